#include "reproduce/paper_numbers.h"

namespace abflat::cli {
namespace {

const std::vector<PaperModel>& paperModels() {
  static const std::vector<PaperModel> models = {
      {"cathead",
       "Cat head (small)",
       "257",
       "<1",
       "0.030",
       "0.560",
       {{2, "0.03", "0.560"},
        {1.05, "0.030", "0.560"},
        {1, "0.030", "0.560"},
        {0.968, "0.030", "0.560"}}},
      {"three-balls",
       "3 balls",
       "1032",
       "8",
       "0.115",
       "0.539",
       {{2, "0.106", "0.108"},
        {1.05, "0.108", "0.483"},
        {1, "0.115", "0.539"},
        {0.968, "0.208", "0.116"}}},
      {"isis", "Isis Statue", "879", "37", "0.015", "0.279", {}},
      {"nefertiti",
       "Nefertiti",
       "562",
       "1",
       "0.0025",
       "0.018",
       {{2, "0.0016", "0.013"},
        {1.05, "0.0021", "0.017"},
        {1, "0.0025", "0.018"},
        {0.968, "0.0029", "0.019"}}},
      {"body",
       "Body",
       "1396",
       "16",
       "0.011",
       "1.688",
       {{2, "0.011", "1.660"},
        {1.05, "0.011", "1.678"},
        {1, "0.011", "1.688"},
        {0.968, "0.011", "1.702"}}},
      {"cathead-large", "Cat head (large)", "3660", "100", "0.003", "0.371", {}},
      {"max-planck", "Max Planck", "988", "12", "0.025", "4.698", {}},
      {"clumpy", "Clumpy", "2340", "180", "0.0063", "2.468", {}},
      {"cat", "Cat", "11168", "1920", "0.001", "0.943", {}},
      {"hand",
       "Hand",
       "3000",
       "215",
       "0.029",
       "4.473",
       {{2, "0.029", "4.455"},
        {1.05, "0.029", "4.455"},
        {1, "0.029", "4.473"},
        {0.968, "0.03", "4.46"}}},
  };
  return models;
}

}  // namespace

const PaperModel* findPaperModel(const std::string& stem) {
  std::string lower = stem;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const PaperModel& model : paperModels())
    if (model.stem == lower) return &model;
  return nullptr;
}

const PaperDistortion* findDistortion(const PaperModel& model, double t) {
  for (const PaperDistortion& d : model.distortions)
    if (d.t == t) return &d;
  return nullptr;
}

}  // namespace abflat::cli

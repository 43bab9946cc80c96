#include "reproduce/page.h"

#include "abflat/version.h"
#include "terminal/markup.h"

namespace abflat::cli {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>abflat: the experiments of Convex Boundary Angle Based Flattening</title>
<style>
  body { margin: 0 auto; max-width: 1500px; padding: 2rem 1.5rem 5rem; color: #1b2430; background: #f5f7fa;
         font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
  h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .3rem; }
  h2 { font-size: 1.25rem; margin: 3rem 0 .8rem; }
  nav a { margin-right: 1.2rem; white-space: nowrap; }
  a { color: #0058a8; }
  p, ul { max-width: 75ch; }
  .table { overflow-x: auto; background: #fff; border: 1px solid #dde2e9; border-radius: 8px; }
  table { border-collapse: collapse; font-size: 13px; width: 100%; }
  th, td { padding: .35rem .6rem; text-align: left; vertical-align: top; border-bottom: 1px solid #e9edf2; }
  tbody tr:last-child td { border-bottom: 0; }
  th { position: sticky; top: 0; background: #fff; font-weight: 600; vertical-align: bottom; }
  td:first-child { white-space: nowrap; }
  td:last-child { min-width: 15rem; }
  td.number { white-space: nowrap; }
  .number { text-align: right; font-variant-numeric: tabular-nums; }
  figure { margin: 0 0 1.5rem; overflow-x: auto; background: #fff; border: 1px solid #dde2e9; border-radius: 8px; }
  img { display: block; max-width: 100%; height: auto; }
  @media print { body { background: #fff; padding: 0; } figure { break-inside: avoid; } }
</style>
</head>
<body>
<header>
<h1>The experiments of <cite>Convex Boundary Angle Based Flattening</cite></h1>
)";

std::string list(const std::vector<std::string>& items) {
  std::string out = "<ul>\n";
  for (const std::string& item : items) out += "<li>" + escapedMarkup(item) + "</li>\n";
  return out + "</ul>\n";
}

std::string heading(int section, const std::string& text) {
  return "<h2 id=\"s" + std::to_string(section) + "\">" + escapedMarkup(text) + "</h2>\n";
}

std::string link(int section, const std::string& text) {
  return "<a href=\"#s" + std::to_string(section) + "\">" + escapedMarkup(text) + "</a>\n";
}

std::string figureHtml(const PagePicture& picture) {
  const std::string file = escapedMarkup(picture.file);
  const std::string text = escapedMarkup(picture.section + ", " + picture.title);
  return "<figure><a href=\"" + file + "\"><img loading=\"lazy\" src=\"" + file + "\" alt=\"" +
         text + "\"></a></figure>\n";
}

}  // namespace

std::string pageHtml(const PageContent& content) {
  std::string links, body;
  int sections = 0;
  const auto start = [&](const std::string& text) {
    links += link(++sections, text);
    body += heading(sections, text);
  };
  if (content.tables) {
    start("Table 1: convex boundary, t = 1");
    body += htmlText(content.tables->table1);
    start("Table 2: distortion for several t");
    body += htmlText(content.tables->table2) + list(tableNotes());
  }
  std::string section;
  for (const PagePicture& picture : content.pictures) {
    if (picture.section != section) start(section = picture.section);
    body += figureHtml(picture);
  }
  if (!content.remarks.empty()) {
    start("Left out");
    body += list(content.remarks);
  }
  return kHead + std::string("<p>Made by abflat " ABFLAT_VERSION ". Compared with ") +
         escapedMarkup(std::string(kPaperSource)) + ".</p>\n<nav>\n" + links +
         "</nav>\n</header>\n" + body + "</body>\n</html>\n";
}

}  // namespace abflat::cli

#include "report/field_writer.h"

namespace abflat {

void FieldWriter::verdict(const char* name, const Status& status) {
  begin(name);
  field("ok", status.ok());
  json_.field("code", statusName(status.code));
  field("message", status.message);
  end();
}

void FieldWriter::reportError(const char* name, const Status& error) {
  if (error.ok()) return;
  begin(name);
  json_.field("code", statusName(error.code));
  field("message", error.message);
  end();
}

bool FieldWriter::isKnown(StatusCode error) {
  return exitCodeOf(error) != static_cast<int>(ExitCode::Unreadable) &&
         error != StatusCode::OutOfMemory;
}

}  // namespace abflat

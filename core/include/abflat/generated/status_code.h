// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

namespace abflat {

/// What the command line program returns.
enum class ExitCode : int {
  Valid = 0,  ///< a valid result was written; of verify: nothing was found; of batch: one for every mesh
  NotValid = 1,  ///< a result was written, but it is not valid or the solver did not converge; the report says why; of verify: something was found; of batch: a mesh has no valid result; the manifest says why
  Usage = 2,  ///< the command line is wrong
  Unreadable = 3,  ///< the input cannot be read; the message says where and why
  NotFlattenable = 4,  ///< the mesh cannot be flattened, or cannot be packed as asked; the message says why
  CannotWrite = 5,  ///< the output cannot be written; existing files are unchanged
};

/// Why a call has no result.
enum class StatusCode : int {
  Ok = 0,  ///< no error
  InvalidOption = 1,  ///< an option is unknown or out of its range
  UnreadableFile = 2,  ///< the file does not exist, cannot be opened or has an unsupported format
  ParseError = 3,  ///< the file breaks the rules of its format; the message names the line, or the byte of a binary file
  InvalidMesh = 4,  ///< mesh arrays are inconsistent: an index out of range, a coordinate that is not finite, a face with fewer than three corners
  EmptyMesh = 5,  ///< the mesh has no faces
  DegenerateFace = 6,  ///< a face uses the same vertex twice
  NonManifoldEdge = 7,  ///< an edge has more than two faces
  InconsistentOrientation = 8,  ///< two adjacent faces have opposite orientation
  MultipleComponents = 9,  ///< the mesh has more than one edge-connected component
  ClosedSurface = 10,  ///< the surface has no boundary
  MultipleBoundaryLoops = 11,  ///< the surface has more than one boundary loop
  HasHandles = 12,  ///< the surface has genus above 0
  InfeasibleBound = 13,  ///< t is below 1 - 2/(number of boundary vertices); the message names the smallest possible t
  OutOfMemory = 14,  ///< there is not enough memory for the mesh
  Aborted = 15,  ///< the caller cancelled the run
  CannotWrite = 16,  ///< the output cannot be written
  Internal = 17,  ///< a bug in abflat; please report it with the mesh
  AtlasTooSmall = 18,  ///< the charts do not fit the atlas; the message names a resolution or texel density at which they fit
  NoTexcoords = 19,  ///< no face of the mesh has texcoords, so it has no layout
};

constexpr int kExitCodeCount = 6;
constexpr int kStatusCodeCount = 20;

/// "NonManifoldEdge"; the name that reports and error objects carry.
inline const char* statusName(StatusCode code) {
  switch (code) {
    case StatusCode::Ok:
      return "Ok";
    case StatusCode::InvalidOption:
      return "InvalidOption";
    case StatusCode::UnreadableFile:
      return "UnreadableFile";
    case StatusCode::ParseError:
      return "ParseError";
    case StatusCode::InvalidMesh:
      return "InvalidMesh";
    case StatusCode::EmptyMesh:
      return "EmptyMesh";
    case StatusCode::DegenerateFace:
      return "DegenerateFace";
    case StatusCode::NonManifoldEdge:
      return "NonManifoldEdge";
    case StatusCode::InconsistentOrientation:
      return "InconsistentOrientation";
    case StatusCode::MultipleComponents:
      return "MultipleComponents";
    case StatusCode::ClosedSurface:
      return "ClosedSurface";
    case StatusCode::MultipleBoundaryLoops:
      return "MultipleBoundaryLoops";
    case StatusCode::HasHandles:
      return "HasHandles";
    case StatusCode::InfeasibleBound:
      return "InfeasibleBound";
    case StatusCode::OutOfMemory:
      return "OutOfMemory";
    case StatusCode::Aborted:
      return "Aborted";
    case StatusCode::CannotWrite:
      return "CannotWrite";
    case StatusCode::Internal:
      return "Internal";
    case StatusCode::AtlasTooSmall:
      return "AtlasTooSmall";
    case StatusCode::NoTexcoords:
      return "NoTexcoords";
  }
  return "Internal";
}

/// What the status means, without the place.
inline const char* statusText(StatusCode code) {
  switch (code) {
    case StatusCode::Ok:
      return "no error";
    case StatusCode::InvalidOption:
      return "an option is unknown or out of its range";
    case StatusCode::UnreadableFile:
      return "the file does not exist, cannot be opened or has an unsupported format";
    case StatusCode::ParseError:
      return "the file breaks the rules of its format; the message names the line, or the byte of a binary file";
    case StatusCode::InvalidMesh:
      return "mesh arrays are inconsistent: an index out of range, a coordinate that is not finite, a face with fewer than three corners";
    case StatusCode::EmptyMesh:
      return "the mesh has no faces";
    case StatusCode::DegenerateFace:
      return "a face uses the same vertex twice";
    case StatusCode::NonManifoldEdge:
      return "an edge has more than two faces";
    case StatusCode::InconsistentOrientation:
      return "two adjacent faces have opposite orientation";
    case StatusCode::MultipleComponents:
      return "the mesh has more than one edge-connected component";
    case StatusCode::ClosedSurface:
      return "the surface has no boundary";
    case StatusCode::MultipleBoundaryLoops:
      return "the surface has more than one boundary loop";
    case StatusCode::HasHandles:
      return "the surface has genus above 0";
    case StatusCode::InfeasibleBound:
      return "t is below 1 - 2/(number of boundary vertices); the message names the smallest possible t";
    case StatusCode::OutOfMemory:
      return "there is not enough memory for the mesh";
    case StatusCode::Aborted:
      return "the caller cancelled the run";
    case StatusCode::CannotWrite:
      return "the output cannot be written";
    case StatusCode::Internal:
      return "a bug in abflat; please report it with the mesh";
    case StatusCode::AtlasTooSmall:
      return "the charts do not fit the atlas; the message names a resolution or texel density at which they fit";
    case StatusCode::NoTexcoords:
      return "no face of the mesh has texcoords, so it has no layout";
  }
  return "";
}

/// Exit code of the program that ends with this status.
inline int exitCodeOf(StatusCode code) {
  switch (code) {
    case StatusCode::Ok:
      return static_cast<int>(ExitCode::Valid);
    case StatusCode::InvalidOption:
      return static_cast<int>(ExitCode::Usage);
    case StatusCode::UnreadableFile:
    case StatusCode::ParseError:
    case StatusCode::InvalidMesh:
      return static_cast<int>(ExitCode::Unreadable);
    case StatusCode::EmptyMesh:
    case StatusCode::DegenerateFace:
    case StatusCode::NonManifoldEdge:
    case StatusCode::InconsistentOrientation:
    case StatusCode::MultipleComponents:
    case StatusCode::ClosedSurface:
    case StatusCode::MultipleBoundaryLoops:
    case StatusCode::HasHandles:
    case StatusCode::InfeasibleBound:
    case StatusCode::OutOfMemory:
    case StatusCode::Aborted:
    case StatusCode::Internal:
    case StatusCode::AtlasTooSmall:
    case StatusCode::NoTexcoords:
      return static_cast<int>(ExitCode::NotFlattenable);
    case StatusCode::CannotWrite:
      return static_cast<int>(ExitCode::CannotWrite);
  }
  return static_cast<int>(ExitCode::NotFlattenable);
}

/// What the exit code means, for the help text.
inline const char* exitCodeText(ExitCode code) {
  switch (code) {
    case ExitCode::Valid:
      return "a valid result was written; of verify: nothing was found; of batch: one for every mesh";
    case ExitCode::NotValid:
      return "a result was written, but it is not valid or the solver did not converge; the report says why; of verify: something was found; of batch: a mesh has no valid result; the manifest says why";
    case ExitCode::Usage:
      return "the command line is wrong";
    case ExitCode::Unreadable:
      return "the input cannot be read; the message says where and why";
    case ExitCode::NotFlattenable:
      return "the mesh cannot be flattened, or cannot be packed as asked; the message says why";
    case ExitCode::CannotWrite:
      return "the output cannot be written; existing files are unchanged";
  }
  return "";
}

}  // namespace abflat

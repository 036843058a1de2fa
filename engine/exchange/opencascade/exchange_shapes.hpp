#pragma once
// Curves and surfaces as OpenCASCADE's shapes, and back: what STEP and IGES have in common. OpenCASCADE's readers are
// not made for hostile input (one damaged IGES file in a few hundred ends them), so they run in a process of their own.

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <functional>

#include "exchange/format.hpp"

namespace blossom::exchange {

struct Shapes {
  TopoDS_Shape compound;
  std::vector<std::string> notes;
};
// Diagnostics when there is nothing that can be written.
Checked<Shapes> shapes_of(const Workspace&, const ExportOptions&);

// Every face's surface and every edge that belongs to no face, as B-splines.
Imported objects_of(const TopoDS_Shape&);

// Reads in a process of its own, of bounded time: what ends it is a diagnostic.
Checked<Imported> apart(const std::string& name, const std::function<Checked<Imported>()>& read);

// OpenCASCADE talks to standard output unless its printers are taken away.
void keep_quiet();

// A file of its own in the system's temporary folder, which goes with this object: these formats go through files.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view extension);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  std::string path() const { return (folder_ / name_).string(); }
  Checked<std::string> bytes() const;

 private:
  std::filesystem::path folder_;
  std::string name_;
};

// What `work` throws, as a diagnostic.
template <class Work>
auto guarded(const std::string& name, Work&& work) -> decltype(work());

}  // namespace blossom::exchange

#include <Standard_Failure.hxx>

template <class Work>
auto blossom::exchange::guarded(const std::string& name, Work&& work) -> decltype(work()) {
  try {
    keep_quiet();
    return work();
  } catch (const Standard_Failure& failure) {
    return Diagnostics{{name, 0, 0, "", std::string("OpenCASCADE gives up: ") + failure.GetMessageString()}};
  }
}

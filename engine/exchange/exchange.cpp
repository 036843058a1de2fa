#include <algorithm>
#include <cctype>

#include "base/json.hpp"
#include "base/text_file.hpp"
#include "exchange/format.hpp"

namespace blossom {
namespace {

// "OBJ (.obj), SVG (.svg) and ..."
std::string formats_that(bool (*can)(const ExchangeFormat&)) {
  std::string text;
  for (const ExchangeFormat* format : exchange_formats())
    if (can(*format)) text += (text.empty() ? "" : ", ") + std::string(format->extensions.front());
  return text;
}

}  // namespace

const ExchangeFormat* format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const ExchangeFormat* format : exchange_formats())
    if (std::ranges::find(format->extensions, extension) != format->extensions.end()) return format;
  return nullptr;
}

Checked<Imported> import_file(const std::filesystem::path& file) {
  const ExchangeFormat* format = format_of(file);
  const std::string name = file_title(file);
  if (format == nullptr || format->import == nullptr)
    return Diagnostics{{name, 0, 0, "",
                        "is of no format that can be imported; these can: " +
                            formats_that([](const ExchangeFormat& f) { return f.import != nullptr; })}};
  auto bytes = read_text(file, most_import_bytes);
  if (!bytes) return bytes.diagnostics;
  if (bytes->size() > most_import_bytes)
    return Diagnostics{{name, 0, 0, "", "is larger than the 64 MiB that are read"}};
  auto read = format->import(name, *bytes);
  if (read && read->objects.empty())
    return Diagnostics{{name, 0, 0, "",
                        "has no curve, surface or point that can be taken" +
                            (read->notes.empty() ? std::string() : ": " + read->notes.front())}};
  return read;
}

Checked<std::vector<std::string>> export_file(const Workspace& scene, const std::filesystem::path& file,
                                              const ExportOptions& options) {
  const ExchangeFormat* format = format_of(file);
  if (format == nullptr || format->write == nullptr)
    return Diagnostics{{file.string(), 0, 0, "",
                        "is of no format that can be written; these can: " +
                            formats_that([](const ExchangeFormat& f) { return f.write != nullptr; })}};
  auto made = format->write(scene, options);
  if (!made) return made.diagnostics;
  if (const auto written = write_file(file, made->bytes); !written) return written.diagnostics;
  return std::move(made->notes);
}

}  // namespace blossom

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "capi/context.hpp"
#include "capi/pictures/picture.hpp"
#include "options/output_kind.hpp"
#include "options/settings.hpp"
#include "options/tables.hpp"
#include "output/export_picture.hpp"

// Parts of sfumato_export() that the modules for WebAssembly share with the library.
namespace sfumato::capi {

using FileBytes = std::vector<std::uint8_t>;

/// Makes a file of a kind without pixels: output::export_picture() or output::export_vector().
using Exporter = Result<FileBytes> (*)(Context&, const Picture&, const output::DrawingOptions&,
                                       ExportNotes*);

/// Gives the caller the bytes of a file, or returns its error.
Outcome hand_out_bytes(Result<FileBytes> file, sfumato_bytes** out);

/// Reads the options of a call that makes a file, and sets all other options to their defaults.
Outcome read_file_options(const char* text, options::Call call, options::OutputKind kind,
                          options::Settings& settings);

/// Returns the background of the file: the requested one, else the document's own, else white in
/// formats without alpha.
std::optional<Rgb> background_of(const options::Settings& settings, options::OutputKind kind,
                                 const Picture& picture);

/// Makes a file without pixels of a picture, with the bytes that the command writes. Sets the
/// warnings of the context.
Outcome export_drawing(sfumato_context* context, const sfumato_picture& handle,
                       options::OutputKind kind, const options::Settings& settings,
                       Exporter exporter, sfumato_bytes** out);

}  // namespace sfumato::capi

#include "render/PngFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include "vtkImageData.h"
#include "vtk_png.h"
#include "vtk_zlib.h"

#include <fmt/format.h>

#include <array>
#include <csetjmp>
#include <string>
#include <vector>

namespace vesicle
{
namespace
{

/// What libpng hands over and says.
struct Output
{
  std::string bytes, complaint;
};

Output& output_of(png_structp png)
{
  return *static_cast<Output*>(png_get_io_ptr(png));
}

void keep(png_structp png, png_bytep bytes, std::size_t count)
{
  output_of(png).bytes.append(reinterpret_cast<const char*>(bytes), count);
}

[[noreturn]] void fail(png_structp png, png_const_charp reason)
{
  static_cast<Output*>(png_get_error_ptr(png))->complaint = reason;
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// Of all filters and zlib's strategies this pair takes a third of the time of what libpng chooses,
/// and files are no larger: pictures of a surface are smooth or of one colour, so that most bytes are
/// the one above, and what is left comes in runs.
void set_quick(png_structp png)
{
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_compression_strategy(png, Z_RLE);
}

/// Nothing here needs a destructor, as libpng leaves by a jump.
void encode(png_structp png, png_infop info, vtkImageData* image, png_bytepp rows)
{
  constexpr std::array<int, 5> color_types{ 0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
    PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA };
  constexpr int bits = 8;
  if (setjmp(png_jmpbuf(png)) != 0)
  {
    return;
  }
  const int* size = image->GetDimensions();
  png_set_IHDR(png, info, size[0], size[1], bits, color_types[image->GetNumberOfScalarComponents()],
    PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  set_quick(png);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
}

/// VTK counts rows from below.
std::vector<png_bytep> rows_from_above(vtkImageData* image)
{
  std::vector<png_bytep> rows;
  for (int y = image->GetDimensions()[1] - 1; y >= 0; --y)
  {
    rows.push_back(static_cast<png_bytep>(image->GetScalarPointer(0, y, 0)));
  }
  return rows;
}

Output encoded(vtkImageData* image)
{
  Output output{ "", "out of memory" };
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, fail, ignore);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (info)
  {
    output.complaint.clear();
    png_set_write_fn(png, &output, keep, nullptr);
    auto rows = rows_from_above(image);
    encode(png, info, image, rows.data());
  }
  png_destroy_write_struct(&png, &info);
  return output;
}

}

void write_png(const std::filesystem::path& file, vtkImageData* image)
{
  const Output output = encoded(image);
  if (!output.complaint.empty())
  {
    throw IoError(
      fmt::format("can't encode the picture for {}: {}", file.string(), output.complaint));
  }
  replace_file(file, output.bytes);
}

}

#pragma once
// The numbers of VTK's XML files: text, base64 within or after the elements, raw bytes after them;
// in blocks that are compressed or not.

#include "XmlTree.h"

#include "solver/mesh/io/SurfaceFile.h"

#include "vtkSmartPointer.h"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

class vtkDataCompressor;

namespace vesicle
{

class XmlArrays
{
public:
  /// Takes byte order, header type and compressor of the root. Throws InputError for unknown ones.
  XmlArrays(const XmlDocument& document, std::string name);
  ~XmlArrays();

  /// An array with as many components as the element says. Throws InputError "name: array 'x' …"
  /// where it is damaged, before memory is taken for what isn't there, or where all arrays together
  /// would take far more memory than the file has bytes.
  DataArray read(const XmlElement& element) const;
  /// Of integers of any type.
  std::vector<std::int64_t> read_integers(const XmlElement& element) const;

  [[noreturn]] void fail(const XmlElement& element, const std::string& problem) const;

private:
  void take_memory(const XmlElement& element, std::uint64_t bytes) const;
  std::string bytes_of(const XmlElement& element) const;
  DataArray::Values values_of(const XmlElement& element) const;
  template<typename T>
  std::vector<T> numbers(const XmlElement& element) const;
  std::vector<std::uint8_t> bits(const XmlElement& element) const;
  std::vector<std::string> strings(const XmlElement& element) const;

  const XmlDocument& document_;
  std::string name_;
  std::endian order_ = std::endian::little;
  bool wide_headers_ = false; ///< 64 bits
  bool appended_as_text_ = false;
  vtkSmartPointer<vtkDataCompressor> compressor_;
  mutable std::uint64_t memory_left_; ///< for further arrays
};

}

#include "output/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <zlib.h>

#include <string_view>

#include "core/errors.h"
#include "output/quiet_vtk.h"

namespace hinge::output {
namespace {

constexpr int level = 4;

std::string big_endian(std::size_t value) {
    return {char(value >> 24 & 255), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

std::string chunk(const std::string& name, const std::string& content) {
    const std::string body = name + content;
    const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(content.size()) + body + big_endian(sum);
}

}  // namespace

std::string encode_png(const Pixels& pixels) {
    const std::size_t row = 3 * static_cast<std::size_t>(pixels.width);
    std::string lines;  // from the top, each after a 0: no filter
    lines.reserve((row + 1) * static_cast<std::size_t>(pixels.height));
    for (int y = pixels.height; y-- > 0;)
        lines.append(1, '\0').append(reinterpret_cast<const char*>(&pixels.rgb[row * static_cast<std::size_t>(y)]),
                                     row);
    uLongf size = ::compressBound(lines.size());
    std::string packed(size, '\0');
    if (::compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(lines.data()),
                    lines.size(), level) != Z_OK)
        throw OutsideError("cannot encode the picture as PNG: out of memory?");
    packed.resize(size);
    const std::string eight_bits_rgb = {8, 2, 0, 0, 0};
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR",
                 big_endian(std::size_t(pixels.width)) + big_endian(std::size_t(pixels.height)) + eight_bits_rgb) +
           chunk("IDAT", packed) + chunk("IEND", "");
}

Pixels decode_png(const std::string& name) {
    const vtkNew<vtkPNGReader> reader;
    if (!reader->CanReadFile(name.c_str())) throw OutsideError("cannot read the picture " + name);
    reader->SetFileName(name.c_str());
    reader->Update();
    const std::string complaint = take_vtk_complaint();
    vtkImageData* image = reader->GetOutput();
    auto* bytes = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
    if (!complaint.empty() || !bytes || bytes->GetNumberOfComponents() != 3)
        throw OutsideError("cannot read the picture " + name + (complaint.empty() ? "" : ": " + complaint));
    const int* size = image->GetDimensions();
    const unsigned char* first = bytes->GetPointer(0);
    return {size[0], size[1], {first, first + bytes->GetNumberOfValues()}};
}

}  // namespace hinge::output

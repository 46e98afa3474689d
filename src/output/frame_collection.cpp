// The collection file of all frames, for an animation in ParaView.
#include <charconv>

#include "output/snapshot_file.h"

namespace hinge::output {
namespace {

/// A text in XML, as an attribute too. XML has no control characters, not even as numbers.
std::string xml_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\'': out += "&apos;"; break;
            default: out += static_cast<unsigned char>(c) < ' ' || c == 127 ? ' ' : c;
        }
    }
    return out;
}

/// Shortest digits that read back as the same number, whatever the locale.
std::string shortest(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace

std::string encode_collection(int n, const double* times, const char* const* files) {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (int i = 0; i < n; ++i)
        text += "    <DataSet timestep=\"" + shortest(times[i]) + "\" group=\"\" part=\"0\" file=\"" +
                xml_text(files[i]) + "\"/>\n";
    return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace hinge::output

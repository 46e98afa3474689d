// A pen that writes SVG: no display is needed, and words stay words.
#include "output/svg.h"

#include <cmath>
#include <cstdio>

namespace hinge::output {
namespace {

/// Widths of the characters from the space to the tilde in DejaVu Sans, thousandths of the size.
constexpr short widths[] = {318,  401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
                            636,  636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531,
                            1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787,
                            603,  787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500,
                            500,  613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
                            635,  635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
constexpr double bold_wider = 1.12;

/// The character at `at` in UTF-8, which is moved behind it; 0xFFFD for what is none.
char32_t next_character(const std::string& text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(at++);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 && first < 0xF5 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : 0;
    if (more == 0 || first >= 0xF5) return 0xFFFD;
    char32_t c = first & (0x3Fu >> more);
    for (int i = 0; i < more; ++i) {
        if ((byte(at + i) & 0xC0) != 0x80) return 0xFFFD;
        c = c << 6 | (byte(at + i) & 0x3F);
    }
    const char32_t least[] = {0, 0x80, 0x800, 0x10000};
    if (c < least[more] || c > 0x10FFFF || (c >= 0xD800 && c < 0xE000) || c == 0xFFFE || c == 0xFFFF) return 0xFFFD;
    at += more;
    return c;
}

double width_of(char32_t c) {
    if (c >= ' ' && c <= '~') return widths[c - ' '] / 1000.0;
    if (c == 0xD7 || c == 0x2212) return 0.838;  // times, minus
    if (c == 0xB7) return 0.318;                 // the dot between factors
    if (c >= 0xB2 && c <= 0xB9) return 0.401;    // squared, cubed
    if (c >= 0x300 && c < 0x370) return 0;       // accents that stand above
    return c < 0x400 ? 0.62 : c < 0x1100 ? 0.72 : c < 0x2E80 ? 0.7 : 1;
}

std::string number(double v) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", std::isfinite(v) ? v : 0.0);
    std::string s = text;
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
    return s == "-0" ? "0" : s;
}

std::string hex(Colour c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c[0], c[1], c[2]);
    return text;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string opacity_of(double opacity) { return opacity < 1 ? attribute("fill-opacity", number(opacity)) : ""; }

}  // namespace

std::string escaped(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t from = at;
        const char32_t c = next_character(text, at);
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else if (c == 0xFFFD || (c < ' ' && c != '\t' && c != '\n')) out += "\xEF\xBF\xBD";
        else out += text.substr(from, at - from);
    }
    return out;
}

SvgPen::SvgPen(int width, int height, const std::string& title) : height_(height) {
    const std::string w = std::to_string(width), h = std::to_string(height);
    out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", w) + attribute("height", h) +
           attribute("viewBox", "0 0 " + w + " " + h) + " role=\"img\"" +
           " font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n";
    if (!title.empty()) out_ += "<title>" + escaped(title) + "</title>\n";
    out_ += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

std::array<double, 2> SvgPen::size_of(const std::string& words, const TextStyle& style) {
    const auto width = [](const std::string& text) {
        double sum = 0;
        for (std::size_t at = 0; at < text.size();) sum += width_of(next_character(text, at));
        return sum;
    };
    if (words.empty() && style.power.empty()) return {0, 0};
    const double size = style.size * (style.bold ? bold_wider : 1);
    return {size * (width(words) + power_size * width(style.power)), 1.16 * style.size};
}

void SvgPen::text(double x, double y, const std::string& words, const TextStyle& style) {
    if (words.empty()) return;
    // From the foot of the line to its top it is 1.16 sizes; letters stand on a line 0.24 above the foot.
    const double below = (1.16 * style.upright - 0.24) * style.size;
    const double at_x = style.upwards ? x + below : x, at_y = height_ - (style.upwards ? y : y - below);
    out_ += "<text" + attribute("x", number(at_x)) + attribute("y", number(at_y)) +
            attribute("font-size", number(style.size)) + attribute("fill", hex(style.colour));
    if (style.across > 0) out_ += attribute("text-anchor", style.across == 1 ? "end" : "middle");
    if (style.bold) out_ += " font-weight=\"bold\"";
    if (style.italic) out_ += " font-style=\"italic\"";
    if (style.upwards) out_ += attribute("transform", "rotate(-90 " + number(at_x) + " " + number(at_y) + ")");
    out_ += ">" + escaped(words);
    if (!style.power.empty())
        out_ += "<tspan" + attribute("dy", number(-power_height * style.size)) +
                attribute("font-size", number(power_size * style.size)) + ">" + escaped(style.power) + "</tspan>";
    out_ += "</text>\n";
}

void SvgPen::path(const std::vector<Pixel>& points, double width, Colour colour, Dashes dashes) {
    if (points.size() < 2) return;
    out_ += "<polyline fill=\"none\"" + attribute("stroke", hex(colour)) + attribute("stroke-width", number(width)) +
            " stroke-linejoin=\"round\"";
    if (dashes.on > 0) out_ += attribute("stroke-dasharray", number(dashes.on) + " " + number(dashes.off));
    out_ += " points=\"";
    for (std::size_t i = 0; i < points.size(); ++i)
        out_ += (i == 0 ? "" : " ") + number(points[i][0]) + "," + number(height_ - points[i][1]);
    out_ += "\"/>\n";
}

void SvgPen::box(double x, double y, double width, double height, Colour colour, double opacity) {
    const double left = std::round(x), foot = std::round(y), wide = std::round(x + width) - left,
                 high = std::round(y + height) - foot;
    if (wide <= 0 || high <= 0) return;
    out_ += "<rect" + attribute("x", number(left)) + attribute("y", number(height_ - foot - high)) +
            attribute("width", number(wide)) + attribute("height", number(high)) + attribute("fill", hex(colour)) +
            opacity_of(opacity) + "/>\n";
}

void SvgPen::dot(double x, double y, double radius, Colour colour) {
    out_ += "<circle" + attribute("cx", number(x)) + attribute("cy", number(height_ - y)) +
            attribute("r", number(radius)) + attribute("fill", hex(colour)) + "/>\n";
}

void SvgPen::strip(const std::vector<Pixel>& low, const std::vector<Pixel>& high, Colour colour, double opacity) {
    if (low.size() < 2) return;
    out_ += "<polygon" + attribute("fill", hex(colour)) + opacity_of(opacity) + " points=\"";
    const auto add = [&](const Pixel& p) { out_ += number(p[0]) + "," + number(height_ - p[1]) + " "; };
    for (const Pixel& p : low) add(p);
    for (auto p = high.rbegin(); p != high.rend(); ++p) add(*p);
    out_.back() = '"';
    out_ += "/>\n";
}

}  // namespace hinge::output

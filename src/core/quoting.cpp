#include "core/quoting.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace hinge {
namespace {

bool is_control(unsigned char c) { return c < ' ' || c == 127; }

/// Whether a spreadsheet computes with the text: = + - @, also in the wide form of East Asian keyboards.
bool is_formula(const std::string& text) {
    if (text.size() < 2) return false;
    bool begins = std::string_view("=+-@").find(text[0]) != std::string_view::npos;
    for (const char* wide : {"\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"}) begins = begins || text.rfind(wide, 0) == 0;
    if (!begins) return false;
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return *end != '\0' || std::isspace(static_cast<unsigned char>(text.back()));
}

}  // namespace

std::string csv_text(std::string text, CsvQuotes quotes) {
    std::replace_if(text.begin(), text.end(), is_control, ' ');
    if (is_formula(text)) text.insert(0, 1, '\'');
    if (quotes == CsvQuotes::where_needed && text.find_first_of(",;\"") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string shell_text(const std::string& text) {
    const auto plain = [](unsigned char c) { return c != 0 && (std::isalnum(c) || std::strchr("_./:=,+%@-", c)); };
    if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

std::string plain_name(const std::string& name) {
    std::string out;
    for (const char c : name) out += is_control(static_cast<unsigned char>(c)) || c == '"' || c == '\\' ? '_' : c;
    for (const char* mark : {"\u061C", "\u200E", "\u200F", "\u202A", "\u202B", "\u202C", "\u202D", "\u202E", "\u2066",
                             "\u2067", "\u2068", "\u2069"})
        for (std::size_t at; (at = out.find(mark)) != std::string::npos;) out.replace(at, std::strlen(mark), "_");
    return out;
}

}  // namespace hinge

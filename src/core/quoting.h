// Quotes texts for the languages that hinge writes: one function a language. Those of Lua, gnuplot, HTML and others are
// in lua/hinge/library/quote.lua, XML is in output/frame_collection.cpp; tests/README.md lists where each is used.
#pragma once

#include <string>

namespace hinge {

enum class CsvQuotes { always, where_needed };

/// A text as a field of a CSV file, on one line. One that a spreadsheet would take for a formula gets an apostrophe
/// before it; a number stays a number.
std::string csv_text(std::string text, CsvQuotes quotes = CsvQuotes::where_needed);

/// A text as one word of a shell.
std::string shell_text(const std::string& text);

/// A name as it may stand in a comment or between double quotes of a script.
std::string plain_name(const std::string& name);

}  // namespace hinge

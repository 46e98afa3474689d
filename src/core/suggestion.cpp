#include "core/suggestion.h"

#include <algorithm>
#include <cctype>

namespace hinge {
namespace {

/// Small letters, without blanks, hyphens and underscores.
std::string plain(const std::string& word) {
    std::string letters;
    for (unsigned char c : word)
        if (!std::isspace(c) && c != '_' && c != '-') letters += char(std::tolower(c));
    return letters;
}

/// Letters to change, add, leave out or swap with their neighbour.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last), last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({row[j - 1] + 1, last[j] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& typed, const std::vector<std::string>& names) {
    const std::string word = plain(typed);
    const std::string* best = nullptr;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& n : names) {
        const std::string name = plain(n);
        if (const std::size_t d = distance(word, name); d < least && d < name.size()) least = d, best = &n;
    }
    return best ? " (did you mean '" + *best + "'?)" : "";
}

}  // namespace hinge

#include "advice/warning.h"

#include <algorithm>

namespace hinge {

std::string warning_text(const Warning& w) {
    std::string where = w.asked_at;
    if (w.more > 0)
        where += (where.empty() ? "" : ", ") + std::string("and ") + std::to_string(w.more) + " more like it";
    return w.what + (where.empty() ? "" : " (" + where + ")") + "; " + w.advice;
}

std::string line_of_member(const Model& model, int member) {
    return member < 0 ? "" : model.asked_at("member " + std::to_string(member + 1));
}

std::optional<Warning> of_units(const std::vector<Warning>& list) {
    const auto first =
        std::find_if(list.begin(), list.end(), [](const Warning& w) { return w.kind == Warning::Kind::units; });
    return first == list.end() ? std::nullopt : std::optional(*first);
}

}  // namespace hinge

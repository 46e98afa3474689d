#include "state/energy.h"

#include <algorithm>

namespace hinge {

double& Accounts::operator[](std::string_view name) {
    for (auto& [known, sum] : sums_)
        if (known == name) return sum;
    return sums_.emplace_back(name, 0).second;
}

double Accounts::operator[](std::string_view name) const {
    for (const auto& [known, sum] : sums_)
        if (known == name) return sum;
    return 0;
}

double Energy::operator[](std::string_view name) const {
    return name == "initial" ? initial : name == "remainder" ? error : accounts[name];
}

Energy balance(const AccountList& list, double initial, const Accounts& sums) {
    Energy e;
    e.initial = initial;
    for (const AccountInfo& info : list) e.accounts[info.name] = sums[info.name];
    for (const AccountInfo& info : list)
        if (!info.part_of.empty()) e.accounts[info.part_of] += sums[info.name];
    double held = 0;
    for (const AccountInfo& info : list)
        if (info.part_of.empty() && info.name != supplied_account) held += e.accounts[info.name];
    e.error = initial + e.accounts[supplied_account] - held;
    return e;
}

}  // namespace hinge

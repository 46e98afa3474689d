// Energy balance (eq 20 and further terms) as a list of named accounts, J. Effects register the accounts; code that
// prints, sums or checks them reads the list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hinge {

/// Sums by name, J, in the order in which the names were first used. A name that was never used stands for 0.
class Accounts {
public:
    double& operator[](std::string_view name);
    double operator[](std::string_view name) const;
    auto begin() const { return sums_.begin(); }
    auto end() const { return sums_.end(); }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.sums_);
    }

private:
    struct Sum {
        std::string_view name;  ///< of a text that is kept for good, so that a copy of the sums copies no text
        double value;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            std::string text(s.name);
            a(text, s.value);
            if constexpr (A::reading) s.name = kept(text);
        }
    };
    static std::string_view kept(std::string_view name);
    std::vector<Sum> sums_;  // a handful: going through them beats any map
};

/// An account, as an effect registers it.
struct AccountInfo {
    std::string_view name;
    int place;                      ///< order in the list: rising
    std::string_view meaning;       ///< for people
    std::string_view part_of = {};  ///< the account that it is a part of; "" for an account of the balance itself
    bool always = false;            ///< in every list, as the contract of summary.json asks, whatever a scene calls for
    bool may_give = false;  ///< below zero it has given energy, as a potential does; another one below zero is an error
};

/// The account of supplied energy. All other accounts are stored energy, or energy taken out.
inline constexpr std::string_view supplied_account = "work";

/// A name beside the accounts, under which effects add up the size of the numbers of which their energies are
/// differences, J.
inline constexpr std::string_view energy_scale = "scale of rounding";

/// Energy balance of a state: error = initial + work - (all other accounts), the energy made or lost by the numerics.
struct Energy {
    double initial = 0;   ///< kinetic energy and all that is stored at the start of the run
    Accounts accounts;    ///< those registered, parts included; an account with parts is their sum
    double error = 0;     ///< of the energy balance, J
    double rounding = 0;  ///< J, that the accounts may be off by for the digits of a number alone
    /// An account, or "initial"; "energy_error": the error.
    double operator[](std::string_view name) const;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.initial, s.accounts, s.error, s.rounding);
    }
};

/// Accounts, rising by place.
using AccountList = std::vector<AccountInfo>;

/// Sums parts into the accounts that they are part of and finds the energy balance error. `sums` holds the others.
Energy balance(const AccountList& list, double initial, const Accounts& sums);

}  // namespace hinge

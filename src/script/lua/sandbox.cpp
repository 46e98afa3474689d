#include "script/lua/sandbox.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "script/lua/lua_support.h"

namespace hinge::script {
namespace {

Limits limits_;
double instructions_ = 0;
int stride_ = 1000;  // instructions between two calls of the hook
volatile std::sig_atomic_t late_ = 0;
char too_long_[160], too_much_[160];  // said where nothing can be formatted
constexpr double grace = 0.5;         // s from the time limit to an end without the script's line

[[noreturn]] void give_up(const char* message) {
    const auto written = ::write(2, message, std::strlen(message));
    (void)written;
    ::_exit(1);
}

/// At the limit it leaves the word to the hook, which knows the script's line; the second time no hook has come.
void on_alarm(int) {
    if (late_) give_up(too_long_);
    late_ = 1;
}

/// Ends the process, for an error could be caught by the script.
void watch(lua_State* L, lua_Debug*) {
    instructions_ += stride_;
    if (!late_ && instructions_ <= limits_.instructions) return;
    std::string place;
    try {
        place = where(L);
    } catch (const std::bad_alloc&) {}
    char text[400];
    if (late_)
        std::snprintf(text, sizeof text,
                      "hinge: %s: the script took more than %g s, the sandbox's limit; --seconds gives it more\n",
                      place.c_str(), limits_.seconds);
    else
        std::snprintf(
            text, sizeof text,
            "hinge: %s: the script took more than %g instructions, the sandbox's limit; --instructions gives it more\n",
            place.c_str(), limits_.instructions);
    give_up(text);
}

}  // namespace

void confine(lua_State* L, const Limits& limits) {
    limits_ = limits;
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what the script said before it is stopped is not lost
    std::snprintf(too_long_, sizeof too_long_,
                  "hinge: the script took more than %g s, the sandbox's limit, in one call; --seconds gives it more\n",
                  limits.seconds);

    const rlimit room{rlim_t(limits.memory), rlim_t(limits.memory)};
    ::setrlimit(RLIMIT_DATA, &room);
    std::snprintf(too_much_, sizeof too_much_,
                  "hinge: not enough memory; the sandbox's limit is %.0fM, --memory gives more\n",
                  limits.memory / (1 << 20));
    std::set_terminate([] { give_up(too_much_); });  // where C++ cannot pass on that there is no more

    struct sigaction action = {};
    action.sa_handler = on_alarm;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGALRM, &action, nullptr);
    const auto time = [](double s) { return timeval{time_t(s), suseconds_t(std::fmod(s, 1) * 1e6)}; };
    const itimerval clock{time(grace), time(std::clamp(limits.seconds, 1e-3, 1e9))};
    ::setitimer(ITIMER_REAL, &clock, nullptr);

    stride_ = int(std::clamp(limits.instructions, 1.0, 1000.0));
    lua_sethook(L, watch, LUA_MASKCOUNT, stride_);  // a coroutine takes it over from the one that makes it
}

}  // namespace hinge::script

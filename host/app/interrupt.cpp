// The handler does only what is allowed in one: it stores a lock-free number, or restores the default action and raises again.
#include "app/interrupt.h"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace pencil {
namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not take locks");

void handle(int signal) {
    if (received.exchange(signal) != 0) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

void watch_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old {};
        if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = handle;
        action.sa_flags = SA_RESTART;
        ::sigemptyset(&action.sa_mask);
        ::sigaction(signal, &action, nullptr);
    }
    // A file size limit is to end as an output error with its message and clean-up, not in the middle of a write.
    std::signal(SIGXFSZ, SIG_IGN);
}

int interrupted_by() { return received.load(); }

}  // namespace pencil

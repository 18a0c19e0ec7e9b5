// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/budget.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/error.h"
#include "pipeline/exit_codes.h"
#include "report/number_text.h"
#include "sandbox/process_memory.h"
#include "sandbox/shared_word.h"

namespace crumple::pipeline {

namespace {

using Clock = std::chrono::steady_clock;

enum Stand : int { working, finishing, ended };

// Whoever moves it away from `working` first decides.
class SharedStand {
public:
    bool move_to(Stand stand) {
        Stand expected = working;
        return (*word_).compare_exchange_strong(expected, stand) || expected == stand;
    }

private:
    sandbox::SharedWord<Stand> word_{working};
};

std::string limit_text(const Budget& budget, bool is_time) {
    return is_time ? "took longer than --timeout " + report::number_text(budget.time_s) + " s"
                   : "needed more than --max-memory " + report::number_text(budget.memory_mb) + " MB";
}

std::vector<pid_t> children_of(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream list("/proc/" + id + "/task/" + id + "/children");
    std::vector<pid_t> children;
    for (pid_t child = 0; list >> child;) children.push_back(child);
    return children;
}

// Of the process and everything it started: memory that is its own, not shared files.
double resident_mb(pid_t process) {
    const sandbox::ProcessMemory memory = sandbox::memory_of(process);
    double sum = static_cast<double>(memory.resident - memory.shared) * 1e-6;
    for (const pid_t child : children_of(process)) sum += resident_mb(child);
    return sum;
}

class Watch {
public:
    Watch(const Budget& budget, pid_t child, SharedStand& stand) : budget_(budget), child_(child), stand_(stand) {}

    int wait() {
        for (std::uint64_t turn = 0;; ++turn) {
            int status = 0;
            if (waitpid(child_, &status, WNOHANG) == child_) return result_of(status);
            const bool is_late = budget_.time_s > 0 && elapsed_s() > budget_.time_s;
            // Summing up memory reads a few files of /proc: not every turn.
            const bool is_large = budget_.memory_mb > 0 && turn % 8 == 0 && resident_mb(child_) > budget_.memory_mb;
            if (is_late || is_large) end(is_late);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

private:
    [[nodiscard]] double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    void end(bool is_time) {
        if (!stand_.move_to(ended)) return;  // its result is on the way to the disk: let it finish
        kill(child_, SIGKILL);
        int status = 0;
        waitpid(child_, &status, 0);
        throw Error(ErrorKind::budget, limit_text(budget_, is_time));
    }
    static int result_of(int status) {
        if (WIFEXITED(status)) return WEXITSTATUS(status);
        throw Error(ErrorKind::internal, std::string("the cook ended by signal ") + strsignal(WTERMSIG(status)));
    }

    const Budget& budget_;
    pid_t child_;
    SharedStand& stand_;
    Clock::time_point start_ = Clock::now();
};

[[noreturn]] void run_child(const Budget& budget, SharedStand& stand,
                            const std::function<int(const Permission&)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const Permission may_finish = [&](double peak_mb, const std::string& where) {
        if (budget.memory_mb > 0 && peak_mb > budget.memory_mb)
            throw Error(ErrorKind::budget, limit_text(budget, false) + "; the most was in " + where);
        if (!stand.move_to(finishing)) throw Error(ErrorKind::budget, limit_text(budget, true));
    };
    int code = exit_internal;
    try {
        code = work(may_finish);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "crumple: %s\n", error.what());
    }
    std::fflush(nullptr);
    _exit(code);
}

}

int run_within(const Budget& budget, const std::function<int(const Permission&)>& work) {
    if (!budget.is_limited()) return work([](double, const std::string&) {});
    SharedStand stand;
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw Error(ErrorKind::internal, "cannot start a process for the cook");
    if (child == 0) run_child(budget, stand, work);
    return Watch(budget, child, stand).wait();
}

}

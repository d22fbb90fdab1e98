#pragma once
/// Two network namespaces with a virtual cable between them, like two machines: this program is in one of them, and
/// programs that it starts may be in the other. Needs root and iproute2. The namespaces have no names: they vanish with
/// the programs that are in them, however these end.

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <QProcess>
#include <QStandardPaths>
#include <csignal>
#include <functional>
#include <thread>

#include "tests/support/patience.h"

namespace pdr::test {

class TwoNetworks {
  public:
    static inline const QString kHere = "10.0.0.1", kThere = "10.0.0.2";

    ~TwoNetworks() {
        if (there_ >= 0)
            ::close(there_);
    }

    /// Makes both networks; threads and programs that this thread starts from now on are in the network kHere. Returns
    /// why that failed; empty: success.
    QString make() {
        if (::geteuid() != 0)
            return "only root may make networks";
        if (tool("ip").isEmpty())
            return "iproute2 is not installed";
        std::thread([this] {
            if (::unshare(CLONE_NEWNET) == 0)
                there_ = ::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
        }).join();
        if (there_ < 0 || ::unshare(CLONE_NEWNET) != 0)
            return "this system makes no network namespaces";
        const QString there = QString("/proc/%1/fd/%2").arg(::getpid()).arg(there_);
        const bool linked = run("ip", "link add cable type veth peer name cable netns " + there) &&
                            run("ip", "address add " + kHere + "/24 dev cable") && setLink(true) &&
                            run("ip", "address add " + kThere + "/24 dev cable", enterThere()) &&
                            run("ip", "link set cable up", enterThere());
        return linked ? "" : "this system makes no cables between networks";
    }

    /// Limits the rate of what is sent from here. False: this system cannot.
    bool limitRate(const QString& rate) const {
        return !tool("tc").isEmpty() && run("tc", "qdisc add dev cable root tbf latency 400ms burst 64kb rate " + rate);
    }
    bool setLink(bool up) const { return run("ip", QString("link set cable ") + (up ? "up" : "down")); }
    /// Returns a function that moves a program into the other network; it must run in the program's process:
    /// QProcess::setChildProcessModifier(). The program is killed when the thread that started it ends.
    std::function<void()> enterThere() const {
        return [there = there_] {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (::setns(there, CLONE_NEWNET) != 0)
                ::_exit(1);
        };
    }

  private:
    static QString tool(const QString& name) {
        const QString found = QStandardPaths::findExecutable(name);
        return found.isEmpty() ? QStandardPaths::findExecutable(name, {"/usr/sbin", "/sbin"}) : found;
    }
    static bool run(const QString& name, const QString& words, const std::function<void()>& before = {}) {
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedChannels);
        if (before)
            process.setChildProcessModifier(before);
        process.start(tool(name), words.split(' '));
        return process.waitForFinished(kPatience) && process.exitStatus() == QProcess::NormalExit &&
               process.exitCode() == 0;
    }

    int there_ = -1;
};

}  // namespace pdr::test

#pragma once
/// Runs a render node as a program of its own, on this machine.

#include <QProcess>
#include <QRegularExpression>
#include <csignal>
#include <functional>
#include <memory>

#include "tests/support/patience.h"
#include "tests/support/places.h"

namespace pdr::test {

class NodeProcess {
  public:
    /// Starts a node that listens at a free port of this machine, with one thread, unless `options` say otherwise.
    /// `inChild` runs in its process before the program does.
    explicit NodeProcess(const QStringList& options = {"--listen", "127.0.0.1:0"},
                         const std::function<void()>& inChild = {}) {
        process_.setProcessChannelMode(QProcess::MergedChannels);
        if (inChild)
            process_.setChildProcessModifier(inChild);
        process_.start(PDR_BINARY_DIR "/bin/pdrender-node", QStringList{"--threads", "1"} + options);
        if (!process_.waitForStarted(kPatience))
            qFatal("a render node cannot be started");
        if (options.contains("--listen"))
            port_ = portBehind("listening at");
    }
    ~NodeProcess() {
        if (process_.state() == QProcess::NotRunning)
            return;
        signal(SIGKILL);
        process_.waitForFinished(kPatience);
    }

    QString address() const { return QString("localhost:%1").arg(port_); }
    void signal(int number) { ::kill(pid_t(process_.processId()), number); }
    qint64 id() const { return process_.processId(); }
    /// Waits for the program's end. Returns the exit code, or -1 after a signal.
    int code() {
        if (process_.state() != QProcess::NotRunning && !process_.waitForFinished(kPatience))
            qFatal("a render node does not end");
        return process_.exitStatus() == QProcess::NormalExit ? process_.exitCode() : -1;
    }
    /// Waits until the program has said these words before an address. Returns the port of that address.
    int portBehind(const QString& words) {
        const QRegularExpression port(words + " \\S*:(\\d+)");
        while (!port.match(QString::fromUtf8(log())).hasMatch())
            if (!process_.waitForReadyRead(kPatience))
                qFatal("a render node does not listen: %s", log_.constData());
        return port.match(QString::fromUtf8(log_)).captured(1).toInt();
    }
    /// Returns all output so far.
    QByteArray log() {
        log_ += process_.readAllStandardOutput();
        return log_;
    }

  private:
    QProcess process_;
    QByteArray log_;
    int port_ = 0;
};

using NodeProcesses = std::vector<std::unique_ptr<NodeProcess>>;

inline NodeProcesses startNodes(int count) {
    NodeProcesses nodes;
    for (int i = 0; i < count; ++i)
        nodes.push_back(std::make_unique<NodeProcess>());
    return nodes;
}

}  // namespace pdr::test

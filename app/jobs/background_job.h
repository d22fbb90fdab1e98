#pragma once
/// Work beside the window: on a thread of its own, with progress and a way to give it up, its results as signals on the
/// caller's thread. A new job cancels the one before.

#include <QObject>
#include <QThread>
#include <functional>
#include <stop_token>

#include "render/base/progress.h"
#include "render/base/result.h"

namespace pdr::app {

class BackgroundJob : public QObject {
    Q_OBJECT

  public:
    BackgroundJob();
    /// Cancels what runs and waits for it.
    ~BackgroundJob() override;

    bool isRunning() const { return running_; }

  public slots:
    /// Gives up what runs; ends with cancelled(). Nothing happens when nothing runs.
    void cancel();

  signals:
    void failed(const pdr::Error& error);
    void cancelled();
    /// Of the job that runs: [0, 1], and what is being done.
    void progressed(double fraction, const QString& step);
    /// The job that runs has ended, one way or another; how, the next signal says.
    void finished();

  protected:
    /// Returns what is to be called with its result. It ends soon after a stop request, of which `progress` tells, too.
    using Work = std::function<std::function<void()>(const Progress& progress, const std::stop_token& stop)>;
    /// Runs `work` on the thread; what it returns is called back here, unless it was cancelled or a newer job has
    /// begun. What it throws, and a thread that the system does not give, end with failed().
    void start(Work work);
    /// As a result: failed().
    std::function<void()> failure(const Error& error);

    QThread& thread() { return thread_; }

  private:
    Progress progressOf(const std::stop_token& stop);
    std::function<void()> resultOf(const Work& work, const Progress& progress, const std::stop_token& stop);
    void deliver(const std::stop_token& stop, const std::function<void()>& result);

    std::stop_source stop_;  ///< of the newest job; older ones are stopped
    bool running_ = false;
    QThread thread_;  ///< begins with the first job
    QObject worker_;  ///< lives on thread_
};

}  // namespace pdr::app

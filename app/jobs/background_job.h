#pragma once
/// Base of jobs in the background: each runs on a thread of its own, reports its progress, can be cancelled and
/// delivers its result as a signal on the caller's thread. A new job cancels the one before.

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
    /// Cancels the running job and waits for it.
    ~BackgroundJob() override;

    bool isRunning() const { return running_; }

  public slots:
    /// Cancels the running job; ends with cancelled(). Does nothing if no job runs.
    void cancel();

  signals:
    void failed(const pdr::Error& error);
    void cancelled();
    /// Reports the progress of the running job: [0, 1], and what it is doing.
    void progressed(double fraction, const QString& step);
    /// Emitted when the running job has ended in any way; the next signal says how.
    void finished();

  protected:
    /// The work of a job; returns a function that is called with its result. The work ends soon after a stop request,
    /// which `progress` reports, too. It uses no member of the job, only what it holds itself or shares: members of a
    /// derived class are gone before this class's destructor waits for the thread.
    using Work = std::function<std::function<void()>(const Progress& progress, const std::stop_token& stop)>;
    /// Runs `work` on the thread. The function that it returns is called on the caller's thread, unless the job was
    /// cancelled or a newer one has begun. An exception from `work`, or a thread that the system refuses, ends with
    /// failed().
    void start(Work work);
    /// Returns a result that emits failed().
    std::function<void()> failure(const Error& error);

    QThread& thread() { return thread_; }

    /// Calls `event` on the caller's thread, unless the job that `stop` belongs to was cancelled by then. For work that
    /// reports more than its progress.
    void report(const std::stop_token& stop, std::function<void()> event);

  private:
    Progress progressOf(const std::stop_token& stop);
    std::function<void()> resultOf(const Work& work, const Progress& progress, const std::stop_token& stop);
    void deliver(const std::stop_token& stop, const std::function<void()>& result);

    std::stop_source stop_;  ///< belongs to the newest job; older ones are stopped
    bool running_ = false;
    QThread thread_;  ///< starts with the first job
    QObject worker_;  ///< lives on thread_
};

}  // namespace pdr::app

#pragma once
/// Reading a folder and a series beside the window: the work on a thread of its own, the results as signals on the
/// caller's thread. A new job cancels the one before.

#include <QObject>
#include <QThread>
#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/segment/hidden_table.h"

namespace pdr::app {

class ImportJob : public QObject {
    Q_OBJECT

  public:
    ImportJob();
    /// Cancels what runs and waits for it.
    ~ImportJob() override;

    /// The scan that the signals' indices refer to.
    const dicom::ScanResult& scan() const { return scan_; }
    /// What only the pixels of the series that was loaded last could tell.
    const std::vector<dicom::Note>& loadNotes() const { return loadNotes_; }

  public slots:
    /// Reads the headers in `folder`; ends with scanned() or failed().
    void scanFolder(const QString& folder);
    /// Reads the pixels of a loadable series of the last scan, and looks for the scanner's table in them; ends with
    /// loaded() or failed(). Begins when the volume that was loaded last has been let go of by all who held it: memory
    /// may not have room for two.
    void loadSeries(int index);
    /// Gives up what runs; ends with cancelled(). Nothing happens when nothing runs.
    void cancel();

  signals:
    void scanned(const pdr::dicom::ScanResult& scan, const QString& folder);
    /// `table`: what the patient lies on, and the scan without it.
    void loaded(std::shared_ptr<const pdr::Volume> volume, int index, const pdr::segment::HiddenTable& table);
    void failed(const pdr::Error& error);
    void cancelled();
    /// Of the job that runs: [0, 1], and what is being done.
    void progressed(double fraction, const QString& step);
    /// The job that runs has ended, one way or another.
    void finished();

  protected:
    /// Returns what is to be called with its result.
    using Work = std::function<std::function<void()>(const Progress&)>;
    /// Runs `work` on the thread; what it returns is called back here, unless a newer job has begun. What it throws,
    /// and a thread that the system does not give, end with failed().
    void start(Work work);

    QThread& thread() { return thread_; }

  private:
    std::function<void()> resultOf(const Work& work, const Progress& progress);
    std::function<void()> failure(const Error& error);
    void deliver(std::uint64_t job, const std::function<void()>& result);

    dicom::ScanResult scan_;
    std::vector<dicom::Note> loadNotes_;
    std::array<std::weak_ptr<const Volume>, 2> lastLoaded_;  ///< the scan, and that without a table
    std::atomic<std::uint64_t> job_ = 0;                     ///< the one that may go on; older ones are cancelled
    bool running_ = false;
    QThread thread_;  ///< begins with the first job
    QObject worker_;  ///< lives on thread_
};

}  // namespace pdr::app

#include "app/import_job.h"

#include <QElapsedTimer>
#include <utility>

#include "dicom/import.h"
#include "render/base/errors.h"
#include "render/base/thrown.h"
#include "ui/to_qt.h"

namespace pdr::app {
namespace {

/// Returns false if it was cancelled.
bool waitUntilFreed(const std::weak_ptr<const Volume>& volume, const Progress& progress) {
    while (!volume.expired()) {
        if (!progress(0, "closing the series before"))
            return false;
        QThread::msleep(5);
    }
    return true;
}

}  // namespace

ImportJob::ImportJob() {
    worker_.moveToThread(&thread_);
}

ImportJob::~ImportJob() {
    ++job_;
    thread_.quit();
    thread_.wait();
}

void ImportJob::scanFolder(const QString& folder) {
    start([this, folder](const Progress& progress) -> std::function<void()> {
        auto result = dicom::scanFolder(ui::fromQt(folder), progress);
        if (!result)
            return failure(result.error());
        return [this, folder, scan = std::move(*result)] {
            scan_ = scan;
            emit scanned(scan_, folder);
        };
    });
}

void ImportJob::loadSeries(int index) {
    if (index < 0 || index >= int(scan_.series.size()))
        return;
    start([this, index, series = scan_.series[std::size_t(index)],
           before = lastLoaded_](const Progress& progress) -> std::function<void()> {
        for (const auto& volume : before)
            if (!waitUntilFreed(volume, progress))
                return failure(pdr::cancelled());
        std::vector<dicom::Note> notes;
        auto result = dicom::loadSeries(series, dicom::Padding::maskAsAir, partOf(progress, 0, 0.9), &notes);
        if (!result)
            return failure(result.error());
        auto volume = std::make_shared<const Volume>(std::move(*result));
        auto table = segment::hideTable(*volume, partOf(progress, 0.9, 1));
        if (!table)
            return failure(table.error());
        return [this, index, volume, notes, table = *std::move(table)] {
            loadNotes_ = notes;
            lastLoaded_ = {volume, table.body};
            emit loaded(volume, index, table);
        };
    });
}

void ImportJob::cancel() {
    if (!running_)
        return;
    ++job_;
    running_ = false;
    emit cancelled();
    emit finished();
}

void ImportJob::start(Work work) {
    const std::uint64_t job = ++job_;
    running_ = true;
    const auto run = [this, job, work = std::move(work)] {
        QElapsedTimer sinceShown;
        const Progress progress = [this, job, &sinceShown](double fraction, std::string_view step) {
            constexpr qint64 kEveryMs = 30;  // the eye needs no more, and the window's queue stays short
            if (job != job_)
                return false;
            if (sinceShown.isValid() && sinceShown.elapsed() < kEveryMs && fraction < 1)
                return true;
            sinceShown.start();
            const QString text = QString::fromUtf8(step.data(), qsizetype(step.size()));
            QMetaObject::invokeMethod(this, [this, job, fraction, text] {
                if (job == job_)
                    emit progressed(fraction, text);
            });
            return true;
        };
        const std::function<void()> result = resultOf(work, progress);
        QMetaObject::invokeMethod(this, [this, job, result] { deliver(job, result); });
    };
    thread_.start();
    if (thread_.isRunning())
        QMetaObject::invokeMethod(&worker_, run);
    else
        deliver(job, failure({"nothing can be read: the system has no thread or no memory left for it", "",
                              "Close other programs, then open the folder again."}));
}

/// The one place of the thread where exceptions end.
std::function<void()> ImportJob::resultOf(const Work& work, const Progress& progress) {
    try {
        return work(progress);
    } catch (...) {
        return failure(thrownError());
    }
}

std::function<void()> ImportJob::failure(const Error& error) {
    return [this, error] { emit failed(error); };
}

/// A job that was overtaken has nothing to say, not even that it was cancelled.
void ImportJob::deliver(std::uint64_t job, const std::function<void()>& result) {
    if (job != job_)
        return;
    running_ = false;
    emit finished();
    result();
}

}  // namespace pdr::app

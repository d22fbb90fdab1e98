#pragma once
/// What the window shows when something has arrived: a scan, a volume, a frame, or nothing.

#include <memory>

#include "app/document.h"
#include "app/import_job.h"
#include "app/picture_job.h"
#include "app/render_bridge.h"
#include "app/settings.h"
#include "app/tissue_edits.h"
#include "app/tissue_study.h"
#include "ui/main_window.h"

namespace pdr::app {

/// The desktop's parts; whoever owns them keeps them together.
struct DesktopParts {
    ImportJob& import;
    Document& document;
    RenderBridge& bridge;
    ui::MainWindow& window;
    Settings& settings;
    TissueStudy& study;
    TissueEdits& tissue;
    PictureJob& picture;
};

/// An invitation to open a folder, and no picture; nothing of the one before is kept.
void showNothing(const DesktopParts& parts);
/// The series of `folder`; the first one that can be shown is loaded, and if there is none a message says why.
void showScan(const DesktopParts& parts, const dicom::ScanResult& scan, const QString& folder);
/// Closes what is shown, so that there is room, and reads the series `index` of the last scan.
void showReading(const DesktopParts& parts, int index);
/// The series `index` of the last scan, whose voxels are `volume`, without its `table`.
void showVolume(const DesktopParts& parts, std::shared_ptr<const Volume> volume, int index,
                const segment::HiddenTable& table);
/// How far reading has come.
void showProgress(const DesktopParts& parts, double fraction, const QString& step);
/// Reading has ended without a new picture: what is shown stays, if anything is.
void showReadingEnded(const DesktopParts& parts);
/// A message. What was shown before stays.
void showFailure(const DesktopParts& parts, const Error& error);
/// That the picture is in that file.
void showSaved(const DesktopParts& parts, const QString& file);
/// Sentences about something that did not go as it was asked; the rendering goes on.
void showNotice(const DesktopParts& parts, const QString& sentences);
/// The picture with what it shows, and how good it is; or why there is none.
void showFrame(const DesktopParts& parts, const std::shared_ptr<const Frame>& frame);
/// How good the picture is, in words; again when the rendering is held or goes on.
void showStatus(const DesktopParts& parts);
/// When rendering holds, wherever that is said.
void showStop(const DesktopParts& parts, const StopRule& rule);
/// How far the picture may be off where the mouse rests.
void showErrorAt(const DesktopParts& parts, QPointF place, const LevelErrorsAt& errors);
/// What the effects cost, as far as it is known.
void showEffects(const DesktopParts& parts);
/// Does what the panel of effects offers.
void leaveOutUnseen(const DesktopParts& parts);
/// What the click on the picture asks for: what lies there.
void pickTissue(const DesktopParts& parts, QPointF place);
/// Makes the picture that was ordered beside the session.
void makePicture(const DesktopParts& parts, const ui::PictureOrder& order);
/// Gives up what the progress is shown of: reading, or else a picture that is being made.
void cancelWhatRuns(const DesktopParts& parts);
/// Everything that follows the document: the camera that the user turns, preset, brightness, undo.
void showDocument(const DesktopParts& parts);

}  // namespace pdr::app

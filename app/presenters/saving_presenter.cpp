#include "app/presenters/saving_presenter.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <algorithm>

#include "app/presenters/annotating.h"
#include "app/presenters/clipboard_image.h"
#include "app/presenters/image_cost.h"
#include "app/presenters/image_text.h"
#include "render/scene/edit/tissue_channels.h"
#include "ui/output/save_dialog.h"

namespace pdr::app {
namespace {

/// Returns whether the boundary between air and skin stops light: its opacity exceeds a hundredth of the maximum.
bool showsSkin(const TransferFunction& function) {
    constexpr float kSkin[] = {-250, -200, -150, -100};  // [HU] of voxels that skin and air share, and of fat below
    const Curve opacity = curveOf(function, TissueChannel::opacity);
    const float most = heightOf(opacity);
    return std::ranges::any_of(kSkin, [&](float hu) { return valueAt(opacity, hu) > 0.01f * most; });
}

}  // namespace

SavingPresenter::SavingPresenter(const Workspace& workspace) : Presenter(workspace), saver_(bridge()) {
    const ui::WindowActions& actions = window().menuActions();
    actions.captioned->setChecked(settings().captioned());
    connect(actions.captioned, &QAction::triggered, this,
            [this](bool captioned) { settings().keepCaptioned(captioned); });
    connect(actions.save, &QAction::triggered, this, &SavingPresenter::ask);
    connect(actions.copy, &QAction::triggered, this, &SavingPresenter::copy);
    connect(&saver_, &ImageSaver::saved, this, &SavingPresenter::showSaved);
    connect(&saver_, &ImageSaver::failed, this, &SavingPresenter::showError);
    connectJob();
}

void SavingPresenter::connectJob() {
    showProgressOf(job_);
    connect(&job_, &ImageJob::progressed, this, [this] {
        window().setQuestionOnClosing(ui::MainWindow::tr("An image is still rendering. Quit and discard it?"));
    });
    connect(&job_, &ImageJob::finished, this, [this] { window().setQuestionOnClosing({}); });
    connect(&job_, &ImageJob::saved, this, &SavingPresenter::showSaved);
    connect(&job_, &ImageJob::failed, this, &SavingPresenter::showError);
    connect(&job_, &ImageJob::cancelled, this,
            [this] { window().status().showForAWhile(ui::MainWindow::tr("Cancelled: no image was saved")); });
}

void SavingPresenter::showFrame(const std::shared_ptr<const Frame>& frame) {
    name_ = fileNameOf(document().looks(), *frame);
    cost_ = costOf(settings(), *frame);
    setImageAvailable(true);
}

void SavingPresenter::clearImage() {
    setImageAvailable(false);
}

void SavingPresenter::releaseVolume() {
    job_.cancel();
    saidSkin_ = false;
}

void SavingPresenter::setImageAvailable(bool available) {
    window().menuActions().save->setEnabled(available);
    window().menuActions().copy->setEnabled(available);
}

/// Returns the choice for images that leave the window without a question to the user.
ui::Annotate SavingPresenter::usualAnnotate() const {
    return window().menuActions().captioned->isChecked() ? ui::Annotate::sides : ui::Annotate::none;
}

/// Asks for the file and how to save the image in it.
void SavingPresenter::ask() {
    const bool patientKnown = !window().patient().isEmpty() && !window().namesHidden();
    const auto order =
        ui::askForImage(&window(), *window().menuActions().save,
                        {window().viewport().sizeInPixels(), name_, folder_, cost_, usualAnnotate(), patientKnown});
    if (!order)
        return;
    folder_ = QFileInfo(order->file).absolutePath();
    if (order->size)
        render(*order);
    else
        save(order->file, order->annotate);
}

void SavingPresenter::render(const ui::ImageOrder& order) {
    if (!document().hasVolume() || !order.size)
        return;
    Scene scene = document().scene();
    scene.film = {order.size->width(), order.size->height()};
    job_.make({scene, document().display(), leaving(annotationsOf(workspace(), scene), order.annotate), order.stop,
               order.file, bridge().finalRenderDevice(), bridge().devices().nodeChecks()});
}

void SavingPresenter::save(const QString& file, ui::Annotate annotate) {
    const auto& frame = bridge().lastFrame();
    saver_.save(file, frame ? leaving(annotationsOf(workspace(), *frame), annotate) : std::nullopt);
}

void SavingPresenter::copy() {
    const auto& frame = bridge().lastFrame();
    if (!frame)
        return;
    const auto annotations = leaving(annotationsOf(workspace(), *frame), usualAnnotate());
    QGuiApplication::clipboard()->setImage(copyOf(*frame, document().scene().film, annotations));
    window().status().showForAWhile(ui::MainWindow::tr("Copied"));
    showWhoCanBeKnown();
}

void SavingPresenter::showSaved(const QString& file) {
    window().status().showForAWhile(ui::MainWindow::tr("Saved as %1").arg(file));
    showWhoCanBeKnown();
}

/// Says once for each series that an image which shows skin shows who the patient is.
void SavingPresenter::showWhoCanBeKnown() {
    if (saidSkin_ || !showsSkin(document().setup().look.transferFunction))
        return;
    saidSkin_ = true;
    window().message().showNotice(
        ui::MainWindow::tr("This image shows skin: share it like a photograph of the patient."));
}

}  // namespace pdr::app

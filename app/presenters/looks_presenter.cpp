#include "app/presenters/looks_presenter.h"

#include <QVBoxLayout>
#include <algorithm>

#include "app/looks/look_files.h"
#include "app/presenters/look_cards.h"
#include "app/presenters/look_text.h"
#include "render/scene/sky_image.h"

namespace pdr::app {
namespace {

/// Returns a widget with one panel above another; the upper one takes the extra height.
QWidget* stacked(QWidget* above, QWidget* below) {
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(above, 1);
    column->addWidget(below);
    return both;
}

/// Returns the look that is shown, with its brightness, under `name`.
NamedLook shownLook(const Document& document, const std::string& name) {
    const ImageSetup& setup = document.setup();
    NamedLook named;
    if (const NamedLook* begun = document.looks().beginningOf(setup)) {
        named.doesNotShow = begun->doesNotShow;
        named.bloodHu = begun->bloodHu;
        named.cut = begun->cut;
    }
    named.name = name;
    named.model = setup.model;
    named.look = setup.look;
    named.look.display.exposure = displayOf(setup).exposure;
    named.look.environment = withoutImage(named.look.environment);  // look files contain no environment images
    return named;
}

/// Returns the looks that are bundled with the program.
std::vector<NamedLook> bundledLooksOf(const Document& document) {
    std::vector<NamedLook> looks = document.looks().drawn();
    std::erase_if(looks, [](const NamedLook& look) { return look.group == LookGroup::own; });
    return looks;
}

/// Returns the error where a look is to be kept or taken: looks are drawn in HU.
Error notInHu() {
    return {phrase("the values of this scan are no HU, in which looks are kept"), "",
            phrase("Open a CT scan for that."), ErrorKind::refused};
}

Result<void> checkFree(const Document& document, const std::string& name) {
    for (const NamedLook& look : bundledLooksOf(document))
        if (look.name == name || nameText(look).toStdString() == name)
            return Error{phrase("a built-in look has this name"), name, phrase("Choose another one.")};
    return {};
}

}  // namespace

LooksPresenter::LooksPresenter(const Workspace& workspace, const QString& ownLooks)
    : Presenter(workspace), panel_(new ui::LookPanel), visible_(new ui::VisibleRow), own_(ownLooks) {
    window().addPanel(stacked(panel_, visible_), {"Look", ui::WindowDocks::tr("Appearance"), Qt::Key_F3});
    images_.setImageStands(false);
    connectPanel();
    connectMenu();
    offerOwnLooks();
}

void LooksPresenter::connectPanel() {
    connect(panel_, &ui::LookPanel::lookChosen, &document(), &Document::chooseLook);
    connect(panel_, &ui::LookPanel::brightnessChosen, &document(), &Document::setBrightness);
    QAction* pause = window().menuActions().pause;
    connect(panel_, &ui::LookPanel::pauseChosen, pause, &QAction::trigger);
    connect(pause, &QAction::toggled, panel_, &ui::LookPanel::setPaused);
    connect(&document(), &Document::sceneChanged, this, [this](const Scene&, bool moving) { requestImages(moving); });
    connect(&images_, &LookImages::made, this, [this](int look, const QImage& picture, double stops) {
        panel_->gallery().setImage(look, picture);
        document().suggestBrightness(look, stops);
    });
}

void LooksPresenter::connectMenu() {
    const ui::LookMenu& menu = panel_->menu();
    connect(&menu, &ui::LookMenu::saveWanted, this, &LooksPresenter::save);
    connect(&menu, &ui::LookMenu::renameWanted, this, &LooksPresenter::rename);
    connect(&menu, &ui::LookMenu::deleteWanted, this,
            [this](const QString& name) { showChange(own_.remove(name.toStdString()), ""); });
    connect(&menu, &ui::LookMenu::importWanted, this, &LooksPresenter::importFrom);
    connect(&menu, &ui::LookMenu::exportWanted, this, &LooksPresenter::exportTo);
}

void LooksPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        panel_->setEnabled(document().hasVolume());
        if (!document().hasVolume())
            images_.setImageStands(false);
    }
    if (has(changes, Changes::looks))
        panel_->gallery().setLooks(lookCards(document()));
    if (has(changes, Changes::partSources))  // looks may show them, and the image may not
        requestImages(false);
    if (!has(changes, Changes::look | Changes::model | Changes::brightness | Changes::looks | Changes::series))
        return;  // comparing all looks is not for each move of a camera
    panel_->setLook(document().look());
    panel_->setDoesNotShow(doesNotShowText(document().looks(), document().setup()));
    panel_->setBrightness(document().setup().stops);
}

void LooksPresenter::showFrame(const std::shared_ptr<const Frame>&) {
    images_.setImageStands(true);
    afterImage_.imageStands();
}

void LooksPresenter::releaseVolume() {
    afterImage_.reset();
    images_.forget();
}

void LooksPresenter::requestImages(bool moving) {
    if (moving)
        images_.cancel();
    else if (document().hasVolume())
        afterImage_.call([this] {
            images_.make(document().seen(), document().parts(), document().bodyBox(), lookTasks(document()));
        });
}

/// Offers the user's own looks after the bundled ones.
void LooksPresenter::offerOwnLooks() {
    std::vector<NamedLook> looks = bundledLooksOf(document());
    OwnLooks::Read own = own_.read();
    for (const Error& problem : own.problems)
        showError(problem);
    for (NamedLook& look : own.looks)
        looks.push_back(std::move(look));
    document().setLooks(std::move(looks));
    requestImages(false);
}

/// Shows the looks after a change, or its error, and chooses the look `name` if it exists.
void LooksPresenter::showChange(const Result<void>& changed, const std::string& name) {
    if (!changed)
        return showError(changed.error());
    offerOwnLooks();
    const auto& looks = document().looks().fitted();
    if (const auto look = std::ranges::find(looks, name, &NamedLook::name); look != looks.end())
        document().chooseLook(int(look - looks.begin()));
}

void LooksPresenter::keep(const NamedLook& look) {
    const Result<void> free = document().looks().areInHu() ? checkFree(document(), look.name) : notInHu();
    showChange(free ? own_.save(look) : free, look.name);
}

void LooksPresenter::save(const QString& name) {
    const bool sky = document().setup().look.environment.image && document().looks().areInHu();
    keep(shownLook(document(), name.toStdString()));
    if (sky)
        window().message().showNotice(
            ui::MainWindow::tr("Looks cannot hold an environment image: this one has uniform ambient light."));
}

void LooksPresenter::rename(const QString& from, const QString& to) {
    const Result<void> free = checkFree(document(), to.toStdString());
    showChange(free ? own_.rename(from.toStdString(), to.toStdString()) : free, to.toStdString());
}

void LooksPresenter::importFrom(const QString& file) {
    const auto look = readLookFile(file, document().looks()[0]);
    if (!look)
        return showError(look.error());
    keep(*look);
}

void LooksPresenter::exportTo(const QString& file) {
    if (!document().looks().areInHu())
        return showError(notInHu());
    if (auto written = writeLookFile(shownLook(document(), lookTitle(document().setup())), file); !written)
        return showError(written.error());
    window().status().showForAWhile(ui::MainWindow::tr("Saved as %1").arg(file));
}

}  // namespace pdr::app

#include "ui/looks/look_gallery.h"

#include <QGridLayout>
#include <QPixmap>
#include <QRegularExpression>
#include <cstdlib>

namespace pdr::ui {
namespace {

constexpr int kColumns = 2;
constexpr int kCard = 136;  ///< width of a look with its name [px]

/// Breaks a name that is wider than a card into two lines of similar length.
QString inLines(const QString& name, const QFontMetrics& metrics) {
    if (metrics.horizontalAdvance(name) <= kCard - 16)
        return name;
    int best = -1;
    for (int space = name.indexOf(' '); space >= 0; space = name.indexOf(' ', space + 1))
        if (best < 0 || std::abs(2 * space - name.size()) < std::abs(2 * best - name.size()))
            best = space;
    return best < 0 ? name : QString(name).replace(best, 1, '\n');
}

QString headingOf(const LookCard& card) {
    return card.unsuited.isEmpty() ? card.group : LookGallery::tr("Not for this scan");
}

QString tipOf(const LookCard& card) {
    const QString why = card.unsuited.isEmpty() ? QString() : LookGallery::tr("Not offered: %1.").arg(card.unsuited);
    return QStringList({card.name, card.doesNotShow, why}).filter(QRegularExpression(".")).join('\n');
}

}  // namespace

LookGallery::LookGallery(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(2);
    connect(&buttons_, &QButtonGroup::idClicked, this, &LookGallery::lookChosen);
}

void LookGallery::setLooks(const QList<LookCard>& looks) {
    if (looks == looks_)
        return;
    // Remember the thumbnails and the current look
    QHash<QString, QIcon> images;
    for (QAbstractButton* button : buttons_.buttons())
        images[looks_[buttons_.id(button)].name] = button->icon();
    const int shown = buttons_.checkedId();
    const QString kept = shown >= 0 ? looks_[shown].name : QString();
    clear();
    looks_ = looks;
    // Add those that suit the scan, then the others
    for (const bool suited : {true, false})
        for (int i = 0; i < looks.size(); ++i)
            if (looks[i].unsuited.isEmpty() == suited)
                addCard(i);
    // Restore the thumbnails and the current look
    for (QAbstractButton* button : buttons_.buttons()) {
        const LookCard& card = looks_[buttons_.id(button)];
        button->setIcon(images.value(card.name));
        button->setChecked(card.name == kept);
    }
    orderTabs();
}

/// Orders the Tab focus as the looks are read, before the widgets that follow the gallery.
void LookGallery::orderTabs() {
    QWidget* before = leader_;
    const auto next = [&](QWidget* widget) {
        if (before)
            setTabOrder(before, widget);
        before = widget;
    };
    for (int i = 0; i + 1 < column_->count(); i += 2) {
        next(column_->itemAt(i)->widget());
        const QLayout& cards = *column_->itemAt(i + 1)->widget()->layout();
        for (int card = 0; card < cards.count(); ++card)
            next(cards.itemAt(card)->widget());
    }
    for (QWidget* follower : followers_)
        next(follower);
}

/// Removes all groups. Their widgets are deleted later, since one of them may be handling an event.
void LookGallery::clear() {
    for (QAbstractButton* button : buttons_.buttons())
        buttons_.removeButton(button);
    for (const Group& group : std::as_const(groups_))
        for (QWidget* widget : {static_cast<QWidget*>(group.heading), group.body}) {
            column_->removeWidget(widget);
            widget->hide();
            widget->deleteLater();
        }
    groups_.clear();
}

LookGallery::Group& LookGallery::groupOf(const QString& name) {
    if (const auto known = groups_.find(name); known != groups_.end())
        return *known;
    auto* heading = new QToolButton;
    heading->setText(name);
    heading->setAccessibleName(tr("Looks: %1").arg(name));
    heading->setCheckable(true);
    heading->setAutoRaise(true);
    heading->setFocusPolicy(Qt::TabFocus);
    heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    heading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* body = new QWidget;
    auto* grid = new QGridLayout(body);
    grid->setContentsMargins(0, 0, 0, 4);
    grid->setSpacing(2);
    grid->setColumnStretch(kColumns, 1);
    connect(heading, &QToolButton::clicked, this, [this, name](bool open) {
        open_[name] = open;
        unfold(name, open);
        if (open)
            emit unfolded(groups_[name].body);
    });
    column_->addWidget(heading);
    column_->addWidget(body);
    Group& group = *groups_.insert(name, {heading, body});
    unfold(name, open_.value(name, false));
    return group;
}

void LookGallery::unfold(const QString& group, bool open) {
    const Group& found = groups_[group];
    found.heading->setChecked(open);
    found.heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    found.body->setVisible(open);
}

void LookGallery::addCard(int index) {
    const LookCard& card = looks_[index];
    auto* grid = static_cast<QGridLayout*>(groupOf(headingOf(card)).body->layout());
    auto* button = new QToolButton;
    button->setText(inLines(card.name, button->fontMetrics()));
    button->setAccessibleName(tr("Look %1").arg(card.name));
    button->setAccessibleDescription(card.doesNotShow);
    button->setToolTip(tipOf(card));
    button->setIconSize({kImage, kImage});
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setFixedWidth(kCard);
    buttons_.addButton(button, index);
    const int place = grid->count();
    grid->addWidget(button, place / kColumns, place % kColumns, Qt::AlignTop);
}

void LookGallery::setLook(int index) {
    buttons_.setExclusive(false);  // so that no button may be checked
    for (QAbstractButton* button : buttons_.buttons())
        button->setChecked(buttons_.id(button) == index);
    buttons_.setExclusive(true);
    if (index < 0 || index >= looks_.size())
        return;
    const QString heading = headingOf(looks_[index]);
    if (open_.value(heading, true))
        unfold(heading, true);
}

void LookGallery::setImage(int index, const QImage& image) {
    QAbstractButton* button = buttons_.button(index);
    if (!button)
        return;
    button->setIcon(QIcon(QPixmap::fromImage(image)));
}

}  // namespace pdr::ui

#include "ui/accuracy/effect_costs.h"

#include <QVBoxLayout>
#include <array>

#include "ui/widgets/scrolled.h"

namespace pdr::ui {
namespace {

constexpr int kReason = 1;   ///< column that shrinks where room is short
constexpr int kFigures = 2;  ///< first column of figures

struct Column {
    const char* title;
    const char* explanation;
    const char* widest = "";  ///< widest text expected in the column
};

const std::array<Column, 7> kColumns{
    {{QT_TR_NOOP("Effect"), ""},
     {QT_TR_NOOP("needed, because"), ""},
     {QT_TR_NOOP("ms per iteration"),
      QT_TR_NOOP(
          "Processor time that an iteration of the small image takes more with it: median, and the smallest to the "
          "largest of six measurements"),
      "12.34 (12.34 to 12.34)"},
     {QT_TR_NOOP("share"), QT_TR_NOOP("The part of an iteration's time that goes to it"), "51 % (42 to 55)"},
     {QT_TR_NOOP("without it: mean"),
      QT_TR_NOOP("Of 255 grey levels, by how many the image changes without it, on average over what it shows; to "
                 "95 % it lies between the two faint numbers"),
      "65.7 (62.9 to 68.3)"},
     {QT_TR_NOOP("95 % within"),
      QT_TR_NOOP("95 % of the image changes by no more levels than this; to 95 % it lies between the two faint "
                 "numbers"),
      "122.3 (115.8 to 128.8)"},
     {QT_TR_NOOP("time to the target"),
      QT_TR_NOOP("How long any target takes without it, in percent of the time with it: an iteration takes another "
                 "time, and the image has other noise"),
      "71 % (46 to 110)"}}};

QLabel* cell(const QString& text, bool faint) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::RichText);
    if (faint)
        label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

/// Formats a figure such as "38 % (36 to 40)", with its interval faint.
QString figure(const QString& text, const QString& faint) {
    const qsizetype band = text.indexOf(" (");
    QString value = text.left(band < 0 ? text.size() : band).toHtmlEscaped();
    if (band < 0)
        return value;
    return QString("%1 <span style='color:%2'>%3</span>").arg(value, faint, text.mid(band + 1).toHtmlEscaped());
}

/// Lets a long text be cut off at its end, so that it does not widen the window.
void mayBeCut(QLabel* label) {
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

}  // namespace

EffectCosts::EffectCosts(QWidget* parent)
    : QWidget(parent),
      table_(new QGridLayout),
      off_(cell({}, true)),
      how_(cell({}, true)),
      onlyNeeded_(new QPushButton(tr("Turn off effects that do not show"))),
      statement_(new QWidget),
      question_(new QWidget),
      questionText_(new QLabel),
      leaveOut_(new QPushButton(tr("Turn off"))),
      keep_(new QPushButton(tr("Keep all"))) {
    layOut();
    connect(onlyNeeded_, &QPushButton::clicked, this, &EffectCosts::ask);
    connect(leaveOut_, &QPushButton::clicked, this, [this] { answer(true); });
    connect(keep_, &QPushButton::clicked, this, [this] { answer(false); });
    fill();
}

QSize EffectCosts::sizeHint() const {
    constexpr int kLines = 8;  // enough for most scenes: a title, six effects, those that are off
    return {QWidget::sizeHint().width(),
            kLines * (fontMetrics().height() + table_->verticalSpacing()) + onlyNeeded_->sizeHint().height() + 16};
}

void EffectCosts::layOut() {
    table_->setHorizontalSpacing(18);
    table_->setVerticalSpacing(3);
    table_->setColumnStretch(kReason, 1);
    for (std::size_t i = kFigures; i < kColumns.size(); ++i)
        table_->setColumnMinimumWidth(int(i), fontMetrics().horizontalAdvance(kColumns[i].widest));
    for (QLabel* label : {off_, how_})
        mayBeCut(label);
    questionText_->setWordWrap(true);
    onlyNeeded_->setToolTip(tr("Turns off the effects that nobody would see, and lists them first"));
    // A click leaves the keyboard focus with the image; Tab still reaches everything.
    for (QPushButton* button : {onlyNeeded_, leaveOut_, keep_})
        button->setFocusPolicy(Qt::TabFocus);

    // Lay out the question and the statement, one of which is shown
    auto* ask = new QHBoxLayout(question_);
    ask->setContentsMargins(0, 0, 0, 0);
    ask->addWidget(questionText_, 1);
    ask->addWidget(leaveOut_);
    ask->addWidget(keep_);
    auto* last = new QHBoxLayout(statement_);
    last->setContentsMargins(0, 0, 0, 0);
    last->addWidget(how_, 1);
    last->addWidget(onlyNeeded_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 2, 10, 8);
    column->setSpacing(6);
    // Lay out the table, which scrolls, above them
    auto* content = new QWidget;
    auto* lines = new QVBoxLayout(content);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->addLayout(table_);
    lines->addWidget(off_);
    lines->addStretch(1);
    column->addWidget(scrolled(content), 1);
    column->addWidget(statement_);
    column->addWidget(question_);
    showQuestion(false);
}

void EffectCosts::setRows(const EffectRows& rows) {
    if (rows.leftOut != rows_.leftOut)
        showQuestion(false);
    rows_ = rows;
    fill();
}

void EffectCosts::fill() {
    while (QLayoutItem* item = table_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    // Add the titles
    for (std::size_t i = 0; i < kColumns.size() && !rows_.needed.isEmpty(); ++i) {
        QLabel* title = cell(tr(kColumns[i].title), true);
        title->setToolTip(tr(kColumns[i].explanation));
        table_->addWidget(title, 0, int(i));
    }
    // Add a line for each effect
    const QString faint = palette().color(QPalette::PlaceholderText).name();
    int line = 0;
    for (const EffectRow& row : rows_.needed) {
        ++line;
        table_->addWidget(cell(row.name.toHtmlEscaped(), false), line, 0);
        QLabel* reason = cell(row.reason.toHtmlEscaped(), true);
        reason->setToolTip(row.reason);
        mayBeCut(reason);
        table_->addWidget(reason, line, kReason);
        int column = kFigures;
        for (const QString& text : {row.milliseconds, row.share, row.meanLevels, row.levels95, row.time}) {
            QLabel* shown = cell(figure(text, faint), row.ofViewBefore);
            QFont font = shown->font();
            font.setItalic(row.ofViewBefore);
            shown->setFont(font);
            table_->addWidget(shown, line, column++);
        }
    }
    // List the effects that are off
    const auto nameOf = [](const QString& effect) { return effect.section(':', 0, 0); };
    QStringList names;
    for (const QString& effect : rows_.off)
        names << nameOf(effect);
    off_->setText(names.isEmpty() ? QString() : tr("Off, without any loss: %1").arg(names.join(", ")));
    off_->setToolTip(rows_.off.join('\n'));
    // State how the costs were measured
    const bool allNeeded = rows_.complete && rows_.leftOut.isEmpty();
    how_->setText(allNeeded ? tr("%1 · all active effects are needed").arg(rows_.how) : rows_.how);
    how_->setToolTip(how_->text());
    onlyNeeded_->setEnabled(!rows_.leftOut.isEmpty());
}

void EffectCosts::ask() {
    questionText_->setText(tr("Turns off %1.").arg(rows_.leftOut.join("; ")));
    showQuestion(true);
}

void EffectCosts::showQuestion(bool shown) {
    statement_->setVisible(!shown);
    question_->setVisible(shown);
}

void EffectCosts::answer(bool leaveOut) {
    showQuestion(false);
    if (leaveOut)
        emit leaveOutChosen();
}

}  // namespace pdr::ui

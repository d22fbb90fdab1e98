#pragma once
/// The looks to choose from, in groups that fold, each as a small picture of this patient. Setters are silent.

#include <QButtonGroup>
#include <QHash>
#include <QImage>
#include <QList>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace pdr::ui {

/// One look, in words.
struct LookCard {
    QString name;
    QString group;        ///< as it is headed
    QString doesNotShow;  ///< a sentence or two
    QString unsuited;     ///< why it makes no sense of this scan: a clause; empty: it does
    bool own = false;     ///< the user's
    bool operator==(const LookCard&) const = default;
};

class LookGallery : public QWidget {
    Q_OBJECT

  public:
    /// Edge of a picture [pixels of the window].
    static constexpr int kPicture = 88;

    explicit LookGallery(QWidget* parent = nullptr);

    /// Looks that make no sense of this scan stand under a heading of their own, last. What is folded stays so.
    /// Pictures of looks that stay are kept. Nothing unfolds until setLook().
    void setLooks(const QList<LookCard>& looks);
    const QList<LookCard>& looks() const { return looks_; }
    /// What Tab reaches before the first look, and after the last, in that order.
    void setNeighbours(QWidget* leader, const QList<QWidget*>& followers) {
        leader_ = leader;
        followers_ = followers;
    }
    /// -1: none of them is shown. Its group unfolds.
    void setLook(int index);
    /// A null image: none yet.
    void setPicture(int index, const QImage& picture);

  signals:
    void lookChosen(int index);
    /// By hand; `group` holds its pictures.
    void unfolded(QWidget* group);

  private:
    struct Group {
        QToolButton* heading;
        QWidget* body;
    };

    void clear();
    Group& groupOf(const QString& name);
    void addCard(int index);
    void orderTabs();
    void unfold(const QString& group, bool open);

    QList<LookCard> looks_;
    QWidget* leader_ = nullptr;
    QList<QWidget*> followers_;
    QVBoxLayout* column_;
    QButtonGroup buttons_;
    QHash<QString, Group> groups_;
    QHash<QString, bool> open_;  ///< that the hand folded or unfolded, by heading
};

}  // namespace pdr::ui

// A label in one of the few ways in which the workbench sets text. Follows light and dark.
#pragma once

#include "widgets/style/palette.h"

#include <QLabel>

namespace driftbench {

enum class TextRole
{
    Body,
    Muted,      // body, muted: labels of fields
    Note,       // 9 pt, muted
    NoteText,   // 9 pt in the text colour: values of read-outs
    StrongNote, // 9 pt semibold
    Section,    // 10 pt semibold: section heads
    Result,     // 12 pt semibold
    Title,      // 15 pt semibold
    Code,       // the system's fixed-width font: rules, CRCs
};

// What a figure or a word says beside its text; always together with an icon or a word.
enum class Tone
{
    Plain,
    Accent, // the main result
    Good,
    Caution,
    Bad,
};

QFont textFont(TextRole role);
QColor textColor(TextRole role, Tone tone, const Palette &look);

class TextLabel : public QLabel
{
    Q_OBJECT

public:
    explicit TextLabel(TextRole role, const QString &text = {}, QWidget *parent = nullptr);
    explicit TextLabel(TextRole role, QWidget *parent) : TextLabel(role, QString(), parent) {}

    void setRole(TextRole role);
    void setTone(Tone tone);
    Tone tone() const { return m_tone; }
    // Cuts the text with "…" where there is no room, and shows it whole as a tooltip then.
    void setElided(bool elided);

    QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void recolor();

    TextRole m_role;
    Tone m_tone = Tone::Plain;
    bool m_elided = false;
};

} // namespace driftbench

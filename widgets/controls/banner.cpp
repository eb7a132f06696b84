#include "widgets/controls/banner.h"

#include "widgets/controls/icon.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kEdge = 4;
static constexpr int kTextLeft = 48;
static constexpr int kLeastHeight = 36;

struct BannerColors
{
    QColor edge, fill, mark;
};

static BannerColors colorsOf(BannerKind kind, const Palette &look)
{
    switch (kind) {
    case BannerKind::Caution:
        return {look.cautionEdge, look.cautionFill, look.caution};
    case BannerKind::Bad:
        return {look.bad, look.badFill, look.bad};
    case BannerKind::Info:
        break;
    }
    return {look.accent, look.infoFill, look.accent};
}

static QString iconOf(BannerKind kind)
{
    return kind == BannerKind::Info      ? QStringLiteral("info")
           : kind == BannerKind::Caution ? QStringLiteral("warn")
                                         : QStringLiteral("cross");
}

Banner::Banner(QWidget *parent)
    : QFrame(parent)
    , m_text(new QLabel(this))
    , m_code(new QLineEdit(this))
    , m_buttons(new QHBoxLayout)
    , m_close(new QToolButton(this))
{
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(kTextLeft, 0, 8, 0);
    columns->setSpacing(kGap);
    auto *lines = new QVBoxLayout;
    lines->setContentsMargins(0, 7, 0, 7);
    lines->setSpacing(0);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::RichText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    lines->addWidget(m_text);
    m_code->setReadOnly(true);
    m_code->setFrame(false);
    m_code->setTextMargins(-2, 0, 0, 0);
    lines->addWidget(m_code);
    columns->addLayout(lines, 1);
    m_buttons->setSpacing(12);
    m_buttons->setContentsMargins(0, 6, 0, 6);
    columns->addLayout(m_buttons);
    columns->setAlignment(m_buttons, Qt::AlignTop);
    m_close->setAutoRaise(true);
    m_close->setFixedSize(20, 20);
    m_close->setFocusPolicy(Qt::StrongFocus);
    auto *corner = new QVBoxLayout;
    corner->setContentsMargins(0, 8, 0, 8);
    corner->addWidget(m_close);
    corner->addStretch(1);
    columns->addLayout(corner);
    connect(m_close, &QToolButton::clicked, this, &Banner::closed);
    setMinimumHeight(kLeastHeight);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void Banner::setContent(const BannerContent &content)
{
    m_content = content;
    while (QLayoutItem *item = m_buttons->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (QAction *action : content.actions) {
        auto *button = new ActionButton(action, ButtonSize::Small, this);
        button->setShortcutShown(false);
        m_buttons->addWidget(button);
    }
    m_close->setVisible(content.closable);
    showText();
}

void Banner::showText()
{
    const Palette &look = lookOf(palette());
    // With a line of code the sentences stand above it, one a line.
    const QString apart = m_content.code.isEmpty() ? QStringLiteral(" ") : QStringLiteral("<br>");
    m_text->setText(QStringLiteral("<span style='font-weight:600'>%1</span>%2")
                        .arg(m_content.what.toHtmlEscaped(),
                             m_content.toDo.isEmpty() ? QString() : apart + m_content.toDo.toHtmlEscaped()));
    setAccessibleName(m_content.what + QLatin1Char(' ') + m_content.toDo);
    m_code->setVisible(!m_content.code.isEmpty());
    m_code->setText(m_content.code);
    m_code->setCursorPosition(0);
    m_code->setFont(textFont(TextRole::Code));
    m_code->setAccessibleName(tr("Line to copy"));
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(m_close->toolTip());
    m_close->setIcon(QIcon(iconPixmap(QStringLiteral("cross"), kSmallIcon, look.text, devicePixelRatioF())));
    update();
}

void Banner::paintEvent(QPaintEvent *)
{
    const BannerColors colors = colorsOf(m_content.kind, lookOf(palette()));
    QPainter painter(this);
    paintBox(painter, rect(), {colors.fill, colors.edge});
    QPainterPath shape;
    shape.addRoundedRect(rect(), kCornerRadius, kCornerRadius);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipPath(shape);
    painter.fillRect(0, 0, kEdge, height(), colors.edge);
    painter.setClipping(false);
    const QString icon = m_content.icon.isEmpty() ? iconOf(m_content.kind) : m_content.icon;
    paintIcon(painter, QRect(16, 8, kIcon, kIcon), icon, colors.mark);
}

void Banner::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange)
        showText();
}

} // namespace driftbench

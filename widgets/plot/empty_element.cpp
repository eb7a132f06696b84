#include "widgets/plot/empty_element.h"

#include "widgets/style/fonts.h"

namespace driftbench {

EmptyElement::EmptyElement(QCustomPlot *plot, QString headline, QString sentence, const Palette &palette)
    : QCPLayoutElement(plot)
    , m_headline(std::move(headline))
    , m_sentence(std::move(sentence))
    , m_textColor(palette.text)
    , m_mutedColor(palette.mutedText)
{
}

void EmptyElement::draw(QCPPainter *painter)
{
    const int middle = mOuterRect.center().y();
    painter->setPen(m_textColor);
    painter->setFont(sectionFont());
    painter->drawText(QRect(mOuterRect.left(), middle - 24, mOuterRect.width(), 24), Qt::AlignCenter,
                      m_headline);
    painter->setPen(m_mutedColor);
    painter->setFont(bodyFont());
    painter->drawText(QRect(mOuterRect.left(), middle, mOuterRect.width(), 48),
                      Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_sentence);
}

} // namespace driftbench

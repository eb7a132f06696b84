#include "widgets/controls/icon.h"

#include "widgets/style/theme.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <cmath>

// The icons are linked as part of a static library: Qt asks for this call from outside every namespace.
static void initialiseIconResources()
{
    Q_INIT_RESOURCE(app);
}

namespace driftbench {

static QImage iconMask(const QString &name, int devicePx)
{
    initialiseIconResources();
    QSvgRenderer renderer(QStringLiteral(":/driftbench/icons/%1.svg").arg(name));
    QImage image(devicePx, devicePx, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    if (!renderer.isValid())
        return image;
    QPainter painter(&image);
    renderer.render(&painter);
    return image;
}

QPixmap iconPixmap(const QString &name, int sizePx, const QColor &color, qreal devicePixelRatio)
{
    const int devicePx = static_cast<int>(std::lround(sizePx * devicePixelRatio));
    const QString key = QStringLiteral("driftbench/%1/%2/%3").arg(name).arg(devicePx).arg(color.rgba());
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        QImage image = iconMask(name, devicePx);
        QPainter painter(&image);
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(image.rect(), color);
        painter.end();
        pixmap = QPixmap::fromImage(image);
        QPixmapCache::insert(key, pixmap);
    }
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

void paintIcon(QPainter &painter, const QRect &rect, const QString &name, const QColor &color)
{
    const int size = std::min(rect.width(), rect.height());
    const QPoint corner = rect.center() - QPoint((size - 1) / 2, (size - 1) / 2);
    painter.drawPixmap(corner, iconPixmap(name, size, color, painter.device()->devicePixelRatioF()));
}

namespace {

class ThemedIconEngine : public QIconEngine
{
public:
    explicit ThemedIconEngine(QString name) : m_name(std::move(name)) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        paintIcon(*painter, rect, m_name, colorFor(mode));
    }
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State) override
    {
        return iconPixmap(m_name, std::min(size.width(), size.height()), colorFor(mode));
    }
    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State, qreal) override
    {
        return iconPixmap(m_name, std::min(size.width(), size.height()), colorFor(mode));
    }
    QIconEngine *clone() const override { return new ThemedIconEngine(m_name); }

private:
    static QColor colorFor(QIcon::Mode mode)
    {
        const Palette &look = lookOf(QGuiApplication::palette());
        return mode == QIcon::Disabled ? look.disabledText : look.text;
    }

    QString m_name;
};

} // namespace

QIcon themedIcon(const QString &name)
{
    return QIcon(new ThemedIconEngine(name));
}

QIcon applicationIcon()
{
    initialiseIconResources();
    return QIcon(QStringLiteral(":/driftbench/application.svg"));
}

} // namespace driftbench

// The place of the one banner of a page. Messages are posted under a key; the most urgent is shown, the
// latest of equals. Nothing posted: no room taken.
#pragma once

#include "widgets/controls/banner.h"

#include <QWidget>

#include <functional>
#include <vector>

namespace driftbench {

class BannerSlot : public QWidget
{
    Q_OBJECT

public:
    explicit BannerSlot(QWidget *parent = nullptr);

    void post(const QString &key, const BannerContent &content); // replaces what stands under the key
    void post(const QString &key, std::function<BannerContent()> content); // asked again in another language
    void withdraw(const QString &key);
    bool holds(const QString &key) const;
    const Banner &banner() const { return *m_banner; }

signals:
    void dismissed(const QString &key); // closed by the user; it is withdrawn already

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Message
    {
        QString key;
        BannerContent content;
        std::function<BannerContent()> again; // empty: the content stays as it is
    };

    void put(Message message);
    void showMostUrgent();

    std::vector<Message> m_messages; // the latest last
    QString m_shown;
    Banner *m_banner;
};

} // namespace driftbench

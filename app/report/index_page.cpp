#include "app/report/index_page.h"

#include "engine/base/axes.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <algorithm>

namespace driftbench {

static QString escaped(const std::string &text)
{
    return QString::fromStdString(text).toHtmlEscaped();
}

static QString styleSheet(const Palette &look)
{
    return QStringLiteral(
               "body{margin:0 auto;max-width:1080px;padding:16px;background:%1;color:%2;"
               "font:10pt/1.5 'Open Sans','DejaVu Sans',sans-serif}"
               "h1{font-size:15pt;font-weight:600;margin:0}h2{font-size:12pt;font-weight:600;margin:24px 0 "
               "8px}"
               "p{margin:4px 0}.muted,figcaption,th{color:%3;font-size:9pt}"
               ".chip{border:1px solid %4;border-radius:4px;padding:1px 8px;font-size:9pt;margin-left:12px}"
               ".cards{display:flex;gap:16px}.card,figure,table{background:%5;border:1px solid %4;"
               "border-radius:4px}.card{flex:1;padding:8px 12px;border-top-width:4px}.card b{font-size:12pt}"
               "figure{margin:8px 0 16px;padding:8px 12px}figure img{width:100%;height:auto}"
               "table{border-collapse:collapse;width:100%}th,td{padding:2px 8px;text-align:right;"
               "border-bottom:1px solid %6;font-weight:400}th:first-child,td:first-child,th:nth-child(2),"
               "td:nth-child(2){text-align:left}a{color:%7}")
        .arg(look.page.name(), look.text.name(), look.mutedText.name(), look.border.name(), look.base.name(),
             look.grid.name(), look.accent.name());
}

static QString verdictWord(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Yes:
        return QStringLiteral("Yes");
    case Verdict::WithCare:
        return QStringLiteral("With care");
    case Verdict::NotRepeatable:
        return QStringLiteral("No: not repeatable");
    case Verdict::NoDrift:
        return QStringLiteral("No drift");
    }
    return {};
}

static QColor verdictColor(Verdict verdict, const Palette &look)
{
    switch (verdict) {
    case Verdict::Yes:
        return look.good;
    case Verdict::WithCare:
        return look.caution;
    case Verdict::NotRepeatable:
        return look.bad;
    case Verdict::NoDrift:
        return look.mutedText;
    }
    return look.text;
}

static QString verdictCards(const ReportData &data, const Palette &look)
{
    QString html = QStringLiteral("<h2>May this drift be compensated?</h2><div class=\"cards\">");
    for (std::size_t axis = 0; axis < data.verdicts.size(); ++axis) {
        const AxisVerdict &verdict = data.verdicts[axis];
        const QString color = verdictColor(verdict.verdict, look).name();
        html += QStringLiteral("<div class=\"card\" style=\"border-top-color:%1\"><b>%2</b> "
                               "<b style=\"color:%1\">%3</b><p>%4</p><p class=\"muted\">Model: %5</p></div>")
                    .arg(color, QString::fromUtf8(kAxisNames[axis].data()), verdictWord(verdict.verdict),
                         escaped(verdict.reason), modelLabel(verdict.model).toHtmlEscaped());
    }
    return html + QStringLiteral("</div>");
}

static std::vector<std::string> modelsIn(const std::vector<ComparisonRow> &rows)
{
    std::vector<std::string> models;
    for (const ComparisonRow &row : rows) {
        if (std::find(models.begin(), models.end(), row.model) == models.end())
            models.push_back(row.model);
    }
    return models;
}

// One line for each run and axis, one column for each model.
static QString comparisonTable(const std::vector<ComparisonRow> &rows)
{
    if (rows.empty())
        return {};
    const auto models = modelsIn(rows);
    QString html =
        QStringLiteral("<h2>Mean square of what is left (MSD, dps²), on runs held out</h2><table><tr>"
                       "<th>Run</th><th>Axis</th><th>before</th>");
    for (const std::string &model : models)
        html += QStringLiteral("<th>%1</th>").arg(modelLabel(model).toHtmlEscaped());
    html += QStringLiteral("<th>noise floor</th></tr>");
    std::vector<std::pair<std::string, int>> done;
    for (const ComparisonRow &first : rows) {
        const std::pair key(first.run, first.axis);
        if (std::find(done.begin(), done.end(), key) != done.end())
            continue;
        done.push_back(key);
        const QString axis = first.axis >= 0 && first.axis < kAxisCount
                                 ? QString::fromUtf8(kAxisNames[static_cast<std::size_t>(first.axis)].data())
                                 : QString();
        html += QStringLiteral("<tr><td>%1</td><td>%2</td><td>%3</td>")
                    .arg(escaped(first.run), axis, numberText(first.msdBefore, 4));
        for (const std::string &model : models) {
            const auto found = std::find_if(rows.begin(), rows.end(), [&](const ComparisonRow &row) {
                return row.run == first.run && row.axis == first.axis && row.model == model;
            });
            html += QStringLiteral("<td>%1</td>")
                        .arg(found == rows.end() ? QString() : numberText(found->msdAfter, 4));
        }
        html += QStringLiteral("<td>%1</td></tr>").arg(numberText(first.noiseFloor, 4));
    }
    return html + QStringLiteral("</table>");
}

QString figureBlock(const WrittenFigure &figure)
{
    const QString stem = QString::fromStdString(figure.stem).toHtmlEscaped();
    const QString title = figure.title.toHtmlEscaped();
    return QStringLiteral("<figure><p><b>%1</b></p><img src=\"%2.svg\" alt=\"%1\"><figcaption>%3 "
                          "<a href=\"%2.svg\">SVG</a> · <a href=\"%2.pdf\">PDF</a> · "
                          "<a href=\"%2.png\">PNG</a></figcaption></figure>\n")
        .arg(title, stem, figure.caption.toHtmlEscaped());
}

QString pageStart(const QString &title, const Palette &look)
{
    return QStringLiteral("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                          "<title>%1</title><style>%2</style></head><body>\n")
        .arg(title, styleSheet(look));
}

QString indexPage(const ReportData &data, const std::vector<WrittenFigure> &figures, const Palette &look)
{
    const QString origin = data.simulated ? QStringLiteral("Simulated data") : QStringLiteral("Real log");
    const QString sensor = data.sensor.empty() ? QStringLiteral("unknown sensor") : escaped(data.sensor);
    QString html = pageStart(QStringLiteral("Temperature drift, %1").arg(sensor), look);
    html += QStringLiteral("<h1>Temperature drift, %1<span class=\"chip\">%2</span></h1>"
                           "<p class=\"muted\">%3 runs · judged %4 · reference temperature %5 °C</p>\n")
                .arg(sensor, origin)
                .arg(data.runs.size())
                .arg(escaped(data.judging), numberText(data.referenceTemperatureC, 2));
    html += verdictCards(data, look);
    for (const std::string &warning : data.warnings)
        html += QStringLiteral("<p class=\"muted\">%1</p>").arg(escaped(warning));
    html += QStringLiteral("<h2>Figures</h2>\n");
    for (const WrittenFigure &figure : figures)
        html += figureBlock(figure);
    html += comparisonTable(data.rows);
    return html + QStringLiteral("</body></html>\n");
}

} // namespace driftbench

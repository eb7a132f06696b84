<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>SimulatedTour</name>
    <message>
        <source>Choose where the samples come from.</source>
        <translation>Wählen, woher die Abtastwerte kommen.</translation>
    </message>
    <message>
        <source>The simulated bridge runs the firmware of a real one over a simulated gyro in a chamber. Next uses it.</source>
        <translation>Die simulierte Bridge führt die Firmware einer echten über einem simulierten Gyro in einer Kammer aus. „Weiter“ verwendet sie.</translation>
    </message>
    <message>
        <source>Plan how the temperature moves.</source>
        <translation>Planen, wie sich die Temperatur bewegt.</translation>
    </message>
    <message>
        <source>From −40 to 85 °C in steps that the datasheets allow. The tour takes three runs instead of five; each is judged by a model of the others.</source>
        <translation>Von −40 bis 85 °C in Schritten, die die Datenblätter erlauben. Die Tour macht drei statt fünf Läufe; jeder wird von einem Modell der anderen bewertet.</translation>
    </message>
    <message>
        <source>Record the runs.</source>
        <translation>Die Läufe aufzeichnen.</translation>
    </message>
    <message>
        <source>Three hours pass in about twelve seconds. Everything is in the session&apos;s file as it comes.</source>
        <translation>Drei Stunden vergehen in etwa zwölf Sekunden. Alles steht sofort in der Datei der Sitzung.</translation>
    </message>
    <message>
        <source>Recording run %1 of %2.</source>
        <translation>Lauf %1 von %2 wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>Look at the drift.</source>
        <translation>Die Drift ansehen.</translation>
    </message>
    <message>
        <source>Train the models.</source>
        <translation>Die Modelle trainieren.</translation>
    </message>
    <message>
        <source>An RBF network and its rivals. Each run is held out once, so that no model is judged on what it has seen.</source>
        <translation>Ein RBF-Netz und seine Konkurrenten. Jeder Lauf wird einmal zurückgehalten, damit kein Modell an Bekanntem bewertet wird.</translation>
    </message>
    <message>
        <source>Read the verdict.</source>
        <translation>Das Urteil lesen.</translation>
    </message>
    <message>
        <source>For each axis: write the table, only a constant, or nothing, with the reason.</source>
        <translation>Für jede Achse: die Tabelle schreiben, nur eine Konstante oder nichts, mit Begründung.</translation>
    </message>
    <message>
        <source>Write the table into the device.</source>
        <translation>Die Tabelle in das Gerät schreiben.</translation>
    </message>
    <message>
        <source>Written to the spare bank, read back, verified, and only then made active. Cut off anywhere, the old table stays.</source>
        <translation>In die Reservebank geschrieben, rückgelesen, verifiziert und erst dann aktiviert. Bei Abbruch an beliebiger Stelle bleibt die alte Tabelle.</translation>
    </message>
    <message>
        <source>That did not work; the page says why. Try again, or skip it.</source>
        <translation>Das ging nicht; die Seite sagt, warum. Wiederholen oder überspringen.</translation>
    </message>
    <message>
        <source>No bridge is chosen; choose the simulated one on the Source page.</source>
        <translation>Keine Bridge gewählt; auf der Seite Quelle die simulierte wählen.</translation>
    </message>
    <message>
        <source>The training ended without a model. Try again, or skip it.</source>
        <translation>Das Training endete ohne Modell. Wiederholen oder überspringen.</translation>
    </message>
    <message>
        <source>There is no model to write; go back to Train, or end the tour.</source>
        <translation>Kein Modell zum Schreiben; zurück zu Trainieren oder die Tour beenden.</translation>
    </message>
    <message>
        <source>The device computed something else with the new table and has its old one again. Try again, or skip it.</source>
        <translation>Das Gerät rechnete mit der neuen Tabelle anders und hat wieder die alte. Wiederholen oder überspringen.</translation>
    </message>
    <message>
        <source>The bridge was unplugged. Plug it in and try again, or stop the run and end the tour.</source>
        <translation>Die Bridge wurde abgezogen. Einstecken und wiederholen, oder den Lauf stoppen und die Tour beenden.</translation>
    </message>
    <message>
        <source>Each sample&apos;s error against temperature. Where they lie on one curve, a table can remove it.</source>
        <translation>Der Fehler jedes Abtastwerts über der Temperatur. Was auf einer Kurve liegt, kann eine Tabelle beseitigen.</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Trainieren</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Choose one</source>
        <translation>Eine wählen</translation>
    </message>
    <message>
        <source>Temperature steps</source>
        <translation>Temperaturschritte</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>Live-Kurven</translation>
    </message>
    <message>
        <source>Look at the drift</source>
        <translation>Drift ansehen</translation>
    </message>
    <message>
        <source>Fit models</source>
        <translation>Modelle anpassen</translation>
    </message>
    <message>
        <source>Judge the fit</source>
        <translation>Anpassung bewerten</translation>
    </message>
    <message>
        <source>Write the table</source>
        <translation>Tabelle schreiben</translation>
    </message>
</context>
<context>
    <name>driftbench::AllanView</name>
    <message>
        <source>Allan deviation before and after compensation</source>
        <translation>Allan-Abweichung vor und nach der Kompensation</translation>
    </message>
    <message>
        <source>No Allan deviation</source>
        <translation>Keine Allan-Abweichung</translation>
    </message>
    <message>
        <source>It needs a stretch of nine samples or more without a gap.</source>
        <translation>Nötig ist ein lückenloser Abschnitt von mindestens neun Abtastwerten.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>Nachher, %1</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>Mittelungszeit τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>Minimum %1 vorher, %2 dps nachher</translation>
    </message>
</context>
<context>
    <name>driftbench::Banner</name>
    <message>
        <source>Line to copy</source>
        <translation>Zeile zum Kopieren</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>driftbench::BeforeAfterView</name>
    <message>
        <source>Rates before and after compensation</source>
        <translation>Drehraten vor und nach der Kompensation</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>Drehrate %1 (dps)</translation>
    </message>
    <message>
        <source>%1 dps rms raw</source>
        <translation>%1 dps RMS roh</translation>
    </message>
    <message>
        <source>%1 dps rms comp.</source>
        <translation>%1 dps RMS komp.</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Nothing to compare yet</source>
        <translation>Noch nichts zu vergleichen</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>Ein Modell trainieren und einen Lauf wählen, den es nicht kennt.</translation>
    </message>
    <message>
        <source>Raw, mean and range</source>
        <translation>Roh, Mittel und Spanne</translation>
    </message>
    <message>
        <source>Compensated, %1</source>
        <translation>Kompensiert, %1</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>Zeit seit Start</translation>
    </message>
</context>
<context>
    <name>driftbench::BridgeModel</name>
    <message>
        <source>Simulated bridge</source>
        <translation>Simulierte Bridge</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>Gyro-Bridge</translation>
    </message>
    <message>
        <source>%1, USB to I2C</source>
        <translation>%1, USB zu I2C</translation>
    </message>
    <message>
        <source>inside this program</source>
        <translation>in diesem Programm</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Streaming</source>
        <translation>Sendet</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>In use here</source>
        <translation>Hier belegt</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Not permitted</source>
        <translation>Keine Rechte</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Belegt</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>Abgezogen</translation>
    </message>
    <message>
        <source>No gyro answers</source>
        <translation>Kein Gyro antwortet</translation>
    </message>
    <message>
        <source>Bus stuck</source>
        <translation>Bus blockiert</translation>
    </message>
    <message>
        <source>Other version</source>
        <translation>Andere Version</translation>
    </message>
    <message>
        <source>Unknown gyro</source>
        <translation>Gyro unbekannt</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>Nicht nutzbar</translation>
    </message>
    <message>
        <source>start here if you have no hardware</source>
        <translation>Einstieg ohne Hardware</translation>
    </message>
</context>
<context>
    <name>driftbench::CentresView</name>
    <message>
        <source>Number of centres</source>
        <translation>Anzahl der Zentren</translation>
    </message>
    <message>
        <source>RBF training</source>
        <translation>RBF Training</translation>
    </message>
    <message>
        <source>RBF held out</source>
        <translation>RBF zurückgehalten</translation>
    </message>
    <message>
        <source>%1 chosen</source>
        <translation>%1 gewählt</translation>
    </message>
    <message>
        <source>RBF, temperature blocks left out</source>
        <translation>RBF, Temperaturblöcke ausgelassen</translation>
    </message>
    <message>
        <source>RBF held out, mean of %1</source>
        <translation>RBF zurückgehalten, Mittel aus %1</translation>
    </message>
    <message>
        <source>RBF held out, mean</source>
        <translation>RBF zurückgehalten, Mittel</translation>
    </message>
    <message>
        <source>Excess over the noise floor</source>
        <translation>Überschuss über dem Grundrauschen</translation>
    </message>
    <message>
        <source>lowest to highest run</source>
        <translation>kleinster bis größter Lauf</translation>
    </message>
    <message>
        <source>lowest to highest block</source>
        <translation>kleinster bis größter Block</translation>
    </message>
    <message>
        <source>Chosen number</source>
        <translation>Gewählte Anzahl</translation>
    </message>
    <message>
        <source>Excess MSD (%)</source>
        <translation>MSD-Überschuss (%)</translation>
    </message>
    <message>
        <source>Excess over the noise floor against the number of centres</source>
        <translation>Überschuss über dem Grundrauschen, nach Anzahl der Zentren</translation>
    </message>
    <message>
        <source>The curve, its centres and their widths</source>
        <translation>Die Kurve, ihre Zentren und deren Breiten</translation>
    </message>
    <message>
        <source>Centres of the RBF network</source>
        <translation>Zentren des RBF-Netzes</translation>
    </message>
    <message>
        <source>The curve, less its straight line</source>
        <translation>Die Kurve ohne ihren Geradenanteil</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>RBF-Netz</translation>
    </message>
    <message>
        <source>Means of 1 °C</source>
        <translation>Mittel über 1 °C</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Zentrum</translation>
    </message>
    <message>
        <source>Width, ±1 σ</source>
        <translation>Breite, ±1 σ</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>TDE less line (dps)</source>
        <translation>TDE ohne Gerade (dps)</translation>
    </message>
    <message>
        <source>No RBF network yet</source>
        <translation>Noch kein RBF-Netz</translation>
    </message>
    <message>
        <source>Train one to see how many centres it needs.</source>
        <translation>Eines trainieren, um zu sehen, wie viele Zentren nötig sind.</translation>
    </message>
    <message>
        <source>No choice was made</source>
        <translation>Keine Auswahl erfolgt</translation>
    </message>
    <message>
        <source>The number of centres was given, so none was tried.</source>
        <translation>Die Anzahl der Zentren war vorgegeben, andere wurden nicht probiert.</translation>
    </message>
</context>
<context>
    <name>driftbench::CoachStrip</name>
    <message>
        <source>Guided tour</source>
        <translation>Geführte Tour</translation>
    </message>
    <message>
        <source>Guided tour, %1 of %2</source>
        <translation>Geführte Tour, %1 von %2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>Tour beenden</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparePage</name>
    <message>
        <source>Held-out run</source>
        <translation>Zurückgehaltener Lauf</translation>
    </message>
    <message>
        <source>Comparison of the models on the held-out run</source>
        <translation>Vergleich der Modelle auf dem zurückgehaltenen Lauf</translation>
    </message>
    <message>
        <source>Limit of what may be left, rms</source>
        <translation>Grenzwert für den Rest, RMS</translation>
    </message>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>Fortschritt des Berichts</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML, one file (*.html)</source>
        <translation>HTML, eine Datei (*.html)</translation>
    </message>
    <message>
        <source>There is nothing to report yet.</source>
        <translation>Noch gibt es nichts zu berichten.</translation>
    </message>
    <message>
        <source>Train a model first; its runs must be readable.</source>
        <translation>Zuerst ein Modell trainieren; seine Läufe müssen lesbar sein.</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>Bericht geschrieben: %1.</translation>
    </message>
    <message>
        <source>The report is written.</source>
        <translation>Der Bericht ist geschrieben.</translation>
    </message>
    <message>
        <source>The report was not written.</source>
        <translation>Der Bericht wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>Models against a constant, on runs they have not seen</source>
        <translation>Modelle gegen eine Konstante, auf Läufen, die sie nicht kennen</translation>
    </message>
    <message>
        <source>%1 against a constant, on runs it has not seen</source>
        <translation>%1 gegen Konstante, auf neuen Läufen</translation>
    </message>
    <message>
        <source>The models are trained and judged on runs held out.</source>
        <translation>Die Modelle werden trainiert und auf zurückgehaltenen Läufen bewertet.</translation>
    </message>
    <message>
        <source>Nothing to judge</source>
        <translation>Nichts zu bewerten</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>Zuerst ein Modell trainieren.</translation>
    </message>
    <message>
        <source>%1 of 3 axes: yes</source>
        <translation>%1 von 3 Achsen: ja</translation>
    </message>
    <message>
        <source>1, 2, 3 choose the held-out run · Wheel zoom · Drag pan · Double-click fit · Ctrl+E export what is visible</source>
        <translation>1, 2, 3 zurückgehaltenen Lauf wählen · Mausrad zoomen · Ziehen verschieben · Doppelklick einpassen · Strg+E Sichtbares exportieren</translation>
    </message>
    <message numerus="yes">
        <source>%n held-out run(s)</source>
        <translation>
            <numerusform>%n zurückgehaltener Lauf</numerusform>
            <numerusform>%n zurückgehaltene Läufe</numerusform>
        </translation>
    </message>
    <message>
        <source>Judged: anchored</source>
        <translation>Bewertung: verankert</translation>
    </message>
    <message>
        <source>Judged: absolute</source>
        <translation>Bewertung: absolut</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>What may be left on a held-out run, rms. Zero: no limit.</source>
        <translation>Was auf einem zurückgehaltenen Lauf übrig bleiben darf, RMS. Null: kein Grenzwert.</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolut</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>Verankert</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Everything found as PDF or as one HTML file</source>
        <translation>Alle Ergebnisse als PDF oder als eine HTML-Datei</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Trainieren</translation>
    </message>
    <message>
        <source>Held-out run %1</source>
        <translation>Zurückgehaltener Lauf %1</translation>
    </message>
    <message>
        <source>The report was cancelled.</source>
        <translation>Der Bericht wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparisonTableModel</name>
    <message>
        <source>Pass</source>
        <translation>Erfüllt</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Verfehlt</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>MSD1
before</source>
        <translation>MSD1
vorher</translation>
    </message>
    <message>
        <source>MSD4
Conv. 1</source>
        <translation>MSD4
Konv. 1</translation>
    </message>
    <message>
        <source>MSD5
Conv. 2</source>
        <translation>MSD5
Konv. 2</translation>
    </message>
    <message>
        <source>MSD6
Novel</source>
        <translation>MSD6
Neu</translation>
    </message>
    <message>
        <source>Q3
Conv. 1</source>
        <translation>Q3
Konv. 1</translation>
    </message>
    <message>
        <source>Q4
Conv. 2</source>
        <translation>Q4
Konv. 2</translation>
    </message>
    <message>
        <source>Q5
Novel</source>
        <translation>Q5
Neu</translation>
    </message>
    <message>
        <source>Q4 − Q3
% of Q3</source>
        <translation>Q4 − Q3
% von Q3</translation>
    </message>
    <message>
        <source>Q5 − Q3
% of Q3</source>
        <translation>Q5 − Q3
% von Q3</translation>
    </message>
    <message>
        <source>Q5 − Q4
% of Q4</source>
        <translation>Q5 − Q4
% von Q4</translation>
    </message>
    <message>
        <source>MSD
cubic</source>
        <translation>MSD
kubisch</translation>
    </message>
    <message>
        <source>MSD
constant</source>
        <translation>MSD
Konstante</translation>
    </message>
    <message>
        <source>MSD
floor</source>
        <translation>MSD
Rauschen</translation>
    </message>
    <message>
        <source>Left
dps rms</source>
        <translation>Rest
dps RMS</translation>
    </message>
    <message>
        <source>Limit
%1</source>
        <translation>Grenzwert
%1</translation>
    </message>
    <message>
        <source>Limit
none</source>
        <translation>Grenzwert
keiner</translation>
    </message>
</context>
<context>
    <name>driftbench::CoverageView</name>
    <message>
        <source>Coverage of the temperature range</source>
        <translation>Abdeckung des Temperaturbereichs</translation>
    </message>
    <message>
        <source>No coverage yet</source>
        <translation>Noch keine Abdeckung</translation>
    </message>
    <message>
        <source>It shows where the temperature has been.</source>
        <translation>Sie zeigt, welche Temperaturen durchlaufen wurden.</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>s per °C</source>
        <translation>s je °C</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Heizen</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Kühlen</translation>
    </message>
</context>
<context>
    <name>driftbench::CurvePanelsView</name>
    <message>
        <source>No curves</source>
        <translation>Keine Kurven</translation>
    </message>
    <message>
        <source>There is nothing to draw over this range.</source>
        <translation>In diesem Bereich gibt es nichts zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>driftbench::DataTable</name>
    <message>
        <source>Copy selected cells</source>
        <translation>Ausgewählte Zellen kopieren</translation>
    </message>
    <message>
        <source>Copy table as text</source>
        <translation>Tabelle als Text kopieren</translation>
    </message>
    <message>
        <source>Copy table as CSV</source>
        <translation>Tabelle als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy table as Markdown</source>
        <translation>Tabelle als Markdown kopieren</translation>
    </message>
    <message>
        <source>Copy table as LaTeX</source>
        <translation>Tabelle als LaTeX kopieren</translation>
    </message>
</context>
<context>
    <name>driftbench::DevicePanel</name>
    <message>
        <source>On the device now against what would be written</source>
        <translation>Jetzt auf dem Gerät, verglichen mit dem, was geschrieben würde</translation>
    </message>
    <message>
        <source>%1 of %2 B</source>
        <translation>%1 von %2 B</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Activating and checking</source>
        <translation>Aktivieren und prüfen</translation>
    </message>
    <message>
        <source>Writing the spare bank</source>
        <translation>Reservebank wird geschrieben</translation>
    </message>
    <message>
        <source>The table in use stays active until the last step.</source>
        <translation>Die benutzte Tabelle bleibt bis zum letzten Schritt aktiv.</translation>
    </message>
    <message>
        <source>Write to the device</source>
        <translation>Auf das Gerät schreiben</translation>
    </message>
    <message>
        <source>Read back and verified. This device can&apos;t show its compensation at work.</source>
        <translation>Rückgelesen und verifiziert. Dieses Gerät kann seine Kompensation nicht im Betrieb zeigen.</translation>
    </message>
    <message>
        <source>Rolled back: %1 of %2 samples differ from what the host computes, by up to %3 dps.</source>
        <translation>Zurückgenommen: %1 von %2 Abtastwerten weichen von der Rechnung des Hosts ab, um bis zu %3 dps.</translation>
    </message>
    <message numerus="yes">
        <source>Verified at work: %n sample(s) compared with what the host computes, none differs.</source>
        <translation>
            <numerusform>Im Betrieb verifiziert: %n Abtastwert mit der Rechnung des Hosts verglichen, keine Abweichung.</numerusform>
            <numerusform>Im Betrieb verifiziert: %n Abtastwerte mit der Rechnung des Hosts verglichen, keine Abweichung.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Not written</source>
        <translation>Nicht geschrieben</translation>
    </message>
    <message>
        <source>The upload was cancelled.</source>
        <translation>Das Hochladen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The table was not written.</source>
        <translation>Die Tabelle wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>gen. %1</source>
        <translation>Gen. %1</translation>
    </message>
    <message>
        <source>bank %1</source>
        <translation>Bank %1</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>Bank %1 is in use</source>
        <translation>Bank %1 ist in Benutzung</translation>
    </message>
    <message>
        <source>The new table was rolled back.</source>
        <translation>Die neue Tabelle wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>The table is on the device.</source>
        <translation>Die Tabelle ist auf dem Gerät.</translation>
    </message>
    <message>
        <source>The table before was not restored.</source>
        <translation>Die vorherige Tabelle wurde nicht wiederhergestellt.</translation>
    </message>
    <message>
        <source>Bank %1, generation %2, is in use again.</source>
        <translation>Bank %1, Generation %2, ist wieder in Benutzung.</translation>
    </message>
    <message>
        <source>No table is in use any more; the device sends raw rates.</source>
        <translation>Keine Tabelle ist mehr in Benutzung; das Gerät sendet rohe Drehraten.</translation>
    </message>
    <message>
        <source>The table was taken out of use.</source>
        <translation>Die Tabelle wurde außer Benutzung genommen.</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
    <message>
        <source>fixed point</source>
        <translation>Festkomma</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>on the die</source>
        <translation>auf dem Chip</translation>
    </message>
    <message>
        <source>external</source>
        <translation>extern</translation>
    </message>
    <message>
        <source>Bank, generation</source>
        <translation>Bank, Generation</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Range, rows</source>
        <translation>Bereich, Zeilen</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>CRC-32</source>
        <translation>CRC-32</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, active</source>
        <translation>%1, %2, aktiv</translation>
    </message>
    <message>
        <source>no image: see Files</source>
        <translation>kein Abbild: siehe Dateien</translation>
    </message>
    <message>
        <source>On the device now</source>
        <translation>Jetzt auf dem Gerät</translation>
    </message>
    <message>
        <source>Would be written</source>
        <translation>Würde geschrieben</translation>
    </message>
    <message>
        <source>Device %1</source>
        <translation>Gerät %1</translation>
    </message>
    <message>
        <source>%1, firmware %2, simulated</source>
        <translation>%1, Firmware %2, simuliert</translation>
    </message>
    <message>
        <source>%1, firmware %2</source>
        <translation>%1, Firmware %2</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>No device chosen</source>
        <translation>Kein Gerät gewählt</translation>
    </message>
    <message>
        <source>Choose the simulated bridge or a plugged-in one as source.</source>
        <translation>Die simulierte oder eine eingesteckte Bridge als Quelle wählen.</translation>
    </message>
    <message>
        <source>No tables there</source>
        <translation>Dort keine Tabellen</translation>
    </message>
    <message>
        <source>Looking at the device</source>
        <translation>Gerät wird abgefragt</translation>
    </message>
    <message>
        <source>Bank %1 active</source>
        <translation>Bank %1 aktiv</translation>
    </message>
    <message>
        <source>No table active</source>
        <translation>Keine Tabelle aktiv</translation>
    </message>
    <message>
        <source>%1, the spare bank being written</source>
        <translation>%1, Reservebank wird geschrieben</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Activation not confirmed</source>
        <translation>Aktivierung nicht bestätigt</translation>
    </message>
    <message>
        <source>Look at the device to see which table is in use.</source>
        <translation>Am Gerät nachsehen, welche Tabelle benutzt wird.</translation>
    </message>
    <message>
        <source>The table that was in use still is.</source>
        <translation>Die bisherige Tabelle wird weiter benutzt.</translation>
    </message>
    <message>
        <source>The activation was not confirmed.</source>
        <translation>Die Aktivierung wurde nicht bestätigt.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>empfohlen</translation>
    </message>
    <message>
        <source>%1 to %2 °C, %3</source>
        <translation>%1 bis %2 °C, %3</translation>
    </message>
</context>
<context>
    <name>driftbench::DurationField</name>
    <message>
        <source>h:min:s</source>
        <translation>h:min:s</translation>
    </message>
</context>
<context>
    <name>driftbench::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ereignis</translation>
    </message>
</context>
<context>
    <name>driftbench::ExcludedModel</name>
    <message>
        <source>non-finite</source>
        <translation>nicht endlich</translation>
    </message>
    <message>
        <source>bad time</source>
        <translation>Zeitfehler</translation>
    </message>
    <message>
        <source>start-up</source>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>übersteuert</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>temperature fault</source>
        <translation>Temperaturfehler</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Time (%1)</source>
        <translation>Zeit (%1)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Grund</translation>
    </message>
</context>
<context>
    <name>driftbench::ExclusionStrip</name>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>Drift error over time</source>
        <translation>Driftfehler über der Zeit</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>Keine Abtastwerte</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Einen Lauf aufzeichnen oder eine Logdatei öffnen.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Ausgeschlossen</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Heizen</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Kühlen</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Ausgewählt</translation>
    </message>
</context>
<context>
    <name>driftbench::ExportPage</name>
    <message>
        <source>Table preview</source>
        <translation>Tabellenvorschau</translation>
    </message>
    <message>
        <source>Recommended of each axis</source>
        <translation>Je Achse das Empfohlene</translation>
    </message>
    <message>
        <source>There is no table to write.</source>
        <translation>Es gibt keine Tabelle zum Schreiben.</translation>
    </message>
    <message>
        <source>The table for the device</source>
        <translation>Die Tabelle für das Gerät</translation>
    </message>
    <message>
        <source>Into the spare bank; the one in use stays until the end</source>
        <translation>In die Reservebank; die benutzte bleibt bis zum Schluss</translation>
    </message>
    <message>
        <source>There is no table to write</source>
        <translation>Es gibt keine Tabelle zum Schreiben</translation>
    </message>
    <message>
        <source>A table is being written</source>
        <translation>Eine Tabelle wird gerade geschrieben</translation>
    </message>
    <message>
        <source>No device with tables is there</source>
        <translation>Kein Gerät mit Tabellen vorhanden</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>Ordner für die Dateien</translation>
    </message>
    <message>
        <source>The files were not written.</source>
        <translation>Die Dateien wurden nicht geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1.</source>
        <translation>
            <numerusform>%n Datei nach %1 geschrieben.</numerusform>
            <numerusform>%n Dateien nach %1 geschrieben.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written.</source>
        <translation>
            <numerusform>%n Datei geschrieben.</numerusform>
            <numerusform>%n Dateien geschrieben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing, %1 %</source>
        <translation>Schreiben, %1 %</translation>
    </message>
    <message>
        <source>Table on %1</source>
        <translation>Auf %1</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written</source>
        <translation>
            <numerusform>%n Datei geschrieben</numerusform>
            <numerusform>%n Dateien geschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing written</source>
        <translation>Nichts geschrieben</translation>
    </message>
    <message>
        <source>Esc cancel, the old table stays · Ctrl+S save the files</source>
        <translation>Esc abbrechen, die alte Tabelle bleibt · Strg+S Dateien speichern</translation>
    </message>
    <message>
        <source>Ctrl+S save the files · Ctrl+U write to the device · F5 look again · Ctrl+C copy the selected cells</source>
        <translation>Strg+S Dateien speichern · Strg+U auf das Gerät schreiben · F5 erneut suchen · Strg+C ausgewählte Zellen kopieren</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Write to device</source>
        <translation>Auf Gerät schreiben</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Takes the table out of use; the one before it takes over</source>
        <translation>Nimmt die Tabelle außer Benutzung; die vorherige tritt an ihre Stelle</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>Quelle wählen</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Trainieren</translation>
    </message>
    <message>
        <source>No model yet</source>
        <translation>Noch kein Modell</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>Zuerst ein Modell trainieren.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Shown form</source>
        <translation>Gezeigte Form</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Vorschau der Datei</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>C header</source>
        <translation>C-Header</translation>
    </message>
    <message>
        <source>PX4</source>
        <translation>PX4</translation>
    </message>
    <message>
        <source>ArduPilot</source>
        <translation>ArduPilot</translation>
    </message>
    <message>
        <source>Device image</source>
        <translation>Geräteabbild</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>int32, 1 LSB = 2%1 dps = %2 µdps</source>
        <translation>int32, 1 LSB = 2%1 dps = %2 µdps</translation>
    </message>
    <message>
        <source>Table of %1 rows, %2 °C apart.</source>
        <translation>%1 Zeilen, Abstand %2 °C</translation>
    </message>
    <message>
        <source>Axes without a yes are written too.</source>
        <translation>Auch Achsen ohne Ja werden geschrieben.</translation>
    </message>
    <message>
        <source>Compare says what that costs on runs held out.</source>
        <translation>Was das auf zurückgehaltenen Läufen kostet, steht unter Vergleichen.</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>Keine Tabelle für %1.</translation>
    </message>
    <message>
        <source>It does not help on runs held out; Compare has the figures. Its values are zero.</source>
        <translation>Sie hilft auf zurückgehaltenen Läufen nicht; die Zahlen stehen unter Vergleichen. In der Tabelle stehen dafür Nullen.</translation>
    </message>
</context>
<context>
    <name>driftbench::FileChoices</name>
    <message>
        <source>Largest interpolation error</source>
        <translation>Größter Interpolationsfehler</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>cubic, loses nothing</source>
        <translation>kubisch, verlustfrei</translation>
    </message>
    <message>
        <source>cubic only: up to %1 mdps off on %2, %3 rms</source>
        <translation>nur kubisch: %2 bis %1 mdps daneben, %3 RMS</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>%1 von %2 gewählt</translation>
    </message>
    <message numerus="yes">
        <source>table, %n row(s)</source>
        <translation>
            <numerusform>Tabelle, %n Zeile</numerusform>
            <numerusform>Tabelle, %n Zeilen</numerusform>
        </translation>
    </message>
    <message>
        <source>table in both kinds and where it comes from, exact</source>
        <translation>Tabelle in beiden Arten samt Herkunft, exakt</translation>
    </message>
    <message>
        <source>float and fixed point, %1 bytes</source>
        <translation>Gleit- und Festkomma, %1 Byte</translation>
    </message>
    <message>
        <source>one bank, %1 bytes</source>
        <translation>eine Bank, %1 Byte</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>C header</source>
        <translation>C-Header</translation>
    </message>
    <message>
        <source>PX4 .params</source>
        <translation>PX4 .params</translation>
    </message>
    <message>
        <source>ArduPilot .parm</source>
        <translation>ArduPilot .parm</translation>
    </message>
    <message>
        <source>Device image</source>
        <translation>Geräteabbild</translation>
    </message>
    <message>
        <source>Also axes without a yes</source>
        <translation>Auch Achsen ohne Ja</translation>
    </message>
    <message>
        <source>Axes whose verdict is not yes are left out unless this is on; the files say so.</source>
        <translation>Achsen, deren Urteil nicht „Ja“ lautet, werden ohne diese Option ausgelassen; die Dateien vermerken es.</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>PX4 device id</source>
        <translation>PX4-Geräte-ID</translation>
    </message>
    <message>
        <source>By which PX4 knows the gyro again: its parameter TC_G0_ID. Empty: the serial number.</source>
        <translation>Daran erkennt PX4 den Gyro wieder: sein Parameter TC_G0_ID. Leer: die Seriennummer.</translation>
    </message>
    <message>
        <source>needs the gyro&apos;s device id, below</source>
        <translation>braucht die Geräte-ID des Gyros, unten</translation>
    </message>
    <message>
        <source>needs the sensor&apos;s name: state it when you open the log</source>
        <translation>braucht den Sensor: beim Öffnen des Logs angeben</translation>
    </message>
</context>
<context>
    <name>driftbench::FileSurvey</name>
    <message>
        <source>Span too small to fit</source>
        <translation>Spanne zu klein zum Anpassen</translation>
    </message>
    <message>
        <source>Temperature stands still</source>
        <translation>Temperatur steht still</translation>
    </message>
    <message>
        <source>Too short to fit</source>
        <translation>Zu kurz zum Anpassen</translation>
    </message>
    <message>
        <source>Can&apos;t be used as it is</source>
        <translation>So nicht verwendbar</translation>
    </message>
    <message>
        <source>No drift found</source>
        <translation>Keine Drift gefunden</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1: Hysterese</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Can&apos;t be opened</source>
        <translation>Nicht zu öffnen</translation>
    </message>
    <message>
        <source>Run %1 to do</source>
        <translation>Lauf %1 steht aus</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>Noch keine Läufe</translation>
    </message>
    <message>
        <source>Ready to train</source>
        <translation>Bereit zum Training</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>Nicht mehr vorhanden</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>Unbekanntes Format</translation>
    </message>
    <message>
        <source>Large: looked at when opened</source>
        <translation>Groß: erst beim Öffnen gesichtet</translation>
    </message>
    <message>
        <source>Can&apos;t be read</source>
        <translation>Nicht lesbar</translation>
    </message>
</context>
<context>
    <name>driftbench::I2cForm</name>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Whichever answers</source>
        <translation>Der antwortende</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>Gyro</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Messbereich</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermometer</translation>
    </message>
    <message>
        <source>Die offset</source>
        <translation>Chip-Offset</translation>
    </message>
    <message>
        <source>Bus speed</source>
        <translation>Bustakt</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>Extern, sonst Chip</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>Auf dem Chip</translation>
    </message>
    <message>
        <source>0 takes the gyro&apos;s usual rate.</source>
        <translation>0 nimmt die übliche Rate des Gyros.</translation>
    </message>
    <message>
        <source>Of the gyro&apos;s own thermometer, which only tells differences.</source>
        <translation>Des gyroeigenen Thermometers, das nur Differenzen angibt.</translation>
    </message>
    <message>
        <source>which gyro it is</source>
        <translation>welcher Gyro es ist</translation>
    </message>
    <message>
        <source>The gyro can&apos;t say it itself; it keeps runs of different gyros apart.</source>
        <translation>Der Gyro kann sie nicht selbst melden; sie hält Läufe verschiedener Gyros auseinander.</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectPage</name>
    <message>
        <source>What is plotted</source>
        <translation>Was dargestellt wird</translation>
    </message>
    <message>
        <source>name the reason</source>
        <translation>Grund angeben</translation>
    </message>
    <message>
        <source>Against TCQ</source>
        <translation>Über TCQ</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über der Zeit</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>exclude %1 s of %2</source>
        <translation>%1 s von %2 ausschließen</translation>
    </message>
    <message>
        <source>include a stretch of %1</source>
        <translation>Abschnitt von %1 einschließen</translation>
    </message>
    <message>
        <source>move an excluded stretch of %1</source>
        <translation>ausgeschlossenen Abschnitt von %1 verschieben</translation>
    </message>
    <message>
        <source>The plan can&apos;t be changed.</source>
        <translation>Der Plan lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>The runs are not read</source>
        <translation>Die Läufe sind nicht eingelesen</translation>
    </message>
    <message>
        <source>Come back to this page to read them again.</source>
        <translation>Zu dieser Seite zurückkehren, um sie erneut zu lesen.</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>Noch keine Läufe</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Einen Lauf aufzeichnen oder eine Logdatei öffnen.</translation>
    </message>
    <message>
        <source>The runs can&apos;t be read.</source>
        <translation>Die Läufe sind nicht lesbar.</translation>
    </message>
    <message>
        <source>Reading the runs</source>
        <translation>Läufe werden gelesen</translation>
    </message>
    <message>
        <source>Fitted curve, ±1 σ of its residuals</source>
        <translation>Ausgleichskurve, ±1 σ ihrer Residuen</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE, %1 (dps)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <translation>%1, Lauf %2</translation>
    </message>
    <message>
        <source>%1, runs %2</source>
        <translation>%1, Läufe %2</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Heizen</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Kühlen</translation>
    </message>
    <message>
        <source>TDE against the temperature quantities</source>
        <translation>TDE über den Temperaturgrößen</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference from the holds</source>
        <translation>TDE von %1 über der Temperatur, Referenz aus den Haltezeiten</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference %2 dps</source>
        <translation>TDE von %1, Referenz %2 dps</translation>
    </message>
    <message>
        <source>heating again</source>
        <translation>erneutes Heizen</translation>
    </message>
    <message>
        <source>heating</source>
        <translation>Heizen</translation>
    </message>
    <message>
        <source>cooling again</source>
        <translation>erneutes Kühlen</translation>
    </message>
    <message>
        <source>cooling</source>
        <translation>Kühlen</translation>
    </message>
    <message>
        <source>%1 dps (%2)</source>
        <translation>%1 dps (%2)</translation>
    </message>
    <message>
        <source>These runs can&apos;t be calibrated as they are.</source>
        <translation>Diese Läufe lassen sich so nicht kalibrieren.</translation>
    </message>
    <message>
        <source>%1 is not a curve of temperature.</source>
        <translation>%1 ist keine Kurve der Temperatur.</translation>
    </message>
    <message>
        <source>No table over temperature can remove this.</source>
        <translation>Keine Tabelle über der Temperatur kann das beseitigen.</translation>
    </message>
    <message>
        <source>At %1 °C it reads %2.</source>
        <translation>Anzeige bei %1 °C: %2.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>Findings of the checks</source>
        <translation>Befunde der Prüfungen</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>Einschließen</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Ausschließen</translation>
    </message>
    <message>
        <source>Drag in the time strip to select a stretch first.</source>
        <translation>Zuerst im Zeitstreifen durch Ziehen einen Abschnitt auswählen.</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Befunde (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>%n Läufe</numerusform>
        </translation>
    </message>
    <message>
        <source>Can&apos;t be calibrated</source>
        <translation>Nicht kalibrierbar</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1: Hysterese</translation>
    </message>
    <message>
        <source>Drag in the time strip to select · Delete exclude · Ctrl+Z undo · X, Y, Z choose the axis · Double-click fit</source>
        <translation>Ziehen im Zeitstreifen auswählen · Entf ausschließen · Strg+Z rückgängig · X, Y, Z Achse wählen · Doppelklick einpassen</translation>
    </message>
    <message>
        <source>%1, %2 samples at %3 Hz</source>
        <translation>%1, %2 Abtastwerte mit %3 Hz</translation>
    </message>
    <message>
        <source>%1 excluded</source>
        <translation>%1 ausgeschlossen</translation>
    </message>
    <message numerus="yes">
        <source>exclude %1 s in %n stretches</source>
        <translation>
            <numerusform>%1 s in %n Abschnitt ausschließen</numerusform>
            <numerusform>%1 s in %n Abschnitten ausschließen</numerusform>
        </translation>
    </message>
    <message>
        <source>Each point is the mean of %1 samples</source>
        <translation>Jeder Punkt ist der Mittelwert von %1 Abtastwerten</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectSide</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Ausgeschlossen</translation>
    </message>
    <message>
        <source>Excluded stretches</source>
        <translation>Ausgeschlossene Abschnitte</translation>
    </message>
    <message>
        <source>Swing of TDE</source>
        <translation>TDE-Hub</translation>
    </message>
    <message>
        <source>Noise within 0.5 °C</source>
        <translation>Rauschen in 0,5 °C</translation>
    </message>
    <message>
        <source>Left by the curve</source>
        <translation>Rest zur Kurve</translation>
    </message>
    <message>
        <source>That is</source>
        <translation>Das sind</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Heated and cooled</source>
        <translation>Geheizt und gekühlt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>A curve of T</source>
        <translation>Eine Kurve von T</translation>
    </message>
    <message>
        <source>Nearly a curve of T</source>
        <translation>Fast eine Kurve von T</translation>
    </message>
    <message>
        <source>Not a curve of T</source>
        <translation>Keine Kurve von T</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>spread at %1 °C</source>
        <translation>Streuung bei %1 °C</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>Hub</translation>
    </message>
    <message>
        <source>%1 in figures</source>
        <translation>%1 in Zahlen</translation>
    </message>
    <message>
        <source>%1 dps rms</source>
        <translation>%1 dps RMS</translation>
    </message>
    <message>
        <source>%1 × the noise</source>
        <translation>%1 × Rauschen</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1 bis %2 °C</translation>
    </message>
    <message>
        <source>%1 % of it</source>
        <translation>%1 % davon</translation>
    </message>
</context>
<context>
    <name>driftbench::IntervalPanel</name>
    <message>
        <source>Smallest rate step, ΔE&lt;sub&gt;S&lt;/sub&gt;</source>
        <translation>Kleinster Drehratenschritt, ΔE&lt;sub&gt;S&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>Bias with T, γ′ = %1 × %2/%3</source>
        <translation>Bias über T, γ′ = %1 × %2/%3</translation>
    </message>
    <message>
        <source>mdps/°C</source>
        <translation>mdps/°C</translation>
    </message>
    <message>
        <source>Sensitivity with T, β</source>
        <translation>Empfindlichkeit über T, β</translation>
    </message>
    <message>
        <source>ΔE&lt;sub&gt;S&lt;/sub&gt; / (γ′ + β)</source>
        <translation>ΔE&lt;sub&gt;S&lt;/sub&gt; / (γ′ + β)</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>used, not above %1</source>
        <translation>verwendet, nicht über %1</translation>
    </message>
    <message>
        <source>used, but above %1</source>
        <translation>verwendet, aber über %1</translation>
    </message>
    <message>
        <source>The paper prints β with the span squared, which gives %1 mdps/°C. Half the span gives the value it uses, %2.</source>
        <translation>Der Artikel druckt β mit dem Quadrat der Spanne, was %1 mdps/°C ergibt. Die halbe Spanne ergibt den dort verwendeten Wert %2.</translation>
    </message>
</context>
<context>
    <name>driftbench::JudgedRunView</name>
    <message>
        <source>Held-out run before and after compensation, and its Allan deviation</source>
        <translation>Zurückgehaltener Lauf vor und nach der Kompensation und seine Allan-Abweichung</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>Nachher, %1</translation>
    </message>
    <message>
        <source>After, %1 trained on %2</source>
        <translation>Nachher, %1 trainiert auf %2</translation>
    </message>
    <message>
        <source>Before, less the constant</source>
        <translation>Vorher, ohne Konstante</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Limit ±%1 dps</source>
        <translation>Grenzwert ±%1 dps</translation>
    </message>
    <message>
        <source>TDE left (dps)</source>
        <translation>TDE-Rest (dps)</translation>
    </message>
    <message>
        <source>Time in run</source>
        <translation>Zeit im Lauf</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>Mittelungszeit τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>Minimum %1 vorher, %2 dps nachher</translation>
    </message>
    <message>
        <source>No run to judge</source>
        <translation>Kein Lauf zu bewerten</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>Ein Modell trainieren und einen Lauf wählen, den es nicht kennt.</translation>
    </message>
</context>
<context>
    <name>driftbench::KnotsTableModel</name>
    <message>
        <source>T
°C</source>
        <translation>T
°C</translation>
    </message>
    <message>
        <source>Worst
mdps</source>
        <translation>Max.
mdps</translation>
    </message>
    <message>
        <source>%1
code</source>
        <translation>%1
Code</translation>
    </message>
    <message>
        <source>%1
dps</source>
        <translation>%1
dps</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveMarks</name>
    <message>
        <source>plateau</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>%1: samples missing, %2</source>
        <translation>%1: Abtastwerte fehlen, %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n samples dropped, %2</source>
        <translation>
            <numerusform>%1: %n Abtastwert verloren, %2</numerusform>
            <numerusform>%1: %n Abtastwerte verloren, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::LiveRun</name>
    <message>
        <source>set the reference rate of the run that is recorded</source>
        <translation>Referenzdrehrate des laufenden Laufs setzen</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveStrips</name>
    <message>
        <source>%1 comp.</source>
        <translation>%1 komp.</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 roh</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveTraceView</name>
    <message>
        <source>Raw, mean and range</source>
        <translation>Roh, Mittel und Spanne</translation>
    </message>
    <message>
        <source>Compensated</source>
        <translation>Kompensiert</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>%1, lowest</source>
        <translation>%1, Minimum</translation>
    </message>
    <message>
        <source>%1, mean</source>
        <translation>%1, Mittel</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <translation>%1, Maximum</translation>
    </message>
    <message>
        <source>%1 raw (dps)</source>
        <translation>%1 roh (dps)</translation>
    </message>
    <message>
        <source>%1 compensated (dps)</source>
        <translation>%1 kompensiert (dps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>raw %1 dps</source>
        <translation>roh %1 dps</translation>
    </message>
    <message>
        <source>compensated %1 dps</source>
        <translation>kompensiert %1 dps</translation>
    </message>
    <message>
        <source>T %1 °C</source>
        <translation>T %1 °C</translation>
    </message>
    <message>
        <source>plan %1 °C</source>
        <translation>Plan %1 °C</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>Live-Kurven</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>Zeit seit Start (h:min)</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>Zeit seit Start (h:min:s)</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>Drehrate %1 (dps)</translation>
    </message>
    <message>
        <source>%1 TDE (dps)</source>
        <translation>TDE %1 (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::LoadingState</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>driftbench::LogForm</name>
    <message>
        <source>mdps/LSB</source>
        <translation>mdps/LSB</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Gyro in the log</source>
        <translation>Gyro im Log</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Zeitspalte</translation>
    </message>
    <message>
        <source>T column</source>
        <translation>T-Spalte</translation>
    </message>
    <message>
        <source>x column</source>
        <translation>x-Spalte</translation>
    </message>
    <message>
        <source>y column</source>
        <translation>y-Spalte</translation>
    </message>
    <message>
        <source>z column</source>
        <translation>z-Spalte</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Zeiteinheit</translation>
    </message>
    <message>
        <source>T unit</source>
        <translation>T-Einheit</translation>
    </message>
    <message>
        <source>Rate unit</source>
        <translation>Drehrateneinheit</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>Referenzdrehrate</translation>
    </message>
    <message>
        <source>found by its name</source>
        <translation>am Namen erkannt</translation>
    </message>
    <message>
        <source>The name in the header, or the number of the column.</source>
        <translation>Der Name in der Kopfzeile oder die Nummer der Spalte.</translation>
    </message>
    <message>
        <source>Read in whole</source>
        <translation>Ganz einlesen</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play back, %1 times</source>
        <translation>Abspielen, %1-fach</translation>
    </message>
    <message>
        <source>The only one</source>
        <translation>Der einzige</translation>
    </message>
    <message>
        <source>As the log says</source>
        <translation>Wie im Log</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>as the log says</source>
        <translation>wie im Log</translation>
    </message>
    <message>
        <source>Whose log it is: a device takes a table only for itself, and the report names it.</source>
        <translation>Von welchem Sensor das Log ist: Ein Gerät nimmt nur eine Tabelle für sich selbst, und der Bericht nennt ihn.</translation>
    </message>
</context>
<context>
    <name>driftbench::MainWindow</name>
    <message>
        <source>Tab next · Enter choose · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>Tab weiter · Enter wählen · Strg+O Dateien öffnen · Alt+1 bis 7 Schritte</translation>
    </message>
    <message>
        <source>Event log</source>
        <translation>Ereignisprotokoll</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Sitzung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Neue Sitzung</translation>
    </message>
    <message>
        <source>&amp;Open files…</source>
        <translation>Dateien ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Copy the event log</source>
        <translation>Ereignisprotokoll kopieren</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Event log</source>
        <translation>&amp;Ereignisprotokoll</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>&amp;Geführte Tour</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;About Driftbench</source>
        <translation>Ü&amp;ber Driftbench</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Noch keine Dateien</translation>
    </message>
    <message>
        <source>&amp;Save session…</source>
        <translation>Sitzung &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Sitzung &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Wheel|Zoom at the mouse; over an axis, that axis</source>
        <translation>Mausrad|An der Maus zoomen; über einer Achse nur diese</translation>
    </message>
    <message>
        <source>Drag|Move</source>
        <translation>Ziehen|Verschieben</translation>
    </message>
    <message>
        <source>Shift+Drag|Zoom to a box</source>
        <translation>Umschalt+Ziehen|Auf Rechteck zoomen</translation>
    </message>
    <message>
        <source>Double-click, F|Fit</source>
        <translation>Doppelklick, F|Einpassen</translation>
    </message>
    <message>
        <source>Arrows|Move</source>
        <translation>Pfeiltasten|Verschieben</translation>
    </message>
    <message>
        <source>+, −|Zoom</source>
        <translation>+, −|Zoomen</translation>
    </message>
    <message>
        <source>A, B|Set a cursor at the mouse</source>
        <translation>A, B|Cursor an der Maus setzen</translation>
    </message>
    <message>
        <source>Ctrl+E|Export what is visible</source>
        <translation>Strg+E|Sichtbares exportieren</translation>
    </message>
    <message>
        <source>About Driftbench</source>
        <translation>Über Driftbench</translation>
    </message>
    <message>
        <source>Driftbench %1</source>
        <translation>Driftbench %1</translation>
    </message>
    <message>
        <source>Calibrates the temperature drift of MEMS gyros. Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Kalibriert die Temperaturdrift von MEMS-Gyros. Freie Software unter der GNU General Public License, Version 3 oder neuer.</translation>
    </message>
    <message>
        <source>Open logs or a session</source>
        <translation>Logs oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>Logs and sessions (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;All files (*)</source>
        <translation>Logs und Sitzungen (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.driftbench)</source>
        <translation>Sitzungen (*.driftbench)</translation>
    </message>
    <message>
        <source>New session, not saved yet</source>
        <translation>Neue Sitzung, noch nicht gespeichert</translation>
    </message>
    <message>
        <source>Unnamed session</source>
        <translation>Unbenannte Sitzung</translation>
    </message>
    <message>
        <source>Session: %1</source>
        <translation>Sitzung: %1</translation>
    </message>
    <message>
        <source>%1 · read-only</source>
        <translation>%1 · schreibgeschützt</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · gespeichert</translation>
    </message>
    <message>
        <source>%1 · not saved</source>
        <translation>%1 · nicht gespeichert</translation>
    </message>
    <message>
        <source>Driftbench</source>
        <translation>Driftbench</translation>
    </message>
    <message>
        <source>%1 – Driftbench</source>
        <translation>%1 – Driftbench</translation>
    </message>
    <message>
        <source>Gap from %1 to %2 s: %3.</source>
        <translation>Lücke von %1 bis %2 s: %3.</translation>
    </message>
    <message>
        <source>Session restored.</source>
        <translation>Sitzung wiederhergestellt.</translation>
    </message>
    <message>
        <source>Recording stopped when the program ended. %1 samples are safe.</source>
        <translation>Die Aufzeichnung endete mit dem Programm. %1 Abtastwerte sind gesichert.</translation>
    </message>
    <message>
        <source>It has no name yet; Save gives it one.</source>
        <translation>Sie hat noch keinen Namen; Speichern gibt ihr einen.</translation>
    </message>
    <message>
        <source>Quit Driftbench</source>
        <translation>Driftbench beenden</translation>
    </message>
    <message>
        <source>A run is being recorded.</source>
        <translation>Ein Lauf wird gerade aufgezeichnet.</translation>
    </message>
    <message>
        <source>The last changes are not on the disk.</source>
        <translation>Die letzten Änderungen sind nicht auf dem Datenträger.</translation>
    </message>
    <message>
        <source>Quit ends the run. What was recorded is kept.</source>
        <translation>Beenden schließt den Lauf ab. Das Aufgezeichnete bleibt erhalten.</translation>
    </message>
    <message>
        <source>Make room or permit the file to be written, then save again.</source>
        <translation>Platz schaffen oder das Schreiben der Datei erlauben, dann erneut speichern.</translation>
    </message>
    <message>
        <source>End the run and quit</source>
        <translation>Lauf abschließen und beenden</translation>
    </message>
    <message>
        <source>Quit and lose them</source>
        <translation>Beenden und verwerfen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortfahren</translation>
    </message>
    <message>
        <source>%1 is running.</source>
        <extracomment>%1 is the name of a source</extracomment>
        <translation>%1 läuft.</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelLabels</name>
    <message>
        <source>RBF network</source>
        <translation>RBF-Netz</translation>
    </message>
    <message>
        <source>RBF network, as in the paper</source>
        <translation>RBF-Netz, wie im Artikel</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>BP-Netz</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>cubic, as ArduPilot</source>
        <translation>kubisch, wie ArduPilot</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>Konstante</translation>
    </message>
    <message>
        <source>recommended model of each axis</source>
        <translation>empfohlenes Modell je Achse</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>RBF network (Novel)</source>
        <translation>RBF-Netz (Neu)</translation>
    </message>
    <message>
        <source>BP 2-%1-1 (Conv. 2)</source>
        <translation>BP 2-%1-1 (Konv. 2)</translation>
    </message>
    <message>
        <source>Cubic (PX4)</source>
        <translation>Kubisch (PX4)</translation>
    </message>
    <message>
        <source>Cubic (ArduPilot)</source>
        <translation>Kubisch (ArduPilot)</translation>
    </message>
    <message>
        <source>Line (Conv. 1)</source>
        <translation>Gerade (Konv. 1)</translation>
    </message>
    <message>
        <source>Constant (bias only)</source>
        <translation>Konstante (nur Bias)</translation>
    </message>
    <message numerus="yes">
        <source>%n centres</source>
        <translation>
            <numerusform>%n Zentrum</numerusform>
            <numerusform>%n Zentren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to %2 centres</source>
        <translation>%1 bis %2 Zentren</translation>
    </message>
    <message>
        <source>RBF, %1 (Novel)</source>
        <translation>RBF, %1 (Neu)</translation>
    </message>
    <message>
        <source>RBF, paper (Novel)</source>
        <translation>RBF, Artikel (Neu)</translation>
    </message>
    <message>
        <source>RBF, paper, %1</source>
        <translation>RBF, Artikel, %1</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelsTableModel</name>
    <message>
        <source>&lt; 1 ms</source>
        <translation>&lt; 1 ms</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation>Grundrauschen</translation>
    </message>
    <message>
        <source>Excess %1
%</source>
        <translation>Übersch. %1
%</translation>
    </message>
    <message>
        <source>MSD %1
dps²</source>
        <translation>MSD %1
dps²</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>driftbench::MsdTrendView</name>
    <message>
        <source>MSD so far</source>
        <translation>MSD bisher</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>It begins with the recording.</source>
        <translation>Beginnt mit der Aufzeichnung.</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>Zeit seit Start (h:min:s)</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>Zeit seit Start (h:min)</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 vorher</translation>
    </message>
    <message>
        <source>%1 after</source>
        <translation>%1 nachher</translation>
    </message>
</context>
<context>
    <name>driftbench::NativeForm</name>
    <message>
        <source>As it is set</source>
        <translation>Wie eingestellt</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>0 leaves the rate that the bridge has now.</source>
        <translation>0 behält die derzeitige Rate der Bridge bei.</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Messbereich</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermometer</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>Extern, sonst Chip</translation>
    </message>
    <message>
        <source>External</source>
        <translation>Extern</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>Auf dem Chip</translation>
    </message>
    <message>
        <source>Compensated by its own table</source>
        <translation>Durch eigene Tabelle kompensiert</translation>
    </message>
    <message>
        <source>To check a table that was written. A calibration needs raw rates.</source>
        <translation>Zum Prüfen einer geschriebenen Tabelle. Eine Kalibrierung braucht rohe Drehraten.</translation>
    </message>
</context>
<context>
    <name>driftbench::OriginChip</name>
    <message>
        <source>Simulated data</source>
        <translation>Simulierte Daten</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>Echtes Log</translation>
    </message>
    <message>
        <source>Real device</source>
        <translation>Echtes Gerät</translation>
    </message>
</context>
<context>
    <name>driftbench::PeriodPanel</name>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>As printed (kJ, °C)</source>
        <translation>Wie gedruckt (kJ, °C)</translation>
    </message>
    <message>
        <source>In SI, °C; in SI, kelvin</source>
        <translation>In SI, °C; in SI, Kelvin</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Slowest mode of a %1 m cube, still air</source>
        <translation>Trägste Mode, Würfel %1 m, ruhende Luft</translation>
    </message>
</context>
<context>
    <name>driftbench::PlanForm</name>
    <message>
        <source>mdps/LSB</source>
        <translation>mdps/LSB</translation>
    </message>
    <message>
        <source>dps/°C</source>
        <translation>dps/°C</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Chamber</source>
        <translation>Kammer</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Messbereich</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>Bias with T</source>
        <translation>Bias über T</translation>
    </message>
    <message>
        <source>Inner length</source>
        <translation>Innenlänge</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermometer</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, bis</translation>
    </message>
    <message>
        <source>Lowest temperature</source>
        <translation>Tiefste Temperatur</translation>
    </message>
    <message>
        <source>Highest temperature</source>
        <translation>Höchste Temperatur</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Hold at the ends</source>
        <translation>Haltezeit Enden</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Come back down, to see hysteresis</source>
        <translation>Zurückkühlen, um Hysterese zu sehen</translation>
    </message>
    <message>
        <source>Own figures</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Sensor preset</source>
        <translation>Sensorvorgabe</translation>
    </message>
    <message>
        <source>Chamber preset</source>
        <translation>Kammervorgabe</translation>
    </message>
</context>
<context>
    <name>driftbench::PlanPage</name>
    <message>
        <source>edit of the plan</source>
        <translation>Änderung am Plan</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1 bis %2 °C</translation>
    </message>
    <message>
        <source>None, from a log</source>
        <translation>Keiner, aus einem Log</translation>
    </message>
    <message>
        <source>Tab next field · Up, Down change a value · Ctrl+Z undo · Ctrl+Enter record</source>
        <translation>Tab nächstes Feld · Auf, Ab Wert ändern · Strg+Z rückgängig · Strg+Enter aufzeichnen</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Diesen Plan nutzen</translation>
    </message>
    <message>
        <source>Plan file</source>
        <translation>Plandatei</translation>
    </message>
    <message>
        <source>Open plan…</source>
        <translation>Plan öffnen…</translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation>Plan speichern…</translation>
    </message>
    <message>
        <source>Save steps for a chamber controller…</source>
        <translation>Schritte für Kammerregler speichern…</translation>
    </message>
    <message>
        <source>Save ramps for a chamber controller…</source>
        <translation>Rampen für Kammerregler speichern…</translation>
    </message>
    <message>
        <source>One run</source>
        <translation>Ein Lauf</translation>
    </message>
    <message>
        <source>Control interval</source>
        <translation>Regelintervall</translation>
    </message>
    <message>
        <source>Eqs. 13, 14, 26, 27</source>
        <translation>Gl. 13, 14, 26, 27</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>Regelperiode</translation>
    </message>
    <message>
        <source>Eqs. 25, 28, and the transient</source>
        <translation>Gl. 25, 28 und Übergang</translation>
    </message>
    <message>
        <source>, without cooling back</source>
        <translation>, ohne Zurückkühlen</translation>
    </message>
    <message>
        <source>What the chamber does in each run, and for how long</source>
        <translation>Was die Kammer in jedem Lauf tut und wie lange</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>A step of %1 is shorter than still air needs to settle: %2.</source>
        <translation>Ein Schritt von %1 ist kürzer, als ruhende Luft zum Einschwingen braucht: %2.</translation>
    </message>
    <message>
        <source>Stir the air, or place the thermometer on the sensor.</source>
        <translation>Die Luft umwälzen oder das Thermometer am Sensor anbringen.</translation>
    </message>
    <message>
        <source>Open plan</source>
        <translation>Plan öffnen</translation>
    </message>
    <message>
        <source>Plans (*.json)</source>
        <translation>Pläne (*.json)</translation>
    </message>
    <message>
        <source>Plan read from %1.</source>
        <translation>Plan gelesen aus %1.</translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation>Plan speichern</translation>
    </message>
    <message>
        <source>Plan written to %1.</source>
        <translation>Plan geschrieben: %1.</translation>
    </message>
    <message>
        <source>Save controller file</source>
        <translation>Reglerdatei speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Controller file written to %1.</source>
        <translation>Reglerdatei geschrieben: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 a run, %2 samples at %3 Hz · %4 for %n runs</source>
        <translation>
            <numerusform>%1 je Lauf, %2 Abtastwerte mit %3 Hz · %4 für %n Lauf</numerusform>
            <numerusform>%1 je Lauf, %2 Abtastwerte mit %3 Hz · %4 für %n Läufe</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::PlotInteraction</name>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Set cursor A here</source>
        <translation>Cursor A hier setzen</translation>
    </message>
    <message>
        <source>Set cursor B here</source>
        <translation>Cursor B hier setzen</translation>
    </message>
    <message>
        <source>Remove the cursors</source>
        <translation>Cursor entfernen</translation>
    </message>
    <message>
        <source>Export what is visible…</source>
        <translation>Sichtbares exportieren…</translation>
    </message>
    <message>
        <source>Show the data as a table</source>
        <translation>Daten als Tabelle zeigen</translation>
    </message>
    <message>
        <source>Export what is visible</source>
        <translation>Sichtbares exportieren</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV-Tabelle (*.csv)</translation>
    </message>
</context>
<context>
    <name>driftbench::PlotTable</name>
    <message>
        <source>Panel</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Abszisse</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
</context>
<context>
    <name>driftbench::ProfileView</name>
    <message>
        <source>Set points of one run over time</source>
        <translation>Sollwerte eines Laufs über der Zeit</translation>
    </message>
    <message>
        <source>hold %1</source>
        <translation>halten %1</translation>
    </message>
    <message>
        <source>No profile</source>
        <translation>Kein Profil</translation>
    </message>
    <message>
        <source>Put the fields right that are marked.</source>
        <translation>Die markierten Felder berichtigen.</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>Zeit seit Start</translation>
    </message>
    <message>
        <source>Set point (°C)</source>
        <translation>Sollwert (°C)</translation>
    </message>
    <message numerus="yes">
        <source>%n steps of %1 °C, %2 °C/min</source>
        <translation>
            <numerusform>%n Schritt zu %1 °C, %2 °C/min</numerusform>
            <numerusform>%n Schritte zu %1 °C, %2 °C/min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RateFields</name>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>Reference rate, %1</source>
        <translation>Referenzdrehrate, %1</translation>
    </message>
</context>
<context>
    <name>driftbench::RecentFilesModel</name>
    <message>
        <source>Ready to train</source>
        <translation>Bereit zum Training</translation>
    </message>
    <message>
        <source>Single run</source>
        <translation>Einzelner Lauf</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>Real</source>
        <translation>Echt</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Wird gesichtet…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Expect</source>
        <translation>Erwartung</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n runs</source>
        <translation>
            <numerusform>%1 von %n Lauf</numerusform>
            <numerusform>%1 von %n Läufen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n runs</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>%n Läufe</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RecordPage</name>
    <message>
        <source>Span of the traces</source>
        <translation>Zeitspanne der Kurven</translation>
    </message>
    <message>
        <source>Quantity of the traces</source>
        <translation>Größe der Kurven</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>Aufzeichnung starten</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung stoppen</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>Quelle wählen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Write again</source>
        <translation>Erneut schreiben</translation>
    </message>
    <message>
        <source>Save it elsewhere…</source>
        <translation>Anderswo speichern…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>1 min</source>
        <translation>1 min</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>TDE</source>
        <translation>TDE</translation>
    </message>
    <message>
        <source>No source is chosen.</source>
        <translation>Keine Quelle gewählt.</translation>
    </message>
    <message>
        <source>Choose the bridge or the file to record from.</source>
        <translation>Die Bridge oder die Datei wählen, aus der aufgezeichnet wird.</translation>
    </message>
    <message>
        <source>The run can&apos;t be recorded.</source>
        <translation>Der Lauf lässt sich nicht aufzeichnen.</translation>
    </message>
    <message>
        <source>The source has ended.</source>
        <translation>Die Quelle ist zu Ende.</translation>
    </message>
    <message>
        <source>Run %1 is complete.</source>
        <translation>Lauf %1 ist vollständig.</translation>
    </message>
    <message>
        <source>Run %1 was stopped at %2.</source>
        <translation>Lauf %1 wurde bei %2 gestoppt.</translation>
    </message>
    <message>
        <source>%1 samples are in the session.</source>
        <translation>%1 Abtastwerte sind in der Sitzung.</translation>
    </message>
    <message>
        <source>A part of the run is not on the disk.</source>
        <translation>Ein Teil des Laufs ist nicht auf dem Datenträger.</translation>
    </message>
    <message>
        <source>It is kept in memory.</source>
        <translation>Er bleibt im Speicher.</translation>
    </message>
    <message>
        <source>The disk is slow.</source>
        <translation>Der Datenträger ist langsam.</translation>
    </message>
    <message>
        <source>The disk takes no more.</source>
        <translation>Der Datenträger nimmt nichts mehr auf.</translation>
    </message>
    <message>
        <source>Make room on it; recording goes on in memory.</source>
        <translation>Dort Platz schaffen; die Aufzeichnung läuft im Speicher weiter.</translation>
    </message>
    <message>
        <source>All samples are on the disk again.</source>
        <translation>Alle Abtastwerte sind wieder auf dem Datenträger.</translation>
    </message>
    <message>
        <source>The memory for samples is full, the run has ended.</source>
        <translation>Der Speicher für Abtastwerte ist voll, der Lauf ist beendet.</translation>
    </message>
    <message>
        <source>Save what is not on the disk</source>
        <translation>Speichern, was nicht auf dem Datenträger ist</translation>
    </message>
    <message>
        <source>CSV log (*.csv)</source>
        <translation>CSV-Log (*.csv)</translation>
    </message>
    <message>
        <source>The rest of the run is in %1.</source>
        <translation>Der Rest des Laufs ist in %1.</translation>
    </message>
    <message>
        <source>The view is paused at %1. Recording goes on.</source>
        <translation>Die Ansicht ist bei %1 angehalten. Die Aufzeichnung läuft weiter.</translation>
    </message>
    <message>
        <source>%1 samples have arrived since. The figures on the right stay live.</source>
        <translation>Seitdem sind %1 Abtastwerte eingetroffen. Die Werte rechts laufen weiter.</translation>
    </message>
    <message>
        <source>The bridge was unplugged at %1.</source>
        <translation>Die Bridge wurde bei %1 abgezogen.</translation>
    </message>
    <message>
        <source>Plug it in to go on with this run.</source>
        <translation>Wieder einstecken, um diesen Lauf fortzusetzen.</translation>
    </message>
    <message>
        <source>No samples have come for %1 s.</source>
        <translation>Seit %1 s kommen keine Abtastwerte.</translation>
    </message>
    <message>
        <source>Look at the cable and the bridge; the run goes on as soon as they come again.</source>
        <translation>Kabel und Bridge prüfen; der Lauf geht weiter, sobald wieder welche kommen.</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>Lauf %1 von %2</translation>
    </message>
    <message>
        <source>%1, no model yet</source>
        <translation>%1, noch kein Modell</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, compensated by the model of %2</source>
        <translation>%1, kompensiert durch das Modell aus %2</translation>
    </message>
    <message>
        <source>Resume view</source>
        <translation>Ansicht fortsetzen</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Ansicht anhalten</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) in the session</source>
        <translation>
            <numerusform>%n Lauf in der Sitzung</numerusform>
            <numerusform>%n Läufe in der Sitzung</numerusform>
        </translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>Noch keine Läufe</translation>
    </message>
    <message>
        <source>Record the next run from: %1.</source>
        <translation>Den nächsten Lauf aufzeichnen aus: %1.</translation>
    </message>
    <message>
        <source>Choose a source, then record a run.</source>
        <translation>Eine Quelle wählen, dann einen Lauf aufzeichnen.</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <translation>%1 · %2 %</translation>
    </message>
    <message>
        <source>Opening the source</source>
        <translation>Quelle wird geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>%n Läufe</numerusform>
        </translation>
    </message>
    <message>
        <source>Space resume the view · Wheel zoom · Drag pan · A, B set a cursor at the mouse</source>
        <translation>Leertaste Ansicht fortsetzen · Mausrad zoomen · Ziehen verschieben · A, B Cursor an der Maus setzen</translation>
    </message>
    <message>
        <source>Wheel zoom · Drag pan · Shift+drag box zoom · Double-click fit · A, B set a cursor at the mouse</source>
        <translation>Mausrad zoomen · Ziehen verschieben · Umschalt+Ziehen Rechteck zoomen · Doppelklick einpassen · A, B Cursor an der Maus setzen</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
</context>
<context>
    <name>driftbench::RecordReadouts</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Fortschritt des Laufs</translation>
    </message>
    <message>
        <source>Running MSD</source>
        <translation>Laufende MSD</translation>
    </message>
    <message>
        <source>dps², since 0:00:00</source>
        <translation>dps², seit 0:00:00</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>10 s means, dps</source>
        <translation>10-s-Mittel, dps</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>MSD so far</source>
        <translation>MSD bisher</translation>
    </message>
    <message>
        <source>dps², amber before, blue after</source>
        <translation>dps², orange vorher, blau nachher</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>Verstrichen</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>Verbleibend</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Q = after/before</source>
        <translation>Q = nachher/vorher</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 roh</translation>
    </message>
    <message>
        <source>%1 comp.</source>
        <translation>%1 komp.</translation>
    </message>
    <message>
        <source>Sample rate, samples</source>
        <translation>Abtastrate, Abtastwerte</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Overruns, saturated</source>
        <translation>Überläufe, übersteuert</translation>
    </message>
    <message>
        <source>rise, step %1 of %2</source>
        <translation>Anstieg, Schritt %1 von %2</translation>
    </message>
    <message>
        <source>fall, step %1 of %2</source>
        <translation>Abfall, Schritt %1 von %2</translation>
    </message>
    <message>
        <source>hold, step %1 of %2</source>
        <translation>Halten, Schritt %1 von %2</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1, %2 daneben</translation>
    </message>
    <message>
        <source>%1, %2 ahead</source>
        <translation>%1, %2 voraus</translation>
    </message>
    <message>
        <source>%1, %2 behind</source>
        <translation>%1, %2 zurück</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>rms of 10 s means, before and after:</source>
        <translation>RMS der 10-s-Mittel, vorher und nachher:</translation>
    </message>
    <message>
        <source>%1: %2 and %3 dps</source>
        <translation>%1: %2 und %3 dps</translation>
    </message>
    <message>
        <source>last gap %1</source>
        <translation>letzte Lücke %1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
</context>
<context>
    <name>driftbench::ReportText</name>
    <message>
        <source>%1 trained on other runs</source>
        <translation>%1 trainiert auf anderen Läufen</translation>
    </message>
    <message>
        <source>%1 trained on %2</source>
        <translation>%1 trainiert auf %2</translation>
    </message>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>Temperaturgrößen und Driftfehler über der Zeit</translation>
    </message>
    <message>
        <source>Run %1: ΔT, ΔT² and √ΔT, and the temperature drift error (TDE) of each axis.</source>
        <translation>Lauf %1: ΔT, ΔT² und √ΔT sowie der Temperaturdriftfehler (TDE) jeder Achse.</translation>
    </message>
    <message>
        <source>TDE of %1 against each temperature quantity</source>
        <translation>TDE von %1 über jeder Temperaturgröße</translation>
    </message>
    <message>
        <source>All runs, with the curves fitted to them; below, what the fitted curve leaves. Where heating and cooling part, no curve of temperature follows.</source>
        <translation>Alle Läufe mit ihren Ausgleichskurven; darunter, was die Ausgleichskurve übrig lässt. Wo Heizen und Kühlen auseinanderlaufen, folgt keine Kurve der Temperatur.</translation>
    </message>
    <message>
        <source>Run %1 before and after compensation</source>
        <translation>Lauf %1 vor und nach der Kompensation</translation>
    </message>
    <message>
        <source>The model has not seen this run. Mean, and lowest to highest, of each stretch of time; rms about the reference rate.</source>
        <translation>Das Modell kennt diesen Lauf nicht. Mittel sowie Minimum bis Maximum jedes Zeitabschnitts; RMS um die Referenzdrehrate.</translation>
    </message>
    <message>
        <source>Allan deviation of run %1</source>
        <translation>Allan-Abweichung von Lauf %1</translation>
    </message>
    <message>
        <source>Noise falls with the averaging time, drift rises with it.</source>
        <translation>Rauschen fällt mit der Mittelungszeit, Drift steigt mit ihr.</translation>
    </message>
    <message>
        <source>Run %1, held out: what is left, and its Allan deviation</source>
        <translation>Lauf %1, zurückgehalten: der Rest und seine Allan-Abweichung</translation>
    </message>
    <message>
        <source>Before, less the constant; after, by a model that has not seen this run. Each axis has its own scale.</source>
        <translation>Vorher, ohne Konstante; nachher, durch ein Modell, das diesen Lauf nicht kennt. Jede Achse hat ihre eigene Skala.</translation>
    </message>
    <message>
        <source>What is left of the TDE on runs held out</source>
        <translation>Rest des TDE auf zurückgehaltenen Läufen</translation>
    </message>
    <message>
        <source>Each run less the model that has not seen it. Lines that are level at zero mean that the drift repeats.</source>
        <translation>Jeder Lauf abzüglich des Modells, das ihn nicht kennt. Linien, die flach bei null liegen, bedeuten, dass sich die Drift wiederholt.</translation>
    </message>
    <message>
        <source>How many centres the RBF network needs</source>
        <translation>Wie viele Zentren das RBF-Netz braucht</translation>
    </message>
    <message>
        <source>The smallest number whose loss on data left out is as good as the lowest; below, where the centres stand.</source>
        <translation>Die kleinste Anzahl, deren Verlust auf ausgelassenen Daten so gut ist wie der niedrigste; darunter, wo die Zentren liegen.</translation>
    </message>
    <message>
        <source>Simulated data</source>
        <translation>Simulierte Daten</translation>
    </message>
    <message>
        <source>%1 held out</source>
        <translation>%1 zurückgehalten</translation>
    </message>
    <message>
        <source>Blocks of temperature held out in turn</source>
        <translation>Temperaturblöcke nacheinander zurückgehalten</translation>
    </message>
    <message>
        <source>Each run held out once</source>
        <translation>Jeder Lauf einmal zurückgehalten</translation>
    </message>
    <message>
        <source>Anchored: the bias at the start of each run is removed</source>
        <translation>Verankert: Der Bias am Anfang jedes Laufs wird abgezogen</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts</source>
        <translation>Absolut: Der Einschalt-Bias zählt</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>not stated by the logs</source>
        <translation>in den Logs nicht angegeben</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Date of this report</source>
        <translation>Datum dieses Berichts</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>%1, with %2 samples, %3 of them usable</source>
        <translation>%1, mit %2 Abtastwerten, davon %3 nutzbar</translation>
    </message>
    <message>
        <source>Reference temperature</source>
        <translation>Referenztemperatur</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Hold-out</source>
        <translation>Zurückhalten</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seed</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>%1 dps rms may be left on a held-out run</source>
        <translation>%1 dps RMS dürfen auf einem zurückgehaltenen Lauf übrig bleiben</translation>
    </message>
    <message>
        <source>none was set</source>
        <translation>keiner gesetzt</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Where the data come from</source>
        <translation>Woher die Daten stammen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Reference dps</source>
        <translation>Referenz dps</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>Nutzbar</translation>
    </message>
    <message>
        <source>Left out, and why</source>
        <translation>Ausgelassen und warum</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>Means over the held-out runs.</source>
        <translation>Mittel über die zurückgehaltenen Läufe.</translation>
    </message>
    <message>
        <source>Held-out runs, in the paper&apos;s order</source>
        <translation>Zurückgehaltene Läufe, in der Reihenfolge des Artikels</translation>
    </message>
    <message>
        <source>MSD in dps²: mean square of what is left. Q: MSD after over MSD before. Differences: negative where the first named is better. Novel: %1.</source>
        <translation>MSD in dps²: mittleres Quadrat des Rests. Q: MSD nachher durch MSD vorher. Differenzen: negativ, wo das zuerst Genannte besser ist. Neu: %1.</translation>
    </message>
    <message>
        <source>Conventional 1 is a line in ΔT, Conventional 2 a BP network 2-10-1, Novel an RBF network on ΔT, ΔT² and √ΔT; cubic is the model of PX4 and ArduPilot, constant the bias alone.</source>
        <translation>Konventionell 1 ist eine Gerade in ΔT, Konventionell 2 ein BP-Netz 2-10-1, Neu ein RBF-Netz auf ΔT, ΔT² und √ΔT; kubisch ist das Modell von PX4 und ArduPilot, Konstante allein der Bias.</translation>
    </message>
    <message>
        <source>Yes: within the limit and better than the constant on every held-out run. With care: within the limit, but not always better. No: over the limit on any run, or the bias does not repeat.</source>
        <translation>Ja: innerhalb des Grenzwerts und besser als die Konstante auf jedem zurückgehaltenen Lauf. Mit Vorsicht: innerhalb des Grenzwerts, aber nicht immer besser. Nein: über dem Grenzwert auf einem der Läufe, oder der Bias wiederholt sich nicht.</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>Echtes Log</translation>
    </message>
    <message>
        <source>unknown sensor</source>
        <translation>unbekannter Sensor</translation>
    </message>
    <message>
        <source>Temperature drift of %1, simulated</source>
        <translation>Temperaturdrift von %1, simuliert</translation>
    </message>
    <message>
        <source>Temperature drift of %1</source>
        <translation>Temperaturdrift von %1</translation>
    </message>
    <message>
        <source>May this drift be compensated?</source>
        <translation>Darf diese Drift kompensiert werden?</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Each model estimates the rate error as a function of temperature alone and is judged only on runs that it has not seen. %1. The noise floor is the variance within 0.5 °C: what no function of temperature removes. Excess is what a model leaves above it.</source>
        <translation>Jedes Modell schätzt den Drehratenfehler allein als Funktion der Temperatur und wird nur auf Läufen bewertet, die es nicht kennt. %1. Das Grundrauschen ist die Varianz innerhalb von 0,5 °C: was keine Funktion der Temperatur beseitigt. Der Überschuss ist, was ein Modell darüber hinaus übrig lässt.</translation>
    </message>
</context>
<context>
    <name>driftbench::ReportWriter</name>
    <message>
        <source>Preparing</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Drawing figure %1 of %2</source>
        <translation>Abbildung %1 von %2 wird gezeichnet</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
</context>
<context>
    <name>driftbench::ResidualView</name>
    <message>
        <source>Residual against temperature</source>
        <translation>Residuum über der Temperatur</translation>
    </message>
    <message>
        <source>No residuals yet</source>
        <translation>Noch keine Residuen</translation>
    </message>
    <message>
        <source>Train a model and choose runs that it has not seen.</source>
        <translation>Ein Modell trainieren und Läufe wählen, die es nicht kennt.</translation>
    </message>
    <message>
        <source>Mean over 1 °C, each run</source>
        <translation>Mittel über 1 °C, je Lauf</translation>
    </message>
    <message>
        <source>95 % band of a new run&apos;s curve</source>
        <translation>95-%-Band der Kurve eines neuen Laufs</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Residual (dps)</source>
        <translation>Residuum (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::ScatterDots</name>
    <message>
        <source>Heating</source>
        <translation>Heizen</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Kühlen</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Ausgeschlossen</translation>
    </message>
</context>
<context>
    <name>driftbench::Session</name>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
</context>
<context>
    <name>driftbench::ShortcutOverview</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>Wirkung</translation>
    </message>
</context>
<context>
    <name>driftbench::SimulatedForm</name>
    <message>
        <source>Curved</source>
        <translation>Gekrümmt</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>Steil</translation>
    </message>
    <message>
        <source>Mild</source>
        <translation>Mild</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Combs</source>
        <translation>Kämme</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>As fast as it goes</source>
        <translation>So schnell wie möglich</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>Referenzdrehrate</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Noise, 1 σ</source>
        <translation>Rauschen, 1 σ</translation>
    </message>
    <message>
        <source>Run-to-run spread</source>
        <translation>Streuung der Läufe</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the simulated time passes while a run is recorded.</source>
        <translation>Wie schnell die simulierte Zeit vergeht, während ein Lauf aufgezeichnet wird.</translation>
    </message>
    <message>
        <source>How the bias follows the temperature; Combs computes it from the comb capacitors.</source>
        <translation>Wie der Bias der Temperatur folgt; „Kämme“ berechnet ihn aus den Kammkondensatoren.</translation>
    </message>
    <message>
        <source>%1, %2 dps</source>
        <translation>%1, %2 dps</translation>
    </message>
    <message>
        <source>%1, drift: %2</source>
        <translation>%1, Drift: %2</translation>
    </message>
</context>
<context>
    <name>driftbench::SourceForm</name>
    <message>
        <source>No source chosen</source>
        <translation>Keine Quelle gewählt</translation>
    </message>
</context>
<context>
    <name>driftbench::SourcePage</name>
    <message>
        <source>Reading</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>Reading logs</source>
        <translation>Logs werden gelesen</translation>
    </message>
    <message>
        <source>Simulated bridge</source>
        <translation>Simulierte Bridge</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>Gyro-Bridge</translation>
    </message>
    <message>
        <source>I2C bridge</source>
        <translation>I2C-Bridge</translation>
    </message>
    <message>
        <source>Up, Down choose · Enter use · F5 look again · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>Auf, Ab wählen · Enter verwenden · F5 erneut suchen · Strg+O Dateien öffnen · Alt+1 bis 7 Schritte</translation>
    </message>
    <message>
        <source>%1 %2 is plugged in, but you may not open it.</source>
        <translation>%1 %2 ist eingesteckt, aber das Recht zum Öffnen fehlt.</translation>
    </message>
    <message>
        <source>Save this line as 70-driftbench.rules in /etc/udev/rules.d, then unplug the bridge and plug it in again:</source>
        <translation>Diese Zeile als 70-driftbench.rules in /etc/udev/rules.d speichern, dann die Bridge abziehen und wieder einstecken:</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Use source</source>
        <translation>Quelle verwenden</translation>
    </message>
    <message>
        <source>Choose a bridge or a file.</source>
        <translation>Eine Bridge oder eine Datei wählen.</translation>
    </message>
    <message>
        <source>Use simulated bridge</source>
        <translation>Simulierte Bridge verwenden</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Read in</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>Other logs are being read.</source>
        <translation>Andere Logs werden gerade gelesen.</translation>
    </message>
    <message>
        <source>A run is being recorded. Stop it to take another source.</source>
        <translation>Ein Lauf wird aufgezeichnet. Zum Wechsel der Quelle stoppen.</translation>
    </message>
    <message>
        <source>Where the samples come from. Nothing is recorded yet.</source>
        <translation>Woher die Abtastwerte kommen. Noch ist nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>Copy line</source>
        <translation>Zeile kopieren</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Bridges</translation>
    </message>
    <message>
        <source>USB-HID, looked for every second</source>
        <translation>USB-HID, Suche jede Sekunde</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Letzte Dateien</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>letzte 60 s</translation>
    </message>
    <message>
        <source>Drop log files here: CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>Logdateien hier ablegen: CSV, PX4 ULog, ArduPilot DataFlash. Das Format wird am Inhalt erkannt.</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Noch keine Dateien</translation>
    </message>
    <message>
        <source>Logs and sessions that were opened stand here.</source>
        <translation>Geöffnete Logs und Sitzungen stehen hier.</translation>
    </message>
    <message numerus="yes">
        <source>%n logs</source>
        <translation>
            <numerusform>%n Log</numerusform>
            <numerusform>%n Logs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bridges plugged in, %1 usable</source>
        <translation>
            <numerusform>%n Bridge eingesteckt, %1 nutzbar</numerusform>
            <numerusform>%n Bridges eingesteckt, %1 nutzbar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Where the samples come from. %n runs so far.</source>
        <translation>
            <numerusform>Woher die Abtastwerte kommen. Bisher %n Lauf.</numerusform>
            <numerusform>Woher die Abtastwerte kommen. Bisher %n Läufe.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::SourceStatus</name>
    <message>
        <source> · opening</source>
        <translation> · wird geöffnet</translation>
    </message>
    <message>
        <source> · no samples for %1 s</source>
        <translation> · seit %1 s keine Abtastwerte</translation>
    </message>
    <message>
        <source> · %1 Hz</source>
        <translation> · %1 Hz</translation>
    </message>
    <message>
        <source> · 0 dropped</source>
        <translation> · 0 verloren</translation>
    </message>
    <message>
        <source>%1 dropped of %2</source>
        <translation>%1 von %2 verloren</translation>
    </message>
    <message>
        <source>%1 GB free</source>
        <translation>%1 GB frei</translation>
    </message>
</context>
<context>
    <name>driftbench::StartPage</name>
    <message>
        <source>Calibrate the temperature drift of a gyro</source>
        <translation>Die Temperaturdrift eines Gyros kalibrieren</translation>
    </message>
    <message>
        <source>From samples to a table in the device, in seven steps. Each step can be used on its own.</source>
        <translation>Von Abtastwerten zur Tabelle im Gerät, in sieben Schritten. Jeder Schritt lässt sich einzeln nutzen.</translation>
    </message>
    <message>
        <source>Guided tour on the simulated bridge</source>
        <translation>Geführte Tour an der simulierten Bridge</translation>
    </message>
    <message>
        <source>Connects, records three runs faster than time, trains, compares and writes the table. Under two minutes, no hardware.</source>
        <translation>Verbindet, zeichnet drei Läufe im Zeitraffer auf, trainiert, vergleicht und schreibt die Tabelle. Unter zwei Minuten, ohne Hardware.</translation>
    </message>
    <message>
        <source>Connect a bridge</source>
        <translation>Bridge anschließen</translation>
    </message>
    <message>
        <source>A native gyro bridge, or an L3GD20H or I3G4250D behind a USB-to-I2C chip.</source>
        <translation>Eine native Gyro-Bridge oder ein L3GD20H oder I3G4250D hinter einem USB-I2C-Chip.</translation>
    </message>
    <message>
        <source>Open log files or a session…</source>
        <translation>Logdateien oder Sitzung öffnen…</translation>
    </message>
    <message>
        <source>CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>CSV, PX4 ULog, ArduPilot DataFlash. Das Format wird am Inhalt erkannt.</translation>
    </message>
    <message>
        <source>Files can also be dropped anywhere on this window. F1 lists all keys.</source>
        <translation>Dateien lassen sich auch überall in diesem Fenster ablegen. F1 listet alle Tasten.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
</context>
<context>
    <name>driftbench::StepRail</name>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>mit Warnungen</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>zeichnet auf</translation>
    </message>
    <message>
        <source>working</source>
        <translation>arbeitet</translation>
    </message>
    <message>
        <source>%1 (Alt+%2)</source>
        <translation>%1 (Alt+%2)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>driftbench::StripView</name>
    <message>
        <source>The last minute of the source</source>
        <translation>Die letzte Minute der Quelle</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Nothing comes yet</source>
        <translation>Noch kommt nichts</translation>
    </message>
    <message>
        <source>Choose a source at the left.</source>
        <translation>Links eine Quelle wählen.</translation>
    </message>
    <message>
        <source>Time before now (s)</source>
        <translation>Zeit vor jetzt (s)</translation>
    </message>
</context>
<context>
    <name>driftbench::TableDifferenceView</name>
    <message>
        <source>New table less the one on the device</source>
        <translation>Neue Tabelle minus Tabelle auf dem Gerät</translation>
    </message>
    <message>
        <source>Nothing to compare</source>
        <translation>Nichts zu vergleichen</translation>
    </message>
    <message>
        <source>No table is on the device.</source>
        <translation>Keine Tabelle auf dem Gerät.</translation>
    </message>
    <message>
        <source>New − now (mdps)</source>
        <translation>Neu − jetzt (mdps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::TableErrorView</name>
    <message>
        <source>Worst error of the table in each cell</source>
        <translation>Größter Fehler der Tabelle in jeder Zelle</translation>
    </message>
    <message>
        <source>Worst in each cell</source>
        <translation>Maximum je Zelle</translation>
    </message>
    <message>
        <source>worst %1 mdps</source>
        <translation>max. %1 mdps</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>No table yet</source>
        <translation>Noch keine Tabelle</translation>
    </message>
    <message>
        <source>Train a model to see what a table of it costs.</source>
        <translation>Ein Modell trainieren, um zu sehen, was seine Tabelle kostet.</translation>
    </message>
    <message>
        <source>Table against model</source>
        <translation>Tabelle gegen Modell</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Schranke</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>Error (mdps)</source>
        <translation>Fehler (mdps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::TcqScatterView</name>
    <message>
        <source>Drift error against the temperature quantities</source>
        <translation>Driftfehler über den Temperaturgrößen</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Ausgeschlossen</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Heizen</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Kühlen</translation>
    </message>
    <message>
        <source>Fitted curve, %1, with its 95 % band</source>
        <translation>Ausgleichskurve, %1, mit ihrem 95-%-Band</translation>
    </message>
    <message>
        <source>Fitted curve, %1</source>
        <translation>Ausgleichskurve, %1</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Ausgewählt</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>Keine Abtastwerte</translation>
    </message>
    <message>
        <source>All samples are excluded, or no run was given.</source>
        <translation>Alle Abtastwerte sind ausgeschlossen, oder es liegt kein Lauf vor.</translation>
    </message>
    <message>
        <source>ΔT (°C)</source>
        <translation>ΔT (°C)</translation>
    </message>
    <message>
        <source>ΔT² (°C²)</source>
        <translation>ΔT² (°C²)</translation>
    </message>
    <message>
        <source>√ΔT (√°C)</source>
        <translation>√ΔT (√°C)</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE, %1 (dps)</translation>
    </message>
    <message>
        <source>Residual (dps)</source>
        <translation>Residuum (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::TcqTimeView</name>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>Temperaturgrößen und Driftfehler über der Zeit</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Noch kein Lauf</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Einen Lauf aufzeichnen oder eine Logdatei öffnen.</translation>
    </message>
    <message>
        <source>Temperature quantity</source>
        <translation>Temperaturgröße</translation>
    </message>
    <message>
        <source>TDE, mean and range</source>
        <translation>TDE, Mittel und Spanne</translation>
    </message>
    <message>
        <source>ΔT (°C)</source>
        <translation>ΔT (°C)</translation>
    </message>
    <message>
        <source>ΔT² (°C²)</source>
        <translation>ΔT² (°C²)</translation>
    </message>
    <message>
        <source>√ΔT (√°C)</source>
        <translation>√ΔT (√°C)</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE, %1 (dps)</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>Zeit seit Start</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainFigures</name>
    <message>
        <source>Trained. Judged once all are.</source>
        <translation>Trainiert. Bewertet, sobald alle es sind.</translation>
    </message>
    <message>
        <source>Waiting.</source>
        <translation>Wartet.</translation>
    </message>
    <message>
        <source>Training on each set of runs.</source>
        <translation>Training auf jedem Satz von Läufen.</translation>
    </message>
    <message>
        <source>Cancelled before it was finished.</source>
        <translation>Vor dem Ende abgebrochen.</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainOptions</name>
    <message>
        <source>Preset of the RBF network</source>
        <translation>Vorgabe des RBF-Netzes</translation>
    </message>
    <message>
        <source>inputs of the RBF network</source>
        <translation>Eingänge des RBF-Netzes</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>Ridge</translation>
    </message>
    <message>
        <source>Hidden units of the BP network</source>
        <translation>Verdeckte Neuronen des BP-Netzes</translation>
    </message>
    <message>
        <source>Starts of the BP network</source>
        <translation>Starts des BP-Netzes</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seed</translation>
    </message>
    <message>
        <source>number of centres</source>
        <translation>Anzahl der Zentren</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>Breiten</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>Ridge</translation>
    </message>
    <message>
        <source>hidden units</source>
        <translation>verdeckte Neuronen</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>Starts</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Seed</translation>
    </message>
    <message>
        <source>hold-out</source>
        <translation>Zurückhalten</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>One run in turn</source>
        <translation>Je ein Lauf</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>Nur %1</translation>
    </message>
    <message>
        <source>Blocks of temperature</source>
        <translation>Temperaturblöcke</translation>
    </message>
    <message>
        <source>Auto, up to %1</source>
        <translation>Auto, bis %1</translation>
    </message>
    <message numerus="yes">
        <source>%n, for every axis</source>
        <translation>
            <numerusform>%n, für jede Achse</numerusform>
            <numerusform>%n, für jede Achse</numerusform>
        </translation>
    </message>
    <message>
        <source>Auto, %1 tried</source>
        <translation>Auto, %1 probiert</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolut</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>Verankert</translation>
    </message>
    <message>
        <source>Gaussians on the temperature quantities, placed by orthogonal least squares.</source>
        <translation>Gauß-Funktionen auf den Temperaturgrößen, gesetzt durch orthogonale kleinste Quadrate.</translation>
    </message>
    <message>
        <source>A network with tanh units, trained from several seeded starts.</source>
        <translation>Ein Netz mit tanh-Neuronen, trainiert aus mehreren Starts mit festem Seed.</translation>
    </message>
    <message>
        <source>As PX4 fits it: medians, 2 000 bins of temperature, a cubic.</source>
        <translation>Wie PX4 anpasst: Mediane, 2 000 Temperaturklassen, ein kubisches Polynom.</translation>
    </message>
    <message>
        <source>As ArduPilot fits it: means of 2 s, a cubic about 35 °C.</source>
        <translation>Wie ArduPilot anpasst: Mittel über 2 s, ein kubisches Polynom um 35 °C.</translation>
    </message>
    <message>
        <source>Least squares on ΔT.</source>
        <translation>Kleinste Quadrate auf ΔT.</translation>
    </message>
    <message>
        <source>Always in: the others can&apos;t tell every temperature from every other.</source>
        <translation>Immer dabei: Die anderen können nicht jede Temperatur von jeder anderen unterscheiden.</translation>
    </message>
    <message>
        <source>The rate of the temperature is an experiment: it did not survive on recorded runs held out, and no table could hold it. driftbench-cli fit --dynamic measures it.</source>
        <translation>Die Änderungsrate der Temperatur ist ein Experiment: Auf aufgezeichneten, zurückgehaltenen Läufen bewährte sie sich nicht, und keine Tabelle könnte sie aufnehmen. driftbench-cli fit --dynamic misst sie.</translation>
    </message>
    <message>
        <source>Auto: the smallest number that does as well as the best on runs left out.</source>
        <translation>Auto: die kleinste Anzahl, die auf ausgelassenen Läufen so gut ist wie die beste.</translation>
    </message>
    <message>
        <source>Widths of the Gaussians, each half the one before, from the whole span down.</source>
        <translation>Breiten der Gauß-Funktionen, jede halb so groß wie die vorige, beginnend mit der ganzen Spanne.</translation>
    </message>
    <message>
        <source>How many samples&apos; worth of doubt shrinks each Gaussian. More is smoother.</source>
        <translation>Um wie viele Abtastwerte an Zweifel jede Gauß-Funktion geschrumpft wird. Mehr ist glatter.</translation>
    </message>
    <message>
        <source>Tanh units in the hidden layer of the BP network.</source>
        <translation>tanh-Neuronen in der verdeckten Schicht des BP-Netzes.</translation>
    </message>
    <message>
        <source>Seeded starts of the BP network; the best one counts.</source>
        <translation>Starts des BP-Netzes mit festem Seed; der beste zählt.</translation>
    </message>
    <message>
        <source>Same runs, options and seed: the same models, bit for bit.</source>
        <translation>Gleiche Läufe, Optionen und Seed: gleiche Modelle, Bit für Bit.</translation>
    </message>
    <message>
        <source>Which runs are judged by models that have not seen them.</source>
        <translation>Welche Läufe von Modellen bewertet werden, die sie nicht kennen.</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts, as in PX4. Anchored: the bias at the start of each run is removed, as ArduPilot does.</source>
        <translation>Absolut: Der Einschalt-Bias zählt, wie bei PX4. Verankert: Der Bias am Anfang jedes Laufs wird abgezogen, wie bei ArduPilot.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>RBF inputs</source>
        <translation>RBF-Eingänge</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Beste</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Artikel</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>RBF-Netz</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>BP-Netz</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as PX4</source>
        <translation>Kubisch in ΔT, wie PX4</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as ArduPilot</source>
        <translation>Kubisch in ΔT, wie ArduPilot</translation>
    </message>
    <message>
        <source>Line in ΔT</source>
        <translation>Gerade in ΔT</translation>
    </message>
    <message>
        <source>Centres</source>
        <translation>Zentren</translation>
    </message>
    <message>
        <source>Widths</source>
        <translation>Breiten</translation>
    </message>
    <message>
        <source>BP units</source>
        <translation>BP-Neuronen</translation>
    </message>
    <message>
        <source>BP starts</source>
        <translation>BP-Starts</translation>
    </message>
    <message>
        <source>Hold out</source>
        <translation>Zurückhalten</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Number of centres</source>
        <translation>Anzahl der Zentren</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainPage</name>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>Progress of the training</source>
        <translation>Fortschritt des Trainings</translation>
    </message>
    <message>
        <source>The training was refused.</source>
        <translation>Das Training wurde abgelehnt.</translation>
    </message>
    <message>
        <source>The training can&apos;t start.</source>
        <translation>Das Training kann nicht starten.</translation>
    </message>
    <message numerus="yes">
        <source>take %n centres</source>
        <translation>
            <numerusform>%n Zentrum übernehmen</numerusform>
            <numerusform>%n Zentren übernehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Each run is held out once.</source>
        <translation>Jeder Lauf wird einmal zurückgehalten.</translation>
    </message>
    <message>
        <source>Shown is what was trained before the last change. Train again.</source>
        <translation>Gezeigt ist der Stand vor der letzten Änderung. Neu trainieren.</translation>
    </message>
    <message>
        <source>Blocks of temperature are held out: one run can&apos;t show that another repeats it.</source>
        <translation>Temperaturblöcke werden zurückgehalten: Ein einziger Lauf kann nicht zeigen, dass ein anderer ihn wiederholt.</translation>
    </message>
    <message>
        <source>Each run is held out once. Held-out error counts, training error does not.</source>
        <translation>Jeder Lauf wird einmal zurückgehalten. Der Fehler darauf zählt, der Trainingsfehler nicht.</translation>
    </message>
    <message>
        <source>Train again</source>
        <translation>Neu trainieren</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Trainieren</translation>
    </message>
    <message>
        <source>Nothing to train on</source>
        <translation>Nichts zum Trainieren</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Einen Lauf aufzeichnen oder eine Logdatei öffnen.</translation>
    </message>
    <message>
        <source>Not trained yet</source>
        <translation>Noch nicht trainiert</translation>
    </message>
    <message>
        <source>Choose the models at the left and train them.</source>
        <translation>Links die Modelle wählen und trainieren.</translation>
    </message>
    <message>
        <source>These runs can&apos;t be trained on.</source>
        <translation>Auf diesen Läufen lässt sich nicht trainieren.</translation>
    </message>
    <message>
        <source>Centres: the fewest that do as well as the best on runs left out. Here %1.</source>
        <translation>Zentren: die wenigsten, die auf ausgelassenen Läufen so gut sind wie das Beste. Hier %1.</translation>
    </message>
    <message>
        <source>Training, %1 %</source>
        <translation>Training, %1 %</translation>
    </message>
    <message>
        <source>Changed, train again</source>
        <translation>Geändert, neu trainieren</translation>
    </message>
    <message numerus="yes">
        <source>%n model(s)</source>
        <translation>
            <numerusform>%n Modell</numerusform>
            <numerusform>%n Modelle</numerusform>
        </translation>
    </message>
    <message>
        <source>Esc cancel. What is finished is kept.</source>
        <translation>Esc abbrechen. Fertiges bleibt erhalten.</translation>
    </message>
    <message>
        <source>Ctrl+R train · Click the curve of the excess to take that number of centres · F fit</source>
        <translation>Strg+R trainieren · Klick auf die Überschusskurve übernimmt diese Anzahl der Zentren · F einpassen</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), %1 samples</source>
        <translation>
            <numerusform>%n Lauf, %1 Abtastwerte</numerusform>
            <numerusform>%n Läufe, %1 Abtastwerte</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Look at the runs</source>
        <translation>Läufe ansehen</translation>
    </message>
    <message>
        <source>Train the chosen models and judge them on runs held out</source>
        <translation>Die gewählten Modelle trainieren und auf zurückgehaltenen Läufen bewerten</translation>
    </message>
</context>
<context>
    <name>driftbench::TransientView</name>
    <message>
        <source>What is left of a step at the centre of the chamber, over time</source>
        <translation>Was von einem Schritt in der Mitte der Kammer übrig ist, über der Zeit</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 to ±%2 °C</source>
        <translation>%1 bis ±%2 °C</translation>
    </message>
    <message>
        <source>Nothing to settle</source>
        <translation>Nichts einzuschwingen</translation>
    </message>
    <message>
        <source>The step is within what the thermometer can tell.</source>
        <translation>Der Schritt liegt innerhalb dessen, was das Thermometer auflöst.</translation>
    </message>
    <message>
        <source>Time after a step of %1 °C</source>
        <translation>Zeit nach einem Schritt von %1 °C</translation>
    </message>
    <message>
        <source>Still to go (°C)</source>
        <translation>Verbleibend (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::UploadSteps</name>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Rücklesen</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Verifizieren</translation>
    </message>
    <message>
        <source>Commit</source>
        <translation>Festlegen</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Aktivieren</translation>
    </message>
    <message>
        <source>No upload under way</source>
        <translation>Kein Hochladen im Gange</translation>
    </message>
    <message>
        <source>Upload done</source>
        <translation>Hochladen fertig</translation>
    </message>
    <message>
        <source>Upload, step %1 of 6: %2</source>
        <translation>Hochladen, Schritt %1 von 6: %2</translation>
    </message>
</context>
<context>
    <name>driftbench::VerdictCard</name>
    <message>
        <source>Write the table.</source>
        <translation>Tabelle schreiben.</translation>
    </message>
    <message>
        <source>Write only a constant, or the table with care.</source>
        <translation>Nur eine Konstante schreiben, oder die Tabelle mit Vorsicht.</translation>
    </message>
    <message>
        <source>Write the table with care.</source>
        <translation>Tabelle mit Vorsicht schreiben.</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>Keine Tabelle für %1.</translation>
    </message>
    <message>
        <source>Nothing to write for %1: its bias does not move with temperature.</source>
        <translation>Nichts zu schreiben für %1: Der Bias ändert sich nicht mit der Temperatur.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 times less than a constant</source>
        <translation>%1-mal weniger als eine Konstante</translation>
    </message>
    <message>
        <source>%1 to %2 times less than a constant</source>
        <translation>%1- bis %2-mal weniger als eine Konstante</translation>
    </message>
    <message>
        <source>It was not judged on any run.</source>
        <translation>Auf keinem Lauf bewertet.</translation>
    </message>
    <message>
        <source>It leaves %1 dps rms</source>
        <translation>Rest %1 dps RMS</translation>
    </message>
    <message>
        <source>With the %1 it leaves %2 dps rms</source>
        <translation>Mit „%1“ Rest %2 dps RMS</translation>
    </message>
    <message>
        <source>, over the limit of %1</source>
        <translation>, über dem Grenzwert von %1</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>, %1</translation>
    </message>
    <message>
        <source>, a constant %1</source>
        <translation>, eine Konstante %1</translation>
    </message>
    <message>
        <source>A constant does better on %1.</source>
        <translation>Eine Konstante ist besser auf %1.</translation>
    </message>
    <message>
        <source>The rest is hysteresis, %1 times the noise.</source>
        <translation>Der Rest ist Hysterese, das %1-Fache des Rauschens.</translation>
    </message>
    <message>
        <source>Verdict for %1: %2. %3</source>
        <translation>Urteil für %1: %2. %3</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>With care</source>
        <translation>Mit Vorsicht</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>No drift</source>
        <translation>Keine Drift</translation>
    </message>
    <message numerus="yes">
        <source>fails on %1 of %n runs</source>
        <translation>
            <numerusform>verfehlt: %1 von %n Lauf</numerusform>
            <numerusform>verfehlt: %1 von %n Läufen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>passes on %1 of %n runs</source>
        <translation>
            <numerusform>erfüllt: %1 von %n Lauf</numerusform>
            <numerusform>erfüllt: %1 von %n Läufen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::Workbench</name>
    <message>
        <source>Simulated bridge</source>
        <translation>Simulierte Bridge</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>Gyro-Bridge</translation>
    </message>
</context>
</TS>

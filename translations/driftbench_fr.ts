<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>SimulatedTour</name>
    <message>
        <source>Choose where the samples come from.</source>
        <translation>Choisir d’où viennent les échantillons.</translation>
    </message>
    <message>
        <source>The simulated bridge runs the firmware of a real one over a simulated gyro in a chamber. Next uses it.</source>
        <translation>Le pont simulé exécute le firmware d’un vrai pont sur un gyromètre simulé dans une enceinte. Suivant l’utilise.</translation>
    </message>
    <message>
        <source>Plan how the temperature moves.</source>
        <translation>Planifier l’évolution de la température.</translation>
    </message>
    <message>
        <source>From −40 to 85 °C in steps that the datasheets allow. The tour takes three runs instead of five; each is judged by a model of the others.</source>
        <translation>De −40 à 85 °C par échelons que permettent les fiches techniques. La visite prend trois essais au lieu de cinq&#x202f;; chacun est évalué par un modèle des autres.</translation>
    </message>
    <message>
        <source>Record the runs.</source>
        <translation>Acquérir les essais.</translation>
    </message>
    <message>
        <source>Three hours pass in about twelve seconds. Everything is in the session&apos;s file as it comes.</source>
        <translation>Trois heures passent en douze secondes environ. Tout entre au fur et à mesure dans le fichier de la session.</translation>
    </message>
    <message>
        <source>Recording run %1 of %2.</source>
        <translation>Acquisition de l’essai %1 sur %2.</translation>
    </message>
    <message>
        <source>Look at the drift.</source>
        <translation>Regarder la dérive.</translation>
    </message>
    <message>
        <source>Train the models.</source>
        <translation>Entraîner les modèles.</translation>
    </message>
    <message>
        <source>An RBF network and its rivals. Each run is held out once, so that no model is judged on what it has seen.</source>
        <translation>Un réseau RBF et ses rivaux. Chaque essai est réservé une fois, pour qu’aucun modèle ne soit évalué sur ce qu’il a vu.</translation>
    </message>
    <message>
        <source>Read the verdict.</source>
        <translation>Lire le verdict.</translation>
    </message>
    <message>
        <source>For each axis: write the table, only a constant, or nothing, with the reason.</source>
        <translation>Pour chaque axe&#x202f;: écrire la table, seulement une constante, ou rien, avec le motif.</translation>
    </message>
    <message>
        <source>Write the table into the device.</source>
        <translation>Écrire la table dans l’appareil.</translation>
    </message>
    <message>
        <source>Written to the spare bank, read back, verified, and only then made active. Cut off anywhere, the old table stays.</source>
        <translation>Écrite dans la banque libre, relue, vérifiée, et seulement alors activée. En cas de coupure, l’ancienne table reste.</translation>
    </message>
    <message>
        <source>That did not work; the page says why. Try again, or skip it.</source>
        <translation>Cela n’a pas marché&#x202f;; la page dit pourquoi. Réessayer ou passer.</translation>
    </message>
    <message>
        <source>No bridge is chosen; choose the simulated one on the Source page.</source>
        <translation>Aucun pont choisi&#x202f;; choisir le pont simulé à la page Source.</translation>
    </message>
    <message>
        <source>The training ended without a model. Try again, or skip it.</source>
        <translation>L’entraînement s’est terminé sans modèle. Réessayer ou passer.</translation>
    </message>
    <message>
        <source>There is no model to write; go back to Train, or end the tour.</source>
        <translation>Aucun modèle à écrire&#x202f;; revenir à Entraîner ou quitter la visite.</translation>
    </message>
    <message>
        <source>The device computed something else with the new table and has its old one again. Try again, or skip it.</source>
        <translation>L’appareil calculait autrement avec la nouvelle table et a repris l’ancienne. Réessayer ou passer.</translation>
    </message>
    <message>
        <source>The bridge was unplugged. Plug it in and try again, or stop the run and end the tour.</source>
        <translation>Le pont a été débranché. Le rebrancher et réessayer, ou arrêter l’essai et quitter la visite.</translation>
    </message>
    <message>
        <source>Each sample&apos;s error against temperature. Where they lie on one curve, a table can remove it.</source>
        <translation>L’erreur de chaque échantillon selon la température. Sur une seule courbe, une table peut l’éliminer.</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Acquérir</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Inspecter</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Entraîner</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Choose one</source>
        <translation>À choisir</translation>
    </message>
    <message>
        <source>Temperature steps</source>
        <translation>Échelons de T</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>Tracés en direct</translation>
    </message>
    <message>
        <source>Look at the drift</source>
        <translation>Voir la dérive</translation>
    </message>
    <message>
        <source>Fit models</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>Judge the fit</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Write the table</source>
        <translation>Écrire la table</translation>
    </message>
</context>
<context>
    <name>driftbench::AllanView</name>
    <message>
        <source>Allan deviation before and after compensation</source>
        <translation>Écart-type d’Allan avant et après compensation</translation>
    </message>
    <message>
        <source>No Allan deviation</source>
        <translation>Pas d’écart-type d’Allan</translation>
    </message>
    <message>
        <source>It needs a stretch of nine samples or more without a gap.</source>
        <translation>Il faut une plage sans lacune d’au moins neuf échantillons.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>Après, %1</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>Temps de moyennage τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>min. %1 avant, %2 dps après</translation>
    </message>
</context>
<context>
    <name>driftbench::Banner</name>
    <message>
        <source>Line to copy</source>
        <translation>Ligne à copier</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>driftbench::BeforeAfterView</name>
    <message>
        <source>Rates before and after compensation</source>
        <translation>Vitesses avant et après compensation</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>Vitesse %1 (dps)</translation>
    </message>
    <message>
        <source>%1 dps rms raw</source>
        <translation>%1 dps rms brut</translation>
    </message>
    <message>
        <source>%1 dps rms comp.</source>
        <translation>%1 dps rms comp.</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Nothing to compare yet</source>
        <translation>Rien à comparer</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>Entraîner un modèle et choisir un essai qu’il n’a pas vu.</translation>
    </message>
    <message>
        <source>Raw, mean and range</source>
        <translation>Brut, moyenne et étendue</translation>
    </message>
    <message>
        <source>Compensated, %1</source>
        <translation>Compensé, %1</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>Temps écoulé</translation>
    </message>
</context>
<context>
    <name>driftbench::BridgeModel</name>
    <message>
        <source>Simulated bridge</source>
        <translation>Pont simulé</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>Pont gyro</translation>
    </message>
    <message>
        <source>%1, USB to I2C</source>
        <translation>%1, USB vers I2C</translation>
    </message>
    <message>
        <source>inside this program</source>
        <translation>dans ce programme</translation>
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
        <translation>Flux actif</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>In use here</source>
        <translation>Utilisé ici</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Not permitted</source>
        <translation>Non autorisé</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Occupé</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>Débranché</translation>
    </message>
    <message>
        <source>No gyro answers</source>
        <translation>Gyromètre muet</translation>
    </message>
    <message>
        <source>Bus stuck</source>
        <translation>Bus bloqué</translation>
    </message>
    <message>
        <source>Other version</source>
        <translation>Autre version</translation>
    </message>
    <message>
        <source>Unknown gyro</source>
        <translation>Gyromètre inconnu</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>Inutilisable</translation>
    </message>
    <message>
        <source>start here if you have no hardware</source>
        <translation>commencer ici sans matériel</translation>
    </message>
</context>
<context>
    <name>driftbench::CentresView</name>
    <message>
        <source>Number of centres</source>
        <translation>Nombre de centres</translation>
    </message>
    <message>
        <source>RBF training</source>
        <translation>RBF, entraînement</translation>
    </message>
    <message>
        <source>RBF held out</source>
        <translation>RBF, réservé</translation>
    </message>
    <message>
        <source>%1 chosen</source>
        <translation>choix&#x202f;: %1</translation>
    </message>
    <message>
        <source>RBF, temperature blocks left out</source>
        <translation>RBF, blocs de température réservés</translation>
    </message>
    <message>
        <source>RBF held out, mean of %1</source>
        <translation>RBF, réservé, moyenne de %1</translation>
    </message>
    <message>
        <source>RBF held out, mean</source>
        <translation>RBF, réservé, moyenne</translation>
    </message>
    <message>
        <source>Excess over the noise floor</source>
        <translation>Excès sur le plancher de bruit</translation>
    </message>
    <message>
        <source>lowest to highest run</source>
        <translation>essai min. à max.</translation>
    </message>
    <message>
        <source>lowest to highest block</source>
        <translation>bloc min. à max.</translation>
    </message>
    <message>
        <source>Chosen number</source>
        <translation>Nombre choisi</translation>
    </message>
    <message>
        <source>Excess MSD (%)</source>
        <translation>Excès MSD (%)</translation>
    </message>
    <message>
        <source>Excess over the noise floor against the number of centres</source>
        <translation>Excès sur le plancher de bruit selon le nombre de centres</translation>
    </message>
    <message>
        <source>The curve, its centres and their widths</source>
        <translation>La courbe, ses centres et leurs largeurs</translation>
    </message>
    <message>
        <source>Centres of the RBF network</source>
        <translation>Centres du réseau RBF</translation>
    </message>
    <message>
        <source>The curve, less its straight line</source>
        <translation>La courbe, moins sa droite</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>Réseau RBF</translation>
    </message>
    <message>
        <source>Means of 1 °C</source>
        <translation>Moyennes sur 1 °C</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Width, ±1 σ</source>
        <translation>Largeur, ±1 σ</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>TDE less line (dps)</source>
        <translation>TDE moins droite (dps)</translation>
    </message>
    <message>
        <source>No RBF network yet</source>
        <translation>Aucun réseau RBF</translation>
    </message>
    <message>
        <source>Train one to see how many centres it needs.</source>
        <translation>En entraîner un pour voir combien de centres il lui faut.</translation>
    </message>
    <message>
        <source>No choice was made</source>
        <translation>Aucun choix n’a été fait</translation>
    </message>
    <message>
        <source>The number of centres was given, so none was tried.</source>
        <translation>Le nombre de centres était donné, aucun n’a donc été essayé.</translation>
    </message>
</context>
<context>
    <name>driftbench::CoachStrip</name>
    <message>
        <source>Guided tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Guided tour, %1 of %2</source>
        <translation>Visite guidée, %1 sur %2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>Quitter la visite</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparePage</name>
    <message>
        <source>Held-out run</source>
        <translation>Essai réservé</translation>
    </message>
    <message>
        <source>Comparison of the models on the held-out run</source>
        <translation>Comparaison des modèles sur l’essai réservé</translation>
    </message>
    <message>
        <source>Limit of what may be left, rms</source>
        <translation>Limite du reste admis, rms</translation>
    </message>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>Progression du rapport</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>évaluation</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML, one file (*.html)</source>
        <translation>HTML, un seul fichier (*.html)</translation>
    </message>
    <message>
        <source>There is nothing to report yet.</source>
        <translation>Il n’y a encore rien à rapporter.</translation>
    </message>
    <message>
        <source>Train a model first; its runs must be readable.</source>
        <translation>Entraîner d’abord un modèle&#x202f;; ses essais doivent être lisibles.</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>Rapport écrit dans %1.</translation>
    </message>
    <message>
        <source>The report is written.</source>
        <translation>Le rapport est écrit.</translation>
    </message>
    <message>
        <source>The report was not written.</source>
        <translation>Le rapport n’a pas été écrit.</translation>
    </message>
    <message>
        <source>Models against a constant, on runs they have not seen</source>
        <translation>Modèles face à une constante, sur des essais non vus</translation>
    </message>
    <message>
        <source>%1 against a constant, on runs it has not seen</source>
        <translation>%1 face à une constante, sur des essais non vus</translation>
    </message>
    <message>
        <source>The models are trained and judged on runs held out.</source>
        <translation>Les modèles sont entraînés et évalués sur des essais réservés.</translation>
    </message>
    <message>
        <source>Nothing to judge</source>
        <translation>Rien à évaluer</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>Entraîner d’abord un modèle.</translation>
    </message>
    <message>
        <source>%1 of 3 axes: yes</source>
        <translation>%1/3 axes&#x202f;: oui</translation>
    </message>
    <message>
        <source>1, 2, 3 choose the held-out run · Wheel zoom · Drag pan · Double-click fit · Ctrl+E export what is visible</source>
        <translation>1, 2, 3 choisir l’essai réservé · Molette zoom · Glisser déplacer · Double-clic cadrer · Ctrl+E exporter la vue</translation>
    </message>
    <message numerus="yes">
        <source>%n held-out run(s)</source>
        <translation>
            <numerusform>%n essai réservé</numerusform>
            <numerusform>%n essais réservés</numerusform>
        </translation>
    </message>
    <message>
        <source>Judged: anchored</source>
        <translation>Évaluation&#x202f;: ancrée</translation>
    </message>
    <message>
        <source>Judged: absolute</source>
        <translation>Évaluation&#x202f;: absolue</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>What may be left on a held-out run, rms. Zero: no limit.</source>
        <translation>Reste admis sur un essai réservé, rms. Zéro&#x202f;: pas de limite.</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolue</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>Ancrée</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Everything found as PDF or as one HTML file</source>
        <translation>Tous les résultats en PDF ou en un seul fichier HTML</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Entraîner</translation>
    </message>
    <message>
        <source>Held-out run %1</source>
        <translation>Essai réservé %1</translation>
    </message>
    <message>
        <source>The report was cancelled.</source>
        <translation>Le rapport a été annulé.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparisonTableModel</name>
    <message>
        <source>Pass</source>
        <translation>Réussi</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>MSD1
before</source>
        <translation>MSD1
avant</translation>
    </message>
    <message>
        <source>MSD4
Conv. 1</source>
        <translation>MSD4
Conv. 1</translation>
    </message>
    <message>
        <source>MSD5
Conv. 2</source>
        <translation>MSD5
Conv. 2</translation>
    </message>
    <message>
        <source>MSD6
Novel</source>
        <translation>MSD6
Nouveau</translation>
    </message>
    <message>
        <source>Q3
Conv. 1</source>
        <translation>Q3
Conv. 1</translation>
    </message>
    <message>
        <source>Q4
Conv. 2</source>
        <translation>Q4
Conv. 2</translation>
    </message>
    <message>
        <source>Q5
Novel</source>
        <translation>Q5
Nouveau</translation>
    </message>
    <message>
        <source>Q4 − Q3
% of Q3</source>
        <translation>Q4 − Q3
% de Q3</translation>
    </message>
    <message>
        <source>Q5 − Q3
% of Q3</source>
        <translation>Q5 − Q3
% de Q3</translation>
    </message>
    <message>
        <source>Q5 − Q4
% of Q4</source>
        <translation>Q5 − Q4
% de Q4</translation>
    </message>
    <message>
        <source>MSD
cubic</source>
        <translation>MSD
cubique</translation>
    </message>
    <message>
        <source>MSD
constant</source>
        <translation>MSD
constante</translation>
    </message>
    <message>
        <source>MSD
floor</source>
        <translation>MSD
plancher</translation>
    </message>
    <message>
        <source>Left
dps rms</source>
        <translation>Reste
dps rms</translation>
    </message>
    <message>
        <source>Limit
%1</source>
        <translation>Limite
%1</translation>
    </message>
    <message>
        <source>Limit
none</source>
        <translation>Limite
aucune</translation>
    </message>
</context>
<context>
    <name>driftbench::CoverageView</name>
    <message>
        <source>Coverage of the temperature range</source>
        <translation>Couverture de la plage de température</translation>
    </message>
    <message>
        <source>No coverage yet</source>
        <translation>Aucune couverture</translation>
    </message>
    <message>
        <source>It shows where the temperature has been.</source>
        <translation>Elle montre où la température est passée.</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>s per °C</source>
        <translation>s par °C</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Chauffe</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Refroidissement</translation>
    </message>
</context>
<context>
    <name>driftbench::CurvePanelsView</name>
    <message>
        <source>No curves</source>
        <translation>Aucune courbe</translation>
    </message>
    <message>
        <source>There is nothing to draw over this range.</source>
        <translation>Il n’y a rien à tracer sur cette plage.</translation>
    </message>
</context>
<context>
    <name>driftbench::DataTable</name>
    <message>
        <source>Copy selected cells</source>
        <translation>Copier la sélection</translation>
    </message>
    <message>
        <source>Copy table as text</source>
        <translation>Copier le tableau en texte</translation>
    </message>
    <message>
        <source>Copy table as CSV</source>
        <translation>Copier le tableau en CSV</translation>
    </message>
    <message>
        <source>Copy table as Markdown</source>
        <translation>Copier le tableau en Markdown</translation>
    </message>
    <message>
        <source>Copy table as LaTeX</source>
        <translation>Copier le tableau en LaTeX</translation>
    </message>
</context>
<context>
    <name>driftbench::DevicePanel</name>
    <message>
        <source>On the device now against what would be written</source>
        <translation>Contenu actuel de l’appareil face à ce qui serait écrit</translation>
    </message>
    <message>
        <source>%1 of %2 B</source>
        <translation>%1 sur %2 o</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Activating and checking</source>
        <translation>Activation et contrôle</translation>
    </message>
    <message>
        <source>Writing the spare bank</source>
        <translation>Écriture de la banque libre</translation>
    </message>
    <message>
        <source>The table in use stays active until the last step.</source>
        <translation>La table en service reste active jusqu’à la dernière étape.</translation>
    </message>
    <message>
        <source>Write to the device</source>
        <translation>Écrire dans l’appareil</translation>
    </message>
    <message>
        <source>Read back and verified. This device can&apos;t show its compensation at work.</source>
        <translation>Relue et vérifiée. Cet appareil ne peut pas montrer sa compensation à l’œuvre.</translation>
    </message>
    <message>
        <source>Rolled back: %1 of %2 samples differ from what the host computes, by up to %3 dps.</source>
        <translation>Retour arrière&#x202f;: %1 échantillons sur %2 diffèrent du calcul de l’hôte, de %3 dps au plus.</translation>
    </message>
    <message numerus="yes">
        <source>Verified at work: %n sample(s) compared with what the host computes, none differs.</source>
        <translation>
            <numerusform>Vérifiée à l’œuvre&#x202f;: %n échantillon comparé au calcul de l’hôte, sans écart.</numerusform>
            <numerusform>Vérifiée à l’œuvre&#x202f;: %n échantillons comparés au calcul de l’hôte, sans écart.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Not written</source>
        <translation>Non écrite</translation>
    </message>
    <message>
        <source>The upload was cancelled.</source>
        <translation>Le transfert a été annulé.</translation>
    </message>
    <message>
        <source>The table was not written.</source>
        <translation>La table n’a pas été écrite.</translation>
    </message>
    <message>
        <source>gen. %1</source>
        <translation>gén. %1</translation>
    </message>
    <message>
        <source>bank %1</source>
        <translation>banque %1</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Bank %1 is in use</source>
        <translation>La banque %1 est en service</translation>
    </message>
    <message>
        <source>The new table was rolled back.</source>
        <translation>Retour arrière sur la nouvelle table.</translation>
    </message>
    <message>
        <source>The table is on the device.</source>
        <translation>La table est dans l’appareil.</translation>
    </message>
    <message>
        <source>The table before was not restored.</source>
        <translation>La table précédente n’a pas été restaurée.</translation>
    </message>
    <message>
        <source>Bank %1, generation %2, is in use again.</source>
        <translation>La banque %1, génération %2, est de nouveau en service.</translation>
    </message>
    <message>
        <source>No table is in use any more; the device sends raw rates.</source>
        <translation>Plus aucune table n’est en service&#x202f;; l’appareil envoie des vitesses brutes.</translation>
    </message>
    <message>
        <source>The table was taken out of use.</source>
        <translation>La table a été mise hors service.</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>inconnu ici</translation>
    </message>
    <message>
        <source>fixed point</source>
        <translation>fixe</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>on the die</source>
        <translation>sur la puce</translation>
    </message>
    <message>
        <source>external</source>
        <translation>externe</translation>
    </message>
    <message>
        <source>Bank, generation</source>
        <translation>Banque, gén.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Range, rows</source>
        <translation>Plage, lignes</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Capteur</translation>
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
        <translation>%1, %2, active</translation>
    </message>
    <message>
        <source>no image: see Files</source>
        <translation>pas d’image&#x202f;: voir Fichiers</translation>
    </message>
    <message>
        <source>On the device now</source>
        <translation>Dans l’appareil</translation>
    </message>
    <message>
        <source>Would be written</source>
        <translation>À écrire</translation>
    </message>
    <message>
        <source>Device %1</source>
        <translation>Appareil %1</translation>
    </message>
    <message>
        <source>%1, firmware %2, simulated</source>
        <translation>%1, firmware %2, simulé</translation>
    </message>
    <message>
        <source>%1, firmware %2</source>
        <translation>%1, firmware %2</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>No device chosen</source>
        <translation>Aucun appareil choisi</translation>
    </message>
    <message>
        <source>Choose the simulated bridge or a plugged-in one as source.</source>
        <translation>Choisir comme source le pont simulé ou un pont branché.</translation>
    </message>
    <message>
        <source>No tables there</source>
        <translation>Pas de tables ici</translation>
    </message>
    <message>
        <source>Looking at the device</source>
        <translation>Lecture de l’appareil</translation>
    </message>
    <message>
        <source>Bank %1 active</source>
        <translation>Banque %1 active</translation>
    </message>
    <message>
        <source>No table active</source>
        <translation>Aucune table active</translation>
    </message>
    <message>
        <source>%1, the spare bank being written</source>
        <translation>%1, écriture de la banque libre</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Activation not confirmed</source>
        <translation>Activation non confirmée</translation>
    </message>
    <message>
        <source>Look at the device to see which table is in use.</source>
        <translation>Interroger l’appareil pour savoir quelle table est en service.</translation>
    </message>
    <message>
        <source>The table that was in use still is.</source>
        <translation>La table qui était en service l’est toujours.</translation>
    </message>
    <message>
        <source>The activation was not confirmed.</source>
        <translation>L’activation n’a pas été confirmée.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>conseillé</translation>
    </message>
    <message>
        <source>%1 to %2 °C, %3</source>
        <translation>%1 à %2 °C, %3</translation>
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
        <translation>Heure</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Événement</translation>
    </message>
</context>
<context>
    <name>driftbench::ExcludedModel</name>
    <message>
        <source>non-finite</source>
        <translation>non fini</translation>
    </message>
    <message>
        <source>bad time</source>
        <translation>temps erroné</translation>
    </message>
    <message>
        <source>start-up</source>
        <translation>démarrage</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturé</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>mouvement</translation>
    </message>
    <message>
        <source>temperature fault</source>
        <translation>défaut de température</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>aberrant</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Time (%1)</source>
        <translation>Temps (%1)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Motif</translation>
    </message>
</context>
<context>
    <name>driftbench::ExclusionStrip</name>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>Drift error over time</source>
        <translation>Erreur de dérive selon le temps</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>Aucun échantillon</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Acquérir un essai, ou ouvrir un fichier journal.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Exclu</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Chauffe</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Refroidissement</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Sélection</translation>
    </message>
</context>
<context>
    <name>driftbench::ExportPage</name>
    <message>
        <source>Table preview</source>
        <translation>Aperçu de la table</translation>
    </message>
    <message>
        <source>Recommended of each axis</source>
        <translation>Modèle conseillé par axe</translation>
    </message>
    <message>
        <source>There is no table to write.</source>
        <translation>Il n’y a pas de table à écrire.</translation>
    </message>
    <message>
        <source>The table for the device</source>
        <translation>La table pour l’appareil</translation>
    </message>
    <message>
        <source>Into the spare bank; the one in use stays until the end</source>
        <translation>Dans la banque libre&#x202f;; celle en service reste jusqu’à la fin</translation>
    </message>
    <message>
        <source>There is no table to write</source>
        <translation>Il n’y a pas de table à écrire</translation>
    </message>
    <message>
        <source>A table is being written</source>
        <translation>Une table est en cours d’écriture</translation>
    </message>
    <message>
        <source>No device with tables is there</source>
        <translation>Aucun appareil à tables n’est présent</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>Dossier des fichiers</translation>
    </message>
    <message>
        <source>The files were not written.</source>
        <translation>Les fichiers n’ont pas été écrits.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1.</source>
        <translation>
            <numerusform>%n fichier écrit dans %1.</numerusform>
            <numerusform>%n fichiers écrits dans %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written.</source>
        <translation>
            <numerusform>%n fichier écrit.</numerusform>
            <numerusform>%n fichiers écrits.</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing, %1 %</source>
        <translation>Écriture, %1 %</translation>
    </message>
    <message>
        <source>Table on %1</source>
        <translation>Dans %1</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written</source>
        <translation>
            <numerusform>%n fichier écrit</numerusform>
            <numerusform>%n fichiers écrits</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing written</source>
        <translation>Rien d’écrit</translation>
    </message>
    <message>
        <source>Esc cancel, the old table stays · Ctrl+S save the files</source>
        <translation>Échap annuler, l’ancienne table reste · Ctrl+S enregistrer les fichiers</translation>
    </message>
    <message>
        <source>Ctrl+S save the files · Ctrl+U write to the device · F5 look again · Ctrl+C copy the selected cells</source>
        <translation>Ctrl+S enregistrer les fichiers · Ctrl+U écrire dans l’appareil · F5 actualiser · Ctrl+C copier la sélection</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Write to device</source>
        <translation>Écrire dans l’appareil</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Takes the table out of use; the one before it takes over</source>
        <translation>Met la table hors service&#x202f;; la précédente prend le relais</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>Choisir une source</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Entraîner</translation>
    </message>
    <message>
        <source>No model yet</source>
        <translation>Aucun modèle</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>Entraîner d’abord un modèle.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Shown form</source>
        <translation>Forme affichée</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Aperçu du fichier</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
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
        <translation>En-tête C</translation>
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
        <translation>Image appareil</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Actualiser</translation>
    </message>
    <message>
        <source>int32, 1 LSB = 2%1 dps = %2 µdps</source>
        <translation>int32, 1 LSB = 2%1 dps = %2 µdps</translation>
    </message>
    <message>
        <source>Table of %1 rows, %2 °C apart.</source>
        <translation>%1 lignes tous les %2 °C</translation>
    </message>
    <message>
        <source>Axes without a yes are written too.</source>
        <translation>Les axes sans oui sont écrits aussi.</translation>
    </message>
    <message>
        <source>Compare says what that costs on runs held out.</source>
        <translation>Comparer dit ce que cela coûte sur les essais réservés.</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>Pas de table pour %1.</translation>
    </message>
    <message>
        <source>It does not help on runs held out; Compare has the figures. Its values are zero.</source>
        <translation>Elle n’aide pas sur les essais réservés&#x202f;; Comparer donne les chiffres. Des zéros y figurent.</translation>
    </message>
</context>
<context>
    <name>driftbench::FileChoices</name>
    <message>
        <source>Largest interpolation error</source>
        <translation>Erreur d’interpolation max.</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>cubic, loses nothing</source>
        <translation>cubique, sans perte</translation>
    </message>
    <message>
        <source>cubic only: up to %1 mdps off on %2, %3 rms</source>
        <translation>cubique seule&#x202f;: écart max. %1 mdps sur %2, %3 rms</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>%1 sur %2 choisis</translation>
    </message>
    <message numerus="yes">
        <source>table, %n row(s)</source>
        <translation>
            <numerusform>table, %n ligne</numerusform>
            <numerusform>table, %n lignes</numerusform>
        </translation>
    </message>
    <message>
        <source>table in both kinds and where it comes from, exact</source>
        <translation>table sous les deux types et sa provenance, exacte</translation>
    </message>
    <message>
        <source>float and fixed point, %1 bytes</source>
        <translation>virgule flottante et fixe, %1 octets</translation>
    </message>
    <message>
        <source>one bank, %1 bytes</source>
        <translation>une banque, %1 octets</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
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
        <translation>En-tête C</translation>
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
        <translation>Image appareil</translation>
    </message>
    <message>
        <source>Also axes without a yes</source>
        <translation>Aussi les axes sans oui</translation>
    </message>
    <message>
        <source>Axes whose verdict is not yes are left out unless this is on; the files say so.</source>
        <translation>Les axes dont le verdict n’est pas oui sont omis, sauf si cette option est active&#x202f;; les fichiers l’indiquent.</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Erreur max.</translation>
    </message>
    <message>
        <source>PX4 device id</source>
        <translation>ID d’appareil PX4</translation>
    </message>
    <message>
        <source>By which PX4 knows the gyro again: its parameter TC_G0_ID. Empty: the serial number.</source>
        <translation>Par lequel PX4 reconnaît le gyromètre&#x202f;: son paramètre TC_G0_ID. Vide&#x202f;: le numéro de série.</translation>
    </message>
    <message>
        <source>needs the gyro&apos;s device id, below</source>
        <translation>exige l’identifiant du gyro, ci-dessous</translation>
    </message>
    <message>
        <source>needs the sensor&apos;s name: state it when you open the log</source>
        <translation>exige le capteur&#x202f;: l’indiquer à l’ouverture du journal</translation>
    </message>
</context>
<context>
    <name>driftbench::FileSurvey</name>
    <message>
        <source>Span too small to fit</source>
        <translation>Plage trop petite pour ajuster</translation>
    </message>
    <message>
        <source>Temperature stands still</source>
        <translation>Température constante</translation>
    </message>
    <message>
        <source>Too short to fit</source>
        <translation>Trop court pour ajuster</translation>
    </message>
    <message>
        <source>Can&apos;t be used as it is</source>
        <translation>Inutilisable tel quel</translation>
    </message>
    <message>
        <source>No drift found</source>
        <translation>Aucune dérive trouvée</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1&#x202f;: hystérésis</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Session</translation>
    </message>
    <message>
        <source>Can&apos;t be opened</source>
        <translation>Impossible à ouvrir</translation>
    </message>
    <message>
        <source>Run %1 to do</source>
        <translation>Essai %1 à faire</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>Aucun essai</translation>
    </message>
    <message>
        <source>Ready to train</source>
        <translation>Prêt à entraîner</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>N’existe plus</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>Format inconnu</translation>
    </message>
    <message>
        <source>Large: looked at when opened</source>
        <translation>Volumineux&#x202f;: examiné à l’ouverture</translation>
    </message>
    <message>
        <source>Can&apos;t be read</source>
        <translation>Illisible</translation>
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
        <translation>Le premier qui répond</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>Gyromètre</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Pleine échelle</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermomètre</translation>
    </message>
    <message>
        <source>Die offset</source>
        <translation>Décalage puce</translation>
    </message>
    <message>
        <source>Bus speed</source>
        <translation>Débit du bus</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>Externe, sinon puce</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>Sur la puce</translation>
    </message>
    <message>
        <source>0 takes the gyro&apos;s usual rate.</source>
        <translation>0 prend la cadence usuelle du gyromètre.</translation>
    </message>
    <message>
        <source>Of the gyro&apos;s own thermometer, which only tells differences.</source>
        <translation>Du thermomètre propre au gyromètre, qui ne donne que des écarts.</translation>
    </message>
    <message>
        <source>which gyro it is</source>
        <translation>désigne le gyromètre</translation>
    </message>
    <message>
        <source>The gyro can&apos;t say it itself; it keeps runs of different gyros apart.</source>
        <translation>Le gyromètre ne peut pas le dire lui-même&#x202f;; il distingue les essais de gyromètres différents.</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectPage</name>
    <message>
        <source>What is plotted</source>
        <translation>Ce qui est tracé</translation>
    </message>
    <message>
        <source>name the reason</source>
        <translation>saisie du motif</translation>
    </message>
    <message>
        <source>Against TCQ</source>
        <translation>Selon TCQ</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Selon le temps</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>exclude %1 s of %2</source>
        <translation>exclusion de %1 s de %2</translation>
    </message>
    <message>
        <source>include a stretch of %1</source>
        <translation>inclusion d’une plage de %1</translation>
    </message>
    <message>
        <source>move an excluded stretch of %1</source>
        <translation>déplacement d’une plage exclue de %1</translation>
    </message>
    <message>
        <source>The plan can&apos;t be changed.</source>
        <translation>Le plan ne peut pas être modifié.</translation>
    </message>
    <message>
        <source>The runs are not read</source>
        <translation>Les essais ne sont pas lus</translation>
    </message>
    <message>
        <source>Come back to this page to read them again.</source>
        <translation>Revenir à cette page pour les relire.</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>Aucun essai</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Acquérir un essai, ou ouvrir un fichier journal.</translation>
    </message>
    <message>
        <source>The runs can&apos;t be read.</source>
        <translation>Les essais ne peuvent pas être lus.</translation>
    </message>
    <message>
        <source>Reading the runs</source>
        <translation>Lecture des essais</translation>
    </message>
    <message>
        <source>Fitted curve, ±1 σ of its residuals</source>
        <translation>Courbe ajustée, ±1 σ de ses résidus</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE, %1 (dps)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <translation>%1, essai %2</translation>
    </message>
    <message>
        <source>%1, runs %2</source>
        <translation>%1, essais %2</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Chauffe</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Refroidissement</translation>
    </message>
    <message>
        <source>TDE against the temperature quantities</source>
        <translation>TDE selon les grandeurs de température</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference from the holds</source>
        <translation>TDE de %1 selon la température, référence tirée des paliers</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference %2 dps</source>
        <translation>TDE de %1, référence %2 dps</translation>
    </message>
    <message>
        <source>heating again</source>
        <translation>chauffe à nouveau</translation>
    </message>
    <message>
        <source>heating</source>
        <translation>chauffe</translation>
    </message>
    <message>
        <source>cooling again</source>
        <translation>refroidissement à nouveau</translation>
    </message>
    <message>
        <source>cooling</source>
        <translation>refroidissement</translation>
    </message>
    <message>
        <source>%1 dps (%2)</source>
        <translation>%1 dps (%2)</translation>
    </message>
    <message>
        <source>These runs can&apos;t be calibrated as they are.</source>
        <translation>Ces essais ne peuvent pas être étalonnés tels quels.</translation>
    </message>
    <message>
        <source>%1 is not a curve of temperature.</source>
        <translation>%1 n’est pas fonction de la température.</translation>
    </message>
    <message>
        <source>No table over temperature can remove this.</source>
        <translation>Aucune table en température ne peut l’éliminer.</translation>
    </message>
    <message>
        <source>At %1 °C it reads %2.</source>
        <translation>À %1 °C, on lit %2.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Constat</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>Findings of the checks</source>
        <translation>Constats des contrôles</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>Inclure</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Exclure</translation>
    </message>
    <message>
        <source>Drag in the time strip to select a stretch first.</source>
        <translation>Glisser d’abord dans la bande de temps pour sélectionner une plage.</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Constats (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>Can&apos;t be calibrated</source>
        <translation>Étalonnage impossible</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1&#x202f;: hystérésis</translation>
    </message>
    <message>
        <source>Drag in the time strip to select · Delete exclude · Ctrl+Z undo · X, Y, Z choose the axis · Double-click fit</source>
        <translation>Glisser dans la bande de temps sélectionner · Suppr exclure · Ctrl+Z annuler · X, Y, Z choisir l’axe · Double-clic cadrer</translation>
    </message>
    <message>
        <source>%1, %2 samples at %3 Hz</source>
        <translation>%1, %2 échantillons à %3 Hz</translation>
    </message>
    <message>
        <source>%1 excluded</source>
        <translation>%1 exclus</translation>
    </message>
    <message numerus="yes">
        <source>exclude %1 s in %n stretches</source>
        <translation>
            <numerusform>exclusion de %1 s en %n plage</numerusform>
            <numerusform>exclusion de %1 s en %n plages</numerusform>
        </translation>
    </message>
    <message>
        <source>Each point is the mean of %1 samples</source>
        <translation>Chaque point est la moyenne de %1 échantillons</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectSide</name>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Couverture</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Exclu</translation>
    </message>
    <message>
        <source>Excluded stretches</source>
        <translation>Plages exclues</translation>
    </message>
    <message>
        <source>Swing of TDE</source>
        <translation>Excursion TDE</translation>
    </message>
    <message>
        <source>Noise within 0.5 °C</source>
        <translation>Bruit sur 0,5 °C</translation>
    </message>
    <message>
        <source>Left by the curve</source>
        <translation>Reste de la courbe</translation>
    </message>
    <message>
        <source>That is</source>
        <translation>Soit</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Heated and cooled</source>
        <translation>Chauffé et refroidi</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>A curve of T</source>
        <translation>Fonction de T</translation>
    </message>
    <message>
        <source>Nearly a curve of T</source>
        <translation>Presque fonction de T</translation>
    </message>
    <message>
        <source>Not a curve of T</source>
        <translation>Pas fonction de T</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>spread at %1 °C</source>
        <translation>écart à %1 °C</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>excursion</translation>
    </message>
    <message>
        <source>%1 in figures</source>
        <translation>%1 en chiffres</translation>
    </message>
    <message>
        <source>%1 dps rms</source>
        <translation>%1 dps rms</translation>
    </message>
    <message>
        <source>%1 × the noise</source>
        <translation>%1 × le bruit</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1 à %2 °C</translation>
    </message>
    <message>
        <source>%1 % of it</source>
        <translation>%1 % de la plage</translation>
    </message>
</context>
<context>
    <name>driftbench::IntervalPanel</name>
    <message>
        <source>Smallest rate step, ΔE&lt;sub&gt;S&lt;/sub&gt;</source>
        <translation>Plus petit pas de vitesse, ΔE&lt;sub&gt;S&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>Bias with T, γ′ = %1 × %2/%3</source>
        <translation>Biais selon T, γ′ = %1 × %2/%3</translation>
    </message>
    <message>
        <source>mdps/°C</source>
        <translation>mdps/°C</translation>
    </message>
    <message>
        <source>Sensitivity with T, β</source>
        <translation>Sensibilité selon T, β</translation>
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
        <translation>utilisé, au plus %1</translation>
    </message>
    <message>
        <source>used, but above %1</source>
        <translation>utilisé, mais dépasse %1</translation>
    </message>
    <message>
        <source>The paper prints β with the span squared, which gives %1 mdps/°C. Half the span gives the value it uses, %2.</source>
        <translation>L’article imprime β avec la pleine échelle au carré, ce qui donne %1 mdps/°C. La moitié de celle-ci donne la valeur qu’il utilise, %2.</translation>
    </message>
</context>
<context>
    <name>driftbench::JudgedRunView</name>
    <message>
        <source>Held-out run before and after compensation, and its Allan deviation</source>
        <translation>Essai réservé avant et après compensation, et son écart-type d’Allan</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>Après, %1</translation>
    </message>
    <message>
        <source>After, %1 trained on %2</source>
        <translation>Après, %1 entraîné sur %2</translation>
    </message>
    <message>
        <source>Before, less the constant</source>
        <translation>Avant, moins la constante</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Limit ±%1 dps</source>
        <translation>Limite ±%1 dps</translation>
    </message>
    <message>
        <source>TDE left (dps)</source>
        <translation>TDE restante (dps)</translation>
    </message>
    <message>
        <source>Time in run</source>
        <translation>Temps dans l’essai</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>Temps de moyennage τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>min. %1 avant, %2 dps après</translation>
    </message>
    <message>
        <source>No run to judge</source>
        <translation>Aucun essai à évaluer</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>Entraîner un modèle et choisir un essai qu’il n’a pas vu.</translation>
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
code</translation>
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
        <translation>palier</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>%1: samples missing, %2</source>
        <translation>%1&#x202f;: échantillons manquants, %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n samples dropped, %2</source>
        <translation>
            <numerusform>%1&#x202f;: %n échantillon perdu, %2</numerusform>
            <numerusform>%1&#x202f;: %n échantillons perdus, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::LiveRun</name>
    <message>
        <source>set the reference rate of the run that is recorded</source>
        <translation>réglage de la vitesse de référence de l’essai en acquisition</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveStrips</name>
    <message>
        <source>%1 comp.</source>
        <translation>%1 comp.</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 brut</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveTraceView</name>
    <message>
        <source>Raw, mean and range</source>
        <translation>Brut, moyenne et étendue</translation>
    </message>
    <message>
        <source>Compensated</source>
        <translation>Compensé</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Perdus</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>%1, lowest</source>
        <translation>%1, minimum</translation>
    </message>
    <message>
        <source>%1, mean</source>
        <translation>%1, moyenne</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <translation>%1, maximum</translation>
    </message>
    <message>
        <source>%1 raw (dps)</source>
        <translation>%1 brut (dps)</translation>
    </message>
    <message>
        <source>%1 compensated (dps)</source>
        <translation>%1 compensé (dps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>raw %1 dps</source>
        <translation>brut %1 dps</translation>
    </message>
    <message>
        <source>compensated %1 dps</source>
        <translation>compensé %1 dps</translation>
    </message>
    <message>
        <source>T %1 °C</source>
        <translation>T %1 °C</translation>
    </message>
    <message>
        <source>plan %1 °C</source>
        <translation>plan %1 °C</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>Tracés en direct</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>Temps écoulé (h:min)</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>Temps écoulé (h:min:s)</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>Vitesse %1 (dps)</translation>
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
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
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
        <translation>Mode</translation>
    </message>
    <message>
        <source>Gyro in the log</source>
        <translation>Gyromètre du journal</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Colonne temps</translation>
    </message>
    <message>
        <source>T column</source>
        <translation>Colonne T</translation>
    </message>
    <message>
        <source>x column</source>
        <translation>Colonne x</translation>
    </message>
    <message>
        <source>y column</source>
        <translation>Colonne y</translation>
    </message>
    <message>
        <source>z column</source>
        <translation>Colonne z</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Unité de temps</translation>
    </message>
    <message>
        <source>T unit</source>
        <translation>Unité de T</translation>
    </message>
    <message>
        <source>Rate unit</source>
        <translation>Unité de vitesse</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilité</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>Vitesse de référence</translation>
    </message>
    <message>
        <source>found by its name</source>
        <translation>trouvée par son nom</translation>
    </message>
    <message>
        <source>The name in the header, or the number of the column.</source>
        <translation>Le nom dans l’en-tête, ou le numéro de la colonne.</translation>
    </message>
    <message>
        <source>Read in whole</source>
        <translation>Lire en entier</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Rejouer</translation>
    </message>
    <message>
        <source>Play back, %1 times</source>
        <translation>Rejouer, × %1</translation>
    </message>
    <message>
        <source>The only one</source>
        <translation>Le seul</translation>
    </message>
    <message>
        <source>As the log says</source>
        <translation>Selon le journal</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Capteur</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>as the log says</source>
        <translation>selon le journal</translation>
    </message>
    <message>
        <source>Whose log it is: a device takes a table only for itself, and the report names it.</source>
        <translation>À quel capteur appartient le journal&#x202f;: un appareil n’accepte qu’une table pour lui-même, et le rapport le nomme.</translation>
    </message>
</context>
<context>
    <name>driftbench::MainWindow</name>
    <message>
        <source>Tab next · Enter choose · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>Tab suivant · Entrée choisir · Ctrl+O ouvrir des fichiers · Alt+1 à 7 étapes</translation>
    </message>
    <message>
        <source>Event log</source>
        <translation>Journal des événements</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Session</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aid&amp;e</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Nouvelle session</translation>
    </message>
    <message>
        <source>&amp;Open files…</source>
        <translation>&amp;Ouvrir des fichiers…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Enregistrer la session &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Copy the event log</source>
        <translation>Copier le journal des événements</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Couleurs</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Selon le &amp;système</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>&amp;Event log</source>
        <translation>&amp;Journal des événements</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Page d’&amp;accueil</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;About Driftbench</source>
        <translation>À &amp;propos de Driftbench</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>À propos de &amp;Qt</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aucun fichier</translation>
    </message>
    <message>
        <source>&amp;Save session…</source>
        <translation>&amp;Enregistrer la session…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>&amp;Enregistrer la session</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#x202f;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#x202f;: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Wheel|Zoom at the mouse; over an axis, that axis</source>
        <translation>Molette|Zoom à la souris&#x202f;; sur un axe, cet axe</translation>
    </message>
    <message>
        <source>Drag|Move</source>
        <translation>Glisser|Déplacer</translation>
    </message>
    <message>
        <source>Shift+Drag|Zoom to a box</source>
        <translation>Maj+Glisser|Zoom sur un cadre</translation>
    </message>
    <message>
        <source>Double-click, F|Fit</source>
        <translation>Double-clic, F|Cadrer</translation>
    </message>
    <message>
        <source>Arrows|Move</source>
        <translation>Flèches|Déplacer</translation>
    </message>
    <message>
        <source>+, −|Zoom</source>
        <translation>+, −|Zoom</translation>
    </message>
    <message>
        <source>A, B|Set a cursor at the mouse</source>
        <translation>A, B|Placer un curseur à la souris</translation>
    </message>
    <message>
        <source>Ctrl+E|Export what is visible</source>
        <translation>Ctrl+E|Exporter la vue</translation>
    </message>
    <message>
        <source>About Driftbench</source>
        <translation>À propos de Driftbench</translation>
    </message>
    <message>
        <source>Driftbench %1</source>
        <translation>Driftbench %1</translation>
    </message>
    <message>
        <source>Calibrates the temperature drift of MEMS gyros. Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Étalonne la dérive thermique des gyromètres MEMS. Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure.</translation>
    </message>
    <message>
        <source>Open logs or a session</source>
        <translation>Ouvrir des journaux ou une session</translation>
    </message>
    <message>
        <source>Logs and sessions (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;All files (*)</source>
        <translation>Journaux et sessions (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Enregistrer la session</translation>
    </message>
    <message>
        <source>Sessions (*.driftbench)</source>
        <translation>Sessions (*.driftbench)</translation>
    </message>
    <message>
        <source>New session, not saved yet</source>
        <translation>Nouvelle session, pas encore enregistrée</translation>
    </message>
    <message>
        <source>Unnamed session</source>
        <translation>Session sans nom</translation>
    </message>
    <message>
        <source>Session: %1</source>
        <translation>Session&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 · read-only</source>
        <translation>%1 · lecture seule</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · enregistrée</translation>
    </message>
    <message>
        <source>%1 · not saved</source>
        <translation>%1 · non enregistrée</translation>
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
        <translation>Lacune de %1 à %2 s&#x202f;: %3.</translation>
    </message>
    <message>
        <source>Session restored.</source>
        <translation>Session rétablie.</translation>
    </message>
    <message>
        <source>Recording stopped when the program ended. %1 samples are safe.</source>
        <translation>L’acquisition s’est arrêtée avec le programme. %1 échantillons sont conservés.</translation>
    </message>
    <message>
        <source>It has no name yet; Save gives it one.</source>
        <translation>Elle n’a pas encore de nom&#x202f;; Enregistrer lui en donne un.</translation>
    </message>
    <message>
        <source>Quit Driftbench</source>
        <translation>Quitter Driftbench</translation>
    </message>
    <message>
        <source>A run is being recorded.</source>
        <translation>Un essai est en cours d’acquisition.</translation>
    </message>
    <message>
        <source>The last changes are not on the disk.</source>
        <translation>Les dernières modifications ne sont pas sur le disque.</translation>
    </message>
    <message>
        <source>Quit ends the run. What was recorded is kept.</source>
        <translation>Quitter met fin à l’essai. Ce qui a été acquis est conservé.</translation>
    </message>
    <message>
        <source>Make room or permit the file to be written, then save again.</source>
        <translation>Libérer de la place ou autoriser l’écriture du fichier, puis enregistrer à nouveau.</translation>
    </message>
    <message>
        <source>End the run and quit</source>
        <translation>Terminer l’essai et quitter</translation>
    </message>
    <message>
        <source>Quit and lose them</source>
        <translation>Quitter et les perdre</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>%1 is running.</source>
        <extracomment>%1 is the name of a source</extracomment>
        <translation>%1 est en marche.</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelLabels</name>
    <message>
        <source>RBF network</source>
        <translation>réseau RBF</translation>
    </message>
    <message>
        <source>RBF network, as in the paper</source>
        <translation>réseau RBF, selon l’article</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>réseau BP</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>cubique</translation>
    </message>
    <message>
        <source>cubic, as ArduPilot</source>
        <translation>cubique, comme ArduPilot</translation>
    </message>
    <message>
        <source>line</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>recommended model of each axis</source>
        <translation>modèle conseillé par axe</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>RBF network (Novel)</source>
        <translation>Réseau RBF (Nouveau)</translation>
    </message>
    <message>
        <source>BP 2-%1-1 (Conv. 2)</source>
        <translation>BP 2-%1-1 (Conv. 2)</translation>
    </message>
    <message>
        <source>Cubic (PX4)</source>
        <translation>Cubique (PX4)</translation>
    </message>
    <message>
        <source>Cubic (ArduPilot)</source>
        <translation>Cubique (ArduPilot)</translation>
    </message>
    <message>
        <source>Line (Conv. 1)</source>
        <translation>Droite (Conv. 1)</translation>
    </message>
    <message>
        <source>Constant (bias only)</source>
        <translation>Constante (biais seul)</translation>
    </message>
    <message numerus="yes">
        <source>%n centres</source>
        <translation>
            <numerusform>%n centre</numerusform>
            <numerusform>%n centres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to %2 centres</source>
        <translation>%1 à %2 centres</translation>
    </message>
    <message>
        <source>RBF, %1 (Novel)</source>
        <translation>RBF, %1 (Nouveau)</translation>
    </message>
    <message>
        <source>RBF, paper (Novel)</source>
        <translation>RBF, article (Nouveau)</translation>
    </message>
    <message>
        <source>RBF, paper, %1</source>
        <translation>RBF, article, %1</translation>
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
        <translation>Plancher de bruit</translation>
    </message>
    <message>
        <source>Excess %1
%</source>
        <translation>Excès %1
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
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Durée</translation>
    </message>
</context>
<context>
    <name>driftbench::MsdTrendView</name>
    <message>
        <source>MSD so far</source>
        <translation>MSD à ce stade</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Rien pour l’instant</translation>
    </message>
    <message>
        <source>It begins with the recording.</source>
        <translation>Elle débute avec l’acquisition.</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>Temps écoulé (h:min:s)</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>Temps écoulé (h:min)</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 avant</translation>
    </message>
    <message>
        <source>%1 after</source>
        <translation>%1 après</translation>
    </message>
</context>
<context>
    <name>driftbench::NativeForm</name>
    <message>
        <source>As it is set</source>
        <translation>Selon réglage</translation>
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
        <translation>Cadence</translation>
    </message>
    <message>
        <source>0 leaves the rate that the bridge has now.</source>
        <translation>0 garde la cadence actuelle du pont.</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Pleine échelle</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermomètre</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>Externe, sinon puce</translation>
    </message>
    <message>
        <source>External</source>
        <translation>Externe</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>Sur la puce</translation>
    </message>
    <message>
        <source>Compensated by its own table</source>
        <translation>Compensé par sa propre table</translation>
    </message>
    <message>
        <source>To check a table that was written. A calibration needs raw rates.</source>
        <translation>Pour contrôler une table écrite. Un étalonnage exige des vitesses brutes.</translation>
    </message>
</context>
<context>
    <name>driftbench::OriginChip</name>
    <message>
        <source>Simulated data</source>
        <translation>Données simulées</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>Journal réel</translation>
    </message>
    <message>
        <source>Real device</source>
        <translation>Appareil réel</translation>
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
        <translation>aucune</translation>
    </message>
    <message>
        <source>As printed (kJ, °C)</source>
        <translation>Tel qu’imprimé (kJ, °C)</translation>
    </message>
    <message>
        <source>In SI, °C; in SI, kelvin</source>
        <translation>En SI, °C&#x202f;; en SI, kelvin</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1&#x202f;; %2</translation>
    </message>
    <message>
        <source>Slowest mode of a %1 m cube, still air</source>
        <translation>Mode le plus lent, cube de %1 m, air calme</translation>
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
        <translation>Capteur</translation>
    </message>
    <message>
        <source>Chamber</source>
        <translation>Enceinte</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Pleine échelle</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilité</translation>
    </message>
    <message>
        <source>Bias with T</source>
        <translation>Biais selon T</translation>
    </message>
    <message>
        <source>Inner length</source>
        <translation>Côté intérieur</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermomètre</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>De, à</translation>
    </message>
    <message>
        <source>Lowest temperature</source>
        <translation>Température minimale</translation>
    </message>
    <message>
        <source>Highest temperature</source>
        <translation>Température maximale</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>Toutes les</translation>
    </message>
    <message>
        <source>Hold at the ends</source>
        <translation>Palier aux bouts</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Come back down, to see hysteresis</source>
        <translation>Redescendre, pour voir l’hystérésis</translation>
    </message>
    <message>
        <source>Own figures</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Sensor preset</source>
        <translation>Préréglage du capteur</translation>
    </message>
    <message>
        <source>Chamber preset</source>
        <translation>Préréglage de l’enceinte</translation>
    </message>
</context>
<context>
    <name>driftbench::PlanPage</name>
    <message>
        <source>edit of the plan</source>
        <translation>modification du plan</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1 à %2 °C</translation>
    </message>
    <message>
        <source>None, from a log</source>
        <translation>Aucun, issu d’un journal</translation>
    </message>
    <message>
        <source>Tab next field · Up, Down change a value · Ctrl+Z undo · Ctrl+Enter record</source>
        <translation>Tab champ suivant · Haut, Bas changer une valeur · Ctrl+Z annuler · Ctrl+Entrée acquérir</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Utiliser ce plan</translation>
    </message>
    <message>
        <source>Plan file</source>
        <translation>Fichier de plan</translation>
    </message>
    <message>
        <source>Open plan…</source>
        <translation>Ouvrir un plan…</translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation>Enregistrer le plan…</translation>
    </message>
    <message>
        <source>Save steps for a chamber controller…</source>
        <translation>Enregistrer les échelons pour un régulateur d’enceinte…</translation>
    </message>
    <message>
        <source>Save ramps for a chamber controller…</source>
        <translation>Enregistrer les rampes pour un régulateur d’enceinte…</translation>
    </message>
    <message>
        <source>One run</source>
        <translation>Un essai</translation>
    </message>
    <message>
        <source>Control interval</source>
        <translation>Intervalle de régulation</translation>
    </message>
    <message>
        <source>Eqs. 13, 14, 26, 27</source>
        <translation>Éq. 13, 14, 26, 27</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>Période de régulation</translation>
    </message>
    <message>
        <source>Eqs. 25, 28, and the transient</source>
        <translation>Éq. 25, 28 et le transitoire</translation>
    </message>
    <message>
        <source>, without cooling back</source>
        <translation>, sans refroidissement</translation>
    </message>
    <message>
        <source>What the chamber does in each run, and for how long</source>
        <translation>Ce que fait l’enceinte à chaque essai, et pendant combien de temps</translation>
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
        <translation>Un échelon de %1 est plus court que la stabilisation en air calme&#x202f;: %2.</translation>
    </message>
    <message>
        <source>Stir the air, or place the thermometer on the sensor.</source>
        <translation>Brasser l’air, ou placer le thermomètre sur le capteur.</translation>
    </message>
    <message>
        <source>Open plan</source>
        <translation>Ouvrir un plan</translation>
    </message>
    <message>
        <source>Plans (*.json)</source>
        <translation>Plans (*.json)</translation>
    </message>
    <message>
        <source>Plan read from %1.</source>
        <translation>Plan lu depuis %1.</translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation>Enregistrer le plan</translation>
    </message>
    <message>
        <source>Plan written to %1.</source>
        <translation>Plan écrit dans %1.</translation>
    </message>
    <message>
        <source>Save controller file</source>
        <translation>Enregistrer le fichier du régulateur</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Controller file written to %1.</source>
        <translation>Fichier du régulateur écrit dans %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 a run, %2 samples at %3 Hz · %4 for %n runs</source>
        <translation>
            <numerusform>%1 par essai, %2 échantillons à %3 Hz · %4 pour %n essai</numerusform>
            <numerusform>%1 par essai, %2 échantillons à %3 Hz · %4 pour %n essais</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::PlotInteraction</name>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>Set cursor A here</source>
        <translation>Placer le curseur A ici</translation>
    </message>
    <message>
        <source>Set cursor B here</source>
        <translation>Placer le curseur B ici</translation>
    </message>
    <message>
        <source>Remove the cursors</source>
        <translation>Retirer les curseurs</translation>
    </message>
    <message>
        <source>Export what is visible…</source>
        <translation>Exporter la vue…</translation>
    </message>
    <message>
        <source>Show the data as a table</source>
        <translation>Afficher les données en tableau</translation>
    </message>
    <message>
        <source>Export what is visible</source>
        <translation>Exporter la vue</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Image PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Dessin SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>Tableau CSV (*.csv)</translation>
    </message>
</context>
<context>
    <name>driftbench::PlotTable</name>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Série</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Abscisse</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
</context>
<context>
    <name>driftbench::ProfileView</name>
    <message>
        <source>Set points of one run over time</source>
        <translation>Consignes d’un essai selon le temps</translation>
    </message>
    <message>
        <source>hold %1</source>
        <translation>palier %1</translation>
    </message>
    <message>
        <source>No profile</source>
        <translation>Aucun profil</translation>
    </message>
    <message>
        <source>Put the fields right that are marked.</source>
        <translation>Corriger les champs signalés.</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>Temps écoulé</translation>
    </message>
    <message>
        <source>Set point (°C)</source>
        <translation>Consigne (°C)</translation>
    </message>
    <message numerus="yes">
        <source>%n steps of %1 °C, %2 °C/min</source>
        <translation>
            <numerusform>%n échelon de %1 °C, %2 °C/min</numerusform>
            <numerusform>%n échelons de %1 °C, %2 °C/min</numerusform>
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
        <translation>Vitesse de référence, %1</translation>
    </message>
</context>
<context>
    <name>driftbench::RecentFilesModel</name>
    <message>
        <source>Ready to train</source>
        <translation>Prêt à entraîner</translation>
    </message>
    <message>
        <source>Single run</source>
        <translation>Un seul essai</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Real</source>
        <translation>Réel</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Examen…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Expect</source>
        <translation>À prévoir</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n runs</source>
        <translation>
            <numerusform>%1 sur %n essai</numerusform>
            <numerusform>%1 sur %n essais</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n runs</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RecordPage</name>
    <message>
        <source>Span of the traces</source>
        <translation>Durée des tracés</translation>
    </message>
    <message>
        <source>Quantity of the traces</source>
        <translation>Grandeur des tracés</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>Démarrer l’acquisition</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’acquisition</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>Choisir une source</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Inspecter</translation>
    </message>
    <message>
        <source>Write again</source>
        <translation>Réécrire</translation>
    </message>
    <message>
        <source>Save it elsewhere…</source>
        <translation>Enregistrer ailleurs…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
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
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>TDE</source>
        <translation>TDE</translation>
    </message>
    <message>
        <source>No source is chosen.</source>
        <translation>Aucune source n’est choisie.</translation>
    </message>
    <message>
        <source>Choose the bridge or the file to record from.</source>
        <translation>Choisir le pont ou le fichier à acquérir.</translation>
    </message>
    <message>
        <source>The run can&apos;t be recorded.</source>
        <translation>L’essai ne peut pas être acquis.</translation>
    </message>
    <message>
        <source>The source has ended.</source>
        <translation>La source s’est interrompue.</translation>
    </message>
    <message>
        <source>Run %1 is complete.</source>
        <translation>L’essai %1 est terminé.</translation>
    </message>
    <message>
        <source>Run %1 was stopped at %2.</source>
        <translation>L’essai %1 a été arrêté à %2.</translation>
    </message>
    <message>
        <source>%1 samples are in the session.</source>
        <translation>%1 échantillons sont dans la session.</translation>
    </message>
    <message>
        <source>A part of the run is not on the disk.</source>
        <translation>Une partie de l’essai n’est pas sur le disque.</translation>
    </message>
    <message>
        <source>It is kept in memory.</source>
        <translation>Elle est conservée en mémoire.</translation>
    </message>
    <message>
        <source>The disk is slow.</source>
        <translation>Le disque est lent.</translation>
    </message>
    <message>
        <source>The disk takes no more.</source>
        <translation>Le disque n’accepte plus rien.</translation>
    </message>
    <message>
        <source>Make room on it; recording goes on in memory.</source>
        <translation>Y libérer de la place&#x202f;; l’acquisition continue en mémoire.</translation>
    </message>
    <message>
        <source>All samples are on the disk again.</source>
        <translation>Tous les échantillons sont de nouveau sur le disque.</translation>
    </message>
    <message>
        <source>The memory for samples is full, the run has ended.</source>
        <translation>La mémoire d’échantillons est pleine, l’essai est terminé.</translation>
    </message>
    <message>
        <source>Save what is not on the disk</source>
        <translation>Enregistrer ce qui n’est pas sur le disque</translation>
    </message>
    <message>
        <source>CSV log (*.csv)</source>
        <translation>Journal CSV (*.csv)</translation>
    </message>
    <message>
        <source>The rest of the run is in %1.</source>
        <translation>Le reste de l’essai est dans %1.</translation>
    </message>
    <message>
        <source>The view is paused at %1. Recording goes on.</source>
        <translation>La vue est en pause à %1. L’acquisition continue.</translation>
    </message>
    <message>
        <source>%1 samples have arrived since. The figures on the right stay live.</source>
        <translation>%1 échantillons sont arrivés depuis. Les valeurs à droite restent en direct.</translation>
    </message>
    <message>
        <source>The bridge was unplugged at %1.</source>
        <translation>Le pont a été débranché à %1.</translation>
    </message>
    <message>
        <source>Plug it in to go on with this run.</source>
        <translation>Le rebrancher pour poursuivre cet essai.</translation>
    </message>
    <message>
        <source>No samples have come for %1 s.</source>
        <translation>Aucun échantillon reçu depuis %1 s.</translation>
    </message>
    <message>
        <source>Look at the cable and the bridge; the run goes on as soon as they come again.</source>
        <translation>Vérifier le câble et le pont&#x202f;; l’essai continue dès que les échantillons reviennent.</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>Essai %1 sur %2</translation>
    </message>
    <message>
        <source>%1, no model yet</source>
        <translation>%1, sans modèle</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1, compensated by the model of %2</source>
        <translation>%1, compensé par le modèle de %2</translation>
    </message>
    <message>
        <source>Resume view</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Pause</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) in the session</source>
        <translation>
            <numerusform>%n essai dans la session</numerusform>
            <numerusform>%n essais dans la session</numerusform>
        </translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>Aucun essai</translation>
    </message>
    <message>
        <source>Record the next run from: %1.</source>
        <translation>Acquérir le prochain essai depuis&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Choose a source, then record a run.</source>
        <translation>Choisir une source, puis acquérir un essai.</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <translation>%1 · %2 %</translation>
    </message>
    <message>
        <source>Opening the source</source>
        <translation>Ouverture de la source</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>Space resume the view · Wheel zoom · Drag pan · A, B set a cursor at the mouse</source>
        <translation>Space reprendre la vue · Molette zoom · Glisser déplacer · A, B placer un curseur à la souris</translation>
    </message>
    <message>
        <source>Wheel zoom · Drag pan · Shift+drag box zoom · Double-click fit · A, B set a cursor at the mouse</source>
        <translation>Molette zoom · Glisser déplacer · Maj+glisser zoom sur un cadre · Double-clic cadrer · A, B placer un curseur à la souris</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
</context>
<context>
    <name>driftbench::RecordReadouts</name>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Progression de l’essai</translation>
    </message>
    <message>
        <source>Running MSD</source>
        <translation>MSD cumulée</translation>
    </message>
    <message>
        <source>dps², since 0:00:00</source>
        <translation>dps², depuis 0:00:00</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>10 s means, dps</source>
        <translation>moyennes sur 10 s, dps</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>MSD so far</source>
        <translation>MSD à ce stade</translation>
    </message>
    <message>
        <source>dps², amber before, blue after</source>
        <translation>dps², ambre avant, bleu après</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>Écoulé</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>Restant</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>Q = after/before</source>
        <translation>Q = après/avant</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 brut</translation>
    </message>
    <message>
        <source>%1 comp.</source>
        <translation>%1 comp.</translation>
    </message>
    <message>
        <source>Sample rate, samples</source>
        <translation>Cadence, échantillons</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Perdus</translation>
    </message>
    <message>
        <source>Overruns, saturated</source>
        <translation>Débordements, saturés</translation>
    </message>
    <message>
        <source>rise, step %1 of %2</source>
        <translation>montée, échelon %1 sur %2</translation>
    </message>
    <message>
        <source>fall, step %1 of %2</source>
        <translation>descente, échelon %1 sur %2</translation>
    </message>
    <message>
        <source>hold, step %1 of %2</source>
        <translation>palier, échelon %1 sur %2</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1, écart %2</translation>
    </message>
    <message>
        <source>%1, %2 ahead</source>
        <translation>%1, avance %2</translation>
    </message>
    <message>
        <source>%1, %2 behind</source>
        <translation>%1, retard %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>palier</translation>
    </message>
    <message>
        <source>rms of 10 s means, before and after:</source>
        <translation>rms des moyennes sur 10 s, avant et après&#x202f;:</translation>
    </message>
    <message>
        <source>%1: %2 and %3 dps</source>
        <translation>%1&#x202f;: %2 et %3 dps</translation>
    </message>
    <message>
        <source>last gap %1</source>
        <translation>dernière lacune %1</translation>
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
        <translation>%1 entraîné sur d’autres essais</translation>
    </message>
    <message>
        <source>%1 trained on %2</source>
        <translation>%1 entraîné sur %2</translation>
    </message>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>Grandeurs de température et erreur de dérive selon le temps</translation>
    </message>
    <message>
        <source>Run %1: ΔT, ΔT² and √ΔT, and the temperature drift error (TDE) of each axis.</source>
        <translation>Essai %1&#x202f;: ΔT, ΔT² et √ΔT, et l’erreur de dérive thermique (TDE) de chaque axe.</translation>
    </message>
    <message>
        <source>TDE of %1 against each temperature quantity</source>
        <translation>TDE de %1 selon chaque grandeur de température</translation>
    </message>
    <message>
        <source>All runs, with the curves fitted to them; below, what the fitted curve leaves. Where heating and cooling part, no curve of temperature follows.</source>
        <translation>Tous les essais, avec leurs courbes ajustées&#x202f;; en dessous, ce que laisse la courbe ajustée. Là où chauffe et refroidissement se séparent, aucune courbe de température ne peut suivre.</translation>
    </message>
    <message>
        <source>Run %1 before and after compensation</source>
        <translation>Essai %1 avant et après compensation</translation>
    </message>
    <message>
        <source>The model has not seen this run. Mean, and lowest to highest, of each stretch of time; rms about the reference rate.</source>
        <translation>Le modèle n’a pas vu cet essai. Moyenne, et minimum à maximum, de chaque plage de temps&#x202f;; rms autour de la vitesse de référence.</translation>
    </message>
    <message>
        <source>Allan deviation of run %1</source>
        <translation>Écart-type d’Allan de l’essai %1</translation>
    </message>
    <message>
        <source>Noise falls with the averaging time, drift rises with it.</source>
        <translation>Le bruit baisse avec le temps de moyennage, la dérive augmente avec lui.</translation>
    </message>
    <message>
        <source>Run %1, held out: what is left, and its Allan deviation</source>
        <translation>Essai %1, réservé&#x202f;: ce qui reste, et son écart-type d’Allan</translation>
    </message>
    <message>
        <source>Before, less the constant; after, by a model that has not seen this run. Each axis has its own scale.</source>
        <translation>Avant, moins la constante&#x202f;; après, par un modèle qui n’a pas vu cet essai. Chaque axe a sa propre échelle.</translation>
    </message>
    <message>
        <source>What is left of the TDE on runs held out</source>
        <translation>Ce qui reste de la TDE sur les essais réservés</translation>
    </message>
    <message>
        <source>Each run less the model that has not seen it. Lines that are level at zero mean that the drift repeats.</source>
        <translation>Chaque essai moins le modèle qui ne l’a pas vu. Des lignes horizontales à zéro signifient que la dérive se répète.</translation>
    </message>
    <message>
        <source>How many centres the RBF network needs</source>
        <translation>Nombre de centres nécessaires au réseau RBF</translation>
    </message>
    <message>
        <source>The smallest number whose loss on data left out is as good as the lowest; below, where the centres stand.</source>
        <translation>Le plus petit nombre dont la perte sur données réservées est aussi bonne que la plus basse&#x202f;; en dessous, la position des centres.</translation>
    </message>
    <message>
        <source>Simulated data</source>
        <translation>Données simulées</translation>
    </message>
    <message>
        <source>%1 held out</source>
        <translation>%1&#x202f;: réservé</translation>
    </message>
    <message>
        <source>Blocks of temperature held out in turn</source>
        <translation>Blocs de température réservés à tour de rôle</translation>
    </message>
    <message>
        <source>Each run held out once</source>
        <translation>Chaque essai réservé une fois</translation>
    </message>
    <message>
        <source>Anchored: the bias at the start of each run is removed</source>
        <translation>Ancrée&#x202f;: le biais au début de chaque essai est retiré</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts</source>
        <translation>Absolue&#x202f;: le biais à la mise sous tension compte</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Capteur</translation>
    </message>
    <message>
        <source>not stated by the logs</source>
        <translation>non indiqué par les journaux</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Date of this report</source>
        <translation>Date de ce rapport</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>%1, with %2 samples, %3 of them usable</source>
        <translation>%1, avec %2 échantillons, dont %3 utilisables</translation>
    </message>
    <message>
        <source>Reference temperature</source>
        <translation>Température de référence</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Hold-out</source>
        <translation>Mise en réserve</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>%1 dps rms may be left on a held-out run</source>
        <translation>reste admis de %1 dps rms sur un essai réservé</translation>
    </message>
    <message>
        <source>none was set</source>
        <translation>aucune n’a été fixée</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>Where the data come from</source>
        <translation>Provenance des données</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Reference dps</source>
        <translation>Référence dps</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>Utilisables</translation>
    </message>
    <message>
        <source>Left out, and why</source>
        <translation>Écartés, et motif</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>Means over the held-out runs.</source>
        <translation>Moyennes sur les essais réservés.</translation>
    </message>
    <message>
        <source>Held-out runs, in the paper&apos;s order</source>
        <translation>Essais réservés, dans l’ordre de l’article</translation>
    </message>
    <message>
        <source>MSD in dps²: mean square of what is left. Q: MSD after over MSD before. Differences: negative where the first named is better. Novel: %1.</source>
        <translation>MSD en dps²&#x202f;: moyenne des carrés de ce qui reste. Q&#x202f;: MSD après sur MSD avant. Différences&#x202f;: négatives là où le premier nommé est meilleur. Nouveau&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Conventional 1 is a line in ΔT, Conventional 2 a BP network 2-10-1, Novel an RBF network on ΔT, ΔT² and √ΔT; cubic is the model of PX4 and ArduPilot, constant the bias alone.</source>
        <translation>Conventionnel 1 est une droite en ΔT, Conventionnel 2 un réseau BP 2-10-1, Nouveau un réseau RBF sur ΔT, ΔT² et √ΔT&#x202f;; cubique est le modèle de PX4 et d’ArduPilot, constante le biais seul.</translation>
    </message>
    <message>
        <source>Yes: within the limit and better than the constant on every held-out run. With care: within the limit, but not always better. No: over the limit on any run, or the bias does not repeat.</source>
        <translation>Oui&#x202f;: dans la limite et meilleur que la constante sur chaque essai réservé. Avec réserve&#x202f;: dans la limite, mais pas toujours meilleur. Non&#x202f;: au-delà de la limite sur au moins un essai, ou biais non répétable.</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>Journal réel</translation>
    </message>
    <message>
        <source>unknown sensor</source>
        <translation>capteur inconnu</translation>
    </message>
    <message>
        <source>Temperature drift of %1, simulated</source>
        <translation>Dérive thermique de %1, simulée</translation>
    </message>
    <message>
        <source>Temperature drift of %1</source>
        <translation>Dérive thermique de %1</translation>
    </message>
    <message>
        <source>May this drift be compensated?</source>
        <translation>Cette dérive peut-elle être compensée&#x202f;?</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Figures</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Page %1</translation>
    </message>
    <message>
        <source>Each model estimates the rate error as a function of temperature alone and is judged only on runs that it has not seen. %1. The noise floor is the variance within 0.5 °C: what no function of temperature removes. Excess is what a model leaves above it.</source>
        <translation>Chaque modèle estime l’erreur de vitesse en fonction de la seule température et n’est évalué que sur des essais qu’il n’a pas vus. %1. Le plancher de bruit est la variance dans 0,5 °C&#x202f;: ce qu’aucune fonction de la température n’élimine. L’excès est ce qu’un modèle laisse au-dessus.</translation>
    </message>
</context>
<context>
    <name>driftbench::ReportWriter</name>
    <message>
        <source>Preparing</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>Drawing figure %1 of %2</source>
        <translation>Tracé de la figure %1 sur %2</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Écriture</translation>
    </message>
</context>
<context>
    <name>driftbench::ResidualView</name>
    <message>
        <source>Residual against temperature</source>
        <translation>Résidu selon la température</translation>
    </message>
    <message>
        <source>No residuals yet</source>
        <translation>Aucun résidu</translation>
    </message>
    <message>
        <source>Train a model and choose runs that it has not seen.</source>
        <translation>Entraîner un modèle et choisir des essais qu’il n’a pas vus.</translation>
    </message>
    <message>
        <source>Mean over 1 °C, each run</source>
        <translation>Moyenne sur 1 °C, chaque essai</translation>
    </message>
    <message>
        <source>95 % band of a new run&apos;s curve</source>
        <translation>Bande à 95 % de la courbe d’un nouvel essai</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Residual (dps)</source>
        <translation>Résidu (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::ScatterDots</name>
    <message>
        <source>Heating</source>
        <translation>Chauffe</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Refroidissement</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Exclu</translation>
    </message>
</context>
<context>
    <name>driftbench::Session</name>
    <message>
        <source>unnamed</source>
        <translation>sans nom</translation>
    </message>
</context>
<context>
    <name>driftbench::ShortcutOverview</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>Effet</translation>
    </message>
</context>
<context>
    <name>driftbench::SimulatedForm</name>
    <message>
        <source>Curved</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>Forte</translation>
    </message>
    <message>
        <source>Mild</source>
        <translation>Faible</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Combs</source>
        <translation>Peignes</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>As fast as it goes</source>
        <translation>Au plus vite</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>× %1</translation>
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
        <translation>Capteur</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>Vitesse de référence</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Noise, 1 σ</source>
        <translation>Bruit, 1 σ</translation>
    </message>
    <message>
        <source>Run-to-run spread</source>
        <translation>Dispersion d’essais</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rythme</translation>
    </message>
    <message>
        <source>How fast the simulated time passes while a run is recorded.</source>
        <translation>À quel rythme le temps simulé s’écoule pendant l’acquisition d’un essai.</translation>
    </message>
    <message>
        <source>How the bias follows the temperature; Combs computes it from the comb capacitors.</source>
        <translation>Comment le biais suit la température&#x202f;; Peignes le calcule à partir des condensateurs à peignes.</translation>
    </message>
    <message>
        <source>%1, %2 dps</source>
        <translation>%1, %2 dps</translation>
    </message>
    <message>
        <source>%1, drift: %2</source>
        <translation>%1, dérive&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>driftbench::SourceForm</name>
    <message>
        <source>No source chosen</source>
        <translation>Aucune source choisie</translation>
    </message>
</context>
<context>
    <name>driftbench::SourcePage</name>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Reading logs</source>
        <translation>Lecture des journaux</translation>
    </message>
    <message>
        <source>Simulated bridge</source>
        <translation>Pont simulé</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>Pont gyro</translation>
    </message>
    <message>
        <source>I2C bridge</source>
        <translation>Pont I2C</translation>
    </message>
    <message>
        <source>Up, Down choose · Enter use · F5 look again · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>Haut, Bas choisir · Entrée utiliser · F5 actualiser · Ctrl+O ouvrir des fichiers · Alt+1 à 7 étapes</translation>
    </message>
    <message>
        <source>%1 %2 is plugged in, but you may not open it.</source>
        <translation>%1 %2 est branché, mais vous n’avez pas le droit de l’ouvrir.</translation>
    </message>
    <message>
        <source>Save this line as 70-driftbench.rules in /etc/udev/rules.d, then unplug the bridge and plug it in again:</source>
        <translation>Enregistrer cette ligne sous 70-driftbench.rules dans /etc/udev/rules.d, puis débrancher et rebrancher le pont&#x202f;:</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Use source</source>
        <translation>Utiliser la source</translation>
    </message>
    <message>
        <source>Choose a bridge or a file.</source>
        <translation>Choisir un pont ou un fichier.</translation>
    </message>
    <message>
        <source>Use simulated bridge</source>
        <translation>Utiliser le pont simulé</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>Ouvrir la session</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Rejouer</translation>
    </message>
    <message>
        <source>Read in</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Other logs are being read.</source>
        <translation>D’autres journaux sont en cours de lecture.</translation>
    </message>
    <message>
        <source>A run is being recorded. Stop it to take another source.</source>
        <translation>Un essai est en cours d’acquisition. L’arrêter pour prendre une autre source.</translation>
    </message>
    <message>
        <source>Where the samples come from. Nothing is recorded yet.</source>
        <translation>D’où viennent les échantillons. Rien n’est encore acquis.</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Actualiser</translation>
    </message>
    <message>
        <source>Copy line</source>
        <translation>Copier la ligne</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Ponts</translation>
    </message>
    <message>
        <source>USB-HID, looked for every second</source>
        <translation>USB-HID, recherche chaque seconde</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>dernières 60 s</translation>
    </message>
    <message>
        <source>Drop log files here: CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>Déposer ici des fichiers journaux&#x202f;: CSV, PX4 ULog, ArduPilot DataFlash. Le format est reconnu au contenu.</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aucun fichier</translation>
    </message>
    <message>
        <source>Logs and sessions that were opened stand here.</source>
        <translation>Les journaux et sessions ouverts figurent ici.</translation>
    </message>
    <message numerus="yes">
        <source>%n logs</source>
        <translation>
            <numerusform>%n journal</numerusform>
            <numerusform>%n journaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bridges plugged in, %1 usable</source>
        <translation>
            <numerusform>%n pont branché, utilisables&#x202f;: %1</numerusform>
            <numerusform>%n ponts branchés, utilisables&#x202f;: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Where the samples come from. %n runs so far.</source>
        <translation>
            <numerusform>D’où viennent les échantillons. %n essai jusqu’ici.</numerusform>
            <numerusform>D’où viennent les échantillons. %n essais jusqu’ici.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::SourceStatus</name>
    <message>
        <source> · opening</source>
        <translation> · ouverture</translation>
    </message>
    <message>
        <source> · no samples for %1 s</source>
        <translation> · aucun échantillon depuis %1 s</translation>
    </message>
    <message>
        <source> · %1 Hz</source>
        <translation> · %1 Hz</translation>
    </message>
    <message>
        <source> · 0 dropped</source>
        <translation> · 0 perdu</translation>
    </message>
    <message>
        <source>%1 dropped of %2</source>
        <translation>%1 perdus sur %2</translation>
    </message>
    <message>
        <source>%1 GB free</source>
        <translation>%1 Go libres</translation>
    </message>
</context>
<context>
    <name>driftbench::StartPage</name>
    <message>
        <source>Calibrate the temperature drift of a gyro</source>
        <translation>Étalonner la dérive thermique d’un gyromètre</translation>
    </message>
    <message>
        <source>From samples to a table in the device, in seven steps. Each step can be used on its own.</source>
        <translation>Des échantillons à la table dans l’appareil, en sept étapes. Chaque étape peut servir seule.</translation>
    </message>
    <message>
        <source>Guided tour on the simulated bridge</source>
        <translation>Visite guidée sur le pont simulé</translation>
    </message>
    <message>
        <source>Connects, records three runs faster than time, trains, compares and writes the table. Under two minutes, no hardware.</source>
        <translation>Connecte, acquiert trois essais en accéléré, entraîne, compare et écrit la table. Moins de deux minutes, sans matériel.</translation>
    </message>
    <message>
        <source>Connect a bridge</source>
        <translation>Connecter un pont</translation>
    </message>
    <message>
        <source>A native gyro bridge, or an L3GD20H or I3G4250D behind a USB-to-I2C chip.</source>
        <translation>Un pont gyro natif, ou un L3GD20H ou I3G4250D derrière une puce USB vers I2C.</translation>
    </message>
    <message>
        <source>Open log files or a session…</source>
        <translation>Ouvrir des journaux ou une session…</translation>
    </message>
    <message>
        <source>CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>CSV, PX4 ULog, ArduPilot DataFlash. Le format est reconnu au contenu.</translation>
    </message>
    <message>
        <source>Files can also be dropped anywhere on this window. F1 lists all keys.</source>
        <translation>Les fichiers peuvent aussi être déposés n’importe où dans cette fenêtre. F1 liste toutes les touches.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Accueil</translation>
    </message>
</context>
<context>
    <name>driftbench::StepRail</name>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>avec avertissements</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>acquisition</translation>
    </message>
    <message>
        <source>working</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>%1 (Alt+%2)</source>
        <translation>%1 (Alt+%2)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
</context>
<context>
    <name>driftbench::StripView</name>
    <message>
        <source>The last minute of the source</source>
        <translation>La dernière minute de la source</translation>
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
        <translation>Rien n’arrive encore</translation>
    </message>
    <message>
        <source>Choose a source at the left.</source>
        <translation>Choisir une source à gauche.</translation>
    </message>
    <message>
        <source>Time before now (s)</source>
        <translation>Temps avant maintenant (s)</translation>
    </message>
</context>
<context>
    <name>driftbench::TableDifferenceView</name>
    <message>
        <source>New table less the one on the device</source>
        <translation>Nouvelle table moins celle de l’appareil</translation>
    </message>
    <message>
        <source>Nothing to compare</source>
        <translation>Rien à comparer</translation>
    </message>
    <message>
        <source>No table is on the device.</source>
        <translation>Aucune table dans l’appareil.</translation>
    </message>
    <message>
        <source>New − now (mdps)</source>
        <translation>Nouv. − act. (mdps)</translation>
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
        <translation>Erreur max. de la table dans chaque cellule</translation>
    </message>
    <message>
        <source>Worst in each cell</source>
        <translation>Max. par cellule</translation>
    </message>
    <message>
        <source>worst %1 mdps</source>
        <translation>max. %1 mdps</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>sans table</translation>
    </message>
    <message>
        <source>No table yet</source>
        <translation>Aucune table</translation>
    </message>
    <message>
        <source>Train a model to see what a table of it costs.</source>
        <translation>Entraîner un modèle pour voir ce que coûte sa mise en table.</translation>
    </message>
    <message>
        <source>Table against model</source>
        <translation>Table face au modèle</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Borne</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Error (mdps)</source>
        <translation>Erreur (mdps)</translation>
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
        <translation>Erreur de dérive selon les grandeurs de température</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Exclu</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Chauffe</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Refroidissement</translation>
    </message>
    <message>
        <source>Fitted curve, %1, with its 95 % band</source>
        <translation>Courbe ajustée, %1, avec sa bande à 95 %</translation>
    </message>
    <message>
        <source>Fitted curve, %1</source>
        <translation>Courbe ajustée, %1</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>Aucun échantillon</translation>
    </message>
    <message>
        <source>All samples are excluded, or no run was given.</source>
        <translation>Tous les échantillons sont exclus, ou aucun essai n’a été donné.</translation>
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
        <translation>Résidu (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::TcqTimeView</name>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>Grandeurs de température et erreur de dérive selon le temps</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Aucun essai</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Acquérir un essai, ou ouvrir un fichier journal.</translation>
    </message>
    <message>
        <source>Temperature quantity</source>
        <translation>Grandeur de température</translation>
    </message>
    <message>
        <source>TDE, mean and range</source>
        <translation>TDE, moyenne et étendue</translation>
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
        <translation>Temps écoulé</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainFigures</name>
    <message>
        <source>Trained. Judged once all are.</source>
        <translation>Entraîné. Évalué quand tous le seront.</translation>
    </message>
    <message>
        <source>Waiting.</source>
        <translation>En attente.</translation>
    </message>
    <message>
        <source>Training on each set of runs.</source>
        <translation>Entraînement sur chaque ensemble d’essais.</translation>
    </message>
    <message>
        <source>Cancelled before it was finished.</source>
        <translation>Annulé avant la fin.</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainOptions</name>
    <message>
        <source>Preset of the RBF network</source>
        <translation>Préréglage du réseau RBF</translation>
    </message>
    <message>
        <source>inputs of the RBF network</source>
        <translation>entrées du réseau RBF</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>Ridge</translation>
    </message>
    <message>
        <source>Hidden units of the BP network</source>
        <translation>Neurones cachés du réseau BP</translation>
    </message>
    <message>
        <source>Starts of the BP network</source>
        <translation>Départs du réseau BP</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>number of centres</source>
        <translation>nombre de centres</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>largeurs</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>ridge</translation>
    </message>
    <message>
        <source>hidden units</source>
        <translation>neurones cachés</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>départs</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>graine</translation>
    </message>
    <message>
        <source>hold-out</source>
        <translation>mise en réserve</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>évaluation</translation>
    </message>
    <message>
        <source>models</source>
        <translation>modèles</translation>
    </message>
    <message>
        <source>One run in turn</source>
        <translation>Essai par essai</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>Seulement %1</translation>
    </message>
    <message>
        <source>Blocks of temperature</source>
        <translation>Blocs de température</translation>
    </message>
    <message>
        <source>Auto, up to %1</source>
        <translation>Auto, jusqu’à %1</translation>
    </message>
    <message numerus="yes">
        <source>%n, for every axis</source>
        <translation>
            <numerusform>%n, pour chaque axe</numerusform>
            <numerusform>%n, pour chaque axe</numerusform>
        </translation>
    </message>
    <message>
        <source>Auto, %1 tried</source>
        <translation>Auto, %1 essayées</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolue</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>Ancrée</translation>
    </message>
    <message>
        <source>Gaussians on the temperature quantities, placed by orthogonal least squares.</source>
        <translation>Gaussiennes sur les grandeurs de température, placées par moindres carrés orthogonaux.</translation>
    </message>
    <message>
        <source>A network with tanh units, trained from several seeded starts.</source>
        <translation>Un réseau à neurones tanh, entraîné depuis plusieurs départs à graine fixée.</translation>
    </message>
    <message>
        <source>As PX4 fits it: medians, 2 000 bins of temperature, a cubic.</source>
        <translation>Comme PX4 l’ajuste&#x202f;: médianes, 2&#x202f;000 classes de température, une cubique.</translation>
    </message>
    <message>
        <source>As ArduPilot fits it: means of 2 s, a cubic about 35 °C.</source>
        <translation>Comme ArduPilot l’ajuste&#x202f;: moyennes sur 2 s, une cubique autour de 35 °C.</translation>
    </message>
    <message>
        <source>Least squares on ΔT.</source>
        <translation>Moindres carrés sur ΔT.</translation>
    </message>
    <message>
        <source>Always in: the others can&apos;t tell every temperature from every other.</source>
        <translation>Toujours présente&#x202f;: les autres ne distinguent pas toutes les températures entre elles.</translation>
    </message>
    <message>
        <source>The rate of the temperature is an experiment: it did not survive on recorded runs held out, and no table could hold it. driftbench-cli fit --dynamic measures it.</source>
        <translation>La vitesse de variation de la température est une expérience&#x202f;: elle n’a pas résisté aux essais réservés réellement acquis, et aucune table ne pourrait la contenir. driftbench-cli fit --dynamic la mesure.</translation>
    </message>
    <message>
        <source>Auto: the smallest number that does as well as the best on runs left out.</source>
        <translation>Auto&#x202f;: le plus petit nombre qui fait aussi bien que le meilleur sur les essais réservés.</translation>
    </message>
    <message>
        <source>Widths of the Gaussians, each half the one before, from the whole span down.</source>
        <translation>Largeurs des gaussiennes, chacune la moitié de la précédente, à partir de toute la plage.</translation>
    </message>
    <message>
        <source>How many samples&apos; worth of doubt shrinks each Gaussian. More is smoother.</source>
        <translation>Poids du doute, en échantillons, qui réduit chaque gaussienne. Plus grand&#x202f;: plus lisse.</translation>
    </message>
    <message>
        <source>Tanh units in the hidden layer of the BP network.</source>
        <translation>Neurones tanh de la couche cachée du réseau BP.</translation>
    </message>
    <message>
        <source>Seeded starts of the BP network; the best one counts.</source>
        <translation>Départs à graine fixée du réseau BP&#x202f;; le meilleur compte.</translation>
    </message>
    <message>
        <source>Same runs, options and seed: the same models, bit for bit.</source>
        <translation>Mêmes essais, options et graine&#x202f;: les mêmes modèles, bit pour bit.</translation>
    </message>
    <message>
        <source>Which runs are judged by models that have not seen them.</source>
        <translation>Quels essais sont évalués par des modèles qui ne les ont pas vus.</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts, as in PX4. Anchored: the bias at the start of each run is removed, as ArduPilot does.</source>
        <translation>Absolue&#x202f;: le biais à la mise sous tension compte, comme dans PX4. Ancrée&#x202f;: le biais au début de chaque essai est retiré, comme le fait ArduPilot.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>RBF inputs</source>
        <translation>Entrées RBF</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Options</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Optimal</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Article</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>Réseau RBF</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>Réseau BP</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as PX4</source>
        <translation>Cubique en ΔT, comme PX4</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as ArduPilot</source>
        <translation>Cubique en ΔT, comme ArduPilot</translation>
    </message>
    <message>
        <source>Line in ΔT</source>
        <translation>Droite en ΔT</translation>
    </message>
    <message>
        <source>Centres</source>
        <translation>Centres</translation>
    </message>
    <message>
        <source>Widths</source>
        <translation>Largeurs</translation>
    </message>
    <message>
        <source>BP units</source>
        <translation>Neurones BP</translation>
    </message>
    <message>
        <source>BP starts</source>
        <translation>Départs BP</translation>
    </message>
    <message>
        <source>Hold out</source>
        <translation>Réserver</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Number of centres</source>
        <translation>Nombre de centres</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainPage</name>
    <message>
        <source>Models</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>Progress of the training</source>
        <translation>Progression de l’entraînement</translation>
    </message>
    <message>
        <source>The training was refused.</source>
        <translation>L’entraînement a été refusé.</translation>
    </message>
    <message>
        <source>The training can&apos;t start.</source>
        <translation>L’entraînement ne peut pas démarrer.</translation>
    </message>
    <message numerus="yes">
        <source>take %n centres</source>
        <translation>
            <numerusform>choix de %n centre</numerusform>
            <numerusform>choix de %n centres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Each run is held out once.</source>
        <translation>Chaque essai est réservé une fois.</translation>
    </message>
    <message>
        <source>Shown is what was trained before the last change. Train again.</source>
        <translation>Affiché&#x202f;: l’état d’avant la dernière modification. Réentraîner.</translation>
    </message>
    <message>
        <source>Blocks of temperature are held out: one run can&apos;t show that another repeats it.</source>
        <translation>Des blocs de température sont réservés&#x202f;: un essai seul ne peut pas montrer qu’un autre le répète.</translation>
    </message>
    <message>
        <source>Each run is held out once. Held-out error counts, training error does not.</source>
        <translation>Chaque essai est réservé une fois. L’erreur sur essai réservé compte, l’erreur d’entraînement non.</translation>
    </message>
    <message>
        <source>Train again</source>
        <translation>Réentraîner</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Entraîner</translation>
    </message>
    <message>
        <source>Nothing to train on</source>
        <translation>Rien pour s’entraîner</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>Acquérir un essai, ou ouvrir un fichier journal.</translation>
    </message>
    <message>
        <source>Not trained yet</source>
        <translation>Pas encore entraîné</translation>
    </message>
    <message>
        <source>Choose the models at the left and train them.</source>
        <translation>Choisir les modèles à gauche et les entraîner.</translation>
    </message>
    <message>
        <source>These runs can&apos;t be trained on.</source>
        <translation>Ces essais ne permettent pas l’entraînement.</translation>
    </message>
    <message>
        <source>Centres: the fewest that do as well as the best on runs left out. Here %1.</source>
        <translation>Centres&#x202f;: le plus petit nombre qui fait aussi bien que le meilleur sur les essais réservés. Ici %1.</translation>
    </message>
    <message>
        <source>Training, %1 %</source>
        <translation>Entraînement, %1 %</translation>
    </message>
    <message>
        <source>Changed, train again</source>
        <translation>Modifié, réentraîner</translation>
    </message>
    <message numerus="yes">
        <source>%n model(s)</source>
        <translation>
            <numerusform>%n modèle</numerusform>
            <numerusform>%n modèles</numerusform>
        </translation>
    </message>
    <message>
        <source>Esc cancel. What is finished is kept.</source>
        <translation>Esc annuler. Ce qui est terminé est conservé.</translation>
    </message>
    <message>
        <source>Ctrl+R train · Click the curve of the excess to take that number of centres · F fit</source>
        <translation>Ctrl+R entraîner · Cliquer la courbe d’excès pour prendre ce nombre de centres · F cadrer</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), %1 samples</source>
        <translation>
            <numerusform>%n essai, %1 échantillons</numerusform>
            <numerusform>%n essais, %1 échantillons</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Look at the runs</source>
        <translation>Voir les essais</translation>
    </message>
    <message>
        <source>Train the chosen models and judge them on runs held out</source>
        <translation>Entraîner les modèles choisis et les évaluer sur des essais réservés</translation>
    </message>
</context>
<context>
    <name>driftbench::TransientView</name>
    <message>
        <source>What is left of a step at the centre of the chamber, over time</source>
        <translation>Ce qui reste d’un échelon au centre de l’enceinte, selon le temps</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 to ±%2 °C</source>
        <translation>%1 pour ±%2 °C</translation>
    </message>
    <message>
        <source>Nothing to settle</source>
        <translation>Rien à stabiliser</translation>
    </message>
    <message>
        <source>The step is within what the thermometer can tell.</source>
        <translation>L’échelon est inférieur à ce que le thermomètre distingue.</translation>
    </message>
    <message>
        <source>Time after a step of %1 °C</source>
        <translation>Temps après un échelon de %1 °C</translation>
    </message>
    <message>
        <source>Still to go (°C)</source>
        <translation>Reste (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::UploadSteps</name>
    <message>
        <source>Begin</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Commit</source>
        <translation>Valider</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Activer</translation>
    </message>
    <message>
        <source>No upload under way</source>
        <translation>Aucun transfert en cours</translation>
    </message>
    <message>
        <source>Upload done</source>
        <translation>Transfert terminé</translation>
    </message>
    <message>
        <source>Upload, step %1 of 6: %2</source>
        <translation>Transfert, étape %1 sur 6&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>driftbench::VerdictCard</name>
    <message>
        <source>Write the table.</source>
        <translation>Écrire la table.</translation>
    </message>
    <message>
        <source>Write only a constant, or the table with care.</source>
        <translation>Écrire seulement une constante, ou la table avec réserve.</translation>
    </message>
    <message>
        <source>Write the table with care.</source>
        <translation>Écrire la table avec réserve.</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>Pas de table pour %1.</translation>
    </message>
    <message>
        <source>Nothing to write for %1: its bias does not move with temperature.</source>
        <translation>Rien à écrire pour %1&#x202f;: son biais ne varie pas avec la température.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 times less than a constant</source>
        <translation>%1 fois moins qu’une constante</translation>
    </message>
    <message>
        <source>%1 to %2 times less than a constant</source>
        <translation>%1 à %2 fois moins qu’une constante</translation>
    </message>
    <message>
        <source>It was not judged on any run.</source>
        <translation>Il n’a été évalué sur aucun essai.</translation>
    </message>
    <message>
        <source>It leaves %1 dps rms</source>
        <translation>Il reste %1 dps rms</translation>
    </message>
    <message>
        <source>With the %1 it leaves %2 dps rms</source>
        <translation>Avec le modèle %1, il reste %2 dps rms</translation>
    </message>
    <message>
        <source>, over the limit of %1</source>
        <translation>, au-delà de la limite de %1</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>, %1</translation>
    </message>
    <message>
        <source>, a constant %1</source>
        <translation>, une constante %1</translation>
    </message>
    <message>
        <source>A constant does better on %1.</source>
        <translation>Une constante fait mieux sur %1.</translation>
    </message>
    <message>
        <source>The rest is hysteresis, %1 times the noise.</source>
        <translation>Le reste est de l’hystérésis, %1 fois le bruit.</translation>
    </message>
    <message>
        <source>Verdict for %1: %2. %3</source>
        <translation>Verdict pour %1&#x202f;: %2. %3</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>With care</source>
        <translation>Avec réserve</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>No drift</source>
        <translation>Sans dérive</translation>
    </message>
    <message numerus="yes">
        <source>fails on %1 of %n runs</source>
        <translation>
            <numerusform>échec sur %1/%n essai</numerusform>
            <numerusform>échec sur %1/%n essais</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>passes on %1 of %n runs</source>
        <translation>
            <numerusform>réussi sur %1/%n essai</numerusform>
            <numerusform>réussi sur %1/%n essais</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::Workbench</name>
    <message>
        <source>Simulated bridge</source>
        <translation>Pont simulé</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>Pont gyro</translation>
    </message>
</context>
</TS>

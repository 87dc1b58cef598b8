<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>handsight</name>
    <message>
        <source>An error of one corner under %1 here could not be seen.</source>
        <translation>Ein Fehler einer Ecke unter %1 wäre hier nicht zu sehen.</translation>
    </message>
    <message>
        <source>First the mistake</source>
        <translation>Zuerst der Fehler</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>Observation %1, bent by the model: %2 mm, drawn %3 ×</source>
        <translation>Beobachtung %1, vom Modell gebogen: %2 mm, gezeichnet %3 ×</translation>
    </message>
    <message>
        <source>Put that right first: until then no other number tells anything.</source>
        <translation>Berichtige das zuerst: bis dahin sagt keine andere Zahl etwas.</translation>
    </message>
    <message>
        <source>Fitted with it, %1 are left; put right, %2.</source>
        <translation>Damit angepasst bleiben %1; berichtigt %2.</translation>
    </message>
    <message>
        <source>Fitted with them, %1 are left; both put right, %2.</source>
        <translation>Damit angepasst bleiben %1; beide berichtigt %2.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Whatever is missing in the model shows once the session is put right: the bar above says how, and writes it.</source>
        <translation>Was im Modell fehlt, zeigt sich, wenn die Sitzung berichtigt ist: die Leiste oben sagt, wie, und schreibt sie.</translation>
    </message>
    <message>
        <source>a mistake in the session</source>
        <translation>ein Fehler in der Sitzung</translation>
    </message>
    <message>
        <source>a repeat, for scatter</source>
        <translation>Wiederholung</translation>
    </message>
    <message>
        <source>deviations %1 ×</source>
        <translation>Abweichungen %1 ×</translation>
    </message>
    <message>
        <source>mistake</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>noise %1</source>
        <translation>Rauschen %1</translation>
    </message>
    <message>
        <source>noise, %1</source>
        <translation>Rauschen, %1</translation>
    </message>
    <message>
        <source>mostly of the depth</source>
        <translation>meist der Tiefe</translation>
    </message>
    <message>
        <source>Look for &amp;mistakes of a whole kind</source>
        <translation>Nach groben &amp;Fehlern suchen</translation>
    </message>
    <message>
        <source>a joint that counts the other way, readings paired one off, another unit</source>
        <translation>ein Gelenk, das andersherum zählt, Messungen um eins versetzt, eine andere Einheit</translation>
    </message>
    <message>
        <source>mm in the mean</source>
        <translation>mm im Mittel</translation>
    </message>
    <message>
        <source>The images show one: say what with --target &quot;%1&quot;, the measured lengths in place of ?%2.</source>
        <translation>Die Bilder zeigen eines: mit --target &quot;%1&quot; sagen, welches, für ? die gemessenen Längen%2.</translation>
    </message>
    <message>
        <source>; a marker is %1 of a square</source>
        <translation>; ein Marker ist das %1-fache eines Felds</translation>
    </message>
    <message>
        <source>; the separation is %1 of a marker</source>
        <translation>; der Abstand ist das %1-fache eines Markers</translation>
    </message>
    <message>
        <source>No target is named. %1</source>
        <translation>Kein Ziel ist genannt. %1</translation>
    </message>
    <message>
        <source>No target is named: the session is one of markers without names. %1</source>
        <translation>Kein Ziel ist genannt: Die Sitzung ist eine von Markern ohne Namen. %1</translation>
    </message>
    <message>
        <source>Write the session put right</source>
        <translation>Berichtigte Sitzung schreiben</translation>
    </message>
    <message>
        <source>Beside the old one, which stays as it is</source>
        <translation>Neben die alte, die bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Looking for mistakes of a whole kind</source>
        <translation>Suche nach groben Fehlern</translation>
    </message>
    <message>
        <source>No mistake of a whole kind makes this session right.</source>
        <translation>Kein grober Fehler, der sich berichtigen ließe, erklärt diese Sitzung.</translation>
    </message>
    <message>
        <source>Add it: press the blue button. The fit runs before your eyes.</source>
        <translation>Hinzufügen: der blaue Knopf. Die Schätzung läuft vor Ihren Augen.</translation>
    </message>
    <message>
        <source>A sample session knows what was hidden in it: Reveal the truth, in the session's menu, compares.</source>
        <translation>Eine Beispielsitzung weiß, was in ihr versteckt wurde: Die Wahrheit zeigen, im Menü der Sitzung, vergleicht.</translation>
    </message>
    <message>
        <source>Reveal the &amp;truth</source>
        <translation>Die &amp;Wahrheit zeigen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>precision of the hand</source>
        <translation>Genauigkeit der Hand</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>the session itself is wrong</source>
        <translation>die Sitzung selbst ist falsch</translation>
    </message>
    <message>
        <source>what was hidden in this session</source>
        <translation>was in dieser Sitzung versteckt wurde</translation>
    </message>
    <message>
        <source>add the best cause again and again</source>
        <translation>immer wieder die beste Ursache hinzufügen</translation>
    </message>
    <message>
        <source>all effects, with one verdict each</source>
        <translation>alle Effekte, mit je einem Urteil</translation>
    </message>
    <message>
        <source>Tour: find the missing effect</source>
        <translation>Rundgang: den fehlenden Effekt finden</translation>
    </message>
    <message>
        <source>Stopped at the noise: %1.</source>
        <translation>Angehalten beim Rauschen: %1.</translation>
    </message>
    <message>
        <source>Larger than robots are built, so it stands in for another cause: %1.</source>
        <translation>Größer, als Roboter gebaut sind, also wohl für eine andere Ursache: %1.</translation>
    </message>
    <message>
        <source>at the noise, by a stand-in</source>
        <translation>beim Rauschen, durch einen Ersatz</translation>
    </message>
    <message>
        <source>no plausible cause</source>
        <translation>keine plausible Ursache</translation>
    </message>
    <message>
        <source>Its plot</source>
        <translation>Sein Bild</translation>
    </message>
    <message>
        <source>What it would explain</source>
        <translation>Was es erklären würde</translation>
    </message>
    <message>
        <source>Tried: the points do not follow it</source>
        <translation>Versuch: die Punkte folgen dem nicht</translation>
    </message>
    <message>
        <source>Its points follow the %1. </source>
        <translation>Die Punkte folgen: %1. </translation>
    </message>
    <message>
        <source>It explains %1 % of what exceeds the noise.</source>
        <translation>Es erklärt %1 % dessen, was das Rauschen übersteigt.</translation>
    </message>
    <message>
        <source>The target is %1 % larger than described: printed to fit the page, or a length typed wrong. Every distance seen is wrong by the same share.</source>
        <translation>Das Muster ist %1 % größer als beschrieben: auf Seitengröße gedruckt, oder eine Länge falsch eingetippt. Jeder gesehene Abstand ist um denselben Anteil falsch.</translation>
    </message>
    <message>
        <source>The target is %1 % smaller than described: printed to fit the page, or a length typed wrong. Every distance seen is wrong by the same share.</source>
        <translation>Das Muster ist %1 % kleiner als beschrieben: auf Seitengröße gedruckt, oder eine Länge falsch eingetippt. Jeder gesehene Abstand ist um denselben Anteil falsch.</translation>
    </message>
    <message>
        <source>The target is described as flat and is bent, by a radius of %1 m: its edges stand off.</source>
        <translation>Das Muster ist als eben beschrieben und ist gebogen, mit einem Radius von %1 m: seine Ränder stehen ab.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>this curve</source>
        <translation>Diese Kurve</translation>
    </message>
    <message>
        <source>A spring that pushes back: no joint is built so. Probably another cause.</source>
        <translation>Eine Feder, die zurückdrückt: so ist kein Gelenk gebaut. Wahrscheinlich eine andere Ursache.</translation>
    </message>
    <message>
        <source>At the noise, but by something that stands in</source>
        <translation>Beim Rauschen, aber durch einen Ersatz</translation>
    </message>
    <message>
        <source>The program cannot say when to stop: declare the noise (sigma), or repeat some poses.</source>
        <translation>Das Programm kann nicht sagen, wann Schluss ist: gib das Rauschen an (sigma), oder wiederhole einige Posen.</translation>
    </message>
    <message>
        <source>Nothing that helps is left</source>
        <translation>Nichts, was hilft, ist übrig</translation>
    </message>
    <message>
        <source>What is left is more than noise, differs from pose to pose and follows nothing that was measured. No effect can remove it.</source>
        <translation>Was bleibt, ist mehr als Rauschen, wechselt von Pose zu Pose und folgt nichts Gemessenem. Kein Effekt kann es beseitigen.</translation>
    </message>
    <message>
        <source>May be there, but is too rare to be named on this evidence: %1.</source>
        <translation>Vielleicht da, doch zu selten, um auf diese Hinweise hin genannt zu werden: %1.</translation>
    </message>
    <message>
        <source>No robot is built so, it stands in for another cause: %1.</source>
        <translation>So ist kein Roboter gebaut, es steht für eine andere Ursache: %1.</translation>
    </message>
    <message>
        <source>Something real is left: %1 explains a part of it, and nothing in the catalogue explains the rest. %2</source>
        <translation>Etwas Wirkliches bleibt: %1 erklärt einen Teil davon, und nichts im Katalog erklärt den Rest. %2</translation>
    </message>
    <message>
        <source>No plausible cause explains it: %1 would help, but it is more than three times what is usual, and leaves much.</source>
        <translation>Keine plausible Ursache erklärt es: %1 würde helfen, ist aber mehr als das Dreifache des Üblichen und lässt viel übrig.</translation>
    </message>
    <message>
        <source>No plausible cause explains it: %1 would help, but no robot is built so.</source>
        <translation>Keine plausible Ursache erklärt es: %1 würde helfen, aber so ist kein Roboter gebaut.</translation>
    </message>
    <message>
        <source>The marker body, as in the whole session: what is missing (%1) explains most of it. </source>
        <translation>Der Markerkörper, wie in der ganzen Sitzung: was fehlt (%1), erklärt das meiste davon. </translation>
    </message>
    <message>
        <source>The cameras, as in the whole session: what is missing (%1) explains most of it. </source>
        <translation>Die Kameras, wie in der ganzen Sitzung: was fehlt (%1), erklärt das meiste davon. </translation>
    </message>
    <message>
        <source>The tracker, as in the whole session: what is missing (%1) explains most of it. </source>
        <translation>Der Tracker, wie in der ganzen Sitzung: was fehlt (%1), erklärt das meiste davon. </translation>
    </message>
    <message>
        <source>%1 of %2 beyond 3 σ</source>
        <translation>%1 von %2 über 3 σ</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>stand-in</source>
        <translation>Ersatz</translation>
    </message>
    <message>
        <source>not all named</source>
        <translation>nicht alles benannt</translation>
    </message>
    <message>
        <source>There is nothing to add.</source>
        <translation>Es gibt nichts hinzuzufügen.</translation>
    </message>
    <message>
        <source>held out; elsewhere %1</source>
        <translation>ungesehen; anderswo %1</translation>
    </message>
    <message>
        <source>How far the hand is from where it is predicted, all markers of an observation together (with a tracker: each marker), on observations that the fit has not seen; what noise alone would make of it; and how many times larger than that it is. U changes the unit.</source>
        <translation>Wie weit die Hand von ihrem vorhergesagten Ort ist, alle Marker einer Beobachtung zusammen (mit einem Tracker: jeder Marker), in Beobachtungen, die die Schätzung nicht gesehen hat; was Rauschen allein daraus machte; und wievielmal größer es ist. U wechselt die Einheit.</translation>
    </message>
    <message>
        <source>The error of one coordinate (root mean square) on observations that the fit has not seen, the noise of the measurement, and how many times larger the error is. Elsewhere: where whole regions of poses are held out. U changes the unit.</source>
        <translation>Der Fehler einer Koordinate (quadratisches Mittel) in Beobachtungen, die die Schätzung nicht gesehen hat, das Rauschen der Messung, und wievielmal größer der Fehler ist. Anderswo: wo ganze Bereiche von Posen ungesehen bleiben. U wechselt die Einheit.</translation>
    </message>
    <message>
        <source>Report as HTML</source>
        <translation>Bericht als HTML</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Bericht als PDF</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Speichern als %1</translation>
    </message>
    <message>
        <source>For other programs</source>
        <translation>Für andere Programme</translation>
    </message>
    <message>
        <source>Save for it</source>
        <translation>Dafür speichern</translation>
    </message>
    <message>
        <source>Beside the XML, for another program: the robot, the hand and what corrects them</source>
        <translation>Neben der XML, für ein anderes Programm: der Roboter, die Hand und was sie korrigiert</translation>
    </message>
    <message>
        <source>Over %1 poses like the measured ones the hand is off by %2 mm as commanded (median), and by %3 mm when the corrected angles are commanded, with all that the model is not sure of: by the C++ and Python files that this page saves.</source>
        <translation>Über %1 Posen wie die gemessenen liegt die Hand, wie befohlen, um %2 mm daneben (Median), und um %3 mm, wenn die korrigierten Winkel befohlen werden, mit allem, worin das Modell unsicher ist: mit den C++- und Python-Dateien, die diese Seite speichert.</translation>
    </message>
    <message>
        <source>%1 (%2 at the hand)</source>
        <translation>%1 (%2 an der Hand)</translation>
    </message>
    <message>
        <source>Where whole regions of poses are held out</source>
        <translation>Wo ganze Bereiche von Posen ungesehen bleiben</translation>
    </message>
    <message>
        <source>What noise alone would leave</source>
        <translation>Was Rauschen allein ließe</translation>
    </message>
    <message>
        <source>What to command so that the hand arrives where it was meant to be.</source>
        <translation>Was zu befehlen ist, damit die Hand dort ankommt, wo sie hin sollte.</translation>
    </message>
    <message>
        <source>The hand misses its place by %1 mm. Command the angles at the right, and it arrives to ± %2 mm.</source>
        <translation>Die Hand verfehlt ihren Ort um %1 mm. Mit den Winkeln rechts kommt sie auf ± %2 mm genau an.</translation>
    </message>
    <message>
        <source>The hand misses its place by %1 mm. Within the joints' limits %2 mm stay (± %3 mm), by the angles at the right.</source>
        <translation>Die Hand verfehlt ihren Ort um %1 mm. In den Grenzen der Gelenke bleiben %2 mm (± %3 mm), mit den Winkeln rechts.</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>korrigiert</translation>
    </message>
    <message>
        <source>as commanded</source>
        <translation>wie befohlen</translation>
    </message>
    <message>
        <source>What this buys you</source>
        <translation>Was das bringt</translation>
    </message>
    <message>
        <source>The hand's error as commanded and corrected</source>
        <translation>Fehler der Hand, wie befohlen und korrigiert</translation>
    </message>
    <message>
        <source>What correcting buys</source>
        <translation>Was die Korrektur bringt</translation>
    </message>
    <message>
        <source>Being worked out over %1 poses like the measured ones ...</source>
        <translation>Wird über %1 Posen wie die gemessenen berechnet ...</translation>
    </message>
    <message>
        <source>%1 of the poses cannot be corrected within the joints' limits.</source>
        <translation>%1 der Posen lassen sich in den Grenzen der Gelenke nicht korrigieren.</translation>
    </message>
    <message>
        <source>; with it %1 % of the error would be left</source>
        <translation>; damit blieben %1 % des Fehlers</translation>
    </message>
    <message>
        <source> (%1 → %2 %3)</source>
        <translation> (%1 → %2 %3)</translation>
    </message>
    <message>
        <source> (Markers from a second look with wider gates; not part of the fit.)</source>
        <translation> (Marker vom zweiten Blick mit weiteren Grenzen; nicht in der Anpassung.)</translation>
    </message>
    <message>
        <source> And %1 more.</source>
        <translation> Und %1 weitere.</translation>
    </message>
    <message>
        <source> Error %1 → %2</source>
        <translation> Fehler %1 → %2</translation>
    </message>
    <message>
        <source> The size that fits best is %1 %2.</source>
        <translation> Am besten passt %1 %2.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>%1 at the hand (%2)</source>
        <translation>%1 an der Hand (%2)</translation>
    </message>
    <message>
        <source> deg</source>
        <translation> Grad</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Most of the error comes from %1.</source>
        <translation>Der Fehler kommt zum größeren Teil %1.</translation>
    </message>
    <message>
        <source>The error comes from %1.</source>
        <translation>Der Fehler kommt %1.</translation>
    </message>
    <message>
        <source>The largest part of the error comes from %1.</source>
        <translation>Am meisten vom Fehler kommt %1.</translation>
    </message>
    <message>
        <source>; with it the error would be down at the noise</source>
        <translation>; damit läge der Fehler beim Rauschen</translation>
    </message>
    <message>
        <source>%1 mrad</source>
        <translation>%1 mrad</translation>
    </message>
    <message>
        <source>%1 mrad (%2: %3 mrad)</source>
        <translation>%1 mrad (%2: %3 mrad)</translation>
    </message>
    <message>
        <source>Error on observations that the fit has not seen: %1; noise: %2.</source>
        <translation>Fehler auf ungesehenen Beobachtungen: %1; Rauschen: %2.</translation>
    </message>
    <message>
        <source>Error on the observations that were fitted: %1; noise: %2.</source>
        <translation>Fehler auf den angepassten Beobachtungen: %1; Rauschen: %2.</translation>
    </message>
    <message>
        <source>It holds for poses like those that were measured, and perhaps for no others.</source>
        <translation>Es gilt für Posen wie die gemessenen, und vielleicht für keine anderen.</translation>
    </message>
    <message>
        <source>There is nothing to add. Poses that are measured again tell how well the robot comes back to them.</source>
        <translation>Es ist nichts hinzuzufügen. Posen, die noch einmal gemessen werden, sagen, wie gut der Roboter zu ihnen zurückkommt.</translation>
    </message>
    <message>
        <source>Poses that differ from those there are tell the most.</source>
        <translation>Posen, die anders sind als die vorhandenen, sagen am meisten.</translation>
    </message>
    <message>
        <source>Look at the plots of what is left, and at the observations that it is largest in.</source>
        <translation>Sieh dir die Diagramme dessen an, was bleibt, und die Beobachtungen, in denen es am größten ist.</translation>
    </message>
    <message>
        <source>A curve shows what it follows; it has no name in the catalogue.</source>
        <translation>Eine Kurve zeigt, wem es folgt; im Katalog hat sie keinen Namen.</translation>
    </message>
    <message>
        <source>Why not ...? says of every effect why it was not added.</source>
        <translation>Warum nicht ...? sagt von jedem Effekt, warum er nicht hinzugefügt wurde.</translation>
    </message>
    <message>
        <source>%1 %2: the size that the fit wants, against what is plausible (± %3).</source>
        <translation>%1 %2: die Größe, die die Anpassung will, gegen das, was glaubhaft ist (± %3).</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 - Handsight</source>
        <translation>%1 - Handsight</translation>
    </message>
    <message>
        <source>%1 across the line of sight</source>
        <translation>%1 quer zur Sichtlinie</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 gegen %2</translation>
    </message>
    <message>
        <source>%1 against the %2: %3; at most %4 here.</source>
        <translation>%1 gegen %2: %3; hier höchstens %4.</translation>
    </message>
    <message>
        <source>%1 alone cannot show an error: label or play more.</source>
        <translation>%1 allein kann keinen Fehler zeigen: markiere oder spiele mehr ab.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 bends across its axis by %2 %3 for each %4: %5 at most here, so %6.</source>
        <translation>%1 biegt sich quer zur Achse um %2 %3 je %4: hier höchstens %5, also %6.</translation>
    </message>
    <message>
        <source>%1 by hand</source>
        <translation>%1 von Hand</translation>
    </message>
    <message>
        <source>%1 cannot be read as an image (%2). Copy it again from where it came.</source>
        <translation>%1 ist nicht als Bild zu lesen (%2). Kopiere es nochmals von dort, wo es herkam.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>%1 ist nicht zu schreiben: %2. Wähle einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1 effects</source>
        <translation>%1 Ursachen</translation>
    </message>
    <message>
        <source>%1 excluded</source>
        <translation>%1 ausgeschlossen</translation>
    </message>
    <message>
        <source>%1 gives way by %2 %3 for each %4: %5 at most here, so %6.</source>
        <translation>%1 gibt um %2 %3 je %4 nach: hier höchstens %5, also %6.</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 is %2 x %3 px, the %4 camera says %5 x %6: images of another size are left out.</source>
        <translation>%1 ist %2 x %3 px, die Kamera %4 sagt %5 x %6: Bilder anderer Größe bleiben weg.</translation>
    </message>
    <message>
        <source>%1 is %2 x %3, the camera says %4 x %5. Use the images that the camera was calibrated with.</source>
        <translation>%1 ist %2 x %3, die Kamera sagt %4 x %5. Nimm die Bilder, mit denen die Kamera kalibriert ist.</translation>
    </message>
    <message>
        <source>%1 is cut off after %2 bytes. Copy it again from where it came.</source>
        <translation>%1 ist nach %2 Bytes abgeschnitten. Kopiere es nochmals von dort, wo es herkam.</translation>
    </message>
    <message>
        <source>%1 is not there. Put it back, or leave the observation out.</source>
        <translation>%1 ist nicht da. Lege es zurück oder lass die Beobachtung weg.</translation>
    </message>
    <message>
        <source>Known to be wrong and not counted: %1.</source>
        <translation>Bekannt falsch und nicht gezählt: %1.</translation>
    </message>
    <message>
        <source>%1 left out of the fit: %2.</source>
        <translation>%1 aus der Anpassung gelassen: %2.</translation>
    </message>
    <message>
        <source>%1 lie</source>
        <translation>liegen %1</translation>
    </message>
    <message>
        <source>%1 links, %2 joints that move by themselves.</source>
        <translation>%1 Glieder, %2 Gelenke, die sich von selbst bewegen.</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>%1 more markers.</source>
        <translation>Noch %1 Marker.</translation>
    </message>
    <message>
        <source>%1 more poses would %2. Choose one to see it in 3D.</source>
        <translation>%1 Posen mehr würden %2. Wähle eine, um sie in 3D zu sehen.</translation>
    </message>
    <message>
        <source>%1 must end in .png, .svg or .csv.</source>
        <translation>%1 muss auf .png, .svg oder .csv enden.</translation>
    </message>
    <message>
        <source>%1 not used</source>
        <translation>%1 nicht benutzt</translation>
    </message>
    <message>
        <source>%1 numbers are wanted, one for each joint; there are %2.</source>
        <translation>%1 Zahlen werden gebraucht, eine je Gelenk; es sind %2.</translation>
    </message>
    <message>
        <source>%1 observations</source>
        <translation>%1 Beobachtungen</translation>
    </message>
    <message>
        <source>%1 odd</source>
        <translation>%1 auffällig</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 beyond</source>
        <translation>%1 von %2 dahinter</translation>
    </message>
    <message>
        <source>%1 of %2 effects</source>
        <translation>%1 von %2 Ursachen</translation>
    </message>
    <message>
        <source>%1 of %2 observations</source>
        <translation>%1 von %2 Beob.</translation>
    </message>
    <message>
        <source>%1 of %2 observations, %3 taken, %4 rejected</source>
        <translation>%1 von %2, %3 genommen, %4 verworfen</translation>
    </message>
    <message>
        <source>%1 of %2 observations. The cameras' mount is still unknown: %3 labelled, %4 left open, which agree on none yet.</source>
        <translation>%1 von %2 Beobachtungen. Der Sitz der Kameras ist noch unbekannt: %3 markiert, %4 offen, die sich noch auf keinen einigen.</translation>
    </message>
    <message>
        <source>%1 of %2.</source>
        <translation>%1 von %2.</translation>
    </message>
    <message>
        <source>%1 or %2: on these poses they look the same.</source>
        <translation>%1 oder %2: in diesen Posen sehen sie gleich aus.</translation>
    </message>
    <message>
        <source>%1 per second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>%1 poses of %2 joints.</source>
        <translation>%1 Posen von %2 Gelenken.</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 px, %2 m</source>
        <translation>%1 px, %2 m</translation>
    </message>
    <message>
        <source>%1 set aside</source>
        <translation>%1 beiseite gelegt</translation>
    </message>
    <message>
        <source>%1 sigma off</source>
        <translation>%1 Sigma daneben</translation>
    </message>
    <message>
        <source>%1 taken</source>
        <translation>%1 genommen</translation>
    </message>
    <message>
        <source>%1 taken, %2 rejected</source>
        <translation>%1 benutzt, %2 nicht</translation>
    </message>
    <message>
        <source>%1 to %2 %4: %3 observations</source>
        <translation>%1 bis %2 %4: %3 Beobachtungen</translation>
    </message>
    <message>
        <source>%1 to play</source>
        <translation>%1 abzuspielen</translation>
    </message>
    <message>
        <source>%1 wanted</source>
        <translation>%1 gewünscht</translation>
    </message>
    <message>
        <source>%1 was left out: its time, %2 s, is before that of the observation in front of it, %3 s. Mend the table and watch anew.</source>
        <translation>%1 blieb weg: seine Zeit, %2 s, liegt vor der der Beobachtung davor, %3 s. Berichtige die Tabelle und beobachte neu.</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>a curve of the %1</source>
        <translation>einer Kurve über: %1</translation>
    </message>
    <message>
        <source>above the noise</source>
        <translation>über dem Rauschen</translation>
    </message>
    <message>
        <source>%1, %2 mm at the hand</source>
        <translation>%1, %2 mm an der Hand</translation>
    </message>
    <message>
        <source>%1, drawn %2 ×</source>
        <translation>%1, gezeichnet %2 ×</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 in every pose, %3 mm at the hand at most.</source>
        <translation>%1: %2 in jeder Pose, höchstens %3 mm an der Hand.</translation>
    </message>
    <message>
        <source>%1: %2 in every pose.</source>
        <translation>%1: %2 in jeder Pose.</translation>
    </message>
    <message>
        <source>%1: held out %2, fitted %3</source>
        <translation>%1: ungesehen %2, angepasst %3</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n Aktion</numerusform>
            <numerusform>%n Aktionen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s)</source>
        <translation>
            <numerusform>%n Ursache</numerusform>
            <numerusform>%n Ursachen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n Gelenk</numerusform>
            <numerusform>%n Gelenke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n Marker</numerusform>
            <numerusform>%n Marker</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n observation(s)</source>
        <translation>
            <numerusform>%n Beobachtung</numerusform>
            <numerusform>%n Beobachtungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s)</source>
        <translation>
            <numerusform>%n Paar</numerusform>
            <numerusform>%n Paare</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rejected observation(s)</source>
        <translation>
            <numerusform>%n verworfene Beobachtung</numerusform>
            <numerusform>%n verworfene Beobachtungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Observation %1 is left out: alone it is off by %2.</source>
        <translation>Beobachtung %1 ist ausgelassen: Sie allein liegt um %2 daneben.</translation>
    </message>
    <message>
        <source>Observations %1 are left out: they alone are far off.</source>
        <translation>Die Beobachtungen %1 sind ausgelassen: Sie allein liegen weit daneben.</translation>
    </message>
    <message numerus="yes">
        <source>%n wrong point(s)</source>
        <translation>
            <numerusform>%n falscher Punkt</numerusform>
            <numerusform>%n falsche Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Close the session</source>
        <translation>Sitzung s&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Finden…</translation>
    </message>
    <message>
        <source>&amp;Fit again</source>
        <translation>Nochmals an&amp;passen</translation>
    </message>
    <message>
        <source>&amp;Full</source>
        <translation>&amp;Voll</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;Language, from the next start on</source>
        <translation>&amp;Sprache, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Bewegung</translation>
    </message>
    <message>
        <source>&amp;New session from images…</source>
        <translation>&amp;Neue Sitzung aus Bildern…</translation>
    </message>
    <message>
        <source>&amp;Open a session…</source>
        <translation>Sitzung &amp;öffnen…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Reduced: nothing moves on its way</source>
        <translation>&amp;Wenig: nichts bewegt sich dorthin</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thema</translation>
    </message>
    <message>
        <source>&amp;Undo everything</source>
        <translation>Alles &amp;rückgängig</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>, %1 chosen</source>
        <translation>, %1 gewählt</translation>
    </message>
    <message>
        <source>, %1 image</source>
        <translation>, Bild %1</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, noch %1</translation>
    </message>
    <message>
        <source>, across the line of sight</source>
        <translation>, quer zur Sichtlinie</translation>
    </message>
    <message>
        <source>, compressed beyond 3 σ</source>
        <translation>, jenseits von 3 σ gestaucht</translation>
    </message>
    <message>
        <source>, left</source>
        <translation>, links</translation>
    </message>
    <message>
        <source>, left image</source>
        <translation>, linkes Bild</translation>
    </message>
    <message>
        <source>, no image</source>
        <translation>, kein Bild</translation>
    </message>
    <message>
        <source>, not added</source>
        <translation>, nicht hinzugefügt</translation>
    </message>
    <message>
        <source>, plausible within about ± %1</source>
        <translation>, glaubhaft bis etwa ± %1</translation>
    </message>
    <message>
        <source>, predicted %1 σ</source>
        <translation>, vorhergesagt %1 σ</translation>
    </message>
    <message>
        <source>, right</source>
        <translation>, rechts</translation>
    </message>
    <message>
        <source>, right image</source>
        <translation>, rechtes Bild</translation>
    </message>
    <message>
        <source>. %1 without it in both images</source>
        <translation>. %1 ohne ihn in beiden Bildern</translation>
    </message>
    <message>
        <source>0 … 9, Delete</source>
        <translation>0 … 9, Entf</translation>
    </message>
    <message>
        <source>0 … 9, Delete on a marker</source>
        <translation>0 … 9, Entf</translation>
    </message>
    <message>
        <source>1 lies</source>
        <translation>liegt 1</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>: %1</source>
        <translation>: %1</translation>
    </message>
    <message>
        <source>; %1 not shown, without a residual or not used</source>
        <translation>; %1 nicht gezeigt, ohne Rest oder nicht benutzt</translation>
    </message>
    <message>
        <source>; 10,000 N m/rad where none is declared</source>
        <translation>; 10 000 N m/rad, wo keine angegeben ist</translation>
    </message>
    <message>
        <source>; TCP→Body moves %1 sigma</source>
        <translation>; TCP→Body rückt um %1 Sigma</translation>
    </message>
    <message>
        <source>; explains %1 %</source>
        <translation>; erklärt %1 %</translation>
    </message>
    <message>
        <source>; no more than chance</source>
        <translation>; nicht mehr als Zufall</translation>
    </message>
    <message>
        <source>; shows: %1</source>
        <translation>; zeigt: %1</translation>
    </message>
    <message>
        <source>; without a partner: %1</source>
        <translation>; ohne Partner: %1</translation>
    </message>
    <message>
        <source>A fit runs.</source>
        <translation>Eine Anpassung läuft.</translation>
    </message>
    <message>
        <source>A fit runs; the export follows it.</source>
        <translation>Eine Anpassung läuft; der Export folgt ihr.</translation>
    </message>
    <message>
        <source>A good answer need not be a name: where, following what, and how much.</source>
        <translation>Eine gute Antwort muss kein Name sein: wo, wonach und wie viel.</translation>
    </message>
    <message>
        <source>A guided arm that sags, and three bad poses with three different causes to find.</source>
        <translation>Ein geführter Arm, der durchhängt, und drei schlechte Posen mit drei Ursachen.</translation>
    </message>
    <message>
        <source>A hundred poses</source>
        <translation>Hundert Posen</translation>
    </message>
    <message>
        <source>A marker has no partner in the right image. Choose it, then click its corner there.</source>
        <translation>Ein Marker hat rechts keinen Partner. Wähle ihn, dann klicke dort auf seine Ecke.</translation>
    </message>
    <message>
        <source>A mesh cannot be shown. %1</source>
        <translation>Ein Netz ist nicht zu zeigen. %1</translation>
    </message>
    <message>
        <source>A quarter of a pixel is left. Is that the cameras, or is there something to be found?</source>
        <translation>Ein Viertelpixel bleibt. Sind das die Kameras, oder ist etwas zu finden?</translation>
    </message>
    <message>
        <source>A to B: %1 → %2 held out; TCP→Body moves %3 mm.</source>
        <translation>A nach B: %1 → %2 ungesehen; TCP→Body rückt um %3 mm.</translation>
    </message>
    <message>
        <source>off along the reading (mm)</source>
        <translation>Abweichung entlang der Ablesung (mm)</translation>
    </message>
    <message>
        <source>How far off along what was read, mm</source>
        <translation>Wie weit daneben entlang dessen, was abgelesen wurde, mm</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>What was touched; sorts by how far off</source>
        <translation>Was berührt wurde; sortiert nach der Abweichung</translation>
    </message>
    <message>
        <source>Nothing was touched in this observation.</source>
        <translation>In dieser Beobachtung wurde nichts berührt.</translation>
    </message>
    <message>
        <source>By tip %1.</source>
        <translation>Mit Spitze %1.</translation>
    </message>
    <message>
        <source>Off by %1 in space.</source>
        <translation>Im Raum um %1 daneben.</translation>
    </message>
    <message>
        <source>Off by %1 along what was read.</source>
        <translation>Entlang der Ablesung um %1 daneben.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Cannot be split by touches</source>
        <translation>Nicht aufteilbar bei Berührungen</translation>
    </message>
    <message>
        <source>The reading is %1 times the noise from where the model has the tip.</source>
        <translation>Die Ablesung liegt das %1-Fache des Rauschens von dort, wo das Modell die Spitze hat.</translation>
    </message>
    <message>
        <source>Touches have no images: there is nothing to label.</source>
        <translation>Berührungen haben keine Bilder: zu markieren ist nichts.</translation>
    </message>
    <message>
        <source>Touches are fitted all at once: there is nothing to play.</source>
        <translation>Berührungen werden alle auf einmal angepasst: abzuspielen ist nichts.</translation>
    </message>
    <message>
        <source>Right only together with where the fixtures stand, which was estimated with it.</source>
        <translation>Nur zusammen mit den mitgeschätzten Orten der Vorrichtungen richtig.</translation>
    </message>
    <message>
        <source>along its normal</source>
        <translation>längs Normale</translation>
    </message>
    <message>
        <source>Where it stands on %1, estimated with the rest.</source>
        <translation>Wo es auf %1 steht, mitgeschätzt.</translation>
    </message>
    <message>
        <source>%1 more touches would %2. Choose one to see it in 3D.</source>
        <translation>%1 weitere Berührungen würden %2. Wähle eine, um sie in 3D zu sehen.</translation>
    </message>
    <message>
        <source>No touch of these fixtures would %1.</source>
        <translation>Keine Berührung dieser Vorrichtungen würde %1.</translation>
    </message>
    <message>
        <source>Far off along what was read: touched or read wrongly?</source>
        <translation>Weit daneben entlang der Ablesung: falsch berührt oder falsch abgelesen?</translation>
    </message>
    <message>
        <source>%1 mm along %2</source>
        <translation>%1 mm entlang %2</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>Berührungen</translation>
    </message>
    <message>
        <source>held out mm</source>
        <translation>ungesehen mm</translation>
    </message>
    <message>
        <source>where it stands</source>
        <translation>wo es steht</translation>
    </message>
    <message>
        <source>What was touched</source>
        <translation>Was berührt wurde</translation>
    </message>
    <message>
        <source>The fixtures and the tip are found with the robot.</source>
        <translation>Die Vorrichtungen und die Spitze werden mit dem Roboter gefunden.</translation>
    </message>
    <message>
        <source>A tracker or a probe measures in space, not in images.</source>
        <translation>Ein Tracker oder ein Taster misst im Raum, nicht in Bildern.</translation>
    </message>
    <message>
        <source>A probe and a plate</source>
        <translation>Ein Taster und eine Platte</translation>
    </message>
    <message>
        <source>No camera, no tracker: a plate in three places and two sockets were touched. What is wrong?</source>
        <translation>Keine Kamera, kein Tracker: berührt wurden eine Platte an drei Orten und zwei Pfannen. Was stimmt nicht?</translation>
    </message>
    <message>
        <source>A real robot: a Panda and four sockets</source>
        <translation>Ein echter Roboter: ein Panda und vier Pfannen</translation>
    </message>
    <message>
        <source>Measured with a printed ball and sockets, by people in Delft. What is wrong with it, nobody knows.</source>
        <translation>Mit gedruckter Kugel und Pfannen gemessen, in Delft. Was an ihm nicht stimmt, weiß niemand.</translation>
    </message>
    <message>
        <source>nothing need be known of it</source>
        <translation>bekannt sein muss davon nichts</translation>
    </message>
    <message>
        <source>not known: estimated</source>
        <translation>unbekannt: wird geschätzt</translation>
    </message>
    <message>
        <source>How exactly a touch tells (sigma)</source>
        <translation>Wie genau eine Berührung ist (Sigma)</translation>
    </message>
    <message>
        <source>Known distances, m; a semicolon between them</source>
        <translation>Bekannte Abstände, m; dazwischen ein Strichpunkt</translation>
    </message>
    <message>
        <source>What is known of %1</source>
        <translation>Was von %1 bekannt ist</translation>
    </message>
    <message>
        <source>What is %1?</source>
        <translation>Was ist %1?</translation>
    </message>
    <message>
        <source>the fixture</source>
        <translation>der Vorrichtung</translation>
    </message>
    <message>
        <source>%1: a table of touches</source>
        <translation>%1: eine Tabelle von Berührungen</translation>
    </message>
    <message>
        <source>I touch things</source>
        <translation>Ich berühre Dinge</translation>
    </message>
    <message>
        <source>No camera: a probe's tip touches plates, sockets, gauges.</source>
        <translation>Keine Kamera: die Spitze eines Tasters berührt Platten, Pfannen, Messuhren.</translation>
    </message>
    <message>
        <source>A tracker session has no images.</source>
        <translation>Eine Trackersitzung hat keine Bilder.</translation>
    </message>
    <message>
        <source>A sensor that tells poses has no images.</source>
        <translation>Ein Sensor, der Posen nennt, hat keine Bilder.</translation>
    </message>
    <message>
        <source>A tracker session has no images; its markers are points already.</source>
        <translation>Eine Trackersitzung hat keine Bilder; ihre Marker sind schon Punkte.</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a candidate, and its fit is drawn here as it runs.</source>
        <translation>Füge einen Kandidaten hinzu, und seine Anpassung wird hier gezeichnet.</translation>
    </message>
    <message>
        <source>Rests after the cause that is being added, so that its proof can be looked at</source>
        <translation>Ruht nach der Ursache, die gerade dazukommt, damit man ihren Beweis ansehen kann</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Add until it stops</source>
        <translation>Bis zum Schluss</translation>
    </message>
    <message>
        <source>Beyond the noise it leaves scatter from pose to pose, as of %1.</source>
        <translation>Über das Rauschen hinaus bleibt Streuung von Pose zu Pose, wie von %1.</translation>
    </message>
    <message>
        <source>Seek longer</source>
        <translation>Länger suchen</translation>
    </message>
    <message>
        <source>Begins again with each other name, and without each of those that were added: takes minutes; what it finds is taken where it is clearly likelier and predicts as well</source>
        <translation>Beginnt von Neuem mit jedem anderen Namen, und ohne jeden der hinzugefügten: dauert Minuten; was es findet, wird genommen, wo es deutlich wahrscheinlicher ist und ebenso gut vorhersagt</translation>
    </message>
    <message>
        <source>Beginning again from other names</source>
        <translation>Von anderen Namen aus wird von Neuem begonnen</translation>
    </message>
    <message>
        <source>Nothing better was found from any other beginning.</source>
        <translation>Von keinem anderen Anfang aus wurde Besseres gefunden.</translation>
    </message>
    <message>
        <source>Seeking other names for what is in the model</source>
        <translation>Andere Namen für das, was im Modell ist, werden gesucht</translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation>%1 wird hinzugefügt</translation>
    </message>
    <message>
        <source>Adds it to the model and fits (Enter)</source>
        <translation>Fügt es dem Modell hinzu und passt an (Eingabe)</translation>
    </message>
    <message>
        <source>Adds the first card, and the first of what is left, until nothing more helps; then seeks other names that explain what was added better</source>
        <translation>Fügt die erste Karte hinzu, und die erste von denen, die bleiben, bis nichts mehr hilft; sucht dann andere Namen, die das Hinzugefügte besser erklären</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Nachher: %1</translation>
    </message>
    <message>
        <source>Agrees with the model down to the noise. </source>
        <translation>Stimmt mit dem Modell bis auf das Rauschen überein. </translation>
    </message>
    <message>
        <source>All %1 markers are placed. Drag one, or remove it first.</source>
        <translation>Alle %1 Marker sind gesetzt. Ziehe einen oder entferne ihn zuerst.</translation>
    </message>
    <message>
        <source>All effects</source>
        <translation>Alle Ursachen</translation>
    </message>
    <message>
        <source>All effects, with one verdict each</source>
        <translation>Alle Ursachen, je ein Urteil</translation>
    </message>
    <message>
        <source>An action, observation, joint, effect or key</source>
        <translation>Eine Aktion, Beobachtung, Ursache, ein Gelenk oder eine Taste</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Und %1 weitere.</translation>
    </message>
    <message>
        <source>Angle-axis</source>
        <translation>Drehvektor</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Arrows, Shift+arrows</source>
        <translation>Pfeile, Umschalt+Pfeile</translation>
    </message>
    <message>
        <source>As I clicked them</source>
        <translation>Wie ich sie geklickt habe</translation>
    </message>
    <message>
        <source>As a matrix, in m:</source>
        <translation>Als Matrix, in m:</translation>
    </message>
    <message>
        <source>As fast as it goes</source>
        <translation>So schnell es geht</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>As the left camera sees it</source>
        <translation>Wie die linke Kamera es sieht</translation>
    </message>
    <message>
        <source>As the other observations number them</source>
        <translation>So nummerieren es die anderen</translation>
    </message>
    <message>
        <source>Back to the candidates</source>
        <translation>Zurück zu den Kandidaten</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Sockel</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Vorher: %1</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Beste</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>By their sides these are markers %1 of the other observations: renumbered.</source>
        <translation>Nach ihren Seiten sind dies die Marker %1 der anderen Beobachtungen: umnummeriert.</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera mount</source>
        <translation>Sitz der Kameras</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Cameras %1 %, body %2 %, robot %3 %</source>
        <translation>Kameras %1 %, Körper %2 %, Roboter %3 %</translation>
    </message>
    <message>
        <source>Tracker %1 %, body %2 %, robot %3 %</source>
        <translation>Tracker %1 %, Körper %2 %, Roboter %3 %</translation>
    </message>
    <message>
        <source>Cameras %1 mm apart.</source>
        <translation>Kameras %1 mm auseinander.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Candidates on the epipolar line</source>
        <translation>Kandidaten auf der Epipolarlinie</translation>
    </message>
    <message>
        <source>Invisible on these poses</source>
        <translation>Hier nicht zu sehen</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>Checked on the robot</source>
        <translation>Am Roboter geprüft</translation>
    </message>
    <message>
        <source>Chi-squared per degree of freedom</source>
        <translation>Chi-Quadrat je Freiheitsgrad</translation>
    </message>
    <message>
        <source>Choose an observation in the strip, a plot or the 3D view.</source>
        <translation>Wähle eine Beobachtung im Streifen, in einem Diagramm oder in 3D.</translation>
    </message>
    <message>
        <source>Choose an observation in the strip.</source>
        <translation>Wähle eine Beobachtung im Streifen.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Click a marker's corner in the left image first.</source>
        <translation>Klicke zuerst im linken Bild auf die Ecke eines Markers.</translation>
    </message>
    <message>
        <source>Click a marker's corner in the left image.</source>
        <translation>Klicke im linken Bild auf die Ecke eines Markers.</translation>
    </message>
    <message>
        <source>Click near a marker's corner in the left image: it snaps, and its partner in the right image is found along the epipolar line. Drag a marker, nudge it with the arrows, press a digit to renumber it, Delete to remove it. Hold Alt to set it freely.</source>
        <translation>Klicke im linken Bild nahe an die Ecke eines Markers: er rastet ein, und sein Partner im rechten Bild wird entlang der Epipolarlinie gefunden. Ziehe einen Marker, rücke ihn mit den Pfeilen, drücke eine Ziffer zum Umnummerieren, Entf zum Entfernen. Halte Alt, um frei zu setzen.</translation>
    </message>
    <message>
        <source>Click, Alt+click</source>
        <translation>Klick, Alt+Klick</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Comes with the fit of %1 observations.</source>
        <translation>Kommt mit der Anpassung an %1 Beobachtungen.</translation>
    </message>
    <message>
        <source>Comparing the three objectives</source>
        <translation>Vergleich der drei Zielfunktionen</translation>
    </message>
    <message>
        <source>Copied, in m and rad.</source>
        <translation>Kopiert, in m und rad.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers as CSV</source>
        <translation>Zahlen als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Cost of the running fit</source>
        <translation>Verlauf der laufenden Anpassung</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>Entscheidungen</translation>
    </message>
    <message>
        <source>Decisions, errors of then</source>
        <translation>Entscheidungen, Fehler von damals</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Delete, Insert</source>
        <translation>Entf, Einfg</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Do again</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Do again: %1 (%2)</source>
        <translation>Wiederholen: %1 (%2)</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Done again: %1%2</source>
        <translation>Wiederholt: %1%2</translation>
    </message>
    <message>
        <source>Done: %1, and nothing is missing any more.</source>
        <translation>Fertig: %1, und nichts fehlt mehr.</translation>
    </message>
    <message>
        <source>Down at the noise, but not all has a name</source>
        <translation>Beim Rauschen, aber nicht alles hat einen Namen</translation>
    </message>
    <message>
        <source>A curve stands in the model for it; what causes it on the robot is not known.</source>
        <translation>Eine Kurve steht dafür im Modell; was sie am Roboter verursacht, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Drag the threshold: what lies beyond it can be excluded.</source>
        <translation>Ziehe die Schwelle: was dahinter liegt, lässt sich ausschließen.</translation>
    </message>
    <message>
        <source>Each dot is the residual of one corner, to the right and down in %1; the rings are one and three sigma of the noise. F fits the axes, L makes them linear.</source>
        <translation>Jeder Punkt ist der Rest einer Ecke, nach rechts und unten in %1; die Ringe sind ein und drei Sigma des Rauschens. F passt die Achsen an, L macht sie linear.</translation>
    </message>
    <message>
        <source>Effective masses</source>
        <translation>Wirksame Massen</translation>
    </message>
    <message>
        <source>Effects in the model</source>
        <translation>Ursachen im Modell</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Error %1, noise %2</source>
        <translation>Fehler %1, Rauschen %2</translation>
    </message>
    <message>
        <source>Error after it</source>
        <translation>Fehler danach</translation>
    </message>
    <message>
        <source>Error fitted, rms</source>
        <translation>Fehler angepasst, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Error held out, rms</source>
        <translation>Fehler ungesehen, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Error now %1, noise %2, ratio %3</source>
        <translation>Fehler jetzt %1, Rauschen %2, Verhältnis %3</translation>
    </message>
    <message>
        <source>Error now, noise floor, ratio</source>
        <translation>Fehler jetzt, Grundrauschen, Verhältnis</translation>
    </message>
    <message>
        <source>Error of each observation against the noise (hatched: what noise alone shows)</source>
        <translation>Fehler jeder Beobachtung gegen das Rauschen (schraffiert: was Rauschen allein zeigt)</translation>
    </message>
    <message>
        <source>Error of each version of the model</source>
        <translation>Fehler jeder Fassung des Modells</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Estimate it again</source>
        <translation>Wieder schätzen</translation>
    </message>
    <message>
        <source>Every observation was used</source>
        <translation>Jede Beobachtung wurde benutzt</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 observations)</source>
        <translation>%1 (%2 von %3 Beobachtungen)</translation>
    </message>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Every observation was used.</source>
        <translation>Jede Beobachtung wurde benutzt.</translation>
    </message>
    <message>
        <source>Everything is saved in %1</source>
        <translation>Alles ist in %1 gespeichert</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Ausschließen</translation>
    </message>
    <message>
        <source>Exclude the chosen observations</source>
        <translation>Gewählte Beobachtungen ausschließen</translation>
    </message>
    <message>
        <source>Exclude them</source>
        <translation>Ausschließen</translation>
    </message>
    <message>
        <source>Expected odds after them: %1.</source>
        <translation>Erwartete Chancen danach: %1.</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export it</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>F, 1 … 6, 0</source>
        <translation>F, 1 … 6, 0</translation>
    </message>
    <message>
        <source>Before you use it</source>
        <translation>Vor dem Gebrauch</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Datei, die geschrieben wird</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Find the missing effect: shows step by step what to look at and what to do</source>
        <translation>Die fehlende Ursache finden: zeigt Schritt für Schritt, wohin zu sehen und was zu tun ist</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Fit by</source>
        <translation>Anpassen nach</translation>
    </message>
    <message>
        <source>Fit now</source>
        <translation>Jetzt anpassen</translation>
    </message>
    <message>
        <source>Fit the image</source>
        <translation>Bild einpassen</translation>
    </message>
    <message>
        <source>Fitting %1</source>
        <translation>Anpassung an %1</translation>
    </message>
    <message>
        <source>Fitting without them</source>
        <translation>Anpassung ohne sie</translation>
    </message>
    <message>
        <source>Fold %1 away</source>
        <translation>%1 wegklappen</translation>
    </message>
    <message>
        <source>Fold the model away (M)</source>
        <translation>Modell wegklappen (M)</translation>
    </message>
    <message>
        <source>Fold the model panel</source>
        <translation>Modell einklappen</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>No fresh pose can test it: the fit has seen all that can be used.</source>
        <translation>Keine frische Pose kann es prüfen: die Schätzung hat alle brauchbaren gesehen.</translation>
    </message>
    <message>
        <source>Fresh poses: of %1 that the fit has not seen, %2 within the 95 % ellipsoid of those it has.</source>
        <translation>Frische Posen: von %1 ungesehenen %2 im 95-%-Ellipsoid der gesehenen.</translation>
    </message>
    <message>
        <source>From the selected</source>
        <translation>Von der gewählten</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Handsight</source>
        <translation>Handsight</translation>
    </message>
    <message>
        <source>Held: the fit leaves it where it is. Press to estimate it again</source>
        <translation>Gehalten: die Anpassung lässt sie stehen. Drücken, um wieder zu schätzen</translation>
    </message>
    <message>
        <source>Hidden 1: the used arm</source>
        <translation>Versteckt 1: der gebrauchte Arm</translation>
    </message>
    <message>
        <source>Hidden 2: the unknown corners</source>
        <translation>Versteckt 2: die unbekannten Ecken</translation>
    </message>
    <message>
        <source>Hidden 4: after the weekend</source>
        <translation>Versteckt 4: nach dem Wochenende</translation>
    </message>
    <message>
        <source>Hidden 5: a long afternoon</source>
        <translation>Versteckt 5: ein langer Nachmittag</translation>
    </message>
    <message>
        <source>Hidden 6: not the first answer</source>
        <translation>Versteckt 6: nicht die erste Antwort</translation>
    </message>
    <message>
        <source>Hidden 7: reflections</source>
        <translation>Versteckt 7: Spiegelungen</translation>
    </message>
    <message>
        <source>Hidden 8: another supplier</source>
        <translation>Versteckt 8: ein anderer Lieferant</translation>
    </message>
    <message>
        <source>Hidden was</source>
        <translation>Versteckt war</translation>
    </message>
    <message>
        <source>Hidden was: %1.</source>
        <translation>Versteckt war: %1.</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>Histogram of the residuals</source>
        <translation>Histogramm der Residuen</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>%1 halten</translation>
    </message>
    <message>
        <source>Hold N: noise alone    Hold B: before and after    Shift + drag: what have these in common?</source>
        <translation>N halten: Rauschen allein    B halten: vorher und nachher    Umschalt + Ziehen: was haben diese gemeinsam?</translation>
    </message>
    <message>
        <source>Hold the body's shape at its average</source>
        <translation>Form des Körpers auf ihrem Mittel halten</translation>
    </message>
    <message>
        <source>Hold these numbers</source>
        <translation>Zahlen halten</translation>
    </message>
    <message>
        <source>Hold this number: the fit leaves it where it is, and it can be typed</source>
        <translation>Diese Zahl halten: die Anpassung lässt sie stehen, und sie lässt sich tippen</translation>
    </message>
    <message>
        <source>How far the hand was from where the model predicts it, and how far 95 of 100 poses like the fitted ones are.</source>
        <translation>Wie weit die Hand von dort war, wo das Modell sie vorhersagt, und wie weit 95 von 100 Posen wie die angepassten es sind.</translation>
    </message>
    <message>
        <source>How much of the error the cameras (C), the marker body (B) and the robot (R) can answer for.</source>
        <translation>Wie viel des Fehlers auf die Kameras (C), den Markerkörper (B) und den Roboter (R) zurückgehen kann.</translation>
    </message>
    <message>
        <source>How much of the error the tracker (T), the marker body (B) and the robot (R) can answer for.</source>
        <translation>Wie viel des Fehlers der Tracker (T), der Markerkörper (B) und der Roboter (R) verantworten.</translation>
    </message>
    <message>
        <source>How much of this residual the cameras (C), the marker body (B) and the robot (R) can answer for.</source>
        <translation>Wie viel dieses Rests auf die Kameras (C), den Markerkörper (B) und den Roboter (R) zurückgehen kann.</translation>
    </message>
    <message>
        <source>How the error fell from step to step, fitted and held out; hatched: the noise</source>
        <translation>Wie der Fehler Schritt um Schritt fiel, angepasst und ungesehen; schraffiert: das Rauschen</translation>
    </message>
    <message>
        <source>I know where the left camera sits on its link</source>
        <translation>Ich weiß, wo die linke Kamera auf ihrem Glied sitzt</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Images of the left camera…</source>
        <translation>Bilder der linken Kamera…</translation>
    </message>
    <message>
        <source>Images of the right camera…</source>
        <translation>Bilder der rechten Kamera…</translation>
    </message>
    <message>
        <source>In some postures it misses much more than in others. Where is it, and how large?</source>
        <translation>In manchen Haltungen liegt er weit mehr daneben. Wo sitzt es, und wie groß ist es?</translation>
    </message>
    <message>
        <source>In the model: %1</source>
        <translation>Im Modell: %1</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>Einschließen</translation>
    </message>
    <message>
        <source>Include the chosen observations</source>
        <translation>Gewählte Beobachtungen einschließen</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfg</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>It follows nothing that was measured, and robots scatter less.</source>
        <translation>Es folgt nichts, was gemessen wurde, und Roboter streuen weniger.</translation>
    </message>
    <message>
        <source>It follows the %1 (%2).</source>
        <translation>Es folgt: %1 (%2).</translation>
    </message>
    <message>
        <source>It follows the %1.</source>
        <translation>Es folgt: %1.</translation>
    </message>
    <message>
        <source>It has no place in this session.</source>
        <translation>Hat in dieser Sitzung keinen Platz.</translation>
    </message>
    <message>
        <source>It is estimated with the rest; the model panel shows its size.</source>
        <translation>Wird mit dem Übrigen geschätzt; das Modell rechts zeigt die Größe.</translation>
    </message>
    <message>
        <source>It would leave %1; odds against nothing missing %2.</source>
        <translation>Es ließe %1; Chancen gegen „nichts fehlt“ %2.</translation>
    </message>
    <message>
        <source>Its markers were not found, at a second look neither: %1</source>
        <translation>Ihre Marker wurden nicht gefunden, auch beim zweiten Blick nicht: %1</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>A ChArUco board on the hand, twelve images, nothing to label: play, export.</source>
        <translation>Ein ChArUco-Brett an der Hand, zwölf Bilder, nichts zu beschriften: abspielen, exportieren.</translation>
    </message>
    <message>
        <source>One camera and a printed board</source>
        <translation>Eine Kamera und ein gedrucktes Brett</translation>
    </message>
    <message>
        <source>No URDF: the controller says where the flange is</source>
        <translation>Keine URDF: Die Steuerung sagt, wo der Flansch ist</translation>
    </message>
    <message>
        <source>What bends or is off in the joints can then not be told apart.</source>
        <translation>Was sich in den Gelenken biegt oder nicht stimmt, lässt sich dann nicht unterscheiden.</translation>
    </message>
    <message>
        <source>Poses of the flange</source>
        <translation>Posen des Flansches</translation>
    </message>
    <message>
        <source>CSV or YAML: x y z qx qy qz qw in the base's frame</source>
        <translation>CSV oder YAML: x y z qx qy qz qw im System der Basis</translation>
    </message>
    <message>
        <source>There are %1 poses of the flange for %2 poses of the target: each instant needs one of each, in the same order.</source>
        <translation>Es sind %1 Posen des Flansches für %2 Posen des Ziels: Jeder Augenblick braucht je eine, in derselben Reihenfolge.</translation>
    </message>
    <message>
        <source>There are %1 poses of the flange for %2 images: each instant needs one of each, in the same order.</source>
        <translation>Es sind %1 Posen des Flansches für %2 Bilder: Jeder Augenblick braucht je eins, in derselben Reihenfolge.</translation>
    </message>
    <message>
        <source>Camera on %1, target on %2: the flange moves, its poses are known.</source>
        <translation>Kamera auf %1, Ziel auf %2: Der Flansch bewegt sich, seine Posen sind bekannt.</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.yaml *.yml *.samples)</source>
        <translation>Tabellen (*.csv *.txt *.yaml *.yml *.samples)</translation>
    </message>
    <message>
        <source>Looking for new measurements</source>
        <translation>Sucht neue Messungen</translation>
    </message>
    <message>
        <source>A pose</source>
        <translation>Eine Pose</translation>
    </message>
    <message>
        <source>Waiting for the next pose of the target in poses.csv and %1 in joints.csv; %2 arrived.</source>
        <translation>Wartet auf die nächste Pose des Ziels in poses.csv und %1 in joints.csv; %2 angekommen.</translation>
    </message>
    <message>
        <source>Waiting for the next points in points.csv and %1 in joints.csv; %2 arrived.</source>
        <translation>Wartet auf die nächsten Punkte in points.csv und %1 in joints.csv; %2 angekommen.</translation>
    </message>
    <message>
        <source>that of the flange</source>
        <translation>die des Flansches</translation>
    </message>
    <message>
        <source>its joint angles</source>
        <translation>ihre Gelenkwinkel</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Justin guided by hand. In the morning's test everything was right.</source>
        <translation>Justin, von Hand geführt. Beim Test am Morgen stimmte alles.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Label observation %1 next</source>
        <translation>Als nächste Beobachtung %1 markieren</translation>
    </message>
    <message>
        <source>Least distance of the triangulated markers, m (thesis 4.41)</source>
        <translation>Kleinster Abstand der triangulierten Marker, m (Arbeit 4.41)</translation>
    </message>
    <message>
        <source>Least error in the images, px (thesis 4.42): the one to use</source>
        <translation>Kleinster Fehler in den Bildern, px (Arbeit 4.42): diese nehmen</translation>
    </message>
    <message>
        <source>Least error of each observation's body pose (thesis 4.39)</source>
        <translation>Kleinster Fehler der Körperlage jeder Beobachtung (Arbeit 4.39)</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Leaves the chosen observations out of the fit (Delete)</source>
        <translation>Lässt die gewählten Beobachtungen aus der Anpassung (Entf)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left images</source>
        <translation>Linke Bilder</translation>
    </message>
    <message>
        <source>Left out, it is found from the observations.</source>
        <translation>Ohne dies wird es aus den Beobachtungen gefunden.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Nochmals suchen</translation>
    </message>
    <message>
        <source>Look there</source>
        <translation>Dorthin sehen</translation>
    </message>
    <message>
        <source>Looking again at %1</source>
        <translation>Zweiter Blick auf %1</translation>
    </message>
    <message>
        <source>Looking for corners</source>
        <translation>Ecken werden gesucht</translation>
    </message>
    <message>
        <source>Looking for corners…</source>
        <translation>Ecken werden gesucht…</translation>
    </message>
    <message>
        <source>Looking for new images</source>
        <translation>Neue Bilder werden gesucht</translation>
    </message>
    <message>
        <source>Looking for poses that would %1 ...</source>
        <translation>Suche nach Posen, die %1 ...</translation>
    </message>
    <message>
        <source>Looking for what is missing</source>
        <translation>Ursachensuche</translation>
    </message>
    <message>
        <source>Looking where %1 would act</source>
        <translation>Suche, wo %1 säße</translation>
    </message>
    <message>
        <source>Looks from there (F, 1 to 6, 0)</source>
        <translation>Sieht von dort hin (F, 1 bis 6, 0)</translation>
    </message>
    <message>
        <source>Magnification of deviations</source>
        <translation>Vergrößerung der Abweichungen</translation>
    </message>
    <message>
        <source>Make the session</source>
        <translation>Sitzung anlegen</translation>
    </message>
    <message>
        <source>Marker %1 is on this corner already. Take another corner.</source>
        <translation>Marker %1 sitzt schon auf dieser Ecke. Nimm eine andere.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Markers are clicked in sessions of two cameras. These labels came with the session.</source>
        <translation>Marker werden in Sitzungen mit zwei Kameras angeklickt. Diese Beschriftung kam mit der Sitzung.</translation>
    </message>
    <message>
        <source>Mass: the force at the TCP, as a mass, that pulls it toward the measured marker. Before and after: how far the marker is off. Angle: between that and what the springs can do at all.</source>
        <translation>Masse: die Kraft am TCP, als Masse, die ihn zum gemessenen Marker zieht. Vorher und nachher: wie weit der Marker daneben liegt. Winkel: zwischen dem und dem, was die Federn überhaupt können.</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Measured on the robot</source>
        <translation>Am Roboter gemessen</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>More than three times what is usual.</source>
        <translation>Mehr als das Dreifache des Üblichen.</translation>
    </message>
    <message>
        <source>More than three times what is usual, and it leaves much. Probably another cause.</source>
        <translation>Mehr als das Dreifache des Üblichen, und es bleibt viel übrig. Wohl eine andere Ursache.</translation>
    </message>
    <message>
        <source>Larger than robots are built. Probably another cause.</source>
        <translation>Größer, als Roboter gebaut sind. Wohl eine andere Ursache.</translation>
    </message>
    <message>
        <source>Most likely missing: %1%2.</source>
        <translation>Am wahrscheinlichsten fehlt: %1%2.</translation>
    </message>
    <message>
        <source>Move the pointer over the image.</source>
        <translation>Führe den Zeiger über das Bild.</translation>
    </message>
    <message>
        <source>N, B held down</source>
        <translation>N, B gehalten</translation>
    </message>
    <message>
        <source>New session from images…</source>
        <translation>Neue Sitzung aus Bildern…</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next observation</source>
        <translation>Nächste Beobachtung</translation>
    </message>
    <message>
        <source>Next unit of sizes</source>
        <translation>Nächste Einheit der Größen</translation>
    </message>
    <message>
        <source>Nine patterns of the residual</source>
        <translation>Muster des Rests</translation>
    </message>
    <message>
        <source>Nine views of the residual appear here once there is a fit.</source>
        <translation>Ansichten des Rests erscheinen hier, sobald es eine Anpassung gibt.</translation>
    </message>
    <message>
        <source>No corner within 12 px. Hold Alt to set it freely.</source>
        <translation>Keine Ecke im Umkreis von 12 px. Halte Alt, um frei zu setzen.</translation>
    </message>
    <message>
        <source>No decisions yet.</source>
        <translation>Noch keine Entscheidungen.</translation>
    </message>
    <message>
        <source>No diagnosis yet.</source>
        <translation>Noch keine Diagnose.</translation>
    </message>
    <message>
        <source>No effect is called "%1". What it does may still be in the catalogue: try another word.</source>
        <translation>Keine Ursache heißt „%1“. Was sie tut, kann doch im Katalog sein: versuche ein anderes Wort.</translation>
    </message>
    <message>
        <source>No fit yet.</source>
        <translation>Noch keine Anpassung.</translation>
    </message>
    <message>
        <source>No image.</source>
        <translation>Kein Bild.</translation>
    </message>
    <message>
        <source>No joint of this robot follows another.</source>
        <translation>Kein Gelenk dieses Roboters folgt einem anderen.</translation>
    </message>
    <message>
        <source>No marker is labelled in this observation.</source>
        <translation>In dieser Beobachtung ist kein Marker gesetzt.</translation>
    </message>
    <message>
        <source>No model yet.</source>
        <translation>Noch kein Modell.</translation>
    </message>
    <message>
        <source>No observation is like that.</source>
        <translation>Keine Beobachtung ist so.</translation>
    </message>
    <message>
        <source>No observation stands out of the noise.</source>
        <translation>Keine Beobachtung ragt aus dem Rauschen.</translation>
    </message>
    <message>
        <source>No observations yet.</source>
        <translation>Noch keine Beobachtungen.</translation>
    </message>
    <message>
        <source>No other observation has images.</source>
        <translation>Keine andere Beobachtung hat Bilder.</translation>
    </message>
    <message>
        <source>No pose that the cameras could see would %1.</source>
        <translation>Keine Pose, die die Kameras sehen, würde %1.</translation>
    </message>
    <message>
        <source>No residuals yet.</source>
        <translation>Noch keine Reste.</translation>
    </message>
    <message>
        <source>No robot yet.</source>
        <translation>Noch kein Roboter.</translation>
    </message>
    <message>
        <source>No version of the model yet.</source>
        <translation>Noch keine Fassung des Modells.</translation>
    </message>
    <message>
        <source>Noise alone on the same poses, draw %1</source>
        <translation>Rauschen allein in denselben Posen, Ziehung %1</translation>
    </message>
    <message>
        <source>Not added: %1 has no place in this session.</source>
        <translation>Nicht hinzugefügt: %1 hat in dieser Sitzung keinen Platz.</translation>
    </message>
    <message>
        <source>Not added: it could not be written down; make room on the disk.</source>
        <translation>Nicht hinzugefügt: es war nicht aufzuschreiben; schaffe Platz auf der Platte.</translation>
    </message>
    <message>
        <source>Not added: with %1 the error on unseen observations would not fall below %2. It would fit noise.</source>
        <translation>Nicht hinzugefügt: mit %1 fiele der Fehler auf ungesehenen Beobachtungen nicht unter %2. Es wäre dem Rauschen angepasst.</translation>
    </message>
    <message>
        <source>Not found (yet).</source>
        <translation>(Noch) nicht gefunden.</translation>
    </message>
    <message>
        <source>Not in this session</source>
        <translation>Nicht in dieser Sitzung</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>Nicht benutzt</translation>
    </message>
    <message>
        <source>Not yet fitted.</source>
        <translation>Noch nicht angepasst.</translation>
    </message>
    <message>
        <source>Not yet saved in session.xml (Ctrl+S). Nothing is lost if you close.</source>
        <translation>Noch nicht in session.xml gespeichert (Strg+S). Beim Schließen geht nichts verloren.</translation>
    </message>
    <message>
        <source>Nothing in the residuals speaks for it beyond chance.</source>
        <translation>Nichts im Rest spricht dafür, was nicht Zufall wäre.</translation>
    </message>
    <message>
        <source>Sure to %1.</source>
        <translation>Sicher zu %1.</translation>
    </message>
    <message>
        <source>It is there with a probability of %1; predictions allow for it.</source>
        <translation>Es ist mit einer Wahrscheinlichkeit von %1 da; Vorhersagen berücksichtigen es.</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>Nichts heißt so.</translation>
    </message>
    <message>
        <source>Nothing is missing</source>
        <translation>Nichts fehlt</translation>
    </message>
    <message>
        <source>No cause that these poses can show would lower the error on observations that the fit has not seen.</source>
        <translation>Keine Ursache, die diese Posen zeigen können, würde den Fehler ungesehener Beobachtungen senken.</translation>
    </message>
    <message>
        <source>Nothing lies beyond %1.</source>
        <translation>Nichts liegt jenseits von %1.</translation>
    </message>
    <message>
        <source>Nothing selected</source>
        <translation>Nichts gewählt</translation>
    </message>
    <message>
        <source>Nothing to add.</source>
        <translation>Nichts hinzuzufügen.</translation>
    </message>
    <message>
        <source>Nothing to export: %1</source>
        <translation>Nichts zu exportieren: %1</translation>
    </message>
    <message>
        <source>Nothing to export: TCP→Body has not been estimated.</source>
        <translation>Nichts zu exportieren: TCP→Body ist nicht geschätzt.</translation>
    </message>
    <message>
        <source>Nothing to label here.</source>
        <translation>Hier ist nichts zu markieren.</translation>
    </message>
    <message>
        <source>Nothing to plot yet.</source>
        <translation>Noch nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nichts zu wiederholen</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Nothing was done to the robot, they say, and still the error is six times what it was.</source>
        <translation>Am Roboter wurde nichts getan, heißt es, und doch ist der Fehler sechsmal so groß.</translation>
    </message>
    <message>
        <source>Nothing was hidden.</source>
        <translation>Nichts war versteckt.</translation>
    </message>
    <message>
        <source>Nothing with a name explains it</source>
        <translation>Nichts mit Namen erklärt es</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Zielfunktion</translation>
    </message>
    <message>
        <source>Observation</source>
        <translation>Beobachtung</translation>
    </message>
    <message>
        <source>Observation %1</source>
        <translation>Beobachtung %1</translation>
    </message>
    <message>
        <source>Observation %1 has no images to label.</source>
        <translation>Beobachtung %1 hat keine Bilder zum Markieren.</translation>
    </message>
    <message>
        <source>Observation %1: markers measured and predicted, residuals times %2</source>
        <translation>Beobachtung %1: Marker gemessen und vorhergesagt, Reste mal %2</translation>
    </message>
    <message>
        <source>Observation %1; the model bends nothing</source>
        <translation>Beobachtung %1; das Modell biegt nichts</translation>
    </message>
    <message>
        <source>Observation strip</source>
        <translation>Streifen der Beobachtungen</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Beobachtungen</translation>
    </message>
    <message>
        <source>Not named: %1.</source>
        <translation>Nicht genannt: %1.</translation>
    </message>
    <message>
        <source>Odds against nothing missing %1.</source>
        <translation>Chancen gegen „nichts fehlt“ %1.</translation>
    </message>
    <message>
        <source>Odds against nothing missing: %1.</source>
        <translation>Chancen gegen „nichts fehlt“: %1.</translation>
    </message>
    <message>
        <source>On the line of marker %1</source>
        <translation>Auf der Linie von Marker %1</translation>
    </message>
    <message>
        <source>On these poses both do the same to the images.</source>
        <translation>In diesen Posen machen beide dasselbe mit den Bildern.</translation>
    </message>
    <message>
        <source>One image point in twenty is wrong. Can the robot's error still be named?</source>
        <translation>Jeder zwanzigste Bildpunkt ist falsch. Lässt sich der Fehler des Roboters doch nennen?</translation>
    </message>
    <message>
        <source>One marker</source>
        <translation>Ein Marker</translation>
    </message>
    <message>
        <source>One more marker.</source>
        <translation>Noch ein Marker.</translation>
    </message>
    <message>
        <source>One observation (.)</source>
        <translation>Eine Beobachtung (.)</translation>
    </message>
    <message>
        <source>One panel fills the centre</source>
        <translation>Ein Feld füllt die Mitte</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open a session…</source>
        <translation>Sitzung öffnen…</translation>
    </message>
    <message>
        <source>Open, save, close</source>
        <translation>Öffnen, speichern, schließen</translation>
    </message>
    <message>
        <source>OpenCV (*.yml *.yaml *.xml *.json)</source>
        <translation>OpenCV (*.yml *.yaml *.xml *.json)</translation>
    </message>
    <message>
        <source>OpenCV's YAML or XML; several by ;</source>
        <translation>YAML oder XML von OpenCV; mehrere mit ;</translation>
    </message>
    <message>
        <source>Opened where you left it: %1 not yet saved in session.xml.</source>
        <translation>Geöffnet, wo du aufgehört hast: %1 noch nicht in session.xml gespeichert.</translation>
    </message>
    <message>
        <source>Opens it in Label; with its markers labelled the play goes on by itself</source>
        <translation>Öffnet sie unter Markieren; sind ihre Marker gesetzt, geht es von selbst weiter</translation>
    </message>
    <message>
        <source>Opens the observation in Label</source>
        <translation>Öffnet die Beobachtung unter Markieren</translation>
    </message>
    <message>
        <source>Order changed: sort again</source>
        <translation>Reihenfolge anders: neu ordnen</translation>
    </message>
    <message>
        <source>Over the image</source>
        <translation>Über dem Bild</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Own pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Plan poses</source>
        <translation>Posen planen</translation>
    </message>
    <message>
        <source>Planning poses</source>
        <translation>Posen werden geplant</translation>
    </message>
    <message>
        <source>Plausible within about ± %1.</source>
        <translation>Glaubhaft bis etwa ± %1.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Nochmals</translation>
    </message>
    <message>
        <source>Play from the first observation again</source>
        <translation>Wieder von der ersten Beobachtung an</translation>
    </message>
    <message>
        <source>Play, and the six parameters converge here.</source>
        <translation>Abspielen, und die sechs Parameter laufen hier zusammen.</translation>
    </message>
    <message>
        <source>Play: each observation is taken, or rejected with its reason.</source>
        <translation>Abspielen: jede Beobachtung wird genommen oder mit ihrem Grund verworfen.</translation>
    </message>
    <message>
        <source>Playing</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Point at an effect, and here stands why. A double click opens its slider.</source>
        <translation>Zeige auf eine Ursache, und hier steht warum. Ein Doppelklick öffnet ihren Regler.</translation>
    </message>
    <message>
        <source>Pointer: </source>
        <translation>Zeiger: </translation>
    </message>
    <message>
        <source>Poses that would tell</source>
        <translation>Posen, die es zeigen würden</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhergesagt</translation>
    </message>
    <message>
        <source>Predicted %1, measured %2. %3</source>
        <translation>Vorhergesagt %1, gemessen %2. %3</translation>
    </message>
    <message>
        <source>Previous observation</source>
        <translation>Vorige Beobachtung</translation>
    </message>
    <message>
        <source>Pull toward</source>
        <translation>Ziehen nach</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>Weglegen</translation>
    </message>
    <message>
        <source>Quaternion</source>
        <translation>Quaternion</translation>
    </message>
    <message>
        <source>Recalling the play</source>
        <translation>Das Abspielen wird zurückgerufen</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Relabel</source>
        <translation>Neu markieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove marker %1</source>
        <translation>Marker %1 entfernen</translation>
    </message>
    <message>
        <source>Renumber to</source>
        <translation>Umnummerieren zu</translation>
    </message>
    <message>
        <source>Report HTML</source>
        <translation>Bericht HTML</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>Certificate as PDF</source>
        <translation>Zertifikat als PDF</translation>
    </message>
    <message>
        <source>As PDF: errors before and after by ISO 9283, promised limits and how often they held</source>
        <translation>Als PDF: Fehler vorher und nachher nach ISO 9283, versprochene Grenzen und wie oft sie hielten</translation>
    </message>
    <message>
        <source>Report PDF</source>
        <translation>Bericht PDF</translation>
    </message>
    <message>
        <source>Residuals of all corners, before and after</source>
        <translation>Reste aller Ecken, vorher und nachher</translation>
    </message>
    <message>
        <source>Residuals over the image, arrows magnified</source>
        <translation>Reste über dem Bild, Pfeile vergrößert</translation>
    </message>
    <message>
        <source>Rewind</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Right cause, another size.</source>
        <translation>Richtige Ursache, andere Größe.</translation>
    </message>
    <message>
        <source>Right hand, 12 March</source>
        <translation>Rechte Hand, 12. März</translation>
    </message>
    <message>
        <source>Right images</source>
        <translation>Rechte Bilder</translation>
    </message>
    <message>
        <source>%1 about %2</source>
        <translation>%1 um %2</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 längs %2</translation>
    </message>
    <message>
        <source>Right only together with: %1. Used alone, TCP→Body misses by %2 mm on these poses.</source>
        <translation>Richtig nur zusammen mit: %1. Allein benutzt liegt TCP→Body in diesen Posen um %2 mm daneben.</translation>
    </message>
    <message>
        <source>Right only together with the camera mount that was estimated with it: on %1 at %2 mm, rpy %3 deg (mount_from_sensor in the XML).</source>
        <translation>Richtig nur zusammen mit dem mitgeschätzten Sitz der Kameras: an %1 bei %2 mm, rpy %3 Grad (mount_from_sensor im XML).</translation>
    </message>
    <message>
        <source>Right only together with the mount of the sensor that was estimated with it: on %1 at %2 mm, rpy %3 deg (mount_from_sensor in the XML).</source>
        <translation>Richtig nur zusammen mit dem mitgeschätzten Sitz des Sensors: an %1 bei %2 mm, rpy %3 Grad (mount_from_sensor im XML).</translation>
    </message>
    <message>
        <source>error of the pose (mm)</source>
        <translation>Fehler der Pose (mm)</translation>
    </message>
    <message>
        <source>Right only together with the mount of the tracker that was estimated with it: on %1 at %2 mm, rpy %3 deg (mount_from_sensor in the XML).</source>
        <translation>Richtig nur zusammen mit dem mitgeschätzten Sitz des Trackers: an %1 bei %2 mm, rpy %3 Grad (mount_from_sensor im XML).</translation>
    </message>
    <message>
        <source>Right, on the line</source>
        <translation>Rechts, auf Linie</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Richtig.</translation>
    </message>
    <message>
        <source>Right: nothing was added.</source>
        <translation>Richtig: nichts wurde hinzugefügt.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Robot in 3D</source>
        <translation>Roboter in 3D</translation>
    </message>
    <message>
        <source>Sample sessions</source>
        <translation>Beispielsitzungen</translation>
    </message>
    <message>
        <source>Save XML</source>
        <translation>XML speichern</translation>
    </message>
    <message>
        <source>Save as %1 ...</source>
        <translation>Als %1 speichern ...</translation>
    </message>
    <message>
        <source>Save as a table</source>
        <translation>Als Tabelle speichern</translation>
    </message>
    <message>
        <source>Save the plot</source>
        <translation>Diagramm speichern</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>Saved, but the journal cannot be written: a kill would bring the actions back.</source>
        <translation>Gespeichert, aber das Protokoll ist nicht zu schreiben: nach einem Absturz kämen die Aktionen wieder.</translation>
    </message>
    <message>
        <source>See all</source>
        <translation>Alles sehen</translation>
    </message>
    <message>
        <source>See the TCP</source>
        <translation>Den TCP sehen</translation>
    </message>
    <message>
        <source>Selected:</source>
        <translation>Gewählt:</translation>
    </message>
    <message>
        <source>Selection one up</source>
        <translation>Auswahl eins hinauf</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Session folder</source>
        <translation>Sitzungsordner</translation>
    </message>
    <message>
        <source>Sessions (*.xml)</source>
        <translation>Sitzungen (*.xml)</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Show the curve</source>
        <translation>Kurve zeigen</translation>
    </message>
    <message>
        <source>Show the model (M)</source>
        <translation>Modell zeigen (M)</translation>
    </message>
    <message>
        <source>Shows the image of this camera</source>
        <translation>Zeigt das Bild dieser Kamera</translation>
    </message>
    <message>
        <source>Shows the plot against it</source>
        <translation>Zeigt das Diagramm dagegen</translation>
    </message>
    <message>
        <source>Sigmas from how the observations differ, not from the noise alone.</source>
        <translation>Sigmas daraus, wie die Beobachtungen sich unterscheiden, nicht aus dem Rauschen allein.</translation>
    </message>
    <message>
        <source>Six poses, everything measured 1 cm nearer than it is: no images, labels only.</source>
        <translation>Sechs Posen, alles 1 cm zu nah gemessen: keine Bilder, nur Marken.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of the effect</source>
        <translation>Größe der Ursache</translation>
    </message>
    <message>
        <source>Sizes in mm at the hand</source>
        <translation>Größen in mm an der Hand</translation>
    </message>
    <message>
        <source>Sizes in mm at the hand: the markers' distances in space (U)</source>
        <translation>Größen in mm an der Hand: Abstände der Marker im Raum (U)</translation>
    </message>
    <message>
        <source>Sizes in px</source>
        <translation>Größen in px</translation>
    </message>
    <message>
        <source>Sizes in px, of one image coordinate (U)</source>
        <translation>Größen in px, einer Bildkoordinate (U)</translation>
    </message>
    <message>
        <source>Sizes in σ (sigma), residual over noise</source>
        <translation>Größen in σ (Sigma), Rest durch Rauschen</translation>
    </message>
    <message>
        <source>Sizes in σ, the noise of one coordinate: what the colours mean (U)</source>
        <translation>Größen in σ, dem Rauschen einer Koordinate: was die Farben bedeuten (U)</translation>
    </message>
    <message>
        <source>Something is left, and what would explain it does not lower the error on observations that the fit has not seen: it was not added.</source>
        <translation>Etwas bleibt, und was es erklärte, senkt den Fehler auf ungesehenen Beobachtungen nicht: es wurde nicht hinzugefügt.</translation>
    </message>
    <message>
        <source>Something moves</source>
        <translation>Etwas geht</translation>
    </message>
    <message>
        <source>Something real is left, and nothing in the catalogue explains it. %1</source>
        <translation>Etwas Wirkliches bleibt, und nichts im Katalog erklärt es. %1</translation>
    </message>
    <message>
        <source>Space, .</source>
        <translation>Leertaste, .</translation>
    </message>
    <message>
        <source>Springs of %1</source>
        <translation>Federn: %1</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Treppe</translation>
    </message>
    <message>
        <source>Start this sample &amp;anew</source>
        <translation>Dieses Beispiel von &amp;vorn</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Stereo calibration</source>
        <translation>Stereokalibrierung</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Stopped before poses were found.</source>
        <translation>Angehalten, bevor Posen gefunden waren.</translation>
    </message>
    <message>
        <source>Stopped by itself: %1, and nothing is left that would help.</source>
        <translation>Von selbst zu Ende: %1, und nichts ist übrig, was helfen würde.</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 hinzugefügt</translation>
    </message>
    <message>
        <source>small deviations at each joint taken in</source>
        <translation>kleine Abweichungen an jedem Gelenk aufgenommen</translation>
    </message>
    <message>
        <source>Stops; what was taken so far stays</source>
        <translation>Hält an; was bisher übernommen wurde, bleibt</translation>
    </message>
    <message>
        <source>other names found for what was added</source>
        <translation>andere Namen für das Hinzugefügte gefunden</translation>
    </message>
    <message>
        <source>Stopped. Everything is as before.</source>
        <translation>Angehalten. Alles ist wie zuvor.</translation>
    </message>
    <message>
        <source>Stops the job; everything stays as it was before</source>
        <translation>Hält die Arbeit an; alles bleibt, wie es war</translation>
    </message>
    <message>
        <source>TCP at %1, %2, %3 mm (± %4, %5, %6)</source>
        <translation>TCP bei %1, %2, %3 mm (± %4, %5, %6)</translation>
    </message>
    <message>
        <source>TCP→Body</source>
        <translation>TCP→Body</translation>
    </message>
    <message>
        <source>TCP→Body, position</source>
        <translation>TCP→Body, Ort</translation>
    </message>
    <message>
        <source>TCP→Body, rotation</source>
        <translation>TCP→Body, Drehung</translation>
    </message>
    <message>
        <source>TCP→TCPest, position</source>
        <translation>TCP→TCPest, Ort</translation>
    </message>
    <message>
        <source>TCP→TCPest, rotation</source>
        <translation>TCP→TCPest, Drehung</translation>
    </message>
    <message>
        <source>Tab, Enter</source>
        <translation>Tab, Eingabe</translation>
    </message>
    <message>
        <source>Table of joint angles…</source>
        <translation>Tabelle der Gelenkwinkel…</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt)</source>
        <translation>Tabellen (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Take back to here</source>
        <translation>Zurück bis hierher</translation>
    </message>
    <message>
        <source>Takes new images or measurements and joint angles in as they arrive, and goes on playing with them</source>
        <translation>Nimmt neue Bilder oder Messungen und Gelenkwinkel auf, wie sie kommen, und spielt mit ihnen weiter</translation>
    </message>
    <message>
        <source>Takes the chosen observations into the fit (Insert)</source>
        <translation>Nimmt die gewählten Beobachtungen in die Anpassung (Einfg)</translation>
    </message>
    <message>
        <source>That is no number. Write it like 1.3 or 1.3 ± 0.1.</source>
        <translation>Das ist keine Zahl. Schreibe sie wie 1,3 oder 1,3 ± 0,1.</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2, which this display does not offer.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2, das diese Anzeige nicht bietet.</translation>
    </message>
    <message>
        <source>The angle of %1 moves</source>
        <translation>Der Winkel von %1 geht</translation>
    </message>
    <message>
        <source>The camera's place is three numbers in m and three in rad.</source>
        <translation>Der Ort der Kamera sind drei Zahlen in m und drei in rad.</translation>
    </message>
    <message>
        <source>The cameras: the two images do not agree with each other. </source>
        <translation>Die Kameras: die zwei Bilder passen nicht zueinander. </translation>
    </message>
    <message>
        <source>The cost of a fit is drawn here.</source>
        <translation>Der Verlauf einer Anpassung wird hier gezeichnet.</translation>
    </message>
    <message>
        <source>The error is not known.</source>
        <translation>Der Fehler ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The error is only twice the noise. Do not stop at the first answer.</source>
        <translation>Der Fehler ist nur das Doppelte des Rauschens. Bleib nicht bei der ersten Antwort.</translation>
    </message>
    <message>
        <source>The error of each version on observations that the fit has not seen, and on those that it has. A gap between the two is over-fitting. Ctrl and click marks two versions for a comparison.</source>
        <translation>Der Fehler jeder Fassung auf ungesehenen Beobachtungen und auf gesehenen. Eine Lücke dazwischen ist Überanpassung. Strg und Klick merken zwei Fassungen zum Vergleich.</translation>
    </message>
    <message>
        <source>The error of every version of the model comes here.</source>
        <translation>Der Fehler jeder Fassung des Modells kommt hierher.</translation>
    </message>
    <message>
        <source>The error that would be left on observations that the fit has not seen: %1. Today %2; the noise (hatched) is %3.</source>
        <translation>Der Fehler, der auf ungesehenen Beobachtungen bliebe: %1. Heute %2; das Rauschen (schraffiert) ist %3.</translation>
    </message>
    <message>
        <source>The errors are those of the moment of the decision</source>
        <translation>Die Fehler sind die vom Augenblick der Entscheidung</translation>
    </message>
    <message>
        <source>The errors are those of the present model</source>
        <translation>Die Fehler sind die des jetzigen Modells</translation>
    </message>
    <message>
        <source>The fit</source>
        <translation>Die Anpassung</translation>
    </message>
    <message>
        <source>The fit has not converged: more observations, or look at Inspect.</source>
        <translation>Die Anpassung ist nicht zur Ruhe gekommen: mehr Beobachtungen, oder sieh unter Prüfen nach.</translation>
    </message>
    <message>
        <source>The fit leaves the numbers where they are; then they can be typed</source>
        <translation>Die Anpassung lässt die Zahlen stehen; dann lassen sie sich tippen</translation>
    </message>
    <message>
        <source>The fit may move the numbers again, from where they are</source>
        <translation>Die Anpassung darf die Zahlen wieder bewegen, von dort aus</translation>
    </message>
    <message>
        <source>The fit starts …</source>
        <translation>Die Anpassung beginnt …</translation>
    </message>
    <message>
        <source>The hand</source>
        <translation>Die Hand</translation>
    </message>
    <message>
        <source>The job failed without saying why.</source>
        <translation>Die Arbeit misslang, ohne zu sagen warum.</translation>
    </message>
    <message>
        <source>The marker body</source>
        <translation>Der Markerkörper</translation>
    </message>
    <message>
        <source>The marker body: the markers are not where they sit on the hand. </source>
        <translation>Der Markerkörper: die Marker sind nicht, wo sie an der Hand sitzen. </translation>
    </message>
    <message>
        <source>The marker is placed. Drag it, or remove it first.</source>
        <translation>Der Marker ist gesetzt. Ziehe ihn oder entferne ihn zuerst.</translation>
    </message>
    <message>
        <source>The mesh %1 is not in the robot's folder. The link is drawn without it.</source>
        <translation>Das Netz %1 ist nicht im Ordner des Roboters. Das Glied wird ohne es gezeichnet.</translation>
    </message>
    <message>
        <source>The model agrees with the measurements down to the noise, but not all of it has a name: %1.</source>
        <translation>Das Modell stimmt mit den Messungen bis auf das Rauschen überein, aber nicht alles hat einen Namen: %1.</translation>
    </message>
    <message>
        <source>The model agrees with the measurements down to the noise.</source>
        <translation>Das Modell stimmt mit den Messungen bis auf das Rauschen überein.</translation>
    </message>
    <message>
        <source>The model comes near the noise, but what is left is more than noise.</source>
        <translation>Das Modell kommt dem Rauschen nahe, aber was übrig ist, ist mehr als Rauschen.</translation>
    </message>
    <message>
        <source>The model is being fitted.</source>
        <translation>Das Modell wird angepasst.</translation>
    </message>
    <message>
        <source>The model misses by more than the noise.</source>
        <translation>Das Modell liegt um mehr als das Rauschen daneben.</translation>
    </message>
    <message>
        <source>The hand is off by %1.</source>
        <translation>Die Hand liegt %1 daneben.</translation>
    </message>
    <message>
        <source>The noise is not known, so that nobody can say whether the error is much: declare it (sigma), or repeat some poses.</source>
        <translation>Das Rauschen ist nicht bekannt, so dass niemand sagen kann, ob der Fehler groß ist: gib es an (sigma), oder wiederhole einige Posen.</translation>
    </message>
    <message>
        <source>The noise is not known, so nothing can be said about this observation.</source>
        <translation>Das Rauschen ist nicht bekannt, also ist über diese Beobachtung nichts zu sagen.</translation>
    </message>
    <message>
        <source>The noise is not known, so nothing can be told in units of it.</source>
        <translation>Das Rauschen ist nicht bekannt, also ist nichts in seiner Einheit zu sagen.</translation>
    </message>
    <message>
        <source>The noise is unknown</source>
        <translation>Das Rauschen ist unbekannt</translation>
    </message>
    <message>
        <source>The planned pose</source>
        <translation>Die geplante Pose</translation>
    </message>
    <message>
        <source>The plot's numbers are on the clipboard.</source>
        <translation>Die Zahlen des Diagramms sind in der Zwischenablage.</translation>
    </message>
    <message>
        <source>The plot's picture is on the clipboard.</source>
        <translation>Das Bild des Diagramms ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>The residual against what it may follow, strongest first</source>
        <translation>Der Rest gegen das, dem er folgen kann, das Stärkste zuerst</translation>
    </message>
    <message>
        <source>The residuals against what they may follow come here.</source>
        <translation>Die Reste gegen das, dem sie folgen können, kommen hierher.</translation>
    </message>
    <message>
        <source>The residuals of all corners, before and after. Hold B to blink between the two on the same axes.</source>
        <translation>Die Reste aller Ecken, vorher und nachher. Halte B, um auf denselben Achsen zu wechseln.</translation>
    </message>
    <message>
        <source>The robot in observation %1, with the deviation of every observation, times %2</source>
        <translation>Der Roboter in Beobachtung %1, mit der Abweichung jeder Beobachtung, mal %2</translation>
    </message>
    <message>
        <source>The robot: the hand is not where the joints say. </source>
        <translation>Der Roboter: die Hand ist nicht, wo die Gelenke sagen. </translation>
    </message>
    <message>
        <source>The same with the model as it is now</source>
        <translation>Dasselbe mit dem Modell, wie es jetzt ist</translation>
    </message>
    <message>
        <source>The search for what is missing was stopped before it was done.</source>
        <translation>Die Suche nach dem, was fehlt, wurde vor dem Ende angehalten.</translation>
    </message>
    <message>
        <source>The selection before</source>
        <translation>Die Auswahl davor</translation>
    </message>
    <message>
        <source>The sensor's mount</source>
        <translation>Der Sitz des Sensors</translation>
    </message>
    <message>
        <source>The session's own folder</source>
        <translation>Der Ordner der Sitzung</translation>
    </message>
    <message>
        <source>The sizes that were found stand in the model panel, with what is plausible.</source>
        <translation>Die gefundenen Größen stehen im Modell rechts, mit dem, was glaubhaft ist.</translation>
    </message>
    <message>
        <source>The step down is the error on unseen poses. When it reaches the hatched floor, only noise is left. Ctrl+Z takes the step back.</source>
        <translation>Die Stufe hinab ist der Fehler in ungesehenen Posen. Am schraffierten Boden bleibt nur Rauschen. Strg+Z nimmt die Stufe zurück.</translation>
    </message>
    <message>
        <source>The thesis's simulation</source>
        <translation>Die Simulation der Arbeit</translation>
    </message>
    <message>
        <source>The tracker: its points do not agree with each other. </source>
        <translation>Der Tracker: seine Punkte passen nicht zueinander. </translation>
    </message>
    <message>
        <source>The triangle appears here.</source>
        <translation>Das Dreieck erscheint hier.</translation>
    </message>
    <message>
        <source>The truth</source>
        <translation>Die Wahrheit</translation>
    </message>
    <message>
        <source>The uncertainties come from how the observations differ, not from the noise alone: they hold for poses like these.</source>
        <translation>Die Unsicherheiten kommen daher, wie die Beobachtungen sich unterscheiden, nicht aus dem Rauschen allein: sie gelten für Posen wie diese.</translation>
    </message>
    <message>
        <source>There are %1 lines of joint angles for %2 images: each instant needs one of each, in the same order.</source>
        <translation>Es sind %1 Zeilen Gelenkwinkel für %2 Bilder: jeder Augenblick braucht je eins, in derselben Reihenfolge.</translation>
    </message>
    <message>
        <source>There is a session already. Take another folder, or open it.</source>
        <translation>Dort ist schon eine Sitzung. Nimm einen anderen Ordner, oder öffne sie.</translation>
    </message>
    <message>
        <source>There is no marker %1: this session has markers 0 to %2.</source>
        <translation>Einen Marker %1 gibt es nicht: diese Sitzung hat Marker 0 bis %2.</translation>
    </message>
    <message>
        <source>These poses could not show: %1.</source>
        <translation>Diese Posen konnten nicht zeigen: %1.</translation>
    </message>
    <message>
        <source>Thesis (4.19-4.23): the markers move as one body</source>
        <translation>Arbeit (4.19-4.23): die Marker bewegen sich als ein Körper</translation>
    </message>
    <message>
        <source>This line says what is most likely missing, what it would bring, and whose fault the error is. How large the error is, on poses that the model has not seen, and the noise beside it stand above, at the right.</source>
        <translation>Diese Zeile sagt, was am wahrscheinlichsten fehlt, was es brächte und an wem der Fehler liegt. Wie groß der Fehler in ungesehenen Posen ist, und daneben das Rauschen, steht oben rechts.</translation>
    </message>
    <message>
        <source>This session does not know its truth.</source>
        <translation>Diese Sitzung kennt ihre Wahrheit nicht.</translation>
    </message>
    <message>
        <source>This will do.</source>
        <translation>Das genügt.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>What would make it right: %1</source>
        <translation>Damit es stimmte: %1</translation>
    </message>
    <message>
        <source>To the size that fits best (B, or a double click on the track)</source>
        <translation>Auf die Größe, die am besten passt (B, oder Doppelklick auf die Leiste)</translation>
    </message>
    <message>
        <source>Too few observations</source>
        <translation>Zu wenige Beobachtungen</translation>
    </message>
    <message>
        <source>Too few observations to tell.</source>
        <translation>Zu wenige Beobachtungen, um es zu sagen.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>True size</source>
        <translation>Wahre Größe</translation>
    </message>
    <message>
        <source>Try a card, or add it.</source>
        <translation>Probiere eine Karte, oder füge sie hinzu.</translation>
    </message>
    <message>
        <source>Trying every effect of the catalogue ...</source>
        <translation>Jede Ursache des Katalogs wird probiert ...</translation>
    </message>
    <message>
        <source>Twelve observations with images, nothing hidden: label three markers, play, export.</source>
        <translation>Zwölf Beobachtungen mit Bildern, nichts versteckt: drei Marker setzen, abspielen, exportieren.</translation>
    </message>
    <message>
        <source>URDF (*.urdf *.xml)</source>
        <translation>URDF (*.urdf *.xml)</translation>
    </message>
    <message>
        <source>URDF file</source>
        <translation>URDF-Datei</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo: %1 (%2)</source>
        <translation>Rückgängig: %1 (%2)</translation>
    </message>
    <message>
        <source>Undoes every action after the version that is shown; Ctrl+Shift+Z does them again</source>
        <translation>Macht jede Aktion nach der gezeigten Fassung rückgängig; Strg+Umschalt+Z wiederholt sie</translation>
    </message>
    <message>
        <source>Undone: %1%2</source>
        <translation>Rückgängig: %1%2</translation>
    </message>
    <message>
        <source>Until the session is opened again</source>
        <translation>Bis die Sitzung wieder geöffnet wird</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Benutzt</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Fassungen</translation>
    </message>
    <message>
        <source>Versions of the model</source>
        <translation>Fassungen des Modells</translation>
    </message>
    <message>
        <source>Waiting for the next images in %1 and their joint angles in %2; %3 arrived.</source>
        <translation>Wartet auf die nächsten Bilder in %1 und ihre Gelenkwinkel in %2; %3 angekommen.</translation>
    </message>
    <message>
        <source>Where the images arrive</source>
        <translation>Wo die Bilder ankommen</translation>
    </message>
    <message>
        <source>Table of joint angles</source>
        <translation>Tabelle der Gelenkwinkel</translation>
    </message>
    <message>
        <source>Images of camera %1…</source>
        <translation>Bilder der Kamera %1…</translation>
    </message>
    <message>
        <source>Waiting for the next image pair in %1 and its joint angles in %2; %3 arrived.</source>
        <translation>Wartet auf das nächste Bildpaar in %1 und seine Gelenkwinkel in %2; %3 angekommen.</translation>
    </message>
    <message>
        <source>Waits for a fit of at least 8 observations; %1 so far.</source>
        <translation>Wartet auf eine Anpassung von mindestens 8 Beobachtungen; bisher %1.</translation>
    </message>
    <message>
        <source>Waits for a fit.</source>
        <translation>Wartet auf eine Anpassung.</translation>
    </message>
    <message>
        <source>Waits for a fit: label three markers, then play.</source>
        <translation>Wartet auf eine Anpassung: markiere drei Marker, dann abspielen.</translation>
    </message>
    <message>
        <source>Waits for a fit: play.</source>
        <translation>Wartet auf eine Anpassung: abspielen.</translation>
    </message>
    <message>
        <source>Waits for a fit; then it says where the TCP really is.</source>
        <translation>Wartet auf eine Anpassung; dann steht hier, wo der TCP wirklich ist.</translation>
    </message>
    <message>
        <source>Waits for the robot, which names the joints.</source>
        <translation>Wartet auf den Roboter, der die Gelenke nennt.</translation>
    </message>
    <message>
        <source>Waits for three markers: label the first observation (Ctrl+1).</source>
        <translation>Wartet auf drei Marker (Strg+1).</translation>
    </message>
    <message>
        <source>Watch folder</source>
        <translation>Ordner beobachten</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>Was wäre: %1</translation>
    </message>
    <message>
        <source>What is left differs from pose to pose without a pattern: the hand's place does not repeat better than %1 mm. No effect can remove it.</source>
        <translation>Was übrig ist, ist von Pose zu Pose verschieden und ohne Muster: der Ort der Hand wiederholt sich nicht besser als auf %1 mm. Kein Effekt kann es beseitigen.</translation>
    </message>
    <message>
        <source>What is left differs from pose to pose without a pattern: the joints do not repeat better than %1, nor the hand's place better than %2 mm. No effect can remove it.</source>
        <translation>Was übrig ist, ist von Pose zu Pose verschieden und ohne Muster: die Gelenke wiederholen sich nicht besser als auf %1, der Ort der Hand nicht besser als auf %2 mm. Kein Effekt kann es beseitigen.</translation>
    </message>
    <message>
        <source>What is left differs from pose to pose without a pattern: the joints do not repeat better than %1. No effect can remove it.</source>
        <translation>Was übrig ist, ist von Pose zu Pose verschieden und ohne Muster: die Gelenke wiederholen sich nicht besser als auf %1. Kein Effekt kann es beseitigen.</translation>
    </message>
    <message>
        <source>What is missing</source>
        <translation>Was fehlt</translation>
    </message>
    <message>
        <source>What is missing? The likeliest cause comes first. Rest the pointer on the card: purple, dashed, everywhere, is what the model would do with it.</source>
        <translation>Was fehlt? Die wahrscheinlichste Ursache steht zuerst. Ruht der Zeiger auf der Karte, zeigt sich überall violett gestrichelt, was das Modell damit täte.</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>Was es sagt</translation>
    </message>
    <message>
        <source>What the real robot shows, with what it may be off by: 1.3 ± 0.1</source>
        <translation>Was der wirkliche Roboter zeigt, und wie weit es daneben sein kann: 1,3 ± 0,1</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Where from…</source>
        <translation>Woher…</translation>
    </message>
    <message>
        <source>Where it failed</source>
        <translation>Wo es abwich</translation>
    </message>
    <message>
        <source>A real Panda: a ball in four sockets</source>
        <translation>Ein echter Panda: eine Kugel in vier Pfannen</translation>
    </message>
    <message>
        <source>Hidden 1: the pedestal arm</source>
        <translation>Versteckt 1: der Arm auf dem Sockel</translation>
    </message>
    <message>
        <source>Hidden 2: the light arm</source>
        <translation>Versteckt 2: der leichte Arm</translation>
    </message>
    <message>
        <source>Hidden 3: Justin</source>
        <translation>Versteckt 3: Justin</translation>
    </message>
    <message>
        <source>Hidden 4: the pedestal arm</source>
        <translation>Versteckt 4: der Arm auf dem Sockel</translation>
    </message>
    <message>
        <source>Hidden 5: Justin</source>
        <translation>Versteckt 5: Justin</translation>
    </message>
    <message>
        <source>Hidden 6: the light arm</source>
        <translation>Versteckt 6: der leichte Arm</translation>
    </message>
    <message>
        <source>Hidden 7: the light arm</source>
        <translation>Versteckt 7: der leichte Arm</translation>
    </message>
    <message>
        <source>Hidden 8: the pedestal arm</source>
        <translation>Versteckt 8: der Arm auf dem Sockel</translation>
    </message>
    <message>
        <source>Where it fails</source>
        <translation>Wo es abweicht</translation>
    </message>
    <message>
        <source>Each point: as if %1 alone had made the whole error. It is more than the %2 mrad to which the joints repeat, for all of them had their share.</source>
        <translation>Jeder Punkt: als hätte %1 allein den ganzen Fehler gemacht. Das ist mehr als die %2 mrad, auf die sich die Gelenke wiederholen, denn jedes hatte seinen Teil.</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Was übrig ist</translation>
    </message>
    <message>
        <source>Where it fails: the proof</source>
        <translation>Abweichung: der Beweis</translation>
    </message>
    <message>
        <source>Where it sits</source>
        <translation>Wo es sitzt</translation>
    </message>
    <message>
        <source>Where the cameras sit on %1, estimated with the rest.</source>
        <translation>Wo die Kameras auf %1 sitzen, mitgeschätzt.</translation>
    </message>
    <message>
        <source>Mount of the tracker</source>
        <translation>Sitz des Trackers</translation>
    </message>
    <message>
        <source>Where the tracker sits on %1, estimated with the rest.</source>
        <translation>Wo der Tracker auf %1 sitzt, mitgeschätzt.</translation>
    </message>
    <message>
        <source>Where the first model failed: the residual against what it followed most</source>
        <translation>Wo das erste Modell danebenlag: der Rest gegen das, dem er am meisten folgte</translation>
    </message>
    <message>
        <source>Where the images and the joint angles arrive</source>
        <translation>Wo die Bilder und die Gelenkwinkel ankommen</translation>
    </message>
    <message>
        <source>Where the marker body sits on the hand. Sigma is that of the body's origin, and of the rotations about the TCP's axes.</source>
        <translation>Wo der Markerkörper an der Hand sitzt. Sigma gilt für den Ursprung des Körpers und die Drehungen um die Achsen des TCP.</translation>
    </message>
    <message>
        <source>Which number</source>
        <translation>Welche Zahl</translation>
    </message>
    <message>
        <source>Whose fault: not known yet</source>
        <translation>An wem es liegt: noch nicht bekannt</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Why not ...? All effects</source>
        <translation>Warum nicht ...? Alle Ursachen</translation>
    </message>
    <message>
        <source>Why not …?</source>
        <translation>Warum nicht …?</translation>
    </message>
    <message>
        <source>Why not …? Type a name</source>
        <translation>Warum nicht …? Tippe einen Namen</translation>
    </message>
    <message>
        <source>With this the error would be %1.</source>
        <translation>Damit wäre der Fehler %1.</translation>
    </message>
    <message>
        <source>The program cannot say when to stop: declare the noise (sigma), or repeat some poses. No cause of the catalogue that is not in the model explains more than chance would.</source>
        <translation>Das Programm kann nicht sagen, wann Schluss ist: gib das Rauschen an (sigma), oder wiederhole einige Posen. Keine Ursache des Katalogs, die nicht im Modell ist, erklärt mehr als der Zufall.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Written: %1, in rad and m.</source>
        <translation>Geschrieben: %1, in rad und m.</translation>
    </message>
    <message>
        <source>Wrong: the model has more than was hidden.</source>
        <translation>Falsch: das Modell hat mehr, als versteckt war.</translation>
    </message>
    <message>
        <source>The small deviations at each joint that it has besides are no causes.</source>
        <translation>Die kleinen Abweichungen an jedem Gelenk, die es daneben hat, sind keine Ursachen.</translation>
    </message>
    <message>
        <source>XML as it will be written</source>
        <translation>XML, wie es geschrieben wird</translation>
    </message>
    <message>
        <source>Zoom both together</source>
        <translation>Beide zusammen vergrößern</translation>
    </message>
    <message>
        <source>Zooms to the marker that is worst off</source>
        <translation>Vergrößert den Marker, der am schlimmsten ist</translation>
    </message>
    <message>
        <source>a curve without a name in %1</source>
        <translation>eine Kurve ohne Namen in %1</translation>
    </message>
    <message>
        <source>a curve without a name in %1, %2 rad</source>
        <translation>eine Kurve ohne Namen in %1, %2 rad</translation>
    </message>
    <message>
        <source>a noun begins small</source>
        <translation>ein Hauptwort beginnt groß</translation>
    </message>
    <message>
        <source>about %1 to one</source>
        <translation>etwa %1 zu eins</translation>
    </message>
    <message>
        <source>action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>added %1</source>
        <translation>%1 hinzugefügt</translation>
    </message>
    <message>
        <source>added: %1</source>
        <translation>hinzugefügt: %1</translation>
    </message>
    <message>
        <source>added %1, which is likely beside the rest</source>
        <translation>%1 hinzugefügt, was neben dem Übrigen wahrscheinlich ist</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>after %1 (obs %2): %3 %4</source>
        <translation>nach %1 (Beob. %2): %3 %4</translation>
    </message>
    <message>
        <source>after mm</source>
        <translation>nachher mm</translation>
    </message>
    <message>
        <source>against %1</source>
        <translation>gegen %1</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>alle Kameras</translation>
    </message>
    <message>
        <source>all, standard views, from the camera</source>
        <translation>alles, Standardansichten, von der Kamera</translation>
    </message>
    <message>
        <source>an effect is missing</source>
        <translation>eine Ursache fehlt</translation>
    </message>
    <message>
        <source>and others</source>
        <translation>und andere</translation>
    </message>
    <message>
        <source>angle deg</source>
        <translation>Winkel Grad</translation>
    </message>
    <message>
        <source>arrows %1 ×</source>
        <translation>Pfeile %1 ×</translation>
    </message>
    <message>
        <source>arrows 0.1 px, Shift 1, Alt free</source>
        <translation>Pfeile 0,1 px, Umschalt 1, Alt frei</translation>
    </message>
    <message>
        <source>as it is fitted</source>
        <translation>während der Anpassung</translation>
    </message>
    <message>
        <source>as opened</source>
        <translation>wie geöffnet</translation>
    </message>
    <message>
        <source>at the noise, not all named</source>
        <translation>Rest ohne Namen</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>before mm</source>
        <translation>vorher mm</translation>
    </message>
    <message>
        <source>best</source>
        <translation>beste</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>cameras | body | robot</source>
        <translation>Kameras | Körper | Roboter</translation>
    </message>
    <message>
        <source>changed since</source>
        <translation>seither geändert</translation>
    </message>
    <message>
        <source>choose observations in a plot</source>
        <translation>Beobachtungen im Diagramm wählen</translation>
    </message>
    <message>
        <source>chose the partner of marker %1 of observation %2</source>
        <translation>Partner von Marker %1 der Beobachtung %2 gewählt</translation>
    </message>
    <message>
        <source>corner at %1: %2</source>
        <translation>Ecke bei %1: %2</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>depth m</source>
        <translation>Tiefe m</translation>
    </message>
    <message>
        <source>down at the noise</source>
        <translation>beim Rauschen</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>error mm</source>
        <translation>Fehler mm</translation>
    </message>
    <message>
        <source>error now (%1)</source>
        <translation>Fehler jetzt (%1)</translation>
    </message>
    <message>
        <source>error now, held out</source>
        <translation>Fehler jetzt, ungesehen</translation>
    </message>
    <message>
        <source>error px</source>
        <translation>Fehler px</translation>
    </message>
    <message>
        <source>estimated %1 again</source>
        <translation>%1 wieder geschätzt</translation>
    </message>
    <message>
        <source>added small deviations at each joint: %1</source>
        <translation>kleine Abweichungen an jedem Gelenk hinzugefügt: %1</translation>
    </message>
    <message>
        <source>moved what is in the model to other places</source>
        <translation>an andere Stellen gesetzt, was im Modell ist</translation>
    </message>
    <message>
        <source>exchanged %1 for %2</source>
        <translation>%1 gegen %2 getauscht</translation>
    </message>
    <message>
        <source>exclude, include the chosen observations</source>
        <translation>gewählte aus- und einschließen</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>excluded %1</source>
        <translation>%1 ausgeschlossen</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>exportiert</translation>
    </message>
    <message>
        <source>find an action, observation, joint, effect or key</source>
        <translation>Aktion, Gelenk, Ursache, Taste ... finden</translation>
    </message>
    <message>
        <source>fit again what was stopped</source>
        <translation>nochmals anpassen, was angehalten wurde</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>fitted by the %1 objective</source>
        <translation>angepasst nach der Zielfunktion %1</translation>
    </message>
    <message>
        <source>fitting ...</source>
        <translation>Anpassung ...</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>folder; may be the same</source>
        <translation>Ordner; darf derselbe sein</translation>
    </message>
    <message>
        <source>forgot what was measured for %1</source>
        <translation>Messung für %1 vergessen</translation>
    </message>
    <message>
        <source>ghost %1 ×</source>
        <translation>Geist %1 ×</translation>
    </message>
    <message>
        <source>half-turn</source>
        <translation>halbe Drehung</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>held %1</source>
        <translation>%1 festgehalten</translation>
    </message>
    <message>
        <source>held %1 at %2 %3</source>
        <translation>%1 bei %2 %3 festgehalten</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>ungesehen</translation>
    </message>
    <message>
        <source>held out px</source>
        <translation>ungesehen px</translation>
    </message>
    <message>
        <source>held the body's shape</source>
        <translation>Form des Körpers gehalten</translation>
    </message>
    <message>
        <source>hit: %1, limit %2</source>
        <translation>Treffer: %1, Grenze %2</translation>
    </message>
    <message>
        <source>in the model as a curve without a name</source>
        <translation>als Kurve ohne Namen im Modell</translation>
    </message>
    <message>
        <source>included %1</source>
        <translation>%1 eingeschlossen</translation>
    </message>
    <message>
        <source>iteration %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>iteration %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>joint angles in rad, in the session's order</source>
        <translation>Gelenkwinkel in rad, wie in der Sitzung</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>known to be wrong: %1, limit %2</source>
        <translation>bekannt falsch: %1, Grenze %2</translation>
    </message>
    <message>
        <source>labelled observation %1</source>
        <translation>Beobachtung %1 markiert</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>let the body's shape free</source>
        <translation>Form des Körpers freigegeben</translation>
    </message>
    <message>
        <source>line px</source>
        <translation>Linie px</translation>
    </message>
    <message>
        <source>link %1</source>
        <translation>Glied %1</translation>
    </message>
    <message>
        <source>link %1, moved by %2</source>
        <translation>Glied %1, bewegt von %2</translation>
    </message>
    <message>
        <source>look at a card, add it</source>
        <translation>eine Karte ansehen, hinzufügen</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>made marker %1 of observation %2 marker %3</source>
        <translation>Marker %1 von Beobachtung %2 ist jetzt Marker %3</translation>
    </message>
    <message>
        <source>made where it is not there</source>
        <translation>wird angelegt, wo er nicht ist</translation>
    </message>
    <message>
        <source>make the estimate surer</source>
        <translation>die Schätzung sicherer machen</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>marker %1</source>
        <translation>Marker %1</translation>
    </message>
    <message>
        <source>marker %1 at %2</source>
        <translation>Marker %1 bei %2</translation>
    </message>
    <message>
        <source>marker %1, %2 from where it was predicted</source>
        <translation>Marker %1, %2 von der Vorhersage entfernt</translation>
    </message>
    <message>
        <source>marker on the nearest corner, exactly there</source>
        <translation>Marker auf die nächste Ecke, genau dorthin</translation>
    </message>
    <message>
        <source>mass kg</source>
        <translation>Masse kg</translation>
    </message>
    <message>
        <source>measured for %1</source>
        <translation>gemessen für %1</translation>
    </message>
    <message>
        <source>miss: %1, limit %2</source>
        <translation>daneben: %1, Grenze %2</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>verfehlt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>more than a million to one</source>
        <translation>mehr als eine Million zu eins</translation>
    </message>
    <message>
        <source>moved marker %1 of observation %2</source>
        <translation>Marker %1 von Beobachtung %2 verschoben</translation>
    </message>
    <message>
        <source>needs no labels</source>
        <translation>braucht keine</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>noise alone, before and after</source>
        <translation>Rauschen allein, vorher und nachher</translation>
    </message>
    <message>
        <source>noise floor</source>
        <translation>Grundrauschen</translation>
    </message>
    <message>
        <source>noise unknown</source>
        <translation>Rauschen unbekannt</translation>
    </message>
    <message>
        <source>not hidden</source>
        <translation>nicht versteckt</translation>
    </message>
    <message>
        <source>not in the model</source>
        <translation>nicht im Modell</translation>
    </message>
    <message>
        <source>not taken</source>
        <translation>nicht genommen</translation>
    </message>
    <message>
        <source>nothing is missing</source>
        <translation>nichts fehlt</translation>
    </message>
    <message>
        <source>nothing odd</source>
        <translation>nichts auffällig</translation>
    </message>
    <message>
        <source>nothing stands out of the noise</source>
        <translation>nichts ragt aus dem Rauschen</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>nudge the chosen marker by 0.1 px, 1 px</source>
        <translation>gewählten Marker um 0,1 px, 1 px rücken</translation>
    </message>
    <message>
        <source>nudged marker %1 of observation %2</source>
        <translation>Marker %1 von Beobachtung %2 gerückt</translation>
    </message>
    <message>
        <source>obs</source>
        <translation>Beob.</translation>
    </message>
    <message>
        <source>obs %1</source>
        <translation>Beob. %1</translation>
    </message>
    <message>
        <source>obs %1, marker %2, %3: %4 %6 right, %5 %6 down</source>
        <translation>Beob. %1, Marker %2, %3: %4 %6 nach rechts, %5 %6 nach unten</translation>
    </message>
    <message>
        <source>obs %1, marker %2, %3: %4, %5 %6</source>
        <translation>Beob. %1, Marker %2, %3: %4, %5 %6</translation>
    </message>
    <message>
        <source>obs %1: %2 %3 %4, %5 %6 %7</source>
        <translation>Beob. %1: %2 %3 %4, %5 %6 %7</translation>
    </message>
    <message>
        <source>obs %1: %2 %3, %4 %5</source>
        <translation>Beob. %1: %2 %3, %4 %5</translation>
    </message>
    <message>
        <source>obs %1: %2 mm</source>
        <translation>Beob. %1: %2 mm</translation>
    </message>
    <message>
        <source>observation</source>
        <translation>Beobachtung</translation>
    </message>
    <message>
        <source>observation %1</source>
        <translation>Beobachtung %1</translation>
    </message>
    <message>
        <source>observation %1 arrived</source>
        <translation>Beobachtung %1 ist da</translation>
    </message>
    <message>
        <source>observation %1 arrived: %2</source>
        <translation>Beobachtung %1 ist da: %2</translation>
    </message>
    <message>
        <source>observation %1, marker %2%3, %4 off</source>
        <translation>Beobachtung %1, Marker %2%3, %4 daneben</translation>
    </message>
    <message>
        <source>observation id</source>
        <translation>Nummer der Beobachtung</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>observations</source>
        <translation>Beobachtungen</translation>
    </message>
    <message>
        <source>observations %1 to %2 arrived</source>
        <translation>Beobachtungen %1 bis %2 sind da</translation>
    </message>
    <message>
        <source>odd</source>
        <translation>auffällig</translation>
    </message>
    <message>
        <source>off</source>
        <translation>daneben</translation>
    </message>
    <message>
        <source>one panel fills the centre (double click on its title)</source>
        <translation>ein Feld füllt die Mitte (Doppelklick auf Titel)</translation>
    </message>
    <message>
        <source>pitch deg</source>
        <translation>Nicken Grad</translation>
    </message>
    <message>
        <source>placed marker %1 of observation %2</source>
        <translation>Marker %1 von Beobachtung %2 gesetzt</translation>
    </message>
    <message>
        <source>play or pause, one observation</source>
        <translation>abspielen oder anhalten, eine Beobachtung</translation>
    </message>
    <message>
        <source>played to observation %1: %2 of %3 taken</source>
        <translation>bis Beobachtung %1 abgespielt: %2 von %3 genommen</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>spielt</translation>
    </message>
    <message>
        <source>plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>predicted with it</source>
        <translation>vorhergesagt damit</translation>
    </message>
    <message>
        <source>prediction, mm</source>
        <translation>Vorhersage, mm</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>ready to play</source>
        <translation>zum Abspielen bereit</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>removed marker %1 of observation %2</source>
        <translation>Marker %1 von Beobachtung %2 entfernt</translation>
    </message>
    <message>
        <source>renumber, remove it</source>
        <translation>Marker umnummerieren, entfernen</translation>
    </message>
    <message>
        <source>renumber, remove the chosen marker</source>
        <translation>gewählten Marker umnummerieren, entfernen</translation>
    </message>
    <message>
        <source>renumbered the markers of observation %1 by their sides</source>
        <translation>Marker von Beobachtung %1 nach ihren Seiten umnummeriert</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>residual u (%1)</source>
        <translation>Rest u (%1)</translation>
    </message>
    <message>
        <source>residual v (%1)</source>
        <translation>Rest v (%1)</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>right image</source>
        <translation>rechtes Bild</translation>
    </message>
    <message>
        <source>rim %1</source>
        <translation>Rand %1</translation>
    </message>
    <message>
        <source>rms (%1)</source>
        <translation>Mittel (%1)</translation>
    </message>
    <message>
        <source>rms / noise</source>
        <translation>Mittel / Rauschen</translation>
    </message>
    <message>
        <source>rms / noise (1 = %1 %2)</source>
        <translation>Mittel / Rauschen (1 = %1 %2)</translation>
    </message>
    <message>
        <source>rms of a coordinate</source>
        <translation>rms je Koordinate</translation>
    </message>
    <message>
        <source>rms of a coordinate (px)</source>
        <translation>rms je Koordinate (px)</translation>
    </message>
    <message>
        <source>rms of the markers' distances (mm)</source>
        <translation>Mittel der Markerabstände (mm)</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>roll deg</source>
        <translation>Rollen Grad</translation>
    </message>
    <message>
        <source>roll pitch yaw, rad</source>
        <translation>Rollen Nicken Gieren, rad</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>seen, and said to have no name</source>
        <translation>gesehen, und als namenlos bezeichnet</translation>
    </message>
    <message>
        <source>settled after %1 iterations</source>
        <translation>nach %1 Schritten ruhig</translation>
    </message>
    <message>
        <source>shift across, u</source>
        <translation>Verschiebung quer, u</translation>
    </message>
    <message>
        <source>shift across, w</source>
        <translation>Verschiebung quer, w</translation>
    </message>
    <message>
        <source>shifts along %1</source>
        <translation>verschiebt sich entlang %1</translation>
    </message>
    <message>
        <source>show everything, standard views, the cameras' view</source>
        <translation>alles zeigen, feste Ansichten, Sicht der Kameras</translation>
    </message>
    <message>
        <source>shows %1</source>
        <translation>zeigt %1</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>sigma of %1 (%2)</source>
        <translation>Sigma von %1 (%2)</translation>
    </message>
    <message>
        <source>sizes in px, in mm at the hand, in σ</source>
        <translation>Größen in px, in mm an der Hand, in σ</translation>
    </message>
    <message>
        <source>sizes in px, in mm at the hand, in σ (residual over noise)</source>
        <translation>Größen in px, in mm an der Hand, in σ (Rest durch Rauschen)</translation>
    </message>
    <message>
        <source>some that cannot be read</source>
        <translation>einige, die nicht zu lesen sind</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>genommen</translation>
    </message>
    <message>
        <source>tell %1 from %2</source>
        <translation>%1 von %2 unterscheiden</translation>
    </message>
    <message>
        <source>the %1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>the cameras</source>
        <translation>von den Kameras</translation>
    </message>
    <message>
        <source>the marker body</source>
        <translation>vom Markerkörper</translation>
    </message>
    <message>
        <source>the robot</source>
        <translation>vom Roboter</translation>
    </message>
    <message>
        <source>the tracker</source>
        <translation>vom Tracker</translation>
    </message>
    <message>
        <source>tilt about u</source>
        <translation>Kippung um u</translation>
    </message>
    <message>
        <source>tilt about w</source>
        <translation>Kippung um w</translation>
    </message>
    <message>
        <source>times the noise</source>
        <translation>mal Rauschen</translation>
    </message>
    <message>
        <source>took out %1</source>
        <translation>%1 herausgenommen</translation>
    </message>
    <message>
        <source>took out: %1</source>
        <translation>herausgenommen: %1</translation>
    </message>
    <message>
        <source>took out %1, no longer needed</source>
        <translation>%1 herausgenommen, nicht mehr nötig</translation>
    </message>
    <message>
        <source>tracker</source>
        <translation>Tracker</translation>
    </message>
    <message>
        <source>tracker | body | robot</source>
        <translation>Tracker | Körper | Roboter</translation>
    </message>
    <message>
        <source>turns about %1</source>
        <translation>dreht sich um %1</translation>
    </message>
    <message>
        <source>unexplained</source>
        <translation>unerklärt</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>use the labels</source>
        <translation>die Marken übernehmen</translation>
    </message>
    <message>
        <source>used</source>
        <translation>benutzt</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>waits for a fit</source>
        <translation>wartet auf ein Modell</translation>
    </message>
    <message>
        <source>waits for labels</source>
        <translation>wartet auf Marken</translation>
    </message>
    <message>
        <source>waits for more observations</source>
        <translation>wartet auf mehr Beobachtungen</translation>
    </message>
    <message>
        <source>was not hidden</source>
        <translation>war nicht versteckt</translation>
    </message>
    <message>
        <source>whose fault: not known yet</source>
        <translation>woran es liegt: offen</translation>
    </message>
    <message>
        <source>why not used</source>
        <translation>warum nicht benutzt</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>%1; with all %2</source>
        <translation>%1; mit allen %2</translation>
    </message>
    <message>
        <source>x mm</source>
        <translation>x mm</translation>
    </message>
    <message>
        <source>x y z TCP</source>
        <translation>x y z TCP</translation>
    </message>
    <message>
        <source>x y z TCP, x′ y′ z′ TCPest</source>
        <translation>x y z TCP, x′ y′ z′ TCPest</translation>
    </message>
    <message>
        <source>x y z, m</source>
        <translation>x y z, m</translation>
    </message>
    <message>
        <source>xyz + rpy</source>
        <translation>xyz + rpy</translation>
    </message>
    <message>
        <source>y mm</source>
        <translation>y mm</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>yaw deg</source>
        <translation>Gieren Grad</translation>
    </message>
    <message>
        <source>z mm</source>
        <translation>z mm</translation>
    </message>
    <message>
        <source>±</source>
        <translation>±</translation>
    </message>
    <message>
        <source>inner corners</source>
        <translation>innere Ecken</translation>
    </message>
    <message>
        <source>tags</source>
        <translation>Tags</translation>
    </message>
    <message>
        <source>squares</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>Side of a tag</source>
        <translation>Seite eines Tags</translation>
    </message>
    <message>
        <source>Gap between tags / side</source>
        <translation>Lücke zwischen Tags / Seite</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Wörterbuch</translation>
    </message>
    <message>
        <source>Numbers of the tags</source>
        <translation>Nummern der Tags</translation>
    </message>
    <message>
        <source>Save a sheet to print…</source>
        <translation>Blatt zum Drucken speichern…</translation>
    </message>
    <message>
        <source>Save a sheet to print</source>
        <translation>Blatt zum Drucken speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Print it at 100 %, check its ruler, and glue it to something flat.</source>
        <translation>Mit 100 % drucken, das Lineal darauf prüfen und auf etwas Ebenes kleben.</translation>
    </message>
    <message>
        <source>It looks the same after half a turn: one column more or less tells its ends apart.</source>
        <translation>Um eine halbe Drehung gedreht sieht es gleich aus: eine Spalte mehr oder weniger unterscheidet seine Enden.</translation>
    </message>
    <message>
        <source>Saved as %1: %2, %3 × %4 mm. Print it at 100 % and check its ruler.</source>
        <translation>Gespeichert als %1: %2, %3 × %4 mm. Mit 100 % drucken und das Lineal darauf prüfen.</translation>
    </message>
    <message>
        <source>One camera of %1 px focal length.</source>
        <translation>Eine Kamera mit %1 px Brennweite.</translation>
    </message>
    <message>
        <source>%1 cameras.</source>
        <translation>%1 Kameras.</translation>
    </message>
    <message>
        <source>%1: holds no poses; expected columns x y z qx qy qz qw, a line for each instant.</source>
        <translation>%1: enthält keine Posen; erwartet sind Spalten x y z qx qy qz qw, eine Zeile je Zeitpunkt.</translation>
    </message>
    <message>
        <source>No joint moves between camera and target: choose other links.</source>
        <translation>Zwischen Kamera und Ziel bewegt sich kein Gelenk: andere Glieder wählen.</translation>
    </message>
    <message>
        <source>There are %1 lines of joint angles for %2 poses: each instant needs one of each, in the same order.</source>
        <translation>Es sind %1 Zeilen mit Gelenkwinkeln für %2 Posen: Jeder Zeitpunkt braucht beides, in derselben Reihenfolge.</translation>
    </message>
    <message>
        <source>There are images of %1 and a calibration of %2.</source>
        <translation>Es gibt Bilder von %1 und eine Kalibrierung von %2.</translation>
    </message>
    <message>
        <source>On a stand</source>
        <translation>Auf einem Stativ</translation>
    </message>
    <message>
        <source>It stands beside the robot and does not move.</source>
        <translation>Sie steht neben dem Roboter und bewegt sich nicht.</translation>
    </message>
    <message>
        <source>On the robot</source>
        <translation>Am Roboter</translation>
    </message>
    <message>
        <source>On its head or any other link that is not the one with the target.</source>
        <translation>Auf dem Kopf oder einem anderen Glied, nicht dem mit dem Ziel.</translation>
    </message>
    <message>
        <source>On the hand</source>
        <translation>An der Hand</translation>
    </message>
    <message>
        <source>It moves with the hand and looks at a target that stands still.</source>
        <translation>Sie bewegt sich mit der Hand und sieht ein Ziel, das stillsteht.</translation>
    </message>
    <message>
        <source>It is held or mounted; the hand carries it.</source>
        <translation>Es wird gehalten oder ist befestigt; die Hand trägt es.</translation>
    </message>
    <message>
        <source>On the table</source>
        <translation>Auf dem Tisch</translation>
    </message>
    <message>
        <source>It stands still beside the robot.</source>
        <translation>Es steht still neben dem Roboter.</translation>
    </message>
    <message>
        <source>Markers without numbers</source>
        <translation>Marker ohne Nummern</translation>
    </message>
    <message>
        <source>Corners of two colours that you click once; two cameras.</source>
        <translation>Zweifarbige Ecken, die einmal angeklickt werden; zwei Kameras.</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Found by itself where the whole board is in sight.</source>
        <translation>Wird von selbst gefunden, wo das ganze Brett zu sehen ist.</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco-Brett</translation>
    </message>
    <message>
        <source>Found by itself, also where a part of it is hidden.</source>
        <translation>Wird von selbst gefunden, auch wo ein Teil verdeckt ist.</translation>
    </message>
    <message>
        <source>AprilGrid</source>
        <translation>AprilGrid</translation>
    </message>
    <message>
        <source>A grid of AprilTags, as Kalibr prints it.</source>
        <translation>Ein Gitter von AprilTags, wie Kalibr es druckt.</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Tags</translation>
    </message>
    <message>
        <source>ArUco or AprilTags, each where you put it.</source>
        <translation>ArUco oder AprilTags, jeder wo er hingestellt wurde.</translation>
    </message>
    <message>
        <source>Printed from here</source>
        <translation>Von hier gedruckt</translation>
    </message>
    <message>
        <source>A good board for a start, as a PDF to print.</source>
        <translation>Ein gutes Brett für den Anfang, als PDF zum Drucken.</translation>
    </message>
    <message>
        <source>Poses from another program</source>
        <translation>Posen aus anderem Programm</translation>
    </message>
    <message>
        <source>A table of where the target is, in place of images.</source>
        <translation>Eine Tabelle, wo das Ziel ist, an Stelle von Bildern.</translation>
    </message>
    <message>
        <source>Where is the camera?</source>
        <translation>Wo ist die Kamera?</translation>
    </message>
    <message>
        <source>Where is the target?</source>
        <translation>Wo ist das Ziel?</translation>
    </message>
    <message>
        <source>What do you know of it?</source>
        <translation>Was ist davon bekannt?</translation>
    </message>
    <message>
        <source>The robot stands here as soon as its URDF is named.</source>
        <translation>Hier steht der Roboter, sobald seine URDF genannt ist.</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Second camera</source>
        <translation>Zweite Kamera</translation>
    </message>
    <message>
        <source>folder; if there is one</source>
        <translation>Ordner; wenn es eine gibt</translation>
    </message>
    <message>
        <source>Camera calibration</source>
        <translation>Kamerakalibrierung</translation>
    </message>
    <message>
        <source>I know where the sensor sits on its link</source>
        <translation>Ich weiß, wo der Sensor auf seinem Glied sitzt</translation>
    </message>
    <message>
        <source>I know where the first camera sits on its link</source>
        <translation>Ich weiß, wo die erste Kamera auf ihrem Glied sitzt</translation>
    </message>
    <message>
        <source>Camera on %1, target on %2: %3 between them.</source>
        <translation>Kamera auf %1, Ziel auf %2: dazwischen %3.</translation>
    </message>
    <message>
        <source>Where exactly the two sit is found from the observations.</source>
        <translation>Wo genau beide sitzen, ergeben die Beobachtungen.</translation>
    </message>
    <message>
        <source>New session</source>
        <translation>Neue Sitzung</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>CSV: a line for each instant, rad</source>
        <translation>CSV: eine Zeile je Zeitpunkt, rad</translation>
    </message>
    <message>
        <source>More cameras</source>
        <translation>Weitere Kameras</translation>
    </message>
    <message>
        <source>folders; several by ;</source>
        <translation>Ordner; mehrere durch ;</translation>
    </message>
    <message>
        <source>Poses of the target</source>
        <translation>Posen des Ziels</translation>
    </message>
    <message>
        <source>CSV or YAML: x y z qx qy qz qw</source>
        <translation>CSV oder YAML: x y z qx qy qz qw</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.yaml *.yml)</source>
        <translation>Tabellen (*.csv *.txt *.yaml *.yml)</translation>
    </message>
    <message>
        <source>Camera on link</source>
        <translation>Kamera auf Glied</translation>
    </message>
    <message>
        <source>Target on link</source>
        <translation>Ziel auf Glied</translation>
    </message>
    <message>
        <source>Number of markers</source>
        <translation>Anzahl der Marker</translation>
    </message>
    <message>
        <source>The session</source>
        <translation>Die Sitzung</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n instant(s) that all cameras saw</source>
        <translation>
            <numerusform>%n Zeitpunkt, den alle Kameras sahen</numerusform>
            <numerusform>%n Zeitpunkte, die alle Kameras sahen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s) of the target</source>
        <translation>
            <numerusform>%n Pose des Ziels</numerusform>
            <numerusform>%n Posen des Ziels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s) of the flange</source>
        <translation>
            <numerusform>%n Pose des Flansches</numerusform>
            <numerusform>%n Posen des Flansches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s)</source>
        <translation>
            <numerusform>%n Kamera</numerusform>
            <numerusform>%n Kameras</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n moving joint(s)</source>
        <translation>
            <numerusform>%n bewegtes Gelenk</numerusform>
            <numerusform>%n bewegte Gelenke</numerusform>
        </translation>
    </message>
    <message>
        <source>, is being read …</source>
        <translation>, wird gelesen …</translation>
    </message>
    <message>
        <source>The image is being read …</source>
        <translation>Das Bild wird gelesen …</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Nothing stands out of the noise</source>
        <translation>Nichts ragt aus dem Rauschen</translation>
    </message>
    <message>
        <source>%1: held out %2, fitted %3. %4</source>
        <translation>%1: ungesehen %2, angepasst %3. %4</translation>
    </message>
    <message>
        <source>%1: not added</source>
        <translation>%1: nicht hinzugefügt</translation>
    </message>
    <message>
        <source>Cannot be told from %1 on these poses.</source>
        <translation>In diesen Posen nicht zu unterscheiden von: %1.</translation>
    </message>
    <message>
        <source>Check: %1</source>
        <translation>Probe: %1</translation>
    </message>
    <message>
        <source>These poses could not show it, if it were there.</source>
        <translation>Diese Posen könnten es nicht zeigen, wenn es da wäre.</translation>
    </message>
    <message>
        <source>Try it on the robot and type what it shows.</source>
        <translation>Am Roboter versuchen und eintippen, was er zeigt.</translation>
    </message>
    <message>
        <source>adequate</source>
        <translation>stimmt</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>mehrdeutig</translation>
    </message>
    <message>
        <source>and %1 more numbers</source>
        <translation>und %1 weitere Zahlen</translation>
    </message>
    <message>
        <source>cause missing</source>
        <translation>Ursache fehlt</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>Änderung %1</translation>
    </message>
    <message>
        <source>no change</source>
        <translation>keine Änderung</translation>
    </message>
    <message>
        <source>fits, but worse</source>
        <translation>passt, aber schlechter</translation>
    </message>
    <message>
        <source>in the model</source>
        <translation>im Modell</translation>
    </message>
    <message>
        <source>looking …</source>
        <translation>sucht …</translation>
    </message>
    <message>
        <source>no sign</source>
        <translation>kein Anzeichen</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>same as</source>
        <translation>gleich wie</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>too few</source>
        <translation>zu wenige</translation>
    </message>
    <message>
        <source>unseen on these poses</source>
        <translation>in diesen Posen unsichtbar</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>where</source>
        <translation>wo</translation>
    </message>
    <message>
        <source>why</source>
        <translation>warum</translation>
    </message>
    <message>
        <source>would help</source>
        <translation>würde helfen</translation>
    </message>
    <message>
        <source>may be there</source>
        <translation>vielleicht da</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>The observation's id</source>
        <translation>Die Nummer der Beobachtung</translation>
    </message>
    <message>
        <source>How far TCPest is turned from the TCP, degrees</source>
        <translation>Wie weit TCPest gegen den TCP gedreht ist, in Grad</translation>
    </message>
    <message>
        <source>The marker and image with the largest residual; sorts by its size</source>
        <translation>Marker und Bild mit dem größten Rest; sortiert nach dessen Größe</translation>
    </message>
    <message>
        <source>Whether the fit uses it; odd: it stands out of the others</source>
        <translation>Ob die Anpassung sie benutzt; auffällig: sie ragt heraus</translation>
    </message>
    <message>
        <source>Why it is rejected or excluded, or what is to be said of it</source>
        <translation>Warum sie verworfen oder ausgeschlossen ist, oder was zu ihr zu sagen ist</translation>
    </message>
    <message>
        <source>Root mean square of its image coordinates' residuals, px</source>
        <translation>Mittlerer Rest ihrer Bildkoordinaten, px</translation>
    </message>
    <message>
        <source>Root mean square of its markers' residuals in space, mm</source>
        <translation>Mittlerer Rest ihrer Marker im Raum, mm</translation>
    </message>
    <message>
        <source>Root mean square of its coordinates' residuals over the noise of one</source>
        <translation>Mittlerer Rest ihrer Koordinaten, geteilt durch das Rauschen einer</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Com&amp;pare with another session…</source>
        <translation>Mit einer anderen Sitzung &amp;vergleichen…</translation>
    </message>
    <message>
        <source>compare with another session of this robot, or with a calibration</source>
        <translation>mit einer anderen Sitzung dieses Roboters oder einer Kalibrierung vergleichen</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>The earlier one is the later one, and the other way round</source>
        <translation>Die frühere ist die spätere und umgekehrt</translation>
    </message>
    <message>
        <source>Compare again</source>
        <translation>Neu vergleichen</translation>
    </message>
    <message>
        <source>With the open session as it is now</source>
        <translation>Mit der offenen Sitzung, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>Another one…</source>
        <translation>Eine andere…</translation>
    </message>
    <message>
        <source>Another session of the same robot, or a calibration</source>
        <translation>Eine andere Sitzung desselben Roboters oder eine Kalibrierung</translation>
    </message>
    <message>
        <source>Back to the workspaces; both sessions are as they were</source>
        <translation>Zurück zu den Arbeitsbereichen; beide Sitzungen sind, wie sie waren</translation>
    </message>
    <message>
        <source>What may have changed</source>
        <translation>Was sich geändert haben kann</translation>
    </message>
    <message>
        <source>ln Bayes</source>
        <translation>ln Bayes</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>in σ</source>
        <translation>in σ</translation>
    </message>
    <message>
        <source>Numbers of both</source>
        <translation>Zahlen von beiden</translation>
    </message>
    <message>
        <source>Choose another session of this robot, or several, or a calibration that was exported for it: what has changed is told here, and two are shown by the same plots.</source>
        <translation>Wähle eine andere Sitzung dieses Roboters, oder mehrere, oder eine Kalibrierung, die für ihn exportiert wurde: Hier steht dann, was sich geändert hat, und zwei sind in denselben Diagrammen zu sehen.</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>the lenses</source>
        <translation>die Objektive</translation>
    </message>
    <message>
        <source>TCP→Body %1</source>
        <translation>TCP→Body %1</translation>
    </message>
    <message>
        <source>sensor on its mount, %1</source>
        <translation>Sensor auf seiner Halterung, %1</translation>
    </message>
    <message>
        <source>The hand is %1 mm from where it was in the mean over these poses, at most %2 mm.</source>
        <translation>Die Hand ist im Mittel über diese Posen %1 mm von da, wo sie war, höchstens %2 mm.</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>%1 → %2 %3</source>
        <translation>%1 → %2 %3</translation>
    </message>
    <message>
        <source>Sessions and calibrations (*.xml)</source>
        <translation>Sitzungen und Kalibrierungen (*.xml)</translation>
    </message>
    <message>
        <source>Comparing with %1</source>
        <translation>Vergleich mit %1</translation>
    </message>
    <message>
        <source>Being compared …</source>
        <translation>Wird verglichen …</translation>
    </message>
    <message>
        <source>Stopped. Nothing was compared.</source>
        <translation>Abgebrochen. Nichts wurde verglichen.</translation>
    </message>
    <message>
        <source>A calibration is always the earlier one</source>
        <translation>Eine Kalibrierung ist immer die frühere</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Verglichen mit %1</translation>
    </message>
    <message>
        <source>Compare with another session</source>
        <translation>Mit einer anderen Sitzung vergleichen</translation>
    </message>
    <message>
        <source>Before: %1. After: %2.</source>
        <translation>Vorher: %1. Nachher: %2.</translation>
    </message>
    <message>
        <source>The open session has changed since.</source>
        <translation>Die offene Sitzung hat sich seitdem geändert.</translation>
    </message>
    <message>
        <source>By evidence</source>
        <translation>Nach Evidenz</translation>
    </message>
    <message>
        <source>What counts is above %1.</source>
        <translation>Was zählt, liegt über %1.</translation>
    </message>
    <message>
        <source>Above %1: no chance.</source>
        <translation>Über %1: kein Zufall.</translation>
    </message>
    <message>
        <source>No residuals of this one.</source>
        <translation>Von dieser gibt es keine Residuen.</translation>
    </message>
    <message>
        <source>%1, as the calibration has it</source>
        <translation>%1, wie die Kalibrierung es sagt</translation>
    </message>
    <message>
        <source>%1, fitted anew</source>
        <translation>%1, neu angepasst</translation>
    </message>
    <message>
        <source>before: %1</source>
        <translation>vorher: %1</translation>
    </message>
    <message>
        <source>after: %1</source>
        <translation>nachher: %1</translation>
    </message>
    <message>
        <source>TCP→Body, position: %1</source>
        <translation>TCP→Body, Ort: %1</translation>
    </message>
    <message>
        <source>TCP→Body, rotation: %1</source>
        <translation>TCP→Body, Drehung: %1</translation>
    </message>
    <message>
        <source>A calibration tells its result alone: it is where the other one's curves are counted from.</source>
        <translation>Eine Kalibrierung sagt nur ihr Ergebnis: von ihm aus zählen die Kurven der anderen.</translation>
    </message>
    <message>
        <source>It is not known how this estimate came about.</source>
        <translation>Wie diese Schätzung zustande kam, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>A calibration has no residuals of its own.</source>
        <translation>Eine Kalibrierung hat keine eigenen Residuen.</translation>
    </message>
    <message>
        <source>The residuals follow nothing here, or there is no fit.</source>
        <translation>Die Residuen folgen hier nichts, oder es gibt keine Anpassung.</translation>
    </message>
    <message>
        <source>Slips in the model of the open session are left out: they came at observations of its own.</source>
        <translation>Sprünge im Modell der offenen Sitzung bleiben weg: sie kamen bei deren eigenen Beobachtungen.</translation>
    </message>
    <message>
        <source>Numbers that the model holds are estimated here, in both.</source>
        <translation>Zahlen, die das Modell festhält, werden hier in beiden geschätzt.</translation>
    </message>
    <message>
        <source>This is the session that is open; choose another one of the same robot, or a calibration.</source>
        <translation>Das ist die Sitzung, die offen ist; eine andere desselben Roboters wählen oder eine Kalibrierung.</translation>
    </message>
    <message>
        <source>; another program had changed it meanwhile, and what it wrote is kept in %1</source>
        <translation>; ein anderes Programm hatte sie inzwischen geändert, und was es schrieb, steht in %1</translation>
    </message>
    <message>
        <source>; what the other program wrote is kept in %1</source>
        <translation>; was das andere Programm schrieb, steht in %1</translation>
    </message>
    <message>
        <source>; what another program wrote meanwhile is in it too</source>
        <translation>; was ein anderes Programm inzwischen schrieb, ist auch darin</translation>
    </message>
    <message>
        <source>took over %1 from another program</source>
        <translation>%1 von einem anderen Programm übernommen</translation>
    </message>
    <message>
        <source>what was done here before another program changed the session</source>
        <translation>was hier getan wurde, bevor ein anderes Programm die Sitzung änderte</translation>
    </message>
    <message>
        <source>unfinished labels</source>
        <translation>unfertige Beschriftung</translation>
    </message>
    <message>
        <source>session.xml was changed by another program. Your unsaved actions are on top of it, but for what both have changed; all of them are kept in %1.</source>
        <translation>session.xml wurde von einem anderen Programm geändert. Die nicht gespeicherten Aktionen liegen darüber, bis auf das, was beide geändert haben; alle stehen in %1.</translation>
    </message>
    <message>
        <source>session.xml was changed by another program. Your unsaved actions are on top of it, as one action.</source>
        <translation>session.xml wurde von einem anderen Programm geändert. Die nicht gespeicherten Aktionen liegen darüber, als eine Aktion.</translation>
    </message>
    <message>
        <source>session.xml was changed by another program. Your unsaved actions are on top of it as far as they fit it; all of them are kept in %1.</source>
        <translation>session.xml wurde von einem anderen Programm geändert. Die nicht gespeicherten Aktionen liegen darüber, soweit sie dazu passen; alle stehen in %1.</translation>
    </message>
    <message>
        <source>kept what was done here against another program</source>
        <translation>behalten, was hier getan wurde, gegen ein anderes Programm</translation>
    </message>
    <message>
        <source>What another program &amp;wrote…</source>
        <translation>&amp;Was ein anderes Programm schrieb…</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>found by the program</source>
        <translation>vom Programm gefunden</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>eingelesen</translation>
    </message>
    <message>
        <source>no markers</source>
        <translation>keine Marker</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nicht entschieden</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>markers, up to %1 mm apart</source>
        <translation>Marker, bis %1 mm auseinander</translation>
    </message>
    <message>
        <source>markers, up to %1 px apart</source>
        <translation>Marker, bis %1 px auseinander</translation>
    </message>
    <message>
        <source>whether it counts</source>
        <translation>ob sie zählt</translation>
    </message>
    <message>
        <source>whether it is there</source>
        <translation>ob es sie gibt</translation>
    </message>
    <message>
        <source>cameras, markers or joints</source>
        <translation>Kameras, Marker oder Gelenke</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>the session as it is here; the file is kept beside it</source>
        <translation>die Sitzung, wie sie hier ist; die Datei bleibt daneben erhalten</translation>
    </message>
    <message>
        <source>the session as it was written; what was done here is kept beside the journal</source>
        <translation>die Sitzung, wie sie geschrieben wurde; was hier getan wurde, bleibt neben dem Journal erhalten</translation>
    </message>
    <message>
        <source>Another program has written this session since it was read</source>
        <translation>Ein anderes Programm hat diese Sitzung geschrieben, seit sie gelesen wurde</translation>
    </message>
    <message>
        <source>What both have changed</source>
        <translation>Was beide geändert haben</translation>
    </message>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>done here</source>
        <translation>hier getan</translation>
    </message>
    <message>
        <source>written there</source>
        <translation>dort geschrieben</translation>
    </message>
    <message>
        <source>All as done here</source>
        <translation>Alles wie hier</translation>
    </message>
    <message>
        <source>All as written there</source>
        <translation>Alles wie dort</translation>
    </message>
    <message>
        <source>Put together</source>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Nothing is written; saving asks again</source>
        <translation>Nichts wird geschrieben; beim Speichern wird wieder gefragt</translation>
    </message>
    <message>
        <source>It now has other cameras, markers or joints, so that nothing of here can be put into it. Which of the two is to be the session? The other one is kept.</source>
        <translation>Sie hat nun andere Kameras, Marker oder Gelenke, sodass sich nichts von hier hineinbringen lässt. Welche von beiden soll die Sitzung sein? Die andere bleibt erhalten.</translation>
    </message>
    <message>
        <source>What only one side has changed is put together by itself. Here both have changed the same: click on what is to count.</source>
        <translation>Was nur eine Seite geändert hat, wird von selbst zusammengeführt. Hier haben beide dasselbe geändert: anklicken, was zählen soll.</translation>
    </message>
    <message>
        <source>From a bag or other files…</source>
        <translation>Aus einem Bag oder anderen Dateien…</translation>
    </message>
    <message>
        <source>A ROS 2 bag, samples of easy_handeye, tables of points: each is known by its content</source>
        <translation>Ein ROS-2-Bag, Messungen von easy_handeye, Tabellen von Punkten: jede wird an ihrem Inhalt erkannt</translation>
    </message>
    <message>
        <source>of OpenCV, Kalibr or ROS; several by ;</source>
        <translation>von OpenCV, Kalibr oder ROS; mehrere mit ;</translation>
    </message>
    <message>
        <source>Calibrations (*.yml *.yaml *.xml *.json)</source>
        <translation>Kalibrierungen (*.yml *.yaml *.xml *.json)</translation>
    </message>
    <message>
        <source>Nothing is there yet.</source>
        <translation>Noch ist nichts da.</translation>
    </message>
    <message>
        <source>One of them is nothing that a session is made from: remove it, or bring another one.</source>
        <translation>Aus einer davon wird keine Sitzung: entfernen oder eine andere nehmen.</translation>
    </message>
    <message>
        <source>The bag publishes no robot_description: add the robot's URDF.</source>
        <translation>Das Bag enthält keine robot_description: die URDF des Roboters hinzufügen.</translation>
    </message>
    <message>
        <source>There is no robot among them: add its URDF, or a table of its flange's poses.</source>
        <translation>Es ist kein Roboter dabei: seine URDF hinzufügen oder eine Tabelle der Posen seines Flansches.</translation>
    </message>
    <message>
        <source>What a sensor measured is missing: images, points, or poses of a target.</source>
        <translation>Es fehlt, was ein Sensor gemessen hat: Bilder, Punkte oder Posen eines Ziels.</translation>
    </message>
    <message>
        <source>The joint readings are missing: add a table of them, a column for each joint.</source>
        <translation>Die Gelenkwinkel fehlen: eine Tabelle davon hinzufügen, eine Spalte je Gelenk.</translation>
    </message>
    <message>
        <source>The cameras' calibration is missing: add camera_info of ROS, a camchain of Kalibr, or OpenCV's.</source>
        <translation>Die Kalibrierung der Kameras fehlt: camera_info von ROS, eine camchain von Kalibr oder die von OpenCV hinzufügen.</translation>
    </message>
    <message>
        <source>The numbers of the target are of none.</source>
        <translation>Die Zahlen des Ziels ergeben keines.</translation>
    </message>
    <message>
        <source>The new session needs a folder.</source>
        <translation>Die neue Sitzung braucht einen Ordner.</translation>
    </message>
    <message>
        <source>Another program has written this session since it was read.</source>
        <translation>Ein anderes Programm hat diese Sitzung geschrieben, seit sie gelesen wurde.</translation>
    </message>
    <message>
        <source>The next save puts it together</source>
        <translation>Das nächste Speichern führt beides zusammen</translation>
    </message>
    <message>
        <source>Takes over what was written there, and saves what was done here with it</source>
        <translation>Übernimmt, was dort geschrieben wurde, und speichert damit, was hier getan wurde</translation>
    </message>
    <message>
        <source>The session is being made …</source>
        <translation>Die Sitzung wird angelegt …</translation>
    </message>
    <message>
        <source>Making a session</source>
        <translation>Eine Sitzung wird angelegt</translation>
    </message>
    <message>
        <source>Stops what is being made; nothing of it stays (Esc)</source>
        <translation>Hält an, was angelegt wird; nichts davon bleibt (Esc)</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Stopped; nothing was made.</source>
        <translation>Angehalten; es wurde nichts angelegt.</translation>
    </message>
    <message>
        <source>It was made before it could be stopped: %1 in %2.</source>
        <translation>Die Sitzung war angelegt, ehe sich das anhalten ließ: %1 in %2.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>Made: %1 in %2.</source>
        <translation>Angelegt: %1 in %2.</translation>
    </message>
    <message>
        <source>Nothing was left out.</source>
        <translation>Nichts wurde weggelassen.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>New session from files</source>
        <translation>Neue Sitzung aus Dateien</translation>
    </message>
    <message>
        <source>Drop here what there is, or add it: a ROS 2 bag, images, camera_info or a camchain of Kalibr, samples of easy_handeye, tables of joints, poses, points or touches, the robot's URDF. Each is known by its content.</source>
        <translation>Hierher ziehen, was da ist, oder hinzufügen: ein ROS-2-Bag, Bilder, camera_info oder eine camchain von Kalibr, Messungen von easy_handeye, Tabellen von Gelenken, Posen, Punkten oder Berührungen, die URDF des Roboters. Jede Datei wird an ihrem Inhalt erkannt.</translation>
    </message>
    <message>
        <source>Files of the new session</source>
        <translation>Dateien der neuen Sitzung</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>Add a folder…</source>
        <translation>Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>What was understood</source>
        <translation>Was verstanden wurde</translation>
    </message>
    <message>
        <source>Link of the hand (TCP)</source>
        <translation>Glied der Hand (TCP)</translation>
    </message>
    <message>
        <source>Link that carries the sensor</source>
        <translation>Glied, das den Sensor trägt</translation>
    </message>
    <message>
        <source>What the images show</source>
        <translation>Was die Bilder zeigen</translation>
    </message>
    <message>
        <source>Markers without numbers (two cameras)</source>
        <translation>Marker ohne Nummern (zwei Kameras)</translation>
    </message>
    <message>
        <source>The camera stands; the flange carries the target</source>
        <translation>Die Kamera steht; der Flansch trägt das Ziel</translation>
    </message>
    <message>
        <source>Joint angles are in degrees</source>
        <translation>Gelenkwinkel in Grad</translation>
    </message>
    <message>
        <source>Target's frame in /tf</source>
        <translation>Koordinatensystem des Ziels in /tf</translation>
    </message>
    <message>
        <source>where the bag has no images of it; empty: the one that sounds like a target</source>
        <translation>wo das Bag keine Bilder davon hat; leer: das, das nach einem Ziel klingt</translation>
    </message>
    <message>
        <source>The robot must stand for</source>
        <translation>Der Roboter muss stehen für</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>The clocks of robot and sensor may differ: find by how much</source>
        <translation>Die Uhren von Roboter und Sensor können abweichen: finden, um wie viel</translation>
    </message>
    <message>
        <source>New folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>A folder of images, or a bag</source>
        <translation>Ein Ordner mit Bildern oder ein Bag</translation>
    </message>
    <message>
        <source>New session from a &amp;bag or other files…</source>
        <translation>Neue Sitzung aus einem &amp;Bag oder anderen Dateien…</translation>
    </message>
    <message>
        <source>a new session from a ROS 2 bag, Kalibr, camera_info, easy_handeye or tables</source>
        <translation>eine neue Sitzung aus einem ROS-2-Bag, Kalibr, camera_info, easy_handeye oder Tabellen</translation>
    </message>
    <message>
        <source>labels included</source>
        <translation>Marken sind dabei</translation>
    </message>
    <message>
        <source>Next: measure more observations.</source>
        <translation>Als Nächstes: mehr Beobachtungen messen.</translation>
    </message>
    <message>
        <source>Next: measure poses that tell the two apart; Explain plans them.</source>
        <translation>Als Nächstes: Posen messen, die beide unterscheiden; Erklären plant sie.</translation>
    </message>
    <message>
        <source>Next: add %1 to the model.</source>
        <translation>Als Nächstes: %1 ins Modell aufnehmen.</translation>
    </message>
    <message>
        <source>Next: look for another cause; %1 would lower the error, but may stand in for it.</source>
        <translation>Als Nächstes: eine andere Ursache suchen; %1 würde den Fehler senken, steht aber vielleicht nur für sie.</translation>
    </message>
    <message>
        <source>Next: declare the noise (sigma), or repeat some poses.</source>
        <translation>Als Nächstes: das Rauschen angeben (sigma) oder einige Posen wiederholen.</translation>
    </message>
    <message>
        <source>Next: give the links' masses in the robot's file; nothing that bends could be tried.</source>
        <translation>Als Nächstes: die Massen der Glieder in der Datei des Roboters angeben; nichts, was sich biegt, konnte geprüft werden.</translation>
    </message>
    <message>
        <source>No link of the robot has a mass, so that nothing that bends could be tried: give the masses in the robot's file.</source>
        <translation>Kein Glied des Roboters hat eine Masse, so dass nichts, was sich biegt, geprüft werden konnte: Geben Sie die Massen in der Datei des Roboters an.</translation>
    </message>
    <message>
        <source>Next: look at what is left and at what it follows.</source>
        <translation>Als Nächstes: ansehen, was übrig ist und wovon es abhängt.</translation>
    </message>
    <message>
        <source>Next: use it. The numbers stand below and in the XML.</source>
        <translation>Als Nächstes: verwenden. Die Zahlen stehen unten und im XML.</translation>
    </message>
    <message>
        <source>The bill: what each cause is worth at the hand (rms)</source>
        <translation>Die Rechnung: was jede Ursache an der Hand ausmacht (rms)</translation>
    </message>
    <message>
        <source>At the hand</source>
        <translation>An der Hand</translation>
    </message>
    <message>
        <source>What to know of it</source>
        <translation>Was dazu zu wissen ist</translation>
    </message>
    <message>
        <source>The residual of every corner</source>
        <translation>Der Rest jeder Ecke</translation>
    </message>
    <message>
        <source>The residual of every marker</source>
        <translation>Der Rest jedes Markers</translation>
    </message>
    <message>
        <source>%1; the rings are one and three sigma</source>
        <translation>%1; die Ringe sind ein und drei Sigma</translation>
    </message>
    <message>
        <source>%1, at first and now, on the same axes; the rings are one and three sigma</source>
        <translation>%1, zuerst und jetzt, auf denselben Achsen; die Ringe sind ein und drei Sigma</translation>
    </message>
    <message>
        <source>nothing to play</source>
        <translation>nichts abzuspielen</translation>
    </message>
    <message>
        <source>Nothing to play</source>
        <translation>Nichts abzuspielen</translation>
    </message>
    <message>
        <source>Tour: the hand that hangs (Hidden 3)</source>
        <translation>Rundgang: die hängende Hand (Versteckt 3)</translation>
    </message>
    <message>
        <source>Justin's hand is three pixels from where it should be: what is missing? Step by step.</source>
        <translation>Justins Hand ist drei Pixel von dort, wo sie sein sollte: Was fehlt? Schritt für Schritt.</translation>
    </message>
    <message>
        <source>Finds out where a robot's hand really is, and why it is not where its model says. Open a session, make one from your images, or try one of these.</source>
        <translation>Findet heraus, wo die Hand eines Roboters wirklich ist und warum sie nicht dort ist, wo sein Modell sie hat. Öffne eine Sitzung, lege eine aus deinen Bildern an, oder versuche eine von diesen.</translation>
    </message>
    <message>
        <source>Where does it fail, and why? Every observation against what the likeliest cause follows: the points lie on its curve. Hold N to see how noise alone would look.</source>
        <translation>Wo versagt es, und warum? Jede Beobachtung über dem, wovon die wahrscheinlichste Ursache abhängt: Die Punkte liegen auf ihrer Kurve. N gedrückt halten zeigt, wie Rauschen allein aussähe.</translation>
    </message>
    <message>
        <source>Other patterns of the same residuals are in this tab. Click one to see it large; Shift and drag to ask what some observations have in common.</source>
        <translation>Andere Muster derselben Reste stehen in diesem Reiter. Ein Klick zeigt eines groß; Umschalt und Ziehen fragt, was einige Beobachtungen gemeinsam haben.</translation>
    </message>
    <message>
        <source>looks random</source>
        <translation>sieht zufällig aus</translation>
    </message>
    <message>
        <source>The proof</source>
        <translation>Der Beweis</translation>
    </message>
    <message>
        <source>Other patterns</source>
        <translation>Andere Muster</translation>
    </message>
    <message>
        <source>Show strongest first</source>
        <translation>Stärkste zuerst zeigen</translation>
    </message>
    <message>
        <source>What is left of every point comes here.</source>
        <translation>Hier steht, was von jedem Punkt übrig bleibt.</translation>
    </message>
    <message>
        <source>The remaining error looks random</source>
        <translation>Der restliche Fehler sieht zufällig aus</translation>
    </message>
    <message>
        <source>Cannot be split with one marker</source>
        <translation>Mit einem Marker nicht aufzuteilen</translation>
    </message>
    <message>
        <source>at %1 a spring that pushes back: there it stands in for another cause</source>
        <translation>bei %1 eine Feder, die zurückdrückt: Dort vertritt sie eine andere Ursache</translation>
    </message>
    <message>
        <source>at %1 larger than robots are built: there it stands in for another cause</source>
        <translation>bei %1 größer, als Roboter gebaut sind: Dort vertritt sie eine andere Ursache</translation>
    </message>
    <message>
        <source>a spring that pushes back: it stands in for another cause</source>
        <translation>eine Feder, die zurückdrückt: Sie vertritt eine andere Ursache</translation>
    </message>
    <message>
        <source>larger than robots are built: it stands in for another cause</source>
        <translation>größer, als Roboter gebaut sind: Sie vertritt eine andere Ursache</translation>
    </message>
    <message>
        <source>a little at each joint, as in every robot</source>
        <translation>ein wenig an jedem Gelenk, wie in jedem Roboter</translation>
    </message>
    <message>
        <source>held, not estimated</source>
        <translation>festgehalten, nicht geschätzt</translation>
    </message>
    <message>
        <source>no name in the catalogue</source>
        <translation>kein Name im Katalog</translation>
    </message>
    <message>
        <source>sure to %1 %</source>
        <translation>zu %1 % sicher</translation>
    </message>
    <message>
        <source>decimal point</source>
        <translation>,</translation>
    </message>
    <message>
        <source>change from the first (%1)</source>
        <translation>Änderung gegenüber dem Ersten (%1)</translation>
    </message>
    <message>
        <source>change from the first</source>
        <translation>Änderung gegenüber dem Ersten</translation>
    </message>
    <message>
        <source>change from final</source>
        <translation>zum Endwert</translation>
    </message>
    <message>
        <source>change from final (%1)</source>
        <translation>zum Endwert (%1)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Das Bild speichern</translation>
    </message>
    <message>
        <source>The bill of the model</source>
        <translation>Die Rechnung des Modells</translation>
    </message>
    <message>
        <source>No cause is in the model.</source>
        <translation>Keine Ursache ist im Modell.</translation>
    </message>
    <message>
        <source>%1: %2 at the hand. %3</source>
        <translation>%1: %2 an der Hand. %3</translation>
    </message>
    <message>
        <source>noise:</source>
        <translation>Rauschen:</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>zweimal</translation>
    </message>
    <message>
        <source>three times</source>
        <translation>dreimal</translation>
    </message>
    <message>
        <source>%1 has an error that repeats %2 a turn</source>
        <translation>%1 hat einen Fehler, der sich %2 je Umdrehung wiederholt</translation>
    </message>
    <message>
        <source>An error of %1 that repeats %2 a turn</source>
        <translation>Ein Fehler von %1, der sich %2 je Umdrehung wiederholt</translation>
    </message>
    <message>
        <source>%1 (± %2)</source>
        <translation>%1 (± %2)</translation>
    </message>
    <message>
        <source>error of the hand (mm)</source>
        <translation>Fehler der Hand (mm)</translation>
    </message>
    <message>
        <source>told from all others</source>
        <translation>von allen anderen unterschieden</translation>
    </message>
    <message>
        <source>not told from %1</source>
        <translation>nicht unterschieden von %1</translation>
    </message>
    <message>
        <source>plausible</source>
        <translation>plausibel</translation>
    </message>
    <message>
        <source>The collection or one of its sessions was changed by another program since it was opened; close it and open it again: what was done here is put on top of it.</source>
        <translation>Die Sammlung oder eine ihrer Sitzungen wurde von einem anderen Programm geändert, seit sie geöffnet wurde; schließe sie und öffne sie wieder: was hier getan wurde, kommt obendrauf.</translation>
    </message>
    <message>
        <source>%1 is there already and is not written over; name another file.</source>
        <translation>%1 gibt es schon und wird nicht überschrieben; nenne eine andere Datei.</translation>
    </message>
    <message>
        <source>Add a session</source>
        <translation>Sitzung hinzufügen</translation>
    </message>
    <message>
        <source>What is shared</source>
        <translation>Was gemeinsam ist</translation>
    </message>
    <message>
        <source>Shares with</source>
        <translation>Gemeinsam mit</translation>
    </message>
    <message>
        <source>shares with</source>
        <translation>hat gemeinsam mit</translation>
    </message>
    <message>
        <source>The robot</source>
        <translation>Der Roboter</translation>
    </message>
    <message>
        <source>Joints, links and masses are one for all sessions.</source>
        <translation>Gelenke, Glieder und Massen sind für alle Sitzungen dieselben.</translation>
    </message>
    <message>
        <source>The cameras or the tracker, at the same place</source>
        <translation>Die Kameras oder der Tracker, am selben Ort</translation>
    </message>
    <message>
        <source>One mount, one lens. What was moved in between is at another place.</source>
        <translation>Ein Ort, eine Linse. Was dazwischen bewegt wurde, ist an einem anderen Ort.</translation>
    </message>
    <message>
        <source>The hand: the same markers or board on the same TCP</source>
        <translation>Die Hand: dieselben Marker oder dasselbe Brett am selben TCP</translation>
    </message>
    <message>
        <source>One TCP→Body. What was taken off and put on again is another one.</source>
        <translation>Ein TCP→Body. Was abgenommen und wieder angebracht wurde, ist ein anderes.</translation>
    </message>
    <message>
        <source>The collection is written to</source>
        <translation>Die Sammlung wird geschrieben nach</translation>
    </message>
    <message>
        <source>Open it by itself</source>
        <translation>Für sich öffnen</translation>
    </message>
    <message>
        <source>Add the session</source>
        <translation>Sitzung hinzufügen</translation>
    </message>
    <message>
        <source>Choose two sessions.</source>
        <translation>Wähle zwei Sitzungen.</translation>
    </message>
    <message>
        <source>the cameras of %1 are those of %2</source>
        <translation>die Kameras von %1 sind die von %2</translation>
    </message>
    <message>
        <source>the cameras of %1 are not those of %2</source>
        <translation>die Kameras von %1 sind nicht die von %2</translation>
    </message>
    <message>
        <source>the hand of %1 is that of %2</source>
        <translation>die Hand von %1 ist die von %2</translation>
    </message>
    <message>
        <source>the hand of %1 is not that of %2</source>
        <translation>die Hand von %1 ist nicht die von %2</translation>
    </message>
    <message>
        <source>%1 of this session is saved with it.</source>
        <translation>%1 dieser Sitzung: wird mit gespeichert.</translation>
    </message>
    <message>
        <source>added the session %1</source>
        <translation>Sitzung %1 hinzugefügt</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Marks in plots</source>
        <translation>Zeichen in Diagrammen</translation>
    </message>
    <message>
        <source>Draws each point as its session's mark</source>
        <translation>Zeichnet jeden Punkt als Zeichen seiner Sitzung</translation>
    </message>
    <message>
        <source>What is shared…</source>
        <translation>Was gemeinsam ist …</translation>
    </message>
    <message>
        <source>Which have the same cameras, which the same hand</source>
        <translation>Welche dieselben Kameras haben, welche dieselbe Hand</translation>
    </message>
    <message>
        <source>Add a session…</source>
        <translation>Sitzung hinzufügen …</translation>
    </message>
    <message>
        <source>Another hand, another camera or another day of this robot</source>
        <translation>Eine andere Hand, eine andere Kamera oder ein anderer Tag dieses Roboters</translation>
    </message>
    <message>
        <source>%1 everywhere; Shift+click: this one alone</source>
        <translation>%1 überall; Umschalt+Klick: diese allein</translation>
    </message>
    <message>
        <source>Hides it</source>
        <translation>Verbirgt sie</translation>
    </message>
    <message>
        <source>Shows it</source>
        <translation>Zeigt sie</translation>
    </message>
    <message>
        <source>in each session</source>
        <translation>in jeder Sitzung</translation>
    </message>
    <message>
        <source>Markers are clicked in one session: open it by itself.</source>
        <translation>Marker werden in einer einzelnen Sitzung angeklickt: öffne sie für sich.</translation>
    </message>
    <message>
        <source>Saved in %1: %2</source>
        <translation>Gespeichert in %1: %2</translation>
    </message>
    <message>
        <source>&amp;Add a session of this robot…</source>
        <translation>Sitzung dieses Roboters &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>another hand, another camera or another day of this robot: fitted together, told apart</source>
        <translation>eine andere Hand, eine andere Kamera oder ein anderer Tag dieses Roboters: gemeinsam angepasst, auseinandergehalten</translation>
    </message>
    <message>
        <source>What is s&amp;hared…</source>
        <translation>Was &amp;gemeinsam ist …</translation>
    </message>
    <message>
        <source>which sessions of the collection have the same cameras, which the same hand</source>
        <translation>welche Sitzungen der Sammlung dieselben Kameras haben, welche dieselbe Hand</translation>
    </message>
    <message>
        <source>Add a session of this robot</source>
        <translation>Sitzung dieses Roboters hinzufügen</translation>
    </message>
    <message>
        <source>Session whose hand is shown</source>
        <translation>Sitzung, deren Hand gezeigt wird</translation>
    </message>
    <message>
        <source>Whose hand is shown, copied, certified and saved for other programs; the XML holds all of them</source>
        <translation>Wessen Hand gezeigt, kopiert, bescheinigt und für andere Programme gespeichert wird; die XML-Datei enthält alle</translation>
    </message>
    <message>
        <source>%1 sessions</source>
        <translation>%1 Sitzungen</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>TCP→Body of each hand</source>
        <translation>TCP→Body jeder Hand</translation>
    </message>
    <message>
        <source>The robot is one for all sessions; each hand is its own, or shared where you said so.</source>
        <translation>Der Roboter ist für alle Sitzungen derselbe; jede Hand ist eine eigene, oder gemeinsam, wo du es gesagt hast.</translation>
    </message>
    <message>
        <source>TCP→Body, %1</source>
        <translation>TCP→Body, %1</translation>
    </message>
    <message>
        <source>Mount, %1</source>
        <translation>Ort der Kameras, %1</translation>
    </message>
    <message>
        <source>The mount drifts: %1 over the session (%2), %3 mm at the hand at most.</source>
        <translation>Der Ort der Kameras wandert: %1 über die Sitzung (%2), höchstens %3 mm an der Hand.</translation>
    </message>
    <message>
        <source>The mount drifts: %1 over the session (%2).</source>
        <translation>Der Ort der Kameras wandert: %1 über die Sitzung (%2).</translation>
    </message>
    <message>
        <source>with the robot of the others</source>
        <translation>mit dem Roboter der anderen</translation>
    </message>
    <message>
        <source>Sessions held out one by one</source>
        <translation>Sitzungen einzeln zurückgehalten</translation>
    </message>
    <message>
        <source>Each session is played by itself.</source>
        <translation>Jede Sitzung wird für sich abgespielt.</translation>
    </message>
    <message>
        <source>Observations are taken or rejected in each session.</source>
        <translation>Beobachtungen werden in jeder Sitzung genommen oder verworfen.</translation>
    </message>
    <message>
        <source>hand of %1</source>
        <translation>Hand von %1</translation>
    </message>
    <message>
        <source>in columns (symmetric)</source>
        <translation>in Spalten (symmetrisch)</translation>
    </message>
    <message>
        <source>every second row half a step aside (asymmetric)</source>
        <translation>jede zweite Reihe um einen halben Schritt versetzt (asymmetrisch)</translation>
    </message>
    <message>
        <source>The circles stand</source>
        <translation>Die Kreise stehen</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Distance of two circles</source>
        <translation>Abstand zweier Kreise</translation>
    </message>
    <message>
        <source>Diameter of a circle</source>
        <translation>Durchmesser eines Kreises</translation>
    </message>
    <message>
        <source>OpenCV's unit: in an asymmetric grid from a row to the next one, half the step along a row</source>
        <translation>Die Einheit von OpenCV: im asymmetrischen Gitter von einer Reihe zur nächsten, halb so viel wie der Schritt in einer Reihe</translation>
    </message>
    <message>
        <source>It looks the same after half a turn: an asymmetric grid of an odd number of rows has two ends that can be told apart.</source>
        <translation>Es sieht nach einer halben Drehung gleich aus: Ein asymmetrisches Gitter mit ungerader Zahl von Reihen hat zwei Enden, die sich unterscheiden lassen.</translation>
    </message>
    <message>
        <source>Grid of circles</source>
        <translation>Kreisgitter</translation>
    </message>
    <message>
        <source>Found by itself where the whole grid is in sight.</source>
        <translation>Wird von selbst gefunden, wo das ganze Gitter zu sehen ist.</translation>
    </message>
    <message>
        <source>%n pose(s)</source>
        <translation>
            <numerusform>%n Pose</numerusform>
            <numerusform>%n Posen</numerusform>
        </translation>
    </message>
    <message>
        <source>Command of the driver</source>
        <translation>Befehl des Treibers</translation>
    </message>
    <message>
        <source>the command of your robot's driver: python3 my_driver.py</source>
        <translation>der Befehl des Treibers deines Roboters: python3 mein_treiber.py</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>The driver is ended; nothing has moved</source>
        <translation>Der Treiber wird beendet; nichts hat sich bewegt</translation>
    </message>
    <message>
        <source>Try it with the simulated robot</source>
        <translation>Mit dem simulierten Roboter probieren</translation>
    </message>
    <message>
        <source>A copy of this session with a few observations, and a robot that is computed: one of its joints is a little off, and the experiment finds out which</source>
        <translation>Eine Kopie dieser Sitzung mit wenigen Beobachtungen und ein berechneter Roboter: eines seiner Gelenke ist ein wenig verstellt, und das Experiment findet heraus, welches</translation>
    </message>
    <message>
        <source>Move the robot</source>
        <translation>Roboter bewegen</translation>
    </message>
    <message>
        <source>Nothing moves (Esc)</source>
        <translation>Nichts bewegt sich (Esc)</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Treiber</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>Start …</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Asks once more before the robot moves</source>
        <translation>Fragt noch einmal, bevor sich der Roboter bewegt</translation>
    </message>
    <message>
        <source>Starts the driver and chooses the poses to recheck in; nothing moves yet</source>
        <translation>Startet den Treiber und wählt die Posen zum Nachprüfen; noch bewegt sich nichts</translation>
    </message>
    <message>
        <source>Starts the driver and shows the first poses; nothing moves yet</source>
        <translation>Startet den Treiber und zeigt die ersten Posen; noch bewegt sich nichts</translation>
    </message>
    <message>
        <source>How well the hand is known</source>
        <translation>Wie gut die Hand bekannt ist</translation>
    </message>
    <message>
        <source>Measure, and the expected error of the hand falls here.</source>
        <translation>Beim Messen fällt hier der erwartete Fehler der Hand.</translation>
    </message>
    <message>
        <source>odds, to one</source>
        <translation>Quote, zu eins</translation>
    </message>
    <message>
        <source>How sure the cause is</source>
        <translation>Wie sicher die Ursache ist</translation>
    </message>
    <message>
        <source>Measure, and the odds of the likeliest cause rise here.</source>
        <translation>Beim Messen steigt hier die Quote der wahrscheinlichsten Ursache.</translation>
    </message>
    <message>
        <source>Let the robot measure by itself</source>
        <translation>Den Roboter selbst messen lassen</translation>
    </message>
    <message>
        <source>The program chooses the most useful poses, drives there, looks (or touches), and stops when enough is known: where the hand sits, and what is missing in the model.</source>
        <translation>Das Programm wählt die nützlichsten Posen, fährt hin, schaut (oder berührt) und hört auf, wenn genug bekannt ist: wo die Hand sitzt und was im Modell fehlt.</translation>
    </message>
    <message>
        <source>1.  Write the command of your robot's driver above: a program of yours that moves the robot and takes the images, or feels for what is touched. A template of thirty lines is in docs/examples/drivers.</source>
        <translation>1.  Schreibe oben den Befehl des Treibers deines Roboters: ein Programm von dir, das den Roboter bewegt und die Bilder macht oder ertastet, was berührt wird. Eine Vorlage von dreißig Zeilen liegt in docs/examples/drivers.</translation>
    </message>
    <message>
        <source>2.  Connect. The driver says where the robot stands, and the first poses and the ways to them are shown. Nothing moves.</source>
        <translation>2.  Verbinden. Der Treiber sagt, wo der Roboter steht; die ersten Posen und die Wege dorthin werden gezeigt. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>3.  Start. You are asked once more. Then each move is shown as it happens; Esc and the red button stop the robot at any time.</source>
        <translation>3.  Start. Du wirst noch einmal gefragt. Dann wird jede Bewegung gezeigt, während sie geschieht; Esc und der rote Knopf halten den Roboter jederzeit an.</translation>
    </message>
    <message>
        <source>No robot at hand? Try it with the simulated one: a copy of this session is measured on, and nothing comes among your own measurements.</source>
        <translation>Kein Roboter da? Probiere es mit dem simulierten: in einer Kopie dieser Sitzung wird weitergemessen, und nichts kommt unter deine eigenen Messungen.</translation>
    </message>
    <message>
        <source>Likeliest</source>
        <translation>Am wahrscheinlichsten</translation>
    </message>
    <message>
        <source>Next likeliest</source>
        <translation>An zweiter Stelle</translation>
    </message>
    <message>
        <source>Next pose</source>
        <translation>Nächste Pose</translation>
    </message>
    <message>
        <source>One more hour</source>
        <translation>Eine Stunde mehr</translation>
    </message>
    <message>
        <source>When to stop</source>
        <translation>Wann Schluss ist</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Was bekannt ist</translation>
    </message>
    <message>
        <source>Poses that were taken and that come next</source>
        <translation>Posen, die eingenommen wurden und die als Nächstes kommen</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>What for</source>
        <translation>Wozu</translation>
    </message>
    <message>
        <source>nothing measured yet</source>
        <translation>noch nichts gemessen</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>noch nicht bekannt</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>none chosen yet</source>
        <translation>noch keine gewählt</translation>
    </message>
    <message>
        <source>next</source>
        <translation>als Nächstes</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>Observation %1 came from somewhere else meanwhile: the experiment stops.</source>
        <translation>Beobachtung %1 kam inzwischen von anderswo: das Experiment hält an.</translation>
    </message>
    <message>
        <source>measured observation %1</source>
        <translation>Beobachtung %1 gemessen</translation>
    </message>
    <message>
        <source>measured observation %1: taken</source>
        <translation>Beobachtung %1 gemessen: genommen</translation>
    </message>
    <message>
        <source>measured observation %1: rejected</source>
        <translation>Beobachtung %1 gemessen: verworfen</translation>
    </message>
    <message>
        <source>Several sessions are open together. An experiment adds to one: open it by itself.</source>
        <translation>Mehrere Sitzungen sind zusammen offen. Ein Experiment erweitert eine: öffne sie allein.</translation>
    </message>
    <message>
        <source>Of this session's robot only the flange's poses are known, and an experiment moves joints.</source>
        <translation>Vom Roboter dieser Sitzung sind nur Flanschposen bekannt, und ein Experiment bewegt Gelenke.</translation>
    </message>
    <message>
        <source>An experiment begins with one observation at least: add it, and it goes on from there.</source>
        <translation>Ein Experiment beginnt mit mindestens einer Beobachtung: füge sie hinzu, dann geht es von dort weiter.</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>Kein Roboter ist verbunden.</translation>
    </message>
    <message>
        <source>The driver is started and asked where the robot stands ...</source>
        <translation>Der Treiber wird gestartet und gefragt, wo der Roboter steht ...</translation>
    </message>
    <message>
        <source>The robot moves.</source>
        <translation>Der Roboter bewegt sich.</translation>
    </message>
    <message>
        <source>The robot looks.</source>
        <translation>Der Roboter schaut.</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>Hält an ...</translation>
    </message>
    <message>
        <source>The robot was told to stop and stands still; what was measured is summed up ...</source>
        <translation>Der Roboter wurde angehalten und steht still; das Gemessene wird zusammengefasst ...</translation>
    </message>
    <message>
        <source>to settle the estimate</source>
        <translation>um die Schätzung zu festigen</translation>
    </message>
    <message>
        <source>to tell two causes apart</source>
        <translation>um zwei Ursachen zu unterscheiden</translation>
    </message>
    <message>
        <source>a small step from where it was seen</source>
        <translation>ein kleiner Schritt von dort, wo es zu sehen war</translation>
    </message>
    <message>
        <source>where it has not been measured yet</source>
        <translation>wo noch nicht gemessen wurde</translation>
    </message>
    <message>
        <source>within %1 mm</source>
        <translation>auf %1 mm</translation>
    </message>
    <message>
        <source>%1 in the box (95 %)</source>
        <translation>%1 im Kasten (95 %)</translation>
    </message>
    <message>
        <source>%1 wherever it can be seen (95 %)</source>
        <translation>%1 überall, wo sie zu sehen ist (95 %)</translation>
    </message>
    <message>
        <source>asked from %1 observations on</source>
        <translation>wird ab %1 Beobachtungen gefragt</translation>
    </message>
    <message>
        <source>something without a name that follows the %1, %2</source>
        <translation>etwas ohne Namen, es folgt %1, %2</translation>
    </message>
    <message>
        <source>nothing that these poses can show, %1</source>
        <translation>nichts, was diese Posen zeigen können, %1</translation>
    </message>
    <message>
        <source>nothing is sure yet</source>
        <translation>noch ist nichts sicher</translation>
    </message>
    <message>
        <source>%1 against none</source>
        <translation>%1 gegen keine</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>less likely than none</source>
        <translation>unwahrscheinlicher als keine</translation>
    </message>
    <message>
        <source>%1 rad away</source>
        <translation>%1 rad entfernt</translation>
    </message>
    <message>
        <source>%1, round what is in the way</source>
        <translation>%1, um das Hindernis herum</translation>
    </message>
    <message>
        <source>The robot moves now: %1 at first, the first one at a tenth of %2 rad/s. Is nobody within its reach, and is the emergency stop at hand?</source>
        <translation>Der Roboter bewegt sich jetzt: zuerst %1, die erste mit einem Zehntel von %2 rad/s. Ist niemand in seiner Reichweite und der Not-Halt zur Hand?</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Recheck</source>
        <translation>Nachprüfen</translation>
    </message>
    <message>
        <source>not of this session</source>
        <translation>nicht für diese Sitzung</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 gemessen</translation>
    </message>
    <message>
        <source>no robot connected</source>
        <translation>kein Roboter verbunden</translation>
    </message>
    <message>
        <source>ready to start</source>
        <translation>startbereit</translation>
    </message>
    <message>
        <source>the robot moves</source>
        <translation>Roboter bewegt sich</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>the robot waits</source>
        <translation>Roboter wartet</translation>
    </message>
    <message>
        <source>choosing poses</source>
        <translation>wählt Posen</translation>
    </message>
    <message>
        <source>stop the robot, from everywhere</source>
        <translation>den Roboter anhalten, von überall</translation>
    </message>
    <message>
        <source> to one</source>
        <translation> zu eins</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation> rad/s</translation>
    </message>
    <message>
        <source>Of the fastest joint (m/s where it slides); the first move takes a tenth of it</source>
        <translation>Des schnellsten Gelenks (m/s, wo es schiebt); die erste Bewegung nimmt ein Zehntel davon</translation>
    </message>
    <message>
        <source>the hand is known within</source>
        <translation>die Hand ist bekannt auf</translation>
    </message>
    <message>
        <source>In 95 of 100 cases, in 95 of 100 poses over what can be reached and seen</source>
        <translation>In 95 von 100 Fällen, in 95 von 100 Posen über alles, was erreicht und gesehen werden kann</translation>
    </message>
    <message>
        <source>one cause, or none, by odds of</source>
        <translation>eine Ursache oder keine, Quote</translation>
    </message>
    <message>
        <source>poses, at most</source>
        <translation>Posen, höchstens</translation>
    </message>
    <message>
        <source>time, at most</source>
        <translation>Zeit, höchstens</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>Two corners of a box in the root's frame, x y z x y z in m: where the hand is to be known</source>
        <translation>Zwei Ecken eines Kastens im System der Wurzel, x y z x y z in m: wo die Hand bekannt sein soll</translation>
    </message>
    <message>
        <source>the floor alone</source>
        <translation>nur der Boden</translation>
    </message>
    <message>
        <source>A file cell.xml with what stands about the robot: boxes and planes (docs/experiment.md)</source>
        <translation>Eine Datei cell.xml mit dem, was um den Roboter steht: Kästen und Ebenen (docs/experiment.md)</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>where the hand works</source>
        <translation>wo die Hand arbeitet</translation>
    </message>
    <message>
        <source>what stands about</source>
        <translation>was herumsteht</translation>
    </message>
    <message>
        <source>What stands about the robot</source>
        <translation>Was um den Roboter steht</translation>
    </message>
    <message>
        <source>Cells (*.xml)</source>
        <translation>Zellen (*.xml)</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>The one that is asked whether it still holds; Export writes it</source>
        <translation>Die gefragt wird, ob sie noch gilt; Export schreibt sie</translation>
    </message>
    <message>
        <source>Calibrations (*.xml)</source>
        <translation>Kalibrierungen (*.xml)</translation>
    </message>
    <message>
        <source>calibration.xml, as Export writes it</source>
        <translation>calibration.xml, wie Export sie schreibt</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>A line is added for every observation; recheck --csv writes the same</source>
        <translation>Jede Beobachtung fügt eine Zeile hinzu; recheck --csv schreibt dasselbe</translation>
    </message>
    <message>
        <source>Logs (*.csv)</source>
        <translation>Protokolle (*.csv)</translation>
    </message>
    <message>
        <source>Evidence that something has changed</source>
        <translation>Was dafür spricht, dass sich etwas geändert hat</translation>
    </message>
    <message>
        <source>e-value</source>
        <translation>E-Wert</translation>
    </message>
    <message>
        <source>1000: it has changed</source>
        <translation>1000: es hat sich geändert</translation>
    </message>
    <message>
        <source>Each observation of a recheck is a point here.</source>
        <translation>Jede Beobachtung einer Nachprüfung ist hier ein Punkt.</translation>
    </message>
    <message>
        <source>How each number of mount, hand and joint zeros went, with two sigma.</source>
        <translation>Wie jede Zahl von Halterung, Hand und Gelenknullpunkten lief, mit zwei Sigma.</translation>
    </message>
    <message>
        <source>The number whose history is shown</source>
        <translation>Die Zahl, deren Verlauf gezeigt wird</translation>
    </message>
    <message>
        <source>Reading the log</source>
        <translation>Das Protokoll wird gelesen</translation>
    </message>
    <message>
        <source>Has anything changed since a calibration?</source>
        <translation>Hat sich seit einer Kalibrierung etwas geändert?</translation>
    </message>
    <message>
        <source>Choose the calibration and connect the driver: the robot goes to the five poses that show mount, hand and joint zeros best. It may be asked every hour, for ever: of a robot that has not changed, the chance of ever being told otherwise is 1 in 1000. Keep one session for all rechecks of a calibration.</source>
        <translation>Wähle die Kalibrierung und verbinde den Treiber: der Roboter fährt in die fünf Posen, die Halterung, Hand und Gelenknullpunkte am besten zeigen. Das darf jede Stunde gefragt werden, für immer: bei einem Roboter, der sich nicht geändert hat, ist die Aussicht, je das Gegenteil zu hören, 1 zu 1000. Nimm eine Sitzung für alle Nachprüfungen einer Kalibrierung.</translation>
    </message>
    <message>
        <source>Something has changed: %1.</source>
        <translation>Etwas hat sich geändert: %1.</translation>
    </message>
    <message>
        <source>Nothing speaks for a change.</source>
        <translation>Nichts spricht für eine Änderung.</translation>
    </message>
    <message>
        <source>%1 looked at, the last at %2 UTC; e-value %3, where 1000 would count as a change.</source>
        <translation>%1 angesehen, zuletzt um %2 UTC; E-Wert %3, wo 1000 als Änderung gälte.</translation>
    </message>
    <message>
        <source>The robot stands still as soon as it can (Esc, wherever you are in the window)</source>
        <translation>Der Roboter steht so bald wie möglich still (Esc, wo immer du im Fenster bist)</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>time (s since 1970)</source>
        <translation>Zeit (s seit 1970)</translation>
    </message>
    <message>
        <source>Where the hand works: expected six numbers, x y z x y z of two corners of a box in m.</source>
        <translation>Wo die Hand arbeitet: erwartet werden sechs Zahlen, x y z x y z von zwei Ecken eines Kastens in m.</translation>
    </message>
    <message>
        <source>Choose the calibration that is to be asked whether it still holds; Export writes one.</source>
        <translation>Wähle die Kalibrierung, die gefragt werden soll, ob sie noch gilt; Export schreibt eine.</translation>
    </message>
    <message>
        <source>Say where the log of the rechecks is to be kept: a CSV file.</source>
        <translation>Sage, wo das Protokoll der Nachprüfungen liegen soll: eine CSV-Datei.</translation>
    </message>
    <message>
        <source>handsight-driver-simulated is not found beside this program; install it with Handsight.</source>
        <translation>handsight-driver-simulated ist neben diesem Programm nicht zu finden; installiere es mit Handsight.</translation>
    </message>
    <message>
        <source>95 % limit</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>on its way</source>
        <translation>unterwegs</translation>
    </message>
    <message>
        <source>What was measured is fitted and diagnosed, and the next poses are chosen ...</source>
        <translation>Das Gemessene wird angepasst und untersucht, und die nächsten Posen werden gewählt ...</translation>
    </message>
    <message>
        <source>Connected: %1. These poses come first; nothing has moved.</source>
        <translation>Verbunden: %1. Diese Posen kommen zuerst; nichts hat sich bewegt.</translation>
    </message>
    <message>
        <source>a simulated %1</source>
        <translation>ein simulierter %1</translation>
    </message>
    <message>
        <source>told when it ends</source>
        <translation>wird am Ende gesagt</translation>
    </message>
    <message>
        <source>cannot be predicted</source>
        <translation>lässt sich nicht vorhersagen</translation>
    </message>
    <message>
        <source>implausible</source>
        <translation>unplausibel</translation>
    </message>
    <message>
        <source>whose fault: noise unknown</source>
        <translation>Rauschen unbekannt</translation>
    </message>
    <message>
        <source>Its points say the same in every pose. </source>
        <translation>Seine Punkte sagen in jeder Pose dasselbe. </translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Opening the collection</source>
        <translation>Die Sammlung wird geöffnet</translation>
    </message>
    <message>
        <source>The sessions of a collection are compared by themselves: add the other one to it first.</source>
        <translation>Die Sitzungen einer Sammlung werden untereinander verglichen: Nimm die andere erst in sie auf.</translation>
    </message>
    <message>
        <source>%1 is a collection: open it, and its sessions are compared with each other.</source>
        <translation>%1 ist eine Sammlung: Öffne sie, dann werden ihre Sitzungen miteinander verglichen.</translation>
    </message>
    <message>
        <source>%1 is a calibration, which is compared with one session alone.</source>
        <translation>%1 ist eine Kalibrierung, die mit einer einzigen Sitzung verglichen wird.</translation>
    </message>
    <message>
        <source>Compare with other sessions or a calibration</source>
        <translation>Mit anderen Sitzungen oder einer Kalibrierung vergleichen</translation>
    </message>
    <message>
        <source>Comparing the sessions</source>
        <translation>Die Sitzungen werden verglichen</translation>
    </message>
    <message>
        <source>The sessions of this collection, compared</source>
        <translation>Die Sitzungen dieser Sammlung im Vergleich</translation>
    </message>
    <message>
        <source>In order of time: %1.</source>
        <translation>In der Reihenfolge der Zeit: %1.</translation>
    </message>
    <message>
        <source>What has changed, and what is shared</source>
        <translation>Was sich geändert hat, und was gemeinsam ist</translation>
    </message>
    <message>
        <source>How likely it is; a click on a change shows the plots of two sessions that it lies between</source>
        <translation>Wie wahrscheinlich es ist; ein Klick auf eine Änderung zeigt die Diagramme zweier Sitzungen, zwischen denen sie liegt</translation>
    </message>
    <message>
        <source>likely</source>
        <translation>wahrscheinlich</translation>
    </message>
    <message>
        <source>By how much</source>
        <translation>Um wie viel</translation>
    </message>
    <message>
        <source>By %1 the hand moves by %2 mm in the mean over these poses, at most by %3 mm.</source>
        <translation>Durch %1 bewegt sich die Hand über diese Posen im Mittel um %2 mm, höchstens um %3 mm.</translation>
    </message>
    <message>
        <source>&lt; %1 %</source>
        <translation>&lt; %1 %</translation>
    </message>
    <message>
        <source>%1: %2 | %3</source>
        <translation>%1: %2 | %3</translation>
    </message>
    <message>
        <source>or %1</source>
        <translation>oder %1</translation>
    </message>
    <message>
        <source>%1: the same in all</source>
        <translation>%1: in allen gleich</translation>
    </message>
    <message>
        <source>Plots before:</source>
        <translation>Diagramme vorher:</translation>
    </message>
    <message>
        <source>after:</source>
        <translation>nachher:</translation>
    </message>
    <message>
        <source>Session before</source>
        <translation>Sitzung vorher</translation>
    </message>
    <message>
        <source>Session after</source>
        <translation>Sitzung nachher</translation>
    </message>
    <message>
        <source>to find what is missing</source>
        <translation>um zu finden, was fehlt</translation>
    </message>
    <message>
        <source>It is %1 times the noise from where the model has it. </source>
        <translation>Sie liegt um das %1-fache des Rauschens neben dem Modell. </translation>
    </message>
    <message>
        <source>Estimated together with: %1. The hand is not moved by it: TCP→Body holds without it, too.</source>
        <translation>Zusammen geschätzt mit: %1. Die Hand bewegt das nicht: TCP→Body gilt auch ohne.</translation>
    </message>
    <message>
        <source>The noise is not known: nothing to colour by.</source>
        <translation>Das Rauschen ist nicht bekannt: Es gibt keine Farbskala.</translation>
    </message>
    <message>
        <source>Expect %1 on new poses: so much is left of poses that took no part in choosing the causes, which few poses do by chance, too.</source>
        <translation>Auf neuen Posen sind %1 zu erwarten: So viel bleibt bei Posen, die bei der Wahl der Ursachen nicht mitgeredet haben; wenige Posen wählen auch nach Zufall.</translation>
    </message>
    <message>
        <source>Choosing the causes without a part of the poses</source>
        <translation>Wählt die Ursachen ohne einen Teil der Posen</translation>
    </message>
    <message>
        <source>The noise is not known: a cell's height is its error, the highest %1.</source>
        <translation>Das Rauschen ist nicht bekannt: Die Höhe einer Zelle ist ihr Fehler, die höchste %1.</translation>
    </message>
    <message>
        <source>%1, %2 taken, %3 rejected</source>
        <translation>%1, %2 genommen, %3 verworfen</translation>
    </message>
    <message>
        <source>It has no name in the catalogue: the plot shows the curve that stands for it.</source>
        <translation>Im Katalog hat es keinen Namen: Das Diagramm zeigt die Kurve, die dafür steht.</translation>
    </message>
    <message>
        <source>Over %1 poses like the measured ones the hand is off by %2 mm as commanded (median); corrected angles would not bring it nearer.</source>
        <translation>Über %1 Posen wie die gemessenen liegt die Hand, wie kommandiert, um %2 mm daneben (Median); korrigierte Winkel brächten sie nicht näher.</translation>
    </message>
    <message>
        <source>What is left of every point is shown against the noise, which is not known.</source>
        <translation>Was von jedem Punkt übrig ist, wird am Rauschen gemessen, und das ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The robot feels for the fixture and goes back.</source>
        <translation>Der Roboter ertastet die Aufnahme und fährt zurück.</translation>
    </message>
    <message>
        <source>%1 wherever it can touch (95 %)</source>
        <translation>%1 überall, wo berührt werden kann (95 %)</translation>
    </message>
    <message>
        <source>The robot moves now and feels for its fixtures: %1 at first, the first move at a tenth of %2 rad/s. Is nobody within its reach, and is the emergency stop at hand?</source>
        <translation>Der Roboter bewegt sich jetzt und ertastet seine Aufnahmen: zuerst %1, die erste Bewegung mit einem Zehntel von %2 rad/s. Ist niemand in seiner Reichweite, und ist der Not-Halt zur Hand?</translation>
    </message>
    <message>
        <source>touches %1, %2</source>
        <translation>berührt %1, %2</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message numerus="yes">
        <source>a collection of %n session(s)</source>
        <translation>
            <numerusform>eine Sammlung von %n Sitzung</numerusform>
            <numerusform>eine Sammlung von %n Sitzungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>effects</name>
    <!-- The catalogue: titles, causes, visibility, checks, names of numbers and units. -->
    <message>
        <source>A camera has moved against the first one since the rig was calibrated; of a rig of two the effect is called stereo_rig.</source>
        <translation>Eine Kamera hat sich seit der Kalibrierung des Aufbaus gegen die erste bewegt; bei zwei Kameras heißt der Effekt stereo_rig.</translation>
    </message>
    <message>
        <source>Alone it is the whole geometry, four numbers a joint; a large offset of one joint is better called joint offset.</source>
        <translation>Allein ist es die ganze Geometrie, vier Zahlen je Gelenk; ein großer Versatz eines Gelenks heißt besser Gelenkversatz.</translation>
    </message>
    <message>
        <source>Always a pair of sine and cosine; needs about half a turn of the joint to be told from a scale or an offset.</source>
        <translation>Immer ein Paar aus Sinus und Kosinus; braucht etwa eine halbe Umdrehung, um von Maßstab oder Versatz unterschieden zu werden.</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Getriebespiel</translation>
    </message>
    <message>
        <source>Base elasticity</source>
        <translation>Elastizität der Basis</translation>
    </message>
    <message>
        <source>Base tilt</source>
        <translation>Neigung der Basis</translation>
    </message>
    <message>
        <source>Body slip</source>
        <translation>Körper verrutscht</translation>
    </message>
    <message>
        <source>Calibrate the cameras again with a board.</source>
        <translation>Die Kameras mit einem Brett neu kalibrieren.</translation>
    </message>
    <message>
        <source>Camera intrinsics</source>
        <translation>Kamerakonstanten</translation>
    </message>
    <message>
        <source>Camera mount</source>
        <translation>Sitz der Kameras</translation>
    </message>
    <message>
        <source>Camera moved in its rig</source>
        <translation>Kamera im Aufbau bewegt</translation>
    </message>
    <message>
        <source>Come back to the first pose at the end.</source>
        <translation>Am Ende zur ersten Pose zurückkehren.</translation>
    </message>
    <message>
        <source>Drive the joint to its mechanical stop or mark and read its angle.</source>
        <translation>Das Gelenk an seinen Anschlag oder seine Marke fahren und den Winkel ablesen.</translation>
    </message>
    <message>
        <source>Drive to one pose from above and from below and compare where the hand is.</source>
        <translation>Eine Pose von oben und von unten anfahren und vergleichen, wo die Hand ist.</translation>
    </message>
    <message>
        <source>Encoder eccentricity</source>
        <translation>Geberexzentrizität</translation>
    </message>
    <message>
        <source>Focal lengths and principal points of the cameras are not those of the calibration: the focus was turned, or the lens was knocked.</source>
        <translation>Brennweiten und Bildhauptpunkte der Kameras sind nicht die der Kalibrierung: am Fokus wurde gedreht, oder das Objektiv bekam einen Stoß.</translation>
    </message>
    <message>
        <source>Friction holds the joint back: it stops short on the side that it came from.</source>
        <translation>Reibung hält das Gelenk zurück: es bleibt auf der Seite stehen, von der es kam.</translation>
    </message>
    <message>
        <source>Friction hysteresis</source>
        <translation>Reibungshysterese</translation>
    </message>
    <message>
        <source>From one observation on; needs some observations before and after.</source>
        <translation>Von einer Beobachtung an; braucht einige Beobachtungen davor und danach.</translation>
    </message>
    <message>
        <source>From one observation on; seen in the side lengths of the markers.</source>
        <translation>Von einer Beobachtung an; zu sehen an den Seitenlängen der Marker.</translation>
    </message>
    <message>
        <source>Hang a known mass on the hand and measure by how much it drops: the joints before the coupled one give way too.</source>
        <translation>Eine bekannte Masse an die Hand hängen und messen, wie weit sie sinkt: auch die Gelenke vor dem gekoppelten geben nach.</translation>
    </message>
    <message>
        <source>Hold the arm stretched out, hang a known mass on the hand, and measure by how much the hand drops.</source>
        <translation>Den Arm ausgestreckt halten, eine bekannte Masse an die Hand hängen und messen, wie weit die Hand sinkt.</translation>
    </message>
    <message>
        <source>Hold the hand still and turn the head: the hand must stay where it is.</source>
        <translation>Die Hand stillhalten und den Kopf drehen: die Hand muss bleiben, wo sie ist.</translation>
    </message>
    <message>
        <source>Hold the motor and rock the link by hand in both directions; read the play at the hand.</source>
        <translation>Den Motor halten, das Glied von Hand in beide Richtungen wippen und das Spiel an der Hand ablesen.</translation>
    </message>
    <message>
        <source>Joint coupling</source>
        <translation>Gelenkkopplung</translation>
    </message>
    <message>
        <source>The joint turns a little with another one: a belt, a wrist or a parallelogram passes on a share of that joint's angle, and the controller does not take it back.</source>
        <translation>Das Gelenk dreht ein wenig mit einem anderen mit: ein Riemen, ein Handgelenk oder ein Parallelogramm gibt einen Teil von dessen Winkel weiter, und die Steuerung nimmt ihn nicht zurück.</translation>
    </message>
    <message>
        <source>Needs wide ranges of both joints, which must not go together.</source>
        <translation>Braucht weite Bereiche beider Gelenke, die nicht miteinander gehen dürfen.</translation>
    </message>
    <message>
        <source>Turn the other joint alone over its whole range and watch whether this one turns.</source>
        <translation>Das andere Gelenk allein über seinen ganzen Bereich drehen und darauf achten, ob dieses mitdreht.</translation>
    </message>
    <message>
        <source>Size of the target</source>
        <translation>Größe des Targets</translation>
    </message>
    <message>
        <source>The target was printed larger or smaller than its description says (a printer that fits the page, or a length typed wrong), so that every distance seen is wrong by the same share.</source>
        <translation>Das Target ist größer oder kleiner gedruckt, als seine Beschreibung sagt (ein Drucker, der an die Seite anpasst, oder eine falsch getippte Länge), sodass jeder gesehene Abstand um denselben Anteil falsch ist.</translation>
    </message>
    <message>
        <source>Needs poses at several distances or positions; where the target's points are free it is not needed.</source>
        <translation>Braucht Posen in mehreren Abständen oder an mehreren Orten; wo die Punkte des Targets frei sind, wird sie nicht gebraucht.</translation>
    </message>
    <message>
        <source>Measure the target over its whole length with a ruler and compare with its description.</source>
        <translation>Das Target über seine ganze Länge mit einem Lineal messen und mit seiner Beschreibung vergleichen.</translation>
    </message>
    <message>
        <source>Misplaced tag</source>
        <translation>Versetztes Tag</translation>
    </message>
    <message>
        <source>One tag of a body of several does not lie where its description says: glued on askew, or its place measured or typed wrong.</source>
        <translation>Ein Tag eines Körpers mit mehreren liegt nicht, wo seine Beschreibung es sagt: schief aufgeklebt, oder sein Ort falsch gemessen oder eingetippt.</translation>
    </message>
    <message>
        <source>Seen where the tag and others of the body are in view together, or by turns in many poses; of two tags nothing tells which is the wrong one.</source>
        <translation>Zu sehen, wo das Tag und andere des Körpers zusammen im Bild sind, oder abwechselnd in vielen Posen; bei zwei Tags sagt nichts, welches das falsche ist.</translation>
    </message>
    <message>
        <source>Measure the tag's distance from the edges of what it is fastened to, and from its neighbours.</source>
        <translation>Den Abstand des Tags von den Kanten dessen messen, worauf es sitzt, und von seinen Nachbarn.</translation>
    </message>
    <message>
        <source>Bent target</source>
        <translation>Gewölbtes Target</translation>
    </message>
    <message>
        <source>A target that is described as flat is bent, as paper or a thin plate is: its edges stand off.</source>
        <translation>Ein Target, das als eben beschrieben ist, ist gewölbt, wie Papier oder eine dünne Platte es ist: seine Ränder stehen ab.</translation>
    </message>
    <message>
        <source>Seen in the shape of the target where it is large in the image; small ones look flat.</source>
        <translation>Zu sehen an der Form des Targets, wo es groß im Bild ist; kleine sehen eben aus.</translation>
    </message>
    <message>
        <source>Lay a ruler over the target, along and across, and look for light under it.</source>
        <translation>Ein Lineal längs und quer über das Target legen und darunter nach Licht sehen.</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>joints before it</source>
        <translation>Gelenke davor</translation>
    </message>
    <message>
        <source>bend_x</source>
        <translation>Wölbung längs x</translation>
    </message>
    <message>
        <source>bend_y</source>
        <translation>Wölbung längs y</translation>
    </message>
    <message>
        <source>Joint elasticity</source>
        <translation>Gelenkelastizität</translation>
    </message>
    <message>
        <source>Joint offset</source>
        <translation>Gelenkversatz</translation>
    </message>
    <message>
        <source>Joint scale</source>
        <translation>Gelenkmaßstab</translation>
    </message>
    <message>
        <source>Lateral elasticity</source>
        <translation>Querelastizität</translation>
    </message>
    <message>
        <source>Lay a spirit level on the robot's base.</source>
        <translation>Eine Wasserwaage auf die Basis des Roboters legen.</translation>
    </message>
    <message>
        <source>Lens distortion</source>
        <translation>Verzeichnung</translation>
    </message>
    <message>
        <source>Link geometry</source>
        <translation>Gliedgeometrie</translation>
    </message>
    <message>
        <source>Look at a straight edge near the border of the undistorted image.</source>
        <translation>Eine gerade Kante nahe am Rand des entzerrten Bildes ansehen.</translation>
    </message>
    <message>
        <source>Look at something that stands still before and after, or measure the first pose again.</source>
        <translation>Davor und danach etwas ansehen, das stillsteht, oder die erste Pose noch einmal messen.</translation>
    </message>
    <message>
        <source>Look at the epipolar distances of any matched points: they ought to be zero.</source>
        <translation>Die Epipolarabstände beliebiger Punktpaare ansehen: sie sollten null sein.</translation>
    </message>
    <message>
        <source>Look whether the markers still sit where they were glued.</source>
        <translation>Nachsehen, ob die Marker noch sitzen, wo sie aufgeklebt wurden.</translation>
    </message>
    <message>
        <source>Marker slip</source>
        <translation>Marker verrutscht</translation>
    </message>
    <message>
        <source>Measure the axis with a dial gauge or a tracker while only this joint turns.</source>
        <translation>Die Achse mit Messuhr oder Tracker vermessen, während nur dieses Gelenk dreht.</translation>
    </message>
    <message>
        <source>Mimic error</source>
        <translation>Mitnehmerfehler</translation>
    </message>
    <message>
        <source>Mimic linkage</source>
        <translation>Mitnehmergestänge</translation>
    </message>
    <message>
        <source>Mount drift</source>
        <translation>Drift des Kamerasitzes</translation>
    </message>
    <message>
        <source>Mount slip</source>
        <translation>Sprung des Kamerasitzes</translation>
    </message>
    <message>
        <source>Move the followed joints through their range and lay a level on the link that ought to keep its direction.</source>
        <translation>Die mitgenommenen Gelenke durch ihren Bereich bewegen und eine Wasserwaage auf das Glied legen, das seine Richtung behalten soll.</translation>
    </message>
    <message>
        <source>Near to the principal points; needs a range of depth and the corners of the images.</source>
        <translation>Nahe an den Bildhauptpunkten; braucht einen Bereich der Tiefe und die Ecken der Bilder.</translation>
    </message>
    <message>
        <source>Needs a quarter turn or more; other orders only where they are asked for.</source>
        <translation>Braucht eine Vierteldrehung oder mehr; andere Ordnungen nur, wo nach ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>Needs a wide range of the angle; over a small range an eccentric encoder looks alike.</source>
        <translation>Braucht einen weiten Bereich des Winkels; über einen kleinen sieht ein exzentrischer Geber gleich aus.</translation>
    </message>
    <message>
        <source>Needs joint velocities; poses at rest cannot show it.</source>
        <translation>Braucht Gelenkgeschwindigkeiten; Posen in Ruhe können es nicht zeigen.</translation>
    </message>
    <message>
        <source>Needs markers far from the images' middle.</source>
        <translation>Braucht Marker fern der Bildmitten.</translation>
    </message>
    <message>
        <source>Needs the range of depth and the corners of the images.</source>
        <translation>Braucht den Bereich der Tiefe und die Ecken der Bilder.</translation>
    </message>
    <message>
        <source>Not apart from the body when hand and cameras never turn against each other; not needed where the mount is estimated anyway.</source>
        <translation>Nicht vom Körper zu trennen, wenn Hand und Kameras sich nie gegeneinander drehen; nicht nötig, wo der Sitz ohnehin geschätzt wird.</translation>
    </message>
    <message>
        <source>Not where head and arm both hang behind the coupled joint, but for gravity.</source>
        <translation>Nicht, wo Kopf und Arm beide hinter dem gekoppelten Gelenk hängen, außer durch die Schwerkraft.</translation>
    </message>
    <message>
        <source>Not where the torque never changes its sign: there it is an offset.</source>
        <translation>Nicht, wo das Moment sein Vorzeichen nie wechselt: dort ist es ein Versatz.</translation>
    </message>
    <message>
        <source>One marker came loose and moved on the hand.</source>
        <translation>Ein Marker löste sich und bewegte sich auf der Hand.</translation>
    </message>
    <message>
        <source>Only the part across the axes on both sides of the joint is its own; along the axis it is joint elasticity.</source>
        <translation>Nur der Teil quer zu den Achsen auf beiden Seiten des Gelenks ist sein eigener; längs der Achse ist es Gelenkelastizität.</translation>
    </message>
    <message>
        <source>Only through elasticity. Wrong names imitate it: nonlinear springs, a centre of mass, a scale, a ratio.</source>
        <translation>Nur über Elastizität. Falsche Namen ahmen es nach: nichtlineare Federn, ein Schwerpunkt, ein Maßstab, ein Verhältnis.</translation>
    </message>
    <message>
        <source>Only through elasticity: in a model without springs it cannot be seen.</source>
        <translation>Nur über Elastizität: in einem Modell ohne Federn ist es nicht zu sehen.</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Traglast</translation>
    </message>
    <message>
        <source>Poses must be approached from both sides.</source>
        <translation>Posen müssen von beiden Seiten angefahren werden.</translation>
    </message>
    <message>
        <source>Press the marker down and compare its distances to the others.</source>
        <translation>Den Marker andrücken und seine Abstände zu den anderen vergleichen.</translation>
    </message>
    <message>
        <source>Seen only by a camera or a tracker that does not ride on the robot.</source>
        <translation>Nur von einer Kamera oder einem Tracker zu sehen, der nicht auf dem Roboter mitfährt.</translation>
    </message>
    <message>
        <source>Seen where the joint moves the hand against the cameras; not where it only turns the body (wrist roll) or the camera (head tilt) as a whole.</source>
        <translation>Zu sehen, wo das Gelenk die Hand gegen die Kameras bewegt; nicht, wo es nur den Körper (Rollen des Handgelenks) oder die Kamera (Neigen des Kopfes) als Ganzes dreht.</translation>
    </message>
    <message>
        <source>Seen where the joint's gravity torque changes between poses; not at joints without torque. A link's torsion along the joint's axis is the same term.</source>
        <translation>Zu sehen, wo sich das Schweremoment des Gelenks zwischen den Posen ändert; nicht an Gelenken ohne Moment. Die Torsion eines Glieds längs der Gelenkachse ist derselbe Term.</translation>
    </message>
    <message>
        <source>Stereo rig</source>
        <translation>Stereoaufbau</translation>
    </message>
    <message>
        <source>Stop the arm before each image: the error must vanish.</source>
        <translation>Den Arm vor jedem Bild anhalten: der Fehler muss verschwinden.</translation>
    </message>
    <message>
        <source>Stretch the arm out, hang a known mass on the hand, and measure by how much the hand drops.</source>
        <translation>Den Arm ausstrecken, eine bekannte Masse an die Hand hängen und messen, wie weit die Hand sinkt.</translation>
    </message>
    <message>
        <source>Stretch the arm to one side, hang a known mass on the hand, and measure by how much the hand drops.</source>
        <translation>Den Arm zur Seite ausstrecken, eine bekannte Masse an die Hand hängen und messen, wie weit die Hand sinkt.</translation>
    </message>
    <message>
        <source>The angle sensor counts a little too much or too little per turn, so that the error grows with the angle.</source>
        <translation>Der Winkelgeber zählt je Umdrehung etwas zu viel oder zu wenig, sodass der Fehler mit dem Winkel wächst.</translation>
    </message>
    <message>
        <source>The angle sensor reads the same amount too much or too little in every pose: a zero position that was set a little wrong.</source>
        <translation>Der Winkelgeber liest in jeder Pose um denselben Betrag zu viel oder zu wenig: eine Nulllage, die etwas falsch gesetzt wurde.</translation>
    </message>
    <message>
        <source>Joint offset changed between sessions</source>
        <translation>Gelenkversatz zwischen Sitzungen geändert</translation>
    </message>
    <message>
        <source>In one session this is another than in the others. The angle sensor reads the same amount too much or too little in every pose: a zero position that was set a little wrong.</source>
        <translation>In einer Sitzung ist dies anders als in den anderen. Der Winkelgeber liest in jeder Pose um denselben Betrag zu viel oder zu wenig: eine Nulllage, die etwas falsch gesetzt wurde.</translation>
    </message>
    <message>
        <source>Needs a session before and one after the change. Seen where the joint moves the hand against the cameras; not where it only turns the body (wrist roll) or the camera (head tilt) as a whole.</source>
        <translation>Braucht eine Sitzung vor und eine nach der Änderung. Zu sehen, wo das Gelenk die Hand gegen die Kameras bewegt; nicht, wo es nur den Körper (Rollen des Handgelenks) oder die Kamera (Neigen des Kopfes) als Ganzes dreht.</translation>
    </message>
    <message>
        <source>The bearing, the housing or the link behind the joint bends across the axis under the moment of gravity: transversal elasticity.</source>
        <translation>Das Lager, das Gehäuse oder das Glied hinter dem Gelenk biegt sich quer zur Achse unter dem Moment der Schwerkraft: transversale Elastizität.</translation>
    </message>
    <message>
        <source>The cameras (or the tracker) sit on their link a little beside and turned against where the model has them.</source>
        <translation>Die Kameras (oder der Tracker) sitzen an ihrem Glied etwas neben und verdreht gegen die Stelle, an der das Modell sie hat.</translation>
    </message>
    <message>
        <source>The cameras move slowly against their link while the session lasts: warming up, or a screw that gives way.</source>
        <translation>Die Kameras wandern langsam gegen ihr Glied, solange die Sitzung dauert: sie werden warm, oder eine Schraube gibt nach.</translation>
    </message>
    <message>
        <source>The cameras or the tracker, their stand, or a fixture jumped at some moment: something knocked it or came loose.</source>
        <translation>Die Kameras oder der Tracker, ihr Stativ oder eine Halterung sprangen irgendwann: etwas stieß dagegen oder löste sich.</translation>
    </message>
    <message>
        <source>The distortion of the lenses is not that of the calibration.</source>
        <translation>Die Verzeichnung der Objektive ist nicht die der Kalibrierung.</translation>
    </message>
    <message>
        <source>The encoder's disc is not centred on the axis: the error swings once per turn.</source>
        <translation>Die Scheibe des Winkelgebers sitzt nicht mittig auf der Achse: der Fehler schwingt einmal je Umdrehung.</translation>
    </message>
    <message>
        <source>The gear does not turn evenly: the error swings twice per turn of the joint, as a harmonic drive does.</source>
        <translation>Das Getriebe läuft nicht gleichmäßig: der Fehler schwingt zweimal je Umdrehung des Gelenks, wie bei einem Wellgetriebe.</translation>
    </message>
    <message>
        <source>The gear has play: the joint rests on one flank or the other, depending on the sign of gravity's torque.</source>
        <translation>Das Getriebe hat Spiel: das Gelenk liegt an der einen oder der anderen Flanke an, je nach Vorzeichen des Schweremoments.</translation>
    </message>
    <message>
        <source>The hand carries a mass that the model does not know, or its centre of mass is elsewhere: the springs are loaded differently.</source>
        <translation>Die Hand trägt eine Masse, die das Modell nicht kennt, oder ihr Schwerpunkt liegt anderswo: die Federn sind anders belastet.</translation>
    </message>
    <message>
        <source>The joint angles belong to another instant than the images: while the arm moves it is already elsewhere.</source>
        <translation>Die Gelenkwinkel gehören zu einem anderen Augenblick als die Bilder: während der Arm sich bewegt, ist er schon anderswo.</translation>
    </message>
    <message>
        <source>The joint does not sit quite where the drawing puts it: its axis is shifted and tilted a little against the link before it.</source>
        <translation>Das Gelenk sitzt nicht ganz, wo die Zeichnung es hat: seine Achse ist gegen das Glied davor etwas verschoben und gekippt.</translation>
    </message>
    <message>
        <source>The joint is a spring: its gear, its torque sensor or its controller gives way to the moment of gravity about its axis, on top of the declared stiffness. The angle sensor sits on the motor's side and does not see it.</source>
        <translation>Das Gelenk ist eine Feder: Getriebe, Drehmomentsensor oder Regler geben der Schwerkraft nach, mehr als die angegebene Steifigkeit sagt. Der Winkelgeber am Motor sieht es nicht.</translation>
    </message>
    <message>
        <source>The joint that follows others does so in a slightly other ratio, or from another zero.</source>
        <translation>Das Gelenk, das anderen folgt, tut es in einem etwas anderen Verhältnis oder von einer anderen Nulllage aus.</translation>
    </message>
    <message>
        <source>The joint that follows others is held by a tendon or a parallel linkage, not by the motors before it: its load pulls at the joints that it follows, and their deflection moves it.</source>
        <translation>Das Gelenk, das anderen folgt, wird von einer Sehne oder einem Parallelgestänge gehalten, nicht von den Motoren davor: seine Last zieht an den Gelenken, denen es folgt, und deren Nachgeben bewegt es.</translation>
    </message>
    <message>
        <source>The marker body moved on the hand at some moment: something knocked it.</source>
        <translation>Der Markerkörper bewegte sich irgendwann auf der Hand: etwas stieß dagegen.</translation>
    </message>
    <message>
        <source>The order of the poses must not follow their posture.</source>
        <translation>Die Reihenfolge der Posen darf nicht ihrer Haltung folgen.</translation>
    </message>
    <message>
        <source>The right camera has moved against the left one since the stereo calibration.</source>
        <translation>Die rechte Kamera hat sich seit der Stereokalibrierung gegen die linke bewegt.</translation>
    </message>
    <message>
        <source>The robot does not stand level: gravity comes from another direction than the model says.</source>
        <translation>Der Roboter steht nicht waagerecht: die Schwerkraft kommt aus einer anderen Richtung, als das Modell sagt.</translation>
    </message>
    <message>
        <source>The robot's foot gives way: the whole robot tips with the moment of gravity about its base.</source>
        <translation>Der Fuß des Roboters gibt nach: der ganze Roboter kippt mit dem Moment der Schwerkraft um seine Basis.</translation>
    </message>
    <message>
        <source>Time lag</source>
        <translation>Zeitversatz</translation>
    </message>
    <message>
        <source>Transmission ripple</source>
        <translation>Getriebewelligkeit</translation>
    </message>
    <message>
        <source>Turn the joint by a full turn against an index table.</source>
        <translation>Das Gelenk eine volle Umdrehung gegen einen Teilapparat drehen.</translation>
    </message>
    <message>
        <source>Turn the joint over its whole range between two marks of known angle.</source>
        <translation>Das Gelenk über seinen ganzen Bereich zwischen zwei Marken mit bekanntem Winkel drehen.</translation>
    </message>
    <message>
        <source>Turn the joint slowly by a full turn and compare motor and joint angle.</source>
        <translation>Das Gelenk langsam eine volle Umdrehung drehen und Motor- mit Gelenkwinkel vergleichen.</translation>
    </message>
    <message>
        <source>Weigh the hand with everything on it.</source>
        <translation>Die Hand mit allem, was daran ist, wiegen.</translation>
    </message>
    <message>
        <source>compliance</source>
        <translation>Nachgiebigkeit</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>Kosinus</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>Verzug</translation>
    </message>
    <message>
        <source>left_cx</source>
        <translation>links cx</translation>
    </message>
    <message>
        <source>left_cy</source>
        <translation>links cy</translation>
    </message>
    <message>
        <source>left_fx</source>
        <translation>links fx</translation>
    </message>
    <message>
        <source>left_fy</source>
        <translation>links fy</translation>
    </message>
    <message>
        <source>left_k1</source>
        <translation>links k1</translation>
    </message>
    <message>
        <source>left_k2</source>
        <translation>links k2</translation>
    </message>
    <message>
        <source>left_p1</source>
        <translation>links p1</translation>
    </message>
    <message>
        <source>left_p2</source>
        <translation>links p2</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>moment_x</source>
        <translation>Moment x</translation>
    </message>
    <message>
        <source>moment_y</source>
        <translation>Moment y</translation>
    </message>
    <message>
        <source>moment_z</source>
        <translation>Moment z</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>right_cx</source>
        <translation>rechts cx</translation>
    </message>
    <message>
        <source>right_cy</source>
        <translation>rechts cy</translation>
    </message>
    <message>
        <source>right_fx</source>
        <translation>rechts fx</translation>
    </message>
    <message>
        <source>right_fy</source>
        <translation>rechts fy</translation>
    </message>
    <message>
        <source>right_k1</source>
        <translation>rechts k1</translation>
    </message>
    <message>
        <source>right_k2</source>
        <translation>rechts k2</translation>
    </message>
    <message>
        <source>right_p1</source>
        <translation>rechts p1</translation>
    </message>
    <message>
        <source>right_p2</source>
        <translation>rechts p2</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>settling</source>
        <translation>Einlaufen</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>share of the session</source>
        <translation>Anteil der Sitzung</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>bow</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
</context>
<context>
    <name>core</name>
    <!-- Sentences of the core: %1 and so on stand for whatever is put in. -->
    <message>
        <source>A URDF cannot say %1; it is named in the file's comment.</source>
        <translation>Ein URDF kann %1 nicht sagen; es steht im Kommentar der Datei.</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>What this kind of file cannot hold was left out and the rest fitted again without it: over the %1 poses of the session the hand is %2 mm rms and %3 mm at most from where the whole calibration has it; without calibration it is %4 mm rms.</source>
        <translation>Was diese Art von Datei nicht fassen kann, ist weggelassen und der Rest ohne es neu geschätzt: über die %1 Posen der Sitzung ist die Hand im quadratischen Mittel %2 mm und höchstens %3 mm von dort, wo die ganze Kalibrierung sie hat; ohne Kalibrierung sind es %4 mm.</translation>
    </message>
    <message>
        <source>What this kind of file cannot hold was left out and the rest fitted again without it: over %1 poses drawn within the joints' limits, for the calibration does not say where it was measured, the hand is %2 mm rms and %3 mm at most from where the whole calibration has it; without calibration it is %4 mm rms.</source>
        <translation>Was diese Art von Datei nicht fassen kann, ist weggelassen und der Rest ohne es neu geschätzt: über %1 Posen, gezogen in den Grenzen der Gelenke, denn die Kalibrierung sagt nicht, wo gemessen wurde, ist die Hand im quadratischen Mittel %2 mm und höchstens %3 mm von dort, wo die ganze Kalibrierung sie hat; ohne Kalibrierung sind es %4 mm.</translation>
    </message>
    <message>
        <source>SDFormat 1.7 has no joint that follows others: %1 moves by itself in the file, command it as well.</source>
        <translation>SDFormat 1.7 hat kein Gelenk, das anderen folgt: %1 bewegt sich in der Datei allein, es muss mit befohlen werden.</translation>
    </message>
    <message>
        <source>MuJoCo has no equality for %1, which follows %2 joints: set it from your program.</source>
        <translation>MuJoCo hat keine Gleichung für %1, das %2 Gelenken folgt: im eigenen Programm setzen.</translation>
    </message>
    <message>
        <source>%1 meshes were not found beside the robot; the file names them as the URDF does.</source>
        <translation>%1 Netze lagen nicht neben dem Roboter; die Datei nennt sie wie das URDF.</translation>
    </message>
    <message>
        <source>%1 meshes are not in the file: they are not beside the robot, or of a kind that MuJoCo does not open (it reads OBJ and binary STL).</source>
        <translation>%1 Netze sind nicht in der Datei: sie liegen nicht neben dem Roboter oder sind von einer Art, die MuJoCo nicht öffnet (es liest OBJ und binäres STL).</translation>
    </message>
    <message>
        <source>about %1 to one</source>
        <translation>etwa %1 zu eins</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>homing_offset is what is to be added to that of your arm, and the other numbers are those of a motor that reads a whole turn; name the arm's own calibration with --lerobot to have it changed.</source>
        <translation>homing_offset ist, was zu dem des Arms zu addieren ist, und die anderen Zahlen sind die eines Motors, der eine ganze Umdrehung liest; mit --lerobot wird die eigene Kalibrierung des Arms geändert.</translation>
    </message>
    <message>
        <source>The signs are those of Feetech's motors (SO-100, SO-101); Dynamixel's add homing_offset where these subtract it.</source>
        <translation>Die Vorzeichen sind die von Feetechs Motoren (SO-100, SO-101); die von Dynamixel addieren homing_offset, wo diese es abziehen.</translation>
    </message>
    <message>
        <source>the markers as a whole are more than %1 mm from where they must be</source>
        <translation>die Marker als Ganzes liegen mehr als %1 mm neben der Stelle, an der sie sein müssen</translation>
    </message>
    <message>
        <source>the markers as a whole are turned by more than %1 deg from how they must lie</source>
        <translation>die Marker als Ganzes sind um mehr als %1 Grad gegen die Lage verdreht, in der sie sein müssen</translation>
    </message>
    <message>
        <source>tracker</source>
        <translation>Tracker</translation>
    </message>
    <message>
        <source>ur_calibration is for robots with UR's six joints, and this one has no joint %1; export as urdf or dh.</source>
        <translation>ur_calibration ist für Roboter mit den sechs Gelenken von UR, und dieser hat kein Gelenk %1; als urdf oder dh exportieren.</translation>
    </message>
    <message>
        <source>No observation shows where the hand was: three markers, or points of a tracker, are needed for a certificate.</source>
        <translation>Keine Beobachtung zeigt, wo die Hand war: ein Zertifikat braucht drei Marker oder Punkte eines Trackers.</translation>
    </message>
    <message>
        <source>A certificate needs ten used observations in different poses, so that some can be held out; the session has %1. Record more.</source>
        <translation>Ein Zertifikat braucht zehn benutzte Beobachtungen in verschiedenen Posen, damit einige zurückgehalten werden können; die Sitzung hat %1. Mehr aufnehmen.</translation>
    </message>
    <message>
        <source>Joint %1 counts the other way than the robot's description says.</source>
        <translation>Gelenk %1 zählt andersherum, als die Beschreibung des Roboters sagt.</translation>
    </message>
    <message>
        <source>Turn the sign of the readings of %1 in %2 (or, where the description is wrong, its &lt;axis&gt; in %3).</source>
        <translation>Das Vorzeichen der Messungen von %1 in %2 umkehren (oder, wo die Beschreibung falsch ist, seine &lt;axis&gt; in %3).</translation>
    </message>
    <message>
        <source>The readings of joints %1 and %2 are exchanged.</source>
        <translation>Die Messungen der Gelenke %1 und %2 sind vertauscht.</translation>
    </message>
    <message>
        <source>Exchange the names %1 and %2 in &lt;joints&gt; of %3 (in the header of the table that it was made of).</source>
        <translation>Die Namen %1 und %2 in &lt;joints&gt; von %3 vertauschen (im Kopf der Tabelle, aus der sie gemacht wurde).</translation>
    </message>
    <message>
        <source>Joint %1 has another zero than the robot's description: %2 are missing in its readings.</source>
        <translation>Gelenk %1 hat eine andere Null als die Beschreibung des Roboters: in seinen Messungen fehlen %2.</translation>
    </message>
    <message>
        <source>Add %1 to the readings of %2 in %3 (or set the zero of that joint so).</source>
        <translation>%1 zu den Messungen von %2 in %3 hinzuzählen (oder die Null dieses Gelenks so setzen).</translation>
    </message>
    <message>
        <source>Joint %1 is in degrees, where radians are expected.</source>
        <translation>Gelenk %1 ist in Grad, wo Bogenmaß erwartet wird.</translation>
    </message>
    <message>
        <source>Write the readings of %1 in %2 in radians (times pi / 180).</source>
        <translation>Die Messungen von %1 in %2 in Bogenmaß schreiben (mal pi / 180).</translation>
    </message>
    <message>
        <source>The images of %1 are mirrored: left and right are exchanged.</source>
        <translation>Die Bilder von %1 sind gespiegelt: links und rechts sind vertauscht.</translation>
    </message>
    <message>
        <source>The images of %1 are mirrored: top and bottom are exchanged.</source>
        <translation>Die Bilder von %1 sind gespiegelt: oben und unten sind vertauscht.</translation>
    </message>
    <message>
        <source>The images of %1 stand upside down against how the camera was calibrated.</source>
        <translation>Die Bilder von %1 stehen kopf gegenüber denen, mit denen die Kamera kalibriert wurde.</translation>
    </message>
    <message>
        <source>The images of %1 are turned by 90 degrees to the right against how the camera was calibrated.</source>
        <translation>Die Bilder von %1 sind um 90 Grad nach rechts gedreht gegenüber denen, mit denen die Kamera kalibriert wurde.</translation>
    </message>
    <message>
        <source>The images of %1 are turned by 90 degrees to the left against how the camera was calibrated.</source>
        <translation>Die Bilder von %1 sind um 90 Grad nach links gedreht gegenüber denen, mit denen die Kamera kalibriert wurde.</translation>
    </message>
    <message>
        <source>Take the images as the camera delivers them (look for flip, mirror or rotate in the driver), or calibrate the camera with images as those of %1.</source>
        <translation>Die Bilder so nehmen, wie die Kamera sie liefert (im Treiber nach flip, mirror oder rotate sehen), oder die Kamera mit Bildern wie denen von %1 kalibrieren.</translation>
    </message>
    <message>
        <source>Width and height of the images of %1 are exchanged.</source>
        <translation>Breite und Höhe der Bilder von %1 sind vertauscht.</translation>
    </message>
    <message>
        <source>Write width="%1" height="%2" cx="%3" cy="%4" into &lt;camera&gt; of %5.</source>
        <translation>width="%1" height="%2" cx="%3" cy="%4" in &lt;camera&gt; von %5 schreiben.</translation>
    </message>
    <message>
        <source>Gravity does not pull as the session says, but along %1 of the robot's root link.</source>
        <translation>Die Schwerkraft zieht nicht, wie die Sitzung sagt, sondern entlang %1 des Wurzelglieds des Roboters.</translation>
    </message>
    <message>
        <source>Write &lt;gravity xyz="%1"/&gt; into %2.</source>
        <translation>&lt;gravity xyz="%1"/&gt; in %2 schreiben.</translation>
    </message>
    <message>
        <source>ArUco grid board of %1 x %2 tags of %3, %4 apart, from %5</source>
        <translation>ArUco-Gitterbrett mit %1 × %2 Tags von %3, Abstand %4, aus %5</translation>
    </message>
    <message>
        <source>The images of the cameras %1 and %2 are exchanged.</source>
        <translation>Die Bilder der Kameras %1 und %2 sind vertauscht.</translation>
    </message>
    <message>
        <source>Exchange %1 and %2 in &lt;images&gt; and &lt;marker&gt; of every observation of %3 (or exchange the cameras of the calibration).</source>
        <translation>%1 und %2 in &lt;images&gt; und &lt;marker&gt; jeder Beobachtung von %3 vertauschen (oder die Kameras der Kalibrierung).</translation>
    </message>
    <message>
        <source>Columns and rows of the board are exchanged: it has %1 columns and %2 rows.</source>
        <translation>Spalten und Zeilen des Bretts sind vertauscht: es hat %1 Spalten und %2 Zeilen.</translation>
    </message>
    <message>
        <source>Write columns="%1" rows="%2" into &lt;target&gt; of %3.</source>
        <translation>columns="%1" rows="%2" in &lt;target&gt; von %3 schreiben.</translation>
    </message>
    <message>
        <source>Invert each &lt;target_pose&gt; in %1 (each pose in the table of the target that it was made of).</source>
        <translation>Jede &lt;target_pose&gt; in %1 umkehren (jede Pose in der Tabelle des Musters, aus der sie gemacht wurde).</translation>
    </message>
    <message>
        <source>%1 does not part these from the rest.</source>
        <translation>%1 trennt diese nicht von den übrigen.</translation>
    </message>
    <message>
        <source>%1 of %2 joint positions are beyond a whole turn (up to %3 rad): are they in degrees?</source>
        <translation>%1 von %2 Gelenkwinkeln liegen jenseits einer ganzen Umdrehung (bis %3 rad): sind es Grad?</translation>
    </message>
    <message>
        <source>The %1 camera sees %2 degrees across (fx %3 px, %4 px wide): is fx in px?</source>
        <translation>Kamera %1 sieht %2 Grad in der Breite (fx %3 px, %4 px breit): ist fx in px?</translation>
    </message>
    <message>
        <source>The %1 camera's fx %2 and fy %3 are far from each other.</source>
        <translation>fx %2 und fy %3 der Kamera %1 liegen weit auseinander.</translation>
    </message>
    <message>
        <source>The %1 camera's principal point %2, %3 lies outside of its image.</source>
        <translation>Der Hauptpunkt %2, %3 der Kamera %1 liegt außerhalb ihres Bildes.</translation>
    </message>
    <message>
        <source>In %1 of %2 sightings the %3 point is the %4 one: is one column copied?</source>
        <translation>In %1 von %2 Sichtungen ist der Punkt %3 der Punkt %4: ist eine Spalte kopiert?</translation>
    </message>
    <message>
        <source>In %1 observations the %2 image is the %3 one.</source>
        <translation>In %1 Beobachtungen ist das Bild %2 das Bild %3.</translation>
    </message>
    <message>
        <source>The cameras are %1 m apart: is right_from_left in m?</source>
        <translation>Die Kameras sind %1 m auseinander: ist right_from_left in m?</translation>
    </message>
    <message>
        <source>The cameras %1 and %2 are %3 m apart: is from_first in m?</source>
        <translation>Die Kameras %1 und %2 sind %3 m auseinander: ist from_first in m?</translation>
    </message>
    <message>
        <source>Gravity is %1 m/s^2; on Earth it is 9.78 to 9.83.</source>
        <translation>Die Schwerkraft ist %1 m/s^2; auf der Erde ist sie 9.78 bis 9.83.</translation>
    </message>
    <message>
        <source>%1 px further %2</source>
        <translation>%1 px weiter %2</translation>
    </message>
    <message>
        <source>%1 sigma from the prediction</source>
        <translation>%1 Sigma von der Vorhersage</translation>
    </message>
    <message>
        <source>%1 usable observations leave %2 degrees of freedom beside %3 parameters; a diagnosis needs at least 10 observations and twice as many degrees of freedom as parameters: measure more poses.</source>
        <translation>%1 brauchbare Beobachtungen lassen %2 Freiheitsgrade neben %3 Parametern; eine Diagnose braucht mindestens 10 Beobachtungen und doppelt so viele Freiheitsgrade wie Parameter: miss mehr Posen.</translation>
    </message>
    <message>
        <source>%1 (pose %2)</source>
        <translation>%1 (Pose %2)</translation>
    </message>
    <message>
        <source>%1, moved from %2 to %3 mm, moves</source>
        <translation>%1, von %2 auf %3 mm bewegt, bewegt sich</translation>
    </message>
    <message>
        <source>%1, turned from %2 to %3 degrees, turns</source>
        <translation>%1, von %2 auf %3 Grad gedreht, dreht sich</translation>
    </message>
    <message>
        <source>Hang 1 kg on the hand: it should sag</source>
        <translation>Hänge 1 kg an die Hand: sie sollte</translation>
    </message>
    <message>
        <source>Inside: %1, but so would nothing be. The check was too coarse to tell.</source>
        <translation>Innerhalb: %1, aber das wäre auch nichts. Die Prüfung war zu grob, um es zu sagen.</translation>
    </message>
    <message>
        <source>Inside: %1. That speaks for this cause.</source>
        <translation>Innerhalb: %1. Das spricht für diese Ursache.</translation>
    </message>
    <message>
        <source>Joint %1 stands at %2 rad, which is %3 turns: are the angles degrees? Sessions hold rad.</source>
        <translation>Gelenk %1 steht auf %2 rad, das sind %3 Umdrehungen: sind die Winkel in Grad? Sitzungen enthalten rad.</translation>
    </message>
    <message>
        <source>Marker %1, %2 image, %3.</source>
        <translation>Marker %1, Bild %2, %3.</translation>
    </message>
    <message>
        <source>Marker %1, %2 mm from its place on the body: loose, hidden in part, or another corner.</source>
        <translation>Marker %1, %2 mm neben seiner Stelle auf dem Körper: lose, teils verdeckt oder eine andere Ecke.</translation>
    </message>
    <message>
        <source>No link of the robot has a mass: what gravity does to it cannot be told. Give the masses in the robot's file.</source>
        <translation>Kein Glied des Roboters hat eine Masse: was die Schwerkraft mit ihm macht, ist nicht zu sagen. Gib die Massen in der Datei des Roboters an.</translation>
    </message>
    <message>
        <source>Of %1 markers %2 %3 never seen: count="%4" in session.xml is enough, or labels are missing.</source>
        <translation>Von %1 Markern nie zu sehen: %2; count="%4" in session.xml genügt, oder Markierungen fehlen.</translation>
    </message>
    <message>
        <source>Outside: %1, and nothing shows. That speaks against this cause.</source>
        <translation>Außerhalb: %1, und nichts zeigt sich. Das spricht gegen diese Ursache.</translation>
    </message>
    <message>
        <source>Outside: %1. It is another cause, or not this one alone.</source>
        <translation>Außerhalb: %1. Es ist eine andere Ursache, oder nicht diese allein.</translation>
    </message>
    <message>
        <source>The %1 images do not fit together (%2 px across the epipolar lines): not taken at the same instant, or several wrong corners.</source>
        <translation>Die Bilder passen nicht zusammen (%2 px quer zu den Epipolarlinien): nicht im selben Augenblick aufgenommen, oder mehrere falsche Ecken.</translation>
    </message>
    <message>
        <source>The hand is</source>
        <translation>Die Hand liegt</translation>
    </message>
    <message>
        <source>The hand moves by</source>
        <translation>Die Hand bewegt sich um</translation>
    </message>
    <message>
        <source>The marker body would be %1 m from the TCP: look whether the TCP is the hand's link, and whether lengths are m.</source>
        <translation>Der Markerkörper wäre %1 m vom TCP entfernt: sieh nach, ob der TCP das Glied der Hand ist und ob Längen in m sind.</translation>
    </message>
    <message>
        <source>The markers do not lie to each other as on the other images (%1 %2): several are wrong, or the body is bent.</source>
        <translation>Die Marker liegen nicht zueinander wie in den anderen Bildern (%1 %2): mehrere sind falsch, oder der Körper ist verbogen.</translation>
    </message>
    <message>
        <source>The whole hand, %1 mm and %2 deg from where the robot says.</source>
        <translation>die ganze Hand, %1 mm und %2 Grad neben der Stelle, die der Roboter sagt.</translation>
    </message>
    <message>
        <source>Where marker %1 is in observation %2, matched points lie</source>
        <translation>Wo Marker %1 in Beobachtung %2 ist, liegen Punktpaare</translation>
    </message>
    <message>
        <source>angle of %1</source>
        <translation>Winkel von %1</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>bend across the axis of %1</source>
        <translation>Biegung quer zur Achse von %1</translation>
    </message>
    <message>
        <source>beside where the model has it</source>
        <translation>neben der Stelle des Modells</translation>
    </message>
    <message>
        <source>direction in which %1 last moved</source>
        <translation>letzte Bewegungsrichtung von %1</translation>
    </message>
    <message>
        <source>place of the TCP along %1 of the sensor's link</source>
        <translation>Ort des TCP längs %1 des Gliedes mit dem Sensor</translation>
    </message>
    <message>
        <source>distance from the sensor</source>
        <translation>Abstand vom Sensor</translation>
    </message>
    <message>
        <source>down</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>error of %1</source>
        <translation>Fehler von %1</translation>
    </message>
    <message>
        <source>excluded by the user</source>
        <translation>vom Benutzer ausgeschlossen</translation>
    </message>
    <message>
        <source>excluded: %1</source>
        <translation>ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>from observation %1 on</source>
        <translation>ab Beobachtung %1</translation>
    </message>
    <message>
        <source>further</source>
        <translation>weiter durchhängen</translation>
    </message>
    <message>
        <source>from one side to the other</source>
        <translation>von der einen Seite zur anderen</translation>
    </message>
    <message>
        <source>from the model's</source>
        <translation>vom Modell</translation>
    </message>
    <message>
        <source>from the start of the session to its end</source>
        <translation>vom Anfang der Sitzung bis zu ihrem Ende</translation>
    </message>
    <message>
        <source>from where the calibration has them</source>
        <translation>neben der Stelle der Kalibrierung</translation>
    </message>
    <message>
        <source>further than it reads</source>
        <translation>weiter, als es anzeigt</translation>
    </message>
    <message>
        <source>gravity torque at %1</source>
        <translation>Schweremoment an %1</translation>
    </message>
    <message>
        <source>gravity's moment across the axis of %1</source>
        <translation>Schweremoment quer zur Achse von %1</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>image column</source>
        <translation>Bildspalte</translation>
    </message>
    <message>
        <source>image row</source>
        <translation>Bildzeile</translation>
    </message>
    <message>
        <source>it alone does not agree with the others</source>
        <translation>sie allein stimmt mit den anderen nicht überein</translation>
    </message>
    <message>
        <source>it has no image, and no point of the target is given</source>
        <translation>sie hat kein Bild, und kein Punkt des Bretts ist angegeben</translation>
    </message>
    <message>
        <source>its target was not found</source>
        <translation>ihr Brett wurde nicht gefunden</translation>
    </message>
    <message>
        <source>its target was not measured</source>
        <translation>ihr Brett wurde nicht gemessen</translation>
    </message>
    <message>
        <source>joints moved %1 deg since observation %2; %3 deg count as new</source>
        <translation>Gelenke seit Beobachtung %2 um %1 Grad bewegt; neu ist eine Pose ab %3 Grad</translation>
    </message>
    <message>
        <source>left open until the cameras' mount is known: %1 labelled and %2 open observations do not agree on one yet</source>
        <translation>offen, bis der Sitz der Kameras bekannt ist: %1 markierte und %2 offene Beobachtungen einigen sich noch auf keinen</translation>
    </message>
    <message>
        <source>left open: nothing is known of the cameras' mount, and no observation is labelled yet</source>
        <translation>offen gelassen: vom Sitz der Kameras ist nichts bekannt, und noch keine Beobachtung ist markiert</translation>
    </message>
    <message>
        <source>link behind it</source>
        <translation>Glied dahinter</translation>
    </message>
    <message>
        <source>marker %1 is %2 mm from where it must be on the body (limit %3)</source>
        <translation>Marker %1 liegt %2 mm neben seiner Stelle auf dem Körper (Grenze %3)</translation>
    </message>
    <message>
        <source>marker body</source>
        <translation>Markerkörper</translation>
    </message>
    <message>
        <source>mount</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>no %1 corners near the prediction have the side lengths of the markers within 3 sigma</source>
        <translation>keine %1 Ecken nahe der Vorhersage haben die Seitenlängen der Marker auf 3 Sigma</translation>
    </message>
    <message>
        <source>no marker is labelled</source>
        <translation>kein Marker ist markiert</translation>
    </message>
    <message>
        <source>no marker is labelled and there are no images</source>
        <translation>kein Marker ist markiert, und es gibt keine Bilder</translation>
    </message>
    <message>
        <source>no marker was measured</source>
        <translation>kein Marker wurde gemessen</translation>
    </message>
    <message>
        <source>no observation before it is labelled; label one first</source>
        <translation>keine Beobachtung davor ist markiert; markiere zuerst eine</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund angegeben</translation>
    </message>
    <message>
        <source>no start for the mount can be found from it</source>
        <translation>aus ihr lässt sich kein Anfang für den Sitz finden</translation>
    </message>
    <message>
        <source>off the epipolar line</source>
        <translation>neben der Epipolarlinie</translation>
    </message>
    <message>
        <source>none of the %1 markers has a corner pair near where it must be (%2 epipolar pairs in the images)</source>
        <translation>keiner der %1 Marker hat ein Eckenpaar nahe der Stelle, an der er sein muss (%2 Epipolarpaare in den Bildern)</translation>
    </message>
    <message>
        <source>only %1 of %2 markers have a corner pair near where they must be (%3 epipolar pairs in the images)</source>
        <translation>nur %1 von %2 Markern haben ein Eckenpaar nahe der Stelle, an der sie sein müssen (%3 Epipolarpaare in den Bildern)</translation>
    </message>
    <message>
        <source>order of the observations</source>
        <translation>Reihenfolge der Beobachtungen</translation>
    </message>
    <message>
        <source>position of %1</source>
        <translation>Pose von %1</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>verworfen: %1</translation>
    </message>
    <message>
        <source>shift along %1 of marker %2</source>
        <translation>Versatz längs %1 von Marker %2</translation>
    </message>
    <message>
        <source>shift along %1 of the %2</source>
        <translation>Versatz längs %1, %2</translation>
    </message>
    <message>
        <source>the first observation needs %1 labelled markers seen as points, and has %2</source>
        <translation>die erste Beobachtung braucht %1 markierte Marker, die als Punkte gesehen werden, und hat %2</translation>
    </message>
    <message>
        <source>tilt of the base about %1</source>
        <translation>Neigung der Basis um %1</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>too many corners look alike to tell the markers among them (%1 epipolar pairs in the images): no assignment was found among those nearest to the prediction</source>
        <translation>zu viele Ecken sehen gleich aus, um die Marker darunter zu erkennen (%1 Epipolarpaare in den Bildern): unter den nächsten zur Vorhersage fand sich keine Zuordnung</translation>
    </message>
    <message>
        <source>turn about %1 of the %2</source>
        <translation>Drehung um %1, %2</translation>
    </message>
    <message>
        <source>two assignments of corners to markers fit equally well, and nothing tells which is right</source>
        <translation>zwei Zuordnungen von Ecken zu Markern passen gleich gut, und nichts sagt, welche stimmt</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>velocity of %1</source>
        <translation>Geschwindigkeit von %1</translation>
    </message>
    <message>
        <source>share the %1 (%2)</source>
        <translation>haben gemeinsam: %1 (%2)</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positiv</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>negativ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 too</source>
        <translation>auch %1</translation>
    </message>
    <message>
        <source>only %1</source>
        <translation>nur %1</translation>
    </message>
    <message>
        <source>chessboard of %1 x %2 inner corners, squares of %3</source>
        <translation>Schachbrett mit %1 × %2 inneren Ecken, Felder von %3</translation>
    </message>
    <message>
        <source>grid of %1 x %2 tags of %3 from %4, gaps of %5</source>
        <translation>Gitter aus %1 × %2 Tags von %3 aus %4, Lücken von %5</translation>
    </message>
    <message>
        <source>body of the tags %1 of %2 from %3</source>
        <translation>Körper mit den Tags %1 von %2 aus %3</translation>
    </message>
    <message>
        <source>tags %1 of %2 from %3</source>
        <translation>Tags %1 von %2 aus %3</translation>
    </message>
    <message>
        <source>sine and cosine of %1 times it</source>
        <translation>Sinus und Kosinus vom %1-fachen</translation>
    </message>
    <message>
        <source>in proportion to it</source>
        <translation>im gleichen Verhältnis</translation>
    </message>
    <message>
        <source>its square, signed</source>
        <translation>sein Quadrat mit Vorzeichen</translation>
    </message>
    <message>
        <source>a saturation of it</source>
        <translation>eine Sättigung davon</translation>
    </message>
    <message>
        <source>a steep saturation of it</source>
        <translation>eine steile Sättigung davon</translation>
    </message>
    <message>
        <source>a curve of it</source>
        <translation>eine Kurve davon</translation>
    </message>
    <message>
        <source>dying away within %1 % of the session</source>
        <translation>klingt innerhalb von %1 % der Sitzung ab</translation>
    </message>
    <message>
        <source>its cube</source>
        <translation>seine dritte Potenz</translation>
    </message>
    <message>
        <source>its product with the %1</source>
        <translation>ihr Produkt mit %1</translation>
    </message>
    <message>
        <source>So large an error is rare: before any number is used, make sure that mount, rig, joints and labels are right.</source>
        <translation>Ein so großer Fehler ist selten: stelle sicher, dass Kamerasitz, Kameras, Gelenke und Marken stimmen, bevor du eine Zahl benutzt.</translation>
    </message>
    <message>
        <source>What is left is more than any robot explains: this is no answer; check mount, cameras, joints' order and labels.</source>
        <translation>Was bleibt, ist mehr, als irgendein Roboter erklärt: das ist keine Antwort; prüfe Kamerasitz, Kameras, Reihenfolge der Gelenke und Marken.</translation>
    </message>
    <message>
        <source>A marker would lie behind a camera that saw it: this is no answer; check the mount, the cameras and the labels.</source>
        <translation>Ein Marker läge hinter einer Kamera, die ihn sah: das ist keine Antwort; prüfe Kamerasitz, Kameras und Marken.</translation>
    </message>
    <message>
        <source>All observations have the same joint positions: nothing can be told from one pose.</source>
        <translation>Alle Beobachtungen haben dieselben Gelenkwinkel: aus einer einzigen Pose lässt sich nichts sagen.</translation>
    </message>
    <message>
        <source>Only one observation is used: tcp_from_body is that of thesis (4.35), and nothing checks it.</source>
        <translation>Nur eine Beobachtung ist benutzt: tcp_from_body ist das der Arbeit (4.35), und nichts prüft es.</translation>
    </message>
    <message>
        <source>Marker %1 is seen in no used observation and has no position.</source>
        <translation>Marker %1 ist in keiner verwendeten Beobachtung zu sehen und hat keinen Ort.</translation>
    </message>
    <message>
        <source>Markers %1 are seen in no used observation and have no position.</source>
        <translation>Die Marker %1 sind in keiner verwendeten Beobachtung zu sehen und haben keinen Ort.</translation>
    </message>
    <message>
        <source>From pose to pose the robot is off by more than the noise of the images: %1 (one standard deviation of each number). Images and robot are weighed by that.</source>
        <translation>Von Pose zu Pose liegt der Roboter weiter daneben, als die Bilder rauschen: %1 (eine Standardabweichung jeder Zahl). Bilder und Roboter sind danach gewichtet.</translation>
    </message>
    <message>
        <source>its joints by %1 mrad and its flange by %2 mm</source>
        <translation>seine Gelenke um %1 mrad und sein Flansch um %2 mm</translation>
    </message>
    <message>
        <source>its joints by %1 mrad</source>
        <translation>seine Gelenke um %1 mrad</translation>
    </message>
    <message>
        <source>its flange by %1 mm</source>
        <translation>sein Flansch um %1 mm</translation>
    </message>
    <message>
        <source>its flange by %1 mm and %2 mrad</source>
        <translation>sein Flansch um %1 mm und %2 mrad</translation>
    </message>
    <message>
        <source>TCP-&gt;Body is not determined in %1: %2. Its numbers there are where the fit began.</source>
        <translation>TCP→Körper ist unbestimmt: %1; %2. Seine Zahlen dort stehen, wo die Anpassung begann.</translation>
    </message>
    <message>
        <source>The sensor's mount is not determined in %1: %2. Its numbers there are where the fit began.</source>
        <translation>Der Sitz des Sensors ist unbestimmt: %1; %2. Seine Zahlen dort stehen, wo die Anpassung begann.</translation>
    </message>
    <message>
        <source>The measurements do not determine %1 of %2: %3. More poses, turned about other axes, tell it.</source>
        <translation>Die Messungen bestimmen %1 von %2 nicht: %3. Mehr Posen, um andere Achsen gedreht, sagen es.</translation>
    </message>
    <message>
        <source>these numbers are nan here, and no sigma stands beside them</source>
        <translation>diese Zahlen sind hier nan, und kein Sigma steht daneben</translation>
    </message>
    <message>
        <source>the transform is left out of the file</source>
        <translation>die Transformation fehlt in der Datei</translation>
    </message>
    <message>
        <source>the hand stands in one and the same pose in all observations</source>
        <translation>die Hand steht in allen Beobachtungen in derselben Pose</translation>
    </message>
    <message>
        <source>no pose turns the hand</source>
        <translation>keine Pose dreht die Hand</translation>
    </message>
    <message>
        <source>every pose turns the hand about the same axis</source>
        <translation>jede Pose dreht die Hand um dieselbe Achse</translation>
    </message>
    <message>
        <source>these poses do not show it</source>
        <translation>diese Posen zeigen es nicht</translation>
    </message>
    <message>
        <source>its place along %1</source>
        <translation>der Ort entlang %1</translation>
    </message>
    <message>
        <source>its place across %1</source>
        <translation>der Ort quer zu %1</translation>
    </message>
    <message>
        <source>its place</source>
        <translation>der Ort</translation>
    </message>
    <message>
        <source>its turn about %1</source>
        <translation>die Drehung um %1</translation>
    </message>
    <message>
        <source>its turn but about %1</source>
        <translation>die Drehung außer um %1</translation>
    </message>
    <message>
        <source>its turn</source>
        <translation>die Drehung</translation>
    </message>
    <message>
        <source>the TCP's %1</source>
        <translation>%1 des TCP</translation>
    </message>
    <message>
        <source>the %1 of the mount's link</source>
        <translation>%1 des Gliedes, auf dem der Sensor sitzt</translation>
    </message>
    <message>
        <source>(%1) of the TCP</source>
        <translation>(%1) des TCP</translation>
    </message>
    <message>
        <source>(%1) of the mount's link</source>
        <translation>(%1) des Gliedes, auf dem der Sensor sitzt</translation>
    </message>
    <message>
        <source>The robot stands in one and the same pose in all observations, and where the sensor sits is asked for: neither it nor TCP-&gt;Body can be told from one pose. Record poses that shift the hand and turn it about two axes.</source>
        <translation>Der Roboter steht in allen Beobachtungen in derselben Pose, und gefragt ist, wo der Sensor sitzt: aus einer einzigen Pose lässt sich weder er noch TCP→Körper sagen. Nimm Posen auf, die die Hand verschieben und um zwei Achsen drehen.</translation>
    </message>
    <message>
        <source>The fit did not converge in %1 iterations.</source>
        <translation>Die Anpassung ist nach %1 Schritten nicht zur Ruhe gekommen.</translation>
    </message>
    <message>
        <source>%1 direction%2 of the unknowns cannot be observed in these poses and stay as they were.</source>
        <translation>%1 Richtungen der Unbekannten zeigen sich in diesen Posen nicht und bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>%1 sightings by one camera only cannot take part in this objective, which needs triangulated points.</source>
        <translation>%1 Marken, die nur eine Kamera sah, können bei dieser Zielfunktion nicht mitmachen: sie braucht Punkte im Raum.</translation>
    </message>
    <message>
        <source>Observation %1: the declared springs are too soft for the load; no equilibrium is found.</source>
        <translation>Beobachtung %1: die angegebenen Federn sind für die Last zu weich; es findet sich kein Gleichgewicht.</translation>
    </message>
    <message>
        <source>Observation %1: marker %2 cannot be triangulated; its %3 image points are not one point in front of the cameras.</source>
        <translation>Beobachtung %1: Marker %2 ergibt keinen Punkt im Raum; seine %3 Bildpunkte sind nicht ein Punkt vor den Kameras.</translation>
    </message>
    <message>
        <source>The noise is neither declared nor to be estimated: %1 %2 is assumed.</source>
        <translation>Das Rauschen ist weder angegeben noch zu schätzen: angenommen sind %1 %2.</translation>
    </message>
    <message>
        <source>points of the tracker</source>
        <translation>Punkten des Trackers</translation>
    </message>
    <message>
        <source>corners and camera errors</source>
        <translation>Ecken und Fehlern der Kameras</translation>
    </message>
    <message>
        <source>%1 cannot show how the body is turned on the hand: its rotation stays as it was at the start.</source>
        <translation>%1 zeigt nicht, wie der Körper an der Hand gedreht ist: seine Drehung bleibt, wie sie am Anfang war.</translation>
    </message>
    <message>
        <source>Two markers show only partly how the body is turned on the hand: its turn about the line through both stays as it was at the start.</source>
        <translation>Zwei Marker zeigen nur teilweise, wie der Körper an der Hand gedreht ist: seine Drehung um die Linie durch beide bleibt, wie sie am Anfang war.</translation>
    </message>
    <message>
        <source>One marker</source>
        <translation>Ein Marker</translation>
    </message>
    <message>
        <source>A tip</source>
        <translation>Eine Spitze</translation>
    </message>
    <message>
        <source>Nothing but the measurements' own sigmas (usually %1 %2) tells the noise; they are taken at their word.</source>
        <translation>Nichts als die Sigmas der Messungen selbst (gewöhnlich %1 %2) sagt etwas über das Rauschen; sie gelten, wie sie dastehen.</translation>
    </message>
    <message>
        <source>The noise, %1 %2, is that of poses which were measured again; how well the robot repeats is part of it.</source>
        <translation>Das Rauschen, %1 %2, ist das von Posen, die noch einmal gemessen wurden; wie gut der Roboter wiederholt, gehört dazu.</translation>
    </message>
    <message>
        <source>%1: the measurements say more than 5 times what is plausible; its prior sigmas were taken %2 times as large.</source>
        <translation>%1: die Messungen sagen mehr als das 5-fache des Plausiblen; die A-priori-Standardabweichungen gelten hier %2-fach.</translation>
    </message>
    <message>
        <source>An effect of the model shows only while the joints move; these poses are at rest and cannot show it.</source>
        <translation>Eine Ursache des Modells zeigt sich nur, während die Gelenke sich bewegen; diese Posen ruhen und können sie nicht zeigen.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>socket</source>
        <translation>Pfanne</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>dial gauge</source>
        <translation>Messuhr</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Socket</source>
        <translation>Pfanne</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Dial gauge</source>
        <translation>Messuhr</translation>
    </message>
    <message>
        <source>Ball bar, wire</source>
        <translation>Messstab, Seil</translation>
    </message>
    <message>
        <source>A plate: the tip touches it, or stands as much above it as was read.</source>
        <translation>Eine Platte: die Spitze berührt sie oder steht um das Abgelesene darüber.</translation>
    </message>
    <message>
        <source>The tip's ball sits in it.</source>
        <translation>Die Kugel der Spitze sitzt darin.</translation>
    </message>
    <message>
        <source>The tip lies against a straight edge.</source>
        <translation>Die Spitze liegt an einer geraden Kante.</translation>
    </message>
    <message>
        <source>It reads how far the tip is along its axis.</source>
        <translation>Sie zeigt, wie weit die Spitze entlang ihrer Achse ist.</translation>
    </message>
    <message>
        <source>It reads how far the tip is from a point.</source>
        <translation>Er zeigt, wie weit die Spitze von einem Punkt ist.</translation>
    </message>
    <message>
        <source>Plane %1: the tip touched it.</source>
        <translation>Ebene %1: die Spitze hat sie berührt.</translation>
    </message>
    <message>
        <source>Plane %1: the tip stood %2 mm above it.</source>
        <translation>Ebene %1: die Spitze stand %2 mm darüber.</translation>
    </message>
    <message>
        <source>Socket %1: the tip's ball sat in it.</source>
        <translation>Pfanne %1: die Kugel der Spitze saß darin.</translation>
    </message>
    <message>
        <source>Edge %1: the tip lay against it.</source>
        <translation>Kante %1: die Spitze lag daran.</translation>
    </message>
    <message>
        <source>Dial gauge %1: it read %2 mm.</source>
        <translation>Messuhr %1: sie zeigte %2 mm.</translation>
    </message>
    <message>
        <source>Length %1: it read %2 mm.</source>
        <translation>Länge %1: abgelesen %2 mm.</translation>
    </message>
    <message>
        <source>Where the tip sits on the hand is not determined in %1 of its %2 numbers: turn the hand about more than one axis while it touches.</source>
        <translation>Wo die Spitze an der Hand sitzt, ist in %1 ihrer %2 Zahlen nicht bestimmt: drehe die Hand um mehr als eine Achse, während sie berührt.</translation>
    </message>
    <message>
        <source>Where %1 stands is not determined by these touches; touch it more often, farther apart and with the hand turned.</source>
        <translation>Wo %1 steht, bestimmen diese Berührungen nicht; berühre öfter, weiter auseinander und mit gedrehter Hand.</translation>
    </message>
    <message>
        <source>The zero of %1 cannot be known from these touches: another one does what another place of the tip or of the fixtures does.</source>
        <translation>Der Nullpunkt von %1 lässt sich aus diesen Berührungen nicht erkennen: ein anderer tut, was ein anderer Ort der Spitze oder der Vorrichtungen tut.</translation>
    </message>
    <message>
        <source>One plane alone tells only what lifts the tip off it, and nothing along it; put the plate in two more places, tilted against the first, or add a socket.</source>
        <translation>Eine Ebene allein zeigt nur, was die Spitze von ihr abhebt, und nichts längs ihrer; lege die Platte an zwei weitere Orte, gegen den ersten gekippt, oder nimm eine Pfanne dazu.</translation>
    </message>
    <message>
        <source>Nothing that was touched tells a length: the robot's size is taken from its description, within 0.1 %. Two sockets of known distance (&lt;apart&gt;), a ball bar or a fixture whose place is known would tell it.</source>
        <translation>Nichts, was berührt wurde, zeigt eine Länge: die Größe des Roboters gilt wie beschrieben, auf 0,1 % genau. Zwei Pfannen von bekanntem Abstand (&lt;apart&gt;), ein Kugelstab oder eine Vorrichtung, deren Ort bekannt ist, würden sie zeigen.</translation>
    </message>
    <message>
        <source>%1: no posture within the joint limits touches a fixture; check the limits in the robot's file.</source>
        <translation>%1: keine Pose innerhalb der Gelenkgrenzen berührt eine Vorrichtung; prüfe die Grenzen in der Datei des Roboters.</translation>
    </message>
    <message>
        <source>has a place_sigma, expected one only where a place is said and estimate="yes"; a place that is held has none.</source>
        <translation>hat ein place_sigma, erwartet nur, wo ein Ort genannt ist und estimate="yes" steht; ein gehaltener Ort hat keines.</translation>
    </message>
    <message>
        <source>%1: the readings in column %2 (%3) have no unit; write it into the header, "%4 [mm]", "[um]" or "[m]".</source>
        <translation>%1: die Ablesungen in Spalte %2 (%3) haben keine Einheit; schreibe sie in den Kopf, "%4 [mm]", "[um]" oder "[m]".</translation>
    </message>
    <message>
        <source>%1: the readings in column %2 (%3) are in %4, which is none of mm, um and m; write it into the header, "%5 [mm]", "[um]" or "[m]".</source>
        <translation>%1: die Ablesungen in Spalte %2 (%3) sind in %4, was weder mm noch um noch m ist; schreibe sie in den Kopf, "%5 [mm]", "[um]" oder "[m]".</translation>
    </message>
    <message>
        <source>%1: nothing says what the fixture %2 is; name it with --fixture "%3 %4", or %5 in place of %3.</source>
        <translation>%1: nichts sagt, was die Vorrichtung %2 ist; nenne sie mit --fixture "%3 %4", oder %5 anstelle von %3.</translation>
    </message>
    <message>
        <source>%1: the fixture %2 is taken for a %3 by its name; say --fixture "KIND %4" where it is something else.</source>
        <translation>%1: die Vorrichtung %2 gilt ihrem Namen nach als %3; sage --fixture "KIND %4", wo sie etwas anderes ist.</translation>
    </message>
    <message>
        <source>%1: is no table of touches; a session of touches is made of tables (CSV) of joint angles, fixture and reading, and of the robot.</source>
        <translation>%1: ist keine Tabelle von Berührungen; eine Sitzung von Berührungen entsteht aus Tabellen (CSV) von Gelenkwinkeln, Vorrichtung und Ablesung und aus dem Roboter.</translation>
    </message>
    <message>
        <source>%1: has no header; name its columns in a first line, or with --table-columns "a1 a2 ... fixture value[mm]".</source>
        <translation>%1: hat keinen Kopf; nenne die Spalten in einer ersten Zeile oder mit --table-columns "a1 a2 ... fixture value[mm]".</translation>
    </message>
    <message>
        <source>There is no table of touches; name a CSV of joint angles, fixture and reading.</source>
        <translation>Es gibt keine Tabelle von Berührungen; nenne eine CSV von Gelenkwinkeln, Vorrichtung und Ablesung.</translation>
    </message>
    <message>
        <source>%1: a touch of %2 has no reading, and it reads one; fill the column value, or say --fixture "... value=METRES" where it is the same for all.</source>
        <translation>%1: eine Berührung von %2 hat keine Ablesung, obwohl dort abgelesen wird; fülle die Spalte value, oder sage --fixture "... value=METRES", wo sie für alle dieselbe ist.</translation>
    </message>
    <message>
        <source>%1: has other joints, or in another order, than the table before.</source>
        <translation>%1: hat andere Gelenke, oder in anderer Reihenfolge, als die Tabelle davor.</translation>
    </message>
    <message>
        <source>Fixture %1: %2 touches.</source>
        <translation>Vorrichtung %1: %2 Berührungen.</translation>
    </message>
    <message>
        <source>How exactly a touch tells is estimated; where it is known say it: --sigma (m), or sigma=METRES of a --fixture.</source>
        <translation>Wie genau eine Berührung ist, wird geschätzt; wo es bekannt ist, sage es: --sigma (m) oder sigma=METRES einer --fixture.</translation>
    </message>
    <message>
        <source>%1: %2 lines are of a touch that the line before is of too; each counts once.</source>
        <translation>%1: %2 Zeilen gehören zu einer Berührung, zu der auch die Zeile davor gehört; jede zählt einmal.</translation>
    </message>
    <message>
        <source>No posture in %1 searches touches the fixture %2 within the joint limits; place it nearer to the robot, or widen --joint-range.</source>
        <translation>Keine Pose aus %1 Suchen berührt die Vorrichtung %2 innerhalb der Gelenkgrenzen; stelle sie näher an den Roboter oder erweitere --joint-range.</translation>
    </message>
    <message>
        <source>%1 and %2 cannot be told apart at any of the %3 poses that this robot and these cameras allow: whatever one of them does, the other does too.</source>
        <translation>%1 und %2 lassen sich in keiner der %3 Posen unterscheiden, die dieser Roboter und diese Kameras erlauben: was das eine tut, tut auch das andere.</translation>
    </message>
    <message>
        <source>An effect depends on where a pose is approached from: drive to the poses in this order, each straight from the one before.</source>
        <translation>Eine Ursache hängt davon ab, von wo eine Pose angefahren wird: fahre sie in dieser Reihenfolge an, jede geradewegs von der davor.</translation>
    </message>
    <message>
        <source>shift across, u,</source>
        <translation>Verschiebung quer, u,</translation>
    </message>
    <message>
        <source>shift across, w,</source>
        <translation>Verschiebung quer, w,</translation>
    </message>
    <message>
        <source>Nothing has changed that these poses show: cameras, hand and arm are as they were.</source>
        <translation>Nichts hat sich geändert, was diese Posen zeigen: Kameras, Hand und Arm sind, wie sie waren.</translation>
    </message>
    <message>
        <source>arm and hand are as they were</source>
        <translation>Arm und Hand sind, wie sie waren</translation>
    </message>
    <message>
        <source>arm and cameras are as they were</source>
        <translation>Arm und Kameras sind, wie sie waren</translation>
    </message>
    <message>
        <source>cameras and markers are as they were</source>
        <translation>Kameras und Marker sind, wie sie waren</translation>
    </message>
    <message>
        <source>The %1 turned by %2 and moved by %3 on its mount</source>
        <translation>%1: auf der Halterung um %2 gedreht und um %3 verschoben</translation>
    </message>
    <message>
        <source>The cameras turned against each other by %1 and moved by %2</source>
        <translation>Die Kameras haben sich gegeneinander um %1 gedreht und um %2 verschoben</translation>
    </message>
    <message>
        <source>The marker body slipped on the hand by %1 and turned by %2</source>
        <translation>Der Markerkörper ist an der Hand um %1 verrutscht und hat sich um %2 gedreht</translation>
    </message>
    <message>
        <source>Of the markers %1 alone slipped, by %2</source>
        <translation>Von den Markern ist nur %1 verrutscht, um %2</translation>
    </message>
    <message>
        <source>The cameras' lenses are not what they were (%1)</source>
        <translation>Die Objektive der Kameras sind nicht mehr, was sie waren (%1)</translation>
    </message>
    <message>
        <source>focal lengths or centres</source>
        <translation>Brennweiten oder Mitten</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>%1 single wrong points of the %2 session are left out.</source>
        <translation>%1 einzelne falsche Punkte der %2 Sitzung bleiben weg.</translation>
    </message>
    <message>
        <source>Of the %1 session: %2</source>
        <translation>Von der %1 Sitzung: %2</translation>
    </message>
    <message>
        <source>first</source>
        <translation>ersten</translation>
    </message>
    <message>
        <source>second</source>
        <translation>zweiten</translation>
    </message>
    <message>
        <source>The sessions name other calibrations of the cameras; each is measured by its own.</source>
        <translation>Die Sitzungen nennen verschiedene Kalibrierungen der Kameras; jede wird mit ihrer eigenen gemessen.</translation>
    </message>
    <message>
        <source>The model misses what both sessions measured. What the catalogue has and smooth curves of the joints' angles, the same in both, were fitted beside the change; a change that looks like them is not seen.</source>
        <translation>Das Modell verfehlt, was beide Sitzungen gemessen haben. Was der Katalog hat und glatte Kurven der Gelenkwinkel, in beiden gleich, wurden neben der Änderung angepasst; eine Änderung, die ihnen gleicht, wird nicht gesehen.</translation>
    </message>
    <message>
        <source>%1 waits for its %2 image, with the number %3 in its name.</source>
        <translation>%1 wartet auf sein Bild %2, mit der Nummer %3 im Namen.</translation>
    </message>
    <message>
        <source>The board's points are counted from the other corner in the images of the camera %1 than in those of %2.</source>
        <translation>In den Bildern der Kamera %1 sind die Punkte des Bretts von einer anderen Ecke aus gezählt als in denen von %2.</translation>
    </message>
    <message>
        <source>%1 are in millimetres, where metres are expected.</source>
        <translation>%1 sind in Millimetern, wo Meter erwartet werden.</translation>
    </message>
    <message>
        <source>Write %1 in %2 in metres (a thousandth).</source>
        <translation>Schreibe %1 in %2 in Metern (ein Tausendstel).</translation>
    </message>
    <message>
        <source>In %1 write %2 %3 %4 in place of the readings of %5.</source>
        <translation>Schreibe in %1 %2 %3 %4 anstelle der Ablesungen von %5.</translation>
    </message>
    <message>
        <source>Write tcp="%1" and mount="%2" into %3.</source>
        <translation>Schreibe tcp="%1" und mount="%2" in %3.</translation>
    </message>
    <message>
        <source>In %1 give each observation the robot's readings of the one %2 place%3 %4 (leave out the %5 %6 of the table of the robot that it was made of).</source>
        <translation>Gib in %1 jeder Beobachtung die Ablesungen des Roboters, die um %2 Zeilen %4 stehen (lass %5 %6 der Tabelle des Roboters aus, aus der sie entstand).</translation>
    </message>
    <message>
        <source>Invert each &lt;flange_pose&gt; in %1 (each pose in the table of the flange), or convert %2 --eye-on-base.</source>
        <translation>Kehre jede &lt;flange_pose&gt; in %1 um (jede Pose der Tabelle des Flansches), oder convert %2 --eye-on-base.</translation>
    </message>
    <message>
        <source>The quaternions of %1 have w %2; they were read with w %3.</source>
        <translation>Die Quaternionen von %1 haben w %2; gelesen wurden sie mit w %3.</translation>
    </message>
    <message>
        <source>In %1 bring the quaternions of %2 into the order x y z w (in the table that they come from name the columns %3).</source>
        <translation>Bring in %1 die Quaternionen von %2 in die Reihenfolge x y z w (benenne in der Tabelle, aus der sie kommen, die Spalten %3).</translation>
    </message>
    <message>
        <source>rotation vectors, and were read as roll pitch yaw</source>
        <translation>Drehvektoren und wurden als roll pitch yaw gelesen</translation>
    </message>
    <message>
        <source>roll pitch yaw, and were read as rotation vectors</source>
        <translation>roll pitch yaw und wurden als Drehvektoren gelesen</translation>
    </message>
    <message>
        <source>turns about the moving axes x, y, z, and were read as roll pitch yaw</source>
        <translation>Drehungen um die mitgedrehten Achsen x, y, z und wurden als roll pitch yaw gelesen</translation>
    </message>
    <message>
        <source>turns about z first, then y, x, and were read as roll pitch yaw</source>
        <translation>Drehungen zuerst um z, dann y, x und wurden als roll pitch yaw gelesen</translation>
    </message>
    <message>
        <source>turns about z, y, z, and were read as roll pitch yaw</source>
        <translation>Drehungen um z, y, z und wurden als roll pitch yaw gelesen</translation>
    </message>
    <message>
        <source>turn the three numbers into quaternions as rotation vectors (axis times angle)</source>
        <translation>mache aus den drei Zahlen Quaternionen, als Drehvektoren (Achse mal Winkel)</translation>
    </message>
    <message>
        <source>turn the three numbers into quaternions as roll pitch yaw (fixed axes x, y, z)</source>
        <translation>mache aus den drei Zahlen Quaternionen, als roll pitch yaw (feste Achsen x, y, z)</translation>
    </message>
    <message>
        <source>turn the three numbers into quaternions as Rx(1st) Ry(2nd) Rz(3rd)</source>
        <translation>mache aus den drei Zahlen Quaternionen als Rx(1.) Ry(2.) Rz(3.)</translation>
    </message>
    <message>
        <source>turn the three numbers into quaternions as Rz(1st) Ry(2nd) Rx(3rd)</source>
        <translation>mache aus den drei Zahlen Quaternionen als Rz(1.) Ry(2.) Rx(3.)</translation>
    </message>
    <message>
        <source>turn the three numbers into quaternions as Rz(1st) Ry(2nd) Rz(3rd)</source>
        <translation>mache aus den drei Zahlen Quaternionen als Rz(1.) Ry(2.) Rz(3.)</translation>
    </message>
    <message>
        <source>The rotations of %1 are %2.</source>
        <translation>Die Drehungen von %1 sind %2.</translation>
    </message>
    <message>
        <source>In the table that %1 of %2 come from, %3.</source>
        <translation>In der Tabelle, aus der %1 von %2 kommen: %3.</translation>
    </message>
    <message>
        <source>the images of %1 are taken for those of camera %2</source>
        <translation>die Bilder von %1 gelten als die der Kamera %2</translation>
    </message>
    <message>
        <source>the images of camera %1 have other times than those of camera %2; each is taken as of the moment of the nearest one. A board that moved between is seen at two places</source>
        <translation>die Bilder der Kamera %1 haben andere Zeiten als die der Kamera %2; jedes gilt als vom Augenblick des nächsten. Ein Brett, das sich dazwischen bewegt hat, wird an zwei Orten gesehen</translation>
    </message>
    <message>
        <source>camera %1 has no image of %2 of the %3 moments</source>
        <translation>Kamera %1 hat von %2 der %3 Augenblicke kein Bild</translation>
    </message>
    <message>
        <source>%1 files are no images by their names and were left out</source>
        <translation>%1 Dateien sind ihren Namen nach keine Bilder und wurden ausgelassen</translation>
    </message>
    <message>
        <source>The %1 on %2 %3 %4 that the robot moves on %5.</source>
        <translation>Auf %2: %1. Bewegt wird %4 auf %5 vom Roboter.</translation>
    </message>
    <message>
        <source>The robot moves the %1 on %2 over %3 on %4.</source>
        <translation>Der Roboter bewegt %1 auf %2 über %3 auf %4.</translation>
    </message>
    <message>
        <source>The robot moves both the %1 on %2 and %3 on %4.</source>
        <translation>Der Roboter bewegt beides: %1 auf %2 und %3 auf %4.</translation>
    </message>
    <message>
        <source>Fix the camera where it sees the hand in many postures, and fasten the target to the hand so that it cannot slip; turn the hand as far as the target can be seen.</source>
        <translation>Befestige die Kamera dort, wo sie die Hand in vielen Posen sieht, und das Ziel so an der Hand, dass es nicht rutschen kann; drehe die Hand so weit, wie das Ziel zu sehen ist.</translation>
    </message>
    <message>
        <source>Fasten the camera to the hand and lay the target on the table where nothing moves it; look at it from all sides, near and far, and turn the hand about the line of sight.</source>
        <translation>Befestige die Kamera an der Hand und lege das Ziel dorthin auf den Tisch, wo nichts es bewegt; sieh es von allen Seiten an, nah und fern, und drehe die Hand um die Blickrichtung.</translation>
    </message>
    <message>
        <source>Name the link that carries the camera and the link that carries the target; a measured joint must lie between them.</source>
        <translation>Nenne das Glied, das die Kamera trägt, und das Glied, das das Ziel trägt; dazwischen muss ein gemessenes Gelenk liegen.</translation>
    </message>
    <message>
        <source>Images show the tag %1 several times (in %2 observation%3); which of them is meant nothing tells, and it is left out there.</source>
        <translation>Bilder zeigen das Tag %1 mehrmals (in %2 Beobachtungen); welches gemeint ist, sagt nichts, und dort wird es ausgelassen.</translation>
    </message>
    <message>
        <source>The %1 is found in %2 of %3 observations with images.</source>
        <translation>%1: gefunden in %2 von %3 Beobachtungen mit Bildern.</translation>
    </message>
    <message>
        <source>It is not found in %1 observations, first in %2.</source>
        <translation>Nicht gefunden ist es in %1 Beobachtungen, zuerst in %2.</translation>
    </message>
    <message>
        <source>%1 points and %2 tags did not agree with the rest of the target and are left out.</source>
        <translation>%1 Punkte und %2 Tags stimmten nicht mit dem übrigen Ziel überein und sind ausgelassen.</translation>
    </message>
    <message>
        <source>the flat target's pose flipped to its mirror tilt</source>
        <translation>die Pose des flachen Ziels sprang in seine gespiegelte Neigung</translation>
    </message>
    <message>
        <source>%1 point%2 of the target %3 not enough to say where it is</source>
        <translation>%1 Punkte des Ziels genügen nicht, um zu sagen, wo es ist</translation>
    </message>
    <message>
        <source>the points do not lie to each other as on the target: %1 %2 rms beside the best pose</source>
        <translation>die Punkte liegen nicht zueinander wie auf dem Ziel: %1 %2 (rms) neben der besten Pose</translation>
    </message>
    <message>
        <source>%1 image points lie outside the image of %2 x %3 px, first in observation %4</source>
        <translation>%1 Bildpunkte liegen außerhalb des Bildes von %2 x %3 px, zuerst in Beobachtung %4</translation>
    </message>
    <message>
        <source>the %1 points of a target</source>
        <translation>die %1 Punkte eines Ziels</translation>
    </message>
    <message>
        <source>its tags were read, but none of its corners is clear enough</source>
        <translation>seine Tags wurden gelesen, aber keine seiner Ecken ist deutlich genug</translation>
    </message>
    <message>
        <source>of %1 X-corners none form the whole board of %2 x %3</source>
        <translation>von %1 X-Ecken bilden keine das ganze Brett aus %2 x %3</translation>
    </message>
    <message>
        <source>none of its tags was found</source>
        <translation>keines seiner Tags wurde gefunden</translation>
    </message>
    <message>
        <source>tags were read, but none clearly enough</source>
        <translation>Tags wurden gelesen, aber keines deutlich genug</translation>
    </message>
    <message>
        <source>Two of the markers are the same corner (sides %1 mm); take another corner.</source>
        <translation>Zwei der Marker sind dieselbe Ecke (Seiten %1 mm); nimm eine andere Ecke.</translation>
    </message>
    <message>
        <source>where a whole fixture is held out, the error rises from %1 to %2</source>
        <translation>wo eine ganze Vorrichtung zurückgehalten wird, steigt der Fehler von %1 auf %2</translation>
    </message>
    <message>
        <source>where a whole region of poses is held out, the error rises from %1 to %2</source>
        <translation>wo ein ganzer Bereich von Posen ungesehen bleibt, steigt der Fehler von %1 auf %2</translation>
    </message>
    <message>
        <source>What is left is finer than any sensor measures, as in a session that was computed without noise; %1 %2 are taken for its noise.</source>
        <translation>Was übrig ist, ist feiner, als ein Sensor misst, wie in einer Sitzung, die ohne Rauschen gerechnet wurde; als Rauschen gelten %1 %2.</translation>
    </message>
    <message>
        <source>The model does not fit down to the noise, so what it leaves is reckoned as noise; find what is missing first (handsight-cli diagnose) and give it with --effects.</source>
        <translation>Das Modell passt nicht bis auf das Rauschen, also gilt, was es übrig lässt, als Rauschen; suche zuerst, was fehlt (handsight-cli diagnose), und gib es mit --effects an.</translation>
    </message>
    <message>
        <source>Only %1 of %2 poses lie %3 rad or more away from the others and from those that were taken.</source>
        <translation>Nur %1 von %2 Posen liegen %3 rad oder mehr von den anderen und von den aufgenommenen entfernt.</translation>
    </message>
    <message>
        <source>rotation vectors (axis times angle)</source>
        <translation>Drehvektoren (Achse mal Winkel)</translation>
    </message>
    <message>
        <source>roll, pitch, yaw (turns about the fixed axes x, y, z)</source>
        <translation>roll, pitch, yaw (Drehungen um die festen Achsen x, y, z)</translation>
    </message>
    <message>
        <source>turns about z, then the new y, then the new x (A B C of KUKA)</source>
        <translation>Drehungen um z, dann das neue y, dann das neue x (A B C von KUKA)</translation>
    </message>
    <message>
        <source>turns about z, then the new y, then the new z (O A T of Kawasaki)</source>
        <translation>Drehungen um z, dann das neue y, dann das neue z (O A T von Kawasaki)</translation>
    </message>
    <message>
        <source>turns about x, then the new y, then the new z (RX RY RZ of Staubli)</source>
        <translation>Drehungen um x, dann das neue y, dann das neue z (RX RY RZ von Stäubli)</translation>
    </message>
    <message>
        <source>%1 degrees and %2 mm</source>
        <translation>%1 Grad und %2 mm</translation>
    </message>
    <message>
        <source> (These measurements are explained as well by %1.)</source>
        <translation> (Ebenso gut erklärt diese Messungen %1.)</translation>
    </message>
    <message>
        <source> with </source>
        <translation> mit </translation>
    </message>
    <message>
        <source>%1: %2 names no two joints; expected %3:FIRST,SECOND.</source>
        <translation>%1: %2 nennt keine zwei Gelenke; erwartet wird %3:ERSTES,ZWEITES.</translation>
    </message>
    <message>
        <source>%1: %2 is no number.</source>
        <translation>%1: %2 ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1: the session has no joint %2; it has: %3.</source>
        <translation>%1: die Sitzung hat kein Gelenk %2; sie hat: %3.</translation>
    </message>
    <message>
        <source>Joint %1 is not reckoned against the link before it: the angle of %2 has to be %3 it (some makers reckon a joint against the horizontal).</source>
        <translation>Gelenk %1 zählt nicht gegen das Glied davor: der Winkel von %2 ist %3 (manche Hersteller zählen ein Gelenk gegen die Waagerechte).</translation>
    </message>
    <message>
        <source>added to</source>
        <translation>dazuzuzählen</translation>
    </message>
    <message>
        <source>taken from</source>
        <translation>davon abzuziehen</translation>
    </message>
    <message>
        <source>all joints</source>
        <translation>allen Gelenken</translation>
    </message>
    <message>
        <source>All joints are in degrees, where radians are expected.</source>
        <translation>Alle Gelenke sind in Grad, wo Radiant erwartet werden.</translation>
    </message>
    <message>
        <source>marker_order: there is no camera %1 beside the first one that sees a board.</source>
        <translation>marker_order: neben der ersten gibt es keine Kamera %1, die ein Brett sieht.</translation>
    </message>
    <message>
        <source>Count the points of %1 in %2 from the other end: point m becomes %3 - m.</source>
        <translation>Die Punkte von %1 in %2 vom anderen Ende zählen: aus Punkt m wird %3 - m.</translation>
    </message>
    <message>
        <source>length_unit: %1 is no length of this session; expected one of: %2.</source>
        <translation>length_unit: %1 ist keine Länge dieser Sitzung; erwartet wird eine von: %2.</translation>
    </message>
    <message>
        <source>image_mirrored: %1 is not known; expected nothing (left and right exchanged) or vertical (top and bottom).</source>
        <translation>image_mirrored: %1 ist nicht bekannt; erwartet wird nichts (links und rechts vertauscht) oder vertical (oben und unten).</translation>
    </message>
    <message>
        <source>image_turned: %1 is not known; expected 90, 180 or 270 (degrees to the right).</source>
        <translation>image_turned: %1 ist nicht bekannt; erwartet wird 90, 180 oder 270 (Grad nach rechts).</translation>
    </message>
    <message>
        <source>%1: the session has no camera %2.</source>
        <translation>%1: die Sitzung hat keine Kamera %2.</translation>
    </message>
    <message>
        <source>%1: the session has no poses of %2; it has those of: %3.</source>
        <translation>%1: die Sitzung hat keine Posen von %2; sie hat die von: %3.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>The flange's poses are inverted: they say where the base is in the flange's frame%1.</source>
        <translation>Die Posen des Flansches sind invertiert: sie sagen, wo die Basis im System des Flansches ist%1.</translation>
    </message>
    <message>
        <source>, or the sensor stands beside the robot and the flange carries the target</source>
        <translation>, oder der Sensor steht neben dem Roboter und der Flansch trägt das Ziel</translation>
    </message>
    <message>
        <source>, or the flange carries the sensor and the target stands beside the robot</source>
        <translation>, oder der Flansch trägt den Sensor und das Ziel steht neben dem Roboter</translation>
    </message>
    <message>
        <source>with</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>without</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>quaternion_order: %1 is no order; expected wxyz or xyzw.</source>
        <translation>quaternion_order: %1 ist keine Reihenfolge; erwartet wird wxyz oder xyzw.</translation>
    </message>
    <message>
        <source>last</source>
        <translation>zuletzt</translation>
    </message>
    <message>
        <source>euler_convention: %1 is not known; expected one of: %2.</source>
        <translation>euler_convention: %1 ist nicht bekannt; erwartet wird eine von: %2.</translation>
    </message>
    <message>
        <source>The target's poses are inverted: they say where the sensor is in the target's frame, where the target in the sensor's is expected.</source>
        <translation>Die Posen des Ziels sind invertiert: sie sagen, wo der Sensor im System des Ziels ist, wo das Ziel in dem des Sensors erwartet wird.</translation>
    </message>
    <message>
        <source>wrong_link: the robot has no link %1; it has: %2.</source>
        <translation>wrong_link: der Roboter hat kein Glied %1; er hat: %2.</translation>
    </message>
    <message>
        <source>%1 (or a link that is fixed to it: %2)</source>
        <translation>%1 (oder ein Glied, das fest mit ihm verbunden ist: %2)</translation>
    </message>
    <message>
        <source>Hand and mount are exchanged: the sensor is on %1, and what it sees on %2.</source>
        <translation>Hand und Halter sind vertauscht: der Sensor sitzt auf %1, und was er sieht, auf %2.</translation>
    </message>
    <message>
        <source>What the sensor sees is not on %1, but on %2.</source>
        <translation>Was der Sensor sieht, sitzt nicht auf %1, sondern auf %2.</translation>
    </message>
    <message>
        <source>The sensor is not on %1, but on %2.</source>
        <translation>Der Sensor sitzt nicht auf %1, sondern auf %2.</translation>
    </message>
    <message>
        <source>Write tcp="%1" into &lt;robot&gt; of %2.</source>
        <translation>tcp="%1" in &lt;robot&gt; von %2 schreiben.</translation>
    </message>
    <message>
        <source>Write mount="%1" into %2.</source>
        <translation>mount="%1" in %2 schreiben.</translation>
    </message>
    <message>
        <source>%1: there is no blunder of that name; in this session there may be: %2.</source>
        <translation>%1: einen groben Fehler dieses Namens gibt es nicht; in dieser Sitzung kann es geben: %2.</translation>
    </message>
    <message>
        <source>%1: there is nothing in this session that it could be put right in.</source>
        <translation>%1: in dieser Sitzung gibt es nichts, woran das zu berichtigen wäre.</translation>
    </message>
    <message>
        <source>%1: where? Expected %2:WHERE, one of: %3.</source>
        <translation>%1: wo? Erwartet wird %2:WO, eines von: %3.</translation>
    </message>
    <message>
        <source>%1: there is a session already; take another folder.</source>
        <translation>%1: dort ist schon eine Sitzung; nimm einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made (%2).</source>
        <translation>%1: der Ordner lässt sich nicht anlegen (%2).</translation>
    </message>
    <message>
        <source>: its %1 are about %2, not %3</source>
        <translation>: seine %1 sind etwa %2, nicht %3</translation>
    </message>
    <message>
        <source>The target is %1 % %2 than its description says%3.</source>
        <translation>Das Ziel ist %1 % %2, als seine Beschreibung sagt%3.</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>größer</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>kleiner</translation>
    </message>
    <message>
        <source>size_swapped: the session has no camera %1.</source>
        <translation>size_swapped: die Sitzung hat keine Kamera %1.</translation>
    </message>
    <message>
        <source>gravity_turned: %1 is no direction; expected one of: %2.</source>
        <translation>gravity_turned: %1 ist keine Richtung; erwartet wird eine von: %2.</translation>
    </message>
    <message>
        <source>pairing_shift: %1 is no number of places; expected 1, -1, 2 ...</source>
        <translation>pairing_shift: %1 ist keine Zahl von Stellen; erwartet wird 1, -1, 2 ...</translation>
    </message>
    <message>
        <source>pairing_shift: the session has %1 observations, fewer than that.</source>
        <translation>pairing_shift: die Sitzung hat %1 Beobachtungen, weniger als das.</translation>
    </message>
    <message>
        <source>The target's places agree to %1 mm and its turns only to %2 degrees: either the sensor tells no turns, or they are read otherwise than they were written (order of a quaternion, kind of angles). The places alone carry this answer.</source>
        <translation>Die Orte des Ziels passen auf %1 mm zusammen und seine Drehungen nur auf %2 Grad: entweder misst der Sensor keine Drehungen, oder sie werden anders gelesen, als sie geschrieben wurden (Reihenfolge eines Quaternions, Art der Winkel). Allein die Orte tragen diese Antwort.</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>What was seen and where the robot stood are in opposite orders: the first belongs to the last.</source>
        <translation>Was gesehen wurde und wo der Roboter stand, ist gegenläufig geordnet: das Erste gehört zum Letzten.</translation>
    </message>
    <message>
        <source>What was seen and where the robot stood are in different orders: one of the two was sorted as text, so that 10 comes before 2.</source>
        <translation>Was gesehen wurde und wo der Roboter stand, ist verschieden geordnet: eines von beiden wurde als Text sortiert, so dass 10 vor 2 kommt.</translation>
    </message>
    <message>
        <source>What was seen and where the robot stood are in different orders: the motions between them say for %1 of %2 %3 which belongs to which.</source>
        <translation>Was gesehen wurde und wo der Roboter stand, ist verschieden geordnet: die Bewegungen dazwischen sagen für %1 von %2 (%3), was zu wem gehört.</translation>
    </message>
    <message>
        <source>Turn one of the two tables or lists of files round and convert again.</source>
        <translation>Drehe eine der beiden Tabellen oder Dateilisten um und wandle noch einmal um.</translation>
    </message>
    <message>
        <source>Sort both by number (or name the files 001, 002 ... 010, so that text and number agree) and convert again.</source>
        <translation>Ordne beides nach Nummern (oder nenne die Dateien 001, 002 ... 010, so dass Text und Nummer übereinstimmen) und wandle noch einmal um.</translation>
    </message>
    <message>
        <source>In %1 pair what was seen with the robot's readings of these observations, in turn: %2; or sort both by one number and convert again.</source>
        <translation>Paare in %1, was gesehen wurde, der Reihe nach mit den Gelenkwerten oder Posen dieser Beobachtungen: %2; oder ordne beides nach einer Nummer und wandle noch einmal um.</translation>
    </message>
    <message>
        <source>pairing_order: %1 is no list of the observations that show something.</source>
        <translation>pairing_order: %1 ist keine Liste der Beobachtungen, die etwas zeigen.</translation>
    </message>
    <message>
        <source>pairing_order: %1 observations are named where %2 show something.</source>
        <translation>pairing_order: %1 Beobachtungen sind genannt, wo %2 etwas zeigen.</translation>
    </message>
    <message>
        <source>which of the robot's readings belongs to it is not known</source>
        <translation>welche Stellung des Roboters dazu gehört, ist nicht bekannt</translation>
    </message>
    <message>
        <source>What was seen and where the robot stood are paired %1 off: each %2 belongs to the robot's %3 %4 %5.</source>
        <translation>Was gesehen wurde und wo der Roboter stand, ist um %1 versetzt gepaart: zu jeder Messung (%2) gehört das des Roboters (%3) %4 %5.</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>eine Zeile</translation>
    </message>
    <message>
        <source>later</source>
        <translation>später</translation>
    </message>
    <message>
        <source>earlier</source>
        <translation>früher</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>The position has %1 numbers; expected %2, one for each joint: %3.</source>
        <translation>Die Pose hat %1 Zahlen; erwartet werden %2, eine je Gelenk: %3.</translation>
    </message>
    <message>
        <source>Effect "%1": the session has the markers 0 to %2.</source>
        <translation>Effekt "%1": die Sitzung hat die Marker 0 bis %2.</translation>
    </message>
    <message>
        <source>Effect "%1" sits at no joint; leave its place empty.</source>
        <translation>Effekt "%1" sitzt an keinem Gelenk; seinen Platz leer lassen.</translation>
    </message>
    <message>
        <source>Effect "%1" has %2 values; expected %3, one for each parameter, or none.</source>
        <translation>Effekt "%1" hat %2 Werte; erwartet werden %3, einer je Parameter, oder keine.</translation>
    </message>
    <message>
        <source>Effect "%1" says of %2 parameters whether they are held; expected %3, or none.</source>
        <translation>Effekt "%1" sagt von %2 Parametern, ob sie gehalten werden; erwartet werden %3, oder keine.</translation>
    </message>
    <message>
        <source>Effect "%1" has the value %2; expected one from %3 to %4.</source>
        <translation>Effekt "%1" hat den Wert %2; erwartet wird einer von %3 bis %4.</translation>
    </message>
    <message>
        <source>Effect "%1": the robot has no moving joint "%2"; it has: %3.</source>
        <translation>Effekt "%1": der Roboter hat kein bewegliches Gelenk "%2"; er hat: %3.</translation>
    </message>
    <message>
        <source>Effect "%1": the joint "%2" follows no other; %3 sits at joints that do.</source>
        <translation>Effekt "%1": das Gelenk "%2" folgt keinem anderen; %3 sitzt an Gelenken, die folgen.</translation>
    </message>
    <message>
        <source>Effect "%1": %2 sits at no camera "%3"; it may sit at: %4.</source>
        <translation>Effekt "%1": %2 sitzt an keiner Kamera "%3"; er kann sitzen an: %4.</translation>
    </message>
    <message>
        <source>none of this session</source>
        <translation>keiner dieser Sitzung</translation>
    </message>
    <message>
        <source>Effect "%1": "%2" is no tag; write its number.</source>
        <translation>Effekt "%1": "%2" ist kein Tag; seine Nummer schreiben.</translation>
    </message>
    <message>
        <source>Effect "%1": the target has no tag %2; it has: %3.</source>
        <translation>Effekt "%1": das Ziel hat kein Tag %2; es hat: %3.</translation>
    </message>
    <message>
        <source>Effect "%1": %2 sits at no session "%3"; it may sit at: %4.</source>
        <translation>Effekt "%1": %2 sitzt an keiner Sitzung "%3"; er kann sitzen an: %4.</translation>
    </message>
    <message>
        <source>Effect "%1": "%2" is no marker; write its number, 0 to 63.</source>
        <translation>Effekt "%1": "%2" ist kein Marker; seine Nummer schreiben, 0 bis 63.</translation>
    </message>
    <message>
        <source>Effect "%1" is not in the catalogue, which has: %2.</source>
        <translation>Den Effekt "%1" hat der Katalog nicht; er hat: %2.</translation>
    </message>
    <message>
        <source>Effect "%1": %2 has no parameter "%3".</source>
        <translation>Effekt "%1": %2 hat keinen Parameter "%3".</translation>
    </message>
    <message>
        <source>Effect "%1" has no value; write it as id:joint.parameter=value, for example joint_elasticity:arm_2.compliance=1e-4.</source>
        <translation>Effekt "%1" hat keinen Wert; als id:gelenk.parameter=wert schreiben, zum Beispiel joint_elasticity:arm_2.compliance=1e-4.</translation>
    </message>
    <message>
        <source>Effect "%1": this session has no %2, which %3 is of.</source>
        <translation>Effekt "%1": diese Sitzung hat kein %2, zu dem %3 gehört.</translation>
    </message>
    <message>
        <source>body of tags whose places are known</source>
        <translation>Körper von Tags, deren Plätze bekannt sind</translation>
    </message>
    <message>
        <source>target of one piece whose shape is known</source>
        <translation>Ziel aus einem Stück, dessen Form bekannt ist</translation>
    </message>
    <message>
        <source>Effect "%1" sits at a %2; write %3:%4.parameter=value.</source>
        <translation>Effekt "%1" sitzt an einer Stelle (%2); %3:%4.parameter=wert schreiben.</translation>
    </message>
    <message>
        <source>Effect "%1": "%2" is not a finite number.</source>
        <translation>Effekt "%1": "%2" ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Effect "%1" has no place in this session: it sits at %2.</source>
        <translation>Effekt "%1" hat in dieser Sitzung keinen Platz: er sitzt an: %2.</translation>
    </message>
    <message>
        <source>joints that follow others</source>
        <translation>Gelenke, die anderen folgen</translation>
    </message>
    <message>
        <source>cameras, which this session has not got for it</source>
        <translation>Kameras, die diese Sitzung dafür nicht hat</translation>
    </message>
    <message>
        <source>the tags of a body whose places are known</source>
        <translation>die Tags eines Körpers, deren Plätze bekannt sind</translation>
    </message>
    <message>
        <source>a target of one piece whose shape is known</source>
        <translation>ein Ziel aus einem Stück, dessen Form bekannt ist</translation>
    </message>
    <message>
        <source>joints between the sensor and the TCP</source>
        <translation>Gelenke zwischen dem Sensor und dem TCP</translation>
    </message>
    <message>
        <source>Effect "%1" sits at no joint; write %2 alone.</source>
        <translation>Effekt "%1" sitzt an keinem Gelenk; %2 allein schreiben.</translation>
    </message>
    <message>
        <source> at %1</source>
        <translation> bei %1</translation>
    </message>
    <message>
        <source>, column %1</source>
        <translation>, Spalte %1</translation>
    </message>
    <message>
        <source>%1: the formula %2 is not understood%3; expected parameters, variables such as q, tau, velocity, time or q_NAME, numbers, + - * / ^ and the functions sin cos tan tanh exp log sqrt abs sign min max.</source>
        <translation>%1: die Formel %2 ist nicht zu verstehen%3; erwartet werden Parameter, Größen wie q, tau, velocity, time oder q_NAME, Zahlen, + - * / ^ und die Funktionen sin cos tan tanh exp log sqrt abs sign min max.</translation>
    </message>
    <message>
        <source>own="%1": only effects that sit at joints can be one session's own; slips, drifts, cameras and bodies are so without being named.</source>
        <translation>own="%1": nur Effekte, die an Gelenken sitzen, können einer Sitzung eigen sein; Verrutschen, Wandern, Kameras und Körper sind es, ohne genannt zu werden.</translation>
    </message>
    <message>
        <source>session "%1": own="%2" names no joint between its sensor and its TCP.</source>
        <translation>Sitzung "%1": own="%2" nennt kein Gelenk zwischen ihrem Sensor und ihrem TCP.</translation>
    </message>
    <message>
        <source>Effect "%1"</source>
        <translation>Effekt "%1"</translation>
    </message>
    <message>
        <source>%1, line %2, effect "%3"</source>
        <translation>%1, Zeile %2, Effekt "%3"</translation>
    </message>
    <message>
        <source>%1: %2 has a part without any parameter; expected every part to be in proportion to one, so that the effect is absent when all are 0.</source>
        <translation>%1: %2 hat einen Teil ohne Parameter; erwartet wird, dass jeder Teil zu einem proportional ist, so dass der Effekt fehlt, wenn alle 0 sind.</translation>
    </message>
    <message>
        <source>%1: %2 is not linear in the parameter "%3"; expected it as a factor, outside of functions and powers.</source>
        <translation>%1: %2 ist nicht linear im Parameter "%3"; erwartet wird er als Faktor, außerhalb von Funktionen und Potenzen.</translation>
    </message>
    <message>
        <source>%1: in %2 parameters are multiplied with each other; expected a sum in which each part has one parameter.</source>
        <translation>%1: in %2 werden Parameter miteinander multipliziert; erwartet wird eine Summe, in der jeder Teil einen Parameter hat.</translation>
    </message>
    <message>
        <source>%1: scope %2 has no site %3; expected one of %4.</source>
        <translation>%1: der Bereich %2 hat keine Stelle %3; erwartet wird eine von %4.</translation>
    </message>
    <message>
        <source>%1: the cameras' numbers are the same in all observations; %2 names the variable "%3", expected parameters and numbers alone.</source>
        <translation>%1: die Zahlen der Kameras sind in allen Beobachtungen dieselben; %2 nennt die Größe "%3"; erwartet werden nur Parameter und Zahlen.</translation>
    </message>
    <message>
        <source>%1: scope %2 has no joint of its own; write %3_NAME with a joint's name in place of "%4".</source>
        <translation>%1: der Bereich %2 hat kein eigenes Gelenk; %3_NAME mit dem Namen eines Gelenks anstelle von "%4" schreiben.</translation>
    </message>
    <message>
        <source>%1: the parameter "%2" has the name of a variable; expected another name.</source>
        <translation>%1: der Parameter "%2" heißt wie eine Größe; erwartet wird ein anderer Name.</translation>
    </message>
    <message>
        <source>%1: no formula names the parameter "%2"; expected it in one of &lt;moves&gt;.</source>
        <translation>%1: keine Formel nennt den Parameter "%2"; erwartet wird er in einem &lt;moves&gt;.</translation>
    </message>
    <message>
        <source>%1: the formula is not a finite number at observation %2%3; expected one that is finite everywhere.</source>
        <translation>%1: die Formel ist bei Beobachtung %2%3 keine endliche Zahl; erwartet wird eine, die überall endlich ist.</translation>
    </message>
    <message>
        <source>%1: the catalogue has an effect "%2" already; give it another id.</source>
        <translation>%1: einen Effekt "%2" hat der Katalog schon; ihm eine andere id geben.</translation>
    </message>
    <message>
        <source>The formula %1 cannot be written in another language: %2 is not understood there.</source>
        <translation>Die Formel %1 lässt sich nicht in einer anderen Sprache schreiben: %2 ist dort nicht zu verstehen.</translation>
    </message>
    <message>
        <source>its end</source>
        <translation>ihr Ende</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>This kind of file holds fixed transforms alone: the %1 effects of the model that move the arm are not in it; export as cpp or python for the whole hand pose.</source>
        <translation>Diese Art von Datei enthält nur feste Transformationen: die %1 Effekte des Modells, die den Arm bewegen, sind nicht darin; für die ganze Handpose als cpp oder python exportieren.</translation>
    </message>
    <message>
        <source>%1 is no kind of export; expected one of: %2.</source>
        <translation>%1 ist keine Art von Export; erwartet wird eine von: %2.</translation>
    </message>
    <message>
        <source>The calibration does not say where the sensor sits; the file has no link for it.</source>
        <translation>Die Kalibrierung sagt nicht, wo der Sensor sitzt; die Datei hat kein Glied für ihn.</translation>
    </message>
    <message>
        <source>The effect %1 cannot be written into a file of this kind; export as yaml or csv.</source>
        <translation>Der Effekt %1 lässt sich nicht in eine Datei dieser Art schreiben; als yaml oder csv exportieren.</translation>
    </message>
    <message>
        <source>%1 and the rotation</source>
        <translation>%1 und die Drehung</translation>
    </message>
    <message>
        <source>No joint moves the hand %1: there are no Denavit-Hartenberg parameters to write; name the link that the robot moves as tcp.</source>
        <translation>Kein Gelenk bewegt die Hand %1: es gibt keine Denavit-Hartenberg-Parameter zu schreiben; das Glied, das der Roboter bewegt, als tcp nennen.</translation>
    </message>
    <message>
        <source>The robot has two joints that end with %1: ur_calibration is of one arm; export its URDF.</source>
        <translation>Der Roboter hat zwei Gelenke, die auf %1 enden: ur_calibration ist von einem Arm; seine URDF exportieren.</translation>
    </message>
    <message>
        <source>Joint %1 does not follow the one before it in UR's order; ur_calibration is for UR's six joints one after another: export as urdf.</source>
        <translation>Gelenk %1 folgt nicht auf das davor in URs Reihenfolge; ur_calibration ist für URs sechs Gelenke nacheinander: als urdf exportieren.</translation>
    </message>
    <message>
        <source>Joint %1 does not turn about its z axis: the robot is described otherwise than in ur_description, whose frames the file is read with; use its URDF, or export as urdf.</source>
        <translation>Gelenk %1 dreht nicht um seine z-Achse: der Roboter ist anders beschrieben als in ur_description, mit deren Systemen die Datei gelesen wird; dessen URDF nehmen oder als urdf exportieren.</translation>
    </message>
    <message>
        <source>the spring of %1 (%2 %3)</source>
        <translation>die Feder von %1 (%2 %3)</translation>
    </message>
    <message>
        <source>%1 follows %2 joints: other readers may take one of its &lt;mimic&gt; alone</source>
        <translation>%1 folgt %2 Gelenken: andere Leser nehmen vielleicht nur eines seiner &lt;mimic&gt;</translation>
    </message>
    <message>
        <source>%1 mm rms and %2 mm at most over %3</source>
        <translation>%1 mm im quadratischen Mittel und höchstens %2 mm über %3</translation>
    </message>
    <message>
        <source>the %1 poses of the session</source>
        <translation>die %1 Posen der Sitzung</translation>
    </message>
    <message>
        <source>%1 poses drawn within the joints' limits</source>
        <translation>%1 Posen, innerhalb der Gelenkgrenzen gezogen</translation>
    </message>
    <message>
        <source>lerobot's calibration has no number %1 for %2; expected the JSON that lerobot wrote.</source>
        <translation>lerobots Kalibrierung hat keine Zahl %1 für %2; erwartet wird das JSON, das lerobot geschrieben hat.</translation>
    </message>
    <message>
        <source>lerobot's calibration has no motor %1; the joints of the session need the names that it gives its motors.</source>
        <translation>lerobots Kalibrierung hat keinen Motor %1; die Gelenke der Sitzung brauchen die Namen, die sie ihren Motoren gibt.</translation>
    </message>
    <message>
        <source>Joint %1 slides, and lerobot's calibration is of motors that turn; export as urdf or ros2_control.</source>
        <translation>Gelenk %1 schiebt, und lerobots Kalibrierung ist von Motoren, die drehen; als urdf oder ros2_control exportieren.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>None of the %1 images that were looked at shows the %2</source>
        <translation>Keines der %1 angesehenen Bilder zeigt das Ziel (%2)</translation>
    </message>
    <message>
        <source>%1; what they show fits %2 (a chessboard is counted by its inner corners, not by its squares).</source>
        <translation>%1; was sie zeigen, passt zu %2 (ein Schachbrett wird nach seinen inneren Ecken gezählt, nicht nach Feldern).</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 von %3</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>%1; what can be read in them are the %2%3.</source>
        <translation>%1; was sich in ihnen lesen lässt, sind %2%3.</translation>
    </message>
    <message>
        <source>%1; what they show (%2) fits %3.</source>
        <translation>%1; was sie zeigen (%2), passt zu %3.</translation>
    </message>
    <message>
        <source>The sheet of %1 x %2 mm has more than %3 million pixels at %4 dots per inch; use fewer, or PDF or SVG.</source>
        <translation>Das Blatt von %1 x %2 mm hat bei %4 Punkten je Zoll mehr als %3 Millionen Bildpunkte; weniger nehmen, oder PDF oder SVG.</translation>
    </message>
    <message>
        <source>%1 of its tags were read where they should be, but none of the %2 corners between them looks like one: something is drawn or lies over them (an earlier detection drawn into the image?), or it is out of focus</source>
        <translation>%1 seiner Tags wurden gelesen, wo sie sein sollten, aber keine der %2 Ecken dazwischen sieht wie eine aus: etwas ist darüber gezeichnet oder liegt darauf (eine frühere Erkennung im Bild?), oder es ist unscharf</translation>
    </message>
    <message>
        <source>fewer than two of the tags that were read lie as they do on the board</source>
        <translation>weniger als zwei der gelesenen Tags liegen wie auf dem Brett</translation>
    </message>
    <message>
        <source>its tags were read, but lie otherwise than on this board: another layout, or several boards</source>
        <translation>seine Tags wurden gelesen, liegen aber anders als auf diesem Brett: eine andere Anordnung, oder mehrere Bretter</translation>
    </message>
    <message>
        <source>the tag with the number %1 is there %2 times, and nothing tells which of them is meant: give every tag its own number</source>
        <translation>das Tag mit der Nummer %1 ist %2 Mal da, und nichts sagt, welches gemeint ist: jedem Tag seine eigene Nummer geben</translation>
    </message>
    <message>
        <source>two</source>
        <translation>zwei</translation>
    </message>
    <message>
        <source>three</source>
        <translation>drei</translation>
    </message>
    <message>
        <source>--angles %1: is no way to tell a rotation; expected one of: %2.</source>
        <translation>--angles %1: ist keine Art, eine Drehung anzugeben; erwartet wird eine von: %2.</translation>
    </message>
    <message>
        <source>%1: the %2 link "%3" is not in the robot %4; name one of its links.</source>
        <translation>%1: das Glied "%3" (%2) gibt es im Roboter %4 nicht; eines seiner Glieder nennen.</translation>
    </message>
    <message>
        <source>%1: the joint "%2" named in &lt;joints&gt; is not in the robot %3.</source>
        <translation>%1: das Gelenk "%2", das &lt;joints&gt; nennt, gibt es im Roboter %3 nicht.</translation>
    </message>
    <message>
        <source>see</source>
        <translation>sehen</translation>
    </message>
    <message>
        <source>sees</source>
        <translation>sieht</translation>
    </message>
    <message>
        <source>No measured joint moves the %1 on %2 against %3 on %4: nothing can be told of where they are.</source>
        <translation>Kein gemessenes Gelenk bewegt %1 auf %2 gegen %3 auf %4: wo sie sind, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>Most of all %1 has changed, by %2 of its sigma; the marker body is %3 mm from where it was (mean over %4 poses).</source>
        <translation>Am meisten hat sich %1 geändert, um %2 seines Sigmas; der Markerkörper ist %3 mm von dort, wo er war (Mittel über %4 Posen).</translation>
    </message>
    <message>
        <source>No number differs by more than %1 of its sigma; the marker body is %2 mm from where it was (mean over %3 poses).</source>
        <translation>Keine Zahl unterscheidet sich um mehr als %1 ihres Sigmas; der Markerkörper ist %2 mm von dort, wo er war (Mittel über %3 Posen).</translation>
    </message>
    <message>
        <source>Two calibrations tell which numbers differ, not why; compare the sessions for what changed.</source>
        <translation>Zwei Kalibrierungen sagen, welche Zahlen sich unterscheiden, nicht warum; was sich geändert hat, sagt ein Vergleich der Sitzungen.</translation>
    </message>
    <message>
        <source>Joint %1 lost its zero: it stands %2 further than it reads</source>
        <translation>Gelenk %1 hat seinen Nullpunkt verloren: es steht %2 weiter, als es anzeigt</translation>
    </message>
    <message>
        <source>The hand carries %1 more than it did</source>
        <translation>Die Hand trägt %1 mehr als vorher</translation>
    </message>
    <message>
        <source>Joint %1 gives way by %2 more than it did</source>
        <translation>Gelenk %1 gibt um %2 mehr nach als vorher</translation>
    </message>
    <message>
        <source>distortion</source>
        <translation>Verzeichnung</translation>
    </message>
    <message>
        <source>; and more than one thing has changed: %1 too, or something that is not in the list.</source>
        <translation>; und mehr als eines hat sich geändert: auch %1, oder etwas, das nicht in der Liste steht.</translation>
    </message>
    <message>
        <source>; or it is %1, which these poses do not tell apart.</source>
        <translation>; oder es ist %1, was diese Posen nicht unterscheiden.</translation>
    </message>
    <message>
        <source>%1: is of the joints %2, and the session has %3; certify with a calibration of the same robot.</source>
        <translation>%1: ist von den Gelenken %2, und die Sitzung hat %3; mit einer Kalibrierung desselben Roboters zertifizieren.</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>%1 of these %2</source>
        <translation>%1 dieser %2</translation>
    </message>
    <message>
        <source>have the %1 between %2 and %3%4</source>
        <translation>haben %1 zwischen %2 und %3%4</translation>
    </message>
    <message>
        <source>have the %1 above %2%3</source>
        <translation>haben %1 über %2%3</translation>
    </message>
    <message>
        <source>have the %1 below %2%3</source>
        <translation>haben %1 unter %2%3</translation>
    </message>
    <message>
        <source>%1 %2; of the other %3 %4.</source>
        <translation>%1 %2; von den %3 anderen %4.</translation>
    </message>
    <message>
        <source>cameras'</source>
        <translation>Kamera-</translation>
    </message>
    <message>
        <source>%1: in %2 searches no pose within the joint limits shows all markers to %3; check the limits in the robot's file and the mount of the cameras.</source>
        <translation>%1: in %2 Versuchen zeigt keine Pose innerhalb der Gelenkgrenzen alle Marker für %3; die Grenzen in der Datei des Roboters und den Halter der Kameras prüfen.</translation>
    </message>
    <message>
        <source>The number of poses to plan is %1; expected 1 to %2 (--count).</source>
        <translation>Die Zahl der Posen, die zu planen sind, ist %1; erwartet wird 1 bis %2 (--count).</translation>
    </message>
    <message>
        <source>"%1" and "%2" are the same effect at the same places; give two that differ (--between a,b).</source>
        <translation>"%1" und "%2" sind derselbe Effekt an denselben Stellen; zwei verschiedene angeben (--between a,b).</translation>
    </message>
    <message>
        <source>The effect "%1" is to be told from another (--between) and is in the model already (--effects); leave it out of one of them.</source>
        <translation>Der Effekt "%1" soll von einem anderen unterschieden werden (--between) und ist schon im Modell (--effects); in einem von beiden auslassen.</translation>
    </message>
    <message>
        <source>These poses are not expected to settle it between %1 and %2: the ln Bayes factor grows by %3, and 3 (odds of 20) is needed; plan more of them.</source>
        <translation>Diese Posen werden zwischen %1 und %2 voraussichtlich nicht entscheiden: der ln des Bayesfaktors wächst um %3, und 3 (20 zu 1) ist nötig; mehr davon planen.</translation>
    </message>
    <message>
        <source> Judged by %1 of the %2 observations, evenly over the session; the model meets the others to %3%4</source>
        <translation> Beurteilt nach %1 der %2 Beobachtungen, gleichmäßig über die Sitzung; die übrigen trifft das Modell auf %3%4</translation>
    </message>
    <message>
        <source>, which is worse than what was held out here: wrong points among them, or something that these did not show.</source>
        <translation>, was schlechter ist als das hier Zurückgehaltene: falsche Punkte darunter, oder etwas, das diese nicht zeigten.</translation>
    </message>
    <message>
        <source>, no worse than these.</source>
        <translation>, nicht schlechter als diese.</translation>
    </message>
    <message>
        <source>The %1%2 differs by</source>
        <translation>%1%2 unterscheidet sich um</translation>
    </message>
    <message>
        <source> The residual "%1" follows the %2.</source>
        <translation> Das Residuum "%1" folgt %2.</translation>
    </message>
    <message>
        <source>Something that moves %1 follows the %2 (%3) in a form that is not in the catalogue; odds against nothing missing: %4.</source>
        <translation>Etwas, das %1 bewegt, folgt %2 (%3) in einer Form, die nicht im Katalog steht; Verhältnis gegen „nichts fehlt“: %4.</translation>
    </message>
    <message>
        <source> These poses could not show it: %1</source>
        <translation> Diese Posen könnten es nicht zeigen: %1</translation>
    </message>
    <message>
        <source> Odds against nothing missing: %1; %2.</source>
        <translation> Verhältnis gegen „nichts fehlt“: %1; %2.</translation>
    </message>
    <message>
        <source> On these poses it cannot be told from %1.</source>
        <translation> Auf diesen Posen ist es nicht von %1 zu unterscheiden.</translation>
    </message>
    <message>
        <source> Check: %1</source>
        <translation> Prüfen: %1</translation>
    </message>
    <message>
        <source>The model misses by %1 (held out) where the noise is %2. %3%4: %5</source>
        <translation>Das Modell liegt um %1 daneben (zurückgehalten), wo das Rauschen %2 ist. %3%4: %5</translation>
    </message>
    <message>
        <source> With it the held-out error falls to %1.</source>
        <translation> Damit sinkt der zurückgehaltene Fehler auf %1.</translation>
    </message>
    <message>
        <source> On these poses it cannot be told from %1; plan poses that would.</source>
        <translation> Auf diesen Posen ist es nicht von %1 zu unterscheiden; Posen planen, die es könnten.</translation>
    </message>
    <message>
        <source> What is left follows the %1.</source>
        <translation> Was bleibt, folgt %1.</translation>
    </message>
    <message>
        <source>The model misses by %1 (held out) where the noise is %2, and the best of the catalogue, %3%4, explains only %5 % of the excess.%6</source>
        <translation>Das Modell liegt um %1 daneben (zurückgehalten), wo das Rauschen %2 ist, und das Beste des Katalogs, %3%4, erklärt nur %5 % des Überschusses.%6</translation>
    </message>
    <message>
        <source>The residuals follow the %1 in a form that is not in the catalogue: %2.</source>
        <translation>Die Residuen folgen %1 in einer Form, die nicht im Katalog steht: %2.</translation>
    </message>
    <message>
        <source>The residual "%1" follows the %2, and nothing of the catalogue explains it.</source>
        <translation>Das Residuum "%1" folgt %2, und nichts im Katalog erklärt es.</translation>
    </message>
    <message>
        <source>Nothing is missing that these %1 observations could show: the held-out error is %2 and the noise %3.</source>
        <translation>Es fehlt nichts, das diese %1 Beobachtungen zeigen könnten: der zurückgehaltene Fehler ist %2 und das Rauschen %3.</translation>
    </message>
    <message>
        <source> What is left is scatter from pose to pose that follows nothing%1.</source>
        <translation> Was bleibt, ist Streuung von Pose zu Pose, die nichts folgt%1.</translation>
    </message>
    <message>
        <source>, as of %1</source>
        <translation>, wie von %1</translation>
    </message>
    <message>
        <source> %1 wrong point%2 left out.</source>
        <translation> Falsche Punkte ausgelassen: %1.</translation>
    </message>
    <message>
        <source> was</source>
        <translation> wurde</translation>
    </message>
    <message>
        <source>s were</source>
        <translation>e wurden</translation>
    </message>
    <message>
        <source>What is left, %1 held out, is %2 times the noise (%3) and follows nothing that was measured</source>
        <translation>Was bleibt, %1 zurückgehalten, ist das %2-Fache des Rauschens (%3) und folgt nichts, das gemessen wurde</translation>
    </message>
    <message>
        <source>; from pose to pose it is as of %1</source>
        <translation>; von Pose zu Pose ist es wie von %1</translation>
    </message>
    <message>
        <source>Nothing of the catalogue passes, but the noise of the measurements is not known (no sigma declared, no repeated poses, and no three markers that tell it), so that nobody can say whether %1 is all noise: declare sigma (convert --sigma, or sigma of &lt;tracker&gt; or &lt;pose_sensor&gt;) or repeat poses.</source>
        <translation>Nichts im Katalog besteht, aber das Rauschen der Messungen ist nicht bekannt (kein Sigma angegeben, keine wiederholten Posen und keine drei Marker, die es sagen), so dass niemand sagen kann, ob %1 alles Rauschen ist: Sigma angeben (convert --sigma, oder sigma von &lt;tracker&gt; oder &lt;pose_sensor&gt;) oder Posen wiederholen.</translation>
    </message>
    <message>
        <source>the cameras against their link</source>
        <translation>die Kameras gegen ihr Glied</translation>
    </message>
    <message>
        <source>. Robots scatter less (0.3 mrad a joint and 0.3 mm at the hand, where &lt;robot repeatability=""&gt; declares nothing else), so something is missing that is not known here. To find out: measure some poses again at the end, come to some from both sides, and record times, velocities and torques.</source>
        <translation>. Roboter streuen weniger (0,3 mrad je Gelenk und 0,3 mm an der Hand, wo &lt;robot repeatability=""&gt; nichts anderes angibt), also fehlt etwas, das hier nicht bekannt ist. Um es herauszufinden: am Ende einige Posen noch einmal messen, manche von beiden Seiten anfahren und Zeiten, Geschwindigkeiten und Momente aufzeichnen.</translation>
    </message>
    <message>
        <source>the hand against the last link</source>
        <translation>die Hand gegen das letzte Glied</translation>
    </message>
    <message>
        <source> Not named: %1.</source>
        <translation> Nicht genannt: %1.</translation>
    </message>
    <message>
        <source> It pushes back where springs give way: it probably stands in for another cause.</source>
        <translation> Sie drückt zurück, wo Federn nachgeben: wahrscheinlich steht sie für eine andere Ursache.</translation>
    </message>
    <message>
        <source> It is larger than robots are built: it probably stands in for another cause.</source>
        <translation> Sie ist größer, als Roboter gebaut werden: wahrscheinlich steht sie für eine andere Ursache.</translation>
    </message>
    <message>
        <source> It is more than three times what is usual, and it leaves much: it may stand in for another cause.</source>
        <translation> Sie ist mehr als das Dreifache des Üblichen und lässt viel übrig: vielleicht steht sie für eine andere Ursache.</translation>
    </message>
    <message>
        <source> Nothing in the residuals speaks for it.</source>
        <translation> Nichts in den Residuen spricht dafür.</translation>
    </message>
    <message>
        <source> Alone %1 is likelier; beside small deviations at each joint, which every robot has, this is.</source>
        <translation> Allein ist %1 wahrscheinlicher; neben kleinen Abweichungen in jedem Gelenk, die jeder Roboter hat, ist es dies.</translation>
    </message>
    <message>
        <source> Its size is more than three times what is usual.</source>
        <translation> Seine Größe ist mehr als das Dreifache des Üblichen.</translation>
    </message>
    <message>
        <source>a wave of %1 periods over the session</source>
        <translation>eine Welle von %1 Perioden über die Sitzung</translation>
    </message>
    <message>
        <source>a step at %1%2</source>
        <translation>eine Stufe bei %1%2</translation>
    </message>
    <message>
        <source>%1 moves with the %2, %3: it has no name in the catalogue.</source>
        <translation>%1 bewegt sich mit %2, %3: im Katalog hat es keinen Namen.</translation>
    </message>
    <message>
        <source>%1%2 where the noise is %3</source>
        <translation>%1%2 bei einem Rauschen von %3</translation>
    </message>
    <message>
        <source> held out</source>
        <translation> zurückgehalten</translation>
    </message>
    <message>
        <source>What is left, %1, differs from pose to pose and follows nothing that was measured%2: no effect can remove it.</source>
        <translation>Was bleibt, %1, ist von Pose zu Pose anders und folgt nichts, das gemessen wurde%2: kein Effekt kann es beseitigen.</translation>
    </message>
    <message>
        <source>Something real is left, %1: %2 explains a part of it, and nothing in the catalogue explains the rest.</source>
        <translation>Etwas Wirkliches bleibt, %1: %2 erklärt einen Teil davon, und nichts im Katalog erklärt den Rest.</translation>
    </message>
    <message>
        <source> %1 in the model %2 in for another cause: no robot is built so.</source>
        <translation> %1 im Modell %2 für eine andere Ursache: so ist kein Roboter gebaut.</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>stand</source>
        <translation>stehen</translation>
    </message>
    <message>
        <source> No link of the robot has a mass, so that nothing that bends could be tried: give the masses in the robot's file.</source>
        <translation> Kein Glied des Roboters hat eine Masse, so dass nichts, was sich biegt, geprüft werden konnte: Geben Sie die Massen in der Datei des Roboters an.</translation>
    </message>
    <message>
        <source>Something is left, %1, and what would explain it does not lower the error on observations that the fit has not seen.</source>
        <translation>Etwas bleibt, %1, und was es erklären würde, senkt den Fehler auf Beobachtungen nicht, die die Schätzung nicht gesehen hat.</translation>
    </message>
    <message>
        <source>Observation%1 %2: the flat target's pose flipped to its mirror tilt (turned by %3; with the tilt mirrored about the line of sight it is right). Leave %4 out.</source>
        <translation>Beobachtung%1 %2: die Pose des ebenen Ziels ist in die gespiegelte Neigung gekippt (um %3 gedreht; mit der an der Sichtlinie gespiegelten Neigung stimmt sie). Lassen Sie %4 aus.</translation>
    </message>
    <message>
        <source>it</source>
        <translation>sie</translation>
    </message>
    <message>
        <source>them</source>
        <translation>sie</translation>
    </message>
    <message>
        <source>%1 to %2 degrees</source>
        <translation>%1 bis %2 Grad</translation>
    </message>
    <message>
        <source>%1 %2 %3: by what the others say %4 off by %5%6, and the others by %7 at most. Look for a wrong reading or image, correct it or exclude it.</source>
        <translation>%1 %2 %3: nach dem, was die anderen sagen, um %5%6 daneben, und die anderen um höchstens %7. Nach einem falschen Messwert oder Bild suchen, es berichtigen oder ausschließen.</translation>
    </message>
    <message>
        <source>it is</source>
        <translation>sie ist</translation>
    </message>
    <message>
        <source>they are</source>
        <translation>sie sind</translation>
    </message>
    <message>
        <source> and more</source>
        <translation> und mehr</translation>
    </message>
    <message>
        <source>the %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>shift along %1 of %2</source>
        <translation>Versatz längs %1, %2</translation>
    </message>
    <message>
        <source>turn about %1 of %2</source>
        <translation>Drehung um %1, %2</translation>
    </message>
    <message>
        <source>joints that repeat to %1 mrad</source>
        <translation>Gelenken, die auf %1 mrad wiederholen</translation>
    </message>
    <message>
        <source> (%1 to %2 mrad)</source>
        <translation> (%1 auf %2 mrad)</translation>
    </message>
    <message>
        <source>a hand whose place scatters by %1 mm</source>
        <translation>einer Hand, deren Ort um %1 mm streut</translation>
    </message>
    <message>
        <source>%1%2 (%3 mm at the hand)</source>
        <translation>%1%2 (%3 mm an der Hand)</translation>
    </message>
    <message>
        <source> %1%2 passes by its evidence and was not taken: %3.</source>
        <translation> %1%2 besteht nach seiner Evidenz und wurde nicht genommen: %3.</translation>
    </message>
    <message>
        <source>The fit finds no answer: %1. What the model lacks cannot be told before; check mount, cameras, joints' order and labels.</source>
        <translation>Die Schätzung findet keine Lösung: %1. Vorher ist nicht zu sagen, was dem Modell fehlt; Halter, Kameras, Reihenfolge der Gelenke und Marken prüfen.</translation>
    </message>
    <message>
        <source>a marker would lie behind a camera that saw it</source>
        <translation>ein Marker läge hinter einer Kamera, die ihn gesehen hat</translation>
    </message>
    <message>
        <source>it leaves %1, more than any robot explains</source>
        <translation>sie lässt %1, mehr als ein Roboter erklärt</translation>
    </message>
    <message>
        <source>%1%2%3 Held out %4.</source>
        <translation>%1%2%3 Zurückgehalten %4.</translation>
    </message>
    <message>
        <source>In the model, though less likely than not: %1. </source>
        <translation>Im Modell, doch eher nicht da: %1. </translation>
    </message>
    <message>
        <source>Named: %1. </source>
        <translation>Mit Namen: %1. </translation>
    </message>
    <message>
        <source>Without a name: %1%2</source>
        <translation>Ohne Namen: %1%2</translation>
    </message>
    <message>
        <source>%1 +- %2 mm</source>
        <translation>%1 +- %2 mm</translation>
    </message>
    <message>
        <source>0 mm</source>
        <translation>0 mm</translation>
    </message>
    <message>
        <source>%1 are rare, and its evidence of ln %2 is below the ln %3 that is asked of them</source>
        <translation>%1 sind selten, und die Evidenz von ln %2 liegt unter den ln %3, die dafür verlangt werden</translation>
    </message>
    <message>
        <source>what follows the posture may explain as much: beside that its evidence is ln %1, below the ln %2 that is asked of %3</source>
        <translation>was der Pose folgt, mag ebenso viel erklären: daneben ist die Evidenz ln %1, unter den ln %2, die für %3 verlangt werden</translation>
    </message>
    <message>
        <source>with it an unnamed curve, which is to be left out, still explains more than any name</source>
        <translation>damit erklärt eine Kurve ohne Namen, die ausgelassen werden soll, noch immer mehr als jeder Name</translation>
    </message>
    <message>
        <source>the fit finds no answer with it: check mount, cameras and labels</source>
        <translation>die Schätzung findet damit keine Lösung: Halter, Kameras und Marken prüfen</translation>
    </message>
    <message>
        <source>the target would be more than four times as large as it is described: that is a mistake in its description, which is put right before anything else</source>
        <translation>das Ziel wäre mehr als viermal so groß, wie es beschrieben ist: das ist ein Fehler in seiner Beschreibung, der zuerst zu beheben ist</translation>
    </message>
    <message>
        <source>it is larger than robots are built, and the hand&apos;s or the sensor&apos;s place would be known ten times worse: it plays against what never moves</source>
        <translation>sie ist größer, als Roboter gebaut sind, und der Ort der Hand oder des Sensors wäre zehnmal schlechter bekannt: sie spielt gegen das aus, was sich nie bewegt</translation>
    </message>
    <message>
        <source>the held-out error does not fall</source>
        <translation>der zurückgehaltene Fehler sinkt nicht</translation>
    </message>
    <message>
        <source>held out in blocks of time, the observations on both sides of the moment do not agree</source>
        <translation>in Zeitblöcken zurückgehalten, stimmen die Beobachtungen zu beiden Seiten des Augenblicks nicht überein</translation>
    </message>
    <message>
        <source>what belongs to the robot seldom changes between sessions, and the evidence is too weak for that</source>
        <translation>was zum Roboter gehört, ändert sich selten zwischen Sitzungen, und dafür ist die Evidenz zu schwach</translation>
    </message>
    <message>
        <source>where a whole session is held out, the error rises from %1 to %2</source>
        <translation>wo eine ganze Sitzung zurückgehalten wird, steigt der Fehler von %1 auf %2</translation>
    </message>
    <message>
        <source>The corners lie on a line (%1 mm off): the hand's rotation about it cannot be seen; take a corner to the side.</source>
        <translation>Die Ecken liegen auf einer Geraden (%1 mm daneben): die Drehung der Hand um sie ist nicht zu sehen; eine Ecke seitwärts nehmen.</translation>
    </message>
    <message>
        <source>Sides %1 mm: too small, the hand's rotation would be known badly; take corners farther apart.</source>
        <translation>Seiten %1 mm: zu klein, die Drehung der Hand wäre schlecht bekannt; weiter auseinanderliegende Ecken nehmen.</translation>
    </message>
    <message>
        <source>Marker %1: no corner within %2 px of (%3, %4) in the left image%5; point nearer to one.</source>
        <translation>Marker %1: keine Ecke im Umkreis von %2 px um (%3, %4) im linken Bild%5; näher an eine zeigen.</translation>
    </message>
    <message>
        <source> (it has none)</source>
        <translation> (es hat keine)</translation>
    </message>
    <message>
        <source> (the nearest is %1 px away)</source>
        <translation> (die nächste ist %1 px entfernt)</translation>
    </message>
    <message>
        <source>Markers %1 and %2: both are nearest to the corner at (%3, %4) of the left image; point each at a corner of its own.</source>
        <translation>Marker %1 und %2: beide sind der Ecke bei (%3, %4) des linken Bilds am nächsten; auf je eine eigene Ecke zeigen.</translation>
    </message>
    <message>
        <source>Marker %1: no corner of the right image lies within %2 px of the epipolar line of (%3, %4) and in front of both cameras; take another corner or the next observation.</source>
        <translation>Marker %1: keine Ecke des rechten Bilds liegt innerhalb von %2 px der Epipolarlinie von (%3, %4) und vor beiden Kameras; eine andere Ecke oder die nächste Beobachtung nehmen.</translation>
    </message>
    <message>
        <source>%1 corners have too many partners in the right image to choose among; point at fewer markers, or at corners with a less crowded epipolar line.</source>
        <translation>%1 Ecken haben im rechten Bild zu viele mögliche Partner; auf weniger Marker zeigen, oder auf Ecken mit weniger auf der Epipolarlinie.</translation>
    </message>
    <message>
        <source>The %1 corners have no partners in the right image that are all different and within %2 mm of each other; check that they are on the hand.</source>
        <translation>Die %1 Ecken haben im rechten Bild keine Partner, die alle verschieden und höchstens %2 mm voneinander sind; prüfen, ob sie auf der Hand sind.</translation>
    </message>
    <message>
        <source>The reader of image files cannot be loaded: %1; build Handsight again.</source>
        <translation>Der Leser der Bilddateien lässt sich nicht laden: %1; Handsight neu bauen.</translation>
    </message>
    <message>
        <source>%1: the image is cut off after %2 bytes; copy it again from where it came.</source>
        <translation>%1: das Bild bricht nach %2 Bytes ab; kopiere es noch einmal von dort, wo es herkam.</translation>
    </message>
    <message>
        <source>%1: the image says that it has %2 x %3 pixels; at most %4 million are read.</source>
        <translation>%1: das Bild sagt, es habe %2 x %3 Pixel; höchstens %4 Millionen werden gelesen.</translation>
    </message>
    <message>
        <source>%1: is no image that can be read (%2 bytes); PNG, JPEG, PGM, BMP, TIFF and WebP can.</source>
        <translation>%1: ist kein Bild, das sich lesen ließe (%2 Byte); PNG, JPEG, PGM, BMP, TIFF und WebP lassen sich lesen.</translation>
    </message>
    <message>
        <source>The image of %1 x %2 could not be encoded as PNG.</source>
        <translation>Das Bild von %1 x %2 ließ sich nicht als PNG schreiben.</translation>
    </message>
    <message>
        <source>Observation %1: the declared springs are too soft for the load.</source>
        <translation>Beobachtung %1: die angegebenen Federn sind zu weich für die Last.</translation>
    </message>
    <message>
        <source>%1: the %2 objective cannot estimate %3; use the image objective.</source>
        <translation>%1: die Zielfunktion %2 kann %3 nicht schätzen; nimm die der Bilder.</translation>
    </message>
    <message>
        <source>angle-axis</source>
        <translation>angle-axis</translation>
    </message>
    <message>
        <source>effects of the cameras</source>
        <translation>Effekte der Kameras</translation>
    </message>
    <message>
        <source>effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>%1: images of a board say something of the cameras, and no number of theirs is estimated; add --effects camera_intrinsics (also lens_distortion%2).</source>
        <translation>%1: Bilder eines Bretts sagen etwas über die Kameras, und keine Zahl von ihnen wird geschätzt; --effects camera_intrinsics dazunehmen (auch lens_distortion%2).</translation>
    </message>
    <message>
        <source>%1: the angle-axis objective is of one session; fit a collection by the image objective.</source>
        <translation>%1: das Ziel angle-axis ist für eine Sitzung; eine Sammlung mit dem Ziel image schätzen.</translation>
    </message>
    <message>
        <source>%1: the target is found in none of the %2 observations that may be used; look at an image and at what &lt;target&gt; says of it.</source>
        <translation>%1: das Ziel findet sich in keiner der %2 Beobachtungen, die benutzt werden dürfen; sieh dir ein Bild an und was &lt;target&gt; davon sagt.</translation>
    </message>
    <message>
        <source>%1: none of the %2 observations has a labelled marker that may be used; label one first (handsight-cli label).</source>
        <translation>%1: in keiner der %2 Beobachtungen ist ein Marker markiert, der benutzt werden darf; markiere erst einen.</translation>
    </message>
    <message>
        <source>%1: nothing is known of the mount, and no marker is seen by two cameras, so that no start can be found; give %2 an xyz and rpy.</source>
        <translation>%1: vom Kamerasitz ist nichts bekannt, und kein Marker wird von zwei Kameras gesehen, so dass sich kein Anfang findet; gib %2 ein xyz und rpy.</translation>
    </message>
    <message>
        <source>%1: no marker is seen by two cameras in any used observation, which the %2 objective needs; use the image objective.</source>
        <translation>%1: in keiner benutzten Beobachtung sehen zwei Kameras einen Marker, was das Ziel %2 braucht; das Ziel image nehmen.</translation>
    </message>
    <message>
        <source>Nothing that was measured tells a length (every marker was measured at one place only): the robot's size is taken from its description, within 0.1 %. Measure a marker at two places of known distance to find it.</source>
        <translation>Nichts Gemessenes sagt eine Länge (jeder Marker wurde nur an einem Ort gemessen): die Größe des Roboters gilt nach seiner Beschreibung, auf 0,1 %. Einen Marker an zwei Orten bekannten Abstands messen, um sie zu finden.</translation>
    </message>
    <message>
        <source>--session %1: this is one session by itself; leave the option out.</source>
        <translation>--session %1: dies ist eine einzelne Sitzung; die Option weglassen.</translation>
    </message>
    <message>
        <source>--session %1: the collection has no such session; it has %2.</source>
        <translation>--session %1: eine solche Sitzung hat die Sammlung nicht; sie hat %2.</translation>
    </message>
    <message>
        <source>%1: holding the markers fixed needs an observation that shows three of them as points (two cameras, or a tracker), and there is none; fit with free markers.</source>
        <translation>%1: um die Marker festzuhalten, braucht es eine Beobachtung, die drei von ihnen als Punkte zeigt (zwei Kameras oder ein Tracker), und es gibt keine; mit freien Markern schätzen.</translation>
    </message>
    <message>
        <source>%1: the angle-axis objective needs observations with three markers or more (%2 of them); use the image objective.</source>
        <translation>%1: das Ziel angle-axis braucht Beobachtungen mit drei Markern oder mehr (davon %2); das Ziel image nehmen.</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
    </message>
    <message>
        <source>The declared noise, %1 %2, and the noise seen in the measurements, %3 +- %4 %2, differ by more than 3 sigma; check the declaration, or look for wrong %5.</source>
        <translation>Das angegebene Rauschen, %1 %2, und das in den Messungen gesehene, %3 ± %4 %2, unterscheiden sich um mehr als 3 Sigma; prüfe die Angabe, oder suche nach falschen %5.</translation>
    </message>
    <message>
        <source>The markers stand against each other to %1 %2, as no sensor measures: they are rigid by construction, like a tracker's virtual points, and do not tell the noise.</source>
        <translation>Die Marker stehen auf %1 %2 genau zueinander, wie kein Sensor misst: sie sind starr gemacht, wie die gedachten Punkte eines Trackers, und sagen das Rauschen nicht.</translation>
    </message>
    <message>
        <source>session "%1" of %2: %3</source>
        <translation>Sitzung "%1" von %2: %3</translation>
    </message>
    <message>
        <source>%1 marker%2</source>
        <translation>Marker: %1</translation>
    </message>
    <message>
        <source>its tags are placed to %1 mm</source>
        <translation>seine Tags sitzen auf %1 mm genau</translation>
    </message>
    <message>
        <source>its points are known to %1 mm</source>
        <translation>seine Punkte sind auf %1 mm bekannt</translation>
    </message>
    <message>
        <source>Fixture %1 on %2, a %3: %4 touches%5; its place is %6.</source>
        <translation>Vorrichtung %1 auf %2 (%3): %4 Berührungen%5; ihr Ort ist %6.</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>guessed, part of the fit</source>
        <translation>geraten, Teil der Schätzung</translation>
    </message>
    <message>
        <source>unknown, part of the fit</source>
        <translation>unbekannt, Teil der Schätzung</translation>
    </message>
    <message>
        <source>, %1 m each</source>
        <translation>, je %1 m</translation>
    </message>
    <message>
        <source>known to %1 m</source>
        <translation>auf %1 m bekannt</translation>
    </message>
    <message>
        <source>Robot %1: %2 links (%3 with mass), %4 moving joints, %5 of them measured; TCP is %6.</source>
        <translation>Roboter %1: %2 Glieder (%3 mit Masse), %4 bewegliche Gelenke, davon %5 gemessen; TCP ist %6.</translation>
    </message>
    <message>
        <source>%1 on %2, mount %3.</source>
        <translation>%1 auf %2, Halter %3.</translation>
    </message>
    <message>
        <source>%1 observations: %2 %3, %4 with images, %5 rejected or excluded; %6.</source>
        <translation>%1 Beobachtungen: %2 %3, %4 mit Bildern, %5 verworfen oder ausgeschlossen; %6.</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>show the target</source>
        <translation>zeigen das Ziel</translation>
    </message>
    <message>
        <source>labelled</source>
        <translation>markiert</translation>
    </message>
    <message>
        <source>Target: %1; %2.</source>
        <translation>Ziel: %1; %2.</translation>
    </message>
    <message>
        <source>Declared noise of one coordinate: %1 %2.</source>
        <translation>Angegebenes Rauschen einer Koordinate: %1 %2.</translation>
    </message>
    <message>
        <source>Observation %1: %2</source>
        <translation>Beobachtung %1: %2</translation>
    </message>
    <message>
        <source>Observation %1 has an image of one camera only; it is not looked for markers.</source>
        <translation>Beobachtung %1 hat ein Bild nur einer Kamera; darin wird nicht nach Markern gesucht.</translation>
    </message>
    <message>
        <source>Joint %1 is outside its limits in %2 observations, first in %3.</source>
        <translation>Gelenk %1 ist in %2 Beobachtungen außerhalb seiner Grenzen, zuerst in %3.</translation>
    </message>
    <message>
        <source>Observation %1: marker %2 lies outside the image.</source>
        <translation>Beobachtung %1: Marker %2 liegt außerhalb des Bilds.</translation>
    </message>
    <message>
        <source>%1 observations have measured torques.</source>
        <translation>%1 Beobachtungen haben gemessene Momente.</translation>
    </message>
    <message>
        <source>Joint %1: measured torques (%2 N m rms) differ from gravity's moments by %3 N m rms; check masses, gravity and units.</source>
        <translation>Gelenk %1: gemessene Momente (%2 N m quadratisches Mittel) weichen von denen der Schwerkraft um %3 N m ab; Massen, Schwerkraft und Einheiten prüfen.</translation>
    </message>
    <message>
        <source>Poses of the flange as the robot's controller tells them: no joints, so that effects of joints are not offered.</source>
        <translation>Posen des Flansches, wie die Steuerung des Roboters sie sagt: keine Gelenke, so dass Effekte von Gelenken nicht angeboten werden.</translation>
    </message>
    <message>
        <source>The noise is not declared; it is estimated where three markers are seen.</source>
        <translation>Das Rauschen ist nicht angegeben; es wird geschätzt, wo drei Marker gesehen werden.</translation>
    </message>
    <message>
        <source>A pose sensor</source>
        <translation>Ein Posensensor</translation>
    </message>
    <message>
        <source>A tracker</source>
        <translation>Ein Tracker</translation>
    </message>
    <message>
        <source>Two cameras</source>
        <translation>Zwei Kameras</translation>
    </message>
    <message>
        <source>poses of a target</source>
        <translation>Posen eines Ziels</translation>
    </message>
    <message>
        <source>the places of its tags are estimated</source>
        <translation>die Plätze seiner Tags werden geschätzt</translation>
    </message>
    <message>
        <source>its points are estimated</source>
        <translation>seine Punkte werden geschätzt</translation>
    </message>
    <message>
        <source>its points are held as described</source>
        <translation>seine Punkte gelten wie beschrieben</translation>
    </message>
    <message>
        <source>Marker %1 does not exist; the session has markers 0 to %2.</source>
        <translation>Marker %1 gibt es nicht; die Sitzung hat die Marker 0 bis %2.</translation>
    </message>
    <message>
        <source>%1: no joint moves %2 without moving %3; a pull at the hand shows nowhere.</source>
        <translation>%1: kein Gelenk bewegt %2, ohne %3 zu bewegen; ein Zug an der Hand zeigt sich nirgends.</translation>
    </message>
    <message>
        <source>%1: no used observation shows marker %2 as a point; label it in both images first.</source>
        <translation>%1: keine benutzte Beobachtung zeigt Marker %2 als Punkt; ihn zuerst in beiden Bildern markieren.</translation>
    </message>
    <message>
        <source>is</source>
        <translation>ist</translation>
    </message>
    <message>
        <source>are</source>
        <translation>sind</translation>
    </message>
    <message>
        <source>Between camera and hand %1 can move, but the session has no angles of it: it is taken to stand at 0. Add it to the joints, or fix it in the robot's file.</source>
        <translation>Zwischen Kamera und Hand kann sich %1 bewegen, aber die Sitzung hat keine Winkel davon: es gilt als auf 0 stehend. Zu den Gelenken nehmen oder in der Datei des Roboters festsetzen.</translation>
    </message>
    <message>
        <source>: are width and height of the cameras swapped?</source>
        <translation>: sind Breite und Höhe der Kameras vertauscht?</translation>
    </message>
    <message>
        <source>; look whether they are px of these cameras, and relabel or exclude them.</source>
        <translation>; nachsehen, ob es px dieser Kameras sind, und sie neu markieren oder ausschließen.</translation>
    </message>
    <message>
        <source>%1: the distance of %2 from %3 tells nothing, as nothing touches %4 and where it stands is a guess; touch it, say how well its place is known (place_sigma), or leave the &lt;apart&gt; out.</source>
        <translation>%1: Der Abstand von %2 und %3 sagt nichts, denn nichts berührt %4, und wo es steht, ist geraten; es berühren, sagen, wie genau der Ort bekannt ist (place_sigma), oder das &lt;apart&gt; weglassen.</translation>
    </message>
    <message>
        <source>%1: nothing says where the fixture %2 is, and nothing touches it; touch it, say where it is, or leave it out.</source>
        <translation>%1: Nichts sagt, wo die Vorrichtung %2 ist, und nichts berührt sie; sie berühren, sagen, wo sie ist, oder sie weglassen.</translation>
    </message>
    <message>
        <source>%1: nothing says where the fixture %2 is, and %3 touch%4 of it do not tell; touch it more often, or say where it is about.</source>
        <translation>%1: nichts sagt, wo die Vorrichtung %2 ist, und %3 Berührung%4 sagt es nicht; sie öfter berühren oder sagen, wo sie ungefähr ist.</translation>
    </message>
    <message>
        <source>es</source>
        <translation>en</translation>
    </message>
    <message>
        <source>; observation %1 would tell most if labelled</source>
        <translation>; am meisten sagte Beobachtung %1, wenn sie markiert wäre</translation>
    </message>
    <message>
        <source>excluded by the user: %1</source>
        <translation>vom Benutzer ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>%1: a fit can bear %2 points, and the target has %3; use one with fewer squares or tags, or name fewer ids.</source>
        <translation>%1: eine Schätzung verträgt %2 Punkte, und das Ziel hat %3; eines mit weniger Feldern oder Tags nehmen oder weniger ids nennen.</translation>
    </message>
    <message>
        <source>%1: &lt;apart&gt; names %2 and %3, which stand on different links; their distance is not one number.</source>
        <translation>%1: &lt;apart&gt; nennt %2 und %3, die auf verschiedenen Gliedern stehen; ihr Abstand ist nicht eine Zahl.</translation>
    </message>
    <message>
        <source>The sensor rides on the hand: what is told is where link %1 is.</source>
        <translation>Der Sensor fährt auf der Hand mit: gesagt wird, wo das Glied %1 ist.</translation>
    </message>
    <message>
        <source>Fewer than three observations show three markers: how the real TCP scatters about the model is not known, and sigma leaves it out.</source>
        <translation>Weniger als drei Beobachtungen zeigen drei Marker: wie der wirkliche TCP um das Modell streut, ist nicht bekannt, und Sigma lässt es aus.</translation>
    </message>
    <message>
        <source>%1: the image has %2 x %3 px, the first of camera %4 has %5 x %6; expected images of one size.</source>
        <translation>%1: das Bild hat %2 x %3 px, das erste der Kamera %4 hat %5 x %6; erwartet werden Bilder einer Größe.</translation>
    </message>
    <message>
        <source>Only %1 poses of the target; 10 to 20 from different sides are better.</source>
        <translation>Nur %1 Posen des Ziels; 10 bis 20 von verschiedenen Seiten sind besser.</translation>
    </message>
    <message>
        <source>The target is turned by at most %1 degrees from pose to pose: focal length and distance can hardly be told apart; tilt it by 30 degrees and more, to all sides.</source>
        <translation>Das Ziel ist von Pose zu Pose um höchstens %1 Grad gedreht: Brennweite und Abstand lassen sich kaum trennen; um 30 Grad und mehr neigen, nach allen Seiten.</translation>
    </message>
    <message>
        <source>Camera %1: the points lie in %2 of %3 parts of the image; the distortion elsewhere is guessed. Bring the target into the corners too.</source>
        <translation>Kamera %1: die Punkte liegen in %2 von %3 Teilen des Bilds; die Verzeichnung anderswo ist geraten. Das Ziel auch in die Ecken bringen.</translation>
    </message>
    <message>
        <source>Camera %1: these poses do not determine all of its numbers; take images from more sides.</source>
        <translation>Kamera %1: diese Posen bestimmen nicht alle ihre Zahlen; Bilder von mehr Seiten aufnehmen.</translation>
    </message>
    <message>
        <source>Camera %1: the focal length is known to %2 px only (%3 %); tilt the target more.</source>
        <translation>Kamera %1: die Brennweite ist nur auf %2 px bekannt (%3 %); das Ziel stärker neigen.</translation>
    </message>
    <message>
        <source>There is no lens model "%1".</source>
        <translation>Ein Linsenmodell "%1" gibt es nicht.</translation>
    </message>
    <message>
        <source>its least squares do not come to an end with the target's shape in them</source>
        <translation>ihre kleinsten Quadrate kommen mit der Form des Ziels darin zu keinem Ende</translation>
    </message>
    <message>
        <source>%1 over %2 along %3 (curvatures in 1/m: %4 along x, %5 along y%6)</source>
        <translation>%1 auf %2 entlang %3 (Krümmungen in 1/m: %4 entlang x, %5 entlang y%6)</translation>
    </message>
    <message>
        <source>, %1 askew</source>
        <translation>, %1 schräg</translation>
    </message>
    <message>
        <source>The tags stand as spacing=%1 has them (gaps of %2 between tags of %3), not spacing=%4 as described; with that the points are %5 off.</source>
        <translation>Die Tags stehen so, wie spacing=%1 es sagt (Lücken von %2 zwischen Tags von %3), nicht spacing=%4 wie beschrieben; damit liegen die Punkte um %5 daneben.</translation>
    </message>
    <message>
        <source>Beside its rows its columns stand %1 % %2 than described, as printers do it that feed paper unevenly.</source>
        <translation>Gegen die Zeilen stehen die Spalten um %1 % %2 als beschrieben, wie bei Druckern, die Papier ungleichmäßig einziehen.</translation>
    </message>
    <message>
        <source>farther apart</source>
        <translation>weiter auseinander</translation>
    </message>
    <message>
        <source>closer together</source>
        <translation>enger beisammen</translation>
    </message>
    <message>
        <source>The board is as described as far as these images tell: bent by less than %1.</source>
        <translation>Das Brett ist wie beschrieben, soweit diese Bilder es sagen: um weniger als %1 gebogen.</translation>
    </message>
    <message>
        <source>The board is not flat: it is bent by %1.</source>
        <translation>Das Brett ist nicht eben: es ist um %1 gebogen.</translation>
    </message>
    <message>
        <source>Its points lie %1 from where they are described (rms), one of them %2%3.</source>
        <translation>Seine Punkte liegen %1 von dort, wo sie beschrieben sind (quadratisches Mittel), einer davon %2%3.</translation>
    </message>
    <message>
        <source>: they were estimated with the cameras</source>
        <translation>: sie wurden mit den Kameras geschätzt</translation>
    </message>
    <message>
        <source>That is more than sigma=%1 m allows; say sigma=free, or look at what the target is.</source>
        <translation>Das ist mehr, als sigma=%1 m erlaubt; sigma=free angeben oder nachsehen, was das Ziel ist.</translation>
    </message>
    <message>
        <source>How large it is images cannot tell: it is known to the %1 of its description alone.</source>
        <translation>Wie groß es ist, können Bilder nicht sagen: bekannt ist es nur auf die %1 seiner Beschreibung.</translation>
    </message>
    <message>
        <source>How large it is images cannot tell: its size as a whole is taken as described, and so are all lengths.</source>
        <translation>Wie groß es ist, können Bilder nicht sagen: seine Größe im Ganzen gilt als die beschriebene, und so alle Längen.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be read: %2.</source>
        <translation>%1: der Ordner lässt sich nicht lesen: %2.</translation>
    </message>
    <message>
        <source>camera %1: %2 images, %3 to %4</source>
        <translation>Kamera %1: %2 Bilder, %3 bis %4</translation>
    </message>
    <message>
        <source>%1: there is no such image or folder.</source>
        <translation>%1: ein solches Bild oder einen solchen Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Images of %1 observations cannot be read, first: %2</source>
        <translation>Bilder von %1 Beobachtungen lassen sich nicht lesen, zuerst: %2</translation>
    </message>
    <message>
        <source>it has no image</source>
        <translation>es hat kein Bild</translation>
    </message>
    <message>
        <source>The board's lengths</source>
        <translation>Die Längen des Bretts</translation>
    </message>
    <message>
        <source>The distances of the cameras</source>
        <translation>Die Abstände der Kameras</translation>
    </message>
    <message>
        <source>The places of the target</source>
        <translation>Die Orte des Ziels</translation>
    </message>
    <message>
        <source>The tracker's points</source>
        <translation>Die Punkte des Trackers</translation>
    </message>
    <message>
        <source>the lengths in &lt;target&gt;</source>
        <translation>die Längen in &lt;target&gt;</translation>
    </message>
    <message>
        <source>the distances between the cameras</source>
        <translation>die Abstände zwischen den Kameras</translation>
    </message>
    <message>
        <source>the xyz of every &lt;target_pose&gt;</source>
        <translation>das xyz jeder &lt;target_pose&gt;</translation>
    </message>
    <message>
        <source>every point</source>
        <translation>jeden Punkt</translation>
    </message>
    <message>
        <source>the target's poses</source>
        <translation>den Posen des Ziels</translation>
    </message>
    <message>
        <source>the flange's poses</source>
        <translation>den Posen des Flansches</translation>
    </message>
    <message>
        <source>all poses</source>
        <translation>allen Posen</translation>
    </message>
    <message>
        <source>quaternions with w last</source>
        <translation>Quaternionen mit w zuletzt</translation>
    </message>
    <message>
        <source>quaternions with w first</source>
        <translation>Quaternionen mit w zuerst</translation>
    </message>
    <message>
        <source>matrices</source>
        <translation>Matrizen</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>a target</source>
        <translation>ein Ziel</translation>
    </message>
    <message>
        <source>a board</source>
        <translation>ein Brett</translation>
    </message>
    <message>
        <source>a body of tags</source>
        <translation>ein Körper von Tags</translation>
    </message>
    <message>
        <source>a tag</source>
        <translation>ein Tag</translation>
    </message>
    <message>
        <source>both cameras</source>
        <translation>beide Kameras</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>die Kamera</translation>
    </message>
    <message>
        <source>two of the cameras</source>
        <translation>zwei der Kameras</translation>
    </message>
    <message>
        <source>The file does not say how the errors of TCP-&gt;Body and of the effects go together (&lt;model_covariance&gt;): sigma takes them as independent and is too large.</source>
        <translation>Die Datei sagt nicht, wie die Fehler von TCP-&gt;Körper und die der Effekte zusammenhängen (&lt;model_covariance&gt;): Sigma nimmt sie als unabhängig und ist zu groß.</translation>
    </message>
    <message>
        <source>slips</source>
        <translation>Verrutschen</translation>
    </message>
    <message>
        <source>drifts</source>
        <translation>Wandern</translation>
    </message>
    <message>
        <source>One camera</source>
        <translation>Eine Kamera</translation>
    </message>
    <message>
        <source>Three cameras</source>
        <translation>Drei Kameras</translation>
    </message>
    <message>
        <source>Four cameras</source>
        <translation>Vier Kameras</translation>
    </message>
    <message>
        <source>Five cameras</source>
        <translation>Fünf Kameras</translation>
    </message>
    <message>
        <source>Six cameras</source>
        <translation>Sechs Kameras</translation>
    </message>
    <message>
        <source>Seven cameras</source>
        <translation>Sieben Kameras</translation>
    </message>
    <message>
        <source>Eight cameras</source>
        <translation>Acht Kameras</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>der Boden</translation>
    </message>
    <message>
        <source>the rotation</source>
        <translation>die Drehung</translation>
    </message>
    <message>
        <source>chessboard, charuco, circles, aprilgrid, grid or tags</source>
        <translation>chessboard, charuco, circles, aprilgrid, grid oder tags</translation>
    </message>
    <message>
        <source>; a</source>
        <translation>; ein</translation>
    </message>
    <message>
        <source>; the sensor's mount and the body can move together</source>
        <translation>; der Halter des Sensors und der Körper können sich zusammen bewegen</translation>
    </message>
    <message>
        <source>N m/rad</source>
        <translation>N m/rad</translation>
    </message>
    <message>
        <source>--mount is not given: the sensor is taken to stand beside the robot (link %1). Where the hand carries it: --mount %2 --tcp %3 (the link on which the target stands).</source>
        <translation>--mount fehlt: Der Sensor steht, so wird angenommen, neben dem Roboter (Glied %1). Wo die Hand ihn trägt: --mount %2 --tcp %3 (das Glied, auf dem das Muster steht).</translation>
    </message>
    <message>
        <source>The target's poses are inverted: they say where the sensor is in the target's frame, where the target in the sensor's is expected; or the sensor is on %1 and the target on %2, which is the same to these numbers.</source>
        <translation>Die Posen des Musters sind umgekehrt: Sie sagen, wo der Sensor im System des Musters ist, wo das Muster in dem des Sensors erwartet wird; oder der Sensor sitzt auf %1 und das Muster auf %2, was für diese Zahlen dasselbe ist.</translation>
    </message>
    <message>
        <source>Invert each &lt;target_pose&gt; in %1 (each pose in the table of the target that it was made of), or convert with --mount %2 --tcp %3.</source>
        <translation>Jede &lt;target_pose&gt; in %1 umkehren (jede Pose in der Tabelle des Musters, aus der sie gemacht wurde), oder convert mit --mount %2 --tcp %3.</translation>
    </message>
    <message>
        <source>The tracker's points are mirrored: two of its axes are exchanged, or one counts the other way, so that its frame is left-handed.</source>
        <translation>Die Punkte des Trackers sind gespiegelt: Zwei seiner Achsen sind vertauscht, oder eine zählt andersherum, so dass sein System linkshändig ist.</translation>
    </message>
    <message>
        <source>Exchange two coordinates of every point in %1 (two columns of the table that it was made of), or export again with right-handed axes.</source>
        <translation>Zwei Koordinaten jedes Punkts in %1 vertauschen (zwei Spalten der Tabelle, aus der sie gemacht wurde), oder noch einmal mit rechtshändigen Achsen exportieren.</translation>
    </message>
    <message>
        <source>Measure it over its whole length and give the right size to the program that found its poses; until then no place of the hand or of a camera is to be trusted (--effects target_scale estimates it with them).</source>
        <translation>Miss es über die ganze Länge und gib dem Programm, das seine Posen sagt, die richtige Größe; bis dahin ist keinem Ort der Hand oder einer Kamera zu trauen (--effects target_scale schätzt sie mit ihnen).</translation>
    </message>
    <message>
        <source>Measure its black square and put the right size into &lt;target&gt;; until then no place of the hand or of a camera is to be trusted.</source>
        <translation>Miss sein schwarzes Quadrat und schreibe die richtige Größe in &lt;target&gt;; bis dahin ist keinem Ort der Hand oder einer Kamera zu trauen.</translation>
    </message>
    <message>
        <source>The noise is not declared; the fit can only say how far the poses are apart.</source>
        <translation>Das Rauschen ist nicht angegeben; die Anpassung kann nur sagen, wie weit die Posen auseinanderliegen.</translation>
    </message>
    <message>
        <source>The noise is not declared; it is estimated from the target's points.</source>
        <translation>Das Rauschen ist nicht angegeben; es wird aus den Punkten des Musters geschätzt.</translation>
    </message>
    <message>
        <source>one file is no image by its name and was left out</source>
        <translation>eine Datei ist ihrem Namen nach kein Bild und wurde ausgelassen</translation>
    </message>
    <message>
        <source>The target's %1 are of %2 m: if millimetres are meant, write %3 into &lt;target&gt;; its lengths are m.</source>
        <translation>Die %1 des Musters messen %2 m: Sind Millimeter gemeint, schreibe %3 in &lt;target&gt;; seine Längen sind m.</translation>
    </message>
    <message>
        <source>%1: %2 points of a program in %3, in its order; where nothing was measured at one of them, take it out.</source>
        <translation>%1: %2 Punkte eines Programms in %3, in dessen Reihenfolge; wo an einem nichts gemessen wurde, nimm ihn heraus.</translation>
    </message>
    <message>
        <source>Left out, as nothing that is read: %1.</source>
        <translation>Ausgelassen, weil nichts davon gelesen wird: %1.</translation>
    </message>
    <message>
        <source>All tags agree with the other layout: write layout="%1" into &lt;target&gt;; as described the board's places are a square aside.</source>
        <translation>Alle Tags passen zur anderen Anordnung: schreibe layout="%1" in &lt;target&gt;; wie beschrieben liegen die Orte auf dem Brett um ein Feld daneben.</translation>
    </message>
    <message>
        <source>%1; what they show fits %2.</source>
        <translation>%1; was sie zeigen, passt zu %2.</translation>
    </message>
    <message>
        <source>points_mirrored: the session has no points of a tracker.</source>
        <translation>points_mirrored: Die Sitzung hat keine Punkte eines Trackers.</translation>
    </message>
    <message>
        <source>What was asked for is reached.</source>
        <translation>Erreicht ist, wonach gefragt wurde.</translation>
    </message>
    <message>
        <source>Nothing is missing that these poses could show.</source>
        <translation>Es fehlt nichts, was diese Posen zeigen könnten.</translation>
    </message>
    <message>
        <source> The hand is known to %1 mm (95 %).</source>
        <translation> Die Hand ist auf %1 mm bekannt (95 %).</translation>
    </message>
    <message>
        <source>What is missing follows the %1 in a form that is not in the catalogue, by odds of %2.</source>
        <translation>Was fehlt, folgt %1 in einer Form, die nicht im Katalog steht (Quote: %2).</translation>
    </message>
    <message>
        <source>The experiment was interrupted between two moves.</source>
        <translation>Das Experiment wurde zwischen zwei Bewegungen unterbrochen.</translation>
    </message>
    <message>
        <source>The experiment was interrupted after a move.</source>
        <translation>Das Experiment wurde nach einer Bewegung unterbrochen.</translation>
    </message>
    <message>
        <source>Nothing was confirmed, so that nothing has moved.</source>
        <translation>Nichts wurde bestätigt, also hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>No further pose was found that the robot can reach without a collision and where the target is seen.</source>
        <translation>Es wurde keine weitere Pose gefunden, die der Roboter ohne Zusammenstoß erreicht und in der das Ziel zu sehen ist.</translation>
    </message>
    <message>
        <source>What is missing: %1, by odds of %2.</source>
        <translation>Es fehlt: %1 (Quote: %2).</translation>
    </message>
    <message>
        <source>is no log of recheck; expected the columns %1.</source>
        <translation>ist kein Protokoll von recheck; erwartet werden die Spalten %1.</translation>
    </message>
    <message>
        <source>has %1 columns, expected %2 at least.</source>
        <translation>hat %1 Spalten; erwartet werden mindestens %2.</translation>
    </message>
    <message>
        <source>expected a time, an observation's number, an e-value and 0 or 1, as recheck --csv writes them; move the file away, and recheck begins a new one.</source>
        <translation>erwartet werden eine Zeit, die Nummer einer Beobachtung, ein E-Wert und 0 oder 1, wie recheck --csv sie schreibt; lege die Datei beiseite, dann beginnt recheck eine neue.</translation>
    </message>
    <message>
        <source>%1 cannot be written; is the disk full?</source>
        <translation>%1 lässt sich nicht schreiben; ist die Platte voll?</translation>
    </message>
    <message>
        <source>Neither the calibration nor the session says where the robot was measured: no pose to recheck in.</source>
        <translation>Weder Kalibrierung noch Sitzung sagt, wo der Roboter gemessen wurde: keine Pose zum Nachprüfen.</translation>
    </message>
    <message>
        <source>%1: was expanded by xacro, with the arguments that it has by itself.</source>
        <translation>%1: wurde von xacro entfaltet, mit den Argumenten, die sie selbst hat.</translation>
    </message>
    <message>
        <source>%1 and %2 cannot be compared: %3.</source>
        <translation>%1 und %2 lassen sich nicht vergleichen: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be compared: its fit finds no answer; run `handsight-cli fit` on it, exclude the observations that it says stand out, and compare again.</source>
        <translation>%1 lässt sich nicht vergleichen: die Anpassung findet keine Antwort; rufe `handsight-cli fit` damit auf, schließe die Beobachtungen aus, die dort auffallen, und vergleiche noch einmal.</translation>
    </message>
    <message>
        <source>A calibration does not say where what is touched stood; name the earlier session of touches in its place.</source>
        <translation>Eine Kalibrierung sagt nicht, wo stand, was berührt wird; nenne an ihrer Stelle die frühere Sitzung mit Berührungen.</translation>
    </message>
    <message>
        <source>%1: a session of touches is compared with one other at a time; name two.</source>
        <translation>%1: eine Sitzung mit Berührungen wird jeweils mit einer anderen verglichen; nenne zwei.</translation>
    </message>
    <message>
        <source>A comparison takes two sessions at least; name another one.</source>
        <translation>Ein Vergleich braucht mindestens zwei Sitzungen; nenne eine weitere.</translation>
    </message>
    <message>
        <source>The model misses what the sessions measured. What the catalogue has and smooth curves of the joints' angles, the same in all, were fitted beside the changes; a change that looks like them is not seen.</source>
        <translation>Das Modell verfehlt, was die Sitzungen gemessen haben. Was der Katalog hat und glatte Kurven der Gelenkwinkel, in allen dieselben, wurden neben den Änderungen angepasst; eine Änderung, die wie sie aussieht, bleibt ungesehen.</translation>
    </message>
    <message>
        <source>; besides, what is there fits %1</source>
        <translation>; außerdem passt, was da ist, zu %1</translation>
    </message>
    <message>
        <source>in a mirror</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>white for black</source>
        <translation>weiß statt schwarz</translation>
    </message>
    <message>
        <source>its tags are there in a mirror and with white for black: the images were turned over and inverted</source>
        <translation>seine Tags sind gespiegelt und weiß statt schwarz zu sehen: die Bilder wurden gewendet und invertiert</translation>
    </message>
    <message>
        <source>its tags are there with white for black: print the board black on white, or invert the images</source>
        <translation>seine Tags sind weiß statt schwarz zu sehen: drucke das Brett schwarz auf weiß oder invertiere die Bilder</translation>
    </message>
    <message>
        <source>its tags can be read in a mirror only: the images (or the print) are turned over, left for right; undo that where they are recorded</source>
        <translation>seine Tags sind nur gespiegelt zu lesen: die Bilder (oder der Druck) sind seitenverkehrt; hebe das dort auf, wo sie aufgenommen werden</translation>
    </message>
    <message>
        <source>The fixture %1 turned by %2 and moved by %3</source>
        <translation>Die Vorrichtung %1 hat sich um %2 gedreht und um %3 bewegt</translation>
    </message>
    <message>
        <source>The probe slipped on the hand by %1</source>
        <translation>Der Taster ist auf der Hand um %1 verrutscht</translation>
    </message>
    <message>
        <source>arm and probe are as they were</source>
        <translation>Arm und Taster sind, wie sie waren</translation>
    </message>
    <message>
        <source>arm and fixtures are as they were</source>
        <translation>Arm und Vorrichtungen sind, wie sie waren</translation>
    </message>
    <message>
        <source>fixtures and probe are as they were</source>
        <translation>Vorrichtungen und Taster sind, wie sie waren</translation>
    </message>
    <message>
        <source>Nothing has changed that these touches show: fixtures, probe and arm are as they were.</source>
        <translation>Nichts hat sich geändert, was diese Berührungen zeigen: Vorrichtungen, Taster und Arm sind, wie sie waren.</translation>
    </message>
    <message>
        <source>What was seen is the same in %1 of %2 observations as in the one before, while the robot moved: right where the hand was held in one place, as in a socket; else the sensor stood still.</source>
        <translation>Was zu sehen war, ist in %1 von %2 Beobachtungen dasselbe wie in der davor, während sich der Roboter bewegte: richtig, wo die Hand an einem Ort gehalten wurde, etwa in einer Pfanne; sonst stand der Sensor still.</translation>
    </message>
    <message>
        <source>Nothing has changed that these poses show: cameras, hands and arms are the same in all sessions.</source>
        <translation>Nichts hat sich geändert, was diese Posen zeigen: Kameras, Hände und Arme sind in allen Sitzungen gleich.</translation>
    </message>
    <message>
        <source>%1: %2 single wrong points are left out.</source>
        <translation>%1: %2 einzelne falsche Punkte sind ausgelassen.</translation>
    </message>
    <message>
        <source>%1: between %2 and %3</source>
        <translation>%1: zwischen %2 und %3</translation>
    </message>
    <message>
        <source>shift along %1 at %2</source>
        <translation>Versatz längs %1 an %2</translation>
    </message>
    <message>
        <source>turn about %1 at %2</source>
        <translation>Drehung um %1 an %2</translation>
    </message>
    <message>
        <source>The bag has several cameras (%1); each has a session in the collection. --camera chooses one of them.</source>
        <translation>Der Bag hat mehrere Kameras (%1); jede hat eine Sitzung in der Sammlung. --camera wählt eine davon.</translation>
    </message>
    <message>
        <source>The bag has several targets in /tf (%1); each has a session in the collection. --target-frame chooses one of them.</source>
        <translation>Der Bag hat mehrere Ziele in /tf (%1); jedes hat eine Sitzung in der Sammlung. --target-frame wählt eines davon.</translation>
    </message>
    <message>
        <source>The cameras' frame %1 is on the link %2, which is taken for what carries them (--mount says otherwise).</source>
        <translation>Das Koordinatensystem der Kameras %1 sitzt am Glied %2; das gilt als ihr Träger (--mount sagt es anders).</translation>
    </message>
    <message>
        <source>That is on the hand %1: the target is taken to stand beside the robot (link %2).</source>
        <translation>Das ist an der Hand %1: Das Ziel gilt als neben dem Roboter stehend (Glied %2).</translation>
    </message>
    <message>
        <source>by the user</source>
        <translation>vom Benutzer</translation>
    </message>
    <message>
        <source>beyond the threshold</source>
        <translation>jenseits der Schwelle</translation>
    </message>
    <message>
        <source>The target's poses are inverted: they say where the sensor is in the target's frame, where the target in the sensor's is expected%1, which is the same to these numbers.</source>
        <translation>Die Posen des Ziels sind invertiert: sie sagen, wo der Sensor im System des Ziels ist, erwartet wird das Ziel in dem des Sensors%1, was für diese Zahlen dasselbe ist.</translation>
    </message>
    <message>
        <source>Convert %1 --eye-on-base, or invert each &lt;target_pose&gt; in %2 (each pose in the table of the target that it was made of).</source>
        <translation>Wandle %1 --eye-on-base um, oder kehre jede &lt;target_pose&gt; in %2 um (jede Pose der Tabelle des Ziels, aus der sie gemacht wurde).</translation>
    </message>
    <message>
        <source>To find where tip and fixtures are takes at least so many touches more, each with the hand turned otherwise: %1.</source>
        <translation>Um zu finden, wo Spitze und Vorrichtungen sind, braucht es mindestens so viele Berührungen mehr, jede mit anders gedrehter Hand: %1.</translation>
    </message>
    <message>
        <source>As many numbers were read as are asked for: how exact they are cannot be known. Touch more, or say how exactly a touch tells (sigma).</source>
        <translation>Es wurden so viele Zahlen gelesen, wie gefragt sind: wie genau sie sind, lässt sich nicht erkennen. Berühre öfter, oder sage, wie genau eine Berührung ist (sigma).</translation>
    </message>
    <message>
        <source>Touch the same fixtures more often, with the hand turned about more than one axis.</source>
        <translation>Berühre dieselben Vorrichtungen öfter, mit um mehr als eine Achse gedrehter Hand.</translation>
    </message>
</context>
<context>
    <name>errors</name>
    <!-- What is wrong with a file, and the forms that such sentences have: translated where an error is shown. -->
    <message>
        <source>has %1 numbers, expected one for each of the %2 &lt;joints&gt; in every pose.</source>
        <translation>hat %1 Zahlen, erwartet eine für jedes der %2 &lt;joints&gt; in jeder Pose.</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: the file %2: %3.</source>
        <translation>%1: die Datei %2: %3.</translation>
    </message>
    <message>
        <source>cannot be written, and is as it was</source>
        <translation>lässt sich nicht schreiben und ist, wie sie war</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>is longer than 1 GiB</source>
        <translation>ist länger als 1 GiB</translation>
    </message>
    <message>
        <source>A collection of several sessions is not written as one; change and save its sessions one by one.</source>
        <translation>Eine Sammlung mehrerer Sitzungen wird nicht als eine geschrieben; ändern und speichern Sie ihre Sitzungen einzeln.</translation>
    </message>
    <message>
        <source>the file holds bytes that are not UTF-8, expected XML saved as UTF-8.</source>
        <translation>die Datei enthält Bytes, die kein UTF-8 sind; erwartet wird XML, als UTF-8 gespeichert.</translation>
    </message>
    <message>
        <source>holds bytes that are not UTF-8, expected UTF-8 text.</source>
        <translation>enthält Bytes, die kein UTF-8 sind; erwartet wird Text in UTF-8.</translation>
    </message>
    <message>
        <source>the file holds a zero byte, expected XML, which is text.</source>
        <translation>die Datei enthält ein Nullbyte; erwartet wird XML, also Text.</translation>
    </message>
    <message>
        <source>the file is empty, expected well-formed XML.</source>
        <translation>die Datei ist leer; erwartet wird wohlgeformtes XML.</translation>
    </message>
    <message>
        <source>%1, expected well-formed XML.</source>
        <translation>%1; erwartet wird wohlgeformtes XML.</translation>
    </message>
    <message>
        <source>an element is closed by another name or not at all</source>
        <translation>ein Element wird mit anderem Namen oder gar nicht geschlossen</translation>
    </message>
    <message>
        <source>an attribute stands twice or is not written as name="value"</source>
        <translation>ein Attribut steht zweimal da oder ist nicht als name="wert" geschrieben</translation>
    </message>
    <message>
        <source>a comment is not closed</source>
        <translation>ein Kommentar ist nicht geschlossen</translation>
    </message>
    <message>
        <source>a text does not end</source>
        <translation>ein Text endet nicht</translation>
    </message>
    <message>
        <source>elements are nested too deeply</source>
        <translation>Elemente sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>an element is broken off or misplaced</source>
        <translation>ein Element ist abgebrochen oder steht am falschen Ort</translation>
    </message>
    <message>
        <source>an XML declaration is misplaced or not closed</source>
        <translation>eine XML-Deklaration steht am falschen Ort oder ist nicht geschlossen</translation>
    </message>
    <message>
        <source>there is no element in the file, expected &lt;%1&gt;.</source>
        <translation>in der Datei ist kein Element; erwartet wird &lt;%1&gt;.</translation>
    </message>
    <message>
        <source>the outermost element is &lt;%1&gt;, expected &lt;%2&gt;.</source>
        <translation>das äußerste Element ist &lt;%1&gt;; erwartet wird &lt;%2&gt;.</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is a second outermost element, expected only &lt;%2&gt;.</source>
        <translation>&lt;%1&gt; ist ein zweites äußerstes Element; erwartet wird nur &lt;%2&gt;.</translation>
    </message>
    <message>
        <source>the text %1 stands outside of the outermost element, expected only comments there.</source>
        <translation>der Text %1 steht außerhalb des äußersten Elements; erwartet werden dort nur Kommentare.</translation>
    </message>
    <message>
        <source>a closing tag too many stands after what begins here, expected well-formed XML.</source>
        <translation>nach dem, was hier beginnt, steht ein schließendes Tag zu viel; erwartet wird wohlgeformtes XML.</translation>
    </message>
    <message>
        <source>has no attribute %1, expected %2="...".</source>
        <translation>hat kein Attribut %1; erwartet wird %2="...".</translation>
    </message>
    <message>
        <source>has no element &lt;%1&gt;, expected one.</source>
        <translation>hat kein Element &lt;%1&gt;; erwartet wird eines.</translation>
    </message>
    <message>
        <source>stands a second time in &lt;%1&gt;, expected once.</source>
        <translation>steht ein zweites Mal in &lt;%1&gt;; erwartet wird einmal.</translation>
    </message>
    <message>
        <source>has %1 bytes in %2 (%3), expected at most %4.</source>
        <translation>hat %1 Bytes in %2 (%3); erwartet werden höchstens %4.</translation>
    </message>
    <message>
        <source>%1, expected version="1", the only one that this program reads.</source>
        <translation>%1; erwartet wird version="1", die einzige, die dieses Programm liest.</translation>
    </message>
    <message>
        <source>%1, expected a name.</source>
        <translation>%1; erwartet wird ein Name.</translation>
    </message>
    <message>
        <source>%1, expected a positive number.</source>
        <translation>%1; erwartet wird eine positive Zahl.</translation>
    </message>
    <message>
        <source>%1, expected one of: %2.</source>
        <translation>%1; erwartet wird eines von: %2.</translation>
    </message>
    <message>
        <source>%1, expected an integer %2.</source>
        <translation>%1; erwartet wird eine ganze Zahl %2.</translation>
    </message>
    <message>
        <source>of at least %1</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>has %1 in %2, expected %3 finite numbers%4.</source>
        <translation>hat %1 in %2; erwartet werden %3 endliche Zahlen%4.</translation>
    </message>
    <message>
        <source>has %1 numbers in %2, expected %3.</source>
        <translation>hat %1 Zahlen in %2; erwartet werden %3.</translation>
    </message>
    <message>
        <source>has %1 numbers, expected %2%3.</source>
        <translation>hat %1 Zahlen; erwartet werden %2%3.</translation>
    </message>
    <message>
        <source>has %1, expected %2 finite numbers%3.</source>
        <translation>hat %1; erwartet werden %2 endliche Zahlen%3.</translation>
    </message>
    <message>
        <source>has the number %1%2, expected a number from %3 to %4.</source>
        <translation>hat die Zahl %1%2; erwartet wird eine von %3 bis %4.</translation>
    </message>
    <message>
        <source>'&amp;' stands alone, expected &amp;amp; for the character itself.</source>
        <translation>'&amp;' steht allein; für das Zeichen selbst wird &amp;amp; erwartet.</translation>
    </message>
    <message>
        <source>the mesh is of a kind that is not read, expected an STL, an OBJ or a Collada (.dae) file.</source>
        <translation>das Netz ist von einer Art, die nicht gelesen wird; erwartet wird eine STL-, OBJ- oder Collada-Datei (.dae).</translation>
    </message>
    <message>
        <source>has %1, expected finite numbers.</source>
        <translation>hat %1; erwartet werden endliche Zahlen.</translation>
    </message>
    <message>
        <source>has %1 numbers, expected %2.</source>
        <translation>hat %1 Zahlen; erwartet werden %2.</translation>
    </message>
    <message>
        <source>names %1, expected a &lt;%2&gt; of the file.</source>
        <translation>nennt %1; erwartet wird ein &lt;%2&gt; der Datei.</translation>
    </message>
    <message>
        <source>turns about no axis, expected one that is not zero.</source>
        <translation>dreht um keine Achse; erwartet wird eine, die nicht null ist.</translation>
    </message>
    <message>
        <source>is one of too many nodes within nodes, expected at most %1 deep.</source>
        <translation>ist einer von zu vielen Knoten in Knoten; erwartet werden höchstens %1 ineinander.</translation>
    </message>
    <message>
        <source>has no points, expected an &lt;input&gt; of VERTEX whose &lt;vertices&gt; have a POSITION.</source>
        <translation>hat keine Punkte; erwartet wird ein &lt;input&gt; VERTEX, dessen &lt;vertices&gt; eine POSITION haben.</translation>
    </message>
    <message>
        <source>has a point that is not finite or too far away, expected points of a robot's link.</source>
        <translation>hat einen Punkt, der nicht endlich oder zu weit weg ist; erwartet werden Punkte eines Roboterglieds.</translation>
    </message>
    <message>
        <source>names the point %1, expected one of the %2 points, from 0.</source>
        <translation>nennt den Punkt %1; erwartet wird einer der %2 Punkte, von 0 an.</translation>
    </message>
    <message>
        <source>has %1 corners, expected as many as its faces have together.</source>
        <translation>hat %1 Ecken; erwartet werden so viele, wie seine Flächen zusammen haben.</translation>
    </message>
    <message>
        <source>makes more than %1 triangles, expected a simpler mesh.</source>
        <translation>ergibt mehr als %1 Dreiecke; erwartet wird ein einfacheres Netz.</translation>
    </message>
    <message>
        <source>the mesh has %1 MB, expected at most %2.</source>
        <translation>das Netz hat %1 MB; erwartet werden höchstens %2.</translation>
    </message>
    <message>
        <source>the mesh has no triangle, expected at least one.</source>
        <translation>das Netz hat kein Dreieck; erwartet wird mindestens eines.</translation>
    </message>
    <message>
        <source>has lower=%1 above upper=%2, expected lower &lt;= upper.</source>
        <translation>hat lower=%1 über upper=%2; erwartet wird lower &lt;= upper.</translation>
    </message>
    <message>
        <source>is a zero vector, expected the direction of the joint's axis.</source>
        <translation>ist ein Nullvektor; erwartet wird die Richtung der Gelenkachse.</translation>
    </message>
    <message>
        <source>has value="%1", a negative mass, expected at least 0 kg.</source>
        <translation>hat value="%1", eine negative Masse; erwartet werden mindestens 0 kg.</translation>
    </message>
    <message>
        <source>has the name %1, which line %2 has already given, expected another name.</source>
        <translation>hat den Namen %1, den Zeile %2 schon vergeben hat; erwartet wird ein anderer.</translation>
    </message>
    <message>
        <source>%1 has the %2 link %3, expected the name of a link in the file.</source>
        <translation>%1 hat das %2-Glied %3; erwartet wird der Name eines Gliedes in der Datei.</translation>
    </message>
    <message>
        <source>%1 carries link %2, which joint %3 carries already, expected one parent for each link.</source>
        <translation>%1 trägt das Glied %2, das Gelenk %3 schon trägt; erwartet wird ein einziges Gelenk über jedem Glied.</translation>
    </message>
    <message>
        <source>has no &lt;link&gt;, expected at least one.</source>
        <translation>hat kein &lt;link&gt;; erwartet wird mindestens eines.</translation>
    </message>
    <message>
        <source>has a joint above each of its links, a cycle, expected one root link without a parent.</source>
        <translation>hat über jedem Glied ein Gelenk, also einen Kreis; erwartet wird ein Wurzelglied ohne Gelenk darüber.</translation>
    </message>
    <message>
        <source>%1 is part of a cycle or hangs on one, expected a tree that starts at the root link.</source>
        <translation>%1 ist Teil eines Kreises oder hängt an einem; erwartet wird ein Baum, der beim Wurzelglied beginnt.</translation>
    </message>
    <message>
        <source>is of type %1, which has several coordinates and is not supported, expected fixed, revolute, continuous or prismatic.</source>
        <translation>ist vom Typ %1, der mehrere Koordinaten hat und nicht geht; erwartet wird fixed, revolute, continuous oder prismatic.</translation>
    </message>
    <message>
        <source>has both quaternion and rpy, expected one of the two.</source>
        <translation>hat quaternion und rpy; erwartet wird eines von beiden.</translation>
    </message>
    <message>
        <source>has a quaternion of length %1, expected "x y z w" of length 1.</source>
        <translation>hat eine Quaternion der Länge %1; erwartet wird "x y z w" der Länge 1.</translation>
    </message>
    <message>
        <source>has id="%1" a second time, expected each id once.</source>
        <translation>hat id="%1" ein zweites Mal; erwartet wird jede id einmal.</translation>
    </message>
    <message>
        <source>has time="%1" after %2 of the observation before, expected times that do not go back.</source>
        <translation>hat time="%1" nach %2 der Beobachtung davor; erwartet werden Zeiten, die nicht zurückgehen.</translation>
    </message>
    <message>
        <source>holds no observation, expected at least one &lt;observation&gt;.</source>
        <translation>enthält keine Beobachtung; erwartet wird mindestens eine &lt;observation&gt;.</translation>
    </message>
    <message>
        <source>has no &lt;observations&gt;, so there is no observation, expected at least one.</source>
        <translation>hat kein &lt;observations&gt;, also keine Beobachtung; erwartet wird mindestens eine.</translation>
    </message>
    <message>
        <source>which the robot does not have</source>
        <translation>das der Roboter nicht hat</translation>
    </message>
    <message>
        <source>which is fixed</source>
        <translation>das fest ist</translation>
    </message>
    <message>
        <source>which follows other joints (&lt;mimic&gt;)</source>
        <translation>das anderen Gelenken folgt (&lt;mimic&gt;)</translation>
    </message>
    <message>
        <source>%1=%2 is no link of the robot, expected the name of a link in %3.</source>
        <translation>%1=%2 ist kein Glied des Roboters; erwartet wird der Name eines Gliedes in %3.</translation>
    </message>
    <message>
        <source>names joint %1 a second time, expected each joint once.</source>
        <translation>nennt Gelenk %1 ein zweites Mal; erwartet wird jedes einmal.</translation>
    </message>
    <message>
        <source>names no joint, expected those that the observations' vectors hold.</source>
        <translation>nennt kein Gelenk; erwartet werden die, die in den Vektoren der Beobachtungen stehen.</translation>
    </message>
    <message>
        <source>has neither &lt;stereo&gt; nor &lt;tracker&gt; nor &lt;cameras&gt; nor &lt;pose_sensor&gt; nor &lt;touch&gt;, expected one of them.</source>
        <translation>hat weder &lt;stereo&gt; noch &lt;tracker&gt; noch &lt;cameras&gt; noch &lt;pose_sensor&gt; noch &lt;touch&gt;; erwartet wird eines davon.</translation>
    </message>
    <message>
        <source>has index="%1" a second time in its observation, expected each marker once.</source>
        <translation>hat index="%1" in seiner Beobachtung ein zweites Mal; erwartet wird jeder Marker einmal.</translation>
    </message>
    <message>
        <source>has no point, expected point="x y z" as this is a tracker session.</source>
        <translation>hat keinen Punkt; erwartet wird point="x y z", denn dies ist eine Sitzung mit Tracker.</translation>
    </message>
    <message>
        <source>has %1=%2, expected %3.</source>
        <translation>hat %1=%2; erwartet wird %3.</translation>
    </message>
    <message>
        <source>has no translation, expected the two cameras apart: without a baseline there is no depth.</source>
        <translation>hat keine Verschiebung; erwartet werden zwei Kameras mit Abstand: ohne Basis keine Tiefe.</translation>
    </message>
    <message>
        <source>There are %1 %2 for %3 %4; each instant needs one of each, in the same order.</source>
        <translation>Es sind %1 %2 für %3 %4; jeder Zeitpunkt braucht von jedem eines, in derselben Reihenfolge.</translation>
    </message>
    <message>
        <source>There are %1 %2 and %3 %4; expected one for each, in the order of the images' numbers. The first has the number %5, the last %6.</source>
        <translation>Es sind %1 %2 und %3 %4; erwartet wird eines für jedes, in der Reihenfolge der Bildnummern. Das erste hat die Nummer %5, das letzte %6.</translation>
    </message>
    <message>
        <source>poses of the flange</source>
        <translation>Posen des Flansches</translation>
    </message>
    <message>
        <source>lines of joint angles</source>
        <translation>Zeilen mit Gelenkwinkeln</translation>
    </message>
    <message>
        <source>poses of the target</source>
        <translation>Posen des Ziels</translation>
    </message>
    <message>
        <source>pairs of images</source>
        <translation>Bildpaare</translation>
    </message>
    <message>
        <source>instants with images</source>
        <translation>Zeitpunkte mit Bildern</translation>
    </message>
    <message>
        <source>There are images of %1 cameras and a calibration of %2; each camera needs both.</source>
        <translation>Es sind Bilder von %1 Kameras da und eine Kalibrierung von %2; jede Kamera braucht beides.</translation>
    </message>
    <message>
        <source>A session needs at least one observation; there is no pose.</source>
        <translation>Eine Sitzung braucht mindestens eine Beobachtung; es ist keine Pose da.</translation>
    </message>
    <message>
        <source>it has no entries with names</source>
        <translation>sie hat keine Einträge mit Namen</translation>
    </message>
    <message>
        <source>it holds a zero byte</source>
        <translation>sie enthält ein Nullbyte</translation>
    </message>
    <message>
        <source>it is no JSON object</source>
        <translation>sie ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>it has %1 MB</source>
        <translation>sie hat %1 MB</translation>
    </message>
    <message>
        <source>it is no matrix</source>
        <translation>sie ist keine Matrix</translation>
    </message>
    <message>
        <source>it holds something that is no number</source>
        <translation>sie enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>%1: holds neither a camera (M1, K1 or cameraMatrix1) nor numbered poses (4x4, or R_1 and t_1); write poses as a table, in each row x y z and a turn.</source>
        <translation>%1: enthält weder eine Kamera (M1, K1 oder cameraMatrix1) noch nummerierte Posen (4x4, oder R_1 und t_1); schreibe Posen als Tabelle, in jeder Zeile x y z und eine Drehung.</translation>
    </message>
    <message>
        <source>left camera matrix (M1, K1 or cameraMatrix1)</source>
        <translation>linke Kameramatrix (M1, K1 oder cameraMatrix1)</translation>
    </message>
    <message>
        <source>right camera matrix (M2, K2 or cameraMatrix2)</source>
        <translation>rechte Kameramatrix (M2, K2 oder cameraMatrix2)</translation>
    </message>
    <message>
        <source>The images are %1 x %2 px, the calibration of the %3 camera is of %4 x %5 px: name the calibration of these images, or images of this size.</source>
        <translation>Die Bilder haben %1 x %2 px, die Kalibrierung der Kamera (%3) ist von %4 x %5 px: nenne die Kalibrierung dieser Bilder oder Bilder dieser Größe.</translation>
    </message>
    <message>
        <source>%1 is %2 x %3, the camera says %4 x %5; use the images that the camera was calibrated with.</source>
        <translation>%1 ist %2 x %3, die Kamera sagt %4 x %5; nimm die Bilder, mit denen die Kamera kalibriert wurde.</translation>
    </message>
    <message>
        <source>The calibration cannot be written: %1 is not finite; the observations do not determine it. Look at the session with check and diagnose.</source>
        <translation>Die Kalibrierung lässt sich nicht schreiben: %1 ist nicht endlich; die Beobachtungen bestimmen es nicht. Sieh nach, was an der Sitzung auffällt.</translation>
    </message>
    <message>
        <source>TCP-&gt;Body or its covariance</source>
        <translation>TCP-&gt;Body oder seine Kovarianz</translation>
    </message>
    <message>
        <source>the mount or its covariance</source>
        <translation>der Kamerasitz oder seine Kovarianz</translation>
    </message>
    <message>
        <source>the scatter of the TCP</source>
        <translation>die Streuung des TCP</translation>
    </message>
    <message>
        <source>the covariance of the effects</source>
        <translation>die Kovarianz der Ursachen</translation>
    </message>
    <message>
        <source>a grid of circles needs at least 6 of them, for example columns="4" rows="11".</source>
        <translation>ein Gitter aus Kreisen braucht mindestens 6, zum Beispiel columns="4" rows="11".</translation>
    </message>
    <message>
        <source>a chessboard needs at least 6 inner corners, for example columns="3" rows="2".</source>
        <translation>ein Schachbrett braucht mindestens 6 innere Ecken, zum Beispiel columns="3" rows="2".</translation>
    </message>
    <message>
        <source>its markers of %1 m do not fit into its squares of %2 m.</source>
        <translation>seine Tags von %1 m passen nicht in seine Felder von %2 m.</translation>
    </message>
    <message>
        <source>tags need the numbers that are used, for example ids="3 7 9".</source>
        <translation>Tags brauchen die Nummern, die benutzt werden, zum Beispiel ids="3 7 9".</translation>
    </message>
    <message>
        <source>the tag %1 is named twice; every id once.</source>
        <translation>der Tag %1 ist zweimal genannt; jede Nummer einmal.</translation>
    </message>
    <message>
        <source>the tag %1 is not in %2, which has 0 to %3.</source>
        <translation>den Tag %1 gibt es in %2 nicht; dort sind 0 bis %3.</translation>
    </message>
    <message>
        <source>it has %1 columns and %2 rows; expected %3 to %4 of each.</source>
        <translation>es hat %1 Spalten und %2 Zeilen; erwartet werden je %3 bis %4.</translation>
    </message>
    <message>
        <source>it has %1 points; expected at most %2.</source>
        <translation>es hat %1 Punkte; erwartet werden höchstens %2.</translation>
    </message>
    <message>
        <source>the header names %1 twice, expected each column once.</source>
        <translation>die Überschrift nennt %1 zweimal; erwartet wird jede Spalte einmal.</translation>
    </message>
    <message>
        <source>the header has no column %1, expected one for each joint of the session.</source>
        <translation>die Überschrift hat keine Spalte %1; erwartet wird eine für jedes Gelenk der Sitzung.</translation>
    </message>
    <message>
        <source>%1 stands in column %2, expected a finite number such as 0.5.</source>
        <translation>%1 steht in Spalte %2; erwartet wird eine endliche Zahl wie 0.5.</translation>
    </message>
    <message>
        <source>%1 stands in column %2, expected a number from %3 to %4.</source>
        <translation>%1 steht in Spalte %2; erwartet wird eine Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>the line has %1 columns, expected %2.</source>
        <translation>die Zeile hat %1 Spalten; erwartet werden %2.</translation>
    </message>
    <message>
        <source>there is no pose in the file, expected a line of joint positions for each.</source>
        <translation>in der Datei ist keine Pose; erwartet wird für jede eine Zeile mit Gelenkwinkeln.</translation>
    </message>
    <message>
        <source>one finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a positive number</source>
        <translation>eine positive Zahl</translation>
    </message>
    <message>
        <source>The images of camera %1 are %2 x %3 px, and camera %4 of the session has %5 x %6: they are another camera's, or were scaled; name images of the session's cameras.</source>
        <translation>Die Bilder der Kamera %1 sind %2 x %3 px, und Kamera %4 der Sitzung hat %5 x %6: sie sind von einer anderen Kamera oder wurden skaliert; nenne Bilder der Kameras der Sitzung.</translation>
    </message>
    <message>
        <source>Camera %1 of the session has the skew %2, which a calibration by images does not know; set it to 0.</source>
        <translation>Kamera %1 der Sitzung hat die Scherung %2, die eine Kalibrierung aus Bildern nicht kennt; setze sie auf 0.</translation>
    </message>
    <message>
        <source>There are board images of %1 %2 (%3), and the session has %4 (%5): name a folder for each of its cameras.</source>
        <translation>Es gibt Bilder eines Bretts von %1 %2 (%3), und die Sitzung hat %4 (%5): nenne einen Ordner für jede ihrer Kameras.</translation>
    </message>
    <message>
        <source>The target is found in none of the board images; look at one and at what --target says of it.</source>
        <translation>Das Ziel ist in keinem der Bilder des Bretts zu finden; sieh dir eines an, und was --target davon sagt.</translation>
    </message>
    <message>
        <source>These board images do not determine the cameras' numbers; take 10 to 20 of each camera, tilted to all sides, and of several cameras at the same moments.</source>
        <translation>Diese Bilder des Bretts bestimmen die Zahlen der Kameras nicht; nimm 10 bis 20 von jeder Kamera auf, nach allen Seiten gekippt, und von mehreren Kameras zu denselben Zeitpunkten.</translation>
    </message>
    <message>
        <source>The target was found with at least %1 points in %2 of the images of camera %3; expected at least 3, better 10 and more, from different sides.</source>
        <translation>Das Ziel wurde mit mindestens %1 Punkten in %2 der Bilder von Kamera %3 gefunden; erwartet werden mindestens 3, besser 10 und mehr, von verschiedenen Seiten.</translation>
    </message>
    <message>
        <source>No focal length was found with which the images of camera %1 fit together; expected images of one flat target from several sides, and the target as it was described.</source>
        <translation>Es fand sich keine Brennweite, mit der die Bilder von Kamera %1 zusammenpassen; erwartet werden Bilder eines ebenen Ziels von mehreren Seiten und das Ziel, wie es beschrieben wurde.</translation>
    </message>
    <message>
        <source>Camera %1 saw the target in no image that was taken together with one of the other cameras; expected images of the same moment, or a run with the images of %2 alone.</source>
        <translation>Kamera %1 sah das Ziel in keinem Bild, das zugleich mit einer der anderen Kameras aufgenommen wurde; erwartet werden Bilder desselben Zeitpunkts, oder ein Lauf mit den Bildern von %2 allein.</translation>
    </message>
    <message>
        <source>%1 and %2: both are moment %3 of camera %4 by their names; name files so that only the number of the moment changes, or give each camera a folder.</source>
        <translation>%1 und %2: beide sind nach ihren Namen Zeitpunkt %3 der Kamera %4; nenne Dateien so, dass sich nur die Nummer des Zeitpunkts ändert, oder gib jeder Kamera einen Ordner.</translation>
    </message>
    <message>
        <source>No images were found; expected folders or files of PNG, JPEG, TIFF, PGM or BMP.</source>
        <translation>Es wurden keine Bilder gefunden; erwartet werden Ordner oder Dateien in PNG, JPEG, TIFF, PGM oder BMP.</translation>
    </message>
    <message>
        <source>The names of the images speak of %1 cameras (%2, %3, ...); expected at most %4.</source>
        <translation>Die Namen der Bilder sprechen von %1 Kameras (%2, %3, ...); erwartet werden höchstens %4.</translation>
    </message>
    <message>
        <source>is a session already, use it as it is</source>
        <translation>ist schon eine Sitzung, nimm sie, wie sie ist</translation>
    </message>
    <message>
        <source>is an SDF of Gazebo; name the URDF of the robot</source>
        <translation>ist ein SDF von Gazebo; nenne die URDF des Roboters</translation>
    </message>
    <message>
        <source>is XML of a kind that is not known</source>
        <translation>ist XML einer unbekannten Art</translation>
    </message>
    <message>
        <source>is YAML of a kind that is not known</source>
        <translation>ist YAML einer unbekannten Art</translation>
    </message>
    <message>
        <source>is a table whose columns are neither joints of the robot nor places (x y z); write a header, or name the columns with --table-columns</source>
        <translation>ist eine Tabelle, deren Spalten weder Gelenke des Roboters noch Orte (x y z) sind; schreibe eine Kopfzeile oder nenne die Spalten mit --table-columns</translation>
    </message>
    <message>
        <source>holds a session already, use it as it is</source>
        <translation>enthält schon eine Sitzung, nimm sie, wie sie ist</translation>
    </message>
    <message>
        <source>is a folder without images, without files of poses and without a bag</source>
        <translation>ist ein Ordner ohne Bilder, ohne Dateien von Posen und ohne Bag</translation>
    </message>
    <message>
        <source>--angles %1: no table of poses here has %2 numbers for a turn; leave it out.</source>
        <translation>--angles %1: keine Tabelle von Posen hat hier %2 Zahlen für eine Drehung; lass es weg.</translation>
    </message>
    <message>
        <source>is no text</source>
        <translation>ist kein Text</translation>
    </message>
    <message>
        <source>is a text of a kind that is not known</source>
        <translation>ist ein Text einer unbekannten Art</translation>
    </message>
    <message>
        <source>%1 is %2, and %3 is one too; name one of them.</source>
        <translation>%1 ist %2, und %3 ist es auch; nenne eine davon.</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>eine andere Datei</translation>
    </message>
    <message>
        <source>the robot's URDF</source>
        <translation>die URDF des Roboters</translation>
    </message>
    <message>
        <source>a folder of images</source>
        <translation>ein Ordner mit Bildern</translation>
    </message>
    <message>
        <source>a table of joint readings</source>
        <translation>eine Tabelle von Gelenkwerten</translation>
    </message>
    <message>
        <source>a table of poses</source>
        <translation>eine Tabelle von Posen</translation>
    </message>
    <message>
        <source>a table of points</source>
        <translation>eine Tabelle von Punkten</translation>
    </message>
    <message>
        <source>samples of easy_handeye</source>
        <translation>Messungen von easy_handeye</translation>
    </message>
    <message>
        <source>a calibration of OpenCV</source>
        <translation>eine Kalibrierung von OpenCV</translation>
    </message>
    <message>
        <source>a camera_info of ROS</source>
        <translation>eine camera_info von ROS</translation>
    </message>
    <message>
        <source>a camchain of Kalibr</source>
        <translation>eine Camchain von Kalibr</translation>
    </message>
    <message>
        <source>the four of a fisheye</source>
        <translation>den vier eines Fischauges</translation>
    </message>
    <message>
        <source>eight (k1 k2 p1 p2 k3 k4 k5 k6)</source>
        <translation>acht (k1 k2 p1 p2 k3 k4 k5 k6)</translation>
    </message>
    <message>
        <source>five (k1 k2 p1 p2 k3)</source>
        <translation>fünf (k1 k2 p1 p2 k3)</translation>
    </message>
    <message>
        <source>%1 and %2: neither names the distance of the cameras (projection_matrix[3] is 0); calibrate them as a stereo pair, or name OpenCV's or Kalibr's stereo file too.</source>
        <translation>%1 und %2: keine nennt den Abstand der Kameras (projection_matrix[3] ist 0); kalibriere sie als Stereopaar, oder nenne auch die Stereodatei von OpenCV oder Kalibr.</translation>
    </message>
    <message>
        <source>The images are %1 x %2 px and the calibration of the %3 camera is of %4 x %5 px, its centre at %6, %7: the images were turned by a quarter after it was calibrated; turn them back.</source>
        <translation>Die Bilder sind %1 x %2 px, und die Kalibrierung der Kamera %3 ist von %4 x %5 px, ihre Mitte bei %6, %7: die Bilder wurden danach um ein Viertel gedreht; drehe sie zurück.</translation>
    </message>
    <message>
        <source>it is not plain CDR</source>
        <translation>es ist kein schlichtes CDR</translation>
    </message>
    <message>
        <source>a list is longer than the message</source>
        <translation>eine Liste ist länger als die Nachricht</translation>
    </message>
    <message>
        <source>the message ends too early</source>
        <translation>die Nachricht endet zu früh</translation>
    </message>
    <message>
        <source>the image ends too early</source>
        <translation>das Bild endet zu früh</translation>
    </message>
    <message>
        <source>There is no robot; name its URDF with --robot, or a table of its flange's poses.</source>
        <translation>Es ist kein Roboter dabei; nenne seine URDF mit --robot, oder eine Tabelle der Posen seines Flansches.</translation>
    </message>
    <message>
        <source>There are no joint readings; name a table (CSV) of them, a column a joint.</source>
        <translation>Es sind keine Gelenkwerte dabei; nenne eine Tabelle (CSV) davon, eine Spalte je Gelenk.</translation>
    </message>
    <message>
        <source>There is nothing that a sensor measured: no images, no points, no poses of a target. Name their folder or file too.</source>
        <translation>Es ist nichts dabei, was ein Sensor maß: keine Bilder, keine Punkte, keine Posen eines Ziels. Nenne auch deren Ordner oder Datei.</translation>
    </message>
    <message>
        <source>--target-frame %1: /tf of the bag has no such child; it has: %2.</source>
        <translation>--target-frame %1: /tf des Bags hat kein solches Kind; es hat: %2.</translation>
    </message>
    <message>
        <source>The bag has no pair of camera images with calibration, and its /tf %1 frames that sound like a target; name it with --target-frame%2. /tf has: %3.</source>
        <translation>Das Bag hat kein Paar von Kamerabildern mit Kalibrierung, und sein /tf %1 Koordinatensysteme, die nach einem Ziel klingen; nenne es mit --target-frame%2. /tf hat: %3.</translation>
    </message>
    <message>
        <source>, once for each --tcp</source>
        <translation>, einmal für jedes --tcp</translation>
    </message>
    <message>
        <source>The bag has %1 image topics with a calibration beside them where one is expected%2; record one camera with its CameraInfo, or a left and a right one, or say with --camera which to take.</source>
        <translation>Das Bag hat %1 Bildthemen mit einer Kalibrierung daneben, wo eines erwartet wird%2; nimm eine Kamera mit ihrer CameraInfo auf, oder eine linke und eine rechte, oder sage mit --camera, welche gemeint ist.</translation>
    </message>
    <message>
        <source>The bag has %1 pairs of cameras (%2); say with --camera which to take, or name each with a --camera of its own for a collection.</source>
        <translation>Das Bag hat %1 Kamerapaare (%2); sage mit --camera, welches gemeint ist, oder nenne jedes mit einem eigenen --camera für eine Sammlung.</translation>
    </message>
    <message>
        <source>--camera %1: no image topic of the bag has this in its name; it has: %2.</source>
        <translation>--camera %1: kein Bildthema des Bags hat dies im Namen; es hat: %2.</translation>
    </message>
    <message>
        <source>--camera %1 and --target-frame %2 are two sensors; name one of them for a session.</source>
        <translation>--camera %1 und --target-frame %2 sind zwei Sensoren; nenne einen davon für eine Sitzung.</translation>
    </message>
    <message>
        <source>--camera %1: names images of a bag, and no bag is among the files; leave it out.</source>
        <translation>--camera %1: nennt Bilder eines Bags, und unter den Dateien ist kein Bag; lass es weg.</translation>
    </message>
    <message>
        <source>The sessions %1 and %2 would be the same; each needs a --tcp, a --camera, a --target-frame or a --target of its own, or files with its --title in their names.</source>
        <translation>Die Sitzungen %1 und %2 wären dieselbe; jede braucht ein eigenes --tcp, --camera, --target-frame oder --target, oder Dateien mit ihrem --title im Namen.</translation>
    </message>
    <message>
        <source>The sessions have different hands, and no robot is known that both are of; name its URDF with --robot.</source>
        <translation>Die Sitzungen haben verschiedene Hände, und kein Roboter ist bekannt, zu dem beide gehören; nenne dessen URDF mit --robot.</translation>
    </message>
    <message>
        <source>--one-sensor: the session %1 is of %2 on %3, %4 of %5 on %6; one tracker stands on one link, and cameras are told by their images.</source>
        <translation>--one-sensor: die Sitzung %1 ist von %2 auf %3, %4 von %5 auf %6; ein Tracker steht auf einem Glied, und Kameras erkennt man an ihren Bildern.</translation>
    </message>
    <message>
        <source>The bag publishes no robot_description, and no frame of its /tf sounds like a flange; name the robot's URDF with --robot, or the flange's frame with --tcp. /tf has: %1.</source>
        <translation>Das Bag veröffentlicht keine robot_description, und kein Frame seines /tf klingt nach einem Flansch; nenne die URDF des Roboters mit --robot oder den Frame des Flansches mit --tcp. /tf enthält: %1.</translation>
    </message>
    <message>
        <source>--tcp %1: no robot is known, and /tf of the bag has no such frame; it has: %2.</source>
        <translation>--tcp %1: Kein Roboter ist bekannt, und /tf des Bags enthält diesen Frame nicht; es enthält: %2.</translation>
    </message>
    <message>
        <source>The bag has %1 frames that sound like the flange (%2); name the one with --tcp.</source>
        <translation>Das Bag enthält %1 Frames, die nach dem Flansch klingen (%2); nenne den richtigen mit --tcp.</translation>
    </message>
    <message>
        <source>The frame %1 of the bag's /tf is told at %2 times together with what carries it; expected it at many: record /tf while the robot moves.</source>
        <translation>Der Frame %1 im /tf des Bags ist zusammen mit dem, was ihn trägt, zu %2 Zeiten angegeben; erwartet sind viele: Nimm /tf auf, während sich der Roboter bewegt.</translation>
    </message>
    <message>
        <source>The flange is the frame %1 that /tf gives in %2.</source>
        <translation>Der Flansch ist der Frame %1, den /tf in %2 angibt.</translation>
    </message>
    <message>
        <source>The camera is taken to be on a stand and the target on the flange.</source>
        <translation>Angenommen ist die Kamera auf einem Stativ und die Messmarke am Flansch.</translation>
    </message>
    <message>
        <source>The camera is taken to be on the flange and the target beside the robot (--eye-on-base: the camera stands, the flange carries the target).</source>
        <translation>Angenommen ist die Kamera am Flansch und die Messmarke neben dem Roboter (--eye-on-base: Die Kamera steht, der Flansch trägt die Messmarke).</translation>
    </message>
    <message>
        <source>its %1 x %2 circles do not show as a whole grid</source>
        <translation>seine %1 x %2 Kreise sind nicht als ganzes Gitter zu sehen</translation>
    </message>
    <message>
        <source>The bag has no sensor_msgs/JointState with joints of this robot; record /joint_states too, or name the robot that it was recorded with.</source>
        <translation>Das Bag hat kein sensor_msgs/JointState mit Gelenken dieses Roboters; nimm auch /joint_states auf, oder nenne den Roboter, mit dem es aufgenommen wurde.</translation>
    </message>
    <message>
        <source>There are %1 folders of images and a calibration of %2 cameras (%3); name one folder for each camera, in this order or with its name in the folder's.</source>
        <translation>Es gibt %1 Ordner mit Bildern und eine Kalibrierung von %2 Kameras (%3); nenne einen Ordner je Kamera, in dieser Reihenfolge oder mit ihrem Namen in dem des Ordners.</translation>
    </message>
    <message>
        <source>There are images, and no calibration of the cameras; name OpenCV's, Kalibr's or those of ROS, or make one with `handsight-cli cameras`.</source>
        <translation>Es gibt Bilder und keine Kalibrierung der Kameras; nenne die von OpenCV, Kalibr oder ROS, oder mache eine mit `handsight-cli cameras`.</translation>
    </message>
    <message>
        <source>Files of ROS do not say how more than two cameras lie to each other; name Kalibr's camchain, or make a calibration with `handsight-cli cameras`.</source>
        <translation>Dateien von ROS sagen nicht, wie mehr als zwei Kameras zueinander liegen; nenne die Camchain von Kalibr, oder mache eine Kalibrierung mit `handsight-cli cameras`.</translation>
    </message>
    <message>
        <source>With %1 %2 something must be shown whose points name themselves: say what with --target, for example "charuco columns=8 rows=6 square=0.03 marker=0.022 dictionary=DICT_5X5_100"; markers without names need two cameras.</source>
        <translation>Mit %1 %2 muss etwas zu sehen sein, dessen Punkte sich selbst nennen: sage mit --target, was, zum Beispiel "charuco columns=8 rows=6 square=0.03 marker=0.022 dictionary=DICT_5X5_100"; Marker ohne Namen brauchen zwei Kameras.</translation>
    </message>
    <message>
        <source>There are images, and no table of joint readings; name a CSV with a line for each instant, or leave the robot out and name a table of its flange's poses.</source>
        <translation>Es gibt Bilder und keine Tabelle von Gelenkwerten; nenne eine CSV mit einer Zeile je Zeitpunkt, oder lass den Roboter weg und nenne eine Tabelle der Posen seines Flansches.</translation>
    </message>
    <message>
        <source>There are %1 lines of joint readings and %2 measurements, and %3 no times to pair them by; expected one line for each, or a column `time` in both.</source>
        <translation>Es gibt %1 Zeilen von Gelenkwerten und %2 Messungen, und %3 keine Zeiten, um sie einander zuzuordnen; erwartet wird eine Zeile für jede, oder eine Spalte `time` in beiden.</translation>
    </message>
    <message>
        <source>the measurements have</source>
        <translation>die Messungen haben</translation>
    </message>
    <message>
        <source>the joints have</source>
        <translation>die Gelenke haben</translation>
    </message>
    <message>
        <source>None of the %1 measurements has joint readings to it: they are from %2 to %3 s, the joints from %4 to %5 s, and %6 were left out because the robot moved. Do the clocks agree (--lag)? Did the robot stand (--still 0 allows moving)?</source>
        <translation>Zu keiner der %1 Messungen gibt es Gelenkwerte: sie gehen von %2 bis %3 s, die Gelenke von %4 bis %5 s, und %6 wurden weggelassen, weil sich der Roboter bewegte. Gehen die Uhren gleich (--lag)? Stand der Roboter (--still 0 erlaubt Bewegung)?</translation>
    </message>
    <message>
        <source>%1 and %2 are both tables of poses: which is the robot's flange, which the target that the sensor sees? Say with --target-frame which is the target's, or name the files so: flange.csv and target.csv.</source>
        <translation>%1 und %2 sind beides Tabellen von Posen: welche ist der Flansch des Roboters, welche das Ziel, das der Sensor sieht? Sage mit --target-frame, welche die des Ziels ist, oder nenne die Dateien so: flange.csv und target.csv.</translation>
    </message>
    <message>
        <source>--target-frame %1: no table of poses is called so; there are: %2.</source>
        <translation>--target-frame %1: so heißt keine Tabelle von Posen; es gibt: %2.</translation>
    </message>
    <message>
        <source>%1 %2: the robot has no such link; it has: %3.</source>
        <translation>%1 %2: der Roboter hat kein solches Glied; er hat: %3.</translation>
    </message>
    <message>
        <source>%1 they agree to %2: leave --angles out.</source>
        <translation>%1 stimmen sie auf %2 überein: lass --angles weg.</translation>
    </message>
    <message>
        <source>As --angles has it, the motions of the flange and of the target do not agree (the best leaves %1); if %2</source>
        <translation>So wie --angles es sagt, stimmen die Bewegungen von Flansch und Ziel nicht überein (das Beste lässt %1 übrig); wenn %2</translation>
    </message>
    <message>
        <source>Images of other cameras are left out: %1. With --target, what the images show, each camera has a session.</source>
        <translation>Bilder anderer Kameras werden weggelassen: %1. Mit --target, dem, was die Bilder zeigen, hat jede Kamera eine Sitzung.</translation>
    </message>
    <message>
        <source>%1 moves with %2 (to %3; the next best frame to %4)</source>
        <translation>%1 bewegt sich mit %2 (auf %3; das nächstbeste Koordinatensystem auf %4)</translation>
    </message>
    <message>
        <source>%1: so the hands' targets are told apart (--target-frame says otherwise).</source>
        <translation>%1: so werden die Ziele der Hände unterschieden (--target-frame sagt es anders).</translation>
    </message>
    <message>
        <source>%1: topic %2 (PoseArray) holds %3 to %4 poses a message, which have no names, so that nothing tells which is which; it is left out. Record a topic that names them (/tf, or tags with their numbers), or with one target in view.</source>
        <translation>%1: Das Thema %2 (PoseArray) hat %3 bis %4 Posen je Nachricht, die keine Namen haben, sodass nichts sagt, welche welche ist; es wird ausgelassen. Zeichne ein Thema auf, das sie nennt (/tf, oder Tags mit ihren Nummern), oder mit nur einem Ziel im Bild.</translation>
    </message>
    <message>
        <source>%1: topic %2 (PoseArray) holds %3 poses a message, which have no names; with --target-frame "%4[0]" (or [1] ...) one of them is taken, as if their order were the same in every message.</source>
        <translation>%1: Das Thema %2 (PoseArray) hat %3 Posen je Nachricht, die keine Namen haben; mit --target-frame „%4[0]“ (oder [1] ...) wird eine davon genommen, als wäre ihre Reihenfolge in jeder Nachricht dieselbe.</translation>
    </message>
    <message>
        <source>The bag has no pair of camera images with calibration, no frames in /tf and no topic of poses that is read (PoseStamped, TransformStamped, PoseArray, ArucoMarkers); one camera needs --target, what its images show. It has: %1.</source>
        <translation>Das Bag hat kein Paar von Kamerabildern mit Kalibrierung, keine Koordinatensysteme in /tf und kein Thema von Posen, das gelesen wird (PoseStamped, TransformStamped, PoseArray, ArucoMarkers); eine Kamera braucht --target, das, was ihre Bilder zeigen. Es hat: %1.</translation>
    </message>
    <message>
        <source>a camera by its numbers' names</source>
        <translation>eine Kamera nach den Namen ihrer Zahlen</translation>
    </message>
    <message>
        <source>numbers of a camera</source>
        <translation>Zahlen einer Kamera</translation>
    </message>
    <message>
        <source>is JSON of a kind that is not known</source>
        <translation>ist JSON einer Art, die nicht bekannt ist</translation>
    </message>
    <message>
        <source>There are %1 poses of the flange and %2 of the target; expected one of each an instant, in the same order, or a column that pairs them: number, image or time.</source>
        <translation>Es gibt %1 Posen des Flansches und %2 des Ziels; erwartet wird je Zeitpunkt eine von beiden, in derselben Reihenfolge, oder eine Spalte, die sie paart: Nummer, Bild oder Zeit.</translation>
    </message>
    <message>
        <source>The target's pose counts whole, place and turn.</source>
        <translation>Die Pose des Ziels zählt ganz, Ort und Drehung.</translation>
    </message>
    <message>
        <source>%1 rows repeat another one in both tables; each counts once.</source>
        <translation>%1 Zeilen wiederholen in beiden Tabellen eine andere; jede zählt einmal.</translation>
    </message>
    <message>
        <source>The clocks of the two tables do not agree; their poses are paired row by row.</source>
        <translation>Die Uhren der beiden Tabellen gehen nicht gleich; ihre Posen sind Zeile für Zeile gepaart.</translation>
    </message>
    <message>
        <source>No row has both a pose of the flange and one of the target; expected one of each an instant.</source>
        <translation>Keine Zeile hat eine Pose des Flansches und eine des Ziels; erwartet wird je Zeitpunkt eine von beiden.</translation>
    </message>
    <message>
        <source>The camera %1 is called %2 in the session.</source>
        <translation>Die Kamera %1 heißt in der Sitzung %2.</translation>
    </message>
    <message>
        <source>There are %1 tables of poses (%2); expected the flange's and the target's.</source>
        <translation>Es gibt %1 Tabellen von Posen (%2); erwartet werden die des Flansches und die des Ziels.</translation>
    </message>
    <message>
        <source>The motions of the flange and of the target agree only if the poses of one of them are inverted (the sensor in the target's frame for the target in the sensor's), or with the sensor on the other side (--eye-on-base); see what fit says.</source>
        <translation>Die Bewegungen des Flansches und des Ziels stimmen nur überein, wenn die Posen von einem umgekehrt sind (der Sensor im Rahmen des Ziels statt das Ziel in dem des Sensors) oder der Sensor auf der anderen Seite ist (--eye-on-base); sieh, was fit sagt.</translation>
    </message>
    <message>
        <source>The pose of the flange is the same in observations %1, while what was seen moved: the reading of one is old, or something slipped between them; leave out what is wrong.</source>
        <translation>Die Pose des Flansches ist in den Beobachtungen %1 dieselbe, während sich das Gesehene bewegte: eine Ablesung ist alt, oder dazwischen ist etwas gerutscht; lass weg, was falsch ist.</translation>
    </message>
    <message>
        <source>The joint readings are the same in observations %1, while what was seen moved: the reading of one is old, or something slipped between them; leave out what is wrong.</source>
        <translation>Die Gelenkwerte sind in den Beobachtungen %1 dieselben, während sich das Gesehene bewegte: eine Ablesung ist alt, oder dazwischen ist etwas gerutscht; lass weg, was falsch ist.</translation>
    </message>
    <message>
        <source>What was seen is the same in observations %1, while the robot moved: the measurement of one is old. Leave it out.</source>
        <translation>Das Gesehene ist in den Beobachtungen %1 dasselbe, während sich der Roboter bewegte: eine Messung ist alt. Lass sie weg.</translation>
    </message>
    <message>
        <source>A file of kind %1 is of a robot with joints, and only the poses of the flange are known here; export where sensor and target sit as static_tf, yaml, opencv or csv.</source>
        <translation>Eine Datei der Art %1 ist von einem Roboter mit Gelenken, und hier sind nur die Posen des Flansches bekannt; exportiere, wo Sensor und Ziel sitzen, als static_tf, yaml, opencv oder csv.</translation>
    </message>
    <message>
        <source>--tcp is missing: the link that is the hand. At the ends of this robot are: %1.</source>
        <translation>--tcp fehlt: das Glied, das die Hand ist. An den Enden dieses Roboters sind: %1.</translation>
    </message>
    <message>
        <source>the columns %1 and %2 are both of joint %3, expected one.</source>
        <translation>die Spalten %1 und %2 sind beide vom Gelenk %3; erwartet wird eine.</translation>
    </message>
    <message>
        <source>joint %1 stands at %2, expected a number from %3 to %4.</source>
        <translation>Gelenk %1 steht bei %2; erwartet wird eine Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>lies outside of any room</source>
        <translation>liegt außerhalb jedes Raums</translation>
    </message>
    <message>
        <source>has no unit quaternion</source>
        <translation>hat kein Einheitsquaternion</translation>
    </message>
    <message>
        <source>is not whole</source>
        <translation>ist nicht vollständig</translation>
    </message>
    <message>
        <source>%1 %2: the robot has no such link; it has: %3.</source>
        <translation>%1 %2: der Roboter hat kein solches Glied; er hat: %3.</translation>
    </message>
    <message>
        <source>%1 stands in column %2, expected a number of at most %3.</source>
        <translation>%1 steht in Spalte %2; erwartet wird eine Zahl von höchstens %3.</translation>
    </message>
    <message>
        <source>column %1 (%2) is empty, expected a number.</source>
        <translation>Spalte %1 (%2) ist leer; erwartet wird eine Zahl.</translation>
    </message>
    <message>
        <source>The two cannot be compared: %1; name two sessions of one robot, sensor and marker body.</source>
        <translation>Die beiden lassen sich nicht vergleichen: %1; zwei Sitzungen mit demselben Roboter, Sensor und Markerkörper nennen.</translation>
    </message>
    <message>
        <source>one has cameras, the other a tracker</source>
        <translation>die eine hat Kameras, die andere einen Tracker</translation>
    </message>
    <message>
        <source>their cameras have other names</source>
        <translation>ihre Kameras heißen anders</translation>
    </message>
    <message>
        <source>one has %1 markers, the other %2</source>
        <translation>die eine hat %1 Marker, die andere %2</translation>
    </message>
    <message>
        <source>TCP or mount are other links</source>
        <translation>TCP oder Halterung sind andere Glieder</translation>
    </message>
    <message>
        <source>their joints are others, or in another order</source>
        <translation>ihre Gelenke sind andere oder anders geordnet</translation>
    </message>
    <message>
        <source>their robots are others</source>
        <translation>ihre Roboter sind andere</translation>
    </message>
    <message>
        <source>The two cannot be compared: the fit of the %1 session finds no answer; run `handsight-cli fit` on it, exclude the observations that it says stand out, and compare again.</source>
        <translation>Die beiden lassen sich nicht vergleichen: die Anpassung der %1 Sitzung findet keine Antwort; `handsight-cli fit` auf sie anwenden, die Beobachtungen ausschließen, die danach herausragen, und neu vergleichen.</translation>
    </message>
    <message>
        <source>The session's TCP, mount or joints are not those of the calibration; name a session of the same robot.</source>
        <translation>TCP, Halterung oder Gelenke der Sitzung sind nicht die der Kalibrierung; eine Sitzung desselben Roboters nennen.</translation>
    </message>
    <message>
        <source>The session has %1 markers, the calibration %2; name a session with the same marker body.</source>
        <translation>Die Sitzung hat %1 Marker, die Kalibrierung %2; eine Sitzung mit demselben Markerkörper nennen.</translation>
    </message>
    <message>
        <source>Neither the calibration nor the session says where the sensor sits: a few poses cannot tell it.</source>
        <translation>Weder die Kalibrierung noch die Sitzung sagt, wo der Sensor sitzt: aus wenigen Posen lässt es sich nicht finden.</translation>
    </message>
    <message>
        <source>The session has no observation with markers that can be used; label some poses.</source>
        <translation>Die Sitzung hat keine Beobachtung mit Markern, die sich verwenden lässt; einige Posen beschriften.</translation>
    </message>
    <message>
        <source>%1: has no &lt;robot&gt; with the tcp link or no &lt;joints&gt; with their order; predict from its session.</source>
        <translation>%1: hat kein &lt;robot&gt; mit dem Glied tcp oder keine &lt;joints&gt; mit ihrer Reihenfolge; die Sitzung selbst verwenden.</translation>
    </message>
    <message>
        <source>The target's pose counts whole, place and turn; how exactly the sensor tells them is estimated. Where it is known say it: --sigma (m), --sigma-angle (rad), or in &lt;pose_sensor&gt;.</source>
        <translation>Die Pose des Ziels zählt ganz, Ort und Drehung; wie genau der Sensor sie angibt, wird geschätzt. Wo es bekannt ist, gib es an: --sigma (m), --sigma-angle (rad), oder in &lt;pose_sensor&gt;.</translation>
    </message>
    <message>
        <source>The calibration of the %1 camera has width and height swapped; %2 x %3 px of the images is taken.</source>
        <translation>Die Kalibrierung der Kamera %1 hat Breite und Höhe vertauscht; %2 x %3 px der Bilder wird genommen.</translation>
    </message>
    <message>
        <source>The robot is the one that the bag publishes as robot_description.</source>
        <translation>Der Roboter ist der, den das Bag als robot_description veröffentlicht.</translation>
    </message>
    <message>
        <source>%1 of %2 left images have no right image within 10 ms and are left out.</source>
        <translation>%1 von %2 linken Bildern haben kein rechtes Bild innerhalb von 10 ms und bleiben weg.</translation>
    </message>
    <message>
        <source>The target is the frame %1 that /tf gives in %2.</source>
        <translation>Das Ziel ist der Rahmen %1, den /tf in %2 angibt.</translation>
    </message>
    <message>
        <source>%1 of %2 measurements are left out: %3.</source>
        <translation>%1 von %2 Messungen bleiben weg: %3.</translation>
    </message>
    <message>
        <source>No robot is known, only where its flange is: what bends or is off in its joints cannot be told apart; name its URDF and a table of joint readings for that.</source>
        <translation>Kein Roboter ist bekannt, nur wo sein Flansch ist: was sich in den Gelenken biegt oder falsch ist, lässt sich nicht unterscheiden; nenne dafür seine URDF und eine Tabelle von Gelenkwerten.</translation>
    </message>
    <message>
        <source>Each line has one of %1 markers.</source>
        <translation>Jede Zeile hat einen von %1 Markern.</translation>
    </message>
    <message>
        <source>%1 points were not seen by the device; they are left out.</source>
        <translation>%1 Punkte hat das Gerät nicht gesehen; sie bleiben weg.</translation>
    </message>
    <message>
        <source>%1 has %2 lines for %3 images: it waits until they are as many. With a column "number" each image finds its own line.</source>
        <translation>%1 hat %2 Zeilen für %3 Bilder: es wartet, bis es gleich viele sind. Mit einer Spalte „number“ findet jedes Bild seine Zeile.</translation>
    </message>
    <message>
        <source>%1 has %2 lines for %3 image pairs: it waits until they are as many. With a column "number" each pair finds its own line.</source>
        <translation>%1 hat %2 Zeilen für %3 Bildpaare: es wartet, bis es gleich viele sind. Mit einer Spalte „number“ findet jedes Paar seine Zeile.</translation>
    </message>
    <message>
        <source>%1 is not there yet: the joint angles, a line for each new image.</source>
        <translation>%1 ist noch nicht da: die Gelenkwinkel, eine Zeile je neuem Bild.</translation>
    </message>
    <message>
        <source>%1 is not there yet: the joint angles of the new images, a line for each pair.</source>
        <translation>%1 ist noch nicht da: die Gelenkwinkel der neuen Bilder, eine Zeile je Paar.</translation>
    </message>
    <message>
        <source>Line %1 of %2 is not the posture that the session has for %3. Name the images' numbers in a column "number".</source>
        <translation>Zeile %1 von %2 ist nicht die Pose, die die Sitzung für %3 hat. Nenne die Nummern der Bilder in einer Spalte „number“.</translation>
    </message>
    <message>
        <source>%1 waits for its joint angles in %2 (number %3).</source>
        <translation>%1 wartet auf seine Gelenkwinkel in %2 (Nummer %3).</translation>
    </message>
    <message>
        <source>%1 waits for its joint angles in %2 (line %3).</source>
        <translation>%1 wartet auf seine Gelenkwinkel in %2 (Zeile %3).</translation>
    </message>
    <message>
        <source>%1 is set aside: %2.</source>
        <translation>%1 ist beiseitegelegt: %2.</translation>
    </message>
    <message>
        <source>%1 is set aside until it is written again: %2.</source>
        <translation>%1 ist beiseitegelegt, bis es neu geschrieben wird: %2.</translation>
    </message>
    <message>
        <source>it is cut off after %1 bytes</source>
        <translation>es bricht nach %1 Bytes ab</translation>
    </message>
    <message>
        <source>it is %1 x %2, the camera says %3 x %4</source>
        <translation>es ist %1 x %2, die Kamera sagt %3 x %4</translation>
    </message>
    <message>
        <source>The line %1 of %2</source>
        <translation>Die Zeile %1 von %2</translation>
    </message>
    <message>
        <source>The line of number %1 of %2</source>
        <translation>Die Zeile der Nummer %1 von %2</translation>
    </message>
    <message>
        <source>A line of %1 (number %2)</source>
        <translation>Eine Zeile von %1 (Nummer %2)</translation>
    </message>
    <message>
        <source>Line %1 of %2</source>
        <translation>Zeile %1 von %2</translation>
    </message>
    <message>
        <source>The file %1</source>
        <translation>Die Datei %1</translation>
    </message>
    <message>
        <source>it has %1 columns, expected %2</source>
        <translation>sie hat %1 Spalten, erwartet werden %2</translation>
    </message>
    <message>
        <source>it has not a finite number for each joint of the session</source>
        <translation>sie hat nicht für jedes Gelenk der Sitzung eine endliche Zahl</translation>
    </message>
    <message>
        <source>it has no whole pose of the flange (x y z qx qy qz qw)</source>
        <translation>sie hat keine ganze Pose des Flansches (x y z qx qy qz qw)</translation>
    </message>
    <message>
        <source>it has no whole point</source>
        <translation>sie hat keinen ganzen Punkt</translation>
    </message>
    <message>
        <source>it has no finite x y z and no qx qy qz qw of length 1</source>
        <translation>sie hat kein endliches x y z und kein qx qy qz qw der Länge 1</translation>
    </message>
    <message>
        <source>its first line names no column `number`, by which poses and measurements are paired</source>
        <translation>ihre erste Zeile nennt keine Spalte `number`, nach der Posen und Messungen zusammengehören</translation>
    </message>
    <message>
        <source>its first line names no column %1</source>
        <translation>ihre erste Zeile nennt keine Spalte %1</translation>
    </message>
    <message>
        <source>it is a pipe or a device, which may never end</source>
        <translation>es ist eine Pipe oder ein Gerät, die nie enden könnten</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>sie lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>There are %1 things with poses (%2); say with --target-frame which is on the hand.</source>
        <translation>Es gibt %1 Dinge mit Posen (%2); sage mit --target-frame, welches an der Hand ist.</translation>
    </message>
    <message>
        <source>the %1 holds no unit quaternion</source>
        <translation>%1 enthält kein Einheitsquaternion</translation>
    </message>
    <message>
        <source>does not begin with a number, expected that of a frame.</source>
        <translation>beginnt nicht mit einer Zahl; erwartet wird die eines Bildes.</translation>
    </message>
    <message>
        <source>stands before the first section; expected [image].</source>
        <translation>steht vor dem ersten Abschnitt; erwartet wird [image].</translation>
    </message>
    <message>
        <source>%1 is no finite number.</source>
        <translation>%1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>is nested more deeply than any robot is.</source>
        <translation>ist tiefer verschachtelt, als ein Roboter es ist.</translation>
    </message>
    <message>
        <source>&lt;%1&gt; makes other bodies, which is not read; write the whole model with mj_saveLastXML (`simulate` has it as Save xml) and name that.</source>
        <translation>&lt;%1&gt; macht andere Körper, was nicht gelesen wird; schreibe das ganze Modell mit mj_saveLastXML (`simulate` hat es als Save xml) und nenne dieses.</translation>
    </message>
    <message>
        <source>has an axis without a direction, expected one.</source>
        <translation>hat eine Achse ohne Richtung; erwartet wird eine.</translation>
    </message>
    <message>
        <source>has fromto without a length, expected two places.</source>
        <translation>hat fromto ohne Länge; erwartet werden zwei Orte.</translation>
    </message>
    <message>
        <source>has a mass of %1 kg.</source>
        <translation>hat eine Masse von %1 kg.</translation>
    </message>
    <message>
        <source>includes %1 a second time, expected once.</source>
        <translation>bindet %1 ein zweites Mal ein; erwartet wird einmal.</translation>
    </message>
    <message>
        <source>is the include number %1.</source>
        <translation>ist die Einbindung Nummer %1.</translation>
    </message>
    <message>
        <source>includes %1, which is not there; put it beside the model.</source>
        <translation>bindet %1 ein, das es nicht gibt; lege es neben das Modell.</translation>
    </message>
    <message>
        <source>includes %1, which is empty.</source>
        <translation>bindet %1 ein, das leer ist.</translation>
    </message>
    <message>
        <source>has eulerseq %1, expected three of x y z X Y Z.</source>
        <translation>hat eulerseq %1; erwartet werden drei von x y z X Y Z.</translation>
    </message>
    <message>
        <source>has coordinate="global", which MuJoCo itself no longer reads, expected "local"; an older MuJoCo writes it anew with mj_saveLastXML.</source>
        <translation>hat coordinate="global", was MuJoCo selbst nicht mehr liest; erwartet wird "local"; ein älteres MuJoCo schreibt es neu mit mj_saveLastXML.</translation>
    </message>
    <message>
        <source>has %1 without a direction, expected one.</source>
        <translation>hat %1 ohne Richtung; erwartet wird eine.</translation>
    </message>
    <message>
        <source>has a quat of length 0, expected w x y z.</source>
        <translation>hat ein quat der Länge 0; erwartet wird w x y z.</translation>
    </message>
    <message>
        <source>is of the class %1, which no &lt;default&gt; describes.</source>
        <translation>ist von der Klasse %1, die kein &lt;default&gt; beschreibt.</translation>
    </message>
    <message>
        <source>has %1=%2, expected %3 finite numbers.</source>
        <translation>hat %1=%2; erwartet werden %3 endliche Zahlen.</translation>
    </message>
    <message>
        <source>has %1 in %2, far outside of any robot.</source>
        <translation>hat %1 in %2, weit außerhalb jedes Roboters.</translation>
    </message>
    <message>
        <source>is no head of a section of Vicon's, expected its rate, names and axes below.</source>
        <translation>ist kein Kopf eines Abschnitts von Vicon; erwartet werden darunter Rate, Namen und Achsen.</translation>
    </message>
    <message>
        <source>a bag of ROS</source>
        <translation>ein Bag von ROS</translation>
    </message>
    <message>
        <source>servos of LeRobot</source>
        <translation>Servos von LeRobot</translation>
    </message>
    <message>
        <source>motion capture of Motive, Vicon or Qualisys</source>
        <translation>Motion-Capture von Motive, Vicon oder Qualisys</translation>
    </message>
    <message>
        <source>a calibration of ROS's camera_calibration</source>
        <translation>eine Kalibrierung von ROS' camera_calibration</translation>
    </message>
    <message>
        <source>a camera of RealSense</source>
        <translation>eine Kamera von RealSense</translation>
    </message>
    <message>
        <source>a camera of camodocal</source>
        <translation>eine Kamera von camodocal</translation>
    </message>
    <message>
        <source>a target of Kalibr</source>
        <translation>ein Ziel von Kalibr</translation>
    </message>
    <message>
        <source>%1 and %2 have other robots: %3; a collection is of one robot.</source>
        <translation>%1 und %2 haben verschiedene Roboter: %3; eine Sammlung ist von einem Roboter.</translation>
    </message>
    <message>
        <source>sides_swapped: the session has not two cameras.</source>
        <translation>sides_swapped: die Sitzung hat nicht zwei Kameras.</translation>
    </message>
    <message>
        <source>The target is not as large as &lt;target&gt; says: its %1 are about %2 mm, not %3 mm.</source>
        <translation>Das Ziel ist nicht so groß, wie &lt;target&gt; sagt: seine %1 messen etwa %2 mm, nicht %3 mm.</translation>
    </message>
    <message>
        <source>Measure it, and write %1=&quot;%2&quot; (m), or what you measured, into &lt;target&gt; of %3.</source>
        <translation>Miss es nach und schreibe %1=&quot;%2&quot; (m) oder das Gemessene in &lt;target&gt; von %3.</translation>
    </message>
    <message>
        <source>target_size: the session has no &lt;target&gt;.</source>
        <translation>target_size: die Sitzung hat kein &lt;target&gt;.</translation>
    </message>
    <message>
        <source>target_size: %1 is no length in m; expected one above 0, like 0.02.</source>
        <translation>target_size: %1 ist keine Länge in m; erwartet wird eine über 0, etwa 0.02.</translation>
    </message>
    <message>
        <source>board_transposed: the session has no board of rows and columns.</source>
        <translation>board_transposed: die Sitzung hat kein Brett mit Zeilen und Spalten.</translation>
    </message>
    <message>
        <source>image_turned: the session has no camera.</source>
        <translation>image_turned: die Sitzung hat keine Kamera.</translation>
    </message>
    <message>
        <source>The position holds a number that is not finite (nan or inf); expected angles in rad (m).</source>
        <translation>Die Pose enthält eine Zahl, die nicht endlich ist (nan oder inf); erwartet werden Winkel in rad (m).</translation>
    </message>
    <message>
        <source>This candidate is a curve without a name that could not be written down; choose one that has terms.</source>
        <translation>Dieser Kandidat ist eine Kurve ohne Namen, die sich nicht aufschreiben ließ; einen wählen, der Terme hat.</translation>
    </message>
    <message>
        <source>the point has %1, expected three finite numbers.</source>
        <translation>der Punkt hat %1; erwartet werden drei endliche Zahlen.</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>the mesh has more than %1 triangles, expected a simpler one.</source>
        <translation>das Netz hat mehr als %1 Dreiecke; erwartet wird ein einfacheres.</translation>
    </message>
    <message>
        <source>the face names the point %1, expected one of the %2 points before it.</source>
        <translation>die Fläche nennt den Punkt %1; erwartet wird einer der %2 Punkte davor.</translation>
    </message>
    <message>
        <source>the face has %1 corners, expected at least three.</source>
        <translation>die Fläche hat %1 Ecken; erwartet werden mindestens drei.</translation>
    </message>
    <message>
        <source>the file has %1 bytes and its head speaks of %2, expected a whole STL file.</source>
        <translation>die Datei hat %1 Bytes, und ihr Kopf spricht von %2; erwartet wird eine ganze STL-Datei.</translation>
    </message>
    <message>
        <source>a corner of a triangle is not finite or too far away, expected finite numbers.</source>
        <translation>eine Ecke eines Dreiecks ist nicht endlich oder zu weit weg; erwartet werden endliche Zahlen.</translation>
    </message>
    <message>
        <source>the last triangle is cut off, expected three corners.</source>
        <translation>das letzte Dreieck ist abgeschnitten; erwartet werden drei Ecken.</translation>
    </message>
    <message>
        <source>is of xacro, expected a URDF: expand it first with `xacro %1 &gt; expanded.urdf` (or `ros2 run xacro xacro ...`, with the arguments that the robot's launch file gives) and name expanded.urdf.</source>
        <translation>ist von xacro; erwartet wird eine URDF: sie zuerst mit `xacro %1 &gt; expanded.urdf` entfalten (oder `ros2 run xacro xacro ...`, mit den Argumenten aus der Startdatei des Roboters) und expanded.urdf nennen.</translation>
    </message>
    <message>
        <source>%1: the file is not UTF-8; its other bytes are read as Latin-1.</source>
        <translation>%1: die Datei ist kein UTF-8; ihre übrigen Bytes werden als Latin-1 gelesen.</translation>
    </message>
    <message>
        <source>of joint %1 follows joint %2, expected the name of a joint in the file.</source>
        <translation>von Gelenk %1 folgt Gelenk %2; erwartet wird der Name eines Gelenks der Datei.</translation>
    </message>
    <message>
        <source>of joint %1 follows joint %2, which is fixed, expected a joint that moves.</source>
        <translation>von Gelenk %1 folgt Gelenk %2, das fest ist; erwartet wird ein bewegliches Gelenk.</translation>
    </message>
    <message>
        <source>%1 follows itself through its &lt;mimic&gt;, expected mimics that end at a joint that moves by itself.</source>
        <translation>%1 folgt über sein &lt;mimic&gt; sich selbst; erwartet werden mimics, die bei einem Gelenk enden, das sich selbst bewegt.</translation>
    </message>
    <message>
        <source>%1 has no parent joint, nor has %2: %3 root links, expected one.</source>
        <translation>%1 hat kein übergeordnetes Gelenk, %2 auch nicht: %3 Wurzelglieder; erwartet wird eines.</translation>
    </message>
    <message>
        <source>has %1="%2", expected a length of at least 0 m.</source>
        <translation>hat %1="%2"; erwartet wird eine Länge von mindestens 0 m.</translation>
    </message>
    <message>
        <source>has a negative number in size, expected three lengths of at least 0 m.</source>
        <translation>hat eine negative Zahl in size; erwartet werden drei Längen von mindestens 0 m.</translation>
    </message>
    <message>
        <source>the &lt;visual&gt; is not drawn: it has no box, cylinder, sphere or mesh in its &lt;geometry&gt;.</source>
        <translation>das &lt;visual&gt; wird nicht gezeichnet: es hat weder box, cylinder, sphere noch mesh in seiner &lt;geometry&gt;.</translation>
    </message>
    <message>
        <source>the centre of mass of link %1 lies %2 m from the link's frame, farther than %3 m; its gravity moments will be as large as that says.</source>
        <translation>der Schwerpunkt des Glieds %1 liegt %2 m vom System des Glieds, weiter als %3 m; seine Schweremomente werden so groß, wie das sagt.</translation>
    </message>
    <message>
        <source>joint %1 has &lt;dh&gt;, so that its &lt;origin&gt; and &lt;axis&gt; are ignored.</source>
        <translation>Gelenk %1 hat &lt;dh&gt;, so dass sein &lt;origin&gt; und &lt;axis&gt; übergangen werden.</translation>
    </message>
    <message>
        <source>joint %1 is fixed, so that its &lt;stiffness&gt; is ignored.</source>
        <translation>Gelenk %1 ist fest, so dass seine &lt;stiffness&gt; übergangen wird.</translation>
    </message>
    <message>
        <source>joint %1 is fixed, so that its &lt;mimic&gt; is ignored.</source>
        <translation>Gelenk %1 ist fest, so dass sein &lt;mimic&gt; übergangen wird.</translation>
    </message>
    <message>
        <source>has no attributes, expected a, alpha, d and theta.</source>
        <translation>hat keine Attribute; erwartet werden a, alpha, d und theta.</translation>
    </message>
    <message>
        <source>%1: its poses are taken for base_from_flange; the camera is taken to be %2.</source>
        <translation>%1: seine Posen gelten als base_from_flange; die Kamera gilt als %2.</translation>
    </message>
    <message>
        <source>on a stand and the target on the flange</source>
        <translation>auf einem Ständer und das Ziel als am Flansch</translation>
    </message>
    <message>
        <source>on the flange and the target beside the robot (--eye-on-base: the camera stands, the flange carries the target)</source>
        <translation>am Flansch und das Ziel als neben dem Roboter (--eye-on-base: die Kamera steht, der Flansch trägt das Ziel)</translation>
    </message>
    <message>
        <source>%1: is one image; name the folder that holds the images.</source>
        <translation>%1: ist ein einzelnes Bild; nenne den Ordner mit den Bildern.</translation>
    </message>
    <message>
        <source>%1: is %2, which is not read; %3.</source>
        <translation>%1: ist %2, was nicht gelesen wird; %3.</translation>
    </message>
    <message>
        <source>%1: no column has the name of a joint of the robot, which has: %2.</source>
        <translation>%1: keine Spalte hat den Namen eines Gelenks des Roboters; er hat: %2.</translation>
    </message>
    <message>
        <source>column %1 (%2) holds %3, expected the tip's number, 0 to 63.</source>
        <translation>Spalte %1 (%2) enthält %3; erwartet wird die Nummer der Tastspitze, 0 bis 63.</translation>
    </message>
    <message>
        <source>says of no fixture what is touched, expected its name.</source>
        <translation>sagt von keiner Vorrichtung, was berührt wird; erwartet wird ihr Name.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 and %4 have a partner.</source>
        <translation>%1: %2 von %3 und %4 haben einen Partner.</translation>
    </message>
    <message>
        <source>No pose of the target has one of the flange at its time: they are from %1 to %2 s, those of the flange from %3 to %4 s. Do the clocks agree (--lag)?</source>
        <translation>Zu keiner Pose des Ziels gibt es zu ihrer Zeit eine des Flansches: sie sind von %1 bis %2 s, die des Flansches von %3 bis %4 s. Stimmen die Uhren überein (--lag)?</translation>
    </message>
    <message>
        <source>The table of the flange names images (%1 ...), and none of them is there (the first is %2).</source>
        <translation>Die Tabelle des Flansches nennt Bilder (%1 ...), und keines davon ist da (das erste ist %2).</translation>
    </message>
    <message>
        <source>There are %1 %2 and %3 poses of the flange; expected one for each, in the order of the images' numbers, or a column that pairs them: image or number. The first image has the number %4, the last %5.</source>
        <translation>Es gibt %1 %2 und %3 Posen des Flansches; erwartet wird eine für jedes, in der Reihenfolge der Bildnummern, oder eine Spalte, die sie paart: image oder number. Das erste Bild hat die Nummer %4, das letzte %5.</translation>
    </message>
    <message>
        <source>Poses of the flange and of the target are paired by the names of their images</source>
        <translation>Posen von Flansch und Ziel sind nach den Namen ihrer Bilder gepaart</translation>
    </message>
    <message>
        <source>Poses of the flange and of the target are paired by their numbers</source>
        <translation>Posen von Flansch und Ziel sind nach ihren Nummern gepaart</translation>
    </message>
    <message>
        <source>Poses of the flange and of the target are paired by their times</source>
        <translation>Posen von Flansch und Ziel sind nach ihren Zeiten gepaart</translation>
    </message>
    <message>
        <source>Poses of the flange and the images are paired by the images' names</source>
        <translation>Posen des Flansches und Bilder sind nach den Namen der Bilder gepaart</translation>
    </message>
    <message>
        <source>Poses of the flange and the images are paired by their numbers</source>
        <translation>Posen des Flansches und Bilder sind nach ihren Nummern gepaart</translation>
    </message>
    <message>
        <source>no</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>The measurements come %1 s after the joint readings; that was taken out.</source>
        <translation>Die Messungen kommen %1 s nach den Gelenkwerten; das wurde herausgerechnet.</translation>
    </message>
    <message>
        <source>The lag between measurements and joint readings cannot be told: both must show the same movements. It is taken as %1 s.</source>
        <translation>Die Verzögerung zwischen Messungen und Gelenkwerten ist nicht zu erkennen: beide müssen dieselben Bewegungen zeigen. Sie gilt als %1 s.</translation>
    </message>
    <message>
        <source>there are no joint readings at their times</source>
        <translation>zu ihren Zeiten gibt es keine Gelenkwerte</translation>
    </message>
    <message>
        <source>the joint readings have a gap there</source>
        <translation>die Gelenkwerte haben dort eine Lücke</translation>
    </message>
    <message>
        <source>the robot was moving</source>
        <translation>der Roboter bewegte sich</translation>
    </message>
    <message>
        <source>they show a standstill that another one shows</source>
        <translation>sie zeigen einen Stillstand, den eine andere schon zeigt</translation>
    </message>
    <message>
        <source>%1 have one %2 (%3).</source>
        <translation>%1 haben %2 gemeinsam (%3).</translation>
    </message>
    <message>
        <source>No two sessions have one %1; where they have, say so in collection.xml.</source>
        <translation>Keine zwei Sitzungen haben %1 gemeinsam; wo doch, das in collection.xml sagen.</translation>
    </message>
    <message>
        <source>Session %1: %2</source>
        <translation>Sitzung %1: %2</translation>
    </message>
    <message>
        <source>%1 is made of %2 of the %3 files, by their names.</source>
        <translation>%1 ist aus %2 der %3 Dateien gemacht, nach ihren Namen.</translation>
    </message>
    <message>
        <source>%1: there is a %2 already; take another folder.</source>
        <translation>%1: dort ist schon eine %2; nimm einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1: is there already; take another folder, or another title.</source>
        <translation>%1: ist schon da; nimm einen anderen Ordner oder einen anderen Titel.</translation>
    </message>
    <message>
        <source>%1: %2; expected a URDF, a folder of images, a table (CSV) of joints, poses or points, a calibration of OpenCV, ROS or Kalibr, samples of easy_handeye, or a bag of ROS.</source>
        <translation>%1: %2; erwartet wird eine URDF, ein Ordner mit Bildern, eine Tabelle (CSV) von Gelenken, Posen oder Punkten, eine Kalibrierung von OpenCV, ROS oder Kalibr, Messungen von easy_handeye oder ein Bag von ROS.</translation>
    </message>
    <message>
        <source>%1: is not there; name a file or folder.</source>
        <translation>%1: ist nicht da; nenne eine Datei oder einen Ordner.</translation>
    </message>
    <message>
        <source>%1: %2 are read as %3</source>
        <translation>%1: %2 gelesen als %3</translation>
    </message>
    <message>
        <source>%1, or %2: both suit the other poses as well; %3.</source>
        <translation>%1, oder %2: beides passt gleich gut zu den anderen Posen; %3.</translation>
    </message>
    <message>
        <source>%1: what stands below its rows, behind an empty line, is left out (up to line %2).</source>
        <translation>%1: was unter den Zeilen steht, hinter einer Leerzeile, bleibt weg (bis Zeile %2).</translation>
    </message>
    <message>
        <source>%1: its rows with %2 are taken for poses of the flange, those with %3 for poses of the target, paired in their order.</source>
        <translation>%1: die Zeilen mit %2 gelten als Posen des Flansches, die mit %3 als Posen des Targets, gepaart in ihrer Reihenfolge.</translation>
    </message>
    <message>
        <source>%1: its points keep their distances from those of the files before it: they are taken for further markers of the same body (number %2 on).</source>
        <translation>%1: die Punkte behalten ihre Abstände von denen der Dateien davor: sie gelten als weitere Marker desselben Körpers (ab Nummer %2).</translation>
    </message>
    <message>
        <source>%1: has one column more than the robot has joints, and no header; the first would be a time, and does not ascend. Name the columns with --table-columns "%2 marker" (a name each; - is left out; marker says which point of a tracker a line's measurement is of).</source>
        <translation>%1: hat eine Spalte mehr als der Roboter Gelenke und keine Kopfzeile; die erste wäre eine Zeit und steigt nicht. Die Spalten mit --table-columns "%2 marker" benennen (je ein Name; - bleibt weg; marker sagt, zu welchem Punkt eines Trackers die Messung einer Zeile gehört).</translation>
    </message>
    <message>
        <source>There are %1 measurements for each line of joint readings, and they keep their distances: they are taken for the markers 0 to %2 of one body.</source>
        <translation>Auf jede Zeile mit Gelenkwinkeln kommen %1 Messungen, und sie behalten ihre Abstände: sie gelten als die Marker 0 bis %2 eines Körpers.</translation>
    </message>
    <message>
        <source>The lines of joint readings say which marker was measured (%1 lines), and there are %2 measurements of %3 points each; expected one point for each line.</source>
        <translation>Die Zeilen mit Gelenkwinkeln sagen, welcher Marker gemessen wurde (%1 Zeilen), und es gibt %2 Messungen von je %3 Punkten; erwartet wird ein Punkt je Zeile.</translation>
    </message>
    <message>
        <source>The column marker has %1, expected whole numbers.</source>
        <translation>In der Spalte marker steht %1, erwartet werden ganze Zahlen.</translation>
    </message>
    <message>
        <source>the three columns before the last three</source>
        <translation>die drei Spalten vor den letzten drei</translation>
    </message>
    <message>
        <source>%1: so %2 of %3 rows go together to %4 degrees; the others do not go with them, however they are read: observations %5. See what check says.</source>
        <translation>%1: so passen %2 von %3 Zeilen auf %4 Grad zusammen; die anderen passen nicht zu ihnen, wie man sie auch liest: Beobachtungen %5. Siehe, was check sagt.</translation>
    </message>
    <message>
        <source>stray_poses: %1 is no list of observations such as 3,5,8.</source>
        <translation>stray_poses: %1 ist keine Liste von Beobachtungen wie 3,5,8.</translation>
    </message>
    <message>
        <source>The poses of %1 of %2 observations (%3) do not go with the others, which agree among themselves: as where a board is read from its other end, a tag's tilt flips, a tracker takes a body for turned, or something moved.</source>
        <translation>Die Posen von %1 von %2 Beobachtungen (%3) passen nicht zu den anderen, die untereinander übereinstimmen: so, wie wenn ein Brett vom anderen Ende gelesen wird, die Neigung eines Tags umschlägt, ein Tracker einen Körper für gedreht hält oder sich etwas bewegt hat.</translation>
    </message>
    <message>
        <source>Leave these observations out of %1.</source>
        <translation>Diese Beobachtungen aus %1 weglassen.</translation>
    </message>
    <message>
        <source>its pose does not go with those of the others</source>
        <translation>seine Pose passt nicht zu denen der anderen</translation>
    </message>
    <message>
        <source>target_scaled: the places of the target's poses need no factor.</source>
        <translation>target_scaled: die Orte der Posen des Targets brauchen keinen Faktor.</translation>
    </message>
    <message>
        <source>target_scaled: expected a factor above 0, such as 0.5.</source>
        <translation>target_scaled: erwartet wird ein Faktor über 0, etwa 0.5.</translation>
    </message>
    <message>
        <source>The target is %1 % %2 than the size given to the program that found its poses.</source>
        <translation>Das Target ist %1 % %2, als dem Programm gesagt wurde, das seine Posen angibt.</translation>
    </message>
    <message>
        <source>Measure the target over its whole length and give the right size to that program; until then multiply the places of each &lt;target_pose&gt; in %1 by %2.</source>
        <translation>Das Target über die ganze Länge messen und diesem Programm die richtige Größe geben; bis dahin die Orte jeder &lt;target_pose&gt; in %1 mit %2 malnehmen.</translation>
    </message>
    <message>
        <source>No reading of %1 makes the motions of both agree (the best leaves %2): do the rows belong together, is one of them inverted, is the robot's file of this robot? If they do, %3.</source>
        <translation>Keine Lesart von %1 bringt die Bewegungen beider zur Übereinstimmung (die beste lässt %2): gehören die Zeilen zusammen, ist eine invertiert, ist die Roboterdatei die dieses Roboters? Wenn sie zusammengehören: %3.</translation>
    </message>
    <message>
        <source>However they are read, the motions of the flange and of the target do not agree (the best leaves %1); see what fit says.</source>
        <translation>Wie immer sie gelesen werden, die Bewegungen von Flansch und Ziel stimmen nicht überein (die beste Lesart lässt %1); nachsehen, was die Schätzung sagt.</translation>
    </message>
    <message>
        <source>; the next best reading leaves %1</source>
        <translation>; die nächstbeste Lesart lässt %1</translation>
    </message>
    <message>
        <source>%1: so the motions of the flange and of the target agree to %2%3.</source>
        <translation>%1: so stimmen die Bewegungen von Flansch und Ziel auf %2 überein%3.</translation>
    </message>
    <message>
        <source>%1: %2 may be %3, or %4, and nothing here can tell: say it with --angles (rotation_vector, rpy, abc, wpr, oat, staubli ...) and --degrees, or in the header ([deg]).</source>
        <translation>%1: %2 können %3 sein oder %4, und nichts hier kann es sagen: gib es an mit --angles (rotation_vector, rpy, abc, wpr, oat, staubli ...) und --degrees oder in der Kopfzeile ([deg]).</translation>
    </message>
    <message>
        <source>%1: %2 are taken for %3.</source>
        <translation>%1: %2 gelten als %3.</translation>
    </message>
    <message>
        <source>%1: is a second robot; name one URDF, with --robot or among the files.</source>
        <translation>%1: ist ein zweiter Roboter; nenne eine URDF, mit --robot oder unter den Dateien.</translation>
    </message>
    <message>
        <source>%1: %2 files with a pose each</source>
        <translation>%1: %2 Dateien mit je einer Pose</translation>
    </message>
    <message>
        <source>%1: %2 may be %3, or %4; name the columns roll pitch yaw or rvx rvy rvz, with their unit ([deg]).</source>
        <translation>%1: %2 können %3 sein oder %4; nenne die Spalten roll pitch yaw oder rvx rvy rvz, mit ihrer Einheit ([deg]).</translation>
    </message>
    <message>
        <source>%1: holds the only poses that are here; name those of the other (of the flange, of the target) too, points that a sensor measured, or a folder of images of a board.</source>
        <translation>%1: enthält die einzigen Posen, die da sind; nenne auch die des anderen (des Flansches, des Ziels), Punkte, die ein Sensor gemessen hat, oder einen Ordner mit Bildern eines Bretts.</translation>
    </message>
    <message>
        <source>%1: %2 may be %3, or %4: the points go with both (%5 and %6 are left); say it with --angles (rotation_vector, rpy, abc, wpr, oat, staubli ...) and --degrees, or in the header ([deg]).</source>
        <translation>%1: %2 können %3 sein oder %4: die Punkte passen zu beiden (%5 und %6 bleiben); sag es mit --angles (rotation_vector, rpy, abc, wpr, oat, staubli ...) und --degrees, oder im Kopf ([deg]).</translation>
    </message>
    <message>
        <source>%1: %2 are read as %3: %4 is left of the points, and %5 by the next best reading.</source>
        <translation>%1: %2 werden als %3 gelesen: %4 bleibt von den Punkten, und %5 mit der nächstbesten Lesart.</translation>
    </message>
    <message>
        <source>There are poses of the flange and points of %1 markers; expected one marker, or the robot's URDF and a table of its joint readings.</source>
        <translation>Es gibt Posen des Flansches und Punkte von %1 Markern; erwartet wird ein Marker, oder die URDF des Roboters und eine Tabelle seiner Gelenkwerte.</translation>
    </message>
    <message>
        <source>The flange carries the sensor, which sees a marker that stands still; where the flange carries the marker: --eye-on-base.</source>
        <translation>Der Flansch trägt den Sensor, der einen stehenden Marker sieht; trägt der Flansch den Marker: --eye-on-base.</translation>
    </message>
    <message>
        <source>The flange carries the marker, which a sensor that stands still sees.</source>
        <translation>Der Flansch trägt den Marker, den ein stehender Sensor sieht.</translation>
    </message>
    <message>
        <source>more than a metre</source>
        <translation>mehr als ein Meter</translation>
    </message>
    <message>
        <source>--apart %1: write two fixtures, by=METRES and sigma=METRES.</source>
        <translation>--apart %1: zwei Vorrichtungen schreiben, by=METER und sigma=METER.</translation>
    </message>
    <message>
        <source>--fixture %1: write what it is and its name, "plane table", "point socket_1", or a %2 with its place.</source>
        <translation>--fixture %1: schreiben, was es ist und wie es heißt: "plane table", "point socket_1", oder %2 mit ihrem Ort.</translation>
    </message>
    <message>
        <source>--fixture: %1 is no number of metres.</source>
        <translation>--fixture: %1 ist keine Zahl von Metern.</translation>
    </message>
    <message>
        <source>--tcp %1: the robot has no such link; it has: %2.</source>
        <translation>--tcp %1: ein solches Glied hat der Roboter nicht; er hat: %2.</translation>
    </message>
    <message>
        <source>There is no robot; name its URDF with --robot.</source>
        <translation>Es gibt keinen Roboter; seine URDF mit --robot nennen.</translation>
    </message>
    <message>
        <source>The robot's URDF text is not at hand; name the file with --robot to export it calibrated.</source>
        <translation>Der Text der URDF des Roboters ist nicht da; die Datei mit --robot nennen, um sie kalibriert zu exportieren.</translation>
    </message>
    <message>
        <source>lerobot's calibration cannot be read; expected the JSON object that lerobot wrote, a motor each.</source>
        <translation>lerobots Kalibrierung lässt sich nicht lesen; erwartet wird das JSON-Objekt, das lerobot geschrieben hat, ein Motor je Eintrag.</translation>
    </message>
    <message>
        <source>%1: has %2 columns and no header, the robot %3 joints that move by themselves: %4. Write a first line with the columns' names.</source>
        <translation>%1: hat %2 Spalten und keine Überschrift, der Roboter %3 Gelenke, die sich von selbst bewegen: %4. Schreib eine erste Zeile mit den Namen der Spalten.</translation>
    </message>
    <message>
        <source>%1: has no header; its columns are taken for %2%3.</source>
        <translation>%1: hat keine Kopfzeile; die Spalten gelten als %2%3.</translation>
    </message>
    <message>
        <source>time </source>
        <translation>Zeit </translation>
    </message>
    <message>
        <source>%1: %2 columns are no joints of the robot and are left out.</source>
        <translation>%1: %2 Spalten sind keine Gelenke des Roboters und bleiben weg.</translation>
    </message>
    <message>
        <source> With %1 and %2 exchanged all would be within them.</source>
        <translation> Mit %1 und %2 vertauscht lägen alle darin.</translation>
    </message>
    <message>
        <source>%1: joint %2 goes %3 %4 beyond its limits: are the columns in another order than the robot's joints, or of another unit?%5</source>
        <translation>%1: Gelenk %2 geht %3 %4 über seine Grenzen: stehen die Spalten in anderer Reihenfolge als die Gelenke des Roboters, oder haben sie eine andere Einheit?%5</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>%1: joint %2 stands at %3, which in rad is %4 turns: these are degrees%5. Say --degrees, or write the unit into the header: "%6 [deg]".</source>
        <translation>%1: Gelenk %2 steht auf %3, was in rad %4 Umdrehungen sind: das sind Grad%5. --degrees angeben oder die Einheit in die Kopfzeile schreiben: "%6 [deg]".</translation>
    </message>
    <message>
        <source>, or per cent of its range as servos tell it (then name LeRobot's calibration too)</source>
        <translation>, oder Prozent seines Bereichs, wie Servos sie nennen (dann auch LeRobots Kalibrierung angeben)</translation>
    </message>
    <message>
        <source>%1: angles are read as degrees.</source>
        <translation>%1: Winkel werden als Grad gelesen.</translation>
    </message>
    <message>
        <source> In the reverse order all would be within them.</source>
        <translation> In umgekehrter Reihenfolge lägen alle darin.</translation>
    </message>
    <message>
        <source>%1: [%2] has a camera matrix of %3 numbers; expected 9.</source>
        <translation>%1: [%2] hat eine Kameramatrix aus %3 Zahlen; erwartet werden 9.</translation>
    </message>
    <message>
        <source>%1: has %2 cameras; expected one, or a left and a right one.</source>
        <translation>%1: hat %2 Kameras; erwartet wird eine, oder eine linke und eine rechte.</translation>
    </message>
    <message>
        <source>%1: has no frames below its header; expected a line a frame.</source>
        <translation>%1: hat unter dem Kopf keine Bilder; erwartet wird eine Zeile je Bild.</translation>
    </message>
    <message>
        <source>%1: has no number %2; expected Kalibr's description of a target, whole.</source>
        <translation>%1: hat keine Zahl %2; erwartet wird Kalibrs vollständige Beschreibung eines Ziels.</translation>
    </message>
    <message>
        <source>%1: %2 is %3; expected a whole number from 1 on.</source>
        <translation>%1: %2 ist %3; erwartet wird eine ganze Zahl ab 1.</translation>
    </message>
    <message>
        <source>%1: its fields are %2 m x %3 m; expected squares (rowSpacingMeters and colSpacingMeters equal).</source>
        <translation>%1: seine Felder sind %2 m x %3 m; erwartet werden Quadrate (rowSpacingMeters und colSpacingMeters gleich).</translation>
    </message>
    <message>
        <source>%1: describes a grid of circles, without their diameter, which is needed; expected it in words: --target circles columns=%2 rows=%3 spacing=%4 diameter=METRES layout=%5.</source>
        <translation>%1: beschreibt ein Gitter aus Kreisen ohne deren Durchmesser, der nötig ist; erwartet ist es in Worten: --target circles columns=%2 rows=%3 spacing=%4 diameter=METER layout=%5.</translation>
    </message>
    <message>
        <source>asymmetric</source>
        <translation>asymmetric</translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>symmetric</translation>
    </message>
    <message>
        <source>%1: describes a target of the type %2, which is not found in images; expected aprilgrid or checkerboard: `handsight-cli target` draws one.</source>
        <translation>%1: beschreibt ein Ziel der Art %2, das in Bildern nicht gefunden wird; erwartet wird aprilgrid oder checkerboard: `handsight-cli target` zeichnet eines.</translation>
    </message>
    <message>
        <source>%1: images of the encoding %2 cannot be read; publish mono8, mono16, rgb8 or bgr8 (image_proc makes them of Bayer patterns).</source>
        <translation>%1: Bilder der Kodierung %2 lassen sich nicht lesen; veröffentliche mono8, mono16, rgb8 oder bgr8 (image_proc macht sie aus Bayer-Mustern).</translation>
    </message>
    <message>
        <source>%1: its rows are shorter than its width.</source>
        <translation>%1: die Zeilen sind kürzer als die Breite.</translation>
    </message>
    <message>
        <source>%1: compressed images of the format %2 cannot be read; expected PNG, JPEG or WebP.</source>
        <translation>%1: komprimierte Bilder des Formats %2 lassen sich nicht lesen; erwartet wird PNG, JPEG oder WebP.</translation>
    </message>
    <message>
        <source>%1, topic %2</source>
        <translation>%1, topic %2</translation>
    </message>
    <message>
        <source>%1: has no number %2; expected a calibration that is whole.</source>
        <translation>%1: hat keine Zahl %2; erwartet wird eine vollständige Kalibrierung.</translation>
    </message>
    <message>
        <source>%1: k does not hold 9 finite numbers; expected the whole text of `ros2 topic echo --full-length`.</source>
        <translation>%1: k enthält nicht 9 endliche Zahlen; erwartet wird der ganze Text von `ros2 topic echo --full-length`.</translation>
    </message>
    <message>
        <source>%1: the camera is of camodocal's model %2, which sessions do not have; calibrate it as PINHOLE or, a wide lens, as KANNALA_BRANDT, or with `handsight-cli cameras`.</source>
        <translation>%1: die Kamera ist von camodocals Modell %2, das Sitzungen nicht haben; kalibriere sie als PINHOLE oder, ein weites Objektiv, als KANNALA_BRANDT, oder mit `handsight-cli cameras`.</translation>
    </message>
    <message>
        <source>%1: has no projection_parameters; expected a calibration that is whole.</source>
        <translation>%1: hat keine projection_parameters; erwartet wird eine vollständige Kalibrierung.</translation>
    </message>
    <message>
        <source>%1, topic %2: %3 of %4 messages are damaged and are left out.</source>
        <translation>%1, topic %2: %3 von %4 Nachrichten sind beschädigt und bleiben weg.</translation>
    </message>
    <message>
        <source>%1: %2 joints that were published are no moving joints of the robot and are left out.</source>
        <translation>%1: %2 veröffentlichte Gelenke sind keine beweglichen Gelenke des Roboters und bleiben weg.</translation>
    </message>
    <message>
        <source>%1: topic %2 (%3%4, %5 messages) is left out.</source>
        <translation>%1: topic %2 (%3%4, %5 Nachrichten) bleibt weg.</translation>
    </message>
    <message>
        <source>of a type that is not told</source>
        <translation>von einer Art, die nicht gesagt wird</translation>
    </message>
    <message>
        <source> as </source>
        <translation> als </translation>
    </message>
    <message>
        <source>%1: no limits are given for %2: they are taken to turn and slide without end, and corrections will not stop at them.</source>
        <translation>%1: für %2 sind keine Grenzen angegeben: sie gelten als ohne Ende dreh- und schiebbar, und Korrekturen machen vor ihnen nicht halt.</translation>
    </message>
    <message>
        <source>%1: no link has a mass: springs cannot show, and gravity bends nothing. Put the masses of the maker's data sheet into &lt;inertial&gt;.</source>
        <translation>%1: kein Glied hat eine Masse: Federn können sich nicht zeigen, und die Schwerkraft biegt nichts. Setze die Massen aus dem Datenblatt des Herstellers in &lt;inertial&gt; ein.</translation>
    </message>
    <message>
        <source>%1: %2 moving links have no mass: %3. What gravity does through them is missing.</source>
        <translation>%1: %2 bewegliche Glieder haben keine Masse: %3. Was die Schwerkraft durch sie tut, fehlt.</translation>
    </message>
    <message>
        <source>%1: its %2 meshes%3 are not copied: they are drawn where they are found beside the robot, else plain limbs are. Nothing that is measured depends on them.</source>
        <translation>%1: seine %2 Netze%3 werden nicht kopiert: sie werden gezeichnet, wo sie neben dem Roboter liegen, sonst schlichte Glieder. Nichts Gemessenes hängt davon ab.</translation>
    </message>
    <message>
        <source> (%1 by package://)</source>
        <translation> (%1 über package://)</translation>
    </message>
    <message>
        <source>%1: %2 stand still in the session's copy: a session has one number a joint. Where the robot drove between observations, each place is a session of its own.</source>
        <translation>%1: %2 stehen in der Kopie der Sitzung still: eine Sitzung hat eine Zahl je Gelenk. Wo der Roboter zwischen Beobachtungen fuhr, ist jeder Ort eine eigene Sitzung.</translation>
    </message>
    <message>
        <source>the matrices</source>
        <translation>die Matrizen</translation>
    </message>
    <message>
        <source>the last four columns</source>
        <translation>die letzten vier Spalten</translation>
    </message>
    <message>
        <source>the last three columns</source>
        <translation>die letzten drei Spalten</translation>
    </message>
    <message>
        <source>%1: holds no single pose, or has no number in its name; expected a 4x4 matrix.</source>
        <translation>%1: enthält nicht eine einzelne Pose oder hat keine Nummer im Namen; erwartet wird eine 4x4-Matrix.</translation>
    </message>
    <message>
        <source>%1: another file of poses has the number %2 too; expected one for each instant.</source>
        <translation>%1: eine andere Datei von Posen hat auch die Nummer %2; erwartet wird eine für jeden Augenblick.</translation>
    </message>
    <message>
        <source>%1: the section %2 is left out.</source>
        <translation>%1: der Abschnitt %2 bleibt weg.</translation>
    </message>
    <message>
        <source>%1: its markers are left out, its rigid bodies count.</source>
        <translation>%1: ihre Marker bleiben weg, ihre starren Körper zählen.</translation>
    </message>
    <message>
        <source>%1: has neither Objects nor Segments nor Trajectories; export it again with one of them.</source>
        <translation>%1: hat weder Objects noch Segments noch Trajectories; exportiere sie noch einmal mit einem davon.</translation>
    </message>
    <message>
        <source>%1: is longer than 16 MB, which no calibration is.</source>
        <translation>%1: ist länger als 16 MB, was keine Kalibrierung ist.</translation>
    </message>
    <message>
        <source>%1: is nested more deeply than any calibration is.</source>
        <translation>%1: ist tiefer verschachtelt als jede Kalibrierung.</translation>
    </message>
    <message>
        <source>%1, line %2: is no YAML: %3; expected `name: value` lines.</source>
        <translation>%1, Zeile %2: ist kein YAML: %3; erwartet werden Zeilen `name: wert`.</translation>
    </message>
    <message>
        <source>%1: has no %2 of %3 finite numbers; expected a calibration that is whole.</source>
        <translation>%1: hat kein %2 aus %3 endlichen Zahlen; erwartet wird eine vollständige Kalibrierung.</translation>
    </message>
    <message>
        <source>%1: a camera is of the model %2, which sessions do not have; calibrate it as pinhole-radtan.</source>
        <translation>%1: eine Kamera hat das Modell %2, das Sitzungen nicht haben; kalibriere sie als pinhole-radtan.</translation>
    </message>
    <message>
        <source>%1: the camera's matrix holds zeros: the driver publishes no calibration; calibrate it, or name a file that has one.</source>
        <translation>%1: die Matrix der Kamera enthält Nullen: der Treiber veröffentlicht keine Kalibrierung; kalibriere sie, oder nenne eine Datei, die eine hat.</translation>
    </message>
    <message>
        <source>%1: has a focal length of %2 px; expected one from %3 to %4.</source>
        <translation>%1: hat eine Brennweite von %2 px; erwartet wird eine von %3 bis %4.</translation>
    </message>
    <message>
        <source>%1: holds %2, no place in an image.</source>
        <translation>%1: enthält %2, keinen Ort in einem Bild.</translation>
    </message>
    <message>
        <source>%1: holds %2, no lens bends so.</source>
        <translation>%1: enthält %2, so biegt keine Linse.</translation>
    </message>
    <message>
        <source>%1: does not say how large the images are; expected image_width and image_height.</source>
        <translation>%1: sagt nicht, wie groß die Bilder sind; erwartet werden image_width und image_height.</translation>
    </message>
    <message>
        <source>%1: the lens is of the model %2, which sessions do not have; calibrate with plumb_bob (k1 k2 p1 p2 k3), rational_polynomial or equidistant.</source>
        <translation>%1: die Linse hat das Modell %2, das Sitzungen nicht haben; kalibriere mit plumb_bob (k1 k2 p1 p2 k3), rational_polynomial oder equidistant.</translation>
    </message>
    <message>
        <source>%1: the lens has %2 distortion terms; calibrate it with %3.</source>
        <translation>%1: die Linse hat %2 Verzeichnungsterme; kalibriere sie mit %3.</translation>
    </message>
    <message>
        <source>%1: T_cn_cnm1 holds no rotation; expected the motion from the camera before.</source>
        <translation>%1: T_cn_cnm1 enthält keine Drehung; erwartet wird die Bewegung von der Kamera davor.</translation>
    </message>
    <message>
        <source>%1: of its cameras the first %2 are taken, the others are left out.</source>
        <translation>%1: von seinen Kameras werden die ersten %2 genommen, die anderen bleiben weg.</translation>
    </message>
    <message>
        <source>%1 stands in column %2%3, expected a finite number such as 0.5.</source>
        <translation>%1 steht in Spalte %2%3; erwartet wird eine endliche Zahl wie 0.5.</translation>
    </message>
    <message>
        <source>%1: commas are read as decimal points.</source>
        <translation>%1: Kommas werden als Dezimalpunkte gelesen.</translation>
    </message>
    <message>
        <source>%1: the times are taken for %2.</source>
        <translation>%1: die Zeiten werden genommen für %2.</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>Nanosekunden</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>Mikrosekunden</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>%1: the lines do not stand in order of time; they were sorted.</source>
        <translation>%1: die Zeilen stehen nicht in der Reihenfolge der Zeit; sie wurden sortiert.</translation>
    </message>
    <message>
        <source>%1: has a line for each marker, and no column that says which lines are of one instant; expected `observation` or `time`.</source>
        <translation>%1: hat eine Zeile je Marker und keine Spalte, die sagt, welche Zeilen von einem Zeitpunkt sind; erwartet wird `observation` oder `time`.</translation>
    </message>
    <message>
        <source>%1: has no header; its columns are taken for %2x y z of %3 points.</source>
        <translation>%1: hat keine Kopfzeile; die Spalten gelten als %2x y z von %3 Punkten.</translation>
    </message>
    <message>
        <source>time and </source>
        <translation>Zeit und </translation>
    </message>
    <message>
        <source>%1: holds %2 points an instant; a session has up to %3 markers.</source>
        <translation>%1: enthält %2 Punkte je Zeitpunkt; eine Sitzung hat bis zu %3 Marker.</translation>
    </message>
    <message>
        <source>%1: lengths of %2 are taken for millimetres; a session holds metres.</source>
        <translation>%1: Längen von %2 werden für Millimeter gehalten; eine Sitzung hat Meter.</translation>
    </message>
    <message>
        <source>%1: pose %2 %3; expected x y z in m and a unit quaternion x y z w.</source>
        <translation>%1: Pose %2 %3; erwartet werden x y z in m und ein Einheitsquaternion x y z w.</translation>
    </message>
    <message>
        <source>%1: holds poses of %2 things (%3); expected those of the flange and of the target.</source>
        <translation>%1: enthält Posen von %2 Dingen (%3); erwartet werden die des Flansches und die des Ziels.</translation>
    </message>
    <message>
        <source>%1: has %2 poses %3 and %4 poses %5; expected one of each an instant.</source>
        <translation>%1: hat %2 Posen %3 und %4 Posen %5; erwartet wird je eine für jeden Augenblick.</translation>
    </message>
    <message>
        <source>%1: the lens is of RealSense's model %2, which sessions do not have; calibrate the camera with `handsight-cli cameras`.</source>
        <translation>%1: das Objektiv ist von RealSenses Modell %2, das Sitzungen nicht haben; kalibriere die Kamera mit `handsight-cli cameras`.</translation>
    </message>
    <message>
        <source>%1: its coefficients are of the model inverse Brown-Conrady; they are taken as Brown's, as librealsense projects with them.</source>
        <translation>%1: ihre Koeffizienten sind vom Modell inverse Brown-Conrady; sie werden als die von Brown genommen, wie librealsense mit ihnen projiziert.</translation>
    </message>
    <message>
        <source>%1: has no number %2; expected width height ppx ppy fx fy.</source>
        <translation>%1: hat keine Zahl %2; erwartet werden width height ppx ppy fx fy.</translation>
    </message>
    <message>
        <source>%1: lists %2 streams (%3); keep the lines of the one that the images are of, from "Intrinsic of" to "Coeffs".</source>
        <translation>%1: nennt %2 Ströme (%3); behalte die Zeilen dessen, von dem die Bilder sind, von "Intrinsic of" bis "Coeffs".</translation>
    </message>
    <message>
        <source>%1: does not say where the camera is; it is taken to be on the hand (--eye-on-base: on a stand).</source>
        <translation>%1: sagt nicht, wo die Kamera ist; sie gilt als an der Hand (--eye-on-base: auf einem Ständer).</translation>
    </message>
    <message>
        <source>%1: angles of up to %2 can only be degrees; they are read so.</source>
        <translation>%1: Winkel bis %2 können nur Grad sein; so werden sie gelesen.</translation>
    </message>
    <message>
        <source>%1: pose %2 lies outside of any room; expected lengths in m or mm.</source>
        <translation>%1: Pose %2 liegt außerhalb jedes Raums; erwartet werden Längen in m oder mm.</translation>
    </message>
    <message>
        <source>%1: has no row with a whole pose; expected a place and a rotation in each.</source>
        <translation>%1: hat keine Zeile mit einer ganzen Pose; erwartet wird in jeder ein Ort und eine Drehung.</translation>
    </message>
    <message>
        <source>%1: a pose has no unit quaternion (%2); expected four numbers whose squares sum to 1.</source>
        <translation>%1: eine Pose hat kein Einheitsquaternion (%2); erwartet werden vier Zahlen, deren Quadrate die Summe 1 haben.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows hold no whole pose (nan or empty); there nothing was measured.</source>
        <translation>%1: %2 von %3 Zeilen haben keine ganze Pose (nan oder leer); dort wurde nichts gemessen.</translation>
    </message>
    <message>
        <source> in degrees</source>
        <translation> in Grad</translation>
    </message>
    <message>
        <source> in rad</source>
        <translation> in rad</translation>
    </message>
    <message>
        <source>%1: has no header; its columns are taken for %2x y z qx qy qz qw.</source>
        <translation>%1: hat keine Kopfzeile; die Spalten gelten als %2x y z qx qy qz qw.</translation>
    </message>
    <message>
        <source>%1: is no file that OpenCV's FileStorage wrote (YAML, XML or JSON): %2; name the stereo calibration.</source>
        <translation>%1: ist keine Datei, die OpenCVs FileStorage geschrieben hat (YAML, XML oder JSON): %2; nenne die Stereokalibrierung.</translation>
    </message>
    <message>
        <source>it says %1 x %2 and has %3 numbers</source>
        <translation>sie sagt %1 x %2 und hat %3 Zahlen</translation>
    </message>
    <message>
        <source>it holds %1</source>
        <translation>sie enthält %1</translation>
    </message>
    <message>
        <source>it is a list of %1 numbers</source>
        <translation>sie ist eine Liste von %1 Zahlen</translation>
    </message>
    <message>
        <source>%1 is no finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>its rows or cols are none of a camera's matrix</source>
        <translation>rows oder cols sind nicht die einer Kameramatrix</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>sie ist leer</translation>
    </message>
    <message>
        <source>its list is not closed</source>
        <translation>ihre Liste ist nicht geschlossen</translation>
    </message>
    <message>
        <source>its data is no list</source>
        <translation>ihr data ist keine Liste</translation>
    </message>
    <message>
        <source>its elements are nested too deeply</source>
        <translation>ihre Elemente sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>%1: %2 columns are no joints of the session and are ignored.</source>
        <translation>%1: %2 Spalten sind keine Gelenke der Sitzung und werden übergangen.</translation>
    </message>
    <message>
        <source>holds a cell that is no number.</source>
        <translation>enthält eine Zelle, die keine Zahl ist.</translation>
    </message>
    <message>
        <source>holds messages of a bag as `mcap cat --json` prints them; name the bag itself (.mcap), which is read as it is</source>
        <translation>enthält Nachrichten eines Bags, wie `mcap cat --json` sie ausgibt; nenne das Bag selbst (.mcap), das gelesen wird, wie es ist</translation>
    </message>
    <message>
        <source>%1: holds a folder for each sample (%2); what is read is a folder of images for each camera and one table with a line for each sample: `%3`</source>
        <translation>%1: enthält einen Ordner für jede Probe (%2); gelesen werden ein Ordner von Bildern für jede Kamera und eine Tabelle mit einer Zeile für jede Probe: `%3`</translation>
    </message>
    <message>
        <source>%1: its messages hold several poses each (PoseArray), and which is meant nothing tells; `ros2 topic echo --field poses[0] TOPIC` prints one of them.</source>
        <translation>%1: Seine Nachrichten enthalten je mehrere Posen (PoseArray), und welche gemeint ist, sagt nichts; `ros2 topic echo --field poses[0] TOPIC` gibt eine davon aus.</translation>
    </message>
    <message>
        <source>has not 16 columns for each of BODY_NAMES (X to Rot[8]); export the 6DOF data whole.</source>
        <translation>hat nicht 16 Spalten für jeden aus BODY_NAMES (X bis Rot[8]); exportiere die 6DOF-Daten ganz.</translation>
    </message>
    <message>
        <source>has not three columns for each of MARKER_NAMES; export the 3D data whole.</source>
        <translation>hat nicht drei Spalten für jeden aus MARKER_NAMES; exportiere die 3D-Daten ganz.</translation>
    </message>
    <message>
        <source>%1: names no bodies or markers, or has no frames; export the 6D or 3D data from QTM with its header.</source>
        <translation>%1: nennt keine Körper oder Marker oder hat keine Bilder; exportiere die 6D- oder 3D-Daten aus QTM mit ihrem Kopf.</translation>
    </message>
    <message>
        <source>%1: has neither times nor a FREQUENCY; export it again with its times.</source>
        <translation>%1: hat weder Zeiten noch eine FREQUENCY; exportiere es noch einmal mit Zeiten.</translation>
    </message>
    <message>
        <source>%1: begins as Motive's CSV does and has no rigid bodies or markers in its header; export it again with them.</source>
        <translation>%1: beginnt wie Motives CSV und hat im Kopf weder starre Körper noch Marker; exportiere sie noch einmal mit ihnen.</translation>
    </message>
    <message>
        <source>%1: its turns are Euler angles (%2); export it again with the rotation type Quaternion.</source>
        <translation>%1: ihre Drehungen sind Euler-Winkel (%2); exportiere sie noch einmal mit der Drehungsart Quaternion.</translation>
    </message>
    <message>
        <source>%1: %2 markers beside the rigid bodies are left out.</source>
        <translation>%1: %2 Marker neben den starren Körpern bleiben weg.</translation>
    </message>
    <message>
        <source>%1: %2 is no matrix of finite numbers: %3; expected what OpenCV's stereoCalibrate writes.</source>
        <translation>%1: %2 ist keine Matrix endlicher Zahlen: %3; erwartet wird, was OpenCVs stereoCalibrate schreibt.</translation>
    </message>
    <message>
        <source>%1: the %2 camera matrix is %3 x %4; expected 3 x 3 with positive focal lengths.</source>
        <translation>%1: die Matrix der Kamera (%2) ist %3 x %4; erwartet wird 3 x 3 mit positiven Brennweiten.</translation>
    </message>
    <message>
        <source>%1: the %2 camera has a focal length of %3 px; expected one from %4 to %5.</source>
        <translation>%1: die Kamera (%2) hat eine Brennweite von %3 px; erwartet wird eine von %4 bis %5.</translation>
    </message>
    <message>
        <source>%1: the %2 camera matrix holds %3; expected at most %4 px.</source>
        <translation>%1: die Kameramatrix %2 enthält %3; erwartet werden höchstens %4 px.</translation>
    </message>
    <message>
        <source>%1: the %2 camera has %3 distortion terms (rational, thin prism or tilted); calibrate it with five (k1 k2 p1 p2 k3).</source>
        <translation>%1: die Kamera %2 hat %3 Verzeichnungsterme (rational, dünnes Prisma oder gekippt); kalibriere sie mit fünf (k1 k2 p1 p2 k3).</translation>
    </message>
    <message>
        <source>%1: R is no rotation (its columns are not of length 1 and square to each other).</source>
        <translation>%1: R ist keine Drehung (ihre Spalten sind nicht von Länge 1 und senkrecht zueinander).</translation>
    </message>
    <message>
        <source>%1: R is %2 x %3; expected a 3 x 3 rotation or a rotation vector.</source>
        <translation>%1: R ist %2 x %3; erwartet wird eine Drehmatrix 3 x 3 oder ein Drehvektor.</translation>
    </message>
    <message>
        <source>%1: T is %2 long and is taken for millimetres: the cameras are %3 mm apart.</source>
        <translation>%1: T ist %2 lang und gilt als Millimeter: die Kameras stehen %3 mm auseinander.</translation>
    </message>
    <message>
        <source>%1: the %2 camera has %3 distortion terms; expected %4.</source>
        <translation>%1: die Kamera %2 hat %3 Verzeichnungsterme; erwartet werden %4.</translation>
    </message>
    <message>
        <source>the four of a fisheye (k1 k2 k3 k4)</source>
        <translation>die vier eines Fischauges (k1 k2 k3 k4)</translation>
    </message>
    <message>
        <source>five (k1 k2 p1 p2 k3) or eight with the rational ones</source>
        <translation>fünf (k1 k2 p1 p2 k3) oder acht mit den rationalen</translation>
    </message>
    <message>
        <source>%1: has no R%2 and T%3 of camera %4; name the file that says where it is to the first.</source>
        <translation>%1: hat kein R%2 und T%3 der Kamera %4; nenne die Datei, die sagt, wo sie zur ersten liegt.</translation>
    </message>
    <message>
        <source>%1: has no %2; name the file of OpenCV's stereoCalibrate that has it too.</source>
        <translation>%1: hat keine %2; nenne auch die Datei von OpenCVs stereoCalibrate, in der sie steht.</translation>
    </message>
    <message>
        <source>No file</source>
        <translation>Keine Datei</translation>
    </message>
    <message>
        <source>rotation R between the cameras</source>
        <translation>Drehung R zwischen den Kameras</translation>
    </message>
    <message>
        <source>translation T between the cameras</source>
        <translation>Verschiebung T zwischen den Kameras</translation>
    </message>
    <message>
        <source>%1: the file cannot be read; is it there, and may you read it?</source>
        <translation>%1: die Datei lässt sich nicht lesen; gibt es sie, und darfst du sie lesen?</translation>
    </message>
    <message>
        <source>%1: is a bag of ROS 1 of the version %2; expected V2.0. `rosbag fix OLD.bag NEW.bag` of ROS writes it anew.</source>
        <translation>%1: ist ein Bag von ROS 1 der Version %2; erwartet wird V2.0. `rosbag fix ALT.bag NEU.bag` von ROS schreibt es neu.</translation>
    </message>
    <message>
        <source>%1: does not begin as a bag does: it was not copied whole, or is of another kind; expected a ROS 2 bag (sqlite3 or MCAP) or a ROS 1 bag of version 2.0.</source>
        <translation>%1: beginnt nicht wie ein Bag: es wurde nicht ganz kopiert oder ist von anderer Art; erwartet wird ein ROS-2-Bag (sqlite3 oder MCAP) oder ein ROS-1-Bag der Version 2.0.</translation>
    </message>
    <message>
        <source>%1: its zstd is damaged (%2): what comes after the damage is lost.</source>
        <translation>%1: ihr zstd ist beschädigt (%2): was nach dem Schaden kommt, ist verloren.</translation>
    </message>
    <message>
        <source>%1: is compressed with zstd, and damaged (%2); expected a whole file: copy it again.</source>
        <translation>%1: ist mit zstd komprimiert und beschädigt (%2); erwartet wird eine ganze Datei: kopiere sie noch einmal.</translation>
    </message>
    <message>
        <source>%1: %2 messages whose compression is damaged are left out.</source>
        <translation>%1: %2 Nachrichten, deren Kompression beschädigt ist, bleiben weg.</translation>
    </message>
    <message>
        <source>%1: %2 more places are damaged.</source>
        <translation>%1: %2 weitere Stellen sind beschädigt.</translation>
    </message>
    <message>
        <source>%1: is a bag of ROS 1 without a connection: nothing was recorded, or it is damaged; expected a bag with messages: record it again, or try `rosbag reindex`.</source>
        <translation>%1: ist ein Bag von ROS 1 ohne Verbindung: es wurde nichts aufgezeichnet, oder es ist beschädigt; erwartet wird ein Bag mit Nachrichten: nimm es neu auf, oder versuche `rosbag reindex`.</translation>
    </message>
    <message>
        <source>%1: is encrypted (%2); expected one that is not: `rosbag decrypt` of ROS writes it.</source>
        <translation>%1: ist verschlüsselt (%2); erwartet wird ein unverschlüsseltes: `rosbag decrypt` von ROS schreibt es.</translation>
    </message>
    <message>
        <source>%1: %2 messages are of connections that are described nowhere and are left out.</source>
        <translation>%1: %2 Nachrichten sind von Verbindungen, die nirgends beschrieben sind, und bleiben weg.</translation>
    </message>
    <message>
        <source>it is compressed with %1, which is not read</source>
        <translation>er ist mit %1 gepackt, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>%1: the chunk at byte %2 is left out: %3.</source>
        <translation>%1: der Abschnitt ab Byte %2 bleibt weg: %3.</translation>
    </message>
    <message>
        <source>%1: is damaged at byte %2: %3 bytes up to the next chunk are left out.</source>
        <translation>%1: ist bei Byte %2 beschädigt: %3 Byte bis zum nächsten Abschnitt bleiben weg.</translation>
    </message>
    <message>
        <source>%1: it is broken off or damaged at byte %2 of %3: after %4 messages the rest is lost.</source>
        <translation>%1: sie bricht bei Byte %2 von %3 ab oder ist dort beschädigt: nach %4 Nachrichten ist der Rest verloren.</translation>
    </message>
    <message>
        <source>it says that it is larger than 1 GiB</source>
        <translation>er sagt, er sei größer als 1 GiB</translation>
    </message>
    <message>
        <source>it holds less than it says</source>
        <translation>er enthält weniger, als er sagt</translation>
    </message>
    <message>
        <source>a record in it is damaged; what stands before it is read</source>
        <translation>ein Eintrag darin ist beschädigt; was davor steht, wird gelesen</translation>
    </message>
    <message>
        <source>%1: begins as MCAP does and holds no channel: it was broken off before anything was recorded, or is damaged; expected a recording with messages: record it again, or try `mcap recover`.</source>
        <translation>%1: beginnt wie MCAP und enthält keinen Kanal: die Aufnahme brach ab, bevor etwas aufgezeichnet war, oder sie ist beschädigt; erwartet wird eine Aufnahme mit Nachrichten: nimm sie neu auf, oder versuche `mcap recover`.</translation>
    </message>
    <message>
        <source>%1: %2 messages are of channels that are described nowhere and are left out.</source>
        <translation>%1: %2 Nachrichten sind von Kanälen, die nirgends beschrieben sind, und bleiben weg.</translation>
    </message>
    <message>
        <source>%1: its checksum does not agree: some of its bytes have changed since it was written; its messages are taken as they are.</source>
        <translation>%1: die Prüfsumme stimmt nicht: einige Bytes haben sich geändert, seit sie geschrieben wurde; die Nachrichten werden genommen, wie sie sind.</translation>
    </message>
    <message>
        <source> (%1 s to %2 s)</source>
        <translation> (%1 s bis %2 s)</translation>
    </message>
    <message>
        <source>, %1 messages</source>
        <translation>, %1 Nachrichten</translation>
    </message>
    <message>
        <source>%1: it is broken off at byte %2 of a record that begins at %3: after %4 messages the rest is lost.</source>
        <translation>%1: sie bricht bei Byte %2 eines Eintrags ab, der bei %3 beginnt: nach %4 Nachrichten ist der Rest verloren.</translation>
    </message>
    <message>
        <source>%1: at byte %2 of %3 stands no record: it is damaged, and after %4 messages the rest is lost.</source>
        <translation>%1: bei Byte %2 von %3 steht kein Eintrag: sie ist beschädigt, und nach %4 Nachrichten ist der Rest verloren.</translation>
    </message>
    <message>
        <source>its head is damaged</source>
        <translation>sein Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>its checksum does not agree</source>
        <translation>seine Prüfsumme stimmt nicht</translation>
    </message>
    <message>
        <source>%1: %2; the bag is damaged, or the message is of another type than it says.</source>
        <translation>%1: %2; das Bag ist beschädigt, oder die Nachricht ist von anderer Art, als sie sagt.</translation>
    </message>
    <message>
        <source>%1: is damaged (%2): after %3 messages the rest is lost.</source>
        <translation>%1: ist beschädigt (%2): nach %3 Nachrichten ist der Rest verloren.</translation>
    </message>
    <message>
        <source>%1: is no ROS 2 bag in sqlite3 that can be read: %2; expected what `ros2 bag record` writes: copy it again, or write it anew with `ros2 bag convert`.</source>
        <translation>%1: ist kein ROS-2-Bag in sqlite3, das sich lesen ließe: %2; erwartet wird, was `ros2 bag record` schreibt: kopiere es noch einmal, oder schreibe es neu mit `ros2 bag convert`.</translation>
    </message>
    <message>
        <source>%1: there is no room to decompress it in %2; make room there, or name another folder in TMPDIR.</source>
        <translation>%1: in %2 ist kein Platz, um sie zu entpacken; schaffe dort Platz, oder nenne einen anderen Ordner in TMPDIR.</translation>
    </message>
    <message>
        <source>it holds more than it says</source>
        <translation>er enthält mehr, als er sagt</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>er endet zu früh</translation>
    </message>
    <message>
        <source>its zstd blocks are damaged</source>
        <translation>seine zstd-Blöcke sind beschädigt</translation>
    </message>
    <message>
        <source>its bz2 blocks do not agree with their sums</source>
        <translation>seine bz2-Blöcke stimmen nicht mit ihren Summen überein</translation>
    </message>
    <message>
        <source>%1: is of LeRobot's older form, which holds no ranges; `lerobot-calibrate` of a newer one writes them.</source>
        <translation>%1: ist von LeRobots älterer Form, die keine Bereiche enthält; `lerobot-calibrate` eines neueren schreibt sie.</translation>
    </message>
    <message>
        <source>%1: servo %2 has no range_min below its range_max; expected LeRobot's calibration.</source>
        <translation>%1: Servo %2 hat kein range_min unter seinem range_max; erwartet wird LeRobots Kalibrierung.</translation>
    </message>
    <message>
        <source>%1: no column has the name of a servo of LeRobot's calibration, which is not used.</source>
        <translation>%1: keine Spalte heißt wie ein Servo aus LeRobots Kalibrierung, die nicht benutzt wird.</translation>
    </message>
    <message>
        <source>%1: %2 columns are read as %3; 0 is the middle of each range: where the robot's URDF has another zero, joint_offset finds it.</source>
        <translation>%1: %2 Spalten werden als %3 gelesen; 0 ist die Mitte jedes Bereichs: wo die URDF des Roboters eine andere Null hat, findet sie joint_offset.</translation>
    </message>
    <message>
        <source>%1: that %2 follows %3 is left out: it is no straight line.</source>
        <translation>%1: dass %2 %3 folgt, bleibt weg: es ist keine Gerade.</translation>
    </message>
    <message>
        <source>%1: %2 stand still in the session's copy: a session has one number a joint.</source>
        <translation>%1: %2 stehen in der Kopie der Sitzung still: eine Sitzung hat eine Zahl je Gelenk.</translation>
    </message>
    <message>
        <source>%1: xacro cannot expand it (%2); expand it with the arguments that the robot's launch file gives, `xacro %3 NAME:=VALUE &gt; robot.urdf`, and name robot.urdf.</source>
        <translation>%1: xacro kann sie nicht entfalten (%2); entfalte sie mit den Argumenten, die die Launch-Datei des Roboters gibt, `xacro %3 NAME:=VALUE &gt; robot.urdf`, und nenne robot.urdf.</translation>
    </message>
    <message>
        <source>%1: is a model of MuJoCo; the session's robot is a URDF of its bodies and joints.</source>
        <translation>%1: ist ein Modell von MuJoCo; der Roboter der Sitzung ist eine URDF seiner Körper und Gelenke.</translation>
    </message>
    <message>
        <source>The driver answered %1, which %2; the experiment stops.</source>
        <translation>Der Treiber hat %1 geantwortet, was %2; der Versuch hält an.</translation>
    </message>
    <message>
        <source>has in "%1" something else than numbers from %2 to %3</source>
        <translation>in "%1" etwas anderes hat als Zahlen von %2 bis %3</translation>
    </message>
    <message>
        <source>has in "%1" something else than a list of numbers</source>
        <translation>in "%1" etwas anderes hat als eine Liste von Zahlen</translation>
    </message>
    <message>
        <source>has %1 numbers in "%2", expected %3</source>
        <translation>%1 Zahlen in "%2" hat; erwartet werden %3</translation>
    </message>
    <message>
        <source>has no text in "%1"</source>
        <translation>keinen Text in "%1" hat</translation>
    </message>
    <message>
        <source>has no list in "%1"</source>
        <translation>keine Liste in "%1" hat</translation>
    </message>
    <message>
        <source>has in "%1" something else than texts</source>
        <translation>in "%1" etwas anderes hat als Texte</translation>
    </message>
    <message>
        <source>has in "points" no list of at most %1 points</source>
        <translation>in "points" keine Liste von höchstens %1 Punkten hat</translation>
    </message>
    <message>
        <source>has marker %1, expected ascending numbers from 0 to %2</source>
        <translation>Marker %1 hat; erwartet werden steigende Nummern von 0 bis %2</translation>
    </message>
    <message>
        <source>names an image of %1, expected files of the cameras %2</source>
        <translation>ein Bild von %1 nennt; erwartet werden Dateien der Kameras %2</translation>
    </message>
    <message>
        <source>is no JSON</source>
        <translation>kein JSON ist</translation>
    </message>
    <message>
        <source>is no JSON object</source>
        <translation>kein JSON-Objekt ist</translation>
    </message>
    <message>
        <source>says in "ok" neither true nor false</source>
        <translation>in "ok" weder true noch false sagt</translation>
    </message>
    <message>
        <source>has a target_pose without "xyz"</source>
        <translation>eine target_pose ohne "xyz" hat</translation>
    </message>
    <message>
        <source>has a quaternion whose length is not 1</source>
        <translation>ein Quaternion hat, dessen Länge nicht 1 ist</translation>
    </message>
    <message>
        <source>has a target_pose without "quaternion" (x y z w) or "rpy"</source>
        <translation>eine target_pose ohne "quaternion" (x y z w) oder "rpy" hat</translation>
    </message>
    <message>
        <source>has "markers", which only the cameras of a session see</source>
        <translation>"markers" hat, die nur die Kameras einer Sitzung sehen</translation>
    </message>
    <message>
        <source>has a marker without "index"</source>
        <translation>einen Marker ohne "index" hat</translation>
    </message>
    <message>
        <source>has "images", which the session has no cameras for</source>
        <translation>"images" hat, für die die Sitzung keine Kameras hat</translation>
    </message>
    <message>
        <source>repeats no "id"</source>
        <translation>keine "id" wiederholt</translation>
    </message>
    <message>
        <source>does not say in "position" where the robot stands</source>
        <translation>nicht in "position" sagt, wo der Roboter steht</translation>
    </message>
    <message>
        <source>has none of "images", "points", "target_pose" and "markers"</source>
        <translation>weder "images" noch "points", "target_pose" oder "markers" hat</translation>
    </message>
    <message>
        <source>has no points in "path"</source>
        <translation>keine Punkte in "path" hat</translation>
    </message>
    <message>
        <source>The driver cannot be begun: %1</source>
        <translation>Der Treiber lässt sich nicht starten: %1</translation>
    </message>
    <message>
        <source>was ended by signal %1</source>
        <translation>wurde durch das Signal %1 beendet</translation>
    </message>
    <message>
        <source>ended with exit code %1%2</source>
        <translation>endete mit dem Rückgabewert %1%2</translation>
    </message>
    <message>
        <source> (is its command there?)</source>
        <translation> (gibt es seinen Befehl?)</translation>
    </message>
    <message>
        <source>The driver has not answered "%1" for %2 s, which is the limit; it was told to stop and the experiment ends.</source>
        <translation>Der Treiber hat auf "%1" seit %2 s nicht geantwortet, was die Grenze ist; ihm wurde Halt gesagt, und der Versuch endet.</translation>
    </message>
    <message>
        <source>The driver's answer to "%1" is longer than 16 MiB without an end of line.</source>
        <translation>Die Antwort des Treibers auf "%1" ist länger als 16 MiB ohne Zeilenende.</translation>
    </message>
    <message>
        <source>The driver %1 while it was asked to "%2"; the experiment stops.</source>
        <translation>Der Treiber %1, während ihm "%2" gesagt war; der Versuch hält an.</translation>
    </message>
    <message>
        <source>closed its output</source>
        <translation>hat seine Ausgabe geschlossen</translation>
    </message>
    <message>
        <source>The driver answered message %1 where %2 ("%3") was asked: what it says belongs to something else, and the experiment stops.</source>
        <translation>Der Treiber hat auf Nachricht %1 geantwortet, wo %2 ("%3") gefragt war: was er sagt, gehört zu etwas anderem, und der Versuch hält an.</translation>
    </message>
    <message>
        <source>The experiment was interrupted; the driver was told to stop.</source>
        <translation>Der Versuch wurde unterbrochen; dem Treiber wurde Halt gesagt.</translation>
    </message>
    <message>
        <source>The driver is lost already: nothing more is asked of it.</source>
        <translation>Der Treiber ist schon verloren: er wird nichts mehr gefragt.</translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation>%1 gibt es nicht</translation>
    </message>
    <message>
        <source>A mesh is left out of the robot's shapes: %1</source>
        <translation>Ein Netz bleibt aus den Formen des Roboters weg: %1</translation>
    </message>
    <message>
        <source>%1: %2 pairs of links are not watched, as it says.</source>
        <translation>%1: auf %2 Paare von Gliedern wird nicht geachtet, wie sie es sagt.</translation>
    </message>
    <message>
        <source>box %1 of the cell</source>
        <translation>Quader %1 der Zelle</translation>
    </message>
    <message>
        <source>plane %1 of the cell</source>
        <translation>Ebene %1 der Zelle</translation>
    </message>
    <message>
        <source>%1 touch by their shapes where the robot has been: they are not watched.</source>
        <translation>%1 berühren sich nach ihren Formen, wo der Roboter schon war: auf sie wird nicht geachtet.</translation>
    </message>
    <message>
        <source>%1 beyond its limit</source>
        <translation>%1 jenseits seiner Grenze</translation>
    </message>
    <message>
        <source>This program was built without FCL and OMPL, with which it finds paths without collisions: install libfcl-dev and libompl-dev, configure the build again and build it.</source>
        <translation>Dieses Programm wurde ohne FCL und OMPL gebaut, mit denen es Wege ohne Zusammenstöße findet: libfcl-dev und libompl-dev installieren, neu konfigurieren und bauen.</translation>
    </message>
    <message>
        <source>has in size a length that is not above 0 m.</source>
        <translation>hat in size eine Länge, die nicht über 0 m ist.</translation>
    </message>
    <message>
        <source>has a normal of zeros, expected the direction that leads out of what is solid.</source>
        <translation>hat eine Normale aus Nullen; erwartet wird die Richtung, die aus dem Festen hinausführt.</translation>
    </message>
    <message>
        <source>is not known, expected &lt;box&gt; or &lt;plane&gt;: what stands about the robot must not be overlooked.</source>
        <translation>ist nicht bekannt; erwartet wird &lt;box&gt; oder &lt;plane&gt;: was um den Roboter steht, darf nicht übersehen werden.</translation>
    </message>
    <message>
        <source>The driver %1 does not say that it can "%2", which an experiment needs.</source>
        <translation>Der Treiber %1 sagt nicht, dass er "%2" kann, was ein Versuch braucht.</translation>
    </message>
    <message>
        <source>The %1 poses that were given have been taken.</source>
        <translation>Die %1 vorgegebenen Posen sind aufgenommen.</translation>
    </message>
    <message>
        <source>The %1 observations that were asked for are made.</source>
        <translation>Die %1 verlangten Beobachtungen sind gemacht.</translation>
    </message>
    <message>
        <source>The time that was asked for is over (%1 s).</source>
        <translation>Die verlangte Zeit ist um (%1 s).</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>verworfen: %1</translation>
    </message>
    <message>
        <source>The driver has refused or shown nothing in %1 moves in a row, the last time because: %2.</source>
        <translation>Der Treiber hat bei %1 Bewegungen nacheinander abgelehnt oder nichts gezeigt, zuletzt weil: %2.</translation>
    </message>
    <message>
        <source>nothing was seen: %1</source>
        <translation>nichts gesehen: %1</translation>
    </message>
    <message>
        <source>Of %1 moves in a row none brought an observation that could be used, the last time because: %2.</source>
        <translation>Von %1 Bewegungen nacheinander brachte keine eine brauchbare Beobachtung, zuletzt weil: %2.</translation>
    </message>
    <message>
        <source>The driver does not say where the robot stands: it is taken to stand where the session's last observation was.</source>
        <translation>Der Treiber sagt nicht, wo der Roboter steht: er gilt als dort, wo die letzte Beobachtung der Sitzung war.</translation>
    </message>
    <message>
        <source>An experiment moves joints, and of this session's robot only the flange's poses are known.</source>
        <translation>Ein Versuch bewegt Gelenke, und vom Roboter dieser Sitzung sind nur die Posen des Flansches bekannt.</translation>
    </message>
    <message>
        <source>no way leads there from where the robot stands now</source>
        <translation>von dort, wo der Roboter jetzt steht, führt kein Weg dahin</translation>
    </message>
    <message>
        <source>The driver moves %1 joints, not those of the session: expected %2, in any order.</source>
        <translation>Der Treiber bewegt %1 Gelenke, nicht die der Sitzung: erwartet werden %2, in beliebiger Reihenfolge.</translation>
    </message>
    <message>
        <source>The driver says that %1 stands %2 %3 from where it was sent; more than %4 stops an experiment, and it was told to stop.</source>
        <translation>Der Treiber sagt, dass %1 um %2 %3 von dort steht, wohin es geschickt wurde; mehr als %4 hält einen Versuch an, und ihm wurde Halt gesagt.</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10 mm</translation>
    </message>
    <message>
        <source>1 degree</source>
        <translation>1 Grad</translation>
    </message>
    <message>
        <source>The driver names %1 as what camera %2 saw, and there is no such file.</source>
        <translation>Der Treiber nennt %1 als das, was Kamera %2 sah, und diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 is there already and is no image of this experiment; move it away.</source>
        <translation>%1 ist schon da und ist kein Bild dieses Versuchs; es wegräumen.</translation>
    </message>
    <message>
        <source>The driver's look is not what &lt;%1&gt; of the session sees: expected %2.</source>
        <translation>Was der Treiber gesehen hat, ist nicht, was &lt;%1&gt; der Sitzung sieht: erwartet wird %2.</translation>
    </message>
    <message>
        <source>"images" or "markers"</source>
        <translation>"images" oder "markers"</translation>
    </message>
    <message>
        <source>One more hour (about %1 poses at %2 s each) would bring the body's place on the hand from +-%3 mm to +-%4 mm, as the model has it.</source>
        <translation>Eine Stunde mehr (etwa %1 Posen zu je %2 s) brächte den Ort des Körpers auf der Hand nach dem Modell von +-%3 mm auf +-%4 mm.</translation>
    </message>
    <message>
        <source>--until %1: expected hand=0.3mm, odds=20, count=60 or time=30min (um, mm, cm, m; s, min, h), several with | between.</source>
        <translation>--until %1: erwartet wird hand=0.3mm, odds=20, count=60 oder time=30min (um, mm, cm, m; s, min, h), mehrere mit | dazwischen.</translation>
    </message>
    <message>
        <source>--fault %1: expected one of %2.</source>
        <translation>--fault %1: erwartet wird eines von %2.</translation>
    </message>
    <message>
        <source>--fault %1: expected the number of a move after the @, from 1 on.</source>
        <translation>--fault %1: erwartet wird nach dem @ die Nummer einer Bewegung, von 1 an.</translation>
    </message>
    <message>
        <source>%1 cannot go to %2: its limits are %3 and %4</source>
        <translation>%1 kann nicht nach %2: seine Grenzen sind %3 und %4</translation>
    </message>
    <message>
        <source>&lt;joints&gt; names %1, %2, expected joints of the robot that move by themselves.</source>
        <translation>&lt;joints&gt; nennt %1, %2; erwartet werden Gelenke des Roboters, die sich von selbst bewegen.</translation>
    </message>
    <message>
        <source>%1: there is no such file or folder, expected a session's folder or its session.xml.</source>
        <translation>%1: eine solche Datei gibt es nicht; erwartet wird der Ordner einer Sitzung oder ihre session.xml.</translation>
    </message>
    <message>
        <source>%1: the folder holds a collection of several sessions, expected one session's folder; open one of them here, or give the collection to handsight-cli fit or improve.</source>
        <translation>%1: der Ordner enthält eine Sammlung mehrerer Sitzungen; erwartet wird der Ordner einer einzelnen Sitzung. Öffnen Sie hier eine davon, oder geben Sie die Sammlung handsight-cli fit oder improve.</translation>
    </message>
    <message>
        <source>%1: the folder holds no session.xml, expected a session's folder.</source>
        <translation>%1: der Ordner enthält keine session.xml; erwartet wird der Ordner einer Sitzung.</translation>
    </message>
    <message>
        <source>&lt;robot&gt; has file=%1, which leads out of the session's folder, expected a URDF file inside it, in a folder "robots" beside or above it, or in one that the environment variable %2 names.</source>
        <translation>&lt;robot&gt; hat file=%1, was aus dem Ordner der Sitzung hinausführt; erwartet wird eine URDF-Datei in ihm, in einem Ordner "robots" daneben oder darüber oder in einem, den die Umgebungsvariable %2 nennt.</translation>
    </message>
    <message>
        <source>&lt;robot&gt; has file=%1, which is not there, expected a URDF file, its path relative to the session's folder.</source>
        <translation>&lt;robot&gt; hat file=%1, was es nicht gibt; erwartet wird eine URDF-Datei, ihr Pfad vom Ordner der Sitzung aus.</translation>
    </message>
    <message>
        <source>the image %1 of observation %2 leads out of the session's folder, expected images inside it.</source>
        <translation>das Bild %1 von Beobachtung %2 führt aus dem Ordner der Sitzung hinaus; erwartet werden Bilder in ihm.</translation>
    </message>
    <message>
        <source>%1: belongs to the session and is not written over; name another file.</source>
        <translation>%1: gehört zur Sitzung und wird nicht überschrieben; nenne eine andere Datei.</translation>
    </message>
    <message>
        <source>session "%1"</source>
        <translation>Sitzung "%1"</translation>
    </message>
    <message>
        <source>%1: nothing tells the noise of its sensor, by which it counts beside the others; declare it (sigma of &lt;%2&gt;).</source>
        <translation>%1: nichts sagt das Rauschen ihres Sensors, nach dem sie neben den anderen zählt; es angeben (sigma von &lt;%2&gt;).</translation>
    </message>
    <message>
        <source>%1: rig="%2" is that of session "%3", but the fixture %4 is of another kind; give it a name of its own.</source>
        <translation>%1: rig="%2" ist das von Sitzung "%3", aber die Vorrichtung %4 ist von anderer Art; ihm einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>%1: gravity is %2 there and %3 in %4; one robot stands in one gravity.</source>
        <translation>%1: die Schwerkraft ist dort %2 und %3 in %4; ein Roboter steht in einer Schwerkraft.</translation>
    </message>
    <message>
        <source>%1: together the sessions have more than %2 cameras; give sessions that share cameras the same rig="".</source>
        <translation>%1: zusammen haben die Sitzungen mehr als %2 Kameras; Sitzungen, die sich Kameras teilen, dasselbe rig="" geben.</translation>
    </message>
    <message>
        <source>%1: rig="%2" is that of session "%3", but it %4; give it a name of its own.</source>
        <translation>%1: rig="%2" ist das der Sitzung "%3", aber hier %4; gib ihm einen eigenen Namen.</translation>
    </message>
    <message>
        <source>%1: body="%2" is that of session "%3", but it has %4; give it a name of its own.</source>
        <translation>%1: body="%2" ist das der Sitzung "%3", aber hier ist %4; gib ihm einen eigenen Namen.</translation>
    </message>
    <message>
        <source>another TCP</source>
        <translation>einen anderen TCP</translation>
    </message>
    <message>
        <source>another number of markers</source>
        <translation>eine andere Zahl von Markern</translation>
    </message>
    <message>
        <source>--session %1: this calibration is of one session alone; leave the option out.</source>
        <translation>--session %1: diese Kalibrierung ist von einer einzelnen Sitzung; die Option weglassen.</translation>
    </message>
    <message>
        <source>--session %1: the calibration has no such session; it has %2.</source>
        <translation>--session %1: eine solche Sitzung hat die Kalibrierung nicht; sie hat %2.</translation>
    </message>
    <message>
        <source>the scatter of the hand</source>
        <translation>die Streuung der Hand</translation>
    </message>
    <message>
        <source>the covariance of the hand</source>
        <translation>die Kovarianz der Hand</translation>
    </message>
    <message>
        <source>what the choice of the effects leaves open</source>
        <translation>was die Wahl der Effekte offenlässt</translation>
    </message>
    <message>
        <source>a marker</source>
        <translation>ein Marker</translation>
    </message>
    <message>
        <source>an error of the fit</source>
        <translation>ein Fehler der Schätzung</translation>
    </message>
    <message>
        <source>joint %1 has %2 %3 in one and %4 in the other</source>
        <translation>Gelenk %1 hat %2 %3 in der einen und %4 in der anderen</translation>
    </message>
    <message>
        <source>the one has a joint %1 where the other has %2</source>
        <translation>die eine hat ein Gelenk %1, wo die andere %2 hat</translation>
    </message>
    <message>
        <source>joint %1 is of another kind or between other links</source>
        <translation>Gelenk %1 ist von anderer Art oder zwischen anderen Gliedern</translation>
    </message>
    <message>
        <source>%1 links and %2 joints in one, %3 and %4 in the other</source>
        <translation>%1 Glieder und %2 Gelenke in der einen, %3 und %4 in der anderen</translation>
    </message>
    <message>
        <source>the one has a link %1 where the other has %2</source>
        <translation>die eine hat ein Glied %1, wo die andere %2 hat</translation>
    </message>
    <message>
        <source>link %1 has a mass of %2 kg in one and %3 kg in the other</source>
        <translation>Glied %1 hat in der einen eine Masse von %2 kg und in der anderen %3 kg</translation>
    </message>
    <message>
        <source>link %1 has its centre of mass at %2 in one and %3 in the other</source>
        <translation>Glied %1 hat seinen Schwerpunkt in der einen bei %2 und in der anderen bei %3</translation>
    </message>
    <message>
        <source>its place at</source>
        <translation>seinen Platz bei</translation>
    </message>
    <message>
        <source>its link at</source>
        <translation>sein Glied bei</translation>
    </message>
    <message>
        <source>its axis along</source>
        <translation>seine Achse entlang</translation>
    </message>
    <message>
        <source>a stiffness of</source>
        <translation>eine Steifigkeit von</translation>
    </message>
    <message>
        <source>has folder="%1", expected a session's folder inside the collection's folder or beside it, its path relative to the collection.</source>
        <translation>hat folder="%1"; erwartet wird der Ordner einer Sitzung in dem der Sammlung oder daneben, sein Pfad von der Sammlung aus.</translation>
    </message>
    <message>
        <source>is a second session called "%1", expected another title="" for one of them.</source>
        <translation>ist eine zweite Sitzung namens "%1"; erwartet wird für eine von ihnen ein anderer title="".</translation>
    </message>
    <message>
        <source>%1: lies neither inside the folder of %2 nor beside it; write the collection into the folder that holds the sessions.</source>
        <translation>%1: liegt weder im Ordner von %2 noch daneben; schreibe die Sammlung in den Ordner, der die Sitzungen enthält.</translation>
    </message>
    <message>
        <source>has no &lt;session&gt;, expected one at least.</source>
        <translation>hat keine &lt;session&gt;; erwartet wird mindestens eine.</translation>
    </message>
    <message>
        <source>has %1=%2, expected a path relative to the session's folder and inside it.</source>
        <translation>hat %1=%2; erwartet wird ein Pfad vom Ordner der Sitzung aus und in ihm.</translation>
    </message>
    <message>
        <source>"su sv suv": two standard deviations of 1e-9 to 1e4 px, and a covariance in px^2 that is smaller than their product</source>
        <translation>"su sv suv": zwei Standardabweichungen von 1e-9 bis 1e4 px und eine Kovarianz in px^2, die kleiner ist als ihr Produkt</translation>
    </message>
    <message>
        <source>none, as that camera did not see the marker</source>
        <translation>keines, denn diese Kamera sah den Marker nicht</translation>
    </message>
    <message>
        <source>has no %1</source>
        <translation>hat kein %1</translation>
    </message>
    <message>
        <source>has neither %1</source>
        <translation>hat weder %1</translation>
    </message>
    <message>
        <source> nor </source>
        <translation> noch </translation>
    </message>
    <message>
        <source>%1%2 marker that is not seen has no element.</source>
        <translation>%1%2 Marker, der nicht gesehen wird, hat kein Element.</translation>
    </message>
    <message>
        <source>, expected at least one; a</source>
        <translation>; erwartet wird mindestens eines; ein</translation>
    </message>
    <message>
        <source>one for each of &lt;joints&gt;</source>
        <translation>eine für jedes von &lt;joints&gt;</translation>
    </message>
    <message>
        <source>has %1=%2, expected a letter and then letters, digits and _, 64 at most.</source>
        <translation>hat %1=%2; erwartet wird ein Buchstabe und dann Buchstaben, Ziffern und _, höchstens 64.</translation>
    </message>
    <message>
        <source>holds %1 characters, expected %2 at most.</source>
        <translation>enthält %1 Zeichen; erwartet werden höchstens %2.</translation>
    </message>
    <message>
        <source>is a second parameter %1, expected each name once.</source>
        <translation>ist ein zweiter Parameter %1; erwartet wird jeder Name einmal.</translation>
    </message>
    <message>
        <source>%1 has %2 &lt;parameter&gt;, expected 1 to %3.</source>
        <translation>%1 hat %2 &lt;parameter&gt;; erwartet werden 1 bis %3.</translation>
    </message>
    <message>
        <source>%1 has %2 &lt;moves&gt;, expected 1 to %3: the sites that it moves, and by how much.</source>
        <translation>%1 hat %2 &lt;moves&gt;; erwartet werden 1 bis %3: die Stellen, die er bewegt, und um wie viel.</translation>
    </message>
    <message>
        <source>has id=%1 a second time, expected each effect once.</source>
        <translation>hat id=%1 ein zweites Mal; erwartet wird jeder Effekt einmal.</translation>
    </message>
    <message>
        <source>%1, line %2: the effect "%3" is defined in %4 already; that one counts.</source>
        <translation>%1, Zeile %2: der Effekt "%3" ist schon in %4 erklärt; jener zählt.</translation>
    </message>
    <message>
        <source>The size of the images is not known; the %1calibration does not name it.</source>
        <translation>Die Größe der Bilder ist nicht bekannt; die %1Kalibrierung nennt sie nicht.</translation>
    </message>
    <message>
        <source>stereo </source>
        <translation>Stereo-</translation>
    </message>
    <message>
        <source>There is no link %1: a robot of poses has "base" and "flange".</source>
        <translation>Ein Glied %1 gibt es nicht: ein Roboter aus Posen hat "base" und "flange".</translation>
    </message>
    <message>
        <source>%1: has no link %2.</source>
        <translation>%1: hat kein Glied %2.</translation>
    </message>
    <message>
        <source>%1 has no partner and is left out; observation %2 has no images.</source>
        <translation>%1 hat keinen Partner und bleibt weg; Beobachtung %2 hat keine Bilder.</translation>
    </message>
    <message>
        <source>images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>%1: %2 and %3 have the same number; one image an instant and side is wanted.</source>
        <translation>%1: %2 und %3 haben dieselbe Nummer; gebraucht wird ein Bild je Zeitpunkt und Seite.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be read (%2).</source>
        <translation>%1: der Ordner lässt sich nicht lesen (%2).</translation>
    </message>
    <message>
        <source>%1: has no %2images with a number in their names (PNG, JPEG, PGM, BMP or TIFF).</source>
        <translation>%1: enthält keine %2Bilder mit einer Nummer im Namen (PNG, JPEG, PGM, BMP oder TIFF).</translation>
    </message>
    <message>
        <source>has %1="0 0 0", expected a direction.</source>
        <translation>hat %1="0 0 0"; erwartet wird eine Richtung.</translation>
    </message>
    <message>
        <source>has id="%1" a second time, expected each fixture once.</source>
        <translation>hat id="%1" ein zweites Mal; erwartet wird jede Vorrichtung einmal.</translation>
    </message>
    <message>
        <source>has %1="%2", expected one of the fixtures: %3.</source>
        <translation>hat %1="%2"; erwartet wird eine der Vorrichtungen: %3.</translation>
    </message>
    <message>
        <source>does not say where it is, expected its place; only %1 with estimate="yes" are found without.</source>
        <translation>sagt nicht, wo sie ist; erwartet wird ihr Ort; nur %1 mit estimate="yes" werden ohne ihn gefunden.</translation>
    </message>
    <message>
        <source>is from a fixture to itself, expected two of them.</source>
        <translation>ist von einer Vorrichtung zu sich selbst; erwartet werden zwei.</translation>
    </message>
    <message>
        <source>holds no fixture, expected a %1.</source>
        <translation>enthält keine Vorrichtung; erwartet wird %1.</translation>
    </message>
    <message>
        <source>is a second touch in one observation, expected one: the robot stands once.</source>
        <translation>ist eine zweite Berührung in einer Beobachtung; erwartet wird eine: der Roboter steht einmal.</translation>
    </message>
    <message>
        <source>has no value, expected the length that was read there.</source>
        <translation>hat keinen value; erwartet wird die Länge, die dort abgelesen wurde.</translation>
    </message>
    <message>
        <source>is a second camera with name="%1", expected one left and one right.</source>
        <translation>ist eine zweite Kamera mit name="%1"; erwartet wird eine linke und eine rechte.</translation>
    </message>
    <message>
        <source>has no &lt;camera name="%1"&gt;, expected one left and one right.</source>
        <translation>hat keine &lt;camera name="%1"&gt;; erwartet wird eine linke und eine rechte.</translation>
    </message>
    <message>
        <source>has name=%1, expected at most 40 letters, digits and _.</source>
        <translation>hat name=%1; erwartet werden höchstens 40 Buchstaben, Ziffern und _.</translation>
    </message>
    <message>
        <source>has name="%1", which markers have as an attribute already, expected another name.</source>
        <translation>hat name="%1", was Marker schon als Attribut haben; erwartet wird ein anderer Name.</translation>
    </message>
    <message>
        <source>has name="%1" beside the camera "%2", expected names that differ, and none that is another's with _sigma behind it.</source>
        <translation>hat name="%1" neben der Kamera "%2"; erwartet werden verschiedene Namen, und keiner, der ein anderer mit _sigma dahinter ist.</translation>
    </message>
    <message>
        <source>is one too many, expected at most %1.</source>
        <translation>ist eine zu viel; erwartet werden höchstens %1.</translation>
    </message>
    <message>
        <source>stands beside the &lt;%1&gt; of line %2, expected one of the two.</source>
        <translation>steht neben dem &lt;%1&gt; von Zeile %2; erwartet wird eines von beiden.</translation>
    </message>
    <message>
        <source>%1, line %2: sigma_pixel has no meaning in a tracker session and is ignored.</source>
        <translation>%1, Zeile %2: sigma_pixel bedeutet in einer Tracker-Sitzung nichts und wird übergangen.</translation>
    </message>
    <message>
        <source>has %1 points, expected at most %2: a fit with more takes minutes and is no surer; use a board with fewer squares or tags.</source>
        <translation>hat %1 Punkte; erwartet werden höchstens %2: eine Schätzung mit mehr dauert Minuten und ist nicht sicherer; ein Brett mit weniger Feldern oder Tags nehmen.</translation>
    </message>
    <message>
        <source>%1, line %2: this chessboard looks the same after half a turn; the robot's motion tells how it lies from one observation to the next, but not which end is the first. One of an even and an odd number of corners cannot be mistaken.</source>
        <translation>%1, Zeile %2: dieses Schachbrett sieht nach einer halben Drehung gleich aus; die Bewegung des Roboters sagt, wie es von einer Beobachtung zur nächsten liegt, aber nicht, welches Ende das erste ist. Eines mit einer geraden und einer ungeraden Zahl von Ecken ist nicht zu verwechseln.</translation>
    </message>
    <message>
        <source>stands beside the &lt;markers&gt; of line %1, expected one of the two.</source>
        <translation>steht neben dem &lt;markers&gt; von Zeile %1; erwartet wird eines von beiden.</translation>
    </message>
    <message>
        <source>%1: markers lie outside their camera's image (%2 positions).</source>
        <translation>%1: Marker liegen außerhalb des Bilds ihrer Kamera (%2 Stellen).</translation>
    </message>
    <message>
        <source>has model="fisheye" with one of p1, p2, k5, k6, expected k1 k2 k3 k4: those of Brown's model mean something else.</source>
        <translation>hat model="fisheye" mit einem von p1, p2, k5, k6; erwartet wird k1 k2 k3 k4: die von Browns Modell bedeuten etwas anderes.</translation>
    </message>
    <message>
        <source>stands in the first camera, expected none there: the first is the reference.</source>
        <translation>steht in der ersten Kamera; erwartet wird dort keines: die erste ist der Bezug.</translation>
    </message>
    <message>
        <source>has no &lt;from_first&gt;, expected where it is: X of this camera = R X of the first + t.</source>
        <translation>hat kein &lt;from_first&gt;; erwartet wird, wo sie ist: X dieser Kamera = R X der ersten + t.</translation>
    </message>
    <message>
        <source>holds no &lt;camera&gt;, expected one to eight.</source>
        <translation>enthält keine &lt;camera&gt;; erwartet werden eine bis acht.</translation>
    </message>
    <message>
        <source>has kind="pose", which needs a &lt;pose_sensor&gt; in place of cameras or a tracker.</source>
        <translation>hat kind="pose", was einen &lt;pose_sensor&gt; anstelle von Kameras oder Tracker braucht.</translation>
    </message>
    <message>
        <source>is found in images, and this session has a &lt;tracker&gt;; expected &lt;cameras&gt;, or &lt;markers count=""/&gt;.</source>
        <translation>wird in Bildern gefunden, und diese Sitzung hat einen &lt;tracker&gt;; erwartet wird &lt;cameras&gt; oder &lt;markers count=""/&gt;.</translation>
    </message>
    <message>
        <source>has order=%1, expected order="%2".</source>
        <translation>hat order=%1; erwartet wird order="%2".</translation>
    </message>
    <message>
        <source>has %1="%2", expected at least 0.</source>
        <translation>hat %1="%2"; erwartet wird mindestens 0.</translation>
    </message>
    <message>
        <source>has index="%1" a second time, expected each marker once.</source>
        <translation>hat index="%1" ein zweites Mal; erwartet wird jeder Marker einmal.</translation>
    </message>
    <message>
        <source>is a second %1 of %2, expected each parameter once.</source>
        <translation>ist ein zweites %1 von %2; erwartet wird jeder Parameter einmal.</translation>
    </message>
    <message>
        <source>has id=%1 a second time, expected each effect once, or with another number.</source>
        <translation>hat id=%1 ein zweites Mal; erwartet wird jeder Effekt einmal, oder mit einer anderen Nummer.</translation>
    </message>
    <message>
        <source>row by row</source>
        <translation>Zeile für Zeile</translation>
    </message>
    <message>
        <source>is no rigid motion, expected a rotation, a translation and the last row 0 0 0 1.</source>
        <translation>ist keine starre Bewegung; erwartet werden eine Drehung, eine Verschiebung und die letzte Zeile 0 0 0 1.</translation>
    </message>
    <message>
        <source>has a negative variance on its diagonal, expected a covariance.</source>
        <translation>hat eine negative Varianz auf der Diagonale; erwartet wird eine Kovarianz.</translation>
    </message>
    <message>
        <source>is not symmetric or has correlations beyond 1, expected a covariance.</source>
        <translation>ist nicht symmetrisch oder hat Korrelationen über 1; erwartet wird eine Kovarianz.</translation>
    </message>
    <message>
        <source>has a negative variance in some direction, expected a covariance.</source>
        <translation>hat in einer Richtung eine negative Varianz; erwartet wird eine Kovarianz.</translation>
    </message>
    <message>
        <source>has neither &lt;matrix&gt; nor xyz and rpy, expected one of them.</source>
        <translation>hat weder &lt;matrix&gt; noch xyz und rpy; erwartet wird eines davon.</translation>
    </message>
    <message>
        <source>has an xyz and rpy that are another motion than its &lt;matrix&gt;, expected them to agree to 1e-6.</source>
        <translation>hat ein xyz und rpy, die eine andere Bewegung sind als seine &lt;matrix&gt;; erwartet wird Übereinstimmung auf 1e-6.</translation>
    </message>
    <message>
        <source>holds no marker, expected at least one.</source>
        <translation>enthält keinen Marker; erwartet wird mindestens einer.</translation>
    </message>
    <message>
        <source>times in s</source>
        <translation>Zeiten in s</translation>
    </message>
    <message>
        <source>has times that go back, expected them in order.</source>
        <translation>hat Zeiten, die zurückgehen; erwartet werden sie der Reihe nach.</translation>
    </message>
    <message>
        <source>a pose a line</source>
        <translation>eine Pose je Zeile</translation>
    </message>
    <message>
        <source>The calibrations are of other links or joints; name two of one robot.</source>
        <translation>Die Kalibrierungen sind von anderen Gliedern oder Gelenken; zwei von einem Roboter nennen.</translation>
    </message>
    <message>
        <source>The comparison was stopped.</source>
        <translation>Der Vergleich wurde angehalten.</translation>
    </message>
    <message>
        <source>%1: is a device or a pipe and is not written over; name a file, or - for standard output where an option takes it.</source>
        <translation>%1: ist ein Gerät oder eine Pipe und wird nicht überschrieben; nenne eine Datei.</translation>
    </message>
    <message>
        <source>%1: is write protected and is as it was; name another file.</source>
        <translation>%1: ist schreibgeschützt und ist, wie sie war; nenne eine andere Datei.</translation>
    </message>
    <message>
        <source>%1: is a device or a pipe and is not read; expected a regular file.</source>
        <translation>%1: ist ein Gerät oder eine Pipe und wird nicht gelesen; erwartet wird eine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>%1: another program has changed the file since it was read; it is as that program left it. Run the command again on what it holds now.</source>
        <translation>%1: ein anderes Programm hat die Datei geändert, seit sie gelesen wurde; sie ist, wie jenes sie hinterließ. Versuche es noch einmal mit dem, was jetzt darin steht.</translation>
    </message>
    <message>
        <source>%1: no folder can be made in it: %2.</source>
        <translation>%1: darin lässt sich kein Ordner anlegen: %2.</translation>
    </message>
    <message>
        <source>attribute %1 of &lt;%2&gt;</source>
        <translation>das Attribut %1 von &lt;%2&gt;</translation>
    </message>
    <message>
        <source>element &lt;%1&gt; in &lt;%2&gt;</source>
        <translation>das Element &lt;%1&gt; in &lt;%2&gt;</translation>
    </message>
    <message>
        <source>text in &lt;%1&gt;</source>
        <translation>Text in &lt;%1&gt;</translation>
    </message>
    <message>
        <source>%1: %2 is not known and is ignored (line %3).</source>
        <translation>%1: %2 ist nicht bekannt und wird übergangen (Zeile %3).</translation>
    </message>
    <message>
        <source>%1: %2 is not known and is ignored (%3 times, first at line %4).</source>
        <translation>%1: %2 ist nicht bekannt und wird übergangen (%3 Mal, zuerst in Zeile %4).</translation>
    </message>
    <message>
        <source>has %1=%2</source>
        <translation>hat %1=%2</translation>
    </message>
    <message>
        <source>%1, expected %2%3.</source>
        <translation>%1; erwartet wird %2%3.</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>the file holds more than %1 elements and attributes, expected at most %2 and one for each %3 bytes.</source>
        <translation>die Datei enthält mehr als %1 Elemente und Attribute; erwartet werden höchstens %2 und eines auf je %3 Bytes.</translation>
    </message>
    <message>
        <source>the reference &amp;%1; stands for no character, expected text.</source>
        <translation>der Verweis &amp;%1; steht für kein Zeichen; erwartet wird Text.</translation>
    </message>
    <message>
        <source>an element has more than %1 attributes, expected far fewer.</source>
        <translation>ein Element hat mehr als %1 Attribute; erwartet werden weit weniger.</translation>
    </message>
    <message>
        <source>the file has %1 MB, expected at most %2.</source>
        <translation>die Datei hat %1 MB; erwartet werden höchstens %2.</translation>
    </message>
    <message>
        <source>the reference &amp;#0; stands for a zero byte, expected text.</source>
        <translation>der Verweis &amp;#0; steht für ein Nullbyte; erwartet wird Text.</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>its least squares do not come to an end from the starts that were tried</source>
        <translation>ihre kleinsten Quadrate kommen von den versuchten Startwerten aus zu keinem Ende</translation>
    </message>
    <message>
        <source>Curve "%1": write JOINT: SIZE*sin(ORDERq), with sin or cos, for example "arm_3: 0.0015*sin(3q)".</source>
        <translation>Kurve "%1": GELENK: GRÖSSE*sin(ORDNUNGq) schreiben, mit sin oder cos, zum Beispiel "arm_3: 0.0015*sin(3q)".</translation>
    </message>
    <message>
        <source>Curve "%1": the robot has no moving joint "%2"; it has: %3.</source>
        <translation>Kurve "%1": der Roboter hat kein bewegliches Gelenk "%2"; er hat: %3.</translation>
    </message>
    <message>
        <source>%1 is there already and not empty; name a new folder in --out.</source>
        <translation>%1 ist schon da und nicht leer; in --out einen neuen Ordner nennen.</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2.</source>
        <translation>%1 lässt sich nicht anlegen: %2.</translation>
    </message>
    <message>
        <source>A tracker session has no images to render; leave --images out.</source>
        <translation>Eine Tracker-Sitzung hat keine Bilder zu zeichnen; --images weglassen.</translation>
    </message>
    <message>
        <source>No pose in %1 searches shows all %2 markers to %3 between %4 and %5 m; check the mount of the cameras, or widen --joint-range.</source>
        <translation>In %1 Versuchen zeigt keine Pose alle %2 Marker für %3 zwischen %4 und %5 m; den Halter der Kameras prüfen oder --joint-range weiten.</translation>
    </message>
    <message>
        <source>Disturbance of observation %1: the joint "%2" is not named in &lt;joints&gt;.</source>
        <translation>Störung von Beobachtung %1: das Gelenk "%2" wird in &lt;joints&gt; nicht genannt.</translation>
    </message>
    <message>
        <source>Disturbance of observation %1: of touches only joints can be disturbed, in observations 0 to %2.</source>
        <translation>Störung von Beobachtung %1: bei Berührungen lassen sich nur Gelenke stören, in den Beobachtungen 0 bis %2.</translation>
    </message>
    <message>
        <source>Disturbance of observation %1: there are observations 0 to %2 and markers 0 to %3.</source>
        <translation>Störung von Beobachtung %1: es gibt die Beobachtungen 0 bis %2 und die Marker 0 bis %3.</translation>
    </message>
    <message>
        <source>Disturbance of observation %1: right_image needs a second camera.</source>
        <translation>Störung von Beobachtung %1: right_image braucht eine zweite Kamera.</translation>
    </message>
    <message>
        <source>Disturbance "%1": write ID:joint:NAME=RAD, ID:marker:INDEX=METRES or ID:right_image:NAME=RAD.</source>
        <translation>Störung "%1": ID:joint:NAME=RAD, ID:marker:INDEX=METER oder ID:right_image:NAME=RAD schreiben.</translation>
    </message>
    <message>
        <source>Disturbance "%1": the robot has no joint "%2"; it has: %3.</source>
        <translation>Störung "%1": der Roboter hat kein Gelenk "%2"; er hat: %3.</translation>
    </message>
    <message>
        <source>A session of touches has no image points and no sensor; leave --wrong-corners and --shift out.</source>
        <translation>Eine Sitzung von Berührungen hat keine Bildpunkte und keinen Sensor; --wrong-corners und --shift weglassen.</translation>
    </message>
    <message>
        <source>A tracker session has no image points; leave --wrong-corners out.</source>
        <translation>Eine Tracker-Sitzung hat keine Bildpunkte; --wrong-corners weglassen.</translation>
    </message>
    <message>
        <source>%1 is %2; expected a length in m from %3 to %4.</source>
        <translation>%1 ist %2; erwartet wird eine Länge in m von %3 bis %4.</translation>
    </message>
    <message>
        <source>the dictionary "%1" is not known; expected one of OpenCV's, such as DICT_5X5_100 or DICT_APRILTAG_36h11, or AprilTag's tag36h11.</source>
        <translation>das Wörterbuch "%1" ist nicht bekannt; erwartet wird eines von OpenCV wie DICT_5X5_100 oder DICT_APRILTAG_36h11, oder AprilTags tag36h11.</translation>
    </message>
    <message>
        <source>it has %1 columns and %2 rows; expected 1 or more of each, and at most %3 tags.</source>
        <translation>es hat %1 Spalten und %2 Zeilen; erwartet wird je 1 oder mehr, und höchstens %3 Tags.</translation>
    </message>
    <message>
        <source>it has %1 tags and %2 places; expected one place a tag.</source>
        <translation>es hat %1 Tags und %2 Plätze; erwartet wird ein Platz je Tag.</translation>
    </message>
    <message>
        <source>the tags %1 and %2 lie at the same place; every tag has its own xyz or rpy.</source>
        <translation>die Tags %1 und %2 liegen am selben Ort; jedes Tag hat sein eigenes xyz oder rpy.</translation>
    </message>
    <message>
        <source>%1 ... (%2 tags)</source>
        <translation>%1 ... (%2 Tags)</translation>
    </message>
    <message>
        <source>sigma is %1; expected 0 to 1 m, or "free".</source>
        <translation>sigma ist %1; erwartet wird 0 bis 1 m, oder "free".</translation>
    </message>
    <message>
        <source>spacing is %1; expected the gap between two tags over a tag's side, 0.02 to 10.</source>
        <translation>spacing ist %1; erwartet wird die Lücke zwischen zwei Tags durch die Seite eines Tags, 0.02 bis 10.</translation>
    </message>
    <message>
        <source>border is %1; expected 1 to 4 modules.</source>
        <translation>border ist %1; erwartet wird 1 bis 4 Module.</translation>
    </message>
    <message>
        <source>ChArUco board of %1 x %2 squares of %3, tags of %4 from %5%6</source>
        <translation>ChArUco-Brett mit %1 × %2 Feldern von %3, Tags von %4 aus %5%6</translation>
    </message>
    <message>
        <source>, old layout</source>
        <translation>, alte Anordnung</translation>
    </message>
    <message>
        <source>%1: diameter is %2 m; expected more than 0 and less than the %3 m between two circles, so that they do not touch.</source>
        <translation>%1: diameter ist %2 m; erwartet ist mehr als 0 und weniger als die %3 m zwischen zwei Kreisen, damit sie sich nicht berühren.</translation>
    </message>
    <message>
        <source>%1 grid of %2 x %3 circles of %4 mm, %5 %6 mm</source>
        <translation>%1 Gitter von %2 x %3 Kreisen von %4 mm, %5 %6 mm</translation>
    </message>
    <message>
        <source>steps of</source>
        <translation>Schritte von</translation>
    </message>
    <message>
        <source>%1: %2 is %3; expected %4.</source>
        <translation>%1: %2 ist %3; erwartet wird %4.</translation>
    </message>
    <message>
        <source>%1: it has no kind; expected %2.</source>
        <translation>%1: es hat kein kind; erwartet wird %2.</translation>
    </message>
    <message>
        <source>%1: a target of kind %2 needs %3, which is missing; expected %4.</source>
        <translation>%1: ein Ziel der Art %2 braucht %3, das fehlt; erwartet wird %4.</translation>
    </message>
    <message>
        <source>%1: it has ids and &lt;tag&gt; elements; expected one of the two.</source>
        <translation>%1: es hat ids und &lt;tag&gt;-Elemente; erwartet wird eines von beiden.</translation>
    </message>
    <message>
        <source>%1: a target of kind tags needs dictionary, which is missing; expected dictionary and a &lt;tag&gt; element for every tag.</source>
        <translation>%1: ein Ziel der Art tags braucht dictionary, das fehlt; erwartet wird dictionary und ein &lt;tag&gt;-Element für jedes Tag.</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>numbers of tags, for example "3 7 9"</source>
        <translation>Nummern von Tags, zum Beispiel "3 7 9"</translation>
    </message>
    <message>
        <source>a length in m, or "free"</source>
        <translation>eine Länge in m, oder "free"</translation>
    </message>
    <message>
        <source>symmetric or asymmetric, how the rows of circles stand</source>
        <translation>symmetric oder asymmetric, wie die Reihen der Kreise stehen</translation>
    </message>
    <message>
        <source>"old" (OpenCV before 4.6) or "new"</source>
        <translation>"old" (OpenCV vor 4.6) oder "new"</translation>
    </message>
    <message>
        <source>has no size, and neither has the target, expected the side of the black square in m.</source>
        <translation>hat keine size, und das Ziel auch nicht; erwartet wird die Seite des schwarzen Quadrats in m.</translation>
    </message>
    <message>
        <source>points of a tracker</source>
        <translation>Punkte eines Trackers</translation>
    </message>
    <message>
        <source>a file with one pose</source>
        <translation>eine Datei mit einer Pose</translation>
    </message>
    <message>
        <source>a CDATA section is not closed</source>
        <translation>ein CDATA-Abschnitt ist nicht geschlossen</translation>
    </message>
    <message>
        <source> (is this a xacro file? Make a URDF of it first)</source>
        <translation> (ist das eine xacro-Datei? Zuerst eine URDF daraus machen)</translation>
    </message>
    <message>
        <source>one of them is several sessions, which `handsight-cli compare COLLECTION` compares with each other</source>
        <translation>eine davon besteht aus mehreren Sitzungen, die `handsight-cli compare SAMMLUNG` miteinander vergleicht</translation>
    </message>
    <message>
        <source>A recheck drives to poses and looks; a session of touches is rechecked by its own touches.</source>
        <translation>Eine Nachprüfung fährt Posen an und schaut; eine Sitzung aus Berührungen wird durch eigene Berührungen nachgeprüft.</translation>
    </message>
    <message>
        <source>An experiment of touches begins where they can be fitted, and these cannot yet: touch each fixture by hand first, a plane at three places at least (fit says what is lacking).</source>
        <translation>Ein Experiment aus Berührungen beginnt dort, wo sie sich anpassen lassen, und diese lassen sich noch nicht anpassen: berühre zuerst jede Vorrichtung von Hand, eine Ebene an mindestens drei Stellen (fit sagt, was fehlt).</translation>
    </message>
    <message>
        <source>nothing was touched: %1</source>
        <translation>nichts berührt: %1</translation>
    </message>
    <message>
        <source>The driver was to touch the fixture %1 and says that it has touched %2.</source>
        <translation>Der Treiber sollte die Vorrichtung %1 berühren und sagt, er habe %2 berührt.</translation>
    </message>
    <message>
        <source>The driver's touch of %1 has no "value": a length is what it reads there.</source>
        <translation>Der Berührung von %1 durch den Treiber fehlt "value": eine Länge ist, was er dort abliest.</translation>
    </message>
    <message>
        <source>the tip is %1 mm from where the touched fixture must be (limit %2)</source>
        <translation>die Spitze ist %1 mm von dort entfernt, wo die berührte Vorrichtung sein muss (Grenze %2)</translation>
    </message>
    <message>
        <source>does not say in "touched" what</source>
        <translation>sagt in "touched" nicht, was</translation>
    </message>
    <message>
        <source>has a "marker" that is no number of a tip</source>
        <translation>hat einen "marker", der keine Nummer einer Spitze ist</translation>
    </message>
    <message>
        <source>there is no fixture %1</source>
        <translation>es gibt keine Vorrichtung %1</translation>
    </message>
    <message>
        <source>it is not said in which posture</source>
        <translation>es ist nicht gesagt, in welcher Pose</translation>
    </message>
    <message>
        <source>the tip does not come to %1</source>
        <translation>die Spitze kommt nicht zu %1</translation>
    </message>
    <message>
        <source>%1 is a table of joint readings, and %2 is one too; name one of them. (Tables of touches, one for each fixture: say what each is, --fixture "plane %3".)</source>
        <translation>%1 ist eine Tabelle von Gelenkwerten, und %2 ist auch eine; nenne eine davon. (Tabellen von Berührungen, eine je Vorrichtung: sage, was jede ist, --fixture "plane %3".)</translation>
    </message>
    <message>
        <source>%1: %2 is no NAME=VALUE such as sigma=2e-5; a fixture's name is one word ("socket 1" of a table is socket_1 here).</source>
        <translation>%1: %2 ist kein NAME=WERT wie sigma=2e-5; der Name einer Vorrichtung ist ein Wort ("socket 1" einer Tabelle ist hier socket_1).</translation>
    </message>
    <message>
        <source>%1: the fixtures %2 and %3 differ in capitals alone; write it one way.</source>
        <translation>%1: die Vorrichtungen %2 und %3 unterscheiden sich nur durch Großbuchstaben; schreibe sie einheitlich.</translation>
    </message>
    <message>
        <source>--apart %1: distances are in metres; %2 mm is by=%3.</source>
        <translation>--apart %1: Abstände stehen in Metern; %2 mm sind by=%3.</translation>
    </message>
    <message>
        <source>%1: the readings of %2 are deviations, and nothing says from which length; say --fixture "%3 %4 ... value=METRES".</source>
        <translation>%1: die Werte von %2 sind Abweichungen, und nichts sagt, von welcher Länge; sage --fixture "%3 %4 ... value=METER".</translation>
    </message>
    <message>
        <source>%1: its columns (%2) are no places (x y z) with or without a turn; joint readings need the robot they are of: name its URDF with --robot.</source>
        <translation>%1: ihre Spalten (%2) sind keine Orte (x y z) mit oder ohne Drehung; Gelenkwerte brauchen den Roboter, von dem sie sind: nenne sein URDF mit --robot.</translation>
    </message>
    <message>
        <source>%1: its columns (%2) are neither joints of the robot (%3) nor places (x y z); name them so in the first line.</source>
        <translation>%1: ihre Spalten (%2) sind weder Gelenke des Roboters (%3) noch Orte (x y z); nenne sie so in der ersten Zeile.</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>has one line, and nothing below it</source>
        <translation>hat eine Zeile und nichts darunter</translation>
    </message>
    <message>
        <source>%1: tells where the controller believes the hand to be, and not how its joints stood; a touch needs a column for each joint: %2.</source>
        <translation>%1: sagt, wo die Steuerung die Hand glaubt, und nicht, wie die Gelenke standen; eine Berührung braucht eine Spalte für jedes Gelenk: %2.</translation>
    </message>
    <message>
        <source>%1: what tf2_echo printed is not whole at its pose %2; expected three numbers and four.</source>
        <translation>%1: was tf2_echo ausgab, ist bei Pose %2 nicht vollständig; erwartet sind drei Zahlen und vier.</translation>
    </message>
    <message>
        <source>%1: the places in it are taken for what a sensor measured of the hand; where they are the controller's own they measure nothing.</source>
        <translation>%1: die Orte darin gelten als das, was ein Sensor von der Hand gemessen hat; sind es die der Steuerung selbst, so messen sie nichts.</translation>
    </message>
    <message>
        <source>Poses of the flange and the images are paired by their times</source>
        <translation>Posen des Flansches und Bilder sind nach ihren Zeiten gepaart</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows have no number for some joint; they are left out.</source>
        <translation>%1: %2 von %3 Zeilen haben für ein Gelenk keine Zahl; sie sind ausgelassen.</translation>
    </message>
    <message>
        <source>%1: nothing is made of its columns %2.</source>
        <translation>%1: aus ihren Spalten %2 wird nichts gemacht.</translation>
    </message>
    <message>
        <source>%1: its numbered columns (%2 ...) are taken for the robot's joints in their order: %3.</source>
        <translation>%1: ihre nummerierten Spalten (%2 ...) gelten als die Gelenke des Roboters in deren Reihenfolge: %3.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows hold zeros alone, as programs write where nothing was found; they are left out.</source>
        <translation>%1: %2 von %3 Zeilen enthalten nur Nullen, wie Programme sie schreiben, wo nichts gefunden wurde; sie sind ausgelassen.</translation>
    </message>
    <message>
        <source>The touches contradict that %1 is %2 mm from %3: by them it is %4 mm, and without known distances %5 mm are left of them in place of %6 mm. Measure it again and put it right in &lt;apart&gt;.</source>
        <translation>Die Berührungen widersprechen dem, dass %1 %2 mm von %3 entfernt ist: nach ihnen sind es %4 mm, und ohne bekannte Abstände bleiben von ihnen %5 mm statt %6 mm. Miss ihn neu und berichtige ihn in &lt;apart&gt;.</translation>
    </message>
    <message>
        <source>is not known in a message, expected form, verbatim, number or sequence.</source>
        <translation>ist in einer Nachricht nicht bekannt; erwartet wird form, verbatim, number oder sequence.</translation>
    </message>
    <message>
        <source>stands too deep in a message, expected %1 levels at most.</source>
        <translation>steht zu tief in einer Nachricht; erwartet werden höchstens %1 Ebenen.</translation>
    </message>
    <message>
        <source>%1: has %2 columns and no header, so that nobody can say which are the joints; name them in a first line, or with --table-columns "%3 x y z" (a name each; - is left out; joint[deg], x[mm] say the unit).</source>
        <translation>%1: hat %2 Spalten und keinen Kopf, sodass niemand sagen kann, welche die Gelenke sind; nenne sie in einer ersten Zeile oder mit --table-columns "%3 x y z" (je ein Name; - wird weggelassen; gelenk[deg], x[mm] sagen die Einheit).</translation>
    </message>
    <message>
        <source>%1: the turn of its poses is the same in every row, though the hand turns: the device measures places alone, and they are taken for points of one marker.</source>
        <translation>%1: die Drehung seiner Posen ist in jeder Zeile dieselbe, obwohl die Hand sich dreht: das Gerät misst nur Orte, und sie werden als Punkte eines Markers genommen.</translation>
    </message>
    <message>
        <source>%1: %2 touches do not determine where the tip sits on the hand (%3 of its %4 numbers), and so no place of a fixture. %5</source>
        <translation>%1: %2 Berührungen bestimmen nicht, wo die Spitze an der Hand sitzt (%3 ihrer %4 Zahlen), und so keinen Ort einer Vorrichtung. %5</translation>
    </message>
</context>
<context>
    <name>system</name>
    <!-- What the operating system says of a file, and the window of a fit. -->
    <message>
        <source>The fit was stopped.</source>
        <translation>Die Anpassung wurde angehalten.</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>es gibt sie nicht</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>der Zugriff ist verweigert</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ein Teil des Pfades ist kein Ordner</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger lässt sich nur lesen</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>der Datenträger antwortet mit einem Fehler</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>der zugeteilte Platz ist voll</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>sie würde zu groß</translation>
    </message>
</context>
</TS>

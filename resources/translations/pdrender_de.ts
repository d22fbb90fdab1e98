<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>PD-Render</name>
    <message>
        <source> /mm</source>
        <translation> /mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> je Sekunde</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> samples</source>
        <translation> Abtastungen</translation>
    </message>
    <message>
        <source> · italics: measured for the previous view</source>
        <translation> · kursiv: von der Ansicht davor</translation>
    </message>
    <message>
        <source>"%1" is no address of a node: only a host and a port, without slashes, such as gpu-07:%2.</source>
        <translation>„%1“ ist keine Adresse eines Render-Rechners: nur Rechner und Port, ohne Schrägstriche, etwa gpu-07:%2.</translation>
    </message>
    <message>
        <source>"%1" is no host: names have letters, digits, dots and hyphens.</source>
        <translation>„%1“ ist kein Rechner: Namen haben Buchstaben, Ziffern, Punkte und Bindestriche.</translation>
    </message>
    <message>
        <source>"%1" is no port: ports are numbers from 1 to 65535.</source>
        <translation>„%1“ ist kein Port: Ports sind Zahlen von 1 bis 65535.</translation>
    </message>
    <message>
        <source>"--series %1" interpolates even slices between those that were measured.</source>
        <translation>„--series %1“ interpoliert gleichmäßige Schichten zwischen den gemessenen.</translation>
    </message>
    <message>
        <source>"pdrender-cli info FOLDER" lists all of them.</source>
        <translation>„pdrender-cli info ORDNER“ listet alle auf.</translation>
    </message>
    <message>
        <source>"pdrender-cli info FOLDER" lists those that there are.</source>
        <translation>„pdrender-cli info ORDNER“ listet auf, welche es gibt.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % bright (%2 to %3)</source>
        <translation>%1 % hell (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 % of %2 tiles of render nodes were rendered twice; one false tile in %3 would have been found with a probability of %4 %</source>
        <translation>%1 % von %2 Kacheln anderer Rechner wurden zweimal berechnet; eine falsche unter %3 wäre mit einer Wahrscheinlichkeit von %4 % gefunden worden</translation>
    </message>
    <message>
        <source>%1 % of the heartbeat</source>
        <translation>%1 % des Herzschlags</translation>
    </message>
    <message>
        <source>%1 % of the image's samples</source>
        <translation>%1 % der Abtastungen des Bildes</translation>
    </message>
    <message>
        <source>%1 % of the voxels lie below</source>
        <translation>%1 % der Voxel liegen darunter</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2, too few voxels for a ±</source>
        <translation>%1 %2, zu wenige Voxel für ein ±</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (geändert)</translation>
    </message>
    <message>
        <source>%1 (the image changes by %2 levels on average, 95 % of it by less than %3</source>
        <translation>%1 (das Bild ändert sich im Mittel um %2 Stufen, 95 % davon um weniger als %3</translation>
    </message>
    <message>
        <source>%1 (the rest is not yet removed)</source>
        <translation>%1 (der Rest ist noch nicht entfernt)</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HU</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 entlang %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 and %2 are %3 mm apart, the others %4 mm</source>
        <translation>%1 und %2 liegen %3 mm auseinander, die anderen %4 mm</translation>
    </message>
    <message>
        <source>%1 and %2 lie at the same height along the normal (%3 mm) but differ</source>
        <translation>%1 und %2 liegen auf gleicher Höhe entlang der Normalen (%3 mm), sind aber verschieden</translation>
    </message>
    <message>
        <source>%1 and %2 lie on different grids (%3 mm at a corner)</source>
        <translation>%1 und %2 liegen auf verschiedenen Gittern (%3 mm an einer Ecke)</translation>
    </message>
    <message>
        <source>%1 and %2 look in different directions</source>
        <translation>%1 und %2 sind verschieden ausgerichtet</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1 belongs to "%2". Give that another key first.</source>
        <translation>%1 gehört zu „%2“. Geben Sie dem zuerst eine andere Taste.</translation>
    </message>
    <message>
        <source>%1 cannot be given away: it moves the view or the keyboard's place.</source>
        <translation>%1 kann nicht vergeben werden: Die Taste bewegt die Ansicht oder den Tastaturfokus.</translation>
    </message>
    <message>
        <source>%1 cannot render this image: %2</source>
        <translation>%1 kann dieses Bild nicht rechnen: %2</translation>
    </message>
    <message>
        <source>%1 copies of slices left out (%2)</source>
        <translation>%1 Kopien von Schichten weggelassen (%2)</translation>
    </message>
    <message>
        <source>%1 damaged files of this series left out (%2)</source>
        <translation>%1 beschädigte Dateien dieser Serie weggelassen (%2)</translation>
    </message>
    <message>
        <source>%1 damaged files were left out</source>
        <translation>%1 beschädigte Dateien wurden ausgelassen</translation>
    </message>
    <message>
        <source>%1 does not say its %2</source>
        <translation>%1 nennt nicht: %2</translation>
    </message>
    <message>
        <source>%1 drawn</source>
        <translation>%1 gezeichnet</translation>
    </message>
    <message>
        <source>%1 files (%2 ...)</source>
        <translation>%1 Dateien (%2 ...)</translation>
    </message>
    <message>
        <source>%1 files could not be read, and slices of this series may be missing (%2)</source>
        <translation>%1 Dateien konnten nicht gelesen werden, und Schichten dieser Serie fehlen vielleicht (%2)</translation>
    </message>
    <message>
        <source>%1 free paths between voxels, above %2 multiple scattering comes out wrong</source>
        <translation>%1 freie Wege zwischen Voxeln, über %2 wird Mehrfachstreuung falsch</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 has %2, %3 has %4</source>
        <translation>%1 hat %2, %3 hat %4</translation>
    </message>
    <message>
        <source>%1 here, %2 there</source>
        <translation>%1 hier, %2 dort</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 in at least %2</source>
        <translation>%1 in mindestens %2</translation>
    </message>
    <message>
        <source>%1 is in the list already.</source>
        <translation>%1 steht schon in der Liste.</translation>
    </message>
    <message>
        <source>%1 is one slice; a volume needs at least two</source>
        <translation>%1 ist eine Schicht; ein Volumen braucht mindestens zwei</translation>
    </message>
    <message>
        <source>%1 iterations per frame on %2</source>
        <translation>%1 Iterationen je Bild auf %2</translation>
    </message>
    <message>
        <source>%1 iterations/s</source>
        <translation>%1 Iterationen/s</translation>
    </message>
    <message>
        <source>%1 joined</source>
        <translation>%1 kam dazu</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>%1 leaves</source>
        <translation>%1 verabschiedet sich</translation>
    </message>
    <message>
        <source>%1 lies %2 mm from where slices every %3 mm would put it</source>
        <translation>%1 liegt %2 mm von der Stelle, an die Schichten im Abstand von %3 mm es setzen würden</translation>
    </message>
    <message>
        <source>%1 lies %2 mm sideways of the straight line from %3 to %4</source>
        <translation>%1 liegt %2 mm seitlich der geraden Linie von %3 nach %4</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm apart at a corner</source>
        <translation>%1 mm auseinander an einer Ecke</translation>
    </message>
    <message>
        <source>%1 mm at the centre's depth</source>
        <translation>%1 mm in der Tiefe der Bildmitte</translation>
    </message>
    <message>
        <source>%1 mm behind: %2 % of the light</source>
        <translation>%1 mm dahinter: %2 % des Lichts</translation>
    </message>
    <message>
        <source>%1 mm off</source>
        <translation>%1 mm daneben</translation>
    </message>
    <message>
        <source>%1 mm: %2 %3</source>
        <translation>%1 mm: %2 %3</translation>
    </message>
    <message>
        <source>%1 mm: %2 %3, interpolated across a hole</source>
        <translation>%1 mm: %2 %3, über eine Lücke interpoliert</translation>
    </message>
    <message>
        <source>%1 mm: nothing measured</source>
        <translation>%1 mm: nichts gemessen</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms after the heartbeat</source>
        <translation>%1 ms nach dem Herzschlag</translation>
    </message>
    <message>
        <source>%1 nodes run a different build and were excluded</source>
        <translation>%1 Rechner haben einen anderen Programmstand und sind ausgeschlossen</translation>
    </message>
    <message>
        <source>%1 of %2 slices read; hatched: not read yet</source>
        <translation>%1 von %2 Schichten gelesen; schraffiert: noch nicht gelesen</translation>
    </message>
    <message>
        <source>%1 of it touched the skin: check the edge.</source>
        <translation>%1 davon lagen an der Haut an: Den Rand prüfen.</translation>
    </message>
    <message>
        <source>%1 of the curve</source>
        <translation>%1 der Kurve</translation>
    </message>
    <message>
        <source>%1 of the voxels are interpolated across a hole.</source>
        <translation>%1 der Voxel sind über eine Lücke interpoliert.</translation>
    </message>
    <message>
        <source>%1 or more thin lines hidden by denoising: E shows where</source>
        <translation>%1 oder mehr dünne Linien durch das Entrauschen verdeckt: E zeigt, wo</translation>
    </message>
    <message>
        <source>%1 over Hounsfield units</source>
        <translation>%1 über Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>%1 over the values of the scan</source>
        <translation>%1 über den Werten der Aufnahme</translation>
    </message>
    <message>
        <source>%1 pixels stretched to %2</source>
        <translation>%1 Pixel, gestreckt auf %2</translation>
    </message>
    <message>
        <source>%1 plans were not saved, the last one from %2 with %3. They will be restored when their series are opened.</source>
        <translation>%1 Pläne wurden nicht gesichert, der letzte von %2 mit %3. Sie werden wiederhergestellt, wenn ihre Serien geöffnet werden.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastungen</translation>
    </message>
    <message>
        <source>%1 separate parts are kept.</source>
        <translation>%1 getrennte Teile bleiben.</translation>
    </message>
    <message>
        <source>%1 series %2</source>
        <translation>%1-Serie %2</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 Schichten</translation>
    </message>
    <message>
        <source>%1 slices may be missing: the files are numbered up to %2, and number %3 and others are not there</source>
        <translation>%1 Schichten fehlen vielleicht: Die Dateien sind bis %2 nummeriert, und Nummer %3 und weitere sind nicht da</translation>
    </message>
    <message>
        <source>%1 slices may be missing: the files state that their acquisition made %2 images, and %3 are there</source>
        <translation>%1 Schichten fehlen vielleicht: Laut den Dateien hat ihre Aufnahme %2 Bilder ergeben, und %3 sind da</translation>
    </message>
    <message>
        <source>%1 slices may have been compressed with loss: their coding allows that, and their files do not say</source>
        <translation>%1 Schichten wurden vielleicht mit Verlust komprimiert: Ihre Codierung erlaubt das, und ihre Dateien sagen nichts dazu</translation>
    </message>
    <message>
        <source>%1 slices of this series on another grid listed apart</source>
        <translation>%1 Schichten dieser Serie auf einem anderen Gitter getrennt aufgeführt</translation>
    </message>
    <message>
        <source>%1 slices state a wrong length in their coding; they are complete, and were read to their end</source>
        <translation>%1 Schichten geben in ihrer Codierung eine falsche Länge an; sie sind vollständig und wurden bis zum Ende gelesen</translation>
    </message>
    <message>
        <source>%1 slices state no rescale; stored values are taken as HU</source>
        <translation>%1 Schichten nennen keine HU-Umrechnung; gespeicherte Werte werden als HU genommen</translation>
    </message>
    <message>
        <source>%1 slices were compressed with loss (%2): the values are not those that were measured</source>
        <translation>%1 Schichten wurden mit Verlust komprimiert (%2): Die Werte sind nicht die gemessenen</translation>
    </message>
    <message>
        <source>%1 slices were compressed with loss, which their files do not say: the values are not those that were measured</source>
        <translation>%1 Schichten wurden mit Verlust komprimiert, ohne dass ihre Dateien es angeben: Die Werte sind nicht die gemessenen</translation>
    </message>
    <message>
        <source>%1 slices, %2 apart, were resampled to %3 every %4 mm; a slice lies up to %5 mm from where anything was measured</source>
        <translation>%1 Schichten im Abstand von %2 wurden auf %3 alle %4 mm umgerechnet; eine Schicht liegt bis zu %5 mm von dem entfernt, was gemessen wurde</translation>
    </message>
    <message>
        <source>%1 states a pixel spacing of %2 mm x %3 mm</source>
        <translation>%1 nennt einen Pixelabstand von %2 mm x %3 mm</translation>
    </message>
    <message>
        <source>%1 states an orientation that is no pair of perpendicular directions</source>
        <translation>%1 nennt eine Ausrichtung, die kein Paar senkrechter Richtungen ist</translation>
    </message>
    <message>
        <source>%1 stopped answering: %2</source>
        <translation>%1 antwortet nicht mehr: %2</translation>
    </message>
    <message>
        <source>%1 thin line hidden by denoising: E shows where</source>
        <translation>%1 dünne Linie durch das Entrauschen verdeckt: E zeigt, wo</translation>
    </message>
    <message>
        <source>%1 thin lines hidden by denoising: E shows where</source>
        <translation>%1 dünne Linien durch das Entrauschen verdeckt: E zeigt, wo</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>%1 voxels lie beyond what 16 bits hold and were put at their end (-32768 or 32767 HU)</source>
        <translation>%1 Voxel liegen jenseits dessen, was 16 Bit fassen, und wurden an deren Ende gesetzt (-32768 oder 32767 HU)</translation>
    </message>
    <message>
        <source>%1 waits for the scan</source>
        <translation>%1 wartet auf den Scan</translation>
    </message>
    <message>
        <source>%1 was lost</source>
        <translation>%1 ging verloren</translation>
    </message>
    <message>
        <source>%1 was lost: %2</source>
        <translation>%1 ging verloren: %2</translation>
    </message>
    <message>
        <source>%1 was paused</source>
        <translation>%1 wurde angehalten</translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation>%1 wurde entfernt</translation>
    </message>
    <message>
        <source>%1 works for others</source>
        <translation>%1 arbeitet für andere</translation>
    </message>
    <message>
        <source>%1 x</source>
        <translation>%1 x</translation>
    </message>
    <message>
        <source>%1 x %2 pixels</source>
        <translation>%1 x %2 Pixel</translation>
    </message>
    <message>
        <source>%1 x %2 pixels of %3 mm x %4 mm</source>
        <translation>%1 x %2 Pixel zu %3 mm x %4 mm</translation>
    </message>
    <message>
        <source>%1 x %2 x %3</source>
        <translation>%1 x %2 x %3</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 mm</source>
        <translation>%1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1 ± %2 %3</source>
        <translation>%1 ± %2 %3</translation>
    </message>
    <message>
        <source>%1 · all active effects are needed</source>
        <translation>%1 · alle aktiven Effekte werden gebraucht</translation>
    </message>
    <message>
        <source>%1 · paused</source>
        <translation>%1 · angehalten</translation>
    </message>
    <message>
        <source>%1 · ±%2 took %3 the last time</source>
        <translation>%1 · ±%2 dauerte letztes Mal %3</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 × %2 pixels stretched to %3 × %4</source>
        <translation>%1 × %2 Pixel, gestreckt auf %3 × %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 iterations/s, %3</source>
        <translation>%1, %2 Iterationen/s, %3</translation>
    </message>
    <message>
        <source>%1, %2:1</source>
        <translation>%1, %2:1</translation>
    </message>
    <message>
        <source>%1, 95 % of the tissue within ±%2 levels (%3 to %4)</source>
        <translation>%1, 95 % des Gewebes innerhalb ±%2 Stufen (%3 bis %4)</translation>
    </message>
    <message>
        <source>%1, 95 % of the tissue within ±%2 levels at most, by now not told from none</source>
        <translation>%1, 95 % des Gewebes innerhalb höchstens ±%2 Stufen, noch nicht von keinem zu unterscheiden</translation>
    </message>
    <message>
        <source>%1, because %2</source>
        <translation>%1, denn %2</translation>
    </message>
    <message>
        <source>%1, before both sides knew each other</source>
        <translation>%1, bevor beide Seiten einander kannten</translation>
    </message>
    <message>
        <source>%1, before denoising</source>
        <translation>%1, vor dem Entrauschen</translation>
    </message>
    <message>
        <source>%1, interpolated across a hole</source>
        <translation>%1, über eine Lücke interpoliert</translation>
    </message>
    <message>
        <source>%1, not CT</source>
        <translation>%1, kein CT</translation>
    </message>
    <message>
        <source>%1, tilted by %2°</source>
        <translation>%1, um %2° gekippt</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2
Drag stops; Ctrl and click adds one; double click chooses a colour</source>
        <translation>%1: %2
Farbmarken ziehen; Strg und Klick fügt eine hinzu; Doppelklick wählt eine Farbe</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>%1: %2 cut off</source>
        <translation>%1: %2 abgeschnitten</translation>
    </message>
    <message>
        <source>%1: %2 from the middle</source>
        <translation>%1: %2 von der Mitte</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1; %2 heights are taken twice</source>
        <translation>%1; %2 Höhen sind doppelt belegt</translation>
    </message>
    <message>
        <source>%1; besides, %2</source>
        <translation>%1; außerdem: %2</translation>
    </message>
    <message>
        <source>%1; measured: %2</source>
        <translation>%1; gemessen: %2</translation>
    </message>
    <message>
        <source>%1; no gantry tilts by more than %2 degrees</source>
        <translation>%1; keine Gantry kippt um mehr als %2 Grad</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1° from above</source>
        <translation>%1° von oben</translation>
    </message>
    <message>
        <source>%1° from below</source>
        <translation>%1° von unten</translation>
    </message>
    <message numerus="yes">
        <source>%n measurement(s)</source>
        <translation><numerusform>%n Messung</numerusform><numerusform>%n Messungen</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation><numerusform>%n Punkt</numerusform><numerusform>%n Punkte</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n stop(s)</source>
        <translation><numerusform>%n Farbmarke</numerusform><numerusform>%n Farbmarken</numerusform></translation>
    </message>
    <message>
        <source>&amp;About PD-Render</source>
        <translation>&amp;Über PD-Render</translation>
    </message>
    <message>
        <source>&amp;All defaults</source>
        <translation>&amp;Alle Vorgaben</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>&amp;Brightness</source>
        <translation>Helligkei&amp;t</translation>
    </message>
    <message>
        <source>&amp;Colour...</source>
        <translation>Far&amp;be...</translation>
    </message>
    <message>
        <source>&amp;Copy image</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Copy slice</source>
        <translation>Schicht &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Schnitt</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Vorgabe</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Denoised</source>
        <translation>&amp;Entrauscht</translation>
    </message>
    <message>
        <source>&amp;Density</source>
        <translation>Dicht&amp;e</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Strecke</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Edit keys...</source>
        <translation>Tasten &amp;ändern...</translation>
    </message>
    <message>
        <source>&amp;Export this look...</source>
        <translation>Diese Darstellung &amp;exportieren...</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Fit the slice to its view</source>
        <translation>Schicht &amp;einpassen</translation>
    </message>
    <message>
        <source>&amp;Focus here</source>
        <translation>Hier scharf&amp;stellen</translation>
    </message>
    <message>
        <source>&amp;Forget these folders</source>
        <translation>Diese Ordner &amp;vergessen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>Geis&amp;t</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Verbergen</translation>
    </message>
    <message>
        <source>&amp;Image alone</source>
        <translation>Nur das &amp;Bild</translation>
    </message>
    <message>
        <source>&amp;Import...</source>
        <translation>&amp;Importieren...</translation>
    </message>
    <message>
        <source>&amp;Iterations per frame</source>
        <translation>&amp;Iterationen je Bild</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;My looks</source>
        <translation>Eige&amp;ne Darstellungen</translation>
    </message>
    <message>
        <source>&amp;Next layout</source>
        <translation>Nächste &amp;Anordnung</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>&amp;Open a folder...</source>
        <translation>&amp;Ordner öffnen...</translation>
    </message>
    <message>
        <source>&amp;Open folder...</source>
        <translation>Ordner ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Remember folders</source>
        <translation>Ordner &amp;merken</translation>
    </message>
    <message>
        <source>&amp;Remove surface</source>
        <translation>Oberflä&amp;che abtragen</translation>
    </message>
    <message>
        <source>&amp;Rename...</source>
        <translation>&amp;Umbenennen...</translation>
    </message>
    <message>
        <source>&amp;Save image...</source>
        <translation>Bild &amp;speichern...</translation>
    </message>
    <message>
        <source>&amp;Save this look...</source>
        <translation>Diese Darstellung &amp;sichern...</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Table and holder</source>
        <translation>&amp;Tisch und Halterung</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Window of the slices</source>
        <translation>&amp;Fenster der Schichten</translation>
    </message>
    <message>
        <source>&amp;Window...</source>
        <translation>&amp;Fenster...</translation>
    </message>
    <message>
        <source>(no unit)</source>
        <translation>(ohne Einheit)</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, noch %1</translation>
    </message>
    <message>
        <source>, within ±%1 levels</source>
        <translation>, innerhalb ±%1 Stufen</translation>
    </message>
    <message>
        <source>/mm</source>
        <translation>/mm</translation>
    </message>
    <message>
        <source>1 copy of a slice left out (%2)</source>
        <translation>1 Kopie einer Schicht weggelassen (%2)</translation>
    </message>
    <message>
        <source>1 damaged file of this series left out (%2)</source>
        <translation>1 beschädigte Datei dieser Serie weggelassen (%2)</translation>
    </message>
    <message>
        <source>1 damaged file was left out</source>
        <translation>1 beschädigte Datei wurde ausgelassen</translation>
    </message>
    <message>
        <source>1 file could not be read, and slices of this series may be missing (%2)</source>
        <translation>1 Datei konnte nicht gelesen werden, und Schichten dieser Serie fehlen vielleicht (%2)</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>1 iteration per frame on %1</source>
        <translation>1 Iteration je Bild auf %1</translation>
    </message>
    <message>
        <source>1 node runs a different build and was excluded</source>
        <translation>1 Rechner hat einen anderen Programmstand und ist ausgeschlossen</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 Abtastung</translation>
    </message>
    <message>
        <source>1 slice may be missing: the files are numbered up to %2, and number %3 is not there</source>
        <translation>1 Schicht fehlt vielleicht: Die Dateien sind bis %2 nummeriert, und Nummer %3 ist nicht da</translation>
    </message>
    <message>
        <source>1 slice may be missing: the files state that their acquisition made %2 images, and %3 are there</source>
        <translation>1 Schicht fehlt vielleicht: Laut den Dateien hat ihre Aufnahme %2 Bilder ergeben, und %3 sind da</translation>
    </message>
    <message>
        <source>1 slice may have been compressed with loss: its coding allows that, and its file does not say</source>
        <translation>1 Schicht wurde vielleicht mit Verlust komprimiert: Ihre Codierung erlaubt das, und ihre Datei sagt nichts dazu</translation>
    </message>
    <message>
        <source>1 slice of this series on another grid listed apart</source>
        <translation>1 Schicht dieser Serie auf einem anderen Gitter getrennt aufgeführt</translation>
    </message>
    <message>
        <source>1 slice states a wrong length in its coding; it is complete, and was read to its end</source>
        <translation>1 Schicht gibt in ihrer Codierung eine falsche Länge an; sie ist vollständig und wurde bis zum Ende gelesen</translation>
    </message>
    <message>
        <source>1 slice states no rescale; stored values are taken as HU</source>
        <translation>1 Schicht nennt keine HU-Umrechnung; gespeicherte Werte werden als HU genommen</translation>
    </message>
    <message>
        <source>1 slice was compressed with loss (%2): the values are not those that were measured</source>
        <translation>1 Schicht wurde mit Verlust komprimiert (%2): Die Werte sind nicht die gemessenen</translation>
    </message>
    <message>
        <source>1 slice was compressed with loss, which its file does not say: the values are not those that were measured</source>
        <translation>1 Schicht wurde mit Verlust komprimiert, ohne dass ihre Datei es angibt: Die Werte sind nicht die gemessenen</translation>
    </message>
    <message>
        <source>1 voxel lies beyond what 16 bits hold and was put at their end (-32768 or 32767 HU)</source>
        <translation>1 Voxel liegt jenseits dessen, was 16 Bit fassen, und wurde an deren Ende gesetzt (-32768 oder 32767 HU)</translation>
    </message>
    <message>
        <source>1/√t</source>
        <translation>1/√t</translation>
    </message>
    <message>
        <source>3D Slicer before 5.9, curves only (*.vp)</source>
        <translation>3D Slicer vor 5.9, nur Kurven (*.vp)</translation>
    </message>
    <message>
        <source>3D Slicer, curves only (*.vp.json)</source>
        <translation>3D Slicer, nur Kurven (*.vp.json)</translation>
    </message>
    <message>
        <source>95 % error per pixel, of 255</source>
        <translation>95-%-Fehler je Pixel, von 255</translation>
    </message>
    <message>
        <source>95 % of the image changes by no more levels than this; to 95 % it lies between the two faint numbers</source>
        <translation>95 % des Bildes ändern sich um höchstens so viele Stufen; zu 95 % liegt der Wert zwischen den beiden blassen Zahlen</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % innerhalb</translation>
    </message>
    <message>
        <source>; any target takes %1 of the time</source>
        <translation>; jedes Ziel braucht %1 der Zeit</translation>
    </message>
    <message>
        <source>&lt; %1</source>
        <translation>&lt; %1</translation>
    </message>
    <message>
        <source>&lt;h3&gt;PD-Render %1&lt;/h3&gt;&lt;p&gt;Photorealistic images of CT volumes, with a measure of how right they are.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnostic use.&lt;/b&gt; PD-Render is not a certified medical device.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Made with Qt, DCMTK, OpenEXR and oneTBB.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;PD-Render %1&lt;/h3&gt;&lt;p&gt;Fotorealistische Bilder von CT-Volumen, mit einem Maß dafür, wie richtig sie sind.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Nicht für die Diagnose.&lt;/b&gt; PD-Render ist kein zugelassenes Medizinprodukt.&lt;/p&gt;&lt;p&gt;Apache-Lizenz 2.0. Gemacht mit Qt, DCMTK, OpenEXR und oneTBB.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A pinhole, which focuses nowhere</source>
        <translation>Eine Lochkamera, die nirgends scharf stellt</translation>
    </message>
    <message>
        <source>A plan from %1 with %2 was not saved. It will be restored when its series is opened.</source>
        <translation>Ein Plan von %1 mit %2 wurde nicht gesichert. Er wird wiederhergestellt, wenn seine Serie geöffnet wird.</translation>
    </message>
    <message>
        <source>A plane between front and back</source>
        <translation>Eine Ebene zwischen vorn und hinten</translation>
    </message>
    <message>
        <source>A plane between head and feet</source>
        <translation>Eine Ebene zwischen Kopf und Füßen</translation>
    </message>
    <message>
        <source>A plane between left and right</source>
        <translation>Eine Ebene zwischen links und rechts</translation>
    </message>
    <message>
        <source>A plane that faces you, through the middle</source>
        <translation>Eine Ebene, die zu Ihnen zeigt, durch die Mitte</translation>
    </message>
    <message>
        <source>A sample takes about %1 times as long as with “%2”; 95 % of the image changes by at most %3 of 255 levels.</source>
        <translation>Eine Stichprobe dauert etwa %1-mal so lange wie mit „%2“; 95 % des Bildes ändern sich um höchstens %3 von 255 Stufen.</translation>
    </message>
    <message>
        <source>A small lamp beside the eye: few shadows, and light in every recess</source>
        <translation>Eine kleine Lampe neben dem Auge: wenig Schatten und Licht in jeder Vertiefung</translation>
    </message>
    <message>
        <source>A small lamp from the side that shows form, a weak one against it, and one behind</source>
        <translation>Eine kleine Lampe von der Seite, die Form zeigt, eine schwache dagegen und eine dahinter</translation>
    </message>
    <message>
        <source>A&amp;nnotate saved images</source>
        <translation>Gespeicherte Bilder &amp;beschriften</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>About PD-Render</source>
        <translation>Über PD-Render</translation>
    </message>
    <message>
        <source>About the series</source>
        <translation>Über die Serie</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Accuracy of the image</source>
        <translation>Genauigkeit des Bildes</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a &amp;plane that faces you</source>
        <translation>Eine &amp;zugewandte Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Add a plane: %1</source>
        <translation>Ebene hinzufügen: %1</translation>
    </message>
    <message>
        <source>Add the node</source>
        <translation>Den Render-Rechner hinzufügen</translation>
    </message>
    <message>
        <source>Address of a node</source>
        <translation>Adresse eines Render-Rechners</translation>
    </message>
    <message>
        <source>Adds a panel like the chosen one, as a lamp of its own</source>
        <translation>Fügt eine Fläche wie die gewählte hinzu, als eigene Lampe</translation>
    </message>
    <message>
        <source>All but %1</source>
        <translation>Alles außer %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All is sharp. A lens blurs what lies before and behind its focus.</source>
        <translation>Alles ist scharf. Eine Linse zeichnet weich, was vor und hinter ihrer Schärfeebene liegt.</translation>
    </message>
    <message>
        <source>All nodes compute the same bits as this machine</source>
        <translation>Alle Render-Rechner rechnen bitgleich mit diesem Rechner</translation>
    </message>
    <message>
        <source>All of the message</source>
        <translation>Die ganze Meldung</translation>
    </message>
    <message>
        <source>All panels in numbers</source>
        <translation>Alle Leuchtflächen in Zahlen</translation>
    </message>
    <message>
        <source>All sharp</source>
        <translation>Alles scharf</translation>
    </message>
    <message>
        <source>All tissue glows through all other. Lamps have no effect.</source>
        <translation>Alles Gewebe leuchtet durch alles andere. Lampen zählen nicht.</translation>
    </message>
    <message>
        <source>Always samples</source>
        <translation>Immer Abtastungen</translation>
    </message>
    <message>
        <source>Always tiles</source>
        <translation>Immer Kacheln</translation>
    </message>
    <message>
        <source>Ambie&amp;nt</source>
        <translation>&amp;Umgebung</translation>
    </message>
    <message>
        <source>Ambient light</source>
        <translation>Umgebungslicht</translation>
    </message>
    <message>
        <source>An IPv6 address stands in brackets: [%1] or [%1]:%2.</source>
        <translation>Eine IPv6-Adresse steht in Klammern: [%1] oder [%1]:%2.</translation>
    </message>
    <message>
        <source>An end at an edge, at %1 %2.</source>
        <translation>Ein Ende an einer Kante, bei %1 %2.</translation>
    </message>
    <message>
        <source>An image is still rendering. Quit and discard it?</source>
        <translation>Ein Bild wird noch gerechnet. Beenden und verwerfen?</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Winkel %1</translation>
    </message>
    <message>
        <source>Angle of two lines</source>
        <translation>Winkel zweier Linien</translation>
    </message>
    <message>
        <source>Annotations:</source>
        <translation>Beschriftung:</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Apert&amp;ure</source>
        <translation>Bl&amp;ende</translation>
    </message>
    <message>
        <source>Aperture</source>
        <translation>Blende</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Area %1.</source>
        <translation>Fläche %1.</translation>
    </message>
    <message>
        <source>Area of a polygon</source>
        <translation>Fläche eines Vielecks</translation>
    </message>
    <message>
        <source>Arrow keys move the chosen lamp, Page up and Page down choose another, Shift and arrow keys turn all.</source>
        <translation>Pfeiltasten bewegen die gewählte Lampe, Bild auf und Bild ab wählen eine andere, Umschalt und Pfeiltasten drehen alle.</translation>
    </message>
    <message>
        <source>As all tissue</source>
        <translation>Wie alles Gewebe</translation>
    </message>
    <message>
        <source>As many iterations per frame as keep the cost of display negligible, within the frame rate. The result is the same.</source>
        <translation>So viele Iterationen zwischen zwei Bildern, dass das Zeigen fast nichts kostet, aber nicht mehr, als die Bildrate zulässt. Das Ergebnis ist dasselbe.</translation>
    </message>
    <message>
        <source>As on the screen, %1</source>
        <translation>Wie auf dem Bildschirm, %1</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>As the scan states</source>
        <translation>Wie in der Aufnahme angegeben</translation>
    </message>
    <message>
        <source>Ask its owner for permission to read.</source>
        <translation>Den Eigentümer um Leserechte bitten.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Away</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Axial %1 of %2</source>
        <translation>Axial %1 von %2</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Axiale Schicht</translation>
    </message>
    <message>
        <source>Bac&amp;kground</source>
        <translation>Hintergr&amp;und</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Back light</source>
        <translation>Gegenlicht</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Ball %1</source>
        <translation>Kugel %1</translation>
    </message>
    <message>
        <source>Bell</source>
        <translation>Glocke</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Blur each iteration</source>
        <translation>Jede Iteration weichzeichnen</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Bone beside contrast</source>
        <translation>Knochen neben Kontrastmittel</translation>
    </message>
    <message>
        <source>Bone is a ghost only, and soft tissue is not shown. Implants are found by the density of metal or by another program; what metal blurs may be among them.</source>
        <translation>Knochen ist nur ein Geist, Weichgewebe nicht zu sehen. Implantate findet eine Regel nach der Dichte von Metall oder ein anderes Programm; was Metall verwischt, kann darunter sein.</translation>
    </message>
    <message>
        <source>Bone is a shadow only, and soft tissue is not shown. What metal blurs looks like metal.</source>
        <translation>Knochen ist nur ein Schatten, Weichgewebe nicht zu sehen. Was Metall verwischt, sieht aus wie Metall.</translation>
    </message>
    <message>
        <source>Bone is found automatically. Thin or porous bone may be missing; dense contrast may remain.</source>
        <translation>Knochen wird automatisch gefunden. Dünner oder poröser Knochen kann fehlen, dichtes Kontrastmittel bleiben.</translation>
    </message>
    <message>
        <source>Bone is removed automatically. Dense contrast may disappear with it; bone edges may remain.</source>
        <translation>Knochen wird automatisch entfernt. Dichtes Kontrastmittel kann mit verschwinden, Knochenränder können bleiben.</translation>
    </message>
    <message>
        <source>Bone that is no denser than the contrast in the blood is not shown: thin bone has false holes.</source>
        <translation>Knochen, der nicht dichter ist als das Kontrastmittel im Blut, ist nicht zu sehen: Dünner Knochen hat falsche Löcher.</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Bones alone</source>
        <translation>Nur Knochen</translation>
    </message>
    <message>
        <source>Bones and vessels</source>
        <translation>Knochen und Gefäße</translation>
    </message>
    <message>
        <source>Bones are not shown, nor is what lies within 2 mm of them; dense vessels may be missing with them.</source>
        <translation>Knochen sind nicht zu sehen, auch nichts im Umkreis von 2 mm; dichte Gefäße fehlen vielleicht mit ihnen.</translation>
    </message>
    <message>
        <source>Bones, vessels and muscle</source>
        <translation>Knochen, Gefäße und Muskeln</translation>
    </message>
    <message>
        <source>Both programs should be of the same release.</source>
        <translation>Beide Programme sollten dieselbe Version haben.</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Bright values, solid</source>
        <translation>Helle Werte als Körper</translation>
    </message>
    <message>
        <source>Brightens shadows; none at the left end</source>
        <translation>Hellt auf, was im Schatten liegt; ganz links gibt es keines</translation>
    </message>
    <message>
        <source>Brighter to the right. It changes what is shown, not what is computed.</source>
        <translation>Nach rechts heller. Das ändert, was gezeigt wird, nicht, was berechnet wird.</translation>
    </message>
    <message>
        <source>Brightest values</source>
        <translation>Hellste Werte</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Bytes from the node</source>
        <translation>Bytes vom Render-Rechner</translation>
    </message>
    <message>
        <source>Bytes to the node</source>
        <translation>Bytes zum Render-Rechner</translation>
    </message>
    <message>
        <source>C&amp;olours on the slices</source>
        <translation>&amp;Farben auf den Schichten</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>CT &amp;denoised</source>
        <translation>CT &amp;entrauscht</translation>
    </message>
    <message>
        <source>CT denoised</source>
        <translation>CT entrauscht</translation>
    </message>
    <message>
        <source>CT series %1</source>
        <translation>CT-Serie %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel a gesture, reading or a box, close a message</source>
        <translation>Geste, Einlesen oder Kasten abbrechen, Meldung schließen</translation>
    </message>
    <message>
        <source>Cancelled: no image was saved</source>
        <translation>Abgebrochen: kein Bild gespeichert</translation>
    </message>
    <message>
        <source>Certificates...</source>
        <translation>Zertifikate...</translation>
    </message>
    <message>
        <source>Change its permissions, or choose another name.</source>
        <translation>Ihre Zugriffsrechte ändern oder einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Change that.</source>
        <translation>Das ändern.</translation>
    </message>
    <message>
        <source>Change the view or the look first.</source>
        <translation>Erst die Ansicht oder die Darstellung ändern.</translation>
    </message>
    <message>
        <source>Changes keyboard shortcuts.</source>
        <translation>Ändert die Tastenkürzel.</translation>
    </message>
    <message>
        <source>Check all</source>
        <translation>Alles prüfen</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Ihre Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>Check size and type.</source>
        <translation>Größe und Typ prüfen.</translation>
    </message>
    <message>
        <source>Check that you may read it.</source>
        <translation>Prüfen, ob Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>Check the disk that it lies on.</source>
        <translation>Die Platte prüfen, auf der sie liegt.</translation>
    </message>
    <message>
        <source>Check the file.</source>
        <translation>Die Datei prüfen.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Den Pfad prüfen.</translation>
    </message>
    <message>
        <source>Check the spelling.</source>
        <translation>Die Schreibweise prüfen.</translation>
    </message>
    <message>
        <source>Check the type, and that the file is little endian.</source>
        <translation>Den Typ prüfen, und ob die Datei little endian ist.</translation>
    </message>
    <message>
        <source>Check the unit: it is millimetres.</source>
        <translation>Die Einheit prüfen: Es sind Millimeter.</translation>
    </message>
    <message>
        <source>Check this machine's clock.</source>
        <translation>Die Uhr dieses Rechners prüfen.</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Brustkorb</translation>
    </message>
    <message>
        <source>Choose a folder of your own.</source>
        <translation>Einen eigenen Ordner wählen.</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to.</source>
        <translation>Einen Ordner wählen, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>Choose a folder with a NIfTI, NRRD or MetaImage mask of each part.</source>
        <translation>Wählen Sie einen Ordner mit einer NIfTI-, NRRD- oder MetaImage-Maske für jeden Teil.</translation>
    </message>
    <message>
        <source>Choose a folder with fewer masks.</source>
        <translation>Wählen Sie einen Ordner mit weniger Masken.</translation>
    </message>
    <message>
        <source>Choose a folder with masks of one scan.</source>
        <translation>Wählen Sie einen Ordner mit Masken einer einzigen Aufnahme.</translation>
    </message>
    <message>
        <source>Choose a label map: a DICOM segmentation, NIfTI, NRRD or MetaImage.</source>
        <translation>Wählen Sie eine Labelkarte: eine DICOM-Segmentierung, NIfTI, NRRD oder MetaImage.</translation>
    </message>
    <message>
        <source>Choose a label map: whole numbers from 0 on, one for each part.</source>
        <translation>Wählen Sie eine Labelkarte: ganze Zahlen ab 0, eine für jeden Teil.</translation>
    </message>
    <message>
        <source>Choose a name that ends in .png or .exr.</source>
        <translation>Einen Namen wählen, der auf .png oder .exr endet.</translation>
    </message>
    <message>
        <source>Choose a series from the list on the left.</source>
        <translation>Wählen Sie links in der Liste eine Serie.</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Einen kürzeren Namen wählen.</translation>
    </message>
    <message>
        <source>Choose a smaller size.</source>
        <translation>Eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>Choose an action, click below, and press its new key.</source>
        <translation>Wählen Sie einen Befehl, klicken Sie unten hinein und drücken Sie die neue Taste.</translation>
    </message>
    <message>
        <source>Choose an empty or a new folder.</source>
        <translation>Einen leeren oder neuen Ordner wählen.</translation>
    </message>
    <message>
        <source>Choose another device; this one cannot be trusted.</source>
        <translation>Ein anderes Gerät wählen; diesem ist nicht zu trauen.</translation>
    </message>
    <message>
        <source>Choose another folder, or delete this one first: nodes that have the old ones are strangers then.</source>
        <translation>Einen anderen Ordner wählen oder diesen erst löschen: Render-Rechner mit den alten sind dann fremd.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Choose another image.</source>
        <translation>Ein anderes Bild wählen.</translation>
    </message>
    <message>
        <source>Choose another name, or one within it.</source>
        <translation>Einen anderen Namen wählen oder einen darin.</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Choose another one.</source>
        <translation>Bitte etwas anderes wählen.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Choose another port.</source>
        <translation>Einen anderen Port wählen.</translation>
    </message>
    <message>
        <source>Choose another series.</source>
        <translation>Eine andere Serie wählen.</translation>
    </message>
    <message>
        <source>Choose auto, cpu, cuda or cuda:1.</source>
        <translation>auto, cpu, cuda oder cuda:1 wählen.</translation>
    </message>
    <message>
        <source>Choose exact filtering, which needs less, import a part of the series, close programs that use the device, or render on the CPU.</source>
        <translation>Genaues Filtern wählen, das weniger braucht, einen Teil der Serie laden, Programme schließen, die das Gerät benutzen, oder auf der CPU rechnen.</translation>
    </message>
    <message>
        <source>Choose exact filtering.</source>
        <translation>Genaues Filtern wählen.</translation>
    </message>
    <message>
        <source>Choose the colour of the selected stop</source>
        <translation>Die Farbe der gewählten Marke wählen</translation>
    </message>
    <message>
        <source>Choose the schedule of PD-Render.</source>
        <translation>Den Ablauf von PD-Render wählen.</translation>
    </message>
    <message>
        <source>Choose the series that it was made on.</source>
        <translation>Wählen Sie die Serie, auf der sie erzeugt wurde.</translation>
    </message>
    <message>
        <source>Click a place, and type what it is. The list shows its value.</source>
        <translation>Einen Punkt anklicken und eintippen, was er ist. Die Liste zeigt seinen Wert.</translation>
    </message>
    <message>
        <source>Click both ends of a line, then of another: the angle between their directions.</source>
        <translation>Beide Enden einer Linie anklicken, dann einer zweiten: der Winkel zwischen ihren Richtungen.</translation>
    </message>
    <message>
        <source>Click the corners of a polygon on a slice. Enter, a double click or a click on the first corner closes it, Backspace takes the last corner back.</source>
        <translation>Auf einer Schicht die Ecken eines Vielecks anklicken. Die Eingabetaste, ein Doppelklick oder ein Klick auf die erste Ecke schließt es, die Rücktaste nimmt die letzte Ecke zurück.</translation>
    </message>
    <message>
        <source>Click the middle of a ball, then a place on its surface: the mean of the values inside.</source>
        <translation>Die Mitte einer Kugel anklicken, dann einen Punkt auf ihrer Oberfläche: der Mittelwert der Werte darin.</translation>
    </message>
    <message>
        <source>Click the middle of an ellipse on a slice, the end of one half axis, then how far the other reaches: the mean of the values inside, and the area.</source>
        <translation>Auf einer Schicht die Mitte einer Ellipse anklicken, das Ende einer Halbachse, dann wie weit die andere reicht: der Mittelwert der Werte darin und die Fläche.</translation>
    </message>
    <message>
        <source>Click there, or press Esc to give it up.</source>
        <translation>Klicken Sie dort, oder geben Sie sie mit Esc auf.</translation>
    </message>
    <message>
        <source>Click three places of a slice or of the image: the angle at the second.</source>
        <translation>Drei Punkte einer Schicht oder des Bildes anklicken: der Winkel am zweiten.</translation>
    </message>
    <message>
        <source>Click two places of a slice or of the image. They move to the edge of a structure; Alt: they stay.</source>
        <translation>Zwei Punkte einer Schicht oder des Bildes anklicken. Sie rücken an den Rand einer Struktur; Alt: Sie bleiben.</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>%1 schließen</translation>
    </message>
    <message>
        <source>Close it with Enter, or take corners back with Backspace.</source>
        <translation>Schließen Sie es mit der Eingabetaste, oder nehmen Sie Ecken mit der Rücktaste zurück.</translation>
    </message>
    <message>
        <source>Close other programs, or import fewer slices.</source>
        <translation>Andere Programme schließen oder weniger Schichten laden.</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit of open files (ulimit -n).</source>
        <translation>Andere Programme schließen oder mehr offene Dateien erlauben (ulimit -n).</translation>
    </message>
    <message>
        <source>Close other programs, or show everything.</source>
        <translation>Andere Programme schließen oder alles zeigen.</translation>
    </message>
    <message>
        <source>Close other programs, or take a smaller volume.</source>
        <translation>Andere Programme schließen oder ein kleineres Volumen nehmen.</translation>
    </message>
    <message>
        <source>Close other programs, then try again.</source>
        <translation>Andere Programme schließen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>Andere Programme schließen.</translation>
    </message>
    <message>
        <source>Close panel</source>
        <translation>Bereich schließen</translation>
    </message>
    <message>
        <source>Close programs that use the GPU, make the image smaller, or render on the CPU.</source>
        <translation>Programme schließen, die die GPU benutzen, das Bild verkleinern oder auf der CPU rechnen.</translation>
    </message>
    <message>
        <source>Close programs, or make the image smaller.</source>
        <translation>Programme schließen oder das Bild verkleinern.</translation>
    </message>
    <message>
        <source>Close that program, or ask who looks after the computer; until then only the CPU can render.</source>
        <translation>Dieses Programm schließen oder fragen, wer den Computer betreut; bis dahin kann nur die CPU rechnen.</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Closes the window. Unsaved images are lost.</source>
        <translation>Schließt das Fenster. Nicht gespeicherte Bilder gehen verloren.</translation>
    </message>
    <message>
        <source>Coarse preview; the full image follows</source>
        <translation>Grobe Vorschau; das volle Bild folgt</translation>
    </message>
    <message>
        <source>Colour at %1</source>
        <translation>Farbe bei %1</translation>
    </message>
    <message>
        <source>Colour of its light: double click it</source>
        <translation>Farbe ihres Lichts: Doppelklick ändert sie</translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation>Farbe des Lichts</translation>
    </message>
    <message>
        <source>Colour of the part</source>
        <translation>Farbe des Teils</translation>
    </message>
    <message>
        <source>Colour of the selected stop</source>
        <translation>Farbe der gewählten Marke</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Farbe...</translation>
    </message>
    <message>
        <source>Colours each pixel by its 95 % error, in grey levels of 255.</source>
        <translation>Färbt jedes Pixel danach, wie weit es abweichen kann, in Graustufen von 255.</translation>
    </message>
    <message>
        <source>Colours over Hounsfield units</source>
        <translation>Farben über Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>Colours over the values of the scan</source>
        <translation>Farben über den Werten der Aufnahme</translation>
    </message>
    <message>
        <source>Comparison with Exposure Render</source>
        <translation>Vergleich mit Exposure Render</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Wird verbunden</translation>
    </message>
    <message>
        <source>Connection security</source>
        <translation>Sicherheit der Verbindung</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>Copies the image to the clipboard, with its caption and without the patient's name.</source>
        <translation>Kopiert das Bild in die Zwischenablage, mit seiner Beschriftung und ohne Namen.</translation>
    </message>
    <message>
        <source>Copy the file again from its source.</source>
        <translation>Die Datei noch einmal von ihrer Quelle kopieren.</translation>
    </message>
    <message>
        <source>Copy the file again.</source>
        <translation>Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Coronal %1 of %2</source>
        <translation>Koronal %1 von %2</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Koronale Schicht</translation>
    </message>
    <message>
        <source>Correct that place, or remove the measurement from the file.</source>
        <translation>Berichtigen Sie diesen Ort, oder entfernen Sie die Messung aus der Datei.</translation>
    </message>
    <message>
        <source>Create it by hand, or make the folder above it writable.</source>
        <translation>Legen Sie ihn von Hand an, oder machen Sie den Ordner darüber beschreibbar.</translation>
    </message>
    <message>
        <source>Create the folder first, or choose another place.</source>
        <translation>Den Ordner erst anlegen oder einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Ctrl+click on the image</source>
        <translation>Strg+Klick ins Bild</translation>
    </message>
    <message>
        <source>Ctrl+drag on the image</source>
        <translation>Strg+Ziehen im Bild</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut away the other side</source>
        <translation>Die andere Seite wegschneiden</translation>
    </message>
    <message>
        <source>Cut off at each side</source>
        <translation>An jeder Seite abgeschnitten</translation>
    </message>
    <message>
        <source>Cut the other side</source>
        <translation>Andere Seite schneiden</translation>
    </message>
    <message>
        <source>Cut with &amp;handles</source>
        <translation>Mit &amp;Griffen schneiden</translation>
    </message>
    <message>
        <source>Cuts away what lies in front of a plane through the middle of the image.</source>
        <translation>Schneidet weg, was vor einer Ebene durch die Bildmitte liegt.</translation>
    </message>
    <message>
        <source>Delete "%1"?</source>
        <translation>„%1“ löschen?</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the look</source>
        <translation>Darstellung löschen</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Alle löschen</translation>
    </message>
    <message>
        <source>Denoised, error not known yet</source>
        <translation>Entrauscht, Fehler noch nicht bekannt</translation>
    </message>
    <message>
        <source>Denoised, error ±%1</source>
        <translation>Entrauscht, Fehler ±%1</translation>
    </message>
    <message>
        <source>Denoised, image error ±%1 of 255 grey levels (95 % of the tissue)</source>
        <translation>Entrauscht, Bildfehler ±%1 von 255 Graustufen (95 % des Gewebes)</translation>
    </message>
    <message>
        <source>Density at the top of the opacity curve</source>
        <translation>Dichte am höchsten Punkt der Opazitätskurve</translation>
    </message>
    <message>
        <source>Depth is not shown, nor anything outside the lungs, nor their outermost 5 mm.</source>
        <translation>Tiefe ist nicht zu sehen, auch nichts außerhalb der Lungen und nicht deren äußerste 5 mm.</translation>
    </message>
    <message>
        <source>Depth is not shown, nor what lies in front of or behind something denser.</source>
        <translation>Tiefe ist nicht zu sehen, auch nicht, was vor oder hinter Dichterem liegt.</translation>
    </message>
    <message>
        <source>Depth is not shown: what lies behind one another adds up.</source>
        <translation>Tiefe ist nicht zu sehen: Was hintereinander liegt, addiert sich.</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Dialling</source>
        <translation>Wird angerufen</translation>
    </message>
    <message>
        <source>Diameter of the lens. At 0 all is sharp; the larger, the less is sharp before and behind the focus</source>
        <translation>Durchmesser der Linse. Bei 0 ist alles scharf; je größer, desto weniger ist vor und hinter der Schärfeebene scharf</translation>
    </message>
    <message>
        <source>Disconnect the selected nodes and erase the scan on them (Delete)</source>
        <translation>Trennt die gewählten Rechner und löscht die Aufnahme dort (Entf)</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Strecke %1</translation>
    </message>
    <message>
        <source>Distance cut off, side: %1</source>
        <translation>Abgeschnitten an der Seite: %1</translation>
    </message>
    <message>
        <source>Distance of the plane from the middle</source>
        <translation>Abstand der Ebene von der Mitte</translation>
    </message>
    <message>
        <source>Double click on a handle</source>
        <translation>Doppelklick auf einen Griff</translation>
    </message>
    <message>
        <source>Drag a lamp to where the light is to come from: over the ball it stands on your side, in the ring about it behind the patient. Beside the lamps, a drag turns them all. On the image, Shift and the right button do the same.</source>
        <translation>Ziehen Sie eine Lampe dorthin, woher das Licht kommen soll: Über der Kugel steht sie auf Ihrer Seite, im Ring darum hinter dem Patienten. Neben den Lampen dreht ein Zug sie alle. Im Bild tun Umschalt und die rechte Taste dasselbe.</translation>
    </message>
    <message>
        <source>Drag a side of the box to cut off what lies outside, in millimetres.</source>
        <translation>Eine Seite des Quaders ziehen, um abzuschneiden, was außerhalb liegt, in Millimetern.</translation>
    </message>
    <message>
        <source>Drag points; click the line to add one; wheel zooms, with Shift the values; double click fits</source>
        <translation>Punkte ziehen; ein Klick auf die Linie fügt einen hinzu; das Rad zoomt, mit Umschalt die Werte; Doppelklick zeigt alles</translation>
    </message>
    <message>
        <source>Draw a box on the image: it gets all samples until it reaches the target.</source>
        <translation>Zeichnen Sie einen Rahmen ins Bild: Er erhält alle Abtastungen, bis er so gut ist wie gewünscht.</translation>
    </message>
    <message>
        <source>Draw a closed outline on the image, then remove the tissue inside it, or everything else (X)</source>
        <translation>Eine geschlossene Linie ins Bild zeichnen, dann wegschneiden, was hinter ihr liegt, oder alles andere (X)</translation>
    </message>
    <message>
        <source>Draw a closed outline on the image, then remove the tissue inside it, or everything else.</source>
        <translation>Eine geschlossene Linie ins Bild zeichnen, dann wegschneiden, was hinter ihr liegt, oder alles andere.</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>E&amp;rror map</source>
        <translation>Fehle&amp;rkarte</translation>
    </message>
    <message>
        <source>E&amp;xport measurements...</source>
        <translation>Messungen e&amp;xportieren...</translation>
    </message>
    <message>
        <source>Each pixel shows the highest value along its ray; nothing says how deep it lies.</source>
        <translation>Jedes Pixel zeigt den höchsten Wert entlang seines Strahls; nichts sagt, wie tief er liegt.</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Edit keys</source>
        <translation>Tasten ändern</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>Efficiency: the part of its time that went into samples</source>
        <translation>Effizienz: der Teil seiner Zeit, der in Abtastungen floss</translation>
    </message>
    <message>
        <source>Eight panels as in a photographer's studio: strips behind draw the edges</source>
        <translation>Acht Flächen wie im Fotostudio: Streifen dahinter zeichnen die Kanten</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Ellipse %1</source>
        <translation>Ellipse %1</translation>
    </message>
    <message>
        <source>Encrypted, and each side proves who it is, by the certificates in %1</source>
        <translation>Verschlüsselt, und jede Seite weist sich aus, mit den Zertifikaten in %1</translation>
    </message>
    <message>
        <source>Environment image...</source>
        <translation>Umgebungsbild...</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Fehler gegen Zeit</translation>
    </message>
    <message>
        <source>Error at that point</source>
        <translation>Fehler an dieser Stelle</translation>
    </message>
    <message>
        <source>Error map</source>
        <translation>Fehlerkarte</translation>
    </message>
    <message>
        <source>Error map before denoising</source>
        <translation>Fehlerkarte vor dem Entrauschen</translation>
    </message>
    <message>
        <source>Error of the image</source>
        <translation>Fehler des Bildes</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Wird geschätzt</translation>
    </message>
    <message>
        <source>Estimating how good the image is</source>
        <translation>Die Bildgüte wird geschätzt</translation>
    </message>
    <message>
        <source>Estimating · image still black</source>
        <translation>Wird geschätzt · Bild noch schwarz</translation>
    </message>
    <message>
        <source>Estimating · the error is not known yet</source>
        <translation>Wird geschätzt · der Fehler ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Export it again from the program that made it, from this scan.</source>
        <translation>Exportieren Sie sie noch einmal aus dem Programm, das sie erzeugt hat, von dieser Aufnahme.</translation>
    </message>
    <message>
        <source>Export it again on the grid of the scan; half a voxel is what is missing where voxels are counted from their corners.</source>
        <translation>Exportieren Sie sie noch einmal auf dem Gitter der Aufnahme; ein halbes Voxel fehlt, wo Voxel von ihren Ecken aus gezählt werden.</translation>
    </message>
    <message>
        <source>Export the look</source>
        <translation>Darstellung exportieren</translation>
    </message>
    <message>
        <source>Export the measurements</source>
        <translation>Die Messungen exportieren</translation>
    </message>
    <message>
        <source>Export the scan as DICOM, or anew in this format.</source>
        <translation>Exportieren Sie die Aufnahme als DICOM oder neu in diesem Format.</translation>
    </message>
    <message>
        <source>Export the segmentation anew, without compression.</source>
        <translation>Exportieren Sie die Segmentierung neu, ohne Kompression.</translation>
    </message>
    <message>
        <source>Exposure Render blurs every iteration over 3 x 3 pixels before it counts. That hides noise and never averages out: the image stays wrong. For comparison only.</source>
        <translation>Exposure Render zeichnet jede Iteration über 3 x 3 Pixel weich, bevor sie zählt. Das verbirgt Rauschen und mittelt sich nie heraus: Das Bild bleibt falsch. Nur zum Vergleich.</translation>
    </message>
    <message>
        <source>Exposure Render's schedule %1</source>
        <translation>Ablauf %1 von Exposure Render</translation>
    </message>
    <message>
        <source>Exposure Render's schedule takes whole images only</source>
        <translation>der Ablauf von Exposure Render nimmt nur ganze Bilder</translation>
    </message>
    <message>
        <source>Exposure Render, K0</source>
        <translation>Exposure Render, K0</translation>
    </message>
    <message>
        <source>Exposure Render, K1</source>
        <translation>Exposure Render, K1</translation>
    </message>
    <message>
        <source>Extinction at the top of the opacity curve: larger is denser tissue everywhere</source>
        <translation>Extinktion am höchsten Punkt der Opazitätskurve: größer heißt überall dichteres Gewebe</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Zugewandt</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Kaudal</translation>
    </message>
    <message>
        <source>Fiel&amp;d of view</source>
        <translation>Blick&amp;winkel</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Blickwinkel</translation>
    </message>
    <message>
        <source>Files that were left out</source>
        <translation>Ausgelassene Dateien</translation>
    </message>
    <message>
        <source>Fills the screen with the image, the patient's name and its accuracy.</source>
        <translation>Füllt den Bildschirm mit dem Bild, dem Namen des Patienten und der Genauigkeit.</translation>
    </message>
    <message>
        <source>Find &amp;implants</source>
        <translation>&amp;Implantate finden</translation>
    </message>
    <message>
        <source>Find &amp;vessels</source>
        <translation>&amp;Gefäße finden</translation>
    </message>
    <message>
        <source>Find implants</source>
        <translation>Implantate finden</translation>
    </message>
    <message>
        <source>Find mirrored bone</source>
        <translation>Knochen spiegeln</translation>
    </message>
    <message>
        <source>Find skin and muscle</source>
        <translation>Haut und Muskel finden</translation>
    </message>
    <message>
        <source>Find skin, m&amp;uscle</source>
        <translation>&amp;Haut, Muskel finden</translation>
    </message>
    <message>
        <source>Find vessels</source>
        <translation>Gefäße finden</translation>
    </message>
    <message>
        <source>Finding what is here...</source>
        <translation>Es wird gesucht, was hier liegt...</translation>
    </message>
    <message>
        <source>Finds bone that one side has and the other lacks, such as what closes a defect of the skull.</source>
        <translation>Sucht Knochen, den eine Seite hat und der anderen fehlt, etwa was eine Lücke im Schädel schließt.</translation>
    </message>
    <message>
        <source>Finds implants by the density of metal: a guess, to be checked.</source>
        <translation>Sucht Implantate nach der Dichte von Metall: geraten, zu prüfen.</translation>
    </message>
    <message>
        <source>Finds skin and muscle by density and geometry: a guess, to be checked.</source>
        <translation>Findet Haut und Muskel nach Dichte und Geometrie: eine Vermutung, die zu prüfen ist.</translation>
    </message>
    <message>
        <source>Finds vessels on a scan with contrast medium by density and geometry: a guess, to be checked.</source>
        <translation>Findet Gefäße auf einer Aufnahme mit Kontrastmittel nach Dichte und Geometrie: eine Vermutung, die zu prüfen ist.</translation>
    </message>
    <message>
        <source>Fluoroscopy</source>
        <translation>Durchleuchtung</translation>
    </message>
    <message>
        <source>Focus o&amp;n...</source>
        <translation>Schar&amp;f auf...</translation>
    </message>
    <message>
        <source>Focus on what is clicked</source>
        <translation>Scharf auf die angeklickte Stelle</translation>
    </message>
    <message>
        <source>Folder of &amp;masks...</source>
        <translation>&amp;Maskenordner...</translation>
    </message>
    <message>
        <source>Folders are often called after patients: anyone who uses this account can read the list.</source>
        <translation>Ordner heißen oft nach Patienten: Wer dieses Benutzerkonto nutzt, kann die Liste lesen.</translation>
    </message>
    <message>
        <source>For comparison only: the ways of the renderer that this one replaces.</source>
        <translation>Nur zum Vergleich: die Verfahren des Renderers, den dieser ersetzt.</translation>
    </message>
    <message>
        <source>For screenshots: no patient is named anywhere in the window.</source>
        <translation>Für Bildschirmfotos: Nirgends im Fenster wird ein Patient genannt.</translation>
    </message>
    <message>
        <source>For the image that is being saved. %1</source>
        <translation>Für das Bild, das gerade gespeichert wird. %1</translation>
    </message>
    <message>
        <source>Found by the program: check it.</source>
        <translation>Vom Programm gefunden: bitte prüfen.</translation>
    </message>
    <message>
        <source>Four &amp;views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Frames &amp;per second</source>
        <translation>Bild&amp;rate</translation>
    </message>
    <message>
        <source>Free points</source>
        <translation>Freie Punkte</translation>
    </message>
    <message>
        <source>Free points, or a curve that a few numbers say. It becomes free points when one is moved.</source>
        <translation>Freie Punkte oder eine Kurve aus wenigen Zahlen. Sie wird zu freien Punkten, wenn einer bewegt wird.</translation>
    </message>
    <message>
        <source>Freehan&amp;d cut</source>
        <translation>Fr&amp;eihandschnitt</translation>
    </message>
    <message>
        <source>Freehand cuts: %1</source>
        <translation>Freihandschnitte: %1</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From %1 to %2 %3 over %4 mm.</source>
        <translation>Von %1 bis %2 %3 auf %4 mm.</translation>
    </message>
    <message>
        <source>From a question to its answer [milliseconds]</source>
        <translation>Von einer Frage bis zur Antwort [Millisekunden]</translation>
    </message>
    <message>
        <source>From the &amp;back (P)</source>
        <translation>Von &amp;hinten (P)</translation>
    </message>
    <message>
        <source>From the &amp;front (A)</source>
        <translation>Von &amp;vorne (A)</translation>
    </message>
    <message>
        <source>From the &amp;head (H)</source>
        <translation>Von &amp;kranial (H)</translation>
    </message>
    <message>
        <source>From the &amp;left (L)</source>
        <translation>Von &amp;links (L)</translation>
    </message>
    <message>
        <source>From the &amp;right (R)</source>
        <translation>Von &amp;rechts (R)</translation>
    </message>
    <message>
        <source>From the f&amp;eet (F)</source>
        <translation>Von &amp;kaudal (F)</translation>
    </message>
    <message>
        <source>From the top to the bottom of the image</source>
        <translation>Von der Oberkante bis zur Unterkante des Bildes</translation>
    </message>
    <message>
        <source>From the top to the bottom of the image. What is in focus keeps its size; the wider, the nearer the eye comes</source>
        <translation>Von der Oberkante bis zur Unterkante des Bildes. Was scharf ist, behält seine Größe; je weiter, desto näher kommt das Auge</translation>
    </message>
    <message>
        <source>From the viewer to the right; beyond 90 degrees it stands behind [degrees]. Of the view from the front where the lamps turn with the patient</source>
        <translation>Vom Betrachter nach rechts; über 90 Grad hinaus steht sie dahinter [Grad]. Bezogen auf die Ansicht von vorne, wo sich die Lampen mit dem Patienten drehen</translation>
    </message>
    <message>
        <source>From the volume's middle [radii of the volume]</source>
        <translation>Von der Mitte des Volumens [Radien des Volumens]</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Ghost: %1.</source>
        <translation>Geist: %1.</translation>
    </message>
    <message>
        <source>Give HOST or HOST:PORT, with an IPv6 address in brackets: [::1]:4743.</source>
        <translation>HOST oder HOST:PORT angeben, eine IPv6-Adresse in Klammern: [::1]:4743.</translation>
    </message>
    <message>
        <source>Give a file, no pipe and no device.</source>
        <translation>Eine Datei angeben, keine Pipe und kein Gerät.</translation>
    </message>
    <message>
        <source>Give a file.</source>
        <translation>Eine Datei angeben.</translation>
    </message>
    <message>
        <source>Give one of this machine's IP addresses, or the port alone.</source>
        <translation>Eine IP-Adresse dieses Rechners angeben oder nur den Port.</translation>
    </message>
    <message>
        <source>Give one without a password, which only you may read.</source>
        <translation>Einen ohne Kennwort angeben, den nur Sie lesen dürfen.</translation>
    </message>
    <message>
        <source>Give the folder that --make-certificates has made.</source>
        <translation>Den Ordner angeben, den --make-certificates gemacht hat.</translation>
    </message>
    <message>
        <source>Give the folder that holds the DICOM files.</source>
        <translation>Den Ordner angeben, der die DICOM-Dateien enthält.</translation>
    </message>
    <message>
        <source>Give the part of the bundle named %1.</source>
        <translation>Den Teil des Bündels namens %1 angeben.</translation>
    </message>
    <message>
        <source>Gives the selected parts a colour of their own.</source>
        <translation>Gibt den gewählten Teilen eine eigene Farbe.</translation>
    </message>
    <message>
        <source>Gives the selected parts the curve and the colours of a look.</source>
        <translation>Gibt den gewählten Teilen die Kurve und die Farben eines Looks.</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Glowing tissue</source>
        <translation>Leuchtendes Gewebe</translation>
    </message>
    <message>
        <source>Good for orientation</source>
        <translation>Gut zur Orientierung</translation>
    </message>
    <message>
        <source>Good for planning</source>
        <translation>Gut zur Planung</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HU</translation>
    </message>
    <message>
        <source>Hard bone</source>
        <translation>Harter Knochen</translation>
    </message>
    <message>
        <source>Have it resampled to the nearest voxels, or export it on the grid of the scan.</source>
        <translation>Lassen Sie sie auf die nächsten Voxel umrechnen, oder exportieren Sie sie auf dem Gitter der Aufnahme.</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kranial</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Stirnlampe</translation>
    </message>
    <message>
        <source>Heart and great vessels</source>
        <translation>Herz und große Gefäße</translation>
    </message>
    <message>
        <source>Hei&amp;ght</source>
        <translation>H&amp;öhe</translation>
    </message>
    <message>
        <source>Height of the image [pixels]</source>
        <translation>Höhe des Bildes [Pixel]</translation>
    </message>
    <message>
        <source>Height of what is seen</source>
        <translation>Höhe des Sichtbaren</translation>
    </message>
    <message>
        <source>Hidden: %1.</source>
        <translation>Verborgen: %1.</translation>
    </message>
    <message>
        <source>Hide the patient's &amp;name</source>
        <translation>&amp;Name des Patienten verbergen</translation>
    </message>
    <message>
        <source>Hides the selected parts.</source>
        <translation>Verbirgt die gewählten Teile.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>How far the grey levels on the screen are from those of the finished image, for 95 % of the pixels that show tissue. Four times the samples at least halve it. A denoised image has an error of its own and may lack fine detail: S shows the raw image. Click for details.</source>
        <translation>Wie weit die Graustufen auf dem Bildschirm von denen des fertigen Bildes abweichen, für 95 % der Pixel, die Gewebe zeigen. Viermal so viele Abtastungen halbieren das mindestens. Ein entrauschtes Bild hat einen eigenen Fehler, und feine Einzelheiten können fehlen: S zeigt das rohe Bild. Ein Klick zeigt mehr.</translation>
    </message>
    <message>
        <source>How far the plane is from the middle of the body, towards the side that it cuts away</source>
        <translation>Wie weit die Ebene von der Körpermitte entfernt ist, zu der Seite hin, die sie wegschneidet</translation>
    </message>
    <message>
        <source>How high the first selected point is; the others move with it</source>
        <translation>Wie hoch der erste gewählte Punkt liegt; die anderen bewegen sich mit</translation>
    </message>
    <message>
        <source>How iterations become images. Ours accumulates them and updates the display from time to time. Exposure Render runs all stages for each iteration; K0 also uploads everything each time, K1 does not. For comparison only.</source>
        <translation>Wie aus Iterationen Bilder werden. Unserer summiert sie und zeigt sie ab und zu. Exposure Render durchläuft für jede alle Stufen; K0 lädt außerdem jedes Mal alles neu hoch, K1 nicht. Nur zum Vergleich.</translation>
    </message>
    <message>
        <source>How light paths are sampled. Unbiased: the image converges to the exact one. The march steps over 3 voxels at a time as Exposure Render does and scatters once: the image stays wrong. For comparison only.</source>
        <translation>Wie das Licht verfolgt wird. Erwartungstreu: Das Bild wird das wahre. Die Schritte gehen über je 3 Voxel wie bei Exposure Render und streuen einmal: Das Bild bleibt falsch. Nur zum Vergleich.</translation>
    </message>
    <message>
        <source>How long any target takes without it, in percent of the time with it: an iteration takes another time, and the image has other noise</source>
        <translation>Wie lange ein Ziel ohne ihn dauert, in Prozent der Zeit mit ihm: eine Iteration dauert anders lange, und das Bild rauscht anders</translation>
    </message>
    <message>
        <source>How long it takes</source>
        <translation>Wie lange es dauert</translation>
    </message>
    <message>
        <source>How much is cut off there; also by the handle in the image (C)</source>
        <translation>Wie viel dort abgeschnitten ist; auch mit dem Griff im Bild (C)</translation>
    </message>
    <message>
        <source>How much light the chosen lamp brings; at the left end it is off</source>
        <translation>Wie viel Licht die gewählte Lampe bringt; ganz links ist sie aus</translation>
    </message>
    <message>
        <source>How nodes share the work</source>
        <translation>Wie sich Render-Rechner die Arbeit teilen</translation>
    </message>
    <message>
        <source>How the work is split</source>
        <translation>Wie die Arbeit verteilt ist</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Image error ±%1 of 255 grey levels (95 % of the tissue)</source>
        <translation>Bildfehler ±%1 von 255 Graustufen (95 % des Gewebes)</translation>
    </message>
    <message>
        <source>Image error ±%1 of 255 grey levels before denoising (95 % of the tissue)</source>
        <translation>Bildfehler ±%1 von 255 Graustufen vor dem Entrauschen (95 % des Gewebes)</translation>
    </message>
    <message>
        <source>Implant over ghost bone</source>
        <translation>Implantat über Geisterknochen</translation>
    </message>
    <message>
        <source>Implants</source>
        <translation>Implantate</translation>
    </message>
    <message>
        <source>Import a look</source>
        <translation>Darstellung importieren</translation>
    </message>
    <message>
        <source>Import a part of the series, close programs that use the device, or render on the CPU.</source>
        <translation>Einen Teil der Serie laden, Programme schließen, die das Gerät benutzen, oder auf der CPU rechnen.</translation>
    </message>
    <message>
        <source>In front: %1 % of the light</source>
        <translation>Vorn: %1 % des Lichts</translation>
    </message>
    <message>
        <source>In the region: %1</source>
        <translation>Im Bereich: %1</translation>
    </message>
    <message>
        <source>Install a newer driver, or a build of this program for this GPU; until then only the CPU can render.</source>
        <translation>Einen neueren Treiber oder eine für diese GPU gebaute Fassung des Programms installieren; bis dahin kann nur die CPU rechnen.</translation>
    </message>
    <message>
        <source>Install a newer driver; until then only the CPU can render.</source>
        <translation>Einen neueren Treiber installieren; bis dahin kann nur die CPU rechnen.</translation>
    </message>
    <message>
        <source>Install libdcmtk17 again.</source>
        <translation>libdcmtk17 neu installieren.</translation>
    </message>
    <message>
        <source>Install one, or render on the CPU.</source>
        <translation>Einen installieren oder auf der CPU rechnen.</translation>
    </message>
    <message>
        <source>Invalid samples</source>
        <translation>Ungültige Abtastungen</translation>
    </message>
    <message>
        <source>Is the disk full, or the folder write-protected?</source>
        <translation>Ist die Platte voll oder der Ordner schreibgeschützt?</translation>
    </message>
    <message>
        <source>It is rendered on this machine alone.</source>
        <translation>Sie wird nur auf diesem Rechner gerechnet.</translation>
    </message>
    <message>
        <source>It may be of another scan or patient: choose the series that it was made on.</source>
        <translation>Sie kann von einer anderen Aufnahme oder einem anderen Patienten sein: wählen Sie die Serie, auf der sie erzeugt wurde.</translation>
    </message>
    <message>
        <source>It needs R, G and B, or Y.</source>
        <translation>Es braucht R, G und B, oder Y.</translation>
    </message>
    <message>
        <source>It reaches where slices were not measured: they are interpolated, and the ± does not know what lies between.</source>
        <translation>Sie reicht dorthin, wo keine Schichten gemessen wurden: Sie sind interpoliert, und das ± weiß nicht, was dazwischen liegt.</translation>
    </message>
    <message>
        <source>It was refused, or the device failed before.</source>
        <translation>Sie wurde abgelehnt, oder das Gerät hat vorher versagt.</translation>
    </message>
    <message>
        <source>It was seen through translucent tissue. Drag it to where it belongs on a slice.</source>
        <translation>Er wurde durch durchscheinendes Gewebe hindurch gesehen. Ziehen Sie ihn auf einer Schicht dorthin, wo er hingehört.</translation>
    </message>
    <message>
        <source>Iterations computed before the image is updated. More is slightly faster, fewer responds sooner; the result is the same.</source>
        <translation>Wie viele Iterationen berechnet werden, bevor das Bild neu gezeigt wird. Mehr ist etwas schneller, weniger ist lebendiger; das Ergebnis ist dasselbe.</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>Iterationen je Bild</translation>
    </message>
    <message>
        <source>Iterations/s</source>
        <translation>Iterationen/s</translation>
    </message>
    <message>
        <source>Its name and where it is reached</source>
        <translation>Wie er heißt und wo er erreicht wird</translation>
    </message>
    <message>
        <source>JPEG lossless</source>
        <translation>JPEG verlustfrei</translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Alles behalten</translation>
    </message>
    <message>
        <source>Keep inside</source>
        <translation>Inneres behalten</translation>
    </message>
    <message>
        <source>Keep only the tissue inside the outline (K)</source>
        <translation>Nur das Gewebe in der Linie behalten (K)</translation>
    </message>
    <message>
        <source>Key of the chosen action</source>
        <translation>Taste des gewählten Befehls</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Known here: %1.</source>
        <translation>Hier bekannt: %1.</translation>
    </message>
    <message>
        <source>Known parts: %1.</source>
        <translation>Bekannte Teile: %1.</translation>
    </message>
    <message>
        <source>L&amp;ook of the part</source>
        <translation>L&amp;ook des Teils</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Label maps (*.nii *.nii.gz *.nrrd *.mha *.mhd *.dcm)</source>
        <translation>Labelkarten (*.nii *.nii.gz *.nrrd *.mha *.mhd *.dcm)</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Lamp %1</source>
        <translation>Lampe %1</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>Large soft light</source>
        <translation>Großes weiches Licht</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Lay it onto the grid of this scan.</source>
        <translation>Legen Sie sie auf das Gitter dieser Aufnahme.</translation>
    </message>
    <message>
        <source>Leave it; the tile is rendered again.</source>
        <translation>So lassen; die Kachel wird noch einmal gerechnet.</translation>
    </message>
    <message>
        <source>Leave one of the two out.</source>
        <translation>Eines von beiden weglassen.</translation>
    </message>
    <message>
        <source>Leave one of them out.</source>
        <translation>Einen davon weglassen.</translation>
    </message>
    <message>
        <source>Leave out nodes that lie on a line between their neighbours.</source>
        <translation>Stützstellen weglassen, die auf einer Linie zwischen ihren Nachbarn liegen.</translation>
    </message>
    <message>
        <source>Leaving</source>
        <translation>Verabschiedet sich</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left drag, arrow keys</source>
        <translation>Ziehen mit links, Pfeiltasten</translation>
    </message>
    <message>
        <source>Left, Right on the strip</source>
        <translation>Links, Rechts auf dem Streifen</translation>
    </message>
    <message>
        <source>Length of its edge [radii of the volume]</source>
        <translation>Länge ihrer Kante [Radien des Volumens]</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Light from a panorama of a sky or a room: an OpenEXR file, twice as wide as high</source>
        <translation>Licht von allen Seiten nach dem Bild eines Himmels oder Raumes: eine OpenEXR-Datei, doppelt so breit wie hoch</translation>
    </message>
    <message>
        <source>Light from all around, most from the head's side, and a sun</source>
        <translation>Licht von allen Seiten, am meisten von kranial, und eine Sonne</translation>
    </message>
    <message>
        <source>Light from an environment image</source>
        <translation>Licht aus einem Umgebungsbild</translation>
    </message>
    <message>
        <source>Light is scattered on and on: soft, with light in the shadows.</source>
        <translation>Licht wird immer wieder gestreut: weich, mit Licht in den Schatten.</translation>
    </message>
    <message>
        <source>Light is scattered once: crisp surfaces and dark shadows.</source>
        <translation>Licht wird einmal gestreut: klare Oberflächen und dunkle Schatten.</translation>
    </message>
    <message>
        <source>Limit reached first</source>
        <translation>Welche Grenze zuerst kommt</translation>
    </message>
    <message>
        <source>Listen on port</source>
        <translation>Am Port lauschen</translation>
    </message>
    <message>
        <source>Lit surfaces</source>
        <translation>Beleuchtete Oberflächen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Logarithmic histogram</source>
        <translation>Logarithmisches Histogramm</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Darstellung %1</translation>
    </message>
    <message>
        <source>Look (*.json)</source>
        <translation>Darstellung (*.json)</translation>
    </message>
    <message>
        <source>Look: %1</source>
        <translation>Look: %1</translation>
    </message>
    <message>
        <source>Looks cannot hold an environment image: this one has uniform ambient light.</source>
        <translation>In Looks passt kein Umgebungsbild: dieser hat gleichmäßiges Umgebungslicht.</translation>
    </message>
    <message>
        <source>Looks, also of 3D Slicer (*.json *.vp)</source>
        <translation>Darstellungen, auch von 3D Slicer (*.json *.vp)</translation>
    </message>
    <message>
        <source>Looks: %1</source>
        <translation>Darstellungen: %1</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Lung vessels</source>
        <translation>Lungengefäße</translation>
    </message>
    <message>
        <source>Lungs</source>
        <translation>Lungen</translation>
    </message>
    <message>
        <source>M&amp;oves with</source>
        <translation>Bewegt sich &amp;mit</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MIP of the lungs</source>
        <translation>MIP der Lungen</translation>
    </message>
    <message>
        <source>Make it of this volume.</source>
        <translation>Für dieses Volumen machen.</translation>
    </message>
    <message>
        <source>Make it smaller.</source>
        <translation>Es kleiner machen.</translation>
    </message>
    <message>
        <source>Make it yours alone: chmod 600.</source>
        <translation>Ihn nur sich selbst zugänglich machen: chmod 600.</translation>
    </message>
    <message>
        <source>Make new ones with --make-certificates, for the coordinator and all nodes.</source>
        <translation>Mit --make-certificates neue machen, für Koordinator und alle Render-Rechner.</translation>
    </message>
    <message>
        <source>Make room there, or choose another place.</source>
        <translation>Dort Platz schaffen oder einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Make some with "pdrender-node --make-certificates FOLDER", and give them to both sides: --bundle, or the window's Certificates.</source>
        <translation>Mit „pdrender-node --make-certificates ORDNER“ welche machen und beiden Seiten geben: --bundle, oder „Zertifikate“ im Fenster.</translation>
    </message>
    <message>
        <source>Make the image smaller, close programs that use the device, or choose another device.</source>
        <translation>Das Bild kleiner machen, Programme schließen, die das Gerät benutzen, oder ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>Manual of PD-Render</source>
        <translation>Handbuch von PD-Render</translation>
    </message>
    <message>
        <source>March of 3 voxels (biased)</source>
        <translation>Schritte von 3 Voxeln (verzerrt)</translation>
    </message>
    <message>
        <source>Markups of 3D Slicer (*.mrk.json)</source>
        <translation>Markierungen für 3D Slicer (*.mrk.json)</translation>
    </message>
    <message>
        <source>Maximum intensity</source>
        <translation>Maximale Intensität</translation>
    </message>
    <message>
        <source>Mean %1.</source>
        <translation>Mittelwert %1.</translation>
    </message>
    <message>
        <source>Mean in a ball</source>
        <translation>Mittelwert in einer Kugel</translation>
    </message>
    <message>
        <source>Mean in an ellipse</source>
        <translation>Mittelwert in einer Ellipse</translation>
    </message>
    <message>
        <source>Measure at least 5 sizes with 3 numbers of iterations.</source>
        <translation>Mindestens 5 Größen mit 3 Anzahlen von Durchgängen messen.</translation>
    </message>
    <message>
        <source>Measure for longer.</source>
        <translation>Länger messen.</translation>
    </message>
    <message>
        <source>Measure more sizes and more numbers of iterations.</source>
        <translation>Mehr Größen und mehr Anzahlen von Durchgängen messen.</translation>
    </message>
    <message>
        <source>Measured %1, %2 s of calibration</source>
        <translation>%1 gemessen, %2 s Eichung</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Measurements are not saved. Discard them?</source>
        <translation>Messungen sind nicht gespeichert. Verwerfen?</translation>
    </message>
    <message>
        <source>Measurements exported as %1</source>
        <translation>Messungen exportiert als %1</translation>
    </message>
    <message>
        <source>Measuring %1 from time to time, in 1/20 of the time</source>
        <translation>%1 wird gemessen, ab und zu, in einem Zwanzigstel der Zeit</translation>
    </message>
    <message>
        <source>Measuring begins when the image is at rest</source>
        <translation>Es wird gemessen, sobald das Bild ruht</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Metal outside the body is kept, with what it touches: %1.</source>
        <translation>Metall außerhalb des Körpers bleibt, mit allem, was es berührt: %1.</translation>
    </message>
    <message>
        <source>Middle or Shift+left drag</source>
        <translation>Ziehen mit Mitte oder Umschalt+links</translation>
    </message>
    <message>
        <source>Minimum frames per second, where the device can reach it.</source>
        <translation>Wie viele Bilder je Sekunde mindestens gezeigt werden, soweit das Gerät es kann.</translation>
    </message>
    <message>
        <source>Mirrored &amp;bone</source>
        <translation>&amp;Knochen spiegeln</translation>
    </message>
    <message>
        <source>More about the image</source>
        <translation>Mehr über das Bild</translation>
    </message>
    <message>
        <source>Most used</source>
        <translation>Häufig gebraucht</translation>
    </message>
    <message>
        <source>Mouse at rest</source>
        <translation>Ruhende Maus</translation>
    </message>
    <message>
        <source>Move an end of one of them.</source>
        <translation>Verschieben Sie ein Ende einer der beiden.</translation>
    </message>
    <message>
        <source>Move it into the scan.</source>
        <translation>Es in die Aufnahme hinein verschieben.</translation>
    </message>
    <message>
        <source>Move it, or make it larger.</source>
        <translation>Ihn verschieben oder größer machen.</translation>
    </message>
    <message>
        <source>Move its corners.</source>
        <translation>Verschieben Sie seine Ecken.</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Muscle is hardly shown. The patient can be recognised.</source>
        <translation>Muskel ist kaum zu sehen. Der Patient ist erkennbar.</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Muskeln</translation>
    </message>
    <message>
        <source>Muscles and skull</source>
        <translation>Muskeln und Schädel</translation>
    </message>
    <message>
        <source>My looks</source>
        <translation>Eigene Darstellungen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name each node once.</source>
        <translation>Jeden Render-Rechner einmal nennen.</translation>
    </message>
    <message>
        <source>Name not given</source>
        <translation>Name nicht angegeben</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Next control</source>
        <translation>Nächstes Bedienelement</translation>
    </message>
    <message>
        <source>No image</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>No known systematic error</source>
        <translation>Kein systematischer Fehler bekannt</translation>
    </message>
    <message>
        <source>No page has all of these words.</source>
        <translation>Keine Seite enthält alle diese Wörter.</translation>
    </message>
    <message>
        <source>No render nodes: other machines can render along, and the image becomes right sooner</source>
        <translation>Keine Render-Rechner: Andere Rechner können mitrechnen, dann wird das Bild eher richtig</translation>
    </message>
    <message>
        <source>No sample was left out</source>
        <translation>Keine Abtastung wurde ausgelassen</translation>
    </message>
    <message>
        <source>No series here can be shown. The list says why.</source>
        <translation>Keine Serie hier kann gezeigt werden. Die Liste sagt, warum.</translation>
    </message>
    <message>
        <source>No table was hidden, because %1.</source>
        <translation>Kein Tisch wurde ausgeblendet, denn %1.</translation>
    </message>
    <message>
        <source>No tissue is in view</source>
        <translation>Kein Gewebe im Bild</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Not for diagnostic use</source>
        <translation>Nicht für die Diagnose</translation>
    </message>
    <message>
        <source>Not for this scan</source>
        <translation>Nicht für diese Aufnahme</translation>
    </message>
    <message>
        <source>Not in it: the scanner's own scale, movement, what was meant.</source>
        <translation>Nicht darin: der Maßstab des Scanners, Bewegung, was gemeint war.</translation>
    </message>
    <message>
        <source>Not measured any further: %1</source>
        <translation>Nicht weiter gemessen: %1</translation>
    </message>
    <message>
        <source>Not offered: %1.</source>
        <translation>Nicht angeboten: %1.</translation>
    </message>
    <message>
        <source>Of 255 grey levels, by how many the image changes without it, on average over what it shows; to 95 % it lies between the two faint numbers</source>
        <translation>Um wie viele von 255 Graustufen sich das Bild ohne ihn ändert, im Mittel über das Gezeigte; zu 95 % liegt der Wert zwischen den beiden blassen Zahlen</translation>
    </message>
    <message>
        <source>Of the image's samples, that it took: what it adds to the error curve</source>
        <translation>An den Abtastungen des Bildes: was er zur Fehlerkurve beiträgt</translation>
    </message>
    <message>
        <source>Of the whole image, that its samples come to</source>
        <translation>Des ganzen Bildes, die seine Abtastungen ergeben</translation>
    </message>
    <message>
        <source>Off, without any loss: %1</source>
        <translation>Aus, und nichts geht verloren: %1</translation>
    </message>
    <message>
        <source>Offers the windows in which slices are shown: bone, lung, brain and others.</source>
        <translation>Bietet die Fenster an, in denen Schichten gezeigt werden: Knochen, Lunge, Gehirn und andere.</translation>
    </message>
    <message>
        <source>On their other side %1.</source>
        <translation>Auf ihrer anderen Seite %1.</translation>
    </message>
    <message>
        <source>One large panel: soft shadows</source>
        <translation>Eine große Fläche: weiche Schatten</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>Nur %1</translation>
    </message>
    <message>
        <source>Only %1 are shown.</source>
        <translation>Nur %1 werden gezeigt.</translation>
    </message>
    <message>
        <source>Only %1 without %2</source>
        <translation>Nur %1 ohne %2</translation>
    </message>
    <message>
        <source>Only bones are shown, as far as they hold dense bone.</source>
        <translation>Nur Knochen sind zu sehen, soweit sie dichten Knochen enthalten.</translation>
    </message>
    <message>
        <source>Only the CPU or a newer GPU can render.</source>
        <translation>Nur die CPU oder eine neuere GPU kann rechnen.</translation>
    </message>
    <message>
        <source>Only the first of the dropped folders is opened.</source>
        <translation>Nur der erste der abgelegten Ordner wird geöffnet.</translation>
    </message>
    <message>
        <source>Only the lungs are shown; %1 mm at the pleura are missing.</source>
        <translation>Nur die Lungen sind zu sehen; %1 mm am Rippenfell fehlen.</translation>
    </message>
    <message>
        <source>Only what a label map marks is shown, in its colours; a part ends where its labels end.</source>
        <translation>Nur was eine Labelkarte markiert, wird gezeigt, in deren Farben; ein Teil endet, wo seine Labels enden.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opazität</translation>
    </message>
    <message>
        <source>Opacity: how much light is taken from a ray, per mm
Reflection: of a surface, seen straight on
Roughness: 0 is a mirror, 1 is dull
Glow: light that the tissue gives off itself</source>
        <translation>Opazität: wie viel Licht einem Strahl je mm genommen wird
Reflexion: einer senkrecht gesehenen Oberfläche
Rauheit: 0 ist ein Spiegel, 1 ist matt
Leuchten: Licht, das das Gewebe selbst abgibt</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open &amp;label map...</source>
        <translation>&amp;Labelkarte öffnen...</translation>
    </message>
    <message>
        <source>Open &amp;plan...</source>
        <translation>&amp;Plan öffnen...</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a CT scan for that.</source>
        <translation>Öffnen Sie dafür eine CT-Aufnahme.</translation>
    </message>
    <message>
        <source>Open a folder</source>
        <translation>Einen Ordner öffnen</translation>
    </message>
    <message>
        <source>Open a folder with a CT</source>
        <translation>Einen Ordner mit einem CT öffnen</translation>
    </message>
    <message>
        <source>Open a folder with a CT series.</source>
        <translation>Einen Ordner mit einer CT-Serie öffnen.</translation>
    </message>
    <message>
        <source>Open a folder with a mask of each part</source>
        <translation>Einen Ordner mit einer Maske je Teil öffnen</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>Eine Labelkarte öffnen</translation>
    </message>
    <message>
        <source>Open a plan</source>
        <translation>Einen Plan öffnen</translation>
    </message>
    <message>
        <source>Open a scan in one file</source>
        <translation>Eine Aufnahme in einer Datei öffnen</translation>
    </message>
    <message>
        <source>Open f&amp;ile...</source>
        <translation>Date&amp;i öffnen...</translation>
    </message>
    <message>
        <source>Open label map...</source>
        <translation>Labelkarte öffnen...</translation>
    </message>
    <message>
        <source>Open the e&amp;xample</source>
        <translation>Beis&amp;piel öffnen</translation>
    </message>
    <message>
        <source>Open the example</source>
        <translation>Das Beispiel öffnen</translation>
    </message>
    <message>
        <source>Open the folder again.</source>
        <translation>Den Ordner noch einmal öffnen.</translation>
    </message>
    <message>
        <source>Open the folder again: it may hold another patient's images now.</source>
        <translation>Den Ordner neu öffnen: Er kann jetzt Bilder eines anderen Patienten enthalten.</translation>
    </message>
    <message>
        <source>Open the folder of the scan first, then drop the plan again.</source>
        <translation>Öffnen Sie zuerst den Ordner der Aufnahme und legen Sie den Plan dann noch einmal ab.</translation>
    </message>
    <message>
        <source>Open the series again, or restart the program.</source>
        <translation>Die Serie noch einmal öffnen oder das Programm neu starten.</translation>
    </message>
    <message>
        <source>Open the series again.</source>
        <translation>Die Serie noch einmal öffnen.</translation>
    </message>
    <message>
        <source>Open the series on which the plan was made.</source>
        <translation>Öffnen Sie die Serie, auf der der Plan entstand.</translation>
    </message>
    <message>
        <source>OpenEXR with the error of every pixel (*.exr)</source>
        <translation>OpenEXR mit dem Fehler jedes Pixels (*.exr)</translation>
    </message>
    <message>
        <source>Opens a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage.</source>
        <translation>Öffnet ein ZIP-Archiv mit DICOM- oder Volumendateien oder ein einzelnes Volumen: NIfTI, NRRD oder MetaImage.</translation>
    </message>
    <message>
        <source>Opens a folder of DICOM files.</source>
        <translation>Öffnet einen Ordner mit DICOM-Dateien.</translation>
    </message>
    <message>
        <source>Opens a folder with a file of this kind for each part.</source>
        <translation>Öffnet einen Ordner mit einer solchen Datei je Teil.</translation>
    </message>
    <message>
        <source>Opens parts that another program has marked on this scan: NIfTI, NRRD, MetaImage or a DICOM segmentation.</source>
        <translation>Öffnet Teile, die ein anderes Programm auf dieser Aufnahme markiert hat: NIfTI, NRRD, MetaImage oder eine DICOM-Segmentierung.</translation>
    </message>
    <message>
        <source>Opens the manual, which needs no network.</source>
        <translation>Öffnet das Handbuch (auf Englisch); es braucht kein Netz.</translation>
    </message>
    <message>
        <source>Opens what was set and measured on this scan before.</source>
        <translation>Öffnet, was an dieser Aufnahme früher eingestellt und gemessen wurde.</translation>
    </message>
    <message>
        <source>Operating lamp</source>
        <translation>Operationsleuchte</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Organs in colour</source>
        <translation>Organe in Farbe</translation>
    </message>
    <message>
        <source>Ours</source>
        <translation>Unserer</translation>
    </message>
    <message>
        <source>PD-Render</source>
        <translation>PD-Render</translation>
    </message>
    <message>
        <source>PD-Render - Not for diagnostic use</source>
        <translation>PD-Render - Nicht für die Diagnose</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>Panels of light</source>
        <translation>Leuchtflächen</translation>
    </message>
    <message>
        <source>Panels of one name are one lamp: they are moved and dimmed together</source>
        <translation>Flächen eines Namens sind eine Lampe: Sie werden zusammen bewegt und gedimmt</translation>
    </message>
    <message>
        <source>Panorama, twice as wide as high (*.exr)</source>
        <translation>Panorama, doppelt so breit wie hoch (*.exr)</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Part that is shown</source>
        <translation>Gezeigter Teil</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Parts of the scan</source>
        <translation>Teile der Aufnahme</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Patient %1 (name hidden)</source>
        <translation>Patient %1 (Name verborgen)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause or continue rendering (Space)</source>
        <translation>Die Berechnung anhalten oder fortsetzen (Leertaste)</translation>
    </message>
    <message>
        <source>Pause or resume the selected nodes (Space)</source>
        <translation>Die gewählten Rechner anhalten oder fortsetzen (Leertaste)</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pausiert</translation>
    </message>
    <message>
        <source>Paused on battery (Space: continue)</source>
        <translation>Pause im Akkubetrieb (Leertaste: weiter)</translation>
    </message>
    <message>
        <source>Pauses rendering, or continues it, also beyond the target.</source>
        <translation>Hält die Berechnung an oder setzt sie fort, auch über das Ziel hinaus.</translation>
    </message>
    <message>
        <source>Peeled %1 mm: skin and what lies less deep is not shown.</source>
        <translation>%1 mm abgeschält: Haut und was weniger tief liegt, ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>Percentiles</source>
        <translation>Perzentile</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Perspective: what is near is larger, as for the eye
Parallel: the same size at every depth, as for measuring</source>
        <translation>Perspektive: Was nah ist, ist größer, wie für das Auge
Parallel: gleich groß in jeder Tiefe, wie zum Messen</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Place of the selected point</source>
        <translation>Ort des gewählten Punktes</translation>
    </message>
    <message>
        <source>Places of the lamps</source>
        <translation>Orte der Lampen</translation>
    </message>
    <message>
        <source>Plan saved as %1</source>
        <translation>Plan gespeichert als %1</translation>
    </message>
    <message>
        <source>Plan saved as %1, without its environment image</source>
        <translation>Plan gespeichert als %1, ohne sein Umgebungsbild</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Plans (*.plan.json *.json)</source>
        <translation>Pläne (*.plan.json *.json)</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Polygon %1</source>
        <translation>Vieleck %1</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Ports are numbers from 1 to 65535.</source>
        <translation>Ports sind Zahlen von 1 bis 65535.</translation>
    </message>
    <message>
        <source>Preparing %1...</source>
        <translation>%1 wird vorbereitet ...</translation>
    </message>
    <message>
        <source>Preparing the GPU...</source>
        <translation>Die GPU wird vorbereitet ...</translation>
    </message>
    <message>
        <source>Preview, not converged · denoised, image error ±%1 of 255 grey levels (95 % of the tissue), target ±%2</source>
        <translation>Vorschau, nicht fertig · entrauscht, Bildfehler ±%1 von 255 Graustufen (95 % des Gewebes), Ziel ±%2</translation>
    </message>
    <message>
        <source>Preview, not converged · error not known yet</source>
        <translation>Vorschau, nicht fertig · Fehler noch nicht bekannt</translation>
    </message>
    <message>
        <source>Preview, not converged · image error ±%1 of 255 grey levels (95 % of the tissue), target ±%2</source>
        <translation>Vorschau, nicht fertig · Bildfehler ±%1 von 255 Graustufen (95 % des Gewebes), Ziel ±%2</translation>
    </message>
    <message>
        <source>Preview, not converged · image error ±%1 of 255 grey levels before denoising (95 % of the tissue), target ±%2</source>
        <translation>Vorschau, nicht fertig · Bildfehler ±%1 von 255 Graustufen vor dem Entrauschen (95 % des Gewebes), Ziel ±%2</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>Pro&amp;jektion</translation>
    </message>
    <message>
        <source>Processor time that an iteration of the small image takes more with it: median, and the smallest to the largest of six measurements</source>
        <translation>Prozessorzeit, die eine Iteration des kleinen Bildes damit mehr braucht: Median und der kleinste bis größte von sechs Messwerten</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Put both files into one folder.</source>
        <translation>Legen Sie beide Dateien in einen Ordner.</translation>
    </message>
    <message>
        <source>Put its ends farther apart.</source>
        <translation>Setzen Sie ihre Enden weiter auseinander.</translation>
    </message>
    <message>
        <source>R&amp;eset view</source>
        <translation>Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Radiance</source>
        <translation>Strahldichte</translation>
    </message>
    <message>
        <source>Radiance, in the units of the exposure</source>
        <translation>Strahldichte, in den Einheiten der Belichtung</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>Recent plans</source>
        <translation>Letzte Pläne</translation>
    </message>
    <message>
        <source>Recently opened</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo adding parts</source>
        <translation>Hinzufügen von Teilen wiederholen</translation>
    </message>
    <message>
        <source>Redo changing a measurement</source>
        <translation>Wiederholen: Messung ändern</translation>
    </message>
    <message>
        <source>Redo changing how a part is shown</source>
        <translation>Darstellung eines Teils wiederholen</translation>
    </message>
    <message>
        <source>Redo changing the background</source>
        <translation>Wiederholen: Hintergrund ändern</translation>
    </message>
    <message>
        <source>Redo changing the brightness</source>
        <translation>Wiederholen: Helligkeit ändern</translation>
    </message>
    <message>
        <source>Redo changing the layout</source>
        <translation>Wiederholen: Anordnung ändern</translation>
    </message>
    <message>
        <source>Redo changing the lens</source>
        <translation>Wiederholen: Linse ändern</translation>
    </message>
    <message>
        <source>Redo changing the light</source>
        <translation>Wiederholen: Licht ändern</translation>
    </message>
    <message>
        <source>Redo changing the rendering</source>
        <translation>Wiederholen: Berechnung ändern</translation>
    </message>
    <message>
        <source>Redo changing the window</source>
        <translation>Wiederholen: Fenster ändern</translation>
    </message>
    <message>
        <source>Redo choosing a look</source>
        <translation>Wiederholen: Darstellung wählen</translation>
    </message>
    <message>
        <source>Redo choosing an optical model</source>
        <translation>Wiederholen: Optisches Modell wählen</translation>
    </message>
    <message>
        <source>Redo choosing the visible part</source>
        <translation>Wiederholen: Sichtbares wählen</translation>
    </message>
    <message>
        <source>Redo cutting</source>
        <translation>Wiederholen: Schneiden</translation>
    </message>
    <message>
        <source>Redo editing the tissue</source>
        <translation>Wiederholen: Gewebe bearbeiten</translation>
    </message>
    <message>
        <source>Redo hiding the table</source>
        <translation>Wiederholen: Tisch ausblenden</translation>
    </message>
    <message>
        <source>Redo marking a place</source>
        <translation>Wiederholen: Punkt markieren</translation>
    </message>
    <message>
        <source>Redo measuring</source>
        <translation>Wiederholen: Messen</translation>
    </message>
    <message>
        <source>Redo moving the view</source>
        <translation>Wiederholen: Ansicht verschieben</translation>
    </message>
    <message>
        <source>Redo moving through the slices</source>
        <translation>Wiederholen: durch die Schichten bewegen</translation>
    </message>
    <message>
        <source>Redo naming a measurement</source>
        <translation>Wiederholen: Messung benennen</translation>
    </message>
    <message>
        <source>Redo removing a measurement</source>
        <translation>Wiederholen: Messung entfernen</translation>
    </message>
    <message>
        <source>Redo removing parts</source>
        <translation>Entfernen der Teile wiederholen</translation>
    </message>
    <message>
        <source>Redo several changes</source>
        <translation>Wiederholen: mehrere Änderungen</translation>
    </message>
    <message>
        <source>Redo showing the table</source>
        <translation>Wiederholen: Tisch zeigen</translation>
    </message>
    <message>
        <source>Redo switching CT denoising</source>
        <translation>Wiederholen: Entrauschen der CT umschalten</translation>
    </message>
    <message>
        <source>Redo turning the view</source>
        <translation>Wiederholen: Ansicht drehen</translation>
    </message>
    <message>
        <source>Redo zooming</source>
        <translation>Wiederholen: Zoomen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Refine a &amp;region</source>
        <translation>&amp;Bereich zuerst</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgewiesen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove all &amp;parts</source>
        <translation>Alle &amp;Teile entfernen</translation>
    </message>
    <message>
        <source>Remove all c&amp;uts</source>
        <translation>Alle Schnitte au&amp;fheben</translation>
    </message>
    <message>
        <source>Remove image</source>
        <translation>Bild entfernen</translation>
    </message>
    <message>
        <source>Remove inside</source>
        <translation>Inneres entfernen</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Eines davon entfernen.</translation>
    </message>
    <message>
        <source>Remove some of them.</source>
        <translation>Einige davon entfernen.</translation>
    </message>
    <message>
        <source>Remove the last freehand cut</source>
        <translation>Den letzten Freihandschnitt entfernen</translation>
    </message>
    <message>
        <source>Remove the last one</source>
        <translation>Letzten entfernen</translation>
    </message>
    <message>
        <source>Remove the plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Remove the plane (double click on its handle)</source>
        <translation>Die Ebene entfernen (Doppelklick auf ihren Griff)</translation>
    </message>
    <message>
        <source>Remove the selected points</source>
        <translation>Gewählte Punkte entfernen</translation>
    </message>
    <message>
        <source>Remove the selected points (Del)</source>
        <translation>Gewählte Punkte entfernen (Entf)</translation>
    </message>
    <message>
        <source>Remove the tissue inside the outline (Del)</source>
        <translation>Das Gewebe in der Linie entfernen (Entf)</translation>
    </message>
    <message>
        <source>Removed tissue casts &amp;shadows</source>
        <translation>Entferntes Ge&amp;webe wirft Schatten</translation>
    </message>
    <message>
        <source>Removes all cuts; this can be undone.</source>
        <translation>Zeigt alles Weggeschnittene wieder; ein Schritt zum Rückgängigmachen.</translation>
    </message>
    <message>
        <source>Removes the selected measurement (Delete).</source>
        <translation>Entfernt die gewählte Messung (Entf).</translation>
    </message>
    <message>
        <source>Rename the look</source>
        <translation>Darstellung umbenennen</translation>
    </message>
    <message>
        <source>Render at the window's si&amp;ze</source>
        <translation>In &amp;Größe des Fensters rendern</translation>
    </message>
    <message>
        <source>Render cost by effect</source>
        <translation>Rechenzeit je Effekt</translation>
    </message>
    <message>
        <source>Render everything that render nodes send a second time, on another one or on this machine, before it is used: twice the work, and no false sample gets into the image</source>
        <translation>Alles, was andere Rechner senden, ein zweites Mal berechnen, auf einem anderen oder auf diesem, bevor es verwendet wird: doppelte Arbeit, und kein falscher Wert gelangt ins Bild</translation>
    </message>
    <message>
        <source>Render node</source>
        <translation>Render-Rechner</translation>
    </message>
    <message>
        <source>Render nodes</source>
        <translation>Render-Rechner</translation>
    </message>
    <message>
        <source>Render nodes may dial in: "pdrender-node --coordinator" with this machine's name and this port.</source>
        <translation>Render-Rechner dürfen sich melden: „pdrender-node --coordinator“ mit dem Namen dieses Rechners und diesem Port.</translation>
    </message>
    <message>
        <source>Render on the CPU, or build it where the CUDA Toolkit is.</source>
        <translation>Auf der CPU rechnen oder dort bauen, wo das CUDA-Toolkit ist.</translation>
    </message>
    <message>
        <source>Render on the CPU.</source>
        <translation>Auf der CPU rechnen.</translation>
    </message>
    <message>
        <source>Rendered at %1</source>
        <translation>Neu gerechnet, %1</translation>
    </message>
    <message>
        <source>Rendered at another size</source>
        <translation>Neu gerechnet, andere Größe</translation>
    </message>
    <message>
        <source>Rendered on</source>
        <translation>Gerechnet auf</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>Rendering cannot continue elsewhere: %1</source>
        <translation>Auch anderswo kann das Bild nicht weiterlaufen: %1</translation>
    </message>
    <message>
        <source>Rendering continues on %1.</source>
        <translation>Weitergerechnet wird auf: %1.</translation>
    </message>
    <message>
        <source>Rendering stops at %1. Drag left to stop sooner, right for a more accurate image.</source>
        <translation>Das Rechnen hält bei %1 an. Nach links ziehen: früher; nach rechts: genauer.</translation>
    </message>
    <message>
        <source>Renders the image again at the size at which it is shown; the next edit does so as well.</source>
        <translation>Beginnt das Bild neu mit so vielen Pixeln, wie es gezeigt wird; die nächste Änderung tut es ebenso.</translation>
    </message>
    <message>
        <source>Resample</source>
        <translation>Umrechnen</translation>
    </message>
    <message>
        <source>Resample it first.</source>
        <translation>Erst umrechnen.</translation>
    </message>
    <message>
        <source>Reset the view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Rest of the body</source>
        <translation>Übriger Körper</translation>
    </message>
    <message>
        <source>Restart the computer to use the GPU; if it happens again, have the GPU replaced.</source>
        <translation>Den Computer neu starten, um die GPU zu benutzen; geschieht es wieder, die GPU austauschen lassen.</translation>
    </message>
    <message>
        <source>Restart the computer; until then only the CPU can render.</source>
        <translation>Den Computer neu starten; bis dahin kann nur die CPU rechnen.</translation>
    </message>
    <message>
        <source>Returns to the page that was read before.</source>
        <translation>Kehrt zur zuvor gelesenen Seite zurück.</translation>
    </message>
    <message>
        <source>Returns to the view in which the series was opened.</source>
        <translation>Zeigt den Patienten wie beim Öffnen der Serie.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechter Klick</translation>
    </message>
    <message>
        <source>Right°</source>
        <translation>Rechts°</translation>
    </message>
    <message>
        <source>Rotates the environment image about the patient's axis [degrees]</source>
        <translation>Dreht das Umgebungsbild um die Achse des Patienten [Grad]</translation>
    </message>
    <message>
        <source>Rotation of the environment image</source>
        <translation>Drehung des Umgebungsbildes</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Grob</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>SD %1 %7, median %2 %7, %3 to %4 %7, %5 voxels, %6 ml.</source>
        <translation>SD %1 %7, Median %2 %7, %3 bis %4 %7, %5 Voxel, %6 ml.</translation>
    </message>
    <message>
        <source>Sa&amp;ve plan...</source>
        <translation>Plan s&amp;peichern...</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Sagittal %1 of %2</source>
        <translation>Sagittal %1 von %2</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Sagittale Schicht</translation>
    </message>
    <message>
        <source>Sample CT (included)</source>
        <translation>Beispiel-CT (mitgeliefert)</translation>
    </message>
    <message>
        <source>Samples: %1</source>
        <translation>Abtastungen: %1</translation>
    </message>
    <message>
        <source>Save and share looks</source>
        <translation>Darstellungen sichern und weitergeben</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Save the look as it is now, rename and delete your own, share them as files</source>
        <translation>Die jetzige Darstellung sichern, eigene umbenennen und löschen, als Dateien weitergeben</translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation>Den Plan speichern</translation>
    </message>
    <message>
        <source>Save this look</source>
        <translation>Diese Darstellung sichern</translation>
    </message>
    <message>
        <source>Saved and copied images say which side is which, what they show, and that they are not for diagnostic use.</source>
        <translation>Gespeicherte und kopierte Bilder sagen, welche Seite welche ist, was sie zeigen und dass sie nicht für die Diagnose sind.</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Saves the image as PNG or EXR, as shown or rendered at any size.</source>
        <translation>Speichert das Bild als PNG oder EXR, wie es ist oder neu berechnet in jeder Größe.</translation>
    </message>
    <message>
        <source>Saves what is set and measured, without the patient's name, for this scan alone.</source>
        <translation>Speichert, was eingestellt und gemessen ist, ohne den Namen des Patienten, nur für diese Aufnahme.</translation>
    </message>
    <message>
        <source>Scans in one file (%1)</source>
        <translation>Aufnahmen in einer Datei (%1)</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Ablauf</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Seen from the feet %1.</source>
        <translation>Von den Füßen her gesehen %1.</translation>
    </message>
    <message>
        <source>Seen from the front %1.</source>
        <translation>Von vorn gesehen %1.</translation>
    </message>
    <message>
        <source>Seen from the left %1.</source>
        <translation>Von links gesehen %1.</translation>
    </message>
    <message>
        <source>Sending the scan, %1 %</source>
        <translation>Scan wird übertragen, %1 %</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Set the &amp;crosshair</source>
        <translation>Faden&amp;kreuz setzen</translation>
    </message>
    <message>
        <source>Set the &amp;crosshair here</source>
        <translation>Faden&amp;kreuz hierher setzen</translation>
    </message>
    <message>
        <source>Seven small lamps in a ring above: their shadows overlap softly</source>
        <translation>Sieben kleine Lampen im Ring darüber: Ihre Schatten überlappen sich weich</translation>
    </message>
    <message>
        <source>Several layers shine through each other here</source>
        <translation>Hier scheinen mehrere Lagen durcheinander</translation>
    </message>
    <message>
        <source>Shape of the curve</source>
        <translation>Form der Kurve</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Shared out by cost</source>
        <translation>Nach Kosten verteilt</translation>
    </message>
    <message>
        <source>Sharp from %1 before the focus on; it is %2 away.</source>
        <translation>Scharf ab %1 vor der Schärfeebene; sie ist %2 entfernt.</translation>
    </message>
    <message>
        <source>Sharp from %1 before the focus to %2 behind it; it is %3 away.</source>
        <translation>Scharf von %1 vor der Schärfeebene bis %2 dahinter; sie ist %3 entfernt.</translation>
    </message>
    <message>
        <source>Shift the tissue's curve, widen it</source>
        <translation>Gewebekurve verschieben, verbreitern</translation>
    </message>
    <message>
        <source>Shift+right drag on the image</source>
        <translation>Umschalt+Ziehen mit rechts im Bild</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show &amp;this tissue</source>
        <translation>Dieses &amp;Gewebe zeigen</translation>
    </message>
    <message>
        <source>Show everything, or another part.</source>
        <translation>Alles zeigen oder einen anderen Teil.</translation>
    </message>
    <message>
        <source>Show it as it is.</source>
        <translation>Zeigen Sie sie, wie sie ist.</translation>
    </message>
    <message>
        <source>Show that slice</source>
        <translation>Diese Schicht zeigen</translation>
    </message>
    <message>
        <source>Show the tissue that is clicked</source>
        <translation>Das angeklickte Gewebe zeigen</translation>
    </message>
    <message>
        <source>Show the tissue that is there</source>
        <translation>Das Gewebe zeigen, das dort ist</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Shows all keys and what they do.</source>
        <translation>Zeigt alle Tasten und was sie tun.</translation>
    </message>
    <message>
        <source>Shows all of the message</source>
        <translation>Zeigt die ganze Meldung</translation>
    </message>
    <message>
        <source>Shows or closes the panels at the right of the image.</source>
        <translation>Zeigt oder schließt die Bereiche rechts vom Bild.</translation>
    </message>
    <message>
        <source>Shows or closes this panel.</source>
        <translation>Zeigt oder schließt diesen Bereich.</translation>
    </message>
    <message>
        <source>Shows or hides the buttons at the left of the image.</source>
        <translation>Zeigt oder verbirgt die Knöpfe links vom Bild.</translation>
    </message>
    <message>
        <source>Shows or hides what is solid, outside the body and thinner than 20 mm.</source>
        <translation>Zeigt oder verbirgt, was fest ist, außerhalb des Körpers liegt und dünner als 20 mm ist.</translation>
    </message>
    <message>
        <source>Shows the CT with less noise than it has. Slices and measurements stay as they are.
It takes as much memory again as the voxels of the scan.</source>
        <translation>Zeigt die CT mit weniger Rauschen, als sie hat. Schichten und Messungen bleiben, wie sie sind.
Das braucht noch einmal so viel Speicher wie die Voxel der Aufnahme.</translation>
    </message>
    <message>
        <source>Shows the denoised or the raw image.</source>
        <translation>Zeigt das entrauschte oder das rohe Bild.</translation>
    </message>
    <message>
        <source>Shows the image alone, with slices beside it, or as one of four views.</source>
        <translation>Zeigt das Bild allein, mit Schichten daneben oder als eine von vier Ansichten.</translation>
    </message>
    <message>
        <source>Shows the patient from this side, filling the view.</source>
        <translation>Zeigt den Patienten von dieser Seite, die Ansicht ausfüllend.</translation>
    </message>
    <message>
        <source>Shows the selected parts so thin that one sees through.</source>
        <translation>Zeigt die gewählten Teile so dünn, dass man hindurchsieht.</translation>
    </message>
    <message>
        <source>Shows the selected parts.</source>
        <translation>Zeigt die gewählten Teile.</translation>
    </message>
    <message>
        <source>Shows the version, the licence, and what this program is not for.</source>
        <translation>Nennt die Version, die Lizenz und wofür dieses Programm nicht gedacht ist.</translation>
    </message>
    <message>
        <source>Shows which voxels are in which part; hidden parts stay grey.</source>
        <translation>Zeigt, welche Voxel zu welchem Teil gehören; verborgene Teile bleiben grau.</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Gr&amp;öße</translation>
    </message>
    <message>
        <source>Side bar</source>
        <translation>Seitenleiste</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Sides and patient</source>
        <translation>Seiten und Patient</translation>
    </message>
    <message>
        <source>Sides, look, body part, cut, scale and accuracy; or the patient as well. OpenEXR files carry none.</source>
        <translation>Seiten, Look, Teil, Schnitt, Maßstab und wie weit das Bild ist; oder zusätzlich, wer der Patient ist. OpenEXR trägt keine.</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>Schweigt</translation>
    </message>
    <message>
        <source>Size of the chosen lamp</source>
        <translation>Größe der gewählten Lampe</translation>
    </message>
    <message>
        <source>Size of the image</source>
        <translation>Größe des Bildes</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>Sk&amp;y turned</source>
        <translation>&amp;Winkel des Himmels</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Skin (identifies the patient)</source>
        <translation>Haut (macht erkennbar)</translation>
    </message>
    <message>
        <source>Skin and fat are not shown. Vessels and muscle are found by rule or by another program: organs may be among the muscle, and vessels beside bone may be missing.</source>
        <translation>Haut und Fett sind nicht zu sehen. Gefäße und Muskeln findet eine Regel oder ein anderes Programm: unter den Muskeln können Organe sein, und Gefäße neben Knochen können fehlen.</translation>
    </message>
    <message>
        <source>Skin over bone</source>
        <translation>Haut über Knochen</translation>
    </message>
    <message>
        <source>Skin surface only. The patient can be recognised.</source>
        <translation>Nur die Hautoberfläche. Der Patient ist erkennbar.</translation>
    </message>
    <message>
        <source>Skull with a defect and its mirror</source>
        <translation>Schädel mit Lücke und Spiegelbild</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Slice &amp;alone, or all views</source>
        <translation>Schicht &amp;allein oder alle Ansichten</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Slices &amp;beside the image</source>
        <translation>Schichten &amp;neben dem Bild</translation>
    </message>
    <message>
        <source>Small lamps throw hard shadows, large ones soft ones; the light stays as strong</source>
        <translation>Kleine Lampen werfen harte Schatten, große weiche; das Licht bleibt gleich stark</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Soft tissue is not shown, and bone below 230 HU is faint.</source>
        <translation>Weichgewebe ist nicht zu sehen, Knochen unter 230 HU nur schwach.</translation>
    </message>
    <message>
        <source>Soft tissue is not shown. Cartilage with calcium looks like bone.</source>
        <translation>Weichgewebe ist nicht zu sehen. Verkalkter Knorpel sieht aus wie Knochen.</translation>
    </message>
    <message>
        <source>Start the program again to use the GPU, with a smaller image, or use one that has no display.</source>
        <translation>Das Programm neu starten, um die GPU zu benutzen, mit einem kleineren Bild, oder eine GPU ohne Anzeige benutzen.</translation>
    </message>
    <message>
        <source>Start the program again to use the GPU; if it is lost again, install a newer driver or restart the computer.</source>
        <translation>Das Programm neu starten, um die GPU zu benutzen; geht sie wieder verloren, einen neueren Treiber installieren oder den Computer neu starten.</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Still being separated; everything is shown until then.</source>
        <translation>Wird noch getrennt; bis dahin ist alles zu sehen.</translation>
    </message>
    <message>
        <source>Stop after this many seconds of rendering</source>
        <translation>Anhalten nach so vielen Sekunden Rechenzeit</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Anhalten bei</translation>
    </message>
    <message>
        <source>Stop sooner, or more accurate</source>
        <translation>Früher anhalten, oder genauer</translation>
    </message>
    <message>
        <source>Stop when 95 % of the tissue is within this many grey levels</source>
        <translation>Anhalten, wenn 95 % des Gewebes innerhalb so vieler Graustufen liegen</translation>
    </message>
    <message>
        <source>Stop when each pixel has this many samples</source>
        <translation>Anhalten, wenn jedes Pixel so viele Abtastungen hat</translation>
    </message>
    <message>
        <source>Stren&amp;gth</source>
        <translation>St&amp;ärke</translation>
    </message>
    <message>
        <source>Strength of the chosen lamp</source>
        <translation>Stärke der gewählten Lampe</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Study without a date</source>
        <translation>Untersuchung ohne Datum</translation>
    </message>
    <message>
        <source>Systematic error</source>
        <translation>Systematischer Fehler</translation>
    </message>
    <message>
        <source>TE %1 ms</source>
        <translation>TE %1 ms</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Table and holder hidden: %1 outside the body.</source>
        <translation>Tisch und Halterung ausgeblendet: %1 außerhalb des Körpers.</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>Tabelle für Tabellenkalkulationen (*.csv)</translation>
    </message>
    <message>
        <source>Take a scan with contrast medium, or a label map of another program.</source>
        <translation>Nehmen Sie eine Aufnahme mit Kontrastmittel oder die Labelkarte eines anderen Programms.</translation>
    </message>
    <message>
        <source>Take absorption, singleScattering or multipleScattering, or leave the parts out.</source>
        <translation>Nehmen Sie absorption, singleScattering oder multipleScattering, oder lassen Sie die Teile weg.</translation>
    </message>
    <message>
        <source>Take the model singleScattering, or the estimator unbiased.</source>
        <translation>Das Modell singleScattering nehmen oder den Schätzer unbiased.</translation>
    </message>
    <message>
        <source>Target accuracy of the image</source>
        <translation>Zielgenauigkeit des Bildes</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>Felsenbein</translation>
    </message>
    <message>
        <source>The CPU renders the image for the file, since the GPU cannot: %1</source>
        <translation>Die CPU rechnet das Bild für die Datei, da die GPU es nicht kann: %1</translation>
    </message>
    <message>
        <source>The CPU renders, since the GPU cannot be used: %1</source>
        <translation>Die CPU rechnet, da die Grafikkarte nicht verwendet werden kann: %1</translation>
    </message>
    <message>
        <source>The CPU renders, since the device chosen last cannot be used: %1</source>
        <translation>Die CPU rechnet, da das zuletzt gewählte Gerät nicht verwendet werden kann: %1</translation>
    </message>
    <message>
        <source>The GPU %1 renders, since the device chosen last cannot be used: %2</source>
        <translation>Die GPU %1 rechnet, da das zuletzt gewählte Gerät nicht verwendet werden kann: %2</translation>
    </message>
    <message>
        <source>The HU that slices show at this place. One place has no ±: a ball has a mean with a ±.</source>
        <translation>Der HU-Wert, den Schichten an diesem Ort zeigen. Ein einzelner Ort hat kein ±: Eine Kugel hat einen Mittelwert mit ±.</translation>
    </message>
    <message>
        <source>The chosen lamp</source>
        <translation>Die gewählte Lampe</translation>
    </message>
    <message>
        <source>The curve follows the values of this scan, which are no HU: what is dark in it is not shown.</source>
        <translation>Die Kurve folgt den Werten dieser Aufnahme, die keine HU sind: Was in ihr dunkel ist, ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>The densest contrast looks like bone, and marrow looks like blood.</source>
        <translation>Das dichteste Kontrastmittel sieht aus wie Knochen, Mark wie Blut.</translation>
    </message>
    <message>
        <source>The densest tissue on each line of sight; not which of two lies in front.</source>
        <translation>Das dichteste Gewebe auf jedem Sehstrahl; nicht, was davon vorn liegt.</translation>
    </message>
    <message>
        <source>The device that renders. Rendering continues there with the samples taken so far.</source>
        <translation>Was das Bild berechnet. Es geht dort mit den vorhandenen Abtastungen weiter.</translation>
    </message>
    <message>
        <source>The error is not known yet</source>
        <translation>Der Fehler ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>The folder of this machine's certificates</source>
        <translation>Der Ordner mit den Zertifikaten dieses Rechners</translation>
    </message>
    <message>
        <source>The folder of this machine's certificates, which "pdrender-node --make-certificates" has made: with them nodes on other machines may be used.</source>
        <translation>Der Ordner mit den Zertifikaten dieses Rechners, die „pdrender-node --make-certificates“ erzeugt hat: Mit ihnen lassen sich andere Rechner als Render-Rechner verwenden.</translation>
    </message>
    <message>
        <source>The histogram's height grows with the logarithm of the voxels</source>
        <translation>Die Höhe des Histogramms wächst mit dem Logarithmus der Voxel</translation>
    </message>
    <message>
        <source>The image begins anew on %1, which filters the volume in another way.</source>
        <translation>Das Bild beginnt von vorn, weil das Volumen dort anders gefiltert wird: %1.</translation>
    </message>
    <message>
        <source>The image is in %1 instead.</source>
        <translation>Das Bild liegt stattdessen in %1.</translation>
    </message>
    <message>
        <source>The language changes after a restart</source>
        <translation>Die Sprache wechselt nach einem Neustart</translation>
    </message>
    <message>
        <source>The last one is cuda:%1.</source>
        <translation>Die letzte ist cuda:%1.</translation>
    </message>
    <message>
        <source>The list offers a series of even slices, interpolated between those measured.</source>
        <translation>Die Liste bietet eine Serie mit gleichmäßigen Schichten an, interpoliert zwischen den gemessenen.</translation>
    </message>
    <message>
        <source>The lungs are not shown; %1 mm at the pleura remain.</source>
        <translation>Die Lungen werden nicht gezeigt; %1 mm an der Pleura bleiben stehen.</translation>
    </message>
    <message>
        <source>The mirrored bone is the healthy side's and no plan of an implant. A defect in the middle, or on both sides, is not closed by it.</source>
        <translation>Der gespiegelte Knochen ist der der gesunden Seite und kein Plan eines Implantats. Eine Lücke in der Mitte oder auf beiden Seiten schließt er nicht.</translation>
    </message>
    <message>
        <source>The next click on the image moves the slices to what is seen there.</source>
        <translation>Der nächste Klick ins Bild führt die Schichten zu dem, was dort zu sehen ist.</translation>
    </message>
    <message>
        <source>The optical model of this look shows no parts.</source>
        <translation>Das optische Modell dieses Looks zeigt keine Teile.</translation>
    </message>
    <message>
        <source>The outermost 5 mm and fat are not shown. The brain lies behind the skull.</source>
        <translation>Die äußersten 5 mm und Fett sind nicht zu sehen. Das Gehirn liegt hinter dem Schädel.</translation>
    </message>
    <message>
        <source>The outermost 7 mm, fat and lung are not shown. Contrast looks like bone.</source>
        <translation>Die äußersten 7 mm, Fett und Lunge sind nicht zu sehen. Kontrastmittel sieht aus wie Knochen.</translation>
    </message>
    <message>
        <source>The part of an iteration's time that goes to it</source>
        <translation>Der Teil der Zeit einer Iteration, der darauf entfällt</translation>
    </message>
    <message>
        <source>The part of the patient that is shown; the scan itself is not changed</source>
        <translation>Der Teil des Patienten, der gezeigt wird; die Aufnahme selbst bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>The patient's side that one looks at (%1)</source>
        <translation>Die Seite des Patienten, die man ansieht (%1)</translation>
    </message>
    <message>
        <source>The plan from %1 with %2, which was not saved, has been restored. Undo removes it again.</source>
        <translation>Der Plan von %1 mit %2, der nicht gesichert war, ist wiederhergestellt. Rückgängig entfernt ihn wieder.</translation>
    </message>
    <message>
        <source>The region extends beyond the scan.</source>
        <translation>Der Bereich reicht über die Aufnahme hinaus.</translation>
    </message>
    <message>
        <source>The rendered volume. Arrow keys turn it, Shift and arrow keys move it, plus and minus zoom.</source>
        <translation>Das berechnete Volumen. Pfeiltasten drehen es, Umschalt und Pfeiltasten verschieben es, Plus und Minus zoomen.</translation>
    </message>
    <message>
        <source>The scanner measured nothing in %1 more.</source>
        <translation>In %1 weiteren hat der Scanner nichts gemessen.</translation>
    </message>
    <message>
        <source>The series was not read to its end; its slices are shown no longer.</source>
        <translation>Die Serie wurde nicht zu Ende gelesen; ihre Schichten werden nicht mehr gezeigt.</translation>
    </message>
    <message>
        <source>The value that slices show at this place. One place has no ±: a ball has a mean with a ±.</source>
        <translation>Der Wert, den Schichten an diesem Ort zeigen. Ein einzelner Ort hat kein ±: Eine Kugel hat einen Mittelwert mit ±.</translation>
    </message>
    <message>
        <source>The values along the chosen distance, and beyond it. Dashed: its ends; dots: the half levels at which they lie. The pointer and the arrow keys read off values.</source>
        <translation>Die Werte entlang der gewählten Strecke und darüber hinaus. Gestrichelt: ihre Enden; Punkte: die halben Höhen, auf denen sie liegen. Mauszeiger und Pfeiltasten lesen Werte ab.</translation>
    </message>
    <message>
        <source>The values of this scan are no HU: windows for tissues are not offered.</source>
        <translation>Die Werte dieser Aufnahme sind keine HU: Fenster für Gewebe werden nicht angeboten.</translation>
    </message>
    <message>
        <source>The view: each side is lit alike
The patient: the lamps stay where they are when the patient is turned</source>
        <translation>Die Ansicht: Jede Seite ist gleich beleuchtet
Der Patient: Die Lampen bleiben, wo sie sind, wenn der Patient gedreht wird</translation>
    </message>
    <message>
        <source>The ± is that of the noise. Not in it: the scanner's own scale, where the region was put.</source>
        <translation>Das ± ist das des Rauschens. Nicht darin: der Maßstab des Scanners, wohin der Bereich gelegt wurde.</translation>
    </message>
    <message>
        <source>Then click the anatomy that is to be sharp</source>
        <translation>Dann auf die Anatomie klicken, die scharf sein soll</translation>
    </message>
    <message>
        <source>Then click the anatomy: a bell at its value is added (Ctrl and click does the same)</source>
        <translation>Dann auf die Anatomie klicken: Eine Glocke bei ihrem Wert wird hinzugefügt (Strg und Klick tut dasselbe)</translation>
    </message>
    <message>
        <source>Then save again.</source>
        <translation>Dann noch einmal sichern.</translation>
    </message>
    <message>
        <source>Thi&amp;s tissue...</source>
        <translation>Dieses Ge&amp;webe...</translation>
    </message>
    <message>
        <source>Thickness removed</source>
        <translation>Abgetragene Dicke</translation>
    </message>
    <message>
        <source>Thickness removed from the body surface, e.g. skin [mm]</source>
        <translation>Dicke, die von der Körperoberfläche abgetragen wird, etwa die Haut [mm]</translation>
    </message>
    <message>
        <source>Thin bone</source>
        <translation>Dünner Knochen</translation>
    </message>
    <message>
        <source>This image cannot be rendered: %1</source>
        <translation>Dieses Bild kann nicht gemacht werden: %1</translation>
    </message>
    <message>
        <source>This image shows skin: share it like a photograph of the patient.</source>
        <translation>Dieses Bild zeigt Haut: Geben Sie es nur weiter wie ein Foto des Patienten.</translation>
    </message>
    <message>
        <source>This look shows bone that one side has and the other lacks, which has not been looked for in this scan yet.</source>
        <translation>Dieser Look zeigt Knochen, den eine Seite hat und der anderen fehlt; danach ist in dieser Aufnahme noch nicht gesucht worden.</translation>
    </message>
    <message>
        <source>This look shows implants, which have not been found in this scan yet.</source>
        <translation>Dieser Look zeigt Implantate, die in dieser Aufnahme noch nicht gefunden sind.</translation>
    </message>
    <message>
        <source>This look shows parts of a label map, and none with them is open.</source>
        <translation>Dieser Look zeigt Teile einer Labelkarte, und keine mit ihnen ist offen.</translation>
    </message>
    <message>
        <source>This look shows skin or muscle, which has not been found in this scan yet.</source>
        <translation>Dieser Look zeigt Haut oder Muskel, was auf dieser Aufnahme noch nicht gefunden wurde.</translation>
    </message>
    <message>
        <source>This look shows vessels, which have not been found in this scan yet.</source>
        <translation>Dieser Look zeigt Gefäße, die auf dieser Aufnahme noch nicht gefunden wurden.</translation>
    </message>
    <message>
        <source>This pixel ±%1</source>
        <translation>Dieses Pixel ±%1</translation>
    </message>
    <message>
        <source>This pixel ±%1; it is larger than 1 mm</source>
        <translation>Dieses Pixel ±%1; es ist größer als 1 mm</translation>
    </message>
    <message>
        <source>This pixel ±%1; mean over 1 mm not known yet</source>
        <translation>Dieses Pixel ±%1; Mittel über 1 mm noch nicht bekannt</translation>
    </message>
    <message>
        <source>This pixel ±%1; mean over 1 mm ±%2</source>
        <translation>Dieses Pixel ±%1; Mittel über 1 mm ±%2</translation>
    </message>
    <message>
        <source>This pixel: not known yet</source>
        <translation>Dieses Pixel: noch nicht bekannt</translation>
    </message>
    <message>
        <source>This plan shows parts of a label map, of which it holds neither the voxels nor the place. Open that label map again, and its parts look as they did.</source>
        <translation>Dieser Plan zeigt Teile einer Labelkarte, von der er weder die Voxel noch den Ort enthält. Öffnen Sie diese Labelkarte wieder, dann sehen ihre Teile aus wie zuvor.</translation>
    </message>
    <message>
        <source>Three-point light</source>
        <translation>Dreipunktlicht</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwellwert</translation>
    </message>
    <message>
        <source>Tiles: %1</source>
        <translation>Kacheln: %1</translation>
    </message>
    <message>
        <source>Tiles: each node renders a part of the image. Samples: each renders the whole image, a block of samples at a time, which is sooner where tiles would be too small.</source>
        <translation>Kacheln: Jeder Render-Rechner rechnet einen Teil des Bildes. Abtastungen: Jeder rechnet das ganze Bild, immer einen Block von Abtastungen; das ist schneller, wo Kacheln zu klein wären.</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Tissue in its own colours, without light or shadow.</source>
        <translation>Gewebe in seinen eigenen Farben, ohne Licht und Schatten.</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Total attenuation along the line of sight, as in a radiograph. Lamps have no effect.</source>
        <translation>Gesamte Schwächung entlang der Blicklinie, wie im Röntgenbild. Lampen wirken nicht.</translation>
    </message>
    <message>
        <source>Translucent tissue (multiple scattering)</source>
        <translation>Durchscheinendes Gewebe (Mehrfachstreuung)</translation>
    </message>
    <message>
        <source>Try OpenEXR (.exr).</source>
        <translation>OpenEXR (.exr) versuchen.</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Try again; if it fails again, start the program again, or render on the CPU.</source>
        <translation>Noch einmal versuchen; versagt sie wieder, das Programm neu starten oder auf der CPU rechnen.</translation>
    </message>
    <message>
        <source>Turn off</source>
        <translation>Abschalten</translation>
    </message>
    <message>
        <source>Turn off effects that do not show</source>
        <translation>Unsichtbare Effekte abschalten</translation>
    </message>
    <message>
        <source>Turn the lights</source>
        <translation>Lampen drehen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Turns off %1.</source>
        <translation>Schaltet ab: %1.</translation>
    </message>
    <message>
        <source>Turns off the effects that nobody would see, and lists them first</source>
        <translation>Schaltet Effekte ab, die niemand sähe, und nennt sie zuvor</translation>
    </message>
    <message>
        <source>Two lamps behind: bright outlines</source>
        <translation>Zwei Lampen dahinter: helle Umrisse</translation>
    </message>
    <message>
        <source>Two lines</source>
        <translation>Zwei Linien</translation>
    </message>
    <message>
        <source>Two lines %1</source>
        <translation>Zwei Linien %1</translation>
    </message>
    <message>
        <source>Type the address of a node first, such as gpu-07 or 10.0.0.7:%1.</source>
        <translation>Geben Sie zuerst die Adresse eines Render-Rechners ein, etwa gpu-07 oder 10.0.0.7:%1.</translation>
    </message>
    <message>
        <source>Typed places have no ±.</source>
        <translation>Eingetippte Orte haben kein ±.</translation>
    </message>
    <message>
        <source>Unbiased</source>
        <translation>Erwartungstreu</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo adding parts</source>
        <translation>Hinzufügen von Teilen rückgängig machen</translation>
    </message>
    <message>
        <source>Undo changing a measurement</source>
        <translation>Rückgängig: Messung ändern</translation>
    </message>
    <message>
        <source>Undo changing how a part is shown</source>
        <translation>Darstellung eines Teils rückgängig machen</translation>
    </message>
    <message>
        <source>Undo changing the background</source>
        <translation>Rückgängig: Hintergrund ändern</translation>
    </message>
    <message>
        <source>Undo changing the brightness</source>
        <translation>Rückgängig: Helligkeit ändern</translation>
    </message>
    <message>
        <source>Undo changing the layout</source>
        <translation>Rückgängig: Anordnung ändern</translation>
    </message>
    <message>
        <source>Undo changing the lens</source>
        <translation>Rückgängig: Linse ändern</translation>
    </message>
    <message>
        <source>Undo changing the light</source>
        <translation>Rückgängig: Licht ändern</translation>
    </message>
    <message>
        <source>Undo changing the rendering</source>
        <translation>Rückgängig: Berechnung ändern</translation>
    </message>
    <message>
        <source>Undo changing the window</source>
        <translation>Rückgängig: Fenster ändern</translation>
    </message>
    <message>
        <source>Undo choosing a look</source>
        <translation>Rückgängig: Darstellung wählen</translation>
    </message>
    <message>
        <source>Undo choosing an optical model</source>
        <translation>Rückgängig: Optisches Modell wählen</translation>
    </message>
    <message>
        <source>Undo choosing the visible part</source>
        <translation>Rückgängig: Sichtbares wählen</translation>
    </message>
    <message>
        <source>Undo cutting</source>
        <translation>Rückgängig: Schneiden</translation>
    </message>
    <message>
        <source>Undo editing the tissue</source>
        <translation>Rückgängig: Gewebe bearbeiten</translation>
    </message>
    <message>
        <source>Undo hiding the table</source>
        <translation>Rückgängig: Tisch ausblenden</translation>
    </message>
    <message>
        <source>Undo marking a place</source>
        <translation>Rückgängig: Punkt markieren</translation>
    </message>
    <message>
        <source>Undo measuring</source>
        <translation>Rückgängig: Messen</translation>
    </message>
    <message>
        <source>Undo moving the view</source>
        <translation>Rückgängig: Ansicht verschieben</translation>
    </message>
    <message>
        <source>Undo moving through the slices</source>
        <translation>Rückgängig: durch die Schichten bewegen</translation>
    </message>
    <message>
        <source>Undo naming a measurement</source>
        <translation>Rückgängig: Messung benennen</translation>
    </message>
    <message>
        <source>Undo removing a measurement</source>
        <translation>Rückgängig: Messung entfernen</translation>
    </message>
    <message>
        <source>Undo removing parts</source>
        <translation>Entfernen der Teile rückgängig machen</translation>
    </message>
    <message>
        <source>Undo several changes</source>
        <translation>Rückgängig: mehrere Änderungen</translation>
    </message>
    <message>
        <source>Undo showing the table</source>
        <translation>Rückgängig: Tisch zeigen</translation>
    </message>
    <message>
        <source>Undo switching CT denoising</source>
        <translation>Rückgängig: Entrauschen der CT umschalten</translation>
    </message>
    <message>
        <source>Undo that side or plane of the cut</source>
        <translation>Diese Seite oder Ebene des Schnitts aufheben</translation>
    </message>
    <message>
        <source>Undo turning the view</source>
        <translation>Rückgängig: Ansicht drehen</translation>
    </message>
    <message>
        <source>Undo zooming</source>
        <translation>Rückgängig: Zoomen</translation>
    </message>
    <message>
        <source>Uniform ambient light instead, as bright</source>
        <translation>Stattdessen gleichmäßiges, ebenso helles Licht von allen Seiten</translation>
    </message>
    <message>
        <source>Unlit tissue</source>
        <translation>Unbeleuchtetes Gewebe</translation>
    </message>
    <message>
        <source>Unpack it with its password, and open the folder.</source>
        <translation>Entpacken Sie es mit seinem Passwort, und öffnen Sie den Ordner.</translation>
    </message>
    <message>
        <source>Unpack it, and open the folder.</source>
        <translation>Entpacken Sie es, und öffnen Sie den Ordner.</translation>
    </message>
    <message>
        <source>Until this is fixed, unsaved work is lost if the program ends unexpectedly: save the plan yourself.</source>
        <translation>Bis das behoben ist, geht Ungesichertes verloren, wenn das Programm unerwartet endet: Sichern Sie den Plan selbst.</translation>
    </message>
    <message>
        <source>Until:</source>
        <translation>Bis:</translation>
    </message>
    <message>
        <source>Up [degrees]</source>
        <translation>Nach oben [Grad]</translation>
    </message>
    <message>
        <source>Up and down scroll by a slice, Page up and Page down by ten, digits choose a window. Shift with the arrows moves the crosshair, Enter clicks there.</source>
        <translation>Auf und Ab blättern um eine Schicht, Bild auf und Bild ab um zehn, Ziffern wählen ein Fenster. Umschalt mit den Pfeiltasten bewegt das Fadenkreuz, Eingabe klickt dort.</translation>
    </message>
    <message>
        <source>Up°</source>
        <translation>Oben°</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punktes</translation>
    </message>
    <message>
        <source>Values along the distance</source>
        <translation>Werte entlang der Strecke</translation>
    </message>
    <message>
        <source>Values that are no HU</source>
        <translation>Werte, die keine HU sind</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Vessels and bone</source>
        <translation>Gefäße und Knochen</translation>
    </message>
    <message>
        <source>Vessels are found by rule or by another program: beside bone they may be missing, and calcium may be among them.</source>
        <translation>Gefäße werden nach Regeln oder von einem anderen Programm gefunden: neben Knochen können sie fehlen, und Kalk kann darunter sein.</translation>
    </message>
    <message>
        <source>Vessels are found by rule or by another program: beside bone they may be missing, and calcium may be among them. Around them nothing can be judged.</source>
        <translation>Gefäße werden nach Regeln oder von einem anderen Programm gefunden: neben Knochen können sie fehlen, und Kalk kann darunter sein. Um sie herum ist nichts zu beurteilen.</translation>
    </message>
    <message>
        <source>Vessels in a ghost body</source>
        <translation>Gefäße im Geisterkörper</translation>
    </message>
    <message>
        <source>Vessels within 5 mm of the lung's surface are not shown; arteries, veins and walls of airways look alike.</source>
        <translation>Gefäße, die weniger als 5 mm unter der Lungenoberfläche liegen, sind nicht zu sehen; Arterien, Venen und Wände der Atemwege sehen gleich aus.</translation>
    </message>
    <message>
        <source>View from: %1</source>
        <translation>Ansicht von: %1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Voxel size %1 × %2 × %3 mm</source>
        <translation>Voxelgröße %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Voxel size of the scan</source>
        <translation>Voxelgröße der Aufnahme</translation>
    </message>
    <message>
        <source>Wait for it, or cancel it.</source>
        <translation>Darauf warten oder es abbrechen.</translation>
    </message>
    <message>
        <source>Wait until the new image is there.</source>
        <translation>Warten, bis das gewünschte Bild da ist.</translation>
    </message>
    <message>
        <source>Wait until there is one.</source>
        <translation>Warten, bis es eines gibt.</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>What can be done</source>
        <translation>Was getan werden kann</translation>
    </message>
    <message>
        <source>What can be dropped on the window:</source>
        <translation>Was auf das Fenster gezogen werden kann:</translation>
    </message>
    <message>
        <source>What could not be done</source>
        <translation>Was nicht ging</translation>
    </message>
    <message>
        <source>What is sharp</source>
        <translation>Was scharf ist</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>What is to be known of the parts</source>
        <translation>Was über die Teile zu wissen ist</translation>
    </message>
    <message>
        <source>What is written over the image</source>
        <translation>Was über dem Bild steht</translation>
    </message>
    <message>
        <source>What it computes with</source>
        <translation>Womit er rechnet</translation>
    </message>
    <message>
        <source>What it is doing. What a lost node had in hand is rendered by others</source>
        <translation>Was er gerade tut. Was ein verlorener Render-Rechner in Arbeit hatte, rechnen andere</translation>
    </message>
    <message>
        <source>What it shows and costs</source>
        <translation>Was es zeigt und kostet</translation>
    </message>
    <message>
        <source>What lies in front of the cut is not shown, nor is fat.</source>
        <translation>Was vor dem Schnitt liegt, ist nicht zu sehen, ebenso Fett.</translation>
    </message>
    <message>
        <source>What lies in front of the cut is not shown, nor is fat. Very dense contrast looks like bone, marrow like blood.</source>
        <translation>Was vor dem Schnitt liegt, ist nicht zu sehen, ebenso Fett. Sehr dichtes Kontrastmittel sieht aus wie Knochen, Mark wie Blut.</translation>
    </message>
    <message>
        <source>What lights it</source>
        <translation>Was es beleuchtet</translation>
    </message>
    <message>
        <source>What stands behind the volume. A plain colour lights nothing</source>
        <translation>Was hinter dem Volumen steht. Eine einfache Farbe beleuchtet nichts</translation>
    </message>
    <message>
        <source>What the lamps move with</source>
        <translation>Womit sich die Lampen drehen</translation>
    </message>
    <message>
        <source>What this look does not show</source>
        <translation>Was diese Darstellung nicht zeigt</translation>
    </message>
    <message>
        <source>What went wrong with it, and was put right by others</source>
        <translation>Was mit ihm schiefging und von anderen behoben wurde</translation>
    </message>
    <message>
        <source>Wheel, right drag, + and -</source>
        <translation>Rad, Ziehen mit rechts, + und -</translation>
    </message>
    <message>
        <source>Where a machine waits that is to render along: one on which "pdrender-node --listen" runs. Without a port it is %1.</source>
        <translation>Wo ein Rechner wartet, der mitrechnen soll: einer, auf dem „pdrender-node --listen“ läuft. Ohne Port gilt %1.</translation>
    </message>
    <message>
        <source>Where the first selected point lies; the others move with it</source>
        <translation>Wo der erste gewählte Punkt liegt; die anderen bewegen sich mit</translation>
    </message>
    <message>
        <source>Whether the tissue removed by box and planes still casts shadows</source>
        <translation>Ob das von Quader und Ebenen entfernte Gewebe noch Schatten wirft</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Ganzer Bereich</translation>
    </message>
    <message>
        <source>Why this key cannot be used</source>
        <translation>Warum diese Taste nicht geht</translation>
    </message>
    <message>
        <source>Width of the image [pixels]</source>
        <translation>Breite des Bildes [Pixel]</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window %1 / %2 %3</source>
        <translation>Fenster %1 / %2 %3</translation>
    </message>
    <message>
        <source>Without certificates</source>
        <translation>Ohne Zertifikate</translation>
    </message>
    <message>
        <source>Without certificates connections are plain, and to this machine only</source>
        <translation>Ohne Zertifikate sind Verbindungen unverschlüsselt und nur innerhalb dieses Rechners möglich</translation>
    </message>
    <message>
        <source>Without certificates: only nodes on this machine</source>
        <translation>Ohne Zertifikate: nur Programme auf diesem Rechner</translation>
    </message>
    <message>
        <source>Without it, it is not known who is shut out.</source>
        <translation>Ohne sie ist nicht bekannt, wer ausgeschlossen ist.</translation>
    </message>
    <message>
        <source>Write to another one.</source>
        <translation>In eine andere schreiben.</translation>
    </message>
    <message>
        <source>Writes the measurements for spreadsheets (CSV) or 3D Slicer, without the patient's name.</source>
        <translation>Schreibt die Messungen für Tabellenkalkulationen (CSV) oder 3D Slicer, ohne den Namen des Patienten.</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgenbild</translation>
    </message>
    <message>
        <source>X-rays of %1 kV</source>
        <translation>Röntgenstrahlen von %1 kV</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>a DICOM segmentation</source>
        <translation>einer DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage</source>
        <translation>ein ZIP-Archiv mit DICOM- oder Volumendateien oder ein einzelnes Volumen: NIfTI, NRRD oder MetaImage</translation>
    </message>
    <message>
        <source>a box, a plane or a drawn line cuts into the volume</source>
        <translation>ein Quader, eine Ebene oder eine gezeichnete Linie schneidet ins Volumen</translation>
    </message>
    <message>
        <source>a built-in look has this name</source>
        <translation>eine Darstellung des Programms hat diesen Namen</translation>
    </message>
    <message>
        <source>a certificate cannot be made: %1</source>
        <translation>ein Zertifikat kann nicht gemacht werden: %1</translation>
    </message>
    <message>
        <source>a code table is missing</source>
        <translation>eine Codetabelle fehlt</translation>
    </message>
    <message>
        <source>a colour image (%1), not a CT slice</source>
        <translation>ein farbiges Bild (%1), keine CT-Schicht</translation>
    </message>
    <message>
        <source>a content of the scene is not what the order says</source>
        <translation>ein Inhalt der Szene ist nicht, was der Auftrag sagt</translation>
    </message>
    <message>
        <source>a damaged piece of a scan</source>
        <translation>ein beschädigtes Stück eines Scans</translation>
    </message>
    <message>
        <source>a file of this name is in the way</source>
        <translation>eine Datei dieses Namens ist im Weg</translation>
    </message>
    <message>
        <source>a folder of DICOM files, or one of the files: its series are listed</source>
        <translation>ein Ordner mit DICOM-Dateien oder eine der Dateien: seine Serien werden aufgelistet</translation>
    </message>
    <message>
        <source>a frame took no time</source>
        <translation>ein Durchgang hat keine Zeit gebraucht</translation>
    </message>
    <message>
        <source>a key of its map is there twice, or out of its place</source>
        <translation>ein Schlüssel ihrer Tabelle ist doppelt oder am falschen Platz</translation>
    </message>
    <message>
        <source>a label map (%1)</source>
        <translation>einer Labelkarte (%1)</translation>
    </message>
    <message>
        <source>a light is a rectangle or a sphere</source>
        <translation>ein Licht ist ein Rechteck oder eine Kugel</translation>
    </message>
    <message>
        <source>a line is too short to have a direction</source>
        <translation>eine Linie ist zu kurz, um eine Richtung zu haben</translation>
    </message>
    <message>
        <source>a list in it has another length</source>
        <translation>eine Liste darin hat eine andere Länge</translation>
    </message>
    <message>
        <source>a localizer (scout view), not a CT slice</source>
        <translation>ein Localizer (Übersichtsaufnahme), keine CT-Schicht</translation>
    </message>
    <message>
        <source>a look needs a name</source>
        <translation>eine Darstellung braucht einen Namen</translation>
    </message>
    <message>
        <source>a message of a kind that must be understood, but is not known here</source>
        <translation>eine Nachricht, die verstanden werden muss, hier aber unbekannt ist</translation>
    </message>
    <message>
        <source>a message that was damaged on its way</source>
        <translation>eine Nachricht, die unterwegs beschädigt wurde</translation>
    </message>
    <message>
        <source>a number in it is none</source>
        <translation>eine Zahl darin ist keine</translation>
    </message>
    <message>
        <source>a number in it is out of its range</source>
        <translation>eine Zahl darin liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>a number in its header is not finite</source>
        <translation>eine Zahl in ihrem Kopf ist nicht endlich</translation>
    </message>
    <message>
        <source>a part of the body has a material of its own</source>
        <translation>ein Körperteil hat ein eigenes Material</translation>
    </message>
    <message>
        <source>a part of the body is not shown</source>
        <translation>ein Teil des Körpers wird nicht gezeigt</translation>
    </message>
    <message>
        <source>a path has at least two places</source>
        <translation>ein Weg hat mindestens zwei Orte</translation>
    </message>
    <message>
        <source>a path may have one event only</source>
        <translation>ein Weg darf nur ein Ereignis haben</translation>
    </message>
    <message>
        <source>a piece of a scan that was not asked for</source>
        <translation>ein Stück eines Scans, um das nicht gebeten war</translation>
    </message>
    <message>
        <source>a plan (.plan.json), once its scan is open</source>
        <translation>ein Plan (.plan.json), sobald seine Aufnahme offen ist</translation>
    </message>
    <message>
        <source>a plan holds %1 measurements at most</source>
        <translation>ein Plan enthält höchstens %1 Messungen</translation>
    </message>
    <message>
        <source>a plan needs its scan</source>
        <translation>ein Plan braucht seine Aufnahme</translation>
    </message>
    <message>
        <source>a point of the curve emits light</source>
        <translation>ein Punkt der Kurve leuchtet selbst</translation>
    </message>
    <message>
        <source>a point of the curve is specular</source>
        <translation>ein Punkt der Kurve glänzt</translation>
    </message>
    <message>
        <source>a polygon has %1 corners at most</source>
        <translation>ein Vieleck hat höchstens %1 Ecken</translation>
    </message>
    <message>
        <source>a render node joined</source>
        <translation>ein Render-Rechner kam dazu</translation>
    </message>
    <message>
        <source>a render node was lost</source>
        <translation>ein Render-Rechner ging verloren</translation>
    </message>
    <message>
        <source>a rule of this program</source>
        <translation>einer Regel dieses Programms</translation>
    </message>
    <message>
        <source>a run of equal bytes is spelled out</source>
        <translation>eine Folge gleicher Bytes ist ausgeschrieben</translation>
    </message>
    <message>
        <source>a run of it goes beyond its block</source>
        <translation>ein Lauf darin reicht über seinen Block hinaus</translation>
    </message>
    <message>
        <source>a run of zeros stands where tissue changes</source>
        <translation>eine Folge von Nullen steht, wo sich das Gewebe ändert</translation>
    </message>
    <message>
        <source>a scan of it does not fit its frame</source>
        <translation>ein Durchgang darin passt nicht zum Bild</translation>
    </message>
    <message>
        <source>a scan that is not what it was said to be</source>
        <translation>ein Scan, der nicht ist, was gesagt war</translation>
    </message>
    <message>
        <source>a segment of it ends before its last pixel</source>
        <translation>ein Segment darin endet vor seinem letzten Pixel</translation>
    </message>
    <message>
        <source>a segment of it goes on behind its last pixel</source>
        <translation>ein Segment darin geht hinter seinem letzten Pixel weiter</translation>
    </message>
    <message>
        <source>a sequence holds %1 where an item should begin</source>
        <translation>eine Sequenz enthält %1, wo ein Element beginnen sollte</translation>
    </message>
    <message>
        <source>a sequence of bytes is too short</source>
        <translation>eine Folge von Bytes ist zu kurz</translation>
    </message>
    <message>
        <source>a single slice</source>
        <translation>eine einzelne Schicht</translation>
    </message>
    <message>
        <source>a slice is missing</source>
        <translation>eine Schicht fehlt</translation>
    </message>
    <message>
        <source>a slice lies %1 mm from an even grid; the slices are taken as even</source>
        <translation>eine Schicht liegt %1 mm neben einem gleichmäßigen Raster; die Schichten werden als gleichmäßig genommen</translation>
    </message>
    <message>
        <source>a slice of more than 65535 pixels has no place in a DICOM file</source>
        <translation>eine Schicht von mehr als 65535 Pixeln hat in einer DICOM-Datei keinen Platz</translation>
    </message>
    <message>
        <source>a table gives its values (Modality LUT Sequence), which this version cannot read</source>
        <translation>eine Tabelle gibt seine Werte an (Modality LUT Sequence), die diese Version nicht lesen kann</translation>
    </message>
    <message>
        <source>a text in it is no line</source>
        <translation>ein Text darin ist keine Zeile</translation>
    </message>
    <message>
        <source>a text or a sequence of bytes in it is too long, or none</source>
        <translation>ein Text oder eine Folge von Bytes darin ist zu lang oder fehlt</translation>
    </message>
    <message>
        <source>a tile keeps a render node busy for longer than it needs to start: %1, %2</source>
        <translation>eine Kachel beschäftigt einen Render-Rechner länger, als er zum Anlaufen braucht: %1, %2</translation>
    </message>
    <message>
        <source>a tile of it was not what this machine found when it did it again</source>
        <translation>eine seiner Kacheln war nicht, was dieser Rechner beim Nachrechnen fand</translation>
    </message>
    <message>
        <source>a tile's result was refused: %1</source>
        <translation>das Ergebnis einer Kachel wurde abgelehnt: %1</translation>
    </message>
    <message>
        <source>about %1 to ±%2</source>
        <translation>etwa %1 bis ±%2</translation>
    </message>
    <message>
        <source>above %1 and at most %2</source>
        <translation>über %1 und höchstens %2</translation>
    </message>
    <message>
        <source>above %1 and below %2</source>
        <translation>über %1 und unter %2</translation>
    </message>
    <message>
        <source>acquisition %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>all lights are hidden from the camera</source>
        <translation>alle Lichter sind vor der Kamera verborgen</translation>
    </message>
    <message>
        <source>all parts are of the same material</source>
        <translation>alle Teile sind aus demselben Material</translation>
    </message>
    <message>
        <source>an OpenEXR environment image, which then lights the scan</source>
        <translation>ein OpenEXR-Umgebungsbild, das dann die Aufnahme beleuchtet</translation>
    </message>
    <message>
        <source>an area has at least three corners</source>
        <translation>eine Fläche hat mindestens drei Ecken</translation>
    </message>
    <message>
        <source>an earlier coding</source>
        <translation>eine frühere Kodierung</translation>
    </message>
    <message>
        <source>an ellipse has two half axes</source>
        <translation>eine Ellipse hat zwei Halbachsen</translation>
    </message>
    <message>
        <source>an image of %1 x %2 pixels needs %3 of memory, %4 are free</source>
        <translation>ein Bild von %1 x %2 Pixeln braucht %3 Speicher, %4 sind frei</translation>
    </message>
    <message>
        <source>an image was damaged on its way from the device</source>
        <translation>ein Bild ist auf dem Weg vom Gerät zerrissen</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation><numerusform>und %n weitere</numerusform><numerusform>und %n weitere</numerusform></translation>
    </message>
    <message>
        <source>another image has taken its place</source>
        <translation>ein anderes Bild ist an seine Stelle getreten</translation>
    </message>
    <message>
        <source>another image is being rendered</source>
        <translation>ein anderes Bild wird gerade gemacht</translation>
    </message>
    <message>
        <source>another program has the GPU to itself, or nobody may compute on it</source>
        <translation>ein anderes Programm hat die GPU für sich allein, oder niemand darf auf ihr rechnen</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at least %1 % of the tissue not sampled yet</source>
        <translation>mindestens %1 % des Gewebes noch nicht abgetastet</translation>
    </message>
    <message>
        <source>at least %1 and below %2</source>
        <translation>mindestens %1 und unter %2</translation>
    </message>
    <message>
        <source>at least one node is needed</source>
        <translation>mindestens eine Stützstelle ist nötig</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>at most %1: thinner than this scan can tell</source>
        <translation>höchstens %1: dünner, als diese Aufnahme erkennen lässt</translation>
    </message>
    <message>
        <source>at this gradient factor no edge is ever steep enough</source>
        <translation>bei diesem Gradientenfaktor ist keine Kante je steil genug</translation>
    </message>
    <message>
        <source>b %1</source>
        <translation>b %1</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>behind %1 mm of tissue</source>
        <translation>hinter %1 mm Gewebe</translation>
    </message>
    <message>
        <source>belongs to a volume of another size</source>
        <translation>gehört zu einem Volumen anderer Größe</translation>
    </message>
    <message>
        <source>beside the eye</source>
        <translation>neben dem Auge</translation>
    </message>
    <message>
        <source>between its segments lie bytes that belong to none</source>
        <translation>zwischen seinen Segmenten liegen Bytes, die zu keinem gehören</translation>
    </message>
    <message>
        <source>biased</source>
        <translation>verzerrt</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>weichgezeichnet</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>bones cannot be told from the rest</source>
        <translation>Knochen sind nicht vom Übrigen zu unterscheiden</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geb. %1</translation>
    </message>
    <message>
        <source>box of %1 x %2 x %3 mm</source>
        <translation>Quader von %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>bytes are left over behind its last pixel</source>
        <translation>hinter dem letzten Pixel sind Bytes übrig</translation>
    </message>
    <message>
        <source>can be shown</source>
        <translation>kann gezeigt werden</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>clipping</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>closing the previous series</source>
        <translation>die Serie davor wird geschlossen</translation>
    </message>
    <message>
        <source>comparing slices at the same place</source>
        <translation>Schichten an gleicher Stelle werden verglichen</translation>
    </message>
    <message>
        <source>comparison: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>connections lost: %1</source>
        <translation>verlorene Verbindungen: %1</translation>
    </message>
    <message>
        <source>contrast</source>
        <translation>Kontrastmittel</translation>
    </message>
    <message>
        <source>copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>cut: %1</source>
        <translation>Schnitt: %1</translation>
    </message>
    <message>
        <source>denoised: 95 % of the tissue within ±%1 levels, noise included</source>
        <translation>entrauscht: 95 % des Gewebes innerhalb ±%1 Stufen, Rauschen inbegriffen</translation>
    </message>
    <message>
        <source>denoised: how much is not known yet</source>
        <translation>entrauscht: wie sehr ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>denoising the scan</source>
        <translation>die Aufnahme wird entrauscht</translation>
    </message>
    <message>
        <source>depth of field</source>
        <translation>Tiefenschärfe</translation>
    </message>
    <message>
        <source>depth of light ±%1</source>
        <translation>Tiefe des Lichts ±%1</translation>
    </message>
    <message>
        <source>detail below %1 % contrast may be missing</source>
        <translation>Einzelheiten unter %1 % Kontrast können fehlen</translation>
    </message>
    <message>
        <source>directed scattering</source>
        <translation>gerichtete Streuung</translation>
    </message>
    <message>
        <source>divided</source>
        <translation>geteilt</translation>
    </message>
    <message>
        <source>duplicate slice position</source>
        <translation>doppelte Schichtposition</translation>
    </message>
    <message>
        <source>each iteration blurred</source>
        <translation>jeder Durchgang verwischt</translation>
    </message>
    <message>
        <source>echo %1</source>
        <translation>Echo %1</translation>
    </message>
    <message>
        <source>edges ±%1</source>
        <translation>Ränder ±%1</translation>
    </message>
    <message>
        <source>efficiency %1 %</source>
        <translation>Wirkungsgrad %1 %</translation>
    </message>
    <message>
        <source>element %1 has no length</source>
        <translation>Element %1 hat keine Länge</translation>
    </message>
    <message>
        <source>element %1 is longer than the file</source>
        <translation>Element %1 ist länger als die Datei</translation>
    </message>
    <message>
        <source>element %1 should hold %2 bytes, but only %3 are left in the file</source>
        <translation>Element %1 soll %2 Bytes enthalten, aber in der Datei sind nur noch %3</translation>
    </message>
    <message>
        <source>emission</source>
        <translation>Eigenleuchten</translation>
    </message>
    <message>
        <source>ended before the first sample: nothing was written</source>
        <translation>vor der ersten Abtastung beendet: nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>every light is best found by aiming at it</source>
        <translation>jedes Licht wird am besten durch Zielen gefunden</translation>
    </message>
    <message>
        <source>everything is shown</source>
        <translation>alles wird gezeigt</translation>
    </message>
    <message>
        <source>fast filter</source>
        <translation>schneller Filter</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>fine detail may be missing</source>
        <translation>feine Einzelheiten können fehlen</translation>
    </message>
    <message>
        <source>for %1 voxels (%2)</source>
        <translation>für %1 Voxel (%2)</translation>
    </message>
    <message>
        <source>for highlights, which cannot show: could be left out</source>
        <translation>für Glanzlichter, die nicht zu sehen sein können: könnte wegbleiben</translation>
    </message>
    <message>
        <source>for images that come from the GPU</source>
        <translation>für Bilder, die von der GPU kommen</translation>
    </message>
    <message>
        <source>for its voxels (%1)</source>
        <translation>für ihre Voxel (%1)</translation>
    </message>
    <message>
        <source>for the scene</source>
        <translation>für die Szene</translation>
    </message>
    <message>
        <source>for the scene: %1</source>
        <translation>für die Szene: %1</translation>
    </message>
    <message>
        <source>for the scene: %1, since others use this render node, too</source>
        <translation>für die Szene: %1, da auch andere diesen Render-Rechner benutzen</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>from behind</source>
        <translation>von hinten</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>front and back</source>
        <translation>vorn und hinten</translation>
    </message>
    <message>
        <source>ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>goes with a gradient only, not with an image</source>
        <translation>passt nur zu einem Verlauf, nicht zu einem Bild</translation>
    </message>
    <message>
        <source>grid ±%1</source>
        <translation>Gitter ±%1</translation>
    </message>
    <message>
        <source>half of the bones lie more than %1 mm from their mirror image: this body is not symmetric</source>
        <translation>die Hälfte der Knochen mehr als %1 mm neben ihrem Spiegelbild liegt: dieser Körper ist nicht symmetrisch</translation>
    </message>
    <message>
        <source>hand ±%1</source>
        <translation>Hand ±%1</translation>
    </message>
    <message>
        <source>has more than %1 holes</source>
        <translation>hat mehr als %1 Lücken</translation>
    </message>
    <message>
        <source>has more than %1 measurements</source>
        <translation>hat mehr als %1 Messungen</translation>
    </message>
    <message>
        <source>has more than %1 styles</source>
        <translation>hat mehr als %1 Darstellungen</translation>
    </message>
    <message>
        <source>has more than 1000 points</source>
        <translation>hat mehr als 1000 Punkte</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>hat keine Punkte</translation>
    </message>
    <message>
        <source>has points that do not ascend</source>
        <translation>hat Punkte, die nicht aufsteigen</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>head and feet</source>
        <translation>Kopf und Füße</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>hidden parts</source>
        <translation>ausgeblendete Teile</translation>
    </message>
    <message>
        <source>hiding the table</source>
        <translation>der Tisch wird ausgeblendet</translation>
    </message>
    <message>
        <source>highHu must lie above lowHu</source>
        <translation>highHu muss über lowHu liegen</translation>
    </message>
    <message>
        <source>highlights</source>
        <translation>Glanzlichter</translation>
    </message>
    <message>
        <source>highlights or directed scattering are sharper than the lights</source>
        <translation>Glanzlichter oder gerichtete Streuung sind schärfer als die Lichter</translation>
    </message>
    <message>
        <source>holds "%1", which is no number</source>
        <translation>enthält „%1“, was keine Zahl ist</translation>
    </message>
    <message>
        <source>holds %1, each number must be %2</source>
        <translation>enthält %1, erlaubt ist für jede Zahl: %2</translation>
    </message>
    <message>
        <source>holds more than %1 values</source>
        <translation>enthält mehr als %1 Werte</translation>
    </message>
    <message>
        <source>holds points of %1 numbers, and one is not whole</source>
        <translation>enthält Punkte zu %1 Zahlen, und einer ist nicht vollständig</translation>
    </message>
    <message>
        <source>holds too few numbers</source>
        <translation>enthält zu wenige Zahlen</translation>
    </message>
    <message>
        <source>host or host:port</source>
        <translation>Rechner oder Rechner:Port</translation>
    </message>
    <message>
        <source>how long it takes is not known yet</source>
        <translation>wie lange es dauert, ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>how much is not known yet</source>
        <translation>wie viel, ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>implant</source>
        <translation>Implantat</translation>
    </message>
    <message>
        <source>implants are guessed by the density of metal: check them; fillings of teeth and undiluted medium may be among them</source>
        <translation>Implantate sind nach der Dichte von Metall geraten: prüfen Sie sie; Zahnfüllungen und unverdünntes Kontrastmittel können darunter sein</translation>
    </message>
    <message>
        <source>implants cannot be found, because %1</source>
        <translation>Implantate lassen sich nicht finden, weil %1</translation>
    </message>
    <message>
        <source>in at most %1 % of the tissue</source>
        <translation>in höchstens %1 % des Gewebes</translation>
    </message>
    <message>
        <source>in the region ±%1 (95 % of the tissue)</source>
        <translation>im Bereich ±%1 (95 % des Gewebes)</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>incomplete?</source>
        <translation>unvollständig?</translation>
    </message>
    <message>
        <source>is "%1", must be "%2"</source>
        <translation>ist „%1“, muss „%2“ sein</translation>
    </message>
    <message>
        <source>is %1, must be %2</source>
        <translation>ist %1, erlaubt ist: %2</translation>
    </message>
    <message>
        <source>is %1, this program reads version 1</source>
        <translation>ist %1, dieses Programm liest Version 1</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is no JSON that can be read (%1)</source>
        <translation>ist kein lesbares JSON (%1)</translation>
    </message>
    <message>
        <source>is no covariance: some direction has a negative variance</source>
        <translation>ist keine Kovarianz: In einer Richtung ist die Varianz negativ</translation>
    </message>
    <message>
        <source>is no direction: it has no length</source>
        <translation>ist keine Richtung: Sie hat keine Länge</translation>
    </message>
    <message>
        <source>is no direction: it needs three finite numbers</source>
        <translation>ist keine Richtung: Sie braucht drei endliche Zahlen</translation>
    </message>
    <message>
        <source>is no direction: its length must be from 1e-100 to 1e+100</source>
        <translation>ist keine Richtung: Ihre Länge muss von 1e-100 bis 1e+100 sein</translation>
    </message>
    <message>
        <source>is no field here</source>
        <translation>ist hier kein Feld</translation>
    </message>
    <message>
        <source>is no unit vector</source>
        <translation>ist kein Einheitsvektor</translation>
    </message>
    <message>
        <source>is the id of two measurements</source>
        <translation>ist die Kennung zweier Messungen</translation>
    </message>
    <message>
        <source>is the name of two styles</source>
        <translation>ist der Name zweier Darstellungen</translation>
    </message>
    <message>
        <source>is the second environment, a scene has at most one</source>
        <translation>ist die zweite Umgebung, eine Szene hat höchstens eine</translation>
    </message>
    <message>
        <source>is too large a number</source>
        <translation>ist eine zu große Zahl</translation>
    </message>
    <message>
        <source>is too long for a volume property</source>
        <translation>ist zu lang für eine Volumeneigenschaft</translation>
    </message>
    <message>
        <source>is written twice in the same object</source>
        <translation>steht zweimal in demselben Objekt</translation>
    </message>
    <message>
        <source>it answered a lease that it was not given</source>
        <translation>er hat Arbeit beantwortet, die ihm nicht gegeben war</translation>
    </message>
    <message>
        <source>it cannot be unpacked (%1)</source>
        <translation>sie lässt sich nicht entpacken (%1)</translation>
    </message>
    <message>
        <source>it does not begin as a JPEG image</source>
        <translation>es beginnt nicht wie ein JPEG-Bild</translation>
    </message>
    <message>
        <source>it does not say how it lies in the patient</source>
        <translation>sie sagt nicht, wie sie im Patienten liegt</translation>
    </message>
    <message>
        <source>it does not say how much memory it has, and is broken or lost</source>
        <translation>es nennt seinen Speicher nicht und ist defekt oder verloren</translation>
    </message>
    <message>
        <source>it does not say its modality</source>
        <translation>sie nennt ihre Modalität nicht</translation>
    </message>
    <message>
        <source>it does not say plainly where its voxels begin</source>
        <translation>sie sagt nicht eindeutig, wo ihre Voxel beginnen</translation>
    </message>
    <message>
        <source>it does not say the order of its bytes</source>
        <translation>sie sagt die Reihenfolge ihrer Bytes nicht</translation>
    </message>
    <message>
        <source>it ends after its header</source>
        <translation>sie endet nach ihrem Kopf</translation>
    </message>
    <message>
        <source>it ends before its last pixel</source>
        <translation>es endet vor seinem letzten Pixel</translation>
    </message>
    <message>
        <source>it ends in the middle of an element</source>
        <translation>sie endet mitten in einem Element</translation>
    </message>
    <message>
        <source>it ends inside the compressed image</source>
        <translation>sie endet innerhalb des komprimierten Bildes</translation>
    </message>
    <message>
        <source>it ends without its end marker</source>
        <translation>es endet ohne Endemarke</translation>
    </message>
    <message>
        <source>it has more than %1 labels</source>
        <translation>sie hat mehr als %1 Labels</translation>
    </message>
    <message>
        <source>it has not been heard of for 10 seconds</source>
        <translation>von ihm ist seit 10 Sekunden nichts zu hören</translation>
    </message>
    <message>
        <source>it has two frame headers</source>
        <translation>es hat zwei Bildköpfe</translation>
    </message>
    <message>
        <source>it holds %1 frames in one file, and does not say where they lie</source>
        <translation>sie enthält %1 Einzelbilder in einer Datei und sagt nicht, wo sie liegen</translation>
    </message>
    <message>
        <source>it holds %1 segments instead of %2</source>
        <translation>es enthält %1 Segmente statt %2</translation>
    </message>
    <message>
        <source>it holds a marker where none belongs</source>
        <translation>es enthält eine Marke, wo keine hingehört</translation>
    </message>
    <message>
        <source>it holds a value that its samples cannot have</source>
        <translation>es enthält einen Wert, den seine Abtastungen nicht haben können</translation>
    </message>
    <message>
        <source>it holds bits that are no code</source>
        <translation>es enthält Bits, die kein Code sind</translation>
    </message>
    <message>
        <source>it holds fewer pixels than its size of %1 x %2 says</source>
        <translation>sie enthält weniger Pixel, als ihre Größe von %1 x %2 besagt</translation>
    </message>
    <message>
        <source>it holds more restart markers than pixels</source>
        <translation>es enthält mehr Neustartmarken als Pixel</translation>
    </message>
    <message>
        <source>it holds more than %1 elements, items, fragments and values</source>
        <translation>sie enthält mehr als %1 Elemente, Einträge, Stücke und Werte</translation>
    </message>
    <message>
        <source>it holds no image</source>
        <translation>es enthält kein Bild</translation>
    </message>
    <message>
        <source>it holds no label map</source>
        <translation>er enthält keine Labelkarte</translation>
    </message>
    <message>
        <source>it holds no map</source>
        <translation>sie enthält keine Tabelle</translation>
    </message>
    <message>
        <source>it holds pixels twice, as floating-point numbers and otherwise</source>
        <translation>sie enthält Pixel zweimal, als Gleitkommazahlen und anders</translation>
    </message>
    <message>
        <source>it holds several values for each place</source>
        <translation>sie enthält mehrere Werte für jede Stelle</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>sie ist eine Verknüpfung</translation>
    </message>
    <message>
        <source>it is an archive within the archive</source>
        <translation>sie ist ein Archiv im Archiv</translation>
    </message>
    <message>
        <source>it is called as the slices beside it, but holds no DICOM</source>
        <translation>sie heißt wie die Schichten daneben, enthält aber kein DICOM</translation>
    </message>
    <message>
        <source>it is divided into more than %1 blocks</source>
        <translation>es ist in mehr als %1 Blöcke geteilt</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>sie ist leer</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>sie ist nicht mehr da</translation>
    </message>
    <message>
        <source>it is longer than such a message is</source>
        <translation>sie ist länger, als eine solche Nachricht ist</translation>
    </message>
    <message>
        <source>it is no JPEG 2000 codestream</source>
        <translation>es ist kein JPEG-2000-Datenstrom</translation>
    </message>
    <message>
        <source>it is no grey image of at most 16 bits</source>
        <translation>es ist kein Graustufenbild mit höchstens 16 Bit</translation>
    </message>
    <message>
        <source>it is no message of PD-Render's</source>
        <translation>das ist keine Nachricht von PD-Render</translation>
    </message>
    <message>
        <source>it is not needed any more</source>
        <translation>er wird nicht mehr gebraucht</translation>
    </message>
    <message>
        <source>it is not of the size that the file's header says</source>
        <translation>es hat nicht die Größe, die der Kopf der Datei nennt</translation>
    </message>
    <message>
        <source>it is of another scene</source>
        <translation>es gehört zu einer anderen Szene</translation>
    </message>
    <message>
        <source>it is shorter than its header</source>
        <translation>es ist kürzer als sein Kopf</translation>
    </message>
    <message>
        <source>it is too long from somebody who is not known yet</source>
        <translation>sie ist zu lang von jemandem, der noch nicht bekannt ist</translation>
    </message>
    <message>
        <source>it is too short for its %1 x %2 x %3 voxels</source>
        <translation>sie ist zu kurz für ihre %1 x %2 x %3 Voxel</translation>
    </message>
    <message>
        <source>it marks no voxel</source>
        <translation>sie markiert kein Voxel</translation>
    </message>
    <message>
        <source>it said goodbye</source>
        <translation>er hat sich verabschiedet</translation>
    </message>
    <message>
        <source>it sends results that nobody asked it for</source>
        <translation>er schickt Ergebnisse, um die ihn niemand gebeten hat</translation>
    </message>
    <message>
        <source>it speaks another version of the protocol: %1</source>
        <translation>er spricht eine andere Version des Protokolls: %1</translation>
    </message>
    <message>
        <source>it states %1 frames in one file; from 1 to %2 can be read</source>
        <translation>sie gibt %1 Einzelbilder in einer Datei an; lesbar sind 1 bis %2</translation>
    </message>
    <message>
        <source>it states %1 frames, and describes another number of them</source>
        <translation>sie gibt %1 Einzelbilder an und beschreibt eine andere Anzahl</translation>
    </message>
    <message>
        <source>it states an impossible precision</source>
        <translation>es nennt eine unmögliche Genauigkeit</translation>
    </message>
    <message>
        <source>it states an impossible size of %1 x %2 pixels</source>
        <translation>sie nennt eine unmögliche Größe von %1 x %2 Pixeln</translation>
    </message>
    <message>
        <source>it states its lengths in an unknown unit</source>
        <translation>sie nennt ihre Längen in einer unbekannten Einheit</translation>
    </message>
    <message>
        <source>it states two places in the patient (sform and qform) that differ by up to %1 mm</source>
        <translation>sie nennt zwei Lagen im Patienten (sform und qform), die sich um bis zu %1 mm unterscheiden</translation>
    </message>
    <message>
        <source>it unpacks to more than %1</source>
        <translation>entpackt ist sie größer als %1</translation>
    </message>
    <message>
        <source>its GPU has failed, and its CPU goes on: %1</source>
        <translation>seine GPU hat versagt, und seine CPU macht weiter: %1</translation>
    </message>
    <message>
        <source>its certificate has expired</source>
        <translation>sein Zertifikat ist abgelaufen</translation>
    </message>
    <message>
        <source>its certificate is not believed: %1</source>
        <translation>seinem Zertifikat wird nicht geglaubt: %1</translation>
    </message>
    <message>
        <source>its certificate is not that of a %1</source>
        <translation>sein Zertifikat ist nicht das eines %1</translation>
    </message>
    <message>
        <source>its certificate, %1, is revoked</source>
        <translation>sein Zertifikat, %1, ist gesperrt</translation>
    </message>
    <message>
        <source>its compressed image is not made of fragments</source>
        <translation>ihr komprimiertes Bild besteht nicht aus Stücken</translation>
    </message>
    <message>
        <source>its decoder says "%1"</source>
        <translation>sein Decoder meldet „%1“</translation>
    </message>
    <message>
        <source>its deflated content is damaged, or larger than %1 MB</source>
        <translation>ihr gepackter Inhalt ist beschädigt oder größer als %1 MB</translation>
    </message>
    <message>
        <source>its frame header is too short</source>
        <translation>sein Bildkopf ist zu kurz</translation>
    </message>
    <message>
        <source>its frames are not evenly spaced</source>
        <translation>ihre Bilder haben keinen gleichmäßigen Abstand</translation>
    </message>
    <message>
        <source>its frames do not say where they lie in the patient</source>
        <translation>ihre Bilder sagen nicht, wo sie im Patienten liegen</translation>
    </message>
    <message>
        <source>its frames lie in several directions, or their pixels differ in size</source>
        <translation>ihre Bilder liegen in mehreren Richtungen, oder ihre Pixel sind verschieden groß</translation>
    </message>
    <message>
        <source>its grid has %1 x %2 x %3 voxels</source>
        <translation>ihr Gitter hat %1 x %2 x %3 Voxel</translation>
    </message>
    <message>
        <source>its header cannot be read</source>
        <translation>ihr Kopf kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>its header has no end</source>
        <translation>ihr Kopf hat kein Ende</translation>
    </message>
    <message>
        <source>its header is broken</source>
        <translation>sein Kopf ist fehlerhaft</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>ihr Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>its header places segments where none can be</source>
        <translation>sein Kopf legt Segmente dorthin, wo keine sein können</translation>
    </message>
    <message>
        <source>its header takes more than %1 MB</source>
        <translation>ihr Kopf umfasst mehr als %1 MB</translation>
    </message>
    <message>
        <source>its images differ from this machine's in the last bits: it runs a different build</source>
        <translation>seine Bilder weichen in den letzten Bits von denen dieses Rechners ab: Das Programm dort ist anders gebaut</translation>
    </message>
    <message>
        <source>its label map is of another size</source>
        <translation>ihre Labelkarte hat eine andere Größe</translation>
    </message>
    <message>
        <source>its map has keys that are no numbers, or too many</source>
        <translation>ihre Tabelle hat Schlüssel, die keine Zahlen sind, oder zu viele</translation>
    </message>
    <message>
        <source>its map is damaged, or too deep</source>
        <translation>ihre Tabelle ist beschädigt oder zu tief</translation>
    </message>
    <message>
        <source>its mask holds what is no weight</source>
        <translation>ihre Maske enthält, was kein Gewicht ist</translation>
    </message>
    <message>
        <source>its mask is of another size</source>
        <translation>ihre Maske hat eine andere Größe</translation>
    </message>
    <message>
        <source>its memory is too small: %1 are needed at a time, %2 are free</source>
        <translation>sein Speicher ist zu klein: %1 werden auf einmal gebraucht, %2 sind frei</translation>
    </message>
    <message>
        <source>its messages are laid out in another way</source>
        <translation>seine Nachrichten sind anders aufgebaut</translation>
    </message>
    <message>
        <source>its name leads out of the archive</source>
        <translation>ihr Name führt aus dem Archiv hinaus</translation>
    </message>
    <message>
        <source>its packed part is damaged</source>
        <translation>ihr gepackter Teil ist beschädigt</translation>
    </message>
    <message>
        <source>its pixel format cannot be read (%1 bits allocated, %2 stored, high bit %3)</source>
        <translation>ihr Pixelformat kann nicht gelesen werden (%1 Bit belegt, %2 gespeichert, höchstes Bit %3)</translation>
    </message>
    <message>
        <source>its pixels are coded as %1, which this version cannot read</source>
        <translation>ihre Pixel sind als %1 kodiert, was diese Version nicht lesen kann</translation>
    </message>
    <message>
        <source>its pixels are no segments (%1 bits)</source>
        <translation>ihre Pixel sind keine Segmente (%1 Bit)</translation>
    </message>
    <message>
        <source>its rescale slope or intercept is no usable number</source>
        <translation>Steigung oder Achsenabschnitt ihrer HU-Umrechnung ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>its restart markers are out of order</source>
        <translation>seine Neustartmarken sind nicht in der Reihenfolge</translation>
    </message>
    <message>
        <source>its samples are not the next ones</source>
        <translation>seine Abtastungen sind nicht die nächsten</translation>
    </message>
    <message>
        <source>its samples are there already</source>
        <translation>seine Abtastungen sind schon da</translation>
    </message>
    <message>
        <source>its sequences are nested more than %1 deep</source>
        <translation>ihre Sequenzen sind tiefer als %1-mal verschachtelt</translation>
    </message>
    <message>
        <source>its sums are none</source>
        <translation>seine Summen sind keine</translation>
    </message>
    <message>
        <source>its surroundings are of another size</source>
        <translation>ihre Umgebung hat eine andere Größe</translation>
    </message>
    <message>
        <source>its text is no UTF-8</source>
        <translation>sein Text ist kein UTF-8</translation>
    </message>
    <message>
        <source>its value %1 is no label</source>
        <translation>ihr Wert %1 ist kein Label</translation>
    </message>
    <message>
        <source>its values are no finite numbers</source>
        <translation>ihre Werte sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>its volume is of another size</source>
        <translation>ihr Volumen hat eine andere Größe</translation>
    </message>
    <message>
        <source>its voxels are of a type that is not read</source>
        <translation>ihre Voxel sind von einer Art, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>its voxels are written in a coding that is not read (%1)</source>
        <translation>ihre Voxel sind in einer Kodierung geschrieben, die nicht gelesen wird (%1)</translation>
    </message>
    <message>
        <source>its voxels lie in several files, or outside its folder</source>
        <translation>ihre Voxel liegen in mehreren Dateien oder außerhalb ihres Ordners</translation>
    </message>
    <message>
        <source>kroesMarch knows one event on a path, but the model is %1</source>
        <translation>kroesMarch kennt ein Ereignis je Weg, aber das Modell ist %1</translation>
    </message>
    <message>
        <source>label maps are written to files that end in %1</source>
        <translation>Labelkarten werden in Dateien geschrieben, die auf %1 enden</translation>
    </message>
    <message>
        <source>labels must ascend from 1 on</source>
        <translation>Labels müssen von 1 an aufsteigen</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>links und rechts</translation>
    </message>
    <message>
        <source>left and right, and front and back,</source>
        <translation>links und rechts sowie vorn und hinten</translation>
    </message>
    <message>
        <source>less than 1 ml</source>
        <translation>weniger als 1 ml</translation>
    </message>
    <message>
        <source>light comes from all around</source>
        <translation>Licht kommt von allen Seiten</translation>
    </message>
    <message>
        <source>light crosses tissue on its way</source>
        <translation>Licht geht auf seinem Weg durch Gewebe</translation>
    </message>
    <message>
        <source>light from all around</source>
        <translation>Licht von allen Seiten</translation>
    </message>
    <message>
        <source>light is let through everything, to see what shadows do</source>
        <translation>Licht geht durch alles hindurch, um zu sehen, was Schatten bewirken</translation>
    </message>
    <message>
        <source>light is scattered on from event to event</source>
        <translation>Licht wird von Ereignis zu Ereignis weitergestreut</translation>
    </message>
    <message>
        <source>light paths cut off at their last allowed event</source>
        <translation>Lichtwege, die an ihrem letzten erlaubten Ereignis endeten</translation>
    </message>
    <message>
        <source>lights in view</source>
        <translation>Lichter im Bild</translation>
    </message>
    <message>
        <source>lights with a place</source>
        <translation>Lichter mit einem Ort</translation>
    </message>
    <message>
        <source>lists and objects lie in one another deeper than %1</source>
        <translation>Listen und Objekte liegen tiefer als %1 ineinander</translation>
    </message>
    <message>
        <source>looking for files</source>
        <translation>Dateien werden gesucht</translation>
    </message>
    <message>
        <source>looking for metal</source>
        <translation>Metall wird gesucht</translation>
    </message>
    <message>
        <source>looking for the table</source>
        <translation>der Tisch wird gesucht</translation>
    </message>
    <message>
        <source>looking for vessels</source>
        <translation>Gefäße werden gesucht</translation>
    </message>
    <message>
        <source>lossy</source>
        <translation>verlustbehaftet</translation>
    </message>
    <message>
        <source>lossy?</source>
        <translation>verlustbehaftet?</translation>
    </message>
    <message>
        <source>lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>lungs are in this scan</source>
        <translation>diese Aufnahme zeigt Lungen</translation>
    </message>
    <message>
        <source>march of 3 voxels</source>
        <translation>Schritte von 3 Voxeln</translation>
    </message>
    <message>
        <source>materials of parts</source>
        <translation>Materialien von Teilen</translation>
    </message>
    <message>
        <source>mean kept in single precision: %1</source>
        <translation>Mittelwert in einfacher Genauigkeit geführt: %1</translation>
    </message>
    <message>
        <source>measurements are exported to files that end in .csv or .mrk.json</source>
        <translation>Messungen werden in Dateien exportiert, die auf .csv oder .mrk.json enden</translation>
    </message>
    <message>
        <source>measurements[%1].places[%2].mm lies %3 mm outside the scan</source>
        <translation>measurements[%1].places[%2].mm liegt %3 mm außerhalb der Aufnahme</translation>
    </message>
    <message>
        <source>meetings with tissue above its bound</source>
        <translation>Treffen auf Gewebe über seiner Schranke</translation>
    </message>
    <message>
        <source>mended</source>
        <translation>berichtigt</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>metal is in this body</source>
        <translation>in diesem Körper ist Metall</translation>
    </message>
    <message>
        <source>mirrored bone</source>
        <translation>gespiegelter Knochen</translation>
    </message>
    <message>
        <source>mirrored bone cannot be found, because %1</source>
        <translation>gespiegelter Knochen lässt sich nicht finden, weil %1</translation>
    </message>
    <message>
        <source>mirrored bone is the other side's: half of the bones lie within %1 mm of their mirror image, nine tenths within %2 mm</source>
        <translation>gespiegelter Knochen ist der der anderen Seite: die Hälfte der Knochen liegt höchstens %1 mm neben ihrem Spiegelbild, neun Zehntel höchstens %2 mm</translation>
    </message>
    <message>
        <source>mirroring the bones</source>
        <translation>Knochen werden gespiegelt</translation>
    </message>
    <message>
        <source>missing position data</source>
        <translation>Positionsdaten fehlen</translation>
    </message>
    <message>
        <source>mixed slice orientations</source>
        <translation>verschiedene Schichtrichtungen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>more than half of what is solid is thinner than 20 mm</source>
        <translation>mehr als die Hälfte von allem Festen ist dünner als 20 mm</translation>
    </message>
    <message>
        <source>ms per iteration</source>
        <translation>ms je Iteration</translation>
    </message>
    <message>
        <source>multiple scattering</source>
        <translation>Mehrfachstreuung</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>muscle is guessed by its density, which organs and marrow may have, too</source>
        <translation>Muskel ist nach seiner Dichte geraten, die auch Organe und Mark haben können</translation>
    </message>
    <message>
        <source>must ascend from one to the next</source>
        <translation>muss von einem zum nächsten steigen</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>must be a list [ ... ]</source>
        <translation>muss eine Liste [ ... ] sein</translation>
    </message>
    <message>
        <source>must be a list of 1 to 64 panels</source>
        <translation>muss eine Liste von 1 bis 64 Leuchtflächen sein</translation>
    </message>
    <message>
        <source>must be a list of different texts in quotes</source>
        <translation>muss eine Liste verschiedener Texte in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to 18446744073709551615</source>
        <translation>muss eine ganze Zahl von 0 bis 18446744073709551615 sein</translation>
    </message>
    <message>
        <source>must be an object { ... }</source>
        <translation>muss ein Objekt { ... } sein</translation>
    </message>
    <message>
        <source>must be of %1, with commas between, not "%2"</source>
        <translation>muss aus %1 bestehen, mit Kommas dazwischen, nicht „%2“</translation>
    </message>
    <message>
        <source>must be one of: %1</source>
        <translation>muss eines davon sein: %1</translation>
    </message>
    <message>
        <source>must be three whole numbers [x, y, z]</source>
        <translation>müssen drei ganze Zahlen [x, y, z] sein</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>must be two whole numbers [lowest, highest]</source>
        <translation>müssen zwei ganze Zahlen [niedrigste, höchste] sein</translation>
    </message>
    <message>
        <source>must begin with the lower value</source>
        <translation>muss mit dem kleineren Wert beginnen</translation>
    </message>
    <message>
        <source>must differ from eyeMm</source>
        <translation>muss sich von eyeMm unterscheiden</translation>
    </message>
    <message>
        <source>must have %1 places</source>
        <translation>muss %1 Orte haben</translation>
    </message>
    <message>
        <source>must have %1 to %2 places</source>
        <translation>muss %1 bis %2 Punkte haben</translation>
    </message>
    <message>
        <source>must have three points at least</source>
        <translation>muss mindestens drei Punkte haben</translation>
    </message>
    <message>
        <source>must lie above lowMm along every axis</source>
        <translation>muss entlang jeder Achse über lowMm liegen</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>darf nicht leer sein</translation>
    </message>
    <message>
        <source>must not be longer than %1 bytes</source>
        <translation>darf nicht länger als %1 Byte sein</translation>
    </message>
    <message>
        <source>must not lie along the view</source>
        <translation>darf nicht entlang der Blickrichtung liegen</translation>
    </message>
    <message>
        <source>must not point along the normal</source>
        <translation>darf nicht entlang der Normalen zeigen</translation>
    </message>
    <message>
        <source>needed, because</source>
        <translation>gebraucht, weil</translation>
    </message>
    <message>
        <source>needs either a DICOM folder (dicom) or a raw file (raw)</source>
        <translation>braucht entweder einen DICOM-Ordner (dicom) oder eine Rohdatei (raw)</translation>
    </message>
    <message>
        <source>needs either a label map (labels) or a rule that finds parts (find)</source>
        <translation>braucht entweder eine Labelkarte (labels) oder eine Regel, die Teile findet (find)</translation>
    </message>
    <message>
        <source>neither this program nor the driver has code for the GPU (%1)</source>
        <translation>weder dieses Programm noch der Treiber hat Code für die GPU (%1)</translation>
    </message>
    <message>
        <source>no HU</source>
        <translation>keine HU</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>no bone of 1 ml that one side has is lacking on the other</source>
        <translation>kein Knochen von 1 ml, den eine Seite hat, auf der anderen fehlt</translation>
    </message>
    <message>
        <source>no bones are in this scan</source>
        <translation>in dieser Aufnahme keine Knochen sind</translation>
    </message>
    <message>
        <source>no contrast medium is found in the blood</source>
        <translation>im Blut kein Kontrastmittel gefunden wird</translation>
    </message>
    <message>
        <source>no contrast was found in the blood</source>
        <translation>im Blut wurde kein Kontrastmittel gefunden</translation>
    </message>
    <message>
        <source>no edge within %1 mm</source>
        <translation>kein Rand im Umkreis von %1 mm</translation>
    </message>
    <message>
        <source>no edge: the scanner measured nothing on one side</source>
        <translation>kein Rand: auf einer Seite hat der Scanner nichts gemessen</translation>
    </message>
    <message>
        <source>no edge: the sides differ by less than five times the noise</source>
        <translation>kein Rand: die Seiten unterscheiden sich um weniger als das Fünffache des Rauschens</translation>
    </message>
    <message>
        <source>no edge: too close to the border of the scan</source>
        <translation>kein Rand: zu nah an der Grenze der Aufnahme</translation>
    </message>
    <message>
        <source>no edge: too few voxels on either side to know the noise</source>
        <translation>kein Rand: zu wenige Voxel auf beiden Seiten, um das Rauschen zu kennen</translation>
    </message>
    <message>
        <source>no image, but %1</source>
        <translation>kein Bild, sondern %1</translation>
    </message>
    <message>
        <source>no image, but another kind of object</source>
        <translation>kein Bild, sondern ein anderes Objekt</translation>
    </message>
    <message>
        <source>no light is a rectangle or a sphere</source>
        <translation>kein Licht ist ein Rechteck oder eine Kugel</translation>
    </message>
    <message>
        <source>no light shines</source>
        <translation>kein Licht leuchtet</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>no lungs are in this scan</source>
        <translation>diese Aufnahme zeigt keine Lungen</translation>
    </message>
    <message>
        <source>no metal is in this body</source>
        <translation>in diesem Körper ist kein Metall</translation>
    </message>
    <message>
        <source>no opaque tissue that the volume holds emits light</source>
        <translation>kein deckendes Gewebe im Volumen leuchtet selbst</translation>
    </message>
    <message>
        <source>no part of the body has a material of its own</source>
        <translation>kein Körperteil hat ein eigenes Material</translation>
    </message>
    <message>
        <source>no point of the curve emits light</source>
        <translation>kein Punkt der Kurve leuchtet selbst</translation>
    </message>
    <message>
        <source>no point of the curve is specular</source>
        <translation>kein Punkt der Kurve glänzt</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund genannt</translation>
    </message>
    <message>
        <source>no rectangle and no sphere shines</source>
        <translation>kein Rechteck und keine Kugel leuchtet</translation>
    </message>
    <message>
        <source>no series here can be loaded</source>
        <translation>keine Serie hier kann geladen werden</translation>
    </message>
    <message>
        <source>no series here can be loaded: %1</source>
        <translation>keine Serie hier kann geladen werden: %1</translation>
    </message>
    <message>
        <source>no such tile is asked for</source>
        <translation>nach dieser Kachel ist nicht gefragt</translation>
    </message>
    <message>
        <source>no tissue at this point: %1 % of the light passes</source>
        <translation>kein Gewebe an dieser Stelle: %1 % des Lichts gehen hindurch</translation>
    </message>
    <message>
        <source>no tissue in the region</source>
        <translation>kein Gewebe im Bereich</translation>
    </message>
    <message>
        <source>no tissue is opaque at the values that the volume holds</source>
        <translation>bei den Werten im Volumen ist kein Gewebe deckend</translation>
    </message>
    <message>
        <source>no tissue scatters light</source>
        <translation>kein Gewebe streut Licht</translation>
    </message>
    <message>
        <source>no voxel's centre lies in this region</source>
        <translation>in diesem Bereich liegt kein Mittelpunkt eines Voxels</translation>
    </message>
    <message>
        <source>nobody can be listened to there: %1</source>
        <translation>dort kann nicht auf andere gewartet werden: %1</translation>
    </message>
    <message>
        <source>none of the %1 files is a DICOM image</source>
        <translation>keine der %1 Dateien ist ein DICOM-Bild</translation>
    </message>
    <message>
        <source>not a CT volume</source>
        <translation>kein CT-Volumen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>not known without the scan</source>
        <translation>ohne die Aufnahme nicht bekannt</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>noch nicht bekannt</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>not saved, because %1</source>
        <translation>nicht gesichert, denn %1</translation>
    </message>
    <message>
        <source>not shown here</source>
        <translation>hier nicht gezeigt</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>nothing can be peeled off</source>
        <translation>nichts kann abgeschält werden</translation>
    </message>
    <message>
        <source>nothing in the scan is as dense as bone</source>
        <translation>nichts im Scan ist so dicht wie Knochen</translation>
    </message>
    <message>
        <source>nothing is as thick as 20 mm</source>
        <translation>nichts ist 20 mm dick</translation>
    </message>
    <message>
        <source>nothing is cut away</source>
        <translation>nichts ist weggeschnitten</translation>
    </message>
    <message>
        <source>nothing says where each of its %1 compressed frames begins</source>
        <translation>nirgends steht, wo jedes ihrer %1 komprimierten Einzelbilder beginnt</translation>
    </message>
    <message>
        <source>now, %1</source>
        <translation>jetzt, %1</translation>
    </message>
    <message>
        <source>number %1 in the line, since others use this render node</source>
        <translation>Nummer %1 in der Schlange, da andere diesen Render-Rechner benutzen</translation>
    </message>
    <message>
        <source>on an image of %1 × %2 pixels on the CPU (%3)</source>
        <translation>an einem Bild von %1 × %2 Pixeln auf der CPU (%3)</translation>
    </message>
    <message>
        <source>one more event</source>
        <translation>ein Ereignis mehr</translation>
    </message>
    <message>
        <source>one of its code tables has more codes than there can be</source>
        <translation>eine seiner Codetabellen hat mehr Codes, als es geben kann</translation>
    </message>
    <message>
        <source>one of its code tables is cut off</source>
        <translation>eine seiner Codetabellen ist abgeschnitten</translation>
    </message>
    <message>
        <source>one of its quantisation tables is cut off</source>
        <translation>eine seiner Quantisierungstabellen ist abgeschnitten</translation>
    </message>
    <message>
        <source>one of its segments is longer than the image</source>
        <translation>eines seiner Segmente ist länger als das Bild</translation>
    </message>
    <message>
        <source>one render node has the whole image</source>
        <translation>ein Render-Rechner hat das ganze Bild</translation>
    </message>
    <message>
        <source>only %1 % of the light here stops at one depth, which was taken</source>
        <translation>nur %1 % des Lichts enden hier in einer Tiefe, die genommen wurde</translation>
    </message>
    <message>
        <source>only values in HU can be denoised, and those of this scan are none</source>
        <translation>nur Werte in HU lassen sich entrauschen, und die dieser Aufnahme sind keine</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>other machines are only talked to with certificates</source>
        <translation>mit anderen Rechnern wird nur mit Zertifikaten gesprochen</translation>
    </message>
    <message>
        <source>others on this machine may read or change this key</source>
        <translation>andere auf diesem Rechner dürfen diesen Schlüssel lesen oder ändern</translation>
    </message>
    <message>
        <source>outside the scan</source>
        <translation>außerhalb der Aufnahme</translation>
    </message>
    <message>
        <source>part %1 of %2 is missing of an image that is stored in several files (a concatenation)</source>
        <translation>es fehlt Teil %1 von %2 einer Aufnahme, die in mehreren Dateien liegt (eine Concatenation)</translation>
    </message>
    <message>
        <source>parts of the driver are of different versions: it was updated while the computer ran</source>
        <translation>Teile des Treibers sind verschiedener Version: Er wurde aktualisiert, während der Computer lief</translation>
    </message>
    <message>
        <source>parts that have a name and no voxels: %1</source>
        <translation>Teile mit einem Namen und ohne Voxel: %1</translation>
    </message>
    <message>
        <source>paths have %1 events</source>
        <translation>Wege haben %1 Ereignisse</translation>
    </message>
    <message>
        <source>paths have as many events as they need</source>
        <translation>Wege haben so viele Ereignisse, wie sie brauchen</translation>
    </message>
    <message>
        <source>paths have one event</source>
        <translation>Wege haben ein Ereignis</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>phase g is 0: the same to all sides</source>
        <translation>die Phase g ist 0: nach allen Seiten gleich</translation>
    </message>
    <message>
        <source>phase g is not 0</source>
        <translation>die Phase g ist nicht 0</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>Pixelabstand</translation>
    </message>
    <message>
        <source>places %1 and %2 of the path are too close for how well they are known</source>
        <translation>die Orte %1 und %2 des Wegs liegen zu nah beieinander für das, was man über sie weiß</translation>
    </message>
    <message>
        <source>point in time %1</source>
        <translation>Zeitpunkt %1</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>rays less exact than asked for</source>
        <translation>Strahlen, die weniger genau sind als verlangt</translation>
    </message>
    <message>
        <source>rays outside soft edges</source>
        <translation>Strahlen außerhalb weicher Ränder</translation>
    </message>
    <message>
        <source>rays to the light leave surfaces one voxel out</source>
        <translation>Strahlen zum Licht verlassen Oberflächen ein Voxel weiter außen</translation>
    </message>
    <message>
        <source>rays to the light start at their event</source>
        <translation>Strahlen zum Licht beginnen bei ihrem Ereignis</translation>
    </message>
    <message>
        <source>reading headers</source>
        <translation>Kopfdaten werden gelesen</translation>
    </message>
    <message>
        <source>reading labels</source>
        <translation>Labels werden gelesen</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>Schichten werden gelesen</translation>
    </message>
    <message>
        <source>reading the image</source>
        <translation>das Bild wird gelesen</translation>
    </message>
    <message>
        <source>reading values</source>
        <translation>Werte werden gelesen</translation>
    </message>
    <message>
        <source>rendering the image</source>
        <translation>Das Bild entsteht</translation>
    </message>
    <message>
        <source>rendering the image: %1 samples in %2</source>
        <translation>Das Bild entsteht: %1 Abtastungen in %2</translation>
    </message>
    <message>
        <source>resampled</source>
        <translation>umgerechnet</translation>
    </message>
    <message>
        <source>resampled to the nearest of voxels of %1</source>
        <translation>auf die nächsten von Voxeln von %1 umgerechnet</translation>
    </message>
    <message>
        <source>rest of the body</source>
        <translation>übriger Körper</translation>
    </message>
    <message>
        <source>results that never came: %1</source>
        <translation>ausgebliebene Ergebnisse: %1</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>rounded</source>
        <translation>gerundet</translation>
    </message>
    <message>
        <source>samples are shared out in blocks of 64, and fewer than two are ordered</source>
        <translation>Samples werden in Blöcken zu 64 verteilt, und weniger als zwei sind bestellt</translation>
    </message>
    <message>
        <source>samples left out: infinitely bright</source>
        <translation>Abtastungen weggelassen: unendlich hell</translation>
    </message>
    <message>
        <source>samples left out: negative light</source>
        <translation>Abtastungen weggelassen: negatives Licht</translation>
    </message>
    <message>
        <source>samples left out: not a number</source>
        <translation>Abtastungen weggelassen: keine Zahl</translation>
    </message>
    <message>
        <source>saved, but its bias could not be measured: %1</source>
        <translation>gesichert, aber sein systematischer Fehler ließ sich nicht messen: %1</translation>
    </message>
    <message>
        <source>saves %1</source>
        <translation>spart %1</translation>
    </message>
    <message>
        <source>says it holds %1 values and holds %2</source>
        <translation>nennt %1 Werte und enthält %2</translation>
    </message>
    <message>
        <source>search along scattering</source>
        <translation>Suche entlang der Streuung</translation>
    </message>
    <message>
        <source>selected, %1</source>
        <translation>ausgewählt, %1</translation>
    </message>
    <message>
        <source>selected, %1: %2</source>
        <translation>ausgewählt, %1: %2</translation>
    </message>
    <message>
        <source>separating the body parts</source>
        <translation>Körperteile werden getrennt</translation>
    </message>
    <message>
        <source>several codings</source>
        <translation>mehrere Codierungen</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>skin and muscle cannot be found, because %1</source>
        <translation>Haut und Muskel sind nicht zu finden, weil %1</translation>
    </message>
    <message>
        <source>slice %1 cannot be written</source>
        <translation>Schicht %1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>slices are interpolated across %3 holes, the widest from %1 to %2 mm above the lowest slice; what is measured there is marked</source>
        <translation>Schichten sind über %3 Lücken interpoliert, die weiteste von %1 bis %2 mm über der untersten Schicht; was dort gemessen wird, ist gekennzeichnet</translation>
    </message>
    <message>
        <source>slices are interpolated across a hole from %1 to %2 mm above the lowest slice; what is measured there is marked</source>
        <translation>Schichten sind über eine Lücke von %1 bis %2 mm über der untersten Schicht interpoliert; was dort gemessen wird, ist gekennzeichnet</translation>
    </message>
    <message>
        <source>slices between the scan's own are a cubic's: a choice, and no error of the computing</source>
        <translation>Schichten zwischen denen des Scans sind kubisch interpoliert: eine Wahl, kein Fehler des Rechnens</translation>
    </message>
    <message>
        <source>slices not in line</source>
        <translation>Schichten nicht in einer Linie</translation>
    </message>
    <message>
        <source>slices of different size</source>
        <translation>Schichten verschiedener Größe</translation>
    </message>
    <message>
        <source>something failed for an unknown reason</source>
        <translation>etwas ist aus unbekanntem Grund fehlgeschlagen</translation>
    </message>
    <message>
        <source>something failed unexpectedly: %1</source>
        <translation>etwas ist unerwartet fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>something is missing in it</source>
        <translation>etwas fehlt darin</translation>
    </message>
    <message>
        <source>sorting slices</source>
        <translation>Schichten werden sortiert</translation>
    </message>
    <message>
        <source>spacing or direction changes on the way; a pixel lies up to %1 mm from where the first slice would put it</source>
        <translation>Abstand oder Richtung ändert sich unterwegs; ein Pixel liegt bis zu %1 mm von der Stelle, an die die erste Schicht es setzen würde</translation>
    </message>
    <message>
        <source>stack %1</source>
        <translation>Stapel %1</translation>
    </message>
    <message>
        <source>stopped after %1, with %2 samples</source>
        <translation>angehalten nach %1, mit %2 Abtastungen</translation>
    </message>
    <message>
        <source>such a message goes the other way</source>
        <translation>eine solche Nachricht geht in die andere Richtung</translation>
    </message>
    <message>
        <source>sums along rays: at most ±%1 levels</source>
        <translation>Summen entlang von Strahlen: höchstens ±%1 Stufen</translation>
    </message>
    <message>
        <source>sums of pixels that cannot be unpacked</source>
        <translation>Summen von Pixeln, die nicht entpackt werden können</translation>
    </message>
    <message>
        <source>sums of samples before the first one of a block</source>
        <translation>Summen von Abtastungen vor der ersten eines Blocks</translation>
    </message>
    <message>
        <source>sums that were not to be sent</source>
        <translation>Summen, die nicht gesendet werden sollten</translation>
    </message>
    <message>
        <source>surface reflection</source>
        <translation>Spiegelung an Oberflächen</translation>
    </message>
    <message>
        <source>taken at %1</source>
        <translation>aufgenommen um %1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>target reached (Space: continue)</source>
        <translation>Ziel erreicht (Leertaste: weiter)</translation>
    </message>
    <message>
        <source>target: %1</source>
        <translation>Ziel: %1</translation>
    </message>
    <message>
        <source>the CPU</source>
        <translation>der CPU</translation>
    </message>
    <message>
        <source>the DICOM dictionary is not there, so no file can be read</source>
        <translation>das DICOM-Verzeichnis der Elemente fehlt, so dass keine Datei gelesen werden kann</translation>
    </message>
    <message>
        <source>the GPU %1</source>
        <translation>die GPU %1</translation>
    </message>
    <message>
        <source>the GPU failed (%1)</source>
        <translation>die GPU hat versagt (%1)</translation>
    </message>
    <message>
        <source>the GPU is too old for this program: it is of compute capability %1, %2 or later is needed</source>
        <translation>die GPU ist zu alt für dieses Programm: Sie hat Compute Capability %1, %2 oder neuer ist nötig</translation>
    </message>
    <message>
        <source>the GPU was lost (%1)</source>
        <translation>die GPU ging verloren (%1)</translation>
    </message>
    <message>
        <source>the aperture is 0</source>
        <translation>die Blende ist 0</translation>
    </message>
    <message>
        <source>the archive holds %1 files, more than 100000</source>
        <translation>das Archiv enthält %1 Dateien, mehr als 100000</translation>
    </message>
    <message>
        <source>the archive holds another file of this name</source>
        <translation>das Archiv enthält noch eine Datei dieses Namens</translation>
    </message>
    <message>
        <source>the archive is damaged, or no ZIP archive (%1)</source>
        <translation>das Archiv ist beschädigt oder kein ZIP-Archiv (%1)</translation>
    </message>
    <message>
        <source>the archive is empty</source>
        <translation>das Archiv ist leer</translation>
    </message>
    <message>
        <source>the archive is encrypted</source>
        <translation>das Archiv ist verschlüsselt</translation>
    </message>
    <message>
        <source>the archive would unpack to %1, which is more than 64 GB or 200 times its size</source>
        <translation>das Archiv wäre entpackt %1 groß, mehr als 64 GB oder das 200fache seiner Größe</translation>
    </message>
    <message>
        <source>the axes of the label map lie in one plane</source>
        <translation>die Achsen der Labelkarte liegen in einer Ebene</translation>
    </message>
    <message>
        <source>the axes of the volume are not at right angles</source>
        <translation>die Achsen des Volumens stehen nicht im rechten Winkel</translation>
    </message>
    <message>
        <source>the blood has %1 HU, which marrow has, too</source>
        <translation>das Blut %1 HU hat, die auch Mark hat</translation>
    </message>
    <message>
        <source>the camera sees a light</source>
        <translation>die Kamera sieht ein Licht</translation>
    </message>
    <message>
        <source>the camera sees the environment</source>
        <translation>die Kamera sieht die Umgebung</translation>
    </message>
    <message>
        <source>the certificates cannot be written</source>
        <translation>die Zertifikate können nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the compressed image cannot be decoded</source>
        <translation>das komprimierte Bild kann nicht dekodiert werden</translation>
    </message>
    <message>
        <source>the compressed image is damaged: %1</source>
        <translation>das komprimierte Bild ist beschädigt: %1</translation>
    </message>
    <message>
        <source>the compressed image is damaged: %1 of its pixels hold numbers that %2 bits cannot</source>
        <translation>das komprimierte Bild ist beschädigt: %1 seiner Pixel enthalten Zahlen, für die %2 Bit nicht reichen</translation>
    </message>
    <message>
        <source>the compressed image is damaged: its decoder says "%1"</source>
        <translation>das komprimierte Bild ist beschädigt: Sein Dekoder meldet „%1“</translation>
    </message>
    <message>
        <source>the coordinator gives out leases twice, or more than a node can have</source>
        <translation>der Koordinator vergibt Aufträge doppelt oder mehr, als ein Rechner haben kann</translation>
    </message>
    <message>
        <source>the coordinator has not been heard of for %1 heartbeats</source>
        <translation>vom Koordinator ist seit %1 Herzschlägen nichts zu hören</translation>
    </message>
    <message>
        <source>the coordinator speaks a version of the protocol that it was not offered</source>
        <translation>der Koordinator spricht eine Version des Protokolls, die ihm nicht angeboten wurde</translation>
    </message>
    <message>
        <source>the corners do not lie in one plane</source>
        <translation>die Ecken liegen nicht in einer Ebene</translation>
    </message>
    <message>
        <source>the device takes samples for films of its own only</source>
        <translation>das Gerät tastet nur für eigene Filme ab</translation>
    </message>
    <message>
        <source>the driver is too old: it knows CUDA %1, %2 is needed</source>
        <translation>der Treiber ist zu alt: Er kennt CUDA %1, gebraucht wird %2</translation>
    </message>
    <message>
        <source>the driver stopped the GPU, since the display had to wait for it</source>
        <translation>der Treiber hat die GPU angehalten, weil die Anzeige auf sie warten musste</translation>
    </message>
    <message>
        <source>the environment image is not complete</source>
        <translation>das Bild der Umgebung ist nicht vollständig</translation>
    </message>
    <message>
        <source>the environment is black</source>
        <translation>die Umgebung ist schwarz</translation>
    </message>
    <message>
        <source>the environment is hidden from the camera</source>
        <translation>die Umgebung ist vor der Kamera verborgen</translation>
    </message>
    <message>
        <source>the environment shines</source>
        <translation>die Umgebung leuchtet</translation>
    </message>
    <message>
        <source>the figure lies in axial slice %1</source>
        <translation>die Figur liegt in der axialen Schicht %1</translation>
    </message>
    <message>
        <source>the figure lies in coronal slice %1</source>
        <translation>die Figur liegt in der koronalen Schicht %1</translation>
    </message>
    <message>
        <source>the figure lies in sagittal slice %1</source>
        <translation>die Figur liegt in der sagittalen Schicht %1</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>die Datei kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the file could not be read to its end</source>
        <translation>die Datei konnte nicht bis zu ihrem Ende gelesen werden</translation>
    </message>
    <message>
        <source>the file could not be written (%1)</source>
        <translation>die Datei konnte nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>the file does not say that its values are HU; they run from %1 to %2, and are taken as HU</source>
        <translation>die Datei sagt nicht, dass ihre Werte HU sind; sie reichen von %1 bis %2 und gelten als HU</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>the file has changed since the folder was scanned</source>
        <translation>die Datei hat sich geändert, seit der Ordner durchsucht wurde</translation>
    </message>
    <message>
        <source>the file holds %1 bytes, %2 voxels of this type are %3</source>
        <translation>die Datei enthält %1 Bytes, %2 Voxel dieses Typs sind %3</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>die Datei ist beschädigt: %1</translation>
    </message>
    <message>
        <source>the file is damaged: it cannot be parsed to its end</source>
        <translation>die Datei ist beschädigt: Sie lässt sich nicht bis zu ihrem Ende lesen</translation>
    </message>
    <message>
        <source>the file is larger than %1</source>
        <translation>die Datei ist größer als %1</translation>
    </message>
    <message>
        <source>the file is no longer there</source>
        <translation>die Datei ist nicht mehr da</translation>
    </message>
    <message>
        <source>the file of its voxels cannot be read (%1)</source>
        <translation>die Datei ihrer Voxel lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>the files call the series %1, not CT, and its values HU</source>
        <translation>die Dateien nennen die Serie %1, nicht CT, und ihre Werte HU</translation>
    </message>
    <message>
        <source>the files do not say that the values are HU: looks, windows and parts of the body that need HU are not offered</source>
        <translation>die Dateien sagen nicht, dass die Werte HU sind: Looks, Fenster und Körperteile, die HU brauchen, werden nicht angeboten</translation>
    </message>
    <message>
        <source>the files name %1 frames of reference; their positions are taken as one</source>
        <translation>die Dateien nennen %1 Bezugssysteme; ihre Lagen werden als die eines einzigen genommen</translation>
    </message>
    <message>
        <source>the files name %1 studies; their slices are taken as one series</source>
        <translation>die Dateien nennen %1 Untersuchungen; ihre Schichten werden als eine Serie genommen</translation>
    </message>
    <message>
        <source>the first place is known only to ± %1 mm</source>
        <translation>der erste Punkt ist nur auf ± %1 mm bekannt</translation>
    </message>
    <message>
        <source>the folder cannot be created (%1)</source>
        <translation>der Ordner lässt sich nicht anlegen (%1)</translation>
    </message>
    <message>
        <source>the folder cannot be looked into (%1)</source>
        <translation>in den Ordner kann nicht gesehen werden (%1)</translation>
    </message>
    <message>
        <source>the folder cannot be made (%1)</source>
        <translation>der Ordner kann nicht angelegt werden (%1)</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1)</source>
        <translation>der Ordner kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the folder for your looks cannot be made</source>
        <translation>der Ordner für Ihre Darstellungen kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>the folder is empty</source>
        <translation>der Ordner ist leer</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>der Ordner ist nicht leer</translation>
    </message>
    <message>
        <source>the fourth place is known only to ± %1 mm</source>
        <translation>der vierte Punkt ist nur auf ± %1 mm bekannt</translation>
    </message>
    <message>
        <source>the gantry was tilted by %1 degrees; the grid follows it (%2 mm a slice)</source>
        <translation>die Gantry war um %1 Grad gekippt; das Gitter folgt ihr (%2 mm je Schicht)</translation>
    </message>
    <message>
        <source>the gradient factor is 0</source>
        <translation>der Gradientenfaktor ist 0</translation>
    </message>
    <message>
        <source>the gradient factor is above 0</source>
        <translation>der Gradientenfaktor ist größer als 0</translation>
    </message>
    <message>
        <source>the grey window in the files is left out: its centre or its width is no number</source>
        <translation>das Graufenster der Dateien bleibt außer Acht: seine Mitte oder seine Breite ist keine Zahl</translation>
    </message>
    <message>
        <source>the grey window in the files is left out: its function "%1" is not known</source>
        <translation>das Graufenster der Dateien bleibt außer Acht: seine Funktion „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>the grey window in the files is left out: no window is %1 wide</source>
        <translation>das Graufenster in den Dateien wird ausgelassen: Kein Fenster ist %1 breit</translation>
    </message>
    <message>
        <source>the image cannot be read as OpenEXR (%1)</source>
        <translation>das Bild kann nicht als OpenEXR gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the image could not be encoded as OpenEXR (%1)</source>
        <translation>das Bild konnte nicht als OpenEXR kodiert werden (%1)</translation>
    </message>
    <message>
        <source>the image could not be encoded as PNG</source>
        <translation>das Bild konnte nicht als PNG kodiert werden</translation>
    </message>
    <message>
        <source>the image could not be rendered</source>
        <translation>das Bild konnte nicht gemacht werden</translation>
    </message>
    <message>
        <source>the image has no channel %1</source>
        <translation>das Bild hat keinen Kanal %1</translation>
    </message>
    <message>
        <source>the image holds fewer pixels than its header says</source>
        <translation>das Bild enthält weniger Pixel, als sein Kopf sagt</translation>
    </message>
    <message>
        <source>the image is %1 x %2 pixels, at most %3 x %3 can be read</source>
        <translation>das Bild hat %1 x %2 Pixel, höchstens %3 x %3 können gelesen werden</translation>
    </message>
    <message>
        <source>the image is black and lights nothing</source>
        <translation>das Bild ist schwarz und beleuchtet nichts</translation>
    </message>
    <message>
        <source>the image is not complete</source>
        <translation>das Bild ist nicht vollständig</translation>
    </message>
    <message>
        <source>the image was closed</source>
        <translation>das Bild wurde geschlossen</translation>
    </message>
    <message>
        <source>the label map has voxels of %1, the scan of %2, or they are turned</source>
        <translation>die Labelkarte hat Voxel von %1, die Aufnahme von %2, oder sie sind gedreht</translation>
    </message>
    <message>
        <source>the label map is mirrored: "%1" lies at the right of "%2"</source>
        <translation>die Labelkarte ist gespiegelt: „%1“ liegt rechts von „%2“</translation>
    </message>
    <message>
        <source>the label map is mirrored: it fits the scan with %1 exchanged</source>
        <translation>die Labelkarte ist gespiegelt: sie passt auf die Aufnahme, wenn %1 vertauscht werden</translation>
    </message>
    <message>
        <source>the label map is shifted: its voxels lie %1 mm (%2 voxels) beside those of the scan</source>
        <translation>die Labelkarte ist verschoben: ihre Voxel liegen %1 mm (%2 Voxel) neben denen der Aufnahme</translation>
    </message>
    <message>
        <source>the label map lies elsewhere: it reaches %1 voxels beyond the scan</source>
        <translation>die Labelkarte liegt woanders: sie reicht %1 Voxel über die Aufnahme hinaus</translation>
    </message>
    <message>
        <source>the label map lies on another grid than the volume</source>
        <translation>die Labelkarte liegt auf einem anderen Gitter als das Volumen</translation>
    </message>
    <message>
        <source>the lens is open</source>
        <translation>die Blende ist offen</translation>
    </message>
    <message>
        <source>the light here stops at %1 depths: the one with the most, %2 %, was taken</source>
        <translation>das Licht endet hier in %1 Tiefen: Genommen wurde die mit dem größten Anteil, %2 %</translation>
    </message>
    <message>
        <source>the link leads nowhere</source>
        <translation>der Verweis führt ins Leere</translation>
    </message>
    <message>
        <source>the lungs</source>
        <translation>die Lungen</translation>
    </message>
    <message>
        <source>the lungs cannot be shown</source>
        <translation>die Lungen können nicht gezeigt werden</translation>
    </message>
    <message>
        <source>the lungs cannot be told from the rest</source>
        <translation>die Lungen sind nicht vom Übrigen zu unterscheiden</translation>
    </message>
    <message>
        <source>the march has one event on a path</source>
        <translation>der Marsch hat ein Ereignis je Weg</translation>
    </message>
    <message>
        <source>the mask has other voxels than those before it</source>
        <translation>die Maske hat andere Voxel als die vor ihr</translation>
    </message>
    <message>
        <source>the masks have more than %1 labels</source>
        <translation>die Masken haben mehr als %1 Labels</translation>
    </message>
    <message>
        <source>the measurements do not tell the parts of a frame's time apart</source>
        <translation>die Messungen trennen die Teile der Zeit eines Bildes nicht</translation>
    </message>
    <message>
        <source>the memory of the GPU has lost bits</source>
        <translation>der Speicher der GPU hat Bits verloren</translation>
    </message>
    <message>
        <source>the memory of the GPU is taken: %1 are free</source>
        <translation>der Speicher der GPU ist belegt: %1 sind frei</translation>
    </message>
    <message>
        <source>the model %1 knows no materials of parts</source>
        <translation>das Modell %1 kennt keine Materialien von Teilen</translation>
    </message>
    <message>
        <source>the model asks for no light</source>
        <translation>das Modell braucht kein Licht</translation>
    </message>
    <message>
        <source>the model does not scatter</source>
        <translation>das Modell streut nicht</translation>
    </message>
    <message>
        <source>the model has none</source>
        <translation>das Modell hat keine</translation>
    </message>
    <message>
        <source>the model has one event on a path</source>
        <translation>das Modell hat ein Ereignis je Weg</translation>
    </message>
    <message>
        <source>the model shows no light from within</source>
        <translation>das Modell zeigt kein Licht von innen</translation>
    </message>
    <message>
        <source>the model shows values, not light</source>
        <translation>das Modell zeigt Werte, kein Licht</translation>
    </message>
    <message>
        <source>the name says no format that images are saved in</source>
        <translation>der Name nennt kein Format, in dem Bilder gesichert werden</translation>
    </message>
    <message>
        <source>the network takes longest either way: %1</source>
        <translation>das Netz braucht so oder so am längsten: %1</translation>
    </message>
    <message>
        <source>the only file is not a DICOM image</source>
        <translation>die einzige Datei ist kein DICOM-Bild</translation>
    </message>
    <message>
        <source>the other device cannot be used: %1</source>
        <translation>das andere Gerät kann nicht benutzt werden: %1</translation>
    </message>
    <message>
        <source>the other side did not introduce itself first</source>
        <translation>die Gegenseite hat sich nicht zuerst vorgestellt</translation>
    </message>
    <message>
        <source>the other side did not introduce itself in time</source>
        <translation>die Gegenseite hat sich nicht rechtzeitig vorgestellt</translation>
    </message>
    <message>
        <source>the other side ended the connection</source>
        <translation>die Gegenseite hat die Verbindung beendet</translation>
    </message>
    <message>
        <source>the other side sends a message too slowly</source>
        <translation>die Gegenseite schickt eine Nachricht zu langsam</translation>
    </message>
    <message>
        <source>the other side sends more messages than it has reason to</source>
        <translation>die Gegenseite schickt mehr Nachrichten, als sie Grund dazu hat</translation>
    </message>
    <message>
        <source>the other side sent what makes no sense: %1</source>
        <translation>die andere Seite hat Unsinniges gesendet: %1</translation>
    </message>
    <message>
        <source>the other side takes too little of what it is sent</source>
        <translation>die Gegenseite nimmt zu wenig von dem ab, was ihr geschickt wird</translation>
    </message>
    <message>
        <source>the outline crosses itself</source>
        <translation>der Umriss kreuzt sich selbst</translation>
    </message>
    <message>
        <source>the outline encloses nothing</source>
        <translation>der Umriss umschließt nichts</translation>
    </message>
    <message>
        <source>the patient</source>
        <translation>dem Patienten</translation>
    </message>
    <message>
        <source>the plan was made by a version that reads scans by rule %1, and this one reads by rule %2</source>
        <translation>der Plan stammt von einer Version, die Aufnahmen nach Regel %1 liest; diese liest nach Regel %2</translation>
    </message>
    <message>
        <source>the plan was made on the same voxels at another place of the patient</source>
        <translation>der Plan entstand auf denselben Voxeln an einem anderen Ort des Patienten</translation>
    </message>
    <message>
        <source>the previous series is still in memory</source>
        <translation>die vorige Serie liegt noch im Speicher</translation>
    </message>
    <message>
        <source>the region is still black</source>
        <translation>der Bereich ist noch schwarz</translation>
    </message>
    <message>
        <source>the rest of the image waits for the region</source>
        <translation>der Rest des Bildes wartet auf den Bereich</translation>
    </message>
    <message>
        <source>the samples come first: %3 in %2, within ±%1</source>
        <translation>die Abtastungen kommen zuerst: %3 in %2, innerhalb ±%1</translation>
    </message>
    <message>
        <source>the scanner measured nothing here</source>
        <translation>hier hat der Scanner nichts gemessen</translation>
    </message>
    <message>
        <source>the scanner measured nothing in this region</source>
        <translation>in diesem Bereich hat der Scanner nichts gemessen</translation>
    </message>
    <message>
        <source>the scene that was ordered cannot be rendered: %1</source>
        <translation>die bestellte Szene kann nicht gerechnet werden: %1</translation>
    </message>
    <message>
        <source>the second place is known only to ± %1 mm</source>
        <translation>der zweite Punkt ist nur auf ± %1 mm bekannt</translation>
    </message>
    <message>
        <source>the segmentation does not refer to the scan</source>
        <translation>die Segmentierung verweist nicht auf die Aufnahme</translation>
    </message>
    <message>
        <source>the segmentation has another frame of reference than the scan</source>
        <translation>die Segmentierung hat ein anderes Bezugssystem als die Aufnahme</translation>
    </message>
    <message>
        <source>the segmentation names another patient than the scan</source>
        <translation>die Segmentierung nennt einen anderen Patienten als die Aufnahme</translation>
    </message>
    <message>
        <source>the slices differ in size: %1</source>
        <translation>die Schichten sind verschieden groß: %1</translation>
    </message>
    <message>
        <source>the slices drift sideways by %1 mm for each %2 mm of height (gantry tilt of %3 degrees), from %4 to %5</source>
        <translation>die Schichten rücken um %1 mm je %2 mm Höhe zur Seite (Gantry um %3 Grad gekippt), von %4 bis %5</translation>
    </message>
    <message>
        <source>the slices scale their values differently; all are rounded to steps of %1</source>
        <translation>die Schichten skalieren ihre Werte verschieden; alle sind auf Schritte von %1 gerundet</translation>
    </message>
    <message>
        <source>the symbolic links here lead in a circle</source>
        <translation>die symbolischen Verweise hier führen im Kreis</translation>
    </message>
    <message>
        <source>the system has no thread or no memory left for this</source>
        <translation>das System hat dafür keinen Thread oder keinen Speicher mehr</translation>
    </message>
    <message>
        <source>the text %1 has more than %2 values</source>
        <translation>der Text %1 hat mehr als %2 Werte</translation>
    </message>
    <message>
        <source>the text %1 is longer than %2 kB</source>
        <translation>der Text %1 ist länger als %2 kB</translation>
    </message>
    <message>
        <source>the third place is known only to ± %1 mm</source>
        <translation>der dritte Punkt ist nur auf ± %1 mm bekannt</translation>
    </message>
    <message>
        <source>the threads of a warp have lost each other</source>
        <translation>die Threads eines Warps haben einander verloren</translation>
    </message>
    <message>
        <source>the time comes first: in %2, within ±%1 and with %3 samples</source>
        <translation>die Zeit kommt zuerst: in %2, innerhalb ±%1 und mit %3 Abtastungen</translation>
    </message>
    <message>
        <source>the values are no HU but another quantity (%1): looks, windows and parts of the body that need HU are not offered</source>
        <translation>die Werte sind keine HU, sondern eine andere Größe (%1): Looks, Fenster und Körperteile, die HU brauchen, werden nicht angeboten</translation>
    </message>
    <message>
        <source>the values are rounded to steps of %1, 65,536 from the lowest to the highest</source>
        <translation>die Werte sind auf Schritte von %1 gerundet, 65.536 vom niedrigsten bis zum höchsten</translation>
    </message>
    <message>
        <source>the values of this scan are no HU</source>
        <translation>die Werte dieser Aufnahme sind keine HU</translation>
    </message>
    <message>
        <source>the values of this scan are no HU, in which looks are kept</source>
        <translation>die Werte dieser Aufnahme sind keine HU, in denen Looks gespeichert werden</translation>
    </message>
    <message>
        <source>the values run from %1 to %2 and are no HU, which begin at -100 or below, and end at 100 or above: looks, windows and parts of the body that need HU are not offered</source>
        <translation>die Werte reichen von %1 bis %2 und sind keine HU, die bei -100 oder darunter beginnen und bei 100 oder darüber enden: Looks, Fenster und Körperteile, die HU brauchen, werden nicht angeboten</translation>
    </message>
    <message>
        <source>the view</source>
        <translation>der Ansicht</translation>
    </message>
    <message>
        <source>the volume does not fit into its memory: %1 are needed, %2 are free</source>
        <translation>das Volumen passt nicht in seinen Speicher: %1 werden gebraucht, %2 sind frei</translation>
    </message>
    <message>
        <source>the volume holds no values that are specular</source>
        <translation>das Volumen enthält keine Werte, die glänzen</translation>
    </message>
    <message>
        <source>the volume is too large for fast filtering: it has %1 voxels, textures may have %2</source>
        <translation>das Volumen ist zu groß für schnelles Filtern: Es hat %1 Voxel, Texturen dürfen %2 haben</translation>
    </message>
    <message>
        <source>the volume needs %1 of memory, and %2 are free</source>
        <translation>das Volumen braucht %1 Speicher, und %2 sind frei</translation>
    </message>
    <message>
        <source>the volume needs %1 of memory, which could not be had</source>
        <translation>das Volumen braucht %1 Speicher, der nicht zu bekommen war</translation>
    </message>
    <message>
        <source>the voxels of %1 slices between %2 and %3 are not those that the plan was made on</source>
        <translation>die Voxel von %1 Schichten zwischen %2 und %3 sind nicht die, auf denen der Plan entstand</translation>
    </message>
    <message>
        <source>the voxels of slice %1 are not those that the plan was made on</source>
        <translation>die Voxel der Schicht %1 sind nicht die, auf denen der Plan entstand</translation>
    </message>
    <message>
        <source>the voxels of slices %1 to %2 are not those that the plan was made on</source>
        <translation>die Voxel der Schichten %1 bis %2 sind nicht die, auf denen der Plan entstand</translation>
    </message>
    <message>
        <source>there are %1 nodes, at most %2 are taken</source>
        <translation>es sind %1 Stützstellen, höchstens %2 werden genommen</translation>
    </message>
    <message>
        <source>there are certificates already</source>
        <translation>es gibt schon Zertifikate</translation>
    </message>
    <message>
        <source>there are no surfaces</source>
        <translation>es gibt keine Oberflächen</translation>
    </message>
    <message>
        <source>there are too few blocks of 64 samples for all render nodes: they would take %1, tiles take %2</source>
        <translation>für alle Render-Rechner gibt es zu wenige Blöcke von 64 Samples: Sie bräuchten %1, Kacheln brauchen %2</translation>
    </message>
    <message>
        <source>there is a stray delimiter %1</source>
        <translation>ein Endezeichen %1 steht, wo keines hingehört</translation>
    </message>
    <message>
        <source>there is contrast in the blood</source>
        <translation>im Blut ist Kontrastmittel</translation>
    </message>
    <message>
        <source>there is no GPU of NVIDIA's</source>
        <translation>es gibt keine GPU von NVIDIA</translation>
    </message>
    <message>
        <source>there is no air of 150 ml in the body that looks like a lung</source>
        <translation>im Körper ist keine Luft von 150 ml, die nach einer Lunge aussieht</translation>
    </message>
    <message>
        <source>there is no connection: %1</source>
        <translation>es gibt keine Verbindung: %1</translation>
    </message>
    <message>
        <source>there is no driver for a GPU of NVIDIA's</source>
        <translation>es gibt keinen Treiber für eine GPU von NVIDIA</translation>
    </message>
    <message>
        <source>there is no image</source>
        <translation>es gibt kein Bild</translation>
    </message>
    <message>
        <source>there is no light</source>
        <translation>es gibt kein Licht</translation>
    </message>
    <message>
        <source>there is no measurement to export</source>
        <translation>es gibt keine Messung, die exportiert werden kann</translation>
    </message>
    <message>
        <source>there is no pool of 5 ml of blood with contrast medium</source>
        <translation>nirgends 5 ml Blut mit Kontrastmittel beisammen sind</translation>
    </message>
    <message>
        <source>there is no scene on the device</source>
        <translation>auf dem Gerät ist keine Szene</translation>
    </message>
    <message>
        <source>there is no series %1 here</source>
        <translation>die Serie %1 gibt es hier nicht</translation>
    </message>
    <message>
        <source>there is no such GPU</source>
        <translation>diese GPU gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such device</source>
        <translation>dieses Gerät gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>diesen Port gibt es nicht</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>es ist nicht genug Speicher da</translation>
    </message>
    <message>
        <source>there is not enough memory %1</source>
        <translation>es ist nicht genug Speicher da %1</translation>
    </message>
    <message>
        <source>there is not enough memory to look for it</source>
        <translation>es ist nicht genug Speicher da, um danach zu suchen</translation>
    </message>
    <message>
        <source>there is not enough memory to read its header</source>
        <translation>es ist nicht genug Speicher da, um ihren Kopf zu lesen</translation>
    </message>
    <message>
        <source>there is something behind its map</source>
        <translation>hinter ihrer Tabelle steht noch etwas</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>es ist zu wenig Speicher da</translation>
    </message>
    <message>
        <source>these certificates do not belong together</source>
        <translation>diese Zertifikate gehören nicht zusammen</translation>
    </message>
    <message>
        <source>thin structures may be further off</source>
        <translation>dünne Strukturen können weiter abweichen</translation>
    </message>
    <message>
        <source>this body is no wider than a head</source>
        <translation>dieser Körper ist nicht breiter als ein Kopf</translation>
    </message>
    <message>
        <source>this body is wider than a head</source>
        <translation>dieser Körper ist breiter als ein Kopf</translation>
    </message>
    <message>
        <source>this certificate does not hold yet</source>
        <translation>dieses Zertifikat gilt noch nicht</translation>
    </message>
    <message>
        <source>this certificate has expired</source>
        <translation>dieses Zertifikat ist abgelaufen</translation>
    </message>
    <message>
        <source>this figure is drawn on a slice</source>
        <translation>diese Figur wird auf einer Schicht gezeichnet</translation>
    </message>
    <message>
        <source>this file belongs to another user, and in this folder only they may replace it</source>
        <translation>diese Datei gehört jemand anderem, und in diesem Ordner darf nur er sie ersetzen</translation>
    </message>
    <message>
        <source>this file is read by the scene that is to be rendered</source>
        <translation>diese Datei wird von der Szene gelesen, die gerendert werden soll</translation>
    </message>
    <message>
        <source>this file may not be written</source>
        <translation>diese Datei darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>this image adds up all depths: no point of it is one place</source>
        <translation>dieses Bild summiert alle Tiefen: Keine Stelle darin ist ein einzelner Ort</translation>
    </message>
    <message>
        <source>this is a file, not a folder</source>
        <translation>das ist eine Datei, kein Ordner</translation>
    </message>
    <message>
        <source>this is a folder, a file name is needed</source>
        <translation>dies ist ein Ordner, ein Dateiname ist nötig</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>das ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>this is another scan: %1 voxels, and the plan was made on %2</source>
        <translation>dies ist eine andere Aufnahme: %1 Voxel, und der Plan entstand auf %2</translation>
    </message>
    <message>
        <source>this is another scan: it has the size of the plan's, but other voxels</source>
        <translation>dies ist eine andere Aufnahme: Sie ist so groß wie die des Plans, hat aber andere Voxel</translation>
    </message>
    <message>
        <source>this is no DICOM image</source>
        <translation>das ist kein DICOM-Bild</translation>
    </message>
    <message>
        <source>this is no DICOM segmentation</source>
        <translation>dies ist keine DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>this is no MetaImage file</source>
        <translation>das ist keine MetaImage-Datei</translation>
    </message>
    <message>
        <source>this is no NIfTI file with header and voxels in one</source>
        <translation>das ist keine NIfTI-Datei mit Kopf und Voxeln in einem</translation>
    </message>
    <message>
        <source>this is no NRRD file</source>
        <translation>das ist keine NRRD-Datei</translation>
    </message>
    <message>
        <source>this is no address</source>
        <translation>das ist keine Adresse</translation>
    </message>
    <message>
        <source>this is no certificate</source>
        <translation>das ist kein Zertifikat</translation>
    </message>
    <message>
        <source>this is no key</source>
        <translation>das ist kein Schlüssel</translation>
    </message>
    <message>
        <source>this is no plain file</source>
        <translation>dies ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>this is not the certificate of a %1</source>
        <translation>das ist nicht das Zertifikat eines %1</translation>
    </message>
    <message>
        <source>this is one piece of a stack whose other piece lies on another grid (%1): %2 and so on here, %3 and so on there</source>
        <translation>dies ist ein Stück eines Stapels, dessen anderes Stück auf einem anderen Gitter liegt (%1): %2 und folgende hier, %3 und folgende dort</translation>
    </message>
    <message>
        <source>this key is encrypted, and nobody is there to ask for its password</source>
        <translation>dieser Schlüssel ist verschlüsselt, und niemand kann nach dem Kennwort gefragt werden</translation>
    </message>
    <message>
        <source>this look cannot be deleted: %1</source>
        <translation>diese Darstellung kann nicht gelöscht werden: %1</translation>
    </message>
    <message>
        <source>this look cannot be written: %1</source>
        <translation>diese Darstellung kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>this machine's certificates have expired: make new ones for the coordinator and all nodes, and start the programs again</source>
        <translation>die Zertifikate dieses Rechners sind abgelaufen: Erstellen Sie neue für den Koordinator und alle Render-Rechner und starten Sie die Programme neu</translation>
    </message>
    <message>
        <source>this name is too long</source>
        <translation>dieser Name ist zu lang</translation>
    </message>
    <message>
        <source>this node has said goodbye</source>
        <translation>dieser Rechner hat sich verabschiedet</translation>
    </message>
    <message>
        <source>this node works for somebody else</source>
        <translation>dieser Rechner arbeitet für jemand anderen</translation>
    </message>
    <message>
        <source>this program listens at IP addresses, not at names</source>
        <translation>dieses Programm wartet an IP-Adressen, nicht an Namen</translation>
    </message>
    <message>
        <source>this program was built without CUDA</source>
        <translation>dieses Programm wurde ohne CUDA gebaut</translation>
    </message>
    <message>
        <source>this region holds more than %1 voxels</source>
        <translation>dieser Bereich enthält mehr als %1 Voxel</translation>
    </message>
    <message>
        <source>this render node is named already</source>
        <translation>dieser Render-Rechner ist schon genannt</translation>
    </message>
    <message>
        <source>this scan has no part called "%1"</source>
        <translation>diese Aufnahme hat keinen Teil namens „%1“</translation>
    </message>
    <message>
        <source>this scene cannot be sent to render nodes: they would read another one</source>
        <translation>diese Szene kann nicht an Render-Rechner gesendet werden: Sie läsen eine andere</translation>
    </message>
    <message>
        <source>tiles would be smaller than what a render node needs to start: %1 of %2</source>
        <translation>Kacheln wären kürzer, als ein Render-Rechner zum Anlaufen braucht: %1 von %2</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>gekippt</translation>
    </message>
    <message>
        <source>time to the target</source>
        <translation>Zeit bis zum Ziel</translation>
    </message>
    <message>
        <source>tissue is seen against the environment, else against white</source>
        <translation>Gewebe wird vor der Umgebung gesehen, sonst vor Weiß</translation>
    </message>
    <message>
        <source>tissue is seen against white: without it there is no image</source>
        <translation>Gewebe wird vor Weiß gesehen: ohne das gibt es kein Bild</translation>
    </message>
    <message>
        <source>to decode it</source>
        <translation>um sie zu dekodieren</translation>
    </message>
    <message>
        <source>to denoise the scan: %1</source>
        <translation>zum Entrauschen der Aufnahme: %1</translation>
    </message>
    <message>
        <source>to tell parts of the body apart</source>
        <translation>um Teile des Körpers zu unterscheiden</translation>
    </message>
    <message>
        <source>too few measurements: %1 sizes with %2 numbers of iterations</source>
        <translation>zu wenige Messungen: %1 Größen mit %2 Anzahlen von Durchgängen</translation>
    </message>
    <message>
        <source>uncompressed</source>
        <translation>unkomprimiert</translation>
    </message>
    <message>
        <source>uneven</source>
        <translation>ungleichmäßig</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>vessels are guessed by their density: check them; beside bone (neck, base of the skull) they may be missing, as may veins full of undiluted medium; calcium, and organs full of medium, may be among them</source>
        <translation>Gefäße sind nach ihrer Dichte geraten: prüfen Sie sie; neben Knochen (Hals, Schädelbasis) können sie fehlen, ebenso Venen voll unverdünntem Mittel; Kalk und Organe voll Kontrastmittel können darunter sein</translation>
    </message>
    <message>
        <source>vessels cannot be found, because %1</source>
        <translation>Gefäße sind nicht zu finden, weil %1</translation>
    </message>
    <message>
        <source>visible background</source>
        <translation>sichtbarer Hintergrund</translation>
    </message>
    <message>
        <source>voxel %1 holds %2, Hounsfield units end at 32767 and begin at -32768</source>
        <translation>Voxel %1 enthält %2, HU reichen von -32768 bis 32767</translation>
    </message>
    <message>
        <source>voxels lie %1 mm apart, must be from %2 to %3</source>
        <translation>Voxel liegen %1 mm auseinander, erlaubt ist %2 bis %3</translation>
    </message>
    <message>
        <source>voxels lie more than 5 mm apart</source>
        <translation>Voxel liegen mehr als 5 mm auseinander</translation>
    </message>
    <message>
        <source>voxels that lie in several parts, of which the smallest keeps them: %1</source>
        <translation>Voxel, die in mehreren Teilen liegen und beim kleinsten bleiben: %1</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>what is cut away lies outside the volume</source>
        <translation>was weggeschnitten ist, liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>what is seen here is spread over %1 mm of depth: too translucent to be one place</source>
        <translation>was hier zu sehen ist, verteilt sich über %1 mm Tiefe: zu durchscheinend für einen einzelnen Ort</translation>
    </message>
    <message>
        <source>which of them comes first is not known yet</source>
        <translation>was davon zuerst kommt, ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>whole image, waiting for the region: ±%1 (95 % of the tissue)</source>
        <translation>ganzes Bild, wartet auf den Bereich: ±%1 (95 % des Gewebes)</translation>
    </message>
    <message>
        <source>without certificates only this machine itself may be dialled</source>
        <translation>ohne Zertifikate darf nur dieser Rechner selbst angewählt werden</translation>
    </message>
    <message>
        <source>without it: mean</source>
        <translation>ohne ihn: Mittel</translation>
    </message>
    <message>
        <source>writing slices</source>
        <translation>Schichten werden geschrieben</translation>
    </message>
    <message>
        <source>writing the image</source>
        <translation>Das Bild wird geschrieben</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>±</source>
        <translation>±</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>±%1 comes first: in %2, with %3 samples</source>
        <translation>±%1 kommt zuerst: in %2, mit %3 Abtastungen</translation>
    </message>
    <message>
        <source>±%1 in %2</source>
        <translation>±%1 in %2</translation>
    </message>
    <message>
        <source>±%1 in %2, to 95 % between %3 and %4</source>
        <translation>±%1 in %2, zu 95 % zwischen %3 und %4</translation>
    </message>
    <message>
        <source>±%1 in at least %2</source>
        <translation>±%1 in mindestens %2</translation>
    </message>
    <message>
        <source>±%1 levels for 95 % of the tissue before denoising; %2 % of its light</source>
        <translation>±%1 Stufen für 95 % des Gewebes vor dem Entrauschen; %2 % seines Lichts</translation>
    </message>
    <message>
        <source>±%1 levels for 95 % of the tissue; %2 % of its light</source>
        <translation>±%1 Stufen für 95 % des Gewebes; %2 % seines Lichts</translation>
    </message>
    <message>
        <source>±%1 since %2 of rendering</source>
        <translation>±%1 seit %2 Rechenzeit</translation>
    </message>
</context>
</TS>

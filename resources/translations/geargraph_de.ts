<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>GearGraph</name>
    <message>
        <source>the ground does not move</source>
        <translation>das Gestell bewegt sich nicht</translation>
    </message>
    <message>
        <source>no turning joint carries it yet</source>
        <translation>noch trägt es kein Drehgelenk</translation>
    </message>
    <message>
        <source>several turning joints: click one</source>
        <translation>mehrere Drehgelenke: eines anklicken</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>link %1</source>
        <translation>Glied %1</translation>
    </message>
    <message>
        <source>turning joint %1</source>
        <translation>Drehgelenk %1</translation>
    </message>
    <message>
        <source>gear mesh %1</source>
        <translation>Zahneingriff %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>brake %1</source>
        <translation>Bremse %1</translation>
    </message>
    <message>
        <source>clutch %1</source>
        <translation>Kupplung %1</translation>
    </message>
    <message>
        <source> from link %1 to link %2</source>
        <translation> von Glied %1 zu Glied %2</translation>
    </message>
    <message>
        <source>: holds link %1 while it is engaged</source>
        <translation>: hält Glied %1, solange sie geschlossen ist</translation>
    </message>
    <message>
        <source>: links %1 turn as one while it is engaged</source>
        <translation>: die Glieder %1 drehen sich gemeinsam, solange sie geschlossen ist</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>, axis %1</source>
        <translation>, Achse %1</translation>
    </message>
    <message>
        <source>, driven</source>
        <translation>, angetrieben</translation>
    </message>
    <message>
        <source>, %1 : %2 teeth</source>
        <translation>, %1 : %2 Zähne</translation>
    </message>
    <message>
        <source>Release %1</source>
        <translation>%1 lösen</translation>
    </message>
    <message>
        <source>Engage %1</source>
        <translation>%1 schließen</translation>
    </message>
    <message>
        <source>Take %1 off</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Hold it with a brake</source>
        <translation>Mit einer Bremse festhalten</translation>
    </message>
    <message>
        <source>Connect it to another link with a clutch</source>
        <translation>Durch eine Kupplung mit einem anderen Glied verbinden</translation>
    </message>
    <message>
        <source>select two links</source>
        <translation>zwei Glieder auswählen</translation>
    </message>
    <message>
        <source>Connect %1 and %2 with a clutch</source>
        <translation>%1 und %2 durch eine Kupplung verbinden</translation>
    </message>
    <message>
        <source>Select one link, and with Shift the joints and meshes that its new half should take.</source>
        <translation>Wählen Sie ein Glied und mit Umschalt die Gelenke und Eingriffe, die seine neue Hälfte übernehmen soll.</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 teilen</translation>
    </message>
    <message>
        <source>Select the two links that should be one: click one, then the other with Shift.</source>
        <translation>Wählen Sie die zwei Glieder, die eines werden sollen: eines anklicken, dann das andere mit Umschalt.</translation>
    </message>
    <message>
        <source>Weld %1 and %2</source>
        <translation>%1 und %2 verschweißen</translation>
    </message>
    <message>
        <source>Split it in two</source>
        <translation>In zwei Glieder teilen</translation>
    </message>
    <message>
        <source>Weld %1 and %2 to one link</source>
        <translation>%1 und %2 zu einem Glied verschweißen</translation>
    </message>
    <message>
        <source>hold the link with a brake</source>
        <translation>das Glied mit einer Bremse festhalten</translation>
    </message>
    <message>
        <source>Move gear %1 to the other side of the apex</source>
        <translation>Zahnrad %1 auf die andere Seite der Kegelspitze setzen</translation>
    </message>
    <message>
        <source>Make it external</source>
        <translation>Außenverzahnt machen</translation>
    </message>
    <message>
        <source>Make it internal</source>
        <translation>Innenverzahnt machen</translation>
    </message>
    <message>
        <source>Pin the module</source>
        <translation>Modul fixieren</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Stop driving it</source>
        <translation>Nicht mehr antreiben</translation>
    </message>
    <message>
        <source>Drive it</source>
        <translation>Antreiben</translation>
    </message>
    <message>
        <source>Make it the ground</source>
        <translation>Zum Gestell machen</translation>
    </message>
    <message>
        <source>it is the ground</source>
        <translation>es ist das Gestell</translation>
    </message>
    <message>
        <source>Attach a gear</source>
        <translation>Zahnrad anfügen</translation>
    </message>
    <message>
        <source>Pin the teeth of its gears</source>
        <translation>Zähnezahlen seiner Räder fixieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>the ground cannot be deleted</source>
        <translation>das Gestell kann nicht gelöscht werden</translation>
    </message>
    <message>
        <source>Axis %1 pinned</source>
        <translation>Achse %1 fixiert</translation>
    </message>
    <message>
        <source>only turning joints can be driven</source>
        <translation>nur Drehgelenke können angetrieben werden</translation>
    </message>
    <message>
        <source>Flip the arrow</source>
        <translation>Pfeil umkehren</translation>
    </message>
    <message>
        <source>Delete with its joints</source>
        <translation>Samt Gelenken löschen</translation>
    </message>
    <message>
        <source>New link here</source>
        <translation>Neues Glied hier</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Tidy the drawing</source>
        <translation>Zeichnung ordnen</translation>
    </message>
    <message>
        <source>nothing is drawn yet</source>
        <translation>noch ist nichts gezeichnet</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Take it off</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Cycle C%1:</source>
        <translation>Zyklus C%1:</translation>
    </message>
    <message>
        <source>Digraph</source>
        <translation>Digraph</translation>
    </message>
    <message>
        <source>Laying out %1 links</source>
        <translation>%1 Glieder werden angeordnet</translation>
    </message>
    <message>
        <source>No gear can be attached: %1.</source>
        <translation>Es kann kein Zahnrad angefügt werden: %1.</translation>
    </message>
    <message>
        <source>Select one turning joint or link to load it.</source>
        <translation>Wählen Sie ein Drehgelenk oder ein Glied aus, um es zu belasten.</translation>
    </message>
    <message>
        <source>The ground takes any load: select a moving link.</source>
        <translation>Das Gestell nimmt jede Last auf: Wählen Sie ein bewegtes Glied.</translation>
    </message>
    <message>
        <source>Loads act in turning joints and on links.</source>
        <translation>Lasten wirken in Drehgelenken und an Gliedern.</translation>
    </message>
    <message>
        <source>10 Nm</source>
        <translation>10 Nm</translation>
    </message>
    <message>
        <source>Torque that acts here</source>
        <translation>Drehmoment, das hier wirkt</translation>
    </message>
    <message>
        <source>Remove load</source>
        <translation>Last entfernen</translation>
    </message>
    <message>
        <source>A torque is a number with its unit: 10 Nm, 500 Nmm, 1/2 kNm</source>
        <translation>Ein Drehmoment ist eine Zahl mit Einheit: 10 Nm, 500 Nmm, 1/2 kNm</translation>
    </message>
    <message>
        <source>Set load</source>
        <translation>Last ändern</translation>
    </message>
    <message>
        <source>Add load</source>
        <translation>Last hinzufügen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>%1 umkehren</translation>
    </message>
    <message>
        <source>Cannot be driven: %1</source>
        <translation>Kann nicht angetrieben werden: %1</translation>
    </message>
    <message>
        <source>Drive or release</source>
        <translation>Antrieb ein oder aus</translation>
    </message>
    <message>
        <source>Rename link</source>
        <translation>Glied umbenennen</translation>
    </message>
    <message>
        <source>No gear can be attached: %1</source>
        <translation>Es kann kein Zahnrad angefügt werden: %1</translation>
    </message>
    <message>
        <source>Attach gear to %1</source>
        <translation>Zahnrad an %1 anfügen</translation>
    </message>
    <message>
        <source>Make ground</source>
        <translation>Gestell festlegen</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>%1 fixieren</translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>%1 freigeben</translation>
    </message>
    <message>
        <source>Change kind</source>
        <translation>Art ändern</translation>
    </message>
    <message>
        <source>Move gear to the other side</source>
        <translation>Zahnrad auf die andere Seite setzen</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>%1 festhalten</translation>
    </message>
    <message>
        <source>Connect links</source>
        <translation>Glieder verbinden</translation>
    </message>
    <message>
        <source>Take off %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>%1:  %2,  transfer vertex %3</source>
        <translation>%1:  %2,  Transferknoten %3</translation>
    </message>
    <message>
        <source>The drawn pose does not tell the sign of its terminal equation.</source>
        <translation>Die gezeichnete Lage bestimmt das Vorzeichen seiner Klemmengleichung nicht.</translation>
    </message>
    <message>
        <source>Draw the first link: L, then click</source>
        <translation>Zeichnen Sie das erste Glied: L, dann klicken</translation>
    </message>
    <message>
        <source>Map of the drawing</source>
        <translation>Übersicht der Zeichnung</translation>
    </message>
    <message>
        <source>All of the drawing: click or drag to move what is in sight</source>
        <translation>Die ganze Zeichnung: Klicken oder ziehen Sie, um den sichtbaren Teil zu verschieben</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the link</source>
        <translation>Name des Glieds</translation>
    </message>
    <message>
        <source>Move link</source>
        <translation>Glied verschieben</translation>
    </message>
    <message>
        <source>Move links</source>
        <translation>Glieder verschieben</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Schrittweise verschieben</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Glied hinzufügen</translation>
    </message>
    <message>
        <source>Add gear mesh</source>
        <translation>Zahneingriff hinzufügen</translation>
    </message>
    <message>
        <source>Add turning joint</source>
        <translation>Drehgelenk hinzufügen</translation>
    </message>
    <message>
        <source>T-T graph</source>
        <translation>T-T-Graph</translation>
    </message>
    <message>
        <source>The T–T graph is still being laid out. Try again in a moment.</source>
        <translation>Der T–T-Graph wird noch angeordnet. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>No tree yet: turning joints have to tie every link to the ground and close no loop.</source>
        <translation>Noch kein Baum: Drehgelenke müssen jedes Glied mit dem Gestell verbinden und dürfen keine Schleife schließen.</translation>
    </message>
    <message>
        <source>Then the dotted meshes get their transfer vertices.</source>
        <translation>Dann erhalten die gepunkteten Zahneingriffe ihre Transferknoten.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Und %1 weitere.</translation>
    </message>
    <message>
        <source>Transfer vertex of %1</source>
        <translation>Transferknoten von %1</translation>
    </message>
    <message>
        <source>Branch %1 on level %2</source>
        <translation>Zweig %1 auf Ebene %2</translation>
    </message>
    <message>
        <source>It has no transfer vertex.</source>
        <translation>Es hat keinen Transferknoten.</translation>
    </message>
    <message>
        <source>Tidy the T-T graph</source>
        <translation>T-T-Graph ordnen</translation>
    </message>
    <message>
        <source>The derivation could not be worked out: %1</source>
        <translation>Die Herleitung konnte nicht berechnet werden: %1</translation>
    </message>
    <message>
        <source>The derivation appears here, both methods step by step.</source>
        <translation>Hier erscheint die Herleitung, beide Verfahren Schritt für Schritt.</translation>
    </message>
    <message>
        <source>The sections of the derivation</source>
        <translation>Abschnitte der Herleitung</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Write the derivation as a web page, PDF, LaTeX or Markdown</source>
        <translation>Herleitung als Webseite, PDF, LaTeX oder Markdown schreiben</translation>
    </message>
    <message>
        <source>The derivation is being worked out…</source>
        <translation>Die Herleitung wird berechnet …</translation>
    </message>
    <message>
        <source>Copy equation as LaTeX</source>
        <translation>Gleichung als LaTeX kopieren</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Text kopieren</translation>
    </message>
    <message>
        <source>Copy all as LaTeX</source>
        <translation>Alles als LaTeX kopieren</translation>
    </message>
    <message>
        <source>Copy all as Markdown</source>
        <translation>Alles als Markdown kopieren</translation>
    </message>
    <message>
        <source>Before the first step</source>
        <translation>Vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>%1 (saved)</source>
        <translation>%1 (gespeichert)</translation>
    </message>
    <message>
        <source>%1, shown now</source>
        <translation>%1, wird jetzt gezeigt</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, rückgängig gemacht</translation>
    </message>
    <message>
        <source>The dynamics could not be worked out: %1</source>
        <translation>Die Dynamik konnte nicht berechnet werden: %1</translation>
    </message>
    <message>
        <source>Masses</source>
        <translation>Massen</translation>
    </message>
    <message>
        <source>Mass and moments of inertia of every link, density and gravity</source>
        <translation>Masse und Trägheitsmomente jedes Glieds, Dichte und Schwerkraft</translation>
    </message>
    <message>
        <source>Inertia at the motors</source>
        <translation>Reduzierte Trägheit</translation>
    </message>
    <message>
        <source>How much of the inertia that each motor feels every link makes up (reflected inertia)</source>
        <translation>Welchen Anteil jedes Glied an der Trägheit hat, die ein Motor spürt (reduzierte Trägheit)</translation>
    </message>
    <message>
        <source>Equation of motion</source>
        <translation>Bewegungsgleichung</translation>
    </message>
    <message>
        <source>Generalised inertia, Coriolis and centrifugal torques, weight and loads in the inputs</source>
        <translation>Verallgemeinerte Trägheit, Coriolis- und Zentrifugalmomente, Gewicht und Lasten in den Antrieben</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>The motion that torques of the motors cause: simulated and played</source>
        <translation>Die Bewegung, die Momente der Motoren bewirken: simuliert und abgespielt</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Tabelle für eine Tabellenkalkulation kopieren</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV …</translation>
    </message>
    <message>
        <source>Export the table, or the simulated motion, to a CSV file</source>
        <translation>Tabelle oder simulierte Bewegung in eine CSV-Datei exportieren</translation>
    </message>
    <message>
        <source>Masses and motion appear here as soon as the mechanism is analysed.</source>
        <translation>Massen und Bewegung erscheinen hier, sobald der Mechanismus analysiert ist.</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: state masses of its links, or give its wheels teeth.</source>
        <translation>Eine Bewegung der Antriebe bewegt keine Masse: Geben Sie Massen der Glieder oder Zähnezahlen der Räder an.</translation>
    </message>
    <message>
        <source>At the moment that the 3D view shows.</source>
        <translation>Zu dem Zeitpunkt, den die 3D-Ansicht zeigt.</translation>
    </message>
    <message>
        <source>There is nothing to copy yet</source>
        <translation>Noch gibt es nichts zu kopieren</translation>
    </message>
    <message>
        <source>There is nothing to export yet</source>
        <translation>Noch gibt es nichts zu exportieren</translation>
    </message>
    <message>
        <source>masses.csv</source>
        <translation>massen.csv</translation>
    </message>
    <message>
        <source>reflected-inertia.csv</source>
        <translation>reduzierte-traegheit.csv</translation>
    </message>
    <message>
        <source>equation-of-motion.csv</source>
        <translation>bewegungsgleichung.csv</translation>
    </message>
    <message>
        <source>motion.csv</source>
        <translation>bewegung.csv</translation>
    </message>
    <message>
        <source>M: the generalised inertia of the inputs. h: what motors have to give at constant speeds, for Coriolis and centrifugal forces and for weight. τ: torques of the motors. ℓ: what the loads contribute.</source>
        <translation>M: verallgemeinerte Trägheit der Antriebe. h: was Motoren bei konstanten Drehzahlen für Coriolis- und Zentrifugalkräfte und für das Gewicht aufbringen müssen. τ: Momente der Motoren. ℓ: Beitrag der Lasten.</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>Gelenk %1</translation>
    </message>
    <message>
        <source>Link %1: %2 kg m² at %3, %4 % of all.</source>
        <translation>Glied %1: %2 kg m² bei %3, %4 % von allem.</translation>
    </message>
    <message>
        <source>moves no mass</source>
        <translation>bewegt keine Masse</translation>
    </message>
    <message>
        <source>%1 kg m²</source>
        <translation>%1 kg m²</translation>
    </message>
    <message>
        <source>The inertia that each link has at the motor while the other inputs stand still: for a link that turns about one axis its moment of inertia times the square of its ratio.</source>
        <translation>Trägheit, die jedes Glied am Motor hat, während die anderen Antriebe stillstehen: bei einem Glied, das sich um eine Achse dreht, sein Trägheitsmoment mal dem Quadrat seiner Übersetzung.</translation>
    </message>
    <message>
        <source>Double-click, or press F2, to state it; empty it to leave it to the solids.</source>
        <translation>Doppelklick oder F2, um sie anzugeben; leer lassen, damit sie aus den Körpern folgt.</translation>
    </message>
    <message>
        <source>Mass, kg</source>
        <translation>Masse, kg</translation>
    </message>
    <message>
        <source>A mass is at least 0 kg.</source>
        <translation>Eine Masse ist mindestens 0 kg.</translation>
    </message>
    <message>
        <source>Masses of the links</source>
        <translation>Massen der Glieder</translation>
    </message>
    <message>
        <source>The density of all solids, kg/m³; empty: that of steel</source>
        <translation>Dichte aller Körper, kg/m³; leer: die von Stahl</translation>
    </message>
    <message>
        <source>Density, kg/m³</source>
        <translation>Dichte, kg/m³</translation>
    </message>
    <message>
        <source>%1, steel</source>
        <translation>%1, Stahl</translation>
    </message>
    <message>
        <source>The acceleration of free fall in the base frame, m/s²: x, y, z</source>
        <translation>Fallbeschleunigung im Basissystem, m/s²: x, y, z</translation>
    </message>
    <message>
        <source>Gravity, m/s²</source>
        <translation>Schwerkraft, m/s²</translation>
    </message>
    <message>
        <source>A density is above 0.</source>
        <translation>Eine Dichte ist größer als 0.</translation>
    </message>
    <message>
        <source>Set density</source>
        <translation>Dichte ändern</translation>
    </message>
    <message>
        <source>Set gravity</source>
        <translation>Schwerkraft ändern</translation>
    </message>
    <message>
        <source>Set mass</source>
        <translation>Masse ändern</translation>
    </message>
    <message>
        <source>The motion could not be followed: %1</source>
        <translation>Die Bewegung konnte nicht verfolgt werden: %1</translation>
    </message>
    <message>
        <source>How much of the motion is followed</source>
        <translation>Wie weit die Bewegung verfolgt ist</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Drehzahlen</translation>
    </message>
    <message>
        <source>Speeds of the inputs, and of the joints that are selected, over time</source>
        <translation>Drehzahlen der Antriebe und der ausgewählten Gelenke über der Zeit</translation>
    </message>
    <message>
        <source>Torques</source>
        <translation>Momente</translation>
    </message>
    <message>
        <source>Torques of the motors over time</source>
        <translation>Momente der Motoren über der Zeit</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Kinetic and potential energy, the work of motors and loads, and their balance, over time</source>
        <translation>Kinetische und potentielle Energie, Arbeit von Motoren und Lasten und ihre Bilanz über der Zeit</translation>
    </message>
    <message>
        <source>Play in 3D</source>
        <translation>In 3D abspielen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>End the motion where it is now</source>
        <translation>Bewegung hier beenden</translation>
    </message>
    <message>
        <source>Follow the motion that these torques, the loads and weight cause</source>
        <translation>Der Bewegung folgen, die diese Momente, die Lasten und das Gewicht bewirken</translation>
    </message>
    <message>
        <source>There is nothing to move yet</source>
        <translation>Noch gibt es nichts zu bewegen</translation>
    </message>
    <message>
        <source>Show this motion in the 3D view instead of that of the input speeds</source>
        <translation>Diese Bewegung in der 3D-Ansicht zeigen statt der mit den Antriebsdrehzahlen</translation>
    </message>
    <message>
        <source>Simulate a motion first</source>
        <translation>Simulieren Sie zuerst eine Bewegung</translation>
    </message>
    <message>
        <source>Give the motors their torques, then Simulate: speeds, torques and energy appear here.</source>
        <translation>Geben Sie den Motoren ihre Momente und wählen Sie Simulieren: Drehzahlen, Momente und Energie erscheinen hier.</translation>
    </message>
    <message>
        <source>The motion is being followed …</source>
        <translation>Die Bewegung wird verfolgt …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>After %1 s: kinetic energy %2 J, potential %3 J, work of motors and loads %4 J; they balance but for %5 J.</source>
        <translation>Nach %1 s: kinetische Energie %2 J, potentielle %3 J, Arbeit von Motoren und Lasten %4 J; die Bilanz stimmt bis auf %5 J.</translation>
    </message>
    <message>
        <source>input</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>The joint that the motor drives.</source>
        <translation>Das Gelenk, das der Motor antreibt.</translation>
    </message>
    <message>
        <source>T, N m</source>
        <translation>T, N m</translation>
    </message>
    <message>
        <source>The torque of the motor at rest, by the tail of its joint on the head.</source>
        <translation>Moment des Motors im Stillstand, vom Fuß seines Gelenks auf die Spitze.</translation>
    </message>
    <message>
        <source>d, N m s</source>
        <translation>d, N m s</translation>
    </message>
    <message>
        <source>How much torque the motor loses for each rad/s of its joint: with the torque at rest over the no-load speed it is a direct-current motor at constant voltage.</source>
        <translation>Wie viel Moment der Motor je rad/s seines Gelenks verliert: mit Stillstandsmoment durch Leerlaufdrehzahl ist er ein Gleichstrommotor bei konstanter Spannung.</translation>
    </message>
    <message>
        <source>from, °</source>
        <translation>ab, °</translation>
    </message>
    <message>
        <source>The angle of the joint at the start, from the reference pose.</source>
        <translation>Winkel des Gelenks am Anfang, ab der Bezugslage.</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>The speed of the joint at the start.</source>
        <translation>Drehzahl des Gelenks am Anfang.</translation>
    </message>
    <message>
        <source>How long the motion is followed, in seconds.</source>
        <translation>Wie lange die Bewegung verfolgt wird, in Sekunden.</translation>
    </message>
    <message>
        <source>for, s</source>
        <translation>Dauer, s</translation>
    </message>
    <message>
        <source>The time is %1 s to %2 s.</source>
        <translation>Die Dauer beträgt %1 s bis %2 s.</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>Gelenk %1</translation>
    </message>
    <message>
        <source>Torque of the motor of joint %1, N m</source>
        <translation>Motormoment von Gelenk %1, N m</translation>
    </message>
    <message>
        <source>Torque that the motor of joint %1 loses for each rad/s, N m s</source>
        <translation>Moment, das der Motor von Gelenk %1 je rad/s verliert, N m s</translation>
    </message>
    <message>
        <source>Angle of joint %1 at the start, degrees</source>
        <translation>Anfangswinkel von Gelenk %1, Grad</translation>
    </message>
    <message>
        <source>Speed of joint %1 at the start, rad/s</source>
        <translation>Anfangsdrehzahl von Gelenk %1, rad/s</translation>
    </message>
    <message>
        <source>It is at least 0 N m s.</source>
        <translation>Es ist mindestens 0 N m s.</translation>
    </message>
    <message>
        <source>Torque, rate and power in every turning joint, and of what acts on links</source>
        <translation>Moment, Drehzahl und Leistung in jedem Drehgelenk und dessen, was an Gliedern wirkt</translation>
    </message>
    <message>
        <source>Torques of the brakes and clutches that are engaged</source>
        <translation>Momente der geschlossenen Bremsen und Kupplungen</translation>
    </message>
    <message>
        <source>What holds each link in its turning joint: force and moment</source>
        <translation>Was jedes Glied in seinem Drehgelenk hält: Kraft und Moment</translation>
    </message>
    <message>
        <source>What every element delivers to each of its links, seen from the ground</source>
        <translation>Was jedes Element an jedes seiner Glieder abgibt, vom Gestell aus gesehen</translation>
    </message>
    <message>
        <source>Power that goes round in loops, beside what goes through the train</source>
        <translation>Blindleistung, die in Schleifen umläuft, neben der, die durch das Getriebe geht</translation>
    </message>
    <message>
        <source>Torques of the couplings and efficiency in every state of the gearbox</source>
        <translation>Momente der Schaltelemente und Wirkungsgrad in jedem Schaltzustand des Getriebes</translation>
    </message>
    <message>
        <source>The torques could not be worked out: %1</source>
        <translation>Die Momente konnten nicht berechnet werden: %1</translation>
    </message>
    <message>
        <source>The state whose brakes and clutches are engaged</source>
        <translation>Der Schaltzustand, dessen Bremsen und Kupplungen geschlossen sind</translation>
    </message>
    <message>
        <source>Export the table with its units to a CSV file</source>
        <translation>Tabelle mit Einheiten in eine CSV-Datei exportieren</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>An efficiency is above 0 and at most 1.</source>
        <translation>Ein Wirkungsgrad ist größer als 0 und höchstens 1.</translation>
    </message>
    <message>
        <source>η of a mesh</source>
        <translation>η eines Zahneingriffs</translation>
    </message>
    <message>
        <source>The efficiency of meshes that state none: the power that a mesh delivers over what it takes, seen from its carrier. Empty: they lose nothing.</source>
        <translation>Wirkungsgrad der Zahneingriffe, die keinen angeben: abgegebene durch aufgenommene Leistung, vom Steg aus gesehen. Leer: verlustfrei.</translation>
    </message>
    <message>
        <source>fed, W</source>
        <translation>zugeführt, W</translation>
    </message>
    <message>
        <source>The power that loads and balances feed into the train.</source>
        <translation>Leistung, die Lasten und Ausgleichsmomente dem Getriebe zuführen.</translation>
    </message>
    <message>
        <source>taken, W</source>
        <translation>entnommen, W</translation>
    </message>
    <message>
        <source>The power that loads and balances take from the train.</source>
        <translation>Leistung, die Lasten und Ausgleichsmomente dem Getriebe entnehmen.</translation>
    </message>
    <message>
        <source>lost, W</source>
        <translation>verloren, W</translation>
    </message>
    <message>
        <source>What the meshes lose: fed less taken.</source>
        <translation>Was die Zahneingriffe verlieren: zugeführte minus entnommene Leistung.</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>Power taken over power fed.</source>
        <translation>Entnommene durch zugeführte Leistung.</translation>
    </message>
    <message>
        <source>backward</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>The efficiency of the same motion with all known torques reversed: the output drives.</source>
        <translation>Wirkungsgrad derselben Bewegung mit umgekehrten bekannten Momenten: Der Abtrieb treibt.</translation>
    </message>
    <message>
        <source>latent ratio</source>
        <translation>Wälzleistungsverhältnis</translation>
    </message>
    <message>
        <source>What all meshes pass, seen from their carriers, over the power fed: the losses are about this many times those of one mesh.</source>
        <translation>Leistung aller Zahneingriffe, von ihren Stegen aus gesehen, durch die zugeführte: Die Verluste sind etwa so viele Male die eines Zahneingriffs.</translation>
    </message>
    <message>
        <source>circulating, W</source>
        <translation>Blindleistung, W</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop of shafts and gear sets.</source>
        <translation>Die größte Leistung, die in einer Schleife von Wellen und Radsätzen umläuft.</translation>
    </message>
    <message>
        <source>Share by stiffness</source>
        <translation>Nach Steifigkeit aufteilen</translation>
    </message>
    <message>
        <source>Meshes that share a load in unknown parts: assume that all teeth are equally stiff, without clearance, on rigid bodies</source>
        <translation>Zahneingriffe, die eine Last in unbekannten Anteilen tragen: alle Zähne gleich steif, spielfrei und auf starren Körpern annehmen</translation>
    </message>
    <message>
        <source>as engaged</source>
        <translation>wie geschlossen</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>Schaltzustand %1</translation>
    </message>
    <message>
        <source>Torques and forces appear here as soon as the mechanism is analysed.</source>
        <translation>Momente und Kräfte erscheinen hier, sobald der Mechanismus analysiert ist.</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: their torques appear here.</source>
        <translation>Zeichnen Sie Drehgelenke und Zahneingriffe: Ihre Momente erscheinen hier.</translation>
    </message>
    <message>
        <source>There is no equilibrium: the reason is below.</source>
        <translation>Es gibt kein Gleichgewicht: Der Grund steht unten.</translation>
    </message>
    <message>
        <source>No brake or clutch is engaged: engage one in Gearbox, or choose a state.</source>
        <translation>Keine Bremse oder Kupplung ist geschlossen: Schließen Sie eine unter Schaltgetriebe oder wählen Sie einen Schaltzustand.</translation>
    </message>
    <message>
        <source>Forces need a unit of length whose size is known.</source>
        <translation>Kräfte brauchen eine Längeneinheit bekannter Größe.</translation>
    </message>
    <message>
        <source>No power flows.</source>
        <translation>Es fließt keine Leistung.</translation>
    </message>
    <message>
        <source>Without a motion there is no power.</source>
        <translation>Ohne Bewegung gibt es keine Leistung.</translation>
    </message>
    <message>
        <source>No power circulates.</source>
        <translation>Es läuft keine Blindleistung um.</translation>
    </message>
    <message>
        <source>Loops are found where every link but the planets turns on the ground.</source>
        <translation>Schleifen werden gefunden, wo jedes Glied außer den Planetenrädern im Gestell dreht.</translation>
    </message>
    <message>
        <source>There is nothing to show.</source>
        <translation>Es gibt nichts zu zeigen.</translation>
    </message>
    <message>
        <source>The two methods do not agree</source>
        <translation>Die beiden Verfahren stimmen nicht überein</translation>
    </message>
    <message>
        <source>locks itself</source>
        <translation>selbsthemmend</translation>
    </message>
    <message>
        <source>No load acts yet. Select a joint or a link, then + Load.</source>
        <translation>Noch wirkt keine Last. Wählen Sie ein Gelenk oder Glied aus, dann + Last.</translation>
    </message>
    <message>
        <source>+ Load</source>
        <translation>+ Last</translation>
    </message>
    <message>
        <source>A torque of 1 N m on the selected joint or link, or choose one</source>
        <translation>Ein Drehmoment von 1 N m am ausgewählten Gelenk oder Glied, oder wählen</translation>
    </message>
    <message>
        <source>Found at ▾</source>
        <translation>Gesucht an ▾</translation>
    </message>
    <message>
        <source>Balances: where torques are found that hold the loads. By itself the program takes the inputs that bear no load of their own.</source>
        <translation>Ausgleich: wo Momente gesucht werden, die den Lasten das Gleichgewicht halten. Von selbst nimmt das Programm die Antriebe ohne eigene Last.</translation>
    </message>
    <message>
        <source>N m</source>
        <translation>N m</translation>
    </message>
    <message>
        <source>N mm</source>
        <translation>N mm</translation>
    </message>
    <message>
        <source>kN m</source>
        <translation>kN m</translation>
    </message>
    <message>
        <source>The unit of the torques in this list; the document keeps N m</source>
        <translation>Einheit der Momente in dieser Liste; das Dokument behält N m</translation>
    </message>
    <message>
        <source>F on %1</source>
        <translation>F an %1</translation>
    </message>
    <message>
        <source>T in %1</source>
        <translation>T in %1</translation>
    </message>
    <message>
        <source>T on %1 about %2</source>
        <translation>T an %1 um %2</translation>
    </message>
    <message>
        <source>T on %1</source>
        <translation>T an %1</translation>
    </message>
    <message>
        <source>A force from outside on the link, N, in the base frame, at (%1) of the reference pose.</source>
        <translation>Äußere Kraft auf das Glied, N, im Basissystem, in (%1) der Bezugslage.</translation>
    </message>
    <message>
        <source>A torque that the joint&apos;s tail exerts on its head, about the direction of its axis; the head exerts the opposite one on the tail.</source>
        <translation>Moment, das der Fuß des Gelenks auf seine Spitze ausübt, um die Richtung seiner Achse; die Spitze übt das entgegengesetzte auf den Fuß aus.</translation>
    </message>
    <message>
        <source>A torque from outside on the link; the ground takes the reaction. Without an axis it is about the link&apos;s first axis on the way to the ground.</source>
        <translation>Äußeres Moment auf das Glied; das Gestell nimmt die Reaktion auf. Ohne Achse wirkt es um die erste Achse des Glieds auf dem Weg zum Gestell.</translation>
    </message>
    <message>
        <source>%1 of %2 loads are listed</source>
        <translation>%1 von %2 Lasten sind aufgeführt</translation>
    </message>
    <message>
        <source>Remove this load</source>
        <translation>Diese Last entfernen</translation>
    </message>
    <message>
        <source>Torque in a joint</source>
        <translation>Moment in einem Gelenk</translation>
    </message>
    <message>
        <source>Torque on a link</source>
        <translation>Moment an einem Glied</translation>
    </message>
    <message>
        <source>Inputs without a load</source>
        <translation>Antriebe ohne Last</translation>
    </message>
    <message>
        <source>Choose balances</source>
        <translation>Ausgleich wählen</translation>
    </message>
    <message>
        <source>Select in the drawing, or type: 8, 10</source>
        <translation>In der Zeichnung auswählen oder eingeben: 8, 10</translation>
    </message>
    <message>
        <source>A whole number, a fraction such as −2/3, or a decimal</source>
        <translation>Eine ganze Zahl, ein Bruch wie −2/3 oder eine Dezimalzahl</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>From one gear pair to the robot</source>
        <translation>Von einem Zahnradpaar bis zum Roboter</translation>
    </message>
    <message>
        <source>Open a lesson file…</source>
        <translation>Lektionsdatei öffnen …</translation>
    </message>
    <message>
        <source>Fresh question %1</source>
        <translation>Neue Frage %1</translation>
    </message>
    <message>
        <source>%1 of %2 fresh questions right at the first check</source>
        <translation>%1 von %2 neuen Fragen auf Anhieb richtig</translation>
    </message>
    <message>
        <source>You have mastered this lesson.</source>
        <translation>Sie beherrschen diese Lektion.</translation>
    </message>
    <message>
        <source>Start again? All answers on this device are deleted.</source>
        <translation>Neu beginnen? Alle Antworten auf diesem Gerät werden gelöscht.</translation>
    </message>
    <message>
        <source>What you write stays in this browser.</source>
        <translation>Was Sie schreiben, bleibt in diesem Browser.</translation>
    </message>
    <message>
        <source>Answer to step %1</source>
        <translation>Antwort zu Schritt %1</translation>
    </message>
    <message>
        <source>One drawing that is right</source>
        <translation>Eine richtige Zeichnung</translation>
    </message>
    <message>
        <source>This is drawn in GearGraph: Learn &gt; Lessons. It gives no points here.</source>
        <translation>Das wird in GearGraph gezeichnet: Lernen &gt; Lektionen. Hier gibt es dafür keine Punkte.</translation>
    </message>
    <message>
        <source>Two lessons have the id &quot;%1&quot;.</source>
        <translation>Zwei Lektionen haben die Kennung „%1“.</translation>
    </message>
    <message>
        <source>Where to begin</source>
        <translation>Wo beginnen</translation>
    </message>
    <message>
        <source>After the lesson “%1” you can answer this.</source>
        <translation>Nach der Lektion „%1“ können Sie das beantworten.</translation>
    </message>
    <message>
        <source>You have mastered this lesson. Review it from %1 on.</source>
        <translation>Sie beherrschen diese Lektion. Wiederholen Sie sie ab dem %1.</translation>
    </message>
    <message>
        <source>%1 of %2 right at once</source>
        <translation>%1 von %2 auf Anhieb richtig</translation>
    </message>
    <message>
        <source>Right at the first check, without a hint; one more is asked as long as some are missing</source>
        <translation>Richtig bei der ersten Prüfung, ohne Hinweis; solange welche fehlen, kommt eine weitere</translation>
    </message>
    <message>
        <source>Fresh questions</source>
        <translation>Neue Fragen</translation>
    </message>
    <message>
        <source>Where do I begin?</source>
        <translation>Wo beginne ich?</translation>
    </message>
    <message>
        <source>A question about each lesson in turn: it ends with the second one that is not right at the first check, and chooses the lesson of the first</source>
        <translation>Der Reihe nach eine Frage zu jeder Lektion: Der Test endet mit der zweiten, die nicht auf Anhieb richtig ist, und wählt die Lektion der ersten</translation>
    </message>
    <message>
        <source>review due</source>
        <translation>Wiederholung fällig</translation>
    </message>
    <message>
        <source>questions left</source>
        <translation>noch Fragen</translation>
    </message>
    <message>
        <source>After the start test: begin with “%1”.</source>
        <translation>Nach dem Eingangstest: Beginnen Sie mit „%1“.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Start test</source>
        <translation>Eingangstest</translation>
    </message>
    <message numerus="yes">
        <source>%n to review.</source>
        <translation>
            <numerusform>%n zu wiederholen.</numerusform>
            <numerusform>%n zu wiederholen.</numerusform>
        </translation>
    </message>
    <message>
        <source>A lesson of your own: it is reloaded whenever the file is saved</source>
        <translation>Eine eigene Lektion: Sie wird neu geladen, sooft die Datei gespeichert wird</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 von %2 Punkten</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Afterwards you can %1.</source>
        <translation>Danach können Sie: %1.</translation>
    </message>
    <message>
        <source>%1 lessons, %2 min. %3 done, about %4 min to go.</source>
        <translation>%1 Lektionen, %2 min. %3 erledigt, noch etwa %4 min.</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>%1 of %2 steps done</source>
        <translation>%1 von %2 Schritten erledigt</translation>
    </message>
    <message>
        <source>‹ Back</source>
        <translation>‹ Zurück</translation>
    </message>
    <message>
        <source>The step before (Alt+Left)</source>
        <translation>Voriger Schritt (Alt+Links)</translation>
    </message>
    <message>
        <source>Skip ›</source>
        <translation>Weiter ›</translation>
    </message>
    <message>
        <source>The next step (Alt+Right)</source>
        <translation>Nächster Schritt (Alt+Rechts)</translation>
    </message>
    <message>
        <source>‹ Course</source>
        <translation>‹ Kurs</translation>
    </message>
    <message>
        <source>All lessons, with your progress</source>
        <translation>Alle Lektionen mit Ihrem Fortschritt</translation>
    </message>
    <message>
        <source>2 points for a step that is right at once, 1 after a hint or a correction; the score never falls</source>
        <translation>2 Punkte für einen Schritt, der sofort richtig ist, 1 nach einem Hinweis oder einer Korrektur; der Punktestand sinkt nie</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>&amp;Hinweis</translation>
    </message>
    <message>
        <source>Where to look, then the rule, then the first half</source>
        <translation>Wo Sie hinsehen müssen, dann die Regel, dann die erste Hälfte</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Lösung zeigen</translation>
    </message>
    <message>
        <source>The answer; the step then gives no points</source>
        <translation>Die Lösung; der Schritt gibt dann keine Punkte</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Check the answer (Return)</source>
        <translation>Antwort prüfen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Begin the step</source>
        <translation>Schritt beginnen</translation>
    </message>
    <message>
        <source>Right. %1</source>
        <translation>Richtig. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) are wrong: look at those that are framed.</source>
        <translation>
            <numerusform>%n Feld ist falsch: Sehen Sie das umrahmte an.</numerusform>
            <numerusform>%n Felder sind falsch: Sehen Sie die umrahmten an.</numerusform>
        </translation>
    </message>
    <message>
        <source>This is not right. A hint tells where to look.</source>
        <translation>Das ist nicht richtig. Ein Hinweis sagt, wo Sie hinsehen müssen.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>Gezeigt: %1</translation>
    </message>
    <message>
        <source>%1, %2 min</source>
        <translation>%1, %2 min</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Score %1 of %2</source>
        <translation>Punkte %1 von %2</translation>
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
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Where to look, then the rule: hint %1 of %2</source>
        <translation>Wo Sie hinsehen müssen, dann die Regel: Hinweis %1 von %2</translation>
    </message>
    <message>
        <source>There are no more hints in this step.</source>
        <translation>In diesem Schritt gibt es keine weiteren Hinweise.</translation>
    </message>
    <message>
        <source>A drawing can be right in many ways: take a hint.</source>
        <translation>Eine Zeichnung kann auf viele Arten richtig sein: Nehmen Sie einen Hinweis.</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>Dies ist der erste Schritt.</translation>
    </message>
    <message>
        <source>Next lesson ›</source>
        <translation>Nächste Lektion ›</translation>
    </message>
    <message>
        <source>Next ›</source>
        <translation>Weiter ›</translation>
    </message>
    <message>
        <source>Leave ›</source>
        <translation>Verlassen ›</translation>
    </message>
    <message>
        <source>About GearGraph</source>
        <translation>Über GearGraph</translation>
    </message>
    <message>
        <source>&lt;b&gt;GearGraph %1&lt;/b&gt;&lt;p&gt;Draw, analyse and see geared mechanisms by the matroid and the T–T graph methods (Amirinezhad and Uyguroğlu, 2014).&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;GearGraph %1&lt;/b&gt;&lt;p&gt;Zahnradmechanismen zeichnen, analysieren und ansehen, mit dem Matroid- und dem T–T-Graph-Verfahren (Amirinezhad und Uyguroğlu, 2014).&lt;/p&gt;&lt;p&gt;MIT-Lizenz.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Einzelheiten kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>Crash report</source>
        <translation>Absturzbericht</translation>
    </message>
    <message>
        <source>GearGraph crashed on %1. A report says where in the program; it names neither documents nor what is in them.</source>
        <translation>GearGraph ist am %1 abgestürzt. Ein Bericht sagt, wo im Programm; er nennt weder Dokumente noch deren Inhalt.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Bericht zeigen</translation>
    </message>
    <message>
        <source>Read it, and decide then</source>
        <translation>Erst lesen, dann entscheiden</translation>
    </message>
    <message>
        <source>For a message to the developers</source>
        <translation>Für eine Nachricht an die Entwickler</translation>
    </message>
    <message>
        <source>The crash report was copied.</source>
        <translation>Der Absturzbericht wurde kopiert.</translation>
    </message>
    <message>
        <source>For good</source>
        <translation>Endgültig</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>It will be offered again</source>
        <translation>Er wird wieder angeboten</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Labels of rows and columns</source>
        <translation>Zeilen- und Spaltennamen</translation>
    </message>
    <message>
        <source>Byte order mark</source>
        <translation>Byte-Reihenfolge-Marke</translation>
    </message>
    <message>
        <source>Export %1 as CSV</source>
        <translation>%1 als CSV exportieren</translation>
    </message>
    <message>
        <source>What parts the columns</source>
        <translation>Was die Spalten trennt</translation>
    </message>
    <message>
        <source>Numbers with a decimal comma are quoted where commas part the columns</source>
        <translation>Zahlen mit Dezimalkomma stehen in Anführungszeichen, wenn Kommas die Spalten trennen</translation>
    </message>
    <message>
        <source>Without them the file holds the entries alone</source>
        <translation>Ohne sie enthält die Datei nur die Einträge</translation>
    </message>
    <message>
        <source>Begins the file with a mark by which spreadsheet programs know UTF-8</source>
        <translation>Beginnt die Datei mit einer Marke, an der Tabellenkalkulationen UTF-8 erkennen</translation>
    </message>
    <message>
        <source>Columns parted by</source>
        <translation>Spaltentrenner</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The clipboard holds no links: %1</source>
        <translation>Die Zwischenablage enthält keine Glieder: %1</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>%1 kopiert</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Glied</translation>
    </message>
    <message>
        <source>1 mesh</source>
        <translation>1 Eingriff</translation>
    </message>
    <message>
        <source>%1 joints</source>
        <translation>%1 Gelenke</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 Gelenk</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 Glieder</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>The clipboard is empty.</source>
        <translation>Die Zwischenablage ist leer.</translation>
    </message>
    <message>
        <source>The clipboard holds no links.</source>
        <translation>Die Zwischenablage enthält keine Glieder.</translation>
    </message>
    <message>
        <source>What the clipboard holds is too large to be a mechanism.</source>
        <translation>Der Inhalt der Zwischenablage ist zu groß für einen Mechanismus.</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Pasted as it was drawn in %1: check the lengths, which count in %2 here.</source>
        <translation>Eingefügt, wie in %1 gezeichnet: Prüfen Sie die Längen, die hier in %2 zählen.</translation>
    </message>
    <message>
        <source>Make %1 planets</source>
        <translation>%1 Planetenräder anlegen</translation>
    </message>
    <message>
        <source>Insert %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Exporting %1.</source>
        <translation>%1 wird exportiert.</translation>
    </message>
    <message>
        <source>Give up this export; nothing is written</source>
        <translation>Diesen Export abbrechen; es wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Exporting %1: %2 of %3 pictures.</source>
        <translation>%1 wird exportiert: %2 von %3 Bildern.</translation>
    </message>
    <message>
        <source>The export of %1 was stopped; nothing was written.</source>
        <translation>Der Export von %1 wurde angehalten; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>GearGraph documents (*.geargraph);;All files (*)</source>
        <translation>GearGraph-Dokumente (*.geargraph);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Schritte des Verlaufs</translation>
    </message>
    <message>
        <source>A click on a step, or Return, goes there. Steps below it can be repeated until something else is drawn.</source>
        <translation>Ein Klick auf einen Schritt oder die Eingabetaste geht dorthin. Schritte darunter können wiederholt werden, bis etwas anderes gezeichnet wird.</translation>
    </message>
    <message>
        <source>The gears appear here. Draw the first link: L, then click.</source>
        <translation>Hier erscheinen die Zahnräder. Zeichnen Sie das erste Glied: L, dann klicken.</translation>
    </message>
    <message>
        <source>The gears appear when the turning joints tie every link to the ground and close no loop.</source>
        <translation>Die Zahnräder erscheinen, wenn die Drehgelenke jedes Glied mit dem Gestell verbinden und keine Schleife schließen.</translation>
    </message>
    <message>
        <source>The 3D view shows trains of up to %1 links; this one has %2.</source>
        <translation>Die 3D-Ansicht zeigt Getriebe mit bis zu %1 Gliedern; dieses hat %2.</translation>
    </message>
    <message>
        <source>The gears appear when a mesh joins two of the links: G, then drag.</source>
        <translation>Die Zahnräder erscheinen, wenn ein Zahneingriff zwei Glieder verbindet: G, dann ziehen.</translation>
    </message>
    <message>
        <source>T–T graph</source>
        <translation>T–T-Graph</translation>
    </message>
    <message>
        <source>Schematic</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>The views could not be updated: %1.</source>
        <translation>Die Ansichten konnten nicht erneuert werden: %1.</translation>
    </message>
    <message>
        <source>Shown as before the last changes. %1</source>
        <translation>Gezeigt wie vor den letzten Änderungen. %1</translation>
    </message>
    <message>
        <source>This matrix needs a mechanism without errors.</source>
        <translation>Diese Matrix braucht einen Mechanismus ohne Fehler.</translation>
    </message>
    <message>
        <source>This matrix needs the turning joints to be a spanning tree.</source>
        <translation>Für diese Matrix müssen die Drehgelenke einen Spannbaum bilden.</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (schreibgeschützt)</translation>
    </message>
    <message>
        <source>Notices</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 von %1</translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation>Der Speicher reicht für das Bild nicht aus.</translation>
    </message>
    <message>
        <source>Of this size:</source>
        <translation>In dieser Größe:</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Hell auf dunkel</translation>
    </message>
    <message>
        <source>Fit everything into the picture</source>
        <translation>Alles in das Bild einpassen</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>SVG, lines and text</source>
        <translation>SVG, Linien und Text</translation>
    </message>
    <message>
        <source>PDF, lines and text</source>
        <translation>PDF, Linien und Text</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, Pixel</translation>
    </message>
    <message>
        <source>PNG, a folder of pictures</source>
        <translation>PNG, ein Ordner mit Bildern</translation>
    </message>
    <message>
        <source>GLB, the solids in their present pose</source>
        <translation>GLB, die Körper in ihrer jetzigen Lage</translation>
    </message>
    <message>
        <source>Without it the picture is as large as the drawing.</source>
        <translation>Ohne sie ist das Bild so groß wie die Zeichnung.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>None: one picture</source>
        <translation>Keine: ein Bild</translation>
    </message>
    <message>
        <source>Turntable: once round</source>
        <translation>Drehteller: einmal herum</translation>
    </message>
    <message>
        <source>Motion: one period</source>
        <translation>Bewegung: eine Periode</translation>
    </message>
    <message>
        <source>A minute where the motion has no period</source>
        <translation>Eine Minute, wo die Bewegung keine Periode hat</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> Bilder</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> je Sekunde</translation>
    </message>
    <message>
        <source>The 3D view is made of pixels.</source>
        <translation>Die 3D-Ansicht besteht aus Pixeln.</translation>
    </message>
    <message>
        <source>Only the 3D view has it.</source>
        <translation>Nur die 3D-Ansicht hat das.</translation>
    </message>
    <message>
        <source>Export pictures into the new folder</source>
        <translation>Bilder in den neuen Ordner exportieren</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Ordner (*)</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>The 3D view is empty: there is nothing to export.</source>
        <translation>Die 3D-Ansicht ist leer: Es gibt nichts zu exportieren.</translation>
    </message>
    <message>
        <source>Copied the drawing as a picture</source>
        <translation>Zeichnung als Bild kopiert</translation>
    </message>
    <message>
        <source>The 3D view is empty: there is nothing to copy.</source>
        <translation>Die 3D-Ansicht ist leer: Es gibt nichts zu kopieren.</translation>
    </message>
    <message>
        <source>Copied the 3D view as a picture</source>
        <translation>3D-Ansicht als Bild kopiert</translation>
    </message>
    <message>
        <source>Sent to the printer</source>
        <translation>An den Drucker gesendet</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>How fast the motion is shown; a double click is 1.0×</source>
        <translation>Wie schnell die Bewegung gezeigt wird; ein Doppelklick ist 1,0×</translation>
    </message>
    <message>
        <source>Speed of the motion</source>
        <translation>Geschwindigkeit der Bewegung</translation>
    </message>
    <message>
        <source>Pause the motion (Space)</source>
        <translation>Bewegung anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Play the motion (Space)</source>
        <translation>Bewegung abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Power flows under loads: add one in Forces.</source>
        <translation>Leistung fließt unter Lasten: Fügen Sie unter Kräfte eine hinzu.</translation>
    </message>
    <message>
        <source>The loads are not in balance: Forces names what is missing.</source>
        <translation>Die Lasten sind nicht im Gleichgewicht: Unter Kräfte steht, was fehlt.</translation>
    </message>
    <message>
        <source>The ground</source>
        <translation>Gestell</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Glied %1</translation>
    </message>
    <message>
        <source>Link %1, %2</source>
        <translation>Glied %1, %2</translation>
    </message>
    <message>
        <source>Esc or F11 ends the presentation, Space plays.  Alt+1, Alt+2, … show and hide panels.</source>
        <translation>Esc oder F11 beendet die Präsentation, die Leertaste spielt ab.  Alt+1, Alt+2, … zeigen und verbergen Bereiche.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt verwendet</translation>
    </message>
    <message>
        <source>No file has been opened yet</source>
        <translation>Es wurde noch keine Datei geöffnet</translation>
    </message>
    <message>
        <source>There is nothing drawn to derive anything for.</source>
        <translation>Es ist nichts gezeichnet, wofür etwas herzuleiten wäre.</translation>
    </message>
    <message>
        <source>A derivation of more than %1 links is not written: it would be too long to read.</source>
        <translation>Eine Herleitung für mehr als %1 Glieder wird nicht geschrieben: Sie wäre zu lang zum Lesen.</translation>
    </message>
    <message>
        <source>Export derivation</source>
        <translation>Herleitung exportieren</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)</source>
        <translation>Webseite (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)</translation>
    </message>
    <message>
        <source>The solution is still being worked out. Try again in a moment.</source>
        <translation>Die Lösung wird noch berechnet. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>The export was stopped.</source>
        <translation>Der Export wurde angehalten.</translation>
    </message>
    <message>
        <source>Export handout</source>
        <translation>Handout exportieren</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>about x, °</source>
        <translation>um x, °</translation>
    </message>
    <message>
        <source>about y, °</source>
        <translation>um y, °</translation>
    </message>
    <message>
        <source>about z, °</source>
        <translation>um z, °</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>Another STL, OBJ, PLY or GLB file</source>
        <translation>Eine weitere STL-, OBJ-, PLY- oder GLB-Datei</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Lengths in the document&apos;s unit. A file is turned about x, then y, then z, and moved, in the drawn pose; it then moves with its link.</source>
        <translation>Längen in der Einheit des Dokuments. Eine Datei wird in der gezeichneten Lage um x, dann y, dann z gedreht und verschoben; danach bewegt sie sich mit ihrem Glied.</translation>
    </message>
    <message>
        <source>3D files of link %1</source>
        <translation>3D-Dateien von Glied %1</translation>
    </message>
    <message>
        <source>Place a 3D file</source>
        <translation>3D-Datei platzieren</translation>
    </message>
    <message>
        <source>3D file</source>
        <translation>3D-Datei</translation>
    </message>
    <message>
        <source>3D files (*.stl *.obj *.ply *.glb);;All files (*)</source>
        <translation>3D-Dateien (*.stl *.obj *.ply *.glb);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Wear a 3D file</source>
        <translation>3D-Datei anhängen</translation>
    </message>
    <message>
        <source>Take off a 3D file</source>
        <translation>3D-Datei abnehmen</translation>
    </message>
    <message>
        <source>In a drawing</source>
        <translation>In einer Zeichnung</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>Abspielen, anhalten</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Blatt verschieben</translation>
    </message>
    <message>
        <source>Space or middle button, and drag</source>
        <translation>Leertaste oder mittlere Taste und ziehen</translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation>An der Maus zoomen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Fit what is selected</source>
        <translation>Auswahl einpassen</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Umschalt+F</translation>
    </message>
    <message>
        <source>Nudge; finer</source>
        <translation>Schrittweise verschieben; feiner</translation>
    </message>
    <message>
        <source>Arrow keys; with Shift</source>
        <translation>Pfeiltasten; mit Umschalt</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Zur Auswahl hinzufügen</translation>
    </message>
    <message>
        <source>Shift or Ctrl, and click</source>
        <translation>Umschalt oder Strg und klicken</translation>
    </message>
    <message>
        <source>Drag without snapping</source>
        <translation>Ohne Einrasten ziehen</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Next, last element; besides</source>
        <translation>Nächstes, voriges Element; zusätzlich</translation>
    </message>
    <message>
        <source>Page down, up; with Shift</source>
        <translation>Bild ab, auf; mit Umschalt</translation>
    </message>
    <message>
        <source>The nearest element that way</source>
        <translation>Nächstes Element in dieser Richtung</translation>
    </message>
    <message>
        <source>Ctrl and arrow key</source>
        <translation>Strg und Pfeiltaste</translation>
    </message>
    <message>
        <source>As a click on the element</source>
        <translation>Wie ein Klick auf das Element</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabetaste</translation>
    </message>
    <message>
        <source>Give up, deselect, back to Select</source>
        <translation>Abbrechen, Auswahl aufheben, zurück zu Auswählen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>In der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Step back, step on</source>
        <translation>Schritt zurück, Schritt vor</translation>
    </message>
    <message>
        <source>Comma, point</source>
        <translation>Komma, Punkt</translation>
    </message>
    <message>
        <source>F, Home</source>
        <translation>F, Pos1</translation>
    </message>
    <message>
        <source>Isometric, front, right, top</source>
        <translation>Isometrisch, vorn, rechts, oben</translation>
    </message>
    <message>
        <source>0, 1, 2, 3</source>
        <translation>0, 1, 2, 3</translation>
    </message>
    <message>
        <source>Turn the train</source>
        <translation>Getriebe drehen</translation>
    </message>
    <message>
        <source>Drag a gear</source>
        <translation>An einem Zahnrad ziehen</translation>
    </message>
    <message>
        <source>Turn a part by hand</source>
        <translation>Ein Teil von Hand drehen</translation>
    </message>
    <message>
        <source>Ctrl, and drag</source>
        <translation>Strg und ziehen</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umkreisen</translation>
    </message>
    <message>
        <source>Drag elsewhere, arrow keys</source>
        <translation>Anderswo ziehen, Pfeiltasten</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Shift with drag or arrow keys</source>
        <translation>Umschalt mit Ziehen oder Pfeiltasten</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Wheel, + and −</source>
        <translation>Rad, + und −</translation>
    </message>
    <message>
        <source>Next, last link</source>
        <translation>Nächstes, voriges Glied</translation>
    </message>
    <message>
        <source>Page down, Page up</source>
        <translation>Bild ab, Bild auf</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>New mechanism</source>
        <translation>Neuer Mechanismus</translation>
    </message>
    <message>
        <source>An empty sheet with the ground on it</source>
        <translation>Ein leeres Blatt mit dem Gestell</translation>
    </message>
    <message>
        <source>Open an example…</source>
        <translation>Ein Beispiel öffnen…</translation>
    </message>
    <message>
        <source>All sets: belts, wrists, strain wave, cycloidal and RV reducers, too</source>
        <translation>Alle Radsätze, auch Riemen, Handgelenke, Wellgetriebe, Zykloid- und RV-Getriebe</translation>
    </message>
    <message>
        <source>More sets…</source>
        <translation>Weitere Radsätze…</translation>
    </message>
    <message>
        <source>Choose teeth and ratio, and insert it: %1</source>
        <translation>Zähnezahlen und Übersetzung wählen und einfügen: %1</translation>
    </message>
    <message>
        <source>Draw links and joints by hand: the tool Link, then click on the sheet</source>
        <translation>Glieder und Gelenke von Hand zeichnen: das Werkzeug Glied, dann auf das Blatt klicken</translation>
    </message>
    <message>
        <source>Draw, or insert a set</source>
        <translation>Zeichnen oder einen Radsatz einfügen</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Anfangen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open a document; it can be dropped on the window, too</source>
        <translation>Ein Dokument öffnen; es kann auch auf das Fenster gezogen werden</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt verwendet</translation>
    </message>
    <message>
        <source>Documents that you open or save are listed here.</source>
        <translation>Hier stehen Dokumente, die Sie öffnen oder speichern.</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>n %1</source>
        <translation>n %1</translation>
    </message>
    <message>
        <source>t %1</source>
        <translation>t %1</translation>
    </message>
    <message>
        <source>c %1</source>
        <translation>c %1</translation>
    </message>
    <message>
        <source>rank –</source>
        <translation>Rang –</translation>
    </message>
    <message>
        <source>DOF –</source>
        <translation>F –</translation>
    </message>
    <message>
        <source>rank %1</source>
        <translation>Rang %1</translation>
    </message>
    <message>
        <source>DOF %1</source>
        <translation>F %1</translation>
    </message>
    <message>
        <source>rank %1 + %2</source>
        <translation>Rang %1 + %2</translation>
    </message>
    <message>
        <source>DOF %1 (engaged: %2)</source>
        <translation>F %1 (geschlossen: %2)</translation>
    </message>
    <message>
        <source>Select, move, and change what is drawn</source>
        <translation>Auswählen, verschieben und ändern, was gezeichnet ist</translation>
    </message>
    <message>
        <source>Draw links: click on an empty place</source>
        <translation>Glieder zeichnen: auf eine leere Stelle klicken</translation>
    </message>
    <message>
        <source>Draw a turning joint: drag from a link to the link it carries</source>
        <translation>Ein Drehgelenk zeichnen: von einem Glied zu dem ziehen, das es trägt</translation>
    </message>
    <message>
        <source>Draw a gear mesh: drag from a gear to the one it drives</source>
        <translation>Einen Zahneingriff zeichnen: von einem Rad zu dem ziehen, das es treibt</translation>
    </message>
    <message>
        <source>Drive a joint: click a turning joint or the link it carries</source>
        <translation>Ein Gelenk antreiben: auf ein Drehgelenk oder das getragene Glied klicken</translation>
    </message>
    <message>
        <source>Move the sheet; the middle mouse button does so with any tool</source>
        <translation>Das Blatt verschieben; die mittlere Maustaste tut das mit jedem Werkzeug</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>A document with the ground and nothing else</source>
        <translation>Ein Dokument nur mit dem Gestell</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Neues &amp;Fenster</translation>
    </message>
    <message>
        <source>Another window with an empty document</source>
        <translation>Ein weiteres Fenster mit leerem Dokument</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>S&amp;tartseite</translation>
    </message>
    <message>
        <source>New document, recent documents and examples</source>
        <translation>Neues Dokument, zuletzt verwendete Dokumente und Beispiele</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen …</translation>
    </message>
    <message>
        <source>Open a document</source>
        <translation>Ein Dokument öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Das Dokument speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the document under another name</source>
        <translation>Das Dokument unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Zu&amp;r Datei zurückkehren</translation>
    </message>
    <message>
        <source>Reload the file; this can be undone</source>
        <translation>Die Datei neu laden; das kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Reopen w&amp;indows at start</source>
        <translation>Fenster beim Start &amp;wieder öffnen</translation>
    </message>
    <message>
        <source>Open the documents of the last time when the program starts without one</source>
        <translation>Die Dokumente vom letzten Mal öffnen, wenn das Programm ohne eines startet</translation>
    </message>
    <message>
        <source>Export the matrix that is shown, with its labels</source>
        <translation>Die gezeigte Matrix mit Zeilen- und Spaltennamen exportieren</translation>
    </message>
    <message>
        <source>Export pict&amp;ure…</source>
        <translation>B&amp;ild exportieren …</translation>
    </message>
    <message>
        <source>Export a drawing as SVG, PDF or PNG, or the 3D view as PNG</source>
        <translation>Eine Zeichnung als SVG, PDF oder PNG oder die 3D-Ansicht als PNG exportieren</translation>
    </message>
    <message>
        <source>Export &amp;derivation…</source>
        <translation>&amp;Herleitung exportieren …</translation>
    </message>
    <message>
        <source>Print and text</source>
        <translation>Druck und Text</translation>
    </message>
    <message>
        <source>CAD and making</source>
        <translation>CAD und Fertigung</translation>
    </message>
    <message>
        <source>Simulators and control</source>
        <translation>Simulatoren und Regelung</translation>
    </message>
    <message>
        <source>Web and class</source>
        <translation>Web und Unterricht</translation>
    </message>
    <message>
        <source>Data and graphs</source>
        <translation>Daten und Graphen</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>of the link between</source>
        <translation>von der die das des zwischen glied</translation>
    </message>
    <message>
        <source>to and against</source>
        <translation>zu und gegen</translation>
    </message>
    <message>
        <source>A ratio holds the answer: it is told when the step is right or shown.</source>
        <translation>Eine Übersetzung enthält die Antwort: Sie wird genannt, wenn der Schritt richtig oder gezeigt ist.</translation>
    </message>
    <message>
        <source>Enter selects both.</source>
        <translation>Die Eingabetaste wählt beide aus.</translation>
    </message>
    <message>
        <source>Exactly, in every motion: %1 turns %3 times as fast as %2, the other way round.</source>
        <translation>Exakt, in jeder Bewegung: %1 dreht sich %3-mal so schnell wie %2, andersherum.</translation>
    </message>
    <message>
        <source>Exactly, in every motion: %1 turns %3 times as fast as %2, the same way round.</source>
        <translation>Exakt, in jeder Bewegung: %1 dreht sich %3-mal so schnell wie %2, gleichsinnig.</translation>
    </message>
    <message>
        <source>With the speeds that the inputs have now: with others it is another.</source>
        <translation>Bei den jetzigen Geschwindigkeiten der Antriebe: bei anderen ist sie eine andere.</translation>
    </message>
    <message>
        <source>There is no ratio to %1, which stands still.</source>
        <translation>Zu %1 gibt es keine Übersetzung: Es steht still.</translation>
    </message>
    <message>
        <source>They turn about axes that are not parallel, or about several at once: the results have their speeds about each axis.</source>
        <translation>Sie drehen sich um Achsen, die nicht parallel sind, oder um mehrere zugleich: Die Ergebnisse nennen ihre Geschwindigkeiten um jede Achse.</translation>
    </message>
    <message>
        <source>There is no exact solution now: Problems says what is missing.</source>
        <translation>Jetzt gibt es keine exakte Lösung: Probleme sagt, was fehlt.</translation>
    </message>
    <message>
        <source>Hold %1 with a brake</source>
        <translation>%1 mit einer Bremse halten</translation>
    </message>
    <message>
        <source>Release the brake of %1</source>
        <translation>Die Bremse von %1 lösen</translation>
    </message>
    <message>
        <source>Its brake is engaged already.</source>
        <translation>Seine Bremse ist schon geschlossen.</translation>
    </message>
    <message>
        <source>No brake holds it.</source>
        <translation>Keine Bremse hält es.</translation>
    </message>
    <message>
        <source>Changes the document; one step back (Ctrl+Z) undoes it.</source>
        <translation>Ändert das Dokument; ein Schritt zurück (Strg+Z) macht es rückgängig.</translation>
    </message>
    <message>
        <source>Mesh %1: %2 teeth on link %3, %4 on link %5</source>
        <translation>Eingriff %1: %2 Zähne an Glied %3, %4 an Glied %5</translation>
    </message>
    <message>
        <source>now %1 : %2</source>
        <translation>jetzt %1 : %2</translation>
    </message>
    <message>
        <source>It has these teeth already.</source>
        <translation>Er hat diese Zähne schon.</translation>
    </message>
    <message>
        <source>ratio i</source>
        <translation>übersetzung verhältnis i</translation>
    </message>
    <message>
        <source>hold brake fix</source>
        <translation>halte halten bremse bremsen</translation>
    </message>
    <message>
        <source>release free</source>
        <translation>löse lösen freigeben</translation>
    </message>
    <message>
        <source>teeth z</source>
        <translation>zähne z</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Export graphs, matrices, derivations, drawings, pictures, solids and models for other programs, with all their options, and see first what will be written</source>
        <translation>Graphen, Matrizen, Herleitungen, Zeichnungen, Bilder, Körper und Modelle für andere Programme exportieren, mit allen Einstellungen, und vorher sehen, was geschrieben wird</translation>
    </message>
    <message>
        <source>Export &amp;matrix as CSV…</source>
        <translation>&amp;Matrix als CSV exportieren …</translation>
    </message>
    <message>
        <source>All panels back to their places, in this window and in those to come</source>
        <translation>Alle Bereiche zurück an ihre Plätze, in diesem und in künftigen Fenstern</translation>
    </message>
    <message>
        <source>&amp;Handout for the class</source>
        <translation>Handout für die &amp;Klasse</translation>
    </message>
    <message>
        <source>Writes a page for any browser beside the document, at once: drawings, matrices, derivation and the train in 3D, with inputs that move</source>
        <translation>Schreibt sofort eine Seite für jeden Browser neben das Dokument: Zeichnungen, Matrizen, Herleitung und das Getriebe in 3D, mit beweglichen Antrieben</translation>
    </message>
    <message>
        <source>mechanism</source>
        <translation>Mechanismus</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Wofür?</translation>
    </message>
    <message>
        <source>Sets all options of this format back to what holds without them</source>
        <translation>Setzt alle Einstellungen dieses Formats auf das zurück, was ohne sie gilt</translation>
    </message>
    <message>
        <source>Asks where, and writes it</source>
        <translation>Fragt wohin, und schreibt es</translation>
    </message>
    <message>
        <source>%1 (a folder with %2 files, %3)</source>
        <translation>%1 (ein Ordner mit %2 Dateien, %3)</translation>
    </message>
    <message>
        <source>Exported %1 into %2.</source>
        <translation>%1 nach %2 exportiert.</translation>
    </message>
    <message>
        <source>Opens it with the program of this kind of file</source>
        <translation>Öffnet es mit dem Programm für solche Dateien</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Opens the folder it is in</source>
        <translation>Öffnet den Ordner, in dem es liegt</translation>
    </message>
    <message>
        <source>The file stays where it is</source>
        <translation>Die Datei bleibt, wo sie ist</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>No program opens %1 here.</source>
        <translation>Kein Programm öffnet hier %1.</translation>
    </message>
    <message>
        <source>Show what would be written</source>
        <translation>Zeigen, was geschrieben würde</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Working out what would be written…</source>
        <translation>Was geschrieben würde, wird ermittelt …</translation>
    </message>
    <message>
        <source>Makes the files without keeping them: with a train as large as this it takes a while</source>
        <translation>Macht die Dateien, ohne sie zu behalten: bei einem so großen Getriebe dauert es eine Weile</translation>
    </message>
    <message>
        <source>Files that would be written</source>
        <translation>Dateien, die geschrieben würden</translation>
    </message>
    <message>
        <source>Beginning of the file</source>
        <translation>Anfang der Datei</translation>
    </message>
    <message>
        <source>Picture of what would be written</source>
        <translation>Bild dessen, was geschrieben würde</translation>
    </message>
    <message>
        <source>Working out what would be written: %1 %</source>
        <translation>Was geschrieben würde, wird ermittelt: %1 %</translation>
    </message>
    <message>
        <source>Made with all its pictures when it is exported. This is one of them.</source>
        <translation>Beim Export werden alle Bilder gemacht. Dies ist eines davon.</translation>
    </message>
    <message>
        <source>A folder with %1 files, %2</source>
        <translation>Ein Ordner mit %1 Dateien, %2</translation>
    </message>
    <message>
        <source>%1 files, %2</source>
        <translation>%1 Dateien, %2</translation>
    </message>
    <message>
        <source>A file for programs: nothing of it is read by people.</source>
        <translation>Eine Datei für Programme: Menschen lesen nichts daraus.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Erneut exp&amp;ortieren</translation>
    </message>
    <message>
        <source>Writes %1 again, with the same options</source>
        <translation>Schreibt %1 noch einmal, mit denselben Einstellungen</translation>
    </message>
    <message>
        <source>This document has not been exported yet</source>
        <translation>Dieses Dokument ist noch nicht exportiert worden</translation>
    </message>
    <message>
        <source>Exports of this document by File &gt; Export are listed here</source>
        <translation>Hier stehen die Exporte dieses Dokuments durch Datei &gt; Exportieren</translation>
    </message>
    <message>
        <source>The folder %1 could not be made.</source>
        <translation>Der Ordner %1 konnte nicht angelegt werden.</translation>
    </message>
    <message>
        <source>GearGraph: keyboard shortcuts</source>
        <translation>GearGraph: Tastenkürzel</translation>
    </message>
    <message>
        <source>On one page, also into a PDF file</source>
        <translation>Auf einer Seite, auch in eine PDF-Datei</translation>
    </message>
    <message>
        <source>The two methods differ at one joint. Please report this document.</source>
        <translation>Die beiden Verfahren unterscheiden sich an einem Gelenk. Bitte melden Sie dieses Dokument.</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism, as a web page, PDF, LaTeX or Markdown</source>
        <translation>Beide Verfahren Schritt für Schritt für diesen Mechanismus, als Webseite, PDF, LaTeX oder Markdown</translation>
    </message>
    <message>
        <source>Export &amp;handout…</source>
        <translation>H&amp;andout exportieren …</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Print the drawings and the derivation, or look at the pages first</source>
        <translation>Zeichnungen und Herleitung drucken oder die Seiten zuerst ansehen</translation>
    </message>
    <message>
        <source>Show the &amp;derivation</source>
        <translation>&amp;Herleitung zeigen</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism</source>
        <translation>Beide Verfahren Schritt für Schritt für diesen Mechanismus</translation>
    </message>
    <message>
        <source>&amp;Compare the methods</source>
        <translation>&amp;Verfahren vergleichen</translation>
    </message>
    <message>
        <source>Both methods side by side, counted for this mechanism</source>
        <translation>Beide Verfahren nebeneinander, für diesen Mechanismus gezählt</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Lektionen …</translation>
    </message>
    <message>
        <source>A course from one gear pair to the robot, with tasks that are checked; in a window of its own</source>
        <translation>Ein Kurs vom Zahnradpaar bis zum Roboter, mit Aufgaben, die geprüft werden; in einem eigenen Fenster</translation>
    </message>
    <message>
        <source>Open a lesson &amp;file…</source>
        <translation>Lektions&amp;datei öffnen …</translation>
    </message>
    <message>
        <source>Preview a lesson of your own: it is reloaded whenever the file is saved</source>
        <translation>Vorschau einer eigenen Lektion: Sie wird neu geladen, sooft die Datei gespeichert wird</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>F&amp;enster schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Alle Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>&amp;Verlauf …</translation>
    </message>
    <message>
        <source>All steps as a list; a click goes to any of them</source>
        <translation>Alle Schritte als Liste; ein Klick geht zu jedem davon</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Copy what is selected, and delete it</source>
        <translation>Die Auswahl kopieren und löschen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected links with the joints and meshes between them</source>
        <translation>Die ausgewählten Glieder mit den Gelenken und Zahneingriffen dazwischen kopieren</translation>
    </message>
    <message>
        <source>Copy as p&amp;icture</source>
        <translation>Als &amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Copy the drawing in front, or the 3D view where it has the focus, as SVG and PNG</source>
        <translation>Die vordere Zeichnung, oder die 3D-Ansicht, wenn sie den Fokus hat, als SVG und PNG kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Insert what was copied, in this window or in another</source>
        <translation>Einfügen, was in diesem oder einem anderen Fenster kopiert wurde</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>A copy of the selection in the drawing</source>
        <translation>Eine Kopie der Auswahl in der Zeichnung</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete what is selected, and what needs it</source>
        <translation>Löschen, was ausgewählt ist und was davon abhängt</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Rename the selected link</source>
        <translation>Das ausgewählte Glied umbenennen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Alle&amp;s auswählen</translation>
    </message>
    <message>
        <source>Select everything</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Exchange tail and head of the selected arrows</source>
        <translation>Fuß und Spitze der ausgewählten Pfeile tauschen</translation>
    </message>
    <message>
        <source>Make &amp;ground</source>
        <translation>Zum &amp;Gestell machen</translation>
    </message>
    <message>
        <source>Makes the selected link the ground</source>
        <translation>Macht das ausgewählte Glied zum Gestell</translation>
    </message>
    <message>
        <source>&amp;Attach a gear</source>
        <translation>&amp;Zahnrad anfügen</translation>
    </message>
    <message>
        <source>A new link takes the selected joints and meshes of the selected link, or the side of the train that was drawn last; both turn about one axis</source>
        <translation>Ein neues Glied übernimmt die ausgewählten Gelenke und Eingriffe des ausgewählten Glieds oder die zuletzt gezeichnete Seite des Getriebes; beide drehen sich um eine Achse</translation>
    </message>
    <message>
        <source>Sp&amp;lit the link</source>
        <translation>G&amp;lied teilen</translation>
    </message>
    <message>
        <source>The two selected links become one, which two gear sets then share; axes on one carrier become one line</source>
        <translation>Die zwei ausgewählten Glieder werden eines, das zwei Radsätze dann teilen; Achsen auf einem Träger werden eine Linie</translation>
    </message>
    <message>
        <source>&amp;Weld links</source>
        <translation>Glieder ver&amp;schweißen</translation>
    </message>
    <message>
        <source>A new gear in mesh with the selected one, on the same carrier</source>
        <translation>Ein neues Rad im Eingriff mit dem ausgewählten, auf demselben Steg</translation>
    </message>
    <message>
        <source>Dri&amp;ve</source>
        <translation>An&amp;treiben</translation>
    </message>
    <message>
        <source>Drive the selected joints, or stop driving them</source>
        <translation>Die ausgewählten Gelenke antreiben oder nicht mehr antreiben</translation>
    </message>
    <message>
        <source>Hold with a &amp;brake</source>
        <translation>Mit B&amp;remse festhalten</translation>
    </message>
    <message>
        <source>Engage the brake of the selected link, a new one where it has none, or release it</source>
        <translation>Die Bremse des ausgewählten Glieds schließen, wo es keine hat eine neue, oder sie lösen</translation>
    </message>
    <message>
        <source>A torque in the selected joint or on the selected link: type 10 Nm, nothing removes it</source>
        <translation>Ein Moment im ausgewählten Gelenk oder am ausgewählten Glied: 10 Nm eingeben, nichts entfernt es</translation>
    </message>
    <message>
        <source>&amp;Release brakes and clutches</source>
        <translation>Bremsen und &amp;Kupplungen lösen</translation>
    </message>
    <message>
        <source>Release every brake and clutch; the motion goes on</source>
        <translation>Alle Bremsen und Kupplungen lösen; die Bewegung geht weiter</translation>
    </message>
    <message>
        <source>&amp;Insert set…</source>
        <translation>Radsatz &amp;einfügen …</translation>
    </message>
    <message>
        <source>A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist, a worm or belt stage, a strain wave, cycloidal or RV reducer</source>
        <translation>Ein ganzer Planeten-, Ravigneaux- oder Simpson-Satz, ein Differential, ein rückkehrendes Getriebe, ein Handgelenk, eine Schnecken- oder Riemenstufe, ein Wellgetriebe, Zykloid- oder RV-Getriebe</translation>
    </message>
    <message>
        <source>%1 planets</source>
        <translation>%1 Planetenräder</translation>
    </message>
    <message>
        <source>Copies of the selected planet, equally spaced, %1 in all</source>
        <translation>Kopien des ausgewählten Planetenrads, gleichmäßig verteilt, insgesamt %1</translation>
    </message>
    <message>
        <source>&amp;Tidy the drawing</source>
        <translation>Zeichnung &amp;ordnen</translation>
    </message>
    <message>
        <source>Lay the digraph out anew</source>
        <translation>Den Digraphen neu anordnen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show all of the drawing</source>
        <translation>Die ganze Zeichnung zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Fit the &amp;selection</source>
        <translation>&amp;Auswahl einpassen</translation>
    </message>
    <message>
        <source>Show all that is selected</source>
        <translation>Alles Ausgewählte zeigen</translation>
    </message>
    <message>
        <source>&amp;Presentation</source>
        <translation>&amp;Präsentation</translation>
    </message>
    <message>
        <source>Full screen, large type, the drawing and the panels that were chosen</source>
        <translation>Vollbild, große Schrift, die Zeichnung und die gewählten Bereiche</translation>
    </message>
    <message>
        <source>Snap to the &amp;grid</source>
        <translation>Am &amp;Raster einrasten</translation>
    </message>
    <message>
        <source>Names of links and tooth counts beside their numbers, where there is room; lessons and presentations have them on</source>
        <translation>Namen der Glieder und Zähnezahlen neben ihren Nummern, wo Platz ist; in Lektionen und Präsentationen eingeschaltet</translation>
    </message>
    <message>
        <source>N&amp;ames and teeth</source>
        <translation>Na&amp;men und Zähnezahlen</translation>
    </message>
    <message>
        <source>Nodes keep to a grid; Alt suspends it</source>
        <translation>Knoten halten sich an ein Raster; Alt setzt es aus</translation>
    </message>
    <message>
        <source>Po&amp;wer flow</source>
        <translation>&amp;Leistungsfluss</translation>
    </message>
    <message>
        <source>Bands in digraph and schematic show where the power of the loads goes</source>
        <translation>Bänder in Digraph und Schema zeigen, wohin die Leistung der Lasten fließt</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Look &amp;up a term…</source>
        <translation>&amp;Begriff nachschlagen …</translation>
    </message>
    <message>
        <source>The definition of a technical term</source>
        <translation>Die Definition eines Fachbegriffs</translation>
    </message>
    <message>
        <source>&amp;Search…</source>
        <translation>&amp;Suchen …</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>All keys on one sheet</source>
        <translation>Alle Tasten auf einem Blatt</translation>
    </message>
    <message>
        <source>&amp;About GearGraph</source>
        <translation>&amp;Über GearGraph</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Was dieses Programm ist</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>Light or dark as the system is</source>
        <translation>Hell oder dunkel wie das System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Dunkel auf hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>Light on black</source>
        <translation>Hell auf schwarz</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Words of the window at %1 % of their size</source>
        <translation>Texte des Fensters in %1 % ihrer Größe</translation>
    </message>
    <message>
        <source>3D on &amp;half the width</source>
        <translation>3D auf halber &amp;Breite</translation>
    </message>
    <message>
        <source>The 3D view as wide as the drawing</source>
        <translation>Die 3D-Ansicht so breit wie die Zeichnung</translation>
    </message>
    <message>
        <source>&amp;Play	Space</source>
        <translation>&amp;Abspielen	Leertaste</translation>
    </message>
    <message>
        <source>Start or stop the motion (Space)</source>
        <translation>Die Bewegung starten oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Back to the &amp;start</source>
        <translation>Zum An&amp;fang</translation>
    </message>
    <message>
        <source>The time goes back to 0</source>
        <translation>Die Zeit geht auf 0 zurück</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Schneller</translation>
    </message>
    <message>
        <source>The motion is shown faster</source>
        <translation>Die Bewegung wird schneller gezeigt</translation>
    </message>
    <message>
        <source>Slo&amp;wer</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>The motion is shown more slowly</source>
        <translation>Die Bewegung wird langsamer gezeigt</translation>
    </message>
    <message>
        <source>&amp;Normal speed</source>
        <translation>&amp;Normale Geschwindigkeit</translation>
    </message>
    <message>
        <source>A second of the motion takes a second</source>
        <translation>Eine Sekunde der Bewegung dauert eine Sekunde</translation>
    </message>
    <message>
        <source>&amp;Backwards</source>
        <translation>&amp;Rückwärts</translation>
    </message>
    <message>
        <source>The motion runs back in time</source>
        <translation>Die Bewegung läuft in der Zeit zurück</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Pause	Space</source>
        <translation>&amp;Anhalten	Leertaste</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open e&amp;xample</source>
        <translation>Beis&amp;piel öffnen</translation>
    </message>
    <message>
        <source>The start page with titles, pictures and a sentence about each example</source>
        <translation>Die Startseite mit Titeln, Bildern und einem Satz zu jedem Beispiel</translation>
    </message>
    <message>
        <source>With pictures…</source>
        <translation>Mit Bildern…</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Gear trains</source>
        <translation>Zahnradgetriebe</translation>
    </message>
    <message>
        <source>Clocks</source>
        <translation>Uhren</translation>
    </message>
    <message>
        <source>Gearboxes</source>
        <translation>Schaltgetriebe</translation>
    </message>
    <message>
        <source>Not as they should be</source>
        <translation>Nicht wie sie sein sollten</translation>
    </message>
    <message>
        <source>Kinds of examples</source>
        <translation>Arten von Beispielen</translation>
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
        <source>Power seen fro&amp;m</source>
        <translation>Leistung gesehen &amp;von</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>T&amp;ype size</source>
        <translation>Schrif&amp;tgröße</translation>
    </message>
    <message>
        <source>&amp;Mechanism</source>
        <translation>&amp;Mechanismus</translation>
    </message>
    <message>
        <source>&amp;Planets like the selected one</source>
        <translation>&amp;Planetenräder wie das ausgewählte</translation>
    </message>
    <message>
        <source>M&amp;otion</source>
        <translation>Be&amp;wegung</translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation>&amp;Lernen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Es ist nichts ausgewählt.</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>There is one ground in every document.</source>
        <translation>In jedem Dokument gibt es ein Gestell.</translation>
    </message>
    <message>
        <source>The ground cannot be deleted.</source>
        <translation>Das Gestell kann nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>Select a joint or a mesh to turn its arrow round.</source>
        <translation>Wählen Sie ein Gelenk oder einen Zahneingriff aus, um den Pfeil umzukehren.</translation>
    </message>
    <message>
        <source>Select a turning joint, or the link it carries.</source>
        <translation>Wählen Sie ein Drehgelenk oder das Glied aus, das es trägt.</translation>
    </message>
    <message>
        <source>The ground does not move.</source>
        <translation>Das Gestell bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Select one link to hold it.</source>
        <translation>Wählen Sie ein Glied aus, um es festzuhalten.</translation>
    </message>
    <message>
        <source>No brake and no clutch is engaged.</source>
        <translation>Keine Bremse und keine Kupplung ist geschlossen.</translation>
    </message>
    <message>
        <source>Select one planet.</source>
        <translation>Wählen Sie ein Planetenrad aus.</translation>
    </message>
    <message>
        <source>Select the link that the gear should mesh with.</source>
        <translation>Wählen Sie das Glied aus, in das das Zahnrad eingreifen soll.</translation>
    </message>
    <message>
        <source>This link is the ground already.</source>
        <translation>Dieses Glied ist bereits das Gestell.</translation>
    </message>
    <message>
        <source>Select one link to make it the ground.</source>
        <translation>Wählen Sie ein Glied aus, um es zum Gestell zu machen.</translation>
    </message>
    <message>
        <source>There is no link to lay out yet.</source>
        <translation>Noch gibt es kein Glied anzuordnen.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>The solution is still being worked out.</source>
        <translation>Die Lösung wird noch berechnet.</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrizen</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Inputs and results</source>
        <translation>Antriebe und Ergebnisse</translation>
    </message>
    <message>
        <source>Gearbox</source>
        <translation>Schaltgetriebe</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Derivation</source>
        <translation>Herleitung</translation>
    </message>
    <message>
        <source>Dynamics</source>
        <translation>Dynamik</translation>
    </message>
    <message>
        <source>Problems %1</source>
        <translation>Probleme %1</translation>
    </message>
    <message>
        <source>Export matrix</source>
        <translation>Matrix exportieren</translation>
    </message>
    <message>
        <source>CSV files (*.csv);;All files (*)</source>
        <translation>CSV-Dateien (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Tabelle exportieren</translation>
    </message>
    <message>
        <source>Save the traced path</source>
        <translation>Aufgezeichnete Bahn speichern</translation>
    </message>
    <message>
        <source>path.csv</source>
        <translation>bahn.csv</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Save the speeds</source>
        <translation>Drehzahlen speichern</translation>
    </message>
    <message>
        <source>speeds.csv</source>
        <translation>drehzahlen.csv</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2</source>
        <translation>%1 konnte nicht geöffnet werden: %2</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>This window is not connected to others.</source>
        <translation>Dieses Fenster ist mit keinem anderen verbunden.</translation>
    </message>
    <message>
        <source>A lesson&apos;s drawing is not kept: copy what you need into another window.</source>
        <translation>Die Zeichnung einer Lektion wird nicht aufbewahrt: Kopieren Sie, was Sie brauchen, in ein anderes Fenster.</translation>
    </message>
    <message>
        <source>Nothing has been changed since it was saved.</source>
        <translation>Seit dem Speichern wurde nichts geändert.</translation>
    </message>
    <message>
        <source>The document has no file yet.</source>
        <translation>Das Dokument hat noch keine Datei.</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier run are in %1, which cannot be read.</source>
        <translation>Ungespeicherte Änderungen eines früheren Laufs liegen in %1, das nicht gelesen werden kann.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>a document that was never saved (%1)</source>
        <translation>eines nie gespeicherten Dokuments (%1)</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 Änderung</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 Änderungen</translation>
    </message>
    <message>
        <source>GearGraph ended with unsaved changes of %1: %2 after it was last saved, the last at %3 (%4).</source>
        <translation>GearGraph endete mit ungespeicherten Änderungen: %1, %2 nach dem letzten Speichern, die letzte um %3 (%4).</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Open them as unsaved changes, which can be undone</source>
        <translation>Als ungespeicherte Änderungen öffnen, die rückgängig gemacht werden können</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Delete them for good</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>They stay where they are and will be offered again</source>
        <translation>Sie bleiben, wo sie sind, und werden wieder angeboten</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>Ungespeicherte Änderungen wiederherstellen</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>Lesson %1 of %2</source>
        <translation>Lektion %1 von %2</translation>
    </message>
    <message>
        <source>Open a lesson file</source>
        <translation>Lektionsdatei öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Lektionen (*.json)</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>This panel holds the answer: it opens when the step is right or shown.</source>
        <translation>Dieser Bereich enthält die Antwort: Er öffnet sich, wenn der Schritt richtig oder gezeigt ist.</translation>
    </message>
    <message>
        <source>The derivation holds the answer: it opens when the step is right or shown.</source>
        <translation>Die Herleitung enthält die Antwort: Sie öffnet sich, wenn der Schritt richtig oder gezeigt ist.</translation>
    </message>
    <message>
        <source>%1 was not saved: another program has changed it.</source>
        <translation>%1 wurde nicht gespeichert: Ein anderes Programm hat es geändert.</translation>
    </message>
    <message>
        <source>%1 was not saved. %2</source>
        <translation>%1 wurde nicht gespeichert. %2</translation>
    </message>
    <message>
        <source>Save it once more</source>
        <translation>Noch einmal speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>The document stays open, with its changes</source>
        <translation>Das Dokument bleibt mit seinen Änderungen geöffnet</translation>
    </message>
    <message>
        <source>untitled.geargraph</source>
        <translation>unbenannt.geargraph</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1 first?</source>
        <translation>Die Änderungen an %1 zuerst speichern?</translation>
    </message>
    <message>
        <source>Revert to the file</source>
        <translation>Zur Datei zurückkehren</translation>
    </message>
    <message>
        <source>it can no longer be read</source>
        <translation>es kann nicht mehr gelesen werden</translation>
    </message>
    <message>
        <source>%1 was not saved: another program has changed it (%2). Reloading can be undone.</source>
        <translation>%1 wurde nicht gespeichert: Ein anderes Programm hat es geändert (%2). Neu laden kann rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>Another program has changed %1: %2. Your own changes are not saved; reloading can be undone.</source>
        <translation>Ein anderes Programm hat %1 geändert: %2. Ihre eigenen Änderungen sind nicht gespeichert; neu laden kann rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>Another program has changed %1: %2.</source>
        <translation>Ein anderes Programm hat %1 geändert: %2.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Load the contents of the file</source>
        <translation>Den Inhalt der Datei laden</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save this window&apos;s document over it</source>
        <translation>Das Dokument dieses Fensters darüber speichern</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Beide behalten</translation>
    </message>
    <message>
        <source>Save this window&apos;s document under another name</source>
        <translation>Das Dokument dieses Fensters unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Saving will ask again</source>
        <translation>Beim Speichern wird wieder gefragt</translation>
    </message>
    <message>
        <source>Another program has moved or deleted %1.</source>
        <translation>Ein anderes Programm hat %1 verschoben oder gelöscht.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Wieder speichern</translation>
    </message>
    <message>
        <source>Write it where it was</source>
        <translation>Dorthin schreiben, wo es war</translation>
    </message>
    <message>
        <source>The document stays open</source>
        <translation>Das Dokument bleibt geöffnet</translation>
    </message>
    <message>
        <source>%1 is open in this window already.</source>
        <translation>%1 ist in diesem Fenster bereits geöffnet.</translation>
    </message>
    <message>
        <source>Not opened again: %1</source>
        <translation>Nicht wieder geöffnet: %1</translation>
    </message>
    <message>
        <source>%1 is open in another window of GearGraph. Here it is read-only.</source>
        <translation>%1 ist in einem anderen Fenster von GearGraph geöffnet. Hier ist es schreibgeschützt.</translation>
    </message>
    <message>
        <source>Show that window</source>
        <translation>Jenes Fenster zeigen</translation>
    </message>
    <message>
        <source>And close this one if nothing is changed in it</source>
        <translation>Und dieses schließen, wenn darin nichts geändert ist</translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation>Schreibgeschützt</translation>
    </message>
    <message>
        <source>Look at it here; changes can be saved under another name</source>
        <translation>Hier ansehen; Änderungen können unter einem anderen Namen gespeichert werden</translation>
    </message>
    <message>
        <source>%1 was not saved: %2 is open in another window of GearGraph.</source>
        <translation>%1 wurde nicht gespeichert: %2 ist in einem anderen Fenster von GearGraph geöffnet.</translation>
    </message>
    <message>
        <source>%1 is not open in another window any more. This one writes to it now.</source>
        <translation>%1 ist in keinem anderen Fenster mehr geöffnet. Dieses schreibt es jetzt.</translation>
    </message>
    <message>
        <source>The other window with %1 does not answer.</source>
        <translation>Das andere Fenster mit %1 antwortet nicht.</translation>
    </message>
    <message>
        <source>Saving %1 was interrupted, so the file may be damaged. What was to be saved is in %2.</source>
        <translation>Das Speichern von %1 wurde unterbrochen, die Datei kann beschädigt sein. Was gespeichert werden sollte, liegt in %2.</translation>
    </message>
    <message>
        <source>Open the copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Delete the copy</source>
        <translation>Kopie löschen</translation>
    </message>
    <message>
        <source>The file is as it should be</source>
        <translation>Die Datei ist, wie sie sein soll</translation>
    </message>
    <message>
        <source>Attached 3D files…</source>
        <translation>Angehängte 3D-Dateien …</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>Code: %1</source>
        <translation>Code: %1</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> und %1 weitere</translation>
    </message>
    <message>
        <source>No other joint turns with joint %1.</source>
        <translation>Kein anderes Gelenk dreht mit Gelenk %1.</translation>
    </message>
    <message>
        <source>Joint %1 commands %2.</source>
        <translation>Gelenk %1 bestimmt %2.</translation>
    </message>
    <message>
        <source>Joints %1 turn together, at a fixed ratio.</source>
        <translation>Die Gelenke %1 drehen sich gemeinsam in festem Verhältnis.</translation>
    </message>
    <message>
        <source>Never turning: %1.</source>
        <translation>Drehen sich nie: %1.</translation>
    </message>
    <message>
        <source>%1 about %2</source>
        <translation>%1 um %2</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>steht still</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>absolute speed</source>
        <translation>absolute Drehzahl</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>U/min</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>zu %1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation>%1 rad/s</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 frei</translation>
    </message>
    <message>
        <source>linkage</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>tumbles</source>
        <translation>taumelt</translation>
    </message>
    <message>
        <source>%1 engaged</source>
        <translation>%1 geschlossen</translation>
    </message>
    <message>
        <source>%1 released</source>
        <translation>%1 gelöst</translation>
    </message>
    <message>
        <source>Several couplings share the load in proportions that stiffness and clearance decide.</source>
        <translation>Mehrere Schaltelemente teilen sich die Last in Anteilen, die Steifigkeit und Spiel bestimmen.</translation>
    </message>
    <message>
        <source>Brake %1 bears %2 N m, its torque on link %3</source>
        <translation>Bremse %1 trägt %2 N m, ihr Moment auf Glied %3</translation>
    </message>
    <message>
        <source>Clutch %1 bears %2 N m, its torque on link %3 from link %4</source>
        <translation>Kupplung %1 trägt %2 N m, ihr Moment auf Glied %3 von Glied %4</translation>
    </message>
    <message>
        <source>In the gear ratios: %1</source>
        <translation>In den Übersetzungen: %1</translation>
    </message>
    <message>
        <source>%1 = 0</source>
        <translation>%1 = 0</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Brake %1 holds link %2</source>
        <translation>Bremse %1 hält Glied %2</translation>
    </message>
    <message>
        <source>Clutch %1 makes links %2 and %3 turn as one</source>
        <translation>Kupplung %1 lässt die Glieder %2 und %3 gemeinsam drehen</translation>
    </message>
    <message>
        <source>The ratio is the speed of the first link over that of the second. Click to choose them.</source>
        <translation>Die Übersetzung ist die Drehzahl des ersten Glieds durch die des zweiten. Klicken, um sie zu wählen.</translation>
    </message>
    <message>
        <source>The ratio before over this one</source>
        <translation>Vorige Übersetzung durch diese</translation>
    </message>
    <message>
        <source>The efficiency with all known torques reversed: the output drives</source>
        <translation>Wirkungsgrad mit umgekehrten bekannten Momenten: Der Abtrieb treibt</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop, for each watt that is fed</source>
        <translation>Die größte Leistung, die in einer Schleife umläuft, je Watt zugeführter</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>decimal</source>
        <translation>dezimal</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>η</source>
        <translation>η</translation>
    </message>
    <message>
        <source>η back</source>
        <translation>η rückw.</translation>
    </message>
    <message>
        <source>circul.</source>
        <translation>Blindl.</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source> Eq. (%1)</source>
        <translation> Gl. (%1)</translation>
    </message>
    <message>
        <source>All gears on this link keep their teeth while other things change.</source>
        <translation>Alle Räder dieses Glieds behalten ihre Zähnezahlen, wenn sich anderes ändert.</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Select a link, a joint or a mesh to see and change what belongs to it.</source>
        <translation>Wählen Sie ein Glied, ein Gelenk oder einen Zahneingriff aus, um dessen Eigenschaften zu sehen und zu ändern.</translation>
    </message>
    <message>
        <source>Rename document</source>
        <translation>Dokument umbenennen</translation>
    </message>
    <message>
        <source>Delete removes them with their joints and meshes.</source>
        <translation>Entf entfernt sie samt ihren Gelenken und Zahneingriffen.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Zahnräder</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Schaltelemente</translation>
    </message>
    <message>
        <source>Brakes and clutches of this link</source>
        <translation>Bremsen und Kupplungen dieses Glieds</translation>
    </message>
    <message>
        <source>Link 0, the ground</source>
        <translation>Glied 0, das Gestell</translation>
    </message>
    <message>
        <source>Makes this link the ground: it becomes 0, and the other labels follow.</source>
        <translation>Macht dieses Glied zum Gestell: Es wird 0, und die anderen Nummern folgen.</translation>
    </message>
    <message>
        <source>Pin the axis</source>
        <translation>Achse fixieren</translation>
    </message>
    <message>
        <source>The axis keeps its place while other things change.</source>
        <translation>Die Achse behält ihren Ort, wenn sich anderes ändert.</translation>
    </message>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Exchange tail and head: the arrow turns round, and the speed changes its sign.</source>
        <translation>Fuß und Spitze tauschen: Der Pfeil kehrt sich um, und die Drehzahl ändert ihr Vorzeichen.</translation>
    </message>
    <message>
        <source>Flip joint</source>
        <translation>Gelenk umkehren</translation>
    </message>
    <message>
        <source>Move bearing</source>
        <translation>Lager verschieben</translation>
    </message>
    <message>
        <source>The joint turns back no farther than this from the reference pose, in degrees: 0 or less. Empty: no limit.</source>
        <translation>Weiter als so dreht das Gelenk nicht zurück, ab der Bezugslage, in Grad: höchstens 0. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>The joint turns on no farther than this from the reference pose, in degrees: 0 or more. Empty: no limit.</source>
        <translation>Weiter als so dreht das Gelenk nicht vor, ab der Bezugslage, in Grad: mindestens 0. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Limit joint</source>
        <translation>Gelenk begrenzen</translation>
    </message>
    <message>
        <source>Limits, deg</source>
        <translation>Grenzen, Grad</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Neue Achse</translation>
    </message>
    <message>
        <source>Change axis</source>
        <translation>Achse wechseln</translation>
    </message>
    <message>
        <source>Move axis</source>
        <translation>Achse verschieben</translation>
    </message>
    <message>
        <source>Turn axis</source>
        <translation>Achse drehen</translation>
    </message>
    <message>
        <source>new axis</source>
        <translation>neue Achse</translation>
    </message>
    <message>
        <source>%1 turning joints</source>
        <translation>%1 Drehgelenke</translation>
    </message>
    <message>
        <source>Turning joint %1: %2 → %3</source>
        <translation>Drehgelenk %1: %2 → %3</translation>
    </message>
    <message>
        <source>The axis is pinned.</source>
        <translation>Die Achse ist fixiert.</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>module</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>The mesh keeps its module while other things change.</source>
        <translation>Der Zahneingriff behält seinen Modul, wenn sich anderes ändert.</translation>
    </message>
    <message>
        <source>This train has more than %1 meshes: axes and other wheels do not follow a change of teeth by themselves.</source>
        <translation>Dieses Getriebe hat mehr als %1 Zahneingriffe: Achsen und andere Räder folgen einer Änderung der Zähnezahlen nicht von selbst.</translation>
    </message>
    <message>
        <source>from the geometry</source>
        <translation>aus der Geometrie</translation>
    </message>
    <message>
        <source>external</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>internal</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>bevel</source>
        <translation>Kegelräder</translation>
    </message>
    <message>
        <source>Teeth of gear %1</source>
        <translation>Zähne des Rads %1</translation>
    </message>
    <message>
        <source>Teeth, tail</source>
        <translation>Zähne, Fuß</translation>
    </message>
    <message>
        <source>Teeth, head</source>
        <translation>Zähne, Spitze</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Pitch point</source>
        <translation>Wälzpunkt</translation>
    </message>
    <message>
        <source>gear %1</source>
        <translation>Rad %1</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Fixiert</translation>
    </message>
    <message>
        <source>Exchange tail and head with their teeth: the arrow turns round.</source>
        <translation>Fuß und Spitze samt Zähnezahlen tauschen: Der Pfeil kehrt sich um.</translation>
    </message>
    <message>
        <source>Change module</source>
        <translation>Modul ändern</translation>
    </message>
    <message>
        <source>Move pitch point</source>
        <translation>Wälzpunkt verschieben</translation>
    </message>
    <message>
        <source>Flip mesh</source>
        <translation>Zahneingriff umkehren</translation>
    </message>
    <message>
        <source>Change teeth</source>
        <translation>Zähnezahlen ändern</translation>
    </message>
    <message>
        <source>%1 gear meshes</source>
        <translation>%1 Zahneingriffe</translation>
    </message>
    <message>
        <source>Gear mesh %1: %2 → %3</source>
        <translation>Zahneingriff %1: %2 → %3</translation>
    </message>
    <message>
        <source>The module is pinned.</source>
        <translation>Der Modul ist fixiert.</translation>
    </message>
    <message>
        <source>The gears have no places yet: see Problems.</source>
        <translation>Die Räder haben noch keinen Ort: siehe Probleme.</translation>
    </message>
    <message>
        <source>They are of several kinds. Select elements of one kind to change them together.</source>
        <translation>Sie sind von verschiedener Art. Wählen Sie Elemente einer Art aus, um sie gemeinsam zu ändern.</translation>
    </message>
    <message>
        <source>Release all couplings</source>
        <translation>Alle Schaltelemente lösen</translation>
    </message>
    <message>
        <source>Fixes it; Ctrl+Z undoes that</source>
        <translation>Behebt es; Strg+Z macht das rückgängig</translation>
    </message>
    <message>
        <source>+ Brake</source>
        <translation>+ Bremse</translation>
    </message>
    <message>
        <source>Hold a link against the ground: the selected one, or choose</source>
        <translation>Ein Glied gegen das Gestell festhalten: das ausgewählte, oder wählen</translation>
    </message>
    <message>
        <source>+ Clutch</source>
        <translation>+ Kupplung</translation>
    </message>
    <message>
        <source>Make two links turn as one: the two selected, or choose</source>
        <translation>Zwei Glieder gemeinsam drehen lassen: die ausgewählten, oder wählen</translation>
    </message>
    <message>
        <source>+ State</source>
        <translation>+ Zustand</translation>
    </message>
    <message>
        <source>A new row: what is engaged together</source>
        <translation>Eine neue Zeile: was gemeinsam geschlossen ist</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Alle lösen</translation>
    </message>
    <message>
        <source>Release every brake and clutch; the motion goes on (Ctrl+B)</source>
        <translation>Alle Bremsen und Kupplungen lösen; die Bewegung geht weiter (Strg+B)</translation>
    </message>
    <message>
        <source>A gearbox has brakes, which hold a link, and clutches, which make two links turn as one. Select a link and add a brake, or two links and add a clutch; then add states that engage them.</source>
        <translation>Ein Schaltgetriebe hat Bremsen, die ein Glied festhalten, und Kupplungen, die zwei Glieder gemeinsam drehen lassen. Wählen Sie ein Glied aus und fügen Sie eine Bremse hinzu, oder zwei Glieder und eine Kupplung; dann Schaltzustände, die sie schließen.</translation>
    </message>
    <message>
        <source>Shift table</source>
        <translation>Schalttabelle</translation>
    </message>
    <message>
        <source>Rename state</source>
        <translation>Schaltzustand umbenennen</translation>
    </message>
    <message>
        <source>Rename coupling</source>
        <translation>Schaltelement umbenennen</translation>
    </message>
    <message>
        <source>Click a state to engage it, a letter to engage or release one coupling, a dot to change a state.</source>
        <translation>Klicken Sie auf einen Schaltzustand, um ihn zu schalten, auf einen Buchstaben, um ein Schaltelement zu schließen oder zu lösen, auf einen Punkt, um einen Zustand zu ändern.</translation>
    </message>
    <message>
        <source>Torques in N m, under the loads of the document.</source>
        <translation>Momente in N m, unter den Lasten des Dokuments.</translation>
    </message>
    <message>
        <source>Click a letter to engage or release; add a state, then click its dots.</source>
        <translation>Auf einen Buchstaben klicken, um zu schließen oder zu lösen; einen Zustand hinzufügen, dann auf seine Punkte klicken.</translation>
    </message>
    <message>
        <source>Add brake</source>
        <translation>Bremse hinzufügen</translation>
    </message>
    <message>
        <source>Add clutch</source>
        <translation>Kupplung hinzufügen</translation>
    </message>
    <message>
        <source>Link %1 with</source>
        <translation>Glied %1 mit</translation>
    </message>
    <message>
        <source>Add state</source>
        <translation>Schaltzustand hinzufügen</translation>
    </message>
    <message>
        <source>Engage state %1</source>
        <translation>Schaltzustand %1 schalten</translation>
    </message>
    <message>
        <source>Put %1 into the state</source>
        <translation>%1 in den Zustand aufnehmen</translation>
    </message>
    <message>
        <source>Take %1 out of the state</source>
        <translation>%1 aus dem Zustand nehmen</translation>
    </message>
    <message>
        <source>Choose drive</source>
        <translation>Antrieb wählen</translation>
    </message>
    <message>
        <source>Choose driven</source>
        <translation>Abtrieb wählen</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Abtrieb</translation>
    </message>
    <message>
        <source>Drive of all states</source>
        <translation>Antrieb aller Zustände</translation>
    </message>
    <message>
        <source>Driven of all states</source>
        <translation>Abtrieb aller Zustände</translation>
    </message>
    <message>
        <source>Engage</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Delete state</source>
        <translation>Schaltzustand löschen</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Export table as CSV…</source>
        <translation>Tabelle als CSV exportieren …</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Delete coupling</source>
        <translation>Schaltelement löschen</translation>
    </message>
    <message>
        <source>No joint is driven yet. Choose the input tool (I), then click a turning joint.</source>
        <translation>Noch ist kein Gelenk angetrieben. Wählen Sie das Antriebswerkzeug (I) und klicken Sie auf ein Drehgelenk.</translation>
    </message>
    <message>
        <source>Show more: %1 of %2 inputs are listed</source>
        <translation>Mehr zeigen: %1 von %2 Antrieben sind aufgeführt</translation>
    </message>
    <message>
        <source>link %1 held</source>
        <translation>Glied %1 festgehalten</translation>
    </message>
    <message>
        <source>links %1 and %2 as one</source>
        <translation>Glieder %1 und %2 gekuppelt</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Engaged: %1</source>
        <translation>Geschlossen: %1</translation>
    </message>
    <message>
        <source>Engaged: state %1, with %2</source>
        <translation>Geschaltet: Zustand %1, mit %2</translation>
    </message>
    <message>
        <source>Colour of link %1</source>
        <translation>Farbe von Glied %1</translation>
    </message>
    <message>
        <source>Drive another joint instead; the motion stays as it is</source>
        <translation>Stattdessen ein anderes Gelenk antreiben; die Bewegung bleibt</translation>
    </message>
    <message>
        <source>Nothing is solved yet</source>
        <translation>Noch ist nichts gelöst</translation>
    </message>
    <message>
        <source>Joint %1 instead of %2</source>
        <translation>Gelenk %1 statt %2</translation>
    </message>
    <message>
        <source>Joint %1 never turns</source>
        <translation>Gelenk %1 dreht sich nie</translation>
    </message>
    <message>
        <source>Joint %1 does not depend on %2; it could replace %3</source>
        <translation>Gelenk %1 hängt nicht von %2 ab; es könnte %3 ersetzen</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Choose inputs</source>
        <translation>Antriebe wählen</translation>
    </message>
    <message>
        <source>There is nothing to drive yet. Draw a turning joint: T, then drag.</source>
        <translation>Noch gibt es nichts anzutreiben. Zeichnen Sie ein Drehgelenk: T, dann ziehen.</translation>
    </message>
    <message>
        <source>There is nothing to drive: the mechanism has no degree of freedom.</source>
        <translation>Es gibt nichts anzutreiben: Der Mechanismus hat keinen Freiheitsgrad.</translation>
    </message>
    <message>
        <source>Drive joint %1</source>
        <translation>Gelenk %1 antreiben</translation>
    </message>
    <message>
        <source>Drive joints %1</source>
        <translation>Gelenke %1 antreiben</translation>
    </message>
    <message>
        <source>Set speed</source>
        <translation>Drehzahl ändern</translation>
    </message>
    <message>
        <source>Side wheels</source>
        <translation>Achswellenräder</translation>
    </message>
    <message>
        <source>Pinions&apos; teeth</source>
        <translation>Zähne der Ausgleichsräder</translation>
    </message>
    <message>
        <source>Pinions</source>
        <translation>Ausgleichsräder</translation>
    </message>
    <message>
        <source>Small sun</source>
        <translation>Kleine Sonne</translation>
    </message>
    <message>
        <source>Large sun</source>
        <translation>Große Sonne</translation>
    </message>
    <message>
        <source>Short planet</source>
        <translation>Kurzer Planet</translation>
    </message>
    <message>
        <source>Long planet</source>
        <translation>Langer Planet</translation>
    </message>
    <message>
        <source>Pairs of planets</source>
        <translation>Planetenpaare</translation>
    </message>
    <message>
        <source>Suns</source>
        <translation>Sonnenräder</translation>
    </message>
    <message>
        <source>Planets&apos; teeth</source>
        <translation>Zähne der Planeten</translation>
    </message>
    <message>
        <source>Planets a set</source>
        <translation>Planeten je Satz</translation>
    </message>
    <message>
        <source>Bend shaft</source>
        <translation>Welle des Beugens</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Beugen</translation>
    </message>
    <message>
        <source>Roll shaft</source>
        <translation>Welle des Rollens</translation>
    </message>
    <message>
        <source>Idler</source>
        <translation>Zwischenrad</translation>
    </message>
    <message>
        <source>Idler&apos;s pinion</source>
        <translation>Ritzel des Zwischenrads</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Insert a set</source>
        <translation>Radsatz einfügen</translation>
    </message>
    <message>
        <source>Planetary set</source>
        <translation>Planetensatz</translation>
    </message>
    <message>
        <source>Reverted train</source>
        <translation>Rückkehrende Stufe</translation>
    </message>
    <message>
        <source>Bevel differential</source>
        <translation>Kegelraddifferential</translation>
    </message>
    <message>
        <source>Ravigneaux set</source>
        <translation>Ravigneaux-Satz</translation>
    </message>
    <message>
        <source>Simpson set</source>
        <translation>Simpson-Satz</translation>
    </message>
    <message>
        <source>Bevel wrist</source>
        <translation>Kegelrad-Handgelenk</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>; %1 couplings and %2 states</source>
        <translation>; %1 Schaltelemente und %2 Zustände</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 with %2, axis %3</source>
        <translation>%1 mit %2, Achse %3</translation>
    </message>
    <message>
        <source>link </source>
        <translation>Glied </translation>
    </message>
    <message>
        <source>%1 teeth in mesh %2 with %3</source>
        <translation>%1 Zähne im Eingriff %2 mit %3</translation>
    </message>
    <message>
        <source>brake </source>
        <translation>Bremse </translation>
    </message>
    <message>
        <source>clutch </source>
        <translation>Kupplung </translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>dezimal</translation>
    </message>
    <message>
        <source>fractions</source>
        <translation>Brüche</translation>
    </message>
    <message>
        <source>symbols</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Export the matrix with its labels to a CSV file</source>
        <translation>Matrix mit Zeilen- und Spaltennamen in eine CSV-Datei exportieren</translation>
    </message>
    <message>
        <source>zeros ·</source>
        <translation>Nullen ·</translation>
    </message>
    <message>
        <source>Show zeros as faint dots, or as 0</source>
        <translation>Nullen als blasse Punkte oder als 0 zeigen</translation>
    </message>
    <message>
        <source>zeros 0</source>
        <translation>Nullen 0</translation>
    </message>
    <message>
        <source>Copy ▾</source>
        <translation>Kopieren ▾</translation>
    </message>
    <message>
        <source>Copy the matrix with its labels</source>
        <translation>Matrix mit Zeilen- und Spaltennamen kopieren</translation>
    </message>
    <message>
        <source>Table (TSV)</source>
        <translation>Tabelle (TSV)</translation>
    </message>
    <message>
        <source>A matrix of %1 entries is too large to be copied. Export it as CSV.</source>
        <translation>Eine Matrix mit %1 Einträgen ist zu groß zum Kopieren. Exportieren Sie sie als CSV.</translation>
    </message>
    <message>
        <source>How the entries are shown: decimals, fractions or symbols</source>
        <translation>Wie die Einträge gezeigt werden: dezimal, als Brüche oder Symbole</translation>
    </message>
    <message>
        <source>The equations are too many to be written out.</source>
        <translation>Es sind zu viele Gleichungen, um sie auszuschreiben.</translation>
    </message>
    <message>
        <source>The matrices appear as soon as the mechanism is analysed.</source>
        <translation>Die Matrizen erscheinen, sobald der Mechanismus analysiert ist.</translation>
    </message>
    <message>
        <source>Draw the first link: L, then click.</source>
        <translation>Zeichnen Sie das erste Glied: L, dann klicken.</translation>
    </message>
    <message>
        <source>Draw a turning joint: T, then drag from a link to another.</source>
        <translation>Zeichnen Sie ein Drehgelenk: T, dann von einem Glied zum anderen ziehen.</translation>
    </message>
    <message>
        <source>Draw a gear mesh: G, then drag from a gear to the one it drives.</source>
        <translation>Zeichnen Sie einen Zahneingriff: G, dann von einem Rad zu dem ziehen, das es treibt.</translation>
    </message>
    <message>
        <source>In %1; a length with another unit, such as 1/2 in or 2.5 cm, is converted.</source>
        <translation>In %1; eine Länge mit anderer Einheit wie 1/2 in oder 2,5 cm wird umgerechnet.</translation>
    </message>
    <message>
        <source>Type a whole number from %1 to %2.</source>
        <translation>Geben Sie eine ganze Zahl von %1 bis %2 ein.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5, 22/7 or 2*3, or a length such as 1/2 in.</source>
        <translation>Geben Sie eine Zahl wie 12, 0,5, 22/7 oder 2*3 oder eine Länge wie 1/2 in ein.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5, 22/7 or 2*3.</source>
        <translation>Geben Sie eine Zahl wie 12, 0,5, 22/7 oder 2*3 ein.</translation>
    </message>
    <message>
        <source>Type an angle such as 30, 2*15, 0.5 rad or 1/4 turns.</source>
        <translation>Geben Sie einen Winkel wie 30, 2*15, 0.5 rad oder 1/4 turns ein.</translation>
    </message>
    <message>
        <source>Type a speed such as 12, 2*3, 90 deg/s or 1500 rpm.</source>
        <translation>Geben Sie eine Drehgeschwindigkeit wie 12, 2*3, 90 deg/s oder 1500 rpm ein.</translation>
    </message>
    <message>
        <source>Type a torque such as 12, 2*3, 5 N cm, 3 lbf ft or 2 kW @ 1500 rpm.</source>
        <translation>Geben Sie ein Moment wie 12, 2*3, 5 N cm, 3 lbf ft oder 2 kW @ 1500 rpm ein.</translation>
    </message>
    <message>
        <source>Type a force such as 12, 2*3 or 5 kN.</source>
        <translation>Geben Sie eine Kraft wie 12, 2*3 oder 5 kN ein.</translation>
    </message>
    <message>
        <source>No problems. Every link is tied to the ground, and the turning joints make a spanning tree.</source>
        <translation>Keine Probleme. Jedes Glied ist mit dem Gestell verbunden, und die Drehgelenke bilden einen Spannbaum.</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show the problems of the open document again</source>
        <translation>Die Probleme des geöffneten Dokuments wieder zeigen</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. The document that was open stays open.</source>
        <translation>%1 konnte nicht geöffnet werden: %2. Das vorher geöffnete Dokument bleibt geöffnet.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fixieren</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Coefficients as formulas in the gear ratios, or as fractions</source>
        <translation>Koeffizienten als Formeln in den Übersetzungen oder als Brüche</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>The unit of the speeds, or the member they are taken as ratio to</source>
        <translation>Einheit der Drehzahlen oder das Element, auf das sie bezogen werden</translation>
    </message>
    <message>
        <source>ratio to %1</source>
        <translation>Verhältnis zu %1</translation>
    </message>
    <message>
        <source>rpm, turns a minute</source>
        <translation>U/min, Umdrehungen je Minute</translation>
    </message>
    <message>
        <source>%1 more joints: select one to find it here</source>
        <translation>%1 weitere Gelenke: Wählen Sie eines aus, um es hier zu finden</translation>
    </message>
    <message>
        <source> (they are not independent)</source>
        <translation> (sie sind nicht unabhängig)</translation>
    </message>
    <message>
        <source>%1 more links: select one to find it here</source>
        <translation>%1 weitere Glieder: Wählen Sie eines aus, um es hier zu finden</translation>
    </message>
    <message>
        <source>Every link turns on the ground</source>
        <translation>Jedes Glied dreht im Gestell</translation>
    </message>
    <message>
        <source>formulas</source>
        <translation>Formeln</translation>
    </message>
    <message>
        <source>… (%1 in all)</source>
        <translation>… (%1 insgesamt)</translation>
    </message>
    <message>
        <source>No joint is driven: %1 as input, at 1 rad/s each.</source>
        <translation>Kein Gelenk ist angetrieben: %1 als Antrieb, mit je 1 rad/s.</translation>
    </message>
    <message>
        <source>the set of joints %1</source>
        <translation>die Gelenkmenge %1</translation>
    </message>
    <message>
        <source>The two methods differ at %1 joints. Please report this document.</source>
        <translation>Die beiden Verfahren weichen bei %1 Gelenken ab. Bitte melden Sie dieses Dokument.</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly</source>
        <translation>Matroid = T–T-Graph, exakt</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly, for all %1 joints</source>
        <translation>Matroid = T–T-Graph, exakt, für alle %1 Gelenke</translation>
    </message>
    <message>
        <source>Solving exactly, by both methods …</source>
        <translation>Wird exakt gelöst, mit beiden Verfahren …</translation>
    </message>
    <message>
        <source>The results appear as soon as the mechanism is analysed.</source>
        <translation>Die Ergebnisse erscheinen, sobald der Mechanismus analysiert ist.</translation>
    </message>
    <message>
        <source>Rates appear when the first turning joint is drawn.</source>
        <translation>Drehzahlen erscheinen, wenn das erste Drehgelenk gezeichnet ist.</translation>
    </message>
    <message>
        <source>Every joint is an input: there is nothing left to solve for.</source>
        <translation>Jedes Gelenk ist ein Antrieb: Es bleibt nichts zu lösen.</translation>
    </message>
    <message>
        <source>Ratio wanted</source>
        <translation>Gewünschte Übersetzung</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>planet</source>
        <translation>Planet</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>Hohlrad</translation>
    </message>
    <message>
        <source>sun to carrier, ring held</source>
        <translation>Sonne zu Steg, Hohlrad fest</translation>
    </message>
    <message>
        <source>ring to carrier, sun held</source>
        <translation>Hohlrad zu Steg, Sonne fest</translation>
    </message>
    <message>
        <source>sun to ring, carrier held</source>
        <translation>Sonne zu Hohlrad, Steg fest</translation>
    </message>
    <message>
        <source>carrier to sun, ring held</source>
        <translation>Steg zu Sonne, Hohlrad fest</translation>
    </message>
    <message>
        <source>carrier to ring, sun held</source>
        <translation>Steg zu Hohlrad, Sonne fest</translation>
    </message>
    <message>
        <source>ring to sun, carrier held</source>
        <translation>Hohlrad zu Sonne, Steg fest</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, nach</translation>
    </message>
    <message>
        <source>Planets</source>
        <translation>Planeten</translation>
    </message>
    <message>
        <source>Fewest teeth</source>
        <translation>Wenigste Zähne</translation>
    </message>
    <message>
        <source>Most teeth</source>
        <translation>Meiste Zähne</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erstes</translation>
    </message>
    <message>
        <source>second</source>
        <translation>zweites</translation>
    </message>
    <message>
        <source>third</source>
        <translation>drittes</translation>
    </message>
    <message>
        <source>fourth</source>
        <translation>viertes</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>Druckvorschau</translation>
    </message>
    <message>
        <source>Page %1 of %2: %3</source>
        <translation>Seite %1 von %2: %3</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>The drawing on a page of its own</source>
        <translation>Die Zeichnung auf einer eigenen Seite</translation>
    </message>
    <message>
        <source>Derivation with its matrices</source>
        <translation>Herleitung mit ihren Matrizen</translation>
    </message>
    <message>
        <source>Both methods worked out step by step</source>
        <translation>Beide Verfahren Schritt für Schritt</translation>
    </message>
    <message>
        <source>Page setup…</source>
        <translation>Seite einrichten …</translation>
    </message>
    <message>
        <source>Size and orientation of the paper</source>
        <translation>Größe und Ausrichtung des Papiers</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken …</translation>
    </message>
    <message>
        <source>Choose a printer, or a PDF file</source>
        <translation>Drucker oder PDF-Datei wählen</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>The page that is shown</source>
        <translation>Die gezeigte Seite</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>Nothing is chosen.</source>
        <translation>Es ist nichts gewählt.</translation>
    </message>
    <message>
        <source>There is no such page to print.</source>
        <translation>Eine solche Seite zum Drucken gibt es nicht.</translation>
    </message>
    <message>
        <source>The printer could not be opened.</source>
        <translation>Der Drucker konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The printer stopped at page %1.</source>
        <translation>Der Drucker hielt bei Seite %1 an.</translation>
    </message>
    <message>
        <source>Printing was stopped.</source>
        <translation>Der Druck wurde angehalten.</translation>
    </message>
    <message>
        <source>The printer reported an error.</source>
        <translation>Der Drucker meldete einen Fehler.</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept: no file can be written beside the document or in %1.</source>
        <translation>Ungespeicherte Änderungen können nicht aufbewahrt werden: Weder neben dem Dokument noch in %1 lässt sich eine Datei schreiben.</translation>
    </message>
    <message>
        <source>The schematic is still being laid out. Try again in a moment.</source>
        <translation>Das Schema wird noch angeordnet. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Finding places for %1 links …</source>
        <translation>Plätze für %1 Glieder werden gesucht …</translation>
    </message>
    <message>
        <source>The schematic shows up to %1 links; this train has %2. Digraph and T–T graph show all of them</source>
        <translation>Das Schema zeigt bis zu %1 Glieder; dieses Getriebe hat %2. Digraph und T–T-Graph zeigen alle</translation>
    </message>
    <message>
        <source>Draw the first shaft: L, then drag</source>
        <translation>Zeichnen Sie die erste Welle: L, dann ziehen</translation>
    </message>
    <message>
        <source>No turning joint ties a link to the ground yet. Draw a shaft: L, then drag</source>
        <translation>Noch verbindet kein Drehgelenk ein Glied mit dem Gestell. Zeichnen Sie eine Welle: L, dann ziehen</translation>
    </message>
    <message>
        <source>Move axis %1</source>
        <translation>Achse %1 verschieben</translation>
    </message>
    <message>
        <source>%1. Alt places freely, Esc puts back</source>
        <translation>%1. Alt platziert frei, Esc setzt zurück</translation>
    </message>
    <message>
        <source>Axis %1 is %2 from axis %3, module %4</source>
        <translation>Achse %1 ist %2 von Achse %3 entfernt, Modul %4</translation>
    </message>
    <message>
        <source>Module %1, teeth as they are</source>
        <translation>Modul %1, Zähnezahlen wie bisher</translation>
    </message>
    <message>
        <source>%1 : %2 teeth, %3 apart, %4 off</source>
        <translation>%1 : %2 Zähne, Abstand %3, Abweichung %4</translation>
    </message>
    <message>
        <source>%1. Choose tooth counts instead, or Esc</source>
        <translation>%1. Stattdessen Zähnezahlen wählen, oder Esc</translation>
    </message>
    <message>
        <source>Draw shaft</source>
        <translation>Welle zeichnen</translation>
    </message>
    <message>
        <source>Draw gear mesh</source>
        <translation>Zahneingriff zeichnen</translation>
    </message>
    <message>
        <source>Turning joint %1</source>
        <translation>Drehgelenk %1</translation>
    </message>
    <message>
        <source>Gear mesh %1</source>
        <translation>Zahneingriff %1</translation>
    </message>
    <message>
        <source>Search a command or a term  Ctrl+K</source>
        <translation>Befehl oder Begriff suchen  Strg+K</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>No command or term matches “%1”.</source>
        <translation>Kein Befehl oder Begriff passt zu „%1“.</translation>
    </message>
    <message>
        <source>element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>term</source>
        <translation>Begriff</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Enter selects and shows it.</source>
        <translation>Die Eingabetaste wählt es aus und zeigt es.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Equation (%1) of the paper.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Gleichung (%1) des Aufsatzes.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Shaft: drag along an axis, or on an empty area for a new axis</source>
        <translation>Welle: entlang einer Achse ziehen, oder im leeren Bereich für eine neue Achse</translation>
    </message>
    <message>
        <source>Shaft: release where it ends. Esc cancels</source>
        <translation>Welle: am Ende loslassen. Esc bricht ab</translation>
    </message>
    <message>
        <source>Carried shaft: drag from the link that carries it to its place</source>
        <translation>Getragene Welle: vom tragenden Glied zu ihrem Ort ziehen</translation>
    </message>
    <message>
        <source>Carried shaft: release at the place of its axis. Esc cancels</source>
        <translation>Getragene Welle: am Ort ihrer Achse loslassen. Esc bricht ab</translation>
    </message>
    <message>
        <source>Gear mesh: drag from a shaft to the one it drives</source>
        <translation>Zahneingriff: von einer Welle zu der ziehen, die sie treibt</translation>
    </message>
    <message>
        <source>Gear mesh: release on the other shaft, or beyond it for a ring. Esc cancels</source>
        <translation>Zahneingriff: auf der anderen Welle loslassen, oder jenseits davon für ein Hohlrad. Esc bricht ab</translation>
    </message>
    <message>
        <source>Input: click a turning joint, or the link it carries, to drive it or not</source>
        <translation>Antrieb: auf ein Drehgelenk oder das getragene Glied klicken, um es anzutreiben oder nicht</translation>
    </message>
    <message>
        <source>Drag to move the sheet</source>
        <translation>Ziehen, um das Blatt zu verschieben</translation>
    </message>
    <message>
        <source>Alt places freely. Esc puts back</source>
        <translation>Alt platziert frei. Esc setzt zurück</translation>
    </message>
    <message>
        <source>Gear mesh: drag from a gear to the gear it drives</source>
        <translation>Zahneingriff: von einem Rad zu dem ziehen, das es treibt</translation>
    </message>
    <message>
        <source>Turning joint: drag from a link to the link it carries</source>
        <translation>Drehgelenk: von einem Glied zu dem ziehen, das es trägt</translation>
    </message>
    <message>
        <source>Gear mesh: release on the second gear. Esc cancels</source>
        <translation>Zahneingriff: auf dem zweiten Rad loslassen. Esc bricht ab</translation>
    </message>
    <message>
        <source>Turning joint: release on the link that is carried. Esc cancels</source>
        <translation>Drehgelenk: auf dem getragenen Glied loslassen. Esc bricht ab</translation>
    </message>
    <message>
        <source>Release to select what is inside</source>
        <translation>Loslassen, um alles darin auszuwählen</translation>
    </message>
    <message>
        <source>Click to select, drag to move, drag on an empty area to select several</source>
        <translation>Klicken wählt aus, ziehen verschiebt, ziehen im leeren Bereich wählt mehrere aus</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>Turning joint</source>
        <translation>Drehgelenk</translation>
    </message>
    <message>
        <source>Gear mesh</source>
        <translation>Zahneingriff</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Link: click on an empty area</source>
        <translation>Glied: in den leeren Bereich klicken</translation>
    </message>
    <message>
        <source>Qt&apos;s platform &quot;%1&quot; has no windows with OpenGL.</source>
        <translation>Qts Plattform „%1“ hat keine Fenster mit OpenGL.</translation>
    </message>
    <message>
        <source>This display offers no OpenGL 3.3.</source>
        <translation>Diese Anzeige bietet kein OpenGL 3.3.</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>Coordinates beside the magnitudes of links and points</source>
        <translation>Koordinaten neben den Beträgen von Gliedern und Punkten</translation>
    </message>
    <message>
        <source>Save what is plotted as CSV</source>
        <translation>Speichern, was aufgetragen ist, als CSV</translation>
    </message>
    <message>
        <source>Select joints or links; trace points in the 3D view.</source>
        <translation>Wählen Sie Gelenke oder Glieder aus; zeichnen Sie Bahnen von Punkten in der 3D-Ansicht auf.</translation>
    </message>
    <message>
        <source>Nothing moves yet: the speeds appear here when the mechanism has valid inputs.</source>
        <translation>Noch bewegt sich nichts: Die Drehzahlen erscheinen hier, wenn der Mechanismus gültige Antriebe hat.</translation>
    </message>
    <message>
        <source>Wheel: zoom in time; Ctrl+wheel: in value; drag: move; click: go there; double click: all</source>
        <translation>Rad: Zeit zoomen; Strg+Rad: Wert zoomen; ziehen: verschieben; klicken: dorthin; Doppelklick: alles</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>bei %1 s</translation>
    </message>
    <message>
        <source>One step back (,)</source>
        <translation>Ein Schritt zurück (,)</translation>
    </message>
    <message>
        <source>One step on (.)</source>
        <translation>Ein Schritt vor (.)</translation>
    </message>
    <message>
        <source>Speed and direction</source>
        <translation>Geschwindigkeit und Richtung</translation>
    </message>
    <message>
        <source>Torques ×</source>
        <translation>Momente ×</translation>
    </message>
    <message>
        <source>The motion that the torques of Dynamics cause is shown. Click to let the inputs run at their speeds again</source>
        <translation>Gezeigt wird die Bewegung, die die Momente der Dynamik bewirken. Klicken, um die Antriebe wieder mit ihren Drehzahlen laufen zu lassen</translation>
    </message>
    <message>
        <source>Backwards</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Drag through the motion that the torques cause</source>
        <translation>Durch die Bewegung ziehen, die die Momente bewirken</translation>
    </message>
    <message>
        <source>Drag through one period of the motion</source>
        <translation>Durch eine Periode der Bewegung ziehen</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>%1 s (%2 … %3)</source>
        <translation>%1 s (%2 … %3)</translation>
    </message>
    <message>
        <source>%1 s / %2 s</source>
        <translation>%1 s / %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut square to %1</source>
        <translation>Schnitt senkrecht zu %1</translation>
    </message>
    <message>
        <source>Where the train is cut</source>
        <translation>Wo das Getriebe geschnitten ist</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Take away the other half</source>
        <translation>Die andere Hälfte wegnehmen</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Explosionsansicht</translation>
    </message>
    <message>
        <source>How far the parts are moved apart along their axes</source>
        <translation>Wie weit die Teile entlang ihrer Achsen auseinandergezogen sind</translation>
    </message>
    <message>
        <source>Picture of the train</source>
        <translation>Bild des Getriebes</translation>
    </message>
    <message>
        <source>Software 3D</source>
        <translation>Software-3D</translation>
    </message>
    <message>
        <source>%1 Painted by the processor (%2): finer when nothing moves.</source>
        <translation>%1 Vom Prozessor gezeichnet (%2): feiner, wenn sich nichts bewegt.</translation>
    </message>
    <message>
        <source>All of the train in the view (F)</source>
        <translation>Das ganze Getriebe in der Ansicht (F)</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>Iso</translation>
    </message>
    <message>
        <source>Isometric (0)</source>
        <translation>Isometrisch (0)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>From the front: x to the right, z up (1)</source>
        <translation>Von vorn: x nach rechts, z nach oben (1)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>From the right: y to the right, z up (2)</source>
        <translation>Von rechts: y nach rechts, z nach oben (2)</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>From above: x to the right, y up (3)</source>
        <translation>Von oben: x nach rechts, y nach oben (3)</translation>
    </message>
    <message>
        <source>Cut the train open (S)</source>
        <translation>Getriebe aufschneiden (S)</translation>
    </message>
    <message>
        <source>What is shown, and how</source>
        <translation>Was gezeigt wird, und wie</translation>
    </message>
    <message>
        <source>Limit reached: %1.</source>
        <translation>Grenze erreicht: %1.</translation>
    </message>
    <message>
        <source>Limit reached: %1. The motion turns round.</source>
        <translation>Grenze erreicht: %1. Die Bewegung kehrt um.</translation>
    </message>
    <message>
        <source>Nothing to turn yet: place axes and give the meshes their teeth.</source>
        <translation>Noch gibt es nichts zu drehen: Platzieren Sie Achsen und geben Sie den Zahneingriffen Zähnezahlen.</translation>
    </message>
    <message>
        <source>The point travels %1 %2 in %3 s.</source>
        <translation>Der Punkt legt %1 %2 in %3 s zurück.</translation>
    </message>
    <message>
        <source>not asked (GEARGRAPH_3D is set)</source>
        <translation>nicht gefragt (GEARGRAPH_3D ist gesetzt)</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>das Gestell</translation>
    </message>
    <message>
        <source>The gears are being made …</source>
        <translation>Die Zahnräder werden erzeugt …</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Lines, hidden ones left out</source>
        <translation>Linien ohne verdeckte</translation>
    </message>
    <message>
        <source>All edges</source>
        <translation>Alle Kanten</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstabsbalken</translation>
    </message>
    <message>
        <source>Pitch circles and cones</source>
        <translation>Wälzkreise und -kegel</translation>
    </message>
    <message>
        <source>Pitch points</source>
        <translation>Wälzpunkte</translation>
    </message>
    <message>
        <source>Instantaneous axes</source>
        <translation>Momentanachsen</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Forces under the loads</source>
        <translation>Kräfte unter den Lasten</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Orbit; Shift pans, Ctrl zooms (Blender)</source>
        <translation>Umkreisen; Umschalt verschiebt, Strg zoomt (Blender)</translation>
    </message>
    <message>
        <source>Pan; Shift orbits, Ctrl zooms (FreeCAD)</source>
        <translation>Verschieben; Umschalt umkreist, Strg zoomt (FreeCAD)</translation>
    </message>
    <message>
        <source>Orbit; Ctrl pans, Shift zooms (SolidWorks)</source>
        <translation>Umkreisen; Strg verschiebt, Umschalt zoomt (SolidWorks)</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Mittlere Maustaste</translation>
    </message>
    <message>
        <source>Stop riding along</source>
        <translation>Nicht mehr mitfahren</translation>
    </message>
    <message>
        <source>Show all parts</source>
        <translation>Alle Teile zeigen</translation>
    </message>
    <message>
        <source>Save the traced path as CSV…</source>
        <translation>Aufgezeichnete Bahn als CSV speichern …</translation>
    </message>
    <message>
        <source>Clear traced paths</source>
        <translation>Aufgezeichnete Bahnen löschen</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>Dim what is not selected</source>
        <translation>Nicht Ausgewähltes abdunkeln</translation>
    </message>
    <message>
        <source>Follow %1</source>
        <translation>%1 folgen</translation>
    </message>
    <message>
        <source>Look along its axis</source>
        <translation>Entlang seiner Achse blicken</translation>
    </message>
    <message>
        <source>Trace this point</source>
        <translation>Bahn dieses Punkts aufzeichnen</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide all others</source>
        <translation>Alle anderen ausblenden</translation>
    </message>
    <message>
        <source>Drag the part to turn the train. Ctrl turns it alone by hand</source>
        <translation>Am Teil ziehen, um das Getriebe zu drehen. Strg dreht es allein von Hand</translation>
    </message>
    <message>
        <source>Drag the part to turn it by hand</source>
        <translation>Am Teil ziehen, um es von Hand zu drehen</translation>
    </message>
    <message>
        <source>Drag to orbit: the train moves as its torques make it</source>
        <translation>Ziehen umkreist: Das Getriebe bewegt sich, wie seine Momente es treiben</translation>
    </message>
    <message>
        <source>Drag to orbit: this part does not turn</source>
        <translation>Ziehen umkreist: Dieses Teil dreht sich nicht</translation>
    </message>
    <message>
        <source>Drag to orbit, with Shift to pan; the wheel zooms</source>
        <translation>Ziehen umkreist, mit Umschalt verschiebt es; das Rad zoomt</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>Spra&amp;che</translation>
    </message>
    <message>
        <source>The language of the system, where the program speaks it</source>
        <translation>Die Sprache des Systems, wenn das Programm sie spricht</translation>
    </message>
    <message>
        <source>The language can be changed when the export is finished.</source>
        <translation>Die Sprache kann gewechselt werden, wenn der Export beendet ist.</translation>
    </message>
    <message>
        <source>The language can be changed when the file has been read.</source>
        <translation>Die Sprache kann gewechselt werden, wenn die Datei gelesen ist.</translation>
    </message>
    <message>
        <source>Moving links</source>
        <translation>Bewegte Glieder</translation>
    </message>
    <message>
        <source>The number of links without the ground. They bear the labels 1 to n; the ground is 0.</source>
        <translation>Anzahl der Glieder ohne das Gestell. Sie tragen die Nummern 1 bis n; das Gestell ist 0.</translation>
    </message>
    <message>
        <source>Turning joints</source>
        <translation>Drehgelenke</translation>
    </message>
    <message>
        <source>The number of turning pairs. They bear the labels n+1 to n+t. As a spanning tree they are as many as the moving links.</source>
        <translation>Anzahl der Drehgelenke. Sie tragen die Nummern n+1 bis n+t. Als Spannbaum sind es so viele wie bewegte Glieder.</translation>
    </message>
    <message>
        <source>Gear meshes</source>
        <translation>Zahneingriffe</translation>
    </message>
    <message>
        <source>The number of gear pairs. They bear the labels n+t+1 to n+t+c. Each closes one cycle of the basis.</source>
        <translation>Anzahl der Zahnradpaare. Sie tragen die Nummern n+t+1 bis n+t+c. Jedes schließt einen Zyklus der Basis.</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>The number of independent equations that the meshes put on the turning joints: the rank r of the coefficient matrix P.</source>
        <translation>Anzahl der unabhängigen Gleichungen, die die Zahneingriffe den Drehgelenken auferlegen: der Rang r der Koeffizientenmatrix P.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Freiheitsgrad</translation>
    </message>
    <message>
        <source>How many joints have to be driven so that the motion of all others follows: E = t − r.</source>
        <translation>Wie viele Gelenke angetrieben werden müssen, damit die Bewegung aller anderen folgt: E = t − r.</translation>
    </message>
    <message>
        <source>Incidence matrix</source>
        <translation>Inzidenzmatrix</translation>
    </message>
    <message>
        <source>A row for each link and a column for each joint and mesh: 1 where its arrow ends, −1 where it begins.</source>
        <translation>Eine Zeile je Glied und eine Spalte je Gelenk und Zahneingriff: 1, wo sein Pfeil endet, −1, wo er beginnt.</translation>
    </message>
    <message>
        <source>Reduced incidence matrix</source>
        <translation>Reduzierte Inzidenzmatrix</translation>
    </message>
    <message>
        <source>The incidence matrix without the ground&apos;s row, so that its rows are independent. G holds the turning joints, G* the meshes.</source>
        <translation>Die Inzidenzmatrix ohne die Zeile des Gestells, sodass ihre Zeilen unabhängig sind. G enthält die Drehgelenke, G* die Zahneingriffe.</translation>
    </message>
    <message>
        <source>Path matrix</source>
        <translation>Wegmatrix</translation>
    </message>
    <message>
        <source>A column for each link tells its walk through the tree to the ground: 1 where the walk runs along a joint, −1 where it runs against it.</source>
        <translation>Eine Spalte je Glied beschreibt seinen Weg durch den Baum zum Gestell: 1, wo der Weg mit einem Gelenk läuft, −1, wo er dagegen läuft.</translation>
    </message>
    <message>
        <source>Spanning-tree matrix</source>
        <translation>Spannbaummatrix</translation>
    </message>
    <message>
        <source>A row for each mesh tells which turning joints its cycle runs along (1) or against (−1): T = G*ᵀ Zᵀ.</source>
        <translation>Eine Zeile je Zahneingriff sagt, mit welchen Drehgelenken (1) oder gegen welche (−1) sein Zyklus läuft: T = G*ᵀ Zᵀ.</translation>
    </message>
    <message>
        <source>Cycle-basis matrix</source>
        <translation>Zyklenbasismatrix</translation>
    </message>
    <message>
        <source>A row for each cycle that a mesh closes: T holds its turning joints, the unit matrix U its mesh.</source>
        <translation>Eine Zeile je Zyklus, den ein Zahneingriff schließt: T enthält seine Drehgelenke, die Einheitsmatrix U seinen Zahneingriff.</translation>
    </message>
    <message>
        <source>Fundamental cutset matrix</source>
        <translation>Fundamentalschnittmatrix</translation>
    </message>
    <message>
        <source>A row for each turning joint tells which edges join the two halves that the tree falls into without it.</source>
        <translation>Eine Zeile je Drehgelenk sagt, welche Kanten die beiden Hälften verbinden, in die der Baum ohne das Gelenk zerfällt.</translation>
    </message>
    <message>
        <source>The mechanism as a directed graph: a node for each link, a solid arrow for each turning joint, a dashed arrow for each gear mesh.</source>
        <translation>Der Mechanismus als gerichteter Graph: ein Knoten je Glied, ein durchgezogener Pfeil je Drehgelenk, ein gestrichelter je Zahneingriff.</translation>
    </message>
    <message>
        <source>Functional schematic</source>
        <translation>Getriebeschema</translation>
    </message>
    <message>
        <source>The mechanism in section, with the symbols of ISO 3952: axes dash-dotted, shafts as thick lines, bearings as bars about them, gears as pitch lines, the frame hatched.</source>
        <translation>Der Mechanismus im Schnitt, mit den Symbolen der ISO 3952: Achsen strichpunktiert, Wellen als dicke Linien, Lager als Balken um sie, Zahnräder als Wälzlinien, das Gestell schraffiert.</translation>
    </message>
    <message>
        <source>A rigid body: a gear, a carrier arm, a shaft, or several of them in one.</source>
        <translation>Ein starrer Körper: ein Zahnrad, ein Steg, eine Welle oder mehrere davon in einem.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Gestell</translation>
    </message>
    <message>
        <source>The fixed link. All others are connected to it by turning joints.</source>
        <translation>Das feste Glied. Alle anderen sind durch Drehgelenke mit ihm verbunden.</translation>
    </message>
    <message>
        <source>Two links that turn relative to each other about an axis. Positive speed turns the head about the axis&apos; direction relative to the tail.</source>
        <translation>Zwei Glieder, die sich gegeneinander um eine Achse drehen. Eine positive Drehzahl dreht die Spitze gegen den Fuß um die Richtung der Achse.</translation>
    </message>
    <message>
        <source>Two toothed wheels that roll on each other at a pitch point.</source>
        <translation>Zwei Zahnräder, die in einem Wälzpunkt aufeinander abrollen.</translation>
    </message>
    <message>
        <source>A turning joint that a motor drives at a speed of its own. There are as many as degrees of freedom.</source>
        <translation>Ein Drehgelenk, das ein Motor mit eigener Drehzahl antreibt. Es gibt so viele, wie der Freiheitsgrad beträgt.</translation>
    </message>
    <message>
        <source>The line that turning joints turn about, the level of the T–T graph. Joints that stay coaxial share one.</source>
        <translation>Die Gerade, um die sich Drehgelenke drehen, die Ebene des T–T-Graphen. Gelenke, die koaxial bleiben, teilen sich eine.</translation>
    </message>
    <message>
        <source>Point of the axis</source>
        <translation>Punkt der Achse</translation>
    </message>
    <message>
        <source>A point that the axis goes through in the reference pose. Without it the axis is placed from the tooth counts.</source>
        <translation>Ein Punkt, durch den die Achse in der Bezugslage geht. Ohne ihn wird die Achse nach den Zähnezahlen platziert.</translation>
    </message>
    <message>
        <source>Direction of the axis</source>
        <translation>Richtung der Achse</translation>
    </message>
    <message>
        <source>The direction of the axis in the reference pose, of any length but 0. Positive speed turns about it by the right-hand rule.</source>
        <translation>Die Richtung der Achse in der Bezugslage, von beliebiger Länge außer 0. Eine positive Drehzahl dreht nach der Rechte-Hand-Regel um sie.</translation>
    </message>
    <message>
        <source>Where along the axis the bearing is drawn, from the axis&apos; point.</source>
        <translation>Wo entlang der Achse das Lager gezeichnet wird, vom Punkt der Achse aus.</translation>
    </message>
    <message>
        <source>Joint limits</source>
        <translation>Gelenkgrenzen</translation>
    </message>
    <message>
        <source>How far the joint may turn from the reference pose, both ways, in degrees.</source>
        <translation>Wie weit sich das Gelenk aus der Bezugslage drehen darf, in beide Richtungen, in Grad.</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zähne</translation>
    </message>
    <message>
        <source>The whole number of teeth of a wheel. Pitch diameters are proportional to it.</source>
        <translation>Die ganze Zahl der Zähne eines Rads. Wälzkreisdurchmesser sind ihr proportional.</translation>
    </message>
    <message>
        <source>The pitch diameter of a wheel over its teeth, one for both wheels of a mesh; of bevels at the large end. Another module moves the axes and changes no ratio.</source>
        <translation>Wälzkreisdurchmesser eines Rads durch seine Zähnezahl, gleich für beide Räder eines Zahneingriffs; bei Kegelrädern am großen Ende. Ein anderer Modul verschiebt die Achsen und ändert keine Übersetzung.</translation>
    </message>
    <message>
        <source>Kind of mesh</source>
        <translation>Art des Zahneingriffs</translation>
    </message>
    <message>
        <source>Where the two pitch surfaces touch in the reference pose. Without it the point follows from axes and teeth.</source>
        <translation>Wo sich die beiden Wälzflächen in der Bezugslage berühren. Ohne Angabe folgt der Punkt aus Achsen und Zähnezahlen.</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>The teeth of the mesh&apos;s tail over those of its head.</source>
        <translation>Zähnezahl am Fuß des Zahneingriffs durch die an seiner Spitze.</translation>
    </message>
    <message>
        <source>Spanning tree</source>
        <translation>Spannbaum</translation>
    </message>
    <message>
        <source>The turning joints, if they tie every link to the ground and close no loop.</source>
        <translation>Die Drehgelenke, wenn sie jedes Glied mit dem Gestell verbinden und keine Schleife schließen.</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>A mesh and the path through the tree that leads back from its head to its tail.</source>
        <translation>Ein Zahneingriff und der Weg durch den Baum, der von seiner Spitze zu seinem Fuß zurückführt.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>The paper&apos;s number of a link, joint or mesh. It follows from the order of the elements.</source>
        <translation>Nummer eines Glieds, Gelenks oder Zahneingriffs nach dem Aufsatz. Sie folgt aus der Reihenfolge der Elemente.</translation>
    </message>
    <message>
        <source>Screw</source>
        <translation>Schraube</translation>
    </message>
    <message>
        <source>A joint&apos;s axis as seen from a pitch point: its unit direction (L M N) and its moment (P Q R), the velocity that the point gets for one unit of speed.</source>
        <translation>Die Achse eines Gelenks, von einem Wälzpunkt aus gesehen: ihre Einheitsrichtung (L M N) und ihr Moment (P Q R), die Geschwindigkeit, die der Punkt für eine Einheit der Drehzahl erhält.</translation>
    </message>
    <message>
        <source>Coefficient matrix</source>
        <translation>Koeffizientenmatrix</translation>
    </message>
    <message>
        <source>A row for each mesh: the moment of each joint of its cycle about the pitch point, times T. P θ̇ = 0 holds for every motion; divided by the head&apos;s radius a row holds only ratios and ones.</source>
        <translation>Eine Zeile je Zahneingriff: das Moment jedes Gelenks seines Zyklus um den Wälzpunkt, mal T. P θ̇ = 0 gilt für jede Bewegung; durch den Radius der Spitze geteilt enthält eine Zeile nur Übersetzungen und Einsen.</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>The rate of every other joint for one unit of each input: minus the inverse of P&apos;s output part times its input part.</source>
        <translation>Die Drehzahl jedes anderen Gelenks für eine Einheit jedes Antriebs: minus die Inverse des Abtriebsteils von P mal seinen Antriebsteil.</translation>
    </message>
    <message>
        <source>The mechanism after Tsai and Tokad: a node for each link, a branch of the tree for each turning joint with the level it turns on, and for each gear mesh two chords, from its gears to their carrier arm. An arrow from i to k carries the velocity of link i relative to link k.</source>
        <translation>Der Mechanismus nach Tsai und Tokad: ein Knoten je Glied, ein Zweig des Baums je Drehgelenk mit der Ebene, auf der es dreht, und je Zahneingriff zwei Sehnen von seinen Rädern zu ihrem Steg. Ein Pfeil von i nach k trägt die Drehzahl von Glied i gegen Glied k.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>The axis that a branch of the T–T graph turns about. Joints that stay coaxial in every motion are on one level.</source>
        <translation>Die Achse, um die ein Zweig des T–T-Graphen dreht. Gelenke, die in jeder Bewegung koaxial bleiben, liegen auf einer Ebene.</translation>
    </message>
    <message>
        <source>Transfer vertex</source>
        <translation>Transferknoten</translation>
    </message>
    <message>
        <source>The carrier arm of a gear mesh: the node on the walk from gear to gear through the tree where the level changes.</source>
        <translation>Der Steg eines Zahneingriffs: der Knoten auf dem Weg von Rad zu Rad durch den Baum, an dem die Ebene wechselt.</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Sehne</translation>
    </message>
    <message>
        <source>A thin line from a gear of a mesh to its transfer vertex. The two chords of a mesh bear the same number of primes. Chords are no part of the tree: each closes one f-circuit.</source>
        <translation>Eine dünne Linie von einem Rad eines Zahneingriffs zu seinem Transferknoten. Die beiden Sehnen eines Zahneingriffs tragen gleich viele Striche. Sehnen gehören nicht zum Baum: Jede schließt einen Fundamentalkreis.</translation>
    </message>
    <message>
        <source>Terminal equation</source>
        <translation>Klemmengleichung</translation>
    </message>
    <message>
        <source>The relation between the two chords of a mesh: the velocity of gear i relative to the carrier arm is that of gear j times ± N(j) / N(i), plus where both gears turn the same way, seen from the arm.</source>
        <translation>Die Beziehung zwischen den beiden Sehnen eines Zahneingriffs: Die Drehzahl von Rad i gegen den Steg ist die von Rad j mal ± N(j) / N(i), plus, wenn sich beide Räder vom Steg aus gesehen gleichsinnig drehen.</translation>
    </message>
    <message>
        <source>f-circuit</source>
        <translation>Fundamentalkreis</translation>
    </message>
    <message>
        <source>A chord and the branches between its two ends: the velocity of the chord is the sum of theirs, with signs by their direction. Eqs. (31) to (38) are the paper&apos;s.</source>
        <translation>Eine Sehne und die Zweige zwischen ihren beiden Enden: Die Drehzahl der Sehne ist die Summe der ihren, mit Vorzeichen nach ihrer Richtung. Die Gln. (31) bis (38) sind die des Aufsatzes.</translation>
    </message>
    <message>
        <source>
Drag to change the load; W types it</source>
        <translation>
Ziehen ändert die Last; W tippt sie ein</translation>
    </message>
    <message>
        <source>%1 N m. %2</source>
        <translation>%1 N m. %2</translation>
    </message>
    <message>
        <source>What is plotted</source>
        <translation>Was aufgetragen wird</translation>
    </message>
    <message>
        <source>torques that hold the loads</source>
        <translation>Momente, die die Lasten halten</translation>
    </message>
    <message>
        <source>What it is plotted over; all else stays as it is</source>
        <translation>Worüber aufgetragen wird; alles andere bleibt, wie es ist</translation>
    </message>
    <message>
        <source>What it is plotted over</source>
        <translation>Worüber aufgetragen wird</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>The efficiency could not be followed: %1</source>
        <translation>Der Wirkungsgrad ließ sich nicht verfolgen: %1</translation>
    </message>
    <message>
        <source>A plot needs loads that are held, one way to hold them, and a motion.</source>
        <translation>Ein Diagramm braucht Lasten, die gehalten werden, genau eine Art, sie zu halten, und eine Bewegung.</translation>
    </message>
    <message>
        <source>torque, N m</source>
        <translation>Moment, N m</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>Plot of the efficiency</source>
        <translation>Diagramm des Wirkungsgrads</translation>
    </message>
    <message>
        <source>The pointer, or the left and right arrow keys, read the values</source>
        <translation>Der Mauszeiger oder die Pfeiltasten links und rechts lesen die Werte ab</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>T: torque in a joint; M: torque of a mesh on the part beyond the joint; both about the joint&apos;s axis. What the joint cuts off, and what crosses, is lit in all views.</source>
        <translation>T: Moment in einem Gelenk; M: Moment eines Zahneingriffs auf den Teil jenseits des Gelenks; beide um die Achse des Gelenks. Was das Gelenk abschneidet und was hinüberführt, leuchtet in allen Ansichten auf.</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Inhalt des Handbuchs</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Zurück (Alt+Links)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Vor (Alt+Rechts)</translation>
    </message>
    <message>
        <source>Find in the manual  Ctrl+F</source>
        <translation>Im Handbuch suchen  Ctrl+F</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Return goes to the next place, through all pages (Ctrl+F)</source>
        <translation>Die Eingabetaste geht zur nächsten Stelle, durch alle Seiten (Ctrl+F)</translation>
    </message>
    <message>
        <source>Manual: %1</source>
        <translation>Handbuch: %1</translation>
    </message>
    <message>
        <source>This is the first page that you opened.</source>
        <translation>Das ist die erste Seite, die Sie geöffnet haben.</translation>
    </message>
    <message>
        <source>This is the last page that you opened.</source>
        <translation>Das ist die letzte Seite, die Sie geöffnet haben.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Nicht gefunden</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Help &gt; Tour shows it again (Esc)</source>
        <translation>Hilfe &gt; Rundgang zeigt ihn wieder (Esc)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The part before (Left)</source>
        <translation>Der vorige Teil (Links)</translation>
    </message>
    <message>
        <source>This is the beginning.</source>
        <translation>Das ist der Anfang.</translation>
    </message>
    <message>
        <source>To the window (Return)</source>
        <translation>Zum Fenster (Eingabetaste)</translation>
    </message>
    <message>
        <source>The next part (Right)</source>
        <translation>Der nächste Teil (Rechts)</translation>
    </message>
    <message>
        <source>F1 opens the page of the manual.</source>
        <translation>F1 öffnet die Seite des Handbuchs.</translation>
    </message>
    <message>
        <source>A lesson is played in this window: take the tour in another one.</source>
        <translation>In diesem Fenster läuft eine Lektion: Machen Sie den Rundgang in einem anderen.</translation>
    </message>
    <message>
        <source>Web page with exercises (*.html)</source>
        <translation>Webseite mit Aufgaben (*.html)</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism: export it without exercises.</source>
        <translation>Zu diesem Mechanismus lässt sich nichts fragen: Exportieren Sie ihn ohne Aufgaben.</translation>
    </message>
    <message>
        <source>Load a joint or a link: drag for its torque, or click and type 10 Nm; where one is selected, its torque is typed at once</source>
        <translation>Ein Gelenk oder Glied belasten: Ziehen gibt das Moment, oder anklicken und 10 Nm eintippen; ist eines ausgewählt, tippt man sein Moment gleich ein</translation>
    </message>
    <message>
        <source>T&amp;orque…</source>
        <translation>Dreh&amp;moment …</translation>
    </message>
    <message>
        <source>Find a command, an element, a term or a page of the manual</source>
        <translation>Einen Befehl, ein Element, einen Begriff oder eine Seite des Handbuchs finden</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>The page of the manual about what has the focus</source>
        <translation>Die Seite des Handbuchs zu dem, was den Fokus hat</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this</source>
        <translation>Was ist &amp;das?</translation>
    </message>
    <message>
        <source>Then click something to learn what it is for</source>
        <translation>Klicken Sie dann etwas an, um zu erfahren, wozu es dient</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>The parts of the window in two minutes</source>
        <translation>Die Teile des Fensters in zwei Minuten</translation>
    </message>
    <message>
        <source>There is no command %1 in this window.</source>
        <translation>In diesem Fenster gibt es keinen Befehl %1.</translation>
    </message>
    <message>
        <source>Welcome to GearGraph</source>
        <translation>Willkommen bei GearGraph</translation>
    </message>
    <message>
        <source>Gear trains as graphs, as equations, and in motion. The tour shows the parts of the window with a robot as example; it takes two minutes. Help &gt; Tour repeats it.</source>
        <translation>Getriebe als Graphen, als Gleichungen und in Bewegung. Der Rundgang zeigt die Teile des Fensters am Beispiel eines Roboters; er dauert zwei Minuten. Hilfe &gt; Rundgang wiederholt ihn.</translation>
    </message>
    <message>
        <source>Draw links, joints and meshes</source>
        <translation>Glieder, Gelenke und Zahneingriffe zeichnen</translation>
    </message>
    <message>
        <source>Each circle is a link, each solid arrow a turning joint, each dashed arrow a pair of gears. Press L and click for a link, T or G and drag from one link to another. Everything can be undone.</source>
        <translation>Jeder Kreis ist ein Glied, jeder durchgezogene Pfeil ein Drehgelenk, jeder gestrichelte ein Zahnradpaar. Drücken Sie L und klicken Sie für ein Glied, T oder G und ziehen Sie von einem Glied zum anderen. Alles lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>The Matroid method</source>
        <translation>Das Matroid-Verfahren</translation>
    </message>
    <message>
        <source>The matrices follow from the drawing at once. Rest the mouse on an entry to have it explained; the arrow that it stands for lights up. Each row of C is the cycle that a mesh closes.</source>
        <translation>Die Matrizen folgen der Zeichnung sofort. Halten Sie die Maus über einen Eintrag, um ihn erklärt zu bekommen; der Pfeil, für den er steht, leuchtet auf. Jede Zeile von C ist der Zyklus, den ein Zahneingriff schließt.</translation>
    </message>
    <message>
        <source>The T–T graph method</source>
        <translation>Das T–T-Graph-Verfahren</translation>
    </message>
    <message>
        <source>The same mechanism by the second method: levels on the branches, two chords for each mesh, carrier arms with a second ring. Select a mesh to see its equations. Both methods give the same speeds.</source>
        <translation>Derselbe Mechanismus mit dem zweiten Verfahren: Ebenen an den Zweigen, zwei Sehnen je Zahneingriff, Stege mit einem zweiten Ring. Wählen Sie einen Zahneingriff aus, um seine Gleichungen zu sehen. Beide Verfahren liefern dieselben Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>The gears in motion</source>
        <translation>Die Zahnräder in Bewegung</translation>
    </message>
    <message>
        <source>Space plays. Drag a gear to turn the train by hand, drag elsewhere to look from another side. Section cuts it open.</source>
        <translation>Die Leertaste spielt ab. Ziehen Sie an einem Zahnrad, um das Getriebe von Hand zu drehen, und daneben, um es von einer anderen Seite zu sehen. Schnitt schneidet es auf.</translation>
    </message>
    <message>
        <source>Motors and speeds</source>
        <translation>Motoren und Geschwindigkeiten</translation>
    </message>
    <message>
        <source>The sliders set the speeds of the motors. Below are the speeds of all other joints: as formulas in the gear ratios, and as they are now.</source>
        <translation>Die Schieber stellen die Geschwindigkeiten der Motoren ein. Darunter stehen die Geschwindigkeiten aller anderen Gelenke: als Formeln in den Übersetzungen und als Werte von jetzt.</translation>
    </message>
    <message>
        <source>When something is wrong</source>
        <translation>Wenn etwas nicht stimmt</translation>
    </message>
    <message>
        <source>Problems says what is wrong, where, and what to do. A click on a line shows the place, and many lines bring a button that mends it.</source>
        <translation>Probleme zeigt, was falsch ist, wo, und was zu tun ist. Ein Klick auf eine Zeile zeigt die Stelle, und viele Zeilen bieten eine Schaltfläche, die es behebt.</translation>
    </message>
    <message>
        <source>Learn, and find anything</source>
        <translation>Lernen und alles finden</translation>
    </message>
    <message>
        <source>Learn &gt; Lessons is a course from one gear pair to this robot. Ctrl+K finds commands, terms and pages of the manual. F1 opens the page about what you are working with.</source>
        <translation>Lernen &gt; Lektionen ist ein Kurs vom einzelnen Radpaar bis zu diesem Roboter. Ctrl+K findet Befehle, Begriffe und Seiten des Handbuchs. F1 öffnet die Seite zu dem, womit Sie gerade arbeiten.</translation>
    </message>
    <message>
        <source>Find a command, an element, a term or a page of the manual (Ctrl+K)</source>
        <translation>Einen Befehl, ein Element, einen Begriff oder eine Seite des Handbuchs finden (Ctrl+K)</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>F1 shows it with a picture and its lesson. Type to search on; Esc closes.</source>
        <translation>F1 zeigt ihn mit Bild und Lektion. Weitertippen sucht weiter; Esc schließt.</translation>
    </message>
    <message>
        <source>Load: drag from a turning joint or a link for its torque, or click it and type 10 Nm</source>
        <translation>Last: von einem Drehgelenk oder Glied aus ziehen gibt das Moment, oder anklicken und 10 Nm eintippen</translation>
    </message>
    <message>
        <source>Load: to the right or upwards is more; Alt: tenths. Esc puts back</source>
        <translation>Last: nach rechts oder oben ist mehr; Alt: Zehntel. Esc stellt zurück</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Check &amp;my matrices…</source>
        <translation>&amp;Meine Matrizen prüfen …</translation>
    </message>
    <message>
        <source>Matrices and equations that you have worked out, beside the derived ones</source>
        <translation>Matrizen und Gleichungen, die Sie ausgearbeitet haben, neben den hergeleiteten</translation>
    </message>
    <message>
        <source>Your matrix</source>
        <translation>Ihre Matrix</translation>
    </message>
    <message>
        <source>The derived matrix, in your order</source>
        <translation>Die hergeleitete Matrix, in Ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>Check my matrices</source>
        <translation>Meine Matrizen prüfen</translation>
    </message>
    <message>
        <source>Your matrix or equations</source>
        <translation>Ihre Matrix oder Gleichungen</translation>
    </message>
    <message>
        <source>CSV, LaTeX, MATLAB, NumPy or plain text; equations, one a line</source>
        <translation>CSV, LaTeX, MATLAB, NumPy oder einfacher Text; Gleichungen, je Zeile eine</translation>
    </message>
    <message>
        <source>Type or paste a matrix or equations: CSV, LaTeX, MATLAB, NumPy, plain text</source>
        <translation>Matrix oder Gleichungen eintippen oder einfügen: CSV, LaTeX, MATLAB, NumPy, einfacher Text</translation>
    </message>
    <message>
        <source>Which matrix it is</source>
        <translation>Welche Matrix es ist</translation>
    </message>
    <message>
        <source>Which matrix it is; recognised by its name, size and entries</source>
        <translation>Welche Matrix es ist; erkannt an Name, Größe und Einträgen</translation>
    </message>
    <message>
        <source>Recognise the matrix</source>
        <translation>Matrix erkennen</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Was abweicht</translation>
    </message>
    <message>
        <source>Select one to see its entries, and its elements in the drawings</source>
        <translation>Eine auswählen, um ihre Einträge zu sehen, und ihre Elemente in den Zeichnungen</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>Read the matrix or the equations from a text file</source>
        <translation>Die Matrix oder die Gleichungen aus einer Textdatei lesen</translation>
    </message>
    <message>
        <source>Example of the paper</source>
        <translation>Beispiel der Arbeit</translation>
    </message>
    <message>
        <source>The rows of equation (45) under the labels of equation (25), for the robot of the paper</source>
        <translation>Die Zeilen von Gleichung (45) unter den Bezeichnungen von Gleichung (25), für den Roboter der Arbeit</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>Ihre</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>Hergeleitet</translation>
    </message>
    <message>
        <source>Open a matrix or equations</source>
        <translation>Matrix oder Gleichungen öffnen</translation>
    </message>
    <message>
        <source>Texts (*.csv *.tsv *.txt *.tex *.m *.py);;All files (*)</source>
        <translation>Texte (*.csv *.tsv *.txt *.tex *.m *.py);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Matrices of at most %1 moving links are compared.</source>
        <translation>Verglichen werden Matrizen von höchstens %1 beweglichen Gliedern.</translation>
    </message>
    <message>
        <source>This text is longer than any matrix that is compared.</source>
        <translation>Dieser Text ist länger als jede Matrix, die verglichen wird.</translation>
    </message>
    <message>
        <source>Your matrix or equations against the derived ones</source>
        <translation>Ihre Matrix oder Gleichungen im Vergleich mit den hergeleiteten</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>✓ Right: %1</source>
        <translation>✓ Richtig: %1</translation>
    </message>
    <message>
        <source>✗ Not right yet: %1</source>
        <translation>✗ Noch nicht richtig: %1</translation>
    </message>
    <message>
        <source>? Only labels can tell: %1</source>
        <translation>? Nur Bezeichnungen können es entscheiden: %1</translation>
    </message>
    <message>
        <source>Derived: %1</source>
        <translation>Hergeleitet: %1</translation>
    </message>
    <message>
        <source>Yours: %1</source>
        <translation>Ihre: %1</translation>
    </message>
    <message>
        <source>equation</source>
        <translation>Gleichung</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>✓ All that is written is right</source>
        <translation>✓ Alles Geschriebene ist richtig</translation>
    </message>
    <message>
        <source>✗ Not right yet: %1 of %2</source>
        <translation>✗ Noch nicht richtig: %1 von %2</translation>
    </message>
    <message>
        <source>How many questions of each kind are asked</source>
        <translation>Wie viele Fragen jeder Art gestellt werden</translation>
    </message>
    <message>
        <source>The same seed makes the same questions, here and on the command line</source>
        <translation>Derselbe Startwert ergibt dieselben Fragen, hier und auf der Befehlszeile</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Sheets that differ in their questions: one for each student, or one for all</source>
        <translation>Blätter mit verschiedenen Fragen: eines für jeden oder eines für alle</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Export sheets…</source>
        <translation>Blätter exportieren…</translation>
    </message>
    <message>
        <source>Export handout…</source>
        <translation>Handout exportieren…</translation>
    </message>
    <message>
        <source>Questions about this mechanism</source>
        <translation>Fragen zu diesem Mechanismus</translation>
    </message>
    <message>
        <source>Kinds of questions</source>
        <translation>Arten von Fragen</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Of each kind</source>
        <translation>Von jeder Art</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Choose every kind that the mechanism gives</source>
        <translation>Jede Art wählen, die der Mechanismus hergibt</translation>
    </message>
    <message>
        <source>Choose no kind, to begin with a few</source>
        <translation>Keine Art wählen, um mit wenigen zu beginnen</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>For a class</source>
        <translation>Für eine Klasse</translation>
    </message>
    <message>
        <source>The heading of sheets and handouts</source>
        <translation>Die Überschrift von Blättern und Handouts</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Webseite</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Sheets and solutions in this form</source>
        <translation>Blätter und Lösungen in dieser Form</translation>
    </message>
    <message>
        <source>Sheets as</source>
        <translation>Blätter als</translation>
    </message>
    <message>
        <source>Exercises are made of mechanisms of at most %1 moving links.</source>
        <translation>Aufgaben entstehen aus Mechanismen mit höchstens %1 bewegten Gliedern.</translation>
    </message>
    <message>
        <source>On the command line: %1</source>
        <translation>Auf der Befehlszeile: %1</translation>
    </message>
    <message>
        <source>The mechanism gives no such question: %1.</source>
        <translation>Der Mechanismus gibt keine solche Frage her: %1.</translation>
    </message>
    <message>
        <source>Choose a kind of question first.</source>
        <translation>Wählen Sie zuerst eine Art von Fragen.</translation>
    </message>
    <message>
        <source>A sheet has at most %1 questions.</source>
        <translation>Ein Blatt hat höchstens %1 Fragen.</translation>
    </message>
    <message>
        <source>Answer the questions in a window of their own, with hints and reasons</source>
        <translation>Die Fragen in einem eigenen Fenster beantworten, mit Hinweisen und Begründungen</translation>
    </message>
    <message>
        <source>At most %1 questions are practised at once.</source>
        <translation>Höchstens %1 Fragen werden auf einmal geübt.</translation>
    </message>
    <message>
        <source>Sheets, solutions and files for answers, which geargraph-cli exercises grade reads</source>
        <translation>Blätter, Lösungen und Dateien für Antworten, die geargraph-cli exercises grade liest</translation>
    </message>
    <message>
        <source>Choose a form of the sheets first.</source>
        <translation>Wählen Sie zuerst eine Form der Blätter.</translation>
    </message>
    <message>
        <source>The mechanism with these questions as one page for any browser, or for a learning platform</source>
        <translation>Der Mechanismus mit diesen Fragen als eine Seite für jeden Browser oder für eine Lernplattform</translation>
    </message>
    <message>
        <source>Other exercises ›</source>
        <translation>Andere Aufgaben ›</translation>
    </message>
    <message>
        <source>Package for learning platforms, SCORM 1.2 (*.zip)</source>
        <translation>Paket für Lernplattformen, SCORM 1.2 (*.zip)</translation>
    </message>
    <message>
        <source>Package with exercises, SCORM 1.2 (*.zip)</source>
        <translation>Paket mit Aufgaben, SCORM 1.2 (*.zip)</translation>
    </message>
    <message>
        <source>Folder in which the sheets&apos; folder is made</source>
        <translation>Ordner, in dem der Ordner der Blätter angelegt wird</translation>
    </message>
    <message>
        <source>%1 exercises %2</source>
        <translation>%1 Aufgaben %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already: no sheet was written.</source>
        <translation>„%1“ gibt es schon: Es wurde kein Blatt geschrieben.</translation>
    </message>
    <message>
        <source>One page for any browser, also on a phone and without a network: drawings, matrices, solution, derivation and the train in 3D, with inputs that move, and exercises if you choose them; also as a package for learning platforms</source>
        <translation>Eine Seite für jeden Browser, auch auf dem Telefon und ohne Netz: Zeichnungen, Matrizen, Lösung, Herleitung und das Getriebe in 3D, mit Antrieben, die sich bewegen, und auf Wunsch mit Aufgaben; auch als Paket für Lernplattformen</translation>
    </message>
    <message>
        <source>&amp;Exercises…</source>
        <translation>Auf&amp;gaben…</translation>
    </message>
    <message>
        <source>Questions about this mechanism, to practise, or as sheets and handouts for a class</source>
        <translation>Fragen zu diesem Mechanismus, zum Üben oder als Blätter und Handouts für eine Klasse</translation>
    </message>
    <message>
        <source>Questions: %1</source>
        <translation>Fragen: %1</translation>
    </message>
    <message>
        <source>‹ Exercises</source>
        <translation>‹ Aufgaben</translation>
    </message>
    <message>
        <source>Other questions, or another seed</source>
        <translation>Andere Fragen oder ein anderer Startwert</translation>
    </message>
    <message>
        <source>The same at any torque</source>
        <translation>Bei jedem Moment gleich</translation>
    </message>
    <message>
        <source>Losses of meshes are proportional to their power, whether an efficiency or a coefficient of friction is stated: all loads scaled alike leave the efficiency as it is, so there is no plot over the torque. Of several loads only the proportions matter.</source>
        <translation>Die Verluste von Zahneingriffen sind ihrer Leistung proportional, ob ein Wirkungsgrad oder eine Reibungszahl angegeben ist: werden alle Lasten gleich skaliert, bleibt der Wirkungsgrad, wie er ist; daher gibt es kein Diagramm über dem Moment. Bei mehreren Lasten zählen nur die Verhältnisse.</translation>
    </message>
    <message>
        <source>Exactly %1</source>
        <translation>Genau %1</translation>
    </message>
    <message>
        <source>both methods agree</source>
        <translation>beide Methoden stimmen überein</translation>
    </message>
    <message>
        <source>Row %1: speeds of mesh %1</source>
        <translation>Zeile %1: Drehzahlen von Zahneingriff %1</translation>
    </message>
    <message>
        <source>Column %1: torque in joint %1</source>
        <translation>Spalte %1: Moment in Gelenk %1</translation>
    </message>
    <message>
        <source>shared in unknown parts, or not held</source>
        <translation>zu unbekannten Teilen geteilt, oder nicht gehalten</translation>
    </message>
    <message>
        <source>here %1 N m</source>
        <translation>hier %1 N m</translation>
    </message>
    <message>
        <source>Documents and tables (*.geargraph *.csv *.tsv);;GearGraph documents (*.geargraph);;Tables of documents (*.csv *.tsv);;All files (*)</source>
        <translation>Dokumente und Tabellen (*.geargraph *.csv *.tsv);;GearGraph-Dokumente (*.geargraph);;Tabellen von Dokumenten (*.csv *.tsv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>%1 was imported. Save writes a document of its own.</source>
        <translation>%1 wurde importiert. Speichern schreibt ein eigenes Dokument.</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>Lay axis %1</source>
        <translation>Achse %1 legen</translation>
    </message>
    <message>
        <source>it is pinned</source>
        <translation>sie ist fixiert</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>i: the teeth of the tail&apos;s gear over those of the head&apos;s; η: the efficiency of a mesh. It holds as long as the same gears drive.</source>
        <translation>i: die Zähnezahl des Rads am Anfang durch die des Rads an der Spitze; η: der Wirkungsgrad eines Zahneingriffs. Sie gilt, solange dieselben Räder treiben.</translation>
    </message>
    <message>
        <source>Efficiency of a mesh</source>
        <translation>Wirkungsgrad eines Zahneingriffs</translation>
    </message>
    <message>
        <source>Set efficiency</source>
        <translation>Wirkungsgrad ändern</translation>
    </message>
    <message>
        <source>Every mesh states an efficiency or a friction of its own.</source>
        <translation>Jeder Zahneingriff gibt einen eigenen Wirkungsgrad oder eine eigene Reibung an.</translation>
    </message>
    <message>
        <source>An efficiency replaces the coefficient of friction that the document states for all meshes.</source>
        <translation>Ein Wirkungsgrad tritt an die Stelle der Reibungszahl, die das Dokument für alle Zahneingriffe angibt.</translation>
    </message>
    <message>
        <source>Self-locking below η = %1</source>
        <translation>Selbsthemmend unter η = %1</translation>
    </message>
    <message>
        <source>Self-locking backward below η = %1</source>
        <translation>Rückwärts selbsthemmend unter η = %1</translation>
    </message>
    <message>
        <source>Never self-locking, at any efficiency</source>
        <translation>Nie selbsthemmend, bei keinem Wirkungsgrad</translation>
    </message>
    <message>
        <source>T in joint %1, link %2</source>
        <translation>T in Gelenk %1, Glied %2</translation>
    </message>
    <message>
        <source>A load: the torque that the joint&apos;s tail exerts on its head, link %1, about the direction of its axis.</source>
        <translation>Eine Last: das Moment, das der Anfang des Gelenks auf seine Spitze, Glied %1, um die Richtung seiner Achse ausübt.</translation>
    </message>
    <message>
        <source>T on link %1</source>
        <translation>T an Glied %1</translation>
    </message>
    <message>
        <source>A load: a torque from outside on the link; the ground takes the reaction.</source>
        <translation>Eine Last: ein Moment von außen am Glied; das Gestell nimmt die Reaktion auf.</translation>
    </message>
    <message>
        <source>link %1, held by brake %2</source>
        <translation>Glied %1, von Bremse %2 gehalten</translation>
    </message>
    <message>
        <source>links %1 and %2, joined by clutch %3</source>
        <translation>Glieder %1 und %2, von Kupplung %3 verbunden</translation>
    </message>
    <message>
        <source>carries %1 N m</source>
        <translation>trägt %1 N m</translation>
    </message>
    <message>
        <source>shares its load in unknown parts</source>
        <translation>teilt seine Last zu unbekannten Teilen</translation>
    </message>
    <message>
        <source>The torque of the brake on link %1, about its first axis on the way to the ground. At rest it passes no power.</source>
        <translation>Das Moment der Bremse auf Glied %1, um dessen erste Achse auf dem Weg zum Gestell. In Ruhe überträgt sie keine Leistung.</translation>
    </message>
    <message>
        <source>The torque of the clutch on link %1; the other link has the reaction.</source>
        <translation>Das Moment der Kupplung auf Glied %1; das andere Glied hat die Reaktion.</translation>
    </message>
    <message>
        <source>%1 N m, found</source>
        <translation>%1 N m, gefunden</translation>
    </message>
    <message>
        <source>shared in unknown parts</source>
        <translation>zu unbekannten Teilen geteilt</translation>
    </message>
    <message>
        <source>Found: the torque that holds the loads here, of the joint&apos;s tail on its head, link %1, about the direction of its axis.</source>
        <translation>Gefunden: das Moment, das hier die Lasten hält, vom Anfang des Gelenks auf seine Spitze, Glied %1, um die Richtung seiner Achse.</translation>
    </message>
    <message>
        <source>Found: the torque from outside on the link that holds the loads.</source>
        <translation>Gefunden: das Moment von außen am Glied, das die Lasten hält.</translation>
    </message>
    <message>
        <source>%1 of %2 torques are listed; all of them are in Forces</source>
        <translation>%1 von %2 Momenten sind aufgeführt; alle stehen unter Kräfte</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Entlang x</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Entlang y</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>Entlang z</translation>
    </message>
    <message>
        <source>Square to</source>
        <translation>Rechtwinklig zu</translation>
    </message>
    <message>
        <source>Parallel to</source>
        <translation>Parallel zu</translation>
    </message>
    <message>
        <source>Through the meeting point of</source>
        <translation>Durch den Schnittpunkt von</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>wählen…</translation>
    </message>
    <message>
        <source>Click to choose the input and the output link of this state</source>
        <translation>Klicken, um das An- und das Abtriebsglied dieses Schaltzustands zu wählen</translation>
    </message>
    <message>
        <source>State %1 has no ratio yet: click “choose…” in its row and name its input and output links.</source>
        <translation>Schaltzustand %1 hat noch keine Übersetzung: Klicken Sie in seiner Zeile auf „wählen…“ und nennen Sie An- und Abtriebsglied.</translation>
    </message>
    <message>
        <source>Which link is the input of state %1?</source>
        <translation>Welches Glied ist der Antrieb von Schaltzustand %1?</translation>
    </message>
    <message>
        <source>Which link is the output of state %1?</source>
        <translation>Welches Glied ist der Abtrieb von Schaltzustand %1?</translation>
    </message>
    <message>
        <source>Choose input and output</source>
        <translation>An- und Abtrieb wählen</translation>
    </message>
    <message>
        <source>Choose input and output…</source>
        <translation>An- und Abtrieb wählen…</translation>
    </message>
    <message>
        <source>Lay axis</source>
        <translation>Achse legen</translation>
    </message>
    <message>
        <source>Lay the axis along x, y or z, or as another axis lies. The kinds of its meshes follow.</source>
        <translation>Legt die Achse entlang x, y oder z oder so, wie eine andere Achse liegt. Die Arten ihrer Zahneingriffe folgen.</translation>
    </message>
    <message>
        <source>Slide to change the teeth; Esc puts back</source>
        <translation>Schieben ändert die Zähnezahl; Esc stellt zurück</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Turning joint %1 closes a loop.</source>
        <translation>Drehgelenk %1 schließt eine Schleife.</translation>
    </message>
    <message>
        <source>Turning joint %1 closes a loop with %2.</source>
        <translation>Drehgelenk %1 schließt eine Schleife mit %2.</translation>
    </message>
    <message>
        <source>All of them turn about axis %1, so joint %2 is a redundant bearing: drop it.</source>
        <translation>Alle drehen sich um Achse %1, also ist Gelenk %2 ein überzähliges Lager: Entfernen Sie es.</translation>
    </message>
    <message>
        <source>The turning joints have to be a tree: delete one of them, or draw a gear mesh instead.</source>
        <translation>Die Drehgelenke müssen ein Baum sein: Löschen Sie eines davon oder zeichnen Sie stattdessen einen Zahneingriff.</translation>
    </message>
    <message>
        <source>Link %1 is not tied to the ground by turning joints: draw a turning joint to it.</source>
        <translation>Glied %1 ist nicht durch Drehgelenke mit dem Gestell verbunden: Zeichnen Sie ein Drehgelenk zu ihm.</translation>
    </message>
    <message>
        <source>Links %1 are not tied to the ground by turning joints: draw a turning joint to them.</source>
        <translation>Die Glieder %1 sind nicht durch Drehgelenke mit dem Gestell verbunden: Zeichnen Sie ein Drehgelenk zu ihnen.</translation>
    </message>
    <message>
        <source>Mesh %1: %2</source>
        <translation>Eingriff %1: %2</translation>
    </message>
    <message>
        <source>another tooth count</source>
        <translation>eine andere Zähnezahl</translation>
    </message>
    <message>
        <source>the pitch point %1</source>
        <translation>der Wälzpunkt %1</translation>
    </message>
    <message>
        <source>the pitch point %1 lies on the axis of the tail gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.</source>
        <translation>Der Wälzpunkt %1 liegt auf der Achse des Rades am Fuß, sodass dessen Wälzradius 0 ist. Es passt: ein Punkt abseits beider Achsen, in ihrer Ebene.</translation>
    </message>
    <message>
        <source>the pitch point %1 lies on the axis of the head gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.</source>
        <translation>Der Wälzpunkt %1 liegt auf der Achse des Rades an der Spitze, sodass dessen Wälzradius 0 ist. Es passt: ein Punkt abseits beider Achsen, in ihrer Ebene.</translation>
    </message>
    <message>
        <source>its two axes are the same line in the reference pose.</source>
        <translation>Seine beiden Achsen sind in der Bezugsstellung dieselbe Gerade.</translation>
    </message>
    <message>
        <source>the pitch point %1 lies %2 off the plane of the two axes, so the teeth would lock. What fits: %3, or none (then it follows from the axes).</source>
        <translation>Der Wälzpunkt %1 liegt %2 außerhalb der Ebene beider Achsen, sodass die Zähne sperren würden. Es passt: %3, oder keiner (dann folgt er aus den Achsen).</translation>
    </message>
    <message>
        <source>it says %1, but its axes are parallel. What fits: external or internal.</source>
        <translation>Als Art ist „%1“ angegeben, aber seine Achsen sind parallel. Es passt: außen oder innen.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet. What fits: bevel.</source>
        <translation>Als Art ist „%1“ angegeben, aber seine Achsen schneiden sich. Es passt: Kegelräder.</translation>
    </message>
    <message>
        <source>it says internal, but the pitch point %1 lies between the axes, which is an external pair.</source>
        <translation>Als Art ist „innen“ angegeben, aber der Wälzpunkt %1 liegt zwischen den Achsen, was ein Außenpaar ist.</translation>
    </message>
    <message>
        <source>it says external, but the pitch point %1 lies on one side of both axes, which is an internal pair.</source>
        <translation>Als Art ist „außen“ angegeben, aber der Wälzpunkt %1 liegt auf einer Seite beider Achsen, was ein Innenpaar ist.</translation>
    </message>
    <message>
        <source>What fits: %1, or %2.</source>
        <translation>Es passt: %1, oder %2.</translation>
    </message>
    <message>
        <source>the pitch radii are %1 and %2 (ratio %3), but the teeth are %4 and %5 (ratio %6). What fits: %7 teeth on the head, or %8.</source>
        <translation>Die Wälzradien sind %1 und %2 (Verhältnis %3), aber die Zähnezahlen sind %4 und %5 (Verhältnis %6). Es passt: %7 Zähne an der Spitze, oder %8.</translation>
    </message>
    <message>
        <source>an internal pair needs different tooth counts, the ring the larger one; both have %1.</source>
        <translation>Ein Innenpaar braucht verschiedene Zähnezahlen, das Hohlrad die größere; beide haben %1.</translation>
    </message>
    <message>
        <source>some of %1</source>
        <translation>einige von %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>state “%1”</source>
        <translation>Schaltzustand „%1“</translation>
    </message>
    <message>
        <source>State “%1” engages %2, link $%3$ drives and link $%4$ bears the load</source>
        <translation>Schaltzustand „%1“ schließt %2, Glied $%3$ treibt an, und Glied $%4$ trägt die Last</translation>
    </message>
    <message>
        <source>state “%1” engages %2, link $%3$ drives and link $%4$ bears the load</source>
        <translation>Schaltzustand „%1“ schließt %2, Glied $%3$ treibt an, und Glied $%4$ trägt die Last</translation>
    </message>
    <message>
        <source>The torque of the drive is $%1$ N m, and no power is lost.</source>
        <translation>Das Antriebsmoment beträgt $%1$ N m, und es geht keine Leistung verloren.</translation>
    </message>
    <message>
        <source>Which of the engaged brakes and clutches carries the largest torque, and how large is it in N m, without a sign? A fraction or a decimal of three digits will do.</source>
        <translation>Welche der geschlossenen Bremsen und Kupplungen trägt das größte Moment, und wie groß ist es in N m, ohne Vorzeichen? Ein Bruch oder eine Dezimalzahl mit drei Ziffern genügt.</translation>
    </message>
    <message>
        <source>In which state does %1 carry the largest torque, and how large is it in N m, without a sign? A fraction or a decimal of three digits will do.</source>
        <translation>In welchem Schaltzustand trägt %1 das größte Moment, und wie groß ist es in N m, ohne Vorzeichen? Ein Bruch oder eine Dezimalzahl mit drei Ziffern genügt.</translation>
    </message>
    <message>
        <source>largest torque in</source>
        <translation>größtes Moment in</translation>
    </message>
    <message>
        <source>torque in N m</source>
        <translation>Moment in N m</translation>
    </message>
    <message>
        <source>The torques on each link and in each mesh balance: %1.</source>
        <translation>Die Momente an jedem Glied und in jedem Eingriff sind im Gleichgewicht: %1.</translation>
    </message>
    <message>
        <source>You choose the clutch that turns fastest, but the torque does not follow the speed: it carries %1 N m, less than the %2 N m of %3.</source>
        <translation>Sie wählen die Kupplung, die sich am schnellsten dreht, aber das Moment folgt nicht der Drehzahl: Sie trägt %1 N m, weniger als die %2 N m von %3.</translation>
    </message>
    <message>
        <source>You choose the state of the largest ratio, but the brake&apos;s torque does not follow the ratio&apos;s size: it carries %1 N m, less than the %2 N m of %3.</source>
        <translation>Sie wählen den Schaltzustand mit der größten Übersetzung, aber das Moment der Bremse folgt nicht dem Betrag der Übersetzung: Sie trägt %1 N m, weniger als die %2 N m von %3.</translation>
    </message>
    <message>
        <source>The %1 carries %2 N m, less than the %3 N m of %4.</source>
        <translation>Die %1 trägt %2 N m, weniger als die %3 N m von %4.</translation>
    </message>
    <message>
        <source>In state “%1” it carries %2 N m, less than the %3 N m of %4.</source>
        <translation>In Schaltzustand „%1“ trägt sie %2 N m, weniger als die %3 N m von %4.</translation>
    </message>
    <message>
        <source>The %1 is released in this state: it carries no torque.</source>
        <translation>Die %1 ist in diesem Schaltzustand gelöst: Sie trägt kein Moment.</translation>
    </message>
    <message>
        <source>State “%1” releases the %2: it carries no torque.</source>
        <translation>Schaltzustand „%1“ löst die %2: Sie trägt kein Moment.</translation>
    </message>
    <message>
        <source>The signs of both torques are lost: the brake holds the sum of %1 N m and %2 N m.</source>
        <translation>Die Vorzeichen beider Momente fehlen: Die Bremse hält die Summe aus %1 N m und %2 N m.</translation>
    </message>
    <message>
        <source>You use the ratio upside down: with the ratio %1 the torque on the driven link is %2 N m.</source>
        <translation>Sie verwenden die Übersetzung verkehrt herum: Mit der Übersetzung %1 beträgt das Moment am getriebenen Glied %2 N m.</translation>
    </message>
    <message>
        <source>This is the torque of %1, which is not the largest.</source>
        <translation>Das ist das Moment von %1, das nicht das größte ist.</translation>
    </message>
    <message>
        <source>This is the torque in state “%1”, which is not the largest.</source>
        <translation>Das ist das Moment in Schaltzustand „%1“, das nicht das größte ist.</translation>
    </message>
    <message>
        <source>This is the torque of the load on link %1: %2 has to keep the balance.</source>
        <translation>Das ist das Lastmoment an Glied %1: %2 muss das Gleichgewicht halten.</translation>
    </message>
    <message>
        <source>This is the torque of the drive: %1 does not carry it as it is.</source>
        <translation>Das ist das Antriebsmoment: %1 trägt es nicht unverändert.</translation>
    </message>
    <message>
        <source>Write the row of mesh $%1$ of the coefficient matrix $P$. Mesh $%1$ has $%2$ teeth on link $%3$ and $%4$ on link $%5$. Any multiple of the row is right: radii, numbers of teeth or the ratio $i_{%1}$.</source>
        <translation>Schreiben Sie die Zeile von Eingriff $%1$ der Koeffizientenmatrix $P$. Eingriff $%1$ hat $%2$ Zähne an Glied $%3$ und $%4$ an Glied $%5$. Jedes Vielfache der Zeile ist richtig: Radien, Zähnezahlen oder die Übersetzung $i_{%1}$.</translation>
    </message>
    <message>
        <source>A joint on the axis of a gear counts with this gear&apos;s radius, the sign is that of the cycle, and the joints of both gears have the signs of the mesh.</source>
        <translation>Ein Gelenk auf der Achse eines Rades zählt mit dem Radius dieses Rades, das Vorzeichen ist das des Zyklus, und die Gelenke beider Räder haben die Vorzeichen des Eingriffs.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: both gears turn the same way, seen from their carrier.</source>
        <translation>Eingriff %1 ist innen: Beide Räder drehen sich, vom Steg aus gesehen, gleichsinnig.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: its gears turn against each other, seen from their carrier.</source>
        <translation>Eingriff %1 ist außen: Seine Räder drehen sich, vom Steg aus gesehen, gegensinnig.</translation>
    </message>
    <message>
        <source>The sign of bevel mesh %1 follows from where its pitch point is, seen from both axes.</source>
        <translation>Das Vorzeichen des Kegelradeingriffs %1 folgt aus der Lage seines Wälzpunkts, von beiden Achsen aus gesehen.</translation>
    </message>
    <message>
        <source>You exchange the radii of both gears: the joints on an axis count with the radius of the gear on it.</source>
        <translation>Sie vertauschen die Radien beider Räder: Die Gelenke auf einer Achse zählen mit dem Radius des Rades darauf.</translation>
    </message>
    <message>
        <source>This is the row of the cycle: in P its signs are multiplied by the radii of the gears.</source>
        <translation>Das ist die Zeile des Zyklus: In P werden seine Vorzeichen mit den Radien der Räder multipliziert.</translation>
    </message>
    <message>
        <source>You write the radii without the signs of the cycle, which walks against some arrows.</source>
        <translation>Sie schreiben die Radien ohne die Vorzeichen des Zyklus, der gegen manche Pfeile läuft.</translation>
    </message>
    <message>
        <source>This is the row of mesh %1.</source>
        <translation>Das ist die Zeile von Eingriff %1.</translation>
    </message>
    <message>
        <source>You exchange the radii of both gears, and the sign of the mesh is wrong, too.</source>
        <translation>Sie vertauschen die Radien beider Räder, und auch das Vorzeichen des Eingriffs ist falsch.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 does not use %2: 0.</source>
        <translation>Der Zyklus von Eingriff %1 benutzt %2 nicht: 0.</translation>
    </message>
    <message>
        <source>The sign of %1 is the opposite: the walk passes its arrow the other way.</source>
        <translation>Das Vorzeichen von %1 ist umgekehrt: Der Weg läuft andersherum durch seinen Pfeil.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 uses %2: its coefficient is not 0.</source>
        <translation>Der Zyklus von Eingriff %1 benutzt %2: Sein Koeffizient ist nicht 0.</translation>
    </message>
    <message>
        <source>Which turning joints lie on the fundamental cycle of mesh $%1$?</source>
        <translation>Welche Drehgelenke liegen auf dem Fundamentalzyklus von Eingriff $%1$?</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 consists of the mesh and of the path through the tree from link %2 to link %3.</source>
        <translation>Der Zyklus von Eingriff %1 besteht aus dem Eingriff und dem Weg durch den Baum von Glied %2 zu Glied %3.</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>You follow both paths to the ground: the cycle turns back at the first link that they share.</source>
        <translation>Sie folgen beiden Wegen bis zum Gestell: Der Zyklus kehrt am ersten gemeinsamen Glied um.</translation>
    </message>
    <message>
        <source>You follow the path of link %1 to the ground: the cycle needs the path between both gears.</source>
        <translation>Sie folgen dem Weg von Glied %1 bis zum Gestell: Der Zyklus braucht den Weg zwischen beiden Rädern.</translation>
    </message>
    <message>
        <source>These are the joints on the cycle of mesh %1.</source>
        <translation>Das sind die Gelenke auf dem Zyklus von Eingriff %1.</translation>
    </message>
    <message>
        <source>%1 is a mesh: the question asks for the turning joints.</source>
        <translation>%1 ist ein Eingriff: Gefragt sind die Drehgelenke.</translation>
    </message>
    <message>
        <source>The path between links %1 and %2 leads through joint %3.</source>
        <translation>Der Weg zwischen den Gliedern %1 und %2 führt durch Gelenk %3.</translation>
    </message>
    <message>
        <source>The path between links %1 and %2 does not lead through joint %3.</source>
        <translation>Der Weg zwischen den Gliedern %1 und %2 führt nicht durch Gelenk %3.</translation>
    </message>
    <message>
        <source>Walk once round the cycle of mesh $%1$, in either sense: $1$ for each arrow that you follow, $-1$ for each that you walk against.</source>
        <translation>Gehen Sie einmal um den Zyklus von Eingriff $%1$, in beliebigem Sinn: $1$ für jeden Pfeil, dem Sie folgen, $-1$ für jeden, gegen den Sie gehen.</translation>
    </message>
    <message>
        <source>One walk runs along mesh %1 and back through the tree; the opposite walk has all signs exchanged and is right, too.</source>
        <translation>Ein Umlauf führt durch Eingriff %1 und durch den Baum zurück; beim umgekehrten Umlauf sind alle Vorzeichen vertauscht, und auch er ist richtig.</translation>
    </message>
    <message>
        <source>You give all edges one sense: some arrows point against every walk round the cycle.</source>
        <translation>Sie geben allen Kanten denselben Sinn: Gegen jeden Umlauf des Zyklus weisen einige Pfeile.</translation>
    </message>
    <message>
        <source>Your walk passes %1 the other way: with the other senses that you give, its sign is the opposite.</source>
        <translation>Ihr Weg läuft andersherum durch %1: Zu den anderen Richtungen, die Sie angeben, gehört das umgekehrte Vorzeichen.</translation>
    </message>
    <message>
        <source>Every walk round the cycle uses %1: 1 or −1, not 0.</source>
        <translation>Jeder Umlauf des Zyklus benutzt %1: 1 oder −1, nicht 0.</translation>
    </message>
    <message>
        <source>These senses belong to no single walk round the cycle: start at one link and follow the edges one by one.</source>
        <translation>Diese Richtungen gehören zu keinem einzelnen Umlauf des Zyklus: Beginnen Sie bei einem Glied und folgen Sie den Kanten der Reihe nach.</translation>
    </message>
    <message>
        <source>Write down all fundamental cycles, one in each row: in any order, each walked in either sense.</source>
        <translation>Schreiben Sie alle Fundamentalzyklen auf, einen je Zeile: in beliebiger Reihenfolge, jeden in beliebigem Sinn.</translation>
    </message>
    <message>
        <source>There is a cycle for each mesh; its row may be multiplied by −1, and rows may be exchanged.</source>
        <translation>Zu jedem Eingriff gibt es einen Zyklus; seine Zeile darf mit −1 multipliziert werden, und Zeilen dürfen vertauscht werden.</translation>
    </message>
    <message>
        <source>You mark the edges of the cycles without their senses: a walk that runs against an arrow has −1.</source>
        <translation>Sie markieren die Kanten der Zyklen ohne ihre Richtungen: Ein Weg gegen einen Pfeil zählt −1.</translation>
    </message>
    <message>
        <source>You write one cycle twice: each mesh closes a cycle of its own.</source>
        <translation>Sie schreiben einen Zyklus zweimal: Jeder Eingriff schließt einen eigenen Zyklus.</translation>
    </message>
    <message>
        <source>You leave out the meshes: each cycle holds the mesh that closes it.</source>
        <translation>Sie lassen die Eingriffe weg: Jeder Zyklus enthält den Eingriff, der ihn schließt.</translation>
    </message>
    <message>
        <source>from link %1 to link %2</source>
        <translation>von Glied %1 zu Glied %2</translation>
    </message>
    <message>
        <source>You turn the arrow of %1 round: it points %2.</source>
        <translation>Sie drehen den Pfeil von %1 um: Er weist %2.</translation>
    </message>
    <message>
        <source>You give link %1 an end of %2, but its arrow points %3: 0.</source>
        <translation>Sie geben Glied %1 ein Ende von %2, aber dessen Pfeil weist %3: 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 ends at link %2: 1, not 0.</source>
        <translation>Der Pfeil von %1 endet an Glied %2: 1, nicht 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 begins at link %2: −1, not 0.</source>
        <translation>Der Pfeil von %1 beginnt an Glied %2: −1, nicht 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 ends at link %2: 1, not −1.</source>
        <translation>Der Pfeil von %1 endet an Glied %2: 1, nicht −1.</translation>
    </message>
    <message>
        <source>The arrow of %1 begins at link %2: −1, not 1.</source>
        <translation>Der Pfeil von %1 beginnt an Glied %2: −1, nicht 1.</translation>
    </message>
    <message>
        <source>You exchange + and −: a column holds −1 where the arrow begins and 1 where it ends.</source>
        <translation>Sie vertauschen + und −: Eine Spalte enthält −1, wo der Pfeil beginnt, und 1, wo er endet.</translation>
    </message>
    <message>
        <source>You mark both ends alike: the end where the arrow begins is −1, the one where it ends 1.</source>
        <translation>Sie markieren beide Enden gleich: Das Ende, an dem der Pfeil beginnt, ist −1, das, an dem er endet, 1.</translation>
    </message>
    <message>
        <source>Fill in these columns of the incidence matrix $\Gamma^0$.</source>
        <translation>Füllen Sie diese Spalten der Inzidenzmatrix $\Gamma^0$ aus.</translation>
    </message>
    <message>
        <source>A column of Γ⁰ holds −1 in the row of the link where the arrow begins, 1 where it ends, and 0 elsewhere.</source>
        <translation>Eine Spalte von Γ⁰ enthält −1 in der Zeile des Glieds, an dem der Pfeil beginnt, 1, wo er endet, und sonst 0.</translation>
    </message>
    <message>
        <source>You leave out the ground: Γ⁰ keeps its row, only Γ has none.</source>
        <translation>Sie lassen das Gestell weg: Γ⁰ behält seine Zeile, nur Γ hat keine.</translation>
    </message>
    <message>
        <source>Fill in these columns of the reduced incidence matrix $\Gamma$. Leave a row that $\Gamma$ does not have empty.</source>
        <translation>Füllen Sie diese Spalten der reduzierten Inzidenzmatrix $\Gamma$ aus. Lassen Sie eine Zeile leer, die $\Gamma$ nicht hat.</translation>
    </message>
    <message>
        <source>Γ is Γ⁰ without the row of the ground, so that its rows are independent; all other entries stay.</source>
        <translation>Γ ist Γ⁰ ohne die Zeile des Gestells, sodass ihre Zeilen unabhängig sind; alle anderen Einträge bleiben.</translation>
    </message>
    <message>
        <source>You leave the row of the ground in: Γ has the rows of the moving links only.</source>
        <translation>Sie behalten die Zeile des Gestells: Γ hat nur die Zeilen der beweglichen Glieder.</translation>
    </message>
    <message>
        <source>You fill in the row of the ground: Γ has the rows of the moving links only.</source>
        <translation>Sie füllen die Zeile des Gestells aus: Γ hat nur die Zeilen der beweglichen Glieder.</translation>
    </message>
    <message>
        <source>The mechanism is drawn with other arrows: these are columns of its incidence matrix $\Gamma^0$. From which link to which link do they point?</source>
        <translation>Der Mechanismus ist mit anderen Pfeilen gezeichnet: Dies sind Spalten seiner Inzidenzmatrix $\Gamma^0$. Von welchem Glied zu welchem weisen sie?</translation>
    </message>
    <message>
        <source>An arrow begins at the link whose entry is −1 and ends at the link whose entry is 1.</source>
        <translation>Ein Pfeil beginnt am Glied mit dem Eintrag −1 und endet am Glied mit dem Eintrag 1.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>nach</translation>
    </message>
    <message>
        <source>You turn every arrow round: −1 is where an arrow begins, 1 where it ends.</source>
        <translation>Sie drehen jeden Pfeil um: −1 steht, wo ein Pfeil beginnt, 1, wo er endet.</translation>
    </message>
    <message>
        <source>You turn the arrow of %1 round: it begins at link %2, where the entry is −1.</source>
        <translation>Sie drehen den Pfeil von %1 um: Er beginnt an Glied %2, wo der Eintrag −1 ist.</translation>
    </message>
    <message>
        <source>The link that you name as the beginning of %1 has a 0 in column %2.</source>
        <translation>Das Glied, das Sie als Anfang von %1 nennen, hat eine 0 in Spalte %2.</translation>
    </message>
    <message>
        <source>The link that you name as the end of %1 has a 0 in column %2.</source>
        <translation>Das Glied, das Sie als Ende von %1 nennen, hat eine 0 in Spalte %2.</translation>
    </message>
    <message>
        <source>One entry of this matrix $%1$ is wrong. Find it and correct it.</source>
        <translation>Ein Eintrag dieser Matrix $%1$ ist falsch. Finden und berichtigen Sie ihn.</translation>
    </message>
    <message>
        <source>The entry in row %1, column %2 is %3, not %4.</source>
        <translation>Der Eintrag in Zeile %1, Spalte %2 ist %3, nicht %4.</translation>
    </message>
    <message>
        <source>row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>right value</source>
        <translation>richtiger Wert</translation>
    </message>
    <message>
        <source>You find the wrong entry, but its right value is another one.</source>
        <translation>Sie finden den falschen Eintrag, aber sein richtiger Wert ist ein anderer.</translation>
    </message>
    <message>
        <source>The wrong entry is in this row, but the entry that you name is right.</source>
        <translation>Der falsche Eintrag steht in dieser Zeile, aber der genannte Eintrag ist richtig.</translation>
    </message>
    <message>
        <source>The wrong entry is in this column, but the entry that you name is right.</source>
        <translation>Der falsche Eintrag steht in dieser Spalte, aber der genannte Eintrag ist richtig.</translation>
    </message>
    <message>
        <source>The entry that you name is right: follow the arrows of its row and column once more.</source>
        <translation>Der genannte Eintrag ist richtig: Folgen Sie den Pfeilen seiner Zeile und Spalte noch einmal.</translation>
    </message>
    <message>
        <source>Take one column at a time. Its arrow touches two links only: the one that it leaves gets −1, the one that it points to gets 1.</source>
        <translation>Nehmen Sie eine Spalte nach der anderen. Ihr Pfeil berührt nur zwei Glieder: Das, von dem er ausgeht, bekommt −1, das, auf das er weist, 1.</translation>
    </message>
    <message>
        <source>Read the matrix, not the drawing, one column at a time: the arrow leaves the link whose entry is −1 and points to the link whose entry is 1.</source>
        <translation>Lesen Sie die Matrix, nicht die Zeichnung, Spalte für Spalte: Der Pfeil geht vom Glied mit dem Eintrag −1 aus und weist auf das Glied mit dem Eintrag 1.</translation>
    </message>
    <message>
        <source>All speeds are measured against one link: Γ leaves out its row. The other rows are those of Γ⁰.</source>
        <translation>Alle Drehzahlen werden gegenüber einem Glied gemessen: Γ lässt dessen Zeile weg. Die übrigen Zeilen sind die von Γ⁰.</translation>
    </message>
    <message>
        <source>Start at the link of the column and walk to the ground along turning joints only. Then compare the arrow of each joint on the walk with your direction.</source>
        <translation>Beginnen Sie am Glied der Spalte und gehen Sie nur entlang von Drehgelenken zum Gestell. Vergleichen Sie dann den Pfeil jedes Gelenks auf dem Weg mit Ihrer Richtung.</translation>
    </message>
    <message>
        <source>Keep the turning joints and only the mesh of the row: together they close one cycle. Begin along the mesh, from tail to head, and compare each arrow on the way back with your direction.</source>
        <translation>Behalten Sie die Drehgelenke und nur den Eingriff der Zeile: Zusammen schließen sie einen Zyklus. Beginnen Sie entlang des Eingriffs, vom Fuß zur Spitze, und vergleichen Sie jeden Pfeil auf dem Rückweg mit Ihrer Richtung.</translation>
    </message>
    <message>
        <source>From both links of the mesh, walk along turning joints toward the ground until the two walks meet. What they share from there on is not part of the cycle.</source>
        <translation>Gehen Sie von beiden Gliedern des Eingriffs entlang von Drehgelenken zum Gestell, bis sich beide Wege treffen. Was sie von dort an gemeinsam haben, gehört nicht zum Zyklus.</translation>
    </message>
    <message>
        <source>Choose a link of the cycle and go once round without turning back. Only the direction of each arrow against your own counts.</source>
        <translation>Wählen Sie ein Glied des Zyklus und gehen Sie einmal herum, ohne umzukehren. Nur die Richtung jedes Pfeils gegenüber Ihrer eigenen zählt.</translation>
    </message>
    <message>
        <source>Begin with the columns of the meshes: a cycle of the basis holds one mesh, its own. Then walk from the head of the mesh back to its tail along turning joints.</source>
        <translation>Beginnen Sie mit den Spalten der Eingriffe: Ein Zyklus der Basis enthält nur einen Eingriff, seinen eigenen. Gehen Sie dann von der Spitze des Eingriffs entlang von Drehgelenken zurück zu seinem Fuß.</translation>
    </message>
    <message>
        <source>Each mesh closes one cycle with the turning joints. Go round one after the other; within a row all signs belong to the same walk.</source>
        <translation>Jeder Eingriff schließt mit den Drehgelenken einen Zyklus. Gehen Sie einen nach dem anderen ab; in einer Zeile gehören alle Vorzeichen zum selben Umlauf.</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree already. With the mesh they close a loop: which edges of this loop could go?</source>
        <translation>Die Drehgelenke sind schon ein Spannbaum. Mit dem Eingriff schließen sie eine Schleife: Welche Kanten dieser Schleife könnten entfallen?</translation>
    </message>
    <message>
        <source>Derive the matrix from the drawing, row by row, and stop at the first entry that differs. Compare signs with the directions of the arrows.</source>
        <translation>Leiten Sie die Matrix Zeile für Zeile aus der Zeichnung her und halten Sie beim ersten abweichenden Eintrag an. Vergleichen Sie Vorzeichen mit den Richtungen der Pfeile.</translation>
    </message>
    <message>
        <source>Start from the cycle of the mesh: only its joints have entries. The size of an entry is the number of teeth of the gear on whose axis the joint turns.</source>
        <translation>Gehen Sie vom Zyklus des Eingriffs aus: Nur seine Gelenke haben Einträge. Der Betrag eines Eintrags ist die Zähnezahl des Rades, auf dessen Achse das Gelenk dreht.</translation>
    </message>
    <message>
        <source>Each mesh gives one equation. Count those that do not follow from the others, and subtract their number from that of the turning joints.</source>
        <translation>Jeder Eingriff liefert eine Gleichung. Zählen Sie die, die nicht aus den anderen folgen, und ziehen Sie ihre Anzahl von der der Drehgelenke ab.</translation>
    </message>
    <message>
        <source>Look for meshes that tie the same links together in two ways. Leave one out: if the others still force the same speeds, it is redundant.</source>
        <translation>Suchen Sie Eingriffe, die dieselben Glieder auf zwei Wegen verbinden. Lassen Sie einen weg: Erzwingen die anderen dieselben Drehzahlen, ist er redundant.</translation>
    </message>
    <message>
        <source>Take as many joints as there are degrees of freedom. Imagine all of them locked: nothing else may move, and no mesh may tie two of them to each other.</source>
        <translation>Nehmen Sie so viele Gelenke, wie es Freiheitsgrade gibt. Denken Sie sich alle gesperrt: Dann darf sich nichts mehr bewegen, und kein Eingriff darf zwei von ihnen aneinander binden.</translation>
    </message>
    <message>
        <source>Look for a mesh whose equation has one unknown speed only, solve it, and go on to the next. A row of P θ̇ = 0 holds the joints of one cycle.</source>
        <translation>Suchen Sie einen Eingriff, dessen Gleichung nur eine unbekannte Drehzahl hat, lösen Sie sie und gehen Sie zum nächsten. Eine Zeile von P θ̇ = 0 enthält die Gelenke eines Zyklus.</translation>
    </message>
    <message>
        <source>The level of a joint is the letter of its axis. Name the axis of each joint on the walk: where the letter changes is the transfer vertex.</source>
        <translation>Die Ebene eines Gelenks ist der Buchstabe seiner Achse. Nennen Sie die Achse jedes Gelenks auf dem Weg: Wo der Buchstabe wechselt, ist der Transferknoten.</translation>
    </message>
    <message>
        <source>The carrier is the link where the level changes on the way between both gears. The gear with fewer teeth turns faster; for the sign, look at each gear along its own axis.</source>
        <translation>Der Steg ist das Glied, an dem auf dem Weg zwischen beiden Rädern die Ebene wechselt. Das Rad mit weniger Zähnen dreht schneller; für das Vorzeichen betrachten Sie jedes Rad entlang seiner eigenen Achse.</translation>
    </message>
    <message>
        <source>Walk from the carrier to the gear along turning joints: only these joints count. Compare their arrows with your direction.</source>
        <translation>Gehen Sie vom Steg entlang von Drehgelenken zum Rad: Nur diese Gelenke zählen. Vergleichen Sie ihre Pfeile mit Ihrer Richtung.</translation>
    </message>
    <message>
        <source>Without the joint the turning joints fall into two groups of links. Look for edges with one end in each group, and compare their direction with that of the joint.</source>
        <translation>Ohne das Gelenk zerfallen die Drehgelenke in zwei Gruppen von Gliedern. Suchen Sie Kanten mit je einem Ende in beiden Gruppen und vergleichen Sie ihre Richtung mit der des Gelenks.</translation>
    </message>
    <message>
        <source>Write the power of each port, torque times speed. Their sum is zero if no power is lost; then put in the terminal equation.</source>
        <translation>Schreiben Sie die Leistung jedes Tors auf, Moment mal Drehzahl. Geht keine Leistung verloren, ist ihre Summe null; setzen Sie dann die Klemmengleichung ein.</translation>
    </message>
    <message>
        <source>Reduce the fraction. Then multiply both of its parts by the same whole number until both are within the bounds.</source>
        <translation>Kürzen Sie den Bruch. Erweitern Sie dann Zähler und Nenner mit derselben ganzen Zahl, bis beide innerhalb der Grenzen liegen.</translation>
    </message>
    <message>
        <source>The centre distance goes with the sum of the teeth where both gears are external, and with their difference where one is a ring.</source>
        <translation>Der Achsabstand richtet sich nach der Summe der Zähne, wenn beide Räder außen verzahnt sind, und nach ihrer Differenz, wenn eines ein Hohlrad ist.</translation>
    </message>
    <message>
        <source>Each engaged element takes degrees of freedom away until one is left. An engaged brake makes the speed of its link zero: try which set gives the ratio.</source>
        <translation>Jedes geschlossene Element nimmt Freiheitsgrade weg, bis einer bleibt. Eine geschlossene Bremse macht die Drehzahl ihres Glieds zu null: Probieren Sie, welche Auswahl die Übersetzung ergibt.</translation>
    </message>
    <message>
        <source>The torques of all shafts and brakes of the train add up to zero, and so do their powers. Write both sums for what is engaged, then compare the sizes.</source>
        <translation>Die Momente aller Wellen und Bremsen des Getriebes ergeben zusammen null, ebenso ihre Leistungen. Schreiben Sie beide Summen für das Geschlossene auf und vergleichen Sie dann die Beträge.</translation>
    </message>
    <message>
        <source>Let the load drive: behind each mesh less power arrives, by its efficiency. If none would be left at the input, or it would have to be driven, the train locks.</source>
        <translation>Lassen Sie die Last antreiben: Hinter jedem Eingriff kommt um seinen Wirkungsgrad weniger Leistung an. Bliebe am Antrieb keine übrig oder müsste er angetrieben werden, sperrt das Getriebe.</translation>
    </message>
    <message>
        <source>The torques of drive, load and brake on the train add up to zero, and a brake passes no power. What acts on a link acts on the other part in the opposite sense.</source>
        <translation>Die Drehmomente von Antrieb, Last und Bremse auf das Getriebe ergeben zusammen null, und eine Bremse überträgt keine Leistung. Was auf ein Glied wirkt, wirkt auf das andere Teil im entgegengesetzten Sinn.</translation>
    </message>
    <message>
        <source>no joints</source>
        <translation>keine Gelenke</translation>
    </message>
    <message>
        <source>the turning joints are no spanning tree</source>
        <translation>die Drehgelenke sind kein Spannbaum</translation>
    </message>
    <message>
        <source>no meshes</source>
        <translation>keine Eingriffe</translation>
    </message>
    <message>
        <source>a mesh has no geometry</source>
        <translation>ein Eingriff hat keine Geometrie</translation>
    </message>
    <message>
        <source>too many cycles</source>
        <translation>zu viele Zyklen</translation>
    </message>
    <message>
        <source>too many edges</source>
        <translation>zu viele Kanten</translation>
    </message>
    <message>
        <source>the matrices are too large or too small</source>
        <translation>die Matrizen sind zu groß oder zu klein</translation>
    </message>
    <message>
        <source>no mesh is redundant</source>
        <translation>kein Eingriff ist redundant</translation>
    </message>
    <message>
        <source>nothing can move</source>
        <translation>nichts kann sich bewegen</translation>
    </message>
    <message>
        <source>too many inputs</source>
        <translation>zu viele Antriebe</translation>
    </message>
    <message>
        <source>no speed follows from the inputs</source>
        <translation>keine Drehzahl folgt aus den Antrieben</translation>
    </message>
    <message>
        <source>no planet between a sun and a ring</source>
        <translation>kein Planet zwischen einer Sonne und einem Hohlrad</translation>
    </message>
    <message>
        <source>no brakes or clutches</source>
        <translation>keine Bremsen oder Kupplungen</translation>
    </message>
    <message>
        <source>no states with a ratio</source>
        <translation>keine Schaltzustände mit einer Übersetzung</translation>
    </message>
    <message>
        <source>no two torques of brakes or clutches to compare</source>
        <translation>keine zwei Momente von Bremsen oder Kupplungen zum Vergleichen</translation>
    </message>
    <message>
        <source>no brake that carries a torque about the drive&apos;s axis</source>
        <translation>keine Bremse, die ein Drehmoment um die Achse des Antriebs aufnimmt</translation>
    </message>
    <message>
        <source>no drive passes power through 1 to 6 meshes</source>
        <translation>kein Antrieb leitet Leistung durch 1 bis 6 Eingriffe</translation>
    </message>
    <message>
        <source>Fill in Γ⁰</source>
        <translation>Γ⁰ ausfüllen</translation>
    </message>
    <message>
        <source>Orient the digraph</source>
        <translation>Den Digraphen orientieren</translation>
    </message>
    <message>
        <source>Fill in Γ</source>
        <translation>Γ ausfüllen</translation>
    </message>
    <message>
        <source>Fill in Z</source>
        <translation>Z ausfüllen</translation>
    </message>
    <message>
        <source>Fill in T</source>
        <translation>T ausfüllen</translation>
    </message>
    <message>
        <source>Find the cycle of a mesh</source>
        <translation>Den Zyklus eines Eingriffs finden</translation>
    </message>
    <message>
        <source>Walk a cycle in either sense</source>
        <translation>Einen Zyklus in beliebigem Sinn umlaufen</translation>
    </message>
    <message>
        <source>Fill in a row of C</source>
        <translation>Eine Zeile von C ausfüllen</translation>
    </message>
    <message>
        <source>Write all cycles</source>
        <translation>Alle Zyklen aufschreiben</translation>
    </message>
    <message>
        <source>Choose a spanning tree</source>
        <translation>Einen Spannbaum wählen</translation>
    </message>
    <message>
        <source>Find the wrong entry</source>
        <translation>Den falschen Eintrag finden</translation>
    </message>
    <message>
        <source>Fill in a row of P</source>
        <translation>Eine Zeile von P ausfüllen</translation>
    </message>
    <message>
        <source>Rank and DOF</source>
        <translation>Rang und Freiheitsgrad</translation>
    </message>
    <message>
        <source>Redundant mesh</source>
        <translation>Redundanter Eingriff</translation>
    </message>
    <message>
        <source>Valid inputs</source>
        <translation>Gültige Antriebe</translation>
    </message>
    <message>
        <source>Predict a speed</source>
        <translation>Eine Drehzahl vorhersagen</translation>
    </message>
    <message>
        <source>Levels and transfer vertex</source>
        <translation>Ebenen und Transferknoten</translation>
    </message>
    <message>
        <source>Terminal equation, sign</source>
        <translation>Klemmengleichung, Vorzeichen</translation>
    </message>
    <message>
        <source>f-circuit equation</source>
        <translation>f-Kreis-Gleichung</translation>
    </message>
    <message>
        <source>Fill in a row of Q</source>
        <translation>Eine Zeile von Q ausfüllen</translation>
    </message>
    <message>
        <source>Torque of a port, sign</source>
        <translation>Moment eines Tors, Vorzeichen</translation>
    </message>
    <message>
        <source>Teeth for a ratio</source>
        <translation>Zähnezahlen für eine Übersetzung</translation>
    </message>
    <message>
        <source>Teeth of the ring</source>
        <translation>Zähnezahl des Hohlrads</translation>
    </message>
    <message>
        <source>Brakes for a gear</source>
        <translation>Bremsen für einen Gang</translation>
    </message>
    <message>
        <source>Largest torque of a brake</source>
        <translation>Größtes Moment einer Bremse</translation>
    </message>
    <message>
        <source>Self-locking</source>
        <translation>Selbsthemmung</translation>
    </message>
    <message>
        <source>Reaction of a brake, sense</source>
        <translation>Reaktion einer Bremse, Sinn</translation>
    </message>
    <message>
        <source>one cycle</source>
        <translation>ein Zyklus</translation>
    </message>
    <message>
        <source>%1 cycles</source>
        <translation>%1 Zyklen</translation>
    </message>
    <message>
        <source>one input</source>
        <translation>ein Antrieb</translation>
    </message>
    <message>
        <source>%1 inputs</source>
        <translation>%1 Antriebe</translation>
    </message>
    <message>
        <source>%1 redundant</source>
        <translation>%1 redundant</translation>
    </message>
    <message>
        <source>%1 states</source>
        <translation>%1 Schaltzustände</translation>
    </message>
    <message>
        <source>easy: %1</source>
        <translation>leicht: %1</translation>
    </message>
    <message>
        <source>medium: %1</source>
        <translation>mittel: %1</translation>
    </message>
    <message>
        <source>hard: %1</source>
        <translation>schwer: %1</translation>
    </message>
    <message>
        <source>What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the mechanism have with every brake and clutch released?</source>
        <translation>Welchen Rang $r$ hat die Koeffizientenmatrix $P$, und wie viele Freiheitsgrade $E$ hat der Mechanismus, wenn alle Bremsen und Kupplungen gelöst sind?</translation>
    </message>
    <message>
        <source>What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the mechanism have?</source>
        <translation>Welchen Rang $r$ hat die Koeffizientenmatrix $P$, und wie viele Freiheitsgrade $E$ hat der Mechanismus?</translation>
    </message>
    <message>
        <source>Of the %1 rows of P, %2 are independent: %3</source>
        <translation>Von den %1 Zeilen von P sind %2 unabhängig: %3</translation>
    </message>
    <message>
        <source>All %1 rows of P are independent: %2</source>
        <translation>Alle %1 Zeilen von P sind unabhängig: %2</translation>
    </message>
    <message>
        <source>You count every mesh as a constraint: one mesh follows from the others, so that r is %1.</source>
        <translation>Sie zählen jeden Eingriff als Bindung: Ein Eingriff folgt aus den anderen, sodass r = %1 ist.</translation>
    </message>
    <message>
        <source>You count every mesh as a constraint: %1 meshes follow from the others, so that r is %2.</source>
        <translation>Sie zählen jeden Eingriff als Bindung: %1 Eingriffe folgen aus den anderen, sodass r = %2 ist.</translation>
    </message>
    <message>
        <source>The rank is not the number of meshes: one mesh follows from the others.</source>
        <translation>Der Rang ist nicht die Anzahl der Eingriffe: Ein Eingriff folgt aus den anderen.</translation>
    </message>
    <message>
        <source>The rank is not the number of meshes: %1 meshes follow from the others.</source>
        <translation>Der Rang ist nicht die Anzahl der Eingriffe: %1 Eingriffe folgen aus den anderen.</translation>
    </message>
    <message>
        <source>You exchange both numbers: r counts equations, E = t − r is left.</source>
        <translation>Sie vertauschen beide Zahlen: r zählt Gleichungen, E = t − r bleibt übrig.</translation>
    </message>
    <message>
        <source>You count the ground among the moving links: it has no turning joint of its own.</source>
        <translation>Sie zählen das Gestell zu den beweglichen Gliedern: Es hat kein eigenes Drehgelenk.</translation>
    </message>
    <message>
        <source>You take two degrees of freedom for each mesh: its gears roll and slide, so that it takes one.</source>
        <translation>Sie ziehen für jeden Eingriff zwei Freiheitsgrade ab: Seine Räder wälzen und gleiten, sodass er nur einen nimmt.</translation>
    </message>
    <message>
        <source>You count the freedoms of the turning joints only: each independent mesh takes one of them.</source>
        <translation>Sie zählen nur die Freiheiten der Drehgelenke: Jeder unabhängige Eingriff nimmt eine davon.</translation>
    </message>
    <message>
        <source>The rank is right, but E = t − r = %1 − %2.</source>
        <translation>Der Rang ist richtig, aber E = t − r = %1 − %2.</translation>
    </message>
    <message>
        <source>Choose a valid set of inputs: turning joints whose speeds determine the whole motion.</source>
        <translation>Wählen Sie eine gültige Menge von Antrieben: Drehgelenke, deren Drehzahlen die ganze Bewegung bestimmen.</translation>
    </message>
    <message>
        <source>A valid set has one joint, whose speed can be chosen freely and determines all others.</source>
        <translation>Eine gültige Menge hat ein Gelenk, dessen Drehzahl frei wählbar ist und alle anderen bestimmt.</translation>
    </message>
    <message>
        <source>A valid set has %1 joints whose speeds can be chosen freely and determine all others.</source>
        <translation>Eine gültige Menge hat %1 Gelenke, deren Drehzahlen frei wählbar sind und alle anderen bestimmen.</translation>
    </message>
    <message>
        <source>Joint %1 can never turn, so that it cannot be driven.</source>
        <translation>Gelenk %1 kann sich nie drehen, also nicht angetrieben werden.</translation>
    </message>
    <message>
        <source>With one degree of freedom the other joints you name follow from one of them.</source>
        <translation>Bei einem Freiheitsgrad folgen die übrigen genannten Gelenke aus einem von ihnen.</translation>
    </message>
    <message>
        <source>With %1 degrees of freedom the other joints you name follow from %1 of them.</source>
        <translation>Bei %1 Freiheitsgraden folgen die übrigen genannten Gelenke aus %1 von ihnen.</translation>
    </message>
    <message>
        <source>Joint %1 is on no cycle, so that only an input can determine its speed.</source>
        <translation>Gelenk %1 liegt auf keinem Zyklus, sodass nur ein Antrieb seine Drehzahl bestimmen kann.</translation>
    </message>
    <message>
        <source>Joint %1 always turns at %2 times the speed of joint %3: only one of them can be chosen.</source>
        <translation>Gelenk %1 dreht sich immer mit dem %2-Fachen der Drehzahl von Gelenk %3: Nur eines von beiden kann gewählt werden.</translation>
    </message>
    <message>
        <source>The speeds of these joints depend on each other, so that some other joint stays free.</source>
        <translation>Die Drehzahlen dieser Gelenke hängen voneinander ab, sodass ein anderes Gelenk frei bleibt.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom: your inputs leave a motion open.</source>
        <translation>Der Mechanismus hat %1 Freiheitsgrade: Ihre Antriebe lassen eine Bewegung offen.</translation>
    </message>
    <message>
        <source>How many meshes are redundant, and which mesh could be left out without another motion? Name one of them.</source>
        <translation>Wie viele Eingriffe sind redundant, und welcher Eingriff könnte ohne Änderung der Bewegung entfallen? Nennen Sie einen.</translation>
    </message>
    <message>
        <source>The rank is %1 with %2 meshes, so that one is redundant; each of %3 follows from others.</source>
        <translation>Der Rang ist %1 bei %2 Eingriffen, sodass einer redundant ist; jeder von %3 folgt aus anderen.</translation>
    </message>
    <message>
        <source>The rank is %1 with %2 meshes, so that %3 are redundant; each of %4 follows from others.</source>
        <translation>Der Rang ist %1 bei %2 Eingriffen, sodass %3 redundant sind; jeder von %4 folgt aus anderen.</translation>
    </message>
    <message>
        <source>redundant meshes</source>
        <translation>redundante Eingriffe</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>einer davon</translation>
    </message>
    <message>
        <source>The rows of P are not independent: their rank is %1, fewer than %2 meshes.</source>
        <translation>Die Zeilen von P sind nicht unabhängig: Ihr Rang ist %1, weniger als %2 Eingriffe.</translation>
    </message>
    <message>
        <source>There are as many redundant meshes as rows of P beyond its rank: %1 − %2.</source>
        <translation>Es gibt so viele redundante Eingriffe, wie P Zeilen über seinen Rang hinaus hat: %1 − %2.</translation>
    </message>
    <message>
        <source>Without mesh %1 the mechanism would gain a degree of freedom: it follows from no others.</source>
        <translation>Ohne Eingriff %1 gewänne der Mechanismus einen Freiheitsgrad: Er folgt aus keinen anderen.</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>dreht sich</translation>
    </message>
    <message>
        <source>Of the power that it takes, seen from its carrier, each mesh passes the part $%1$; nothing else loses power. Now %2 drives backwards and %3 takes the power. Does the train turn, or does it lock itself? With which efficiency does it pass the power (0 where it locks itself)? A fraction or a decimal of three digits will do.</source>
        <translation>Von der Leistung, die er, vom Steg aus gesehen, aufnimmt, gibt jeder Eingriff den Teil $%1$ weiter; sonst geht keine Leistung verloren. Nun treibt %2 rückwärts an, und %3 nimmt die Leistung ab. Dreht sich das Getriebe, oder sperrt es sich selbst? Mit welchem Wirkungsgrad gibt es die Leistung weiter (0, wenn es sich selbst sperrt)? Ein Bruch oder eine Dezimalzahl mit drei Ziffern genügt.</translation>
    </message>
    <message>
        <source>driven backwards it</source>
        <translation>rückwärts angetrieben</translation>
    </message>
    <message>
        <source>efficiency backwards</source>
        <translation>Wirkungsgrad rückwärts</translation>
    </message>
    <message>
        <source>joint $%1$</source>
        <translation>Gelenk $%1$</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2.</source>
        <translation>Ein Motor in %1 treibt eine Last an %2 an.</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2, with joint %3 held.</source>
        <translation>Ein Motor in %1 treibt eine Last an %2 an, wobei Gelenk %3 gehalten wird.</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2, with joints %3 held.</source>
        <translation>Ein Motor in %1 treibt eine Last an %2 an, wobei die Gelenke %3 gehalten werden.</translation>
    </message>
    <message>
        <source>link $%1$</source>
        <translation>Glied $%1$</translation>
    </message>
    <message>
        <source>In state “%1”, with %2 engaged, %3 drives a load on %4.</source>
        <translation>In Schaltzustand „%1“, mit %2 geschlossen, treibt %3 eine Last an %4 an.</translation>
    </message>
    <message>
        <source>the mesh passes %1 W for each watt that is fed, seen from its carrier</source>
        <translation>leitet der Eingriff, vom Steg aus gesehen, %1 W je zugeführtem Watt</translation>
    </message>
    <message>
        <source>the meshes pass %1 W for each watt that is fed, seen from their carriers</source>
        <translation>leiten die Eingriffe, von ihren Stegen aus gesehen, %1 W je zugeführtem Watt</translation>
    </message>
    <message>
        <source>gear %1 drives in mesh %2</source>
        <translation>Rad %1 treibt in Eingriff %2</translation>
    </message>
    <message>
        <source>Driven backwards, %1: of each watt that is fed %2 W arrive, so that the train turns.</source>
        <translation>Rückwärts angetrieben gilt: %1. Von jedem zugeführten Watt kommen %2 W an, sodass sich das Getriebe dreht.</translation>
    </message>
    <message>
        <source>Without losses %1, and each loses %2 of what it takes: with these losses no load, however large, turns the drive: the train locks itself.</source>
        <translation>Ohne Verluste %1, und jeder Eingriff verliert %2 dessen, was er aufnimmt: Mit diesen Verlusten dreht keine noch so große Last den Antrieb: Das Getriebe sperrt sich selbst.</translation>
    </message>
    <message>
        <source>Backwards it passes %1.</source>
        <translation>Rückwärts leitet es %1 weiter.</translation>
    </message>
    <message>
        <source>Your efficiency is upside down: it is the power taken over the power fed, less than 1.</source>
        <translation>Ihr Wirkungsgrad steht verkehrt herum: Er ist die abgenommene durch die zugeführte Leistung, kleiner als 1.</translation>
    </message>
    <message>
        <source>It does not lock itself: the losses are less than the power fed, and %1 of the power arrives when it is driven backwards.</source>
        <translation>Es sperrt sich nicht selbst: Die Verluste sind kleiner als die zugeführte Leistung, und %1 der Leistung kommt bei Rückwärtsantrieb an.</translation>
    </message>
    <message>
        <source>Backwards it locks itself.</source>
        <translation>Rückwärts sperrt es sich selbst.</translation>
    </message>
    <message>
        <source>It locks itself: %1, and with these losses no load, however large, turns the drive.</source>
        <translation>Es sperrt sich selbst: Ohne Verluste %1, und mit den Verlusten dreht keine noch so große Last den Antrieb.</translation>
    </message>
    <message>
        <source>It locks itself, right; but then no power passes: the efficiency is 0.</source>
        <translation>Es sperrt sich selbst, richtig; dann aber fließt keine Leistung: Der Wirkungsgrad ist 0.</translation>
    </message>
    <message>
        <source>This is the efficiency with the motor driving: backwards the other gears drive.</source>
        <translation>Das ist der Wirkungsgrad bei antreibendem Motor: Rückwärts treiben die anderen Räder.</translation>
    </message>
    <message>
        <source>You leave out the losses of the meshes.</source>
        <translation>Sie lassen die Verluste der Eingriffe weg.</translation>
    </message>
    <message>
        <source>You multiply the efficiencies of the meshes as in a train of fixed axes: seen from its carrier a mesh passes another power.</source>
        <translation>Sie multiplizieren die Wirkungsgrade der Eingriffe wie bei einem Standgetriebe: Vom Steg aus gesehen leitet ein Eingriff eine andere Leistung.</translation>
    </message>
    <message>
        <source>The entries of this matrix are −1, 0 and 1 only: they tell senses, not sizes.</source>
        <translation>Die Einträge dieser Matrix sind nur −1, 0 und 1: Sie geben Richtungen an, keine Beträge.</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>Eingriff %1</translation>
    </message>
    <message>
        <source>as the drive&apos;s torque</source>
        <translation>im Sinn des Antriebsmoments</translation>
    </message>
    <message>
        <source>against the drive&apos;s torque</source>
        <translation>gegen das Antriebsmoment</translation>
    </message>
    <message>
        <source>State “%1” engages %2, link $%3$ drives and link $%4$ bears the load. The torque of the drive is $%5$ N m, and no power is lost. What torque, with its sign, does brake %6 exert on link $%7$? And in which sense does it try to turn the housing? A fraction or a decimal of three digits will do.</source>
        <translation>Zustand „%1“ schließt %2, Glied $%3$ treibt an und Glied $%4$ trägt die Last. Das Antriebsmoment beträgt $%5$ N m, und keine Leistung geht verloren. Welches Drehmoment, mit Vorzeichen, übt Bremse %6 auf Glied $%7$ aus? Und in welchem Sinn will sie das Gehäuse drehen? Ein Bruch oder eine Dezimalzahl mit drei Ziffern genügt.</translation>
    </message>
    <message>
        <source>torque on link %1 in N m</source>
        <translation>Drehmoment auf Glied %1 in N m</translation>
    </message>
    <message>
        <source>turns the housing</source>
        <translation>dreht das Gehäuse</translation>
    </message>
    <message>
        <source>Brake %1 holds link %2 with %3 N m; the housing has the opposite, %4 N m.</source>
        <translation>Bremse %1 hält Glied %2 mit %3 N m; das Gehäuse erhält das Entgegengesetzte, %4 N m.</translation>
    </message>
    <message>
        <source>This is what the housing feels: on link %1 the brake acts with %2 N m.</source>
        <translation>Das spürt das Gehäuse: Auf Glied %1 wirkt die Bremse mit %2 N m.</translation>
    </message>
    <message>
        <source>A sign is lost: %1 N m of the drive, %2 N m that hold the load and the torque of the brake add up to 0.</source>
        <translation>Ein Vorzeichen ging verloren: %1 N m des Antriebs, %2 N m, die die Last halten, und das Drehmoment der Bremse ergeben zusammen 0.</translation>
    </message>
    <message>
        <source>You use the ratio upside down: with the ratio %1 the load is held by %2 N m.</source>
        <translation>Sie verwenden die Übersetzung verkehrt herum: Mit der Übersetzung %1 wird die Last von %2 N m gehalten.</translation>
    </message>
    <message>
        <source>This is the torque at the load on link %1: the brake has to keep the balance of drive and load.</source>
        <translation>Das ist das Drehmoment an der Last auf Glied %1: Die Bremse muss Antrieb und Last im Gleichgewicht halten.</translation>
    </message>
    <message>
        <source>This is the torque of the drive: the brake does not carry it as it is.</source>
        <translation>Das ist das Drehmoment des Antriebs: Die Bremse nimmt es nicht unverändert auf.</translation>
    </message>
    <message>
        <source>Link %1 and the housing are turned in opposite senses by the brake: link %1 has %2 N m, the housing %3 N m.</source>
        <translation>Glied %1 und das Gehäuse werden von der Bremse in entgegengesetztem Sinn gedreht: Glied %1 hat %2 N m, das Gehäuse %3 N m.</translation>
    </message>
    <message>
        <source>The inputs turn at %1 rad/s. What is $\dot{\theta}_{%2}$ in rad/s? A fraction or a decimal of three digits will do.</source>
        <translation>Die Antriebe drehen sich mit %1 rad/s. Wie groß ist $\dot{\theta}_{%2}$ in rad/s? Ein Bruch oder eine Dezimalzahl mit drei Ziffern genügt.</translation>
    </message>
    <message>
        <source>The meshes in the chain give joint %1 the rate %2 rad/s.</source>
        <translation>Die Eingriffe der Kette geben Gelenk %1 die Drehzahl %2 rad/s.</translation>
    </message>
    <message>
        <source>speed of joint %1</source>
        <translation>Drehzahl von Gelenk %1</translation>
    </message>
    <message>
        <source>The size is right, but the joint turns the other way.</source>
        <translation>Der Betrag ist richtig, aber das Gelenk dreht sich andersherum.</translation>
    </message>
    <message>
        <source>You leave out input %1: the contributions of all inputs add up.</source>
        <translation>Sie lassen Antrieb %1 weg: Die Beiträge aller Antriebe addieren sich.</translation>
    </message>
    <message>
        <source>You multiply by the whole ratio where you have to divide by it: %1 turns at %2 rad/s.</source>
        <translation>Sie multiplizieren mit der ganzen Übersetzung, wo Sie dividieren müssen: %1 dreht sich mit %2 rad/s.</translation>
    </message>
    <message>
        <source>You use the ratio of mesh %1 upside down.</source>
        <translation>Sie verwenden die Übersetzung von Eingriff %1 verkehrt herum.</translation>
    </message>
    <message>
        <source>The sign of mesh %1 is the opposite in your chain.</source>
        <translation>Das Vorzeichen von Eingriff %1 ist in Ihrer Kette umgekehrt.</translation>
    </message>
    <message>
        <source>You use speeds relative to the ground in the meshes: a mesh relates the speeds of its gears in their carrier.</source>
        <translation>Sie verwenden in den Eingriffen Drehzahlen gegenüber dem Gestell: Ein Eingriff verknüpft die Drehzahlen seiner Räder im Steg.</translation>
    </message>
    <message>
        <source>This is the speed of link %1 relative to the ground: the joint&apos;s rate is relative to the link that carries it.</source>
        <translation>Das ist die Drehzahl von Glied %1 gegenüber dem Gestell: Die des Gelenks gilt gegenüber dem Glied, das es trägt.</translation>
    </message>
    <message>
        <source>Which brakes and clutches have to be engaged for state “%1”, in which link $%2$ turns at $%3$ times the speed of link $%4$?</source>
        <translation>Welche Bremsen und Kupplungen müssen für Schaltzustand „%1“ geschlossen sein, in dem Glied $%2$ mit dem $%3$-Fachen der Drehzahl von Glied $%4$ dreht?</translation>
    </message>
    <message>
        <source>With %1 engaged one degree of freedom is left and the ratio is %2.</source>
        <translation>Mit %1 geschlossen bleibt ein Freiheitsgrad, und die Übersetzung ist %2.</translation>
    </message>
    <message>
        <source>engaged</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>These couplings engage state “%1”, not “%2”.</source>
        <translation>Diese Schaltelemente ergeben Schaltzustand „%1“, nicht „%2“.</translation>
    </message>
    <message>
        <source>More than one degree of freedom is left: another brake or clutch has to be engaged.</source>
        <translation>Es bleibt mehr als ein Freiheitsgrad: Eine weitere Bremse oder Kupplung muss geschlossen werden.</translation>
    </message>
    <message>
        <source>These couplings together lock the drive.</source>
        <translation>Diese Schaltelemente sperren zusammen den Antrieb.</translation>
    </message>
    <message>
        <source>The drive turns with these couplings, but its ratio is not %1.</source>
        <translation>Der Antrieb dreht sich mit diesen Schaltelementen, aber die Übersetzung ist nicht %1.</translation>
    </message>
    <message>
        <source>The terminal equation of mesh $%1$ is $\omega_{%2} = %3 \, \omega_{%4}$. No power is lost. Write the torque of the second port in terms of the first one&apos;s: the factor $f$ with its sign.</source>
        <translation>Die Klemmengleichung von Eingriff $%1$ lautet $\omega_{%2} = %3 \, \omega_{%4}$. Es geht keine Leistung verloren. Schreiben Sie das Moment des zweiten Tors durch das des ersten: den Faktor $f$ mit seinem Vorzeichen.</translation>
    </message>
    <message>
        <source>The powers of both ports add up to 0, so that the torques have the inverse ratio of the speeds with the opposite sign: f = %1.</source>
        <translation>Die Leistungen beider Tore ergeben zusammen 0, sodass die Momente das umgekehrte Verhältnis der Drehzahlen mit entgegengesetztem Vorzeichen haben: f = %1.</translation>
    </message>
    <message>
        <source>The ratio is right, but the sign is not: what one port takes in the other gives off.</source>
        <translation>Das Verhältnis ist richtig, das Vorzeichen nicht: Was ein Tor aufnimmt, gibt das andere ab.</translation>
    </message>
    <message>
        <source>You use the relation of the speeds: torques have the inverse ratio and the opposite sign.</source>
        <translation>Sie verwenden die Beziehung der Drehzahlen: Momente haben das umgekehrte Verhältnis und das entgegengesetzte Vorzeichen.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: the gear that turns more slowly has the larger torque.</source>
        <translation>Ihr Verhältnis steht verkehrt herum: Das langsamer drehende Rad hat das größere Moment.</translation>
    </message>
    <message>
        <source>Choose numbers of teeth between $%1$ and $%2$ for mesh $%3$ so that $i_{%3} = \frac{N_{%4}}{N_{%5}} = %6$.</source>
        <translation>Wählen Sie Zähnezahlen zwischen $%1$ und $%2$ für Eingriff $%3$, sodass $i_{%3} = \frac{N_{%4}}{N_{%5}} = %6$ gilt.</translation>
    </message>
    <message>
        <source>N%1 : N%2 = %3 : %4, for example %5 and %6 teeth.</source>
        <translation>N%1 : N%2 = %3 : %4, zum Beispiel %5 und %6 Zähne.</translation>
    </message>
    <message>
        <source>A number of teeth is a whole number between %1 and %2 here.</source>
        <translation>Eine Zähnezahl ist hier eine ganze Zahl zwischen %1 und %2.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: it is %1, not %2.</source>
        <translation>Ihr Verhältnis steht verkehrt herum: Es ist %1, nicht %2.</translation>
    </message>
    <message>
        <source>The quotient of your numbers is not %1.</source>
        <translation>Der Quotient Ihrer Zahlen ist nicht %1.</translation>
    </message>
    <message>
        <source>Let link $%1$ have $%2$ teeth and the planet $%3$ in mesh $%4$ and $%5$ in mesh $%6$, all of one module and without profile shift.</source>
        <translation>Glied $%1$ habe $%2$ Zähne und der Planet $%3$ in Eingriff $%4$ und $%5$ in Eingriff $%6$, alle mit demselben Modul und ohne Profilverschiebung.</translation>
    </message>
    <message>
        <source>Let link $%1$ have $%2$ teeth and the planet $%3$, all of one module and without profile shift.</source>
        <translation>Glied $%1$ habe $%2$ Zähne und der Planet $%3$, alle mit demselben Modul und ohne Profilverschiebung.</translation>
    </message>
    <message>
        <source>Planet $%1$ is in external mesh $%2$ with link $%3$ and in internal mesh $%4$ with ring $%5$. %6 How many teeth must the ring have, so that both centre distances are equal?</source>
        <translation>Planet $%1$ steht in Außeneingriff $%2$ mit Glied $%3$ und in Inneneingriff $%4$ mit Hohlrad $%5$. %6 Wie viele Zähne muss das Hohlrad haben, damit beide Achsabstände gleich sind?</translation>
    </message>
    <message>
        <source>The centre distance is half the sum of an external pair and half the difference of an internal one: %1 + %2 = N − %3, so that N = %4.</source>
        <translation>Der Achsabstand ist die halbe Summe eines Außenpaars und die halbe Differenz eines Innenpaars: %1 + %2 = N − %3, also N = %4.</translation>
    </message>
    <message>
        <source>teeth of the ring</source>
        <translation>Zähne des Hohlrads</translation>
    </message>
    <message>
        <source>You add the teeth of the ring: the centre distance of an internal pair is half the difference.</source>
        <translation>Sie addieren die Zähne des Hohlrads: Der Achsabstand eines Innenpaars ist die halbe Differenz.</translation>
    </message>
    <message>
        <source>You count the planet once: it is between the sun and the ring on both sides.</source>
        <translation>Sie zählen den Planeten einmal: Er liegt auf beiden Seiten zwischen Sonne und Hohlrad.</translation>
    </message>
    <message>
        <source>Take meshes and turning joints alike as edges of one graph. Choose a spanning tree of it that contains mesh $%1$.</source>
        <translation>Nehmen Sie Eingriffe und Drehgelenke gleichermaßen als Kanten eines Graphen. Wählen Sie einen Spannbaum davon, der Eingriff $%1$ enthält.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges and no loop: take the mesh in and a joint of its cycle out.</source>
        <translation>Ein Spannbaum von %1 Gliedern hat %2 Kanten und keine Schleife: Nehmen Sie den Eingriff hinzu und ein Gelenk seines Zyklus heraus.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree, but mesh %1 is not in it.</source>
        <translation>Die Drehgelenke sind ein Spannbaum, aber Eingriff %1 ist nicht darin.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges: yours leaves links loose.</source>
        <translation>Ein Spannbaum von %1 Gliedern hat %2 Kanten: Ihrer lässt Glieder lose.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges: with more of them some close a loop.</source>
        <translation>Ein Spannbaum von %1 Gliedern hat %2 Kanten: Mit mehr schließen einige eine Schleife.</translation>
    </message>
    <message>
        <source>Some of your edges close a loop, so that another link is left loose.</source>
        <translation>Einige Ihrer Kanten schließen eine Schleife, sodass ein anderes Glied lose bleibt.</translation>
    </message>
    <message>
        <source>Your edges are a spanning tree, but mesh %1 is not among them.</source>
        <translation>Ihre Kanten sind ein Spannbaum, aber Eingriff %1 ist nicht dabei.</translation>
    </message>
    <message>
        <source>Link %1 is a gear of mesh %2, not its carrier: the level changes at link %3.</source>
        <translation>Glied %1 ist ein Rad von Eingriff %2, nicht sein Steg: Die Ebene wechselt an Glied %3.</translation>
    </message>
    <message>
        <source>You measure from the ground, but the level changes at link %1.</source>
        <translation>Sie messen vom Gestell aus, aber die Ebene wechselt an Glied %1.</translation>
    </message>
    <message>
        <source>Both edges of the path at link %1 are on one level: the level changes at link %2.</source>
        <translation>Beide Kanten des Wegs an Glied %1 liegen auf einer Ebene: Die Ebene wechselt an Glied %2.</translation>
    </message>
    <message>
        <source>Link %1 is not on the path between both gears: the level changes at link %2.</source>
        <translation>Glied %1 liegt nicht auf dem Weg zwischen beiden Rädern: Die Ebene wechselt an Glied %2.</translation>
    </message>
    <message>
        <source>Walk from link $%1$ through the tree branches to link $%2$, the gears of mesh $%3$. On which levels do both gears turn in their carrier, and which link is the transfer vertex?</source>
        <translation>Gehen Sie von Glied $%1$ durch die Zweige des Baums zu Glied $%2$, den Rädern von Eingriff $%3$. Auf welchen Ebenen drehen beide Räder in ihrem Steg, und welches Glied ist der Transferknoten?</translation>
    </message>
    <message>
        <source>The walk begins on level %1 and ends on level %2; the link where the level changes, %3, is the transfer vertex: the carrier of the mesh.</source>
        <translation>Der Weg beginnt auf Ebene %1 und endet auf Ebene %2; das Glied, an dem die Ebene wechselt, %3, ist der Transferknoten: der Steg des Eingriffs.</translation>
    </message>
    <message>
        <source>level of link %1</source>
        <translation>Ebene von Glied %1</translation>
    </message>
    <message>
        <source>transfer vertex</source>
        <translation>Transferknoten</translation>
    </message>
    <message>
        <source>You exchange the levels: link %1 turns on level %2, link %3 on level %4.</source>
        <translation>Sie vertauschen die Ebenen: Glied %1 dreht auf Ebene %2, Glied %3 auf Ebene %4.</translation>
    </message>
    <message>
        <source>Level %1 is that of the other gear: this one turns on level %2.</source>
        <translation>Ebene %1 ist die des anderen Rades: Dieses dreht auf Ebene %2.</translation>
    </message>
    <message>
        <source>The walk between both gears uses the levels %1 and %2 only.</source>
        <translation>Der Weg zwischen beiden Rädern benutzt nur die Ebenen %1 und %2.</translation>
    </message>
    <message>
        <source>Write the terminal equation of mesh $%1$, with $N_{%2} = %3$ and $N_{%4} = %5$ teeth: the carrier $k$, and the factor $f$ with its sign.</source>
        <translation>Schreiben Sie die Klemmengleichung von Eingriff $%1$ mit $N_{%2} = %3$ und $N_{%4} = %5$ Zähnen: den Steg $k$ und den Faktor $f$ mit seinem Vorzeichen.</translation>
    </message>
    <message>
        <source>Seen from carrier %1, the gears of mesh %2 turn the same way, each along its own axis: f = %3.</source>
        <translation>Von Steg %1 aus gesehen drehen die Räder von Eingriff %2 gleichsinnig, jedes um seine eigene Achse: f = %3.</translation>
    </message>
    <message>
        <source>Seen from carrier %1, the gears of mesh %2 turn against each other, each along its own axis: f = %3.</source>
        <translation>Von Steg %1 aus gesehen drehen die Räder von Eingriff %2 gegensinnig, jedes um seine eigene Achse: f = %3.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: seen from the carrier, its gears turn the same way, so that f is %2.</source>
        <translation>Eingriff %1 ist innen: Vom Steg aus gesehen drehen seine Räder gleichsinnig, also ist f = %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: seen from the carrier, its gears turn against each other, so that f is %2.</source>
        <translation>Eingriff %1 ist außen: Vom Steg aus gesehen drehen seine Räder gegensinnig, also ist f = %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a bevel mesh: seen from the carrier, its gears turn the same way, so that f is %2.</source>
        <translation>Eingriff %1 ist ein Kegelradeingriff: Vom Steg aus gesehen drehen seine Räder gleichsinnig, also ist f = %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a bevel mesh: seen from the carrier, its gears turn against each other, so that f is %2.</source>
        <translation>Eingriff %1 ist ein Kegelradeingriff: Vom Steg aus gesehen drehen seine Räder gegensinnig, also ist f = %2.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: the gear with more teeth turns more slowly, f = %1.</source>
        <translation>Ihr Verhältnis steht verkehrt herum: Das Rad mit mehr Zähnen dreht langsamer, f = %1.</translation>
    </message>
    <message>
        <source>Your ratio is upside down, and the sign is wrong, too: f = %1.</source>
        <translation>Ihr Verhältnis steht verkehrt herum, und auch das Vorzeichen ist falsch: f = %1.</translation>
    </message>
    <message>
        <source>You take the teeth of another wheel on the same link: mesh %1 has %2 and %3.</source>
        <translation>Sie nehmen die Zähne eines anderen Rades auf demselben Glied: Eingriff %1 hat %2 und %3.</translation>
    </message>
    <message>
        <source>Write the f-circuit equation of the chord between gear $%1$ and carrier $%2$: the coefficients of the branches.</source>
        <translation>Schreiben Sie die f-Kreis-Gleichung der Sehne zwischen Rad $%1$ und Steg $%2$: die Koeffizienten der Zweige.</translation>
    </message>
    <message>
        <source>The speed of gear %1 in carrier %2 is the sum over the branches between them: 1 for a branch that points to the gear, −1 for one that points to the carrier, as their axes do.</source>
        <translation>Die Drehzahl von Rad %1 im Steg %2 ist die Summe über die Zweige dazwischen: 1 für einen Zweig, der zum Rad weist, −1 für einen, der zum Steg weist, wie ihre Achsen.</translation>
    </message>
    <message>
        <source>You write the speed of the carrier relative to the gear: all signs are the opposite.</source>
        <translation>Sie schreiben die Drehzahl des Stegs gegenüber dem Rad: Alle Vorzeichen sind umgekehrt.</translation>
    </message>
    <message>
        <source>This is the circuit of the other chord of mesh %1, of gear %2.</source>
        <translation>Das ist der Kreis der anderen Sehne von Eingriff %1, der von Rad %2.</translation>
    </message>
    <message>
        <source>You write the speed relative to the ground: the chord ends at carrier %1.</source>
        <translation>Sie schreiben die Drehzahl gegenüber dem Gestell: Die Sehne endet am Steg %1.</translation>
    </message>
    <message>
        <source>You follow the walk from gear to gear: the chord ends at carrier %1.</source>
        <translation>Sie folgen dem Weg von Rad zu Rad: Die Sehne endet am Steg %1.</translation>
    </message>
    <message>
        <source>You give all branches one sign: one that points from the gear to the carrier counts −1.</source>
        <translation>Sie geben allen Zweigen ein Vorzeichen: Ein Zweig, der vom Rad zum Steg weist, zählt −1.</translation>
    </message>
    <message>
        <source>The branches between gear %1 and carrier %2 do not include %3: 0.</source>
        <translation>Zu den Zweigen zwischen Rad %1 und Steg %2 gehört %3 nicht: 0.</translation>
    </message>
    <message>
        <source>The sign of %1 is the opposite on the way from the carrier to the gear: %2.</source>
        <translation>Das Vorzeichen von %1 ist auf dem Weg vom Steg zum Rad umgekehrt: %2.</translation>
    </message>
    <message>
        <source>The circuit closes through %1: %2, not 0.</source>
        <translation>Der Kreis schließt sich durch %1: %2, nicht 0.</translation>
    </message>
    <message>
        <source>%1 does not use %2: 0.</source>
        <translation>%1 benutzt %2 nicht: 0.</translation>
    </message>
    <message>
        <source>%1 runs along the arrow of %2: 1, not −1.</source>
        <translation>%1 läuft entlang des Pfeils von %2: 1, nicht −1.</translation>
    </message>
    <message>
        <source>%1 runs against the arrow of %2: −1, not 1.</source>
        <translation>%1 läuft gegen den Pfeil von %2: −1, nicht 1.</translation>
    </message>
    <message>
        <source>%1 uses %2, along its arrow: 1, not 0.</source>
        <translation>%1 benutzt %2, entlang des Pfeils: 1, nicht 0.</translation>
    </message>
    <message>
        <source>%1 uses %2, against its arrow: −1, not 0.</source>
        <translation>%1 benutzt %2, gegen den Pfeil: −1, nicht 0.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1</source>
        <translation>Der Zyklus von Eingriff %1</translation>
    </message>
    <message>
        <source>You walk the cycle against mesh %1: it runs along the mesh from tail to head and back through the tree.</source>
        <translation>Sie durchlaufen den Zyklus gegen Eingriff %1: Er läuft entlang des Eingriffs vom Fuß zur Spitze und durch den Baum zurück.</translation>
    </message>
    <message>
        <source>You mark the joints of the cycle without their senses: −1 where the walk runs against an arrow.</source>
        <translation>Sie markieren die Gelenke des Zyklus ohne ihre Richtungen: −1, wo der Weg gegen einen Pfeil läuft.</translation>
    </message>
    <message>
        <source>This is the row of the cycle of mesh %1, not of mesh %2.</source>
        <translation>Das ist die Zeile des Zyklus von Eingriff %1, nicht von Eingriff %2.</translation>
    </message>
    <message>
        <source>%1 begins along the mesh itself: 1.</source>
        <translation>%1 beginnt entlang des Eingriffs selbst: 1.</translation>
    </message>
    <message>
        <source>%1 is walked along its mesh, from tail to head: 1, not −1.</source>
        <translation>%1 wird entlang seines Eingriffs durchlaufen, vom Fuß zur Spitze: 1, nicht −1.</translation>
    </message>
    <message>
        <source>%1 holds one mesh only, not mesh %2: 0.</source>
        <translation>%1 enthält nur einen Eingriff, nicht Eingriff %2: 0.</translation>
    </message>
    <message>
        <source>Fill in these rows and columns of the path matrix $Z$: how the walk from each link to the ground uses the turning joints.</source>
        <translation>Füllen Sie diese Zeilen und Spalten der Wegmatrix $Z$ aus: wie der Weg von jedem Glied zum Gestell die Drehgelenke benutzt.</translation>
    </message>
    <message>
        <source>Walk from the link to the ground: 1 where the walk follows a joint&apos;s arrow, −1 where it runs against it, 0 off the walk.</source>
        <translation>Gehen Sie vom Glied zum Gestell: 1, wo der Weg dem Pfeil eines Gelenks folgt, −1, wo er dagegen läuft, 0 abseits des Wegs.</translation>
    </message>
    <message>
        <source>You walk from the ground to the links: the walks of Z end at the ground.</source>
        <translation>Sie gehen vom Gestell zu den Gliedern: Die Wege von Z enden am Gestell.</translation>
    </message>
    <message>
        <source>You mark the joints of the walks without their senses: −1 where a walk runs against an arrow.</source>
        <translation>Sie markieren die Gelenke der Wege ohne ihre Richtungen: −1, wo ein Weg gegen einen Pfeil läuft.</translation>
    </message>
    <message>
        <source>You exchange rows and columns: a column of Z belongs to a link and tells its walk.</source>
        <translation>Sie vertauschen Zeilen und Spalten: Eine Spalte von Z gehört zu einem Glied und beschreibt seinen Weg.</translation>
    </message>
    <message>
        <source>This is the walk of link %1, not of link %2.</source>
        <translation>Das ist der Weg von Glied %1, nicht von Glied %2.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground</source>
        <translation>Der Weg von Glied %1 zum Gestell</translation>
    </message>
    <message>
        <source>Fill in this row of the spanning-tree matrix $T$.</source>
        <translation>Füllen Sie diese Zeile der Spannbaummatrix $T$ aus.</translation>
    </message>
    <message>
        <source>Fill in these rows of the spanning-tree matrix $T$.</source>
        <translation>Füllen Sie diese Zeilen der Spannbaummatrix $T$ aus.</translation>
    </message>
    <message>
        <source>Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows a joint&apos;s arrow, −1 where it runs against it.</source>
        <translation>Durchlaufen Sie den Zyklus entlang seines Eingriffs vom Fuß zur Spitze und durch den Baum zurück: 1, wo der Weg dem Pfeil eines Gelenks folgt, −1, wo er dagegen läuft.</translation>
    </message>
    <message>
        <source>You walk the cycles against their meshes: they run along the mesh from tail to head and back through the tree.</source>
        <translation>Sie durchlaufen die Zyklen gegen ihre Eingriffe: Sie laufen entlang des Eingriffs vom Fuß zur Spitze und durch den Baum zurück.</translation>
    </message>
    <message>
        <source>You mark the joints of the cycles without their senses: −1 where the walk runs against an arrow.</source>
        <translation>Sie markieren die Gelenke der Zyklen ohne ihre Richtungen: −1, wo der Weg gegen einen Pfeil läuft.</translation>
    </message>
    <message>
        <source>You exchange the rows of both cycles.</source>
        <translation>Sie vertauschen die Zeilen beider Zyklen.</translation>
    </message>
    <message>
        <source>Fill in row $C_{%1}$ of the cycle-basis matrix $C = \left[ T \mid U \right]$.</source>
        <translation>Füllen Sie Zeile $C_{%1}$ der Zyklenbasismatrix $C = \left[ T \mid U \right]$ aus.</translation>
    </message>
    <message>
        <source>Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows an arrow, −1 where it runs against one.</source>
        <translation>Durchlaufen Sie den Zyklus entlang seines Eingriffs vom Fuß zur Spitze und durch den Baum zurück: 1, wo der Weg einem Pfeil folgt, −1, wo er gegen einen läuft.</translation>
    </message>
    <message>
        <source>Fill in the row of joint $%1$ of the fundamental cutset matrix $Q = \left[ U \mid -T^T \right]$.</source>
        <translation>Füllen Sie die Zeile von Gelenk $%1$ der fundamentalen Schnittmengenmatrix $Q = \left[ U \mid -T^T \right]$ aus.</translation>
    </message>
    <message>
        <source>Without the joint the tree falls into two halves: every edge between them counts, 1 where it crosses in the joint&apos;s direction, −1 where it crosses the other way.</source>
        <translation>Ohne das Gelenk zerfällt der Baum in zwei Hälften: Jede Kante dazwischen zählt, 1, wo sie in Richtung des Gelenks quert, −1, wo sie andersherum quert.</translation>
    </message>
    <message>
        <source>You take the signs of the cycles: Q holds −T transposed beside the unit matrix.</source>
        <translation>Sie nehmen die Vorzeichen der Zyklen: Q enthält −T transponiert neben der Einheitsmatrix.</translation>
    </message>
    <message>
        <source>You mark the edges of the cutset without their senses: −1 where an edge crosses against the joint.</source>
        <translation>Sie markieren die Kanten der Schnittmenge ohne ihre Richtungen: −1, wo eine Kante gegen das Gelenk quert.</translation>
    </message>
    <message>
        <source>This is the cutset of joint %1, not of %2.</source>
        <translation>Das ist die Schnittmenge von Gelenk %1, nicht von %2.</translation>
    </message>
    <message>
        <source>The joint crosses its own cut in its own direction: 1, not −1.</source>
        <translation>Das Gelenk quert seinen eigenen Schnitt in seiner Richtung: 1, nicht −1.</translation>
    </message>
    <message>
        <source>The cutset holds its own joint: 1, not 0.</source>
        <translation>Die Schnittmenge enthält ihr eigenes Gelenk: 1, nicht 0.</translation>
    </message>
    <message>
        <source>A fundamental cutset holds one turning joint only, not %1: 0.</source>
        <translation>Eine fundamentale Schnittmenge enthält nur ein Drehgelenk, nicht %1: 0.</translation>
    </message>
    <message>
        <source>Both gears of %1 are on one side of %2: 0.</source>
        <translation>Beide Räder von %1 liegen auf einer Seite von %2: 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 crosses the cut in the direction of %2: 1, not −1.</source>
        <translation>Der Pfeil von %1 quert den Schnitt in Richtung von %2: 1, nicht −1.</translation>
    </message>
    <message>
        <source>The arrow of %1 crosses the cut against %2: −1, not 1.</source>
        <translation>Der Pfeil von %1 quert den Schnitt gegen %2: −1, nicht 1.</translation>
    </message>
    <message>
        <source>The ends of %1 are on different sides of %2: %3, not 0.</source>
        <translation>Die Enden von %1 liegen auf verschiedenen Seiten von %2: %3, nicht 0.</translation>
    </message>
    <message>
        <source>The field %1 is empty.</source>
        <translation>Das Feld „%1“ ist leer.</translation>
    </message>
    <message>
        <source>“%1” can be read as a thousand or as a decimal: write it without the comma, or as a fraction.</source>
        <translation>„%1“ lässt sich als Tausender oder als Dezimalzahl lesen: Schreiben Sie es ohne Komma oder als Bruch.</translation>
    </message>
    <message>
        <source>“%1” is not a number: write a whole number, a fraction such as −3/4 or a decimal.</source>
        <translation>„%1“ ist keine Zahl: Schreiben Sie eine ganze Zahl, einen Bruch wie −3/4 oder eine Dezimalzahl.</translation>
    </message>
    <message>
        <source>“%1” is not among what the question offers for %2.</source>
        <translation>„%1“ gehört nicht zu dem, was die Frage für „%2“ anbietet.</translation>
    </message>
    <message>
        <source>meshes %1</source>
        <translation>Eingriffe %1</translation>
    </message>
    <message>
        <source>Mesh %1 follows from %2: it constrains nothing more. Harmless for the motion; the load is shared.</source>
        <translation>Eingriff %1 ist redundant gegenüber %2: Er bindet nichts weiter. Für die Bewegung unschädlich; die Last teilt sich auf.</translation>
    </message>
    <message>
        <source>Links %1 are equal planets, which share the load: the motion would be the same without %2.</source>
        <translation>Glieder %1 sind gleiche Planeten, die sich die Last teilen: Ohne %2 wäre die Bewegung dieselbe.</translation>
    </message>
    <message>
        <source>Brake %1 is engaged and holds nothing that could move.</source>
        <translation>Bremse %1 ist geschlossen und hält nichts, was sich bewegen könnte.</translation>
    </message>
    <message>
        <source>Brake %1 is engaged and holds nothing that could move: that follows from %2.</source>
        <translation>Bremse %1 ist geschlossen und hält nichts, was sich bewegen könnte: Das folgt schon aus %2.</translation>
    </message>
    <message>
        <source>Clutch %1 is engaged and holds nothing that could move.</source>
        <translation>Kupplung %1 ist geschlossen und hält nichts, was sich bewegen könnte.</translation>
    </message>
    <message>
        <source>Clutch %1 is engaged and holds nothing that could move: that follows from %2.</source>
        <translation>Kupplung %1 ist geschlossen und hält nichts, was sich bewegen könnte: Das folgt schon aus %2.</translation>
    </message>
    <message>
        <source>Nothing can move: the loop of %1 locks it. Change a tooth count so that the ratios round the loop agree, or delete a mesh.</source>
        <translation>Nichts kann sich bewegen: Die Schleife aus %1 sperrt es. Ändern Sie eine Zähnezahl, sodass die Übersetzungen um die Schleife zusammenpassen, oder löschen Sie einen Eingriff.</translation>
    </message>
    <message>
        <source>Nothing can move: %1 holds everything. Release a coupling.</source>
        <translation>Nichts kann sich bewegen: %1 hält alles. Lösen Sie ein Schaltelement.</translation>
    </message>
    <message>
        <source>Nothing can move: %1 hold everything. Release a coupling.</source>
        <translation>Nichts kann sich bewegen: %1 halten alles. Lösen Sie ein Schaltelement.</translation>
    </message>
    <message>
        <source>Joint %1 can never turn, locked by %2.</source>
        <translation>Gelenk %1 kann sich nie drehen, gesperrt durch %2.</translation>
    </message>
    <message>
        <source>Joints %1 can never turn, locked by %2.</source>
        <translation>Die Gelenke %1 können sich nie drehen, gesperrt durch %2.</translation>
    </message>
    <message>
        <source>Links %1 form a rigid block.</source>
        <translation>Die Glieder %1 bilden einen starren Block.</translation>
    </message>
    <message>
        <source>No mesh constrains joint %1: it has to be driven.</source>
        <translation>Kein Eingriff bindet Gelenk %1: Es muss angetrieben werden.</translation>
    </message>
    <message>
        <source>No mesh constrains joints %1: they have to be driven.</source>
        <translation>Kein Eingriff bindet die Gelenke %1: Sie müssen angetrieben werden.</translation>
    </message>
    <message>
        <source>The mechanism has 1 degree of freedom, and 1 input is chosen.</source>
        <translation>Der Mechanismus hat 1 Freiheitsgrad, und 1 Antrieb ist gewählt.</translation>
    </message>
    <message>
        <source>The mechanism has 1 degree of freedom, and %1 inputs are chosen.</source>
        <translation>Der Mechanismus hat 1 Freiheitsgrad, und %1 Antriebe sind gewählt.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom, and 1 input is chosen.</source>
        <translation>Der Mechanismus hat %1 Freiheitsgrade, und 1 Antrieb ist gewählt.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom, and %2 inputs are chosen.</source>
        <translation>Der Mechanismus hat %1 Freiheitsgrade, und %2 Antriebe sind gewählt.</translation>
    </message>
    <message>
        <source>Joint %1 is chosen twice.</source>
        <translation>Gelenk %1 ist zweimal gewählt.</translation>
    </message>
    <message>
        <source>Joint %1 is no free choice: %2.</source>
        <translation>Gelenk %1 ist nicht frei wählbar: %2.</translation>
    </message>
    <message>
        <source>Still free: choose %1 too.</source>
        <translation>Noch frei: Wählen Sie auch %1.</translation>
    </message>
    <message>
        <source>The only valid set is the empty one.</source>
        <translation>Die einzige gültige Menge ist die leere.</translation>
    </message>
    <message>
        <source>A valid set is %1.</source>
        <translation>Eine gültige Menge ist %1.</translation>
    </message>
    <message>
        <source>There are no gear meshes yet: every joint is free.</source>
        <translation>Es gibt noch keine Zahneingriffe: Jedes Gelenk ist frei.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: the train holds it with nothing engaged. Change the train, or drive another link.</source>
        <translation>Schaltzustand %1 sperrt seinen Antrieb, Glied %2: Das Getriebe hält es, ohne dass etwas geschlossen ist. Ändern Sie das Getriebe oder treiben Sie ein anderes Glied an.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: more couplings than one hold it. Release two or more, or drive another link.</source>
        <translation>Schaltzustand %1 sperrt seinen Antrieb, Glied %2: Mehr als ein Schaltelement hält es. Lösen Sie zwei oder mehr oder treiben Sie ein anderes Glied an.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: %3 holds it. Release it, or drive another link.</source>
        <translation>Schaltzustand %1 sperrt seinen Antrieb, Glied %2: %3 hält es. Lösen Sie es oder treiben Sie ein anderes Glied an.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: %3 hold it together. Release one of them, or drive another link.</source>
        <translation>Schaltzustand %1 sperrt seinen Antrieb, Glied %2: %3 halten es gemeinsam. Lösen Sie eines davon oder treiben Sie ein anderes Glied an.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: with the drive, link %3, held, link %4 still turns.</source>
        <translation>Schaltzustand %1 lässt %2 Freiheitsgrade: Bei gehaltenem Antrieb, Glied %3, dreht sich Glied %4 noch.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: with the drive, link %3, held, links %4 still turn.</source>
        <translation>Schaltzustand %1 lässt %2 Freiheitsgrade: Bei gehaltenem Antrieb, Glied %3, drehen sich die Glieder %4 noch.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: link %3 still turns.</source>
        <translation>Schaltzustand %1 lässt %2 Freiheitsgrade: Glied %3 dreht sich noch.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: links %3 still turn.</source>
        <translation>Schaltzustand %1 lässt %2 Freiheitsgrade: Die Glieder %3 drehen sich noch.</translation>
    </message>
    <message>
        <source>Engage one more coupling that holds them.</source>
        <translation>Schließen Sie ein weiteres Schaltelement, das sie hält.</translation>
    </message>
    <message>
        <source>Engage %1 more couplings that hold them.</source>
        <translation>Schließen Sie %1 weitere Schaltelemente, die sie halten.</translation>
    </message>
    <message>
        <source>State %1: coupling %2 ties link %3 to the ground over axes of four directions or more.</source>
        <translation>Schaltzustand %1: Schaltelement %2 verbindet Glied %3 mit dem Gestell über Achsen von vier oder mehr Richtungen.</translation>
    </message>
    <message>
        <source>State %1: coupling %2 ties link %3 to link %4 over axes of four directions or more.</source>
        <translation>Schaltzustand %1: Schaltelement %2 verbindet Glied %3 mit Glied %4 über Achsen von vier oder mehr Richtungen.</translation>
    </message>
    <message>
        <source>Engaged coupling %1 ties link %2 to the ground over axes of four directions or more.</source>
        <translation>Das geschlossene Schaltelement %1 verbindet Glied %2 mit dem Gestell über Achsen von vier oder mehr Richtungen.</translation>
    </message>
    <message>
        <source>Engaged coupling %1 ties link %2 to link %3 over axes of four directions or more.</source>
        <translation>Das geschlossene Schaltelement %1 verbindet Glied %2 mit Glied %3 über Achsen von vier oder mehr Richtungen.</translation>
    </message>
    <message>
        <source>That is a linkage whose speeds depend on the pose: there is no ratio to state. Couple links that lie nearer to each other.</source>
        <translation>Das ist ein Gelenkgetriebe, dessen Drehzahlen von der Stellung abhängen: Es gibt keine Übersetzung anzugeben. Kuppeln Sie Glieder, die näher beieinander liegen.</translation>
    </message>
    <message>
        <source>Clutch %1 couples links %2 and %3, which do not turn about one axis against each other: their axes are not one line. Couple links on one axis, or a planet and its carrier.</source>
        <translation>Kupplung %1 verbindet die Glieder %2 und %3, die sich nicht um eine gemeinsame Achse gegeneinander drehen: Ihre Achsen sind nicht eine Linie. Verbinden Sie Glieder auf einer Achse oder einen Planeten mit seinem Steg.</translation>
    </message>
    <message>
        <source>State %1 has a ratio beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, give one that it can.</source>
        <translation>Schaltzustand %1 hat eine Übersetzung jenseits der größten Zahl, die die Analyse fassen kann, 1.79e308. Näher beieinanderliegende Zähnezahlen oder weniger Eingriffe hintereinander ergeben eine darstellbare.</translation>
    </message>
    <message>
        <source>Mesh %1 holds gears %2 and %3 on one axis (%4). Gears that mesh turn about two axes of one carrier: let one of them turn about another axis.</source>
        <translation>Eingriff %1 hat die Räder %2 und %3 auf einer Achse (%4). Kämmende Räder drehen sich um zwei Achsen eines Stegs: Lassen Sie eines um eine andere Achse drehen.</translation>
    </message>
    <message>
        <source>The path between the gears of mesh %1 runs over %2 axes (%3), and no carrier holds both of theirs: attach gear %4 to link %5.</source>
        <translation>Der Weg zwischen den Rädern von Eingriff %1 läuft über %2 Achsen (%3), und kein Steg hält beide zugehörigen: Befestigen Sie Rad %4 an Glied %5.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
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
        <source>four</source>
        <translation>vier</translation>
    </message>
    <message>
        <source>five</source>
        <translation>fünf</translation>
    </message>
    <message>
        <source>six</source>
        <translation>sechs</translation>
    </message>
    <message>
        <source>seven</source>
        <translation>sieben</translation>
    </message>
    <message>
        <source>eight</source>
        <translation>acht</translation>
    </message>
    <message>
        <source>nine</source>
        <translation>neun</translation>
    </message>
    <message>
        <source>ten</source>
        <translation>zehn</translation>
    </message>
    <message>
        <source>eleven</source>
        <translation>elf</translation>
    </message>
    <message>
        <source>twelve</source>
        <translation>zwölf</translation>
    </message>
    <message>
        <source>Preview: %1. Click to keep it; leave it, or Esc, to go back</source>
        <translation>Vorschau: %1. Klicken behält es; Verlassen oder Esc stellt zurück</translation>
    </message>
    <message>
        <source>%1 (nearest axes)</source>
        <translation>%1 (nächste Achsen)</translation>
    </message>
    <message>
        <source>relative to %1</source>
        <translation>gegen %1</translation>
    </message>
    <message>
        <source>link %1 (%2)</source>
        <translation>Glied %1 (%2)</translation>
    </message>
    <message>
        <source>%1 relative to %2</source>
        <translation>%1 gegen %2</translation>
    </message>
    <message>
        <source>Speed of joint %1: link %2 relative to link %3</source>
        <translation>Drehzahl von Gelenk %1: Glied %2 gegen Glied %3</translation>
    </message>
    <message>
        <source>Speed of joint %1: how fast %2 turns relative to %3. Positive: about the direction of the axis, by the right-hand rule.</source>
        <translation>Drehzahl von Gelenk %1: wie schnell %2 gegen %3 dreht. Positiv: um die Richtung der Achse, nach der Rechte-Hand-Regel.</translation>
    </message>
    <message>
        <source>Speed of joint %1, %2</source>
        <translation>Drehzahl von Gelenk %1, %2</translation>
    </message>
    <message>
        <source>Speed of the only input over that of an output. Select a joint or a link to see its ratio.</source>
        <translation>Drehzahl des einzigen Antriebs durch die eines Abtriebs. Wählen Sie ein Gelenk oder Glied aus, um seine Übersetzung zu sehen.</translation>
    </message>
    <message>
        <source>Ratio %1</source>
        <translation>Übersetzung %1</translation>
    </message>
    <message>
        <source>What speeds are relative to: joint by joint, or those of the links seen from one</source>
        <translation>Wogegen Drehzahlen gezählt werden: Gelenk für Gelenk, oder die der Glieder von einem aus gesehen</translation>
    </message>
    <message>
        <source>Drive by a link’s joints ▾</source>
        <translation>Über ein Glied antreiben ▾</translation>
    </message>
    <message>
        <source>Make the joints that carry a link the inputs: their speeds are set, those of the motors become results</source>
        <translation>Die Gelenke, die ein Glied tragen, zu Antrieben machen: ihre Drehzahlen werden vorgegeben, die der Motoren werden Ergebnisse</translation>
    </message>
    <message>
        <source>joint by joint</source>
        <translation>Gelenk für Gelenk</translation>
    </message>
    <message>
        <source>relative to the ground</source>
        <translation>gegen das Gestell</translation>
    </message>
    <message>
        <source>Joint by joint: each link relative to the one that carries it</source>
        <translation>Gelenk für Gelenk: jedes Glied gegen das, das es trägt</translation>
    </message>
    <message>
        <source>Relative to the ground</source>
        <translation>Gegen das Gestell</translation>
    </message>
    <message>
        <source>Relative to %1</source>
        <translation>Gegen %1</translation>
    </message>
    <message>
        <source>Ratio to joint %1, %2</source>
        <translation>Verhältnis zu Gelenk %1, %2</translation>
    </message>
    <message>
        <source>Joints of %1: %2</source>
        <translation>Gelenke von %1: %2</translation>
    </message>
    <message>
        <source>tooth forces (on heads)</source>
        <translation>Zahnkräfte (auf die Köpfe)</translation>
    </message>
    <message>
        <source>bearing reactions (on heads)</source>
        <translation>Lagerreaktionen (auf die Köpfe)</translation>
    </message>
    <message>
        <source>mesh %1: %2</source>
        <translation>Eingriff %1: %2</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>Gelenk %1: %2</translation>
    </message>
    <message>
        <source>%1; X, Y or Z lays its axis along x, y or z</source>
        <translation>%1; X, Y oder Z legt seine Achse entlang x, y oder z</translation>
    </message>
    <message>
        <source>%1; its axis lies along %2</source>
        <translation>%1; seine Achse liegt entlang %2</translation>
    </message>
    <message>
        <source>No forces without loads: add one in Forces.</source>
        <translation>Keine Kräfte ohne Lasten: Fügen Sie unter Kräfte eine hinzu.</translation>
    </message>
    <message>
        <source>No forces: the loads are not in balance. Forces names what is missing.</source>
        <translation>Keine Kräfte: Die Lasten sind nicht im Gleichgewicht. Unter Kräfte steht, was fehlt.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: forces at meshes %1. Choose Share by stiffness in Forces to find them.</source>
        <translation>Nicht gezeichnet, da zu unbekannten Teilen geteilt: Kräfte an den Zahneingriffen %1. Unter Kräfte ergeben sie sich mit „Nach Steifigkeit aufteilen“.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: reactions in joints %1. Choose Share by stiffness in Forces to find them.</source>
        <translation>Nicht gezeichnet, da zu unbekannten Teilen geteilt: Reaktionen in den Gelenken %1. Unter Kräfte ergeben sie sich mit „Nach Steifigkeit aufteilen“.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: forces at meshes %1, reactions in joints %2. Choose Share by stiffness in Forces to find them.</source>
        <translation>Nicht gezeichnet, da zu unbekannten Teilen geteilt: Kräfte an den Zahneingriffen %1, Reaktionen in den Gelenken %2. Unter Kräfte ergeben sie sich mit „Nach Steifigkeit aufteilen“.</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Release %1; the motion goes on</source>
        <translation>%1 lösen; die Bewegung läuft weiter</translation>
    </message>
    <message>
        <source>Find no torque here any more; without any such place the inputs hold the loads</source>
        <translation>Hier kein Moment mehr suchen; ohne jede solche Stelle halten die Antriebe die Lasten</translation>
    </message>
    <message>
        <source>Remove balance</source>
        <translation>Ausgleich entfernen</translation>
    </message>
    <message>
        <source>The entry that speeds and torques share</source>
        <translation>Der Eintrag, den Drehzahlen und Momente teilen</translation>
    </message>
    <message>
        <source>A row of P holds the speeds of a mesh, a column the torque in a joint: the framed entry is in both. Entries count teeth; μ is the force of a mesh for each tooth, ℓ what loads on links add. Select a joint or a mesh to see its own; click the framed entry to see it in Matrices.</source>
        <translation>Eine Zeile von P enthält die Drehzahlen eines Zahneingriffs, eine Spalte das Moment in einem Gelenk: der eingerahmte Eintrag steht in beiden. Einträge zählen Zähne; μ ist die Kraft eines Zahneingriffs je Zahn, ℓ was Lasten auf Gliedern beitragen. Wählen Sie ein Gelenk oder einen Zahneingriff, um dessen Gleichungen zu sehen; ein Klick auf den eingerahmten Eintrag zeigt ihn unter Matrizen.</translation>
    </message>
    <message>
        <source>; brake %1 is engaged</source>
        <translation>; Bremse %1 ist geschlossen</translation>
    </message>
    <message>
        <source>by an engaged brake</source>
        <translation>durch eine geschlossene Bremse</translation>
    </message>
    <message>
        <source>cut into the ground</source>
        <translation>im Gestell eingeschnitten</translation>
    </message>
    <message>
        <source>What &quot;held&quot; means: a link of its own with a brake that is engaged, so that you can release it; or no link of its own, its teeth are the ground&apos;s, as in the example &quot;Planetary train, ring held&quot;. The speeds are the same.</source>
        <translation>Was „festgehalten“ bedeutet: ein eigenes Glied mit einer geschlossenen Bremse, die Sie lösen können; oder kein eigenes Glied, seine Zähne gehören zum Gestell, wie im Beispiel „Planetary train, ring held“. Die Geschwindigkeiten sind gleich.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Festgehalten</translation>
    </message>
    <message>
        <source>One file is needed.</source>
        <translation>Eine Datei wird gebraucht.</translation>
    </message>
    <message>
        <source>Give --symbolic or --no-symbolic.</source>
        <translation>Geben Sie --symbolic oder --no-symbolic an.</translation>
    </message>
    <message>
        <source>the analysis</source>
        <translation>die Analyse</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>Die Standardausgabe konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>drive these joints (by label) instead of the document&apos;s</source>
        <translation>diese Gelenke (nach Bezeichnung) antreiben statt der des Dokuments</translation>
    </message>
    <message>
        <source>the speed of an input in rad/s; may be repeated</source>
        <translation>die Drehgeschwindigkeit eines Antriebs in rad/s; darf wiederholt werden</translation>
    </message>
    <message>
        <source>with the solution in gear ratios (the default)</source>
        <translation>mit der Lösung in Übersetzungen (Voreinstellung)</translation>
    </message>
    <message>
        <source>without it</source>
        <translation>ohne sie</translation>
    </message>
    <message>
        <source>as JSON</source>
        <translation>als JSON</translation>
    </message>
    <message>
        <source>with --json: all entries of matrices, also above 250,000 (else triplets)</source>
        <translation>mit --json: alle Einträge der Matrizen, auch über 250.000 (sonst Tripel)</translation>
    </message>
    <message>
        <source>Analyses a mechanism, for people or as JSON.</source>
        <translation>Analysiert einen Mechanismus, für Menschen oder als JSON.</translation>
    </message>
    <message>
        <source>Untitled mechanism</source>
        <translation>Mechanismus ohne Titel</translation>
    </message>
    <message>
        <source>%1 moving link</source>
        <translation>%1 bewegtes Glied</translation>
    </message>
    <message>
        <source>%1 moving links</source>
        <translation>%1 bewegte Glieder</translation>
    </message>
    <message>
        <source>%1 turning joint</source>
        <translation>%1 Drehgelenk</translation>
    </message>
    <message>
        <source>%1 gear mesh</source>
        <translation>%1 Zahneingriff</translation>
    </message>
    <message>
        <source>teeth %1 : %2</source>
        <translation>Zähne %1 : %2</translation>
    </message>
    <message>
        <source>Eq. (%1)</source>
        <translation>Gl. (%1)</translation>
    </message>
    <message>
        <source>%1 row</source>
        <translation>%1 Zeile</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>%1 column</source>
        <translation>%1 Spalte</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>%1 Spalten</translation>
    </message>
    <message>
        <source>%1: too large to print; see &quot;export --to csv --matrix %2&quot;</source>
        <translation>%1: zu groß zum Drucken; siehe „export --to csv --matrix %2“</translation>
    </message>
    <message>
        <source>The option %1 takes no value.</source>
        <translation>Die Option %1 nimmt keinen Wert.</translation>
    </message>
    <message>
        <source>The option %1 needs a value: %1 %2.</source>
        <translation>Die Option %1 braucht einen Wert: %1 %2.</translation>
    </message>
    <message>
        <source>The options cannot be read.</source>
        <translation>Die Optionen sind nicht lesbar.</translation>
    </message>
    <message>
        <source>There is no option &quot;%1&quot; here.</source>
        <translation>Eine Option „%1“ gibt es hier nicht.</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>rows %1</source>
        <translation>Zeilen %1</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>columns %1</source>
        <translation>Spalten %1</translation>
    </message>
    <message>
        <source>There is no matrix &quot;%1&quot;: %2.</source>
        <translation>Eine Matrix „%1“ gibt es nicht: %2.</translation>
    </message>
    <message>
        <source>A mechanism and a file with a matrix or equations are needed.</source>
        <translation>Ein Mechanismus und eine Datei mit einer Matrix oder Gleichungen werden gebraucht.</translation>
    </message>
    <message>
        <source>the check</source>
        <translation>die Prüfung</translation>
    </message>
    <message>
        <source>Compares a matrix or equations of yours with the derived ones; status 1 where they differ.</source>
        <translation>Vergleicht eine Matrix oder Gleichungen von Ihnen mit den hergeleiteten; Status 1, wo sie abweichen.</translation>
    </message>
    <message>
        <source>Usage: geargraph-cli %1 %2</source>
        <translation>Aufruf: geargraph-cli %1 %2</translation>
    </message>
    <message>
        <source>More: geargraph-cli %1 --help</source>
        <translation>Mehr: geargraph-cli %1 --help</translation>
    </message>
    <message>
        <source>Not in the table: %1.</source>
        <translation>Nicht in der Tabelle: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a table or a graph, not a document. Convert it first: geargraph-cli convert %1 --to geargraph -o %2</source>
        <translation>„%1“ ist eine Tabelle oder ein Graph, kein Dokument. Wandeln Sie die Datei zuerst um: geargraph-cli convert %1 --to geargraph -o %2</translation>
    </message>
    <message>
        <source>Not in the graph: %1.</source>
        <translation>Nicht im Graphen: %1.</translation>
    </message>
    <message>
        <source>--to is one of csv, geargraph, dot, graphml, node-link.</source>
        <translation>--to ist eines von csv, geargraph, dot, graphml, node-link.</translation>
    </message>
    <message>
        <source>--separator is one of comma, semicolon, tab.</source>
        <translation>--separator ist eines von comma, semicolon, tab.</translation>
    </message>
    <message>
        <source>%1 has no meaning with %2; it is an option of %3.</source>
        <translation>%1 hat mit %2 keine Bedeutung; es ist eine Option von %3.</translation>
    </message>
    <message>
        <source>the conversion</source>
        <translation>die Umwandlung</translation>
    </message>
    <message>
        <source>csv: a table with a row for each link, axis, turning joint, gear mesh, ...; geargraph: a document; dot, graphml, node-link: the digraph; each is read back, graphs of other programs, too, where edges have kind, axis and tooth counts</source>
        <translation>csv: eine Tabelle mit einer Zeile für jedes Glied, jede Achse, jedes Drehgelenk, jeden Zahneingriff, ...; geargraph: ein Dokument; dot, graphml, node-link: der Digraph; jedes wird wieder gelesen, auch Graphen anderer Programme, wenn Kanten Art, Achse und Zähnezahlen haben</translation>
    </message>
    <message>
        <source>the file (standard output)</source>
        <translation>die Datei (Standardausgabe)</translation>
    </message>
    <message>
        <source>of a table that is written (comma); reading recognises it</source>
        <translation>einer Tabelle, die geschrieben wird (comma); beim Lesen wird es erkannt</translation>
    </message>
    <message>
        <source>begin a table with a byte order mark, for spreadsheet programs</source>
        <translation>eine Tabelle mit einer Byte-Reihenfolge-Marke beginnen, für Tabellenprogramme</translation>
    </message>
    <message>
        <source>Converts documents to tables (CSV) and graphs, and back; FILE is any of them.</source>
        <translation>Wandelt Dokumente in Tabellen (CSV) und Graphen um, und zurück; FILE ist eines davon.</translation>
    </message>
    <message>
        <source>motion not checked: nothing moves, the mechanism has errors, or it has more than %1 links</source>
        <translation>Bewegung nicht geprüft: Nichts bewegt sich, der Mechanismus hat Fehler, oder er hat mehr als %1 Glieder</translation>
    </message>
    <message>
        <source>motion checked in part only: too many parts come close to each other</source>
        <translation>Bewegung nur zum Teil geprüft: Zu viele Teile kommen einander nahe</translation>
    </message>
    <message>
        <source>motion checked: the distance of no two parts changes, so that nothing can collide</source>
        <translation>Bewegung geprüft: Der Abstand keiner zwei Teile ändert sich, sodass nichts zusammenstoßen kann</translation>
    </message>
    <message>
        <source>motion checked from %1 to %2; it does not repeat sooner</source>
        <translation>Bewegung von %1 bis %2 geprüft; sie wiederholt sich nicht früher</translation>
    </message>
    <message>
        <source>motion checked from %1 to %2, between the limits of the joints</source>
        <translation>Bewegung geprüft von %1 bis %2, zwischen den Grenzen der Gelenke</translation>
    </message>
    <message>
        <source>motion checked for %1, until the motion of every two links repeats</source>
        <translation>Bewegung geprüft für %1, bis sich die Bewegung je zweier Glieder wiederholt</translation>
    </message>
    <message>
        <source>%1 names an input and its number, like %2, not &quot;%3&quot;.</source>
        <translation>%1 nennt einen Antrieb und seine Zahl, wie %2, nicht „%3“.</translation>
    </message>
    <message>
        <source>Joint %1 is not an input; see --inputs.</source>
        <translation>Gelenk %1 ist kein Antrieb; siehe --inputs.</translation>
    </message>
    <message>
        <source>--damping is at least 0, in N m s.</source>
        <translation>--damping ist mindestens 0, in N m s.</translation>
    </message>
    <message>
        <source>--seconds over --interval are at most a million samples.</source>
        <translation>--seconds durch --interval sind höchstens eine Million Abtastungen.</translation>
    </message>
    <message>
        <source>Dynamics is computed for up to %1 entries of the solution (inputs times other joints).</source>
        <translation>Dynamik wird für bis zu %1 Einträge der Lösung berechnet (Antriebe mal andere Gelenke).</translation>
    </message>
    <message>
        <source>the gear train</source>
        <translation>das Getriebe</translation>
    </message>
    <message>
        <source>the masses</source>
        <translation>die Massen</translation>
    </message>
    <message>
        <source>the motion</source>
        <translation>die Bewegung</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: there is no motion to write.</source>
        <translation>Eine Bewegung der Antriebe bewegt keine Masse: Es gibt keine Bewegung zu schreiben.</translation>
    </message>
    <message>
        <source>the torque of an input&apos;s motor (without it 0); may be given again</source>
        <translation>das Moment des Motors eines Antriebs (sonst 0); darf mehrmals stehen</translation>
    </message>
    <message>
        <source>less this for each rad/s, N m s; may be given again</source>
        <translation>um so viel weniger für jedes rad/s, N m s; darf mehrmals stehen</translation>
    </message>
    <message>
        <source>the angle of an input at the start; may be given again</source>
        <translation>der Winkel eines Antriebs am Anfang; darf mehrmals stehen</translation>
    </message>
    <message>
        <source>its speed at the start, rad/s or with a unit (without it 0); may be given again</source>
        <translation>seine Drehgeschwindigkeit am Anfang, rad/s oder mit Einheit (sonst 0); darf mehrmals stehen</translation>
    </message>
    <message>
        <source>follow the motion for so long</source>
        <translation>die Bewegung so lange verfolgen</translation>
    </message>
    <message>
        <source>seconds between samples (without it a hundredth of the motion)</source>
        <translation>Sekunden zwischen Abtastungen (sonst ein Hundertstel der Bewegung)</translation>
    </message>
    <message>
        <source>write the samples of the motion as CSV</source>
        <translation>die Abtastungen der Bewegung als CSV schreiben</translation>
    </message>
    <message>
        <source>Masses, the inertia that motors feel, and the motion that torques cause.</source>
        <translation>Massen, die Trägheit, die Motoren spüren, und die Bewegung, die Momente bewirken.</translation>
    </message>
    <message>
        <source>angle, rad</source>
        <translation>Winkel, rad</translation>
    </message>
    <message>
        <source>speed, rad/s</source>
        <translation>Drehgeschwindigkeit, rad/s</translation>
    </message>
    <message>
        <source>Motion, after %1 s</source>
        <translation>Bewegung, nach %1 s</translation>
    </message>
    <message>
        <source>kinetic energy %1 J, potential %2 J, work of motors and loads %3 J</source>
        <translation>kinetische Energie %1 J, potentielle %2 J, Arbeit von Motoren und Lasten %3 J</translation>
    </message>
    <message>
        <source>mass, kg</source>
        <translation>Masse, kg</translation>
    </message>
    <message>
        <source>at motor %1, kg m²</source>
        <translation>am Motor %1, kg m²</translation>
    </message>
    <message>
        <source>inertia, kg m²</source>
        <translation>Trägheit, kg m²</translation>
    </message>
    <message>
        <source>holding torque, N m</source>
        <translation>Haltemoment, N m</translation>
    </message>
    <message>
        <source>acceleration, rad/s²</source>
        <translation>Beschleunigung, rad/s²</translation>
    </message>
    <message>
        <source>Links, and the inertia that each has at the motors</source>
        <translation>Glieder und die Trägheit, die jedes an den Motoren hat</translation>
    </message>
    <message>
        <source>Inputs, at the start</source>
        <translation>Antriebe, am Anfang</translation>
    </message>
    <message>
        <source>Generalised inertia M, kg m²</source>
        <translation>Verallgemeinerte Trägheit M, kg m²</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;. The document has no states.</source>
        <translation>Einen Zustand „%1“ gibt es nicht. Das Dokument hat keine Zustände.</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;. States: %2.</source>
        <translation>Einen Zustand „%1“ gibt es nicht. Zustände: %2.</translation>
    </message>
    <message>
        <source>There is no coupling &quot;%1&quot;. The document has no couplings.</source>
        <translation>Ein Schaltelement „%1“ gibt es nicht. Das Dokument hat keine.</translation>
    </message>
    <message>
        <source>There is no coupling &quot;%1&quot;. Couplings: %2.</source>
        <translation>Ein Schaltelement „%1“ gibt es nicht. Schaltelemente: %2.</translation>
    </message>
    <message>
        <source>Give --state NAME or --engage A,B.</source>
        <translation>Geben Sie --state NAME oder --engage A,B an.</translation>
    </message>
    <message>
        <source>%1 (state %2)</source>
        <translation>%1 (Zustand %2)</translation>
    </message>
    <message>
        <source>with the couplings of this state engaged</source>
        <translation>mit den Schaltelementen dieses Zustands geschlossen</translation>
    </message>
    <message>
        <source>with these couplings engaged, &quot;none&quot; for no coupling, instead of those that the document engages</source>
        <translation>mit diesen Schaltelementen geschlossen, „none“ für keines, statt derer, die das Dokument schließt</translation>
    </message>
    <message>
        <source>There is no kind of question &quot;%1&quot;; geargraph-cli exercises kinds FILE lists them.</source>
        <translation>Eine Frageart „%1“ gibt es nicht; geargraph-cli exercises kinds FILE zählt sie auf.</translation>
    </message>
    <message>
        <source>The mechanism gives no question &quot;%1&quot;: %2.</source>
        <translation>Der Mechanismus gibt keine Frage „%1“ her: %2.</translation>
    </message>
    <message>
        <source>--kinds names 1 to 100 questions.</source>
        <translation>--kinds nennt 1 bis 100 Fragen.</translation>
    </message>
    <message>
        <source>--seed is a whole number from 0 on.</source>
        <translation>--seed ist eine ganze Zahl ab 0.</translation>
    </message>
    <message>
        <source>--variants is a whole number from 1 to 1000.</source>
        <translation>--variants ist eine ganze Zahl von 1 bis 1000.</translation>
    </message>
    <message>
        <source>The first word is kinds, make or grade.</source>
        <translation>Das erste Wort ist kinds, make oder grade.</translation>
    </message>
    <message>
        <source>%1 has no meaning for exercises %2.</source>
        <translation>%1 hat für exercises %2 keine Bedeutung.</translation>
    </message>
    <message>
        <source>kinds of questions, with commas; a kind may occur again (all)</source>
        <translation>Fragearten, durch Kommas getrennt; eine darf wiederkehren (alle)</translation>
    </message>
    <message>
        <source>how many different sheets, at most 1,000 (1)</source>
        <translation>wie viele verschiedene Blätter, höchstens 1.000 (1)</translation>
    </message>
    <message>
        <source>a variant for each line of this text file</source>
        <translation>eine Variante für jede Zeile dieser Textdatei</translation>
    </message>
    <message>
        <source>the heading of the sheets (&quot;Exercises&quot;)</source>
        <translation>die Überschrift der Blätter („Exercises“)</translation>
    </message>
    <message>
        <source>overwrites files in the folder</source>
        <translation>überschreibt Dateien im Ordner</translation>
    </message>
    <message>
        <source>make: the folder; grade: the CSV file (standard output)</source>
        <translation>make: der Ordner; grade: die CSV-Datei (Standardausgabe)</translation>
    </message>
    <message>
        <source>Makes exercise sheets from a mechanism and grades the answers.</source>
        <translation>Macht Aufgabenblätter aus einem Mechanismus und bewertet die Antworten.</translation>
    </message>
    <message>
        <source>(not offered: %1)</source>
        <translation>(nicht angeboten: %1)</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be read: %2.</source>
        <translation>Der Ordner „%1“ konnte nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>These are answers to another sheet.</source>
        <translation>Das sind Antworten zu einem anderen Blatt.</translation>
    </message>
    <message>
        <source>The sheet has no variant %1.</source>
        <translation>Das Blatt hat keine Variante %1.</translation>
    </message>
    <message>
        <source>Question %1 has no such field as some that are answered.</source>
        <translation>Frage %1 hat keine solchen Felder wie einige der beantworteten.</translation>
    </message>
    <message>
        <source>The question is not answered.</source>
        <translation>Die Frage ist nicht beantwortet.</translation>
    </message>
    <message>
        <source>The sheet has no question %1.</source>
        <translation>Das Blatt hat keine Frage %1.</translation>
    </message>
    <message>
        <source>grade needs a sheet and answers.</source>
        <translation>grade braucht ein Blatt und Antworten.</translation>
    </message>
    <message>
        <source>the grading</source>
        <translation>die Bewertung</translation>
    </message>
    <message>
        <source>Give --variants or --names: a name is a variant.</source>
        <translation>Geben Sie --variants oder --names an: Ein Name ist eine Variante.</translation>
    </message>
    <message>
        <source>--names is a text file of 1 to 1000 lines.</source>
        <translation>--names ist eine Textdatei mit 1 bis 1000 Zeilen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; nothing was written (--force overwrites).</source>
        <translation>„%1“ gibt es schon; es wurde nichts geschrieben (--force überschreibt).</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>Variante %1</translation>
    </message>
    <message>
        <source>make needs one file.</source>
        <translation>make braucht eine Datei.</translation>
    </message>
    <message>
        <source>make needs a folder: -o FOLDER.</source>
        <translation>make braucht einen Ordner: -o FOLDER.</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism; no sheet was written.</source>
        <translation>Zu diesem Mechanismus lässt sich nichts fragen; es wurde kein Blatt geschrieben.</translation>
    </message>
    <message>
        <source>Drawings and 3D pictures (--to svg, pdf or png --view NAME)</source>
        <translation>Zeichnungen und 3D-Bilder (--to svg, pdf oder png --view NAME)</translation>
    </message>
    <message>
        <source>3D pictures (--to png --view 3d)</source>
        <translation>3D-Bilder (--to png --view 3d)</translation>
    </message>
    <message>
        <source>Animations (--to png --view 3d)</source>
        <translation>Animationen (--to png --view 3d)</translation>
    </message>
    <message>
        <source>the file (&quot;-&quot; is standard output), or with --all the folder</source>
        <translation>die Datei („-“ ist die Standardausgabe), oder mit --all der Ordner</translation>
    </message>
    <message>
        <source>every matrix, or every picture of an animation, into the folder that -o names</source>
        <translation>jede Matrix, oder jedes Bild einer Animation, in den Ordner, den -o nennt</translation>
    </message>
    <message>
        <source>with a folder: overwrite files that are there</source>
        <translation>mit einem Ordner: vorhandene Dateien überschreiben</translation>
    </message>
    <message>
        <source>incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, tt-circuits, tt-cutsets; of statics: statics, cutset-equations, joint-torques, coupling-torques, mesh-forces, bearings, powers, circulations, and shift-torques of all states</source>
        <translation>incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, tt-circuits, tt-cutsets; zur Statik: statics, cutset-equations, joint-torques, coupling-torques, mesh-forces, bearings, powers, circulations, und shift-torques aller Zustände</translation>
    </message>
    <message>
        <source>without the header row and the first column</source>
        <translation>ohne die Kopfzeile und die erste Spalte</translation>
    </message>
    <message>
        <source>comma (the default), semicolon or tab</source>
        <translation>comma (Voreinstellung), semicolon oder tab</translation>
    </message>
    <message>
        <source>point (the default) or comma</source>
        <translation>point (Voreinstellung) oder comma</translation>
    </message>
    <message>
        <source>begin with a byte order mark, for spreadsheet programs</source>
        <translation>mit einer Byte-Reihenfolge-Marke beginnen, für Tabellenprogramme</translation>
    </message>
    <message>
        <source>with an exercise sheet that tells where an answer is wrong, and why. Saved answers are graded by exercises grade with the sheet.json of exercises make with the same options</source>
        <translation>mit einem Aufgabenblatt, das sagt, wo eine Antwort falsch ist und warum. Gespeicherte Antworten bewertet exercises grade mit der sheet.json von exercises make mit denselben Optionen</translation>
    </message>
    <message>
        <source>kinds of questions, as for exercises make (all)</source>
        <translation>Fragearten, wie bei exercises make (alle)</translation>
    </message>
    <message>
        <source>the heading of the sheet (&quot;Exercises&quot;)</source>
        <translation>die Überschrift des Blatts („Exercises“)</translation>
    </message>
    <message>
        <source>how many different sheets there are (1)</source>
        <translation>wie viele verschiedene Blätter es gibt (1)</translation>
    </message>
    <message>
        <source>which of them this is (1)</source>
        <translation>welches davon dieses ist (1)</translation>
    </message>
    <message>
        <source>digraph, ttgraph or schematic; with png and glb also 3d, the train as seen; of graphs digraph or ttgraph</source>
        <translation>digraph, ttgraph oder schematic; mit png und glb auch 3d, das Getriebe, wie man es sieht; von Graphen digraph oder ttgraph</translation>
    </message>
    <message>
        <source>pixels (as large as the drawing is; 3d: 1600x1000)</source>
        <translation>Pixel (so groß, wie die Zeichnung ist; 3d: 1600x1000)</translation>
    </message>
    <message>
        <source>on a dark ground</source>
        <translation>auf dunklem Grund</translation>
    </message>
    <message>
        <source>on no ground</source>
        <translation>ohne Grund</translation>
    </message>
    <message>
        <source>under a digraph or schematic: where the power of the loads goes, seen from &quot;ground&quot; or the link with this label</source>
        <translation>unter einem Digraphen oder Schema: wohin die Leistung der Lasten geht, gesehen von „ground“ oder dem Glied mit dieser Bezeichnung</translation>
    </message>
    <message>
        <source>front, back, left, right, top, bottom or iso</source>
        <translation>front, back, left, right, top, bottom oder iso</translation>
    </message>
    <message>
        <source>from this azimuth and elevation, degrees (-26,20)</source>
        <translation>aus diesem Azimut und dieser Höhe, Grad (-26,20)</translation>
    </message>
    <message>
        <source>how far the inputs have turned (0); also with glb</source>
        <translation>wie weit sich die Antriebe gedreht haben (0); auch mit glb</translation>
    </message>
    <message>
        <source>section perpendicular to x, y or z at this fraction of the length (y:0.5)</source>
        <translation>Schnitt senkrecht zu x, y oder z bei diesem Bruchteil der Länge (y:0.5)</translation>
    </message>
    <message>
        <source>exploded view along the axes, 0 to 1; also with glb</source>
        <translation>Explosionsansicht entlang der Achsen, 0 bis 1; auch mit glb</translation>
    </message>
    <message>
        <source>shaded, lines (hidden ones left out) or edges (all of them)</source>
        <translation>shaded, lines (verdeckte weggelassen) oder edges (alle)</translation>
    </message>
    <message>
        <source>links that are left out: 2,5; also with glb</source>
        <translation>Glieder, die weggelassen werden: 2,5; auch mit glb</translation>
    </message>
    <message>
        <source>the link that the reference frame is fixed to; also with glb</source>
        <translation>das Glied, an dem das Bezugssystem fest ist; auch mit glb</translation>
    </message>
    <message>
        <source>once round the train, as an animated PNG (or --all)</source>
        <translation>einmal um das Getriebe herum, als animiertes PNG (oder --all)</translation>
    </message>
    <message>
        <source>one period of the motion (a minute without one)</source>
        <translation>eine Periode der Bewegung (eine Minute, wo keine ist)</translation>
    </message>
    <message>
        <source>pictures a second (24)</source>
        <translation>Bilder je Sekunde (24)</translation>
    </message>
    <message>
        <source>pictures (72); with assembly: poses of every gear (24)</source>
        <translation>Bilder (72); mit assembly: Lagen jedes Rads (24)</translation>
    </message>
    <message>
        <source>one gear in its own frame: 15:tail or 15:head</source>
        <translation>ein Rad in seinem eigenen Koordinatensystem: 15:tail oder 15:head</translation>
    </message>
    <message>
        <source>the solids of one link</source>
        <translation>die Körper eines Glieds</translation>
    </message>
    <message>
        <source>with glb: how long one period plays (without: as long as it takes; of a period too long for a file, so many seconds of the motion, 60)</source>
        <translation>mit glb: wie lange eine Periode spielt (sonst: so lange sie dauert; bei einer für eine Datei zu langen so viele Sekunden der Bewegung, 60)</translation>
    </message>
    <message>
        <source>farthest chord from the exact form (0.002; of large trains as fine as 10 million triangles allow); also with assembly, step (farthest surface of a tooth, 0.001), mjcf and urdf (0.01)</source>
        <translation>größte Sehnenabweichung von der exakten Form (0.002; bei großen Getrieben so fein, wie 10 Millionen Dreiecke erlauben); auch mit assembly, step (größter Abstand der Zahnflächen, 0.001), mjcf und urdf (0.01)</translation>
    </message>
    <message>
        <source>mjcf: speed (servos with rotors, the default), torque or none</source>
        <translation>mjcf: speed (Servos mit Rotoren, Voreinstellung), torque oder none</translation>
    </message>
    <message>
        <source>mjcf: inertia of the rotors, kg m² (100 times what the input feels)</source>
        <translation>mjcf: Trägheit der Rotoren, kg m² (das Hundertfache dessen, was der Antrieb spürt)</translation>
    </message>
    <message>
        <source>mjcf: seconds (0.001)</source>
        <translation>mjcf: Sekunden (0.001)</translation>
    </message>
    <message>
        <source>SDF is not written: no current Gazebo runs its gear joints. --to urdf is read by Gazebo.</source>
        <translation>SDF wird nicht geschrieben: Kein aktuelles Gazebo führt seine Zahnradgelenke aus. --to urdf liest Gazebo.</translation>
    </message>
    <message>
        <source>-o says where to write.</source>
        <translation>-o sagt, wohin geschrieben wird.</translation>
    </message>
    <message>
        <source>Writes matrices as CSV, the worked derivation, pictures and animations, gears as 3D files, models for simulators, and graphs.</source>
        <translation>Schreibt Matrizen als CSV, die ausgearbeitete Herleitung, Bilder und Animationen, Räder als 3D-Dateien, Modelle für Simulatoren und Graphen.</translation>
    </message>
    <message>
        <source>%1 is one of %2.</source>
        <translation>%1 ist eines von %2.</translation>
    </message>
    <message>
        <source>There is no matrix &quot;%1&quot;; there are %2.</source>
        <translation>Eine Matrix „%1“ gibt es nicht; es gibt %2.</translation>
    </message>
    <message>
        <source>The matrix &quot;%1&quot; needs %2; nothing was written.</source>
        <translation>Die Matrix „%1“ braucht %2; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be made.</source>
        <translation>Der Ordner „%1“ konnte nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Left out: %1, which needs %2.</source>
        <translation>Weggelassen: %1, was %2 braucht.</translation>
    </message>
    <message>
        <source>Give --matrix NAME or --all.</source>
        <translation>Geben Sie --matrix NAME oder --all an.</translation>
    </message>
    <message>
        <source>the solution</source>
        <translation>die Lösung</translation>
    </message>
    <message>
        <source>the torques</source>
        <translation>die Momente</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>--power needs a mechanism without errors.</source>
        <translation>--power braucht einen Mechanismus ohne Fehler.</translation>
    </message>
    <message>
        <source>--power needs loads: this document has none, so that no power flows. Add &quot;loads&quot; to it.</source>
        <translation>--power braucht Lasten: Dieses Dokument hat keine, also fließt keine Leistung. Fügen Sie „loads“ hinzu.</translation>
    </message>
    <message>
        <source>--power needs balances that hold the loads.</source>
        <translation>--power braucht Ausgleichsmomente, die die Lasten halten.</translation>
    </message>
    <message>
        <source>--power needs a motion: the speeds are not determined.</source>
        <translation>--power braucht eine Bewegung: Die Drehgeschwindigkeiten sind nicht bestimmt.</translation>
    </message>
    <message>
        <source>No power flows: the loads and what holds them do no work in this motion.</source>
        <translation>Es fließt keine Leistung: Die Lasten und was sie hält leisten in dieser Bewegung keine Arbeit.</translation>
    </message>
    <message>
        <source>--power is ground or the label of a link, not &quot;%1&quot;.</source>
        <translation>--power ist ground oder die Bezeichnung eines Glieds, nicht „%1“.</translation>
    </message>
    <message>
        <source>--view 3d is made of pixels: it needs --to png.</source>
        <translation>--view 3d besteht aus Pixeln: Es braucht --to png.</translation>
    </message>
    <message>
        <source>%1 needs --view: one of %2.</source>
        <translation>%1 braucht --view: eines von %2.</translation>
    </message>
    <message>
        <source>--power is drawn in the digraph and in the schematic.</source>
        <translation>--power wird im Digraphen und im Schema gezeichnet.</translation>
    </message>
    <message>
        <source>the drawing</source>
        <translation>die Zeichnung</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>das Bild</translation>
    </message>
    <message>
        <source>A graph is the digraph or the ttgraph, not &quot;%1&quot;.</source>
        <translation>Ein Graph ist der digraph oder der ttgraph, nicht „%1“.</translation>
    </message>
    <message>
        <source>There is no T-T graph: the turning joints are no spanning tree, or a mesh has no carrier; nothing was written.</source>
        <translation>Es gibt keinen T-T-Graphen: Die Drehgelenke sind kein Spannbaum, oder ein Eingriff hat keinen Steg; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>the 3D view</source>
        <translation>die 3D-Ansicht</translation>
    </message>
    <message>
        <source>A train of %1 links has no 3D, which is made of up to %2 links.</source>
        <translation>Ein Getriebe mit %1 Gliedern hat kein 3D, das für bis zu %2 Glieder gemacht wird.</translation>
    </message>
    <message>
        <source>There is nothing to show: the turning joints are no spanning tree.</source>
        <translation>Es gibt nichts zu zeigen: Die Drehgelenke sind kein Spannbaum.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, each from %1 to %2, not &quot;%3&quot;.</source>
        <translation>--size nimmt BREITExHÖHE, beide von %1 bis %2, nicht „%3“.</translation>
    </message>
    <message>
        <source>--all writes a folder; &quot;-&quot; is none.</source>
        <translation>--all schreibt einen Ordner; „-“ ist keiner.</translation>
    </message>
    <message>
        <source>A derivation of more than %1 links is not written: it would be too long to read. The matrices are exported as CSV.</source>
        <translation>Eine Herleitung für mehr als %1 Glieder wird nicht geschrieben: Sie wäre zu lang zum Lesen. Die Matrizen lassen sich als CSV exportieren.</translation>
    </message>
    <message>
        <source>the derivation</source>
        <translation>die Herleitung</translation>
    </message>
    <message>
        <source>%1 needs --exercises.</source>
        <translation>%1 braucht --exercises.</translation>
    </message>
    <message>
        <source>%1 has no meaning with --exercises, which ask about the document.</source>
        <translation>%1 hat mit --exercises keine Bedeutung, das nach dem Dokument fragt.</translation>
    </message>
    <message>
        <source>--exercises needs a file, not standard input.</source>
        <translation>--exercises braucht eine Datei, nicht die Standardeingabe.</translation>
    </message>
    <message>
        <source>--variant is a whole number from 1 to that of --variants.</source>
        <translation>--variant ist eine ganze Zahl von 1 bis zu der von --variants.</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism.</source>
        <translation>Zu diesem Mechanismus lässt sich nichts fragen.</translation>
    </message>
    <message>
        <source>--motor is one of speed, torque, none.</source>
        <translation>--motor ist eines von speed, torque, none.</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>das Modell</translation>
    </message>
    <message>
        <source>Nothing can move; the model holds still.</source>
        <translation>Nichts kann sich bewegen; das Modell steht still.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 freedoms; joints %3 are driven.</source>
        <translation>Zustand %1 lässt %2 Freiheitsgrade; die Gelenke %3 werden angetrieben.</translation>
    </message>
    <message>
        <source>A model for simulators is a folder; &quot;-&quot; is none.</source>
        <translation>Ein Modell für Simulatoren ist ein Ordner; „-“ ist keiner.</translation>
    </message>
    <message>
        <source>There is no solution to drive the model by; nothing was written.</source>
        <translation>Es gibt keine Lösung, mit der das Modell angetrieben würde; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Models for simulators have at most %1 entries of the solution (inputs times other joints).</source>
        <translation>Modelle für Simulatoren haben höchstens %1 Einträge der Lösung (Antriebe mal andere Gelenke).</translation>
    </message>
    <message>
        <source>the folder</source>
        <translation>der Ordner</translation>
    </message>
    <message>
        <source>The train is so large that its chords are within %1 modules instead of %2 (--tolerance).</source>
        <translation>Das Getriebe ist so groß, dass seine Sehnen auf %1 Moduln genau sind statt auf %2 (--tolerance).</translation>
    </message>
    <message>
        <source>Left out: %1 of %2 gears, which cannot be made.</source>
        <translation>Weggelassen: %1 von %2 Rädern, die sich nicht herstellen lassen.</translation>
    </message>
    <message>
        <source>Only --to glb of a train or a link carries an animation.</source>
        <translation>Nur --to glb eines Getriebes oder Glieds enthält eine Animation.</translation>
    </message>
    <message>
        <source>Give --gear or --link, not both.</source>
        <translation>Geben Sie --gear oder --link an, nicht beides.</translation>
    </message>
    <message>
        <source>--to assembly writes a folder; &quot;-&quot; is none.</source>
        <translation>--to assembly schreibt einen Ordner; „-“ ist keiner.</translation>
    </message>
    <message>
        <source>There is no turning joint &quot;%1&quot;.</source>
        <translation>Ein Drehgelenk „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no turning joint &quot;%1&quot;; they are labelled %2 to %3.</source>
        <translation>Ein Drehgelenk „%1“ gibt es nicht; ihre Bezeichnungen sind %2 bis %3.</translation>
    </message>
    <message>
        <source>--inputs names joint %1 twice.</source>
        <translation>--inputs nennt Gelenk %1 zweimal.</translation>
    </message>
    <message>
        <source>--speed is like 8=1/2: a joint&apos;s label and rad/s.</source>
        <translation>--speed ist wie 8=1/2: Bezeichnung eines Gelenks und rad/s.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no speed; 1/2, 2*3 (rad/s), 1500rpm and 90deg/s are.</source>
        <translation>„%1“ ist keine Drehgeschwindigkeit; 1/2, 2*3 (rad/s), 1500rpm und 90deg/s sind welche.</translation>
    </message>
    <message>
        <source>Too many to count</source>
        <translation>Unzählbar viele</translation>
    </message>
    <message>
        <source>%1 valid set of inputs</source>
        <translation>%1 zulässiger Satz von Antrieben</translation>
    </message>
    <message>
        <source>%1 valid sets of inputs</source>
        <translation>%1 zulässige Sätze von Antrieben</translation>
    </message>
    <message>
        <source>; the first %1:</source>
        <translation>; die ersten %1:</translation>
    </message>
    <message>
        <source>(none: nothing can move)</source>
        <translation>(keine: Nichts kann sich bewegen)</translation>
    </message>
    <message>
        <source>There are over 20 million rates of joints over inputs; no sets are listed.</source>
        <translation>Es gibt über 20 Millionen Übersetzungen von Gelenken zu Antrieben; es werden keine Sätze aufgeführt.</translation>
    </message>
    <message>
        <source>--limit is a whole number.</source>
        <translation>--limit ist eine ganze Zahl.</translation>
    </message>
    <message>
        <source>the list of input sets</source>
        <translation>die Liste der Antriebssätze</translation>
    </message>
    <message>
        <source>how many sets are listed (1,000)</source>
        <translation>wie viele Sätze aufgeführt werden (1.000)</translation>
    </message>
    <message>
        <source>Counts and lists the valid sets of inputs.</source>
        <translation>Zählt die zulässigen Sätze von Antrieben und führt sie auf.</translation>
    </message>
    <message>
        <source>1 step, no faults</source>
        <translation>1 Schritt, keine Fehler</translation>
    </message>
    <message>
        <source>%1 steps, no faults</source>
        <translation>%1 Schritte, keine Fehler</translation>
    </message>
    <message>
        <source>check needs a file.</source>
        <translation>check braucht eine Datei.</translation>
    </message>
    <message>
        <source>%1 lessons, %2 min</source>
        <translation>%1 Lektionen, %2 min</translation>
    </message>
    <message>
        <source>The first word is check, list or make.</source>
        <translation>Das erste Wort ist check, list oder make.</translation>
    </message>
    <message>
        <source>the findings as JSON</source>
        <translation>die Befunde als JSON</translation>
    </message>
    <message>
        <source>Checks lessons: their form, answers and reasons; lists those of the program; makes pages of them.</source>
        <translation>Prüft Lektionen: ihre Form, Antworten und Begründungen; zählt die des Programms auf; macht Seiten daraus.</translation>
    </message>
    <message>
        <source>A train of %1 links has no 3D, which is made of up to %2 links; --gear and --link export a part of it. Nothing was written.</source>
        <translation>Ein Getriebe mit %1 Gliedern hat kein 3D, das für bis zu %2 Glieder gemacht wird; --gear und --link exportieren einen Teil. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>A train of %1 gears (over %2): wheels are plain discs, shafts and arms are straight and pass through other parts.</source>
        <translation>Ein Getriebe mit %1 Rädern (über %2): Räder sind glatte Scheiben, Wellen und Arme sind gerade und gehen durch andere Teile hindurch.</translation>
    </message>
    <message>
        <source>%1; nothing was written.</source>
        <translation>%1; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>%1; choose a coarser --tolerance.</source>
        <translation>%1; wählen Sie eine gröbere --tolerance.</translation>
    </message>
    <message>
        <source>Exit status: 0 fine (warnings allowed), 1 the mechanism has errors, 2 wrong usage or a file that could not be read or
written, 3 out of a stated resource limit. &quot;-&quot; is standard input or output.</source>
        <translation>Exit-Status: 0 in Ordnung (Warnungen erlaubt), 1 der Mechanismus hat Fehler, 2 falscher Aufruf oder eine Datei, die nicht gelesen oder
geschrieben werden konnte, 3 eine angegebene Grenze überschritten. „-“ ist die Standardein- oder -ausgabe.</translation>
    </message>
    <message>
        <source>geargraph-cli: the analysis of geared mechanisms, without a window.</source>
        <translation>geargraph-cli: die Analyse von Getriebemechanismen, ohne Fenster.</translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation>Befehle:</translation>
    </message>
    <message>
        <source>--help, --version and --language en|de|tr|es (that of the environment) work on every command.</source>
        <translation>--help, --version und --language en|de|tr|es (die der Umgebung) gehen bei jedem Befehl.</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;.</source>
        <translation>Einen Befehl „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>The memory does not suffice for this mechanism.</source>
        <translation>Der Speicher reicht für diesen Mechanismus nicht aus.</translation>
    </message>
    <message>
        <source>It needs -o with a folder.</source>
        <translation>Es braucht -o mit einem Ordner.</translation>
    </message>
    <message>
        <source>It reads no file.</source>
        <translation>Es liest keine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; --force overwrites it.</source>
        <translation>„%1“ gibt es schon; --force überschreibt es.</translation>
    </message>
    <message>
        <source>%1 files in %2</source>
        <translation>%1 Dateien in %2</translation>
    </message>
    <message>
        <source>the folder that the pages are written to</source>
        <translation>der Ordner, in den die Seiten geschrieben werden</translation>
    </message>
    <message>
        <source>overwrite files that are there</source>
        <translation>vorhandene Dateien überschreiben</translation>
    </message>
    <message>
        <source>Writes the manual of the program as web pages, with its pictures.</source>
        <translation>Schreibt das Handbuch des Programms als Webseiten, mit seinen Bildern.</translation>
    </message>
    <message>
        <source>--density is above 0, in kg/m³, not &quot;%1&quot;.</source>
        <translation>--density ist größer als 0, in kg/m³, nicht „%1“.</translation>
    </message>
    <message>
        <source>--gravity is like 0,0,-9.81, in m/s², not &quot;%1&quot;.</source>
        <translation>--gravity ist wie 0,0,-9.81, in m/s², nicht „%1“.</translation>
    </message>
    <message>
        <source>acceleration of free fall, m/s², instead of the document&apos;s</source>
        <translation>Fallbeschleunigung, m/s², statt der des Dokuments</translation>
    </message>
    <message>
        <source>of all solids, kg/m³, instead of the document&apos;s</source>
        <translation>aller Körper, kg/m³, statt der des Dokuments</translation>
    </message>
    <message>
        <source>%1 takes a number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1 nimmt eine Zahl von %2 bis %3, nicht „%4“.</translation>
    </message>
    <message>
        <source>%1 is like 8=30deg, 8=1/2rad or 8=2turns: an input&apos;s label and its angle.</source>
        <translation>%1 ist wie 8=30deg, 8=1/2rad oder 8=2turns: Bezeichnung eines Antriebs und sein Winkel.</translation>
    </message>
    <message>
        <source>%1 needs the unit of its angle: %2deg or %2rad.</source>
        <translation>%1 braucht die Einheit des Winkels: %2deg oder %2rad.</translation>
    </message>
    <message>
        <source>The angle %1 is too large: no program could represent it, the largest number is 1.79e308. Leave out whole turns.</source>
        <translation>Der Winkel %1 ist zu groß: Kein Programm könnte ihn darstellen, die größte Zahl ist 1.79e308. Lassen Sie ganze Umdrehungen weg.</translation>
    </message>
    <message>
        <source>%1 deg</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>joint %1 at %2 is beyond its limits (%3, %4)</source>
        <translation>Gelenk %1 liegt bei %2 jenseits seiner Anschläge (%3, %4)</translation>
    </message>
    <message>
        <source>%1 turned by %2 deg</source>
        <translation>%1 um %2 Grad gedreht</translation>
    </message>
    <message>
        <source>Links, against the reference pose: turned, and where the point went that was at the origin</source>
        <translation>Glieder gegen die Bezugslage: gedreht, und wohin der Punkt ging, der im Ursprung war</translation>
    </message>
    <message>
        <source>%1 by %2 deg about %3 to %4</source>
        <translation>%1 um %2 Grad um %3 nach %4</translation>
    </message>
    <message>
        <source>the pose</source>
        <translation>die Lage</translation>
    </message>
    <message>
        <source>the angle of an input (deg, rad or turns; without it 0); may be repeated</source>
        <translation>der Winkel eines Antriebs (deg, rad oder turns; sonst 0); darf wiederholt werden</translation>
    </message>
    <message>
        <source>Says where every link is for given angles of the inputs.</source>
        <translation>Sagt, wo jedes Glied bei gegebenen Winkeln der Antriebe ist.</translation>
    </message>
    <message>
        <source>requests on standard input, answers on standard output</source>
        <translation>Anfragen auf der Standardeingabe, Antworten auf der Standardausgabe</translation>
    </message>
    <message>
        <source>Methods and their params; those in [ ] may be left out:</source>
        <translation>Methoden und ihre params; die in [ ] dürfen fehlen:</translation>
    </message>
    <message>
        <source>Edits and their members beside &quot;edit&quot;; null removes what may be left out:</source>
        <translation>Änderungen und ihre Mitglieder neben „edit“; null entfernt, was fehlen darf:</translation>
    </message>
    <message>
        <source>of address space, for each command</source>
        <translation>Adressraum, für jeden Befehl</translation>
    </message>
    <message>
        <source>Answers requests, a JSON object a line: open, edit, analyze, export, ...</source>
        <translation>Beantwortet Anfragen, ein JSON-Objekt je Zeile: open, edit, analyze, export, ...</translation>
    </message>
    <message>
        <source>rank r = %1, degrees of freedom E = t - r = %2</source>
        <translation>Rang r = %1, Freiheitsgrade E = t - r = %2</translation>
    </message>
    <message>
        <source>rank r = %1 (%3 of the meshes + %4 of the couplings), degrees of freedom E = t - r = %2</source>
        <translation>Rang r = %1 (%3 der Eingriffe + %4 der Schaltelemente), Freiheitsgrade E = t - r = %2</translation>
    </message>
    <message>
        <source>(Kutzbach counts %1)</source>
        <translation>(Kutzbach zählt %1)</translation>
    </message>
    <message>
        <source>Carriers of the gear pairs, by their transfer vertices</source>
        <translation>Stege der Räderpaare, nach ihren Transferknoten</translation>
    </message>
    <message>
        <source>axes %1, %2</source>
        <translation>Achsen %1, %2</translation>
    </message>
    <message>
        <source>Rates of the outputs over those of the inputs, Eq. (23)</source>
        <translation>Drehgeschwindigkeiten der Abtriebe über denen der Antriebe, Gl. (23)</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>inputs, chosen because the file names none:</source>
        <translation>Antriebe, gewählt, weil die Datei keine nennt:</translation>
    </message>
    <message>
        <source>%1 at %2 rad/s</source>
        <translation>%1 mit %2 rad/s</translation>
    </message>
    <message>
        <source>not driven, because engaged couplings decide:</source>
        <translation>nicht angetrieben, weil geschlossene Schaltelemente bestimmen:</translation>
    </message>
    <message>
        <source>%1 outputs over %2 inputs: too large to print; see --json</source>
        <translation>%1 Abtriebe über %2 Antrieben: zu groß zum Drucken; siehe --json</translation>
    </message>
    <message>
        <source>The matroid method and the T-T graph method agree exactly.</source>
        <translation>Die Matroid-Methode und die T-T-Graph-Methode stimmen exakt überein.</translation>
    </message>
    <message>
        <source>The two methods differ by up to %1.</source>
        <translation>Die beiden Methoden unterscheiden sich um bis zu %1.</translation>
    </message>
    <message>
        <source>in the gear ratios</source>
        <translation>in den Übersetzungen</translation>
    </message>
    <message>
        <source>State %1: it names no drive and driven link, so it has no ratio.</source>
        <translation>Zustand %1: Er nennt weder Antrieb noch Abtrieb, also hat er keine Übersetzung.</translation>
    </message>
    <message>
        <source>State %1: the driven link does not move.</source>
        <translation>Zustand %1: Der Abtrieb bewegt sich nicht.</translation>
    </message>
    <message>
        <source>State %1: the driven link turns about several directions at once.</source>
        <translation>Zustand %1: Der Abtrieb dreht sich um mehrere Richtungen zugleich.</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation>Mechanismus</translation>
    </message>
    <message>
        <source>%1: no states</source>
        <translation>%1: keine Zustände</translation>
    </message>
    <message>
        <source>%1: 1 state</source>
        <translation>%1: 1 Zustand</translation>
    </message>
    <message>
        <source>%1: %2 states</source>
        <translation>%1: %2 Zustände</translation>
    </message>
    <message>
        <source>the shift table</source>
        <translation>die Schalttabelle</translation>
    </message>
    <message>
        <source>The shift table: what each state of the brakes and clutches does.</source>
        <translation>Die Schalttabelle: was jeder Zustand der Bremsen und Kupplungen bewirkt.</translation>
    </message>
    <message>
        <source>Give --state NAME, --all-states or --engage A,B.</source>
        <translation>Geben Sie --state NAME, --all-states oder --engage A,B an.</translation>
    </message>
    <message>
        <source>of every state</source>
        <translation>jedes Zustands</translation>
    </message>
    <message>
        <source>joint:14=10Nm, link:3@e=10Nm or link:3=10,-20,-50N@30,-60,130, added</source>
        <translation>joint:14=10Nm, link:3@e=10Nm oder link:3=10,-20,-50N@30,-60,130, zusätzlich</translation>
    </message>
    <message>
        <source>without the loads of the document</source>
        <translation>ohne die Lasten des Dokuments</translation>
    </message>
    <message>
        <source>joint:8 or link:7@a: find the torque there; may be given again</source>
        <translation>joint:8 oder link:7@a: das Moment dort bestimmen; darf mehrmals stehen</translation>
    </message>
    <message>
        <source>the speed of an input in rad/s; may be given again</source>
        <translation>die Drehgeschwindigkeit eines Antriebs in rad/s; darf mehrmals stehen</translation>
    </message>
    <message>
        <source>with the losses of the meshes</source>
        <translation>mit den Verlusten der Eingriffe</translation>
    </message>
    <message>
        <source>efficiency of meshes that state none; implies --efficiency</source>
        <translation>Wirkungsgrad von Eingriffen, die keinen angeben; schließt --efficiency ein</translation>
    </message>
    <message>
        <source>loads that several meshes share: left open, or by equal stiffness</source>
        <translation>Lasten, die mehrere Eingriffe teilen: offen gelassen, oder nach gleicher Steifigkeit</translation>
    </message>
    <message>
        <source>without the solution in gear ratios</source>
        <translation>ohne die Lösung in Übersetzungen</translation>
    </message>
    <message>
        <source>Torques, tooth forces, bearing reactions and efficiency under loads.</source>
        <translation>Momente, Zahnkräfte, Lagerreaktionen und Wirkungsgrad unter Lasten.</translation>
    </message>
    <message>
        <source>%1 is on joint:LABEL, link:LABEL or link:LABEL@AXIS, not &quot;%2&quot;.</source>
        <translation>%1 steht in joint:LABEL, link:LABEL oder link:LABEL@AXIS, nicht „%2“.</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot;.</source>
        <translation>Ein Glied „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>The ground takes any load: name a moving link.</source>
        <translation>Das Gestell nimmt jede Last auf: Nennen Sie ein bewegtes Glied.</translation>
    </message>
    <message>
        <source>There is no axis &quot;%1&quot;.</source>
        <translation>Eine Achse „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no load: 10Nm, 1/2kNm, 3lbf ft and 2kW@1500rpm are torques, and 10,-20,-50N@30,-60,130 is a force on a link at a point.</source>
        <translation>„%1“ ist keine Last: 10Nm, 1/2kNm, 3lbf ft und 2kW@1500rpm sind Momente, und 10,-20,-50N@30,-60,130 ist eine Kraft auf ein Glied in einem Punkt.</translation>
    </message>
    <message>
        <source>--balance names &quot;%1&quot; twice.</source>
        <translation>--balance nennt „%1“ zweimal.</translation>
    </message>
    <message>
        <source>--eta is an efficiency, above 0 and at most 1.</source>
        <translation>--eta ist ein Wirkungsgrad, größer als 0 und höchstens 1.</translation>
    </message>
    <message>
        <source>--share is one of none, stiffness.</source>
        <translation>--share ist eines von none, stiffness.</translation>
    </message>
    <message>
        <source>Give --state NAME or --all-states.</source>
        <translation>Geben Sie --state NAME oder --all-states an.</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;.</source>
        <translation>Einen Zustand „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>power, W</source>
        <translation>Leistung, W</translation>
    </message>
    <message>
        <source>shared</source>
        <translation>geteilt</translation>
    </message>
    <message>
        <source>Balances and couplings</source>
        <translation>Ausgleichsmomente und Schaltelemente</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Eingriff</translation>
    </message>
    <message>
        <source>torque on tail, N m</source>
        <translation>Moment auf Fuß, N m</translation>
    </message>
    <message>
        <source>on head, N m</source>
        <translation>auf Spitze, N m</translation>
    </message>
    <message>
        <source>force on head, N</source>
        <translation>Kraft auf Spitze, N</translation>
    </message>
    <message>
        <source>Meshes (torques about the axes from the carrier)</source>
        <translation>Eingriffe (Momente um die Achsen, vom Steg aus)</translation>
    </message>
    <message>
        <source>force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>moment, N m</source>
        <translation>Moment, N m</translation>
    </message>
    <message>
        <source>at</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Bearings (tail on head, base frame)</source>
        <translation>Lager (Fuß auf Spitze, Basissystem)</translation>
    </message>
    <message>
        <source>Power fed %1 W, taken %2 W, lost %3 W</source>
        <translation>Leistung zugeführt %1 W, entnommen %2 W, verloren %3 W</translation>
    </message>
    <message>
        <source>Passed by the meshes, seen from their carriers, over the power fed: %1</source>
        <translation>Von den Eingriffen übertragen, von ihren Stegen aus gesehen, durch die zugeführte Leistung: %1</translation>
    </message>
    <message>
        <source>Efficiency %1</source>
        <translation>Wirkungsgrad %1</translation>
    </message>
    <message>
        <source>Efficiency backward %1</source>
        <translation>Wirkungsgrad rückwärts %1</translation>
    </message>
    <message>
        <source>The output cannot drive it back: it locks itself.</source>
        <translation>Der Abtrieb kann es nicht zurücktreiben: Es ist selbsthemmend.</translation>
    </message>
    <message>
        <source>Both methods agree.</source>
        <translation>Beide Methoden stimmen überein.</translation>
    </message>
    <message>
        <source>The methods do NOT agree.</source>
        <translation>Die Methoden stimmen NICHT überein.</translation>
    </message>
    <message>
        <source>%1, state %2</source>
        <translation>%1, Zustand %2</translation>
    </message>
    <message>
        <source>There is no equilibrium.</source>
        <translation>Es gibt kein Gleichgewicht.</translation>
    </message>
    <message>
        <source>Files or folders are needed.</source>
        <translation>Dateien oder Ordner werden gebraucht.</translation>
    </message>
    <message>
        <source>--jobs is a whole number from 1 to 256.</source>
        <translation>--jobs ist eine ganze Zahl von 1 bis 256.</translation>
    </message>
    <message>
        <source>the summary</source>
        <translation>die Übersicht</translation>
    </message>
    <message>
        <source>how many files are analysed at once (as many as there are processors)</source>
        <translation>wie viele Dateien zugleich analysiert werden (so viele, wie es Prozessoren gibt)</translation>
    </message>
    <message>
        <source>the file (standard output without it)</source>
        <translation>die Datei (sonst die Standardausgabe)</translation>
    </message>
    <message>
        <source>A row for each file, or for each document in a folder, as CSV.</source>
        <translation>Eine Zeile für jede Datei, oder für jedes Dokument in einem Ordner, als CSV.</translation>
    </message>
    <message>
        <source>give up after this time (exit status 3); nothing is written then</source>
        <translation>nach dieser Zeit aufgeben (Exit-Status 3); dann wird nichts geschrieben</translation>
    </message>
    <message>
        <source>--limit-seconds takes a number of seconds above 0, up to 1000000, not &quot;%1&quot;.</source>
        <translation>--limit-seconds nimmt eine Zahl von Sekunden über 0, bis 1000000, nicht „%1“.</translation>
    </message>
    <message>
        <source>The limit of %1 s was over before %2 was finished; nothing was written.</source>
        <translation>Die Grenze von %1 s war erreicht, bevor dies fertig war: %2; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>the validation</source>
        <translation>die Prüfung der Datei</translation>
    </message>
    <message>
        <source>%1: no problems</source>
        <translation>%1: keine Probleme</translation>
    </message>
    <message>
        <source>also look for links that collide while the inputs run at their speeds</source>
        <translation>auch nach Gliedern suchen, die zusammenstoßen, während die Antriebe mit ihren Drehgeschwindigkeiten laufen</translation>
    </message>
    <message>
        <source>Says what is wrong with a file.</source>
        <translation>Sagt, was an einer Datei falsch ist.</translation>
    </message>
    <message>
        <source>Give --from or --camera, not both.</source>
        <translation>Geben Sie --from oder --camera an, nicht beides.</translation>
    </message>
    <message>
        <source>--from is one of front, back, left, right, top, bottom, iso.</source>
        <translation>--from ist eines von front, back, left, right, top, bottom, iso.</translation>
    </message>
    <message>
        <source>--camera takes AZIMUTH,ELEVATION in degrees, up to 360 and 90, not &quot;%1&quot;.</source>
        <translation>--camera nimmt AZIMUT,HÖHE in Grad, bis 360 und 90, nicht „%1“.</translation>
    </message>
    <message>
        <source>--time takes seconds, not &quot;%1&quot;.</source>
        <translation>--time nimmt Sekunden, nicht „%1“.</translation>
    </message>
    <message>
        <source>--explode takes a part from 0 to 1, not &quot;%1&quot;.</source>
        <translation>--explode nimmt einen Anteil von 0 bis 1, nicht „%1“.</translation>
    </message>
    <message>
        <source>--section takes x, y or z, and how far along from 0 to 1: y:0.5, not &quot;%1&quot;.</source>
        <translation>--section nimmt x, y oder z, und wie weit entlang von 0 bis 1: y:0.5, nicht „%1“.</translation>
    </message>
    <message>
        <source>--faces is one of shaded, lines, edges.</source>
        <translation>--faces ist eines von shaded, lines, edges.</translation>
    </message>
    <message>
        <source>Give --turntable or --motion, not both.</source>
        <translation>Geben Sie --turntable oder --motion an, nicht beides.</translation>
    </message>
    <message>
        <source>--frames takes a whole number from 2 to %1, not &quot;%2&quot;.</source>
        <translation>--frames nimmt eine ganze Zahl von 2 bis %1, nicht „%2“.</translation>
    </message>
    <message>
        <source>--fps takes pictures a second from 0.1 to 100, not &quot;%1&quot;.</source>
        <translation>--fps nimmt Bilder je Sekunde von 0.1 bis 100, nicht „%1“.</translation>
    </message>
    <message>
        <source>Links %1 and %2 overlap in the reference pose: give them clearance.</source>
        <translation>Glieder %1 und %2 überschneiden sich in der Bezugslage: Geben Sie ihnen Abstand.</translation>
    </message>
    <message>
        <source>Links %1 and %2 collide %3, with %4. Give them clearance, or limit joints.</source>
        <translation>Glieder %1 und %2 stoßen %3 zusammen, mit %4. Geben Sie ihnen Abstand, oder begrenzen Sie Gelenke.</translation>
    </message>
    <message>
        <source>after %1 of the motion backwards</source>
        <translation>nach %1 der Bewegung rückwärts</translation>
    </message>
    <message>
        <source>after %1 of the motion</source>
        <translation>nach %1 der Bewegung</translation>
    </message>
    <message>
        <source>%1 at %2 deg</source>
        <translation>%1 bei %2 Grad</translation>
    </message>
    <message>
        <source>joints %1</source>
        <translation>Gelenken %1</translation>
    </message>
    <message>
        <source>(Only part of the motion was checked.)</source>
        <translation>(Nur ein Teil der Bewegung wurde geprüft.)</translation>
    </message>
    <message>
        <source>(Checked for the first %1: the motion does not repeat sooner.)</source>
        <translation>(Geprüft über die ersten %1: Die Bewegung wiederholt sich nicht früher.)</translation>
    </message>
    <message>
        <source>(Checked until the motion repeats.)</source>
        <translation>(Geprüft, bis die Bewegung sich wiederholt.)</translation>
    </message>
    <message>
        <source>(Checked between the limits of the joints, from %1 to %2.)</source>
        <translation>(Geprüft zwischen den Anschlägen der Gelenke, von %1 bis %2.)</translation>
    </message>
    <message>
        <source>(1 more pair of links collides later.)</source>
        <translation>(1 weiteres Gliederpaar stößt später zusammen.)</translation>
    </message>
    <message>
        <source>(%1 more pairs of links collide later.)</source>
        <translation>(%1 weitere Gliederpaare stoßen später zusammen.)</translation>
    </message>
    <message>
        <source>The motion of more than %1 links is not checked for collisions.</source>
        <translation>Die Bewegung von mehr als %1 Gliedern wird nicht auf Zusammenstöße geprüft.</translation>
    </message>
    <message>
        <source>Only part of the motion was checked for collisions: too many parts come close to each other.</source>
        <translation>Nur ein Teil der Bewegung wurde auf Zusammenstöße geprüft: Zu viele Teile kommen einander nahe.</translation>
    </message>
    <message>
        <source>The motion was checked for collisions for its first %1: it does not repeat sooner.</source>
        <translation>Die Bewegung wurde über ihre ersten %1 auf Zusammenstöße geprüft: Sie wiederholt sich nicht früher.</translation>
    </message>
    <message>
        <source>Stop driving %1</source>
        <translation>%1 nicht mehr antreiben</translation>
    </message>
    <message>
        <source>Drive %1 too</source>
        <translation>Auch %1 antreiben</translation>
    </message>
    <message>
        <source>Exchange input %1 for %2</source>
        <translation>Antrieb %1 gegen %2 tauschen</translation>
    </message>
    <message>
        <source>Choose the inputs for me</source>
        <translation>Antriebe für mich wählen</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2</source>
        <translation>%1 Zähne an Rad %2 verwenden</translation>
    </message>
    <message>
        <source>Make %1 external</source>
        <translation>%1 außenverzahnt machen</translation>
    </message>
    <message>
        <source>Make %1 internal</source>
        <translation>%1 innenverzahnt machen</translation>
    </message>
    <message>
        <source>Make %1 bevel</source>
        <translation>%1 zu Kegelrädern machen</translation>
    </message>
    <message>
        <source>Let the pitch point follow from axes and teeth</source>
        <translation>Wälzpunkt aus Achsen und Zähnezahlen folgen lassen</translation>
    </message>
    <message>
        <source>Let pitch point and kind follow from the axes</source>
        <translation>Wälzpunkt und Art aus den Achsen folgen lassen</translation>
    </message>
    <message>
        <source>Give each its own axis</source>
        <translation>Jedem seine eigene Achse geben</translation>
    </message>
    <message>
        <source>Move %1 along its axis to %2 %3</source>
        <translation>%1 auf der Achse nach %2 %3 schieben</translation>
    </message>
    <message>
        <source>Use %1 teeth on the ring and %2 on the planets</source>
        <translation>%1 Zähne am Hohlrad und %2 an den Planeten verwenden</translation>
    </message>
    <message>
        <source>Use %1 teeth on the sun and %2 on the planets</source>
        <translation>%1 Zähne an der Sonne und %2 an den Planeten verwenden</translation>
    </message>
    <message>
        <source>Use twice the teeth everywhere</source>
        <translation>Überall doppelt so viele Zähne verwenden</translation>
    </message>
    <message>
        <source>Use three times the teeth everywhere</source>
        <translation>Überall dreimal so viele Zähne verwenden</translation>
    </message>
    <message>
        <source>Use four times the teeth everywhere</source>
        <translation>Überall viermal so viele Zähne verwenden</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2 of %3</source>
        <translation>%1 Zähne an Rad %2 von %3 verwenden</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2 and %3 on gear %4</source>
        <translation>%1 Zähne an Rad %2 und %3 an Rad %4 verwenden</translation>
    </message>
    <message>
        <source>Use %1 equally spaced planets</source>
        <translation>%1 gleichmäßig verteilte Planeten verwenden</translation>
    </message>
    <message>
        <source>Tie link %1 to the ground</source>
        <translation>Glied %1 mit dem Gestell verbinden</translation>
    </message>
    <message>
        <source>Tie links %1 to the ground</source>
        <translation>Glieder %1 mit dem Gestell verbinden</translation>
    </message>
    <message>
        <source>Delete the loose links</source>
        <translation>Die losen Glieder löschen</translation>
    </message>
    <message>
        <source>, a second bearing on axis %1</source>
        <translation>, ein zweites Lager auf Achse %1</translation>
    </message>
    <message>
        <source>The pinions do not go in evenly: twice the side wheels&apos; teeth, %1, has to be a multiple of %2.</source>
        <translation>Die Ausgleichsräder lassen sich nicht gleichmäßig einsetzen: Die doppelte Zähnezahl der Achswellenräder, %1, muss ein Vielfaches von %2 sein.</translation>
    </message>
    <message>
        <source>There is no such link.</source>
        <translation>Ein solches Glied gibt es nicht.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: a planet turns on its carrier and carries nothing.</source>
        <translation>Glied %1 ist kein Planet: Ein Planet dreht sich auf seinem Steg und trägt nichts.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: one of its meshes does not fit its axes.</source>
        <translation>Glied %1 ist kein Planet: Einer seiner Eingriffe passt nicht zu seinen Achsen.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: its meshes are with wheels on several axes.</source>
        <translation>Glied %1 ist kein Planet: Seine Eingriffe sind mit Rädern auf mehreren Achsen.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: what it turns on does not carry the axis of what it meshes with.</source>
        <translation>Glied %1 ist kein Planet: Worauf es sich dreht, trägt nicht die Achse dessen, womit es kämmt.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: it meshes with nothing.</source>
        <translation>Glied %1 ist kein Planet: Es kämmt mit nichts.</translation>
    </message>
    <message>
        <source>%1 planets cannot be put in evenly.</source>
        <translation>%1 Planeten lassen sich nicht gleichmäßig einsetzen.</translation>
    </message>
    <message>
        <source>Short and long planet cannot touch each other: small sun + short planet and large sun + long planet differ by more than short + long planet. What fits: sums that are nearer.</source>
        <translation>Kurzer und langer Planet können einander nicht berühren: Kleine Sonne + kurzer Planet und große Sonne + langer Planet unterscheiden sich um mehr als kurzer + langer Planet. Es passen Summen, die näher beieinanderliegen.</translation>
    </message>
    <message>
        <source>The long planets, which extend through both planes, interfere with the small sun. What fits: a large sun with at least 4 teeth more than the small one.</source>
        <translation>Die langen Planeten, die durch beide Ebenen reichen, überschneiden die kleine Sonne. Es passt eine große Sonne mit mindestens 4 Zähnen mehr als die kleine.</translation>
    </message>
    <message>
        <source>The planets collide. What fits: fewer pairs, smaller planets, or a larger ring.</source>
        <translation>Die Planeten stoßen aneinander. Es passen weniger Paare, kleinere Planeten oder ein größeres Hohlrad.</translation>
    </message>
    <message>
        <source>The pairs do not go in evenly: ring + large sun = %1 and ring - small sun = %2 have to be multiples of %3.</source>
        <translation>Die Paare lassen sich nicht gleichmäßig einsetzen: Hohlrad + große Sonne = %1 und Hohlrad - kleine Sonne = %2 müssen Vielfache von %3 sein.</translation>
    </message>
    <message>
        <source>The planets do not go in evenly: sun + ring = %1 has to be a multiple of %2.</source>
        <translation>Die Planeten lassen sich nicht gleichmäßig einsetzen: Sonne + Hohlrad = %1 muss ein Vielfaches von %2 sein.</translation>
    </message>
    <message>
        <source>The planets collide. What fits: fewer or smaller planets, or a larger sun.</source>
        <translation>Die Planeten stoßen aneinander. Es passen weniger oder kleinere Planeten oder eine größere Sonne.</translation>
    </message>
    <message>
        <source>The quote that begins here is never closed.</source>
        <translation>Das Anführungszeichen, das hier beginnt, wird nie geschlossen.</translation>
    </message>
    <message>
        <source>A field ends with its closing quote; a quote inside a field is written twice.</source>
        <translation>Ein Feld endet mit seinem schließenden Anführungszeichen; eines im Feld wird doppelt geschrieben.</translation>
    </message>
    <message>
        <source>A field with a quote in it is quoted as a whole, and the quote written twice.</source>
        <translation>Ein Feld mit einem Anführungszeichen steht als Ganzes in Anführungszeichen, und das innere doppelt.</translation>
    </message>
    <message>
        <source>These bytes are not UTF-8.</source>
        <translation>Diese Bytes sind kein UTF-8.</translation>
    </message>
    <message>
        <source>Standard input could not be read: %1.</source>
        <translation>Die Standardeingabe konnte nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>%1 konnte nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>%1 could not be written: it is a folder.</source>
        <translation>%1 konnte nicht geschrieben werden: Es ist ein Ordner.</translation>
    </message>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>%1 konnte nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>; what should be in it is kept in %1</source>
        <translation>; was darin stehen sollte, ist in %1 aufbewahrt</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be made: %2.</source>
        <translation>Der Ordner „%1“ konnte nicht angelegt werden: %2.</translation>
    </message>
    <message>
        <source>Stopped; the folder is not complete.</source>
        <translation>Angehalten; der Ordner ist unvollständig.</translation>
    </message>
    <message>
        <source>there is a file of that name</source>
        <translation>es gibt eine Datei dieses Namens</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; nothing was written.</source>
        <translation>„%1“ gibt es schon; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The file is far too large.</source>
        <translation>Die Datei ist viel zu groß.</translation>
    </message>
    <message>
        <source>expected the end of the file after the outermost value</source>
        <translation>erwartet: das Ende der Datei nach dem äußersten Wert</translation>
    </message>
    <message>
        <source>expected a value</source>
        <translation>erwartet: ein Wert</translation>
    </message>
    <message>
        <source>lists and objects are nested deeper than %1</source>
        <translation>Listen und Objekte sind tiefer als %1 verschachtelt</translation>
    </message>
    <message>
        <source>expected a digit of a number</source>
        <translation>erwartet: eine Ziffer einer Zahl</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;]&apos; in a list</source>
        <translation>erwartet: „,“ oder „]“ in einer Liste</translation>
    </message>
    <message>
        <source>expected a member name in double quotes</source>
        <translation>erwartet: ein Mitgliedsname in doppelten Anführungszeichen</translation>
    </message>
    <message>
        <source>expected &apos;:&apos; after a member name</source>
        <translation>erwartet: „:“ nach einem Mitgliedsnamen</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;}&apos; in an object</source>
        <translation>erwartet: „,“ oder „}“ in einem Objekt</translation>
    </message>
    <message>
        <source>expected the closing quote of a string</source>
        <translation>erwartet: das schließende Anführungszeichen einer Zeichenkette</translation>
    </message>
    <message>
        <source>expected the closing quote of a string, or an escape such as \n</source>
        <translation>erwartet: das schließende Anführungszeichen einer Zeichenkette oder eine Escape-Folge wie \n</translation>
    </message>
    <message>
        <source>expected a character in UTF-8</source>
        <translation>erwartet: ein Zeichen in UTF-8</translation>
    </message>
    <message>
        <source>expected an escape that JSON knows (\&quot; \\ \/ \b \f \n \r \t \u)</source>
        <translation>erwartet: eine Escape-Folge, die JSON kennt (\&quot; \\ \/ \b \f \n \r \t \u)</translation>
    </message>
    <message>
        <source>expected four hexadecimal digits after \u</source>
        <translation>erwartet: vier Hexadezimalziffern nach \u</translation>
    </message>
    <message>
        <source>expected no second half of a surrogate pair here</source>
        <translation>erwartet: hier keine zweite Hälfte eines Surrogatpaars</translation>
    </message>
    <message>
        <source>expected both halves of a surrogate pair</source>
        <translation>erwartet: beide Hälften eines Surrogatpaars</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>the byte 0x%1</source>
        <translation>das Byte 0x%1</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3, found %4.</source>
        <translation>Zeile %1, Spalte %2: %3, gefunden: %4.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3.</source>
        <translation>Zeile %1, Spalte %2: %3.</translation>
    </message>
    <message>
        <source>Links %1 overlap in 3D: move their joints along the axes, leave pitch points open, or change the tooth counts.</source>
        <translation>Glieder %1 überschneiden sich in 3D: Verschieben Sie ihre Gelenke entlang der Achsen, lassen Sie Wälzpunkte offen oder ändern Sie die Zähnezahlen.</translation>
    </message>
    <message>
        <source>Links %1 overlap in 3D: move their joints along the axes, or change the tooth counts.</source>
        <translation>Glieder %1 überschneiden sich in 3D: Verschieben Sie ihre Gelenke entlang der Achsen, oder ändern Sie die Zähnezahlen.</translation>
    </message>
    <message>
        <source>The rim of %1 does not reach past the roots of the ring&apos;s %2 teeth: make it larger than %3.</source>
        <translation>Der Kranz von %1 reicht nicht über die Zahnfüße der %2 Zähne des Hohlrads hinaus: Machen Sie ihn größer als %3.</translation>
    </message>
    <message>
        <source>The bore of %1 leaves no body below the roots of %2 teeth: make it smaller than %3.</source>
        <translation>Die Bohrung von %1 lässt unter den Zahnfüßen von %2 Zähnen keinen Körper übrig: Machen Sie sie kleiner als %3.</translation>
    </message>
    <message>
        <source>A gear of %1 teeth has a measure that no tooth can have; module and face width must be positive, the pressure angle between 5 and 35 degrees, shift and heights at most 3 modules.</source>
        <translation>Ein Rad mit %1 Zähnen hat ein Maß, das kein Zahn haben kann; Modul und Zahnbreite müssen positiv sein, der Eingriffswinkel zwischen 5 und 35 Grad, Profilverschiebung und Zahnhöhen höchstens 3 Moduln.</translation>
    </message>
    <message>
        <source>%1 teeth are too few for a ring that a rack can generate; use at least %2.</source>
        <translation>%1 Zähne sind zu wenige für ein Hohlrad, das eine Zahnstange erzeugen kann; verwenden Sie mindestens %2.</translation>
    </message>
    <message>
        <source>%1 teeth are too few for a gear that a rack can generate; use at least %2.</source>
        <translation>%1 Zähne sind zu wenige für ein Rad, das eine Zahnstange erzeugen kann; verwenden Sie mindestens %2.</translation>
    </message>
    <message>
        <source>One tooth is too few for a gear that a rack can generate; use at least %1.</source>
        <translation>Ein Zahn ist zu wenig für ein Rad, das eine Zahnstange erzeugen kann; verwenden Sie mindestens %1.</translation>
    </message>
    <message>
        <source>The pitch cone of a bevel gear must be between %1 and 163 degrees.</source>
        <translation>Der Teilkegelwinkel eines Kegelrads muss zwischen %1 und 163 Grad liegen.</translation>
    </message>
    <message>
        <source>The face of %1 runs into the apex: make it shorter than %2, a third of the cone distance.</source>
        <translation>Die Zahnbreite von %1 läuft in die Kegelspitze: Machen Sie sie kürzer als %2, ein Drittel der Teilkegellänge.</translation>
    </message>
    <message>
        <source>%1 teeth leave no body below the roots; use more, or a larger profile shift.</source>
        <translation>%1 Zähne lassen unter den Zahnfüßen keinen Körper übrig; verwenden Sie mehr oder eine größere Profilverschiebung.</translation>
    </message>
    <message>
        <source>, or give the ring %1 teeth and the planets %2 (then %3 at equal distances fit)</source>
        <translation>, oder geben Sie dem Hohlrad %1 Zähne und den Planeten %2 (dann passen %3 in gleichen Abständen)</translation>
    </message>
    <message>
        <source>, or use %1 planets at equal distances</source>
        <translation>, oder verwenden Sie %1 Planeten in gleichen Abständen</translation>
    </message>
    <message>
        <source>link %1 by %2 degrees</source>
        <translation>Glied %1 um %2 Grad</translation>
    </message>
    <message>
        <source>Equal planets fit at multiples of 360/%1 = %2 degrees: move the axis of %3 round the central axis</source>
        <translation>Gleiche Planeten passen bei Vielfachen von 360/%1 = %2 Grad: Drehen Sie die Achse von %3 um die Mittelachse</translation>
    </message>
    <message>
        <source>%1 degrees on link %2</source>
        <translation>%1 Grad an Glied %2</translation>
    </message>
    <message>
        <source>Links %1 are drawn as equal planets and cannot be equal parts: with all teeth in mesh, their gear with %2 teeth is turned against that with %3 teeth, compared with link %4, by %5.</source>
        <translation>Glieder %1 sind als gleiche Planeten gezeichnet und können keine gleichen Teile sein: Wenn alle Zähne kämmen, ist ihr Rad mit %2 Zähnen gegen das mit %3 Zähnen, verglichen mit Glied %4, verdreht um %5.</translation>
    </message>
    <message>
        <source>With these teeth there are fewer places for equal planets (%1) than planets: let the planets differ, or change tooth counts.</source>
        <translation>Mit diesen Zähnen gibt es weniger Stellen für gleiche Planeten (%1) als Planeten: Lassen Sie die Planeten verschieden sein, oder ändern Sie Zähnezahlen.</translation>
    </message>
    <message>
        <source>Planets fit at multiples of 360/%1 = %2 degrees: move that of link %3 by %4 degrees</source>
        <translation>Planeten passen bei Vielfachen von 360/%1 = %2 Grad: Verschieben Sie den von Glied %3 um %4 Grad</translation>
    </message>
    <message>
        <source>It fits with %1 instead of %2 teeth on gear %3</source>
        <translation>Es passt mit %1 statt %2 Zähnen an Rad %3</translation>
    </message>
    <message>
        <source>, or with %1 instead of %2 teeth on gear %3</source>
        <translation>, oder mit %1 statt %2 Zähnen an Rad %3</translation>
    </message>
    <message>
        <source>Change tooth counts of the loop, or move one of its axes</source>
        <translation>Ändern Sie Zähnezahlen der Schleife, oder verschieben Sie eine ihrer Achsen</translation>
    </message>
    <message>
        <source>The loop of meshes %1 cannot be assembled as drawn: at mesh %2 the teeth miss each other by %3 of a pitch.</source>
        <translation>Die Schleife der Eingriffe %1 lässt sich so, wie sie gezeichnet ist, nicht montieren: Bei Eingriff %2 verfehlen die Zähne einander um %3 einer Teilung.</translation>
    </message>
    <message>
        <source>The wheels of links %1 and %2 beside gear %3 interfere: their tips overlap by %4 modules.</source>
        <translation>Die Räder der Glieder %1 und %2 neben Rad %3 überschneiden sich: Ihre Zahnköpfe überlappen um %4 Moduln.</translation>
    </message>
    <message>
        <source>At most %1 of them fit round it, at equal distances.</source>
        <translation>Höchstens %1 davon passen in gleichen Abständen darum.</translation>
    </message>
    <message>
        <source>Move one of them, or give it fewer teeth.</source>
        <translation>Verschieben Sie eines davon, oder geben Sie ihm weniger Zähne.</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) has no solid: %3</source>
        <translation>Rad %1 (%2 Zähne) hat keinen Körper: %3</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) is undercut: at a profile shift of %3 a rack needs %4 teeth or more. Use more teeth, or a shift of at least %5.</source>
        <translation>Rad %1 (%2 Zähne) hat Unterschnitt: Bei einer Profilverschiebung von %3 braucht eine Zahnstange %4 Zähne oder mehr. Verwenden Sie mehr Zähne oder eine Profilverschiebung von mindestens %5.</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) would have pointed teeth: its tips were lowered to keep a land of %3 modules. Use a smaller profile shift than %4.</source>
        <translation>Rad %1 (%2 Zähne) hätte spitze Zähne: Die Köpfe wurden gekürzt, damit eine Zahnkopfdicke von %3 Moduln bleibt. Verwenden Sie eine kleinere Profilverschiebung als %4.</translation>
    </message>
    <message>
        <source>Mesh %1, %2 and %3 teeth</source>
        <translation>Eingriff %1, %2 und %3 Zähne</translation>
    </message>
    <message>
        <source>%1: a contact ratio of %2, one pair of teeth lets go before the next takes over. Use more teeth, or profile shifts that leave longer flanks, for %3 or more.</source>
        <translation>%1: Die Profilüberdeckung ist %2, ein Zahnpaar löst sich, bevor das nächste übernimmt. Verwenden Sie mehr Zähne oder Profilverschiebungen, die längere Flanken lassen, für %3 oder mehr.</translation>
    </message>
    <message>
        <source>%1: a contact ratio of %2, that leaves nothing for errors of the teeth. Use more teeth, or profile shifts that leave longer flanks, for %3 or more.</source>
        <translation>%1: Die Profilüberdeckung ist %2, das lässt nichts für Fehler der Zähne übrig. Verwenden Sie mehr Zähne oder Profilverschiebungen, die längere Flanken lassen, für %3 oder mehr.</translation>
    </message>
    <message>
        <source>%1: a face width of %2 is more than a third of the cone distance, so that the small ends of the teeth are too weak to bear load. Use %3 or less.</source>
        <translation>%1: Die Zahnbreite von %2 ist mehr als ein Drittel der Teilkegellänge, sodass die kleinen Enden der Zähne zu schwach zum Tragen sind. Verwenden Sie %3 oder weniger.</translation>
    </message>
    <message>
        <source>%1 teeth in a ring of %2: their tips collide outside of the mesh, by %3 modules. Use a difference of more teeth, or a larger profile shift of the ring.</source>
        <translation>%1 Zähne in einem Hohlrad mit %2: Ihre Köpfe stoßen außerhalb des Eingriffs zusammen, um %3 Moduln. Verwenden Sie einen größeren Zähnezahlunterschied oder eine größere Profilverschiebung des Hohlrads.</translation>
    </message>
    <message>
        <source>%1 teeth in a ring of %2: the ring&apos;s tips would interfere with the pinion&apos;s fillets and were lowered by %3 modules. Use a pinion of more teeth, or with a larger profile shift.</source>
        <translation>%1 Zähne in einem Hohlrad mit %2: Die Köpfe des Hohlrads würden in die Fußrundungen des Ritzels eindringen und wurden um %3 Moduln gekürzt. Verwenden Sie ein Ritzel mit mehr Zähnen oder größerer Profilverschiebung.</translation>
    </message>
    <message>
        <source>Gears %1 and %2 overlap and do not mesh.</source>
        <translation>Räder %1 und %2 überschneiden sich und kämmen nicht.</translation>
    </message>
    <message>
        <source>Use smaller face widths, or leave them or a pitch point open.</source>
        <translation>Verwenden Sie kleinere Zahnbreiten, oder lassen Sie diese oder einen Wälzpunkt offen.</translation>
    </message>
    <message>
        <source>Move a pitch point on its axes, or leave it open.</source>
        <translation>Verschieben Sie einen Wälzpunkt auf seinen Achsen, oder lassen Sie ihn offen.</translation>
    </message>
    <message>
        <source>Move the pitch point of one along its axis, or leave it open.</source>
        <translation>Verschieben Sie den Wälzpunkt von einem entlang seiner Achse, oder lassen Sie ihn offen.</translation>
    </message>
    <message>
        <source>No free places along their axes clear them: move an axis, change tooth counts, or state pitch points.</source>
        <translation>Keine freien Plätze entlang ihrer Achsen trennen sie: Verschieben Sie eine Achse, ändern Sie Zähnezahlen, oder geben Sie Wälzpunkte an.</translation>
    </message>
    <message>
        <source>The number is too large; its double would be infinite.</source>
        <translation>Die Zahl ist zu groß; als Gleitkommazahl wäre sie unendlich.</translation>
    </message>
    <message>
        <source>A list has at most 100,000 elements; this one has %1.</source>
        <translation>Eine Liste hat höchstens 100.000 Elemente; diese hat %1.</translation>
    </message>
    <message>
        <source>The member occurs twice in its object; only one may stay.</source>
        <translation>Das Mitglied steht zweimal in seinem Objekt; nur eines darf bleiben.</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>die Zahl %1</translation>
    </message>
    <message>
        <source>the string %1</source>
        <translation>die Zeichenkette %1</translation>
    </message>
    <message>
        <source>a list of %1 elements</source>
        <translation>eine Liste von %1 Elementen</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an id: a string of 1 to 1,000 characters or a whole number</source>
        <translation>eine Kennung: eine Zeichenkette von 1 bis 1.000 Zeichen oder eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number, or a fraction as a string like &quot;22/7&quot;</source>
        <translation>eine Zahl oder ein Bruch als Zeichenkette wie „22/7“</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>Erwartet: %1; gefunden: %2.</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; is missing; expected %2.</source>
        <translation>Das Mitglied „%1“ fehlt; erwartet: %2.</translation>
    </message>
    <message>
        <source>a list of ids</source>
        <translation>eine Liste von Kennungen</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>eine Zeichenkette</translation>
    </message>
    <message>
        <source>expected at most 1,000 characters, found %1.</source>
        <translation>Erwartet: höchstens 1.000 Zeichen; gefunden: %1.</translation>
    </message>
    <message>
        <source>there is no member &quot;%1&quot;; &quot;%2&quot; is meant.</source>
        <translation>es gibt kein Mitglied „%1“; gemeint ist „%2“.</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; has no meaning here.</source>
        <translation>das Mitglied „%1“ hat hier keine Bedeutung.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; in %2 has no meaning beside the others of its object: it is kept and changes nothing.</source>
        <translation>Das Mitglied „%1“ in %2 hat neben den anderen seines Objekts keine Bedeutung: Es bleibt erhalten und ändert nichts.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; of the document is not known here: it is kept and changes nothing.</source>
        <translation>Das Mitglied „%1“ des Dokuments ist hier nicht bekannt: Es bleibt erhalten und ändert nichts.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; in %2 is not known here: it is kept and changes nothing.</source>
        <translation>Das Mitglied „%1“ in %2 ist hier nicht bekannt: Es bleibt erhalten und ändert nichts.</translation>
    </message>
    <message>
        <source>Is &quot;%1&quot; meant?</source>
        <translation>Ist „%1“ gemeint?</translation>
    </message>
    <message>
        <source>3D files of links are shown only: they have no mass, and overlaps and collisions with them are not looked for.</source>
        <translation>3D-Dateien von Gliedern werden nur gezeigt: Sie haben keine Masse, und nach Überschneidungen und Kollisionen mit ihnen wird nicht gesucht.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; names the 3D file &quot;%2&quot;, which cannot be read.</source>
        <translation>Glied „%1“ nennt die 3D-Datei „%2“, die nicht gelesen werden kann.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; names the 3D file &quot;%2&quot;, which is not there: the path begins at the folder of the document.</source>
        <translation>Glied „%1“ nennt die 3D-Datei „%2“, die es nicht gibt: Der Pfad beginnt beim Ordner des Dokuments.</translation>
    </message>
    <message>
        <source>a list of three numbers</source>
        <translation>eine Liste von drei Zahlen</translation>
    </message>
    <message>
        <source>a list of six numbers, xx, yy, zz, xy, xz, yz</source>
        <translation>eine Liste von sechs Zahlen, xx, yy, zz, xy, xz, yz</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a list of two, each a number or null</source>
        <translation>eine Liste von zweien, jedes eine Zahl oder null</translation>
    </message>
    <message>
        <source>the whole number %1</source>
        <translation>die ganze Zahl %1</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>The file has version %1, but this program reads version %2: open it with a newer GearGraph.</source>
        <translation>Die Datei hat Version %1, dieses Programm liest Version %2: Öffnen Sie sie mit einem neueren GearGraph.</translation>
    </message>
    <message>
        <source>This is not a GearGraph document: the member &quot;format&quot; has to be &quot;geargraph&quot;.</source>
        <translation>Das ist kein Dokument von GearGraph: Das Mitglied „format“ muss „geargraph“ sein.</translation>
    </message>
    <message>
        <source>a list of links, the ground first</source>
        <translation>eine Liste von Gliedern, das Gestell zuerst</translation>
    </message>
    <message>
        <source>a list of turning joints that tie the links</source>
        <translation>eine Liste von Drehgelenken, die die Glieder verbinden</translation>
    </message>
    <message>
        <source>a list of the axes that the turning joints name</source>
        <translation>eine Liste der Achsen, die die Drehgelenke nennen</translation>
    </message>
    <message>
        <source>a list of 3D files</source>
        <translation>eine Liste von 3D-Dateien</translation>
    </message>
    <message>
        <source>a &quot;mass&quot; beside it</source>
        <translation>ein „mass“ daneben</translation>
    </message>
    <message>
        <source>a speed in rad/s</source>
        <translation>eine Drehzahl in rad/s</translation>
    </message>
    <message>
        <source>the name of the state</source>
        <translation>der Name des Zustands</translation>
    </message>
    <message>
        <source>a list of ids of couplings</source>
        <translation>eine Liste von Kennungen von Schaltelementen</translation>
    </message>
    <message>
        <source>a list of two ids of links</source>
        <translation>eine Liste von zwei Kennungen von Gliedern</translation>
    </message>
    <message>
        <source>a torque in N m</source>
        <translation>ein Moment in N m</translation>
    </message>
    <message>
        <source>a torque or a force, not both in one load</source>
        <translation>ein Moment oder eine Kraft, nicht beides in einer Last</translation>
    </message>
    <message>
        <source>the point of the link that the force acts at</source>
        <translation>der Punkt des Glieds, an dem die Kraft angreift</translation>
    </message>
    <message>
        <source>a joint or a link, not both</source>
        <translation>ein Gelenk oder ein Glied, nicht beides</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>Erwartet: eine Liste.</translation>
    </message>
    <message>
        <source>The file has %1 bytes; at most 64 MiB are read.</source>
        <translation>Die Datei hat %1 Bytes; gelesen werden höchstens 64 MiB.</translation>
    </message>
    <message>
        <source>This is no GearGraph document: the file is not text in UTF-8, but a picture, an archive or the like, or damaged.</source>
        <translation>Dies ist kein GearGraph-Dokument: Die Datei ist kein Text in UTF-8, sondern ein Bild, ein Archiv oder dergleichen, oder beschädigt.</translation>
    </message>
    <message>
        <source>A centre of mass and an inertia need a &quot;mass&quot; beside them.</source>
        <translation>Schwerpunkt und Trägheit brauchen ein „mass“ neben sich.</translation>
    </message>
    <message>
        <source>This is no table of a mechanism: its first row has to name the columns, &quot;element&quot; among them.</source>
        <translation>Das ist keine Tabelle eines Mechanismus: Ihre erste Zeile muss die Spalten nennen, darunter „element“.</translation>
    </message>
    <message>
        <source>There are too many columns.</source>
        <translation>Es sind zu viele Spalten.</translation>
    </message>
    <message>
        <source>There is no column &quot;%1&quot;: %2.</source>
        <translation>Eine Spalte „%1“ gibt es nicht: %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs twice.</source>
        <translation>Die Spalte „%1“ kommt zweimal vor.</translation>
    </message>
    <message>
        <source>The column &quot;element&quot; is empty; it says what the row is about.</source>
        <translation>Die Spalte „element“ ist leer; sie sagt, wovon die Zeile handelt.</translation>
    </message>
    <message>
        <source>There is no element &quot;%1&quot;: %2.</source>
        <translation>Ein Element „%1“ gibt es nicht: %2.</translation>
    </message>
    <message>
        <source>This cell is in a column without a name.</source>
        <translation>Diese Zelle steht in einer Spalte ohne Namen.</translation>
    </message>
    <message>
        <source>This row has more cells than there are columns.</source>
        <translation>Diese Zeile hat mehr Zellen, als es Spalten gibt.</translation>
    </message>
    <message>
        <source>There is one row &quot;document&quot; at most.</source>
        <translation>Es gibt höchstens eine Zeile „document“.</translation>
    </message>
    <message>
        <source>A document has at most 100,000 %1.</source>
        <translation>Ein Dokument hat höchstens 100.000 %1.</translation>
    </message>
    <message>
        <source>The row names a &quot;joint&quot; or a &quot;link&quot;, one of them.</source>
        <translation>Die Zeile nennt ein „joint“ oder ein „link“, eines von beiden.</translation>
    </message>
    <message>
        <source>An &quot;axis&quot; is named beside a &quot;link&quot;; a joint has its own.</source>
        <translation>Eine „axis“ steht neben einem „link“; ein Gelenk hat seine eigene.</translation>
    </message>
    <message>
        <source>A load has a &quot;torque&quot;, or a force (dx, dy, dz) at a point (x, y, z).</source>
        <translation>Eine Last hat ein „torque“, oder eine Kraft (dx, dy, dz) in einem Punkt (x, y, z).</translation>
    </message>
    <message>
        <source>A force acts on a &quot;link&quot;: it has dx, dy, dz and a point x, y, z, and no axis.</source>
        <translation>Eine Kraft wirkt auf ein „link“: Sie hat dx, dy, dz und einen Punkt x, y, z, aber keine Achse.</translation>
    </message>
    <message>
        <source>More problems follow; only the first 100 are listed.</source>
        <translation>Weitere Probleme folgen; nur die ersten 100 sind aufgeführt.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; is empty; expected %2.</source>
        <translation>Die Spalte „%1“ ist leer; erwartet: %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; has %2; expected %3.</source>
        <translation>Die Spalte „%1“ hat %2; erwartet: %3.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; has no meaning for the element &quot;%2&quot;.</source>
        <translation>Die Spalte „%1“ hat für das Element „%2“ keine Bedeutung.</translation>
    </message>
    <message>
        <source>an id of at most 1,000 characters</source>
        <translation>eine Kennung von höchstens 1.000 Zeichen</translation>
    </message>
    <message>
        <source>at most 100,000 ids of 1 to 1,000 characters, with a bar (|) between</source>
        <translation>höchstens 100.000 Kennungen von 1 bis 1.000 Zeichen, durch senkrechte Striche (|) getrennt</translation>
    </message>
    <message>
        <source>a number, such as 12, -1.5, 1e-3 or 22/7</source>
        <translation>eine Zahl, etwa 12, -1.5, 1e-3 oder 22/7</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number of teeth</source>
        <translation>eine Zähnezahl</translation>
    </message>
    <message>
        <source>a whole number from 1 to 100,000</source>
        <translation>eine ganze Zahl von 1 bis 100.000</translation>
    </message>
    <message>
        <source>yes, no or nothing</source>
        <translation>yes, no oder nichts</translation>
    </message>
    <message>
        <source>an id</source>
        <translation>eine Kennung</translation>
    </message>
    <message>
        <source>a number, as its neighbours have one</source>
        <translation>eine Zahl, wie ihre Nachbarn eine haben</translation>
    </message>
    <message>
        <source>an attached 3D file</source>
        <translation>eine angehängte 3D-Datei</translation>
    </message>
    <message>
        <source>%1 attached 3D files</source>
        <translation>%1 angehängte 3D-Dateien</translation>
    </message>
    <message>
        <source>the view (places in the drawings, camera of the 3D view)</source>
        <translation>die Ansicht (Orte in den Zeichnungen, Kamera der 3D-Ansicht)</translation>
    </message>
    <message>
        <source>members that this program does not know</source>
        <translation>Mitglieder, die dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>the empty name of the unit, which becomes &quot;mm&quot;</source>
        <translation>der leere Name der Einheit, der „mm“ wird</translation>
    </message>
    <message>
        <source>a path that stays in the folder of this document</source>
        <translation>ein Pfad, der im Ordner dieses Dokuments bleibt</translation>
    </message>
    <message>
        <source>an object of points by the id of their link</source>
        <translation>ein Objekt von Punkten nach der Kennung ihres Glieds</translation>
    </message>
    <message>
        <source>expected the point of a node: a list of two numbers, x to the right and y down.</source>
        <translation>Erwartet: der Punkt eines Knotens, eine Liste von zwei Zahlen, x nach rechts und y nach unten.</translation>
    </message>
    <message>
        <source>a list of notes</source>
        <translation>eine Liste von Notizen</translation>
    </message>
    <message>
        <source>the text of the note</source>
        <translation>der Text der Notiz</translation>
    </message>
    <message>
        <source>the middle of the note</source>
        <translation>die Mitte der Notiz</translation>
    </message>
    <message>
        <source>a list of two numbers, x to the right and y down</source>
        <translation>eine Liste von zwei Zahlen, x nach rechts und y nach unten</translation>
    </message>
    <message>
        <source>the point that the camera looks at</source>
        <translation>der Punkt, auf den die Kamera blickt</translation>
    </message>
    <message>
        <source>an angle in degrees</source>
        <translation>ein Winkel in Grad</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>eine Zahl über 0</translation>
    </message>
    <message>
        <source>The axis would coincide with the one that its wheels mesh with.</source>
        <translation>Die Achse fiele mit der zusammen, mit deren Rädern ihre Räder kämmen.</translation>
    </message>
    <message>
        <source>There is no place for axis %1 where the wheels of meshes %2 would touch at these tooth counts. What fits: a smaller change, or other teeth first.</source>
        <translation>Es gibt keinen Ort für Achse %1, an dem die Räder der Eingriffe %2 sich bei diesen Zähnezahlen berühren. Es passt eine kleinere Änderung, oder zuerst andere Zähnezahlen.</translation>
    </message>
    <message>
        <source>Mesh %1 is no bevel pair: only bevels have an apex with two sides.</source>
        <translation>Eingriff %1 ist kein Kegelradpaar: Nur Kegelräder haben eine Spitze mit zwei Seiten.</translation>
    </message>
    <message>
        <source>A module is more than 0: the pitch diameter over the teeth.</source>
        <translation>Ein Modul ist größer als 0: der Teilkreisdurchmesser durch die Zähnezahl.</translation>
    </message>
    <message>
        <source>Modules can be set where every mesh has its place, in trains of up to %1 meshes. Resolve the reported problems first.</source>
        <translation>Moduln lassen sich setzen, wo jeder Eingriff seinen Ort hat, in Getrieben mit bis zu %1 Eingriffen. Lösen Sie zuerst die gemeldeten Probleme.</translation>
    </message>
    <message>
        <source>Mesh %1 cannot follow: %2 is pinned. What fits: unpin it, or another change.</source>
        <translation>Eingriff %1 kann nicht folgen: %2 ist fixiert. Lösen Sie die Fixierung, oder ändern Sie etwas anderes.</translation>
    </message>
    <message>
        <source>Mesh %1 cannot follow: %2 are pinned. What fits: unpin one of them, or another change.</source>
        <translation>Eingriff %1 kann nicht folgen: %2 sind fixiert. Lösen Sie eine der Fixierungen, oder ändern Sie etwas anderes.</translation>
    </message>
    <message>
        <source>The module of mesh %1 is pinned, and would change. What fits: unpin it, or another change.</source>
        <translation>Der Modul von Eingriff %1 ist fixiert und würde sich ändern. Lösen Sie die Fixierung, oder ändern Sie etwas anderes.</translation>
    </message>
    <message>
        <source>Axis %1 is pinned. What fits: unpin it to move it.</source>
        <translation>Achse %1 ist fixiert. Lösen Sie die Fixierung, um sie zu verschieben.</translation>
    </message>
    <message>
        <source>gear %1 would need %2 teeth to stay coaxial. What fits: a smaller change.</source>
        <translation>Rad %1 bräuchte %2 Zähne, um koaxial zu bleiben. Es passt eine kleinere Änderung.</translation>
    </message>
    <message>
        <source>an internal pair needs different tooth counts, the ring the larger one.</source>
        <translation>Ein Innenpaar braucht verschiedene Zähnezahlen, das Hohlrad die größere.</translation>
    </message>
    <message>
        <source>The comment has no end.</source>
        <translation>Der Kommentar hat kein Ende.</translation>
    </message>
    <message>
        <source>This character is no part of DOT.</source>
        <translation>Dieses Zeichen gehört nicht zu DOT.</translation>
    </message>
    <message>
        <source>The quote has no end.</source>
        <translation>Das Anführungszeichen hat kein Ende.</translation>
    </message>
    <message>
        <source>The text in angle brackets has no end.</source>
        <translation>Der Text in spitzen Klammern hat kein Ende.</translation>
    </message>
    <message>
        <source>This is no number.</source>
        <translation>Das ist keine Zahl.</translation>
    </message>
    <message>
        <source>The text is not UTF-8.</source>
        <translation>Der Text ist nicht UTF-8.</translation>
    </message>
    <message>
        <source>Behind the graph is something else; a file with one graph is read.</source>
        <translation>Hinter dem Graphen steht noch etwas; gelesen wird eine Datei mit einem Graphen.</translation>
    </message>
    <message>
        <source>Expected %1, found the end.</source>
        <translation>Erwartet: %1, gefunden: das Ende.</translation>
    </message>
    <message>
        <source>Expected %1, found %2.</source>
        <translation>Erwartet: %1, gefunden: %2.</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>a quoted text</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>Groups are nested deeper than 64.</source>
        <translation>Gruppen sind tiefer als 64-fach verschachtelt.</translation>
    </message>
    <message>
        <source>An edge between groups is not read; write an edge for each joint and mesh.</source>
        <translation>Eine Kante zwischen Gruppen wird nicht gelesen; schreiben Sie für jedes Gelenk und jeden Zahneingriff eine Kante.</translation>
    </message>
    <message>
        <source>An edge of a directed graph is written -&gt;.</source>
        <translation>Eine Kante eines gerichteten Graphen schreibt man -&gt;.</translation>
    </message>
    <message>
        <source>The graph is strict, and a second edge leads from %1 to %2: it would be one with the first. Leave out &quot;strict&quot;.</source>
        <translation>Der Graph ist „strict“, und eine zweite Kante führt von %1 nach %2: Sie fiele mit der ersten zusammen. Lassen Sie „strict“ weg.</translation>
    </message>
    <message>
        <source>A graph of at most 200,000 edges is read.</source>
        <translation>Gelesen wird ein Graph mit höchstens 200.000 Kanten.</translation>
    </message>
    <message>
        <source>A graph of at most 100,000 nodes is read.</source>
        <translation>Gelesen wird ein Graph mit höchstens 100.000 Knoten.</translation>
    </message>
    <message>
        <source>The graph is undirected, so that it does not say which link of a joint or mesh is tail and which is head: the signs and the teeth of each gear depend on it. Make it directed.</source>
        <translation>Der Graph ist ungerichtet, sagt also nicht, welches Glied eines Gelenks oder Zahneingriffs Fuß und welches Spitze ist: Davon hängen die Vorzeichen und die Zähnezahl jedes Rads ab. Machen Sie ihn gerichtet.</translation>
    </message>
    <message>
        <source>This is no XML: %1.</source>
        <translation>Das ist kein XML: %1.</translation>
    </message>
    <message>
        <source>There is no &lt;graph&gt; in the file.</source>
        <translation>In der Datei gibt es kein &lt;graph&gt;.</translation>
    </message>
    <message>
        <source>A file with a document type (&lt;!DOCTYPE&gt;) is not read; leave it out.</source>
        <translation>Eine Datei mit Dokumenttyp (&lt;!DOCTYPE&gt;) wird nicht gelesen; lassen Sie ihn weg.</translation>
    </message>
    <message>
        <source>The element &lt;%1&gt; lacks the attribute &quot;%2&quot;.</source>
        <translation>Dem Element &lt;%1&gt; fehlt das Attribut „%2“.</translation>
    </message>
    <message>
        <source>Elements are nested deeper than 64.</source>
        <translation>Elemente sind tiefer als 64-fach verschachtelt.</translation>
    </message>
    <message>
        <source>This is no GraphML: it begins with &lt;%1&gt;.</source>
        <translation>Das ist kein GraphML: Es beginnt mit &lt;%1&gt;.</translation>
    </message>
    <message>
        <source>A hyperedge is not read; a joint and a mesh are edges between two nodes.</source>
        <translation>Eine Hyperkante wird nicht gelesen; Gelenk und Zahneingriff sind Kanten zwischen zwei Knoten.</translation>
    </message>
    <message>
        <source>A file with one graph is read, without graphs inside its nodes.</source>
        <translation>Gelesen wird eine Datei mit einem Graphen, ohne Graphen in seinen Knoten.</translation>
    </message>
    <message>
        <source>The graph has no node; the first one is the ground.</source>
        <translation>Der Graph hat keinen Knoten; der erste ist das Gestell.</translation>
    </message>
    <message>
        <source>The graph has version %1, but this program reads version %2: read it with a newer GearGraph.</source>
        <translation>Der Graph hat Version %1, dieses Programm liest aber Version %2: Lesen Sie ihn mit einem neueren GearGraph.</translation>
    </message>
    <message>
        <source>The ground is the first node, %1.</source>
        <translation>Das Gestell ist der erste Knoten, %1.</translation>
    </message>
    <message>
        <source>The edge %1 (%2)</source>
        <translation>Die Kante %1 (%2)</translation>
    </message>
    <message>
        <source>The edge %1</source>
        <translation>Die Kante %1</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;kind&quot;; expected &quot;turning&quot; or &quot;mesh&quot;.</source>
        <translation>%1: Das Attribut „kind“ fehlt; erwartet: „turning“ oder „mesh“.</translation>
    </message>
    <message>
        <source>%1: its &quot;kind&quot; is %2, so this is a T-T graph; the digraph (--view digraph) is read back.</source>
        <translation>%1: „kind“ ist %2, also ist dies ein T-T-Graph; zurückgelesen wird der Digraph (--view digraph).</translation>
    </message>
    <message>
        <source>%1: its &quot;kind&quot; is %2; expected &quot;turning&quot; or &quot;mesh&quot;.</source>
        <translation>%1: „kind“ ist %2; erwartet: „turning“ oder „mesh“.</translation>
    </message>
    <message>
        <source>As a document the graph has more than 64 MiB.</source>
        <translation>Als Dokument hat der Graph mehr als 64 MiB.</translation>
    </message>
    <message>
        <source>%1, %2: expected a list or an object as JSON, found %3.</source>
        <translation>%1, %2: erwartet: eine Liste oder ein Objekt als JSON, gefunden: %3.</translation>
    </message>
    <message>
        <source>The graph</source>
        <translation>Der Graph</translation>
    </message>
    <message>
        <source>The node %1</source>
        <translation>Der Knoten %1</translation>
    </message>
    <message>
        <source>%1 is in the graph twice.</source>
        <translation>%1 steht zweimal im Graphen.</translation>
    </message>
    <message>
        <source>The graph has no places of axes: %1 are placed from the tooth counts.</source>
        <translation>Der Graph hat keine Lagen der Achsen: %1 werden aus den Zähnezahlen angeordnet.</translation>
    </message>
    <message>
        <source>1 mesh has no &quot;meshKind&quot;: external between parallel axes, bevel between intersecting ones.</source>
        <translation>1 Zahneingriff hat kein „meshKind“: zwischen parallelen Achsen außenverzahnt, zwischen sich schneidenden kegelig.</translation>
    </message>
    <message>
        <source>%1 meshes have no &quot;meshKind&quot;: external between parallel axes, bevel between intersecting ones.</source>
        <translation>%1 Zahneingriffe haben kein „meshKind“: zwischen parallelen Achsen außenverzahnt, zwischen sich schneidenden kegelig.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the name of the axis that the joint turns about, the same for joints on one axis.</source>
        <translation>%1: Das Attribut „%2“ fehlt: der Name der Achse, um die sich das Gelenk dreht, gleich für Gelenke auf einer Achse.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the number of teeth of the gear on its first node.</source>
        <translation>%1: Das Attribut „%2“ fehlt: die Zähnezahl des Rads auf dem ersten Knoten.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the number of teeth of the gear on its second node.</source>
        <translation>%1: Das Attribut „%2“ fehlt: die Zähnezahl des Rads auf dem zweiten Knoten.</translation>
    </message>
    <message>
        <source>%1: there is no node %2.</source>
        <translation>%1: Einen Knoten %2 gibt es nicht.</translation>
    </message>
    <message>
        <source>Attributes without a meaning for the mechanism were not read: %1.</source>
        <translation>Attribute ohne Bedeutung für den Mechanismus wurden nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>A graph of at most 100,000 nodes and 200,000 edges is read.</source>
        <translation>Gelesen wird ein Graph mit höchstens 100.000 Knoten und 200.000 Kanten.</translation>
    </message>
    <message>
        <source>This is no node-link graph: it is an object with the lists &quot;nodes&quot; and &quot;links&quot;.</source>
        <translation>Das ist kein Node-Link-Graph: Der ist ein Objekt mit den Listen „nodes“ und „links“.</translation>
    </message>
    <message>
        <source>Expected an object with &quot;%1&quot;, a text or a number that names a node.</source>
        <translation>Erwartet: ein Objekt mit „%1“, einem Text oder einer Zahl, die einen Knoten nennt.</translation>
    </message>
    <message>
        <source>%1 link</source>
        <translation>%1 Glied</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 hinzugefügt</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 entfernt</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 geändert</translation>
    </message>
    <message>
        <source>axes changed</source>
        <translation>Achsen geändert</translation>
    </message>
    <message>
        <source>inputs changed</source>
        <translation>Antriebe geändert</translation>
    </message>
    <message>
        <source>links moved in the drawing</source>
        <translation>Glieder in der Zeichnung verschoben</translation>
    </message>
    <message>
        <source>other properties changed</source>
        <translation>andere Eigenschaften geändert</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot; in %2.</source>
        <translation>In %2 gibt es kein „%1“.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>Ein Drehgelenk von Glied %1 zu Glied %2 würde eine Schleife schließen. Die Drehgelenke müssen ein Baum sein: Zeichnen Sie stattdessen einen Zahneingriff.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop with joint %3. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>Ein Drehgelenk von Glied %1 zu Glied %2 würde mit Gelenk %3 eine Schleife schließen. Die Drehgelenke müssen ein Baum sein: Zeichnen Sie stattdessen einen Zahneingriff.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop with joints %3. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>Ein Drehgelenk von Glied %1 zu Glied %2 würde mit den Gelenken %3 eine Schleife schließen. Die Drehgelenke müssen ein Baum sein: Zeichnen Sie stattdessen einen Zahneingriff.</translation>
    </message>
    <message>
        <source>A turning joint needs two different links.</source>
        <translation>Ein Drehgelenk braucht zwei verschiedene Glieder.</translation>
    </message>
    <message>
        <source>To split link %1, choose some of its joints and meshes, and leave others: the new link takes those that you choose.</source>
        <translation>Um Glied %1 zu teilen, wählen Sie einige seiner Gelenke und Eingriffe und lassen andere: Das neue Glied übernimmt die gewählten.</translation>
    </message>
    <message>
        <source>Link %1 turns on no other link, so that its parts have no axis: draw its joint first.</source>
        <translation>Glied %1 dreht sich auf keinem anderen Glied, sodass seine Teile keine Achse haben: Zeichnen Sie zuerst sein Gelenk.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint, mesh or coupling of link %2.</source>
        <translation>„%1“ ist kein Gelenk, kein Eingriff und kein Schaltelement von Glied %2.</translation>
    </message>
    <message>
        <source>The ground cannot be split: nothing says about which axis its part turns.</source>
        <translation>Das Gestell lässt sich nicht teilen: Nichts sagt, um welche Achse sich sein Teil dreht.</translation>
    </message>
    <message>
        <source>A weld needs two different links.</source>
        <translation>Verschweißen lassen sich nur zwei verschiedene Glieder.</translation>
    </message>
    <message>
        <source>Links %1 and %2 cannot be one: both wheels of mesh %3 would turn about one axis.</source>
        <translation>Glied %1 und Glied %2 können nicht eines sein: Beide Räder von Eingriff %3 würden sich um eine Achse drehen.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are in different places of one train, so that links %3 and %4 cannot be one: lay one axis on the other first.</source>
        <translation>Die Achsen %1 und %2 liegen an verschiedenen Stellen eines Getriebes, sodass Glied %3 und Glied %4 nicht eines sein können: Legen Sie zuerst eine Achse auf die andere.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 have different directions, so that links %3 and %4 cannot be one: lay one axis along the other first.</source>
        <translation>Die Achsen %1 und %2 haben verschiedene Richtungen, sodass Glied %3 und Glied %4 nicht eines sein können: Legen Sie zuerst eine Achse längs der anderen.</translation>
    </message>
    <message>
        <source>The limits of joints %1 and %2 leave the welded link no angle to turn: change them first.</source>
        <translation>Die Grenzen der Gelenke %1 und %2 lassen dem verschweißten Glied keinen Drehwinkel: Ändern Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Links %1 and %2 cannot be one: it would turn about several axes. Links are welded whose joints can lie on one axis.</source>
        <translation>Glied %1 und Glied %2 können nicht eines sein: Es würde sich um mehrere Achsen drehen. Verschweißt werden Glieder, deren Gelenke auf einer Achse liegen können.</translation>
    </message>
    <message>
        <source>A load or balance is in joint %1, which the weld takes away: remove it first.</source>
        <translation>In Gelenk %1, das beim Verschweißen wegfällt, wirkt eine Last oder ein Ausgleichsmoment: Entfernen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>The mass of link %1 is stated, and would be that of a part only: remove it before you weld the link.</source>
        <translation>Die Masse von Glied %1 ist angegeben und wäre nur die eines Teils: Entfernen Sie sie, bevor Sie das Glied verschweißen.</translation>
    </message>
    <message>
        <source>Links %1 and %2 mesh with each other in mesh %3: delete it before you weld them.</source>
        <translation>Glied %1 und Glied %2 greifen in Eingriff %3 ineinander: Löschen Sie ihn, bevor Sie die Glieder verschweißen.</translation>
    </message>
    <message>
        <source>A gear mesh needs two different links.</source>
        <translation>Ein Zahneingriff braucht zwei verschiedene Glieder.</translation>
    </message>
    <message>
        <source>The ground cannot be deleted; make another link the ground first.</source>
        <translation>Das Gestell lässt sich nicht löschen; machen Sie zuerst ein anderes Glied zum Gestell.</translation>
    </message>
    <message>
        <source>Only links and axes bear names; the others bear the paper&apos;s labels.</source>
        <translation>Nur Glieder und Achsen tragen Namen; die anderen tragen die Bezeichnungen der Arbeit.</translation>
    </message>
    <message>
        <source>An axis needs a name.</source>
        <translation>Eine Achse braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is an axis &quot;%1&quot; already.</source>
        <translation>Eine Achse „%1“ gibt es schon.</translation>
    </message>
    <message>
        <source>A gear has 1 to 100,000 teeth, not %1.</source>
        <translation>Ein Rad hat 1 bis 100.000 Zähne, nicht %1.</translation>
    </message>
    <message>
        <source>The direction of axis %1 has length 0.</source>
        <translation>Die Richtung der Achse %1 hat die Länge 0.</translation>
    </message>
    <message>
        <source>The joint is an input already.</source>
        <translation>Das Gelenk ist schon ein Antrieb.</translation>
    </message>
    <message>
        <source>Loads or balances act on this link, and the ground can have none: remove them first.</source>
        <translation>Auf dieses Glied wirken Lasten oder Ausgleichsmomente, und das Gestell kann keine haben: Entfernen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>There is no link or note in what was copied.</source>
        <translation>Im Kopierten ist kein Glied und keine Notiz.</translation>
    </message>
    <message>
        <source>A name has at most 1,000 characters; this one has %1.</source>
        <translation>Ein Name hat höchstens 1.000 Zeichen; dieser hat %1.</translation>
    </message>
    <message>
        <source>A document has at most 100,000 %1; this one has %2.</source>
        <translation>Ein Dokument hat höchstens 100.000 %1; dieses hat %2.</translation>
    </message>
    <message>
        <source>expected a coordinate from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Koordinate von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a number from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Zahl von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a component from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Komponente von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a length from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Länge von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a density from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Dichte von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a mass from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Masse von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a moment from -1e15 to 1e15.</source>
        <translation>Erwartet: ein Trägheitsmoment von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a torque from -1e15 to 1e15.</source>
        <translation>Erwartet: ein Moment von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a force from -1e15 to 1e15.</source>
        <translation>Erwartet: eine Kraft von -1e15 bis 1e15.</translation>
    </message>
    <message>
        <source>expected a direction with a component of at least 1e-15.</source>
        <translation>Erwartet: eine Richtung mit einer Komponente von mindestens 1e-15.</translation>
    </message>
    <message>
        <source>A mass is at least 0, in kg.</source>
        <translation>Eine Masse ist mindestens 0, in kg.</translation>
    </message>
    <message>
        <source>No body has this inertia: each principal moment is at least 0 and at most the sum of the other two. The numbers are xx, yy, zz, xy, xz, yz in kg m², about the centre of mass.</source>
        <translation>Kein Körper hat diese Trägheit: Jedes Hauptmoment ist mindestens 0 und höchstens die Summe der beiden anderen. Die Zahlen sind xx, yy, zz, xy, xz, yz in kg m², um den Schwerpunkt.</translation>
    </message>
    <message>
        <source>%1 names &quot;%2&quot;, but %3 has no such id.</source>
        <translation>%1 nennt „%2“, aber %3 hat keine solche Kennung.</translation>
    </message>
    <message>
        <source>The ground takes any load: %1 are on moving links. Name one of those.</source>
        <translation>Das Gestell nimmt jede Last auf: %1 wirken auf bewegte Glieder. Nennen Sie eines davon.</translation>
    </message>
    <message>
        <source>The id &quot;%1&quot; occurs twice in %2.</source>
        <translation>Die Kennung „%1“ kommt in %2 zweimal vor.</translation>
    </message>
    <message>
        <source>The joint &quot;%1&quot; occurs twice in %2.</source>
        <translation>Das Gelenk „%1“ kommt in %2 zweimal vor.</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; occurs twice in %2.</source>
        <translation>Das Glied „%1“ kommt in %2 zweimal vor.</translation>
    </message>
    <message>
        <source>A mesh has an efficiency or a coefficient of friction, not both.</source>
        <translation>Ein Eingriff hat einen Wirkungsgrad oder eine Reibungszahl, nicht beides.</translation>
    </message>
    <message>
        <source>A coefficient of friction is from 0 to 1.</source>
        <translation>Eine Reibungszahl liegt zwischen 0 und 1.</translation>
    </message>
    <message>
        <source>A density is above 0, in kg/m³.</source>
        <translation>Eine Dichte ist größer als 0, in kg/m³.</translation>
    </message>
    <message>
        <source>There is no note &quot;%1&quot;.</source>
        <translation>Eine Notiz „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>A document has at most 1,000 notes; this one has %1.</source>
        <translation>Ein Dokument hat höchstens 1.000 Notizen; dieses hat %1.</translation>
    </message>
    <message>
        <source>A note has at most 1,000 characters; this one has %1.</source>
        <translation>Eine Notiz hat höchstens 1.000 Zeichen; diese hat %1.</translation>
    </message>
    <message>
        <source>A note needs a text.</source>
        <translation>Eine Notiz braucht einen Text.</translation>
    </message>
    <message>
        <source>A note is lines of text without control characters.</source>
        <translation>Eine Notiz besteht aus Textzeilen ohne Steuerzeichen.</translation>
    </message>
    <message>
        <source>There is no axis, link or mesh &quot;%1&quot; to pin.</source>
        <translation>Es gibt keine Achse, kein Glied und keinen Eingriff „%1“ zu fixieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the folder of the document: save the document first, then copy the 3D file into its folder.</source>
        <translation>„%1“ liegt nicht im Ordner des Dokuments: Speichern Sie zuerst das Dokument, und kopieren Sie dann die 3D-Datei in seinen Ordner.</translation>
    </message>
    <message>
        <source>The scale of a 3D file has to be above 0.</source>
        <translation>Der Maßstab einer 3D-Datei muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>There is a coupling &quot;%1&quot; already.</source>
        <translation>Ein Schaltelement „%1“ gibt es schon.</translation>
    </message>
    <message>
        <source>The ground does not move: a brake is for a moving link.</source>
        <translation>Das Gestell bewegt sich nicht: Eine Bremse ist für ein bewegtes Glied.</translation>
    </message>
    <message>
        <source>A clutch needs two different links.</source>
        <translation>Eine Kupplung braucht zwei verschiedene Glieder.</translation>
    </message>
    <message>
        <source>A coupling needs a name.</source>
        <translation>Ein Schaltelement braucht einen Namen.</translation>
    </message>
    <message>
        <source>A state needs a name.</source>
        <translation>Ein Zustand braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is a state &quot;%1&quot; already.</source>
        <translation>Einen Zustand „%1“ gibt es schon.</translation>
    </message>
    <message>
        <source>Coupling &quot;%1&quot; is listed twice.</source>
        <translation>Schaltelement „%1“ ist zweimal aufgeführt.</translation>
    </message>
    <message>
        <source>A mechanism needs at least the ground.</source>
        <translation>Ein Mechanismus braucht mindestens das Gestell.</translation>
    </message>
    <message>
        <source>An id may not be empty.</source>
        <translation>Eine Kennung darf nicht leer sein.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; names &quot;%3&quot;, but %4 has no such id.</source>
        <translation>%1 „%2“ nennt „%3“, aber %4 hat keine solche Kennung.</translation>
    </message>
    <message>
        <source>The 3D file of a link is a path that stays in the folder of the document, not &quot;%1&quot;.</source>
        <translation>Die 3D-Datei eines Glieds ist ein Pfad, der im Ordner des Dokuments bleibt, nicht „%1“.</translation>
    </message>
    <message>
        <source>Turning joint &quot;%1&quot; ties link &quot;%2&quot; to itself; it needs two links.</source>
        <translation>Drehgelenk „%1“ verbindet Glied „%2“ mit sich selbst; es braucht zwei Glieder.</translation>
    </message>
    <message>
        <source>Gear mesh &quot;%1&quot; ties link &quot;%2&quot; to itself; it needs two links.</source>
        <translation>Zahneingriff „%1“ verbindet Glied „%2“ mit sich selbst; er braucht zwei Glieder.</translation>
    </message>
    <message>
        <source>The face width of a gear mesh is above 0.</source>
        <translation>Die Zahnbreite eines Eingriffs ist größer als 0.</translation>
    </message>
    <message>
        <source>A gear has 1 to 100,000 teeth; mesh &quot;%1&quot; says %2.</source>
        <translation>Ein Rad hat 1 bis 100.000 Zähne; Eingriff „%1“ nennt %2.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; is on link &quot;%2&quot;, but its wheel &quot;%3&quot; is on link &quot;%4&quot;.</source>
        <translation>Eingriff „%1“ ist an Glied „%2“, sein Rad „%3“ aber an Glied „%4“.</translation>
    </message>
    <message>
        <source>A brake names one link, a clutch two.</source>
        <translation>Eine Bremse nennt ein Glied, eine Kupplung zwei.</translation>
    </message>
    <message>
        <source>Clutch &quot;%1&quot; ties link &quot;%2&quot; to itself.</source>
        <translation>Kupplung „%1“ verbindet Glied „%2“ mit sich selbst.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; occurs twice in %2.</source>
        <translation>Der Name „%1“ kommt in %2 zweimal vor.</translation>
    </message>
    <message>
        <source>Coupling &quot;%1&quot; is listed twice in %2.</source>
        <translation>Schaltelement „%1“ ist in %2 zweimal aufgeführt.</translation>
    </message>
    <message>
        <source>The distance of the camera has to be above 0.</source>
        <translation>Der Abstand der Kamera muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>The limits of a joint are two angles from the reference pose, in degrees: the first at most 0, the second at least 0, and not both 0.</source>
        <translation>Die Anschläge eines Gelenks sind zwei Winkel ab der Bezugslage, in Grad: der erste höchstens 0, der zweite mindestens 0, und nicht beide 0.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are one line held by a common link: they are treated as one axis, with opposite directions.</source>
        <translation>Achsen %1 und %2 sind eine Gerade, die ein gemeinsames Glied hält: Sie gelten als eine Achse, mit entgegengesetzten Richtungen.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are one line held by a common link: they are treated as one axis.</source>
        <translation>Achsen %1 und %2 sind eine Gerade, die ein gemeinsames Glied hält: Sie gelten als eine Achse.</translation>
    </message>
    <message>
        <source>Axis %1 is named by joints that share no link on it (%2 ...): they coincide in the drawn pose only and are treated as different axes. Give each its own axis.</source>
        <translation>Achse %1 wird von Gelenken genannt, die kein Glied darauf gemeinsam haben (%2 ...): Sie fallen nur in der gezeichneten Lage zusammen und gelten als verschiedene Achsen. Geben Sie jedem seine eigene Achse.</translation>
    </message>
    <message>
        <source>Mesh %1 (%2) joins two gears on the same axis %3: coaxial gears cannot mesh. Move one of them to another axis, or delete the mesh.</source>
        <translation>Eingriff %1 (%2) verbindet zwei Räder auf derselben Achse %3: Koaxiale Räder können nicht kämmen. Versetzen Sie eines auf eine andere Achse, oder löschen Sie den Eingriff.</translation>
    </message>
    <message>
        <source>Mesh %1 (%2) has no carrier: the path between its gears changes axis more than once, %3. One link must carry both axes, so that their distance is constant.</source>
        <translation>Eingriff %1 (%2) hat keinen Steg: Der Weg zwischen seinen Rädern wechselt mehr als einmal die Achse, %3. Ein Glied muss beide Achsen tragen, damit ihr Abstand gleich bleibt.</translation>
    </message>
    <message>
        <source>the drawings</source>
        <translation>die Zeichnungen</translation>
    </message>
    <message>
        <source>the matrices</source>
        <translation>die Matrizen</translation>
    </message>
    <message>
        <source>the exercises</source>
        <translation>die Aufgaben</translation>
    </message>
    <message>
        <source>the key of the exercises</source>
        <translation>die Lösungen der Aufgaben</translation>
    </message>
    <message>
        <source>the mechanism&apos;s data</source>
        <translation>die Daten des Mechanismus</translation>
    </message>
    <message>
        <source>the still picture</source>
        <translation>das Standbild</translation>
    </message>
    <message>
        <source>the solids</source>
        <translation>die Körper</translation>
    </message>
    <message>
        <source>The handout would have %1 MB; a page has at most 3 MB. The largest part: %2.</source>
        <translation>Das Handout hätte %1 MB; eine Seite hat höchstens 3 MB. Der größte Teil: %2.</translation>
    </message>
    <message>
        <source>Reading it took longer than %1 s.</source>
        <translation>Das Lesen dauerte länger als %1 s.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: the program that reads it crashed, and was confined.</source>
        <translation>Sie ist beschädigt oder soll Schaden anrichten: Das Programm, das sie liest, ist abgestürzt und war eingeschränkt.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: the program that reads it crashed. This system does not confine it.</source>
        <translation>Sie ist beschädigt oder in böser Absicht gemacht: Das Programm, das sie liest, stürzte ab. Dieses System schließt es nicht ein.</translation>
    </message>
    <message>
        <source>Reading it was stopped.</source>
        <translation>Das Lesen wurde angehalten.</translation>
    </message>
    <message>
        <source>The program geargraph-mesh cannot be run.</source>
        <translation>Das Programm geargraph-mesh lässt sich nicht ausführen.</translation>
    </message>
    <message>
        <source>There are too many open files.</source>
        <translation>Es sind zu viele Dateien offen.</translation>
    </message>
    <message>
        <source>It is not there.</source>
        <translation>Sie ist nicht da.</translation>
    </message>
    <message>
        <source>It cannot be opened.</source>
        <translation>Sie lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>It is no file.</source>
        <translation>Es ist keine Datei.</translation>
    </message>
    <message>
        <source>It has %1 bytes, more than the limit of %2.</source>
        <translation>Sie hat %1 Bytes, mehr als die Grenze von %2.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: what the program that reads it answers is no solid.</source>
        <translation>Sie ist beschädigt oder soll Schaden anrichten: Was das Programm antwortet, das sie liest, ist kein Körper.</translation>
    </message>
    <message>
        <source>It is none of STL, OBJ, PLY and GLB.</source>
        <translation>Sie ist keine STL-, OBJ-, PLY- oder GLB-Datei.</translation>
    </message>
    <message>
        <source>The program geargraph-mesh, which reads 3D files, is missing.</source>
        <translation>Das Programm geargraph-mesh, das 3D-Dateien liest, fehlt.</translation>
    </message>
    <message>
        <source>Too wide for this page; the web page and LaTeX hold it whole.</source>
        <translation>Zu breit für diese Seite; die Webseite und LaTeX enthalten es ganz.</translation>
    </message>
    <message>
        <source>There is not enough memory for the pages.</source>
        <translation>Der Speicher reicht für die Seiten nicht aus.</translation>
    </message>
    <message>
        <source>No 3D pictures: %1. On Debian, the package libgl1-mesa-dri brings what is missing.</source>
        <translation>Keine 3D-Bilder: %1. Unter Debian bringt das Paket libgl1-mesa-dri, was fehlt.</translation>
    </message>
    <message>
        <source>EGL finds no device</source>
        <translation>EGL findet kein Gerät</translation>
    </message>
    <message>
        <source>EGL has no desktop OpenGL</source>
        <translation>EGL hat kein Desktop-OpenGL</translation>
    </message>
    <message>
        <source>EGL has no OpenGL configuration</source>
        <translation>EGL hat keine OpenGL-Konfiguration</translation>
    </message>
    <message>
        <source>there is no OpenGL 3.3 core</source>
        <translation>es gibt keinen Kern von OpenGL 3.3</translation>
    </message>
    <message>
        <source>the driver cannot paint without a window</source>
        <translation>der Treiber kann ohne Fenster nicht zeichnen</translation>
    </message>
    <message>
        <source>No 3D pictures: %1. Install a driver with OpenGL 3.3 or newer.</source>
        <translation>Keine 3D-Bilder: %1. Installieren Sie einen Treiber mit OpenGL 3.3 oder neuer.</translation>
    </message>
    <message>
        <source>the driver has no %1</source>
        <translation>dem Treiber fehlt %1</translation>
    </message>
    <message>
        <source>the driver offers OpenGL %1</source>
        <translation>der Treiber bietet OpenGL %1</translation>
    </message>
    <message>
        <source>the driver rejects a shader: %1</source>
        <translation>der Treiber weist einen Shader ab: %1</translation>
    </message>
    <message>
        <source>The picture would be more than %1 pixels wide or high: give it a smaller size, or write SVG or PDF.</source>
        <translation>Das Bild wäre mehr als %1 Pixel breit oder hoch: Geben Sie eine kleinere Größe an, oder schreiben Sie SVG oder PDF.</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 Verlust</translation>
    </message>
    <message>
        <source>* shared by equal stiffness: an assumption</source>
        <translation>* nach gleicher Steifigkeit geteilt: eine Annahme</translation>
    </message>
    <message>
        <source>? W: shared in unknown parts, not determined</source>
        <translation>? W: zu unbekannten Teilen geteilt, nicht bestimmt</translation>
    </message>
    <message>
        <source>circulates: links %1, meshes %2</source>
        <translation>Blindleistung: Glieder %1, Eingriffe %2</translation>
    </message>
    <message>
        <source>seen from the ground</source>
        <translation>vom Gestell aus gesehen</translation>
    </message>
    <message>
        <source>seen from link %1</source>
        <translation>von Glied %1 aus gesehen</translation>
    </message>
    <message>
        <source>Balance in joint %1</source>
        <translation>Ausgleich in Gelenk %1</translation>
    </message>
    <message>
        <source>Balance on link %1</source>
        <translation>Ausgleich an Glied %1</translation>
    </message>
    <message>
        <source>%1: not determined, it shares the loads in unknown parts.</source>
        <translation>%1: nicht bestimmt, die Lasten sind zu unbekannten Teilen geteilt.</translation>
    </message>
    <message>
        <source>%1: found, it holds the loads with %2 N m.</source>
        <translation>%1: gefunden, hält die Lasten mit %2 N m.</translation>
    </message>
    <message>
        <source>It feeds %1 into the train.</source>
        <translation>Führt dem Getriebe %1 zu.</translation>
    </message>
    <message>
        <source>It takes %1 out of the train.</source>
        <translation>Entnimmt dem Getriebe %1.</translation>
    </message>
    <message>
        <source>T shared</source>
        <translation>Gemeinsames T</translation>
    </message>
    <message>
        <source>Both methods give the same fractions: all %1 entries agree.</source>
        <translation>Beide Methoden ergeben dieselben Brüche: Alle %1 Einträge stimmen überein.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Schritt für Schritt</translation>
    </message>
    <message>
        <source>Matroid method</source>
        <translation>Matroid-Methode</translation>
    </message>
    <message>
        <source>T-T graph method</source>
        <translation>T-T-Graph-Methode</translation>
    </message>
    <message>
        <source>Relation</source>
        <translation>Beziehung</translation>
    </message>
    <message>
        <source>Mesh by mesh</source>
        <translation>Eingriff für Eingriff</translation>
    </message>
    <message>
        <source>For each mesh, above: its row of $P$, divided by the radius of the head&apos;s gear. Below: its terminal equation with both circuits put in, times $N_{tail} / N_{head}$.</source>
        <translation>Für jeden Eingriff oben seine Zeile von $P$, geteilt durch den Radius des Rads an der Spitze, unten seine Klemmengleichung mit beiden Kreisen eingesetzt, mal $N_{tail} / N_{head}$.</translation>
    </message>
    <message>
        <source>too long to write</source>
        <translation>zu lang zum Ausschreiben</translation>
    </message>
    <message>
        <source>Counted</source>
        <translation>Gezählt</translation>
    </message>
    <message>
        <source>Products and quotients, sums and differences of the calculation by hand for this mechanism; those with $0$ and $\pm 1$ cost nothing.</source>
        <translation>Produkte und Quotienten, Summen und Differenzen der Rechnung von Hand für diesen Mechanismus; die mit $0$ und $\pm 1$ kosten nichts.</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Gleichungen</translation>
    </message>
    <message>
        <source>Matrix of the equations</source>
        <translation>Matrix der Gleichungen</translation>
    </message>
    <message>
        <source>Entries that are not 0</source>
        <translation>Einträge ungleich 0</translation>
    </message>
    <message>
        <source>From the drawing to the equations</source>
        <translation>Von der Zeichnung zu den Gleichungen</translation>
    </message>
    <message>
        <source>From the equations to the solution</source>
        <translation>Von den Gleichungen zur Lösung</translation>
    </message>
    <message>
        <source>The same in gear ratios</source>
        <translation>Dasselbe in Übersetzungen</translation>
    </message>
    <message>
        <source>With more links</source>
        <translation>Mit mehr Gliedern</translation>
    </message>
    <message>
        <source>The same counted on larger trains. The chain of substitutions grows with the number of meshes times that of the inputs; the inverse of $P_r$ holds all products along the way and grows with its square.</source>
        <translation>Dasselbe, an größeren Getrieben gezählt. Die Substitutionskette wächst mit der Zahl der Eingriffe mal der der Antriebe; die Inverse von $P_r$ enthält alle Produkte entlang des Wegs und wächst mit deren Quadrat.</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Getriebe</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Eingriffe</translation>
    </message>
    <message>
        <source>Inverse and product</source>
        <translation>Inverse und Produkt</translation>
    </message>
    <message>
        <source>Substitution</source>
        <translation>Substitution</translation>
    </message>
    <message>
        <source>Multiplications and additions from the equations to the solution</source>
        <translation>Multiplikationen und Additionen von den Gleichungen zur Lösung</translation>
    </message>
    <message>
        <source>moving links</source>
        <translation>bewegte Glieder</translation>
    </message>
    <message>
        <source>What the paper concludes</source>
        <translation>Was die Arbeit folgert</translation>
    </message>
    <message>
        <source>For it: %1</source>
        <translation>Dafür: %1</translation>
    </message>
    <message>
        <source>Against it: %1</source>
        <translation>Dagegen: %1</translation>
    </message>
    <message>
        <source>The mechanism</source>
        <translation>Der Mechanismus</translation>
    </message>
    <message>
        <source>It has %1, %2 and %3, $k = t + c = %4$ joints in all. The ground is link 0; the other links, the turning joints and the meshes are numbered on from there.</source>
        <translation>Er hat %1, %2 und %3, insgesamt $k = t + c = %4$ Gelenke. Das Gestell ist Glied 0; die anderen Glieder, die Drehgelenke und die Eingriffe sind von da an fortlaufend nummeriert.</translation>
    </message>
    <message>
        <source>$%1$ moving link ($n = %1$)</source>
        <translation>$%1$ bewegtes Glied ($n = %1$)</translation>
    </message>
    <message>
        <source>$%1$ moving links ($n = %1$)</source>
        <translation>$%1$ bewegte Glieder ($n = %1$)</translation>
    </message>
    <message>
        <source>$%1$ turning joint ($t = %1$)</source>
        <translation>$%1$ Drehgelenk ($t = %1$)</translation>
    </message>
    <message>
        <source>$%1$ turning joints ($t = %1$)</source>
        <translation>$%1$ Drehgelenke ($t = %1$)</translation>
    </message>
    <message>
        <source>$%1$ gear mesh ($c = %1$)</source>
        <translation>$%1$ Zahneingriff ($c = %1$)</translation>
    </message>
    <message>
        <source>$%1$ gear meshes ($c = %1$)</source>
        <translation>$%1$ Zahneingriffe ($c = %1$)</translation>
    </message>
    <message>
        <source>Digraph and matrices</source>
        <translation>Digraph und Matrizen</translation>
    </message>
    <message>
        <source>Each link becomes a node, each turning joint a solid arrow from its tail to its head, each gear mesh a dashed one.</source>
        <translation>Jedes Glied wird ein Knoten, jedes Drehgelenk ein durchgezogener Pfeil von seinem Fuß zu seiner Spitze, jeder Zahneingriff ein gestrichelter.</translation>
    </message>
    <message>
        <source>In the incidence matrix an edge&apos;s column holds $-1$ in the row of the link that it leaves and $1$ in the row of the link that it reaches.</source>
        <translation>In der Inzidenzmatrix enthält die Spalte einer Kante $-1$ in der Zeile des Glieds, das sie verlässt, und $1$ in der Zeile des Glieds, das sie erreicht.</translation>
    </message>
    <message>
        <source>Without the row of the ground its rows are independent: $G$ for the turning joints, $G^*$ for the meshes.</source>
        <translation>Ohne die Zeile des Gestells sind ihre Zeilen unabhängig: $G$ für die Drehgelenke, $G^*$ für die Eingriffe.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree of this digraph, so there is nothing more to derive: see the findings above.</source>
        <translation>Die Drehgelenke sind kein Spannbaum dieses Digraphen, sodass nichts weiter herzuleiten ist: siehe die Meldungen oben.</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree. The path matrix holds, for each link, the joints on its path to the ground: $1$ where the path follows the arrow, $-1$ where it runs against it.</source>
        <translation>Die Drehgelenke sind ein Spannbaum. Die Wegmatrix enthält für jedes Glied die Gelenke auf seinem Weg zum Gestell: $1$, wo der Weg dem Pfeil folgt, $-1$, wo er gegen ihn läuft.</translation>
    </message>
    <message>
        <source>Each mesh closes a fundamental cycle with the joints between its two links. They follow from both matrices.</source>
        <translation>Jeder Eingriff schließt mit den Gelenken zwischen seinen beiden Gliedern einen Fundamentalzyklus. Sie folgen aus beiden Matrizen.</translation>
    </message>
    <message>
        <source>With the meshes themselves, each once, this is the cycle-basis matrix.</source>
        <translation>Mit den Eingriffen selbst, jeder einmal, ist dies die Zyklenbasismatrix.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Schrauben</translation>
    </message>
    <message>
        <source>The screw of joint $k$ about the pitch point of mesh $c$ is the unit vector along the joint&apos;s axis, $u_k$, with its moment about that point, $r_{c,k} = l_{c,k} \times u_k$, where $l_{c,k}$ leads from the pitch point to the axis:</source>
        <translation>Die Schraube von Gelenk $k$ um den Wälzpunkt von Eingriff $c$ ist der Einheitsvektor entlang der Gelenkachse, $u_k$, mit seinem Moment um diesen Punkt, $r_{c,k} = l_{c,k} \times u_k$, wobei $l_{c,k}$ vom Wälzpunkt zur Achse führt:</translation>
    </message>
    <message>
        <source>For the joints of each cycle, lengths in %1:</source>
        <translation>Für die Gelenke jedes Zyklus, Längen in %1:</translation>
    </message>
    <message>
        <source>Equations of the meshes</source>
        <translation>Gleichungen der Eingriffe</translation>
    </message>
    <message>
        <source>They all point along one line: the normal of the plane that holds both axes of the mesh. One number of each is enough, its component $P_{c,t}$ along that normal, and each mesh gives one equation:</source>
        <translation>Alle liegen auf einer Geraden: der Normalen der Ebene, die beide Achsen des Eingriffs enthält. Von jedem genügt eine Zahl, seine Komponente $P_{c,t}$ entlang dieser Normalen, und jeder Eingriff ergibt eine Gleichung:</translation>
    </message>
    <message>
        <source>With lengths in %1,</source>
        <translation>Mit Längen in %1,</translation>
    </message>
    <message>
        <source>The entries of a row are the radii of its two gears. Divided by the radius of the head&apos;s gear, the ratios are left:</source>
        <translation>Die Einträge einer Zeile sind die Radien ihrer beiden Räder. Geteilt durch den Radius des Rads an der Spitze bleiben die Übersetzungen:</translation>
    </message>
    <message>
        <source>Engaged couplings</source>
        <translation>Geschlossene Schaltelemente</translation>
    </message>
    <message>
        <source>An engaged brake holds its link against the ground, an engaged clutch makes two links turn as one. The rates of the joints between them add up to zero, once for each direction of their axes: rows below those of the meshes, which stay as they are.</source>
        <translation>Eine geschlossene Bremse hält ihr Glied am Gestell, eine geschlossene Kupplung lässt zwei Glieder gemeinsam drehen. Die Drehgeschwindigkeiten der Gelenke dazwischen ergeben in der Summe null, einmal für jede Richtung ihrer Achsen: Zeilen unter denen der Eingriffe, die bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Schaltelement</translation>
    </message>
    <message>
        <source>Equation</source>
        <translation>Gleichung</translation>
    </message>
    <message>
        <source>The input is joint %1.</source>
        <translation>Der Antrieb ist Gelenk %1.</translation>
    </message>
    <message>
        <source>The inputs are joints %1.</source>
        <translation>Die Antriebe sind die Gelenke %1.</translation>
    </message>
    <message>
        <source>The input is joint %1, chosen by the program because the document names none.</source>
        <translation>Der Antrieb ist Gelenk %1, vom Programm gewählt, weil das Dokument keinen nennt.</translation>
    </message>
    <message>
        <source>The inputs are joints %1, chosen by the program because the document names none.</source>
        <translation>Die Antriebe sind die Gelenke %1, vom Programm gewählt, weil das Dokument keine nennt.</translation>
    </message>
    <message>
        <source>Freedom and inputs</source>
        <translation>Freiheitsgrad und Antriebe</translation>
    </message>
    <message>
        <source>The rank of $P$ with the rows of the couplings, in exact arithmetic, is $r = %1$. The mechanism therefore has</source>
        <translation>Der Rang von $P$ mit den Zeilen der Schaltelemente ist, exakt gerechnet, $r = %1$. Der Mechanismus hat daher</translation>
    </message>
    <message>
        <source>The rank of $P$, in exact arithmetic, is $r = %1$. The mechanism therefore has</source>
        <translation>Der Rang von $P$ ist, exakt gerechnet, $r = %1$. Der Mechanismus hat daher</translation>
    </message>
    <message>
        <source>degrees of freedom. Kutzbach&apos;s count $n - c - h = %1$, with the $h$ rows of couplings, differs, because %2 of the equations follow from the others.</source>
        <translation>Freiheitsgrade. Die Zählung nach Kutzbach, $n - c - h = %1$ mit den $h$ Zeilen der Schaltelemente, weicht ab, weil %2 der Gleichungen aus den anderen folgen.</translation>
    </message>
    <message>
        <source>degrees of freedom. Kutzbach&apos;s count $n - c = %1$ differs, because the equations of %2 of the meshes follow from the others.</source>
        <translation>Freiheitsgrade. Die Zählung nach Kutzbach, $n - c = %1$, weicht ab, weil die Gleichungen von %2 der Eingriffe aus den anderen folgen.</translation>
    </message>
    <message>
        <source>degrees of freedom: as many inputs have to be given.</source>
        <translation>Freiheitsgrade: Ebenso viele Antriebe müssen gegeben sein.</translation>
    </message>
    <message>
        <source>Each direction is the $z$ axis, turned about $x$ by the offset angle $\varphi_k$:</source>
        <translation>Jede Richtung ist die $z$-Achse, um $x$ gedreht um den Versatzwinkel $\varphi_k$:</translation>
    </message>
    <message>
        <source>Each direction is the $z$ axis, turned by a rotation $D_{0,k}$:</source>
        <translation>Jede Richtung ist die $z$-Achse, gedreht mit $D_{0,k}$:</translation>
    </message>
    <message>
        <source>The moment needs the way from the pitch point to a point of the axis:</source>
        <translation>Für das Moment braucht man den Weg vom Wälzpunkt zu einem Punkt der Achse:</translation>
    </message>
    <message>
        <source>The twist of a joint is its screw times its rate:</source>
        <translation>Der Twist eines Gelenks ist seine Schraube mal seine Geschwindigkeit:</translation>
    </message>
    <message>
        <source>Along each cycle the twists, with their signs in $C$, add up to zero:</source>
        <translation>Entlang jedes Zyklus ergeben die Twists, mit ihren Vorzeichen in $C$, zusammen null:</translation>
    </message>
    <message>
        <source>Their directions give the velocity of one gear of each mesh relative to the other. The mesh has no moment about its own pitch point, so the moments of the turning joints alone add up to zero:</source>
        <translation>Ihre Richtungen ergeben die Geschwindigkeit eines Zahnrads jedes Eingriffs relativ zum anderen. Der Eingriff hat kein Moment um seinen eigenen Wälzpunkt; also ergeben die Momente der Drehgelenke allein null:</translation>
    </message>
    <message>
        <source>With the inputs first, the equations are parted into columns of the inputs and of the outputs:</source>
        <translation>Mit den Antrieben zuerst zerfallen die Gleichungen in Spalten der Antriebe und der Abtriebe:</translation>
    </message>
    <message>
        <source>and their solution is</source>
        <translation>und ihre Lösung ist</translation>
    </message>
    <message>
        <source>With the inputs first, and in gear ratios, the equations are</source>
        <translation>Mit den Antrieben zuerst und in Übersetzungen lauten die Gleichungen</translation>
    </message>
    <message>
        <source>Solved for the outputs,</source>
        <translation>Nach den Abtrieben aufgelöst,</translation>
    </message>
    <message>
        <source>there is nothing that turns: without a freedom all rates are $0$.</source>
        <translation>dreht sich nichts: Ohne Freiheitsgrad sind alle Drehgeschwindigkeiten $0$.</translation>
    </message>
    <message>
        <source>With the teeth of this mechanism:</source>
        <translation>Mit den Zähnezahlen dieses Mechanismus:</translation>
    </message>
    <message>
        <source>Written out, some entries are too long to read. One joint after the other they are</source>
        <translation>Ausgeschrieben sind manche Einträge zu lang zum Lesen. Ein Gelenk nach dem anderen lauten sie</translation>
    </message>
    <message>
        <source>At these speeds of the inputs, in rad/s,</source>
        <translation>Bei diesen Drehgeschwindigkeiten der Antriebe, in rad/s,</translation>
    </message>
    <message>
        <source>the outputs turn at</source>
        <translation>drehen sich die Abtriebe mit</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Worked out by the Matroid and the T-T graph method</source>
        <translation>Nach der Matroid- und der T-T-Graph-Methode ausgearbeitet</translation>
    </message>
    <message>
        <source>Both methods compared</source>
        <translation>Beide Methoden im Vergleich</translation>
    </message>
    <message>
        <source>It has $%1 \times %2$ entries, too many to print: &quot;export --to csv --matrix %3&quot; writes them.</source>
        <translation>Sie hat $%1 \times %2$ Einträge, zu viele zum Drucken: „export --to csv --matrix %3“ schreibt sie.</translation>
    </message>
    <message>
        <source>Statics</source>
        <translation>Statik</translation>
    </message>
    <message>
        <source>What holds the loads follows from the same matrices, read down their columns. A starred number belongs to the equation of the kinematics beside it. A torque $\tau_e$ acts in joint $e$, by its tail on its head, about the direction of its axis; $\ell_e$ is the power of the loads on links beyond the joint for its rate $1$; $F_c$ is the tangential force of mesh $c$, by the tail&apos;s gear on the head&apos;s.</source>
        <translation>Was die Lasten hält, folgt aus denselben Matrizen, spaltenweise gelesen. Eine Nummer mit Stern gehört zur Gleichung der Kinematik neben ihr. Ein Moment $\tau_e$ wirkt in Gelenk $e$, von dessen Fuß auf dessen Spitze, um die Richtung seiner Achse; $\ell_e$ ist die Leistung der Lasten auf Glieder jenseits des Gelenks für dessen Drehgeschwindigkeit $1$; $F_c$ ist die Umfangskraft von Eingriff $c$, vom Rad am Fuß auf das an der Spitze.</translation>
    </message>
    <message>
        <source>Cutset equations</source>
        <translation>Schnittgleichungen</translation>
    </message>
    <message>
        <source>Without joint $e$ the tree falls into two parts. The edges that lead from one to the other are its fundamental cutset. It crosses each cycle as often along the cycle as against it:</source>
        <translation>Ohne Gelenk $e$ zerfällt der Baum in zwei Teile. Die Kanten, die von einem zum anderen führen, sind seine fundamentale Schnittmenge. Sie kreuzt jeden Zyklus ebenso oft mit ihm wie gegen ihn:</translation>
    </message>
    <message>
        <source>So the part beyond a joint is in equilibrium if the torque in the joint and the loads hold the forces of the meshes that cross the cutset. Their moments about the joint&apos;s axis are the entries of its column of $P$; forces along the line of centres or along an axis do no work and are in no equation:</source>
        <translation>Der Teil jenseits eines Gelenks ist also im Gleichgewicht, wenn das Moment im Gelenk und die Lasten den Kräften der Eingriffe das Gleichgewicht halten, die die Schnittmenge kreuzen. Deren Momente um die Gelenkachse sind die Einträge seiner Spalte von $P$; Kräfte entlang der Mittenlinie oder einer Achse leisten keine Arbeit und stehen in keiner Gleichung:</translation>
    </message>
    <message>
        <source>There are too many to print: &quot;export --to csv --matrix cutset-equations&quot; writes them.</source>
        <translation>Es sind zu viele zum Drucken: „export --to csv --matrix cutset-equations“ schreibt sie.</translation>
    </message>
    <message>
        <source>An engaged coupling is a further edge of the graph, with its torque $T$.</source>
        <translation>Ein geschlossenes Schaltelement ist eine weitere Kante des Graphen, mit seinem Moment $T$.</translation>
    </message>
    <message>
        <source>With lengths in %1, so that torques are in N %1, joint by joint,</source>
        <translation>Mit Längen in %1, sodass Momente in N %1 sind, Gelenk für Gelenk,</translation>
    </message>
    <message>
        <source>The transposed solution</source>
        <translation>Die transponierte Lösung</translation>
    </message>
    <message>
        <source>The torque in every balanced joint for one unit of torque in each loaded one: the solution of the speeds, transposed, with the opposite sign.</source>
        <translation>Das Moment in jedem ausgleichenden Gelenk für eine Einheit des Moments in jedem belasteten: die Lösung der Geschwindigkeiten, transponiert und mit umgekehrtem Vorzeichen.</translation>
    </message>
    <message>
        <source>A row for each joint and a column for each mesh: the lever of the mesh&apos;s force about the joint&apos;s axis. It is P transposed; a row times the forces is the torque in the joint and that of the loads beyond it.</source>
        <translation>Eine Zeile für jedes Gelenk und eine Spalte für jeden Zahneingriff: der Hebelarm der Kraft des Zahneingriffs um die Achse des Gelenks. Es ist P transponiert; eine Zeile mal die Kräfte ist das Moment im Gelenk und das der Lasten dahinter.</translation>
    </message>
    <message>
        <source>The torques in the balanced joints, $\tau_E$, hold those in the others, $\tau_r$. With the columns of $P$ in the same order as for the speeds,</source>
        <translation>Die Momente in den Gelenken mit Ausgleichsmoment, $\tau_E$, halten die in den anderen, $\tau_r$. Mit den Spalten von $P$ in derselben Reihenfolge wie für die Drehgeschwindigkeiten</translation>
    </message>
    <message>
        <source>which in ratios is (25) transposed, with the opposite sign:</source>
        <translation>was in Übersetzungen (25) transponiert ist, mit dem entgegengesetzten Vorzeichen:</translation>
    </message>
    <message>
        <source>Torques under the loads</source>
        <translation>Momente unter den Lasten</translation>
    </message>
    <message>
        <source>The loads of the document are held by these torques, in N m, in a train without losses:</source>
        <translation>Die Lasten des Dokuments werden in einem verlustfreien Getriebe von diesen Momenten gehalten, in N m:</translation>
    </message>
    <message>
        <source>The tangential forces of the meshes, in N, are</source>
        <translation>Die Umfangskräfte der Eingriffe, in N, sind</translation>
    </message>
    <message>
        <source>The same by the T-T graph</source>
        <translation>Dasselbe mit dem T-T-Graphen</translation>
    </message>
    <message>
        <source>A mesh loses no power at its two ports, so the torques on its gears, seen from the carrier, are in the inverse ratio of their speeds:</source>
        <translation>Ein Eingriff verliert an seinen beiden Toren keine Leistung, also stehen die Momente auf seine Räder, vom Steg aus gesehen, im umgekehrten Verhältnis ihrer Drehgeschwindigkeiten:</translation>
    </message>
    <message>
        <source>Each branch of the tree has a fundamental cutset, with the coefficients of the circuits that the branch belongs to:</source>
        <translation>Jeder Zweig des Baums hat eine fundamentale Schnittmenge, mit den Koeffizienten der Kreise, zu denen der Zweig gehört:</translation>
    </message>
    <message>
        <source>These cutsets as the rows of a matrix, the torques in the branches before the line, those of the chords after it; loads and engaged couplings come in addition:</source>
        <translation>Diese Schnittmengen als Zeilen einer Matrix, die Momente in den Zweigen vor dem Strich, die der Sehnen dahinter; Lasten und geschlossene Schaltelemente kommen hinzu:</translation>
    </message>
    <message>
        <source>The Matroid method&apos;s $Q$ has the same rows. A mesh is one edge there and has a chord to each gear here, so its column of $Q$ is that of the chord of the head&apos;s gear less that of the tail&apos;s:</source>
        <translation>Das $Q$ der Matroid-Methode hat dieselben Zeilen. Ein Eingriff ist dort eine Kante und hat hier eine Sehne zu jedem Rad, also ist seine Spalte von $Q$ die der Sehne des Rads an der Spitze minus die der Sehne am Fuß:</translation>
    </message>
    <message>
        <source>The chain runs from the loads back to the motors: a cutset with one unknown left gives it, the terminal equation of its mesh the other torque.</source>
        <translation>Die Kette läuft von den Lasten zurück zu den Motoren: Eine Schnittmenge mit nur noch einer Unbekannten ergibt diese, die Klemmengleichung ihres Eingriffs das andere Moment.</translation>
    </message>
    <message>
        <source>Torque by torque, both methods give the same fractions: all %1 entries agree.</source>
        <translation>Moment für Moment ergeben beide Methoden dieselben Brüche: Alle %1 Einträge stimmen überein.</translation>
    </message>
    <message>
        <source>The two methods differ by up to %1 N m.</source>
        <translation>Die beiden Methoden unterscheiden sich um bis zu %1 N m.</translation>
    </message>
    <message>
        <source>In symbols, too: eliminated in the gear ratios, the cutsets of the T-T graph give the torque matrix of (25) transposed, entry by entry.</source>
        <translation>Auch in Symbolen: In den Übersetzungen eliminiert, ergeben die Schnittmengen des T-T-Graphen Eintrag für Eintrag die transponierte Momentenmatrix von (25).</translation>
    </message>
    <message>
        <source>In symbols the two torque matrices differ.</source>
        <translation>In Symbolen unterscheiden sich die beiden Momentenmatrizen.</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>The turning joints are the branches of the graph&apos;s tree. Each carries the letter of its axis, its level.</source>
        <translation>Die Drehgelenke sind die Zweige des Baums des Graphen. Jeder trägt den Buchstaben seiner Achse, seine Ebene.</translation>
    </message>
    <message>
        <source>Carriers</source>
        <translation>Stege</translation>
    </message>
    <message>
        <source>From one gear of a mesh through the branches to the other, the level changes at one link: the transfer vertex, which carries both gears. A mesh is written as its gear pair and its carrier.</source>
        <translation>Vom einen Rad eines Eingriffs durch die Zweige zum anderen wechselt die Ebene an einem Glied: dem Transferknoten, der beide Räder trägt. Ein Eingriff wird als sein Räderpaar und sein Steg geschrieben.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Eingriff</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Pair and carrier</source>
        <translation>Paar und Steg</translation>
    </message>
    <message>
        <source>no transfer vertex</source>
        <translation>kein Transferknoten</translation>
    </message>
    <message>
        <source>Terminal equations</source>
        <translation>Klemmengleichungen</translation>
    </message>
    <message>
        <source>Seen from its carrier, one gear of a pair turns as fast as the other times the ratio of their teeth, with a plus sign where both turn the same way, each seen along its own axis:</source>
        <translation>Von seinem Steg aus gesehen dreht sich ein Rad eines Paars so schnell wie das andere mal dem Verhältnis ihrer Zähnezahlen, mit einem Pluszeichen, wo sich beide, jedes entlang seiner eigenen Achse gesehen, gleichsinnig drehen:</translation>
    </message>
    <message>
        <source>Fundamental circuits</source>
        <translation>Fundamentalkreise</translation>
    </message>
    <message>
        <source>Each of these velocities closes a circuit with branches of the tree, and is the sum along the branches:</source>
        <translation>Jede dieser Geschwindigkeiten schließt mit Zweigen des Baums einen Kreis und ist die Summe entlang der Zweige:</translation>
    </message>
    <message>
        <source>An engaged brake or clutch is one more edge of the graph, from the link that it holds to the ground or to the other link. Its velocity is zero, so the branches of its fundamental circuit add up to zero, once for each direction of their axes:</source>
        <translation>Eine geschlossene Bremse oder Kupplung ist eine weitere Kante des Graphen, von dem Glied, das sie hält, zum Gestell oder zum anderen Glied. Ihre Geschwindigkeit ist null, also ergeben die Zweige ihres Fundamentalkreises in der Summe null, einmal für jede Richtung ihrer Achsen:</translation>
    </message>
    <message>
        <source>Solution by substitution</source>
        <translation>Lösung durch Einsetzen</translation>
    </message>
    <message>
        <source>Given is %1.</source>
        <translation>Gegeben ist %1.</translation>
    </message>
    <message>
        <source>Given are %1.</source>
        <translation>Gegeben sind %1.</translation>
    </message>
    <message>
        <source>Mesh by mesh, the equations give the others.</source>
        <translation>Eingriff für Eingriff ergeben die Gleichungen die anderen.</translation>
    </message>
    <message>
        <source>One after the other, the equations give the others.</source>
        <translation>Eine nach der anderen ergeben die Gleichungen die anderen.</translation>
    </message>
    <message>
        <source>Equation %1 gives %2:</source>
        <translation>Gleichung %1 ergibt %2:</translation>
    </message>
    <message>
        <source>Equations %1 give %2:</source>
        <translation>Die Gleichungen %1 ergeben %2:</translation>
    </message>
    <message>
        <source>The equations of several meshes and couplings, solved together, give %1:</source>
        <translation>Die Gleichungen mehrerer Eingriffe und Schaltelemente ergeben, zusammen gelöst, %1:</translation>
    </message>
    <message>
        <source>The equations of several meshes, solved together, give %1:</source>
        <translation>Die Gleichungen mehrerer Eingriffe ergeben, zusammen gelöst, %1:</translation>
    </message>
    <message>
        <source>Together:</source>
        <translation>Zusammen:</translation>
    </message>
    <message>
        <source>With the names of the ratios that the matroid method uses,</source>
        <translation>Mit den Namen der Übersetzungen, die die Matroid-Methode verwendet,</translation>
    </message>
    <message>
        <source>this is</source>
        <translation>ist dies</translation>
    </message>
    <message>
        <source>a mechanism without errors, and at most 250,000 entries</source>
        <translation>ein Mechanismus ohne Fehler und höchstens 250.000 Einträge</translation>
    </message>
    <message>
        <source>a carrier and a sign of every mesh</source>
        <translation>ein Steg und ein Vorzeichen für jeden Zahneingriff</translation>
    </message>
    <message>
        <source>a geometry of every mesh</source>
        <translation>die Geometrie jedes Eingriffs</translation>
    </message>
    <message>
        <source>balances in joints that hold all loads, and at most 250,000 entries</source>
        <translation>Ausgleichsmomente in Gelenken, die alle Lasten halten, und höchstens 250.000 Einträge</translation>
    </message>
    <message>
        <source>loads, and balances that hold them</source>
        <translation>Lasten und Ausgleichsmomente, die sie halten</translation>
    </message>
    <message>
        <source>states of a gearbox</source>
        <translation>Schaltzustände</translation>
    </message>
    <message>
        <source>a spanning tree</source>
        <translation>einen Spannbaum</translation>
    </message>
    <message>
        <source>The handout has no still picture: %1</source>
        <translation>Das Handout hat kein Standbild: %1</translation>
    </message>
    <message>
        <source>About %1 triangles are more than the limit of %2</source>
        <translation>Etwa %1 Dreiecke sind mehr als die Grenze von %2</translation>
    </message>
    <message>
        <source>The file shows the first %1 s of it, at its speed; it does not end where it began.</source>
        <translation>Die Datei zeigt die ersten %1 s davon, mit ihrer Geschwindigkeit; sie endet nicht, wo sie begann.</translation>
    </message>
    <message>
        <source>The motion in the file goes there and back within the limits of joints: %1.</source>
        <translation>Die Bewegung in der Datei geht innerhalb der Grenzen von Gelenken hin und zurück: %1.</translation>
    </message>
    <message>
        <source>Nothing in the file moves.</source>
        <translation>In der Datei bewegt sich nichts.</translation>
    </message>
    <message>
        <source>A mechanism with errors has no gears</source>
        <translation>Ein Mechanismus mit Fehlern hat keine Räder</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot; with solids</source>
        <translation>Es gibt kein Glied „%1“ mit Körpern</translation>
    </message>
    <message>
        <source>There is no gear &quot;%1&quot;; gears are named like 15:tail, 15:head</source>
        <translation>Es gibt kein Rad „%1“; Räder heißen wie 15:tail, 15:head</translation>
    </message>
    <message>
        <source>the assembly</source>
        <translation>der Zusammenbau</translation>
    </message>
    <message>
        <source>(pinned)</source>
        <translation>(fixiert)</translation>
    </message>
    <message>
        <source>One of %1 equal planets is drawn: %2 is like %3.</source>
        <translation>Von %1 gleichen Planeten ist einer gezeichnet: %2 ist wie %3.</translation>
    </message>
    <message>
        <source>One of %1 equal planets is drawn: %2 are like %3.</source>
        <translation>Von %1 gleichen Planeten ist einer gezeichnet: %2 sind wie %3.</translation>
    </message>
    <message>
        <source>One of %1 equal sets of planets is drawn: %2 is like %3.</source>
        <translation>Von %1 gleichen Planetensätzen ist einer gezeichnet: %2 ist wie %3.</translation>
    </message>
    <message>
        <source>One of %1 equal sets of planets is drawn: %2 are like %3.</source>
        <translation>Von %1 gleichen Planetensätzen ist einer gezeichnet: %2 sind wie %3.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. Radii are not to scale.</source>
        <translation>Abgewickelt: Die Achsen liegen nicht in einer Ebene. Radien sind nicht maßstäblich.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 is turned into the sheet.</source>
        <translation>Abgewickelt: Die Achsen liegen nicht in einer Ebene. %1 ist in die Zeichenebene gedreht.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 are turned into the sheet.</source>
        <translation>Abgewickelt: Die Achsen liegen nicht in einer Ebene. %1 sind in die Zeichenebene gedreht.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 of them are turned into the sheet.</source>
        <translation>Abgewickelt: Die Achsen liegen nicht in einer Ebene. %1 davon sind in die Zeichenebene gedreht.</translation>
    </message>
    <message>
        <source>Wheels that a dashed line joins mesh, though they do not touch here.</source>
        <translation>Räder, die eine gestrichelte Linie verbindet, kämmen miteinander, obwohl sie sich hier nicht berühren.</translation>
    </message>
    <message>
        <source>Link %1 is not drawn: no turning joint ties it to the ground.</source>
        <translation>Glied %1 ist nicht gezeichnet: Kein Drehgelenk verbindet es mit dem Gestell.</translation>
    </message>
    <message>
        <source>Links %1 are not drawn: no turning joint ties them to the ground.</source>
        <translation>Glieder %1 sind nicht gezeichnet: Kein Drehgelenk verbindet sie mit dem Gestell.</translation>
    </message>
    <message>
        <source>Joint %1 closes a loop and is not drawn.</source>
        <translation>Gelenk %1 schließt eine Schleife und ist nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Joints %1 close a loop and are not drawn.</source>
        <translation>Gelenke %1 schließen eine Schleife und sind nicht gezeichnet.</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1, variant %2</source>
        <translation>%1, Variante %2</translation>
    </message>
    <message>
        <source>%1: solution</source>
        <translation>%1: Lösung</translation>
    </message>
    <message>
        <source>Name: %1</source>
        <translation>Name: %1</translation>
    </message>
    <message>
        <source>%1 question</source>
        <translation>%1 Frage</translation>
    </message>
    <message>
        <source>%1 questions</source>
        <translation>%1 Fragen</translation>
    </message>
    <message>
        <source>Brake or clutch</source>
        <translation>Bremse oder Kupplung</translation>
    </message>
    <message>
        <source>Engaged, it holds</source>
        <translation>Geschlossen hält sie</translation>
    </message>
    <message>
        <source>link %1 against the ground</source>
        <translation>Glied %1 am Gestell</translation>
    </message>
    <message>
        <source>links %1 together</source>
        <translation>Glieder %1 aneinander</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Angular speed</source>
        <translation>Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>Traced points</source>
        <translation>Verfolgte Punkte</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Gestell</translation>
    </message>
    <message>
        <source>point %1 of %2</source>
        <translation>Punkt %1 von %2</translation>
    </message>
    <message>
        <source>link %1: %2</source>
        <translation>Glied %1: %2</translation>
    </message>
    <message>
        <source>Shared by equal stiffness of all teeth: an assumption.</source>
        <translation>Nach gleicher Steifigkeit aller Zähne aufgeteilt: eine Annahme.</translation>
    </message>
    <message>
        <source>Loads: %1.</source>
        <translation>Lasten: %1.</translation>
    </message>
    <message>
        <source>joint %1 at %2°</source>
        <translation>Gelenk %1 bei %2°</translation>
    </message>
    <message>
        <source>It is not in the folder of the document: copy it there.</source>
        <translation>Sie liegt nicht im Ordner des Dokuments: Kopieren Sie sie dorthin.</translation>
    </message>
    <message>
        <source>The memory does not suffice for the pictures.</source>
        <translation>Der Speicher reicht für die Bilder nicht aus.</translation>
    </message>
    <message>
        <source>The driver painted nothing.</source>
        <translation>Der Treiber hat nichts gezeichnet.</translation>
    </message>
    <message>
        <source>The memory does not suffice for the labels.</source>
        <translation>Der Speicher reicht für die Beschriftungen nicht aus.</translation>
    </message>
    <message>
        <source>The file could not be written.</source>
        <translation>Die Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written.</source>
        <translation>„%1“ konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder.</source>
        <translation>„%1“ ist kein Ordner.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; is not empty; nothing was written.</source>
        <translation>Der Ordner „%1“ ist nicht leer; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>No folder could be made beside &quot;%1&quot;.</source>
        <translation>Neben „%1“ konnte kein Ordner angelegt werden.</translation>
    </message>
    <message>
        <source>The driver paints pictures of up to %1 pixels a side; choose a smaller size.</source>
        <translation>Der Treiber zeichnet Bilder mit bis zu %1 Pixeln je Seite; wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>Gear %1 has %2 teeth, too fine to be distinguished: it is shown without them.</source>
        <translation>Rad %1 hat %2 Zähne, zu fein, um sie zu unterscheiden: Es wird ohne sie gezeigt.</translation>
    </message>
    <message>
        <source>Link %1 wears &quot;%2&quot;, which is not shown: %3</source>
        <translation>Glied %1 trägt „%2“, das nicht gezeigt wird: %3</translation>
    </message>
    <message>
        <source>A train of %1 gears: its wheels are plain discs, its shafts and arms are straight and pass through what they meet (up to %2 gears they are routed past it).</source>
        <translation>Ein Getriebe mit %1 Rädern: Seine Räder sind glatte Scheiben, seine Wellen und Arme sind gerade und gehen durch das hindurch, was ihnen begegnet (bis zu %2 Rädern werden sie darum herumgeführt).</translation>
    </message>
    <message>
        <source>gears in a row</source>
        <translation>Räder in einer Reihe</translation>
    </message>
    <message>
        <source>planetary sets in line</source>
        <translation>Planetensätze hintereinander</translation>
    </message>
    <message>
        <source>arms of a bevel-gear wrist</source>
        <translation>Arme eines Kegelrad-Handgelenks</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 equation</source>
        <translation>%1 Gleichung</translation>
    </message>
    <message>
        <source>%1 equations</source>
        <translation>%1 Gleichungen</translation>
    </message>
    <message>
        <source>%1 unknown</source>
        <translation>%1 Unbekannten</translation>
    </message>
    <message>
        <source>%1 unknowns</source>
        <translation>%1 Unbekannten</translation>
    </message>
    <message>
        <source>%1 product</source>
        <translation>%1 Produkt</translation>
    </message>
    <message>
        <source>%1 products</source>
        <translation>%1 Produkte</translation>
    </message>
    <message>
        <source>%1 sum</source>
        <translation>%1 Summe</translation>
    </message>
    <message>
        <source>%1 sums</source>
        <translation>%1 Summen</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>digraph: a node for each link, an oriented line for each joint and mesh (Figs. 2, 3)</source>
        <translation>Digraph: ein Knoten für jedes Glied, eine gerichtete Linie für jedes Gelenk und jeden Eingriff (Bilder 2, 3)</translation>
    </message>
    <message>
        <source>oriented graph: the same nodes and branches, and for each mesh two chords to its carrier (Figs. 4 to 6)</source>
        <translation>gerichteter Graph: dieselben Knoten und Zweige, und für jeden Eingriff zwei Sehnen zu seinem Steg (Bilder 4 bis 6)</translation>
    </message>
    <message>
        <source>The turning joints are the tree in both, the meshes close its cycles.</source>
        <translation>Die Drehgelenke sind in beiden der Baum, die Eingriffe schließen seine Zyklen.</translation>
    </message>
    <message>
        <source>Tree and cycles</source>
        <translation>Baum und Zyklen</translation>
    </message>
    <message>
        <source>incidence matrix (1), (2), path matrix $Z$ (3), spanning tree (4), $C$ (5)</source>
        <translation>Inzidenzmatrix (1), (2), Wegmatrix $Z$ (3), Spannbaum (4), $C$ (5)</translation>
    </message>
    <message>
        <source>levels of the branches; f-circuits of the chords (31)-(38)</source>
        <translation>Ebenen der Zweige; f-Kreise der Sehnen (31)-(38)</translation>
    </message>
    <message>
        <source>The cycle of a mesh is the circuit of its tail&apos;s chord less that of its head&apos;s chord.</source>
        <translation>Der Zyklus eines Eingriffs ist der Kreis seiner Sehne am Fuß minus der seiner Sehne an der Spitze.</translation>
    </message>
    <message>
        <source>Carrier</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>not named: it drops out of the moments about the pitch point</source>
        <translation>nicht benannt: Er fällt aus den Momenten um den Wälzpunkt heraus</translation>
    </message>
    <message>
        <source>transfer vertex: where the level changes on the walk between the gears</source>
        <translation>Transferknoten: wo auf dem Weg zwischen den Rädern die Ebene wechselt</translation>
    </message>
    <message>
        <source>The moments of a cycle&apos;s joints lie on one line because the carrier holds both axes.</source>
        <translation>Die Momente der Gelenke eines Zyklus liegen auf einer Geraden, weil der Steg beide Achsen hält.</translation>
    </message>
    <message>
        <source>screws about the pitch point (6)-(13), one row of $P$ (16)-(19): $i_c$ on the tail&apos;s axis, $\pm 1$ on the head&apos;s</source>
        <translation>Schrauben um den Wälzpunkt (6)-(13), eine Zeile von $P$ (16)-(19): $i_c$ auf der Achse des Fußes, $\pm 1$ auf der der Spitze</translation>
    </message>
    <message>
        <source>terminal equation (26)-(30): speeds seen from the carrier, a ratio and a sign</source>
        <translation>Klemmengleichung (26)-(30): Geschwindigkeiten vom Steg aus gesehen, ein Verhältnis und ein Vorzeichen</translation>
    </message>
    <message>
        <source>The terminal equation with its two circuits put in is the row of $P$.</source>
        <translation>Die Klemmengleichung mit ihren beiden Kreisen eingesetzt ist die Zeile von $P$.</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Vorzeichen</translation>
    </message>
    <message>
        <source>comes with the diameters in the reference frame</source>
        <translation>kommt mit den Durchmessern im Bezugssystem</translation>
    </message>
    <message>
        <source>from the turning senses of the two gears, seen along their axes</source>
        <translation>aus den Drehsinnen der beiden Räder, entlang ihrer Achsen gesehen</translation>
    </message>
    <message>
        <source>The signs agree: both are that of the product of the two moments.</source>
        <translation>Die Vorzeichen stimmen überein: Beide sind das des Produkts der zwei Momente.</translation>
    </message>
    <message>
        <source>rank of $P$, $E = t - r$ (21); bases of the dual matroid are the valid inputs</source>
        <translation>Rang von $P$, $E = t - r$ (21); Basen des dualen Matroids sind die zulässigen Antriebe</translation>
    </message>
    <message>
        <source>not asked: the inputs are taken as given</source>
        <translation>nicht gefragt: Die Antriebe gelten als gegeben</translation>
    </message>
    <message>
        <source>What can be driven is read from $P$.</source>
        <translation>Was sich antreiben lässt, liest man aus $P$ ab.</translation>
    </message>
    <message>
        <source>$-P_r^{-1} P_E$ (22)-(25)</source>
        <translation>$-P_r^{-1} P_E$ (22)-(25)</translation>
    </message>
    <message>
        <source>one mesh after the other, substituted (39)-(42), then (43)-(45)</source>
        <translation>ein Eingriff nach dem anderen, eingesetzt (39)-(42), dann (43)-(45)</translation>
    </message>
    <message>
        <source>The same matrix, by joint.</source>
        <translation>Dieselbe Matrix, nach Gelenken.</translation>
    </message>
    <message>
        <source>Relative velocities</source>
        <translation>Relativgeschwindigkeiten</translation>
    </message>
    <message>
        <source>of the two gears of a mesh to each other (15), after the solution</source>
        <translation>der beiden Räder eines Eingriffs zueinander (15), nach der Lösung</translation>
    </message>
    <message>
        <source>of each gear to its carrier: the chords, on the way to the solution</source>
        <translation>jedes Rads gegen seinen Steg: die Sehnen, auf dem Weg zur Lösung</translation>
    </message>
    <message>
        <source>(15) is the difference of the two chords, as vectors.</source>
        <translation>(15) ist die Differenz der beiden Sehnen, als Vektoren.</translation>
    </message>
    <message>
        <source>columns of $P$ (not in the paper)</source>
        <translation>Spalten von $P$ (nicht in der Arbeit)</translation>
    </message>
    <message>
        <source>complementary terminal variables and f-cutsets (not worked out in the paper)</source>
        <translation>komplementäre Klemmenvariable und f-Schnittmengen (in der Arbeit nicht ausgeführt)</translation>
    </message>
    <message>
        <source>The cutset matrix $Q$ serves both.</source>
        <translation>Die Schnittmatrix $Q$ dient beiden.</translation>
    </message>
    <message>
        <source>&quot;The kinematic equations can be obtained more easily by the T-T graph method.&quot;</source>
        <translation>„Die kinematischen Gleichungen lassen sich mit der T-T-Graph-Methode leichter gewinnen.“</translation>
    </message>
    <message>
        <source>From its equations to the solution of this mechanism the chain of substitutions takes %1, the inverse of $P_r$ and its product %2.</source>
        <translation>Von ihren Gleichungen zur Lösung dieses Mechanismus braucht die Substitutionskette %1, die Inverse von $P_r$ und ihr Produkt %2.</translation>
    </message>
    <message>
        <source>It needs teeth and turning senses; the rows of $P$ need coordinates of axes and pitch points, and %1 from them.</source>
        <translation>Sie braucht Zähnezahlen und Drehsinne; die Zeilen von $P$ brauchen Koordinaten von Achsen und Wälzpunkten und daraus %1.</translation>
    </message>
    <message>
        <source>It writes %1 in %2, the Matroid method %3 in %4.</source>
        <translation>Sie schreibt %1 mit %2, die Matroid-Methode %3 mit %4.</translation>
    </message>
    <message>
        <source>Once a row of $P$ is divided by a radius it is the terminal equation with its circuits put in: solved in the same order, both take the same steps.</source>
        <translation>Durch einen Radius geteilt ist eine Zeile von $P$ die Klemmengleichung mit ihren Kreisen eingesetzt: In derselben Reihenfolge gelöst, machen beide dieselben Schritte.</translation>
    </message>
    <message>
        <source>&quot;The only advantage of the Matroid method is the derivation of the relative velocities of the gears with respect to the carrier arm.&quot;</source>
        <translation>„Der einzige Vorteil der Matroid-Methode ist die Herleitung der Relativgeschwindigkeiten der Räder gegenüber dem Steg.“</translation>
    </message>
    <message>
        <source>(15) gives them as vectors, for skew and meeting axes alike.</source>
        <translation>(15) gibt sie als Vektoren, für windschiefe wie für sich schneidende Achsen.</translation>
    </message>
    <message>
        <source>The chords of the T-T graph are velocities relative to the carrier, too.</source>
        <translation>Auch die Sehnen des T-T-Graphen sind Geschwindigkeiten relativ zum Steg.</translation>
    </message>
    <message>
        <source>The rank of $P$ gives the degrees of freedom, redundant meshes and every valid set of inputs; the T-T graph takes the inputs as given.</source>
        <translation>Der Rang von $P$ ergibt den Freiheitsgrad, redundante Eingriffe und jeden zulässigen Satz von Antrieben; der T-T-Graph nimmt die Antriebe als gegeben.</translation>
    </message>
    <message>
        <source>&quot;The sign of the gear ratio is obtained directly, without considering the turning direction.&quot;</source>
        <translation>„Das Vorzeichen der Übersetzung ergibt sich unmittelbar, ohne Betrachtung des Drehsinns.“</translation>
    </message>
    <message>
        <source>The sign of each entry of $P$ is that of a difference of coordinates.</source>
        <translation>Das Vorzeichen jedes Eintrags von $P$ ist das einer Koordinatendifferenz.</translation>
    </message>
    <message>
        <source>The senses have to be seen once a mesh: here %1 of %2 turn against each other, seen along their axes.</source>
        <translation>Die Drehsinne müssen einmal je Eingriff gesehen werden: Hier drehen sich, entlang ihrer Achsen gesehen, %1 von %2 gegensinnig.</translation>
    </message>
    <message>
        <source>%1 pair</source>
        <translation>%1 Paar</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 Paare</translation>
    </message>
    <message>
        <source>Mesh %1</source>
        <translation>Eingriff %1</translation>
    </message>
    <message>
        <source>%1 points to link %2: its arrow ends there.</source>
        <translation>%1 zeigt auf Glied %2: Sein Pfeil endet dort.</translation>
    </message>
    <message>
        <source>%1 leaves link %2: its arrow begins there.</source>
        <translation>%1 verlässt Glied %2: Sein Pfeil beginnt dort.</translation>
    </message>
    <message>
        <source>%1 goes from link %2 to link %3 and does not touch link %4.</source>
        <translation>%1 geht von Glied %2 zu Glied %3 und berührt Glied %4 nicht.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground does not use %2.</source>
        <translation>Der Weg von Glied %1 zum Gestell benutzt %2 nicht.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground runs along %2 (from %3 to %4).</source>
        <translation>Der Weg von Glied %1 zum Gestell läuft mit %2 (von %3 nach %4).</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground runs against %2 (from %3 to %4).</source>
        <translation>Der Weg von Glied %1 zum Gestell läuft gegen %2 (von %3 nach %4).</translation>
    </message>
    <message>
        <source>%1 is the cycle that %2 closes, walked along its arrow (from %3 to %4).</source>
        <translation>%1 ist der Zyklus, den %2 schließt, entlang seines Pfeils durchlaufen (von %3 nach %4).</translation>
    </message>
    <message>
        <source>A cycle of the basis holds one mesh, its own: %1 holds %2, not %3.</source>
        <translation>Ein Zyklus der Basis enthält einen Eingriff, seinen eigenen: %1 enthält %2, nicht %3.</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 does not use %5.</source>
        <translation>Durchläuft man %1 entlang %2, so benutzt der Weg von %3 zurück nach %4 nicht %5.</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 runs along %5 (from %6 to %7).</source>
        <translation>Durchläuft man %1 entlang %2, so läuft der Weg von %3 zurück nach %4 mit %5 (von %6 nach %7).</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 runs against %5 (from %6 to %7).</source>
        <translation>Durchläuft man %1 entlang %2, so läuft der Weg von %3 zurück nach %4 gegen %5 (von %6 nach %7).</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; its own arrow counts as 1.</source>
        <translation>Ohne %1 zerfällt der Baum in zwei Hälften; der eigene Pfeil zählt als 1.</translation>
    </message>
    <message>
        <source>A cutset holds one turning joint, its own: %1, not %2.</source>
        <translation>Eine Schnittmenge enthält ein Drehgelenk, ihr eigenes: %1, nicht %2.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 stays in one of them.</source>
        <translation>Ohne %1 zerfällt der Baum in zwei Hälften; %2 bleibt in einer davon.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 crosses over in the direction of %1.</source>
        <translation>Ohne %1 zerfällt der Baum in zwei Hälften; %2 führt in Richtung von %1 hinüber.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 crosses over against %1.</source>
        <translation>Ohne %1 zerfällt der Baum in zwei Hälften; %2 führt gegen %1 hinüber.</translation>
    </message>
    <message>
        <source>Cutset of %1, %2</source>
        <translation>Schnittmenge von %1, %2</translation>
    </message>
    <message>
        <source>%1, link %2</source>
        <translation>%1, Glied %2</translation>
    </message>
    <message>
        <source>Not in the paper.</source>
        <translation>Nicht in der Arbeit.</translation>
    </message>
    <message>
        <source>The row divided by the radius of the head&apos;s gear: %1 turns about the axis of the tail&apos;s gear, which leaves the ratio i%2 = %3.</source>
        <translation>Die Zeile geteilt durch den Radius des Rads an der Spitze: %1 dreht um die Achse des Rads am Fuß, das lässt die Übersetzung i%2 = %3.</translation>
    </message>
    <message>
        <source>The row divided by the radius of the head&apos;s gear: %1 turns about the axis of the head&apos;s gear, which leaves 1.</source>
        <translation>Die Zeile geteilt durch den Radius des Rads an der Spitze: %1 dreht um die Achse des Rads an der Spitze, das lässt 1.</translation>
    </message>
    <message>
        <source>T times the moment of %1&apos;s axis about the pitch point of mesh %2, along the normal of the mesh: the radius of the tail&apos;s gear.</source>
        <translation>T mal das Moment der Achse von %1 um den Wälzpunkt von Eingriff %2, entlang der Normalen des Eingriffs: der Radius des Rads am Fuß.</translation>
    </message>
    <message>
        <source>T times the moment of %1&apos;s axis about the pitch point of mesh %2, along the normal of the mesh: the radius of the head&apos;s gear.</source>
        <translation>T mal das Moment der Achse von %1 um den Wälzpunkt von Eingriff %2, entlang der Normalen des Eingriffs: der Radius des Rads an der Spitze.</translation>
    </message>
    <message>
        <source>%1 does not use %2, so it has no part in the equation of mesh %3.</source>
        <translation>%1 benutzt %2 nicht, also kommt es in der Gleichung von Eingriff %3 nicht vor.</translation>
    </message>
    <message>
        <source>f-circuit matrix of the T–T graph</source>
        <translation>Fundamentalkreismatrix des T–T-Graphen</translation>
    </message>
    <message>
        <source>A row for each f-circuit of the T–T graph: 1 for its own chord; a branch that counts with plus in the chord&apos;s velocity is −1, one that counts with minus is 1. Engaged couplings are chords, too. B ω = 0 holds for every motion.</source>
        <translation>Eine Zeile je Fundamentalkreis des T–T-Graphen: 1 für die eigene Sehne; ein Zweig, der in der Drehzahl der Sehne mit Plus zählt, ist −1, einer mit Minus ist 1. Eingelegte Kupplungen sind auch Sehnen. B ω = 0 gilt für jede Bewegung.</translation>
    </message>
    <message>
        <source>f-cutset matrix of the T–T graph</source>
        <translation>Fundamentalschnittmatrix des T–T-Graphen</translation>
    </message>
    <message>
        <source>A row for each branch of the T–T graph: 1 for its own torque, and the chords that cross the cut, with minus their entries in the f-circuits. Its rows are the equations of the T–T graph&apos;s statics, and B Q′ᵀ = 0.</source>
        <translation>Eine Zeile je Zweig des T–T-Graphen: 1 für das eigene Moment, dazu die Sehnen, die den Schnitt queren, mit dem Negativen ihrer Einträge in den Fundamentalkreisen. Ihre Zeilen sind die Gleichungen der Statik des T–T-Graphen, und B Q′ᵀ = 0.</translation>
    </message>
    <message>
        <source>T-T circuit matrix</source>
        <translation>T-T-Kreismatrix</translation>
    </message>
    <message>
        <source>T-T cutset matrix</source>
        <translation>T-T-Schnittmatrix</translation>
    </message>
    <message>
        <source>The %1 component of the unit vector u along the axis of %2. Eqs. (7)-(9)</source>
        <translation>Die %1-Komponente des Einheitsvektors u entlang der Achse von %2. Gln. (7)-(9)</translation>
    </message>
    <message>
        <source>The %1 component of the moment of %2&apos;s axis about the pitch point of %3: how fast that point moves for one unit of speed. Eqs. (10)-(12)</source>
        <translation>Die %1-Komponente des Moments der Achse von %2 um den Wälzpunkt von %3: wie schnell sich dieser Punkt bei der Drehgeschwindigkeit 1 bewegt. Gln. (10)-(12)</translation>
    </message>
    <message>
        <source>Joint %1 over joint %2: %3</source>
        <translation>Gelenk %1 über Gelenk %2: %3</translation>
    </message>
    <message>
        <source>Joint %1 does not feel input %2.</source>
        <translation>Gelenk %1 spürt Antrieb %2 nicht.</translation>
    </message>
    <message>
        <source>How fast joint %1 turns for one unit of speed at joint %2, the other inputs at rest.</source>
        <translation>Wie schnell sich Gelenk %1 bei der Drehgeschwindigkeit 1 in Gelenk %2 dreht, die anderen Antriebe in Ruhe.</translation>
    </message>
    <message>
        <source>With these teeth: %1.</source>
        <translation>Mit diesen Zähnezahlen: %1.</translation>
    </message>
    <message>
        <source>the chord of coupling %1</source>
        <translation>die Sehne der Kupplung %1</translation>
    </message>
    <message>
        <source>the chord %1 from gear %2 to carrier %3</source>
        <translation>die Sehne %1 vom Rad %2 zum Steg %3</translation>
    </message>
    <message>
        <source>f-circuit of %1, %2: %3</source>
        <translation>Fundamentalkreis von %1, %2: %3</translation>
    </message>
    <message>
        <source>Eqs. (31) to (38)</source>
        <translation>Gln. (31) bis (38)</translation>
    </message>
    <message>
        <source>The f-circuit that %1 closes: the chord itself counts as 1.</source>
        <translation>Der Fundamentalkreis, den %1 schließt: Die Sehne selbst zählt als 1.</translation>
    </message>
    <message>
        <source>An f-circuit holds one chord, its own: here %1.</source>
        <translation>Ein Fundamentalkreis enthält eine Sehne, die eigene: hier %1.</translation>
    </message>
    <message>
        <source>%1 is not between the ends of %2.</source>
        <translation>%1 liegt nicht zwischen den Enden dieser Sehne: %2.</translation>
    </message>
    <message>
        <source>The velocity of %1 is a sum of branches, in which %2 counts with plus. On one side with the chord it is −1.</source>
        <translation>Die Drehzahl (%1) ist eine Summe von Zweigen, in der %2 mit Plus zählt. Auf einer Seite mit der Sehne ist es −1.</translation>
    </message>
    <message>
        <source>The velocity of %1 is a sum of branches, in which %2 counts with minus. On one side with the chord it is 1.</source>
        <translation>Die Drehzahl (%1) ist eine Summe von Zweigen, in der %2 mit Minus zählt. Auf einer Seite mit der Sehne ist es 1.</translation>
    </message>
    <message>
        <source>f-cutset of joint %1, %2: %3</source>
        <translation>Fundamentalschnitt von Gelenk %1, %2: %3</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; the torque in the joint itself counts as 1.</source>
        <translation>Ohne %1 zerfällt der Baum in zwei Hälften; das Moment im Gelenk selbst zählt als 1.</translation>
    </message>
    <message>
        <source>An f-cutset holds one branch, its own: %1, not %2.</source>
        <translation>Ein Fundamentalschnitt enthält einen Zweig, den eigenen: %1, nicht %2.</translation>
    </message>
    <message>
        <source>Both ends of %1 are in the same half without %2: its torque is not in this equation.</source>
        <translation>Beide Enden (%1) sind ohne %2 in derselben Hälfte: Ihr Moment steht nicht in dieser Gleichung.</translation>
    </message>
    <message>
        <source>The torque of %1 acts across the cut, in the sense of %2: minus its entry in the f-circuit.</source>
        <translation>Das Moment (%1) wirkt über den Schnitt hinweg, im Sinn von %2: das Negative des Eintrags im Fundamentalkreis.</translation>
    </message>
    <message>
        <source>The torque of %1 acts across the cut, against the sense of %2: minus its entry in the f-circuit.</source>
        <translation>Das Moment (%1) wirkt über den Schnitt hinweg, gegen den Sinn von %2: das Negative des Eintrags im Fundamentalkreis.</translation>
    </message>
    <message>
        <source>The centre of mass in the reference pose, in the base frame.</source>
        <translation>Der Schwerpunkt in der Bezugslage, im Basissystem.</translation>
    </message>
    <message>
        <source>The moment of inertia about the centre of mass, about the direction of this axis of the base frame, in the reference pose.</source>
        <translation>Das Trägheitsmoment um den Schwerpunkt, um die Richtung dieser Achse des Basissystems, in der Bezugslage.</translation>
    </message>
    <message>
        <source>The link, by its number.</source>
        <translation>Das Glied, nach seiner Nummer.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>The mass: of the link&apos;s solids at the density, or as it is stated.</source>
        <translation>Die Masse: der Körper des Glieds bei der Dichte, oder wie sie angegeben ist.</translation>
    </message>
    <message>
        <source>Where the mass comes from: the link&apos;s solids, or the document, which states it.</source>
        <translation>Woher die Masse kommt: von den Körpern des Glieds oder aus dem Dokument, das sie angibt.</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>an %1</translation>
    </message>
    <message>
        <source>The inertia that the link has at the motor of joint %1 while the other inputs stand still: for a link that turns about one axis its moment of inertia times the square of its ratio.</source>
        <translation>Die Trägheit, die das Glied am Motor von Gelenk %1 hat, während die anderen Antriebe stillstehen: bei einem Glied, das sich um eine Achse dreht, sein Trägheitsmoment mal dem Quadrat seiner Übersetzung.</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>The joint of the input, by its number.</source>
        <translation>Das Gelenk des Antriebs, nach seiner Nummer.</translation>
    </message>
    <message>
        <source>The generalised inertia: the torque in the row&apos;s joint for each rad/s² of joint %1.</source>
        <translation>Die verallgemeinerte Trägheit: das Moment im Gelenk der Zeile für jedes rad/s² von Gelenk %1.</translation>
    </message>
    <message>
        <source>What motors have to give at constant speeds, for Coriolis and centrifugal forces and for weight.</source>
        <translation>Was Motoren bei konstanten Drehgeschwindigkeiten aufbringen müssen, für Coriolis- und Fliehkräfte und für das Gewicht.</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>What the loads contribute, as a torque in the row&apos;s joint.</source>
        <translation>Was die Lasten beitragen, als Moment im Gelenk der Zeile.</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>haltend</translation>
    </message>
    <message>
        <source>The torque of the motor that keeps the speeds constant: h less the load.</source>
        <translation>Das Moment des Motors, das die Drehgeschwindigkeiten konstant hält: h minus die Last.</translation>
    </message>
    <message>
        <source>no solid: massless</source>
        <translation>kein Körper: masselos</translation>
    </message>
    <message>
        <source>solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>stated, spread as its solids</source>
        <translation>angegeben, verteilt wie seine Körper</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 2^64 - 1, in quotes.</source>
        <translation>Der Startwert ist eine ganze Zahl von 0 bis 2^64 - 1, in Anführungszeichen.</translation>
    </message>
    <message>
        <source>The sheet was made by another version of the program, whose questions this one cannot make again.</source>
        <translation>Das Blatt wurde mit einer anderen Version des Programms erstellt, deren Fragen diese nicht wieder erzeugen kann.</translation>
    </message>
    <message>
        <source>A sheet has 1 to 1,000 variants.</source>
        <translation>Ein Blatt hat 1 bis 1.000 Varianten.</translation>
    </message>
    <message>
        <source>There is no kind of question &quot;%1&quot;.</source>
        <translation>Eine Frageart „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>A sheet has 1 to 100 questions.</source>
        <translation>Ein Blatt hat 1 bis 100 Fragen.</translation>
    </message>
    <message>
        <source>%1 = 0, shared in unknown parts</source>
        <translation>%1 = 0, zu unbekannten Teilen geteilt</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: no mesh crosses.</source>
        <translation>Gelenk %1 schneidet Glied %2 ab: Kein Eingriff kreuzt.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: mesh %3 crosses.</source>
        <translation>Gelenk %1 schneidet Glied %2 ab: Eingriff %3 kreuzt.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: meshes %3 cross.</source>
        <translation>Gelenk %1 schneidet Glied %2 ab: Eingriffe %3 kreuzen.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: no mesh crosses.</source>
        <translation>Gelenk %1 schneidet Glieder %2 ab: Kein Eingriff kreuzt.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: mesh %3 crosses.</source>
        <translation>Gelenk %1 schneidet Glieder %2 ab: Eingriff %3 kreuzt.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: meshes %3 cross.</source>
        <translation>Gelenk %1 schneidet Glieder %2 ab: Eingriffe %3 kreuzen.</translation>
    </message>
    <message>
        <source>T(link %1)</source>
        <translation>T(Glied %1)</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Which gear drives in mesh %1 depends on how the load is shared.</source>
        <translation>Welches Rad in Eingriff %1 treibt, hängt davon ab, wie die Last sich teilt.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from the ground, it bears no load.</source>
        <translation>In Eingriff %1 treibt kein Rad: Vom Gestell aus gesehen trägt er keine Last.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from carrier %2, it bears no load.</source>
        <translation>In Eingriff %1 treibt kein Rad: Vom Steg %2 aus gesehen trägt er keine Last.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from the ground, it does not roll.</source>
        <translation>In Eingriff %1 treibt kein Rad: Vom Gestell aus gesehen wälzt er nicht.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from carrier %2, it does not roll.</source>
        <translation>In Eingriff %1 treibt kein Rad: Vom Steg %2 aus gesehen wälzt er nicht.</translation>
    </message>
    <message>
        <source>Gear %1 drives gear %2 in mesh %3: seen from the ground, it turns against the teeth&apos;s torque on it and passes %4 W.</source>
        <translation>Rad %1 treibt Rad %2 in Eingriff %3: Vom Gestell aus gesehen dreht es sich gegen das Moment, das die Zähne auf es ausüben, und überträgt %4 W.</translation>
    </message>
    <message>
        <source>Gear %1 drives gear %2 in mesh %3: seen from carrier %5, it turns against the teeth&apos;s torque on it and passes %4 W.</source>
        <translation>Rad %1 treibt Rad %2 in Eingriff %3: Vom Steg %5 aus gesehen dreht es sich gegen das Moment, das die Zähne auf es ausüben, und überträgt %4 W.</translation>
    </message>
    <message>
        <source>efficiency of every mesh</source>
        <translation>Wirkungsgrad jedes Eingriffs</translation>
    </message>
    <message>
        <source>speed of joint %1 / joint %2</source>
        <translation>Drehgeschwindigkeit von Gelenk %1 / Gelenk %2</translation>
    </message>
    <message>
        <source>What the efficiency is followed over.</source>
        <translation>Worüber der Wirkungsgrad verfolgt wird.</translation>
    </message>
    <message>
        <source>efficiency backward</source>
        <translation>Wirkungsgrad rückwärts</translation>
    </message>
    <message>
        <source>The same with every known torque reversed: the output drives.</source>
        <translation>Dasselbe mit jedem bekannten Moment umgekehrt: Der Abtrieb treibt.</translation>
    </message>
    <message>
        <source>torque at %1</source>
        <translation>Moment: %1</translation>
    </message>
    <message>
        <source>What holds the loads there.</source>
        <translation>Was die Lasten dort hält.</translation>
    </message>
    <message>
        <source>load and balance</source>
        <translation>Last und Ausgleichsmoment</translation>
    </message>
    <message>
        <source>balance</source>
        <translation>Ausgleichsmoment</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>A turning joint, by its label, or a link on which a load or a balance acts from outside.</source>
        <translation>Ein Drehgelenk, nach seiner Bezeichnung, oder ein Glied, auf das eine Last oder ein Ausgleichsmoment von außen wirkt.</translation>
    </message>
    <message>
        <source>The link beyond the joint, seen from the ground.</source>
        <translation>Das Glied jenseits des Gelenks, vom Gestell aus gesehen.</translation>
    </message>
    <message>
        <source>carried by</source>
        <translation>getragen von</translation>
    </message>
    <message>
        <source>What puts a torque in: a load that is given, a balance that is found, or nothing: a free joint.</source>
        <translation>Was ein Moment einleitet: eine gegebene Last, ein gefundenes Ausgleichsmoment, oder nichts: ein freies Gelenk.</translation>
    </message>
    <message>
        <source>lossless</source>
        <translation>verlustfrei</translation>
    </message>
    <message>
        <source>The torque that the joint&apos;s tail exerts on its head about the axis, of a train without losses.</source>
        <translation>Das Moment, das der Fuß des Gelenks auf dessen Spitze um die Achse ausübt, in einem verlustfreien Getriebe.</translation>
    </message>
    <message>
        <source>exact torque</source>
        <translation>Moment exakt</translation>
    </message>
    <message>
        <source>The same with the losses of the meshes, where they are given.</source>
        <translation>Dasselbe mit den Verlusten der Eingriffe, wo sie angegeben sind.</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>The same as a decimal.</source>
        <translation>Dasselbe als Dezimalzahl.</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Drehgeschwindigkeit</translation>
    </message>
    <message>
        <source>How fast the head turns against the tail.</source>
        <translation>Wie schnell sich die Spitze gegen den Fuß dreht.</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Torque times rate: what load or balance feed into the train here; below 0: what they take.</source>
        <translation>Moment mal Drehgeschwindigkeit: was Last oder Ausgleichsmoment hier dem Getriebe zuführen; unter 0: was sie entnehmen.</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>coupling</source>
        <translation>Schaltelement</translation>
    </message>
    <message>
        <source>A brake or clutch that is engaged.</source>
        <translation>Eine geschlossene Bremse oder Kupplung.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>The link that a brake holds; the two links that a clutch joins, the torque acts on the first one.</source>
        <translation>Das Glied, das eine Bremse hält; die beiden Glieder, die eine Kupplung verbindet, das Moment wirkt auf das erste.</translation>
    </message>
    <message>
        <source>about</source>
        <translation>um</translation>
    </message>
    <message>
        <source>The axis that the torque is about, the first one on the way to the ground.</source>
        <translation>Die Achse, um die das Moment wirkt, die erste auf dem Weg zum Gestell.</translation>
    </message>
    <message>
        <source>The torque on that link, with the losses where they are given.</source>
        <translation>Das Moment auf dieses Glied, mit den Verlusten, wo sie angegeben sind.</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>übertragen</translation>
    </message>
    <message>
        <source>The power that a clutch delivers to the first link; a brake passes none.</source>
        <translation>Die Leistung, die eine Kupplung an das erste Glied abgibt; eine Bremse überträgt keine.</translation>
    </message>
    <message>
        <source>The gear mesh, by its label.</source>
        <translation>Der Zahneingriff, nach seiner Bezeichnung.</translation>
    </message>
    <message>
        <source>The link of the tail&apos;s gear.</source>
        <translation>Das Glied des Rads am Fuß.</translation>
    </message>
    <message>
        <source>The link of the head&apos;s gear.</source>
        <translation>Das Glied des Rads an der Spitze.</translation>
    </message>
    <message>
        <source>carrier</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>The link that holds both gears&apos; axes, from which the mesh is seen.</source>
        <translation>Das Glied, das die Achsen beider Räder hält und von dem aus der Eingriff gesehen wird.</translation>
    </message>
    <message>
        <source>on tail</source>
        <translation>auf Fuß</translation>
    </message>
    <message>
        <source>The torque of the mesh on the tail&apos;s gear about its own axis, seen from the carrier.</source>
        <translation>Das Moment des Eingriffs auf das Rad am Fuß um dessen eigene Achse, vom Steg aus gesehen.</translation>
    </message>
    <message>
        <source>on head</source>
        <translation>auf Spitze</translation>
    </message>
    <message>
        <source>The torque of the mesh on the head&apos;s gear about its own axis, seen from the carrier.</source>
        <translation>Das Moment des Eingriffs auf das Rad an der Spitze um dessen eigene Achse, vom Steg aus gesehen.</translation>
    </message>
    <message>
        <source>tangential</source>
        <translation>Umfangskraft</translation>
    </message>
    <message>
        <source>The force along the pitch circles&apos; tangent, of the tail&apos;s gear on the head&apos;s.</source>
        <translation>Die Kraft entlang der Tangente der Teilkreise, vom Rad am Fuß auf das an der Spitze.</translation>
    </message>
    <message>
        <source>separating</source>
        <translation>Radialkraft</translation>
    </message>
    <message>
        <source>The force that presses the gears apart: the tangential one times the tangent of the operating pressure angle.</source>
        <translation>Die Kraft, die die Räder auseinanderdrückt: die Umfangskraft mal dem Tangens des Betriebseingriffswinkels.</translation>
    </message>
    <message>
        <source>The whole tooth force on the head&apos;s gear, in the base frame.</source>
        <translation>Die ganze Zahnkraft auf das Rad an der Spitze, im Basissystem.</translation>
    </message>
    <message>
        <source>Power delivered over power taken, seen from the carrier.</source>
        <translation>Abgegebene durch aufgenommene Leistung, vom Steg aus gesehen.</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>treibt</translation>
    </message>
    <message>
        <source>The gear that delivers the power to the teeth, seen from the carrier.</source>
        <translation>Das Rad, das den Zähnen die Leistung zuführt, vom Steg aus gesehen.</translation>
    </message>
    <message>
        <source>rolling power</source>
        <translation>Wälzleistung</translation>
    </message>
    <message>
        <source>What the teeth pass from tail to head, seen from the carrier: the latent power.</source>
        <translation>Was die Zähne vom Fuß zur Spitze übertragen, vom Steg aus gesehen: die Wälzleistung.</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>One minus the efficiency, times the rolling power.</source>
        <translation>Eins minus der Wirkungsgrad, mal die Wälzleistung.</translation>
    </message>
    <message>
        <source>to tail</source>
        <translation>an Fuß</translation>
    </message>
    <message>
        <source>What the mesh delivers to the tail&apos;s gear, seen from the ground.</source>
        <translation>Was der Eingriff an das Rad am Fuß abgibt, vom Gestell aus gesehen.</translation>
    </message>
    <message>
        <source>to head</source>
        <translation>an Spitze</translation>
    </message>
    <message>
        <source>What the mesh delivers to the head&apos;s gear, seen from the ground.</source>
        <translation>Was der Eingriff an das Rad an der Spitze abgibt, vom Gestell aus gesehen.</translation>
    </message>
    <message>
        <source>to carrier</source>
        <translation>an Steg</translation>
    </message>
    <message>
        <source>What the mesh delivers to the carrier, seen from the ground.</source>
        <translation>Was der Eingriff an den Steg abgibt, vom Gestell aus gesehen.</translation>
    </message>
    <message>
        <source>The turning joint, whose bearing holds its head on its tail.</source>
        <translation>Das Drehgelenk, dessen Lager seine Spitze auf seinem Fuß hält.</translation>
    </message>
    <message>
        <source>The size of the force of the tail on the head.</source>
        <translation>Der Betrag der Kraft des Fußes auf die Spitze.</translation>
    </message>
    <message>
        <source>The force of the tail on the head, in the base frame.</source>
        <translation>Die Kraft des Fußes auf die Spitze, im Basissystem.</translation>
    </message>
    <message>
        <source>The moment of the tail on the head about the point, with the joint&apos;s own torque.</source>
        <translation>Das Moment des Fußes auf die Spitze um den Punkt, mit dem eigenen Moment des Gelenks.</translation>
    </message>
    <message>
        <source>Where the joint is drawn: the point that the moment is about, in the document&apos;s unit.</source>
        <translation>Wo das Gelenk gezeichnet ist: der Punkt, um den das Moment zählt, in der Einheit des Dokuments.</translation>
    </message>
    <message>
        <source>Where the joint is drawn, in the document&apos;s unit.</source>
        <translation>Wo das Gelenk gezeichnet ist, in der Einheit des Dokuments.</translation>
    </message>
    <message>
        <source>A mesh, a joint, an engaged coupling, a load or a balance.</source>
        <translation>Ein Eingriff, ein Gelenk, ein geschlossenes Schaltelement, eine Last oder ein Ausgleichsmoment.</translation>
    </message>
    <message>
        <source>The link that it acts on.</source>
        <translation>Das Glied, auf das es wirkt.</translation>
    </message>
    <message>
        <source>exact power</source>
        <translation>Leistung exakt</translation>
    </message>
    <message>
        <source>What the element delivers to the link, seen from the ground; below 0: what it takes from it. The sum at every link is 0.</source>
        <translation>Was das Element an das Glied abgibt, vom Gestell aus gesehen; unter 0: was es ihm entnimmt. Die Summe an jedem Glied ist 0.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Of the power fed into the train.</source>
        <translation>An der Leistung, die dem Getriebe zugeführt wird.</translation>
    </message>
    <message>
        <source>load on link %1</source>
        <translation>Last auf Glied %1</translation>
    </message>
    <message>
        <source>balance on link %1</source>
        <translation>Ausgleichsmoment auf Glied %1</translation>
    </message>
    <message>
        <source>The least power on the loop: what goes round beside what goes through.</source>
        <translation>Die kleinste Leistung in der Schleife: was neben dem Durchfließenden umläuft.</translation>
    </message>
    <message>
        <source>The shafts of the loop.</source>
        <translation>Die Wellen der Schleife.</translation>
    </message>
    <message>
        <source>meshes</source>
        <translation>Eingriffe</translation>
    </message>
    <message>
        <source>The meshes of the gear sets of the loop.</source>
        <translation>Die Eingriffe der Radsätze der Schleife.</translation>
    </message>
    <message>
        <source>Bearings</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Circulating power</source>
        <translation>Blindleistung</translation>
    </message>
    <message>
        <source>The state of the gearbox, by its name.</source>
        <translation>Der Schaltzustand, nach seinem Namen.</translation>
    </message>
    <message>
        <source>The torque that the brake exerts on its link while it is engaged.</source>
        <translation>Das Moment, das die Bremse auf ihr Glied ausübt, während sie geschlossen ist.</translation>
    </message>
    <message>
        <source>The torque that the clutch exerts on the first of its links while it is engaged; the second one has the reaction.</source>
        <translation>Das Moment, das die Kupplung auf das erste ihrer Glieder ausübt, während sie geschlossen ist; das zweite hat die Reaktion.</translation>
    </message>
    <message>
        <source>exact ratio</source>
        <translation>Übersetzung exakt</translation>
    </message>
    <message>
        <source>The speed of the drive over that of the driven link.</source>
        <translation>Die Drehgeschwindigkeit des Antriebs durch die des Abtriebs.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving.</source>
        <translation>Entnommene durch zugeführte Leistung, wenn der Antrieb treibt.</translation>
    </message>
    <message>
        <source>The same with all known torques reversed: the output drives.</source>
        <translation>Dasselbe mit allen bekannten Momenten umgekehrt: Der Abtrieb treibt.</translation>
    </message>
    <message>
        <source>latent</source>
        <translation>Wälzleistung</translation>
    </message>
    <message>
        <source>The power that all meshes pass, seen from their carriers, over the power fed.</source>
        <translation>Die Leistung aller Eingriffe, von ihren Stegen aus gesehen, durch die zugeführte.</translation>
    </message>
    <message>
        <source>circulating</source>
        <translation>Blindleistung</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop, for each watt that is fed.</source>
        <translation>Die größte Leistung, die in einer Schleife umläuft, für jedes zugeführte Watt.</translation>
    </message>
    <message>
        <source>locks</source>
        <translation>sperrt</translation>
    </message>
    <message>
        <source>An object is needed here.</source>
        <translation>Hier wird ein Objekt gebraucht.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is missing.</source>
        <translation>Das Mitglied „%1“ fehlt.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is of the wrong type.</source>
        <translation>Das Mitglied „%1“ hat den falschen Typ.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>Hier wird eine ganze Zahl gebraucht.</translation>
    </message>
    <message>
        <source>An array is needed here.</source>
        <translation>Hier wird eine Liste gebraucht.</translation>
    </message>
    <message>
        <source>A text is needed here.</source>
        <translation>Hier wird ein Text gebraucht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no list of the document with an id.</source>
        <translation>„%1“ ist keine Liste des Dokuments mit Kennungen.</translation>
    </message>
    <message>
        <source>This is no file of the format &quot;%1&quot;.</source>
        <translation>Das ist keine Datei des Formats „%1“.</translation>
    </message>
    <message>
        <source>Version %1 is not known to this program.</source>
        <translation>Version %1 kennt dieses Programm nicht.</translation>
    </message>
    <message>
        <source>field left empty</source>
        <translation>Feld leer gelassen</translation>
    </message>
    <message>
        <source>text that is no number</source>
        <translation>Text, der keine Zahl ist</translation>
    </message>
    <message>
        <source>comma that may be a decimal or a thousand</source>
        <translation>Komma, das Dezimal- oder Tausendertrennzeichen sein kann</translation>
    </message>
    <message>
        <source>text that the question does not offer</source>
        <translation>Text, den die Frage nicht anbietet</translation>
    </message>
    <message>
        <source>incidence with + and − exchanged</source>
        <translation>Inzidenz mit vertauschtem + und −</translation>
    </message>
    <message>
        <source>tail and head of an arrow exchanged</source>
        <translation>Fuß und Spitze eines Pfeils vertauscht</translation>
    </message>
    <message>
        <source>signs left out</source>
        <translation>Vorzeichen weggelassen</translation>
    </message>
    <message>
        <source>an end of an arrow left out</source>
        <translation>ein Ende eines Pfeils weggelassen</translation>
    </message>
    <message>
        <source>a link that is no end of the arrow</source>
        <translation>ein Glied, das kein Ende des Pfeils ist</translation>
    </message>
    <message>
        <source>ground row left in</source>
        <translation>Zeile des Gestells stehen gelassen</translation>
    </message>
    <message>
        <source>ground row left out</source>
        <translation>Zeile des Gestells weggelassen</translation>
    </message>
    <message>
        <source>rows and columns exchanged</source>
        <translation>Zeilen und Spalten vertauscht</translation>
    </message>
    <message>
        <source>entry that is not −1, 0 or 1</source>
        <translation>Eintrag, der nicht −1, 0 oder 1 ist</translation>
    </message>
    <message>
        <source>arrow walked against its direction</source>
        <translation>Pfeil gegen seine Richtung durchlaufen</translation>
    </message>
    <message>
        <source>joint of the walk left out</source>
        <translation>Gelenk des Wegs weggelassen</translation>
    </message>
    <message>
        <source>joint that is not on the walk</source>
        <translation>Gelenk, das nicht auf dem Weg liegt</translation>
    </message>
    <message>
        <source>another cycle&apos;s row</source>
        <translation>Zeile eines anderen Zyklus</translation>
    </message>
    <message>
        <source>cycle walked against its mesh</source>
        <translation>Zyklus gegen seinen Zahneingriff durchlaufen</translation>
    </message>
    <message>
        <source>the cycle&apos;s own mesh left out</source>
        <translation>den eigenen Zahneingriff des Zyklus weggelassen</translation>
    </message>
    <message>
        <source>another mesh in the cycle</source>
        <translation>anderer Zahneingriff im Zyklus</translation>
    </message>
    <message>
        <source>walked from the ground instead of to it</source>
        <translation>vom Gestell weg statt zu ihm gelaufen</translation>
    </message>
    <message>
        <source>another link&apos;s walk</source>
        <translation>Weg eines anderen Glieds</translation>
    </message>
    <message>
        <source>another joint&apos;s cutset</source>
        <translation>Schnittmenge eines anderen Gelenks</translation>
    </message>
    <message>
        <source>signs of the cycle instead of the cutset</source>
        <translation>Vorzeichen des Zyklus statt der Schnittmenge</translation>
    </message>
    <message>
        <source>mesh that the cutset does not cut</source>
        <translation>Zahneingriff, den die Schnittmenge nicht schneidet</translation>
    </message>
    <message>
        <source>mesh that the cutset cuts left out</source>
        <translation>Zahneingriff, den die Schnittmenge schneidet, weggelassen</translation>
    </message>
    <message>
        <source>edge that crosses the cut the other way</source>
        <translation>Kante, die den Schnitt in der anderen Richtung kreuzt</translation>
    </message>
    <message>
        <source>another turning joint in the cutset</source>
        <translation>anderes Drehgelenk in der Schnittmenge</translation>
    </message>
    <message>
        <source>mesh listed among the turning joints</source>
        <translation>Zahneingriff unter den Drehgelenken aufgeführt</translation>
    </message>
    <message>
        <source>both paths followed to the ground</source>
        <translation>beide Wege bis zum Gestell verfolgt</translation>
    </message>
    <message>
        <source>path of one gear only</source>
        <translation>nur der Weg eines Rads</translation>
    </message>
    <message>
        <source>too few edges for a spanning tree</source>
        <translation>zu wenige Kanten für einen Spannbaum</translation>
    </message>
    <message>
        <source>too many edges for a spanning tree</source>
        <translation>zu viele Kanten für einen Spannbaum</translation>
    </message>
    <message>
        <source>edges that close a loop</source>
        <translation>Kanten, die eine Schleife schließen</translation>
    </message>
    <message>
        <source>the required edge is not in the tree</source>
        <translation>die verlangte Kante ist nicht im Baum</translation>
    </message>
    <message>
        <source>senses that do not follow one walk</source>
        <translation>Richtungen, die keinem einheitlichen Umlauf folgen</translation>
    </message>
    <message>
        <source>ratio upside down</source>
        <translation>Übersetzung verkehrt herum</translation>
    </message>
    <message>
        <source>internal mesh with an external sign</source>
        <translation>innenverzahnter Eingriff mit dem Vorzeichen eines außenverzahnten</translation>
    </message>
    <message>
        <source>external mesh with an internal sign</source>
        <translation>außenverzahnter Eingriff mit dem Vorzeichen eines innenverzahnten</translation>
    </message>
    <message>
        <source>sign of a bevel mesh</source>
        <translation>Vorzeichen eines Kegeleingriffs</translation>
    </message>
    <message>
        <source>sign wrong and ratio upside down</source>
        <translation>Vorzeichen falsch und Übersetzung verkehrt herum</translation>
    </message>
    <message>
        <source>row of C in place of P</source>
        <translation>Zeile von C statt von P</translation>
    </message>
    <message>
        <source>coefficients without the signs of the cycle</source>
        <translation>Koeffizienten ohne die Vorzeichen des Zyklus</translation>
    </message>
    <message>
        <source>teeth of another wheel on the same link</source>
        <translation>Zähne eines anderen Rads desselben Glieds</translation>
    </message>
    <message>
        <source>chord followed from the carrier to the gear</source>
        <translation>Sehne vom Steg zum Rad verfolgt</translation>
    </message>
    <message>
        <source>circuit of the other chord</source>
        <translation>Kreis der anderen Sehne</translation>
    </message>
    <message>
        <source>circuit followed to the ground instead of the carrier</source>
        <translation>Kreis bis zum Gestell statt bis zum Steg verfolgt</translation>
    </message>
    <message>
        <source>circuit of the whole walk between the gears</source>
        <translation>Kreis über den ganzen Weg zwischen den Rädern</translation>
    </message>
    <message>
        <source>levels of the two gears exchanged</source>
        <translation>Ebenen der beiden Räder vertauscht</translation>
    </message>
    <message>
        <source>transfer vertex where the level does not change</source>
        <translation>Transferknoten, wo die Ebene nicht wechselt</translation>
    </message>
    <message>
        <source>gear taken for the carrier</source>
        <translation>Rad für den Steg gehalten</translation>
    </message>
    <message>
        <source>ground taken for the carrier</source>
        <translation>Gestell für den Steg gehalten</translation>
    </message>
    <message>
        <source>carrier that is not on the path</source>
        <translation>Steg, der nicht auf dem Weg liegt</translation>
    </message>
    <message>
        <source>level that is not on the path</source>
        <translation>Ebene, die nicht auf dem Weg liegt</translation>
    </message>
    <message>
        <source>velocity relation used for torques</source>
        <translation>Beziehung der Drehzahlen für Momente verwendet</translation>
    </message>
    <message>
        <source>port torque with the wrong sign</source>
        <translation>Moment an einem Anschluss mit falschem Vorzeichen</translation>
    </message>
    <message>
        <source>Kutzbach&apos;s count where a mesh is redundant</source>
        <translation>Kutzbachs Abzählung, obwohl ein Zahneingriff redundant ist</translation>
    </message>
    <message>
        <source>ground counted as a moving link</source>
        <translation>Gestell als bewegtes Glied gezählt</translation>
    </message>
    <message>
        <source>rank and degrees of freedom exchanged</source>
        <translation>Rang und Freiheitsgrad vertauscht</translation>
    </message>
    <message>
        <source>two freedoms taken by a mesh</source>
        <translation>zwei Freiheiten durch einen Zahneingriff genommen</translation>
    </message>
    <message>
        <source>meshes ignored</source>
        <translation>Zahneingriffe nicht berücksichtigt</translation>
    </message>
    <message>
        <source>degrees of freedom that are not t − r</source>
        <translation>Freiheitsgrad, der nicht t − r ist</translation>
    </message>
    <message>
        <source>too few inputs</source>
        <translation>zu wenige Antriebe</translation>
    </message>
    <message>
        <source>inputs that depend on each other</source>
        <translation>Antriebe, die voneinander abhängen</translation>
    </message>
    <message>
        <source>a joint that can never turn as input</source>
        <translation>ein Gelenk als Antrieb, das sich nie drehen kann</translation>
    </message>
    <message>
        <source>a joint that no mesh drives is not an input</source>
        <translation>ein Gelenk, das kein Zahneingriff treibt, ist kein Antrieb</translation>
    </message>
    <message>
        <source>mesh on which no other depends</source>
        <translation>Zahneingriff, von dem kein anderer abhängt</translation>
    </message>
    <message>
        <source>no mesh taken for redundant</source>
        <translation>kein Zahneingriff für redundant gehalten</translation>
    </message>
    <message>
        <source>number of redundant meshes</source>
        <translation>Anzahl redundanter Zahneingriffe</translation>
    </message>
    <message>
        <source>sign of the speed lost</source>
        <translation>Vorzeichen der Drehzahl verloren</translation>
    </message>
    <message>
        <source>an input ignored</source>
        <translation>einen Antrieb nicht berücksichtigt</translation>
    </message>
    <message>
        <source>sign of one mesh in the chain</source>
        <translation>Vorzeichen eines Zahneingriffs der Kette</translation>
    </message>
    <message>
        <source>absolute speed in place of the joint&apos;s rate</source>
        <translation>absolute Drehzahl statt der des Gelenks</translation>
    </message>
    <message>
        <source>motion of the carrier ignored</source>
        <translation>Bewegung des Stegs nicht berücksichtigt</translation>
    </message>
    <message>
        <source>whole ratio upside down</source>
        <translation>gesamte Übersetzung verkehrt herum</translation>
    </message>
    <message>
        <source>number of teeth out of the range</source>
        <translation>Zähnezahl außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>teeth that do not make the ratio</source>
        <translation>Zähne, die die Übersetzung nicht ergeben</translation>
    </message>
    <message>
        <source>teeth of the ring added</source>
        <translation>Zähne des Hohlrads addiert</translation>
    </message>
    <message>
        <source>planet counted once in the ring</source>
        <translation>Planet im Hohlrad nur einmal gezählt</translation>
    </message>
    <message>
        <source>couplings of another gear</source>
        <translation>Schaltelemente eines anderen Gangs</translation>
    </message>
    <message>
        <source>couplings that lock the drive</source>
        <translation>Schaltelemente, die das Getriebe sperren</translation>
    </message>
    <message>
        <source>too few couplings to leave one freedom</source>
        <translation>zu wenige Schaltelemente, um einen Freiheitsgrad zu lassen</translation>
    </message>
    <message>
        <source>couplings that make another ratio</source>
        <translation>Schaltelemente, die eine andere Übersetzung ergeben</translation>
    </message>
    <message>
        <source>brake or clutch that is released</source>
        <translation>Bremse oder Kupplung, die gelöst ist</translation>
    </message>
    <message>
        <source>a smaller torque taken for the largest</source>
        <translation>ein kleineres Moment für das größte gehalten</translation>
    </message>
    <message>
        <source>the fastest clutch instead of that of the largest torque</source>
        <translation>die schnellste Kupplung statt der mit dem größten Moment</translation>
    </message>
    <message>
        <source>the largest ratio instead of the largest torque</source>
        <translation>die größte Übersetzung statt des größten Moments</translation>
    </message>
    <message>
        <source>torques added without their signs</source>
        <translation>Momente ohne ihre Vorzeichen addiert</translation>
    </message>
    <message>
        <source>torque of another brake, clutch or state</source>
        <translation>Moment einer anderen Bremse, Kupplung oder eines anderen Schaltzustands</translation>
    </message>
    <message>
        <source>torque of the load in place of that of the brake</source>
        <translation>Moment der Last statt dessen der Bremse</translation>
    </message>
    <message>
        <source>torque of the drive in place of that of the brake</source>
        <translation>Moment des Antriebs statt dessen der Bremse</translation>
    </message>
    <message>
        <source>torque on the housing in place of that on the link</source>
        <translation>Moment auf das Gehäuse statt auf das Glied</translation>
    </message>
    <message>
        <source>brake that turns link and housing in the same sense</source>
        <translation>Bremse, die Glied und Gehäuse im selben Sinn dreht</translation>
    </message>
    <message>
        <source>efficiency forward in place of backward</source>
        <translation>Wirkungsgrad vorwärts statt rückwärts</translation>
    </message>
    <message>
        <source>losses left out</source>
        <translation>Verluste weggelassen</translation>
    </message>
    <message>
        <source>losses of a planetary train as of fixed axes</source>
        <translation>Verluste eines Planetengetriebes wie bei festen Achsen</translation>
    </message>
    <message>
        <source>efficiency upside down</source>
        <translation>Wirkungsgrad verkehrt herum</translation>
    </message>
    <message>
        <source>self-locking train taken for one that turns</source>
        <translation>selbsthemmendes Getriebe für ein drehendes gehalten</translation>
    </message>
    <message>
        <source>train that turns taken for a self-locking one</source>
        <translation>drehendes Getriebe für ein selbsthemmendes gehalten</translation>
    </message>
    <message>
        <source>efficiency of a train that locks itself</source>
        <translation>Wirkungsgrad eines selbsthemmenden Getriebes</translation>
    </message>
    <message>
        <source>right row, wrong column</source>
        <translation>richtige Zeile, falsche Spalte</translation>
    </message>
    <message>
        <source>right column, wrong row</source>
        <translation>richtige Spalte, falsche Zeile</translation>
    </message>
    <message>
        <source>an entry that is right</source>
        <translation>ein Eintrag, der richtig ist</translation>
    </message>
    <message>
        <source>right place, wrong correction</source>
        <translation>richtige Stelle, falsche Korrektur</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here.</source>
        <translation>„%1“ ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>This part does not fit the fields of its question.</source>
        <translation>Dieser Teil passt nicht zu den Feldern seiner Frage.</translation>
    </message>
    <message>
        <source>Answers are kept by the number of their question.</source>
        <translation>Antworten werden unter der Nummer ihrer Frage geführt.</translation>
    </message>
    <message>
        <source>An answer is a text or a number.</source>
        <translation>Eine Antwort ist ein Text oder eine Zahl.</translation>
    </message>
    <message>
        <source>There is no example &quot;%1&quot;.</source>
        <translation>Ein Beispiel „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>The glossary has no term &quot;%1&quot;.</source>
        <translation>Das Glossar hat keinen Begriff „%1“.</translation>
    </message>
    <message>
        <source>The solution is not accepted.</source>
        <translation>Die Lösung wird nicht angenommen.</translation>
    </message>
    <message>
        <source>An answer has a text for each field.</source>
        <translation>Eine Antwort hat für jedes Feld einen Text.</translation>
    </message>
    <message>
        <source>This answer is accepted as right.</source>
        <translation>Diese Antwort wird als richtig angenommen.</translation>
    </message>
    <message>
        <source>This answer gets another reason: &quot;%1&quot;</source>
        <translation>Diese Antwort bekommt eine andere Begründung: „%1“</translation>
    </message>
    <message>
        <source>The document of the step fulfils them already: nothing is left to draw.</source>
        <translation>Das Dokument des Schritts erfüllt sie schon: Es bleibt nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>The solution is not accepted: %1</source>
        <translation>Die Lösung wird nicht angenommen: %1</translation>
    </message>
    <message>
        <source>This drawing is accepted as right.</source>
        <translation>Diese Zeichnung wird als richtig angenommen.</translation>
    </message>
    <message>
        <source>The first condition that fails is %1.</source>
        <translation>Die erste Bedingung, die nicht erfüllt ist, ist %1.</translation>
    </message>
    <message>
        <source>An id consists of small letters, digits and hyphens, such as &quot;cycle-basis&quot;.</source>
        <translation>Eine Kennung besteht aus Kleinbuchstaben, Ziffern und Bindestrichen, etwa „cycle-basis“.</translation>
    </message>
    <message>
        <source>A lesson takes 1 to 60 minutes.</source>
        <translation>Eine Lektion dauert 1 bis 60 Minuten.</translation>
    </message>
    <message>
        <source>A lesson has 1 to %1 steps.</source>
        <translation>Eine Lektion hat 1 bis %1 Schritte.</translation>
    </message>
    <message>
        <source>Either an example is named or a document is given, not both.</source>
        <translation>Entweder wird ein Beispiel genannt oder ein Dokument angegeben, nicht beides.</translation>
    </message>
    <message>
        <source>A step explains in at most %1 words; these are %2.</source>
        <translation>Ein Schritt erklärt mit höchstens %1 Wörtern; das sind %2.</translation>
    </message>
    <message>
        <source>The paper numbers its equations from 1 to %1.</source>
        <translation>Die Gleichungen des Artikels haben die Nummern 1 bis %1.</translation>
    </message>
    <message>
        <source>Neither the step nor its lesson names an example or gives a document.</source>
        <translation>Weder der Schritt noch seine Lektion nennt ein Beispiel oder gibt ein Dokument an.</translation>
    </message>
    <message>
        <source>A step gives at least one hint.</source>
        <translation>Ein Schritt gibt mindestens einen Hinweis.</translation>
    </message>
    <message>
        <source>This part does not fit the fields of its task.</source>
        <translation>Dieser Teil passt nicht zu den Feldern seiner Aufgabe.</translation>
    </message>
    <message>
        <source>What the analysis gives here is no answer to this field.</source>
        <translation>Was die Analyse hier liefert, ist keine Antwort auf dieses Feld.</translation>
    </message>
    <message>
        <source>An answer has a text for each field: %1, not %2.</source>
        <translation>Eine Antwort hat für jedes Feld einen Text: %1, nicht %2.</translation>
    </message>
    <message>
        <source>There is no such field.</source>
        <translation>Ein solches Feld gibt es nicht.</translation>
    </message>
    <message>
        <source>The field &quot;%1&quot; cannot hold &quot;%2&quot;.</source>
        <translation>Das Feld „%1“ kann „%2“ nicht enthalten.</translation>
    </message>
    <message>
        <source>The document gives no exercise of this kind: %1.</source>
        <translation>Das Dokument ergibt keine Übung dieser Art: %1.</translation>
    </message>
    <message>
        <source>No exercise of this kind is about this element.</source>
        <translation>Keine Übung dieser Art handelt von diesem Element.</translation>
    </message>
    <message>
        <source>A mechanism is missing here.</source>
        <translation>Hier fehlt ein Mechanismus.</translation>
    </message>
    <message>
        <source>The document has no such element.</source>
        <translation>Das Dokument hat kein solches Element.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Your task</source>
        <translation>Ihre Aufgabe</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Pick in the drawing</source>
        <translation>In der Zeichnung anklicken</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Vorhersagen</translation>
    </message>
    <message>
        <source>Find the mistake</source>
        <translation>Fehler finden</translation>
    </message>
    <message>
        <source>The degrees of freedom are not defined yet: the document has errors.</source>
        <translation>Der Freiheitsgrad ist noch nicht bestimmt: Das Dokument hat Fehler.</translation>
    </message>
    <message>
        <source>This quantity is not known.</source>
        <translation>Diese Größe ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The document has no turning joint &quot;%1&quot;.</source>
        <translation>Das Dokument hat kein Drehgelenk „%1“.</translation>
    </message>
    <message>
        <source>The speeds are not determined yet: see Problems.</source>
        <translation>Die Drehzahlen sind noch nicht bestimmt: siehe Probleme.</translation>
    </message>
    <message>
        <source>The solution was cancelled.</source>
        <translation>Die Lösung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The document has no state &quot;%1&quot;.</source>
        <translation>Das Dokument hat keinen Schaltzustand „%1“.</translation>
    </message>
    <message>
        <source>The document has errors: no state has a ratio.</source>
        <translation>Das Dokument hat Fehler: Kein Schaltzustand hat eine Übersetzung.</translation>
    </message>
    <message>
        <source>State &quot;%1&quot; has no ratio.</source>
        <translation>Schaltzustand „%1“ hat keine Übersetzung.</translation>
    </message>
    <message>
        <source>The document has errors: torques are not determined.</source>
        <translation>Das Dokument hat Fehler: Die Momente sind nicht bestimmt.</translation>
    </message>
    <message>
        <source>The loads are not held: torques are not determined.</source>
        <translation>Die Lasten werden nicht gehalten: Die Momente sind nicht bestimmt.</translation>
    </message>
    <message>
        <source>The torque of &quot;%1&quot; is not determined as a fraction.</source>
        <translation>Das Moment von „%1“ ist nicht als Bruch bestimmt.</translation>
    </message>
    <message>
        <source>The document has no balance or engaged coupling &quot;%1&quot;.</source>
        <translation>Das Dokument hat kein Ausgleichsmoment oder geschlossenes Schaltelement „%1“.</translation>
    </message>
    <message>
        <source>The document has no gear mesh &quot;%1&quot;.</source>
        <translation>Das Dokument hat keinen Zahneingriff „%1“.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree: meshes close no cycles.</source>
        <translation>Die Drehgelenke bilden keinen Spannbaum: Zahneingriffe schließen keine Zyklen.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; has no transfer vertex.</source>
        <translation>Zahneingriff „%1“ hat keinen Transferknoten.</translation>
    </message>
    <message>
        <source>A number or a fraction such as &quot;-2/3&quot; is needed here.</source>
        <translation>Hier wird eine Zahl oder ein Bruch wie „-2/3“ gebraucht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no quantity that the analysis gives.</source>
        <translation>„%1“ ist keine Größe, die die Analyse liefert.</translation>
    </message>
    <message>
        <source>The quantity &quot;%1&quot; is of the whole document.</source>
        <translation>Die Größe „%1“ gehört zum ganzen Dokument.</translation>
    </message>
    <message>
        <source>What can be picked is links, turningJoints or gearMeshes.</source>
        <translation>Angeklickt werden kann: links, turningJoints oder gearMeshes.</translation>
    </message>
    <message>
        <source>What can be picked is named here.</source>
        <translation>Hier wird genannt, was angeklickt werden kann.</translation>
    </message>
    <message>
        <source>A field is an integer, a number, a choice or a set.</source>
        <translation>Ein Feld ist eine ganze Zahl, eine Zahl, eine Auswahl oder eine Menge.</translation>
    </message>
    <message>
        <source>A choice or a set has options, a number has none.</source>
        <translation>Eine Auswahl oder Menge hat Optionen, eine Zahl hat keine.</translation>
    </message>
    <message>
        <source>A mistake is told by answers or by conditions, not by both.</source>
        <translation>Ein Fehler wird durch Antworten oder durch Bedingungen beschrieben, nicht durch beides.</translation>
    </message>
    <message>
        <source>A reason is a sentence.</source>
        <translation>Eine Begründung ist ein Satz.</translation>
    </message>
    <message>
        <source>A mistake has at least one condition.</source>
        <translation>Ein Fehler hat mindestens eine Bedingung.</translation>
    </message>
    <message>
        <source>A mistake that conditions tell needs an example of an answer.</source>
        <translation>Ein Fehler, den Bedingungen beschreiben, braucht ein Beispiel einer Antwort.</translation>
    </message>
    <message>
        <source>A prediction names the quantity of the analysis that it is compared with.</source>
        <translation>Eine Vorhersage nennt die Größe der Analyse, mit der sie verglichen wird.</translation>
    </message>
    <message>
        <source>A choice needs two options or more.</source>
        <translation>Eine Auswahl braucht mindestens zwei Optionen.</translation>
    </message>
    <message>
        <source>A task gives its reason for at least one wrong answer.</source>
        <translation>Eine Aufgabe gibt zu mindestens einer falschen Antwort den Grund an.</translation>
    </message>
    <message>
        <source>What is right is told in one way: by &quot;accepted&quot;, by &quot;conditions&quot;, or by &quot;is&quot; of every field.</source>
        <translation>Was richtig ist, wird auf eine Art gesagt: durch „accepted“, durch „conditions“ oder durch „is“ jedes Felds.</translation>
    </message>
    <message>
        <source>Conditions need a solution that fulfils them.</source>
        <translation>Bedingungen brauchen eine Lösung, die sie erfüllt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no kind of exercise; `geargraph-cli exercises kinds` lists them.</source>
        <translation>„%1“ ist keine Übungsart; `geargraph-cli exercises kinds` listet sie auf.</translation>
    </message>
    <message>
        <source>A drawing is judged by numbers.</source>
        <translation>Eine Zeichnung wird nach Zahlen beurteilt.</translation>
    </message>
    <message>
        <source>Either one value is given or bounds, not both.</source>
        <translation>Entweder wird ein Wert angegeben oder Grenzen, nicht beides.</translation>
    </message>
    <message>
        <source>A condition has &quot;equals&quot;, &quot;least&quot; or &quot;most&quot;.</source>
        <translation>Eine Bedingung hat „equals“, „least“ oder „most“.</translation>
    </message>
    <message>
        <source>A drawing has to fulfil something.</source>
        <translation>Eine Zeichnung muss etwas erfüllen.</translation>
    </message>
    <message>
        <source>This is the position of a condition, counted from 0.</source>
        <translation>Das ist die Stelle einer Bedingung, ab 0 gezählt.</translation>
    </message>
    <message>
        <source>A task gives its reason for at least one wrong drawing.</source>
        <translation>Eine Aufgabe gibt zu mindestens einer falschen Zeichnung den Grund an.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is not known here.</source>
        <translation>Das Mitglied „%1“ ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>The document has a fault: %1</source>
        <translation>Das Dokument hat einen Fehler: %1</translation>
    </message>
    <message>
        <source>A task is one of type, choose, pick, predict, find, exercise and draw.</source>
        <translation>Eine Aufgabe hat eine der Arten type, choose, pick, predict, find, exercise und draw.</translation>
    </message>
    <message>
        <source>An equation between velocities has no number without one: write the input&apos;s velocity.</source>
        <translation>Eine Gleichung zwischen Geschwindigkeiten hat ohne eine solche keine Zahl: Schreiben Sie die Geschwindigkeit des Antriebs.</translation>
    </message>
    <message>
        <source>This equation has no velocity: write θ or ω with a label.</source>
        <translation>Diese Gleichung hat keine Geschwindigkeit: Schreiben Sie θ oder ω mit einer Bezeichnung.</translation>
    </message>
    <message>
        <source>The equation is true for these teeth and not for all: it holds another mesh&apos;s ratio.</source>
        <translation>Die Gleichung gilt für diese Zähnezahlen, aber nicht allgemein: Sie enthält die Übersetzung eines anderen Zahneingriffs.</translation>
    </message>
    <message>
        <source>The sign of the term with %1 is wrong: with the other one the equation holds.</source>
        <translation>Das Vorzeichen des Terms mit %1 ist falsch: Mit dem anderen gilt die Gleichung.</translation>
    </message>
    <message>
        <source>The ratio %1 is upside down: it is N of the tail over N of the head.</source>
        <translation>Die Übersetzung %1 steht verkehrt herum: Sie ist N des Fußes durch N der Spitze.</translation>
    </message>
    <message>
        <source>The ratio %1 is upside down, and a sign is wrong besides.</source>
        <translation>Die Übersetzung %1 steht verkehrt herum, und außerdem ist ein Vorzeichen falsch.</translation>
    </message>
    <message>
        <source>The number before %1 is upside down.</source>
        <translation>Die Zahl vor %1 steht verkehrt herum.</translation>
    </message>
    <message>
        <source>A term with θ%1 is left out.</source>
        <translation>Ein Term mit θ%1 fehlt.</translation>
    </message>
    <message>
        <source>In place of %1 there should be θ%2.</source>
        <translation>Statt %1 muss hier θ%2 stehen.</translation>
    </message>
    <message>
        <source>With θ%1 = 1 and the other inputs at rest the left side is greater than the right one by %2.</source>
        <translation>Mit θ%1 = 1 und den anderen Antrieben in Ruhe ist die linke Seite um %2 größer als die rechte.</translation>
    </message>
    <message>
        <source>The equation is true for these teeth only.</source>
        <translation>Die Gleichung gilt nur für diese Zähnezahlen.</translation>
    </message>
    <message>
        <source>This mechanism has no motion to check an equation against.</source>
        <translation>Dieser Mechanismus hat keine Bewegung, mit der sich eine Gleichung prüfen ließe.</translation>
    </message>
    <message>
        <source>You exchange rows and columns of %1.</source>
        <translation>Sie vertauschen Zeilen und Spalten von %1.</translation>
    </message>
    <message>
        <source>You leave out the minus of (23): what is on the other side of the equation changes its sign.</source>
        <translation>Sie lassen das Minus von (23) weg: Was auf der anderen Seite der Gleichung steht, wechselt das Vorzeichen.</translation>
    </message>
    <message>
        <source>You write all entries without their signs: −1 where a walk runs against an arrow.</source>
        <translation>Sie schreiben alle Einträge ohne Vorzeichen: −1, wo ein Weg gegen einen Pfeil läuft.</translation>
    </message>
    <message>
        <source>You exchange rows and columns of %1, and + and − besides.</source>
        <translation>Sie vertauschen Zeilen und Spalten von %1 und außerdem + und −.</translation>
    </message>
    <message>
        <source>These are the rows of T: P multiplies each entry by the joint&apos;s coefficient.</source>
        <translation>Das sind die Zeilen von T: P multipliziert jeden Eintrag mit dem Koeffizienten des Gelenks.</translation>
    </message>
    <message>
        <source>These are the signs of P alone: each is to be multiplied by the ratio of its gear.</source>
        <translation>Das sind nur die Vorzeichen von P: Jedes ist mit der Übersetzung seines Rads zu multiplizieren.</translation>
    </message>
    <message>
        <source>Your ratios are upside down: a joint on the axis of the tail&apos;s gear has i, one on the head&apos;s has 1.</source>
        <translation>Ihre Übersetzungen stehen verkehrt herum: Ein Gelenk auf der Achse des Rads am Fuß hat i, eines auf der des Rads an der Spitze 1.</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>mehrdeutig</translation>
    </message>
    <message>
        <source>another matrix than the one asked for</source>
        <translation>andere Matrix als die verlangte</translation>
    </message>
    <message>
        <source>size that the matrix does not have</source>
        <translation>Größe, die die Matrix nicht hat</translation>
    </message>
    <message>
        <source>minus of the solution left out</source>
        <translation>Minus der Lösung weggelassen</translation>
    </message>
    <message>
        <source>row of another output</source>
        <translation>Zeile eines anderen Abtriebs</translation>
    </message>
    <message>
        <source>ratio of another mesh with the same value</source>
        <translation>Übersetzung eines anderen Zahneingriffs mit demselben Wert</translation>
    </message>
    <message>
        <source>input that the output does not feel</source>
        <translation>Antrieb, von dem der Abtrieb nichts spürt</translation>
    </message>
    <message>
        <source>entry that differs</source>
        <translation>Eintrag, der abweicht</translation>
    </message>
    <message>
        <source>velocity left out of the equation</source>
        <translation>Geschwindigkeit in der Gleichung weggelassen</translation>
    </message>
    <message>
        <source>velocity of another joint or link</source>
        <translation>Geschwindigkeit eines anderen Gelenks oder Glieds</translation>
    </message>
    <message>
        <source>equation that does not follow from the mechanism</source>
        <translation>Gleichung, die nicht aus dem Mechanismus folgt</translation>
    </message>
    <message>
        <source>This is %1, not %2.</source>
        <translation>Das ist %1, nicht %2.</translation>
    </message>
    <message>
        <source>%1 has the size %2 for this mechanism, and yours is %3.</source>
        <translation>%1 hat für diesen Mechanismus die Größe %2, Ihre hat %3.</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>No matrix of this mechanism has the size %1: %2.</source>
        <translation>Keine Matrix dieses Mechanismus hat die Größe %1: %2.</translation>
    </message>
    <message>
        <source>%1 is no label of %2, or occurs twice: its rows are %3, its columns %4.</source>
        <translation>%1 ist keine Bezeichnung von %2 oder kommt zweimal vor: Die Zeilen sind %3, die Spalten %4.</translation>
    </message>
    <message>
        <source>This mechanism has no %1.</source>
        <translation>Dieser Mechanismus hat keine %1.</translation>
    </message>
    <message>
        <source>These inputs depend on each other, so there is no solution for them.</source>
        <translation>Diese Antriebe hängen voneinander ab, also gibt es für sie keine Lösung.</translation>
    </message>
    <message>
        <source>You turn the arrow of edge %1 round: it points from link %2 to link %3.</source>
        <translation>Sie kehren den Pfeil von Kante %1 um: Er weist von Glied %2 zu Glied %3.</translation>
    </message>
    <message>
        <source>The number is right for these teeth and the formula is not: it holds another mesh&apos;s ratio.</source>
        <translation>Die Zahl stimmt für diese Zähnezahlen, die Formel nicht: Sie enthält die Übersetzung eines anderen Zahneingriffs.</translation>
    </message>
    <message>
        <source>This is the row of %1, not of %2.</source>
        <translation>Das ist die Zeile von %1, nicht von %2.</translation>
    </message>
    <message>
        <source>You exchange the gears of mesh %1: i%1 belongs to the joints on the tail&apos;s axis.</source>
        <translation>Sie vertauschen die Räder von Eingriff %1: i%1 gehört zu den Gelenken auf der Achse des Fußes.</translation>
    </message>
    <message>
        <source>The sign of bevel mesh %1 follows from its pitch point, seen from both axes.</source>
        <translation>Das Vorzeichen von Kegeleingriff %1 folgt aus seinem Wälzpunkt, von beiden Achsen aus gesehen.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: its gears turn the same way, seen from the carrier.</source>
        <translation>Eingriff %1 ist innenverzahnt: Vom Steg aus gesehen drehen seine Räder gleichsinnig.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: its gears turn opposite ways, seen from the carrier.</source>
        <translation>Eingriff %1 ist außenverzahnt: Vom Steg aus gesehen drehen seine Räder gegensinnig.</translation>
    </message>
    <message>
        <source>The ratio of mesh %1 is upside down and its sign is wrong.</source>
        <translation>Die Übersetzung von Eingriff %1 steht verkehrt herum, und ihr Vorzeichen ist falsch.</translation>
    </message>
    <message>
        <source>This is the row of the cycle: in P its signs are multiplied by the coefficients of mesh %1.</source>
        <translation>Das ist die Zeile des Zyklus: In P werden seine Vorzeichen mit den Koeffizienten von Eingriff %1 multipliziert.</translation>
    </message>
    <message>
        <source>You leave out the signs of the cycle of mesh %1, which walks against some arrows.</source>
        <translation>Sie lassen die Vorzeichen des Zyklus von Eingriff %1 weg, der gegen manche Pfeile läuft.</translation>
    </message>
    <message>
        <source>Joint %1 turns the other way: the sign of one mesh of its chain is wrong.</source>
        <translation>Gelenk %1 dreht sich andersherum: Das Vorzeichen eines Eingriffs seiner Kette ist falsch.</translation>
    </message>
    <message>
        <source>The row of joint %1 is upside down: it is output over input.</source>
        <translation>Die Zeile von Gelenk %1 steht verkehrt herum: Sie ist Abtrieb durch Antrieb.</translation>
    </message>
    <message>
        <source>In the sense that you walk it, the entry is %1.</source>
        <translation>In Ihrem Umlaufsinn ist der Eintrag %1.</translation>
    </message>
    <message>
        <source>So the entry is %1.</source>
        <translation>Also ist der Eintrag %1.</translation>
    </message>
    <message>
        <source>Entries of this matrix are −1, 0 or 1.</source>
        <translation>Einträge dieser Matrix sind −1, 0 oder 1.</translation>
    </message>
    <message>
        <source>Joint %1 is not on cycle %2, so its coefficient is 0.</source>
        <translation>Gelenk %1 liegt nicht auf Zyklus %2, also ist sein Koeffizient 0.</translation>
    </message>
    <message>
        <source>In the multiple of row %1 that you write, joint %2 has %3.</source>
        <translation>Im Vielfachen von Zeile %1, das Sie schreiben, hat Gelenk %2 %3.</translation>
    </message>
    <message>
        <source>Joint %1 does not feel input %2: 0.</source>
        <translation>Gelenk %1 spürt Antrieb %2 nicht: 0.</translation>
    </message>
    <message>
        <source>With input %1 alone, joint %2 turns at %3 times its speed.</source>
        <translation>Mit Antrieb %1 allein dreht sich Gelenk %2 mit dem %3-Fachen seiner Drehzahl.</translation>
    </message>
    <message>
        <source>Without labels it may be either: write the labels of rows and columns.</source>
        <translation>Ohne Bezeichnungen kann es jede von beiden sein: Schreiben Sie die Bezeichnungen der Zeilen und Spalten.</translation>
    </message>
    <message>
        <source>Your rows are in another order: %1.</source>
        <translation>Ihre Zeilen stehen in anderer Reihenfolge: %1.</translation>
    </message>
    <message>
        <source>Your columns are in another order: %1.</source>
        <translation>Ihre Spalten stehen in anderer Reihenfolge: %1.</translation>
    </message>
    <message>
        <source>You walk %1 the other way, which is as good: all signs of the row change.</source>
        <translation>Sie durchlaufen %1 andersherum, was ebenso gut ist: Alle Vorzeichen der Zeile wechseln.</translation>
    </message>
    <message>
        <source>You take another spanning tree, of the edges %1: for it the matrix is right.</source>
        <translation>Sie nehmen einen anderen Spannbaum, aus den Kanten %1: Für ihn stimmt die Matrix.</translation>
    </message>
    <message>
        <source>This mechanism has no ratio %1.</source>
        <translation>Dieser Mechanismus hat keine Übersetzung %1.</translation>
    </message>
    <message>
        <source>Link %1 has no gear, so %2 has no value.</source>
        <translation>Glied %1 hat kein Rad, also hat %2 keinen Wert.</translation>
    </message>
    <message>
        <source>Link %1 has several gears: write %2&apos; or %2&apos;&apos;, in the order of its meshes.</source>
        <translation>Glied %1 hat mehrere Räder: Schreiben Sie %2&apos; oder %2&apos;&apos;, in der Reihenfolge seiner Zahneingriffe.</translation>
    </message>
    <message>
        <source>The diameter %1 is no fraction: use numbers of teeth.</source>
        <translation>Der Durchmesser %1 ist kein Bruch: Verwenden Sie Zähnezahlen.</translation>
    </message>
    <message>
        <source>This mechanism has no turning joint %1, so no %2.</source>
        <translation>Dieser Mechanismus hat kein Drehgelenk %1, also kein %2.</translation>
    </message>
    <message>
        <source>%1 names no links of this mechanism: write ω with two labels, as ω5_1.</source>
        <translation>%1 nennt keine Glieder dieses Mechanismus: Schreiben Sie ω mit zwei Bezeichnungen, etwa ω5_1.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree, so no velocity follows from them.</source>
        <translation>Die Drehgelenke bilden keinen Spannbaum, also folgen aus ihnen keine Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>The velocity of link %1 relative to link %2 has several directions: write one equation for each level.</source>
        <translation>Die Geschwindigkeit von Glied %1 gegenüber Glied %2 hat mehrere Richtungen: Schreiben Sie für jede Ebene eine Gleichung.</translation>
    </message>
    <message>
        <source>An entry is missing here.</source>
        <translation>Hier fehlt ein Eintrag.</translation>
    </message>
    <message>
        <source>This formula is too long.</source>
        <translation>Diese Formel ist zu lang.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: write a number, a fraction or names such as i15, n41, N4, θ8 or ω51.</source>
        <translation>„%1“ ist nicht lesbar: Schreiben Sie eine Zahl, einen Bruch oder Namen wie i15, n41, N4, θ8 oder ω51.</translation>
    </message>
    <message>
        <source>A velocity is multiplied by a velocity here.</source>
        <translation>Hier wird eine Geschwindigkeit mit einer Geschwindigkeit multipliziert.</translation>
    </message>
    <message>
        <source>Something is divided by a velocity here.</source>
        <translation>Hier wird etwas durch eine Geschwindigkeit geteilt.</translation>
    </message>
    <message>
        <source>Something is divided by 0 here.</source>
        <translation>Hier wird etwas durch 0 geteilt.</translation>
    </message>
    <message>
        <source>This formula has too many parentheses inside each other.</source>
        <translation>In dieser Formel sind zu viele Klammern verschachtelt.</translation>
    </message>
    <message>
        <source>A power needs a whole number of at most %1.</source>
        <translation>Eine Potenz braucht eine ganze Zahl, höchstens %1.</translation>
    </message>
    <message>
        <source>“%1” can be read as a thousand or as a decimal: write it without the comma.</source>
        <translation>„%1“ lässt sich als Tausender- oder als Dezimalzahl lesen: Schreiben Sie die Zahl ohne das Komma.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>“%1” holds a velocity, and an entry of a matrix is a number.</source>
        <translation>„%1“ enthält eine Geschwindigkeit, und ein Eintrag einer Matrix ist eine Zahl.</translation>
    </message>
    <message>
        <source>The text has more than %1 bytes.</source>
        <translation>Der Text hat mehr als %1 Byte.</translation>
    </message>
    <message>
        <source>There is no matrix and no equation.</source>
        <translation>Es gibt weder eine Matrix noch eine Gleichung.</translation>
    </message>
    <message>
        <source>This \begin has no name in braces.</source>
        <translation>Dieses \begin hat keinen Namen in Klammern.</translation>
    </message>
    <message>
        <source>\begin{%1} has no \end{%1}.</source>
        <translation>\begin{%1} hat kein \end{%1}.</translation>
    </message>
    <message>
        <source>This bracket is not closed.</source>
        <translation>Diese Klammer ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>The matrix has more than %1 entries.</source>
        <translation>Die Matrix hat mehr als %1 Einträge.</translation>
    </message>
    <message>
        <source>The matrix has no rows.</source>
        <translation>Die Matrix hat keine Zeilen.</translation>
    </message>
    <message>
        <source>Row %1 has 1 entry, the first has %2.</source>
        <translation>Zeile %1 hat 1 Eintrag, die erste hat %2.</translation>
    </message>
    <message>
        <source>Row %1 has %2 entries, the first has %3.</source>
        <translation>Zeile %1 hat %2 Einträge, die erste hat %3.</translation>
    </message>
    <message>
        <source>This row has a label and no entry.</source>
        <translation>Diese Zeile hat eine Bezeichnung und keinen Eintrag.</translation>
    </message>
    <message>
        <source>There are %1 labels for %2 columns.</source>
        <translation>Es gibt %1 Bezeichnungen für %2 Spalten.</translation>
    </message>
    <message>
        <source>There are %1 labels for %2 rows.</source>
        <translation>Es gibt %1 Bezeichnungen für %2 Zeilen.</translation>
    </message>
    <message>
        <source>There is no equation.</source>
        <translation>Es gibt keine Gleichung.</translation>
    </message>
    <message>
        <source>This line has no equals sign.</source>
        <translation>Diese Zeile hat kein Gleichheitszeichen.</translation>
    </message>
    <message>
        <source>A side of this equation is empty.</source>
        <translation>Eine Seite dieser Gleichung ist leer.</translation>
    </message>
    <message>
        <source>The symbolic solution has %1 entries; it was left out.</source>
        <translation>Die symbolische Lösung hat %1 Einträge; sie wurde weggelassen.</translation>
    </message>
    <message>
        <source>The equations of this mechanism are so coupled that the symbolic solution would fill pages; it was left out.</source>
        <translation>Die Gleichungen dieses Mechanismus sind so gekoppelt, dass die symbolische Lösung Seiten füllen würde; sie wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 entries of the symbolic solution are left as a chain of substitutions: expanded, one has over %2 terms, or all together over %3 factors.</source>
        <translation>%1 Einträge der symbolischen Lösung bleiben eine Substitutionskette: Ausmultipliziert hat einer über %2 Terme, oder alle zusammen über %3 Faktoren.</translation>
    </message>
    <message>
        <source>Masses need lengths in metres, and &quot;%1&quot; is no unit of length that is known: use mm, cm, m or in.</source>
        <translation>Massen brauchen Längen in Metern, und „%1“ ist keine bekannte Längeneinheit: Verwenden Sie mm, cm, m oder in.</translation>
    </message>
    <message>
        <source>It ends where joint %1 reaches the end of its range.</source>
        <translation>Sie endet, wo Gelenk %1 das Ende seines Bereichs erreicht.</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: torques determine no acceleration.</source>
        <translation>Eine Bewegung der Antriebe bewegt keine Masse: Momente bestimmen keine Beschleunigung.</translation>
    </message>
    <message>
        <source>It ends where speeds grow beyond what can be followed.</source>
        <translation>Sie endet, wo Drehgeschwindigkeiten über das hinauswachsen, was sich verfolgen lässt.</translation>
    </message>
    <message>
        <source>The ratio of an input to joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, give a ratio that it can.</source>
        <translation>Die Übersetzung eines Antriebs zu Gelenk %1 liegt über der größten Zahl, die die Analyse darstellen kann, 1.79e308. Zähnezahlen, die näher beieinanderliegen, oder weniger Eingriffe hintereinander geben eine, die sie darstellen kann.</translation>
    </message>
    <message>
        <source>The speed of joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Lower the speeds of the inputs.</source>
        <translation>Die Drehgeschwindigkeit von Gelenk %1 liegt über der größten Zahl, die die Analyse darstellen kann, 1.79e308. Senken Sie die Drehgeschwindigkeiten der Antriebe.</translation>
    </message>
    <message>
        <source>The speed of the link that turns about joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Lower the speeds of the inputs.</source>
        <translation>Die Drehgeschwindigkeit des Glieds, das sich um Gelenk %1 dreht, liegt über der größten Zahl, die die Analyse darstellen kann, 1.79e308. Senken Sie die Drehgeschwindigkeiten der Antriebe.</translation>
    </message>
    <message>
        <source>In state %1: %2</source>
        <translation>Im Zustand %1: %2</translation>
    </message>
    <message>
        <source>In states %1: %2</source>
        <translation>In den Zuständen %1: %2</translation>
    </message>
    <message>
        <source>No load is given: all torques are 0.</source>
        <translation>Keine Last ist gegeben: Alle Momente sind 0.</translation>
    </message>
    <message>
        <source>The drive of state %1, link %2, gets 1 N m, as no load acts on it or on the driven link.</source>
        <translation>Der Antrieb des Zustands %1, Glied %2, bekommt 1 N m, weil weder auf ihn noch auf den Abtrieb eine Last wirkt.</translation>
    </message>
    <message>
        <source>The unit of length, &quot;%1&quot;, has no known size: forces of teeth and bearings are left out, and so are loads that are forces. Units are nm, um, mm, cm, dm, m, mil, in and ft.</source>
        <translation>Die Größe der Längeneinheit „%1“ ist nicht bekannt: Kräfte von Zähnen und Lagern werden weggelassen, und auch Lasten, die Kräfte sind. Einheiten sind nm, um, mm, cm, dm, m, mil, in und ft.</translation>
    </message>
    <message>
        <source>The unit of length, &quot;%1&quot;, has no known size: forces of teeth and bearings are left out. Units are nm, um, mm, cm, dm, m, mil, in and ft.</source>
        <translation>Die Größe der Längeneinheit „%1“ ist nicht bekannt: Kräfte von Zähnen und Lagern werden weggelassen. Einheiten sind nm, um, mm, cm, dm, m, mil, in und ft.</translation>
    </message>
    <message>
        <source>Speeds are not determined: powers and efficiencies are left out. Give inputs their speeds, or choose a state of one degree of freedom.</source>
        <translation>Die Drehgeschwindigkeiten sind nicht bestimmt: Leistungen und Wirkungsgrade werden weggelassen. Geben Sie den Antrieben ihre Drehgeschwindigkeiten, oder wählen Sie einen Zustand mit einem Freiheitsgrad.</translation>
    </message>
    <message>
        <source>No mesh has an efficiency: give `efficiency` or `friction` in the document, or --eta.</source>
        <translation>Kein Eingriff hat einen Wirkungsgrad: Geben Sie `efficiency` oder `friction` im Dokument an, oder --eta.</translation>
    </message>
    <message>
        <source>Nothing holds this motion: joint %1 turns freely under the load on %2. Add a balance at joint %3.</source>
        <translation>Nichts hält diese Bewegung: Gelenk %1 dreht sich frei unter der Last auf %2. Fügen Sie ein Ausgleichsmoment in Gelenk %3 hinzu.</translation>
    </message>
    <message>
        <source>Nothing holds this motion: joints %1 turn freely under the load on %2. Add a balance at joint %3.</source>
        <translation>Nichts hält diese Bewegung: Gelenke %1 drehen sich frei unter der Last auf %2. Fügen Sie ein Ausgleichsmoment in Gelenk %3 hinzu.</translation>
    </message>
    <message>
        <source>coupling %1</source>
        <translation>Schaltelement %1</translation>
    </message>
    <message>
        <source>couplings %1</source>
        <translation>Schaltelemente %1</translation>
    </message>
    <message>
        <source>balances</source>
        <translation>Ausgleichsmomente</translation>
    </message>
    <message>
        <source>%1 share the load in proportions that stiffness and clearance decide (1 self-stress).</source>
        <translation>%1 teilen sich die Last in Anteilen, die Steifigkeit und Spiel bestimmen (1 Eigenspannungszustand).</translation>
    </message>
    <message>
        <source>%1 share the load in proportions that stiffness and clearance decide (%2 self-stresses).</source>
        <translation>%1 teilen sich die Last in Anteilen, die Steifigkeit und Spiel bestimmen (%2 Eigenspannungszustände).</translation>
    </message>
    <message>
        <source>Torques outside are determined.</source>
        <translation>Momente außerhalb sind bestimmt.</translation>
    </message>
    <message>
        <source>Torques that do not depend on them are determined.</source>
        <translation>Momente, die nicht von ihnen abhängen, sind bestimmt.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load needs no balance.</source>
        <translation>Gelenk %1 kann sich nicht drehen: Seine Last braucht kein Ausgleichsmoment.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load is carried by mesh %2.</source>
        <translation>Gelenk %1 kann sich nicht drehen: Eingriff %2 trägt seine Last.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load is carried by meshes %2.</source>
        <translation>Gelenk %1 kann sich nicht drehen: Eingriffe %2 tragen seine Last.</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction.</source>
        <translation>Kein Moment an %1 bewegt diese Last: Das Getriebe ist in dieser Richtung selbsthemmend.</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction (it begins below eta = %2).</source>
        <translation>Kein Moment an %1 bewegt diese Last: Das Getriebe ist in dieser Richtung selbsthemmend (es beginnt unter eta = %2).</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction (it begins at %2 % of these losses).</source>
        <translation>Kein Moment an %1 bewegt diese Last: Das Getriebe ist in dieser Richtung selbsthemmend (es beginnt bei %2 % dieser Verluste).</translation>
    </message>
    <message>
        <source>Mesh %1 passes %2 times the power fed, seen from its carrier.</source>
        <translation>Eingriff %1 überträgt, von seinem Steg aus gesehen, das %2-Fache der zugeführten Leistung.</translation>
    </message>
    <message>
        <source>Meshes %1 pass up to %2 times the power fed, seen from their carriers.</source>
        <translation>Eingriffe %1 übertragen, von ihren Stegen aus gesehen, bis zum %2-Fachen der zugeführten Leistung.</translation>
    </message>
    <message>
        <source>%1 W of each W fed circulate through %2 and %3.</source>
        <translation>%1 W von jedem zugeführten W laufen als Blindleistung um, durch %2 und %3.</translation>
    </message>
    <message>
        <source>links %1</source>
        <translation>Glieder %1</translation>
    </message>
    <message>
        <source>Turning joints %1 name one axis (%2) but do not all hang together on it by common links: they coincide only in the drawn pose and are treated as different axes (%3). Give each axis of the mechanism its own entry in axes.</source>
        <translation>Drehgelenke %1 nennen eine Achse (%2), hängen darauf aber nicht alle durch gemeinsame Glieder zusammen: Sie fallen nur in der gezeichneten Lage zusammen und gelten als verschiedene Achsen (%3). Geben Sie jeder Achse des Mechanismus ihren eigenen Eintrag in axes.</translation>
    </message>
    <message>
        <source>Axes %1 are one line held by common links: they are treated as one axis (%2).</source>
        <translation>Achsen %1 sind eine Gerade, die gemeinsame Glieder halten: Sie gelten als eine Achse (%2).</translation>
    </message>
    <message>
        <source>The opposite direction of %1 is minded.</source>
        <translation>Die entgegengesetzte Richtung von %1 ist berücksichtigt.</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>New note here</source>
        <translation>Neue Notiz hier</translation>
    </message>
    <message>
        <source>Change the text</source>
        <translation>Text ändern</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Notiz hinzufügen</translation>
    </message>
    <message>
        <source>Delete note</source>
        <translation>Notiz löschen</translation>
    </message>
    <message>
        <source>Change note</source>
        <translation>Notiz ändern</translation>
    </message>
    <message>
        <source>Text of the note</source>
        <translation>Text der Notiz</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Return takes the text, Shift+Return begins a new line, Esc leaves it as it was</source>
        <translation>Eingabe übernimmt den Text, Umschalt+Eingabe beginnt eine neue Zeile, Esc lässt ihn, wie er war</translation>
    </message>
    <message>
        <source>A note has at most 1,000 characters.</source>
        <translation>Eine Notiz hat höchstens 1000 Zeichen.</translation>
    </message>
    <message>
        <source>Move note</source>
        <translation>Notiz verschieben</translation>
    </message>
    <message>
        <source>Notes are written on the sheet of the digraph</source>
        <translation>Notizen stehen auf dem Blatt des Digraphen</translation>
    </message>
    <message>
        <source>Never self-locking, however large the losses</source>
        <translation>Nie selbsthemmend, wie groß die Verluste auch sind</translation>
    </message>
    <message>
        <source>Moves up to %1 % of these losses; beyond, not decided</source>
        <translation>Läuft bis %1 % dieser Verluste; darüber nicht entschieden</translation>
    </message>
    <message>
        <source>Moves backward up to %1 % of these losses; beyond, not decided</source>
        <translation>Läuft rückwärts bis %1 % dieser Verluste; darüber nicht entschieden</translation>
    </message>
    <message>
        <source>Moves down to η = %1; below, not decided</source>
        <translation>Läuft bis herab zu η = %1; darunter nicht entschieden</translation>
    </message>
    <message>
        <source>Moves backward down to η = %1; below, not decided</source>
        <translation>Läuft rückwärts bis herab zu η = %1; darunter nicht entschieden</translation>
    </message>
    <message>
        <source>Self-locking from %1 % of these losses on</source>
        <translation>Selbsthemmend ab %1 % dieser Verluste</translation>
    </message>
    <message>
        <source>Self-locking backward from %1 % of these losses on</source>
        <translation>Rückwärts selbsthemmend ab %1 % dieser Verluste</translation>
    </message>
    <message>
        <source>Where a train locks itself, no torque of what holds the loads moves them, however large.</source>
        <translation>Wo ein Getriebe sich selbst hemmt, bewegt kein Moment dessen, was die Lasten hält, diese, so groß es auch sei.</translation>
    </message>
    <message>
        <source>The meshes state different efficiencies: all their losses, 1 − η, are multiplied by one factor.</source>
        <translation>Die Zahneingriffe nennen verschiedene Wirkungsgrade: Alle ihre Verluste, 1 − η, werden mit einem Faktor multipliziert.</translation>
    </message>
    <message>
        <source>The efficiency counts as the same in all meshes.</source>
        <translation>Der Wirkungsgrad gilt als in allen Zahneingriffen gleich.</translation>
    </message>
    <message>
        <source>At %1 % it moves, at %2 % no choice of driving gears solves it.</source>
        <translation>Bei %1 % bewegt es sich, bei %2 % löst es keine Wahl der treibenden Räder.</translation>
    </message>
    <message>
        <source>At η = %1 it moves, at %2 no choice of driving gears solves it.</source>
        <translation>Bei η = %1 bewegt es sich, bei %2 löst es keine Wahl der treibenden Räder.</translation>
    </message>
    <message>
        <source>Of that many meshes not all choices were tried.</source>
        <translation>Bei so vielen Zahneingriffen wurden nicht alle probiert.</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 Notiz</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 Notizen</translation>
    </message>
    <message>
        <source>Select links or notes to copy; the ground stays where it is.</source>
        <translation>Wählen Sie Glieder oder Notizen zum Kopieren aus; das Gestell bleibt, wo es ist.</translation>
    </message>
    <message>
        <source>Rename a link, change a note</source>
        <translation>Glied umbenennen, Notiz ändern</translation>
    </message>
    <message>
        <source>Write a note on the sheet of the digraph: click where it should be; a double click changes one</source>
        <translation>Eine Notiz auf das Blatt des Digraphen schreiben: klicken, wo sie stehen soll; ein Doppelklick ändert eine</translation>
    </message>
    <message>
        <source>Select one link to rename it, or one note to change it.</source>
        <translation>Wählen Sie ein Glied aus, um es umzubenennen, oder eine Notiz, um sie zu ändern.</translation>
    </message>
    <message>
        <source>Move its axis</source>
        <translation>Achse verschieben</translation>
    </message>
    <message>
        <source>Move its axis (%1)</source>
        <translation>Achse verschieben (%1)</translation>
    </message>
    <message>
        <source>A mesh has no carrier in the T–T graph, or its kind is not known.</source>
        <translation>Ein Zahneingriff hat keinen Steg im T–T-Graphen, oder seine Art ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Select one note to change its text.</source>
        <translation>Wählen Sie eine einzelne Notiz, um ihren Text zu ändern.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>The text on the sheet of the digraph</source>
        <translation>Der Text auf dem Blatt des Digraphen</translation>
    </message>
    <message>
        <source>z = %1. Esc puts back</source>
        <translation>z = %1. Esc setzt zurück</translation>
    </message>
    <message>
        <source>z = %1</source>
        <translation>z = %1</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>Click to select, drag an axis to move it or the rim of a gear for its teeth. The program lays the drawing out</source>
        <translation>Klicken wählt aus; eine Achse ziehen verschiebt sie, den Rand eines Rades ziehen ändert dessen Zähne. Das Programm ordnet die Zeichnung an</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measure: click an axis, a pitch point or a gear</source>
        <translation>Messen: eine Achse, einen Wälzpunkt oder ein Rad anklicken</translation>
    </message>
    <message>
        <source>Measure distances, angles and diameters: click an axis, a pitch point or a gear, then another one, in a drawing or in 3D</source>
        <translation>Abstände, Winkel und Durchmesser messen: eine Achse, einen Wälzpunkt oder ein Rad anklicken, dann das nächste, in einer Zeichnung oder in 3D</translation>
    </message>
    <message>
        <source>This has no place to measure from. Click an axis, a mesh or a gear</source>
        <translation>Hier ist kein Ort, von dem aus gemessen wird. Eine Achse, einen Zahneingriff oder ein Rad anklicken</translation>
    </message>
    <message>
        <source>%1. Click a second one. Esc takes it back</source>
        <translation>%1. Ein zweites anklicken. Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>%1. Ctrl+C copies the result, Esc goes back</source>
        <translation>%1. Strg+C kopiert das Ergebnis, Esc geht zurück</translation>
    </message>
    <message>
        <source>Measure: %1</source>
        <translation>Messen: %1</translation>
    </message>
    <message>
        <source>pitch point of mesh %1</source>
        <translation>Wälzpunkt von Zahneingriff %1</translation>
    </message>
    <message>
        <source>centre of gear %1 in mesh %2</source>
        <translation>Mitte von Rad %1 im Zahneingriff %2</translation>
    </message>
    <message>
        <source>face of gear %1 in mesh %2</source>
        <translation>Stirnfläche von Rad %1 im Zahneingriff %2</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>centre distance</source>
        <translation>Achsabstand</translation>
    </message>
    <message>
        <source>pitch radius</source>
        <translation>Wälzkreisradius</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>along the axes</source>
        <translation>längs der Achsen</translation>
    </message>
    <message>
        <source>pitch diameter</source>
        <translation>Wälzkreisdurchmesser</translation>
    </message>
    <message>
        <source>pitch diameter of gear %1</source>
        <translation>Wälzkreisdurchmesser von Rad %1</translation>
    </message>
    <message>
        <source>tip diameter</source>
        <translation>Kopfkreisdurchmesser</translation>
    </message>
    <message>
        <source>root diameter</source>
        <translation>Fußkreisdurchmesser</translation>
    </message>
    <message>
        <source>face width</source>
        <translation>Zahnbreite</translation>
    </message>
    <message>
        <source>--captions are written in the digraph, the T–T graph and the schematic.</source>
        <translation>--captions werden im Digraphen, im T–T-Graphen und im Schema geschrieben.</translation>
    </message>
    <message>
        <source>names of links and tooth counts in a digraph, T–T graph or schematic, where there is room</source>
        <translation>Namen der Glieder und Zähnezahlen in Digraph, T–T-Graph oder Schema, wo Platz ist</translation>
    </message>
    <message>
        <source>Names and teeth</source>
        <translation>Namen und Zähne</translation>
    </message>
    <message>
        <source>Given speeds</source>
        <translation>Gegebene Drehzahlen</translation>
    </message>
    <message>
        <source>Given torques</source>
        <translation>Gegebene Drehmomente</translation>
    </message>
    <message>
        <source>No motors</source>
        <translation>Keine Motoren</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Lines in sight</source>
        <translation>Sichtbare Linien</translation>
    </message>
    <message>
        <source>Plane of points</source>
        <translation>Punktebene</translation>
    </message>
    <message>
        <source>Layout for projectors</source>
        <translation>Anordnung für Beamer</translation>
    </message>
    <message>
        <source>Drawing and 3D alone, the drawing on three fifths of the width, in large type; Reset the layout brings the panels back</source>
        <translation>Zeichnung und 3D allein, die Zeichnung auf drei Fünfteln der Breite, in großer Schrift; „Anordnung zurücksetzen“ bringt die Felder zurück</translation>
    </message>
    <message>
        <source>Lessons as &amp;web pages…</source>
        <translation>Lektionen als &amp;Webseiten …</translation>
    </message>
    <message>
        <source>Writes all lessons into a folder, with the same grader: pages for any browser, phones too, and packages for learning platforms</source>
        <translation>Schreibt alle Lektionen in einen Ordner, mit derselben Korrektur: Seiten für jeden Browser, auch auf Telefonen, und Pakete für Lernplattformen</translation>
    </message>
    <message>
        <source>Folder in which the lessons&apos; folder is made</source>
        <translation>Ordner, in dem der Ordner der Lektionen angelegt wird</translation>
    </message>
    <message>
        <source>GearGraph lessons</source>
        <translation>GearGraph-Lektionen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already: no lesson was written.</source>
        <translation>„%1“ ist schon da: Keine Lektion wurde geschrieben.</translation>
    </message>
    <message>
        <source>Range of two motors</source>
        <translation>Bereich zweier Motoren</translation>
    </message>
    <message>
        <source>Parallel lines, as both links turn alike: %1.</source>
        <translation>Parallele Linien, weil sich beide Glieder gleich drehen: %1.</translation>
    </message>
    <message>
        <source>Note: click on an empty area, or on a note to change it</source>
        <translation>Notiz: in den leeren Bereich klicken, oder auf eine Notiz, um sie zu ändern</translation>
    </message>
    <message>
        <source>Handle of %1</source>
        <translation>Griff an: %1</translation>
    </message>
    <message>
        <source>Drag to move %1, or use the arrow keys (with Shift: finer). Alt places freely, Esc puts back</source>
        <translation>Ziehen verschiebt: %1; ebenso die Pfeiltasten (mit Umschalt feiner). Alt platziert frei, Esc setzt zurück</translation>
    </message>
    <message>
        <source>the axis of joint %1</source>
        <translation>die Achse von Gelenk %1</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,velocities,forces,power</source>
        <translation>labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,velocities,forces,power</translation>
    </message>
    <message>
        <source>No power without loads: add one in Forces.</source>
        <translation>Keine Leistung ohne Lasten: unter Kräfte eine hinzufügen.</translation>
    </message>
    <message>
        <source>No power: the loads are not in balance. Forces names what is missing.</source>
        <translation>Keine Leistung: Die Lasten sind nicht im Gleichgewicht. Unter Kräfte steht, was fehlt.</translation>
    </message>
    <message>
        <source>No power without a motion.</source>
        <translation>Keine Leistung ohne Bewegung.</translation>
    </message>
    <message>
        <source>--show names labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, instant-axes, velocities, forces, power, with commas.</source>
        <translation>--show nennt labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, instant-axes, velocities, forces, power, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>2→3: from link 2 to link 3; in the colour of the link that delivers</source>
        <translation>2→3: von Glied 2 zu Glied 3; in der Farbe des abgebenden Glieds</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Seite einrichten</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Paper:</source>
        <translation>Papier:</translation>
    </message>
    <message>
        <source>Orientation:</source>
        <translation>Ausrichtung:</translation>
    </message>
    <message>
        <source>It could not be read.</source>
        <translation>Sie konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>It has more than %1 bytes.</source>
        <translation>Sie hat mehr als %1 Bytes.</translation>
    </message>
    <message>
        <source>This system cannot confine the program that reads 3D files (%1).</source>
        <translation>Dieses System kann das Programm, das 3D-Dateien liest, nicht einschließen (%1).</translation>
    </message>
    <message>
        <source>Reading it takes more than %1 MiB of memory.</source>
        <translation>Sie zu lesen braucht mehr als %1 MiB Speicher.</translation>
    </message>
    <message>
        <source>It is damaged: %1</source>
        <translation>Sie ist beschädigt: %1</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Korb</translation>
    </message>
    <message>
        <source>left wheel</source>
        <translation>linkes Rad</translation>
    </message>
    <message>
        <source>right wheel</source>
        <translation>rechtes Rad</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>Ausgleichsrad</translation>
    </message>
    <message>
        <source>pinion %1</source>
        <translation>Ausgleichsrad %1</translation>
    </message>
    <message>
        <source>housing</source>
        <translation>Gehäuse</translation>
    </message>
    <message>
        <source>bend shaft</source>
        <translation>Beugewelle</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>Beugeglied</translation>
    </message>
    <message>
        <source>roll shaft</source>
        <translation>Rollwelle</translation>
    </message>
    <message>
        <source>idler</source>
        <translation>Zwischenrad</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>planet %1</source>
        <translation>Planet %1</translation>
    </message>
    <message>
        <source>countershaft</source>
        <translation>Vorgelegewelle</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Abtrieb</translation>
    </message>
    <message>
        <source>small sun</source>
        <translation>kleine Sonne</translation>
    </message>
    <message>
        <source>large sun</source>
        <translation>große Sonne</translation>
    </message>
    <message>
        <source>short planet %1</source>
        <translation>kurzer Planet %1</translation>
    </message>
    <message>
        <source>long planet %1</source>
        <translation>langer Planet %1</translation>
    </message>
    <message>
        <source>suns</source>
        <translation>Sonnen</translation>
    </message>
    <message>
        <source>first ring</source>
        <translation>erstes Hohlrad</translation>
    </message>
    <message>
        <source>second carrier</source>
        <translation>zweiter Steg</translation>
    </message>
    <message>
        <source>first planet %1</source>
        <translation>erster Planet %1</translation>
    </message>
    <message>
        <source>second planet %1</source>
        <translation>zweiter Planet %1</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht aus</translation>
    </message>
    <message>
        <source>%1 mesh</source>
        <translation>%1 Eingriff</translation>
    </message>
    <message>
        <source>%1 meshes</source>
        <translation>%1 Eingriffe</translation>
    </message>
    <message>
        <source>%1 degree of freedom</source>
        <translation>%1 Freiheitsgrad</translation>
    </message>
    <message>
        <source>%1 degrees of freedom</source>
        <translation>%1 Freiheitsgrade</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>Tells the learning platform which parts were seen, and points; loads nothing and sends nothing else.</source>
        <translation>Meldet der Lernplattform, welche Teile angesehen wurden, und die Punkte; lädt nichts und sendet sonst nichts.</translation>
    </message>
    <message>
        <source>Works offline: this file loads nothing and sends nothing.</source>
        <translation>Funktioniert offline: Diese Datei lädt nichts und sendet nichts.</translation>
    </message>
    <message>
        <source>Made by GearGraph.</source>
        <translation>Erstellt mit GearGraph.</translation>
    </message>
    <message>
        <source>To the drawings</source>
        <translation>Zu den Zeichnungen</translation>
    </message>
    <message>
        <source>The train and its solution</source>
        <translation>Das Getriebe und seine Lösung</translation>
    </message>
    <message>
        <source>The wheels are coarse: finer ones would make the file too large.</source>
        <translation>Die Räder sind grob: Feinere würden die Datei zu groß machen.</translation>
    </message>
    <message>
        <source>From %1 to %2.</source>
        <translation>%1 → %2.</translation>
    </message>
    <message>
        <source>Along joint %1, from %2 to %3: %4.</source>
        <translation>Mit Gelenk %1 (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Against joint %1, from %2 to %3: %4.</source>
        <translation>Gegen Gelenk %1 (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Along mesh %1, from %2 to %3: %4.</source>
        <translation>Mit Eingriff %1 (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Against mesh %1, from %2 to %3: %4.</source>
        <translation>Gegen Eingriff %1 (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Turning joints: %1.</source>
        <translation>Drehgelenke: %1.</translation>
    </message>
    <message>
        <source>Gear meshes: %1.</source>
        <translation>Zahneingriffe: %1.</translation>
    </message>
    <message>
        <source>Its cycle runs along %1 and against %2.</source>
        <translation>Sein Zyklus läuft mit %1 und gegen %2.</translation>
    </message>
    <message>
        <source>Its cycle runs along %1.</source>
        <translation>Sein Zyklus läuft mit %1.</translation>
    </message>
    <message>
        <source>Its cycle runs against %1.</source>
        <translation>Sein Zyklus läuft gegen %1.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2 on %3, %4, %5 : %6 teeth.</source>
        <translation>Räder: %1 und %2; Steg: %3; %4, %5 : %6 Zähne.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2 on %3, %4 : %5 teeth.</source>
        <translation>Räder: %1 und %2; Steg: %3; %4 : %5 Zähne.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2, %3, %4 : %5 teeth.</source>
        <translation>Räder: %1 und %2; %3, %4 : %5 Zähne.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2, %3 : %4 teeth.</source>
        <translation>Räder: %1 und %2; %3 : %4 Zähne.</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Answer to question %1</source>
        <translation>Antwort auf Frage %1</translation>
    </message>
    <message>
        <source>The answers are hidden in this file, not secret, and other parts of it help: try first.</source>
        <translation>Die Antworten sind in dieser Datei versteckt, nicht geheim, und andere Teile davon helfen: Versuchen Sie es zuerst selbst.</translation>
    </message>
    <message>
        <source>Rows of P times the rates (17)</source>
        <translation>Zeilen von P mal Drehzahlen (17)</translation>
    </message>
    <message>
        <source>Coefficient matrix P (18), (19), in %1</source>
        <translation>Koeffizientenmatrix P (18), (19), in %1</translation>
    </message>
    <message>
        <source>Digraph. Solid arrows: turning joints; dashed: gear meshes.</source>
        <translation>Digraph. Durchgezogene Pfeile: Drehgelenke; gestrichelte: Zahneingriffe.</translation>
    </message>
    <message>
        <source>Schematic.</source>
        <translation>Schema.</translation>
    </message>
    <message>
        <source>T-T graph.</source>
        <translation>T-T-Graph.</translation>
    </message>
    <message>
        <source>The train</source>
        <translation>Das Getriebe</translation>
    </message>
    <message>
        <source>The train in three dimensions</source>
        <translation>Das Getriebe in drei Dimensionen</translation>
    </message>
    <message>
        <source>The train turns where scripts may run: open the file in a browser.</source>
        <translation>Das Getriebe dreht sich, wo Skripte laufen dürfen: Öffnen Sie die Datei in einem Browser.</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>The mechanism has no solution: its derivation says why.</source>
        <translation>Der Mechanismus hat keine Lösung: Den Grund nennt die Herleitung.</translation>
    </message>
    <message>
        <source>joint %1 at %2 rad/s</source>
        <translation>Gelenk %1 mit %2 rad/s</translation>
    </message>
    <message>
        <source>Inputs: %1.</source>
        <translation>Antriebe: %1.</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>now, rad/s</source>
        <translation>jetzt, rad/s</translation>
    </message>
    <message>
        <source>Speeds of the joints</source>
        <translation>Drehzahlen der Gelenke</translation>
    </message>
    <message>
        <source>Arrow keys walk its elements.</source>
        <translation>Pfeiltasten gehen durch ihre Elemente.</translation>
    </message>
    <message>
        <source>Speed of joint %1</source>
        <translation>Drehzahl von Gelenk %1</translation>
    </message>
    <message>
        <source>Speed of joint %1, exact, rad/s</source>
        <translation>Drehzahl von Gelenk %1, exakt, rad/s</translation>
    </message>
    <message>
        <source>A number such as 2, -3/4 or 0.75.</source>
        <translation>Eine Zahl wie 2, -3/4 oder 0,75.</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>Hell oder dunkel</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Walk round the cycle: left and right arrow keys step, Escape ends</source>
        <translation>Umlauf des Zyklus: Pfeiltasten links und rechts gehen Schritt für Schritt, Escape beendet</translation>
    </message>
    <message>
        <source>%1 of %2. %3</source>
        <translation>%1 von %2. %3</translation>
    </message>
    <message>
        <source>The walk is closed: row C%1 has no other entries.</source>
        <translation>Der Umlauf ist geschlossen: Zeile C%1 hat keine weiteren Einträge.</translation>
    </message>
    <message>
        <source>Walk the cycle</source>
        <translation>Zyklus durchlaufen</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Now %1 rad/s.</source>
        <translation>Jetzt %1 rad/s.</translation>
    </message>
    <message>
        <source>The train in three dimensions. Arrow keys turn it, plus and minus zoom, Space plays, comma and full stop step.</source>
        <translation>Das Getriebe in drei Dimensionen. Pfeiltasten drehen es, Plus und Minus zoomen, die Leertaste spielt ab, Komma und Punkt gehen schrittweise.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 s of %2 s</source>
        <translation>%1 s von %2 s</translation>
    </message>
    <message>
        <source>To the reference pose</source>
        <translation>Zur Bezugslage</translation>
    </message>
    <message>
        <source>%1 is at its limit of %2°.</source>
        <translation>%1 ist an der Grenze von %2°.</translation>
    </message>
    <message>
        <source>%1 has reached its limit of %2°: the motion turns round.</source>
        <translation>%1 hat seine Grenze von %2° erreicht: Die Bewegung kehrt um.</translation>
    </message>
    <message>
        <source>Whole train, from the corner</source>
        <translation>Ganzes Getriebe, schräg von oben</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>Entlang %1</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>This browser cannot show the train in three dimensions (%1).</source>
        <translation>Dieser Browser kann das Getriebe nicht in drei Dimensionen zeigen (%1).</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>Look at %1 in the drawing.</source>
        <translation>Sehen Sie in der Zeichnung nach: %1.</translation>
    </message>
    <message>
        <source>Fills the cell and goes on to the next</source>
        <translation>Füllt die Zelle und geht zur nächsten</translation>
    </message>
    <message>
        <source>Right, %1 of 1 point</source>
        <translation>Richtig, %1 von 1 Punkt</translation>
    </message>
    <message>
        <source>Right, %1 of %2 points</source>
        <translation>Richtig, %1 von %2 Punkten</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Falsch</translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <translation>Falsch: %1</translation>
    </message>
    <message>
        <source>The other field is right.</source>
        <translation>Das andere Feld ist richtig.</translation>
    </message>
    <message>
        <source>The other %1 fields are right.</source>
        <translation>Die anderen %1 Felder sind richtig.</translation>
    </message>
    <message>
        <source>No known mistake explains it. Walk through it once more, or let it be shown.</source>
        <translation>Kein bekannter Fehler erklärt es. Gehen Sie es noch einmal durch oder lassen Sie sich die Lösung zeigen.</translation>
    </message>
    <message>
        <source>Shown, no points</source>
        <translation>Gezeigt, keine Punkte</translation>
    </message>
    <message>
        <source>%1 of the mechanism</source>
        <translation>%1 des Mechanismus</translation>
    </message>
    <message>
        <source>%1 of 1 point; %2 of %3 checked</source>
        <translation>%1 von 1 Punkt; %2 von %3 geprüft</translation>
    </message>
    <message>
        <source>%1 of %2 points; %3 of %4 checked</source>
        <translation>%1 von %2 Punkten; %3 von %4 geprüft</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Frage %1 von %2</translation>
    </message>
    <message>
        <source>Previous question</source>
        <translation>Vorige Frage</translation>
    </message>
    <message>
        <source>Next question</source>
        <translation>Nächste Frage</translation>
    </message>
    <message>
        <source>Save answers</source>
        <translation>Antworten speichern</translation>
    </message>
    <message>
        <source>Enlarge: %1</source>
        <translation>Vergrößern: %1</translation>
    </message>
    <message>
        <source>Fit the window</source>
        <translation>Ins Fenster einpassen</translation>
    </message>
    <message>
        <source>Print the questions</source>
        <translation>Fragen drucken</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Vorheriger Schritt</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Hint %1 of %2</source>
        <translation>Hinweis %1 von %2</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Of the files of %1, %2 counts.</source>
        <translation>Von den Dateien von %1 zählt %2.</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Lernende</translation>
    </message>
    <message>
        <source>not right: %1</source>
        <translation>nicht richtig: %1</translation>
    </message>
    <message>
        <source>--to lists forms out of html and scorm, not &quot;%1&quot;.</source>
        <translation>--to zählt Formen aus html und scorm auf, nicht „%1“.</translation>
    </message>
    <message>
        <source>the pages</source>
        <translation>die Seiten</translation>
    </message>
    <message>
        <source>%1 has no meaning for lesson %2.</source>
        <translation>%1 hat bei lesson %2 keine Bedeutung.</translation>
    </message>
    <message>
        <source>list needs no file.</source>
        <translation>list braucht keine Datei.</translation>
    </message>
    <message>
        <source>forms: html for browsers, scorm for learning platforms (html)</source>
        <translation>Formen: html für Browser, scorm für Lernplattformen (html)</translation>
    </message>
    <message>
        <source>a folder for the pages and packages</source>
        <translation>ein Ordner für die Seiten und Pakete</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Start again? All answers and the name on this device are deleted.</source>
        <translation>Neu beginnen? Alle Antworten und der Name auf diesem Gerät werden gelöscht.</translation>
    </message>
    <message>
        <source>What you write stays in this browser. Saved answers are a small file to hand in.</source>
        <translation>Was Sie schreiben, bleibt in diesem Browser. Gespeicherte Antworten sind eine kleine Datei zum Abgeben.</translation>
    </message>
    <message>
        <source>This browser cannot grade the answers (%1): write them on paper.</source>
        <translation>Dieser Browser kann die Antworten nicht bewerten (%1): Schreiben Sie sie auf Papier.</translation>
    </message>
    <message>
        <source>The 3D file has %1 faces, more than the limit of %2.</source>
        <translation>Die 3D-Datei hat %1 Flächen, mehr als die Grenze von %2.</translation>
    </message>
    <message>
        <source>It is damaged: its header has no end.</source>
        <translation>Sie ist beschädigt: Ihr Kopf hat kein Ende.</translation>
    </message>
    <message>
        <source>It is damaged: a face names a vertex that is not there.</source>
        <translation>Sie ist beschädigt: Eine Fläche nennt einen Eckpunkt, den es nicht gibt.</translation>
    </message>
    <message>
        <source>It has no faces that could be shown.</source>
        <translation>Sie hat keine Flächen, die sich zeigen ließen.</translation>
    </message>
    <message>
        <source>The motion repeats only after %1 turns of what turns at 1 rad/s; that is too long for an animation.</source>
        <translation>Die Bewegung wiederholt sich erst nach %1 Umdrehungen dessen, was mit 1 rad/s dreht; das ist zu lang für eine Animation.</translation>
    </message>
    <message>
        <source>The motion is too fast for an animation that long.</source>
        <translation>Die Bewegung ist für eine so lange Animation zu schnell.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The scene has %1 triangles, more than the limit of %2; choose a coarser tolerance.</source>
        <translation>Die Szene hat %1 Dreiecke, mehr als die Grenze von %2; wählen Sie eine gröbere Toleranz.</translation>
    </message>
    <message>
        <source>The scene has coordinates beyond 3.4e38, the largest that 3D files hold; bring the parts nearer to each other, or scale them down.</source>
        <translation>Die Szene hat Koordinaten über 3,4e38, den größten, die 3D-Dateien fassen; rücken Sie die Teile näher zusammen oder verkleinern Sie sie.</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; is written as &quot;%2&quot;.</source>
        <translation>Das Glied „%1“ heißt in der Datei „%2“.</translation>
    </message>
    <message>
        <source>Link %1 has too little mass or inertia for simulators, which take 1e-15 kg and kg m² and more. Is the unit of length right?</source>
        <translation>Glied %1 hat zu wenig Masse oder Trägheit für Simulatoren, die 1e-15 kg und kg m² und mehr annehmen. Stimmt die Längeneinheit?</translation>
    </message>
    <message>
        <source>Coupling %1 would close a linkage and is left out.</source>
        <translation>Schaltelement %1 würde ein Gelenkgetriebe schließen und wird weggelassen.</translation>
    </message>
    <message>
        <source>Joint %1 follows %2 (q%1 = %3)</source>
        <translation>Gelenk %1 folgt %2 (q%1 = %3)</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; und %2 weitere</translation>
    </message>
    <message>
        <source>A joint of URDF can follow one other joint. %1. Use --to mjcf, or --state with one freedom.</source>
        <translation>Ein Gelenk in URDF kann einem anderen Gelenk folgen. %1. Nehmen Sie --to mjcf oder --state mit einem Freiheitsgrad.</translation>
    </message>
    <message>
        <source>2→3: from link 2 to link 3</source>
        <translation>2→3: von Glied 2 zu Glied 3</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>%1 more: select links in a drawing first</source>
        <translation>%1 weitere: Wählen Sie die Glieder zuerst in einer Zeichnung aus</translation>
    </message>
    <message>
        <source>There is more on the left</source>
        <translation>Links ist noch mehr</translation>
    </message>
    <message>
        <source>There is more on the right</source>
        <translation>Rechts ist noch mehr</translation>
    </message>
    <message>
        <source>They have no properties that could be changed together.</source>
        <translation>Sie haben keine Eigenschaften, die man gemeinsam ändern könnte.</translation>
    </message>
    <message>
        <source>Its joints have its place and direction: select one to change them.</source>
        <translation>Lage und Richtung haben ihre Gelenke: Wählen Sie eines aus, um sie zu ändern.</translation>
    </message>
    <message>
        <source>Brake %1</source>
        <translation>Bremse %1</translation>
    </message>
    <message>
        <source>Clutch %1</source>
        <translation>Kupplung %1</translation>
    </message>
    <message>
        <source>While it is engaged the brake holds its link.</source>
        <translation>Solange sie geschlossen ist, hält die Bremse ihr Glied fest.</translation>
    </message>
    <message>
        <source>While it is engaged the clutch makes its links turn as one.</source>
        <translation>Solange sie geschlossen ist, drehen sich die Glieder der Kupplung gemeinsam.</translation>
    </message>
    <message>
        <source>At most %1 inputs are listed.</source>
        <translation>Höchstens %1 Antriebe werden aufgeführt.</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: their masses and their motion appear here.</source>
        <translation>Zeichnen Sie Drehgelenke und Zahneingriffe: Massen und Bewegung erscheinen hier.</translation>
    </message>
    <message>
        <source>Nothing can turn here: without an input there is no equation of motion.</source>
        <translation>Hier kann sich nichts drehen: ohne Antrieb gibt es keine Bewegungsgleichung.</translation>
    </message>
    <message>
        <source>This train has too many inputs and joints: dynamics is computed for up to %1 entries of the solution.</source>
        <translation>Dieses Getriebe hat zu viele Antriebe und Gelenke: Die Dynamik wird für bis zu %1 Einträge der Lösung berechnet.</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentiell</translation>
    </message>
    <message>
        <source>work done</source>
        <translation>verrichtete Arbeit</translation>
    </message>
    <message>
        <source>energy balance</source>
        <translation>Energiebilanz</translation>
    </message>
    <message>
        <source>Torques of the motors</source>
        <translation>Momente der Motoren</translation>
    </message>
    <message>
        <source>Energy gained and work done</source>
        <translation>Gewonnene Energie und verrichtete Arbeit</translation>
    </message>
    <message>
        <source>No tooth counts within these limits come near this ratio with this sign. What fits: wider limits, or other members.</source>
        <translation>Keine Zähnezahlen in diesen Grenzen kommen dieser Übersetzung mit diesem Vorzeichen nahe. Was hilft: weitere Grenzen oder andere Glieder.</translation>
    </message>
    <message>
        <source>%1 is no regular file.</source>
        <translation>%1 ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB, which no answers are.</source>
        <translation>%1 ist größer als %2 MB, was keine Antworten sind.</translation>
    </message>
    <message>
        <source>Answers that cannot be read: %1.</source>
        <translation>Nicht lesbare Antworten: %1.</translation>
    </message>
    <message>
        <source>“%1” cannot be read from “%2” on: write a whole number, a fraction such as −3/4 or a decimal.</source>
        <translation>„%1“ ist ab „%2“ nicht lesbar: Schreiben Sie eine ganze Zahl, einen Bruch wie −3/4 oder eine Dezimalzahl.</translation>
    </message>
    <message>
        <source>“%1” cannot be read from “%2” on: this question knows no such symbol.</source>
        <translation>„%1“ ist ab „%2“ nicht lesbar: Diese Frage kennt kein solches Zeichen.</translation>
    </message>
    <message>
        <source>“%1” has the unit %2: write the number in %3.</source>
        <translation>„%1“ hat die Einheit %2: Schreiben Sie die Zahl in %3.</translation>
    </message>
    <message>
        <source>“%1” has the unit %2: write a number without a unit.</source>
        <translation>„%1“ hat die Einheit %2: Schreiben Sie eine Zahl ohne Einheit.</translation>
    </message>
    <message>
        <source>%1 fields are empty: %2.</source>
        <translation>%1 Felder sind leer: %2.</translation>
    </message>
    <message>
        <source>symbol that the question does not know</source>
        <translation>Zeichen, das die Frage nicht kennt</translation>
    </message>
    <message>
        <source>number in another unit</source>
        <translation>Zahl in einer anderen Einheit</translation>
    </message>
    <message>
        <source>A number is needed here.</source>
        <translation>Hier wird eine Zahl gebraucht.</translation>
    </message>
    <message>
        <source>the same number makes the same sheets everywhere (random)</source>
        <translation>dieselbe Zahl macht überall dieselben Blätter (zufällig)</translation>
    </message>
    <message>
        <source>--seed %1 makes these sheets again.</source>
        <translation>--seed %1 macht diese Blätter wieder.</translation>
    </message>
    <message>
        <source>--seed %1 asks these questions again.</source>
        <translation>--seed %1 stellt diese Fragen wieder.</translation>
    </message>
    <message>
        <source>Cannot be read: %1</source>
        <translation>Nicht lesbar: %1</translation>
    </message>
    <message>
        <source>Easy</source>
        <translation>Leicht</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Schwer</translation>
    </message>
    <message>
        <source>The document has no link &quot;%1&quot;.</source>
        <translation>Das Dokument hat kein Glied „%1“.</translation>
    </message>
    <message>
        <source>With these losses no torques are known.</source>
        <translation>Mit diesen Verlusten sind keine Momente bekannt.</translation>
    </message>
    <message>
        <source>No power: with these losses no torques are known.</source>
        <translation>Keine Leistung: Mit diesen Verlusten sind keine Momente bekannt.</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>driven</source>
        <translation>Abtrieb</translation>
    </message>
    <message>
        <source>Torques in N m</source>
        <translation>Momente in N m</translation>
    </message>
    <message>
        <source>--torque is a torque like 100Nm, not &quot;%1&quot;.</source>
        <translation>--torque ist ein Moment wie 100Nm, nicht „%1“.</translation>
    </message>
    <message>
        <source>at the drive of every state, instead of the document&apos;s</source>
        <translation>am Antrieb jedes Schaltzustands, statt des Moments im Dokument</translation>
    </message>
    <message>
        <source>efficiency of meshes that state none</source>
        <translation>Wirkungsgrad der Zahneingriffe, die keinen angeben</translation>
    </message>
    <message>
        <source>&quot;none&quot; or &quot;stiffness&quot;</source>
        <translation>&quot;none&quot; oder &quot;stiffness&quot;</translation>
    </message>
    <message>
        <source>none, stiffness or nothing</source>
        <translation>none, stiffness oder nichts</translation>
    </message>
    <message>
        <source>No forces: with these losses no torques are known. Forces tells why.</source>
        <translation>Keine Kräfte: Mit diesen Verlusten sind keine Momente bekannt. Kräfte nennt den Grund.</translation>
    </message>
    <message>
        <source>The torque that holds the loads: at the driven link, or at the drive where loads on the driven link alone are given.</source>
        <translation>Das Moment, das die Lasten hält: am Abtrieb, oder am Antrieb, wo nur Lasten am Abtrieb gegeben sind.</translation>
    </message>
    <message>
        <source>The loads on %1 act as well.</source>
        <translation>Die Lasten an %1 wirken ebenfalls.</translation>
    </message>
    <message>
        <source>The torque at the drive takes the place of the loads on %1.</source>
        <translation>Das Moment am Antrieb tritt an die Stelle der Lasten an %1.</translation>
    </message>
    <message>
        <source>State %1: link %2 turns freely beside it, at any speed. The ratio does not depend on it.</source>
        <translation>Schaltzustand %1: Glied %2 dreht sich daneben frei, mit beliebiger Drehzahl. Die Übersetzung hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>State %1: links %2 turn freely beside it, at any speed. The ratio does not depend on them.</source>
        <translation>Schaltzustand %1: Die Glieder %2 drehen sich daneben frei, mit beliebiger Drehzahl. Die Übersetzung hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>%1: %2 N m</source>
        <translation>%1: %2 N m</translation>
    </message>
    <message>
        <source>%1: %2 to %3 N m</source>
        <translation>%1: %2 bis %3 N m</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too: they are given for equally stiff teeth, an assumption.</source>
        <translation>Mit Verlusten hängen auch die Momente außerhalb davon ab: Sie gelten für gleich steife Zähne, eine Annahme.</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too, and are not given.</source>
        <translation>Mit Verlusten hängen auch die Momente außerhalb davon ab und werden nicht angegeben.</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too, and are not given: share by stiffness to find them.</source>
        <translation>Mit Verlusten hängen auch die Momente außerhalb davon ab und werden nicht angegeben: Teilen Sie nach Steifigkeit auf, um sie zu finden.</translation>
    </message>
    <message>
        <source>Speeds are not determined, so that nothing tells which gears drive: with losses, torques and powers are left out. Give inputs their speeds, or choose a state of one degree of freedom.</source>
        <translation>Die Drehzahlen sind nicht bestimmt, sodass nichts zeigt, welche Räder treiben: Mit Verlusten entfallen Momente und Leistungen. Geben Sie den Antrieben ihre Drehzahlen, oder wählen Sie einen Schaltzustand mit einem Freiheitsgrad.</translation>
    </message>
    <message>
        <source>All speeds are 0: at rest no power is lost, so that torques are those without losses. Give inputs their speeds.</source>
        <translation>Alle Drehzahlen sind 0: Im Stillstand geht keine Leistung verloren, die Momente sind also die ohne Verluste. Geben Sie den Antrieben ihre Drehzahlen.</translation>
    </message>
    <message>
        <source>The load on %1 acts where the balance at %2 holds, which cancels it: no mesh passes any of it, and it counts for no efficiency. To find what it drives, put the balance elsewhere.</source>
        <translation>Die Last an %1 wirkt dort, wo das Ausgleichsmoment an %2 hält, und wird von ihm aufgehoben: Kein Zahneingriff überträgt etwas davon, und sie zählt für keinen Wirkungsgrad. Um zu finden, was sie antreibt, legen Sie das Ausgleichsmoment an eine andere Stelle.</translation>
    </message>
    <message>
        <source>Which gears drive was not decided: the rounds of guesses do not settle, and %1 leave too many patterns to try all of them. Torques and powers are left out.</source>
        <translation>Welche Räder treiben, wurde nicht entschieden: Die Folge der Annahmen kommt nicht zur Ruhe, und %1 lassen zu viele Muster, um alle zu probieren. Momente und Leistungen entfallen.</translation>
    </message>
    <message>
        <source>With these losses no torques are known: the reason is below.</source>
        <translation>Mit diesen Verlusten sind keine Momente bekannt: Der Grund steht unten.</translation>
    </message>
    <message>
        <source>Set load sharing</source>
        <translation>Lastaufteilung setzen</translation>
    </message>
    <message>
        <source>With these losses no torques are known: Forces tells why.</source>
        <translation>Mit diesen Verlusten sind keine Momente bekannt: Kräfte nennt den Grund.</translation>
    </message>
    <message>
        <source>At the drive of every state, about its first axis; empty: that of the loads at drives, else 1 N m</source>
        <translation>Am Antrieb jedes Schaltzustands, um seine erste Achse; leer: das der Lasten an Antrieben, sonst 1 N m</translation>
    </message>
    <message>
        <source>Torque at the drive, N m</source>
        <translation>Moment am Antrieb, N m</translation>
    </message>
    <message>
        <source>Set torque at the drive</source>
        <translation>Moment am Antrieb setzen</translation>
    </message>
    <message>
        <source>Torques in N m, for %1 N m at the drive.</source>
        <translation>Momente in N m, für %1 N m am Antrieb.</translation>
    </message>
    <message>
        <source>For any sharing in which no mesh works against the others: %1.</source>
        <translation>Bei jeder Aufteilung, in der kein Zahneingriff gegen die anderen arbeitet: %1.</translation>
    </message>
    <message>
        <source>%1 is now %2</source>
        <translation>aus %1 wird %2</translation>
    </message>
    <message>
        <source>New numbers: %1</source>
        <translation>Neue Nummern: %1</translation>
    </message>
    <message>
        <source>New numbers: %1, and %2 more</source>
        <translation>Neue Nummern: %1 und %2 weitere</translation>
    </message>
    <message>
        <source>an object of whole numbers by the id of their link</source>
        <translation>ein Objekt aus ganzen Zahlen unter der id ihres Glieds</translation>
    </message>
    <message>
        <source>expected the number of a link&apos;s colour: a whole number from 1 on.</source>
        <translation>erwartet wird die Nummer der Farbe eines Glieds: eine ganze Zahl ab 1.</translation>
    </message>
    <message>
        <source>%1 is a whole number, %2 to %3.</source>
        <translation>%1 ist eine ganze Zahl von %2 bis %3.</translation>
    </message>
    <message>
        <source>A chain is links, axes and gear pairs, each pair with the link that carries both gears. Frame, teeth, kinds of gears
and the joints by which coaxial links are drawn do not matter. Equations: rotation graphs, the triples gear, gear, carrier.
Chains: displacement graphs, which tell shafts apart, too. Left out: chains where m gear pairs have fewer than m + 2
links between them, so that these turn as one; the smallest of them are listed with freedom 0.</source>
        <translation>Eine Kette besteht aus Gliedern, Achsen und Radpaaren, jedes Paar mit seinem Steg. Gestell, Zähne,
Arten der Räder und die Drehgelenke, mit denen gleichachsige Glieder gezeichnet sind, zählen nicht. Gleichungen:
Rotationsgraphen, die Tripel Rad, Rad, Steg. Ketten: Verschiebungsgraphen, die auch Wellen unterscheiden. Nicht dabei:
Ketten, in denen m Radpaare weniger als m + 2 Glieder haben, sodass diese sich wie eines drehen; die kleinsten davon
stehen unter dem Freiheitsgrad 0.</translation>
    </message>
    <message>
        <source>Counts of chains with 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301: 27 and 81 with 6 links, 152
and 647 with 7, 1070 and 6360 with 8. Nonfractionated chains with 2 freedoms: see Tsai, Lin, J. Mech. Transm. Autom. Des.
111(4), 1989, 524.</source>
        <translation>Anzahlen der Ketten mit Freiheitsgrad 1 wie bei Yang, Ding u. a., J. Mech. Des. 141(4), 2019, 043301: 27 und 81 mit
6 Gliedern, 152 und 647 mit 7, 1070 und 6360 mit 8. Nicht zerlegbare Ketten mit Freiheitsgrad 2: siehe Tsai, Lin,
J. Mech. Transm. Autom. Des. 111(4), 1989, 524.</translation>
    </message>
    <message>
        <source>freedom</source>
        <translation>Freiheitsgrad</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>Gleichungen</translation>
    </message>
    <message>
        <source>chains</source>
        <translation>Ketten</translation>
    </message>
    <message>
        <source>nonfractionated equations</source>
        <translation>nicht zerlegbare Gleichungen</translation>
    </message>
    <message>
        <source>Geared kinematic chains, one link held</source>
        <translation>Kinematische Ketten mit Rädern, ein Glied festgehalten</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>gear pairs / carrier</source>
        <translation>Radpaare / Steg</translation>
    </message>
    <message>
        <source>Equations: %1, chains: %2</source>
        <translation>Gleichungen: %1, Ketten: %2</translation>
    </message>
    <message>
        <source>Chain %1</source>
        <translation>Kette %1</translation>
    </message>
    <message>
        <source>axes: %1</source>
        <translation>Achsen: %1</translation>
    </message>
    <message>
        <source>gear pairs / carrier: %1</source>
        <translation>Radpaare / Steg: %1</translation>
    </message>
    <message>
        <source>%1 has no meaning with a number of a chain.</source>
        <translation>%1 hat bei der Nummer einer Kette keine Bedeutung.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number of a chain, as 6-1.5.1 is.</source>
        <translation>„%1“ ist keine Nummer einer Kette wie 6-1.5.1.</translation>
    </message>
    <message>
        <source>The atlas has no chain %1.</source>
        <translation>Der Atlas hat keine Kette %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; are equations; a document needs a chain, as %2 is.</source>
        <translation>„%1“ sind Gleichungen; ein Dokument braucht eine Kette wie %2.</translation>
    </message>
    <message>
        <source>One number is enough.</source>
        <translation>Eine Nummer genügt.</translation>
    </message>
    <message>
        <source>%1 needs the number of a chain.</source>
        <translation>%1 braucht die Nummer einer Kette.</translation>
    </message>
    <message>
        <source>The atlas has chains of up to %1 links with this freedom.</source>
        <translation>Mit diesem Freiheitsgrad hat der Atlas Ketten bis %1 Glieder.</translation>
    </message>
    <message>
        <source>only chains of so many links (3 to 7)</source>
        <translation>nur Ketten mit so vielen Gliedern (3 bis 7)</translation>
    </message>
    <message>
        <source>of this freedom: 1 (the default), 2, or 0: trains that cannot turn</source>
        <translation>mit diesem Freiheitsgrad: 1 (ohne Angabe), 2, oder 0: Getriebe, die sich nicht drehen können</translation>
    </message>
    <message>
        <source>with so many axes</source>
        <translation>mit so vielen Achsen</translation>
    </message>
    <message>
        <source>that no link parts, every link in a gear pair</source>
        <translation>die kein Glied zerlegt, jedes Glied in einem Radpaar</translation>
    </message>
    <message>
        <source>write the chain of the number as a document</source>
        <translation>die Kette dieser Nummer als Dokument schreiben</translation>
    </message>
    <message>
        <source>With a number</source>
        <translation>Mit einer Nummer</translation>
    </message>
    <message>
        <source>the link that is held</source>
        <translation>das Glied, das festgehalten ist</translation>
    </message>
    <message>
        <source>a gear pair, by its place, with a ring gear; may be repeated</source>
        <translation>ein Radpaar, nach seinem Platz, mit einem Hohlrad; mehrfach möglich</translation>
    </message>
    <message>
        <source>another atlas than the program&apos;s (of geargraph-make-atlas)</source>
        <translation>ein anderer Atlas als der des Programms (von geargraph-make-atlas)</translation>
    </message>
    <message>
        <source>Counts and lists geared kinematic chains; writes one as a document.</source>
        <translation>Zählt und listet kinematische Ketten mit Rädern; schreibt eine als Dokument.</translation>
    </message>
    <message>
        <source>same equations, other shafts: %1</source>
        <translation>gleiche Gleichungen, andere Wellen: %1</translation>
    </message>
    <message>
        <source>one gear pair less: %1</source>
        <translation>ein Radpaar weniger: %1</translation>
    </message>
    <message>
        <source>one gear pair more: %1</source>
        <translation>ein Radpaar mehr: %1</translation>
    </message>
    <message>
        <source>links that differ as the frame: %1</source>
        <translation>als Gestell verschiedene Glieder: %1</translation>
    </message>
    <message>
        <source>cannot turn: %1 gear pairs between %2 links, of which one is held</source>
        <translation>kann sich nicht drehen: %1 Radpaare zwischen %2 Gliedern, von denen eines festgehalten ist</translation>
    </message>
    <message>
        <source>Trains of more than %1 links are not identified.</source>
        <translation>Getriebe mit mehr als %1 Gliedern werden nicht bestimmt.</translation>
    </message>
    <message>
        <source>the identification</source>
        <translation>die Bestimmung</translation>
    </message>
    <message>
        <source>A chain that is not in the atlas</source>
        <translation>Eine Kette, die nicht im Atlas ist</translation>
    </message>
    <message>
        <source>links: %1</source>
        <translation>Glieder: %1</translation>
    </message>
    <message>
        <source>meshes: %1</source>
        <translation>Zahneingriffe: %1</translation>
    </message>
    <message>
        <source>freedom: %1</source>
        <translation>Freiheitsgrad: %1</translation>
    </message>
    <message>
        <source>locked: two of its links turn as one in every motion</source>
        <translation>gesperrt: zwei ihrer Glieder drehen sich bei jeder Bewegung wie eines</translation>
    </message>
    <message>
        <source>turns by these tooth counts only; with others it would be locked</source>
        <translation>dreht sich nur mit diesen Zähnezahlen; mit anderen wäre sie gesperrt</translation>
    </message>
    <message>
        <source>Left out: link %1, a planet that repeats another</source>
        <translation>Weggelassen: Glied %1, ein Planet, der einen anderen wiederholt</translation>
    </message>
    <message>
        <source>Left out: link %1, in no mesh</source>
        <translation>Weggelassen: Glied %1, in keinem Zahneingriff</translation>
    </message>
    <message>
        <source>There is no mesh.</source>
        <translation>Es gibt keinen Zahneingriff.</translation>
    </message>
    <message>
        <source>%1 and %2 are different chains.</source>
        <translation>%1 und %2 sind verschiedene Ketten.</translation>
    </message>
    <message>
        <source>%1 and %2 are the same chain.</source>
        <translation>%1 und %2 sind dieselbe Kette.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same equations, on other shafts.</source>
        <translation>%1 und %2 haben dieselben Gleichungen, auf anderen Wellen.</translation>
    </message>
    <message>
        <source>another document: is it the same chain, and which link is which?</source>
        <translation>ein anderes Dokument: ist es dieselbe Kette, und welches Glied ist welches?</translation>
    </message>
    <message>
        <source>Which chains of the atlas a train is made of.</source>
        <translation>Aus welchen Ketten des Atlas ein Getriebe besteht.</translation>
    </message>
    <message>
        <source>link %1 of the chain</source>
        <translation>Glied %1 der Kette</translation>
    </message>
    <message>
        <source>This is no atlas of chains.</source>
        <translation>Das ist kein Atlas von Ketten.</translation>
    </message>
    <message>
        <source>This line of the atlas is no chain with its number.</source>
        <translation>Diese Zeile des Atlas ist keine Kette mit ihrer Nummer.</translation>
    </message>
    <message>
        <source>Chain %1 is not at its place in the atlas, or there twice.</source>
        <translation>Kette %1 ist im Atlas nicht an ihrem Platz oder zweimal da.</translation>
    </message>
    <message>
        <source>also the trees, inputs and frames by which the train can be drawn</source>
        <translation>auch die Bäume, Antriebe und Gestelle, mit denen das Getriebe gezeichnet werden kann</translation>
    </message>
    <message>
        <source>with --choices: how many of each are listed (100)</source>
        <translation>mit --choices: wie viele jeweils gelistet werden (100)</translation>
    </message>
    <message>
        <source>over 2^63</source>
        <translation>über 2^63</translation>
    </message>
    <message>
        <source>Trees of turning joints: %1</source>
        <translation>Bäume aus Drehgelenken: %1</translation>
    </message>
    <message>
        <source>Valid sets of inputs, as pairs of links: %1</source>
        <translation>Gültige Sätze von Antrieben, als Paare von Gliedern: %1</translation>
    </message>
    <message>
        <source>Links that differ as the frame: %1</source>
        <translation>Als Gestell verschiedene Glieder: %1</translation>
    </message>
    <message>
        <source>There are more than %1 sets of inputs to try; they are not listed.</source>
        <translation>Es wären mehr als %1 Sätze von Antrieben zu prüfen; sie werden nicht gelistet.</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>Radsatz %1</translation>
    </message>
    <message>
        <source>sets %1</source>
        <translation>Radsätze %1</translation>
    </message>
    <message>
        <source>No lever: the train is not finished. Problems tells what is missing.</source>
        <translation>Kein Hebel: Das Getriebe ist nicht fertig. Probleme sagt, was fehlt.</translation>
    </message>
    <message>
        <source>No lever: no mesh joins two links on the ground&apos;s axis.</source>
        <translation>Kein Hebel: Kein Zahneingriff verbindet zwei Glieder auf der Achse des Gestells.</translation>
    </message>
    <message>
        <source>No lever: no link on the ground&apos;s axis can turn.</source>
        <translation>Kein Hebel: Kein Glied auf der Achse des Gestells kann sich drehen.</translation>
    </message>
    <message>
        <source>No lever: mesh %1 leads to an axis of another direction. Bevel pinions have no place on a lever, and their side gears are not joined to another link on the ground&apos;s axis.</source>
        <translation>Kein Hebel: Zahneingriff %1 führt zu einer Achse anderer Richtung. Kegelritzel haben keinen Platz auf einem Hebel, und ihre Achswellenräder sind mit keinem weiteren Glied auf der Achse des Gestells verbunden.</translation>
    </message>
    <message>
        <source>No lever: the train has more links and freedoms than levers are drawn for.</source>
        <translation>Kein Hebel: Das Getriebe hat mehr Glieder und Freiheiten, als Hebel gezeichnet werden.</translation>
    </message>
    <message>
        <source>dashed: by these tooth counts only</source>
        <translation>gestrichelt: nur bei diesen Zähnezahlen</translation>
    </message>
    <message>
        <source>Links %1 turn as one.</source>
        <translation>Glieder %1 drehen sich wie eines.</translation>
    </message>
    <message>
        <source>Arrows: speeds in rad/s.</source>
        <translation>Pfeile: Drehzahlen in rad/s.</translation>
    </message>
    <message>
        <source>Arrows to the right of the bars: speeds in rad/s; to the left: torques on the lever in N m.</source>
        <translation>Pfeile rechts der Balken: Drehzahlen in rad/s; links: Momente auf den Hebel in N m.</translation>
    </message>
    <message>
        <source>No states yet: a state engages brakes and clutches and names its drive.</source>
        <translation>Noch keine Zustände: Ein Zustand schließt Bremsen und Kupplungen und nennt seinen Antrieb.</translation>
    </message>
    <message>
        <source>No state has one motion: each is locked or free.</source>
        <translation>Kein Zustand hat eine Bewegung: Jeder ist gesperrt oder frei.</translation>
    </message>
    <message>
        <source>The plan shows two freedoms; the links on the ground&apos;s axis have %1.</source>
        <translation>Der Plan zeigt zwei Freiheiten; die Glieder auf der Achse des Gestells haben %1.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>no set</source>
        <translation>kein Radsatz</translation>
    </message>
    <message>
        <source>%1: 1 lever, freedom %2</source>
        <translation>%1: 1 Hebel, Freiheitsgrad %2</translation>
    </message>
    <message>
        <source>%1: %2 levers, freedom %3</source>
        <translation>%1: %2 Hebel, Freiheitsgrad %3</translation>
    </message>
    <message>
        <source>* there by these tooth counts only</source>
        <translation>* dort nur bei diesen Zähnezahlen</translation>
    </message>
    <message>
        <source>the levers</source>
        <translation>die Hebel</translation>
    </message>
    <message>
        <source>The levers of a train: where the links of the ground&apos;s axis have their points.</source>
        <translation>Die Hebel eines Getriebes: wo die Glieder der Gestellachse ihre Punkte haben.</translation>
    </message>
    <message>
        <source>modules</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>gears</source>
        <translation>Räder</translation>
    </message>
    <message>
        <source>GLB, in motion</source>
        <translation>GLB, in Bewegung</translation>
    </message>
    <message>
        <source>Assembly: gears with their poses</source>
        <translation>Zusammenbau: Räder mit ihren Lagen</translation>
    </message>
    <message>
        <source>gears for a check</source>
        <translation>Räder für eine Prüfung</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Checks of teeth</source>
        <translation>Prüfung der Zähne</translation>
    </message>
    <message>
        <source>a model of the joints</source>
        <translation>ein Modell der Gelenke</translation>
    </message>
    <message>
        <source>Models of the joints</source>
        <translation>Modelle der Gelenke</translation>
    </message>
    <message>
        <source>the worked derivation</source>
        <translation>die ausgearbeitete Herleitung</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>Herleitungen</translation>
    </message>
    <message>
        <source>derivations</source>
        <translation>Herleitungen</translation>
    </message>
    <message>
        <source>No power flows, or what there is of loads and motion does not determine it.</source>
        <translation>Es fließt keine Leistung, oder Lasten und Bewegung bestimmen sie nicht.</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree.</source>
        <translation>Die Drehgelenke sind kein Spannbaum.</translation>
    </message>
    <message>
        <source>The mechanism has errors.</source>
        <translation>Der Mechanismus hat Fehler.</translation>
    </message>
    <message>
        <source>There is no solution, because nothing can move or inputs are missing.</source>
        <translation>Es gibt keine Lösung, weil sich nichts bewegen kann oder Antriebe fehlen.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree, or a mesh has no carrier.</source>
        <translation>Die Drehgelenke sind kein Spannbaum, oder ein Zahneingriff hat keinen Steg.</translation>
    </message>
    <message>
        <source>a graph</source>
        <translation>ein Graph</translation>
    </message>
    <message>
        <source>Graphs</source>
        <translation>Graphen</translation>
    </message>
    <message>
        <source>graphs</source>
        <translation>Graphen</translation>
    </message>
    <message>
        <source>The mechanism has no such table.</source>
        <translation>Der Mechanismus hat keine solche Tabelle.</translation>
    </message>
    <message>
        <source>matrices</source>
        <translation>Matrizen</translation>
    </message>
    <message>
        <source>CSV, one matrix or table</source>
        <translation>CSV, eine Matrix oder Tabelle</translation>
    </message>
    <message>
        <source>CSV, all matrices and tables</source>
        <translation>CSV, alle Matrizen und Tabellen</translation>
    </message>
    <message>
        <source>Handouts</source>
        <translation>Handouts</translation>
    </message>
    <message>
        <source>Simulators</source>
        <translation>Simulatoren</translation>
    </message>
    <message>
        <source>%1 with --view</source>
        <translation>%1 mit --view</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Without labels</source>
        <translation>Ohne Beschriftungen</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>With exercises</source>
        <translation>Mit Übungen</translation>
    </message>
    <message>
        <source>This variant</source>
        <translation>Diese Variante</translation>
    </message>
    <message>
        <source>Power seen from</source>
        <translation>Leistung gesehen von</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Gesehen von</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Hidden links</source>
        <translation>Ausgeblendete Glieder</translation>
    </message>
    <message>
        <source>Reference frame fixed to</source>
        <translation>Bezugssystem fest an</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Only the gear</source>
        <translation>Nur das Rad</translation>
    </message>
    <message>
        <source>Only the link</source>
        <translation>Nur das Glied</translation>
    </message>
    <message>
        <source>A period plays</source>
        <translation>Eine Periode dauert</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Inertia of the rotors</source>
        <translation>Trägheit der Rotoren</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>The format cannot hold the mechanism: a joint depends on several inputs, a link is too light, or the unit of length is not known.</source>
        <translation>Das Format kann den Mechanismus nicht aufnehmen: Ein Gelenk hängt von mehreren Antrieben ab, ein Glied ist zu leicht, oder die Längeneinheit ist nicht bekannt.</translation>
    </message>
    <message>
        <source>a model for simulators</source>
        <translation>ein Modell für Simulatoren</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>an animation</source>
        <translation>eine Animation</translation>
    </message>
    <message>
        <source>PNG, a picture of the train</source>
        <translation>PNG, ein Bild des Getriebes</translation>
    </message>
    <message>
        <source>PNG, once round the train</source>
        <translation>PNG, einmal um das Getriebe</translation>
    </message>
    <message>
        <source>PNG, one period of the motion</source>
        <translation>PNG, eine Periode der Bewegung</translation>
    </message>
    <message>
        <source>PNG, once round the train, a file for each picture</source>
        <translation>PNG, einmal um das Getriebe, eine Datei je Bild</translation>
    </message>
    <message>
        <source>PNG, one period of the motion, a file for each picture</source>
        <translation>PNG, eine Periode der Bewegung, eine Datei je Bild</translation>
    </message>
    <message>
        <source>GLB, the train as seen</source>
        <translation>GLB, das Getriebe, wie man es sieht</translation>
    </message>
    <message>
        <source>3D pictures</source>
        <translation>3D-Bilder</translation>
    </message>
    <message>
        <source>Animations</source>
        <translation>Animationen</translation>
    </message>
    <message>
        <source>animations</source>
        <translation>Animationen</translation>
    </message>
    <message>
        <source>The train as seen</source>
        <translation>Das Getriebe, wie man es sieht</translation>
    </message>
    <message>
        <source>Handout, a web page</source>
        <translation>Handout, eine Webseite</translation>
    </message>
    <message>
        <source>a page for browsers, with inputs to move</source>
        <translation>eine Seite für Browser mit Antrieben zum Bewegen</translation>
    </message>
    <message>
        <source>Handout for learning platforms (SCORM 1.2)</source>
        <translation>Handout für Lernplattformen (SCORM 1.2)</translation>
    </message>
    <message>
        <source>that page as a package for learning platforms (SCORM 1.2)</source>
        <translation>diese Seite als Paket für Lernplattformen (SCORM 1.2)</translation>
    </message>
    <message>
        <source>handouts</source>
        <translation>Handouts</translation>
    </message>
    <message>
        <source>The mechanism, or what would be written, is too large.</source>
        <translation>Der Mechanismus, oder was geschrieben würde, ist zu groß.</translation>
    </message>
    <message>
        <source>Gears cannot be made.</source>
        <translation>Räder können nicht erzeugt werden.</translation>
    </message>
    <message>
        <source>Nothing can paint pictures here, or a picture is too large to be painted.</source>
        <translation>Hier kann nichts Bilder malen, oder ein Bild ist dafür zu groß.</translation>
    </message>
    <message>
        <source>--to is one of %1.</source>
        <translation>--to ist eines von %1.</translation>
    </message>
    <message>
        <source>Export into the new folder</source>
        <translation>In den neuen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Exporting %1: %2 %.</source>
        <translation>%1 wird exportiert: %2 %.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>This format has no options.</source>
        <translation>Dieses Format hat keine Optionen.</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Wie üblich</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>This is no certificate of teeth.</source>
        <translation>Dies ist kein Zertifikat über Zähne.</translation>
    </message>
    <message>
        <source>The certificate is newer than this program.</source>
        <translation>Das Zertifikat ist neuer als dieses Programm.</translation>
    </message>
    <message>
        <source>%1 is not what a certificate has there.</source>
        <translation>%1 ist nicht, was ein Zertifikat an dieser Stelle hat.</translation>
    </message>
    <message>
        <source>The mark is not that of the problem: it was changed.</source>
        <translation>Die Kennung ist nicht die der Aufgabe: sie wurde geändert.</translation>
    </message>
    <message>
        <source>The wheels are not those of the meshes.</source>
        <translation>Die Räder sind nicht die der Zahneingriffe.</translation>
    </message>
    <message>
        <source>Ratio %1 is not that of the mechanism.</source>
        <translation>Übersetzung %1 ist nicht die des Getriebes.</translation>
    </message>
    <message>
        <source>The counts are %1 choices and %2 within the bounds, not %3 and %4.</source>
        <translation>Es sind %1 Möglichkeiten und %2 davon in den Grenzen, nicht %3 und %4.</translation>
    </message>
    <message>
        <source>The counts of the branches are not those of the choices.</source>
        <translation>Die Anzahlen der Zweige sind nicht die der Möglichkeiten.</translation>
    </message>
    <message>
        <source>Choices are listed that there are not.</source>
        <translation>Es sind Möglichkeiten aufgeführt, die es nicht gibt.</translation>
    </message>
    <message>
        <source>Choice %1 is not the one that follows.</source>
        <translation>Möglichkeit %1 ist nicht die, die an der Reihe ist.</translation>
    </message>
    <message>
        <source>a ratio other than 0: a number, or a string like &quot;9/2&quot; or &quot;0.632&quot;</source>
        <translation>eine Übersetzung außer 0: eine Zahl oder eine Zeichenkette wie &quot;9/2&quot; oder &quot;0.632&quot;</translation>
    </message>
    <message>
        <source>There are no teeth from %1 to %2.</source>
        <translation>Von %1 bis %2 gibt es keine Zähnezahl.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or &quot;%2&quot;</source>
        <translation>„%1“ oder „%2“</translation>
    </message>
    <message>
        <source>There is no member &quot;%1&quot; in a wish.</source>
        <translation>Ein Wunsch hat kein Element „%1“.</translation>
    </message>
    <message>
        <source>a list of ratios</source>
        <translation>eine Liste von Übersetzungen</translation>
    </message>
    <message>
        <source>a list of 1 to %1 ratios</source>
        <translation>eine Liste von 1 bis %1 Übersetzungen</translation>
    </message>
    <message>
        <source>Drive and driven are one link.</source>
        <translation>Antrieb und Abtrieb sind ein und dasselbe Glied.</translation>
    </message>
    <message>
        <source>Link %1 is held, so that it has no ratio.</source>
        <translation>Glied %1 wird gehalten und hat deshalb keine Übersetzung.</translation>
    </message>
    <message>
        <source>the name of a state</source>
        <translation>der Name eines Schaltzustands</translation>
    </message>
    <message>
        <source>A ratio is wanted in a state or with links held, not in both.</source>
        <translation>Eine Übersetzung ist in einem Schaltzustand oder mit gehaltenen Gliedern gewünscht, nicht beides.</translation>
    </message>
    <message>
        <source>no ratio beside an interval</source>
        <translation>keine Übersetzung neben einem Intervall</translation>
    </message>
    <message>
        <source>With the ratio 0 the drive would stand still while link %1 turns.</source>
        <translation>Mit der Übersetzung 0 stünde der Antrieb still, während sich Glied %1 dreht.</translation>
    </message>
    <message>
        <source>two ratios of one sign, the smaller first</source>
        <translation>zwei Übersetzungen gleichen Vorzeichens, die kleinere zuerst</translation>
    </message>
    <message>
        <source>Without &quot;wheels&quot; there is none that could be used once.</source>
        <translation>Ohne „wheels“ gibt es kein Rad, das einmal verwendet werden könnte.</translation>
    </message>
    <message>
        <source>a list of 1 to %1 numbers of teeth from 1 to %2</source>
        <translation>eine Liste von 1 bis %1 Zähnezahlen von 1 bis %2</translation>
    </message>
    <message>
        <source>There is no wheel &quot;%1&quot;: wheels are named like 15:tail.</source>
        <translation>Ein Rad „%1“ gibt es nicht: Räder heißen wie 15:tail.</translation>
    </message>
    <message>
        <source>no efficiency of a set beside that of a mesh</source>
        <translation>kein Wirkungsgrad eines Satzes neben dem eines Eingriffs</translation>
    </message>
    <message>
        <source>a relative tolerance from 0 to below 1</source>
        <translation>eine relative Toleranz von 0 bis unter 1</translation>
    </message>
    <message>
        <source>an efficiency above 0 and at most 1</source>
        <translation>ein Wirkungsgrad über 0 und höchstens 1</translation>
    </message>
    <message>
        <source>There are no gears whose teeth could be chosen.</source>
        <translation>Es gibt keine Zahnräder, deren Zähne gewählt werden könnten.</translation>
    </message>
    <message>
        <source>The speeds of links %1 and %2 have no ratio that the teeth determine.</source>
        <translation>Die Drehzahlen der Glieder %1 und %2 haben kein Verhältnis, das die Zähne bestimmen.</translation>
    </message>
    <message>
        <source>The ratio depends on %1 gear pairs: teeth are looked for in trains of at most %2.</source>
        <translation>Die Übersetzung hängt von %1 Radpaaren ab: Zähne werden in Getrieben mit höchstens %2 gesucht.</translation>
    </message>
    <message>
        <source>Not all choices were tried, so that there is nothing to certify.</source>
        <translation>Nicht alle Möglichkeiten wurden geprüft, deshalb gibt es nichts zu bescheinigen.</translation>
    </message>
    <message>
        <source>A wish with a least efficiency has no certificate.</source>
        <translation>Für einen Wunsch mit einem Mindestwirkungsgrad gibt es kein Zertifikat.</translation>
    </message>
    <message>
        <source>A train that locks with other teeth has no certificate.</source>
        <translation>Für ein Getriebe, das mit anderen Zähnen sperrt, gibt es kein Zertifikat.</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <source>planets</source>
        <translation>Planeten</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>Unterschnitt</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen sich</translation>
    </message>
    <message>
        <source>with planets that clear each other</source>
        <translation>mit Planeten, die aneinander vorbeikommen</translation>
    </message>
    <message>
        <source>with equal planets that go in</source>
        <translation>mit gleichen Planeten, die sich einbauen lassen</translation>
    </message>
    <message>
        <source>with hunting teeth only</source>
        <translation>nur mit wechselnden Zahnpaarungen</translation>
    </message>
    <message>
        <source>without undercut</source>
        <translation>ohne Unterschnitt</translation>
    </message>
    <message>
        <source>within the bounds</source>
        <translation>in den Grenzen</translation>
    </message>
    <message>
        <source>All %1 choices were tried.</source>
        <translation>Alle %1 Möglichkeiten wurden geprüft.</translation>
    </message>
    <message>
        <source>meet the wish</source>
        <translation>erfüllen den Wunsch</translation>
    </message>
    <message>
        <source>None. The nearest</source>
        <translation>Keine. Am nächsten</translation>
    </message>
    <message>
        <source>Choices, the best first</source>
        <translation>Möglichkeiten, die beste zuerst</translation>
    </message>
    <message>
        <source>The certificate holds: %1 choices were tried again, %2 are within the bounds.</source>
        <translation>Das Zertifikat stimmt: %1 Möglichkeiten wurden noch einmal geprüft, %2 liegen in den Grenzen.</translation>
    </message>
    <message>
        <source>The certificate does not hold.</source>
        <translation>Das Zertifikat stimmt nicht.</translation>
    </message>
    <message>
        <source>A certificate is checked by itself, without a mechanism and a wish.</source>
        <translation>Ein Zertifikat wird für sich geprüft, ohne Getriebe und Wunsch.</translation>
    </message>
    <message>
        <source>A mechanism and a file with a wish are needed.</source>
        <translation>Ein Getriebe und eine Datei mit einem Wunsch sind nötig.</translation>
    </message>
    <message>
        <source>inner planet %1</source>
        <translation>inneres Planetenrad %1</translation>
    </message>
    <message>
        <source>outer planet %1</source>
        <translation>äußeres Planetenrad %1</translation>
    </message>
    <message>
        <source>Found by the gearbox designer. Ratios: %1. One planet or pair of each set is drawn; numbers that go in: %2.</source>
        <translation>Vom Getriebeentwurf gefunden. Übersetzungen: %1. Von jedem Satz ist ein Planetenrad oder Paar gezeichnet; montierbare Anzahlen: %2.</translation>
    </message>
    <message>
        <source>One mesh of each set has the whole basic efficiency of the set, the others lose nothing.</source>
        <translation>Ein Eingriff jedes Satzes hat den ganzen Grundwirkungsgrad des Satzes, die anderen verlieren nichts.</translation>
    </message>
    <message>
        <source>It is of another version of the search.</source>
        <translation>Sie stammt von einer anderen Fassung der Suche.</translation>
    </message>
    <message>
        <source>Line %1 is none of a finished part of a gearbox search.</source>
        <translation>Zeile %1 gehört nicht zu einem fertigen Teil einer Getriebesuche.</translation>
    </message>
    <message>
        <source>The file ends early: its gearboxes are fewer than its first line says.</source>
        <translation>Die Datei endet zu früh: Sie hat weniger Getriebe, als ihre erste Zeile sagt.</translation>
    </message>
    <message>
        <source>These are parts of searches for different wishes.</source>
        <translation>Das sind Teile von Suchen nach verschiedenen Wünschen.</translation>
    </message>
    <message>
        <source>These are parts of %1 and of %2: a search is parted once.</source>
        <translation>Das sind Teile von %1 und von %2: Eine Suche wird nur einmal geteilt.</translation>
    </message>
    <message>
        <source>Part %1 is in two files that hold further parts: merge single parts.</source>
        <translation>Teil %1 ist in zwei Dateien, die noch andere Teile enthalten: Einzelne Teile zusammenführen.</translation>
    </message>
    <message>
        <source>It is of another wish, another part or another version of the search.</source>
        <translation>Sie gehört zu einem anderen Wunsch, einem anderen Teil oder einer anderen Fassung der Suche.</translation>
    </message>
    <message>
        <source>It holds a line that is none of this search.</source>
        <translation>Sie enthält eine Zeile, die nicht zu dieser Suche gehört.</translation>
    </message>
    <message>
        <source>an object of wheels with their teeth, {&quot;1.ring&quot;: 72}</source>
        <translation>ein Objekt aus Rädern mit ihren Zähnezahlen, {&quot;1.ring&quot;: 72}</translation>
    </message>
    <message>
        <source>there is no wheel &quot;%1&quot;; wheels are named like &quot;1.ring&quot;, &quot;2.sun1&quot;, &quot;2.planet1&quot;.</source>
        <translation>es gibt kein Rad &quot;%1&quot;; Räder heißen wie &quot;1.ring&quot;, &quot;2.sun1&quot;, &quot;2.planet1&quot;.</translation>
    </message>
    <message>
        <source>a list of gears with ratios, {&quot;gear&quot;: 4, &quot;ratio&quot;: &quot;0.98884&quot;}</source>
        <translation>eine Liste von Gängen mit Übersetzungen, {&quot;gear&quot;: 4, &quot;ratio&quot;: &quot;0.98884&quot;}</translation>
    </message>
    <message>
        <source>a ratio in a string</source>
        <translation>eine Übersetzung als Zeichenkette</translation>
    </message>
    <message>
        <source>only sets in series are searched.</source>
        <translation>es werden nur hintereinandergeschaltete Sätze durchsucht.</translation>
    </message>
    <message>
        <source>only sets of which one sun is held at a time are searched.</source>
        <translation>es werden nur Sätze durchsucht, von denen je ein Sonnenrad festgehalten wird.</translation>
    </message>
    <message>
        <source>a ratio above 0 in a string: a decimal like &quot;2.34&quot; or a fraction like &quot;7/3&quot;</source>
        <translation>eine Übersetzung über 0 als Zeichenkette: eine Dezimalzahl wie &quot;2.34&quot; oder ein Bruch wie &quot;7/3&quot;</translation>
    </message>
    <message>
        <source>a list of two whole numbers from %1 to %2, the smaller one first</source>
        <translation>eine Liste von zwei ganzen Zahlen von %1 bis %2, die kleinere zuerst</translation>
    </message>
    <message>
        <source>a number from 0 to below 1, the part of each ratio</source>
        <translation>eine Zahl von 0 bis unter 1, der Anteil jeder Übersetzung</translation>
    </message>
    <message>
        <source>a list of 1 to %1 ratios in strings, each above 0</source>
        <translation>eine Liste von 1 bis %1 Übersetzungen als Zeichenketten, jede über 0</translation>
    </message>
    <message>
        <source>a wish has no member &quot;%1&quot;.</source>
        <translation>ein Wunsch hat keinen Eintrag &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>a list of 1 to 4 sets, &quot;simple&quot;, &quot;double&quot; or &quot;ravigneaux&quot;, which counts twice</source>
        <translation>eine Liste von 1 bis 4 Sätzen, &quot;simple&quot;, &quot;double&quot; oder &quot;ravigneaux&quot;, der doppelt zählt</translation>
    </message>
    <message>
        <source>a list of two numbers above 1 and at most 10, the smaller one first</source>
        <translation>eine Liste von zwei Zahlen über 1 und höchstens 10, die kleinere zuerst</translation>
    </message>
    <message>
        <source>an efficiency above 0, at most 1</source>
        <translation>ein Wirkungsgrad über 0, höchstens 1</translation>
    </message>
    <message>
        <source>one of &quot;mesh&quot; and &quot;set&quot; is needed, not both.</source>
        <translation>eines von &quot;mesh&quot; und &quot;set&quot; wird gebraucht, nicht beide.</translation>
    </message>
    <message>
        <source>Shafts would have to cross each other.</source>
        <translation>Wellen müssten einander kreuzen.</translation>
    </message>
    <message>
        <source>A brake cannot reach the housing: other links enclose its link.</source>
        <translation>Eine Bremse kommt nicht an das Gehäuse: Andere Glieder schließen ihr Glied ein.</translation>
    </message>
    <message>
        <source>A clutch cannot reach both of its links without crossing others.</source>
        <translation>Eine Kupplung kommt nicht an ihre beiden Glieder, ohne andere zu kreuzen.</translation>
    </message>
    <message>
        <source>Input and output cannot come out at the two ends.</source>
        <translation>Antrieb und Abtrieb kommen nicht an den beiden Enden heraus.</translation>
    </message>
    <message>
        <source>No. %1: %2 elements, largest error %3</source>
        <translation>Nr. %1: %2 Schaltelemente, größter Fehler %3</translation>
    </message>
    <message>
        <source>Teeth, sun planet ring: %1</source>
        <translation>Zähne, Sonne Planet Hohlrad: %1</translation>
    </message>
    <message>
        <source>Largest over that of the input: power through a member %1, torque of an element %2, slip of an open element %3, speed of a link %4</source>
        <translation>Größtes Verhältnis zum Antrieb: Leistung durch ein Teil %1, Moment eines Schaltelements %2, Schlupf eines offenen Schaltelements %3, Drehzahl eines Glieds %4</translation>
    </message>
    <message>
        <source>Its section can be drawn without crossing shafts.</source>
        <translation>Sein Schnitt lässt sich ohne kreuzende Wellen zeichnen.</translation>
    </message>
    <message>
        <source>%1 layouts, %2 found</source>
        <translation>%1 Anordnungen, %2 gefunden</translation>
    </message>
    <message>
        <source>Complete: these elements have fewer states than gears are wanted, or no layout has so many links.</source>
        <translation>Vollständig: Diese Schaltelemente haben weniger Zustände, als Gänge gewünscht sind, oder keine Anordnung hat so viele Glieder.</translation>
    </message>
    <message>
        <source>All layouts were searched, but ring ratios at %1 only: sampled, not a proof.</source>
        <translation>Alle Anordnungen wurden durchsucht, aber Standübersetzungen nur an %1: Stichprobe, kein Beweis.</translation>
    </message>
    <message>
        <source>%1 values for each set</source>
        <translation>%1 Werten für jeden Satz</translation>
    </message>
    <message>
        <source>the search</source>
        <translation>die Suche</translation>
    </message>
    <message>
        <source>how many choices are given, the best first (20)</source>
        <translation>wie viele Möglichkeiten angegeben werden, die beste zuerst (20)</translation>
    </message>
    <message>
        <source>write what proves that all choices were tried</source>
        <translation>schreiben, was beweist, dass alle Möglichkeiten geprüft wurden</translation>
    </message>
    <message>
        <source>check such a proof, with code of its own</source>
        <translation>einen solchen Beweis mit eigenem Programmteil prüfen</translation>
    </message>
    <message>
        <source>merge needs the files of parts.</source>
        <translation>merge braucht die Dateien von Teilen.</translation>
    </message>
    <message>
        <source>%1 has no meaning for gearbox merge.</source>
        <translation>%1 hat für gearbox merge keine Bedeutung.</translation>
    </message>
    <message>
        <source>One wish is needed.</source>
        <translation>Ein Wunsch wird gebraucht.</translation>
    </message>
    <message>
        <source>--parts is for gearbox merge.</source>
        <translation>--parts ist für gearbox merge.</translation>
    </message>
    <message>
        <source>--shard is R/N, the part R of N, counted from 0, not &quot;%1&quot;.</source>
        <translation>--shard ist R/N, der Teil R von N, ab 0 gezählt, nicht &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>--shard needs a file: -o FILE.</source>
        <translation>--shard braucht eine Datei: -o FILE.</translation>
    </message>
    <message>
        <source>--resume needs --shard.</source>
        <translation>--resume braucht --shard.</translation>
    </message>
    <message>
        <source>how many gearboxes are shown and written (20)</source>
        <translation>wie viele Getriebe gezeigt und geschrieben werden (20)</translation>
    </message>
    <message>
        <source>how many layouts are searched at once (all processors but one)</source>
        <translation>wie viele Anordnungen zugleich durchsucht werden (alle Prozessoren bis auf einen)</translation>
    </message>
    <message>
        <source>a folder for the documents; with --shard the file of the part</source>
        <translation>ein Ordner für die Dokumente; mit --shard die Datei des Teils</translation>
    </message>
    <message>
        <source>searches the part R of N only, counted from 0, into a file</source>
        <translation>durchsucht nur den Teil R von N, ab 0 gezählt, in eine Datei</translation>
    </message>
    <message>
        <source>On many machines</source>
        <translation>Auf vielen Rechnern</translation>
    </message>
    <message>
        <source>goes on where the part was stopped; nothing if it is finished</source>
        <translation>macht weiter, wo der Teil aufgehört hat; nichts, wenn er fertig ist</translation>
    </message>
    <message>
        <source>merge: writes the merged parts, of which some may be missing</source>
        <translation>merge: schreibt die zusammengeführten Teile, von denen welche fehlen dürfen</translation>
    </message>
    <message>
        <source>Gearboxes from planetary sets, brakes and clutches with wanted ratios.</source>
        <translation>Getriebe aus Planetensätzen, Bremsen und Kupplungen mit gewünschten Übersetzungen.</translation>
    </message>
    <message>
        <source>%1 of %2 layouts, %3 found</source>
        <translation>%1 von %2 Anordnungen, %3 gefunden</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>%1 of %2 parts are missing, the first is %3/%2.</source>
        <translation>%1 von %2 Teilen fehlen, der erste ist %3/%2.</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>sun on planet, ring of each set</source>
        <translation>Sonne auf Planet, Hohlrad jedes Satzes</translation>
    </message>
    <message>
        <source>ratios</source>
        <translation>Übersetzungen</translation>
    </message>
    <message>
        <source>Count %1. By the number of teeth there remain %2.</source>
        <translation>%1 zählen. Nach der Zähnezahl bleiben %2.</translation>
    </message>
    <message>
        <source>Turn the input %1 times in %2. By the degrees of the output there remain %3.</source>
        <translation>Den Antrieb in %2 %1-mal drehen. Nach den Graden des Abtriebs bleiben %3.</translation>
    </message>
    <message>
        <source>%1 candidates of %2 tooth sets with these ratios. All tooth sets of the structures with the fewest suns were tried.</source>
        <translation>%1 Kandidaten von %2 Zähnezahlsätzen mit diesen Übersetzungen. Alle Zähnezahlen der Aufbauten mit den wenigsten Sonnenrädern wurden geprüft.</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>No equal planets at equal distances can be assembled</source>
        <translation>Gleiche Planeten in gleichen Abständen lassen sich nicht montieren</translation>
    </message>
    <message>
        <source>All candidates share: %1.</source>
        <translation>Allen Kandidaten gemeinsam: %1.</translation>
    </message>
    <message>
        <source>Candidates %1 have the same ratios: no turning tells them apart.</source>
        <translation>Die Kandidaten %1 haben gleiche Übersetzungen: Durch Drehen lassen sie sich nicht unterscheiden.</translation>
    </message>
    <message>
        <source>how many candidates are shown (20)</source>
        <translation>wie viele Kandidaten gezeigt werden (20)</translation>
    </message>
    <message>
        <source>The planetary sets that may be inside a hub gear with these ratios.</source>
        <translation>Die Planetensätze, die in einer Nabenschaltung mit diesen Übersetzungen stecken können.</translation>
    </message>
    <message>
        <source>Gearbox designer</source>
        <translation>Getriebeentwurf</translation>
    </message>
    <message>
        <source>Searches for planetary sets, brakes and clutches that have the ratios you want.</source>
        <translation>Sucht Planetensätze, Bremsen und Kupplungen mit den gewünschten Übersetzungen.</translation>
    </message>
    <message>
        <source>The list is of the earlier wish until you search again.</source>
        <translation>Die Liste gehört zum früheren Wunsch, bis neu gesucht wird.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Keeps what was found (Esc)</source>
        <translation>Behält, was gefunden wurde (Esc)</translation>
    </message>
    <message>
        <source>Gearboxes with the ratios you want</source>
        <translation>Getriebe mit den gewünschten Übersetzungen</translation>
    </message>
    <message>
        <source>Gears: %1, sets: %2</source>
        <translation>Gänge: %1, Sätze: %2</translation>
    </message>
    <message>
        <source>Gears: %1 and reverse, sets: %2</source>
        <translation>Gänge: %1 und Rückwärtsgang, Sätze: %2</translation>
    </message>
    <message>
        <source>Listing layouts…</source>
        <translation>Anordnungen werden aufgezählt…</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Paused at %1 of %2 layouts, %3 found</source>
        <translation>Angehalten bei %1 von %2 Anordnungen, %3 gefunden</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>sampled, not a proof</source>
        <translation>Stichproben, kein Beweis</translation>
    </message>
    <message>
        <source>No layout has so many links.</source>
        <translation>Keine Anordnung hat so viele Glieder.</translation>
    </message>
    <message>
        <source>Every layout is searched, but the ratio of ring to sun at %1 values of each set only, from which the nearest whole teeth are taken.</source>
        <translation>Jede Anordnung wird durchsucht, das Verhältnis von Hohlrad zu Sonne aber nur bei %1 Werten je Satz, von denen aus die nächsten ganzen Zähnezahlen genommen werden.</translation>
    </message>
    <message>
        <source>Every layout is searched, but the ratios of ring to sun at %1 points only, from which the nearest whole teeth are taken.</source>
        <translation>Jede Anordnung wird durchsucht, die Verhältnisse von Hohlrad zu Sonne aber nur an %1 Punkten, von denen aus die nächsten ganzen Zähnezahlen genommen werden.</translation>
    </message>
    <message>
        <source>Type ratios and choose Search.&lt;br&gt;Six ratios are enough: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</source>
        <translation>Übersetzungen eingeben und Suchen wählen.&lt;br&gt;Sechs Übersetzungen genügen: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</translation>
    </message>
    <message>
        <source>None: no layout of these sets has so many links.</source>
        <translation>Keines: Keine Anordnung dieser Sätze hat so viele Glieder.</translation>
    </message>
    <message>
        <source>Nothing yet.</source>
        <translation>Noch nichts.</translation>
    </message>
    <message>
        <source>Shift table of the chosen gearbox</source>
        <translation>Schaltschema des gewählten Getriebes</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>gewünscht</translation>
    </message>
    <message>
        <source>The largest circulating power, as a part of the power at the input</source>
        <translation>Die größte Blindleistung, als Teil der Leistung am Antrieb</translation>
    </message>
    <message>
        <source>Opens this gearbox as a document with its states, in a new window</source>
        <translation>Öffnet dieses Getriebe als Dokument mit seinen Schaltzuständen in einem neuen Fenster</translation>
    </message>
    <message>
        <source>Open No. %1</source>
        <translation>Nr. %1 öffnen</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>Choose a gearbox of the list.</source>
        <translation>Ein Getriebe der Liste wählen.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Which brakes and clutches each gear engages</source>
        <translation>Welche Bremsen und Kupplungen jeder Gang schließt</translation>
    </message>
    <message>
        <source>The largest difference from a wanted ratio, relative to it</source>
        <translation>Die größte Abweichung von einer gewünschten Übersetzung, bezogen auf diese</translation>
    </message>
    <message>
        <source>The least efficiency of a gear; the wish gives that of a mesh</source>
        <translation>Der kleinste Wirkungsgrad eines Gangs; der Wunsch gibt den eines Zahneingriffs an</translation>
    </message>
    <message>
        <source>Can its section be drawn without shafts that cross?</source>
        <translation>Lässt sich sein Schnitt ohne kreuzende Wellen zeichnen?</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>worst η</source>
        <translation>kleinstes η</translation>
    </message>
    <message>
        <source>buildable</source>
        <translation>baubar</translation>
    </message>
    <message>
        <source>Gearboxes that were found</source>
        <translation>Gefundene Getriebe</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Übersetzungen</translation>
    </message>
    <message>
        <source>Wanted ratios</source>
        <translation>Gewünschte Übersetzungen</translation>
    </message>
    <message>
        <source>4.17 2.34 1.52 …</source>
        <translation>4,17 2,34 1,52 …</translation>
    </message>
    <message>
        <source>Input over output of each gear, first gear first: decimals or fractions, typed or pasted</source>
        <translation>Antrieb zu Abtrieb jedes Gangs, der erste zuerst: Dezimalzahlen oder Brüche, getippt oder eingefügt</translation>
    </message>
    <message>
        <source>any ratio</source>
        <translation>beliebige Übersetzung</translation>
    </message>
    <message>
        <source>this ratio</source>
        <translation>diese Übersetzung</translation>
    </message>
    <message>
        <source>no reverse</source>
        <translation>kein Rückwärtsgang</translation>
    </message>
    <message>
        <source>Wanted ratio of the reverse</source>
        <translation>Gewünschte Übersetzung des Rückwärtsgangs</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>By how many percent a ratio may differ; empty: ratios are rounded as typed</source>
        <translation>Um wie viel Prozent eine Übersetzung abweichen darf; leer: gerundet, wie getippt</translation>
    </message>
    <message>
        <source>Tolerance in percent</source>
        <translation>Toleranz in Prozent</translation>
    </message>
    <message>
        <source>% of every ratio</source>
        <translation>% jeder Übersetzung</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Sätze</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>double planets</source>
        <translation>Doppelplaneten</translation>
    </message>
    <message>
        <source>Ravigneaux</source>
        <translation>Ravigneaux-Sätze</translation>
    </message>
    <message>
        <source>Shafts that can turn, the input shaft too</source>
        <translation>Wellen, die drehen können, mit der Antriebswelle</translation>
    </message>
    <message>
        <source>rotating links</source>
        <translation>drehende Glieder</translation>
    </message>
    <message>
        <source>Members of sets that are part of the housing</source>
        <translation>Teile von Sätzen, die zum Gehäuse gehören</translation>
    </message>
    <message>
        <source>members held</source>
        <translation>feste Teile</translation>
    </message>
    <message>
        <source>input joined by clutches only</source>
        <translation>Antrieb nur über Kupplungen</translation>
    </message>
    <message>
        <source>Also layouts whose input shaft has no member of a set</source>
        <translation>Auch Anordnungen, deren Antriebswelle kein Teil eines Satzes ist</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Schaltelemente</translation>
    </message>
    <message>
        <source>Brakes and clutches together</source>
        <translation>Bremsen und Kupplungen zusammen</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>brakes</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>clutches</source>
        <translation>Kupplungen</translation>
    </message>
    <message>
        <source>Show what the exercises ask for</source>
        <translation>Zeigen, wonach die Aufgaben fragen</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>gezeichnet</translation>
    </message>
    <message>
        <source>%1: pinned, it keeps its teeth</source>
        <translation>%1: fixiert, es behält seine Zähne</translation>
    </message>
    <message>
        <source>%1. Ticked: its teeth may change</source>
        <translation>%1. Angehakt: seine Zähne dürfen sich ändern</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fixiert</translation>
    </message>
    <message>
        <source>Its teeth follow from the others: one distance between two axes</source>
        <translation>Seine Zähne folgen aus den anderen: ein Abstand zwischen zwei Achsen</translation>
    </message>
    <message>
        <source>Whole teeth with which the train has the ratios that you want, all of them.</source>
        <translation>Ganze Zähnezahlen, mit denen das Getriebe die gewünschten Übersetzungen hat, und zwar alle.</translation>
    </message>
    <message>
        <source>The link that drives</source>
        <translation>Das Glied, das antreibt</translation>
    </message>
    <message>
        <source>The link that is driven</source>
        <translation>Das Glied, das angetrieben wird</translation>
    </message>
    <message>
        <source>In which state the ratio is wanted, or which links are held</source>
        <translation>In welchem Schaltzustand die Übersetzung gewünscht ist, oder welche Glieder festgehalten werden</translation>
    </message>
    <message>
        <source>The numbers of the links that are held, such as 2 4</source>
        <translation>Die Nummern der Glieder, die festgehalten werden, etwa 2 4</translation>
    </message>
    <message>
        <source>Speed of the drive over that of the driven link: 64, 9/2 or 0.632</source>
        <translation>Geschwindigkeit des antreibenden durch die des angetriebenen Glieds: 64, 9/2 oder 0,632</translation>
    </message>
    <message>
        <source>How far the ratio may be missed: 0.5 % of it, or by a number such as 0.01. Empty: a decimal is taken as rounded, any other ratio is wanted exactly</source>
        <translation>Wie weit die Übersetzung verfehlt werden darf: um 0,5 % oder um eine Zahl wie 0,01. Leer: eine Dezimalzahl gilt als gerundet, jede andere Übersetzung ist genau gewünscht</translation>
    </message>
    <message>
        <source>Remove this ratio</source>
        <translation>Diese Übersetzung entfernen</translation>
    </message>
    <message>
        <source>such as 2 4</source>
        <translation>etwa 2 4</translation>
    </message>
    <message>
        <source>in state %1</source>
        <translation>im Schaltzustand %1</translation>
    </message>
    <message>
        <source>as engaged now</source>
        <translation>wie jetzt geschlossen</translation>
    </message>
    <message>
        <source>with links held:</source>
        <translation>mit festen Gliedern:</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>%1, meshes with %2</source>
        <translation>%1, kämmt mit %2</translation>
    </message>
    <message>
        <source>+ Ratio</source>
        <translation>+ Übersetzung</translation>
    </message>
    <message>
        <source>Another ratio of the same train: all of them have to be met</source>
        <translation>Noch eine Übersetzung desselben Getriebes: alle müssen erfüllt sein</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Gewünscht</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>Räder</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>The limits as they are at first</source>
        <translation>Die Grenzen wie am Anfang</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>ring : sun</source>
        <translation>Hohlrad : Sonne</translation>
    </message>
    <message>
        <source>teeth from</source>
        <translation>Zähne ab</translation>
    </message>
    <message>
        <source>rings to</source>
        <translation>Hohlräder bis</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>nicht berechnet</translation>
    </message>
    <message>
        <source>Efficiency of a mesh, such as 0.98, from which that of each gear follows</source>
        <translation>Wirkungsgrad eines Zahneingriffs, etwa 0,98, aus dem der jedes Gangs folgt</translation>
    </message>
    <message>
        <source>buildable only</source>
        <translation>nur baubare</translation>
    </message>
    <message>
        <source>Only gearboxes whose section can be drawn without shafts that cross</source>
        <translation>Nur Getriebe, deren Schnitt sich ohne kreuzende Wellen zeichnen lässt</translation>
    </message>
    <message>
        <source>Impossible: %1 gears need as many states; %2 of %3 elements give fewer.</source>
        <translation>Unmöglich: %1 Gänge brauchen ebenso viele Zustände; %2 von %3 Schaltelementen geben weniger.</translation>
    </message>
    <message>
        <source>Gearbox designer…</source>
        <translation>Getriebeentwurf…</translation>
    </message>
    <message>
        <source>Search for planetary sets, brakes and clutches that have the ratios you want</source>
        <translation>Planetensätze, Bremsen und Kupplungen mit den gewünschten Übersetzungen suchen</translation>
    </message>
    <message>
        <source>Fewest teeth of a wheel</source>
        <translation>Wenigste Zähne eines Rads</translation>
    </message>
    <message>
        <source>Most teeth of a gear</source>
        <translation>Meiste Zähne eines außenverzahnten Rads</translation>
    </message>
    <message>
        <source>Most teeth of a ring gear</source>
        <translation>Meiste Zähne eines Hohlrads</translation>
    </message>
    <message>
        <source>Equal planets at equal distances that have to go in and to clear each other</source>
        <translation>Gleiche Planeten in gleichen Abständen, die sich einbauen lassen und einander nicht berühren</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>wie gezeichnet</translation>
    </message>
    <message>
        <source>Whole teeth by which the sums of two pairs between the same axes may differ; a profile shift makes up for it</source>
        <translation>Ganze Zähne, um die sich die Summen zweier Paare zwischen denselben Achsen unterscheiden dürfen; eine Profilverschiebung gleicht es aus</translation>
    </message>
    <message>
        <source>one for all</source>
        <translation>einer für alle</translation>
    </message>
    <message>
        <source>free for each pair</source>
        <translation>frei für jedes Paar</translation>
    </message>
    <message>
        <source>With one module, pairs between the same two axes have one sum of teeth</source>
        <translation>Mit einem Modul haben Paare zwischen denselben zwei Achsen eine Zähnesumme</translation>
    </message>
    <message>
        <source>The only teeth that there are, such as 8 16 24 40; empty: any</source>
        <translation>Die einzigen Zähnezahlen, die es gibt, etwa 8 16 24 40; leer: beliebige</translation>
    </message>
    <message>
        <source>any, or only these: 8 16 24 40</source>
        <translation>beliebig, oder nur: 8 16 24 40</translation>
    </message>
    <message>
        <source>Efficiency of every mesh; empty: as the document states, if it does</source>
        <translation>Wirkungsgrad jedes Zahneingriffs; leer: wie im Dokument, falls es einen nennt</translation>
    </message>
    <message>
        <source>The least efficiency that every ratio must have; empty: any</source>
        <translation>Der kleinste Wirkungsgrad, den jede Übersetzung haben muss; leer: beliebig</translation>
    </message>
    <message>
        <source>each of these once</source>
        <translation>jedes davon einmal</translation>
    </message>
    <message>
        <source>Of the wheels that are listed each is used once at most</source>
        <translation>Von den aufgezählten Rädern wird jedes höchstens einmal verwendet</translation>
    </message>
    <message>
        <source>axes stay where they are</source>
        <translation>Achsen bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Centre distances and modules stay as they are</source>
        <translation>Achsabstände und Module bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>only with hunting teeth</source>
        <translation>nur mit teilerfremden Zähnezahlen</translation>
    </message>
    <message>
        <source>No two teeth meet again before each has met all others</source>
        <translation>Keine zwei Zähne treffen sich wieder, bevor jeder alle anderen getroffen hat</translation>
    </message>
    <message>
        <source>no undercut</source>
        <translation>kein Unterschnitt</translation>
    </message>
    <message>
        <source>No gear has fewer teeth than a rack cuts without undercut and profile shift</source>
        <translation>Kein Rad hat weniger Zähne, als eine Zahnstange ohne Unterschnitt und Profilverschiebung schneidet</translation>
    </message>
    <message>
        <source>Rings to</source>
        <translation>Hohlräder bis</translation>
    </message>
    <message>
        <source>Slack</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>In stock</source>
        <translation>Vorrat</translation>
    </message>
    <message>
        <source>Least η</source>
        <translation>η mindestens</translation>
    </message>
    <message>
        <source>%1 turn</source>
        <translation>%1 drehen sich</translation>
    </message>
    <message>
        <source>%1 with planets that clear each other</source>
        <translation>%1 mit Planeten, die einander nicht berühren</translation>
    </message>
    <message>
        <source>%1 with equal planets that go in</source>
        <translation>%1 mit gleichen Planeten, die sich einbauen lassen</translation>
    </message>
    <message>
        <source>%1 with hunting teeth only</source>
        <translation>%1 nur mit teilerfremden Zähnezahlen</translation>
    </message>
    <message>
        <source>%1 without undercut</source>
        <translation>%1 ohne Unterschnitt</translation>
    </message>
    <message>
        <source>%1 within the tolerance</source>
        <translation>%1 innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Draw a train with gear pairs; then say which ratio it should have, and every choice of whole teeth within your limits is tried.</source>
        <translation>Zeichnen Sie ein Getriebe mit Radpaaren; sagen Sie dann, welche Übersetzung es haben soll, und jede Wahl ganzer Zähnezahlen innerhalb Ihrer Grenzen wird geprüft.</translation>
    </message>
    <message>
        <source>The teeth could not be searched: %1</source>
        <translation>Die Zähnezahlen konnten nicht gesucht werden: %1</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>Wie viel der Suche getan ist</translation>
    </message>
    <message>
        <source>u: undercut; a profile shift mends it</source>
        <translation>u: Unterschnitt; eine Profilverschiebung behebt ihn</translation>
    </message>
    <message>
        <source>Save certificate…</source>
        <translation>Zertifikat sichern…</translation>
    </message>
    <message>
        <source>Copy the table as CSV (Ctrl+C)</source>
        <translation>Die Tabelle als CSV kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Save the table as CSV</source>
        <translation>Die Tabelle als CSV sichern</translation>
    </message>
    <message>
        <source>Use these teeth</source>
        <translation>Diese Zähne verwenden</translation>
    </message>
    <message>
        <source>Choices of teeth</source>
        <translation>Möglichkeiten für Zähnezahlen</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>bisher %1</translation>
    </message>
    <message>
        <source>End the search; what was found stays</source>
        <translation>Die Suche beenden; was gefunden ist, bleibt</translation>
    </message>
    <message>
        <source>The wish cannot be met as it is: see beside its fields.</source>
        <translation>Der Wunsch lässt sich so nicht erfüllen: siehe bei seinen Feldern.</translation>
    </message>
    <message>
        <source>Type the ratio that you want: every choice of whole teeth is tried.</source>
        <translation>Tippen Sie die gewünschte Übersetzung: jede Wahl ganzer Zähnezahlen wird geprüft.</translation>
    </message>
    <message>
        <source>All %1 choices tried: complete</source>
        <translation>Alle %1 Möglichkeiten geprüft: vollständig</translation>
    </message>
    <message>
        <source>Stopped after %1 choices: not complete</source>
        <translation>Nach %1 Möglichkeiten angehalten: nicht vollständig</translation>
    </message>
    <message>
        <source>Search anew</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Search from the beginning</source>
        <translation>Von vorn suchen</translation>
    </message>
    <message>
        <source>%1 meet the wish</source>
        <translation>%1 erfüllen den Wunsch</translation>
    </message>
    <message>
        <source>the best %1 are shown</source>
        <translation>die besten %1 sind zu sehen</translation>
    </message>
    <message>
        <source>%1, off by %2</source>
        <translation>%1, daneben um %2</translation>
    </message>
    <message>
        <source>None. Nearest: %1</source>
        <translation>Keine. Am nächsten: %1</translation>
    </message>
    <message>
        <source>No choice of teeth is left: the line above says where they end. Wider limits, or more wheels that may change, give more.</source>
        <translation>Keine Möglichkeit bleibt: die Zeile darüber sagt, wo sie enden. Weitere Grenzen oder mehr Räder, die sich ändern dürfen, geben mehr.</translation>
    </message>
    <message>
        <source>Nothing was found yet.</source>
        <translation>Noch wurde nichts gefunden.</translation>
    </message>
    <message>
        <source>Give the train the teeth of the chosen row (Enter); Ctrl+Z undoes it</source>
        <translation>Dem Getriebe die Zähne der gewählten Zeile geben (Eingabe); Strg+Z macht es rückgängig</translation>
    </message>
    <message>
        <source>Choose a row first</source>
        <translation>Erst eine Zeile wählen</translation>
    </message>
    <message>
        <source>Save what proves that there are no other choices</source>
        <translation>Sichern, was beweist, dass es keine anderen Möglichkeiten gibt</translation>
    </message>
    <message>
        <source>There is a certificate when all choices have been tried</source>
        <translation>Ein Zertifikat gibt es, wenn alle Möglichkeiten geprüft sind</translation>
    </message>
    <message>
        <source>Choose teeth</source>
        <translation>Zähnezahlen wählen</translation>
    </message>
    <message>
        <source>choice %1</source>
        <translation>Wahl %1</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>am nächsten</translation>
    </message>
    <message>
        <source>Save certificate</source>
        <translation>Zertifikat sichern</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON-Dateien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Mesh %1: every tooth meets every other</source>
        <translation>Zahneingriff %1: jeder Zahn trifft jeden anderen</translation>
    </message>
    <message>
        <source>Mesh %1: a tooth meets one in %2 of the others</source>
        <translation>Zahneingriff %1: ein Zahn trifft nur jeden %2-ten der anderen</translation>
    </message>
    <message>
        <source>%1: a rack undercuts it without a profile shift</source>
        <translation>%1: eine Zahnstange unterschneidet es ohne Profilverschiebung</translation>
    </message>
    <message>
        <source>hunting</source>
        <translation>teilerfremd</translation>
    </message>
    <message>
        <source>The best first: the smallest error, then the highest efficiency</source>
        <translation>Die beste zuerst: der kleinste Fehler, dann der höchste Wirkungsgrad</translation>
    </message>
    <message>
        <source>Teeth of %1</source>
        <translation>Zähne von %1</translation>
    </message>
    <message>
        <source>The ratio, exactly</source>
        <translation>Die Übersetzung, genau</translation>
    </message>
    <message>
        <source>The ratio, rounded to three decimals</source>
        <translation>Die Übersetzung, auf drei Stellen gerundet</translation>
    </message>
    <message>
        <source>By how much of the wished ratio it is missed; the dot shows where it is within the tolerance</source>
        <translation>Um welchen Teil der gewünschten Übersetzung sie verfehlt wird; der Punkt zeigt, wo sie in der Toleranz ist</translation>
    </message>
    <message>
        <source>How many equal planets go in at equal distances and clear each other</source>
        <translation>Wie viele gleiche Planeten sich in gleichen Abständen einbauen lassen, ohne einander zu berühren</translation>
    </message>
    <message>
        <source>By pair of wheels: a hunting tooth meets all others before it meets one again</source>
        <translation>Je Radpaar: bei teilerfremden Zähnezahlen trifft ein Zahn alle anderen, bevor er einen wieder trifft</translation>
    </message>
    <message>
        <source>Efficiency of the train, of several ratios the smallest</source>
        <translation>Wirkungsgrad des Getriebes, von mehreren Übersetzungen der kleinste</translation>
    </message>
    <message>
        <source>The same with the power the other way; none: it locks itself</source>
        <translation>Dasselbe mit der Leistung in Gegenrichtung; keiner: es hemmt sich selbst</translation>
    </message>
    <message>
        <source>Teeth for ratios…</source>
        <translation>Zähnezahlen für Übersetzungen…</translation>
    </message>
    <message>
        <source>Every choice of whole teeth with which this train has the ratios that you want</source>
        <translation>Jede Wahl ganzer Zähnezahlen, mit der dieses Getriebe die gewünschten Übersetzungen hat</translation>
    </message>
    <message>
        <source>There is no train yet whose teeth could be chosen.</source>
        <translation>Es gibt noch kein Getriebe, dessen Zähne gewählt werden könnten.</translation>
    </message>
    <message>
        <source>The teeth hold the answer: they open when the step is right or shown.</source>
        <translation>Die Zähne enthalten die Antwort: sie öffnen sich, wenn der Schritt richtig oder gezeigt ist.</translation>
    </message>
    <message>
        <source>Levers</source>
        <translation>Hebel</translation>
    </message>
    <message>
        <source>Each gear set as a lever, its links at their places</source>
        <translation>Jeder Radsatz als Hebel, seine Glieder an ihren Stellen</translation>
    </message>
    <message>
        <source>Nomogram</source>
        <translation>Nomogramm</translation>
    </message>
    <message>
        <source>The states of the gearbox as lines across the speeds of its links</source>
        <translation>Die Schaltzustände des Getriebes als Linien über die Drehzahlen seiner Glieder</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Lageplan</translation>
    </message>
    <message>
        <source>The plane of the links that is left when the coupling engaged last is let go</source>
        <translation>Die Ebene der Glieder, die bleibt, wenn das zuletzt geschlossene Schaltelement gelöst wird</translation>
    </message>
    <message>
        <source>Arrows to the right of the bars: how fast each link turns</source>
        <translation>Pfeile rechts der Stäbe: wie schnell sich jedes Glied dreht</translation>
    </message>
    <message>
        <source>Arrows to the left of the bars: the torques of the links on the lever, which add up to zero</source>
        <translation>Pfeile links der Stäbe: die Momente der Glieder auf den Hebel, deren Summe null ist</translation>
    </message>
    <message>
        <source>With so many inputs no arrow is dragged: set them in Inputs and results</source>
        <translation>Bei so vielen Antrieben wird kein Pfeil gezogen: Sie werden unter Antriebe und Ergebnisse eingestellt</translation>
    </message>
    <message>
        <source>Input %1: %2 rad/s. Esc puts back</source>
        <translation>Antrieb %1: %2 rad/s. Esc stellt zurück</translation>
    </message>
    <message>
        <source>No input turns this link: there is no speed to set</source>
        <translation>Kein Antrieb dreht dieses Glied: Es gibt keine Geschwindigkeit einzustellen</translation>
    </message>
    <message>
        <source>Speed of the link, rad/s</source>
        <translation>Geschwindigkeit des Glieds, rad/s</translation>
    </message>
    <message>
        <source>“%1” is no speed: a number, or one with a unit such as 30 rpm</source>
        <translation>„%1“ ist keine Geschwindigkeit: eine Zahl, oder eine mit Einheit wie 30 rpm</translation>
    </message>
    <message>
        <source>%1 for %2: state %3</source>
        <translation>%1 statt %2: Schaltzustand %3</translation>
    </message>
    <message>
        <source>, ratio %1</source>
        <translation>, Übersetzung %1</translation>
    </message>
    <message>
        <source>let go of %1: 1 freedom</source>
        <translation>%1 lösen: 1 Freiheitsgrad</translation>
    </message>
    <message>
        <source>let go of %1: %2 freedoms</source>
        <translation>%1 lösen: %2 Freiheitsgrade</translation>
    </message>
    <message>
        <source>hold it (B): it does not turn anyway</source>
        <translation>festhalten (B): Es dreht sich ohnehin nicht</translation>
    </message>
    <message>
        <source>hold it (B): nothing turns any more</source>
        <translation>festhalten (B): Dann dreht sich nichts mehr</translation>
    </message>
    <message>
        <source>hold it (B): 1 freedom</source>
        <translation>festhalten (B): 1 Freiheitsgrad</translation>
    </message>
    <message>
        <source>hold it (B): %1 freedoms</source>
        <translation>festhalten (B): %1 Freiheitsgrade</translation>
    </message>
    <message>
        <source>instead</source>
        <translation>sonst</translation>
    </message>
    <message>
        <source>State %1: nothing engaged</source>
        <translation>Schaltzustand %1: nichts geschlossen</translation>
    </message>
    <message>
        <source>State %1: %2</source>
        <translation>Schaltzustand %1: %2</translation>
    </message>
    <message>
        <source>The levers hold the answer: they are shown when the step is right or shown.</source>
        <translation>Die Hebel enthalten die Antwort: Sie erscheinen, wenn der Schritt richtig ist oder gezeigt wird.</translation>
    </message>
    <message>
        <source>The levers are still being laid out. Try again in a moment.</source>
        <translation>Die Hebel werden noch angeordnet. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Drag an arrow: the train turns with it. Click a point to select its link, B holds it</source>
        <translation>Ziehen Sie an einem Pfeil: Das Getriebe dreht sich mit. Ein Klick auf einen Punkt wählt sein Glied, B hält es fest</translation>
    </message>
    <message>
        <source>Click a line or its tag to engage the state</source>
        <translation>Ein Klick auf eine Linie oder ihr Schild schaltet den Zustand</translation>
    </message>
    <message>
        <source>Engaging a coupling draws the plane together along its dotted line</source>
        <translation>Ein Schaltelement zu schließen zieht die Ebene entlang seiner gepunkteten Linie zusammen</translation>
    </message>
    <message>
        <source>Gear sets as levers: speeds and torques of the links on the ground&apos;s axis</source>
        <translation>Radsätze als Hebel: Geschwindigkeiten und Momente der Glieder auf der Gestellachse</translation>
    </message>
    <message>
        <source>Speeds and torques on levers, the states of a gearbox as a nomogram, and the plane of two freedoms.</source>
        <translation>Geschwindigkeiten und Momente an Hebeln, die Schaltzustände eines Getriebes als Nomogramm, und die Ebene zweier Freiheitsgrade.</translation>
    </message>
    <message>
        <source>Links %1</source>
        <translation>Glieder %1</translation>
    </message>
    <message>
        <source>Link %1 (%2)</source>
        <translation>Glied %1 (%2)</translation>
    </message>
    <message>
        <source>%1: held by brake %2</source>
        <translation>%1: von Bremse %2 gehalten</translation>
    </message>
    <message>
        <source>, as %1 : %2 teeth</source>
        <translation>, wie %1 : %2 Zähne</translation>
    </message>
    <message>
        <source>an end of the lever, %1 the other</source>
        <translation>ein Ende des Hebels, %1 das andere</translation>
    </message>
    <message>
        <source>%1 divides %2 to %3 in %4 : %5</source>
        <translation>%1 teilt %2 bis %3 im Verhältnis %4 : %5</translation>
    </message>
    <message>
        <source>: %1 of the speed of %2 and %3 of that of %4</source>
        <translation>: %1 der Geschwindigkeit von %2 und %3 derer von %4</translation>
    </message>
    <message>
        <source>, by these tooth counts only</source>
        <translation>, nur bei diesen Zähnezahlen</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 N m on this lever</source>
        <translation>%1 N m auf diesen Hebel</translation>
    </message>
    <message>
        <source>, %1 of the way from %2 to %3</source>
        <translation>, %1 des Wegs von %2 nach %3</translation>
    </message>
    <message>
        <source>, an end of the lever</source>
        <translation>, ein Ende des Hebels</translation>
    </message>
    <message>
        <source>, %1 rad/s</source>
        <translation>, %1 rad/s</translation>
    </message>
    <message>
        <source>, %1 N m</source>
        <translation>, %1 N m</translation>
    </message>
    <message>
        <source>Along a lever, to the next one</source>
        <translation>Am Hebel entlang, zum nächsten</translation>
    </message>
    <message>
        <source>%1, of your train</source>
        <translation>%1, aus Ihrem Getriebe</translation>
    </message>
    <message>
        <source>%1
axes: %2
gear pairs / carrier: %3</source>
        <translation>%1
Achsen: %2
Radpaare / Steg: %3</translation>
    </message>
    <message>
        <source>%1 chains</source>
        <translation>%1 Ketten</translation>
    </message>
    <message>
        <source>one of %1 links that is not in the atlas</source>
        <translation>eine mit %1 Gliedern, die nicht im Atlas ist</translation>
    </message>
    <message>
        <source>(cannot turn)</source>
        <translation>(kann sich nicht drehen)</translation>
    </message>
    <message>
        <source>(turns by these tooth counts only)</source>
        <translation>(dreht sich nur mit diesen Zähnezahlen)</translation>
    </message>
    <message>
        <source>in no gear pair: %1</source>
        <translation>in keinem Radpaar: %1</translation>
    </message>
    <message>
        <source>planets that repeat another: %1</source>
        <translation>Planeten, die einen anderen wiederholen: %1</translation>
    </message>
    <message>
        <source>brakes and clutches</source>
        <translation>Bremsen und Kupplungen</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Weggelassen: %1</translation>
    </message>
    <message>
        <source>Your train is unfinished: %1</source>
        <translation>Ihr Getriebe ist unfertig: %1</translation>
    </message>
    <message>
        <source>Your train has no gear pair yet.</source>
        <translation>Ihr Getriebe hat noch kein Radpaar.</translation>
    </message>
    <message>
        <source>Your train is %1</source>
        <translation>Ihr Getriebe ist %1</translation>
    </message>
    <message>
        <source>Your train is %1 chains: %2</source>
        <translation>Ihr Getriebe besteht aus %1 Ketten: %2</translation>
    </message>
    <message>
        <source>Open as document</source>
        <translation>Als Dokument öffnen</translation>
    </message>
    <message>
        <source>Show in my train</source>
        <translation>In meinem Getriebe zeigen</translation>
    </message>
    <message>
        <source>Copy number</source>
        <translation>Nummer kopieren</translation>
    </message>
    <message>
        <source>Select the links and gear pairs of your train that are this chain</source>
        <translation>Die Glieder und Radpaare Ihres Getriebes auswählen, die diese Kette sind</translation>
    </message>
    <message>
        <source>Your train is being identified…</source>
        <translation>Ihr Getriebe wird bestimmt…</translation>
    </message>
    <message>
        <source>It cannot turn: %1 gear pairs are as many conditions for the speeds of %2 links, of which one is held.</source>
        <translation>Sie kann sich nicht drehen: %1 Radpaare sind ebenso viele Bedingungen für die Drehzahlen von %2 Gliedern, von denen eines festgehalten ist.</translation>
    </message>
    <message>
        <source>Same equations, other shafts: %1</source>
        <translation>Gleiche Gleichungen, andere Wellen: %1</translation>
    </message>
    <message>
        <source>One gear pair less: %1</source>
        <translation>Ein Radpaar weniger: %1</translation>
    </message>
    <message>
        <source>One gear pair more: %1</source>
        <translation>Ein Radpaar mehr: %1</translation>
    </message>
    <message>
        <source>Digraph of chain %1</source>
        <translation>Digraph der Kette %1</translation>
    </message>
    <message>
        <source>With the numbers and colours of your links</source>
        <translation>Mit den Nummern und Farben Ihrer Glieder</translation>
    </message>
    <message>
        <source>Counts for 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301</source>
        <translation>Anzahlen für Freiheitsgrad 1 wie in Yang, Ding u. a., J. Mech. Des. 141(4), 2019, 043301</translation>
    </message>
    <message>
        <source>A chain is links, axes and gear pairs, each pair with the link that carries both gears. Which link is held, teeth, kinds of gears and the joints by which coaxial links are drawn do not matter. Equations: the triples gear, gear, carrier alone (rotation graphs), which are the equations of the speeds. Chains: with the axes, too (displacement graphs). Left out are chains in which m gear pairs have fewer than m + 2 links between them, so that these turn as one; the smallest of them are the trains that cannot turn.</source>
        <translation>Eine Kette sind Glieder, Achsen und Radpaare, jedes Paar mit dem Glied, das beide Räder trägt. Welches Glied festgehalten ist, Zähne, Arten von Rädern und die Gelenke, mit denen gleichachsige Glieder gezeichnet sind, spielen keine Rolle. Gleichungen: allein die Tripel Rad, Rad, Steg (Rotationsgraphen), also die Gleichungen der Drehzahlen. Ketten: auch mit den Achsen (Verschiebungsgraphen). Weggelassen sind Ketten, in denen m Radpaare weniger als m + 2 Glieder zwischen sich haben, sodass diese sich wie eines drehen; die kleinsten davon sind die Getriebe, die sich nicht drehen können.</translation>
    </message>
    <message>
        <source>Freedom, one link held</source>
        <translation>Freiheitsgrad, ein Glied fest</translation>
    </message>
    <message>
        <source>No link parts the chain in two, and every link is in a gear pair</source>
        <translation>Kein Glied teilt die Kette in zwei, und jedes Glied ist in einem Radpaar</translation>
    </message>
    <message>
        <source>Chains with the same equations of speeds differ in their shafts only</source>
        <translation>Ketten mit denselben Gleichungen der Drehzahlen unterscheiden sich nur in den Wellen</translation>
    </message>
    <message>
        <source>Trains that cannot turn, and why</source>
        <translation>Getriebe, die sich nicht drehen können, und warum</translation>
    </message>
    <message>
        <source>Number, as 6-1.5</source>
        <translation>Nummer, etwa 6-1.5</translation>
    </message>
    <message>
        <source>What is counted?</source>
        <translation>Was wird gezählt?</translation>
    </message>
    <message>
        <source>Chains with 1 freedom</source>
        <translation>Ketten mit Freiheitsgrad 1</translation>
    </message>
    <message>
        <source>nonfractionated (%1)</source>
        <translation>nicht zerlegbar (%1)</translation>
    </message>
    <message>
        <source>equations of %1 only</source>
        <translation>nur Gleichungen von %1</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>All geared kinematic chains up to 7 links, and which of them your train is. Arrow keys walk, Enter opens one as a document, / finds a number.</source>
        <translation>Alle Räderketten bis 7 Glieder, und welche davon Ihr Getriebe ist. Pfeiltasten gehen weiter, Enter öffnet eine als Dokument, / sucht eine Nummer.</translation>
    </message>
    <message>
        <source>Geared kinematic chains, filtered and counted, and which your train is.</source>
        <translation>Räderketten, gefiltert und gezählt, und welche davon Ihr Getriebe ist.</translation>
    </message>
    <message>
        <source>Atlas of chains</source>
        <translation>Atlas der Ketten</translation>
    </message>
    <message>
        <source>All geared kinematic chains up to 7 links, and which of them this train is</source>
        <translation>Alle Räderketten bis 7 Glieder, und welche davon dieses Getriebe ist</translation>
    </message>
    <message>
        <source>New document</source>
        <translation>Neues Dokument</translation>
    </message>
    <message>
        <source>Chains</source>
        <translation>Ketten</translation>
    </message>
    <message>
        <source>Number of a chain</source>
        <translation>Nummer einer Kette</translation>
    </message>
    <message>
        <source>%1 has no meaning without %2.</source>
        <translation>%1 hat ohne %2 keine Bedeutung.</translation>
    </message>
    <message>
        <source>--limit is a whole number up to %1.</source>
        <translation>--limit ist eine ganze Zahl bis %1.</translation>
    </message>
    <message>
        <source>Whole teeth with which a drawn train has wanted ratios, all of them or the best.</source>
        <translation>Ganze Zähnezahlen, mit denen ein gezeichnetes Getriebe die gewünschten Übersetzungen hat, alle oder die besten.</translation>
    </message>
    <message>
        <source>Links %1 turn as one by these tooth counts only.</source>
        <translation>Die Glieder %1 drehen sich nur bei diesen Zähnezahlen wie eines.</translation>
    </message>
    <message>
        <source>The mechanism as a directed graph: links as circles, turning joints as solid arrows, gear meshes as dashed ones.</source>
        <translation>Der Mechanismus als gerichteter Graph: Glieder als Kreise, Drehgelenke als durchgezogene, Zahneingriffe als gestrichelte Pfeile.</translation>
    </message>
    <message>
        <source>The mechanism after Tsai and Tokad, with levels, chords and transfer vertices.</source>
        <translation>Der Mechanismus nach Tsai und Tokad, mit Ebenen, Sehnen und Transferknoten.</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism.</source>
        <translation>Beide Verfahren Schritt für Schritt, für diesen Mechanismus.</translation>
    </message>
    <message>
        <source>one let go, one taken per shift</source>
        <translation>je Schaltung eines gelöst, eines geschlossen</translation>
    </message>
    <message>
        <source>Masses, the inertia at each motor, and the motion that torques cause.</source>
        <translation>Massen, die Trägheit an jedem Motor, und die Bewegung, die Momente hervorrufen.</translation>
    </message>
    <message>
        <source>Loads, and the torques, forces and powers that they cause.</source>
        <translation>Lasten und die Momente, Kräfte und Leistungen, die sie hervorrufen.</translation>
    </message>
    <message>
        <source>The speeds of the motors, and how fast every joint turns with them.</source>
        <translation>Die Geschwindigkeiten der Motoren, und wie schnell sich jedes Gelenk mit ihnen dreht.</translation>
    </message>
    <message>
        <source>A lesson: what is asked, your answer, hints, and the reason where it is wrong.</source>
        <translation>Eine Lektion: was gefragt ist, Ihre Antwort, Hinweise, und der Grund, wo sie falsch ist.</translation>
    </message>
    <message>
        <source>Up and Down, Tab</source>
        <translation>Auf und Ab, Tab</translation>
    </message>
    <message>
        <source>Brakes and clutches, what is engaged, and the states of a gearbox.</source>
        <translation>Bremsen und Kupplungen, was geschlossen ist, und die Schaltzustände eines Getriebes.</translation>
    </message>
    <message>
        <source>Every matrix of the Matroid method. Rest the mouse on an entry to have it explained.</source>
        <translation>Alle Matrizen des Matroid-Verfahrens. Halten Sie die Maus über einen Eintrag, um ihn erklärt zu bekommen.</translation>
    </message>
    <message>
        <source>What is wrong with the mechanism, and how to mend it.</source>
        <translation>Was am Mechanismus falsch ist und wie man es behebt.</translation>
    </message>
    <message>
        <source>Teeth, axes and names of what is selected.</source>
        <translation>Zähne, Achsen und Namen dessen, was ausgewählt ist.</translation>
    </message>
    <message>
        <source>The mechanism in section, as in textbooks. You can draw here, too.</source>
        <translation>Der Mechanismus im Schnitt, wie in Lehrbüchern. Auch hier lässt sich zeichnen.</translation>
    </message>
    <message>
        <source>Speeds over one period of the motion.</source>
        <translation>Geschwindigkeiten über eine Periode der Bewegung.</translation>
    </message>
    <message>
        <source>The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit.</source>
        <translation>Die Zahnräder in Bewegung. Am Rad ziehen dreht das Getriebe, daneben ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Fewest brakes</source>
        <translation>Wenigste Bremsen</translation>
    </message>
    <message>
        <source>Most brakes</source>
        <translation>Meiste Bremsen</translation>
    </message>
    <message>
        <source>Fewest clutches</source>
        <translation>Wenigste Kupplungen</translation>
    </message>
    <message>
        <source>Most clutches</source>
        <translation>Meiste Kupplungen</translation>
    </message>
    <message>
        <source>Least ring : sun</source>
        <translation>Kleinstes Verhältnis Hohlrad : Sonne</translation>
    </message>
    <message>
        <source>Largest ring : sun</source>
        <translation>Größtes Verhältnis Hohlrad : Sonne</translation>
    </message>
    <message>
        <source>a folder for the documents of the candidates</source>
        <translation>ein Ordner für die Dokumente der Kandidaten</translation>
    </message>
    <message>
        <source>Hub gear</source>
        <translation>Nabenschaltung</translation>
    </message>
    <message>
        <source>driver</source>
        <translation>Antreiber</translation>
    </message>
    <message>
        <source>hub shell</source>
        <translation>Nabenhülse</translation>
    </message>
    <message>
        <source>shaft %1</source>
        <translation>Welle %1</translation>
    </message>
    <message>
        <source>ring %1</source>
        <translation>Hohlrad %1</translation>
    </message>
    <message>
        <source>carrier %1</source>
        <translation>Steg %1</translation>
    </message>
    <message>
        <source>sun %1</source>
        <translation>Sonne %1</translation>
    </message>
    <message>
        <source>Found from the ratios of a hub gear. One planet of each set is drawn; numbers of equal planets that go in: %1.</source>
        <translation>Aus den Übersetzungen einer Nabenschaltung gefunden. Von jedem Satz ist ein Planet gezeichnet; mögliche Anzahlen gleicher Planeten: %1.</translation>
    </message>
    <message>
        <source>Gearboxes with the ratios that you want. Space ticks one for comparison, Enter opens it as a document, Esc pauses the search.</source>
        <translation>Getriebe mit den gewünschten Übersetzungen. Leertaste merkt eines zum Vergleich vor, Eingabe öffnet es als Dokument, Esc hält die Suche an.</translation>
    </message>
    <message>
        <source>Ratios to hardware</source>
        <translation>Von Übersetzungen zum Innenleben</translation>
    </message>
    <message>
        <source>What may be inside a hub gear with the ratios of its maker&apos;s sheet, and which wheel to count. Enter opens a candidate as a document.</source>
        <translation>Was in einer Nabenschaltung mit den Übersetzungen des Datenblatts stecken kann und welches Rad zu zählen ist. Eingabe öffnet einen Kandidaten als Dokument.</translation>
    </message>
    <message>
        <source>Finds the planetary sets that may be inside a hub gear with given ratios, and what to count in it.</source>
        <translation>Findet die Planetensätze, die in einer Nabenschaltung mit gegebenen Übersetzungen stecken können, und was darin zu zählen ist.</translation>
    </message>
    <message>
        <source>Searches for gearboxes with these ratios (Ctrl+Return)</source>
        <translation>Sucht Getriebe mit diesen Übersetzungen (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Save wish…</source>
        <translation>Wunsch sichern…</translation>
    </message>
    <message>
        <source>Writes the wish as a file for geargraph-cli gearbox, which searches on many machines</source>
        <translation>Schreibt den Wunsch als Datei für geargraph-cli gearbox, das auf vielen Rechnern sucht</translation>
    </message>
    <message>
        <source>This variant exceeds a limit of the wish.</source>
        <translation>Diese Variante überschreitet eine Grenze des Wunsches.</translation>
    </message>
    <message>
        <source>Save wish</source>
        <translation>Wunsch sichern</translation>
    </message>
    <message>
        <source>, about %1 s to go</source>
        <translation>, noch etwa %1 s</translation>
    </message>
    <message>
        <source>, about %1 min to go</source>
        <translation>, noch etwa %1 min</translation>
    </message>
    <message>
        <source>None was found: no layout comes near these ratios.&lt;br&gt;More elements, another number of links, another set, or wider limits of ring : sun may help.</source>
        <translation>Keines gefunden: keine Anordnung kommt diesen Übersetzungen nahe.&lt;br&gt;Mehr Elemente, eine andere Anzahl von Gliedern, ein anderer Satz oder weitere Grenzen von Hohlrad : Sonne können helfen.</translation>
    </message>
    <message>
        <source>None was found: %1 shift tables come near these ratios, but no whole teeth do.&lt;br&gt;A larger tolerance, or rings with more teeth may help.</source>
        <translation>Keines gefunden: %1 Schalttabellen kommen diesen Übersetzungen nahe, aber keine ganzen Zähnezahlen.&lt;br&gt;Eine größere Toleranz oder Hohlräder mit mehr Zähnen können helfen.</translation>
    </message>
    <message>
        <source>None was found: %1 gearboxes have these ratios, but not so many brakes and clutches.</source>
        <translation>Keines gefunden: %1 Getriebe haben diese Übersetzungen, aber nicht so viele Bremsen und Kupplungen.</translation>
    </message>
    <message>
        <source>None was found: %1 gearboxes have these ratios, but are beyond the limits at the end of the wish.</source>
        <translation>Keines gefunden: %1 Getriebe haben diese Übersetzungen, liegen aber jenseits der Grenzen am Ende des Wunsches.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Shows only gearboxes with a property (Ctrl+F); H hides a single one, Ctrl+Z brings it back</source>
        <translation>Zeigt nur Getriebe mit einer Eigenschaft (Strg+F); H blendet ein einzelnes aus, Strg+Z holt es zurück</translation>
    </message>
    <message>
        <source>There is nothing in which these gearboxes differ.</source>
        <translation>Es gibt nichts, worin sich diese Getriebe unterscheiden.</translation>
    </message>
    <message>
        <source>Hides %1; a click lets go of it</source>
        <translation>Blendet %1 aus; ein Klick hebt ihn auf</translation>
    </message>
    <message>
        <source>hidden: %1</source>
        <translation>ausgeblendet: %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 von %2 gezeigt</translation>
    </message>
    <message>
        <source>What gearboxes are compared by</source>
        <translation>Wonach Getriebe verglichen werden</translation>
    </message>
    <message>
        <source>Brakes and clutches with the same speeds, but other torques and slips</source>
        <translation>Bremsen und Kupplungen mit denselben Drehzahlen, aber anderen Momenten und Schlupf</translation>
    </message>
    <message>
        <source>Schematic of the gearbox</source>
        <translation>Schema des Getriebes</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3, largest torque %4, largest slip %5</source>
        <translation>%1: %2 statt %3, größtes Moment %4, größter Schlupf %5</translation>
    </message>
    <message>
        <source>None of them is within the limits of the wish.</source>
        <translation>Keine davon liegt in den Grenzen des Wunsches.</translation>
    </message>
    <message>
        <source>error ≤ %1 %</source>
        <translation>Fehler ≤ %1 %</translation>
    </message>
    <message>
        <source>no circulating power</source>
        <translation>keine Blindleistung</translation>
    </message>
    <message>
        <source>elements ≤ %1</source>
        <translation>Elemente ≤ %1</translation>
    </message>
    <message>
        <source>brakes ≤ %1</source>
        <translation>Bremsen ≤ %1</translation>
    </message>
    <message>
        <source>clutches ≤ %1</source>
        <translation>Kupplungen ≤ %1</translation>
    </message>
    <message>
        <source>worst η ≥ %1</source>
        <translation>schlechtestes η ≥ %1</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>größter Fehler</translation>
    </message>
    <message>
        <source>worst efficiency</source>
        <translation>schlechtester Wirkungsgrad</translation>
    </message>
    <message>
        <source>circulating power</source>
        <translation>Blindleistung</translation>
    </message>
    <message>
        <source>fastest member</source>
        <translation>schnellstes Glied</translation>
    </message>
    <message>
        <source>largest torque</source>
        <translation>größtes Moment</translation>
    </message>
    <message>
        <source>largest slip</source>
        <translation>größter Schlupf</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Spreizung</translation>
    </message>
    <message>
        <source>largest ring</source>
        <translation>größtes Hohlrad</translation>
    </message>
    <message>
        <source>Tick two to compare them (Space)</source>
        <translation>Zwei ankreuzen, um sie zu vergleichen (Leertaste)</translation>
    </message>
    <message>
        <source>A bar a set, its links at their exact places; the filled points are input and output</source>
        <translation>Ein Balken je Satz, seine Glieder an ihren genauen Stellen; gefüllt sind Antrieb und Abtrieb</translation>
    </message>
    <message>
        <source>The speed of the fastest link, as a multiple of the input&apos;s</source>
        <translation>Die Drehzahl des schnellsten Glieds als Vielfaches der des Antriebs</translation>
    </message>
    <message>
        <source>The largest torque in a brake or clutch, as a multiple of the input&apos;s</source>
        <translation>Das größte Moment in einer Bremse oder Kupplung als Vielfaches dessen am Antrieb</translation>
    </message>
    <message>
        <source>levers</source>
        <translation>Hebel</translation>
    </message>
    <message>
        <source>schematic</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Schematic of the candidate</source>
        <translation>Schema des Kandidaten</translation>
    </message>
    <message>
        <source>Opens this candidate with a state for each gear, in a new window (Return)</source>
        <translation>Öffnet diesen Kandidaten mit einem Schaltzustand je Gang in einem neuen Fenster (Eingabe)</translation>
    </message>
    <message>
        <source>What can be counted or measured</source>
        <translation>Was gezählt oder gemessen werden kann</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>andere Zahl</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Eine andere Antwort</translation>
    </message>
    <message>
        <source>This is it, within your limits.</source>
        <translation>Das ist sie, in Ihren Grenzen.</translation>
    </message>
    <message>
        <source>count %1: leaves %2 at most</source>
        <translation>%1 zählen: lässt höchstens %2 übrig</translation>
    </message>
    <message>
        <source>turn %1: leaves %2 at most</source>
        <translation>%1 drehen: lässt höchstens %2 übrig</translation>
    </message>
    <message>
        <source>One measurement decides</source>
        <translation>Eine Messung entscheidet</translation>
    </message>
    <message>
        <source>No single measurement decides</source>
        <translation>Keine einzelne Messung entscheidet</translation>
    </message>
    <message>
        <source>Count the teeth of %1. You counted</source>
        <translation>Zählen Sie die Zähne: %1. Gezählt wurden</translation>
    </message>
    <message>
        <source>Turn the input %1 times in %2. The output turned, in degrees,</source>
        <translation>Drehen Sie den Antrieb %1-mal (%2). Der Abtrieb drehte sich, in Grad, um</translation>
    </message>
    <message>
        <source>no such wheel</source>
        <translation>kein solches Rad</translation>
    </message>
    <message>
        <source>leaves %1</source>
        <translation>lässt %1 übrig</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Kandidat %1</translation>
    </message>
    <message>
        <source>Choose a candidate of the list.</source>
        <translation>Wählen Sie einen Kandidaten der Liste.</translation>
    </message>
    <message>
        <source>Wheel over sprocket of each gear as the sheet prints it: typed or pasted</source>
        <translation>Laufrad zu Ritzel für jeden Gang, wie im Datenblatt: getippt oder eingefügt</translation>
    </message>
    <message>
        <source>0.632 0.741 0.843 …</source>
        <translation>0,632 0,741 0,843 …</translation>
    </message>
    <message>
        <source>that with 1</source>
        <translation>der mit 1</translation>
    </message>
    <message>
        <source>The gear that passes the motion through. The others may then be in percent, or metres a turn.</source>
        <translation>Der Gang, der die Bewegung durchreicht. Die anderen dürfen dann in Prozent oder in Metern je Umdrehung stehen.</translation>
    </message>
    <message>
        <source>direct gear</source>
        <translation>direkter Gang</translation>
    </message>
    <message>
        <source>rounded as printed</source>
        <translation>gerundet wie gedruckt</translation>
    </message>
    <message>
        <source>tolerance, %</source>
        <translation>Toleranz, %</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Was bekannt ist</translation>
    </message>
    <message>
        <source>Planetary sets in series, at most</source>
        <translation>Planetensätze hintereinander, höchstens</translation>
    </message>
    <message>
        <source>sets in series</source>
        <translation>Sätze in Reihe</translation>
    </message>
    <message>
        <source>stepped planets</source>
        <translation>Stufenplaneten</translation>
    </message>
    <message>
        <source>Planets with several wheels, each with a sun of its own</source>
        <translation>Planeten mit mehreren Rädern, jedes mit eigener Sonne</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>Hohlräder</translation>
    </message>
    <message>
        <source>Teeth by which the sums of one set may differ, made up by profile shift</source>
        <translation>Zähne, um die sich die Summen eines Satzes unterscheiden dürfen, durch Profilverschiebung ausgeglichen</translation>
    </message>
    <message>
        <source>slack</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>Wheels whose teeth have been counted: set and wheel, then the teeth</source>
        <translation>Räder, deren Zähne gezählt sind: Satz und Rad, dann die Zähne</translation>
    </message>
    <message>
        <source>Counted teeth</source>
        <translation>Gezählte Zähne</translation>
    </message>
    <message>
        <source>Products of the ratios of two sets</source>
        <translation>Produkte der Übersetzungen zweier Sätze</translation>
    </message>
    <message>
        <source>Rows: ratios of the first set. Columns: of the second. Gears are products of both.</source>
        <translation>Zeilen: Übersetzungen des ersten Satzes. Spalten: des zweiten. Gänge sind Produkte beider.</translation>
    </message>
    <message>
        <source>through</source>
        <translation>durch</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1, ungenutzt</translation>
    </message>
    <message>
        <source>planets %1</source>
        <translation>Planeten %1</translation>
    </message>
    <message>
        <source>No equal planets at equal distances can be assembled.</source>
        <translation>Gleiche Planeten in gleichen Abständen lassen sich nicht montieren.</translation>
    </message>
    <message>
        <source>A click takes this answer back</source>
        <translation>Ein Klick nimmt diese Antwort zurück</translation>
    </message>
    <message>
        <source>Candidates: %1, of %2 tooth sets with these ratios</source>
        <translation>Kandidaten: %1, von %2 Zahnsätzen mit diesen Übersetzungen</translation>
    </message>
    <message>
        <source>What is inside a hub with these ratios?</source>
        <translation>Was steckt in einer Nabe mit diesen Übersetzungen?</translation>
    </message>
    <message>
        <source>All tooth sets tried: complete. By set: %1.</source>
        <translation>Alle Zahnsätze geprüft: vollständig. Je Satz: %1.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche…</translation>
    </message>
    <message>
        <source>Type the ratios of the maker&apos;s sheet and choose Search.&lt;br&gt;A hub with seven gears: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</source>
        <translation>Tippen Sie die Übersetzungen des Datenblatts und wählen Sie Suchen.&lt;br&gt;Eine Nabe mit sieben Gängen: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</translation>
    </message>
    <message>
        <source>None has this number: was it counted rightly, or are the limits too narrow?</source>
        <translation>Keiner hat diese Zahl: ist richtig gezählt, oder sind die Grenzen zu eng?</translation>
    </message>
    <message>
        <source>None: some ratio is no product of the others. Are all of them rounded to the same place? More sets may explain them.</source>
        <translation>Keiner: eine Übersetzung ist kein Produkt der anderen. Sind alle auf dieselbe Stelle gerundet? Mehr Sätze können sie erklären.</translation>
    </message>
    <message>
        <source>the ring of set %1</source>
        <translation>Hohlrad von Satz %1</translation>
    </message>
    <message>
        <source>sun %2 of set %1</source>
        <translation>Sonne %2 von Satz %1</translation>
    </message>
    <message>
        <source>planet step %2 of set %1</source>
        <translation>Planetenstufe %2 von Satz %1</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>Ratios to hardware…</source>
        <translation>Von Übersetzungen zum Innenleben…</translation>
    </message>
    <message>
        <source>What may be inside a hub gear with these ratios, and what to count</source>
        <translation>Was in einer Nabenschaltung mit diesen Übersetzungen stecken kann und was zu zählen ist</translation>
    </message>
    <message>
        <source>Closes this tab; what it holds stays</source>
        <translation>Schließt diese Karte; was darin ist, bleibt</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>%1 schließen</translation>
    </message>
    <message>
        <source>Gearbox from ratios…</source>
        <translation>Getriebe aus Übersetzungen…</translation>
    </message>
    <message>
        <source>This is a document of its own. Save keeps it.</source>
        <translation>Das ist ein eigenes Dokument. Sichern bewahrt es auf.</translation>
    </message>
    <message>
        <source>Ratios with the drawn teeth; * is not the stated one</source>
        <translation>Übersetzungen mit den gezeichneten Zähnezahlen; * ist nicht die angegebene</translation>
    </message>
    <message>
        <source>The drawn teeth have all stated ratios.</source>
        <translation>Die gezeichneten Zähnezahlen haben alle angegebenen Übersetzungen.</translation>
    </message>
    <message>
        <source>No teeth near the drawn ones have all stated ratios.</source>
        <translation>Keine Zähnezahlen nahe den gezeichneten haben alle angegebenen Übersetzungen.</translation>
    </message>
    <message>
        <source>instead of the drawn teeth</source>
        <translation>statt der gezeichneten Zähnezahlen</translation>
    </message>
    <message>
        <source>Which teeth were meant? Wheels that differ: %1, choices: %2</source>
        <translation>Welche Zähnezahlen waren gemeint? Abweichende Räder: %1, Möglichkeiten: %2</translation>
    </message>
    <message>
        <source>the ratios are stated ones: which teeth near the drawn ones have them?</source>
        <translation>die Übersetzungen sind angegebene: welche Zähnezahlen nahe den gezeichneten haben sie?</translation>
    </message>
    <message>
        <source>with --meant: wheels that may differ, at most (3)</source>
        <translation>mit --meant: Räder, die abweichen dürfen, höchstens (3)</translation>
    </message>
    <message>
        <source>with --meant: teeth by which a wheel may differ (5)</source>
        <translation>mit --meant: Zähne, um die ein Rad abweichen darf (5)</translation>
    </message>
    <message>
        <source>Fewest teeth: %1</source>
        <translation>Wenigste Zähne: %1</translation>
    </message>
    <message>
        <source>Most teeth: %1</source>
        <translation>Meiste Zähne: %1</translation>
    </message>
    <message>
        <source>Lever diagram of the gearbox</source>
        <translation>Hebeldiagramm des Getriebes</translation>
    </message>
    <message>
        <source>sun %1.%2</source>
        <translation>Sonne %1.%2</translation>
    </message>
    <message>
        <source>None: no whole teeth within the limits have these ratios. A slack of 1 to 3, or wider limits, may help.</source>
        <translation>Keiner: keine ganzen Zähnezahlen in den Grenzen haben diese Übersetzungen. Ein Spielraum von 1 bis 3 oder weitere Grenzen können helfen.</translation>
    </message>
    <message>
        <source>ratio %1 (%2)</source>
        <translation>Übersetzung %1 (%2)</translation>
    </message>
    <message>
        <source>No choice within the limits has %1.</source>
        <translation>Keine Wahl innerhalb der Grenzen hat %1.</translation>
    </message>
    <message>
        <source>No choice within the limits has both %1 and %2.</source>
        <translation>Keine Wahl innerhalb der Grenzen hat zugleich %1 und %2.</translation>
    </message>
    <message>
        <source>Levers. Points: links of a gear set at exact distances; arrows: their speeds.</source>
        <translation>Hebel. Punkte: Glieder eines Radsatzes in genauen Abständen; Pfeile: ihre Drehzahlen.</translation>
    </message>
    <message>
        <source>Nomogram. A line for each state through the speeds of the links, the drive being 1.</source>
        <translation>Nomogramm. Eine Linie je Schaltzustand durch die Drehzahlen der Glieder; der Antrieb hat 1.</translation>
    </message>
    <message>
        <source>%1 is engaged: the plane projected along its line</source>
        <translation>%1 ist geschlossen: die Ebene entlang seiner Linie projiziert</translation>
    </message>
    <message>
        <source>peripheral velocity in %1/s</source>
        <translation>Umfangsgeschwindigkeit in %1/s</translation>
    </message>
    <message>
        <source>A line for each link; its slope is the speed in rad/s. Filled points: teeth; others: carried axes.</source>
        <translation>Eine Linie je Glied; ihre Steigung ist die Drehzahl in rad/s. Gefüllte Punkte: Zähne; andere: getragene Achsen.</translation>
    </message>
    <message>
        <source>Mesh %1 joins axes that are not in one plane with that of their carrier: its lines do not meet.</source>
        <translation>Eingriff %1 verbindet Achsen, die mit der ihres Stegs nicht in einer Ebene liegen: seine Linien treffen sich nicht.</translation>
    </message>
    <message>
        <source>Meshes %1 join axes that are not in one plane with that of their carrier: their lines do not meet.</source>
        <translation>Die Eingriffe %1 verbinden Achsen, die mit der ihres Stegs nicht in einer Ebene liegen: ihre Linien treffen sich nicht.</translation>
    </message>
    <message>
        <source>The section is unrolled in another way: not all teeth are at the heights of the plan.</source>
        <translation>Der Schnitt ist anders abgewickelt: nicht alle Zähne liegen auf den Höhen des Plans.</translation>
    </message>
    <message>
        <source>No speed plan: the train is not finished, see Problems.</source>
        <translation>Kein Drehzahlplan: Das Getriebe ist nicht fertig, siehe Probleme.</translation>
    </message>
    <message>
        <source>No speed plan: the speeds are not determined, see Problems.</source>
        <translation>Kein Drehzahlplan: Die Drehzahlen sind nicht bestimmt, siehe Probleme.</translation>
    </message>
    <message>
        <source>No speed plan: it needs axes that are all parallel.</source>
        <translation>Kein Drehzahlplan: Er braucht Achsen, die alle parallel sind.</translation>
    </message>
    <message>
        <source>Each gear set is a lever: its links on the ground&apos;s axis are points with exact places, 0 at one end and 1 at the other. In every motion the speed of a link is an affine function of its place, $\omega(x) = \omega(0) + x\,(\omega(1) - \omega(0))$.</source>
        <translation>Jeder Radsatz ist ein Hebel: Seine Glieder auf der Achse des Gestells sind Punkte an genauen Stellen, 0 an einem Ende und 1 am anderen. In jeder Bewegung ist die Drehzahl eines Glieds eine affine Funktion seiner Stelle, $\omega(x) = \omega(0) + x\,(\omega(1) - \omega(0))$.</translation>
    </message>
    <message>
        <source>Nomogram of the states, the speed of the drive being 1</source>
        <translation>Nomogramm der Schaltzustände; die Drehzahl des Antriebs ist 1</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Speed in rad/s</source>
        <translation>Drehzahl in rad/s</translation>
    </message>
    <message>
        <source>Lever of %1, %2 teeth:</source>
        <translation>Hebel von %1, %2 Zähne:</translation>
    </message>
    <message>
        <source>These links are on one lever by these tooth counts only.</source>
        <translation>Diese Glieder liegen nur bei diesen Zähnezahlen auf einem Hebel.</translation>
    </message>
    <message>
        <source>A view is digraph, tt-graph, schematic, levers or nomogram.</source>
        <translation>Eine Ansicht ist digraph, tt-graph, schematic, levers oder nomogram.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; is on no lever.</source>
        <translation>Glied „%1“ liegt auf keinem Hebel.</translation>
    </message>
    <message>
        <source>Speed plan</source>
        <translation>Drehzahlplan</translation>
    </message>
    <message>
        <source>Kutzbach&apos;s plan beside the section: peripheral velocities over the radius, a line for each link</source>
        <translation>Kutzbachs Plan neben dem Schnitt: Umfangsgeschwindigkeiten über dem Radius, eine Linie je Glied</translation>
    </message>
    <message>
        <source>Click the point to lock link %1 with. Esc ends</source>
        <translation>Punkt anklicken, der mit Glied %1 verbunden wird. Esc beendet</translation>
    </message>
    <message>
        <source>Each line is a link: its slope is the speed, lines cross at the teeth</source>
        <translation>Jede Linie ist ein Glied: Ihre Steigung ist die Drehzahl, Linien kreuzen sich an den Zähnen</translation>
    </message>
    <message>
        <source>Lock with…</source>
        <translation>Verbinden mit…</translation>
    </message>
    <message>
        <source>A clutch to the link that you click next</source>
        <translation>Eine Kupplung zu dem Glied, das Sie als Nächstes anklicken</translation>
    </message>
    <message>
        <source>Let go (B)</source>
        <translation>Lösen (B)</translation>
    </message>
    <message>
        <source>Hold (B)</source>
        <translation>Festhalten (B)</translation>
    </message>
    <message>
        <source>Release the brake of this link</source>
        <translation>Die Bremse dieses Glieds lösen</translation>
    </message>
    <message>
        <source>Engage the brake of this link, a new one where it has none</source>
        <translation>Die Bremse dieses Glieds schließen, eine neue, wo es keine hat</translation>
    </message>
    <message>
        <source>The speeds of these joints do not determine those of the motors.</source>
        <translation>Die Geschwindigkeiten dieser Gelenke bestimmen die der Motoren nicht.</translation>
    </message>
    <message>
        <source>There are %1 motors: name as many joints, not %2.</source>
        <translation>Es gibt %1 Motoren: Nennen Sie ebenso viele Gelenke, nicht %2.</translation>
    </message>
    <message>
        <source>The joints are %1: --outputs names others.</source>
        <translation>Die Gelenke sind %1: --outputs nennt andere.</translation>
    </message>
    <message>
        <source>the coupling of motors and joints</source>
        <translation>die Kopplung von Motoren und Gelenken</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (JSON)</source>
        <translation>Kopplung von Motoren und Gelenken (JSON)</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (C++)</source>
        <translation>Kopplung von Motoren und Gelenken (C++)</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (Python)</source>
        <translation>Kopplung von Motoren und Gelenken (Python)</translation>
    </message>
    <message>
        <source>Transmissions of ros2_control (XML)</source>
        <translation>Getriebe von ros2_control (XML)</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>Steuerungen</translation>
    </message>
    <message>
        <source>the joints that the motors drive, by label, as many as motors (the chain from the ground to a link that they determine)</source>
        <translation>die Gelenke, die die Motoren antreiben, nach Nummern, ebenso viele wie Motoren (die Kette vom Gestell zu einem Glied, die sie bestimmen)</translation>
    </message>
    <message>
        <source>json (the default), header (C++17), python, or ros2 (transmissions of ros2_control); each of header and python tests itself</source>
        <translation>json (Vorgabe), header (C++17), python oder ros2 (Getriebe von ros2_control); header und python prüfen sich selbst</translation>
    </message>
    <message>
        <source>Written as</source>
        <translation>Geschrieben als</translation>
    </message>
    <message>
        <source>In the gearbox designer: search</source>
        <translation>Im Getriebeentwurf: suchen</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Strg+Eingabetaste</translation>
    </message>
    <message>
        <source>forms: html,latex,pdf,json,handout,scorm (html,latex,pdf)</source>
        <translation>Formen: html,latex,pdf,json,handout,scorm (html,latex,pdf)</translation>
    </message>
    <message>
        <source>which mistake, how often, by whom: a .csv or a page with bars (.html)</source>
        <translation>welcher Fehler, wie oft, von wem: eine .csv oder eine Seite mit Balken (.html)</translation>
    </message>
    <message>
        <source>--summary is a file that ends in .csv or .html.</source>
        <translation>--summary ist eine Datei, die auf .csv oder .html endet.</translation>
    </message>
    <message>
        <source>--to lists forms out of html, latex, pdf, json, handout and scorm, not &quot;%1&quot;.</source>
        <translation>--to nennt Formen aus html, latex, pdf, json, handout und scorm, nicht „%1“.</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>File for answers</source>
        <translation>Datei für Antworten</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>nicht beantwortet</translation>
    </message>
    <message>
        <source>wrong, by no known mistake</source>
        <translation>falsch, ohne bekannten Fehler</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>Question %1: %2</source>
        <translation>Frage %1: %2</translation>
    </message>
    <message>
        <source>Handout</source>
        <translation>Handout</translation>
    </message>
    <message>
        <source>SCORM package</source>
        <translation>SCORM-Paket</translation>
    </message>
    <message>
        <source>A page for each variant, with the train in 3D, that grades what is filled in</source>
        <translation>Je Variante eine Seite mit dem Getriebe in 3D, die bewertet, was eingetragen wird</translation>
    </message>
    <message>
        <source>That page for each variant as a package for learning platforms</source>
        <translation>Diese Seite je Variante als Paket für Lernplattformen</translation>
    </message>
    <message>
        <source>right-hand</source>
        <translation>rechtssteigend</translation>
    </message>
    <message>
        <source>left-hand</source>
        <translation>linkssteigend</translation>
    </message>
    <message>
        <source>&quot;right&quot; or &quot;left&quot;</source>
        <translation>&quot;right&quot; oder &quot;left&quot;</translation>
    </message>
    <message>
        <source>right, left or nothing</source>
        <translation>right, left oder nichts</translation>
    </message>
    <message>
        <source>The helix angle of a gear mesh is at least 0 and below 90 degrees.</source>
        <translation>Der Schrägungswinkel eines Zahneingriffs ist mindestens 0 und kleiner als 90 Grad.</translation>
    </message>
    <message>
        <source>The module of a gear mesh is above 0.</source>
        <translation>Der Modul eines Zahneingriffs ist größer als 0.</translation>
    </message>
    <message>
        <source>The pressure angle of a gear mesh is above 0 and below 90 degrees.</source>
        <translation>Der Eingriffswinkel eines Zahneingriffs ist größer als 0 und kleiner als 90 Grad.</translation>
    </message>
    <message>
        <source>its module %1 makes a centre distance of %2, and the axes are %3 apart: profile shifts make up for two modules at most. What fits: the module %4.</source>
        <translation>sein Modul %1 ergibt einen Achsabstand von %2, und die Achsen sind %3 voneinander entfernt: Profilverschiebungen gleichen höchstens zwei Module aus. Passend: der Modul %4.</translation>
    </message>
    <message>
        <source>Meshes %1 and %2 give the teeth of gear %3 different helix angles or hands. What fits: one helix for both (a wheel and the ring round it have the same hand, two wheels beside each other opposite ones), or two wheels with names of their own.</source>
        <translation>Die Zahneingriffe %1 und %2 geben den Zähnen des Rades %3 verschiedene Schrägungswinkel oder Steigungsrichtungen. Passend: eine Schrägung für beide (ein Rad und der Ring darum haben dieselbe Richtung, zwei Räder nebeneinander entgegengesetzte) oder zwei Räder mit eigenen Namen.</translation>
    </message>
    <message>
        <source>Meshes %1 and %2 give gear %3 different modules. What fits: one module for both, or two wheels with names of their own.</source>
        <translation>Die Zahneingriffe %1 und %2 geben dem Rad %3 verschiedene Module. Passend: ein Modul für beide oder zwei Räder mit eigenen Namen.</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>Riemen</translation>
    </message>
    <message>
        <source>pins</source>
        <translation>Bolzen</translation>
    </message>
    <message>
        <source>Make %1 a belt</source>
        <translation>%1 zu einem Riemen machen</translation>
    </message>
    <message>
        <source>Make %1 a pair of pins and holes</source>
        <translation>%1 zu Bolzen in Löchern machen</translation>
    </message>
    <message>
        <source>freewheel %1</source>
        <translation>Freilauf %1</translation>
    </message>
    <message>
        <source>&quot;brake&quot;, &quot;clutch&quot; or &quot;freewheel&quot;</source>
        <translation>„brake“, „clutch“ oder „freewheel“</translation>
    </message>
    <message>
        <source>Only a belt is crossed, or has a pitch or running diameters; mesh &quot;%1&quot; is none.</source>
        <translation>Nur ein Riemen ist gekreuzt oder hat eine Teilung oder Laufdurchmesser; Eingriff „%1“ ist keiner.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; has no teeth that slide: state its `efficiency`, not a `friction`.</source>
        <translation>Eingriff „%1“ hat keine gleitenden Zähne: `efficiency` angeben, keine `friction`.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; is a belt or pins, which have no pitch point: leave it out.</source>
        <translation>Eingriff „%1“ ist ein Riemen oder besteht aus Bolzen, die keinen Wälzpunkt haben: ihn weglassen.</translation>
    </message>
    <message>
        <source>Pitch and running diameters of belt &quot;%1&quot; are above 0.</source>
        <translation>Teilung und Laufdurchmesser des Riemens „%1“ sind größer als 0.</translation>
    </message>
    <message>
        <source>Belt &quot;%1&quot; has teeth at both ends, or running diameters at both.</source>
        <translation>Riemen „%1“ hat an beiden Enden Zähne oder an beiden Laufdurchmesser.</translation>
    </message>
    <message>
        <source>The running diameters of belt &quot;%1&quot; are in the ratio of two whole numbers up to 100,000: give them with fewer digits.</source>
        <translation>Die Laufdurchmesser des Riemens „%1“ stehen im Verhältnis zweier ganzer Zahlen bis 100.000: sie mit weniger Stellen angeben.</translation>
    </message>
    <message>
        <source>Pins turn 1 : 1 and belts with running diameters in their ratio; mesh &quot;%1&quot; states other teeth: leave them out.</source>
        <translation>Bolzen drehen 1 : 1 und Riemen mit Laufdurchmessern in deren Verhältnis; Eingriff „%1“ nennt andere Zähnezahlen: sie weglassen.</translation>
    </message>
    <message>
        <source>A freewheel names two links.</source>
        <translation>Ein Freilauf nennt zwei Glieder.</translation>
    </message>
    <message>
        <source>Freewheel &quot;%1&quot; ties link &quot;%2&quot; to itself.</source>
        <translation>Freilauf „%1“ verbindet Glied „%2“ mit sich selbst.</translation>
    </message>
    <message>
        <source>State &quot;%1&quot; engages freewheel &quot;%2&quot;, which locks by itself: leave it out.</source>
        <translation>Zustand „%1“ schaltet Freilauf „%2“, der von selbst sperrt: ihn weglassen.</translation>
    </message>
    <message>
        <source>The direction of a state is 1 or -1.</source>
        <translation>Die Richtung eines Zustands ist 1 oder -1.</translation>
    </message>
    <message>
        <source>A freewheel needs two different links.</source>
        <translation>Ein Freilauf braucht zwei verschiedene Glieder.</translation>
    </message>
    <message>
        <source>A belt and pins have no module: state a pitch or running diameters.</source>
        <translation>Riemen und Bolzen haben keinen Modul: eine Teilung oder Laufdurchmesser angeben.</translation>
    </message>
    <message>
        <source>it says %1, but its axes are skew. What fits: parallel axes.</source>
        <translation>angegeben ist %1, aber seine Achsen sind windschief. Es passen: parallele Achsen.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet. What fits: bevel, or parallel axes.</source>
        <translation>angegeben ist %1, aber seine Achsen schneiden sich. Es passen: Kegelräder oder parallele Achsen.</translation>
    </message>
    <message>
        <source>its pulleys overlap: the running radii %1 and %2 need more than the %3 between the axes. What fits: smaller ones, or axes farther apart.</source>
        <translation>seine Scheiben überschneiden sich: die Laufradien %1 und %2 brauchen mehr als die %3 zwischen den Achsen. Es passen: kleinere, oder Achsen mit größerem Abstand.</translation>
    </message>
    <message>
        <source>State %1: more than one pattern of locked and free freewheels is possible; shown is the one with these locked: %2.</source>
        <translation>Zustand %1: mehr als ein Muster gesperrter und freier Freiläufe ist möglich; gezeigt ist das mit diesen gesperrten: %2.</translation>
    </message>
    <message>
        <source>State %1: the drive overruns its freewheels and drives nothing this way (locked they would turn as shown: %2). Exchange the two links of one, or turn the drive the other way.</source>
        <translation>Zustand %1: der Antrieb überholt seine Freiläufe und treibt so herum nichts an (gesperrt würden sie wie gezeigt drehen: %2). Die zwei Glieder eines Freilaufs tauschen oder den Antrieb anders herum drehen.</translation>
    </message>
    <message>
        <source>Freewheel %1 locks before link %2 turns faster than link %3, but the given speeds make it faster by %4 rad/s. Engage it, exchange its links, or turn the inputs the other way.</source>
        <translation>Freilauf %1 sperrt, bevor Glied %2 schneller dreht als Glied %3, aber die gegebenen Drehzahlen machen es um %4 rad/s schneller. Ihn schalten, seine Glieder tauschen oder die Eingänge anders herum drehen.</translation>
    </message>
    <message>
        <source>The torque that the freewheel exerts on the first of its links while it is locked; the second one has the reaction.</source>
        <translation>Das Moment, das der gesperrte Freilauf auf das erste seiner Glieder ausübt; das zweite hat die Reaktion.</translation>
    </message>
    <message>
        <source>Freewheel %1</source>
        <translation>Freilauf %1</translation>
    </message>
    <message>
        <source>It locks where its first link would turn faster than its second.</source>
        <translation>Er sperrt, wo sein erstes Glied schneller drehen würde als sein zweites.</translation>
    </message>
    <message>
        <source>Mesh %1 is a belt: its pulleys turn the same way, seen from their carrier, and against each other where it is crossed.</source>
        <translation>Eingriff %1 ist ein Riemen: seine Scheiben drehen, vom Steg aus gesehen, gleichsinnig, und gegensinnig, wo er gekreuzt ist.</translation>
    </message>
    <message>
        <source>Mesh %1 is a belt: its pulleys turn the same way, seen from the carrier, and opposite ways where it is crossed.</source>
        <translation>Eingriff %1 ist ein Riemen: seine Scheiben drehen, vom Steg aus gesehen, gleich herum, und entgegengesetzt, wo er gekreuzt ist.</translation>
    </message>
    <message>
        <source>Mesh %1 is an open belt: seen from the carrier, its pulleys turn the same way, so that f is %2.</source>
        <translation>Eingriff %1 ist ein offener Riemen: vom Steg aus gesehen drehen seine Scheiben gleichsinnig, also ist f %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a crossed belt: seen from the carrier, its pulleys turn against each other, so that f is %2.</source>
        <translation>Eingriff %1 ist ein gekreuzter Riemen: vom Steg aus gesehen drehen seine Scheiben gegensinnig, also ist f %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: seen from the carrier, both links turn alike, so that f is %2.</source>
        <translation>Eingriff %1 sind Bolzen in Löchern: vom Steg aus gesehen drehen beide Glieder gleich, also ist f %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: both links turn alike, seen from their carrier.</source>
        <translation>Eingriff %1 sind Bolzen in Löchern: beide Glieder drehen, von ihrem Steg aus gesehen, gleich.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: both links turn alike, seen from the carrier.</source>
        <translation>Eingriff %1 sind Bolzen in Löchern: beide Glieder drehen, vom Steg aus gesehen, gleich.</translation>
    </message>
    <message>
        <source>%1 past link %2</source>
        <translation>%1 an Glied %2 vorbei</translation>
    </message>
    <message>
        <source>--input is the label of a joint or of a moving link, not &quot;%1&quot;.</source>
        <translation>--input ist die Nummer eines Gelenks oder eines bewegten Glieds, nicht „%1“.</translation>
    </message>
    <message>
        <source>--rpm is above 0.</source>
        <translation>--rpm ist größer als 0.</translation>
    </message>
    <message>
        <source>At the given speed of the input shaft.</source>
        <translation>Bei der angegebenen Drehzahl der Antriebswelle.</translation>
    </message>
    <message>
        <source>Cycles for a turn of the input shaft, exactly.</source>
        <translation>Schwingungen je Umdrehung der Antriebswelle, exakt.</translation>
    </message>
    <message>
        <source>From stop to stop at the output, every mesh at its worst.</source>
        <translation>Von Anschlag zu Anschlag am Abtrieb, jeder Eingriff im ungünstigsten Fall.</translation>
    </message>
    <message>
        <source>Give --json or --csv.</source>
        <translation>--json oder --csv angeben.</translation>
    </message>
    <message>
        <source>Height and dashes tell what repeats, not how strongly.</source>
        <translation>Höhe und Strichart sagen, was sich wiederholt, nicht wie stark.</translation>
    </message>
    <message>
        <source>How far outputs turn while inputs are held, by the play of the teeth.</source>
        <translation>Wie weit sich Abtriebe durch das Flankenspiel drehen, während die Antriebe gehalten werden.</translation>
    </message>
    <message>
        <source>How far the input turns from stop to stop while the output is held.</source>
        <translation>Wie weit sich der Antrieb von Anschlag zu Anschlag dreht, während der Abtrieb gehalten wird.</translation>
    </message>
    <message>
        <source>How often the modulating frequency is added to the harmonic, or taken from it.</source>
        <translation>Wie oft die modulierende Frequenz zur Harmonischen addiert oder von ihr abgezogen wird.</translation>
    </message>
    <message>
        <source>Meshes that follow from others share their play; the tightest decides.</source>
        <translation>Eingriffe, die aus anderen folgen, teilen sich ihr Spiel; der engste entscheidet.</translation>
    </message>
    <message>
        <source>No input turns, so there are no frequencies.</source>
        <translation>Kein Antrieb dreht sich, darum gibt es keine Frequenzen.</translation>
    </message>
    <message>
        <source>No joint follows an input.</source>
        <translation>Kein Gelenk folgt einem Antrieb.</translation>
    </message>
    <message>
        <source>No lost motion is known: the train has no solution, or is too large.</source>
        <translation>Kein Umkehrspiel bekannt: Das Getriebe hat keine Lösung oder ist zu groß.</translation>
    </message>
    <message>
        <source>No motion is known, so there are no frequencies.</source>
        <translation>Keine Bewegung ist bekannt, darum gibt es keine Frequenzen.</translation>
    </message>
    <message>
        <source>The frequencies of shafts, tooth meshes and planets, as ratios to the input shaft.</source>
        <translation>Die Frequenzen von Wellen, Zahneingriffen und Planeten, als Verhältnisse zur Antriebswelle.</translation>
    </message>
    <message>
        <source>The input that it is carried back to, by label.</source>
        <translation>Der Antrieb, auf den es bezogen ist, nach Nummer.</translation>
    </message>
    <message>
        <source>The joint that turns while the inputs are held, by label.</source>
        <translation>Das Gelenk, das sich dreht, während die Antriebe gehalten werden, nach Nummer.</translation>
    </message>
    <message>
        <source>The mesh that contributes most, by label.</source>
        <translation>Der Eingriff, der am meisten beiträgt, nach Nummer.</translation>
    </message>
    <message>
        <source>The multiple of the tooth mesh.</source>
        <translation>Das Vielfache des Zahneingriffs.</translation>
    </message>
    <message>
        <source>The root of the sum of squares of the parts of all meshes.</source>
        <translation>Die Wurzel aus der Summe der Quadrate der Anteile aller Eingriffe.</translation>
    </message>
    <message>
        <source>The same in minutes of arc.</source>
        <translation>Dasselbe in Winkelminuten.</translation>
    </message>
    <message>
        <source>The shaft does not turn (%1).</source>
        <translation>Die Welle dreht sich nicht (%1).</translation>
    </message>
    <message>
        <source>The shaft has no speed of its own about one axis (%1).</source>
        <translation>Die Welle hat keine bestimmte Drehzahl um eine Achse (%1).</translation>
    </message>
    <message>
        <source>The state whose couplings are engaged.</source>
        <translation>Der Gang, dessen Kupplungen und Bremsen geschlossen sind.</translation>
    </message>
    <message>
        <source>What is lost of the worst case if that mesh has no play.</source>
        <translation>Was vom ungünstigsten Fall entfällt, wenn dieser Eingriff kein Spiel hat.</translation>
    </message>
    <message>
        <source>What repeats.</source>
        <translation>Was sich wiederholt.</translation>
    </message>
    <message>
        <source>Where it repeats, by label.</source>
        <translation>Wo es sich wiederholt, nach Nummer.</translation>
    </message>
    <message>
        <source>as CSV</source>
        <translation>als CSV</translation>
    </message>
    <message>
        <source>assembly phase</source>
        <translation>Montagephase</translation>
    </message>
    <message>
        <source>at the input</source>
        <translation>am Antrieb</translation>
    </message>
    <message>
        <source>Dashed: what either motor may do alone, for some angle of the other.</source>
        <translation>Gestrichelt: was jeder Motor allein darf, bei irgendeinem Winkel des anderen.</translation>
    </message>
    <message>
        <source>Degrees from the reference pose; all other motors stand in it.</source>
        <translation>Grad ab der Bezugslage; alle anderen Motoren stehen in ihr.</translation>
    </message>
    <message>
        <source>Dotted sides are open: nothing limits the motors there.</source>
        <translation>Gepunktete Seiten sind offen: Dort begrenzt nichts die Motoren.</translation>
    </message>
    <message>
        <source>Limits that these motors never reach: those of joints %1.</source>
        <translation>Grenzen, die diese Motoren nie erreichen: die der Gelenke %1.</translation>
    </message>
    <message>
        <source>No joint that turns with these motors has limits.</source>
        <translation>Kein Gelenk, das sich mit diesen Motoren dreht, hat Grenzen.</translation>
    </message>
    <message>
        <source>Nothing moves that limits could stop.</source>
        <translation>Nichts bewegt sich, was Grenzen anhalten könnten.</translation>
    </message>
    <message>
        <source>The mechanism is too large for exact limits.</source>
        <translation>Das Getriebe ist für exakte Grenzen zu groß.</translation>
    </message>
    <message>
        <source>There are not two motors.</source>
        <translation>Es gibt keine zwei Motoren.</translation>
    </message>
    <message>
        <source>joint %1 at %2</source>
        <translation>Gelenk %1 bei %2</translation>
    </message>
    <message>
        <source>motor %1, degrees</source>
        <translation>Motor %1, Grad</translation>
    </message>
    <message>
        <source>cycles for a turn of the shaft (%1)</source>
        <translation>Schwingungen je Umdrehung der Welle (%1)</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>harmonic</source>
        <translation>Harmonische</translation>
    </message>
    <message>
        <source>how many planets one stands for that is drawn alone (1)</source>
        <translation>für wie viele Planeten ein einzeln gezeichneter steht (1)</translation>
    </message>
    <message>
        <source>hunting tooth</source>
        <translation>Zahnpaarung (Hunting Tooth)</translation>
    </message>
    <message>
        <source>input shaft: joint %1</source>
        <translation>Antriebswelle: Gelenk %1</translation>
    </message>
    <message>
        <source>input shaft: link %1</source>
        <translation>Antriebswelle: Glied %1</translation>
    </message>
    <message>
        <source>its part</source>
        <translation>sein Anteil</translation>
    </message>
    <message>
        <source>likely</source>
        <translation>wahrscheinlich</translation>
    </message>
    <message>
        <source>mesh %1, %2 planets past link %3</source>
        <translation>Eingriff %1, %2 Planeten an Glied %3 vorbei</translation>
    </message>
    <message>
        <source>mesh %1, turns of link %2</source>
        <translation>Eingriff %1, Umdrehungen von Glied %2</translation>
    </message>
    <message>
        <source>multiples of each tooth mesh (1)</source>
        <translation>Vielfache jedes Zahneingriffs (1)</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>on each side of each multiple (1)</source>
        <translation>auf jeder Seite jedes Vielfachen (1)</translation>
    </message>
    <message>
        <source>orders</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>planets pass</source>
        <translation>Planetendurchgang</translation>
    </message>
    <message>
        <source>shaft</source>
        <translation>Welle</translation>
    </message>
    <message>
        <source>sideband</source>
        <translation>Seitenband</translation>
    </message>
    <message>
        <source>the frequencies</source>
        <translation>die Frequenzen</translation>
    </message>
    <message>
        <source>the joint or link (by label) that ratios are of, instead of the first input or the state&apos;s drive</source>
        <translation>das Gelenk oder Glied (nach Nummer), auf das Verhältnisse bezogen sind, statt des ersten Antriebs oder dem des Gangs</translation>
    </message>
    <message>
        <source>the lost motion</source>
        <translation>das Umkehrspiel</translation>
    </message>
    <message>
        <source>the speed of the input shaft: frequencies also in Hz</source>
        <translation>die Drehzahl der Antriebswelle: Frequenzen auch in Hz</translation>
    </message>
    <message>
        <source>tooth mesh</source>
        <translation>Zahneingriff</translation>
    </message>
    <message>
        <source>turns on its bearer</source>
        <translation>Drehung auf dem Träger</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>ungünstigst</translation>
    </message>
    <message>
        <source>A wheel without teeth in one plane has no profile.</source>
        <translation>Ein Rad ohne Zähne in einer Ebene hat kein Profil.</translation>
    </message>
    <message>
        <source>Left out, as they have no teeth in one plane: %1.</source>
        <translation>Weggelassen, da ihre Zähne nicht in einer Ebene liegen: %1.</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>die Profile</translation>
    </message>
    <message>
        <source>Profiles of wheels (DXF)</source>
        <translation>Profile der Räder (DXF)</translation>
    </message>
    <message>
        <source>profiles of wheels</source>
        <translation>Profile von Rädern</translation>
    </message>
    <message>
        <source>Cutting profiles</source>
        <translation>Schnittprofile</translation>
    </message>
    <message>
        <source>The program geargraph-step, which writes STEP files, is not installed; it is in the package of that name.</source>
        <translation>Das Programm geargraph-step, das STEP-Dateien schreibt, ist nicht installiert; es ist im Paket dieses Namens.</translation>
    </message>
    <message>
        <source>OpenCASCADE could not make the solids or write the file.</source>
        <translation>OpenCASCADE konnte die Körper nicht bilden oder die Datei nicht schreiben.</translation>
    </message>
    <message>
        <source>There are no solids to write.</source>
        <translation>Es gibt keine Körper zu schreiben.</translation>
    </message>
    <message>
        <source>More than %1 faces are too many for a STEP file; --gear and --link export a part.</source>
        <translation>Mehr als %1 Flächen sind zu viele für eine STEP-Datei; --gear und --link exportieren einen Teil.</translation>
    </message>
    <message>
        <source>Teeth of a worm&apos;s wheel are within %1 modules instead of %2 (--tolerance).</source>
        <translation>Zähne eines Schneckenrads weichen bis zu %1 statt %2 Module ab (--tolerance).</translation>
    </message>
    <message>
        <source>Of %1 part(s) the solids could not be united; they overlap.</source>
        <translation>Bei %1 Teil(en) konnten die Körper nicht vereinigt werden; sie durchdringen sich.</translation>
    </message>
    <message>
        <source>%1 parts, %2 solids, teeth within %3 modules of their exact form.</source>
        <translation>%1 Teile, %2 Körper, Zähne höchstens %3 Module von ihrer exakten Form.</translation>
    </message>
    <message>
        <source>STEP (AP214), for CAD</source>
        <translation>STEP (AP214), für CAD</translation>
    </message>
    <message>
        <source>an assembly for CAD</source>
        <translation>eine Baugruppe für CAD</translation>
    </message>
    <message>
        <source>CAD</source>
        <translation>CAD</translation>
    </message>
    <message>
        <source>Writing the STEP file took longer than %1 s.</source>
        <translation>Das Schreiben der STEP-Datei dauerte länger als %1 s.</translation>
    </message>
    <message>
        <source>The program geargraph-step crashed; nothing was written.</source>
        <translation>Das Programm geargraph-step ist abgestürzt; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The program geargraph-step cannot be run.</source>
        <translation>Das Programm geargraph-step kann nicht ausgeführt werden.</translation>
    </message>
    <message>
        <source>The STEP file takes more memory or more bytes than there may be; export a part of the train.</source>
        <translation>Die STEP-Datei braucht mehr Speicher oder mehr Bytes als erlaubt; exportieren Sie einen Teil des Getriebes.</translation>
    </message>
    <message>
        <source>OpenCASCADE finds no valid solid in &quot;%1&quot;; nothing was written.</source>
        <translation>OpenCASCADE findet keinen gültigen Körper in „%1“; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The program geargraph-step failed; nothing was written.</source>
        <translation>Das Programm geargraph-step ist gescheitert; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 um %2</translation>
    </message>
    <message>
        <source>%1, %2: %3 should be %4.</source>
        <translation>%1, %2: %3 muss %4 sein.</translation>
    </message>
    <message>
        <source>%1, %2: the sign of %3 is wrong; it is %4.</source>
        <translation>%1, %2: das Vorzeichen von %3 ist falsch; es ist %4.</translation>
    </message>
    <message>
        <source>%1: joint %2 is named twice.</source>
        <translation>%1: Gelenk %2 ist zweimal genannt.</translation>
    </message>
    <message>
        <source>%1: there is no turning joint &quot;%2&quot;.</source>
        <translation>%1: Es gibt kein Drehgelenk „%2“.</translation>
    </message>
    <message>
        <source>--outputs belongs to the matrices of a controller.</source>
        <translation>--outputs gehört zu den Matrizen einer Steuerung.</translation>
    </message>
    <message>
        <source>A matrix has at most %1 rows.</source>
        <translation>Eine Matrix hat höchstens %1 Zeilen.</translation>
    </message>
    <message>
        <source>A matrix is an array of rows.</source>
        <translation>Eine Matrix ist ein Feld von Zeilen.</translation>
    </message>
    <message>
        <source>A row is an array of numbers.</source>
        <translation>Eine Zeile ist ein Feld von Zahlen.</translation>
    </message>
    <message>
        <source>An object or an array of rows is needed.</source>
        <translation>Ein Objekt oder ein Feld von Zeilen wird gebraucht.</translation>
    </message>
    <message>
        <source>Directions differ, too.</source>
        <translation>Auch Drehrichtungen weichen ab.</translation>
    </message>
    <message>
        <source>Matrix from %1: %2</source>
        <translation>Matrix von %1: %2</translation>
    </message>
    <message>
        <source>Motors %1, joints %2</source>
        <translation>Motoren %1, Gelenke %2</translation>
    </message>
    <message>
        <source>Row %1 has %2 numbers; the matrix is square, with %3 rows.</source>
        <translation>Zeile %1 hat %2 Zahlen; die Matrix ist quadratisch, mit %3 Zeilen.</translation>
    </message>
    <message>
        <source>Say which matrix this is: --matrix motor-to-joint or joint-to-motor.</source>
        <translation>Angeben, welche Matrix das ist: --matrix motor-to-joint oder joint-to-motor.</translation>
    </message>
    <message>
        <source>The matrices and offsets are of different sizes.</source>
        <translation>Die Matrizen und Versätze sind verschieden groß.</translation>
    </message>
    <message>
        <source>The matrices have %1 rows, the train has %2 motors.</source>
        <translation>Die Matrizen haben %1 Zeilen, das Getriebe hat %2 Motoren.</translation>
    </message>
    <message>
        <source>The offsets do not cancel: motor offset %1 is %2, the joints&apos; offsets ask for %3.</source>
        <translation>Die Versätze heben sich nicht auf: Motorversatz %1 ist %2, die Versätze der Gelenke verlangen %3.</translation>
    </message>
    <message>
        <source>The two matrices are not inverse of each other: their product has %1 in row %2, column %3, not %4.</source>
        <translation>Die beiden Matrizen sind nicht zueinander invers: Ihr Produkt hat %1 in Zeile %2, Spalte %3, nicht %4.</translation>
    </message>
    <message>
        <source>There is neither &quot;motorToJoint&quot; nor &quot;jointToMotor&quot;.</source>
        <translation>Es gibt weder „motorToJoint“ noch „jointToMotor“.</translation>
    </message>
    <message>
        <source>There is no row of numbers.</source>
        <translation>Es gibt keine Zeile mit Zahlen.</translation>
    </message>
    <message>
        <source>all is right but for factors: %1.</source>
        <translation>alles stimmt bis auf Faktoren: %1.</translation>
    </message>
    <message>
        <source>all would be right if these turned the other way: %1.</source>
        <translation>alles stimmte, wenn sich diese andersherum drehten: %1.</translation>
    </message>
    <message>
        <source>all would be right with rows for %1 and columns for %2.</source>
        <translation>alles stimmte mit Zeilen für %1 und Spalten für %2.</translation>
    </message>
    <message>
        <source>joints to motors</source>
        <translation>Gelenken zu Motoren</translation>
    </message>
    <message>
        <source>motor %1</source>
        <translation>Motor %1</translation>
    </message>
    <message>
        <source>motors to joints</source>
        <translation>Motoren zu Gelenken</translation>
    </message>
    <message>
        <source>of a controller: the joints of its rows or columns, by label (as export --to coupling takes them)</source>
        <translation>einer Steuerung: die Gelenke ihrer Zeilen oder Spalten, nach Nummer (wie export --to coupling sie nimmt)</translation>
    </message>
    <message>
        <source>rows and columns are exchanged: this is the transpose.</source>
        <translation>Zeilen und Spalten sind vertauscht: Das ist die Transponierte.</translation>
    </message>
    <message>
        <source>this is the matrix from %1: the inverse.</source>
        <translation>das ist die Matrix von %1: die Inverse.</translation>
    </message>
    <message>
        <source>this is the matrix of torques, the transposed inverse.</source>
        <translation>das ist die Matrix der Drehmomente, die transponierte Inverse.</translation>
    </message>
    <message>
        <source>which matrix it is: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p or solution (recognised); of a controller: motor-to-joint, joint-to-motor, or coupling for both as JSON</source>
        <translation>welche Matrix es ist: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p oder solution (wird erkannt); einer Steuerung: motor-to-joint, joint-to-motor, oder coupling für beide als JSON</translation>
    </message>
    <message>
        <source>%1 is a whole number.</source>
        <translation>%1 ist eine ganze Zahl.</translation>
    </message>
    <message>
        <source>crossed helical</source>
        <translation>Schraubrad</translation>
    </message>
    <message>
        <source>Make %1 crossed helical</source>
        <translation>%1 zum Schraubradpaar machen</translation>
    </message>
    <message>
        <source>worm</source>
        <translation>Schnecke</translation>
    </message>
    <message>
        <source>Make %1 a worm</source>
        <translation>%1 zur Schnecke machen</translation>
    </message>
    <message>
        <source>Teeth that cross at an angle are no herringbone teeth; mesh &quot;%1&quot; says so: leave it out.</source>
        <translation>Zähne, die sich unter einem Winkel kreuzen, sind keine Pfeilzähne; Zahneingriff „%1“ sagt es: lassen Sie es weg.</translation>
    </message>
    <message>
        <source>The helix of worm &quot;%1&quot; follows from its starts, the module and the distance of the axes: leave the helix angle out.</source>
        <translation>Die Schraubenlinie der Schnecke „%1“ folgt aus ihren Gängen, dem Modul und dem Achsabstand: lassen Sie den Schrägungswinkel weg.</translation>
    </message>
    <message>
        <source>its module %1 does not fit the distance of the axes: their pitch cylinders would not touch. What fits: the module %2.</source>
        <translation>sein Modul %1 passt nicht zum Achsabstand: die Wälzzylinder würden sich nicht berühren. Es passt: der Modul %2.</translation>
    </message>
    <message>
        <source>no helix of this hand makes these teeth with pitch radii of %1 and %2. What fits: the other hand, or no pitch point.</source>
        <translation>keine Schraubenlinie dieser Steigungsrichtung ergibt diese Zähne mit Wälzradien von %1 und %2. Es passt: die andere Richtung, oder kein Wälzpunkt.</translation>
    </message>
    <message>
        <source>a helix angle of %1 degrees leaves %2 for the head&apos;s gear, and at 90 teeth run round their axis. What fits: none, or a smaller one.</source>
        <translation>ein Schrägungswinkel von %1 Grad lässt %2 für das Rad am Kopf, und bei 90 laufen Zähne rund um ihre Achse. Es passt: keiner, oder ein kleinerer.</translation>
    </message>
    <message>
        <source>its pitch point makes pitch radii of %1 and %2, but teeth and helix angles make %3 and %4. What fits: no pitch point, or no helix angle.</source>
        <translation>sein Wälzpunkt ergibt Wälzradien von %1 und %2, aber Zähne und Schrägungswinkel ergeben %3 und %4. Es passt: kein Wälzpunkt, oder kein Schrägungswinkel.</translation>
    </message>
    <message>
        <source>a worm has 1 to %1 starts, fewer than its wheel has teeth; it has %2, and the wheel %3. What fits: other numbers, or crossed helical.</source>
        <translation>eine Schnecke hat 1 bis %1 Gänge, weniger als ihr Rad Zähne hat; sie hat %2, und das Rad %3. Es passt: andere Zahlen, oder ein Schraubradpaar.</translation>
    </message>
    <message>
        <source>it says worm, but its axes cross at %1 degrees. What fits: crossed helical, or axes that cross at 90 degrees.</source>
        <translation>er ist als Schnecke angegeben, aber seine Achsen kreuzen sich unter %1 Grad. Es passt: Schraubrad, oder Achsen, die sich unter 90 Grad kreuzen.</translation>
    </message>
    <message>
        <source>its module %1 gives the wheel a pitch radius of %2, and the axes are %3 apart: that leaves no core for the worm. What fits: a module of at most %4.</source>
        <translation>sein Modul %1 gibt dem Rad einen Wälzradius von %2, und der Achsabstand ist %3: das lässt der Schnecke keinen Kern. Es passt: ein Modul von höchstens %4.</translation>
    </message>
    <message>
        <source>its pitch point lies %1 off the common perpendicular of the axes, where their pitch cylinders touch. What fits: a point on it, or none (then it follows from the axes).</source>
        <translation>sein Wälzpunkt liegt %1 neben dem gemeinsamen Lot der Achsen, auf dem sich ihre Wälzzylinder berühren. Es passt: ein Punkt darauf, oder keiner (dann folgt er aus den Achsen).</translation>
    </message>
    <message>
        <source>its pitch point does not lie between the axes. What fits: a point between them, or none (then it follows from the axes).</source>
        <translation>sein Wälzpunkt liegt nicht zwischen den Achsen. Es passt: ein Punkt dazwischen, oder keiner (dann folgt er aus den Achsen).</translation>
    </message>
    <message>
        <source>its axes are skew, %1 apart: there is no point where the gears could roll. What fits: axes that are parallel or meet, or the kind worm or crossed helical.</source>
        <translation>seine Achsen sind windschief, Abstand %1: es gibt keinen Punkt, in dem die Räder abrollen könnten. Es passen: parallele oder sich schneidende Achsen, oder die Art Schnecke oder Schraubrad.</translation>
    </message>
    <message>
        <source>External, internal (one wheel is a ring), bevel (the axes meet), belt or pins (the wheels do not touch), crossed helical or worm (the axes cross without meeting). Without it the geometry tells which of the first three it is.</source>
        <translation>Außen, innen (ein Rad ist ein Hohlrad), Kegelrad (die Achsen schneiden sich), Riemen oder Bolzen (die Räder berühren sich nicht), Schraubrad oder Schnecke (die Achsen kreuzen sich, ohne sich zu schneiden). Ohne Angabe sagt die Geometrie, welche der ersten drei es ist.</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Schrägungswinkel</translation>
    </message>
    <message>
        <source>Between a tooth and the axis, at the reference cylinder of the first gear. A right-hand helix turns like a common screw. On parallel axes it changes no ratio; on axes that cross, the hands decide which way the gears turn.</source>
        <translation>Zwischen Zahn und Achse, am Teilzylinder des ersten Rades. Eine rechtssteigende Schraubenlinie dreht wie eine gewöhnliche Schraube. Auf parallelen Achsen ändert er keine Übersetzung; auf Achsen, die sich kreuzen, entscheiden die Steigungsrichtungen, wie herum die Räder drehen.</translation>
    </message>
    <message>
        <source>The sign of mesh %1 follows from the hands of its teeth and the way its axes cross.</source>
        <translation>Das Vorzeichen von Zahneingriff %1 folgt aus den Steigungsrichtungen seiner Zähne und daraus, wie seine Achsen sich kreuzen.</translation>
    </message>
    <message>
        <source>Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, let both turn the same way, so that f is %2.</source>
        <translation>Zahneingriff %1 liegt zwischen Achsen, die sich kreuzen: die Steigungsrichtungen seiner Zähne lassen beide Räder, jedes entlang seiner eigenen Achse gesehen, gleich herum drehen, sodass f gleich %2 ist.</translation>
    </message>
    <message>
        <source>Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, let them turn against each other, so that f is %2.</source>
        <translation>Zahneingriff %1 liegt zwischen Achsen, die sich kreuzen: die Steigungsrichtungen seiner Zähne lassen die Räder, jedes entlang seiner eigenen Achse gesehen, gegeneinander drehen, sodass f gleich %2 ist.</translation>
    </message>
    <message>
        <source>Axes that cross at right angles without meeting. The gear with fewer teeth is the worm: they are its starts.</source>
        <translation>Achsen, die sich rechtwinklig kreuzen, ohne sich zu schneiden. Das Rad mit weniger Zähnen ist die Schnecke: sie sind ihre Gänge.</translation>
    </message>
    <message>
        <source>Axes that cross without meeting.</source>
        <translation>Achsen, die sich kreuzen, ohne sich zu schneiden.</translation>
    </message>
    <message>
        <source>Axes that meet.</source>
        <translation>Achsen, die sich schneiden.</translation>
    </message>
    <message>
        <source>Parallel axes.</source>
        <translation>Parallele Achsen.</translation>
    </message>
    <message>
        <source>herringbone</source>
        <translation>Pfeilzähne</translation>
    </message>
    <message>
        <source>The strands cross</source>
        <translation>Die Trume kreuzen sich</translation>
    </message>
    <message>
        <source>Hand of the helix</source>
        <translation>Steigungsrichtung</translation>
    </message>
    <message>
        <source>usual hand</source>
        <translation>übliche Richtung</translation>
    </message>
    <message>
        <source>The hand of the first gear&apos;s teeth. Usual: right-hand, or what fits the axes.</source>
        <translation>Die Steigungsrichtung der Zähne des ersten Rades. Üblich: rechtssteigend, oder was zu den Achsen passt.</translation>
    </message>
    <message>
        <source>The helix changes its hand at the middle of the face, so that no axial force is left.</source>
        <translation>Die Steigungsrichtung wechselt in der Mitte der Zahnbreite, sodass keine Axialkraft bleibt.</translation>
    </message>
    <message>
        <source>The strands cross between the pulleys, which then turn against each other.</source>
        <translation>Die Trume kreuzen sich zwischen den Scheiben, die dann gegeneinander drehen.</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>Change helix angle</source>
        <translation>Schrägungswinkel ändern</translation>
    </message>
    <message>
        <source>Change hand</source>
        <translation>Steigungsrichtung ändern</translation>
    </message>
    <message>
        <source>Change herringbone</source>
        <translation>Pfeilzähne ändern</translation>
    </message>
    <message>
        <source>Cross strands</source>
        <translation>Trume kreuzen</translation>
    </message>
    <message>
        <source>equal on both</source>
        <translation>beide gleich</translation>
    </message>
    <message>
        <source>A cycloidal disc runs on 4 pins or more.</source>
        <translation>Eine Zykloidenscheibe läuft auf 4 oder mehr Bolzen.</translation>
    </message>
    <message>
        <source>A worm has 1 to %1 starts, fewer than its wheel has teeth.</source>
        <translation>Eine Schnecke hat 1 bis %1 Gänge, weniger als ihr Rad Zähne hat.</translation>
    </message>
    <message>
        <source>Worm stage</source>
        <translation>Schneckenstufe</translation>
    </message>
    <message>
        <source>worm wheel</source>
        <translation>Schneckenrad</translation>
    </message>
    <message>
        <source>The pitch of a belt is above 0.</source>
        <translation>Die Teilung eines Riemens ist größer als 0.</translation>
    </message>
    <message>
        <source>Belt drive</source>
        <translation>Riementrieb</translation>
    </message>
    <message>
        <source>driving pulley</source>
        <translation>treibende Scheibe</translation>
    </message>
    <message>
        <source>driven pulley</source>
        <translation>getriebene Scheibe</translation>
    </message>
    <message>
        <source>The circular spline has more teeth than the flexspline, usually two.</source>
        <translation>Der Circular Spline hat mehr Zähne als der Flexspline, meist zwei.</translation>
    </message>
    <message>
        <source>Strain wave drive</source>
        <translation>Wellgetriebe</translation>
    </message>
    <message>
        <source>wave generator</source>
        <translation>Wellengenerator</translation>
    </message>
    <message>
        <source>flexspline</source>
        <translation>Flexspline</translation>
    </message>
    <message>
        <source>Cycloidal drive</source>
        <translation>Zykloidgetriebe</translation>
    </message>
    <message>
        <source>crank</source>
        <translation>Kurbel</translation>
    </message>
    <message>
        <source>cycloidal disc</source>
        <translation>Zykloidenscheibe</translation>
    </message>
    <message>
        <source>RV reducer</source>
        <translation>RV-Getriebe</translation>
    </message>
    <message>
        <source>eccentric</source>
        <translation>Exzenter</translation>
    </message>
    <message>
        <source>Starts of the worm</source>
        <translation>Gänge der Schnecke</translation>
    </message>
    <message>
        <source>Teeth of the wheel</source>
        <translation>Zähne des Rades</translation>
    </message>
    <message>
        <source>Driving pulley</source>
        <translation>Treibende Scheibe</translation>
    </message>
    <message>
        <source>Driven pulley</source>
        <translation>Getriebene Scheibe</translation>
    </message>
    <message>
        <source>Flexspline</source>
        <translation>Flexspline</translation>
    </message>
    <message>
        <source>Circular spline</source>
        <translation>Circular Spline</translation>
    </message>
    <message>
        <source>Pins of the ring</source>
        <translation>Bolzen des Rings</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Planet</source>
        <translation>Planet</translation>
    </message>
    <message>
        <source>One turn of &quot;%1&quot; turns &quot;%2&quot; by %3.</source>
        <translation>Eine Umdrehung von „%1“ dreht „%2“ um %3.</translation>
    </message>
    <message>
        <source>Change its kind: %1</source>
        <translation>Seine Art ändern: %1</translation>
    </message>
    <message>
        <source>Freewheel: %1 cannot overtake %2</source>
        <translation>Freilauf: %1 kann %2 nicht überholen</translation>
    </message>
    <message>
        <source>It locks where the first link would turn faster, about the direction of their axis.</source>
        <translation>Er sperrt, wo das erste Glied schneller drehen würde, um die Richtung ihrer Achse.</translation>
    </message>
    <message>
        <source>Add freewheel</source>
        <translation>Freilauf hinzufügen</translation>
    </message>
    <message>
        <source>Frequencies, or lost motion</source>
        <translation>Frequenzen, oder Totgang</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>The frequencies could not be worked out: %1</source>
        <translation>Die Frequenzen ließen sich nicht berechnen: %1</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: what repeats in their motion appears here.</source>
        <translation>Zeichnen Sie Drehgelenke und Zahneingriffe: was sich in ihrer Bewegung wiederholt, erscheint hier.</translation>
    </message>
    <message>
        <source>Frequencies</source>
        <translation>Frequenzen</translation>
    </message>
    <message>
        <source>Shafts, tooth meshes with harmonics and sidebands, passing planets, hunting tooth and assembly phase</source>
        <translation>Wellen, Zahneingriffe mit Harmonischen und Seitenbändern, vorbeilaufende Planeten, Wiederkehr des Zahnpaars und Montagephase</translation>
    </message>
    <message>
        <source>The same as lines over a logarithmic axis</source>
        <translation>Dieselben als Linien über einer logarithmischen Achse</translation>
    </message>
    <message>
        <source>Lost motion</source>
        <translation>Totgang</translation>
    </message>
    <message>
        <source>How far the outputs turn by the play of the teeth while the inputs are held</source>
        <translation>Wie weit die Abtriebe durch das Spiel der Zähne drehen, während die Antriebe gehalten werden</translation>
    </message>
    <message>
        <source>Export the table to a CSV file</source>
        <translation>Die Tabelle in eine CSV-Datei exportieren</translation>
    </message>
    <message>
        <source>lost-motion.csv</source>
        <translation>totgang.csv</translation>
    </message>
    <message>
        <source>frequencies.csv</source>
        <translation>frequenzen.csv</translation>
    </message>
    <message>
        <source>The state whose couplings are engaged</source>
        <translation>Der Zustand, dessen Kupplungen eingerückt sind</translation>
    </message>
    <message>
        <source>Speed of the input shaft, rpm</source>
        <translation>Drehzahl der Antriebswelle, 1/min</translation>
    </message>
    <message>
        <source>A speed above 0, in turns a minute.</source>
        <translation>Eine Drehzahl über 0, in Umdrehungen je Minute.</translation>
    </message>
    <message>
        <source>Input shaft, rpm</source>
        <translation>Antriebswelle, 1/min</translation>
    </message>
    <message>
        <source>Its speed in turns a minute: frequencies in Hz</source>
        <translation>Ihre Drehzahl in Umdrehungen je Minute: Frequenzen in Hz</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmonische</translation>
    </message>
    <message>
        <source>How many multiples of each tooth mesh are listed</source>
        <translation>Wie viele Vielfache jedes Zahneingriffs aufgeführt werden</translation>
    </message>
    <message>
        <source>Sidebands</source>
        <translation>Seitenbänder</translation>
    </message>
    <message>
        <source>How many sidebands each multiple has on either side</source>
        <translation>Wie viele Seitenbänder jedes Vielfache auf jeder Seite hat</translation>
    </message>
    <message>
        <source>How many equal planets one stands for that is drawn alone</source>
        <translation>Für wie viele gleiche Planeten einer steht, der allein gezeichnet ist</translation>
    </message>
    <message>
        <source>No output can be told from an input here, so that there is no lost motion: drive a joint.</source>
        <translation>Hier ist kein Abtrieb von einem Antrieb zu unterscheiden, also gibt es keinen Totgang: treiben Sie ein Gelenk an.</translation>
    </message>
    <message>
        <source>Minutes of arc from stop to stop, inputs held; &quot;worst&quot; adds all plays, the root of squares is what assemblies show.</source>
        <translation>Winkelminuten von Anschlag zu Anschlag, Antriebe gehalten; „schlimmster“ zählt alle Spiele zusammen, die Wurzel der Quadrate ist, was Baugruppen zeigen.</translation>
    </message>
    <message>
        <source>Cycles for one turn of the %1.</source>
        <translation>Zyklen je Umdrehung der Welle (%1).</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Schwingungen</translation>
    </message>
    <message>
        <source>Frequencies of shafts, tooth meshes and planets, and the motion that the play of the teeth loses.</source>
        <translation>Frequenzen von Wellen, Zahneingriffen und Planeten, und die Bewegung, die das Spiel der Zähne verschluckt.</translation>
    </message>
    <message>
        <source>A worm has one start or more.</source>
        <translation>Eine Schnecke hat einen Gang oder mehr.</translation>
    </message>
    <message>
        <source>%1 starts are too many for a worm; use at most %2, or a pair of helical gears on crossed axes.</source>
        <translation>%1 Gänge sind zu viele für eine Schnecke; nehmen Sie höchstens %2, oder ein Paar schrägverzahnter Räder auf gekreuzten Achsen.</translation>
    </message>
    <message>
        <source>A worm of %1 starts needs a lead angle between 0.3 and 70 degrees, and no profile shift: its wheel has it.</source>
        <translation>Eine Schnecke mit %1 Gängen braucht einen Steigungswinkel zwischen 0,3 und 70 Grad und keine Profilverschiebung: Die hat ihr Rad.</translation>
    </message>
    <message>
        <source>A worm of %1 starts and a pitch diameter of %2 leaves no body below its threads: make it larger than %3.</source>
        <translation>Eine Schnecke mit %1 Gängen und einem Teilkreisdurchmesser von %2 lässt unter ihrem Gewinde keinen Körper übrig: Machen Sie ihn größer als %3.</translation>
    </message>
    <message>
        <source>The threads of a worm of %1 starts would be pointed; use a smaller pressure angle or less height.</source>
        <translation>Die Gänge einer Schnecke mit %1 Gängen würden spitz; nehmen Sie einen kleineren Eingriffswinkel oder weniger Höhe.</translation>
    </message>
    <message>
        <source>The bore of %1 leaves no body below the threads of the worm: make it smaller than %2.</source>
        <translation>Die Bohrung von %1 lässt unter dem Gewinde der Schnecke keinen Körper übrig: Machen Sie sie kleiner als %2.</translation>
    </message>
    <message>
        <source>A worm wheel of %1 teeth needs a worm of fewer starts, at most %2; a pair of helical gears on crossed axes may have any numbers of teeth.</source>
        <translation>Ein Schneckenrad mit %1 Zähnen braucht eine Schnecke mit weniger Gängen, höchstens %2; ein Paar schrägverzahnter Räder auf gekreuzten Achsen darf beliebige Zähnezahlen haben.</translation>
    </message>
    <message>
        <source>The worm of a wheel of %1 teeth is too thin for its throat: make its pitch diameter larger than %2.</source>
        <translation>Die Schnecke eines Rads mit %1 Zähnen ist zu dünn für dessen Kehle: Machen Sie ihren Teilkreisdurchmesser größer als %2.</translation>
    </message>
    <message>
        <source>A worm wheel of %1 teeth is wider than its worm is thick: make its face width at most %2.</source>
        <translation>Ein Schneckenrad mit %1 Zähnen ist breiter, als seine Schnecke dick ist: Machen Sie seine Zahnbreite höchstens %2.</translation>
    </message>
    <message>
        <source>The joint, the link, the brake or the clutch that a torque acts in or on.</source>
        <translation>Das Gelenk, das Glied, die Bremse oder die Kupplung, in oder an der ein Moment wirkt.</translation>
    </message>
    <message>
        <source>The link that the torque acts on, and for a clutch the one that has the reaction.</source>
        <translation>Das Glied, an dem das Moment wirkt, bei einer Kupplung auch das mit der Reaktion.</translation>
    </message>
    <message>
        <source>part in it</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>A motor turns a joint at a given speed, or holds it; its torque is given or found. A load is given, a balance is found. A brake holds its link, a clutch joins two.</source>
        <translation>Ein Motor dreht ein Gelenk mit gegebener Drehgeschwindigkeit oder hält es; sein Moment ist gegeben oder gesucht. Eine Last ist gegeben, ein Ausgleichsmoment gesucht. Eine Bremse hält ihr Glied, eine Kupplung verbindet zwei.</translation>
    </message>
    <message>
        <source>How fast it turns about its axis.</source>
        <translation>Wie schnell es sich um seine Achse dreht.</translation>
    </message>
    <message>
        <source>Torque times rate: what is fed into the train here; below 0: what is taken. A clutch passes power between its links, a brake passes none.</source>
        <translation>Moment mal Drehgeschwindigkeit: was dem Getriebe hier zugeführt wird; unter 0: was entnommen wird. Eine Kupplung leitet Leistung zwischen ihren Gliedern weiter, eine Bremse keine.</translation>
    </message>
    <message>
        <source>held, found</source>
        <translation>gehalten, gesucht</translation>
    </message>
    <message>
        <source>motor, given</source>
        <translation>Motor, gegeben</translation>
    </message>
    <message>
        <source>motor, found</source>
        <translation>Motor, gesucht</translation>
    </message>
    <message>
        <source>balance, found</source>
        <translation>Ausgleich, gesucht</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>An efficiency or a coefficient of friction of a mesh is among its properties; friction becomes an efficiency by the teeth that touch.</source>
        <translation>Wirkungsgrad oder Reibungszahl eines Zahneingriffs stehen unter seinen Eigenschaften; aus der Reibung wird über die Zähne im Eingriff ein Wirkungsgrad.</translation>
    </message>
    <message>
        <source>Coefficient of friction μ = %1 of meshes that state none</source>
        <translation>Reibungszahl μ = %1 der Zahneingriffe ohne eigene Angabe</translation>
    </message>
    <message>
        <source>mesh %1: η = %2</source>
        <translation>Zahneingriff %1: η = %2</translation>
    </message>
    <message>
        <source>mesh %1: μ = %2</source>
        <translation>Zahneingriff %1: μ = %2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>Torque, rate and power where the train is driven, loaded and held</source>
        <translation>Moment, Drehgeschwindigkeit und Leistung, wo das Getriebe angetrieben, belastet und gehalten wird</translation>
    </message>
    <message>
        <source>What every mesh passes, seen from its carrier, and what it loses of that</source>
        <translation>Was jeder Zahneingriff vom Steg aus gesehen weiterleitet und was er davon verliert</translation>
    </message>
    <message>
        <source>Efficiency forward and backward, where the train locks itself, and both over the ratio of two speeds or over the efficiency of the meshes</source>
        <translation>Wirkungsgrad vorwärts und rückwärts, wo das Getriebe selbsthemmend wird, und beide über dem Verhältnis zweier Drehzahlen oder dem Wirkungsgrad der Zahneingriffe</translation>
    </message>
    <message>
        <source>Torques on the gears of every mesh, and tooth forces</source>
        <translation>Momente an den Rädern jedes Zahneingriffs und Zahnkräfte</translation>
    </message>
    <message>
        <source>Losses</source>
        <translation>Verluste</translation>
    </message>
    <message>
        <source>What do I need?</source>
        <translation>Was brauche ich?</translation>
    </message>
    <message>
        <source>The torques at motors, brakes and clutches, as engaged and in each state</source>
        <translation>Die Momente an Motoren, Bremsen und Kupplungen, wie geschaltet und in jedem Schaltzustand</translation>
    </message>
    <message>
        <source>Where does it go?</source>
        <translation>Wohin geht es?</translation>
    </message>
    <message>
        <source>Power, losses, power that circulates, and efficiency forward and backward</source>
        <translation>Leistung, Verluste, Blindleistung und Wirkungsgrad vorwärts und rückwärts</translation>
    </message>
    <message>
        <source>What do parts carry?</source>
        <translation>Was tragen die Teile?</translation>
    </message>
    <message>
        <source>The forces on teeth and bearings</source>
        <translation>Die Kräfte an Zähnen und Lagern</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>The cutset whose torques balance, and the row of speeds with its column of torques</source>
        <translation>Die Schnittmenge, deren Momente sich aufheben, und die Zeile der Drehzahlen mit ihrer Spalte der Momente</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Schaltzustand</translation>
    </message>
    <message>
        <source>No load acts and nothing is held: add a load.</source>
        <translation>Keine Last wirkt und nichts wird gehalten: fügen Sie eine Last hinzu.</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Show or hide the loads that act on the train</source>
        <translation>Die Lasten zeigen oder verbergen, die am Getriebe wirken</translation>
    </message>
    <message>
        <source>Unit of the loads</source>
        <translation>Einheit der Lasten</translation>
    </message>
    <message>
        <source>Loads: %1</source>
        <translation>Lasten: %1</translation>
    </message>
    <message>
        <source>Found at %1 ▾</source>
        <translation>Gesucht an %1 ▾</translation>
    </message>
    <message>
        <source>Found at %1 places ▾</source>
        <translation>Gesucht an %1 Stellen ▾</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>What is asked about the torques</source>
        <translation>Was nach den Momenten gefragt wird</translation>
    </message>
    <message>
        <source>Choose a joint or a mesh in the list above, in a table or in a drawing.</source>
        <translation>Wählen Sie ein Gelenk oder einen Zahneingriff in der Liste oben, in einer Tabelle oder in einer Zeichnung.</translation>
    </message>
    <message>
        <source>Joint or mesh that is explained</source>
        <translation>Gelenk oder Zahneingriff, das erklärt wird</translation>
    </message>
    <message>
        <source>The joint or the mesh whose torque is explained; it is selected in all views</source>
        <translation>Das Gelenk oder der Zahneingriff, dessen Moment erklärt wird; in allen Ansichten ausgewählt</translation>
    </message>
    <message>
        <source>All torques are found twice, by the cutsets of the Matroid method and by those of the T–T graph.</source>
        <translation>Alle Momente werden zweimal bestimmt: mit den Schnittmengen der Matroid-Methode und mit denen des T–T-Graphen.</translation>
    </message>
    <message>
        <source>The cutset: which torques balance</source>
        <translation>Die Schnittmenge: welche Momente sich aufheben</translation>
    </message>
    <message>
        <source>A joint cuts off links from the ground: all torques that cross add up to 0. Of a mesh: which gear drives.</source>
        <translation>Ein Gelenk trennt Glieder vom Gestell: alle Momente über den Schnitt ergeben zusammen 0. Bei einem Zahneingriff: welches Rad treibt.</translation>
    </message>
    <message>
        <source>The row of speeds and its column of torques</source>
        <translation>Die Zeile der Drehzahlen und ihre Spalte der Momente</translation>
    </message>
    <message>
        <source>A row of P holds the speeds of a mesh, a column the torque in a joint; one entry is in both.</source>
        <translation>Eine Zeile von P enthält die Drehzahlen eines Zahneingriffs, eine Spalte das Moment in einem Gelenk; ein Eintrag steht in beiden.</translation>
    </message>
    <message>
        <source>choose a joint or a mesh</source>
        <translation>Gelenk oder Zahneingriff wählen</translation>
    </message>
    <message>
        <source>mesh %1: %2, %3</source>
        <translation>Zahneingriff %1: %2, %3</translation>
    </message>
    <message>
        <source>The link that drives in the state.</source>
        <translation>Das Glied, das in dem Schaltzustand antreibt.</translation>
    </message>
    <message>
        <source>The link that is driven in the state.</source>
        <translation>Das Glied, das in dem Schaltzustand angetrieben wird.</translation>
    </message>
    <message>
        <source>The brakes and clutches that it engages.</source>
        <translation>Die Bremsen und Kupplungen, die er schließt.</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving; none while the meshes state no losses</source>
        <translation>Entnommene durch zugeführte Leistung, wenn der Antrieb antreibt; keiner, solange die Zahneingriffe keine Verluste angeben</translation>
    </message>
    <message>
        <source>beside</source>
        <translation>neben</translation>
    </message>
    <message>
        <source>State that is compared</source>
        <translation>Verglichener Schaltzustand</translation>
    </message>
    <message>
        <source>A state of the gearbox that is compared with the other one</source>
        <translation>Ein Schaltzustand des Getriebes, der mit dem anderen verglichen wird</translation>
    </message>
    <message>
        <source>Two states side by side</source>
        <translation>Zwei Schaltzustände nebeneinander</translation>
    </message>
    <message>
        <source>speed in joint %1, link %2</source>
        <translation>Drehzahl in Gelenk %1, Glied %2</translation>
    </message>
    <message>
        <source>How fast the head turns against the tail, for 1 at the drive</source>
        <translation>Wie schnell sich die Spitze gegen den Fuß dreht, bei 1 am Antrieb</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>The ratio of the one state over that of the other</source>
        <translation>Die Übersetzung des einen durch die des anderen</translation>
    </message>
    <message>
        <source>%1, N m</source>
        <translation>%1, N m</translation>
    </message>
    <message>
        <source>The largest ratio over the smallest, of the states that turn forward</source>
        <translation>Die größte Übersetzung durch die kleinste, der Vorwärtsgänge</translation>
    </message>
    <message>
        <source>spread %1</source>
        <translation>Spreizung %1</translation>
    </message>
    <message>
        <source>Compare states</source>
        <translation>Zustände vergleichen</translation>
    </message>
    <message>
        <source>Two states side by side: ratios, torques, efficiencies, speeds</source>
        <translation>Zwei Schaltzustände nebeneinander: Übersetzungen, Momente, Wirkungsgrade, Drehzahlen</translation>
    </message>
    <message>
        <source>Export the table with drive, driven, what is engaged and steps to a CSV file</source>
        <translation>Die Tabelle mit Antrieb, Abtrieb, geschlossenen Schaltelementen und Stufensprüngen als CSV-Datei exportieren</translation>
    </message>
    <message>
        <source>A part of the mechanism has no form that prints.</source>
        <translation>Ein Teil des Mechanismus hat keine druckbare Form.</translation>
    </message>
    <message>
        <source>Printed parts would overlap.</source>
        <translation>Gedruckte Teile würden sich überschneiden.</translation>
    </message>
    <message>
        <source>A part does not fit the plate.</source>
        <translation>Ein Teil passt nicht auf die Platte.</translation>
    </message>
    <message>
        <source>--bed is a width and a depth in mm from %1 to %2, like 220x220.</source>
        <translation>--bed ist eine Breite und eine Tiefe in mm von %1 bis %2, etwa 220x220.</translation>
    </message>
    <message>
        <source>the print kit</source>
        <translation>der Druckbausatz</translation>
    </message>
    <message>
        <source>--to kit writes a folder; &quot;-&quot; is none.</source>
        <translation>--to kit schreibt einen Ordner; &quot;-&quot; ist keiner.</translation>
    </message>
    <message>
        <source>%1 parts on %2 plate(s).</source>
        <translation>%1 Teile auf %2 Platte(n).</translation>
    </message>
    <message>
        <source>Print kit: parts for a 3D printer</source>
        <translation>Druckbausatz: Teile für einen 3D-Drucker</translation>
    </message>
    <message>
        <source>parts for a 3D printer, with their assembly</source>
        <translation>Teile für einen 3D-Drucker, mit ihrem Zusammenbau</translation>
    </message>
    <message>
        <source>Print kits</source>
        <translation>Druckbausätze</translation>
    </message>
    <message>
        <source>Axes of the ground have several directions; a base holds one.</source>
        <translation>Achsen des Gestells haben mehrere Richtungen; eine Grundplatte hält eine.</translation>
    </message>
    <message>
        <source>The wheel %1 is fixed to the ground, for which the kit has no part.</source>
        <translation>Das Rad %1 ist am Gestell fest; dafür hat der Bausatz kein Teil.</translation>
    </message>
    <message>
        <source>The ring %1 is too near to the base.</source>
        <translation>Das Hohlrad %1 ist der Grundplatte zu nah.</translation>
    </message>
    <message>
        <source>There is no room for posts beside what turns.</source>
        <translation>Neben dem, was sich dreht, ist kein Platz für Säulen.</translation>
    </message>
    <message>
        <source>Parts reach below the lowest bearing of the ground, so that no base fits there; move that joint along its axis.</source>
        <translation>Teile reichen unter das unterste Lager des Gestells, so dass dort keine Grundplatte passt; das Gelenk längs seiner Achse verschieben.</translation>
    </message>
    <message>
        <source>A bearing of link %1 is too near to its arm for a printed pedestal.</source>
        <translation>Ein Lager von Glied %1 ist seinem Arm zu nah für einen gedruckten Lagerbock.</translation>
    </message>
    <message>
        <source>An arm of link %1 is neither parallel nor at right angles to its bearing.</source>
        <translation>Ein Arm von Glied %1 steht weder parallel noch rechtwinklig zu seinem Lager.</translation>
    </message>
    <message>
        <source>There are no wheels to print.</source>
        <translation>Es gibt keine Räder zu drucken.</translation>
    </message>
    <message>
        <source>Belts are not printed.</source>
        <translation>Riemen werden nicht gedruckt.</translation>
    </message>
    <message>
        <source>The train is too large for a kit.</source>
        <translation>Das Getriebe ist zu groß für einen Bausatz.</translation>
    </message>
    <message>
        <source>Links overlap in 3D, so their printed parts would too.</source>
        <translation>Glieder überschneiden sich in 3D, also auch ihre gedruckten Teile.</translation>
    </message>
    <message>
        <source>Several rings on one axis are joined by drums around each other, which the kit cannot divide.</source>
        <translation>Mehrere Hohlräder auf einer Achse sind durch Trommeln umeinander verbunden, die der Bausatz nicht teilen kann.</translation>
    </message>
    <message>
        <source>A link turns on a pin across the axis of another, for which the kit has no part.</source>
        <translation>Ein Glied dreht sich auf einem Bolzen quer zur Achse eines anderen; dafür hat der Bausatz kein Teil.</translation>
    </message>
    <message>
        <source>The wheel %1 has no teeth.</source>
        <translation>Das Rad %1 hat keine Zähne.</translation>
    </message>
    <message>
        <source>The bevel %1 has so flat or so steep a cone that it does not print on a face.</source>
        <translation>Das Kegelrad %1 hat einen so flachen oder so steilen Kegel, dass es auf keiner Stirnseite druckbar ist.</translation>
    </message>
    <message>
        <source>Link %1 turns on a pin of link %2, for which the kit has no part.</source>
        <translation>Glied %1 dreht sich auf einem Bolzen von Glied %2; dafür hat der Bausatz kein Teil.</translation>
    </message>
    <message>
        <source>The face of wheel %1 is %2 mm instead of %3 mm, so that it clears %4.</source>
        <translation>Die Zahnbreite von Rad %1 ist %2 mm statt %3 mm, damit es an %4 vorbeikommt.</translation>
    </message>
    <message>
        <source>The ring %1 is joined to its link by more than a disc.</source>
        <translation>Das Hohlrad %1 ist mit seinem Glied durch mehr als eine Scheibe verbunden.</translation>
    </message>
    <message>
        <source>The wheel %1 is on no shaft of its link.</source>
        <translation>Das Rad %1 sitzt auf keiner Welle seines Glieds.</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>ring gear</source>
        <translation>Hohlrad</translation>
    </message>
    <message>
        <source>arm or carrier plate</source>
        <translation>Arm oder Stegplatte</translation>
    </message>
    <message>
        <source>pedestal with a tenon</source>
        <translation>Lagerbock mit Zapfen</translation>
    </message>
    <message>
        <source>base plate</source>
        <translation>Grundplatte</translation>
    </message>
    <message>
        <source>bridge</source>
        <translation>Brücke</translation>
    </message>
    <message>
        <source>post</source>
        <translation>Säule</translation>
    </message>
    <message>
        <source>spacer</source>
        <translation>Abstandsring</translation>
    </message>
    <message>
        <source>clip, pressed on</source>
        <translation>Klemmring, aufgepresst</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Graviert</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>All parts lie on a flat face and need no supports: nothing hangs over by more than %1 degrees from the upright.</source>
        <translation>Alle Teile liegen auf einer ebenen Fläche und brauchen keine Stützen: nichts hängt um mehr als %1 Grad gegen die Senkrechte über.</translation>
    </message>
    <message>
        <source>Supports are needed below the teeth of: %1.</source>
        <translation>Stützen sind nötig unter den Zähnen von: %1.</translation>
    </message>
    <message>
        <source>Shafts and screws</source>
        <translation>Wellen und Schrauben</translation>
    </message>
    <message>
        <source>Shafts are printed lying on their flat, which keys what is pressed on them. Round rods of the same diameter do as well, with a flat filed to the same depth.</source>
        <translation>Wellen werden liegend auf ihrer Abflachung gedruckt, die das Aufgepresste gegen Verdrehen sichert. Rundstäbe desselben Durchmessers gehen auch, mit einer gleich tief gefeilten Fläche.</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Durchmesser, mm</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Länge, mm</translation>
    </message>
    <message>
        <source>No screws are needed.</source>
        <translation>Schrauben sind nicht nötig.</translation>
    </message>
    <message>
        <source>%1 countersunk screws M%2 × %3, which cut their thread in the part</source>
        <translation>%1 Senkschrauben M%2 × %3, die ihr Gewinde in das Teil schneiden</translation>
    </message>
    <message>
        <source>the space with %1 square(s) on %2</source>
        <translation>die Lücke mit %1 Quadrat(en) auf %2</translation>
    </message>
    <message>
        <source>the tooth with %1 dot(s) on %2</source>
        <translation>der Zahn mit %1 Punkt(en) auf %2</translation>
    </message>
    <message>
        <source>the space after tooth %1 of %2 (no room for a mark)</source>
        <translation>die Lücke nach Zahn %1 von %2 (kein Platz für eine Marke)</translation>
    </message>
    <message>
        <source>tooth %1 of %2 (no room for a mark)</source>
        <translation>Zahn %1 von %2 (kein Platz für eine Marke)</translation>
    </message>
    <message>
        <source>Teeth that meet</source>
        <translation>Zähne, die zusammenkommen</translation>
    </message>
    <message>
        <source>Put the wheels together with each marked tooth in the marked space. All marks meet at once in the pose of assembly.3mf.</source>
        <translation>Setzen Sie die Räder so zusammen, dass jeder markierte Zahn in der markierten Lücke steht. Alle Marken treffen sich zugleich in der Lage von assembly.3mf.</translation>
    </message>
    <message>
        <source>Mesh %1: %2 goes into %3.</source>
        <translation>Zahneingriff %1: %2 gehört in %3.</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>von unten</translation>
    </message>
    <message>
        <source>along (%1, %2, %3)</source>
        <translation>längs (%1, %2, %3)</translation>
    </message>
    <message>
        <source>Order of assembly</source>
        <translation>Reihenfolge des Zusammenbaus</translation>
    </message>
    <message>
        <source>Each part comes to its place past all those before it, as assembly.3mf shows it. Turn wheels a little where teeth meet.</source>
        <translation>Jedes Teil kommt an allen früheren vorbei an seinen Platz, wie assembly.3mf ihn zeigt. Räder ein wenig drehen, wo Zähne zusammenkommen.</translation>
    </message>
    <message>
        <source>no straight way was found free; bend or turn it in</source>
        <translation>es fand sich kein gerader freier Weg; biegen oder eindrehen</translation>
    </message>
    <message>
        <source>Plate %1</source>
        <translation>Platte %1</translation>
    </message>
    <message>
        <source>Print kit</source>
        <translation>Druckbausatz</translation>
    </message>
    <message>
        <source>Print kit: %1</source>
        <translation>Druckbausatz: %1</translation>
    </message>
    <message>
        <source>Play %1 mm on each flank, bores %2 mm wider than their shafts, first layers narrower by %3 mm, scale %4. Lengths are in mm.</source>
        <translation>Spiel %1 mm an jeder Flanke, Bohrungen %2 mm weiter als ihre Wellen, erste Schichten um %3 mm schmaler, Maßstab %4. Längen sind in mm.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; measures %2 mm by %3 mm and does not fit the plate; scale the kit down.</source>
        <translation>&quot;%1&quot; misst %2 mm mal %3 mm und passt nicht auf die Platte; den Bausatz verkleinern.</translation>
    </message>
    <message>
        <source>Printed, &quot;%1&quot; and &quot;%2&quot; would overlap.</source>
        <translation>Gedruckt würden sich &quot;%1&quot; und &quot;%2&quot; überschneiden.</translation>
    </message>
    <message>
        <source>The ground has no bearing that a base could hold.</source>
        <translation>Das Gestell hat kein Lager, das eine Grundplatte halten könnte.</translation>
    </message>
    <message>
        <source>Edges of &quot;%1&quot; cross each other at this size; try another scale.</source>
        <translation>Kanten von &quot;%1&quot; überkreuzen sich in dieser Größe; einen anderen Maßstab versuchen.</translation>
    </message>
    <message>
        <source>the plate of the printer, mm (220x220)</source>
        <translation>die Platte des Druckers, mm (220x220)</translation>
    </message>
    <message>
        <source>Plate of the printer</source>
        <translation>Platte des Druckers</translation>
    </message>
    <message>
        <source>play on either flank of a tooth, mm (0.15)</source>
        <translation>Spiel an jeder Flanke eines Zahns, mm (0.15)</translation>
    </message>
    <message>
        <source>Play of the teeth</source>
        <translation>Spiel der Zähne</translation>
    </message>
    <message>
        <source>by which bores are wider than their shafts, mm (0.2)</source>
        <translation>um wie viel Bohrungen weiter sind als ihre Wellen, mm (0.2)</translation>
    </message>
    <message>
        <source>Clearance of bores</source>
        <translation>Spiel der Bohrungen</translation>
    </message>
    <message>
        <source>by which the lowest layers are narrower, against their spread, mm (0.4)</source>
        <translation>um wie viel die untersten Schichten schmaler sind, gegen ihr Breitlaufen, mm (0.4)</translation>
    </message>
    <message>
        <source>Chamfer of first layers</source>
        <translation>Fase der ersten Schichten</translation>
    </message>
    <message>
        <source>by which all lengths are multiplied (1)</source>
        <translation>womit alle Längen multipliziert werden (1)</translation>
    </message>
    <message>
        <source>sign of a belt</source>
        <translation>Vorzeichen eines Riemens</translation>
    </message>
    <message>
        <source>sign of pins in holes</source>
        <translation>Vorzeichen von Bolzen in Löchern</translation>
    </message>
    <message>
        <source>sign of gears on axes that cross</source>
        <translation>Vorzeichen von Rädern auf Achsen, die sich kreuzen</translation>
    </message>
    <message>
        <source>stated: which teeth were meant?</source>
        <translation>angegeben: Welche Zähne waren gemeint?</translation>
    </message>
    <message>
        <source>The ratios are those that somebody states, and the drawn teeth are in doubt: looks for teeth near them with all of these ratios, by the fewest wheels</source>
        <translation>Die Übersetzungen sind die angegebenen, und die gezeichneten Zähnezahlen sind fraglich: sucht in ihrer Nähe Zähnezahlen mit all diesen Übersetzungen, mit möglichst wenigen anderen Rädern</translation>
    </message>
    <message>
        <source>Wheels that may differ from the drawn ones</source>
        <translation>Räder, die von den gezeichneten abweichen dürfen</translation>
    </message>
    <message>
        <source>Teeth by which each of them may differ</source>
        <translation>Zähne, um die jedes von ihnen abweichen darf</translation>
    </message>
    <message>
        <source>Wheels that differ</source>
        <translation>Abweichende Räder</translation>
    </message>
    <message>
        <source>Teeth apart</source>
        <translation>Zähne Abstand</translation>
    </message>
    <message>
        <source>All %1 choices near the drawn teeth tried: complete</source>
        <translation>Alle %1 Möglichkeiten nahe den gezeichneten Zähnezahlen geprüft: vollständig</translation>
    </message>
    <message>
        <source>Ratio %1 of the drawn teeth: %2, as stated</source>
        <translation>Übersetzung %1 der gezeichneten Zähne: %2, wie angegeben</translation>
    </message>
    <message>
        <source>Ratio %1 of the drawn teeth: %2, not the stated one</source>
        <translation>Übersetzung %1 der gezeichneten Zähne: %2, nicht die angegebene</translation>
    </message>
    <message>
        <source>Wheels that differ: %1, choices: %2</source>
        <translation>Abweichende Räder: %1, Möglichkeiten: %2</translation>
    </message>
    <message>
        <source>No teeth near the drawn ones have all stated ratios. More wheels that may differ, or by more teeth, give more.</source>
        <translation>Keine Zähnezahlen nahe den gezeichneten haben alle angegebenen Übersetzungen. Mehr abweichende Räder oder mehr Zähne Abstand ergeben mehr.</translation>
    </message>
    <message>
        <source>The likeliest first: the fewest teeth more or less, then the smallest error</source>
        <translation>Die wahrscheinlichsten zuerst: die wenigsten Zähne mehr oder weniger, dann die kleinste Abweichung</translation>
    </message>
    <message>
        <source>%1 of %2 chains; equations: %3</source>
        <translation>%1 von %2 Ketten; Gleichungen: %3</translation>
    </message>
    <message>
        <source>links: %1, axes: %2, gear pairs: %3</source>
        <translation>Glieder: %1, Achsen: %2, Radpaare: %3</translation>
    </message>
    <message>
        <source>links: %1, axes: %2, gear pairs: %3; freedom %4 with one link held</source>
        <translation>Glieder: %1, Achsen: %2, Radpaare: %3; Freiheitsgrad %4 mit einem festen Glied</translation>
    </message>
    <message>
        <source>Trees, inputs and frames</source>
        <translation>Bäume, Antriebe und Gestelle</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>Vergleichen mit…</translation>
    </message>
    <message>
        <source>Which link is which</source>
        <translation>Welches Glied welches ist</translation>
    </message>
    <message>
        <source>Lists all trees of turning joints, valid sets of inputs and frames with which your train can be drawn</source>
        <translation>Listet alle Bäume von Drehgelenken, gültigen Sätze von Antrieben und Gestelle auf, mit denen Ihr Getriebe gezeichnet werden kann</translation>
    </message>
    <message>
        <source>Is the train of another document the same chain, and which link is which?</source>
        <translation>Ist das Getriebe eines anderen Dokuments dieselbe Kette, und welches Glied ist welches?</translation>
    </message>
    <message>
        <source>your train</source>
        <translation>Ihr Getriebe</translation>
    </message>
    <message>
        <source>the other one</source>
        <translation>das andere</translation>
    </message>
    <message>
        <source>Valid sets of inputs: %1</source>
        <translation>Gültige Sätze von Antrieben: %1</translation>
    </message>
    <message>
        <source>GearGraph documents (*.geargraph)</source>
        <translation>GearGraph-Dokumente (*.geargraph)</translation>
    </message>
    <message>
        <source>%1 is a different chain.</source>
        <translation>%1 ist eine andere Kette.</translation>
    </message>
    <message>
        <source>%1 is the same chain.</source>
        <translation>%1 ist dieselbe Kette.</translation>
    </message>
    <message>
        <source>%1 has the same equations, on other shafts.</source>
        <translation>%1 hat dieselben Gleichungen, auf anderen Wellen.</translation>
    </message>
    <message>
        <source>Digraph of your train</source>
        <translation>Digraph Ihres Getriebes</translation>
    </message>
    <message>
        <source>Digraph of the other train, with the colours of your links</source>
        <translation>Digraph des anderen Getriebes, mit den Farben Ihrer Glieder</translation>
    </message>
    <message>
        <source>Schematic of chain %1</source>
        <translation>Schema der Kette %1</translation>
    </message>
    <message>
        <source>Chain %1 in three dimensions</source>
        <translation>Kette %1 in drei Dimensionen</translation>
    </message>
    <message>
        <source>Laid out by rule, with teeth that are no special ones</source>
        <translation>Nach Regeln angeordnet, mit Zähnezahlen ohne besonderes Verhältnis</translation>
    </message>
    <message>
        <source>The trains are too large to be compared.</source>
        <translation>Die Getriebe sind zu groß für einen Vergleich.</translation>
    </message>
    <message>
        <source>A face gear has more teeth than its pinion.</source>
        <translation>Ein Kronrad hat mehr Zähne als sein Ritzel.</translation>
    </message>
    <message>
        <source>Face gear drive</source>
        <translation>Kronradgetriebe</translation>
    </message>
    <message>
        <source>face gear</source>
        <translation>Kronrad</translation>
    </message>
    <message>
        <source>The gear of an axle has more teeth than its pinion.</source>
        <translation>Das Tellerrad einer Achse hat mehr Zähne als ihr Ritzel.</translation>
    </message>
    <message>
        <source>Hypoid axle</source>
        <translation>Hypoidachse</translation>
    </message>
    <message>
        <source>axle gear</source>
        <translation>Tellerrad</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) is drawn as its pitch cone: the teeth of hypoid gears are not made here. Motion, torques and forces are those of the teeth.</source>
        <translation>Zahnrad %1 (%2 Zähne) ist als sein Wälzkegel gezeichnet: die Zähne von Hypoidrädern werden hier nicht erzeugt. Bewegung, Momente und Kräfte sind die der Zähne.</translation>
    </message>
    <message>
        <source>Make %1 a face gear</source>
        <translation>%1 zum Kronradpaar machen</translation>
    </message>
    <message>
        <source>hypoid</source>
        <translation>Hypoid</translation>
    </message>
    <message>
        <source>Make %1 hypoid</source>
        <translation>%1 zum Hypoidpaar machen</translation>
    </message>
    <message>
        <source>The teeth of a face gear are straight, and those of a hypoid pair follow from its pitch point; mesh &quot;%1&quot; says otherwise: leave it out.</source>
        <translation>Die Zähne eines Kronrads sind gerade, und die eines Hypoidpaars folgen aus seinem Wälzpunkt; der Zahneingriff „%1“ sagt etwas anderes: lassen Sie es weg.</translation>
    </message>
    <message>
        <source>it has herringbone teeth, but its axes meet. What fits: a helix angle alone, or none.</source>
        <translation>er hat Pfeilzähne, aber seine Achsen schneiden sich. Es passt: ein Schrägungswinkel allein, oder keiner.</translation>
    </message>
    <message>
        <source>it has a helix angle, but the pinion of a face gear has straight teeth here. What fits: none.</source>
        <translation>er hat einen Schrägungswinkel, aber das Ritzel eines Kronrads hat hier gerade Zähne. Es passt: keiner.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet at %2 degrees. What fits: bevel, or axes that meet at 90 degrees.</source>
        <translation>er ist als %1 angegeben, aber seine Achsen schneiden sich unter %2 Grad. Es passt: Kegelräder, oder Achsen, die sich unter 90 Grad schneiden.</translation>
    </message>
    <message>
        <source>a face gear has more teeth than its pinion; both have %1. What fits: other numbers, or bevel.</source>
        <translation>ein Kronrad hat mehr Zähne als sein Ritzel; beide haben %1. Es passt: andere Zahlen, oder Kegelräder.</translation>
    </message>
    <message>
        <source>The spiral teeth of gear %1 have no exact faces here; STL and GLB have them.</source>
        <translation>Die Spiralzähne von Zahnrad %1 haben hier keine exakten Flächen; STL und GLB haben sie.</translation>
    </message>
    <message>
        <source>The teeth of face gear %1 have no exact faces here; STL and GLB have them.</source>
        <translation>Die Zähne des Kronrads %1 haben hier keine exakten Flächen; STL und GLB haben sie.</translation>
    </message>
    <message>
        <source>Spiral teeth and face gears are not printed: gear %1.</source>
        <translation>Spiralzähne und Kronräder werden nicht gedruckt: Zahnrad %1.</translation>
    </message>
    <message>
        <source>The sign of face gear mesh %1 follows from where its pitch point is, seen from both axes.</source>
        <translation>Das Vorzeichen des Kronradeingriffs %1 folgt daraus, wo sein Wälzpunkt von beiden Achsen aus gesehen liegt.</translation>
    </message>
    <message>
        <source>The sign of face gear mesh %1 follows from its pitch point, seen from both axes.</source>
        <translation>Das Vorzeichen des Kronradeingriffs %1 folgt aus seinem Wälzpunkt, von beiden Achsen aus gesehen.</translation>
    </message>
    <message>
        <source>Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, they turn the same way, so that f is %2.</source>
        <translation>Zahneingriff %1 ist ein Kronrad mit seinem Ritzel: vom Steg aus gesehen, jedes längs seiner eigenen Achse, drehen sie gleichsinnig, also ist f gleich %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, they turn against each other, so that f is %2.</source>
        <translation>Zahneingriff %1 ist ein Kronrad mit seinem Ritzel: vom Steg aus gesehen, jedes längs seiner eigenen Achse, drehen sie gegensinnig, also ist f gleich %2.</translation>
    </message>
    <message>
        <source>The sign of hypoid mesh %1 follows from the half axes beside which its pitch point is, as if the axes met.</source>
        <translation>Das Vorzeichen des Hypoideingriffs %1 folgt aus den Halbachsen, neben denen sein Wälzpunkt liegt, als schnitten sich die Achsen.</translation>
    </message>
    <message>
        <source>The sign of hypoid mesh %1 follows from the half axes beside its pitch point.</source>
        <translation>Das Vorzeichen des Hypoideingriffs %1 folgt aus den Halbachsen neben seinem Wälzpunkt.</translation>
    </message>
    <message>
        <source>Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn the same way, so that f is %2.</source>
        <translation>Zahneingriff %1 ist ein Hypoideingriff: vom Steg aus gesehen, jedes längs seiner eigenen Achse, drehen seine Räder gleichsinnig, also ist f gleich %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn against each other, so that f is %2.</source>
        <translation>Zahneingriff %1 ist ein Hypoideingriff: vom Steg aus gesehen, jedes längs seiner eigenen Achse, drehen seine Räder gegensinnig, also ist f gleich %2.</translation>
    </message>
    <message>
        <source>Axes that meet at right angles. The gear with fewer teeth is the pinion.</source>
        <translation>Achsen, die sich rechtwinklig schneiden. Das Rad mit weniger Zähnen ist das Ritzel.</translation>
    </message>
    <message>
        <source>Axes that cross at right angles without meeting, or at any angle with a pitch point.</source>
        <translation>Achsen, die sich rechtwinklig kreuzen, ohne sich zu schneiden, oder unter beliebigem Winkel mit einem Wälzpunkt.</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Ritzel</translation>
    </message>
    <message>
        <source>Face gear</source>
        <translation>Kronrad</translation>
    </message>
    <message>
        <source>Axle gear</source>
        <translation>Tellerrad</translation>
    </message>
    <message>
        <source>Spiral angle</source>
        <translation>Spiralwinkel</translation>
    </message>
    <message>
        <source>The face of %1 is wider than the teeth of a face gear are, or leaves none: make it at most %2.</source>
        <translation>Die Breite von %1 ist größer, als die Zähne eines Kronrads sind, oder lässt keine: höchstens %2.</translation>
    </message>
    <message>
        <source>it says hypoid, but its axes cross at %1 degrees. What fits: axes that cross at 90 degrees, or a pitch point of its own.</source>
        <translation>er ist als Hypoid angegeben, aber seine Achsen kreuzen sich unter %1 Grad. Es passt: Achsen, die sich unter 90 Grad kreuzen, oder ein eigener Wälzpunkt.</translation>
    </message>
    <message>
        <source>its axes are %1 apart, too far for a gear of %2 teeth and module %3. What fits: a module of at least %4, or axes nearer to each other.</source>
        <translation>seine Achsen haben den Abstand %1, zu viel für ein Rad mit %2 Zähnen und Modul %3. Es passt: ein Modul von mindestens %4, oder ein kleinerer Achsabstand.</translation>
    </message>
    <message>
        <source>its pitch point leaves one gear no cone: it lies on an axis, or beside the common perpendicular of both. What fits: a point farther out along both axes, or none (then it follows from the axes).</source>
        <translation>sein Wälzpunkt lässt einem Rad keinen Kegel: er liegt auf einer Achse oder neben dem gemeinsamen Lot beider. Es passt: ein Punkt weiter außen längs beider Achsen, oder keiner (dann folgt er aus den Achsen).</translation>
    </message>
    <message>
        <source>its pitch point asks for a spiral angle of %1 degrees, and at 90 teeth run round their axis. What fits: a point whose distances from the axes are nearer to the ratio of the teeth, or none.</source>
        <translation>sein Wälzpunkt verlangt einen Spiralwinkel von %1 Grad, und bei 90 laufen Zähne um ihre Achse herum. Es passt: ein Punkt, dessen Abstände von den Achsen dem Verhältnis der Zähne näher sind, oder keiner.</translation>
    </message>
    <message>
        <source>%1 joints, of which %2 slide</source>
        <translation>%1 Gelenke, davon %2 Schubgelenke</translation>
    </message>
    <message>
        <source>travel of link %1 per radian of link %2: %3 %4</source>
        <translation>Weg von Glied %1 je Radiant von Glied %2: %3 %4</translation>
    </message>
    <message>
        <source>slides along axis %1</source>
        <translation>gleitet entlang Achse %1</translation>
    </message>
    <message>
        <source>The command %1 does not cover sliding joints, and &quot;%2&quot; has some.</source>
        <translation>Der Befehl %1 kennt keine Schubgelenke, und „%2“ hat welche.</translation>
    </message>
    <message>
        <source>%1 is like 9=20%2: an input&apos;s label and its travel in the document&apos;s unit.</source>
        <translation>%1 ist wie 9=20%2: die Nummer eines Antriebs und sein Weg in der Einheit des Dokuments.</translation>
    </message>
    <message>
        <source>Joint %1 turns: its angle is given by --angle.</source>
        <translation>Gelenk %1 dreht sich: sein Winkel wird mit --angle angegeben.</translation>
    </message>
    <message>
        <source>Joint %1 slides: its travel is given by --travel.</source>
        <translation>Gelenk %1 gleitet: sein Weg wird mit --travel angegeben.</translation>
    </message>
    <message>
        <source>%1 moved by %2 %3</source>
        <translation>%1 um %2 %3 verschoben</translation>
    </message>
    <message>
        <source>the travel of an input that slides, in the document&apos;s unit; may be repeated</source>
        <translation>der Weg eines Antriebs, der gleitet, in der Einheit des Dokuments; mehrfach möglich</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1 at %2 %3</source>
        <translation>%1 mit %2 %3</translation>
    </message>
    <message>
        <source>&quot;turning&quot; or &quot;sliding&quot;</source>
        <translation>&quot;turning&quot; oder &quot;sliding&quot;</translation>
    </message>
    <message>
        <source>turning, sliding or nothing</source>
        <translation>turning, sliding oder nichts</translation>
    </message>
    <message>
        <source>rack</source>
        <translation>Zahnstange</translation>
    </message>
    <message>
        <source>Make %1 a rack and pinion</source>
        <translation>%1 zu Zahnstange und Ritzel machen</translation>
    </message>
    <message>
        <source>screw</source>
        <translation>Gewindespindel</translation>
    </message>
    <message>
        <source>Make %1 a screw and nut</source>
        <translation>%1 zu Spindel und Mutter machen</translation>
    </message>
    <message>
        <source>Screw &quot;%1&quot; needs a lead: its advance in one turn.</source>
        <translation>Spindel „%1“ braucht eine Steigung: ihren Vorschub je Umdrehung.</translation>
    </message>
    <message>
        <source>The lead of screw &quot;%1&quot; is above 0.</source>
        <translation>Die Steigung der Spindel „%1“ ist größer als 0.</translation>
    </message>
    <message>
        <source>Screw &quot;%1&quot; has a lead and a hand, no module and no helix angle: leave them out.</source>
        <translation>Spindel „%1“ hat Steigung und Gangrichtung, aber weder Modul noch Schrägungswinkel: sie weglassen.</translation>
    </message>
    <message>
        <source>Rack &quot;%1&quot; has a module or a pitch along its motion, one of them.</source>
        <translation>Zahnstange „%1“ hat einen Modul oder eine Teilung längs ihrer Bewegung, eines von beiden.</translation>
    </message>
    <message>
        <source>The travel of a radian of &quot;%1&quot; is a ratio of two whole numbers up to 100,000: give it with fewer digits.</source>
        <translation>Der Weg je Radiant von „%1“ ist ein Verhältnis zweier ganzer Zahlen bis 100.000: mit weniger Stellen angeben.</translation>
    </message>
    <message>
        <source>Only a screw has a lead; mesh &quot;%1&quot; is none.</source>
        <translation>Nur eine Spindel hat eine Steigung; Eingriff „%1“ ist keine.</translation>
    </message>
    <message>
        <source>This format does not cover sliding joints, racks and screws.</source>
        <translation>Dieses Format kennt keine Schubgelenke, Zahnstangen und Spindeln.</translation>
    </message>
    <message>
        <source>%1 slides: its screw has no angular part.</source>
        <translation>%1 gleitet: seine Schraube hat keinen Drehanteil.</translation>
    </message>
    <message>
        <source>The %1 component of the direction in which %2 slides: how fast the pitch point of %3 moves for one unit of speed.</source>
        <translation>Die %1-Komponente der Richtung, in der %2 gleitet: wie schnell sich der Wälzpunkt von %3 bei der Geschwindigkeit 1 bewegt.</translation>
    </message>
    <message>
        <source>a joint slides</source>
        <translation>ein Gelenk gleitet</translation>
    </message>
    <message>
        <source>Mesh %1 is a rack: its sign follows from the side of the pinion on which it is, and f is %2.</source>
        <translation>Eingriff %1 ist eine Zahnstange: ihr Vorzeichen folgt aus der Seite des Ritzels, auf der sie liegt, und f ist %2.</translation>
    </message>
    <message>
        <source>The sign of rack %1 follows from the side of the pinion&apos;s axis on which its teeth are.</source>
        <translation>Das Vorzeichen der Zahnstange %1 folgt aus der Seite der Ritzelachse, auf der ihre Zähne liegen.</translation>
    </message>
    <message>
        <source>Mesh %1 is a screw: its sign follows from the hand of the thread, and f is %2.</source>
        <translation>Eingriff %1 ist eine Spindel: ihr Vorzeichen folgt aus der Gangrichtung des Gewindes, und f ist %2.</translation>
    </message>
    <message>
        <source>The sign of screw %1 follows from the hand of its thread.</source>
        <translation>Das Vorzeichen der Spindel %1 folgt aus der Gangrichtung ihres Gewindes.</translation>
    </message>
    <message>
        <source>A length is tied to an angle by pi (meshes %1) and, round a loop, by a whole number of modules too: their rates would be sums of different powers of pi, for which there are no exact numbers here. State the racks of the loop all by their module or all by their pitch.</source>
        <translation>Eine Länge ist mit einem Winkel über Pi verknüpft (Eingriffe %1) und, rings um eine Schleife, auch ohne Pi: die Geschwindigkeiten wären Summen verschiedener Potenzen von Pi, für die es hier keine exakten Zahlen gibt. Die Zahnstangen der Schleife alle mit dem Modul oder alle mit der Teilung angeben.</translation>
    </message>
    <message>
        <source>The equation of motion</source>
        <translation>Die Bewegungsgleichung</translation>
    </message>
    <message>
        <source>Ratios of states with pi</source>
        <translation>Übersetzungen von Schaltzuständen mit Pi</translation>
    </message>
    <message>
        <source>Torques and forces</source>
        <translation>Momente und Kräfte</translation>
    </message>
    <message>
        <source>%1: sliding joints are not covered, and joints %2 slide.</source>
        <translation>%1: Schubgelenke werden nicht behandelt, und die Gelenke %2 gleiten.</translation>
    </message>
    <message>
        <source>one of its gears slides in their carrier, and gears of the kind %1 turn. What fits: a rack or a screw, or turning joints.</source>
        <translation>eines ihrer Räder gleitet in ihrem Träger, und Räder der Art %1 drehen sich. Es passen: eine Zahnstange oder Spindel, oder Drehgelenke.</translation>
    </message>
    <message>
        <source>it says %1, but both of its sides slide. What fits: one side that turns.</source>
        <translation>angegeben ist %1, aber beide Seiten gleiten. Es passt: eine Seite, die sich dreht.</translation>
    </message>
    <message>
        <source>it says %1, but both of its sides turn. What fits: one side that slides.</source>
        <translation>angegeben ist %1, aber beide Seiten drehen sich. Es passt: eine Seite, die gleitet.</translation>
    </message>
    <message>
        <source>the travel of a turn is not stated. What fits: a module or a pitch of the rack, the lead of the screw.</source>
        <translation>der Weg je Umdrehung ist nicht angegeben. Es passen: Modul oder Teilung der Zahnstange, Steigung der Spindel.</translation>
    </message>
    <message>
        <source>it says %1, but its side that slides does not slide along the axis of the other one. What fits: parallel directions, or a rack.</source>
        <translation>angegeben ist %1, aber die gleitende Seite gleitet nicht längs der Achse der anderen. Es passen: parallele Richtungen, oder eine Zahnstange.</translation>
    </message>
    <message>
        <source>it says %1, but it slides along the axis of its pinion. What fits: a direction across it, or a screw.</source>
        <translation>angegeben ist %1, aber sie gleitet längs der Achse ihres Ritzels. Es passen: eine Richtung quer dazu, oder eine Spindel.</translation>
    </message>
    <message>
        <source>its teeth run along the slide and cannot push it. What fits: another helix angle or hand.</source>
        <translation>ihre Zähne laufen längs der Führung und können sie nicht schieben. Es passen: ein anderer Schrägungswinkel oder eine andere Flankenrichtung.</translation>
    </message>
    <message>
        <source>its pitch point lies %1 off the place where a pinion of the pitch radius %2 touches the rack. What fits: no pitch point.</source>
        <translation>ihr Wälzpunkt liegt %1 neben der Stelle, an der ein Ritzel mit dem Wälzkreisradius %2 die Zahnstange berührt. Es passt: kein Wälzpunkt.</translation>
    </message>
    <message>
        <source>sign of a rack</source>
        <translation>Vorzeichen einer Zahnstange</translation>
    </message>
    <message>
        <source>sign of a screw</source>
        <translation>Vorzeichen einer Spindel</translation>
    </message>
    <message>
        <source>Sliding joints, racks and screws have no symbols here.</source>
        <translation>Schubgelenke, Zahnstangen und Spindeln haben hier keine Sinnbilder.</translation>
    </message>
    <message>
        <source>One of its links turns, the other one slides across that axis.</source>
        <translation>Eines der Glieder dreht sich, das andere gleitet quer zu dieser Achse.</translation>
    </message>
    <message>
        <source>One of its links turns, the other one slides along that axis.</source>
        <translation>Eines der Glieder dreht sich, das andere gleitet längs dieser Achse.</translation>
    </message>
    <message>
        <source>Travel and module of a rack are above 0.</source>
        <translation>Hub und Modul einer Zahnstange sind größer als 0.</translation>
    </message>
    <message>
        <source>A pinion of this module has %1 teeth for this travel a turn, and %2 to %3 fit.</source>
        <translation>Ein Ritzel dieses Moduls hat für diesen Hub je Umdrehung %1 Zähne, möglich sind %2 bis %3.</translation>
    </message>
    <message>
        <source>Rack drive</source>
        <translation>Zahnstangentrieb</translation>
    </message>
    <message>
        <source>The lead of a screw is above 0.</source>
        <translation>Die Steigung einer Spindel ist größer als 0.</translation>
    </message>
    <message>
        <source>Screw drive</source>
        <translation>Spindeltrieb</translation>
    </message>
    <message>
        <source>nut</source>
        <translation>Mutter</translation>
    </message>
    <message>
        <source>joint %1 at %2 %3</source>
        <translation>Gelenk %1 bei %2 %3</translation>
    </message>
    <message>
        <source>Speed of what slides</source>
        <translation>Geschwindigkeit von Schiebendem</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 längs %2</translation>
    </message>
    <message>
        <source>Speed of joint %1: link %2 slides along link %3</source>
        <translation>Geschwindigkeit von Gelenk %1: Glied %2 gleitet auf Glied %3</translation>
    </message>
    <message>
        <source>%1/rad</source>
        <translation>%1/rad</translation>
    </message>
    <message>
        <source>rad/%1</source>
        <translation>rad/%1</translation>
    </message>
    <message>
        <source>The joint slides back no farther than this from the reference pose: 0 or less. Empty: no limit.</source>
        <translation>Weiter gleitet das Gelenk aus der Ausgangslage nicht zurück: 0 oder weniger. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>The joint slides on no farther than this from the reference pose: 0 or more. Empty: no limit.</source>
        <translation>Weiter gleitet das Gelenk aus der Ausgangslage nicht vor: 0 oder mehr. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>One of its links slides: a rack or a screw fits, or turning joints.</source>
        <translation>Eines seiner Glieder gleitet: Es passen eine Zahnstange oder eine Spindel, oder Drehgelenke.</translation>
    </message>
    <message>
        <source>Both of its links slide, and one of them has to turn.</source>
        <translation>Beide Glieder gleiten, und eines davon muss sich drehen.</translation>
    </message>
    <message>
        <source>Both of its links turn, and one of them has to slide. The form of a joint makes it a sliding one.</source>
        <translation>Beide Glieder drehen sich, und eines davon muss gleiten. Das Formular eines Gelenks macht es zum Schubgelenk.</translation>
    </message>
    <message>
        <source>It does not slide along the axis of the link that turns: a rack fits.</source>
        <translation>Es gleitet nicht längs der Achse des Glieds, das sich dreht: Eine Zahnstange passt.</translation>
    </message>
    <message>
        <source>It slides along the axis of the link that turns: a screw fits.</source>
        <translation>Es gleitet längs der Achse des Glieds, das sich dreht: Eine Spindel passt.</translation>
    </message>
    <message>
        <source>Sliding joint %1: %2 → %3</source>
        <translation>Schubgelenk %1: %2 → %3</translation>
    </message>
    <message>
        <source>%1 sliding joints</source>
        <translation>%1 Schubgelenke</translation>
    </message>
    <message>
        <source>Limits, %1</source>
        <translation>Grenzen, %1</translation>
    </message>
    <message>
        <source>Speed of joint %1: how fast %2 slides along %3. Positive: in the direction of the axis.</source>
        <translation>Geschwindigkeit von Gelenk %1: wie schnell %2 auf %3 gleitet. Positiv: in Richtung der Achse.</translation>
    </message>
    <message>
        <source>Travel a turn, about</source>
        <translation>Hub je Umdrehung, etwa</translation>
    </message>
    <message>
        <source>Lead, advance of a turn</source>
        <translation>Steigung, Vorschub je Umdrehung</translation>
    </message>
    <message>
        <source>One turn of &quot;%1&quot; moves &quot;%2&quot; by %3.</source>
        <translation>Eine Umdrehung von „%1“ verschiebt „%2“ um %3.</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>drehend</translation>
    </message>
    <message>
        <source>The head turns about the axis, against the tail.</source>
        <translation>Die Spitze dreht sich um die Achse, gegen den Fuß.</translation>
    </message>
    <message>
        <source>sliding</source>
        <translation>gleitend</translation>
    </message>
    <message>
        <source>The head slides along the axis, against the tail.</source>
        <translation>Die Spitze gleitet längs der Achse, gegen den Fuß.</translation>
    </message>
    <message>
        <source>Change kind of joint</source>
        <translation>Gelenkart ändern</translation>
    </message>
    <message>
        <source>In %1/s; a speed with another unit, such as 2 m/s or 30 in/min, is converted.</source>
        <translation>In %1/s; eine Geschwindigkeit in einer anderen Einheit, etwa 2 m/s oder 30 in/min, wird umgerechnet.</translation>
    </message>
    <message>
        <source>Type a speed such as 12, 2*3, 2 m/s or 30 in/min.</source>
        <translation>Eine Geschwindigkeit eingeben, etwa 12, 2*3, 2 m/s oder 30 in/min.</translation>
    </message>
    <message>
        <source>No joint is driven: %1 as input, at 1 rad/s or %2 each.</source>
        <translation>Kein Gelenk wird angetrieben: %1 als Antrieb, mit je 1 rad/s oder %2.</translation>
    </message>
    <message>
        <source>Hand of the thread</source>
        <translation>Gangrichtung des Gewindes</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>The mechanism drawn in four ways; a click on a tab chooses one.</source>
        <translation>Der Mechanismus, auf vier Arten gezeichnet; ein Klick auf einen Reiter wählt eine davon.</translation>
    </message>
    <message>
        <source>Tools for drawing, undo and redo, the motion, and the search field.</source>
        <translation>Werkzeuge zum Zeichnen, Rückgängig und Wiederholen, die Bewegung und das Suchfeld.</translation>
    </message>
    <message>
        <source>What has to be known about the file of this window.</source>
        <translation>Was über die Datei dieses Fensters zu wissen ist.</translation>
    </message>
    <message>
        <source>Begin a mechanism, or open a recent document or an example.</source>
        <translation>Einen Mechanismus beginnen, oder ein zuletzt verwendetes Dokument oder ein Beispiel öffnen.</translation>
    </message>
    <message>
        <source>What the tool expects next, and the counts of the mechanism.</source>
        <translation>Was das Werkzeug als Nächstes erwartet, und die Zahlen des Mechanismus.</translation>
    </message>
</context>
</TS>

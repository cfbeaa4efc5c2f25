<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>GearGraph</name>
    <message>
        <source>at</source>
        <comment>A turning joint, by its label, or a link on which a load or a balance acts from outside.</comment>
        <translation>bei</translation>
    </message>
    <message>
        <source>turns</source>
        <comment>The link beyond the joint, seen from the ground.</comment>
        <translation>dreht</translation>
    </message>
    <message>
        <source>carried by</source>
        <comment>What puts a torque in: a load that is given, a balance that is found, or nothing: a free joint.</comment>
        <translation>getragen von</translation>
    </message>
    <message>
        <source>coupling</source>
        <comment>A brake or clutch that is engaged.</comment>
        <translation>Schaltelement</translation>
    </message>
    <message>
        <source>holds</source>
        <comment>The link that a brake holds; the two links that a clutch joins, the torque acts on the first one.</comment>
        <translation>hält</translation>
    </message>
    <message>
        <source>about</source>
        <comment>The axis that the torque is about, the first one on the way to the ground.</comment>
        <translation>um</translation>
    </message>
    <message>
        <source>mesh</source>
        <comment>The gear mesh, by its label.</comment>
        <translation>Zahneingriff</translation>
    </message>
    <message>
        <source>tail</source>
        <comment>The link of the tail&apos;s gear.</comment>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>head</source>
        <comment>The link of the head&apos;s gear.</comment>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>carrier</source>
        <comment>The link that holds both gears&apos; axes, from which the mesh is seen.</comment>
        <translation>Steg</translation>
    </message>
    <message>
        <source>drives</source>
        <comment>The gear that delivers the power to the teeth, seen from the carrier.</comment>
        <translation>treibt</translation>
    </message>
    <message>
        <source>joint</source>
        <comment>The turning joint, whose bearing holds its head on its tail.</comment>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>element</source>
        <comment>A mesh, a joint, an engaged coupling, a load or a balance.</comment>
        <translation>Element</translation>
    </message>
    <message>
        <source>link</source>
        <comment>The link that it acts on.</comment>
        <translation>Glied</translation>
    </message>
    <message>
        <source>links</source>
        <comment>The shafts of the loop.</comment>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>meshes</source>
        <comment>The meshes of the gear sets of the loop.</comment>
        <translation>greift ein in</translation>
    </message>
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
        <translation>Trägheit an den Motoren</translation>
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
        <source>Torques on the gears of every mesh, tooth forces, and the power that it passes</source>
        <translation>Momente an den Rädern jedes Zahneingriffs, Zahnkräfte und übertragene Leistung</translation>
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
        <source>Select links to copy; the ground stays where it is.</source>
        <translation>Wählen Sie Glieder zum Kopieren aus; das Gestell bleibt, wo es ist.</translation>
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
        <source>Rename in place</source>
        <translation>An Ort und Stelle umbenennen</translation>
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
        <source>&amp;Export matrix as CSV…</source>
        <translation>&amp;Matrix als CSV exportieren …</translation>
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
        <source>A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist</source>
        <translation>Ein ganzer Planeten-, Ravigneaux- oder Simpson-Satz, ein Differential, eine rückkehrende Stufe, ein Handgelenk</translation>
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
        <source>All panels back to their places</source>
        <translation>Alle Bereiche zurück an ihre Plätze</translation>
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
        <source>Select one link to rename it.</source>
        <translation>Wählen Sie ein Glied aus, um es umzubenennen.</translation>
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
        <source>Power taken over power fed, with the drive driving</source>
        <translation>Entnommene durch zugeführte Leistung, wenn der Antrieb treibt</translation>
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
        <source>Torques in N m, for 1 N m at the drive.</source>
        <translation>Momente in N m, für 1 N m am Antrieb.</translation>
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
        <source>%1 links, %2 joints, %3 meshes</source>
        <translation>%1 Glieder, %2 Gelenke, %3 Zahneingriffe</translation>
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
        <source>Type a number such as 12, 0.5 or 22/7, or a length such as 1/2 in.</source>
        <translation>Geben Sie eine Zahl wie 12, 0,5 oder 22/7 oder eine Länge wie 1/2 in ein.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5 or 22/7.</source>
        <translation>Geben Sie eine Zahl wie 12, 0,5 oder 22/7 ein.</translation>
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
        <translation>Matroid-Verfahren = T–T-Graph-Verfahren, exakt</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly, for all %1 joints</source>
        <translation>Matroid-Verfahren = T–T-Graph-Verfahren, exakt, für alle %1 Gelenke</translation>
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
        <source>Click to select, drag an axis to move it. The program lays the drawing out</source>
        <translation>Klicken wählt aus, eine Achse ziehen verschiebt sie. Das Programm ordnet die Zeichnung an</translation>
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
        <source>External, internal (one wheel is a ring) or bevel (the axes meet). Without it the geometry tells.</source>
        <translation>Außen, innen (ein Rad ist ein Hohlrad) oder Kegelräder (die Achsen schneiden sich). Ohne Angabe folgt sie aus der Geometrie.</translation>
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
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Efficiency and torques over the ratio of two speeds, or over the efficiency of the meshes</source>
        <translation>Wirkungsgrad und Momente über dem Verhältnis zweier Drehzahlen oder über dem Wirkungsgrad der Zahneingriffe</translation>
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
        <source>Where a train locks itself, no torque of what holds the loads moves them, however large. The efficiency counts as the same in all meshes.</source>
        <translation>Wo ein Getriebe sich selbst hemmt, bewegt kein Moment dessen, was die Lasten hält, diese, so groß es auch sei. Der Wirkungsgrad gilt als in allen Zahneingriffen gleich.</translation>
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
        <source>its axes are skew, %1 apart: there is no point where the gears could roll. What fits: axes that are parallel or meet.</source>
        <translation>Seine Achsen sind windschief im Abstand %1: Es gibt keinen Punkt, an dem die Räder wälzen könnten. Es passt: Achsen, die parallel sind oder sich schneiden.</translation>
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
        <source>joint %1 (%2)</source>
        <translation>Gelenk %1 (%2)</translation>
    </message>
    <message>
        <source>%1 = %2, inverse %3</source>
        <translation>%1 = %2, Kehrwert %3</translation>
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
        <source>Speed of an output over that of the only input, and the inverse. Select a joint or a link to see its ratio.</source>
        <translation>Drehzahl eines Abtriebs durch die des einzigen Antriebs, und der Kehrwert. Wählen Sie ein Gelenk oder Glied aus, um seine Übersetzung zu sehen.</translation>
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
        <source>The power taken over the power fed; backward and in symbols it is on the card Efficiency.</source>
        <translation>Die entnommene durch die zugeführte Leistung; rückwärts und in Formelzeichen steht sie auf der Karte Wirkungsgrad.</translation>
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
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>Every matrix of the Matroid method. Rest the mouse on an entry to have it explained.</source>
        <translation>Alle Matrizen des Matroid-Verfahrens. Halten Sie die Maus über einen Eintrag, um ihn erklärt zu bekommen.</translation>
    </message>
    <message>
        <source>What is wrong with the mechanism, and how to mend it.</source>
        <translation>Was am Mechanismus falsch ist und wie man es behebt.</translation>
    </message>
    <message>
        <source>The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit.</source>
        <translation>Die Zahnräder in Bewegung. Am Rad ziehen dreht das Getriebe, daneben ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>The speeds of the motors, and how fast every joint turns with them.</source>
        <translation>Die Geschwindigkeiten der Motoren, und wie schnell sich jedes Gelenk mit ihnen dreht.</translation>
    </message>
    <message>
        <source>Brakes and clutches, what is engaged, and the states of a gearbox.</source>
        <translation>Bremsen und Kupplungen, was geschlossen ist, und die Schaltzustände eines Getriebes.</translation>
    </message>
    <message>
        <source>Teeth, axes and names of what is selected.</source>
        <translation>Zähne, Achsen und Namen dessen, was ausgewählt ist.</translation>
    </message>
    <message>
        <source>Speeds over one period of the motion.</source>
        <translation>Geschwindigkeiten über eine Periode der Bewegung.</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism.</source>
        <translation>Beide Verfahren Schritt für Schritt, für diesen Mechanismus.</translation>
    </message>
    <message>
        <source>Loads, and the torques, forces and powers that they cause.</source>
        <translation>Lasten und die Momente, Kräfte und Leistungen, die sie hervorrufen.</translation>
    </message>
    <message>
        <source>Masses, the inertia at each motor, and the motion that torques cause.</source>
        <translation>Massen, die Trägheit an jedem Motor, und die Bewegung, die Momente hervorrufen.</translation>
    </message>
    <message>
        <source>A lesson: what is asked, your answer, hints, and the reason where it is wrong.</source>
        <translation>Eine Lektion: was gefragt ist, Ihre Antwort, Hinweise, und der Grund, wo sie falsch ist.</translation>
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
        <source>The mechanism in section, as in textbooks. You can draw here, too.</source>
        <translation>Der Mechanismus im Schnitt, wie in Lehrbüchern. Auch hier lässt sich zeichnen.</translation>
    </message>
    <message>
        <source>The mechanism drawn in three ways; a click on a tab chooses one.</source>
        <translation>Der Mechanismus, auf drei Arten gezeichnet; ein Klick auf einen Reiter wählt eine davon.</translation>
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

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>GearGraph</name>
    <message>
        <source>the ground does not move</source>
        <translation>el bastidor no se mueve</translation>
    </message>
    <message>
        <source>no turning joint carries it yet</source>
        <translation>ningún par de revolución lo lleva todavía</translation>
    </message>
    <message>
        <source>several turning joints: click one</source>
        <translation>varios pares de revolución: haga clic en uno</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 elementos</translation>
    </message>
    <message>
        <source>link %1</source>
        <translation>eslabón %1</translation>
    </message>
    <message>
        <source>turning joint %1</source>
        <translation>par de revolución %1</translation>
    </message>
    <message>
        <source>gear mesh %1</source>
        <translation>engrane %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>brake %1</source>
        <translation>freno %1</translation>
    </message>
    <message>
        <source>clutch %1</source>
        <translation>embrague %1</translation>
    </message>
    <message>
        <source> from link %1 to link %2</source>
        <translation> del eslabón %1 al eslabón %2</translation>
    </message>
    <message>
        <source>: holds link %1 while it is engaged</source>
        <translation>: retiene el eslabón %1 mientras está activado</translation>
    </message>
    <message>
        <source>: links %1 turn as one while it is engaged</source>
        <translation>: los eslabones %1 giran juntos mientras está activado</translation>
    </message>
    <message>
        <source> and </source>
        <translation> y </translation>
    </message>
    <message>
        <source>, axis %1</source>
        <translation>, eje %1</translation>
    </message>
    <message>
        <source>, driven</source>
        <translation>, accionado</translation>
    </message>
    <message>
        <source>, %1 : %2 teeth</source>
        <translation>, %1 : %2 dientes</translation>
    </message>
    <message>
        <source>Release %1</source>
        <translation>Liberar %1</translation>
    </message>
    <message>
        <source>Engage %1</source>
        <translation>Activar %1</translation>
    </message>
    <message>
        <source>Take %1 off</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Hold it with a brake</source>
        <translation>Retener con un freno</translation>
    </message>
    <message>
        <source>Connect it to another link with a clutch</source>
        <translation>Unir a otro eslabón con un embrague</translation>
    </message>
    <message>
        <source>select two links</source>
        <translation>seleccione dos eslabones</translation>
    </message>
    <message>
        <source>Connect %1 and %2 with a clutch</source>
        <translation>Unir %1 y %2 con un embrague</translation>
    </message>
    <message>
        <source>Select one link, and with Shift the joints and meshes that its new half should take.</source>
        <translation>Seleccione un eslabón y, con Mayús, los pares y engranes que ha de tomar su nueva mitad.</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Dividir %1</translation>
    </message>
    <message>
        <source>Select the two links that should be one: click one, then the other with Shift.</source>
        <translation>Seleccione los dos eslabones que han de ser uno: haga clic en uno y después en el otro con Mayús.</translation>
    </message>
    <message>
        <source>Weld %1 and %2</source>
        <translation>Soldar %1 y %2</translation>
    </message>
    <message>
        <source>Split it in two</source>
        <translation>Dividirlo en dos</translation>
    </message>
    <message>
        <source>Weld %1 and %2 to one link</source>
        <translation>Soldar %1 y %2 en un eslabón</translation>
    </message>
    <message>
        <source>hold the link with a brake</source>
        <translation>retenga el eslabón con un freno</translation>
    </message>
    <message>
        <source>Move gear %1 to the other side of the apex</source>
        <translation>Pasar la rueda %1 al otro lado del vértice</translation>
    </message>
    <message>
        <source>Make it external</source>
        <translation>Hacerlo exterior</translation>
    </message>
    <message>
        <source>Make it internal</source>
        <translation>Hacerlo interior</translation>
    </message>
    <message>
        <source>Pin the module</source>
        <translation>Fijar el módulo</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Cambiar nombre</translation>
    </message>
    <message>
        <source>Stop driving it</source>
        <translation>Dejar de accionarlo</translation>
    </message>
    <message>
        <source>Drive it</source>
        <translation>Accionarlo</translation>
    </message>
    <message>
        <source>Make it the ground</source>
        <translation>Hacerlo bastidor</translation>
    </message>
    <message>
        <source>it is the ground</source>
        <translation>es el bastidor</translation>
    </message>
    <message>
        <source>Attach a gear</source>
        <translation>Añadir una rueda</translation>
    </message>
    <message>
        <source>Pin the teeth of its gears</source>
        <translation>Fijar los dientes de sus ruedas</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>the ground cannot be deleted</source>
        <translation>el bastidor no se puede eliminar</translation>
    </message>
    <message>
        <source>Axis %1 pinned</source>
        <translation>Eje %1 fijado</translation>
    </message>
    <message>
        <source>only turning joints can be driven</source>
        <translation>solo se pueden accionar pares de revolución</translation>
    </message>
    <message>
        <source>Flip the arrow</source>
        <translation>Invertir la flecha</translation>
    </message>
    <message>
        <source>Delete with its joints</source>
        <translation>Eliminar con sus pares</translation>
    </message>
    <message>
        <source>New link here</source>
        <translation>Nuevo eslabón aquí</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Tidy the drawing</source>
        <translation>Ordenar el dibujo</translation>
    </message>
    <message>
        <source>nothing is drawn yet</source>
        <translation>todavía no hay nada dibujado</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Take it off</source>
        <translation>Quitarlo</translation>
    </message>
    <message>
        <source>Cycle C%1:</source>
        <translation>Ciclo C%1:</translation>
    </message>
    <message>
        <source>Digraph</source>
        <translation>Dígrafo</translation>
    </message>
    <message>
        <source>Laying out %1 links</source>
        <translation>Ordenando %1 eslabones</translation>
    </message>
    <message>
        <source>No gear can be attached: %1.</source>
        <translation>No se puede añadir una rueda: %1.</translation>
    </message>
    <message>
        <source>Select one turning joint or link to load it.</source>
        <translation>Seleccione un par de revolución o un eslabón para cargarlo.</translation>
    </message>
    <message>
        <source>The ground takes any load: select a moving link.</source>
        <translation>El bastidor soporta cualquier carga: seleccione un eslabón móvil.</translation>
    </message>
    <message>
        <source>Loads act in turning joints and on links.</source>
        <translation>Las cargas actúan en pares de revolución y en eslabones.</translation>
    </message>
    <message>
        <source>10 Nm</source>
        <translation>10 Nm</translation>
    </message>
    <message>
        <source>Torque that acts here</source>
        <translation>Momento que actúa aquí</translation>
    </message>
    <message>
        <source>Remove load</source>
        <translation>Quitar la carga</translation>
    </message>
    <message>
        <source>A torque is a number with its unit: 10 Nm, 500 Nmm, 1/2 kNm</source>
        <translation>Un momento es un número con su unidad: 10 Nm, 500 Nmm, 1/2 kNm</translation>
    </message>
    <message>
        <source>Set load</source>
        <translation>Fijar la carga</translation>
    </message>
    <message>
        <source>Add load</source>
        <translation>Añadir carga</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>Invertir %1</translation>
    </message>
    <message>
        <source>Cannot be driven: %1</source>
        <translation>No se puede accionar: %1</translation>
    </message>
    <message>
        <source>Drive or release</source>
        <translation>Accionar o liberar</translation>
    </message>
    <message>
        <source>Rename link</source>
        <translation>Cambiar nombre del eslabón</translation>
    </message>
    <message>
        <source>No gear can be attached: %1</source>
        <translation>No se puede añadir una rueda: %1</translation>
    </message>
    <message>
        <source>Attach gear to %1</source>
        <translation>Añadir una rueda a %1</translation>
    </message>
    <message>
        <source>Make ground</source>
        <translation>Definir el bastidor</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>Fijar %1</translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>Soltar %1</translation>
    </message>
    <message>
        <source>Change kind</source>
        <translation>Cambiar el tipo</translation>
    </message>
    <message>
        <source>Move gear to the other side</source>
        <translation>Pasar la rueda al otro lado</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>Retener %1</translation>
    </message>
    <message>
        <source>Connect links</source>
        <translation>Unir eslabones</translation>
    </message>
    <message>
        <source>Take off %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>%1:  %2,  transfer vertex %3</source>
        <translation>%1:  %2,  vértice de transferencia %3</translation>
    </message>
    <message>
        <source>The drawn pose does not tell the sign of its terminal equation.</source>
        <translation>La posición dibujada no determina el signo de su ecuación terminal.</translation>
    </message>
    <message>
        <source>Draw the first link: L, then click</source>
        <translation>Dibuje el primer eslabón: L y clic</translation>
    </message>
    <message>
        <source>Map of the drawing</source>
        <translation>Mapa del dibujo</translation>
    </message>
    <message>
        <source>All of the drawing: click or drag to move what is in sight</source>
        <translation>Todo el dibujo: haga clic o arrastre para mover lo que se ve</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the link</source>
        <translation>Nombre del eslabón</translation>
    </message>
    <message>
        <source>Move link</source>
        <translation>Mover eslabón</translation>
    </message>
    <message>
        <source>Move links</source>
        <translation>Mover eslabones</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Desplazar un poco</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Añadir eslabón</translation>
    </message>
    <message>
        <source>Add gear mesh</source>
        <translation>Añadir engrane</translation>
    </message>
    <message>
        <source>Add turning joint</source>
        <translation>Añadir par de revolución</translation>
    </message>
    <message>
        <source>T-T graph</source>
        <translation>Grafo T-T</translation>
    </message>
    <message>
        <source>The T–T graph is still being laid out. Try again in a moment.</source>
        <translation>El grafo T–T se está ordenando todavía. Inténtelo de nuevo en un momento.</translation>
    </message>
    <message>
        <source>No tree yet: turning joints have to tie every link to the ground and close no loop.</source>
        <translation>Todavía no hay árbol: los pares de revolución deben unir cada eslabón al bastidor sin cerrar ningún lazo.</translation>
    </message>
    <message>
        <source>Then the dotted meshes get their transfer vertices.</source>
        <translation>Entonces los engranes punteados reciben sus vértices de transferencia.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Y %1 más.</translation>
    </message>
    <message>
        <source>Transfer vertex of %1</source>
        <translation>Vértice de transferencia de %1</translation>
    </message>
    <message>
        <source>Branch %1 on level %2</source>
        <translation>Rama %1 en el nivel %2</translation>
    </message>
    <message>
        <source>It has no transfer vertex.</source>
        <translation>No tiene vértice de transferencia.</translation>
    </message>
    <message>
        <source>Tidy the T-T graph</source>
        <translation>Ordenar el grafo T-T</translation>
    </message>
    <message>
        <source>The derivation could not be worked out: %1</source>
        <translation>No se pudo obtener la deducción: %1</translation>
    </message>
    <message>
        <source>The derivation appears here, both methods step by step.</source>
        <translation>La deducción aparece aquí, con ambos métodos paso a paso.</translation>
    </message>
    <message>
        <source>The sections of the derivation</source>
        <translation>Secciones de la deducción</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Write the derivation as a web page, PDF, LaTeX or Markdown</source>
        <translation>Escribir la deducción como página web, PDF, LaTeX o Markdown</translation>
    </message>
    <message>
        <source>The derivation is being worked out…</source>
        <translation>Obteniendo la deducción…</translation>
    </message>
    <message>
        <source>Copy equation as LaTeX</source>
        <translation>Copiar la ecuación como LaTeX</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Copiar el texto</translation>
    </message>
    <message>
        <source>Copy all as LaTeX</source>
        <translation>Copiar todo como LaTeX</translation>
    </message>
    <message>
        <source>Copy all as Markdown</source>
        <translation>Copiar todo como Markdown</translation>
    </message>
    <message>
        <source>Before the first step</source>
        <translation>Antes del primer paso</translation>
    </message>
    <message>
        <source>%1 (saved)</source>
        <translation>%1 (guardado)</translation>
    </message>
    <message>
        <source>%1, shown now</source>
        <translation>%1, se muestra ahora</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, deshecho</translation>
    </message>
    <message>
        <source>The dynamics could not be worked out: %1</source>
        <translation>No se pudo calcular la dinámica: %1</translation>
    </message>
    <message>
        <source>Masses</source>
        <translation>Masas</translation>
    </message>
    <message>
        <source>Mass and moments of inertia of every link, density and gravity</source>
        <translation>Masa y momentos de inercia de cada eslabón, densidad y gravedad</translation>
    </message>
    <message>
        <source>Inertia at the motors</source>
        <translation>Inercia reducida</translation>
    </message>
    <message>
        <source>How much of the inertia that each motor feels every link makes up (reflected inertia)</source>
        <translation>Qué parte de la inercia que siente cada motor aporta cada eslabón (inercia reducida)</translation>
    </message>
    <message>
        <source>Equation of motion</source>
        <translation>Ecuación</translation>
    </message>
    <message>
        <source>Generalised inertia, Coriolis and centrifugal torques, weight and loads in the inputs</source>
        <translation>Inercia generalizada, momentos centrífugos y de Coriolis, peso y cargas en las entradas</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>The motion that torques of the motors cause: simulated and played</source>
        <translation>El movimiento que causan los momentos de los motores: simulado y reproducido</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Copiar la tabla para una hoja de cálculo</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Export the table, or the simulated motion, to a CSV file</source>
        <translation>Exportar la tabla, o el movimiento simulado, a un archivo CSV</translation>
    </message>
    <message>
        <source>Masses and motion appear here as soon as the mechanism is analysed.</source>
        <translation>Las masas y el movimiento aparecen aquí en cuanto se analiza el mecanismo.</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: state masses of its links, or give its wheels teeth.</source>
        <translation>El movimiento de las entradas no mueve ninguna masa: indique masas de los eslabones o dientes de las ruedas.</translation>
    </message>
    <message>
        <source>At the moment that the 3D view shows.</source>
        <translation>En el instante que muestra la vista 3D.</translation>
    </message>
    <message>
        <source>There is nothing to copy yet</source>
        <translation>Todavía no hay nada que copiar</translation>
    </message>
    <message>
        <source>There is nothing to export yet</source>
        <translation>Todavía no hay nada que exportar</translation>
    </message>
    <message>
        <source>masses.csv</source>
        <translation>masas.csv</translation>
    </message>
    <message>
        <source>reflected-inertia.csv</source>
        <translation>inercia-reducida.csv</translation>
    </message>
    <message>
        <source>equation-of-motion.csv</source>
        <translation>ecuacion-de-movimiento.csv</translation>
    </message>
    <message>
        <source>motion.csv</source>
        <translation>movimiento.csv</translation>
    </message>
    <message>
        <source>M: the generalised inertia of the inputs. h: what motors have to give at constant speeds, for Coriolis and centrifugal forces and for weight. τ: torques of the motors. ℓ: what the loads contribute.</source>
        <translation>M: inercia generalizada de las entradas. h: lo que los motores deben dar a velocidad constante por las fuerzas centrífugas y de Coriolis y por el peso. τ: momentos de los motores. ℓ: lo que aportan las cargas.</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>par %1</translation>
    </message>
    <message>
        <source>Link %1: %2 kg m² at %3, %4 % of all.</source>
        <translation>Eslabón %1: %2 kg m² en %3, %4 % del total.</translation>
    </message>
    <message>
        <source>moves no mass</source>
        <translation>no mueve ninguna masa</translation>
    </message>
    <message>
        <source>%1 kg m²</source>
        <translation>%1 kg m²</translation>
    </message>
    <message>
        <source>The inertia that each link has at the motor while the other inputs stand still: for a link that turns about one axis its moment of inertia times the square of its ratio.</source>
        <translation>La inercia que cada eslabón tiene en el motor mientras las demás entradas están quietas: en un eslabón que gira en torno a un eje, su momento de inercia por el cuadrado de su relación.</translation>
    </message>
    <message>
        <source>Double-click, or press F2, to state it; empty it to leave it to the solids.</source>
        <translation>Doble clic, o F2, para indicarla; vacía, la dan los sólidos.</translation>
    </message>
    <message>
        <source>Mass, kg</source>
        <translation>Masa, kg</translation>
    </message>
    <message>
        <source>A mass is at least 0 kg.</source>
        <translation>Una masa es al menos 0 kg.</translation>
    </message>
    <message>
        <source>Masses of the links</source>
        <translation>Masas de los eslabones</translation>
    </message>
    <message>
        <source>The density of all solids, kg/m³; empty: that of steel</source>
        <translation>Densidad de todos los sólidos, kg/m³; vacía: la del acero</translation>
    </message>
    <message>
        <source>Density, kg/m³</source>
        <translation>Densidad, kg/m³</translation>
    </message>
    <message>
        <source>%1, steel</source>
        <translation>%1, acero</translation>
    </message>
    <message>
        <source>The acceleration of free fall in the base frame, m/s²: x, y, z</source>
        <translation>Aceleración de la caída libre en el sistema base, m/s²: x, y, z</translation>
    </message>
    <message>
        <source>Gravity, m/s²</source>
        <translation>Gravedad, m/s²</translation>
    </message>
    <message>
        <source>A density is above 0.</source>
        <translation>Una densidad es mayor que 0.</translation>
    </message>
    <message>
        <source>Set density</source>
        <translation>Fijar la densidad</translation>
    </message>
    <message>
        <source>Set gravity</source>
        <translation>Fijar la gravedad</translation>
    </message>
    <message>
        <source>Set mass</source>
        <translation>Fijar la masa</translation>
    </message>
    <message>
        <source>The motion could not be followed: %1</source>
        <translation>No se pudo seguir el movimiento: %1</translation>
    </message>
    <message>
        <source>How much of the motion is followed</source>
        <translation>Cuánto del movimiento se ha seguido</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Velocidades</translation>
    </message>
    <message>
        <source>Speeds of the inputs, and of the joints that are selected, over time</source>
        <translation>Velocidades de las entradas, y de los pares seleccionados, en el tiempo</translation>
    </message>
    <message>
        <source>Torques</source>
        <translation>Momentos</translation>
    </message>
    <message>
        <source>Torques of the motors over time</source>
        <translation>Momentos de los motores en el tiempo</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energía</translation>
    </message>
    <message>
        <source>Kinetic and potential energy, the work of motors and loads, and their balance, over time</source>
        <translation>Energía cinética y potencial, trabajo de motores y cargas, y su balance, en el tiempo</translation>
    </message>
    <message>
        <source>Play in 3D</source>
        <translation>Reproducir en 3D</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simular</translation>
    </message>
    <message>
        <source>End the motion where it is now</source>
        <translation>Terminar aquí el movimiento</translation>
    </message>
    <message>
        <source>Follow the motion that these torques, the loads and weight cause</source>
        <translation>Seguir el movimiento que causan estos momentos, las cargas y el peso</translation>
    </message>
    <message>
        <source>There is nothing to move yet</source>
        <translation>Todavía no hay nada que mover</translation>
    </message>
    <message>
        <source>Show this motion in the 3D view instead of that of the input speeds</source>
        <translation>Mostrar este movimiento en la vista 3D en lugar del de las velocidades de entrada</translation>
    </message>
    <message>
        <source>Simulate a motion first</source>
        <translation>Simule antes un movimiento</translation>
    </message>
    <message>
        <source>Give the motors their torques, then Simulate: speeds, torques and energy appear here.</source>
        <translation>Dé a los motores sus momentos y pulse Simular: aquí aparecen velocidades, momentos y energía.</translation>
    </message>
    <message>
        <source>The motion is being followed …</source>
        <translation>Siguiendo el movimiento …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Detenido.</translation>
    </message>
    <message>
        <source>After %1 s: kinetic energy %2 J, potential %3 J, work of motors and loads %4 J; they balance but for %5 J.</source>
        <translation>Después de %1 s: energía cinética %2 J, potencial %3 J, trabajo de motores y cargas %4 J; el balance difiere en %5 J.</translation>
    </message>
    <message>
        <source>input</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>The joint that the motor drives.</source>
        <translation>El par que acciona el motor.</translation>
    </message>
    <message>
        <source>T, N m</source>
        <translation>T, N m</translation>
    </message>
    <message>
        <source>The torque of the motor at rest, by the tail of its joint on the head.</source>
        <translation>Momento del motor en reposo, de la cola de su par sobre la cabeza.</translation>
    </message>
    <message>
        <source>d, N m s</source>
        <translation>d, N m s</translation>
    </message>
    <message>
        <source>How much torque the motor loses for each rad/s of its joint: with the torque at rest over the no-load speed it is a direct-current motor at constant voltage.</source>
        <translation>Cuánto momento pierde el motor por cada rad/s de su par: con el momento en reposo entre la velocidad en vacío es un motor de corriente continua a tensión constante.</translation>
    </message>
    <message>
        <source>from, °</source>
        <translation>desde, °</translation>
    </message>
    <message>
        <source>The angle of the joint at the start, from the reference pose.</source>
        <translation>Ángulo del par al comienzo, desde la posición de referencia.</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>The speed of the joint at the start.</source>
        <translation>Velocidad del par al comienzo.</translation>
    </message>
    <message>
        <source>How long the motion is followed, in seconds.</source>
        <translation>Cuánto tiempo se sigue el movimiento, en segundos.</translation>
    </message>
    <message>
        <source>for, s</source>
        <translation>durante, s</translation>
    </message>
    <message>
        <source>The time is %1 s to %2 s.</source>
        <translation>El tiempo es de %1 s a %2 s.</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>Par %1</translation>
    </message>
    <message>
        <source>Torque of the motor of joint %1, N m</source>
        <translation>Momento del motor del par %1, N m</translation>
    </message>
    <message>
        <source>Torque that the motor of joint %1 loses for each rad/s, N m s</source>
        <translation>Momento que el motor del par %1 pierde por cada rad/s, N m s</translation>
    </message>
    <message>
        <source>Angle of joint %1 at the start, degrees</source>
        <translation>Ángulo inicial del par %1, grados</translation>
    </message>
    <message>
        <source>Speed of joint %1 at the start, rad/s</source>
        <translation>Velocidad inicial del par %1, rad/s</translation>
    </message>
    <message>
        <source>It is at least 0 N m s.</source>
        <translation>Es al menos 0 N m s.</translation>
    </message>
    <message>
        <source>Torque, rate and power in every turning joint, and of what acts on links</source>
        <translation>Momento, velocidad y potencia en cada par de revolución, y de lo que actúa en los eslabones</translation>
    </message>
    <message>
        <source>Torques of the brakes and clutches that are engaged</source>
        <translation>Momentos de los frenos y embragues activados</translation>
    </message>
    <message>
        <source>What holds each link in its turning joint: force and moment</source>
        <translation>Lo que sostiene a cada eslabón en su par de revolución: fuerza y momento</translation>
    </message>
    <message>
        <source>What every element delivers to each of its links, seen from the ground</source>
        <translation>Lo que cada elemento entrega a cada uno de sus eslabones, visto desde el bastidor</translation>
    </message>
    <message>
        <source>Power that goes round in loops, beside what goes through the train</source>
        <translation>Potencia que circula en lazos, además de la que atraviesa el tren</translation>
    </message>
    <message>
        <source>Torques of the couplings and efficiency in every state of the gearbox</source>
        <translation>Momentos de los acoplamientos y rendimiento en cada estado de la caja</translation>
    </message>
    <message>
        <source>The torques could not be worked out: %1</source>
        <translation>No se pudieron calcular los momentos: %1</translation>
    </message>
    <message>
        <source>The state whose brakes and clutches are engaged</source>
        <translation>El estado cuyos frenos y embragues están activados</translation>
    </message>
    <message>
        <source>Export the table with its units to a CSV file</source>
        <translation>Exportar la tabla con sus unidades a un archivo CSV</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Fuerzas</translation>
    </message>
    <message>
        <source>none</source>
        <translation>no hay</translation>
    </message>
    <message>
        <source>An efficiency is above 0 and at most 1.</source>
        <translation>Un rendimiento es mayor que 0 y como mucho 1.</translation>
    </message>
    <message>
        <source>η of a mesh</source>
        <translation>η de un engrane</translation>
    </message>
    <message>
        <source>The efficiency of meshes that state none: the power that a mesh delivers over what it takes, seen from its carrier. Empty: they lose nothing.</source>
        <translation>Rendimiento de los engranes que no indican ninguno: potencia que entrega un engrane entre la que toma, vista desde su portasatélites. Vacío: no pierden nada.</translation>
    </message>
    <message>
        <source>fed, W</source>
        <translation>aportada, W</translation>
    </message>
    <message>
        <source>The power that loads and balances feed into the train.</source>
        <translation>Potencia que cargas y equilibrantes aportan al tren.</translation>
    </message>
    <message>
        <source>taken, W</source>
        <translation>extraída, W</translation>
    </message>
    <message>
        <source>The power that loads and balances take from the train.</source>
        <translation>Potencia que cargas y equilibrantes extraen del tren.</translation>
    </message>
    <message>
        <source>lost, W</source>
        <translation>perdida, W</translation>
    </message>
    <message>
        <source>What the meshes lose: fed less taken.</source>
        <translation>Lo que pierden los engranes: aportada menos extraída.</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>rendimiento</translation>
    </message>
    <message>
        <source>Power taken over power fed.</source>
        <translation>Potencia extraída entre potencia aportada.</translation>
    </message>
    <message>
        <source>backward</source>
        <translation>inverso</translation>
    </message>
    <message>
        <source>The efficiency of the same motion with all known torques reversed: the output drives.</source>
        <translation>Rendimiento del mismo movimiento con todos los momentos conocidos invertidos: acciona la salida.</translation>
    </message>
    <message>
        <source>latent ratio</source>
        <translation>relación latente</translation>
    </message>
    <message>
        <source>What all meshes pass, seen from their carriers, over the power fed: the losses are about this many times those of one mesh.</source>
        <translation>Lo que transmiten todos los engranes, visto desde sus portasatélites, entre la potencia aportada: las pérdidas son unas tantas veces las de un engrane.</translation>
    </message>
    <message>
        <source>circulating, W</source>
        <translation>circulante, W</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop of shafts and gear sets.</source>
        <translation>La mayor potencia que circula en un lazo de ejes y trenes.</translation>
    </message>
    <message>
        <source>Share by stiffness</source>
        <translation>Repartir por rigidez</translation>
    </message>
    <message>
        <source>Meshes that share a load in unknown parts: assume that all teeth are equally stiff, without clearance, on rigid bodies</source>
        <translation>Engranes que comparten una carga en partes desconocidas: suponer todos los dientes igual de rígidos, sin juego, sobre cuerpos rígidos</translation>
    </message>
    <message>
        <source>as engaged</source>
        <translation>como está activado</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>estado %1</translation>
    </message>
    <message>
        <source>Torques and forces appear here as soon as the mechanism is analysed.</source>
        <translation>Los momentos y fuerzas aparecen aquí en cuanto se analiza el mecanismo.</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: their torques appear here.</source>
        <translation>Dibuje pares de revolución y engranes: sus momentos aparecen aquí.</translation>
    </message>
    <message>
        <source>There is no equilibrium: the reason is below.</source>
        <translation>No hay equilibrio: el motivo está abajo.</translation>
    </message>
    <message>
        <source>No brake or clutch is engaged: engage one in Gearbox, or choose a state.</source>
        <translation>No hay ningún freno ni embrague activado: active uno en Caja de cambios o elija un estado.</translation>
    </message>
    <message>
        <source>Forces need a unit of length whose size is known.</source>
        <translation>Las fuerzas necesitan una unidad de longitud de tamaño conocido.</translation>
    </message>
    <message>
        <source>No power flows.</source>
        <translation>No fluye potencia.</translation>
    </message>
    <message>
        <source>Without a motion there is no power.</source>
        <translation>Sin movimiento no hay potencia.</translation>
    </message>
    <message>
        <source>No power circulates.</source>
        <translation>No circula potencia.</translation>
    </message>
    <message>
        <source>Loops are found where every link but the planets turns on the ground.</source>
        <translation>Se buscan lazos cuando todos los eslabones menos los satélites giran en el bastidor.</translation>
    </message>
    <message>
        <source>There is nothing to show.</source>
        <translation>No hay nada que mostrar.</translation>
    </message>
    <message>
        <source>The two methods do not agree</source>
        <translation>Los dos métodos no coinciden</translation>
    </message>
    <message>
        <source>locks itself</source>
        <translation>se autobloquea</translation>
    </message>
    <message>
        <source>No load acts yet. Select a joint or a link, then + Load.</source>
        <translation>Todavía no actúa ninguna carga. Seleccione un par o un eslabón y luego + Carga.</translation>
    </message>
    <message>
        <source>+ Load</source>
        <translation>+ Carga</translation>
    </message>
    <message>
        <source>A torque of 1 N m on the selected joint or link, or choose one</source>
        <translation>Un momento de 1 N m en el par o eslabón seleccionado, o elegir</translation>
    </message>
    <message>
        <source>Found at ▾</source>
        <translation>Se busca en ▾</translation>
    </message>
    <message>
        <source>Balances: where torques are found that hold the loads. By itself the program takes the inputs that bear no load of their own.</source>
        <translation>Equilibrantes: dónde se buscan momentos que sostengan las cargas. Por sí mismo, el programa toma las entradas sin carga propia.</translation>
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
        <translation>La unidad de los momentos de esta lista; el documento conserva N m</translation>
    </message>
    <message>
        <source>F on %1</source>
        <translation>F en %1</translation>
    </message>
    <message>
        <source>T in %1</source>
        <translation>T en el par %1</translation>
    </message>
    <message>
        <source>T on %1 about %2</source>
        <translation>T en %1 en torno a %2</translation>
    </message>
    <message>
        <source>T on %1</source>
        <translation>T en %1</translation>
    </message>
    <message>
        <source>A force from outside on the link, N, in the base frame, at (%1) of the reference pose.</source>
        <translation>Fuerza exterior sobre el eslabón, N, en el sistema base, en (%1) de la posición de referencia.</translation>
    </message>
    <message>
        <source>A torque that the joint&apos;s tail exerts on its head, about the direction of its axis; the head exerts the opposite one on the tail.</source>
        <translation>Momento que la cola del par ejerce sobre su cabeza, en torno a la dirección de su eje; la cabeza ejerce el opuesto sobre la cola.</translation>
    </message>
    <message>
        <source>A torque from outside on the link; the ground takes the reaction. Without an axis it is about the link&apos;s first axis on the way to the ground.</source>
        <translation>Momento exterior sobre el eslabón; el bastidor toma la reacción. Sin eje actúa en torno al primer eje del eslabón en el camino al bastidor.</translation>
    </message>
    <message>
        <source>%1 of %2 loads are listed</source>
        <translation>Se muestran %1 de %2 cargas</translation>
    </message>
    <message>
        <source>Remove this load</source>
        <translation>Quitar esta carga</translation>
    </message>
    <message>
        <source>Torque in a joint</source>
        <translation>Momento en un par</translation>
    </message>
    <message>
        <source>Torque on a link</source>
        <translation>Momento en un eslabón</translation>
    </message>
    <message>
        <source>Inputs without a load</source>
        <translation>Entradas sin carga</translation>
    </message>
    <message>
        <source>Choose balances</source>
        <translation>Elegir equilibrantes</translation>
    </message>
    <message>
        <source>Select in the drawing, or type: 8, 10</source>
        <translation>Seleccione en el dibujo o escriba: 8, 10</translation>
    </message>
    <message>
        <source>A whole number, a fraction such as −2/3, or a decimal</source>
        <translation>Un entero, una fracción como −2/3 o un decimal</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>From one gear pair to the robot</source>
        <translation>De un par de ruedas al robot</translation>
    </message>
    <message>
        <source>Open a lesson file…</source>
        <translation>Abrir un archivo de lección…</translation>
    </message>
    <message>
        <source>Fresh question %1</source>
        <translation>Pregunta nueva %1</translation>
    </message>
    <message>
        <source>%1 of %2 fresh questions right at the first check</source>
        <translation>%1 de %2 preguntas nuevas bien a la primera</translation>
    </message>
    <message>
        <source>You have mastered this lesson.</source>
        <translation>Domina usted esta lección.</translation>
    </message>
    <message>
        <source>Start again? All answers on this device are deleted.</source>
        <translation>¿Empezar de nuevo? Se borrarán todas las respuestas de este dispositivo.</translation>
    </message>
    <message>
        <source>What you write stays in this browser.</source>
        <translation>Lo que escribe se queda en este navegador.</translation>
    </message>
    <message>
        <source>Answer to step %1</source>
        <translation>Respuesta al paso %1</translation>
    </message>
    <message>
        <source>One drawing that is right</source>
        <translation>Un dibujo correcto</translation>
    </message>
    <message>
        <source>This is drawn in GearGraph: Learn &gt; Lessons. It gives no points here.</source>
        <translation>Esto se dibuja en GearGraph: Aprender &gt; Lecciones. Aquí no da puntos.</translation>
    </message>
    <message>
        <source>Two lessons have the id &quot;%1&quot;.</source>
        <translation>Dos lecciones tienen el identificador «%1».</translation>
    </message>
    <message>
        <source>Where to begin</source>
        <translation>Por dónde empezar</translation>
    </message>
    <message>
        <source>After the lesson “%1” you can answer this.</source>
        <translation>Después de la lección «%1» puede responder a esto.</translation>
    </message>
    <message>
        <source>You have mastered this lesson. Review it from %1 on.</source>
        <translation>Domina usted esta lección. Repásela a partir del %1.</translation>
    </message>
    <message>
        <source>%1 of %2 right at once</source>
        <translation>%1 de %2 bien a la primera</translation>
    </message>
    <message>
        <source>Right at the first check, without a hint; one more is asked as long as some are missing</source>
        <translation>Bien en la primera comprobación, sin pista; mientras falte alguna se pregunta otra</translation>
    </message>
    <message>
        <source>Fresh questions</source>
        <translation>Preguntas nuevas</translation>
    </message>
    <message>
        <source>Where do I begin?</source>
        <translation>¿Por dónde empiezo?</translation>
    </message>
    <message>
        <source>A question about each lesson in turn: it ends with the second one that is not right at the first check, and chooses the lesson of the first</source>
        <translation>Una pregunta sobre cada lección, por orden: termina con la segunda que no esté bien a la primera y elige la lección de la primera</translation>
    </message>
    <message>
        <source>review due</source>
        <translation>repaso pendiente</translation>
    </message>
    <message>
        <source>questions left</source>
        <translation>quedan preguntas</translation>
    </message>
    <message>
        <source>After the start test: begin with “%1”.</source>
        <translation>Según la prueba inicial: empiece por «%1».</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Repasar</translation>
    </message>
    <message>
        <source>Start test</source>
        <translation>Prueba inicial</translation>
    </message>
    <message numerus="yes">
        <source>%n to review.</source>
        <translation>
            <numerusform>%n para repasar.</numerusform>
            <numerusform>%n para repasar.</numerusform>
        </translation>
    </message>
    <message>
        <source>A lesson of your own: it is reloaded whenever the file is saved</source>
        <translation>Una lección propia: se recarga cada vez que se guarda el archivo</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 de %2 puntos</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>paso %1 de %2</translation>
    </message>
    <message>
        <source>Afterwards you can %1.</source>
        <translation>Después sabrá: %1.</translation>
    </message>
    <message>
        <source>%1 lessons, %2 min. %3 done, about %4 min to go.</source>
        <translation>%1 lecciones, %2 min. %3 hechas, quedan unos %4 min.</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>%1 of %2 steps done</source>
        <translation>%1 de %2 pasos hechos</translation>
    </message>
    <message>
        <source>‹ Back</source>
        <translation>‹ Atrás</translation>
    </message>
    <message>
        <source>The step before (Alt+Left)</source>
        <translation>El paso anterior (Alt+Izquierda)</translation>
    </message>
    <message>
        <source>Skip ›</source>
        <translation>Saltar ›</translation>
    </message>
    <message>
        <source>The next step (Alt+Right)</source>
        <translation>El paso siguiente (Alt+Derecha)</translation>
    </message>
    <message>
        <source>‹ Course</source>
        <translation>‹ Curso</translation>
    </message>
    <message>
        <source>All lessons, with your progress</source>
        <translation>Todas las lecciones, con su progreso</translation>
    </message>
    <message>
        <source>2 points for a step that is right at once, 1 after a hint or a correction; the score never falls</source>
        <translation>2 puntos por un paso correcto a la primera, 1 tras una pista o una corrección; la puntuación nunca baja</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>P&amp;ista</translation>
    </message>
    <message>
        <source>Where to look, then the rule, then the first half</source>
        <translation>Dónde mirar, luego la regla, luego la primera mitad</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>The answer; the step then gives no points</source>
        <translation>La respuesta; el paso ya no da puntos</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Check the answer (Return)</source>
        <translation>Comprobar la respuesta (Intro)</translation>
    </message>
    <message>
        <source>Begin the step</source>
        <translation>Empezar el paso</translation>
    </message>
    <message>
        <source>Right. %1</source>
        <translation>Correcto. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) are wrong: look at those that are framed.</source>
        <translation>
            <numerusform>%n campo está mal: mire el que está enmarcado.</numerusform>
            <numerusform>%n campos están mal: mire los que están enmarcados.</numerusform>
        </translation>
    </message>
    <message>
        <source>This is not right. A hint tells where to look.</source>
        <translation>Esto no es correcto. Una pista dice dónde mirar.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>Mostrado: %1</translation>
    </message>
    <message>
        <source>%1, %2 min</source>
        <translation>%1, %2 min</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Paso %1 de %2</translation>
    </message>
    <message>
        <source>Score %1 of %2</source>
        <translation>Puntos %1 de %2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Where to look, then the rule: hint %1 of %2</source>
        <translation>Dónde mirar, luego la regla: pista %1 de %2</translation>
    </message>
    <message>
        <source>There are no more hints in this step.</source>
        <translation>No hay más pistas en este paso.</translation>
    </message>
    <message>
        <source>A drawing can be right in many ways: take a hint.</source>
        <translation>Un dibujo puede ser correcto de muchas maneras: pida una pista.</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>Este es el primer paso.</translation>
    </message>
    <message>
        <source>Next lesson ›</source>
        <translation>Lección siguiente ›</translation>
    </message>
    <message>
        <source>Next ›</source>
        <translation>Siguiente ›</translation>
    </message>
    <message>
        <source>Leave ›</source>
        <translation>Salir ›</translation>
    </message>
    <message>
        <source>About GearGraph</source>
        <translation>Acerca de GearGraph</translation>
    </message>
    <message>
        <source>&lt;b&gt;GearGraph %1&lt;/b&gt;&lt;p&gt;Draw, analyse and see geared mechanisms by the matroid and the T–T graph methods (Amirinezhad and Uyguroğlu, 2014).&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;GearGraph %1&lt;/b&gt;&lt;p&gt;Dibuje, analice y vea mecanismos de engranajes con los métodos de matroides y del grafo T–T (Amirinezhad y Uyguroğlu, 2014).&lt;/p&gt;&lt;p&gt;Licencia MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Copiar detalles</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copiado</translation>
    </message>
    <message>
        <source>Crash report</source>
        <translation>Informe de fallo</translation>
    </message>
    <message>
        <source>GearGraph crashed on %1. A report says where in the program; it names neither documents nor what is in them.</source>
        <translation>GearGraph falló el %1. Un informe dice en qué parte del programa; no nombra documentos ni su contenido.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Mostrar el informe</translation>
    </message>
    <message>
        <source>Read it, and decide then</source>
        <translation>Léalo y decida después</translation>
    </message>
    <message>
        <source>For a message to the developers</source>
        <translation>Para un mensaje a los desarrolladores</translation>
    </message>
    <message>
        <source>The crash report was copied.</source>
        <translation>El informe de fallo se ha copiado.</translation>
    </message>
    <message>
        <source>For good</source>
        <translation>Para siempre</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Más tarde</translation>
    </message>
    <message>
        <source>It will be offered again</source>
        <translation>Se ofrecerá de nuevo</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Coma</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>Punto y coma</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulador</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Labels of rows and columns</source>
        <translation>Etiquetas de filas y columnas</translation>
    </message>
    <message>
        <source>Byte order mark</source>
        <translation>Marca de orden de bytes</translation>
    </message>
    <message>
        <source>Export %1 as CSV</source>
        <translation>Exportar %1 como CSV</translation>
    </message>
    <message>
        <source>What parts the columns</source>
        <translation>Lo que separa las columnas</translation>
    </message>
    <message>
        <source>Numbers with a decimal comma are quoted where commas part the columns</source>
        <translation>Los números con coma decimal van entre comillas cuando las comas separan las columnas</translation>
    </message>
    <message>
        <source>Without them the file holds the entries alone</source>
        <translation>Sin ellas el archivo solo contiene las entradas</translation>
    </message>
    <message>
        <source>Begins the file with a mark by which spreadsheet programs know UTF-8</source>
        <translation>Comienza el archivo con una marca por la que las hojas de cálculo reconocen UTF-8</translation>
    </message>
    <message>
        <source>Columns parted by</source>
        <translation>Separador de columnas</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Signo decimal</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1 …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>The clipboard holds no links: %1</source>
        <translation>El portapapeles no contiene eslabones: %1</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>Copiado: %1</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 eslabón</translation>
    </message>
    <message>
        <source>1 mesh</source>
        <translation>1 engrane</translation>
    </message>
    <message>
        <source>%1 joints</source>
        <translation>%1 pares</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 par</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 eslabones</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>The clipboard is empty.</source>
        <translation>El portapapeles está vacío.</translation>
    </message>
    <message>
        <source>The clipboard holds no links.</source>
        <translation>El portapapeles no contiene eslabones.</translation>
    </message>
    <message>
        <source>What the clipboard holds is too large to be a mechanism.</source>
        <translation>Lo que contiene el portapapeles es demasiado grande para ser un mecanismo.</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Pasted as it was drawn in %1: check the lengths, which count in %2 here.</source>
        <translation>Pegado como se dibujó en %1: compruebe las longitudes, que aquí cuentan en %2.</translation>
    </message>
    <message>
        <source>Make %1 planets</source>
        <translation>Crear %1 satélites</translation>
    </message>
    <message>
        <source>Insert %1</source>
        <translation>Insertar %1</translation>
    </message>
    <message>
        <source>Exporting %1.</source>
        <translation>Exportando %1.</translation>
    </message>
    <message>
        <source>Give up this export; nothing is written</source>
        <translation>Abandonar esta exportación; no se escribe nada</translation>
    </message>
    <message>
        <source>Exporting %1: %2 of %3 pictures.</source>
        <translation>Exportando %1: %2 de %3 imágenes.</translation>
    </message>
    <message>
        <source>The export of %1 was stopped; nothing was written.</source>
        <translation>Se detuvo la exportación de %1; no se escribió nada.</translation>
    </message>
    <message>
        <source>GearGraph documents (*.geargraph);;All files (*)</source>
        <translation>Documentos de GearGraph (*.geargraph);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Pasos del historial</translation>
    </message>
    <message>
        <source>A click on a step, or Return, goes there. Steps below it can be repeated until something else is drawn.</source>
        <translation>Un clic en un paso, o Intro, va allí. Los pasos de debajo se pueden rehacer hasta que se dibuje otra cosa.</translation>
    </message>
    <message>
        <source>The gears appear here. Draw the first link: L, then click.</source>
        <translation>Las ruedas aparecen aquí. Dibuje el primer eslabón: L y clic.</translation>
    </message>
    <message>
        <source>The gears appear when the turning joints tie every link to the ground and close no loop.</source>
        <translation>Las ruedas aparecen cuando los pares de revolución unen cada eslabón al bastidor sin cerrar lazos.</translation>
    </message>
    <message>
        <source>The 3D view shows trains of up to %1 links; this one has %2.</source>
        <translation>La vista 3D muestra trenes de hasta %1 eslabones; este tiene %2.</translation>
    </message>
    <message>
        <source>The gears appear when a mesh joins two of the links: G, then drag.</source>
        <translation>Las ruedas aparecen cuando un engrane une dos eslabones: G y arrastrar.</translation>
    </message>
    <message>
        <source>T–T graph</source>
        <translation>Grafo T–T</translation>
    </message>
    <message>
        <source>Schematic</source>
        <translation>Esquema</translation>
    </message>
    <message>
        <source>The views could not be updated: %1.</source>
        <translation>No se pudieron actualizar las vistas: %1.</translation>
    </message>
    <message>
        <source>Shown as before the last changes. %1</source>
        <translation>Se muestra como antes de los últimos cambios. %1</translation>
    </message>
    <message>
        <source>This matrix needs a mechanism without errors.</source>
        <translation>Esta matriz necesita un mecanismo sin errores.</translation>
    </message>
    <message>
        <source>This matrix needs the turning joints to be a spanning tree.</source>
        <translation>Esta matriz necesita que los pares de revolución formen un árbol generador.</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (solo lectura)</translation>
    </message>
    <message>
        <source>Notices</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 de %1</translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation>No hay memoria suficiente para la imagen.</translation>
    </message>
    <message>
        <source>Of this size:</source>
        <translation>De este tamaño:</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fondo transparente</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Claro sobre oscuro</translation>
    </message>
    <message>
        <source>Fit everything into the picture</source>
        <translation>Ajustar todo a la imagen</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>SVG, lines and text</source>
        <translation>SVG, líneas y texto</translation>
    </message>
    <message>
        <source>PDF, lines and text</source>
        <translation>PDF, líneas y texto</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, píxeles</translation>
    </message>
    <message>
        <source>PNG, a folder of pictures</source>
        <translation>PNG, una carpeta de imágenes</translation>
    </message>
    <message>
        <source>GLB, the solids in their present pose</source>
        <translation>GLB, los sólidos en su posición actual</translation>
    </message>
    <message>
        <source>Without it the picture is as large as the drawing.</source>
        <translation>Sin esto la imagen es tan grande como el dibujo.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animación</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>None: one picture</source>
        <translation>Ninguna: una imagen</translation>
    </message>
    <message>
        <source>Turntable: once round</source>
        <translation>Plato giratorio: una vuelta</translation>
    </message>
    <message>
        <source>Motion: one period</source>
        <translation>Movimiento: un periodo</translation>
    </message>
    <message>
        <source>A minute where the motion has no period</source>
        <translation>Un minuto si el movimiento no tiene periodo</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> imágenes</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> por segundo</translation>
    </message>
    <message>
        <source>The 3D view is made of pixels.</source>
        <translation>La vista 3D está hecha de píxeles.</translation>
    </message>
    <message>
        <source>Only the 3D view has it.</source>
        <translation>Solo la vista 3D lo tiene.</translation>
    </message>
    <message>
        <source>Export pictures into the new folder</source>
        <translation>Exportar imágenes a la carpeta nueva</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Carpetas (*)</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Todos los archivos</translation>
    </message>
    <message>
        <source>The 3D view is empty: there is nothing to export.</source>
        <translation>La vista 3D está vacía: no hay nada que exportar.</translation>
    </message>
    <message>
        <source>Copied the drawing as a picture</source>
        <translation>Dibujo copiado como imagen</translation>
    </message>
    <message>
        <source>The 3D view is empty: there is nothing to copy.</source>
        <translation>La vista 3D está vacía: no hay nada que copiar.</translation>
    </message>
    <message>
        <source>Copied the 3D view as a picture</source>
        <translation>Vista 3D copiada como imagen</translation>
    </message>
    <message>
        <source>Sent to the printer</source>
        <translation>Enviado a la impresora</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Exportado %1</translation>
    </message>
    <message>
        <source>How fast the motion is shown; a double click is 1.0×</source>
        <translation>Con qué rapidez se muestra el movimiento; un doble clic es 1,0×</translation>
    </message>
    <message>
        <source>Speed of the motion</source>
        <translation>Velocidad del movimiento</translation>
    </message>
    <message>
        <source>Pause the motion (Space)</source>
        <translation>Pausar el movimiento (Espacio)</translation>
    </message>
    <message>
        <source>Play the motion (Space)</source>
        <translation>Reproducir el movimiento (Espacio)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Power flows under loads: add one in Forces.</source>
        <translation>La potencia fluye bajo cargas: añada una en Fuerzas.</translation>
    </message>
    <message>
        <source>The loads are not in balance: Forces names what is missing.</source>
        <translation>Las cargas no están en equilibrio: Fuerzas dice lo que falta.</translation>
    </message>
    <message>
        <source>The ground</source>
        <translation>El bastidor</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Eslabón %1</translation>
    </message>
    <message>
        <source>Link %1, %2</source>
        <translation>Eslabón %1, %2</translation>
    </message>
    <message>
        <source>Esc or F11 ends the presentation, Space plays.  Alt+1, Alt+2, … show and hide panels.</source>
        <translation>Esc o F11 terminan la presentación, Espacio reproduce.  Alt+1, Alt+2, … muestran y ocultan paneles.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>No file has been opened yet</source>
        <translation>Todavía no se ha abierto ningún archivo</translation>
    </message>
    <message>
        <source>There is nothing drawn to derive anything for.</source>
        <translation>No hay nada dibujado de lo que deducir algo.</translation>
    </message>
    <message>
        <source>A derivation of more than %1 links is not written: it would be too long to read.</source>
        <translation>No se escribe una deducción de más de %1 eslabones: sería demasiado larga para leerla.</translation>
    </message>
    <message>
        <source>Export derivation</source>
        <translation>Exportar la deducción</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)</source>
        <translation>Página web (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)</translation>
    </message>
    <message>
        <source>The solution is still being worked out. Try again in a moment.</source>
        <translation>La solución se está calculando todavía. Inténtelo de nuevo en un momento.</translation>
    </message>
    <message>
        <source>The export was stopped.</source>
        <translation>La exportación se detuvo.</translation>
    </message>
    <message>
        <source>Export handout</source>
        <translation>Exportar el folleto</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Página web (*.html)</translation>
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
        <translation>en torno a x, °</translation>
    </message>
    <message>
        <source>about y, °</source>
        <translation>en torno a y, °</translation>
    </message>
    <message>
        <source>about z, °</source>
        <translation>en torno a z, °</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Añadir…</translation>
    </message>
    <message>
        <source>Another STL, OBJ, PLY or GLB file</source>
        <translation>Otro archivo STL, OBJ, PLY o GLB</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Lengths in the document&apos;s unit. A file is turned about x, then y, then z, and moved, in the drawn pose; it then moves with its link.</source>
        <translation>Longitudes en la unidad del documento. El archivo se gira en torno a x, luego y, luego z, y se desplaza, en la posición dibujada; después se mueve con su eslabón.</translation>
    </message>
    <message>
        <source>3D files of link %1</source>
        <translation>Archivos 3D del eslabón %1</translation>
    </message>
    <message>
        <source>Place a 3D file</source>
        <translation>Colocar un archivo 3D</translation>
    </message>
    <message>
        <source>3D file</source>
        <translation>Archivo 3D</translation>
    </message>
    <message>
        <source>3D files (*.stl *.obj *.ply *.glb);;All files (*)</source>
        <translation>Archivos 3D (*.stl *.obj *.ply *.glb);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Wear a 3D file</source>
        <translation>Poner un archivo 3D</translation>
    </message>
    <message>
        <source>Take off a 3D file</source>
        <translation>Quitar un archivo 3D</translation>
    </message>
    <message>
        <source>In a drawing</source>
        <translation>En un dibujo</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>Reproducir, pausar</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Mover la hoja</translation>
    </message>
    <message>
        <source>Space or middle button, and drag</source>
        <translation>Espacio o botón central, y arrastrar</translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation>Zoom en el ratón</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Fit what is selected</source>
        <translation>Ajustar lo seleccionado</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Mayús+F</translation>
    </message>
    <message>
        <source>Nudge; finer</source>
        <translation>Desplazar; más fino</translation>
    </message>
    <message>
        <source>Arrow keys; with Shift</source>
        <translation>Flechas; con Mayús</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Añadir a la selección</translation>
    </message>
    <message>
        <source>Shift or Ctrl, and click</source>
        <translation>Mayús o Ctrl, y clic</translation>
    </message>
    <message>
        <source>Drag without snapping</source>
        <translation>Arrastrar sin ajuste</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>Next, last element; besides</source>
        <translation>Elemento siguiente, anterior; además</translation>
    </message>
    <message>
        <source>Page down, up; with Shift</source>
        <translation>Av Pág, Re Pág; con Mayús</translation>
    </message>
    <message>
        <source>The nearest element that way</source>
        <translation>El elemento más cercano en esa dirección</translation>
    </message>
    <message>
        <source>Ctrl and arrow key</source>
        <translation>Ctrl y flecha</translation>
    </message>
    <message>
        <source>As a click on the element</source>
        <translation>Como un clic en el elemento</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Give up, deselect, back to Select</source>
        <translation>Abandonar, deseleccionar, volver a Seleccionar</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>En la vista 3D</translation>
    </message>
    <message>
        <source>Step back, step on</source>
        <translation>Paso atrás, paso adelante</translation>
    </message>
    <message>
        <source>Comma, point</source>
        <translation>Coma, punto</translation>
    </message>
    <message>
        <source>F, Home</source>
        <translation>F, Inicio</translation>
    </message>
    <message>
        <source>Isometric, front, right, top</source>
        <translation>Isométrica, frente, derecha, arriba</translation>
    </message>
    <message>
        <source>0, 1, 2, 3</source>
        <translation>0, 1, 2, 3</translation>
    </message>
    <message>
        <source>Turn the train</source>
        <translation>Girar el tren</translation>
    </message>
    <message>
        <source>Drag a gear</source>
        <translation>Arrastrar una rueda</translation>
    </message>
    <message>
        <source>Turn a part by hand</source>
        <translation>Girar una pieza a mano</translation>
    </message>
    <message>
        <source>Ctrl, and drag</source>
        <translation>Ctrl, y arrastrar</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Orbitar</translation>
    </message>
    <message>
        <source>Drag elsewhere, arrow keys</source>
        <translation>Arrastrar en otro sitio, flechas</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>Shift with drag or arrow keys</source>
        <translation>Mayús con arrastrar o flechas</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Wheel, + and −</source>
        <translation>Rueda, + y −</translation>
    </message>
    <message>
        <source>Next, last link</source>
        <translation>Eslabón siguiente, anterior</translation>
    </message>
    <message>
        <source>Page down, Page up</source>
        <translation>Av Pág, Re Pág</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>New mechanism</source>
        <translation>Mecanismo nuevo</translation>
    </message>
    <message>
        <source>An empty sheet with the ground on it</source>
        <translation>Una hoja vacía con el bastidor</translation>
    </message>
    <message>
        <source>Open an example…</source>
        <translation>Abrir un ejemplo…</translation>
    </message>
    <message>
        <source>All sets: belts, wrists, strain wave, cycloidal and RV reducers, too</source>
        <translation>Todos los trenes, también correas, muñecas y reductores de onda, cicloidales y RV</translation>
    </message>
    <message>
        <source>More sets…</source>
        <translation>Más trenes…</translation>
    </message>
    <message>
        <source>Choose teeth and ratio, and insert it: %1</source>
        <translation>Elegir dientes y relación e insertarlo: %1</translation>
    </message>
    <message>
        <source>Draw links and joints by hand: the tool Link, then click on the sheet</source>
        <translation>Dibujar eslabones y pares a mano: la herramienta Eslabón y después un clic en la hoja</translation>
    </message>
    <message>
        <source>Draw, or insert a set</source>
        <translation>Dibujar o insertar un tren</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Open a document; it can be dropped on the window, too</source>
        <translation>Abrir un documento; también se puede soltar en la ventana</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Documents that you open or save are listed here.</source>
        <translation>Aquí aparecen los documentos que abra o guarde.</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
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
        <translation>rango –</translation>
    </message>
    <message>
        <source>DOF –</source>
        <translation>GDL –</translation>
    </message>
    <message>
        <source>rank %1</source>
        <translation>rango %1</translation>
    </message>
    <message>
        <source>DOF %1</source>
        <translation>GDL %1</translation>
    </message>
    <message>
        <source>rank %1 + %2</source>
        <translation>rango %1 + %2</translation>
    </message>
    <message>
        <source>DOF %1 (engaged: %2)</source>
        <translation>GDL %1 (activado: %2)</translation>
    </message>
    <message>
        <source>Select, move, and change what is drawn</source>
        <translation>Seleccionar, mover y cambiar lo dibujado</translation>
    </message>
    <message>
        <source>Draw links: click on an empty place</source>
        <translation>Dibujar eslabones: clic en un lugar vacío</translation>
    </message>
    <message>
        <source>Draw a turning joint: drag from a link to the link it carries</source>
        <translation>Dibujar un par de revolución: arrastrar de un eslabón al que lleva</translation>
    </message>
    <message>
        <source>Draw a gear mesh: drag from a gear to the one it drives</source>
        <translation>Dibujar un engrane: arrastrar de una rueda a la que acciona</translation>
    </message>
    <message>
        <source>Drive a joint: click a turning joint or the link it carries</source>
        <translation>Accionar un par: clic en un par de revolución o en el eslabón que lleva</translation>
    </message>
    <message>
        <source>Move the sheet; the middle mouse button does so with any tool</source>
        <translation>Mover la hoja; el botón central lo hace con cualquier herramienta</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>A document with the ground and nothing else</source>
        <translation>Un documento solo con el bastidor</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nueva &amp;ventana</translation>
    </message>
    <message>
        <source>Another window with an empty document</source>
        <translation>Otra ventana con un documento vacío</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>Página de &amp;inicio</translation>
    </message>
    <message>
        <source>New document, recent documents and examples</source>
        <translation>Documento nuevo, documentos recientes y ejemplos</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a document</source>
        <translation>Abrir un documento</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Guardar el documento</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar co&amp;mo…</translation>
    </message>
    <message>
        <source>Save the document under another name</source>
        <translation>Guardar el documento con otro nombre</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>V&amp;olver al archivo</translation>
    </message>
    <message>
        <source>Reload the file; this can be undone</source>
        <translation>Recargar el archivo; se puede deshacer</translation>
    </message>
    <message>
        <source>Reopen w&amp;indows at start</source>
        <translation>Rea&amp;brir ventanas al arrancar</translation>
    </message>
    <message>
        <source>Open the documents of the last time when the program starts without one</source>
        <translation>Abrir los documentos de la última vez cuando el programa arranca sin ninguno</translation>
    </message>
    <message>
        <source>Export the matrix that is shown, with its labels</source>
        <translation>Exportar la matriz que se muestra, con sus etiquetas</translation>
    </message>
    <message>
        <source>Export pict&amp;ure…</source>
        <translation>E&amp;xportar imagen…</translation>
    </message>
    <message>
        <source>Export a drawing as SVG, PDF or PNG, or the 3D view as PNG</source>
        <translation>Exportar un dibujo como SVG, PDF o PNG, o la vista 3D como PNG</translation>
    </message>
    <message>
        <source>Export &amp;derivation…</source>
        <translation>Exportar &amp;deducción…</translation>
    </message>
    <message>
        <source>Print and text</source>
        <translation>Impresión y texto</translation>
    </message>
    <message>
        <source>CAD and making</source>
        <translation>CAD y fabricación</translation>
    </message>
    <message>
        <source>Simulators and control</source>
        <translation>Simuladores y control</translation>
    </message>
    <message>
        <source>Web and class</source>
        <translation>Web y clase</translation>
    </message>
    <message>
        <source>Data and graphs</source>
        <translation>Datos y grafos</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Paso %1</translation>
    </message>
    <message>
        <source>of the link between</source>
        <translation>de del la el entre eslabón</translation>
    </message>
    <message>
        <source>to and against</source>
        <translation>a y contra</translation>
    </message>
    <message>
        <source>A ratio holds the answer: it is told when the step is right or shown.</source>
        <translation>Una relación contiene la respuesta: se dice cuando el paso está bien o se ha mostrado.</translation>
    </message>
    <message>
        <source>Enter selects both.</source>
        <translation>Intro selecciona ambos.</translation>
    </message>
    <message>
        <source>Exactly, in every motion: %1 turns %3 times as fast as %2, the other way round.</source>
        <translation>Exactamente, en todo movimiento: %1 gira %3 veces tan rápido como %2, en sentido contrario.</translation>
    </message>
    <message>
        <source>Exactly, in every motion: %1 turns %3 times as fast as %2, the same way round.</source>
        <translation>Exactamente, en todo movimiento: %1 gira %3 veces tan rápido como %2, en el mismo sentido.</translation>
    </message>
    <message>
        <source>With the speeds that the inputs have now: with others it is another.</source>
        <translation>Con las velocidades actuales de las entradas: con otras es otra.</translation>
    </message>
    <message>
        <source>There is no ratio to %1, which stands still.</source>
        <translation>No hay relación con %1, que está parado.</translation>
    </message>
    <message>
        <source>They turn about axes that are not parallel, or about several at once: the results have their speeds about each axis.</source>
        <translation>Giran en torno a ejes que no son paralelos, o a varios a la vez: los resultados dan sus velocidades en cada eje.</translation>
    </message>
    <message>
        <source>There is no exact solution now: Problems says what is missing.</source>
        <translation>Ahora no hay solución exacta: Problemas dice qué falta.</translation>
    </message>
    <message>
        <source>Hold %1 with a brake</source>
        <translation>Retener %1 con un freno</translation>
    </message>
    <message>
        <source>Release the brake of %1</source>
        <translation>Liberar el freno de %1</translation>
    </message>
    <message>
        <source>Its brake is engaged already.</source>
        <translation>Su freno ya está activado.</translation>
    </message>
    <message>
        <source>No brake holds it.</source>
        <translation>Ningún freno lo retiene.</translation>
    </message>
    <message>
        <source>Changes the document; one step back (Ctrl+Z) undoes it.</source>
        <translation>Cambia el documento; un paso atrás (Ctrl+Z) lo deshace.</translation>
    </message>
    <message>
        <source>Mesh %1: %2 teeth on link %3, %4 on link %5</source>
        <translation>Engrane %1: %2 dientes en el eslabón %3, %4 en el eslabón %5</translation>
    </message>
    <message>
        <source>now %1 : %2</source>
        <translation>ahora %1 : %2</translation>
    </message>
    <message>
        <source>It has these teeth already.</source>
        <translation>Ya tiene estos dientes.</translation>
    </message>
    <message>
        <source>ratio i</source>
        <translation>relación i</translation>
    </message>
    <message>
        <source>hold brake fix</source>
        <translation>retener frenar sujetar</translation>
    </message>
    <message>
        <source>release free</source>
        <translation>liberar soltar</translation>
    </message>
    <message>
        <source>teeth z</source>
        <translation>dientes z</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>respuesta</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>cambio</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>Expor&amp;tar…</translation>
    </message>
    <message>
        <source>Export graphs, matrices, derivations, drawings, pictures, solids and models for other programs, with all their options, and see first what will be written</source>
        <translation>Exportar grafos, matrices, deducciones, dibujos, imágenes, sólidos y modelos para otros programas, con todas sus opciones, y ver antes qué se escribirá</translation>
    </message>
    <message>
        <source>Export &amp;matrix as CSV…</source>
        <translation>Exportar matri&amp;z como CSV…</translation>
    </message>
    <message>
        <source>All panels back to their places, in this window and in those to come</source>
        <translation>Todos los paneles de nuevo en su sitio, en esta ventana y en las próximas</translation>
    </message>
    <message>
        <source>&amp;Handout for the class</source>
        <translation>&amp;Folleto para la clase</translation>
    </message>
    <message>
        <source>Writes a page for any browser beside the document, at once: drawings, matrices, derivation and the train in 3D, with inputs that move</source>
        <translation>Escribe enseguida, junto al documento, una página para cualquier navegador: dibujos, matrices, deducción y el tren en 3D, con entradas que se mueven</translation>
    </message>
    <message>
        <source>mechanism</source>
        <translation>mecanismo</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>¿Para qué?</translation>
    </message>
    <message>
        <source>Sets all options of this format back to what holds without them</source>
        <translation>Devuelve todas las opciones de este formato a lo que vale sin ellas</translation>
    </message>
    <message>
        <source>Asks where, and writes it</source>
        <translation>Pregunta dónde y lo escribe</translation>
    </message>
    <message>
        <source>%1 (a folder with %2 files, %3)</source>
        <translation>%1 (una carpeta con %2 archivos, %3)</translation>
    </message>
    <message>
        <source>Exported %1 into %2.</source>
        <translation>%1 se ha exportado a %2.</translation>
    </message>
    <message>
        <source>Opens it with the program of this kind of file</source>
        <translation>Lo abre con el programa de este tipo de archivo</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Opens the folder it is in</source>
        <translation>Abre la carpeta en la que está</translation>
    </message>
    <message>
        <source>The file stays where it is</source>
        <translation>El archivo se queda donde está</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 ya no está.</translation>
    </message>
    <message>
        <source>No program opens %1 here.</source>
        <translation>Ningún programa abre %1 aquí.</translation>
    </message>
    <message>
        <source>Show what would be written</source>
        <translation>Mostrar qué se escribiría</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Working out what would be written…</source>
        <translation>Se averigua qué se escribiría…</translation>
    </message>
    <message>
        <source>Makes the files without keeping them: with a train as large as this it takes a while</source>
        <translation>Hace los archivos sin conservarlos: con un tren tan grande tarda un rato</translation>
    </message>
    <message>
        <source>Files that would be written</source>
        <translation>Archivos que se escribirían</translation>
    </message>
    <message>
        <source>Beginning of the file</source>
        <translation>Comienzo del archivo</translation>
    </message>
    <message>
        <source>Picture of what would be written</source>
        <translation>Imagen de lo que se escribiría</translation>
    </message>
    <message>
        <source>Working out what would be written: %1 %</source>
        <translation>Se averigua qué se escribiría: %1 %</translation>
    </message>
    <message>
        <source>Made with all its pictures when it is exported. This is one of them.</source>
        <translation>Al exportar se hacen todas las imágenes. Esta es una de ellas.</translation>
    </message>
    <message>
        <source>A folder with %1 files, %2</source>
        <translation>Una carpeta con %1 archivos, %2</translation>
    </message>
    <message>
        <source>%1 files, %2</source>
        <translation>%1 archivos, %2</translation>
    </message>
    <message>
        <source>A file for programs: nothing of it is read by people.</source>
        <translation>Un archivo para programas: las personas no leen nada de él.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exportar de n&amp;uevo</translation>
    </message>
    <message>
        <source>Writes %1 again, with the same options</source>
        <translation>Escribe %1 de nuevo, con las mismas opciones</translation>
    </message>
    <message>
        <source>This document has not been exported yet</source>
        <translation>Este documento aún no se ha exportado</translation>
    </message>
    <message>
        <source>Exports of this document by File &gt; Export are listed here</source>
        <translation>Aquí están las exportaciones de este documento por Archivo &gt; Exportar</translation>
    </message>
    <message>
        <source>The folder %1 could not be made.</source>
        <translation>No se pudo crear la carpeta %1.</translation>
    </message>
    <message>
        <source>GearGraph: keyboard shortcuts</source>
        <translation>GearGraph: atajos de teclado</translation>
    </message>
    <message>
        <source>On one page, also into a PDF file</source>
        <translation>En una página, también en un archivo PDF</translation>
    </message>
    <message>
        <source>The two methods differ at one joint. Please report this document.</source>
        <translation>Los dos métodos difieren en un par. Por favor, comunique este documento.</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism, as a web page, PDF, LaTeX or Markdown</source>
        <translation>Ambos métodos paso a paso para este mecanismo, como página web, PDF, LaTeX o Markdown</translation>
    </message>
    <message>
        <source>Export &amp;handout…</source>
        <translation>Exportar &amp;folleto…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Im&amp;primir…</translation>
    </message>
    <message>
        <source>Print the drawings and the derivation, or look at the pages first</source>
        <translation>Imprimir los dibujos y la deducción, o ver antes las páginas</translation>
    </message>
    <message>
        <source>Show the &amp;derivation</source>
        <translation>Mostrar la &amp;deducción</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism</source>
        <translation>Ambos métodos paso a paso para este mecanismo</translation>
    </message>
    <message>
        <source>&amp;Compare the methods</source>
        <translation>&amp;Comparar los métodos</translation>
    </message>
    <message>
        <source>Both methods side by side, counted for this mechanism</source>
        <translation>Ambos métodos en paralelo, contados para este mecanismo</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Lecciones…</translation>
    </message>
    <message>
        <source>A course from one gear pair to the robot, with tasks that are checked; in a window of its own</source>
        <translation>Un curso de un par de ruedas al robot, con tareas que se comprueban; en una ventana propia</translation>
    </message>
    <message>
        <source>Open a lesson &amp;file…</source>
        <translation>Abrir un &amp;archivo de lección…</translation>
    </message>
    <message>
        <source>Preview a lesson of your own: it is reloaded whenever the file is saved</source>
        <translation>Vista previa de una lección propia: se recarga cada vez que se guarda el archivo</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>&amp;Cerrar ventana</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Cerrar todas las ventanas</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>&amp;Historial…</translation>
    </message>
    <message>
        <source>All steps as a list; a click goes to any of them</source>
        <translation>Todos los pasos en una lista; un clic va a cualquiera de ellos</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>Copy what is selected, and delete it</source>
        <translation>Copiar lo seleccionado y eliminarlo</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selected links with the joints and meshes between them</source>
        <translation>Copiar los eslabones seleccionados con los pares y engranes entre ellos</translation>
    </message>
    <message>
        <source>Copy as p&amp;icture</source>
        <translation>Copiar como &amp;imagen</translation>
    </message>
    <message>
        <source>Copy the drawing in front, or the 3D view where it has the focus, as SVG and PNG</source>
        <translation>Copiar el dibujo de delante, o la vista 3D si tiene el foco, como SVG y PNG</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Insert what was copied, in this window or in another</source>
        <translation>Insertar lo que se copió, en esta ventana o en otra</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>A copy of the selection in the drawing</source>
        <translation>Una copia de la selección en el dibujo</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Delete what is selected, and what needs it</source>
        <translation>Eliminar lo seleccionado y lo que lo necesita</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Cambiar &amp;nombre</translation>
    </message>
    <message>
        <source>Rename the selected link</source>
        <translation>Cambiar el nombre del eslabón seleccionado</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleccion&amp;ar todo</translation>
    </message>
    <message>
        <source>Select everything</source>
        <translation>Seleccionarlo todo</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>In&amp;vertir</translation>
    </message>
    <message>
        <source>Exchange tail and head of the selected arrows</source>
        <translation>Intercambiar cola y cabeza de las flechas seleccionadas</translation>
    </message>
    <message>
        <source>Make &amp;ground</source>
        <translation>Hacer &amp;bastidor</translation>
    </message>
    <message>
        <source>Makes the selected link the ground</source>
        <translation>Hace del eslabón seleccionado el bastidor</translation>
    </message>
    <message>
        <source>&amp;Attach a gear</source>
        <translation>&amp;Añadir una rueda</translation>
    </message>
    <message>
        <source>A new link takes the selected joints and meshes of the selected link, or the side of the train that was drawn last; both turn about one axis</source>
        <translation>Un eslabón nuevo toma los pares y engranes seleccionados del eslabón seleccionado, o el lado del tren dibujado en último lugar; ambos giran en torno a un eje</translation>
    </message>
    <message>
        <source>Sp&amp;lit the link</source>
        <translation>Dividir &amp;el eslabón</translation>
    </message>
    <message>
        <source>The two selected links become one, which two gear sets then share; axes on one carrier become one line</source>
        <translation>Los dos eslabones seleccionados pasan a ser uno, que dos trenes comparten; los ejes sobre un mismo portador pasan a ser una línea</translation>
    </message>
    <message>
        <source>&amp;Weld links</source>
        <translation>Sol&amp;dar eslabones</translation>
    </message>
    <message>
        <source>A new gear in mesh with the selected one, on the same carrier</source>
        <translation>Una rueda nueva que engrana con la seleccionada, en el mismo portasatélites</translation>
    </message>
    <message>
        <source>Dri&amp;ve</source>
        <translation>A&amp;ccionar</translation>
    </message>
    <message>
        <source>Drive the selected joints, or stop driving them</source>
        <translation>Accionar los pares seleccionados, o dejar de accionarlos</translation>
    </message>
    <message>
        <source>Hold with a &amp;brake</source>
        <translation>Retener con un &amp;freno</translation>
    </message>
    <message>
        <source>Engage the brake of the selected link, a new one where it has none, or release it</source>
        <translation>Activar el freno del eslabón seleccionado, uno nuevo si no tiene, o liberarlo</translation>
    </message>
    <message>
        <source>A torque in the selected joint or on the selected link: type 10 Nm, nothing removes it</source>
        <translation>Un momento en el par o eslabón seleccionado: escriba 10 Nm; vacío lo quita</translation>
    </message>
    <message>
        <source>&amp;Release brakes and clutches</source>
        <translation>&amp;Liberar frenos y embragues</translation>
    </message>
    <message>
        <source>Release every brake and clutch; the motion goes on</source>
        <translation>Liberar todos los frenos y embragues; el movimiento sigue</translation>
    </message>
    <message>
        <source>&amp;Insert set…</source>
        <translation>&amp;Insertar un tren…</translation>
    </message>
    <message>
        <source>A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist, a worm or belt stage, a strain wave, cycloidal or RV reducer</source>
        <translation>Un tren epicicloidal, Ravigneaux o Simpson completo, un diferencial, un tren recurrente, una muñeca, una etapa de tornillo sin fin o de correa, un reductor de onda, cicloidal o RV</translation>
    </message>
    <message>
        <source>%1 planets</source>
        <translation>%1 satélites</translation>
    </message>
    <message>
        <source>Copies of the selected planet, equally spaced, %1 in all</source>
        <translation>Copias del satélite seleccionado, a distancias iguales, %1 en total</translation>
    </message>
    <message>
        <source>&amp;Tidy the drawing</source>
        <translation>&amp;Ordenar el dibujo</translation>
    </message>
    <message>
        <source>Lay the digraph out anew</source>
        <translation>Disponer de nuevo el dígrafo</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Ajustar</translation>
    </message>
    <message>
        <source>Show all of the drawing</source>
        <translation>Mostrar todo el dibujo</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>A&amp;cercar</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Más grande</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>A&amp;lejar</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Más pequeño</translation>
    </message>
    <message>
        <source>Fit the &amp;selection</source>
        <translation>Ajustar la &amp;selección</translation>
    </message>
    <message>
        <source>Show all that is selected</source>
        <translation>Mostrar todo lo seleccionado</translation>
    </message>
    <message>
        <source>&amp;Presentation</source>
        <translation>&amp;Presentación</translation>
    </message>
    <message>
        <source>Full screen, large type, the drawing and the panels that were chosen</source>
        <translation>Pantalla completa, letra grande, el dibujo y los paneles elegidos</translation>
    </message>
    <message>
        <source>Snap to the &amp;grid</source>
        <translation>Ajustar a la c&amp;uadrícula</translation>
    </message>
    <message>
        <source>Names of links and tooth counts beside their numbers, where there is room; lessons and presentations have them on</source>
        <translation>Nombres de los eslabones y números de dientes junto a sus números, donde hay sitio; en lecciones y presentaciones están activados</translation>
    </message>
    <message>
        <source>N&amp;ames and teeth</source>
        <translation>Nom&amp;bres y dientes</translation>
    </message>
    <message>
        <source>Nodes keep to a grid; Alt suspends it</source>
        <translation>Los nodos siguen una cuadrícula; Alt la suspende</translation>
    </message>
    <message>
        <source>Po&amp;wer flow</source>
        <translation>&amp;Flujo de potencia</translation>
    </message>
    <message>
        <source>Bands in digraph and schematic show where the power of the loads goes</source>
        <translation>Las bandas en el dígrafo y el esquema muestran adónde va la potencia de las cargas</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>&amp;Restablecer la disposición</translation>
    </message>
    <message>
        <source>Look &amp;up a term…</source>
        <translation>Consultar un &amp;término…</translation>
    </message>
    <message>
        <source>The definition of a technical term</source>
        <translation>La definición de un término técnico</translation>
    </message>
    <message>
        <source>&amp;Search…</source>
        <translation>&amp;Buscar…</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>A&amp;tajos de teclado</translation>
    </message>
    <message>
        <source>All keys on one sheet</source>
        <translation>Todas las teclas en una hoja</translation>
    </message>
    <message>
        <source>&amp;About GearGraph</source>
        <translation>&amp;Acerca de GearGraph</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Qué es este programa</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>Light or dark as the system is</source>
        <translation>Claro u oscuro como el sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Oscuro sobre claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Alto contraste</translation>
    </message>
    <message>
        <source>Light on black</source>
        <translation>Claro sobre negro</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Words of the window at %1 % of their size</source>
        <translation>Los textos del programa al %1 % de su tamaño</translation>
    </message>
    <message>
        <source>3D on &amp;half the width</source>
        <translation>3D a &amp;medio ancho</translation>
    </message>
    <message>
        <source>The 3D view as wide as the drawing</source>
        <translation>La vista 3D tan ancha como el dibujo</translation>
    </message>
    <message>
        <source>&amp;Play	Space</source>
        <translation>R&amp;eproducir	Espacio</translation>
    </message>
    <message>
        <source>Start or stop the motion (Space)</source>
        <translation>Iniciar o detener el movimiento (Espacio)</translation>
    </message>
    <message>
        <source>Back to the &amp;start</source>
        <translation>Volver al &amp;inicio</translation>
    </message>
    <message>
        <source>The time goes back to 0</source>
        <translation>El tiempo vuelve a 0</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Más &amp;rápido</translation>
    </message>
    <message>
        <source>The motion is shown faster</source>
        <translation>El movimiento se muestra más rápido</translation>
    </message>
    <message>
        <source>Slo&amp;wer</source>
        <translation>Más &amp;lento</translation>
    </message>
    <message>
        <source>The motion is shown more slowly</source>
        <translation>El movimiento se muestra más despacio</translation>
    </message>
    <message>
        <source>&amp;Normal speed</source>
        <translation>Velocidad &amp;normal</translation>
    </message>
    <message>
        <source>A second of the motion takes a second</source>
        <translation>Un segundo del movimiento dura un segundo</translation>
    </message>
    <message>
        <source>&amp;Backwards</source>
        <translation>&amp;Hacia atrás</translation>
    </message>
    <message>
        <source>The motion runs back in time</source>
        <translation>El movimiento va hacia atrás en el tiempo</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>&amp;Pause	Space</source>
        <translation>&amp;Pausa	Espacio</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open e&amp;xample</source>
        <translation>Abrir &amp;ejemplo</translation>
    </message>
    <message>
        <source>The start page with titles, pictures and a sentence about each example</source>
        <translation>La página de inicio con títulos, imágenes y una frase sobre cada ejemplo</translation>
    </message>
    <message>
        <source>With pictures…</source>
        <translation>Con imágenes…</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Gear trains</source>
        <translation>Trenes de engranajes</translation>
    </message>
    <message>
        <source>Clocks</source>
        <translation>Relojes</translation>
    </message>
    <message>
        <source>Gearboxes</source>
        <translation>Cajas de cambios</translation>
    </message>
    <message>
        <source>Not as they should be</source>
        <translation>No como deberían ser</translation>
    </message>
    <message>
        <source>Kinds of examples</source>
        <translation>Clases de ejemplos</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Power seen fro&amp;m</source>
        <translation>Potencia vista &amp;desde</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>T&amp;ype size</source>
        <translation>Tamañ&amp;o de letra</translation>
    </message>
    <message>
        <source>&amp;Mechanism</source>
        <translation>&amp;Mecanismo</translation>
    </message>
    <message>
        <source>&amp;Planets like the selected one</source>
        <translation>&amp;Satélites como el seleccionado</translation>
    </message>
    <message>
        <source>M&amp;otion</source>
        <translation>M&amp;ovimiento</translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation>A&amp;prender</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>No hay nada seleccionado.</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>No hay nada que deshacer.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>No hay nada que rehacer.</translation>
    </message>
    <message>
        <source>There is one ground in every document.</source>
        <translation>En cada documento hay un bastidor.</translation>
    </message>
    <message>
        <source>The ground cannot be deleted.</source>
        <translation>El bastidor no se puede eliminar.</translation>
    </message>
    <message>
        <source>Select a joint or a mesh to turn its arrow round.</source>
        <translation>Seleccione un par o un engrane para invertir su flecha.</translation>
    </message>
    <message>
        <source>Select a turning joint, or the link it carries.</source>
        <translation>Seleccione un par de revolución o el eslabón que lleva.</translation>
    </message>
    <message>
        <source>The ground does not move.</source>
        <translation>El bastidor no se mueve.</translation>
    </message>
    <message>
        <source>Select one link to hold it.</source>
        <translation>Seleccione un eslabón para retenerlo.</translation>
    </message>
    <message>
        <source>No brake and no clutch is engaged.</source>
        <translation>No hay ningún freno ni embrague activado.</translation>
    </message>
    <message>
        <source>Select one planet.</source>
        <translation>Seleccione un satélite.</translation>
    </message>
    <message>
        <source>Select the link that the gear should mesh with.</source>
        <translation>Seleccione el eslabón con el que debe engranar la rueda.</translation>
    </message>
    <message>
        <source>This link is the ground already.</source>
        <translation>Este eslabón ya es el bastidor.</translation>
    </message>
    <message>
        <source>Select one link to make it the ground.</source>
        <translation>Seleccione un eslabón para hacerlo bastidor.</translation>
    </message>
    <message>
        <source>There is no link to lay out yet.</source>
        <translation>Todavía no hay eslabones que ordenar.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>The solution is still being worked out.</source>
        <translation>La solución se está calculando todavía.</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrices</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Inputs and results</source>
        <translation>Entradas y resultados</translation>
    </message>
    <message>
        <source>Gearbox</source>
        <translation>Caja de cambios</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Derivation</source>
        <translation>Deducción</translation>
    </message>
    <message>
        <source>Dynamics</source>
        <translation>Dinámica</translation>
    </message>
    <message>
        <source>Problems %1</source>
        <translation>Problemas %1</translation>
    </message>
    <message>
        <source>Export matrix</source>
        <translation>Exportar matriz</translation>
    </message>
    <message>
        <source>CSV files (*.csv);;All files (*)</source>
        <translation>Archivos CSV (*.csv);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Exportar tabla</translation>
    </message>
    <message>
        <source>Save the traced path</source>
        <translation>Guardar la trayectoria trazada</translation>
    </message>
    <message>
        <source>path.csv</source>
        <translation>trayectoria.csv</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Guardado %1</translation>
    </message>
    <message>
        <source>Save the speeds</source>
        <translation>Guardar las velocidades</translation>
    </message>
    <message>
        <source>speeds.csv</source>
        <translation>velocidades.csv</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2</source>
        <translation>No se pudo abrir %1: %2</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>This window is not connected to others.</source>
        <translation>Esta ventana no está conectada con otras.</translation>
    </message>
    <message>
        <source>A lesson&apos;s drawing is not kept: copy what you need into another window.</source>
        <translation>El dibujo de una lección no se conserva: copie lo que necesite en otra ventana.</translation>
    </message>
    <message>
        <source>Nothing has been changed since it was saved.</source>
        <translation>No se ha cambiado nada desde que se guardó.</translation>
    </message>
    <message>
        <source>The document has no file yet.</source>
        <translation>El documento no tiene archivo todavía.</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier run are in %1, which cannot be read.</source>
        <translation>Hay cambios sin guardar de una ejecución anterior en %1, que no se puede leer.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Eliminarlo</translation>
    </message>
    <message>
        <source>a document that was never saved (%1)</source>
        <translation>un documento que nunca se guardó (%1)</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 cambio</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 cambios</translation>
    </message>
    <message>
        <source>GearGraph ended with unsaved changes of %1: %2 after it was last saved, the last at %3 (%4).</source>
        <translation>GearGraph terminó con cambios sin guardar de %1: %2 desde que se guardó, el último a las %3 (%4).</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Open them as unsaved changes, which can be undone</source>
        <translation>Abrirlos como cambios sin guardar, que se pueden deshacer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Delete them for good</source>
        <translation>Eliminarlos para siempre</translation>
    </message>
    <message>
        <source>They stay where they are and will be offered again</source>
        <translation>Se quedan donde están y se ofrecerán de nuevo</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>Restaurar los cambios sin guardar</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, línea %2: %3</translation>
    </message>
    <message>
        <source>Lesson %1 of %2</source>
        <translation>Lección %1 de %2</translation>
    </message>
    <message>
        <source>Open a lesson file</source>
        <translation>Abrir un archivo de lección</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Lecciones (*.json)</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>This panel holds the answer: it opens when the step is right or shown.</source>
        <translation>Este panel contiene la respuesta: se abre cuando el paso es correcto o se muestra.</translation>
    </message>
    <message>
        <source>The derivation holds the answer: it opens when the step is right or shown.</source>
        <translation>La deducción contiene la respuesta: se abre cuando el paso es correcto o se muestra.</translation>
    </message>
    <message>
        <source>%1 was not saved: another program has changed it.</source>
        <translation>%1 no se guardó: otro programa lo ha cambiado.</translation>
    </message>
    <message>
        <source>%1 was not saved. %2</source>
        <translation>%1 no se guardó. %2</translation>
    </message>
    <message>
        <source>Save it once more</source>
        <translation>Guardar otra vez</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Guardar con otro nombre</translation>
    </message>
    <message>
        <source>The document stays open, with its changes</source>
        <translation>El documento sigue abierto, con sus cambios</translation>
    </message>
    <message>
        <source>untitled.geargraph</source>
        <translation>sin-titulo.geargraph</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the changes to %1 first?</source>
        <translation>¿Guardar antes los cambios de %1?</translation>
    </message>
    <message>
        <source>Revert to the file</source>
        <translation>Volver al archivo</translation>
    </message>
    <message>
        <source>it can no longer be read</source>
        <translation>ya no se puede leer</translation>
    </message>
    <message>
        <source>%1 was not saved: another program has changed it (%2). Reloading can be undone.</source>
        <translation>%1 no se guardó: otro programa lo ha cambiado (%2). Recargar se puede deshacer.</translation>
    </message>
    <message>
        <source>Another program has changed %1: %2. Your own changes are not saved; reloading can be undone.</source>
        <translation>Otro programa ha cambiado %1: %2. Sus cambios no están guardados; recargar se puede deshacer.</translation>
    </message>
    <message>
        <source>Another program has changed %1: %2.</source>
        <translation>Otro programa ha cambiado %1: %2.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Load the contents of the file</source>
        <translation>Cargar el contenido del archivo</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescribir</translation>
    </message>
    <message>
        <source>Save this window&apos;s document over it</source>
        <translation>Guardar encima el documento de esta ventana</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Conservar ambos</translation>
    </message>
    <message>
        <source>Save this window&apos;s document under another name</source>
        <translation>Guardar el documento de esta ventana con otro nombre</translation>
    </message>
    <message>
        <source>Saving will ask again</source>
        <translation>Al guardar se preguntará de nuevo</translation>
    </message>
    <message>
        <source>Another program has moved or deleted %1.</source>
        <translation>Otro programa ha movido o eliminado %1.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Guardar de nuevo</translation>
    </message>
    <message>
        <source>Write it where it was</source>
        <translation>Escribirlo donde estaba</translation>
    </message>
    <message>
        <source>The document stays open</source>
        <translation>El documento sigue abierto</translation>
    </message>
    <message>
        <source>%1 is open in this window already.</source>
        <translation>%1 ya está abierto en esta ventana.</translation>
    </message>
    <message>
        <source>Not opened again: %1</source>
        <translation>No se abrió de nuevo: %1</translation>
    </message>
    <message>
        <source>%1 is open in another window of GearGraph. Here it is read-only.</source>
        <translation>%1 está abierto en otra ventana de GearGraph. Aquí es de solo lectura.</translation>
    </message>
    <message>
        <source>Show that window</source>
        <translation>Mostrar esa ventana</translation>
    </message>
    <message>
        <source>And close this one if nothing is changed in it</source>
        <translation>Y cerrar esta si no hay nada cambiado en ella</translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation>Solo lectura</translation>
    </message>
    <message>
        <source>Look at it here; changes can be saved under another name</source>
        <translation>Verlo aquí; los cambios se pueden guardar con otro nombre</translation>
    </message>
    <message>
        <source>%1 was not saved: %2 is open in another window of GearGraph.</source>
        <translation>%1 no se guardó: %2 está abierto en otra ventana de GearGraph.</translation>
    </message>
    <message>
        <source>%1 is not open in another window any more. This one writes to it now.</source>
        <translation>%1 ya no está abierto en otra ventana. Ahora lo escribe esta.</translation>
    </message>
    <message>
        <source>The other window with %1 does not answer.</source>
        <translation>La otra ventana con %1 no responde.</translation>
    </message>
    <message>
        <source>Saving %1 was interrupted, so the file may be damaged. What was to be saved is in %2.</source>
        <translation>Se interrumpió el guardado de %1, así que el archivo puede estar dañado. Lo que se iba a guardar está en %2.</translation>
    </message>
    <message>
        <source>Open the copy</source>
        <translation>Abrir la copia</translation>
    </message>
    <message>
        <source>Delete the copy</source>
        <translation>Eliminar la copia</translation>
    </message>
    <message>
        <source>The file is as it should be</source>
        <translation>El archivo está como debe</translation>
    </message>
    <message>
        <source>Attached 3D files…</source>
        <translation>Archivos 3D adjuntos…</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>línea %1, columna %2</translation>
    </message>
    <message>
        <source>Code: %1</source>
        <translation>Código: %1</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> y %1 más</translation>
    </message>
    <message>
        <source>No other joint turns with joint %1.</source>
        <translation>Ningún otro par gira con el par %1.</translation>
    </message>
    <message>
        <source>Joint %1 commands %2.</source>
        <translation>El par %1 determina %2.</translation>
    </message>
    <message>
        <source>Joints %1 turn together, at a fixed ratio.</source>
        <translation>Los pares %1 giran juntos, con relación fija.</translation>
    </message>
    <message>
        <source>Never turning: %1.</source>
        <translation>Nunca giran: %1.</translation>
    </message>
    <message>
        <source>%1 about %2</source>
        <translation>%1 en torno a %2</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>está quieto</translation>
    </message>
    <message>
        <source>link</source>
        <translation>eslabón</translation>
    </message>
    <message>
        <source>absolute speed</source>
        <translation>velocidad absoluta</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>relación</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>respecto a %1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation>%1 rad/s</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>par</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 libres</translation>
    </message>
    <message>
        <source>linkage</source>
        <translation>acoplamiento</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>quieto</translation>
    </message>
    <message>
        <source>tumbles</source>
        <translation>oscila</translation>
    </message>
    <message>
        <source>%1 engaged</source>
        <translation>%1 activado</translation>
    </message>
    <message>
        <source>%1 released</source>
        <translation>%1 liberado</translation>
    </message>
    <message>
        <source>Several couplings share the load in proportions that stiffness and clearance decide.</source>
        <translation>Varios acoplamientos comparten la carga en proporciones que deciden la rigidez y el juego.</translation>
    </message>
    <message>
        <source>Brake %1 bears %2 N m, its torque on link %3</source>
        <translation>El freno %1 soporta %2 N m, su momento sobre el eslabón %3</translation>
    </message>
    <message>
        <source>Clutch %1 bears %2 N m, its torque on link %3 from link %4</source>
        <translation>El embrague %1 soporta %2 N m, su momento sobre el eslabón %3 desde el eslabón %4</translation>
    </message>
    <message>
        <source>In the gear ratios: %1</source>
        <translation>En las relaciones de engrane: %1</translation>
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
        <translation>El freno %1 retiene el eslabón %2</translation>
    </message>
    <message>
        <source>Clutch %1 makes links %2 and %3 turn as one</source>
        <translation>El embrague %1 hace girar juntos los eslabones %2 y %3</translation>
    </message>
    <message>
        <source>The ratio is the speed of the first link over that of the second. Click to choose them.</source>
        <translation>La relación es la velocidad del primer eslabón entre la del segundo. Haga clic para elegirlos.</translation>
    </message>
    <message>
        <source>The ratio before over this one</source>
        <translation>La relación anterior entre esta</translation>
    </message>
    <message>
        <source>The efficiency with all known torques reversed: the output drives</source>
        <translation>El rendimiento con todos los momentos conocidos invertidos: acciona la salida</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop, for each watt that is fed</source>
        <translation>La mayor potencia que circula en un lazo, por cada vatio aportado</translation>
    </message>
    <message>
        <source>links</source>
        <translation>eslabones</translation>
    </message>
    <message>
        <source>decimal</source>
        <translation>decimal</translation>
    </message>
    <message>
        <source>step</source>
        <translation>paso</translation>
    </message>
    <message>
        <source>η</source>
        <translation>η</translation>
    </message>
    <message>
        <source>η back</source>
        <translation>η inv.</translation>
    </message>
    <message>
        <source>circul.</source>
        <translation>circul.</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source> Eq. (%1)</source>
        <translation> Ec. (%1)</translation>
    </message>
    <message>
        <source>All gears on this link keep their teeth while other things change.</source>
        <translation>Todas las ruedas de este eslabón conservan sus dientes mientras cambian otras cosas.</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Documento</translation>
    </message>
    <message>
        <source>Select a link, a joint or a mesh to see and change what belongs to it.</source>
        <translation>Seleccione un eslabón, un par o un engrane para ver y cambiar lo que le pertenece.</translation>
    </message>
    <message>
        <source>Rename document</source>
        <translation>Cambiar nombre del documento</translation>
    </message>
    <message>
        <source>Delete removes them with their joints and meshes.</source>
        <translation>Supr los elimina con sus pares y engranes.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Pares</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Ruedas</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Acoplamientos</translation>
    </message>
    <message>
        <source>Brakes and clutches of this link</source>
        <translation>Frenos y embragues de este eslabón</translation>
    </message>
    <message>
        <source>Link 0, the ground</source>
        <translation>Eslabón 0, el bastidor</translation>
    </message>
    <message>
        <source>Makes this link the ground: it becomes 0, and the other labels follow.</source>
        <translation>Hace de este eslabón el bastidor: pasa a ser 0, y las demás etiquetas siguen.</translation>
    </message>
    <message>
        <source>Pin the axis</source>
        <translation>Fijar el eje</translation>
    </message>
    <message>
        <source>The axis keeps its place while other things change.</source>
        <translation>El eje conserva su lugar mientras cambian otras cosas.</translation>
    </message>
    <message>
        <source>several</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Exchange tail and head: the arrow turns round, and the speed changes its sign.</source>
        <translation>Intercambiar cola y cabeza: la flecha se da la vuelta y la velocidad cambia de signo.</translation>
    </message>
    <message>
        <source>Flip joint</source>
        <translation>Invertir par</translation>
    </message>
    <message>
        <source>Move bearing</source>
        <translation>Mover cojinete</translation>
    </message>
    <message>
        <source>The joint turns back no farther than this from the reference pose, in degrees: 0 or less. Empty: no limit.</source>
        <translation>El par no gira hacia atrás más que esto desde la posición de referencia, en grados: 0 o menos. Vacío: sin límite.</translation>
    </message>
    <message>
        <source>The joint turns on no farther than this from the reference pose, in degrees: 0 or more. Empty: no limit.</source>
        <translation>El par no gira hacia delante más que esto desde la posición de referencia, en grados: 0 o más. Vacío: sin límite.</translation>
    </message>
    <message>
        <source>Limit joint</source>
        <translation>Limitar par</translation>
    </message>
    <message>
        <source>Limits, deg</source>
        <translation>Límites, grados</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Eje nuevo</translation>
    </message>
    <message>
        <source>Change axis</source>
        <translation>Cambiar de eje</translation>
    </message>
    <message>
        <source>Move axis</source>
        <translation>Mover eje</translation>
    </message>
    <message>
        <source>Turn axis</source>
        <translation>Girar eje</translation>
    </message>
    <message>
        <source>new axis</source>
        <translation>eje nuevo</translation>
    </message>
    <message>
        <source>%1 turning joints</source>
        <translation>%1 pares de revolución</translation>
    </message>
    <message>
        <source>Turning joint %1: %2 → %3</source>
        <translation>Par de revolución %1: %2 → %3</translation>
    </message>
    <message>
        <source>The axis is pinned.</source>
        <translation>El eje está fijado.</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>cola</translation>
    </message>
    <message>
        <source>head</source>
        <translation>cabeza</translation>
    </message>
    <message>
        <source>module</source>
        <translation>módulo</translation>
    </message>
    <message>
        <source>The mesh keeps its module while other things change.</source>
        <translation>El engrane conserva su módulo mientras cambian otras cosas.</translation>
    </message>
    <message>
        <source>This train has more than %1 meshes: axes and other wheels do not follow a change of teeth by themselves.</source>
        <translation>Este tren tiene más de %1 engranes: los ejes y otras ruedas no siguen por sí mismos un cambio de dientes.</translation>
    </message>
    <message>
        <source>from the geometry</source>
        <translation>de la geometría</translation>
    </message>
    <message>
        <source>external</source>
        <translation>exterior</translation>
    </message>
    <message>
        <source>internal</source>
        <translation>interior</translation>
    </message>
    <message>
        <source>bevel</source>
        <translation>cónico</translation>
    </message>
    <message>
        <source>Teeth of gear %1</source>
        <translation>Dientes de la rueda %1</translation>
    </message>
    <message>
        <source>Teeth, tail</source>
        <translation>Dientes, cola</translation>
    </message>
    <message>
        <source>Teeth, head</source>
        <translation>Dientes, cabeza</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Relación</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Módulo</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Pitch point</source>
        <translation>Punto primitivo</translation>
    </message>
    <message>
        <source>gear %1</source>
        <translation>rueda %1</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Fijado</translation>
    </message>
    <message>
        <source>Exchange tail and head with their teeth: the arrow turns round.</source>
        <translation>Intercambiar cola y cabeza con sus dientes: la flecha se da la vuelta.</translation>
    </message>
    <message>
        <source>Change module</source>
        <translation>Cambiar módulo</translation>
    </message>
    <message>
        <source>Move pitch point</source>
        <translation>Mover punto primitivo</translation>
    </message>
    <message>
        <source>Flip mesh</source>
        <translation>Invertir engrane</translation>
    </message>
    <message>
        <source>Change teeth</source>
        <translation>Cambiar dientes</translation>
    </message>
    <message>
        <source>%1 gear meshes</source>
        <translation>%1 engranes</translation>
    </message>
    <message>
        <source>Gear mesh %1: %2 → %3</source>
        <translation>Engrane %1: %2 → %3</translation>
    </message>
    <message>
        <source>The module is pinned.</source>
        <translation>El módulo está fijado.</translation>
    </message>
    <message>
        <source>The gears have no places yet: see Problems.</source>
        <translation>Las ruedas no tienen lugar todavía: vea Problemas.</translation>
    </message>
    <message>
        <source>They are of several kinds. Select elements of one kind to change them together.</source>
        <translation>Son de varios tipos. Seleccione elementos de un tipo para cambiarlos juntos.</translation>
    </message>
    <message>
        <source>Release all couplings</source>
        <translation>Liberar todos los acoplamientos</translation>
    </message>
    <message>
        <source>Fixes it; Ctrl+Z undoes that</source>
        <translation>Lo arregla; Ctrl+Z lo deshace</translation>
    </message>
    <message>
        <source>+ Brake</source>
        <translation>+ Freno</translation>
    </message>
    <message>
        <source>Hold a link against the ground: the selected one, or choose</source>
        <translation>Retener un eslabón contra el bastidor: el seleccionado, o elegir</translation>
    </message>
    <message>
        <source>+ Clutch</source>
        <translation>+ Embrague</translation>
    </message>
    <message>
        <source>Make two links turn as one: the two selected, or choose</source>
        <translation>Hacer girar juntos dos eslabones: los dos seleccionados, o elegir</translation>
    </message>
    <message>
        <source>+ State</source>
        <translation>+ Estado</translation>
    </message>
    <message>
        <source>A new row: what is engaged together</source>
        <translation>Una fila nueva: lo que se activa junto</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Liberar todo</translation>
    </message>
    <message>
        <source>Release every brake and clutch; the motion goes on (Ctrl+B)</source>
        <translation>Liberar todos los frenos y embragues; el movimiento sigue (Ctrl+B)</translation>
    </message>
    <message>
        <source>A gearbox has brakes, which hold a link, and clutches, which make two links turn as one. Select a link and add a brake, or two links and add a clutch; then add states that engage them.</source>
        <translation>Una caja de cambios tiene frenos, que retienen un eslabón, y embragues, que hacen girar juntos dos. Seleccione un eslabón y añada un freno, o dos eslabones y añada un embrague; luego añada estados que los activen.</translation>
    </message>
    <message>
        <source>Shift table</source>
        <translation>Tabla de cambios</translation>
    </message>
    <message>
        <source>Rename state</source>
        <translation>Cambiar nombre del estado</translation>
    </message>
    <message>
        <source>Rename coupling</source>
        <translation>Cambiar nombre del acoplamiento</translation>
    </message>
    <message>
        <source>Click a state to engage it, a letter to engage or release one coupling, a dot to change a state.</source>
        <translation>Haga clic en un estado para activarlo, en una letra para activar o liberar un acoplamiento, en un punto para cambiar un estado.</translation>
    </message>
    <message>
        <source>Torques in N m, under the loads of the document.</source>
        <translation>Momentos en N m, con las cargas del documento.</translation>
    </message>
    <message>
        <source>Click a letter to engage or release; add a state, then click its dots.</source>
        <translation>Haga clic en una letra para activar o liberar; añada un estado y haga clic en sus puntos.</translation>
    </message>
    <message>
        <source>Add brake</source>
        <translation>Añadir freno</translation>
    </message>
    <message>
        <source>Add clutch</source>
        <translation>Añadir embrague</translation>
    </message>
    <message>
        <source>Link %1 with</source>
        <translation>Eslabón %1 con</translation>
    </message>
    <message>
        <source>Add state</source>
        <translation>Añadir estado</translation>
    </message>
    <message>
        <source>Engage state %1</source>
        <translation>Activar el estado %1</translation>
    </message>
    <message>
        <source>Put %1 into the state</source>
        <translation>Poner %1 en el estado</translation>
    </message>
    <message>
        <source>Take %1 out of the state</source>
        <translation>Quitar %1 del estado</translation>
    </message>
    <message>
        <source>Choose drive</source>
        <translation>Elegir el motriz</translation>
    </message>
    <message>
        <source>Choose driven</source>
        <translation>Elegir el conducido</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Motriz</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Conducido</translation>
    </message>
    <message>
        <source>Drive of all states</source>
        <translation>Motriz de todos los estados</translation>
    </message>
    <message>
        <source>Driven of all states</source>
        <translation>Conducido de todos los estados</translation>
    </message>
    <message>
        <source>Engage</source>
        <translation>Activar</translation>
    </message>
    <message>
        <source>Delete state</source>
        <translation>Eliminar estado</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Copiar tabla</translation>
    </message>
    <message>
        <source>Export table as CSV…</source>
        <translation>Exportar tabla como CSV…</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Liberar</translation>
    </message>
    <message>
        <source>Delete coupling</source>
        <translation>Eliminar acoplamiento</translation>
    </message>
    <message>
        <source>No joint is driven yet. Choose the input tool (I), then click a turning joint.</source>
        <translation>Todavía no hay ningún par accionado. Elija la herramienta de entrada (I) y haga clic en un par de revolución.</translation>
    </message>
    <message>
        <source>Show more: %1 of %2 inputs are listed</source>
        <translation>Mostrar más: se muestran %1 de %2 entradas</translation>
    </message>
    <message>
        <source>link %1 held</source>
        <translation>eslabón %1 retenido</translation>
    </message>
    <message>
        <source>links %1 and %2 as one</source>
        <translation>eslabones %1 y %2 como uno</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Engaged: %1</source>
        <translation>Activado: %1</translation>
    </message>
    <message>
        <source>Engaged: state %1, with %2</source>
        <translation>Activado: estado %1, con %2</translation>
    </message>
    <message>
        <source>Colour of link %1</source>
        <translation>Color del eslabón %1</translation>
    </message>
    <message>
        <source>Drive another joint instead; the motion stays as it is</source>
        <translation>Accionar otro par en su lugar; el movimiento no cambia</translation>
    </message>
    <message>
        <source>Nothing is solved yet</source>
        <translation>Todavía no hay nada resuelto</translation>
    </message>
    <message>
        <source>Joint %1 instead of %2</source>
        <translation>Par %1 en lugar de %2</translation>
    </message>
    <message>
        <source>Joint %1 never turns</source>
        <translation>El par %1 nunca gira</translation>
    </message>
    <message>
        <source>Joint %1 does not depend on %2; it could replace %3</source>
        <translation>El par %1 no depende de %2; podría sustituir a %3</translation>
    </message>
    <message>
        <source> or </source>
        <translation> o </translation>
    </message>
    <message>
        <source>Choose inputs</source>
        <translation>Elegir entradas</translation>
    </message>
    <message>
        <source>There is nothing to drive yet. Draw a turning joint: T, then drag.</source>
        <translation>Todavía no hay nada que accionar. Dibuje un par de revolución: T y arrastrar.</translation>
    </message>
    <message>
        <source>There is nothing to drive: the mechanism has no degree of freedom.</source>
        <translation>No hay nada que accionar: el mecanismo no tiene ningún grado de libertad.</translation>
    </message>
    <message>
        <source>Drive joint %1</source>
        <translation>Accionar el par %1</translation>
    </message>
    <message>
        <source>Drive joints %1</source>
        <translation>Accionar los pares %1</translation>
    </message>
    <message>
        <source>Set speed</source>
        <translation>Fijar velocidad</translation>
    </message>
    <message>
        <source>Side wheels</source>
        <translation>Planetarios</translation>
    </message>
    <message>
        <source>Pinions&apos; teeth</source>
        <translation>Dientes de los satélites</translation>
    </message>
    <message>
        <source>Pinions</source>
        <translation>Satélites</translation>
    </message>
    <message>
        <source>Small sun</source>
        <translation>Solar pequeño</translation>
    </message>
    <message>
        <source>Large sun</source>
        <translation>Solar grande</translation>
    </message>
    <message>
        <source>Short planet</source>
        <translation>Satélite corto</translation>
    </message>
    <message>
        <source>Long planet</source>
        <translation>Satélite largo</translation>
    </message>
    <message>
        <source>Pairs of planets</source>
        <translation>Pares de satélites</translation>
    </message>
    <message>
        <source>Suns</source>
        <translation>Solares</translation>
    </message>
    <message>
        <source>Planets&apos; teeth</source>
        <translation>Dientes de los satélites</translation>
    </message>
    <message>
        <source>Planets a set</source>
        <translation>Satélites por tren</translation>
    </message>
    <message>
        <source>Bend shaft</source>
        <translation>Eje de flexión</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Flexión</translation>
    </message>
    <message>
        <source>Roll shaft</source>
        <translation>Eje de giro</translation>
    </message>
    <message>
        <source>Idler</source>
        <translation>Intermedia</translation>
    </message>
    <message>
        <source>Idler&apos;s pinion</source>
        <translation>Piñón de la intermedia</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insertar</translation>
    </message>
    <message>
        <source>Insert a set</source>
        <translation>Insertar un tren</translation>
    </message>
    <message>
        <source>Planetary set</source>
        <translation>Tren epicicloidal</translation>
    </message>
    <message>
        <source>Reverted train</source>
        <translation>Tren recurrente</translation>
    </message>
    <message>
        <source>Bevel differential</source>
        <translation>Diferencial cónico</translation>
    </message>
    <message>
        <source>Ravigneaux set</source>
        <translation>Tren Ravigneaux</translation>
    </message>
    <message>
        <source>Simpson set</source>
        <translation>Tren Simpson</translation>
    </message>
    <message>
        <source>Bevel wrist</source>
        <translation>Muñeca cónica</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>; %1 couplings and %2 states</source>
        <translation>; %1 acoplamientos y %2 estados</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message>
        <source>%1 with %2, axis %3</source>
        <translation>%1 con %2, eje %3</translation>
    </message>
    <message>
        <source>link </source>
        <translation>eslabón </translation>
    </message>
    <message>
        <source>%1 teeth in mesh %2 with %3</source>
        <translation>%1 dientes en el engrane %2 con %3</translation>
    </message>
    <message>
        <source>brake </source>
        <translation>freno </translation>
    </message>
    <message>
        <source>clutch </source>
        <translation>embrague </translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 con %2</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>decimales</translation>
    </message>
    <message>
        <source>fractions</source>
        <translation>fracciones</translation>
    </message>
    <message>
        <source>symbols</source>
        <translation>símbolos</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>Export the matrix with its labels to a CSV file</source>
        <translation>Exportar la matriz con sus etiquetas a un archivo CSV</translation>
    </message>
    <message>
        <source>zeros ·</source>
        <translation>ceros ·</translation>
    </message>
    <message>
        <source>Show zeros as faint dots, or as 0</source>
        <translation>Mostrar los ceros como puntos tenues, o como 0</translation>
    </message>
    <message>
        <source>zeros 0</source>
        <translation>ceros 0</translation>
    </message>
    <message>
        <source>Copy ▾</source>
        <translation>Copiar ▾</translation>
    </message>
    <message>
        <source>Copy the matrix with its labels</source>
        <translation>Copiar la matriz con sus etiquetas</translation>
    </message>
    <message>
        <source>Table (TSV)</source>
        <translation>Tabla (TSV)</translation>
    </message>
    <message>
        <source>A matrix of %1 entries is too large to be copied. Export it as CSV.</source>
        <translation>Una matriz de %1 entradas es demasiado grande para copiarla. Expórtela como CSV.</translation>
    </message>
    <message>
        <source>How the entries are shown: decimals, fractions or symbols</source>
        <translation>Cómo se muestran las entradas: decimales, fracciones o símbolos</translation>
    </message>
    <message>
        <source>The equations are too many to be written out.</source>
        <translation>Las ecuaciones son demasiadas para escribirlas.</translation>
    </message>
    <message>
        <source>The matrices appear as soon as the mechanism is analysed.</source>
        <translation>Las matrices aparecen en cuanto se analiza el mecanismo.</translation>
    </message>
    <message>
        <source>Draw the first link: L, then click.</source>
        <translation>Dibuje el primer eslabón: L y clic.</translation>
    </message>
    <message>
        <source>Draw a turning joint: T, then drag from a link to another.</source>
        <translation>Dibuje un par de revolución: T y arrastrar de un eslabón a otro.</translation>
    </message>
    <message>
        <source>Draw a gear mesh: G, then drag from a gear to the one it drives.</source>
        <translation>Dibuje un engrane: G y arrastrar de una rueda a la que acciona.</translation>
    </message>
    <message>
        <source>In %1; a length with another unit, such as 1/2 in or 2.5 cm, is converted.</source>
        <translation>En %1; una longitud con otra unidad, como 1/2 in o 2,5 cm, se convierte.</translation>
    </message>
    <message>
        <source>Type a whole number from %1 to %2.</source>
        <translation>Escriba un número entero de %1 a %2.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5, 22/7 or 2*3, or a length such as 1/2 in.</source>
        <translation>Escriba un número como 12, 0,5, 22/7 o 2*3, o una longitud como 1/2 in.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5, 22/7 or 2*3.</source>
        <translation>Escriba un número como 12, 0,5, 22/7 o 2*3.</translation>
    </message>
    <message>
        <source>Type an angle such as 30, 2*15, 0.5 rad or 1/4 turns.</source>
        <translation>Escriba un ángulo como 30, 2*15, 0.5 rad o 1/4 turns.</translation>
    </message>
    <message>
        <source>Type a speed such as 12, 2*3, 90 deg/s or 1500 rpm.</source>
        <translation>Escriba una velocidad como 12, 2*3, 90 deg/s o 1500 rpm.</translation>
    </message>
    <message>
        <source>Type a torque such as 12, 2*3, 5 N cm, 3 lbf ft or 2 kW @ 1500 rpm.</source>
        <translation>Escriba un momento como 12, 2*3, 5 N cm, 3 lbf ft o 2 kW @ 1500 rpm.</translation>
    </message>
    <message>
        <source>Type a force such as 12, 2*3 or 5 kN.</source>
        <translation>Escriba una fuerza como 12, 2*3 o 5 kN.</translation>
    </message>
    <message>
        <source>No problems. Every link is tied to the ground, and the turning joints make a spanning tree.</source>
        <translation>Sin problemas. Cada eslabón está unido al bastidor, y los pares de revolución forman un árbol generador.</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Show the problems of the open document again</source>
        <translation>Mostrar de nuevo los problemas del documento abierto</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 problema</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 problemas</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. The document that was open stays open.</source>
        <translation>No se pudo abrir %1: %2. El documento que estaba abierto sigue abierto.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Coefficients as formulas in the gear ratios, or as fractions</source>
        <translation>Coeficientes como fórmulas en las relaciones de engrane, o como fracciones</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>The unit of the speeds, or the member they are taken as ratio to</source>
        <translation>La unidad de las velocidades, o el miembro al que se refieren</translation>
    </message>
    <message>
        <source>ratio to %1</source>
        <translation>relación respecto a %1</translation>
    </message>
    <message>
        <source>rpm, turns a minute</source>
        <translation>rpm, vueltas por minuto</translation>
    </message>
    <message>
        <source>%1 more joints: select one to find it here</source>
        <translation>%1 pares más: seleccione uno para encontrarlo aquí</translation>
    </message>
    <message>
        <source> (they are not independent)</source>
        <translation> (no son independientes)</translation>
    </message>
    <message>
        <source>%1 more links: select one to find it here</source>
        <translation>%1 eslabones más: seleccione uno para encontrarlo aquí</translation>
    </message>
    <message>
        <source>Every link turns on the ground</source>
        <translation>Cada eslabón gira en el bastidor</translation>
    </message>
    <message>
        <source>formulas</source>
        <translation>fórmulas</translation>
    </message>
    <message>
        <source>… (%1 in all)</source>
        <translation>… (%1 en total)</translation>
    </message>
    <message>
        <source>No joint is driven: %1 as input, at 1 rad/s each.</source>
        <translation>No hay ningún par accionado: %1 como entrada, a 1 rad/s cada uno.</translation>
    </message>
    <message>
        <source>the set of joints %1</source>
        <translation>el conjunto de pares %1</translation>
    </message>
    <message>
        <source>The two methods differ at %1 joints. Please report this document.</source>
        <translation>Los dos métodos difieren en %1 pares. Comunique este documento, por favor.</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly</source>
        <translation>Matroides = grafo T–T, exacto</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly, for all %1 joints</source>
        <translation>Matroides = grafo T–T, exacto, en los %1 pares</translation>
    </message>
    <message>
        <source>Solving exactly, by both methods …</source>
        <translation>Resolviendo exactamente, con ambos métodos …</translation>
    </message>
    <message>
        <source>The results appear as soon as the mechanism is analysed.</source>
        <translation>Los resultados aparecen en cuanto se analiza el mecanismo.</translation>
    </message>
    <message>
        <source>Rates appear when the first turning joint is drawn.</source>
        <translation>Las velocidades aparecen cuando se dibuja el primer par de revolución.</translation>
    </message>
    <message>
        <source>Every joint is an input: there is nothing left to solve for.</source>
        <translation>Todos los pares son entradas: no queda nada que resolver.</translation>
    </message>
    <message>
        <source>Ratio wanted</source>
        <translation>Relación deseada</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>solar</translation>
    </message>
    <message>
        <source>planet</source>
        <translation>satélite</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>corona</translation>
    </message>
    <message>
        <source>sun to carrier, ring held</source>
        <translation>solar a portasatélites, corona retenida</translation>
    </message>
    <message>
        <source>ring to carrier, sun held</source>
        <translation>corona a portasatélites, solar retenido</translation>
    </message>
    <message>
        <source>sun to ring, carrier held</source>
        <translation>solar a corona, portasatélites retenido</translation>
    </message>
    <message>
        <source>carrier to sun, ring held</source>
        <translation>portasatélites a solar, corona retenida</translation>
    </message>
    <message>
        <source>carrier to ring, sun held</source>
        <translation>portasatélites a corona, solar retenido</translation>
    </message>
    <message>
        <source>ring to sun, carrier held</source>
        <translation>corona a solar, portasatélites retenido</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>De, a</translation>
    </message>
    <message>
        <source>Planets</source>
        <translation>Satélites</translation>
    </message>
    <message>
        <source>Fewest teeth</source>
        <translation>Mínimo de dientes</translation>
    </message>
    <message>
        <source>Most teeth</source>
        <translation>Máximo de dientes</translation>
    </message>
    <message>
        <source>first</source>
        <translation>primera</translation>
    </message>
    <message>
        <source>second</source>
        <translation>segunda</translation>
    </message>
    <message>
        <source>third</source>
        <translation>tercera</translation>
    </message>
    <message>
        <source>fourth</source>
        <translation>cuarta</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>Vista previa de impresión</translation>
    </message>
    <message>
        <source>Page %1 of %2: %3</source>
        <translation>Página %1 de %2: %3</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>The drawing on a page of its own</source>
        <translation>El dibujo en una página propia</translation>
    </message>
    <message>
        <source>Derivation with its matrices</source>
        <translation>Deducción con sus matrices</translation>
    </message>
    <message>
        <source>Both methods worked out step by step</source>
        <translation>Ambos métodos paso a paso</translation>
    </message>
    <message>
        <source>Page setup…</source>
        <translation>Configurar página…</translation>
    </message>
    <message>
        <source>Size and orientation of the paper</source>
        <translation>Tamaño y orientación del papel</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimir…</translation>
    </message>
    <message>
        <source>Choose a printer, or a PDF file</source>
        <translation>Elegir una impresora, o un archivo PDF</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>The page that is shown</source>
        <translation>La página que se muestra</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> de %1</translation>
    </message>
    <message>
        <source>Nothing is chosen.</source>
        <translation>No hay nada elegido.</translation>
    </message>
    <message>
        <source>There is no such page to print.</source>
        <translation>No hay tal página para imprimir.</translation>
    </message>
    <message>
        <source>The printer could not be opened.</source>
        <translation>No se pudo abrir la impresora.</translation>
    </message>
    <message>
        <source>The printer stopped at page %1.</source>
        <translation>La impresora se detuvo en la página %1.</translation>
    </message>
    <message>
        <source>Printing was stopped.</source>
        <translation>Se detuvo la impresión.</translation>
    </message>
    <message>
        <source>The printer reported an error.</source>
        <translation>La impresora comunicó un error.</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept: no file can be written beside the document or in %1.</source>
        <translation>No se pueden conservar los cambios sin guardar: no se puede escribir ningún archivo junto al documento ni en %1.</translation>
    </message>
    <message>
        <source>The schematic is still being laid out. Try again in a moment.</source>
        <translation>El esquema se está ordenando todavía. Inténtelo de nuevo en un momento.</translation>
    </message>
    <message>
        <source>Finding places for %1 links …</source>
        <translation>Buscando lugar para %1 eslabones …</translation>
    </message>
    <message>
        <source>The schematic shows up to %1 links; this train has %2. Digraph and T–T graph show all of them</source>
        <translation>El esquema muestra hasta %1 eslabones; este tren tiene %2. El dígrafo y el grafo T–T los muestran todos</translation>
    </message>
    <message>
        <source>Draw the first shaft: L, then drag</source>
        <translation>Dibuje el primer eje: L y arrastrar</translation>
    </message>
    <message>
        <source>No turning joint ties a link to the ground yet. Draw a shaft: L, then drag</source>
        <translation>Todavía ningún par de revolución une un eslabón al bastidor. Dibuje un eje: L y arrastrar</translation>
    </message>
    <message>
        <source>Move axis %1</source>
        <translation>Mover el eje %1</translation>
    </message>
    <message>
        <source>%1. Alt places freely, Esc puts back</source>
        <translation>%1. Alt coloca libremente, Esc devuelve</translation>
    </message>
    <message>
        <source>Axis %1 is %2 from axis %3, module %4</source>
        <translation>El eje %1 está a %2 del eje %3, módulo %4</translation>
    </message>
    <message>
        <source>Module %1, teeth as they are</source>
        <translation>Módulo %1, dientes como están</translation>
    </message>
    <message>
        <source>%1 : %2 teeth, %3 apart, %4 off</source>
        <translation>%1 : %2 dientes, separación %3, desviación %4</translation>
    </message>
    <message>
        <source>%1. Choose tooth counts instead, or Esc</source>
        <translation>%1. Elija números de dientes en su lugar, o Esc</translation>
    </message>
    <message>
        <source>Draw shaft</source>
        <translation>Dibujar eje</translation>
    </message>
    <message>
        <source>Draw gear mesh</source>
        <translation>Dibujar engrane</translation>
    </message>
    <message>
        <source>Turning joint %1</source>
        <translation>Par de revolución %1</translation>
    </message>
    <message>
        <source>Gear mesh %1</source>
        <translation>Engrane %1</translation>
    </message>
    <message>
        <source>Search a command or a term  Ctrl+K</source>
        <translation>Buscar orden o término  Ctrl+K</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>No command or term matches “%1”.</source>
        <translation>Ninguna orden ni término coincide con «%1».</translation>
    </message>
    <message>
        <source>element</source>
        <translation>elemento</translation>
    </message>
    <message>
        <source>term</source>
        <translation>término</translation>
    </message>
    <message>
        <source>command</source>
        <translation>orden</translation>
    </message>
    <message>
        <source>Enter selects and shows it.</source>
        <translation>Intro lo selecciona y lo muestra.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Equation (%1) of the paper.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ecuación (%1) del artículo.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Shaft: drag along an axis, or on an empty area for a new axis</source>
        <translation>Eje: arrastrar a lo largo de un eje, o en un área vacía para uno nuevo</translation>
    </message>
    <message>
        <source>Shaft: release where it ends. Esc cancels</source>
        <translation>Eje: soltar donde termina. Esc cancela</translation>
    </message>
    <message>
        <source>Carried shaft: drag from the link that carries it to its place</source>
        <translation>Eje llevado: arrastrar del eslabón que lo lleva a su lugar</translation>
    </message>
    <message>
        <source>Carried shaft: release at the place of its axis. Esc cancels</source>
        <translation>Eje llevado: soltar en el lugar de su eje. Esc cancela</translation>
    </message>
    <message>
        <source>Gear mesh: drag from a shaft to the one it drives</source>
        <translation>Engrane: arrastrar de un eje al que acciona</translation>
    </message>
    <message>
        <source>Gear mesh: release on the other shaft, or beyond it for a ring. Esc cancels</source>
        <translation>Engrane: soltar en el otro eje, o más allá para una corona. Esc cancela</translation>
    </message>
    <message>
        <source>Input: click a turning joint, or the link it carries, to drive it or not</source>
        <translation>Entrada: clic en un par de revolución, o en el eslabón que lleva, para accionarlo o no</translation>
    </message>
    <message>
        <source>Drag to move the sheet</source>
        <translation>Arrastrar para mover la hoja</translation>
    </message>
    <message>
        <source>Alt places freely. Esc puts back</source>
        <translation>Alt coloca libremente. Esc devuelve</translation>
    </message>
    <message>
        <source>Gear mesh: drag from a gear to the gear it drives</source>
        <translation>Engrane: arrastrar de una rueda a la que acciona</translation>
    </message>
    <message>
        <source>Turning joint: drag from a link to the link it carries</source>
        <translation>Par de revolución: arrastrar de un eslabón al que lleva</translation>
    </message>
    <message>
        <source>Gear mesh: release on the second gear. Esc cancels</source>
        <translation>Engrane: soltar en la segunda rueda. Esc cancela</translation>
    </message>
    <message>
        <source>Turning joint: release on the link that is carried. Esc cancels</source>
        <translation>Par de revolución: soltar en el eslabón llevado. Esc cancela</translation>
    </message>
    <message>
        <source>Release to select what is inside</source>
        <translation>Soltar para seleccionar lo que hay dentro</translation>
    </message>
    <message>
        <source>Click to select, drag to move, drag on an empty area to select several</source>
        <translation>Clic para seleccionar, arrastrar para mover, arrastrar en un área vacía para seleccionar varios</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Eslabón</translation>
    </message>
    <message>
        <source>Turning joint</source>
        <translation>Revolución</translation>
    </message>
    <message>
        <source>Gear mesh</source>
        <translation>Engrane</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Link: click on an empty area</source>
        <translation>Eslabón: clic en un área vacía</translation>
    </message>
    <message>
        <source>Qt&apos;s platform &quot;%1&quot; has no windows with OpenGL.</source>
        <translation>La plataforma «%1» de Qt no tiene ventanas con OpenGL.</translation>
    </message>
    <message>
        <source>This display offers no OpenGL 3.3.</source>
        <translation>Esta pantalla no ofrece OpenGL 3.3.</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>Coordinates beside the magnitudes of links and points</source>
        <translation>Coordenadas junto a las magnitudes de eslabones y puntos</translation>
    </message>
    <message>
        <source>Save what is plotted as CSV</source>
        <translation>Guardar como CSV lo que se representa</translation>
    </message>
    <message>
        <source>Select joints or links; trace points in the 3D view.</source>
        <translation>Seleccione pares o eslabones; trace puntos en la vista 3D.</translation>
    </message>
    <message>
        <source>Nothing moves yet: the speeds appear here when the mechanism has valid inputs.</source>
        <translation>Todavía no se mueve nada: las velocidades aparecen aquí cuando el mecanismo tiene entradas válidas.</translation>
    </message>
    <message>
        <source>Wheel: zoom in time; Ctrl+wheel: in value; drag: move; click: go there; double click: all</source>
        <translation>Rueda: zoom en el tiempo; Ctrl+rueda: en el valor; arrastrar: mover; clic: ir ahí; doble clic: todo</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>a los %1 s</translation>
    </message>
    <message>
        <source>One step back (,)</source>
        <translation>Un paso atrás (,)</translation>
    </message>
    <message>
        <source>One step on (.)</source>
        <translation>Un paso adelante (.)</translation>
    </message>
    <message>
        <source>Speed and direction</source>
        <translation>Velocidad y sentido</translation>
    </message>
    <message>
        <source>Torques ×</source>
        <translation>Momentos ×</translation>
    </message>
    <message>
        <source>The motion that the torques of Dynamics cause is shown. Click to let the inputs run at their speeds again</source>
        <translation>Se muestra el movimiento que causan los momentos de Dinámica. Haga clic para que las entradas vuelvan a girar a sus velocidades</translation>
    </message>
    <message>
        <source>Backwards</source>
        <translation>Hacia atrás</translation>
    </message>
    <message>
        <source>Drag through the motion that the torques cause</source>
        <translation>Arrastrar por el movimiento que causan los momentos</translation>
    </message>
    <message>
        <source>Drag through one period of the motion</source>
        <translation>Arrastrar por un periodo del movimiento</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pausa (Espacio)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Reproducir (Espacio)</translation>
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
        <translation>Sección</translation>
    </message>
    <message>
        <source>Cut square to %1</source>
        <translation>Corte perpendicular a %1</translation>
    </message>
    <message>
        <source>Where the train is cut</source>
        <translation>Dónde se corta el tren</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Take away the other half</source>
        <translation>Quitar la otra mitad</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Vista explosionada</translation>
    </message>
    <message>
        <source>How far the parts are moved apart along their axes</source>
        <translation>Cuánto se separan las piezas a lo largo de sus ejes</translation>
    </message>
    <message>
        <source>Picture of the train</source>
        <translation>Imagen del tren</translation>
    </message>
    <message>
        <source>Software 3D</source>
        <translation>3D software</translation>
    </message>
    <message>
        <source>%1 Painted by the processor (%2): finer when nothing moves.</source>
        <translation>%1 Pintado por el procesador (%2): más fino cuando nada se mueve.</translation>
    </message>
    <message>
        <source>All of the train in the view (F)</source>
        <translation>Todo el tren en la vista (F)</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>Iso</translation>
    </message>
    <message>
        <source>Isometric (0)</source>
        <translation>Isométrica (0)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>From the front: x to the right, z up (1)</source>
        <translation>De frente: x a la derecha, z arriba (1)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>From the right: y to the right, z up (2)</source>
        <translation>Desde la derecha: y a la derecha, z arriba (2)</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>From above: x to the right, y up (3)</source>
        <translation>Desde arriba: x a la derecha, y arriba (3)</translation>
    </message>
    <message>
        <source>Cut the train open (S)</source>
        <translation>Cortar el tren (S)</translation>
    </message>
    <message>
        <source>What is shown, and how</source>
        <translation>Qué se muestra, y cómo</translation>
    </message>
    <message>
        <source>Limit reached: %1.</source>
        <translation>Límite alcanzado: %1.</translation>
    </message>
    <message>
        <source>Limit reached: %1. The motion turns round.</source>
        <translation>Límite alcanzado: %1. El movimiento da la vuelta.</translation>
    </message>
    <message>
        <source>Nothing to turn yet: place axes and give the meshes their teeth.</source>
        <translation>Todavía no hay nada que girar: coloque ejes y dé dientes a los engranes.</translation>
    </message>
    <message>
        <source>The point travels %1 %2 in %3 s.</source>
        <translation>El punto recorre %1 %2 en %3 s.</translation>
    </message>
    <message>
        <source>not asked (GEARGRAPH_3D is set)</source>
        <translation>no preguntado (GEARGRAPH_3D está definida)</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>el bastidor</translation>
    </message>
    <message>
        <source>The gears are being made …</source>
        <translation>Se están creando las ruedas …</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Sombreado</translation>
    </message>
    <message>
        <source>Lines, hidden ones left out</source>
        <translation>Líneas, sin las ocultas</translation>
    </message>
    <message>
        <source>All edges</source>
        <translation>Todas las aristas</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Eslabones</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Barra de escala</translation>
    </message>
    <message>
        <source>Pitch circles and cones</source>
        <translation>Círculos y conos primitivos</translation>
    </message>
    <message>
        <source>Pitch points</source>
        <translation>Puntos primitivos</translation>
    </message>
    <message>
        <source>Instantaneous axes</source>
        <translation>Ejes instantáneos</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Velocidades</translation>
    </message>
    <message>
        <source>Forces under the loads</source>
        <translation>Fuerzas bajo las cargas</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Orbit; Shift pans, Ctrl zooms (Blender)</source>
        <translation>Orbitar; Mayús desplaza, Ctrl hace zoom (Blender)</translation>
    </message>
    <message>
        <source>Pan; Shift orbits, Ctrl zooms (FreeCAD)</source>
        <translation>Desplazar; Mayús orbita, Ctrl hace zoom (FreeCAD)</translation>
    </message>
    <message>
        <source>Orbit; Ctrl pans, Shift zooms (SolidWorks)</source>
        <translation>Orbitar; Ctrl desplaza, Mayús hace zoom (SolidWorks)</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Botón central</translation>
    </message>
    <message>
        <source>Stop riding along</source>
        <translation>Dejar de seguir</translation>
    </message>
    <message>
        <source>Show all parts</source>
        <translation>Mostrar todas las piezas</translation>
    </message>
    <message>
        <source>Save the traced path as CSV…</source>
        <translation>Guardar la trayectoria trazada como CSV…</translation>
    </message>
    <message>
        <source>Clear traced paths</source>
        <translation>Borrar las trayectorias trazadas</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Desde atrás</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Desde la izquierda</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Desde abajo</translation>
    </message>
    <message>
        <source>Dim what is not selected</source>
        <translation>Atenuar lo no seleccionado</translation>
    </message>
    <message>
        <source>Follow %1</source>
        <translation>Seguir %1</translation>
    </message>
    <message>
        <source>Look along its axis</source>
        <translation>Mirar a lo largo de su eje</translation>
    </message>
    <message>
        <source>Trace this point</source>
        <translation>Trazar este punto</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ocultarla</translation>
    </message>
    <message>
        <source>Hide all others</source>
        <translation>Ocultar todas las demás</translation>
    </message>
    <message>
        <source>Drag the part to turn the train. Ctrl turns it alone by hand</source>
        <translation>Arrastre la pieza para girar el tren. Ctrl la gira sola, a mano</translation>
    </message>
    <message>
        <source>Drag the part to turn it by hand</source>
        <translation>Arrastre la pieza para girarla a mano</translation>
    </message>
    <message>
        <source>Drag to orbit: the train moves as its torques make it</source>
        <translation>Arrastrar orbita: el tren se mueve como lo llevan sus momentos</translation>
    </message>
    <message>
        <source>Drag to orbit: this part does not turn</source>
        <translation>Arrastrar orbita: esta pieza no gira</translation>
    </message>
    <message>
        <source>Drag to orbit, with Shift to pan; the wheel zooms</source>
        <translation>Arrastrar orbita, con Mayús desplaza; la rueda hace zoom</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>The language of the system, where the program speaks it</source>
        <translation>El idioma del sistema, si el programa lo habla</translation>
    </message>
    <message>
        <source>The language can be changed when the export is finished.</source>
        <translation>El idioma se puede cambiar cuando termine la exportación.</translation>
    </message>
    <message>
        <source>The language can be changed when the file has been read.</source>
        <translation>El idioma se puede cambiar cuando se haya leído el archivo.</translation>
    </message>
    <message>
        <source>Moving links</source>
        <translation>Eslabones móviles</translation>
    </message>
    <message>
        <source>The number of links without the ground. They bear the labels 1 to n; the ground is 0.</source>
        <translation>El número de eslabones sin el bastidor. Llevan las etiquetas 1 a n; el bastidor es 0.</translation>
    </message>
    <message>
        <source>Turning joints</source>
        <translation>Pares de revolución</translation>
    </message>
    <message>
        <source>The number of turning pairs. They bear the labels n+1 to n+t. As a spanning tree they are as many as the moving links.</source>
        <translation>El número de pares de revolución. Llevan las etiquetas n+1 a n+t. Como árbol generador son tantos como los eslabones móviles.</translation>
    </message>
    <message>
        <source>Gear meshes</source>
        <translation>Engranes</translation>
    </message>
    <message>
        <source>The number of gear pairs. They bear the labels n+t+1 to n+t+c. Each closes one cycle of the basis.</source>
        <translation>El número de pares de engranajes. Llevan las etiquetas n+t+1 a n+t+c. Cada uno cierra un ciclo de la base.</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rango</translation>
    </message>
    <message>
        <source>The number of independent equations that the meshes put on the turning joints: the rank r of the coefficient matrix P.</source>
        <translation>El número de ecuaciones independientes que los engranes imponen a los pares de revolución: el rango r de la matriz de coeficientes P.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Grados de libertad</translation>
    </message>
    <message>
        <source>How many joints have to be driven so that the motion of all others follows: E = t − r.</source>
        <translation>Cuántos pares hay que accionar para que quede determinado el movimiento de todos los demás: E = t − r.</translation>
    </message>
    <message>
        <source>Incidence matrix</source>
        <translation>Matriz de incidencia</translation>
    </message>
    <message>
        <source>A row for each link and a column for each joint and mesh: 1 where its arrow ends, −1 where it begins.</source>
        <translation>Una fila por eslabón y una columna por par y engrane: 1 donde termina su flecha, −1 donde empieza.</translation>
    </message>
    <message>
        <source>Reduced incidence matrix</source>
        <translation>Matriz de incidencia reducida</translation>
    </message>
    <message>
        <source>The incidence matrix without the ground&apos;s row, so that its rows are independent. G holds the turning joints, G* the meshes.</source>
        <translation>La matriz de incidencia sin la fila del bastidor, de modo que sus filas son independientes. G contiene los pares de revolución, G* los engranes.</translation>
    </message>
    <message>
        <source>Path matrix</source>
        <translation>Matriz de caminos</translation>
    </message>
    <message>
        <source>A column for each link tells its walk through the tree to the ground: 1 where the walk runs along a joint, −1 where it runs against it.</source>
        <translation>Una columna por eslabón describe su camino por el árbol hasta el bastidor: 1 donde el camino sigue un par, −1 donde va en contra.</translation>
    </message>
    <message>
        <source>Spanning-tree matrix</source>
        <translation>Matriz del árbol generador</translation>
    </message>
    <message>
        <source>A row for each mesh tells which turning joints its cycle runs along (1) or against (−1): T = G*ᵀ Zᵀ.</source>
        <translation>Una fila por engrane dice qué pares de revolución recorre su ciclo a favor (1) o en contra (−1): T = G*ᵀ Zᵀ.</translation>
    </message>
    <message>
        <source>Cycle-basis matrix</source>
        <translation>Matriz de la base de ciclos</translation>
    </message>
    <message>
        <source>A row for each cycle that a mesh closes: T holds its turning joints, the unit matrix U its mesh.</source>
        <translation>Una fila por cada ciclo que cierra un engrane: T contiene sus pares de revolución, la matriz unidad U su engrane.</translation>
    </message>
    <message>
        <source>Fundamental cutset matrix</source>
        <translation>Matriz de cortes fundamentales</translation>
    </message>
    <message>
        <source>A row for each turning joint tells which edges join the two halves that the tree falls into without it.</source>
        <translation>Una fila por par de revolución dice qué aristas unen las dos mitades en que se divide el árbol sin él.</translation>
    </message>
    <message>
        <source>The mechanism as a directed graph: a node for each link, a solid arrow for each turning joint, a dashed arrow for each gear mesh.</source>
        <translation>El mecanismo como grafo dirigido: un nodo por eslabón, una flecha continua por par de revolución, una discontinua por engrane.</translation>
    </message>
    <message>
        <source>Functional schematic</source>
        <translation>Esquema funcional</translation>
    </message>
    <message>
        <source>The mechanism in section, with the symbols of ISO 3952: axes dash-dotted, shafts as thick lines, bearings as bars about them, gears as pitch lines, the frame hatched.</source>
        <translation>El mecanismo en sección, con los símbolos de ISO 3952: ejes geométricos de trazo y punto, árboles como líneas gruesas, cojinetes como barras a su alrededor, ruedas como líneas primitivas, el bastidor rayado.</translation>
    </message>
    <message>
        <source>A rigid body: a gear, a carrier arm, a shaft, or several of them in one.</source>
        <translation>Un cuerpo rígido: una rueda, un brazo portasatélites, un árbol, o varios de ellos en uno.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Bastidor</translation>
    </message>
    <message>
        <source>The fixed link. All others are connected to it by turning joints.</source>
        <translation>El eslabón fijo. Todos los demás están unidos a él por pares de revolución.</translation>
    </message>
    <message>
        <source>Two links that turn relative to each other about an axis. Positive speed turns the head about the axis&apos; direction relative to the tail.</source>
        <translation>Dos eslabones que giran uno respecto al otro en torno a un eje. Una velocidad positiva gira la cabeza respecto a la cola en torno a la dirección del eje.</translation>
    </message>
    <message>
        <source>Two toothed wheels that roll on each other at a pitch point.</source>
        <translation>Dos ruedas dentadas que ruedan una sobre otra en un punto primitivo.</translation>
    </message>
    <message>
        <source>A turning joint that a motor drives at a speed of its own. There are as many as degrees of freedom.</source>
        <translation>Un par de revolución que un motor acciona a una velocidad propia. Hay tantos como grados de libertad.</translation>
    </message>
    <message>
        <source>The line that turning joints turn about, the level of the T–T graph. Joints that stay coaxial share one.</source>
        <translation>La recta en torno a la que giran los pares de revolución, el nivel del grafo T–T. Los pares que siguen coaxiales comparten uno.</translation>
    </message>
    <message>
        <source>Point of the axis</source>
        <translation>Punto del eje</translation>
    </message>
    <message>
        <source>A point that the axis goes through in the reference pose. Without it the axis is placed from the tooth counts.</source>
        <translation>Un punto por el que pasa el eje en la posición de referencia. Sin él, el eje se coloca según los números de dientes.</translation>
    </message>
    <message>
        <source>Direction of the axis</source>
        <translation>Dirección del eje</translation>
    </message>
    <message>
        <source>The direction of the axis in the reference pose, of any length but 0. Positive speed turns about it by the right-hand rule.</source>
        <translation>La dirección del eje en la posición de referencia, de cualquier longitud menos 0. Una velocidad positiva gira en torno a ella por la regla de la mano derecha.</translation>
    </message>
    <message>
        <source>Where along the axis the bearing is drawn, from the axis&apos; point.</source>
        <translation>Dónde se dibuja el cojinete a lo largo del eje, desde el punto del eje.</translation>
    </message>
    <message>
        <source>Joint limits</source>
        <translation>Límites del par</translation>
    </message>
    <message>
        <source>How far the joint may turn from the reference pose, both ways, in degrees.</source>
        <translation>Cuánto puede girar el par desde la posición de referencia, en ambos sentidos, en grados.</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Dientes</translation>
    </message>
    <message>
        <source>The whole number of teeth of a wheel. Pitch diameters are proportional to it.</source>
        <translation>El número entero de dientes de una rueda. Los diámetros primitivos son proporcionales a él.</translation>
    </message>
    <message>
        <source>The pitch diameter of a wheel over its teeth, one for both wheels of a mesh; of bevels at the large end. Another module moves the axes and changes no ratio.</source>
        <translation>El diámetro primitivo de una rueda entre sus dientes, el mismo para ambas ruedas de un engrane; en las cónicas, en el extremo grande. Otro módulo mueve los ejes y no cambia ninguna relación.</translation>
    </message>
    <message>
        <source>Kind of mesh</source>
        <translation>Tipo de engrane</translation>
    </message>
    <message>
        <source>Where the two pitch surfaces touch in the reference pose. Without it the point follows from axes and teeth.</source>
        <translation>Donde se tocan las dos superficies primitivas en la posición de referencia. Sin indicarlo, el punto se deduce de los ejes y los dientes.</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Relación de engrane</translation>
    </message>
    <message>
        <source>The teeth of the mesh&apos;s tail over those of its head.</source>
        <translation>Los dientes de la cola del engrane entre los de su cabeza.</translation>
    </message>
    <message>
        <source>Spanning tree</source>
        <translation>Árbol generador</translation>
    </message>
    <message>
        <source>The turning joints, if they tie every link to the ground and close no loop.</source>
        <translation>Los pares de revolución, si unen cada eslabón al bastidor sin cerrar ningún lazo.</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>A mesh and the path through the tree that leads back from its head to its tail.</source>
        <translation>Un engrane y el camino por el árbol que vuelve de su cabeza a su cola.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>The paper&apos;s number of a link, joint or mesh. It follows from the order of the elements.</source>
        <translation>El número del artículo para un eslabón, par o engrane. Se deduce del orden de los elementos.</translation>
    </message>
    <message>
        <source>Screw</source>
        <translation>Tornillo</translation>
    </message>
    <message>
        <source>A joint&apos;s axis as seen from a pitch point: its unit direction (L M N) and its moment (P Q R), the velocity that the point gets for one unit of speed.</source>
        <translation>El eje de un par visto desde un punto primitivo: su dirección unitaria (L M N) y su momento (P Q R), la velocidad que recibe el punto por una unidad de velocidad.</translation>
    </message>
    <message>
        <source>Coefficient matrix</source>
        <translation>Matriz de coeficientes</translation>
    </message>
    <message>
        <source>A row for each mesh: the moment of each joint of its cycle about the pitch point, times T. P θ̇ = 0 holds for every motion; divided by the head&apos;s radius a row holds only ratios and ones.</source>
        <translation>Una fila por engrane: el momento de cada par de su ciclo respecto al punto primitivo, por T. P θ̇ = 0 vale para todo movimiento; dividida por el radio de la cabeza, una fila solo contiene relaciones y unos.</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Solución</translation>
    </message>
    <message>
        <source>The rate of every other joint for one unit of each input: minus the inverse of P&apos;s output part times its input part.</source>
        <translation>La velocidad de cada otro par por una unidad de cada entrada: menos la inversa de la parte de salida de P por su parte de entrada.</translation>
    </message>
    <message>
        <source>The mechanism after Tsai and Tokad: a node for each link, a branch of the tree for each turning joint with the level it turns on, and for each gear mesh two chords, from its gears to their carrier arm. An arrow from i to k carries the velocity of link i relative to link k.</source>
        <translation>El mecanismo según Tsai y Tokad: un nodo por eslabón, una rama del árbol por par de revolución con el nivel en que gira, y por engrane dos cuerdas, de sus ruedas a su brazo portasatélites. Una flecha de i a k lleva la velocidad del eslabón i respecto al eslabón k.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>The axis that a branch of the T–T graph turns about. Joints that stay coaxial in every motion are on one level.</source>
        <translation>El eje en torno al que gira una rama del grafo T–T. Los pares que siguen coaxiales en todo movimiento están en un nivel.</translation>
    </message>
    <message>
        <source>Transfer vertex</source>
        <translation>Vértice de transferencia</translation>
    </message>
    <message>
        <source>The carrier arm of a gear mesh: the node on the walk from gear to gear through the tree where the level changes.</source>
        <translation>El brazo portasatélites de un engrane: el nodo, en el camino de rueda a rueda por el árbol, donde cambia el nivel.</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Cuerda</translation>
    </message>
    <message>
        <source>A thin line from a gear of a mesh to its transfer vertex. The two chords of a mesh bear the same number of primes. Chords are no part of the tree: each closes one f-circuit.</source>
        <translation>Una línea fina de una rueda de un engrane a su vértice de transferencia. Las dos cuerdas de un engrane llevan el mismo número de primas. Las cuerdas no son parte del árbol: cada una cierra un circuito f.</translation>
    </message>
    <message>
        <source>Terminal equation</source>
        <translation>Ecuación terminal</translation>
    </message>
    <message>
        <source>The relation between the two chords of a mesh: the velocity of gear i relative to the carrier arm is that of gear j times ± N(j) / N(i), plus where both gears turn the same way, seen from the arm.</source>
        <translation>La relación entre las dos cuerdas de un engrane: la velocidad de la rueda i respecto al brazo portasatélites es la de la rueda j por ± N(j) / N(i), más si ambas ruedas giran en el mismo sentido, vistas desde el brazo.</translation>
    </message>
    <message>
        <source>f-circuit</source>
        <translation>Circuito f</translation>
    </message>
    <message>
        <source>A chord and the branches between its two ends: the velocity of the chord is the sum of theirs, with signs by their direction. Eqs. (31) to (38) are the paper&apos;s.</source>
        <translation>Una cuerda y las ramas entre sus dos extremos: la velocidad de la cuerda es la suma de las suyas, con signos según su dirección. Las ecs. (31) a (38) son las del artículo.</translation>
    </message>
    <message>
        <source>
Drag to change the load; W types it</source>
        <translation>
Arrastrar cambia la carga; W la escribe</translation>
    </message>
    <message>
        <source>%1 N m. %2</source>
        <translation>%1 N m. %2</translation>
    </message>
    <message>
        <source>What is plotted</source>
        <translation>Qué se representa</translation>
    </message>
    <message>
        <source>torques that hold the loads</source>
        <translation>momentos que sostienen las cargas</translation>
    </message>
    <message>
        <source>What it is plotted over; all else stays as it is</source>
        <translation>Respecto a qué se representa; todo lo demás queda como está</translation>
    </message>
    <message>
        <source>What it is plotted over</source>
        <translation>Respecto a qué se representa</translation>
    </message>
    <message>
        <source>over</source>
        <translation>sobre</translation>
    </message>
    <message>
        <source>The efficiency could not be followed: %1</source>
        <translation>No se pudo seguir el rendimiento: %1</translation>
    </message>
    <message>
        <source>A plot needs loads that are held, one way to hold them, and a motion.</source>
        <translation>Un gráfico necesita cargas sostenidas, una sola manera de sostenerlas y un movimiento.</translation>
    </message>
    <message>
        <source>torque, N m</source>
        <translation>momento, N m</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>hacia delante</translation>
    </message>
    <message>
        <source>Plot of the efficiency</source>
        <translation>Gráfico del rendimiento</translation>
    </message>
    <message>
        <source>The pointer, or the left and right arrow keys, read the values</source>
        <translation>El puntero o las flechas izquierda y derecha leen los valores</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>T: torque in a joint; M: torque of a mesh on the part beyond the joint; both about the joint&apos;s axis. What the joint cuts off, and what crosses, is lit in all views.</source>
        <translation>T: momento en un par; M: momento de un engrane sobre la parte más allá del par; ambos respecto al eje del par. Lo que el par separa y lo que cruza se ilumina en todas las vistas.</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Contenido del manual</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Atrás (Alt+Izquierda)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Adelante (Alt+Derecha)</translation>
    </message>
    <message>
        <source>Find in the manual  Ctrl+F</source>
        <translation>Buscar en el manual  Ctrl+F</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>Buscar en el manual</translation>
    </message>
    <message>
        <source>Return goes to the next place, through all pages (Ctrl+F)</source>
        <translation>Intro va al siguiente lugar, por todas las páginas (Ctrl+F)</translation>
    </message>
    <message>
        <source>Manual: %1</source>
        <translation>Manual: %1</translation>
    </message>
    <message>
        <source>This is the first page that you opened.</source>
        <translation>Esta es la primera página que abrió.</translation>
    </message>
    <message>
        <source>This is the last page that you opened.</source>
        <translation>Esta es la última página que abrió.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>No se encontró</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Help &gt; Tour shows it again (Esc)</source>
        <translation>Ayuda &gt; Recorrido lo muestra de nuevo (Esc)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>The part before (Left)</source>
        <translation>La parte anterior (Izquierda)</translation>
    </message>
    <message>
        <source>This is the beginning.</source>
        <translation>Este es el comienzo.</translation>
    </message>
    <message>
        <source>To the window (Return)</source>
        <translation>A la ventana (Intro)</translation>
    </message>
    <message>
        <source>The next part (Right)</source>
        <translation>La parte siguiente (Derecha)</translation>
    </message>
    <message>
        <source>F1 opens the page of the manual.</source>
        <translation>F1 abre la página del manual.</translation>
    </message>
    <message>
        <source>A lesson is played in this window: take the tour in another one.</source>
        <translation>En esta ventana se sigue una lección: haga el recorrido en otra.</translation>
    </message>
    <message>
        <source>Web page with exercises (*.html)</source>
        <translation>Página web con ejercicios (*.html)</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism: export it without exercises.</source>
        <translation>No se puede preguntar nada sobre este mecanismo: expórtelo sin ejercicios.</translation>
    </message>
    <message>
        <source>Load a joint or a link: drag for its torque, or click and type 10 Nm; where one is selected, its torque is typed at once</source>
        <translation>Cargar un par o un eslabón: arrastre para su momento, o haga clic y escriba 10 Nm; si hay uno seleccionado, su momento se escribe enseguida</translation>
    </message>
    <message>
        <source>T&amp;orque…</source>
        <translation>Mo&amp;mento…</translation>
    </message>
    <message>
        <source>Find a command, an element, a term or a page of the manual</source>
        <translation>Encontrar una orden, un elemento, un término o una página del manual</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>The page of the manual about what has the focus</source>
        <translation>La página del manual sobre lo que tiene el foco</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this</source>
        <translation>¿&amp;Qué es esto?</translation>
    </message>
    <message>
        <source>Then click something to learn what it is for</source>
        <translation>Después haga clic en algo para saber para qué sirve</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Recorrido</translation>
    </message>
    <message>
        <source>The parts of the window in two minutes</source>
        <translation>Las partes de la ventana en dos minutos</translation>
    </message>
    <message>
        <source>There is no command %1 in this window.</source>
        <translation>No hay ninguna orden %1 en esta ventana.</translation>
    </message>
    <message>
        <source>Welcome to GearGraph</source>
        <translation>Bienvenido a GearGraph</translation>
    </message>
    <message>
        <source>Gear trains as graphs, as equations, and in motion. The tour shows the parts of the window with a robot as example; it takes two minutes. Help &gt; Tour repeats it.</source>
        <translation>Trenes de engranajes como grafos, como ecuaciones y en movimiento. El recorrido muestra las partes de la ventana con un robot como ejemplo; dura dos minutos. Ayuda &gt; Recorrido lo repite.</translation>
    </message>
    <message>
        <source>Draw links, joints and meshes</source>
        <translation>Dibuje eslabones, pares y engranes</translation>
    </message>
    <message>
        <source>Each circle is a link, each solid arrow a turning joint, each dashed arrow a pair of gears. Press L and click for a link, T or G and drag from one link to another. Everything can be undone.</source>
        <translation>Cada círculo es un eslabón, cada flecha continua un par de revolución, cada flecha discontinua un par de ruedas. Pulse L y haga clic para un eslabón, T o G y arrastre de un eslabón a otro. Todo se puede deshacer.</translation>
    </message>
    <message>
        <source>The Matroid method</source>
        <translation>El método de matroides</translation>
    </message>
    <message>
        <source>The matrices follow from the drawing at once. Rest the mouse on an entry to have it explained; the arrow that it stands for lights up. Each row of C is the cycle that a mesh closes.</source>
        <translation>Las matrices siguen al dibujo enseguida. Deje el ratón sobre una entrada para que se explique; la flecha que representa se ilumina. Cada fila de C es el ciclo que cierra un engrane.</translation>
    </message>
    <message>
        <source>The T–T graph method</source>
        <translation>El método del grafo T–T</translation>
    </message>
    <message>
        <source>The same mechanism by the second method: levels on the branches, two chords for each mesh, carrier arms with a second ring. Select a mesh to see its equations. Both methods give the same speeds.</source>
        <translation>El mismo mecanismo por el segundo método: niveles en las ramas, dos cuerdas por engrane, portasatélites con un segundo anillo. Seleccione un engrane para ver sus ecuaciones. Ambos métodos dan las mismas velocidades.</translation>
    </message>
    <message>
        <source>The gears in motion</source>
        <translation>Las ruedas en movimiento</translation>
    </message>
    <message>
        <source>Space plays. Drag a gear to turn the train by hand, drag elsewhere to look from another side. Section cuts it open.</source>
        <translation>Espacio reproduce. Arrastre una rueda para girar el tren a mano, o fuera de ella para verlo desde otro lado. Sección lo corta.</translation>
    </message>
    <message>
        <source>Motors and speeds</source>
        <translation>Motores y velocidades</translation>
    </message>
    <message>
        <source>The sliders set the speeds of the motors. Below are the speeds of all other joints: as formulas in the gear ratios, and as they are now.</source>
        <translation>Los deslizadores fijan las velocidades de los motores. Debajo están las velocidades de los demás pares: como fórmulas en las relaciones y como son ahora.</translation>
    </message>
    <message>
        <source>When something is wrong</source>
        <translation>Cuando algo está mal</translation>
    </message>
    <message>
        <source>Problems says what is wrong, where, and what to do. A click on a line shows the place, and many lines bring a button that mends it.</source>
        <translation>Problemas indica qué está mal, dónde y qué hacer. Un clic en una línea muestra el lugar, y muchas líneas traen un botón que lo corrige.</translation>
    </message>
    <message>
        <source>Learn, and find anything</source>
        <translation>Aprender y encontrarlo todo</translation>
    </message>
    <message>
        <source>Learn &gt; Lessons is a course from one gear pair to this robot. Ctrl+K finds commands, terms and pages of the manual. F1 opens the page about what you are working with.</source>
        <translation>Aprender &gt; Lecciones es un curso desde un par de ruedas hasta este robot. Ctrl+K encuentra órdenes, términos y páginas del manual. F1 abre la página de aquello con lo que trabaja.</translation>
    </message>
    <message>
        <source>Find a command, an element, a term or a page of the manual (Ctrl+K)</source>
        <translation>Encontrar una orden, un elemento, un término o una página del manual (Ctrl+K)</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>manual</translation>
    </message>
    <message>
        <source>F1 shows it with a picture and its lesson. Type to search on; Esc closes.</source>
        <translation>F1 lo muestra con una imagen y su lección. Escriba para seguir buscando; Esc cierra.</translation>
    </message>
    <message>
        <source>Load: drag from a turning joint or a link for its torque, or click it and type 10 Nm</source>
        <translation>Carga: arrastre desde un par de revolución o un eslabón para su momento, o haga clic y escriba 10 Nm</translation>
    </message>
    <message>
        <source>Load: to the right or upwards is more; Alt: tenths. Esc puts back</source>
        <translation>Carga: a la derecha o hacia arriba es más; Alt: décimas. Esc lo devuelve</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Carga</translation>
    </message>
    <message>
        <source>Check &amp;my matrices…</source>
        <translation>Comprobar &amp;mis matrices…</translation>
    </message>
    <message>
        <source>Matrices and equations that you have worked out, beside the derived ones</source>
        <translation>Matrices y ecuaciones que ha obtenido, junto a las deducidas</translation>
    </message>
    <message>
        <source>Your matrix</source>
        <translation>Su matriz</translation>
    </message>
    <message>
        <source>The derived matrix, in your order</source>
        <translation>La matriz deducida, en su orden</translation>
    </message>
    <message>
        <source>Check my matrices</source>
        <translation>Comprobar mis matrices</translation>
    </message>
    <message>
        <source>Your matrix or equations</source>
        <translation>Su matriz o sus ecuaciones</translation>
    </message>
    <message>
        <source>CSV, LaTeX, MATLAB, NumPy or plain text; equations, one a line</source>
        <translation>CSV, LaTeX, MATLAB, NumPy o texto sin formato; ecuaciones, una por línea</translation>
    </message>
    <message>
        <source>Type or paste a matrix or equations: CSV, LaTeX, MATLAB, NumPy, plain text</source>
        <translation>Escriba o pegue una matriz o ecuaciones: CSV, LaTeX, MATLAB, NumPy, texto sin formato</translation>
    </message>
    <message>
        <source>Which matrix it is</source>
        <translation>Qué matriz es</translation>
    </message>
    <message>
        <source>Which matrix it is; recognised by its name, size and entries</source>
        <translation>Qué matriz es; se reconoce por su nombre, tamaño y entradas</translation>
    </message>
    <message>
        <source>Recognise the matrix</source>
        <translation>Reconocer la matriz</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Qué difiere</translation>
    </message>
    <message>
        <source>Select one to see its entries, and its elements in the drawings</source>
        <translation>Seleccione una para ver sus entradas y sus elementos en los dibujos</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Abrir un archivo…</translation>
    </message>
    <message>
        <source>Read the matrix or the equations from a text file</source>
        <translation>Leer la matriz o las ecuaciones de un archivo de texto</translation>
    </message>
    <message>
        <source>Example of the paper</source>
        <translation>Ejemplo del artículo</translation>
    </message>
    <message>
        <source>The rows of equation (45) under the labels of equation (25), for the robot of the paper</source>
        <translation>Las filas de la ecuación (45) con las etiquetas de la ecuación (25), para el robot del artículo</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>La suya</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>Deducida</translation>
    </message>
    <message>
        <source>Open a matrix or equations</source>
        <translation>Abrir una matriz o ecuaciones</translation>
    </message>
    <message>
        <source>Texts (*.csv *.tsv *.txt *.tex *.m *.py);;All files (*)</source>
        <translation>Textos (*.csv *.tsv *.txt *.tex *.m *.py);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Matrices of at most %1 moving links are compared.</source>
        <translation>Se comparan matrices de hasta %1 eslabones móviles.</translation>
    </message>
    <message>
        <source>This text is longer than any matrix that is compared.</source>
        <translation>Este texto es más largo que cualquier matriz que se compara.</translation>
    </message>
    <message>
        <source>Your matrix or equations against the derived ones</source>
        <translation>Su matriz o sus ecuaciones frente a las deducidas</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>✓ Right: %1</source>
        <translation>✓ Correcto: %1</translation>
    </message>
    <message>
        <source>✗ Not right yet: %1</source>
        <translation>✗ Aún no es correcto: %1</translation>
    </message>
    <message>
        <source>? Only labels can tell: %1</source>
        <translation>? Solo las etiquetas pueden decidirlo: %1</translation>
    </message>
    <message>
        <source>Derived: %1</source>
        <translation>Deducida: %1</translation>
    </message>
    <message>
        <source>Yours: %1</source>
        <translation>La suya: %1</translation>
    </message>
    <message>
        <source>equation</source>
        <translation>ecuación</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredicto</translation>
    </message>
    <message>
        <source>right</source>
        <translation>correcta</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>incorrecta</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>✓ All that is written is right</source>
        <translation>✓ Todo lo escrito es correcto</translation>
    </message>
    <message>
        <source>✗ Not right yet: %1 of %2</source>
        <translation>✗ Aún no son correctas: %1 de %2</translation>
    </message>
    <message>
        <source>How many questions of each kind are asked</source>
        <translation>Cuántas preguntas de cada tipo se hacen</translation>
    </message>
    <message>
        <source>The same seed makes the same questions, here and on the command line</source>
        <translation>La misma semilla da las mismas preguntas, aquí y en la línea de órdenes</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Ejercicios</translation>
    </message>
    <message>
        <source>Sheets that differ in their questions: one for each student, or one for all</source>
        <translation>Hojas con preguntas distintas: una para cada estudiante o una para todos</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Practicar</translation>
    </message>
    <message>
        <source>Export sheets…</source>
        <translation>Exportar hojas…</translation>
    </message>
    <message>
        <source>Export handout…</source>
        <translation>Exportar el folleto…</translation>
    </message>
    <message>
        <source>Questions about this mechanism</source>
        <translation>Preguntas sobre este mecanismo</translation>
    </message>
    <message>
        <source>Kinds of questions</source>
        <translation>Tipos de preguntas</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Preguntas</translation>
    </message>
    <message>
        <source>Of each kind</source>
        <translation>De cada tipo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Choose every kind that the mechanism gives</source>
        <translation>Elegir todos los tipos que permite el mecanismo</translation>
    </message>
    <message>
        <source>Choose no kind, to begin with a few</source>
        <translation>No elegir ningún tipo, para empezar con pocos</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Tipos</translation>
    </message>
    <message>
        <source>For a class</source>
        <translation>Para una clase</translation>
    </message>
    <message>
        <source>The heading of sheets and handouts</source>
        <translation>El título de las hojas y los folletos</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Variantes</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Página web</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Sheets and solutions in this form</source>
        <translation>Hojas y soluciones en este formato</translation>
    </message>
    <message>
        <source>Sheets as</source>
        <translation>Hojas como</translation>
    </message>
    <message>
        <source>Exercises are made of mechanisms of at most %1 moving links.</source>
        <translation>Los ejercicios se hacen de mecanismos de %1 eslabones móviles como máximo.</translation>
    </message>
    <message>
        <source>On the command line: %1</source>
        <translation>En la línea de órdenes: %1</translation>
    </message>
    <message>
        <source>The mechanism gives no such question: %1.</source>
        <translation>El mecanismo no permite esta pregunta: %1.</translation>
    </message>
    <message>
        <source>Choose a kind of question first.</source>
        <translation>Elija primero un tipo de pregunta.</translation>
    </message>
    <message>
        <source>A sheet has at most %1 questions.</source>
        <translation>Una hoja tiene %1 preguntas como máximo.</translation>
    </message>
    <message>
        <source>Answer the questions in a window of their own, with hints and reasons</source>
        <translation>Responder las preguntas en una ventana propia, con pistas y razones</translation>
    </message>
    <message>
        <source>At most %1 questions are practised at once.</source>
        <translation>Se practican %1 preguntas a la vez como máximo.</translation>
    </message>
    <message>
        <source>Sheets, solutions and files for answers, which geargraph-cli exercises grade reads</source>
        <translation>Hojas, soluciones y archivos de respuestas, que lee geargraph-cli exercises grade</translation>
    </message>
    <message>
        <source>Choose a form of the sheets first.</source>
        <translation>Elija primero un formato de las hojas.</translation>
    </message>
    <message>
        <source>The mechanism with these questions as one page for any browser, or for a learning platform</source>
        <translation>El mecanismo con estas preguntas como una página para cualquier navegador o para una plataforma de aprendizaje</translation>
    </message>
    <message>
        <source>Other exercises ›</source>
        <translation>Otros ejercicios ›</translation>
    </message>
    <message>
        <source>Package for learning platforms, SCORM 1.2 (*.zip)</source>
        <translation>Paquete para plataformas de aprendizaje, SCORM 1.2 (*.zip)</translation>
    </message>
    <message>
        <source>Package with exercises, SCORM 1.2 (*.zip)</source>
        <translation>Paquete con ejercicios, SCORM 1.2 (*.zip)</translation>
    </message>
    <message>
        <source>Folder in which the sheets&apos; folder is made</source>
        <translation>Carpeta en la que se crea la carpeta de las hojas</translation>
    </message>
    <message>
        <source>%1 exercises %2</source>
        <translation>%1 ejercicios %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already: no sheet was written.</source>
        <translation>«%1» ya existe: no se ha escrito ninguna hoja.</translation>
    </message>
    <message>
        <source>One page for any browser, also on a phone and without a network: drawings, matrices, solution, derivation and the train in 3D, with inputs that move, and exercises if you choose them; also as a package for learning platforms</source>
        <translation>Una página para cualquier navegador, también en el teléfono y sin red: dibujos, matrices, solución, deducción y el tren en 3D, con entradas que se mueven y, si lo elige, ejercicios; también como paquete para plataformas de aprendizaje</translation>
    </message>
    <message>
        <source>&amp;Exercises…</source>
        <translation>E&amp;jercicios…</translation>
    </message>
    <message>
        <source>Questions about this mechanism, to practise, or as sheets and handouts for a class</source>
        <translation>Preguntas sobre este mecanismo, para practicar o como hojas y folletos para una clase</translation>
    </message>
    <message>
        <source>Questions: %1</source>
        <translation>Preguntas: %1</translation>
    </message>
    <message>
        <source>‹ Exercises</source>
        <translation>‹ Ejercicios</translation>
    </message>
    <message>
        <source>Other questions, or another seed</source>
        <translation>Otras preguntas u otra semilla</translation>
    </message>
    <message>
        <source>The same at any torque</source>
        <translation>Igual con cualquier momento</translation>
    </message>
    <message>
        <source>Losses of meshes are proportional to their power, whether an efficiency or a coefficient of friction is stated: all loads scaled alike leave the efficiency as it is, so there is no plot over the torque. Of several loads only the proportions matter.</source>
        <translation>Las pérdidas de los engranes son proporcionales a su potencia, tanto si se indica un rendimiento como un coeficiente de rozamiento: si todas las cargas cambian en la misma proporción, el rendimiento no varía; por eso no hay gráfico sobre el momento. Con varias cargas solo importan las proporciones.</translation>
    </message>
    <message>
        <source>Exactly %1</source>
        <translation>Exactamente %1</translation>
    </message>
    <message>
        <source>both methods agree</source>
        <translation>ambos métodos coinciden</translation>
    </message>
    <message>
        <source>Row %1: speeds of mesh %1</source>
        <translation>Fila %1: velocidades del engrane %1</translation>
    </message>
    <message>
        <source>Column %1: torque in joint %1</source>
        <translation>Columna %1: momento en el par %1</translation>
    </message>
    <message>
        <source>shared in unknown parts, or not held</source>
        <translation>repartido en partes desconocidas, o sin equilibrar</translation>
    </message>
    <message>
        <source>here %1 N m</source>
        <translation>aquí %1 N m</translation>
    </message>
    <message>
        <source>Documents and tables (*.geargraph *.csv *.tsv);;GearGraph documents (*.geargraph);;Tables of documents (*.csv *.tsv);;All files (*)</source>
        <translation>Documentos y tablas (*.geargraph *.csv *.tsv);;Documentos de GearGraph (*.geargraph);;Tablas de documentos (*.csv *.tsv);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>%1 was imported. Save writes a document of its own.</source>
        <translation>%1 se ha importado. Guardar escribe un documento propio.</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>Lay axis %1</source>
        <translation>Orientar el eje %1</translation>
    </message>
    <message>
        <source>it is pinned</source>
        <translation>está fijado</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Rendimiento</translation>
    </message>
    <message>
        <source>i: the teeth of the tail&apos;s gear over those of the head&apos;s; η: the efficiency of a mesh. It holds as long as the same gears drive.</source>
        <translation>i: los dientes de la rueda de la cola entre los de la cabeza; η: el rendimiento de un engrane. Vale mientras accionen las mismas ruedas.</translation>
    </message>
    <message>
        <source>Efficiency of a mesh</source>
        <translation>Rendimiento de un engrane</translation>
    </message>
    <message>
        <source>Set efficiency</source>
        <translation>Fijar el rendimiento</translation>
    </message>
    <message>
        <source>Every mesh states an efficiency or a friction of its own.</source>
        <translation>Cada engrane indica un rendimiento o un rozamiento propio.</translation>
    </message>
    <message>
        <source>An efficiency replaces the coefficient of friction that the document states for all meshes.</source>
        <translation>Un rendimiento sustituye al coeficiente de rozamiento que el documento indica para todos los engranes.</translation>
    </message>
    <message>
        <source>Self-locking below η = %1</source>
        <translation>Se autobloquea por debajo de η = %1</translation>
    </message>
    <message>
        <source>Self-locking backward below η = %1</source>
        <translation>Se autobloquea en sentido inverso por debajo de η = %1</translation>
    </message>
    <message>
        <source>Never self-locking, at any efficiency</source>
        <translation>Nunca se autobloquea, con ningún rendimiento</translation>
    </message>
    <message>
        <source>T in joint %1, link %2</source>
        <translation>T en el par %1, eslabón %2</translation>
    </message>
    <message>
        <source>A load: the torque that the joint&apos;s tail exerts on its head, link %1, about the direction of its axis.</source>
        <translation>Una carga: el par que la cola del par cinemático ejerce sobre su cabeza, el eslabón %1, alrededor de la dirección de su eje.</translation>
    </message>
    <message>
        <source>T on link %1</source>
        <translation>T en el eslabón %1</translation>
    </message>
    <message>
        <source>A load: a torque from outside on the link; the ground takes the reaction.</source>
        <translation>Una carga: un par exterior sobre el eslabón; la bancada toma la reacción.</translation>
    </message>
    <message>
        <source>link %1, held by brake %2</source>
        <translation>eslabón %1, retenido por el freno %2</translation>
    </message>
    <message>
        <source>links %1 and %2, joined by clutch %3</source>
        <translation>eslabones %1 y %2, unidos por el embrague %3</translation>
    </message>
    <message>
        <source>carries %1 N m</source>
        <translation>soporta %1 N m</translation>
    </message>
    <message>
        <source>shares its load in unknown parts</source>
        <translation>reparte su carga en partes desconocidas</translation>
    </message>
    <message>
        <source>The torque of the brake on link %1, about its first axis on the way to the ground. At rest it passes no power.</source>
        <translation>El par del freno sobre el eslabón %1, alrededor de su primer eje en el camino a la bancada. En reposo no transmite potencia.</translation>
    </message>
    <message>
        <source>The torque of the clutch on link %1; the other link has the reaction.</source>
        <translation>El par del embrague sobre el eslabón %1; el otro eslabón tiene la reacción.</translation>
    </message>
    <message>
        <source>%1 N m, found</source>
        <translation>%1 N m, hallado</translation>
    </message>
    <message>
        <source>shared in unknown parts</source>
        <translation>repartido en partes desconocidas</translation>
    </message>
    <message>
        <source>Found: the torque that holds the loads here, of the joint&apos;s tail on its head, link %1, about the direction of its axis.</source>
        <translation>Hallado: el par que aquí sostiene las cargas, de la cola del par cinemático sobre su cabeza, el eslabón %1, alrededor de la dirección de su eje.</translation>
    </message>
    <message>
        <source>Found: the torque from outside on the link that holds the loads.</source>
        <translation>Hallado: el par exterior sobre el eslabón que sostiene las cargas.</translation>
    </message>
    <message>
        <source>%1 of %2 torques are listed; all of them are in Forces</source>
        <translation>Se muestran %1 de %2 pares; todos están en Fuerzas</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>A lo largo de x</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>A lo largo de y</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>A lo largo de z</translation>
    </message>
    <message>
        <source>Square to</source>
        <translation>Perpendicular a</translation>
    </message>
    <message>
        <source>Parallel to</source>
        <translation>Paralelo a</translation>
    </message>
    <message>
        <source>Through the meeting point of</source>
        <translation>Por el punto de intersección de</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Eje %1</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>elegir…</translation>
    </message>
    <message>
        <source>Click to choose the input and the output link of this state</source>
        <translation>Haga clic para elegir el eslabón de entrada y el de salida de este estado</translation>
    </message>
    <message>
        <source>State %1 has no ratio yet: click “choose…” in its row and name its input and output links.</source>
        <translation>El estado %1 todavía no tiene relación: haga clic en «elegir…» en su fila e indique los eslabones de entrada y de salida.</translation>
    </message>
    <message>
        <source>Which link is the input of state %1?</source>
        <translation>¿Qué eslabón es la entrada del estado %1?</translation>
    </message>
    <message>
        <source>Which link is the output of state %1?</source>
        <translation>¿Qué eslabón es la salida del estado %1?</translation>
    </message>
    <message>
        <source>Choose input and output</source>
        <translation>Elegir entrada y salida</translation>
    </message>
    <message>
        <source>Choose input and output…</source>
        <translation>Elegir entrada y salida…</translation>
    </message>
    <message>
        <source>Lay axis</source>
        <translation>Orientar el eje</translation>
    </message>
    <message>
        <source>Lay the axis along x, y or z, or as another axis lies. The kinds of its meshes follow.</source>
        <translation>Orienta el eje según x, y o z, o según otro eje. Los tipos de sus engranes se adaptan.</translation>
    </message>
    <message>
        <source>Slide to change the teeth; Esc puts back</source>
        <translation>Deslice para cambiar los dientes; Esc los devuelve</translation>
    </message>
    <message>
        <source>and</source>
        <translation>y</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>Turning joint %1 closes a loop.</source>
        <translation>El par de revolución %1 cierra un lazo.</translation>
    </message>
    <message>
        <source>Turning joint %1 closes a loop with %2.</source>
        <translation>El par de revolución %1 cierra un lazo con %2.</translation>
    </message>
    <message>
        <source>All of them turn about axis %1, so joint %2 is a redundant bearing: drop it.</source>
        <translation>Todos giran en torno al eje %1, así que el par %2 es un cojinete redundante: elimínelo.</translation>
    </message>
    <message>
        <source>The turning joints have to be a tree: delete one of them, or draw a gear mesh instead.</source>
        <translation>Los pares de revolución deben formar un árbol: elimine uno de ellos o dibuje en su lugar un engrane.</translation>
    </message>
    <message>
        <source>Link %1 is not tied to the ground by turning joints: draw a turning joint to it.</source>
        <translation>El eslabón %1 no está unido al bastidor por pares de revolución: dibuje un par de revolución hasta él.</translation>
    </message>
    <message>
        <source>Links %1 are not tied to the ground by turning joints: draw a turning joint to them.</source>
        <translation>Los eslabones %1 no están unidos al bastidor por pares de revolución: dibuje un par de revolución hasta ellos.</translation>
    </message>
    <message>
        <source>Mesh %1: %2</source>
        <translation>Engrane %1: %2</translation>
    </message>
    <message>
        <source>another tooth count</source>
        <translation>otro número de dientes</translation>
    </message>
    <message>
        <source>the pitch point %1</source>
        <translation>el punto primitivo %1</translation>
    </message>
    <message>
        <source>the pitch point %1 lies on the axis of the tail gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.</source>
        <translation>el punto primitivo %1 está en el eje de la rueda de cola, así que su radio primitivo es 0. Lo que encaja: un punto fuera de ambos ejes, en su plano.</translation>
    </message>
    <message>
        <source>the pitch point %1 lies on the axis of the head gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.</source>
        <translation>el punto primitivo %1 está en el eje de la rueda de cabeza, así que su radio primitivo es 0. Lo que encaja: un punto fuera de ambos ejes, en su plano.</translation>
    </message>
    <message>
        <source>its two axes are the same line in the reference pose.</source>
        <translation>sus dos ejes son la misma recta en la posición de referencia.</translation>
    </message>
    <message>
        <source>the pitch point %1 lies %2 off the plane of the two axes, so the teeth would lock. What fits: %3, or none (then it follows from the axes).</source>
        <translation>el punto primitivo %1 está a %2 del plano de los dos ejes, así que los dientes se bloquearían. Lo que encaja: %3, o ninguno (entonces se deduce de los ejes).</translation>
    </message>
    <message>
        <source>it says %1, but its axes are parallel. What fits: external or internal.</source>
        <translation>dice %1, pero sus ejes son paralelos. Lo que encaja: exterior o interior.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet. What fits: bevel.</source>
        <translation>dice %1, pero sus ejes se cortan. Lo que encaja: cónico.</translation>
    </message>
    <message>
        <source>it says internal, but the pitch point %1 lies between the axes, which is an external pair.</source>
        <translation>dice interior, pero el punto primitivo %1 está entre los ejes, lo que es un par exterior.</translation>
    </message>
    <message>
        <source>it says external, but the pitch point %1 lies on one side of both axes, which is an internal pair.</source>
        <translation>dice exterior, pero el punto primitivo %1 está a un lado de ambos ejes, lo que es un par interior.</translation>
    </message>
    <message>
        <source>What fits: %1, or %2.</source>
        <translation>Lo que encaja: %1, o %2.</translation>
    </message>
    <message>
        <source>the pitch radii are %1 and %2 (ratio %3), but the teeth are %4 and %5 (ratio %6). What fits: %7 teeth on the head, or %8.</source>
        <translation>los radios primitivos son %1 y %2 (relación %3), pero los dientes son %4 y %5 (relación %6). Lo que encaja: %7 dientes en la cabeza, o %8.</translation>
    </message>
    <message>
        <source>an internal pair needs different tooth counts, the ring the larger one; both have %1.</source>
        <translation>un par interior necesita números de dientes distintos, la corona el mayor; ambos tienen %1.</translation>
    </message>
    <message>
        <source>some of %1</source>
        <translation>algunos de %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>uno de %1</translation>
    </message>
    <message>
        <source>or</source>
        <translation>o</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>state “%1”</source>
        <translation>estado «%1»</translation>
    </message>
    <message>
        <source>State “%1” engages %2, link $%3$ drives and link $%4$ bears the load</source>
        <translation>El estado «%1» activa %2, el eslabón $%3$ acciona y el eslabón $%4$ soporta la carga</translation>
    </message>
    <message>
        <source>state “%1” engages %2, link $%3$ drives and link $%4$ bears the load</source>
        <translation>el estado «%1» activa %2, el eslabón $%3$ acciona y el eslabón $%4$ soporta la carga</translation>
    </message>
    <message>
        <source>The torque of the drive is $%1$ N m, and no power is lost.</source>
        <translation>El momento de accionamiento es $%1$ N m y no se pierde potencia.</translation>
    </message>
    <message>
        <source>Which of the engaged brakes and clutches carries the largest torque, and how large is it in N m, without a sign? A fraction or a decimal of three digits will do.</source>
        <translation>¿Cuál de los frenos y embragues activados soporta el mayor momento y cuánto vale en N m, sin signo? Basta una fracción o un decimal de tres cifras.</translation>
    </message>
    <message>
        <source>In which state does %1 carry the largest torque, and how large is it in N m, without a sign? A fraction or a decimal of three digits will do.</source>
        <translation>¿En qué estado soporta %1 el mayor momento y cuánto vale en N m, sin signo? Basta una fracción o un decimal de tres cifras.</translation>
    </message>
    <message>
        <source>largest torque in</source>
        <translation>mayor momento en</translation>
    </message>
    <message>
        <source>torque in N m</source>
        <translation>momento en N m</translation>
    </message>
    <message>
        <source>The torques on each link and in each mesh balance: %1.</source>
        <translation>Los momentos en cada eslabón y en cada engrane se equilibran: %1.</translation>
    </message>
    <message>
        <source>You choose the clutch that turns fastest, but the torque does not follow the speed: it carries %1 N m, less than the %2 N m of %3.</source>
        <translation>Elige el embrague que gira más rápido, pero el momento no sigue a la velocidad: soporta %1 N m, menos que los %2 N m de %3.</translation>
    </message>
    <message>
        <source>You choose the state of the largest ratio, but the brake&apos;s torque does not follow the ratio&apos;s size: it carries %1 N m, less than the %2 N m of %3.</source>
        <translation>Elige el estado de mayor relación, pero el momento del freno no sigue al tamaño de la relación: soporta %1 N m, menos que los %2 N m de %3.</translation>
    </message>
    <message>
        <source>The %1 carries %2 N m, less than the %3 N m of %4.</source>
        <translation>El %1 soporta %2 N m, menos que los %3 N m de %4.</translation>
    </message>
    <message>
        <source>In state “%1” it carries %2 N m, less than the %3 N m of %4.</source>
        <translation>En el estado «%1» soporta %2 N m, menos que los %3 N m de %4.</translation>
    </message>
    <message>
        <source>The %1 is released in this state: it carries no torque.</source>
        <translation>El %1 está liberado en este estado: no soporta momento.</translation>
    </message>
    <message>
        <source>State “%1” releases the %2: it carries no torque.</source>
        <translation>El estado «%1» libera el %2: no soporta momento.</translation>
    </message>
    <message>
        <source>The signs of both torques are lost: the brake holds the sum of %1 N m and %2 N m.</source>
        <translation>Se pierden los signos de ambos momentos: el freno soporta la suma de %1 N m y %2 N m.</translation>
    </message>
    <message>
        <source>You use the ratio upside down: with the ratio %1 the torque on the driven link is %2 N m.</source>
        <translation>Usa la relación al revés: con la relación %1 el momento en el eslabón accionado es %2 N m.</translation>
    </message>
    <message>
        <source>This is the torque of %1, which is not the largest.</source>
        <translation>Este es el momento de %1, que no es el mayor.</translation>
    </message>
    <message>
        <source>This is the torque in state “%1”, which is not the largest.</source>
        <translation>Este es el momento en el estado «%1», que no es el mayor.</translation>
    </message>
    <message>
        <source>This is the torque of the load on link %1: %2 has to keep the balance.</source>
        <translation>Este es el momento de la carga en el eslabón %1: %2 debe mantener el equilibrio.</translation>
    </message>
    <message>
        <source>This is the torque of the drive: %1 does not carry it as it is.</source>
        <translation>Este es el momento de accionamiento: %1 no lo soporta tal cual.</translation>
    </message>
    <message>
        <source>Write the row of mesh $%1$ of the coefficient matrix $P$. Mesh $%1$ has $%2$ teeth on link $%3$ and $%4$ on link $%5$. Any multiple of the row is right: radii, numbers of teeth or the ratio $i_{%1}$.</source>
        <translation>Escriba la fila del engrane $%1$ de la matriz de coeficientes $P$. El engrane $%1$ tiene $%2$ dientes en el eslabón $%3$ y $%4$ en el eslabón $%5$. Vale cualquier múltiplo de la fila: radios, números de dientes o la relación $i_{%1}$.</translation>
    </message>
    <message>
        <source>A joint on the axis of a gear counts with this gear&apos;s radius, the sign is that of the cycle, and the joints of both gears have the signs of the mesh.</source>
        <translation>Un par sobre el eje de una rueda cuenta con el radio de esta rueda, el signo es el del ciclo y los pares de ambas ruedas llevan los signos del engrane.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: both gears turn the same way, seen from their carrier.</source>
        <translation>El engrane %1 es interior: vistas desde su portasatélites, ambas ruedas giran en el mismo sentido.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: its gears turn against each other, seen from their carrier.</source>
        <translation>El engrane %1 es exterior: vistas desde su portasatélites, sus ruedas giran en sentidos opuestos.</translation>
    </message>
    <message>
        <source>The sign of bevel mesh %1 follows from where its pitch point is, seen from both axes.</source>
        <translation>El signo del engrane cónico %1 resulta de la posición de su punto primitivo, visto desde ambos ejes.</translation>
    </message>
    <message>
        <source>You exchange the radii of both gears: the joints on an axis count with the radius of the gear on it.</source>
        <translation>Intercambia los radios de ambas ruedas: los pares sobre un eje cuentan con el radio de la rueda que hay en él.</translation>
    </message>
    <message>
        <source>This is the row of the cycle: in P its signs are multiplied by the radii of the gears.</source>
        <translation>Esta es la fila del ciclo: en P sus signos se multiplican por los radios de las ruedas.</translation>
    </message>
    <message>
        <source>You write the radii without the signs of the cycle, which walks against some arrows.</source>
        <translation>Escribe los radios sin los signos del ciclo, que recorre algunas flechas a contrasentido.</translation>
    </message>
    <message>
        <source>This is the row of mesh %1.</source>
        <translation>Esta es la fila del engrane %1.</translation>
    </message>
    <message>
        <source>You exchange the radii of both gears, and the sign of the mesh is wrong, too.</source>
        <translation>Intercambia los radios de ambas ruedas y, además, el signo del engrane es incorrecto.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 does not use %2: 0.</source>
        <translation>El ciclo del engrane %1 no usa %2: 0.</translation>
    </message>
    <message>
        <source>The sign of %1 is the opposite: the walk passes its arrow the other way.</source>
        <translation>El signo de %1 es el opuesto: el camino recorre su flecha en el otro sentido.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 uses %2: its coefficient is not 0.</source>
        <translation>El ciclo del engrane %1 usa %2: su coeficiente no es 0.</translation>
    </message>
    <message>
        <source>Which turning joints lie on the fundamental cycle of mesh $%1$?</source>
        <translation>¿Qué pares de revolución están en el ciclo fundamental del engrane $%1$?</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 consists of the mesh and of the path through the tree from link %2 to link %3.</source>
        <translation>El ciclo del engrane %1 consta del engrane y del camino por el árbol del eslabón %2 al eslabón %3.</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>pares</translation>
    </message>
    <message>
        <source>You follow both paths to the ground: the cycle turns back at the first link that they share.</source>
        <translation>Sigue ambos caminos hasta el bastidor: el ciclo vuelve en el primer eslabón que comparten.</translation>
    </message>
    <message>
        <source>You follow the path of link %1 to the ground: the cycle needs the path between both gears.</source>
        <translation>Sigue el camino del eslabón %1 hasta el bastidor: el ciclo necesita el camino entre ambas ruedas.</translation>
    </message>
    <message>
        <source>These are the joints on the cycle of mesh %1.</source>
        <translation>Estos son los pares del ciclo del engrane %1.</translation>
    </message>
    <message>
        <source>%1 is a mesh: the question asks for the turning joints.</source>
        <translation>%1 es un engrane: se pregunta por los pares de revolución.</translation>
    </message>
    <message>
        <source>The path between links %1 and %2 leads through joint %3.</source>
        <translation>El camino entre los eslabones %1 y %2 pasa por el par %3.</translation>
    </message>
    <message>
        <source>The path between links %1 and %2 does not lead through joint %3.</source>
        <translation>El camino entre los eslabones %1 y %2 no pasa por el par %3.</translation>
    </message>
    <message>
        <source>Walk once round the cycle of mesh $%1$, in either sense: $1$ for each arrow that you follow, $-1$ for each that you walk against.</source>
        <translation>Recorra una vez el ciclo del engrane $%1$ en cualquier sentido: $1$ por cada flecha que siga, $-1$ por cada una que recorra a contrasentido.</translation>
    </message>
    <message>
        <source>One walk runs along mesh %1 and back through the tree; the opposite walk has all signs exchanged and is right, too.</source>
        <translation>Un recorrido va por el engrane %1 y vuelve por el árbol; el recorrido opuesto tiene todos los signos cambiados y también es correcto.</translation>
    </message>
    <message>
        <source>You give all edges one sense: some arrows point against every walk round the cycle.</source>
        <translation>Da a todas las aristas el mismo sentido: algunas flechas apuntan en contra de todo recorrido del ciclo.</translation>
    </message>
    <message>
        <source>Your walk passes %1 the other way: with the other senses that you give, its sign is the opposite.</source>
        <translation>Su recorrido pasa por %1 en el otro sentido: con los demás sentidos que da, su signo es el opuesto.</translation>
    </message>
    <message>
        <source>Every walk round the cycle uses %1: 1 or −1, not 0.</source>
        <translation>Todo recorrido del ciclo usa %1: 1 o −1, no 0.</translation>
    </message>
    <message>
        <source>These senses belong to no single walk round the cycle: start at one link and follow the edges one by one.</source>
        <translation>Estos sentidos no corresponden a ningún recorrido único del ciclo: empiece en un eslabón y siga las aristas una a una.</translation>
    </message>
    <message>
        <source>Write down all fundamental cycles, one in each row: in any order, each walked in either sense.</source>
        <translation>Escriba todos los ciclos fundamentales, uno por fila: en cualquier orden, cada uno en cualquier sentido.</translation>
    </message>
    <message>
        <source>There is a cycle for each mesh; its row may be multiplied by −1, and rows may be exchanged.</source>
        <translation>Hay un ciclo por cada engrane; su fila puede multiplicarse por −1 y las filas pueden intercambiarse.</translation>
    </message>
    <message>
        <source>You mark the edges of the cycles without their senses: a walk that runs against an arrow has −1.</source>
        <translation>Marca las aristas de los ciclos sin sus sentidos: un recorrido contra una flecha lleva −1.</translation>
    </message>
    <message>
        <source>You write one cycle twice: each mesh closes a cycle of its own.</source>
        <translation>Escribe un ciclo dos veces: cada engrane cierra un ciclo propio.</translation>
    </message>
    <message>
        <source>You leave out the meshes: each cycle holds the mesh that closes it.</source>
        <translation>Omite los engranes: cada ciclo contiene el engrane que lo cierra.</translation>
    </message>
    <message>
        <source>from link %1 to link %2</source>
        <translation>del eslabón %1 al eslabón %2</translation>
    </message>
    <message>
        <source>You turn the arrow of %1 round: it points %2.</source>
        <translation>Invierte la flecha de %1: apunta %2.</translation>
    </message>
    <message>
        <source>You give link %1 an end of %2, but its arrow points %3: 0.</source>
        <translation>Da al eslabón %1 un extremo de %2, pero su flecha apunta %3: 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 ends at link %2: 1, not 0.</source>
        <translation>La flecha de %1 termina en el eslabón %2: 1, no 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 begins at link %2: −1, not 0.</source>
        <translation>La flecha de %1 empieza en el eslabón %2: −1, no 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 ends at link %2: 1, not −1.</source>
        <translation>La flecha de %1 termina en el eslabón %2: 1, no −1.</translation>
    </message>
    <message>
        <source>The arrow of %1 begins at link %2: −1, not 1.</source>
        <translation>La flecha de %1 empieza en el eslabón %2: −1, no 1.</translation>
    </message>
    <message>
        <source>You exchange + and −: a column holds −1 where the arrow begins and 1 where it ends.</source>
        <translation>Intercambia + y −: una columna contiene −1 donde empieza la flecha y 1 donde termina.</translation>
    </message>
    <message>
        <source>You mark both ends alike: the end where the arrow begins is −1, the one where it ends 1.</source>
        <translation>Marca ambos extremos igual: el extremo donde empieza la flecha es −1 y aquel donde termina, 1.</translation>
    </message>
    <message>
        <source>Fill in these columns of the incidence matrix $\Gamma^0$.</source>
        <translation>Rellene estas columnas de la matriz de incidencia $\Gamma^0$.</translation>
    </message>
    <message>
        <source>A column of Γ⁰ holds −1 in the row of the link where the arrow begins, 1 where it ends, and 0 elsewhere.</source>
        <translation>Una columna de Γ⁰ contiene −1 en la fila del eslabón donde empieza la flecha, 1 donde termina y 0 en las demás.</translation>
    </message>
    <message>
        <source>You leave out the ground: Γ⁰ keeps its row, only Γ has none.</source>
        <translation>Omite el bastidor: Γ⁰ conserva su fila, solo Γ no la tiene.</translation>
    </message>
    <message>
        <source>Fill in these columns of the reduced incidence matrix $\Gamma$. Leave a row that $\Gamma$ does not have empty.</source>
        <translation>Rellene estas columnas de la matriz de incidencia reducida $\Gamma$. Deje vacía una fila que $\Gamma$ no tenga.</translation>
    </message>
    <message>
        <source>Γ is Γ⁰ without the row of the ground, so that its rows are independent; all other entries stay.</source>
        <translation>Γ es Γ⁰ sin la fila del bastidor, de modo que sus filas son independientes; las demás entradas quedan igual.</translation>
    </message>
    <message>
        <source>You leave the row of the ground in: Γ has the rows of the moving links only.</source>
        <translation>Deja la fila del bastidor: Γ solo tiene las filas de los eslabones móviles.</translation>
    </message>
    <message>
        <source>You fill in the row of the ground: Γ has the rows of the moving links only.</source>
        <translation>Rellena la fila del bastidor: Γ solo tiene las filas de los eslabones móviles.</translation>
    </message>
    <message>
        <source>The mechanism is drawn with other arrows: these are columns of its incidence matrix $\Gamma^0$. From which link to which link do they point?</source>
        <translation>El mecanismo está dibujado con otras flechas: estas son columnas de su matriz de incidencia $\Gamma^0$. ¿De qué eslabón a qué eslabón apuntan?</translation>
    </message>
    <message>
        <source>An arrow begins at the link whose entry is −1 and ends at the link whose entry is 1.</source>
        <translation>Una flecha empieza en el eslabón cuya entrada es −1 y termina en el eslabón cuya entrada es 1.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>desde</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>You turn every arrow round: −1 is where an arrow begins, 1 where it ends.</source>
        <translation>Invierte todas las flechas: −1 está donde empieza una flecha y 1 donde termina.</translation>
    </message>
    <message>
        <source>You turn the arrow of %1 round: it begins at link %2, where the entry is −1.</source>
        <translation>Invierte la flecha de %1: empieza en el eslabón %2, donde la entrada es −1.</translation>
    </message>
    <message>
        <source>The link that you name as the beginning of %1 has a 0 in column %2.</source>
        <translation>El eslabón que nombra como principio de %1 tiene un 0 en la columna %2.</translation>
    </message>
    <message>
        <source>The link that you name as the end of %1 has a 0 in column %2.</source>
        <translation>El eslabón que nombra como final de %1 tiene un 0 en la columna %2.</translation>
    </message>
    <message>
        <source>One entry of this matrix $%1$ is wrong. Find it and correct it.</source>
        <translation>Una entrada de esta matriz $%1$ es incorrecta. Encuéntrela y corríjala.</translation>
    </message>
    <message>
        <source>The entry in row %1, column %2 is %3, not %4.</source>
        <translation>La entrada de la fila %1, columna %2 es %3, no %4.</translation>
    </message>
    <message>
        <source>row</source>
        <translation>fila</translation>
    </message>
    <message>
        <source>column</source>
        <translation>columna</translation>
    </message>
    <message>
        <source>right value</source>
        <translation>valor correcto</translation>
    </message>
    <message>
        <source>You find the wrong entry, but its right value is another one.</source>
        <translation>Encuentra la entrada incorrecta, pero su valor correcto es otro.</translation>
    </message>
    <message>
        <source>The wrong entry is in this row, but the entry that you name is right.</source>
        <translation>La entrada incorrecta está en esta fila, pero la que nombra es correcta.</translation>
    </message>
    <message>
        <source>The wrong entry is in this column, but the entry that you name is right.</source>
        <translation>La entrada incorrecta está en esta columna, pero la que nombra es correcta.</translation>
    </message>
    <message>
        <source>The entry that you name is right: follow the arrows of its row and column once more.</source>
        <translation>La entrada que nombra es correcta: siga otra vez las flechas de su fila y su columna.</translation>
    </message>
    <message>
        <source>Take one column at a time. Its arrow touches two links only: the one that it leaves gets −1, the one that it points to gets 1.</source>
        <translation>Tome las columnas de una en una. Su flecha toca solo dos eslabones: aquel del que sale recibe −1 y aquel al que apunta, 1.</translation>
    </message>
    <message>
        <source>Read the matrix, not the drawing, one column at a time: the arrow leaves the link whose entry is −1 and points to the link whose entry is 1.</source>
        <translation>Lea la matriz, no el dibujo, columna por columna: la flecha sale del eslabón cuya entrada es −1 y apunta al eslabón cuya entrada es 1.</translation>
    </message>
    <message>
        <source>All speeds are measured against one link: Γ leaves out its row. The other rows are those of Γ⁰.</source>
        <translation>Todas las velocidades se miden respecto de un eslabón: Γ omite su fila. Las demás filas son las de Γ⁰.</translation>
    </message>
    <message>
        <source>Start at the link of the column and walk to the ground along turning joints only. Then compare the arrow of each joint on the walk with your direction.</source>
        <translation>Empiece en el eslabón de la columna y camine hasta el bastidor solo por pares de revolución. Compare luego la flecha de cada par del camino con su dirección.</translation>
    </message>
    <message>
        <source>Keep the turning joints and only the mesh of the row: together they close one cycle. Begin along the mesh, from tail to head, and compare each arrow on the way back with your direction.</source>
        <translation>Conserve los pares de revolución y solo el engrane de la fila: juntos cierran un ciclo. Empiece por el engrane, de cola a cabeza, y compare cada flecha del camino de vuelta con su dirección.</translation>
    </message>
    <message>
        <source>From both links of the mesh, walk along turning joints toward the ground until the two walks meet. What they share from there on is not part of the cycle.</source>
        <translation>Desde ambos eslabones del engrane, camine por pares de revolución hacia el bastidor hasta que los dos caminos se encuentren. Lo que comparten desde allí no forma parte del ciclo.</translation>
    </message>
    <message>
        <source>Choose a link of the cycle and go once round without turning back. Only the direction of each arrow against your own counts.</source>
        <translation>Elija un eslabón del ciclo y dé una vuelta sin retroceder. Solo cuenta la dirección de cada flecha respecto de la suya.</translation>
    </message>
    <message>
        <source>Begin with the columns of the meshes: a cycle of the basis holds one mesh, its own. Then walk from the head of the mesh back to its tail along turning joints.</source>
        <translation>Empiece por las columnas de los engranes: un ciclo de la base contiene un solo engrane, el suyo. Vuelva luego de la cabeza del engrane a su cola por pares de revolución.</translation>
    </message>
    <message>
        <source>Each mesh closes one cycle with the turning joints. Go round one after the other; within a row all signs belong to the same walk.</source>
        <translation>Cada engrane cierra un ciclo con los pares de revolución. Recórralos uno tras otro; dentro de una fila todos los signos son del mismo recorrido.</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree already. With the mesh they close a loop: which edges of this loop could go?</source>
        <translation>Los pares de revolución ya son un árbol generador. Con el engrane cierran un lazo: ¿qué aristas de este lazo podrían quitarse?</translation>
    </message>
    <message>
        <source>Derive the matrix from the drawing, row by row, and stop at the first entry that differs. Compare signs with the directions of the arrows.</source>
        <translation>Deduzca la matriz del dibujo, fila por fila, y deténgase en la primera entrada distinta. Compare los signos con las direcciones de las flechas.</translation>
    </message>
    <message>
        <source>Start from the cycle of the mesh: only its joints have entries. The size of an entry is the number of teeth of the gear on whose axis the joint turns.</source>
        <translation>Parta del ciclo del engrane: solo sus pares tienen entradas. El tamaño de una entrada es el número de dientes de la rueda en cuyo eje gira el par.</translation>
    </message>
    <message>
        <source>Each mesh gives one equation. Count those that do not follow from the others, and subtract their number from that of the turning joints.</source>
        <translation>Cada engrane da una ecuación. Cuente las que no se deducen de las demás y reste su número del de los pares de revolución.</translation>
    </message>
    <message>
        <source>Look for meshes that tie the same links together in two ways. Leave one out: if the others still force the same speeds, it is redundant.</source>
        <translation>Busque engranes que unan los mismos eslabones de dos maneras. Quite uno: si los demás imponen las mismas velocidades, es redundante.</translation>
    </message>
    <message>
        <source>Take as many joints as there are degrees of freedom. Imagine all of them locked: nothing else may move, and no mesh may tie two of them to each other.</source>
        <translation>Tome tantos pares como grados de libertad haya. Imagínelos todos bloqueados: nada más debe moverse y ningún engrane debe ligar dos de ellos.</translation>
    </message>
    <message>
        <source>Look for a mesh whose equation has one unknown speed only, solve it, and go on to the next. A row of P θ̇ = 0 holds the joints of one cycle.</source>
        <translation>Busque un engrane cuya ecuación tenga una sola velocidad desconocida, resuélvala y pase al siguiente. Una fila de P θ̇ = 0 contiene los pares de un ciclo.</translation>
    </message>
    <message>
        <source>The level of a joint is the letter of its axis. Name the axis of each joint on the walk: where the letter changes is the transfer vertex.</source>
        <translation>El nivel de un par es la letra de su eje. Nombre el eje de cada par del camino: donde cambia la letra está el vértice de transferencia.</translation>
    </message>
    <message>
        <source>The carrier is the link where the level changes on the way between both gears. The gear with fewer teeth turns faster; for the sign, look at each gear along its own axis.</source>
        <translation>El portasatélites es el eslabón donde cambia el nivel en el camino entre ambas ruedas. La rueda con menos dientes gira más rápido; para el signo, mire cada rueda a lo largo de su propio eje.</translation>
    </message>
    <message>
        <source>Walk from the carrier to the gear along turning joints: only these joints count. Compare their arrows with your direction.</source>
        <translation>Camine del portasatélites a la rueda por pares de revolución: solo estos pares cuentan. Compare sus flechas con su dirección.</translation>
    </message>
    <message>
        <source>Without the joint the turning joints fall into two groups of links. Look for edges with one end in each group, and compare their direction with that of the joint.</source>
        <translation>Sin el par, los pares de revolución se separan en dos grupos de eslabones. Busque aristas con un extremo en cada grupo y compare su dirección con la del par.</translation>
    </message>
    <message>
        <source>Write the power of each port, torque times speed. Their sum is zero if no power is lost; then put in the terminal equation.</source>
        <translation>Escriba la potencia de cada puerto, momento por velocidad. Si no se pierde potencia, su suma es cero; introduzca entonces la ecuación terminal.</translation>
    </message>
    <message>
        <source>Reduce the fraction. Then multiply both of its parts by the same whole number until both are within the bounds.</source>
        <translation>Simplifique la fracción. Multiplique luego ambas partes por el mismo entero hasta que las dos estén dentro de los límites.</translation>
    </message>
    <message>
        <source>The centre distance goes with the sum of the teeth where both gears are external, and with their difference where one is a ring.</source>
        <translation>La distancia entre centros va con la suma de los dientes si ambas ruedas son exteriores y con su diferencia si una es una corona.</translation>
    </message>
    <message>
        <source>Each engaged element takes degrees of freedom away until one is left. An engaged brake makes the speed of its link zero: try which set gives the ratio.</source>
        <translation>Cada elemento activado quita grados de libertad hasta que queda uno. Un freno activado anula la velocidad de su eslabón: pruebe qué conjunto da la relación.</translation>
    </message>
    <message>
        <source>The torques of all shafts and brakes of the train add up to zero, and so do their powers. Write both sums for what is engaged, then compare the sizes.</source>
        <translation>Los momentos de todos los ejes y frenos del tren suman cero, y también sus potencias. Escriba ambas sumas para lo que está activado y compare luego los valores.</translation>
    </message>
    <message>
        <source>Let the load drive: behind each mesh less power arrives, by its efficiency. If none would be left at the input, or it would have to be driven, the train locks.</source>
        <translation>Deje que accione la carga: detrás de cada engrane llega menos potencia, según su rendimiento. Si en la entrada no quedara ninguna, o hubiera que accionarla, el tren se bloquea.</translation>
    </message>
    <message>
        <source>The torques of drive, load and brake on the train add up to zero, and a brake passes no power. What acts on a link acts on the other part in the opposite sense.</source>
        <translation>Los pares del accionamiento, de la carga y del freno sobre el tren suman cero, y un freno no transmite potencia. Lo que actúa sobre un eslabón actúa sobre la otra parte en sentido contrario.</translation>
    </message>
    <message>
        <source>no joints</source>
        <translation>sin pares</translation>
    </message>
    <message>
        <source>the turning joints are no spanning tree</source>
        <translation>los pares de revolución no son un árbol generador</translation>
    </message>
    <message>
        <source>no meshes</source>
        <translation>sin engranes</translation>
    </message>
    <message>
        <source>a mesh has no geometry</source>
        <translation>un engrane no tiene geometría</translation>
    </message>
    <message>
        <source>too many cycles</source>
        <translation>demasiados ciclos</translation>
    </message>
    <message>
        <source>too many edges</source>
        <translation>demasiadas aristas</translation>
    </message>
    <message>
        <source>the matrices are too large or too small</source>
        <translation>las matrices son demasiado grandes o pequeñas</translation>
    </message>
    <message>
        <source>no mesh is redundant</source>
        <translation>ningún engrane es redundante</translation>
    </message>
    <message>
        <source>nothing can move</source>
        <translation>nada puede moverse</translation>
    </message>
    <message>
        <source>too many inputs</source>
        <translation>demasiadas entradas</translation>
    </message>
    <message>
        <source>no speed follows from the inputs</source>
        <translation>ninguna velocidad se deduce de las entradas</translation>
    </message>
    <message>
        <source>no planet between a sun and a ring</source>
        <translation>ningún satélite entre un solar y una corona</translation>
    </message>
    <message>
        <source>no brakes or clutches</source>
        <translation>sin frenos ni embragues</translation>
    </message>
    <message>
        <source>no states with a ratio</source>
        <translation>ningún estado con una relación</translation>
    </message>
    <message>
        <source>no two torques of brakes or clutches to compare</source>
        <translation>no hay dos momentos de frenos o embragues que comparar</translation>
    </message>
    <message>
        <source>no brake that carries a torque about the drive&apos;s axis</source>
        <translation>ningún freno que soporte un par alrededor del eje del accionamiento</translation>
    </message>
    <message>
        <source>no drive passes power through 1 to 6 meshes</source>
        <translation>ningún accionamiento pasa potencia por 1 a 6 engranes</translation>
    </message>
    <message>
        <source>Fill in Γ⁰</source>
        <translation>Rellenar Γ⁰</translation>
    </message>
    <message>
        <source>Orient the digraph</source>
        <translation>Orientar el dígrafo</translation>
    </message>
    <message>
        <source>Fill in Γ</source>
        <translation>Rellenar Γ</translation>
    </message>
    <message>
        <source>Fill in Z</source>
        <translation>Rellenar Z</translation>
    </message>
    <message>
        <source>Fill in T</source>
        <translation>Rellenar T</translation>
    </message>
    <message>
        <source>Find the cycle of a mesh</source>
        <translation>Hallar el ciclo de un engrane</translation>
    </message>
    <message>
        <source>Walk a cycle in either sense</source>
        <translation>Recorrer un ciclo en cualquier sentido</translation>
    </message>
    <message>
        <source>Fill in a row of C</source>
        <translation>Rellenar una fila de C</translation>
    </message>
    <message>
        <source>Write all cycles</source>
        <translation>Escribir todos los ciclos</translation>
    </message>
    <message>
        <source>Choose a spanning tree</source>
        <translation>Elegir un árbol generador</translation>
    </message>
    <message>
        <source>Find the wrong entry</source>
        <translation>Hallar la entrada incorrecta</translation>
    </message>
    <message>
        <source>Fill in a row of P</source>
        <translation>Rellenar una fila de P</translation>
    </message>
    <message>
        <source>Rank and DOF</source>
        <translation>Rango y GDL</translation>
    </message>
    <message>
        <source>Redundant mesh</source>
        <translation>Engrane redundante</translation>
    </message>
    <message>
        <source>Valid inputs</source>
        <translation>Entradas válidas</translation>
    </message>
    <message>
        <source>Predict a speed</source>
        <translation>Predecir una velocidad</translation>
    </message>
    <message>
        <source>Levels and transfer vertex</source>
        <translation>Niveles y vértice de transferencia</translation>
    </message>
    <message>
        <source>Terminal equation, sign</source>
        <translation>Ecuación terminal, signo</translation>
    </message>
    <message>
        <source>f-circuit equation</source>
        <translation>Ecuación del f-circuito</translation>
    </message>
    <message>
        <source>Fill in a row of Q</source>
        <translation>Rellenar una fila de Q</translation>
    </message>
    <message>
        <source>Torque of a port, sign</source>
        <translation>Momento de un puerto, signo</translation>
    </message>
    <message>
        <source>Teeth for a ratio</source>
        <translation>Dientes para una relación</translation>
    </message>
    <message>
        <source>Teeth of the ring</source>
        <translation>Dientes de la corona</translation>
    </message>
    <message>
        <source>Brakes for a gear</source>
        <translation>Frenos para una marcha</translation>
    </message>
    <message>
        <source>Largest torque of a brake</source>
        <translation>Mayor momento de un freno</translation>
    </message>
    <message>
        <source>Self-locking</source>
        <translation>Autobloqueo</translation>
    </message>
    <message>
        <source>Reaction of a brake, sense</source>
        <translation>Reacción de un freno, sentido</translation>
    </message>
    <message>
        <source>one cycle</source>
        <translation>un ciclo</translation>
    </message>
    <message>
        <source>%1 cycles</source>
        <translation>%1 ciclos</translation>
    </message>
    <message>
        <source>one input</source>
        <translation>una entrada</translation>
    </message>
    <message>
        <source>%1 inputs</source>
        <translation>%1 entradas</translation>
    </message>
    <message>
        <source>%1 redundant</source>
        <translation>%1 redundantes</translation>
    </message>
    <message>
        <source>%1 states</source>
        <translation>%1 estados</translation>
    </message>
    <message>
        <source>easy: %1</source>
        <translation>fácil: %1</translation>
    </message>
    <message>
        <source>medium: %1</source>
        <translation>medio: %1</translation>
    </message>
    <message>
        <source>hard: %1</source>
        <translation>difícil: %1</translation>
    </message>
    <message>
        <source>What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the mechanism have with every brake and clutch released?</source>
        <translation>¿Cuál es el rango $r$ de la matriz de coeficientes $P$ y cuántos grados de libertad $E$ tiene el mecanismo con todos los frenos y embragues liberados?</translation>
    </message>
    <message>
        <source>What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the mechanism have?</source>
        <translation>¿Cuál es el rango $r$ de la matriz de coeficientes $P$ y cuántos grados de libertad $E$ tiene el mecanismo?</translation>
    </message>
    <message>
        <source>Of the %1 rows of P, %2 are independent: %3</source>
        <translation>De las %1 filas de P, %2 son independientes: %3</translation>
    </message>
    <message>
        <source>All %1 rows of P are independent: %2</source>
        <translation>Las %1 filas de P son independientes: %2</translation>
    </message>
    <message>
        <source>You count every mesh as a constraint: one mesh follows from the others, so that r is %1.</source>
        <translation>Cuenta todos los engranes como restricciones: uno se deduce de los demás, de modo que r es %1.</translation>
    </message>
    <message>
        <source>You count every mesh as a constraint: %1 meshes follow from the others, so that r is %2.</source>
        <translation>Cuenta todos los engranes como restricciones: %1 se deducen de los demás, de modo que r es %2.</translation>
    </message>
    <message>
        <source>The rank is not the number of meshes: one mesh follows from the others.</source>
        <translation>El rango no es el número de engranes: uno se deduce de los demás.</translation>
    </message>
    <message>
        <source>The rank is not the number of meshes: %1 meshes follow from the others.</source>
        <translation>El rango no es el número de engranes: %1 se deducen de los demás.</translation>
    </message>
    <message>
        <source>You exchange both numbers: r counts equations, E = t − r is left.</source>
        <translation>Intercambia ambos números: r cuenta ecuaciones y queda E = t − r.</translation>
    </message>
    <message>
        <source>You count the ground among the moving links: it has no turning joint of its own.</source>
        <translation>Cuenta el bastidor entre los eslabones móviles: no tiene par de revolución propio.</translation>
    </message>
    <message>
        <source>You take two degrees of freedom for each mesh: its gears roll and slide, so that it takes one.</source>
        <translation>Resta dos grados de libertad por engrane: sus ruedas ruedan y deslizan, de modo que quita uno.</translation>
    </message>
    <message>
        <source>You count the freedoms of the turning joints only: each independent mesh takes one of them.</source>
        <translation>Cuenta solo las libertades de los pares de revolución: cada engrane independiente quita una.</translation>
    </message>
    <message>
        <source>The rank is right, but E = t − r = %1 − %2.</source>
        <translation>El rango es correcto, pero E = t − r = %1 − %2.</translation>
    </message>
    <message>
        <source>Choose a valid set of inputs: turning joints whose speeds determine the whole motion.</source>
        <translation>Elija un conjunto válido de entradas: pares de revolución cuyas velocidades determinan todo el movimiento.</translation>
    </message>
    <message>
        <source>A valid set has one joint, whose speed can be chosen freely and determines all others.</source>
        <translation>Un conjunto válido tiene un par cuya velocidad se elige libremente y determina todas las demás.</translation>
    </message>
    <message>
        <source>A valid set has %1 joints whose speeds can be chosen freely and determine all others.</source>
        <translation>Un conjunto válido tiene %1 pares cuyas velocidades se eligen libremente y determinan todas las demás.</translation>
    </message>
    <message>
        <source>Joint %1 can never turn, so that it cannot be driven.</source>
        <translation>El par %1 no puede girar nunca, así que no puede accionarse.</translation>
    </message>
    <message>
        <source>With one degree of freedom the other joints you name follow from one of them.</source>
        <translation>Con un grado de libertad, los demás pares que nombra se deducen de uno de ellos.</translation>
    </message>
    <message>
        <source>With %1 degrees of freedom the other joints you name follow from %1 of them.</source>
        <translation>Con %1 grados de libertad, los demás pares que nombra se deducen de %1 de ellos.</translation>
    </message>
    <message>
        <source>Joint %1 is on no cycle, so that only an input can determine its speed.</source>
        <translation>El par %1 no está en ningún ciclo, así que solo una entrada puede determinar su velocidad.</translation>
    </message>
    <message>
        <source>Joint %1 always turns at %2 times the speed of joint %3: only one of them can be chosen.</source>
        <translation>El par %1 gira siempre a %2 veces la velocidad del par %3: solo puede elegirse uno de ellos.</translation>
    </message>
    <message>
        <source>The speeds of these joints depend on each other, so that some other joint stays free.</source>
        <translation>Las velocidades de estos pares dependen unas de otras, así que algún otro par queda libre.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom: your inputs leave a motion open.</source>
        <translation>El mecanismo tiene %1 grados de libertad: sus entradas dejan un movimiento libre.</translation>
    </message>
    <message>
        <source>How many meshes are redundant, and which mesh could be left out without another motion? Name one of them.</source>
        <translation>¿Cuántos engranes son redundantes y qué engrane podría quitarse sin cambiar el movimiento? Nombre uno.</translation>
    </message>
    <message>
        <source>The rank is %1 with %2 meshes, so that one is redundant; each of %3 follows from others.</source>
        <translation>El rango es %1 con %2 engranes, así que uno es redundante; cada uno de %3 se deduce de otros.</translation>
    </message>
    <message>
        <source>The rank is %1 with %2 meshes, so that %3 are redundant; each of %4 follows from others.</source>
        <translation>El rango es %1 con %2 engranes, así que %3 son redundantes; cada uno de %4 se deduce de otros.</translation>
    </message>
    <message>
        <source>redundant meshes</source>
        <translation>engranes redundantes</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>uno de ellos</translation>
    </message>
    <message>
        <source>The rows of P are not independent: their rank is %1, fewer than %2 meshes.</source>
        <translation>Las filas de P no son independientes: su rango es %1, menos que %2 engranes.</translation>
    </message>
    <message>
        <source>There are as many redundant meshes as rows of P beyond its rank: %1 − %2.</source>
        <translation>Hay tantos engranes redundantes como filas de P exceden su rango: %1 − %2.</translation>
    </message>
    <message>
        <source>Without mesh %1 the mechanism would gain a degree of freedom: it follows from no others.</source>
        <translation>Sin el engrane %1 el mecanismo ganaría un grado de libertad: no se deduce de otros.</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>gira</translation>
    </message>
    <message>
        <source>Of the power that it takes, seen from its carrier, each mesh passes the part $%1$; nothing else loses power. Now %2 drives backwards and %3 takes the power. Does the train turn, or does it lock itself? With which efficiency does it pass the power (0 where it locks itself)? A fraction or a decimal of three digits will do.</source>
        <translation>De la potencia que toma, vista desde su portasatélites, cada engrane transmite la parte $%1$; nada más pierde potencia. Ahora %2 acciona hacia atrás y %3 toma la potencia. ¿Gira el tren o se autobloquea? ¿Con qué rendimiento transmite la potencia (0 si se autobloquea)? Basta una fracción o un decimal de tres cifras.</translation>
    </message>
    <message>
        <source>driven backwards it</source>
        <translation>accionado hacia atrás</translation>
    </message>
    <message>
        <source>efficiency backwards</source>
        <translation>rendimiento hacia atrás</translation>
    </message>
    <message>
        <source>joint $%1$</source>
        <translation>par $%1$</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2.</source>
        <translation>Un motor en %1 acciona una carga en %2.</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2, with joint %3 held.</source>
        <translation>Un motor en %1 acciona una carga en %2, con el par %3 retenido.</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2, with joints %3 held.</source>
        <translation>Un motor en %1 acciona una carga en %2, con los pares %3 retenidos.</translation>
    </message>
    <message>
        <source>link $%1$</source>
        <translation>eslabón $%1$</translation>
    </message>
    <message>
        <source>In state “%1”, with %2 engaged, %3 drives a load on %4.</source>
        <translation>En el estado «%1», con %2 activados, %3 acciona una carga en %4.</translation>
    </message>
    <message>
        <source>the mesh passes %1 W for each watt that is fed, seen from its carrier</source>
        <translation>el engrane transmite %1 W por cada vatio suministrado, visto desde su portasatélites</translation>
    </message>
    <message>
        <source>the meshes pass %1 W for each watt that is fed, seen from their carriers</source>
        <translation>los engranes transmiten %1 W por cada vatio suministrado, vistos desde sus portasatélites</translation>
    </message>
    <message>
        <source>gear %1 drives in mesh %2</source>
        <translation>la rueda %1 acciona en el engrane %2</translation>
    </message>
    <message>
        <source>Driven backwards, %1: of each watt that is fed %2 W arrive, so that the train turns.</source>
        <translation>Accionado hacia atrás, %1: de cada vatio suministrado llegan %2 W, así que el tren gira.</translation>
    </message>
    <message>
        <source>Without losses %1, and each loses %2 of what it takes: with these losses no load, however large, turns the drive: the train locks itself.</source>
        <translation>Sin pérdidas %1, y cada uno pierde %2 de lo que toma: con estas pérdidas ninguna carga, por grande que sea, gira el accionamiento: el tren se autobloquea.</translation>
    </message>
    <message>
        <source>Backwards it passes %1.</source>
        <translation>Hacia atrás transmite %1.</translation>
    </message>
    <message>
        <source>Your efficiency is upside down: it is the power taken over the power fed, less than 1.</source>
        <translation>Su rendimiento está al revés: es la potencia tomada dividida por la suministrada, menor que 1.</translation>
    </message>
    <message>
        <source>It does not lock itself: the losses are less than the power fed, and %1 of the power arrives when it is driven backwards.</source>
        <translation>No se autobloquea: las pérdidas son menores que la potencia suministrada, y al accionarlo hacia atrás llega %1 de la potencia.</translation>
    </message>
    <message>
        <source>Backwards it locks itself.</source>
        <translation>Hacia atrás se autobloquea.</translation>
    </message>
    <message>
        <source>It locks itself: %1, and with these losses no load, however large, turns the drive.</source>
        <translation>Se autobloquea: %1, y con estas pérdidas ninguna carga, por grande que sea, gira el accionamiento.</translation>
    </message>
    <message>
        <source>It locks itself, right; but then no power passes: the efficiency is 0.</source>
        <translation>Se autobloquea, correcto; pero entonces no pasa potencia: el rendimiento es 0.</translation>
    </message>
    <message>
        <source>This is the efficiency with the motor driving: backwards the other gears drive.</source>
        <translation>Este es el rendimiento con el motor accionando: hacia atrás accionan las otras ruedas.</translation>
    </message>
    <message>
        <source>You leave out the losses of the meshes.</source>
        <translation>Omite las pérdidas de los engranes.</translation>
    </message>
    <message>
        <source>You multiply the efficiencies of the meshes as in a train of fixed axes: seen from its carrier a mesh passes another power.</source>
        <translation>Multiplica los rendimientos de los engranes como en un tren de ejes fijos: visto desde su portasatélites, un engrane transmite otra potencia.</translation>
    </message>
    <message>
        <source>The entries of this matrix are −1, 0 and 1 only: they tell senses, not sizes.</source>
        <translation>Las entradas de esta matriz son solo −1, 0 y 1: indican sentidos, no tamaños.</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>engrane %1</translation>
    </message>
    <message>
        <source>as the drive&apos;s torque</source>
        <translation>en el sentido del par de accionamiento</translation>
    </message>
    <message>
        <source>against the drive&apos;s torque</source>
        <translation>contra el par de accionamiento</translation>
    </message>
    <message>
        <source>State “%1” engages %2, link $%3$ drives and link $%4$ bears the load. The torque of the drive is $%5$ N m, and no power is lost. What torque, with its sign, does brake %6 exert on link $%7$? And in which sense does it try to turn the housing? A fraction or a decimal of three digits will do.</source>
        <translation>El estado «%1» acopla %2; el eslabón $%3$ acciona y el eslabón $%4$ soporta la carga. El par de accionamiento es de $%5$ N m y no se pierde potencia. ¿Qué par, con su signo, ejerce el freno %6 sobre el eslabón $%7$? ¿Y en qué sentido intenta girar la carcasa? Basta una fracción o un decimal de tres cifras.</translation>
    </message>
    <message>
        <source>torque on link %1 in N m</source>
        <translation>par sobre el eslabón %1 en N m</translation>
    </message>
    <message>
        <source>turns the housing</source>
        <translation>gira la carcasa</translation>
    </message>
    <message>
        <source>Brake %1 holds link %2 with %3 N m; the housing has the opposite, %4 N m.</source>
        <translation>El freno %1 sujeta el eslabón %2 con %3 N m; la carcasa recibe lo contrario, %4 N m.</translation>
    </message>
    <message>
        <source>This is what the housing feels: on link %1 the brake acts with %2 N m.</source>
        <translation>Esto es lo que siente la carcasa: sobre el eslabón %1 el freno actúa con %2 N m.</translation>
    </message>
    <message>
        <source>A sign is lost: %1 N m of the drive, %2 N m that hold the load and the torque of the brake add up to 0.</source>
        <translation>Se pierde un signo: %1 N m del accionamiento, %2 N m que sostienen la carga y el par del freno suman 0.</translation>
    </message>
    <message>
        <source>You use the ratio upside down: with the ratio %1 the load is held by %2 N m.</source>
        <translation>Usas la relación al revés: con la relación %1 la carga se sostiene con %2 N m.</translation>
    </message>
    <message>
        <source>This is the torque at the load on link %1: the brake has to keep the balance of drive and load.</source>
        <translation>Este es el par de la carga sobre el eslabón %1: el freno tiene que equilibrar accionamiento y carga.</translation>
    </message>
    <message>
        <source>This is the torque of the drive: the brake does not carry it as it is.</source>
        <translation>Este es el par del accionamiento: el freno no lo soporta tal cual.</translation>
    </message>
    <message>
        <source>Link %1 and the housing are turned in opposite senses by the brake: link %1 has %2 N m, the housing %3 N m.</source>
        <translation>El freno gira el eslabón %1 y la carcasa en sentidos contrarios: el eslabón %1 tiene %2 N m, la carcasa %3 N m.</translation>
    </message>
    <message>
        <source>The inputs turn at %1 rad/s. What is $\dot{\theta}_{%2}$ in rad/s? A fraction or a decimal of three digits will do.</source>
        <translation>Las entradas giran a %1 rad/s. ¿Cuánto vale $\dot{\theta}_{%2}$ en rad/s? Basta una fracción o un decimal de tres cifras.</translation>
    </message>
    <message>
        <source>The meshes in the chain give joint %1 the rate %2 rad/s.</source>
        <translation>Los engranes de la cadena dan al par %1 la velocidad %2 rad/s.</translation>
    </message>
    <message>
        <source>speed of joint %1</source>
        <translation>velocidad del par %1</translation>
    </message>
    <message>
        <source>The size is right, but the joint turns the other way.</source>
        <translation>El valor es correcto, pero el par gira en el otro sentido.</translation>
    </message>
    <message>
        <source>You leave out input %1: the contributions of all inputs add up.</source>
        <translation>Omite la entrada %1: las contribuciones de todas las entradas se suman.</translation>
    </message>
    <message>
        <source>You multiply by the whole ratio where you have to divide by it: %1 turns at %2 rad/s.</source>
        <translation>Multiplica por la relación total donde hay que dividir: %1 gira a %2 rad/s.</translation>
    </message>
    <message>
        <source>You use the ratio of mesh %1 upside down.</source>
        <translation>Usa la relación del engrane %1 al revés.</translation>
    </message>
    <message>
        <source>The sign of mesh %1 is the opposite in your chain.</source>
        <translation>El signo del engrane %1 es el opuesto en su cadena.</translation>
    </message>
    <message>
        <source>You use speeds relative to the ground in the meshes: a mesh relates the speeds of its gears in their carrier.</source>
        <translation>Usa velocidades relativas al bastidor en los engranes: un engrane relaciona las velocidades de sus ruedas en su portasatélites.</translation>
    </message>
    <message>
        <source>This is the speed of link %1 relative to the ground: the joint&apos;s rate is relative to the link that carries it.</source>
        <translation>Esta es la velocidad del eslabón %1 respecto del bastidor: la del par es respecto del eslabón que lo lleva.</translation>
    </message>
    <message>
        <source>Which brakes and clutches have to be engaged for state “%1”, in which link $%2$ turns at $%3$ times the speed of link $%4$?</source>
        <translation>¿Qué frenos y embragues deben activarse para el estado «%1», en el que el eslabón $%2$ gira a $%3$ veces la velocidad del eslabón $%4$?</translation>
    </message>
    <message>
        <source>With %1 engaged one degree of freedom is left and the ratio is %2.</source>
        <translation>Con %1 activados queda un grado de libertad y la relación es %2.</translation>
    </message>
    <message>
        <source>engaged</source>
        <translation>activados</translation>
    </message>
    <message>
        <source>These couplings engage state “%1”, not “%2”.</source>
        <translation>Estos acoplamientos activan el estado «%1», no «%2».</translation>
    </message>
    <message>
        <source>More than one degree of freedom is left: another brake or clutch has to be engaged.</source>
        <translation>Queda más de un grado de libertad: hay que activar otro freno o embrague.</translation>
    </message>
    <message>
        <source>These couplings together lock the drive.</source>
        <translation>Estos acoplamientos juntos bloquean el accionamiento.</translation>
    </message>
    <message>
        <source>The drive turns with these couplings, but its ratio is not %1.</source>
        <translation>El accionamiento gira con estos acoplamientos, pero su relación no es %1.</translation>
    </message>
    <message>
        <source>The terminal equation of mesh $%1$ is $\omega_{%2} = %3 \, \omega_{%4}$. No power is lost. Write the torque of the second port in terms of the first one&apos;s: the factor $f$ with its sign.</source>
        <translation>La ecuación terminal del engrane $%1$ es $\omega_{%2} = %3 \, \omega_{%4}$. No se pierde potencia. Escriba el momento del segundo puerto en función del primero: el factor $f$ con su signo.</translation>
    </message>
    <message>
        <source>The powers of both ports add up to 0, so that the torques have the inverse ratio of the speeds with the opposite sign: f = %1.</source>
        <translation>Las potencias de ambos puertos suman 0, así que los momentos tienen la relación inversa de las velocidades con el signo opuesto: f = %1.</translation>
    </message>
    <message>
        <source>The ratio is right, but the sign is not: what one port takes in the other gives off.</source>
        <translation>La relación es correcta, pero el signo no: lo que un puerto toma, el otro lo entrega.</translation>
    </message>
    <message>
        <source>You use the relation of the speeds: torques have the inverse ratio and the opposite sign.</source>
        <translation>Usa la relación de las velocidades: los momentos tienen la relación inversa y el signo opuesto.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: the gear that turns more slowly has the larger torque.</source>
        <translation>Su relación está al revés: la rueda que gira más despacio tiene el mayor momento.</translation>
    </message>
    <message>
        <source>Choose numbers of teeth between $%1$ and $%2$ for mesh $%3$ so that $i_{%3} = \frac{N_{%4}}{N_{%5}} = %6$.</source>
        <translation>Elija números de dientes entre $%1$ y $%2$ para el engrane $%3$ de modo que $i_{%3} = \frac{N_{%4}}{N_{%5}} = %6$.</translation>
    </message>
    <message>
        <source>N%1 : N%2 = %3 : %4, for example %5 and %6 teeth.</source>
        <translation>N%1 : N%2 = %3 : %4, por ejemplo %5 y %6 dientes.</translation>
    </message>
    <message>
        <source>A number of teeth is a whole number between %1 and %2 here.</source>
        <translation>Aquí un número de dientes es un entero entre %1 y %2.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: it is %1, not %2.</source>
        <translation>Su relación está al revés: es %1, no %2.</translation>
    </message>
    <message>
        <source>The quotient of your numbers is not %1.</source>
        <translation>El cociente de sus números no es %1.</translation>
    </message>
    <message>
        <source>Let link $%1$ have $%2$ teeth and the planet $%3$ in mesh $%4$ and $%5$ in mesh $%6$, all of one module and without profile shift.</source>
        <translation>Sean $%2$ los dientes del eslabón $%1$ y los del satélite $%3$ en el engrane $%4$ y $%5$ en el engrane $%6$, todos del mismo módulo y sin desplazamiento de perfil.</translation>
    </message>
    <message>
        <source>Let link $%1$ have $%2$ teeth and the planet $%3$, all of one module and without profile shift.</source>
        <translation>Sean $%2$ los dientes del eslabón $%1$ y $%3$ los del satélite, todos del mismo módulo y sin desplazamiento de perfil.</translation>
    </message>
    <message>
        <source>Planet $%1$ is in external mesh $%2$ with link $%3$ and in internal mesh $%4$ with ring $%5$. %6 How many teeth must the ring have, so that both centre distances are equal?</source>
        <translation>El satélite $%1$ está en el engrane exterior $%2$ con el eslabón $%3$ y en el engrane interior $%4$ con la corona $%5$. %6 ¿Cuántos dientes debe tener la corona para que ambas distancias entre centros sean iguales?</translation>
    </message>
    <message>
        <source>The centre distance is half the sum of an external pair and half the difference of an internal one: %1 + %2 = N − %3, so that N = %4.</source>
        <translation>La distancia entre centros es la semisuma de un par exterior y la semidiferencia de uno interior: %1 + %2 = N − %3, de modo que N = %4.</translation>
    </message>
    <message>
        <source>teeth of the ring</source>
        <translation>dientes de la corona</translation>
    </message>
    <message>
        <source>You add the teeth of the ring: the centre distance of an internal pair is half the difference.</source>
        <translation>Suma los dientes de la corona: la distancia entre centros de un par interior es la semidiferencia.</translation>
    </message>
    <message>
        <source>You count the planet once: it is between the sun and the ring on both sides.</source>
        <translation>Cuenta el satélite una vez: está entre el solar y la corona en ambos lados.</translation>
    </message>
    <message>
        <source>Take meshes and turning joints alike as edges of one graph. Choose a spanning tree of it that contains mesh $%1$.</source>
        <translation>Tome engranes y pares de revolución por igual como aristas de un grafo. Elija un árbol generador suyo que contenga el engrane $%1$.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges and no loop: take the mesh in and a joint of its cycle out.</source>
        <translation>Un árbol generador de %1 eslabones tiene %2 aristas y ningún lazo: incluya el engrane y quite un par de su ciclo.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>aristas</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree, but mesh %1 is not in it.</source>
        <translation>Los pares de revolución son un árbol generador, pero el engrane %1 no está en él.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges: yours leaves links loose.</source>
        <translation>Un árbol generador de %1 eslabones tiene %2 aristas: el suyo deja eslabones sueltos.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges: with more of them some close a loop.</source>
        <translation>Un árbol generador de %1 eslabones tiene %2 aristas: con más, algunas cierran un lazo.</translation>
    </message>
    <message>
        <source>Some of your edges close a loop, so that another link is left loose.</source>
        <translation>Algunas de sus aristas cierran un lazo, así que otro eslabón queda suelto.</translation>
    </message>
    <message>
        <source>Your edges are a spanning tree, but mesh %1 is not among them.</source>
        <translation>Sus aristas son un árbol generador, pero el engrane %1 no está entre ellas.</translation>
    </message>
    <message>
        <source>Link %1 is a gear of mesh %2, not its carrier: the level changes at link %3.</source>
        <translation>El eslabón %1 es una rueda del engrane %2, no su portasatélites: el nivel cambia en el eslabón %3.</translation>
    </message>
    <message>
        <source>You measure from the ground, but the level changes at link %1.</source>
        <translation>Mide desde el bastidor, pero el nivel cambia en el eslabón %1.</translation>
    </message>
    <message>
        <source>Both edges of the path at link %1 are on one level: the level changes at link %2.</source>
        <translation>Ambas aristas del camino en el eslabón %1 están en un nivel: el nivel cambia en el eslabón %2.</translation>
    </message>
    <message>
        <source>Link %1 is not on the path between both gears: the level changes at link %2.</source>
        <translation>El eslabón %1 no está en el camino entre ambas ruedas: el nivel cambia en el eslabón %2.</translation>
    </message>
    <message>
        <source>Walk from link $%1$ through the tree branches to link $%2$, the gears of mesh $%3$. On which levels do both gears turn in their carrier, and which link is the transfer vertex?</source>
        <translation>Camine del eslabón $%1$ por las ramas del árbol al eslabón $%2$, las ruedas del engrane $%3$. ¿En qué niveles giran ambas ruedas en su portasatélites y qué eslabón es el vértice de transferencia?</translation>
    </message>
    <message>
        <source>The walk begins on level %1 and ends on level %2; the link where the level changes, %3, is the transfer vertex: the carrier of the mesh.</source>
        <translation>El camino empieza en el nivel %1 y termina en el nivel %2; el eslabón donde cambia el nivel, %3, es el vértice de transferencia: el portasatélites del engrane.</translation>
    </message>
    <message>
        <source>level of link %1</source>
        <translation>nivel del eslabón %1</translation>
    </message>
    <message>
        <source>transfer vertex</source>
        <translation>vértice de transferencia</translation>
    </message>
    <message>
        <source>You exchange the levels: link %1 turns on level %2, link %3 on level %4.</source>
        <translation>Intercambia los niveles: el eslabón %1 gira en el nivel %2 y el eslabón %3 en el nivel %4.</translation>
    </message>
    <message>
        <source>Level %1 is that of the other gear: this one turns on level %2.</source>
        <translation>El nivel %1 es el de la otra rueda: esta gira en el nivel %2.</translation>
    </message>
    <message>
        <source>The walk between both gears uses the levels %1 and %2 only.</source>
        <translation>El camino entre ambas ruedas usa solo los niveles %1 y %2.</translation>
    </message>
    <message>
        <source>Write the terminal equation of mesh $%1$, with $N_{%2} = %3$ and $N_{%4} = %5$ teeth: the carrier $k$, and the factor $f$ with its sign.</source>
        <translation>Escriba la ecuación terminal del engrane $%1$, con $N_{%2} = %3$ y $N_{%4} = %5$ dientes: el portasatélites $k$ y el factor $f$ con su signo.</translation>
    </message>
    <message>
        <source>Seen from carrier %1, the gears of mesh %2 turn the same way, each along its own axis: f = %3.</source>
        <translation>Vistas desde el portasatélites %1, las ruedas del engrane %2 giran en el mismo sentido, cada una según su propio eje: f = %3.</translation>
    </message>
    <message>
        <source>Seen from carrier %1, the gears of mesh %2 turn against each other, each along its own axis: f = %3.</source>
        <translation>Vistas desde el portasatélites %1, las ruedas del engrane %2 giran en sentidos opuestos, cada una según su propio eje: f = %3.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: seen from the carrier, its gears turn the same way, so that f is %2.</source>
        <translation>El engrane %1 es interior: vistas desde el portasatélites, sus ruedas giran en el mismo sentido, así que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: seen from the carrier, its gears turn against each other, so that f is %2.</source>
        <translation>El engrane %1 es exterior: vistas desde el portasatélites, sus ruedas giran en sentidos opuestos, así que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a bevel mesh: seen from the carrier, its gears turn the same way, so that f is %2.</source>
        <translation>El engrane %1 es cónico: vistas desde el portasatélites, sus ruedas giran en el mismo sentido, así que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a bevel mesh: seen from the carrier, its gears turn against each other, so that f is %2.</source>
        <translation>El engrane %1 es cónico: vistas desde el portasatélites, sus ruedas giran en sentidos opuestos, así que f es %2.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: the gear with more teeth turns more slowly, f = %1.</source>
        <translation>Su relación está al revés: la rueda con más dientes gira más despacio, f = %1.</translation>
    </message>
    <message>
        <source>Your ratio is upside down, and the sign is wrong, too: f = %1.</source>
        <translation>Su relación está al revés y, además, el signo es incorrecto: f = %1.</translation>
    </message>
    <message>
        <source>You take the teeth of another wheel on the same link: mesh %1 has %2 and %3.</source>
        <translation>Toma los dientes de otra rueda del mismo eslabón: el engrane %1 tiene %2 y %3.</translation>
    </message>
    <message>
        <source>Write the f-circuit equation of the chord between gear $%1$ and carrier $%2$: the coefficients of the branches.</source>
        <translation>Escriba la ecuación del f-circuito de la cuerda entre la rueda $%1$ y el portasatélites $%2$: los coeficientes de las ramas.</translation>
    </message>
    <message>
        <source>The speed of gear %1 in carrier %2 is the sum over the branches between them: 1 for a branch that points to the gear, −1 for one that points to the carrier, as their axes do.</source>
        <translation>La velocidad de la rueda %1 en el portasatélites %2 es la suma sobre las ramas entre ambos: 1 para una rama que apunta a la rueda, −1 para una que apunta al portasatélites, como sus ejes.</translation>
    </message>
    <message>
        <source>You write the speed of the carrier relative to the gear: all signs are the opposite.</source>
        <translation>Escribe la velocidad del portasatélites respecto de la rueda: todos los signos son los opuestos.</translation>
    </message>
    <message>
        <source>This is the circuit of the other chord of mesh %1, of gear %2.</source>
        <translation>Este es el circuito de la otra cuerda del engrane %1, la de la rueda %2.</translation>
    </message>
    <message>
        <source>You write the speed relative to the ground: the chord ends at carrier %1.</source>
        <translation>Escribe la velocidad respecto del bastidor: la cuerda termina en el portasatélites %1.</translation>
    </message>
    <message>
        <source>You follow the walk from gear to gear: the chord ends at carrier %1.</source>
        <translation>Sigue el camino de rueda a rueda: la cuerda termina en el portasatélites %1.</translation>
    </message>
    <message>
        <source>You give all branches one sign: one that points from the gear to the carrier counts −1.</source>
        <translation>Da a todas las ramas un mismo signo: una que apunta de la rueda al portasatélites cuenta −1.</translation>
    </message>
    <message>
        <source>The branches between gear %1 and carrier %2 do not include %3: 0.</source>
        <translation>Las ramas entre la rueda %1 y el portasatélites %2 no incluyen %3: 0.</translation>
    </message>
    <message>
        <source>The sign of %1 is the opposite on the way from the carrier to the gear: %2.</source>
        <translation>El signo de %1 es el opuesto en el camino del portasatélites a la rueda: %2.</translation>
    </message>
    <message>
        <source>The circuit closes through %1: %2, not 0.</source>
        <translation>El circuito se cierra por %1: %2, no 0.</translation>
    </message>
    <message>
        <source>%1 does not use %2: 0.</source>
        <translation>%1 no usa %2: 0.</translation>
    </message>
    <message>
        <source>%1 runs along the arrow of %2: 1, not −1.</source>
        <translation>%1 recorre a favor la flecha de %2: 1, no −1.</translation>
    </message>
    <message>
        <source>%1 runs against the arrow of %2: −1, not 1.</source>
        <translation>%1 recorre a contrasentido la flecha de %2: −1, no 1.</translation>
    </message>
    <message>
        <source>%1 uses %2, along its arrow: 1, not 0.</source>
        <translation>%1 usa %2, a favor de su flecha: 1, no 0.</translation>
    </message>
    <message>
        <source>%1 uses %2, against its arrow: −1, not 0.</source>
        <translation>%1 usa %2, a contrasentido de su flecha: −1, no 0.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1</source>
        <translation>El ciclo del engrane %1</translation>
    </message>
    <message>
        <source>You walk the cycle against mesh %1: it runs along the mesh from tail to head and back through the tree.</source>
        <translation>Recorre el ciclo contra el engrane %1: va por el engrane de cola a cabeza y vuelve por el árbol.</translation>
    </message>
    <message>
        <source>You mark the joints of the cycle without their senses: −1 where the walk runs against an arrow.</source>
        <translation>Marca los pares del ciclo sin sus sentidos: −1 donde el camino va contra una flecha.</translation>
    </message>
    <message>
        <source>This is the row of the cycle of mesh %1, not of mesh %2.</source>
        <translation>Esta es la fila del ciclo del engrane %1, no del engrane %2.</translation>
    </message>
    <message>
        <source>%1 begins along the mesh itself: 1.</source>
        <translation>%1 empieza por el propio engrane: 1.</translation>
    </message>
    <message>
        <source>%1 is walked along its mesh, from tail to head: 1, not −1.</source>
        <translation>%1 se recorre a lo largo de su engrane, de cola a cabeza: 1, no −1.</translation>
    </message>
    <message>
        <source>%1 holds one mesh only, not mesh %2: 0.</source>
        <translation>%1 contiene un solo engrane, no el engrane %2: 0.</translation>
    </message>
    <message>
        <source>Fill in these rows and columns of the path matrix $Z$: how the walk from each link to the ground uses the turning joints.</source>
        <translation>Rellene estas filas y columnas de la matriz de caminos $Z$: cómo usa los pares de revolución el camino de cada eslabón al bastidor.</translation>
    </message>
    <message>
        <source>Walk from the link to the ground: 1 where the walk follows a joint&apos;s arrow, −1 where it runs against it, 0 off the walk.</source>
        <translation>Camine del eslabón al bastidor: 1 donde el camino sigue la flecha de un par, −1 donde va en contra, 0 fuera del camino.</translation>
    </message>
    <message>
        <source>You walk from the ground to the links: the walks of Z end at the ground.</source>
        <translation>Camina del bastidor a los eslabones: los caminos de Z terminan en el bastidor.</translation>
    </message>
    <message>
        <source>You mark the joints of the walks without their senses: −1 where a walk runs against an arrow.</source>
        <translation>Marca los pares de los caminos sin sus sentidos: −1 donde un camino va contra una flecha.</translation>
    </message>
    <message>
        <source>You exchange rows and columns: a column of Z belongs to a link and tells its walk.</source>
        <translation>Intercambia filas y columnas: una columna de Z pertenece a un eslabón e indica su camino.</translation>
    </message>
    <message>
        <source>This is the walk of link %1, not of link %2.</source>
        <translation>Este es el camino del eslabón %1, no del eslabón %2.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground</source>
        <translation>El camino del eslabón %1 al bastidor</translation>
    </message>
    <message>
        <source>Fill in this row of the spanning-tree matrix $T$.</source>
        <translation>Rellene esta fila de la matriz del árbol generador $T$.</translation>
    </message>
    <message>
        <source>Fill in these rows of the spanning-tree matrix $T$.</source>
        <translation>Rellene estas filas de la matriz del árbol generador $T$.</translation>
    </message>
    <message>
        <source>Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows a joint&apos;s arrow, −1 where it runs against it.</source>
        <translation>Recorra el ciclo por su engrane de cola a cabeza y de vuelta por el árbol: 1 donde el camino sigue la flecha de un par, −1 donde va en contra.</translation>
    </message>
    <message>
        <source>You walk the cycles against their meshes: they run along the mesh from tail to head and back through the tree.</source>
        <translation>Recorre los ciclos contra sus engranes: van por el engrane de cola a cabeza y vuelven por el árbol.</translation>
    </message>
    <message>
        <source>You mark the joints of the cycles without their senses: −1 where the walk runs against an arrow.</source>
        <translation>Marca los pares de los ciclos sin sus sentidos: −1 donde el camino va contra una flecha.</translation>
    </message>
    <message>
        <source>You exchange the rows of both cycles.</source>
        <translation>Intercambia las filas de ambos ciclos.</translation>
    </message>
    <message>
        <source>Fill in row $C_{%1}$ of the cycle-basis matrix $C = \left[ T \mid U \right]$.</source>
        <translation>Rellene la fila $C_{%1}$ de la matriz de la base de ciclos $C = \left[ T \mid U \right]$.</translation>
    </message>
    <message>
        <source>Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows an arrow, −1 where it runs against one.</source>
        <translation>Recorra el ciclo por su engrane de cola a cabeza y de vuelta por el árbol: 1 donde el camino sigue una flecha, −1 donde va contra ella.</translation>
    </message>
    <message>
        <source>Fill in the row of joint $%1$ of the fundamental cutset matrix $Q = \left[ U \mid -T^T \right]$.</source>
        <translation>Rellene la fila del par $%1$ de la matriz fundamental de cortes $Q = \left[ U \mid -T^T \right]$.</translation>
    </message>
    <message>
        <source>Without the joint the tree falls into two halves: every edge between them counts, 1 where it crosses in the joint&apos;s direction, −1 where it crosses the other way.</source>
        <translation>Sin el par, el árbol se separa en dos mitades: cuenta toda arista entre ellas, 1 donde cruza en la dirección del par, −1 donde cruza en la otra.</translation>
    </message>
    <message>
        <source>You take the signs of the cycles: Q holds −T transposed beside the unit matrix.</source>
        <translation>Toma los signos de los ciclos: Q contiene −T traspuesta junto a la matriz unidad.</translation>
    </message>
    <message>
        <source>You mark the edges of the cutset without their senses: −1 where an edge crosses against the joint.</source>
        <translation>Marca las aristas del conjunto de corte sin sus sentidos: −1 donde una arista cruza contra el par.</translation>
    </message>
    <message>
        <source>This is the cutset of joint %1, not of %2.</source>
        <translation>Este es el conjunto de corte del par %1, no de %2.</translation>
    </message>
    <message>
        <source>The joint crosses its own cut in its own direction: 1, not −1.</source>
        <translation>El par cruza su propio corte en su propia dirección: 1, no −1.</translation>
    </message>
    <message>
        <source>The cutset holds its own joint: 1, not 0.</source>
        <translation>El conjunto de corte contiene su propio par: 1, no 0.</translation>
    </message>
    <message>
        <source>A fundamental cutset holds one turning joint only, not %1: 0.</source>
        <translation>Un conjunto de corte fundamental contiene un solo par de revolución, no %1: 0.</translation>
    </message>
    <message>
        <source>Both gears of %1 are on one side of %2: 0.</source>
        <translation>Ambas ruedas de %1 están en un mismo lado de %2: 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 crosses the cut in the direction of %2: 1, not −1.</source>
        <translation>La flecha de %1 cruza el corte en la dirección de %2: 1, no −1.</translation>
    </message>
    <message>
        <source>The arrow of %1 crosses the cut against %2: −1, not 1.</source>
        <translation>La flecha de %1 cruza el corte contra %2: −1, no 1.</translation>
    </message>
    <message>
        <source>The ends of %1 are on different sides of %2: %3, not 0.</source>
        <translation>Los extremos de %1 están en lados distintos de %2: %3, no 0.</translation>
    </message>
    <message>
        <source>The field %1 is empty.</source>
        <translation>El campo «%1» está vacío.</translation>
    </message>
    <message>
        <source>“%1” can be read as a thousand or as a decimal: write it without the comma, or as a fraction.</source>
        <translation>«%1» puede leerse como millar o como decimal: escríbalo sin coma o como fracción.</translation>
    </message>
    <message>
        <source>“%1” is not a number: write a whole number, a fraction such as −3/4 or a decimal.</source>
        <translation>«%1» no es un número: escriba un entero, una fracción como −3/4 o un decimal.</translation>
    </message>
    <message>
        <source>“%1” is not among what the question offers for %2.</source>
        <translation>«%1» no está entre lo que la pregunta ofrece para «%2».</translation>
    </message>
    <message>
        <source>meshes %1</source>
        <translation>engranes %1</translation>
    </message>
    <message>
        <source>Mesh %1 follows from %2: it constrains nothing more. Harmless for the motion; the load is shared.</source>
        <translation>El engrane %1 se deduce de %2: no restringe nada más. Es inofensivo para el movimiento; la carga se reparte.</translation>
    </message>
    <message>
        <source>Links %1 are equal planets, which share the load: the motion would be the same without %2.</source>
        <translation>Los eslabones %1 son satélites iguales, que se reparten la carga: el movimiento sería el mismo sin %2.</translation>
    </message>
    <message>
        <source>Brake %1 is engaged and holds nothing that could move.</source>
        <translation>El freno %1 está activado y no retiene nada que pudiera moverse.</translation>
    </message>
    <message>
        <source>Brake %1 is engaged and holds nothing that could move: that follows from %2.</source>
        <translation>El freno %1 está activado y no retiene nada que pudiera moverse: ya se deduce de %2.</translation>
    </message>
    <message>
        <source>Clutch %1 is engaged and holds nothing that could move.</source>
        <translation>El embrague %1 está activado y no retiene nada que pudiera moverse.</translation>
    </message>
    <message>
        <source>Clutch %1 is engaged and holds nothing that could move: that follows from %2.</source>
        <translation>El embrague %1 está activado y no retiene nada que pudiera moverse: ya se deduce de %2.</translation>
    </message>
    <message>
        <source>Nothing can move: the loop of %1 locks it. Change a tooth count so that the ratios round the loop agree, or delete a mesh.</source>
        <translation>Nada puede moverse: lo bloquea el lazo de %1. Cambie un número de dientes para que las relaciones del lazo concuerden, o elimine un engrane.</translation>
    </message>
    <message>
        <source>Nothing can move: %1 holds everything. Release a coupling.</source>
        <translation>Nada puede moverse: %1 lo retiene todo. Libere un acoplamiento.</translation>
    </message>
    <message>
        <source>Nothing can move: %1 hold everything. Release a coupling.</source>
        <translation>Nada puede moverse: %1 lo retienen todo. Libere un acoplamiento.</translation>
    </message>
    <message>
        <source>Joint %1 can never turn, locked by %2.</source>
        <translation>El par %1 no puede girar nunca, bloqueado por %2.</translation>
    </message>
    <message>
        <source>Joints %1 can never turn, locked by %2.</source>
        <translation>Los pares %1 no pueden girar nunca, bloqueados por %2.</translation>
    </message>
    <message>
        <source>Links %1 form a rigid block.</source>
        <translation>Los eslabones %1 forman un bloque rígido.</translation>
    </message>
    <message>
        <source>No mesh constrains joint %1: it has to be driven.</source>
        <translation>Ningún engrane restringe el par %1: hay que accionarlo.</translation>
    </message>
    <message>
        <source>No mesh constrains joints %1: they have to be driven.</source>
        <translation>Ningún engrane restringe los pares %1: hay que accionarlos.</translation>
    </message>
    <message>
        <source>The mechanism has 1 degree of freedom, and 1 input is chosen.</source>
        <translation>El mecanismo tiene 1 grado de libertad y hay 1 entrada elegida.</translation>
    </message>
    <message>
        <source>The mechanism has 1 degree of freedom, and %1 inputs are chosen.</source>
        <translation>El mecanismo tiene 1 grado de libertad y hay %1 entradas elegidas.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom, and 1 input is chosen.</source>
        <translation>El mecanismo tiene %1 grados de libertad y hay 1 entrada elegida.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom, and %2 inputs are chosen.</source>
        <translation>El mecanismo tiene %1 grados de libertad y hay %2 entradas elegidas.</translation>
    </message>
    <message>
        <source>Joint %1 is chosen twice.</source>
        <translation>El par %1 está elegido dos veces.</translation>
    </message>
    <message>
        <source>Joint %1 is no free choice: %2.</source>
        <translation>El par %1 no puede elegirse libremente: %2.</translation>
    </message>
    <message>
        <source>Still free: choose %1 too.</source>
        <translation>Aún libre: elija también %1.</translation>
    </message>
    <message>
        <source>The only valid set is the empty one.</source>
        <translation>El único conjunto válido es el vacío.</translation>
    </message>
    <message>
        <source>A valid set is %1.</source>
        <translation>Un conjunto válido es %1.</translation>
    </message>
    <message>
        <source>There are no gear meshes yet: every joint is free.</source>
        <translation>Aún no hay engranes: todos los pares están libres.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: the train holds it with nothing engaged. Change the train, or drive another link.</source>
        <translation>El estado %1 bloquea su accionamiento, el eslabón %2: el tren lo retiene sin nada activado. Cambie el tren o accione otro eslabón.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: more couplings than one hold it. Release two or more, or drive another link.</source>
        <translation>El estado %1 bloquea su accionamiento, el eslabón %2: lo retiene más de un acoplamiento. Libere dos o más, o accione otro eslabón.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: %3 holds it. Release it, or drive another link.</source>
        <translation>El estado %1 bloquea su accionamiento, el eslabón %2: lo retiene %3. Libérelo o accione otro eslabón.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: %3 hold it together. Release one of them, or drive another link.</source>
        <translation>El estado %1 bloquea su accionamiento, el eslabón %2: %3 lo retienen juntos. Libere uno de ellos o accione otro eslabón.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: with the drive, link %3, held, link %4 still turns.</source>
        <translation>El estado %1 deja %2 grados de libertad: con el accionamiento, el eslabón %3, retenido, el eslabón %4 aún gira.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: with the drive, link %3, held, links %4 still turn.</source>
        <translation>El estado %1 deja %2 grados de libertad: con el accionamiento, el eslabón %3, retenido, los eslabones %4 aún giran.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: link %3 still turns.</source>
        <translation>El estado %1 deja %2 grados de libertad: el eslabón %3 aún gira.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: links %3 still turn.</source>
        <translation>El estado %1 deja %2 grados de libertad: los eslabones %3 aún giran.</translation>
    </message>
    <message>
        <source>Engage one more coupling that holds them.</source>
        <translation>Active un acoplamiento más que los retenga.</translation>
    </message>
    <message>
        <source>Engage %1 more couplings that hold them.</source>
        <translation>Active %1 acoplamientos más que los retengan.</translation>
    </message>
    <message>
        <source>State %1: coupling %2 ties link %3 to the ground over axes of four directions or more.</source>
        <translation>Estado %1: el acoplamiento %2 une el eslabón %3 al bastidor a través de ejes de cuatro direcciones o más.</translation>
    </message>
    <message>
        <source>State %1: coupling %2 ties link %3 to link %4 over axes of four directions or more.</source>
        <translation>Estado %1: el acoplamiento %2 une el eslabón %3 al eslabón %4 a través de ejes de cuatro direcciones o más.</translation>
    </message>
    <message>
        <source>Engaged coupling %1 ties link %2 to the ground over axes of four directions or more.</source>
        <translation>El acoplamiento activado %1 une el eslabón %2 al bastidor a través de ejes de cuatro direcciones o más.</translation>
    </message>
    <message>
        <source>Engaged coupling %1 ties link %2 to link %3 over axes of four directions or more.</source>
        <translation>El acoplamiento activado %1 une el eslabón %2 al eslabón %3 a través de ejes de cuatro direcciones o más.</translation>
    </message>
    <message>
        <source>That is a linkage whose speeds depend on the pose: there is no ratio to state. Couple links that lie nearer to each other.</source>
        <translation>Es un mecanismo articulado cuyas velocidades dependen de la posición: no hay relación que indicar. Acople eslabones más próximos entre sí.</translation>
    </message>
    <message>
        <source>Clutch %1 couples links %2 and %3, which do not turn about one axis against each other: their axes are not one line. Couple links on one axis, or a planet and its carrier.</source>
        <translation>El embrague %1 une los eslabones %2 y %3, que no giran uno respecto a otro alrededor de un mismo eje: sus ejes no son una sola recta. Una eslabones de un mismo eje, o un satélite y su portasatélites.</translation>
    </message>
    <message>
        <source>State %1 has a ratio beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, give one that it can.</source>
        <translation>El estado %1 tiene una relación superior al mayor número que admite el análisis, 1.79e308. Números de dientes más próximos entre sí, o menos engranes en serie, dan una admisible.</translation>
    </message>
    <message>
        <source>Mesh %1 holds gears %2 and %3 on one axis (%4). Gears that mesh turn about two axes of one carrier: let one of them turn about another axis.</source>
        <translation>El engrane %1 tiene las ruedas %2 y %3 en un mismo eje (%4). Las ruedas que engranan giran en torno a dos ejes de un portasatélites: haga girar una de ellas en otro eje.</translation>
    </message>
    <message>
        <source>The path between the gears of mesh %1 runs over %2 axes (%3), and no carrier holds both of theirs: attach gear %4 to link %5.</source>
        <translation>El camino entre las ruedas del engrane %1 pasa por %2 ejes (%3) y ningún portasatélites lleva los de ambas: una la rueda %4 al eslabón %5.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ningún</translation>
    </message>
    <message>
        <source>one</source>
        <translation>un</translation>
    </message>
    <message>
        <source>two</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>three</source>
        <translation>tres</translation>
    </message>
    <message>
        <source>four</source>
        <translation>cuatro</translation>
    </message>
    <message>
        <source>five</source>
        <translation>cinco</translation>
    </message>
    <message>
        <source>six</source>
        <translation>seis</translation>
    </message>
    <message>
        <source>seven</source>
        <translation>siete</translation>
    </message>
    <message>
        <source>eight</source>
        <translation>ocho</translation>
    </message>
    <message>
        <source>nine</source>
        <translation>nueve</translation>
    </message>
    <message>
        <source>ten</source>
        <translation>diez</translation>
    </message>
    <message>
        <source>eleven</source>
        <translation>once</translation>
    </message>
    <message>
        <source>twelve</source>
        <translation>doce</translation>
    </message>
    <message>
        <source>Preview: %1. Click to keep it; leave it, or Esc, to go back</source>
        <translation>Vista previa: %1. Un clic lo conserva; salir de la entrada o Esc lo deshace</translation>
    </message>
    <message>
        <source>%1 (nearest axes)</source>
        <translation>%1 (ejes más cercanos)</translation>
    </message>
    <message>
        <source>relative to %1</source>
        <translation>respecto a %1</translation>
    </message>
    <message>
        <source>link %1 (%2)</source>
        <translation>eslabón %1 (%2)</translation>
    </message>
    <message>
        <source>%1 relative to %2</source>
        <translation>%1 respecto a %2</translation>
    </message>
    <message>
        <source>Speed of joint %1: link %2 relative to link %3</source>
        <translation>Velocidad del par %1: eslabón %2 respecto al eslabón %3</translation>
    </message>
    <message>
        <source>Speed of joint %1: how fast %2 turns relative to %3. Positive: about the direction of the axis, by the right-hand rule.</source>
        <translation>Velocidad del par %1: con qué rapidez gira %2 respecto a %3. Positiva: en torno a la dirección del eje, por la regla de la mano derecha.</translation>
    </message>
    <message>
        <source>Speed of joint %1, %2</source>
        <translation>Velocidad del par %1, %2</translation>
    </message>
    <message>
        <source>Speed of the only input over that of an output. Select a joint or a link to see its ratio.</source>
        <translation>Velocidad de la única entrada entre la de una salida. Seleccione un par o un eslabón para ver su relación.</translation>
    </message>
    <message>
        <source>Ratio %1</source>
        <translation>Relación %1</translation>
    </message>
    <message>
        <source>What speeds are relative to: joint by joint, or those of the links seen from one</source>
        <translation>Respecto a qué se dan las velocidades: par por par, o las de los eslabones vistas desde uno</translation>
    </message>
    <message>
        <source>Drive by a link’s joints ▾</source>
        <translation>Mover por los pares de un eslabón ▾</translation>
    </message>
    <message>
        <source>Make the joints that carry a link the inputs: their speeds are set, those of the motors become results</source>
        <translation>Hacer entradas de los pares que llevan un eslabón: sus velocidades se dan, las de los motores son resultados</translation>
    </message>
    <message>
        <source>joint by joint</source>
        <translation>par por par</translation>
    </message>
    <message>
        <source>relative to the ground</source>
        <translation>respecto al bastidor</translation>
    </message>
    <message>
        <source>Joint by joint: each link relative to the one that carries it</source>
        <translation>Par por par: cada eslabón respecto al que lo lleva</translation>
    </message>
    <message>
        <source>Relative to the ground</source>
        <translation>Respecto al bastidor</translation>
    </message>
    <message>
        <source>Relative to %1</source>
        <translation>Respecto a %1</translation>
    </message>
    <message>
        <source>Ratio to joint %1, %2</source>
        <translation>Relación respecto al par %1, %2</translation>
    </message>
    <message>
        <source>Joints of %1: %2</source>
        <translation>Pares de %1: %2</translation>
    </message>
    <message>
        <source>tooth forces (on heads)</source>
        <translation>fuerzas en los dientes (sobre las cabezas)</translation>
    </message>
    <message>
        <source>bearing reactions (on heads)</source>
        <translation>reacciones en cojinetes (sobre las cabezas)</translation>
    </message>
    <message>
        <source>mesh %1: %2</source>
        <translation>engrane %1: %2</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>par %1: %2</translation>
    </message>
    <message>
        <source>%1; X, Y or Z lays its axis along x, y or z</source>
        <translation>%1; X, Y o Z coloca su eje a lo largo de x, y o z</translation>
    </message>
    <message>
        <source>%1; its axis lies along %2</source>
        <translation>%1; su eje queda a lo largo de %2</translation>
    </message>
    <message>
        <source>No forces without loads: add one in Forces.</source>
        <translation>Sin cargas no hay fuerzas: añada una en Fuerzas.</translation>
    </message>
    <message>
        <source>No forces: the loads are not in balance. Forces names what is missing.</source>
        <translation>Sin fuerzas: las cargas no están en equilibrio. Fuerzas dice lo que falta.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: forces at meshes %1. Choose Share by stiffness in Forces to find them.</source>
        <translation>No se dibujan, por repartirse en partes desconocidas: fuerzas en los engranes %1. Elija «Repartir por rigidez» en Fuerzas para hallarlas.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: reactions in joints %1. Choose Share by stiffness in Forces to find them.</source>
        <translation>No se dibujan, por repartirse en partes desconocidas: reacciones en los pares %1. Elija «Repartir por rigidez» en Fuerzas para hallarlas.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: forces at meshes %1, reactions in joints %2. Choose Share by stiffness in Forces to find them.</source>
        <translation>No se dibujan, por repartirse en partes desconocidas: fuerzas en los engranes %1, reacciones en los pares %2. Elija «Repartir por rigidez» en Fuerzas para hallarlas.</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>Release %1; the motion goes on</source>
        <translation>Liberar %1; el movimiento sigue</translation>
    </message>
    <message>
        <source>Find no torque here any more; without any such place the inputs hold the loads</source>
        <translation>Ya no buscar aquí un momento; si no queda ningún lugar así, las entradas sostienen las cargas</translation>
    </message>
    <message>
        <source>Remove balance</source>
        <translation>Quitar el equilibrante</translation>
    </message>
    <message>
        <source>The entry that speeds and torques share</source>
        <translation>La entrada que comparten velocidades y momentos</translation>
    </message>
    <message>
        <source>A row of P holds the speeds of a mesh, a column the torque in a joint: the framed entry is in both. Entries count teeth; μ is the force of a mesh for each tooth, ℓ what loads on links add. Select a joint or a mesh to see its own; click the framed entry to see it in Matrices.</source>
        <translation>Una fila de P contiene las velocidades de un engrane, una columna el momento en un par: la entrada enmarcada está en ambas. Las entradas cuentan dientes; μ es la fuerza de un engrane por diente, ℓ lo que aportan las cargas en eslabones. Seleccione un par o un engrane para ver los suyos; un clic en la entrada enmarcada la muestra en Matrices.</translation>
    </message>
    <message>
        <source>; brake %1 is engaged</source>
        <translation>; el freno %1 está activado</translation>
    </message>
    <message>
        <source>by an engaged brake</source>
        <translation>por un freno activado</translation>
    </message>
    <message>
        <source>cut into the ground</source>
        <translation>tallado en el bastidor</translation>
    </message>
    <message>
        <source>What &quot;held&quot; means: a link of its own with a brake that is engaged, so that you can release it; or no link of its own, its teeth are the ground&apos;s, as in the example &quot;Planetary train, ring held&quot;. The speeds are the same.</source>
        <translation>Qué significa «retenido»: un eslabón propio con un freno activado que se puede soltar; o ningún eslabón propio: sus dientes son del bastidor, como en el ejemplo «Planetary train, ring held». Las velocidades son las mismas.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Retenido</translation>
    </message>
    <message>
        <source>One file is needed.</source>
        <translation>Se necesita un archivo.</translation>
    </message>
    <message>
        <source>Give --symbolic or --no-symbolic.</source>
        <translation>Indique --symbolic o --no-symbolic.</translation>
    </message>
    <message>
        <source>the analysis</source>
        <translation>el análisis</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>No se pudo escribir en la salida estándar.</translation>
    </message>
    <message>
        <source>drive these joints (by label) instead of the document&apos;s</source>
        <translation>accionar estos pares (por etiqueta) en vez de los del documento</translation>
    </message>
    <message>
        <source>the speed of an input in rad/s; may be repeated</source>
        <translation>la velocidad de una entrada en rad/s; se puede repetir</translation>
    </message>
    <message>
        <source>with the solution in gear ratios (the default)</source>
        <translation>con la solución en relaciones de engrane (por omisión)</translation>
    </message>
    <message>
        <source>without it</source>
        <translation>sin ella</translation>
    </message>
    <message>
        <source>as JSON</source>
        <translation>como JSON</translation>
    </message>
    <message>
        <source>with --json: all entries of matrices, also above 250,000 (else triplets)</source>
        <translation>con --json: todas las entradas de las matrices, también por encima de 250.000 (si no, tripletas)</translation>
    </message>
    <message>
        <source>Analyses a mechanism, for people or as JSON.</source>
        <translation>Analiza un mecanismo, para personas o como JSON.</translation>
    </message>
    <message>
        <source>Untitled mechanism</source>
        <translation>Mecanismo sin título</translation>
    </message>
    <message>
        <source>%1 moving link</source>
        <translation>%1 eslabón móvil</translation>
    </message>
    <message>
        <source>%1 moving links</source>
        <translation>%1 eslabones móviles</translation>
    </message>
    <message>
        <source>%1 turning joint</source>
        <translation>%1 par de revolución</translation>
    </message>
    <message>
        <source>%1 gear mesh</source>
        <translation>%1 engrane</translation>
    </message>
    <message>
        <source>teeth %1 : %2</source>
        <translation>dientes %1 : %2</translation>
    </message>
    <message>
        <source>Eq. (%1)</source>
        <translation>Ec. (%1)</translation>
    </message>
    <message>
        <source>%1 row</source>
        <translation>%1 fila</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 filas</translation>
    </message>
    <message>
        <source>%1 column</source>
        <translation>%1 columna</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>%1 columnas</translation>
    </message>
    <message>
        <source>%1: too large to print; see &quot;export --to csv --matrix %2&quot;</source>
        <translation>%1: demasiado grande para imprimirlo; vea «export --to csv --matrix %2»</translation>
    </message>
    <message>
        <source>The option %1 takes no value.</source>
        <translation>La opción %1 no lleva valor.</translation>
    </message>
    <message>
        <source>The option %1 needs a value: %1 %2.</source>
        <translation>La opción %1 necesita un valor: %1 %2.</translation>
    </message>
    <message>
        <source>The options cannot be read.</source>
        <translation>No se pueden leer las opciones.</translation>
    </message>
    <message>
        <source>There is no option &quot;%1&quot; here.</source>
        <translation>Aquí no hay ninguna opción «%1».</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>fila %1</translation>
    </message>
    <message>
        <source>rows %1</source>
        <translation>filas %1</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>columna %1</translation>
    </message>
    <message>
        <source>columns %1</source>
        <translation>columnas %1</translation>
    </message>
    <message>
        <source>There is no matrix &quot;%1&quot;: %2.</source>
        <translation>No hay ninguna matriz «%1»: %2.</translation>
    </message>
    <message>
        <source>A mechanism and a file with a matrix or equations are needed.</source>
        <translation>Se necesitan un mecanismo y un archivo con una matriz o ecuaciones.</translation>
    </message>
    <message>
        <source>the check</source>
        <translation>la comprobación</translation>
    </message>
    <message>
        <source>Compares a matrix or equations of yours with the derived ones; status 1 where they differ.</source>
        <translation>Compara una matriz o ecuaciones suyas con las deducidas; estado 1 donde difieren.</translation>
    </message>
    <message>
        <source>Usage: geargraph-cli %1 %2</source>
        <translation>Uso: geargraph-cli %1 %2</translation>
    </message>
    <message>
        <source>More: geargraph-cli %1 --help</source>
        <translation>Más: geargraph-cli %1 --help</translation>
    </message>
    <message>
        <source>Not in the table: %1.</source>
        <translation>No está en la tabla: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a table or a graph, not a document. Convert it first: geargraph-cli convert %1 --to geargraph -o %2</source>
        <translation>&quot;%1&quot; es una tabla o un grafo, no un documento. Conviértalo primero: geargraph-cli convert %1 --to geargraph -o %2</translation>
    </message>
    <message>
        <source>Not in the graph: %1.</source>
        <translation>No está en el grafo: %1.</translation>
    </message>
    <message>
        <source>--to is one of csv, geargraph, dot, graphml, node-link.</source>
        <translation>--to es uno de csv, geargraph, dot, graphml, node-link.</translation>
    </message>
    <message>
        <source>--separator is one of comma, semicolon, tab.</source>
        <translation>--separator es uno de comma, semicolon, tab.</translation>
    </message>
    <message>
        <source>%1 has no meaning with %2; it is an option of %3.</source>
        <translation>%1 no tiene significado con %2; es una opción de %3.</translation>
    </message>
    <message>
        <source>the conversion</source>
        <translation>la conversión</translation>
    </message>
    <message>
        <source>csv: a table with a row for each link, axis, turning joint, gear mesh, ...; geargraph: a document; dot, graphml, node-link: the digraph; each is read back, graphs of other programs, too, where edges have kind, axis and tooth counts</source>
        <translation>csv: una tabla con una fila por eslabón, eje, par de revolución, engrane, ...; geargraph: un documento; dot, graphml, node-link: el dígrafo; todo se vuelve a leer, también grafos de otros programas si las aristas tienen tipo, eje y números de dientes</translation>
    </message>
    <message>
        <source>the file (standard output)</source>
        <translation>el archivo (salida estándar)</translation>
    </message>
    <message>
        <source>of a table that is written (comma); reading recognises it</source>
        <translation>de la tabla que se escribe (comma); al leer se reconoce</translation>
    </message>
    <message>
        <source>begin a table with a byte order mark, for spreadsheet programs</source>
        <translation>empezar la tabla con una marca de orden de bytes, para hojas de cálculo</translation>
    </message>
    <message>
        <source>Converts documents to tables (CSV) and graphs, and back; FILE is any of them.</source>
        <translation>Convierte documentos en tablas (CSV) y grafos, y al revés; FILE es cualquiera de ellos.</translation>
    </message>
    <message>
        <source>motion not checked: nothing moves, the mechanism has errors, or it has more than %1 links</source>
        <translation>movimiento no comprobado: nada se mueve, el mecanismo tiene errores, o tiene más de %1 eslabones</translation>
    </message>
    <message>
        <source>motion checked in part only: too many parts come close to each other</source>
        <translation>movimiento comprobado solo en parte: demasiadas piezas se acercan entre sí</translation>
    </message>
    <message>
        <source>motion checked: the distance of no two parts changes, so that nothing can collide</source>
        <translation>movimiento comprobado: la distancia entre dos piezas no cambia en ningún caso, de modo que nada puede chocar</translation>
    </message>
    <message>
        <source>motion checked from %1 to %2; it does not repeat sooner</source>
        <translation>movimiento comprobado de %1 a %2; no se repite antes</translation>
    </message>
    <message>
        <source>motion checked from %1 to %2, between the limits of the joints</source>
        <translation>movimiento comprobado de %1 a %2, entre los límites de los pares</translation>
    </message>
    <message>
        <source>motion checked for %1, until the motion of every two links repeats</source>
        <translation>movimiento comprobado durante %1, hasta que se repite el movimiento de cada dos eslabones</translation>
    </message>
    <message>
        <source>%1 names an input and its number, like %2, not &quot;%3&quot;.</source>
        <translation>%1 nombra una entrada y su número, como %2, no «%3».</translation>
    </message>
    <message>
        <source>Joint %1 is not an input; see --inputs.</source>
        <translation>El par %1 no es una entrada; vea --inputs.</translation>
    </message>
    <message>
        <source>--damping is at least 0, in N m s.</source>
        <translation>--damping es como mínimo 0, en N m s.</translation>
    </message>
    <message>
        <source>--seconds over --interval are at most a million samples.</source>
        <translation>--seconds entre --interval son como mucho un millón de muestras.</translation>
    </message>
    <message>
        <source>Dynamics is computed for up to %1 entries of the solution (inputs times other joints).</source>
        <translation>La dinámica se calcula hasta %1 entradas de la solución (entradas por otros pares).</translation>
    </message>
    <message>
        <source>the gear train</source>
        <translation>el tren</translation>
    </message>
    <message>
        <source>the masses</source>
        <translation>las masas</translation>
    </message>
    <message>
        <source>the motion</source>
        <translation>el movimiento</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: there is no motion to write.</source>
        <translation>Un movimiento de las entradas no mueve ninguna masa: no hay movimiento que escribir.</translation>
    </message>
    <message>
        <source>the torque of an input&apos;s motor (without it 0); may be given again</source>
        <translation>el momento del motor de una entrada (si no, 0); se puede repetir</translation>
    </message>
    <message>
        <source>less this for each rad/s, N m s; may be given again</source>
        <translation>menos esto por cada rad/s, N m s; se puede repetir</translation>
    </message>
    <message>
        <source>the angle of an input at the start; may be given again</source>
        <translation>el ángulo de una entrada al comienzo; se puede repetir</translation>
    </message>
    <message>
        <source>its speed at the start, rad/s or with a unit (without it 0); may be given again</source>
        <translation>su velocidad al comienzo, rad/s o con su unidad (si no, 0); se puede repetir</translation>
    </message>
    <message>
        <source>follow the motion for so long</source>
        <translation>seguir el movimiento este tiempo</translation>
    </message>
    <message>
        <source>seconds between samples (without it a hundredth of the motion)</source>
        <translation>segundos entre muestras (si no, un centésimo del movimiento)</translation>
    </message>
    <message>
        <source>write the samples of the motion as CSV</source>
        <translation>escribir las muestras del movimiento como CSV</translation>
    </message>
    <message>
        <source>Masses, the inertia that motors feel, and the motion that torques cause.</source>
        <translation>Masas, la inercia que notan los motores y el movimiento que causan los momentos.</translation>
    </message>
    <message>
        <source>angle, rad</source>
        <translation>ángulo, rad</translation>
    </message>
    <message>
        <source>speed, rad/s</source>
        <translation>velocidad, rad/s</translation>
    </message>
    <message>
        <source>Motion, after %1 s</source>
        <translation>Movimiento, después de %1 s</translation>
    </message>
    <message>
        <source>kinetic energy %1 J, potential %2 J, work of motors and loads %3 J</source>
        <translation>energía cinética %1 J, potencial %2 J, trabajo de motores y cargas %3 J</translation>
    </message>
    <message>
        <source>mass, kg</source>
        <translation>masa, kg</translation>
    </message>
    <message>
        <source>at motor %1, kg m²</source>
        <translation>en el motor %1, kg m²</translation>
    </message>
    <message>
        <source>inertia, kg m²</source>
        <translation>inercia, kg m²</translation>
    </message>
    <message>
        <source>holding torque, N m</source>
        <translation>momento de sostén, N m</translation>
    </message>
    <message>
        <source>acceleration, rad/s²</source>
        <translation>aceleración, rad/s²</translation>
    </message>
    <message>
        <source>Links, and the inertia that each has at the motors</source>
        <translation>Eslabones, y la inercia que cada uno tiene en los motores</translation>
    </message>
    <message>
        <source>Inputs, at the start</source>
        <translation>Entradas, al comienzo</translation>
    </message>
    <message>
        <source>Generalised inertia M, kg m²</source>
        <translation>Inercia generalizada M, kg m²</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;. The document has no states.</source>
        <translation>No hay ningún estado «%1». El documento no tiene estados.</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;. States: %2.</source>
        <translation>No hay ningún estado «%1». Estados: %2.</translation>
    </message>
    <message>
        <source>There is no coupling &quot;%1&quot;. The document has no couplings.</source>
        <translation>No hay ningún acoplamiento «%1». El documento no tiene.</translation>
    </message>
    <message>
        <source>There is no coupling &quot;%1&quot;. Couplings: %2.</source>
        <translation>No hay ningún acoplamiento «%1». Acoplamientos: %2.</translation>
    </message>
    <message>
        <source>Give --state NAME or --engage A,B.</source>
        <translation>Indique --state NAME o --engage A,B.</translation>
    </message>
    <message>
        <source>%1 (state %2)</source>
        <translation>%1 (estado %2)</translation>
    </message>
    <message>
        <source>with the couplings of this state engaged</source>
        <translation>con los acoplamientos de este estado activados</translation>
    </message>
    <message>
        <source>with these couplings engaged, &quot;none&quot; for no coupling, instead of those that the document engages</source>
        <translation>con estos acoplamientos activados, «none» para ninguno, en vez de los que activa el documento</translation>
    </message>
    <message>
        <source>There is no kind of question &quot;%1&quot;; geargraph-cli exercises kinds FILE lists them.</source>
        <translation>No hay ningún tipo de pregunta «%1»; geargraph-cli exercises kinds FILE los enumera.</translation>
    </message>
    <message>
        <source>The mechanism gives no question &quot;%1&quot;: %2.</source>
        <translation>El mecanismo no da ninguna pregunta «%1»: %2.</translation>
    </message>
    <message>
        <source>--kinds names 1 to 100 questions.</source>
        <translation>--kinds nombra de 1 a 100 preguntas.</translation>
    </message>
    <message>
        <source>--seed is a whole number from 0 on.</source>
        <translation>--seed es un número entero desde 0.</translation>
    </message>
    <message>
        <source>--variants is a whole number from 1 to 1000.</source>
        <translation>--variants es un número entero de 1 a 1000.</translation>
    </message>
    <message>
        <source>The first word is kinds, make or grade.</source>
        <translation>La primera palabra es kinds, make o grade.</translation>
    </message>
    <message>
        <source>%1 has no meaning for exercises %2.</source>
        <translation>%1 no tiene significado para exercises %2.</translation>
    </message>
    <message>
        <source>kinds of questions, with commas; a kind may occur again (all)</source>
        <translation>tipos de preguntas, con comas; un tipo puede repetirse (todos)</translation>
    </message>
    <message>
        <source>how many different sheets, at most 1,000 (1)</source>
        <translation>cuántas hojas distintas, como mucho 1.000 (1)</translation>
    </message>
    <message>
        <source>a variant for each line of this text file</source>
        <translation>una variante por cada línea de este archivo de texto</translation>
    </message>
    <message>
        <source>the heading of the sheets (&quot;Exercises&quot;)</source>
        <translation>el encabezado de las hojas («Exercises»)</translation>
    </message>
    <message>
        <source>overwrites files in the folder</source>
        <translation>sobrescribe archivos en la carpeta</translation>
    </message>
    <message>
        <source>make: the folder; grade: the CSV file (standard output)</source>
        <translation>make: la carpeta; grade: el archivo CSV (salida estándar)</translation>
    </message>
    <message>
        <source>Makes exercise sheets from a mechanism and grades the answers.</source>
        <translation>Hace hojas de ejercicios a partir de un mecanismo y califica las respuestas.</translation>
    </message>
    <message>
        <source>(not offered: %1)</source>
        <translation>(no se ofrece: %1)</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be read: %2.</source>
        <translation>No se pudo leer la carpeta «%1»: %2.</translation>
    </message>
    <message>
        <source>These are answers to another sheet.</source>
        <translation>Son respuestas a otra hoja.</translation>
    </message>
    <message>
        <source>The sheet has no variant %1.</source>
        <translation>La hoja no tiene variante %1.</translation>
    </message>
    <message>
        <source>Question %1 has no such field as some that are answered.</source>
        <translation>La pregunta %1 no tiene algunos de los campos respondidos.</translation>
    </message>
    <message>
        <source>The question is not answered.</source>
        <translation>La pregunta no está respondida.</translation>
    </message>
    <message>
        <source>The sheet has no question %1.</source>
        <translation>La hoja no tiene pregunta %1.</translation>
    </message>
    <message>
        <source>grade needs a sheet and answers.</source>
        <translation>grade necesita una hoja y respuestas.</translation>
    </message>
    <message>
        <source>the grading</source>
        <translation>la calificación</translation>
    </message>
    <message>
        <source>Give --variants or --names: a name is a variant.</source>
        <translation>Indique --variants o --names: un nombre es una variante.</translation>
    </message>
    <message>
        <source>--names is a text file of 1 to 1000 lines.</source>
        <translation>--names es un archivo de texto de 1 a 1000 líneas.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; nothing was written (--force overwrites).</source>
        <translation>«%1» ya existe; no se escribió nada (--force sobrescribe).</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>la variante %1</translation>
    </message>
    <message>
        <source>make needs one file.</source>
        <translation>make necesita un archivo.</translation>
    </message>
    <message>
        <source>make needs a folder: -o FOLDER.</source>
        <translation>make necesita una carpeta: -o FOLDER.</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism; no sheet was written.</source>
        <translation>Sobre este mecanismo no se puede preguntar nada; no se escribió ninguna hoja.</translation>
    </message>
    <message>
        <source>Drawings and 3D pictures (--to svg, pdf or png --view NAME)</source>
        <translation>Dibujos e imágenes 3D (--to svg, pdf o png --view NAME)</translation>
    </message>
    <message>
        <source>3D pictures (--to png --view 3d)</source>
        <translation>Imágenes 3D (--to png --view 3d)</translation>
    </message>
    <message>
        <source>Animations (--to png --view 3d)</source>
        <translation>Animaciones (--to png --view 3d)</translation>
    </message>
    <message>
        <source>the file (&quot;-&quot; is standard output), or with --all the folder</source>
        <translation>el archivo («-» es la salida estándar), o con --all la carpeta</translation>
    </message>
    <message>
        <source>every matrix, or every picture of an animation, into the folder that -o names</source>
        <translation>cada matriz, o cada imagen de una animación, en la carpeta que nombra -o</translation>
    </message>
    <message>
        <source>with a folder: overwrite files that are there</source>
        <translation>con una carpeta: sobrescribir los archivos que haya</translation>
    </message>
    <message>
        <source>incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, tt-circuits, tt-cutsets; of statics: statics, cutset-equations, joint-torques, coupling-torques, mesh-forces, bearings, powers, circulations, and shift-torques of all states</source>
        <translation>incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, tt-circuits, tt-cutsets; de la estática: statics, cutset-equations, joint-torques, coupling-torques, mesh-forces, bearings, powers, circulations, y shift-torques de todos los estados</translation>
    </message>
    <message>
        <source>without the header row and the first column</source>
        <translation>sin la fila de encabezado ni la primera columna</translation>
    </message>
    <message>
        <source>comma (the default), semicolon or tab</source>
        <translation>comma (por omisión), semicolon o tab</translation>
    </message>
    <message>
        <source>point (the default) or comma</source>
        <translation>point (por omisión) o comma</translation>
    </message>
    <message>
        <source>begin with a byte order mark, for spreadsheet programs</source>
        <translation>empezar con una marca de orden de bytes, para hojas de cálculo</translation>
    </message>
    <message>
        <source>with an exercise sheet that tells where an answer is wrong, and why. Saved answers are graded by exercises grade with the sheet.json of exercises make with the same options</source>
        <translation>con una hoja de ejercicios que dice dónde está mal una respuesta, y por qué. Las respuestas guardadas las califica exercises grade con el sheet.json de exercises make con las mismas opciones</translation>
    </message>
    <message>
        <source>kinds of questions, as for exercises make (all)</source>
        <translation>tipos de preguntas, como en exercises make (todos)</translation>
    </message>
    <message>
        <source>the heading of the sheet (&quot;Exercises&quot;)</source>
        <translation>el encabezado de la hoja («Exercises»)</translation>
    </message>
    <message>
        <source>how many different sheets there are (1)</source>
        <translation>cuántas hojas distintas hay (1)</translation>
    </message>
    <message>
        <source>which of them this is (1)</source>
        <translation>cuál de ellas es esta (1)</translation>
    </message>
    <message>
        <source>digraph, ttgraph or schematic; with png and glb also 3d, the train as seen; of graphs digraph or ttgraph</source>
        <translation>digraph, ttgraph o schematic; con png y glb también 3d, el tren como se ve; de los grafos digraph o ttgraph</translation>
    </message>
    <message>
        <source>pixels (as large as the drawing is; 3d: 1600x1000)</source>
        <translation>píxeles (tan grande como el dibujo; 3d: 1600x1000)</translation>
    </message>
    <message>
        <source>on a dark ground</source>
        <translation>sobre fondo oscuro</translation>
    </message>
    <message>
        <source>on no ground</source>
        <translation>sin fondo</translation>
    </message>
    <message>
        <source>under a digraph or schematic: where the power of the loads goes, seen from &quot;ground&quot; or the link with this label</source>
        <translation>bajo un dígrafo o esquema: adónde va la potencia de las cargas, vista desde «ground» o el eslabón con esta etiqueta</translation>
    </message>
    <message>
        <source>front, back, left, right, top, bottom or iso</source>
        <translation>front, back, left, right, top, bottom o iso</translation>
    </message>
    <message>
        <source>from this azimuth and elevation, degrees (-26,20)</source>
        <translation>desde este acimut y elevación, grados (-26,20)</translation>
    </message>
    <message>
        <source>how far the inputs have turned (0); also with glb</source>
        <translation>cuánto han girado las entradas (0); también con glb</translation>
    </message>
    <message>
        <source>section perpendicular to x, y or z at this fraction of the length (y:0.5)</source>
        <translation>sección perpendicular a x, y o z en esta fracción de la longitud (y:0.5)</translation>
    </message>
    <message>
        <source>exploded view along the axes, 0 to 1; also with glb</source>
        <translation>vista explosionada según los ejes, de 0 a 1; también con glb</translation>
    </message>
    <message>
        <source>shaded, lines (hidden ones left out) or edges (all of them)</source>
        <translation>shaded, lines (sin las ocultas) o edges (todas)</translation>
    </message>
    <message>
        <source>links that are left out: 2,5; also with glb</source>
        <translation>eslabones que se omiten: 2,5; también con glb</translation>
    </message>
    <message>
        <source>the link that the reference frame is fixed to; also with glb</source>
        <translation>el eslabón al que está fijo el sistema de referencia; también con glb</translation>
    </message>
    <message>
        <source>once round the train, as an animated PNG (or --all)</source>
        <translation>una vuelta alrededor del tren, como PNG animado (o --all)</translation>
    </message>
    <message>
        <source>one period of the motion (a minute without one)</source>
        <translation>un período del movimiento (un minuto si no lo hay)</translation>
    </message>
    <message>
        <source>pictures a second (24)</source>
        <translation>imágenes por segundo (24)</translation>
    </message>
    <message>
        <source>pictures (72); with assembly: poses of every gear (24)</source>
        <translation>imágenes (72); con assembly: posiciones de cada rueda (24)</translation>
    </message>
    <message>
        <source>one gear in its own frame: 15:tail or 15:head</source>
        <translation>una rueda en su propio sistema: 15:tail o 15:head</translation>
    </message>
    <message>
        <source>the solids of one link</source>
        <translation>los sólidos de un eslabón</translation>
    </message>
    <message>
        <source>with glb: how long one period plays (without: as long as it takes; of a period too long for a file, so many seconds of the motion, 60)</source>
        <translation>con glb: cuánto dura un período (si no: lo que dura; de un período demasiado largo para un archivo, tantos segundos del movimiento, 60)</translation>
    </message>
    <message>
        <source>farthest chord from the exact form (0.002; of large trains as fine as 10 million triangles allow); also with assembly, step (farthest surface of a tooth, 0.001), mjcf and urdf (0.01)</source>
        <translation>mayor desviación de la cuerda respecto a la forma exacta (0.002; en trenes grandes, tan fino como permitan 10 millones de triángulos); también con assembly, step (mayor distancia de las superficies de los dientes, 0.001), mjcf y urdf (0.01)</translation>
    </message>
    <message>
        <source>mjcf: speed (servos with rotors, the default), torque or none</source>
        <translation>mjcf: speed (servos con rotores, por omisión), torque o none</translation>
    </message>
    <message>
        <source>mjcf: inertia of the rotors, kg m² (100 times what the input feels)</source>
        <translation>mjcf: inercia de los rotores, kg m² (100 veces lo que nota la entrada)</translation>
    </message>
    <message>
        <source>mjcf: seconds (0.001)</source>
        <translation>mjcf: segundos (0.001)</translation>
    </message>
    <message>
        <source>SDF is not written: no current Gazebo runs its gear joints. --to urdf is read by Gazebo.</source>
        <translation>SDF no se escribe: ningún Gazebo actual ejecuta sus pares de engranaje. Gazebo lee --to urdf.</translation>
    </message>
    <message>
        <source>-o says where to write.</source>
        <translation>-o dice dónde escribir.</translation>
    </message>
    <message>
        <source>Writes matrices as CSV, the worked derivation, pictures and animations, gears as 3D files, models for simulators, and graphs.</source>
        <translation>Escribe matrices como CSV, la deducción desarrollada, imágenes y animaciones, ruedas como archivos 3D, modelos para simuladores y grafos.</translation>
    </message>
    <message>
        <source>%1 is one of %2.</source>
        <translation>%1 es uno de %2.</translation>
    </message>
    <message>
        <source>There is no matrix &quot;%1&quot;; there are %2.</source>
        <translation>No hay ninguna matriz «%1»; hay %2.</translation>
    </message>
    <message>
        <source>The matrix &quot;%1&quot; needs %2; nothing was written.</source>
        <translation>La matriz «%1» necesita %2; no se escribió nada.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be made.</source>
        <translation>No se pudo crear la carpeta «%1».</translation>
    </message>
    <message>
        <source>Left out: %1, which needs %2.</source>
        <translation>Se omite: %1, que necesita %2.</translation>
    </message>
    <message>
        <source>Give --matrix NAME or --all.</source>
        <translation>Indique --matrix NAME o --all.</translation>
    </message>
    <message>
        <source>the solution</source>
        <translation>la solución</translation>
    </message>
    <message>
        <source>the torques</source>
        <translation>los momentos</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>No se escribió nada.</translation>
    </message>
    <message>
        <source>--power needs a mechanism without errors.</source>
        <translation>--power necesita un mecanismo sin errores.</translation>
    </message>
    <message>
        <source>--power needs loads: this document has none, so that no power flows. Add &quot;loads&quot; to it.</source>
        <translation>--power necesita cargas: este documento no tiene, así que no fluye potencia. Añada «loads».</translation>
    </message>
    <message>
        <source>--power needs balances that hold the loads.</source>
        <translation>--power necesita equilibrantes que sostengan las cargas.</translation>
    </message>
    <message>
        <source>--power needs a motion: the speeds are not determined.</source>
        <translation>--power necesita un movimiento: las velocidades no están determinadas.</translation>
    </message>
    <message>
        <source>No power flows: the loads and what holds them do no work in this motion.</source>
        <translation>No fluye potencia: las cargas y lo que las sostiene no trabajan en este movimiento.</translation>
    </message>
    <message>
        <source>--power is ground or the label of a link, not &quot;%1&quot;.</source>
        <translation>--power es ground o la etiqueta de un eslabón, no «%1».</translation>
    </message>
    <message>
        <source>--view 3d is made of pixels: it needs --to png.</source>
        <translation>--view 3d está hecho de píxeles: necesita --to png.</translation>
    </message>
    <message>
        <source>%1 needs --view: one of %2.</source>
        <translation>%1 necesita --view: uno de %2.</translation>
    </message>
    <message>
        <source>--power is drawn in the digraph and in the schematic.</source>
        <translation>--power se dibuja en el dígrafo y en el esquema.</translation>
    </message>
    <message>
        <source>the drawing</source>
        <translation>el dibujo</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>la imagen</translation>
    </message>
    <message>
        <source>A graph is the digraph or the ttgraph, not &quot;%1&quot;.</source>
        <translation>Un grafo es el digraph o el ttgraph, no «%1».</translation>
    </message>
    <message>
        <source>There is no T-T graph: the turning joints are no spanning tree, or a mesh has no carrier; nothing was written.</source>
        <translation>No hay grafo T-T: los pares de revolución no son un árbol generador, o un engrane no tiene portasatélites; no se escribió nada.</translation>
    </message>
    <message>
        <source>the 3D view</source>
        <translation>la vista 3D</translation>
    </message>
    <message>
        <source>A train of %1 links has no 3D, which is made of up to %2 links.</source>
        <translation>Un tren de %1 eslabones no tiene 3D, que se hace de hasta %2 eslabones.</translation>
    </message>
    <message>
        <source>There is nothing to show: the turning joints are no spanning tree.</source>
        <translation>No hay nada que mostrar: los pares de revolución no son un árbol generador.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>el archivo</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, each from %1 to %2, not &quot;%3&quot;.</source>
        <translation>--size toma ANCHOxALTO, ambos de %1 a %2, no «%3».</translation>
    </message>
    <message>
        <source>--all writes a folder; &quot;-&quot; is none.</source>
        <translation>--all escribe una carpeta; «-» no lo es.</translation>
    </message>
    <message>
        <source>A derivation of more than %1 links is not written: it would be too long to read. The matrices are exported as CSV.</source>
        <translation>No se escribe una deducción de más de %1 eslabones: sería demasiado larga. Las matrices se exportan como CSV.</translation>
    </message>
    <message>
        <source>the derivation</source>
        <translation>la deducción</translation>
    </message>
    <message>
        <source>%1 needs --exercises.</source>
        <translation>%1 necesita --exercises.</translation>
    </message>
    <message>
        <source>%1 has no meaning with --exercises, which ask about the document.</source>
        <translation>%1 no tiene significado con --exercises, que pregunta por el documento.</translation>
    </message>
    <message>
        <source>--exercises needs a file, not standard input.</source>
        <translation>--exercises necesita un archivo, no la entrada estándar.</translation>
    </message>
    <message>
        <source>--variant is a whole number from 1 to that of --variants.</source>
        <translation>--variant es un número entero de 1 al de --variants.</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism.</source>
        <translation>Sobre este mecanismo no se puede preguntar nada.</translation>
    </message>
    <message>
        <source>--motor is one of speed, torque, none.</source>
        <translation>--motor es uno de speed, torque, none.</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>el modelo</translation>
    </message>
    <message>
        <source>Nothing can move; the model holds still.</source>
        <translation>Nada puede moverse; el modelo está quieto.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 freedoms; joints %3 are driven.</source>
        <translation>El estado %1 deja %2 libertades; se accionan los pares %3.</translation>
    </message>
    <message>
        <source>A model for simulators is a folder; &quot;-&quot; is none.</source>
        <translation>Un modelo para simuladores es una carpeta; «-» no lo es.</translation>
    </message>
    <message>
        <source>There is no solution to drive the model by; nothing was written.</source>
        <translation>No hay solución con que accionar el modelo; no se escribió nada.</translation>
    </message>
    <message>
        <source>Models for simulators have at most %1 entries of the solution (inputs times other joints).</source>
        <translation>Los modelos para simuladores tienen como mucho %1 entradas de la solución (entradas por otros pares).</translation>
    </message>
    <message>
        <source>the folder</source>
        <translation>la carpeta</translation>
    </message>
    <message>
        <source>The train is so large that its chords are within %1 modules instead of %2 (--tolerance).</source>
        <translation>El tren es tan grande que sus cuerdas se apartan hasta %1 módulos en vez de %2 (--tolerance).</translation>
    </message>
    <message>
        <source>Left out: %1 of %2 gears, which cannot be made.</source>
        <translation>Se omiten: %1 de %2 ruedas, que no se pueden hacer.</translation>
    </message>
    <message>
        <source>Only --to glb of a train or a link carries an animation.</source>
        <translation>Solo --to glb de un tren o un eslabón lleva una animación.</translation>
    </message>
    <message>
        <source>Give --gear or --link, not both.</source>
        <translation>Indique --gear o --link, no ambos.</translation>
    </message>
    <message>
        <source>--to assembly writes a folder; &quot;-&quot; is none.</source>
        <translation>--to assembly escribe una carpeta; «-» no lo es.</translation>
    </message>
    <message>
        <source>There is no turning joint &quot;%1&quot;.</source>
        <translation>No hay ningún par de revolución «%1».</translation>
    </message>
    <message>
        <source>There is no turning joint &quot;%1&quot;; they are labelled %2 to %3.</source>
        <translation>No hay ningún par de revolución «%1»; sus etiquetas van de %2 a %3.</translation>
    </message>
    <message>
        <source>--inputs names joint %1 twice.</source>
        <translation>--inputs nombra dos veces el par %1.</translation>
    </message>
    <message>
        <source>--speed is like 8=1/2: a joint&apos;s label and rad/s.</source>
        <translation>--speed es como 8=1/2: la etiqueta de un par y rad/s.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no speed; 1/2, 2*3 (rad/s), 1500rpm and 90deg/s are.</source>
        <translation>«%1» no es una velocidad; 1/2, 2*3 (rad/s), 1500rpm y 90deg/s sí.</translation>
    </message>
    <message>
        <source>Too many to count</source>
        <translation>Incontables</translation>
    </message>
    <message>
        <source>%1 valid set of inputs</source>
        <translation>%1 conjunto válido de entradas</translation>
    </message>
    <message>
        <source>%1 valid sets of inputs</source>
        <translation>%1 conjuntos válidos de entradas</translation>
    </message>
    <message>
        <source>; the first %1:</source>
        <translation>; los %1 primeros:</translation>
    </message>
    <message>
        <source>(none: nothing can move)</source>
        <translation>(ninguna: nada puede moverse)</translation>
    </message>
    <message>
        <source>There are over 20 million rates of joints over inputs; no sets are listed.</source>
        <translation>Hay más de 20 millones de velocidades de pares sobre entradas; no se enumeran conjuntos.</translation>
    </message>
    <message>
        <source>--limit is a whole number.</source>
        <translation>--limit es un número entero.</translation>
    </message>
    <message>
        <source>the list of input sets</source>
        <translation>la lista de conjuntos de entradas</translation>
    </message>
    <message>
        <source>how many sets are listed (1,000)</source>
        <translation>cuántos conjuntos se enumeran (1.000)</translation>
    </message>
    <message>
        <source>Counts and lists the valid sets of inputs.</source>
        <translation>Cuenta y enumera los conjuntos válidos de entradas.</translation>
    </message>
    <message>
        <source>1 step, no faults</source>
        <translation>1 paso, sin fallos</translation>
    </message>
    <message>
        <source>%1 steps, no faults</source>
        <translation>%1 pasos, sin fallos</translation>
    </message>
    <message>
        <source>check needs a file.</source>
        <translation>check necesita un archivo.</translation>
    </message>
    <message>
        <source>%1 lessons, %2 min</source>
        <translation>%1 lecciones, %2 min</translation>
    </message>
    <message>
        <source>The first word is check, list or make.</source>
        <translation>La primera palabra es check, list o make.</translation>
    </message>
    <message>
        <source>the findings as JSON</source>
        <translation>los hallazgos como JSON</translation>
    </message>
    <message>
        <source>Checks lessons: their form, answers and reasons; lists those of the program; makes pages of them.</source>
        <translation>Comprueba lecciones: su forma, respuestas y razones; enumera las del programa; hace páginas de ellas.</translation>
    </message>
    <message>
        <source>A train of %1 links has no 3D, which is made of up to %2 links; --gear and --link export a part of it. Nothing was written.</source>
        <translation>Un tren de %1 eslabones no tiene 3D, que se hace de hasta %2 eslabones; --gear y --link exportan una parte. No se escribió nada.</translation>
    </message>
    <message>
        <source>A train of %1 gears (over %2): wheels are plain discs, shafts and arms are straight and pass through other parts.</source>
        <translation>Un tren de %1 ruedas (más de %2): las ruedas son discos lisos, los ejes y brazos son rectos y atraviesan otras piezas.</translation>
    </message>
    <message>
        <source>%1; nothing was written.</source>
        <translation>%1; no se escribió nada.</translation>
    </message>
    <message>
        <source>%1; choose a coarser --tolerance.</source>
        <translation>%1; elija una --tolerance más gruesa.</translation>
    </message>
    <message>
        <source>Exit status: 0 fine (warnings allowed), 1 the mechanism has errors, 2 wrong usage or a file that could not be read or
written, 3 out of a stated resource limit. &quot;-&quot; is standard input or output.</source>
        <translation>Estado de salida: 0 bien (se permiten advertencias), 1 el mecanismo tiene errores, 2 uso incorrecto o un archivo que no se pudo leer o
escribir, 3 se superó un límite indicado. «-» es la entrada o salida estándar.</translation>
    </message>
    <message>
        <source>geargraph-cli: the analysis of geared mechanisms, without a window.</source>
        <translation>geargraph-cli: el análisis de mecanismos con engranajes, sin ventana.</translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation>Comandos:</translation>
    </message>
    <message>
        <source>--help, --version and --language en|de|tr|es (that of the environment) work on every command.</source>
        <translation>--help, --version y --language en|de|tr|es (la del entorno) valen en todos los comandos.</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Opciones</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;.</source>
        <translation>No hay ningún comando «%1».</translation>
    </message>
    <message>
        <source>The memory does not suffice for this mechanism.</source>
        <translation>No hay memoria suficiente para este mecanismo.</translation>
    </message>
    <message>
        <source>It needs -o with a folder.</source>
        <translation>Necesita -o con una carpeta.</translation>
    </message>
    <message>
        <source>It reads no file.</source>
        <translation>No lee ningún archivo.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; --force overwrites it.</source>
        <translation>«%1» ya existe; --force lo sobrescribe.</translation>
    </message>
    <message>
        <source>%1 files in %2</source>
        <translation>%1 archivos en %2</translation>
    </message>
    <message>
        <source>the folder that the pages are written to</source>
        <translation>la carpeta en la que se escriben las páginas</translation>
    </message>
    <message>
        <source>overwrite files that are there</source>
        <translation>sobrescribir los archivos que haya</translation>
    </message>
    <message>
        <source>Writes the manual of the program as web pages, with its pictures.</source>
        <translation>Escribe el manual del programa como páginas web, con sus imágenes.</translation>
    </message>
    <message>
        <source>--density is above 0, in kg/m³, not &quot;%1&quot;.</source>
        <translation>--density es mayor que 0, en kg/m³, no «%1».</translation>
    </message>
    <message>
        <source>--gravity is like 0,0,-9.81, in m/s², not &quot;%1&quot;.</source>
        <translation>--gravity es como 0,0,-9.81, en m/s², no «%1».</translation>
    </message>
    <message>
        <source>acceleration of free fall, m/s², instead of the document&apos;s</source>
        <translation>aceleración de la gravedad, m/s², en vez de la del documento</translation>
    </message>
    <message>
        <source>of all solids, kg/m³, instead of the document&apos;s</source>
        <translation>de todos los sólidos, kg/m³, en vez de la del documento</translation>
    </message>
    <message>
        <source>%1 takes a number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1 toma un número de %2 a %3, no «%4».</translation>
    </message>
    <message>
        <source>%1 is like 8=30deg, 8=1/2rad or 8=2turns: an input&apos;s label and its angle.</source>
        <translation>%1 es como 8=30deg, 8=1/2rad u 8=2turns: la etiqueta de una entrada y su ángulo.</translation>
    </message>
    <message>
        <source>%1 needs the unit of its angle: %2deg or %2rad.</source>
        <translation>%1 necesita la unidad del ángulo: %2deg o %2rad.</translation>
    </message>
    <message>
        <source>The angle %1 is too large: no program could represent it, the largest number is 1.79e308. Leave out whole turns.</source>
        <translation>El ángulo %1 es demasiado grande: ningún programa podría representarlo, el mayor número es 1.79e308. Quite vueltas enteras.</translation>
    </message>
    <message>
        <source>%1 deg</source>
        <translation>%1 grados</translation>
    </message>
    <message>
        <source>joint %1 at %2 is beyond its limits (%3, %4)</source>
        <translation>el par %1 a %2 está más allá de sus límites (%3, %4)</translation>
    </message>
    <message>
        <source>%1 turned by %2 deg</source>
        <translation>%1 girado %2 grados</translation>
    </message>
    <message>
        <source>Links, against the reference pose: turned, and where the point went that was at the origin</source>
        <translation>Eslabones, respecto a la posición de referencia: giro, y adónde fue el punto que estaba en el origen</translation>
    </message>
    <message>
        <source>%1 by %2 deg about %3 to %4</source>
        <translation>%1 en %2 grados en torno a %3 hasta %4</translation>
    </message>
    <message>
        <source>the pose</source>
        <translation>la posición</translation>
    </message>
    <message>
        <source>the angle of an input (deg, rad or turns; without it 0); may be repeated</source>
        <translation>el ángulo de una entrada (deg, rad o turns; si no, 0); se puede repetir</translation>
    </message>
    <message>
        <source>Says where every link is for given angles of the inputs.</source>
        <translation>Dice dónde está cada eslabón para ángulos dados de las entradas.</translation>
    </message>
    <message>
        <source>requests on standard input, answers on standard output</source>
        <translation>peticiones en la entrada estándar, respuestas en la salida estándar</translation>
    </message>
    <message>
        <source>Methods and their params; those in [ ] may be left out:</source>
        <translation>Métodos y sus params; los que están en [ ] pueden faltar:</translation>
    </message>
    <message>
        <source>Edits and their members beside &quot;edit&quot;; null removes what may be left out:</source>
        <translation>Ediciones y sus miembros junto a «edit»; null quita lo que puede faltar:</translation>
    </message>
    <message>
        <source>of address space, for each command</source>
        <translation>de espacio de direcciones, para cada comando</translation>
    </message>
    <message>
        <source>Answers requests, a JSON object a line: open, edit, analyze, export, ...</source>
        <translation>Responde a peticiones, un objeto JSON por línea: open, edit, analyze, export, ...</translation>
    </message>
    <message>
        <source>rank r = %1, degrees of freedom E = t - r = %2</source>
        <translation>rango r = %1, grados de libertad E = t - r = %2</translation>
    </message>
    <message>
        <source>rank r = %1 (%3 of the meshes + %4 of the couplings), degrees of freedom E = t - r = %2</source>
        <translation>rango r = %1 (%3 de los engranes + %4 de los acoplamientos), grados de libertad E = t - r = %2</translation>
    </message>
    <message>
        <source>(Kutzbach counts %1)</source>
        <translation>(Kutzbach cuenta %1)</translation>
    </message>
    <message>
        <source>Carriers of the gear pairs, by their transfer vertices</source>
        <translation>Portasatélites de las parejas de ruedas, por sus vértices de transferencia</translation>
    </message>
    <message>
        <source>axes %1, %2</source>
        <translation>ejes %1, %2</translation>
    </message>
    <message>
        <source>Rates of the outputs over those of the inputs, Eq. (23)</source>
        <translation>Velocidades de las salidas entre las de las entradas, Ec. (23)</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>entradas</translation>
    </message>
    <message>
        <source>inputs, chosen because the file names none:</source>
        <translation>entradas, elegidas porque el archivo no nombra ninguna:</translation>
    </message>
    <message>
        <source>%1 at %2 rad/s</source>
        <translation>%1 a %2 rad/s</translation>
    </message>
    <message>
        <source>not driven, because engaged couplings decide:</source>
        <translation>no accionados, porque deciden los acoplamientos activados:</translation>
    </message>
    <message>
        <source>%1 outputs over %2 inputs: too large to print; see --json</source>
        <translation>%1 salidas entre %2 entradas: demasiado grande para imprimirlo; vea --json</translation>
    </message>
    <message>
        <source>The matroid method and the T-T graph method agree exactly.</source>
        <translation>El método del matroide y el del grafo T-T coinciden exactamente.</translation>
    </message>
    <message>
        <source>The two methods differ by up to %1.</source>
        <translation>Los dos métodos difieren hasta en %1.</translation>
    </message>
    <message>
        <source>in the gear ratios</source>
        <translation>en las relaciones de engrane</translation>
    </message>
    <message>
        <source>State %1: it names no drive and driven link, so it has no ratio.</source>
        <translation>Estado %1: no nombra eslabón motor ni conducido, así que no tiene relación.</translation>
    </message>
    <message>
        <source>State %1: the driven link does not move.</source>
        <translation>Estado %1: el eslabón conducido no se mueve.</translation>
    </message>
    <message>
        <source>State %1: the driven link turns about several directions at once.</source>
        <translation>Estado %1: el eslabón conducido gira en torno a varias direcciones a la vez.</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation>Mecanismo</translation>
    </message>
    <message>
        <source>%1: no states</source>
        <translation>%1: sin estados</translation>
    </message>
    <message>
        <source>%1: 1 state</source>
        <translation>%1: 1 estado</translation>
    </message>
    <message>
        <source>%1: %2 states</source>
        <translation>%1: %2 estados</translation>
    </message>
    <message>
        <source>the shift table</source>
        <translation>la tabla de estados</translation>
    </message>
    <message>
        <source>The shift table: what each state of the brakes and clutches does.</source>
        <translation>La tabla de estados: qué hace cada estado de los frenos y embragues.</translation>
    </message>
    <message>
        <source>Give --state NAME, --all-states or --engage A,B.</source>
        <translation>Indique --state NAME, --all-states o --engage A,B.</translation>
    </message>
    <message>
        <source>of every state</source>
        <translation>de cada estado</translation>
    </message>
    <message>
        <source>joint:14=10Nm, link:3@e=10Nm or link:3=10,-20,-50N@30,-60,130, added</source>
        <translation>joint:14=10Nm, link:3@e=10Nm o link:3=10,-20,-50N@30,-60,130, se añade</translation>
    </message>
    <message>
        <source>without the loads of the document</source>
        <translation>sin las cargas del documento</translation>
    </message>
    <message>
        <source>joint:8 or link:7@a: find the torque there; may be given again</source>
        <translation>joint:8 o link:7@a: hallar el momento allí; se puede repetir</translation>
    </message>
    <message>
        <source>the speed of an input in rad/s; may be given again</source>
        <translation>la velocidad de una entrada en rad/s; se puede repetir</translation>
    </message>
    <message>
        <source>with the losses of the meshes</source>
        <translation>con las pérdidas de los engranes</translation>
    </message>
    <message>
        <source>efficiency of meshes that state none; implies --efficiency</source>
        <translation>rendimiento de los engranes que no lo indican; implica --efficiency</translation>
    </message>
    <message>
        <source>loads that several meshes share: left open, or by equal stiffness</source>
        <translation>cargas que comparten varios engranes: se dejan abiertas, o por igual rigidez</translation>
    </message>
    <message>
        <source>without the solution in gear ratios</source>
        <translation>sin la solución en relaciones de engrane</translation>
    </message>
    <message>
        <source>Torques, tooth forces, bearing reactions and efficiency under loads.</source>
        <translation>Momentos, fuerzas de diente, reacciones de cojinetes y rendimiento bajo cargas.</translation>
    </message>
    <message>
        <source>%1 is on joint:LABEL, link:LABEL or link:LABEL@AXIS, not &quot;%2&quot;.</source>
        <translation>%1 está en joint:LABEL, link:LABEL o link:LABEL@AXIS, no «%2».</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot;.</source>
        <translation>No hay ningún eslabón «%1».</translation>
    </message>
    <message>
        <source>The ground takes any load: name a moving link.</source>
        <translation>El bastidor aguanta cualquier carga: nombre un eslabón móvil.</translation>
    </message>
    <message>
        <source>There is no axis &quot;%1&quot;.</source>
        <translation>No hay ningún eje «%1».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no load: 10Nm, 1/2kNm, 3lbf ft and 2kW@1500rpm are torques, and 10,-20,-50N@30,-60,130 is a force on a link at a point.</source>
        <translation>«%1» no es una carga: 10Nm, 1/2kNm, 3lbf ft y 2kW@1500rpm son momentos, y 10,-20,-50N@30,-60,130 es una fuerza sobre un eslabón en un punto.</translation>
    </message>
    <message>
        <source>--balance names &quot;%1&quot; twice.</source>
        <translation>--balance nombra «%1» dos veces.</translation>
    </message>
    <message>
        <source>--eta is an efficiency, above 0 and at most 1.</source>
        <translation>--eta es un rendimiento, mayor que 0 y como mucho 1.</translation>
    </message>
    <message>
        <source>--share is one of none, stiffness.</source>
        <translation>--share es uno de none, stiffness.</translation>
    </message>
    <message>
        <source>Give --state NAME or --all-states.</source>
        <translation>Indique --state NAME o --all-states.</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;.</source>
        <translation>No hay ningún estado «%1».</translation>
    </message>
    <message>
        <source>power, W</source>
        <translation>potencia, W</translation>
    </message>
    <message>
        <source>shared</source>
        <translation>repartido</translation>
    </message>
    <message>
        <source>Balances and couplings</source>
        <translation>Equilibrantes y acoplamientos</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>engrane</translation>
    </message>
    <message>
        <source>torque on tail, N m</source>
        <translation>momento en la cola, N m</translation>
    </message>
    <message>
        <source>on head, N m</source>
        <translation>en la cabeza, N m</translation>
    </message>
    <message>
        <source>force on head, N</source>
        <translation>fuerza en la cabeza, N</translation>
    </message>
    <message>
        <source>Meshes (torques about the axes from the carrier)</source>
        <translation>Engranes (momentos en torno a los ejes, desde el portasatélites)</translation>
    </message>
    <message>
        <source>force, N</source>
        <translation>fuerza, N</translation>
    </message>
    <message>
        <source>moment, N m</source>
        <translation>momento, N m</translation>
    </message>
    <message>
        <source>at</source>
        <translation>lugar</translation>
    </message>
    <message>
        <source>Bearings (tail on head, base frame)</source>
        <translation>Cojinetes (cola sobre cabeza, sistema base)</translation>
    </message>
    <message>
        <source>Power fed %1 W, taken %2 W, lost %3 W</source>
        <translation>Potencia aportada %1 W, extraída %2 W, perdida %3 W</translation>
    </message>
    <message>
        <source>Passed by the meshes, seen from their carriers, over the power fed: %1</source>
        <translation>Transmitida por los engranes, vista desde sus portasatélites, entre la potencia aportada: %1</translation>
    </message>
    <message>
        <source>Efficiency %1</source>
        <translation>Rendimiento %1</translation>
    </message>
    <message>
        <source>Efficiency backward %1</source>
        <translation>Rendimiento inverso %1</translation>
    </message>
    <message>
        <source>The output cannot drive it back: it locks itself.</source>
        <translation>La salida no puede accionarlo hacia atrás: se autobloquea.</translation>
    </message>
    <message>
        <source>Both methods agree.</source>
        <translation>Ambos métodos coinciden.</translation>
    </message>
    <message>
        <source>The methods do NOT agree.</source>
        <translation>Los métodos NO coinciden.</translation>
    </message>
    <message>
        <source>%1, state %2</source>
        <translation>%1, estado %2</translation>
    </message>
    <message>
        <source>There is no equilibrium.</source>
        <translation>No hay equilibrio.</translation>
    </message>
    <message>
        <source>Files or folders are needed.</source>
        <translation>Se necesitan archivos o carpetas.</translation>
    </message>
    <message>
        <source>--jobs is a whole number from 1 to 256.</source>
        <translation>--jobs es un número entero de 1 a 256.</translation>
    </message>
    <message>
        <source>the summary</source>
        <translation>el resumen</translation>
    </message>
    <message>
        <source>how many files are analysed at once (as many as there are processors)</source>
        <translation>cuántos archivos se analizan a la vez (tantos como procesadores hay)</translation>
    </message>
    <message>
        <source>the file (standard output without it)</source>
        <translation>el archivo (si no, la salida estándar)</translation>
    </message>
    <message>
        <source>A row for each file, or for each document in a folder, as CSV.</source>
        <translation>Una fila por cada archivo, o por cada documento de una carpeta, como CSV.</translation>
    </message>
    <message>
        <source>give up after this time (exit status 3); nothing is written then</source>
        <translation>rendirse tras este tiempo (estado de salida 3); entonces no se escribe nada</translation>
    </message>
    <message>
        <source>--limit-seconds takes a number of seconds above 0, up to 1000000, not &quot;%1&quot;.</source>
        <translation>--limit-seconds toma un número de segundos mayor que 0, hasta 1000000, no «%1».</translation>
    </message>
    <message>
        <source>The limit of %1 s was over before %2 was finished; nothing was written.</source>
        <translation>El límite de %1 s se agotó antes de terminar %2; no se escribió nada.</translation>
    </message>
    <message>
        <source>the validation</source>
        <translation>la validación</translation>
    </message>
    <message>
        <source>%1: no problems</source>
        <translation>%1: sin problemas</translation>
    </message>
    <message>
        <source>also look for links that collide while the inputs run at their speeds</source>
        <translation>buscar también eslabones que chocan mientras las entradas giran a sus velocidades</translation>
    </message>
    <message>
        <source>Says what is wrong with a file.</source>
        <translation>Dice qué está mal en un archivo.</translation>
    </message>
    <message>
        <source>Give --from or --camera, not both.</source>
        <translation>Indique --from o --camera, no ambos.</translation>
    </message>
    <message>
        <source>--from is one of front, back, left, right, top, bottom, iso.</source>
        <translation>--from es uno de front, back, left, right, top, bottom, iso.</translation>
    </message>
    <message>
        <source>--camera takes AZIMUTH,ELEVATION in degrees, up to 360 and 90, not &quot;%1&quot;.</source>
        <translation>--camera toma ACIMUT,ELEVACIÓN en grados, hasta 360 y 90, no «%1».</translation>
    </message>
    <message>
        <source>--time takes seconds, not &quot;%1&quot;.</source>
        <translation>--time toma segundos, no «%1».</translation>
    </message>
    <message>
        <source>--explode takes a part from 0 to 1, not &quot;%1&quot;.</source>
        <translation>--explode toma una parte de 0 a 1, no «%1».</translation>
    </message>
    <message>
        <source>--section takes x, y or z, and how far along from 0 to 1: y:0.5, not &quot;%1&quot;.</source>
        <translation>--section toma x, y o z, y hasta dónde de 0 a 1: y:0.5, no «%1».</translation>
    </message>
    <message>
        <source>--faces is one of shaded, lines, edges.</source>
        <translation>--faces es uno de shaded, lines, edges.</translation>
    </message>
    <message>
        <source>Give --turntable or --motion, not both.</source>
        <translation>Indique --turntable o --motion, no ambos.</translation>
    </message>
    <message>
        <source>--frames takes a whole number from 2 to %1, not &quot;%2&quot;.</source>
        <translation>--frames toma un número entero de 2 a %1, no «%2».</translation>
    </message>
    <message>
        <source>--fps takes pictures a second from 0.1 to 100, not &quot;%1&quot;.</source>
        <translation>--fps toma imágenes por segundo de 0.1 a 100, no «%1».</translation>
    </message>
    <message>
        <source>Links %1 and %2 overlap in the reference pose: give them clearance.</source>
        <translation>Los eslabones %1 y %2 se solapan en la posición de referencia: sepárelos.</translation>
    </message>
    <message>
        <source>Links %1 and %2 collide %3, with %4. Give them clearance, or limit joints.</source>
        <translation>Los eslabones %1 y %2 chocan %3, con %4. Sepárelos o limite pares.</translation>
    </message>
    <message>
        <source>after %1 of the motion backwards</source>
        <translation>tras %1 del movimiento hacia atrás</translation>
    </message>
    <message>
        <source>after %1 of the motion</source>
        <translation>tras %1 del movimiento</translation>
    </message>
    <message>
        <source>%1 at %2 deg</source>
        <translation>%1 a %2 grados</translation>
    </message>
    <message>
        <source>joints %1</source>
        <translation>los pares %1</translation>
    </message>
    <message>
        <source>(Only part of the motion was checked.)</source>
        <translation>(Solo se comprobó parte del movimiento.)</translation>
    </message>
    <message>
        <source>(Checked for the first %1: the motion does not repeat sooner.)</source>
        <translation>(Comprobado durante los primeros %1: el movimiento no se repite antes.)</translation>
    </message>
    <message>
        <source>(Checked until the motion repeats.)</source>
        <translation>(Comprobado hasta que el movimiento se repite.)</translation>
    </message>
    <message>
        <source>(Checked between the limits of the joints, from %1 to %2.)</source>
        <translation>(Comprobado entre los límites de los pares, de %1 a %2.)</translation>
    </message>
    <message>
        <source>(1 more pair of links collides later.)</source>
        <translation>(1 pareja más de eslabones choca después.)</translation>
    </message>
    <message>
        <source>(%1 more pairs of links collide later.)</source>
        <translation>(%1 parejas más de eslabones chocan después.)</translation>
    </message>
    <message>
        <source>The motion of more than %1 links is not checked for collisions.</source>
        <translation>El movimiento de más de %1 eslabones no se comprueba en busca de choques.</translation>
    </message>
    <message>
        <source>Only part of the motion was checked for collisions: too many parts come close to each other.</source>
        <translation>Solo se comprobó parte del movimiento en busca de choques: demasiadas piezas se acercan entre sí.</translation>
    </message>
    <message>
        <source>The motion was checked for collisions for its first %1: it does not repeat sooner.</source>
        <translation>Se comprobaron los choques durante los primeros %1 del movimiento: no se repite antes.</translation>
    </message>
    <message>
        <source>Stop driving %1</source>
        <translation>Dejar de accionar %1</translation>
    </message>
    <message>
        <source>Drive %1 too</source>
        <translation>Accionar también %1</translation>
    </message>
    <message>
        <source>Exchange input %1 for %2</source>
        <translation>Cambiar la entrada %1 por %2</translation>
    </message>
    <message>
        <source>Choose the inputs for me</source>
        <translation>Elegir las entradas por mí</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2</source>
        <translation>Usar %1 dientes en la rueda %2</translation>
    </message>
    <message>
        <source>Make %1 external</source>
        <translation>Hacer exterior: %1</translation>
    </message>
    <message>
        <source>Make %1 internal</source>
        <translation>Hacer interior: %1</translation>
    </message>
    <message>
        <source>Make %1 bevel</source>
        <translation>Hacer cónico: %1</translation>
    </message>
    <message>
        <source>Let the pitch point follow from axes and teeth</source>
        <translation>Dejar que el punto primitivo resulte de ejes y dientes</translation>
    </message>
    <message>
        <source>Let pitch point and kind follow from the axes</source>
        <translation>Dejar que el punto primitivo y el tipo resulten de los ejes</translation>
    </message>
    <message>
        <source>Give each its own axis</source>
        <translation>Dar a cada uno su propio eje</translation>
    </message>
    <message>
        <source>Move %1 along its axis to %2 %3</source>
        <translation>Mover %1 a lo largo de su eje a %2 %3</translation>
    </message>
    <message>
        <source>Use %1 teeth on the ring and %2 on the planets</source>
        <translation>Usar %1 dientes en la corona y %2 en los satélites</translation>
    </message>
    <message>
        <source>Use %1 teeth on the sun and %2 on the planets</source>
        <translation>Usar %1 dientes en el solar y %2 en los satélites</translation>
    </message>
    <message>
        <source>Use twice the teeth everywhere</source>
        <translation>Usar el doble de dientes en todas partes</translation>
    </message>
    <message>
        <source>Use three times the teeth everywhere</source>
        <translation>Usar el triple de dientes en todas partes</translation>
    </message>
    <message>
        <source>Use four times the teeth everywhere</source>
        <translation>Usar el cuádruple de dientes en todas partes</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2 of %3</source>
        <translation>Usar %1 dientes en la rueda %2 de: %3</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2 and %3 on gear %4</source>
        <translation>Usar %1 dientes en la rueda %2 y %3 en la rueda %4</translation>
    </message>
    <message>
        <source>Use %1 equally spaced planets</source>
        <translation>Usar %1 satélites equidistantes</translation>
    </message>
    <message>
        <source>Tie link %1 to the ground</source>
        <translation>Unir el eslabón %1 al bastidor</translation>
    </message>
    <message>
        <source>Tie links %1 to the ground</source>
        <translation>Unir los eslabones %1 al bastidor</translation>
    </message>
    <message>
        <source>Delete the loose links</source>
        <translation>Eliminar los eslabones sueltos</translation>
    </message>
    <message>
        <source>, a second bearing on axis %1</source>
        <translation>, un segundo cojinete en el eje %1</translation>
    </message>
    <message>
        <source>The pinions do not go in evenly: twice the side wheels&apos; teeth, %1, has to be a multiple of %2.</source>
        <translation>Los satélites no entran por igual: el doble de los dientes de los planetarios, %1, tiene que ser múltiplo de %2.</translation>
    </message>
    <message>
        <source>There is no such link.</source>
        <translation>No existe ese eslabón.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: a planet turns on its carrier and carries nothing.</source>
        <translation>El eslabón %1 no es un satélite: un satélite gira en su portasatélites y no soporta nada.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: one of its meshes does not fit its axes.</source>
        <translation>El eslabón %1 no es un satélite: uno de sus engranes no encaja con sus ejes.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: its meshes are with wheels on several axes.</source>
        <translation>El eslabón %1 no es un satélite: engrana con ruedas de varios ejes.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: what it turns on does not carry the axis of what it meshes with.</source>
        <translation>El eslabón %1 no es un satélite: aquello sobre lo que gira no lleva el eje de la rueda con la que engrana.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: it meshes with nothing.</source>
        <translation>El eslabón %1 no es un satélite: no engrana con nada.</translation>
    </message>
    <message>
        <source>%1 planets cannot be put in evenly.</source>
        <translation>No se pueden colocar %1 satélites por igual.</translation>
    </message>
    <message>
        <source>Short and long planet cannot touch each other: small sun + short planet and large sun + long planet differ by more than short + long planet. What fits: sums that are nearer.</source>
        <translation>El satélite corto y el largo no pueden tocarse: solar pequeño + satélite corto y solar grande + satélite largo difieren en más de corto + largo. Sirven sumas más próximas.</translation>
    </message>
    <message>
        <source>The long planets, which extend through both planes, interfere with the small sun. What fits: a large sun with at least 4 teeth more than the small one.</source>
        <translation>Los satélites largos, que atraviesan ambos planos, interfieren con el solar pequeño. Sirve un solar grande con al menos 4 dientes más que el pequeño.</translation>
    </message>
    <message>
        <source>The planets collide. What fits: fewer pairs, smaller planets, or a larger ring.</source>
        <translation>Los satélites chocan. Sirven menos parejas, satélites más pequeños o una corona mayor.</translation>
    </message>
    <message>
        <source>The pairs do not go in evenly: ring + large sun = %1 and ring - small sun = %2 have to be multiples of %3.</source>
        <translation>Las parejas no entran por igual: corona + solar grande = %1 y corona - solar pequeño = %2 tienen que ser múltiplos de %3.</translation>
    </message>
    <message>
        <source>The planets do not go in evenly: sun + ring = %1 has to be a multiple of %2.</source>
        <translation>Los satélites no entran por igual: solar + corona = %1 tiene que ser múltiplo de %2.</translation>
    </message>
    <message>
        <source>The planets collide. What fits: fewer or smaller planets, or a larger sun.</source>
        <translation>Los satélites chocan. Sirven menos satélites, más pequeños, o un solar mayor.</translation>
    </message>
    <message>
        <source>The quote that begins here is never closed.</source>
        <translation>Las comillas que empiezan aquí no se cierran nunca.</translation>
    </message>
    <message>
        <source>A field ends with its closing quote; a quote inside a field is written twice.</source>
        <translation>Un campo termina con sus comillas de cierre; unas comillas dentro de él se escriben dos veces.</translation>
    </message>
    <message>
        <source>A field with a quote in it is quoted as a whole, and the quote written twice.</source>
        <translation>Un campo con comillas va entero entre comillas, y las de dentro se escriben dos veces.</translation>
    </message>
    <message>
        <source>These bytes are not UTF-8.</source>
        <translation>Estos bytes no son UTF-8.</translation>
    </message>
    <message>
        <source>Standard input could not be read: %1.</source>
        <translation>No se pudo leer la entrada estándar: %1.</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>No se pudo leer %1: %2.</translation>
    </message>
    <message>
        <source>%1 could not be written: it is a folder.</source>
        <translation>No se pudo escribir %1: es una carpeta.</translation>
    </message>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>No se pudo escribir %1: %2.</translation>
    </message>
    <message>
        <source>; what should be in it is kept in %1</source>
        <translation>; lo que debía contener se conserva en %1</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be made: %2.</source>
        <translation>No se pudo crear la carpeta «%1»: %2.</translation>
    </message>
    <message>
        <source>Stopped; the folder is not complete.</source>
        <translation>Detenido; la carpeta está incompleta.</translation>
    </message>
    <message>
        <source>there is a file of that name</source>
        <translation>hay un archivo con ese nombre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; nothing was written.</source>
        <translation>«%1» ya existe; no se escribió nada.</translation>
    </message>
    <message>
        <source>The file is far too large.</source>
        <translation>El archivo es demasiado grande.</translation>
    </message>
    <message>
        <source>expected the end of the file after the outermost value</source>
        <translation>se esperaba el final del archivo tras el valor más externo</translation>
    </message>
    <message>
        <source>expected a value</source>
        <translation>se esperaba un valor</translation>
    </message>
    <message>
        <source>lists and objects are nested deeper than %1</source>
        <translation>las listas y objetos están anidados a más de %1 niveles</translation>
    </message>
    <message>
        <source>expected a digit of a number</source>
        <translation>se esperaba una cifra de un número</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;]&apos; in a list</source>
        <translation>se esperaba «,» o «]» en una lista</translation>
    </message>
    <message>
        <source>expected a member name in double quotes</source>
        <translation>se esperaba un nombre de miembro entre comillas dobles</translation>
    </message>
    <message>
        <source>expected &apos;:&apos; after a member name</source>
        <translation>se esperaba «:» tras un nombre de miembro</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;}&apos; in an object</source>
        <translation>se esperaba «,» o «}» en un objeto</translation>
    </message>
    <message>
        <source>expected the closing quote of a string</source>
        <translation>se esperaban las comillas de cierre de una cadena</translation>
    </message>
    <message>
        <source>expected the closing quote of a string, or an escape such as \n</source>
        <translation>se esperaban las comillas de cierre de una cadena o una secuencia de escape como \n</translation>
    </message>
    <message>
        <source>expected a character in UTF-8</source>
        <translation>se esperaba un carácter en UTF-8</translation>
    </message>
    <message>
        <source>expected an escape that JSON knows (\&quot; \\ \/ \b \f \n \r \t \u)</source>
        <translation>se esperaba una secuencia de escape de JSON (\&quot; \\ \/ \b \f \n \r \t \u)</translation>
    </message>
    <message>
        <source>expected four hexadecimal digits after \u</source>
        <translation>se esperaban cuatro cifras hexadecimales tras \u</translation>
    </message>
    <message>
        <source>expected no second half of a surrogate pair here</source>
        <translation>no se esperaba aquí la segunda mitad de un par sustituto</translation>
    </message>
    <message>
        <source>expected both halves of a surrogate pair</source>
        <translation>se esperaban ambas mitades de un par sustituto</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>el final del archivo</translation>
    </message>
    <message>
        <source>the byte 0x%1</source>
        <translation>el byte 0x%1</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3, found %4.</source>
        <translation>Línea %1, columna %2: %3, encontrado: %4.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3.</source>
        <translation>Línea %1, columna %2: %3.</translation>
    </message>
    <message>
        <source>Links %1 overlap in 3D: move their joints along the axes, leave pitch points open, or change the tooth counts.</source>
        <translation>Los eslabones %1 se solapan en 3D: mueva sus pares a lo largo de los ejes, deje puntos primitivos abiertos o cambie los números de dientes.</translation>
    </message>
    <message>
        <source>Links %1 overlap in 3D: move their joints along the axes, or change the tooth counts.</source>
        <translation>Los eslabones %1 se solapan en 3D: mueva sus pares a lo largo de los ejes, o cambie los números de dientes.</translation>
    </message>
    <message>
        <source>The rim of %1 does not reach past the roots of the ring&apos;s %2 teeth: make it larger than %3.</source>
        <translation>La llanta de %1 no llega más allá del pie de los %2 dientes de la corona: hágala mayor que %3.</translation>
    </message>
    <message>
        <source>The bore of %1 leaves no body below the roots of %2 teeth: make it smaller than %3.</source>
        <translation>El agujero de %1 no deja cuerpo bajo el pie de %2 dientes: hágalo menor que %3.</translation>
    </message>
    <message>
        <source>A gear of %1 teeth has a measure that no tooth can have; module and face width must be positive, the pressure angle between 5 and 35 degrees, shift and heights at most 3 modules.</source>
        <translation>Una rueda de %1 dientes tiene una medida que ningún diente puede tener; módulo y ancho de cara deben ser positivos, el ángulo de presión entre 5 y 35 grados, desplazamiento y alturas de 3 módulos como mucho.</translation>
    </message>
    <message>
        <source>%1 teeth are too few for a ring that a rack can generate; use at least %2.</source>
        <translation>%1 dientes son muy pocos para una corona que una cremallera pueda generar; use al menos %2.</translation>
    </message>
    <message>
        <source>%1 teeth are too few for a gear that a rack can generate; use at least %2.</source>
        <translation>%1 dientes son muy pocos para una rueda que una cremallera pueda generar; use al menos %2.</translation>
    </message>
    <message>
        <source>One tooth is too few for a gear that a rack can generate; use at least %1.</source>
        <translation>Un diente es muy poco para una rueda que pueda generar una cremallera; use al menos %1.</translation>
    </message>
    <message>
        <source>The pitch cone of a bevel gear must be between %1 and 163 degrees.</source>
        <translation>El cono primitivo de una rueda cónica tiene que estar entre %1 y 163 grados.</translation>
    </message>
    <message>
        <source>The face of %1 runs into the apex: make it shorter than %2, a third of the cone distance.</source>
        <translation>El ancho de cara de %1 llega al vértice: hágalo menor que %2, un tercio de la generatriz del cono.</translation>
    </message>
    <message>
        <source>%1 teeth leave no body below the roots; use more, or a larger profile shift.</source>
        <translation>%1 dientes no dejan cuerpo bajo el pie; use más, o un desplazamiento de perfil mayor.</translation>
    </message>
    <message>
        <source>, or give the ring %1 teeth and the planets %2 (then %3 at equal distances fit)</source>
        <translation>, o dé a la corona %1 dientes y a los satélites %2 (entonces caben %3 a distancias iguales)</translation>
    </message>
    <message>
        <source>, or use %1 planets at equal distances</source>
        <translation>, o use %1 satélites a distancias iguales</translation>
    </message>
    <message>
        <source>link %1 by %2 degrees</source>
        <translation>eslabón %1 en %2 grados</translation>
    </message>
    <message>
        <source>Equal planets fit at multiples of 360/%1 = %2 degrees: move the axis of %3 round the central axis</source>
        <translation>Los satélites iguales encajan en múltiplos de 360/%1 = %2 grados: gire alrededor del eje central el eje de: %3</translation>
    </message>
    <message>
        <source>%1 degrees on link %2</source>
        <translation>%1 grados en el eslabón %2</translation>
    </message>
    <message>
        <source>Links %1 are drawn as equal planets and cannot be equal parts: with all teeth in mesh, their gear with %2 teeth is turned against that with %3 teeth, compared with link %4, by %5.</source>
        <translation>Los eslabones %1 están dibujados como satélites iguales y no pueden ser piezas iguales: con todos los dientes engranados, su rueda de %2 dientes queda girada respecto a la de %3 dientes, comparada con el eslabón %4, en %5.</translation>
    </message>
    <message>
        <source>With these teeth there are fewer places for equal planets (%1) than planets: let the planets differ, or change tooth counts.</source>
        <translation>Con estos dientes hay menos lugares para satélites iguales (%1) que satélites: deje que los satélites difieran, o cambie los números de dientes.</translation>
    </message>
    <message>
        <source>Planets fit at multiples of 360/%1 = %2 degrees: move that of link %3 by %4 degrees</source>
        <translation>Los satélites encajan en múltiplos de 360/%1 = %2 grados: mueva el del eslabón %3 en %4 grados</translation>
    </message>
    <message>
        <source>It fits with %1 instead of %2 teeth on gear %3</source>
        <translation>Encaja con %1 en vez de %2 dientes en la rueda %3</translation>
    </message>
    <message>
        <source>, or with %1 instead of %2 teeth on gear %3</source>
        <translation>, o con %1 en vez de %2 dientes en la rueda %3</translation>
    </message>
    <message>
        <source>Change tooth counts of the loop, or move one of its axes</source>
        <translation>Cambie números de dientes del lazo o mueva uno de sus ejes</translation>
    </message>
    <message>
        <source>The loop of meshes %1 cannot be assembled as drawn: at mesh %2 the teeth miss each other by %3 of a pitch.</source>
        <translation>El lazo de los engranes %1 no se puede montar como está dibujado: en el engrane %2 los dientes no coinciden por %3 de un paso.</translation>
    </message>
    <message>
        <source>The wheels of links %1 and %2 beside gear %3 interfere: their tips overlap by %4 modules.</source>
        <translation>Las ruedas de los eslabones %1 y %2 junto a la rueda %3 interfieren: sus cabezas se solapan %4 módulos.</translation>
    </message>
    <message>
        <source>At most %1 of them fit round it, at equal distances.</source>
        <translation>Caben como mucho %1 alrededor, a distancias iguales.</translation>
    </message>
    <message>
        <source>Move one of them, or give it fewer teeth.</source>
        <translation>Mueva una de ellas o dele menos dientes.</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) has no solid: %3</source>
        <translation>La rueda %1 (%2 dientes) no tiene sólido: %3</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) is undercut: at a profile shift of %3 a rack needs %4 teeth or more. Use more teeth, or a shift of at least %5.</source>
        <translation>La rueda %1 (%2 dientes) tiene interferencia de tallado: con un desplazamiento de perfil de %3 una cremallera necesita %4 dientes o más. Use más dientes, o un desplazamiento de al menos %5.</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) would have pointed teeth: its tips were lowered to keep a land of %3 modules. Use a smaller profile shift than %4.</source>
        <translation>La rueda %1 (%2 dientes) tendría dientes puntiagudos: se rebajaron las cabezas para dejar un espesor de %3 módulos. Use un desplazamiento de perfil menor que %4.</translation>
    </message>
    <message>
        <source>Mesh %1, %2 and %3 teeth</source>
        <translation>Engrane %1, %2 y %3 dientes</translation>
    </message>
    <message>
        <source>%1: a contact ratio of %2, one pair of teeth lets go before the next takes over. Use more teeth, or profile shifts that leave longer flanks, for %3 or more.</source>
        <translation>%1: relación de contacto de %2, un par de dientes se suelta antes de que entre el siguiente. Use más dientes, o desplazamientos de perfil que dejen flancos más largos, para %3 o más.</translation>
    </message>
    <message>
        <source>%1: a contact ratio of %2, that leaves nothing for errors of the teeth. Use more teeth, or profile shifts that leave longer flanks, for %3 or more.</source>
        <translation>%1: relación de contacto de %2, no deja margen para errores de los dientes. Use más dientes, o desplazamientos de perfil que dejen flancos más largos, para %3 o más.</translation>
    </message>
    <message>
        <source>%1: a face width of %2 is more than a third of the cone distance, so that the small ends of the teeth are too weak to bear load. Use %3 or less.</source>
        <translation>%1: un ancho de cara de %2 es más de un tercio de la generatriz del cono, de modo que los extremos pequeños de los dientes son demasiado débiles para la carga. Use %3 o menos.</translation>
    </message>
    <message>
        <source>%1 teeth in a ring of %2: their tips collide outside of the mesh, by %3 modules. Use a difference of more teeth, or a larger profile shift of the ring.</source>
        <translation>%1 dientes en una corona de %2: sus cabezas chocan fuera del engrane, por %3 módulos. Use una diferencia de más dientes, o un desplazamiento de perfil mayor de la corona.</translation>
    </message>
    <message>
        <source>%1 teeth in a ring of %2: the ring&apos;s tips would interfere with the pinion&apos;s fillets and were lowered by %3 modules. Use a pinion of more teeth, or with a larger profile shift.</source>
        <translation>%1 dientes en una corona de %2: las cabezas de la corona interferirían con los acuerdos del piñón y se rebajaron %3 módulos. Use un piñón de más dientes o con mayor desplazamiento de perfil.</translation>
    </message>
    <message>
        <source>Gears %1 and %2 overlap and do not mesh.</source>
        <translation>Las ruedas %1 y %2 se solapan y no engranan.</translation>
    </message>
    <message>
        <source>Use smaller face widths, or leave them or a pitch point open.</source>
        <translation>Use anchos de diente menores, o deje sin fijar estos o un punto primitivo.</translation>
    </message>
    <message>
        <source>Move a pitch point on its axes, or leave it open.</source>
        <translation>Mueva un punto primitivo sobre sus ejes, o déjelo sin fijar.</translation>
    </message>
    <message>
        <source>Move the pitch point of one along its axis, or leave it open.</source>
        <translation>Mueva el punto primitivo de una a lo largo de su eje, o déjelo sin fijar.</translation>
    </message>
    <message>
        <source>No free places along their axes clear them: move an axis, change tooth counts, or state pitch points.</source>
        <translation>Ningún lugar libre a lo largo de sus ejes las separa: mueva un eje, cambie los números de dientes o indique puntos primitivos.</translation>
    </message>
    <message>
        <source>The number is too large; its double would be infinite.</source>
        <translation>El número es demasiado grande; en coma flotante sería infinito.</translation>
    </message>
    <message>
        <source>A list has at most 100,000 elements; this one has %1.</source>
        <translation>Una lista tiene como mucho 100.000 elementos; esta tiene %1.</translation>
    </message>
    <message>
        <source>The member occurs twice in its object; only one may stay.</source>
        <translation>El miembro aparece dos veces en su objeto; solo puede quedar uno.</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>el número %1</translation>
    </message>
    <message>
        <source>the string %1</source>
        <translation>la cadena %1</translation>
    </message>
    <message>
        <source>a list of %1 elements</source>
        <translation>una lista de %1 elementos</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>an id: a string of 1 to 1,000 characters or a whole number</source>
        <translation>un identificador: una cadena de 1 a 1.000 caracteres o un número entero</translation>
    </message>
    <message>
        <source>a number, or a fraction as a string like &quot;22/7&quot;</source>
        <translation>un número, o una fracción como cadena, por ejemplo «22/7»</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>se esperaba %1, se encontró %2.</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; is missing; expected %2.</source>
        <translation>falta el miembro «%1»; se esperaba %2.</translation>
    </message>
    <message>
        <source>a list of ids</source>
        <translation>una lista de identificadores</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>una cadena</translation>
    </message>
    <message>
        <source>expected at most 1,000 characters, found %1.</source>
        <translation>se esperaban como mucho 1.000 caracteres, se encontraron %1.</translation>
    </message>
    <message>
        <source>there is no member &quot;%1&quot;; &quot;%2&quot; is meant.</source>
        <translation>no hay ningún miembro «%1»; se trata de «%2».</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; has no meaning here.</source>
        <translation>el miembro «%1» no tiene significado aquí.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; in %2 has no meaning beside the others of its object: it is kept and changes nothing.</source>
        <translation>El miembro «%1» en %2 no tiene significado junto a los demás de su objeto: se conserva y no cambia nada.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; of the document is not known here: it is kept and changes nothing.</source>
        <translation>El miembro «%1» del documento no se conoce aquí: se conserva y no cambia nada.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; in %2 is not known here: it is kept and changes nothing.</source>
        <translation>El miembro «%1» en %2 no se conoce aquí: se conserva y no cambia nada.</translation>
    </message>
    <message>
        <source>Is &quot;%1&quot; meant?</source>
        <translation>¿Se trata de «%1»?</translation>
    </message>
    <message>
        <source>3D files of links are shown only: they have no mass, and overlaps and collisions with them are not looked for.</source>
        <translation>Los archivos 3D de los eslabones solo se muestran: no tienen masa y no se buscan solapamientos ni colisiones con ellos.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; names the 3D file &quot;%2&quot;, which cannot be read.</source>
        <translation>El eslabón «%1» nombra el archivo 3D «%2», que no se puede leer.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; names the 3D file &quot;%2&quot;, which is not there: the path begins at the folder of the document.</source>
        <translation>El eslabón «%1» nombra el archivo 3D «%2», que no existe: la ruta empieza en la carpeta del documento.</translation>
    </message>
    <message>
        <source>a list of three numbers</source>
        <translation>una lista de tres números</translation>
    </message>
    <message>
        <source>a list of six numbers, xx, yy, zz, xy, xz, yz</source>
        <translation>una lista de seis números, xx, yy, zz, xy, xz, yz</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a list of two, each a number or null</source>
        <translation>una lista de dos, cada uno un número o null</translation>
    </message>
    <message>
        <source>the whole number %1</source>
        <translation>el número entero %1</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>un número entero de %1 a %2</translation>
    </message>
    <message>
        <source>The file has version %1, but this program reads version %2: open it with a newer GearGraph.</source>
        <translation>El archivo tiene la versión %1, pero este programa lee la versión %2: ábralo con un GearGraph más nuevo.</translation>
    </message>
    <message>
        <source>This is not a GearGraph document: the member &quot;format&quot; has to be &quot;geargraph&quot;.</source>
        <translation>Esto no es un documento de GearGraph: el miembro «format» tiene que ser «geargraph».</translation>
    </message>
    <message>
        <source>a list of links, the ground first</source>
        <translation>una lista de eslabones, primero el bastidor</translation>
    </message>
    <message>
        <source>a list of turning joints that tie the links</source>
        <translation>una lista de pares de revolución que unen los eslabones</translation>
    </message>
    <message>
        <source>a list of the axes that the turning joints name</source>
        <translation>una lista de los ejes que nombran los pares de revolución</translation>
    </message>
    <message>
        <source>a list of 3D files</source>
        <translation>una lista de archivos 3D</translation>
    </message>
    <message>
        <source>a &quot;mass&quot; beside it</source>
        <translation>un «mass» a su lado</translation>
    </message>
    <message>
        <source>a speed in rad/s</source>
        <translation>una velocidad en rad/s</translation>
    </message>
    <message>
        <source>the name of the state</source>
        <translation>el nombre del estado</translation>
    </message>
    <message>
        <source>a list of ids of couplings</source>
        <translation>una lista de identificadores de acoplamientos</translation>
    </message>
    <message>
        <source>a list of two ids of links</source>
        <translation>una lista de dos identificadores de eslabones</translation>
    </message>
    <message>
        <source>a torque in N m</source>
        <translation>un momento en N m</translation>
    </message>
    <message>
        <source>a torque or a force, not both in one load</source>
        <translation>un momento o una fuerza, no ambos en una carga</translation>
    </message>
    <message>
        <source>the point of the link that the force acts at</source>
        <translation>el punto del eslabón en que actúa la fuerza</translation>
    </message>
    <message>
        <source>a joint or a link, not both</source>
        <translation>un par o un eslabón, no ambos</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>se esperaba una lista.</translation>
    </message>
    <message>
        <source>The file has %1 bytes; at most 64 MiB are read.</source>
        <translation>El archivo tiene %1 bytes; se leen como mucho 64 MiB.</translation>
    </message>
    <message>
        <source>This is no GearGraph document: the file is not text in UTF-8, but a picture, an archive or the like, or damaged.</source>
        <translation>Esto no es un documento de GearGraph: el archivo no es texto en UTF-8, sino una imagen, un archivo comprimido o algo así, o está dañado.</translation>
    </message>
    <message>
        <source>A centre of mass and an inertia need a &quot;mass&quot; beside them.</source>
        <translation>Un centro de masas y una inercia necesitan un «mass» a su lado.</translation>
    </message>
    <message>
        <source>This is no table of a mechanism: its first row has to name the columns, &quot;element&quot; among them.</source>
        <translation>Esto no es una tabla de un mecanismo: su primera fila tiene que nombrar las columnas, entre ellas «element».</translation>
    </message>
    <message>
        <source>There are too many columns.</source>
        <translation>Hay demasiadas columnas.</translation>
    </message>
    <message>
        <source>There is no column &quot;%1&quot;: %2.</source>
        <translation>No hay ninguna columna «%1»: %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs twice.</source>
        <translation>La columna «%1» aparece dos veces.</translation>
    </message>
    <message>
        <source>The column &quot;element&quot; is empty; it says what the row is about.</source>
        <translation>La columna «element» está vacía; dice de qué trata la fila.</translation>
    </message>
    <message>
        <source>There is no element &quot;%1&quot;: %2.</source>
        <translation>No hay ningún elemento «%1»: %2.</translation>
    </message>
    <message>
        <source>This cell is in a column without a name.</source>
        <translation>Esta celda está en una columna sin nombre.</translation>
    </message>
    <message>
        <source>This row has more cells than there are columns.</source>
        <translation>Esta fila tiene más celdas que columnas hay.</translation>
    </message>
    <message>
        <source>There is one row &quot;document&quot; at most.</source>
        <translation>Hay como mucho una fila «document».</translation>
    </message>
    <message>
        <source>A document has at most 100,000 %1.</source>
        <translation>Un documento tiene como mucho 100.000 %1.</translation>
    </message>
    <message>
        <source>The row names a &quot;joint&quot; or a &quot;link&quot;, one of them.</source>
        <translation>La fila nombra un «joint» o un «link», uno de los dos.</translation>
    </message>
    <message>
        <source>An &quot;axis&quot; is named beside a &quot;link&quot;; a joint has its own.</source>
        <translation>Un «axis» se nombra junto a un «link»; un par tiene el suyo.</translation>
    </message>
    <message>
        <source>A load has a &quot;torque&quot;, or a force (dx, dy, dz) at a point (x, y, z).</source>
        <translation>Una carga tiene un «torque», o una fuerza (dx, dy, dz) en un punto (x, y, z).</translation>
    </message>
    <message>
        <source>A force acts on a &quot;link&quot;: it has dx, dy, dz and a point x, y, z, and no axis.</source>
        <translation>Una fuerza actúa sobre un «link»: tiene dx, dy, dz y un punto x, y, z, y ningún eje.</translation>
    </message>
    <message>
        <source>More problems follow; only the first 100 are listed.</source>
        <translation>Siguen más problemas; solo se enumeran los 100 primeros.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; is empty; expected %2.</source>
        <translation>La columna «%1» está vacía; se esperaba %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; has %2; expected %3.</source>
        <translation>La columna «%1» tiene %2; se esperaba %3.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; has no meaning for the element &quot;%2&quot;.</source>
        <translation>La columna «%1» no tiene significado para el elemento «%2».</translation>
    </message>
    <message>
        <source>an id of at most 1,000 characters</source>
        <translation>un identificador de 1.000 caracteres como mucho</translation>
    </message>
    <message>
        <source>at most 100,000 ids of 1 to 1,000 characters, with a bar (|) between</source>
        <translation>como mucho 100.000 identificadores de 1 a 1.000 caracteres, separados por una barra (|)</translation>
    </message>
    <message>
        <source>a number, such as 12, -1.5, 1e-3 or 22/7</source>
        <translation>un número, como 12, -1.5, 1e-3 o 22/7</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a number of teeth</source>
        <translation>un número de dientes</translation>
    </message>
    <message>
        <source>a whole number from 1 to 100,000</source>
        <translation>un número entero de 1 a 100.000</translation>
    </message>
    <message>
        <source>yes, no or nothing</source>
        <translation>yes, no o nada</translation>
    </message>
    <message>
        <source>an id</source>
        <translation>un identificador</translation>
    </message>
    <message>
        <source>a number, as its neighbours have one</source>
        <translation>un número, como lo tienen sus vecinas</translation>
    </message>
    <message>
        <source>an attached 3D file</source>
        <translation>un archivo 3D adjunto</translation>
    </message>
    <message>
        <source>%1 attached 3D files</source>
        <translation>%1 archivos 3D adjuntos</translation>
    </message>
    <message>
        <source>the view (places in the drawings, camera of the 3D view)</source>
        <translation>la vista (lugares en los dibujos, cámara de la vista 3D)</translation>
    </message>
    <message>
        <source>members that this program does not know</source>
        <translation>miembros que este programa no conoce</translation>
    </message>
    <message>
        <source>the empty name of the unit, which becomes &quot;mm&quot;</source>
        <translation>el nombre vacío de la unidad, que pasa a «mm»</translation>
    </message>
    <message>
        <source>a path that stays in the folder of this document</source>
        <translation>una ruta que no sale de la carpeta de este documento</translation>
    </message>
    <message>
        <source>an object of points by the id of their link</source>
        <translation>un objeto de puntos por el identificador de su eslabón</translation>
    </message>
    <message>
        <source>expected the point of a node: a list of two numbers, x to the right and y down.</source>
        <translation>se esperaba el punto de un nodo: una lista de dos números, x a la derecha e y hacia abajo.</translation>
    </message>
    <message>
        <source>a list of notes</source>
        <translation>una lista de notas</translation>
    </message>
    <message>
        <source>the text of the note</source>
        <translation>el texto de la nota</translation>
    </message>
    <message>
        <source>the middle of the note</source>
        <translation>el centro de la nota</translation>
    </message>
    <message>
        <source>a list of two numbers, x to the right and y down</source>
        <translation>una lista de dos números, x a la derecha e y hacia abajo</translation>
    </message>
    <message>
        <source>the point that the camera looks at</source>
        <translation>el punto al que mira la cámara</translation>
    </message>
    <message>
        <source>an angle in degrees</source>
        <translation>un ángulo en grados</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>un número mayor que 0</translation>
    </message>
    <message>
        <source>The axis would coincide with the one that its wheels mesh with.</source>
        <translation>El eje coincidiría con aquel con cuyas ruedas engranan las suyas.</translation>
    </message>
    <message>
        <source>There is no place for axis %1 where the wheels of meshes %2 would touch at these tooth counts. What fits: a smaller change, or other teeth first.</source>
        <translation>No hay lugar para el eje %1 donde las ruedas de los engranes %2 se toquen con estos números de dientes. Sirve un cambio menor, o antes otros dientes.</translation>
    </message>
    <message>
        <source>Mesh %1 is no bevel pair: only bevels have an apex with two sides.</source>
        <translation>El engrane %1 no es cónico: solo las cónicas tienen un vértice con dos lados.</translation>
    </message>
    <message>
        <source>A module is more than 0: the pitch diameter over the teeth.</source>
        <translation>Un módulo es mayor que 0: el diámetro primitivo entre los dientes.</translation>
    </message>
    <message>
        <source>Modules can be set where every mesh has its place, in trains of up to %1 meshes. Resolve the reported problems first.</source>
        <translation>Los módulos se pueden fijar donde cada engrane tiene su lugar, en trenes de hasta %1 engranes. Resuelva antes los problemas indicados.</translation>
    </message>
    <message>
        <source>Mesh %1 cannot follow: %2 is pinned. What fits: unpin it, or another change.</source>
        <translation>El engrane %1 no puede seguir: %2 está fijado. Suéltelo, o haga otro cambio.</translation>
    </message>
    <message>
        <source>Mesh %1 cannot follow: %2 are pinned. What fits: unpin one of them, or another change.</source>
        <translation>El engrane %1 no puede seguir: %2 están fijados. Suelte uno de ellos, o haga otro cambio.</translation>
    </message>
    <message>
        <source>The module of mesh %1 is pinned, and would change. What fits: unpin it, or another change.</source>
        <translation>El módulo del engrane %1 está fijado y cambiaría. Suéltelo, o haga otro cambio.</translation>
    </message>
    <message>
        <source>Axis %1 is pinned. What fits: unpin it to move it.</source>
        <translation>El eje %1 está fijado. Suéltelo para moverlo.</translation>
    </message>
    <message>
        <source>gear %1 would need %2 teeth to stay coaxial. What fits: a smaller change.</source>
        <translation>la rueda %1 necesitaría %2 dientes para seguir coaxial. Sirve un cambio menor.</translation>
    </message>
    <message>
        <source>an internal pair needs different tooth counts, the ring the larger one.</source>
        <translation>un par interior necesita números de dientes distintos, la corona el mayor.</translation>
    </message>
    <message>
        <source>The comment has no end.</source>
        <translation>El comentario no tiene fin.</translation>
    </message>
    <message>
        <source>This character is no part of DOT.</source>
        <translation>Este carácter no pertenece a DOT.</translation>
    </message>
    <message>
        <source>The quote has no end.</source>
        <translation>Las comillas no se cierran.</translation>
    </message>
    <message>
        <source>The text in angle brackets has no end.</source>
        <translation>El texto entre corchetes angulares no tiene fin.</translation>
    </message>
    <message>
        <source>This is no number.</source>
        <translation>Esto no es un número.</translation>
    </message>
    <message>
        <source>The text is not UTF-8.</source>
        <translation>El texto no es UTF-8.</translation>
    </message>
    <message>
        <source>Behind the graph is something else; a file with one graph is read.</source>
        <translation>Tras el grafo hay algo más; se lee un archivo con un solo grafo.</translation>
    </message>
    <message>
        <source>Expected %1, found the end.</source>
        <translation>Se esperaba %1, se encontró el final.</translation>
    </message>
    <message>
        <source>Expected %1, found %2.</source>
        <translation>Se esperaba %1, se encontró %2.</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a quoted text</source>
        <translation>un texto entre comillas</translation>
    </message>
    <message>
        <source>Groups are nested deeper than 64.</source>
        <translation>Los grupos están anidados a más de 64 niveles.</translation>
    </message>
    <message>
        <source>An edge between groups is not read; write an edge for each joint and mesh.</source>
        <translation>No se lee una arista entre grupos; escriba una arista por cada par y cada engrane.</translation>
    </message>
    <message>
        <source>An edge of a directed graph is written -&gt;.</source>
        <translation>Una arista de un grafo dirigido se escribe -&gt;.</translation>
    </message>
    <message>
        <source>The graph is strict, and a second edge leads from %1 to %2: it would be one with the first. Leave out &quot;strict&quot;.</source>
        <translation>El grafo es «strict» y una segunda arista va de %1 a %2: sería la misma que la primera. Quite «strict».</translation>
    </message>
    <message>
        <source>A graph of at most 200,000 edges is read.</source>
        <translation>Se lee un grafo de 200.000 aristas como máximo.</translation>
    </message>
    <message>
        <source>A graph of at most 100,000 nodes is read.</source>
        <translation>Se lee un grafo de 100.000 nodos como máximo.</translation>
    </message>
    <message>
        <source>The graph is undirected, so that it does not say which link of a joint or mesh is tail and which is head: the signs and the teeth of each gear depend on it. Make it directed.</source>
        <translation>El grafo no es dirigido, así que no dice qué eslabón de un par o engrane es cola y cuál cabeza: de ello dependen los signos y los dientes de cada rueda. Hágalo dirigido.</translation>
    </message>
    <message>
        <source>This is no XML: %1.</source>
        <translation>Esto no es XML: %1.</translation>
    </message>
    <message>
        <source>There is no &lt;graph&gt; in the file.</source>
        <translation>En el archivo no hay ningún &lt;graph&gt;.</translation>
    </message>
    <message>
        <source>A file with a document type (&lt;!DOCTYPE&gt;) is not read; leave it out.</source>
        <translation>No se lee un archivo con tipo de documento (&lt;!DOCTYPE&gt;); quítelo.</translation>
    </message>
    <message>
        <source>The element &lt;%1&gt; lacks the attribute &quot;%2&quot;.</source>
        <translation>Al elemento &lt;%1&gt; le falta el atributo «%2».</translation>
    </message>
    <message>
        <source>Elements are nested deeper than 64.</source>
        <translation>Los elementos están anidados a más de 64 niveles.</translation>
    </message>
    <message>
        <source>This is no GraphML: it begins with &lt;%1&gt;.</source>
        <translation>Esto no es GraphML: empieza por &lt;%1&gt;.</translation>
    </message>
    <message>
        <source>A hyperedge is not read; a joint and a mesh are edges between two nodes.</source>
        <translation>No se lee una hiperarista; un par y un engrane son aristas entre dos nodos.</translation>
    </message>
    <message>
        <source>A file with one graph is read, without graphs inside its nodes.</source>
        <translation>Se lee un archivo con un solo grafo, sin grafos dentro de sus nodos.</translation>
    </message>
    <message>
        <source>The graph has no node; the first one is the ground.</source>
        <translation>El grafo no tiene nodos; el primero es el bastidor.</translation>
    </message>
    <message>
        <source>The graph has version %1, but this program reads version %2: read it with a newer GearGraph.</source>
        <translation>El grafo tiene la versión %1, pero este programa lee la versión %2: léalo con un GearGraph más nuevo.</translation>
    </message>
    <message>
        <source>The ground is the first node, %1.</source>
        <translation>El bastidor es el primer nodo, %1.</translation>
    </message>
    <message>
        <source>The edge %1 (%2)</source>
        <translation>La arista %1 (%2)</translation>
    </message>
    <message>
        <source>The edge %1</source>
        <translation>La arista %1</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;kind&quot;; expected &quot;turning&quot; or &quot;mesh&quot;.</source>
        <translation>%1: falta el atributo «kind»; se esperaba «turning» o «mesh».</translation>
    </message>
    <message>
        <source>%1: its &quot;kind&quot; is %2, so this is a T-T graph; the digraph (--view digraph) is read back.</source>
        <translation>%1: su «kind» es %2, así que es un grafo T-T; lo que se vuelve a leer es el dígrafo (--view digraph).</translation>
    </message>
    <message>
        <source>%1: its &quot;kind&quot; is %2; expected &quot;turning&quot; or &quot;mesh&quot;.</source>
        <translation>%1: su «kind» es %2; se esperaba «turning» o «mesh».</translation>
    </message>
    <message>
        <source>As a document the graph has more than 64 MiB.</source>
        <translation>Como documento, el grafo tiene más de 64 MiB.</translation>
    </message>
    <message>
        <source>%1, %2: expected a list or an object as JSON, found %3.</source>
        <translation>%1, %2: se esperaba una lista o un objeto como JSON, se encontró %3.</translation>
    </message>
    <message>
        <source>The graph</source>
        <translation>El grafo</translation>
    </message>
    <message>
        <source>The node %1</source>
        <translation>El nodo %1</translation>
    </message>
    <message>
        <source>%1 is in the graph twice.</source>
        <translation>%1 aparece dos veces en el grafo.</translation>
    </message>
    <message>
        <source>The graph has no places of axes: %1 are placed from the tooth counts.</source>
        <translation>El grafo no tiene posiciones de ejes: %1 se colocan a partir de los números de dientes.</translation>
    </message>
    <message>
        <source>1 mesh has no &quot;meshKind&quot;: external between parallel axes, bevel between intersecting ones.</source>
        <translation>1 engrane no tiene «meshKind»: exterior entre ejes paralelos, cónico entre los que se cortan.</translation>
    </message>
    <message>
        <source>%1 meshes have no &quot;meshKind&quot;: external between parallel axes, bevel between intersecting ones.</source>
        <translation>%1 engranes no tienen «meshKind»: exteriores entre ejes paralelos, cónicos entre los que se cortan.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the name of the axis that the joint turns about, the same for joints on one axis.</source>
        <translation>%1: falta el atributo «%2»: el nombre del eje en torno al que gira el par, el mismo para los pares de un eje.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the number of teeth of the gear on its first node.</source>
        <translation>%1: falta el atributo «%2»: el número de dientes de la rueda en su primer nodo.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the number of teeth of the gear on its second node.</source>
        <translation>%1: falta el atributo «%2»: el número de dientes de la rueda en su segundo nodo.</translation>
    </message>
    <message>
        <source>%1: there is no node %2.</source>
        <translation>%1: no hay ningún nodo %2.</translation>
    </message>
    <message>
        <source>Attributes without a meaning for the mechanism were not read: %1.</source>
        <translation>No se leyeron los atributos sin significado para el mecanismo: %1.</translation>
    </message>
    <message>
        <source>A graph of at most 100,000 nodes and 200,000 edges is read.</source>
        <translation>Se lee un grafo de 100.000 nodos y 200.000 aristas como máximo.</translation>
    </message>
    <message>
        <source>This is no node-link graph: it is an object with the lists &quot;nodes&quot; and &quot;links&quot;.</source>
        <translation>Esto no es un grafo node-link: ese es un objeto con las listas «nodes» y «links».</translation>
    </message>
    <message>
        <source>Expected an object with &quot;%1&quot;, a text or a number that names a node.</source>
        <translation>Se esperaba un objeto con «%1», un texto o un número que nombre un nodo.</translation>
    </message>
    <message>
        <source>%1 link</source>
        <translation>%1 eslabón</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 añadidos</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 eliminados</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 modificados</translation>
    </message>
    <message>
        <source>axes changed</source>
        <translation>ejes modificados</translation>
    </message>
    <message>
        <source>inputs changed</source>
        <translation>entradas modificadas</translation>
    </message>
    <message>
        <source>links moved in the drawing</source>
        <translation>eslabones movidos en el dibujo</translation>
    </message>
    <message>
        <source>other properties changed</source>
        <translation>otras propiedades modificadas</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot; in %2.</source>
        <translation>No hay «%1» en %2.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>Un par de revolución del eslabón %1 al %2 cerraría un lazo. Los pares de revolución tienen que ser un árbol: dibuje un engrane en su lugar.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop with joint %3. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>Un par de revolución del eslabón %1 al %2 cerraría un lazo con el par %3. Los pares de revolución tienen que ser un árbol: dibuje un engrane en su lugar.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop with joints %3. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>Un par de revolución del eslabón %1 al %2 cerraría un lazo con los pares %3. Los pares de revolución tienen que ser un árbol: dibuje un engrane en su lugar.</translation>
    </message>
    <message>
        <source>A turning joint needs two different links.</source>
        <translation>Un par de revolución necesita dos eslabones distintos.</translation>
    </message>
    <message>
        <source>To split link %1, choose some of its joints and meshes, and leave others: the new link takes those that you choose.</source>
        <translation>Para dividir el eslabón %1, elija algunos de sus pares y engranes y deje otros: el eslabón nuevo toma los elegidos.</translation>
    </message>
    <message>
        <source>Link %1 turns on no other link, so that its parts have no axis: draw its joint first.</source>
        <translation>El eslabón %1 no gira sobre ningún otro, de modo que sus partes no tienen eje: dibuje primero su par.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint, mesh or coupling of link %2.</source>
        <translation>«%1» no es un par, un engrane ni un acoplamiento del eslabón %2.</translation>
    </message>
    <message>
        <source>The ground cannot be split: nothing says about which axis its part turns.</source>
        <translation>El bastidor no se puede dividir: nada indica en torno a qué eje gira su parte.</translation>
    </message>
    <message>
        <source>A weld needs two different links.</source>
        <translation>Para soldar hacen falta dos eslabones distintos.</translation>
    </message>
    <message>
        <source>Links %1 and %2 cannot be one: both wheels of mesh %3 would turn about one axis.</source>
        <translation>Los eslabones %1 y %2 no pueden ser uno: las dos ruedas del engrane %3 girarían en torno a un mismo eje.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are in different places of one train, so that links %3 and %4 cannot be one: lay one axis on the other first.</source>
        <translation>Los ejes %1 y %2 están en lugares distintos de un mismo tren, de modo que los eslabones %3 y %4 no pueden ser uno: disponga primero un eje sobre el otro.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 have different directions, so that links %3 and %4 cannot be one: lay one axis along the other first.</source>
        <translation>Los ejes %1 y %2 tienen direcciones distintas, de modo que los eslabones %3 y %4 no pueden ser uno: disponga primero un eje a lo largo del otro.</translation>
    </message>
    <message>
        <source>The limits of joints %1 and %2 leave the welded link no angle to turn: change them first.</source>
        <translation>Los límites de los pares %1 y %2 no dejan ángulo de giro al eslabón soldado: cámbielos primero.</translation>
    </message>
    <message>
        <source>Links %1 and %2 cannot be one: it would turn about several axes. Links are welded whose joints can lie on one axis.</source>
        <translation>Los eslabones %1 y %2 no pueden ser uno: giraría en torno a varios ejes. Se sueldan eslabones cuyos pares pueden estar en un mismo eje.</translation>
    </message>
    <message>
        <source>A load or balance is in joint %1, which the weld takes away: remove it first.</source>
        <translation>En el par %1, que desaparece al soldar, hay una carga o una equilibrante: quítela primero.</translation>
    </message>
    <message>
        <source>The mass of link %1 is stated, and would be that of a part only: remove it before you weld the link.</source>
        <translation>La masa del eslabón %1 está indicada y sería solo la de una parte: quítela antes de soldar el eslabón.</translation>
    </message>
    <message>
        <source>Links %1 and %2 mesh with each other in mesh %3: delete it before you weld them.</source>
        <translation>Los eslabones %1 y %2 engranan entre sí en el engrane %3: elimínelo antes de soldarlos.</translation>
    </message>
    <message>
        <source>A gear mesh needs two different links.</source>
        <translation>Un engrane necesita dos eslabones distintos.</translation>
    </message>
    <message>
        <source>The ground cannot be deleted; make another link the ground first.</source>
        <translation>El bastidor no se puede eliminar; haga antes bastidor otro eslabón.</translation>
    </message>
    <message>
        <source>Only links and axes bear names; the others bear the paper&apos;s labels.</source>
        <translation>Solo los eslabones y los ejes llevan nombre; los demás llevan las etiquetas del artículo.</translation>
    </message>
    <message>
        <source>An axis needs a name.</source>
        <translation>Un eje necesita un nombre.</translation>
    </message>
    <message>
        <source>There is an axis &quot;%1&quot; already.</source>
        <translation>Ya hay un eje «%1».</translation>
    </message>
    <message>
        <source>A gear has 1 to 100,000 teeth, not %1.</source>
        <translation>Una rueda tiene de 1 a 100.000 dientes, no %1.</translation>
    </message>
    <message>
        <source>The direction of axis %1 has length 0.</source>
        <translation>La dirección del eje %1 tiene longitud 0.</translation>
    </message>
    <message>
        <source>The joint is an input already.</source>
        <translation>El par ya es una entrada.</translation>
    </message>
    <message>
        <source>Loads or balances act on this link, and the ground can have none: remove them first.</source>
        <translation>Sobre este eslabón actúan cargas o equilibrantes, y el bastidor no puede tener: elimínelos antes.</translation>
    </message>
    <message>
        <source>There is no link or note in what was copied.</source>
        <translation>En lo copiado no hay ningún eslabón ni nota.</translation>
    </message>
    <message>
        <source>A name has at most 1,000 characters; this one has %1.</source>
        <translation>Un nombre tiene como mucho 1.000 caracteres; este tiene %1.</translation>
    </message>
    <message>
        <source>A document has at most 100,000 %1; this one has %2.</source>
        <translation>Un documento tiene como mucho 100.000 %1; este tiene %2.</translation>
    </message>
    <message>
        <source>expected a coordinate from -1e15 to 1e15.</source>
        <translation>se esperaba una coordenada de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a number from -1e15 to 1e15.</source>
        <translation>se esperaba un número de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a component from -1e15 to 1e15.</source>
        <translation>se esperaba una componente de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a length from -1e15 to 1e15.</source>
        <translation>se esperaba una longitud de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a density from -1e15 to 1e15.</source>
        <translation>se esperaba una densidad de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a mass from -1e15 to 1e15.</source>
        <translation>se esperaba una masa de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a moment from -1e15 to 1e15.</source>
        <translation>se esperaba un momento de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a torque from -1e15 to 1e15.</source>
        <translation>se esperaba un momento de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a force from -1e15 to 1e15.</source>
        <translation>se esperaba una fuerza de -1e15 a 1e15.</translation>
    </message>
    <message>
        <source>expected a direction with a component of at least 1e-15.</source>
        <translation>se esperaba una dirección con una componente de al menos 1e-15.</translation>
    </message>
    <message>
        <source>A mass is at least 0, in kg.</source>
        <translation>Una masa es como mínimo 0, en kg.</translation>
    </message>
    <message>
        <source>No body has this inertia: each principal moment is at least 0 and at most the sum of the other two. The numbers are xx, yy, zz, xy, xz, yz in kg m², about the centre of mass.</source>
        <translation>Ningún cuerpo tiene esta inercia: cada momento principal es como mínimo 0 y como mucho la suma de los otros dos. Los números son xx, yy, zz, xy, xz, yz en kg m², respecto al centro de masas.</translation>
    </message>
    <message>
        <source>%1 names &quot;%2&quot;, but %3 has no such id.</source>
        <translation>%1 nombra «%2», pero %3 no tiene ese identificador.</translation>
    </message>
    <message>
        <source>The ground takes any load: %1 are on moving links. Name one of those.</source>
        <translation>El bastidor aguanta cualquier carga: %1 están en eslabones móviles. Nombre uno de ellos.</translation>
    </message>
    <message>
        <source>The id &quot;%1&quot; occurs twice in %2.</source>
        <translation>El identificador «%1» aparece dos veces en %2.</translation>
    </message>
    <message>
        <source>The joint &quot;%1&quot; occurs twice in %2.</source>
        <translation>El par «%1» aparece dos veces en %2.</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; occurs twice in %2.</source>
        <translation>El eslabón «%1» aparece dos veces en %2.</translation>
    </message>
    <message>
        <source>A mesh has an efficiency or a coefficient of friction, not both.</source>
        <translation>Un engrane tiene un rendimiento o un coeficiente de rozamiento, no ambos.</translation>
    </message>
    <message>
        <source>A coefficient of friction is from 0 to 1.</source>
        <translation>Un coeficiente de rozamiento va de 0 a 1.</translation>
    </message>
    <message>
        <source>A density is above 0, in kg/m³.</source>
        <translation>Una densidad es mayor que 0, en kg/m³.</translation>
    </message>
    <message>
        <source>There is no note &quot;%1&quot;.</source>
        <translation>No hay ninguna nota «%1».</translation>
    </message>
    <message>
        <source>A document has at most 1,000 notes; this one has %1.</source>
        <translation>Un documento tiene como mucho 1.000 notas; este tiene %1.</translation>
    </message>
    <message>
        <source>A note has at most 1,000 characters; this one has %1.</source>
        <translation>Una nota tiene como mucho 1.000 caracteres; esta tiene %1.</translation>
    </message>
    <message>
        <source>A note needs a text.</source>
        <translation>Una nota necesita un texto.</translation>
    </message>
    <message>
        <source>A note is lines of text without control characters.</source>
        <translation>Una nota son líneas de texto sin caracteres de control.</translation>
    </message>
    <message>
        <source>There is no axis, link or mesh &quot;%1&quot; to pin.</source>
        <translation>No hay eje, eslabón ni engrane «%1» que fijar.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the folder of the document: save the document first, then copy the 3D file into its folder.</source>
        <translation>«%1» no está en la carpeta del documento: guarde primero el documento y copie después el archivo 3D en su carpeta.</translation>
    </message>
    <message>
        <source>The scale of a 3D file has to be above 0.</source>
        <translation>La escala de un archivo 3D tiene que ser mayor que 0.</translation>
    </message>
    <message>
        <source>There is a coupling &quot;%1&quot; already.</source>
        <translation>Ya hay un acoplamiento «%1».</translation>
    </message>
    <message>
        <source>The ground does not move: a brake is for a moving link.</source>
        <translation>El bastidor no se mueve: un freno es para un eslabón móvil.</translation>
    </message>
    <message>
        <source>A clutch needs two different links.</source>
        <translation>Un embrague necesita dos eslabones distintos.</translation>
    </message>
    <message>
        <source>A coupling needs a name.</source>
        <translation>Un acoplamiento necesita un nombre.</translation>
    </message>
    <message>
        <source>A state needs a name.</source>
        <translation>Un estado necesita un nombre.</translation>
    </message>
    <message>
        <source>There is a state &quot;%1&quot; already.</source>
        <translation>Ya hay un estado «%1».</translation>
    </message>
    <message>
        <source>Coupling &quot;%1&quot; is listed twice.</source>
        <translation>El acoplamiento «%1» figura dos veces.</translation>
    </message>
    <message>
        <source>A mechanism needs at least the ground.</source>
        <translation>Un mecanismo necesita al menos el bastidor.</translation>
    </message>
    <message>
        <source>An id may not be empty.</source>
        <translation>Un identificador no puede estar vacío.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; names &quot;%3&quot;, but %4 has no such id.</source>
        <translation>%1 «%2» nombra «%3», pero %4 no tiene ese identificador.</translation>
    </message>
    <message>
        <source>The 3D file of a link is a path that stays in the folder of the document, not &quot;%1&quot;.</source>
        <translation>El archivo 3D de un eslabón es una ruta que no sale de la carpeta del documento, no «%1».</translation>
    </message>
    <message>
        <source>Turning joint &quot;%1&quot; ties link &quot;%2&quot; to itself; it needs two links.</source>
        <translation>El par de revolución «%1» une el eslabón «%2» consigo mismo; necesita dos eslabones.</translation>
    </message>
    <message>
        <source>Gear mesh &quot;%1&quot; ties link &quot;%2&quot; to itself; it needs two links.</source>
        <translation>El engrane «%1» une el eslabón «%2» consigo mismo; necesita dos eslabones.</translation>
    </message>
    <message>
        <source>The face width of a gear mesh is above 0.</source>
        <translation>El ancho de cara de un engrane es mayor que 0.</translation>
    </message>
    <message>
        <source>A gear has 1 to 100,000 teeth; mesh &quot;%1&quot; says %2.</source>
        <translation>Una rueda tiene de 1 a 100.000 dientes; el engrane «%1» dice %2.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; is on link &quot;%2&quot;, but its wheel &quot;%3&quot; is on link &quot;%4&quot;.</source>
        <translation>El engrane «%1» está en el eslabón «%2», pero su rueda «%3» está en el eslabón «%4».</translation>
    </message>
    <message>
        <source>A brake names one link, a clutch two.</source>
        <translation>Un freno nombra un eslabón, un embrague dos.</translation>
    </message>
    <message>
        <source>Clutch &quot;%1&quot; ties link &quot;%2&quot; to itself.</source>
        <translation>El embrague «%1» une el eslabón «%2» consigo mismo.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; occurs twice in %2.</source>
        <translation>El nombre «%1» aparece dos veces en %2.</translation>
    </message>
    <message>
        <source>Coupling &quot;%1&quot; is listed twice in %2.</source>
        <translation>El acoplamiento «%1» figura dos veces en %2.</translation>
    </message>
    <message>
        <source>The distance of the camera has to be above 0.</source>
        <translation>La distancia de la cámara tiene que ser mayor que 0.</translation>
    </message>
    <message>
        <source>The limits of a joint are two angles from the reference pose, in degrees: the first at most 0, the second at least 0, and not both 0.</source>
        <translation>Los límites de un par son dos ángulos desde la posición de referencia, en grados: el primero como mucho 0, el segundo al menos 0, y no ambos 0.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are one line held by a common link: they are treated as one axis, with opposite directions.</source>
        <translation>Los ejes %1 y %2 son una sola recta que sostiene un eslabón común: se tratan como un solo eje, con direcciones opuestas.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are one line held by a common link: they are treated as one axis.</source>
        <translation>Los ejes %1 y %2 son una sola recta que sostiene un eslabón común: se tratan como un solo eje.</translation>
    </message>
    <message>
        <source>Axis %1 is named by joints that share no link on it (%2 ...): they coincide in the drawn pose only and are treated as different axes. Give each its own axis.</source>
        <translation>El eje %1 lo nombran pares que no comparten en él ningún eslabón (%2 ...): solo coinciden en la posición dibujada y se tratan como ejes distintos. Dé a cada uno su propio eje.</translation>
    </message>
    <message>
        <source>Mesh %1 (%2) joins two gears on the same axis %3: coaxial gears cannot mesh. Move one of them to another axis, or delete the mesh.</source>
        <translation>El engrane %1 (%2) une dos ruedas del mismo eje %3: ruedas coaxiales no pueden engranar. Pase una a otro eje, o elimine el engrane.</translation>
    </message>
    <message>
        <source>Mesh %1 (%2) has no carrier: the path between its gears changes axis more than once, %3. One link must carry both axes, so that their distance is constant.</source>
        <translation>El engrane %1 (%2) no tiene portasatélites: el camino entre sus ruedas cambia de eje más de una vez, %3. Un eslabón tiene que llevar ambos ejes para que su distancia sea constante.</translation>
    </message>
    <message>
        <source>the drawings</source>
        <translation>los dibujos</translation>
    </message>
    <message>
        <source>the matrices</source>
        <translation>las matrices</translation>
    </message>
    <message>
        <source>the exercises</source>
        <translation>los ejercicios</translation>
    </message>
    <message>
        <source>the key of the exercises</source>
        <translation>la clave de los ejercicios</translation>
    </message>
    <message>
        <source>the mechanism&apos;s data</source>
        <translation>los datos del mecanismo</translation>
    </message>
    <message>
        <source>the still picture</source>
        <translation>la imagen fija</translation>
    </message>
    <message>
        <source>the solids</source>
        <translation>los sólidos</translation>
    </message>
    <message>
        <source>The handout would have %1 MB; a page has at most 3 MB. The largest part: %2.</source>
        <translation>La hoja tendría %1 MB; una página tiene como mucho 3 MB. La parte mayor: %2.</translation>
    </message>
    <message>
        <source>Reading it took longer than %1 s.</source>
        <translation>La lectura tardó más de %1 s.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: the program that reads it crashed, and was confined.</source>
        <translation>Está dañado o hecho para hacer daño: el programa que lo lee se cerró, y estaba confinado.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: the program that reads it crashed. This system does not confine it.</source>
        <translation>Está dañado o hecho para causar daño: el programa que lo lee falló. Este sistema no lo confina.</translation>
    </message>
    <message>
        <source>Reading it was stopped.</source>
        <translation>La lectura se detuvo.</translation>
    </message>
    <message>
        <source>The program geargraph-mesh cannot be run.</source>
        <translation>No se puede ejecutar el programa geargraph-mesh.</translation>
    </message>
    <message>
        <source>There are too many open files.</source>
        <translation>Hay demasiados archivos abiertos.</translation>
    </message>
    <message>
        <source>It is not there.</source>
        <translation>No está.</translation>
    </message>
    <message>
        <source>It cannot be opened.</source>
        <translation>No se puede abrir.</translation>
    </message>
    <message>
        <source>It is no file.</source>
        <translation>No es un archivo.</translation>
    </message>
    <message>
        <source>It has %1 bytes, more than the limit of %2.</source>
        <translation>Tiene %1 bytes, más que el límite de %2.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: what the program that reads it answers is no solid.</source>
        <translation>Está dañado o hecho para hacer daño: lo que responde el programa que lo lee no es un sólido.</translation>
    </message>
    <message>
        <source>It is none of STL, OBJ, PLY and GLB.</source>
        <translation>No es STL, OBJ, PLY ni GLB.</translation>
    </message>
    <message>
        <source>The program geargraph-mesh, which reads 3D files, is missing.</source>
        <translation>Falta el programa geargraph-mesh, que lee archivos 3D.</translation>
    </message>
    <message>
        <source>Too wide for this page; the web page and LaTeX hold it whole.</source>
        <translation>Demasiado ancho para esta página; la página web y LaTeX lo contienen entero.</translation>
    </message>
    <message>
        <source>There is not enough memory for the pages.</source>
        <translation>No hay memoria suficiente para las páginas.</translation>
    </message>
    <message>
        <source>No 3D pictures: %1. On Debian, the package libgl1-mesa-dri brings what is missing.</source>
        <translation>Sin imágenes 3D: %1. En Debian, el paquete libgl1-mesa-dri trae lo que falta.</translation>
    </message>
    <message>
        <source>EGL finds no device</source>
        <translation>EGL no encuentra ningún dispositivo</translation>
    </message>
    <message>
        <source>EGL has no desktop OpenGL</source>
        <translation>EGL no tiene OpenGL de escritorio</translation>
    </message>
    <message>
        <source>EGL has no OpenGL configuration</source>
        <translation>EGL no tiene configuración de OpenGL</translation>
    </message>
    <message>
        <source>there is no OpenGL 3.3 core</source>
        <translation>no hay núcleo de OpenGL 3.3</translation>
    </message>
    <message>
        <source>the driver cannot paint without a window</source>
        <translation>el controlador no puede pintar sin una ventana</translation>
    </message>
    <message>
        <source>No 3D pictures: %1. Install a driver with OpenGL 3.3 or newer.</source>
        <translation>Sin imágenes 3D: %1. Instale un controlador con OpenGL 3.3 o más nuevo.</translation>
    </message>
    <message>
        <source>the driver has no %1</source>
        <translation>el controlador no tiene %1</translation>
    </message>
    <message>
        <source>the driver offers OpenGL %1</source>
        <translation>el controlador ofrece OpenGL %1</translation>
    </message>
    <message>
        <source>the driver rejects a shader: %1</source>
        <translation>el controlador rechaza un sombreador: %1</translation>
    </message>
    <message>
        <source>The picture would be more than %1 pixels wide or high: give it a smaller size, or write SVG or PDF.</source>
        <translation>La imagen tendría más de %1 píxeles de ancho o alto: dele un tamaño menor, o escriba SVG o PDF.</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 perdidos</translation>
    </message>
    <message>
        <source>* shared by equal stiffness: an assumption</source>
        <translation>* repartido por igual rigidez: una suposición</translation>
    </message>
    <message>
        <source>? W: shared in unknown parts, not determined</source>
        <translation>? W: repartido en partes desconocidas, no determinado</translation>
    </message>
    <message>
        <source>circulates: links %1, meshes %2</source>
        <translation>circula: eslabones %1, engranes %2</translation>
    </message>
    <message>
        <source>seen from the ground</source>
        <translation>visto desde el bastidor</translation>
    </message>
    <message>
        <source>seen from link %1</source>
        <translation>visto desde el eslabón %1</translation>
    </message>
    <message>
        <source>Balance in joint %1</source>
        <translation>Equilibrio en el par %1</translation>
    </message>
    <message>
        <source>Balance on link %1</source>
        <translation>Equilibrio en el eslabón %1</translation>
    </message>
    <message>
        <source>%1: not determined, it shares the loads in unknown parts.</source>
        <translation>%1: no determinado, comparte las cargas en partes desconocidas.</translation>
    </message>
    <message>
        <source>%1: found, it holds the loads with %2 N m.</source>
        <translation>%1: hallado, sostiene las cargas con %2 N m.</translation>
    </message>
    <message>
        <source>It feeds %1 into the train.</source>
        <translation>Aporta %1 al tren.</translation>
    </message>
    <message>
        <source>It takes %1 out of the train.</source>
        <translation>Toma %1 del tren.</translation>
    </message>
    <message>
        <source>T shared</source>
        <translation>T común</translation>
    </message>
    <message>
        <source>Both methods give the same fractions: all %1 entries agree.</source>
        <translation>Ambos métodos dan las mismas fracciones: coinciden las %1 entradas.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Paso a paso</translation>
    </message>
    <message>
        <source>Matroid method</source>
        <translation>Método del matroide</translation>
    </message>
    <message>
        <source>T-T graph method</source>
        <translation>Método del grafo T-T</translation>
    </message>
    <message>
        <source>Relation</source>
        <translation>Relación</translation>
    </message>
    <message>
        <source>Mesh by mesh</source>
        <translation>Engrane a engrane</translation>
    </message>
    <message>
        <source>For each mesh, above: its row of $P$, divided by the radius of the head&apos;s gear. Below: its terminal equation with both circuits put in, times $N_{tail} / N_{head}$.</source>
        <translation>Para cada engrane, arriba su fila de $P$ dividida entre el radio de la rueda de la cabeza; abajo su ecuación terminal con ambos circuitos sustituidos, por $N_{tail} / N_{head}$.</translation>
    </message>
    <message>
        <source>too long to write</source>
        <translation>demasiado largo para escribirlo</translation>
    </message>
    <message>
        <source>Counted</source>
        <translation>Contado</translation>
    </message>
    <message>
        <source>Products and quotients, sums and differences of the calculation by hand for this mechanism; those with $0$ and $\pm 1$ cost nothing.</source>
        <translation>Productos y cocientes, sumas y restas del cálculo a mano para este mecanismo; los de $0$ y $\pm 1$ no cuestan nada.</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Incógnitas</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Ecuaciones</translation>
    </message>
    <message>
        <source>Matrix of the equations</source>
        <translation>Matriz de las ecuaciones</translation>
    </message>
    <message>
        <source>Entries that are not 0</source>
        <translation>Entradas distintas de 0</translation>
    </message>
    <message>
        <source>From the drawing to the equations</source>
        <translation>Del dibujo a las ecuaciones</translation>
    </message>
    <message>
        <source>From the equations to the solution</source>
        <translation>De las ecuaciones a la solución</translation>
    </message>
    <message>
        <source>The same in gear ratios</source>
        <translation>Lo mismo en relaciones de engrane</translation>
    </message>
    <message>
        <source>With more links</source>
        <translation>Con más eslabones</translation>
    </message>
    <message>
        <source>The same counted on larger trains. The chain of substitutions grows with the number of meshes times that of the inputs; the inverse of $P_r$ holds all products along the way and grows with its square.</source>
        <translation>Lo mismo contado en trenes mayores. La cadena de sustituciones crece con el número de engranes por el de entradas; la inversa de $P_r$ contiene todos los productos del camino y crece con su cuadrado.</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Tren</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Engranes</translation>
    </message>
    <message>
        <source>Inverse and product</source>
        <translation>Inversa y producto</translation>
    </message>
    <message>
        <source>Substitution</source>
        <translation>Sustitución</translation>
    </message>
    <message>
        <source>Multiplications and additions from the equations to the solution</source>
        <translation>Multiplicaciones y sumas de las ecuaciones a la solución</translation>
    </message>
    <message>
        <source>moving links</source>
        <translation>eslabones móviles</translation>
    </message>
    <message>
        <source>What the paper concludes</source>
        <translation>Lo que concluye el artículo</translation>
    </message>
    <message>
        <source>For it: %1</source>
        <translation>A favor: %1</translation>
    </message>
    <message>
        <source>Against it: %1</source>
        <translation>En contra: %1</translation>
    </message>
    <message>
        <source>The mechanism</source>
        <translation>El mecanismo</translation>
    </message>
    <message>
        <source>It has %1, %2 and %3, $k = t + c = %4$ joints in all. The ground is link 0; the other links, the turning joints and the meshes are numbered on from there.</source>
        <translation>Tiene %1, %2 y %3, $k = t + c = %4$ pares en total. El bastidor es el eslabón 0; los demás eslabones, los pares de revolución y los engranes se numeran a partir de él.</translation>
    </message>
    <message>
        <source>$%1$ moving link ($n = %1$)</source>
        <translation>$%1$ eslabón móvil ($n = %1$)</translation>
    </message>
    <message>
        <source>$%1$ moving links ($n = %1$)</source>
        <translation>$%1$ eslabones móviles ($n = %1$)</translation>
    </message>
    <message>
        <source>$%1$ turning joint ($t = %1$)</source>
        <translation>$%1$ par de revolución ($t = %1$)</translation>
    </message>
    <message>
        <source>$%1$ turning joints ($t = %1$)</source>
        <translation>$%1$ pares de revolución ($t = %1$)</translation>
    </message>
    <message>
        <source>$%1$ gear mesh ($c = %1$)</source>
        <translation>$%1$ engrane ($c = %1$)</translation>
    </message>
    <message>
        <source>$%1$ gear meshes ($c = %1$)</source>
        <translation>$%1$ engranes ($c = %1$)</translation>
    </message>
    <message>
        <source>Digraph and matrices</source>
        <translation>Dígrafo y matrices</translation>
    </message>
    <message>
        <source>Each link becomes a node, each turning joint a solid arrow from its tail to its head, each gear mesh a dashed one.</source>
        <translation>Cada eslabón pasa a ser un nodo, cada par de revolución una flecha continua de su cola a su cabeza, cada engrane una discontinua.</translation>
    </message>
    <message>
        <source>In the incidence matrix an edge&apos;s column holds $-1$ in the row of the link that it leaves and $1$ in the row of the link that it reaches.</source>
        <translation>En la matriz de incidencia la columna de una arista tiene $-1$ en la fila del eslabón del que sale y $1$ en la del eslabón al que llega.</translation>
    </message>
    <message>
        <source>Without the row of the ground its rows are independent: $G$ for the turning joints, $G^*$ for the meshes.</source>
        <translation>Sin la fila del bastidor sus filas son independientes: $G$ para los pares de revolución, $G^*$ para los engranes.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree of this digraph, so there is nothing more to derive: see the findings above.</source>
        <translation>Los pares de revolución no son un árbol generador de este dígrafo, así que no hay nada más que deducir: vea los avisos de arriba.</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree. The path matrix holds, for each link, the joints on its path to the ground: $1$ where the path follows the arrow, $-1$ where it runs against it.</source>
        <translation>Los pares de revolución son un árbol generador. La matriz de caminos contiene, para cada eslabón, los pares de su camino al bastidor: $1$ donde el camino sigue la flecha, $-1$ donde va contra ella.</translation>
    </message>
    <message>
        <source>Each mesh closes a fundamental cycle with the joints between its two links. They follow from both matrices.</source>
        <translation>Cada engrane cierra un ciclo fundamental con los pares entre sus dos eslabones. Los ciclos resultan de ambas matrices.</translation>
    </message>
    <message>
        <source>With the meshes themselves, each once, this is the cycle-basis matrix.</source>
        <translation>Con los engranes mismos, cada uno una vez, esta es la matriz de la base de ciclos.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>en</source>
        <translation>es</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Tornillos</translation>
    </message>
    <message>
        <source>The screw of joint $k$ about the pitch point of mesh $c$ is the unit vector along the joint&apos;s axis, $u_k$, with its moment about that point, $r_{c,k} = l_{c,k} \times u_k$, where $l_{c,k}$ leads from the pitch point to the axis:</source>
        <translation>El tornillo del par $k$ respecto al punto primitivo del engrane $c$ es el vector unitario a lo largo del eje del par, $u_k$, con su momento respecto a ese punto, $r_{c,k} = l_{c,k} \times u_k$, donde $l_{c,k}$ va del punto primitivo al eje:</translation>
    </message>
    <message>
        <source>For the joints of each cycle, lengths in %1:</source>
        <translation>Para los pares de cada ciclo, longitudes en %1:</translation>
    </message>
    <message>
        <source>Equations of the meshes</source>
        <translation>Ecuaciones de los engranes</translation>
    </message>
    <message>
        <source>They all point along one line: the normal of the plane that holds both axes of the mesh. One number of each is enough, its component $P_{c,t}$ along that normal, and each mesh gives one equation:</source>
        <translation>Todos apuntan a lo largo de una recta: la normal del plano que contiene ambos ejes del engrane. De cada uno basta un número, su componente $P_{c,t}$ según esa normal, y cada engrane da una ecuación:</translation>
    </message>
    <message>
        <source>With lengths in %1,</source>
        <translation>Con longitudes en %1,</translation>
    </message>
    <message>
        <source>The entries of a row are the radii of its two gears. Divided by the radius of the head&apos;s gear, the ratios are left:</source>
        <translation>Las entradas de una fila son los radios de sus dos ruedas. Divididas entre el radio de la rueda de la cabeza quedan las relaciones:</translation>
    </message>
    <message>
        <source>Engaged couplings</source>
        <translation>Acoplamientos activados</translation>
    </message>
    <message>
        <source>An engaged brake holds its link against the ground, an engaged clutch makes two links turn as one. The rates of the joints between them add up to zero, once for each direction of their axes: rows below those of the meshes, which stay as they are.</source>
        <translation>Un freno activado sujeta su eslabón al bastidor, un embrague activado hace girar dos eslabones como uno. Las velocidades de los pares entre ellos suman cero, una vez por cada dirección de sus ejes: filas debajo de las de los engranes, que quedan como están.</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Acoplamiento</translation>
    </message>
    <message>
        <source>Equation</source>
        <translation>Ecuación</translation>
    </message>
    <message>
        <source>The input is joint %1.</source>
        <translation>La entrada es el par %1.</translation>
    </message>
    <message>
        <source>The inputs are joints %1.</source>
        <translation>Las entradas son los pares %1.</translation>
    </message>
    <message>
        <source>The input is joint %1, chosen by the program because the document names none.</source>
        <translation>La entrada es el par %1, elegida por el programa porque el documento no nombra ninguna.</translation>
    </message>
    <message>
        <source>The inputs are joints %1, chosen by the program because the document names none.</source>
        <translation>Las entradas son los pares %1, elegidos por el programa porque el documento no nombra ninguno.</translation>
    </message>
    <message>
        <source>Freedom and inputs</source>
        <translation>Grados de libertad y entradas</translation>
    </message>
    <message>
        <source>The rank of $P$ with the rows of the couplings, in exact arithmetic, is $r = %1$. The mechanism therefore has</source>
        <translation>El rango de $P$ con las filas de los acoplamientos, en aritmética exacta, es $r = %1$. El mecanismo tiene por tanto</translation>
    </message>
    <message>
        <source>The rank of $P$, in exact arithmetic, is $r = %1$. The mechanism therefore has</source>
        <translation>El rango de $P$, en aritmética exacta, es $r = %1$. El mecanismo tiene por tanto</translation>
    </message>
    <message>
        <source>degrees of freedom. Kutzbach&apos;s count $n - c - h = %1$, with the $h$ rows of couplings, differs, because %2 of the equations follow from the others.</source>
        <translation>grados de libertad. El recuento de Kutzbach, $n - c - h = %1$ con las $h$ filas de los acoplamientos, difiere porque %2 de las ecuaciones resultan de las demás.</translation>
    </message>
    <message>
        <source>degrees of freedom. Kutzbach&apos;s count $n - c = %1$ differs, because the equations of %2 of the meshes follow from the others.</source>
        <translation>grados de libertad. El recuento de Kutzbach, $n - c = %1$, difiere porque las ecuaciones de %2 de los engranes resultan de las demás.</translation>
    </message>
    <message>
        <source>degrees of freedom: as many inputs have to be given.</source>
        <translation>grados de libertad: hay que dar otras tantas entradas.</translation>
    </message>
    <message>
        <source>Each direction is the $z$ axis, turned about $x$ by the offset angle $\varphi_k$:</source>
        <translation>Cada dirección es el eje $z$ girado alrededor de $x$ en el ángulo $\varphi_k$:</translation>
    </message>
    <message>
        <source>Each direction is the $z$ axis, turned by a rotation $D_{0,k}$:</source>
        <translation>Cada dirección es el eje $z$ girado mediante $D_{0,k}$:</translation>
    </message>
    <message>
        <source>The moment needs the way from the pitch point to a point of the axis:</source>
        <translation>Para el momento se necesita el vector del punto primitivo a un punto del eje:</translation>
    </message>
    <message>
        <source>The twist of a joint is its screw times its rate:</source>
        <translation>El torsor cinemático de un par es su tornillo por su velocidad:</translation>
    </message>
    <message>
        <source>Along each cycle the twists, with their signs in $C$, add up to zero:</source>
        <translation>A lo largo de cada ciclo los torsores, con sus signos en $C$, suman cero:</translation>
    </message>
    <message>
        <source>Their directions give the velocity of one gear of each mesh relative to the other. The mesh has no moment about its own pitch point, so the moments of the turning joints alone add up to zero:</source>
        <translation>Sus direcciones dan la velocidad de una rueda de cada engrane respecto a la otra. El engrane no tiene momento respecto a su propio punto primitivo, así que los momentos de los pares giratorios suman cero por sí solos:</translation>
    </message>
    <message>
        <source>With the inputs first, the equations are parted into columns of the inputs and of the outputs:</source>
        <translation>Con las entradas primero, las ecuaciones se dividen en columnas de las entradas y de las salidas:</translation>
    </message>
    <message>
        <source>and their solution is</source>
        <translation>y su solución es</translation>
    </message>
    <message>
        <source>With the inputs first, and in gear ratios, the equations are</source>
        <translation>Con las entradas primero, y en relaciones de engrane, las ecuaciones son</translation>
    </message>
    <message>
        <source>Solved for the outputs,</source>
        <translation>Resueltas para las salidas,</translation>
    </message>
    <message>
        <source>there is nothing that turns: without a freedom all rates are $0$.</source>
        <translation>no gira nada: sin libertad todas las velocidades son $0$.</translation>
    </message>
    <message>
        <source>With the teeth of this mechanism:</source>
        <translation>Con los dientes de este mecanismo:</translation>
    </message>
    <message>
        <source>Written out, some entries are too long to read. One joint after the other they are</source>
        <translation>Escritas por extenso, algunas entradas son demasiado largas para leerlas. Un par tras otro son</translation>
    </message>
    <message>
        <source>At these speeds of the inputs, in rad/s,</source>
        <translation>Con estas velocidades de las entradas, en rad/s,</translation>
    </message>
    <message>
        <source>the outputs turn at</source>
        <translation>las salidas giran a</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Advertencias</translation>
    </message>
    <message>
        <source>Worked out by the Matroid and the T-T graph method</source>
        <translation>Obtenido por los métodos del matroide y del grafo T-T</translation>
    </message>
    <message>
        <source>Both methods compared</source>
        <translation>Ambos métodos comparados</translation>
    </message>
    <message>
        <source>It has $%1 \times %2$ entries, too many to print: &quot;export --to csv --matrix %3&quot; writes them.</source>
        <translation>Tiene $%1 \times %2$ entradas, demasiadas para imprimirlas: «export --to csv --matrix %3» las escribe.</translation>
    </message>
    <message>
        <source>Statics</source>
        <translation>Estática</translation>
    </message>
    <message>
        <source>What holds the loads follows from the same matrices, read down their columns. A starred number belongs to the equation of the kinematics beside it. A torque $\tau_e$ acts in joint $e$, by its tail on its head, about the direction of its axis; $\ell_e$ is the power of the loads on links beyond the joint for its rate $1$; $F_c$ is the tangential force of mesh $c$, by the tail&apos;s gear on the head&apos;s.</source>
        <translation>Lo que sostiene las cargas resulta de las mismas matrices, leídas por columnas. Un número con estrella pertenece a la ecuación de la cinemática que está a su lado. Un momento $\tau_e$ actúa en el par $e$, de su cola sobre su cabeza, en torno a la dirección de su eje; $\ell_e$ es la potencia de las cargas sobre los eslabones más allá del par para su velocidad $1$; $F_c$ es la fuerza tangencial del engrane $c$, de la rueda de la cola sobre la de la cabeza.</translation>
    </message>
    <message>
        <source>Cutset equations</source>
        <translation>Ecuaciones de corte</translation>
    </message>
    <message>
        <source>Without joint $e$ the tree falls into two parts. The edges that lead from one to the other are its fundamental cutset. It crosses each cycle as often along the cycle as against it:</source>
        <translation>Sin el par $e$ el árbol se divide en dos partes. Las aristas que van de una a otra son su conjunto de corte fundamental. Cruza cada ciclo tantas veces a favor como en contra:</translation>
    </message>
    <message>
        <source>So the part beyond a joint is in equilibrium if the torque in the joint and the loads hold the forces of the meshes that cross the cutset. Their moments about the joint&apos;s axis are the entries of its column of $P$; forces along the line of centres or along an axis do no work and are in no equation:</source>
        <translation>Así, la parte más allá de un par está en equilibrio si el momento en el par y las cargas sostienen las fuerzas de los engranes que cruzan el conjunto de corte. Sus momentos respecto al eje del par son las entradas de su columna de $P$; las fuerzas según la línea de centros o según un eje no trabajan y no están en ninguna ecuación:</translation>
    </message>
    <message>
        <source>There are too many to print: &quot;export --to csv --matrix cutset-equations&quot; writes them.</source>
        <translation>Son demasiadas para imprimirlas: «export --to csv --matrix cutset-equations» las escribe.</translation>
    </message>
    <message>
        <source>An engaged coupling is a further edge of the graph, with its torque $T$.</source>
        <translation>Un acoplamiento activado es una arista más del grafo, con su momento $T$.</translation>
    </message>
    <message>
        <source>With lengths in %1, so that torques are in N %1, joint by joint,</source>
        <translation>Con longitudes en %1, de modo que los momentos están en N %1, par a par,</translation>
    </message>
    <message>
        <source>The transposed solution</source>
        <translation>La solución traspuesta</translation>
    </message>
    <message>
        <source>The torque in every balanced joint for one unit of torque in each loaded one: the solution of the speeds, transposed, with the opposite sign.</source>
        <translation>El momento en cada par equilibrante por una unidad de momento en cada par cargado: la solución de las velocidades, traspuesta y con el signo contrario.</translation>
    </message>
    <message>
        <source>A row for each joint and a column for each mesh: the lever of the mesh&apos;s force about the joint&apos;s axis. It is P transposed; a row times the forces is the torque in the joint and that of the loads beyond it.</source>
        <translation>Una fila por cada par y una columna por cada engrane: el brazo de la fuerza del engrane respecto al eje del par. Es P traspuesta; una fila por las fuerzas es el momento en el par y el de las cargas más allá de él.</translation>
    </message>
    <message>
        <source>The torques in the balanced joints, $\tau_E$, hold those in the others, $\tau_r$. With the columns of $P$ in the same order as for the speeds,</source>
        <translation>Los momentos en los pares equilibrados, $\tau_E$, sostienen los de los demás, $\tau_r$. Con las columnas de $P$ en el mismo orden que para las velocidades,</translation>
    </message>
    <message>
        <source>which in ratios is (25) transposed, with the opposite sign:</source>
        <translation>lo que en relaciones es (25) traspuesta, con el signo opuesto:</translation>
    </message>
    <message>
        <source>Torques under the loads</source>
        <translation>Momentos bajo las cargas</translation>
    </message>
    <message>
        <source>The loads of the document are held by these torques, in N m, in a train without losses:</source>
        <translation>Las cargas del documento las sostienen estos momentos, en N m, en un tren sin pérdidas:</translation>
    </message>
    <message>
        <source>The tangential forces of the meshes, in N, are</source>
        <translation>Las fuerzas tangenciales de los engranes, en N, son</translation>
    </message>
    <message>
        <source>The same by the T-T graph</source>
        <translation>Lo mismo con el grafo T-T</translation>
    </message>
    <message>
        <source>A mesh loses no power at its two ports, so the torques on its gears, seen from the carrier, are in the inverse ratio of their speeds:</source>
        <translation>Un engrane no pierde potencia en sus dos puertos, así que los momentos sobre sus ruedas, vistos desde el portasatélites, están en razón inversa de sus velocidades:</translation>
    </message>
    <message>
        <source>Each branch of the tree has a fundamental cutset, with the coefficients of the circuits that the branch belongs to:</source>
        <translation>Cada rama del árbol tiene un conjunto de corte fundamental, con los coeficientes de los circuitos a los que pertenece la rama:</translation>
    </message>
    <message>
        <source>These cutsets as the rows of a matrix, the torques in the branches before the line, those of the chords after it; loads and engaged couplings come in addition:</source>
        <translation>Estos cortes como filas de una matriz, los momentos en las ramas antes de la línea, los de las cuerdas después; las cargas y los acoplamientos activados se añaden:</translation>
    </message>
    <message>
        <source>The Matroid method&apos;s $Q$ has the same rows. A mesh is one edge there and has a chord to each gear here, so its column of $Q$ is that of the chord of the head&apos;s gear less that of the tail&apos;s:</source>
        <translation>La $Q$ del método del matroide tiene las mismas filas. Un engrane es allí una arista y tiene aquí una cuerda a cada rueda, así que su columna de $Q$ es la de la cuerda de la rueda de la cabeza menos la de la cola:</translation>
    </message>
    <message>
        <source>The chain runs from the loads back to the motors: a cutset with one unknown left gives it, the terminal equation of its mesh the other torque.</source>
        <translation>La cadena va de las cargas de vuelta a los motores: un corte con una sola incógnita la da, y la ecuación terminal de su engrane el otro momento.</translation>
    </message>
    <message>
        <source>Torque by torque, both methods give the same fractions: all %1 entries agree.</source>
        <translation>Momento a momento, ambos métodos dan las mismas fracciones: coinciden las %1 entradas.</translation>
    </message>
    <message>
        <source>The two methods differ by up to %1 N m.</source>
        <translation>Los dos métodos difieren hasta en %1 N m.</translation>
    </message>
    <message>
        <source>In symbols, too: eliminated in the gear ratios, the cutsets of the T-T graph give the torque matrix of (25) transposed, entry by entry.</source>
        <translation>También en símbolos: eliminados en las relaciones de engrane, los cortes del grafo T-T dan, entrada a entrada, la matriz de momentos de (25) traspuesta.</translation>
    </message>
    <message>
        <source>In symbols the two torque matrices differ.</source>
        <translation>En símbolos las dos matrices de momentos difieren.</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveles</translation>
    </message>
    <message>
        <source>The turning joints are the branches of the graph&apos;s tree. Each carries the letter of its axis, its level.</source>
        <translation>Los pares de revolución son las ramas del árbol del grafo. Cada una lleva la letra de su eje, su nivel.</translation>
    </message>
    <message>
        <source>Carriers</source>
        <translation>Portasatélites</translation>
    </message>
    <message>
        <source>From one gear of a mesh through the branches to the other, the level changes at one link: the transfer vertex, which carries both gears. A mesh is written as its gear pair and its carrier.</source>
        <translation>De una rueda de un engrane a la otra, por las ramas, el nivel cambia en un eslabón: el vértice de transferencia, que lleva ambas ruedas. Un engrane se escribe como su pareja de ruedas y su portasatélites.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Engrane</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Camino</translation>
    </message>
    <message>
        <source>Pair and carrier</source>
        <translation>Pareja y portasatélites</translation>
    </message>
    <message>
        <source>no transfer vertex</source>
        <translation>sin vértice de transferencia</translation>
    </message>
    <message>
        <source>Terminal equations</source>
        <translation>Ecuaciones terminales</translation>
    </message>
    <message>
        <source>Seen from its carrier, one gear of a pair turns as fast as the other times the ratio of their teeth, with a plus sign where both turn the same way, each seen along its own axis:</source>
        <translation>Vista desde su portasatélites, una rueda de la pareja gira tan rápido como la otra por la relación de sus dientes, con signo más donde ambas giran en el mismo sentido, cada una vista según su propio eje:</translation>
    </message>
    <message>
        <source>Fundamental circuits</source>
        <translation>Circuitos fundamentales</translation>
    </message>
    <message>
        <source>Each of these velocities closes a circuit with branches of the tree, and is the sum along the branches:</source>
        <translation>Cada una de estas velocidades cierra un circuito con ramas del árbol, y es la suma a lo largo de las ramas:</translation>
    </message>
    <message>
        <source>An engaged brake or clutch is one more edge of the graph, from the link that it holds to the ground or to the other link. Its velocity is zero, so the branches of its fundamental circuit add up to zero, once for each direction of their axes:</source>
        <translation>Un freno o embrague activado es una arista más del grafo, del eslabón que sujeta al bastidor o al otro eslabón. Su velocidad es cero, así que las ramas de su circuito fundamental suman cero, una vez por cada dirección de sus ejes:</translation>
    </message>
    <message>
        <source>Solution by substitution</source>
        <translation>Solución por sustitución</translation>
    </message>
    <message>
        <source>Given is %1.</source>
        <translation>Se da %1.</translation>
    </message>
    <message>
        <source>Given are %1.</source>
        <translation>Se dan %1.</translation>
    </message>
    <message>
        <source>Mesh by mesh, the equations give the others.</source>
        <translation>Engrane a engrane, las ecuaciones dan las demás.</translation>
    </message>
    <message>
        <source>One after the other, the equations give the others.</source>
        <translation>Una tras otra, las ecuaciones dan las demás.</translation>
    </message>
    <message>
        <source>Equation %1 gives %2:</source>
        <translation>La ecuación %1 da %2:</translation>
    </message>
    <message>
        <source>Equations %1 give %2:</source>
        <translation>Las ecuaciones %1 dan %2:</translation>
    </message>
    <message>
        <source>The equations of several meshes and couplings, solved together, give %1:</source>
        <translation>Las ecuaciones de varios engranes y acoplamientos, resueltas a la vez, dan %1:</translation>
    </message>
    <message>
        <source>The equations of several meshes, solved together, give %1:</source>
        <translation>Las ecuaciones de varios engranes, resueltas a la vez, dan %1:</translation>
    </message>
    <message>
        <source>Together:</source>
        <translation>En conjunto:</translation>
    </message>
    <message>
        <source>With the names of the ratios that the matroid method uses,</source>
        <translation>Con los nombres de las relaciones que usa el método del matroide,</translation>
    </message>
    <message>
        <source>this is</source>
        <translation>esto es</translation>
    </message>
    <message>
        <source>a mechanism without errors, and at most 250,000 entries</source>
        <translation>un mecanismo sin errores y 250.000 entradas como máximo</translation>
    </message>
    <message>
        <source>a carrier and a sign of every mesh</source>
        <translation>un portasatélites y un signo de cada engrane</translation>
    </message>
    <message>
        <source>a geometry of every mesh</source>
        <translation>la geometría de cada engrane</translation>
    </message>
    <message>
        <source>balances in joints that hold all loads, and at most 250,000 entries</source>
        <translation>equilibrantes en pares que sostengan todas las cargas, y como mucho 250.000 entradas</translation>
    </message>
    <message>
        <source>loads, and balances that hold them</source>
        <translation>cargas, y equilibrantes que las sostengan</translation>
    </message>
    <message>
        <source>states of a gearbox</source>
        <translation>estados de una caja</translation>
    </message>
    <message>
        <source>a spanning tree</source>
        <translation>un árbol generador</translation>
    </message>
    <message>
        <source>The handout has no still picture: %1</source>
        <translation>El folleto no tiene imagen fija: %1</translation>
    </message>
    <message>
        <source>About %1 triangles are more than the limit of %2</source>
        <translation>Unos %1 triángulos son más que el límite de %2</translation>
    </message>
    <message>
        <source>The file shows the first %1 s of it, at its speed; it does not end where it began.</source>
        <translation>El archivo muestra los primeros %1 s, a su velocidad; no termina donde empezó.</translation>
    </message>
    <message>
        <source>The motion in the file goes there and back within the limits of joints: %1.</source>
        <translation>El movimiento del archivo va y vuelve dentro de los límites de los pares: %1.</translation>
    </message>
    <message>
        <source>Nothing in the file moves.</source>
        <translation>Nada se mueve en el archivo.</translation>
    </message>
    <message>
        <source>A mechanism with errors has no gears</source>
        <translation>Un mecanismo con errores no tiene ruedas</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot; with solids</source>
        <translation>No hay ningún eslabón «%1» con sólidos</translation>
    </message>
    <message>
        <source>There is no gear &quot;%1&quot;; gears are named like 15:tail, 15:head</source>
        <translation>No hay ninguna rueda «%1»; las ruedas se llaman como 15:tail, 15:head</translation>
    </message>
    <message>
        <source>the assembly</source>
        <translation>el montaje</translation>
    </message>
    <message>
        <source>(pinned)</source>
        <translation>(fijado)</translation>
    </message>
    <message>
        <source>One of %1 equal planets is drawn: %2 is like %3.</source>
        <translation>Se dibuja uno de %1 satélites iguales: %2 es como %3.</translation>
    </message>
    <message>
        <source>One of %1 equal planets is drawn: %2 are like %3.</source>
        <translation>Se dibuja uno de %1 satélites iguales: %2 son como %3.</translation>
    </message>
    <message>
        <source>One of %1 equal sets of planets is drawn: %2 is like %3.</source>
        <translation>Se dibuja uno de %1 grupos iguales de satélites: %2 es como %3.</translation>
    </message>
    <message>
        <source>One of %1 equal sets of planets is drawn: %2 are like %3.</source>
        <translation>Se dibuja uno de %1 grupos iguales de satélites: %2 son como %3.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. Radii are not to scale.</source>
        <translation>Desarrollado: los ejes no están en un plano. Los radios no están a escala.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 is turned into the sheet.</source>
        <translation>Desarrollado: los ejes no están en un plano. %1 se ha girado al plano del dibujo.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 are turned into the sheet.</source>
        <translation>Desarrollado: los ejes no están en un plano. %1 se han girado al plano del dibujo.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 of them are turned into the sheet.</source>
        <translation>Desarrollado: los ejes no están en un plano. %1 de ellos se han girado al plano del dibujo.</translation>
    </message>
    <message>
        <source>Wheels that a dashed line joins mesh, though they do not touch here.</source>
        <translation>Las ruedas que une una línea discontinua engranan, aunque aquí no se toquen.</translation>
    </message>
    <message>
        <source>Link %1 is not drawn: no turning joint ties it to the ground.</source>
        <translation>El eslabón %1 no se dibuja: ningún par de revolución lo une al bastidor.</translation>
    </message>
    <message>
        <source>Links %1 are not drawn: no turning joint ties them to the ground.</source>
        <translation>Los eslabones %1 no se dibujan: ningún par de revolución los une al bastidor.</translation>
    </message>
    <message>
        <source>Joint %1 closes a loop and is not drawn.</source>
        <translation>El par %1 cierra un lazo y no se dibuja.</translation>
    </message>
    <message>
        <source>Joints %1 close a loop and are not drawn.</source>
        <translation>Los pares %1 cierran un lazo y no se dibujan.</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 punto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>%1, variant %2</source>
        <translation>%1, variante %2</translation>
    </message>
    <message>
        <source>%1: solution</source>
        <translation>%1: solución</translation>
    </message>
    <message>
        <source>Name: %1</source>
        <translation>Nombre: %1</translation>
    </message>
    <message>
        <source>%1 question</source>
        <translation>%1 pregunta</translation>
    </message>
    <message>
        <source>%1 questions</source>
        <translation>%1 preguntas</translation>
    </message>
    <message>
        <source>Brake or clutch</source>
        <translation>Freno o embrague</translation>
    </message>
    <message>
        <source>Engaged, it holds</source>
        <translation>Activado, sujeta</translation>
    </message>
    <message>
        <source>link %1 against the ground</source>
        <translation>el eslabón %1 al bastidor</translation>
    </message>
    <message>
        <source>links %1 together</source>
        <translation>los eslabones %1 entre sí</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Respuesta</translation>
    </message>
    <message>
        <source>Angular speed</source>
        <translation>Velocidad angular</translation>
    </message>
    <message>
        <source>Traced points</source>
        <translation>Puntos trazados</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>bastidor</translation>
    </message>
    <message>
        <source>point %1 of %2</source>
        <translation>punto %1 de %2</translation>
    </message>
    <message>
        <source>link %1: %2</source>
        <translation>eslabón %1: %2</translation>
    </message>
    <message>
        <source>Shared by equal stiffness of all teeth: an assumption.</source>
        <translation>Repartido por igual rigidez de todos los dientes: una hipótesis.</translation>
    </message>
    <message>
        <source>Loads: %1.</source>
        <translation>Cargas: %1.</translation>
    </message>
    <message>
        <source>joint %1 at %2°</source>
        <translation>par %1 a %2°</translation>
    </message>
    <message>
        <source>It is not in the folder of the document: copy it there.</source>
        <translation>No está en la carpeta del documento: cópielo allí.</translation>
    </message>
    <message>
        <source>The memory does not suffice for the pictures.</source>
        <translation>No hay memoria suficiente para las imágenes.</translation>
    </message>
    <message>
        <source>The driver painted nothing.</source>
        <translation>El controlador no pintó nada.</translation>
    </message>
    <message>
        <source>The memory does not suffice for the labels.</source>
        <translation>No hay memoria suficiente para los rótulos.</translation>
    </message>
    <message>
        <source>The file could not be written.</source>
        <translation>No se pudo escribir el archivo.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written.</source>
        <translation>No se pudo escribir «%1».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder.</source>
        <translation>«%1» no es una carpeta.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; is not empty; nothing was written.</source>
        <translation>La carpeta «%1» no está vacía; no se escribió nada.</translation>
    </message>
    <message>
        <source>No folder could be made beside &quot;%1&quot;.</source>
        <translation>No se pudo crear una carpeta junto a «%1».</translation>
    </message>
    <message>
        <source>The driver paints pictures of up to %1 pixels a side; choose a smaller size.</source>
        <translation>El controlador pinta imágenes de hasta %1 píxeles de lado; elija un tamaño menor.</translation>
    </message>
    <message>
        <source>Gear %1 has %2 teeth, too fine to be distinguished: it is shown without them.</source>
        <translation>La rueda %1 tiene %2 dientes, demasiado finos para distinguirlos: se muestra sin ellos.</translation>
    </message>
    <message>
        <source>Link %1 wears &quot;%2&quot;, which is not shown: %3</source>
        <translation>El eslabón %1 lleva «%2», que no se muestra: %3</translation>
    </message>
    <message>
        <source>A train of %1 gears: its wheels are plain discs, its shafts and arms are straight and pass through what they meet (up to %2 gears they are routed past it).</source>
        <translation>Un tren de %1 ruedas: sus ruedas son discos lisos, sus ejes y brazos son rectos y atraviesan lo que encuentran (hasta %2 ruedas se conducen alrededor).</translation>
    </message>
    <message>
        <source>gears in a row</source>
        <translation>ruedas en fila</translation>
    </message>
    <message>
        <source>planetary sets in line</source>
        <translation>trenes epicicloidales en serie</translation>
    </message>
    <message>
        <source>arms of a bevel-gear wrist</source>
        <translation>brazos de una muñeca de ruedas cónicas</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 equation</source>
        <translation>%1 ecuación</translation>
    </message>
    <message>
        <source>%1 equations</source>
        <translation>%1 ecuaciones</translation>
    </message>
    <message>
        <source>%1 unknown</source>
        <translation>%1 incógnita</translation>
    </message>
    <message>
        <source>%1 unknowns</source>
        <translation>%1 incógnitas</translation>
    </message>
    <message>
        <source>%1 product</source>
        <translation>%1 producto</translation>
    </message>
    <message>
        <source>%1 products</source>
        <translation>%1 productos</translation>
    </message>
    <message>
        <source>%1 sum</source>
        <translation>%1 suma</translation>
    </message>
    <message>
        <source>%1 sums</source>
        <translation>%1 sumas</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Grafo</translation>
    </message>
    <message>
        <source>digraph: a node for each link, an oriented line for each joint and mesh (Figs. 2, 3)</source>
        <translation>dígrafo: un nodo por eslabón, una línea orientada por par y por engrane (Figs. 2, 3)</translation>
    </message>
    <message>
        <source>oriented graph: the same nodes and branches, and for each mesh two chords to its carrier (Figs. 4 to 6)</source>
        <translation>grafo orientado: los mismos nodos y ramas, y por cada engrane dos cuerdas a su portasatélites (Figs. 4 a 6)</translation>
    </message>
    <message>
        <source>The turning joints are the tree in both, the meshes close its cycles.</source>
        <translation>Los pares de revolución son el árbol en ambos, los engranes cierran sus ciclos.</translation>
    </message>
    <message>
        <source>Tree and cycles</source>
        <translation>Árbol y ciclos</translation>
    </message>
    <message>
        <source>incidence matrix (1), (2), path matrix $Z$ (3), spanning tree (4), $C$ (5)</source>
        <translation>matriz de incidencia (1), (2), matriz de caminos $Z$ (3), árbol generador (4), $C$ (5)</translation>
    </message>
    <message>
        <source>levels of the branches; f-circuits of the chords (31)-(38)</source>
        <translation>niveles de las ramas; f-circuitos de las cuerdas (31)-(38)</translation>
    </message>
    <message>
        <source>The cycle of a mesh is the circuit of its tail&apos;s chord less that of its head&apos;s chord.</source>
        <translation>El ciclo de un engrane es el circuito de su cuerda de la cola menos el de su cuerda de la cabeza.</translation>
    </message>
    <message>
        <source>Carrier</source>
        <translation>Portasatélites</translation>
    </message>
    <message>
        <source>not named: it drops out of the moments about the pitch point</source>
        <translation>sin nombre: desaparece de los momentos respecto al punto primitivo</translation>
    </message>
    <message>
        <source>transfer vertex: where the level changes on the walk between the gears</source>
        <translation>vértice de transferencia: donde cambia el nivel en el camino entre las ruedas</translation>
    </message>
    <message>
        <source>The moments of a cycle&apos;s joints lie on one line because the carrier holds both axes.</source>
        <translation>Los momentos de los pares de un ciclo están en una recta porque el portasatélites sostiene ambos ejes.</translation>
    </message>
    <message>
        <source>screws about the pitch point (6)-(13), one row of $P$ (16)-(19): $i_c$ on the tail&apos;s axis, $\pm 1$ on the head&apos;s</source>
        <translation>tornillos respecto al punto primitivo (6)-(13), una fila de $P$ (16)-(19): $i_c$ en el eje de la cola, $\pm 1$ en el de la cabeza</translation>
    </message>
    <message>
        <source>terminal equation (26)-(30): speeds seen from the carrier, a ratio and a sign</source>
        <translation>ecuación terminal (26)-(30): velocidades vistas desde el portasatélites, una relación y un signo</translation>
    </message>
    <message>
        <source>The terminal equation with its two circuits put in is the row of $P$.</source>
        <translation>La ecuación terminal con sus dos circuitos sustituidos es la fila de $P$.</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signo</translation>
    </message>
    <message>
        <source>comes with the diameters in the reference frame</source>
        <translation>viene con los diámetros en el sistema de referencia</translation>
    </message>
    <message>
        <source>from the turning senses of the two gears, seen along their axes</source>
        <translation>de los sentidos de giro de las dos ruedas, vistos según sus ejes</translation>
    </message>
    <message>
        <source>The signs agree: both are that of the product of the two moments.</source>
        <translation>Los signos coinciden: ambos son el del producto de los dos momentos.</translation>
    </message>
    <message>
        <source>rank of $P$, $E = t - r$ (21); bases of the dual matroid are the valid inputs</source>
        <translation>rango de $P$, $E = t - r$ (21); las bases del matroide dual son las entradas válidas</translation>
    </message>
    <message>
        <source>not asked: the inputs are taken as given</source>
        <translation>no se pregunta: las entradas se toman como dadas</translation>
    </message>
    <message>
        <source>What can be driven is read from $P$.</source>
        <translation>Lo que se puede accionar se lee en $P$.</translation>
    </message>
    <message>
        <source>$-P_r^{-1} P_E$ (22)-(25)</source>
        <translation>$-P_r^{-1} P_E$ (22)-(25)</translation>
    </message>
    <message>
        <source>one mesh after the other, substituted (39)-(42), then (43)-(45)</source>
        <translation>un engrane tras otro, sustituidos (39)-(42), después (43)-(45)</translation>
    </message>
    <message>
        <source>The same matrix, by joint.</source>
        <translation>La misma matriz, por pares.</translation>
    </message>
    <message>
        <source>Relative velocities</source>
        <translation>Velocidades relativas</translation>
    </message>
    <message>
        <source>of the two gears of a mesh to each other (15), after the solution</source>
        <translation>de las dos ruedas de un engrane entre sí (15), tras la solución</translation>
    </message>
    <message>
        <source>of each gear to its carrier: the chords, on the way to the solution</source>
        <translation>de cada rueda respecto a su portasatélites: las cuerdas, de camino a la solución</translation>
    </message>
    <message>
        <source>(15) is the difference of the two chords, as vectors.</source>
        <translation>(15) es la diferencia de las dos cuerdas, como vectores.</translation>
    </message>
    <message>
        <source>columns of $P$ (not in the paper)</source>
        <translation>columnas de $P$ (no está en el artículo)</translation>
    </message>
    <message>
        <source>complementary terminal variables and f-cutsets (not worked out in the paper)</source>
        <translation>variables terminales complementarias y f-cortes (no desarrollado en el artículo)</translation>
    </message>
    <message>
        <source>The cutset matrix $Q$ serves both.</source>
        <translation>La matriz de cortes $Q$ sirve a ambos.</translation>
    </message>
    <message>
        <source>&quot;The kinematic equations can be obtained more easily by the T-T graph method.&quot;</source>
        <translation>«Las ecuaciones cinemáticas se obtienen más fácilmente con el método del grafo T-T.»</translation>
    </message>
    <message>
        <source>From its equations to the solution of this mechanism the chain of substitutions takes %1, the inverse of $P_r$ and its product %2.</source>
        <translation>De sus ecuaciones a la solución de este mecanismo la cadena de sustituciones requiere %1, la inversa de $P_r$ y su producto %2.</translation>
    </message>
    <message>
        <source>It needs teeth and turning senses; the rows of $P$ need coordinates of axes and pitch points, and %1 from them.</source>
        <translation>Necesita dientes y sentidos de giro; las filas de $P$ necesitan coordenadas de ejes y puntos primitivos, y de ellas %1.</translation>
    </message>
    <message>
        <source>It writes %1 in %2, the Matroid method %3 in %4.</source>
        <translation>Escribe %1 con %2, el método del matroide %3 con %4.</translation>
    </message>
    <message>
        <source>Once a row of $P$ is divided by a radius it is the terminal equation with its circuits put in: solved in the same order, both take the same steps.</source>
        <translation>Dividida entre un radio, una fila de $P$ es la ecuación terminal con sus circuitos sustituidos: resueltas en el mismo orden, ambas dan los mismos pasos.</translation>
    </message>
    <message>
        <source>&quot;The only advantage of the Matroid method is the derivation of the relative velocities of the gears with respect to the carrier arm.&quot;</source>
        <translation>«La única ventaja del método del matroide es la deducción de las velocidades relativas de las ruedas respecto al brazo portasatélites.»</translation>
    </message>
    <message>
        <source>(15) gives them as vectors, for skew and meeting axes alike.</source>
        <translation>(15) las da como vectores, tanto para ejes que se cruzan como que se cortan.</translation>
    </message>
    <message>
        <source>The chords of the T-T graph are velocities relative to the carrier, too.</source>
        <translation>Las cuerdas del grafo T-T son también velocidades relativas al portasatélites.</translation>
    </message>
    <message>
        <source>The rank of $P$ gives the degrees of freedom, redundant meshes and every valid set of inputs; the T-T graph takes the inputs as given.</source>
        <translation>El rango de $P$ da los grados de libertad, los engranes redundantes y todo conjunto válido de entradas; el grafo T-T toma las entradas como dadas.</translation>
    </message>
    <message>
        <source>&quot;The sign of the gear ratio is obtained directly, without considering the turning direction.&quot;</source>
        <translation>«El signo de la relación de engrane se obtiene directamente, sin considerar el sentido de giro.»</translation>
    </message>
    <message>
        <source>The sign of each entry of $P$ is that of a difference of coordinates.</source>
        <translation>El signo de cada entrada de $P$ es el de una diferencia de coordenadas.</translation>
    </message>
    <message>
        <source>The senses have to be seen once a mesh: here %1 of %2 turn against each other, seen along their axes.</source>
        <translation>Los sentidos hay que verlos una vez por engrane: aquí %1 de %2 giran en sentidos opuestos, vistas según sus ejes.</translation>
    </message>
    <message>
        <source>%1 pair</source>
        <translation>%1 pareja</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 parejas</translation>
    </message>
    <message>
        <source>Mesh %1</source>
        <translation>Engrane %1</translation>
    </message>
    <message>
        <source>%1 points to link %2: its arrow ends there.</source>
        <translation>%1 apunta al eslabón %2: su flecha termina ahí.</translation>
    </message>
    <message>
        <source>%1 leaves link %2: its arrow begins there.</source>
        <translation>%1 sale del eslabón %2: su flecha empieza ahí.</translation>
    </message>
    <message>
        <source>%1 goes from link %2 to link %3 and does not touch link %4.</source>
        <translation>%1 va del eslabón %2 al eslabón %3 y no toca el eslabón %4.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground does not use %2.</source>
        <translation>El camino del eslabón %1 al bastidor no usa: %2.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground runs along %2 (from %3 to %4).</source>
        <translation>El camino del eslabón %1 al bastidor va a favor de: %2 (de %3 a %4).</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground runs against %2 (from %3 to %4).</source>
        <translation>El camino del eslabón %1 al bastidor va en contra de: %2 (de %3 a %4).</translation>
    </message>
    <message>
        <source>%1 is the cycle that %2 closes, walked along its arrow (from %3 to %4).</source>
        <translation>%1 es el ciclo que cierra: %2, recorrido según su flecha (de %3 a %4).</translation>
    </message>
    <message>
        <source>A cycle of the basis holds one mesh, its own: %1 holds %2, not %3.</source>
        <translation>Un ciclo de la base contiene un engrane, el suyo: %1 contiene %2, no %3.</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 does not use %5.</source>
        <translation>Al recorrer %1 según %2, el camino de %3 de vuelta a %4 no usa: %5.</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 runs along %5 (from %6 to %7).</source>
        <translation>Al recorrer %1 según %2, el camino de %3 de vuelta a %4 va a favor de: %5 (de %6 a %7).</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 runs against %5 (from %6 to %7).</source>
        <translation>Al recorrer %1 según %2, el camino de %3 de vuelta a %4 va en contra de: %5 (de %6 a %7).</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; its own arrow counts as 1.</source>
        <translation>Sin %1 el árbol se divide en dos mitades; su propia flecha cuenta como 1.</translation>
    </message>
    <message>
        <source>A cutset holds one turning joint, its own: %1, not %2.</source>
        <translation>Un conjunto de corte contiene un par de revolución, el suyo: %1, no %2.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 stays in one of them.</source>
        <translation>Sin %1 el árbol se divide en dos mitades; %2 queda en una de ellas.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 crosses over in the direction of %1.</source>
        <translation>Sin %1 el árbol se divide en dos mitades; %2 cruza en el sentido de %1.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 crosses over against %1.</source>
        <translation>Sin %1 el árbol se divide en dos mitades; %2 cruza en contra de %1.</translation>
    </message>
    <message>
        <source>Cutset of %1, %2</source>
        <translation>Conjunto de corte de %1, %2</translation>
    </message>
    <message>
        <source>%1, link %2</source>
        <translation>%1, eslabón %2</translation>
    </message>
    <message>
        <source>Not in the paper.</source>
        <translation>No está en el artículo.</translation>
    </message>
    <message>
        <source>The row divided by the radius of the head&apos;s gear: %1 turns about the axis of the tail&apos;s gear, which leaves the ratio i%2 = %3.</source>
        <translation>La fila dividida entre el radio de la rueda de la cabeza: %1 gira en torno al eje de la rueda de la cola, lo que deja la relación i%2 = %3.</translation>
    </message>
    <message>
        <source>The row divided by the radius of the head&apos;s gear: %1 turns about the axis of the head&apos;s gear, which leaves 1.</source>
        <translation>La fila dividida entre el radio de la rueda de la cabeza: %1 gira en torno al eje de la rueda de la cabeza, lo que deja 1.</translation>
    </message>
    <message>
        <source>T times the moment of %1&apos;s axis about the pitch point of mesh %2, along the normal of the mesh: the radius of the tail&apos;s gear.</source>
        <translation>T por el momento del eje de %1 respecto al punto primitivo del engrane %2, según la normal del engrane: el radio de la rueda de la cola.</translation>
    </message>
    <message>
        <source>T times the moment of %1&apos;s axis about the pitch point of mesh %2, along the normal of the mesh: the radius of the head&apos;s gear.</source>
        <translation>T por el momento del eje de %1 respecto al punto primitivo del engrane %2, según la normal del engrane: el radio de la rueda de la cabeza.</translation>
    </message>
    <message>
        <source>%1 does not use %2, so it has no part in the equation of mesh %3.</source>
        <translation>%1 no usa %2, así que no interviene en la ecuación del engrane %3.</translation>
    </message>
    <message>
        <source>f-circuit matrix of the T–T graph</source>
        <translation>Matriz de circuitos f del grafo T–T</translation>
    </message>
    <message>
        <source>A row for each f-circuit of the T–T graph: 1 for its own chord; a branch that counts with plus in the chord&apos;s velocity is −1, one that counts with minus is 1. Engaged couplings are chords, too. B ω = 0 holds for every motion.</source>
        <translation>Una fila por cada circuito f del grafo T–T: 1 para su propia cuerda; una rama que cuenta con más en la velocidad de la cuerda es −1, una que cuenta con menos es 1. Los acoplamientos activados también son cuerdas. B ω = 0 vale para todo movimiento.</translation>
    </message>
    <message>
        <source>f-cutset matrix of the T–T graph</source>
        <translation>Matriz de cortes f del grafo T–T</translation>
    </message>
    <message>
        <source>A row for each branch of the T–T graph: 1 for its own torque, and the chords that cross the cut, with minus their entries in the f-circuits. Its rows are the equations of the T–T graph&apos;s statics, and B Q′ᵀ = 0.</source>
        <translation>Una fila por cada rama del grafo T–T: 1 para su propio par, y las cuerdas que cruzan el corte, con menos sus entradas en los circuitos f. Sus filas son las ecuaciones de la estática del grafo T–T, y B Q′ᵀ = 0.</translation>
    </message>
    <message>
        <source>T-T circuit matrix</source>
        <translation>matriz de circuitos T-T</translation>
    </message>
    <message>
        <source>T-T cutset matrix</source>
        <translation>matriz de cortes T-T</translation>
    </message>
    <message>
        <source>The %1 component of the unit vector u along the axis of %2. Eqs. (7)-(9)</source>
        <translation>La componente %1 del vector unitario u según el eje de %2. Ecs. (7)-(9)</translation>
    </message>
    <message>
        <source>The %1 component of the moment of %2&apos;s axis about the pitch point of %3: how fast that point moves for one unit of speed. Eqs. (10)-(12)</source>
        <translation>La componente %1 del momento del eje de %2 respecto al punto primitivo de %3: a qué velocidad se mueve ese punto para velocidad uno. Ecs. (10)-(12)</translation>
    </message>
    <message>
        <source>Joint %1 over joint %2: %3</source>
        <translation>Par %1 entre par %2: %3</translation>
    </message>
    <message>
        <source>Joint %1 does not feel input %2.</source>
        <translation>El par %1 no nota la entrada %2.</translation>
    </message>
    <message>
        <source>How fast joint %1 turns for one unit of speed at joint %2, the other inputs at rest.</source>
        <translation>A qué velocidad gira el par %1 para velocidad uno en el par %2, las demás entradas en reposo.</translation>
    </message>
    <message>
        <source>With these teeth: %1.</source>
        <translation>Con estos dientes: %1.</translation>
    </message>
    <message>
        <source>the chord of coupling %1</source>
        <translation>la cuerda del acoplamiento %1</translation>
    </message>
    <message>
        <source>the chord %1 from gear %2 to carrier %3</source>
        <translation>la cuerda %1 de la rueda %2 al portador %3</translation>
    </message>
    <message>
        <source>f-circuit of %1, %2: %3</source>
        <translation>circuito f de %1, %2: %3</translation>
    </message>
    <message>
        <source>Eqs. (31) to (38)</source>
        <translation>Ecs. (31) a (38)</translation>
    </message>
    <message>
        <source>The f-circuit that %1 closes: the chord itself counts as 1.</source>
        <translation>El circuito f que cierra %1: la cuerda misma cuenta como 1.</translation>
    </message>
    <message>
        <source>An f-circuit holds one chord, its own: here %1.</source>
        <translation>Un circuito f contiene una cuerda, la suya: aquí %1.</translation>
    </message>
    <message>
        <source>%1 is not between the ends of %2.</source>
        <translation>%1 no está entre los extremos de %2.</translation>
    </message>
    <message>
        <source>The velocity of %1 is a sum of branches, in which %2 counts with plus. On one side with the chord it is −1.</source>
        <translation>La velocidad de %1 es una suma de ramas, en la que %2 cuenta con más. Del mismo lado que la cuerda es −1.</translation>
    </message>
    <message>
        <source>The velocity of %1 is a sum of branches, in which %2 counts with minus. On one side with the chord it is 1.</source>
        <translation>La velocidad de %1 es una suma de ramas, en la que %2 cuenta con menos. Del mismo lado que la cuerda es 1.</translation>
    </message>
    <message>
        <source>f-cutset of joint %1, %2: %3</source>
        <translation>corte f del par %1, %2: %3</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; the torque in the joint itself counts as 1.</source>
        <translation>Sin %1 el árbol se parte en dos mitades; el par en la propia articulación cuenta como 1.</translation>
    </message>
    <message>
        <source>An f-cutset holds one branch, its own: %1, not %2.</source>
        <translation>Un corte f contiene una rama, la suya: %1, no %2.</translation>
    </message>
    <message>
        <source>Both ends of %1 are in the same half without %2: its torque is not in this equation.</source>
        <translation>Ambos extremos de %1 están en la misma mitad sin %2: su par no está en esta ecuación.</translation>
    </message>
    <message>
        <source>The torque of %1 acts across the cut, in the sense of %2: minus its entry in the f-circuit.</source>
        <translation>El par de %1 actúa a través del corte, en el sentido de %2: menos su entrada en el circuito f.</translation>
    </message>
    <message>
        <source>The torque of %1 acts across the cut, against the sense of %2: minus its entry in the f-circuit.</source>
        <translation>El par de %1 actúa a través del corte, contra el sentido de %2: menos su entrada en el circuito f.</translation>
    </message>
    <message>
        <source>The centre of mass in the reference pose, in the base frame.</source>
        <translation>El centro de masas en la posición de referencia, en el sistema base.</translation>
    </message>
    <message>
        <source>The moment of inertia about the centre of mass, about the direction of this axis of the base frame, in the reference pose.</source>
        <translation>El momento de inercia respecto al centro de masas, en torno a la dirección de este eje del sistema base, en la posición de referencia.</translation>
    </message>
    <message>
        <source>The link, by its number.</source>
        <translation>El eslabón, por su número.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>masa</translation>
    </message>
    <message>
        <source>The mass: of the link&apos;s solids at the density, or as it is stated.</source>
        <translation>La masa: de los sólidos del eslabón con la densidad, o como está indicada.</translation>
    </message>
    <message>
        <source>Where the mass comes from: the link&apos;s solids, or the document, which states it.</source>
        <translation>De dónde viene la masa: de los sólidos del eslabón, o del documento, que la indica.</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>The inertia that the link has at the motor of joint %1 while the other inputs stand still: for a link that turns about one axis its moment of inertia times the square of its ratio.</source>
        <translation>La inercia que tiene el eslabón en el motor del par %1 mientras las demás entradas están quietas: en un eslabón que gira en torno a un eje, su momento de inercia por el cuadrado de su relación.</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>suma</translation>
    </message>
    <message>
        <source>The joint of the input, by its number.</source>
        <translation>El par de la entrada, por su número.</translation>
    </message>
    <message>
        <source>The generalised inertia: the torque in the row&apos;s joint for each rad/s² of joint %1.</source>
        <translation>La inercia generalizada: el momento en el par de la fila por cada rad/s² del par %1.</translation>
    </message>
    <message>
        <source>What motors have to give at constant speeds, for Coriolis and centrifugal forces and for weight.</source>
        <translation>Lo que los motores tienen que dar a velocidades constantes, por fuerzas de Coriolis y centrífugas y por el peso.</translation>
    </message>
    <message>
        <source>load</source>
        <translation>carga</translation>
    </message>
    <message>
        <source>What the loads contribute, as a torque in the row&apos;s joint.</source>
        <translation>Lo que aportan las cargas, como momento en el par de la fila.</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>sostén</translation>
    </message>
    <message>
        <source>The torque of the motor that keeps the speeds constant: h less the load.</source>
        <translation>El momento del motor que mantiene constantes las velocidades: h menos la carga.</translation>
    </message>
    <message>
        <source>no solid: massless</source>
        <translation>sin sólido: sin masa</translation>
    </message>
    <message>
        <source>solids</source>
        <translation>sólidos</translation>
    </message>
    <message>
        <source>stated, spread as its solids</source>
        <translation>indicada, repartida como sus sólidos</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>indicada</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 2^64 - 1, in quotes.</source>
        <translation>La semilla es un número entero de 0 a 2^64 - 1, entre comillas.</translation>
    </message>
    <message>
        <source>The sheet was made by another version of the program, whose questions this one cannot make again.</source>
        <translation>La hoja se hizo con otra versión del programa, cuyas preguntas esta no puede volver a generar.</translation>
    </message>
    <message>
        <source>A sheet has 1 to 1,000 variants.</source>
        <translation>Una hoja tiene de 1 a 1000 variantes.</translation>
    </message>
    <message>
        <source>There is no kind of question &quot;%1&quot;.</source>
        <translation>No hay ningún tipo de pregunta «%1».</translation>
    </message>
    <message>
        <source>A sheet has 1 to 100 questions.</source>
        <translation>Una hoja tiene de 1 a 100 preguntas.</translation>
    </message>
    <message>
        <source>%1 = 0, shared in unknown parts</source>
        <translation>%1 = 0, repartido en partes desconocidas</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: no mesh crosses.</source>
        <translation>El par %1 separa el eslabón %2: ningún engrane cruza.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: mesh %3 crosses.</source>
        <translation>El par %1 separa el eslabón %2: cruza el engrane %3.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: meshes %3 cross.</source>
        <translation>El par %1 separa el eslabón %2: cruzan los engranes %3.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: no mesh crosses.</source>
        <translation>El par %1 separa los eslabones %2: ningún engrane cruza.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: mesh %3 crosses.</source>
        <translation>El par %1 separa los eslabones %2: cruza el engrane %3.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: meshes %3 cross.</source>
        <translation>El par %1 separa los eslabones %2: cruzan los engranes %3.</translation>
    </message>
    <message>
        <source>T(link %1)</source>
        <translation>T(eslabón %1)</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>cargas</translation>
    </message>
    <message>
        <source>Which gear drives in mesh %1 depends on how the load is shared.</source>
        <translation>Qué rueda acciona en el engrane %1 depende de cómo se reparte la carga.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from the ground, it bears no load.</source>
        <translation>Ninguna rueda acciona en el engrane %1: visto desde el bastidor, no lleva carga.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from carrier %2, it bears no load.</source>
        <translation>Ninguna rueda acciona en el engrane %1: visto desde el portasatélites %2, no lleva carga.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from the ground, it does not roll.</source>
        <translation>Ninguna rueda acciona en el engrane %1: visto desde el bastidor, no rueda.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from carrier %2, it does not roll.</source>
        <translation>Ninguna rueda acciona en el engrane %1: visto desde el portasatélites %2, no rueda.</translation>
    </message>
    <message>
        <source>Gear %1 drives gear %2 in mesh %3: seen from the ground, it turns against the teeth&apos;s torque on it and passes %4 W.</source>
        <translation>La rueda %1 acciona la rueda %2 en el engrane %3: vista desde el bastidor, gira contra el momento que los dientes ejercen sobre ella y transmite %4 W.</translation>
    </message>
    <message>
        <source>Gear %1 drives gear %2 in mesh %3: seen from carrier %5, it turns against the teeth&apos;s torque on it and passes %4 W.</source>
        <translation>La rueda %1 acciona la rueda %2 en el engrane %3: vista desde el portasatélites %5, gira contra el momento que los dientes ejercen sobre ella y transmite %4 W.</translation>
    </message>
    <message>
        <source>efficiency of every mesh</source>
        <translation>rendimiento de cada engrane</translation>
    </message>
    <message>
        <source>speed of joint %1 / joint %2</source>
        <translation>velocidad del par %1 / par %2</translation>
    </message>
    <message>
        <source>What the efficiency is followed over.</source>
        <translation>Sobre qué se sigue el rendimiento.</translation>
    </message>
    <message>
        <source>efficiency backward</source>
        <translation>rendimiento inverso</translation>
    </message>
    <message>
        <source>The same with every known torque reversed: the output drives.</source>
        <translation>Lo mismo con cada momento conocido invertido: acciona la salida.</translation>
    </message>
    <message>
        <source>torque at %1</source>
        <translation>momento: %1</translation>
    </message>
    <message>
        <source>What holds the loads there.</source>
        <translation>Lo que sostiene allí las cargas.</translation>
    </message>
    <message>
        <source>load and balance</source>
        <translation>carga y equilibrante</translation>
    </message>
    <message>
        <source>balance</source>
        <translation>equilibrante</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>A turning joint, by its label, or a link on which a load or a balance acts from outside.</source>
        <translation>Un par de revolución, por su etiqueta, o un eslabón sobre el que actúa desde fuera una carga o un equilibrante.</translation>
    </message>
    <message>
        <source>The link beyond the joint, seen from the ground.</source>
        <translation>El eslabón más allá del par, visto desde el bastidor.</translation>
    </message>
    <message>
        <source>carried by</source>
        <translation>a cargo de</translation>
    </message>
    <message>
        <source>What puts a torque in: a load that is given, a balance that is found, or nothing: a free joint.</source>
        <translation>Lo que introduce un momento: una carga dada, un equilibrante hallado, o nada: un par libre.</translation>
    </message>
    <message>
        <source>lossless</source>
        <translation>sin pérdidas</translation>
    </message>
    <message>
        <source>The torque that the joint&apos;s tail exerts on its head about the axis, of a train without losses.</source>
        <translation>El momento que la cola del par ejerce sobre su cabeza en torno al eje, en un tren sin pérdidas.</translation>
    </message>
    <message>
        <source>exact torque</source>
        <translation>momento exacto</translation>
    </message>
    <message>
        <source>The same with the losses of the meshes, where they are given.</source>
        <translation>Lo mismo con las pérdidas de los engranes, donde están dadas.</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>momento</translation>
    </message>
    <message>
        <source>The same as a decimal.</source>
        <translation>Lo mismo como decimal.</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>How fast the head turns against the tail.</source>
        <translation>A qué velocidad gira la cabeza respecto a la cola.</translation>
    </message>
    <message>
        <source>power</source>
        <translation>potencia</translation>
    </message>
    <message>
        <source>Torque times rate: what load or balance feed into the train here; below 0: what they take.</source>
        <translation>Momento por velocidad: lo que la carga o el equilibrante aportan aquí al tren; por debajo de 0: lo que extraen.</translation>
    </message>
    <message>
        <source>force</source>
        <translation>fuerza</translation>
    </message>
    <message>
        <source>coupling</source>
        <translation>acoplamiento</translation>
    </message>
    <message>
        <source>A brake or clutch that is engaged.</source>
        <translation>Un freno o embrague activado.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>sujeta</translation>
    </message>
    <message>
        <source>The link that a brake holds; the two links that a clutch joins, the torque acts on the first one.</source>
        <translation>El eslabón que sujeta un freno; los dos eslabones que une un embrague, el momento actúa sobre el primero.</translation>
    </message>
    <message>
        <source>about</source>
        <translation>en torno a</translation>
    </message>
    <message>
        <source>The axis that the torque is about, the first one on the way to the ground.</source>
        <translation>El eje en torno al que actúa el momento, el primero de camino al bastidor.</translation>
    </message>
    <message>
        <source>The torque on that link, with the losses where they are given.</source>
        <translation>El momento sobre ese eslabón, con las pérdidas donde están dadas.</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>transmitida</translation>
    </message>
    <message>
        <source>The power that a clutch delivers to the first link; a brake passes none.</source>
        <translation>La potencia que un embrague entrega al primer eslabón; un freno no transmite ninguna.</translation>
    </message>
    <message>
        <source>The gear mesh, by its label.</source>
        <translation>El engrane, por su etiqueta.</translation>
    </message>
    <message>
        <source>The link of the tail&apos;s gear.</source>
        <translation>El eslabón de la rueda de la cola.</translation>
    </message>
    <message>
        <source>The link of the head&apos;s gear.</source>
        <translation>El eslabón de la rueda de la cabeza.</translation>
    </message>
    <message>
        <source>carrier</source>
        <translation>portasatélites</translation>
    </message>
    <message>
        <source>The link that holds both gears&apos; axes, from which the mesh is seen.</source>
        <translation>El eslabón que sostiene los ejes de ambas ruedas, desde el que se ve el engrane.</translation>
    </message>
    <message>
        <source>on tail</source>
        <translation>en la cola</translation>
    </message>
    <message>
        <source>The torque of the mesh on the tail&apos;s gear about its own axis, seen from the carrier.</source>
        <translation>El momento del engrane sobre la rueda de la cola en torno a su propio eje, visto desde el portasatélites.</translation>
    </message>
    <message>
        <source>on head</source>
        <translation>en la cabeza</translation>
    </message>
    <message>
        <source>The torque of the mesh on the head&apos;s gear about its own axis, seen from the carrier.</source>
        <translation>El momento del engrane sobre la rueda de la cabeza en torno a su propio eje, visto desde el portasatélites.</translation>
    </message>
    <message>
        <source>tangential</source>
        <translation>tangencial</translation>
    </message>
    <message>
        <source>The force along the pitch circles&apos; tangent, of the tail&apos;s gear on the head&apos;s.</source>
        <translation>La fuerza según la tangente a las circunferencias primitivas, de la rueda de la cola sobre la de la cabeza.</translation>
    </message>
    <message>
        <source>separating</source>
        <translation>separadora</translation>
    </message>
    <message>
        <source>The force that presses the gears apart: the tangential one times the tangent of the operating pressure angle.</source>
        <translation>La fuerza que separa las ruedas: la tangencial por la tangente del ángulo de presión de funcionamiento.</translation>
    </message>
    <message>
        <source>The whole tooth force on the head&apos;s gear, in the base frame.</source>
        <translation>La fuerza total del diente sobre la rueda de la cabeza, en el sistema base.</translation>
    </message>
    <message>
        <source>Power delivered over power taken, seen from the carrier.</source>
        <translation>Potencia entregada entre potencia tomada, vista desde el portasatélites.</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>acciona</translation>
    </message>
    <message>
        <source>The gear that delivers the power to the teeth, seen from the carrier.</source>
        <translation>La rueda que entrega la potencia a los dientes, vista desde el portasatélites.</translation>
    </message>
    <message>
        <source>rolling power</source>
        <translation>potencia de rodadura</translation>
    </message>
    <message>
        <source>What the teeth pass from tail to head, seen from the carrier: the latent power.</source>
        <translation>Lo que transmiten los dientes de la cola a la cabeza, visto desde el portasatélites: la potencia latente.</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdida</translation>
    </message>
    <message>
        <source>One minus the efficiency, times the rolling power.</source>
        <translation>Uno menos el rendimiento, por la potencia de rodadura.</translation>
    </message>
    <message>
        <source>to tail</source>
        <translation>a la cola</translation>
    </message>
    <message>
        <source>What the mesh delivers to the tail&apos;s gear, seen from the ground.</source>
        <translation>Lo que el engrane entrega a la rueda de la cola, visto desde el bastidor.</translation>
    </message>
    <message>
        <source>to head</source>
        <translation>a la cabeza</translation>
    </message>
    <message>
        <source>What the mesh delivers to the head&apos;s gear, seen from the ground.</source>
        <translation>Lo que el engrane entrega a la rueda de la cabeza, visto desde el bastidor.</translation>
    </message>
    <message>
        <source>to carrier</source>
        <translation>al portasatélites</translation>
    </message>
    <message>
        <source>What the mesh delivers to the carrier, seen from the ground.</source>
        <translation>Lo que el engrane entrega al portasatélites, visto desde el bastidor.</translation>
    </message>
    <message>
        <source>The turning joint, whose bearing holds its head on its tail.</source>
        <translation>El par de revolución, cuyo cojinete sostiene su cabeza en su cola.</translation>
    </message>
    <message>
        <source>The size of the force of the tail on the head.</source>
        <translation>El módulo de la fuerza de la cola sobre la cabeza.</translation>
    </message>
    <message>
        <source>The force of the tail on the head, in the base frame.</source>
        <translation>La fuerza de la cola sobre la cabeza, en el sistema base.</translation>
    </message>
    <message>
        <source>The moment of the tail on the head about the point, with the joint&apos;s own torque.</source>
        <translation>El momento de la cola sobre la cabeza respecto al punto, con el momento propio del par.</translation>
    </message>
    <message>
        <source>Where the joint is drawn: the point that the moment is about, in the document&apos;s unit.</source>
        <translation>Dónde está dibujado el par: el punto respecto al que se toma el momento, en la unidad del documento.</translation>
    </message>
    <message>
        <source>Where the joint is drawn, in the document&apos;s unit.</source>
        <translation>Dónde está dibujado el par, en la unidad del documento.</translation>
    </message>
    <message>
        <source>A mesh, a joint, an engaged coupling, a load or a balance.</source>
        <translation>Un engrane, un par, un acoplamiento activado, una carga o un equilibrante.</translation>
    </message>
    <message>
        <source>The link that it acts on.</source>
        <translation>El eslabón sobre el que actúa.</translation>
    </message>
    <message>
        <source>exact power</source>
        <translation>potencia exacta</translation>
    </message>
    <message>
        <source>What the element delivers to the link, seen from the ground; below 0: what it takes from it. The sum at every link is 0.</source>
        <translation>Lo que el elemento entrega al eslabón, visto desde el bastidor; por debajo de 0: lo que toma de él. La suma en cada eslabón es 0.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>Of the power fed into the train.</source>
        <translation>De la potencia aportada al tren.</translation>
    </message>
    <message>
        <source>load on link %1</source>
        <translation>carga en el eslabón %1</translation>
    </message>
    <message>
        <source>balance on link %1</source>
        <translation>equilibrante en el eslabón %1</translation>
    </message>
    <message>
        <source>The least power on the loop: what goes round beside what goes through.</source>
        <translation>La menor potencia del lazo: lo que circula además de lo que pasa.</translation>
    </message>
    <message>
        <source>The shafts of the loop.</source>
        <translation>Los ejes del lazo.</translation>
    </message>
    <message>
        <source>meshes</source>
        <translation>engranes</translation>
    </message>
    <message>
        <source>The meshes of the gear sets of the loop.</source>
        <translation>Los engranes de los trenes del lazo.</translation>
    </message>
    <message>
        <source>Bearings</source>
        <translation>Cojinetes</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Potencia</translation>
    </message>
    <message>
        <source>Circulating power</source>
        <translation>Potencia circulante</translation>
    </message>
    <message>
        <source>The state of the gearbox, by its name.</source>
        <translation>El estado de la caja, por su nombre.</translation>
    </message>
    <message>
        <source>The torque that the brake exerts on its link while it is engaged.</source>
        <translation>El momento que el freno ejerce sobre su eslabón mientras está activado.</translation>
    </message>
    <message>
        <source>The torque that the clutch exerts on the first of its links while it is engaged; the second one has the reaction.</source>
        <translation>El momento que el embrague ejerce sobre el primero de sus eslabones mientras está activado; el segundo tiene la reacción.</translation>
    </message>
    <message>
        <source>exact ratio</source>
        <translation>relación exacta</translation>
    </message>
    <message>
        <source>The speed of the drive over that of the driven link.</source>
        <translation>La velocidad del eslabón motor entre la del conducido.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>hallado</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving.</source>
        <translation>Potencia extraída entre potencia aportada, cuando acciona la entrada.</translation>
    </message>
    <message>
        <source>The same with all known torques reversed: the output drives.</source>
        <translation>Lo mismo con todos los momentos conocidos invertidos: acciona la salida.</translation>
    </message>
    <message>
        <source>latent</source>
        <translation>latente</translation>
    </message>
    <message>
        <source>The power that all meshes pass, seen from their carriers, over the power fed.</source>
        <translation>La potencia que transmiten todos los engranes, vista desde sus portasatélites, entre la aportada.</translation>
    </message>
    <message>
        <source>circulating</source>
        <translation>circulante</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop, for each watt that is fed.</source>
        <translation>La mayor potencia que circula en un lazo, por cada vatio aportado.</translation>
    </message>
    <message>
        <source>locks</source>
        <translation>bloquea</translation>
    </message>
    <message>
        <source>An object is needed here.</source>
        <translation>Aquí se necesita un objeto.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is missing.</source>
        <translation>Falta el miembro «%1».</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is of the wrong type.</source>
        <translation>El miembro «%1» es de un tipo incorrecto.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>Aquí se necesita un número entero.</translation>
    </message>
    <message>
        <source>An array is needed here.</source>
        <translation>Aquí se necesita una lista.</translation>
    </message>
    <message>
        <source>A text is needed here.</source>
        <translation>Aquí se necesita un texto.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no list of the document with an id.</source>
        <translation>«%1» no es una lista del documento con identificadores.</translation>
    </message>
    <message>
        <source>This is no file of the format &quot;%1&quot;.</source>
        <translation>Esto no es un archivo del formato «%1».</translation>
    </message>
    <message>
        <source>Version %1 is not known to this program.</source>
        <translation>Este programa no conoce la versión %1.</translation>
    </message>
    <message>
        <source>field left empty</source>
        <translation>campo dejado vacío</translation>
    </message>
    <message>
        <source>text that is no number</source>
        <translation>texto que no es un número</translation>
    </message>
    <message>
        <source>comma that may be a decimal or a thousand</source>
        <translation>coma que puede ser decimal o de millares</translation>
    </message>
    <message>
        <source>text that the question does not offer</source>
        <translation>texto que la pregunta no ofrece</translation>
    </message>
    <message>
        <source>incidence with + and − exchanged</source>
        <translation>incidencia con + y − intercambiados</translation>
    </message>
    <message>
        <source>tail and head of an arrow exchanged</source>
        <translation>cola y cabeza de una flecha intercambiadas</translation>
    </message>
    <message>
        <source>signs left out</source>
        <translation>signos omitidos</translation>
    </message>
    <message>
        <source>an end of an arrow left out</source>
        <translation>un extremo de una flecha omitido</translation>
    </message>
    <message>
        <source>a link that is no end of the arrow</source>
        <translation>un eslabón que no es extremo de la flecha</translation>
    </message>
    <message>
        <source>ground row left in</source>
        <translation>fila del bastidor conservada</translation>
    </message>
    <message>
        <source>ground row left out</source>
        <translation>fila del bastidor omitida</translation>
    </message>
    <message>
        <source>rows and columns exchanged</source>
        <translation>filas y columnas intercambiadas</translation>
    </message>
    <message>
        <source>entry that is not −1, 0 or 1</source>
        <translation>entrada que no es −1, 0 ni 1</translation>
    </message>
    <message>
        <source>arrow walked against its direction</source>
        <translation>flecha recorrida a contrasentido</translation>
    </message>
    <message>
        <source>joint of the walk left out</source>
        <translation>par del camino omitido</translation>
    </message>
    <message>
        <source>joint that is not on the walk</source>
        <translation>par que no está en el camino</translation>
    </message>
    <message>
        <source>another cycle&apos;s row</source>
        <translation>fila de otro ciclo</translation>
    </message>
    <message>
        <source>cycle walked against its mesh</source>
        <translation>ciclo recorrido en contra de su engrane</translation>
    </message>
    <message>
        <source>the cycle&apos;s own mesh left out</source>
        <translation>el propio engrane del ciclo omitido</translation>
    </message>
    <message>
        <source>another mesh in the cycle</source>
        <translation>otro engrane en el ciclo</translation>
    </message>
    <message>
        <source>walked from the ground instead of to it</source>
        <translation>recorrido desde el bastidor en vez de hacia él</translation>
    </message>
    <message>
        <source>another link&apos;s walk</source>
        <translation>camino de otro eslabón</translation>
    </message>
    <message>
        <source>another joint&apos;s cutset</source>
        <translation>conjunto de corte de otro par</translation>
    </message>
    <message>
        <source>signs of the cycle instead of the cutset</source>
        <translation>signos del ciclo en vez del conjunto de corte</translation>
    </message>
    <message>
        <source>mesh that the cutset does not cut</source>
        <translation>engrane que el conjunto de corte no corta</translation>
    </message>
    <message>
        <source>mesh that the cutset cuts left out</source>
        <translation>omitido un engrane que el conjunto de corte corta</translation>
    </message>
    <message>
        <source>edge that crosses the cut the other way</source>
        <translation>arista que cruza el corte en el otro sentido</translation>
    </message>
    <message>
        <source>another turning joint in the cutset</source>
        <translation>otro par de revolución en el conjunto de corte</translation>
    </message>
    <message>
        <source>mesh listed among the turning joints</source>
        <translation>engrane contado entre los pares de revolución</translation>
    </message>
    <message>
        <source>both paths followed to the ground</source>
        <translation>ambos caminos seguidos hasta el bastidor</translation>
    </message>
    <message>
        <source>path of one gear only</source>
        <translation>solo el camino de una rueda</translation>
    </message>
    <message>
        <source>too few edges for a spanning tree</source>
        <translation>muy pocas aristas para un árbol generador</translation>
    </message>
    <message>
        <source>too many edges for a spanning tree</source>
        <translation>demasiadas aristas para un árbol generador</translation>
    </message>
    <message>
        <source>edges that close a loop</source>
        <translation>aristas que cierran un lazo</translation>
    </message>
    <message>
        <source>the required edge is not in the tree</source>
        <translation>la arista pedida no está en el árbol</translation>
    </message>
    <message>
        <source>senses that do not follow one walk</source>
        <translation>sentidos que no siguen un mismo recorrido</translation>
    </message>
    <message>
        <source>ratio upside down</source>
        <translation>relación al revés</translation>
    </message>
    <message>
        <source>internal mesh with an external sign</source>
        <translation>engrane interior con signo de exterior</translation>
    </message>
    <message>
        <source>external mesh with an internal sign</source>
        <translation>engrane exterior con signo de interior</translation>
    </message>
    <message>
        <source>sign of a bevel mesh</source>
        <translation>signo de un engrane cónico</translation>
    </message>
    <message>
        <source>sign wrong and ratio upside down</source>
        <translation>signo incorrecto y relación al revés</translation>
    </message>
    <message>
        <source>row of C in place of P</source>
        <translation>fila de C en lugar de P</translation>
    </message>
    <message>
        <source>coefficients without the signs of the cycle</source>
        <translation>coeficientes sin los signos del ciclo</translation>
    </message>
    <message>
        <source>teeth of another wheel on the same link</source>
        <translation>dientes de otra rueda del mismo eslabón</translation>
    </message>
    <message>
        <source>chord followed from the carrier to the gear</source>
        <translation>cuerda seguida del portasatélites a la rueda</translation>
    </message>
    <message>
        <source>circuit of the other chord</source>
        <translation>circuito de la otra cuerda</translation>
    </message>
    <message>
        <source>circuit followed to the ground instead of the carrier</source>
        <translation>circuito seguido hasta el bastidor en vez del portasatélites</translation>
    </message>
    <message>
        <source>circuit of the whole walk between the gears</source>
        <translation>circuito de todo el camino entre las ruedas</translation>
    </message>
    <message>
        <source>levels of the two gears exchanged</source>
        <translation>niveles de las dos ruedas intercambiados</translation>
    </message>
    <message>
        <source>transfer vertex where the level does not change</source>
        <translation>vértice de transferencia donde el nivel no cambia</translation>
    </message>
    <message>
        <source>gear taken for the carrier</source>
        <translation>rueda tomada por portasatélites</translation>
    </message>
    <message>
        <source>ground taken for the carrier</source>
        <translation>bastidor tomado por portasatélites</translation>
    </message>
    <message>
        <source>carrier that is not on the path</source>
        <translation>portasatélites que no está en el camino</translation>
    </message>
    <message>
        <source>level that is not on the path</source>
        <translation>nivel que no está en el camino</translation>
    </message>
    <message>
        <source>velocity relation used for torques</source>
        <translation>relación de velocidades usada para momentos</translation>
    </message>
    <message>
        <source>port torque with the wrong sign</source>
        <translation>momento de un puerto con signo incorrecto</translation>
    </message>
    <message>
        <source>Kutzbach&apos;s count where a mesh is redundant</source>
        <translation>recuento de Kutzbach con un engrane redundante</translation>
    </message>
    <message>
        <source>ground counted as a moving link</source>
        <translation>bastidor contado como eslabón móvil</translation>
    </message>
    <message>
        <source>rank and degrees of freedom exchanged</source>
        <translation>rango y grados de libertad intercambiados</translation>
    </message>
    <message>
        <source>two freedoms taken by a mesh</source>
        <translation>dos libertades quitadas por un engrane</translation>
    </message>
    <message>
        <source>meshes ignored</source>
        <translation>engranes ignorados</translation>
    </message>
    <message>
        <source>degrees of freedom that are not t − r</source>
        <translation>grados de libertad que no son t − r</translation>
    </message>
    <message>
        <source>too few inputs</source>
        <translation>muy pocas entradas</translation>
    </message>
    <message>
        <source>inputs that depend on each other</source>
        <translation>entradas que dependen entre sí</translation>
    </message>
    <message>
        <source>a joint that can never turn as input</source>
        <translation>un par que no puede girar nunca, como entrada</translation>
    </message>
    <message>
        <source>a joint that no mesh drives is not an input</source>
        <translation>un par que ningún engrane mueve no es entrada</translation>
    </message>
    <message>
        <source>mesh on which no other depends</source>
        <translation>engrane del que ningún otro depende</translation>
    </message>
    <message>
        <source>no mesh taken for redundant</source>
        <translation>ningún engrane tomado por redundante</translation>
    </message>
    <message>
        <source>number of redundant meshes</source>
        <translation>número de engranes redundantes</translation>
    </message>
    <message>
        <source>sign of the speed lost</source>
        <translation>signo de la velocidad perdido</translation>
    </message>
    <message>
        <source>an input ignored</source>
        <translation>una entrada ignorada</translation>
    </message>
    <message>
        <source>sign of one mesh in the chain</source>
        <translation>signo de un engrane de la cadena</translation>
    </message>
    <message>
        <source>absolute speed in place of the joint&apos;s rate</source>
        <translation>velocidad absoluta en lugar de la del par</translation>
    </message>
    <message>
        <source>motion of the carrier ignored</source>
        <translation>movimiento del portasatélites ignorado</translation>
    </message>
    <message>
        <source>whole ratio upside down</source>
        <translation>relación total al revés</translation>
    </message>
    <message>
        <source>number of teeth out of the range</source>
        <translation>número de dientes fuera del intervalo</translation>
    </message>
    <message>
        <source>teeth that do not make the ratio</source>
        <translation>dientes que no dan la relación</translation>
    </message>
    <message>
        <source>teeth of the ring added</source>
        <translation>dientes de la corona sumados</translation>
    </message>
    <message>
        <source>planet counted once in the ring</source>
        <translation>satélite contado una sola vez en la corona</translation>
    </message>
    <message>
        <source>couplings of another gear</source>
        <translation>acoplamientos de otra marcha</translation>
    </message>
    <message>
        <source>couplings that lock the drive</source>
        <translation>acoplamientos que bloquean la transmisión</translation>
    </message>
    <message>
        <source>too few couplings to leave one freedom</source>
        <translation>muy pocos acoplamientos para dejar un grado de libertad</translation>
    </message>
    <message>
        <source>couplings that make another ratio</source>
        <translation>acoplamientos que dan otra relación</translation>
    </message>
    <message>
        <source>brake or clutch that is released</source>
        <translation>freno o embrague que está liberado</translation>
    </message>
    <message>
        <source>a smaller torque taken for the largest</source>
        <translation>un momento menor tomado por el mayor</translation>
    </message>
    <message>
        <source>the fastest clutch instead of that of the largest torque</source>
        <translation>el embrague más rápido en vez del de mayor momento</translation>
    </message>
    <message>
        <source>the largest ratio instead of the largest torque</source>
        <translation>la relación mayor en vez del momento mayor</translation>
    </message>
    <message>
        <source>torques added without their signs</source>
        <translation>momentos sumados sin sus signos</translation>
    </message>
    <message>
        <source>torque of another brake, clutch or state</source>
        <translation>momento de otro freno, embrague o estado</translation>
    </message>
    <message>
        <source>torque of the load in place of that of the brake</source>
        <translation>momento de la carga en lugar del del freno</translation>
    </message>
    <message>
        <source>torque of the drive in place of that of the brake</source>
        <translation>momento del accionamiento en lugar del del freno</translation>
    </message>
    <message>
        <source>torque on the housing in place of that on the link</source>
        <translation>momento sobre la carcasa en lugar del eslabón</translation>
    </message>
    <message>
        <source>brake that turns link and housing in the same sense</source>
        <translation>freno que gira eslabón y carcasa en el mismo sentido</translation>
    </message>
    <message>
        <source>efficiency forward in place of backward</source>
        <translation>rendimiento hacia delante en lugar de hacia atrás</translation>
    </message>
    <message>
        <source>losses left out</source>
        <translation>pérdidas omitidas</translation>
    </message>
    <message>
        <source>losses of a planetary train as of fixed axes</source>
        <translation>pérdidas de un tren planetario como de ejes fijos</translation>
    </message>
    <message>
        <source>efficiency upside down</source>
        <translation>rendimiento al revés</translation>
    </message>
    <message>
        <source>self-locking train taken for one that turns</source>
        <translation>tren que se autobloquea tomado por uno que gira</translation>
    </message>
    <message>
        <source>train that turns taken for a self-locking one</source>
        <translation>tren que gira tomado por uno que se autobloquea</translation>
    </message>
    <message>
        <source>efficiency of a train that locks itself</source>
        <translation>rendimiento de un tren que se autobloquea</translation>
    </message>
    <message>
        <source>right row, wrong column</source>
        <translation>fila correcta, columna incorrecta</translation>
    </message>
    <message>
        <source>right column, wrong row</source>
        <translation>columna correcta, fila incorrecta</translation>
    </message>
    <message>
        <source>an entry that is right</source>
        <translation>una entrada que es correcta</translation>
    </message>
    <message>
        <source>right place, wrong correction</source>
        <translation>lugar correcto, corrección incorrecta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here.</source>
        <translation>«%1» no se conoce aquí.</translation>
    </message>
    <message>
        <source>This part does not fit the fields of its question.</source>
        <translation>Esta parte no corresponde a los campos de su pregunta.</translation>
    </message>
    <message>
        <source>Answers are kept by the number of their question.</source>
        <translation>Las respuestas se guardan por el número de su pregunta.</translation>
    </message>
    <message>
        <source>An answer is a text or a number.</source>
        <translation>Una respuesta es un texto o un número.</translation>
    </message>
    <message>
        <source>There is no example &quot;%1&quot;.</source>
        <translation>No hay ningún ejemplo «%1».</translation>
    </message>
    <message>
        <source>The glossary has no term &quot;%1&quot;.</source>
        <translation>El glosario no tiene el término «%1».</translation>
    </message>
    <message>
        <source>The solution is not accepted.</source>
        <translation>La solución no se acepta.</translation>
    </message>
    <message>
        <source>An answer has a text for each field.</source>
        <translation>Una respuesta tiene un texto por campo.</translation>
    </message>
    <message>
        <source>This answer is accepted as right.</source>
        <translation>Esta respuesta se acepta como correcta.</translation>
    </message>
    <message>
        <source>This answer gets another reason: &quot;%1&quot;</source>
        <translation>Esta respuesta recibe otra razón: «%1»</translation>
    </message>
    <message>
        <source>The document of the step fulfils them already: nothing is left to draw.</source>
        <translation>El documento del paso ya las cumple: no queda nada por dibujar.</translation>
    </message>
    <message>
        <source>The solution is not accepted: %1</source>
        <translation>La solución no se acepta: %1</translation>
    </message>
    <message>
        <source>This drawing is accepted as right.</source>
        <translation>Este dibujo se acepta como correcto.</translation>
    </message>
    <message>
        <source>The first condition that fails is %1.</source>
        <translation>La primera condición que falla es %1.</translation>
    </message>
    <message>
        <source>An id consists of small letters, digits and hyphens, such as &quot;cycle-basis&quot;.</source>
        <translation>Un identificador consta de minúsculas, cifras y guiones, como «cycle-basis».</translation>
    </message>
    <message>
        <source>A lesson takes 1 to 60 minutes.</source>
        <translation>Una lección dura de 1 a 60 minutos.</translation>
    </message>
    <message>
        <source>A lesson has 1 to %1 steps.</source>
        <translation>Una lección tiene de 1 a %1 pasos.</translation>
    </message>
    <message>
        <source>Either an example is named or a document is given, not both.</source>
        <translation>O se nombra un ejemplo o se da un documento, no ambas cosas.</translation>
    </message>
    <message>
        <source>A step explains in at most %1 words; these are %2.</source>
        <translation>Un paso explica con %1 palabras como máximo; estas son %2.</translation>
    </message>
    <message>
        <source>The paper numbers its equations from 1 to %1.</source>
        <translation>El artículo numera sus ecuaciones del 1 al %1.</translation>
    </message>
    <message>
        <source>Neither the step nor its lesson names an example or gives a document.</source>
        <translation>Ni el paso ni su lección nombran un ejemplo o dan un documento.</translation>
    </message>
    <message>
        <source>A step gives at least one hint.</source>
        <translation>Un paso da al menos una pista.</translation>
    </message>
    <message>
        <source>This part does not fit the fields of its task.</source>
        <translation>Esta parte no corresponde a los campos de su tarea.</translation>
    </message>
    <message>
        <source>What the analysis gives here is no answer to this field.</source>
        <translation>Lo que el análisis da aquí no es respuesta para este campo.</translation>
    </message>
    <message>
        <source>An answer has a text for each field: %1, not %2.</source>
        <translation>Una respuesta tiene un texto por campo: %1, no %2.</translation>
    </message>
    <message>
        <source>There is no such field.</source>
        <translation>No hay tal campo.</translation>
    </message>
    <message>
        <source>The field &quot;%1&quot; cannot hold &quot;%2&quot;.</source>
        <translation>El campo «%1» no admite «%2».</translation>
    </message>
    <message>
        <source>The document gives no exercise of this kind: %1.</source>
        <translation>El documento no da ningún ejercicio de este tipo: %1.</translation>
    </message>
    <message>
        <source>No exercise of this kind is about this element.</source>
        <translation>Ningún ejercicio de este tipo trata de este elemento.</translation>
    </message>
    <message>
        <source>A mechanism is missing here.</source>
        <translation>Aquí falta un mecanismo.</translation>
    </message>
    <message>
        <source>The document has no such element.</source>
        <translation>El documento no tiene tal elemento.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>Your task</source>
        <translation>Su tarea</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Elegir</translation>
    </message>
    <message>
        <source>Pick in the drawing</source>
        <translation>Señalar en el dibujo</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Predecir</translation>
    </message>
    <message>
        <source>Find the mistake</source>
        <translation>Encontrar el error</translation>
    </message>
    <message>
        <source>The degrees of freedom are not defined yet: the document has errors.</source>
        <translation>Los grados de libertad aún no están definidos: el documento tiene errores.</translation>
    </message>
    <message>
        <source>This quantity is not known.</source>
        <translation>Esta magnitud no se conoce.</translation>
    </message>
    <message>
        <source>The document has no turning joint &quot;%1&quot;.</source>
        <translation>El documento no tiene el par de revolución «%1».</translation>
    </message>
    <message>
        <source>The speeds are not determined yet: see Problems.</source>
        <translation>Las velocidades aún no están determinadas: véase Problemas.</translation>
    </message>
    <message>
        <source>The solution was cancelled.</source>
        <translation>La solución se canceló.</translation>
    </message>
    <message>
        <source>The document has no state &quot;%1&quot;.</source>
        <translation>El documento no tiene el estado «%1».</translation>
    </message>
    <message>
        <source>The document has errors: no state has a ratio.</source>
        <translation>El documento tiene errores: ningún estado tiene relación.</translation>
    </message>
    <message>
        <source>State &quot;%1&quot; has no ratio.</source>
        <translation>El estado «%1» no tiene relación.</translation>
    </message>
    <message>
        <source>The document has errors: torques are not determined.</source>
        <translation>El documento tiene errores: los momentos no están determinados.</translation>
    </message>
    <message>
        <source>The loads are not held: torques are not determined.</source>
        <translation>Las cargas no están sostenidas: los momentos no están determinados.</translation>
    </message>
    <message>
        <source>The torque of &quot;%1&quot; is not determined as a fraction.</source>
        <translation>El momento de «%1» no está determinado como fracción.</translation>
    </message>
    <message>
        <source>The document has no balance or engaged coupling &quot;%1&quot;.</source>
        <translation>El documento no tiene el equilibrante o acoplamiento activado «%1».</translation>
    </message>
    <message>
        <source>The document has no gear mesh &quot;%1&quot;.</source>
        <translation>El documento no tiene el engrane «%1».</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree: meshes close no cycles.</source>
        <translation>Los pares de revolución no forman un árbol generador: los engranes no cierran ciclos.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; has no transfer vertex.</source>
        <translation>El engrane «%1» no tiene vértice de transferencia.</translation>
    </message>
    <message>
        <source>A number or a fraction such as &quot;-2/3&quot; is needed here.</source>
        <translation>Aquí se necesita un número o una fracción como «-2/3».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no quantity that the analysis gives.</source>
        <translation>«%1» no es una magnitud que dé el análisis.</translation>
    </message>
    <message>
        <source>The quantity &quot;%1&quot; is of the whole document.</source>
        <translation>La magnitud «%1» es de todo el documento.</translation>
    </message>
    <message>
        <source>What can be picked is links, turningJoints or gearMeshes.</source>
        <translation>Lo que se puede señalar es links, turningJoints o gearMeshes.</translation>
    </message>
    <message>
        <source>What can be picked is named here.</source>
        <translation>Aquí se nombra lo que se puede señalar.</translation>
    </message>
    <message>
        <source>A field is an integer, a number, a choice or a set.</source>
        <translation>Un campo es un entero, un número, una elección o un conjunto.</translation>
    </message>
    <message>
        <source>A choice or a set has options, a number has none.</source>
        <translation>Una elección o un conjunto tiene opciones, un número no.</translation>
    </message>
    <message>
        <source>A mistake is told by answers or by conditions, not by both.</source>
        <translation>Un error se describe con respuestas o con condiciones, no con ambas.</translation>
    </message>
    <message>
        <source>A reason is a sentence.</source>
        <translation>Una razón es una frase.</translation>
    </message>
    <message>
        <source>A mistake has at least one condition.</source>
        <translation>Un error tiene al menos una condición.</translation>
    </message>
    <message>
        <source>A mistake that conditions tell needs an example of an answer.</source>
        <translation>Un error descrito con condiciones necesita un ejemplo de respuesta.</translation>
    </message>
    <message>
        <source>A prediction names the quantity of the analysis that it is compared with.</source>
        <translation>Una predicción nombra la magnitud del análisis con la que se compara.</translation>
    </message>
    <message>
        <source>A choice needs two options or more.</source>
        <translation>Una elección necesita dos opciones o más.</translation>
    </message>
    <message>
        <source>A task gives its reason for at least one wrong answer.</source>
        <translation>Una tarea da la razón de al menos una respuesta incorrecta.</translation>
    </message>
    <message>
        <source>What is right is told in one way: by &quot;accepted&quot;, by &quot;conditions&quot;, or by &quot;is&quot; of every field.</source>
        <translation>Lo que es correcto se dice de una sola manera: con «accepted», con «conditions» o con «is» de cada campo.</translation>
    </message>
    <message>
        <source>Conditions need a solution that fulfils them.</source>
        <translation>Las condiciones necesitan una solución que las cumpla.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no kind of exercise; `geargraph-cli exercises kinds` lists them.</source>
        <translation>«%1» no es un tipo de ejercicio; `geargraph-cli exercises kinds` los enumera.</translation>
    </message>
    <message>
        <source>A drawing is judged by numbers.</source>
        <translation>Un dibujo se juzga por números.</translation>
    </message>
    <message>
        <source>Either one value is given or bounds, not both.</source>
        <translation>O se da un valor o límites, no ambas cosas.</translation>
    </message>
    <message>
        <source>A condition has &quot;equals&quot;, &quot;least&quot; or &quot;most&quot;.</source>
        <translation>Una condición tiene «equals», «least» o «most».</translation>
    </message>
    <message>
        <source>A drawing has to fulfil something.</source>
        <translation>Un dibujo tiene que cumplir algo.</translation>
    </message>
    <message>
        <source>This is the position of a condition, counted from 0.</source>
        <translation>Esta es la posición de una condición, contada desde 0.</translation>
    </message>
    <message>
        <source>A task gives its reason for at least one wrong drawing.</source>
        <translation>Una tarea da la razón de al menos un dibujo incorrecto.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is not known here.</source>
        <translation>El miembro «%1» no se conoce aquí.</translation>
    </message>
    <message>
        <source>The document has a fault: %1</source>
        <translation>El documento tiene un fallo: %1</translation>
    </message>
    <message>
        <source>A task is one of type, choose, pick, predict, find, exercise and draw.</source>
        <translation>Una tarea es de uno de los tipos type, choose, pick, predict, find, exercise y draw.</translation>
    </message>
    <message>
        <source>An equation between velocities has no number without one: write the input&apos;s velocity.</source>
        <translation>Una ecuación entre velocidades no tiene número sin una de ellas: escriba la velocidad de la entrada.</translation>
    </message>
    <message>
        <source>This equation has no velocity: write θ or ω with a label.</source>
        <translation>Esta ecuación no tiene velocidad: escriba θ u ω con una etiqueta.</translation>
    </message>
    <message>
        <source>The equation is true for these teeth and not for all: it holds another mesh&apos;s ratio.</source>
        <translation>La ecuación es cierta para estos dientes y no para todos: contiene la relación de otro engrane.</translation>
    </message>
    <message>
        <source>The sign of the term with %1 is wrong: with the other one the equation holds.</source>
        <translation>El signo del término con %1 es incorrecto: con el otro se cumple la ecuación.</translation>
    </message>
    <message>
        <source>The ratio %1 is upside down: it is N of the tail over N of the head.</source>
        <translation>La relación %1 está al revés: es N de la cola entre N de la cabeza.</translation>
    </message>
    <message>
        <source>The ratio %1 is upside down, and a sign is wrong besides.</source>
        <translation>La relación %1 está al revés y, además, un signo es incorrecto.</translation>
    </message>
    <message>
        <source>The number before %1 is upside down.</source>
        <translation>El número delante de %1 está al revés.</translation>
    </message>
    <message>
        <source>A term with θ%1 is left out.</source>
        <translation>Falta un término con θ%1.</translation>
    </message>
    <message>
        <source>In place of %1 there should be θ%2.</source>
        <translation>En lugar de %1 debe estar θ%2.</translation>
    </message>
    <message>
        <source>With θ%1 = 1 and the other inputs at rest the left side is greater than the right one by %2.</source>
        <translation>Con θ%1 = 1 y las demás entradas en reposo, el lado izquierdo es mayor que el derecho en %2.</translation>
    </message>
    <message>
        <source>The equation is true for these teeth only.</source>
        <translation>La ecuación es cierta solo para estos dientes.</translation>
    </message>
    <message>
        <source>This mechanism has no motion to check an equation against.</source>
        <translation>Este mecanismo no tiene movimiento con el que comprobar una ecuación.</translation>
    </message>
    <message>
        <source>You exchange rows and columns of %1.</source>
        <translation>Intercambia filas y columnas de %1.</translation>
    </message>
    <message>
        <source>You leave out the minus of (23): what is on the other side of the equation changes its sign.</source>
        <translation>Omite el menos de (23): lo que está al otro lado de la ecuación cambia de signo.</translation>
    </message>
    <message>
        <source>You write all entries without their signs: −1 where a walk runs against an arrow.</source>
        <translation>Escribe todas las entradas sin signo: −1 donde un camino va en contra de una flecha.</translation>
    </message>
    <message>
        <source>You exchange rows and columns of %1, and + and − besides.</source>
        <translation>Intercambia filas y columnas de %1 y, además, + y −.</translation>
    </message>
    <message>
        <source>These are the rows of T: P multiplies each entry by the joint&apos;s coefficient.</source>
        <translation>Estas son las filas de T: P multiplica cada entrada por el coeficiente del par.</translation>
    </message>
    <message>
        <source>These are the signs of P alone: each is to be multiplied by the ratio of its gear.</source>
        <translation>Estos son solo los signos de P: cada uno se multiplica por la relación de su rueda.</translation>
    </message>
    <message>
        <source>Your ratios are upside down: a joint on the axis of the tail&apos;s gear has i, one on the head&apos;s has 1.</source>
        <translation>Sus relaciones están al revés: un par en el eje de la rueda de la cola tiene i, uno en el de la cabeza tiene 1.</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>ambigua</translation>
    </message>
    <message>
        <source>another matrix than the one asked for</source>
        <translation>otra matriz que la pedida</translation>
    </message>
    <message>
        <source>size that the matrix does not have</source>
        <translation>tamaño que la matriz no tiene</translation>
    </message>
    <message>
        <source>minus of the solution left out</source>
        <translation>menos de la solución omitido</translation>
    </message>
    <message>
        <source>row of another output</source>
        <translation>fila de otra salida</translation>
    </message>
    <message>
        <source>ratio of another mesh with the same value</source>
        <translation>relación de otro engrane con el mismo valor</translation>
    </message>
    <message>
        <source>input that the output does not feel</source>
        <translation>entrada que la salida no nota</translation>
    </message>
    <message>
        <source>entry that differs</source>
        <translation>entrada que difiere</translation>
    </message>
    <message>
        <source>velocity left out of the equation</source>
        <translation>velocidad omitida en la ecuación</translation>
    </message>
    <message>
        <source>velocity of another joint or link</source>
        <translation>velocidad de otro par o eslabón</translation>
    </message>
    <message>
        <source>equation that does not follow from the mechanism</source>
        <translation>ecuación que no se deduce del mecanismo</translation>
    </message>
    <message>
        <source>This is %1, not %2.</source>
        <translation>Esto es %1, no %2.</translation>
    </message>
    <message>
        <source>%1 has the size %2 for this mechanism, and yours is %3.</source>
        <translation>%1 tiene para este mecanismo el tamaño %2, y la suya %3.</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 es %2</translation>
    </message>
    <message>
        <source>No matrix of this mechanism has the size %1: %2.</source>
        <translation>Ninguna matriz de este mecanismo tiene el tamaño %1: %2.</translation>
    </message>
    <message>
        <source>%1 is no label of %2, or occurs twice: its rows are %3, its columns %4.</source>
        <translation>%1 no es una etiqueta de %2, o aparece dos veces: sus filas son %3 y sus columnas %4.</translation>
    </message>
    <message>
        <source>This mechanism has no %1.</source>
        <translation>Este mecanismo no tiene %1.</translation>
    </message>
    <message>
        <source>These inputs depend on each other, so there is no solution for them.</source>
        <translation>Estas entradas dependen entre sí, así que no hay solución para ellas.</translation>
    </message>
    <message>
        <source>You turn the arrow of edge %1 round: it points from link %2 to link %3.</source>
        <translation>Invierte la flecha de la arista %1: va del eslabón %2 al eslabón %3.</translation>
    </message>
    <message>
        <source>The number is right for these teeth and the formula is not: it holds another mesh&apos;s ratio.</source>
        <translation>El número es correcto para estos dientes y la fórmula no: contiene la relación de otro engrane.</translation>
    </message>
    <message>
        <source>This is the row of %1, not of %2.</source>
        <translation>Esta es la fila de %1, no de %2.</translation>
    </message>
    <message>
        <source>You exchange the gears of mesh %1: i%1 belongs to the joints on the tail&apos;s axis.</source>
        <translation>Intercambia las ruedas del engrane %1: i%1 pertenece a los pares del eje de la cola.</translation>
    </message>
    <message>
        <source>The sign of bevel mesh %1 follows from its pitch point, seen from both axes.</source>
        <translation>El signo del engrane cónico %1 se deduce de su punto primitivo, visto desde ambos ejes.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: its gears turn the same way, seen from the carrier.</source>
        <translation>El engrane %1 es interior: visto desde el portasatélites, sus ruedas giran en el mismo sentido.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: its gears turn opposite ways, seen from the carrier.</source>
        <translation>El engrane %1 es exterior: visto desde el portasatélites, sus ruedas giran en sentidos opuestos.</translation>
    </message>
    <message>
        <source>The ratio of mesh %1 is upside down and its sign is wrong.</source>
        <translation>La relación del engrane %1 está al revés y su signo es incorrecto.</translation>
    </message>
    <message>
        <source>This is the row of the cycle: in P its signs are multiplied by the coefficients of mesh %1.</source>
        <translation>Esta es la fila del ciclo: en P sus signos se multiplican por los coeficientes del engrane %1.</translation>
    </message>
    <message>
        <source>You leave out the signs of the cycle of mesh %1, which walks against some arrows.</source>
        <translation>Omite los signos del ciclo del engrane %1, que recorre algunas flechas a contrasentido.</translation>
    </message>
    <message>
        <source>Joint %1 turns the other way: the sign of one mesh of its chain is wrong.</source>
        <translation>El par %1 gira en el otro sentido: el signo de un engrane de su cadena es incorrecto.</translation>
    </message>
    <message>
        <source>The row of joint %1 is upside down: it is output over input.</source>
        <translation>La fila del par %1 está al revés: es salida entre entrada.</translation>
    </message>
    <message>
        <source>In the sense that you walk it, the entry is %1.</source>
        <translation>En el sentido de su recorrido, la entrada es %1.</translation>
    </message>
    <message>
        <source>So the entry is %1.</source>
        <translation>Así que la entrada es %1.</translation>
    </message>
    <message>
        <source>Entries of this matrix are −1, 0 or 1.</source>
        <translation>Las entradas de esta matriz son −1, 0 o 1.</translation>
    </message>
    <message>
        <source>Joint %1 is not on cycle %2, so its coefficient is 0.</source>
        <translation>El par %1 no está en el ciclo %2, así que su coeficiente es 0.</translation>
    </message>
    <message>
        <source>In the multiple of row %1 that you write, joint %2 has %3.</source>
        <translation>En el múltiplo de la fila %1 que escribe, el par %2 tiene %3.</translation>
    </message>
    <message>
        <source>Joint %1 does not feel input %2: 0.</source>
        <translation>El par %1 no nota la entrada %2: 0.</translation>
    </message>
    <message>
        <source>With input %1 alone, joint %2 turns at %3 times its speed.</source>
        <translation>Solo con la entrada %1, el par %2 gira a %3 veces su velocidad.</translation>
    </message>
    <message>
        <source>Without labels it may be either: write the labels of rows and columns.</source>
        <translation>Sin etiquetas puede ser cualquiera de las dos: escriba las etiquetas de filas y columnas.</translation>
    </message>
    <message>
        <source>Your rows are in another order: %1.</source>
        <translation>Sus filas están en otro orden: %1.</translation>
    </message>
    <message>
        <source>Your columns are in another order: %1.</source>
        <translation>Sus columnas están en otro orden: %1.</translation>
    </message>
    <message>
        <source>You walk %1 the other way, which is as good: all signs of the row change.</source>
        <translation>Recorre %1 en el otro sentido, que vale igual: cambian todos los signos de la fila.</translation>
    </message>
    <message>
        <source>You take another spanning tree, of the edges %1: for it the matrix is right.</source>
        <translation>Toma otro árbol generador, de las aristas %1: para él la matriz es correcta.</translation>
    </message>
    <message>
        <source>This mechanism has no ratio %1.</source>
        <translation>Este mecanismo no tiene la relación %1.</translation>
    </message>
    <message>
        <source>Link %1 has no gear, so %2 has no value.</source>
        <translation>El eslabón %1 no tiene rueda, así que %2 no tiene valor.</translation>
    </message>
    <message>
        <source>Link %1 has several gears: write %2&apos; or %2&apos;&apos;, in the order of its meshes.</source>
        <translation>El eslabón %1 tiene varias ruedas: escriba %2&apos; o %2&apos;&apos;, en el orden de sus engranes.</translation>
    </message>
    <message>
        <source>The diameter %1 is no fraction: use numbers of teeth.</source>
        <translation>El diámetro %1 no es una fracción: use números de dientes.</translation>
    </message>
    <message>
        <source>This mechanism has no turning joint %1, so no %2.</source>
        <translation>Este mecanismo no tiene el par de revolución %1, así que no hay %2.</translation>
    </message>
    <message>
        <source>%1 names no links of this mechanism: write ω with two labels, as ω5_1.</source>
        <translation>%1 no nombra eslabones de este mecanismo: escriba ω con dos etiquetas, como ω5_1.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree, so no velocity follows from them.</source>
        <translation>Los pares de revolución no forman un árbol generador, así que de ellos no se deduce ninguna velocidad.</translation>
    </message>
    <message>
        <source>The velocity of link %1 relative to link %2 has several directions: write one equation for each level.</source>
        <translation>La velocidad del eslabón %1 respecto del eslabón %2 tiene varias direcciones: escriba una ecuación por nivel.</translation>
    </message>
    <message>
        <source>An entry is missing here.</source>
        <translation>Aquí falta una entrada.</translation>
    </message>
    <message>
        <source>This formula is too long.</source>
        <translation>Esta fórmula es demasiado larga.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: write a number, a fraction or names such as i15, n41, N4, θ8 or ω51.</source>
        <translation>«%1» no se puede leer: escriba un número, una fracción o nombres como i15, n41, N4, θ8 u ω51.</translation>
    </message>
    <message>
        <source>A velocity is multiplied by a velocity here.</source>
        <translation>Aquí se multiplica una velocidad por otra.</translation>
    </message>
    <message>
        <source>Something is divided by a velocity here.</source>
        <translation>Aquí se divide algo entre una velocidad.</translation>
    </message>
    <message>
        <source>Something is divided by 0 here.</source>
        <translation>Aquí se divide algo entre 0.</translation>
    </message>
    <message>
        <source>This formula has too many parentheses inside each other.</source>
        <translation>Esta fórmula tiene demasiados paréntesis anidados.</translation>
    </message>
    <message>
        <source>A power needs a whole number of at most %1.</source>
        <translation>Una potencia necesita un número entero de %1 como máximo.</translation>
    </message>
    <message>
        <source>“%1” can be read as a thousand or as a decimal: write it without the comma.</source>
        <translation>«%1» se puede leer como millar o como decimal: escríbalo sin la coma.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>“%1” holds a velocity, and an entry of a matrix is a number.</source>
        <translation>«%1» contiene una velocidad, y una entrada de una matriz es un número.</translation>
    </message>
    <message>
        <source>The text has more than %1 bytes.</source>
        <translation>El texto tiene más de %1 bytes.</translation>
    </message>
    <message>
        <source>There is no matrix and no equation.</source>
        <translation>No hay ni matriz ni ecuación.</translation>
    </message>
    <message>
        <source>This \begin has no name in braces.</source>
        <translation>Este \begin no tiene nombre entre llaves.</translation>
    </message>
    <message>
        <source>\begin{%1} has no \end{%1}.</source>
        <translation>\begin{%1} no tiene \end{%1}.</translation>
    </message>
    <message>
        <source>This bracket is not closed.</source>
        <translation>Este corchete no está cerrado.</translation>
    </message>
    <message>
        <source>The matrix has more than %1 entries.</source>
        <translation>La matriz tiene más de %1 entradas.</translation>
    </message>
    <message>
        <source>The matrix has no rows.</source>
        <translation>La matriz no tiene filas.</translation>
    </message>
    <message>
        <source>Row %1 has 1 entry, the first has %2.</source>
        <translation>La fila %1 tiene 1 entrada, la primera tiene %2.</translation>
    </message>
    <message>
        <source>Row %1 has %2 entries, the first has %3.</source>
        <translation>La fila %1 tiene %2 entradas, la primera tiene %3.</translation>
    </message>
    <message>
        <source>This row has a label and no entry.</source>
        <translation>Esta fila tiene una etiqueta y ninguna entrada.</translation>
    </message>
    <message>
        <source>There are %1 labels for %2 columns.</source>
        <translation>Hay %1 etiquetas para %2 columnas.</translation>
    </message>
    <message>
        <source>There are %1 labels for %2 rows.</source>
        <translation>Hay %1 etiquetas para %2 filas.</translation>
    </message>
    <message>
        <source>There is no equation.</source>
        <translation>No hay ninguna ecuación.</translation>
    </message>
    <message>
        <source>This line has no equals sign.</source>
        <translation>Esta línea no tiene signo igual.</translation>
    </message>
    <message>
        <source>A side of this equation is empty.</source>
        <translation>Un lado de esta ecuación está vacío.</translation>
    </message>
    <message>
        <source>The symbolic solution has %1 entries; it was left out.</source>
        <translation>La solución simbólica tiene %1 entradas; se omitió.</translation>
    </message>
    <message>
        <source>The equations of this mechanism are so coupled that the symbolic solution would fill pages; it was left out.</source>
        <translation>Las ecuaciones de este mecanismo están tan acopladas que la solución simbólica llenaría páginas; se omitió.</translation>
    </message>
    <message>
        <source>%1 entries of the symbolic solution are left as a chain of substitutions: expanded, one has over %2 terms, or all together over %3 factors.</source>
        <translation>%1 entradas de la solución simbólica quedan como cadena de sustituciones: desarrolladas, una tiene más de %2 términos, o todas juntas más de %3 factores.</translation>
    </message>
    <message>
        <source>Masses need lengths in metres, and &quot;%1&quot; is no unit of length that is known: use mm, cm, m or in.</source>
        <translation>Las masas necesitan longitudes en metros, y «%1» no es una unidad de longitud conocida: use mm, cm, m o in.</translation>
    </message>
    <message>
        <source>It ends where joint %1 reaches the end of its range.</source>
        <translation>Termina donde el par %1 llega al final de su intervalo.</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: torques determine no acceleration.</source>
        <translation>Un movimiento de las entradas no mueve ninguna masa: los momentos no determinan ninguna aceleración.</translation>
    </message>
    <message>
        <source>It ends where speeds grow beyond what can be followed.</source>
        <translation>Termina donde las velocidades crecen más allá de lo que se puede seguir.</translation>
    </message>
    <message>
        <source>The ratio of an input to joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, give a ratio that it can.</source>
        <translation>La relación de una entrada con el par %1 supera el mayor número que puede representar el análisis, 1.79e308. Números de dientes más próximos, o menos engranes seguidos, dan una que sí puede.</translation>
    </message>
    <message>
        <source>The speed of joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Lower the speeds of the inputs.</source>
        <translation>La velocidad del par %1 supera el mayor número que puede representar el análisis, 1.79e308. Reduzca las velocidades de las entradas.</translation>
    </message>
    <message>
        <source>The speed of the link that turns about joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Lower the speeds of the inputs.</source>
        <translation>La velocidad del eslabón que gira en el par %1 supera el mayor número que puede representar el análisis, 1.79e308. Reduzca las velocidades de las entradas.</translation>
    </message>
    <message>
        <source>In state %1: %2</source>
        <translation>En el estado %1: %2</translation>
    </message>
    <message>
        <source>In states %1: %2</source>
        <translation>En los estados %1: %2</translation>
    </message>
    <message>
        <source>No load is given: all torques are 0.</source>
        <translation>No se da ninguna carga: todos los momentos son 0.</translation>
    </message>
    <message>
        <source>The drive of state %1, link %2, gets 1 N m, as no load acts on it or on the driven link.</source>
        <translation>La entrada del estado %1, el eslabón %2, recibe 1 N m, pues no actúa ninguna carga sobre ella ni sobre el eslabón conducido.</translation>
    </message>
    <message>
        <source>The unit of length, &quot;%1&quot;, has no known size: forces of teeth and bearings are left out, and so are loads that are forces. Units are nm, um, mm, cm, dm, m, mil, in and ft.</source>
        <translation>No se conoce el tamaño de la unidad de longitud «%1»: se omiten las fuerzas de dientes y cojinetes, y también las cargas que son fuerzas. Las unidades son nm, um, mm, cm, dm, m, mil, in y ft.</translation>
    </message>
    <message>
        <source>The unit of length, &quot;%1&quot;, has no known size: forces of teeth and bearings are left out. Units are nm, um, mm, cm, dm, m, mil, in and ft.</source>
        <translation>No se conoce el tamaño de la unidad de longitud «%1»: se omiten las fuerzas de dientes y cojinetes. Las unidades son nm, um, mm, cm, dm, m, mil, in y ft.</translation>
    </message>
    <message>
        <source>Speeds are not determined: powers and efficiencies are left out. Give inputs their speeds, or choose a state of one degree of freedom.</source>
        <translation>Las velocidades no están determinadas: se omiten potencias y rendimientos. Dé a las entradas sus velocidades, o elija un estado de un grado de libertad.</translation>
    </message>
    <message>
        <source>No mesh has an efficiency: give `efficiency` or `friction` in the document, or --eta.</source>
        <translation>Ningún engrane tiene rendimiento: indique `efficiency` o `friction` en el documento, o --eta.</translation>
    </message>
    <message>
        <source>Nothing holds this motion: joint %1 turns freely under the load on %2. Add a balance at joint %3.</source>
        <translation>Nada sostiene este movimiento: el par %1 gira libremente bajo la carga en: %2. Añada un equilibrante en el par %3.</translation>
    </message>
    <message>
        <source>Nothing holds this motion: joints %1 turn freely under the load on %2. Add a balance at joint %3.</source>
        <translation>Nada sostiene este movimiento: los pares %1 giran libremente bajo la carga en: %2. Añada un equilibrante en el par %3.</translation>
    </message>
    <message>
        <source>coupling %1</source>
        <translation>acoplamiento %1</translation>
    </message>
    <message>
        <source>couplings %1</source>
        <translation>acoplamientos %1</translation>
    </message>
    <message>
        <source>balances</source>
        <translation>equilibrantes</translation>
    </message>
    <message>
        <source>%1 share the load in proportions that stiffness and clearance decide (1 self-stress).</source>
        <translation>%1 comparten la carga en proporciones que deciden la rigidez y el juego (1 autotensión).</translation>
    </message>
    <message>
        <source>%1 share the load in proportions that stiffness and clearance decide (%2 self-stresses).</source>
        <translation>%1 comparten la carga en proporciones que deciden la rigidez y el juego (%2 autotensiones).</translation>
    </message>
    <message>
        <source>Torques outside are determined.</source>
        <translation>Los momentos de fuera están determinados.</translation>
    </message>
    <message>
        <source>Torques that do not depend on them are determined.</source>
        <translation>Los momentos que no dependen de ellos están determinados.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load needs no balance.</source>
        <translation>El par %1 no puede girar: su carga no necesita equilibrante.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load is carried by mesh %2.</source>
        <translation>El par %1 no puede girar: su carga la lleva el engrane %2.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load is carried by meshes %2.</source>
        <translation>El par %1 no puede girar: su carga la llevan los engranes %2.</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction.</source>
        <translation>Ningún momento en: %1 mueve esta carga: el tren se autobloquea en este sentido.</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction (it begins below eta = %2).</source>
        <translation>Ningún momento en: %1 mueve esta carga: el tren se autobloquea en este sentido (empieza por debajo de eta = %2).</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction (it begins at %2 % of these losses).</source>
        <translation>Ningún momento en: %1 mueve esta carga: el tren se autobloquea en este sentido (empieza con el %2 % de estas pérdidas).</translation>
    </message>
    <message>
        <source>Mesh %1 passes %2 times the power fed, seen from its carrier.</source>
        <translation>El engrane %1 transmite %2 veces la potencia aportada, visto desde su portasatélites.</translation>
    </message>
    <message>
        <source>Meshes %1 pass up to %2 times the power fed, seen from their carriers.</source>
        <translation>Los engranes %1 transmiten hasta %2 veces la potencia aportada, vistos desde sus portasatélites.</translation>
    </message>
    <message>
        <source>%1 W of each W fed circulate through %2 and %3.</source>
        <translation>%1 W de cada W aportado circulan por: %2 y %3.</translation>
    </message>
    <message>
        <source>links %1</source>
        <translation>eslabones %1</translation>
    </message>
    <message>
        <source>Turning joints %1 name one axis (%2) but do not all hang together on it by common links: they coincide only in the drawn pose and are treated as different axes (%3). Give each axis of the mechanism its own entry in axes.</source>
        <translation>Los pares de revolución %1 nombran un eje (%2), pero no todos están unidos en él por eslabones comunes: solo coinciden en la posición dibujada y se tratan como ejes distintos (%3). Dé a cada eje del mecanismo su propia entrada en axes.</translation>
    </message>
    <message>
        <source>Axes %1 are one line held by common links: they are treated as one axis (%2).</source>
        <translation>Los ejes %1 son una sola recta que sostienen eslabones comunes: se tratan como un solo eje (%2).</translation>
    </message>
    <message>
        <source>The opposite direction of %1 is minded.</source>
        <translation>Se tiene en cuenta la dirección opuesta de %1.</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
    </message>
    <message>
        <source>New note here</source>
        <translation>Nota nueva aquí</translation>
    </message>
    <message>
        <source>Change the text</source>
        <translation>Cambiar el texto</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Añadir nota</translation>
    </message>
    <message>
        <source>Delete note</source>
        <translation>Eliminar nota</translation>
    </message>
    <message>
        <source>Change note</source>
        <translation>Cambiar nota</translation>
    </message>
    <message>
        <source>Text of the note</source>
        <translation>Texto de la nota</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Return takes the text, Shift+Return begins a new line, Esc leaves it as it was</source>
        <translation>Intro acepta el texto, Mayús+Intro empieza otra línea, Esc lo deja como estaba</translation>
    </message>
    <message>
        <source>A note has at most 1,000 characters.</source>
        <translation>Una nota tiene como máximo 1000 caracteres.</translation>
    </message>
    <message>
        <source>Move note</source>
        <translation>Mover nota</translation>
    </message>
    <message>
        <source>Notes are written on the sheet of the digraph</source>
        <translation>Las notas se escriben en la hoja del dígrafo</translation>
    </message>
    <message>
        <source>Never self-locking, however large the losses</source>
        <translation>Nunca se autobloquea, por grandes que sean las pérdidas</translation>
    </message>
    <message>
        <source>Moves up to %1 % of these losses; beyond, not decided</source>
        <translation>Se mueve hasta el %1 % de estas pérdidas; más allá, no decidido</translation>
    </message>
    <message>
        <source>Moves backward up to %1 % of these losses; beyond, not decided</source>
        <translation>Se mueve en sentido inverso hasta el %1 % de estas pérdidas; más allá, no decidido</translation>
    </message>
    <message>
        <source>Moves down to η = %1; below, not decided</source>
        <translation>Se mueve hasta η = %1; por debajo, no decidido</translation>
    </message>
    <message>
        <source>Moves backward down to η = %1; below, not decided</source>
        <translation>Se mueve en sentido inverso hasta η = %1; por debajo, no decidido</translation>
    </message>
    <message>
        <source>Self-locking from %1 % of these losses on</source>
        <translation>Se autobloquea a partir del %1 % de estas pérdidas</translation>
    </message>
    <message>
        <source>Self-locking backward from %1 % of these losses on</source>
        <translation>Se autobloquea en sentido inverso a partir del %1 % de estas pérdidas</translation>
    </message>
    <message>
        <source>Where a train locks itself, no torque of what holds the loads moves them, however large.</source>
        <translation>Donde un tren se autobloquea, ningún par de lo que sostiene las cargas las mueve, por grande que sea.</translation>
    </message>
    <message>
        <source>The meshes state different efficiencies: all their losses, 1 − η, are multiplied by one factor.</source>
        <translation>Los engranes indican rendimientos distintos: todas sus pérdidas, 1 − η, se multiplican por un mismo factor.</translation>
    </message>
    <message>
        <source>The efficiency counts as the same in all meshes.</source>
        <translation>El rendimiento cuenta como igual en todos los engranes.</translation>
    </message>
    <message>
        <source>At %1 % it moves, at %2 % no choice of driving gears solves it.</source>
        <translation>Al %1 % se mueve, al %2 % ninguna elección de ruedas motrices lo resuelve.</translation>
    </message>
    <message>
        <source>At η = %1 it moves, at %2 no choice of driving gears solves it.</source>
        <translation>Con η = %1 se mueve, con %2 ninguna elección de ruedas motrices lo resuelve.</translation>
    </message>
    <message>
        <source>Of that many meshes not all choices were tried.</source>
        <translation>Con tantos engranes no se probaron todas las elecciones.</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 nota</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 notas</translation>
    </message>
    <message>
        <source>Select links or notes to copy; the ground stays where it is.</source>
        <translation>Seleccione eslabones o notas para copiar; el bastidor se queda donde está.</translation>
    </message>
    <message>
        <source>Rename a link, change a note</source>
        <translation>Renombrar un eslabón, cambiar una nota</translation>
    </message>
    <message>
        <source>Write a note on the sheet of the digraph: click where it should be; a double click changes one</source>
        <translation>Escribir una nota en la hoja del dígrafo: haga clic donde debe estar; un doble clic cambia una</translation>
    </message>
    <message>
        <source>Select one link to rename it, or one note to change it.</source>
        <translation>Seleccione un eslabón para cambiarle el nombre, o una nota para cambiarla.</translation>
    </message>
    <message>
        <source>Move its axis</source>
        <translation>Mover su eje</translation>
    </message>
    <message>
        <source>Move its axis (%1)</source>
        <translation>Mover su eje (%1)</translation>
    </message>
    <message>
        <source>A mesh has no carrier in the T–T graph, or its kind is not known.</source>
        <translation>Un engrane no tiene portador en el grafo T–T, o no se conoce su tipo.</translation>
    </message>
    <message>
        <source>Select one note to change its text.</source>
        <translation>Seleccione una sola nota para cambiar su texto.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>The text on the sheet of the digraph</source>
        <translation>El texto en la hoja del dígrafo</translation>
    </message>
    <message>
        <source>z = %1. Esc puts back</source>
        <translation>z = %1. Esc devuelve</translation>
    </message>
    <message>
        <source>z = %1</source>
        <translation>z = %1</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Nota: %1</translation>
    </message>
    <message>
        <source>Click to select, drag an axis to move it or the rim of a gear for its teeth. The program lays the drawing out</source>
        <translation>Clic para seleccionar; arrastrar un eje lo mueve, arrastrar el borde de una rueda cambia sus dientes. El programa dispone el dibujo</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Measure: click an axis, a pitch point or a gear</source>
        <translation>Medir: haga clic en un eje, un punto primitivo o una rueda</translation>
    </message>
    <message>
        <source>Measure distances, angles and diameters: click an axis, a pitch point or a gear, then another one, in a drawing or in 3D</source>
        <translation>Mide distancias, ángulos y diámetros: haga clic en un eje, un punto primitivo o una rueda y después en otro, en un dibujo o en 3D</translation>
    </message>
    <message>
        <source>This has no place to measure from. Click an axis, a mesh or a gear</source>
        <translation>No hay aquí un lugar desde el que medir. Haga clic en un eje, un engrane o una rueda</translation>
    </message>
    <message>
        <source>%1. Click a second one. Esc takes it back</source>
        <translation>%1. Haga clic en un segundo. Esc lo deshace</translation>
    </message>
    <message>
        <source>%1. Ctrl+C copies the result, Esc goes back</source>
        <translation>%1. Ctrl+C copia el resultado, Esc vuelve atrás</translation>
    </message>
    <message>
        <source>Measure: %1</source>
        <translation>Medir: %1</translation>
    </message>
    <message>
        <source>pitch point of mesh %1</source>
        <translation>punto primitivo del engrane %1</translation>
    </message>
    <message>
        <source>centre of gear %1 in mesh %2</source>
        <translation>centro de la rueda %1 en el engrane %2</translation>
    </message>
    <message>
        <source>face of gear %1 in mesh %2</source>
        <translation>cara de la rueda %1 en el engrane %2</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>centre distance</source>
        <translation>distancia entre ejes</translation>
    </message>
    <message>
        <source>pitch radius</source>
        <translation>radio primitivo</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>along the axes</source>
        <translation>a lo largo de los ejes</translation>
    </message>
    <message>
        <source>pitch diameter</source>
        <translation>diámetro primitivo</translation>
    </message>
    <message>
        <source>pitch diameter of gear %1</source>
        <translation>diámetro primitivo de la rueda %1</translation>
    </message>
    <message>
        <source>tip diameter</source>
        <translation>diámetro de cabeza</translation>
    </message>
    <message>
        <source>root diameter</source>
        <translation>diámetro de pie</translation>
    </message>
    <message>
        <source>face width</source>
        <translation>ancho de cara</translation>
    </message>
    <message>
        <source>--captions are written in the digraph, the T–T graph and the schematic.</source>
        <translation>--captions se escriben en el dígrafo, el grafo T–T y el esquema.</translation>
    </message>
    <message>
        <source>names of links and tooth counts in a digraph, T–T graph or schematic, where there is room</source>
        <translation>nombres de los eslabones y números de dientes en un dígrafo, grafo T–T o esquema, donde haya sitio</translation>
    </message>
    <message>
        <source>Names and teeth</source>
        <translation>Nombres y dientes</translation>
    </message>
    <message>
        <source>Given speeds</source>
        <translation>Velocidades dadas</translation>
    </message>
    <message>
        <source>Given torques</source>
        <translation>Pares dados</translation>
    </message>
    <message>
        <source>No motors</source>
        <translation>Sin motores</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Desde delante</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Desde la derecha</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrica</translation>
    </message>
    <message>
        <source>Lines in sight</source>
        <translation>Líneas visibles</translation>
    </message>
    <message>
        <source>Plane of points</source>
        <translation>Plano de puntos</translation>
    </message>
    <message>
        <source>Layout for projectors</source>
        <translation>Disposición para proyectores</translation>
    </message>
    <message>
        <source>Drawing and 3D alone, the drawing on three fifths of the width, in large type; Reset the layout brings the panels back</source>
        <translation>Solo el dibujo y el 3D, el dibujo en tres quintos del ancho, con letra grande; «Restablecer la disposición» devuelve los paneles</translation>
    </message>
    <message>
        <source>Lessons as &amp;web pages…</source>
        <translation>Lecciones como &amp;páginas web…</translation>
    </message>
    <message>
        <source>Writes all lessons into a folder, with the same grader: pages for any browser, phones too, and packages for learning platforms</source>
        <translation>Escribe todas las lecciones en una carpeta, con la misma corrección: páginas para cualquier navegador, también en teléfonos, y paquetes para plataformas de aprendizaje</translation>
    </message>
    <message>
        <source>Folder in which the lessons&apos; folder is made</source>
        <translation>Carpeta en la que se crea la carpeta de las lecciones</translation>
    </message>
    <message>
        <source>GearGraph lessons</source>
        <translation>Lecciones de GearGraph</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already: no lesson was written.</source>
        <translation>«%1» ya existe: no se escribió ninguna lección.</translation>
    </message>
    <message>
        <source>Range of two motors</source>
        <translation>Zona de dos motores</translation>
    </message>
    <message>
        <source>Parallel lines, as both links turn alike: %1.</source>
        <translation>Líneas paralelas, porque los dos eslabones giran igual: %1.</translation>
    </message>
    <message>
        <source>Note: click on an empty area, or on a note to change it</source>
        <translation>Nota: clic en un área vacía, o en una nota para cambiarla</translation>
    </message>
    <message>
        <source>Handle of %1</source>
        <translation>Asa de %1</translation>
    </message>
    <message>
        <source>Drag to move %1, or use the arrow keys (with Shift: finer). Alt places freely, Esc puts back</source>
        <translation>Arrastre para mover %1, o use las flechas (con Mayús: más fino). Alt coloca libremente, Esc devuelve</translation>
    </message>
    <message>
        <source>the axis of joint %1</source>
        <translation>el eje del par %1</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>motor</translation>
    </message>
    <message>
        <source>labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,velocities,forces,power</source>
        <translation>labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,velocities,forces,power</translation>
    </message>
    <message>
        <source>No power without loads: add one in Forces.</source>
        <translation>No hay potencia sin cargas: añada una en Fuerzas.</translation>
    </message>
    <message>
        <source>No power: the loads are not in balance. Forces names what is missing.</source>
        <translation>No hay potencia: las cargas no están en equilibrio. Fuerzas indica qué falta.</translation>
    </message>
    <message>
        <source>No power without a motion.</source>
        <translation>No hay potencia sin movimiento.</translation>
    </message>
    <message>
        <source>--show names labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, instant-axes, velocities, forces, power, with commas.</source>
        <translation>--show nombra labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, instant-axes, velocities, forces, power, con comas.</translation>
    </message>
    <message>
        <source>2→3: from link 2 to link 3; in the colour of the link that delivers</source>
        <translation>2→3: del eslabón 2 al eslabón 3; en el color del eslabón que entrega</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Configurar página</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Paper:</source>
        <translation>Papel:</translation>
    </message>
    <message>
        <source>Orientation:</source>
        <translation>Orientación:</translation>
    </message>
    <message>
        <source>It could not be read.</source>
        <translation>No se pudo leer.</translation>
    </message>
    <message>
        <source>It has more than %1 bytes.</source>
        <translation>Tiene más de %1 bytes.</translation>
    </message>
    <message>
        <source>This system cannot confine the program that reads 3D files (%1).</source>
        <translation>Este sistema no puede confinar el programa que lee archivos 3D (%1).</translation>
    </message>
    <message>
        <source>Reading it takes more than %1 MiB of memory.</source>
        <translation>Leerlo requiere más de %1 MiB de memoria.</translation>
    </message>
    <message>
        <source>It is damaged: %1</source>
        <translation>Está dañado: %1</translation>
    </message>
    <message>
        <source>case</source>
        <translation>caja</translation>
    </message>
    <message>
        <source>left wheel</source>
        <translation>planetario izquierdo</translation>
    </message>
    <message>
        <source>right wheel</source>
        <translation>planetario derecho</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>satélite</translation>
    </message>
    <message>
        <source>pinion %1</source>
        <translation>satélite %1</translation>
    </message>
    <message>
        <source>housing</source>
        <translation>carcasa</translation>
    </message>
    <message>
        <source>bend shaft</source>
        <translation>eje de flexión</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>flexión</translation>
    </message>
    <message>
        <source>roll shaft</source>
        <translation>eje de giro</translation>
    </message>
    <message>
        <source>idler</source>
        <translation>intermedia</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>herramienta</translation>
    </message>
    <message>
        <source>planet %1</source>
        <translation>satélite %1</translation>
    </message>
    <message>
        <source>countershaft</source>
        <translation>contraeje</translation>
    </message>
    <message>
        <source>output</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>small sun</source>
        <translation>solar pequeño</translation>
    </message>
    <message>
        <source>large sun</source>
        <translation>solar grande</translation>
    </message>
    <message>
        <source>short planet %1</source>
        <translation>satélite corto %1</translation>
    </message>
    <message>
        <source>long planet %1</source>
        <translation>satélite largo %1</translation>
    </message>
    <message>
        <source>suns</source>
        <translation>solares</translation>
    </message>
    <message>
        <source>first ring</source>
        <translation>primera corona</translation>
    </message>
    <message>
        <source>second carrier</source>
        <translation>segundo portasatélites</translation>
    </message>
    <message>
        <source>first planet %1</source>
        <translation>primer satélite %1</translation>
    </message>
    <message>
        <source>second planet %1</source>
        <translation>segundo satélite %1</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>no hay memoria suficiente</translation>
    </message>
    <message>
        <source>%1 mesh</source>
        <translation>%1 engrane</translation>
    </message>
    <message>
        <source>%1 meshes</source>
        <translation>%1 engranes</translation>
    </message>
    <message>
        <source>%1 degree of freedom</source>
        <translation>%1 grado de libertad</translation>
    </message>
    <message>
        <source>%1 degrees of freedom</source>
        <translation>%1 grados de libertad</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Dibujos</translation>
    </message>
    <message>
        <source>Tells the learning platform which parts were seen, and points; loads nothing and sends nothing else.</source>
        <translation>Informa a la plataforma de aprendizaje de las partes vistas y de los puntos; no carga nada ni envía nada más.</translation>
    </message>
    <message>
        <source>Works offline: this file loads nothing and sends nothing.</source>
        <translation>Funciona sin conexión: este archivo no carga ni envía nada.</translation>
    </message>
    <message>
        <source>Made by GearGraph.</source>
        <translation>Hecho con GearGraph.</translation>
    </message>
    <message>
        <source>To the drawings</source>
        <translation>Ir a los dibujos</translation>
    </message>
    <message>
        <source>The train and its solution</source>
        <translation>El tren y su solución</translation>
    </message>
    <message>
        <source>The wheels are coarse: finer ones would make the file too large.</source>
        <translation>Las ruedas son toscas: unas más finas harían el archivo demasiado grande.</translation>
    </message>
    <message>
        <source>From %1 to %2.</source>
        <translation>%1 → %2.</translation>
    </message>
    <message>
        <source>Along joint %1, from %2 to %3: %4.</source>
        <translation>Por el par %1, en su sentido (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Against joint %1, from %2 to %3: %4.</source>
        <translation>Por el par %1, en sentido contrario (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Along mesh %1, from %2 to %3: %4.</source>
        <translation>Por el engrane %1, en su sentido (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Against mesh %1, from %2 to %3: %4.</source>
        <translation>Por el engrane %1, en sentido contrario (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Turning joints: %1.</source>
        <translation>Pares de revolución: %1.</translation>
    </message>
    <message>
        <source>Gear meshes: %1.</source>
        <translation>Engranes: %1.</translation>
    </message>
    <message>
        <source>Its cycle runs along %1 and against %2.</source>
        <translation>Su ciclo recorre %1 en su sentido y %2 en sentido contrario.</translation>
    </message>
    <message>
        <source>Its cycle runs along %1.</source>
        <translation>Su ciclo recorre %1 en su sentido.</translation>
    </message>
    <message>
        <source>Its cycle runs against %1.</source>
        <translation>Su ciclo recorre %1 en sentido contrario.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2 on %3, %4, %5 : %6 teeth.</source>
        <translation>Ruedas: %1 y %2; portasatélites: %3; %4, %5 : %6 dientes.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2 on %3, %4 : %5 teeth.</source>
        <translation>Ruedas: %1 y %2; portasatélites: %3; %4 : %5 dientes.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2, %3, %4 : %5 teeth.</source>
        <translation>Ruedas: %1 y %2; %3, %4 : %5 dientes.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2, %3 : %4 teeth.</source>
        <translation>Ruedas: %1 y %2; %3 : %4 dientes.</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Pista</translation>
    </message>
    <message>
        <source>Answer to question %1</source>
        <translation>Respuesta a la pregunta %1</translation>
    </message>
    <message>
        <source>The answers are hidden in this file, not secret, and other parts of it help: try first.</source>
        <translation>Las respuestas están ocultas en este archivo, no son secretas, y otras partes de él ayudan: inténtelo primero.</translation>
    </message>
    <message>
        <source>Rows of P times the rates (17)</source>
        <translation>Filas de P por las velocidades (17)</translation>
    </message>
    <message>
        <source>Coefficient matrix P (18), (19), in %1</source>
        <translation>Matriz de coeficientes P (18), (19), en %1</translation>
    </message>
    <message>
        <source>Digraph. Solid arrows: turning joints; dashed: gear meshes.</source>
        <translation>Dígrafo. Flechas continuas: pares de revolución; discontinuas: engranes.</translation>
    </message>
    <message>
        <source>Schematic.</source>
        <translation>Esquema.</translation>
    </message>
    <message>
        <source>T-T graph.</source>
        <translation>Grafo T-T.</translation>
    </message>
    <message>
        <source>The train</source>
        <translation>El tren</translation>
    </message>
    <message>
        <source>The train in three dimensions</source>
        <translation>El tren en tres dimensiones</translation>
    </message>
    <message>
        <source>The train turns where scripts may run: open the file in a browser.</source>
        <translation>El tren gira donde se permiten scripts: abra el archivo en un navegador.</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Estados</translation>
    </message>
    <message>
        <source>The mechanism has no solution: its derivation says why.</source>
        <translation>El mecanismo no tiene solución: la deducción dice por qué.</translation>
    </message>
    <message>
        <source>joint %1 at %2 rad/s</source>
        <translation>par %1 a %2 rad/s</translation>
    </message>
    <message>
        <source>Inputs: %1.</source>
        <translation>Entradas: %1.</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>now, rad/s</source>
        <translation>ahora, rad/s</translation>
    </message>
    <message>
        <source>Speeds of the joints</source>
        <translation>Velocidades de los pares</translation>
    </message>
    <message>
        <source>Arrow keys walk its elements.</source>
        <translation>Las teclas de flecha recorren sus elementos.</translation>
    </message>
    <message>
        <source>Speed of joint %1</source>
        <translation>Velocidad del par %1</translation>
    </message>
    <message>
        <source>Speed of joint %1, exact, rad/s</source>
        <translation>Velocidad del par %1, exacta, rad/s</translation>
    </message>
    <message>
        <source>A number such as 2, -3/4 or 0.75.</source>
        <translation>Un número como 2, -3/4 o 0,75.</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>Claro u oscuro</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dibujo</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>Walk round the cycle: left and right arrow keys step, Escape ends</source>
        <translation>Recorrido del ciclo: las flechas izquierda y derecha avanzan paso a paso, Escape termina</translation>
    </message>
    <message>
        <source>%1 of %2. %3</source>
        <translation>%1 de %2. %3</translation>
    </message>
    <message>
        <source>The walk is closed: row C%1 has no other entries.</source>
        <translation>El recorrido está cerrado: la fila C%1 no tiene otras entradas.</translation>
    </message>
    <message>
        <source>Walk the cycle</source>
        <translation>Recorrer el ciclo</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Quitar la selección</translation>
    </message>
    <message>
        <source>Now %1 rad/s.</source>
        <translation>Ahora %1 rad/s.</translation>
    </message>
    <message>
        <source>The train in three dimensions. Arrow keys turn it, plus and minus zoom, Space plays, comma and full stop step.</source>
        <translation>El tren en tres dimensiones. Las flechas lo giran, más y menos amplían y reducen, Espacio reproduce, coma y punto avanzan paso a paso.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>%1 s of %2 s</source>
        <translation>%1 s de %2 s</translation>
    </message>
    <message>
        <source>To the reference pose</source>
        <translation>A la posición de referencia</translation>
    </message>
    <message>
        <source>%1 is at its limit of %2°.</source>
        <translation>%1 está en su límite de %2°.</translation>
    </message>
    <message>
        <source>%1 has reached its limit of %2°: the motion turns round.</source>
        <translation>%1 ha llegado a su límite de %2°: el movimiento da la vuelta.</translation>
    </message>
    <message>
        <source>Whole train, from the corner</source>
        <translation>Todo el tren, desde la esquina</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>A lo largo de %1</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>This browser cannot show the train in three dimensions (%1).</source>
        <translation>Este navegador no puede mostrar el tren en tres dimensiones (%1).</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>Fila %1, columna %2</translation>
    </message>
    <message>
        <source>Look at %1 in the drawing.</source>
        <translation>Mire en el dibujo: %1.</translation>
    </message>
    <message>
        <source>Fills the cell and goes on to the next</source>
        <translation>Rellena la celda y pasa a la siguiente</translation>
    </message>
    <message>
        <source>Right, %1 of 1 point</source>
        <translation>Correcto, %1 de 1 punto</translation>
    </message>
    <message>
        <source>Right, %1 of %2 points</source>
        <translation>Correcto, %1 de %2 puntos</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Incorrecto</translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <translation>Incorrecto: %1</translation>
    </message>
    <message>
        <source>The other field is right.</source>
        <translation>El otro campo es correcto.</translation>
    </message>
    <message>
        <source>The other %1 fields are right.</source>
        <translation>Los otros %1 campos son correctos.</translation>
    </message>
    <message>
        <source>No known mistake explains it. Walk through it once more, or let it be shown.</source>
        <translation>Ningún error conocido lo explica. Repáselo una vez más o haga que se muestre la solución.</translation>
    </message>
    <message>
        <source>Shown, no points</source>
        <translation>Mostrado, sin puntos</translation>
    </message>
    <message>
        <source>%1 of the mechanism</source>
        <translation>%1 del mecanismo</translation>
    </message>
    <message>
        <source>%1 of 1 point; %2 of %3 checked</source>
        <translation>%1 de 1 punto; %2 de %3 comprobadas</translation>
    </message>
    <message>
        <source>%1 of %2 points; %3 of %4 checked</source>
        <translation>%1 de %2 puntos; %3 de %4 comprobadas</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Pregunta %1 de %2</translation>
    </message>
    <message>
        <source>Previous question</source>
        <translation>Pregunta anterior</translation>
    </message>
    <message>
        <source>Next question</source>
        <translation>Pregunta siguiente</translation>
    </message>
    <message>
        <source>Save answers</source>
        <translation>Guardar respuestas</translation>
    </message>
    <message>
        <source>Enlarge: %1</source>
        <translation>Ampliar: %1</translation>
    </message>
    <message>
        <source>Fit the window</source>
        <translation>Ajustar a la ventana</translation>
    </message>
    <message>
        <source>Print the questions</source>
        <translation>Imprimir las preguntas</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Paso anterior</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Paso siguiente</translation>
    </message>
    <message>
        <source>Hint %1 of %2</source>
        <translation>Pista %1 de %2</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Pistas</translation>
    </message>
    <message>
        <source>Of the files of %1, %2 counts.</source>
        <translation>De los archivos de %1 cuenta %2.</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Estudiantes</translation>
    </message>
    <message>
        <source>not right: %1</source>
        <translation>no correctas: %1</translation>
    </message>
    <message>
        <source>--to lists forms out of html and scorm, not &quot;%1&quot;.</source>
        <translation>--to enumera formas entre html y scorm, no «%1».</translation>
    </message>
    <message>
        <source>the pages</source>
        <translation>las páginas</translation>
    </message>
    <message>
        <source>%1 has no meaning for lesson %2.</source>
        <translation>%1 no significa nada en lesson %2.</translation>
    </message>
    <message>
        <source>list needs no file.</source>
        <translation>list no necesita ningún archivo.</translation>
    </message>
    <message>
        <source>forms: html for browsers, scorm for learning platforms (html)</source>
        <translation>formas: html para navegadores, scorm para plataformas de aprendizaje (html)</translation>
    </message>
    <message>
        <source>a folder for the pages and packages</source>
        <translation>una carpeta para las páginas y los paquetes</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Start again? All answers and the name on this device are deleted.</source>
        <translation>¿Empezar de nuevo? Se borran todas las respuestas y el nombre de este dispositivo.</translation>
    </message>
    <message>
        <source>What you write stays in this browser. Saved answers are a small file to hand in.</source>
        <translation>Lo que escribe queda en este navegador. Las respuestas guardadas son un archivo pequeño para entregar.</translation>
    </message>
    <message>
        <source>This browser cannot grade the answers (%1): write them on paper.</source>
        <translation>Este navegador no puede calificar las respuestas (%1): escríbalas en papel.</translation>
    </message>
    <message>
        <source>The 3D file has %1 faces, more than the limit of %2.</source>
        <translation>El archivo 3D tiene %1 caras, más que el límite de %2.</translation>
    </message>
    <message>
        <source>It is damaged: its header has no end.</source>
        <translation>Está dañado: su cabecera no tiene fin.</translation>
    </message>
    <message>
        <source>It is damaged: a face names a vertex that is not there.</source>
        <translation>Está dañado: una cara nombra un vértice que no existe.</translation>
    </message>
    <message>
        <source>It has no faces that could be shown.</source>
        <translation>No tiene caras que puedan mostrarse.</translation>
    </message>
    <message>
        <source>The motion repeats only after %1 turns of what turns at 1 rad/s; that is too long for an animation.</source>
        <translation>El movimiento solo se repite tras %1 vueltas de lo que gira a 1 rad/s; es demasiado largo para una animación.</translation>
    </message>
    <message>
        <source>The motion is too fast for an animation that long.</source>
        <translation>El movimiento es demasiado rápido para una animación tan larga.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Detenido; no se escribió nada.</translation>
    </message>
    <message>
        <source>The scene has %1 triangles, more than the limit of %2; choose a coarser tolerance.</source>
        <translation>La escena tiene %1 triángulos, más que el límite de %2; elija una tolerancia más gruesa.</translation>
    </message>
    <message>
        <source>The scene has coordinates beyond 3.4e38, the largest that 3D files hold; bring the parts nearer to each other, or scale them down.</source>
        <translation>La escena tiene coordenadas mayores que 3,4e38, las mayores que admiten los archivos 3D; acerque las piezas o redúzcalas.</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; is written as &quot;%2&quot;.</source>
        <translation>El eslabón «%1» se escribe como «%2».</translation>
    </message>
    <message>
        <source>Link %1 has too little mass or inertia for simulators, which take 1e-15 kg and kg m² and more. Is the unit of length right?</source>
        <translation>El eslabón %1 tiene muy poca masa o inercia para los simuladores, que admiten desde 1e-15 kg y kg m². ¿Es correcta la unidad de longitud?</translation>
    </message>
    <message>
        <source>Coupling %1 would close a linkage and is left out.</source>
        <translation>El acoplamiento %1 cerraría un mecanismo articulado y se omite.</translation>
    </message>
    <message>
        <source>Joint %1 follows %2 (q%1 = %3)</source>
        <translation>El par %1 sigue a %2 (q%1 = %3)</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; y %2 más</translation>
    </message>
    <message>
        <source>A joint of URDF can follow one other joint. %1. Use --to mjcf, or --state with one freedom.</source>
        <translation>Un par de URDF puede seguir a un solo par. %1. Use --to mjcf, o --state con un grado de libertad.</translation>
    </message>
    <message>
        <source>2→3: from link 2 to link 3</source>
        <translation>2→3: del eslabón 2 al eslabón 3</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>%1 more: select links in a drawing first</source>
        <translation>%1 más: seleccione antes los eslabones en un dibujo</translation>
    </message>
    <message>
        <source>There is more on the left</source>
        <translation>Hay más a la izquierda</translation>
    </message>
    <message>
        <source>There is more on the right</source>
        <translation>Hay más a la derecha</translation>
    </message>
    <message>
        <source>They have no properties that could be changed together.</source>
        <translation>No tienen propiedades que se puedan cambiar juntas.</translation>
    </message>
    <message>
        <source>Its joints have its place and direction: select one to change them.</source>
        <translation>Su posición y su dirección están en sus pares: seleccione uno para cambiarlas.</translation>
    </message>
    <message>
        <source>Brake %1</source>
        <translation>Freno %1</translation>
    </message>
    <message>
        <source>Clutch %1</source>
        <translation>Embrague %1</translation>
    </message>
    <message>
        <source>While it is engaged the brake holds its link.</source>
        <translation>Mientras está activado, el freno sujeta su eslabón.</translation>
    </message>
    <message>
        <source>While it is engaged the clutch makes its links turn as one.</source>
        <translation>Mientras está activado, el embrague hace girar juntos sus eslabones.</translation>
    </message>
    <message>
        <source>At most %1 inputs are listed.</source>
        <translation>Se enumeran como máximo %1 entradas.</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: their masses and their motion appear here.</source>
        <translation>Dibuje pares de revolución y engranes: aquí aparecen sus masas y su movimiento.</translation>
    </message>
    <message>
        <source>Nothing can turn here: without an input there is no equation of motion.</source>
        <translation>Aquí nada puede girar: sin una entrada no hay ecuación de movimiento.</translation>
    </message>
    <message>
        <source>This train has too many inputs and joints: dynamics is computed for up to %1 entries of the solution.</source>
        <translation>Este tren tiene demasiadas entradas y pares: la dinámica se calcula hasta %1 entradas de la solución.</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>cinética</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potencial</translation>
    </message>
    <message>
        <source>work done</source>
        <translation>trabajo realizado</translation>
    </message>
    <message>
        <source>energy balance</source>
        <translation>balance de energía</translation>
    </message>
    <message>
        <source>Torques of the motors</source>
        <translation>Momentos de los motores</translation>
    </message>
    <message>
        <source>Energy gained and work done</source>
        <translation>Energía ganada y trabajo realizado</translation>
    </message>
    <message>
        <source>No tooth counts within these limits come near this ratio with this sign. What fits: wider limits, or other members.</source>
        <translation>Ningún número de dientes dentro de estos límites se acerca a esta relación con este signo. Sirven límites más amplios u otros miembros.</translation>
    </message>
    <message>
        <source>%1 is no regular file.</source>
        <translation>%1 no es un archivo normal.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB, which no answers are.</source>
        <translation>%1 ocupa más de %2 MB, lo que no ocupa ninguna respuesta.</translation>
    </message>
    <message>
        <source>Answers that cannot be read: %1.</source>
        <translation>Respuestas ilegibles: %1.</translation>
    </message>
    <message>
        <source>“%1” cannot be read from “%2” on: write a whole number, a fraction such as −3/4 or a decimal.</source>
        <translation>«%1» no se puede leer a partir de «%2»: escriba un número entero, una fracción como −3/4 o un decimal.</translation>
    </message>
    <message>
        <source>“%1” cannot be read from “%2” on: this question knows no such symbol.</source>
        <translation>«%1» no se puede leer a partir de «%2»: esta pregunta no conoce ese símbolo.</translation>
    </message>
    <message>
        <source>“%1” has the unit %2: write the number in %3.</source>
        <translation>«%1» tiene la unidad %2: escriba el número en %3.</translation>
    </message>
    <message>
        <source>“%1” has the unit %2: write a number without a unit.</source>
        <translation>«%1» tiene la unidad %2: escriba un número sin unidad.</translation>
    </message>
    <message>
        <source>%1 fields are empty: %2.</source>
        <translation>%1 campos están vacíos: %2.</translation>
    </message>
    <message>
        <source>symbol that the question does not know</source>
        <translation>símbolo que la pregunta no conoce</translation>
    </message>
    <message>
        <source>number in another unit</source>
        <translation>número en otra unidad</translation>
    </message>
    <message>
        <source>A number is needed here.</source>
        <translation>Aquí hace falta un número.</translation>
    </message>
    <message>
        <source>the same number makes the same sheets everywhere (random)</source>
        <translation>el mismo número hace las mismas hojas en todas partes (al azar)</translation>
    </message>
    <message>
        <source>--seed %1 makes these sheets again.</source>
        <translation>--seed %1 vuelve a hacer estas hojas.</translation>
    </message>
    <message>
        <source>--seed %1 asks these questions again.</source>
        <translation>--seed %1 vuelve a hacer estas preguntas.</translation>
    </message>
    <message>
        <source>Cannot be read: %1</source>
        <translation>No se puede leer: %1</translation>
    </message>
    <message>
        <source>Easy</source>
        <translation>Fácil</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medio</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Difícil</translation>
    </message>
    <message>
        <source>The document has no link &quot;%1&quot;.</source>
        <translation>El documento no tiene el eslabón «%1».</translation>
    </message>
    <message>
        <source>With these losses no torques are known.</source>
        <translation>Con estas pérdidas no se conocen los momentos.</translation>
    </message>
    <message>
        <source>No power: with these losses no torques are known.</source>
        <translation>Sin potencia: con estas pérdidas no se conocen los momentos.</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>driven</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>Torques in N m</source>
        <translation>Momentos en N m</translation>
    </message>
    <message>
        <source>--torque is a torque like 100Nm, not &quot;%1&quot;.</source>
        <translation>--torque es un momento como 100Nm, no «%1».</translation>
    </message>
    <message>
        <source>at the drive of every state, instead of the document&apos;s</source>
        <translation>en la entrada de cada estado, en vez del momento del documento</translation>
    </message>
    <message>
        <source>efficiency of meshes that state none</source>
        <translation>rendimiento de los engranes que no indican ninguno</translation>
    </message>
    <message>
        <source>&quot;none&quot; or &quot;stiffness&quot;</source>
        <translation>&quot;none&quot; o &quot;stiffness&quot;</translation>
    </message>
    <message>
        <source>none, stiffness or nothing</source>
        <translation>none, stiffness o nada</translation>
    </message>
    <message>
        <source>No forces: with these losses no torques are known. Forces tells why.</source>
        <translation>Sin fuerzas: con estas pérdidas no se conocen los momentos. Fuerzas dice por qué.</translation>
    </message>
    <message>
        <source>The torque that holds the loads: at the driven link, or at the drive where loads on the driven link alone are given.</source>
        <translation>El momento que equilibra las cargas: en la salida, o en la entrada donde solo hay cargas en la salida.</translation>
    </message>
    <message>
        <source>The loads on %1 act as well.</source>
        <translation>También actúan las cargas en %1.</translation>
    </message>
    <message>
        <source>The torque at the drive takes the place of the loads on %1.</source>
        <translation>El momento en la entrada sustituye a las cargas en %1.</translation>
    </message>
    <message>
        <source>State %1: link %2 turns freely beside it, at any speed. The ratio does not depend on it.</source>
        <translation>Estado %1: el eslabón %2 gira libre al lado, a cualquier velocidad. La relación no depende de él.</translation>
    </message>
    <message>
        <source>State %1: links %2 turn freely beside it, at any speed. The ratio does not depend on them.</source>
        <translation>Estado %1: los eslabones %2 giran libres al lado, a cualquier velocidad. La relación no depende de ellos.</translation>
    </message>
    <message>
        <source>%1: %2 N m</source>
        <translation>%1: %2 N m</translation>
    </message>
    <message>
        <source>%1: %2 to %3 N m</source>
        <translation>%1: de %2 a %3 N m</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too: they are given for equally stiff teeth, an assumption.</source>
        <translation>Con pérdidas también dependen de ello los momentos de fuera: se dan para dientes de igual rigidez, una suposición.</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too, and are not given.</source>
        <translation>Con pérdidas también dependen de ello los momentos de fuera, y no se dan.</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too, and are not given: share by stiffness to find them.</source>
        <translation>Con pérdidas también dependen de ello los momentos de fuera, y no se dan: reparta por rigidez para hallarlos.</translation>
    </message>
    <message>
        <source>Speeds are not determined, so that nothing tells which gears drive: with losses, torques and powers are left out. Give inputs their speeds, or choose a state of one degree of freedom.</source>
        <translation>Las velocidades no están determinadas, así que nada dice qué ruedas accionan: con pérdidas se omiten momentos y potencias. Dé velocidades a las entradas o elija un estado de un grado de libertad.</translation>
    </message>
    <message>
        <source>All speeds are 0: at rest no power is lost, so that torques are those without losses. Give inputs their speeds.</source>
        <translation>Todas las velocidades son 0: en reposo no se pierde potencia, así que los momentos son los de sin pérdidas. Dé velocidades a las entradas.</translation>
    </message>
    <message>
        <source>The load on %1 acts where the balance at %2 holds, which cancels it: no mesh passes any of it, and it counts for no efficiency. To find what it drives, put the balance elsewhere.</source>
        <translation>La carga en %1 actúa donde sostiene la equilibrante en %2, que la anula: ningún engrane transmite nada de ella y no cuenta para el rendimiento. Para hallar qué acciona, ponga la equilibrante en otro sitio.</translation>
    </message>
    <message>
        <source>Which gears drive was not decided: the rounds of guesses do not settle, and %1 leave too many patterns to try all of them. Torques and powers are left out.</source>
        <translation>No se decidió qué ruedas accionan: las rondas de suposiciones no se estabilizan, y %1 dejan demasiadas combinaciones para probarlas todas. Se omiten momentos y potencias.</translation>
    </message>
    <message>
        <source>With these losses no torques are known: the reason is below.</source>
        <translation>Con estas pérdidas no se conocen los momentos: la razón está abajo.</translation>
    </message>
    <message>
        <source>Set load sharing</source>
        <translation>Fijar el reparto de cargas</translation>
    </message>
    <message>
        <source>With these losses no torques are known: Forces tells why.</source>
        <translation>Con estas pérdidas no se conocen los momentos: Fuerzas dice por qué.</translation>
    </message>
    <message>
        <source>At the drive of every state, about its first axis; empty: that of the loads at drives, else 1 N m</source>
        <translation>En la entrada de cada estado, en torno a su primer eje; vacío: el de las cargas en las entradas o, si no, 1 N m</translation>
    </message>
    <message>
        <source>Torque at the drive, N m</source>
        <translation>Momento en la entrada, N m</translation>
    </message>
    <message>
        <source>Set torque at the drive</source>
        <translation>Fijar el momento en la entrada</translation>
    </message>
    <message>
        <source>Torques in N m, for %1 N m at the drive.</source>
        <translation>Momentos en N m, para %1 N m en la entrada.</translation>
    </message>
    <message>
        <source>For any sharing in which no mesh works against the others: %1.</source>
        <translation>Con cualquier reparto en que ningún engrane trabaje contra los demás: %1.</translation>
    </message>
    <message>
        <source>%1 is now %2</source>
        <translation>%1 es ahora %2</translation>
    </message>
    <message>
        <source>New numbers: %1</source>
        <translation>Números nuevos: %1</translation>
    </message>
    <message>
        <source>New numbers: %1, and %2 more</source>
        <translation>Números nuevos: %1 y %2 más</translation>
    </message>
    <message>
        <source>an object of whole numbers by the id of their link</source>
        <translation>un objeto de números enteros bajo el id de su eslabón</translation>
    </message>
    <message>
        <source>expected the number of a link&apos;s colour: a whole number from 1 on.</source>
        <translation>se esperaba el número del color de un eslabón: un entero desde 1.</translation>
    </message>
    <message>
        <source>%1 is a whole number, %2 to %3.</source>
        <translation>%1 es un número entero de %2 a %3.</translation>
    </message>
    <message>
        <source>A chain is links, axes and gear pairs, each pair with the link that carries both gears. Frame, teeth, kinds of gears
and the joints by which coaxial links are drawn do not matter. Equations: rotation graphs, the triples gear, gear, carrier.
Chains: displacement graphs, which tell shafts apart, too. Left out: chains where m gear pairs have fewer than m + 2
links between them, so that these turn as one; the smallest of them are listed with freedom 0.</source>
        <translation>Una cadena son eslabones, ejes y pares de engranajes, cada par con el eslabón que lleva las dos ruedas. No cuentan el
bastidor, los dientes, los tipos de rueda ni las articulaciones con que se dibujan los eslabones coaxiales. Ecuaciones:
grafos de rotación, las ternas rueda, rueda, portasatélites. Cadenas: grafos de desplazamiento, que distinguen también los
árboles. Quedan fuera las cadenas en las que m pares tienen menos de m + 2 eslabones, de modo que estos giran como uno
solo; las más pequeñas figuran con 0 grados de libertad.</translation>
    </message>
    <message>
        <source>Counts of chains with 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301: 27 and 81 with 6 links, 152
and 647 with 7, 1070 and 6360 with 8. Nonfractionated chains with 2 freedoms: see Tsai, Lin, J. Mech. Transm. Autom. Des.
111(4), 1989, 524.</source>
        <translation>Números de cadenas con 1 grado de libertad como en Yang, Ding y otros, J. Mech. Des. 141(4), 2019, 043301: 27 y 81 con
6 eslabones, 152 y 647 con 7, 1070 y 6360 con 8. Cadenas no fraccionadas con 2 grados de libertad: véase Tsai, Lin,
J. Mech. Transm. Autom. Des. 111(4), 1989, 524.</translation>
    </message>
    <message>
        <source>freedom</source>
        <translation>libertad</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>ecuaciones</translation>
    </message>
    <message>
        <source>chains</source>
        <translation>cadenas</translation>
    </message>
    <message>
        <source>nonfractionated equations</source>
        <translation>ecuaciones no fraccionadas</translation>
    </message>
    <message>
        <source>Geared kinematic chains, one link held</source>
        <translation>Cadenas cinemáticas de engranajes, un eslabón fijo</translation>
    </message>
    <message>
        <source>number</source>
        <translation>número</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>ejes</translation>
    </message>
    <message>
        <source>gear pairs / carrier</source>
        <translation>pares / portasatélites</translation>
    </message>
    <message>
        <source>Equations: %1, chains: %2</source>
        <translation>Ecuaciones: %1, cadenas: %2</translation>
    </message>
    <message>
        <source>Chain %1</source>
        <translation>Cadena %1</translation>
    </message>
    <message>
        <source>axes: %1</source>
        <translation>ejes: %1</translation>
    </message>
    <message>
        <source>gear pairs / carrier: %1</source>
        <translation>pares / portasatélites: %1</translation>
    </message>
    <message>
        <source>%1 has no meaning with a number of a chain.</source>
        <translation>%1 no tiene sentido con el número de una cadena.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number of a chain, as 6-1.5.1 is.</source>
        <translation>«%1» no es el número de una cadena, como 6-1.5.1.</translation>
    </message>
    <message>
        <source>The atlas has no chain %1.</source>
        <translation>El atlas no tiene la cadena %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; are equations; a document needs a chain, as %2 is.</source>
        <translation>«%1» son ecuaciones; un documento necesita una cadena, como %2.</translation>
    </message>
    <message>
        <source>One number is enough.</source>
        <translation>Basta un número.</translation>
    </message>
    <message>
        <source>%1 needs the number of a chain.</source>
        <translation>%1 necesita el número de una cadena.</translation>
    </message>
    <message>
        <source>The atlas has chains of up to %1 links with this freedom.</source>
        <translation>Con estos grados de libertad el atlas tiene cadenas de hasta %1 eslabones.</translation>
    </message>
    <message>
        <source>only chains of so many links (3 to 7)</source>
        <translation>solo cadenas con tantos eslabones (3 a 7)</translation>
    </message>
    <message>
        <source>of this freedom: 1 (the default), 2, or 0: trains that cannot turn</source>
        <translation>con esta libertad: 1 (lo normal), 2, o 0: trenes que no pueden girar</translation>
    </message>
    <message>
        <source>with so many axes</source>
        <translation>con tantos ejes</translation>
    </message>
    <message>
        <source>that no link parts, every link in a gear pair</source>
        <translation>que ningún eslabón divide, cada eslabón en un par</translation>
    </message>
    <message>
        <source>write the chain of the number as a document</source>
        <translation>escribe la cadena de ese número como documento</translation>
    </message>
    <message>
        <source>With a number</source>
        <translation>Con un número</translation>
    </message>
    <message>
        <source>the link that is held</source>
        <translation>el eslabón fijo</translation>
    </message>
    <message>
        <source>a gear pair, by its place, with a ring gear; may be repeated</source>
        <translation>un par, por su lugar, con una corona; se puede repetir</translation>
    </message>
    <message>
        <source>another atlas than the program&apos;s (of geargraph-make-atlas)</source>
        <translation>otro atlas que el del programa (de geargraph-make-atlas)</translation>
    </message>
    <message>
        <source>Counts and lists geared kinematic chains; writes one as a document.</source>
        <translation>Cuenta y enumera cadenas cinemáticas de engranajes; escribe una como documento.</translation>
    </message>
    <message>
        <source>same equations, other shafts: %1</source>
        <translation>mismas ecuaciones, otros árboles: %1</translation>
    </message>
    <message>
        <source>one gear pair less: %1</source>
        <translation>un par menos: %1</translation>
    </message>
    <message>
        <source>one gear pair more: %1</source>
        <translation>un par más: %1</translation>
    </message>
    <message>
        <source>links that differ as the frame: %1</source>
        <translation>eslabones distintos como bastidor: %1</translation>
    </message>
    <message>
        <source>cannot turn: %1 gear pairs between %2 links, of which one is held</source>
        <translation>no puede girar: %1 pares entre %2 eslabones, uno de ellos fijo</translation>
    </message>
    <message>
        <source>Trains of more than %1 links are not identified.</source>
        <translation>No se identifican trenes de más de %1 eslabones.</translation>
    </message>
    <message>
        <source>the identification</source>
        <translation>la identificación</translation>
    </message>
    <message>
        <source>A chain that is not in the atlas</source>
        <translation>Una cadena que no está en el atlas</translation>
    </message>
    <message>
        <source>links: %1</source>
        <translation>eslabones: %1</translation>
    </message>
    <message>
        <source>meshes: %1</source>
        <translation>engranes: %1</translation>
    </message>
    <message>
        <source>freedom: %1</source>
        <translation>libertad: %1</translation>
    </message>
    <message>
        <source>locked: two of its links turn as one in every motion</source>
        <translation>bloqueada: dos de sus eslabones giran como uno en todo movimiento</translation>
    </message>
    <message>
        <source>turns by these tooth counts only; with others it would be locked</source>
        <translation>gira solo con estos números de dientes; con otros estaría bloqueada</translation>
    </message>
    <message>
        <source>Left out: link %1, a planet that repeats another</source>
        <translation>Fuera: el eslabón %1, un planeta que repite otro</translation>
    </message>
    <message>
        <source>Left out: link %1, in no mesh</source>
        <translation>Fuera: el eslabón %1, en ningún engrane</translation>
    </message>
    <message>
        <source>There is no mesh.</source>
        <translation>No hay ningún engrane.</translation>
    </message>
    <message>
        <source>%1 and %2 are different chains.</source>
        <translation>%1 y %2 son cadenas distintas.</translation>
    </message>
    <message>
        <source>%1 and %2 are the same chain.</source>
        <translation>%1 y %2 son la misma cadena.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same equations, on other shafts.</source>
        <translation>%1 y %2 tienen las mismas ecuaciones, en otros árboles.</translation>
    </message>
    <message>
        <source>another document: is it the same chain, and which link is which?</source>
        <translation>otro documento: ¿es la misma cadena, y qué eslabón es cuál?</translation>
    </message>
    <message>
        <source>Which chains of the atlas a train is made of.</source>
        <translation>De qué cadenas del atlas se compone un tren.</translation>
    </message>
    <message>
        <source>link %1 of the chain</source>
        <translation>eslabón %1 de la cadena</translation>
    </message>
    <message>
        <source>This is no atlas of chains.</source>
        <translation>Esto no es un atlas de cadenas.</translation>
    </message>
    <message>
        <source>This line of the atlas is no chain with its number.</source>
        <translation>Esta línea del atlas no es una cadena con su número.</translation>
    </message>
    <message>
        <source>Chain %1 is not at its place in the atlas, or there twice.</source>
        <translation>La cadena %1 no está en su lugar del atlas, o está dos veces.</translation>
    </message>
    <message>
        <source>also the trees, inputs and frames by which the train can be drawn</source>
        <translation>también los árboles, entradas y bastidores con que se puede dibujar el tren</translation>
    </message>
    <message>
        <source>with --choices: how many of each are listed (100)</source>
        <translation>con --choices: cuántos de cada uno se enumeran (100)</translation>
    </message>
    <message>
        <source>over 2^63</source>
        <translation>más de 2^63</translation>
    </message>
    <message>
        <source>Trees of turning joints: %1</source>
        <translation>Árboles de articulaciones: %1</translation>
    </message>
    <message>
        <source>Valid sets of inputs, as pairs of links: %1</source>
        <translation>Conjuntos válidos de entradas, como pares de eslabones: %1</translation>
    </message>
    <message>
        <source>Links that differ as the frame: %1</source>
        <translation>Eslabones distintos como bastidor: %1</translation>
    </message>
    <message>
        <source>There are more than %1 sets of inputs to try; they are not listed.</source>
        <translation>Habría que probar más de %1 conjuntos de entradas; no se enumeran.</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>juego %1</translation>
    </message>
    <message>
        <source>sets %1</source>
        <translation>juegos %1</translation>
    </message>
    <message>
        <source>No lever: the train is not finished. Problems tells what is missing.</source>
        <translation>Ninguna palanca: el tren no está terminado. Problemas indica qué falta.</translation>
    </message>
    <message>
        <source>No lever: no mesh joins two links on the ground&apos;s axis.</source>
        <translation>Ninguna palanca: ningún engrane une dos eslabones en el eje del bastidor.</translation>
    </message>
    <message>
        <source>No lever: no link on the ground&apos;s axis can turn.</source>
        <translation>Ninguna palanca: ningún eslabón en el eje del bastidor puede girar.</translation>
    </message>
    <message>
        <source>No lever: mesh %1 leads to an axis of another direction. Bevel pinions have no place on a lever, and their side gears are not joined to another link on the ground&apos;s axis.</source>
        <translation>Ninguna palanca: el engrane %1 lleva a un eje de otra dirección. Los piñones cónicos no tienen lugar en una palanca, y sus ruedas laterales no están unidas a otro eslabón en el eje del bastidor.</translation>
    </message>
    <message>
        <source>No lever: the train has more links and freedoms than levers are drawn for.</source>
        <translation>Ninguna palanca: el tren tiene más eslabones y libertades de los que se dibujan como palancas.</translation>
    </message>
    <message>
        <source>dashed: by these tooth counts only</source>
        <translation>a trazos: solo con estos números de dientes</translation>
    </message>
    <message>
        <source>Links %1 turn as one.</source>
        <translation>Los eslabones %1 giran como uno solo.</translation>
    </message>
    <message>
        <source>Arrows: speeds in rad/s.</source>
        <translation>Flechas: velocidades en rad/s.</translation>
    </message>
    <message>
        <source>Arrows to the right of the bars: speeds in rad/s; to the left: torques on the lever in N m.</source>
        <translation>Flechas a la derecha de las barras: velocidades en rad/s; a la izquierda: momentos sobre la palanca en N m.</translation>
    </message>
    <message>
        <source>No states yet: a state engages brakes and clutches and names its drive.</source>
        <translation>Aún no hay estados: un estado acciona frenos y embragues y nombra su entrada.</translation>
    </message>
    <message>
        <source>No state has one motion: each is locked or free.</source>
        <translation>Ningún estado tiene un solo movimiento: cada uno está bloqueado o libre.</translation>
    </message>
    <message>
        <source>The plan shows two freedoms; the links on the ground&apos;s axis have %1.</source>
        <translation>El plano muestra dos libertades; los eslabones en el eje del bastidor tienen %1.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>lugar</translation>
    </message>
    <message>
        <source>no set</source>
        <translation>ningún juego</translation>
    </message>
    <message>
        <source>%1: 1 lever, freedom %2</source>
        <translation>%1: 1 palanca, grado de libertad %2</translation>
    </message>
    <message>
        <source>%1: %2 levers, freedom %3</source>
        <translation>%1: %2 palancas, grado de libertad %3</translation>
    </message>
    <message>
        <source>* there by these tooth counts only</source>
        <translation>* ahí solo con estos números de dientes</translation>
    </message>
    <message>
        <source>the levers</source>
        <translation>las palancas</translation>
    </message>
    <message>
        <source>The levers of a train: where the links of the ground&apos;s axis have their points.</source>
        <translation>Las palancas de un tren: dónde tienen sus puntos los eslabones del eje del bastidor.</translation>
    </message>
    <message>
        <source>modules</source>
        <translation>módulos</translation>
    </message>
    <message>
        <source>gears</source>
        <translation>ruedas</translation>
    </message>
    <message>
        <source>GLB, in motion</source>
        <translation>GLB, en movimiento</translation>
    </message>
    <message>
        <source>Assembly: gears with their poses</source>
        <translation>Montaje: ruedas con sus posiciones</translation>
    </message>
    <message>
        <source>gears for a check</source>
        <translation>ruedas para una comprobación</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Sólidos</translation>
    </message>
    <message>
        <source>Checks of teeth</source>
        <translation>Comprobación de los dientes</translation>
    </message>
    <message>
        <source>a model of the joints</source>
        <translation>un modelo de los pares</translation>
    </message>
    <message>
        <source>Models of the joints</source>
        <translation>Modelos de los pares</translation>
    </message>
    <message>
        <source>the worked derivation</source>
        <translation>la deducción desarrollada</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>Deducciones</translation>
    </message>
    <message>
        <source>derivations</source>
        <translation>deducciones</translation>
    </message>
    <message>
        <source>No power flows, or what there is of loads and motion does not determine it.</source>
        <translation>No fluye potencia, o las cargas y el movimiento no la determinan.</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>una imagen</translation>
    </message>
    <message>
        <source>drawings</source>
        <translation>dibujos</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree.</source>
        <translation>Los pares de revolución no forman un árbol generador.</translation>
    </message>
    <message>
        <source>The mechanism has errors.</source>
        <translation>El mecanismo tiene errores.</translation>
    </message>
    <message>
        <source>There is no solution, because nothing can move or inputs are missing.</source>
        <translation>No hay solución, porque nada puede moverse o faltan entradas.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree, or a mesh has no carrier.</source>
        <translation>Los pares de revolución no forman un árbol generador, o un engrane no tiene portasatélites.</translation>
    </message>
    <message>
        <source>a graph</source>
        <translation>un grafo</translation>
    </message>
    <message>
        <source>Graphs</source>
        <translation>Grafos</translation>
    </message>
    <message>
        <source>graphs</source>
        <translation>grafos</translation>
    </message>
    <message>
        <source>The mechanism has no such table.</source>
        <translation>El mecanismo no tiene tal tabla.</translation>
    </message>
    <message>
        <source>matrices</source>
        <translation>matrices</translation>
    </message>
    <message>
        <source>CSV, one matrix or table</source>
        <translation>CSV, una matriz o tabla</translation>
    </message>
    <message>
        <source>CSV, all matrices and tables</source>
        <translation>CSV, todas las matrices y tablas</translation>
    </message>
    <message>
        <source>Handouts</source>
        <translation>Hojas interactivas</translation>
    </message>
    <message>
        <source>Simulators</source>
        <translation>Simuladores</translation>
    </message>
    <message>
        <source>%1 with --view</source>
        <translation>%1 con --view</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Without labels</source>
        <translation>Sin etiquetas</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>With exercises</source>
        <translation>Con ejercicios</translation>
    </message>
    <message>
        <source>This variant</source>
        <translation>Esta variante</translation>
    </message>
    <message>
        <source>Power seen from</source>
        <translation>Potencia vista desde</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Vista desde</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Caras</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Se muestra</translation>
    </message>
    <message>
        <source>Hidden links</source>
        <translation>Eslabones ocultos</translation>
    </message>
    <message>
        <source>Reference frame fixed to</source>
        <translation>Sistema de referencia fijo a</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Imágenes por segundo</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Only the gear</source>
        <translation>Solo la rueda</translation>
    </message>
    <message>
        <source>Only the link</source>
        <translation>Solo el eslabón</translation>
    </message>
    <message>
        <source>A period plays</source>
        <translation>Un periodo dura</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motores</translation>
    </message>
    <message>
        <source>Inertia of the rotors</source>
        <translation>Inercia de los rotores</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Paso de tiempo</translation>
    </message>
    <message>
        <source>The format cannot hold the mechanism: a joint depends on several inputs, a link is too light, or the unit of length is not known.</source>
        <translation>El formato no puede contener el mecanismo: un par depende de varias entradas, un eslabón es demasiado ligero o la unidad de longitud no se conoce.</translation>
    </message>
    <message>
        <source>a model for simulators</source>
        <translation>un modelo para simuladores</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>imágenes</translation>
    </message>
    <message>
        <source>an animation</source>
        <translation>una animación</translation>
    </message>
    <message>
        <source>PNG, a picture of the train</source>
        <translation>PNG, una imagen del tren</translation>
    </message>
    <message>
        <source>PNG, once round the train</source>
        <translation>PNG, una vuelta alrededor del tren</translation>
    </message>
    <message>
        <source>PNG, one period of the motion</source>
        <translation>PNG, un periodo del movimiento</translation>
    </message>
    <message>
        <source>PNG, once round the train, a file for each picture</source>
        <translation>PNG, una vuelta alrededor del tren, un archivo por imagen</translation>
    </message>
    <message>
        <source>PNG, one period of the motion, a file for each picture</source>
        <translation>PNG, un periodo del movimiento, un archivo por imagen</translation>
    </message>
    <message>
        <source>GLB, the train as seen</source>
        <translation>GLB, el tren tal como se ve</translation>
    </message>
    <message>
        <source>3D pictures</source>
        <translation>Imágenes 3D</translation>
    </message>
    <message>
        <source>Animations</source>
        <translation>Animaciones</translation>
    </message>
    <message>
        <source>animations</source>
        <translation>animaciones</translation>
    </message>
    <message>
        <source>The train as seen</source>
        <translation>El tren tal como se ve</translation>
    </message>
    <message>
        <source>Handout, a web page</source>
        <translation>Hoja interactiva, una página web</translation>
    </message>
    <message>
        <source>a page for browsers, with inputs to move</source>
        <translation>una página para navegadores, con entradas que mover</translation>
    </message>
    <message>
        <source>Handout for learning platforms (SCORM 1.2)</source>
        <translation>Hoja interactiva para plataformas de aprendizaje (SCORM 1.2)</translation>
    </message>
    <message>
        <source>that page as a package for learning platforms (SCORM 1.2)</source>
        <translation>esa página como paquete para plataformas de aprendizaje (SCORM 1.2)</translation>
    </message>
    <message>
        <source>handouts</source>
        <translation>hojas interactivas</translation>
    </message>
    <message>
        <source>The mechanism, or what would be written, is too large.</source>
        <translation>El mecanismo, o lo que se escribiría, es demasiado grande.</translation>
    </message>
    <message>
        <source>Gears cannot be made.</source>
        <translation>No se pueden generar ruedas.</translation>
    </message>
    <message>
        <source>Nothing can paint pictures here, or a picture is too large to be painted.</source>
        <translation>Aquí nada puede pintar imágenes, o una imagen es demasiado grande para pintarla.</translation>
    </message>
    <message>
        <source>--to is one of %1.</source>
        <translation>--to es uno de %1.</translation>
    </message>
    <message>
        <source>Export into the new folder</source>
        <translation>Exportar a la nueva carpeta</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Exporting %1: %2 %.</source>
        <translation>Exportando %1: %2 %.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>This format has no options.</source>
        <translation>Este formato no tiene opciones.</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Como de costumbre</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>This is no certificate of teeth.</source>
        <translation>Esto no es un certificado de dientes.</translation>
    </message>
    <message>
        <source>The certificate is newer than this program.</source>
        <translation>El certificado es más nuevo que este programa.</translation>
    </message>
    <message>
        <source>%1 is not what a certificate has there.</source>
        <translation>%1 no es lo que un certificado tiene en ese lugar.</translation>
    </message>
    <message>
        <source>The mark is not that of the problem: it was changed.</source>
        <translation>La marca no es la del problema: fue modificado.</translation>
    </message>
    <message>
        <source>The wheels are not those of the meshes.</source>
        <translation>Las ruedas no son las de los engranes.</translation>
    </message>
    <message>
        <source>Ratio %1 is not that of the mechanism.</source>
        <translation>La relación %1 no es la del mecanismo.</translation>
    </message>
    <message>
        <source>The counts are %1 choices and %2 within the bounds, not %3 and %4.</source>
        <translation>Son %1 opciones y %2 dentro de los límites, no %3 y %4.</translation>
    </message>
    <message>
        <source>The counts of the branches are not those of the choices.</source>
        <translation>Los números de las ramas no son los de las opciones.</translation>
    </message>
    <message>
        <source>Choices are listed that there are not.</source>
        <translation>Figuran opciones que no existen.</translation>
    </message>
    <message>
        <source>Choice %1 is not the one that follows.</source>
        <translation>La opción %1 no es la que sigue.</translation>
    </message>
    <message>
        <source>a ratio other than 0: a number, or a string like &quot;9/2&quot; or &quot;0.632&quot;</source>
        <translation>una relación distinta de 0: un número o una cadena como &quot;9/2&quot; o &quot;0.632&quot;</translation>
    </message>
    <message>
        <source>There are no teeth from %1 to %2.</source>
        <translation>No hay números de dientes de %1 a %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or &quot;%2&quot;</source>
        <translation>«%1» o «%2»</translation>
    </message>
    <message>
        <source>There is no member &quot;%1&quot; in a wish.</source>
        <translation>Un deseo no tiene ningún miembro «%1».</translation>
    </message>
    <message>
        <source>a list of ratios</source>
        <translation>una lista de relaciones</translation>
    </message>
    <message>
        <source>a list of 1 to %1 ratios</source>
        <translation>una lista de 1 a %1 relaciones</translation>
    </message>
    <message>
        <source>Drive and driven are one link.</source>
        <translation>La entrada y la salida son el mismo eslabón.</translation>
    </message>
    <message>
        <source>Link %1 is held, so that it has no ratio.</source>
        <translation>El eslabón %1 está retenido y por eso no tiene relación.</translation>
    </message>
    <message>
        <source>the name of a state</source>
        <translation>el nombre de un estado</translation>
    </message>
    <message>
        <source>A ratio is wanted in a state or with links held, not in both.</source>
        <translation>Una relación se pide en un estado o con eslabones retenidos, no ambas cosas.</translation>
    </message>
    <message>
        <source>no ratio beside an interval</source>
        <translation>ninguna relación junto a un intervalo</translation>
    </message>
    <message>
        <source>With the ratio 0 the drive would stand still while link %1 turns.</source>
        <translation>Con la relación 0 la entrada estaría quieta mientras gira el eslabón %1.</translation>
    </message>
    <message>
        <source>two ratios of one sign, the smaller first</source>
        <translation>dos relaciones del mismo signo, primero la menor</translation>
    </message>
    <message>
        <source>Without &quot;wheels&quot; there is none that could be used once.</source>
        <translation>Sin «wheels» no hay ninguna rueda que se pueda usar una vez.</translation>
    </message>
    <message>
        <source>a list of 1 to %1 numbers of teeth from 1 to %2</source>
        <translation>una lista de 1 a %1 números de dientes de 1 a %2</translation>
    </message>
    <message>
        <source>There is no wheel &quot;%1&quot;: wheels are named like 15:tail.</source>
        <translation>No hay ninguna rueda «%1»: las ruedas se nombran como 15:tail.</translation>
    </message>
    <message>
        <source>no efficiency of a set beside that of a mesh</source>
        <translation>ningún rendimiento de un juego junto al de un engrane</translation>
    </message>
    <message>
        <source>a relative tolerance from 0 to below 1</source>
        <translation>una tolerancia relativa desde 0 hasta menos de 1</translation>
    </message>
    <message>
        <source>an efficiency above 0 and at most 1</source>
        <translation>un rendimiento mayor que 0 y como máximo 1</translation>
    </message>
    <message>
        <source>There are no gears whose teeth could be chosen.</source>
        <translation>No hay engranajes cuyos dientes se puedan elegir.</translation>
    </message>
    <message>
        <source>The speeds of links %1 and %2 have no ratio that the teeth determine.</source>
        <translation>Las velocidades de los eslabones %1 y %2 no tienen una relación que determinen los dientes.</translation>
    </message>
    <message>
        <source>The ratio depends on %1 gear pairs: teeth are looked for in trains of at most %2.</source>
        <translation>La relación depende de %1 pares de ruedas: se buscan dientes en trenes de %2 como máximo.</translation>
    </message>
    <message>
        <source>Not all choices were tried, so that there is nothing to certify.</source>
        <translation>No se probaron todas las opciones, así que no hay nada que certificar.</translation>
    </message>
    <message>
        <source>A wish with a least efficiency has no certificate.</source>
        <translation>Para un deseo con un rendimiento mínimo no hay certificado.</translation>
    </message>
    <message>
        <source>A train that locks with other teeth has no certificate.</source>
        <translation>Para un tren que se bloquea con otros dientes no hay certificado.</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>opción</translation>
    </message>
    <message>
        <source>planets</source>
        <translation>satélites</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>socavado</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>giran</translation>
    </message>
    <message>
        <source>with planets that clear each other</source>
        <translation>con satélites que no se tocan</translation>
    </message>
    <message>
        <source>with equal planets that go in</source>
        <translation>con satélites iguales que se pueden montar</translation>
    </message>
    <message>
        <source>with hunting teeth only</source>
        <translation>solo con dientes itinerantes</translation>
    </message>
    <message>
        <source>without undercut</source>
        <translation>sin socavado</translation>
    </message>
    <message>
        <source>within the bounds</source>
        <translation>dentro de los límites</translation>
    </message>
    <message>
        <source>All %1 choices were tried.</source>
        <translation>Se probaron todas las %1 opciones.</translation>
    </message>
    <message>
        <source>meet the wish</source>
        <translation>cumplen el deseo</translation>
    </message>
    <message>
        <source>None. The nearest</source>
        <translation>Ninguna. La más próxima</translation>
    </message>
    <message>
        <source>Choices, the best first</source>
        <translation>Opciones, la mejor primero</translation>
    </message>
    <message>
        <source>The certificate holds: %1 choices were tried again, %2 are within the bounds.</source>
        <translation>El certificado es correcto: se volvieron a probar %1 opciones, %2 están dentro de los límites.</translation>
    </message>
    <message>
        <source>The certificate does not hold.</source>
        <translation>El certificado no es correcto.</translation>
    </message>
    <message>
        <source>A certificate is checked by itself, without a mechanism and a wish.</source>
        <translation>Un certificado se comprueba por sí solo, sin mecanismo ni deseo.</translation>
    </message>
    <message>
        <source>A mechanism and a file with a wish are needed.</source>
        <translation>Se necesitan un mecanismo y un archivo con un deseo.</translation>
    </message>
    <message>
        <source>inner planet %1</source>
        <translation>satélite interior %1</translation>
    </message>
    <message>
        <source>outer planet %1</source>
        <translation>satélite exterior %1</translation>
    </message>
    <message>
        <source>Found by the gearbox designer. Ratios: %1. One planet or pair of each set is drawn; numbers that go in: %2.</source>
        <translation>Hallada por el diseñador de cajas de cambios. Relaciones: %1. De cada tren se dibuja un satélite o un par; números que caben: %2.</translation>
    </message>
    <message>
        <source>One mesh of each set has the whole basic efficiency of the set, the others lose nothing.</source>
        <translation>Un engrane de cada tren tiene todo el rendimiento básico del tren; los demás no pierden nada.</translation>
    </message>
    <message>
        <source>It is of another version of the search.</source>
        <translation>Es de otra versión de la búsqueda.</translation>
    </message>
    <message>
        <source>Line %1 is none of a finished part of a gearbox search.</source>
        <translation>La línea %1 no es de una parte terminada de una búsqueda de cajas de cambios.</translation>
    </message>
    <message>
        <source>The file ends early: its gearboxes are fewer than its first line says.</source>
        <translation>El archivo termina antes de tiempo: tiene menos cajas de cambios de las que dice su primera línea.</translation>
    </message>
    <message>
        <source>These are parts of searches for different wishes.</source>
        <translation>Son partes de búsquedas de deseos distintos.</translation>
    </message>
    <message>
        <source>These are parts of %1 and of %2: a search is parted once.</source>
        <translation>Son partes de %1 y de %2: una búsqueda se divide una sola vez.</translation>
    </message>
    <message>
        <source>Part %1 is in two files that hold further parts: merge single parts.</source>
        <translation>La parte %1 está en dos archivos que contienen además otras: una las partes sueltas.</translation>
    </message>
    <message>
        <source>It is of another wish, another part or another version of the search.</source>
        <translation>Es de otro deseo, de otra parte o de otra versión de la búsqueda.</translation>
    </message>
    <message>
        <source>It holds a line that is none of this search.</source>
        <translation>Contiene una línea que no es de esta búsqueda.</translation>
    </message>
    <message>
        <source>an object of wheels with their teeth, {&quot;1.ring&quot;: 72}</source>
        <translation>un objeto de ruedas con sus dientes, {&quot;1.ring&quot;: 72}</translation>
    </message>
    <message>
        <source>there is no wheel &quot;%1&quot;; wheels are named like &quot;1.ring&quot;, &quot;2.sun1&quot;, &quot;2.planet1&quot;.</source>
        <translation>no hay ninguna rueda &quot;%1&quot;; las ruedas se llaman como &quot;1.ring&quot;, &quot;2.sun1&quot;, &quot;2.planet1&quot;.</translation>
    </message>
    <message>
        <source>a list of gears with ratios, {&quot;gear&quot;: 4, &quot;ratio&quot;: &quot;0.98884&quot;}</source>
        <translation>una lista de marchas con relaciones, {&quot;gear&quot;: 4, &quot;ratio&quot;: &quot;0.98884&quot;}</translation>
    </message>
    <message>
        <source>a ratio in a string</source>
        <translation>una relación en una cadena</translation>
    </message>
    <message>
        <source>only sets in series are searched.</source>
        <translation>solo se buscan trenes en serie.</translation>
    </message>
    <message>
        <source>only sets of which one sun is held at a time are searched.</source>
        <translation>solo se buscan trenes de los que se retiene un sol cada vez.</translation>
    </message>
    <message>
        <source>a ratio above 0 in a string: a decimal like &quot;2.34&quot; or a fraction like &quot;7/3&quot;</source>
        <translation>una relación mayor que 0 en una cadena: un decimal como &quot;2.34&quot; o una fracción como &quot;7/3&quot;</translation>
    </message>
    <message>
        <source>a list of two whole numbers from %1 to %2, the smaller one first</source>
        <translation>una lista de dos números enteros de %1 a %2, primero el menor</translation>
    </message>
    <message>
        <source>a number from 0 to below 1, the part of each ratio</source>
        <translation>un número desde 0 y menor que 1, la parte de cada relación</translation>
    </message>
    <message>
        <source>a list of 1 to %1 ratios in strings, each above 0</source>
        <translation>una lista de 1 a %1 relaciones en cadenas, cada una mayor que 0</translation>
    </message>
    <message>
        <source>a wish has no member &quot;%1&quot;.</source>
        <translation>un deseo no tiene ningún miembro &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>a list of 1 to 4 sets, &quot;simple&quot;, &quot;double&quot; or &quot;ravigneaux&quot;, which counts twice</source>
        <translation>una lista de 1 a 4 trenes, &quot;simple&quot;, &quot;double&quot; o &quot;ravigneaux&quot;, que cuenta dos veces</translation>
    </message>
    <message>
        <source>a list of two numbers above 1 and at most 10, the smaller one first</source>
        <translation>una lista de dos números mayores que 1 y de 10 como máximo, primero el menor</translation>
    </message>
    <message>
        <source>an efficiency above 0, at most 1</source>
        <translation>un rendimiento mayor que 0, de 1 como máximo</translation>
    </message>
    <message>
        <source>one of &quot;mesh&quot; and &quot;set&quot; is needed, not both.</source>
        <translation>hace falta uno de &quot;mesh&quot; y &quot;set&quot;, no ambos.</translation>
    </message>
    <message>
        <source>Shafts would have to cross each other.</source>
        <translation>Los ejes tendrían que cruzarse.</translation>
    </message>
    <message>
        <source>A brake cannot reach the housing: other links enclose its link.</source>
        <translation>Un freno no llega a la carcasa: otros eslabones encierran el suyo.</translation>
    </message>
    <message>
        <source>A clutch cannot reach both of its links without crossing others.</source>
        <translation>Un embrague no llega a sus dos eslabones sin cruzar otros.</translation>
    </message>
    <message>
        <source>Input and output cannot come out at the two ends.</source>
        <translation>La entrada y la salida no pueden salir por los dos extremos.</translation>
    </message>
    <message>
        <source>No. %1: %2 elements, largest error %3</source>
        <translation>N.º %1: %2 elementos, error máximo %3</translation>
    </message>
    <message>
        <source>Teeth, sun planet ring: %1</source>
        <translation>Dientes, sol satélite corona: %1</translation>
    </message>
    <message>
        <source>Largest over that of the input: power through a member %1, torque of an element %2, slip of an open element %3, speed of a link %4</source>
        <translation>Máximos respecto a la entrada: potencia por un miembro %1, par de un elemento %2, deslizamiento de un elemento abierto %3, velocidad de un eslabón %4</translation>
    </message>
    <message>
        <source>Its section can be drawn without crossing shafts.</source>
        <translation>Su sección se puede dibujar sin que se crucen los ejes.</translation>
    </message>
    <message>
        <source>%1 layouts, %2 found</source>
        <translation>%1 disposiciones, %2 halladas</translation>
    </message>
    <message>
        <source>Complete: these elements have fewer states than gears are wanted, or no layout has so many links.</source>
        <translation>Completo: estos elementos tienen menos estados que las marchas deseadas, o ninguna disposición tiene tantos eslabones.</translation>
    </message>
    <message>
        <source>All layouts were searched, but ring ratios at %1 only: sampled, not a proof.</source>
        <translation>Se buscaron todas las disposiciones, pero las relaciones de las coronas solo en %1: una muestra, no una prueba.</translation>
    </message>
    <message>
        <source>%1 values for each set</source>
        <translation>%1 valores de cada tren</translation>
    </message>
    <message>
        <source>the search</source>
        <translation>la búsqueda</translation>
    </message>
    <message>
        <source>how many choices are given, the best first (20)</source>
        <translation>cuántas opciones se dan, la mejor primero (20)</translation>
    </message>
    <message>
        <source>write what proves that all choices were tried</source>
        <translation>escribir lo que demuestra que se probaron todas las opciones</translation>
    </message>
    <message>
        <source>check such a proof, with code of its own</source>
        <translation>comprobar una demostración así, con código propio</translation>
    </message>
    <message>
        <source>merge needs the files of parts.</source>
        <translation>merge necesita los archivos de las partes.</translation>
    </message>
    <message>
        <source>%1 has no meaning for gearbox merge.</source>
        <translation>%1 no tiene sentido para gearbox merge.</translation>
    </message>
    <message>
        <source>One wish is needed.</source>
        <translation>Hace falta un deseo.</translation>
    </message>
    <message>
        <source>--parts is for gearbox merge.</source>
        <translation>--parts es para gearbox merge.</translation>
    </message>
    <message>
        <source>--shard is R/N, the part R of N, counted from 0, not &quot;%1&quot;.</source>
        <translation>--shard es R/N, la parte R de N, contada desde 0, no &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>--shard needs a file: -o FILE.</source>
        <translation>--shard necesita un archivo: -o FILE.</translation>
    </message>
    <message>
        <source>--resume needs --shard.</source>
        <translation>--resume necesita --shard.</translation>
    </message>
    <message>
        <source>how many gearboxes are shown and written (20)</source>
        <translation>cuántas cajas de cambios se muestran y escriben (20)</translation>
    </message>
    <message>
        <source>how many layouts are searched at once (all processors but one)</source>
        <translation>cuántas disposiciones se buscan a la vez (todos los procesadores menos uno)</translation>
    </message>
    <message>
        <source>a folder for the documents; with --shard the file of the part</source>
        <translation>una carpeta para los documentos; con --shard el archivo de la parte</translation>
    </message>
    <message>
        <source>searches the part R of N only, counted from 0, into a file</source>
        <translation>busca solo la parte R de N, contada desde 0, en un archivo</translation>
    </message>
    <message>
        <source>On many machines</source>
        <translation>En muchas máquinas</translation>
    </message>
    <message>
        <source>goes on where the part was stopped; nothing if it is finished</source>
        <translation>continúa donde se detuvo la parte; nada si está terminada</translation>
    </message>
    <message>
        <source>merge: writes the merged parts, of which some may be missing</source>
        <translation>merge: escribe las partes unidas, de las que pueden faltar algunas</translation>
    </message>
    <message>
        <source>Gearboxes from planetary sets, brakes and clutches with wanted ratios.</source>
        <translation>Cajas de cambios de trenes planetarios, frenos y embragues con las relaciones deseadas.</translation>
    </message>
    <message>
        <source>%1 of %2 layouts, %3 found</source>
        <translation>%1 de %2 disposiciones, %3 halladas</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>No se pudo escribir %1.</translation>
    </message>
    <message>
        <source>%1 of %2 parts are missing, the first is %3/%2.</source>
        <translation>Faltan %1 de %2 partes; la primera es %3/%2.</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>n.º</translation>
    </message>
    <message>
        <source>sun on planet, ring of each set</source>
        <translation>sol sobre satélite, corona de cada tren</translation>
    </message>
    <message>
        <source>ratios</source>
        <translation>relaciones</translation>
    </message>
    <message>
        <source>Count %1. By the number of teeth there remain %2.</source>
        <translation>Cuente %1. Según el número de dientes quedan %2.</translation>
    </message>
    <message>
        <source>Turn the input %1 times in %2. By the degrees of the output there remain %3.</source>
        <translation>Gire la entrada %1 veces en %2. Según los grados de la salida quedan %3.</translation>
    </message>
    <message>
        <source>%1 candidates of %2 tooth sets with these ratios. All tooth sets of the structures with the fewest suns were tried.</source>
        <translation>%1 candidatos de %2 juegos de dientes con estas relaciones. Se probaron todos los juegos de dientes de las estructuras con menos soles.</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Candidatos</translation>
    </message>
    <message>
        <source>No equal planets at equal distances can be assembled</source>
        <translation>No se pueden montar satélites iguales a distancias iguales</translation>
    </message>
    <message>
        <source>All candidates share: %1.</source>
        <translation>Todos los candidatos comparten: %1.</translation>
    </message>
    <message>
        <source>Candidates %1 have the same ratios: no turning tells them apart.</source>
        <translation>Los candidatos %1 tienen las mismas relaciones: no se distinguen girando.</translation>
    </message>
    <message>
        <source>how many candidates are shown (20)</source>
        <translation>cuántos candidatos se muestran (20)</translation>
    </message>
    <message>
        <source>The planetary sets that may be inside a hub gear with these ratios.</source>
        <translation>Los trenes planetarios que puede haber dentro de un buje con estas relaciones.</translation>
    </message>
    <message>
        <source>Gearbox designer</source>
        <translation>Diseñador de cajas de cambios</translation>
    </message>
    <message>
        <source>Searches for planetary sets, brakes and clutches that have the ratios you want.</source>
        <translation>Busca trenes epicicloidales, frenos y embragues con las relaciones deseadas.</translation>
    </message>
    <message>
        <source>The list is of the earlier wish until you search again.</source>
        <translation>La lista es del deseo anterior hasta que busque de nuevo.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Keeps what was found (Esc)</source>
        <translation>Conserva lo encontrado (Esc)</translation>
    </message>
    <message>
        <source>Gearboxes with the ratios you want</source>
        <translation>Cajas de cambios con las relaciones deseadas</translation>
    </message>
    <message>
        <source>Gears: %1, sets: %2</source>
        <translation>Marchas: %1, trenes: %2</translation>
    </message>
    <message>
        <source>Gears: %1 and reverse, sets: %2</source>
        <translation>Marchas: %1 y marcha atrás, trenes: %2</translation>
    </message>
    <message>
        <source>Listing layouts…</source>
        <translation>Enumerando disposiciones…</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Paused at %1 of %2 layouts, %3 found</source>
        <translation>En pausa en %1 de %2 disposiciones, %3 halladas</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>completa</translation>
    </message>
    <message>
        <source>sampled, not a proof</source>
        <translation>muestreada, no es una prueba</translation>
    </message>
    <message>
        <source>No layout has so many links.</source>
        <translation>Ninguna disposición tiene tantos eslabones.</translation>
    </message>
    <message>
        <source>Every layout is searched, but the ratio of ring to sun at %1 values of each set only, from which the nearest whole teeth are taken.</source>
        <translation>Se recorre cada disposición, pero la relación de corona a solar solo en %1 valores por tren, desde los que se toman los dientes enteros más próximos.</translation>
    </message>
    <message>
        <source>Every layout is searched, but the ratios of ring to sun at %1 points only, from which the nearest whole teeth are taken.</source>
        <translation>Se recorre cada disposición, pero las relaciones de corona a solar solo en %1 puntos, desde los que se toman los dientes enteros más próximos.</translation>
    </message>
    <message>
        <source>Type ratios and choose Search.&lt;br&gt;Six ratios are enough: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</source>
        <translation>Escriba relaciones y elija Buscar.&lt;br&gt;Bastan seis relaciones: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</translation>
    </message>
    <message>
        <source>None: no layout of these sets has so many links.</source>
        <translation>Ninguna: ninguna disposición de estos trenes tiene tantos eslabones.</translation>
    </message>
    <message>
        <source>Nothing yet.</source>
        <translation>Todavía nada.</translation>
    </message>
    <message>
        <source>Shift table of the chosen gearbox</source>
        <translation>Tabla de marchas de la caja elegida</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>deseada</translation>
    </message>
    <message>
        <source>The largest circulating power, as a part of the power at the input</source>
        <translation>La mayor potencia circulante, como parte de la potencia de entrada</translation>
    </message>
    <message>
        <source>Opens this gearbox as a document with its states, in a new window</source>
        <translation>Abre esta caja como documento con sus estados, en una ventana nueva</translation>
    </message>
    <message>
        <source>Open No. %1</source>
        <translation>Abrir n.º %1</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>N.º %1</translation>
    </message>
    <message>
        <source>Choose a gearbox of the list.</source>
        <translation>Elija una caja de la lista.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Which brakes and clutches each gear engages</source>
        <translation>Qué frenos y embragues activa cada marcha</translation>
    </message>
    <message>
        <source>The largest difference from a wanted ratio, relative to it</source>
        <translation>La mayor diferencia con una relación deseada, relativa a ella</translation>
    </message>
    <message>
        <source>The least efficiency of a gear; the wish gives that of a mesh</source>
        <translation>El menor rendimiento de una marcha; el deseo da el de un engrane</translation>
    </message>
    <message>
        <source>Can its section be drawn without shafts that cross?</source>
        <translation>¿Puede dibujarse su sección sin ejes que se crucen?</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>worst η</source>
        <translation>peor η</translation>
    </message>
    <message>
        <source>buildable</source>
        <translation>realizable</translation>
    </message>
    <message>
        <source>Gearboxes that were found</source>
        <translation>Cajas halladas</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Relaciones</translation>
    </message>
    <message>
        <source>Wanted ratios</source>
        <translation>Relaciones deseadas</translation>
    </message>
    <message>
        <source>4.17 2.34 1.52 …</source>
        <translation>4,17 2,34 1,52 …</translation>
    </message>
    <message>
        <source>Input over output of each gear, first gear first: decimals or fractions, typed or pasted</source>
        <translation>Entrada entre salida de cada marcha, la primera al principio: decimales o fracciones, escritos o pegados</translation>
    </message>
    <message>
        <source>any ratio</source>
        <translation>cualquier relación</translation>
    </message>
    <message>
        <source>this ratio</source>
        <translation>esta relación</translation>
    </message>
    <message>
        <source>no reverse</source>
        <translation>sin marcha atrás</translation>
    </message>
    <message>
        <source>Wanted ratio of the reverse</source>
        <translation>Relación deseada de la marcha atrás</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Marcha atrás</translation>
    </message>
    <message>
        <source>By how many percent a ratio may differ; empty: ratios are rounded as typed</source>
        <translation>En qué porcentaje puede diferir una relación; vacío: redondeadas como se escriben</translation>
    </message>
    <message>
        <source>Tolerance in percent</source>
        <translation>Tolerancia en por ciento</translation>
    </message>
    <message>
        <source>% of every ratio</source>
        <translation>% de cada relación</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Trenes</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>simples</translation>
    </message>
    <message>
        <source>double planets</source>
        <translation>satélites dobles</translation>
    </message>
    <message>
        <source>Ravigneaux</source>
        <translation>Trenes Ravigneaux</translation>
    </message>
    <message>
        <source>Shafts that can turn, the input shaft too</source>
        <translation>Ejes que pueden girar, también el de entrada</translation>
    </message>
    <message>
        <source>rotating links</source>
        <translation>eslabones giratorios</translation>
    </message>
    <message>
        <source>Members of sets that are part of the housing</source>
        <translation>Miembros de trenes que son parte de la carcasa</translation>
    </message>
    <message>
        <source>members held</source>
        <translation>miembros fijos</translation>
    </message>
    <message>
        <source>input joined by clutches only</source>
        <translation>entrada unida solo por embragues</translation>
    </message>
    <message>
        <source>Also layouts whose input shaft has no member of a set</source>
        <translation>También disposiciones cuyo eje de entrada no tiene miembro de un tren</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Acoplamientos</translation>
    </message>
    <message>
        <source>Brakes and clutches together</source>
        <translation>Frenos y embragues juntos</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>como máximo</translation>
    </message>
    <message>
        <source>brakes</source>
        <translation>frenos</translation>
    </message>
    <message>
        <source>clutches</source>
        <translation>embragues</translation>
    </message>
    <message>
        <source>Show what the exercises ask for</source>
        <translation>Mostrar lo que preguntan los ejercicios</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>dibujado</translation>
    </message>
    <message>
        <source>%1: pinned, it keeps its teeth</source>
        <translation>%1: fijada, conserva sus dientes</translation>
    </message>
    <message>
        <source>%1. Ticked: its teeth may change</source>
        <translation>%1. Marcada: sus dientes pueden cambiar</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fijada</translation>
    </message>
    <message>
        <source>Its teeth follow from the others: one distance between two axes</source>
        <translation>Sus dientes se deducen de los demás: una sola distancia entre dos ejes</translation>
    </message>
    <message>
        <source>Whole teeth with which the train has the ratios that you want, all of them.</source>
        <translation>Los dientes enteros con los que el tren tiene las relaciones deseadas, todos ellos.</translation>
    </message>
    <message>
        <source>The link that drives</source>
        <translation>El eslabón que acciona</translation>
    </message>
    <message>
        <source>The link that is driven</source>
        <translation>El eslabón accionado</translation>
    </message>
    <message>
        <source>In which state the ratio is wanted, or which links are held</source>
        <translation>En qué estado se desea la relación, o qué eslabones están retenidos</translation>
    </message>
    <message>
        <source>The numbers of the links that are held, such as 2 4</source>
        <translation>Los números de los eslabones retenidos, como 2 4</translation>
    </message>
    <message>
        <source>Speed of the drive over that of the driven link: 64, 9/2 or 0.632</source>
        <translation>Velocidad del eslabón motor entre la del accionado: 64, 9/2 o 0,632</translation>
    </message>
    <message>
        <source>How far the ratio may be missed: 0.5 % of it, or by a number such as 0.01. Empty: a decimal is taken as rounded, any other ratio is wanted exactly</source>
        <translation>Cuánto puede desviarse la relación: un 0,5 % de ella, o un número como 0,01. Vacío: un decimal se toma como redondeado, cualquier otra relación se desea exacta</translation>
    </message>
    <message>
        <source>Remove this ratio</source>
        <translation>Quitar esta relación</translation>
    </message>
    <message>
        <source>such as 2 4</source>
        <translation>como 2 4</translation>
    </message>
    <message>
        <source>in state %1</source>
        <translation>en el estado %1</translation>
    </message>
    <message>
        <source>as engaged now</source>
        <translation>como está activado ahora</translation>
    </message>
    <message>
        <source>with links held:</source>
        <translation>con eslabones retenidos:</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>ahora %1</translation>
    </message>
    <message>
        <source>%1, meshes with %2</source>
        <translation>%1, engrana con %2</translation>
    </message>
    <message>
        <source>+ Ratio</source>
        <translation>+ Relación</translation>
    </message>
    <message>
        <source>Another ratio of the same train: all of them have to be met</source>
        <translation>Otra relación del mismo tren: todas han de cumplirse</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Deseado</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>Ruedas</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Por defecto</translation>
    </message>
    <message>
        <source>The limits as they are at first</source>
        <translation>Los límites como al principio</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>ring : sun</source>
        <translation>corona : solar</translation>
    </message>
    <message>
        <source>teeth from</source>
        <translation>dientes desde</translation>
    </message>
    <message>
        <source>rings to</source>
        <translation>coronas hasta</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>no se calcula</translation>
    </message>
    <message>
        <source>Efficiency of a mesh, such as 0.98, from which that of each gear follows</source>
        <translation>Rendimiento de un engrane, como 0,98, del que resulta el de cada marcha</translation>
    </message>
    <message>
        <source>buildable only</source>
        <translation>solo realizables</translation>
    </message>
    <message>
        <source>Only gearboxes whose section can be drawn without shafts that cross</source>
        <translation>Solo cajas cuya sección puede dibujarse sin ejes que se crucen</translation>
    </message>
    <message>
        <source>Impossible: %1 gears need as many states; %2 of %3 elements give fewer.</source>
        <translation>Imposible: %1 marchas necesitan otros tantos estados; %2 de %3 acoplamientos dan menos.</translation>
    </message>
    <message>
        <source>Gearbox designer…</source>
        <translation>Diseñador de cajas de cambios…</translation>
    </message>
    <message>
        <source>Search for planetary sets, brakes and clutches that have the ratios you want</source>
        <translation>Buscar trenes epicicloidales, frenos y embragues con las relaciones deseadas</translation>
    </message>
    <message>
        <source>Fewest teeth of a wheel</source>
        <translation>Mínimo de dientes de una rueda</translation>
    </message>
    <message>
        <source>Most teeth of a gear</source>
        <translation>Máximo de dientes de una rueda exterior</translation>
    </message>
    <message>
        <source>Most teeth of a ring gear</source>
        <translation>Máximo de dientes de una corona</translation>
    </message>
    <message>
        <source>Equal planets at equal distances that have to go in and to clear each other</source>
        <translation>Satélites iguales a distancias iguales que han de montarse sin tocarse</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>como está dibujado</translation>
    </message>
    <message>
        <source>Whole teeth by which the sums of two pairs between the same axes may differ; a profile shift makes up for it</source>
        <translation>Dientes enteros en que pueden diferir las sumas de dos pares entre los mismos ejes; un desplazamiento de perfil lo compensa</translation>
    </message>
    <message>
        <source>one for all</source>
        <translation>uno para todos</translation>
    </message>
    <message>
        <source>free for each pair</source>
        <translation>libre para cada par</translation>
    </message>
    <message>
        <source>With one module, pairs between the same two axes have one sum of teeth</source>
        <translation>Con un solo módulo, los pares entre los mismos dos ejes tienen una misma suma de dientes</translation>
    </message>
    <message>
        <source>The only teeth that there are, such as 8 16 24 40; empty: any</source>
        <translation>Los únicos dientes que hay, como 8 16 24 40; vacío: cualesquiera</translation>
    </message>
    <message>
        <source>any, or only these: 8 16 24 40</source>
        <translation>cualquiera, o solo: 8 16 24 40</translation>
    </message>
    <message>
        <source>Efficiency of every mesh; empty: as the document states, if it does</source>
        <translation>Rendimiento de cada engrane; vacío: como indica el documento, si lo indica</translation>
    </message>
    <message>
        <source>The least efficiency that every ratio must have; empty: any</source>
        <translation>El rendimiento mínimo que debe tener cada relación; vacío: cualquiera</translation>
    </message>
    <message>
        <source>each of these once</source>
        <translation>cada una de estas una vez</translation>
    </message>
    <message>
        <source>Of the wheels that are listed each is used once at most</source>
        <translation>De las ruedas enumeradas cada una se usa una vez como mucho</translation>
    </message>
    <message>
        <source>axes stay where they are</source>
        <translation>los ejes se quedan donde están</translation>
    </message>
    <message>
        <source>Centre distances and modules stay as they are</source>
        <translation>Las distancias entre ejes y los módulos se quedan como están</translation>
    </message>
    <message>
        <source>only with hunting teeth</source>
        <translation>solo con dientes primos entre sí</translation>
    </message>
    <message>
        <source>No two teeth meet again before each has met all others</source>
        <translation>Dos dientes no se reencuentran antes de que cada uno haya encontrado a todos los demás</translation>
    </message>
    <message>
        <source>no undercut</source>
        <translation>sin socavado</translation>
    </message>
    <message>
        <source>No gear has fewer teeth than a rack cuts without undercut and profile shift</source>
        <translation>Ninguna rueda tiene menos dientes de los que una cremallera talla sin socavado ni desplazamiento de perfil</translation>
    </message>
    <message>
        <source>Rings to</source>
        <translation>Coronas hasta</translation>
    </message>
    <message>
        <source>Slack</source>
        <translation>Holgura</translation>
    </message>
    <message>
        <source>In stock</source>
        <translation>Existencias</translation>
    </message>
    <message>
        <source>Least η</source>
        <translation>η mínimo</translation>
    </message>
    <message>
        <source>%1 turn</source>
        <translation>%1 giran</translation>
    </message>
    <message>
        <source>%1 with planets that clear each other</source>
        <translation>%1 con satélites que no se tocan</translation>
    </message>
    <message>
        <source>%1 with equal planets that go in</source>
        <translation>%1 con satélites iguales que se pueden montar</translation>
    </message>
    <message>
        <source>%1 with hunting teeth only</source>
        <translation>%1 solo con dientes primos entre sí</translation>
    </message>
    <message>
        <source>%1 without undercut</source>
        <translation>%1 sin socavado</translation>
    </message>
    <message>
        <source>%1 within the tolerance</source>
        <translation>%1 dentro de la tolerancia</translation>
    </message>
    <message>
        <source>Draw a train with gear pairs; then say which ratio it should have, and every choice of whole teeth within your limits is tried.</source>
        <translation>Dibuje un tren con pares de ruedas; diga después qué relación ha de tener, y se prueba cada elección de dientes enteros dentro de sus límites.</translation>
    </message>
    <message>
        <source>The teeth could not be searched: %1</source>
        <translation>No se pudieron buscar los dientes: %1</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>Cuánto de la búsqueda está hecho</translation>
    </message>
    <message>
        <source>u: undercut; a profile shift mends it</source>
        <translation>u: socavado; un desplazamiento de perfil lo corrige</translation>
    </message>
    <message>
        <source>Save certificate…</source>
        <translation>Guardar certificado…</translation>
    </message>
    <message>
        <source>Copy the table as CSV (Ctrl+C)</source>
        <translation>Copiar la tabla como CSV (Ctrl+C)</translation>
    </message>
    <message>
        <source>Save the table as CSV</source>
        <translation>Guardar la tabla como CSV</translation>
    </message>
    <message>
        <source>Use these teeth</source>
        <translation>Usar estos dientes</translation>
    </message>
    <message>
        <source>Choices of teeth</source>
        <translation>Elecciones de dientes</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>%1 hasta ahora</translation>
    </message>
    <message>
        <source>End the search; what was found stays</source>
        <translation>Terminar la búsqueda; lo hallado se queda</translation>
    </message>
    <message>
        <source>The wish cannot be met as it is: see beside its fields.</source>
        <translation>El deseo no puede cumplirse así: véase junto a sus campos.</translation>
    </message>
    <message>
        <source>Type the ratio that you want: every choice of whole teeth is tried.</source>
        <translation>Escriba la relación deseada: se prueba cada elección de dientes enteros.</translation>
    </message>
    <message>
        <source>All %1 choices tried: complete</source>
        <translation>Las %1 elecciones probadas: completo</translation>
    </message>
    <message>
        <source>Stopped after %1 choices: not complete</source>
        <translation>Detenido tras %1 elecciones: incompleto</translation>
    </message>
    <message>
        <source>Search anew</source>
        <translation>Buscar de nuevo</translation>
    </message>
    <message>
        <source>Search from the beginning</source>
        <translation>Buscar desde el principio</translation>
    </message>
    <message>
        <source>%1 meet the wish</source>
        <translation>%1 cumplen el deseo</translation>
    </message>
    <message>
        <source>the best %1 are shown</source>
        <translation>se muestran las %1 mejores</translation>
    </message>
    <message>
        <source>%1, off by %2</source>
        <translation>%1, con desvío de %2</translation>
    </message>
    <message>
        <source>None. Nearest: %1</source>
        <translation>Ninguna. La más cercana: %1</translation>
    </message>
    <message>
        <source>No choice of teeth is left: the line above says where they end. Wider limits, or more wheels that may change, give more.</source>
        <translation>No queda ninguna elección: la línea de arriba dice dónde se acaban. Límites más amplios, o más ruedas que puedan cambiar, dan más.</translation>
    </message>
    <message>
        <source>Nothing was found yet.</source>
        <translation>Aún no se ha hallado nada.</translation>
    </message>
    <message>
        <source>Give the train the teeth of the chosen row (Enter); Ctrl+Z undoes it</source>
        <translation>Dar al tren los dientes de la fila elegida (Intro); Ctrl+Z lo deshace</translation>
    </message>
    <message>
        <source>Choose a row first</source>
        <translation>Elija antes una fila</translation>
    </message>
    <message>
        <source>Save what proves that there are no other choices</source>
        <translation>Guardar lo que demuestra que no hay otras elecciones</translation>
    </message>
    <message>
        <source>There is a certificate when all choices have been tried</source>
        <translation>Hay certificado cuando se han probado todas las elecciones</translation>
    </message>
    <message>
        <source>Choose teeth</source>
        <translation>Elegir dientes</translation>
    </message>
    <message>
        <source>choice %1</source>
        <translation>elección %1</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>más cercana</translation>
    </message>
    <message>
        <source>Save certificate</source>
        <translation>Guardar certificado</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>Archivos JSON (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Mesh %1: every tooth meets every other</source>
        <translation>Engrane %1: cada diente encuentra a todos los otros</translation>
    </message>
    <message>
        <source>Mesh %1: a tooth meets one in %2 of the others</source>
        <translation>Engrane %1: un diente encuentra a uno de cada %2 de los otros</translation>
    </message>
    <message>
        <source>%1: a rack undercuts it without a profile shift</source>
        <translation>%1: una cremallera la socava sin desplazamiento de perfil</translation>
    </message>
    <message>
        <source>hunting</source>
        <translation>primos</translation>
    </message>
    <message>
        <source>The best first: the smallest error, then the highest efficiency</source>
        <translation>La mejor primero: el menor error, después el mayor rendimiento</translation>
    </message>
    <message>
        <source>Teeth of %1</source>
        <translation>Dientes de %1</translation>
    </message>
    <message>
        <source>The ratio, exactly</source>
        <translation>La relación, exacta</translation>
    </message>
    <message>
        <source>The ratio, rounded to three decimals</source>
        <translation>La relación, redondeada a tres decimales</translation>
    </message>
    <message>
        <source>By how much of the wished ratio it is missed; the dot shows where it is within the tolerance</source>
        <translation>En qué parte de la relación deseada se desvía; el punto muestra dónde está dentro de la tolerancia</translation>
    </message>
    <message>
        <source>How many equal planets go in at equal distances and clear each other</source>
        <translation>Cuántos satélites iguales se pueden montar a distancias iguales sin tocarse</translation>
    </message>
    <message>
        <source>By pair of wheels: a hunting tooth meets all others before it meets one again</source>
        <translation>Por par de ruedas: con números primos entre sí, un diente encuentra a todos los otros antes de repetir</translation>
    </message>
    <message>
        <source>Efficiency of the train, of several ratios the smallest</source>
        <translation>Rendimiento del tren, el menor si hay varias relaciones</translation>
    </message>
    <message>
        <source>The same with the power the other way; none: it locks itself</source>
        <translation>Lo mismo con la potencia en sentido contrario; ninguno: se autobloquea</translation>
    </message>
    <message>
        <source>Teeth for ratios…</source>
        <translation>Dientes para relaciones…</translation>
    </message>
    <message>
        <source>Every choice of whole teeth with which this train has the ratios that you want</source>
        <translation>Cada elección de dientes enteros con la que este tren tiene las relaciones deseadas</translation>
    </message>
    <message>
        <source>There is no train yet whose teeth could be chosen.</source>
        <translation>Aún no hay un tren cuyos dientes se puedan elegir.</translation>
    </message>
    <message>
        <source>The teeth hold the answer: they open when the step is right or shown.</source>
        <translation>Los dientes contienen la respuesta: se abren cuando el paso es correcto o se muestra.</translation>
    </message>
    <message>
        <source>Levers</source>
        <translation>Palancas</translation>
    </message>
    <message>
        <source>Each gear set as a lever, its links at their places</source>
        <translation>Cada juego de engranajes como palanca, con sus eslabones en su sitio</translation>
    </message>
    <message>
        <source>Nomogram</source>
        <translation>Nomograma</translation>
    </message>
    <message>
        <source>The states of the gearbox as lines across the speeds of its links</source>
        <translation>Los estados de la caja como líneas a través de las velocidades de sus eslabones</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>The plane of the links that is left when the coupling engaged last is let go</source>
        <translation>El plano de los eslabones que queda al soltar el último acoplamiento activado</translation>
    </message>
    <message>
        <source>Arrows to the right of the bars: how fast each link turns</source>
        <translation>Flechas a la derecha de las barras: a qué velocidad gira cada eslabón</translation>
    </message>
    <message>
        <source>Arrows to the left of the bars: the torques of the links on the lever, which add up to zero</source>
        <translation>Flechas a la izquierda de las barras: los pares de los eslabones sobre la palanca, que suman cero</translation>
    </message>
    <message>
        <source>With so many inputs no arrow is dragged: set them in Inputs and results</source>
        <translation>Con tantas entradas no se arrastra ninguna flecha: se ajustan en Entradas y resultados</translation>
    </message>
    <message>
        <source>Input %1: %2 rad/s. Esc puts back</source>
        <translation>Entrada %1: %2 rad/s. Esc la devuelve</translation>
    </message>
    <message>
        <source>No input turns this link: there is no speed to set</source>
        <translation>Ninguna entrada gira este eslabón: no hay velocidad que ajustar</translation>
    </message>
    <message>
        <source>Speed of the link, rad/s</source>
        <translation>Velocidad del eslabón, rad/s</translation>
    </message>
    <message>
        <source>“%1” is no speed: a number, or one with a unit such as 30 rpm</source>
        <translation>«%1» no es una velocidad: un número, o uno con unidad como 30 rpm</translation>
    </message>
    <message>
        <source>%1 for %2: state %3</source>
        <translation>%1 en lugar de %2: estado %3</translation>
    </message>
    <message>
        <source>, ratio %1</source>
        <translation>, relación %1</translation>
    </message>
    <message>
        <source>let go of %1: 1 freedom</source>
        <translation>soltar %1: 1 grado de libertad</translation>
    </message>
    <message>
        <source>let go of %1: %2 freedoms</source>
        <translation>soltar %1: %2 grados de libertad</translation>
    </message>
    <message>
        <source>hold it (B): it does not turn anyway</source>
        <translation>retenerlo (B): de todos modos no gira</translation>
    </message>
    <message>
        <source>hold it (B): nothing turns any more</source>
        <translation>retenerlo (B): ya nada gira</translation>
    </message>
    <message>
        <source>hold it (B): 1 freedom</source>
        <translation>retenerlo (B): 1 grado de libertad</translation>
    </message>
    <message>
        <source>hold it (B): %1 freedoms</source>
        <translation>retenerlo (B): %1 grados de libertad</translation>
    </message>
    <message>
        <source>instead</source>
        <translation>en cambio</translation>
    </message>
    <message>
        <source>State %1: nothing engaged</source>
        <translation>Estado %1: nada activado</translation>
    </message>
    <message>
        <source>State %1: %2</source>
        <translation>Estado %1: %2</translation>
    </message>
    <message>
        <source>The levers hold the answer: they are shown when the step is right or shown.</source>
        <translation>Las palancas contienen la respuesta: aparecen cuando el paso es correcto o se muestra.</translation>
    </message>
    <message>
        <source>The levers are still being laid out. Try again in a moment.</source>
        <translation>Las palancas aún se están disponiendo. Inténtelo de nuevo en un momento.</translation>
    </message>
    <message>
        <source>Drag an arrow: the train turns with it. Click a point to select its link, B holds it</source>
        <translation>Arrastre una flecha: el tren gira con ella. Un clic en un punto selecciona su eslabón, B lo retiene</translation>
    </message>
    <message>
        <source>Click a line or its tag to engage the state</source>
        <translation>Un clic en una línea o en su etiqueta activa el estado</translation>
    </message>
    <message>
        <source>Engaging a coupling draws the plane together along its dotted line</source>
        <translation>Activar un acoplamiento junta el plano a lo largo de su línea de puntos</translation>
    </message>
    <message>
        <source>Gear sets as levers: speeds and torques of the links on the ground&apos;s axis</source>
        <translation>Juegos de engranajes como palancas: velocidades y pares de los eslabones del eje del bastidor</translation>
    </message>
    <message>
        <source>Speeds and torques on levers, the states of a gearbox as a nomogram, and the plane of two freedoms.</source>
        <translation>Velocidades y pares en palancas, los estados de una caja como nomograma y el plano de dos grados de libertad.</translation>
    </message>
    <message>
        <source>Links %1</source>
        <translation>Eslabones %1</translation>
    </message>
    <message>
        <source>Link %1 (%2)</source>
        <translation>Eslabón %1 (%2)</translation>
    </message>
    <message>
        <source>%1: held by brake %2</source>
        <translation>%1: retenido por el freno %2</translation>
    </message>
    <message>
        <source>, as %1 : %2 teeth</source>
        <translation>, como %1 : %2 dientes</translation>
    </message>
    <message>
        <source>an end of the lever, %1 the other</source>
        <translation>un extremo de la palanca, %1 el otro</translation>
    </message>
    <message>
        <source>%1 divides %2 to %3 in %4 : %5</source>
        <translation>%1 divide de %2 a %3 en %4 : %5</translation>
    </message>
    <message>
        <source>: %1 of the speed of %2 and %3 of that of %4</source>
        <translation>: %1 de la velocidad de %2 y %3 de la de %4</translation>
    </message>
    <message>
        <source>, by these tooth counts only</source>
        <translation>, solo con estos números de dientes</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>%1 N m on this lever</source>
        <translation>%1 N m sobre esta palanca</translation>
    </message>
    <message>
        <source>, %1 of the way from %2 to %3</source>
        <translation>, a %1 del camino de %2 a %3</translation>
    </message>
    <message>
        <source>, an end of the lever</source>
        <translation>, un extremo de la palanca</translation>
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
        <translation>A lo largo de una palanca, a la siguiente</translation>
    </message>
    <message>
        <source>%1, of your train</source>
        <translation>%1, de su tren</translation>
    </message>
    <message>
        <source>%1
axes: %2
gear pairs / carrier: %3</source>
        <translation>%1
ejes: %2
pares / portasatélites: %3</translation>
    </message>
    <message>
        <source>%1 chains</source>
        <translation>%1 cadenas</translation>
    </message>
    <message>
        <source>one of %1 links that is not in the atlas</source>
        <translation>una de %1 eslabones que no está en el atlas</translation>
    </message>
    <message>
        <source>(cannot turn)</source>
        <translation>(no puede girar)</translation>
    </message>
    <message>
        <source>(turns by these tooth counts only)</source>
        <translation>(gira solo con estos números de dientes)</translation>
    </message>
    <message>
        <source>in no gear pair: %1</source>
        <translation>en ningún par: %1</translation>
    </message>
    <message>
        <source>planets that repeat another: %1</source>
        <translation>satélites que repiten otro: %1</translation>
    </message>
    <message>
        <source>brakes and clutches</source>
        <translation>frenos y embragues</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Fuera: %1</translation>
    </message>
    <message>
        <source>Your train is unfinished: %1</source>
        <translation>Su tren está sin terminar: %1</translation>
    </message>
    <message>
        <source>Your train has no gear pair yet.</source>
        <translation>Su tren aún no tiene ningún par.</translation>
    </message>
    <message>
        <source>Your train is %1</source>
        <translation>Su tren es %1</translation>
    </message>
    <message>
        <source>Your train is %1 chains: %2</source>
        <translation>Su tren son %1 cadenas: %2</translation>
    </message>
    <message>
        <source>Open as document</source>
        <translation>Abrir como documento</translation>
    </message>
    <message>
        <source>Show in my train</source>
        <translation>Mostrar en mi tren</translation>
    </message>
    <message>
        <source>Copy number</source>
        <translation>Copiar el número</translation>
    </message>
    <message>
        <source>Select the links and gear pairs of your train that are this chain</source>
        <translation>Seleccionar los eslabones y pares de su tren que son esta cadena</translation>
    </message>
    <message>
        <source>Your train is being identified…</source>
        <translation>Se está identificando su tren…</translation>
    </message>
    <message>
        <source>It cannot turn: %1 gear pairs are as many conditions for the speeds of %2 links, of which one is held.</source>
        <translation>No puede girar: %1 pares son otras tantas condiciones para las velocidades de %2 eslabones, uno de ellos fijo.</translation>
    </message>
    <message>
        <source>Same equations, other shafts: %1</source>
        <translation>Mismas ecuaciones, otros árboles: %1</translation>
    </message>
    <message>
        <source>One gear pair less: %1</source>
        <translation>Un par menos: %1</translation>
    </message>
    <message>
        <source>One gear pair more: %1</source>
        <translation>Un par más: %1</translation>
    </message>
    <message>
        <source>Digraph of chain %1</source>
        <translation>Digrafo de la cadena %1</translation>
    </message>
    <message>
        <source>With the numbers and colours of your links</source>
        <translation>Con los números y colores de sus eslabones</translation>
    </message>
    <message>
        <source>Counts for 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301</source>
        <translation>Cantidades con libertad 1 como en Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301</translation>
    </message>
    <message>
        <source>A chain is links, axes and gear pairs, each pair with the link that carries both gears. Which link is held, teeth, kinds of gears and the joints by which coaxial links are drawn do not matter. Equations: the triples gear, gear, carrier alone (rotation graphs), which are the equations of the speeds. Chains: with the axes, too (displacement graphs). Left out are chains in which m gear pairs have fewer than m + 2 links between them, so that these turn as one; the smallest of them are the trains that cannot turn.</source>
        <translation>Una cadena son eslabones, ejes y pares de engranajes, cada par con el eslabón que lleva las dos ruedas. No importan el eslabón fijo, los dientes, los tipos de ruedas ni las juntas con que se dibujan los eslabones coaxiales. Ecuaciones: solo las ternas rueda, rueda, portasatélites (grafos de rotación), que son las ecuaciones de las velocidades. Cadenas: también con los ejes (grafos de desplazamiento). Quedan fuera las cadenas en que m pares tienen entre sí menos de m + 2 eslabones, de modo que estos giran como uno; las más pequeñas son los trenes que no pueden girar.</translation>
    </message>
    <message>
        <source>Freedom, one link held</source>
        <translation>Libertad, un eslabón fijo</translation>
    </message>
    <message>
        <source>No link parts the chain in two, and every link is in a gear pair</source>
        <translation>Ningún eslabón parte la cadena en dos, y cada eslabón está en un par</translation>
    </message>
    <message>
        <source>Chains with the same equations of speeds differ in their shafts only</source>
        <translation>Las cadenas con las mismas ecuaciones de velocidades solo difieren en los árboles</translation>
    </message>
    <message>
        <source>Trains that cannot turn, and why</source>
        <translation>Trenes que no pueden girar, y por qué</translation>
    </message>
    <message>
        <source>Number, as 6-1.5</source>
        <translation>Número, p. ej. 6-1.5</translation>
    </message>
    <message>
        <source>What is counted?</source>
        <translation>¿Qué se cuenta?</translation>
    </message>
    <message>
        <source>Chains with 1 freedom</source>
        <translation>Cadenas con libertad 1</translation>
    </message>
    <message>
        <source>nonfractionated (%1)</source>
        <translation>no fraccionadas (%1)</translation>
    </message>
    <message>
        <source>equations of %1 only</source>
        <translation>solo ecuaciones de %1</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>All geared kinematic chains up to 7 links, and which of them your train is. Arrow keys walk, Enter opens one as a document, / finds a number.</source>
        <translation>Todas las cadenas de engranajes hasta 7 eslabones, y cuál es su tren. Las flechas recorren, Intro abre una como documento, / busca un número.</translation>
    </message>
    <message>
        <source>Geared kinematic chains, filtered and counted, and which your train is.</source>
        <translation>Cadenas de engranajes, filtradas y contadas, y cuál es su tren.</translation>
    </message>
    <message>
        <source>Atlas of chains</source>
        <translation>Atlas de cadenas</translation>
    </message>
    <message>
        <source>All geared kinematic chains up to 7 links, and which of them this train is</source>
        <translation>Todas las cadenas de engranajes hasta 7 eslabones, y cuál es este tren</translation>
    </message>
    <message>
        <source>New document</source>
        <translation>Documento nuevo</translation>
    </message>
    <message>
        <source>Chains</source>
        <translation>Cadenas</translation>
    </message>
    <message>
        <source>Number of a chain</source>
        <translation>Número de una cadena</translation>
    </message>
    <message>
        <source>%1 has no meaning without %2.</source>
        <translation>%1 no tiene sentido sin %2.</translation>
    </message>
    <message>
        <source>--limit is a whole number up to %1.</source>
        <translation>--limit es un número entero hasta %1.</translation>
    </message>
    <message>
        <source>Whole teeth with which a drawn train has wanted ratios, all of them or the best.</source>
        <translation>Números enteros de dientes con los que un tren dibujado tiene las relaciones deseadas, todos o los mejores.</translation>
    </message>
    <message>
        <source>Links %1 turn as one by these tooth counts only.</source>
        <translation>Los eslabones %1 giran como uno solo con estos números de dientes.</translation>
    </message>
    <message>
        <source>The mechanism as a directed graph: links as circles, turning joints as solid arrows, gear meshes as dashed ones.</source>
        <translation>El mecanismo como grafo dirigido: eslabones como círculos, pares de revolución como flechas continuas, engranes como discontinuas.</translation>
    </message>
    <message>
        <source>The mechanism after Tsai and Tokad, with levels, chords and transfer vertices.</source>
        <translation>El mecanismo según Tsai y Tokad, con niveles, cuerdas y vértices de transferencia.</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism.</source>
        <translation>Ambos métodos, paso a paso, para este mecanismo.</translation>
    </message>
    <message>
        <source>one let go, one taken per shift</source>
        <translation>uno se suelta y uno se acopla en cada cambio</translation>
    </message>
    <message>
        <source>Masses, the inertia at each motor, and the motion that torques cause.</source>
        <translation>Masas, la inercia en cada motor y el movimiento que causan los momentos.</translation>
    </message>
    <message>
        <source>Loads, and the torques, forces and powers that they cause.</source>
        <translation>Cargas y los momentos, fuerzas y potencias que causan.</translation>
    </message>
    <message>
        <source>The speeds of the motors, and how fast every joint turns with them.</source>
        <translation>Las velocidades de los motores y a qué velocidad gira cada par con ellos.</translation>
    </message>
    <message>
        <source>A lesson: what is asked, your answer, hints, and the reason where it is wrong.</source>
        <translation>Una lección: lo que se pregunta, su respuesta, pistas y la razón si está mal.</translation>
    </message>
    <message>
        <source>Up and Down, Tab</source>
        <translation>Arriba y Abajo, Tab</translation>
    </message>
    <message>
        <source>Brakes and clutches, what is engaged, and the states of a gearbox.</source>
        <translation>Frenos y embragues, qué está activo, y los estados de una caja de cambios.</translation>
    </message>
    <message>
        <source>Every matrix of the Matroid method. Rest the mouse on an entry to have it explained.</source>
        <translation>Todas las matrices del método de matroides. Deje el ratón sobre una entrada para que se explique.</translation>
    </message>
    <message>
        <source>What is wrong with the mechanism, and how to mend it.</source>
        <translation>Qué está mal en el mecanismo y cómo corregirlo.</translation>
    </message>
    <message>
        <source>Teeth, axes and names of what is selected.</source>
        <translation>Dientes, ejes y nombres de lo seleccionado.</translation>
    </message>
    <message>
        <source>The mechanism in section, as in textbooks. You can draw here, too.</source>
        <translation>El mecanismo en sección, como en los libros de texto. También aquí se puede dibujar.</translation>
    </message>
    <message>
        <source>Speeds over one period of the motion.</source>
        <translation>Velocidades durante un periodo del movimiento.</translation>
    </message>
    <message>
        <source>The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit.</source>
        <translation>Las ruedas en movimiento. Arrastrar una rueda gira el tren; arrastrar fuera gira la vista.</translation>
    </message>
    <message>
        <source>Fewest brakes</source>
        <translation>Menos frenos</translation>
    </message>
    <message>
        <source>Most brakes</source>
        <translation>Más frenos</translation>
    </message>
    <message>
        <source>Fewest clutches</source>
        <translation>Menos embragues</translation>
    </message>
    <message>
        <source>Most clutches</source>
        <translation>Más embragues</translation>
    </message>
    <message>
        <source>Least ring : sun</source>
        <translation>Menor corona : sol</translation>
    </message>
    <message>
        <source>Largest ring : sun</source>
        <translation>Mayor corona : sol</translation>
    </message>
    <message>
        <source>a folder for the documents of the candidates</source>
        <translation>una carpeta para los documentos de los candidatos</translation>
    </message>
    <message>
        <source>Hub gear</source>
        <translation>Cambio de buje</translation>
    </message>
    <message>
        <source>driver</source>
        <translation>propulsor</translation>
    </message>
    <message>
        <source>hub shell</source>
        <translation>cuerpo del buje</translation>
    </message>
    <message>
        <source>shaft %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>ring %1</source>
        <translation>corona %1</translation>
    </message>
    <message>
        <source>carrier %1</source>
        <translation>portasatélites %1</translation>
    </message>
    <message>
        <source>sun %1</source>
        <translation>solar %1</translation>
    </message>
    <message>
        <source>Found from the ratios of a hub gear. One planet of each set is drawn; numbers of equal planets that go in: %1.</source>
        <translation>Hallado a partir de las relaciones de un cambio de buje. De cada tren se dibuja un satélite; números de satélites iguales que caben: %1.</translation>
    </message>
    <message>
        <source>Gearboxes with the ratios that you want. Space ticks one for comparison, Enter opens it as a document, Esc pauses the search.</source>
        <translation>Cajas de cambios con las relaciones deseadas. Espacio marca una para comparar, Intro la abre como documento, Esc pausa la búsqueda.</translation>
    </message>
    <message>
        <source>Ratios to hardware</source>
        <translation>De relaciones a mecanismo</translation>
    </message>
    <message>
        <source>What may be inside a hub gear with the ratios of its maker&apos;s sheet, and which wheel to count. Enter opens a candidate as a document.</source>
        <translation>Qué puede haber dentro de un cambio de buje con las relaciones de la hoja del fabricante y qué rueda contar. Intro abre un candidato como documento.</translation>
    </message>
    <message>
        <source>Finds the planetary sets that may be inside a hub gear with given ratios, and what to count in it.</source>
        <translation>Halla los trenes epicicloidales que puede haber en un cambio de buje con las relaciones dadas y qué contar en él.</translation>
    </message>
    <message>
        <source>Searches for gearboxes with these ratios (Ctrl+Return)</source>
        <translation>Busca cajas de cambios con estas relaciones (Ctrl+Intro)</translation>
    </message>
    <message>
        <source>Save wish…</source>
        <translation>Guardar petición…</translation>
    </message>
    <message>
        <source>Writes the wish as a file for geargraph-cli gearbox, which searches on many machines</source>
        <translation>Escribe la petición como archivo para geargraph-cli gearbox, que busca en muchas máquinas</translation>
    </message>
    <message>
        <source>This variant exceeds a limit of the wish.</source>
        <translation>Esta variante supera un límite de la petición.</translation>
    </message>
    <message>
        <source>Save wish</source>
        <translation>Guardar petición</translation>
    </message>
    <message>
        <source>, about %1 s to go</source>
        <translation>, faltan unos %1 s</translation>
    </message>
    <message>
        <source>, about %1 min to go</source>
        <translation>, faltan unos %1 min</translation>
    </message>
    <message>
        <source>None was found: no layout comes near these ratios.&lt;br&gt;More elements, another number of links, another set, or wider limits of ring : sun may help.</source>
        <translation>No se halló ninguna: ninguna disposición se acerca a estas relaciones.&lt;br&gt;Pueden ayudar más elementos, otro número de eslabones, otro tren o límites más amplios de corona : solar.</translation>
    </message>
    <message>
        <source>None was found: %1 shift tables come near these ratios, but no whole teeth do.&lt;br&gt;A larger tolerance, or rings with more teeth may help.</source>
        <translation>No se halló ninguna: %1 tablas de marchas se acercan a estas relaciones, pero no con dientes enteros.&lt;br&gt;Puede ayudar una tolerancia mayor o coronas con más dientes.</translation>
    </message>
    <message>
        <source>None was found: %1 gearboxes have these ratios, but not so many brakes and clutches.</source>
        <translation>No se halló ninguna: %1 cajas tienen estas relaciones, pero no ese número de frenos y embragues.</translation>
    </message>
    <message>
        <source>None was found: %1 gearboxes have these ratios, but are beyond the limits at the end of the wish.</source>
        <translation>No se halló ninguna: %1 cajas tienen estas relaciones, pero superan los límites del final de la petición.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Shows only gearboxes with a property (Ctrl+F); H hides a single one, Ctrl+Z brings it back</source>
        <translation>Muestra solo cajas con una propiedad (Ctrl+F); H oculta una sola, Ctrl+Z la recupera</translation>
    </message>
    <message>
        <source>There is nothing in which these gearboxes differ.</source>
        <translation>No hay nada en que difieran estas cajas de cambios.</translation>
    </message>
    <message>
        <source>Hides %1; a click lets go of it</source>
        <translation>Oculta %1; un clic lo quita</translation>
    </message>
    <message>
        <source>hidden: %1</source>
        <translation>ocultas: %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 de %2 mostradas</translation>
    </message>
    <message>
        <source>What gearboxes are compared by</source>
        <translation>En qué se comparan las cajas de cambios</translation>
    </message>
    <message>
        <source>Brakes and clutches with the same speeds, but other torques and slips</source>
        <translation>Frenos y embragues con las mismas velocidades, pero otros momentos y deslizamientos</translation>
    </message>
    <message>
        <source>Schematic of the gearbox</source>
        <translation>Esquema de la caja de cambios</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3, largest torque %4, largest slip %5</source>
        <translation>%1: %2 en lugar de %3, momento máximo %4, deslizamiento máximo %5</translation>
    </message>
    <message>
        <source>None of them is within the limits of the wish.</source>
        <translation>Ninguna está dentro de los límites de la petición.</translation>
    </message>
    <message>
        <source>error ≤ %1 %</source>
        <translation>error ≤ %1 %</translation>
    </message>
    <message>
        <source>no circulating power</source>
        <translation>sin potencia circulante</translation>
    </message>
    <message>
        <source>elements ≤ %1</source>
        <translation>elementos ≤ %1</translation>
    </message>
    <message>
        <source>brakes ≤ %1</source>
        <translation>frenos ≤ %1</translation>
    </message>
    <message>
        <source>clutches ≤ %1</source>
        <translation>embragues ≤ %1</translation>
    </message>
    <message>
        <source>worst η ≥ %1</source>
        <translation>peor η ≥ %1</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>error máximo</translation>
    </message>
    <message>
        <source>worst efficiency</source>
        <translation>peor rendimiento</translation>
    </message>
    <message>
        <source>circulating power</source>
        <translation>potencia circulante</translation>
    </message>
    <message>
        <source>fastest member</source>
        <translation>miembro más rápido</translation>
    </message>
    <message>
        <source>largest torque</source>
        <translation>momento máximo</translation>
    </message>
    <message>
        <source>largest slip</source>
        <translation>deslizamiento máximo</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>amplitud</translation>
    </message>
    <message>
        <source>largest ring</source>
        <translation>corona máxima</translation>
    </message>
    <message>
        <source>Tick two to compare them (Space)</source>
        <translation>Marque dos para compararlas (Espacio)</translation>
    </message>
    <message>
        <source>A bar a set, its links at their exact places; the filled points are input and output</source>
        <translation>Una barra por tren, con sus eslabones en su lugar exacto; los puntos llenos son entrada y salida</translation>
    </message>
    <message>
        <source>The speed of the fastest link, as a multiple of the input&apos;s</source>
        <translation>La velocidad del eslabón más rápido, como múltiplo de la de entrada</translation>
    </message>
    <message>
        <source>The largest torque in a brake or clutch, as a multiple of the input&apos;s</source>
        <translation>El mayor momento en un freno o embrague, como múltiplo del de entrada</translation>
    </message>
    <message>
        <source>levers</source>
        <translation>palancas</translation>
    </message>
    <message>
        <source>schematic</source>
        <translation>esquema</translation>
    </message>
    <message>
        <source>Schematic of the candidate</source>
        <translation>Esquema del candidato</translation>
    </message>
    <message>
        <source>Opens this candidate with a state for each gear, in a new window (Return)</source>
        <translation>Abre este candidato con un estado por marcha en una ventana nueva (Intro)</translation>
    </message>
    <message>
        <source>What can be counted or measured</source>
        <translation>Qué se puede contar o medir</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>otro número</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Otra respuesta</translation>
    </message>
    <message>
        <source>This is it, within your limits.</source>
        <translation>Es este, dentro de sus límites.</translation>
    </message>
    <message>
        <source>count %1: leaves %2 at most</source>
        <translation>contar %1: quedan %2 como máximo</translation>
    </message>
    <message>
        <source>turn %1: leaves %2 at most</source>
        <translation>girar %1: quedan %2 como máximo</translation>
    </message>
    <message>
        <source>One measurement decides</source>
        <translation>Una medición decide</translation>
    </message>
    <message>
        <source>No single measurement decides</source>
        <translation>Ninguna medición sola decide</translation>
    </message>
    <message>
        <source>Count the teeth of %1. You counted</source>
        <translation>Cuente los dientes de %1. Ha contado</translation>
    </message>
    <message>
        <source>Turn the input %1 times in %2. The output turned, in degrees,</source>
        <translation>Gire la entrada %1 veces en %2. La salida giró, en grados,</translation>
    </message>
    <message>
        <source>no such wheel</source>
        <translation>no hay tal rueda</translation>
    </message>
    <message>
        <source>leaves %1</source>
        <translation>quedan %1</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Candidato %1</translation>
    </message>
    <message>
        <source>Choose a candidate of the list.</source>
        <translation>Elija un candidato de la lista.</translation>
    </message>
    <message>
        <source>Wheel over sprocket of each gear as the sheet prints it: typed or pasted</source>
        <translation>Rueda entre piñón de cada marcha como lo imprime la hoja: tecleado o pegado</translation>
    </message>
    <message>
        <source>0.632 0.741 0.843 …</source>
        <translation>0,632 0,741 0,843 …</translation>
    </message>
    <message>
        <source>that with 1</source>
        <translation>la de 1</translation>
    </message>
    <message>
        <source>The gear that passes the motion through. The others may then be in percent, or metres a turn.</source>
        <translation>La marcha que pasa el movimiento directo. Las otras pueden estar entonces en tanto por ciento o en metros por vuelta.</translation>
    </message>
    <message>
        <source>direct gear</source>
        <translation>marcha directa</translation>
    </message>
    <message>
        <source>rounded as printed</source>
        <translation>redondeado como se imprime</translation>
    </message>
    <message>
        <source>tolerance, %</source>
        <translation>tolerancia, %</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Lo que se sabe</translation>
    </message>
    <message>
        <source>Planetary sets in series, at most</source>
        <translation>Trenes epicicloidales en serie, como máximo</translation>
    </message>
    <message>
        <source>sets in series</source>
        <translation>trenes en serie</translation>
    </message>
    <message>
        <source>stepped planets</source>
        <translation>satélites escalonados</translation>
    </message>
    <message>
        <source>Planets with several wheels, each with a sun of its own</source>
        <translation>Satélites con varias ruedas, cada una con su propio solar</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>coronas</translation>
    </message>
    <message>
        <source>Teeth by which the sums of one set may differ, made up by profile shift</source>
        <translation>Dientes en que pueden diferir las sumas de un tren, compensados con desplazamiento de perfil</translation>
    </message>
    <message>
        <source>slack</source>
        <translation>holgura</translation>
    </message>
    <message>
        <source>Wheels whose teeth have been counted: set and wheel, then the teeth</source>
        <translation>Ruedas cuyos dientes se han contado: tren y rueda, luego los dientes</translation>
    </message>
    <message>
        <source>Counted teeth</source>
        <translation>Dientes contados</translation>
    </message>
    <message>
        <source>Products of the ratios of two sets</source>
        <translation>Productos de las relaciones de dos trenes</translation>
    </message>
    <message>
        <source>Rows: ratios of the first set. Columns: of the second. Gears are products of both.</source>
        <translation>Filas: relaciones del primer tren. Columnas: del segundo. Las marchas son productos de ambos.</translation>
    </message>
    <message>
        <source>through</source>
        <translation>directo</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1, no usado</translation>
    </message>
    <message>
        <source>planets %1</source>
        <translation>satélites %1</translation>
    </message>
    <message>
        <source>No equal planets at equal distances can be assembled.</source>
        <translation>No se pueden montar satélites iguales a distancias iguales.</translation>
    </message>
    <message>
        <source>A click takes this answer back</source>
        <translation>Un clic retira esta respuesta</translation>
    </message>
    <message>
        <source>Candidates: %1, of %2 tooth sets with these ratios</source>
        <translation>Candidatos: %1, de %2 juegos de dientes con estas relaciones</translation>
    </message>
    <message>
        <source>What is inside a hub with these ratios?</source>
        <translation>¿Qué hay dentro de un buje con estas relaciones?</translation>
    </message>
    <message>
        <source>All tooth sets tried: complete. By set: %1.</source>
        <translation>Probados todos los juegos de dientes: completo. Por tren: %1.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>Type the ratios of the maker&apos;s sheet and choose Search.&lt;br&gt;A hub with seven gears: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</source>
        <translation>Teclee las relaciones de la hoja del fabricante y elija Buscar.&lt;br&gt;Un buje de siete marchas: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</translation>
    </message>
    <message>
        <source>None has this number: was it counted rightly, or are the limits too narrow?</source>
        <translation>Ninguno tiene este número: ¿se contó bien o son demasiado estrechos los límites?</translation>
    </message>
    <message>
        <source>None: some ratio is no product of the others. Are all of them rounded to the same place? More sets may explain them.</source>
        <translation>Ninguno: alguna relación no es producto de las otras. ¿Están todas redondeadas a la misma cifra? Más trenes pueden explicarlas.</translation>
    </message>
    <message>
        <source>the ring of set %1</source>
        <translation>la corona del tren %1</translation>
    </message>
    <message>
        <source>sun %2 of set %1</source>
        <translation>solar %2 del tren %1</translation>
    </message>
    <message>
        <source>planet step %2 of set %1</source>
        <translation>escalón %2 del satélite del tren %1</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Ratios to hardware…</source>
        <translation>De relaciones a mecanismo…</translation>
    </message>
    <message>
        <source>What may be inside a hub gear with these ratios, and what to count</source>
        <translation>Qué puede haber en un cambio de buje con estas relaciones y qué contar</translation>
    </message>
    <message>
        <source>Closes this tab; what it holds stays</source>
        <translation>Cierra esta pestaña; lo que contiene se conserva</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>Cerrar %1</translation>
    </message>
    <message>
        <source>Gearbox from ratios…</source>
        <translation>Caja de cambios por relaciones…</translation>
    </message>
    <message>
        <source>This is a document of its own. Save keeps it.</source>
        <translation>Es un documento propio. Guardar lo conserva.</translation>
    </message>
    <message>
        <source>Ratios with the drawn teeth; * is not the stated one</source>
        <translation>Relaciones con los dientes dibujados; * no es la indicada</translation>
    </message>
    <message>
        <source>The drawn teeth have all stated ratios.</source>
        <translation>Los dientes dibujados dan todas las relaciones indicadas.</translation>
    </message>
    <message>
        <source>No teeth near the drawn ones have all stated ratios.</source>
        <translation>Ningún número de dientes próximo a los dibujados da todas las relaciones indicadas.</translation>
    </message>
    <message>
        <source>instead of the drawn teeth</source>
        <translation>en lugar de los dientes dibujados</translation>
    </message>
    <message>
        <source>Which teeth were meant? Wheels that differ: %1, choices: %2</source>
        <translation>¿Qué dientes se querían decir? Ruedas que difieren: %1, opciones: %2</translation>
    </message>
    <message>
        <source>the ratios are stated ones: which teeth near the drawn ones have them?</source>
        <translation>las relaciones son las indicadas: ¿qué dientes próximos a los dibujados las dan?</translation>
    </message>
    <message>
        <source>with --meant: wheels that may differ, at most (3)</source>
        <translation>con --meant: ruedas que pueden diferir, como máximo (3)</translation>
    </message>
    <message>
        <source>with --meant: teeth by which a wheel may differ (5)</source>
        <translation>con --meant: dientes en que puede diferir una rueda (5)</translation>
    </message>
    <message>
        <source>Fewest teeth: %1</source>
        <translation>Menos dientes: %1</translation>
    </message>
    <message>
        <source>Most teeth: %1</source>
        <translation>Más dientes: %1</translation>
    </message>
    <message>
        <source>Lever diagram of the gearbox</source>
        <translation>Diagrama de palancas de la caja de cambios</translation>
    </message>
    <message>
        <source>sun %1.%2</source>
        <translation>solar %1.%2</translation>
    </message>
    <message>
        <source>None: no whole teeth within the limits have these ratios. A slack of 1 to 3, or wider limits, may help.</source>
        <translation>Ninguno: ningún número entero de dientes dentro de los límites da estas relaciones. Puede ayudar una holgura de 1 a 3 o límites más amplios.</translation>
    </message>
    <message>
        <source>ratio %1 (%2)</source>
        <translation>la relación %1 (%2)</translation>
    </message>
    <message>
        <source>No choice within the limits has %1.</source>
        <translation>Ninguna opción dentro de los límites tiene %1.</translation>
    </message>
    <message>
        <source>No choice within the limits has both %1 and %2.</source>
        <translation>Ninguna opción dentro de los límites tiene a la vez %1 y %2.</translation>
    </message>
    <message>
        <source>Levers. Points: links of a gear set at exact distances; arrows: their speeds.</source>
        <translation>Palancas. Puntos: eslabones de un tren a distancias exactas; flechas: sus velocidades.</translation>
    </message>
    <message>
        <source>Nomogram. A line for each state through the speeds of the links, the drive being 1.</source>
        <translation>Nomograma. Una línea por estado que pasa por las velocidades de los eslabones; el accionamiento es 1.</translation>
    </message>
    <message>
        <source>%1 is engaged: the plane projected along its line</source>
        <translation>%1 está activado: el plano proyectado a lo largo de su línea</translation>
    </message>
    <message>
        <source>peripheral velocity in %1/s</source>
        <translation>velocidad periférica en %1/s</translation>
    </message>
    <message>
        <source>A line for each link; its slope is the speed in rad/s. Filled points: teeth; others: carried axes.</source>
        <translation>Una línea por eslabón; su pendiente es la velocidad en rad/s. Puntos llenos: dientes; los demás: ejes llevados.</translation>
    </message>
    <message>
        <source>Mesh %1 joins axes that are not in one plane with that of their carrier: its lines do not meet.</source>
        <translation>El engrane %1 une ejes que no están en un plano con el de su portasatélites: sus líneas no se cortan.</translation>
    </message>
    <message>
        <source>Meshes %1 join axes that are not in one plane with that of their carrier: their lines do not meet.</source>
        <translation>Los engranes %1 unen ejes que no están en un plano con el de su portasatélites: sus líneas no se cortan.</translation>
    </message>
    <message>
        <source>The section is unrolled in another way: not all teeth are at the heights of the plan.</source>
        <translation>La sección está desarrollada de otro modo: no todos los dientes están a las alturas del plano.</translation>
    </message>
    <message>
        <source>No speed plan: the train is not finished, see Problems.</source>
        <translation>No hay plano de velocidades: el tren no está terminado, vea Problemas.</translation>
    </message>
    <message>
        <source>No speed plan: the speeds are not determined, see Problems.</source>
        <translation>No hay plano de velocidades: las velocidades no están determinadas, vea Problemas.</translation>
    </message>
    <message>
        <source>No speed plan: it needs axes that are all parallel.</source>
        <translation>No hay plano de velocidades: necesita ejes que sean todos paralelos.</translation>
    </message>
    <message>
        <source>Each gear set is a lever: its links on the ground&apos;s axis are points with exact places, 0 at one end and 1 at the other. In every motion the speed of a link is an affine function of its place, $\omega(x) = \omega(0) + x\,(\omega(1) - \omega(0))$.</source>
        <translation>Cada tren es una palanca: sus eslabones en el eje del bastidor son puntos en lugares exactos, 0 en un extremo y 1 en el otro. En todo movimiento la velocidad de un eslabón es una función afín de su lugar, $\omega(x) = \omega(0) + x\,(\omega(1) - \omega(0))$.</translation>
    </message>
    <message>
        <source>Nomogram of the states, the speed of the drive being 1</source>
        <translation>Nomograma de los estados; la velocidad del accionamiento es 1</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Speed in rad/s</source>
        <translation>Velocidad en rad/s</translation>
    </message>
    <message>
        <source>Lever of %1, %2 teeth:</source>
        <translation>Palanca de %1, %2 dientes:</translation>
    </message>
    <message>
        <source>These links are on one lever by these tooth counts only.</source>
        <translation>Estos eslabones están en una palanca solo con estos números de dientes.</translation>
    </message>
    <message>
        <source>A view is digraph, tt-graph, schematic, levers or nomogram.</source>
        <translation>Una vista es digraph, tt-graph, schematic, levers o nomogram.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; is on no lever.</source>
        <translation>El eslabón «%1» no está en ninguna palanca.</translation>
    </message>
    <message>
        <source>Speed plan</source>
        <translation>Plano de velocidades</translation>
    </message>
    <message>
        <source>Kutzbach&apos;s plan beside the section: peripheral velocities over the radius, a line for each link</source>
        <translation>El plano de Kutzbach junto a la sección: velocidades periféricas sobre el radio, una línea por eslabón</translation>
    </message>
    <message>
        <source>Click the point to lock link %1 with. Esc ends</source>
        <translation>Haga clic en el punto que se une al eslabón %1. Esc termina</translation>
    </message>
    <message>
        <source>Each line is a link: its slope is the speed, lines cross at the teeth</source>
        <translation>Cada línea es un eslabón: su pendiente es la velocidad; las líneas se cruzan en los dientes</translation>
    </message>
    <message>
        <source>Lock with…</source>
        <translation>Unir con…</translation>
    </message>
    <message>
        <source>A clutch to the link that you click next</source>
        <translation>Un embrague al eslabón en que haga clic después</translation>
    </message>
    <message>
        <source>Let go (B)</source>
        <translation>Soltar (B)</translation>
    </message>
    <message>
        <source>Hold (B)</source>
        <translation>Retener (B)</translation>
    </message>
    <message>
        <source>Release the brake of this link</source>
        <translation>Liberar el freno de este eslabón</translation>
    </message>
    <message>
        <source>Engage the brake of this link, a new one where it has none</source>
        <translation>Activar el freno de este eslabón, uno nuevo si no tiene</translation>
    </message>
    <message>
        <source>The speeds of these joints do not determine those of the motors.</source>
        <translation>Las velocidades de estas articulaciones no determinan las de los motores.</translation>
    </message>
    <message>
        <source>There are %1 motors: name as many joints, not %2.</source>
        <translation>Hay %1 motores: nombre el mismo número de articulaciones, no %2.</translation>
    </message>
    <message>
        <source>The joints are %1: --outputs names others.</source>
        <translation>Las articulaciones son %1: --outputs nombra otras.</translation>
    </message>
    <message>
        <source>the coupling of motors and joints</source>
        <translation>el acoplamiento de motores y articulaciones</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (JSON)</source>
        <translation>Acoplamiento de motores y articulaciones (JSON)</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (C++)</source>
        <translation>Acoplamiento de motores y articulaciones (C++)</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (Python)</source>
        <translation>Acoplamiento de motores y articulaciones (Python)</translation>
    </message>
    <message>
        <source>Transmissions of ros2_control (XML)</source>
        <translation>Transmisiones de ros2_control (XML)</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>Controladores</translation>
    </message>
    <message>
        <source>the joints that the motors drive, by label, as many as motors (the chain from the ground to a link that they determine)</source>
        <translation>las articulaciones que mueven los motores, por etiqueta, tantas como motores (la cadena del bastidor a un eslabón que ellos determinan)</translation>
    </message>
    <message>
        <source>json (the default), header (C++17), python, or ros2 (transmissions of ros2_control); each of header and python tests itself</source>
        <translation>json (por omisión), header (C++17), python o ros2 (transmisiones de ros2_control); header y python se comprueban a sí mismos</translation>
    </message>
    <message>
        <source>Written as</source>
        <translation>Escrito como</translation>
    </message>
    <message>
        <source>In the gearbox designer: search</source>
        <translation>En el diseñador de cajas: buscar</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Intro</translation>
    </message>
    <message>
        <source>forms: html,latex,pdf,json,handout,scorm (html,latex,pdf)</source>
        <translation>formas: html,latex,pdf,json,handout,scorm (html,latex,pdf)</translation>
    </message>
    <message>
        <source>which mistake, how often, by whom: a .csv or a page with bars (.html)</source>
        <translation>qué error, cuántas veces, de quién: un .csv o una página con barras (.html)</translation>
    </message>
    <message>
        <source>--summary is a file that ends in .csv or .html.</source>
        <translation>--summary es un archivo que termina en .csv o .html.</translation>
    </message>
    <message>
        <source>--to lists forms out of html, latex, pdf, json, handout and scorm, not &quot;%1&quot;.</source>
        <translation>--to enumera formas de entre html, latex, pdf, json, handout y scorm, no «%1».</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Estudiante</translation>
    </message>
    <message>
        <source>File for answers</source>
        <translation>Archivo para las respuestas</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>sin responder</translation>
    </message>
    <message>
        <source>wrong, by no known mistake</source>
        <translation>incorrecta, sin error conocido</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>Question %1: %2</source>
        <translation>Pregunta %1: %2</translation>
    </message>
    <message>
        <source>Handout</source>
        <translation>Hoja interactiva</translation>
    </message>
    <message>
        <source>SCORM package</source>
        <translation>Paquete SCORM</translation>
    </message>
    <message>
        <source>A page for each variant, with the train in 3D, that grades what is filled in</source>
        <translation>Una página por variante, con el tren en 3D, que califica lo que se escribe</translation>
    </message>
    <message>
        <source>That page for each variant as a package for learning platforms</source>
        <translation>Esa página por variante como paquete para plataformas de aprendizaje</translation>
    </message>
    <message>
        <source>right-hand</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>left-hand</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>&quot;right&quot; or &quot;left&quot;</source>
        <translation>&quot;right&quot; o &quot;left&quot;</translation>
    </message>
    <message>
        <source>right, left or nothing</source>
        <translation>right, left o nada</translation>
    </message>
    <message>
        <source>The helix angle of a gear mesh is at least 0 and below 90 degrees.</source>
        <translation>El ángulo de hélice de un engrane es al menos 0 y menor que 90 grados.</translation>
    </message>
    <message>
        <source>The module of a gear mesh is above 0.</source>
        <translation>El módulo de un engrane es mayor que 0.</translation>
    </message>
    <message>
        <source>The pressure angle of a gear mesh is above 0 and below 90 degrees.</source>
        <translation>El ángulo de presión de un engrane es mayor que 0 y menor que 90 grados.</translation>
    </message>
    <message>
        <source>its module %1 makes a centre distance of %2, and the axes are %3 apart: profile shifts make up for two modules at most. What fits: the module %4.</source>
        <translation>su módulo %1 da una distancia entre centros de %2, y los ejes están a %3: los desplazamientos de perfil compensan dos módulos como mucho. Lo que encaja: el módulo %4.</translation>
    </message>
    <message>
        <source>Meshes %1 and %2 give the teeth of gear %3 different helix angles or hands. What fits: one helix for both (a wheel and the ring round it have the same hand, two wheels beside each other opposite ones), or two wheels with names of their own.</source>
        <translation>Los engranes %1 y %2 dan a los dientes de la rueda %3 ángulos o sentidos de hélice distintos. Lo que encaja: una hélice para ambos (una rueda y la corona que la rodea tienen el mismo sentido, dos ruedas contiguas sentidos opuestos), o dos ruedas con nombres propios.</translation>
    </message>
    <message>
        <source>Meshes %1 and %2 give gear %3 different modules. What fits: one module for both, or two wheels with names of their own.</source>
        <translation>Los engranes %1 y %2 dan a la rueda %3 módulos distintos. Lo que encaja: un módulo para ambos, o dos ruedas con nombres propios.</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>correa</translation>
    </message>
    <message>
        <source>pins</source>
        <translation>pernos</translation>
    </message>
    <message>
        <source>Make %1 a belt</source>
        <translation>Convertir %1 en una correa</translation>
    </message>
    <message>
        <source>Make %1 a pair of pins and holes</source>
        <translation>Convertir %1 en pernos y agujeros</translation>
    </message>
    <message>
        <source>freewheel %1</source>
        <translation>rueda libre %1</translation>
    </message>
    <message>
        <source>&quot;brake&quot;, &quot;clutch&quot; or &quot;freewheel&quot;</source>
        <translation>&quot;brake&quot;, &quot;clutch&quot; o &quot;freewheel&quot;</translation>
    </message>
    <message>
        <source>Only a belt is crossed, or has a pitch or running diameters; mesh &quot;%1&quot; is none.</source>
        <translation>Solo una correa puede ser cruzada o tener paso o diámetros de rodadura; el engrane «%1» no lo es.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; has no teeth that slide: state its `efficiency`, not a `friction`.</source>
        <translation>El engrane «%1» no tiene dientes que deslicen: indique su `efficiency`, no una `friction`.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; is a belt or pins, which have no pitch point: leave it out.</source>
        <translation>El engrane «%1» es una correa o pernos, que no tienen punto primitivo: omítalo.</translation>
    </message>
    <message>
        <source>Pitch and running diameters of belt &quot;%1&quot; are above 0.</source>
        <translation>El paso y los diámetros de rodadura de la correa «%1» son mayores que 0.</translation>
    </message>
    <message>
        <source>Belt &quot;%1&quot; has teeth at both ends, or running diameters at both.</source>
        <translation>La correa «%1» tiene dientes en ambos extremos, o diámetros de rodadura en ambos.</translation>
    </message>
    <message>
        <source>The running diameters of belt &quot;%1&quot; are in the ratio of two whole numbers up to 100,000: give them with fewer digits.</source>
        <translation>Los diámetros de rodadura de la correa «%1» están en la razón de dos números enteros de hasta 100 000: indíquelos con menos cifras.</translation>
    </message>
    <message>
        <source>Pins turn 1 : 1 and belts with running diameters in their ratio; mesh &quot;%1&quot; states other teeth: leave them out.</source>
        <translation>Los pernos giran 1 : 1 y las correas con diámetros de rodadura en su razón; el engrane «%1» indica otros dientes: omítalos.</translation>
    </message>
    <message>
        <source>A freewheel names two links.</source>
        <translation>Una rueda libre nombra dos eslabones.</translation>
    </message>
    <message>
        <source>Freewheel &quot;%1&quot; ties link &quot;%2&quot; to itself.</source>
        <translation>La rueda libre «%1» une el eslabón «%2» consigo mismo.</translation>
    </message>
    <message>
        <source>State &quot;%1&quot; engages freewheel &quot;%2&quot;, which locks by itself: leave it out.</source>
        <translation>El estado «%1» acopla la rueda libre «%2», que se bloquea sola: omítala.</translation>
    </message>
    <message>
        <source>The direction of a state is 1 or -1.</source>
        <translation>El sentido de un estado es 1 o -1.</translation>
    </message>
    <message>
        <source>A freewheel needs two different links.</source>
        <translation>Una rueda libre necesita dos eslabones distintos.</translation>
    </message>
    <message>
        <source>A belt and pins have no module: state a pitch or running diameters.</source>
        <translation>Una correa y unos pernos no tienen módulo: indique un paso o diámetros de rodadura.</translation>
    </message>
    <message>
        <source>it says %1, but its axes are skew. What fits: parallel axes.</source>
        <translation>dice %1, pero sus ejes se cruzan sin cortarse. Lo que encaja: ejes paralelos.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet. What fits: bevel, or parallel axes.</source>
        <translation>dice %1, pero sus ejes se cortan. Lo que encaja: cónico, o ejes paralelos.</translation>
    </message>
    <message>
        <source>its pulleys overlap: the running radii %1 and %2 need more than the %3 between the axes. What fits: smaller ones, or axes farther apart.</source>
        <translation>sus poleas se solapan: los radios de rodadura %1 y %2 necesitan más que los %3 entre los ejes. Lo que encaja: más pequeños, o ejes más separados.</translation>
    </message>
    <message>
        <source>State %1: more than one pattern of locked and free freewheels is possible; shown is the one with these locked: %2.</source>
        <translation>Estado %1: es posible más de una combinación de ruedas libres bloqueadas y sueltas; se muestra aquella con estas bloqueadas: %2.</translation>
    </message>
    <message>
        <source>State %1: the drive overruns its freewheels and drives nothing this way (locked they would turn as shown: %2). Exchange the two links of one, or turn the drive the other way.</source>
        <translation>Estado %1: la entrada adelanta a sus ruedas libres y así no arrastra nada (bloqueadas girarían como se muestra: %2). Intercambie los dos eslabones de una, o gire la entrada al revés.</translation>
    </message>
    <message>
        <source>Freewheel %1 locks before link %2 turns faster than link %3, but the given speeds make it faster by %4 rad/s. Engage it, exchange its links, or turn the inputs the other way.</source>
        <translation>La rueda libre %1 se bloquea antes de que el eslabón %2 gire más rápido que el %3, pero las velocidades dadas lo hacen más rápido en %4 rad/s. Acóplela, intercambie sus eslabones o gire las entradas al revés.</translation>
    </message>
    <message>
        <source>The torque that the freewheel exerts on the first of its links while it is locked; the second one has the reaction.</source>
        <translation>El par que la rueda libre bloqueada ejerce sobre el primero de sus eslabones; el segundo tiene la reacción.</translation>
    </message>
    <message>
        <source>Freewheel %1</source>
        <translation>Rueda libre %1</translation>
    </message>
    <message>
        <source>It locks where its first link would turn faster than its second.</source>
        <translation>Se bloquea donde su primer eslabón giraría más rápido que el segundo.</translation>
    </message>
    <message>
        <source>Mesh %1 is a belt: its pulleys turn the same way, seen from their carrier, and against each other where it is crossed.</source>
        <translation>El engrane %1 es una correa: sus poleas giran en el mismo sentido, vistas desde su portador, y en sentidos contrarios donde está cruzada.</translation>
    </message>
    <message>
        <source>Mesh %1 is a belt: its pulleys turn the same way, seen from the carrier, and opposite ways where it is crossed.</source>
        <translation>El engrane %1 es una correa: sus poleas giran igual, vistas desde el portador, y al revés donde está cruzada.</translation>
    </message>
    <message>
        <source>Mesh %1 is an open belt: seen from the carrier, its pulleys turn the same way, so that f is %2.</source>
        <translation>El engrane %1 es una correa abierta: vistas desde el portador, sus poleas giran en el mismo sentido, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a crossed belt: seen from the carrier, its pulleys turn against each other, so that f is %2.</source>
        <translation>El engrane %1 es una correa cruzada: vistas desde el portador, sus poleas giran en sentidos contrarios, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: seen from the carrier, both links turn alike, so that f is %2.</source>
        <translation>El engrane %1 son pernos en agujeros: vistos desde el portador, ambos eslabones giran igual, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: both links turn alike, seen from their carrier.</source>
        <translation>El engrane %1 son pernos en agujeros: ambos eslabones giran igual, vistos desde su portador.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: both links turn alike, seen from the carrier.</source>
        <translation>El engrane %1 son pernos en agujeros: ambos eslabones giran igual, vistos desde el portador.</translation>
    </message>
    <message>
        <source>%1 past link %2</source>
        <translation>%1 ante el eslabón %2</translation>
    </message>
    <message>
        <source>--input is the label of a joint or of a moving link, not &quot;%1&quot;.</source>
        <translation>--input es el número de una articulación o de un eslabón móvil, no «%1».</translation>
    </message>
    <message>
        <source>--rpm is above 0.</source>
        <translation>--rpm es mayor que 0.</translation>
    </message>
    <message>
        <source>At the given speed of the input shaft.</source>
        <translation>A la velocidad dada del eje de entrada.</translation>
    </message>
    <message>
        <source>Cycles for a turn of the input shaft, exactly.</source>
        <translation>Ciclos por vuelta del eje de entrada, exactamente.</translation>
    </message>
    <message>
        <source>From stop to stop at the output, every mesh at its worst.</source>
        <translation>De tope a tope en la salida, con cada engrane en su peor caso.</translation>
    </message>
    <message>
        <source>Give --json or --csv.</source>
        <translation>Indique --json o --csv.</translation>
    </message>
    <message>
        <source>Height and dashes tell what repeats, not how strongly.</source>
        <translation>La altura y el trazo indican qué se repite, no con qué intensidad.</translation>
    </message>
    <message>
        <source>How far outputs turn while inputs are held, by the play of the teeth.</source>
        <translation>Cuánto giran las salidas por el juego de los dientes mientras las entradas están fijas.</translation>
    </message>
    <message>
        <source>How far the input turns from stop to stop while the output is held.</source>
        <translation>Cuánto gira la entrada de tope a tope mientras la salida está fija.</translation>
    </message>
    <message>
        <source>How often the modulating frequency is added to the harmonic, or taken from it.</source>
        <translation>Cuántas veces se suma al armónico, o se le resta, la frecuencia moduladora.</translation>
    </message>
    <message>
        <source>Meshes that follow from others share their play; the tightest decides.</source>
        <translation>Los engranes que se siguen de otros comparten su juego; decide el más ajustado.</translation>
    </message>
    <message>
        <source>No input turns, so there are no frequencies.</source>
        <translation>Ninguna entrada gira, así que no hay frecuencias.</translation>
    </message>
    <message>
        <source>No joint follows an input.</source>
        <translation>Ninguna articulación sigue a una entrada.</translation>
    </message>
    <message>
        <source>No lost motion is known: the train has no solution, or is too large.</source>
        <translation>No se conoce el movimiento perdido: el tren no tiene solución o es demasiado grande.</translation>
    </message>
    <message>
        <source>No motion is known, so there are no frequencies.</source>
        <translation>No se conoce ningún movimiento, así que no hay frecuencias.</translation>
    </message>
    <message>
        <source>The frequencies of shafts, tooth meshes and planets, as ratios to the input shaft.</source>
        <translation>Las frecuencias de ejes, engranes y satélites, como razones respecto al eje de entrada.</translation>
    </message>
    <message>
        <source>The input that it is carried back to, by label.</source>
        <translation>La entrada a la que se refiere, por número.</translation>
    </message>
    <message>
        <source>The joint that turns while the inputs are held, by label.</source>
        <translation>La articulación que gira mientras las entradas están fijas, por número.</translation>
    </message>
    <message>
        <source>The mesh that contributes most, by label.</source>
        <translation>El engrane que más contribuye, por número.</translation>
    </message>
    <message>
        <source>The multiple of the tooth mesh.</source>
        <translation>El múltiplo del engrane.</translation>
    </message>
    <message>
        <source>The root of the sum of squares of the parts of all meshes.</source>
        <translation>La raíz de la suma de los cuadrados de las partes de todos los engranes.</translation>
    </message>
    <message>
        <source>The same in minutes of arc.</source>
        <translation>Lo mismo en minutos de arco.</translation>
    </message>
    <message>
        <source>The shaft does not turn (%1).</source>
        <translation>El eje no gira (%1).</translation>
    </message>
    <message>
        <source>The shaft has no speed of its own about one axis (%1).</source>
        <translation>El eje no tiene una velocidad determinada alrededor de un eje (%1).</translation>
    </message>
    <message>
        <source>The state whose couplings are engaged.</source>
        <translation>El estado cuyos acoplamientos están accionados.</translation>
    </message>
    <message>
        <source>What is lost of the worst case if that mesh has no play.</source>
        <translation>Lo que se pierde del peor caso si ese engrane no tiene juego.</translation>
    </message>
    <message>
        <source>What repeats.</source>
        <translation>Qué se repite.</translation>
    </message>
    <message>
        <source>Where it repeats, by label.</source>
        <translation>Dónde se repite, por número.</translation>
    </message>
    <message>
        <source>as CSV</source>
        <translation>como CSV</translation>
    </message>
    <message>
        <source>assembly phase</source>
        <translation>fase de montaje</translation>
    </message>
    <message>
        <source>at the input</source>
        <translation>en la entrada</translation>
    </message>
    <message>
        <source>Dashed: what either motor may do alone, for some angle of the other.</source>
        <translation>A trazos: lo que cada motor puede hacer solo, con algún ángulo del otro.</translation>
    </message>
    <message>
        <source>Degrees from the reference pose; all other motors stand in it.</source>
        <translation>Grados desde la pose de referencia; los demás motores están en ella.</translation>
    </message>
    <message>
        <source>Dotted sides are open: nothing limits the motors there.</source>
        <translation>Los lados punteados están abiertos: allí nada limita los motores.</translation>
    </message>
    <message>
        <source>Limits that these motors never reach: those of joints %1.</source>
        <translation>Límites que estos motores nunca alcanzan: los de los pares %1.</translation>
    </message>
    <message>
        <source>No joint that turns with these motors has limits.</source>
        <translation>Ningún par que gira con estos motores tiene límites.</translation>
    </message>
    <message>
        <source>Nothing moves that limits could stop.</source>
        <translation>No se mueve nada que los límites pudieran detener.</translation>
    </message>
    <message>
        <source>The mechanism is too large for exact limits.</source>
        <translation>El mecanismo es demasiado grande para límites exactos.</translation>
    </message>
    <message>
        <source>There are not two motors.</source>
        <translation>No hay dos motores.</translation>
    </message>
    <message>
        <source>joint %1 at %2</source>
        <translation>par %1 en %2</translation>
    </message>
    <message>
        <source>motor %1, degrees</source>
        <translation>motor %1, grados</translation>
    </message>
    <message>
        <source>cycles for a turn of the shaft (%1)</source>
        <translation>ciclos por vuelta del eje (%1)</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>frecuencia</translation>
    </message>
    <message>
        <source>harmonic</source>
        <translation>armónico</translation>
    </message>
    <message>
        <source>how many planets one stands for that is drawn alone (1)</source>
        <translation>a cuántos satélites representa uno dibujado solo (1)</translation>
    </message>
    <message>
        <source>hunting tooth</source>
        <translation>diente errante</translation>
    </message>
    <message>
        <source>input shaft: joint %1</source>
        <translation>eje de entrada: articulación %1</translation>
    </message>
    <message>
        <source>input shaft: link %1</source>
        <translation>eje de entrada: eslabón %1</translation>
    </message>
    <message>
        <source>its part</source>
        <translation>su parte</translation>
    </message>
    <message>
        <source>likely</source>
        <translation>probable</translation>
    </message>
    <message>
        <source>mesh %1, %2 planets past link %3</source>
        <translation>engrane %1, %2 satélites ante el eslabón %3</translation>
    </message>
    <message>
        <source>mesh %1, turns of link %2</source>
        <translation>engrane %1, vueltas del eslabón %2</translation>
    </message>
    <message>
        <source>multiples of each tooth mesh (1)</source>
        <translation>múltiplos de cada engrane (1)</translation>
    </message>
    <message>
        <source>of</source>
        <translation>de</translation>
    </message>
    <message>
        <source>on each side of each multiple (1)</source>
        <translation>a cada lado de cada múltiplo (1)</translation>
    </message>
    <message>
        <source>orders</source>
        <translation>órdenes</translation>
    </message>
    <message>
        <source>planets pass</source>
        <translation>paso de satélites</translation>
    </message>
    <message>
        <source>shaft</source>
        <translation>eje</translation>
    </message>
    <message>
        <source>sideband</source>
        <translation>banda lateral</translation>
    </message>
    <message>
        <source>the frequencies</source>
        <translation>las frecuencias</translation>
    </message>
    <message>
        <source>the joint or link (by label) that ratios are of, instead of the first input or the state&apos;s drive</source>
        <translation>la articulación o el eslabón (por número) al que se refieren las razones, en lugar de la primera entrada o del motor del estado</translation>
    </message>
    <message>
        <source>the lost motion</source>
        <translation>el movimiento perdido</translation>
    </message>
    <message>
        <source>the speed of the input shaft: frequencies also in Hz</source>
        <translation>la velocidad del eje de entrada: frecuencias también en Hz</translation>
    </message>
    <message>
        <source>tooth mesh</source>
        <translation>engrane</translation>
    </message>
    <message>
        <source>turns on its bearer</source>
        <translation>giro sobre su portador</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>A wheel without teeth in one plane has no profile.</source>
        <translation>Una rueda sin dientes en un plano no tiene perfil.</translation>
    </message>
    <message>
        <source>Left out, as they have no teeth in one plane: %1.</source>
        <translation>Se omiten, pues no tienen los dientes en un plano: %1.</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>los perfiles</translation>
    </message>
    <message>
        <source>Profiles of wheels (DXF)</source>
        <translation>Perfiles de ruedas (DXF)</translation>
    </message>
    <message>
        <source>profiles of wheels</source>
        <translation>perfiles de ruedas</translation>
    </message>
    <message>
        <source>Cutting profiles</source>
        <translation>Perfiles de corte</translation>
    </message>
    <message>
        <source>The program geargraph-step, which writes STEP files, is not installed; it is in the package of that name.</source>
        <translation>El programa geargraph-step, que escribe archivos STEP, no está instalado; está en el paquete de ese nombre.</translation>
    </message>
    <message>
        <source>OpenCASCADE could not make the solids or write the file.</source>
        <translation>OpenCASCADE no pudo formar los sólidos o escribir el archivo.</translation>
    </message>
    <message>
        <source>There are no solids to write.</source>
        <translation>No hay sólidos que escribir.</translation>
    </message>
    <message>
        <source>More than %1 faces are too many for a STEP file; --gear and --link export a part.</source>
        <translation>Más de %1 caras son demasiadas para un archivo STEP; --gear y --link exportan una parte.</translation>
    </message>
    <message>
        <source>Teeth of a worm&apos;s wheel are within %1 modules instead of %2 (--tolerance).</source>
        <translation>Los dientes de una corona de tornillo sin fin se desvían hasta %1 módulos en vez de %2 (--tolerance).</translation>
    </message>
    <message>
        <source>Of %1 part(s) the solids could not be united; they overlap.</source>
        <translation>En %1 pieza(s) los sólidos no se pudieron unir; se solapan.</translation>
    </message>
    <message>
        <source>%1 parts, %2 solids, teeth within %3 modules of their exact form.</source>
        <translation>%1 piezas, %2 sólidos, dientes a no más de %3 módulos de su forma exacta.</translation>
    </message>
    <message>
        <source>STEP (AP214), for CAD</source>
        <translation>STEP (AP214), para CAD</translation>
    </message>
    <message>
        <source>an assembly for CAD</source>
        <translation>un ensamblaje para CAD</translation>
    </message>
    <message>
        <source>CAD</source>
        <translation>CAD</translation>
    </message>
    <message>
        <source>Writing the STEP file took longer than %1 s.</source>
        <translation>Escribir el archivo STEP tardó más de %1 s.</translation>
    </message>
    <message>
        <source>The program geargraph-step crashed; nothing was written.</source>
        <translation>El programa geargraph-step se cerró de forma inesperada; no se escribió nada.</translation>
    </message>
    <message>
        <source>The program geargraph-step cannot be run.</source>
        <translation>El programa geargraph-step no se puede ejecutar.</translation>
    </message>
    <message>
        <source>The STEP file takes more memory or more bytes than there may be; export a part of the train.</source>
        <translation>El archivo STEP necesita más memoria o más bytes de lo permitido; exporte una parte del tren.</translation>
    </message>
    <message>
        <source>OpenCASCADE finds no valid solid in &quot;%1&quot;; nothing was written.</source>
        <translation>OpenCASCADE no encuentra un sólido válido en «%1»; no se escribió nada.</translation>
    </message>
    <message>
        <source>The program geargraph-step failed; nothing was written.</source>
        <translation>El programa geargraph-step falló; no se escribió nada.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 por %2</translation>
    </message>
    <message>
        <source>%1, %2: %3 should be %4.</source>
        <translation>%1, %2: %3 debe ser %4.</translation>
    </message>
    <message>
        <source>%1, %2: the sign of %3 is wrong; it is %4.</source>
        <translation>%1, %2: el signo de %3 es incorrecto; es %4.</translation>
    </message>
    <message>
        <source>%1: joint %2 is named twice.</source>
        <translation>%1: la articulación %2 está nombrada dos veces.</translation>
    </message>
    <message>
        <source>%1: there is no turning joint &quot;%2&quot;.</source>
        <translation>%1: no hay ninguna articulación giratoria «%2».</translation>
    </message>
    <message>
        <source>--outputs belongs to the matrices of a controller.</source>
        <translation>--outputs pertenece a las matrices de un controlador.</translation>
    </message>
    <message>
        <source>A matrix has at most %1 rows.</source>
        <translation>Una matriz tiene como máximo %1 filas.</translation>
    </message>
    <message>
        <source>A matrix is an array of rows.</source>
        <translation>Una matriz es un arreglo de filas.</translation>
    </message>
    <message>
        <source>A row is an array of numbers.</source>
        <translation>Una fila es un arreglo de números.</translation>
    </message>
    <message>
        <source>An object or an array of rows is needed.</source>
        <translation>Se necesita un objeto o un arreglo de filas.</translation>
    </message>
    <message>
        <source>Directions differ, too.</source>
        <translation>También difieren los sentidos de giro.</translation>
    </message>
    <message>
        <source>Matrix from %1: %2</source>
        <translation>Matriz de %1: %2</translation>
    </message>
    <message>
        <source>Motors %1, joints %2</source>
        <translation>Motores %1, articulaciones %2</translation>
    </message>
    <message>
        <source>Row %1 has %2 numbers; the matrix is square, with %3 rows.</source>
        <translation>La fila %1 tiene %2 números; la matriz es cuadrada, con %3 filas.</translation>
    </message>
    <message>
        <source>Say which matrix this is: --matrix motor-to-joint or joint-to-motor.</source>
        <translation>Indique qué matriz es: --matrix motor-to-joint o joint-to-motor.</translation>
    </message>
    <message>
        <source>The matrices and offsets are of different sizes.</source>
        <translation>Las matrices y los desfases son de tamaños distintos.</translation>
    </message>
    <message>
        <source>The matrices have %1 rows, the train has %2 motors.</source>
        <translation>Las matrices tienen %1 filas, el tren tiene %2 motores.</translation>
    </message>
    <message>
        <source>The offsets do not cancel: motor offset %1 is %2, the joints&apos; offsets ask for %3.</source>
        <translation>Los desfases no se cancelan: el desfase del motor %1 es %2, los de las articulaciones piden %3.</translation>
    </message>
    <message>
        <source>The two matrices are not inverse of each other: their product has %1 in row %2, column %3, not %4.</source>
        <translation>Las dos matrices no son inversas entre sí: su producto tiene %1 en la fila %2, columna %3, no %4.</translation>
    </message>
    <message>
        <source>There is neither &quot;motorToJoint&quot; nor &quot;jointToMotor&quot;.</source>
        <translation>No hay ni «motorToJoint» ni «jointToMotor».</translation>
    </message>
    <message>
        <source>There is no row of numbers.</source>
        <translation>No hay ninguna fila de números.</translation>
    </message>
    <message>
        <source>all is right but for factors: %1.</source>
        <translation>todo es correcto salvo factores: %1.</translation>
    </message>
    <message>
        <source>all would be right if these turned the other way: %1.</source>
        <translation>todo sería correcto si estos giraran al revés: %1.</translation>
    </message>
    <message>
        <source>all would be right with rows for %1 and columns for %2.</source>
        <translation>todo sería correcto con filas para %1 y columnas para %2.</translation>
    </message>
    <message>
        <source>joints to motors</source>
        <translation>articulaciones a motores</translation>
    </message>
    <message>
        <source>motor %1</source>
        <translation>motor %1</translation>
    </message>
    <message>
        <source>motors to joints</source>
        <translation>motores a articulaciones</translation>
    </message>
    <message>
        <source>of a controller: the joints of its rows or columns, by label (as export --to coupling takes them)</source>
        <translation>de un controlador: las articulaciones de sus filas o columnas, por número (como las toma export --to coupling)</translation>
    </message>
    <message>
        <source>rows and columns are exchanged: this is the transpose.</source>
        <translation>filas y columnas están intercambiadas: es la traspuesta.</translation>
    </message>
    <message>
        <source>this is the matrix from %1: the inverse.</source>
        <translation>es la matriz de %1: la inversa.</translation>
    </message>
    <message>
        <source>this is the matrix of torques, the transposed inverse.</source>
        <translation>es la matriz de pares, la inversa traspuesta.</translation>
    </message>
    <message>
        <source>which matrix it is: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p or solution (recognised); of a controller: motor-to-joint, joint-to-motor, or coupling for both as JSON</source>
        <translation>qué matriz es: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p o solution (se reconoce); de un controlador: motor-to-joint, joint-to-motor, o coupling para ambas como JSON</translation>
    </message>
    <message>
        <source>%1 is a whole number.</source>
        <translation>%1 es un número entero.</translation>
    </message>
    <message>
        <source>crossed helical</source>
        <translation>helicoidal cruzado</translation>
    </message>
    <message>
        <source>Make %1 crossed helical</source>
        <translation>Hacer %1 helicoidal cruzado</translation>
    </message>
    <message>
        <source>worm</source>
        <translation>tornillo sin fin</translation>
    </message>
    <message>
        <source>Make %1 a worm</source>
        <translation>Hacer %1 un tornillo sin fin</translation>
    </message>
    <message>
        <source>Teeth that cross at an angle are no herringbone teeth; mesh &quot;%1&quot; says so: leave it out.</source>
        <translation>Los dientes que se cruzan en ángulo no son dientes en espiga; el engrane «%1» lo dice: omítalo.</translation>
    </message>
    <message>
        <source>The helix of worm &quot;%1&quot; follows from its starts, the module and the distance of the axes: leave the helix angle out.</source>
        <translation>La hélice del tornillo sin fin «%1» resulta de sus entradas, el módulo y la distancia entre ejes: omita el ángulo de hélice.</translation>
    </message>
    <message>
        <source>its module %1 does not fit the distance of the axes: their pitch cylinders would not touch. What fits: the module %2.</source>
        <translation>su módulo %1 no encaja con la distancia entre ejes: los cilindros primitivos no se tocarían. Lo que encaja: el módulo %2.</translation>
    </message>
    <message>
        <source>no helix of this hand makes these teeth with pitch radii of %1 and %2. What fits: the other hand, or no pitch point.</source>
        <translation>ninguna hélice de este sentido da estos dientes con radios primitivos de %1 y %2. Lo que encaja: el otro sentido, o ningún punto primitivo.</translation>
    </message>
    <message>
        <source>a helix angle of %1 degrees leaves %2 for the head&apos;s gear, and at 90 teeth run round their axis. What fits: none, or a smaller one.</source>
        <translation>un ángulo de hélice de %1 grados deja %2 para la rueda de cabeza, y a 90 los dientes dan la vuelta a su eje. Lo que encaja: ninguno, o uno menor.</translation>
    </message>
    <message>
        <source>its pitch point makes pitch radii of %1 and %2, but teeth and helix angles make %3 and %4. What fits: no pitch point, or no helix angle.</source>
        <translation>su punto primitivo da radios primitivos de %1 y %2, pero los dientes y los ángulos de hélice dan %3 y %4. Lo que encaja: ningún punto primitivo, o ningún ángulo de hélice.</translation>
    </message>
    <message>
        <source>a worm has 1 to %1 starts, fewer than its wheel has teeth; it has %2, and the wheel %3. What fits: other numbers, or crossed helical.</source>
        <translation>un tornillo sin fin tiene de 1 a %1 entradas, menos que dientes su rueda; tiene %2, y la rueda %3. Lo que encaja: otros números, o helicoidal cruzado.</translation>
    </message>
    <message>
        <source>it says worm, but its axes cross at %1 degrees. What fits: crossed helical, or axes that cross at 90 degrees.</source>
        <translation>dice tornillo sin fin, pero sus ejes se cruzan a %1 grados. Lo que encaja: helicoidal cruzado, o ejes que se cruzan a 90 grados.</translation>
    </message>
    <message>
        <source>its module %1 gives the wheel a pitch radius of %2, and the axes are %3 apart: that leaves no core for the worm. What fits: a module of at most %4.</source>
        <translation>su módulo %1 da a la rueda un radio primitivo de %2, y los ejes distan %3: no queda núcleo para el tornillo. Lo que encaja: un módulo de %4 como máximo.</translation>
    </message>
    <message>
        <source>its pitch point lies %1 off the common perpendicular of the axes, where their pitch cylinders touch. What fits: a point on it, or none (then it follows from the axes).</source>
        <translation>su punto primitivo está a %1 de la perpendicular común de los ejes, donde se tocan sus cilindros primitivos. Lo que encaja: un punto en ella, o ninguno (entonces resulta de los ejes).</translation>
    </message>
    <message>
        <source>its pitch point does not lie between the axes. What fits: a point between them, or none (then it follows from the axes).</source>
        <translation>su punto primitivo no está entre los ejes. Lo que encaja: un punto entre ellos, o ninguno (entonces resulta de los ejes).</translation>
    </message>
    <message>
        <source>its axes are skew, %1 apart: there is no point where the gears could roll. What fits: axes that are parallel or meet, or the kind worm or crossed helical.</source>
        <translation>sus ejes se cruzan sin cortarse, a %1: no hay punto en que las ruedas puedan rodar. Lo que encaja: ejes paralelos o que se corten, o la clase tornillo sin fin o helicoidal cruzado.</translation>
    </message>
    <message>
        <source>External, internal (one wheel is a ring), bevel (the axes meet), belt or pins (the wheels do not touch), crossed helical or worm (the axes cross without meeting). Without it the geometry tells which of the first three it is.</source>
        <translation>Exterior, interior (una rueda es una corona), cónico (los ejes se cortan), correa o pasadores (las ruedas no se tocan), helicoidal cruzado o tornillo sin fin (los ejes se cruzan sin cortarse). Sin ella, la geometría dice cuál de los tres primeros es.</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Ángulo de hélice</translation>
    </message>
    <message>
        <source>Between a tooth and the axis, at the reference cylinder of the first gear. A right-hand helix turns like a common screw. On parallel axes it changes no ratio; on axes that cross, the hands decide which way the gears turn.</source>
        <translation>Entre un diente y el eje, en el cilindro de referencia de la primera rueda. Una hélice a derechas gira como un tornillo común. En ejes paralelos no cambia ninguna relación; en ejes que se cruzan, los sentidos deciden hacia dónde giran las ruedas.</translation>
    </message>
    <message>
        <source>The sign of mesh %1 follows from the hands of its teeth and the way its axes cross.</source>
        <translation>El signo del engrane %1 resulta de los sentidos de sus dientes y de cómo se cruzan sus ejes.</translation>
    </message>
    <message>
        <source>Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, let both turn the same way, so that f is %2.</source>
        <translation>El engrane %1 está entre ejes que se cruzan: los sentidos de sus dientes hacen girar ambas ruedas, vista cada una a lo largo de su eje, en el mismo sentido, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, let them turn against each other, so that f is %2.</source>
        <translation>El engrane %1 está entre ejes que se cruzan: los sentidos de sus dientes hacen girar las ruedas, vista cada una a lo largo de su eje, en sentidos opuestos, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Axes that cross at right angles without meeting. The gear with fewer teeth is the worm: they are its starts.</source>
        <translation>Ejes que se cruzan en ángulo recto sin cortarse. La rueda con menos dientes es el tornillo: son sus entradas.</translation>
    </message>
    <message>
        <source>Axes that cross without meeting.</source>
        <translation>Ejes que se cruzan sin cortarse.</translation>
    </message>
    <message>
        <source>Axes that meet.</source>
        <translation>Ejes que se cortan.</translation>
    </message>
    <message>
        <source>Parallel axes.</source>
        <translation>Ejes paralelos.</translation>
    </message>
    <message>
        <source>herringbone</source>
        <translation>en espiga</translation>
    </message>
    <message>
        <source>The strands cross</source>
        <translation>Los ramales se cruzan</translation>
    </message>
    <message>
        <source>Hand of the helix</source>
        <translation>Sentido de la hélice</translation>
    </message>
    <message>
        <source>usual hand</source>
        <translation>sentido usual</translation>
    </message>
    <message>
        <source>The hand of the first gear&apos;s teeth. Usual: right-hand, or what fits the axes.</source>
        <translation>El sentido de los dientes de la primera rueda. Usual: a derechas, o el que encaja con los ejes.</translation>
    </message>
    <message>
        <source>The helix changes its hand at the middle of the face, so that no axial force is left.</source>
        <translation>La hélice cambia de sentido en el centro del ancho, de modo que no queda fuerza axial.</translation>
    </message>
    <message>
        <source>The strands cross between the pulleys, which then turn against each other.</source>
        <translation>Los ramales se cruzan entre las poleas, que giran entonces en sentidos opuestos.</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>rectos</translation>
    </message>
    <message>
        <source>Change helix angle</source>
        <translation>Cambiar el ángulo de hélice</translation>
    </message>
    <message>
        <source>Change hand</source>
        <translation>Cambiar el sentido</translation>
    </message>
    <message>
        <source>Change herringbone</source>
        <translation>Cambiar los dientes en espiga</translation>
    </message>
    <message>
        <source>Cross strands</source>
        <translation>Cruzar los ramales</translation>
    </message>
    <message>
        <source>equal on both</source>
        <translation>igual en ambas</translation>
    </message>
    <message>
        <source>A cycloidal disc runs on 4 pins or more.</source>
        <translation>Un disco cicloidal rueda sobre 4 pasadores o más.</translation>
    </message>
    <message>
        <source>A worm has 1 to %1 starts, fewer than its wheel has teeth.</source>
        <translation>Un tornillo sin fin tiene de 1 a %1 entradas, menos que dientes su rueda.</translation>
    </message>
    <message>
        <source>Worm stage</source>
        <translation>Etapa de tornillo sin fin</translation>
    </message>
    <message>
        <source>worm wheel</source>
        <translation>rueda del tornillo sin fin</translation>
    </message>
    <message>
        <source>The pitch of a belt is above 0.</source>
        <translation>El paso de una correa es mayor que 0.</translation>
    </message>
    <message>
        <source>Belt drive</source>
        <translation>Transmisión por correa</translation>
    </message>
    <message>
        <source>driving pulley</source>
        <translation>polea motriz</translation>
    </message>
    <message>
        <source>driven pulley</source>
        <translation>polea conducida</translation>
    </message>
    <message>
        <source>The circular spline has more teeth than the flexspline, usually two.</source>
        <translation>La corona circular tiene más dientes que la rueda flexible, normalmente dos.</translation>
    </message>
    <message>
        <source>Strain wave drive</source>
        <translation>Reductor de onda</translation>
    </message>
    <message>
        <source>wave generator</source>
        <translation>generador de onda</translation>
    </message>
    <message>
        <source>flexspline</source>
        <translation>rueda flexible</translation>
    </message>
    <message>
        <source>Cycloidal drive</source>
        <translation>Reductor cicloidal</translation>
    </message>
    <message>
        <source>crank</source>
        <translation>manivela</translation>
    </message>
    <message>
        <source>cycloidal disc</source>
        <translation>disco cicloidal</translation>
    </message>
    <message>
        <source>RV reducer</source>
        <translation>Reductor RV</translation>
    </message>
    <message>
        <source>eccentric</source>
        <translation>excéntrica</translation>
    </message>
    <message>
        <source>Starts of the worm</source>
        <translation>Entradas del tornillo</translation>
    </message>
    <message>
        <source>Teeth of the wheel</source>
        <translation>Dientes de la rueda</translation>
    </message>
    <message>
        <source>Driving pulley</source>
        <translation>Polea motriz</translation>
    </message>
    <message>
        <source>Driven pulley</source>
        <translation>Polea conducida</translation>
    </message>
    <message>
        <source>Flexspline</source>
        <translation>Rueda flexible</translation>
    </message>
    <message>
        <source>Circular spline</source>
        <translation>Corona circular</translation>
    </message>
    <message>
        <source>Pins of the ring</source>
        <translation>Pasadores de la corona</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Planet</source>
        <translation>Satélite</translation>
    </message>
    <message>
        <source>One turn of &quot;%1&quot; turns &quot;%2&quot; by %3.</source>
        <translation>Una vuelta de «%1» gira «%2» %3 vueltas.</translation>
    </message>
    <message>
        <source>Change its kind: %1</source>
        <translation>Cambiar su clase: %1</translation>
    </message>
    <message>
        <source>Freewheel: %1 cannot overtake %2</source>
        <translation>Rueda libre: %1 no puede adelantar a %2</translation>
    </message>
    <message>
        <source>It locks where the first link would turn faster, about the direction of their axis.</source>
        <translation>Bloquea donde el primer eslabón giraría más deprisa, en el sentido de su eje.</translation>
    </message>
    <message>
        <source>Add freewheel</source>
        <translation>Añadir rueda libre</translation>
    </message>
    <message>
        <source>Frequencies, or lost motion</source>
        <translation>Frecuencias, o juego perdido</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>The frequencies could not be worked out: %1</source>
        <translation>No se pudieron calcular las frecuencias: %1</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: what repeats in their motion appears here.</source>
        <translation>Dibuje articulaciones y engranes: lo que se repite en su movimiento aparece aquí.</translation>
    </message>
    <message>
        <source>Frequencies</source>
        <translation>Frecuencias</translation>
    </message>
    <message>
        <source>Shafts, tooth meshes with harmonics and sidebands, passing planets, hunting tooth and assembly phase</source>
        <translation>Ejes, engranes con armónicos y bandas laterales, satélites que pasan, reencuentro de dientes y fase de montaje</translation>
    </message>
    <message>
        <source>The same as lines over a logarithmic axis</source>
        <translation>Lo mismo como líneas sobre un eje logarítmico</translation>
    </message>
    <message>
        <source>Lost motion</source>
        <translation>Juego perdido</translation>
    </message>
    <message>
        <source>How far the outputs turn by the play of the teeth while the inputs are held</source>
        <translation>Cuánto giran las salidas por el juego de los dientes mientras se sujetan las entradas</translation>
    </message>
    <message>
        <source>Export the table to a CSV file</source>
        <translation>Exportar la tabla a un archivo CSV</translation>
    </message>
    <message>
        <source>lost-motion.csv</source>
        <translation>juego-perdido.csv</translation>
    </message>
    <message>
        <source>frequencies.csv</source>
        <translation>frecuencias.csv</translation>
    </message>
    <message>
        <source>The state whose couplings are engaged</source>
        <translation>El estado cuyos acoplamientos están accionados</translation>
    </message>
    <message>
        <source>Speed of the input shaft, rpm</source>
        <translation>Velocidad del eje de entrada, rpm</translation>
    </message>
    <message>
        <source>A speed above 0, in turns a minute.</source>
        <translation>Una velocidad mayor que 0, en vueltas por minuto.</translation>
    </message>
    <message>
        <source>Input shaft, rpm</source>
        <translation>Eje de entrada, rpm</translation>
    </message>
    <message>
        <source>Its speed in turns a minute: frequencies in Hz</source>
        <translation>Su velocidad en vueltas por minuto: frecuencias en Hz</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Armónicos</translation>
    </message>
    <message>
        <source>How many multiples of each tooth mesh are listed</source>
        <translation>Cuántos múltiplos de cada engrane se listan</translation>
    </message>
    <message>
        <source>Sidebands</source>
        <translation>Bandas laterales</translation>
    </message>
    <message>
        <source>How many sidebands each multiple has on either side</source>
        <translation>Cuántas bandas laterales tiene cada múltiplo a cada lado</translation>
    </message>
    <message>
        <source>How many equal planets one stands for that is drawn alone</source>
        <translation>Por cuántos satélites iguales está uno dibujado solo</translation>
    </message>
    <message>
        <source>No output can be told from an input here, so that there is no lost motion: drive a joint.</source>
        <translation>Aquí ninguna salida se distingue de una entrada, así que no hay juego perdido: accione una articulación.</translation>
    </message>
    <message>
        <source>Minutes of arc from stop to stop, inputs held; &quot;worst&quot; adds all plays, the root of squares is what assemblies show.</source>
        <translation>Minutos de arco de tope a tope, entradas sujetas; «peor» suma todos los juegos, la raíz de los cuadrados es lo que muestran los conjuntos.</translation>
    </message>
    <message>
        <source>Cycles for one turn of the %1.</source>
        <translation>Ciclos por vuelta del eje (%1).</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibración</translation>
    </message>
    <message>
        <source>Frequencies of shafts, tooth meshes and planets, and the motion that the play of the teeth loses.</source>
        <translation>Frecuencias de ejes, engranes y satélites, y el movimiento que pierde el juego de los dientes.</translation>
    </message>
    <message>
        <source>A worm has one start or more.</source>
        <translation>Un tornillo sin fin tiene una entrada o más.</translation>
    </message>
    <message>
        <source>%1 starts are too many for a worm; use at most %2, or a pair of helical gears on crossed axes.</source>
        <translation>%1 entradas son demasiadas para un tornillo sin fin; use como máximo %2, o un par de ruedas helicoidales de ejes cruzados.</translation>
    </message>
    <message>
        <source>A worm of %1 starts needs a lead angle between 0.3 and 70 degrees, and no profile shift: its wheel has it.</source>
        <translation>Un tornillo sin fin de %1 entradas necesita un ángulo de avance entre 0,3 y 70 grados y ningún desplazamiento de perfil: lo tiene su rueda.</translation>
    </message>
    <message>
        <source>A worm of %1 starts and a pitch diameter of %2 leaves no body below its threads: make it larger than %3.</source>
        <translation>Un tornillo sin fin de %1 entradas y un diámetro primitivo de %2 no deja cuerpo bajo sus filetes: hágalo mayor que %3.</translation>
    </message>
    <message>
        <source>The threads of a worm of %1 starts would be pointed; use a smaller pressure angle or less height.</source>
        <translation>Los filetes de un tornillo sin fin de %1 entradas serían puntiagudos; use un ángulo de presión menor o menos altura.</translation>
    </message>
    <message>
        <source>The bore of %1 leaves no body below the threads of the worm: make it smaller than %2.</source>
        <translation>El agujero de %1 no deja cuerpo bajo los filetes del tornillo sin fin: hágalo menor que %2.</translation>
    </message>
    <message>
        <source>A worm wheel of %1 teeth needs a worm of fewer starts, at most %2; a pair of helical gears on crossed axes may have any numbers of teeth.</source>
        <translation>Una corona de tornillo sin fin de %1 dientes necesita un tornillo con menos entradas, como máximo %2; un par de ruedas helicoidales de ejes cruzados puede tener cualquier número de dientes.</translation>
    </message>
    <message>
        <source>The worm of a wheel of %1 teeth is too thin for its throat: make its pitch diameter larger than %2.</source>
        <translation>El tornillo de una corona de %1 dientes es demasiado delgado para su garganta: haga su diámetro primitivo mayor que %2.</translation>
    </message>
    <message>
        <source>A worm wheel of %1 teeth is wider than its worm is thick: make its face width at most %2.</source>
        <translation>Una corona de %1 dientes es más ancha que el grosor de su tornillo: haga su ancho de cara como máximo %2.</translation>
    </message>
    <message>
        <source>The joint, the link, the brake or the clutch that a torque acts in or on.</source>
        <translation>El par, el eslabón, el freno o el embrague en el que actúa un par de fuerzas.</translation>
    </message>
    <message>
        <source>The link that the torque acts on, and for a clutch the one that has the reaction.</source>
        <translation>El eslabón sobre el que actúa el par y, en un embrague, el que recibe la reacción.</translation>
    </message>
    <message>
        <source>part in it</source>
        <translation>función</translation>
    </message>
    <message>
        <source>A motor turns a joint at a given speed, or holds it; its torque is given or found. A load is given, a balance is found. A brake holds its link, a clutch joins two.</source>
        <translation>Un motor gira un par a la velocidad dada o lo sujeta; su par de fuerzas se da o se halla. Una carga se da, un equilibrante se halla. Un freno sujeta su eslabón, un embrague une dos.</translation>
    </message>
    <message>
        <source>How fast it turns about its axis.</source>
        <translation>Con qué rapidez gira alrededor de su eje.</translation>
    </message>
    <message>
        <source>Torque times rate: what is fed into the train here; below 0: what is taken. A clutch passes power between its links, a brake passes none.</source>
        <translation>Par por velocidad: lo que se suministra aquí al tren; por debajo de 0: lo que se extrae. Un embrague transmite potencia entre sus eslabones, un freno ninguna.</translation>
    </message>
    <message>
        <source>held, found</source>
        <translation>sujeto, hallado</translation>
    </message>
    <message>
        <source>motor, given</source>
        <translation>motor, dado</translation>
    </message>
    <message>
        <source>motor, found</source>
        <translation>motor, hallado</translation>
    </message>
    <message>
        <source>balance, found</source>
        <translation>equilibrante, hallado</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>une</translation>
    </message>
    <message>
        <source>An efficiency or a coefficient of friction of a mesh is among its properties; friction becomes an efficiency by the teeth that touch.</source>
        <translation>El rendimiento o el coeficiente de rozamiento de un engrane está entre sus propiedades; el rozamiento se convierte en rendimiento por los dientes en contacto.</translation>
    </message>
    <message>
        <source>Coefficient of friction μ = %1 of meshes that state none</source>
        <translation>Coeficiente de rozamiento μ = %1 de los engranes que no indican otro</translation>
    </message>
    <message>
        <source>mesh %1: η = %2</source>
        <translation>engrane %1: η = %2</translation>
    </message>
    <message>
        <source>mesh %1: μ = %2</source>
        <translation>engrane %1: μ = %2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 más</translation>
    </message>
    <message>
        <source>Torque, rate and power where the train is driven, loaded and held</source>
        <translation>Par, velocidad y potencia donde el tren es accionado, cargado y sujetado</translation>
    </message>
    <message>
        <source>What every mesh passes, seen from its carrier, and what it loses of that</source>
        <translation>Lo que transmite cada engrane visto desde su portasatélites y lo que pierde de ello</translation>
    </message>
    <message>
        <source>Efficiency forward and backward, where the train locks itself, and both over the ratio of two speeds or over the efficiency of the meshes</source>
        <translation>Rendimiento hacia delante y hacia atrás, dónde el tren se autobloquea, y ambos según la relación de dos velocidades o el rendimiento de los engranes</translation>
    </message>
    <message>
        <source>Torques on the gears of every mesh, and tooth forces</source>
        <translation>Pares sobre las ruedas de cada engrane y fuerzas en los dientes</translation>
    </message>
    <message>
        <source>Losses</source>
        <translation>Pérdidas</translation>
    </message>
    <message>
        <source>What do I need?</source>
        <translation>¿Qué necesito?</translation>
    </message>
    <message>
        <source>The torques at motors, brakes and clutches, as engaged and in each state</source>
        <translation>Los pares en motores, frenos y embragues, según lo activado y en cada estado</translation>
    </message>
    <message>
        <source>Where does it go?</source>
        <translation>¿Adónde va?</translation>
    </message>
    <message>
        <source>Power, losses, power that circulates, and efficiency forward and backward</source>
        <translation>Potencia, pérdidas, potencia circulante y rendimiento en ambos sentidos</translation>
    </message>
    <message>
        <source>What do parts carry?</source>
        <translation>¿Qué soportan las piezas?</translation>
    </message>
    <message>
        <source>The forces on teeth and bearings</source>
        <translation>Las fuerzas en dientes y cojinetes</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>The cutset whose torques balance, and the row of speeds with its column of torques</source>
        <translation>El conjunto de corte cuyos pares se equilibran y la fila de velocidades con su columna de pares</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>No load acts and nothing is held: add a load.</source>
        <translation>No actúa ninguna carga y nada está sujeto: añada una carga.</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Cargas</translation>
    </message>
    <message>
        <source>Show or hide the loads that act on the train</source>
        <translation>Mostrar u ocultar las cargas que actúan sobre el tren</translation>
    </message>
    <message>
        <source>Unit of the loads</source>
        <translation>Unidad de las cargas</translation>
    </message>
    <message>
        <source>Loads: %1</source>
        <translation>Cargas: %1</translation>
    </message>
    <message>
        <source>Found at %1 ▾</source>
        <translation>Se halla en %1 ▾</translation>
    </message>
    <message>
        <source>Found at %1 places ▾</source>
        <translation>Se halla en %1 lugares ▾</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Pregunta</translation>
    </message>
    <message>
        <source>What is asked about the torques</source>
        <translation>Qué se pregunta sobre los pares</translation>
    </message>
    <message>
        <source>Choose a joint or a mesh in the list above, in a table or in a drawing.</source>
        <translation>Elija un par o un engrane en la lista de arriba, en una tabla o en un dibujo.</translation>
    </message>
    <message>
        <source>Joint or mesh that is explained</source>
        <translation>Par o engrane que se explica</translation>
    </message>
    <message>
        <source>The joint or the mesh whose torque is explained; it is selected in all views</source>
        <translation>El par o el engrane cuyo par de fuerzas se explica; queda seleccionado en todas las vistas</translation>
    </message>
    <message>
        <source>All torques are found twice, by the cutsets of the Matroid method and by those of the T–T graph.</source>
        <translation>Todos los pares se hallan dos veces: por los conjuntos de corte del método Matroid y por los del grafo T–T.</translation>
    </message>
    <message>
        <source>The cutset: which torques balance</source>
        <translation>El conjunto de corte: qué pares se equilibran</translation>
    </message>
    <message>
        <source>A joint cuts off links from the ground: all torques that cross add up to 0. Of a mesh: which gear drives.</source>
        <translation>Un par separa eslabones del bastidor: todos los pares de fuerzas que cruzan suman 0. De un engrane: qué rueda acciona.</translation>
    </message>
    <message>
        <source>The row of speeds and its column of torques</source>
        <translation>La fila de velocidades y su columna de pares</translation>
    </message>
    <message>
        <source>A row of P holds the speeds of a mesh, a column the torque in a joint; one entry is in both.</source>
        <translation>Una fila de P contiene las velocidades de un engrane, una columna el par en una articulación; un elemento está en ambas.</translation>
    </message>
    <message>
        <source>choose a joint or a mesh</source>
        <translation>elegir un par o un engrane</translation>
    </message>
    <message>
        <source>mesh %1: %2, %3</source>
        <translation>engrane %1: %2, %3</translation>
    </message>
    <message>
        <source>The link that drives in the state.</source>
        <translation>El eslabón que acciona en el estado.</translation>
    </message>
    <message>
        <source>The link that is driven in the state.</source>
        <translation>El eslabón que es accionado en el estado.</translation>
    </message>
    <message>
        <source>The brakes and clutches that it engages.</source>
        <translation>Los frenos y embragues que activa.</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving; none while the meshes state no losses</source>
        <translation>Potencia extraída entre potencia suministrada, cuando acciona la entrada; ninguno mientras los engranes no indiquen pérdidas</translation>
    </message>
    <message>
        <source>beside</source>
        <translation>junto a</translation>
    </message>
    <message>
        <source>State that is compared</source>
        <translation>Estado que se compara</translation>
    </message>
    <message>
        <source>A state of the gearbox that is compared with the other one</source>
        <translation>Un estado de la caja de cambios que se compara con el otro</translation>
    </message>
    <message>
        <source>Two states side by side</source>
        <translation>Dos estados uno junto al otro</translation>
    </message>
    <message>
        <source>speed in joint %1, link %2</source>
        <translation>velocidad en el par %1, eslabón %2</translation>
    </message>
    <message>
        <source>How fast the head turns against the tail, for 1 at the drive</source>
        <translation>Con qué rapidez gira la cabeza respecto a la cola, para 1 en la entrada</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>The ratio of the one state over that of the other</source>
        <translation>La relación de un estado entre la del otro</translation>
    </message>
    <message>
        <source>%1, N m</source>
        <translation>%1, N m</translation>
    </message>
    <message>
        <source>The largest ratio over the smallest, of the states that turn forward</source>
        <translation>La mayor relación entre la menor, de los estados que giran hacia delante</translation>
    </message>
    <message>
        <source>spread %1</source>
        <translation>apertura %1</translation>
    </message>
    <message>
        <source>Compare states</source>
        <translation>Comparar estados</translation>
    </message>
    <message>
        <source>Two states side by side: ratios, torques, efficiencies, speeds</source>
        <translation>Dos estados uno junto al otro: relaciones, pares, rendimientos, velocidades</translation>
    </message>
    <message>
        <source>Export the table with drive, driven, what is engaged and steps to a CSV file</source>
        <translation>Exportar la tabla con entrada, salida, elementos activados y saltos a un archivo CSV</translation>
    </message>
    <message>
        <source>A part of the mechanism has no form that prints.</source>
        <translation>Una parte del mecanismo no tiene forma imprimible.</translation>
    </message>
    <message>
        <source>Printed parts would overlap.</source>
        <translation>Las piezas impresas se solaparían.</translation>
    </message>
    <message>
        <source>A part does not fit the plate.</source>
        <translation>Una pieza no cabe en la placa.</translation>
    </message>
    <message>
        <source>--bed is a width and a depth in mm from %1 to %2, like 220x220.</source>
        <translation>--bed es un ancho y un fondo en mm de %1 a %2, como 220x220.</translation>
    </message>
    <message>
        <source>the print kit</source>
        <translation>el kit de impresión</translation>
    </message>
    <message>
        <source>--to kit writes a folder; &quot;-&quot; is none.</source>
        <translation>--to kit escribe una carpeta; &quot;-&quot; no lo es.</translation>
    </message>
    <message>
        <source>%1 parts on %2 plate(s).</source>
        <translation>%1 piezas en %2 placa(s).</translation>
    </message>
    <message>
        <source>Print kit: parts for a 3D printer</source>
        <translation>Kit de impresión: piezas para una impresora 3D</translation>
    </message>
    <message>
        <source>parts for a 3D printer, with their assembly</source>
        <translation>piezas para una impresora 3D, con su montaje</translation>
    </message>
    <message>
        <source>Print kits</source>
        <translation>Kits de impresión</translation>
    </message>
    <message>
        <source>Axes of the ground have several directions; a base holds one.</source>
        <translation>Los ejes del bastidor tienen varias direcciones; una base sostiene una.</translation>
    </message>
    <message>
        <source>The wheel %1 is fixed to the ground, for which the kit has no part.</source>
        <translation>La rueda %1 está fija al bastidor; el kit no tiene pieza para ello.</translation>
    </message>
    <message>
        <source>The ring %1 is too near to the base.</source>
        <translation>La corona %1 está demasiado cerca de la base.</translation>
    </message>
    <message>
        <source>There is no room for posts beside what turns.</source>
        <translation>No hay sitio para columnas junto a lo que gira.</translation>
    </message>
    <message>
        <source>Parts reach below the lowest bearing of the ground, so that no base fits there; move that joint along its axis.</source>
        <translation>Hay piezas por debajo del cojinete más bajo del bastidor y allí no cabe una base; mueva esa articulación a lo largo de su eje.</translation>
    </message>
    <message>
        <source>A bearing of link %1 is too near to its arm for a printed pedestal.</source>
        <translation>Un cojinete del eslabón %1 está demasiado cerca de su brazo para un soporte impreso.</translation>
    </message>
    <message>
        <source>An arm of link %1 is neither parallel nor at right angles to its bearing.</source>
        <translation>Un brazo del eslabón %1 no es paralelo ni perpendicular a su cojinete.</translation>
    </message>
    <message>
        <source>There are no wheels to print.</source>
        <translation>No hay ruedas que imprimir.</translation>
    </message>
    <message>
        <source>Belts are not printed.</source>
        <translation>Las correas no se imprimen.</translation>
    </message>
    <message>
        <source>The train is too large for a kit.</source>
        <translation>El tren es demasiado grande para un kit.</translation>
    </message>
    <message>
        <source>Links overlap in 3D, so their printed parts would too.</source>
        <translation>Los eslabones se solapan en 3D, y también lo harían sus piezas impresas.</translation>
    </message>
    <message>
        <source>Several rings on one axis are joined by drums around each other, which the kit cannot divide.</source>
        <translation>Varias coronas de un eje están unidas por tambores unos dentro de otros, que el kit no puede dividir.</translation>
    </message>
    <message>
        <source>A link turns on a pin across the axis of another, for which the kit has no part.</source>
        <translation>Un eslabón gira sobre un pasador transversal al eje de otro; el kit no tiene pieza para ello.</translation>
    </message>
    <message>
        <source>The wheel %1 has no teeth.</source>
        <translation>La rueda %1 no tiene dientes.</translation>
    </message>
    <message>
        <source>The bevel %1 has so flat or so steep a cone that it does not print on a face.</source>
        <translation>El engranaje cónico %1 tiene un cono tan plano o tan agudo que no se imprime sobre una cara.</translation>
    </message>
    <message>
        <source>Link %1 turns on a pin of link %2, for which the kit has no part.</source>
        <translation>El eslabón %1 gira sobre un pasador del eslabón %2; el kit no tiene pieza para ello.</translation>
    </message>
    <message>
        <source>The face of wheel %1 is %2 mm instead of %3 mm, so that it clears %4.</source>
        <translation>La anchura de cara de la rueda %1 es %2 mm en vez de %3 mm, para que no toque %4.</translation>
    </message>
    <message>
        <source>The ring %1 is joined to its link by more than a disc.</source>
        <translation>La corona %1 está unida a su eslabón por más que un disco.</translation>
    </message>
    <message>
        <source>The wheel %1 is on no shaft of its link.</source>
        <translation>La rueda %1 no está en ningún eje de su eslabón.</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rueda</translation>
    </message>
    <message>
        <source>ring gear</source>
        <translation>corona</translation>
    </message>
    <message>
        <source>arm or carrier plate</source>
        <translation>brazo o placa del portador</translation>
    </message>
    <message>
        <source>pedestal with a tenon</source>
        <translation>soporte con espiga</translation>
    </message>
    <message>
        <source>base plate</source>
        <translation>placa base</translation>
    </message>
    <message>
        <source>bridge</source>
        <translation>puente</translation>
    </message>
    <message>
        <source>post</source>
        <translation>columna</translation>
    </message>
    <message>
        <source>spacer</source>
        <translation>separador</translation>
    </message>
    <message>
        <source>clip, pressed on</source>
        <translation>anillo de retención, a presión</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Tamaño, mm</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Grabado</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Placa</translation>
    </message>
    <message>
        <source>All parts lie on a flat face and need no supports: nothing hangs over by more than %1 degrees from the upright.</source>
        <translation>Todas las piezas se apoyan en una cara plana y no necesitan soportes: nada sobresale más de %1 grados respecto a la vertical.</translation>
    </message>
    <message>
        <source>Supports are needed below the teeth of: %1.</source>
        <translation>Hacen falta soportes bajo los dientes de: %1.</translation>
    </message>
    <message>
        <source>Shafts and screws</source>
        <translation>Ejes y tornillos</translation>
    </message>
    <message>
        <source>Shafts are printed lying on their flat, which keys what is pressed on them. Round rods of the same diameter do as well, with a flat filed to the same depth.</source>
        <translation>Los ejes se imprimen tumbados sobre su plano, que enclava lo que va a presión. También sirven varillas redondas del mismo diámetro con un plano limado a igual profundidad.</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Diámetro, mm</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Longitud, mm</translation>
    </message>
    <message>
        <source>No screws are needed.</source>
        <translation>No hacen falta tornillos.</translation>
    </message>
    <message>
        <source>%1 countersunk screws M%2 × %3, which cut their thread in the part</source>
        <translation>%1 tornillos avellanados M%2 × %3, que tallan su rosca en la pieza</translation>
    </message>
    <message>
        <source>the space with %1 square(s) on %2</source>
        <translation>el hueco con %1 cuadrado(s) en %2</translation>
    </message>
    <message>
        <source>the tooth with %1 dot(s) on %2</source>
        <translation>el diente con %1 punto(s) en %2</translation>
    </message>
    <message>
        <source>the space after tooth %1 of %2 (no room for a mark)</source>
        <translation>el hueco tras el diente %1 de %2 (sin sitio para una marca)</translation>
    </message>
    <message>
        <source>tooth %1 of %2 (no room for a mark)</source>
        <translation>el diente %1 de %2 (sin sitio para una marca)</translation>
    </message>
    <message>
        <source>Teeth that meet</source>
        <translation>Dientes que se encuentran</translation>
    </message>
    <message>
        <source>Put the wheels together with each marked tooth in the marked space. All marks meet at once in the pose of assembly.3mf.</source>
        <translation>Junte las ruedas con cada diente marcado en el hueco marcado. Todas las marcas coinciden a la vez en la posición de assembly.3mf.</translation>
    </message>
    <message>
        <source>Mesh %1: %2 goes into %3.</source>
        <translation>Engrane %1: %2 entra en %3.</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>desde arriba</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>desde abajo</translation>
    </message>
    <message>
        <source>along (%1, %2, %3)</source>
        <translation>a lo largo de (%1, %2, %3)</translation>
    </message>
    <message>
        <source>Order of assembly</source>
        <translation>Orden de montaje</translation>
    </message>
    <message>
        <source>Each part comes to its place past all those before it, as assembly.3mf shows it. Turn wheels a little where teeth meet.</source>
        <translation>Cada pieza llega a su sitio sin tocar las anteriores, como muestra assembly.3mf. Gire un poco las ruedas donde se encuentran dientes.</translation>
    </message>
    <message>
        <source>no straight way was found free; bend or turn it in</source>
        <translation>no se halló un camino recto libre; dóblela o gírela al entrar</translation>
    </message>
    <message>
        <source>Plate %1</source>
        <translation>Placa %1</translation>
    </message>
    <message>
        <source>Print kit</source>
        <translation>Kit de impresión</translation>
    </message>
    <message>
        <source>Print kit: %1</source>
        <translation>Kit de impresión: %1</translation>
    </message>
    <message>
        <source>Play %1 mm on each flank, bores %2 mm wider than their shafts, first layers narrower by %3 mm, scale %4. Lengths are in mm.</source>
        <translation>Juego de %1 mm en cada flanco, agujeros %2 mm más anchos que sus ejes, primeras capas %3 mm más estrechas, escala %4. Longitudes en mm.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; measures %2 mm by %3 mm and does not fit the plate; scale the kit down.</source>
        <translation>&quot;%1&quot; mide %2 mm por %3 mm y no cabe en la placa; reduzca el kit.</translation>
    </message>
    <message>
        <source>Printed, &quot;%1&quot; and &quot;%2&quot; would overlap.</source>
        <translation>Impresos, &quot;%1&quot; y &quot;%2&quot; se solaparían.</translation>
    </message>
    <message>
        <source>The ground has no bearing that a base could hold.</source>
        <translation>El bastidor no tiene ningún cojinete que una base pueda sostener.</translation>
    </message>
    <message>
        <source>Edges of &quot;%1&quot; cross each other at this size; try another scale.</source>
        <translation>Los bordes de &quot;%1&quot; se cruzan a este tamaño; pruebe otra escala.</translation>
    </message>
    <message>
        <source>the plate of the printer, mm (220x220)</source>
        <translation>la placa de la impresora, mm (220x220)</translation>
    </message>
    <message>
        <source>Plate of the printer</source>
        <translation>Placa de la impresora</translation>
    </message>
    <message>
        <source>play on either flank of a tooth, mm (0.15)</source>
        <translation>juego en cada flanco de un diente, mm (0.15)</translation>
    </message>
    <message>
        <source>Play of the teeth</source>
        <translation>Juego de los dientes</translation>
    </message>
    <message>
        <source>by which bores are wider than their shafts, mm (0.2)</source>
        <translation>lo que los agujeros son más anchos que sus ejes, mm (0.2)</translation>
    </message>
    <message>
        <source>Clearance of bores</source>
        <translation>Holgura de los agujeros</translation>
    </message>
    <message>
        <source>by which the lowest layers are narrower, against their spread, mm (0.4)</source>
        <translation>lo que las capas más bajas son más estrechas, contra su ensanchamiento, mm (0.4)</translation>
    </message>
    <message>
        <source>Chamfer of first layers</source>
        <translation>Chaflán de las primeras capas</translation>
    </message>
    <message>
        <source>by which all lengths are multiplied (1)</source>
        <translation>por lo que se multiplican todas las longitudes (1)</translation>
    </message>
    <message>
        <source>sign of a belt</source>
        <translation>signo de una correa</translation>
    </message>
    <message>
        <source>sign of pins in holes</source>
        <translation>signo de pasadores en agujeros</translation>
    </message>
    <message>
        <source>sign of gears on axes that cross</source>
        <translation>signo de ruedas en ejes que se cruzan</translation>
    </message>
    <message>
        <source>stated: which teeth were meant?</source>
        <translation>indicadas: ¿qué dientes se querían decir?</translation>
    </message>
    <message>
        <source>The ratios are those that somebody states, and the drawn teeth are in doubt: looks for teeth near them with all of these ratios, by the fewest wheels</source>
        <translation>Las relaciones son las que alguien indica y los dientes dibujados están en duda: busca cerca de ellos dientes con todas estas relaciones, cambiando las menos ruedas</translation>
    </message>
    <message>
        <source>Wheels that may differ from the drawn ones</source>
        <translation>Ruedas que pueden diferir de las dibujadas</translation>
    </message>
    <message>
        <source>Teeth by which each of them may differ</source>
        <translation>Dientes en que cada una de ellas puede diferir</translation>
    </message>
    <message>
        <source>Wheels that differ</source>
        <translation>Ruedas que difieren</translation>
    </message>
    <message>
        <source>Teeth apart</source>
        <translation>Dientes de diferencia</translation>
    </message>
    <message>
        <source>All %1 choices near the drawn teeth tried: complete</source>
        <translation>Probadas las %1 opciones cercanas a los dientes dibujados: completo</translation>
    </message>
    <message>
        <source>Ratio %1 of the drawn teeth: %2, as stated</source>
        <translation>Relación %1 de los dientes dibujados: %2, como se indica</translation>
    </message>
    <message>
        <source>Ratio %1 of the drawn teeth: %2, not the stated one</source>
        <translation>Relación %1 de los dientes dibujados: %2, no la indicada</translation>
    </message>
    <message>
        <source>Wheels that differ: %1, choices: %2</source>
        <translation>Ruedas que difieren: %1, opciones: %2</translation>
    </message>
    <message>
        <source>No teeth near the drawn ones have all stated ratios. More wheels that may differ, or by more teeth, give more.</source>
        <translation>Ningunos dientes cercanos a los dibujados tienen todas las relaciones indicadas. Más ruedas que puedan diferir, o más dientes de diferencia, dan más.</translation>
    </message>
    <message>
        <source>The likeliest first: the fewest teeth more or less, then the smallest error</source>
        <translation>Lo más probable primero: los menos dientes de más o de menos, luego el menor error</translation>
    </message>
    <message>
        <source>%1 of %2 chains; equations: %3</source>
        <translation>%1 de %2 cadenas; ecuaciones: %3</translation>
    </message>
    <message>
        <source>links: %1, axes: %2, gear pairs: %3</source>
        <translation>eslabones: %1, ejes: %2, pares de ruedas: %3</translation>
    </message>
    <message>
        <source>links: %1, axes: %2, gear pairs: %3; freedom %4 with one link held</source>
        <translation>eslabones: %1, ejes: %2, pares de ruedas: %3; libertad %4 con un eslabón fijo</translation>
    </message>
    <message>
        <source>Trees, inputs and frames</source>
        <translation>Árboles, entradas y bastidores</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>Comparar con…</translation>
    </message>
    <message>
        <source>Which link is which</source>
        <translation>Qué eslabón es cuál</translation>
    </message>
    <message>
        <source>Lists all trees of turning joints, valid sets of inputs and frames with which your train can be drawn</source>
        <translation>Enumera todos los árboles de pares de revolución, los conjuntos válidos de entradas y los bastidores con que se puede dibujar su tren</translation>
    </message>
    <message>
        <source>Is the train of another document the same chain, and which link is which?</source>
        <translation>¿Es el tren de otro documento la misma cadena, y qué eslabón es cuál?</translation>
    </message>
    <message>
        <source>your train</source>
        <translation>su tren</translation>
    </message>
    <message>
        <source>the other one</source>
        <translation>el otro</translation>
    </message>
    <message>
        <source>Valid sets of inputs: %1</source>
        <translation>Conjuntos válidos de entradas: %1</translation>
    </message>
    <message>
        <source>GearGraph documents (*.geargraph)</source>
        <translation>Documentos de GearGraph (*.geargraph)</translation>
    </message>
    <message>
        <source>%1 is a different chain.</source>
        <translation>%1 es otra cadena.</translation>
    </message>
    <message>
        <source>%1 is the same chain.</source>
        <translation>%1 es la misma cadena.</translation>
    </message>
    <message>
        <source>%1 has the same equations, on other shafts.</source>
        <translation>%1 tiene las mismas ecuaciones, en otros ejes.</translation>
    </message>
    <message>
        <source>Digraph of your train</source>
        <translation>Dígrafo de su tren</translation>
    </message>
    <message>
        <source>Digraph of the other train, with the colours of your links</source>
        <translation>Dígrafo del otro tren, con los colores de sus eslabones</translation>
    </message>
    <message>
        <source>Schematic of chain %1</source>
        <translation>Esquema de la cadena %1</translation>
    </message>
    <message>
        <source>Chain %1 in three dimensions</source>
        <translation>Cadena %1 en tres dimensiones</translation>
    </message>
    <message>
        <source>Laid out by rule, with teeth that are no special ones</source>
        <translation>Dispuesta según reglas, con dientes sin relación especial</translation>
    </message>
    <message>
        <source>The trains are too large to be compared.</source>
        <translation>Los trenes son demasiado grandes para compararlos.</translation>
    </message>
    <message>
        <source>A face gear has more teeth than its pinion.</source>
        <translation>Una corona frontal tiene más dientes que su piñón.</translation>
    </message>
    <message>
        <source>Face gear drive</source>
        <translation>Engranaje de corona frontal</translation>
    </message>
    <message>
        <source>face gear</source>
        <translation>corona frontal</translation>
    </message>
    <message>
        <source>The gear of an axle has more teeth than its pinion.</source>
        <translation>La corona de un eje tiene más dientes que su piñón.</translation>
    </message>
    <message>
        <source>Hypoid axle</source>
        <translation>Eje hipoide</translation>
    </message>
    <message>
        <source>axle gear</source>
        <translation>corona del eje</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) is drawn as its pitch cone: the teeth of hypoid gears are not made here. Motion, torques and forces are those of the teeth.</source>
        <translation>La rueda %1 (%2 dientes) se dibuja como su cono primitivo: los dientes de las ruedas hipoides no se generan aquí. El movimiento, los pares y las fuerzas son los de los dientes.</translation>
    </message>
    <message>
        <source>Make %1 a face gear</source>
        <translation>Hacer %1 una corona frontal</translation>
    </message>
    <message>
        <source>hypoid</source>
        <translation>hipoide</translation>
    </message>
    <message>
        <source>Make %1 hypoid</source>
        <translation>Hacer %1 hipoide</translation>
    </message>
    <message>
        <source>The teeth of a face gear are straight, and those of a hypoid pair follow from its pitch point; mesh &quot;%1&quot; says otherwise: leave it out.</source>
        <translation>Los dientes de una corona frontal son rectos, y los de un par hipoide se deducen de su punto primitivo; el engrane «%1» dice otra cosa: omítalo.</translation>
    </message>
    <message>
        <source>it has herringbone teeth, but its axes meet. What fits: a helix angle alone, or none.</source>
        <translation>tiene dientes de espina de pescado, pero sus ejes se cortan. Lo que encaja: solo un ángulo de hélice, o ninguno.</translation>
    </message>
    <message>
        <source>it has a helix angle, but the pinion of a face gear has straight teeth here. What fits: none.</source>
        <translation>tiene un ángulo de hélice, pero el piñón de una corona frontal tiene aquí dientes rectos. Lo que encaja: ninguno.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet at %2 degrees. What fits: bevel, or axes that meet at 90 degrees.</source>
        <translation>dice %1, pero sus ejes se cortan a %2 grados. Lo que encaja: cónico, o ejes que se cortan a 90 grados.</translation>
    </message>
    <message>
        <source>a face gear has more teeth than its pinion; both have %1. What fits: other numbers, or bevel.</source>
        <translation>una corona frontal tiene más dientes que su piñón; ambos tienen %1. Lo que encaja: otros números, o cónico.</translation>
    </message>
    <message>
        <source>The spiral teeth of gear %1 have no exact faces here; STL and GLB have them.</source>
        <translation>Los dientes en espiral de la rueda %1 no tienen aquí caras exactas; STL y GLB las tienen.</translation>
    </message>
    <message>
        <source>The teeth of face gear %1 have no exact faces here; STL and GLB have them.</source>
        <translation>Los dientes de la corona frontal %1 no tienen aquí caras exactas; STL y GLB las tienen.</translation>
    </message>
    <message>
        <source>Spiral teeth and face gears are not printed: gear %1.</source>
        <translation>Los dientes en espiral y las coronas frontales no se imprimen: rueda %1.</translation>
    </message>
    <message>
        <source>The sign of face gear mesh %1 follows from where its pitch point is, seen from both axes.</source>
        <translation>El signo del engrane de corona frontal %1 se deduce de dónde está su punto primitivo, visto desde ambos ejes.</translation>
    </message>
    <message>
        <source>The sign of face gear mesh %1 follows from its pitch point, seen from both axes.</source>
        <translation>El signo del engrane de corona frontal %1 se deduce de su punto primitivo, visto desde ambos ejes.</translation>
    </message>
    <message>
        <source>Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, they turn the same way, so that f is %2.</source>
        <translation>El engrane %1 es una corona frontal con su piñón: vistos desde el portasatélites, cada uno a lo largo de su eje, giran en el mismo sentido, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, they turn against each other, so that f is %2.</source>
        <translation>El engrane %1 es una corona frontal con su piñón: vistos desde el portasatélites, cada uno a lo largo de su eje, giran en sentidos opuestos, de modo que f es %2.</translation>
    </message>
    <message>
        <source>The sign of hypoid mesh %1 follows from the half axes beside which its pitch point is, as if the axes met.</source>
        <translation>El signo del engrane hipoide %1 se deduce de los semiejes junto a los que está su punto primitivo, como si los ejes se cortaran.</translation>
    </message>
    <message>
        <source>The sign of hypoid mesh %1 follows from the half axes beside its pitch point.</source>
        <translation>El signo del engrane hipoide %1 se deduce de los semiejes junto a su punto primitivo.</translation>
    </message>
    <message>
        <source>Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn the same way, so that f is %2.</source>
        <translation>El engrane %1 es hipoide: vistas desde el portasatélites, cada una a lo largo de su eje, sus ruedas giran en el mismo sentido, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn against each other, so that f is %2.</source>
        <translation>El engrane %1 es hipoide: vistas desde el portasatélites, cada una a lo largo de su eje, sus ruedas giran en sentidos opuestos, de modo que f es %2.</translation>
    </message>
    <message>
        <source>Axes that meet at right angles. The gear with fewer teeth is the pinion.</source>
        <translation>Ejes que se cortan en ángulo recto. La rueda con menos dientes es el piñón.</translation>
    </message>
    <message>
        <source>Axes that cross at right angles without meeting, or at any angle with a pitch point.</source>
        <translation>Ejes que se cruzan en ángulo recto sin cortarse, o con cualquier ángulo si hay punto primitivo.</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Piñón</translation>
    </message>
    <message>
        <source>Face gear</source>
        <translation>Corona frontal</translation>
    </message>
    <message>
        <source>Axle gear</source>
        <translation>Corona del eje</translation>
    </message>
    <message>
        <source>Spiral angle</source>
        <translation>Ángulo de espiral</translation>
    </message>
    <message>
        <source>The face of %1 is wider than the teeth of a face gear are, or leaves none: make it at most %2.</source>
        <translation>El ancho de %1 es mayor que el de los dientes de una corona frontal, o no deja ninguno: como máximo %2.</translation>
    </message>
    <message>
        <source>it says hypoid, but its axes cross at %1 degrees. What fits: axes that cross at 90 degrees, or a pitch point of its own.</source>
        <translation>dice hipoide, pero sus ejes se cruzan a %1 grados. Lo que encaja: ejes que se cruzan a 90 grados, o un punto primitivo propio.</translation>
    </message>
    <message>
        <source>its axes are %1 apart, too far for a gear of %2 teeth and module %3. What fits: a module of at least %4, or axes nearer to each other.</source>
        <translation>sus ejes distan %1, demasiado para una rueda de %2 dientes y módulo %3. Lo que encaja: un módulo de al menos %4, o ejes más próximos.</translation>
    </message>
    <message>
        <source>its pitch point leaves one gear no cone: it lies on an axis, or beside the common perpendicular of both. What fits: a point farther out along both axes, or none (then it follows from the axes).</source>
        <translation>su punto primitivo no deja cono a una rueda: está en un eje, o junto a la perpendicular común de ambos. Lo que encaja: un punto más alejado a lo largo de ambos ejes, o ninguno (entonces se deduce de los ejes).</translation>
    </message>
    <message>
        <source>its pitch point asks for a spiral angle of %1 degrees, and at 90 teeth run round their axis. What fits: a point whose distances from the axes are nearer to the ratio of the teeth, or none.</source>
        <translation>su punto primitivo pide un ángulo de espiral de %1 grados, y a 90 los dientes rodean su eje. Lo que encaja: un punto cuyas distancias a los ejes se acerquen más a la relación de dientes, o ninguno.</translation>
    </message>
    <message>
        <source>%1 joints, of which %2 slide</source>
        <translation>%1 pares, de los que %2 se deslizan</translation>
    </message>
    <message>
        <source>travel of link %1 per radian of link %2: %3 %4</source>
        <translation>recorrido del eslabón %1 por radián del eslabón %2: %3 %4</translation>
    </message>
    <message>
        <source>slides along axis %1</source>
        <translation>se desliza a lo largo del eje %1</translation>
    </message>
    <message>
        <source>The command %1 does not cover sliding joints, and &quot;%2&quot; has some.</source>
        <translation>La orden %1 no trata pares deslizantes, y «%2» tiene alguno.</translation>
    </message>
    <message>
        <source>%1 is like 9=20%2: an input&apos;s label and its travel in the document&apos;s unit.</source>
        <translation>%1 es como 9=20%2: el número de una entrada y su recorrido en la unidad del documento.</translation>
    </message>
    <message>
        <source>Joint %1 turns: its angle is given by --angle.</source>
        <translation>El par %1 gira: su ángulo se da con --angle.</translation>
    </message>
    <message>
        <source>Joint %1 slides: its travel is given by --travel.</source>
        <translation>El par %1 se desliza: su recorrido se da con --travel.</translation>
    </message>
    <message>
        <source>%1 moved by %2 %3</source>
        <translation>%1 desplazado %2 %3</translation>
    </message>
    <message>
        <source>the travel of an input that slides, in the document&apos;s unit; may be repeated</source>
        <translation>el recorrido de una entrada que se desliza, en la unidad del documento; puede repetirse</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1 at %2 %3</source>
        <translation>%1 a %2 %3</translation>
    </message>
    <message>
        <source>&quot;turning&quot; or &quot;sliding&quot;</source>
        <translation>&quot;turning&quot; o &quot;sliding&quot;</translation>
    </message>
    <message>
        <source>turning, sliding or nothing</source>
        <translation>turning, sliding o nada</translation>
    </message>
    <message>
        <source>rack</source>
        <translation>cremallera</translation>
    </message>
    <message>
        <source>Make %1 a rack and pinion</source>
        <translation>Hacer de %1 una cremallera con piñón</translation>
    </message>
    <message>
        <source>screw</source>
        <translation>husillo</translation>
    </message>
    <message>
        <source>Make %1 a screw and nut</source>
        <translation>Hacer de %1 un husillo con tuerca</translation>
    </message>
    <message>
        <source>Screw &quot;%1&quot; needs a lead: its advance in one turn.</source>
        <translation>El husillo «%1» necesita un avance: lo que avanza en una vuelta.</translation>
    </message>
    <message>
        <source>The lead of screw &quot;%1&quot; is above 0.</source>
        <translation>El avance del husillo «%1» es mayor que 0.</translation>
    </message>
    <message>
        <source>Screw &quot;%1&quot; has a lead and a hand, no module and no helix angle: leave them out.</source>
        <translation>El husillo «%1» tiene avance y sentido, pero ni módulo ni ángulo de hélice: quítelos.</translation>
    </message>
    <message>
        <source>Rack &quot;%1&quot; has a module or a pitch along its motion, one of them.</source>
        <translation>La cremallera «%1» tiene un módulo o un paso a lo largo de su movimiento, uno de los dos.</translation>
    </message>
    <message>
        <source>The travel of a radian of &quot;%1&quot; is a ratio of two whole numbers up to 100,000: give it with fewer digits.</source>
        <translation>El recorrido por radián de «%1» es una razón de dos enteros hasta 100.000: escríbalo con menos cifras.</translation>
    </message>
    <message>
        <source>Only a screw has a lead; mesh &quot;%1&quot; is none.</source>
        <translation>Solo un husillo tiene avance; el engrane «%1» no lo es.</translation>
    </message>
    <message>
        <source>This format does not cover sliding joints, racks and screws.</source>
        <translation>Este formato no trata pares deslizantes, cremalleras ni husillos.</translation>
    </message>
    <message>
        <source>%1 slides: its screw has no angular part.</source>
        <translation>%1 se desliza: su torsor no tiene parte angular.</translation>
    </message>
    <message>
        <source>The %1 component of the direction in which %2 slides: how fast the pitch point of %3 moves for one unit of speed.</source>
        <translation>La componente %1 de la dirección en que se desliza %2: con qué rapidez se mueve el punto primitivo de %3 por unidad de velocidad.</translation>
    </message>
    <message>
        <source>a joint slides</source>
        <translation>un par se desliza</translation>
    </message>
    <message>
        <source>Mesh %1 is a rack: its sign follows from the side of the pinion on which it is, and f is %2.</source>
        <translation>El engrane %1 es una cremallera: su signo se sigue del lado del piñón en que está, y f es %2.</translation>
    </message>
    <message>
        <source>The sign of rack %1 follows from the side of the pinion&apos;s axis on which its teeth are.</source>
        <translation>El signo de la cremallera %1 se sigue del lado del eje del piñón en que están sus dientes.</translation>
    </message>
    <message>
        <source>Mesh %1 is a screw: its sign follows from the hand of the thread, and f is %2.</source>
        <translation>El engrane %1 es un husillo: su signo se sigue del sentido de la rosca, y f es %2.</translation>
    </message>
    <message>
        <source>The sign of screw %1 follows from the hand of its thread.</source>
        <translation>El signo del husillo %1 se sigue del sentido de su rosca.</translation>
    </message>
    <message>
        <source>A length is tied to an angle by pi (meshes %1) and, round a loop, by a whole number of modules too: their rates would be sums of different powers of pi, for which there are no exact numbers here. State the racks of the loop all by their module or all by their pitch.</source>
        <translation>Una longitud está ligada a un ángulo por pi (engranes %1) y, alrededor de un lazo, también sin pi: las velocidades serían sumas de potencias distintas de pi, para las que aquí no hay números exactos. Dé todas las cremalleras del lazo por su módulo o todas por su paso.</translation>
    </message>
    <message>
        <source>The equation of motion</source>
        <translation>La ecuación de movimiento</translation>
    </message>
    <message>
        <source>Ratios of states with pi</source>
        <translation>Relaciones de estados con pi</translation>
    </message>
    <message>
        <source>Torques and forces</source>
        <translation>Pares y fuerzas</translation>
    </message>
    <message>
        <source>%1: sliding joints are not covered, and joints %2 slide.</source>
        <translation>%1: no se tratan pares deslizantes, y los pares %2 se deslizan.</translation>
    </message>
    <message>
        <source>one of its gears slides in their carrier, and gears of the kind %1 turn. What fits: a rack or a screw, or turning joints.</source>
        <translation>una de sus ruedas se desliza en su portador, y las ruedas de la clase %1 giran. Sirve: una cremallera o un husillo, o pares giratorios.</translation>
    </message>
    <message>
        <source>it says %1, but both of its sides slide. What fits: one side that turns.</source>
        <translation>dice %1, pero sus dos lados se deslizan. Sirve: un lado que gire.</translation>
    </message>
    <message>
        <source>it says %1, but both of its sides turn. What fits: one side that slides.</source>
        <translation>dice %1, pero sus dos lados giran. Sirve: un lado que se deslice.</translation>
    </message>
    <message>
        <source>the travel of a turn is not stated. What fits: a module or a pitch of the rack, the lead of the screw.</source>
        <translation>no se indica el recorrido de una vuelta. Sirve: un módulo o un paso de la cremallera, el avance del husillo.</translation>
    </message>
    <message>
        <source>it says %1, but its side that slides does not slide along the axis of the other one. What fits: parallel directions, or a rack.</source>
        <translation>dice %1, pero el lado que se desliza no lo hace a lo largo del eje del otro. Sirve: direcciones paralelas, o una cremallera.</translation>
    </message>
    <message>
        <source>it says %1, but it slides along the axis of its pinion. What fits: a direction across it, or a screw.</source>
        <translation>dice %1, pero se desliza a lo largo del eje de su piñón. Sirve: una dirección transversal, o un husillo.</translation>
    </message>
    <message>
        <source>its teeth run along the slide and cannot push it. What fits: another helix angle or hand.</source>
        <translation>sus dientes corren a lo largo de la guía y no pueden empujarla. Sirve: otro ángulo de hélice u otro sentido.</translation>
    </message>
    <message>
        <source>its pitch point lies %1 off the place where a pinion of the pitch radius %2 touches the rack. What fits: no pitch point.</source>
        <translation>su punto primitivo está a %1 del lugar en que un piñón de radio primitivo %2 toca la cremallera. Sirve: ningún punto primitivo.</translation>
    </message>
    <message>
        <source>sign of a rack</source>
        <translation>signo de una cremallera</translation>
    </message>
    <message>
        <source>sign of a screw</source>
        <translation>signo de un husillo</translation>
    </message>
    <message>
        <source>Sliding joints, racks and screws have no symbols here.</source>
        <translation>Los pares deslizantes, las cremalleras y los husillos no tienen símbolos aquí.</translation>
    </message>
    <message>
        <source>One of its links turns, the other one slides across that axis.</source>
        <translation>Uno de sus eslabones gira, el otro se desliza a través de ese eje.</translation>
    </message>
    <message>
        <source>One of its links turns, the other one slides along that axis.</source>
        <translation>Uno de sus eslabones gira, el otro se desliza a lo largo de ese eje.</translation>
    </message>
    <message>
        <source>Travel and module of a rack are above 0.</source>
        <translation>La carrera y el módulo de una cremallera son mayores que 0.</translation>
    </message>
    <message>
        <source>A pinion of this module has %1 teeth for this travel a turn, and %2 to %3 fit.</source>
        <translation>Un piñón de este módulo tiene %1 dientes para esta carrera por vuelta, y sirven de %2 a %3.</translation>
    </message>
    <message>
        <source>Rack drive</source>
        <translation>Transmisión por cremallera</translation>
    </message>
    <message>
        <source>The lead of a screw is above 0.</source>
        <translation>El paso de un husillo es mayor que 0.</translation>
    </message>
    <message>
        <source>Screw drive</source>
        <translation>Transmisión por husillo</translation>
    </message>
    <message>
        <source>nut</source>
        <translation>tuerca</translation>
    </message>
    <message>
        <source>joint %1 at %2 %3</source>
        <translation>par %1 a %2 %3</translation>
    </message>
    <message>
        <source>Speed of what slides</source>
        <translation>Velocidad de lo que desliza</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 a lo largo de %2</translation>
    </message>
    <message>
        <source>Speed of joint %1: link %2 slides along link %3</source>
        <translation>Velocidad del par %1: el eslabón %2 desliza sobre el eslabón %3</translation>
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
        <translation>El par no desliza hacia atrás más allá de esto desde la posición de referencia: 0 o menos. Vacío: sin límite.</translation>
    </message>
    <message>
        <source>The joint slides on no farther than this from the reference pose: 0 or more. Empty: no limit.</source>
        <translation>El par no desliza hacia delante más allá de esto desde la posición de referencia: 0 o más. Vacío: sin límite.</translation>
    </message>
    <message>
        <source>One of its links slides: a rack or a screw fits, or turning joints.</source>
        <translation>Uno de sus eslabones desliza: sirve una cremallera o un husillo, o pares de revolución.</translation>
    </message>
    <message>
        <source>Both of its links slide, and one of them has to turn.</source>
        <translation>Sus dos eslabones deslizan, y uno de ellos tiene que girar.</translation>
    </message>
    <message>
        <source>Both of its links turn, and one of them has to slide. The form of a joint makes it a sliding one.</source>
        <translation>Sus dos eslabones giran, y uno de ellos tiene que deslizar. El formulario de un par lo convierte en deslizante.</translation>
    </message>
    <message>
        <source>It does not slide along the axis of the link that turns: a rack fits.</source>
        <translation>No desliza a lo largo del eje del eslabón que gira: sirve una cremallera.</translation>
    </message>
    <message>
        <source>It slides along the axis of the link that turns: a screw fits.</source>
        <translation>Desliza a lo largo del eje del eslabón que gira: sirve un husillo.</translation>
    </message>
    <message>
        <source>Sliding joint %1: %2 → %3</source>
        <translation>Par deslizante %1: %2 → %3</translation>
    </message>
    <message>
        <source>%1 sliding joints</source>
        <translation>%1 pares deslizantes</translation>
    </message>
    <message>
        <source>Limits, %1</source>
        <translation>Límites, %1</translation>
    </message>
    <message>
        <source>Speed of joint %1: how fast %2 slides along %3. Positive: in the direction of the axis.</source>
        <translation>Velocidad del par %1: con qué rapidez %2 desliza sobre %3. Positiva: en la dirección del eje.</translation>
    </message>
    <message>
        <source>Travel a turn, about</source>
        <translation>Carrera por vuelta, aproximada</translation>
    </message>
    <message>
        <source>Lead, advance of a turn</source>
        <translation>Paso, avance por vuelta</translation>
    </message>
    <message>
        <source>One turn of &quot;%1&quot; moves &quot;%2&quot; by %3.</source>
        <translation>Una vuelta de «%1» desplaza «%2» %3.</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>de revolución</translation>
    </message>
    <message>
        <source>The head turns about the axis, against the tail.</source>
        <translation>La cabeza gira alrededor del eje, respecto a la cola.</translation>
    </message>
    <message>
        <source>sliding</source>
        <translation>deslizante</translation>
    </message>
    <message>
        <source>The head slides along the axis, against the tail.</source>
        <translation>La cabeza desliza a lo largo del eje, respecto a la cola.</translation>
    </message>
    <message>
        <source>Change kind of joint</source>
        <translation>Cambiar el tipo de par</translation>
    </message>
    <message>
        <source>In %1/s; a speed with another unit, such as 2 m/s or 30 in/min, is converted.</source>
        <translation>En %1/s; una velocidad en otra unidad, como 2 m/s o 30 in/min, se convierte.</translation>
    </message>
    <message>
        <source>Type a speed such as 12, 2*3, 2 m/s or 30 in/min.</source>
        <translation>Escriba una velocidad como 12, 2*3, 2 m/s o 30 in/min.</translation>
    </message>
    <message>
        <source>No joint is driven: %1 as input, at 1 rad/s or %2 each.</source>
        <translation>Ningún par está accionado: %1 como entrada, a 1 rad/s o %2 cada uno.</translation>
    </message>
    <message>
        <source>Hand of the thread</source>
        <translation>Sentido de la rosca</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>The mechanism drawn in four ways; a click on a tab chooses one.</source>
        <translation>El mecanismo dibujado de cuatro maneras; un clic en una pestaña elige una.</translation>
    </message>
    <message>
        <source>Tools for drawing, undo and redo, the motion, and the search field.</source>
        <translation>Herramientas de dibujo, deshacer y rehacer, el movimiento y el campo de búsqueda.</translation>
    </message>
    <message>
        <source>What has to be known about the file of this window.</source>
        <translation>Lo que hay que saber del archivo de esta ventana.</translation>
    </message>
    <message>
        <source>Begin a mechanism, or open a recent document or an example.</source>
        <translation>Comience un mecanismo, o abra un documento reciente o un ejemplo.</translation>
    </message>
    <message>
        <source>What the tool expects next, and the counts of the mechanism.</source>
        <translation>Lo que la herramienta espera a continuación, y los números del mecanismo.</translation>
    </message>
</context>
</TS>

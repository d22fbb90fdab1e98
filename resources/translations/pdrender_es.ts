<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es">
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
        <translation> por segundo</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> samples</source>
        <translation> muestras</translation>
    </message>
    <message>
        <source> · italics: measured for the previous view</source>
        <translation> · en cursiva: de la vista anterior</translation>
    </message>
    <message>
        <source>"%1" is no address of a node: only a host and a port, without slashes, such as gpu-07:%2.</source>
        <translation>«%1» no es la dirección de un equipo de render: solo equipo y puerto, sin barras, como gpu-07:%2.</translation>
    </message>
    <message>
        <source>"%1" is no host: names have letters, digits, dots and hyphens.</source>
        <translation>«%1» no es un equipo: los nombres tienen letras, cifras, puntos y guiones.</translation>
    </message>
    <message>
        <source>"%1" is no port: ports are numbers from 1 to 65535.</source>
        <translation>«%1» no es un puerto: los puertos son números del 1 al 65535.</translation>
    </message>
    <message>
        <source>"--series %1" interpolates even slices between those that were measured.</source>
        <translation>«--series %1» interpola cortes uniformes entre los medidos.</translation>
    </message>
    <message>
        <source>"pdrender-cli info FOLDER" lists all of them.</source>
        <translation>«pdrender-cli info CARPETA» las muestra todas.</translation>
    </message>
    <message>
        <source>"pdrender-cli info FOLDER" lists those that there are.</source>
        <translation>«pdrender-cli info CARPETA» muestra las que hay.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % bright (%2 to %3)</source>
        <translation>%1 % de brillo (%2 a %3)</translation>
    </message>
    <message>
        <source>%1 % of %2 tiles of render nodes were rendered twice; one false tile in %3 would have been found with a probability of %4 %</source>
        <translation>El %1 % de %2 teselas de otros equipos se calculó dos veces; una falsa entre %3 se habría hallado con una probabilidad del %4 %</translation>
    </message>
    <message>
        <source>%1 % of the heartbeat</source>
        <translation>%1 % del latido</translation>
    </message>
    <message>
        <source>%1 % of the image's samples</source>
        <translation>%1 % de las muestras de la imagen</translation>
    </message>
    <message>
        <source>%1 % of the voxels lie below</source>
        <translation>%1 % de los vóxeles están por debajo</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2, too few voxels for a ±</source>
        <translation>%1 %2, muy pocos vóxeles para un ±</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 a %3)</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (modificado)</translation>
    </message>
    <message>
        <source>%1 (the image changes by %2 levels on average, 95 % of it by less than %3</source>
        <translation>%1 (la imagen cambia %2 niveles de media, el 95 % de ella menos de %3</translation>
    </message>
    <message>
        <source>%1 (the rest is not yet removed)</source>
        <translation>%1 (el resto aún no se ha quitado)</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 UH</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 a lo largo de %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 and %2 are %3 mm apart, the others %4 mm</source>
        <translation>%1 y %2 están a %3 mm, los demás a %4 mm</translation>
    </message>
    <message>
        <source>%1 and %2 lie at the same height along the normal (%3 mm) but differ</source>
        <translation>%1 y %2 están a la misma altura a lo largo de la normal (%3 mm), pero son distintos</translation>
    </message>
    <message>
        <source>%1 and %2 lie on different grids (%3 mm at a corner)</source>
        <translation>%1 y %2 están en rejillas distintas (%3 mm en una esquina)</translation>
    </message>
    <message>
        <source>%1 and %2 look in different directions</source>
        <translation>%1 y %2 tienen orientaciones distintas</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 belongs to "%2". Give that another key first.</source>
        <translation>%1 pertenece a «%2». Asigne primero otra tecla a esa acción.</translation>
    </message>
    <message>
        <source>%1 cannot be given away: it moves the view or the keyboard's place.</source>
        <translation>%1 no se puede asignar: mueve la vista o el foco del teclado.</translation>
    </message>
    <message>
        <source>%1 cannot render this image: %2</source>
        <translation>%1 no puede calcular esta imagen: %2</translation>
    </message>
    <message>
        <source>%1 copies of slices left out (%2)</source>
        <translation>%1 copias de cortes omitidas (%2)</translation>
    </message>
    <message>
        <source>%1 damaged files of this series left out (%2)</source>
        <translation>%1 archivos dañados de esta serie omitidos (%2)</translation>
    </message>
    <message>
        <source>%1 damaged files were left out</source>
        <translation>Se omitieron %1 archivos dañados</translation>
    </message>
    <message>
        <source>%1 does not say its %2</source>
        <translation>%1 no indica: %2</translation>
    </message>
    <message>
        <source>%1 drawn</source>
        <translation>%1 a mano</translation>
    </message>
    <message>
        <source>%1 files (%2 ...)</source>
        <translation>%1 archivos (%2 ...)</translation>
    </message>
    <message>
        <source>%1 files could not be read, and slices of this series may be missing (%2)</source>
        <translation>%1 archivos no se pudieron leer y pueden faltar cortes de esta serie (%2)</translation>
    </message>
    <message>
        <source>%1 free paths between voxels, above %2 multiple scattering comes out wrong</source>
        <translation>%1 recorridos libres entre vóxeles; por encima de %2 la dispersión múltiple sale mal</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 has %2, %3 has %4</source>
        <translation>%1 tiene %2, %3 tiene %4</translation>
    </message>
    <message>
        <source>%1 here, %2 there</source>
        <translation>%1 aquí, %2 allí</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 imágenes</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 in at least %2</source>
        <translation>%1 en al menos %2</translation>
    </message>
    <message>
        <source>%1 is in the list already.</source>
        <translation>%1 ya está en la lista.</translation>
    </message>
    <message>
        <source>%1 is one slice; a volume needs at least two</source>
        <translation>%1 es un corte; un volumen necesita al menos dos</translation>
    </message>
    <message>
        <source>%1 iterations per frame on %2</source>
        <translation>%1 iteraciones por imagen en %2</translation>
    </message>
    <message>
        <source>%1 iterations/s</source>
        <translation>%1 iteraciones/s</translation>
    </message>
    <message>
        <source>%1 joined</source>
        <translation>%1 se unió</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>%1 leaves</source>
        <translation>%1 se despide</translation>
    </message>
    <message>
        <source>%1 lies %2 mm from where slices every %3 mm would put it</source>
        <translation>%1 está a %2 mm de donde lo pondrían cortes cada %3 mm</translation>
    </message>
    <message>
        <source>%1 lies %2 mm sideways of the straight line from %3 to %4</source>
        <translation>%1 está a %2 mm al lado de la línea recta de %3 a %4</translation>
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
        <translation>%1 mm de diferencia en una esquina</translation>
    </message>
    <message>
        <source>%1 mm at the centre's depth</source>
        <translation>%1 mm a la profundidad del centro</translation>
    </message>
    <message>
        <source>%1 mm behind: %2 % of the light</source>
        <translation>%1 mm detrás: %2 % de la luz</translation>
    </message>
    <message>
        <source>%1 mm off</source>
        <translation>a %1 mm</translation>
    </message>
    <message>
        <source>%1 mm: %2 %3</source>
        <translation>%1 mm: %2 %3</translation>
    </message>
    <message>
        <source>%1 mm: %2 %3, interpolated across a hole</source>
        <translation>%1 mm: %2 %3, interpolado a través de un hueco</translation>
    </message>
    <message>
        <source>%1 mm: nothing measured</source>
        <translation>%1 mm: nada medido</translation>
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
        <translation>%1 ms tras el latido</translation>
    </message>
    <message>
        <source>%1 nodes run a different build and were excluded</source>
        <translation>%1 equipos tienen otra versión y quedan excluidos</translation>
    </message>
    <message>
        <source>%1 of %2 slices read; hatched: not read yet</source>
        <translation>%1 de %2 cortes leídos; rayado: aún no leído</translation>
    </message>
    <message>
        <source>%1 of it touched the skin: check the edge.</source>
        <translation>%1 de ello tocaban la piel: revise el borde.</translation>
    </message>
    <message>
        <source>%1 of the curve</source>
        <translation>%1 de la curva</translation>
    </message>
    <message>
        <source>%1 of the voxels are interpolated across a hole.</source>
        <translation>%1 de los vóxeles están interpolados a través de un hueco.</translation>
    </message>
    <message>
        <source>%1 or more thin lines hidden by denoising: E shows where</source>
        <translation>%1 o más líneas finas ocultas al eliminar el ruido: E muestra dónde</translation>
    </message>
    <message>
        <source>%1 over Hounsfield units</source>
        <translation>%1 sobre unidades Hounsfield</translation>
    </message>
    <message>
        <source>%1 over the values of the scan</source>
        <translation>%1 sobre los valores del estudio</translation>
    </message>
    <message>
        <source>%1 pixels stretched to %2</source>
        <translation>%1 píxeles, estirados a %2</translation>
    </message>
    <message>
        <source>%1 plans were not saved, the last one from %2 with %3. They will be restored when their series are opened.</source>
        <translation>No se guardaron %1 planes, el último del %2 con %3. Se recuperarán al abrir sus series.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 muestras</translation>
    </message>
    <message>
        <source>%1 separate parts are kept.</source>
        <translation>Se conservan %1 partes separadas.</translation>
    </message>
    <message>
        <source>%1 series %2</source>
        <translation>Serie de %1 %2</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 cortes</translation>
    </message>
    <message>
        <source>%1 slices may be missing: the files are numbered up to %2, and number %3 and others are not there</source>
        <translation>pueden faltar %1 cortes: los archivos están numerados hasta %2, y faltan el número %3 y otros</translation>
    </message>
    <message>
        <source>%1 slices may be missing: the files state that their acquisition made %2 images, and %3 are there</source>
        <translation>quizá falten %1 cortes: según los archivos, su adquisición produjo %2 imágenes, y hay %3</translation>
    </message>
    <message>
        <source>%1 slices may have been compressed with loss: their coding allows that, and their files do not say</source>
        <translation>%1 cortes quizá se comprimieron con pérdida: su codificación lo permite y sus archivos no lo indican</translation>
    </message>
    <message>
        <source>%1 slices of this series on another grid listed apart</source>
        <translation>%1 cortes de esta serie en otra rejilla se listan aparte</translation>
    </message>
    <message>
        <source>%1 slices state a wrong length in their coding; they are complete, and were read to their end</source>
        <translation>%1 cortes indican una longitud errónea en su codificación; están completos y se leyeron hasta el final</translation>
    </message>
    <message>
        <source>%1 slices state no rescale; stored values are taken as HU</source>
        <translation>%1 cortes no indican reescalado; los valores guardados se toman como HU</translation>
    </message>
    <message>
        <source>%1 slices were compressed with loss (%2): the values are not those that were measured</source>
        <translation>%1 cortes se comprimieron con pérdida (%2): los valores no son los medidos</translation>
    </message>
    <message>
        <source>%1 slices were compressed with loss, which their files do not say: the values are not those that were measured</source>
        <translation>%1 cortes se comprimieron con pérdida, y sus archivos no lo indican: los valores no son los medidos</translation>
    </message>
    <message>
        <source>%1 slices, %2 apart, were resampled to %3 every %4 mm; a slice lies up to %5 mm from where anything was measured</source>
        <translation>%1 cortes, a %2 de distancia, se remuestrearon a %3 cada %4 mm; un corte está a un máximo de %5 mm de donde se midió algo</translation>
    </message>
    <message>
        <source>%1 states a pixel spacing of %2 mm x %3 mm</source>
        <translation>%1 indica un espaciado de píxel de %2 mm x %3 mm</translation>
    </message>
    <message>
        <source>%1 states an orientation that is no pair of perpendicular directions</source>
        <translation>%1 indica una orientación que no es un par de direcciones perpendiculares</translation>
    </message>
    <message>
        <source>%1 stopped answering: %2</source>
        <translation>%1 dejó de responder: %2</translation>
    </message>
    <message>
        <source>%1 thin line hidden by denoising: E shows where</source>
        <translation>%1 línea fina oculta al eliminar el ruido: E muestra dónde</translation>
    </message>
    <message>
        <source>%1 thin lines hidden by denoising: E shows where</source>
        <translation>%1 líneas finas ocultas al eliminar el ruido: E muestra dónde</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 a %2 mm</translation>
    </message>
    <message>
        <source>%1 voxels lie beyond what 16 bits hold and were put at their end (-32768 or 32767 HU)</source>
        <translation>%1 vóxeles están más allá de lo que cabe en 16 bits y se pusieron en su extremo (-32768 o 32767 HU)</translation>
    </message>
    <message>
        <source>%1 waits for the scan</source>
        <translation>%1 espera el estudio</translation>
    </message>
    <message>
        <source>%1 was lost</source>
        <translation>%1 se perdió</translation>
    </message>
    <message>
        <source>%1 was lost: %2</source>
        <translation>%1 se perdió: %2</translation>
    </message>
    <message>
        <source>%1 was paused</source>
        <translation>%1 se pausó</translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation>%1 se quitó</translation>
    </message>
    <message>
        <source>%1 works for others</source>
        <translation>%1 trabaja para otros</translation>
    </message>
    <message>
        <source>%1 x</source>
        <translation>%1 x</translation>
    </message>
    <message>
        <source>%1 x %2 pixels</source>
        <translation>%1 x %2 píxeles</translation>
    </message>
    <message>
        <source>%1 x %2 pixels of %3 mm x %4 mm</source>
        <translation>%1 x %2 píxeles de %3 mm x %4 mm</translation>
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
        <translation>%1 · todos los efectos activos son necesarios</translation>
    </message>
    <message>
        <source>%1 · paused</source>
        <translation>%1 · en pausa</translation>
    </message>
    <message>
        <source>%1 · ±%2 took %3 the last time</source>
        <translation>%1 · ±%2 tardó %3 la última vez</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 × %2 pixels stretched to %3 × %4</source>
        <translation>%1 × %2 píxeles ampliados a %3 × %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 iterations/s, %3</source>
        <translation>%1, %2 iteraciones/s, %3</translation>
    </message>
    <message>
        <source>%1, %2:1</source>
        <translation>%1, %2:1</translation>
    </message>
    <message>
        <source>%1, 95 % of the tissue within ±%2 levels (%3 to %4)</source>
        <translation>%1, 95 % del tejido dentro de ±%2 niveles (%3 a %4)</translation>
    </message>
    <message>
        <source>%1, 95 % of the tissue within ±%2 levels at most, by now not told from none</source>
        <translation>%1, 95 % del tejido dentro de ±%2 niveles como máximo, por ahora indistinguible de ninguno</translation>
    </message>
    <message>
        <source>%1, because %2</source>
        <translation>%1, porque %2</translation>
    </message>
    <message>
        <source>%1, before both sides knew each other</source>
        <translation>%1, antes de que ambas partes se conocieran</translation>
    </message>
    <message>
        <source>%1, before denoising</source>
        <translation>%1, antes de eliminar el ruido</translation>
    </message>
    <message>
        <source>%1, interpolated across a hole</source>
        <translation>%1, interpolado a través de un hueco</translation>
    </message>
    <message>
        <source>%1, not CT</source>
        <translation>%1, no TC</translation>
    </message>
    <message>
        <source>%1, tilted by %2°</source>
        <translation>%1, inclinado %2°</translation>
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
Arrastre las marcas; Ctrl y clic añade una; doble clic elige un color</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>%1: %2 cut off</source>
        <translation>%1: %2 cortados</translation>
    </message>
    <message>
        <source>%1: %2 from the middle</source>
        <translation>%1: a %2 del centro</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1; %2 heights are taken twice</source>
        <translation>%1; %2 alturas están ocupadas dos veces</translation>
    </message>
    <message>
        <source>%1; besides, %2</source>
        <translation>%1; además, %2</translation>
    </message>
    <message>
        <source>%1; measured: %2</source>
        <translation>%1; medido: %2</translation>
    </message>
    <message>
        <source>%1; no gantry tilts by more than %2 degrees</source>
        <translation>%1; ningún gantry se inclina más de %2 grados</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1° from above</source>
        <translation>%1° desde arriba</translation>
    </message>
    <message>
        <source>%1° from below</source>
        <translation>%1° desde abajo</translation>
    </message>
    <message numerus="yes">
        <source>%n measurement(s)</source>
        <translation><numerusform>%n medición</numerusform><numerusform>%n mediciones</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation><numerusform>%n punto</numerusform><numerusform>%n puntos</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n stop(s)</source>
        <translation><numerusform>%n marca</numerusform><numerusform>%n marcas</numerusform></translation>
    </message>
    <message>
        <source>&amp;About PD-Render</source>
        <translation>&amp;Acerca de PD-Render</translation>
    </message>
    <message>
        <source>&amp;All defaults</source>
        <translation>&amp;Todas las predeterminadas</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>Án&amp;gulo</translation>
    </message>
    <message>
        <source>&amp;Brightness</source>
        <translation>&amp;Brillo</translation>
    </message>
    <message>
        <source>&amp;Colour...</source>
        <translation>Colo&amp;r...</translation>
    </message>
    <message>
        <source>&amp;Copy image</source>
        <translation>&amp;Copiar imagen</translation>
    </message>
    <message>
        <source>&amp;Copy slice</source>
        <translation>&amp;Copiar corte</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Corte</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Predeterminada</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>&amp;Denoised</source>
        <translation>&amp;Sin ruido</translation>
    </message>
    <message>
        <source>&amp;Density</source>
        <translation>De&amp;nsidad</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Distancia</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Edit keys...</source>
        <translation>&amp;Editar teclas...</translation>
    </message>
    <message>
        <source>&amp;Export this look...</source>
        <translation>&amp;Exportar este aspecto...</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Fit the slice to its view</source>
        <translation>A&amp;justar el corte a su vista</translation>
    </message>
    <message>
        <source>&amp;Focus here</source>
        <translation>&amp;Enfocar aquí</translation>
    </message>
    <message>
        <source>&amp;Forget these folders</source>
        <translation>&amp;Olvidar estas carpetas</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Pan&amp;talla completa</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>&amp;Fantasma</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>O&amp;cultar</translation>
    </message>
    <message>
        <source>&amp;Image alone</source>
        <translation>Solo la &amp;imagen</translation>
    </message>
    <message>
        <source>&amp;Import...</source>
        <translation>&amp;Importar...</translation>
    </message>
    <message>
        <source>&amp;Iterations per frame</source>
        <translation>Iteraciones/ima&amp;gen</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>&amp;My looks</source>
        <translation>&amp;Mis aspectos</translation>
    </message>
    <message>
        <source>&amp;Next layout</source>
        <translation>&amp;Siguiente disposición</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Ninguna tecla</translation>
    </message>
    <message>
        <source>&amp;Open a folder...</source>
        <translation>Abrir &amp;una carpeta...</translation>
    </message>
    <message>
        <source>&amp;Open folder...</source>
        <translation>&amp;Abrir carpeta...</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Remember folders</source>
        <translation>&amp;Recordar carpetas</translation>
    </message>
    <message>
        <source>&amp;Remove surface</source>
        <translation>Quitar su&amp;perficie</translation>
    </message>
    <message>
        <source>&amp;Rename...</source>
        <translation>&amp;Renombrar...</translation>
    </message>
    <message>
        <source>&amp;Save image...</source>
        <translation>&amp;Guardar imagen...</translation>
    </message>
    <message>
        <source>&amp;Save this look...</source>
        <translation>&amp;Guardar este aspecto...</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>&amp;Table and holder</source>
        <translation>&amp;Mesa y soporte</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Window of the slices</source>
        <translation>&amp;Ventana de los cortes</translation>
    </message>
    <message>
        <source>&amp;Window...</source>
        <translation>&amp;Ventana...</translation>
    </message>
    <message>
        <source>(no unit)</source>
        <translation>(sin unidad)</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, quedan %1</translation>
    </message>
    <message>
        <source>, within ±%1 levels</source>
        <translation>, dentro de ±%1 niveles</translation>
    </message>
    <message>
        <source>/mm</source>
        <translation>/mm</translation>
    </message>
    <message>
        <source>1 copy of a slice left out (%2)</source>
        <translation>1 copia de un corte omitida (%2)</translation>
    </message>
    <message>
        <source>1 damaged file of this series left out (%2)</source>
        <translation>1 archivo dañado de esta serie omitido (%2)</translation>
    </message>
    <message>
        <source>1 damaged file was left out</source>
        <translation>Se omitió 1 archivo dañado</translation>
    </message>
    <message>
        <source>1 file could not be read, and slices of this series may be missing (%2)</source>
        <translation>1 archivo no se pudo leer y pueden faltar cortes de esta serie (%2)</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 imagen</translation>
    </message>
    <message>
        <source>1 iteration per frame on %1</source>
        <translation>1 iteración por imagen en %1</translation>
    </message>
    <message>
        <source>1 node runs a different build and was excluded</source>
        <translation>1 equipo tiene otra versión y queda excluido</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 muestra</translation>
    </message>
    <message>
        <source>1 slice may be missing: the files are numbered up to %2, and number %3 is not there</source>
        <translation>puede faltar 1 corte: los archivos están numerados hasta %2, y falta el número %3</translation>
    </message>
    <message>
        <source>1 slice may be missing: the files state that their acquisition made %2 images, and %3 are there</source>
        <translation>quizá falte 1 corte: según los archivos, su adquisición produjo %2 imágenes, y hay %3</translation>
    </message>
    <message>
        <source>1 slice may have been compressed with loss: its coding allows that, and its file does not say</source>
        <translation>1 corte quizá se comprimió con pérdida: su codificación lo permite y su archivo no lo indica</translation>
    </message>
    <message>
        <source>1 slice of this series on another grid listed apart</source>
        <translation>1 corte de esta serie en otra rejilla se lista aparte</translation>
    </message>
    <message>
        <source>1 slice states a wrong length in its coding; it is complete, and was read to its end</source>
        <translation>1 corte indica una longitud errónea en su codificación; está completo y se leyó hasta el final</translation>
    </message>
    <message>
        <source>1 slice states no rescale; stored values are taken as HU</source>
        <translation>1 corte no indica reescalado; los valores guardados se toman como HU</translation>
    </message>
    <message>
        <source>1 slice was compressed with loss (%2): the values are not those that were measured</source>
        <translation>1 corte se comprimió con pérdida (%2): los valores no son los medidos</translation>
    </message>
    <message>
        <source>1 slice was compressed with loss, which its file does not say: the values are not those that were measured</source>
        <translation>1 corte se comprimió con pérdida, y su archivo no lo indica: los valores no son los medidos</translation>
    </message>
    <message>
        <source>1 voxel lies beyond what 16 bits hold and was put at their end (-32768 or 32767 HU)</source>
        <translation>1 vóxel está más allá de lo que cabe en 16 bits y se puso en su extremo (-32768 o 32767 HU)</translation>
    </message>
    <message>
        <source>1/√t</source>
        <translation>1/√t</translation>
    </message>
    <message>
        <source>3D Slicer before 5.9, curves only (*.vp)</source>
        <translation>3D Slicer anterior a 5.9, solo curvas (*.vp)</translation>
    </message>
    <message>
        <source>3D Slicer, curves only (*.vp.json)</source>
        <translation>3D Slicer, solo curvas (*.vp.json)</translation>
    </message>
    <message>
        <source>95 % error per pixel, of 255</source>
        <translation>error del 95 % por píxel, de 255</translation>
    </message>
    <message>
        <source>95 % of the image changes by no more levels than this; to 95 % it lies between the two faint numbers</source>
        <translation>El 95 % de la imagen cambia a lo sumo en estos niveles; al 95 % está entre los dos números tenues</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % dentro de</translation>
    </message>
    <message>
        <source>; any target takes %1 of the time</source>
        <translation>; cualquier objetivo necesita el %1 del tiempo</translation>
    </message>
    <message>
        <source>&lt; %1</source>
        <translation>&lt; %1</translation>
    </message>
    <message>
        <source>&lt;h3&gt;PD-Render %1&lt;/h3&gt;&lt;p&gt;Photorealistic images of CT volumes, with a measure of how right they are.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnostic use.&lt;/b&gt; PD-Render is not a certified medical device.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Made with Qt, DCMTK, OpenEXR and oneTBB.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;PD-Render %1&lt;/h3&gt;&lt;p&gt;Imágenes fotorrealistas de volúmenes de TC, con una medida de su exactitud.&lt;/p&gt;&lt;p&gt;&lt;b&gt;No apto para diagnóstico.&lt;/b&gt; PD-Render no es un producto sanitario certificado.&lt;/p&gt;&lt;p&gt;Licencia Apache 2.0. Hecho con Qt, DCMTK, OpenEXR y oneTBB.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A pinhole, which focuses nowhere</source>
        <translation>Una cámara estenopeica, que no enfoca ningún punto</translation>
    </message>
    <message>
        <source>A plan from %1 with %2 was not saved. It will be restored when its series is opened.</source>
        <translation>No se guardó un plan del %1 con %2. Se recuperará al abrir su serie.</translation>
    </message>
    <message>
        <source>A plane between front and back</source>
        <translation>Un plano entre delante y detrás</translation>
    </message>
    <message>
        <source>A plane between head and feet</source>
        <translation>Un plano entre cabeza y pies</translation>
    </message>
    <message>
        <source>A plane between left and right</source>
        <translation>Un plano entre izquierda y derecha</translation>
    </message>
    <message>
        <source>A plane that faces you, through the middle</source>
        <translation>Un plano de frente a usted, por el centro</translation>
    </message>
    <message>
        <source>A sample takes about %1 times as long as with “%2”; 95 % of the image changes by at most %3 of 255 levels.</source>
        <translation>Una muestra tarda unas %1 veces lo que con «%2»; el 95 % de la imagen cambia como mucho %3 de 255 niveles.</translation>
    </message>
    <message>
        <source>A small lamp beside the eye: few shadows, and light in every recess</source>
        <translation>Una lámpara pequeña junto al ojo: pocas sombras y luz en cada hueco</translation>
    </message>
    <message>
        <source>A small lamp from the side that shows form, a weak one against it, and one behind</source>
        <translation>Una lámpara pequeña desde el lado que muestra la forma, una débil enfrente y otra detrás</translation>
    </message>
    <message>
        <source>A&amp;nnotate saved images</source>
        <translation>A&amp;notar imágenes guardadas</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>About PD-Render</source>
        <translation>Acerca de PD-Render</translation>
    </message>
    <message>
        <source>About the series</source>
        <translation>Acerca de la serie</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Exactitud</translation>
    </message>
    <message>
        <source>Accuracy of the image</source>
        <translation>Exactitud de la imagen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Acciones y sus teclas</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Add a &amp;plane that faces you</source>
        <translation>Añadir un &amp;plano de frente</translation>
    </message>
    <message>
        <source>Add a plane: %1</source>
        <translation>Añadir un plano: %1</translation>
    </message>
    <message>
        <source>Add the node</source>
        <translation>Añadir el equipo de render</translation>
    </message>
    <message>
        <source>Address of a node</source>
        <translation>Dirección de un equipo de render</translation>
    </message>
    <message>
        <source>Adds a panel like the chosen one, as a lamp of its own</source>
        <translation>Añade un panel como el elegido, como lámpara propia</translation>
    </message>
    <message>
        <source>All but %1</source>
        <translation>Todo menos %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>All is sharp. A lens blurs what lies before and behind its focus.</source>
        <translation>Todo está nítido. Una lente desenfoca lo que hay delante y detrás de su foco.</translation>
    </message>
    <message>
        <source>All nodes compute the same bits as this machine</source>
        <translation>Todos los equipos de render calculan los mismos bits que este equipo</translation>
    </message>
    <message>
        <source>All of the message</source>
        <translation>Todo el mensaje</translation>
    </message>
    <message>
        <source>All panels in numbers</source>
        <translation>Todos los paneles en números</translation>
    </message>
    <message>
        <source>All sharp</source>
        <translation>Todo nítido</translation>
    </message>
    <message>
        <source>All tissue glows through all other. Lamps have no effect.</source>
        <translation>Todo tejido brilla a través de los demás. Las luces no cuentan.</translation>
    </message>
    <message>
        <source>Always samples</source>
        <translation>Siempre muestras</translation>
    </message>
    <message>
        <source>Always tiles</source>
        <translation>Siempre teselas</translation>
    </message>
    <message>
        <source>Ambie&amp;nt</source>
        <translation>Luz &amp;del entorno</translation>
    </message>
    <message>
        <source>Ambient light</source>
        <translation>Luz ambiental</translation>
    </message>
    <message>
        <source>An IPv6 address stands in brackets: [%1] or [%1]:%2.</source>
        <translation>Una dirección IPv6 va entre corchetes: [%1] o [%1]:%2.</translation>
    </message>
    <message>
        <source>An end at an edge, at %1 %2.</source>
        <translation>Un extremo en un borde, a %1 %2.</translation>
    </message>
    <message>
        <source>An image is still rendering. Quit and discard it?</source>
        <translation>Aún se calcula una imagen. ¿Salir y descartarla?</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Ángulo %1</translation>
    </message>
    <message>
        <source>Angle of two lines</source>
        <translation>Ángulo de dos líneas</translation>
    </message>
    <message>
        <source>Annotations:</source>
        <translation>Anotaciones:</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Otro</translation>
    </message>
    <message>
        <source>Apert&amp;ure</source>
        <translation>Apert&amp;ura</translation>
    </message>
    <message>
        <source>Aperture</source>
        <translation>Apertura</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Area %1.</source>
        <translation>Área %1.</translation>
    </message>
    <message>
        <source>Area of a polygon</source>
        <translation>Área de un polígono</translation>
    </message>
    <message>
        <source>Arrow keys move the chosen lamp, Page up and Page down choose another, Shift and arrow keys turn all.</source>
        <translation>Las flechas mueven la lámpara elegida, Re Pág y Av Pág eligen otra, Mayús y flechas giran todas.</translation>
    </message>
    <message>
        <source>As all tissue</source>
        <translation>Como todo el tejido</translation>
    </message>
    <message>
        <source>As many iterations per frame as keep the cost of display negligible, within the frame rate. The result is the same.</source>
        <translation>Tantas iteraciones entre dos imágenes que mostrarlas casi no cueste nada, pero no más de las que permite el número de imágenes por segundo. El resultado es el mismo.</translation>
    </message>
    <message>
        <source>As on the screen, %1</source>
        <translation>Como en la pantalla, %1</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>As the scan states</source>
        <translation>Como indica el estudio</translation>
    </message>
    <message>
        <source>Ask its owner for permission to read.</source>
        <translation>Pida permiso de lectura a su propietario.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Away</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Axial %1 of %2</source>
        <translation>Axial %1 de %2</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Corte axial</translation>
    </message>
    <message>
        <source>Bac&amp;kground</source>
        <translation>F&amp;ondo</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Back light</source>
        <translation>Contraluz</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Ball %1</source>
        <translation>Esfera %1</translation>
    </message>
    <message>
        <source>Bell</source>
        <translation>Campana</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negro</translation>
    </message>
    <message>
        <source>Blur each iteration</source>
        <translation>Desenfocar cada iteración</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Bone beside contrast</source>
        <translation>Hueso junto a contraste</translation>
    </message>
    <message>
        <source>Bone is a ghost only, and soft tissue is not shown. Implants are found by the density of metal or by another program; what metal blurs may be among them.</source>
        <translation>El hueso es solo un fantasma y el tejido blando no se muestra. Los implantes se encuentran por la densidad del metal o con otro programa; entre ellos puede estar lo que el metal difumina.</translation>
    </message>
    <message>
        <source>Bone is a shadow only, and soft tissue is not shown. What metal blurs looks like metal.</source>
        <translation>El hueso es solo una sombra y no se ven los tejidos blandos. Lo que el metal emborrona parece metal.</translation>
    </message>
    <message>
        <source>Bone is found automatically. Thin or porous bone may be missing; dense contrast may remain.</source>
        <translation>El hueso se detecta automáticamente. Puede faltar hueso fino o poroso; puede quedar contraste denso.</translation>
    </message>
    <message>
        <source>Bone is removed automatically. Dense contrast may disappear with it; bone edges may remain.</source>
        <translation>El hueso se quita automáticamente. Puede desaparecer contraste denso; pueden quedar bordes de hueso.</translation>
    </message>
    <message>
        <source>Bone that is no denser than the contrast in the blood is not shown: thin bone has false holes.</source>
        <translation>No se ve el hueso que no es más denso que el contraste de la sangre: el hueso fino tiene agujeros falsos.</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Huesos</translation>
    </message>
    <message>
        <source>Bones alone</source>
        <translation>Solo huesos</translation>
    </message>
    <message>
        <source>Bones and vessels</source>
        <translation>Huesos y vasos</translation>
    </message>
    <message>
        <source>Bones are not shown, nor is what lies within 2 mm of them; dense vessels may be missing with them.</source>
        <translation>No se muestran los huesos ni lo que está a menos de 2 mm de ellos; con ellos pueden faltar vasos densos.</translation>
    </message>
    <message>
        <source>Bones, vessels and muscle</source>
        <translation>Huesos, vasos y músculos</translation>
    </message>
    <message>
        <source>Both programs should be of the same release.</source>
        <translation>Ambos programas deben ser de la misma versión.</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Cerebro</translation>
    </message>
    <message>
        <source>Bright values, solid</source>
        <translation>Valores claros, sólidos</translation>
    </message>
    <message>
        <source>Brightens shadows; none at the left end</source>
        <translation>Aclara lo que está en sombra; en el extremo izquierdo no hay ninguna</translation>
    </message>
    <message>
        <source>Brighter to the right. It changes what is shown, not what is computed.</source>
        <translation>Más claro hacia la derecha. Cambia lo que se muestra, no lo que se calcula.</translation>
    </message>
    <message>
        <source>Brightest values</source>
        <translation>Valores más claros</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Bytes from the node</source>
        <translation>Bytes desde el equipo de render</translation>
    </message>
    <message>
        <source>Bytes to the node</source>
        <translation>Bytes hacia el equipo de render</translation>
    </message>
    <message>
        <source>C&amp;olours on the slices</source>
        <translation>C&amp;olores en los cortes</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>CT &amp;denoised</source>
        <translation>&amp;Reducir ruido de la TC</translation>
    </message>
    <message>
        <source>CT denoised</source>
        <translation>Ruido de la TC reducido</translation>
    </message>
    <message>
        <source>CT series %1</source>
        <translation>Serie de TC %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel a gesture, reading or a box, close a message</source>
        <translation>Cancelar un gesto, la lectura o un recuadro, cerrar un mensaje</translation>
    </message>
    <message>
        <source>Cancelled: no image was saved</source>
        <translation>Cancelado: no se guardó ninguna imagen</translation>
    </message>
    <message>
        <source>Certificates...</source>
        <translation>Certificados...</translation>
    </message>
    <message>
        <source>Change its permissions, or choose another name.</source>
        <translation>Cambie sus permisos o elija otro nombre.</translation>
    </message>
    <message>
        <source>Change that.</source>
        <translation>Cambie eso.</translation>
    </message>
    <message>
        <source>Change the view or the look first.</source>
        <translation>Cambie antes la vista o el aspecto.</translation>
    </message>
    <message>
        <source>Changes keyboard shortcuts.</source>
        <translation>Cambia los atajos de teclado.</translation>
    </message>
    <message>
        <source>Check all</source>
        <translation>Comprobar todo</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Compruebe sus permisos.</translation>
    </message>
    <message>
        <source>Check size and type.</source>
        <translation>Compruebe el tamaño y el tipo.</translation>
    </message>
    <message>
        <source>Check that you may read it.</source>
        <translation>Compruebe que puede leerlo.</translation>
    </message>
    <message>
        <source>Check the disk that it lies on.</source>
        <translation>Compruebe el disco en el que está.</translation>
    </message>
    <message>
        <source>Check the file.</source>
        <translation>Compruebe el archivo.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Compruebe la ruta.</translation>
    </message>
    <message>
        <source>Check the spelling.</source>
        <translation>Compruebe cómo está escrito.</translation>
    </message>
    <message>
        <source>Check the type, and that the file is little endian.</source>
        <translation>Compruebe el tipo y que el archivo sea little endian.</translation>
    </message>
    <message>
        <source>Check the unit: it is millimetres.</source>
        <translation>Compruebe la unidad: son milímetros.</translation>
    </message>
    <message>
        <source>Check this machine's clock.</source>
        <translation>Compruebe el reloj de este equipo.</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Tórax</translation>
    </message>
    <message>
        <source>Choose a folder of your own.</source>
        <translation>Elija una carpeta propia.</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to.</source>
        <translation>Elija una carpeta en la que pueda escribir.</translation>
    </message>
    <message>
        <source>Choose a folder with a NIfTI, NRRD or MetaImage mask of each part.</source>
        <translation>Elija una carpeta con una máscara NIfTI, NRRD o MetaImage de cada parte.</translation>
    </message>
    <message>
        <source>Choose a folder with fewer masks.</source>
        <translation>Elija una carpeta con menos máscaras.</translation>
    </message>
    <message>
        <source>Choose a folder with masks of one scan.</source>
        <translation>Elija una carpeta con máscaras de un solo estudio.</translation>
    </message>
    <message>
        <source>Choose a label map: a DICOM segmentation, NIfTI, NRRD or MetaImage.</source>
        <translation>Elija un mapa de etiquetas: una segmentación DICOM, NIfTI, NRRD o MetaImage.</translation>
    </message>
    <message>
        <source>Choose a label map: whole numbers from 0 on, one for each part.</source>
        <translation>Elija un mapa de etiquetas: números enteros desde 0, uno para cada parte.</translation>
    </message>
    <message>
        <source>Choose a name that ends in .png or .exr.</source>
        <translation>Elija un nombre que termine en .png o .exr.</translation>
    </message>
    <message>
        <source>Choose a series from the list on the left.</source>
        <translation>Elija una serie de la lista de la izquierda.</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Elija un nombre más corto.</translation>
    </message>
    <message>
        <source>Choose a smaller size.</source>
        <translation>Elija un tamaño menor.</translation>
    </message>
    <message>
        <source>Choose an action, click below, and press its new key.</source>
        <translation>Elija una acción, haga clic abajo y pulse su nueva tecla.</translation>
    </message>
    <message>
        <source>Choose an empty or a new folder.</source>
        <translation>Elija una carpeta vacía o nueva.</translation>
    </message>
    <message>
        <source>Choose another device; this one cannot be trusted.</source>
        <translation>Elija otro dispositivo; este no es de fiar.</translation>
    </message>
    <message>
        <source>Choose another folder, or delete this one first: nodes that have the old ones are strangers then.</source>
        <translation>Elija otra carpeta o borre antes esta: los equipos de render que tengan los antiguos serán entonces extraños.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Elija otra carpeta.</translation>
    </message>
    <message>
        <source>Choose another image.</source>
        <translation>Elija otra imagen.</translation>
    </message>
    <message>
        <source>Choose another name, or one within it.</source>
        <translation>Elija otro nombre, o uno dentro de ella.</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Elija otro nombre.</translation>
    </message>
    <message>
        <source>Choose another one.</source>
        <translation>Elija otra opción.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Elija otro lugar.</translation>
    </message>
    <message>
        <source>Choose another port.</source>
        <translation>Elija otro puerto.</translation>
    </message>
    <message>
        <source>Choose another series.</source>
        <translation>Elija otra serie.</translation>
    </message>
    <message>
        <source>Choose auto, cpu, cuda or cuda:1.</source>
        <translation>Elija auto, cpu, cuda o cuda:1.</translation>
    </message>
    <message>
        <source>Choose exact filtering, which needs less, import a part of the series, close programs that use the device, or render on the CPU.</source>
        <translation>Elija el filtrado exacto, que necesita menos, importe una parte de la serie, cierre programas que usen el dispositivo o calcule en la CPU.</translation>
    </message>
    <message>
        <source>Choose exact filtering.</source>
        <translation>Elija el filtrado exacto.</translation>
    </message>
    <message>
        <source>Choose the colour of the selected stop</source>
        <translation>Elegir el color de la marca elegida</translation>
    </message>
    <message>
        <source>Choose the schedule of PD-Render.</source>
        <translation>Elija el orden de trabajo de PD-Render.</translation>
    </message>
    <message>
        <source>Choose the series that it was made on.</source>
        <translation>Elija la serie sobre la que se creó.</translation>
    </message>
    <message>
        <source>Click a place, and type what it is. The list shows its value.</source>
        <translation>Haga clic en un punto y escriba qué es. La lista muestra su valor.</translation>
    </message>
    <message>
        <source>Click both ends of a line, then of another: the angle between their directions.</source>
        <translation>Haga clic en ambos extremos de una línea y luego de otra: el ángulo entre sus direcciones.</translation>
    </message>
    <message>
        <source>Click the corners of a polygon on a slice. Enter, a double click or a click on the first corner closes it, Backspace takes the last corner back.</source>
        <translation>Haga clic en los vértices de un polígono en un corte. Intro, un doble clic o un clic en el primer vértice lo cierran; Retroceso quita el último vértice.</translation>
    </message>
    <message>
        <source>Click the middle of a ball, then a place on its surface: the mean of the values inside.</source>
        <translation>Haga clic en el centro de una esfera y luego en un punto de su superficie: la media de los valores de dentro.</translation>
    </message>
    <message>
        <source>Click the middle of an ellipse on a slice, the end of one half axis, then how far the other reaches: the mean of the values inside, and the area.</source>
        <translation>Haga clic en un corte en el centro de una elipse, en el extremo de un semieje y luego hasta donde llega el otro: la media de los valores de dentro y el área.</translation>
    </message>
    <message>
        <source>Click there, or press Esc to give it up.</source>
        <translation>Haga clic allí o abandónela con Esc.</translation>
    </message>
    <message>
        <source>Click three places of a slice or of the image: the angle at the second.</source>
        <translation>Haga clic en tres puntos de un corte o de la imagen: el ángulo en el segundo.</translation>
    </message>
    <message>
        <source>Click two places of a slice or of the image. They move to the edge of a structure; Alt: they stay.</source>
        <translation>Haga clic en dos puntos de un corte o de la imagen. Pasan al borde de una estructura; con Alt se quedan.</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>Cerrar %1</translation>
    </message>
    <message>
        <source>Close it with Enter, or take corners back with Backspace.</source>
        <translation>Ciérrelo con Intro o quite vértices con Retroceso.</translation>
    </message>
    <message>
        <source>Close other programs, or import fewer slices.</source>
        <translation>Cierre otros programas o importe menos cortes.</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit of open files (ulimit -n).</source>
        <translation>Cierre otros programas o aumente el límite de archivos abiertos (ulimit -n).</translation>
    </message>
    <message>
        <source>Close other programs, or show everything.</source>
        <translation>Cierre otros programas o muéstrelo todo.</translation>
    </message>
    <message>
        <source>Close other programs, or take a smaller volume.</source>
        <translation>Cierre otros programas o use un volumen menor.</translation>
    </message>
    <message>
        <source>Close other programs, then try again.</source>
        <translation>Cierre otros programas y vuelva a intentarlo.</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>Cierre otros programas.</translation>
    </message>
    <message>
        <source>Close panel</source>
        <translation>Cerrar panel</translation>
    </message>
    <message>
        <source>Close programs that use the GPU, make the image smaller, or render on the CPU.</source>
        <translation>Cierre programas que usen la GPU, haga la imagen más pequeña o calcule en la CPU.</translation>
    </message>
    <message>
        <source>Close programs, or make the image smaller.</source>
        <translation>Cierre programas o haga la imagen más pequeña.</translation>
    </message>
    <message>
        <source>Close that program, or ask who looks after the computer; until then only the CPU can render.</source>
        <translation>Cierre ese programa o pregunte a quien mantiene el ordenador; hasta entonces solo puede calcular la CPU.</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Cerrar el mensaje</translation>
    </message>
    <message>
        <source>Closes the window. Unsaved images are lost.</source>
        <translation>Cierra la ventana. Las imágenes sin guardar se pierden.</translation>
    </message>
    <message>
        <source>Coarse preview; the full image follows</source>
        <translation>Vista previa; sigue la imagen completa</translation>
    </message>
    <message>
        <source>Colour at %1</source>
        <translation>Color en %1</translation>
    </message>
    <message>
        <source>Colour of its light: double click it</source>
        <translation>Color de su luz: doble clic para cambiarlo</translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation>Color de la luz</translation>
    </message>
    <message>
        <source>Colour of the part</source>
        <translation>Color de la parte</translation>
    </message>
    <message>
        <source>Colour of the selected stop</source>
        <translation>Color de la marca elegida</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Color...</translation>
    </message>
    <message>
        <source>Colours each pixel by its 95 % error, in grey levels of 255.</source>
        <translation>Colorea cada píxel según cuánto puede desviarse, en niveles de gris de 255.</translation>
    </message>
    <message>
        <source>Colours over Hounsfield units</source>
        <translation>Colores sobre unidades Hounsfield</translation>
    </message>
    <message>
        <source>Colours over the values of the scan</source>
        <translation>Colores sobre los valores del estudio</translation>
    </message>
    <message>
        <source>Comparison with Exposure Render</source>
        <translation>Comparación con Exposure Render</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Conectando</translation>
    </message>
    <message>
        <source>Connection security</source>
        <translation>Seguridad de la conexión</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copiado</translation>
    </message>
    <message>
        <source>Copies the image to the clipboard, with its caption and without the patient's name.</source>
        <translation>Copia la imagen al portapapeles, con su leyenda y sin nombre.</translation>
    </message>
    <message>
        <source>Copy the file again from its source.</source>
        <translation>Copie de nuevo el archivo desde su origen.</translation>
    </message>
    <message>
        <source>Copy the file again.</source>
        <translation>Vuelva a copiar el archivo.</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Coronal %1 of %2</source>
        <translation>Coronal %1 de %2</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Corte coronal</translation>
    </message>
    <message>
        <source>Correct that place, or remove the measurement from the file.</source>
        <translation>Corrija ese lugar o quite la medición del archivo.</translation>
    </message>
    <message>
        <source>Create it by hand, or make the folder above it writable.</source>
        <translation>Créela a mano o permita escribir en la carpeta superior.</translation>
    </message>
    <message>
        <source>Create the folder first, or choose another place.</source>
        <translation>Cree antes la carpeta o elija otro lugar.</translation>
    </message>
    <message>
        <source>Ctrl+click on the image</source>
        <translation>Ctrl+clic en la imagen</translation>
    </message>
    <message>
        <source>Ctrl+drag on the image</source>
        <translation>Ctrl+arrastrar en la imagen</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Cut away the other side</source>
        <translation>Corta el otro lado</translation>
    </message>
    <message>
        <source>Cut off at each side</source>
        <translation>Cortado en cada lado</translation>
    </message>
    <message>
        <source>Cut the other side</source>
        <translation>Cortar el otro lado</translation>
    </message>
    <message>
        <source>Cut with &amp;handles</source>
        <translation>Cortar con &amp;asas</translation>
    </message>
    <message>
        <source>Cuts away what lies in front of a plane through the middle of the image.</source>
        <translation>Corta lo que queda delante de un plano por el centro de la imagen.</translation>
    </message>
    <message>
        <source>Delete "%1"?</source>
        <translation>¿Borrar «%1»?</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete the look</source>
        <translation>Borrar el aspecto</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Eliminar todos</translation>
    </message>
    <message>
        <source>Denoised, error not known yet</source>
        <translation>Sin ruido, error aún desconocido</translation>
    </message>
    <message>
        <source>Denoised, error ±%1</source>
        <translation>Sin ruido, error ±%1</translation>
    </message>
    <message>
        <source>Denoised, image error ±%1 of 255 grey levels (95 % of the tissue)</source>
        <translation>Sin ruido, error de la imagen ±%1 de 255 niveles de gris (95 % del tejido)</translation>
    </message>
    <message>
        <source>Density at the top of the opacity curve</source>
        <translation>Densidad en lo más alto de la curva de opacidad</translation>
    </message>
    <message>
        <source>Depth is not shown, nor anything outside the lungs, nor their outermost 5 mm.</source>
        <translation>No se ve la profundidad, ni nada fuera de los pulmones, ni sus 5 mm exteriores.</translation>
    </message>
    <message>
        <source>Depth is not shown, nor what lies in front of or behind something denser.</source>
        <translation>No se ve la profundidad, ni lo que está delante o detrás de algo más denso.</translation>
    </message>
    <message>
        <source>Depth is not shown: what lies behind one another adds up.</source>
        <translation>No se ve la profundidad: lo que está uno tras otro se suma.</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>Dialling</source>
        <translation>Llamando</translation>
    </message>
    <message>
        <source>Diameter of the lens. At 0 all is sharp; the larger, the less is sharp before and behind the focus</source>
        <translation>Diámetro de la lente. Con 0 todo está nítido; cuanto mayor, menos nítido es lo que hay delante y detrás del foco</translation>
    </message>
    <message>
        <source>Disconnect the selected nodes and erase the scan on them (Delete)</source>
        <translation>Desconecta los equipos elegidos y borra la exploración en ellos (Supr)</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Distancia %1</translation>
    </message>
    <message>
        <source>Distance cut off, side: %1</source>
        <translation>Cortado en el lado: %1</translation>
    </message>
    <message>
        <source>Distance of the plane from the middle</source>
        <translation>Distancia del plano al centro</translation>
    </message>
    <message>
        <source>Double click on a handle</source>
        <translation>Doble clic en un tirador</translation>
    </message>
    <message>
        <source>Drag a lamp to where the light is to come from: over the ball it stands on your side, in the ring about it behind the patient. Beside the lamps, a drag turns them all. On the image, Shift and the right button do the same.</source>
        <translation>Arrastre una lámpara hasta donde deba venir la luz: sobre la esfera está de su lado, en el anillo que la rodea detrás del paciente. Junto a las lámparas, arrastrar las gira todas. En la imagen, Mayús y el botón derecho hacen lo mismo.</translation>
    </message>
    <message>
        <source>Drag a side of the box to cut off what lies outside, in millimetres.</source>
        <translation>Arrastre un lado de la caja para cortar lo que queda fuera, en milímetros.</translation>
    </message>
    <message>
        <source>Drag points; click the line to add one; wheel zooms, with Shift the values; double click fits</source>
        <translation>Arrastre los puntos; un clic en la línea añade uno; la rueda amplía, con Mayús los valores; doble clic lo muestra todo</translation>
    </message>
    <message>
        <source>Draw a box on the image: it gets all samples until it reaches the target.</source>
        <translation>Dibuje un recuadro en la imagen: recibe todas las muestras hasta que sea tan bueno como se desea.</translation>
    </message>
    <message>
        <source>Draw a closed outline on the image, then remove the tissue inside it, or everything else (X)</source>
        <translation>Dibuje una línea cerrada en la imagen y corte lo que queda detrás, o todo lo demás (X)</translation>
    </message>
    <message>
        <source>Draw a closed outline on the image, then remove the tissue inside it, or everything else.</source>
        <translation>Dibuje una línea cerrada en la imagen y corte lo que queda detrás, o todo lo demás.</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>E&amp;rror map</source>
        <translation>Mapa de e&amp;rror</translation>
    </message>
    <message>
        <source>E&amp;xport measurements...</source>
        <translation>E&amp;xportar mediciones...</translation>
    </message>
    <message>
        <source>Each pixel shows the highest value along its ray; nothing says how deep it lies.</source>
        <translation>Cada píxel muestra el valor más alto a lo largo de su rayo; nada dice a qué profundidad está.</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Edit keys</source>
        <translation>Editar teclas</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>Efficiency: the part of its time that went into samples</source>
        <translation>Eficiencia: la parte de su tiempo que se dedicó a muestras</translation>
    </message>
    <message>
        <source>Eight panels as in a photographer's studio: strips behind draw the edges</source>
        <translation>Ocho paneles como en un estudio fotográfico: las tiras de detrás dibujan los bordes</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Ellipse %1</source>
        <translation>Elipse %1</translation>
    </message>
    <message>
        <source>Encrypted, and each side proves who it is, by the certificates in %1</source>
        <translation>Cifrado, y cada parte demuestra quién es, con los certificados de %1</translation>
    </message>
    <message>
        <source>Environment image...</source>
        <translation>Imagen de entorno...</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Error frente al tiempo</translation>
    </message>
    <message>
        <source>Error at that point</source>
        <translation>Error en ese punto</translation>
    </message>
    <message>
        <source>Error map</source>
        <translation>Mapa de error</translation>
    </message>
    <message>
        <source>Error map before denoising</source>
        <translation>Mapa de error antes de la reducción de ruido</translation>
    </message>
    <message>
        <source>Error of the image</source>
        <translation>Error de la imagen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Estimando</translation>
    </message>
    <message>
        <source>Estimating how good the image is</source>
        <translation>Estimando la calidad de la imagen</translation>
    </message>
    <message>
        <source>Estimating · image still black</source>
        <translation>Estimando · imagen aún negra</translation>
    </message>
    <message>
        <source>Estimating · the error is not known yet</source>
        <translation>Estimando · el error aún no se conoce</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Estimador</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>Export it again from the program that made it, from this scan.</source>
        <translation>Expórtelo de nuevo desde el programa que lo creó, a partir de este estudio.</translation>
    </message>
    <message>
        <source>Export it again on the grid of the scan; half a voxel is what is missing where voxels are counted from their corners.</source>
        <translation>Expórtelo de nuevo en la cuadrícula del estudio; medio vóxel es lo que falta donde los vóxeles se cuentan desde sus esquinas.</translation>
    </message>
    <message>
        <source>Export the look</source>
        <translation>Exportar el aspecto</translation>
    </message>
    <message>
        <source>Export the measurements</source>
        <translation>Exportar las mediciones</translation>
    </message>
    <message>
        <source>Export the scan as DICOM, or anew in this format.</source>
        <translation>Exporte el estudio como DICOM, o de nuevo en este formato.</translation>
    </message>
    <message>
        <source>Export the segmentation anew, without compression.</source>
        <translation>Exporte la segmentación de nuevo, sin compresión.</translation>
    </message>
    <message>
        <source>Exposure Render blurs every iteration over 3 x 3 pixels before it counts. That hides noise and never averages out: the image stays wrong. For comparison only.</source>
        <translation>Exposure Render desenfoca cada iteración sobre 3 x 3 píxeles antes de contarla. Eso oculta el ruido y nunca se promedia: la imagen sigue siendo errónea. Solo para comparar.</translation>
    </message>
    <message>
        <source>Exposure Render's schedule %1</source>
        <translation>esquema %1 de Exposure Render</translation>
    </message>
    <message>
        <source>Exposure Render's schedule takes whole images only</source>
        <translation>el orden de trabajo de Exposure Render solo admite imágenes enteras</translation>
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
        <translation>Extinción en lo más alto de la curva de opacidad: mayor es tejido más denso en todas partes</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>De frente</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fallos</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>Fiel&amp;d of view</source>
        <translation>Campo &amp;de visión</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo de visión</translation>
    </message>
    <message>
        <source>Files that were left out</source>
        <translation>Archivos omitidos</translation>
    </message>
    <message>
        <source>Fills the screen with the image, the patient's name and its accuracy.</source>
        <translation>Llena la pantalla con la imagen, el nombre del paciente y su exactitud.</translation>
    </message>
    <message>
        <source>Find &amp;implants</source>
        <translation>Buscar &amp;implantes</translation>
    </message>
    <message>
        <source>Find &amp;vessels</source>
        <translation>Buscar &amp;vasos</translation>
    </message>
    <message>
        <source>Find implants</source>
        <translation>Buscar implantes</translation>
    </message>
    <message>
        <source>Find mirrored bone</source>
        <translation>Buscar hueso reflejado</translation>
    </message>
    <message>
        <source>Find skin and muscle</source>
        <translation>Buscar piel y músculo</translation>
    </message>
    <message>
        <source>Find skin, m&amp;uscle</source>
        <translation>Piel, múscu&amp;lo</translation>
    </message>
    <message>
        <source>Find vessels</source>
        <translation>Buscar vasos</translation>
    </message>
    <message>
        <source>Finding what is here...</source>
        <translation>Buscando qué hay aquí...</translation>
    </message>
    <message>
        <source>Finds bone that one side has and the other lacks, such as what closes a defect of the skull.</source>
        <translation>Busca hueso que un lado tiene y al otro le falta, como el que cierra un defecto del cráneo.</translation>
    </message>
    <message>
        <source>Finds implants by the density of metal: a guess, to be checked.</source>
        <translation>Busca implantes por la densidad del metal: una suposición, que hay que comprobar.</translation>
    </message>
    <message>
        <source>Finds skin and muscle by density and geometry: a guess, to be checked.</source>
        <translation>Busca piel y músculo por densidad y geometría: una suposición que debe comprobarse.</translation>
    </message>
    <message>
        <source>Finds vessels on a scan with contrast medium by density and geometry: a guess, to be checked.</source>
        <translation>Busca vasos en un estudio con medio de contraste por densidad y geometría: una suposición que debe comprobarse.</translation>
    </message>
    <message>
        <source>Fluoroscopy</source>
        <translation>Fluoroscopia</translation>
    </message>
    <message>
        <source>Focus o&amp;n...</source>
        <translation>En&amp;focar...</translation>
    </message>
    <message>
        <source>Focus on what is clicked</source>
        <translation>Enfocar donde se haga clic</translation>
    </message>
    <message>
        <source>Folder of &amp;masks...</source>
        <translation>&amp;Máscaras...</translation>
    </message>
    <message>
        <source>Folders are often called after patients: anyone who uses this account can read the list.</source>
        <translation>Las carpetas suelen llevar el nombre de los pacientes: quien use esta cuenta puede leer la lista.</translation>
    </message>
    <message>
        <source>For comparison only: the ways of the renderer that this one replaces.</source>
        <translation>Solo para comparar: los métodos del programa al que este sustituye.</translation>
    </message>
    <message>
        <source>For screenshots: no patient is named anywhere in the window.</source>
        <translation>Para capturas de pantalla: no se nombra a ningún paciente en la ventana.</translation>
    </message>
    <message>
        <source>For the image that is being saved. %1</source>
        <translation>Para la imagen que se está guardando. %1</translation>
    </message>
    <message>
        <source>Found by the program: check it.</source>
        <translation>Encontrado por el programa: compruébelo.</translation>
    </message>
    <message>
        <source>Four &amp;views</source>
        <translation>Cuatro &amp;vistas</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Imágenes por segundo</translation>
    </message>
    <message>
        <source>Frames &amp;per second</source>
        <translation>&amp;Imágenes/s</translation>
    </message>
    <message>
        <source>Free points</source>
        <translation>Puntos libres</translation>
    </message>
    <message>
        <source>Free points, or a curve that a few numbers say. It becomes free points when one is moved.</source>
        <translation>Puntos libres, o una curva descrita por pocos números. Pasa a puntos libres cuando se mueve uno.</translation>
    </message>
    <message>
        <source>Freehan&amp;d cut</source>
        <translation>Corte a mano alza&amp;da</translation>
    </message>
    <message>
        <source>Freehand cuts: %1</source>
        <translation>Cortes a mano alzada: %1</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>From %1 to %2 %3 over %4 mm.</source>
        <translation>De %1 a %2 %3 en %4 mm.</translation>
    </message>
    <message>
        <source>From a question to its answer [milliseconds]</source>
        <translation>De una pregunta a su respuesta [milisegundos]</translation>
    </message>
    <message>
        <source>From the &amp;back (P)</source>
        <translation>Desde &amp;atrás (P)</translation>
    </message>
    <message>
        <source>From the &amp;front (A)</source>
        <translation>Desde &amp;delante (A)</translation>
    </message>
    <message>
        <source>From the &amp;head (H)</source>
        <translation>Desde la ca&amp;beza (H)</translation>
    </message>
    <message>
        <source>From the &amp;left (L)</source>
        <translation>Desde la &amp;izquierda (L)</translation>
    </message>
    <message>
        <source>From the &amp;right (R)</source>
        <translation>Desde la de&amp;recha (R)</translation>
    </message>
    <message>
        <source>From the f&amp;eet (F)</source>
        <translation>Desde los &amp;pies (F)</translation>
    </message>
    <message>
        <source>From the top to the bottom of the image</source>
        <translation>Desde el borde superior al inferior de la imagen</translation>
    </message>
    <message>
        <source>From the top to the bottom of the image. What is in focus keeps its size; the wider, the nearer the eye comes</source>
        <translation>Desde el borde superior al inferior de la imagen. Lo enfocado conserva su tamaño; cuanto más ancho, más se acerca el ojo</translation>
    </message>
    <message>
        <source>From the viewer to the right; beyond 90 degrees it stands behind [degrees]. Of the view from the front where the lamps turn with the patient</source>
        <translation>Del observador hacia la derecha; más allá de 90 grados está detrás [grados]. Respecto a la vista frontal cuando las lámparas giran con el paciente</translation>
    </message>
    <message>
        <source>From the volume's middle [radii of the volume]</source>
        <translation>Desde el centro del volumen [radios del volumen]</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Ghost: %1.</source>
        <translation>Fantasma: %1.</translation>
    </message>
    <message>
        <source>Give HOST or HOST:PORT, with an IPv6 address in brackets: [::1]:4743.</source>
        <translation>Indique HOST o HOST:PUERTO, con una dirección IPv6 entre corchetes: [::1]:4743.</translation>
    </message>
    <message>
        <source>Give a file, no pipe and no device.</source>
        <translation>Indique un archivo, no una tubería ni un dispositivo.</translation>
    </message>
    <message>
        <source>Give a file.</source>
        <translation>Indique un archivo.</translation>
    </message>
    <message>
        <source>Give one of this machine's IP addresses, or the port alone.</source>
        <translation>Indique una dirección IP de este equipo o solo el puerto.</translation>
    </message>
    <message>
        <source>Give one without a password, which only you may read.</source>
        <translation>Indique una sin contraseña que solo usted pueda leer.</translation>
    </message>
    <message>
        <source>Give the folder that --make-certificates has made.</source>
        <translation>Indique la carpeta que hizo --make-certificates.</translation>
    </message>
    <message>
        <source>Give the folder that holds the DICOM files.</source>
        <translation>Indique la carpeta que contiene los archivos DICOM.</translation>
    </message>
    <message>
        <source>Give the part of the bundle named %1.</source>
        <translation>Indique la parte del paquete llamada %1.</translation>
    </message>
    <message>
        <source>Gives the selected parts a colour of their own.</source>
        <translation>Da un color propio a las partes elegidas.</translation>
    </message>
    <message>
        <source>Gives the selected parts the curve and the colours of a look.</source>
        <translation>Da a las partes elegidas la curva y los colores de un aspecto.</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>Brillo propio</translation>
    </message>
    <message>
        <source>Glowing tissue</source>
        <translation>Tejido luminoso</translation>
    </message>
    <message>
        <source>Good for orientation</source>
        <translation>Buena para orientarse</translation>
    </message>
    <message>
        <source>Good for planning</source>
        <translation>Buena para planificar</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>UH</translation>
    </message>
    <message>
        <source>Hard bone</source>
        <translation>Hueso duro</translation>
    </message>
    <message>
        <source>Have it resampled to the nearest voxels, or export it on the grid of the scan.</source>
        <translation>Haga que se remuestree a los vóxeles más cercanos, o expórtelo en la cuadrícula del estudio.</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Lámpara frontal</translation>
    </message>
    <message>
        <source>Heart and great vessels</source>
        <translation>Corazón y grandes vasos</translation>
    </message>
    <message>
        <source>Hei&amp;ght</source>
        <translation>A&amp;ltura</translation>
    </message>
    <message>
        <source>Height of the image [pixels]</source>
        <translation>Alto de la imagen [píxeles]</translation>
    </message>
    <message>
        <source>Height of what is seen</source>
        <translation>Altura de lo visible</translation>
    </message>
    <message>
        <source>Hidden: %1.</source>
        <translation>Oculto: %1.</translation>
    </message>
    <message>
        <source>Hide the patient's &amp;name</source>
        <translation>Ocultar el &amp;nombre del paciente</translation>
    </message>
    <message>
        <source>Hides the selected parts.</source>
        <translation>Oculta las partes elegidas.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>How far the grey levels on the screen are from those of the finished image, for 95 % of the pixels that show tissue. Four times the samples at least halve it. A denoised image has an error of its own and may lack fine detail: S shows the raw image. Click for details.</source>
        <translation>Cuánto distan como máximo los niveles de gris de la pantalla de los de la imagen terminada, para el 95 % de los píxeles que muestran tejido. Cuatro veces más muestras lo reducen al menos a la mitad. Una imagen suavizada tiene un error propio y puede carecer de detalles finos: S muestra la imagen sin suavizar. Un clic dice más.</translation>
    </message>
    <message>
        <source>How far the plane is from the middle of the body, towards the side that it cuts away</source>
        <translation>A qué distancia del centro del cuerpo está el plano, hacia el lado que corta</translation>
    </message>
    <message>
        <source>How high the first selected point is; the others move with it</source>
        <translation>A qué altura está el primer punto elegido; los demás se mueven con él</translation>
    </message>
    <message>
        <source>How iterations become images. Ours accumulates them and updates the display from time to time. Exposure Render runs all stages for each iteration; K0 also uploads everything each time, K1 does not. For comparison only.</source>
        <translation>Cómo las iteraciones se convierten en imágenes. El nuestro las suma y las muestra de vez en cuando. Exposure Render pasa por todas las etapas en cada una; K0 además lo carga todo de nuevo cada vez, K1 no. Solo para comparar.</translation>
    </message>
    <message>
        <source>How light paths are sampled. Unbiased: the image converges to the exact one. The march steps over 3 voxels at a time as Exposure Render does and scatters once: the image stays wrong. For comparison only.</source>
        <translation>Cómo se sigue la luz. Insesgado: la imagen llega a ser la verdadera. Los pasos avanzan 3 vóxeles cada vez como en Exposure Render y dispersan una sola vez: la imagen sigue siendo errónea. Solo para comparar.</translation>
    </message>
    <message>
        <source>How long any target takes without it, in percent of the time with it: an iteration takes another time, and the image has other noise</source>
        <translation>Cuánto tarda un objetivo sin él, en porcentaje del tiempo con él: una iteración tarda otro tiempo, y la imagen tiene otro ruido</translation>
    </message>
    <message>
        <source>How long it takes</source>
        <translation>Cuánto tarda</translation>
    </message>
    <message>
        <source>How much is cut off there; also by the handle in the image (C)</source>
        <translation>Cuánto se corta allí; también con el tirador en la imagen (C)</translation>
    </message>
    <message>
        <source>How much light the chosen lamp brings; at the left end it is off</source>
        <translation>Cuánta luz aporta la lámpara elegida; en el extremo izquierdo está apagada</translation>
    </message>
    <message>
        <source>How nodes share the work</source>
        <translation>Cómo se reparten los equipos de render el trabajo</translation>
    </message>
    <message>
        <source>How the work is split</source>
        <translation>Cómo se reparte el trabajo</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Image error ±%1 of 255 grey levels (95 % of the tissue)</source>
        <translation>Error de la imagen ±%1 de 255 niveles de gris (95 % del tejido)</translation>
    </message>
    <message>
        <source>Image error ±%1 of 255 grey levels before denoising (95 % of the tissue)</source>
        <translation>Error de la imagen ±%1 de 255 niveles de gris antes de la reducción de ruido (95 % del tejido)</translation>
    </message>
    <message>
        <source>Implant over ghost bone</source>
        <translation>Implante sobre hueso fantasma</translation>
    </message>
    <message>
        <source>Implants</source>
        <translation>Implantes</translation>
    </message>
    <message>
        <source>Import a look</source>
        <translation>Importar un aspecto</translation>
    </message>
    <message>
        <source>Import a part of the series, close programs that use the device, or render on the CPU.</source>
        <translation>Importe una parte de la serie, cierre programas que usen el dispositivo o calcule en la CPU.</translation>
    </message>
    <message>
        <source>In front: %1 % of the light</source>
        <translation>Delante: %1 % de la luz</translation>
    </message>
    <message>
        <source>In the region: %1</source>
        <translation>En la región: %1</translation>
    </message>
    <message>
        <source>Install a newer driver, or a build of this program for this GPU; until then only the CPU can render.</source>
        <translation>Instale un controlador más nuevo o una versión del programa compilada para esta GPU; hasta entonces solo puede calcular la CPU.</translation>
    </message>
    <message>
        <source>Install a newer driver; until then only the CPU can render.</source>
        <translation>Instale un controlador más nuevo; hasta entonces solo puede calcular la CPU.</translation>
    </message>
    <message>
        <source>Install libdcmtk17 again.</source>
        <translation>Vuelva a instalar libdcmtk17.</translation>
    </message>
    <message>
        <source>Install one, or render on the CPU.</source>
        <translation>Instale uno o calcule en la CPU.</translation>
    </message>
    <message>
        <source>Invalid samples</source>
        <translation>Muestras no válidas</translation>
    </message>
    <message>
        <source>Is the disk full, or the folder write-protected?</source>
        <translation>¿Está lleno el disco o protegida la carpeta contra escritura?</translation>
    </message>
    <message>
        <source>It is rendered on this machine alone.</source>
        <translation>Se calcula solo en este equipo.</translation>
    </message>
    <message>
        <source>It may be of another scan or patient: choose the series that it was made on.</source>
        <translation>Puede ser de otro estudio o paciente: elija la serie sobre la que se creó.</translation>
    </message>
    <message>
        <source>It needs R, G and B, or Y.</source>
        <translation>Necesita R, G y B, o Y.</translation>
    </message>
    <message>
        <source>It reaches where slices were not measured: they are interpolated, and the ± does not know what lies between.</source>
        <translation>Llega adonde no se midieron cortes: están interpolados, y el ± no sabe qué hay entre ellos.</translation>
    </message>
    <message>
        <source>It was refused, or the device failed before.</source>
        <translation>Se rechazó o el dispositivo falló antes.</translation>
    </message>
    <message>
        <source>It was seen through translucent tissue. Drag it to where it belongs on a slice.</source>
        <translation>Se vio a través de tejido translúcido. Arrástrelo en un corte hasta donde corresponde.</translation>
    </message>
    <message>
        <source>Iterations computed before the image is updated. More is slightly faster, fewer responds sooner; the result is the same.</source>
        <translation>Cuántas iteraciones se calculan antes de mostrar la imagen de nuevo. Más es algo más rápido, menos es más vivo; el resultado es el mismo.</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>Iteraciones por imagen</translation>
    </message>
    <message>
        <source>Iterations/s</source>
        <translation>Iteraciones/s</translation>
    </message>
    <message>
        <source>Its name and where it is reached</source>
        <translation>Cómo se llama y dónde se le encuentra</translation>
    </message>
    <message>
        <source>JPEG lossless</source>
        <translation>JPEG sin pérdida</translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Mantener todo</translation>
    </message>
    <message>
        <source>Keep inside</source>
        <translation>Conservar el interior</translation>
    </message>
    <message>
        <source>Keep only the tissue inside the outline (K)</source>
        <translation>Conservar solo el tejido dentro del contorno (K)</translation>
    </message>
    <message>
        <source>Key of the chosen action</source>
        <translation>Tecla de la acción elegida</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Known here: %1.</source>
        <translation>Conocidos aquí: %1.</translation>
    </message>
    <message>
        <source>Known parts: %1.</source>
        <translation>Partes conocidas: %1.</translation>
    </message>
    <message>
        <source>L&amp;ook of the part</source>
        <translation>&amp;Aspecto de la parte</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Label maps (*.nii *.nii.gz *.nrrd *.mha *.mhd *.dcm)</source>
        <translation>Mapas de etiquetas (*.nii *.nii.gz *.nrrd *.mha *.mhd *.dcm)</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lámpara</translation>
    </message>
    <message>
        <source>Lamp %1</source>
        <translation>Lámpara %1</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>I&amp;dioma</translation>
    </message>
    <message>
        <source>Large soft light</source>
        <translation>Luz grande y suave</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latencia</translation>
    </message>
    <message>
        <source>Lay it onto the grid of this scan.</source>
        <translation>Páselo a la cuadrícula de este estudio.</translation>
    </message>
    <message>
        <source>Leave it; the tile is rendered again.</source>
        <translation>Déjelo; la tesela se calcula de nuevo.</translation>
    </message>
    <message>
        <source>Leave one of the two out.</source>
        <translation>Omita uno de los dos.</translation>
    </message>
    <message>
        <source>Leave one of them out.</source>
        <translation>Omita uno de ellos.</translation>
    </message>
    <message>
        <source>Leave out nodes that lie on a line between their neighbours.</source>
        <translation>Omita los puntos que estén en línea entre sus vecinos.</translation>
    </message>
    <message>
        <source>Leaving</source>
        <translation>Despidiéndose</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Left drag, arrow keys</source>
        <translation>Arrastrar con el botón izquierdo, flechas</translation>
    </message>
    <message>
        <source>Left, Right on the strip</source>
        <translation>Izquierda, Derecha en la barra</translation>
    </message>
    <message>
        <source>Length of its edge [radii of the volume]</source>
        <translation>Longitud de su lado [radios del volumen]</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Light from a panorama of a sky or a room: an OpenEXR file, twice as wide as high</source>
        <translation>Luz de todas partes según la imagen de un cielo o de una sala: un archivo OpenEXR, el doble de ancho que de alto</translation>
    </message>
    <message>
        <source>Light from all around, most from the head's side, and a sun</source>
        <translation>Luz de todas partes, sobre todo desde la cabeza, y un sol</translation>
    </message>
    <message>
        <source>Light from an environment image</source>
        <translation>Luz de una imagen de entorno</translation>
    </message>
    <message>
        <source>Light is scattered on and on: soft, with light in the shadows.</source>
        <translation>La luz se dispersa una y otra vez: suave, con luz en las sombras.</translation>
    </message>
    <message>
        <source>Light is scattered once: crisp surfaces and dark shadows.</source>
        <translation>La luz se dispersa una vez: superficies nítidas y sombras oscuras.</translation>
    </message>
    <message>
        <source>Limit reached first</source>
        <translation>Qué límite llega primero</translation>
    </message>
    <message>
        <source>Listen on port</source>
        <translation>Escuchar en el puerto</translation>
    </message>
    <message>
        <source>Lit surfaces</source>
        <translation>Superficies iluminadas</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Logarithmic histogram</source>
        <translation>Histograma logarítmico</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Aspecto %1</translation>
    </message>
    <message>
        <source>Look (*.json)</source>
        <translation>Aspecto (*.json)</translation>
    </message>
    <message>
        <source>Look: %1</source>
        <translation>Aspecto: %1</translation>
    </message>
    <message>
        <source>Looks cannot hold an environment image: this one has uniform ambient light.</source>
        <translation>Un aspecto no admite imagen de entorno: este tiene luz ambiental uniforme.</translation>
    </message>
    <message>
        <source>Looks, also of 3D Slicer (*.json *.vp)</source>
        <translation>Aspectos, también de 3D Slicer (*.json *.vp)</translation>
    </message>
    <message>
        <source>Looks: %1</source>
        <translation>Aspectos: %1</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdido</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Pulmón</translation>
    </message>
    <message>
        <source>Lung vessels</source>
        <translation>Vasos pulmonares</translation>
    </message>
    <message>
        <source>Lungs</source>
        <translation>Pulmones</translation>
    </message>
    <message>
        <source>M&amp;oves with</source>
        <translation>Se mueve c&amp;on</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MIP of the lungs</source>
        <translation>MIP de los pulmones</translation>
    </message>
    <message>
        <source>Make it of this volume.</source>
        <translation>Hágala de este volumen.</translation>
    </message>
    <message>
        <source>Make it smaller.</source>
        <translation>Hágala más pequeña.</translation>
    </message>
    <message>
        <source>Make it yours alone: chmod 600.</source>
        <translation>Hágala solo suya: chmod 600.</translation>
    </message>
    <message>
        <source>Make new ones with --make-certificates, for the coordinator and all nodes.</source>
        <translation>Haga otros nuevos con --make-certificates, para el coordinador y todos los equipos de render.</translation>
    </message>
    <message>
        <source>Make room there, or choose another place.</source>
        <translation>Haga sitio ahí o elija otro lugar.</translation>
    </message>
    <message>
        <source>Make some with "pdrender-node --make-certificates FOLDER", and give them to both sides: --bundle, or the window's Certificates.</source>
        <translation>Haga unos con «pdrender-node --make-certificates CARPETA» y délos a ambas partes: --bundle, o «Certificados» en la ventana.</translation>
    </message>
    <message>
        <source>Make the image smaller, close programs that use the device, or choose another device.</source>
        <translation>Haga la imagen más pequeña, cierre programas que usen el dispositivo o elija otro dispositivo.</translation>
    </message>
    <message>
        <source>Manual of PD-Render</source>
        <translation>Manual de PD-Render</translation>
    </message>
    <message>
        <source>March of 3 voxels (biased)</source>
        <translation>Pasos de 3 vóxeles (sesgado)</translation>
    </message>
    <message>
        <source>Markups of 3D Slicer (*.mrk.json)</source>
        <translation>Marcas de 3D Slicer (*.mrk.json)</translation>
    </message>
    <message>
        <source>Maximum intensity</source>
        <translation>Intensidad máxima</translation>
    </message>
    <message>
        <source>Mean %1.</source>
        <translation>Media %1.</translation>
    </message>
    <message>
        <source>Mean in a ball</source>
        <translation>Media en una esfera</translation>
    </message>
    <message>
        <source>Mean in an ellipse</source>
        <translation>Media en una elipse</translation>
    </message>
    <message>
        <source>Measure at least 5 sizes with 3 numbers of iterations.</source>
        <translation>Mida al menos 5 tamaños con 3 números de iteraciones.</translation>
    </message>
    <message>
        <source>Measure for longer.</source>
        <translation>Mida durante más tiempo.</translation>
    </message>
    <message>
        <source>Measure more sizes and more numbers of iterations.</source>
        <translation>Mida más tamaños y más números de iteraciones.</translation>
    </message>
    <message>
        <source>Measured %1, %2 s of calibration</source>
        <translation>%1 medido, %2 s de calibración</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Measurements are not saved. Discard them?</source>
        <translation>Las mediciones no están guardadas. ¿Descartarlas?</translation>
    </message>
    <message>
        <source>Measurements exported as %1</source>
        <translation>Mediciones exportadas como %1</translation>
    </message>
    <message>
        <source>Measuring %1 from time to time, in 1/20 of the time</source>
        <translation>Midiendo %1, de vez en cuando, en una vigésima parte del tiempo</translation>
    </message>
    <message>
        <source>Measuring begins when the image is at rest</source>
        <translation>Se medirá en cuanto la imagen esté en reposo</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastino</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Metal outside the body is kept, with what it touches: %1.</source>
        <translation>Se conserva el metal fuera del cuerpo, con lo que toca: %1.</translation>
    </message>
    <message>
        <source>Middle or Shift+left drag</source>
        <translation>Arrastrar con el central o Mayús+izquierdo</translation>
    </message>
    <message>
        <source>Minimum frames per second, where the device can reach it.</source>
        <translation>Cuántas imágenes por segundo se muestran como mínimo, si el dispositivo puede.</translation>
    </message>
    <message>
        <source>Mirrored &amp;bone</source>
        <translation>H&amp;ueso reflejado</translation>
    </message>
    <message>
        <source>More about the image</source>
        <translation>Más sobre la imagen</translation>
    </message>
    <message>
        <source>Most used</source>
        <translation>Lo más usado</translation>
    </message>
    <message>
        <source>Mouse at rest</source>
        <translation>Ratón en reposo</translation>
    </message>
    <message>
        <source>Move an end of one of them.</source>
        <translation>Mueva un extremo de uno de ellos.</translation>
    </message>
    <message>
        <source>Move it into the scan.</source>
        <translation>Muévalo dentro del estudio.</translation>
    </message>
    <message>
        <source>Move it, or make it larger.</source>
        <translation>Muévala o hágala más grande.</translation>
    </message>
    <message>
        <source>Move its corners.</source>
        <translation>Mueva sus esquinas.</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Mover la vista</translation>
    </message>
    <message>
        <source>Muscle is hardly shown. The patient can be recognised.</source>
        <translation>El músculo apenas se ve. El paciente es reconocible.</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Músculos</translation>
    </message>
    <message>
        <source>Muscles and skull</source>
        <translation>Músculos y cráneo</translation>
    </message>
    <message>
        <source>My looks</source>
        <translation>Mis aspectos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name each node once.</source>
        <translation>Nombre cada equipo de render una sola vez.</translation>
    </message>
    <message>
        <source>Name not given</source>
        <translation>Nombre no indicado</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Next control</source>
        <translation>Control siguiente</translation>
    </message>
    <message>
        <source>No image</source>
        <translation>Sin imagen</translation>
    </message>
    <message>
        <source>No known systematic error</source>
        <translation>Sin error sistemático conocido</translation>
    </message>
    <message>
        <source>No page has all of these words.</source>
        <translation>Ninguna página contiene todas estas palabras.</translation>
    </message>
    <message>
        <source>No render nodes: other machines can render along, and the image becomes right sooner</source>
        <translation>Sin equipos de render: otros equipos pueden calcular también, y la imagen es correcta antes</translation>
    </message>
    <message>
        <source>No sample was left out</source>
        <translation>No se omitió ninguna muestra</translation>
    </message>
    <message>
        <source>No series here can be shown. The list says why.</source>
        <translation>Ninguna serie de aquí se puede mostrar. La lista dice por qué.</translation>
    </message>
    <message>
        <source>No table was hidden, because %1.</source>
        <translation>No se ocultó ninguna mesa, porque %1.</translation>
    </message>
    <message>
        <source>No tissue is in view</source>
        <translation>No hay tejido a la vista</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Not for diagnostic use</source>
        <translation>No apto para diagnóstico</translation>
    </message>
    <message>
        <source>Not for this scan</source>
        <translation>No para este estudio</translation>
    </message>
    <message>
        <source>Not in it: the scanner's own scale, movement, what was meant.</source>
        <translation>No incluye: la escala del propio escáner, el movimiento ni lo que se quería medir.</translation>
    </message>
    <message>
        <source>Not measured any further: %1</source>
        <translation>No se mide más: %1</translation>
    </message>
    <message>
        <source>Not offered: %1.</source>
        <translation>No se ofrece: %1.</translation>
    </message>
    <message>
        <source>Of 255 grey levels, by how many the image changes without it, on average over what it shows; to 95 % it lies between the two faint numbers</source>
        <translation>En cuántos de 255 niveles de gris cambia la imagen sin él, en promedio sobre lo que muestra; al 95 % está entre los dos números tenues</translation>
    </message>
    <message>
        <source>Of the image's samples, that it took: what it adds to the error curve</source>
        <translation>De las muestras de la imagen: lo que aporta a la curva de error</translation>
    </message>
    <message>
        <source>Of the whole image, that its samples come to</source>
        <translation>De la imagen entera, a las que equivalen sus muestras</translation>
    </message>
    <message>
        <source>Off, without any loss: %1</source>
        <translation>Desactivado, y no se pierde nada: %1</translation>
    </message>
    <message>
        <source>Offers the windows in which slices are shown: bone, lung, brain and others.</source>
        <translation>Ofrece las ventanas en que se muestran los cortes: hueso, pulmón, cerebro y otras.</translation>
    </message>
    <message>
        <source>On their other side %1.</source>
        <translation>Por el otro lado %1.</translation>
    </message>
    <message>
        <source>One large panel: soft shadows</source>
        <translation>Un panel grande: sombras suaves</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>Solo %1</translation>
    </message>
    <message>
        <source>Only %1 are shown.</source>
        <translation>Solo se muestran %1.</translation>
    </message>
    <message>
        <source>Only %1 without %2</source>
        <translation>Solo %1 sin %2</translation>
    </message>
    <message>
        <source>Only bones are shown, as far as they hold dense bone.</source>
        <translation>Solo se muestran huesos que contienen hueso denso.</translation>
    </message>
    <message>
        <source>Only the CPU or a newer GPU can render.</source>
        <translation>Solo la CPU o una GPU más nueva puede calcular.</translation>
    </message>
    <message>
        <source>Only the first of the dropped folders is opened.</source>
        <translation>Solo se abre la primera de las carpetas soltadas.</translation>
    </message>
    <message>
        <source>Only the lungs are shown; %1 mm at the pleura are missing.</source>
        <translation>Solo se muestran los pulmones; faltan %1 mm junto a la pleura.</translation>
    </message>
    <message>
        <source>Only what a label map marks is shown, in its colours; a part ends where its labels end.</source>
        <translation>Solo se muestra lo que marca un mapa de etiquetas, en sus colores; una parte termina donde terminan sus etiquetas.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Opacity: how much light is taken from a ray, per mm
Reflection: of a surface, seen straight on
Roughness: 0 is a mirror, 1 is dull
Glow: light that the tissue gives off itself</source>
        <translation>Opacidad: cuánta luz se quita a un rayo, por mm
Reflexión: de una superficie vista de frente
Rugosidad: 0 es un espejo, 1 es mate
Brillo propio: luz que emite el propio tejido</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message>
        <source>Open &amp;label map...</source>
        <translation>Abrir &amp;etiquetas...</translation>
    </message>
    <message>
        <source>Open &amp;plan...</source>
        <translation>Abrir &amp;plan...</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Open a CT scan for that.</source>
        <translation>Abra para ello un estudio de TC.</translation>
    </message>
    <message>
        <source>Open a folder</source>
        <translation>Abrir una carpeta</translation>
    </message>
    <message>
        <source>Open a folder with a CT</source>
        <translation>Abrir una carpeta con una TC</translation>
    </message>
    <message>
        <source>Open a folder with a CT series.</source>
        <translation>Abra una carpeta con una serie de TC.</translation>
    </message>
    <message>
        <source>Open a folder with a mask of each part</source>
        <translation>Abrir una carpeta con una máscara por parte</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>Abrir un mapa de etiquetas</translation>
    </message>
    <message>
        <source>Open a plan</source>
        <translation>Abrir un plan</translation>
    </message>
    <message>
        <source>Open a scan in one file</source>
        <translation>Abrir un estudio en un solo archivo</translation>
    </message>
    <message>
        <source>Open f&amp;ile...</source>
        <translation>Abrir arch&amp;ivo...</translation>
    </message>
    <message>
        <source>Open label map...</source>
        <translation>Abrir mapa de etiquetas...</translation>
    </message>
    <message>
        <source>Open the e&amp;xample</source>
        <translation>Abrir el e&amp;jemplo</translation>
    </message>
    <message>
        <source>Open the example</source>
        <translation>Abrir el ejemplo</translation>
    </message>
    <message>
        <source>Open the folder again.</source>
        <translation>Abra de nuevo la carpeta.</translation>
    </message>
    <message>
        <source>Open the folder again: it may hold another patient's images now.</source>
        <translation>Abra la carpeta de nuevo: puede contener ahora imágenes de otro paciente.</translation>
    </message>
    <message>
        <source>Open the folder of the scan first, then drop the plan again.</source>
        <translation>Abra primero la carpeta del estudio y vuelva a soltar el plan.</translation>
    </message>
    <message>
        <source>Open the series again, or restart the program.</source>
        <translation>Abra de nuevo la serie o reinicie el programa.</translation>
    </message>
    <message>
        <source>Open the series again.</source>
        <translation>Abra de nuevo la serie.</translation>
    </message>
    <message>
        <source>Open the series on which the plan was made.</source>
        <translation>Abra la serie sobre la que se hizo el plan.</translation>
    </message>
    <message>
        <source>OpenEXR with the error of every pixel (*.exr)</source>
        <translation>OpenEXR con el error de cada píxel (*.exr)</translation>
    </message>
    <message>
        <source>Opens a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage.</source>
        <translation>Abre un archivo ZIP con archivos DICOM o de volumen, o un solo volumen: NIfTI, NRRD o MetaImage.</translation>
    </message>
    <message>
        <source>Opens a folder of DICOM files.</source>
        <translation>Abre una carpeta con archivos DICOM.</translation>
    </message>
    <message>
        <source>Opens a folder with a file of this kind for each part.</source>
        <translation>Abre una carpeta con un archivo de este tipo por parte.</translation>
    </message>
    <message>
        <source>Opens parts that another program has marked on this scan: NIfTI, NRRD, MetaImage or a DICOM segmentation.</source>
        <translation>Abre partes que otro programa ha marcado en este estudio: NIfTI, NRRD, MetaImage o una segmentación DICOM.</translation>
    </message>
    <message>
        <source>Opens the manual, which needs no network.</source>
        <translation>Abre el manual (en inglés); no necesita red.</translation>
    </message>
    <message>
        <source>Opens what was set and measured on this scan before.</source>
        <translation>Abre lo que se ajustó y midió antes en este estudio.</translation>
    </message>
    <message>
        <source>Operating lamp</source>
        <translation>Lámpara de quirófano</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Órganos</translation>
    </message>
    <message>
        <source>Organs in colour</source>
        <translation>Órganos en color</translation>
    </message>
    <message>
        <source>Ours</source>
        <translation>El nuestro</translation>
    </message>
    <message>
        <source>PD-Render</source>
        <translation>PD-Render</translation>
    </message>
    <message>
        <source>PD-Render - Not for diagnostic use</source>
        <translation>PD-Render - No apto para diagnóstico</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>Imagen PNG (*.png)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Páginas del manual</translation>
    </message>
    <message>
        <source>Panels of light</source>
        <translation>Paneles de luz</translation>
    </message>
    <message>
        <source>Panels of one name are one lamp: they are moved and dimmed together</source>
        <translation>Los paneles de un mismo nombre son una lámpara: se mueven y atenúan juntos</translation>
    </message>
    <message>
        <source>Panorama, twice as wide as high (*.exr)</source>
        <translation>Panorama, el doble de ancho que de alto (*.exr)</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Paralela</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Part that is shown</source>
        <translation>Parte que se muestra</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Parts of the scan</source>
        <translation>Partes del estudio</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Paciente</translation>
    </message>
    <message>
        <source>Patient %1 (name hidden)</source>
        <translation>Paciente %1 (nombre oculto)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Pause or continue rendering (Space)</source>
        <translation>Detener el cálculo o continuarlo (Espacio)</translation>
    </message>
    <message>
        <source>Pause or resume the selected nodes (Space)</source>
        <translation>Pausar o reanudar los equipos elegidos (Espacio)</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Paused on battery (Space: continue)</source>
        <translation>En pausa con batería (Espacio: continuar)</translation>
    </message>
    <message>
        <source>Pauses rendering, or continues it, also beyond the target.</source>
        <translation>Detiene el cálculo o lo continúa, también más allá del objetivo.</translation>
    </message>
    <message>
        <source>Peeled %1 mm: skin and what lies less deep is not shown.</source>
        <translation>Pelado %1 mm: no se muestran la piel ni lo menos profundo.</translation>
    </message>
    <message>
        <source>Percentiles</source>
        <translation>Percentiles</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspectiva</translation>
    </message>
    <message>
        <source>Perspective: what is near is larger, as for the eye
Parallel: the same size at every depth, as for measuring</source>
        <translation>Perspectiva: lo cercano es mayor, como para el ojo
Paralela: el mismo tamaño a cualquier profundidad, como para medir</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Punto %1</translation>
    </message>
    <message>
        <source>Place of the selected point</source>
        <translation>Posición del punto elegido</translation>
    </message>
    <message>
        <source>Places of the lamps</source>
        <translation>Lugares de las lámparas</translation>
    </message>
    <message>
        <source>Plan saved as %1</source>
        <translation>Plan guardado como %1</translation>
    </message>
    <message>
        <source>Plan saved as %1, without its environment image</source>
        <translation>Plan guardado como %1, sin su imagen de entorno</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Planos</translation>
    </message>
    <message>
        <source>Plans (*.plan.json *.json)</source>
        <translation>Planes (*.plan.json *.json)</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Polygon %1</source>
        <translation>Polígono %1</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Ports are numbers from 1 to 65535.</source>
        <translation>Los puertos son números de 1 a 65535.</translation>
    </message>
    <message>
        <source>Preparing %1...</source>
        <translation>Preparando %1...</translation>
    </message>
    <message>
        <source>Preparing the GPU...</source>
        <translation>Preparando la GPU...</translation>
    </message>
    <message>
        <source>Preview, not converged · denoised, image error ±%1 of 255 grey levels (95 % of the tissue), target ±%2</source>
        <translation>Vista previa sin converger · sin ruido, error de la imagen ±%1 de 255 niveles de gris (95 % del tejido), objetivo ±%2</translation>
    </message>
    <message>
        <source>Preview, not converged · error not known yet</source>
        <translation>Vista previa sin converger · error aún desconocido</translation>
    </message>
    <message>
        <source>Preview, not converged · image error ±%1 of 255 grey levels (95 % of the tissue), target ±%2</source>
        <translation>Vista previa sin converger · error de la imagen ±%1 de 255 niveles de gris (95 % del tejido), objetivo ±%2</translation>
    </message>
    <message>
        <source>Preview, not converged · image error ±%1 of 255 grey levels before denoising (95 % of the tissue), target ±%2</source>
        <translation>Vista previa sin converger · error de la imagen ±%1 de 255 niveles de gris antes de la reducción de ruido (95 % del tejido), objetivo ±%2</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>Proyecció&amp;n</translation>
    </message>
    <message>
        <source>Processor time that an iteration of the small image takes more with it: median, and the smallest to the largest of six measurements</source>
        <translation>Tiempo de procesador que añade a una iteración de la imagen pequeña: mediana, y de la menor a la mayor de seis medidas</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Proyección</translation>
    </message>
    <message>
        <source>Put both files into one folder.</source>
        <translation>Ponga ambos archivos en una carpeta.</translation>
    </message>
    <message>
        <source>Put its ends farther apart.</source>
        <translation>Separe más sus extremos.</translation>
    </message>
    <message>
        <source>R&amp;eset view</source>
        <translation>R&amp;establecer la vista</translation>
    </message>
    <message>
        <source>Radiance</source>
        <translation>Radiancia</translation>
    </message>
    <message>
        <source>Radiance, in the units of the exposure</source>
        <translation>Radiancia, en las unidades de la exposición</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Recibido</translation>
    </message>
    <message>
        <source>Recent plans</source>
        <translation>Planes recientes</translation>
    </message>
    <message>
        <source>Recently opened</source>
        <translation>Abiertas recientemente</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo adding parts</source>
        <translation>Rehacer la adición de partes</translation>
    </message>
    <message>
        <source>Redo changing a measurement</source>
        <translation>Rehacer: cambiar una medición</translation>
    </message>
    <message>
        <source>Redo changing how a part is shown</source>
        <translation>Rehacer el cambio de aspecto de una parte</translation>
    </message>
    <message>
        <source>Redo changing the background</source>
        <translation>Rehacer: cambiar el fondo</translation>
    </message>
    <message>
        <source>Redo changing the brightness</source>
        <translation>Rehacer: cambiar el brillo</translation>
    </message>
    <message>
        <source>Redo changing the layout</source>
        <translation>Rehacer: cambiar la disposición</translation>
    </message>
    <message>
        <source>Redo changing the lens</source>
        <translation>Rehacer: cambiar la lente</translation>
    </message>
    <message>
        <source>Redo changing the light</source>
        <translation>Rehacer: cambiar la luz</translation>
    </message>
    <message>
        <source>Redo changing the rendering</source>
        <translation>Rehacer: cambiar el cálculo</translation>
    </message>
    <message>
        <source>Redo changing the window</source>
        <translation>Rehacer: cambiar la ventana</translation>
    </message>
    <message>
        <source>Redo choosing a look</source>
        <translation>Rehacer: elegir un aspecto</translation>
    </message>
    <message>
        <source>Redo choosing an optical model</source>
        <translation>Rehacer: elegir un modelo óptico</translation>
    </message>
    <message>
        <source>Redo choosing the visible part</source>
        <translation>Rehacer: elegir lo visible</translation>
    </message>
    <message>
        <source>Redo cutting</source>
        <translation>Rehacer: cortar</translation>
    </message>
    <message>
        <source>Redo editing the tissue</source>
        <translation>Rehacer: editar el tejido</translation>
    </message>
    <message>
        <source>Redo hiding the table</source>
        <translation>Rehacer: ocultar la mesa</translation>
    </message>
    <message>
        <source>Redo marking a place</source>
        <translation>Rehacer: marcar un punto</translation>
    </message>
    <message>
        <source>Redo measuring</source>
        <translation>Rehacer: medir</translation>
    </message>
    <message>
        <source>Redo moving the view</source>
        <translation>Rehacer: mover la vista</translation>
    </message>
    <message>
        <source>Redo moving through the slices</source>
        <translation>Rehacer: moverse por los cortes</translation>
    </message>
    <message>
        <source>Redo naming a measurement</source>
        <translation>Rehacer: nombrar una medición</translation>
    </message>
    <message>
        <source>Redo removing a measurement</source>
        <translation>Rehacer: quitar una medición</translation>
    </message>
    <message>
        <source>Redo removing parts</source>
        <translation>Rehacer la eliminación de las partes</translation>
    </message>
    <message>
        <source>Redo several changes</source>
        <translation>Rehacer: varios cambios</translation>
    </message>
    <message>
        <source>Redo showing the table</source>
        <translation>Rehacer: mostrar la mesa</translation>
    </message>
    <message>
        <source>Redo switching CT denoising</source>
        <translation>Rehacer: cambiar la reducción de ruido de la TC</translation>
    </message>
    <message>
        <source>Redo turning the view</source>
        <translation>Rehacer: girar la vista</translation>
    </message>
    <message>
        <source>Redo zooming</source>
        <translation>Rehacer: zoom</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>Refine a &amp;region</source>
        <translation>Primero una &amp;región</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>Reflexión</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Rechazado</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove all &amp;parts</source>
        <translation>Quitar todas las &amp;partes</translation>
    </message>
    <message>
        <source>Remove all c&amp;uts</source>
        <translation>&amp;Quitar todos los cortes</translation>
    </message>
    <message>
        <source>Remove image</source>
        <translation>Quitar imagen</translation>
    </message>
    <message>
        <source>Remove inside</source>
        <translation>Quitar el interior</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Quite uno de ellos.</translation>
    </message>
    <message>
        <source>Remove some of them.</source>
        <translation>Quite algunas.</translation>
    </message>
    <message>
        <source>Remove the last freehand cut</source>
        <translation>Quitar el último corte a mano alzada</translation>
    </message>
    <message>
        <source>Remove the last one</source>
        <translation>Quitar el último</translation>
    </message>
    <message>
        <source>Remove the plane</source>
        <translation>Quitar el plano</translation>
    </message>
    <message>
        <source>Remove the plane (double click on its handle)</source>
        <translation>Quita el plano (doble clic en su tirador)</translation>
    </message>
    <message>
        <source>Remove the selected points</source>
        <translation>Quitar los puntos elegidos</translation>
    </message>
    <message>
        <source>Remove the selected points (Del)</source>
        <translation>Quitar los puntos elegidos (Supr)</translation>
    </message>
    <message>
        <source>Remove the tissue inside the outline (Del)</source>
        <translation>Quitar el tejido dentro del contorno (Supr)</translation>
    </message>
    <message>
        <source>Removed tissue casts &amp;shadows</source>
        <translation>El tejido quitado proyecta s&amp;ombra</translation>
    </message>
    <message>
        <source>Removes all cuts; this can be undone.</source>
        <translation>Muestra todo lo cortado; un solo paso para deshacer.</translation>
    </message>
    <message>
        <source>Removes the selected measurement (Delete).</source>
        <translation>Quita la medición seleccionada (Supr).</translation>
    </message>
    <message>
        <source>Rename the look</source>
        <translation>Renombrar el aspecto</translation>
    </message>
    <message>
        <source>Render at the window's si&amp;ze</source>
        <translation>Renderizar al tamaño de la &amp;ventana</translation>
    </message>
    <message>
        <source>Render cost by effect</source>
        <translation>Coste por efecto</translation>
    </message>
    <message>
        <source>Render everything that render nodes send a second time, on another one or on this machine, before it is used: twice the work, and no false sample gets into the image</source>
        <translation>Calcular por segunda vez, en otro equipo o en este, todo lo que envían los equipos antes de usarlo: el doble de trabajo, y ningún valor falso llega a la imagen</translation>
    </message>
    <message>
        <source>Render node</source>
        <translation>Equipo de render</translation>
    </message>
    <message>
        <source>Render nodes</source>
        <translation>Equipos de render</translation>
    </message>
    <message>
        <source>Render nodes may dial in: "pdrender-node --coordinator" with this machine's name and this port.</source>
        <translation>Los equipos de render pueden llamar: «pdrender-node --coordinator» con el nombre de este equipo y este puerto.</translation>
    </message>
    <message>
        <source>Render on the CPU, or build it where the CUDA Toolkit is.</source>
        <translation>Calcule en la CPU o compile donde esté el CUDA Toolkit.</translation>
    </message>
    <message>
        <source>Render on the CPU.</source>
        <translation>Calcule en la CPU.</translation>
    </message>
    <message>
        <source>Rendered at %1</source>
        <translation>Calculada a %1</translation>
    </message>
    <message>
        <source>Rendered at another size</source>
        <translation>Calculada a otro tamaño</translation>
    </message>
    <message>
        <source>Rendered on</source>
        <translation>Calculada en</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Cálculo</translation>
    </message>
    <message>
        <source>Rendering cannot continue elsewhere: %1</source>
        <translation>La imagen tampoco puede seguir en otro lugar: %1</translation>
    </message>
    <message>
        <source>Rendering continues on %1.</source>
        <translation>La imagen sigue en: %1.</translation>
    </message>
    <message>
        <source>Rendering stops at %1. Drag left to stop sooner, right for a more accurate image.</source>
        <translation>El cálculo se detiene en %1. Arrastre a la izquierda para parar antes, a la derecha para más exactitud.</translation>
    </message>
    <message>
        <source>Renders the image again at the size at which it is shown; the next edit does so as well.</source>
        <translation>Empieza la imagen de nuevo con tantos píxeles como se muestran; el próximo cambio también lo hace.</translation>
    </message>
    <message>
        <source>Resample</source>
        <translation>Remuestrear</translation>
    </message>
    <message>
        <source>Resample it first.</source>
        <translation>Remuestréelo antes.</translation>
    </message>
    <message>
        <source>Reset the view</source>
        <translation>Restablecer la vista</translation>
    </message>
    <message>
        <source>Rest of the body</source>
        <translation>Resto del cuerpo</translation>
    </message>
    <message>
        <source>Restart the computer to use the GPU; if it happens again, have the GPU replaced.</source>
        <translation>Reinicie el ordenador para usar la GPU; si vuelve a ocurrir, haga cambiar la GPU.</translation>
    </message>
    <message>
        <source>Restart the computer; until then only the CPU can render.</source>
        <translation>Reinicie el ordenador; hasta entonces solo puede calcular la CPU.</translation>
    </message>
    <message>
        <source>Returns to the page that was read before.</source>
        <translation>Vuelve a la página leída antes.</translation>
    </message>
    <message>
        <source>Returns to the view in which the series was opened.</source>
        <translation>Muestra al paciente como cuando se abrió la serie.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Clic derecho</translation>
    </message>
    <message>
        <source>Right°</source>
        <translation>Derecha°</translation>
    </message>
    <message>
        <source>Rotates the environment image about the patient's axis [degrees]</source>
        <translation>Gira la imagen de entorno alrededor del eje del paciente [grados]</translation>
    </message>
    <message>
        <source>Rotation of the environment image</source>
        <translation>Giro de la imagen de entorno</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Aproximada</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosidad</translation>
    </message>
    <message>
        <source>SD %1 %7, median %2 %7, %3 to %4 %7, %5 voxels, %6 ml.</source>
        <translation>DE %1 %7, mediana %2 %7, de %3 a %4 %7, %5 vóxeles, %6 ml.</translation>
    </message>
    <message>
        <source>Sa&amp;ve plan...</source>
        <translation>Guardar p&amp;lan...</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Sagittal %1 of %2</source>
        <translation>Sagital %1 de %2</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Corte sagital</translation>
    </message>
    <message>
        <source>Sample CT (included)</source>
        <translation>TC de ejemplo (incluida)</translation>
    </message>
    <message>
        <source>Samples: %1</source>
        <translation>Muestras: %1</translation>
    </message>
    <message>
        <source>Save and share looks</source>
        <translation>Guardar y compartir aspectos</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>Save the look as it is now, rename and delete your own, share them as files</source>
        <translation>Guarde el aspecto actual, renombre y borre los suyos, compártalos como archivos</translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation>Guardar el plan</translation>
    </message>
    <message>
        <source>Save this look</source>
        <translation>Guardar este aspecto</translation>
    </message>
    <message>
        <source>Saved and copied images say which side is which, what they show, and that they are not for diagnostic use.</source>
        <translation>Las imágenes guardadas y copiadas dicen qué lado es cuál, qué muestran y que no son para diagnóstico.</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Guardada como %1</translation>
    </message>
    <message>
        <source>Saves the image as PNG or EXR, as shown or rendered at any size.</source>
        <translation>Guarda la imagen como PNG o EXR, tal como está o creada de nuevo en cualquier tamaño.</translation>
    </message>
    <message>
        <source>Saves what is set and measured, without the patient's name, for this scan alone.</source>
        <translation>Guarda lo ajustado y medido, sin el nombre del paciente, solo para este estudio.</translation>
    </message>
    <message>
        <source>Scans in one file (%1)</source>
        <translation>Estudios en un solo archivo (%1)</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Esquema</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Buscar en el manual</translation>
    </message>
    <message>
        <source>Seen from the feet %1.</source>
        <translation>Visto desde los pies %1.</translation>
    </message>
    <message>
        <source>Seen from the front %1.</source>
        <translation>Visto de frente %1.</translation>
    </message>
    <message>
        <source>Seen from the left %1.</source>
        <translation>Visto desde la izquierda %1.</translation>
    </message>
    <message>
        <source>Sending the scan, %1 %</source>
        <translation>Enviando el estudio, %1 %</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Enviado</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Series</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Set the &amp;crosshair</source>
        <translation>Colocar la &amp;cruz</translation>
    </message>
    <message>
        <source>Set the &amp;crosshair here</source>
        <translation>Colocar la &amp;cruz aquí</translation>
    </message>
    <message>
        <source>Seven small lamps in a ring above: their shadows overlap softly</source>
        <translation>Siete lámparas pequeñas en un anillo arriba: sus sombras se superponen suavemente</translation>
    </message>
    <message>
        <source>Several layers shine through each other here</source>
        <translation>Aquí se transparentan varias capas</translation>
    </message>
    <message>
        <source>Shape of the curve</source>
        <translation>Forma de la curva</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Shared out by cost</source>
        <translation>Repartido según el coste</translation>
    </message>
    <message>
        <source>Sharp from %1 before the focus on; it is %2 away.</source>
        <translation>Nítido desde %1 delante del foco; este está a %2.</translation>
    </message>
    <message>
        <source>Sharp from %1 before the focus to %2 behind it; it is %3 away.</source>
        <translation>Nítido desde %1 delante del foco hasta %2 detrás; este está a %3.</translation>
    </message>
    <message>
        <source>Shift the tissue's curve, widen it</source>
        <translation>Desplazar la curva del tejido, ensancharla</translation>
    </message>
    <message>
        <source>Shift+right drag on the image</source>
        <translation>Mayús+arrastrar con el derecho en la imagen</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>Mo&amp;strar</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Show &amp;this tissue</source>
        <translation>Mostrar este &amp;tejido</translation>
    </message>
    <message>
        <source>Show everything, or another part.</source>
        <translation>Muestre todo u otra parte.</translation>
    </message>
    <message>
        <source>Show it as it is.</source>
        <translation>Muéstrelo tal como es.</translation>
    </message>
    <message>
        <source>Show that slice</source>
        <translation>Mostrar ese corte</translation>
    </message>
    <message>
        <source>Show the tissue that is clicked</source>
        <translation>Mostrar el tejido en el que se haga clic</translation>
    </message>
    <message>
        <source>Show the tissue that is there</source>
        <translation>Mostrar el tejido que hay allí</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Shows all keys and what they do.</source>
        <translation>Muestra todas las teclas y lo que hacen.</translation>
    </message>
    <message>
        <source>Shows all of the message</source>
        <translation>Muestra todo el mensaje</translation>
    </message>
    <message>
        <source>Shows or closes the panels at the right of the image.</source>
        <translation>Muestra o cierra los paneles a la derecha de la imagen.</translation>
    </message>
    <message>
        <source>Shows or closes this panel.</source>
        <translation>Muestra o cierra este panel.</translation>
    </message>
    <message>
        <source>Shows or hides the buttons at the left of the image.</source>
        <translation>Muestra u oculta los botones a la izquierda de la imagen.</translation>
    </message>
    <message>
        <source>Shows or hides what is solid, outside the body and thinner than 20 mm.</source>
        <translation>Muestra u oculta lo que es sólido, está fuera del cuerpo y tiene menos de 20 mm de grosor.</translation>
    </message>
    <message>
        <source>Shows the CT with less noise than it has. Slices and measurements stay as they are.
It takes as much memory again as the voxels of the scan.</source>
        <translation>Muestra la TC con menos ruido del que tiene. Los cortes y las mediciones quedan como están.
Requiere otra vez tanta memoria como los vóxeles del estudio.</translation>
    </message>
    <message>
        <source>Shows the denoised or the raw image.</source>
        <translation>Muestra la imagen sin ruido o en bruto.</translation>
    </message>
    <message>
        <source>Shows the image alone, with slices beside it, or as one of four views.</source>
        <translation>Muestra la imagen sola, con cortes a su lado o como una de cuatro vistas.</translation>
    </message>
    <message>
        <source>Shows the patient from this side, filling the view.</source>
        <translation>Muestra al paciente desde este lado, llenando la vista.</translation>
    </message>
    <message>
        <source>Shows the selected parts so thin that one sees through.</source>
        <translation>Muestra las partes elegidas tan tenues que se ve a través de ellas.</translation>
    </message>
    <message>
        <source>Shows the selected parts.</source>
        <translation>Muestra las partes elegidas.</translation>
    </message>
    <message>
        <source>Shows the version, the licence, and what this program is not for.</source>
        <translation>Dice la versión, la licencia y para qué no sirve este programa.</translation>
    </message>
    <message>
        <source>Shows which voxels are in which part; hidden parts stay grey.</source>
        <translation>Muestra qué vóxeles están en qué parte; las partes ocultas siguen grises.</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Tama&amp;ño</translation>
    </message>
    <message>
        <source>Side bar</source>
        <translation>Barra lateral</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>Sides and patient</source>
        <translation>Lados y paciente</translation>
    </message>
    <message>
        <source>Sides, look, body part, cut, scale and accuracy; or the patient as well. OpenEXR files carry none.</source>
        <translation>Lados, aspecto, parte, corte, escala y hasta dónde ha llegado la imagen; o también quién es el paciente. OpenEXR no lleva ninguna.</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>En silencio</translation>
    </message>
    <message>
        <source>Size of the chosen lamp</source>
        <translation>Tamaño de la lámpara elegida</translation>
    </message>
    <message>
        <source>Size of the image</source>
        <translation>Tamaño de la imagen</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Tamaño:</translation>
    </message>
    <message>
        <source>Sk&amp;y turned</source>
        <translation>Cie&amp;lo girado</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
    <message>
        <source>Skin (identifies the patient)</source>
        <translation>Piel (identifica al paciente)</translation>
    </message>
    <message>
        <source>Skin and fat are not shown. Vessels and muscle are found by rule or by another program: organs may be among the muscle, and vessels beside bone may be missing.</source>
        <translation>La piel y la grasa no se muestran. Los vasos y los músculos los encuentra una regla u otro programa: entre los músculos puede haber órganos, y pueden faltar vasos junto al hueso.</translation>
    </message>
    <message>
        <source>Skin over bone</source>
        <translation>Piel sobre hueso</translation>
    </message>
    <message>
        <source>Skin surface only. The patient can be recognised.</source>
        <translation>Solo la superficie de la piel. El paciente es reconocible.</translation>
    </message>
    <message>
        <source>Skull with a defect and its mirror</source>
        <translation>Cráneo con un defecto y su reflejo</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Cielo</translation>
    </message>
    <message>
        <source>Slice &amp;alone, or all views</source>
        <translation>Corte &amp;solo, o todas las vistas</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Slices &amp;beside the image</source>
        <translation>Cortes &amp;junto a la imagen</translation>
    </message>
    <message>
        <source>Small lamps throw hard shadows, large ones soft ones; the light stays as strong</source>
        <translation>Las lámparas pequeñas dan sombras duras, las grandes suaves; la luz conserva su intensidad</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Tejidos blandos</translation>
    </message>
    <message>
        <source>Soft tissue is not shown, and bone below 230 HU is faint.</source>
        <translation>No se ven los tejidos blandos, y el hueso por debajo de 230 HU apenas.</translation>
    </message>
    <message>
        <source>Soft tissue is not shown. Cartilage with calcium looks like bone.</source>
        <translation>No se ven los tejidos blandos. El cartílago calcificado parece hueso.</translation>
    </message>
    <message>
        <source>Start the program again to use the GPU, with a smaller image, or use one that has no display.</source>
        <translation>Inicie de nuevo el programa para usar la GPU, con una imagen más pequeña, o use una GPU sin pantalla.</translation>
    </message>
    <message>
        <source>Start the program again to use the GPU; if it is lost again, install a newer driver or restart the computer.</source>
        <translation>Inicie de nuevo el programa para usar la GPU; si vuelve a perderse, instale un controlador más nuevo o reinicie el ordenador.</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Still being separated; everything is shown until then.</source>
        <translation>Aún se separa; hasta entonces se muestra todo.</translation>
    </message>
    <message>
        <source>Stop after this many seconds of rendering</source>
        <translation>Detener tras tantos segundos de cálculo</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Parar en</translation>
    </message>
    <message>
        <source>Stop sooner, or more accurate</source>
        <translation>Parar antes, o más exacto</translation>
    </message>
    <message>
        <source>Stop when 95 % of the tissue is within this many grey levels</source>
        <translation>Detener cuando el 95 % del tejido esté dentro de tantos niveles de gris</translation>
    </message>
    <message>
        <source>Stop when each pixel has this many samples</source>
        <translation>Detener cuando cada píxel tenga tantas muestras</translation>
    </message>
    <message>
        <source>Stren&amp;gth</source>
        <translation>I&amp;ntensidad</translation>
    </message>
    <message>
        <source>Strength of the chosen lamp</source>
        <translation>Intensidad de la lámpara elegida</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Study without a date</source>
        <translation>Estudio sin fecha</translation>
    </message>
    <message>
        <source>Systematic error</source>
        <translation>Error sistemático</translation>
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
        <translation>Mesa y soporte ocultos: %1 fuera del cuerpo.</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>Tabla para hojas de cálculo (*.csv)</translation>
    </message>
    <message>
        <source>Take a scan with contrast medium, or a label map of another program.</source>
        <translation>Tome un estudio con medio de contraste, o un mapa de etiquetas de otro programa.</translation>
    </message>
    <message>
        <source>Take absorption, singleScattering or multipleScattering, or leave the parts out.</source>
        <translation>Use absorption, singleScattering o multipleScattering, o deje fuera las partes.</translation>
    </message>
    <message>
        <source>Take the model singleScattering, or the estimator unbiased.</source>
        <translation>Elija el modelo singleScattering o el estimador unbiased.</translation>
    </message>
    <message>
        <source>Target accuracy of the image</source>
        <translation>Exactitud deseada de la imagen</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>Hueso temporal</translation>
    </message>
    <message>
        <source>The CPU renders the image for the file, since the GPU cannot: %1</source>
        <translation>La CPU calcula la imagen para el archivo, pues la GPU no puede: %1</translation>
    </message>
    <message>
        <source>The CPU renders, since the GPU cannot be used: %1</source>
        <translation>Calcula la CPU, pues la tarjeta gráfica no se puede usar: %1</translation>
    </message>
    <message>
        <source>The CPU renders, since the device chosen last cannot be used: %1</source>
        <translation>Calcula la CPU, pues el dispositivo elegido la última vez no se puede usar: %1</translation>
    </message>
    <message>
        <source>The GPU %1 renders, since the device chosen last cannot be used: %2</source>
        <translation>Calcula la GPU %1, pues el dispositivo elegido la última vez no se puede usar: %2</translation>
    </message>
    <message>
        <source>The HU that slices show at this place. One place has no ±: a ball has a mean with a ±.</source>
        <translation>El valor UH que muestran los cortes en este punto. Un solo punto no tiene ±: una esfera tiene una media con ±.</translation>
    </message>
    <message>
        <source>The chosen lamp</source>
        <translation>La lámpara elegida</translation>
    </message>
    <message>
        <source>The curve follows the values of this scan, which are no HU: what is dark in it is not shown.</source>
        <translation>La curva sigue los valores de este estudio, que no son UH: lo que es oscuro en él no se muestra.</translation>
    </message>
    <message>
        <source>The densest contrast looks like bone, and marrow looks like blood.</source>
        <translation>El contraste más denso parece hueso; la médula, sangre.</translation>
    </message>
    <message>
        <source>The densest tissue on each line of sight; not which of two lies in front.</source>
        <translation>El tejido más denso en cada línea de visión; no cuál de dos está delante.</translation>
    </message>
    <message>
        <source>The device that renders. Rendering continues there with the samples taken so far.</source>
        <translation>Lo que calcula la imagen. Continúa allí con las muestras que tiene.</translation>
    </message>
    <message>
        <source>The error is not known yet</source>
        <translation>El error aún no se conoce</translation>
    </message>
    <message>
        <source>The folder of this machine's certificates</source>
        <translation>La carpeta con los certificados de este equipo</translation>
    </message>
    <message>
        <source>The folder of this machine's certificates, which "pdrender-node --make-certificates" has made: with them nodes on other machines may be used.</source>
        <translation>La carpeta con los certificados de este equipo, creados con «pdrender-node --make-certificates»: con ellos se pueden usar otros equipos como equipos de render.</translation>
    </message>
    <message>
        <source>The histogram's height grows with the logarithm of the voxels</source>
        <translation>La altura del histograma crece con el logaritmo de los vóxeles</translation>
    </message>
    <message>
        <source>The image begins anew on %1, which filters the volume in another way.</source>
        <translation>La imagen empieza de nuevo, pues allí el volumen se filtra de otra manera: %1.</translation>
    </message>
    <message>
        <source>The image is in %1 instead.</source>
        <translation>La imagen está en %1 en su lugar.</translation>
    </message>
    <message>
        <source>The language changes after a restart</source>
        <translation>El idioma cambia tras reiniciar</translation>
    </message>
    <message>
        <source>The last one is cuda:%1.</source>
        <translation>La última es cuda:%1.</translation>
    </message>
    <message>
        <source>The list offers a series of even slices, interpolated between those measured.</source>
        <translation>La lista ofrece una serie de cortes uniformes, interpolados entre los medidos.</translation>
    </message>
    <message>
        <source>The lungs are not shown; %1 mm at the pleura remain.</source>
        <translation>No se muestran los pulmones; quedan %1 mm junto a la pleura.</translation>
    </message>
    <message>
        <source>The mirrored bone is the healthy side's and no plan of an implant. A defect in the middle, or on both sides, is not closed by it.</source>
        <translation>El hueso reflejado es el del lado sano y no un plan de implante. No cierra un defecto en el medio o en ambos lados.</translation>
    </message>
    <message>
        <source>The next click on the image moves the slices to what is seen there.</source>
        <translation>El próximo clic en la imagen lleva los cortes a lo que se ve allí.</translation>
    </message>
    <message>
        <source>The optical model of this look shows no parts.</source>
        <translation>El modelo óptico de este aspecto no muestra partes.</translation>
    </message>
    <message>
        <source>The outermost 5 mm and fat are not shown. The brain lies behind the skull.</source>
        <translation>No se ven los 5 mm exteriores ni la grasa. El cerebro queda detrás del cráneo.</translation>
    </message>
    <message>
        <source>The outermost 7 mm, fat and lung are not shown. Contrast looks like bone.</source>
        <translation>No se ven los 7 mm exteriores, la grasa ni el pulmón. El contraste parece hueso.</translation>
    </message>
    <message>
        <source>The part of an iteration's time that goes to it</source>
        <translation>La parte del tiempo de una iteración que se dedica a él</translation>
    </message>
    <message>
        <source>The part of the patient that is shown; the scan itself is not changed</source>
        <translation>La parte del paciente que se muestra; el estudio en sí no cambia</translation>
    </message>
    <message>
        <source>The patient's side that one looks at (%1)</source>
        <translation>El lado del paciente que se mira (%1)</translation>
    </message>
    <message>
        <source>The plan from %1 with %2, which was not saved, has been restored. Undo removes it again.</source>
        <translation>Se ha recuperado el plan del %1 con %2, que no estaba guardado. Deshacer lo quita de nuevo.</translation>
    </message>
    <message>
        <source>The region extends beyond the scan.</source>
        <translation>La región se extiende más allá del estudio.</translation>
    </message>
    <message>
        <source>The rendered volume. Arrow keys turn it, Shift and arrow keys move it, plus and minus zoom.</source>
        <translation>El volumen calculado. Las flechas lo giran, Mayús y flechas lo mueven, más y menos amplían y reducen.</translation>
    </message>
    <message>
        <source>The scanner measured nothing in %1 more.</source>
        <translation>En %1 más el escáner no midió nada.</translation>
    </message>
    <message>
        <source>The series was not read to its end; its slices are shown no longer.</source>
        <translation>La serie no se leyó hasta el final; sus cortes ya no se muestran.</translation>
    </message>
    <message>
        <source>The value that slices show at this place. One place has no ±: a ball has a mean with a ±.</source>
        <translation>El valor que muestran los cortes en este punto. Un solo punto no tiene ±: una esfera tiene una media con ±.</translation>
    </message>
    <message>
        <source>The values along the chosen distance, and beyond it. Dashed: its ends; dots: the half levels at which they lie. The pointer and the arrow keys read off values.</source>
        <translation>Los valores a lo largo de la distancia elegida y más allá. Líneas discontinuas: sus extremos; puntos: los niveles medios en que están. El puntero y las teclas de flecha leen valores.</translation>
    </message>
    <message>
        <source>The values of this scan are no HU: windows for tissues are not offered.</source>
        <translation>Los valores de este estudio no son UH: no se ofrecen ventanas para tejidos.</translation>
    </message>
    <message>
        <source>The view: each side is lit alike
The patient: the lamps stay where they are when the patient is turned</source>
        <translation>La vista: cada lado se ilumina igual
El paciente: las lámparas se quedan donde están cuando se gira al paciente</translation>
    </message>
    <message>
        <source>The ± is that of the noise. Not in it: the scanner's own scale, where the region was put.</source>
        <translation>El ± es el del ruido. No incluye: la escala del propio escáner ni dónde se puso la región.</translation>
    </message>
    <message>
        <source>Then click the anatomy that is to be sharp</source>
        <translation>Después haga clic en la anatomía que debe verse nítida</translation>
    </message>
    <message>
        <source>Then click the anatomy: a bell at its value is added (Ctrl and click does the same)</source>
        <translation>Después haga clic en la anatomía: se añade una campana en su valor (Ctrl y clic hace lo mismo)</translation>
    </message>
    <message>
        <source>Then save again.</source>
        <translation>Después guarde de nuevo.</translation>
    </message>
    <message>
        <source>Thi&amp;s tissue...</source>
        <translation>Este teji&amp;do...</translation>
    </message>
    <message>
        <source>Thickness removed</source>
        <translation>Grosor quitado</translation>
    </message>
    <message>
        <source>Thickness removed from the body surface, e.g. skin [mm]</source>
        <translation>Grosor que se quita de la superficie del cuerpo, p. ej. la piel [mm]</translation>
    </message>
    <message>
        <source>Thin bone</source>
        <translation>Hueso fino</translation>
    </message>
    <message>
        <source>This image cannot be rendered: %1</source>
        <translation>Esta imagen no se puede hacer: %1</translation>
    </message>
    <message>
        <source>This image shows skin: share it like a photograph of the patient.</source>
        <translation>Esta imagen muestra piel: compártala como una fotografía del paciente.</translation>
    </message>
    <message>
        <source>This look shows bone that one side has and the other lacks, which has not been looked for in this scan yet.</source>
        <translation>Este aspecto muestra hueso que un lado tiene y al otro le falta, que aún no se ha buscado en este estudio.</translation>
    </message>
    <message>
        <source>This look shows implants, which have not been found in this scan yet.</source>
        <translation>Este aspecto muestra implantes, que aún no se han encontrado en este estudio.</translation>
    </message>
    <message>
        <source>This look shows parts of a label map, and none with them is open.</source>
        <translation>Este aspecto muestra partes de un mapa de etiquetas, y no hay ninguno abierto que las tenga.</translation>
    </message>
    <message>
        <source>This look shows skin or muscle, which has not been found in this scan yet.</source>
        <translation>Este aspecto muestra piel o músculo, que aún no se han buscado en este estudio.</translation>
    </message>
    <message>
        <source>This look shows vessels, which have not been found in this scan yet.</source>
        <translation>Este aspecto muestra vasos, que aún no se han buscado en este estudio.</translation>
    </message>
    <message>
        <source>This pixel ±%1</source>
        <translation>Este píxel ±%1</translation>
    </message>
    <message>
        <source>This pixel ±%1; it is larger than 1 mm</source>
        <translation>Este píxel ±%1; es mayor que 1 mm</translation>
    </message>
    <message>
        <source>This pixel ±%1; mean over 1 mm not known yet</source>
        <translation>Este píxel ±%1; media en 1 mm aún desconocida</translation>
    </message>
    <message>
        <source>This pixel ±%1; mean over 1 mm ±%2</source>
        <translation>Este píxel ±%1; media en 1 mm ±%2</translation>
    </message>
    <message>
        <source>This pixel: not known yet</source>
        <translation>Este píxel: aún desconocido</translation>
    </message>
    <message>
        <source>This plan shows parts of a label map, of which it holds neither the voxels nor the place. Open that label map again, and its parts look as they did.</source>
        <translation>Este plan muestra partes de un mapa de etiquetas, del que no guarda ni los vóxeles ni el lugar. Abra de nuevo ese mapa de etiquetas y sus partes se verán como antes.</translation>
    </message>
    <message>
        <source>Three-point light</source>
        <translation>Luz de tres puntos</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>Tiles: %1</source>
        <translation>Teselas: %1</translation>
    </message>
    <message>
        <source>Tiles: each node renders a part of the image. Samples: each renders the whole image, a block of samples at a time, which is sooner where tiles would be too small.</source>
        <translation>Teselas: cada equipo de render calcula una parte de la imagen. Muestras: cada uno calcula la imagen entera, un bloque de muestras tras otro, lo que es más rápido donde las teselas serían demasiado pequeñas.</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tejido</translation>
    </message>
    <message>
        <source>Tissue in its own colours, without light or shadow.</source>
        <translation>Tejido con sus propios colores, sin luz ni sombra.</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Barra de herramientas</translation>
    </message>
    <message>
        <source>Total attenuation along the line of sight, as in a radiograph. Lamps have no effect.</source>
        <translation>Atenuación total a lo largo de la línea de visión, como en una radiografía. Las lámparas no influyen.</translation>
    </message>
    <message>
        <source>Translucent tissue (multiple scattering)</source>
        <translation>Tejido translúcido (dispersión múltiple)</translation>
    </message>
    <message>
        <source>Try OpenEXR (.exr).</source>
        <translation>Pruebe OpenEXR (.exr).</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Vuelva a intentarlo.</translation>
    </message>
    <message>
        <source>Try again; if it fails again, start the program again, or render on the CPU.</source>
        <translation>Inténtelo de nuevo; si vuelve a fallar, inicie de nuevo el programa o calcule en la CPU.</translation>
    </message>
    <message>
        <source>Turn off</source>
        <translation>Desactivar</translation>
    </message>
    <message>
        <source>Turn off effects that do not show</source>
        <translation>Desactivar efectos que no se ven</translation>
    </message>
    <message>
        <source>Turn the lights</source>
        <translation>Girar las luces</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Girar la vista</translation>
    </message>
    <message>
        <source>Turns off %1.</source>
        <translation>Desactiva %1.</translation>
    </message>
    <message>
        <source>Turns off the effects that nobody would see, and lists them first</source>
        <translation>Desactiva los efectos que nadie vería, y antes los enumera</translation>
    </message>
    <message>
        <source>Two lamps behind: bright outlines</source>
        <translation>Dos lámparas detrás: contornos brillantes</translation>
    </message>
    <message>
        <source>Two lines</source>
        <translation>Dos líneas</translation>
    </message>
    <message>
        <source>Two lines %1</source>
        <translation>Dos líneas %1</translation>
    </message>
    <message>
        <source>Type the address of a node first, such as gpu-07 or 10.0.0.7:%1.</source>
        <translation>Escriba primero la dirección de un equipo de render, como gpu-07 o 10.0.0.7:%1.</translation>
    </message>
    <message>
        <source>Typed places have no ±.</source>
        <translation>Los puntos escritos no tienen ±.</translation>
    </message>
    <message>
        <source>Unbiased</source>
        <translation>Insesgado</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo adding parts</source>
        <translation>Deshacer la adición de partes</translation>
    </message>
    <message>
        <source>Undo changing a measurement</source>
        <translation>Deshacer: cambiar una medición</translation>
    </message>
    <message>
        <source>Undo changing how a part is shown</source>
        <translation>Deshacer el cambio de aspecto de una parte</translation>
    </message>
    <message>
        <source>Undo changing the background</source>
        <translation>Deshacer: cambiar el fondo</translation>
    </message>
    <message>
        <source>Undo changing the brightness</source>
        <translation>Deshacer: cambiar el brillo</translation>
    </message>
    <message>
        <source>Undo changing the layout</source>
        <translation>Deshacer: cambiar la disposición</translation>
    </message>
    <message>
        <source>Undo changing the lens</source>
        <translation>Deshacer: cambiar la lente</translation>
    </message>
    <message>
        <source>Undo changing the light</source>
        <translation>Deshacer: cambiar la luz</translation>
    </message>
    <message>
        <source>Undo changing the rendering</source>
        <translation>Deshacer: cambiar el cálculo</translation>
    </message>
    <message>
        <source>Undo changing the window</source>
        <translation>Deshacer: cambiar la ventana</translation>
    </message>
    <message>
        <source>Undo choosing a look</source>
        <translation>Deshacer: elegir un aspecto</translation>
    </message>
    <message>
        <source>Undo choosing an optical model</source>
        <translation>Deshacer: elegir un modelo óptico</translation>
    </message>
    <message>
        <source>Undo choosing the visible part</source>
        <translation>Deshacer: elegir lo visible</translation>
    </message>
    <message>
        <source>Undo cutting</source>
        <translation>Deshacer: cortar</translation>
    </message>
    <message>
        <source>Undo editing the tissue</source>
        <translation>Deshacer: editar el tejido</translation>
    </message>
    <message>
        <source>Undo hiding the table</source>
        <translation>Deshacer: ocultar la mesa</translation>
    </message>
    <message>
        <source>Undo marking a place</source>
        <translation>Deshacer: marcar un punto</translation>
    </message>
    <message>
        <source>Undo measuring</source>
        <translation>Deshacer: medir</translation>
    </message>
    <message>
        <source>Undo moving the view</source>
        <translation>Deshacer: mover la vista</translation>
    </message>
    <message>
        <source>Undo moving through the slices</source>
        <translation>Deshacer: moverse por los cortes</translation>
    </message>
    <message>
        <source>Undo naming a measurement</source>
        <translation>Deshacer: nombrar una medición</translation>
    </message>
    <message>
        <source>Undo removing a measurement</source>
        <translation>Deshacer: quitar una medición</translation>
    </message>
    <message>
        <source>Undo removing parts</source>
        <translation>Deshacer la eliminación de las partes</translation>
    </message>
    <message>
        <source>Undo several changes</source>
        <translation>Deshacer: varios cambios</translation>
    </message>
    <message>
        <source>Undo showing the table</source>
        <translation>Deshacer: mostrar la mesa</translation>
    </message>
    <message>
        <source>Undo switching CT denoising</source>
        <translation>Deshacer: cambiar la reducción de ruido de la TC</translation>
    </message>
    <message>
        <source>Undo that side or plane of the cut</source>
        <translation>Deshacer ese lado o plano del corte</translation>
    </message>
    <message>
        <source>Undo turning the view</source>
        <translation>Deshacer: girar la vista</translation>
    </message>
    <message>
        <source>Undo zooming</source>
        <translation>Deshacer: zoom</translation>
    </message>
    <message>
        <source>Uniform ambient light instead, as bright</source>
        <translation>En su lugar, luz uniforme de todas partes, igual de intensa</translation>
    </message>
    <message>
        <source>Unlit tissue</source>
        <translation>Tejido sin iluminar</translation>
    </message>
    <message>
        <source>Unpack it with its password, and open the folder.</source>
        <translation>Descomprímalo con su contraseña y abra la carpeta.</translation>
    </message>
    <message>
        <source>Unpack it, and open the folder.</source>
        <translation>Descomprímalo y abra la carpeta.</translation>
    </message>
    <message>
        <source>Until this is fixed, unsaved work is lost if the program ends unexpectedly: save the plan yourself.</source>
        <translation>Hasta que se resuelva, lo no guardado se pierde si el programa termina de forma inesperada: guarde el plan usted mismo.</translation>
    </message>
    <message>
        <source>Until:</source>
        <translation>Hasta:</translation>
    </message>
    <message>
        <source>Up [degrees]</source>
        <translation>Hacia arriba [grados]</translation>
    </message>
    <message>
        <source>Up and down scroll by a slice, Page up and Page down by ten, digits choose a window. Shift with the arrows moves the crosshair, Enter clicks there.</source>
        <translation>Arriba y Abajo pasan un corte, Re Pág y Av Pág diez, las cifras eligen una ventana. Mayús con las flechas mueve la cruz, Intro hace clic allí.</translation>
    </message>
    <message>
        <source>Up°</source>
        <translation>Arriba°</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Valor del punto elegido</translation>
    </message>
    <message>
        <source>Values along the distance</source>
        <translation>Valores a lo largo de la distancia</translation>
    </message>
    <message>
        <source>Values that are no HU</source>
        <translation>Valores que no son UH</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Vasos</translation>
    </message>
    <message>
        <source>Vessels and bone</source>
        <translation>Vasos y hueso</translation>
    </message>
    <message>
        <source>Vessels are found by rule or by another program: beside bone they may be missing, and calcium may be among them.</source>
        <translation>Los vasos se encuentran por reglas o con otro programa: junto al hueso pueden faltar, y puede haber calcio entre ellos.</translation>
    </message>
    <message>
        <source>Vessels are found by rule or by another program: beside bone they may be missing, and calcium may be among them. Around them nothing can be judged.</source>
        <translation>Los vasos se encuentran por reglas o con otro programa: junto al hueso pueden faltar, y puede haber calcio entre ellos. A su alrededor no se puede juzgar nada.</translation>
    </message>
    <message>
        <source>Vessels in a ghost body</source>
        <translation>Vasos en un cuerpo fantasma</translation>
    </message>
    <message>
        <source>Vessels within 5 mm of the lung's surface are not shown; arteries, veins and walls of airways look alike.</source>
        <translation>No se ven los vasos a menos de 5 mm de la superficie del pulmón; arterias, venas y paredes bronquiales se ven iguales.</translation>
    </message>
    <message>
        <source>View from: %1</source>
        <translation>Vista desde: %1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Voxel size %1 × %2 × %3 mm</source>
        <translation>Tamaño de vóxel %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Voxel size of the scan</source>
        <translation>Tamaño de vóxel de la exploración</translation>
    </message>
    <message>
        <source>Wait for it, or cancel it.</source>
        <translation>Espere a que termine o cancélela.</translation>
    </message>
    <message>
        <source>Wait until the new image is there.</source>
        <translation>Espere a que esté la imagen que desea.</translation>
    </message>
    <message>
        <source>Wait until there is one.</source>
        <translation>Espere a que haya una.</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En espera</translation>
    </message>
    <message>
        <source>What can be done</source>
        <translation>Qué se puede hacer</translation>
    </message>
    <message>
        <source>What can be dropped on the window:</source>
        <translation>Qué se puede soltar en la ventana:</translation>
    </message>
    <message>
        <source>What could not be done</source>
        <translation>Lo que no se pudo hacer</translation>
    </message>
    <message>
        <source>What is sharp</source>
        <translation>Qué está nítido</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Qué se muestra</translation>
    </message>
    <message>
        <source>What is to be known of the parts</source>
        <translation>Lo que hay que saber de las partes</translation>
    </message>
    <message>
        <source>What is written over the image</source>
        <translation>Qué se escribe sobre la imagen</translation>
    </message>
    <message>
        <source>What it computes with</source>
        <translation>Con qué calcula</translation>
    </message>
    <message>
        <source>What it is doing. What a lost node had in hand is rendered by others</source>
        <translation>Qué está haciendo. Lo que un equipo de render perdido tenía entre manos lo calculan otros</translation>
    </message>
    <message>
        <source>What it shows and costs</source>
        <translation>Qué muestra y qué cuesta</translation>
    </message>
    <message>
        <source>What lies in front of the cut is not shown, nor is fat.</source>
        <translation>No se ve lo que está delante del corte, ni la grasa.</translation>
    </message>
    <message>
        <source>What lies in front of the cut is not shown, nor is fat. Very dense contrast looks like bone, marrow like blood.</source>
        <translation>No se ve lo que está delante del corte, ni la grasa. El contraste muy denso parece hueso; la médula, sangre.</translation>
    </message>
    <message>
        <source>What lights it</source>
        <translation>Lo que lo ilumina</translation>
    </message>
    <message>
        <source>What stands behind the volume. A plain colour lights nothing</source>
        <translation>Lo que hay detrás del volumen. Un color liso no ilumina nada</translation>
    </message>
    <message>
        <source>What the lamps move with</source>
        <translation>Con qué giran las lámparas</translation>
    </message>
    <message>
        <source>What this look does not show</source>
        <translation>Qué no muestra este aspecto</translation>
    </message>
    <message>
        <source>What went wrong with it, and was put right by others</source>
        <translation>Lo que falló en él y arreglaron otros</translation>
    </message>
    <message>
        <source>Wheel, right drag, + and -</source>
        <translation>Rueda, arrastrar con el derecho, + y -</translation>
    </message>
    <message>
        <source>Where a machine waits that is to render along: one on which "pdrender-node --listen" runs. Without a port it is %1.</source>
        <translation>Dónde espera un equipo que ha de calcular también: uno en el que se ejecuta «pdrender-node --listen». Sin puerto es %1.</translation>
    </message>
    <message>
        <source>Where the first selected point lies; the others move with it</source>
        <translation>Dónde está el primer punto elegido; los demás se mueven con él</translation>
    </message>
    <message>
        <source>Whether the tissue removed by box and planes still casts shadows</source>
        <translation>Si el tejido quitado por la caja y los planos sigue proyectando sombra</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Intervalo completo</translation>
    </message>
    <message>
        <source>Why this key cannot be used</source>
        <translation>Por qué no se puede usar esta tecla</translation>
    </message>
    <message>
        <source>Width of the image [pixels]</source>
        <translation>Ancho de la imagen [píxeles]</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Window %1 / %2 %3</source>
        <translation>Ventana %1 / %2 %3</translation>
    </message>
    <message>
        <source>Without certificates</source>
        <translation>Sin certificados</translation>
    </message>
    <message>
        <source>Without certificates connections are plain, and to this machine only</source>
        <translation>Sin certificados las conexiones no van cifradas y solo son posibles dentro de este equipo</translation>
    </message>
    <message>
        <source>Without certificates: only nodes on this machine</source>
        <translation>Sin certificados: solo programas en este equipo</translation>
    </message>
    <message>
        <source>Without it, it is not known who is shut out.</source>
        <translation>Sin ella no se sabe quién está excluido.</translation>
    </message>
    <message>
        <source>Write to another one.</source>
        <translation>Escriba en otro.</translation>
    </message>
    <message>
        <source>Writes the measurements for spreadsheets (CSV) or 3D Slicer, without the patient's name.</source>
        <translation>Escribe las mediciones para hojas de cálculo (CSV) o 3D Slicer, sin el nombre del paciente.</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Radiografía</translation>
    </message>
    <message>
        <source>X-rays of %1 kV</source>
        <translation>rayos X de %1 kV</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>a DICOM segmentation</source>
        <translation>una segmentación DICOM</translation>
    </message>
    <message>
        <source>a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage</source>
        <translation>un archivo ZIP con archivos DICOM o de volumen, o un solo volumen: NIfTI, NRRD o MetaImage</translation>
    </message>
    <message>
        <source>a box, a plane or a drawn line cuts into the volume</source>
        <translation>una caja, un plano o una línea dibujada corta el volumen</translation>
    </message>
    <message>
        <source>a built-in look has this name</source>
        <translation>un aspecto del programa tiene este nombre</translation>
    </message>
    <message>
        <source>a certificate cannot be made: %1</source>
        <translation>no se puede hacer un certificado: %1</translation>
    </message>
    <message>
        <source>a code table is missing</source>
        <translation>falta una tabla de códigos</translation>
    </message>
    <message>
        <source>a colour image (%1), not a CT slice</source>
        <translation>una imagen en color (%1), no un corte de TC</translation>
    </message>
    <message>
        <source>a content of the scene is not what the order says</source>
        <translation>un contenido de la escena no es lo que dice la orden</translation>
    </message>
    <message>
        <source>a damaged piece of a scan</source>
        <translation>un trozo dañado de un estudio</translation>
    </message>
    <message>
        <source>a file of this name is in the way</source>
        <translation>un archivo con este nombre estorba</translation>
    </message>
    <message>
        <source>a folder of DICOM files, or one of the files: its series are listed</source>
        <translation>una carpeta de archivos DICOM, o uno de ellos: se listan sus series</translation>
    </message>
    <message>
        <source>a frame took no time</source>
        <translation>una iteración no tardó nada</translation>
    </message>
    <message>
        <source>a key of its map is there twice, or out of its place</source>
        <translation>una clave de su tabla está repetida o fuera de lugar</translation>
    </message>
    <message>
        <source>a label map (%1)</source>
        <translation>un mapa de etiquetas (%1)</translation>
    </message>
    <message>
        <source>a light is a rectangle or a sphere</source>
        <translation>una luz es un rectángulo o una esfera</translation>
    </message>
    <message>
        <source>a line is too short to have a direction</source>
        <translation>una línea es demasiado corta para tener dirección</translation>
    </message>
    <message>
        <source>a list in it has another length</source>
        <translation>una lista en él tiene otra longitud</translation>
    </message>
    <message>
        <source>a localizer (scout view), not a CT slice</source>
        <translation>un localizador (topograma), no un corte de TC</translation>
    </message>
    <message>
        <source>a look needs a name</source>
        <translation>un aspecto necesita un nombre</translation>
    </message>
    <message>
        <source>a message of a kind that must be understood, but is not known here</source>
        <translation>un mensaje de un tipo que hay que entender, pero que aquí no se conoce</translation>
    </message>
    <message>
        <source>a message that was damaged on its way</source>
        <translation>un mensaje dañado por el camino</translation>
    </message>
    <message>
        <source>a number in it is none</source>
        <translation>un número en él no lo es</translation>
    </message>
    <message>
        <source>a number in it is out of its range</source>
        <translation>un número en él está fuera de su rango</translation>
    </message>
    <message>
        <source>a number in its header is not finite</source>
        <translation>un número de su cabecera no es finito</translation>
    </message>
    <message>
        <source>a part of the body has a material of its own</source>
        <translation>una parte del cuerpo tiene un material propio</translation>
    </message>
    <message>
        <source>a part of the body is not shown</source>
        <translation>una parte del cuerpo no se muestra</translation>
    </message>
    <message>
        <source>a path has at least two places</source>
        <translation>un recorrido tiene al menos dos lugares</translation>
    </message>
    <message>
        <source>a path may have one event only</source>
        <translation>un camino solo puede tener un evento</translation>
    </message>
    <message>
        <source>a piece of a scan that was not asked for</source>
        <translation>un trozo de un estudio que no se pidió</translation>
    </message>
    <message>
        <source>a plan (.plan.json), once its scan is open</source>
        <translation>un plan (.plan.json), una vez abierto su estudio</translation>
    </message>
    <message>
        <source>a plan holds %1 measurements at most</source>
        <translation>un plan contiene como máximo %1 mediciones</translation>
    </message>
    <message>
        <source>a plan needs its scan</source>
        <translation>un plan necesita su estudio</translation>
    </message>
    <message>
        <source>a point of the curve emits light</source>
        <translation>un punto de la curva emite luz</translation>
    </message>
    <message>
        <source>a point of the curve is specular</source>
        <translation>un punto de la curva es especular</translation>
    </message>
    <message>
        <source>a polygon has %1 corners at most</source>
        <translation>un polígono tiene como máximo %1 vértices</translation>
    </message>
    <message>
        <source>a render node joined</source>
        <translation>se unió un equipo de render</translation>
    </message>
    <message>
        <source>a render node was lost</source>
        <translation>se perdió un equipo de render</translation>
    </message>
    <message>
        <source>a rule of this program</source>
        <translation>una regla de este programa</translation>
    </message>
    <message>
        <source>a run of equal bytes is spelled out</source>
        <translation>una serie de bytes iguales está escrita entera</translation>
    </message>
    <message>
        <source>a run of it goes beyond its block</source>
        <translation>una serie sobrepasa su bloque</translation>
    </message>
    <message>
        <source>a run of zeros stands where tissue changes</source>
        <translation>hay una serie de ceros donde el tejido cambia</translation>
    </message>
    <message>
        <source>a scan of it does not fit its frame</source>
        <translation>una pasada no encaja en su marco</translation>
    </message>
    <message>
        <source>a scan that is not what it was said to be</source>
        <translation>un estudio que no es lo que se dijo</translation>
    </message>
    <message>
        <source>a segment of it ends before its last pixel</source>
        <translation>un segmento termina antes de su último píxel</translation>
    </message>
    <message>
        <source>a segment of it goes on behind its last pixel</source>
        <translation>un segmento sigue detrás de su último píxel</translation>
    </message>
    <message>
        <source>a sequence holds %1 where an item should begin</source>
        <translation>una secuencia contiene %1 donde debería empezar un elemento</translation>
    </message>
    <message>
        <source>a sequence of bytes is too short</source>
        <translation>una secuencia de bytes es demasiado corta</translation>
    </message>
    <message>
        <source>a single slice</source>
        <translation>un solo corte</translation>
    </message>
    <message>
        <source>a slice is missing</source>
        <translation>falta un corte</translation>
    </message>
    <message>
        <source>a slice lies %1 mm from an even grid; the slices are taken as even</source>
        <translation>un corte está a %1 mm de una cuadrícula uniforme; los cortes se toman como uniformes</translation>
    </message>
    <message>
        <source>a slice of more than 65535 pixels has no place in a DICOM file</source>
        <translation>un corte de más de 65535 píxeles no cabe en un archivo DICOM</translation>
    </message>
    <message>
        <source>a table gives its values (Modality LUT Sequence), which this version cannot read</source>
        <translation>una tabla da sus valores (Modality LUT Sequence), que esta versión no puede leer</translation>
    </message>
    <message>
        <source>a text in it is no line</source>
        <translation>un texto en él no es una línea</translation>
    </message>
    <message>
        <source>a text or a sequence of bytes in it is too long, or none</source>
        <translation>un texto o una secuencia de bytes en él es demasiado largo o falta</translation>
    </message>
    <message>
        <source>a tile keeps a render node busy for longer than it needs to start: %1, %2</source>
        <translation>una tesela ocupa a un equipo de render más tiempo del que necesita para empezar: %1, %2</translation>
    </message>
    <message>
        <source>a tile of it was not what this machine found when it did it again</source>
        <translation>una de sus teselas no era lo que este equipo halló al repetirla</translation>
    </message>
    <message>
        <source>a tile's result was refused: %1</source>
        <translation>se rechazó el resultado de una tesela: %1</translation>
    </message>
    <message>
        <source>about %1 to ±%2</source>
        <translation>unos %1 hasta ±%2</translation>
    </message>
    <message>
        <source>above %1 and at most %2</source>
        <translation>más de %1 y como máximo %2</translation>
    </message>
    <message>
        <source>above %1 and below %2</source>
        <translation>más de %1 y menos de %2</translation>
    </message>
    <message>
        <source>acquisition %1</source>
        <translation>adquisición %1</translation>
    </message>
    <message>
        <source>air</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>all lights are hidden from the camera</source>
        <translation>todas las luces están ocultas a la cámara</translation>
    </message>
    <message>
        <source>all parts are of the same material</source>
        <translation>todas las partes son del mismo material</translation>
    </message>
    <message>
        <source>an OpenEXR environment image, which then lights the scan</source>
        <translation>una imagen de entorno OpenEXR, que ilumina entonces el estudio</translation>
    </message>
    <message>
        <source>an area has at least three corners</source>
        <translation>un área tiene al menos tres esquinas</translation>
    </message>
    <message>
        <source>an earlier coding</source>
        <translation>una codificación anterior</translation>
    </message>
    <message>
        <source>an ellipse has two half axes</source>
        <translation>una elipse tiene dos semiejes</translation>
    </message>
    <message>
        <source>an image of %1 x %2 pixels needs %3 of memory, %4 are free</source>
        <translation>una imagen de %1 x %2 píxeles necesita %3 de memoria; hay %4 libres</translation>
    </message>
    <message>
        <source>an image was damaged on its way from the device</source>
        <translation>una imagen se rompió en el camino desde el dispositivo</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation><numerusform>y %n más</numerusform><numerusform>y %n más</numerusform></translation>
    </message>
    <message>
        <source>another image has taken its place</source>
        <translation>otra imagen ha ocupado su lugar</translation>
    </message>
    <message>
        <source>another image is being rendered</source>
        <translation>se está haciendo otra imagen</translation>
    </message>
    <message>
        <source>another program has the GPU to itself, or nobody may compute on it</source>
        <translation>otro programa tiene la GPU para él solo, o nadie puede calcular en ella</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>al menos %1</translation>
    </message>
    <message>
        <source>at least %1 % of the tissue not sampled yet</source>
        <translation>al menos el %1 % del tejido sin muestrear aún</translation>
    </message>
    <message>
        <source>at least %1 and below %2</source>
        <translation>al menos %1 y menos de %2</translation>
    </message>
    <message>
        <source>at least one node is needed</source>
        <translation>hace falta al menos un punto</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>como máximo %1</translation>
    </message>
    <message>
        <source>at most %1: thinner than this scan can tell</source>
        <translation>como máximo %1: más fino de lo que este estudio distingue</translation>
    </message>
    <message>
        <source>at this gradient factor no edge is ever steep enough</source>
        <translation>con este factor de gradiente ningún borde es lo bastante brusco</translation>
    </message>
    <message>
        <source>b %1</source>
        <translation>b %1</translation>
    </message>
    <message>
        <source>back</source>
        <translation>detrás</translation>
    </message>
    <message>
        <source>behind %1 mm of tissue</source>
        <translation>detrás de %1 mm de tejido</translation>
    </message>
    <message>
        <source>belongs to a volume of another size</source>
        <translation>es de un volumen de otro tamaño</translation>
    </message>
    <message>
        <source>beside the eye</source>
        <translation>junto al ojo</translation>
    </message>
    <message>
        <source>between its segments lie bytes that belong to none</source>
        <translation>entre sus segmentos hay bytes que no son de ninguno</translation>
    </message>
    <message>
        <source>biased</source>
        <translation>sesgado</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>desenfocado</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>hueso</translation>
    </message>
    <message>
        <source>bones</source>
        <translation>huesos</translation>
    </message>
    <message>
        <source>bones cannot be told from the rest</source>
        <translation>los huesos no se distinguen del resto</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>nac. %1</translation>
    </message>
    <message>
        <source>box of %1 x %2 x %3 mm</source>
        <translation>caja de %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>bytes are left over behind its last pixel</source>
        <translation>sobran bytes detrás de su último píxel</translation>
    </message>
    <message>
        <source>can be shown</source>
        <translation>se puede mostrar</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>recortada</translation>
    </message>
    <message>
        <source>clipping</source>
        <translation>corte</translation>
    </message>
    <message>
        <source>closing the previous series</source>
        <translation>se cierra la serie anterior</translation>
    </message>
    <message>
        <source>comparing slices at the same place</source>
        <translation>se comparan los cortes del mismo lugar</translation>
    </message>
    <message>
        <source>comparison: %1</source>
        <translation>comparación: %1</translation>
    </message>
    <message>
        <source>connections lost: %1</source>
        <translation>conexiones perdidas: %1</translation>
    </message>
    <message>
        <source>contrast</source>
        <translation>contraste</translation>
    </message>
    <message>
        <source>copies</source>
        <translation>copias</translation>
    </message>
    <message>
        <source>cut: %1</source>
        <translation>corte: %1</translation>
    </message>
    <message>
        <source>denoised: 95 % of the tissue within ±%1 levels, noise included</source>
        <translation>sin ruido: el 95 % del tejido dentro de ±%1 niveles, ruido incluido</translation>
    </message>
    <message>
        <source>denoised: how much is not known yet</source>
        <translation>sin ruido: aún no se sabe cuánto</translation>
    </message>
    <message>
        <source>denoising the scan</source>
        <translation>se reduce el ruido del estudio</translation>
    </message>
    <message>
        <source>depth of field</source>
        <translation>profundidad de campo</translation>
    </message>
    <message>
        <source>depth of light ±%1</source>
        <translation>profundidad de la luz ±%1</translation>
    </message>
    <message>
        <source>detail below %1 % contrast may be missing</source>
        <translation>pueden faltar detalles de menos del %1 % de contraste</translation>
    </message>
    <message>
        <source>directed scattering</source>
        <translation>dispersión dirigida</translation>
    </message>
    <message>
        <source>divided</source>
        <translation>dividida</translation>
    </message>
    <message>
        <source>duplicate slice position</source>
        <translation>posición de corte duplicada</translation>
    </message>
    <message>
        <source>each iteration blurred</source>
        <translation>cada iteración, desenfocada</translation>
    </message>
    <message>
        <source>echo %1</source>
        <translation>eco %1</translation>
    </message>
    <message>
        <source>edges ±%1</source>
        <translation>bordes ±%1</translation>
    </message>
    <message>
        <source>efficiency %1 %</source>
        <translation>rendimiento %1 %</translation>
    </message>
    <message>
        <source>element %1 has no length</source>
        <translation>el elemento %1 no tiene longitud</translation>
    </message>
    <message>
        <source>element %1 is longer than the file</source>
        <translation>el elemento %1 es más largo que el archivo</translation>
    </message>
    <message>
        <source>element %1 should hold %2 bytes, but only %3 are left in the file</source>
        <translation>el elemento %1 debería contener %2 bytes, pero en el archivo solo quedan %3</translation>
    </message>
    <message>
        <source>emission</source>
        <translation>emisión</translation>
    </message>
    <message>
        <source>ended before the first sample: nothing was written</source>
        <translation>terminó antes de la primera muestra: no se escribió nada</translation>
    </message>
    <message>
        <source>every light is best found by aiming at it</source>
        <translation>cada luz se encuentra mejor apuntando a ella</translation>
    </message>
    <message>
        <source>everything is shown</source>
        <translation>se muestra todo</translation>
    </message>
    <message>
        <source>fast filter</source>
        <translation>filtro rápido</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>grasa</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>file</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>fine detail may be missing</source>
        <translation>pueden faltar detalles finos</translation>
    </message>
    <message>
        <source>for %1 voxels (%2)</source>
        <translation>para %1 vóxeles (%2)</translation>
    </message>
    <message>
        <source>for highlights, which cannot show: could be left out</source>
        <translation>para brillos que no se pueden ver: se podría omitir</translation>
    </message>
    <message>
        <source>for images that come from the GPU</source>
        <translation>para las imágenes que vienen de la GPU</translation>
    </message>
    <message>
        <source>for its voxels (%1)</source>
        <translation>para sus vóxeles (%1)</translation>
    </message>
    <message>
        <source>for the scene</source>
        <translation>para la escena</translation>
    </message>
    <message>
        <source>for the scene: %1</source>
        <translation>para la escena: %1</translation>
    </message>
    <message>
        <source>for the scene: %1, since others use this render node, too</source>
        <translation>para la escena: %1, porque otros usan también este equipo de render</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>desde %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>from behind</source>
        <translation>desde detrás</translation>
    </message>
    <message>
        <source>front</source>
        <translation>delante</translation>
    </message>
    <message>
        <source>front and back</source>
        <translation>delante y detrás</translation>
    </message>
    <message>
        <source>ghost</source>
        <translation>fantasma</translation>
    </message>
    <message>
        <source>goes with a gradient only, not with an image</source>
        <translation>va solo con un degradado, no con una imagen</translation>
    </message>
    <message>
        <source>grid ±%1</source>
        <translation>rejilla ±%1</translation>
    </message>
    <message>
        <source>half of the bones lie more than %1 mm from their mirror image: this body is not symmetric</source>
        <translation>la mitad de los huesos está a más de %1 mm de su imagen reflejada: este cuerpo no es simétrico</translation>
    </message>
    <message>
        <source>hand ±%1</source>
        <translation>mano ±%1</translation>
    </message>
    <message>
        <source>has more than %1 holes</source>
        <translation>tiene más de %1 huecos</translation>
    </message>
    <message>
        <source>has more than %1 measurements</source>
        <translation>tiene más de %1 mediciones</translation>
    </message>
    <message>
        <source>has more than %1 styles</source>
        <translation>tiene más de %1 aspectos</translation>
    </message>
    <message>
        <source>has more than 1000 points</source>
        <translation>tiene más de 1000 puntos</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>no tiene puntos</translation>
    </message>
    <message>
        <source>has points that do not ascend</source>
        <translation>tiene puntos que no ascienden</translation>
    </message>
    <message>
        <source>head</source>
        <translation>cabeza</translation>
    </message>
    <message>
        <source>head and feet</source>
        <translation>cabeza y pies</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculta</translation>
    </message>
    <message>
        <source>hidden parts</source>
        <translation>partes ocultas</translation>
    </message>
    <message>
        <source>hiding the table</source>
        <translation>se oculta la mesa</translation>
    </message>
    <message>
        <source>highHu must lie above lowHu</source>
        <translation>highHu debe estar por encima de lowHu</translation>
    </message>
    <message>
        <source>highlights</source>
        <translation>brillos</translation>
    </message>
    <message>
        <source>highlights or directed scattering are sharper than the lights</source>
        <translation>los brillos o la dispersión dirigida son más nítidos que las luces</translation>
    </message>
    <message>
        <source>holds "%1", which is no number</source>
        <translation>contiene «%1», que no es un número</translation>
    </message>
    <message>
        <source>holds %1, each number must be %2</source>
        <translation>contiene %1; para cada número se admite: %2</translation>
    </message>
    <message>
        <source>holds more than %1 values</source>
        <translation>contiene más de %1 valores</translation>
    </message>
    <message>
        <source>holds points of %1 numbers, and one is not whole</source>
        <translation>contiene puntos de %1 números, y uno no está completo</translation>
    </message>
    <message>
        <source>holds too few numbers</source>
        <translation>contiene muy pocos números</translation>
    </message>
    <message>
        <source>host or host:port</source>
        <translation>equipo o equipo:puerto</translation>
    </message>
    <message>
        <source>how long it takes is not known yet</source>
        <translation>aún no se sabe cuánto tarda</translation>
    </message>
    <message>
        <source>how much is not known yet</source>
        <translation>aún no se sabe cuánto</translation>
    </message>
    <message>
        <source>implant</source>
        <translation>implante</translation>
    </message>
    <message>
        <source>implants are guessed by the density of metal: check them; fillings of teeth and undiluted medium may be among them</source>
        <translation>los implantes se suponen por la densidad del metal: compruébelos; entre ellos puede haber empastes y medio de contraste sin diluir</translation>
    </message>
    <message>
        <source>implants cannot be found, because %1</source>
        <translation>no se pueden encontrar implantes, porque %1</translation>
    </message>
    <message>
        <source>in at most %1 % of the tissue</source>
        <translation>en un %1 % del tejido como máximo</translation>
    </message>
    <message>
        <source>in the region ±%1 (95 % of the tissue)</source>
        <translation>en la región ±%1 (95 % del tejido)</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>incompleta</translation>
    </message>
    <message>
        <source>incomplete?</source>
        <translation>¿incompleta?</translation>
    </message>
    <message>
        <source>is "%1", must be "%2"</source>
        <translation>es «%1», debe ser «%2»</translation>
    </message>
    <message>
        <source>is %1, must be %2</source>
        <translation>es %1; se admite: %2</translation>
    </message>
    <message>
        <source>is %1, this program reads version 1</source>
        <translation>es %1, este programa lee la versión 1</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>is no JSON that can be read (%1)</source>
        <translation>no es JSON que se pueda leer (%1)</translation>
    </message>
    <message>
        <source>is no covariance: some direction has a negative variance</source>
        <translation>no es una covarianza: en alguna dirección la varianza es negativa</translation>
    </message>
    <message>
        <source>is no direction: it has no length</source>
        <translation>no es una dirección: no tiene longitud</translation>
    </message>
    <message>
        <source>is no direction: it needs three finite numbers</source>
        <translation>no es una dirección: necesita tres números finitos</translation>
    </message>
    <message>
        <source>is no direction: its length must be from 1e-100 to 1e+100</source>
        <translation>no es una dirección: su longitud debe ser de 1e-100 a 1e+100</translation>
    </message>
    <message>
        <source>is no field here</source>
        <translation>no es un campo aquí</translation>
    </message>
    <message>
        <source>is no unit vector</source>
        <translation>no es un vector unitario</translation>
    </message>
    <message>
        <source>is the id of two measurements</source>
        <translation>es el identificador de dos mediciones</translation>
    </message>
    <message>
        <source>is the name of two styles</source>
        <translation>es el nombre de dos aspectos</translation>
    </message>
    <message>
        <source>is the second environment, a scene has at most one</source>
        <translation>es el segundo entorno; una escena tiene uno como máximo</translation>
    </message>
    <message>
        <source>is too large a number</source>
        <translation>es un número demasiado grande</translation>
    </message>
    <message>
        <source>is too long for a volume property</source>
        <translation>es demasiado largo para una propiedad de volumen</translation>
    </message>
    <message>
        <source>is written twice in the same object</source>
        <translation>está escrito dos veces en el mismo objeto</translation>
    </message>
    <message>
        <source>it answered a lease that it was not given</source>
        <translation>respondió a un trabajo que no se le había dado</translation>
    </message>
    <message>
        <source>it cannot be unpacked (%1)</source>
        <translation>no se puede descomprimir (%1)</translation>
    </message>
    <message>
        <source>it does not begin as a JPEG image</source>
        <translation>no empieza como una imagen JPEG</translation>
    </message>
    <message>
        <source>it does not say how it lies in the patient</source>
        <translation>no dice cómo está situado en el paciente</translation>
    </message>
    <message>
        <source>it does not say how much memory it has, and is broken or lost</source>
        <translation>no dice cuánta memoria tiene, y está averiado o perdido</translation>
    </message>
    <message>
        <source>it does not say its modality</source>
        <translation>no indica su modalidad</translation>
    </message>
    <message>
        <source>it does not say plainly where its voxels begin</source>
        <translation>no dice con claridad dónde empiezan sus vóxeles</translation>
    </message>
    <message>
        <source>it does not say the order of its bytes</source>
        <translation>no dice el orden de sus bytes</translation>
    </message>
    <message>
        <source>it ends after its header</source>
        <translation>termina después de su cabecera</translation>
    </message>
    <message>
        <source>it ends before its last pixel</source>
        <translation>termina antes de su último píxel</translation>
    </message>
    <message>
        <source>it ends in the middle of an element</source>
        <translation>termina en medio de un elemento</translation>
    </message>
    <message>
        <source>it ends inside the compressed image</source>
        <translation>termina dentro de la imagen comprimida</translation>
    </message>
    <message>
        <source>it ends without its end marker</source>
        <translation>termina sin su marca final</translation>
    </message>
    <message>
        <source>it has more than %1 labels</source>
        <translation>tiene más de %1 etiquetas</translation>
    </message>
    <message>
        <source>it has not been heard of for 10 seconds</source>
        <translation>no se sabe nada de él desde hace 10 segundos</translation>
    </message>
    <message>
        <source>it has two frame headers</source>
        <translation>tiene dos cabeceras de imagen</translation>
    </message>
    <message>
        <source>it holds %1 frames in one file, and does not say where they lie</source>
        <translation>contiene %1 cuadros en un archivo y no dice dónde están</translation>
    </message>
    <message>
        <source>it holds %1 segments instead of %2</source>
        <translation>contiene %1 segmentos en vez de %2</translation>
    </message>
    <message>
        <source>it holds a marker where none belongs</source>
        <translation>contiene una marca donde no debe haberla</translation>
    </message>
    <message>
        <source>it holds a value that its samples cannot have</source>
        <translation>contiene un valor que sus muestras no pueden tener</translation>
    </message>
    <message>
        <source>it holds bits that are no code</source>
        <translation>contiene bits que no son ningún código</translation>
    </message>
    <message>
        <source>it holds fewer pixels than its size of %1 x %2 says</source>
        <translation>contiene menos píxeles de los que dice su tamaño de %1 x %2</translation>
    </message>
    <message>
        <source>it holds more restart markers than pixels</source>
        <translation>contiene más marcas de reinicio que píxeles</translation>
    </message>
    <message>
        <source>it holds more than %1 elements, items, fragments and values</source>
        <translation>contiene más de %1 elementos, ítems, fragmentos y valores</translation>
    </message>
    <message>
        <source>it holds no image</source>
        <translation>no contiene ninguna imagen</translation>
    </message>
    <message>
        <source>it holds no label map</source>
        <translation>no contiene ningún mapa de etiquetas</translation>
    </message>
    <message>
        <source>it holds no map</source>
        <translation>no contiene ninguna tabla</translation>
    </message>
    <message>
        <source>it holds pixels twice, as floating-point numbers and otherwise</source>
        <translation>contiene píxeles dos veces, como números de coma flotante y de otra forma</translation>
    </message>
    <message>
        <source>it holds several values for each place</source>
        <translation>contiene varios valores para cada lugar</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>es un enlace</translation>
    </message>
    <message>
        <source>it is an archive within the archive</source>
        <translation>es un archivo comprimido dentro del archivo</translation>
    </message>
    <message>
        <source>it is called as the slices beside it, but holds no DICOM</source>
        <translation>se llama como los cortes de al lado, pero no contiene DICOM</translation>
    </message>
    <message>
        <source>it is divided into more than %1 blocks</source>
        <translation>está dividida en más de %1 bloques</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>ya no está</translation>
    </message>
    <message>
        <source>it is longer than such a message is</source>
        <translation>es más largo de lo que es un mensaje así</translation>
    </message>
    <message>
        <source>it is no JPEG 2000 codestream</source>
        <translation>no es un flujo JPEG 2000</translation>
    </message>
    <message>
        <source>it is no grey image of at most 16 bits</source>
        <translation>no es una imagen en grises de 16 bits como máximo</translation>
    </message>
    <message>
        <source>it is no message of PD-Render's</source>
        <translation>no es un mensaje de PD-Render</translation>
    </message>
    <message>
        <source>it is not needed any more</source>
        <translation>ya no hace falta</translation>
    </message>
    <message>
        <source>it is not of the size that the file's header says</source>
        <translation>no tiene el tamaño que dice la cabecera del archivo</translation>
    </message>
    <message>
        <source>it is of another scene</source>
        <translation>es de otra escena</translation>
    </message>
    <message>
        <source>it is shorter than its header</source>
        <translation>es más corta que su cabecera</translation>
    </message>
    <message>
        <source>it is too long from somebody who is not known yet</source>
        <translation>es demasiado largo de alguien que aún no se conoce</translation>
    </message>
    <message>
        <source>it is too short for its %1 x %2 x %3 voxels</source>
        <translation>es demasiado corto para sus %1 x %2 x %3 vóxeles</translation>
    </message>
    <message>
        <source>it marks no voxel</source>
        <translation>no marca ningún vóxel</translation>
    </message>
    <message>
        <source>it said goodbye</source>
        <translation>se ha despedido</translation>
    </message>
    <message>
        <source>it sends results that nobody asked it for</source>
        <translation>envía resultados que nadie le ha pedido</translation>
    </message>
    <message>
        <source>it speaks another version of the protocol: %1</source>
        <translation>habla otra versión del protocolo: %1</translation>
    </message>
    <message>
        <source>it states %1 frames in one file; from 1 to %2 can be read</source>
        <translation>indica %1 cuadros en un archivo; se pueden leer de 1 a %2</translation>
    </message>
    <message>
        <source>it states %1 frames, and describes another number of them</source>
        <translation>indica %1 cuadros y describe otro número de ellos</translation>
    </message>
    <message>
        <source>it states an impossible precision</source>
        <translation>indica una precisión imposible</translation>
    </message>
    <message>
        <source>it states an impossible size of %1 x %2 pixels</source>
        <translation>indica un tamaño imposible de %1 x %2 píxeles</translation>
    </message>
    <message>
        <source>it states its lengths in an unknown unit</source>
        <translation>indica sus longitudes en una unidad desconocida</translation>
    </message>
    <message>
        <source>it states two places in the patient (sform and qform) that differ by up to %1 mm</source>
        <translation>indica dos posiciones en el paciente (sform y qform) que difieren hasta %1 mm</translation>
    </message>
    <message>
        <source>it unpacks to more than %1</source>
        <translation>descomprimido ocupa más de %1</translation>
    </message>
    <message>
        <source>its GPU has failed, and its CPU goes on: %1</source>
        <translation>su GPU ha fallado y sigue con su CPU: %1</translation>
    </message>
    <message>
        <source>its certificate has expired</source>
        <translation>su certificado ha caducado</translation>
    </message>
    <message>
        <source>its certificate is not believed: %1</source>
        <translation>no se acepta su certificado: %1</translation>
    </message>
    <message>
        <source>its certificate is not that of a %1</source>
        <translation>su certificado no es el de un %1</translation>
    </message>
    <message>
        <source>its certificate, %1, is revoked</source>
        <translation>su certificado, %1, está revocado</translation>
    </message>
    <message>
        <source>its compressed image is not made of fragments</source>
        <translation>su imagen comprimida no está hecha de fragmentos</translation>
    </message>
    <message>
        <source>its decoder says "%1"</source>
        <translation>su decodificador dice «%1»</translation>
    </message>
    <message>
        <source>its deflated content is damaged, or larger than %1 MB</source>
        <translation>su contenido comprimido está dañado o supera %1 MB</translation>
    </message>
    <message>
        <source>its frame header is too short</source>
        <translation>su cabecera de imagen es demasiado corta</translation>
    </message>
    <message>
        <source>its frames are not evenly spaced</source>
        <translation>sus imágenes no están a distancias iguales</translation>
    </message>
    <message>
        <source>its frames do not say where they lie in the patient</source>
        <translation>sus imágenes no dicen dónde están en el paciente</translation>
    </message>
    <message>
        <source>its frames lie in several directions, or their pixels differ in size</source>
        <translation>sus imágenes están en varias direcciones, o sus píxeles difieren en tamaño</translation>
    </message>
    <message>
        <source>its grid has %1 x %2 x %3 voxels</source>
        <translation>su rejilla tiene %1 x %2 x %3 vóxeles</translation>
    </message>
    <message>
        <source>its header cannot be read</source>
        <translation>no se puede leer su cabecera</translation>
    </message>
    <message>
        <source>its header has no end</source>
        <translation>su cabecera no tiene fin</translation>
    </message>
    <message>
        <source>its header is broken</source>
        <translation>su cabecera está dañada</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>su cabecera está dañada</translation>
    </message>
    <message>
        <source>its header places segments where none can be</source>
        <translation>su cabecera sitúa segmentos donde no puede haberlos</translation>
    </message>
    <message>
        <source>its header takes more than %1 MB</source>
        <translation>su cabecera ocupa más de %1 MB</translation>
    </message>
    <message>
        <source>its images differ from this machine's in the last bits: it runs a different build</source>
        <translation>sus imágenes difieren de las de este equipo en los últimos bits: su programa está compilado de otro modo</translation>
    </message>
    <message>
        <source>its label map is of another size</source>
        <translation>su mapa de etiquetas tiene otro tamaño</translation>
    </message>
    <message>
        <source>its map has keys that are no numbers, or too many</source>
        <translation>su tabla tiene claves que no son números, o demasiadas</translation>
    </message>
    <message>
        <source>its map is damaged, or too deep</source>
        <translation>su tabla está dañada o es demasiado profunda</translation>
    </message>
    <message>
        <source>its mask holds what is no weight</source>
        <translation>su máscara contiene lo que no es un peso</translation>
    </message>
    <message>
        <source>its mask is of another size</source>
        <translation>su máscara tiene otro tamaño</translation>
    </message>
    <message>
        <source>its memory is too small: %1 are needed at a time, %2 are free</source>
        <translation>su memoria es demasiado pequeña: se necesitan %1 a la vez y hay %2 libres</translation>
    </message>
    <message>
        <source>its messages are laid out in another way</source>
        <translation>sus mensajes están dispuestos de otro modo</translation>
    </message>
    <message>
        <source>its name leads out of the archive</source>
        <translation>su nombre lleva fuera del archivo</translation>
    </message>
    <message>
        <source>its packed part is damaged</source>
        <translation>su parte comprimida está dañada</translation>
    </message>
    <message>
        <source>its pixel format cannot be read (%1 bits allocated, %2 stored, high bit %3)</source>
        <translation>su formato de píxel no se puede leer (%1 bits asignados, %2 guardados, bit alto %3)</translation>
    </message>
    <message>
        <source>its pixels are coded as %1, which this version cannot read</source>
        <translation>sus píxeles están codificados como %1, que esta versión no puede leer</translation>
    </message>
    <message>
        <source>its pixels are no segments (%1 bits)</source>
        <translation>sus píxeles no son segmentos (%1 bits)</translation>
    </message>
    <message>
        <source>its rescale slope or intercept is no usable number</source>
        <translation>su pendiente u ordenada de reescalado no es un número utilizable</translation>
    </message>
    <message>
        <source>its restart markers are out of order</source>
        <translation>sus marcas de reinicio no están en orden</translation>
    </message>
    <message>
        <source>its samples are not the next ones</source>
        <translation>sus muestras no son las siguientes</translation>
    </message>
    <message>
        <source>its samples are there already</source>
        <translation>sus muestras ya están</translation>
    </message>
    <message>
        <source>its sequences are nested more than %1 deep</source>
        <translation>sus secuencias están anidadas en más de %1 niveles</translation>
    </message>
    <message>
        <source>its sums are none</source>
        <translation>sus sumas no lo son</translation>
    </message>
    <message>
        <source>its surroundings are of another size</source>
        <translation>su entorno tiene otro tamaño</translation>
    </message>
    <message>
        <source>its text is no UTF-8</source>
        <translation>su texto no es UTF-8</translation>
    </message>
    <message>
        <source>its value %1 is no label</source>
        <translation>su valor %1 no es una etiqueta</translation>
    </message>
    <message>
        <source>its values are no finite numbers</source>
        <translation>sus valores no son números finitos</translation>
    </message>
    <message>
        <source>its volume is of another size</source>
        <translation>su volumen tiene otro tamaño</translation>
    </message>
    <message>
        <source>its voxels are of a type that is not read</source>
        <translation>sus vóxeles son de un tipo que no se lee</translation>
    </message>
    <message>
        <source>its voxels are written in a coding that is not read (%1)</source>
        <translation>sus vóxeles están escritos en una codificación que no se lee (%1)</translation>
    </message>
    <message>
        <source>its voxels lie in several files, or outside its folder</source>
        <translation>sus vóxeles están en varios archivos, o fuera de su carpeta</translation>
    </message>
    <message>
        <source>kroesMarch knows one event on a path, but the model is %1</source>
        <translation>kroesMarch conoce un suceso por camino, pero el modelo es %1</translation>
    </message>
    <message>
        <source>label maps are written to files that end in %1</source>
        <translation>los mapas de etiquetas se escriben en archivos que terminan en %1</translation>
    </message>
    <message>
        <source>labels must ascend from 1 on</source>
        <translation>las etiquetas deben ir en orden creciente desde 1</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>izquierda y derecha</translation>
    </message>
    <message>
        <source>left and right, and front and back,</source>
        <translation>izquierda y derecha, y delante y detrás,</translation>
    </message>
    <message>
        <source>less than 1 ml</source>
        <translation>menos de 1 ml</translation>
    </message>
    <message>
        <source>light comes from all around</source>
        <translation>llega luz de todos los lados</translation>
    </message>
    <message>
        <source>light crosses tissue on its way</source>
        <translation>la luz atraviesa tejido en su camino</translation>
    </message>
    <message>
        <source>light from all around</source>
        <translation>luz de todos los lados</translation>
    </message>
    <message>
        <source>light is let through everything, to see what shadows do</source>
        <translation>la luz lo atraviesa todo, para ver qué hacen las sombras</translation>
    </message>
    <message>
        <source>light is scattered on from event to event</source>
        <translation>la luz se sigue dispersando de evento en evento</translation>
    </message>
    <message>
        <source>light paths cut off at their last allowed event</source>
        <translation>caminos de luz cortados en su último suceso permitido</translation>
    </message>
    <message>
        <source>lights in view</source>
        <translation>luces a la vista</translation>
    </message>
    <message>
        <source>lights with a place</source>
        <translation>luces con un lugar</translation>
    </message>
    <message>
        <source>lists and objects lie in one another deeper than %1</source>
        <translation>listas y objetos están anidados en más de %1 niveles</translation>
    </message>
    <message>
        <source>looking for files</source>
        <translation>se buscan archivos</translation>
    </message>
    <message>
        <source>looking for metal</source>
        <translation>buscando metal</translation>
    </message>
    <message>
        <source>looking for the table</source>
        <translation>se busca la mesa</translation>
    </message>
    <message>
        <source>looking for vessels</source>
        <translation>buscando vasos</translation>
    </message>
    <message>
        <source>lossy</source>
        <translation>con pérdida</translation>
    </message>
    <message>
        <source>lossy?</source>
        <translation>¿con pérdida?</translation>
    </message>
    <message>
        <source>lung</source>
        <translation>pulmón</translation>
    </message>
    <message>
        <source>lungs are in this scan</source>
        <translation>hay pulmones en este estudio</translation>
    </message>
    <message>
        <source>march of 3 voxels</source>
        <translation>pasos de 3 vóxeles</translation>
    </message>
    <message>
        <source>materials of parts</source>
        <translation>materiales de partes</translation>
    </message>
    <message>
        <source>mean kept in single precision: %1</source>
        <translation>media guardada en precisión simple: %1</translation>
    </message>
    <message>
        <source>measurements are exported to files that end in .csv or .mrk.json</source>
        <translation>las mediciones se exportan a archivos que terminan en .csv o .mrk.json</translation>
    </message>
    <message>
        <source>measurements[%1].places[%2].mm lies %3 mm outside the scan</source>
        <translation>measurements[%1].places[%2].mm está %3 mm fuera del estudio</translation>
    </message>
    <message>
        <source>meetings with tissue above its bound</source>
        <translation>encuentros con tejido por encima de su cota</translation>
    </message>
    <message>
        <source>mended</source>
        <translation>corregida</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>metal</translation>
    </message>
    <message>
        <source>metal is in this body</source>
        <translation>hay metal en este cuerpo</translation>
    </message>
    <message>
        <source>mirrored bone</source>
        <translation>hueso reflejado</translation>
    </message>
    <message>
        <source>mirrored bone cannot be found, because %1</source>
        <translation>no se puede encontrar hueso reflejado, porque %1</translation>
    </message>
    <message>
        <source>mirrored bone is the other side's: half of the bones lie within %1 mm of their mirror image, nine tenths within %2 mm</source>
        <translation>el hueso reflejado es el del otro lado: la mitad de los huesos está a %1 mm como máximo de su imagen reflejada, nueve décimos a %2 mm</translation>
    </message>
    <message>
        <source>mirroring the bones</source>
        <translation>reflejando los huesos</translation>
    </message>
    <message>
        <source>missing position data</source>
        <translation>faltan datos de posición</translation>
    </message>
    <message>
        <source>mixed slice orientations</source>
        <translation>orientaciones de corte mezcladas</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>modality</source>
        <translation>modalidad</translation>
    </message>
    <message>
        <source>more than half of what is solid is thinner than 20 mm</source>
        <translation>más de la mitad de lo sólido tiene menos de 20 mm de grosor</translation>
    </message>
    <message>
        <source>ms per iteration</source>
        <translation>ms por iteración</translation>
    </message>
    <message>
        <source>multiple scattering</source>
        <translation>dispersión múltiple</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>músculo</translation>
    </message>
    <message>
        <source>muscle is guessed by its density, which organs and marrow may have, too</source>
        <translation>el músculo se supone por su densidad, que también pueden tener los órganos y la médula</translation>
    </message>
    <message>
        <source>must ascend from one to the next</source>
        <translation>debe ascender de uno al siguiente</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>debe ser un número finito</translation>
    </message>
    <message>
        <source>must be a list [ ... ]</source>
        <translation>debe ser una lista [ ... ]</translation>
    </message>
    <message>
        <source>must be a list of 1 to 64 panels</source>
        <translation>debe ser una lista de 1 a 64 paneles</translation>
    </message>
    <message>
        <source>must be a list of different texts in quotes</source>
        <translation>debe ser una lista de textos distintos entre comillas</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>debe ser un número</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>debe ser un texto entre comillas</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>debe ser un número entero</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to 18446744073709551615</source>
        <translation>debe ser un número entero de 0 a 18446744073709551615</translation>
    </message>
    <message>
        <source>must be an object { ... }</source>
        <translation>debe ser un objeto { ... }</translation>
    </message>
    <message>
        <source>must be of %1, with commas between, not "%2"</source>
        <translation>debe constar de %1, con comas entre ellos, no «%2»</translation>
    </message>
    <message>
        <source>must be one of: %1</source>
        <translation>debe ser uno de: %1</translation>
    </message>
    <message>
        <source>must be three whole numbers [x, y, z]</source>
        <translation>deben ser tres números enteros [x, y, z]</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>debe ser true o false</translation>
    </message>
    <message>
        <source>must be two whole numbers [lowest, highest]</source>
        <translation>deben ser dos números enteros [menor, mayor]</translation>
    </message>
    <message>
        <source>must begin with the lower value</source>
        <translation>debe empezar por el valor menor</translation>
    </message>
    <message>
        <source>must differ from eyeMm</source>
        <translation>debe ser distinto de eyeMm</translation>
    </message>
    <message>
        <source>must have %1 places</source>
        <translation>debe tener %1 lugares</translation>
    </message>
    <message>
        <source>must have %1 to %2 places</source>
        <translation>debe tener de %1 a %2 puntos</translation>
    </message>
    <message>
        <source>must have three points at least</source>
        <translation>debe tener al menos tres puntos</translation>
    </message>
    <message>
        <source>must lie above lowMm along every axis</source>
        <translation>debe estar por encima de lowMm en cada eje</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>no debe estar vacío</translation>
    </message>
    <message>
        <source>must not be longer than %1 bytes</source>
        <translation>no debe tener más de %1 bytes</translation>
    </message>
    <message>
        <source>must not lie along the view</source>
        <translation>no debe estar en la dirección de la vista</translation>
    </message>
    <message>
        <source>must not point along the normal</source>
        <translation>no debe apuntar a lo largo de la normal</translation>
    </message>
    <message>
        <source>needed, because</source>
        <translation>necesario porque</translation>
    </message>
    <message>
        <source>needs either a DICOM folder (dicom) or a raw file (raw)</source>
        <translation>necesita una carpeta DICOM (dicom) o un archivo en bruto (raw)</translation>
    </message>
    <message>
        <source>needs either a label map (labels) or a rule that finds parts (find)</source>
        <translation>necesita un mapa de etiquetas (labels) o una regla que encuentre partes (find)</translation>
    </message>
    <message>
        <source>neither this program nor the driver has code for the GPU (%1)</source>
        <translation>ni este programa ni el controlador tienen código para la GPU (%1)</translation>
    </message>
    <message>
        <source>no HU</source>
        <translation>sin HU</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>no bone of 1 ml that one side has is lacking on the other</source>
        <translation>a ningún lado le falta 1 ml de hueso que el otro tenga</translation>
    </message>
    <message>
        <source>no bones are in this scan</source>
        <translation>no hay huesos en este estudio</translation>
    </message>
    <message>
        <source>no contrast medium is found in the blood</source>
        <translation>no se encuentra medio de contraste en la sangre</translation>
    </message>
    <message>
        <source>no contrast was found in the blood</source>
        <translation>no se ha encontrado contraste en la sangre</translation>
    </message>
    <message>
        <source>no edge within %1 mm</source>
        <translation>ningún borde a menos de %1 mm</translation>
    </message>
    <message>
        <source>no edge: the scanner measured nothing on one side</source>
        <translation>ningún borde: a un lado el escáner no midió nada</translation>
    </message>
    <message>
        <source>no edge: the sides differ by less than five times the noise</source>
        <translation>ningún borde: los lados difieren en menos de cinco veces el ruido</translation>
    </message>
    <message>
        <source>no edge: too close to the border of the scan</source>
        <translation>ningún borde: demasiado cerca del límite del estudio</translation>
    </message>
    <message>
        <source>no edge: too few voxels on either side to know the noise</source>
        <translation>ningún borde: muy pocos vóxeles a ambos lados para conocer el ruido</translation>
    </message>
    <message>
        <source>no image, but %1</source>
        <translation>no es una imagen, sino %1</translation>
    </message>
    <message>
        <source>no image, but another kind of object</source>
        <translation>no es una imagen, sino otro tipo de objeto</translation>
    </message>
    <message>
        <source>no light is a rectangle or a sphere</source>
        <translation>ninguna luz es un rectángulo o una esfera</translation>
    </message>
    <message>
        <source>no light shines</source>
        <translation>ninguna luz alumbra</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin tope</translation>
    </message>
    <message>
        <source>no lungs are in this scan</source>
        <translation>no hay pulmones en este estudio</translation>
    </message>
    <message>
        <source>no metal is in this body</source>
        <translation>no hay metal en este cuerpo</translation>
    </message>
    <message>
        <source>no opaque tissue that the volume holds emits light</source>
        <translation>ningún tejido opaco del volumen emite luz</translation>
    </message>
    <message>
        <source>no part of the body has a material of its own</source>
        <translation>ninguna parte del cuerpo tiene un material propio</translation>
    </message>
    <message>
        <source>no point of the curve emits light</source>
        <translation>ningún punto de la curva emite luz</translation>
    </message>
    <message>
        <source>no point of the curve is specular</source>
        <translation>ningún punto de la curva es especular</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>sin motivo indicado</translation>
    </message>
    <message>
        <source>no rectangle and no sphere shines</source>
        <translation>no alumbra ningún rectángulo ni ninguna esfera</translation>
    </message>
    <message>
        <source>no series here can be loaded</source>
        <translation>aquí no se puede cargar ninguna serie</translation>
    </message>
    <message>
        <source>no series here can be loaded: %1</source>
        <translation>aquí no se puede cargar ninguna serie: %1</translation>
    </message>
    <message>
        <source>no such tile is asked for</source>
        <translation>no se pide esa tesela</translation>
    </message>
    <message>
        <source>no tissue at this point: %1 % of the light passes</source>
        <translation>no hay tejido en este punto: pasa el %1 % de la luz</translation>
    </message>
    <message>
        <source>no tissue in the region</source>
        <translation>no hay tejido en la región</translation>
    </message>
    <message>
        <source>no tissue is opaque at the values that the volume holds</source>
        <translation>ningún tejido es opaco en los valores del volumen</translation>
    </message>
    <message>
        <source>no tissue scatters light</source>
        <translation>ningún tejido dispersa luz</translation>
    </message>
    <message>
        <source>no voxel's centre lies in this region</source>
        <translation>en esta región no está el centro de ningún vóxel</translation>
    </message>
    <message>
        <source>nobody can be listened to there: %1</source>
        <translation>no se puede escuchar ahí: %1</translation>
    </message>
    <message>
        <source>none of the %1 files is a DICOM image</source>
        <translation>ninguno de los %1 archivos es una imagen DICOM</translation>
    </message>
    <message>
        <source>not a CT volume</source>
        <translation>no es un volumen de TC</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>not known without the scan</source>
        <translation>no se conoce sin el estudio</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>aún no se conoce</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>aún no leído</translation>
    </message>
    <message>
        <source>not saved, because %1</source>
        <translation>no se ha guardado, porque %1</translation>
    </message>
    <message>
        <source>not shown here</source>
        <translation>no se muestra aquí</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
    </message>
    <message>
        <source>nothing can be peeled off</source>
        <translation>no se puede pelar nada</translation>
    </message>
    <message>
        <source>nothing in the scan is as dense as bone</source>
        <translation>nada en el estudio es tan denso como el hueso</translation>
    </message>
    <message>
        <source>nothing is as thick as 20 mm</source>
        <translation>nada alcanza 20 mm de grosor</translation>
    </message>
    <message>
        <source>nothing is cut away</source>
        <translation>no se ha cortado nada</translation>
    </message>
    <message>
        <source>nothing says where each of its %1 compressed frames begins</source>
        <translation>nada dice dónde empieza cada uno de sus %1 cuadros comprimidos</translation>
    </message>
    <message>
        <source>now, %1</source>
        <translation>ahora, %1</translation>
    </message>
    <message>
        <source>number %1 in the line, since others use this render node</source>
        <translation>número %1 en la cola, porque otros usan este equipo de render</translation>
    </message>
    <message>
        <source>on an image of %1 × %2 pixels on the CPU (%3)</source>
        <translation>en una imagen de %1 × %2 píxeles en la CPU (%3)</translation>
    </message>
    <message>
        <source>one more event</source>
        <translation>un evento más</translation>
    </message>
    <message>
        <source>one of its code tables has more codes than there can be</source>
        <translation>una de sus tablas de códigos tiene más códigos de los posibles</translation>
    </message>
    <message>
        <source>one of its code tables is cut off</source>
        <translation>una de sus tablas de códigos está cortada</translation>
    </message>
    <message>
        <source>one of its quantisation tables is cut off</source>
        <translation>una de sus tablas de cuantización está cortada</translation>
    </message>
    <message>
        <source>one of its segments is longer than the image</source>
        <translation>uno de sus segmentos es más largo que la imagen</translation>
    </message>
    <message>
        <source>one render node has the whole image</source>
        <translation>un equipo de render tiene la imagen entera</translation>
    </message>
    <message>
        <source>only %1 % of the light here stops at one depth, which was taken</source>
        <translation>solo el %1 % de la luz se detiene aquí a una misma profundidad, la elegida</translation>
    </message>
    <message>
        <source>only values in HU can be denoised, and those of this scan are none</source>
        <translation>solo se puede reducir el ruido de valores en HU, y los de este estudio no lo son</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>orientación</translation>
    </message>
    <message>
        <source>other machines are only talked to with certificates</source>
        <translation>con otros equipos solo se habla con certificados</translation>
    </message>
    <message>
        <source>others on this machine may read or change this key</source>
        <translation>otros en este equipo pueden leer o cambiar esta clave</translation>
    </message>
    <message>
        <source>outside the scan</source>
        <translation>fuera del estudio</translation>
    </message>
    <message>
        <source>part %1 of %2 is missing of an image that is stored in several files (a concatenation)</source>
        <translation>falta la parte %1 de %2 de una imagen guardada en varios archivos (una concatenación)</translation>
    </message>
    <message>
        <source>parts of the driver are of different versions: it was updated while the computer ran</source>
        <translation>hay partes del controlador de versiones distintas: se actualizó con el ordenador en marcha</translation>
    </message>
    <message>
        <source>parts that have a name and no voxels: %1</source>
        <translation>partes que tienen nombre y ningún vóxel: %1</translation>
    </message>
    <message>
        <source>paths have %1 events</source>
        <translation>los caminos tienen %1 eventos</translation>
    </message>
    <message>
        <source>paths have as many events as they need</source>
        <translation>los caminos tienen tantos eventos como necesitan</translation>
    </message>
    <message>
        <source>paths have one event</source>
        <translation>los caminos tienen un evento</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pausa</translation>
    </message>
    <message>
        <source>phase g is 0: the same to all sides</source>
        <translation>la fase g es 0: igual hacia todos los lados</translation>
    </message>
    <message>
        <source>phase g is not 0</source>
        <translation>la fase g no es 0</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>espaciado de píxel</translation>
    </message>
    <message>
        <source>places %1 and %2 of the path are too close for how well they are known</source>
        <translation>los lugares %1 y %2 del recorrido están demasiado cerca para lo que se sabe de ellos</translation>
    </message>
    <message>
        <source>point in time %1</source>
        <translation>instante %1</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programa</translation>
    </message>
    <message>
        <source>rays less exact than asked for</source>
        <translation>rayos menos exactos de lo pedido</translation>
    </message>
    <message>
        <source>rays outside soft edges</source>
        <translation>rayos fuera de los bordes suaves</translation>
    </message>
    <message>
        <source>rays to the light leave surfaces one voxel out</source>
        <translation>los rayos hacia la luz salen de las superficies un vóxel más afuera</translation>
    </message>
    <message>
        <source>rays to the light start at their event</source>
        <translation>los rayos hacia la luz empiezan en su evento</translation>
    </message>
    <message>
        <source>reading headers</source>
        <translation>se leen los encabezados</translation>
    </message>
    <message>
        <source>reading labels</source>
        <translation>leyendo etiquetas</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>se leen los cortes</translation>
    </message>
    <message>
        <source>reading the image</source>
        <translation>se lee la imagen</translation>
    </message>
    <message>
        <source>reading values</source>
        <translation>se leen los valores</translation>
    </message>
    <message>
        <source>rendering the image</source>
        <translation>Creando la imagen</translation>
    </message>
    <message>
        <source>rendering the image: %1 samples in %2</source>
        <translation>Creando la imagen: %1 muestras en %2</translation>
    </message>
    <message>
        <source>resampled</source>
        <translation>recalculada</translation>
    </message>
    <message>
        <source>resampled to the nearest of voxels of %1</source>
        <translation>remuestreado a los más cercanos de vóxeles de %1</translation>
    </message>
    <message>
        <source>rest of the body</source>
        <translation>resto del cuerpo</translation>
    </message>
    <message>
        <source>results that never came: %1</source>
        <translation>resultados que no llegaron: %1</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>rounded</source>
        <translation>redondeados</translation>
    </message>
    <message>
        <source>samples are shared out in blocks of 64, and fewer than two are ordered</source>
        <translation>las muestras se reparten en bloques de 64, y se han pedido menos de dos</translation>
    </message>
    <message>
        <source>samples left out: infinitely bright</source>
        <translation>muestras omitidas: brillo infinito</translation>
    </message>
    <message>
        <source>samples left out: negative light</source>
        <translation>muestras omitidas: luz negativa</translation>
    </message>
    <message>
        <source>samples left out: not a number</source>
        <translation>muestras omitidas: no son un número</translation>
    </message>
    <message>
        <source>saved, but its bias could not be measured: %1</source>
        <translation>guardada, pero no se pudo medir su sesgo: %1</translation>
    </message>
    <message>
        <source>saves %1</source>
        <translation>ahorra %1</translation>
    </message>
    <message>
        <source>says it holds %1 values and holds %2</source>
        <translation>dice que contiene %1 valores y contiene %2</translation>
    </message>
    <message>
        <source>search along scattering</source>
        <translation>búsqueda a lo largo de la dispersión</translation>
    </message>
    <message>
        <source>selected, %1</source>
        <translation>elegido, %1</translation>
    </message>
    <message>
        <source>selected, %1: %2</source>
        <translation>elegido, %1: %2</translation>
    </message>
    <message>
        <source>separating the body parts</source>
        <translation>separando las partes del cuerpo</translation>
    </message>
    <message>
        <source>several codings</source>
        <translation>varias codificaciones</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>sombras</translation>
    </message>
    <message>
        <source>share</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>piel</translation>
    </message>
    <message>
        <source>skin and muscle cannot be found, because %1</source>
        <translation>no se pueden encontrar piel y músculo, porque %1</translation>
    </message>
    <message>
        <source>slice %1 cannot be written</source>
        <translation>no se puede escribir el corte %1</translation>
    </message>
    <message>
        <source>slices are interpolated across %3 holes, the widest from %1 to %2 mm above the lowest slice; what is measured there is marked</source>
        <translation>los cortes están interpolados a través de %3 huecos, el más ancho de %1 a %2 mm por encima del corte más bajo; lo que se mide allí queda marcado</translation>
    </message>
    <message>
        <source>slices are interpolated across a hole from %1 to %2 mm above the lowest slice; what is measured there is marked</source>
        <translation>los cortes están interpolados a través de un hueco de %1 a %2 mm por encima del corte más bajo; lo que se mide allí queda marcado</translation>
    </message>
    <message>
        <source>slices between the scan's own are a cubic's: a choice, and no error of the computing</source>
        <translation>los cortes entre los del estudio son de una interpolación cúbica: una elección, no un error del cálculo</translation>
    </message>
    <message>
        <source>slices not in line</source>
        <translation>cortes no alineados</translation>
    </message>
    <message>
        <source>slices of different size</source>
        <translation>cortes de tamaño distinto</translation>
    </message>
    <message>
        <source>something failed for an unknown reason</source>
        <translation>algo falló por un motivo desconocido</translation>
    </message>
    <message>
        <source>something failed unexpectedly: %1</source>
        <translation>algo falló inesperadamente: %1</translation>
    </message>
    <message>
        <source>something is missing in it</source>
        <translation>falta algo en él</translation>
    </message>
    <message>
        <source>sorting slices</source>
        <translation>se ordenan los cortes</translation>
    </message>
    <message>
        <source>spacing or direction changes on the way; a pixel lies up to %1 mm from where the first slice would put it</source>
        <translation>el espaciado o la dirección cambia en el camino; un píxel está hasta a %1 mm de donde lo pondría el primer corte</translation>
    </message>
    <message>
        <source>stack %1</source>
        <translation>pila %1</translation>
    </message>
    <message>
        <source>stopped after %1, with %2 samples</source>
        <translation>parada tras %1, con %2 muestras</translation>
    </message>
    <message>
        <source>such a message goes the other way</source>
        <translation>un mensaje así va en la otra dirección</translation>
    </message>
    <message>
        <source>sums along rays: at most ±%1 levels</source>
        <translation>sumas a lo largo de rayos: como máximo ±%1 niveles</translation>
    </message>
    <message>
        <source>sums of pixels that cannot be unpacked</source>
        <translation>sumas de píxeles que no se pueden desempaquetar</translation>
    </message>
    <message>
        <source>sums of samples before the first one of a block</source>
        <translation>sumas de muestras anteriores a la primera de un bloque</translation>
    </message>
    <message>
        <source>sums that were not to be sent</source>
        <translation>sumas que no debían enviarse</translation>
    </message>
    <message>
        <source>surface reflection</source>
        <translation>reflexión en superficies</translation>
    </message>
    <message>
        <source>taken at %1</source>
        <translation>tomada a las %1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>target reached (Space: continue)</source>
        <translation>objetivo alcanzado (Espacio: continuar)</translation>
    </message>
    <message>
        <source>target: %1</source>
        <translation>objetivo: %1</translation>
    </message>
    <message>
        <source>the CPU</source>
        <translation>la CPU</translation>
    </message>
    <message>
        <source>the DICOM dictionary is not there, so no file can be read</source>
        <translation>falta el diccionario DICOM, así que no se puede leer ningún archivo</translation>
    </message>
    <message>
        <source>the GPU %1</source>
        <translation>la GPU %1</translation>
    </message>
    <message>
        <source>the GPU failed (%1)</source>
        <translation>la GPU falló (%1)</translation>
    </message>
    <message>
        <source>the GPU is too old for this program: it is of compute capability %1, %2 or later is needed</source>
        <translation>la GPU es demasiado antigua para este programa: es de compute capability %1 y se necesita %2 o posterior</translation>
    </message>
    <message>
        <source>the GPU was lost (%1)</source>
        <translation>se perdió la GPU (%1)</translation>
    </message>
    <message>
        <source>the aperture is 0</source>
        <translation>la apertura es 0</translation>
    </message>
    <message>
        <source>the archive holds %1 files, more than 100000</source>
        <translation>el archivo contiene %1 archivos, más de 100000</translation>
    </message>
    <message>
        <source>the archive holds another file of this name</source>
        <translation>el archivo contiene otro archivo con este nombre</translation>
    </message>
    <message>
        <source>the archive is damaged, or no ZIP archive (%1)</source>
        <translation>el archivo está dañado o no es un archivo ZIP (%1)</translation>
    </message>
    <message>
        <source>the archive is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the archive is encrypted</source>
        <translation>el archivo está cifrado</translation>
    </message>
    <message>
        <source>the archive would unpack to %1, which is more than 64 GB or 200 times its size</source>
        <translation>el archivo ocuparía %1 descomprimido, más de 64 GB o 200 veces su tamaño</translation>
    </message>
    <message>
        <source>the axes of the label map lie in one plane</source>
        <translation>los ejes del mapa de etiquetas están en un plano</translation>
    </message>
    <message>
        <source>the axes of the volume are not at right angles</source>
        <translation>los ejes del volumen no forman ángulos rectos</translation>
    </message>
    <message>
        <source>the blood has %1 HU, which marrow has, too</source>
        <translation>la sangre tiene %1 HU, que también tiene la médula</translation>
    </message>
    <message>
        <source>the camera sees a light</source>
        <translation>la cámara ve una luz</translation>
    </message>
    <message>
        <source>the camera sees the environment</source>
        <translation>la cámara ve el entorno</translation>
    </message>
    <message>
        <source>the certificates cannot be written</source>
        <translation>no se pueden escribir los certificados</translation>
    </message>
    <message>
        <source>the compressed image cannot be decoded</source>
        <translation>la imagen comprimida no se puede descodificar</translation>
    </message>
    <message>
        <source>the compressed image is damaged: %1</source>
        <translation>la imagen comprimida está dañada: %1</translation>
    </message>
    <message>
        <source>the compressed image is damaged: %1 of its pixels hold numbers that %2 bits cannot</source>
        <translation>la imagen comprimida está dañada: %1 de sus píxeles contienen números que no caben en %2 bits</translation>
    </message>
    <message>
        <source>the compressed image is damaged: its decoder says "%1"</source>
        <translation>la imagen comprimida está dañada: su descodificador dice «%1»</translation>
    </message>
    <message>
        <source>the coordinator gives out leases twice, or more than a node can have</source>
        <translation>el coordinador reparte encargos dos veces, o más de los que un equipo puede tener</translation>
    </message>
    <message>
        <source>the coordinator has not been heard of for %1 heartbeats</source>
        <translation>no se sabe nada del coordinador desde hace %1 latidos</translation>
    </message>
    <message>
        <source>the coordinator speaks a version of the protocol that it was not offered</source>
        <translation>el coordinador habla una versión del protocolo que no se le ofreció</translation>
    </message>
    <message>
        <source>the corners do not lie in one plane</source>
        <translation>los vértices no están en un mismo plano</translation>
    </message>
    <message>
        <source>the device takes samples for films of its own only</source>
        <translation>el dispositivo solo toma muestras para sus propias películas</translation>
    </message>
    <message>
        <source>the driver is too old: it knows CUDA %1, %2 is needed</source>
        <translation>el controlador es demasiado antiguo: conoce CUDA %1 y se necesita %2</translation>
    </message>
    <message>
        <source>the driver stopped the GPU, since the display had to wait for it</source>
        <translation>el controlador detuvo la GPU, porque la pantalla tenía que esperarla</translation>
    </message>
    <message>
        <source>the environment image is not complete</source>
        <translation>la imagen del entorno no está completa</translation>
    </message>
    <message>
        <source>the environment is black</source>
        <translation>el entorno es negro</translation>
    </message>
    <message>
        <source>the environment is hidden from the camera</source>
        <translation>el entorno está oculto a la cámara</translation>
    </message>
    <message>
        <source>the environment shines</source>
        <translation>el entorno alumbra</translation>
    </message>
    <message>
        <source>the figure lies in axial slice %1</source>
        <translation>la figura está en el corte axial %1</translation>
    </message>
    <message>
        <source>the figure lies in coronal slice %1</source>
        <translation>la figura está en el corte coronal %1</translation>
    </message>
    <message>
        <source>the figure lies in sagittal slice %1</source>
        <translation>la figura está en el corte sagital %1</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>no se puede abrir el archivo</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>no se puede leer el archivo</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>no se puede leer el archivo (%1)</translation>
    </message>
    <message>
        <source>the file could not be read to its end</source>
        <translation>no se pudo leer el archivo hasta el final</translation>
    </message>
    <message>
        <source>the file could not be written (%1)</source>
        <translation>no se pudo escribir el archivo (%1)</translation>
    </message>
    <message>
        <source>the file does not say that its values are HU; they run from %1 to %2, and are taken as HU</source>
        <translation>el archivo no dice que sus valores sean HU; van de %1 a %2 y se toman como HU</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>el archivo termina demasiado pronto</translation>
    </message>
    <message>
        <source>the file has changed since the folder was scanned</source>
        <translation>el archivo ha cambiado desde que se examinó la carpeta</translation>
    </message>
    <message>
        <source>the file holds %1 bytes, %2 voxels of this type are %3</source>
        <translation>el archivo contiene %1 bytes; %2 vóxeles de este tipo son %3</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>el archivo está dañado: %1</translation>
    </message>
    <message>
        <source>the file is damaged: it cannot be parsed to its end</source>
        <translation>el archivo está dañado: no se puede leer hasta el final</translation>
    </message>
    <message>
        <source>the file is larger than %1</source>
        <translation>el archivo supera %1</translation>
    </message>
    <message>
        <source>the file is no longer there</source>
        <translation>el archivo ya no está</translation>
    </message>
    <message>
        <source>the file of its voxels cannot be read (%1)</source>
        <translation>el archivo de sus vóxeles no se puede leer (%1)</translation>
    </message>
    <message>
        <source>the files call the series %1, not CT, and its values HU</source>
        <translation>los archivos llaman a la serie %1, no CT, y a sus valores HU</translation>
    </message>
    <message>
        <source>the files do not say that the values are HU: looks, windows and parts of the body that need HU are not offered</source>
        <translation>los archivos no dicen que los valores sean UH: no se ofrecen aspectos, ventanas ni partes del cuerpo que necesitan UH</translation>
    </message>
    <message>
        <source>the files name %1 frames of reference; their positions are taken as one</source>
        <translation>los archivos nombran %1 sistemas de referencia; sus posiciones se toman como de uno solo</translation>
    </message>
    <message>
        <source>the files name %1 studies; their slices are taken as one series</source>
        <translation>los archivos nombran %1 estudios; sus cortes se toman como una sola serie</translation>
    </message>
    <message>
        <source>the first place is known only to ± %1 mm</source>
        <translation>el primer punto solo se conoce con ± %1 mm</translation>
    </message>
    <message>
        <source>the folder cannot be created (%1)</source>
        <translation>no se puede crear la carpeta (%1)</translation>
    </message>
    <message>
        <source>the folder cannot be looked into (%1)</source>
        <translation>no se puede mirar en la carpeta (%1)</translation>
    </message>
    <message>
        <source>the folder cannot be made (%1)</source>
        <translation>no se puede crear la carpeta (%1)</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1)</source>
        <translation>no se puede leer la carpeta (%1)</translation>
    </message>
    <message>
        <source>the folder for your looks cannot be made</source>
        <translation>no se puede crear la carpeta de sus aspectos</translation>
    </message>
    <message>
        <source>the folder is empty</source>
        <translation>la carpeta está vacía</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>la carpeta no está vacía</translation>
    </message>
    <message>
        <source>the fourth place is known only to ± %1 mm</source>
        <translation>el cuarto punto solo se conoce con ± %1 mm</translation>
    </message>
    <message>
        <source>the gantry was tilted by %1 degrees; the grid follows it (%2 mm a slice)</source>
        <translation>el gantry estaba inclinado %1 grados; la rejilla lo sigue (%2 mm por corte)</translation>
    </message>
    <message>
        <source>the gradient factor is 0</source>
        <translation>el factor de gradiente es 0</translation>
    </message>
    <message>
        <source>the gradient factor is above 0</source>
        <translation>el factor de gradiente es mayor que 0</translation>
    </message>
    <message>
        <source>the grey window in the files is left out: its centre or its width is no number</source>
        <translation>la ventana de grises de los archivos no se tiene en cuenta: su centro o su anchura no es un número</translation>
    </message>
    <message>
        <source>the grey window in the files is left out: its function "%1" is not known</source>
        <translation>la ventana de grises de los archivos no se tiene en cuenta: su función «%1» es desconocida</translation>
    </message>
    <message>
        <source>the grey window in the files is left out: no window is %1 wide</source>
        <translation>se omite la ventana de grises de los archivos: ninguna ventana tiene una anchura de %1</translation>
    </message>
    <message>
        <source>the image cannot be read as OpenEXR (%1)</source>
        <translation>la imagen no se puede leer como OpenEXR (%1)</translation>
    </message>
    <message>
        <source>the image could not be encoded as OpenEXR (%1)</source>
        <translation>la imagen no se pudo codificar como OpenEXR (%1)</translation>
    </message>
    <message>
        <source>the image could not be encoded as PNG</source>
        <translation>la imagen no se pudo codificar como PNG</translation>
    </message>
    <message>
        <source>the image could not be rendered</source>
        <translation>no se pudo hacer la imagen</translation>
    </message>
    <message>
        <source>the image has no channel %1</source>
        <translation>la imagen no tiene canal %1</translation>
    </message>
    <message>
        <source>the image holds fewer pixels than its header says</source>
        <translation>la imagen contiene menos píxeles de los que dice su cabecera</translation>
    </message>
    <message>
        <source>the image is %1 x %2 pixels, at most %3 x %3 can be read</source>
        <translation>la imagen tiene %1 x %2 píxeles; se pueden leer %3 x %3 como máximo</translation>
    </message>
    <message>
        <source>the image is black and lights nothing</source>
        <translation>la imagen es negra y no ilumina nada</translation>
    </message>
    <message>
        <source>the image is not complete</source>
        <translation>la imagen no está completa</translation>
    </message>
    <message>
        <source>the image was closed</source>
        <translation>se cerró la imagen</translation>
    </message>
    <message>
        <source>the label map has voxels of %1, the scan of %2, or they are turned</source>
        <translation>el mapa de etiquetas tiene vóxeles de %1, el estudio de %2, o están girados</translation>
    </message>
    <message>
        <source>the label map is mirrored: "%1" lies at the right of "%2"</source>
        <translation>el mapa de etiquetas está reflejado: «%1» está a la derecha de «%2»</translation>
    </message>
    <message>
        <source>the label map is mirrored: it fits the scan with %1 exchanged</source>
        <translation>el mapa de etiquetas está reflejado: encaja con el estudio si se intercambian %1</translation>
    </message>
    <message>
        <source>the label map is shifted: its voxels lie %1 mm (%2 voxels) beside those of the scan</source>
        <translation>el mapa de etiquetas está desplazado: sus vóxeles están a %1 mm (%2 vóxeles) de los del estudio</translation>
    </message>
    <message>
        <source>the label map lies elsewhere: it reaches %1 voxels beyond the scan</source>
        <translation>el mapa de etiquetas está en otro lugar: sobresale %1 vóxeles del estudio</translation>
    </message>
    <message>
        <source>the label map lies on another grid than the volume</source>
        <translation>el mapa de etiquetas está en otra cuadrícula que el volumen</translation>
    </message>
    <message>
        <source>the lens is open</source>
        <translation>el objetivo está abierto</translation>
    </message>
    <message>
        <source>the light here stops at %1 depths: the one with the most, %2 %, was taken</source>
        <translation>la luz se detiene aquí a %1 profundidades: se ha elegido la de mayor parte, el %2 %</translation>
    </message>
    <message>
        <source>the link leads nowhere</source>
        <translation>el enlace no lleva a ninguna parte</translation>
    </message>
    <message>
        <source>the lungs</source>
        <translation>los pulmones</translation>
    </message>
    <message>
        <source>the lungs cannot be shown</source>
        <translation>no se pueden mostrar los pulmones</translation>
    </message>
    <message>
        <source>the lungs cannot be told from the rest</source>
        <translation>los pulmones no se distinguen del resto</translation>
    </message>
    <message>
        <source>the march has one event on a path</source>
        <translation>la marcha tiene un evento por camino</translation>
    </message>
    <message>
        <source>the mask has other voxels than those before it</source>
        <translation>la máscara tiene vóxeles distintos de las anteriores</translation>
    </message>
    <message>
        <source>the masks have more than %1 labels</source>
        <translation>las máscaras tienen más de %1 etiquetas</translation>
    </message>
    <message>
        <source>the measurements do not tell the parts of a frame's time apart</source>
        <translation>las mediciones no distinguen las partes del tiempo de una imagen</translation>
    </message>
    <message>
        <source>the memory of the GPU has lost bits</source>
        <translation>la memoria de la GPU ha perdido bits</translation>
    </message>
    <message>
        <source>the memory of the GPU is taken: %1 are free</source>
        <translation>la memoria de la GPU está ocupada: quedan libres %1</translation>
    </message>
    <message>
        <source>the model %1 knows no materials of parts</source>
        <translation>el modelo %1 no conoce materiales de partes</translation>
    </message>
    <message>
        <source>the model asks for no light</source>
        <translation>el modelo no usa luz</translation>
    </message>
    <message>
        <source>the model does not scatter</source>
        <translation>el modelo no dispersa</translation>
    </message>
    <message>
        <source>the model has none</source>
        <translation>el modelo no las tiene</translation>
    </message>
    <message>
        <source>the model has one event on a path</source>
        <translation>el modelo tiene un evento por camino</translation>
    </message>
    <message>
        <source>the model shows no light from within</source>
        <translation>el modelo no muestra luz del interior</translation>
    </message>
    <message>
        <source>the model shows values, not light</source>
        <translation>el modelo muestra valores, no luz</translation>
    </message>
    <message>
        <source>the name says no format that images are saved in</source>
        <translation>el nombre no indica un formato en el que se guarden imágenes</translation>
    </message>
    <message>
        <source>the network takes longest either way: %1</source>
        <translation>la red es lo que más tarda en ambos casos: %1</translation>
    </message>
    <message>
        <source>the only file is not a DICOM image</source>
        <translation>el único archivo no es una imagen DICOM</translation>
    </message>
    <message>
        <source>the other device cannot be used: %1</source>
        <translation>no se puede usar el otro dispositivo: %1</translation>
    </message>
    <message>
        <source>the other side did not introduce itself first</source>
        <translation>la otra parte no se ha presentado primero</translation>
    </message>
    <message>
        <source>the other side did not introduce itself in time</source>
        <translation>la otra parte no se ha presentado a tiempo</translation>
    </message>
    <message>
        <source>the other side ended the connection</source>
        <translation>la otra parte ha terminado la conexión</translation>
    </message>
    <message>
        <source>the other side sends a message too slowly</source>
        <translation>la otra parte envía un mensaje demasiado despacio</translation>
    </message>
    <message>
        <source>the other side sends more messages than it has reason to</source>
        <translation>la otra parte envía más mensajes de los que tiene motivo</translation>
    </message>
    <message>
        <source>the other side sent what makes no sense: %1</source>
        <translation>la otra parte envió algo sin sentido: %1</translation>
    </message>
    <message>
        <source>the other side takes too little of what it is sent</source>
        <translation>la otra parte acepta demasiado poco de lo que se le envía</translation>
    </message>
    <message>
        <source>the outline crosses itself</source>
        <translation>el contorno se cruza a sí mismo</translation>
    </message>
    <message>
        <source>the outline encloses nothing</source>
        <translation>el contorno no encierra nada</translation>
    </message>
    <message>
        <source>the patient</source>
        <translation>el paciente</translation>
    </message>
    <message>
        <source>the plan was made by a version that reads scans by rule %1, and this one reads by rule %2</source>
        <translation>el plan es de una versión que lee los estudios con la regla %1; esta los lee con la regla %2</translation>
    </message>
    <message>
        <source>the plan was made on the same voxels at another place of the patient</source>
        <translation>el plan se hizo sobre los mismos vóxeles en otro lugar del paciente</translation>
    </message>
    <message>
        <source>the previous series is still in memory</source>
        <translation>la serie anterior sigue en memoria</translation>
    </message>
    <message>
        <source>the region is still black</source>
        <translation>la región sigue negra</translation>
    </message>
    <message>
        <source>the rest of the image waits for the region</source>
        <translation>el resto de la imagen espera a la región</translation>
    </message>
    <message>
        <source>the samples come first: %3 in %2, within ±%1</source>
        <translation>las muestras llegan primero: %3 en %2, dentro de ±%1</translation>
    </message>
    <message>
        <source>the scanner measured nothing here</source>
        <translation>aquí el escáner no midió nada</translation>
    </message>
    <message>
        <source>the scanner measured nothing in this region</source>
        <translation>en esta región el escáner no midió nada</translation>
    </message>
    <message>
        <source>the scene that was ordered cannot be rendered: %1</source>
        <translation>la escena pedida no se puede calcular: %1</translation>
    </message>
    <message>
        <source>the second place is known only to ± %1 mm</source>
        <translation>el segundo punto solo se conoce con ± %1 mm</translation>
    </message>
    <message>
        <source>the segmentation does not refer to the scan</source>
        <translation>la segmentación no se refiere al estudio</translation>
    </message>
    <message>
        <source>the segmentation has another frame of reference than the scan</source>
        <translation>la segmentación tiene otro sistema de referencia que el estudio</translation>
    </message>
    <message>
        <source>the segmentation names another patient than the scan</source>
        <translation>la segmentación nombra a otro paciente que el estudio</translation>
    </message>
    <message>
        <source>the slices differ in size: %1</source>
        <translation>los cortes tienen distinto tamaño: %1</translation>
    </message>
    <message>
        <source>the slices drift sideways by %1 mm for each %2 mm of height (gantry tilt of %3 degrees), from %4 to %5</source>
        <translation>los cortes se desplazan lateralmente %1 mm por cada %2 mm de altura (inclinación del gantry de %3 grados), de %4 a %5</translation>
    </message>
    <message>
        <source>the slices scale their values differently; all are rounded to steps of %1</source>
        <translation>los cortes escalan sus valores de forma distinta; todos están redondeados a pasos de %1</translation>
    </message>
    <message>
        <source>the symbolic links here lead in a circle</source>
        <translation>los enlaces simbólicos forman aquí un círculo</translation>
    </message>
    <message>
        <source>the system has no thread or no memory left for this</source>
        <translation>al sistema no le quedan hilos o memoria para esto</translation>
    </message>
    <message>
        <source>the text %1 has more than %2 values</source>
        <translation>el texto %1 tiene más de %2 valores</translation>
    </message>
    <message>
        <source>the text %1 is longer than %2 kB</source>
        <translation>el texto %1 supera %2 kB</translation>
    </message>
    <message>
        <source>the third place is known only to ± %1 mm</source>
        <translation>el tercer punto solo se conoce con ± %1 mm</translation>
    </message>
    <message>
        <source>the threads of a warp have lost each other</source>
        <translation>los hilos de un warp se han perdido unos a otros</translation>
    </message>
    <message>
        <source>the time comes first: in %2, within ±%1 and with %3 samples</source>
        <translation>el tiempo llega primero: en %2, dentro de ±%1 y con %3 muestras</translation>
    </message>
    <message>
        <source>the values are no HU but another quantity (%1): looks, windows and parts of the body that need HU are not offered</source>
        <translation>los valores no son UH sino otra magnitud (%1): no se ofrecen aspectos, ventanas ni partes del cuerpo que necesitan UH</translation>
    </message>
    <message>
        <source>the values are rounded to steps of %1, 65,536 from the lowest to the highest</source>
        <translation>los valores están redondeados a pasos de %1, 65.536 del más bajo al más alto</translation>
    </message>
    <message>
        <source>the values of this scan are no HU</source>
        <translation>los valores de este estudio no son UH</translation>
    </message>
    <message>
        <source>the values of this scan are no HU, in which looks are kept</source>
        <translation>los valores de este estudio no son UH, en las que se guardan los aspectos</translation>
    </message>
    <message>
        <source>the values run from %1 to %2 and are no HU, which begin at -100 or below, and end at 100 or above: looks, windows and parts of the body that need HU are not offered</source>
        <translation>los valores van de %1 a %2 y no son UH, que empiezan en -100 o menos y terminan en 100 o más: no se ofrecen aspectos, ventanas ni partes del cuerpo que necesitan UH</translation>
    </message>
    <message>
        <source>the view</source>
        <translation>la vista</translation>
    </message>
    <message>
        <source>the volume does not fit into its memory: %1 are needed, %2 are free</source>
        <translation>el volumen no cabe en su memoria: se necesitan %1 y hay %2 libres</translation>
    </message>
    <message>
        <source>the volume holds no values that are specular</source>
        <translation>el volumen no contiene valores especulares</translation>
    </message>
    <message>
        <source>the volume is too large for fast filtering: it has %1 voxels, textures may have %2</source>
        <translation>el volumen es demasiado grande para el filtrado rápido: tiene %1 vóxeles y las texturas admiten %2</translation>
    </message>
    <message>
        <source>the volume needs %1 of memory, and %2 are free</source>
        <translation>el volumen necesita %1 de memoria y hay %2 libres</translation>
    </message>
    <message>
        <source>the volume needs %1 of memory, which could not be had</source>
        <translation>el volumen necesita %1 de memoria, que no se pudo obtener</translation>
    </message>
    <message>
        <source>the voxels of %1 slices between %2 and %3 are not those that the plan was made on</source>
        <translation>los vóxeles de %1 cortes entre %2 y %3 no son aquellos sobre los que se hizo el plan</translation>
    </message>
    <message>
        <source>the voxels of slice %1 are not those that the plan was made on</source>
        <translation>los vóxeles del corte %1 no son aquellos sobre los que se hizo el plan</translation>
    </message>
    <message>
        <source>the voxels of slices %1 to %2 are not those that the plan was made on</source>
        <translation>los vóxeles de los cortes %1 a %2 no son aquellos sobre los que se hizo el plan</translation>
    </message>
    <message>
        <source>there are %1 nodes, at most %2 are taken</source>
        <translation>hay %1 puntos; se admiten %2 como máximo</translation>
    </message>
    <message>
        <source>there are certificates already</source>
        <translation>ya hay certificados</translation>
    </message>
    <message>
        <source>there are no surfaces</source>
        <translation>no hay superficies</translation>
    </message>
    <message>
        <source>there are too few blocks of 64 samples for all render nodes: they would take %1, tiles take %2</source>
        <translation>hay demasiado pocos bloques de 64 muestras para todos los equipos de render: tardarían %1, las teselas tardan %2</translation>
    </message>
    <message>
        <source>there is a stray delimiter %1</source>
        <translation>hay un delimitador suelto %1</translation>
    </message>
    <message>
        <source>there is contrast in the blood</source>
        <translation>hay contraste en la sangre</translation>
    </message>
    <message>
        <source>there is no GPU of NVIDIA's</source>
        <translation>no hay ninguna GPU de NVIDIA</translation>
    </message>
    <message>
        <source>there is no air of 150 ml in the body that looks like a lung</source>
        <translation>en el cuerpo no hay 150 ml de aire que parezcan un pulmón</translation>
    </message>
    <message>
        <source>there is no connection: %1</source>
        <translation>no hay conexión: %1</translation>
    </message>
    <message>
        <source>there is no driver for a GPU of NVIDIA's</source>
        <translation>no hay controlador para una GPU de NVIDIA</translation>
    </message>
    <message>
        <source>there is no image</source>
        <translation>no hay imagen</translation>
    </message>
    <message>
        <source>there is no light</source>
        <translation>no hay luz</translation>
    </message>
    <message>
        <source>there is no measurement to export</source>
        <translation>no hay ninguna medición que exportar</translation>
    </message>
    <message>
        <source>there is no pool of 5 ml of blood with contrast medium</source>
        <translation>no hay 5 ml juntos de sangre con medio de contraste</translation>
    </message>
    <message>
        <source>there is no scene on the device</source>
        <translation>no hay ninguna escena en el dispositivo</translation>
    </message>
    <message>
        <source>there is no series %1 here</source>
        <translation>aquí no hay ninguna serie %1</translation>
    </message>
    <message>
        <source>there is no such GPU</source>
        <translation>no existe esa GPU</translation>
    </message>
    <message>
        <source>there is no such device</source>
        <translation>no existe ese dispositivo</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>no existe esa carpeta</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>no existe ese puerto</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>no hay memoria suficiente</translation>
    </message>
    <message>
        <source>there is not enough memory %1</source>
        <translation>no hay memoria suficiente %1</translation>
    </message>
    <message>
        <source>there is not enough memory to look for it</source>
        <translation>no hay memoria suficiente para buscarla</translation>
    </message>
    <message>
        <source>there is not enough memory to read its header</source>
        <translation>no hay memoria suficiente para leer su cabecera</translation>
    </message>
    <message>
        <source>there is something behind its map</source>
        <translation>hay algo detrás de su tabla</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>hay muy poca memoria</translation>
    </message>
    <message>
        <source>these certificates do not belong together</source>
        <translation>estos certificados no van juntos</translation>
    </message>
    <message>
        <source>thin structures may be further off</source>
        <translation>las estructuras finas pueden desviarse más</translation>
    </message>
    <message>
        <source>this body is no wider than a head</source>
        <translation>este cuerpo no es más ancho que una cabeza</translation>
    </message>
    <message>
        <source>this body is wider than a head</source>
        <translation>este cuerpo es más ancho que una cabeza</translation>
    </message>
    <message>
        <source>this certificate does not hold yet</source>
        <translation>este certificado aún no es válido</translation>
    </message>
    <message>
        <source>this certificate has expired</source>
        <translation>este certificado ha caducado</translation>
    </message>
    <message>
        <source>this figure is drawn on a slice</source>
        <translation>esta figura se dibuja en un corte</translation>
    </message>
    <message>
        <source>this file belongs to another user, and in this folder only they may replace it</source>
        <translation>este archivo es de otro usuario, y en esta carpeta solo él puede reemplazarlo</translation>
    </message>
    <message>
        <source>this file is read by the scene that is to be rendered</source>
        <translation>este archivo lo lee la escena que se va a renderizar</translation>
    </message>
    <message>
        <source>this file may not be written</source>
        <translation>no está permitido escribir este archivo</translation>
    </message>
    <message>
        <source>this image adds up all depths: no point of it is one place</source>
        <translation>esta imagen suma todas las profundidades: ningún punto suyo es un único lugar</translation>
    </message>
    <message>
        <source>this is a file, not a folder</source>
        <translation>esto es un archivo, no una carpeta</translation>
    </message>
    <message>
        <source>this is a folder, a file name is needed</source>
        <translation>esto es una carpeta, hace falta un nombre de archivo</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>esto es una carpeta, no un archivo</translation>
    </message>
    <message>
        <source>this is another scan: %1 voxels, and the plan was made on %2</source>
        <translation>este es otro estudio: %1 vóxeles, y el plan se hizo sobre %2</translation>
    </message>
    <message>
        <source>this is another scan: it has the size of the plan's, but other voxels</source>
        <translation>este es otro estudio: tiene el tamaño del plan, pero otros vóxeles</translation>
    </message>
    <message>
        <source>this is no DICOM image</source>
        <translation>esto no es una imagen DICOM</translation>
    </message>
    <message>
        <source>this is no DICOM segmentation</source>
        <translation>esto no es una segmentación DICOM</translation>
    </message>
    <message>
        <source>this is no MetaImage file</source>
        <translation>no es un archivo MetaImage</translation>
    </message>
    <message>
        <source>this is no NIfTI file with header and voxels in one</source>
        <translation>no es un archivo NIfTI con cabecera y vóxeles en uno</translation>
    </message>
    <message>
        <source>this is no NRRD file</source>
        <translation>no es un archivo NRRD</translation>
    </message>
    <message>
        <source>this is no address</source>
        <translation>esto no es una dirección</translation>
    </message>
    <message>
        <source>this is no certificate</source>
        <translation>esto no es un certificado</translation>
    </message>
    <message>
        <source>this is no key</source>
        <translation>esto no es una clave</translation>
    </message>
    <message>
        <source>this is no plain file</source>
        <translation>esto no es un archivo corriente</translation>
    </message>
    <message>
        <source>this is not the certificate of a %1</source>
        <translation>este no es el certificado de un %1</translation>
    </message>
    <message>
        <source>this is one piece of a stack whose other piece lies on another grid (%1): %2 and so on here, %3 and so on there</source>
        <translation>es una parte de una pila cuya otra parte está en otra rejilla (%1): %2 y siguientes aquí, %3 y siguientes allí</translation>
    </message>
    <message>
        <source>this key is encrypted, and nobody is there to ask for its password</source>
        <translation>esta clave está cifrada y no hay nadie a quien pedir la contraseña</translation>
    </message>
    <message>
        <source>this look cannot be deleted: %1</source>
        <translation>no se puede borrar este aspecto: %1</translation>
    </message>
    <message>
        <source>this look cannot be written: %1</source>
        <translation>no se puede escribir este aspecto: %1</translation>
    </message>
    <message>
        <source>this machine's certificates have expired: make new ones for the coordinator and all nodes, and start the programs again</source>
        <translation>los certificados de este equipo han caducado: cree otros para el coordinador y todos los equipos de render, y vuelva a iniciar los programas</translation>
    </message>
    <message>
        <source>this name is too long</source>
        <translation>este nombre es demasiado largo</translation>
    </message>
    <message>
        <source>this node has said goodbye</source>
        <translation>este equipo se ha despedido</translation>
    </message>
    <message>
        <source>this node works for somebody else</source>
        <translation>este equipo trabaja para otro</translation>
    </message>
    <message>
        <source>this program listens at IP addresses, not at names</source>
        <translation>este programa escucha en direcciones IP, no en nombres</translation>
    </message>
    <message>
        <source>this program was built without CUDA</source>
        <translation>este programa se compiló sin CUDA</translation>
    </message>
    <message>
        <source>this region holds more than %1 voxels</source>
        <translation>esta región contiene más de %1 vóxeles</translation>
    </message>
    <message>
        <source>this render node is named already</source>
        <translation>este equipo de render ya está nombrado</translation>
    </message>
    <message>
        <source>this scan has no part called "%1"</source>
        <translation>este estudio no tiene ninguna parte llamada «%1»</translation>
    </message>
    <message>
        <source>this scene cannot be sent to render nodes: they would read another one</source>
        <translation>esta escena no se puede enviar a los equipos de render: leerían otra</translation>
    </message>
    <message>
        <source>tiles would be smaller than what a render node needs to start: %1 of %2</source>
        <translation>las teselas serían más cortas de lo que un equipo de render necesita para empezar: %1 de %2</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>inclinada</translation>
    </message>
    <message>
        <source>time to the target</source>
        <translation>tiempo hasta el objetivo</translation>
    </message>
    <message>
        <source>tissue is seen against the environment, else against white</source>
        <translation>el tejido se ve ante el entorno, si no ante blanco</translation>
    </message>
    <message>
        <source>tissue is seen against white: without it there is no image</source>
        <translation>el tejido se ve ante blanco: sin ello no hay imagen</translation>
    </message>
    <message>
        <source>to decode it</source>
        <translation>para descodificarlo</translation>
    </message>
    <message>
        <source>to denoise the scan: %1</source>
        <translation>para reducir el ruido del estudio: %1</translation>
    </message>
    <message>
        <source>to tell parts of the body apart</source>
        <translation>para distinguir partes del cuerpo</translation>
    </message>
    <message>
        <source>too few measurements: %1 sizes with %2 numbers of iterations</source>
        <translation>muy pocas mediciones: %1 tamaños con %2 números de iteraciones</translation>
    </message>
    <message>
        <source>uncompressed</source>
        <translation>sin comprimir</translation>
    </message>
    <message>
        <source>uneven</source>
        <translation>irregular</translation>
    </message>
    <message>
        <source>units</source>
        <translation>unidades</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>vasos</translation>
    </message>
    <message>
        <source>vessels are guessed by their density: check them; beside bone (neck, base of the skull) they may be missing, as may veins full of undiluted medium; calcium, and organs full of medium, may be among them</source>
        <translation>los vasos se suponen por su densidad: compruébelos; junto al hueso (cuello, base del cráneo) pueden faltar, igual que las venas llenas de medio sin diluir; calcio y órganos llenos de medio pueden estar entre ellos</translation>
    </message>
    <message>
        <source>vessels cannot be found, because %1</source>
        <translation>no se pueden encontrar vasos, porque %1</translation>
    </message>
    <message>
        <source>visible background</source>
        <translation>fondo visible</translation>
    </message>
    <message>
        <source>voxel %1 holds %2, Hounsfield units end at 32767 and begin at -32768</source>
        <translation>el vóxel %1 contiene %2; las unidades Hounsfield van de -32768 a 32767</translation>
    </message>
    <message>
        <source>voxels lie %1 mm apart, must be from %2 to %3</source>
        <translation>los vóxeles están a %1 mm; se admite de %2 a %3</translation>
    </message>
    <message>
        <source>voxels lie more than 5 mm apart</source>
        <translation>los vóxeles están a más de 5 mm</translation>
    </message>
    <message>
        <source>voxels that lie in several parts, of which the smallest keeps them: %1</source>
        <translation>vóxeles que están en varias partes y se quedan en la más pequeña: %1</translation>
    </message>
    <message>
        <source>water</source>
        <translation>agua</translation>
    </message>
    <message>
        <source>what is cut away lies outside the volume</source>
        <translation>lo cortado queda fuera del volumen</translation>
    </message>
    <message>
        <source>what is seen here is spread over %1 mm of depth: too translucent to be one place</source>
        <translation>lo que se ve aquí se reparte en %1 mm de profundidad: es demasiado translúcido para ser un único lugar</translation>
    </message>
    <message>
        <source>which of them comes first is not known yet</source>
        <translation>aún no se sabe cuál de ellos llega primero</translation>
    </message>
    <message>
        <source>whole image, waiting for the region: ±%1 (95 % of the tissue)</source>
        <translation>toda la imagen, a la espera de la región: ±%1 (95 % del tejido)</translation>
    </message>
    <message>
        <source>without certificates only this machine itself may be dialled</source>
        <translation>sin certificados solo se puede llamar a este mismo equipo</translation>
    </message>
    <message>
        <source>without it: mean</source>
        <translation>sin él: media</translation>
    </message>
    <message>
        <source>writing slices</source>
        <translation>se escriben los cortes</translation>
    </message>
    <message>
        <source>writing the image</source>
        <translation>Escribiendo la imagen</translation>
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
        <translation>±%1 llega primero: en %2, con %3 muestras</translation>
    </message>
    <message>
        <source>±%1 in %2</source>
        <translation>±%1 en %2</translation>
    </message>
    <message>
        <source>±%1 in %2, to 95 % between %3 and %4</source>
        <translation>±%1 en %2, al 95 % entre %3 y %4</translation>
    </message>
    <message>
        <source>±%1 in at least %2</source>
        <translation>±%1 en al menos %2</translation>
    </message>
    <message>
        <source>±%1 levels for 95 % of the tissue before denoising; %2 % of its light</source>
        <translation>±%1 niveles para el 95 % del tejido antes de eliminar el ruido; %2 % de su luz</translation>
    </message>
    <message>
        <source>±%1 levels for 95 % of the tissue; %2 % of its light</source>
        <translation>±%1 niveles para el 95 % del tejido; %2 % de su luz</translation>
    </message>
    <message>
        <source>±%1 since %2 of rendering</source>
        <translation>±%1 desde %2 de cálculo</translation>
    </message>
</context>
</TS>

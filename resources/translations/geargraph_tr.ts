<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>GearGraph</name>
    <message>
        <source>at</source>
        <comment>A turning joint, by its label, or a link on which a load or a balance acts from outside.</comment>
        <translation>an</translation>
    </message>
    <message>
        <source>turns</source>
        <comment>The link beyond the joint, seen from the ground.</comment>
        <translation>dönüş</translation>
    </message>
    <message>
        <source>carried by</source>
        <comment>What puts a torque in: a load that is given, a balance that is found, or nothing: a free joint.</comment>
        <translation>taşıyan</translation>
    </message>
    <message>
        <source>coupling</source>
        <comment>A brake or clutch that is engaged.</comment>
        <translation>eleman</translation>
    </message>
    <message>
        <source>holds</source>
        <comment>The link that a brake holds; the two links that a clutch joins, the torque acts on the first one.</comment>
        <translation>tutar</translation>
    </message>
    <message>
        <source>about</source>
        <comment>The axis that the torque is about, the first one on the way to the ground.</comment>
        <translation>etrafında</translation>
    </message>
    <message>
        <source>mesh</source>
        <comment>The gear mesh, by its label.</comment>
        <translation>dişli çifti</translation>
    </message>
    <message>
        <source>tail</source>
        <comment>The link of the tail&apos;s gear.</comment>
        <translation>kuyruk</translation>
    </message>
    <message>
        <source>head</source>
        <comment>The link of the head&apos;s gear.</comment>
        <translation>baş</translation>
    </message>
    <message>
        <source>carrier</source>
        <comment>The link that holds both gears&apos; axes, from which the mesh is seen.</comment>
        <translation>taşıyıcı</translation>
    </message>
    <message>
        <source>drives</source>
        <comment>The gear that delivers the power to the teeth, seen from the carrier.</comment>
        <translation>tahrik eder</translation>
    </message>
    <message>
        <source>joint</source>
        <comment>The turning joint, whose bearing holds its head on its tail.</comment>
        <translation>mafsal</translation>
    </message>
    <message>
        <source>element</source>
        <comment>A mesh, a joint, an engaged coupling, a load or a balance.</comment>
        <translation>öğe</translation>
    </message>
    <message>
        <source>link</source>
        <comment>The link that it acts on.</comment>
        <translation>uzuv</translation>
    </message>
    <message>
        <source>links</source>
        <comment>The shafts of the loop.</comment>
        <translation>uzuvlar</translation>
    </message>
    <message>
        <source>meshes</source>
        <comment>The meshes of the gear sets of the loop.</comment>
        <translation>kavraşır</translation>
    </message>
    <message>
        <source>the ground does not move</source>
        <translation>sabit uzuv hareket etmez</translation>
    </message>
    <message>
        <source>no turning joint carries it yet</source>
        <translation>henüz onu taşıyan döner mafsal yok</translation>
    </message>
    <message>
        <source>several turning joints: click one</source>
        <translation>birkaç döner mafsal var: birine tıklayın</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 öğe</translation>
    </message>
    <message>
        <source>link %1</source>
        <translation>%1 uzvu</translation>
    </message>
    <message>
        <source>turning joint %1</source>
        <translation>%1 döner mafsalı</translation>
    </message>
    <message>
        <source>gear mesh %1</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>%1 ekseni</translation>
    </message>
    <message>
        <source>brake %1</source>
        <translation>%1 freni</translation>
    </message>
    <message>
        <source>clutch %1</source>
        <translation>%1 kavraması</translation>
    </message>
    <message>
        <source> from link %1 to link %2</source>
        <translation> %1 uzvundan %2 uzvuna</translation>
    </message>
    <message>
        <source>: holds link %1 while it is engaged</source>
        <translation>: devredeyken %1 uzvunu tutar</translation>
    </message>
    <message>
        <source>: links %1 turn as one while it is engaged</source>
        <translation>: devredeyken %1 uzuvları birlikte döner</translation>
    </message>
    <message>
        <source> and </source>
        <translation> ve </translation>
    </message>
    <message>
        <source>, axis %1</source>
        <translation>, %1 ekseni</translation>
    </message>
    <message>
        <source>, driven</source>
        <translation>, tahrikli</translation>
    </message>
    <message>
        <source>, %1 : %2 teeth</source>
        <translation>, %1 : %2 diş</translation>
    </message>
    <message>
        <source>Release %1</source>
        <translation>%1 elemanını ayır</translation>
    </message>
    <message>
        <source>Engage %1</source>
        <translation>%1 elemanını devreye al</translation>
    </message>
    <message>
        <source>Take %1 off</source>
        <translation>%1 elemanını kaldır</translation>
    </message>
    <message>
        <source>Hold it with a brake</source>
        <translation>Frenle tut</translation>
    </message>
    <message>
        <source>Connect it to another link with a clutch</source>
        <translation>Kavrama ile başka bir uzva bağla</translation>
    </message>
    <message>
        <source>select two links</source>
        <translation>iki uzuv seçin</translation>
    </message>
    <message>
        <source>Connect %1 and %2 with a clutch</source>
        <translation>%1 ve %2 uzuvlarını kavrama ile bağla</translation>
    </message>
    <message>
        <source>hold the link with a brake</source>
        <translation>uzvu frenle tutun</translation>
    </message>
    <message>
        <source>Move gear %1 to the other side of the apex</source>
        <translation>%1 dişlisini koni tepesinin öbür yanına taşı</translation>
    </message>
    <message>
        <source>Make it external</source>
        <translation>Dış dişli yap</translation>
    </message>
    <message>
        <source>Make it internal</source>
        <translation>İç dişli yap</translation>
    </message>
    <message>
        <source>Pin the module</source>
        <translation>Modülü sabitle</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Yeniden adlandır</translation>
    </message>
    <message>
        <source>Stop driving it</source>
        <translation>Tahriki kaldır</translation>
    </message>
    <message>
        <source>Drive it</source>
        <translation>Tahrik et</translation>
    </message>
    <message>
        <source>Make it the ground</source>
        <translation>Sabit uzuv yap</translation>
    </message>
    <message>
        <source>it is the ground</source>
        <translation>bu sabit uzuvdur</translation>
    </message>
    <message>
        <source>Attach a gear</source>
        <translation>Dişli ekle</translation>
    </message>
    <message>
        <source>Pin the teeth of its gears</source>
        <translation>Dişlilerinin diş sayılarını sabitle</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>the ground cannot be deleted</source>
        <translation>sabit uzuv silinemez</translation>
    </message>
    <message>
        <source>Axis %1 pinned</source>
        <translation>%1 ekseni sabitlendi</translation>
    </message>
    <message>
        <source>only turning joints can be driven</source>
        <translation>yalnızca döner mafsallar tahrik edilebilir</translation>
    </message>
    <message>
        <source>Flip the arrow</source>
        <translation>Oku ters çevir</translation>
    </message>
    <message>
        <source>Delete with its joints</source>
        <translation>Mafsallarıyla birlikte sil</translation>
    </message>
    <message>
        <source>New link here</source>
        <translation>Buraya yeni uzuv</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tümünü seç</translation>
    </message>
    <message>
        <source>Tidy the drawing</source>
        <translation>Çizimi düzenle</translation>
    </message>
    <message>
        <source>nothing is drawn yet</source>
        <translation>henüz bir şey çizilmedi</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Sığdır</translation>
    </message>
    <message>
        <source>Take it off</source>
        <translation>Kaldır</translation>
    </message>
    <message>
        <source>Cycle C%1:</source>
        <translation>C%1 çevrimi:</translation>
    </message>
    <message>
        <source>Digraph</source>
        <translation>Yönlü graf</translation>
    </message>
    <message>
        <source>Laying out %1 links</source>
        <translation>%1 uzuv yerleştiriliyor</translation>
    </message>
    <message>
        <source>No gear can be attached: %1.</source>
        <translation>Dişli eklenemiyor: %1.</translation>
    </message>
    <message>
        <source>Select one turning joint or link to load it.</source>
        <translation>Yüklemek için bir döner mafsal veya uzuv seçin.</translation>
    </message>
    <message>
        <source>The ground takes any load: select a moving link.</source>
        <translation>Sabit uzuv her yükü taşır: hareketli bir uzuv seçin.</translation>
    </message>
    <message>
        <source>Loads act in turning joints and on links.</source>
        <translation>Yükler döner mafsallara ve uzuvlara etkir.</translation>
    </message>
    <message>
        <source>10 Nm</source>
        <translation>10 Nm</translation>
    </message>
    <message>
        <source>Torque that acts here</source>
        <translation>Buraya etkiyen tork</translation>
    </message>
    <message>
        <source>Remove load</source>
        <translation>Yükü kaldır</translation>
    </message>
    <message>
        <source>A torque is a number with its unit: 10 Nm, 500 Nmm, 1/2 kNm</source>
        <translation>Tork, birimli bir sayıdır: 10 Nm, 500 Nmm, 1/2 kNm</translation>
    </message>
    <message>
        <source>Set load</source>
        <translation>Yükü belirle</translation>
    </message>
    <message>
        <source>Add load</source>
        <translation>Yük ekle</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 sil</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>%1 ters çevir</translation>
    </message>
    <message>
        <source>Cannot be driven: %1</source>
        <translation>Tahrik edilemez: %1</translation>
    </message>
    <message>
        <source>Drive or release</source>
        <translation>Tahriki aç veya kapat</translation>
    </message>
    <message>
        <source>Rename link</source>
        <translation>Uzvu yeniden adlandır</translation>
    </message>
    <message>
        <source>No gear can be attached: %1</source>
        <translation>Dişli eklenemiyor: %1</translation>
    </message>
    <message>
        <source>Attach gear to %1</source>
        <translation>%1 uzvuna dişli ekle</translation>
    </message>
    <message>
        <source>Make ground</source>
        <translation>Sabit uzuv yap</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>%1 sabitle</translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>%1 serbest bırak</translation>
    </message>
    <message>
        <source>Change kind</source>
        <translation>Türü değiştir</translation>
    </message>
    <message>
        <source>Move gear to the other side</source>
        <translation>Dişliyi öbür yana taşı</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>%1 tut</translation>
    </message>
    <message>
        <source>Connect links</source>
        <translation>Uzuvları bağla</translation>
    </message>
    <message>
        <source>Take off %1</source>
        <translation>%1 kaldır</translation>
    </message>
    <message>
        <source>%1:  %2,  transfer vertex %3</source>
        <translation>%1:  %2,  aktarma düğümü %3</translation>
    </message>
    <message>
        <source>The drawn pose does not tell the sign of its terminal equation.</source>
        <translation>Çizilen konum uç denkleminin işaretini belirlemiyor.</translation>
    </message>
    <message>
        <source>Draw the first link: L, then click</source>
        <translation>İlk uzvu çizin: L, sonra tıklayın</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>Name of the link</source>
        <translation>Uzvun adı</translation>
    </message>
    <message>
        <source>Move link</source>
        <translation>Uzvu taşı</translation>
    </message>
    <message>
        <source>Move links</source>
        <translation>Uzuvları taşı</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Az kaydır</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Uzuv ekle</translation>
    </message>
    <message>
        <source>Add gear mesh</source>
        <translation>Dişli çifti ekle</translation>
    </message>
    <message>
        <source>Add turning joint</source>
        <translation>Döner mafsal ekle</translation>
    </message>
    <message>
        <source>T-T graph</source>
        <translation>T-T grafı</translation>
    </message>
    <message>
        <source>The T–T graph is still being laid out. Try again in a moment.</source>
        <translation>T–T grafı hâlâ yerleştiriliyor. Biraz sonra yeniden deneyin.</translation>
    </message>
    <message>
        <source>No tree yet: turning joints have to tie every link to the ground and close no loop.</source>
        <translation>Henüz ağaç yok: döner mafsallar her uzvu sabit uzva bağlamalı ve çevrim kapatmamalıdır.</translation>
    </message>
    <message>
        <source>Then the dotted meshes get their transfer vertices.</source>
        <translation>O zaman noktalı dişli çiftleri aktarma düğümlerini alır.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Ve %1 tane daha.</translation>
    </message>
    <message>
        <source>Transfer vertex of %1</source>
        <translation>%1 için aktarma düğümü</translation>
    </message>
    <message>
        <source>Branch %1 on level %2</source>
        <translation>%2 düzeyinde %1 dalı</translation>
    </message>
    <message>
        <source>It has no transfer vertex.</source>
        <translation>Aktarma düğümü yok.</translation>
    </message>
    <message>
        <source>Tidy the T-T graph</source>
        <translation>T-T grafını düzenle</translation>
    </message>
    <message>
        <source>The derivation could not be worked out: %1</source>
        <translation>Türetim yapılamadı: %1</translation>
    </message>
    <message>
        <source>The derivation appears here, both methods step by step.</source>
        <translation>Türetim burada, iki yöntemle adım adım görünür.</translation>
    </message>
    <message>
        <source>The sections of the derivation</source>
        <translation>Türetimin bölümleri</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Dışa aktar…</translation>
    </message>
    <message>
        <source>Write the derivation as a web page, PDF, LaTeX or Markdown</source>
        <translation>Türetimi web sayfası, PDF, LaTeX veya Markdown olarak yaz</translation>
    </message>
    <message>
        <source>The derivation is being worked out…</source>
        <translation>Türetim hazırlanıyor…</translation>
    </message>
    <message>
        <source>Copy equation as LaTeX</source>
        <translation>Denklemi LaTeX olarak kopyala</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Metni kopyala</translation>
    </message>
    <message>
        <source>Copy all as LaTeX</source>
        <translation>Tümünü LaTeX olarak kopyala</translation>
    </message>
    <message>
        <source>Copy all as Markdown</source>
        <translation>Tümünü Markdown olarak kopyala</translation>
    </message>
    <message>
        <source>Before the first step</source>
        <translation>İlk adımdan önce</translation>
    </message>
    <message>
        <source>%1 (saved)</source>
        <translation>%1 (kaydedildi)</translation>
    </message>
    <message>
        <source>%1, shown now</source>
        <translation>%1, şimdi gösterilen</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, geri alındı</translation>
    </message>
    <message>
        <source>The dynamics could not be worked out: %1</source>
        <translation>Dinamik hesaplanamadı: %1</translation>
    </message>
    <message>
        <source>Masses</source>
        <translation>Kütleler</translation>
    </message>
    <message>
        <source>Mass and moments of inertia of every link, density and gravity</source>
        <translation>Her uzvun kütlesi ve atalet momentleri, yoğunluk ve yerçekimi</translation>
    </message>
    <message>
        <source>Inertia at the motors</source>
        <translation>Motorlardaki atalet</translation>
    </message>
    <message>
        <source>How much of the inertia that each motor feels every link makes up (reflected inertia)</source>
        <translation>Her motorun hissettiği atalette her uzvun payı (indirgenmiş atalet)</translation>
    </message>
    <message>
        <source>Equation of motion</source>
        <translation>Hareket denklemi</translation>
    </message>
    <message>
        <source>Generalised inertia, Coriolis and centrifugal torques, weight and loads in the inputs</source>
        <translation>Girişlerde genelleştirilmiş atalet, Coriolis ve merkezkaç torkları, ağırlık ve yükler</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Hareket</translation>
    </message>
    <message>
        <source>The motion that torques of the motors cause: simulated and played</source>
        <translation>Motor torklarının oluşturduğu hareket: benzetilir ve oynatılır</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopyala</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Tabloyu hesap tablosu için kopyala</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Export the table, or the simulated motion, to a CSV file</source>
        <translation>Tabloyu veya benzetilen hareketi CSV dosyasına aktar</translation>
    </message>
    <message>
        <source>Masses and motion appear here as soon as the mechanism is analysed.</source>
        <translation>Mekanizma çözümlenince kütleler ve hareket burada görünür.</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: state masses of its links, or give its wheels teeth.</source>
        <translation>Girişlerin hareketi hiçbir kütleyi hareket ettirmiyor: uzuvlara kütle veya dişlilere diş sayısı verin.</translation>
    </message>
    <message>
        <source>At the moment that the 3D view shows.</source>
        <translation>3B görünümün gösterdiği anda.</translation>
    </message>
    <message>
        <source>There is nothing to copy yet</source>
        <translation>Henüz kopyalanacak bir şey yok</translation>
    </message>
    <message>
        <source>There is nothing to export yet</source>
        <translation>Henüz dışa aktarılacak bir şey yok</translation>
    </message>
    <message>
        <source>masses.csv</source>
        <translation>kutleler.csv</translation>
    </message>
    <message>
        <source>reflected-inertia.csv</source>
        <translation>indirgenmis-atalet.csv</translation>
    </message>
    <message>
        <source>equation-of-motion.csv</source>
        <translation>hareket-denklemi.csv</translation>
    </message>
    <message>
        <source>motion.csv</source>
        <translation>hareket.csv</translation>
    </message>
    <message>
        <source>M: the generalised inertia of the inputs. h: what motors have to give at constant speeds, for Coriolis and centrifugal forces and for weight. τ: torques of the motors. ℓ: what the loads contribute.</source>
        <translation>M: girişlerin genelleştirilmiş ataleti. h: sabit hızda motorların Coriolis ve merkezkaç kuvvetleri ile ağırlık için vermesi gereken. τ: motor torkları. ℓ: yüklerin katkısı.</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>%1 mafsalı</translation>
    </message>
    <message>
        <source>Link %1: %2 kg m² at %3, %4 % of all.</source>
        <translation>%1 uzvu: %3 için %2 kg m², toplamın %4 %&apos;si.</translation>
    </message>
    <message>
        <source>moves no mass</source>
        <translation>kütle hareket ettirmiyor</translation>
    </message>
    <message>
        <source>%1 kg m²</source>
        <translation>%1 kg m²</translation>
    </message>
    <message>
        <source>The inertia that each link has at the motor while the other inputs stand still: for a link that turns about one axis its moment of inertia times the square of its ratio.</source>
        <translation>Öbür girişler dururken her uzvun motordaki ataleti: tek eksen etrafında dönen bir uzuv için atalet momenti çarpı oranının karesi.</translation>
    </message>
    <message>
        <source>Double-click, or press F2, to state it; empty it to leave it to the solids.</source>
        <translation>Belirtmek için çift tıklayın veya F2&apos;ye basın; katılardan hesaplanması için boş bırakın.</translation>
    </message>
    <message>
        <source>Mass, kg</source>
        <translation>Kütle, kg</translation>
    </message>
    <message>
        <source>A mass is at least 0 kg.</source>
        <translation>Kütle en az 0 kg&apos;dır.</translation>
    </message>
    <message>
        <source>Masses of the links</source>
        <translation>Uzuvların kütleleri</translation>
    </message>
    <message>
        <source>The density of all solids, kg/m³; empty: that of steel</source>
        <translation>Bütün katıların yoğunluğu, kg/m³; boş: çelik</translation>
    </message>
    <message>
        <source>Density, kg/m³</source>
        <translation>Yoğunluk, kg/m³</translation>
    </message>
    <message>
        <source>%1, steel</source>
        <translation>%1, çelik</translation>
    </message>
    <message>
        <source>The acceleration of free fall in the base frame, m/s²: x, y, z</source>
        <translation>Temel eksen takımında yerçekimi ivmesi, m/s²: x, y, z</translation>
    </message>
    <message>
        <source>Gravity, m/s²</source>
        <translation>Yerçekimi, m/s²</translation>
    </message>
    <message>
        <source>A density is above 0.</source>
        <translation>Yoğunluk 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>Set density</source>
        <translation>Yoğunluğu belirle</translation>
    </message>
    <message>
        <source>Set gravity</source>
        <translation>Yerçekimini belirle</translation>
    </message>
    <message>
        <source>Set mass</source>
        <translation>Kütleyi belirle</translation>
    </message>
    <message>
        <source>The motion could not be followed: %1</source>
        <translation>Hareket izlenemedi: %1</translation>
    </message>
    <message>
        <source>How much of the motion is followed</source>
        <translation>Hareketin ne kadarının izlendiği</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Hızlar</translation>
    </message>
    <message>
        <source>Speeds of the inputs, and of the joints that are selected, over time</source>
        <translation>Girişlerin ve seçili mafsalların zamana göre hızları</translation>
    </message>
    <message>
        <source>Torques</source>
        <translation>Torklar</translation>
    </message>
    <message>
        <source>Torques of the motors over time</source>
        <translation>Motor torkları, zamana göre</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Enerji</translation>
    </message>
    <message>
        <source>Kinetic and potential energy, the work of motors and loads, and their balance, over time</source>
        <translation>Kinetik ve potansiyel enerji, motorların ve yüklerin işi ve dengesi, zamana göre</translation>
    </message>
    <message>
        <source>Play in 3D</source>
        <translation>3B&apos;de oynat</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Durdur</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Benzet</translation>
    </message>
    <message>
        <source>End the motion where it is now</source>
        <translation>Hareketi burada bitir</translation>
    </message>
    <message>
        <source>Follow the motion that these torques, the loads and weight cause</source>
        <translation>Bu torkların, yüklerin ve ağırlığın oluşturduğu hareketi izle</translation>
    </message>
    <message>
        <source>There is nothing to move yet</source>
        <translation>Henüz hareket edecek bir şey yok</translation>
    </message>
    <message>
        <source>Show this motion in the 3D view instead of that of the input speeds</source>
        <translation>3B görünümde giriş hızlarınınki yerine bu hareketi göster</translation>
    </message>
    <message>
        <source>Simulate a motion first</source>
        <translation>Önce bir hareket benzetin</translation>
    </message>
    <message>
        <source>Give the motors their torques, then Simulate: speeds, torques and energy appear here.</source>
        <translation>Motorlara torklarını verin, sonra Benzet&apos;e basın: hızlar, torklar ve enerji burada görünür.</translation>
    </message>
    <message>
        <source>The motion is being followed …</source>
        <translation>Hareket izleniyor …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Durduruldu.</translation>
    </message>
    <message>
        <source>After %1 s: kinetic energy %2 J, potential %3 J, work of motors and loads %4 J; they balance but for %5 J.</source>
        <translation>%1 s sonra: kinetik enerji %2 J, potansiyel %3 J, motorların ve yüklerin işi %4 J; denge farkı %5 J.</translation>
    </message>
    <message>
        <source>input</source>
        <translation>giriş</translation>
    </message>
    <message>
        <source>The joint that the motor drives.</source>
        <translation>Motorun tahrik ettiği mafsal.</translation>
    </message>
    <message>
        <source>T, N m</source>
        <translation>T, N m</translation>
    </message>
    <message>
        <source>The torque of the motor at rest, by the tail of its joint on the head.</source>
        <translation>Motorun dururken torku, mafsalın kuyruğundan başına.</translation>
    </message>
    <message>
        <source>d, N m s</source>
        <translation>d, N m s</translation>
    </message>
    <message>
        <source>How much torque the motor loses for each rad/s of its joint: with the torque at rest over the no-load speed it is a direct-current motor at constant voltage.</source>
        <translation>Mafsalın her rad/s&apos;si için motorun yitirdiği tork: durma torku bölü boşta hız ile sabit gerilimli bir doğru akım motorudur.</translation>
    </message>
    <message>
        <source>from, °</source>
        <translation>baş., °</translation>
    </message>
    <message>
        <source>The angle of the joint at the start, from the reference pose.</source>
        <translation>Başlangıçta mafsalın referans konumdan açısı.</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>The speed of the joint at the start.</source>
        <translation>Mafsalın başlangıçtaki hızı.</translation>
    </message>
    <message>
        <source>How long the motion is followed, in seconds.</source>
        <translation>Hareketin saniye olarak ne kadar izleneceği.</translation>
    </message>
    <message>
        <source>for, s</source>
        <translation>süre, s</translation>
    </message>
    <message>
        <source>The time is %1 s to %2 s.</source>
        <translation>Süre %1 s ile %2 s arasıdır.</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>%1 mafsalı</translation>
    </message>
    <message>
        <source>Torque of the motor of joint %1, N m</source>
        <translation>%1 mafsalının motor torku, N m</translation>
    </message>
    <message>
        <source>Torque that the motor of joint %1 loses for each rad/s, N m s</source>
        <translation>%1 mafsalı motorunun her rad/s için yitirdiği tork, N m s</translation>
    </message>
    <message>
        <source>Angle of joint %1 at the start, degrees</source>
        <translation>%1 mafsalının başlangıç açısı, derece</translation>
    </message>
    <message>
        <source>Speed of joint %1 at the start, rad/s</source>
        <translation>%1 mafsalının başlangıç hızı, rad/s</translation>
    </message>
    <message>
        <source>It is at least 0 N m s.</source>
        <translation>En az 0 N m s&apos;dir.</translation>
    </message>
    <message>
        <source>Torque, rate and power in every turning joint, and of what acts on links</source>
        <translation>Her döner mafsalda ve uzuvlara etkiyenlerde tork, hız ve güç</translation>
    </message>
    <message>
        <source>Torques of the brakes and clutches that are engaged</source>
        <translation>Devredeki fren ve kavramaların torkları</translation>
    </message>
    <message>
        <source>Torques on the gears of every mesh, tooth forces, and the power that it passes</source>
        <translation>Her dişli çiftinin dişlilerindeki torklar, diş kuvvetleri ve ilettiği güç</translation>
    </message>
    <message>
        <source>What holds each link in its turning joint: force and moment</source>
        <translation>Her uzvu döner mafsalında tutan: kuvvet ve moment</translation>
    </message>
    <message>
        <source>What every element delivers to each of its links, seen from the ground</source>
        <translation>Her öğenin sabit uzuvdan bakıldığında uzuvlarının her birine verdiği</translation>
    </message>
    <message>
        <source>Power that goes round in loops, beside what goes through the train</source>
        <translation>Dişli takımından geçenin yanında çevrimlerde dolaşan güç</translation>
    </message>
    <message>
        <source>Torques of the couplings and efficiency in every state of the gearbox</source>
        <translation>Şanzımanın her durumunda fren ve kavrama torkları ile verim</translation>
    </message>
    <message>
        <source>The torques could not be worked out: %1</source>
        <translation>Torklar hesaplanamadı: %1</translation>
    </message>
    <message>
        <source>The state whose brakes and clutches are engaged</source>
        <translation>Fren ve kavramaları devrede olan durum</translation>
    </message>
    <message>
        <source>Export the table with its units to a CSV file</source>
        <translation>Tabloyu birimleriyle CSV dosyasına aktar</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kuvvetler</translation>
    </message>
    <message>
        <source>none</source>
        <translation>yok</translation>
    </message>
    <message>
        <source>An efficiency is above 0 and at most 1.</source>
        <translation>Verim 0&apos;dan büyük ve en çok 1&apos;dir.</translation>
    </message>
    <message>
        <source>η of a mesh</source>
        <translation>bir dişli çiftinin η&apos;sı</translation>
    </message>
    <message>
        <source>The efficiency of meshes that state none: the power that a mesh delivers over what it takes, seen from its carrier. Empty: they lose nothing.</source>
        <translation>Kendi verimi verilmemiş dişli çiftlerinin verimi: taşıyıcıdan bakıldığında verilen güç bölü alınan güç. Boş: kayıpsız.</translation>
    </message>
    <message>
        <source>fed, W</source>
        <translation>verilen, W</translation>
    </message>
    <message>
        <source>The power that loads and balances feed into the train.</source>
        <translation>Yüklerin ve dengelerin dişli takımına verdiği güç.</translation>
    </message>
    <message>
        <source>taken, W</source>
        <translation>alınan, W</translation>
    </message>
    <message>
        <source>The power that loads and balances take from the train.</source>
        <translation>Yüklerin ve dengelerin dişli takımından aldığı güç.</translation>
    </message>
    <message>
        <source>lost, W</source>
        <translation>kayıp, W</translation>
    </message>
    <message>
        <source>What the meshes lose: fed less taken.</source>
        <translation>Dişli çiftlerinin yitirdiği: verilen eksi alınan.</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>verim</translation>
    </message>
    <message>
        <source>Power taken over power fed.</source>
        <translation>Alınan güç bölü verilen güç.</translation>
    </message>
    <message>
        <source>backward</source>
        <translation>geri</translation>
    </message>
    <message>
        <source>The efficiency of the same motion with all known torques reversed: the output drives.</source>
        <translation>Bilinen bütün torklar ters çevrildiğinde aynı hareketin verimi: çıkış tahrik eder.</translation>
    </message>
    <message>
        <source>latent ratio</source>
        <translation>gizli güç oranı</translation>
    </message>
    <message>
        <source>What all meshes pass, seen from their carriers, over the power fed: the losses are about this many times those of one mesh.</source>
        <translation>Bütün dişli çiftlerinin taşıyıcılarından görülen gücü bölü verilen güç: kayıplar tek çiftinkinin yaklaşık bu katıdır.</translation>
    </message>
    <message>
        <source>circulating, W</source>
        <translation>dolaşan, W</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop of shafts and gear sets.</source>
        <translation>Millerden ve dişli takımlarından oluşan bir çevrimde dolaşan en büyük güç.</translation>
    </message>
    <message>
        <source>Share by stiffness</source>
        <translation>Rijitliğe göre paylaştır</translation>
    </message>
    <message>
        <source>Meshes that share a load in unknown parts: assume that all teeth are equally stiff, without clearance, on rigid bodies</source>
        <translation>Bir yükü bilinmeyen paylarla taşıyan dişli çiftleri: bütün dişleri eşit rijitlikte, boşluksuz ve rijit cisimler üzerinde kabul et</translation>
    </message>
    <message>
        <source>as engaged</source>
        <translation>devredeki gibi</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>%1 durumu</translation>
    </message>
    <message>
        <source>Torques and forces appear here as soon as the mechanism is analysed.</source>
        <translation>Mekanizma çözümlenince torklar ve kuvvetler burada görünür.</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: their torques appear here.</source>
        <translation>Döner mafsallar ve dişli çiftleri çizin: torkları burada görünür.</translation>
    </message>
    <message>
        <source>There is no equilibrium: the reason is below.</source>
        <translation>Denge yok: nedeni aşağıda.</translation>
    </message>
    <message>
        <source>No brake or clutch is engaged: engage one in Gearbox, or choose a state.</source>
        <translation>Devrede fren veya kavrama yok: Şanzıman&apos;da birini devreye alın veya bir durum seçin.</translation>
    </message>
    <message>
        <source>Forces need a unit of length whose size is known.</source>
        <translation>Kuvvetler, büyüklüğü bilinen bir uzunluk birimi gerektirir.</translation>
    </message>
    <message>
        <source>No power flows.</source>
        <translation>Güç akışı yok.</translation>
    </message>
    <message>
        <source>Without a motion there is no power.</source>
        <translation>Hareket yoksa güç de yoktur.</translation>
    </message>
    <message>
        <source>No power circulates.</source>
        <translation>Dolaşan güç yok.</translation>
    </message>
    <message>
        <source>Loops are found where every link but the planets turns on the ground.</source>
        <translation>Çevrimler, gezegenler dışında her uzuv sabit uzuvda döndüğünde bulunur.</translation>
    </message>
    <message>
        <source>There is nothing to show.</source>
        <translation>Gösterilecek bir şey yok.</translation>
    </message>
    <message>
        <source>The two methods do not agree</source>
        <translation>İki yöntem uyuşmuyor</translation>
    </message>
    <message>
        <source>locks itself</source>
        <translation>kendini kilitler</translation>
    </message>
    <message>
        <source>No load acts yet. Select a joint or a link, then + Load.</source>
        <translation>Henüz yük yok. Bir mafsal veya uzuv seçin, sonra + Yük.</translation>
    </message>
    <message>
        <source>+ Load</source>
        <translation>+ Yük</translation>
    </message>
    <message>
        <source>A torque of 1 N m on the selected joint or link, or choose one</source>
        <translation>Seçili mafsala veya uzva 1 N m tork, ya da seçin</translation>
    </message>
    <message>
        <source>Found at ▾</source>
        <translation>Bulunacak yer ▾</translation>
    </message>
    <message>
        <source>Balances: where torques are found that hold the loads. By itself the program takes the inputs that bear no load of their own.</source>
        <translation>Dengeler: yükleri tutan torkların bulunduğu yerler. Program kendiliğinden, yükü olmayan girişleri alır.</translation>
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
        <translation>Bu listedeki torkların birimi; belge N m&apos;yi korur</translation>
    </message>
    <message>
        <source>F on %1</source>
        <translation>%1 üzerinde F</translation>
    </message>
    <message>
        <source>T in %1</source>
        <translation>%1 içinde T</translation>
    </message>
    <message>
        <source>T on %1 about %2</source>
        <translation>%2 etrafında %1 üzerinde T</translation>
    </message>
    <message>
        <source>T on %1</source>
        <translation>%1 üzerinde T</translation>
    </message>
    <message>
        <source>A force from outside on the link, N, in the base frame, at (%1) of the reference pose.</source>
        <translation>Uzva dıştan etkiyen kuvvet, N, temel eksen takımında, referans konumun (%1) noktasında.</translation>
    </message>
    <message>
        <source>A torque that the joint&apos;s tail exerts on its head, about the direction of its axis; the head exerts the opposite one on the tail.</source>
        <translation>Mafsal kuyruğunun başına, eksen yönü etrafında uyguladığı tork; baş da kuyruğa tersini uygular.</translation>
    </message>
    <message>
        <source>A torque from outside on the link; the ground takes the reaction. Without an axis it is about the link&apos;s first axis on the way to the ground.</source>
        <translation>Uzva dıştan etkiyen tork; tepkisini sabit uzuv alır. Eksen verilmezse uzvun sabit uzva giden yoldaki ilk ekseni etrafındadır.</translation>
    </message>
    <message>
        <source>%1 of %2 loads are listed</source>
        <translation>%2 yükten %1 tanesi listelendi</translation>
    </message>
    <message>
        <source>Remove this load</source>
        <translation>Bu yükü kaldır</translation>
    </message>
    <message>
        <source>Torque in a joint</source>
        <translation>Mafsalda tork</translation>
    </message>
    <message>
        <source>Torque on a link</source>
        <translation>Uzuvda tork</translation>
    </message>
    <message>
        <source>Inputs without a load</source>
        <translation>Yüksüz girişler</translation>
    </message>
    <message>
        <source>Choose balances</source>
        <translation>Dengeleri seç</translation>
    </message>
    <message>
        <source>Select in the drawing, or type: 8, 10</source>
        <translation>Çizimde seçin veya yazın: 8, 10</translation>
    </message>
    <message>
        <source>A whole number, a fraction such as −2/3, or a decimal</source>
        <translation>Tam sayı, −2/3 gibi kesir veya ondalık sayı</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Başla</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Dersler</translation>
    </message>
    <message>
        <source>From one gear pair to the robot</source>
        <translation>Tek dişli çiftinden robota</translation>
    </message>
    <message>
        <source>Open a lesson file…</source>
        <translation>Ders dosyası aç…</translation>
    </message>
    <message>
        <source>A lesson of your own: it is reloaded whenever the file is saved</source>
        <translation>Kendi dersiniz: dosya her kaydedildiğinde yeniden yüklenir</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 dk</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 / %2 puan</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>adım %1 / %2</translation>
    </message>
    <message>
        <source>Afterwards you can %1.</source>
        <translation>Sonunda şunu yapabilirsiniz: %1.</translation>
    </message>
    <message>
        <source>%1 lessons, %2 min. %3 done, about %4 min to go.</source>
        <translation>%1 ders, %2 dk. %3 bitti, yaklaşık %4 dk kaldı.</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Tekrarla</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Sürdür</translation>
    </message>
    <message>
        <source>%1 of %2 steps done</source>
        <translation>%2 adımdan %1 tanesi bitti</translation>
    </message>
    <message>
        <source>‹ Back</source>
        <translation>‹ Geri</translation>
    </message>
    <message>
        <source>The step before (Alt+Left)</source>
        <translation>Önceki adım (Alt+Sol)</translation>
    </message>
    <message>
        <source>Skip ›</source>
        <translation>Atla ›</translation>
    </message>
    <message>
        <source>The next step (Alt+Right)</source>
        <translation>Sonraki adım (Alt+Sağ)</translation>
    </message>
    <message>
        <source>‹ Course</source>
        <translation>‹ Kurs</translation>
    </message>
    <message>
        <source>All lessons, with your progress</source>
        <translation>İlerlemenizle birlikte bütün dersler</translation>
    </message>
    <message>
        <source>2 points for a step that is right at once, 1 after a hint or a correction; the score never falls</source>
        <translation>İlk seferde doğru adıma 2, ipucu veya düzeltmeden sonra 1 puan; puan hiç düşmez</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>İ&amp;pucu</translation>
    </message>
    <message>
        <source>Where to look, then the rule, then the first half</source>
        <translation>Nereye bakılacağı, sonra kural, sonra ilk yarısı</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Göster</translation>
    </message>
    <message>
        <source>The answer; the step then gives no points</source>
        <translation>Yanıt; o zaman adım puan vermez</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Denetle</translation>
    </message>
    <message>
        <source>Check the answer (Return)</source>
        <translation>Yanıtı denetle (Enter)</translation>
    </message>
    <message>
        <source>Begin the step</source>
        <translation>Adıma başla</translation>
    </message>
    <message>
        <source>Right. %1</source>
        <translation>Doğru. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) are wrong: look at those that are framed.</source>
        <translation>
            <numerusform>%n alan yanlış: çerçevelilere bakın.</numerusform>
        </translation>
    </message>
    <message>
        <source>This is not right. A hint tells where to look.</source>
        <translation>Bu doğru değil. Bir ipucu nereye bakacağınızı söyler.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>Gösterildi: %1</translation>
    </message>
    <message>
        <source>%1, %2 min</source>
        <translation>%1, %2 dk</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Adım %1 / %2</translation>
    </message>
    <message>
        <source>Score %1 of %2</source>
        <translation>Puan %1 / %2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Bitir</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>İleri</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Yeniden dene</translation>
    </message>
    <message>
        <source>Where to look, then the rule: hint %1 of %2</source>
        <translation>Nereye bakılacağı, sonra kural: ipucu %1 / %2</translation>
    </message>
    <message>
        <source>There are no more hints in this step.</source>
        <translation>Bu adımda başka ipucu yok.</translation>
    </message>
    <message>
        <source>A drawing can be right in many ways: take a hint.</source>
        <translation>Bir çizim birçok biçimde doğru olabilir: ipucu alın.</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>Bu ilk adımdır.</translation>
    </message>
    <message>
        <source>Next lesson ›</source>
        <translation>Sonraki ders ›</translation>
    </message>
    <message>
        <source>Next ›</source>
        <translation>İleri ›</translation>
    </message>
    <message>
        <source>Leave ›</source>
        <translation>Çık ›</translation>
    </message>
    <message>
        <source>About GearGraph</source>
        <translation>GearGraph hakkında</translation>
    </message>
    <message>
        <source>&lt;b&gt;GearGraph %1&lt;/b&gt;&lt;p&gt;Draw, analyse and see geared mechanisms by the matroid and the T–T graph methods (Amirinezhad and Uyguroğlu, 2014).&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;GearGraph %1&lt;/b&gt;&lt;p&gt;Dişli mekanizmaları matroid ve T–T grafı yöntemleriyle çizin, çözümleyin ve görün (Amirinezhad ve Uyguroğlu, 2014).&lt;/p&gt;&lt;p&gt;MIT lisansı.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Ayrıntıları kopyala</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopyalandı</translation>
    </message>
    <message>
        <source>Crash report</source>
        <translation>Çökme raporu</translation>
    </message>
    <message>
        <source>GearGraph crashed on %1. A report says where in the program; it names neither documents nor what is in them.</source>
        <translation>GearGraph %1 tarihinde çöktü. Bir rapor programın neresinde olduğunu söyler; belgeleri veya içeriklerini yazmaz.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Raporu göster</translation>
    </message>
    <message>
        <source>Read it, and decide then</source>
        <translation>Önce okuyun, sonra karar verin</translation>
    </message>
    <message>
        <source>For a message to the developers</source>
        <translation>Geliştiricilere ileti için</translation>
    </message>
    <message>
        <source>The crash report was copied.</source>
        <translation>Çökme raporu kopyalandı.</translation>
    </message>
    <message>
        <source>For good</source>
        <translation>Kalıcı olarak</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Sonra</translation>
    </message>
    <message>
        <source>It will be offered again</source>
        <translation>Yeniden önerilecek</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Virgül</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>Noktalı virgül</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Sekme</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Nokta</translation>
    </message>
    <message>
        <source>Labels of rows and columns</source>
        <translation>Satır ve sütun etiketleri</translation>
    </message>
    <message>
        <source>Byte order mark</source>
        <translation>Bayt sırası imi (BOM)</translation>
    </message>
    <message>
        <source>Export %1 as CSV</source>
        <translation>%1 matrisini CSV olarak dışa aktar</translation>
    </message>
    <message>
        <source>What parts the columns</source>
        <translation>Sütunları ayıran</translation>
    </message>
    <message>
        <source>Numbers with a decimal comma are quoted where commas part the columns</source>
        <translation>Sütunlar virgülle ayrılıyorsa ondalık virgüllü sayılar tırnak içine alınır</translation>
    </message>
    <message>
        <source>Without them the file holds the entries alone</source>
        <translation>Onlarsız dosyada yalnız öğeler bulunur</translation>
    </message>
    <message>
        <source>Begins the file with a mark by which spreadsheet programs know UTF-8</source>
        <translation>Dosyayı, hesap tablosu programlarının UTF-8&apos;i tanıdığı bir imle başlatır</translation>
    </message>
    <message>
        <source>Columns parted by</source>
        <translation>Sütun ayırıcı</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Ondalık işareti</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 okunuyor …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>İptal</translation>
    </message>
    <message>
        <source>The clipboard holds no links: %1</source>
        <translation>Panoda uzuv yok: %1</translation>
    </message>
    <message>
        <source>Select links to copy; the ground stays where it is.</source>
        <translation>Kopyalanacak uzuvları seçin; sabit uzuv yerinde kalır.</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>%1 kopyalandı</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 uzuv</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 uzuv</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Kes</translation>
    </message>
    <message>
        <source>The clipboard is empty.</source>
        <translation>Pano boş.</translation>
    </message>
    <message>
        <source>The clipboard holds no links.</source>
        <translation>Panoda uzuv yok.</translation>
    </message>
    <message>
        <source>What the clipboard holds is too large to be a mechanism.</source>
        <translation>Panodaki, mekanizma olamayacak kadar büyük.</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Yapıştır</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Çoğalt</translation>
    </message>
    <message>
        <source>Pasted as it was drawn in %1: check the lengths, which count in %2 here.</source>
        <translation>%1 biriminde çizildiği gibi yapıştırıldı: burada %2 olarak sayılan uzunlukları denetleyin.</translation>
    </message>
    <message>
        <source>Make %1 planets</source>
        <translation>%1 gezegen yap</translation>
    </message>
    <message>
        <source>Insert %1</source>
        <translation>%1 yerleştir</translation>
    </message>
    <message>
        <source>Exporting %1.</source>
        <translation>%1 dışa aktarılıyor.</translation>
    </message>
    <message>
        <source>Give up this export; nothing is written</source>
        <translation>Bu dışa aktarmayı bırak; hiçbir şey yazılmaz</translation>
    </message>
    <message>
        <source>Exporting %1: %2 of %3 pictures.</source>
        <translation>%1 dışa aktarılıyor: %3 resimden %2.</translation>
    </message>
    <message>
        <source>The export of %1 was stopped; nothing was written.</source>
        <translation>%1 dışa aktarımı durduruldu; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>GearGraph documents (*.geargraph);;All files (*)</source>
        <translation>GearGraph belgeleri (*.geargraph);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Geçmiş</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Geçmişin adımları</translation>
    </message>
    <message>
        <source>A click on a step, or Return, goes there. Steps below it can be repeated until something else is drawn.</source>
        <translation>Bir adıma tıklama veya Enter oraya gider. Aşağıdaki adımlar, başka bir şey çizilene dek yinelenebilir.</translation>
    </message>
    <message>
        <source>The gears appear here. Draw the first link: L, then click.</source>
        <translation>Dişliler burada görünür. İlk uzvu çizin: L, sonra tıklayın.</translation>
    </message>
    <message>
        <source>The gears appear when the turning joints tie every link to the ground and close no loop.</source>
        <translation>Dişliler, döner mafsallar her uzvu sabit uzva bağlayıp çevrim kapatmadığında görünür.</translation>
    </message>
    <message>
        <source>The 3D view shows trains of up to %1 links; this one has %2.</source>
        <translation>3B görünüm en çok %1 uzuvlu takımları gösterir; bunda %2 uzuv var.</translation>
    </message>
    <message>
        <source>The gears appear when a mesh joins two of the links: G, then drag.</source>
        <translation>Dişliler, bir dişli çifti iki uzvu birleştirince görünür: G, sonra sürükleyin.</translation>
    </message>
    <message>
        <source>T–T graph</source>
        <translation>T–T grafı</translation>
    </message>
    <message>
        <source>Schematic</source>
        <translation>Şema</translation>
    </message>
    <message>
        <source>The views could not be updated: %1.</source>
        <translation>Görünümler yenilenemedi: %1.</translation>
    </message>
    <message>
        <source>Shown as before the last changes. %1</source>
        <translation>Son değişikliklerden önceki gibi gösteriliyor. %1</translation>
    </message>
    <message>
        <source>This matrix needs a mechanism without errors.</source>
        <translation>Bu matris hatasız bir mekanizma gerektirir.</translation>
    </message>
    <message>
        <source>This matrix needs the turning joints to be a spanning tree.</source>
        <translation>Bu matris için döner mafsallar kapsayan ağaç oluşturmalıdır.</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (salt okunur)</translation>
    </message>
    <message>
        <source>Notices</source>
        <translation>Bildirimler</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 / %1</translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation>Resim için yeterli bellek yok.</translation>
    </message>
    <message>
        <source>Of this size:</source>
        <translation>Bu boyutta:</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Saydam arka plan</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Koyu üzerine açık</translation>
    </message>
    <message>
        <source>Fit everything into the picture</source>
        <translation>Her şeyi resme sığdır</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Resmi dışa aktar</translation>
    </message>
    <message>
        <source>SVG, lines and text</source>
        <translation>SVG, çizgiler ve metin</translation>
    </message>
    <message>
        <source>PDF, lines and text</source>
        <translation>PDF, çizgiler ve metin</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, pikseller</translation>
    </message>
    <message>
        <source>PNG, a folder of pictures</source>
        <translation>PNG, bir resim klasörü</translation>
    </message>
    <message>
        <source>GLB, the solids in their present pose</source>
        <translation>GLB, katılar şimdiki konumlarında</translation>
    </message>
    <message>
        <source>Without it the picture is as large as the drawing.</source>
        <translation>Bu seçilmezse resim çizim kadar büyüktür.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Görünüm</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Dosya</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Boyut</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Canlandırma</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arka plan</translation>
    </message>
    <message>
        <source>None: one picture</source>
        <translation>Yok: tek resim</translation>
    </message>
    <message>
        <source>Turntable: once round</source>
        <translation>Döner tabla: tam tur</translation>
    </message>
    <message>
        <source>Motion: one period</source>
        <translation>Hareket: bir periyot</translation>
    </message>
    <message>
        <source>A minute where the motion has no period</source>
        <translation>Hareketin periyodu yoksa bir dakika</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> resim</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> / saniye</translation>
    </message>
    <message>
        <source>The 3D view is made of pixels.</source>
        <translation>3B görünüm piksellerden oluşur.</translation>
    </message>
    <message>
        <source>Only the 3D view has it.</source>
        <translation>Yalnızca 3B görünümde vardır.</translation>
    </message>
    <message>
        <source>Export pictures into the new folder</source>
        <translation>Resimleri yeni klasöre aktar</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Klasörler (*)</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tüm dosyalar</translation>
    </message>
    <message>
        <source>The 3D view is empty: there is nothing to export.</source>
        <translation>3B görünüm boş: dışa aktarılacak bir şey yok.</translation>
    </message>
    <message>
        <source>Copied the drawing as a picture</source>
        <translation>Çizim resim olarak kopyalandı</translation>
    </message>
    <message>
        <source>The 3D view is empty: there is nothing to copy.</source>
        <translation>3B görünüm boş: kopyalanacak bir şey yok.</translation>
    </message>
    <message>
        <source>Copied the 3D view as a picture</source>
        <translation>3B görünüm resim olarak kopyalandı</translation>
    </message>
    <message>
        <source>Sent to the printer</source>
        <translation>Yazıcıya gönderildi</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 dışa aktarıldı</translation>
    </message>
    <message>
        <source>How fast the motion is shown; a double click is 1.0×</source>
        <translation>Hareketin gösterilme hızı; çift tıklama 1,0× yapar</translation>
    </message>
    <message>
        <source>Speed of the motion</source>
        <translation>Hareketin hızı</translation>
    </message>
    <message>
        <source>Pause the motion (Space)</source>
        <translation>Hareketi duraklat (Boşluk)</translation>
    </message>
    <message>
        <source>Play the motion (Space)</source>
        <translation>Hareketi oynat (Boşluk)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Duraklat</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Oynat</translation>
    </message>
    <message>
        <source>Power flows under loads: add one in Forces.</source>
        <translation>Güç yük altında akar: Kuvvetler&apos;de bir yük ekleyin.</translation>
    </message>
    <message>
        <source>The loads are not in balance: Forces names what is missing.</source>
        <translation>Yükler dengede değil: eksik olan Kuvvetler&apos;de yazıyor.</translation>
    </message>
    <message>
        <source>The ground</source>
        <translation>Sabit uzuv</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>%1 uzvu</translation>
    </message>
    <message>
        <source>Link %1, %2</source>
        <translation>%1 uzvu, %2</translation>
    </message>
    <message>
        <source>Esc or F11 ends the presentation, Space plays.  Alt+1, Alt+2, … show and hide panels.</source>
        <translation>Esc veya F11 sunumu bitirir, Boşluk oynatır.  Alt+1, Alt+2, … panelleri gösterir ve gizler.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Son kullanılanlar</translation>
    </message>
    <message>
        <source>No file has been opened yet</source>
        <translation>Henüz dosya açılmadı</translation>
    </message>
    <message>
        <source>There is nothing drawn to derive anything for.</source>
        <translation>Türetim yapılacak bir çizim yok.</translation>
    </message>
    <message>
        <source>A derivation of more than %1 links is not written: it would be too long to read.</source>
        <translation>%1 uzuvdan fazlası için türetim yazılmaz: okunamayacak kadar uzun olurdu.</translation>
    </message>
    <message>
        <source>Export derivation</source>
        <translation>Türetimi dışa aktar</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)</source>
        <translation>Web sayfası (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)</translation>
    </message>
    <message>
        <source>The solution is still being worked out. Try again in a moment.</source>
        <translation>Çözüm hâlâ hesaplanıyor. Biraz sonra yeniden deneyin.</translation>
    </message>
    <message>
        <source>The export was stopped.</source>
        <translation>Dışa aktarma durduruldu.</translation>
    </message>
    <message>
        <source>Export handout</source>
        <translation>Ders notunu dışa aktar</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Web sayfası (*.html)</translation>
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
        <translation>x etrafında, °</translation>
    </message>
    <message>
        <source>about y, °</source>
        <translation>y etrafında, °</translation>
    </message>
    <message>
        <source>about z, °</source>
        <translation>z etrafında, °</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Ölçek</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Ekle…</translation>
    </message>
    <message>
        <source>Another STL, OBJ, PLY or GLB file</source>
        <translation>Başka bir STL, OBJ, PLY veya GLB dosyası</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Kaldır</translation>
    </message>
    <message>
        <source>Lengths in the document&apos;s unit. A file is turned about x, then y, then z, and moved, in the drawn pose; it then moves with its link.</source>
        <translation>Uzunluklar belgenin birimindedir. Dosya, çizilen konumda x, sonra y, sonra z etrafında döndürülüp taşınır; sonra uzvuyla birlikte hareket eder.</translation>
    </message>
    <message>
        <source>3D files of link %1</source>
        <translation>%1 uzvunun 3B dosyaları</translation>
    </message>
    <message>
        <source>Place a 3D file</source>
        <translation>3B dosya yerleştir</translation>
    </message>
    <message>
        <source>3D file</source>
        <translation>3B dosya</translation>
    </message>
    <message>
        <source>3D files (*.stl *.obj *.ply *.glb);;All files (*)</source>
        <translation>3B dosyalar (*.stl *.obj *.ply *.glb);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Wear a 3D file</source>
        <translation>3B dosya tak</translation>
    </message>
    <message>
        <source>Take off a 3D file</source>
        <translation>3B dosyayı çıkar</translation>
    </message>
    <message>
        <source>In a drawing</source>
        <translation>Çizimde</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>Oynat, duraklat</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Boşluk</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Sayfayı kaydır</translation>
    </message>
    <message>
        <source>Space or middle button, and drag</source>
        <translation>Boşluk veya orta düğme ile sürükleme</translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation>Farenin olduğu yerde yakınlaştır</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Tekerlek</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Fit what is selected</source>
        <translation>Seçileni sığdır</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Nudge; finer</source>
        <translation>Az kaydır; daha ince</translation>
    </message>
    <message>
        <source>Arrow keys; with Shift</source>
        <translation>Ok tuşları; Shift ile</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Seçime ekle</translation>
    </message>
    <message>
        <source>Shift or Ctrl, and click</source>
        <translation>Shift veya Ctrl ile tıklama</translation>
    </message>
    <message>
        <source>Drag without snapping</source>
        <translation>Yakalamadan sürükle</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Rename in place</source>
        <translation>Yerinde yeniden adlandır</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Çift tıklama</translation>
    </message>
    <message>
        <source>Next, last element; besides</source>
        <translation>Sonraki, önceki öğe; seçime ek</translation>
    </message>
    <message>
        <source>Page down, up; with Shift</source>
        <translation>Page Down, Up; Shift ile</translation>
    </message>
    <message>
        <source>The nearest element that way</source>
        <translation>O yöndeki en yakın öğe</translation>
    </message>
    <message>
        <source>Ctrl and arrow key</source>
        <translation>Ctrl ve ok tuşu</translation>
    </message>
    <message>
        <source>As a click on the element</source>
        <translation>Öğeye tıklama gibi</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Give up, deselect, back to Select</source>
        <translation>Vazgeç, seçimi kaldır, Seç&apos;e dön</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>3B görünümde</translation>
    </message>
    <message>
        <source>Step back, step on</source>
        <translation>Adım geri, adım ileri</translation>
    </message>
    <message>
        <source>Comma, point</source>
        <translation>Virgül, nokta</translation>
    </message>
    <message>
        <source>F, Home</source>
        <translation>F, Home</translation>
    </message>
    <message>
        <source>Isometric, front, right, top</source>
        <translation>İzometrik, ön, sağ, üst</translation>
    </message>
    <message>
        <source>0, 1, 2, 3</source>
        <translation>0, 1, 2, 3</translation>
    </message>
    <message>
        <source>Turn the train</source>
        <translation>Dişli takımını döndür</translation>
    </message>
    <message>
        <source>Drag a gear</source>
        <translation>Bir dişliyi sürükleme</translation>
    </message>
    <message>
        <source>Turn a part by hand</source>
        <translation>Bir parçayı elle döndür</translation>
    </message>
    <message>
        <source>Ctrl, and drag</source>
        <translation>Ctrl ile sürükleme</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Çevresinde dön</translation>
    </message>
    <message>
        <source>Drag elsewhere, arrow keys</source>
        <translation>Başka yerde sürükleme, ok tuşları</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Kaydır</translation>
    </message>
    <message>
        <source>Shift with drag or arrow keys</source>
        <translation>Shift ile sürükleme veya ok tuşları</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Yakınlaştır</translation>
    </message>
    <message>
        <source>Wheel, + and −</source>
        <translation>Tekerlek, + ve −</translation>
    </message>
    <message>
        <source>Next, last link</source>
        <translation>Sonraki, önceki uzuv</translation>
    </message>
    <message>
        <source>Page down, Page up</source>
        <translation>Page Down, Page Up</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Klavye kısayolları</translation>
    </message>
    <message>
        <source>New mechanism</source>
        <translation>Yeni mekanizma</translation>
    </message>
    <message>
        <source>An empty sheet with the ground on it</source>
        <translation>Üzerinde sabit uzuv olan boş sayfa</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Aç…</translation>
    </message>
    <message>
        <source>Open a document; it can be dropped on the window, too</source>
        <translation>Belge aç; pencerenin üzerine de bırakılabilir</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Son kullanılanlar</translation>
    </message>
    <message>
        <source>Documents that you open or save are listed here.</source>
        <translation>Açtığınız veya kaydettiğiniz belgeler burada listelenir.</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Örnekler</translation>
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
        <translation>rank –</translation>
    </message>
    <message>
        <source>DOF –</source>
        <translation>SD –</translation>
    </message>
    <message>
        <source>rank %1</source>
        <translation>rank %1</translation>
    </message>
    <message>
        <source>DOF %1</source>
        <translation>SD %1</translation>
    </message>
    <message>
        <source>rank %1 + %2</source>
        <translation>rank %1 + %2</translation>
    </message>
    <message>
        <source>DOF %1 (engaged: %2)</source>
        <translation>SD %1 (devrede: %2)</translation>
    </message>
    <message>
        <source>Select, move, and change what is drawn</source>
        <translation>Çizileni seç, taşı ve değiştir</translation>
    </message>
    <message>
        <source>Draw links: click on an empty place</source>
        <translation>Uzuv çiz: boş yere tıklayın</translation>
    </message>
    <message>
        <source>Draw a turning joint: drag from a link to the link it carries</source>
        <translation>Döner mafsal çiz: bir uzuvdan taşıdığı uzva sürükleyin</translation>
    </message>
    <message>
        <source>Draw a gear mesh: drag from a gear to the one it drives</source>
        <translation>Dişli çifti çiz: bir dişliden tahrik ettiğine sürükleyin</translation>
    </message>
    <message>
        <source>Drive a joint: click a turning joint or the link it carries</source>
        <translation>Mafsal tahrik et: döner mafsala veya taşıdığı uzva tıklayın</translation>
    </message>
    <message>
        <source>Move the sheet; the middle mouse button does so with any tool</source>
        <translation>Sayfayı kaydır; orta fare düğmesi her araçta bunu yapar</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Yeni</translation>
    </message>
    <message>
        <source>A document with the ground and nothing else</source>
        <translation>Yalnız sabit uzvu olan belge</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Yeni &amp;pencere</translation>
    </message>
    <message>
        <source>Another window with an empty document</source>
        <translation>Boş belgeli başka bir pencere</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Başlangıç sayfası</translation>
    </message>
    <message>
        <source>New document, recent documents and examples</source>
        <translation>Yeni belge, son belgeler ve örnekler</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Aç…</translation>
    </message>
    <message>
        <source>Open a document</source>
        <translation>Belge aç</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Kaydet</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Belgeyi kaydet</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>&amp;Farklı kaydet…</translation>
    </message>
    <message>
        <source>Save the document under another name</source>
        <translation>Belgeyi başka adla kaydet</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>&amp;Dosyaya dön</translation>
    </message>
    <message>
        <source>Reload the file; this can be undone</source>
        <translation>Dosyayı yeniden yükle; geri alınabilir</translation>
    </message>
    <message>
        <source>Reopen w&amp;indows at start</source>
        <translation>Açılışta pencereleri y&amp;eniden aç</translation>
    </message>
    <message>
        <source>Open the documents of the last time when the program starts without one</source>
        <translation>Program belgesiz başlarsa son kullanımın belgelerini aç</translation>
    </message>
    <message>
        <source>&amp;Export matrix as CSV…</source>
        <translation>&amp;Matrisi CSV olarak dışa aktar…</translation>
    </message>
    <message>
        <source>Export the matrix that is shown, with its labels</source>
        <translation>Gösterilen matrisi etiketleriyle dışa aktar</translation>
    </message>
    <message>
        <source>Export pict&amp;ure…</source>
        <translation>Resm&amp;i dışa aktar…</translation>
    </message>
    <message>
        <source>Export a drawing as SVG, PDF or PNG, or the 3D view as PNG</source>
        <translation>Bir çizimi SVG, PDF veya PNG, ya da 3B görünümü PNG olarak dışa aktar</translation>
    </message>
    <message>
        <source>Export &amp;derivation…</source>
        <translation>&amp;Türetimi dışa aktar…</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism, as a web page, PDF, LaTeX or Markdown</source>
        <translation>Bu mekanizma için iki yöntem adım adım; web sayfası, PDF, LaTeX veya Markdown olarak</translation>
    </message>
    <message>
        <source>Export &amp;handout…</source>
        <translation>Ders &amp;notunu dışa aktar…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Ya&amp;zdır…</translation>
    </message>
    <message>
        <source>Print the drawings and the derivation, or look at the pages first</source>
        <translation>Çizimleri ve türetimi yazdır, ya da önce sayfalara bak</translation>
    </message>
    <message>
        <source>Show the &amp;derivation</source>
        <translation>&amp;Türetimi göster</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism</source>
        <translation>Bu mekanizma için iki yöntem adım adım</translation>
    </message>
    <message>
        <source>&amp;Compare the methods</source>
        <translation>Yöntemleri &amp;karşılaştır</translation>
    </message>
    <message>
        <source>Both methods side by side, counted for this mechanism</source>
        <translation>Bu mekanizma için sayılmış iki yöntem yan yana</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Dersler…</translation>
    </message>
    <message>
        <source>A course from one gear pair to the robot, with tasks that are checked; in a window of its own</source>
        <translation>Tek dişli çiftinden robota, denetlenen ödevlerle bir kurs; kendi penceresinde</translation>
    </message>
    <message>
        <source>Open a lesson &amp;file…</source>
        <translation>Ders d&amp;osyası aç…</translation>
    </message>
    <message>
        <source>Preview a lesson of your own: it is reloaded whenever the file is saved</source>
        <translation>Kendi dersinizin önizlemesi: dosya her kaydedildiğinde yeniden yüklenir</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Pen&amp;cereyi kapat</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Bu pencereyi kapat</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Çık</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Bütün pencereleri kapat</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Geri al</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Geri al</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Yinele</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Yinele</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>Geç&amp;miş…</translation>
    </message>
    <message>
        <source>All steps as a list; a click goes to any of them</source>
        <translation>Bütün adımlar liste olarak; bir tıklama herhangi birine gider</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>K&amp;es</translation>
    </message>
    <message>
        <source>Copy what is selected, and delete it</source>
        <translation>Seçileni kopyala ve sil</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopyala</translation>
    </message>
    <message>
        <source>Copy the selected links with the joints and meshes between them</source>
        <translation>Seçili uzuvları aralarındaki mafsal ve dişli çiftleriyle kopyala</translation>
    </message>
    <message>
        <source>Copy as p&amp;icture</source>
        <translation>Re&amp;sim olarak kopyala</translation>
    </message>
    <message>
        <source>Copy the drawing in front, or the 3D view where it has the focus, as SVG and PNG</source>
        <translation>Öndeki çizimi, ya da odaktaysa 3B görünümü, SVG ve PNG olarak kopyala</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Ya&amp;pıştır</translation>
    </message>
    <message>
        <source>Insert what was copied, in this window or in another</source>
        <translation>Bu pencerede veya başkasında kopyalananı ekle</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Ç&amp;oğalt</translation>
    </message>
    <message>
        <source>A copy of the selection in the drawing</source>
        <translation>Seçimin çizimde bir kopyası</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Si&amp;l</translation>
    </message>
    <message>
        <source>Delete what is selected, and what needs it</source>
        <translation>Seçileni ve ona gereksinenleri sil</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Yeni&amp;den adlandır</translation>
    </message>
    <message>
        <source>Rename the selected link</source>
        <translation>Seçili uzvu yeniden adlandır</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Tümünü seç</translation>
    </message>
    <message>
        <source>Select everything</source>
        <translation>Her şeyi seç</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>Ters çe&amp;vir</translation>
    </message>
    <message>
        <source>Exchange tail and head of the selected arrows</source>
        <translation>Seçili okların kuyruk ve başını değiştir</translation>
    </message>
    <message>
        <source>Make &amp;ground</source>
        <translation>Sa&amp;bit uzuv yap</translation>
    </message>
    <message>
        <source>Makes the selected link the ground</source>
        <translation>Seçili uzvu sabit uzuv yapar</translation>
    </message>
    <message>
        <source>&amp;Attach a gear</source>
        <translation>Dişli &amp;ekle</translation>
    </message>
    <message>
        <source>A new gear in mesh with the selected one, on the same carrier</source>
        <translation>Seçiliyle kavraşan yeni dişli, aynı taşıyıcı üzerinde</translation>
    </message>
    <message>
        <source>Dri&amp;ve</source>
        <translation>Tah&amp;rik et</translation>
    </message>
    <message>
        <source>Drive the selected joints, or stop driving them</source>
        <translation>Seçili mafsalları tahrik et veya tahrikini kaldır</translation>
    </message>
    <message>
        <source>Hold with a &amp;brake</source>
        <translation>&amp;Frenle tut</translation>
    </message>
    <message>
        <source>Engage the brake of the selected link, a new one where it has none, or release it</source>
        <translation>Seçili uzvun frenini, yoksa yeni bir freni devreye al, ya da ayır</translation>
    </message>
    <message>
        <source>A torque in the selected joint or on the selected link: type 10 Nm, nothing removes it</source>
        <translation>Seçili mafsalda veya uzuvda tork: 10 Nm yazın, boş bırakmak kaldırır</translation>
    </message>
    <message>
        <source>&amp;Release brakes and clutches</source>
        <translation>Fren ve &amp;kavramaları ayır</translation>
    </message>
    <message>
        <source>Release every brake and clutch; the motion goes on</source>
        <translation>Bütün fren ve kavramaları ayır; hareket sürer</translation>
    </message>
    <message>
        <source>&amp;Insert set…</source>
        <translation>Takım yer&amp;leştir…</translation>
    </message>
    <message>
        <source>A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist</source>
        <translation>Bütün bir planet, Ravigneaux veya Simpson takımı, diferansiyel, geri dönüşlü takım, bilek</translation>
    </message>
    <message>
        <source>%1 planets</source>
        <translation>%1 gezegen</translation>
    </message>
    <message>
        <source>Copies of the selected planet, equally spaced, %1 in all</source>
        <translation>Seçili gezegenin eşit aralıklı kopyaları, toplam %1</translation>
    </message>
    <message>
        <source>&amp;Tidy the drawing</source>
        <translation>Çizimi &amp;düzenle</translation>
    </message>
    <message>
        <source>Lay the digraph out anew</source>
        <translation>Yönlü grafı yeniden yerleştir</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Sığdır</translation>
    </message>
    <message>
        <source>Show all of the drawing</source>
        <translation>Bütün çizimi göster</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Yakın&amp;laştır</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Daha büyük</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>U&amp;zaklaştır</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Daha küçük</translation>
    </message>
    <message>
        <source>Fit the &amp;selection</source>
        <translation>Se&amp;çimi sığdır</translation>
    </message>
    <message>
        <source>Show all that is selected</source>
        <translation>Seçilenlerin hepsini göster</translation>
    </message>
    <message>
        <source>&amp;Presentation</source>
        <translation>Su&amp;num</translation>
    </message>
    <message>
        <source>Full screen, large type, the drawing and the panels that were chosen</source>
        <translation>Tam ekran, büyük yazı, çizim ve seçilen paneller</translation>
    </message>
    <message>
        <source>Snap to the &amp;grid</source>
        <translation>Iz&amp;garaya yakala</translation>
    </message>
    <message>
        <source>Nodes keep to a grid; Alt suspends it</source>
        <translation>Düğümler ızgaraya uyar; Alt bunu askıya alır</translation>
    </message>
    <message>
        <source>Po&amp;wer flow</source>
        <translation>G&amp;üç akışı</translation>
    </message>
    <message>
        <source>Bands in digraph and schematic show where the power of the loads goes</source>
        <translation>Yönlü graf ve şemadaki bantlar yüklerin gücünün nereye gittiğini gösterir</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>Ye&amp;rleşimi sıfırla</translation>
    </message>
    <message>
        <source>All panels back to their places</source>
        <translation>Bütün paneller yerlerine</translation>
    </message>
    <message>
        <source>Look &amp;up a term…</source>
        <translation>T&amp;erime bak…</translation>
    </message>
    <message>
        <source>The definition of a technical term</source>
        <translation>Bir teknik terimin tanımı</translation>
    </message>
    <message>
        <source>&amp;Search…</source>
        <translation>&amp;Ara…</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Klavye kısayolları</translation>
    </message>
    <message>
        <source>All keys on one sheet</source>
        <translation>Bütün tuşlar tek sayfada</translation>
    </message>
    <message>
        <source>&amp;About GearGraph</source>
        <translation>GearGraph &amp;hakkında</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Bu programın ne olduğu</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>&amp;Sistem gibi</translation>
    </message>
    <message>
        <source>Light or dark as the system is</source>
        <translation>Sistem gibi açık veya koyu</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Açık</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Açık üzerine koyu</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Koyu</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Yüksek karşıtlık</translation>
    </message>
    <message>
        <source>Light on black</source>
        <translation>Siyah üzerine açık</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%%1</translation>
    </message>
    <message>
        <source>Words of the window at %1 % of their size</source>
        <translation>Pencere yazıları boyutlarının %%1&apos;i kadar</translation>
    </message>
    <message>
        <source>3D on &amp;half the width</source>
        <translation>3B yar&amp;ı genişlikte</translation>
    </message>
    <message>
        <source>The 3D view as wide as the drawing</source>
        <translation>3B görünüm çizim kadar geniş</translation>
    </message>
    <message>
        <source>&amp;Play	Space</source>
        <translation>&amp;Oynat	Boşluk</translation>
    </message>
    <message>
        <source>Start or stop the motion (Space)</source>
        <translation>Hareketi başlat veya durdur (Boşluk)</translation>
    </message>
    <message>
        <source>Back to the &amp;start</source>
        <translation>&amp;Başa dön</translation>
    </message>
    <message>
        <source>The time goes back to 0</source>
        <translation>Zaman 0&apos;a döner</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Daha hızlı</translation>
    </message>
    <message>
        <source>The motion is shown faster</source>
        <translation>Hareket daha hızlı gösterilir</translation>
    </message>
    <message>
        <source>Slo&amp;wer</source>
        <translation>Daha &amp;yavaş</translation>
    </message>
    <message>
        <source>The motion is shown more slowly</source>
        <translation>Hareket daha yavaş gösterilir</translation>
    </message>
    <message>
        <source>&amp;Normal speed</source>
        <translation>&amp;Normal hız</translation>
    </message>
    <message>
        <source>A second of the motion takes a second</source>
        <translation>Hareketin bir saniyesi bir saniye sürer</translation>
    </message>
    <message>
        <source>&amp;Backwards</source>
        <translation>&amp;Geriye</translation>
    </message>
    <message>
        <source>The motion runs back in time</source>
        <translation>Hareket zamanda geri gider</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Araçlar</translation>
    </message>
    <message>
        <source>&amp;Pause	Space</source>
        <translation>&amp;Duraklat	Boşluk</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Dosya</translation>
    </message>
    <message>
        <source>Open e&amp;xample</source>
        <translation>Ö&amp;rnek aç</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>D&amp;üzen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Görünüm</translation>
    </message>
    <message>
        <source>Power seen fro&amp;m</source>
        <translation>Gücün görüldüğü y&amp;er</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>T&amp;ype size</source>
        <translation>Yazı &amp;boyu</translation>
    </message>
    <message>
        <source>&amp;Mechanism</source>
        <translation>&amp;Mekanizma</translation>
    </message>
    <message>
        <source>&amp;Planets like the selected one</source>
        <translation>Seçili gibi ge&amp;zegenler</translation>
    </message>
    <message>
        <source>M&amp;otion</source>
        <translation>&amp;Hareket</translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation>Öğ&amp;ren</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Yardım</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Hiçbir şey seçili değil.</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Geri al: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Yinele: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Geri alınacak bir şey yok.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Yinelenecek bir şey yok.</translation>
    </message>
    <message>
        <source>There is one ground in every document.</source>
        <translation>Her belgede bir sabit uzuv vardır.</translation>
    </message>
    <message>
        <source>The ground cannot be deleted.</source>
        <translation>Sabit uzuv silinemez.</translation>
    </message>
    <message>
        <source>Select one link to rename it.</source>
        <translation>Yeniden adlandırmak için bir uzuv seçin.</translation>
    </message>
    <message>
        <source>Select a joint or a mesh to turn its arrow round.</source>
        <translation>Okunu ters çevirmek için bir mafsal veya dişli çifti seçin.</translation>
    </message>
    <message>
        <source>Select a turning joint, or the link it carries.</source>
        <translation>Bir döner mafsal veya taşıdığı uzvu seçin.</translation>
    </message>
    <message>
        <source>The ground does not move.</source>
        <translation>Sabit uzuv hareket etmez.</translation>
    </message>
    <message>
        <source>Select one link to hold it.</source>
        <translation>Tutmak için bir uzuv seçin.</translation>
    </message>
    <message>
        <source>No brake and no clutch is engaged.</source>
        <translation>Devrede fren ve kavrama yok.</translation>
    </message>
    <message>
        <source>Select one planet.</source>
        <translation>Bir gezegen dişli seçin.</translation>
    </message>
    <message>
        <source>Select the link that the gear should mesh with.</source>
        <translation>Dişlinin kavraşacağı uzvu seçin.</translation>
    </message>
    <message>
        <source>This link is the ground already.</source>
        <translation>Bu uzuv zaten sabit.</translation>
    </message>
    <message>
        <source>Select one link to make it the ground.</source>
        <translation>Sabit uzuv yapmak için bir uzuv seçin.</translation>
    </message>
    <message>
        <source>There is no link to lay out yet.</source>
        <translation>Henüz yerleştirilecek uzuv yok.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3B</translation>
    </message>
    <message>
        <source>The solution is still being worked out.</source>
        <translation>Çözüm hâlâ hesaplanıyor.</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrisler</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Sorunlar</translation>
    </message>
    <message>
        <source>Inputs and results</source>
        <translation>Girişler ve sonuçlar</translation>
    </message>
    <message>
        <source>Gearbox</source>
        <translation>Şanzıman</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Özellikler</translation>
    </message>
    <message>
        <source>Derivation</source>
        <translation>Türetim</translation>
    </message>
    <message>
        <source>Dynamics</source>
        <translation>Dinamik</translation>
    </message>
    <message>
        <source>Problems %1</source>
        <translation>Sorunlar %1</translation>
    </message>
    <message>
        <source>Export matrix</source>
        <translation>Matrisi dışa aktar</translation>
    </message>
    <message>
        <source>CSV files (*.csv);;All files (*)</source>
        <translation>CSV dosyaları (*.csv);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Tabloyu dışa aktar</translation>
    </message>
    <message>
        <source>Save the traced path</source>
        <translation>Çizilen yörüngeyi kaydet</translation>
    </message>
    <message>
        <source>path.csv</source>
        <translation>yorunge.csv</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 kaydedildi</translation>
    </message>
    <message>
        <source>Save the speeds</source>
        <translation>Hızları kaydet</translation>
    </message>
    <message>
        <source>speeds.csv</source>
        <translation>hizlar.csv</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2</source>
        <translation>%1 açılamadı: %2</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Adsız</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Aç</translation>
    </message>
    <message>
        <source>This window is not connected to others.</source>
        <translation>Bu pencere başkalarına bağlı değil.</translation>
    </message>
    <message>
        <source>A lesson&apos;s drawing is not kept: copy what you need into another window.</source>
        <translation>Dersin çizimi saklanmaz: gerekeni başka bir pencereye kopyalayın.</translation>
    </message>
    <message>
        <source>Nothing has been changed since it was saved.</source>
        <translation>Kaydedildiğinden beri değişiklik yok.</translation>
    </message>
    <message>
        <source>The document has no file yet.</source>
        <translation>Belgenin henüz dosyası yok.</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier run are in %1, which cannot be read.</source>
        <translation>Önceki bir çalışmanın kaydedilmemiş değişiklikleri, okunamayan %1 dosyasında.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>a document that was never saved (%1)</source>
        <translation>hiç kaydedilmemiş bir belge (%1)</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 değişiklik</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 değişiklik</translation>
    </message>
    <message>
        <source>GearGraph ended with unsaved changes of %1: %2 after it was last saved, the last at %3 (%4).</source>
        <translation>GearGraph, %1 için kaydedilmemiş değişikliklerle kapandı: son kayıttan sonra %2, sonuncusu %3 (%4).</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Geri yükle</translation>
    </message>
    <message>
        <source>Open them as unsaved changes, which can be undone</source>
        <translation>Geri alınabilen, kaydedilmemiş değişiklikler olarak aç</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>At</translation>
    </message>
    <message>
        <source>Delete them for good</source>
        <translation>Kalıcı olarak sil</translation>
    </message>
    <message>
        <source>They stay where they are and will be offered again</source>
        <translation>Yerlerinde kalır ve yeniden önerilirler</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>Kaydedilmemiş değişiklikleri geri yükle</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, satır %2: %3</translation>
    </message>
    <message>
        <source>Lesson %1 of %2</source>
        <translation>Ders %1 / %2</translation>
    </message>
    <message>
        <source>Open a lesson file</source>
        <translation>Ders dosyası aç</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Dersler (*.json)</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Önizleme</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Ders</translation>
    </message>
    <message>
        <source>This panel holds the answer: it opens when the step is right or shown.</source>
        <translation>Bu panelde yanıt var: adım doğru olunca veya gösterilince açılır.</translation>
    </message>
    <message>
        <source>The derivation holds the answer: it opens when the step is right or shown.</source>
        <translation>Türetimde yanıt var: adım doğru olunca veya gösterilince açılır.</translation>
    </message>
    <message>
        <source>%1 was not saved: another program has changed it.</source>
        <translation>%1 kaydedilmedi: başka bir program onu değiştirdi.</translation>
    </message>
    <message>
        <source>%1 was not saved. %2</source>
        <translation>%1 kaydedilmedi. %2</translation>
    </message>
    <message>
        <source>Save it once more</source>
        <translation>Bir daha kaydet</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Farklı kaydet…</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Başka bir adla kaydet</translation>
    </message>
    <message>
        <source>The document stays open, with its changes</source>
        <translation>Belge değişiklikleriyle açık kalır</translation>
    </message>
    <message>
        <source>untitled.geargraph</source>
        <translation>adsiz.geargraph</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Farklı kaydet</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 zaten var. Değiştirilsin mi?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Kaydedilmemiş değişiklikler</translation>
    </message>
    <message>
        <source>Save the changes to %1 first?</source>
        <translation>%1 üzerindeki değişiklikler önce kaydedilsin mi?</translation>
    </message>
    <message>
        <source>Revert to the file</source>
        <translation>Dosyaya dön</translation>
    </message>
    <message>
        <source>it can no longer be read</source>
        <translation>artık okunamıyor</translation>
    </message>
    <message>
        <source>%1 was not saved: another program has changed it (%2). Reloading can be undone.</source>
        <translation>%1 kaydedilmedi: başka bir program onu değiştirdi (%2). Yeniden yükleme geri alınabilir.</translation>
    </message>
    <message>
        <source>Another program has changed %1: %2. Your own changes are not saved; reloading can be undone.</source>
        <translation>Başka bir program %1 dosyasını değiştirdi: %2. Kendi değişiklikleriniz kaydedilmedi; yeniden yükleme geri alınabilir.</translation>
    </message>
    <message>
        <source>Another program has changed %1: %2.</source>
        <translation>Başka bir program %1 dosyasını değiştirdi: %2.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Yeniden yükle</translation>
    </message>
    <message>
        <source>Load the contents of the file</source>
        <translation>Dosyanın içeriğini yükle</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Üzerine yaz</translation>
    </message>
    <message>
        <source>Save this window&apos;s document over it</source>
        <translation>Bu pencerenin belgesini üzerine kaydet</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>İkisini de koru</translation>
    </message>
    <message>
        <source>Save this window&apos;s document under another name</source>
        <translation>Bu pencerenin belgesini başka adla kaydet</translation>
    </message>
    <message>
        <source>Saving will ask again</source>
        <translation>Kaydederken yeniden sorulur</translation>
    </message>
    <message>
        <source>Another program has moved or deleted %1.</source>
        <translation>Başka bir program %1 dosyasını taşıdı veya sildi.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Yeniden kaydet</translation>
    </message>
    <message>
        <source>Write it where it was</source>
        <translation>Bulunduğu yere yaz</translation>
    </message>
    <message>
        <source>The document stays open</source>
        <translation>Belge açık kalır</translation>
    </message>
    <message>
        <source>%1 is open in this window already.</source>
        <translation>%1 bu pencerede zaten açık.</translation>
    </message>
    <message>
        <source>Not opened again: %1</source>
        <translation>Yeniden açılmadı: %1</translation>
    </message>
    <message>
        <source>%1 is open in another window of GearGraph. Here it is read-only.</source>
        <translation>%1 başka bir GearGraph penceresinde açık. Burada salt okunur.</translation>
    </message>
    <message>
        <source>Show that window</source>
        <translation>O pencereyi göster</translation>
    </message>
    <message>
        <source>And close this one if nothing is changed in it</source>
        <translation>Bunda değişiklik yoksa bunu kapat</translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation>Salt okunur</translation>
    </message>
    <message>
        <source>Look at it here; changes can be saved under another name</source>
        <translation>Burada bakın; değişiklikler başka adla kaydedilebilir</translation>
    </message>
    <message>
        <source>%1 was not saved: %2 is open in another window of GearGraph.</source>
        <translation>%1 kaydedilmedi: %2 başka bir GearGraph penceresinde açık.</translation>
    </message>
    <message>
        <source>%1 is not open in another window any more. This one writes to it now.</source>
        <translation>%1 artık başka bir pencerede açık değil. Şimdi bu pencere ona yazıyor.</translation>
    </message>
    <message>
        <source>The other window with %1 does not answer.</source>
        <translation>%1 dosyasının açık olduğu öbür pencere yanıt vermiyor.</translation>
    </message>
    <message>
        <source>Saving %1 was interrupted, so the file may be damaged. What was to be saved is in %2.</source>
        <translation>%1 kaydı yarıda kesildi, dosya bozulmuş olabilir. Kaydedilecek olan %2 içinde.</translation>
    </message>
    <message>
        <source>Open the copy</source>
        <translation>Kopyayı aç</translation>
    </message>
    <message>
        <source>Delete the copy</source>
        <translation>Kopyayı sil</translation>
    </message>
    <message>
        <source>The file is as it should be</source>
        <translation>Dosya olması gerektiği gibi</translation>
    </message>
    <message>
        <source>Attached 3D files…</source>
        <translation>Takılı 3B dosyalar…</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>satır %1, sütun %2</translation>
    </message>
    <message>
        <source>Code: %1</source>
        <translation>Kod: %1</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> ve %1 tane daha</translation>
    </message>
    <message>
        <source>No other joint turns with joint %1.</source>
        <translation>%1 mafsalıyla dönen başka mafsal yok.</translation>
    </message>
    <message>
        <source>Joint %1 commands %2.</source>
        <translation>%1 mafsalı şunları belirler: %2.</translation>
    </message>
    <message>
        <source>Joints %1 turn together, at a fixed ratio.</source>
        <translation>%1 mafsalları sabit oranla birlikte döner.</translation>
    </message>
    <message>
        <source>Never turning: %1.</source>
        <translation>Hiç dönmeyenler: %1.</translation>
    </message>
    <message>
        <source>%1 about %2</source>
        <translation>%2 etrafında %1</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>duruyor</translation>
    </message>
    <message>
        <source>link</source>
        <translation>uzuv</translation>
    </message>
    <message>
        <source>absolute speed</source>
        <translation>mutlak hız</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>dev/dk</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>oran</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>%1 için</translation>
    </message>
    <message>
        <source>now</source>
        <translation>şimdi</translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation>%1 rad/s</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>mafsal</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>kilitli</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 serbest</translation>
    </message>
    <message>
        <source>linkage</source>
        <translation>bağıntı</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>duruyor</translation>
    </message>
    <message>
        <source>tumbles</source>
        <translation>yalpalıyor</translation>
    </message>
    <message>
        <source>%1 engaged</source>
        <translation>%1 devrede</translation>
    </message>
    <message>
        <source>%1 released</source>
        <translation>%1 ayrıldı</translation>
    </message>
    <message>
        <source>Several couplings share the load in proportions that stiffness and clearance decide.</source>
        <translation>Birkaç eleman yükü, rijitlik ve boşluğun belirlediği oranlarda paylaşır.</translation>
    </message>
    <message>
        <source>Brake %1 bears %2 N m, its torque on link %3</source>
        <translation>%1 freni %2 N m taşır, %3 uzvuna torku</translation>
    </message>
    <message>
        <source>Clutch %1 bears %2 N m, its torque on link %3 from link %4</source>
        <translation>%1 kavraması %2 N m taşır, %4 uzvundan %3 uzvuna torku</translation>
    </message>
    <message>
        <source>In the gear ratios: %1</source>
        <translation>Dişli oranlarıyla: %1</translation>
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
        <translation>%1 freni %2 uzvunu tutar</translation>
    </message>
    <message>
        <source>Clutch %1 makes links %2 and %3 turn as one</source>
        <translation>%1 kavraması %2 ve %3 uzuvlarını birlikte döndürür</translation>
    </message>
    <message>
        <source>The ratio is the speed of the first link over that of the second. Click to choose them.</source>
        <translation>Oran, ilk uzvun hızının ikincininkine bölümüdür. Seçmek için tıklayın.</translation>
    </message>
    <message>
        <source>The ratio before over this one</source>
        <translation>Önceki oran bölü bu oran</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving</source>
        <translation>Giriş tahrik ederken alınan güç bölü verilen güç</translation>
    </message>
    <message>
        <source>The efficiency with all known torques reversed: the output drives</source>
        <translation>Bilinen bütün torklar ters çevrildiğinde verim: çıkış tahrik eder</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop, for each watt that is fed</source>
        <translation>Verilen her watt için bir çevrimde dolaşan en büyük güç</translation>
    </message>
    <message>
        <source>links</source>
        <translation>uzuvlar</translation>
    </message>
    <message>
        <source>decimal</source>
        <translation>ondalık</translation>
    </message>
    <message>
        <source>step</source>
        <translation>basamak</translation>
    </message>
    <message>
        <source>η</source>
        <translation>η</translation>
    </message>
    <message>
        <source>η back</source>
        <translation>η geri</translation>
    </message>
    <message>
        <source>circul.</source>
        <translation>dolaşan</translation>
    </message>
    <message>
        <source>state</source>
        <translation>durum</translation>
    </message>
    <message>
        <source> Eq. (%1)</source>
        <translation> Denk. (%1)</translation>
    </message>
    <message>
        <source>All gears on this link keep their teeth while other things change.</source>
        <translation>Başka şeyler değişirken bu uzuvdaki bütün dişliler diş sayılarını korur.</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Belge</translation>
    </message>
    <message>
        <source>Select a link, a joint or a mesh to see and change what belongs to it.</source>
        <translation>Özelliklerini görmek ve değiştirmek için bir uzuv, mafsal veya dişli çifti seçin.</translation>
    </message>
    <message>
        <source>Rename document</source>
        <translation>Belgeyi yeniden adlandır</translation>
    </message>
    <message>
        <source>Delete removes them with their joints and meshes.</source>
        <translation>Del onları mafsalları ve dişli çiftleriyle birlikte siler.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Mafsallar</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Dişliler</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Fren ve kavramalar</translation>
    </message>
    <message>
        <source>Brakes and clutches of this link</source>
        <translation>Bu uzvun fren ve kavramaları</translation>
    </message>
    <message>
        <source>Link 0, the ground</source>
        <translation>0 uzvu, sabit uzuv</translation>
    </message>
    <message>
        <source>Makes this link the ground: it becomes 0, and the other labels follow.</source>
        <translation>Bu uzvu sabit uzuv yapar: 0 olur, öbür etiketler izler.</translation>
    </message>
    <message>
        <source>Pin the axis</source>
        <translation>Ekseni sabitle</translation>
    </message>
    <message>
        <source>The axis keeps its place while other things change.</source>
        <translation>Başka şeyler değişirken eksen yerini korur.</translation>
    </message>
    <message>
        <source>several</source>
        <translation>birkaç</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eksen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Yön</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Öteleme</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Ters çevir</translation>
    </message>
    <message>
        <source>Exchange tail and head: the arrow turns round, and the speed changes its sign.</source>
        <translation>Kuyruk ve başı değiştir: ok döner, hız işaret değiştirir.</translation>
    </message>
    <message>
        <source>Flip joint</source>
        <translation>Mafsalı ters çevir</translation>
    </message>
    <message>
        <source>Move bearing</source>
        <translation>Yatağı taşı</translation>
    </message>
    <message>
        <source>The joint turns back no farther than this from the reference pose, in degrees: 0 or less. Empty: no limit.</source>
        <translation>Mafsal referans konumdan bundan fazla geri dönmez, derece: 0 veya az. Boş: sınır yok.</translation>
    </message>
    <message>
        <source>The joint turns on no farther than this from the reference pose, in degrees: 0 or more. Empty: no limit.</source>
        <translation>Mafsal referans konumdan bundan fazla ileri dönmez, derece: 0 veya çok. Boş: sınır yok.</translation>
    </message>
    <message>
        <source>Limit joint</source>
        <translation>Mafsalı sınırla</translation>
    </message>
    <message>
        <source>Limits, deg</source>
        <translation>Sınırlar, derece</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Yeni eksen</translation>
    </message>
    <message>
        <source>Change axis</source>
        <translation>Ekseni değiştir</translation>
    </message>
    <message>
        <source>Move axis</source>
        <translation>Ekseni taşı</translation>
    </message>
    <message>
        <source>Turn axis</source>
        <translation>Ekseni döndür</translation>
    </message>
    <message>
        <source>new axis</source>
        <translation>yeni eksen</translation>
    </message>
    <message>
        <source>%1 turning joints</source>
        <translation>%1 döner mafsal</translation>
    </message>
    <message>
        <source>Turning joint %1: %2 → %3</source>
        <translation>%1 döner mafsalı: %2 → %3</translation>
    </message>
    <message>
        <source>The axis is pinned.</source>
        <translation>Eksen sabitlenmiş.</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>kuyruk</translation>
    </message>
    <message>
        <source>head</source>
        <translation>baş</translation>
    </message>
    <message>
        <source>module</source>
        <translation>modül</translation>
    </message>
    <message>
        <source>The mesh keeps its module while other things change.</source>
        <translation>Başka şeyler değişirken dişli çifti modülünü korur.</translation>
    </message>
    <message>
        <source>This train has more than %1 meshes: axes and other wheels do not follow a change of teeth by themselves.</source>
        <translation>Bu takımda %1&apos;den çok dişli çifti var: eksenler ve öbür dişliler diş değişikliğini kendiliğinden izlemez.</translation>
    </message>
    <message>
        <source>from the geometry</source>
        <translation>geometriden</translation>
    </message>
    <message>
        <source>external</source>
        <translation>dış</translation>
    </message>
    <message>
        <source>internal</source>
        <translation>iç</translation>
    </message>
    <message>
        <source>bevel</source>
        <translation>konik</translation>
    </message>
    <message>
        <source>Teeth of gear %1</source>
        <translation>%1 dişlisinin diş sayısı</translation>
    </message>
    <message>
        <source>Teeth, tail</source>
        <translation>Diş, kuyruk</translation>
    </message>
    <message>
        <source>Teeth, head</source>
        <translation>Diş, baş</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Oran</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Modül</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>Pitch point</source>
        <translation>Hatve noktası</translation>
    </message>
    <message>
        <source>gear %1</source>
        <translation>%1 dişlisi</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Sabit</translation>
    </message>
    <message>
        <source>Exchange tail and head with their teeth: the arrow turns round.</source>
        <translation>Kuyruk ve başı dişleriyle değiştir: ok döner.</translation>
    </message>
    <message>
        <source>Change module</source>
        <translation>Modülü değiştir</translation>
    </message>
    <message>
        <source>Move pitch point</source>
        <translation>Hatve noktasını taşı</translation>
    </message>
    <message>
        <source>Flip mesh</source>
        <translation>Dişli çiftini ters çevir</translation>
    </message>
    <message>
        <source>Change teeth</source>
        <translation>Dişleri değiştir</translation>
    </message>
    <message>
        <source>%1 gear meshes</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>Gear mesh %1: %2 → %3</source>
        <translation>%1 dişli çifti: %2 → %3</translation>
    </message>
    <message>
        <source>The module is pinned.</source>
        <translation>Modül sabitlenmiş.</translation>
    </message>
    <message>
        <source>The gears have no places yet: see Problems.</source>
        <translation>Dişlilerin henüz yeri yok: Sorunlar&apos;a bakın.</translation>
    </message>
    <message>
        <source>They are of several kinds. Select elements of one kind to change them together.</source>
        <translation>Türleri farklı. Birlikte değiştirmek için aynı türden öğeler seçin.</translation>
    </message>
    <message>
        <source>Release all couplings</source>
        <translation>Bütün fren ve kavramaları ayır</translation>
    </message>
    <message>
        <source>Fixes it; Ctrl+Z undoes that</source>
        <translation>Düzeltir; Ctrl+Z geri alır</translation>
    </message>
    <message>
        <source>+ Brake</source>
        <translation>+ Fren</translation>
    </message>
    <message>
        <source>Hold a link against the ground: the selected one, or choose</source>
        <translation>Bir uzvu sabit uzva karşı tut: seçiliyi, ya da seçin</translation>
    </message>
    <message>
        <source>+ Clutch</source>
        <translation>+ Kavrama</translation>
    </message>
    <message>
        <source>Make two links turn as one: the two selected, or choose</source>
        <translation>İki uzvu birlikte döndür: seçili ikisini, ya da seçin</translation>
    </message>
    <message>
        <source>+ State</source>
        <translation>+ Durum</translation>
    </message>
    <message>
        <source>A new row: what is engaged together</source>
        <translation>Yeni satır: birlikte devreye alınanlar</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Tümünü ayır</translation>
    </message>
    <message>
        <source>Release every brake and clutch; the motion goes on (Ctrl+B)</source>
        <translation>Bütün fren ve kavramaları ayır; hareket sürer (Ctrl+B)</translation>
    </message>
    <message>
        <source>A gearbox has brakes, which hold a link, and clutches, which make two links turn as one. Select a link and add a brake, or two links and add a clutch; then add states that engage them.</source>
        <translation>Bir şanzımanda uzuv tutan frenler ve iki uzvu birlikte döndüren kavramalar vardır. Bir uzuv seçip fren, iki uzuv seçip kavrama ekleyin; sonra bunları devreye alan durumlar ekleyin.</translation>
    </message>
    <message>
        <source>Shift table</source>
        <translation>Vites tablosu</translation>
    </message>
    <message>
        <source>Rename state</source>
        <translation>Durumu yeniden adlandır</translation>
    </message>
    <message>
        <source>Rename coupling</source>
        <translation>Elemanı yeniden adlandır</translation>
    </message>
    <message>
        <source>Click a state to engage it, a letter to engage or release one coupling, a dot to change a state.</source>
        <translation>Devreye almak için bir duruma, bir elemanı açıp kapamak için harfe, durumu değiştirmek için noktaya tıklayın.</translation>
    </message>
    <message>
        <source>Torques in N m, for 1 N m at the drive.</source>
        <translation>Torklar N m, girişte 1 N m için.</translation>
    </message>
    <message>
        <source>Torques in N m, under the loads of the document.</source>
        <translation>Torklar N m, belgedeki yükler altında.</translation>
    </message>
    <message>
        <source>Click a letter to engage or release; add a state, then click its dots.</source>
        <translation>Devreye almak veya ayırmak için harfe tıklayın; durum ekleyin, sonra noktalarına tıklayın.</translation>
    </message>
    <message>
        <source>Add brake</source>
        <translation>Fren ekle</translation>
    </message>
    <message>
        <source>Add clutch</source>
        <translation>Kavrama ekle</translation>
    </message>
    <message>
        <source>Link %1 with</source>
        <translation>%1 uzvu ile</translation>
    </message>
    <message>
        <source>Add state</source>
        <translation>Durum ekle</translation>
    </message>
    <message>
        <source>Engage state %1</source>
        <translation>%1 durumunu devreye al</translation>
    </message>
    <message>
        <source>Put %1 into the state</source>
        <translation>%1 elemanını duruma koy</translation>
    </message>
    <message>
        <source>Take %1 out of the state</source>
        <translation>%1 elemanını durumdan çıkar</translation>
    </message>
    <message>
        <source>Choose drive</source>
        <translation>Girişi seç</translation>
    </message>
    <message>
        <source>Choose driven</source>
        <translation>Çıkışı seç</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Giriş</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Çıkış</translation>
    </message>
    <message>
        <source>Drive of all states</source>
        <translation>Bütün durumların girişi</translation>
    </message>
    <message>
        <source>Driven of all states</source>
        <translation>Bütün durumların çıkışı</translation>
    </message>
    <message>
        <source>Engage</source>
        <translation>Devreye al</translation>
    </message>
    <message>
        <source>Delete state</source>
        <translation>Durumu sil</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabloyu kopyala</translation>
    </message>
    <message>
        <source>Export table as CSV…</source>
        <translation>Tabloyu CSV olarak dışa aktar…</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Ayır</translation>
    </message>
    <message>
        <source>Delete coupling</source>
        <translation>Elemanı sil</translation>
    </message>
    <message>
        <source>No joint is driven yet. Choose the input tool (I), then click a turning joint.</source>
        <translation>Henüz tahrikli mafsal yok. Giriş aracını (I) seçin, sonra bir döner mafsala tıklayın.</translation>
    </message>
    <message>
        <source>Show more: %1 of %2 inputs are listed</source>
        <translation>Daha çok göster: %2 girişten %1 tanesi listelendi</translation>
    </message>
    <message>
        <source>link %1 held</source>
        <translation>%1 uzvu tutulu</translation>
    </message>
    <message>
        <source>links %1 and %2 as one</source>
        <translation>%1 ve %2 uzuvları tek parça</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Engaged: %1</source>
        <translation>Devrede: %1</translation>
    </message>
    <message>
        <source>Engaged: state %1, with %2</source>
        <translation>Devrede: %1 durumu, %2 ile</translation>
    </message>
    <message>
        <source>Colour of link %1</source>
        <translation>%1 uzvunun rengi</translation>
    </message>
    <message>
        <source>Drive another joint instead; the motion stays as it is</source>
        <translation>Yerine başka bir mafsalı tahrik et; hareket aynı kalır</translation>
    </message>
    <message>
        <source>Nothing is solved yet</source>
        <translation>Henüz bir şey çözülmedi</translation>
    </message>
    <message>
        <source>Joint %1 instead of %2</source>
        <translation>%2 yerine %1 mafsalı</translation>
    </message>
    <message>
        <source>Joint %1 never turns</source>
        <translation>%1 mafsalı hiç dönmez</translation>
    </message>
    <message>
        <source>Joint %1 does not depend on %2; it could replace %3</source>
        <translation>%1 mafsalı %2 mafsalına bağlı değil; %3 yerine geçebilir</translation>
    </message>
    <message>
        <source> or </source>
        <translation> veya </translation>
    </message>
    <message>
        <source>Choose inputs</source>
        <translation>Girişleri seç</translation>
    </message>
    <message>
        <source>There is nothing to drive yet. Draw a turning joint: T, then drag.</source>
        <translation>Henüz tahrik edilecek bir şey yok. Döner mafsal çizin: T, sonra sürükleyin.</translation>
    </message>
    <message>
        <source>There is nothing to drive: the mechanism has no degree of freedom.</source>
        <translation>Tahrik edilecek bir şey yok: mekanizmanın serbestlik derecesi yok.</translation>
    </message>
    <message>
        <source>Drive joint %1</source>
        <translation>%1 mafsalını tahrik et</translation>
    </message>
    <message>
        <source>Drive joints %1</source>
        <translation>%1 mafsallarını tahrik et</translation>
    </message>
    <message>
        <source>Set speed</source>
        <translation>Hızı belirle</translation>
    </message>
    <message>
        <source>Side wheels</source>
        <translation>Yan dişliler</translation>
    </message>
    <message>
        <source>Pinions&apos; teeth</source>
        <translation>Pinyonların dişleri</translation>
    </message>
    <message>
        <source>Pinions</source>
        <translation>Pinyonlar</translation>
    </message>
    <message>
        <source>Small sun</source>
        <translation>Küçük güneş</translation>
    </message>
    <message>
        <source>Large sun</source>
        <translation>Büyük güneş</translation>
    </message>
    <message>
        <source>Short planet</source>
        <translation>Kısa gezegen</translation>
    </message>
    <message>
        <source>Long planet</source>
        <translation>Uzun gezegen</translation>
    </message>
    <message>
        <source>Pairs of planets</source>
        <translation>Gezegen çiftleri</translation>
    </message>
    <message>
        <source>Suns</source>
        <translation>Güneş dişliler</translation>
    </message>
    <message>
        <source>Planets&apos; teeth</source>
        <translation>Gezegenlerin dişleri</translation>
    </message>
    <message>
        <source>Planets a set</source>
        <translation>Takım başına gezegen</translation>
    </message>
    <message>
        <source>Bend shaft</source>
        <translation>Bükme mili</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Bükme</translation>
    </message>
    <message>
        <source>Roll shaft</source>
        <translation>Yuvarlanma mili</translation>
    </message>
    <message>
        <source>Idler</source>
        <translation>Ara dişli</translation>
    </message>
    <message>
        <source>Idler&apos;s pinion</source>
        <translation>Ara dişli pinyonu</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Takım</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Yerleştir</translation>
    </message>
    <message>
        <source>Insert a set</source>
        <translation>Takım yerleştir</translation>
    </message>
    <message>
        <source>Planetary set</source>
        <translation>Planet dişli takımı</translation>
    </message>
    <message>
        <source>Reverted train</source>
        <translation>Geri dönüşlü dişli takımı</translation>
    </message>
    <message>
        <source>Bevel differential</source>
        <translation>Konik diferansiyel</translation>
    </message>
    <message>
        <source>Ravigneaux set</source>
        <translation>Ravigneaux takımı</translation>
    </message>
    <message>
        <source>Simpson set</source>
        <translation>Simpson takımı</translation>
    </message>
    <message>
        <source>Bevel wrist</source>
        <translation>Konik dişli bilek</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Kapat</translation>
    </message>
    <message>
        <source>%1 links, %2 joints, %3 meshes</source>
        <translation>%1 uzuv, %2 mafsal, %3 dişli çifti</translation>
    </message>
    <message>
        <source>; %1 couplings and %2 states</source>
        <translation>; %1 fren/kavrama ve %2 durum</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>ve %1 tane daha</translation>
    </message>
    <message>
        <source>%1 with %2, axis %3</source>
        <translation>%1, %2 ile, %3 ekseni</translation>
    </message>
    <message>
        <source>link </source>
        <translation>uzuv </translation>
    </message>
    <message>
        <source>%1 teeth in mesh %2 with %3</source>
        <translation>%1 diş, %2 dişli çiftinde, %3 ile</translation>
    </message>
    <message>
        <source>brake </source>
        <translation>fren </translation>
    </message>
    <message>
        <source>clutch </source>
        <translation>kavrama </translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1, %2 ile</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>ondalık</translation>
    </message>
    <message>
        <source>fractions</source>
        <translation>kesirler</translation>
    </message>
    <message>
        <source>symbols</source>
        <translation>simgeler</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matris</translation>
    </message>
    <message>
        <source>Export the matrix with its labels to a CSV file</source>
        <translation>Matrisi etiketleriyle CSV dosyasına aktar</translation>
    </message>
    <message>
        <source>zeros ·</source>
        <translation>sıfırlar ·</translation>
    </message>
    <message>
        <source>Show zeros as faint dots, or as 0</source>
        <translation>Sıfırları soluk nokta veya 0 olarak göster</translation>
    </message>
    <message>
        <source>zeros 0</source>
        <translation>sıfırlar 0</translation>
    </message>
    <message>
        <source>Copy ▾</source>
        <translation>Kopyala ▾</translation>
    </message>
    <message>
        <source>Copy the matrix with its labels</source>
        <translation>Matrisi etiketleriyle kopyala</translation>
    </message>
    <message>
        <source>Table (TSV)</source>
        <translation>Tablo (TSV)</translation>
    </message>
    <message>
        <source>A matrix of %1 entries is too large to be copied. Export it as CSV.</source>
        <translation>%1 öğeli matris kopyalanamayacak kadar büyük. CSV olarak dışa aktarın.</translation>
    </message>
    <message>
        <source>How the entries are shown: decimals, fractions or symbols</source>
        <translation>Öğelerin gösterimi: ondalık, kesir veya simge</translation>
    </message>
    <message>
        <source>The equations are too many to be written out.</source>
        <translation>Denklemler yazılamayacak kadar çok.</translation>
    </message>
    <message>
        <source>The matrices appear as soon as the mechanism is analysed.</source>
        <translation>Mekanizma çözümlenince matrisler görünür.</translation>
    </message>
    <message>
        <source>Draw the first link: L, then click.</source>
        <translation>İlk uzvu çizin: L, sonra tıklayın.</translation>
    </message>
    <message>
        <source>Draw a turning joint: T, then drag from a link to another.</source>
        <translation>Döner mafsal çizin: T, sonra bir uzuvdan öbürüne sürükleyin.</translation>
    </message>
    <message>
        <source>Draw a gear mesh: G, then drag from a gear to the one it drives.</source>
        <translation>Dişli çifti çizin: G, sonra bir dişliden tahrik ettiğine sürükleyin.</translation>
    </message>
    <message>
        <source>In %1; a length with another unit, such as 1/2 in or 2.5 cm, is converted.</source>
        <translation>%1 biriminde; 1/2 in veya 2,5 cm gibi başka birimli uzunluk çevrilir.</translation>
    </message>
    <message>
        <source>Type a whole number from %1 to %2.</source>
        <translation>%1 ile %2 arasında bir tam sayı yazın.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5 or 22/7, or a length such as 1/2 in.</source>
        <translation>12, 0,5 veya 22/7 gibi bir sayı ya da 1/2 in gibi bir uzunluk yazın.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5 or 22/7.</source>
        <translation>12, 0,5 veya 22/7 gibi bir sayı yazın.</translation>
    </message>
    <message>
        <source>No problems. Every link is tied to the ground, and the turning joints make a spanning tree.</source>
        <translation>Sorun yok. Her uzuv sabit uzva bağlı ve döner mafsallar kapsayan ağaç oluşturuyor.</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Kapat</translation>
    </message>
    <message>
        <source>Show the problems of the open document again</source>
        <translation>Açık belgenin sorunlarını yeniden göster</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 sorun</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 sorun</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. The document that was open stays open.</source>
        <translation>%1 açılamadı: %2. Açık olan belge açık kalır.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Sabitle</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Serbest bırak</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>oto</translation>
    </message>
    <message>
        <source>Coefficients as formulas in the gear ratios, or as fractions</source>
        <translation>Katsayılar dişli oranlarıyla formül veya kesir olarak</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Sonuçlar</translation>
    </message>
    <message>
        <source>The unit of the speeds, or the member they are taken as ratio to</source>
        <translation>Hızların birimi veya oranlandıkları öğe</translation>
    </message>
    <message>
        <source>ratio to %1</source>
        <translation>%1 için oran</translation>
    </message>
    <message>
        <source>rpm, turns a minute</source>
        <translation>dev/dk, dakikadaki devir</translation>
    </message>
    <message>
        <source>%1 more joints: select one to find it here</source>
        <translation>%1 mafsal daha: burada bulmak için birini seçin</translation>
    </message>
    <message>
        <source> (they are not independent)</source>
        <translation> (bağımsız değiller)</translation>
    </message>
    <message>
        <source>%1 more links: select one to find it here</source>
        <translation>%1 uzuv daha: burada bulmak için birini seçin</translation>
    </message>
    <message>
        <source>Every link turns on the ground</source>
        <translation>Her uzuv sabit uzuvda dönüyor</translation>
    </message>
    <message>
        <source>formulas</source>
        <translation>formüller</translation>
    </message>
    <message>
        <source>… (%1 in all)</source>
        <translation>… (toplam %1)</translation>
    </message>
    <message>
        <source>No joint is driven: %1 as input, at 1 rad/s each.</source>
        <translation>Tahrikli mafsal yok: %1 giriş, her biri 1 rad/s.</translation>
    </message>
    <message>
        <source>the set of joints %1</source>
        <translation>%1 mafsal kümesi</translation>
    </message>
    <message>
        <source>The two methods differ at %1 joints. Please report this document.</source>
        <translation>İki yöntem %1 mafsalda farklı. Lütfen bu belgeyi bildirin.</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly</source>
        <translation>Matroid yöntemi = T–T grafı yöntemi, tam olarak</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly, for all %1 joints</source>
        <translation>Matroid yöntemi = T–T grafı yöntemi, %1 mafsalın hepsi için tam olarak</translation>
    </message>
    <message>
        <source>Solving exactly, by both methods …</source>
        <translation>İki yöntemle tam olarak çözülüyor …</translation>
    </message>
    <message>
        <source>The results appear as soon as the mechanism is analysed.</source>
        <translation>Mekanizma çözümlenince sonuçlar görünür.</translation>
    </message>
    <message>
        <source>Rates appear when the first turning joint is drawn.</source>
        <translation>İlk döner mafsal çizilince hızlar görünür.</translation>
    </message>
    <message>
        <source>Every joint is an input: there is nothing left to solve for.</source>
        <translation>Her mafsal giriş: çözülecek bir şey kalmadı.</translation>
    </message>
    <message>
        <source>Ratio wanted</source>
        <translation>İstenen oran</translation>
    </message>
    <message>
        <source>error</source>
        <translation>hata</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>güneş</translation>
    </message>
    <message>
        <source>planet</source>
        <translation>gezegen</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>çember</translation>
    </message>
    <message>
        <source>sun to carrier, ring held</source>
        <translation>güneşten taşıyıcıya, çember tutulu</translation>
    </message>
    <message>
        <source>ring to carrier, sun held</source>
        <translation>çemberden taşıyıcıya, güneş tutulu</translation>
    </message>
    <message>
        <source>sun to ring, carrier held</source>
        <translation>güneşten çembere, taşıyıcı tutulu</translation>
    </message>
    <message>
        <source>carrier to sun, ring held</source>
        <translation>taşıyıcıdan güneşe, çember tutulu</translation>
    </message>
    <message>
        <source>carrier to ring, sun held</source>
        <translation>taşıyıcıdan çembere, güneş tutulu</translation>
    </message>
    <message>
        <source>ring to sun, carrier held</source>
        <translation>çemberden güneşe, taşıyıcı tutulu</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Nereden, nereye</translation>
    </message>
    <message>
        <source>Planets</source>
        <translation>Gezegenler</translation>
    </message>
    <message>
        <source>Fewest teeth</source>
        <translation>En az diş</translation>
    </message>
    <message>
        <source>Most teeth</source>
        <translation>En çok diş</translation>
    </message>
    <message>
        <source>first</source>
        <translation>birinci</translation>
    </message>
    <message>
        <source>second</source>
        <translation>ikinci</translation>
    </message>
    <message>
        <source>third</source>
        <translation>üçüncü</translation>
    </message>
    <message>
        <source>fourth</source>
        <translation>dördüncü</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>Baskı önizleme</translation>
    </message>
    <message>
        <source>Page %1 of %2: %3</source>
        <translation>Sayfa %1 / %2: %3</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Yazdır</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Ne</translation>
    </message>
    <message>
        <source>The drawing on a page of its own</source>
        <translation>Çizim kendi sayfasında</translation>
    </message>
    <message>
        <source>Derivation with its matrices</source>
        <translation>Matrisleriyle türetim</translation>
    </message>
    <message>
        <source>Both methods worked out step by step</source>
        <translation>İki yöntem adım adım</translation>
    </message>
    <message>
        <source>Page setup…</source>
        <translation>Sayfa yapısı…</translation>
    </message>
    <message>
        <source>Size and orientation of the paper</source>
        <translation>Kâğıt boyutu ve yönü</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Yazdır…</translation>
    </message>
    <message>
        <source>Choose a printer, or a PDF file</source>
        <translation>Yazıcı veya PDF dosyası seç</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Sayfa</translation>
    </message>
    <message>
        <source>The page that is shown</source>
        <translation>Gösterilen sayfa</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> / %1</translation>
    </message>
    <message>
        <source>Nothing is chosen.</source>
        <translation>Hiçbir şey seçilmedi.</translation>
    </message>
    <message>
        <source>There is no such page to print.</source>
        <translation>Yazdırılacak böyle bir sayfa yok.</translation>
    </message>
    <message>
        <source>The printer could not be opened.</source>
        <translation>Yazıcı açılamadı.</translation>
    </message>
    <message>
        <source>The printer stopped at page %1.</source>
        <translation>Yazıcı %1. sayfada durdu.</translation>
    </message>
    <message>
        <source>Printing was stopped.</source>
        <translation>Yazdırma durduruldu.</translation>
    </message>
    <message>
        <source>The printer reported an error.</source>
        <translation>Yazıcı hata bildirdi.</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept: no file can be written beside the document or in %1.</source>
        <translation>Kaydedilmemiş değişiklikler saklanamıyor: ne belgenin yanına ne de %1 içine dosya yazılabiliyor.</translation>
    </message>
    <message>
        <source>The schematic is still being laid out. Try again in a moment.</source>
        <translation>Şema hâlâ yerleştiriliyor. Biraz sonra yeniden deneyin.</translation>
    </message>
    <message>
        <source>Finding places for %1 links …</source>
        <translation>%1 uzva yer bulunuyor …</translation>
    </message>
    <message>
        <source>The schematic shows up to %1 links; this train has %2. Digraph and T–T graph show all of them</source>
        <translation>Şema en çok %1 uzuv gösterir; bu takımda %2 var. Yönlü graf ve T–T grafı hepsini gösterir</translation>
    </message>
    <message>
        <source>Draw the first shaft: L, then drag</source>
        <translation>İlk mili çizin: L, sonra sürükleyin</translation>
    </message>
    <message>
        <source>No turning joint ties a link to the ground yet. Draw a shaft: L, then drag</source>
        <translation>Henüz bir uzvu sabit uzva bağlayan döner mafsal yok. Bir mil çizin: L, sonra sürükleyin</translation>
    </message>
    <message>
        <source>Move axis %1</source>
        <translation>%1 eksenini taşı</translation>
    </message>
    <message>
        <source>%1. Alt places freely, Esc puts back</source>
        <translation>%1. Alt serbest yerleştirir, Esc geri koyar</translation>
    </message>
    <message>
        <source>Axis %1 is %2 from axis %3, module %4</source>
        <translation>%1 ekseni %3 ekseninden %2 uzakta, modül %4</translation>
    </message>
    <message>
        <source>Module %1, teeth as they are</source>
        <translation>Modül %1, dişler aynı</translation>
    </message>
    <message>
        <source>%1 : %2 teeth, %3 apart, %4 off</source>
        <translation>%1 : %2 diş, aralık %3, sapma %4</translation>
    </message>
    <message>
        <source>%1. Choose tooth counts instead, or Esc</source>
        <translation>%1. Yerine diş sayıları seçin, ya da Esc</translation>
    </message>
    <message>
        <source>Draw shaft</source>
        <translation>Mil çiz</translation>
    </message>
    <message>
        <source>Draw gear mesh</source>
        <translation>Dişli çifti çiz</translation>
    </message>
    <message>
        <source>Turning joint %1</source>
        <translation>%1 döner mafsalı</translation>
    </message>
    <message>
        <source>Gear mesh %1</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>Search a command or a term  Ctrl+K</source>
        <translation>Komut veya terim ara  Ctrl+K</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Ara</translation>
    </message>
    <message>
        <source>No command or term matches “%1”.</source>
        <translation>“%1” ile eşleşen komut veya terim yok.</translation>
    </message>
    <message>
        <source>element</source>
        <translation>öğe</translation>
    </message>
    <message>
        <source>term</source>
        <translation>terim</translation>
    </message>
    <message>
        <source>command</source>
        <translation>komut</translation>
    </message>
    <message>
        <source>Enter selects and shows it.</source>
        <translation>Enter seçer ve gösterir.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Equation (%1) of the paper.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Makalenin (%1) denklemi.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Shaft: drag along an axis, or on an empty area for a new axis</source>
        <translation>Mil: bir eksen boyunca, yeni eksen için boş alanda sürükleyin</translation>
    </message>
    <message>
        <source>Shaft: release where it ends. Esc cancels</source>
        <translation>Mil: bittiği yerde bırakın. Esc vazgeçer</translation>
    </message>
    <message>
        <source>Carried shaft: drag from the link that carries it to its place</source>
        <translation>Taşınan mil: taşıyan uzuvdan yerine sürükleyin</translation>
    </message>
    <message>
        <source>Carried shaft: release at the place of its axis. Esc cancels</source>
        <translation>Taşınan mil: ekseninin yerinde bırakın. Esc vazgeçer</translation>
    </message>
    <message>
        <source>Gear mesh: drag from a shaft to the one it drives</source>
        <translation>Dişli çifti: bir milden tahrik ettiğine sürükleyin</translation>
    </message>
    <message>
        <source>Gear mesh: release on the other shaft, or beyond it for a ring. Esc cancels</source>
        <translation>Dişli çifti: öbür milin üzerinde, çember için ötesinde bırakın. Esc vazgeçer</translation>
    </message>
    <message>
        <source>Input: click a turning joint, or the link it carries, to drive it or not</source>
        <translation>Giriş: tahrik etmek veya etmemek için döner mafsala ya da taşıdığı uzva tıklayın</translation>
    </message>
    <message>
        <source>Drag to move the sheet</source>
        <translation>Sayfayı kaydırmak için sürükleyin</translation>
    </message>
    <message>
        <source>Alt places freely. Esc puts back</source>
        <translation>Alt serbest yerleştirir. Esc geri koyar</translation>
    </message>
    <message>
        <source>Click to select, drag an axis to move it. The program lays the drawing out</source>
        <translation>Seçmek için tıklayın, taşımak için ekseni sürükleyin. Çizimi program yerleştirir</translation>
    </message>
    <message>
        <source>Gear mesh: drag from a gear to the gear it drives</source>
        <translation>Dişli çifti: bir dişliden tahrik ettiği dişliye sürükleyin</translation>
    </message>
    <message>
        <source>Turning joint: drag from a link to the link it carries</source>
        <translation>Döner mafsal: bir uzuvdan taşıdığı uzva sürükleyin</translation>
    </message>
    <message>
        <source>Gear mesh: release on the second gear. Esc cancels</source>
        <translation>Dişli çifti: ikinci dişlide bırakın. Esc vazgeçer</translation>
    </message>
    <message>
        <source>Turning joint: release on the link that is carried. Esc cancels</source>
        <translation>Döner mafsal: taşınan uzuvda bırakın. Esc vazgeçer</translation>
    </message>
    <message>
        <source>Release to select what is inside</source>
        <translation>İçindekileri seçmek için bırakın</translation>
    </message>
    <message>
        <source>Click to select, drag to move, drag on an empty area to select several</source>
        <translation>Seçmek için tıklayın, taşımak için sürükleyin, birkaçını seçmek için boş alanda sürükleyin</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seç</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Uzuv</translation>
    </message>
    <message>
        <source>Turning joint</source>
        <translation>Döner mafsal</translation>
    </message>
    <message>
        <source>Gear mesh</source>
        <translation>Dişli çifti</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Giriş</translation>
    </message>
    <message>
        <source>Link: click on an empty area</source>
        <translation>Uzuv: boş alana tıklayın</translation>
    </message>
    <message>
        <source>Qt&apos;s platform &quot;%1&quot; has no windows with OpenGL.</source>
        <translation>Qt&apos;nin &quot;%1&quot; platformunda OpenGL pencereleri yok.</translation>
    </message>
    <message>
        <source>This display offers no OpenGL 3.3.</source>
        <translation>Bu ekranda OpenGL 3.3 yok.</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>Coordinates beside the magnitudes of links and points</source>
        <translation>Uzuv ve nokta büyüklüklerinin yanında koordinatlar</translation>
    </message>
    <message>
        <source>Save what is plotted as CSV</source>
        <translation>Çizileni CSV olarak kaydet</translation>
    </message>
    <message>
        <source>Select joints or links; trace points in the 3D view.</source>
        <translation>Mafsal veya uzuv seçin; 3B görünümde noktaların izini çizdirin.</translation>
    </message>
    <message>
        <source>Nothing moves yet: the speeds appear here when the mechanism has valid inputs.</source>
        <translation>Henüz hareket yok: mekanizmanın geçerli girişleri olunca hızlar burada görünür.</translation>
    </message>
    <message>
        <source>Wheel: zoom in time; Ctrl+wheel: in value; drag: move; click: go there; double click: all</source>
        <translation>Tekerlek: zamanda yakınlaştır; Ctrl+tekerlek: değerde; sürükle: kaydır; tıkla: oraya git; çift tıkla: tümü</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>zaman, s</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>%1 s anında</translation>
    </message>
    <message>
        <source>One step back (,)</source>
        <translation>Bir adım geri (,)</translation>
    </message>
    <message>
        <source>One step on (.)</source>
        <translation>Bir adım ileri (.)</translation>
    </message>
    <message>
        <source>Speed and direction</source>
        <translation>Hız ve yön</translation>
    </message>
    <message>
        <source>Torques ×</source>
        <translation>Torklar ×</translation>
    </message>
    <message>
        <source>The motion that the torques of Dynamics cause is shown. Click to let the inputs run at their speeds again</source>
        <translation>Dinamik torklarının oluşturduğu hareket gösteriliyor. Girişlerin yeniden kendi hızlarıyla dönmesi için tıklayın</translation>
    </message>
    <message>
        <source>Backwards</source>
        <translation>Geriye</translation>
    </message>
    <message>
        <source>Drag through the motion that the torques cause</source>
        <translation>Torkların oluşturduğu hareket boyunca sürükleyin</translation>
    </message>
    <message>
        <source>Drag through one period of the motion</source>
        <translation>Hareketin bir periyodu boyunca sürükleyin</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Duraklat (Boşluk)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Oynat (Boşluk)</translation>
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
        <translation>Kesit</translation>
    </message>
    <message>
        <source>Cut square to %1</source>
        <translation>%1 yönüne dik kesit</translation>
    </message>
    <message>
        <source>Where the train is cut</source>
        <translation>Takımın kesildiği yer</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Döndür</translation>
    </message>
    <message>
        <source>Take away the other half</source>
        <translation>Öbür yarıyı kaldır</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Patlatılmış görünüş</translation>
    </message>
    <message>
        <source>How far the parts are moved apart along their axes</source>
        <translation>Parçaların eksenleri boyunca ne kadar ayrıldığı</translation>
    </message>
    <message>
        <source>Picture of the train</source>
        <translation>Dişli takımının resmi</translation>
    </message>
    <message>
        <source>Software 3D</source>
        <translation>Yazılımsal 3B</translation>
    </message>
    <message>
        <source>%1 Painted by the processor (%2): finer when nothing moves.</source>
        <translation>%1 İşlemci çiziyor (%2): hareket yokken daha ince.</translation>
    </message>
    <message>
        <source>All of the train in the view (F)</source>
        <translation>Bütün takım görünümde (F)</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>İzo</translation>
    </message>
    <message>
        <source>Isometric (0)</source>
        <translation>İzometrik (0)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Ön</translation>
    </message>
    <message>
        <source>From the front: x to the right, z up (1)</source>
        <translation>Önden: x sağa, z yukarı (1)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Sağ</translation>
    </message>
    <message>
        <source>From the right: y to the right, z up (2)</source>
        <translation>Sağdan: y sağa, z yukarı (2)</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Üst</translation>
    </message>
    <message>
        <source>From above: x to the right, y up (3)</source>
        <translation>Üstten: x sağa, y yukarı (3)</translation>
    </message>
    <message>
        <source>Cut the train open (S)</source>
        <translation>Takımı kesip aç (S)</translation>
    </message>
    <message>
        <source>What is shown, and how</source>
        <translation>Ne gösterilir ve nasıl</translation>
    </message>
    <message>
        <source>Limit reached: %1.</source>
        <translation>Sınıra ulaşıldı: %1.</translation>
    </message>
    <message>
        <source>Limit reached: %1. The motion turns round.</source>
        <translation>Sınıra ulaşıldı: %1. Hareket yön değiştirir.</translation>
    </message>
    <message>
        <source>Nothing to turn yet: place axes and give the meshes their teeth.</source>
        <translation>Henüz döndürülecek bir şey yok: eksenleri yerleştirin ve dişli çiftlerine diş sayısı verin.</translation>
    </message>
    <message>
        <source>The point travels %1 %2 in %3 s.</source>
        <translation>Nokta %3 s içinde %1 %2 yol alır.</translation>
    </message>
    <message>
        <source>not asked (GEARGRAPH_3D is set)</source>
        <translation>sorulmadı (GEARGRAPH_3D ayarlı)</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>sabit uzuv</translation>
    </message>
    <message>
        <source>The gears are being made …</source>
        <translation>Dişliler oluşturuluyor …</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Gölgeli</translation>
    </message>
    <message>
        <source>Lines, hidden ones left out</source>
        <translation>Çizgiler, gizliler olmadan</translation>
    </message>
    <message>
        <source>All edges</source>
        <translation>Bütün kenarlar</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketler</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Uzuvlar</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Eksenler</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Ölçek çubuğu</translation>
    </message>
    <message>
        <source>Pitch circles and cones</source>
        <translation>Hatve daireleri ve konileri</translation>
    </message>
    <message>
        <source>Pitch points</source>
        <translation>Hatve noktaları</translation>
    </message>
    <message>
        <source>Instantaneous axes</source>
        <translation>Ani dönme eksenleri</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Hızlar</translation>
    </message>
    <message>
        <source>Forces under the loads</source>
        <translation>Yükler altındaki kuvvetler</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Göster</translation>
    </message>
    <message>
        <source>Orbit; Shift pans, Ctrl zooms (Blender)</source>
        <translation>Çevresinde dön; Shift kaydırır, Ctrl yakınlaştırır (Blender)</translation>
    </message>
    <message>
        <source>Pan; Shift orbits, Ctrl zooms (FreeCAD)</source>
        <translation>Kaydır; Shift çevresinde döndürür, Ctrl yakınlaştırır (FreeCAD)</translation>
    </message>
    <message>
        <source>Orbit; Ctrl pans, Shift zooms (SolidWorks)</source>
        <translation>Çevresinde dön; Ctrl kaydırır, Shift yakınlaştırır (SolidWorks)</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Orta düğme</translation>
    </message>
    <message>
        <source>Stop riding along</source>
        <translation>Birlikte gitmeyi bırak</translation>
    </message>
    <message>
        <source>Show all parts</source>
        <translation>Bütün parçaları göster</translation>
    </message>
    <message>
        <source>Save the traced path as CSV…</source>
        <translation>Çizilen yörüngeyi CSV olarak kaydet…</translation>
    </message>
    <message>
        <source>Clear traced paths</source>
        <translation>Çizilen yörüngeleri sil</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Arkadan</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Soldan</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Alttan</translation>
    </message>
    <message>
        <source>Dim what is not selected</source>
        <translation>Seçilmeyenleri soluklaştır</translation>
    </message>
    <message>
        <source>Follow %1</source>
        <translation>%1 öğesini izle</translation>
    </message>
    <message>
        <source>Look along its axis</source>
        <translation>Ekseni boyunca bak</translation>
    </message>
    <message>
        <source>Trace this point</source>
        <translation>Bu noktanın izini çiz</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Gizle</translation>
    </message>
    <message>
        <source>Hide all others</source>
        <translation>Öbürlerinin hepsini gizle</translation>
    </message>
    <message>
        <source>Drag the part to turn the train. Ctrl turns it alone by hand</source>
        <translation>Takımı döndürmek için parçayı sürükleyin. Ctrl yalnız onu elle döndürür</translation>
    </message>
    <message>
        <source>Drag the part to turn it by hand</source>
        <translation>Elle döndürmek için parçayı sürükleyin</translation>
    </message>
    <message>
        <source>Drag to orbit: the train moves as its torques make it</source>
        <translation>Sürükleme çevresinde döndürür: takım torklarının götürdüğü gibi hareket eder</translation>
    </message>
    <message>
        <source>Drag to orbit: this part does not turn</source>
        <translation>Sürükleme çevresinde döndürür: bu parça dönmez</translation>
    </message>
    <message>
        <source>Drag to orbit, with Shift to pan; the wheel zooms</source>
        <translation>Sürükleme çevresinde döndürür, Shift ile kaydırır; tekerlek yakınlaştırır</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>&amp;Dil</translation>
    </message>
    <message>
        <source>The language of the system, where the program speaks it</source>
        <translation>Program konuşuyorsa sistemin dili</translation>
    </message>
    <message>
        <source>The language can be changed when the export is finished.</source>
        <translation>Dil, dışa aktarma bitince değiştirilebilir.</translation>
    </message>
    <message>
        <source>Moving links</source>
        <translation>Hareketli uzuvlar</translation>
    </message>
    <message>
        <source>The number of links without the ground. They bear the labels 1 to n; the ground is 0.</source>
        <translation>Sabit uzuv dışındaki uzuvların sayısı. Etiketleri 1&apos;den n&apos;ye; sabit uzuv 0&apos;dır.</translation>
    </message>
    <message>
        <source>Turning joints</source>
        <translation>Döner mafsallar</translation>
    </message>
    <message>
        <source>The number of turning pairs. They bear the labels n+1 to n+t. As a spanning tree they are as many as the moving links.</source>
        <translation>Döner mafsalların sayısı. Etiketleri n+1&apos;den n+t&apos;ye. Kapsayan ağaç olarak hareketli uzuvlar kadardırlar.</translation>
    </message>
    <message>
        <source>Gear meshes</source>
        <translation>Dişli çiftleri</translation>
    </message>
    <message>
        <source>The number of gear pairs. They bear the labels n+t+1 to n+t+c. Each closes one cycle of the basis.</source>
        <translation>Dişli çiftlerinin sayısı. Etiketleri n+t+1&apos;den n+t+c&apos;ye. Her biri tabanın bir çevrimini kapatır.</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rank</translation>
    </message>
    <message>
        <source>The number of independent equations that the meshes put on the turning joints: the rank r of the coefficient matrix P.</source>
        <translation>Dişli çiftlerinin döner mafsallara koyduğu bağımsız denklemlerin sayısı: P katsayı matrisinin rankı r.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Serbestlik derecesi</translation>
    </message>
    <message>
        <source>How many joints have to be driven so that the motion of all others follows: E = t − r.</source>
        <translation>Öbürlerinin hareketinin belirlenmesi için kaç mafsalın tahrik edilmesi gerektiği: E = t − r.</translation>
    </message>
    <message>
        <source>Incidence matrix</source>
        <translation>Bağlantı matrisi</translation>
    </message>
    <message>
        <source>A row for each link and a column for each joint and mesh: 1 where its arrow ends, −1 where it begins.</source>
        <translation>Her uzuv için bir satır, her mafsal ve dişli çifti için bir sütun: okunun bittiği yerde 1, başladığı yerde −1.</translation>
    </message>
    <message>
        <source>Reduced incidence matrix</source>
        <translation>İndirgenmiş bağlantı matrisi</translation>
    </message>
    <message>
        <source>The incidence matrix without the ground&apos;s row, so that its rows are independent. G holds the turning joints, G* the meshes.</source>
        <translation>Satırları bağımsız olsun diye sabit uzvun satırı çıkarılmış bağlantı matrisi. G döner mafsalları, G* dişli çiftlerini içerir.</translation>
    </message>
    <message>
        <source>Path matrix</source>
        <translation>Yol matrisi</translation>
    </message>
    <message>
        <source>A column for each link tells its walk through the tree to the ground: 1 where the walk runs along a joint, −1 where it runs against it.</source>
        <translation>Her uzuv için bir sütun, ağaç üzerinden sabit uzva giden yolu anlatır: yol bir mafsalla aynı yöndeyse 1, tersse −1.</translation>
    </message>
    <message>
        <source>Spanning-tree matrix</source>
        <translation>Kapsayan ağaç matrisi</translation>
    </message>
    <message>
        <source>A row for each mesh tells which turning joints its cycle runs along (1) or against (−1): T = G*ᵀ Zᵀ.</source>
        <translation>Her dişli çifti için bir satır, çevriminin hangi döner mafsallarla (1) veya onlara ters (−1) gittiğini söyler: T = G*ᵀ Zᵀ.</translation>
    </message>
    <message>
        <source>Cycle-basis matrix</source>
        <translation>Çevrim tabanı matrisi</translation>
    </message>
    <message>
        <source>A row for each cycle that a mesh closes: T holds its turning joints, the unit matrix U its mesh.</source>
        <translation>Bir dişli çiftinin kapattığı her çevrim için bir satır: T döner mafsallarını, U birim matrisi dişli çiftini içerir.</translation>
    </message>
    <message>
        <source>Fundamental cutset matrix</source>
        <translation>Temel kesitleme matrisi</translation>
    </message>
    <message>
        <source>A row for each turning joint tells which edges join the two halves that the tree falls into without it.</source>
        <translation>Her döner mafsal için bir satır, o olmadan ağacın ayrıldığı iki yarıyı hangi kenarların birleştirdiğini söyler.</translation>
    </message>
    <message>
        <source>The mechanism as a directed graph: a node for each link, a solid arrow for each turning joint, a dashed arrow for each gear mesh.</source>
        <translation>Yönlü graf olarak mekanizma: her uzuv bir düğüm, her döner mafsal düz bir ok, her dişli çifti kesikli bir ok.</translation>
    </message>
    <message>
        <source>Functional schematic</source>
        <translation>İşlevsel şema</translation>
    </message>
    <message>
        <source>The mechanism in section, with the symbols of ISO 3952: axes dash-dotted, shafts as thick lines, bearings as bars about them, gears as pitch lines, the frame hatched.</source>
        <translation>Kesit olarak mekanizma, ISO 3952 simgeleriyle: eksenler noktalı kesik, miller kalın çizgi, yataklar çevrelerinde çubuk, dişliler hatve çizgisi, gövde taralı.</translation>
    </message>
    <message>
        <source>A rigid body: a gear, a carrier arm, a shaft, or several of them in one.</source>
        <translation>Rijit bir cisim: dişli, taşıyıcı kol, mil, veya bunların birkaçı bir arada.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sabit uzuv</translation>
    </message>
    <message>
        <source>The fixed link. All others are connected to it by turning joints.</source>
        <translation>Sabit olan uzuv. Öbürlerinin hepsi ona döner mafsallarla bağlıdır.</translation>
    </message>
    <message>
        <source>Two links that turn relative to each other about an axis. Positive speed turns the head about the axis&apos; direction relative to the tail.</source>
        <translation>Bir eksen etrafında birbirine göre dönen iki uzuv. Pozitif hız, başı kuyruğa göre eksen yönü etrafında döndürür.</translation>
    </message>
    <message>
        <source>Two toothed wheels that roll on each other at a pitch point.</source>
        <translation>Bir hatve noktasında birbiri üzerinde yuvarlanan iki dişli.</translation>
    </message>
    <message>
        <source>A turning joint that a motor drives at a speed of its own. There are as many as degrees of freedom.</source>
        <translation>Bir motorun kendi hızıyla tahrik ettiği döner mafsal. Serbestlik derecesi kadardırlar.</translation>
    </message>
    <message>
        <source>The line that turning joints turn about, the level of the T–T graph. Joints that stay coaxial share one.</source>
        <translation>Döner mafsalların etrafında döndüğü doğru, T–T grafının düzeyi. Eş eksenli kalan mafsallar birini paylaşır.</translation>
    </message>
    <message>
        <source>Point of the axis</source>
        <translation>Eksenin noktası</translation>
    </message>
    <message>
        <source>A point that the axis goes through in the reference pose. Without it the axis is placed from the tooth counts.</source>
        <translation>Referans konumda eksenin geçtiği bir nokta. Verilmezse eksen diş sayılarından yerleştirilir.</translation>
    </message>
    <message>
        <source>Direction of the axis</source>
        <translation>Eksenin yönü</translation>
    </message>
    <message>
        <source>The direction of the axis in the reference pose, of any length but 0. Positive speed turns about it by the right-hand rule.</source>
        <translation>Referans konumda eksenin yönü, 0 dışında her uzunlukta. Pozitif hız onun etrafında sağ el kuralıyla döner.</translation>
    </message>
    <message>
        <source>Where along the axis the bearing is drawn, from the axis&apos; point.</source>
        <translation>Yatağın eksen boyunca, eksenin noktasından ölçülerek çizildiği yer.</translation>
    </message>
    <message>
        <source>Joint limits</source>
        <translation>Mafsal sınırları</translation>
    </message>
    <message>
        <source>How far the joint may turn from the reference pose, both ways, in degrees.</source>
        <translation>Mafsalın referans konumdan iki yöne ne kadar dönebileceği, derece.</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Diş</translation>
    </message>
    <message>
        <source>The whole number of teeth of a wheel. Pitch diameters are proportional to it.</source>
        <translation>Bir dişlinin tam sayı olan diş sayısı. Hatve çapları onunla orantılıdır.</translation>
    </message>
    <message>
        <source>The pitch diameter of a wheel over its teeth, one for both wheels of a mesh; of bevels at the large end. Another module moves the axes and changes no ratio.</source>
        <translation>Bir dişlinin hatve çapı bölü diş sayısı, çiftin iki dişlisi için aynı; koniklerde büyük uçta. Başka bir modül eksenleri taşır, oranları değiştirmez.</translation>
    </message>
    <message>
        <source>Kind of mesh</source>
        <translation>Dişli çiftinin türü</translation>
    </message>
    <message>
        <source>External, internal (one wheel is a ring) or bevel (the axes meet). Without it the geometry tells.</source>
        <translation>Dış, iç (bir dişli çemberdir) veya konik (eksenler kesişir). Verilmezse geometri belirler.</translation>
    </message>
    <message>
        <source>Where the two pitch surfaces touch in the reference pose. Without it the point follows from axes and teeth.</source>
        <translation>Referans konumda iki hatve yüzeyinin değdiği yer. Verilmezse nokta eksenlerden ve dişlerden bulunur.</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Dişli oranı</translation>
    </message>
    <message>
        <source>The teeth of the mesh&apos;s tail over those of its head.</source>
        <translation>Dişli çiftinin kuyruğundaki diş sayısı bölü başındaki.</translation>
    </message>
    <message>
        <source>Spanning tree</source>
        <translation>Kapsayan ağaç</translation>
    </message>
    <message>
        <source>The turning joints, if they tie every link to the ground and close no loop.</source>
        <translation>Her uzvu sabit uzva bağlayıp çevrim kapatmayan döner mafsallar.</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Çevrim</translation>
    </message>
    <message>
        <source>A mesh and the path through the tree that leads back from its head to its tail.</source>
        <translation>Bir dişli çifti ve ağaç üzerinden başından kuyruğuna geri dönen yol.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiket</translation>
    </message>
    <message>
        <source>The paper&apos;s number of a link, joint or mesh. It follows from the order of the elements.</source>
        <translation>Makalede bir uzvun, mafsalın veya dişli çiftinin numarası. Öğelerin sırasından gelir.</translation>
    </message>
    <message>
        <source>Screw</source>
        <translation>Vida</translation>
    </message>
    <message>
        <source>A joint&apos;s axis as seen from a pitch point: its unit direction (L M N) and its moment (P Q R), the velocity that the point gets for one unit of speed.</source>
        <translation>Bir mafsalın bir hatve noktasından görülen ekseni: birim yönü (L M N) ve momenti (P Q R), yani birim hız için noktanın aldığı hız.</translation>
    </message>
    <message>
        <source>Coefficient matrix</source>
        <translation>Katsayı matrisi</translation>
    </message>
    <message>
        <source>A row for each mesh: the moment of each joint of its cycle about the pitch point, times T. P θ̇ = 0 holds for every motion; divided by the head&apos;s radius a row holds only ratios and ones.</source>
        <translation>Her dişli çifti için bir satır: çevrimindeki her mafsalın hatve noktası etrafındaki momenti çarpı T. Her hareket için P θ̇ = 0; başın yarıçapına bölünen satırda yalnız oranlar ve birler kalır.</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Çözüm</translation>
    </message>
    <message>
        <source>The rate of every other joint for one unit of each input: minus the inverse of P&apos;s output part times its input part.</source>
        <translation>Her girişin bir birimi için öbür mafsalların her birinin hızı: eksi P&apos;nin çıkış bölümünün tersi çarpı giriş bölümü.</translation>
    </message>
    <message>
        <source>The mechanism after Tsai and Tokad: a node for each link, a branch of the tree for each turning joint with the level it turns on, and for each gear mesh two chords, from its gears to their carrier arm. An arrow from i to k carries the velocity of link i relative to link k.</source>
        <translation>Tsai ve Tokad&apos;a göre mekanizma: her uzuv bir düğüm, her döner mafsal üzerinde döndüğü düzeyle bir ağaç dalı, her dişli çifti için dişlilerinden taşıyıcı kollarına iki kiriş. i&apos;den k&apos;ye ok, i uzvunun k uzvuna göre hızını taşır.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Düzey</translation>
    </message>
    <message>
        <source>The axis that a branch of the T–T graph turns about. Joints that stay coaxial in every motion are on one level.</source>
        <translation>T–T grafının bir dalının etrafında döndüğü eksen. Her harekette eş eksenli kalan mafsallar aynı düzeydedir.</translation>
    </message>
    <message>
        <source>Transfer vertex</source>
        <translation>Aktarma düğümü</translation>
    </message>
    <message>
        <source>The carrier arm of a gear mesh: the node on the walk from gear to gear through the tree where the level changes.</source>
        <translation>Bir dişli çiftinin taşıyıcı kolu: ağaç üzerinden dişliden dişliye giderken düzeyin değiştiği düğüm.</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Kiriş</translation>
    </message>
    <message>
        <source>A thin line from a gear of a mesh to its transfer vertex. The two chords of a mesh bear the same number of primes. Chords are no part of the tree: each closes one f-circuit.</source>
        <translation>Bir çiftin bir dişlisinden aktarma düğümüne ince çizgi. Bir çiftin iki kirişi aynı sayıda üs imi taşır. Kirişler ağaçtan değildir: her biri bir f-devresi kapatır.</translation>
    </message>
    <message>
        <source>Terminal equation</source>
        <translation>Uç denklemi</translation>
    </message>
    <message>
        <source>The relation between the two chords of a mesh: the velocity of gear i relative to the carrier arm is that of gear j times ± N(j) / N(i), plus where both gears turn the same way, seen from the arm.</source>
        <translation>Bir dişli çiftinin iki kirişi arasındaki bağıntı: i dişlisinin taşıyıcı kola göre hızı, j dişlisininki çarpı ± N(j) / N(i); koldan bakıldığında ikisi aynı yönde dönüyorsa artı.</translation>
    </message>
    <message>
        <source>f-circuit</source>
        <translation>f-devresi</translation>
    </message>
    <message>
        <source>A chord and the branches between its two ends: the velocity of the chord is the sum of theirs, with signs by their direction. Eqs. (31) to (38) are the paper&apos;s.</source>
        <translation>Bir kiriş ve iki ucu arasındaki dallar: kirişin hızı, yönlerine göre işaretlerle onlarınkinin toplamıdır. (31)–(38) denklemleri makalenindir.</translation>
    </message>
    <message>
        <source>
Drag to change the load; W types it</source>
        <translation>
Sürüklemek yükü değiştirir; W ile yazılır</translation>
    </message>
    <message>
        <source>%1 N m. %2</source>
        <translation>%1 N m. %2</translation>
    </message>
    <message>
        <source>What is plotted</source>
        <translation>Ne çizilir</translation>
    </message>
    <message>
        <source>torques that hold the loads</source>
        <translation>yükleri tutan torklar</translation>
    </message>
    <message>
        <source>What it is plotted over; all else stays as it is</source>
        <translation>Neye göre çizilir; diğer her şey olduğu gibi kalır</translation>
    </message>
    <message>
        <source>What it is plotted over</source>
        <translation>Neye göre çizilir</translation>
    </message>
    <message>
        <source>over</source>
        <translation>göre</translation>
    </message>
    <message>
        <source>The efficiency could not be followed: %1</source>
        <translation>Verim izlenemedi: %1</translation>
    </message>
    <message>
        <source>A plot needs loads that are held, one way to hold them, and a motion.</source>
        <translation>Grafik için tutulan yükler, bunları tutmanın tek bir yolu ve bir hareket gerekir.</translation>
    </message>
    <message>
        <source>torque, N m</source>
        <translation>tork, N m</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>ileri</translation>
    </message>
    <message>
        <source>Plot of the efficiency</source>
        <translation>Verim grafiği</translation>
    </message>
    <message>
        <source>The pointer, or the left and right arrow keys, read the values</source>
        <translation>Değerleri fare imleci ya da sol ve sağ ok tuşları okur</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>T: torque in a joint; M: torque of a mesh on the part beyond the joint; both about the joint&apos;s axis. What the joint cuts off, and what crosses, is lit in all views.</source>
        <translation>T: bir mafsaldaki tork; M: bir dişli çiftinin mafsalın ötesindeki parçaya torku; ikisi de mafsalın ekseni etrafında. Mafsalın ayırdığı parça ve karşıya geçenler tüm görünümlerde parlar.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Grafikler</translation>
    </message>
    <message>
        <source>Efficiency and torques over the ratio of two speeds, or over the efficiency of the meshes</source>
        <translation>İki hızın oranına ya da dişli çiftlerinin verimine göre verim ve torklar</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>El kitabı</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>El kitabının içindekiler</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Geri (Alt+Sol)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>İleri (Alt+Sağ)</translation>
    </message>
    <message>
        <source>Find in the manual  Ctrl+F</source>
        <translation>El kitabında bul  Ctrl+F</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>El kitabında bul</translation>
    </message>
    <message>
        <source>Return goes to the next place, through all pages (Ctrl+F)</source>
        <translation>Enter tüm sayfalarda sonraki yere gider (Ctrl+F)</translation>
    </message>
    <message>
        <source>Manual: %1</source>
        <translation>El kitabı: %1</translation>
    </message>
    <message>
        <source>This is the first page that you opened.</source>
        <translation>Açtığınız ilk sayfa bu.</translation>
    </message>
    <message>
        <source>This is the last page that you opened.</source>
        <translation>Açtığınız son sayfa bu.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Bulunamadı</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Tur</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Atla</translation>
    </message>
    <message>
        <source>Help &gt; Tour shows it again (Esc)</source>
        <translation>Yardım &gt; Tur yeniden gösterir (Esc)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Geri</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>The part before (Left)</source>
        <translation>Önceki bölüm (Sol)</translation>
    </message>
    <message>
        <source>This is the beginning.</source>
        <translation>Başlangıç burası.</translation>
    </message>
    <message>
        <source>To the window (Return)</source>
        <translation>Pencereye (Enter)</translation>
    </message>
    <message>
        <source>The next part (Right)</source>
        <translation>Sonraki bölüm (Sağ)</translation>
    </message>
    <message>
        <source>F1 opens the page of the manual.</source>
        <translation>F1 el kitabının sayfasını açar.</translation>
    </message>
    <message>
        <source>A lesson is played in this window: take the tour in another one.</source>
        <translation>Bu pencerede bir ders oynatılıyor: turu başka bir pencerede yapın.</translation>
    </message>
    <message>
        <source>Web page with exercises (*.html)</source>
        <translation>Alıştırmalı web sayfası (*.html)</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism: export it without exercises.</source>
        <translation>Bu mekanizma hakkında soru sorulamıyor: alıştırmasız dışa aktarın.</translation>
    </message>
    <message>
        <source>Load a joint or a link: drag for its torque, or click and type 10 Nm; where one is selected, its torque is typed at once</source>
        <translation>Bir mafsalı ya da uzvu yükleyin: torku için sürükleyin ya da tıklayıp 10 Nm yazın; biri seçiliyse torku hemen yazılır</translation>
    </message>
    <message>
        <source>T&amp;orque…</source>
        <translation>T&amp;ork…</translation>
    </message>
    <message>
        <source>Find a command, an element, a term or a page of the manual</source>
        <translation>Bir komut, öğe, terim ya da el kitabı sayfası bul</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;El kitabı</translation>
    </message>
    <message>
        <source>The page of the manual about what has the focus</source>
        <translation>Odaktaki öğeyle ilgili el kitabı sayfası</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this</source>
        <translation>Bu &amp;nedir?</translation>
    </message>
    <message>
        <source>Then click something to learn what it is for</source>
        <translation>Sonra ne işe yaradığını öğrenmek için bir şeye tıklayın</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Tur</translation>
    </message>
    <message>
        <source>The parts of the window in two minutes</source>
        <translation>İki dakikada pencerenin bölümleri</translation>
    </message>
    <message>
        <source>There is no command %1 in this window.</source>
        <translation>Bu pencerede %1 komutu yok.</translation>
    </message>
    <message>
        <source>Welcome to GearGraph</source>
        <translation>GearGraph&apos;a hoş geldiniz</translation>
    </message>
    <message>
        <source>Gear trains as graphs, as equations, and in motion. The tour shows the parts of the window with a robot as example; it takes two minutes. Help &gt; Tour repeats it.</source>
        <translation>Dişli takımları graf, denklem ve hareket olarak. Tur, pencerenin bölümlerini bir robot örneğiyle gösterir; iki dakika sürer. Yardım &gt; Tur yineler.</translation>
    </message>
    <message>
        <source>Draw links, joints and meshes</source>
        <translation>Uzuv, mafsal ve dişli çiftleri çizin</translation>
    </message>
    <message>
        <source>Each circle is a link, each solid arrow a turning joint, each dashed arrow a pair of gears. Press L and click for a link, T or G and drag from one link to another. Everything can be undone.</source>
        <translation>Her daire bir uzuv, her düz ok bir döner mafsal, her kesikli ok bir dişli çiftidir. Uzuv için L&apos;ye basıp tıklayın; T ya da G ile bir uzuvdan diğerine sürükleyin. Her şey geri alınabilir.</translation>
    </message>
    <message>
        <source>The Matroid method</source>
        <translation>Matroid yöntemi</translation>
    </message>
    <message>
        <source>The matrices follow from the drawing at once. Rest the mouse on an entry to have it explained; the arrow that it stands for lights up. Each row of C is the cycle that a mesh closes.</source>
        <translation>Matrisler çizimi hemen izler. Açıklaması için fareyi bir öğenin üzerinde tutun; karşılık geldiği ok parlar. C&apos;nin her satırı bir dişli çiftinin kapattığı çevrimdir.</translation>
    </message>
    <message>
        <source>The T–T graph method</source>
        <translation>T–T graf yöntemi</translation>
    </message>
    <message>
        <source>The same mechanism by the second method: levels on the branches, two chords for each mesh, carrier arms with a second ring. Select a mesh to see its equations. Both methods give the same speeds.</source>
        <translation>Aynı mekanizma ikinci yöntemle: dallarda düzeyler, her dişli çifti için iki kiriş, ikinci halkalı taşıyıcılar. Denklemlerini görmek için bir dişli çifti seçin. İki yöntem de aynı hızları verir.</translation>
    </message>
    <message>
        <source>The gears in motion</source>
        <translation>Dişliler hareket halinde</translation>
    </message>
    <message>
        <source>Space plays. Drag a gear to turn the train by hand, drag elsewhere to look from another side. Section cuts it open.</source>
        <translation>Boşluk tuşu oynatır. Takımı elle döndürmek için bir dişliyi, başka yandan bakmak için boş yeri sürükleyin. Kesit takımı keserek açar.</translation>
    </message>
    <message>
        <source>Motors and speeds</source>
        <translation>Motorlar ve hızlar</translation>
    </message>
    <message>
        <source>The sliders set the speeds of the motors. Below are the speeds of all other joints: as formulas in the gear ratios, and as they are now.</source>
        <translation>Kaydırıcılar motorların hızlarını ayarlar. Altında diğer tüm mafsalların hızları vardır: dişli oranlarıyla formül olarak ve şu anki değerleriyle.</translation>
    </message>
    <message>
        <source>When something is wrong</source>
        <translation>Bir şey yanlış olduğunda</translation>
    </message>
    <message>
        <source>Problems says what is wrong, where, and what to do. A click on a line shows the place, and many lines bring a button that mends it.</source>
        <translation>Sorunlar neyin, nerede yanlış olduğunu ve ne yapılacağını söyler. Satıra tıklamak yerini gösterir; birçok satırda düzelten bir düğme vardır.</translation>
    </message>
    <message>
        <source>Learn, and find anything</source>
        <translation>Öğrenin, her şeyi bulun</translation>
    </message>
    <message>
        <source>Learn &gt; Lessons is a course from one gear pair to this robot. Ctrl+K finds commands, terms and pages of the manual. F1 opens the page about what you are working with.</source>
        <translation>Öğren &gt; Dersler tek bir dişli çiftinden bu robota kadar bir kurstur. Ctrl+K komutları, terimleri ve el kitabının sayfalarını bulur. F1 üzerinde çalıştığınız şeyin sayfasını açar.</translation>
    </message>
    <message>
        <source>Find a command, an element, a term or a page of the manual (Ctrl+K)</source>
        <translation>Bir komut, öğe, terim ya da el kitabı sayfası bul (Ctrl+K)</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>el kitabı</translation>
    </message>
    <message>
        <source>F1 shows it with a picture and its lesson. Type to search on; Esc closes.</source>
        <translation>F1 resmi ve dersiyle gösterir. Aramayı sürdürmek için yazın; Esc kapatır.</translation>
    </message>
    <message>
        <source>Load: drag from a turning joint or a link for its torque, or click it and type 10 Nm</source>
        <translation>Yük: torku için bir döner mafsaldan ya da uzuvdan sürükleyin ya da tıklayıp 10 Nm yazın</translation>
    </message>
    <message>
        <source>Load: to the right or upwards is more; Alt: tenths. Esc puts back</source>
        <translation>Yük: sağa ya da yukarı artırır; Alt: onda birler. Esc geri koyar</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Yük</translation>
    </message>
    <message>
        <source>Check &amp;my matrices…</source>
        <translation>&amp;Matrislerimi denetle…</translation>
    </message>
    <message>
        <source>Matrices and equations that you have worked out, beside the derived ones</source>
        <translation>Çıkardığınız matrisler ve denklemler, türetilenlerin yanında</translation>
    </message>
    <message>
        <source>Your matrix</source>
        <translation>Sizin matrisiniz</translation>
    </message>
    <message>
        <source>The derived matrix, in your order</source>
        <translation>Türetilen matris, sizin sıranızla</translation>
    </message>
    <message>
        <source>Check my matrices</source>
        <translation>Matrislerimi denetle</translation>
    </message>
    <message>
        <source>Your matrix or equations</source>
        <translation>Matrisiniz ya da denklemleriniz</translation>
    </message>
    <message>
        <source>CSV, LaTeX, MATLAB, NumPy or plain text; equations, one a line</source>
        <translation>CSV, LaTeX, MATLAB, NumPy ya da düz metin; denklemler, satır başına bir</translation>
    </message>
    <message>
        <source>Type or paste a matrix or equations: CSV, LaTeX, MATLAB, NumPy, plain text</source>
        <translation>Bir matris ya da denklemler yazın veya yapıştırın: CSV, LaTeX, MATLAB, NumPy, düz metin</translation>
    </message>
    <message>
        <source>Which matrix it is</source>
        <translation>Hangi matris olduğu</translation>
    </message>
    <message>
        <source>Which matrix it is; recognised by its name, size and entries</source>
        <translation>Hangi matris olduğu; adından, boyutundan ve öğelerinden tanınır</translation>
    </message>
    <message>
        <source>Recognise the matrix</source>
        <translation>Matrisi tanı</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Farklı olanlar</translation>
    </message>
    <message>
        <source>Select one to see its entries, and its elements in the drawings</source>
        <translation>Öğelerini ve çizimlerdeki elemanlarını görmek için birini seçin</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Dosya aç…</translation>
    </message>
    <message>
        <source>Read the matrix or the equations from a text file</source>
        <translation>Matrisi ya da denklemleri bir metin dosyasından oku</translation>
    </message>
    <message>
        <source>Example of the paper</source>
        <translation>Makaledeki örnek</translation>
    </message>
    <message>
        <source>The rows of equation (45) under the labels of equation (25), for the robot of the paper</source>
        <translation>(45) denkleminin satırları (25) denkleminin etiketleri altında, makaledeki robot için</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>Sizinki</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>Türetilen</translation>
    </message>
    <message>
        <source>Open a matrix or equations</source>
        <translation>Matris ya da denklem aç</translation>
    </message>
    <message>
        <source>Texts (*.csv *.tsv *.txt *.tex *.m *.py);;All files (*)</source>
        <translation>Metinler (*.csv *.tsv *.txt *.tex *.m *.py);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Matrices of at most %1 moving links are compared.</source>
        <translation>En çok %1 hareketli uzvun matrisleri karşılaştırılır.</translation>
    </message>
    <message>
        <source>This text is longer than any matrix that is compared.</source>
        <translation>Bu metin karşılaştırılan her matristen uzun.</translation>
    </message>
    <message>
        <source>Your matrix or equations against the derived ones</source>
        <translation>Matrisiniz ya da denklemleriniz türetilenlere karşı</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Satır %1, sütun %2: %3</translation>
    </message>
    <message>
        <source>✓ Right: %1</source>
        <translation>✓ Doğru: %1</translation>
    </message>
    <message>
        <source>✗ Not right yet: %1</source>
        <translation>✗ Henüz doğru değil: %1</translation>
    </message>
    <message>
        <source>? Only labels can tell: %1</source>
        <translation>? Yalnızca etiketler belirleyebilir: %1</translation>
    </message>
    <message>
        <source>Derived: %1</source>
        <translation>Türetilen: %1</translation>
    </message>
    <message>
        <source>Yours: %1</source>
        <translation>Sizinki: %1</translation>
    </message>
    <message>
        <source>equation</source>
        <translation>denklem</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>karar</translation>
    </message>
    <message>
        <source>right</source>
        <translation>doğru</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>yanlış</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>✓ All that is written is right</source>
        <translation>✓ Yazılanların hepsi doğru</translation>
    </message>
    <message>
        <source>✗ Not right yet: %1 of %2</source>
        <translation>✗ Henüz doğru değil: %2 içinden %1</translation>
    </message>
    <message>
        <source>How many questions of each kind are asked</source>
        <translation>Her türden kaç soru sorulacağı</translation>
    </message>
    <message>
        <source>The same seed makes the same questions, here and on the command line</source>
        <translation>Aynı başlangıç değeri burada da komut satırında da aynı soruları verir</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Alıştırmalar</translation>
    </message>
    <message>
        <source>Sheets that differ in their questions: one for each student, or one for all</source>
        <translation>Soruları farklı kâğıtlar: her öğrenciye bir tane ya da herkese aynısı</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Alıştırma yap</translation>
    </message>
    <message>
        <source>Export sheets…</source>
        <translation>Kâğıtları dışa aktar…</translation>
    </message>
    <message>
        <source>Export handout…</source>
        <translation>Ders notunu dışa aktar…</translation>
    </message>
    <message>
        <source>Questions about this mechanism</source>
        <translation>Bu mekanizma hakkında sorular</translation>
    </message>
    <message>
        <source>Kinds of questions</source>
        <translation>Soru türleri</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Sorular</translation>
    </message>
    <message>
        <source>Of each kind</source>
        <translation>Her türden</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Başlangıç değeri</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tümü</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Hiçbiri</translation>
    </message>
    <message>
        <source>Choose every kind that the mechanism gives</source>
        <translation>Mekanizmanın verdiği her türü seç</translation>
    </message>
    <message>
        <source>Choose no kind, to begin with a few</source>
        <translation>Birkaç taneyle başlamak için hiçbir türü seçme</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Türler</translation>
    </message>
    <message>
        <source>For a class</source>
        <translation>Bir sınıf için</translation>
    </message>
    <message>
        <source>The heading of sheets and handouts</source>
        <translation>Kâğıtların ve ders notlarının başlığı</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Başlık</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Çeşitler</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Web sayfası</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Sheets and solutions in this form</source>
        <translation>Bu biçimde kâğıtlar ve çözümler</translation>
    </message>
    <message>
        <source>Sheets as</source>
        <translation>Kâğıt biçimi</translation>
    </message>
    <message>
        <source>Exercises are made of mechanisms of at most %1 moving links.</source>
        <translation>Alıştırmalar en çok %1 hareketli uzvu olan mekanizmalardan yapılır.</translation>
    </message>
    <message>
        <source>On the command line: %1</source>
        <translation>Komut satırında: %1</translation>
    </message>
    <message>
        <source>The mechanism gives no such question: %1.</source>
        <translation>Mekanizma böyle bir soru vermiyor: %1.</translation>
    </message>
    <message>
        <source>Choose a kind of question first.</source>
        <translation>Önce bir soru türü seçin.</translation>
    </message>
    <message>
        <source>A sheet has at most %1 questions.</source>
        <translation>Bir kâğıtta en çok %1 soru olur.</translation>
    </message>
    <message>
        <source>Answer the questions in a window of their own, with hints and reasons</source>
        <translation>Soruları ayrı bir pencerede, ipuçları ve gerekçelerle yanıtla</translation>
    </message>
    <message>
        <source>At most %1 questions are practised at once.</source>
        <translation>Bir seferde en çok %1 soru çalışılır.</translation>
    </message>
    <message>
        <source>Sheets, solutions and files for answers, which geargraph-cli exercises grade reads</source>
        <translation>Kâğıtlar, çözümler ve geargraph-cli exercises grade komutunun okuduğu yanıt dosyaları</translation>
    </message>
    <message>
        <source>Choose a form of the sheets first.</source>
        <translation>Önce kâğıtların biçimini seçin.</translation>
    </message>
    <message>
        <source>The mechanism with these questions as one page for any browser, or for a learning platform</source>
        <translation>Mekanizma bu sorularla birlikte, her tarayıcı ya da bir öğrenme platformu için tek sayfa</translation>
    </message>
    <message>
        <source>Other exercises ›</source>
        <translation>Başka alıştırmalar ›</translation>
    </message>
    <message>
        <source>Package for learning platforms, SCORM 1.2 (*.zip)</source>
        <translation>Öğrenme platformları için paket, SCORM 1.2 (*.zip)</translation>
    </message>
    <message>
        <source>Package with exercises, SCORM 1.2 (*.zip)</source>
        <translation>Alıştırmalı paket, SCORM 1.2 (*.zip)</translation>
    </message>
    <message>
        <source>Folder in which the sheets&apos; folder is made</source>
        <translation>Kâğıtların klasörünün oluşturulacağı klasör</translation>
    </message>
    <message>
        <source>%1 exercises %2</source>
        <translation>%1 alıştırmalar %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already: no sheet was written.</source>
        <translation>&quot;%1&quot; zaten var: hiçbir kâğıt yazılmadı.</translation>
    </message>
    <message>
        <source>One page for any browser, also on a phone and without a network: drawings, matrices, solution, derivation and the train in 3D, with inputs that move, and exercises if you choose them; also as a package for learning platforms</source>
        <translation>Telefonda ve ağ olmadan da her tarayıcı için tek sayfa: çizimler, matrisler, çözüm, türetim ve hareketli girişleriyle 3B dişli takımı, isterseniz alıştırmalarla; öğrenme platformları için paket olarak da</translation>
    </message>
    <message>
        <source>&amp;Exercises…</source>
        <translation>&amp;Alıştırmalar…</translation>
    </message>
    <message>
        <source>Questions about this mechanism, to practise, or as sheets and handouts for a class</source>
        <translation>Bu mekanizma hakkında sorular: alıştırma için ya da bir sınıfa kâğıt ve ders notu olarak</translation>
    </message>
    <message>
        <source>Questions: %1</source>
        <translation>Sorular: %1</translation>
    </message>
    <message>
        <source>‹ Exercises</source>
        <translation>‹ Alıştırmalar</translation>
    </message>
    <message>
        <source>Other questions, or another seed</source>
        <translation>Başka sorular ya da başka bir başlangıç değeri</translation>
    </message>
    <message>
        <source>The same at any torque</source>
        <translation>Her torkta aynı</translation>
    </message>
    <message>
        <source>Losses of meshes are proportional to their power, whether an efficiency or a coefficient of friction is stated: all loads scaled alike leave the efficiency as it is, so there is no plot over the torque. Of several loads only the proportions matter.</source>
        <translation>Verim de verilse sürtünme katsayısı da verilse dişli çiftlerinin kayıpları güçleriyle orantılıdır: bütün yükler aynı oranda değişirse verim aynı kalır, bu yüzden torka göre çizim yoktur. Birden çok yükte yalnızca oranları önemlidir.</translation>
    </message>
    <message>
        <source>Exactly %1</source>
        <translation>Tam olarak %1</translation>
    </message>
    <message>
        <source>both methods agree</source>
        <translation>iki yöntem de aynı sonucu verir</translation>
    </message>
    <message>
        <source>Row %1: speeds of mesh %1</source>
        <translation>Satır %1: %1 dişli çiftinin hızları</translation>
    </message>
    <message>
        <source>Column %1: torque in joint %1</source>
        <translation>Sütun %1: %1 mafsalındaki tork</translation>
    </message>
    <message>
        <source>shared in unknown parts, or not held</source>
        <translation>bilinmeyen paylarla bölüşülüyor ya da tutulmuyor</translation>
    </message>
    <message>
        <source>here %1 N m</source>
        <translation>burada %1 N m</translation>
    </message>
    <message>
        <source>Documents and tables (*.geargraph *.csv *.tsv);;GearGraph documents (*.geargraph);;Tables of documents (*.csv *.tsv);;All files (*)</source>
        <translation>Belgeler ve tablolar (*.geargraph *.csv *.tsv);;GearGraph belgeleri (*.geargraph);;Belge tabloları (*.csv *.tsv);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>%1 içe aktarma</translation>
    </message>
    <message>
        <source>%1 was imported. Save writes a document of its own.</source>
        <translation>%1 içe aktarıldı. Kaydetmek ayrı bir belge yazar.</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>Lay axis %1</source>
        <translation>Eksen %1 yerleştir</translation>
    </message>
    <message>
        <source>it is pinned</source>
        <translation>sabitlenmiş</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Verim</translation>
    </message>
    <message>
        <source>Where a train locks itself, no torque of what holds the loads moves them, however large. The efficiency counts as the same in all meshes.</source>
        <translation>Bir düzenek kendini kilitlediğinde, yükleri tutanın momenti ne kadar büyük olursa olsun onları hareket ettirmez. Verim tüm kavramalarda aynı sayılır.</translation>
    </message>
    <message>
        <source>i: the teeth of the tail&apos;s gear over those of the head&apos;s; η: the efficiency of a mesh. It holds as long as the same gears drive.</source>
        <translation>i: kuyruktaki dişlinin diş sayısının baştakininkine oranı; η: bir kavramanın verimi. Aynı dişliler tahrik ettiği sürece geçerlidir.</translation>
    </message>
    <message>
        <source>Efficiency of a mesh</source>
        <translation>Bir kavramanın verimi</translation>
    </message>
    <message>
        <source>Set efficiency</source>
        <translation>Verimi değiştir</translation>
    </message>
    <message>
        <source>Every mesh states an efficiency or a friction of its own.</source>
        <translation>Her kavrama kendi verimini ya da sürtünmesini belirtiyor.</translation>
    </message>
    <message>
        <source>An efficiency replaces the coefficient of friction that the document states for all meshes.</source>
        <translation>Bir verim, belgenin tüm kavramalar için belirttiği sürtünme katsayısının yerini alır.</translation>
    </message>
    <message>
        <source>Self-locking below η = %1</source>
        <translation>η = %1 altında kendini kilitler</translation>
    </message>
    <message>
        <source>Self-locking backward below η = %1</source>
        <translation>η = %1 altında geri yönde kendini kilitler</translation>
    </message>
    <message>
        <source>Never self-locking, at any efficiency</source>
        <translation>Hiçbir verimde kendini kilitlemez</translation>
    </message>
    <message>
        <source>T in joint %1, link %2</source>
        <translation>%1 eklemindeki T, uzuv %2</translation>
    </message>
    <message>
        <source>A load: the torque that the joint&apos;s tail exerts on its head, link %1, about the direction of its axis.</source>
        <translation>Bir yük: eklemin kuyruğunun başına, %1 uzvuna, ekseninin yönü etrafında uyguladığı moment.</translation>
    </message>
    <message>
        <source>T on link %1</source>
        <translation>%1 uzvundaki T</translation>
    </message>
    <message>
        <source>A load: a torque from outside on the link; the ground takes the reaction.</source>
        <translation>Bir yük: uzva dışarıdan etki eden bir moment; tepkiyi gövde alır.</translation>
    </message>
    <message>
        <source>link %1, held by brake %2</source>
        <translation>uzuv %1, %2 freni tutuyor</translation>
    </message>
    <message>
        <source>links %1 and %2, joined by clutch %3</source>
        <translation>%1 ve %2 uzuvları, %3 kavraması birleştiriyor</translation>
    </message>
    <message>
        <source>carries %1 N m</source>
        <translation>%1 N m taşır</translation>
    </message>
    <message>
        <source>shares its load in unknown parts</source>
        <translation>yükünü bilinmeyen oranlarda paylaşır</translation>
    </message>
    <message>
        <source>The torque of the brake on link %1, about its first axis on the way to the ground. At rest it passes no power.</source>
        <translation>Frenin %1 uzvuna, gövdeye giden yoldaki ilk ekseni etrafındaki momenti. Dururken güç aktarmaz.</translation>
    </message>
    <message>
        <source>The torque of the clutch on link %1; the other link has the reaction.</source>
        <translation>Kavramanın %1 uzvundaki momenti; tepki öbür uzuvdadır.</translation>
    </message>
    <message>
        <source>%1 N m, found</source>
        <translation>%1 N m, bulundu</translation>
    </message>
    <message>
        <source>shared in unknown parts</source>
        <translation>bilinmeyen oranlarda paylaşılır</translation>
    </message>
    <message>
        <source>Found: the torque that holds the loads here, of the joint&apos;s tail on its head, link %1, about the direction of its axis.</source>
        <translation>Bulunan: burada yükleri tutan moment; eklemin kuyruğundan başına, %1 uzvuna, ekseninin yönü etrafında.</translation>
    </message>
    <message>
        <source>Found: the torque from outside on the link that holds the loads.</source>
        <translation>Bulunan: uzva dışarıdan etki edip yükleri tutan moment.</translation>
    </message>
    <message>
        <source>%1 of %2 torques are listed; all of them are in Forces</source>
        <translation>%2 momentten %1 tanesi listelendi; tümü Kuvvetler&apos;de</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>x boyunca</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>y boyunca</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>z boyunca</translation>
    </message>
    <message>
        <source>Square to</source>
        <translation>Şuna dik</translation>
    </message>
    <message>
        <source>Parallel to</source>
        <translation>Şuna paralel</translation>
    </message>
    <message>
        <source>Through the meeting point of</source>
        <translation>Şunun kesişme noktasından</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Eksen %1</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>seç…</translation>
    </message>
    <message>
        <source>Click to choose the input and the output link of this state</source>
        <translation>Bu durumun giriş ve çıkış uzvunu seçmek için tıklayın</translation>
    </message>
    <message>
        <source>State %1 has no ratio yet: click “choose…” in its row and name its input and output links.</source>
        <translation>%1 durumunun henüz oranı yok: satırındaki “seç…” öğesine tıklayıp giriş ve çıkış uzuvlarını belirtin.</translation>
    </message>
    <message>
        <source>Which link is the input of state %1?</source>
        <translation>%1 durumunun girişi hangi uzuv?</translation>
    </message>
    <message>
        <source>Which link is the output of state %1?</source>
        <translation>%1 durumunun çıkışı hangi uzuv?</translation>
    </message>
    <message>
        <source>Choose input and output</source>
        <translation>Giriş ve çıkışı seç</translation>
    </message>
    <message>
        <source>Choose input and output…</source>
        <translation>Giriş ve çıkışı seç…</translation>
    </message>
    <message>
        <source>Lay axis</source>
        <translation>Ekseni yerleştir</translation>
    </message>
    <message>
        <source>Lay the axis along x, y or z, or as another axis lies. The kinds of its meshes follow.</source>
        <translation>Ekseni x, y veya z boyunca ya da başka bir eksene göre yerleştirir. Dişli çiftlerinin türleri buna uyar.</translation>
    </message>
    <message>
        <source>Slide to change the teeth; Esc puts back</source>
        <translation>Diş sayısını değiştirmek için kaydırın; Esc geri alır</translation>
    </message>
    <message>
        <source>and</source>
        <translation>ve</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 ve %2 tane daha</translation>
    </message>
    <message>
        <source>Turning joint %1 closes a loop.</source>
        <translation>%1 döner mafsalı bir döngü kapatıyor.</translation>
    </message>
    <message>
        <source>Turning joint %1 closes a loop with %2.</source>
        <translation>%1 döner mafsalı %2 ile bir döngü kapatıyor.</translation>
    </message>
    <message>
        <source>All of them turn about axis %1, so joint %2 is a redundant bearing: drop it.</source>
        <translation>Hepsi %1 ekseni etrafında döner, bu yüzden %2 mafsalı fazlalık bir yataktır: silin.</translation>
    </message>
    <message>
        <source>The turning joints have to be a tree: delete one of them, or draw a gear mesh instead.</source>
        <translation>Döner mafsallar bir ağaç olmalıdır: birini silin ya da onun yerine bir dişli çifti çizin.</translation>
    </message>
    <message>
        <source>Link %1 is not tied to the ground by turning joints: draw a turning joint to it.</source>
        <translation>%1 uzvu sabit uzva döner mafsallarla bağlı değil: ona bir döner mafsal çizin.</translation>
    </message>
    <message>
        <source>Links %1 are not tied to the ground by turning joints: draw a turning joint to them.</source>
        <translation>%1 uzuvları sabit uzva döner mafsallarla bağlı değil: onlara bir döner mafsal çizin.</translation>
    </message>
    <message>
        <source>Mesh %1: %2</source>
        <translation>%1 dişli çifti: %2</translation>
    </message>
    <message>
        <source>another tooth count</source>
        <translation>başka bir diş sayısı</translation>
    </message>
    <message>
        <source>the pitch point %1</source>
        <translation>%1 hatve noktası</translation>
    </message>
    <message>
        <source>the pitch point %1 lies on the axis of the tail gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.</source>
        <translation>%1 hatve noktası kuyruk dişlisinin ekseni üzerindedir, bu yüzden hatve yarıçapı 0&apos;dır. Uygun olan: iki eksenin dışında, düzlemlerinde bir nokta.</translation>
    </message>
    <message>
        <source>the pitch point %1 lies on the axis of the head gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.</source>
        <translation>%1 hatve noktası baş dişlisinin ekseni üzerindedir, bu yüzden hatve yarıçapı 0&apos;dır. Uygun olan: iki eksenin dışında, düzlemlerinde bir nokta.</translation>
    </message>
    <message>
        <source>its two axes are the same line in the reference pose.</source>
        <translation>iki ekseni referans konumda aynı doğrudur.</translation>
    </message>
    <message>
        <source>the pitch point %1 lies %2 off the plane of the two axes, so the teeth would lock. What fits: %3, or none (then it follows from the axes).</source>
        <translation>%1 hatve noktası iki eksenin düzleminden %2 uzaktadır, dişler kilitlenirdi. Uygun olan: %3, ya da hiçbiri (o zaman eksenlerden çıkar).</translation>
    </message>
    <message>
        <source>it says %1, but its axes are parallel. What fits: external or internal.</source>
        <translation>türü %1 olarak verilmiş, ama eksenleri paralel. Uygun olan: dış ya da iç.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet. What fits: bevel.</source>
        <translation>türü %1 olarak verilmiş, ama eksenleri kesişiyor. Uygun olan: konik.</translation>
    </message>
    <message>
        <source>it says internal, but the pitch point %1 lies between the axes, which is an external pair.</source>
        <translation>türü iç olarak verilmiş, ama %1 hatve noktası eksenlerin arasındadır; bu bir dış çifttir.</translation>
    </message>
    <message>
        <source>it says external, but the pitch point %1 lies on one side of both axes, which is an internal pair.</source>
        <translation>türü dış olarak verilmiş, ama %1 hatve noktası iki eksenin aynı yanındadır; bu bir iç çifttir.</translation>
    </message>
    <message>
        <source>What fits: %1, or %2.</source>
        <translation>Uygun olan: %1 ya da %2.</translation>
    </message>
    <message>
        <source>the pitch radii are %1 and %2 (ratio %3), but the teeth are %4 and %5 (ratio %6). What fits: %7 teeth on the head, or %8.</source>
        <translation>hatve yarıçapları %1 ve %2 (oran %3), ama diş sayıları %4 ve %5 (oran %6). Uygun olan: başta %7 diş, ya da %8.</translation>
    </message>
    <message>
        <source>its axes are skew, %1 apart: there is no point where the gears could roll. What fits: axes that are parallel or meet.</source>
        <translation>eksenleri aykırı, aralarındaki uzaklık %1: dişlilerin yuvarlanabileceği bir nokta yok. Uygun olan: paralel ya da kesişen eksenler.</translation>
    </message>
    <message>
        <source>an internal pair needs different tooth counts, the ring the larger one; both have %1.</source>
        <translation>iç çiftin diş sayıları farklı olmalı, çemberinki daha büyük; ikisinde de %1 var.</translation>
    </message>
    <message>
        <source>some of %1</source>
        <translation>şunlardan bazıları: %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>şunlardan biri: %1</translation>
    </message>
    <message>
        <source>or</source>
        <translation>veya</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>liste</translation>
    </message>
    <message>
        <source>state “%1”</source>
        <translation>“%1” durumu</translation>
    </message>
    <message>
        <source>State “%1” engages %2, link $%3$ drives and link $%4$ bears the load</source>
        <translation>“%1” durumu %2 elemanlarını devreye alır, $%3$ uzvu tahrik eder, $%4$ uzvu yükü taşır</translation>
    </message>
    <message>
        <source>state “%1” engages %2, link $%3$ drives and link $%4$ bears the load</source>
        <translation>“%1” durumu %2 elemanlarını devreye alır, $%3$ uzvu tahrik eder, $%4$ uzvu yükü taşır</translation>
    </message>
    <message>
        <source>The torque of the drive is $%1$ N m, and no power is lost.</source>
        <translation>Tahrik torku $%1$ N m&apos;dir ve güç kaybı yoktur.</translation>
    </message>
    <message>
        <source>Which of the engaged brakes and clutches carries the largest torque, and how large is it in N m, without a sign? A fraction or a decimal of three digits will do.</source>
        <translation>Devredeki fren ve kavramalardan hangisi en büyük torku taşır ve bu tork işaretsiz olarak kaç N m&apos;dir? Bir kesir ya da üç basamaklı bir ondalık sayı yeterlidir.</translation>
    </message>
    <message>
        <source>In which state does %1 carry the largest torque, and how large is it in N m, without a sign? A fraction or a decimal of three digits will do.</source>
        <translation>%1 hangi durumda en büyük torku taşır ve bu tork işaretsiz olarak kaç N m&apos;dir? Bir kesir ya da üç basamaklı bir ondalık sayı yeterlidir.</translation>
    </message>
    <message>
        <source>largest torque in</source>
        <translation>en büyük torku taşıyan</translation>
    </message>
    <message>
        <source>torque in N m</source>
        <translation>tork (N m)</translation>
    </message>
    <message>
        <source>The torques on each link and in each mesh balance: %1.</source>
        <translation>Her uzuvdaki ve her dişli çiftindeki torklar dengededir: %1.</translation>
    </message>
    <message>
        <source>You choose the clutch that turns fastest, but the torque does not follow the speed: it carries %1 N m, less than the %2 N m of %3.</source>
        <translation>En hızlı dönen kavramayı seçtiniz, ama tork hızı izlemez: bu kavrama %1 N m taşır; bu, %3 için olan %2 N m değerinden azdır.</translation>
    </message>
    <message>
        <source>You choose the state of the largest ratio, but the brake&apos;s torque does not follow the ratio&apos;s size: it carries %1 N m, less than the %2 N m of %3.</source>
        <translation>En büyük oranlı durumu seçtiniz, ama frenin torku oranın büyüklüğünü izlemez: %1 N m taşır; bu, %3 için olan %2 N m değerinden azdır.</translation>
    </message>
    <message>
        <source>The %1 carries %2 N m, less than the %3 N m of %4.</source>
        <translation>%1 %2 N m taşır; bu, %4 için olan %3 N m değerinden azdır.</translation>
    </message>
    <message>
        <source>In state “%1” it carries %2 N m, less than the %3 N m of %4.</source>
        <translation>“%1” durumunda %2 N m taşır; bu, %4 için olan %3 N m değerinden azdır.</translation>
    </message>
    <message>
        <source>The %1 is released in this state: it carries no torque.</source>
        <translation>%1 bu durumda ayrıktır: tork taşımaz.</translation>
    </message>
    <message>
        <source>State “%1” releases the %2: it carries no torque.</source>
        <translation>“%1” durumunda %2 ayrıktır: tork taşımaz.</translation>
    </message>
    <message>
        <source>The signs of both torques are lost: the brake holds the sum of %1 N m and %2 N m.</source>
        <translation>İki torkun işareti kaybolmuş: fren %1 N m ile %2 N m toplamını tutar.</translation>
    </message>
    <message>
        <source>You use the ratio upside down: with the ratio %1 the torque on the driven link is %2 N m.</source>
        <translation>Oranı ters kullandınız: %1 oranıyla tahrik edilen uzuvdaki tork %2 N m&apos;dir.</translation>
    </message>
    <message>
        <source>This is the torque of %1, which is not the largest.</source>
        <translation>Bu, %1 için olan torktur; en büyüğü değildir.</translation>
    </message>
    <message>
        <source>This is the torque in state “%1”, which is not the largest.</source>
        <translation>Bu, “%1” durumundaki torktur; en büyüğü değildir.</translation>
    </message>
    <message>
        <source>This is the torque of the load on link %1: %2 has to keep the balance.</source>
        <translation>Bu, %1 uzvundaki yük torkudur: dengeyi %2 sağlamalıdır.</translation>
    </message>
    <message>
        <source>This is the torque of the drive: %1 does not carry it as it is.</source>
        <translation>Bu, tahrik torkudur: %1 onu olduğu gibi taşımaz.</translation>
    </message>
    <message>
        <source>Write the row of mesh $%1$ of the coefficient matrix $P$. Mesh $%1$ has $%2$ teeth on link $%3$ and $%4$ on link $%5$. Any multiple of the row is right: radii, numbers of teeth or the ratio $i_{%1}$.</source>
        <translation>$P$ katsayı matrisinde $%1$ dişli çiftinin satırını yazın. $%1$ dişli çiftinin $%3$ uzvunda $%2$, $%5$ uzvunda $%4$ dişi vardır. Satırın her katı doğrudur: yarıçaplar, diş sayıları ya da $i_{%1}$ oranı.</translation>
    </message>
    <message>
        <source>A joint on the axis of a gear counts with this gear&apos;s radius, the sign is that of the cycle, and the joints of both gears have the signs of the mesh.</source>
        <translation>Bir dişlinin ekseni üzerindeki mafsal o dişlinin yarıçapıyla sayılır, işaret çevriminkidir ve iki dişlinin mafsalları dişli çiftinin işaretlerini taşır.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: both gears turn the same way, seen from their carrier.</source>
        <translation>%1 dişli çifti içtir: taşıyıcıdan bakıldığında iki dişli aynı yönde döner.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: its gears turn against each other, seen from their carrier.</source>
        <translation>%1 dişli çifti dıştır: taşıyıcıdan bakıldığında dişliler ters yönde döner.</translation>
    </message>
    <message>
        <source>The sign of bevel mesh %1 follows from where its pitch point is, seen from both axes.</source>
        <translation>Konik dişli çifti %1 için işaret, hatve noktasının iki eksene göre konumundan çıkar.</translation>
    </message>
    <message>
        <source>You exchange the radii of both gears: the joints on an axis count with the radius of the gear on it.</source>
        <translation>İki dişlinin yarıçaplarını karıştırdınız: bir eksendeki mafsallar o eksendeki dişlinin yarıçapıyla sayılır.</translation>
    </message>
    <message>
        <source>This is the row of the cycle: in P its signs are multiplied by the radii of the gears.</source>
        <translation>Bu, çevrimin satırıdır: P&apos;de işaretleri dişlilerin yarıçaplarıyla çarpılır.</translation>
    </message>
    <message>
        <source>You write the radii without the signs of the cycle, which walks against some arrows.</source>
        <translation>Yarıçapları, bazı oklara ters giden çevrimin işaretleri olmadan yazdınız.</translation>
    </message>
    <message>
        <source>This is the row of mesh %1.</source>
        <translation>Bu, %1 dişli çiftinin satırıdır.</translation>
    </message>
    <message>
        <source>You exchange the radii of both gears, and the sign of the mesh is wrong, too.</source>
        <translation>İki dişlinin yarıçaplarını karıştırdınız, dişli çiftinin işareti de yanlış.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 does not use %2: 0.</source>
        <translation>%1 dişli çiftinin çevrimi şunu kullanmaz: %2: 0.</translation>
    </message>
    <message>
        <source>The sign of %1 is the opposite: the walk passes its arrow the other way.</source>
        <translation>%1 için işaret terstir: yol, okunu öbür yönde geçer.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 uses %2: its coefficient is not 0.</source>
        <translation>%1 dişli çiftinin çevrimi şunu kullanır: %2; katsayısı 0 değildir.</translation>
    </message>
    <message>
        <source>Which turning joints lie on the fundamental cycle of mesh $%1$?</source>
        <translation>$%1$ dişli çiftinin temel çevriminde hangi döner mafsallar bulunur?</translation>
    </message>
    <message>
        <source>The cycle of mesh %1 consists of the mesh and of the path through the tree from link %2 to link %3.</source>
        <translation>%1 dişli çiftinin çevrimi, dişli çifti ile ağaçta %2 uzvundan %3 uzvuna giden yoldan oluşur.</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>mafsallar</translation>
    </message>
    <message>
        <source>You follow both paths to the ground: the cycle turns back at the first link that they share.</source>
        <translation>İki yolu da sabit uzva kadar izlediniz: çevrim ilk ortak uzuvda geri döner.</translation>
    </message>
    <message>
        <source>You follow the path of link %1 to the ground: the cycle needs the path between both gears.</source>
        <translation>%1 uzvunun yolunu sabit uzva kadar izlediniz: çevrim için iki dişli arasındaki yol gerekir.</translation>
    </message>
    <message>
        <source>These are the joints on the cycle of mesh %1.</source>
        <translation>Bunlar %1 dişli çiftinin çevrimindeki mafsallardır.</translation>
    </message>
    <message>
        <source>%1 is a mesh: the question asks for the turning joints.</source>
        <translation>%1 bir dişli çiftidir: soru döner mafsalları istiyor.</translation>
    </message>
    <message>
        <source>The path between links %1 and %2 leads through joint %3.</source>
        <translation>%1 ve %2 uzuvları arasındaki yol %3 mafsalından geçer.</translation>
    </message>
    <message>
        <source>The path between links %1 and %2 does not lead through joint %3.</source>
        <translation>%1 ve %2 uzuvları arasındaki yol %3 mafsalından geçmez.</translation>
    </message>
    <message>
        <source>Walk once round the cycle of mesh $%1$, in either sense: $1$ for each arrow that you follow, $-1$ for each that you walk against.</source>
        <translation>$%1$ dişli çiftinin çevrimini istediğiniz yönde bir kez dolaşın: izlediğiniz her ok için $1$, ters gittiğiniz her ok için $-1$.</translation>
    </message>
    <message>
        <source>One walk runs along mesh %1 and back through the tree; the opposite walk has all signs exchanged and is right, too.</source>
        <translation>Bir tur %1 dişli çifti boyunca gider ve ağaçtan geri döner; ters turda bütün işaretler değişir ve o da doğrudur.</translation>
    </message>
    <message>
        <source>You give all edges one sense: some arrows point against every walk round the cycle.</source>
        <translation>Bütün kenarlara aynı yönü verdiniz: çevrimin her turunda bazı oklar ters yönü gösterir.</translation>
    </message>
    <message>
        <source>Your walk passes %1 the other way: with the other senses that you give, its sign is the opposite.</source>
        <translation>Yolunuz şuradan öbür yönde geçiyor: %1. Verdiğiniz öteki yönlerle işareti terstir.</translation>
    </message>
    <message>
        <source>Every walk round the cycle uses %1: 1 or −1, not 0.</source>
        <translation>Çevrimin her turu şunu kullanır: %1; 1 ya da −1, 0 değil.</translation>
    </message>
    <message>
        <source>These senses belong to no single walk round the cycle: start at one link and follow the edges one by one.</source>
        <translation>Bu yönler çevrimin tek bir turuna ait değil: bir uzuvdan başlayın ve kenarları sırayla izleyin.</translation>
    </message>
    <message>
        <source>Write down all fundamental cycles, one in each row: in any order, each walked in either sense.</source>
        <translation>Bütün temel çevrimleri her satıra biri gelecek biçimde yazın: sıra serbest, her biri istenen yönde.</translation>
    </message>
    <message>
        <source>There is a cycle for each mesh; its row may be multiplied by −1, and rows may be exchanged.</source>
        <translation>Her dişli çifti için bir çevrim vardır; satırı −1 ile çarpılabilir ve satırlar yer değiştirebilir.</translation>
    </message>
    <message>
        <source>You mark the edges of the cycles without their senses: a walk that runs against an arrow has −1.</source>
        <translation>Çevrimlerin kenarlarını yönsüz işaretlediniz: oka ters giden yol −1 alır.</translation>
    </message>
    <message>
        <source>You write one cycle twice: each mesh closes a cycle of its own.</source>
        <translation>Bir çevrimi iki kez yazdınız: her dişli çifti kendi çevrimini kapatır.</translation>
    </message>
    <message>
        <source>You leave out the meshes: each cycle holds the mesh that closes it.</source>
        <translation>Dişli çiftlerini atladınız: her çevrim kendisini kapatan dişli çiftini içerir.</translation>
    </message>
    <message>
        <source>from link %1 to link %2</source>
        <translation>%1 uzvundan %2 uzvuna</translation>
    </message>
    <message>
        <source>You turn the arrow of %1 round: it points %2.</source>
        <translation>%1 için oku ters çevirdiniz: ok %2 gider.</translation>
    </message>
    <message>
        <source>You give link %1 an end of %2, but its arrow points %3: 0.</source>
        <translation>%1 uzvuna şunun bir ucunu verdiniz: %2; oysa oku %3 gider: 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 ends at link %2: 1, not 0.</source>
        <translation>%1 için ok %2 uzvunda biter: 1, 0 değil.</translation>
    </message>
    <message>
        <source>The arrow of %1 begins at link %2: −1, not 0.</source>
        <translation>%1 için ok %2 uzvunda başlar: −1, 0 değil.</translation>
    </message>
    <message>
        <source>The arrow of %1 ends at link %2: 1, not −1.</source>
        <translation>%1 için ok %2 uzvunda biter: 1, −1 değil.</translation>
    </message>
    <message>
        <source>The arrow of %1 begins at link %2: −1, not 1.</source>
        <translation>%1 için ok %2 uzvunda başlar: −1, 1 değil.</translation>
    </message>
    <message>
        <source>You exchange + and −: a column holds −1 where the arrow begins and 1 where it ends.</source>
        <translation>+ ile − işaretlerini karıştırdınız: sütunda okun başladığı yerde −1, bittiği yerde 1 bulunur.</translation>
    </message>
    <message>
        <source>You mark both ends alike: the end where the arrow begins is −1, the one where it ends 1.</source>
        <translation>İki ucu aynı işaretlediniz: okun başladığı uç −1, bittiği uç 1&apos;dir.</translation>
    </message>
    <message>
        <source>Fill in these columns of the incidence matrix $\Gamma^0$.</source>
        <translation>$\Gamma^0$ bağlantı matrisinin bu sütunlarını doldurun.</translation>
    </message>
    <message>
        <source>A column of Γ⁰ holds −1 in the row of the link where the arrow begins, 1 where it ends, and 0 elsewhere.</source>
        <translation>Γ⁰&apos;ın bir sütununda okun başladığı uzvun satırında −1, bittiği yerde 1, başka yerlerde 0 bulunur.</translation>
    </message>
    <message>
        <source>You leave out the ground: Γ⁰ keeps its row, only Γ has none.</source>
        <translation>Sabit uzvu atladınız: Γ⁰ onun satırını korur, yalnız Γ&apos;da yoktur.</translation>
    </message>
    <message>
        <source>Fill in these columns of the reduced incidence matrix $\Gamma$. Leave a row that $\Gamma$ does not have empty.</source>
        <translation>İndirgenmiş $\Gamma$ bağlantı matrisinin bu sütunlarını doldurun. $\Gamma$&apos;da olmayan satırı boş bırakın.</translation>
    </message>
    <message>
        <source>Γ is Γ⁰ without the row of the ground, so that its rows are independent; all other entries stay.</source>
        <translation>Γ, satırları bağımsız olsun diye sabit uzvun satırı çıkarılmış Γ⁰&apos;dır; öteki girdiler aynı kalır.</translation>
    </message>
    <message>
        <source>You leave the row of the ground in: Γ has the rows of the moving links only.</source>
        <translation>Sabit uzvun satırını bıraktınız: Γ&apos;da yalnız hareketli uzuvların satırları vardır.</translation>
    </message>
    <message>
        <source>You fill in the row of the ground: Γ has the rows of the moving links only.</source>
        <translation>Sabit uzvun satırını doldurdunuz: Γ&apos;da yalnız hareketli uzuvların satırları vardır.</translation>
    </message>
    <message>
        <source>The mechanism is drawn with other arrows: these are columns of its incidence matrix $\Gamma^0$. From which link to which link do they point?</source>
        <translation>Mekanizma başka oklarla çizilmiştir: bunlar $\Gamma^0$ bağlantı matrisinin sütunlarıdır. Oklar hangi uzuvdan hangi uzva gider?</translation>
    </message>
    <message>
        <source>An arrow begins at the link whose entry is −1 and ends at the link whose entry is 1.</source>
        <translation>Ok, girdisi −1 olan uzuvda başlar ve girdisi 1 olan uzuvda biter.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>başlangıç</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bitiş</translation>
    </message>
    <message>
        <source>You turn every arrow round: −1 is where an arrow begins, 1 where it ends.</source>
        <translation>Her oku ters çevirdiniz: okun başladığı yer −1, bittiği yer 1&apos;dir.</translation>
    </message>
    <message>
        <source>You turn the arrow of %1 round: it begins at link %2, where the entry is −1.</source>
        <translation>%1 için oku ters çevirdiniz: ok, girdinin −1 olduğu %2 uzvunda başlar.</translation>
    </message>
    <message>
        <source>The link that you name as the beginning of %1 has a 0 in column %2.</source>
        <translation>%1 için başlangıç dediğiniz uzvun %2 sütununda 0 vardır.</translation>
    </message>
    <message>
        <source>The link that you name as the end of %1 has a 0 in column %2.</source>
        <translation>%1 için bitiş dediğiniz uzvun %2 sütununda 0 vardır.</translation>
    </message>
    <message>
        <source>One entry of this matrix $%1$ is wrong. Find it and correct it.</source>
        <translation>Bu $%1$ matrisinin bir girdisi yanlış. Bulun ve düzeltin.</translation>
    </message>
    <message>
        <source>The entry in row %1, column %2 is %3, not %4.</source>
        <translation>%1 satırı, %2 sütunundaki girdi %4 değil %3 olmalıdır.</translation>
    </message>
    <message>
        <source>row</source>
        <translation>satır</translation>
    </message>
    <message>
        <source>column</source>
        <translation>sütun</translation>
    </message>
    <message>
        <source>right value</source>
        <translation>doğru değer</translation>
    </message>
    <message>
        <source>You find the wrong entry, but its right value is another one.</source>
        <translation>Yanlış girdiyi buldunuz, ama doğru değeri başka.</translation>
    </message>
    <message>
        <source>The wrong entry is in this row, but the entry that you name is right.</source>
        <translation>Yanlış girdi bu satırda, ama gösterdiğiniz girdi doğru.</translation>
    </message>
    <message>
        <source>The wrong entry is in this column, but the entry that you name is right.</source>
        <translation>Yanlış girdi bu sütunda, ama gösterdiğiniz girdi doğru.</translation>
    </message>
    <message>
        <source>The entry that you name is right: follow the arrows of its row and column once more.</source>
        <translation>Gösterdiğiniz girdi doğru: satırının ve sütununun oklarını bir kez daha izleyin.</translation>
    </message>
    <message>
        <source>Take one column at a time. Its arrow touches two links only: the one that it leaves gets −1, the one that it points to gets 1.</source>
        <translation>Sütunları tek tek ele alın. Oku yalnız iki uzva dokunur: çıktığı uzuv −1, gösterdiği uzuv 1 alır.</translation>
    </message>
    <message>
        <source>Read the matrix, not the drawing, one column at a time: the arrow leaves the link whose entry is −1 and points to the link whose entry is 1.</source>
        <translation>Çizimi değil matrisi sütun sütun okuyun: ok, girdisi −1 olan uzuvdan çıkar ve girdisi 1 olan uzvu gösterir.</translation>
    </message>
    <message>
        <source>All speeds are measured against one link: Γ leaves out its row. The other rows are those of Γ⁰.</source>
        <translation>Bütün hızlar bir uzva göre ölçülür: Γ onun satırını içermez. Öteki satırlar Γ⁰&apos;ınkilerdir.</translation>
    </message>
    <message>
        <source>Start at the link of the column and walk to the ground along turning joints only. Then compare the arrow of each joint on the walk with your direction.</source>
        <translation>Sütunun uzvundan başlayıp yalnız döner mafsallar boyunca sabit uzva gidin. Sonra yoldaki her mafsalın okunu kendi yönünüzle karşılaştırın.</translation>
    </message>
    <message>
        <source>Keep the turning joints and only the mesh of the row: together they close one cycle. Begin along the mesh, from tail to head, and compare each arrow on the way back with your direction.</source>
        <translation>Döner mafsalları ve yalnız satırın dişli çiftini tutun: birlikte bir çevrim kapatırlar. Dişli çifti boyunca kuyruktan başa doğru başlayın ve dönüş yolundaki her oku kendi yönünüzle karşılaştırın.</translation>
    </message>
    <message>
        <source>From both links of the mesh, walk along turning joints toward the ground until the two walks meet. What they share from there on is not part of the cycle.</source>
        <translation>Dişli çiftinin iki uzvundan döner mafsallar boyunca, iki yol buluşana dek sabit uzva doğru gidin. Oradan sonra ortak olan kısım çevrime ait değildir.</translation>
    </message>
    <message>
        <source>Choose a link of the cycle and go once round without turning back. Only the direction of each arrow against your own counts.</source>
        <translation>Çevrimden bir uzuv seçin ve geri dönmeden bir kez dolaşın. Yalnız her okun sizin yönünüze göre yönü önemlidir.</translation>
    </message>
    <message>
        <source>Begin with the columns of the meshes: a cycle of the basis holds one mesh, its own. Then walk from the head of the mesh back to its tail along turning joints.</source>
        <translation>Dişli çiftlerinin sütunlarıyla başlayın: tabanın bir çevrimi tek dişli çifti, kendisininkini içerir. Sonra dişli çiftinin başından kuyruğuna döner mafsallar boyunca geri yürüyün.</translation>
    </message>
    <message>
        <source>Each mesh closes one cycle with the turning joints. Go round one after the other; within a row all signs belong to the same walk.</source>
        <translation>Her dişli çifti döner mafsallarla bir çevrim kapatır. Birer birer dolaşın; bir satırdaki bütün işaretler aynı tura aittir.</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree already. With the mesh they close a loop: which edges of this loop could go?</source>
        <translation>Döner mafsallar zaten bir kapsayan ağaçtır. Dişli çiftiyle bir döngü kapatırlar: bu döngünün hangi kenarları çıkarılabilir?</translation>
    </message>
    <message>
        <source>Derive the matrix from the drawing, row by row, and stop at the first entry that differs. Compare signs with the directions of the arrows.</source>
        <translation>Matrisi çizimden satır satır türetin ve farklı olan ilk girdide durun. İşaretleri okların yönleriyle karşılaştırın.</translation>
    </message>
    <message>
        <source>Start from the cycle of the mesh: only its joints have entries. The size of an entry is the number of teeth of the gear on whose axis the joint turns.</source>
        <translation>Dişli çiftinin çevriminden başlayın: yalnız onun mafsallarının girdisi vardır. Girdinin büyüklüğü, mafsalın ekseninde döndüğü dişlinin diş sayısıdır.</translation>
    </message>
    <message>
        <source>Each mesh gives one equation. Count those that do not follow from the others, and subtract their number from that of the turning joints.</source>
        <translation>Her dişli çifti bir denklem verir. Ötekilerden çıkmayanları sayın ve sayılarını döner mafsalların sayısından çıkarın.</translation>
    </message>
    <message>
        <source>Look for meshes that tie the same links together in two ways. Leave one out: if the others still force the same speeds, it is redundant.</source>
        <translation>Aynı uzuvları iki yoldan bağlayan dişli çiftlerini arayın. Birini çıkarın: ötekiler yine aynı hızları zorluyorsa o fazlalıktır.</translation>
    </message>
    <message>
        <source>Take as many joints as there are degrees of freedom. Imagine all of them locked: nothing else may move, and no mesh may tie two of them to each other.</source>
        <translation>Serbestlik derecesi kadar mafsal alın. Hepsinin kilitli olduğunu düşünün: başka hiçbir şey hareket etmemeli ve hiçbir dişli çifti ikisini birbirine bağlamamalıdır.</translation>
    </message>
    <message>
        <source>Look for a mesh whose equation has one unknown speed only, solve it, and go on to the next. A row of P θ̇ = 0 holds the joints of one cycle.</source>
        <translation>Denkleminde tek bilinmeyen hız olan bir dişli çifti arayın, çözün ve sıradakine geçin. P θ̇ = 0&apos;ın bir satırı bir çevrimin mafsallarını içerir.</translation>
    </message>
    <message>
        <source>The level of a joint is the letter of its axis. Name the axis of each joint on the walk: where the letter changes is the transfer vertex.</source>
        <translation>Mafsalın düzeyi, ekseninin harfidir. Yoldaki her mafsalın eksenini söyleyin: harfin değiştiği yer aktarma düğümüdür.</translation>
    </message>
    <message>
        <source>The carrier is the link where the level changes on the way between both gears. The gear with fewer teeth turns faster; for the sign, look at each gear along its own axis.</source>
        <translation>Taşıyıcı, iki dişli arasındaki yolda düzeyin değiştiği uzuvdur. Dişi az olan dişli daha hızlı döner; işaret için her dişliye kendi ekseni boyunca bakın.</translation>
    </message>
    <message>
        <source>Walk from the carrier to the gear along turning joints: only these joints count. Compare their arrows with your direction.</source>
        <translation>Taşıyıcıdan dişliye döner mafsallar boyunca gidin: yalnız bu mafsallar sayılır. Oklarını kendi yönünüzle karşılaştırın.</translation>
    </message>
    <message>
        <source>Without the joint the turning joints fall into two groups of links. Look for edges with one end in each group, and compare their direction with that of the joint.</source>
        <translation>Mafsal olmadan döner mafsallar iki uzuv grubuna ayrılır. Uçları ayrı gruplarda olan kenarları arayın ve yönlerini mafsalınkiyle karşılaştırın.</translation>
    </message>
    <message>
        <source>Write the power of each port, torque times speed. Their sum is zero if no power is lost; then put in the terminal equation.</source>
        <translation>Her kapının gücünü yazın: tork çarpı hız. Güç kaybı yoksa toplamları sıfırdır; sonra uç denklemini yerine koyun.</translation>
    </message>
    <message>
        <source>Reduce the fraction. Then multiply both of its parts by the same whole number until both are within the bounds.</source>
        <translation>Kesri sadeleştirin. Sonra iki kısmını da sınırlar içine girene dek aynı tam sayıyla çarpın.</translation>
    </message>
    <message>
        <source>The centre distance goes with the sum of the teeth where both gears are external, and with their difference where one is a ring.</source>
        <translation>Eksenler arası uzaklık, iki dişli de dışsa dişlerin toplamıyla, biri çemberse farkıyla orantılıdır.</translation>
    </message>
    <message>
        <source>Each engaged element takes degrees of freedom away until one is left. An engaged brake makes the speed of its link zero: try which set gives the ratio.</source>
        <translation>Devredeki her eleman, bir tane kalana dek serbestlik derecesi azaltır. Devredeki fren, uzvunun hızını sıfır yapar: hangi kümenin oranı verdiğini deneyin.</translation>
    </message>
    <message>
        <source>The torques of all shafts and brakes of the train add up to zero, and so do their powers. Write both sums for what is engaged, then compare the sizes.</source>
        <translation>Dişli takımının bütün mil ve frenlerinin torkları toplamı sıfırdır, güçleri de. Devredekiler için iki toplamı yazın, sonra büyüklükleri karşılaştırın.</translation>
    </message>
    <message>
        <source>Let the load drive: behind each mesh less power arrives, by its efficiency. If none would be left at the input, or it would have to be driven, the train locks.</source>
        <translation>Yükün tahrik ettiğini varsayın: her dişli çiftinin ardında verimi kadar az güç kalır. Girişte hiç güç kalmayacaksa ya da girişin tahrik edilmesi gerekecekse takım kilitlenir.</translation>
    </message>
    <message>
        <source>The torques of drive, load and brake on the train add up to zero, and a brake passes no power. What acts on a link acts on the other part in the opposite sense.</source>
        <translation>Tahrik, yük ve frenin dişli düzenine uyguladığı torkların toplamı sıfırdır; fren güç aktarmaz. Bir uzva etkiyen, öteki parçaya ters yönde etkir.</translation>
    </message>
    <message>
        <source>no joints</source>
        <translation>mafsal yok</translation>
    </message>
    <message>
        <source>the turning joints are no spanning tree</source>
        <translation>döner mafsallar kapsayan ağaç değil</translation>
    </message>
    <message>
        <source>no meshes</source>
        <translation>dişli çifti yok</translation>
    </message>
    <message>
        <source>a mesh has no geometry</source>
        <translation>bir dişli çiftinin geometrisi yok</translation>
    </message>
    <message>
        <source>too many cycles</source>
        <translation>çok fazla çevrim</translation>
    </message>
    <message>
        <source>too many edges</source>
        <translation>çok fazla kenar</translation>
    </message>
    <message>
        <source>the matrices are too large or too small</source>
        <translation>matrisler çok büyük ya da çok küçük</translation>
    </message>
    <message>
        <source>no mesh is redundant</source>
        <translation>fazlalık dişli çifti yok</translation>
    </message>
    <message>
        <source>nothing can move</source>
        <translation>hiçbir şey hareket edemez</translation>
    </message>
    <message>
        <source>too many inputs</source>
        <translation>çok fazla giriş</translation>
    </message>
    <message>
        <source>no speed follows from the inputs</source>
        <translation>girişlerden çıkan hız yok</translation>
    </message>
    <message>
        <source>no planet between a sun and a ring</source>
        <translation>güneş ile çember arasında gezegen yok</translation>
    </message>
    <message>
        <source>no brakes or clutches</source>
        <translation>fren ya da kavrama yok</translation>
    </message>
    <message>
        <source>no states with a ratio</source>
        <translation>oranı olan durum yok</translation>
    </message>
    <message>
        <source>no two torques of brakes or clutches to compare</source>
        <translation>karşılaştırılacak iki fren ya da kavrama torku yok</translation>
    </message>
    <message>
        <source>no brake that carries a torque about the drive&apos;s axis</source>
        <translation>tahrik ekseni çevresinde tork taşıyan fren yok</translation>
    </message>
    <message>
        <source>no drive passes power through 1 to 6 meshes</source>
        <translation>hiçbir tahrik gücü 1 ile 6 arası dişli çiftinden geçirmez</translation>
    </message>
    <message>
        <source>Fill in Γ⁰</source>
        <translation>Γ⁰&apos;ı doldur</translation>
    </message>
    <message>
        <source>Orient the digraph</source>
        <translation>Yönlü grafı yönlendir</translation>
    </message>
    <message>
        <source>Fill in Γ</source>
        <translation>Γ&apos;yı doldur</translation>
    </message>
    <message>
        <source>Fill in Z</source>
        <translation>Z&apos;yi doldur</translation>
    </message>
    <message>
        <source>Fill in T</source>
        <translation>T&apos;yi doldur</translation>
    </message>
    <message>
        <source>Find the cycle of a mesh</source>
        <translation>Bir dişli çiftinin çevrimini bul</translation>
    </message>
    <message>
        <source>Walk a cycle in either sense</source>
        <translation>Bir çevrimi istenen yönde dolaş</translation>
    </message>
    <message>
        <source>Fill in a row of C</source>
        <translation>C&apos;nin bir satırını doldur</translation>
    </message>
    <message>
        <source>Write all cycles</source>
        <translation>Bütün çevrimleri yaz</translation>
    </message>
    <message>
        <source>Choose a spanning tree</source>
        <translation>Bir kapsayan ağaç seç</translation>
    </message>
    <message>
        <source>Find the wrong entry</source>
        <translation>Yanlış girdiyi bul</translation>
    </message>
    <message>
        <source>Fill in a row of P</source>
        <translation>P&apos;nin bir satırını doldur</translation>
    </message>
    <message>
        <source>Rank and DOF</source>
        <translation>Rank ve SD</translation>
    </message>
    <message>
        <source>Redundant mesh</source>
        <translation>Fazlalık dişli çifti</translation>
    </message>
    <message>
        <source>Valid inputs</source>
        <translation>Geçerli girişler</translation>
    </message>
    <message>
        <source>Predict a speed</source>
        <translation>Bir hızı öngör</translation>
    </message>
    <message>
        <source>Levels and transfer vertex</source>
        <translation>Düzeyler ve aktarma düğümü</translation>
    </message>
    <message>
        <source>Terminal equation, sign</source>
        <translation>Uç denklemi, işaret</translation>
    </message>
    <message>
        <source>f-circuit equation</source>
        <translation>f-çevrim denklemi</translation>
    </message>
    <message>
        <source>Fill in a row of Q</source>
        <translation>Q&apos;nun bir satırını doldur</translation>
    </message>
    <message>
        <source>Torque of a port, sign</source>
        <translation>Bir kapının torku, işaret</translation>
    </message>
    <message>
        <source>Teeth for a ratio</source>
        <translation>Bir oran için diş sayıları</translation>
    </message>
    <message>
        <source>Teeth of the ring</source>
        <translation>Çemberin diş sayısı</translation>
    </message>
    <message>
        <source>Brakes for a gear</source>
        <translation>Bir vites için frenler</translation>
    </message>
    <message>
        <source>Largest torque of a brake</source>
        <translation>Bir frenin en büyük torku</translation>
    </message>
    <message>
        <source>Self-locking</source>
        <translation>Kendi kendine kilitlenme</translation>
    </message>
    <message>
        <source>Reaction of a brake, sense</source>
        <translation>Bir frenin tepkisi, yön</translation>
    </message>
    <message>
        <source>one cycle</source>
        <translation>bir çevrim</translation>
    </message>
    <message>
        <source>%1 cycles</source>
        <translation>%1 çevrim</translation>
    </message>
    <message>
        <source>one input</source>
        <translation>bir giriş</translation>
    </message>
    <message>
        <source>%1 inputs</source>
        <translation>%1 giriş</translation>
    </message>
    <message>
        <source>%1 redundant</source>
        <translation>%1 fazlalık</translation>
    </message>
    <message>
        <source>%1 states</source>
        <translation>%1 durum</translation>
    </message>
    <message>
        <source>easy: %1</source>
        <translation>kolay: %1</translation>
    </message>
    <message>
        <source>medium: %1</source>
        <translation>orta: %1</translation>
    </message>
    <message>
        <source>hard: %1</source>
        <translation>zor: %1</translation>
    </message>
    <message>
        <source>What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the mechanism have with every brake and clutch released?</source>
        <translation>$P$ katsayı matrisinin $r$ rankı nedir ve bütün fren ve kavramalar ayrıkken mekanizmanın kaç serbestlik derecesi $E$ vardır?</translation>
    </message>
    <message>
        <source>What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the mechanism have?</source>
        <translation>$P$ katsayı matrisinin $r$ rankı nedir ve mekanizmanın kaç serbestlik derecesi $E$ vardır?</translation>
    </message>
    <message>
        <source>Of the %1 rows of P, %2 are independent: %3</source>
        <translation>P&apos;nin %1 satırından %2 tanesi bağımsızdır: %3</translation>
    </message>
    <message>
        <source>All %1 rows of P are independent: %2</source>
        <translation>P&apos;nin %1 satırının hepsi bağımsızdır: %2</translation>
    </message>
    <message>
        <source>You count every mesh as a constraint: one mesh follows from the others, so that r is %1.</source>
        <translation>Her dişli çiftini kısıt saydınız: biri ötekilerden çıkar, bu yüzden r = %1.</translation>
    </message>
    <message>
        <source>You count every mesh as a constraint: %1 meshes follow from the others, so that r is %2.</source>
        <translation>Her dişli çiftini kısıt saydınız: %1 tanesi ötekilerden çıkar, bu yüzden r = %2.</translation>
    </message>
    <message>
        <source>The rank is not the number of meshes: one mesh follows from the others.</source>
        <translation>Rank, dişli çifti sayısı değildir: biri ötekilerden çıkar.</translation>
    </message>
    <message>
        <source>The rank is not the number of meshes: %1 meshes follow from the others.</source>
        <translation>Rank, dişli çifti sayısı değildir: %1 tanesi ötekilerden çıkar.</translation>
    </message>
    <message>
        <source>You exchange both numbers: r counts equations, E = t − r is left.</source>
        <translation>İki sayıyı karıştırdınız: r denklemleri sayar, kalan E = t − r&apos;dir.</translation>
    </message>
    <message>
        <source>You count the ground among the moving links: it has no turning joint of its own.</source>
        <translation>Sabit uzvu hareketli uzuvlardan saydınız: onun kendi döner mafsalı yoktur.</translation>
    </message>
    <message>
        <source>You take two degrees of freedom for each mesh: its gears roll and slide, so that it takes one.</source>
        <translation>Her dişli çifti için iki serbestlik derecesi çıkardınız: dişliler yuvarlanır ve kayar, bu yüzden yalnız bir tane çıkar.</translation>
    </message>
    <message>
        <source>You count the freedoms of the turning joints only: each independent mesh takes one of them.</source>
        <translation>Yalnız döner mafsalların serbestliklerini saydınız: her bağımsız dişli çifti birini alır.</translation>
    </message>
    <message>
        <source>The rank is right, but E = t − r = %1 − %2.</source>
        <translation>Rank doğru, ama E = t − r = %1 − %2.</translation>
    </message>
    <message>
        <source>Choose a valid set of inputs: turning joints whose speeds determine the whole motion.</source>
        <translation>Geçerli bir giriş kümesi seçin: hızları bütün hareketi belirleyen döner mafsallar.</translation>
    </message>
    <message>
        <source>A valid set has one joint, whose speed can be chosen freely and determines all others.</source>
        <translation>Geçerli kümede, hızı serbestçe seçilen ve bütün ötekileri belirleyen tek mafsal vardır.</translation>
    </message>
    <message>
        <source>A valid set has %1 joints whose speeds can be chosen freely and determine all others.</source>
        <translation>Geçerli kümede, hızları serbestçe seçilen ve bütün ötekileri belirleyen %1 mafsal vardır.</translation>
    </message>
    <message>
        <source>Joint %1 can never turn, so that it cannot be driven.</source>
        <translation>%1 mafsalı hiç dönemez, bu yüzden tahrik edilemez.</translation>
    </message>
    <message>
        <source>With one degree of freedom the other joints you name follow from one of them.</source>
        <translation>Bir serbestlik derecesiyle, söylediğiniz öteki mafsallar birinden çıkar.</translation>
    </message>
    <message>
        <source>With %1 degrees of freedom the other joints you name follow from %1 of them.</source>
        <translation>%1 serbestlik derecesiyle, söylediğiniz öteki mafsallar %1 tanesinden çıkar.</translation>
    </message>
    <message>
        <source>Joint %1 is on no cycle, so that only an input can determine its speed.</source>
        <translation>%1 mafsalı hiçbir çevrimde değil, hızını yalnız bir giriş belirleyebilir.</translation>
    </message>
    <message>
        <source>Joint %1 always turns at %2 times the speed of joint %3: only one of them can be chosen.</source>
        <translation>%1 mafsalı her zaman %3 mafsalının %2 katı hızla döner: yalnız biri seçilebilir.</translation>
    </message>
    <message>
        <source>The speeds of these joints depend on each other, so that some other joint stays free.</source>
        <translation>Bu mafsalların hızları birbirine bağlı, bu yüzden başka bir mafsal serbest kalır.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom: your inputs leave a motion open.</source>
        <translation>Mekanizmanın %1 serbestlik derecesi var: girişleriniz bir hareketi açık bırakıyor.</translation>
    </message>
    <message>
        <source>How many meshes are redundant, and which mesh could be left out without another motion? Name one of them.</source>
        <translation>Kaç dişli çifti fazlalıktır ve hareket değişmeden hangisi çıkarılabilir? Birini söyleyin.</translation>
    </message>
    <message>
        <source>The rank is %1 with %2 meshes, so that one is redundant; each of %3 follows from others.</source>
        <translation>%2 dişli çiftiyle rank %1&apos;dir, yani biri fazlalıktır; %3 içinden her biri ötekilerden çıkar.</translation>
    </message>
    <message>
        <source>The rank is %1 with %2 meshes, so that %3 are redundant; each of %4 follows from others.</source>
        <translation>%2 dişli çiftiyle rank %1&apos;dir, yani %3 tanesi fazlalıktır; %4 içinden her biri ötekilerden çıkar.</translation>
    </message>
    <message>
        <source>redundant meshes</source>
        <translation>fazlalık dişli çiftleri</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>biri</translation>
    </message>
    <message>
        <source>The rows of P are not independent: their rank is %1, fewer than %2 meshes.</source>
        <translation>P&apos;nin satırları bağımsız değil: rankları %1, dişli çifti sayısı %2&apos;den az.</translation>
    </message>
    <message>
        <source>There are as many redundant meshes as rows of P beyond its rank: %1 − %2.</source>
        <translation>P&apos;nin rankını aşan satırları kadar fazlalık dişli çifti vardır: %1 − %2.</translation>
    </message>
    <message>
        <source>Without mesh %1 the mechanism would gain a degree of freedom: it follows from no others.</source>
        <translation>%1 dişli çifti olmasa mekanizma bir serbestlik derecesi kazanırdı: ötekilerden çıkmaz.</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>döner</translation>
    </message>
    <message>
        <source>Of the power that it takes, seen from its carrier, each mesh passes the part $%1$; nothing else loses power. Now %2 drives backwards and %3 takes the power. Does the train turn, or does it lock itself? With which efficiency does it pass the power (0 where it locks itself)? A fraction or a decimal of three digits will do.</source>
        <translation>Her dişli çifti, taşıyıcısından bakıldığında aldığı gücün $%1$ kadarını geçirir; başka güç kaybı yoktur. Şimdi %2 geri tahrik eder, %3 gücü alır. Takım döner mi, yoksa kendi kendine kilitlenir mi? Gücü hangi verimle geçirir (kilitleniyorsa 0)? Bir kesir ya da üç basamaklı bir ondalık sayı yeterlidir.</translation>
    </message>
    <message>
        <source>driven backwards it</source>
        <translation>geri tahrik edilince</translation>
    </message>
    <message>
        <source>efficiency backwards</source>
        <translation>geri verim</translation>
    </message>
    <message>
        <source>joint $%1$</source>
        <translation>$%1$ mafsalı</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2.</source>
        <translation>Motor: %1; tahrik ettiği yük: %2.</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2, with joint %3 held.</source>
        <translation>Motor: %1; tahrik ettiği yük: %2; %3 mafsalı tutuluyor.</translation>
    </message>
    <message>
        <source>A motor in %1 drives a load at %2, with joints %3 held.</source>
        <translation>Motor: %1; tahrik ettiği yük: %2; %3 mafsalları tutuluyor.</translation>
    </message>
    <message>
        <source>link $%1$</source>
        <translation>$%1$ uzvu</translation>
    </message>
    <message>
        <source>In state “%1”, with %2 engaged, %3 drives a load on %4.</source>
        <translation>“%1” durumunda, %2 devredeyken, %3 yükü tahrik eder; yük: %4.</translation>
    </message>
    <message>
        <source>the mesh passes %1 W for each watt that is fed, seen from its carrier</source>
        <translation>dişli çifti taşıyıcısından bakıldığında beslenen her watt için %1 W geçirir</translation>
    </message>
    <message>
        <source>the meshes pass %1 W for each watt that is fed, seen from their carriers</source>
        <translation>dişli çiftleri taşıyıcılarından bakıldığında beslenen her watt için %1 W geçirir</translation>
    </message>
    <message>
        <source>gear %1 drives in mesh %2</source>
        <translation>%2 dişli çiftinde %1 dişlisi tahrik eder</translation>
    </message>
    <message>
        <source>Driven backwards, %1: of each watt that is fed %2 W arrive, so that the train turns.</source>
        <translation>Geri tahrik edilince: %1. Beslenen her wattın %2 W&apos;ı ulaşır, bu yüzden takım döner.</translation>
    </message>
    <message>
        <source>Without losses %1, and each loses %2 of what it takes: with these losses no load, however large, turns the drive: the train locks itself.</source>
        <translation>Kayıpsız %1 ve her biri aldığının %2 kadarını kaybeder: bu kayıplarla, ne kadar büyük olursa olsun hiçbir yük tahriki döndürmez: takım kendi kendine kilitlenir.</translation>
    </message>
    <message>
        <source>Backwards it passes %1.</source>
        <translation>Geri yönde %1 geçirir.</translation>
    </message>
    <message>
        <source>Your efficiency is upside down: it is the power taken over the power fed, less than 1.</source>
        <translation>Veriminiz ters: verim, alınan gücün beslenen güce oranıdır ve 1&apos;den küçüktür.</translation>
    </message>
    <message>
        <source>It does not lock itself: the losses are less than the power fed, and %1 of the power arrives when it is driven backwards.</source>
        <translation>Kendi kendine kilitlenmez: kayıplar beslenen güçten azdır ve geri tahrikte gücün %1 kadarı ulaşır.</translation>
    </message>
    <message>
        <source>Backwards it locks itself.</source>
        <translation>Geri yönde kendi kendine kilitlenir.</translation>
    </message>
    <message>
        <source>It locks itself: %1, and with these losses no load, however large, turns the drive.</source>
        <translation>Kendi kendine kilitlenir: %1 ve bu kayıplarla, ne kadar büyük olursa olsun hiçbir yük tahriki döndürmez.</translation>
    </message>
    <message>
        <source>It locks itself, right; but then no power passes: the efficiency is 0.</source>
        <translation>Kendi kendine kilitlenir, doğru; ama o zaman güç geçmez: verim 0&apos;dır.</translation>
    </message>
    <message>
        <source>This is the efficiency with the motor driving: backwards the other gears drive.</source>
        <translation>Bu, motor tahrik ederkenki verimdir: geri yönde öteki dişliler tahrik eder.</translation>
    </message>
    <message>
        <source>You leave out the losses of the meshes.</source>
        <translation>Dişli çiftlerinin kayıplarını atladınız.</translation>
    </message>
    <message>
        <source>You multiply the efficiencies of the meshes as in a train of fixed axes: seen from its carrier a mesh passes another power.</source>
        <translation>Dişli çiftlerinin verimlerini sabit eksenli takımdaki gibi çarptınız: taşıyıcısından bakıldığında bir dişli çifti başka bir güç geçirir.</translation>
    </message>
    <message>
        <source>The entries of this matrix are −1, 0 and 1 only: they tell senses, not sizes.</source>
        <translation>Bu matrisin girdileri yalnız −1, 0 ve 1&apos;dir: büyüklükleri değil yönleri söylerler.</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>as the drive&apos;s torque</source>
        <translation>tahrik torkuyla aynı yönde</translation>
    </message>
    <message>
        <source>against the drive&apos;s torque</source>
        <translation>tahrik torkuna ters yönde</translation>
    </message>
    <message>
        <source>State “%1” engages %2, link $%3$ drives and link $%4$ bears the load. The torque of the drive is $%5$ N m, and no power is lost. What torque, with its sign, does brake %6 exert on link $%7$? And in which sense does it try to turn the housing? A fraction or a decimal of three digits will do.</source>
        <translation>“%1” durumu %2 elemanını kavrar; $%3$ uzvu tahrik eder, $%4$ uzvu yükü taşır. Tahrik torku $%5$ N m’dir ve güç kaybı yoktur. %6 freni $%7$ uzvuna işaretiyle birlikte hangi torku uygular? Gövdeyi hangi yönde döndürmeye çalışır? Bir kesir ya da üç basamaklı bir ondalık yeterlidir.</translation>
    </message>
    <message>
        <source>torque on link %1 in N m</source>
        <translation>%1 uzvuna etkiyen tork, N m</translation>
    </message>
    <message>
        <source>turns the housing</source>
        <translation>gövdeyi döndürür</translation>
    </message>
    <message>
        <source>Brake %1 holds link %2 with %3 N m; the housing has the opposite, %4 N m.</source>
        <translation>%1 freni %2 uzvunu %3 N m ile tutar; gövdeye bunun tersi, %4 N m etkir.</translation>
    </message>
    <message>
        <source>This is what the housing feels: on link %1 the brake acts with %2 N m.</source>
        <translation>Bu, gövdenin hissettiğidir: fren %1 uzvuna %2 N m ile etkir.</translation>
    </message>
    <message>
        <source>A sign is lost: %1 N m of the drive, %2 N m that hold the load and the torque of the brake add up to 0.</source>
        <translation>Bir işaret kayboldu: tahrikin %1 N m’si, yükü tutan %2 N m ve frenin torku toplamda 0 eder.</translation>
    </message>
    <message>
        <source>You use the ratio upside down: with the ratio %1 the load is held by %2 N m.</source>
        <translation>Oranı ters kullanıyorsunuz: %1 oranıyla yükü %2 N m tutar.</translation>
    </message>
    <message>
        <source>This is the torque at the load on link %1: the brake has to keep the balance of drive and load.</source>
        <translation>Bu, %1 uzvundaki yükün torkudur: fren, tahrik ile yükün dengesini sağlamalıdır.</translation>
    </message>
    <message>
        <source>This is the torque of the drive: the brake does not carry it as it is.</source>
        <translation>Bu, tahrikin torkudur: fren onu olduğu gibi taşımaz.</translation>
    </message>
    <message>
        <source>Link %1 and the housing are turned in opposite senses by the brake: link %1 has %2 N m, the housing %3 N m.</source>
        <translation>Fren %1 uzvunu ve gövdeyi ters yönlerde döndürür: %1 uzvunda %2 N m, gövdede %3 N m vardır.</translation>
    </message>
    <message>
        <source>The inputs turn at %1 rad/s. What is $\dot{\theta}_{%2}$ in rad/s? A fraction or a decimal of three digits will do.</source>
        <translation>Girişler %1 rad/s ile döner. $\dot{\theta}_{%2}$ kaç rad/s&apos;dir? Bir kesir ya da üç basamaklı bir ondalık sayı yeterlidir.</translation>
    </message>
    <message>
        <source>The meshes in the chain give joint %1 the rate %2 rad/s.</source>
        <translation>Zincirdeki dişli çiftleri %1 mafsalına %2 rad/s hız verir.</translation>
    </message>
    <message>
        <source>speed of joint %1</source>
        <translation>%1 mafsalının hızı</translation>
    </message>
    <message>
        <source>The size is right, but the joint turns the other way.</source>
        <translation>Büyüklük doğru, ama mafsal öbür yönde döner.</translation>
    </message>
    <message>
        <source>You leave out input %1: the contributions of all inputs add up.</source>
        <translation>%1 girişini atladınız: bütün girişlerin katkıları toplanır.</translation>
    </message>
    <message>
        <source>You multiply by the whole ratio where you have to divide by it: %1 turns at %2 rad/s.</source>
        <translation>Bölmeniz gereken yerde bütün oranla çarptınız: %1, %2 rad/s ile döner.</translation>
    </message>
    <message>
        <source>You use the ratio of mesh %1 upside down.</source>
        <translation>%1 dişli çiftinin oranını ters kullandınız.</translation>
    </message>
    <message>
        <source>The sign of mesh %1 is the opposite in your chain.</source>
        <translation>Zincirinizde %1 dişli çiftinin işareti ters.</translation>
    </message>
    <message>
        <source>You use speeds relative to the ground in the meshes: a mesh relates the speeds of its gears in their carrier.</source>
        <translation>Dişli çiftlerinde sabit uzva göre hızları kullandınız: dişli çifti, dişlilerinin taşıyıcıdaki hızlarını bağlar.</translation>
    </message>
    <message>
        <source>This is the speed of link %1 relative to the ground: the joint&apos;s rate is relative to the link that carries it.</source>
        <translation>Bu, %1 uzvunun sabit uzva göre hızıdır: mafsalın hızı onu taşıyan uzva göredir.</translation>
    </message>
    <message>
        <source>Which brakes and clutches have to be engaged for state “%1”, in which link $%2$ turns at $%3$ times the speed of link $%4$?</source>
        <translation>$%2$ uzvunun $%4$ uzvunun $%3$ katı hızla döndüğü “%1” durumu için hangi fren ve kavramalar devrede olmalıdır?</translation>
    </message>
    <message>
        <source>With %1 engaged one degree of freedom is left and the ratio is %2.</source>
        <translation>%1 devredeyken bir serbestlik derecesi kalır ve oran %2&apos;dir.</translation>
    </message>
    <message>
        <source>engaged</source>
        <translation>devrede</translation>
    </message>
    <message>
        <source>These couplings engage state “%1”, not “%2”.</source>
        <translation>Bu elemanlar “%2” değil “%1” durumunu verir.</translation>
    </message>
    <message>
        <source>More than one degree of freedom is left: another brake or clutch has to be engaged.</source>
        <translation>Birden çok serbestlik derecesi kalıyor: bir fren ya da kavrama daha devreye alınmalıdır.</translation>
    </message>
    <message>
        <source>These couplings together lock the drive.</source>
        <translation>Bu elemanlar birlikte tahriki kilitler.</translation>
    </message>
    <message>
        <source>The drive turns with these couplings, but its ratio is not %1.</source>
        <translation>Tahrik bu elemanlarla döner, ama oran %1 değildir.</translation>
    </message>
    <message>
        <source>The terminal equation of mesh $%1$ is $\omega_{%2} = %3 \, \omega_{%4}$. No power is lost. Write the torque of the second port in terms of the first one&apos;s: the factor $f$ with its sign.</source>
        <translation>$%1$ dişli çiftinin uç denklemi $\omega_{%2} = %3 \, \omega_{%4}$ şeklindedir. Güç kaybı yoktur. İkinci kapının torkunu birincininki cinsinden yazın: işaretiyle $f$ çarpanı.</translation>
    </message>
    <message>
        <source>The powers of both ports add up to 0, so that the torques have the inverse ratio of the speeds with the opposite sign: f = %1.</source>
        <translation>İki kapının güçleri toplamı 0&apos;dır; bu yüzden torkların oranı hızlarınkinin tersi, işareti karşıttır: f = %1.</translation>
    </message>
    <message>
        <source>The ratio is right, but the sign is not: what one port takes in the other gives off.</source>
        <translation>Oran doğru, işaret değil: bir kapının aldığını öteki verir.</translation>
    </message>
    <message>
        <source>You use the relation of the speeds: torques have the inverse ratio and the opposite sign.</source>
        <translation>Hızların bağıntısını kullandınız: torkların oranı ters, işareti karşıttır.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: the gear that turns more slowly has the larger torque.</source>
        <translation>Oranınız ters: yavaş dönen dişlinin torku büyüktür.</translation>
    </message>
    <message>
        <source>Choose numbers of teeth between $%1$ and $%2$ for mesh $%3$ so that $i_{%3} = \frac{N_{%4}}{N_{%5}} = %6$.</source>
        <translation>$%3$ dişli çifti için $i_{%3} = \frac{N_{%4}}{N_{%5}} = %6$ olacak biçimde $%1$ ile $%2$ arasında diş sayıları seçin.</translation>
    </message>
    <message>
        <source>N%1 : N%2 = %3 : %4, for example %5 and %6 teeth.</source>
        <translation>N%1 : N%2 = %3 : %4, örneğin %5 ve %6 diş.</translation>
    </message>
    <message>
        <source>A number of teeth is a whole number between %1 and %2 here.</source>
        <translation>Burada diş sayısı %1 ile %2 arasında bir tam sayıdır.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: it is %1, not %2.</source>
        <translation>Oranınız ters: %2 değil %1.</translation>
    </message>
    <message>
        <source>The quotient of your numbers is not %1.</source>
        <translation>Sayılarınızın bölümü %1 değil.</translation>
    </message>
    <message>
        <source>Let link $%1$ have $%2$ teeth and the planet $%3$ in mesh $%4$ and $%5$ in mesh $%6$, all of one module and without profile shift.</source>
        <translation>$%1$ uzvunun $%2$ dişi, gezegenin $%4$ dişli çiftinde $%3$, $%6$ dişli çiftinde $%5$ dişi olsun; modül hep aynı, profil kaydırma yok.</translation>
    </message>
    <message>
        <source>Let link $%1$ have $%2$ teeth and the planet $%3$, all of one module and without profile shift.</source>
        <translation>$%1$ uzvunun $%2$, gezegenin $%3$ dişi olsun; modül hep aynı, profil kaydırma yok.</translation>
    </message>
    <message>
        <source>Planet $%1$ is in external mesh $%2$ with link $%3$ and in internal mesh $%4$ with ring $%5$. %6 How many teeth must the ring have, so that both centre distances are equal?</source>
        <translation>$%1$ gezegeni $%2$ dış dişli çiftinde $%3$ uzvuyla, $%4$ iç dişli çiftinde $%5$ çemberiyle eştir. %6 İki eksen uzaklığının eşit olması için çemberin kaç dişi olmalıdır?</translation>
    </message>
    <message>
        <source>The centre distance is half the sum of an external pair and half the difference of an internal one: %1 + %2 = N − %3, so that N = %4.</source>
        <translation>Eksen uzaklığı dış çiftte toplamın, iç çiftte farkın yarısıdır: %1 + %2 = N − %3, yani N = %4.</translation>
    </message>
    <message>
        <source>teeth of the ring</source>
        <translation>çemberin dişleri</translation>
    </message>
    <message>
        <source>You add the teeth of the ring: the centre distance of an internal pair is half the difference.</source>
        <translation>Çemberin dişlerini topladınız: iç çiftin eksen uzaklığı farkın yarısıdır.</translation>
    </message>
    <message>
        <source>You count the planet once: it is between the sun and the ring on both sides.</source>
        <translation>Gezegeni bir kez saydınız: güneş ile çember arasında iki yanda da bulunur.</translation>
    </message>
    <message>
        <source>Take meshes and turning joints alike as edges of one graph. Choose a spanning tree of it that contains mesh $%1$.</source>
        <translation>Dişli çiftlerini ve döner mafsalları birlikte bir grafın kenarları sayın. Onun $%1$ dişli çiftini içeren bir kapsayan ağacını seçin.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges and no loop: take the mesh in and a joint of its cycle out.</source>
        <translation>%1 uzvun kapsayan ağacında %2 kenar vardır ve döngü yoktur: dişli çiftini alın, çevriminden bir mafsalı çıkarın.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>kenarlar</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree, but mesh %1 is not in it.</source>
        <translation>Döner mafsallar bir kapsayan ağaçtır, ama %1 dişli çifti içinde değil.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges: yours leaves links loose.</source>
        <translation>%1 uzvun kapsayan ağacında %2 kenar vardır: sizinki uzuvları açıkta bırakır.</translation>
    </message>
    <message>
        <source>A spanning tree of %1 links has %2 edges: with more of them some close a loop.</source>
        <translation>%1 uzvun kapsayan ağacında %2 kenar vardır: daha çoğuyla bazıları döngü kapatır.</translation>
    </message>
    <message>
        <source>Some of your edges close a loop, so that another link is left loose.</source>
        <translation>Kenarlarınızdan bazıları döngü kapatıyor, bu yüzden başka bir uzuv açıkta kalıyor.</translation>
    </message>
    <message>
        <source>Your edges are a spanning tree, but mesh %1 is not among them.</source>
        <translation>Kenarlarınız bir kapsayan ağaç, ama %1 dişli çifti aralarında değil.</translation>
    </message>
    <message>
        <source>Link %1 is a gear of mesh %2, not its carrier: the level changes at link %3.</source>
        <translation>%1 uzvu %2 dişli çiftinin taşıyıcısı değil dişlisidir: düzey %3 uzvunda değişir.</translation>
    </message>
    <message>
        <source>You measure from the ground, but the level changes at link %1.</source>
        <translation>Sabit uzuvdan ölçtünüz, ama düzey %1 uzvunda değişir.</translation>
    </message>
    <message>
        <source>Both edges of the path at link %1 are on one level: the level changes at link %2.</source>
        <translation>Yolun %1 uzvundaki iki kenarı aynı düzeydedir: düzey %2 uzvunda değişir.</translation>
    </message>
    <message>
        <source>Link %1 is not on the path between both gears: the level changes at link %2.</source>
        <translation>%1 uzvu iki dişli arasındaki yolda değil: düzey %2 uzvunda değişir.</translation>
    </message>
    <message>
        <source>Walk from link $%1$ through the tree branches to link $%2$, the gears of mesh $%3$. On which levels do both gears turn in their carrier, and which link is the transfer vertex?</source>
        <translation>$%3$ dişli çiftinin dişlileri olan $%1$ uzvundan $%2$ uzvuna ağaç dalları boyunca gidin. İki dişli taşıyıcılarında hangi düzeylerde döner ve aktarma düğümü hangi uzuvdur?</translation>
    </message>
    <message>
        <source>The walk begins on level %1 and ends on level %2; the link where the level changes, %3, is the transfer vertex: the carrier of the mesh.</source>
        <translation>Yol %1 düzeyinde başlar, %2 düzeyinde biter; düzeyin değiştiği %3 uzvu aktarma düğümüdür: dişli çiftinin taşıyıcısı.</translation>
    </message>
    <message>
        <source>level of link %1</source>
        <translation>%1 uzvunun düzeyi</translation>
    </message>
    <message>
        <source>transfer vertex</source>
        <translation>aktarma düğümü</translation>
    </message>
    <message>
        <source>You exchange the levels: link %1 turns on level %2, link %3 on level %4.</source>
        <translation>Düzeyleri karıştırdınız: %1 uzvu %2 düzeyinde, %3 uzvu %4 düzeyinde döner.</translation>
    </message>
    <message>
        <source>Level %1 is that of the other gear: this one turns on level %2.</source>
        <translation>%1 düzeyi öteki dişlininkidir: bu dişli %2 düzeyinde döner.</translation>
    </message>
    <message>
        <source>The walk between both gears uses the levels %1 and %2 only.</source>
        <translation>İki dişli arasındaki yol yalnız %1 ve %2 düzeylerini kullanır.</translation>
    </message>
    <message>
        <source>Write the terminal equation of mesh $%1$, with $N_{%2} = %3$ and $N_{%4} = %5$ teeth: the carrier $k$, and the factor $f$ with its sign.</source>
        <translation>$N_{%2} = %3$ ve $N_{%4} = %5$ dişli $%1$ dişli çiftinin uç denklemini yazın: $k$ taşıyıcısı ve işaretiyle $f$ çarpanı.</translation>
    </message>
    <message>
        <source>Seen from carrier %1, the gears of mesh %2 turn the same way, each along its own axis: f = %3.</source>
        <translation>%1 taşıyıcısından bakıldığında %2 dişli çiftinin dişlileri, her biri kendi ekseninde, aynı yönde döner: f = %3.</translation>
    </message>
    <message>
        <source>Seen from carrier %1, the gears of mesh %2 turn against each other, each along its own axis: f = %3.</source>
        <translation>%1 taşıyıcısından bakıldığında %2 dişli çiftinin dişlileri, her biri kendi ekseninde, ters yönde döner: f = %3.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: seen from the carrier, its gears turn the same way, so that f is %2.</source>
        <translation>%1 dişli çifti içtir: taşıyıcıdan bakıldığında dişlileri aynı yönde döner, yani f = %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: seen from the carrier, its gears turn against each other, so that f is %2.</source>
        <translation>%1 dişli çifti dıştır: taşıyıcıdan bakıldığında dişlileri ters yönde döner, yani f = %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a bevel mesh: seen from the carrier, its gears turn the same way, so that f is %2.</source>
        <translation>%1 konik dişli çiftidir: taşıyıcıdan bakıldığında dişlileri aynı yönde döner, yani f = %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a bevel mesh: seen from the carrier, its gears turn against each other, so that f is %2.</source>
        <translation>%1 konik dişli çiftidir: taşıyıcıdan bakıldığında dişlileri ters yönde döner, yani f = %2.</translation>
    </message>
    <message>
        <source>Your ratio is upside down: the gear with more teeth turns more slowly, f = %1.</source>
        <translation>Oranınız ters: dişi çok olan dişli daha yavaş döner, f = %1.</translation>
    </message>
    <message>
        <source>Your ratio is upside down, and the sign is wrong, too: f = %1.</source>
        <translation>Oranınız ters, işaret de yanlış: f = %1.</translation>
    </message>
    <message>
        <source>You take the teeth of another wheel on the same link: mesh %1 has %2 and %3.</source>
        <translation>Aynı uzuvdaki başka bir dişlinin dişlerini aldınız: %1 dişli çiftinde %2 ve %3 vardır.</translation>
    </message>
    <message>
        <source>Write the f-circuit equation of the chord between gear $%1$ and carrier $%2$: the coefficients of the branches.</source>
        <translation>$%1$ dişlisi ile $%2$ taşıyıcısı arasındaki kirişin f-çevrim denklemini yazın: dalların katsayıları.</translation>
    </message>
    <message>
        <source>The speed of gear %1 in carrier %2 is the sum over the branches between them: 1 for a branch that points to the gear, −1 for one that points to the carrier, as their axes do.</source>
        <translation>%1 dişlisinin %2 taşıyıcısındaki hızı, aralarındaki dalların toplamıdır: dişliyi gösteren dal 1, taşıyıcıyı gösteren dal −1 alır; eksenleri de öyle.</translation>
    </message>
    <message>
        <source>You write the speed of the carrier relative to the gear: all signs are the opposite.</source>
        <translation>Taşıyıcının dişliye göre hızını yazdınız: bütün işaretler ters.</translation>
    </message>
    <message>
        <source>This is the circuit of the other chord of mesh %1, of gear %2.</source>
        <translation>Bu, %1 dişli çiftinin öteki kirişinin, %2 dişlisinin çevrimidir.</translation>
    </message>
    <message>
        <source>You write the speed relative to the ground: the chord ends at carrier %1.</source>
        <translation>Sabit uzva göre hızı yazdınız: kiriş %1 taşıyıcısında biter.</translation>
    </message>
    <message>
        <source>You follow the walk from gear to gear: the chord ends at carrier %1.</source>
        <translation>Dişliden dişliye yolu izlediniz: kiriş %1 taşıyıcısında biter.</translation>
    </message>
    <message>
        <source>You give all branches one sign: one that points from the gear to the carrier counts −1.</source>
        <translation>Bütün dallara tek işaret verdiniz: dişliden taşıyıcıya giden dal −1 sayılır.</translation>
    </message>
    <message>
        <source>The branches between gear %1 and carrier %2 do not include %3: 0.</source>
        <translation>%1 dişlisi ile %2 taşıyıcısı arasındaki dallarda şu yoktur: %3: 0.</translation>
    </message>
    <message>
        <source>The sign of %1 is the opposite on the way from the carrier to the gear: %2.</source>
        <translation>%1 için işaret, taşıyıcıdan dişliye giderken terstir: %2.</translation>
    </message>
    <message>
        <source>The circuit closes through %1: %2, not 0.</source>
        <translation>Çevrim şuradan kapanır: %1; %2, 0 değil.</translation>
    </message>
    <message>
        <source>%1 does not use %2: 0.</source>
        <translation>%1 şunu kullanmaz: %2: 0.</translation>
    </message>
    <message>
        <source>%1 runs along the arrow of %2: 1, not −1.</source>
        <translation>%1, şunun oku boyunca gider: %2; 1, −1 değil.</translation>
    </message>
    <message>
        <source>%1 runs against the arrow of %2: −1, not 1.</source>
        <translation>%1, şunun okuna ters gider: %2; −1, 1 değil.</translation>
    </message>
    <message>
        <source>%1 uses %2, along its arrow: 1, not 0.</source>
        <translation>%1 şunu oku boyunca kullanır: %2; 1, 0 değil.</translation>
    </message>
    <message>
        <source>%1 uses %2, against its arrow: −1, not 0.</source>
        <translation>%1 şunu okuna ters kullanır: %2; −1, 0 değil.</translation>
    </message>
    <message>
        <source>The cycle of mesh %1</source>
        <translation>%1 dişli çiftinin çevrimi</translation>
    </message>
    <message>
        <source>You walk the cycle against mesh %1: it runs along the mesh from tail to head and back through the tree.</source>
        <translation>Çevrimi %1 dişli çiftine ters dolaştınız: çevrim, dişli çifti boyunca kuyruktan başa gider ve ağaçtan döner.</translation>
    </message>
    <message>
        <source>You mark the joints of the cycle without their senses: −1 where the walk runs against an arrow.</source>
        <translation>Çevrimin mafsallarını yönsüz işaretlediniz: yolun oka ters gittiği yer −1&apos;dir.</translation>
    </message>
    <message>
        <source>This is the row of the cycle of mesh %1, not of mesh %2.</source>
        <translation>Bu, %2 değil %1 dişli çiftinin çevrim satırıdır.</translation>
    </message>
    <message>
        <source>%1 begins along the mesh itself: 1.</source>
        <translation>%1 dişli çiftinin kendisi boyunca başlar: 1.</translation>
    </message>
    <message>
        <source>%1 is walked along its mesh, from tail to head: 1, not −1.</source>
        <translation>%1, dişli çifti boyunca kuyruktan başa dolaşılır: 1, −1 değil.</translation>
    </message>
    <message>
        <source>%1 holds one mesh only, not mesh %2: 0.</source>
        <translation>%1 tek dişli çifti içerir, %2 dişli çiftini içermez: 0.</translation>
    </message>
    <message>
        <source>Fill in these rows and columns of the path matrix $Z$: how the walk from each link to the ground uses the turning joints.</source>
        <translation>$Z$ yol matrisinin bu satır ve sütunlarını doldurun: her uzuvdan sabit uzva giden yol döner mafsalları nasıl kullanır.</translation>
    </message>
    <message>
        <source>Walk from the link to the ground: 1 where the walk follows a joint&apos;s arrow, −1 where it runs against it, 0 off the walk.</source>
        <translation>Uzuvdan sabit uzva gidin: yol mafsalın okunu izliyorsa 1, ona ters gidiyorsa −1, yol dışında 0.</translation>
    </message>
    <message>
        <source>You walk from the ground to the links: the walks of Z end at the ground.</source>
        <translation>Sabit uzuvdan uzuvlara gittiniz: Z&apos;nin yolları sabit uzuvda biter.</translation>
    </message>
    <message>
        <source>You mark the joints of the walks without their senses: −1 where a walk runs against an arrow.</source>
        <translation>Yolların mafsallarını yönsüz işaretlediniz: yolun oka ters gittiği yer −1&apos;dir.</translation>
    </message>
    <message>
        <source>You exchange rows and columns: a column of Z belongs to a link and tells its walk.</source>
        <translation>Satırlarla sütunları karıştırdınız: Z&apos;nin bir sütunu bir uzva aittir ve onun yolunu anlatır.</translation>
    </message>
    <message>
        <source>This is the walk of link %1, not of link %2.</source>
        <translation>Bu, %2 değil %1 uzvunun yoludur.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground</source>
        <translation>%1 uzvundan sabit uzva giden yol</translation>
    </message>
    <message>
        <source>Fill in this row of the spanning-tree matrix $T$.</source>
        <translation>$T$ kapsayan ağaç matrisinin bu satırını doldurun.</translation>
    </message>
    <message>
        <source>Fill in these rows of the spanning-tree matrix $T$.</source>
        <translation>$T$ kapsayan ağaç matrisinin bu satırlarını doldurun.</translation>
    </message>
    <message>
        <source>Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows a joint&apos;s arrow, −1 where it runs against it.</source>
        <translation>Çevrimi dişli çifti boyunca kuyruktan başa ve ağaçtan geri dolaşın: yol mafsalın okunu izliyorsa 1, ona ters gidiyorsa −1.</translation>
    </message>
    <message>
        <source>You walk the cycles against their meshes: they run along the mesh from tail to head and back through the tree.</source>
        <translation>Çevrimleri dişli çiftlerine ters dolaştınız: dişli çifti boyunca kuyruktan başa gider ve ağaçtan dönerler.</translation>
    </message>
    <message>
        <source>You mark the joints of the cycles without their senses: −1 where the walk runs against an arrow.</source>
        <translation>Çevrimlerin mafsallarını yönsüz işaretlediniz: yolun oka ters gittiği yer −1&apos;dir.</translation>
    </message>
    <message>
        <source>You exchange the rows of both cycles.</source>
        <translation>İki çevrimin satırlarını karıştırdınız.</translation>
    </message>
    <message>
        <source>Fill in row $C_{%1}$ of the cycle-basis matrix $C = \left[ T \mid U \right]$.</source>
        <translation>$C = \left[ T \mid U \right]$ çevrim tabanı matrisinin $C_{%1}$ satırını doldurun.</translation>
    </message>
    <message>
        <source>Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows an arrow, −1 where it runs against one.</source>
        <translation>Çevrimi dişli çifti boyunca kuyruktan başa ve ağaçtan geri dolaşın: yol oku izliyorsa 1, ona ters gidiyorsa −1.</translation>
    </message>
    <message>
        <source>Fill in the row of joint $%1$ of the fundamental cutset matrix $Q = \left[ U \mid -T^T \right]$.</source>
        <translation>$Q = \left[ U \mid -T^T \right]$ temel kesitleme matrisinde $%1$ mafsalının satırını doldurun.</translation>
    </message>
    <message>
        <source>Without the joint the tree falls into two halves: every edge between them counts, 1 where it crosses in the joint&apos;s direction, −1 where it crosses the other way.</source>
        <translation>Mafsal olmadan ağaç iki yarıya ayrılır: aralarındaki her kenar sayılır; mafsalın yönünde geçiyorsa 1, öbür yönde geçiyorsa −1.</translation>
    </message>
    <message>
        <source>You take the signs of the cycles: Q holds −T transposed beside the unit matrix.</source>
        <translation>Çevrimlerin işaretlerini aldınız: Q, birim matrisin yanında −T&apos;nin devriğini içerir.</translation>
    </message>
    <message>
        <source>You mark the edges of the cutset without their senses: −1 where an edge crosses against the joint.</source>
        <translation>Kesitlemenin kenarlarını yönsüz işaretlediniz: kenarın mafsala ters geçtiği yer −1&apos;dir.</translation>
    </message>
    <message>
        <source>This is the cutset of joint %1, not of %2.</source>
        <translation>Bu, %1 mafsalının kesitlemesidir; istenen: %2.</translation>
    </message>
    <message>
        <source>The joint crosses its own cut in its own direction: 1, not −1.</source>
        <translation>Mafsal kendi kesitini kendi yönünde geçer: 1, −1 değil.</translation>
    </message>
    <message>
        <source>The cutset holds its own joint: 1, not 0.</source>
        <translation>Kesitleme kendi mafsalını içerir: 1, 0 değil.</translation>
    </message>
    <message>
        <source>A fundamental cutset holds one turning joint only, not %1: 0.</source>
        <translation>Temel kesitleme tek döner mafsal içerir, şunu içermez: %1: 0.</translation>
    </message>
    <message>
        <source>Both gears of %1 are on one side of %2: 0.</source>
        <translation>%1 için iki dişli de %2 için aynı taraftadır: 0.</translation>
    </message>
    <message>
        <source>The arrow of %1 crosses the cut in the direction of %2: 1, not −1.</source>
        <translation>%1 için ok, kesiti %2 yönünde geçer: 1, −1 değil.</translation>
    </message>
    <message>
        <source>The arrow of %1 crosses the cut against %2: −1, not 1.</source>
        <translation>%1 için ok, kesiti %2 yönüne ters geçer: −1, 1 değil.</translation>
    </message>
    <message>
        <source>The ends of %1 are on different sides of %2: %3, not 0.</source>
        <translation>%1 için uçlar %2 için ayrı taraflardadır: %3, 0 değil.</translation>
    </message>
    <message>
        <source>The field %1 is empty.</source>
        <translation>“%1” alanı boş.</translation>
    </message>
    <message>
        <source>“%1” can be read as a thousand or as a decimal: write it without the comma, or as a fraction.</source>
        <translation>“%1” bin ya da ondalık sayı olarak okunabilir: virgülsüz ya da kesir olarak yazın.</translation>
    </message>
    <message>
        <source>“%1” is not a number: write a whole number, a fraction such as −3/4 or a decimal.</source>
        <translation>“%1” bir sayı değil: tam sayı, −3/4 gibi bir kesir ya da ondalık sayı yazın.</translation>
    </message>
    <message>
        <source>“%1” is not among what the question offers for %2.</source>
        <translation>“%1”, sorunun “%2” için sunduklarından biri değil.</translation>
    </message>
    <message>
        <source>meshes %1</source>
        <translation>%1 dişli çiftleri</translation>
    </message>
    <message>
        <source>Mesh %1 follows from %2: it constrains nothing more. Harmless for the motion; the load is shared.</source>
        <translation>%1 dişli çifti şunlardan çıkar: %2; başka bir şeyi kısıtlamaz. Hareket için zararsızdır; yük paylaşılır.</translation>
    </message>
    <message>
        <source>Brake %1 is engaged and holds nothing that could move.</source>
        <translation>%1 freni devrede ve hareket edebilecek hiçbir şeyi tutmuyor.</translation>
    </message>
    <message>
        <source>Brake %1 is engaged and holds nothing that could move: that follows from %2.</source>
        <translation>%1 freni devrede ve hareket edebilecek hiçbir şeyi tutmuyor: bu zaten şunlardan çıkar: %2.</translation>
    </message>
    <message>
        <source>Clutch %1 is engaged and holds nothing that could move.</source>
        <translation>%1 kavraması devrede ve hareket edebilecek hiçbir şeyi tutmuyor.</translation>
    </message>
    <message>
        <source>Clutch %1 is engaged and holds nothing that could move: that follows from %2.</source>
        <translation>%1 kavraması devrede ve hareket edebilecek hiçbir şeyi tutmuyor: bu zaten şunlardan çıkar: %2.</translation>
    </message>
    <message>
        <source>Nothing can move: the loop of %1 locks it. Change a tooth count so that the ratios round the loop agree, or delete a mesh.</source>
        <translation>Hiçbir şey hareket edemez: şunların döngüsü kilitliyor: %1. Döngüdeki oranlar uyuşsun diye bir diş sayısını değiştirin ya da bir dişli çiftini silin.</translation>
    </message>
    <message>
        <source>Nothing can move: %1 holds everything. Release a coupling.</source>
        <translation>Hiçbir şey hareket edemez: %1 her şeyi tutuyor. Bir elemanı ayırın.</translation>
    </message>
    <message>
        <source>Nothing can move: %1 hold everything. Release a coupling.</source>
        <translation>Hiçbir şey hareket edemez: %1 her şeyi tutuyor. Bir elemanı ayırın.</translation>
    </message>
    <message>
        <source>Joint %1 can never turn, locked by %2.</source>
        <translation>%1 mafsalı hiç dönemez; kilitleyen: %2.</translation>
    </message>
    <message>
        <source>Joints %1 can never turn, locked by %2.</source>
        <translation>%1 mafsalları hiç dönemez; kilitleyen: %2.</translation>
    </message>
    <message>
        <source>Links %1 form a rigid block.</source>
        <translation>%1 uzuvları rijit bir blok oluşturur.</translation>
    </message>
    <message>
        <source>No mesh constrains joint %1: it has to be driven.</source>
        <translation>Hiçbir dişli çifti %1 mafsalını kısıtlamaz: tahrik edilmesi gerekir.</translation>
    </message>
    <message>
        <source>No mesh constrains joints %1: they have to be driven.</source>
        <translation>Hiçbir dişli çifti %1 mafsallarını kısıtlamaz: tahrik edilmeleri gerekir.</translation>
    </message>
    <message>
        <source>The mechanism has 1 degree of freedom, and 1 input is chosen.</source>
        <translation>Mekanizmanın 1 serbestlik derecesi var ve 1 giriş seçili.</translation>
    </message>
    <message>
        <source>The mechanism has 1 degree of freedom, and %1 inputs are chosen.</source>
        <translation>Mekanizmanın 1 serbestlik derecesi var ve %1 giriş seçili.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom, and 1 input is chosen.</source>
        <translation>Mekanizmanın %1 serbestlik derecesi var ve 1 giriş seçili.</translation>
    </message>
    <message>
        <source>The mechanism has %1 degrees of freedom, and %2 inputs are chosen.</source>
        <translation>Mekanizmanın %1 serbestlik derecesi var ve %2 giriş seçili.</translation>
    </message>
    <message>
        <source>Joint %1 is chosen twice.</source>
        <translation>%1 mafsalı iki kez seçili.</translation>
    </message>
    <message>
        <source>Joint %1 is no free choice: %2.</source>
        <translation>%1 mafsalı serbestçe seçilemez: %2.</translation>
    </message>
    <message>
        <source>Still free: choose %1 too.</source>
        <translation>Hâlâ serbest: %1 de seçin.</translation>
    </message>
    <message>
        <source>The only valid set is the empty one.</source>
        <translation>Tek geçerli küme boş kümedir.</translation>
    </message>
    <message>
        <source>A valid set is %1.</source>
        <translation>Geçerli bir küme: %1.</translation>
    </message>
    <message>
        <source>There are no gear meshes yet: every joint is free.</source>
        <translation>Henüz dişli çifti yok: her mafsal serbest.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: the train holds it with nothing engaged. Change the train, or drive another link.</source>
        <translation>%1 durumu tahrikini (%2 uzvu) kilitler: hiçbir eleman devrede değilken dişli takımı onu tutar. Takımı değiştirin ya da başka bir uzvu tahrik edin.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: more couplings than one hold it. Release two or more, or drive another link.</source>
        <translation>%1 durumu tahrikini (%2 uzvu) kilitler: birden çok eleman onu tutar. İki ya da daha çoğunu ayırın ya da başka bir uzvu tahrik edin.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: %3 holds it. Release it, or drive another link.</source>
        <translation>%1 durumu tahrikini (%2 uzvu) kilitler: onu %3 tutar. Ayırın ya da başka bir uzvu tahrik edin.</translation>
    </message>
    <message>
        <source>State %1 locks its drive, link %2: %3 hold it together. Release one of them, or drive another link.</source>
        <translation>%1 durumu tahrikini (%2 uzvu) kilitler: %3 onu birlikte tutar. Birini ayırın ya da başka bir uzvu tahrik edin.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: with the drive, link %3, held, link %4 still turns.</source>
        <translation>%1 durumu %2 serbestlik derecesi bırakır: tahrik (%3 uzvu) tutulunca %4 uzvu yine döner.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: with the drive, link %3, held, links %4 still turn.</source>
        <translation>%1 durumu %2 serbestlik derecesi bırakır: tahrik (%3 uzvu) tutulunca %4 uzuvları yine döner.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: link %3 still turns.</source>
        <translation>%1 durumu %2 serbestlik derecesi bırakır: %3 uzvu yine döner.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 degrees of freedom: links %3 still turn.</source>
        <translation>%1 durumu %2 serbestlik derecesi bırakır: %3 uzuvları yine döner.</translation>
    </message>
    <message>
        <source>Engage one more coupling that holds them.</source>
        <translation>Onları tutan bir elemanı daha devreye alın.</translation>
    </message>
    <message>
        <source>Engage %1 more couplings that hold them.</source>
        <translation>Onları tutan %1 elemanı daha devreye alın.</translation>
    </message>
    <message>
        <source>State %1: coupling %2 ties link %3 to the ground over axes of four directions or more.</source>
        <translation>%1 durumu: %2 elemanı %3 uzvunu dört ya da daha çok yönde eksenler üzerinden sabit uzva bağlar.</translation>
    </message>
    <message>
        <source>State %1: coupling %2 ties link %3 to link %4 over axes of four directions or more.</source>
        <translation>%1 durumu: %2 elemanı %3 uzvunu dört ya da daha çok yönde eksenler üzerinden %4 uzvuna bağlar.</translation>
    </message>
    <message>
        <source>Engaged coupling %1 ties link %2 to the ground over axes of four directions or more.</source>
        <translation>Devredeki %1 elemanı %2 uzvunu dört ya da daha çok yönde eksenler üzerinden sabit uzva bağlar.</translation>
    </message>
    <message>
        <source>Engaged coupling %1 ties link %2 to link %3 over axes of four directions or more.</source>
        <translation>Devredeki %1 elemanı %2 uzvunu dört ya da daha çok yönde eksenler üzerinden %3 uzvuna bağlar.</translation>
    </message>
    <message>
        <source>That is a linkage whose speeds depend on the pose: there is no ratio to state. Couple links that lie nearer to each other.</source>
        <translation>Bu, hızları konuma bağlı bir çubuk mekanizmasıdır: verilecek bir oran yoktur. Birbirine daha yakın uzuvları bağlayın.</translation>
    </message>
    <message>
        <source>State %1 has a ratio beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, give one that it can.</source>
        <translation>%1 durumunun oranı, analizin tutabildiği en büyük sayıyı, 1.79e308&apos;i aşıyor. Birbirine daha yakın diş sayıları ya da art arda daha az dişli çifti uygun bir oran verir.</translation>
    </message>
    <message>
        <source>Mesh %1 holds gears %2 and %3 on one axis (%4). Gears that mesh turn about two axes of one carrier: let one of them turn about another axis.</source>
        <translation>%1 dişli çiftinin %2 ve %3 dişlileri aynı eksendedir (%4). Eş çalışan dişliler bir taşıyıcının iki ekseni etrafında döner: birini başka bir eksende döndürün.</translation>
    </message>
    <message>
        <source>The path between the gears of mesh %1 runs over %2 axes (%3), and no carrier holds both of theirs: attach gear %4 to link %5.</source>
        <translation>%1 dişli çiftinin dişlileri arasındaki yol %2 eksenden (%3) geçer ve hiçbir taşıyıcı ikisinin eksenlerini birden taşımaz: %4 dişlisini %5 uzvuna bağlayın.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>hiç</translation>
    </message>
    <message>
        <source>one</source>
        <translation>bir</translation>
    </message>
    <message>
        <source>two</source>
        <translation>iki</translation>
    </message>
    <message>
        <source>three</source>
        <translation>üç</translation>
    </message>
    <message>
        <source>four</source>
        <translation>dört</translation>
    </message>
    <message>
        <source>five</source>
        <translation>beş</translation>
    </message>
    <message>
        <source>six</source>
        <translation>altı</translation>
    </message>
    <message>
        <source>seven</source>
        <translation>yedi</translation>
    </message>
    <message>
        <source>eight</source>
        <translation>sekiz</translation>
    </message>
    <message>
        <source>nine</source>
        <translation>dokuz</translation>
    </message>
    <message>
        <source>ten</source>
        <translation>on</translation>
    </message>
    <message>
        <source>eleven</source>
        <translation>on bir</translation>
    </message>
    <message>
        <source>twelve</source>
        <translation>on iki</translation>
    </message>
    <message>
        <source>Preview: %1. Click to keep it; leave it, or Esc, to go back</source>
        <translation>Önizleme: %1. Tıklarsanız kalır; ayrılırsanız ya da Esc ile geri döner</translation>
    </message>
    <message>
        <source>%1 (nearest axes)</source>
        <translation>%1 (en yakın eksenler)</translation>
    </message>
    <message>
        <source>relative to %1</source>
        <translation>%1 uzvuna göre</translation>
    </message>
    <message>
        <source>link %1 (%2)</source>
        <translation>%1 uzvu (%2)</translation>
    </message>
    <message>
        <source>%1 relative to %2</source>
        <translation>%2 uzvuna göre %1</translation>
    </message>
    <message>
        <source>joint %1 (%2)</source>
        <translation>%1 mafsalı (%2)</translation>
    </message>
    <message>
        <source>%1 = %2, inverse %3</source>
        <translation>%1 = %2, tersi %3</translation>
    </message>
    <message>
        <source>Speed of joint %1: link %2 relative to link %3</source>
        <translation>%1 mafsalının hızı: %3 uzvuna göre %2 uzvu</translation>
    </message>
    <message>
        <source>Speed of joint %1: how fast %2 turns relative to %3. Positive: about the direction of the axis, by the right-hand rule.</source>
        <translation>%1 mafsalının hızı: %2, %3 göre ne kadar hızlı döner. Pozitif: sağ el kuralına göre eksenin yönü etrafında.</translation>
    </message>
    <message>
        <source>Speed of joint %1, %2</source>
        <translation>%1 mafsalının hızı, %2</translation>
    </message>
    <message>
        <source>Speed of an output over that of the only input, and the inverse. Select a joint or a link to see its ratio.</source>
        <translation>Bir çıkışın hızının tek girişin hızına oranı ve tersi. Oranını görmek için bir mafsal ya da uzuv seçin.</translation>
    </message>
    <message>
        <source>Ratio %1</source>
        <translation>Oran %1</translation>
    </message>
    <message>
        <source>What speeds are relative to: joint by joint, or those of the links seen from one</source>
        <translation>Hızların neye göre verildiği: mafsal mafsal ya da bir uzuvdan görüldüğü gibi</translation>
    </message>
    <message>
        <source>Drive by a link’s joints ▾</source>
        <translation>Bir uzvun mafsallarıyla sür ▾</translation>
    </message>
    <message>
        <source>Make the joints that carry a link the inputs: their speeds are set, those of the motors become results</source>
        <translation>Bir uzvu taşıyan mafsalları giriş yapar: onların hızları verilir, motorlarınki sonuç olur</translation>
    </message>
    <message>
        <source>joint by joint</source>
        <translation>mafsal mafsal</translation>
    </message>
    <message>
        <source>relative to the ground</source>
        <translation>sabit uzva göre</translation>
    </message>
    <message>
        <source>Joint by joint: each link relative to the one that carries it</source>
        <translation>Mafsal mafsal: her uzuv, onu taşıyana göre</translation>
    </message>
    <message>
        <source>Relative to the ground</source>
        <translation>Sabit uzva göre</translation>
    </message>
    <message>
        <source>Relative to %1</source>
        <translation>Şuna göre: %1</translation>
    </message>
    <message>
        <source>Ratio to joint %1, %2</source>
        <translation>%1 mafsalına oran, %2</translation>
    </message>
    <message>
        <source>Joints of %1: %2</source>
        <translation>Mafsallar, %1: %2</translation>
    </message>
    <message>
        <source>tooth forces (on heads)</source>
        <translation>diş kuvvetleri (başlara)</translation>
    </message>
    <message>
        <source>bearing reactions (on heads)</source>
        <translation>yatak tepkileri (başlara)</translation>
    </message>
    <message>
        <source>mesh %1: %2</source>
        <translation>dişli çifti %1: %2</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>mafsal %1: %2</translation>
    </message>
    <message>
        <source>%1; X, Y or Z lays its axis along x, y or z</source>
        <translation>%1; X, Y ya da Z eksenini x, y ya da z boyunca yatırır</translation>
    </message>
    <message>
        <source>%1; its axis lies along %2</source>
        <translation>%1; ekseni %2 boyunca uzanır</translation>
    </message>
    <message>
        <source>No forces without loads: add one in Forces.</source>
        <translation>Yük olmadan kuvvet olmaz: Kuvvetler&apos;de bir yük ekleyin.</translation>
    </message>
    <message>
        <source>No forces: the loads are not in balance. Forces names what is missing.</source>
        <translation>Kuvvet yok: yükler dengede değil. Eksik olan Kuvvetler&apos;de yazıyor.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: forces at meshes %1. Choose Share by stiffness in Forces to find them.</source>
        <translation>Bilinmeyen oranlarda paylaşıldığı için çizilmedi: %1 dişli çiftlerindeki kuvvetler. Bulmak için Kuvvetler&apos;de “Rijitliğe göre paylaştır”ı seçin.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: reactions in joints %1. Choose Share by stiffness in Forces to find them.</source>
        <translation>Bilinmeyen oranlarda paylaşıldığı için çizilmedi: %1 mafsallarındaki tepkiler. Bulmak için Kuvvetler&apos;de “Rijitliğe göre paylaştır”ı seçin.</translation>
    </message>
    <message>
        <source>Not drawn, as shared in unknown parts: forces at meshes %1, reactions in joints %2. Choose Share by stiffness in Forces to find them.</source>
        <translation>Bilinmeyen oranlarda paylaşıldığı için çizilmedi: %1 dişli çiftlerindeki kuvvetler, %2 mafsallarındaki tepkiler. Bulmak için Kuvvetler&apos;de “Rijitliğe göre paylaştır”ı seçin.</translation>
    </message>
    <message>
        <source>The power taken over the power fed; backward and in symbols it is on the card Efficiency.</source>
        <translation>Alınan gücün verilen güce oranı; ters yönde ve simgelerle Verim kartındadır.</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Bırak</translation>
    </message>
    <message>
        <source>Release %1; the motion goes on</source>
        <translation>%1 ayrılır; hareket sürer</translation>
    </message>
    <message>
        <source>Find no torque here any more; without any such place the inputs hold the loads</source>
        <translation>Burada artık tork aranmaz; böyle bir yer kalmazsa yükleri girişler tutar</translation>
    </message>
    <message>
        <source>Remove balance</source>
        <translation>Dengeyi kaldır</translation>
    </message>
    <message>
        <source>The entry that speeds and torques share</source>
        <translation>Hızların ve torkların paylaştığı eleman</translation>
    </message>
    <message>
        <source>A row of P holds the speeds of a mesh, a column the torque in a joint: the framed entry is in both. Entries count teeth; μ is the force of a mesh for each tooth, ℓ what loads on links add. Select a joint or a mesh to see its own; click the framed entry to see it in Matrices.</source>
        <translation>P&apos;nin bir satırı bir dişli çiftinin hızlarını, bir sütunu bir mafsaldaki torku içerir: çerçeveli eleman ikisinde de vardır. Elemanlar diş sayısıdır; μ bir dişli çiftinin diş başına kuvveti, ℓ uzuvlardaki yüklerin katkısıdır. Kendi denklemlerini görmek için bir mafsal ya da dişli çifti seçin; çerçeveli elemana tıklamak onu Matrisler&apos;de gösterir.</translation>
    </message>
    <message>
        <source>; brake %1 is engaged</source>
        <translation>; %1 freni devrede</translation>
    </message>
    <message>
        <source>by an engaged brake</source>
        <translation>devredeki bir frenle</translation>
    </message>
    <message>
        <source>cut into the ground</source>
        <translation>sabit uzva açılmış</translation>
    </message>
    <message>
        <source>What &quot;held&quot; means: a link of its own with a brake that is engaged, so that you can release it; or no link of its own, its teeth are the ground&apos;s, as in the example &quot;Planetary train, ring held&quot;. The speeds are the same.</source>
        <translation>“Tutulan” ne demektir: devrede olan, bırakabileceğiniz bir freni olan ayrı bir uzuv; ya da ayrı bir uzuv yoktur, dişleri “Planetary train, ring held” örneğindeki gibi sabit uzvundur. Hızlar aynıdır.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Tutulan</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>Every matrix of the Matroid method. Rest the mouse on an entry to have it explained.</source>
        <translation>Matroid yönteminin tüm matrisleri. Açıklaması için fareyi bir öğenin üzerinde tutun.</translation>
    </message>
    <message>
        <source>What is wrong with the mechanism, and how to mend it.</source>
        <translation>Mekanizmada neyin yanlış olduğu ve nasıl düzeltileceği.</translation>
    </message>
    <message>
        <source>The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit.</source>
        <translation>Dişliler hareket halinde. Dişliyi sürüklemek takımı, boş yeri sürüklemek görünümü döndürür.</translation>
    </message>
    <message>
        <source>The speeds of the motors, and how fast every joint turns with them.</source>
        <translation>Motorların hızları ve her mafsalın onlarla ne kadar hızlı döndüğü.</translation>
    </message>
    <message>
        <source>Brakes and clutches, what is engaged, and the states of a gearbox.</source>
        <translation>Frenler ve kavramalar, neyin devrede olduğu ve bir şanzımanın durumları.</translation>
    </message>
    <message>
        <source>Teeth, axes and names of what is selected.</source>
        <translation>Seçili olanın dişleri, eksenleri ve adları.</translation>
    </message>
    <message>
        <source>Speeds over one period of the motion.</source>
        <translation>Hareketin bir periyodu boyunca hızlar.</translation>
    </message>
    <message>
        <source>Both methods worked out step by step for this mechanism.</source>
        <translation>Bu mekanizma için iki yöntem de adım adım.</translation>
    </message>
    <message>
        <source>Loads, and the torques, forces and powers that they cause.</source>
        <translation>Yükler ve yol açtıkları torklar, kuvvetler ve güçler.</translation>
    </message>
    <message>
        <source>Masses, the inertia at each motor, and the motion that torques cause.</source>
        <translation>Kütleler, her motordaki atalet ve torkların yol açtığı hareket.</translation>
    </message>
    <message>
        <source>A lesson: what is asked, your answer, hints, and the reason where it is wrong.</source>
        <translation>Bir ders: ne sorulduğu, yanıtınız, ipuçları ve yanlışsa nedeni.</translation>
    </message>
    <message>
        <source>The mechanism as a directed graph: links as circles, turning joints as solid arrows, gear meshes as dashed ones.</source>
        <translation>Yönlü graf olarak mekanizma: uzuvlar daire, döner mafsallar düz ok, dişli çiftleri kesikli ok.</translation>
    </message>
    <message>
        <source>The mechanism after Tsai and Tokad, with levels, chords and transfer vertices.</source>
        <translation>Tsai ve Tokad&apos;a göre mekanizma: düzeyler, kirişler ve aktarma düğümleri.</translation>
    </message>
    <message>
        <source>The mechanism in section, as in textbooks. You can draw here, too.</source>
        <translation>Ders kitaplarındaki gibi kesit olarak mekanizma. Burada da çizilebilir.</translation>
    </message>
    <message>
        <source>The mechanism drawn in three ways; a click on a tab chooses one.</source>
        <translation>Üç biçimde çizilmiş mekanizma; bir sekmeye tıklamak birini seçer.</translation>
    </message>
    <message>
        <source>Tools for drawing, undo and redo, the motion, and the search field.</source>
        <translation>Çizim araçları, geri al ve yinele, hareket ve arama alanı.</translation>
    </message>
    <message>
        <source>What has to be known about the file of this window.</source>
        <translation>Bu pencerenin dosyası hakkında bilinmesi gerekenler.</translation>
    </message>
    <message>
        <source>Begin a mechanism, or open a recent document or an example.</source>
        <translation>Bir mekanizmaya başlayın ya da son belgelerden veya örneklerden birini açın.</translation>
    </message>
    <message>
        <source>What the tool expects next, and the counts of the mechanism.</source>
        <translation>Aracın sırada ne beklediği ve mekanizmanın sayıları.</translation>
    </message>
</context>
</TS>

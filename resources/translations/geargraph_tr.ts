<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>GearGraph</name>
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
        <source>Select one link, and with Shift the joints and meshes that its new half should take.</source>
        <translation>Bir uzuv ve Shift ile yeni yarısının alacağı mafsalları ve dişli çiftlerini seçin.</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 bölünsün</translation>
    </message>
    <message>
        <source>Select the two links that should be one: click one, then the other with Shift.</source>
        <translation>Tek uzuv olacak iki uzvu seçin: birine, sonra Shift ile ötekine tıklayın.</translation>
    </message>
    <message>
        <source>Weld %1 and %2</source>
        <translation>%1 ile %2 kaynaklansın</translation>
    </message>
    <message>
        <source>Split it in two</source>
        <translation>İkiye böl</translation>
    </message>
    <message>
        <source>Weld %1 and %2 to one link</source>
        <translation>%1 ile %2 tek uzuv olsun</translation>
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
        <source>Map of the drawing</source>
        <translation>Çizimin haritası</translation>
    </message>
    <message>
        <source>All of the drawing: click or drag to move what is in sight</source>
        <translation>Çizimin tamamı: görünen yeri taşımak için tıklayın ya da sürükleyin</translation>
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
        <source>Fresh question %1</source>
        <translation>Yeni soru %1</translation>
    </message>
    <message>
        <source>%1 of %2 fresh questions right at the first check</source>
        <translation>%2 yeni sorudan %1 tanesi ilk denetimde doğru</translation>
    </message>
    <message>
        <source>You have mastered this lesson.</source>
        <translation>Bu dersi öğrendiniz.</translation>
    </message>
    <message>
        <source>Start again? All answers on this device are deleted.</source>
        <translation>Yeniden başlansın mı? Bu cihazdaki bütün yanıtlar silinir.</translation>
    </message>
    <message>
        <source>What you write stays in this browser.</source>
        <translation>Yazdıklarınız bu tarayıcıda kalır.</translation>
    </message>
    <message>
        <source>Answer to step %1</source>
        <translation>%1. adımın yanıtı</translation>
    </message>
    <message>
        <source>One drawing that is right</source>
        <translation>Doğru bir çizim</translation>
    </message>
    <message>
        <source>This is drawn in GearGraph: Learn &gt; Lessons. It gives no points here.</source>
        <translation>Bu, GearGraph&apos;ta çizilir: Öğren &gt; Dersler. Burada puan getirmez.</translation>
    </message>
    <message>
        <source>Two lessons have the id &quot;%1&quot;.</source>
        <translation>İki dersin kimliği &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>Where to begin</source>
        <translation>Nereden başlamalı</translation>
    </message>
    <message>
        <source>After the lesson “%1” you can answer this.</source>
        <translation>“%1” dersinden sonra bunu yanıtlayabilirsiniz.</translation>
    </message>
    <message>
        <source>You have mastered this lesson. Review it from %1 on.</source>
        <translation>Bu dersi öğrendiniz. %1 tarihinden başlayarak yineleyin.</translation>
    </message>
    <message>
        <source>%1 of %2 right at once</source>
        <translation>%2 sorudan %1 tanesi hemen doğru</translation>
    </message>
    <message>
        <source>Right at the first check, without a hint; one more is asked as long as some are missing</source>
        <translation>İlk denetimde, ipucusuz doğru; eksik kaldıkça bir soru daha sorulur</translation>
    </message>
    <message>
        <source>Fresh questions</source>
        <translation>Yeni sorular</translation>
    </message>
    <message>
        <source>Where do I begin?</source>
        <translation>Nereden başlayayım?</translation>
    </message>
    <message>
        <source>A question about each lesson in turn: it ends with the second one that is not right at the first check, and chooses the lesson of the first</source>
        <translation>Sırayla her ders için bir soru: ilk denetimde doğru olmayan ikinci soruyla biter ve ilkinin dersini seçer</translation>
    </message>
    <message>
        <source>review due</source>
        <translation>yineleme zamanı</translation>
    </message>
    <message>
        <source>questions left</source>
        <translation>soru kaldı</translation>
    </message>
    <message>
        <source>After the start test: begin with “%1”.</source>
        <translation>Başlangıç sınavına göre: “%1” ile başlayın.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Yinele</translation>
    </message>
    <message>
        <source>Start test</source>
        <translation>Başlangıç sınavı</translation>
    </message>
    <message numerus="yes">
        <source>%n to review.</source>
        <translation>
            <numerusform>%n ders yinelenecek.</numerusform>
        </translation>
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
        <source>Copied %1</source>
        <translation>%1 kopyalandı</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 uzuv</translation>
    </message>
    <message>
        <source>1 mesh</source>
        <translation>1 dişli çifti</translation>
    </message>
    <message>
        <source>%1 joints</source>
        <translation>%1 mafsal</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 mafsal</translation>
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
        <source>Open an example…</source>
        <translation>Bir örnek aç…</translation>
    </message>
    <message>
        <source>All sets: belts, wrists, strain wave, cycloidal and RV reducers, too</source>
        <translation>Tüm takımlar: kayış, bilek, dalga, sikloid ve RV redüktörleri de</translation>
    </message>
    <message>
        <source>More sets…</source>
        <translation>Diğer takımlar…</translation>
    </message>
    <message>
        <source>Choose teeth and ratio, and insert it: %1</source>
        <translation>Dişleri ve oranı seçin, ekleyin: %1</translation>
    </message>
    <message>
        <source>Draw links and joints by hand: the tool Link, then click on the sheet</source>
        <translation>Uzuvları ve mafsalları elle çizin: Uzuv aracı, sonra sayfaya tıklayın</translation>
    </message>
    <message>
        <source>Draw, or insert a set</source>
        <translation>Çizin ya da bir takım ekleyin</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Başla</translation>
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
        <source>Print and text</source>
        <translation>Baskı ve metin</translation>
    </message>
    <message>
        <source>CAD and making</source>
        <translation>CAD ve üretim</translation>
    </message>
    <message>
        <source>Simulators and control</source>
        <translation>Benzetim ve kontrol</translation>
    </message>
    <message>
        <source>Web and class</source>
        <translation>Web ve sınıf</translation>
    </message>
    <message>
        <source>Data and graphs</source>
        <translation>Veri ve graflar</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Adım %1</translation>
    </message>
    <message>
        <source>of the link between</source>
        <translation>uzuv uzvun arasında</translation>
    </message>
    <message>
        <source>to and against</source>
        <translation>ile ve göre</translation>
    </message>
    <message>
        <source>A ratio holds the answer: it is told when the step is right or shown.</source>
        <translation>Oran yanıtı içerir: adım doğru ya da gösterilmiş olunca söylenir.</translation>
    </message>
    <message>
        <source>Enter selects both.</source>
        <translation>Enter ikisini de seçer.</translation>
    </message>
    <message>
        <source>Exactly, in every motion: %1 turns %3 times as fast as %2, the other way round.</source>
        <translation>Tam olarak, her harekette: %1, %2 ile karşılaştırıldığında %3 katı hızla, ters yönde döner.</translation>
    </message>
    <message>
        <source>Exactly, in every motion: %1 turns %3 times as fast as %2, the same way round.</source>
        <translation>Tam olarak, her harekette: %1, %2 ile karşılaştırıldığında %3 katı hızla, aynı yönde döner.</translation>
    </message>
    <message>
        <source>With the speeds that the inputs have now: with others it is another.</source>
        <translation>Girişlerin şimdiki hızlarıyla: başka hızlarla başka olur.</translation>
    </message>
    <message>
        <source>There is no ratio to %1, which stands still.</source>
        <translation>%1 durduğundan ona göre oran yoktur.</translation>
    </message>
    <message>
        <source>They turn about axes that are not parallel, or about several at once: the results have their speeds about each axis.</source>
        <translation>Paralel olmayan eksenler ya da aynı anda birkaç eksen çevresinde dönerler: sonuçlarda her eksen çevresindeki hızları vardır.</translation>
    </message>
    <message>
        <source>There is no exact solution now: Problems says what is missing.</source>
        <translation>Şimdi tam çözüm yok: Sorunlar neyin eksik olduğunu söyler.</translation>
    </message>
    <message>
        <source>Hold %1 with a brake</source>
        <translation>%1 frenle tutulsun</translation>
    </message>
    <message>
        <source>Release the brake of %1</source>
        <translation>%1 freni ayrılsın</translation>
    </message>
    <message>
        <source>Its brake is engaged already.</source>
        <translation>Freni zaten devrede.</translation>
    </message>
    <message>
        <source>No brake holds it.</source>
        <translation>Hiçbir fren onu tutmuyor.</translation>
    </message>
    <message>
        <source>Changes the document; one step back (Ctrl+Z) undoes it.</source>
        <translation>Belgeyi değiştirir; bir adım geri (Ctrl+Z) onu geri alır.</translation>
    </message>
    <message>
        <source>Mesh %1: %2 teeth on link %3, %4 on link %5</source>
        <translation>Çift %1: uzuv %3 üzerinde %2 diş, uzuv %5 üzerinde %4</translation>
    </message>
    <message>
        <source>now %1 : %2</source>
        <translation>şimdi %1 : %2</translation>
    </message>
    <message>
        <source>It has these teeth already.</source>
        <translation>Zaten bu dişleri var.</translation>
    </message>
    <message>
        <source>ratio i</source>
        <translation>oran i</translation>
    </message>
    <message>
        <source>hold brake fix</source>
        <translation>tut frenle sabitle</translation>
    </message>
    <message>
        <source>release free</source>
        <translation>ayır bırak</translation>
    </message>
    <message>
        <source>teeth z</source>
        <translation>diş dişler z</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>yanıt</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>değişiklik</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>Dı&amp;şa aktar…</translation>
    </message>
    <message>
        <source>Export graphs, matrices, derivations, drawings, pictures, solids and models for other programs, with all their options, and see first what will be written</source>
        <translation>Grafları, matrisleri, türetmeleri, çizimleri, resimleri, katıları ve başka programlar için modelleri bütün seçenekleriyle dışa aktar; ne yazılacağını önceden gör</translation>
    </message>
    <message>
        <source>Export &amp;matrix as CSV…</source>
        <translation>&amp;Matrisi CSV olarak dışa aktar…</translation>
    </message>
    <message>
        <source>All panels back to their places, in this window and in those to come</source>
        <translation>Bütün paneller yerlerine, bu pencerede ve sonrakilerde</translation>
    </message>
    <message>
        <source>&amp;Handout for the class</source>
        <translation>&amp;Sınıf için ders notu</translation>
    </message>
    <message>
        <source>Writes a page for any browser beside the document, at once: drawings, matrices, derivation and the train in 3D, with inputs that move</source>
        <translation>Belgenin yanına hemen her tarayıcı için bir sayfa yazar: çizimler, matrisler, türetim ve 3B dişli takımı, hareket eden girişlerle</translation>
    </message>
    <message>
        <source>mechanism</source>
        <translation>mekanizma</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Ne için?</translation>
    </message>
    <message>
        <source>Sets all options of this format back to what holds without them</source>
        <translation>Bu biçimin bütün seçeneklerini onlarsız geçerli olana döndürür</translation>
    </message>
    <message>
        <source>Asks where, and writes it</source>
        <translation>Nereye olduğunu sorar ve yazar</translation>
    </message>
    <message>
        <source>%1 (a folder with %2 files, %3)</source>
        <translation>%1 (%2 dosyalı klasör, %3)</translation>
    </message>
    <message>
        <source>Exported %1 into %2.</source>
        <translation>%1, %2 içine aktarıldı.</translation>
    </message>
    <message>
        <source>Opens it with the program of this kind of file</source>
        <translation>Bu tür dosyanın programıyla açar</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Klasörde göster</translation>
    </message>
    <message>
        <source>Opens the folder it is in</source>
        <translation>Bulunduğu klasörü açar</translation>
    </message>
    <message>
        <source>The file stays where it is</source>
        <translation>Dosya olduğu yerde kalır</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 artık yok.</translation>
    </message>
    <message>
        <source>No program opens %1 here.</source>
        <translation>Burada %1 dosyasını açan program yok.</translation>
    </message>
    <message>
        <source>Show what would be written</source>
        <translation>Ne yazılacağını göster</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Working out what would be written…</source>
        <translation>Ne yazılacağı bulunuyor…</translation>
    </message>
    <message>
        <source>Makes the files without keeping them: with a train as large as this it takes a while</source>
        <translation>Dosyaları saklamadan yapar: bu kadar büyük bir dişli takımında biraz sürer</translation>
    </message>
    <message>
        <source>Files that would be written</source>
        <translation>Yazılacak dosyalar</translation>
    </message>
    <message>
        <source>Beginning of the file</source>
        <translation>Dosyanın başı</translation>
    </message>
    <message>
        <source>Picture of what would be written</source>
        <translation>Yazılacak olanın resmi</translation>
    </message>
    <message>
        <source>Working out what would be written: %1 %</source>
        <translation>Ne yazılacağı bulunuyor: %1 %</translation>
    </message>
    <message>
        <source>Made with all its pictures when it is exported. This is one of them.</source>
        <translation>Dışa aktarınca bütün resimler yapılır. Bu onlardan biridir.</translation>
    </message>
    <message>
        <source>A folder with %1 files, %2</source>
        <translation>%1 dosyalı klasör, %2</translation>
    </message>
    <message>
        <source>%1 files, %2</source>
        <translation>%1 dosya, %2</translation>
    </message>
    <message>
        <source>A file for programs: nothing of it is read by people.</source>
        <translation>Programlar için bir dosya: insanlar ondan bir şey okumaz.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Bir da&amp;ha dışa aktar</translation>
    </message>
    <message>
        <source>Writes %1 again, with the same options</source>
        <translation>%1 dosyasını aynı seçeneklerle yeniden yazar</translation>
    </message>
    <message>
        <source>This document has not been exported yet</source>
        <translation>Bu belge henüz dışa aktarılmadı</translation>
    </message>
    <message>
        <source>Exports of this document by File &gt; Export are listed here</source>
        <translation>Bu belgenin Dosya &gt; Dışa aktar ile yapılan aktarımları burada listelenir</translation>
    </message>
    <message>
        <source>The folder %1 could not be made.</source>
        <translation>%1 klasörü oluşturulamadı.</translation>
    </message>
    <message>
        <source>GearGraph: keyboard shortcuts</source>
        <translation>GearGraph: klavye kısayolları</translation>
    </message>
    <message>
        <source>On one page, also into a PDF file</source>
        <translation>Bir sayfada, PDF dosyasına da</translation>
    </message>
    <message>
        <source>The two methods differ at one joint. Please report this document.</source>
        <translation>İki yöntem bir mafsalda farklı. Lütfen bu belgeyi bildirin.</translation>
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
        <source>A new link takes the selected joints and meshes of the selected link, or the side of the train that was drawn last; both turn about one axis</source>
        <translation>Yeni bir uzuv, seçili uzvun seçili mafsallarını ve dişli çiftlerini ya da takımın en son çizilen yanını alır; ikisi aynı eksende döner</translation>
    </message>
    <message>
        <source>Sp&amp;lit the link</source>
        <translation>&amp;Uzvu böl</translation>
    </message>
    <message>
        <source>The two selected links become one, which two gear sets then share; axes on one carrier become one line</source>
        <translation>Seçili iki uzuv tek uzuv olur ve iki dişli takımı onu paylaşır; aynı taşıyıcıdaki eksenler tek doğru olur</translation>
    </message>
    <message>
        <source>&amp;Weld links</source>
        <translation>Uzuvları kay&amp;nakla</translation>
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
        <source>A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist, a worm or belt stage, a strain wave, cycloidal or RV reducer</source>
        <translation>Tam bir planet, Ravigneaux ya da Simpson takımı, diferansiyel, geri dönüşlü takım, bilek, sonsuz vida ya da kayış kademesi, dalga, sikloid ya da RV redüktör</translation>
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
        <source>Names of links and tooth counts beside their numbers, where there is room; lessons and presentations have them on</source>
        <translation>Yer olan yerde numaraların yanında uzuv adları ve diş sayıları; derslerde ve sunumlarda açıktır</translation>
    </message>
    <message>
        <source>N&amp;ames and teeth</source>
        <translation>&amp;Adlar ve diş sayıları</translation>
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
        <source>The start page with titles, pictures and a sentence about each example</source>
        <translation>Her örneğin adı, resmi ve bir cümlesiyle başlangıç sayfası</translation>
    </message>
    <message>
        <source>With pictures…</source>
        <translation>Resimlerle…</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robotlar</translation>
    </message>
    <message>
        <source>Gear trains</source>
        <translation>Dişli takımları</translation>
    </message>
    <message>
        <source>Clocks</source>
        <translation>Saatler</translation>
    </message>
    <message>
        <source>Gearboxes</source>
        <translation>Vites kutuları</translation>
    </message>
    <message>
        <source>Not as they should be</source>
        <translation>Olması gerektiği gibi olmayanlar</translation>
    </message>
    <message>
        <source>Kinds of examples</source>
        <translation>Örnek türleri</translation>
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
        <source>Type a number such as 12, 0.5, 22/7 or 2*3, or a length such as 1/2 in.</source>
        <translation>12, 0,5, 22/7 veya 2*3 gibi bir sayı ya da 1/2 in gibi bir uzunluk yazın.</translation>
    </message>
    <message>
        <source>Type a number such as 12, 0.5, 22/7 or 2*3.</source>
        <translation>12, 0,5, 22/7 veya 2*3 gibi bir sayı yazın.</translation>
    </message>
    <message>
        <source>Type an angle such as 30, 2*15, 0.5 rad or 1/4 turns.</source>
        <translation>30, 2*15, 0.5 rad veya 1/4 turns gibi bir açı yazın.</translation>
    </message>
    <message>
        <source>Type a speed such as 12, 2*3, 90 deg/s or 1500 rpm.</source>
        <translation>12, 2*3, 90 deg/s veya 1500 rpm gibi bir hız yazın.</translation>
    </message>
    <message>
        <source>Type a torque such as 12, 2*3, 5 N cm, 3 lbf ft or 2 kW @ 1500 rpm.</source>
        <translation>12, 2*3, 5 N cm, 3 lbf ft veya 2 kW @ 1500 rpm gibi bir tork yazın.</translation>
    </message>
    <message>
        <source>Type a force such as 12, 2*3 or 5 kN.</source>
        <translation>12, 2*3 veya 5 kN gibi bir kuvvet yazın.</translation>
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
        <translation>Matroid = T–T grafı, tam olarak</translation>
    </message>
    <message>
        <source>Matroid method = T–T graph method, exactly, for all %1 joints</source>
        <translation>Matroid = T–T grafı, %1 mafsalın hepsi için tam olarak</translation>
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
        <source>The language can be changed when the file has been read.</source>
        <translation>Dil, dosya okunduktan sonra değiştirilebilir.</translation>
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
        <source>Links %1 are equal planets, which share the load: the motion would be the same without %2.</source>
        <translation>%1 uzuvları yükü paylaşan eş gezegenlerdir: %2 olmadan da hareket aynı olurdu.</translation>
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
        <source>Clutch %1 couples links %2 and %3, which do not turn about one axis against each other: their axes are not one line. Couple links on one axis, or a planet and its carrier.</source>
        <translation>%1 kavraması, birbirine göre tek bir eksen etrafında dönmeyen %2 ve %3 uzuvlarını bağlıyor: eksenleri tek bir doğru değil. Aynı eksendeki uzuvları ya da bir gezegeni taşıyıcısıyla bağlayın.</translation>
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
        <source>Speed of the only input over that of an output. Select a joint or a link to see its ratio.</source>
        <translation>Tek girişin hızının bir çıkışın hızına oranı. Oranını görmek için bir mafsal ya da uzuv seçin.</translation>
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
    <message>
        <source>One file is needed.</source>
        <translation>Bir dosya gerekli.</translation>
    </message>
    <message>
        <source>Give --symbolic or --no-symbolic.</source>
        <translation>--symbolic ya da --no-symbolic verin.</translation>
    </message>
    <message>
        <source>the analysis</source>
        <translation>çözümleme</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>Standart çıktıya yazılamadı.</translation>
    </message>
    <message>
        <source>drive these joints (by label) instead of the document&apos;s</source>
        <translation>belgedekiler yerine bu mafsalları (etiketiyle) tahrik et</translation>
    </message>
    <message>
        <source>the speed of an input in rad/s; may be repeated</source>
        <translation>bir girişin rad/s cinsinden hızı; yinelenebilir</translation>
    </message>
    <message>
        <source>with the solution in gear ratios (the default)</source>
        <translation>dişli oranlarıyla çözümle birlikte (varsayılan)</translation>
    </message>
    <message>
        <source>without it</source>
        <translation>onsuz</translation>
    </message>
    <message>
        <source>as JSON</source>
        <translation>JSON olarak</translation>
    </message>
    <message>
        <source>with --json: all entries of matrices, also above 250,000 (else triplets)</source>
        <translation>--json ile: 250.000&apos;den fazla olsa da matrislerin bütün öğeleri (yoksa üçlüler)</translation>
    </message>
    <message>
        <source>Analyses a mechanism, for people or as JSON.</source>
        <translation>Bir mekanizmayı çözümler, insanlar için ya da JSON olarak.</translation>
    </message>
    <message>
        <source>Untitled mechanism</source>
        <translation>Adsız mekanizma</translation>
    </message>
    <message>
        <source>%1 moving link</source>
        <translation>%1 hareketli uzuv</translation>
    </message>
    <message>
        <source>%1 moving links</source>
        <translation>%1 hareketli uzuv</translation>
    </message>
    <message>
        <source>%1 turning joint</source>
        <translation>%1 döner mafsal</translation>
    </message>
    <message>
        <source>%1 gear mesh</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>teeth %1 : %2</source>
        <translation>diş %1 : %2</translation>
    </message>
    <message>
        <source>Eq. (%1)</source>
        <translation>Denk. (%1)</translation>
    </message>
    <message>
        <source>%1 row</source>
        <translation>%1 satır</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 satır</translation>
    </message>
    <message>
        <source>%1 column</source>
        <translation>%1 sütun</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>%1 sütun</translation>
    </message>
    <message>
        <source>%1: too large to print; see &quot;export --to csv --matrix %2&quot;</source>
        <translation>%1: basılamayacak kadar büyük; bkz. &quot;export --to csv --matrix %2&quot;</translation>
    </message>
    <message>
        <source>The option %1 takes no value.</source>
        <translation>%1 seçeneği değer almaz.</translation>
    </message>
    <message>
        <source>The option %1 needs a value: %1 %2.</source>
        <translation>%1 seçeneği bir değer ister: %1 %2.</translation>
    </message>
    <message>
        <source>The options cannot be read.</source>
        <translation>Seçenekler okunamıyor.</translation>
    </message>
    <message>
        <source>There is no option &quot;%1&quot; here.</source>
        <translation>Burada &quot;%1&quot; diye bir seçenek yok.</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>satır %1</translation>
    </message>
    <message>
        <source>rows %1</source>
        <translation>satır %1</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>sütun %1</translation>
    </message>
    <message>
        <source>columns %1</source>
        <translation>sütun %1</translation>
    </message>
    <message>
        <source>There is no matrix &quot;%1&quot;: %2.</source>
        <translation>&quot;%1&quot; diye bir matris yok: %2.</translation>
    </message>
    <message>
        <source>A mechanism and a file with a matrix or equations are needed.</source>
        <translation>Bir mekanizma ve içinde matris ya da denklemler olan bir dosya gerekli.</translation>
    </message>
    <message>
        <source>the check</source>
        <translation>denetim</translation>
    </message>
    <message>
        <source>Compares a matrix or equations of yours with the derived ones; status 1 where they differ.</source>
        <translation>Sizin bir matrisinizi ya da denklemlerinizi türetilenlerle karşılaştırır; farklıysa durum 1.</translation>
    </message>
    <message>
        <source>Usage: geargraph-cli %1 %2</source>
        <translation>Kullanım: geargraph-cli %1 %2</translation>
    </message>
    <message>
        <source>More: geargraph-cli %1 --help</source>
        <translation>Daha fazlası: geargraph-cli %1 --help</translation>
    </message>
    <message>
        <source>Not in the table: %1.</source>
        <translation>Tabloda yok: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a table or a graph, not a document. Convert it first: geargraph-cli convert %1 --to geargraph -o %2</source>
        <translation>&quot;%1&quot; bir tablo ya da graf, belge değil. Önce dönüştürün: geargraph-cli convert %1 --to geargraph -o %2</translation>
    </message>
    <message>
        <source>Not in the graph: %1.</source>
        <translation>Grafta yok: %1.</translation>
    </message>
    <message>
        <source>--to is one of csv, geargraph, dot, graphml, node-link.</source>
        <translation>--to şunlardan biridir: csv, geargraph, dot, graphml, node-link.</translation>
    </message>
    <message>
        <source>--separator is one of comma, semicolon, tab.</source>
        <translation>--separator şunlardan biridir: comma, semicolon, tab.</translation>
    </message>
    <message>
        <source>%1 has no meaning with %2; it is an option of %3.</source>
        <translation>%1 seçeneğinin %2 ile anlamı yok; %3 seçeneğidir.</translation>
    </message>
    <message>
        <source>the conversion</source>
        <translation>dönüştürme</translation>
    </message>
    <message>
        <source>csv: a table with a row for each link, axis, turning joint, gear mesh, ...; geargraph: a document; dot, graphml, node-link: the digraph; each is read back, graphs of other programs, too, where edges have kind, axis and tooth counts</source>
        <translation>csv: her uzuv, eksen, döner mafsal, dişli çifti, ... için bir satırı olan tablo; geargraph: belge; dot, graphml, node-link: yönlü graf; hepsi geri okunur, kenarların türü, ekseni ve diş sayıları varsa başka programların grafları da</translation>
    </message>
    <message>
        <source>the file (standard output)</source>
        <translation>dosya (standart çıktı)</translation>
    </message>
    <message>
        <source>of a table that is written (comma); reading recognises it</source>
        <translation>yazılan tablonun (comma); okurken tanınır</translation>
    </message>
    <message>
        <source>begin a table with a byte order mark, for spreadsheet programs</source>
        <translation>tabloya bayt sırası işaretiyle başla, hesap tablosu programları için</translation>
    </message>
    <message>
        <source>Converts documents to tables (CSV) and graphs, and back; FILE is any of them.</source>
        <translation>Belgeleri tablolara (CSV) ve graflara çevirir, ve geri; FILE bunlardan biridir.</translation>
    </message>
    <message>
        <source>motion not checked: nothing moves, the mechanism has errors, or it has more than %1 links</source>
        <translation>hareket denetlenmedi: hiçbir şey hareket etmiyor, mekanizmada hata var ya da %1 uzuvdan fazla</translation>
    </message>
    <message>
        <source>motion checked in part only: too many parts come close to each other</source>
        <translation>hareket yalnız kısmen denetlendi: çok fazla parça birbirine yaklaşıyor</translation>
    </message>
    <message>
        <source>motion checked: the distance of no two parts changes, so that nothing can collide</source>
        <translation>hareket denetlendi: hiçbir iki parçanın arasındaki uzaklık değişmiyor, yani hiçbir şey çarpışamaz</translation>
    </message>
    <message>
        <source>motion checked from %1 to %2; it does not repeat sooner</source>
        <translation>hareket %1 ile %2 arasında denetlendi; daha önce yinelenmiyor</translation>
    </message>
    <message>
        <source>motion checked from %1 to %2, between the limits of the joints</source>
        <translation>hareket %1 ile %2 arasında, mafsalların sınırları içinde denetlendi</translation>
    </message>
    <message>
        <source>motion checked for %1, until the motion of every two links repeats</source>
        <translation>hareket %1 boyunca, her iki uzvun hareketi yinelenene kadar denetlendi</translation>
    </message>
    <message>
        <source>%1 names an input and its number, like %2, not &quot;%3&quot;.</source>
        <translation>%1, %2 gibi bir giriş ve sayısını verir, &quot;%3&quot; değil.</translation>
    </message>
    <message>
        <source>Joint %1 is not an input; see --inputs.</source>
        <translation>%1 mafsalı giriş değil; bkz. --inputs.</translation>
    </message>
    <message>
        <source>--damping is at least 0, in N m s.</source>
        <translation>--damping en az 0&apos;dır, N m s cinsinden.</translation>
    </message>
    <message>
        <source>--seconds over --interval are at most a million samples.</source>
        <translation>--seconds bölü --interval en çok bir milyon örnektir.</translation>
    </message>
    <message>
        <source>Dynamics is computed for up to %1 entries of the solution (inputs times other joints).</source>
        <translation>Dinamik, çözümün en çok %1 öğesi için hesaplanır (girişler çarpı öteki mafsallar).</translation>
    </message>
    <message>
        <source>the gear train</source>
        <translation>dişli takımı</translation>
    </message>
    <message>
        <source>the masses</source>
        <translation>kütleler</translation>
    </message>
    <message>
        <source>the motion</source>
        <translation>hareket</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: there is no motion to write.</source>
        <translation>Girişlerin bir hareketi hiçbir kütleyi hareket ettirmiyor: yazılacak hareket yok.</translation>
    </message>
    <message>
        <source>the torque of an input&apos;s motor (without it 0); may be given again</source>
        <translation>bir girişin motor torku (yoksa 0); yeniden verilebilir</translation>
    </message>
    <message>
        <source>less this for each rad/s, N m s; may be given again</source>
        <translation>her rad/s için bu kadar az, N m s; yeniden verilebilir</translation>
    </message>
    <message>
        <source>the angle of an input at the start; may be given again</source>
        <translation>başlangıçta bir girişin açısı; yeniden verilebilir</translation>
    </message>
    <message>
        <source>its speed at the start, rad/s or with a unit (without it 0); may be given again</source>
        <translation>başlangıçtaki hızı, rad/s veya birimiyle (yoksa 0); yeniden verilebilir</translation>
    </message>
    <message>
        <source>follow the motion for so long</source>
        <translation>hareketi bu süre izle</translation>
    </message>
    <message>
        <source>seconds between samples (without it a hundredth of the motion)</source>
        <translation>örnekler arası saniye (yoksa hareketin yüzde biri)</translation>
    </message>
    <message>
        <source>write the samples of the motion as CSV</source>
        <translation>hareketin örneklerini CSV olarak yaz</translation>
    </message>
    <message>
        <source>Masses, the inertia that motors feel, and the motion that torques cause.</source>
        <translation>Kütleler, motorların gördüğü atalet ve torkların yarattığı hareket.</translation>
    </message>
    <message>
        <source>angle, rad</source>
        <translation>açı, rad</translation>
    </message>
    <message>
        <source>speed, rad/s</source>
        <translation>hız, rad/s</translation>
    </message>
    <message>
        <source>Motion, after %1 s</source>
        <translation>Hareket, %1 s sonra</translation>
    </message>
    <message>
        <source>kinetic energy %1 J, potential %2 J, work of motors and loads %3 J</source>
        <translation>kinetik enerji %1 J, potansiyel %2 J, motorların ve yüklerin işi %3 J</translation>
    </message>
    <message>
        <source>mass, kg</source>
        <translation>kütle, kg</translation>
    </message>
    <message>
        <source>at motor %1, kg m²</source>
        <translation>%1 motorunda, kg m²</translation>
    </message>
    <message>
        <source>inertia, kg m²</source>
        <translation>atalet, kg m²</translation>
    </message>
    <message>
        <source>holding torque, N m</source>
        <translation>tutma torku, N m</translation>
    </message>
    <message>
        <source>acceleration, rad/s²</source>
        <translation>ivme, rad/s²</translation>
    </message>
    <message>
        <source>Links, and the inertia that each has at the motors</source>
        <translation>Uzuvlar ve her birinin motorlardaki ataleti</translation>
    </message>
    <message>
        <source>Inputs, at the start</source>
        <translation>Girişler, başlangıçta</translation>
    </message>
    <message>
        <source>Generalised inertia M, kg m²</source>
        <translation>Genelleştirilmiş atalet M, kg m²</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;. The document has no states.</source>
        <translation>&quot;%1&quot; durumu yok. Belgede durum yok.</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;. States: %2.</source>
        <translation>&quot;%1&quot; durumu yok. Durumlar: %2.</translation>
    </message>
    <message>
        <source>There is no coupling &quot;%1&quot;. The document has no couplings.</source>
        <translation>&quot;%1&quot; adlı fren veya kavrama yok. Belgede hiç yok.</translation>
    </message>
    <message>
        <source>There is no coupling &quot;%1&quot;. Couplings: %2.</source>
        <translation>&quot;%1&quot; adlı fren veya kavrama yok. Olanlar: %2.</translation>
    </message>
    <message>
        <source>Give --state NAME or --engage A,B.</source>
        <translation>--state NAME ya da --engage A,B verin.</translation>
    </message>
    <message>
        <source>%1 (state %2)</source>
        <translation>%1 (durum %2)</translation>
    </message>
    <message>
        <source>with the couplings of this state engaged</source>
        <translation>bu durumun frenleri ve kavramaları devrede</translation>
    </message>
    <message>
        <source>with these couplings engaged, &quot;none&quot; for no coupling, instead of those that the document engages</source>
        <translation>belgenin devreye aldıkları yerine bunlar devrede, hiçbiri için &quot;none&quot;</translation>
    </message>
    <message>
        <source>There is no kind of question &quot;%1&quot;; geargraph-cli exercises kinds FILE lists them.</source>
        <translation>&quot;%1&quot; diye bir soru türü yok; geargraph-cli exercises kinds FILE listeler.</translation>
    </message>
    <message>
        <source>The mechanism gives no question &quot;%1&quot;: %2.</source>
        <translation>Mekanizma &quot;%1&quot; sorusunu vermiyor: %2.</translation>
    </message>
    <message>
        <source>--kinds names 1 to 100 questions.</source>
        <translation>--kinds 1 ile 100 arası soru adlandırır.</translation>
    </message>
    <message>
        <source>--seed is a whole number from 0 on.</source>
        <translation>--seed 0 veya daha büyük bir tam sayıdır.</translation>
    </message>
    <message>
        <source>--variants is a whole number from 1 to 1000.</source>
        <translation>--variants 1 ile 1000 arasında bir tam sayıdır.</translation>
    </message>
    <message>
        <source>The first word is kinds, make or grade.</source>
        <translation>İlk sözcük kinds, make veya grade olur.</translation>
    </message>
    <message>
        <source>%1 has no meaning for exercises %2.</source>
        <translation>%1 seçeneğinin exercises %2 için anlamı yok.</translation>
    </message>
    <message>
        <source>kinds of questions, with commas; a kind may occur again (all)</source>
        <translation>virgülle ayrılmış soru türleri; bir tür yinelenebilir (hepsi)</translation>
    </message>
    <message>
        <source>how many different sheets, at most 1,000 (1)</source>
        <translation>kaç ayrı sayfa, en çok 1.000 (1)</translation>
    </message>
    <message>
        <source>a variant for each line of this text file</source>
        <translation>bu metin dosyasının her satırı için bir seçenek</translation>
    </message>
    <message>
        <source>the heading of the sheets (&quot;Exercises&quot;)</source>
        <translation>sayfaların başlığı (&quot;Exercises&quot;)</translation>
    </message>
    <message>
        <source>overwrites files in the folder</source>
        <translation>klasördeki dosyaların üzerine yazar</translation>
    </message>
    <message>
        <source>make: the folder; grade: the CSV file (standard output)</source>
        <translation>make: klasör; grade: CSV dosyası (standart çıktı)</translation>
    </message>
    <message>
        <source>Makes exercise sheets from a mechanism and grades the answers.</source>
        <translation>Bir mekanizmadan alıştırma sayfaları yapar ve yanıtları notlar.</translation>
    </message>
    <message>
        <source>(not offered: %1)</source>
        <translation>(sunulmuyor: %1)</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be read: %2.</source>
        <translation>&quot;%1&quot; klasörü okunamadı: %2.</translation>
    </message>
    <message>
        <source>These are answers to another sheet.</source>
        <translation>Bunlar başka bir sayfanın yanıtları.</translation>
    </message>
    <message>
        <source>The sheet has no variant %1.</source>
        <translation>Sayfanın %1. seçeneği yok.</translation>
    </message>
    <message>
        <source>Question %1 has no such field as some that are answered.</source>
        <translation>%1. soruda, yanıtlananlardan bazıları gibi bir alan yok.</translation>
    </message>
    <message>
        <source>The question is not answered.</source>
        <translation>Soru yanıtlanmamış.</translation>
    </message>
    <message>
        <source>The sheet has no question %1.</source>
        <translation>Sayfanın %1. sorusu yok.</translation>
    </message>
    <message>
        <source>grade needs a sheet and answers.</source>
        <translation>grade bir sayfa ve yanıtlar ister.</translation>
    </message>
    <message>
        <source>the grading</source>
        <translation>notlama</translation>
    </message>
    <message>
        <source>Give --variants or --names: a name is a variant.</source>
        <translation>--variants ya da --names verin: bir ad bir seçenektir.</translation>
    </message>
    <message>
        <source>--names is a text file of 1 to 1000 lines.</source>
        <translation>--names 1 ile 1000 satırlık bir metin dosyasıdır.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; nothing was written (--force overwrites).</source>
        <translation>&quot;%1&quot; zaten var; hiçbir şey yazılmadı (--force üzerine yazar).</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>%1. seçenek</translation>
    </message>
    <message>
        <source>make needs one file.</source>
        <translation>make bir dosya ister.</translation>
    </message>
    <message>
        <source>make needs a folder: -o FOLDER.</source>
        <translation>make bir klasör ister: -o FOLDER.</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism; no sheet was written.</source>
        <translation>Bu mekanizma hakkında sorulacak bir şey yok; sayfa yazılmadı.</translation>
    </message>
    <message>
        <source>Drawings and 3D pictures (--to svg, pdf or png --view NAME)</source>
        <translation>Çizimler ve 3B resimler (--to svg, pdf veya png --view NAME)</translation>
    </message>
    <message>
        <source>3D pictures (--to png --view 3d)</source>
        <translation>3B resimler (--to png --view 3d)</translation>
    </message>
    <message>
        <source>Animations (--to png --view 3d)</source>
        <translation>Canlandırmalar (--to png --view 3d)</translation>
    </message>
    <message>
        <source>the file (&quot;-&quot; is standard output), or with --all the folder</source>
        <translation>dosya (&quot;-&quot; standart çıktıdır), --all ile klasör</translation>
    </message>
    <message>
        <source>every matrix, or every picture of an animation, into the folder that -o names</source>
        <translation>her matris ya da canlandırmanın her resmi, -o ile verilen klasöre</translation>
    </message>
    <message>
        <source>with a folder: overwrite files that are there</source>
        <translation>klasörle: var olan dosyaların üzerine yaz</translation>
    </message>
    <message>
        <source>incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, tt-circuits, tt-cutsets; of statics: statics, cutset-equations, joint-torques, coupling-torques, mesh-forces, bearings, powers, circulations, and shift-torques of all states</source>
        <translation>incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, tt-circuits, tt-cutsets; statikte: statics, cutset-equations, joint-torques, coupling-torques, mesh-forces, bearings, powers, circulations ve bütün durumlar için shift-torques</translation>
    </message>
    <message>
        <source>without the header row and the first column</source>
        <translation>başlık satırı ve ilk sütun olmadan</translation>
    </message>
    <message>
        <source>comma (the default), semicolon or tab</source>
        <translation>comma (varsayılan), semicolon veya tab</translation>
    </message>
    <message>
        <source>point (the default) or comma</source>
        <translation>point (varsayılan) veya comma</translation>
    </message>
    <message>
        <source>begin with a byte order mark, for spreadsheet programs</source>
        <translation>bayt sırası işaretiyle başla, hesap tablosu programları için</translation>
    </message>
    <message>
        <source>with an exercise sheet that tells where an answer is wrong, and why. Saved answers are graded by exercises grade with the sheet.json of exercises make with the same options</source>
        <translation>yanıtın nerede ve neden yanlış olduğunu söyleyen bir alıştırma sayfasıyla. Kaydedilen yanıtları, aynı seçeneklerle yapılan exercises make&apos;in sheet.json dosyasıyla exercises grade notlar</translation>
    </message>
    <message>
        <source>kinds of questions, as for exercises make (all)</source>
        <translation>soru türleri, exercises make&apos;teki gibi (hepsi)</translation>
    </message>
    <message>
        <source>the heading of the sheet (&quot;Exercises&quot;)</source>
        <translation>sayfanın başlığı (&quot;Exercises&quot;)</translation>
    </message>
    <message>
        <source>how many different sheets there are (1)</source>
        <translation>kaç ayrı sayfa olduğu (1)</translation>
    </message>
    <message>
        <source>which of them this is (1)</source>
        <translation>bunun hangisi olduğu (1)</translation>
    </message>
    <message>
        <source>digraph, ttgraph or schematic; with png and glb also 3d, the train as seen; of graphs digraph or ttgraph</source>
        <translation>digraph, ttgraph veya schematic; png ve glb ile 3d de, takımın görünüşü; graflarda digraph veya ttgraph</translation>
    </message>
    <message>
        <source>pixels (as large as the drawing is; 3d: 1600x1000)</source>
        <translation>piksel (çizimin büyüklüğü kadar; 3d: 1600x1000)</translation>
    </message>
    <message>
        <source>on a dark ground</source>
        <translation>koyu zeminde</translation>
    </message>
    <message>
        <source>on no ground</source>
        <translation>zeminsiz</translation>
    </message>
    <message>
        <source>under a digraph or schematic: where the power of the loads goes, seen from &quot;ground&quot; or the link with this label</source>
        <translation>yönlü graf veya şemanın altında: yüklerin gücünün nereye gittiği, &quot;ground&quot; ya da bu etiketli uzuvdan bakıldığında</translation>
    </message>
    <message>
        <source>front, back, left, right, top, bottom or iso</source>
        <translation>front, back, left, right, top, bottom veya iso</translation>
    </message>
    <message>
        <source>from this azimuth and elevation, degrees (-26,20)</source>
        <translation>bu azimut ve yükselişten, derece (-26,20)</translation>
    </message>
    <message>
        <source>how far the inputs have turned (0); also with glb</source>
        <translation>girişlerin ne kadar döndüğü (0); glb ile de</translation>
    </message>
    <message>
        <source>section perpendicular to x, y or z at this fraction of the length (y:0.5)</source>
        <translation>x, y veya z&apos;ye dik kesit, uzunluğun bu kesrinde (y:0.5)</translation>
    </message>
    <message>
        <source>exploded view along the axes, 0 to 1; also with glb</source>
        <translation>eksenler boyunca patlatılmış görünüm, 0 ile 1 arası; glb ile de</translation>
    </message>
    <message>
        <source>shaded, lines (hidden ones left out) or edges (all of them)</source>
        <translation>shaded, lines (gizliler olmadan) veya edges (hepsi)</translation>
    </message>
    <message>
        <source>links that are left out: 2,5; also with glb</source>
        <translation>dışarıda bırakılan uzuvlar: 2,5; glb ile de</translation>
    </message>
    <message>
        <source>the link that the reference frame is fixed to; also with glb</source>
        <translation>referans eksen takımının bağlı olduğu uzuv; glb ile de</translation>
    </message>
    <message>
        <source>once round the train, as an animated PNG (or --all)</source>
        <translation>takımın çevresinde bir tur, hareketli PNG olarak (ya da --all)</translation>
    </message>
    <message>
        <source>one period of the motion (a minute without one)</source>
        <translation>hareketin bir periyodu (yoksa bir dakika)</translation>
    </message>
    <message>
        <source>pictures a second (24)</source>
        <translation>saniyede resim (24)</translation>
    </message>
    <message>
        <source>pictures (72); with assembly: poses of every gear (24)</source>
        <translation>resim (72); assembly ile: her dişlinin konumları (24)</translation>
    </message>
    <message>
        <source>one gear in its own frame: 15:tail or 15:head</source>
        <translation>kendi eksen takımında tek dişli: 15:tail veya 15:head</translation>
    </message>
    <message>
        <source>the solids of one link</source>
        <translation>tek uzvun katı modelleri</translation>
    </message>
    <message>
        <source>with glb: how long one period plays (without: as long as it takes; of a period too long for a file, so many seconds of the motion, 60)</source>
        <translation>glb ile: bir periyodun ne kadar sürdüğü (yoksa kendi süresi; dosya için çok uzunsa hareketin bu kadar saniyesi, 60)</translation>
    </message>
    <message>
        <source>farthest chord from the exact form (0.002; of large trains as fine as 10 million triangles allow); also with assembly, step (farthest surface of a tooth, 0.001), mjcf and urdf (0.01)</source>
        <translation>kesin biçimden en büyük kiriş sapması (0.002; büyük takımlarda 10 milyon üçgenin izin verdiği kadar ince); assembly, step (diş yüzeylerinin en büyük sapması, 0.001), mjcf ve urdf ile de (0.01)</translation>
    </message>
    <message>
        <source>mjcf: speed (servos with rotors, the default), torque or none</source>
        <translation>mjcf: speed (rotorlu servolar, varsayılan), torque veya none</translation>
    </message>
    <message>
        <source>mjcf: inertia of the rotors, kg m² (100 times what the input feels)</source>
        <translation>mjcf: rotorların ataleti, kg m² (girişin gördüğünün 100 katı)</translation>
    </message>
    <message>
        <source>mjcf: seconds (0.001)</source>
        <translation>mjcf: saniye (0.001)</translation>
    </message>
    <message>
        <source>SDF is not written: no current Gazebo runs its gear joints. --to urdf is read by Gazebo.</source>
        <translation>SDF yazılmaz: güncel hiçbir Gazebo onun dişli mafsallarını çalıştırmıyor. Gazebo, --to urdf çıktısını okur.</translation>
    </message>
    <message>
        <source>-o says where to write.</source>
        <translation>-o nereye yazılacağını söyler.</translation>
    </message>
    <message>
        <source>Writes matrices as CSV, the worked derivation, pictures and animations, gears as 3D files, models for simulators, and graphs.</source>
        <translation>Matrisleri CSV olarak, işlenmiş türetimi, resimleri ve canlandırmaları, dişlileri 3B dosya olarak, simülatör modellerini ve grafları yazar.</translation>
    </message>
    <message>
        <source>%1 is one of %2.</source>
        <translation>%1 şunlardan biridir: %2.</translation>
    </message>
    <message>
        <source>There is no matrix &quot;%1&quot;; there are %2.</source>
        <translation>&quot;%1&quot; diye bir matris yok; olanlar: %2.</translation>
    </message>
    <message>
        <source>The matrix &quot;%1&quot; needs %2; nothing was written.</source>
        <translation>&quot;%1&quot; matrisi şunu ister: %2; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be made.</source>
        <translation>&quot;%1&quot; klasörü oluşturulamadı.</translation>
    </message>
    <message>
        <source>Left out: %1, which needs %2.</source>
        <translation>Atlandı: %1; şunu ister: %2.</translation>
    </message>
    <message>
        <source>Give --matrix NAME or --all.</source>
        <translation>--matrix NAME ya da --all verin.</translation>
    </message>
    <message>
        <source>the solution</source>
        <translation>çözüm</translation>
    </message>
    <message>
        <source>the torques</source>
        <translation>torklar</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>--power needs a mechanism without errors.</source>
        <translation>--power hatasız bir mekanizma ister.</translation>
    </message>
    <message>
        <source>--power needs loads: this document has none, so that no power flows. Add &quot;loads&quot; to it.</source>
        <translation>--power yük ister: bu belgede yük yok, güç akmıyor. &quot;loads&quot; ekleyin.</translation>
    </message>
    <message>
        <source>--power needs balances that hold the loads.</source>
        <translation>--power yükleri tutan dengeler ister.</translation>
    </message>
    <message>
        <source>--power needs a motion: the speeds are not determined.</source>
        <translation>--power bir hareket ister: hızlar belirli değil.</translation>
    </message>
    <message>
        <source>No power flows: the loads and what holds them do no work in this motion.</source>
        <translation>Güç akmıyor: yükler ve onları tutanlar bu harekette iş yapmıyor.</translation>
    </message>
    <message>
        <source>--power is ground or the label of a link, not &quot;%1&quot;.</source>
        <translation>--power, ground ya da bir uzvun etiketidir, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--view 3d is made of pixels: it needs --to png.</source>
        <translation>--view 3d piksellerden oluşur: --to png ister.</translation>
    </message>
    <message>
        <source>%1 needs --view: one of %2.</source>
        <translation>%1, --view ister: şunlardan biri: %2.</translation>
    </message>
    <message>
        <source>--power is drawn in the digraph and in the schematic.</source>
        <translation>--power yönlü grafta ve şemada çizilir.</translation>
    </message>
    <message>
        <source>the drawing</source>
        <translation>çizim</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>resim</translation>
    </message>
    <message>
        <source>A graph is the digraph or the ttgraph, not &quot;%1&quot;.</source>
        <translation>Graf, digraph ya da ttgraph olur, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>There is no T-T graph: the turning joints are no spanning tree, or a mesh has no carrier; nothing was written.</source>
        <translation>T-T grafı yok: döner mafsallar kapsayan ağaç değil ya da bir dişli çiftinin taşıyıcısı yok; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>the 3D view</source>
        <translation>3B görünüm</translation>
    </message>
    <message>
        <source>A train of %1 links has no 3D, which is made of up to %2 links.</source>
        <translation>%1 uzuvlu bir takımın 3B&apos;si yok; 3B en çok %2 uzuv için yapılır.</translation>
    </message>
    <message>
        <source>There is nothing to show: the turning joints are no spanning tree.</source>
        <translation>Gösterilecek bir şey yok: döner mafsallar kapsayan ağaç değil.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>dosya</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, each from %1 to %2, not &quot;%3&quot;.</source>
        <translation>--size GENİŞLİKxYÜKSEKLİK alır, ikisi de %1 ile %2 arasında, &quot;%3&quot; değil.</translation>
    </message>
    <message>
        <source>--all writes a folder; &quot;-&quot; is none.</source>
        <translation>--all bir klasör yazar; &quot;-&quot; klasör değil.</translation>
    </message>
    <message>
        <source>A derivation of more than %1 links is not written: it would be too long to read. The matrices are exported as CSV.</source>
        <translation>%1 uzuvdan fazlası için türetim yazılmaz: okunamayacak kadar uzun olurdu. Matrisler CSV olarak dışa aktarılır.</translation>
    </message>
    <message>
        <source>the derivation</source>
        <translation>türetim</translation>
    </message>
    <message>
        <source>%1 needs --exercises.</source>
        <translation>%1, --exercises ister.</translation>
    </message>
    <message>
        <source>%1 has no meaning with --exercises, which ask about the document.</source>
        <translation>%1 seçeneğinin --exercises ile anlamı yok; alıştırmalar belgeyi sorar.</translation>
    </message>
    <message>
        <source>--exercises needs a file, not standard input.</source>
        <translation>--exercises bir dosya ister, standart girdi olmaz.</translation>
    </message>
    <message>
        <source>--variant is a whole number from 1 to that of --variants.</source>
        <translation>--variant 1 ile --variants sayısı arasında bir tam sayıdır.</translation>
    </message>
    <message>
        <source>Nothing can be asked about this mechanism.</source>
        <translation>Bu mekanizma hakkında sorulacak bir şey yok.</translation>
    </message>
    <message>
        <source>--motor is one of speed, torque, none.</source>
        <translation>--motor şunlardan biridir: speed, torque, none.</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>Nothing can move; the model holds still.</source>
        <translation>Hiçbir şey hareket edemez; model durur.</translation>
    </message>
    <message>
        <source>State %1 leaves %2 freedoms; joints %3 are driven.</source>
        <translation>%1 durumunda %2 serbestlik kalıyor; %3 mafsalları tahrik edilir.</translation>
    </message>
    <message>
        <source>A model for simulators is a folder; &quot;-&quot; is none.</source>
        <translation>Simülatör modeli bir klasördür; &quot;-&quot; klasör değil.</translation>
    </message>
    <message>
        <source>There is no solution to drive the model by; nothing was written.</source>
        <translation>Modeli sürecek bir çözüm yok; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>Models for simulators have at most %1 entries of the solution (inputs times other joints).</source>
        <translation>Simülatör modellerinde çözümün en çok %1 öğesi olur (girişler çarpı öteki mafsallar).</translation>
    </message>
    <message>
        <source>the folder</source>
        <translation>klasör</translation>
    </message>
    <message>
        <source>The train is so large that its chords are within %1 modules instead of %2 (--tolerance).</source>
        <translation>Takım o kadar büyük ki kirişleri %2 yerine %1 modül içinde kalıyor (--tolerance).</translation>
    </message>
    <message>
        <source>Left out: %1 of %2 gears, which cannot be made.</source>
        <translation>Atlandı: %2 dişliden %1 tanesi yapılamıyor.</translation>
    </message>
    <message>
        <source>Only --to glb of a train or a link carries an animation.</source>
        <translation>Canlandırmayı yalnız bir takımın ya da uzvun --to glb çıktısı taşır.</translation>
    </message>
    <message>
        <source>Give --gear or --link, not both.</source>
        <translation>--gear ya da --link verin, ikisini birden değil.</translation>
    </message>
    <message>
        <source>--to assembly writes a folder; &quot;-&quot; is none.</source>
        <translation>--to assembly bir klasör yazar; &quot;-&quot; klasör değil.</translation>
    </message>
    <message>
        <source>There is no turning joint &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; döner mafsalı yok.</translation>
    </message>
    <message>
        <source>There is no turning joint &quot;%1&quot;; they are labelled %2 to %3.</source>
        <translation>&quot;%1&quot; döner mafsalı yok; etiketleri %2 ile %3 arasında.</translation>
    </message>
    <message>
        <source>--inputs names joint %1 twice.</source>
        <translation>--inputs %1 mafsalını iki kez anıyor.</translation>
    </message>
    <message>
        <source>--speed is like 8=1/2: a joint&apos;s label and rad/s.</source>
        <translation>--speed 8=1/2 gibidir: mafsalın etiketi ve rad/s.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no speed; 1/2, 2*3 (rad/s), 1500rpm and 90deg/s are.</source>
        <translation>&quot;%1&quot; hız değil; 1/2, 2*3 (rad/s), 1500rpm ve 90deg/s olur.</translation>
    </message>
    <message>
        <source>Too many to count</source>
        <translation>Sayılamayacak kadar çok</translation>
    </message>
    <message>
        <source>%1 valid set of inputs</source>
        <translation>%1 geçerli giriş kümesi</translation>
    </message>
    <message>
        <source>%1 valid sets of inputs</source>
        <translation>%1 geçerli giriş kümesi</translation>
    </message>
    <message>
        <source>; the first %1:</source>
        <translation>; ilk %1:</translation>
    </message>
    <message>
        <source>(none: nothing can move)</source>
        <translation>(yok: hiçbir şey hareket edemez)</translation>
    </message>
    <message>
        <source>There are over 20 million rates of joints over inputs; no sets are listed.</source>
        <translation>Mafsalların girişlere göre 20 milyondan fazla hızı var; küme listelenmez.</translation>
    </message>
    <message>
        <source>--limit is a whole number.</source>
        <translation>--limit bir tam sayıdır.</translation>
    </message>
    <message>
        <source>the list of input sets</source>
        <translation>giriş kümelerinin listesi</translation>
    </message>
    <message>
        <source>how many sets are listed (1,000)</source>
        <translation>kaç kümenin listeleneceği (1.000)</translation>
    </message>
    <message>
        <source>Counts and lists the valid sets of inputs.</source>
        <translation>Geçerli giriş kümelerini sayar ve listeler.</translation>
    </message>
    <message>
        <source>1 step, no faults</source>
        <translation>1 adım, hata yok</translation>
    </message>
    <message>
        <source>%1 steps, no faults</source>
        <translation>%1 adım, hata yok</translation>
    </message>
    <message>
        <source>check needs a file.</source>
        <translation>check bir dosya ister.</translation>
    </message>
    <message>
        <source>%1 lessons, %2 min</source>
        <translation>%1 ders, %2 dk</translation>
    </message>
    <message>
        <source>The first word is check, list or make.</source>
        <translation>İlk sözcük check, list ya da make&apos;tir.</translation>
    </message>
    <message>
        <source>the findings as JSON</source>
        <translation>bulgular JSON olarak</translation>
    </message>
    <message>
        <source>Checks lessons: their form, answers and reasons; lists those of the program; makes pages of them.</source>
        <translation>Dersleri denetler: biçimlerini, yanıtlarını ve gerekçelerini; programınkileri sıralar; onlardan sayfa yapar.</translation>
    </message>
    <message>
        <source>A train of %1 links has no 3D, which is made of up to %2 links; --gear and --link export a part of it. Nothing was written.</source>
        <translation>%1 uzuvlu bir takımın 3B&apos;si yok; 3B en çok %2 uzuv için yapılır; --gear ve --link bir parçasını dışa aktarır. Hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>A train of %1 gears (over %2): wheels are plain discs, shafts and arms are straight and pass through other parts.</source>
        <translation>%1 dişlili bir takım (%2 üstü): dişliler düz disktir, miller ve kollar düzdür ve başka parçaların içinden geçer.</translation>
    </message>
    <message>
        <source>%1; nothing was written.</source>
        <translation>%1; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>%1; choose a coarser --tolerance.</source>
        <translation>%1; daha kaba bir --tolerance seçin.</translation>
    </message>
    <message>
        <source>Exit status: 0 fine (warnings allowed), 1 the mechanism has errors, 2 wrong usage or a file that could not be read or
written, 3 out of a stated resource limit. &quot;-&quot; is standard input or output.</source>
        <translation>Çıkış durumu: 0 sorun yok (uyarı olabilir), 1 mekanizmada hata var, 2 yanlış kullanım ya da okunamayan veya
yazılamayan dosya, 3 belirtilen bir sınır aşıldı. &quot;-&quot; standart girdi veya çıktıdır.</translation>
    </message>
    <message>
        <source>geargraph-cli: the analysis of geared mechanisms, without a window.</source>
        <translation>geargraph-cli: dişli mekanizmaların çözümlemesi, penceresiz.</translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation>Komutlar:</translation>
    </message>
    <message>
        <source>--help, --version and --language en|de|tr|es (that of the environment) work on every command.</source>
        <translation>--help, --version ve --language en|de|tr|es (ortamınki) her komutta geçer.</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Seçenekler</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; diye bir komut yok.</translation>
    </message>
    <message>
        <source>The memory does not suffice for this mechanism.</source>
        <translation>Bu mekanizma için bellek yetmiyor.</translation>
    </message>
    <message>
        <source>It needs -o with a folder.</source>
        <translation>Klasörle birlikte -o ister.</translation>
    </message>
    <message>
        <source>It reads no file.</source>
        <translation>Dosya okumaz.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; --force overwrites it.</source>
        <translation>&quot;%1&quot; zaten var; --force üzerine yazar.</translation>
    </message>
    <message>
        <source>%1 files in %2</source>
        <translation>%2 içinde %1 dosya</translation>
    </message>
    <message>
        <source>the folder that the pages are written to</source>
        <translation>sayfaların yazılacağı klasör</translation>
    </message>
    <message>
        <source>overwrite files that are there</source>
        <translation>var olan dosyaların üzerine yaz</translation>
    </message>
    <message>
        <source>Writes the manual of the program as web pages, with its pictures.</source>
        <translation>Programın kılavuzunu resimleriyle web sayfaları olarak yazar.</translation>
    </message>
    <message>
        <source>--density is above 0, in kg/m³, not &quot;%1&quot;.</source>
        <translation>--density 0&apos;dan büyüktür, kg/m³ cinsinden, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--gravity is like 0,0,-9.81, in m/s², not &quot;%1&quot;.</source>
        <translation>--gravity 0,0,-9.81 gibidir, m/s² cinsinden, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>acceleration of free fall, m/s², instead of the document&apos;s</source>
        <translation>yerçekimi ivmesi, m/s², belgedekinin yerine</translation>
    </message>
    <message>
        <source>of all solids, kg/m³, instead of the document&apos;s</source>
        <translation>bütün katı modellerin, kg/m³, belgedekinin yerine</translation>
    </message>
    <message>
        <source>%1 takes a number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1, %2 ile %3 arasında bir sayı alır, &quot;%4&quot; değil.</translation>
    </message>
    <message>
        <source>%1 is like 8=30deg, 8=1/2rad or 8=2turns: an input&apos;s label and its angle.</source>
        <translation>%1 8=30deg, 8=1/2rad veya 8=2turns gibidir: girişin etiketi ve açısı.</translation>
    </message>
    <message>
        <source>%1 needs the unit of its angle: %2deg or %2rad.</source>
        <translation>%1 için açının birimi gerekir: %2deg veya %2rad.</translation>
    </message>
    <message>
        <source>The angle %1 is too large: no program could represent it, the largest number is 1.79e308. Leave out whole turns.</source>
        <translation>%1 açısı çok büyük: hiçbir program tutamaz, en büyük sayı 1.79e308&apos;dir. Tam turları atın.</translation>
    </message>
    <message>
        <source>%1 deg</source>
        <translation>%1 derece</translation>
    </message>
    <message>
        <source>joint %1 at %2 is beyond its limits (%3, %4)</source>
        <translation>%1 mafsalı %2 ile sınırlarının ötesinde (%3, %4)</translation>
    </message>
    <message>
        <source>%1 turned by %2 deg</source>
        <translation>%1, %2 derece dönmüş</translation>
    </message>
    <message>
        <source>Links, against the reference pose: turned, and where the point went that was at the origin</source>
        <translation>Uzuvlar referans konuma göre: dönüş, ve başlangıç noktasındaki noktanın gittiği yer</translation>
    </message>
    <message>
        <source>%1 by %2 deg about %3 to %4</source>
        <translation>%1, %3 etrafında %2 derece, %4 noktasına</translation>
    </message>
    <message>
        <source>the pose</source>
        <translation>konum</translation>
    </message>
    <message>
        <source>the angle of an input (deg, rad or turns; without it 0); may be repeated</source>
        <translation>bir girişin açısı (deg, rad veya turns; yoksa 0); yinelenebilir</translation>
    </message>
    <message>
        <source>Says where every link is for given angles of the inputs.</source>
        <translation>Girişlerin verilen açılarında her uzvun nerede olduğunu söyler.</translation>
    </message>
    <message>
        <source>requests on standard input, answers on standard output</source>
        <translation>istekler standart girdide, yanıtlar standart çıktıda</translation>
    </message>
    <message>
        <source>Methods and their params; those in [ ] may be left out:</source>
        <translation>Yöntemler ve params üyeleri; [ ] içindekiler olmayabilir:</translation>
    </message>
    <message>
        <source>Edits and their members beside &quot;edit&quot;; null removes what may be left out:</source>
        <translation>Düzenlemeler ve &quot;edit&quot; yanındaki üyeleri; null, olmayabilecek olanı kaldırır:</translation>
    </message>
    <message>
        <source>of address space, for each command</source>
        <translation>adres alanı, her komut için</translation>
    </message>
    <message>
        <source>Answers requests, a JSON object a line: open, edit, analyze, export, ...</source>
        <translation>İstekleri yanıtlar, her satırda bir JSON nesnesi: open, edit, analyze, export, ...</translation>
    </message>
    <message>
        <source>rank r = %1, degrees of freedom E = t - r = %2</source>
        <translation>rank r = %1, serbestlik derecesi E = t - r = %2</translation>
    </message>
    <message>
        <source>rank r = %1 (%3 of the meshes + %4 of the couplings), degrees of freedom E = t - r = %2</source>
        <translation>rank r = %1 (dişli çiftlerinden %3 + fren ve kavramalardan %4), serbestlik derecesi E = t - r = %2</translation>
    </message>
    <message>
        <source>(Kutzbach counts %1)</source>
        <translation>(Kutzbach %1 sayar)</translation>
    </message>
    <message>
        <source>Carriers of the gear pairs, by their transfer vertices</source>
        <translation>Dişli çiftlerinin taşıyıcıları, aktarma düğümleriyle</translation>
    </message>
    <message>
        <source>axes %1, %2</source>
        <translation>eksenler %1, %2</translation>
    </message>
    <message>
        <source>Rates of the outputs over those of the inputs, Eq. (23)</source>
        <translation>Çıkış hızları bölü giriş hızları, Denk. (23)</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>girişler</translation>
    </message>
    <message>
        <source>inputs, chosen because the file names none:</source>
        <translation>girişler, dosya adlandırmadığı için seçildi:</translation>
    </message>
    <message>
        <source>%1 at %2 rad/s</source>
        <translation>%1: %2 rad/s</translation>
    </message>
    <message>
        <source>not driven, because engaged couplings decide:</source>
        <translation>devredeki fren ve kavramalar belirlediği için tahrik edilmeyen:</translation>
    </message>
    <message>
        <source>%1 outputs over %2 inputs: too large to print; see --json</source>
        <translation>%1 çıkış bölü %2 giriş: basılamayacak kadar büyük; bkz. --json</translation>
    </message>
    <message>
        <source>The matroid method and the T-T graph method agree exactly.</source>
        <translation>Matroid yöntemi ile T-T graf yöntemi tam olarak uyuşuyor.</translation>
    </message>
    <message>
        <source>The two methods differ by up to %1.</source>
        <translation>İki yöntem arasındaki fark en çok %1.</translation>
    </message>
    <message>
        <source>in the gear ratios</source>
        <translation>dişli oranlarıyla</translation>
    </message>
    <message>
        <source>State %1: it names no drive and driven link, so it has no ratio.</source>
        <translation>%1 durumu: tahrik eden ve tahrik edilen uzvu adlandırmıyor, bu yüzden oranı yok.</translation>
    </message>
    <message>
        <source>State %1: the driven link does not move.</source>
        <translation>%1 durumu: tahrik edilen uzuv hareket etmiyor.</translation>
    </message>
    <message>
        <source>State %1: the driven link turns about several directions at once.</source>
        <translation>%1 durumu: tahrik edilen uzuv aynı anda birkaç doğrultuda dönüyor.</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation>Mekanizma</translation>
    </message>
    <message>
        <source>%1: no states</source>
        <translation>%1: durum yok</translation>
    </message>
    <message>
        <source>%1: 1 state</source>
        <translation>%1: 1 durum</translation>
    </message>
    <message>
        <source>%1: %2 states</source>
        <translation>%1: %2 durum</translation>
    </message>
    <message>
        <source>the shift table</source>
        <translation>vites tablosu</translation>
    </message>
    <message>
        <source>The shift table: what each state of the brakes and clutches does.</source>
        <translation>Vites tablosu: frenlerin ve kavramaların her durumunun ne yaptığı.</translation>
    </message>
    <message>
        <source>Give --state NAME, --all-states or --engage A,B.</source>
        <translation>--state NAME, --all-states ya da --engage A,B verin.</translation>
    </message>
    <message>
        <source>of every state</source>
        <translation>her durumun</translation>
    </message>
    <message>
        <source>joint:14=10Nm, link:3@e=10Nm or link:3=10,-20,-50N@30,-60,130, added</source>
        <translation>joint:14=10Nm, link:3@e=10Nm veya link:3=10,-20,-50N@30,-60,130, eklenir</translation>
    </message>
    <message>
        <source>without the loads of the document</source>
        <translation>belgedeki yükler olmadan</translation>
    </message>
    <message>
        <source>joint:8 or link:7@a: find the torque there; may be given again</source>
        <translation>joint:8 veya link:7@a: oradaki torku bul; yeniden verilebilir</translation>
    </message>
    <message>
        <source>the speed of an input in rad/s; may be given again</source>
        <translation>bir girişin rad/s cinsinden hızı; yeniden verilebilir</translation>
    </message>
    <message>
        <source>with the losses of the meshes</source>
        <translation>dişli çiftlerinin kayıplarıyla</translation>
    </message>
    <message>
        <source>efficiency of meshes that state none; implies --efficiency</source>
        <translation>verim vermeyen dişli çiftlerinin verimi; --efficiency&apos;yi içerir</translation>
    </message>
    <message>
        <source>loads that several meshes share: left open, or by equal stiffness</source>
        <translation>birkaç dişli çiftinin paylaştığı yükler: açık bırakılır ya da eşit rijitlikle</translation>
    </message>
    <message>
        <source>without the solution in gear ratios</source>
        <translation>dişli oranlarıyla çözüm olmadan</translation>
    </message>
    <message>
        <source>Torques, tooth forces, bearing reactions and efficiency under loads.</source>
        <translation>Yükler altında torklar, diş kuvvetleri, yatak tepkileri ve verim.</translation>
    </message>
    <message>
        <source>%1 is on joint:LABEL, link:LABEL or link:LABEL@AXIS, not &quot;%2&quot;.</source>
        <translation>%1, joint:LABEL, link:LABEL veya link:LABEL@AXIS olur, &quot;%2&quot; değil.</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; uzvu yok.</translation>
    </message>
    <message>
        <source>The ground takes any load: name a moving link.</source>
        <translation>Sabit uzuv her yükü karşılar: hareketli bir uzuv yazın.</translation>
    </message>
    <message>
        <source>There is no axis &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; ekseni yok.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no load: 10Nm, 1/2kNm, 3lbf ft and 2kW@1500rpm are torques, and 10,-20,-50N@30,-60,130 is a force on a link at a point.</source>
        <translation>&quot;%1&quot; yük değil: 10Nm, 1/2kNm, 3lbf ft ve 2kW@1500rpm torktur, 10,-20,-50N@30,-60,130 bir uzva bir noktada etkiyen kuvvettir.</translation>
    </message>
    <message>
        <source>--balance names &quot;%1&quot; twice.</source>
        <translation>--balance &quot;%1&quot; yerini iki kez anıyor.</translation>
    </message>
    <message>
        <source>--eta is an efficiency, above 0 and at most 1.</source>
        <translation>--eta bir verimdir, 0&apos;dan büyük ve en çok 1.</translation>
    </message>
    <message>
        <source>--share is one of none, stiffness.</source>
        <translation>--share şunlardan biridir: none, stiffness.</translation>
    </message>
    <message>
        <source>Give --state NAME or --all-states.</source>
        <translation>--state NAME ya da --all-states verin.</translation>
    </message>
    <message>
        <source>There is no state &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; durumu yok.</translation>
    </message>
    <message>
        <source>power, W</source>
        <translation>güç, W</translation>
    </message>
    <message>
        <source>shared</source>
        <translation>paylaşılan</translation>
    </message>
    <message>
        <source>Balances and couplings</source>
        <translation>Dengeler, frenler ve kavramalar</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>dişli çifti</translation>
    </message>
    <message>
        <source>torque on tail, N m</source>
        <translation>kuyruktaki tork, N m</translation>
    </message>
    <message>
        <source>on head, N m</source>
        <translation>başta, N m</translation>
    </message>
    <message>
        <source>force on head, N</source>
        <translation>baştaki kuvvet, N</translation>
    </message>
    <message>
        <source>Meshes (torques about the axes from the carrier)</source>
        <translation>Dişli çiftleri (eksenlere göre torklar, taşıyıcıdan)</translation>
    </message>
    <message>
        <source>force, N</source>
        <translation>kuvvet, N</translation>
    </message>
    <message>
        <source>moment, N m</source>
        <translation>moment, N m</translation>
    </message>
    <message>
        <source>at</source>
        <translation>yer</translation>
    </message>
    <message>
        <source>Bearings (tail on head, base frame)</source>
        <translation>Yataklar (kuyruktan başa, temel eksen takımı)</translation>
    </message>
    <message>
        <source>Power fed %1 W, taken %2 W, lost %3 W</source>
        <translation>Verilen güç %1 W, alınan %2 W, yitirilen %3 W</translation>
    </message>
    <message>
        <source>Passed by the meshes, seen from their carriers, over the power fed: %1</source>
        <translation>Dişli çiftlerinin taşıyıcılarından görülen ilettiği güç bölü verilen güç: %1</translation>
    </message>
    <message>
        <source>Efficiency %1</source>
        <translation>Verim %1</translation>
    </message>
    <message>
        <source>Efficiency backward %1</source>
        <translation>Ters yönde verim %1</translation>
    </message>
    <message>
        <source>The output cannot drive it back: it locks itself.</source>
        <translation>Çıkış onu geri tahrik edemez: kendini kilitler.</translation>
    </message>
    <message>
        <source>Both methods agree.</source>
        <translation>İki yöntem uyuşuyor.</translation>
    </message>
    <message>
        <source>The methods do NOT agree.</source>
        <translation>Yöntemler UYUŞMUYOR.</translation>
    </message>
    <message>
        <source>%1, state %2</source>
        <translation>%1, durum %2</translation>
    </message>
    <message>
        <source>There is no equilibrium.</source>
        <translation>Denge yok.</translation>
    </message>
    <message>
        <source>Files or folders are needed.</source>
        <translation>Dosyalar ya da klasörler gerekli.</translation>
    </message>
    <message>
        <source>--jobs is a whole number from 1 to 256.</source>
        <translation>--jobs 1 ile 256 arasında bir tam sayıdır.</translation>
    </message>
    <message>
        <source>the summary</source>
        <translation>özet</translation>
    </message>
    <message>
        <source>how many files are analysed at once (as many as there are processors)</source>
        <translation>aynı anda kaç dosyanın çözümleneceği (işlemci sayısı kadar)</translation>
    </message>
    <message>
        <source>the file (standard output without it)</source>
        <translation>dosya (yoksa standart çıktı)</translation>
    </message>
    <message>
        <source>A row for each file, or for each document in a folder, as CSV.</source>
        <translation>Her dosya için, ya da klasördeki her belge için bir satır, CSV olarak.</translation>
    </message>
    <message>
        <source>give up after this time (exit status 3); nothing is written then</source>
        <translation>bu süreden sonra vazgeç (çıkış durumu 3); o zaman hiçbir şey yazılmaz</translation>
    </message>
    <message>
        <source>--limit-seconds takes a number of seconds above 0, up to 1000000, not &quot;%1&quot;.</source>
        <translation>--limit-seconds 0&apos;dan büyük, en çok 1000000 saniye alır, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>The limit of %1 s was over before %2 was finished; nothing was written.</source>
        <translation>%1 s sınırı şu bitmeden doldu: %2; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>the validation</source>
        <translation>doğrulama</translation>
    </message>
    <message>
        <source>%1: no problems</source>
        <translation>%1: sorun yok</translation>
    </message>
    <message>
        <source>also look for links that collide while the inputs run at their speeds</source>
        <translation>girişler kendi hızlarında dönerken çarpışan uzuvları da ara</translation>
    </message>
    <message>
        <source>Says what is wrong with a file.</source>
        <translation>Bir dosyada neyin yanlış olduğunu söyler.</translation>
    </message>
    <message>
        <source>Give --from or --camera, not both.</source>
        <translation>--from ya da --camera verin, ikisini birden değil.</translation>
    </message>
    <message>
        <source>--from is one of front, back, left, right, top, bottom, iso.</source>
        <translation>--from şunlardan biridir: front, back, left, right, top, bottom, iso.</translation>
    </message>
    <message>
        <source>--camera takes AZIMUTH,ELEVATION in degrees, up to 360 and 90, not &quot;%1&quot;.</source>
        <translation>--camera derece cinsinden AZİMUT,YÜKSELİŞ alır, en çok 360 ve 90, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--time takes seconds, not &quot;%1&quot;.</source>
        <translation>--time saniye alır, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--explode takes a part from 0 to 1, not &quot;%1&quot;.</source>
        <translation>--explode 0 ile 1 arası bir oran alır, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--section takes x, y or z, and how far along from 0 to 1: y:0.5, not &quot;%1&quot;.</source>
        <translation>--section x, y veya z alır, ve 0 ile 1 arası yerini: y:0.5, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--faces is one of shaded, lines, edges.</source>
        <translation>--faces şunlardan biridir: shaded, lines, edges.</translation>
    </message>
    <message>
        <source>Give --turntable or --motion, not both.</source>
        <translation>--turntable ya da --motion verin, ikisini birden değil.</translation>
    </message>
    <message>
        <source>--frames takes a whole number from 2 to %1, not &quot;%2&quot;.</source>
        <translation>--frames 2 ile %1 arasında bir tam sayı alır, &quot;%2&quot; değil.</translation>
    </message>
    <message>
        <source>--fps takes pictures a second from 0.1 to 100, not &quot;%1&quot;.</source>
        <translation>--fps saniyede 0.1 ile 100 arası resim alır, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>Links %1 and %2 overlap in the reference pose: give them clearance.</source>
        <translation>%1 ve %2 uzuvları referans konumda iç içe: aralarına boşluk verin.</translation>
    </message>
    <message>
        <source>Links %1 and %2 collide %3, with %4. Give them clearance, or limit joints.</source>
        <translation>%1 ve %2 uzuvları %3 çarpışır; o anda %4. Aralarına boşluk verin ya da mafsalları sınırlayın.</translation>
    </message>
    <message>
        <source>after %1 of the motion backwards</source>
        <translation>geri hareketin %1 sonrasında</translation>
    </message>
    <message>
        <source>after %1 of the motion</source>
        <translation>hareketin %1 sonrasında</translation>
    </message>
    <message>
        <source>%1 at %2 deg</source>
        <translation>%1: %2 derece</translation>
    </message>
    <message>
        <source>joints %1</source>
        <translation>mafsallar %1</translation>
    </message>
    <message>
        <source>(Only part of the motion was checked.)</source>
        <translation>(Hareketin yalnız bir bölümü denetlendi.)</translation>
    </message>
    <message>
        <source>(Checked for the first %1: the motion does not repeat sooner.)</source>
        <translation>(İlk %1 boyunca denetlendi: hareket daha önce yinelenmiyor.)</translation>
    </message>
    <message>
        <source>(Checked until the motion repeats.)</source>
        <translation>(Hareket yinelenene kadar denetlendi.)</translation>
    </message>
    <message>
        <source>(Checked between the limits of the joints, from %1 to %2.)</source>
        <translation>(Mafsalların sınırları arasında denetlendi, %1 ile %2 arası.)</translation>
    </message>
    <message>
        <source>(1 more pair of links collides later.)</source>
        <translation>(1 uzuv çifti daha sonra çarpışır.)</translation>
    </message>
    <message>
        <source>(%1 more pairs of links collide later.)</source>
        <translation>(%1 uzuv çifti daha sonra çarpışır.)</translation>
    </message>
    <message>
        <source>The motion of more than %1 links is not checked for collisions.</source>
        <translation>%1 uzuvdan fazlasının hareketi çarpışma için denetlenmez.</translation>
    </message>
    <message>
        <source>Only part of the motion was checked for collisions: too many parts come close to each other.</source>
        <translation>Hareketin yalnız bir bölümü çarpışma için denetlendi: çok fazla parça birbirine yaklaşıyor.</translation>
    </message>
    <message>
        <source>The motion was checked for collisions for its first %1: it does not repeat sooner.</source>
        <translation>Hareketin ilk %1 süresi çarpışma için denetlendi: daha önce yinelenmiyor.</translation>
    </message>
    <message>
        <source>Stop driving %1</source>
        <translation>%1 mafsalını artık tahrik etme</translation>
    </message>
    <message>
        <source>Drive %1 too</source>
        <translation>%1 mafsalını da tahrik et</translation>
    </message>
    <message>
        <source>Exchange input %1 for %2</source>
        <translation>%1 girişini %2 ile değiştir</translation>
    </message>
    <message>
        <source>Choose the inputs for me</source>
        <translation>Girişleri benim için seç</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2</source>
        <translation>%2 dişlisinde %1 diş kullan</translation>
    </message>
    <message>
        <source>Make %1 external</source>
        <translation>%1 dış olsun</translation>
    </message>
    <message>
        <source>Make %1 internal</source>
        <translation>%1 iç olsun</translation>
    </message>
    <message>
        <source>Make %1 bevel</source>
        <translation>%1 konik olsun</translation>
    </message>
    <message>
        <source>Let the pitch point follow from axes and teeth</source>
        <translation>Hatve noktası eksenlerden ve dişlerden çıksın</translation>
    </message>
    <message>
        <source>Let pitch point and kind follow from the axes</source>
        <translation>Hatve noktası ve tür eksenlerden çıksın</translation>
    </message>
    <message>
        <source>Give each its own axis</source>
        <translation>Her birine kendi eksenini ver</translation>
    </message>
    <message>
        <source>Move %1 along its axis to %2 %3</source>
        <translation>%1 ekseni boyunca %2 %3 konumuna kaydırılsın</translation>
    </message>
    <message>
        <source>Use %1 teeth on the ring and %2 on the planets</source>
        <translation>Çemberde %1, gezegenlerde %2 diş kullan</translation>
    </message>
    <message>
        <source>Use %1 teeth on the sun and %2 on the planets</source>
        <translation>Güneşte %1, gezegenlerde %2 diş kullan</translation>
    </message>
    <message>
        <source>Use twice the teeth everywhere</source>
        <translation>Her yerde iki kat diş kullan</translation>
    </message>
    <message>
        <source>Use three times the teeth everywhere</source>
        <translation>Her yerde üç kat diş kullan</translation>
    </message>
    <message>
        <source>Use four times the teeth everywhere</source>
        <translation>Her yerde dört kat diş kullan</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2 of %3</source>
        <translation>%3 üzerindeki %2 dişlisinde %1 diş kullan</translation>
    </message>
    <message>
        <source>Use %1 teeth on gear %2 and %3 on gear %4</source>
        <translation>%2 dişlisinde %1, %4 dişlisinde %3 diş kullan</translation>
    </message>
    <message>
        <source>Use %1 equally spaced planets</source>
        <translation>Eşit aralıklı %1 gezegen kullan</translation>
    </message>
    <message>
        <source>Tie link %1 to the ground</source>
        <translation>%1 uzvunu sabit uzva bağla</translation>
    </message>
    <message>
        <source>Tie links %1 to the ground</source>
        <translation>%1 uzuvlarını sabit uzva bağla</translation>
    </message>
    <message>
        <source>Delete the loose links</source>
        <translation>Bağlı olmayan uzuvları sil</translation>
    </message>
    <message>
        <source>, a second bearing on axis %1</source>
        <translation>, %1 ekseninde ikinci bir yatak</translation>
    </message>
    <message>
        <source>The pinions do not go in evenly: twice the side wheels&apos; teeth, %1, has to be a multiple of %2.</source>
        <translation>Pinyonlar eşit aralıkla yerleşmiyor: yan dişlilerin diş sayısının iki katı, %1, %2 sayısının katı olmalıdır.</translation>
    </message>
    <message>
        <source>There is no such link.</source>
        <translation>Böyle bir uzuv yok.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: a planet turns on its carrier and carries nothing.</source>
        <translation>%1 uzvu gezegen değil: gezegen, taşıyıcısında döner ve hiçbir şey taşımaz.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: one of its meshes does not fit its axes.</source>
        <translation>%1 uzvu gezegen değil: dişli çiftlerinden biri eksenlerine uymuyor.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: its meshes are with wheels on several axes.</source>
        <translation>%1 uzvu gezegen değil: dişli çiftleri birkaç eksendeki dişlilerle.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: what it turns on does not carry the axis of what it meshes with.</source>
        <translation>%1 uzvu gezegen değil: üzerinde döndüğü uzuv, birlikte çalıştığı dişlinin eksenini taşımıyor.</translation>
    </message>
    <message>
        <source>Link %1 is no planet: it meshes with nothing.</source>
        <translation>%1 uzvu gezegen değil: hiçbir dişliyle çalışmıyor.</translation>
    </message>
    <message>
        <source>%1 planets cannot be put in evenly.</source>
        <translation>%1 gezegen eşit aralıkla yerleştirilemez.</translation>
    </message>
    <message>
        <source>Short and long planet cannot touch each other: small sun + short planet and large sun + long planet differ by more than short + long planet. What fits: sums that are nearer.</source>
        <translation>Kısa ve uzun gezegen birbirine değemez: küçük güneş + kısa gezegen ile büyük güneş + uzun gezegen arasındaki fark, kısa + uzun gezegenden büyük. Birbirine yakın toplamlar uyar.</translation>
    </message>
    <message>
        <source>The long planets, which extend through both planes, interfere with the small sun. What fits: a large sun with at least 4 teeth more than the small one.</source>
        <translation>İki düzlemden de geçen uzun gezegenler küçük güneşle çakışıyor. Küçüğünden en az 4 dişi fazla olan bir büyük güneş uyar.</translation>
    </message>
    <message>
        <source>The planets collide. What fits: fewer pairs, smaller planets, or a larger ring.</source>
        <translation>Gezegenler çarpışıyor. Daha az çift, daha küçük gezegenler ya da daha büyük bir çember uyar.</translation>
    </message>
    <message>
        <source>The pairs do not go in evenly: ring + large sun = %1 and ring - small sun = %2 have to be multiples of %3.</source>
        <translation>Çiftler eşit aralıkla yerleşmiyor: çember + büyük güneş = %1 ve çember - küçük güneş = %2, %3 sayısının katları olmalıdır.</translation>
    </message>
    <message>
        <source>The planets do not go in evenly: sun + ring = %1 has to be a multiple of %2.</source>
        <translation>Gezegenler eşit aralıkla yerleşmiyor: güneş + çember = %1, %2 sayısının katı olmalıdır.</translation>
    </message>
    <message>
        <source>The planets collide. What fits: fewer or smaller planets, or a larger sun.</source>
        <translation>Gezegenler çarpışıyor. Daha az ya da daha küçük gezegenler veya daha büyük bir güneş uyar.</translation>
    </message>
    <message>
        <source>The quote that begins here is never closed.</source>
        <translation>Burada başlayan tırnak hiç kapanmıyor.</translation>
    </message>
    <message>
        <source>A field ends with its closing quote; a quote inside a field is written twice.</source>
        <translation>Bir alan kapanan tırnağıyla biter; alan içindeki tırnak iki kez yazılır.</translation>
    </message>
    <message>
        <source>A field with a quote in it is quoted as a whole, and the quote written twice.</source>
        <translation>İçinde tırnak olan alan bütünüyle tırnak içine alınır ve içteki tırnak iki kez yazılır.</translation>
    </message>
    <message>
        <source>These bytes are not UTF-8.</source>
        <translation>Bu baytlar UTF-8 değil.</translation>
    </message>
    <message>
        <source>Standard input could not be read: %1.</source>
        <translation>Standart girdi okunamadı: %1.</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>%1 okunamadı: %2.</translation>
    </message>
    <message>
        <source>%1 could not be written: it is a folder.</source>
        <translation>%1 yazılamadı: bu bir klasör.</translation>
    </message>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>%1 yazılamadı: %2.</translation>
    </message>
    <message>
        <source>; what should be in it is kept in %1</source>
        <translation>; içinde olması gereken %1 içinde saklandı</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; could not be made: %2.</source>
        <translation>&quot;%1&quot; klasörü oluşturulamadı: %2.</translation>
    </message>
    <message>
        <source>Stopped; the folder is not complete.</source>
        <translation>Durduruldu; klasör eksik.</translation>
    </message>
    <message>
        <source>there is a file of that name</source>
        <translation>bu adda bir dosya var</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; nothing was written.</source>
        <translation>&quot;%1&quot; zaten var; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>The file is far too large.</source>
        <translation>Dosya çok fazla büyük.</translation>
    </message>
    <message>
        <source>expected the end of the file after the outermost value</source>
        <translation>en dıştaki değerden sonra dosyanın sonu bekleniyordu</translation>
    </message>
    <message>
        <source>expected a value</source>
        <translation>bir değer bekleniyordu</translation>
    </message>
    <message>
        <source>lists and objects are nested deeper than %1</source>
        <translation>listeler ve nesneler %1 düzeyden derin iç içe</translation>
    </message>
    <message>
        <source>expected a digit of a number</source>
        <translation>bir sayının rakamı bekleniyordu</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;]&apos; in a list</source>
        <translation>listede &apos;,&apos; veya &apos;]&apos; bekleniyordu</translation>
    </message>
    <message>
        <source>expected a member name in double quotes</source>
        <translation>çift tırnak içinde bir üye adı bekleniyordu</translation>
    </message>
    <message>
        <source>expected &apos;:&apos; after a member name</source>
        <translation>üye adından sonra &apos;:&apos; bekleniyordu</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;}&apos; in an object</source>
        <translation>nesnede &apos;,&apos; veya &apos;}&apos; bekleniyordu</translation>
    </message>
    <message>
        <source>expected the closing quote of a string</source>
        <translation>dizgenin kapanan tırnağı bekleniyordu</translation>
    </message>
    <message>
        <source>expected the closing quote of a string, or an escape such as \n</source>
        <translation>dizgenin kapanan tırnağı ya da \n gibi bir kaçış dizisi bekleniyordu</translation>
    </message>
    <message>
        <source>expected a character in UTF-8</source>
        <translation>UTF-8 karakteri bekleniyordu</translation>
    </message>
    <message>
        <source>expected an escape that JSON knows (\&quot; \\ \/ \b \f \n \r \t \u)</source>
        <translation>JSON&apos;un bildiği bir kaçış dizisi bekleniyordu (\&quot; \\ \/ \b \f \n \r \t \u)</translation>
    </message>
    <message>
        <source>expected four hexadecimal digits after \u</source>
        <translation>\u&apos;dan sonra dört onaltılık rakam bekleniyordu</translation>
    </message>
    <message>
        <source>expected no second half of a surrogate pair here</source>
        <translation>burada vekil çiftin ikinci yarısı beklenmiyordu</translation>
    </message>
    <message>
        <source>expected both halves of a surrogate pair</source>
        <translation>vekil çiftin iki yarısı bekleniyordu</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>dosyanın sonu</translation>
    </message>
    <message>
        <source>the byte 0x%1</source>
        <translation>0x%1 baytı</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3, found %4.</source>
        <translation>Satır %1, sütun %2: %3, bulunan: %4.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3.</source>
        <translation>Satır %1, sütun %2: %3.</translation>
    </message>
    <message>
        <source>Links %1 overlap in 3D: move their joints along the axes, leave pitch points open, or change the tooth counts.</source>
        <translation>%1 uzuvları 3B&apos;de iç içe: mafsallarını eksenler boyunca kaydırın, hatve noktalarını boş bırakın ya da diş sayılarını değiştirin.</translation>
    </message>
    <message>
        <source>Links %1 overlap in 3D: move their joints along the axes, or change the tooth counts.</source>
        <translation>%1 uzuvları 3B&apos;de üst üste biniyor: mafsallarını eksenler boyunca kaydırın ya da diş sayılarını değiştirin.</translation>
    </message>
    <message>
        <source>The rim of %1 does not reach past the roots of the ring&apos;s %2 teeth: make it larger than %3.</source>
        <translation>%1 çaplı jant, çemberin %2 dişinin dibini aşmıyor: %3 değerinden büyük yapın.</translation>
    </message>
    <message>
        <source>The bore of %1 leaves no body below the roots of %2 teeth: make it smaller than %3.</source>
        <translation>%1 çaplı delik, %2 dişin dibinin altında gövde bırakmıyor: %3 değerinden küçük yapın.</translation>
    </message>
    <message>
        <source>A gear of %1 teeth has a measure that no tooth can have; module and face width must be positive, the pressure angle between 5 and 35 degrees, shift and heights at most 3 modules.</source>
        <translation>%1 dişli bir dişlinin hiçbir dişte olamayacak bir ölçüsü var; modül ve diş genişliği pozitif, kavrama açısı 5 ile 35 derece arasında, profil kaydırma ve yükseklikler en çok 3 modül olmalıdır.</translation>
    </message>
    <message>
        <source>%1 teeth are too few for a ring that a rack can generate; use at least %2.</source>
        <translation>%1 diş, kremayerle üretilebilen bir çember için çok az; en az %2 kullanın.</translation>
    </message>
    <message>
        <source>%1 teeth are too few for a gear that a rack can generate; use at least %2.</source>
        <translation>%1 diş, kremayerle üretilebilen bir dişli için çok az; en az %2 kullanın.</translation>
    </message>
    <message>
        <source>One tooth is too few for a gear that a rack can generate; use at least %1.</source>
        <translation>Tek diş, kremayerle üretilebilecek bir dişli için çok azdır; en az %1 kullanın.</translation>
    </message>
    <message>
        <source>The pitch cone of a bevel gear must be between %1 and 163 degrees.</source>
        <translation>Konik dişlinin taksimat konisi %1 ile 163 derece arasında olmalıdır.</translation>
    </message>
    <message>
        <source>The face of %1 runs into the apex: make it shorter than %2, a third of the cone distance.</source>
        <translation>%1 diş genişliği koni tepesine giriyor: koni uzunluğunun üçte biri olan %2 değerinden kısa yapın.</translation>
    </message>
    <message>
        <source>%1 teeth leave no body below the roots; use more, or a larger profile shift.</source>
        <translation>%1 diş, diş dibinin altında gövde bırakmıyor; daha çok diş ya da daha büyük profil kaydırma kullanın.</translation>
    </message>
    <message>
        <source>, or give the ring %1 teeth and the planets %2 (then %3 at equal distances fit)</source>
        <translation>, ya da çembere %1, gezegenlere %2 diş verin (o zaman eşit aralıklı %3 gezegen sığar)</translation>
    </message>
    <message>
        <source>, or use %1 planets at equal distances</source>
        <translation>, ya da eşit aralıklı %1 gezegen kullanın</translation>
    </message>
    <message>
        <source>link %1 by %2 degrees</source>
        <translation>%1 uzvunu %2 derece</translation>
    </message>
    <message>
        <source>Equal planets fit at multiples of 360/%1 = %2 degrees: move the axis of %3 round the central axis</source>
        <translation>Eş gezegenler 360/%1 = %2 derecenin katlarında takılabilir: şu eksenleri merkez eksen etrafında kaydırın: %3</translation>
    </message>
    <message>
        <source>%1 degrees on link %2</source>
        <translation>%2 uzvunda %1 derece</translation>
    </message>
    <message>
        <source>Links %1 are drawn as equal planets and cannot be equal parts: with all teeth in mesh, their gear with %2 teeth is turned against that with %3 teeth, compared with link %4, by %5.</source>
        <translation>%1 uzuvları eş gezegenler olarak çizilmiş, ama eş parçalar olamazlar: bütün dişler eşleştiğinde %2 dişli çarkları, %3 dişli olana göre, %4 uzvuyla karşılaştırıldığında şu kadar dönüktür: %5.</translation>
    </message>
    <message>
        <source>With these teeth there are fewer places for equal planets (%1) than planets: let the planets differ, or change tooth counts.</source>
        <translation>Bu dişlerle eş gezegenler için gezegenlerden daha az yer (%1) var: gezegenler farklı olsun ya da diş sayılarını değiştirin.</translation>
    </message>
    <message>
        <source>Planets fit at multiples of 360/%1 = %2 degrees: move that of link %3 by %4 degrees</source>
        <translation>Gezegenler 360/%1 = %2 derecenin katlarına sığar: %3 uzvununkini %4 derece kaydırın</translation>
    </message>
    <message>
        <source>It fits with %1 instead of %2 teeth on gear %3</source>
        <translation>%3 dişlisinde %2 yerine %1 dişle uyar</translation>
    </message>
    <message>
        <source>, or with %1 instead of %2 teeth on gear %3</source>
        <translation>, ya da %3 dişlisinde %2 yerine %1 dişle</translation>
    </message>
    <message>
        <source>Change tooth counts of the loop, or move one of its axes</source>
        <translation>Çevrimin diş sayılarını değiştirin ya da eksenlerinden birini kaydırın</translation>
    </message>
    <message>
        <source>The loop of meshes %1 cannot be assembled as drawn: at mesh %2 the teeth miss each other by %3 of a pitch.</source>
        <translation>%1 dişli çiftlerinin çevrimi çizildiği gibi monte edilemez: %2 dişli çiftinde dişler birbirini adımın %3 kadarıyla kaçırıyor.</translation>
    </message>
    <message>
        <source>The wheels of links %1 and %2 beside gear %3 interfere: their tips overlap by %4 modules.</source>
        <translation>%3 dişlisinin yanındaki %1 ve %2 uzuvlarının dişlileri çakışıyor: diş başları %4 modül üst üste biniyor.</translation>
    </message>
    <message>
        <source>At most %1 of them fit round it, at equal distances.</source>
        <translation>Çevresine eşit aralıkla en çok %1 tanesi sığar.</translation>
    </message>
    <message>
        <source>Move one of them, or give it fewer teeth.</source>
        <translation>Birini kaydırın ya da ona daha az diş verin.</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) has no solid: %3</source>
        <translation>%1 dişlisinin (%2 diş) katı modeli yok: %3</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) is undercut: at a profile shift of %3 a rack needs %4 teeth or more. Use more teeth, or a shift of at least %5.</source>
        <translation>%1 dişlisinde (%2 diş) alttan kesilme var: %3 profil kaydırmada kremayer %4 veya daha çok diş ister. Daha çok diş ya da en az %5 profil kaydırma kullanın.</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) would have pointed teeth: its tips were lowered to keep a land of %3 modules. Use a smaller profile shift than %4.</source>
        <translation>%1 dişlisinin (%2 diş) dişleri sivri olurdu: %3 modül baş kalınlığı kalsın diye başlar alçaltıldı. %4 değerinden küçük profil kaydırma kullanın.</translation>
    </message>
    <message>
        <source>Mesh %1, %2 and %3 teeth</source>
        <translation>%1 dişli çifti, %2 ve %3 diş</translation>
    </message>
    <message>
        <source>%1: a contact ratio of %2, one pair of teeth lets go before the next takes over. Use more teeth, or profile shifts that leave longer flanks, for %3 or more.</source>
        <translation>%1: kavrama oranı %2, bir diş çifti sonraki devralmadan ayrılıyor. %3 veya daha fazlası için daha çok diş ya da daha uzun yanak bırakan profil kaydırmalar kullanın.</translation>
    </message>
    <message>
        <source>%1: a contact ratio of %2, that leaves nothing for errors of the teeth. Use more teeth, or profile shifts that leave longer flanks, for %3 or more.</source>
        <translation>%1: kavrama oranı %2, diş hatalarına pay kalmıyor. %3 veya daha fazlası için daha çok diş ya da daha uzun yanak bırakan profil kaydırmalar kullanın.</translation>
    </message>
    <message>
        <source>%1: a face width of %2 is more than a third of the cone distance, so that the small ends of the teeth are too weak to bear load. Use %3 or less.</source>
        <translation>%1: %2 diş genişliği koni uzunluğunun üçte birinden fazla; dişlerin küçük uçları yük taşıyamayacak kadar zayıf. %3 veya daha azını kullanın.</translation>
    </message>
    <message>
        <source>%1 teeth in a ring of %2: their tips collide outside of the mesh, by %3 modules. Use a difference of more teeth, or a larger profile shift of the ring.</source>
        <translation>%2 dişli çember içinde %1 diş: diş başları kavrama dışında %3 modül çarpışıyor. Daha büyük diş farkı ya da çemberde daha büyük profil kaydırma kullanın.</translation>
    </message>
    <message>
        <source>%1 teeth in a ring of %2: the ring&apos;s tips would interfere with the pinion&apos;s fillets and were lowered by %3 modules. Use a pinion of more teeth, or with a larger profile shift.</source>
        <translation>%2 dişli çember içinde %1 diş: çemberin diş başları pinyonun dip kavislerine girerdi ve %3 modül alçaltıldı. Daha çok dişli ya da daha büyük profil kaydırmalı bir pinyon kullanın.</translation>
    </message>
    <message>
        <source>Gears %1 and %2 overlap and do not mesh.</source>
        <translation>%1 ve %2 dişlileri üst üste biniyor ve eşleşmiyor.</translation>
    </message>
    <message>
        <source>Use smaller face widths, or leave them or a pitch point open.</source>
        <translation>Daha küçük diş genişlikleri kullanın ya da bunları veya bir hatve noktasını açık bırakın.</translation>
    </message>
    <message>
        <source>Move a pitch point on its axes, or leave it open.</source>
        <translation>Bir hatve noktasını eksenleri üzerinde kaydırın ya da açık bırakın.</translation>
    </message>
    <message>
        <source>Move the pitch point of one along its axis, or leave it open.</source>
        <translation>Birinin hatve noktasını ekseni boyunca kaydırın ya da açık bırakın.</translation>
    </message>
    <message>
        <source>No free places along their axes clear them: move an axis, change tooth counts, or state pitch points.</source>
        <translation>Eksenleri boyunca onları ayıran boş yer yok: bir ekseni taşıyın, diş sayılarını değiştirin ya da hatve noktalarını belirtin.</translation>
    </message>
    <message>
        <source>The number is too large; its double would be infinite.</source>
        <translation>Sayı çok büyük; kayan noktalı karşılığı sonsuz olurdu.</translation>
    </message>
    <message>
        <source>A list has at most 100,000 elements; this one has %1.</source>
        <translation>Bir listede en çok 100.000 öğe olur; bunda %1 var.</translation>
    </message>
    <message>
        <source>The member occurs twice in its object; only one may stay.</source>
        <translation>Üye, nesnesinde iki kez geçiyor; yalnız biri kalabilir.</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>%1 sayısı</translation>
    </message>
    <message>
        <source>the string %1</source>
        <translation>%1 dizgesi</translation>
    </message>
    <message>
        <source>a list of %1 elements</source>
        <translation>%1 öğeli bir liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>bir nesne</translation>
    </message>
    <message>
        <source>an id: a string of 1 to 1,000 characters or a whole number</source>
        <translation>bir kimlik: 1-1.000 karakterlik bir dizge ya da bir tam sayı</translation>
    </message>
    <message>
        <source>a number, or a fraction as a string like &quot;22/7&quot;</source>
        <translation>bir sayı ya da &quot;22/7&quot; gibi dizge olarak bir kesir</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>beklenen: %1; bulunan: %2.</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; is missing; expected %2.</source>
        <translation>&quot;%1&quot; üyesi eksik; beklenen: %2.</translation>
    </message>
    <message>
        <source>a list of ids</source>
        <translation>bir kimlik listesi</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>bir dizge</translation>
    </message>
    <message>
        <source>expected at most 1,000 characters, found %1.</source>
        <translation>beklenen: en çok 1.000 karakter; bulunan: %1.</translation>
    </message>
    <message>
        <source>there is no member &quot;%1&quot;; &quot;%2&quot; is meant.</source>
        <translation>&quot;%1&quot; diye bir üye yok; kastedilen &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; has no meaning here.</source>
        <translation>&quot;%1&quot; üyesinin burada anlamı yok.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; in %2 has no meaning beside the others of its object: it is kept and changes nothing.</source>
        <translation>%2 içindeki &quot;%1&quot; üyesinin nesnesinin öteki üyeleri yanında anlamı yok: korunur ve hiçbir şeyi değiştirmez.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; of the document is not known here: it is kept and changes nothing.</source>
        <translation>Belgenin &quot;%1&quot; üyesi burada bilinmiyor: korunur ve hiçbir şeyi değiştirmez.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; in %2 is not known here: it is kept and changes nothing.</source>
        <translation>%2 içindeki &quot;%1&quot; üyesi burada bilinmiyor: korunur ve hiçbir şeyi değiştirmez.</translation>
    </message>
    <message>
        <source>Is &quot;%1&quot; meant?</source>
        <translation>&quot;%1&quot; mi kastedildi?</translation>
    </message>
    <message>
        <source>3D files of links are shown only: they have no mass, and overlaps and collisions with them are not looked for.</source>
        <translation>Uzuvların 3B dosyaları yalnızca gösterilir: kütleleri yoktur, onlarla örtüşme ve çarpışma aranmaz.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; names the 3D file &quot;%2&quot;, which cannot be read.</source>
        <translation>&quot;%1&quot; uzvu, okunamayan &quot;%2&quot; 3B dosyasını adlandırıyor.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; names the 3D file &quot;%2&quot;, which is not there: the path begins at the folder of the document.</source>
        <translation>&quot;%1&quot; uzvu, bulunmayan &quot;%2&quot; 3B dosyasını adlandırıyor: yol belgenin klasöründen başlar.</translation>
    </message>
    <message>
        <source>a list of three numbers</source>
        <translation>üç sayılık bir liste</translation>
    </message>
    <message>
        <source>a list of six numbers, xx, yy, zz, xy, xz, yz</source>
        <translation>altı sayılık bir liste, xx, yy, zz, xy, xz, yz</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true veya false</translation>
    </message>
    <message>
        <source>a list of two, each a number or null</source>
        <translation>her biri sayı veya null olan iki öğelik bir liste</translation>
    </message>
    <message>
        <source>the whole number %1</source>
        <translation>%1 tam sayısı</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1 ile %2 arasında bir tam sayı</translation>
    </message>
    <message>
        <source>The file has version %1, but this program reads version %2: open it with a newer GearGraph.</source>
        <translation>Dosyanın sürümü %1, bu program %2 sürümünü okur: daha yeni bir GearGraph ile açın.</translation>
    </message>
    <message>
        <source>This is not a GearGraph document: the member &quot;format&quot; has to be &quot;geargraph&quot;.</source>
        <translation>Bu bir GearGraph belgesi değil: &quot;format&quot; üyesi &quot;geargraph&quot; olmalıdır.</translation>
    </message>
    <message>
        <source>a list of links, the ground first</source>
        <translation>bir uzuv listesi, önce sabit uzuv</translation>
    </message>
    <message>
        <source>a list of turning joints that tie the links</source>
        <translation>uzuvları bağlayan döner mafsalların listesi</translation>
    </message>
    <message>
        <source>a list of the axes that the turning joints name</source>
        <translation>döner mafsalların andığı eksenlerin listesi</translation>
    </message>
    <message>
        <source>a list of 3D files</source>
        <translation>3B dosyaların listesi</translation>
    </message>
    <message>
        <source>a &quot;mass&quot; beside it</source>
        <translation>yanında bir &quot;mass&quot;</translation>
    </message>
    <message>
        <source>a speed in rad/s</source>
        <translation>rad/s cinsinden bir hız</translation>
    </message>
    <message>
        <source>the name of the state</source>
        <translation>durumun adı</translation>
    </message>
    <message>
        <source>a list of ids of couplings</source>
        <translation>fren ve kavrama kimliklerinin listesi</translation>
    </message>
    <message>
        <source>a list of two ids of links</source>
        <translation>iki uzuv kimliğinin listesi</translation>
    </message>
    <message>
        <source>a torque in N m</source>
        <translation>N m cinsinden bir tork</translation>
    </message>
    <message>
        <source>a torque or a force, not both in one load</source>
        <translation>tork ya da kuvvet, bir yükte ikisi birden değil</translation>
    </message>
    <message>
        <source>the point of the link that the force acts at</source>
        <translation>kuvvetin etkidiği uzuv noktası</translation>
    </message>
    <message>
        <source>a joint or a link, not both</source>
        <translation>mafsal ya da uzuv, ikisi birden değil</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>beklenen: bir liste.</translation>
    </message>
    <message>
        <source>The file has %1 bytes; at most 64 MiB are read.</source>
        <translation>Dosya %1 bayt; en çok 64 MiB okunur.</translation>
    </message>
    <message>
        <source>This is no GearGraph document: the file is not text in UTF-8, but a picture, an archive or the like, or damaged.</source>
        <translation>Bu bir GearGraph belgesi değil: dosya UTF-8 metin değil; bir resim, arşiv ya da benzeri bir dosya veya bozuk.</translation>
    </message>
    <message>
        <source>A centre of mass and an inertia need a &quot;mass&quot; beside them.</source>
        <translation>Kütle merkezi ve atalet, yanlarında bir &quot;mass&quot; ister.</translation>
    </message>
    <message>
        <source>This is no table of a mechanism: its first row has to name the columns, &quot;element&quot; among them.</source>
        <translation>Bu bir mekanizma tablosu değil: ilk satırı, aralarında &quot;element&quot; olan sütunları adlandırmalıdır.</translation>
    </message>
    <message>
        <source>There are too many columns.</source>
        <translation>Sütun sayısı çok fazla.</translation>
    </message>
    <message>
        <source>There is no column &quot;%1&quot;: %2.</source>
        <translation>&quot;%1&quot; diye bir sütun yok: %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs twice.</source>
        <translation>&quot;%1&quot; sütunu iki kez geçiyor.</translation>
    </message>
    <message>
        <source>The column &quot;element&quot; is empty; it says what the row is about.</source>
        <translation>&quot;element&quot; sütunu boş; satırın ne hakkında olduğunu o söyler.</translation>
    </message>
    <message>
        <source>There is no element &quot;%1&quot;: %2.</source>
        <translation>&quot;%1&quot; diye bir öğe yok: %2.</translation>
    </message>
    <message>
        <source>This cell is in a column without a name.</source>
        <translation>Bu hücre adsız bir sütunda.</translation>
    </message>
    <message>
        <source>This row has more cells than there are columns.</source>
        <translation>Bu satırda sütun sayısından fazla hücre var.</translation>
    </message>
    <message>
        <source>There is one row &quot;document&quot; at most.</source>
        <translation>En çok bir &quot;document&quot; satırı olur.</translation>
    </message>
    <message>
        <source>A document has at most 100,000 %1.</source>
        <translation>Bir belgede en çok 100.000 %1 olur.</translation>
    </message>
    <message>
        <source>The row names a &quot;joint&quot; or a &quot;link&quot;, one of them.</source>
        <translation>Satır bir &quot;joint&quot; ya da bir &quot;link&quot; adlandırır, ikisinden birini.</translation>
    </message>
    <message>
        <source>An &quot;axis&quot; is named beside a &quot;link&quot;; a joint has its own.</source>
        <translation>&quot;axis&quot;, bir &quot;link&quot; yanında yazılır; mafsalın kendi ekseni vardır.</translation>
    </message>
    <message>
        <source>A load has a &quot;torque&quot;, or a force (dx, dy, dz) at a point (x, y, z).</source>
        <translation>Bir yükün &quot;torque&quot; değeri ya da (x, y, z) noktasında bir kuvveti (dx, dy, dz) vardır.</translation>
    </message>
    <message>
        <source>A force acts on a &quot;link&quot;: it has dx, dy, dz and a point x, y, z, and no axis.</source>
        <translation>Kuvvet bir &quot;link&quot; üzerine etkir: dx, dy, dz ve x, y, z noktası vardır, ekseni yoktur.</translation>
    </message>
    <message>
        <source>More problems follow; only the first 100 are listed.</source>
        <translation>Başka sorunlar da var; yalnız ilk 100 tanesi listelendi.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; is empty; expected %2.</source>
        <translation>&quot;%1&quot; sütunu boş; beklenen: %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; has %2; expected %3.</source>
        <translation>&quot;%1&quot; sütununda %2 var; beklenen: %3.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; has no meaning for the element &quot;%2&quot;.</source>
        <translation>&quot;%1&quot; sütununun &quot;%2&quot; öğesi için anlamı yok.</translation>
    </message>
    <message>
        <source>an id of at most 1,000 characters</source>
        <translation>en çok 1.000 karakterlik bir kimlik</translation>
    </message>
    <message>
        <source>at most 100,000 ids of 1 to 1,000 characters, with a bar (|) between</source>
        <translation>dikey çizgiyle (|) ayrılmış, 1-1.000 karakterlik en çok 100.000 kimlik</translation>
    </message>
    <message>
        <source>a number, such as 12, -1.5, 1e-3 or 22/7</source>
        <translation>12, -1.5, 1e-3 veya 22/7 gibi bir sayı</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>bir sayı</translation>
    </message>
    <message>
        <source>a number of teeth</source>
        <translation>bir diş sayısı</translation>
    </message>
    <message>
        <source>a whole number from 1 to 100,000</source>
        <translation>1 ile 100.000 arasında bir tam sayı</translation>
    </message>
    <message>
        <source>yes, no or nothing</source>
        <translation>yes, no ya da boş</translation>
    </message>
    <message>
        <source>an id</source>
        <translation>bir kimlik</translation>
    </message>
    <message>
        <source>a number, as its neighbours have one</source>
        <translation>komşularında olduğu gibi bir sayı</translation>
    </message>
    <message>
        <source>an attached 3D file</source>
        <translation>ekli bir 3B dosya</translation>
    </message>
    <message>
        <source>%1 attached 3D files</source>
        <translation>%1 ekli 3B dosya</translation>
    </message>
    <message>
        <source>the view (places in the drawings, camera of the 3D view)</source>
        <translation>görünüm (çizimlerdeki yerler, 3B görünümün kamerası)</translation>
    </message>
    <message>
        <source>members that this program does not know</source>
        <translation>bu programın bilmediği üyeler</translation>
    </message>
    <message>
        <source>the empty name of the unit, which becomes &quot;mm&quot;</source>
        <translation>birimin boş adı, &quot;mm&quot; olur</translation>
    </message>
    <message>
        <source>a path that stays in the folder of this document</source>
        <translation>bu belgenin klasöründe kalan bir yol</translation>
    </message>
    <message>
        <source>an object of points by the id of their link</source>
        <translation>uzuv kimliğine göre noktalar nesnesi</translation>
    </message>
    <message>
        <source>expected the point of a node: a list of two numbers, x to the right and y down.</source>
        <translation>beklenen: bir düğümün noktası, iki sayılık bir liste, x sağa ve y aşağı.</translation>
    </message>
    <message>
        <source>a list of notes</source>
        <translation>bir not listesi</translation>
    </message>
    <message>
        <source>the text of the note</source>
        <translation>notun metni</translation>
    </message>
    <message>
        <source>the middle of the note</source>
        <translation>notun ortası</translation>
    </message>
    <message>
        <source>a list of two numbers, x to the right and y down</source>
        <translation>iki sayılık bir liste, x sağa ve y aşağı</translation>
    </message>
    <message>
        <source>the point that the camera looks at</source>
        <translation>kameranın baktığı nokta</translation>
    </message>
    <message>
        <source>an angle in degrees</source>
        <translation>derece cinsinden bir açı</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>0&apos;dan büyük bir sayı</translation>
    </message>
    <message>
        <source>The axis would coincide with the one that its wheels mesh with.</source>
        <translation>Eksen, dişlilerinin birlikte çalıştığı eksenle çakışırdı.</translation>
    </message>
    <message>
        <source>There is no place for axis %1 where the wheels of meshes %2 would touch at these tooth counts. What fits: a smaller change, or other teeth first.</source>
        <translation>%1 ekseni için, %2 dişli çiftlerinin dişlilerinin bu diş sayılarıyla değeceği bir yer yok. Daha küçük bir değişiklik ya da önce başka diş sayıları uyar.</translation>
    </message>
    <message>
        <source>Mesh %1 is no bevel pair: only bevels have an apex with two sides.</source>
        <translation>%1 dişli çifti konik değil: iki yanı olan bir tepe yalnız koniklerde vardır.</translation>
    </message>
    <message>
        <source>A module is more than 0: the pitch diameter over the teeth.</source>
        <translation>Modül 0&apos;dan büyüktür: taksimat dairesi çapı bölü diş sayısı.</translation>
    </message>
    <message>
        <source>Modules can be set where every mesh has its place, in trains of up to %1 meshes. Resolve the reported problems first.</source>
        <translation>Modüller, her dişli çiftinin yeri belliyse ve en çok %1 dişli çifti olan takımlarda verilebilir. Önce bildirilen sorunları giderin.</translation>
    </message>
    <message>
        <source>Mesh %1 cannot follow: %2 is pinned. What fits: unpin it, or another change.</source>
        <translation>%1 dişli çifti izleyemiyor: %2 sabitlenmiş. Sabitlemeyi kaldırın ya da başka bir değişiklik yapın.</translation>
    </message>
    <message>
        <source>Mesh %1 cannot follow: %2 are pinned. What fits: unpin one of them, or another change.</source>
        <translation>%1 dişli çifti izleyemiyor: %2 sabitlenmiş. Birinin sabitlemesini kaldırın ya da başka bir değişiklik yapın.</translation>
    </message>
    <message>
        <source>The module of mesh %1 is pinned, and would change. What fits: unpin it, or another change.</source>
        <translation>%1 dişli çiftinin modülü sabitlenmiş ve değişecekti. Sabitlemeyi kaldırın ya da başka bir değişiklik yapın.</translation>
    </message>
    <message>
        <source>Axis %1 is pinned. What fits: unpin it to move it.</source>
        <translation>%1 ekseni sabitlenmiş. Kaydırmak için sabitlemeyi kaldırın.</translation>
    </message>
    <message>
        <source>gear %1 would need %2 teeth to stay coaxial. What fits: a smaller change.</source>
        <translation>%1 dişlisinin eş eksenli kalması için %2 dişi olmalı. Daha küçük bir değişiklik uyar.</translation>
    </message>
    <message>
        <source>an internal pair needs different tooth counts, the ring the larger one.</source>
        <translation>iç çiftte diş sayıları farklı olmalı, büyük olan çemberde.</translation>
    </message>
    <message>
        <source>The comment has no end.</source>
        <translation>Yorumun sonu yok.</translation>
    </message>
    <message>
        <source>This character is no part of DOT.</source>
        <translation>Bu karakter DOT&apos;a ait değil.</translation>
    </message>
    <message>
        <source>The quote has no end.</source>
        <translation>Tırnağın sonu yok.</translation>
    </message>
    <message>
        <source>The text in angle brackets has no end.</source>
        <translation>Açılı ayraç içindeki metnin sonu yok.</translation>
    </message>
    <message>
        <source>This is no number.</source>
        <translation>Bu bir sayı değil.</translation>
    </message>
    <message>
        <source>The text is not UTF-8.</source>
        <translation>Metin UTF-8 değil.</translation>
    </message>
    <message>
        <source>Behind the graph is something else; a file with one graph is read.</source>
        <translation>Graftan sonra başka bir şey var; tek grafı olan dosya okunur.</translation>
    </message>
    <message>
        <source>Expected %1, found the end.</source>
        <translation>Beklenen: %1, bulunan: dosya sonu.</translation>
    </message>
    <message>
        <source>Expected %1, found %2.</source>
        <translation>Beklenen: %1, bulunan: %2.</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>bir ad</translation>
    </message>
    <message>
        <source>a quoted text</source>
        <translation>tırnak içinde bir metin</translation>
    </message>
    <message>
        <source>Groups are nested deeper than 64.</source>
        <translation>Gruplar 64 düzeyden derin iç içe geçmiş.</translation>
    </message>
    <message>
        <source>An edge between groups is not read; write an edge for each joint and mesh.</source>
        <translation>Gruplar arasındaki kenar okunmaz; her mafsal ve dişli çifti için bir kenar yazın.</translation>
    </message>
    <message>
        <source>An edge of a directed graph is written -&gt;.</source>
        <translation>Yönlü bir grafın kenarı -&gt; ile yazılır.</translation>
    </message>
    <message>
        <source>The graph is strict, and a second edge leads from %1 to %2: it would be one with the first. Leave out &quot;strict&quot;.</source>
        <translation>Graf &quot;strict&quot; ve %1 ile %2 arasında ikinci bir kenar var: birincisiyle aynı sayılırdı. &quot;strict&quot; sözcüğünü çıkarın.</translation>
    </message>
    <message>
        <source>A graph of at most 200,000 edges is read.</source>
        <translation>En çok 200.000 kenarlı graf okunur.</translation>
    </message>
    <message>
        <source>A graph of at most 100,000 nodes is read.</source>
        <translation>En çok 100.000 düğümlü graf okunur.</translation>
    </message>
    <message>
        <source>The graph is undirected, so that it does not say which link of a joint or mesh is tail and which is head: the signs and the teeth of each gear depend on it. Make it directed.</source>
        <translation>Graf yönsüz; bu yüzden bir mafsalın veya dişli çiftinin hangi uzvunun kuyruk, hangisinin baş olduğunu söylemiyor: işaretler ve her dişlinin diş sayısı buna bağlıdır. Grafı yönlü yapın.</translation>
    </message>
    <message>
        <source>This is no XML: %1.</source>
        <translation>Bu XML değil: %1.</translation>
    </message>
    <message>
        <source>There is no &lt;graph&gt; in the file.</source>
        <translation>Dosyada &lt;graph&gt; yok.</translation>
    </message>
    <message>
        <source>A file with a document type (&lt;!DOCTYPE&gt;) is not read; leave it out.</source>
        <translation>Belge türü (&lt;!DOCTYPE&gt;) olan dosya okunmaz; onu çıkarın.</translation>
    </message>
    <message>
        <source>The element &lt;%1&gt; lacks the attribute &quot;%2&quot;.</source>
        <translation>&lt;%1&gt; öğesinde &quot;%2&quot; özniteliği eksik.</translation>
    </message>
    <message>
        <source>Elements are nested deeper than 64.</source>
        <translation>Öğeler 64 düzeyden derin iç içe geçmiş.</translation>
    </message>
    <message>
        <source>This is no GraphML: it begins with &lt;%1&gt;.</source>
        <translation>Bu GraphML değil: &lt;%1&gt; ile başlıyor.</translation>
    </message>
    <message>
        <source>A hyperedge is not read; a joint and a mesh are edges between two nodes.</source>
        <translation>Hiperkenar okunmaz; mafsal ve dişli çifti iki düğüm arasında bir kenardır.</translation>
    </message>
    <message>
        <source>A file with one graph is read, without graphs inside its nodes.</source>
        <translation>Düğümlerinin içinde graf olmayan, tek graflı dosya okunur.</translation>
    </message>
    <message>
        <source>The graph has no node; the first one is the ground.</source>
        <translation>Grafın düğümü yok; ilki sabit uzuvdur.</translation>
    </message>
    <message>
        <source>The graph has version %1, but this program reads version %2: read it with a newer GearGraph.</source>
        <translation>Grafın sürümü %1, bu program ise %2 sürümünü okur: daha yeni bir GearGraph ile okuyun.</translation>
    </message>
    <message>
        <source>The ground is the first node, %1.</source>
        <translation>Sabit uzuv ilk düğümdür: %1.</translation>
    </message>
    <message>
        <source>The edge %1 (%2)</source>
        <translation>%1 kenarı (%2)</translation>
    </message>
    <message>
        <source>The edge %1</source>
        <translation>%1 kenarı</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;kind&quot;; expected &quot;turning&quot; or &quot;mesh&quot;.</source>
        <translation>%1: &quot;kind&quot; özniteliği eksik; beklenen: &quot;turning&quot; veya &quot;mesh&quot;.</translation>
    </message>
    <message>
        <source>%1: its &quot;kind&quot; is %2, so this is a T-T graph; the digraph (--view digraph) is read back.</source>
        <translation>%1: &quot;kind&quot; değeri %2, yani bu bir T-T grafı; geri okunan yönlü graftır (--view digraph).</translation>
    </message>
    <message>
        <source>%1: its &quot;kind&quot; is %2; expected &quot;turning&quot; or &quot;mesh&quot;.</source>
        <translation>%1: &quot;kind&quot; değeri %2; beklenen: &quot;turning&quot; veya &quot;mesh&quot;.</translation>
    </message>
    <message>
        <source>As a document the graph has more than 64 MiB.</source>
        <translation>Graf belge olarak 64 MiB&apos;tan büyük.</translation>
    </message>
    <message>
        <source>%1, %2: expected a list or an object as JSON, found %3.</source>
        <translation>%1, %2: beklenen: JSON olarak bir liste veya nesne, bulunan: %3.</translation>
    </message>
    <message>
        <source>The graph</source>
        <translation>Graf</translation>
    </message>
    <message>
        <source>The node %1</source>
        <translation>%1 düğümü</translation>
    </message>
    <message>
        <source>%1 is in the graph twice.</source>
        <translation>%1 grafta iki kez geçiyor.</translation>
    </message>
    <message>
        <source>The graph has no places of axes: %1 are placed from the tooth counts.</source>
        <translation>Grafta eksenlerin yeri yok: %1 diş sayılarından yerleştirilir.</translation>
    </message>
    <message>
        <source>1 mesh has no &quot;meshKind&quot;: external between parallel axes, bevel between intersecting ones.</source>
        <translation>1 dişli çiftinde &quot;meshKind&quot; yok: paralel eksenler arasında dış, kesişen eksenler arasında konik.</translation>
    </message>
    <message>
        <source>%1 meshes have no &quot;meshKind&quot;: external between parallel axes, bevel between intersecting ones.</source>
        <translation>%1 dişli çiftinde &quot;meshKind&quot; yok: paralel eksenler arasında dış, kesişen eksenler arasında konik.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the name of the axis that the joint turns about, the same for joints on one axis.</source>
        <translation>%1: &quot;%2&quot; özniteliği eksik: mafsalın etrafında döndüğü eksenin adı; aynı eksendeki mafsallarda aynıdır.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the number of teeth of the gear on its first node.</source>
        <translation>%1: &quot;%2&quot; özniteliği eksik: ilk düğümdeki dişlinin diş sayısı.</translation>
    </message>
    <message>
        <source>%1 lacks the attribute &quot;%2&quot;: the number of teeth of the gear on its second node.</source>
        <translation>%1: &quot;%2&quot; özniteliği eksik: ikinci düğümdeki dişlinin diş sayısı.</translation>
    </message>
    <message>
        <source>%1: there is no node %2.</source>
        <translation>%1: %2 düğümü yok.</translation>
    </message>
    <message>
        <source>Attributes without a meaning for the mechanism were not read: %1.</source>
        <translation>Mekanizma için anlamı olmayan öznitelikler okunmadı: %1.</translation>
    </message>
    <message>
        <source>A graph of at most 100,000 nodes and 200,000 edges is read.</source>
        <translation>En çok 100.000 düğümlü ve 200.000 kenarlı graf okunur.</translation>
    </message>
    <message>
        <source>This is no node-link graph: it is an object with the lists &quot;nodes&quot; and &quot;links&quot;.</source>
        <translation>Bu bir node-link grafı değil: o, &quot;nodes&quot; ve &quot;links&quot; listeleri olan bir nesnedir.</translation>
    </message>
    <message>
        <source>Expected an object with &quot;%1&quot;, a text or a number that names a node.</source>
        <translation>Beklenen: bir düğümü adlandıran metin veya sayı olan &quot;%1&quot; üyeli bir nesne.</translation>
    </message>
    <message>
        <source>%1 link</source>
        <translation>%1 uzuv</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 eklendi</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 kaldırıldı</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 değişti</translation>
    </message>
    <message>
        <source>axes changed</source>
        <translation>eksenler değişti</translation>
    </message>
    <message>
        <source>inputs changed</source>
        <translation>girişler değişti</translation>
    </message>
    <message>
        <source>links moved in the drawing</source>
        <translation>uzuvlar çizimde kaydırıldı</translation>
    </message>
    <message>
        <source>other properties changed</source>
        <translation>başka özellikler değişti</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>hiçbir şey</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot; in %2.</source>
        <translation>%2 içinde &quot;%1&quot; yok.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>%1 uzvundan %2 uzvuna bir döner mafsal çevrim kapatırdı. Döner mafsallar ağaç olmalıdır: yerine bir dişli çifti çizin.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop with joint %3. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>%1 uzvundan %2 uzvuna bir döner mafsal, %3 mafsalıyla çevrim kapatırdı. Döner mafsallar ağaç olmalıdır: yerine bir dişli çifti çizin.</translation>
    </message>
    <message>
        <source>A turning joint from link %1 to link %2 would close a loop with joints %3. The turning joints have to be a tree: draw a gear mesh instead.</source>
        <translation>%1 uzvundan %2 uzvuna bir döner mafsal, %3 mafsallarıyla çevrim kapatırdı. Döner mafsallar ağaç olmalıdır: yerine bir dişli çifti çizin.</translation>
    </message>
    <message>
        <source>A turning joint needs two different links.</source>
        <translation>Döner mafsal iki ayrı uzuv ister.</translation>
    </message>
    <message>
        <source>To split link %1, choose some of its joints and meshes, and leave others: the new link takes those that you choose.</source>
        <translation>%1 uzvunu bölmek için bazı mafsallarını ve dişli çiftlerini seçin, ötekileri bırakın: yeni uzuv seçtiklerinizi alır.</translation>
    </message>
    <message>
        <source>Link %1 turns on no other link, so that its parts have no axis: draw its joint first.</source>
        <translation>%1 uzvu başka bir uzuv üzerinde dönmüyor, bu yüzden parçalarının ekseni yok: önce mafsalını çizin.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint, mesh or coupling of link %2.</source>
        <translation>&quot;%1&quot;, %2 uzvunun mafsalı, dişli çifti ya da kavraması değil.</translation>
    </message>
    <message>
        <source>The ground cannot be split: nothing says about which axis its part turns.</source>
        <translation>Sabit uzuv bölünemez: parçasının hangi eksende döneceğini gösteren bir şey yok.</translation>
    </message>
    <message>
        <source>A weld needs two different links.</source>
        <translation>Kaynak için iki farklı uzuv gerekir.</translation>
    </message>
    <message>
        <source>Links %1 and %2 cannot be one: both wheels of mesh %3 would turn about one axis.</source>
        <translation>%1 ve %2 uzuvları tek uzuv olamaz: %3 dişli çiftinin iki dişlisi de aynı eksende dönerdi.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are in different places of one train, so that links %3 and %4 cannot be one: lay one axis on the other first.</source>
        <translation>%1 ve %2 eksenleri aynı takımın farklı yerlerinde, bu yüzden %3 ve %4 uzuvları tek uzuv olamaz: önce bir ekseni ötekinin üzerine koyun.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 have different directions, so that links %3 and %4 cannot be one: lay one axis along the other first.</source>
        <translation>%1 ve %2 eksenlerinin doğrultuları farklı, bu yüzden %3 ve %4 uzuvları tek uzuv olamaz: önce bir ekseni ötekinin doğrultusuna koyun.</translation>
    </message>
    <message>
        <source>The limits of joints %1 and %2 leave the welded link no angle to turn: change them first.</source>
        <translation>%1 ve %2 mafsallarının sınırları kaynaklanan uzva dönecek açı bırakmıyor: önce onları değiştirin.</translation>
    </message>
    <message>
        <source>Links %1 and %2 cannot be one: it would turn about several axes. Links are welded whose joints can lie on one axis.</source>
        <translation>%1 ve %2 uzuvları tek uzuv olamaz: birkaç eksende dönerdi. Mafsalları tek eksende olabilen uzuvlar kaynaklanır.</translation>
    </message>
    <message>
        <source>A load or balance is in joint %1, which the weld takes away: remove it first.</source>
        <translation>Kaynakla kalkacak %1 mafsalında bir yük ya da denge var: önce onu kaldırın.</translation>
    </message>
    <message>
        <source>The mass of link %1 is stated, and would be that of a part only: remove it before you weld the link.</source>
        <translation>%1 uzvunun kütlesi verilmiş ve yalnız bir parçanınki olurdu: uzvu kaynaklamadan önce kaldırın.</translation>
    </message>
    <message>
        <source>Links %1 and %2 mesh with each other in mesh %3: delete it before you weld them.</source>
        <translation>%1 ve %2 uzuvları %3 dişli çiftinde birbiriyle çalışıyor: kaynaklamadan önce onu silin.</translation>
    </message>
    <message>
        <source>A gear mesh needs two different links.</source>
        <translation>Dişli çifti iki ayrı uzuv ister.</translation>
    </message>
    <message>
        <source>The ground cannot be deleted; make another link the ground first.</source>
        <translation>Sabit uzuv silinemez; önce başka bir uzvu sabit uzuv yapın.</translation>
    </message>
    <message>
        <source>Only links and axes bear names; the others bear the paper&apos;s labels.</source>
        <translation>Yalnız uzuvlar ve eksenler ad taşır; ötekiler makaledeki etiketleri taşır.</translation>
    </message>
    <message>
        <source>An axis needs a name.</source>
        <translation>Eksen bir ad ister.</translation>
    </message>
    <message>
        <source>There is an axis &quot;%1&quot; already.</source>
        <translation>&quot;%1&quot; ekseni zaten var.</translation>
    </message>
    <message>
        <source>A gear has 1 to 100,000 teeth, not %1.</source>
        <translation>Bir dişlinin 1 ile 100.000 arası dişi olur, %1 olmaz.</translation>
    </message>
    <message>
        <source>The direction of axis %1 has length 0.</source>
        <translation>%1 ekseninin doğrultusunun uzunluğu 0.</translation>
    </message>
    <message>
        <source>The joint is an input already.</source>
        <translation>Mafsal zaten bir giriş.</translation>
    </message>
    <message>
        <source>Loads or balances act on this link, and the ground can have none: remove them first.</source>
        <translation>Bu uzva yükler veya dengeler etkiyor; sabit uzuvda olamazlar: önce onları kaldırın.</translation>
    </message>
    <message>
        <source>There is no link or note in what was copied.</source>
        <translation>Kopyalananda uzuv ya da not yok.</translation>
    </message>
    <message>
        <source>A name has at most 1,000 characters; this one has %1.</source>
        <translation>Bir ad en çok 1.000 karakter olur; bu %1 karakter.</translation>
    </message>
    <message>
        <source>A document has at most 100,000 %1; this one has %2.</source>
        <translation>Bir belgede en çok 100.000 %1 olur; bunda %2 var.</translation>
    </message>
    <message>
        <source>expected a coordinate from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir koordinat.</translation>
    </message>
    <message>
        <source>expected a number from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir sayı.</translation>
    </message>
    <message>
        <source>expected a component from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir bileşen.</translation>
    </message>
    <message>
        <source>expected a length from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir uzunluk.</translation>
    </message>
    <message>
        <source>expected a density from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir yoğunluk.</translation>
    </message>
    <message>
        <source>expected a mass from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir kütle.</translation>
    </message>
    <message>
        <source>expected a moment from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir atalet momenti.</translation>
    </message>
    <message>
        <source>expected a torque from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir tork.</translation>
    </message>
    <message>
        <source>expected a force from -1e15 to 1e15.</source>
        <translation>beklenen: -1e15 ile 1e15 arasında bir kuvvet.</translation>
    </message>
    <message>
        <source>expected a direction with a component of at least 1e-15.</source>
        <translation>beklenen: bir bileşeni en az 1e-15 olan bir doğrultu.</translation>
    </message>
    <message>
        <source>A mass is at least 0, in kg.</source>
        <translation>Kütle en az 0&apos;dır, kg cinsinden.</translation>
    </message>
    <message>
        <source>No body has this inertia: each principal moment is at least 0 and at most the sum of the other two. The numbers are xx, yy, zz, xy, xz, yz in kg m², about the centre of mass.</source>
        <translation>Hiçbir cismin ataleti böyle değildir: her asal moment en az 0 ve en çok öteki ikisinin toplamıdır. Sayılar xx, yy, zz, xy, xz, yz; kg m² cinsinden, kütle merkezine göre.</translation>
    </message>
    <message>
        <source>%1 names &quot;%2&quot;, but %3 has no such id.</source>
        <translation>%1, &quot;%2&quot; adını anıyor, ama %3 içinde böyle bir kimlik yok.</translation>
    </message>
    <message>
        <source>The ground takes any load: %1 are on moving links. Name one of those.</source>
        <translation>Sabit uzuv her yükü karşılar: %1 hareketli uzuvlar içindir. Onlardan birini yazın.</translation>
    </message>
    <message>
        <source>The id &quot;%1&quot; occurs twice in %2.</source>
        <translation>&quot;%1&quot; kimliği %2 içinde iki kez geçiyor.</translation>
    </message>
    <message>
        <source>The joint &quot;%1&quot; occurs twice in %2.</source>
        <translation>&quot;%1&quot; mafsalı %2 içinde iki kez geçiyor.</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; occurs twice in %2.</source>
        <translation>&quot;%1&quot; uzvu %2 içinde iki kez geçiyor.</translation>
    </message>
    <message>
        <source>A mesh has an efficiency or a coefficient of friction, not both.</source>
        <translation>Bir dişli çiftinin ya verimi ya sürtünme katsayısı olur, ikisi birden olmaz.</translation>
    </message>
    <message>
        <source>A coefficient of friction is from 0 to 1.</source>
        <translation>Sürtünme katsayısı 0 ile 1 arasındadır.</translation>
    </message>
    <message>
        <source>A density is above 0, in kg/m³.</source>
        <translation>Yoğunluk 0&apos;dan büyüktür, kg/m³ cinsinden.</translation>
    </message>
    <message>
        <source>There is no note &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; diye bir not yok.</translation>
    </message>
    <message>
        <source>A document has at most 1,000 notes; this one has %1.</source>
        <translation>Bir belgede en çok 1.000 not olur; bunda %1 var.</translation>
    </message>
    <message>
        <source>A note has at most 1,000 characters; this one has %1.</source>
        <translation>Bir not en çok 1.000 karakter olur; bu %1 karakter.</translation>
    </message>
    <message>
        <source>A note needs a text.</source>
        <translation>Not bir metin ister.</translation>
    </message>
    <message>
        <source>A note is lines of text without control characters.</source>
        <translation>Not, denetim karakteri içermeyen metin satırlarıdır.</translation>
    </message>
    <message>
        <source>There is no axis, link or mesh &quot;%1&quot; to pin.</source>
        <translation>Sabitlenecek &quot;%1&quot; diye bir eksen, uzuv veya dişli çifti yok.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the folder of the document: save the document first, then copy the 3D file into its folder.</source>
        <translation>&quot;%1&quot; belgenin klasöründe değil: önce belgeyi kaydedin, sonra 3B dosyayı onun klasörüne kopyalayın.</translation>
    </message>
    <message>
        <source>The scale of a 3D file has to be above 0.</source>
        <translation>3B dosyanın ölçeği 0&apos;dan büyük olmalıdır.</translation>
    </message>
    <message>
        <source>There is a coupling &quot;%1&quot; already.</source>
        <translation>&quot;%1&quot; adlı fren veya kavrama zaten var.</translation>
    </message>
    <message>
        <source>The ground does not move: a brake is for a moving link.</source>
        <translation>Sabit uzuv hareket etmez: fren hareketli bir uzuv içindir.</translation>
    </message>
    <message>
        <source>A clutch needs two different links.</source>
        <translation>Kavrama iki ayrı uzuv ister.</translation>
    </message>
    <message>
        <source>A coupling needs a name.</source>
        <translation>Fren veya kavrama bir ad ister.</translation>
    </message>
    <message>
        <source>A state needs a name.</source>
        <translation>Durum bir ad ister.</translation>
    </message>
    <message>
        <source>There is a state &quot;%1&quot; already.</source>
        <translation>&quot;%1&quot; durumu zaten var.</translation>
    </message>
    <message>
        <source>Coupling &quot;%1&quot; is listed twice.</source>
        <translation>&quot;%1&quot; elemanı iki kez yazılmış.</translation>
    </message>
    <message>
        <source>A mechanism needs at least the ground.</source>
        <translation>Mekanizmada en azından sabit uzuv olmalıdır.</translation>
    </message>
    <message>
        <source>An id may not be empty.</source>
        <translation>Kimlik boş olamaz.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; names &quot;%3&quot;, but %4 has no such id.</source>
        <translation>%1 &quot;%2&quot;, &quot;%3&quot; adını anıyor, ama %4 içinde böyle bir kimlik yok.</translation>
    </message>
    <message>
        <source>The 3D file of a link is a path that stays in the folder of the document, not &quot;%1&quot;.</source>
        <translation>Bir uzvun 3B dosyası, belgenin klasöründe kalan bir yoldur, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>Turning joint &quot;%1&quot; ties link &quot;%2&quot; to itself; it needs two links.</source>
        <translation>&quot;%1&quot; döner mafsalı &quot;%2&quot; uzvunu kendisine bağlıyor; iki uzuv ister.</translation>
    </message>
    <message>
        <source>Gear mesh &quot;%1&quot; ties link &quot;%2&quot; to itself; it needs two links.</source>
        <translation>&quot;%1&quot; dişli çifti &quot;%2&quot; uzvunu kendisine bağlıyor; iki uzuv ister.</translation>
    </message>
    <message>
        <source>The face width of a gear mesh is above 0.</source>
        <translation>Dişli çiftinin diş genişliği 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>A gear has 1 to 100,000 teeth; mesh &quot;%1&quot; says %2.</source>
        <translation>Bir dişlinin 1 ile 100.000 arası dişi olur; &quot;%1&quot; dişli çifti %2 diyor.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; is on link &quot;%2&quot;, but its wheel &quot;%3&quot; is on link &quot;%4&quot;.</source>
        <translation>&quot;%1&quot; dişli çifti &quot;%2&quot; uzvunda, ama dişlisi &quot;%3&quot;, &quot;%4&quot; uzvunda.</translation>
    </message>
    <message>
        <source>A brake names one link, a clutch two.</source>
        <translation>Fren bir uzuv, kavrama iki uzuv adlandırır.</translation>
    </message>
    <message>
        <source>Clutch &quot;%1&quot; ties link &quot;%2&quot; to itself.</source>
        <translation>&quot;%1&quot; kavraması &quot;%2&quot; uzvunu kendisine bağlıyor.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; occurs twice in %2.</source>
        <translation>&quot;%1&quot; adı %2 içinde iki kez geçiyor.</translation>
    </message>
    <message>
        <source>Coupling &quot;%1&quot; is listed twice in %2.</source>
        <translation>&quot;%1&quot; elemanı %2 içinde iki kez yazılmış.</translation>
    </message>
    <message>
        <source>The distance of the camera has to be above 0.</source>
        <translation>Kameranın uzaklığı 0&apos;dan büyük olmalıdır.</translation>
    </message>
    <message>
        <source>The limits of a joint are two angles from the reference pose, in degrees: the first at most 0, the second at least 0, and not both 0.</source>
        <translation>Bir mafsalın sınırları, referans konumdan derece cinsinden iki açıdır: ilki en çok 0, ikincisi en az 0, ikisi birden 0 olamaz.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are one line held by a common link: they are treated as one axis, with opposite directions.</source>
        <translation>%1 ve %2 eksenleri ortak bir uzvun tuttuğu tek bir doğrudur: zıt yönlü tek eksen sayılırlar.</translation>
    </message>
    <message>
        <source>Axes %1 and %2 are one line held by a common link: they are treated as one axis.</source>
        <translation>%1 ve %2 eksenleri ortak bir uzvun tuttuğu tek bir doğrudur: tek eksen sayılırlar.</translation>
    </message>
    <message>
        <source>Axis %1 is named by joints that share no link on it (%2 ...): they coincide in the drawn pose only and are treated as different axes. Give each its own axis.</source>
        <translation>%1 eksenini, üzerinde ortak uzvu olmayan mafsallar anıyor (%2 ...): yalnız çizilen konumda çakışırlar ve ayrı eksenler sayılırlar. Her birine kendi eksenini verin.</translation>
    </message>
    <message>
        <source>Mesh %1 (%2) joins two gears on the same axis %3: coaxial gears cannot mesh. Move one of them to another axis, or delete the mesh.</source>
        <translation>%1 dişli çifti (%2) aynı %3 eksenindeki iki dişliyi bağlıyor: eş eksenli dişliler birlikte çalışamaz. Birini başka bir eksene alın ya da dişli çiftini silin.</translation>
    </message>
    <message>
        <source>Mesh %1 (%2) has no carrier: the path between its gears changes axis more than once, %3. One link must carry both axes, so that their distance is constant.</source>
        <translation>%1 dişli çiftinin (%2) taşıyıcısı yok: dişlileri arasındaki yol ekseni birden çok kez değiştiriyor, %3. Aralarındaki uzaklık sabit kalsın diye iki ekseni de bir uzuv taşımalıdır.</translation>
    </message>
    <message>
        <source>the drawings</source>
        <translation>çizimler</translation>
    </message>
    <message>
        <source>the matrices</source>
        <translation>matrisler</translation>
    </message>
    <message>
        <source>the exercises</source>
        <translation>alıştırmalar</translation>
    </message>
    <message>
        <source>the key of the exercises</source>
        <translation>alıştırmaların anahtarı</translation>
    </message>
    <message>
        <source>the mechanism&apos;s data</source>
        <translation>mekanizmanın verileri</translation>
    </message>
    <message>
        <source>the still picture</source>
        <translation>durağan resim</translation>
    </message>
    <message>
        <source>the solids</source>
        <translation>katı modeller</translation>
    </message>
    <message>
        <source>The handout would have %1 MB; a page has at most 3 MB. The largest part: %2.</source>
        <translation>Ders notu %1 MB olurdu; bir sayfa en çok 3 MB&apos;tır. En büyük bölüm: %2.</translation>
    </message>
    <message>
        <source>Reading it took longer than %1 s.</source>
        <translation>Okuma %1 s&apos;den uzun sürdü.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: the program that reads it crashed, and was confined.</source>
        <translation>Bozuk ya da zarar vermek için yapılmış: onu okuyan program çöktü, kısıtlı çalışıyordu.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: the program that reads it crashed. This system does not confine it.</source>
        <translation>Dosya bozuk veya zarar vermek için yapılmış: onu okuyan program çöktü. Bu sistem onu yalıtmıyor.</translation>
    </message>
    <message>
        <source>Reading it was stopped.</source>
        <translation>Okuma durduruldu.</translation>
    </message>
    <message>
        <source>The program geargraph-mesh cannot be run.</source>
        <translation>geargraph-mesh programı çalıştırılamıyor.</translation>
    </message>
    <message>
        <source>There are too many open files.</source>
        <translation>Çok fazla açık dosya var.</translation>
    </message>
    <message>
        <source>It is not there.</source>
        <translation>Yerinde değil.</translation>
    </message>
    <message>
        <source>It cannot be opened.</source>
        <translation>Açılamıyor.</translation>
    </message>
    <message>
        <source>It is no file.</source>
        <translation>Bir dosya değil.</translation>
    </message>
    <message>
        <source>It has %1 bytes, more than the limit of %2.</source>
        <translation>%1 bayt; sınır olan %2 baytı aşıyor.</translation>
    </message>
    <message>
        <source>It is damaged, or made to do harm: what the program that reads it answers is no solid.</source>
        <translation>Bozuk ya da zarar vermek için yapılmış: onu okuyan programın yanıtı katı model değil.</translation>
    </message>
    <message>
        <source>It is none of STL, OBJ, PLY and GLB.</source>
        <translation>STL, OBJ, PLY veya GLB değil.</translation>
    </message>
    <message>
        <source>The program geargraph-mesh, which reads 3D files, is missing.</source>
        <translation>3B dosyaları okuyan geargraph-mesh programı eksik.</translation>
    </message>
    <message>
        <source>Too wide for this page; the web page and LaTeX hold it whole.</source>
        <translation>Bu sayfaya sığmayacak kadar geniş; web sayfası ve LaTeX tümünü içerir.</translation>
    </message>
    <message>
        <source>There is not enough memory for the pages.</source>
        <translation>Sayfalar için yeterli bellek yok.</translation>
    </message>
    <message>
        <source>No 3D pictures: %1. On Debian, the package libgl1-mesa-dri brings what is missing.</source>
        <translation>3B resim yok: %1. Debian&apos;da eksik olanı libgl1-mesa-dri paketi getirir.</translation>
    </message>
    <message>
        <source>EGL finds no device</source>
        <translation>EGL aygıt bulamıyor</translation>
    </message>
    <message>
        <source>EGL has no desktop OpenGL</source>
        <translation>EGL&apos;de masaüstü OpenGL yok</translation>
    </message>
    <message>
        <source>EGL has no OpenGL configuration</source>
        <translation>EGL&apos;de OpenGL yapılandırması yok</translation>
    </message>
    <message>
        <source>there is no OpenGL 3.3 core</source>
        <translation>OpenGL 3.3 çekirdeği yok</translation>
    </message>
    <message>
        <source>the driver cannot paint without a window</source>
        <translation>sürücü pencere olmadan çizemiyor</translation>
    </message>
    <message>
        <source>No 3D pictures: %1. Install a driver with OpenGL 3.3 or newer.</source>
        <translation>3B resim yok: %1. OpenGL 3.3 veya daha yeni bir sürücü kurun.</translation>
    </message>
    <message>
        <source>the driver has no %1</source>
        <translation>sürücüde %1 yok</translation>
    </message>
    <message>
        <source>the driver offers OpenGL %1</source>
        <translation>sürücü OpenGL %1 sunuyor</translation>
    </message>
    <message>
        <source>the driver rejects a shader: %1</source>
        <translation>sürücü bir gölgelendiriciyi reddediyor: %1</translation>
    </message>
    <message>
        <source>The picture would be more than %1 pixels wide or high: give it a smaller size, or write SVG or PDF.</source>
        <translation>Resim %1 pikselden geniş ya da yüksek olurdu: daha küçük bir boyut verin ya da SVG veya PDF yazın.</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 kayıp</translation>
    </message>
    <message>
        <source>* shared by equal stiffness: an assumption</source>
        <translation>* eşit rijitlikle paylaşıldı: bir kabul</translation>
    </message>
    <message>
        <source>? W: shared in unknown parts, not determined</source>
        <translation>? W: bilinmeyen paylarla bölüşülüyor, belirli değil</translation>
    </message>
    <message>
        <source>circulates: links %1, meshes %2</source>
        <translation>dolaşır: uzuvlar %1, dişli çiftleri %2</translation>
    </message>
    <message>
        <source>seen from the ground</source>
        <translation>sabit uzuvdan bakıldığında</translation>
    </message>
    <message>
        <source>seen from link %1</source>
        <translation>%1 uzvundan bakıldığında</translation>
    </message>
    <message>
        <source>Balance in joint %1</source>
        <translation>%1 mafsalındaki dengeleme</translation>
    </message>
    <message>
        <source>Balance on link %1</source>
        <translation>%1 uzvundaki dengeleme</translation>
    </message>
    <message>
        <source>%1: not determined, it shares the loads in unknown parts.</source>
        <translation>%1: belirlenemez, yükler bilinmeyen oranlarda paylaşılıyor.</translation>
    </message>
    <message>
        <source>%1: found, it holds the loads with %2 N m.</source>
        <translation>%1: bulundu, yükleri %2 N m ile tutar.</translation>
    </message>
    <message>
        <source>It feeds %1 into the train.</source>
        <translation>Düzeneğe %1 verir.</translation>
    </message>
    <message>
        <source>It takes %1 out of the train.</source>
        <translation>Düzenekten %1 alır.</translation>
    </message>
    <message>
        <source>T shared</source>
        <translation>Ortak T</translation>
    </message>
    <message>
        <source>Both methods give the same fractions: all %1 entries agree.</source>
        <translation>İki yöntem aynı kesirleri verir: %1 öğenin hepsi uyuşuyor.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Adım adım</translation>
    </message>
    <message>
        <source>Matroid method</source>
        <translation>Matroid yöntemi</translation>
    </message>
    <message>
        <source>T-T graph method</source>
        <translation>T-T graf yöntemi</translation>
    </message>
    <message>
        <source>Relation</source>
        <translation>İlişki</translation>
    </message>
    <message>
        <source>Mesh by mesh</source>
        <translation>Dişli çifti dişli çifti</translation>
    </message>
    <message>
        <source>For each mesh, above: its row of $P$, divided by the radius of the head&apos;s gear. Below: its terminal equation with both circuits put in, times $N_{tail} / N_{head}$.</source>
        <translation>Her dişli çifti için üstte $P$ matrisindeki satırı, baştaki dişlinin yarıçapına bölünmüş olarak; altta iki çevrimi yerine konmuş uç denklemi, $N_{tail} / N_{head}$ ile çarpılmış olarak.</translation>
    </message>
    <message>
        <source>too long to write</source>
        <translation>yazılamayacak kadar uzun</translation>
    </message>
    <message>
        <source>Counted</source>
        <translation>Sayılmış</translation>
    </message>
    <message>
        <source>Products and quotients, sums and differences of the calculation by hand for this mechanism; those with $0$ and $\pm 1$ cost nothing.</source>
        <translation>Bu mekanizma için elle hesabın çarpma ve bölmeleri, toplama ve çıkarmaları; $0$ ve $\pm 1$ ile olanlar sayılmaz.</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Bilinmeyenler</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Denklemler</translation>
    </message>
    <message>
        <source>Matrix of the equations</source>
        <translation>Denklemlerin matrisi</translation>
    </message>
    <message>
        <source>Entries that are not 0</source>
        <translation>0 olmayan öğeler</translation>
    </message>
    <message>
        <source>From the drawing to the equations</source>
        <translation>Çizimden denklemlere</translation>
    </message>
    <message>
        <source>From the equations to the solution</source>
        <translation>Denklemlerden çözüme</translation>
    </message>
    <message>
        <source>The same in gear ratios</source>
        <translation>Aynısı dişli oranlarıyla</translation>
    </message>
    <message>
        <source>With more links</source>
        <translation>Daha çok uzuvla</translation>
    </message>
    <message>
        <source>The same counted on larger trains. The chain of substitutions grows with the number of meshes times that of the inputs; the inverse of $P_r$ holds all products along the way and grows with its square.</source>
        <translation>Aynısı daha büyük takımlarda sayıldı. Yerine koyma zinciri dişli çifti sayısı çarpı giriş sayısı ile büyür; $P_r$ matrisinin tersi yol boyunca bütün çarpımları içerir ve bunun karesiyle büyür.</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Dişli takımı</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Dişli çiftleri</translation>
    </message>
    <message>
        <source>Inverse and product</source>
        <translation>Ters ve çarpım</translation>
    </message>
    <message>
        <source>Substitution</source>
        <translation>Yerine koyma</translation>
    </message>
    <message>
        <source>Multiplications and additions from the equations to the solution</source>
        <translation>Denklemlerden çözüme çarpmalar ve toplamalar</translation>
    </message>
    <message>
        <source>moving links</source>
        <translation>hareketli uzuvlar</translation>
    </message>
    <message>
        <source>What the paper concludes</source>
        <translation>Makalenin vardığı sonuçlar</translation>
    </message>
    <message>
        <source>For it: %1</source>
        <translation>Lehine: %1</translation>
    </message>
    <message>
        <source>Against it: %1</source>
        <translation>Aleyhine: %1</translation>
    </message>
    <message>
        <source>The mechanism</source>
        <translation>Mekanizma</translation>
    </message>
    <message>
        <source>It has %1, %2 and %3, $k = t + c = %4$ joints in all. The ground is link 0; the other links, the turning joints and the meshes are numbered on from there.</source>
        <translation>%1, %2 ve %3 var; toplam $k = t + c = %4$ mafsal. Sabit uzuv 0 numaralı uzuvdur; öteki uzuvlar, döner mafsallar ve dişli çiftleri oradan başlayarak numaralanır.</translation>
    </message>
    <message>
        <source>$%1$ moving link ($n = %1$)</source>
        <translation>$%1$ hareketli uzuv ($n = %1$)</translation>
    </message>
    <message>
        <source>$%1$ moving links ($n = %1$)</source>
        <translation>$%1$ hareketli uzuv ($n = %1$)</translation>
    </message>
    <message>
        <source>$%1$ turning joint ($t = %1$)</source>
        <translation>$%1$ döner mafsal ($t = %1$)</translation>
    </message>
    <message>
        <source>$%1$ turning joints ($t = %1$)</source>
        <translation>$%1$ döner mafsal ($t = %1$)</translation>
    </message>
    <message>
        <source>$%1$ gear mesh ($c = %1$)</source>
        <translation>$%1$ dişli çifti ($c = %1$)</translation>
    </message>
    <message>
        <source>$%1$ gear meshes ($c = %1$)</source>
        <translation>$%1$ dişli çifti ($c = %1$)</translation>
    </message>
    <message>
        <source>Digraph and matrices</source>
        <translation>Yönlü graf ve matrisler</translation>
    </message>
    <message>
        <source>Each link becomes a node, each turning joint a solid arrow from its tail to its head, each gear mesh a dashed one.</source>
        <translation>Her uzuv bir düğüm, her döner mafsal kuyruğundan başına düz bir ok, her dişli çifti kesikli bir ok olur.</translation>
    </message>
    <message>
        <source>In the incidence matrix an edge&apos;s column holds $-1$ in the row of the link that it leaves and $1$ in the row of the link that it reaches.</source>
        <translation>Bağlantı matrisinde bir kenarın sütunu, çıktığı uzvun satırında $-1$, vardığı uzvun satırında $1$ içerir.</translation>
    </message>
    <message>
        <source>Without the row of the ground its rows are independent: $G$ for the turning joints, $G^*$ for the meshes.</source>
        <translation>Sabit uzvun satırı olmadan satırları bağımsızdır: $G$ döner mafsallar, $G^*$ dişli çiftleri içindir.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree of this digraph, so there is nothing more to derive: see the findings above.</source>
        <translation>Döner mafsallar bu yönlü grafın kapsayan ağacı değil; türetilecek başka bir şey yok: yukarıdaki bulgulara bakın.</translation>
    </message>
    <message>
        <source>The turning joints are a spanning tree. The path matrix holds, for each link, the joints on its path to the ground: $1$ where the path follows the arrow, $-1$ where it runs against it.</source>
        <translation>Döner mafsallar bir kapsayan ağaçtır. Yol matrisi her uzuv için sabit uzva giden yolundaki mafsalları içerir: yol oku izliyorsa $1$, oka karşı gidiyorsa $-1$.</translation>
    </message>
    <message>
        <source>Each mesh closes a fundamental cycle with the joints between its two links. They follow from both matrices.</source>
        <translation>Her dişli çifti, iki uzvu arasındaki mafsallarla bir temel çevrim kapatır. Çevrimler iki matristen çıkar.</translation>
    </message>
    <message>
        <source>With the meshes themselves, each once, this is the cycle-basis matrix.</source>
        <translation>Dişli çiftlerinin kendileriyle, her biri bir kez, bu çevrim tabanı matrisidir.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Nereden</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nereye</translation>
    </message>
    <message>
        <source>en</source>
        <translation>tr</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Vidalar</translation>
    </message>
    <message>
        <source>The screw of joint $k$ about the pitch point of mesh $c$ is the unit vector along the joint&apos;s axis, $u_k$, with its moment about that point, $r_{c,k} = l_{c,k} \times u_k$, where $l_{c,k}$ leads from the pitch point to the axis:</source>
        <translation>$k$ mafsalının $c$ dişli çiftinin hatve noktasına göre vidası, mafsal ekseni boyunca birim vektör $u_k$ ile onun bu noktaya göre momenti $r_{c,k} = l_{c,k} \times u_k$ olur; $l_{c,k}$ hatve noktasından eksene gider:</translation>
    </message>
    <message>
        <source>For the joints of each cycle, lengths in %1:</source>
        <translation>Her çevrimin mafsalları için, uzunluklar %1 cinsinden:</translation>
    </message>
    <message>
        <source>Equations of the meshes</source>
        <translation>Dişli çiftlerinin denklemleri</translation>
    </message>
    <message>
        <source>They all point along one line: the normal of the plane that holds both axes of the mesh. One number of each is enough, its component $P_{c,t}$ along that normal, and each mesh gives one equation:</source>
        <translation>Hepsi tek bir doğru boyuncadır: dişli çiftinin iki eksenini içeren düzlemin normali. Her birinden bir sayı yeter, bu normal boyunca bileşeni $P_{c,t}$; her dişli çifti bir denklem verir:</translation>
    </message>
    <message>
        <source>With lengths in %1,</source>
        <translation>Uzunluklar %1 cinsinden,</translation>
    </message>
    <message>
        <source>The entries of a row are the radii of its two gears. Divided by the radius of the head&apos;s gear, the ratios are left:</source>
        <translation>Bir satırın öğeleri iki dişlisinin yarıçaplarıdır. Baştaki dişlinin yarıçapına bölününce oranlar kalır:</translation>
    </message>
    <message>
        <source>Engaged couplings</source>
        <translation>Devredeki fren ve kavramalar</translation>
    </message>
    <message>
        <source>An engaged brake holds its link against the ground, an engaged clutch makes two links turn as one. The rates of the joints between them add up to zero, once for each direction of their axes: rows below those of the meshes, which stay as they are.</source>
        <translation>Devredeki fren uzvunu sabit uzva bağlar, devredeki kavrama iki uzvu birlikte döndürür. Aralarındaki mafsalların hızları, eksenlerinin her doğrultusu için bir kez, sıfıra toplanır: dişli çiftlerininkilerin altında satırlar; onlar olduğu gibi kalır.</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Fren veya kavrama</translation>
    </message>
    <message>
        <source>Equation</source>
        <translation>Denklem</translation>
    </message>
    <message>
        <source>The input is joint %1.</source>
        <translation>Giriş %1 mafsalıdır.</translation>
    </message>
    <message>
        <source>The inputs are joints %1.</source>
        <translation>Girişler %1 mafsallarıdır.</translation>
    </message>
    <message>
        <source>The input is joint %1, chosen by the program because the document names none.</source>
        <translation>Giriş %1 mafsalıdır; belge adlandırmadığı için program seçti.</translation>
    </message>
    <message>
        <source>The inputs are joints %1, chosen by the program because the document names none.</source>
        <translation>Girişler %1 mafsallarıdır; belge adlandırmadığı için program seçti.</translation>
    </message>
    <message>
        <source>Freedom and inputs</source>
        <translation>Serbestlik ve girişler</translation>
    </message>
    <message>
        <source>The rank of $P$ with the rows of the couplings, in exact arithmetic, is $r = %1$. The mechanism therefore has</source>
        <translation>Fren ve kavrama satırlarıyla $P$ matrisinin rankı, kesin hesapla, $r = %1$. Buna göre mekanizmanın</translation>
    </message>
    <message>
        <source>The rank of $P$, in exact arithmetic, is $r = %1$. The mechanism therefore has</source>
        <translation>$P$ matrisinin rankı, kesin hesapla, $r = %1$. Buna göre mekanizmanın</translation>
    </message>
    <message>
        <source>degrees of freedom. Kutzbach&apos;s count $n - c - h = %1$, with the $h$ rows of couplings, differs, because %2 of the equations follow from the others.</source>
        <translation>serbestlik derecesi vardır. $h$ fren ve kavrama satırıyla Kutzbach sayımı $n - c - h = %1$ farklıdır, çünkü denklemlerin %2 tanesi ötekilerden çıkar.</translation>
    </message>
    <message>
        <source>degrees of freedom. Kutzbach&apos;s count $n - c = %1$ differs, because the equations of %2 of the meshes follow from the others.</source>
        <translation>serbestlik derecesi vardır. Kutzbach sayımı $n - c = %1$ farklıdır, çünkü dişli çiftlerinden %2 tanesinin denklemleri ötekilerden çıkar.</translation>
    </message>
    <message>
        <source>degrees of freedom: as many inputs have to be given.</source>
        <translation>serbestlik derecesi vardır: o kadar giriş verilmelidir.</translation>
    </message>
    <message>
        <source>Each direction is the $z$ axis, turned about $x$ by the offset angle $\varphi_k$:</source>
        <translation>Her yön, $x$ etrafında $\varphi_k$ kaçıklık açısı kadar döndürülmüş $z$ eksenidir:</translation>
    </message>
    <message>
        <source>Each direction is the $z$ axis, turned by a rotation $D_{0,k}$:</source>
        <translation>Her yön, $D_{0,k}$ dönmesiyle döndürülmüş $z$ eksenidir:</translation>
    </message>
    <message>
        <source>The moment needs the way from the pitch point to a point of the axis:</source>
        <translation>Moment için hatve noktasından eksenin bir noktasına giden vektör gerekir:</translation>
    </message>
    <message>
        <source>The twist of a joint is its screw times its rate:</source>
        <translation>Bir mafsalın burgusu, vidası ile hızının çarpımıdır:</translation>
    </message>
    <message>
        <source>Along each cycle the twists, with their signs in $C$, add up to zero:</source>
        <translation>Her çevrim boyunca burgular, $C$ içindeki işaretleriyle, sıfıra toplanır:</translation>
    </message>
    <message>
        <source>Their directions give the velocity of one gear of each mesh relative to the other. The mesh has no moment about its own pitch point, so the moments of the turning joints alone add up to zero:</source>
        <translation>Yönleri, her dişli çiftinin bir dişlisinin ötekine göre hızını verir. Dişli çiftinin kendi hatve noktasına göre momenti yoktur; bu yüzden döner mafsalların momentleri tek başına sıfıra toplanır:</translation>
    </message>
    <message>
        <source>With the inputs first, the equations are parted into columns of the inputs and of the outputs:</source>
        <translation>Girişler önce gelince denklemler giriş ve çıkış sütunlarına ayrılır:</translation>
    </message>
    <message>
        <source>and their solution is</source>
        <translation>ve çözümleri</translation>
    </message>
    <message>
        <source>With the inputs first, and in gear ratios, the equations are</source>
        <translation>Girişler başta ve dişli oranlarıyla denklemler şöyledir:</translation>
    </message>
    <message>
        <source>Solved for the outputs,</source>
        <translation>Çıkışlara göre çözülünce</translation>
    </message>
    <message>
        <source>there is nothing that turns: without a freedom all rates are $0$.</source>
        <translation>dönen hiçbir şey yoktur: serbestlik olmadan bütün hızlar $0$ olur.</translation>
    </message>
    <message>
        <source>With the teeth of this mechanism:</source>
        <translation>Bu mekanizmanın diş sayılarıyla:</translation>
    </message>
    <message>
        <source>Written out, some entries are too long to read. One joint after the other they are</source>
        <translation>Açık yazıldığında bazı öğeler okunamayacak kadar uzundur. Mafsal mafsal şöyledir:</translation>
    </message>
    <message>
        <source>At these speeds of the inputs, in rad/s,</source>
        <translation>Girişlerin rad/s cinsinden bu hızlarında</translation>
    </message>
    <message>
        <source>the outputs turn at</source>
        <translation>çıkışlar şu hızlarla döner:</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Uyarılar</translation>
    </message>
    <message>
        <source>Worked out by the Matroid and the T-T graph method</source>
        <translation>Matroid ve T-T graf yöntemleriyle çıkarılmıştır</translation>
    </message>
    <message>
        <source>Both methods compared</source>
        <translation>İki yöntemin karşılaştırması</translation>
    </message>
    <message>
        <source>It has $%1 \times %2$ entries, too many to print: &quot;export --to csv --matrix %3&quot; writes them.</source>
        <translation>$%1 \times %2$ öğesi var, basılamayacak kadar çok: &quot;export --to csv --matrix %3&quot; onları yazar.</translation>
    </message>
    <message>
        <source>Statics</source>
        <translation>Statik</translation>
    </message>
    <message>
        <source>What holds the loads follows from the same matrices, read down their columns. A starred number belongs to the equation of the kinematics beside it. A torque $\tau_e$ acts in joint $e$, by its tail on its head, about the direction of its axis; $\ell_e$ is the power of the loads on links beyond the joint for its rate $1$; $F_c$ is the tangential force of mesh $c$, by the tail&apos;s gear on the head&apos;s.</source>
        <translation>Yükleri tutan şey, sütunlarından okunan aynı matrislerden çıkar. Yıldızlı numara, yanındaki kinematik denklemine aittir. $\tau_e$ torku $e$ mafsalında, kuyruğundan başına, ekseninin doğrultusu etrafında etkir; $\ell_e$, mafsalın hızı $1$ iken onun ötesindeki uzuvlardaki yüklerin gücüdür; $F_c$, $c$ dişli çiftinin kuyruktaki dişliden baştakine teğetsel kuvvetidir.</translation>
    </message>
    <message>
        <source>Cutset equations</source>
        <translation>Kesitleme denklemleri</translation>
    </message>
    <message>
        <source>Without joint $e$ the tree falls into two parts. The edges that lead from one to the other are its fundamental cutset. It crosses each cycle as often along the cycle as against it:</source>
        <translation>$e$ mafsalı olmadan ağaç iki parçaya ayrılır. Birinden ötekine giden kenarlar onun temel kesitlemesidir. Her çevrimi, çevrim yönünde ve ona ters yönde eşit sayıda keser:</translation>
    </message>
    <message>
        <source>So the part beyond a joint is in equilibrium if the torque in the joint and the loads hold the forces of the meshes that cross the cutset. Their moments about the joint&apos;s axis are the entries of its column of $P$; forces along the line of centres or along an axis do no work and are in no equation:</source>
        <translation>Buna göre mafsalın ötesindeki parça, mafsaldaki tork ve yükler kesitlemeyi kesen dişli çiftlerinin kuvvetlerini karşılıyorsa dengededir. Bunların mafsal eksenine göre momentleri $P$ matrisindeki sütununun öğeleridir; merkezler doğrusu veya bir eksen boyunca kuvvetler iş yapmaz ve hiçbir denklemde yer almaz:</translation>
    </message>
    <message>
        <source>There are too many to print: &quot;export --to csv --matrix cutset-equations&quot; writes them.</source>
        <translation>Basılamayacak kadar çok: &quot;export --to csv --matrix cutset-equations&quot; onları yazar.</translation>
    </message>
    <message>
        <source>An engaged coupling is a further edge of the graph, with its torque $T$.</source>
        <translation>Devredeki fren veya kavrama, $T$ torkuyla grafın bir kenarı daha olur.</translation>
    </message>
    <message>
        <source>With lengths in %1, so that torques are in N %1, joint by joint,</source>
        <translation>Uzunluklar %1, dolayısıyla torklar N %1 cinsinden, mafsal mafsal,</translation>
    </message>
    <message>
        <source>The transposed solution</source>
        <translation>Devrik çözüm</translation>
    </message>
    <message>
        <source>The torque in every balanced joint for one unit of torque in each loaded one: the solution of the speeds, transposed, with the opposite sign.</source>
        <translation>Yüklü her mafsaldaki bir birim tork için dengeleyen her mafsaldaki tork: hızların çözümü, devriği alınmış ve ters işaretli.</translation>
    </message>
    <message>
        <source>A row for each joint and a column for each mesh: the lever of the mesh&apos;s force about the joint&apos;s axis. It is P transposed; a row times the forces is the torque in the joint and that of the loads beyond it.</source>
        <translation>Her mafsal için bir satır, her dişli çifti için bir sütun: çiftin kuvvetinin mafsalın eksenine göre kolu. P&apos;nin devriğidir; bir satır kuvvetlerle çarpılınca mafsaldaki tork ve ötesindeki yüklerin torku bulunur.</translation>
    </message>
    <message>
        <source>The torques in the balanced joints, $\tau_E$, hold those in the others, $\tau_r$. With the columns of $P$ in the same order as for the speeds,</source>
        <translation>Dengelenen mafsallardaki torklar $\tau_E$, ötekilerdeki $\tau_r$ torklarını tutar. $P$ matrisinin sütunları hızlardaki sırayla alınınca</translation>
    </message>
    <message>
        <source>which in ratios is (25) transposed, with the opposite sign:</source>
        <translation>bu, oranlarla (25) denkleminin ters işaretli devriğidir:</translation>
    </message>
    <message>
        <source>Torques under the loads</source>
        <translation>Yükler altında torklar</translation>
    </message>
    <message>
        <source>The loads of the document are held by these torques, in N m, in a train without losses:</source>
        <translation>Kayıpsız bir takımda belgenin yüklerini N m cinsinden şu torklar tutar:</translation>
    </message>
    <message>
        <source>The tangential forces of the meshes, in N, are</source>
        <translation>Dişli çiftlerinin N cinsinden teğetsel kuvvetleri şöyledir:</translation>
    </message>
    <message>
        <source>The same by the T-T graph</source>
        <translation>Aynısı T-T grafıyla</translation>
    </message>
    <message>
        <source>A mesh loses no power at its two ports, so the torques on its gears, seen from the carrier, are in the inverse ratio of their speeds:</source>
        <translation>Dişli çifti iki kapısında güç yitirmez; bu yüzden dişlilerindeki torklar, taşıyıcıdan bakıldığında, hızlarıyla ters orantılıdır:</translation>
    </message>
    <message>
        <source>Each branch of the tree has a fundamental cutset, with the coefficients of the circuits that the branch belongs to:</source>
        <translation>Ağacın her dalının, dalın ait olduğu çevrimlerin katsayılarıyla bir temel kesitlemesi vardır:</translation>
    </message>
    <message>
        <source>These cutsets as the rows of a matrix, the torques in the branches before the line, those of the chords after it; loads and engaged couplings come in addition:</source>
        <translation>Bu kesitlemeler bir matrisin satırları olarak; çizgiden önce dallardaki, sonra kirişlerdeki torklar; yükler ve devredeki fren ve kavramalar bunlara eklenir:</translation>
    </message>
    <message>
        <source>The Matroid method&apos;s $Q$ has the same rows. A mesh is one edge there and has a chord to each gear here, so its column of $Q$ is that of the chord of the head&apos;s gear less that of the tail&apos;s:</source>
        <translation>Matroid yönteminin $Q$ matrisinin satırları aynıdır. Dişli çifti orada tek kenardır, burada her dişliye bir kirişi vardır; bu yüzden $Q$ içindeki sütunu, baştaki dişlinin kirişininkinden kuyruktakininki çıkarılarak bulunur:</translation>
    </message>
    <message>
        <source>The chain runs from the loads back to the motors: a cutset with one unknown left gives it, the terminal equation of its mesh the other torque.</source>
        <translation>Zincir yüklerden motorlara doğru gider: tek bilinmeyeni kalan kesitleme onu verir, dişli çiftinin uç denklemi öteki torku.</translation>
    </message>
    <message>
        <source>Torque by torque, both methods give the same fractions: all %1 entries agree.</source>
        <translation>Tork tork, iki yöntem aynı kesirleri verir: %1 öğenin hepsi uyuşuyor.</translation>
    </message>
    <message>
        <source>The two methods differ by up to %1 N m.</source>
        <translation>İki yöntem arasındaki fark en çok %1 N m.</translation>
    </message>
    <message>
        <source>In symbols, too: eliminated in the gear ratios, the cutsets of the T-T graph give the torque matrix of (25) transposed, entry by entry.</source>
        <translation>Simgelerle de: dişli oranlarıyla yok etme yapılınca T-T grafının kesitlemeleri, öğe öğe, (25) denkleminin devriği olan tork matrisini verir.</translation>
    </message>
    <message>
        <source>In symbols the two torque matrices differ.</source>
        <translation>Simgelerle iki tork matrisi farklı.</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Düzeyler</translation>
    </message>
    <message>
        <source>The turning joints are the branches of the graph&apos;s tree. Each carries the letter of its axis, its level.</source>
        <translation>Döner mafsallar grafın ağacının dallarıdır. Her biri ekseninin harfini, yani düzeyini taşır.</translation>
    </message>
    <message>
        <source>Carriers</source>
        <translation>Taşıyıcılar</translation>
    </message>
    <message>
        <source>From one gear of a mesh through the branches to the other, the level changes at one link: the transfer vertex, which carries both gears. A mesh is written as its gear pair and its carrier.</source>
        <translation>Bir dişli çiftinin bir dişlisinden dallar boyunca ötekine giderken düzey bir uzuvda değişir: iki dişliyi de taşıyan aktarma düğümü. Dişli çifti, dişlileri ve taşıyıcısıyla yazılır.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Dişli çifti</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Yol</translation>
    </message>
    <message>
        <source>Pair and carrier</source>
        <translation>Çift ve taşıyıcı</translation>
    </message>
    <message>
        <source>no transfer vertex</source>
        <translation>aktarma düğümü yok</translation>
    </message>
    <message>
        <source>Terminal equations</source>
        <translation>Uç denklemleri</translation>
    </message>
    <message>
        <source>Seen from its carrier, one gear of a pair turns as fast as the other times the ratio of their teeth, with a plus sign where both turn the same way, each seen along its own axis:</source>
        <translation>Taşıyıcısından bakıldığında çiftin bir dişlisi, ötekinin hızı çarpı diş oranı kadar hızlı döner; her biri kendi ekseni boyunca bakıldığında ikisi aynı yönde dönüyorsa işaret artıdır:</translation>
    </message>
    <message>
        <source>Fundamental circuits</source>
        <translation>Temel çevrimler</translation>
    </message>
    <message>
        <source>Each of these velocities closes a circuit with branches of the tree, and is the sum along the branches:</source>
        <translation>Bu hızların her biri ağacın dallarıyla bir çevrim kapatır ve dallar boyunca toplamdır:</translation>
    </message>
    <message>
        <source>An engaged brake or clutch is one more edge of the graph, from the link that it holds to the ground or to the other link. Its velocity is zero, so the branches of its fundamental circuit add up to zero, once for each direction of their axes:</source>
        <translation>Devredeki fren veya kavrama, tuttuğu uzuvdan sabit uzva ya da öteki uzva giden bir kenar daha olur. Hızı sıfırdır; bu yüzden temel çevriminin dalları, eksenlerinin her doğrultusu için bir kez, sıfıra toplanır:</translation>
    </message>
    <message>
        <source>Solution by substitution</source>
        <translation>Yerine koyarak çözüm</translation>
    </message>
    <message>
        <source>Given is %1.</source>
        <translation>Verilen: %1.</translation>
    </message>
    <message>
        <source>Given are %1.</source>
        <translation>Verilenler: %1.</translation>
    </message>
    <message>
        <source>Mesh by mesh, the equations give the others.</source>
        <translation>Denklemler, dişli çifti dişli çifti, ötekileri verir.</translation>
    </message>
    <message>
        <source>One after the other, the equations give the others.</source>
        <translation>Denklemler, birbiri ardına, ötekileri verir.</translation>
    </message>
    <message>
        <source>Equation %1 gives %2:</source>
        <translation>%1 denklemi %2 büyüklüğünü verir:</translation>
    </message>
    <message>
        <source>Equations %1 give %2:</source>
        <translation>%1 denklemleri %2 büyüklüğünü verir:</translation>
    </message>
    <message>
        <source>The equations of several meshes and couplings, solved together, give %1:</source>
        <translation>Birkaç dişli çiftinin ve elemanın denklemleri birlikte çözülünce %1 bulunur:</translation>
    </message>
    <message>
        <source>The equations of several meshes, solved together, give %1:</source>
        <translation>Birkaç dişli çiftinin denklemleri birlikte çözülünce %1 bulunur:</translation>
    </message>
    <message>
        <source>Together:</source>
        <translation>Birlikte:</translation>
    </message>
    <message>
        <source>With the names of the ratios that the matroid method uses,</source>
        <translation>Oranların matroid yöntemindeki adlarıyla,</translation>
    </message>
    <message>
        <source>this is</source>
        <translation>bu</translation>
    </message>
    <message>
        <source>a mechanism without errors, and at most 250,000 entries</source>
        <translation>hatasız bir mekanizma ve en çok 250.000 öğe</translation>
    </message>
    <message>
        <source>a carrier and a sign of every mesh</source>
        <translation>her dişli çiftinin taşıyıcısı ve işareti</translation>
    </message>
    <message>
        <source>a geometry of every mesh</source>
        <translation>her dişli çiftinin geometrisi</translation>
    </message>
    <message>
        <source>balances in joints that hold all loads, and at most 250,000 entries</source>
        <translation>bütün yükleri tutan mafsal dengeleri ve en çok 250.000 öğe</translation>
    </message>
    <message>
        <source>loads, and balances that hold them</source>
        <translation>yükler ve onları tutan dengeler</translation>
    </message>
    <message>
        <source>states of a gearbox</source>
        <translation>vites kutusu durumları</translation>
    </message>
    <message>
        <source>a spanning tree</source>
        <translation>kapsayan ağaç</translation>
    </message>
    <message>
        <source>The handout has no still picture: %1</source>
        <translation>Ders notunda durağan resim yok: %1</translation>
    </message>
    <message>
        <source>About %1 triangles are more than the limit of %2</source>
        <translation>Yaklaşık %1 üçgen, %2 sınırını aşıyor</translation>
    </message>
    <message>
        <source>The file shows the first %1 s of it, at its speed; it does not end where it began.</source>
        <translation>Dosya bunun ilk %1 s&apos;sini, kendi hızında gösterir; başladığı yerde bitmez.</translation>
    </message>
    <message>
        <source>The motion in the file goes there and back within the limits of joints: %1.</source>
        <translation>Dosyadaki hareket, mafsal sınırları içinde gidip gelir: %1.</translation>
    </message>
    <message>
        <source>Nothing in the file moves.</source>
        <translation>Dosyada hiçbir şey hareket etmez.</translation>
    </message>
    <message>
        <source>A mechanism with errors has no gears</source>
        <translation>Hatalı bir mekanizmanın dişlileri olmaz</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot; with solids</source>
        <translation>Katı modeli olan &quot;%1&quot; diye bir uzuv yok</translation>
    </message>
    <message>
        <source>There is no gear &quot;%1&quot;; gears are named like 15:tail, 15:head</source>
        <translation>&quot;%1&quot; diye bir dişli yok; dişliler 15:tail, 15:head gibi adlanır</translation>
    </message>
    <message>
        <source>the assembly</source>
        <translation>montaj</translation>
    </message>
    <message>
        <source>(pinned)</source>
        <translation>(sabitlenmiş)</translation>
    </message>
    <message>
        <source>One of %1 equal planets is drawn: %2 is like %3.</source>
        <translation>%1 özdeş gezegenden biri çizildi: %2, %3 gibidir.</translation>
    </message>
    <message>
        <source>One of %1 equal planets is drawn: %2 are like %3.</source>
        <translation>%1 özdeş gezegenden biri çizildi: %2, %3 gibidir.</translation>
    </message>
    <message>
        <source>One of %1 equal sets of planets is drawn: %2 is like %3.</source>
        <translation>%1 özdeş gezegen grubundan biri çizildi: %2, %3 gibidir.</translation>
    </message>
    <message>
        <source>One of %1 equal sets of planets is drawn: %2 are like %3.</source>
        <translation>%1 özdeş gezegen grubundan biri çizildi: %2, %3 gibidir.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. Radii are not to scale.</source>
        <translation>Açınım: eksenler tek düzlemde değil. Yarıçaplar ölçekli değil.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 is turned into the sheet.</source>
        <translation>Açınım: eksenler tek düzlemde değil. %1 çizim düzlemine döndürüldü.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 are turned into the sheet.</source>
        <translation>Açınım: eksenler tek düzlemde değil. %1 çizim düzlemine döndürüldü.</translation>
    </message>
    <message>
        <source>Unfolded: the axes do not lie in one plane. %1 of them are turned into the sheet.</source>
        <translation>Açınım: eksenler tek düzlemde değil. %1 tanesi çizim düzlemine döndürüldü.</translation>
    </message>
    <message>
        <source>Wheels that a dashed line joins mesh, though they do not touch here.</source>
        <translation>Kesikli çizgiyle birleşen dişliler, burada değmeseler de birlikte çalışır.</translation>
    </message>
    <message>
        <source>Link %1 is not drawn: no turning joint ties it to the ground.</source>
        <translation>%1 uzvu çizilmedi: onu sabit uzva bağlayan döner mafsal yok.</translation>
    </message>
    <message>
        <source>Links %1 are not drawn: no turning joint ties them to the ground.</source>
        <translation>%1 uzuvları çizilmedi: onları sabit uzva bağlayan döner mafsal yok.</translation>
    </message>
    <message>
        <source>Joint %1 closes a loop and is not drawn.</source>
        <translation>%1 mafsalı bir çevrim kapatır ve çizilmedi.</translation>
    </message>
    <message>
        <source>Joints %1 close a loop and are not drawn.</source>
        <translation>%1 mafsalları bir çevrim kapatır ve çizilmedi.</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 puan</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puan</translation>
    </message>
    <message>
        <source>%1, variant %2</source>
        <translation>%1, %2. seçenek</translation>
    </message>
    <message>
        <source>%1: solution</source>
        <translation>%1: çözüm</translation>
    </message>
    <message>
        <source>Name: %1</source>
        <translation>Ad: %1</translation>
    </message>
    <message>
        <source>%1 question</source>
        <translation>%1 soru</translation>
    </message>
    <message>
        <source>%1 questions</source>
        <translation>%1 soru</translation>
    </message>
    <message>
        <source>Brake or clutch</source>
        <translation>Fren veya kavrama</translation>
    </message>
    <message>
        <source>Engaged, it holds</source>
        <translation>Devredeyken tuttuğu</translation>
    </message>
    <message>
        <source>link %1 against the ground</source>
        <translation>%1 uzvunu sabit uzva</translation>
    </message>
    <message>
        <source>links %1 together</source>
        <translation>%1 uzuvlarını birbirine</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Yanıt</translation>
    </message>
    <message>
        <source>Angular speed</source>
        <translation>Açısal hız</translation>
    </message>
    <message>
        <source>Traced points</source>
        <translation>İzlenen noktalar</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>sabit uzuv</translation>
    </message>
    <message>
        <source>point %1 of %2</source>
        <translation>%2 üzerinde %1. nokta</translation>
    </message>
    <message>
        <source>link %1: %2</source>
        <translation>uzuv %1: %2</translation>
    </message>
    <message>
        <source>Shared by equal stiffness of all teeth: an assumption.</source>
        <translation>Tüm dişlerin eşit rijitliğine göre paylaştırıldı: bir varsayım.</translation>
    </message>
    <message>
        <source>Loads: %1.</source>
        <translation>Yükler: %1.</translation>
    </message>
    <message>
        <source>joint %1 at %2°</source>
        <translation>%1 mafsalı %2°&apos;de</translation>
    </message>
    <message>
        <source>It is not in the folder of the document: copy it there.</source>
        <translation>Belgenin klasöründe değil: oraya kopyalayın.</translation>
    </message>
    <message>
        <source>The memory does not suffice for the pictures.</source>
        <translation>Resimler için bellek yetmiyor.</translation>
    </message>
    <message>
        <source>The driver painted nothing.</source>
        <translation>Sürücü hiçbir şey çizmedi.</translation>
    </message>
    <message>
        <source>The memory does not suffice for the labels.</source>
        <translation>Etiketler için bellek yetmiyor.</translation>
    </message>
    <message>
        <source>The file could not be written.</source>
        <translation>Dosya yazılamadı.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written.</source>
        <translation>&quot;%1&quot; yazılamadı.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder.</source>
        <translation>&quot;%1&quot; bir klasör değil.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; is not empty; nothing was written.</source>
        <translation>&quot;%1&quot; klasörü boş değil; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>No folder could be made beside &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; yanında klasör oluşturulamadı.</translation>
    </message>
    <message>
        <source>The driver paints pictures of up to %1 pixels a side; choose a smaller size.</source>
        <translation>Sürücü kenarı en çok %1 piksel olan resimler çizer; daha küçük bir boyut seçin.</translation>
    </message>
    <message>
        <source>Gear %1 has %2 teeth, too fine to be distinguished: it is shown without them.</source>
        <translation>%1 dişlisinin %2 dişi var, ayırt edilemeyecek kadar ince: dişsiz gösterilir.</translation>
    </message>
    <message>
        <source>Link %1 wears &quot;%2&quot;, which is not shown: %3</source>
        <translation>%1 uzvuna &quot;%2&quot; ekli, ama gösterilmiyor: %3</translation>
    </message>
    <message>
        <source>A train of %1 gears: its wheels are plain discs, its shafts and arms are straight and pass through what they meet (up to %2 gears they are routed past it).</source>
        <translation>%1 dişlili bir takım: dişlileri düz diskler olarak gösterilir, milleri ve kolları düzdür ve önlerine çıkanın içinden geçer (%2 dişliye kadar çevresinden dolaştırılırlar).</translation>
    </message>
    <message>
        <source>gears in a row</source>
        <translation>sıralı dişli</translation>
    </message>
    <message>
        <source>planetary sets in line</source>
        <translation>art arda planet dişli takımı</translation>
    </message>
    <message>
        <source>arms of a bevel-gear wrist</source>
        <translation>konik dişli bileğin kolu</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 ve %2</translation>
    </message>
    <message>
        <source>%1 equation</source>
        <translation>%1 denklem</translation>
    </message>
    <message>
        <source>%1 equations</source>
        <translation>%1 denklem</translation>
    </message>
    <message>
        <source>%1 unknown</source>
        <translation>%1 bilinmeyen</translation>
    </message>
    <message>
        <source>%1 unknowns</source>
        <translation>%1 bilinmeyen</translation>
    </message>
    <message>
        <source>%1 product</source>
        <translation>%1 çarpma</translation>
    </message>
    <message>
        <source>%1 products</source>
        <translation>%1 çarpma</translation>
    </message>
    <message>
        <source>%1 sum</source>
        <translation>%1 toplama</translation>
    </message>
    <message>
        <source>%1 sums</source>
        <translation>%1 toplama</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graf</translation>
    </message>
    <message>
        <source>digraph: a node for each link, an oriented line for each joint and mesh (Figs. 2, 3)</source>
        <translation>yönlü graf: her uzuv için bir düğüm, her mafsal ve dişli çifti için yönlü bir çizgi (Şekil 2, 3)</translation>
    </message>
    <message>
        <source>oriented graph: the same nodes and branches, and for each mesh two chords to its carrier (Figs. 4 to 6)</source>
        <translation>yönlü graf: aynı düğümler ve dallar, her dişli çifti için taşıyıcısına iki kiriş (Şekil 4-6)</translation>
    </message>
    <message>
        <source>The turning joints are the tree in both, the meshes close its cycles.</source>
        <translation>İkisinde de döner mafsallar ağaçtır, dişli çiftleri çevrimleri kapatır.</translation>
    </message>
    <message>
        <source>Tree and cycles</source>
        <translation>Ağaç ve çevrimler</translation>
    </message>
    <message>
        <source>incidence matrix (1), (2), path matrix $Z$ (3), spanning tree (4), $C$ (5)</source>
        <translation>bağlantı matrisi (1), (2), yol matrisi $Z$ (3), kapsayan ağaç (4), $C$ (5)</translation>
    </message>
    <message>
        <source>levels of the branches; f-circuits of the chords (31)-(38)</source>
        <translation>dalların düzeyleri; kirişlerin f-çevrimleri (31)-(38)</translation>
    </message>
    <message>
        <source>The cycle of a mesh is the circuit of its tail&apos;s chord less that of its head&apos;s chord.</source>
        <translation>Bir dişli çiftinin çevrimi, kuyruk kirişinin çevriminden baş kirişininki çıkarılarak bulunur.</translation>
    </message>
    <message>
        <source>Carrier</source>
        <translation>Taşıyıcı</translation>
    </message>
    <message>
        <source>not named: it drops out of the moments about the pitch point</source>
        <translation>adlandırılmaz: hatve noktasına göre momentlerden düşer</translation>
    </message>
    <message>
        <source>transfer vertex: where the level changes on the walk between the gears</source>
        <translation>aktarma düğümü: dişliler arasındaki yolda düzeyin değiştiği yer</translation>
    </message>
    <message>
        <source>The moments of a cycle&apos;s joints lie on one line because the carrier holds both axes.</source>
        <translation>Bir çevrimin mafsallarının momentleri tek bir doğrudadır, çünkü iki ekseni de taşıyıcı tutar.</translation>
    </message>
    <message>
        <source>screws about the pitch point (6)-(13), one row of $P$ (16)-(19): $i_c$ on the tail&apos;s axis, $\pm 1$ on the head&apos;s</source>
        <translation>hatve noktasına göre vidalar (6)-(13), $P$ matrisinin bir satırı (16)-(19): kuyruğun ekseninde $i_c$, başınkinde $\pm 1$</translation>
    </message>
    <message>
        <source>terminal equation (26)-(30): speeds seen from the carrier, a ratio and a sign</source>
        <translation>uç denklemi (26)-(30): taşıyıcıdan görülen hızlar, bir oran ve bir işaret</translation>
    </message>
    <message>
        <source>The terminal equation with its two circuits put in is the row of $P$.</source>
        <translation>İki çevrimi yerine konmuş uç denklemi, $P$ matrisinin satırıdır.</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>İşaret</translation>
    </message>
    <message>
        <source>comes with the diameters in the reference frame</source>
        <translation>referans eksen takımındaki çaplarla gelir</translation>
    </message>
    <message>
        <source>from the turning senses of the two gears, seen along their axes</source>
        <translation>iki dişlinin eksenleri boyunca görülen dönme yönlerinden</translation>
    </message>
    <message>
        <source>The signs agree: both are that of the product of the two moments.</source>
        <translation>İşaretler uyuşur: ikisi de iki momentin çarpımının işaretidir.</translation>
    </message>
    <message>
        <source>rank of $P$, $E = t - r$ (21); bases of the dual matroid are the valid inputs</source>
        <translation>$P$ matrisinin rankı, $E = t - r$ (21); eş matroidin tabanları geçerli girişlerdir</translation>
    </message>
    <message>
        <source>not asked: the inputs are taken as given</source>
        <translation>sorulmaz: girişler verilmiş sayılır</translation>
    </message>
    <message>
        <source>What can be driven is read from $P$.</source>
        <translation>Neyin tahrik edilebileceği $P$ matrisinden okunur.</translation>
    </message>
    <message>
        <source>$-P_r^{-1} P_E$ (22)-(25)</source>
        <translation>$-P_r^{-1} P_E$ (22)-(25)</translation>
    </message>
    <message>
        <source>one mesh after the other, substituted (39)-(42), then (43)-(45)</source>
        <translation>dişli çiftleri sırayla, yerine koyarak (39)-(42), sonra (43)-(45)</translation>
    </message>
    <message>
        <source>The same matrix, by joint.</source>
        <translation>Aynı matris, mafsallara göre.</translation>
    </message>
    <message>
        <source>Relative velocities</source>
        <translation>Bağıl hızlar</translation>
    </message>
    <message>
        <source>of the two gears of a mesh to each other (15), after the solution</source>
        <translation>bir dişli çiftinin iki dişlisinin birbirine göre hızı (15), çözümden sonra</translation>
    </message>
    <message>
        <source>of each gear to its carrier: the chords, on the way to the solution</source>
        <translation>her dişlinin taşıyıcısına göre hızı: kirişler, çözüme giderken</translation>
    </message>
    <message>
        <source>(15) is the difference of the two chords, as vectors.</source>
        <translation>(15), iki kirişin vektörel farkıdır.</translation>
    </message>
    <message>
        <source>columns of $P$ (not in the paper)</source>
        <translation>$P$ matrisinin sütunları (makalede yok)</translation>
    </message>
    <message>
        <source>complementary terminal variables and f-cutsets (not worked out in the paper)</source>
        <translation>tümleyici uç değişkenleri ve f-kesitlemeler (makalede işlenmemiş)</translation>
    </message>
    <message>
        <source>The cutset matrix $Q$ serves both.</source>
        <translation>Kesitleme matrisi $Q$ ikisine de yarar.</translation>
    </message>
    <message>
        <source>&quot;The kinematic equations can be obtained more easily by the T-T graph method.&quot;</source>
        <translation>&quot;Kinematik denklemler T-T graf yöntemiyle daha kolay elde edilebilir.&quot;</translation>
    </message>
    <message>
        <source>From its equations to the solution of this mechanism the chain of substitutions takes %1, the inverse of $P_r$ and its product %2.</source>
        <translation>Denklemlerinden bu mekanizmanın çözümüne yerine koyma zinciri %1 ister, $P_r$ matrisinin tersi ve çarpımı %2.</translation>
    </message>
    <message>
        <source>It needs teeth and turning senses; the rows of $P$ need coordinates of axes and pitch points, and %1 from them.</source>
        <translation>Diş sayıları ve dönme yönleri yeter; $P$ matrisinin satırları eksenlerin ve hatve noktalarının koordinatlarını ve onlardan %1 ister.</translation>
    </message>
    <message>
        <source>It writes %1 in %2, the Matroid method %3 in %4.</source>
        <translation>%2 içinde %1 yazar; matroid yöntemi %4 içinde %3.</translation>
    </message>
    <message>
        <source>Once a row of $P$ is divided by a radius it is the terminal equation with its circuits put in: solved in the same order, both take the same steps.</source>
        <translation>$P$ matrisinin bir satırı bir yarıçapa bölününce, çevrimleri yerine konmuş uç denklemi olur: aynı sırayla çözülürse ikisi aynı adımları atar.</translation>
    </message>
    <message>
        <source>&quot;The only advantage of the Matroid method is the derivation of the relative velocities of the gears with respect to the carrier arm.&quot;</source>
        <translation>&quot;Matroid yönteminin tek üstünlüğü, dişlilerin taşıyıcı kola göre bağıl hızlarının türetilmesidir.&quot;</translation>
    </message>
    <message>
        <source>(15) gives them as vectors, for skew and meeting axes alike.</source>
        <translation>(15) onları vektör olarak verir, aykırı ve kesişen eksenler için de.</translation>
    </message>
    <message>
        <source>The chords of the T-T graph are velocities relative to the carrier, too.</source>
        <translation>T-T grafının kirişleri de taşıyıcıya göre hızlardır.</translation>
    </message>
    <message>
        <source>The rank of $P$ gives the degrees of freedom, redundant meshes and every valid set of inputs; the T-T graph takes the inputs as given.</source>
        <translation>$P$ matrisinin rankı serbestlik derecesini, fazlalık dişli çiftlerini ve her geçerli giriş kümesini verir; T-T grafı girişleri verilmiş sayar.</translation>
    </message>
    <message>
        <source>&quot;The sign of the gear ratio is obtained directly, without considering the turning direction.&quot;</source>
        <translation>&quot;Dişli oranının işareti, dönme yönü düşünülmeden doğrudan elde edilir.&quot;</translation>
    </message>
    <message>
        <source>The sign of each entry of $P$ is that of a difference of coordinates.</source>
        <translation>$P$ matrisinin her öğesinin işareti bir koordinat farkının işaretidir.</translation>
    </message>
    <message>
        <source>The senses have to be seen once a mesh: here %1 of %2 turn against each other, seen along their axes.</source>
        <translation>Dönme yönleri her dişli çifti için bir kez görülmelidir: burada eksenleri boyunca bakıldığında %2 içinden %1 ters yönde döner.</translation>
    </message>
    <message>
        <source>%1 pair</source>
        <translation>%1 çift</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 çift</translation>
    </message>
    <message>
        <source>Mesh %1</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>%1 points to link %2: its arrow ends there.</source>
        <translation>%1, %2 uzvuna yönelir: oku orada biter.</translation>
    </message>
    <message>
        <source>%1 leaves link %2: its arrow begins there.</source>
        <translation>%1, %2 uzvundan çıkar: oku orada başlar.</translation>
    </message>
    <message>
        <source>%1 goes from link %2 to link %3 and does not touch link %4.</source>
        <translation>%1, %2 uzvundan %3 uzvuna gider ve %4 uzvuna değmez.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground does not use %2.</source>
        <translation>%1 uzvundan sabit uzva giden yol %2 üzerinden geçmez.</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground runs along %2 (from %3 to %4).</source>
        <translation>%1 uzvundan sabit uzva giden yol %2 ile aynı yönde geçer (%3 ucundan %4 ucuna).</translation>
    </message>
    <message>
        <source>The walk from link %1 to the ground runs against %2 (from %3 to %4).</source>
        <translation>%1 uzvundan sabit uzva giden yol %2 ile ters yönde geçer (%3 ucundan %4 ucuna).</translation>
    </message>
    <message>
        <source>%1 is the cycle that %2 closes, walked along its arrow (from %3 to %4).</source>
        <translation>%1, %2 ile kapanan ve okunun yönünde (%3 ucundan %4 ucuna) dolaşılan çevrimdir.</translation>
    </message>
    <message>
        <source>A cycle of the basis holds one mesh, its own: %1 holds %2, not %3.</source>
        <translation>Tabanın bir çevriminde tek dişli çifti vardır, kendisininki: %1 içinde %2 var, %3 yok.</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 does not use %5.</source>
        <translation>%1, %2 boyunca dolaşılırken %3 ucundan %4 ucuna dönen yol %5 üzerinden geçmez.</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 runs along %5 (from %6 to %7).</source>
        <translation>%1, %2 boyunca dolaşılırken %3 ucundan %4 ucuna dönen yol %5 ile aynı yönde geçer (%6 ucundan %7 ucuna).</translation>
    </message>
    <message>
        <source>Walking %1 along %2, the path from %3 back to %4 runs against %5 (from %6 to %7).</source>
        <translation>%1, %2 boyunca dolaşılırken %3 ucundan %4 ucuna dönen yol %5 ile ters yönde geçer (%6 ucundan %7 ucuna).</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; its own arrow counts as 1.</source>
        <translation>%1 olmadan ağaç iki yarıya ayrılır; kendi oku 1 sayılır.</translation>
    </message>
    <message>
        <source>A cutset holds one turning joint, its own: %1, not %2.</source>
        <translation>Bir kesitlemede tek döner mafsal vardır, kendisininki: %1, %2 değil.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 stays in one of them.</source>
        <translation>%1 olmadan ağaç iki yarıya ayrılır; %2 bunlardan birinde kalır.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 crosses over in the direction of %1.</source>
        <translation>%1 olmadan ağaç iki yarıya ayrılır; %2, %1 yönünde karşıya geçer.</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; %2 crosses over against %1.</source>
        <translation>%1 olmadan ağaç iki yarıya ayrılır; %2, %1 yönüne ters karşıya geçer.</translation>
    </message>
    <message>
        <source>Cutset of %1, %2</source>
        <translation>%1 kesitlemesi, %2</translation>
    </message>
    <message>
        <source>%1, link %2</source>
        <translation>%1, %2 uzvu</translation>
    </message>
    <message>
        <source>Not in the paper.</source>
        <translation>Makalede yok.</translation>
    </message>
    <message>
        <source>The row divided by the radius of the head&apos;s gear: %1 turns about the axis of the tail&apos;s gear, which leaves the ratio i%2 = %3.</source>
        <translation>Baştaki dişlinin yarıçapına bölünmüş satır: %1 kuyruktaki dişlinin ekseninde döner, geriye i%2 = %3 oranı kalır.</translation>
    </message>
    <message>
        <source>The row divided by the radius of the head&apos;s gear: %1 turns about the axis of the head&apos;s gear, which leaves 1.</source>
        <translation>Baştaki dişlinin yarıçapına bölünmüş satır: %1 baştaki dişlinin ekseninde döner, geriye 1 kalır.</translation>
    </message>
    <message>
        <source>T times the moment of %1&apos;s axis about the pitch point of mesh %2, along the normal of the mesh: the radius of the tail&apos;s gear.</source>
        <translation>T çarpı %1 ekseninin %2 dişli çiftinin hatve noktasına göre momenti, çiftin normali boyunca: kuyruktaki dişlinin yarıçapı.</translation>
    </message>
    <message>
        <source>T times the moment of %1&apos;s axis about the pitch point of mesh %2, along the normal of the mesh: the radius of the head&apos;s gear.</source>
        <translation>T çarpı %1 ekseninin %2 dişli çiftinin hatve noktasına göre momenti, çiftin normali boyunca: baştaki dişlinin yarıçapı.</translation>
    </message>
    <message>
        <source>%1 does not use %2, so it has no part in the equation of mesh %3.</source>
        <translation>%1 çevrimi %2 üzerinden geçmez, bu yüzden %3 dişli çiftinin denkleminde yeri yoktur.</translation>
    </message>
    <message>
        <source>f-circuit matrix of the T–T graph</source>
        <translation>T–T grafının f-devre matrisi</translation>
    </message>
    <message>
        <source>A row for each f-circuit of the T–T graph: 1 for its own chord; a branch that counts with plus in the chord&apos;s velocity is −1, one that counts with minus is 1. Engaged couplings are chords, too. B ω = 0 holds for every motion.</source>
        <translation>T–T grafının her f-devresi için bir satır: kendi kirişi için 1; kirişin hızında artı ile sayılan dal −1, eksi ile sayılan dal 1&apos;dir. Bağlı kavramalar da kiriştir. B ω = 0 her hareket için geçerlidir.</translation>
    </message>
    <message>
        <source>f-cutset matrix of the T–T graph</source>
        <translation>T–T grafının f-kesitleme matrisi</translation>
    </message>
    <message>
        <source>A row for each branch of the T–T graph: 1 for its own torque, and the chords that cross the cut, with minus their entries in the f-circuits. Its rows are the equations of the T–T graph&apos;s statics, and B Q′ᵀ = 0.</source>
        <translation>T–T grafının her dalı için bir satır: kendi momenti için 1 ve kesiti geçen kirişler, f-devrelerindeki girdilerinin eksilisiyle. Satırları T–T grafının statik denklemleridir ve B Q′ᵀ = 0&apos;dır.</translation>
    </message>
    <message>
        <source>T-T circuit matrix</source>
        <translation>T-T çevrim matrisi</translation>
    </message>
    <message>
        <source>T-T cutset matrix</source>
        <translation>T-T kesitleme matrisi</translation>
    </message>
    <message>
        <source>The %1 component of the unit vector u along the axis of %2. Eqs. (7)-(9)</source>
        <translation>%2 ekseni boyunca u birim vektörünün %1 bileşeni. Denk. (7)-(9)</translation>
    </message>
    <message>
        <source>The %1 component of the moment of %2&apos;s axis about the pitch point of %3: how fast that point moves for one unit of speed. Eqs. (10)-(12)</source>
        <translation>%2 ekseninin %3 hatve noktasına göre momentinin %1 bileşeni: birim hızda o noktanın ne kadar hızlı hareket ettiği. Denk. (10)-(12)</translation>
    </message>
    <message>
        <source>Joint %1 over joint %2: %3</source>
        <translation>%1 mafsalı bölü %2 mafsalı: %3</translation>
    </message>
    <message>
        <source>Joint %1 does not feel input %2.</source>
        <translation>%1 mafsalı %2 girişinden etkilenmez.</translation>
    </message>
    <message>
        <source>How fast joint %1 turns for one unit of speed at joint %2, the other inputs at rest.</source>
        <translation>Öteki girişler dururken %2 mafsalının birim hızında %1 mafsalının ne kadar hızlı döndüğü.</translation>
    </message>
    <message>
        <source>With these teeth: %1.</source>
        <translation>Bu diş sayılarıyla: %1.</translation>
    </message>
    <message>
        <source>the chord of coupling %1</source>
        <translation>%1 kavramasının kirişi</translation>
    </message>
    <message>
        <source>the chord %1 from gear %2 to carrier %3</source>
        <translation>%2 dişlisinden %3 taşıyıcısına %1 kirişi</translation>
    </message>
    <message>
        <source>f-circuit of %1, %2: %3</source>
        <translation>%1 f-devresi, %2: %3</translation>
    </message>
    <message>
        <source>Eqs. (31) to (38)</source>
        <translation>Denklem (31)–(38)</translation>
    </message>
    <message>
        <source>The f-circuit that %1 closes: the chord itself counts as 1.</source>
        <translation>Kapattığı f-devresi (%1): kirişin kendisi 1 sayılır.</translation>
    </message>
    <message>
        <source>An f-circuit holds one chord, its own: here %1.</source>
        <translation>Bir f-devresi tek bir kiriş içerir, kendininkini: burada %1.</translation>
    </message>
    <message>
        <source>%1 is not between the ends of %2.</source>
        <translation>%1, şunun uçları arasında değil: %2.</translation>
    </message>
    <message>
        <source>The velocity of %1 is a sum of branches, in which %2 counts with plus. On one side with the chord it is −1.</source>
        <translation>Hız (%1) dalların toplamıdır; içinde %2 artı ile sayılır. Kirişle aynı yanda −1 olur.</translation>
    </message>
    <message>
        <source>The velocity of %1 is a sum of branches, in which %2 counts with minus. On one side with the chord it is 1.</source>
        <translation>Hız (%1) dalların toplamıdır; içinde %2 eksi ile sayılır. Kirişle aynı yanda 1 olur.</translation>
    </message>
    <message>
        <source>f-cutset of joint %1, %2: %3</source>
        <translation>%1 mafsalının f-kesiti, %2: %3</translation>
    </message>
    <message>
        <source>Without %1 the tree falls into two halves; the torque in the joint itself counts as 1.</source>
        <translation>%1 olmadan ağaç iki yarıya ayrılır; mafsalın kendi momenti 1 sayılır.</translation>
    </message>
    <message>
        <source>An f-cutset holds one branch, its own: %1, not %2.</source>
        <translation>Bir f-kesiti tek bir dal içerir, kendininkini: %1, %2 değil.</translation>
    </message>
    <message>
        <source>Both ends of %1 are in the same half without %2: its torque is not in this equation.</source>
        <translation>%2 olmadan iki uç da aynı yarıdadır (%1): momenti bu denklemde yok.</translation>
    </message>
    <message>
        <source>The torque of %1 acts across the cut, in the sense of %2: minus its entry in the f-circuit.</source>
        <translation>Moment (%1) kesitin iki yanı arasında etkir, %2 yönünde: f-devresindeki girdisinin eksilisi.</translation>
    </message>
    <message>
        <source>The torque of %1 acts across the cut, against the sense of %2: minus its entry in the f-circuit.</source>
        <translation>Moment (%1) kesitin iki yanı arasında etkir, %2 yönüne ters: f-devresindeki girdisinin eksilisi.</translation>
    </message>
    <message>
        <source>The centre of mass in the reference pose, in the base frame.</source>
        <translation>Referans konumda kütle merkezi, temel eksen takımında.</translation>
    </message>
    <message>
        <source>The moment of inertia about the centre of mass, about the direction of this axis of the base frame, in the reference pose.</source>
        <translation>Kütle merkezine göre, temel eksen takımının bu ekseni doğrultusundaki atalet momenti, referans konumda.</translation>
    </message>
    <message>
        <source>The link, by its number.</source>
        <translation>Uzuv, numarasıyla.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>kütle</translation>
    </message>
    <message>
        <source>The mass: of the link&apos;s solids at the density, or as it is stated.</source>
        <translation>Kütle: uzvun katı modellerinden, yoğunlukla, ya da verildiği gibi.</translation>
    </message>
    <message>
        <source>Where the mass comes from: the link&apos;s solids, or the document, which states it.</source>
        <translation>Kütlenin kaynağı: uzvun katı modelleri ya da onu veren belge.</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>%1 mafsalında</translation>
    </message>
    <message>
        <source>The inertia that the link has at the motor of joint %1 while the other inputs stand still: for a link that turns about one axis its moment of inertia times the square of its ratio.</source>
        <translation>Öteki girişler dururken uzvun %1 mafsalının motorundaki ataleti: tek eksende dönen bir uzuv için atalet momenti çarpı oranının karesi.</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>toplam</translation>
    </message>
    <message>
        <source>The joint of the input, by its number.</source>
        <translation>Giriş mafsalı, numarasıyla.</translation>
    </message>
    <message>
        <source>The generalised inertia: the torque in the row&apos;s joint for each rad/s² of joint %1.</source>
        <translation>Genelleştirilmiş atalet: %1 mafsalının her rad/s² ivmesi için satırdaki mafsalın torku.</translation>
    </message>
    <message>
        <source>What motors have to give at constant speeds, for Coriolis and centrifugal forces and for weight.</source>
        <translation>Sabit hızlarda motorların Coriolis ve merkezkaç kuvvetleri ile ağırlık için vermesi gereken.</translation>
    </message>
    <message>
        <source>load</source>
        <translation>yük</translation>
    </message>
    <message>
        <source>What the loads contribute, as a torque in the row&apos;s joint.</source>
        <translation>Yüklerin katkısı, satırdaki mafsalda tork olarak.</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>tutan</translation>
    </message>
    <message>
        <source>The torque of the motor that keeps the speeds constant: h less the load.</source>
        <translation>Hızları sabit tutan motor torku: h eksi yük.</translation>
    </message>
    <message>
        <source>no solid: massless</source>
        <translation>katı model yok: kütlesiz</translation>
    </message>
    <message>
        <source>solids</source>
        <translation>katı modeller</translation>
    </message>
    <message>
        <source>stated, spread as its solids</source>
        <translation>verilmiş, katı modelleri gibi dağıtılmış</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>verilmiş</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 2^64 - 1, in quotes.</source>
        <translation>Tohum, tırnak içinde 0 ile 2^64 - 1 arasında bir tam sayıdır.</translation>
    </message>
    <message>
        <source>The sheet was made by another version of the program, whose questions this one cannot make again.</source>
        <translation>Sayfa, programın başka bir sürümüyle hazırlanmış; bu sürüm onun sorularını yeniden üretemez.</translation>
    </message>
    <message>
        <source>A sheet has 1 to 1,000 variants.</source>
        <translation>Bir sayfanın 1 ile 1.000 arası sürümü olur.</translation>
    </message>
    <message>
        <source>There is no kind of question &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; diye bir soru türü yok.</translation>
    </message>
    <message>
        <source>A sheet has 1 to 100 questions.</source>
        <translation>Bir sayfada 1 ile 100 arası soru olur.</translation>
    </message>
    <message>
        <source>%1 = 0, shared in unknown parts</source>
        <translation>%1 = 0, bilinmeyen paylarla bölüşülüyor</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: no mesh crosses.</source>
        <translation>%1 mafsalı %2 uzvunu ayırır: kesen dişli çifti yok.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: mesh %3 crosses.</source>
        <translation>%1 mafsalı %2 uzvunu ayırır: %3 dişli çifti keser.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off link %2: meshes %3 cross.</source>
        <translation>%1 mafsalı %2 uzvunu ayırır: %3 dişli çiftleri keser.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: no mesh crosses.</source>
        <translation>%1 mafsalı %2 uzuvlarını ayırır: kesen dişli çifti yok.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: mesh %3 crosses.</source>
        <translation>%1 mafsalı %2 uzuvlarını ayırır: %3 dişli çifti keser.</translation>
    </message>
    <message>
        <source>Joint %1 cuts off links %2: meshes %3 cross.</source>
        <translation>%1 mafsalı %2 uzuvlarını ayırır: %3 dişli çiftleri keser.</translation>
    </message>
    <message>
        <source>T(link %1)</source>
        <translation>T(uzuv %1)</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>yükler</translation>
    </message>
    <message>
        <source>Which gear drives in mesh %1 depends on how the load is shared.</source>
        <translation>%1 dişli çiftinde hangi dişlinin tahrik ettiği yükün nasıl paylaşıldığına bağlıdır.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from the ground, it bears no load.</source>
        <translation>%1 dişli çiftinde tahrik eden dişli yok: sabit uzuvdan bakıldığında yük taşımaz.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from carrier %2, it bears no load.</source>
        <translation>%1 dişli çiftinde tahrik eden dişli yok: %2 taşıyıcısından bakıldığında yük taşımaz.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from the ground, it does not roll.</source>
        <translation>%1 dişli çiftinde tahrik eden dişli yok: sabit uzuvdan bakıldığında yuvarlanmaz.</translation>
    </message>
    <message>
        <source>No gear drives in mesh %1: seen from carrier %2, it does not roll.</source>
        <translation>%1 dişli çiftinde tahrik eden dişli yok: %2 taşıyıcısından bakıldığında yuvarlanmaz.</translation>
    </message>
    <message>
        <source>Gear %1 drives gear %2 in mesh %3: seen from the ground, it turns against the teeth&apos;s torque on it and passes %4 W.</source>
        <translation>%3 dişli çiftinde %1 dişlisi %2 dişlisini tahrik eder: sabit uzuvdan bakıldığında, dişlerin ona uyguladığı torka karşı döner ve %4 W iletir.</translation>
    </message>
    <message>
        <source>Gear %1 drives gear %2 in mesh %3: seen from carrier %5, it turns against the teeth&apos;s torque on it and passes %4 W.</source>
        <translation>%3 dişli çiftinde %1 dişlisi %2 dişlisini tahrik eder: %5 taşıyıcısından bakıldığında, dişlerin ona uyguladığı torka karşı döner ve %4 W iletir.</translation>
    </message>
    <message>
        <source>efficiency of every mesh</source>
        <translation>her dişli çiftinin verimi</translation>
    </message>
    <message>
        <source>speed of joint %1 / joint %2</source>
        <translation>%1 mafsalının hızı / %2 mafsalının hızı</translation>
    </message>
    <message>
        <source>What the efficiency is followed over.</source>
        <translation>Verimin neye göre izlendiği.</translation>
    </message>
    <message>
        <source>efficiency backward</source>
        <translation>ters yönde verim</translation>
    </message>
    <message>
        <source>The same with every known torque reversed: the output drives.</source>
        <translation>Aynısı, bilinen her tork ters çevrilmiş: çıkış tahrik eder.</translation>
    </message>
    <message>
        <source>torque at %1</source>
        <translation>tork: %1</translation>
    </message>
    <message>
        <source>What holds the loads there.</source>
        <translation>Yükleri orada tutan.</translation>
    </message>
    <message>
        <source>load and balance</source>
        <translation>yük ve denge</translation>
    </message>
    <message>
        <source>balance</source>
        <translation>denge</translation>
    </message>
    <message>
        <source>free</source>
        <translation>serbest</translation>
    </message>
    <message>
        <source>A turning joint, by its label, or a link on which a load or a balance acts from outside.</source>
        <translation>Etiketiyle bir döner mafsal ya da dışarıdan yük veya denge etkiyen bir uzuv.</translation>
    </message>
    <message>
        <source>The link beyond the joint, seen from the ground.</source>
        <translation>Sabit uzuvdan bakıldığında mafsalın ötesindeki uzuv.</translation>
    </message>
    <message>
        <source>carried by</source>
        <translation>taşıyan</translation>
    </message>
    <message>
        <source>What puts a torque in: a load that is given, a balance that is found, or nothing: a free joint.</source>
        <translation>Torku veren: belirtilen bir yük, bulunan bir denge, ya da hiçbiri: serbest mafsal.</translation>
    </message>
    <message>
        <source>lossless</source>
        <translation>kayıpsız</translation>
    </message>
    <message>
        <source>The torque that the joint&apos;s tail exerts on its head about the axis, of a train without losses.</source>
        <translation>Kayıpsız bir takımda mafsalın kuyruğunun başına eksen etrafında uyguladığı tork.</translation>
    </message>
    <message>
        <source>exact torque</source>
        <translation>kesin tork</translation>
    </message>
    <message>
        <source>The same with the losses of the meshes, where they are given.</source>
        <translation>Aynısı, verilmişse dişli çiftlerinin kayıplarıyla.</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>tork</translation>
    </message>
    <message>
        <source>The same as a decimal.</source>
        <translation>Aynısı ondalık olarak.</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>hız</translation>
    </message>
    <message>
        <source>How fast the head turns against the tail.</source>
        <translation>Başın kuyruğa göre ne kadar hızlı döndüğü.</translation>
    </message>
    <message>
        <source>power</source>
        <translation>güç</translation>
    </message>
    <message>
        <source>Torque times rate: what load or balance feed into the train here; below 0: what they take.</source>
        <translation>Tork çarpı hız: yük veya dengenin burada takıma verdiği güç; 0&apos;ın altında: aldığı.</translation>
    </message>
    <message>
        <source>force</source>
        <translation>kuvvet</translation>
    </message>
    <message>
        <source>coupling</source>
        <translation>fren veya kavrama</translation>
    </message>
    <message>
        <source>A brake or clutch that is engaged.</source>
        <translation>Devredeki bir fren veya kavrama.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>tutar</translation>
    </message>
    <message>
        <source>The link that a brake holds; the two links that a clutch joins, the torque acts on the first one.</source>
        <translation>Frenin tuttuğu uzuv; kavramanın birleştirdiği iki uzuv, tork birincisine etkir.</translation>
    </message>
    <message>
        <source>about</source>
        <translation>eksen</translation>
    </message>
    <message>
        <source>The axis that the torque is about, the first one on the way to the ground.</source>
        <translation>Torkun etrafında etkidiği eksen, sabit uzva giden yoldaki ilk eksen.</translation>
    </message>
    <message>
        <source>The torque on that link, with the losses where they are given.</source>
        <translation>O uzuvdaki tork, verilmişse kayıplarla.</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>iletilen</translation>
    </message>
    <message>
        <source>The power that a clutch delivers to the first link; a brake passes none.</source>
        <translation>Kavramanın birinci uzva verdiği güç; fren güç iletmez.</translation>
    </message>
    <message>
        <source>The gear mesh, by its label.</source>
        <translation>Dişli çifti, etiketiyle.</translation>
    </message>
    <message>
        <source>The link of the tail&apos;s gear.</source>
        <translation>Kuyruktaki dişlinin uzvu.</translation>
    </message>
    <message>
        <source>The link of the head&apos;s gear.</source>
        <translation>Baştaki dişlinin uzvu.</translation>
    </message>
    <message>
        <source>carrier</source>
        <translation>taşıyıcı</translation>
    </message>
    <message>
        <source>The link that holds both gears&apos; axes, from which the mesh is seen.</source>
        <translation>İki dişlinin eksenini tutan ve dişli çiftinin görüldüğü uzuv.</translation>
    </message>
    <message>
        <source>on tail</source>
        <translation>kuyrukta</translation>
    </message>
    <message>
        <source>The torque of the mesh on the tail&apos;s gear about its own axis, seen from the carrier.</source>
        <translation>Dişli çiftinin kuyruktaki dişliye, onun kendi ekseni etrafında uyguladığı tork, taşıyıcıdan bakıldığında.</translation>
    </message>
    <message>
        <source>on head</source>
        <translation>başta</translation>
    </message>
    <message>
        <source>The torque of the mesh on the head&apos;s gear about its own axis, seen from the carrier.</source>
        <translation>Dişli çiftinin baştaki dişliye, onun kendi ekseni etrafında uyguladığı tork, taşıyıcıdan bakıldığında.</translation>
    </message>
    <message>
        <source>tangential</source>
        <translation>teğetsel</translation>
    </message>
    <message>
        <source>The force along the pitch circles&apos; tangent, of the tail&apos;s gear on the head&apos;s.</source>
        <translation>Taksimat dairelerinin teğeti boyunca, kuyruktaki dişliden baştakine kuvvet.</translation>
    </message>
    <message>
        <source>separating</source>
        <translation>ayırıcı</translation>
    </message>
    <message>
        <source>The force that presses the gears apart: the tangential one times the tangent of the operating pressure angle.</source>
        <translation>Dişlileri birbirinden iten kuvvet: teğetsel kuvvet çarpı işletme kavrama açısının tanjantı.</translation>
    </message>
    <message>
        <source>The whole tooth force on the head&apos;s gear, in the base frame.</source>
        <translation>Baştaki dişliye etkiyen toplam diş kuvveti, temel eksen takımında.</translation>
    </message>
    <message>
        <source>Power delivered over power taken, seen from the carrier.</source>
        <translation>Verilen güç bölü alınan güç, taşıyıcıdan bakıldığında.</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>tahrik eder</translation>
    </message>
    <message>
        <source>The gear that delivers the power to the teeth, seen from the carrier.</source>
        <translation>Taşıyıcıdan bakıldığında dişlere gücü veren dişli.</translation>
    </message>
    <message>
        <source>rolling power</source>
        <translation>yuvarlanma gücü</translation>
    </message>
    <message>
        <source>What the teeth pass from tail to head, seen from the carrier: the latent power.</source>
        <translation>Taşıyıcıdan bakıldığında dişlerin kuyruktan başa ilettiği: gizli güç.</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>kayıp</translation>
    </message>
    <message>
        <source>One minus the efficiency, times the rolling power.</source>
        <translation>Bir eksi verim, çarpı yuvarlanma gücü.</translation>
    </message>
    <message>
        <source>to tail</source>
        <translation>kuyruğa</translation>
    </message>
    <message>
        <source>What the mesh delivers to the tail&apos;s gear, seen from the ground.</source>
        <translation>Sabit uzuvdan bakıldığında dişli çiftinin kuyruktaki dişliye verdiği.</translation>
    </message>
    <message>
        <source>to head</source>
        <translation>başa</translation>
    </message>
    <message>
        <source>What the mesh delivers to the head&apos;s gear, seen from the ground.</source>
        <translation>Sabit uzuvdan bakıldığında dişli çiftinin baştaki dişliye verdiği.</translation>
    </message>
    <message>
        <source>to carrier</source>
        <translation>taşıyıcıya</translation>
    </message>
    <message>
        <source>What the mesh delivers to the carrier, seen from the ground.</source>
        <translation>Sabit uzuvdan bakıldığında dişli çiftinin taşıyıcıya verdiği.</translation>
    </message>
    <message>
        <source>The turning joint, whose bearing holds its head on its tail.</source>
        <translation>Yatağı, başını kuyruğunda tutan döner mafsal.</translation>
    </message>
    <message>
        <source>The size of the force of the tail on the head.</source>
        <translation>Kuyruğun başa uyguladığı kuvvetin büyüklüğü.</translation>
    </message>
    <message>
        <source>The force of the tail on the head, in the base frame.</source>
        <translation>Kuyruğun başa uyguladığı kuvvet, temel eksen takımında.</translation>
    </message>
    <message>
        <source>The moment of the tail on the head about the point, with the joint&apos;s own torque.</source>
        <translation>Kuyruğun başa, noktaya göre uyguladığı moment, mafsalın kendi torkuyla.</translation>
    </message>
    <message>
        <source>Where the joint is drawn: the point that the moment is about, in the document&apos;s unit.</source>
        <translation>Mafsalın çizildiği yer: momentin alındığı nokta, belgenin biriminde.</translation>
    </message>
    <message>
        <source>Where the joint is drawn, in the document&apos;s unit.</source>
        <translation>Mafsalın çizildiği yer, belgenin biriminde.</translation>
    </message>
    <message>
        <source>A mesh, a joint, an engaged coupling, a load or a balance.</source>
        <translation>Bir dişli çifti, mafsal, devredeki fren veya kavrama, yük ya da denge.</translation>
    </message>
    <message>
        <source>The link that it acts on.</source>
        <translation>Etkidiği uzuv.</translation>
    </message>
    <message>
        <source>exact power</source>
        <translation>kesin güç</translation>
    </message>
    <message>
        <source>What the element delivers to the link, seen from the ground; below 0: what it takes from it. The sum at every link is 0.</source>
        <translation>Sabit uzuvdan bakıldığında öğenin uzva verdiği; 0&apos;ın altında: uzuvdan aldığı. Her uzuvdaki toplam 0&apos;dır.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pay</translation>
    </message>
    <message>
        <source>Of the power fed into the train.</source>
        <translation>Takıma verilen güce göre.</translation>
    </message>
    <message>
        <source>load on link %1</source>
        <translation>%1 uzvundaki yük</translation>
    </message>
    <message>
        <source>balance on link %1</source>
        <translation>%1 uzvundaki denge</translation>
    </message>
    <message>
        <source>The least power on the loop: what goes round beside what goes through.</source>
        <translation>Çevrimdeki en küçük güç: geçenin yanında dolaşan.</translation>
    </message>
    <message>
        <source>The shafts of the loop.</source>
        <translation>Çevrimin milleri.</translation>
    </message>
    <message>
        <source>meshes</source>
        <translation>dişli çiftleri</translation>
    </message>
    <message>
        <source>The meshes of the gear sets of the loop.</source>
        <translation>Çevrimdeki dişli takımlarının dişli çiftleri.</translation>
    </message>
    <message>
        <source>Bearings</source>
        <translation>Yataklar</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Güç</translation>
    </message>
    <message>
        <source>Circulating power</source>
        <translation>Dolaşan güç</translation>
    </message>
    <message>
        <source>The state of the gearbox, by its name.</source>
        <translation>Vites kutusunun durumu, adıyla.</translation>
    </message>
    <message>
        <source>The torque that the brake exerts on its link while it is engaged.</source>
        <translation>Fren devredeyken uzvuna uyguladığı tork.</translation>
    </message>
    <message>
        <source>The torque that the clutch exerts on the first of its links while it is engaged; the second one has the reaction.</source>
        <translation>Kavrama devredeyken birinci uzvuna uyguladığı tork; ikincisi tepkiyi alır.</translation>
    </message>
    <message>
        <source>exact ratio</source>
        <translation>kesin oran</translation>
    </message>
    <message>
        <source>The speed of the drive over that of the driven link.</source>
        <translation>Tahrik eden uzvun hızı bölü tahrik edilenin hızı.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>bulunan</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving.</source>
        <translation>Alınan güç bölü verilen güç, giriş tahrik ederken.</translation>
    </message>
    <message>
        <source>The same with all known torques reversed: the output drives.</source>
        <translation>Aynısı, bilinen bütün torklar ters çevrilmiş: çıkış tahrik eder.</translation>
    </message>
    <message>
        <source>latent</source>
        <translation>gizli</translation>
    </message>
    <message>
        <source>The power that all meshes pass, seen from their carriers, over the power fed.</source>
        <translation>Bütün dişli çiftlerinin taşıyıcılarından görülen gücü bölü verilen güç.</translation>
    </message>
    <message>
        <source>circulating</source>
        <translation>dolaşan</translation>
    </message>
    <message>
        <source>The greatest power that goes round in a loop, for each watt that is fed.</source>
        <translation>Verilen her watt için bir çevrimde dolaşan en büyük güç.</translation>
    </message>
    <message>
        <source>locks</source>
        <translation>kilitler</translation>
    </message>
    <message>
        <source>An object is needed here.</source>
        <translation>Burada bir nesne gerekli.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is missing.</source>
        <translation>&quot;%1&quot; üyesi eksik.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is of the wrong type.</source>
        <translation>&quot;%1&quot; üyesinin türü yanlış.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>Burada bir tam sayı gerekli.</translation>
    </message>
    <message>
        <source>An array is needed here.</source>
        <translation>Burada bir dizi gerekli.</translation>
    </message>
    <message>
        <source>A text is needed here.</source>
        <translation>Burada bir metin gerekli.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no list of the document with an id.</source>
        <translation>&quot;%1&quot;, belgenin kimlikli bir listesi değil.</translation>
    </message>
    <message>
        <source>This is no file of the format &quot;%1&quot;.</source>
        <translation>Bu, &quot;%1&quot; biçiminde bir dosya değil.</translation>
    </message>
    <message>
        <source>Version %1 is not known to this program.</source>
        <translation>Bu program %1 sürümünü bilmiyor.</translation>
    </message>
    <message>
        <source>field left empty</source>
        <translation>alan boş bırakılmış</translation>
    </message>
    <message>
        <source>text that is no number</source>
        <translation>sayı olmayan metin</translation>
    </message>
    <message>
        <source>comma that may be a decimal or a thousand</source>
        <translation>ondalık ya da binlik olabilecek virgül</translation>
    </message>
    <message>
        <source>text that the question does not offer</source>
        <translation>sorunun sunmadığı metin</translation>
    </message>
    <message>
        <source>incidence with + and − exchanged</source>
        <translation>+ ve − yer değiştirmiş bağlantı</translation>
    </message>
    <message>
        <source>tail and head of an arrow exchanged</source>
        <translation>bir okun kuyruğu ve başı yer değiştirmiş</translation>
    </message>
    <message>
        <source>signs left out</source>
        <translation>işaretler yazılmamış</translation>
    </message>
    <message>
        <source>an end of an arrow left out</source>
        <translation>bir okun bir ucu yazılmamış</translation>
    </message>
    <message>
        <source>a link that is no end of the arrow</source>
        <translation>okun ucu olmayan bir uzuv</translation>
    </message>
    <message>
        <source>ground row left in</source>
        <translation>sabit uzuv satırı bırakılmış</translation>
    </message>
    <message>
        <source>ground row left out</source>
        <translation>sabit uzuv satırı atılmış</translation>
    </message>
    <message>
        <source>rows and columns exchanged</source>
        <translation>satır ve sütunlar yer değiştirmiş</translation>
    </message>
    <message>
        <source>entry that is not −1, 0 or 1</source>
        <translation>−1, 0 veya 1 olmayan öğe</translation>
    </message>
    <message>
        <source>arrow walked against its direction</source>
        <translation>okta ters yönde gidilmiş</translation>
    </message>
    <message>
        <source>joint of the walk left out</source>
        <translation>yoldaki mafsal atlanmış</translation>
    </message>
    <message>
        <source>joint that is not on the walk</source>
        <translation>yolda olmayan mafsal</translation>
    </message>
    <message>
        <source>another cycle&apos;s row</source>
        <translation>başka bir çevrimin satırı</translation>
    </message>
    <message>
        <source>cycle walked against its mesh</source>
        <translation>çevrim, dişli çiftine ters yönde dolaşılmış</translation>
    </message>
    <message>
        <source>the cycle&apos;s own mesh left out</source>
        <translation>çevrimin kendi dişli çifti yazılmamış</translation>
    </message>
    <message>
        <source>another mesh in the cycle</source>
        <translation>çevrimde başka bir dişli çifti</translation>
    </message>
    <message>
        <source>walked from the ground instead of to it</source>
        <translation>sabit uzva doğru değil, ondan gidilmiş</translation>
    </message>
    <message>
        <source>another link&apos;s walk</source>
        <translation>başka bir uzvun yolu</translation>
    </message>
    <message>
        <source>another joint&apos;s cutset</source>
        <translation>başka bir mafsalın kesitlemesi</translation>
    </message>
    <message>
        <source>signs of the cycle instead of the cutset</source>
        <translation>kesitleme yerine çevrimin işaretleri</translation>
    </message>
    <message>
        <source>mesh that the cutset does not cut</source>
        <translation>kesitlemenin kesmediği dişli çifti</translation>
    </message>
    <message>
        <source>mesh that the cutset cuts left out</source>
        <translation>kesitlemenin kestiği dişli çifti yazılmamış</translation>
    </message>
    <message>
        <source>edge that crosses the cut the other way</source>
        <translation>kesiti öbür yönde geçen kenar</translation>
    </message>
    <message>
        <source>another turning joint in the cutset</source>
        <translation>kesitlemede başka bir döner mafsal</translation>
    </message>
    <message>
        <source>mesh listed among the turning joints</source>
        <translation>dişli çifti döner mafsallar arasında sayılmış</translation>
    </message>
    <message>
        <source>both paths followed to the ground</source>
        <translation>iki yol da sabit uzva kadar izlenmiş</translation>
    </message>
    <message>
        <source>path of one gear only</source>
        <translation>yalnız bir dişlinin yolu</translation>
    </message>
    <message>
        <source>too few edges for a spanning tree</source>
        <translation>kapsayan ağaç için çok az kenar</translation>
    </message>
    <message>
        <source>too many edges for a spanning tree</source>
        <translation>kapsayan ağaç için çok fazla kenar</translation>
    </message>
    <message>
        <source>edges that close a loop</source>
        <translation>döngü kapatan kenarlar</translation>
    </message>
    <message>
        <source>the required edge is not in the tree</source>
        <translation>istenen kenar ağaçta değil</translation>
    </message>
    <message>
        <source>senses that do not follow one walk</source>
        <translation>tek bir tura uymayan yönler</translation>
    </message>
    <message>
        <source>ratio upside down</source>
        <translation>oran ters</translation>
    </message>
    <message>
        <source>internal mesh with an external sign</source>
        <translation>iç dişli çifti, dış çift işaretiyle</translation>
    </message>
    <message>
        <source>external mesh with an internal sign</source>
        <translation>dış dişli çifti, iç çift işaretiyle</translation>
    </message>
    <message>
        <source>sign of a bevel mesh</source>
        <translation>konik dişli çiftinin işareti</translation>
    </message>
    <message>
        <source>sign wrong and ratio upside down</source>
        <translation>işaret yanlış ve oran ters</translation>
    </message>
    <message>
        <source>row of C in place of P</source>
        <translation>P yerine C satırı</translation>
    </message>
    <message>
        <source>coefficients without the signs of the cycle</source>
        <translation>çevrimin işaretleri olmadan katsayılar</translation>
    </message>
    <message>
        <source>teeth of another wheel on the same link</source>
        <translation>aynı uzuvdaki başka bir dişlinin dişleri</translation>
    </message>
    <message>
        <source>chord followed from the carrier to the gear</source>
        <translation>kiriş, taşıyıcıdan dişliye izlenmiş</translation>
    </message>
    <message>
        <source>circuit of the other chord</source>
        <translation>öteki kirişin çevrimi</translation>
    </message>
    <message>
        <source>circuit followed to the ground instead of the carrier</source>
        <translation>çevrim taşıyıcı yerine sabit uzva kadar izlenmiş</translation>
    </message>
    <message>
        <source>circuit of the whole walk between the gears</source>
        <translation>dişliler arasındaki bütün yolun çevrimi</translation>
    </message>
    <message>
        <source>levels of the two gears exchanged</source>
        <translation>iki dişlinin düzeyleri yer değiştirmiş</translation>
    </message>
    <message>
        <source>transfer vertex where the level does not change</source>
        <translation>düzeyin değişmediği yerde aktarma düğümü</translation>
    </message>
    <message>
        <source>gear taken for the carrier</source>
        <translation>dişli taşıyıcı sanılmış</translation>
    </message>
    <message>
        <source>ground taken for the carrier</source>
        <translation>sabit uzuv taşıyıcı sanılmış</translation>
    </message>
    <message>
        <source>carrier that is not on the path</source>
        <translation>yolda olmayan taşıyıcı</translation>
    </message>
    <message>
        <source>level that is not on the path</source>
        <translation>yolda olmayan düzey</translation>
    </message>
    <message>
        <source>velocity relation used for torques</source>
        <translation>tork için hız bağıntısı kullanılmış</translation>
    </message>
    <message>
        <source>port torque with the wrong sign</source>
        <translation>bağlantı torku yanlış işaretle</translation>
    </message>
    <message>
        <source>Kutzbach&apos;s count where a mesh is redundant</source>
        <translation>fazlalık dişli çifti varken Kutzbach sayımı</translation>
    </message>
    <message>
        <source>ground counted as a moving link</source>
        <translation>sabit uzuv hareketli uzuv sayılmış</translation>
    </message>
    <message>
        <source>rank and degrees of freedom exchanged</source>
        <translation>rank ve serbestlik derecesi yer değiştirmiş</translation>
    </message>
    <message>
        <source>two freedoms taken by a mesh</source>
        <translation>bir dişli çiftine iki serbestlik aldırılmış</translation>
    </message>
    <message>
        <source>meshes ignored</source>
        <translation>dişli çiftleri göz ardı edilmiş</translation>
    </message>
    <message>
        <source>degrees of freedom that are not t − r</source>
        <translation>t − r olmayan serbestlik derecesi</translation>
    </message>
    <message>
        <source>too few inputs</source>
        <translation>çok az giriş</translation>
    </message>
    <message>
        <source>inputs that depend on each other</source>
        <translation>birbirine bağlı girişler</translation>
    </message>
    <message>
        <source>a joint that can never turn as input</source>
        <translation>hiç dönemeyen mafsal giriş seçilmiş</translation>
    </message>
    <message>
        <source>a joint that no mesh drives is not an input</source>
        <translation>hiçbir dişli çiftinin tahrik etmediği mafsal giriş alınmamış</translation>
    </message>
    <message>
        <source>mesh on which no other depends</source>
        <translation>başka hiçbirinin bağlı olmadığı dişli çifti</translation>
    </message>
    <message>
        <source>no mesh taken for redundant</source>
        <translation>hiçbir dişli çifti fazlalık sayılmamış</translation>
    </message>
    <message>
        <source>number of redundant meshes</source>
        <translation>fazlalık dişli çiftlerinin sayısı</translation>
    </message>
    <message>
        <source>sign of the speed lost</source>
        <translation>hızın işareti kaybolmuş</translation>
    </message>
    <message>
        <source>an input ignored</source>
        <translation>bir giriş göz ardı edilmiş</translation>
    </message>
    <message>
        <source>sign of one mesh in the chain</source>
        <translation>zincirdeki bir dişli çiftinin işareti</translation>
    </message>
    <message>
        <source>absolute speed in place of the joint&apos;s rate</source>
        <translation>mafsalın hızı yerine mutlak hız</translation>
    </message>
    <message>
        <source>motion of the carrier ignored</source>
        <translation>taşıyıcının hareketi göz ardı edilmiş</translation>
    </message>
    <message>
        <source>whole ratio upside down</source>
        <translation>toplam oran ters</translation>
    </message>
    <message>
        <source>number of teeth out of the range</source>
        <translation>aralık dışında diş sayısı</translation>
    </message>
    <message>
        <source>teeth that do not make the ratio</source>
        <translation>oranı vermeyen dişler</translation>
    </message>
    <message>
        <source>teeth of the ring added</source>
        <translation>çember dişlinin dişleri toplanmış</translation>
    </message>
    <message>
        <source>planet counted once in the ring</source>
        <translation>gezegen çemberde bir kez sayılmış</translation>
    </message>
    <message>
        <source>couplings of another gear</source>
        <translation>başka bir vitesin elemanları</translation>
    </message>
    <message>
        <source>couplings that lock the drive</source>
        <translation>şanzımanı kilitleyen elemanlar</translation>
    </message>
    <message>
        <source>too few couplings to leave one freedom</source>
        <translation>tek serbestlik bırakmaya yetmeyen elemanlar</translation>
    </message>
    <message>
        <source>couplings that make another ratio</source>
        <translation>başka bir oran veren elemanlar</translation>
    </message>
    <message>
        <source>brake or clutch that is released</source>
        <translation>devrede olmayan fren veya kavrama</translation>
    </message>
    <message>
        <source>a smaller torque taken for the largest</source>
        <translation>daha küçük bir tork en büyük sanılmış</translation>
    </message>
    <message>
        <source>the fastest clutch instead of that of the largest torque</source>
        <translation>en büyük torklu yerine en hızlı kavrama</translation>
    </message>
    <message>
        <source>the largest ratio instead of the largest torque</source>
        <translation>en büyük tork yerine en büyük oran</translation>
    </message>
    <message>
        <source>torques added without their signs</source>
        <translation>torklar işaretsiz toplanmış</translation>
    </message>
    <message>
        <source>torque of another brake, clutch or state</source>
        <translation>başka bir fren, kavrama veya durumun torku</translation>
    </message>
    <message>
        <source>torque of the load in place of that of the brake</source>
        <translation>fren torku yerine yükün torku</translation>
    </message>
    <message>
        <source>torque of the drive in place of that of the brake</source>
        <translation>fren torku yerine tahrikin torku</translation>
    </message>
    <message>
        <source>torque on the housing in place of that on the link</source>
        <translation>uzuv yerine gövdeye etkiyen tork</translation>
    </message>
    <message>
        <source>brake that turns link and housing in the same sense</source>
        <translation>uzvu ve gövdeyi aynı yönde döndüren fren</translation>
    </message>
    <message>
        <source>efficiency forward in place of backward</source>
        <translation>geri yerine ileri yönde verim</translation>
    </message>
    <message>
        <source>losses left out</source>
        <translation>kayıplar hesaba katılmamış</translation>
    </message>
    <message>
        <source>losses of a planetary train as of fixed axes</source>
        <translation>planet takımının kayıpları sabit eksenliymiş gibi</translation>
    </message>
    <message>
        <source>efficiency upside down</source>
        <translation>verim ters</translation>
    </message>
    <message>
        <source>self-locking train taken for one that turns</source>
        <translation>kendini kilitleyen takım döner sanılmış</translation>
    </message>
    <message>
        <source>train that turns taken for a self-locking one</source>
        <translation>dönen takım kendini kilitler sanılmış</translation>
    </message>
    <message>
        <source>efficiency of a train that locks itself</source>
        <translation>kendini kilitleyen takımın verimi</translation>
    </message>
    <message>
        <source>right row, wrong column</source>
        <translation>doğru satır, yanlış sütun</translation>
    </message>
    <message>
        <source>right column, wrong row</source>
        <translation>doğru sütun, yanlış satır</translation>
    </message>
    <message>
        <source>an entry that is right</source>
        <translation>doğru olan bir öğe</translation>
    </message>
    <message>
        <source>right place, wrong correction</source>
        <translation>doğru yer, yanlış düzeltme</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here.</source>
        <translation>&quot;%1&quot; burada bilinmiyor.</translation>
    </message>
    <message>
        <source>This part does not fit the fields of its question.</source>
        <translation>Bu bölüm sorusunun alanlarına uymuyor.</translation>
    </message>
    <message>
        <source>Answers are kept by the number of their question.</source>
        <translation>Yanıtlar sorularının numarasıyla tutulur.</translation>
    </message>
    <message>
        <source>An answer is a text or a number.</source>
        <translation>Yanıt bir metin ya da sayıdır.</translation>
    </message>
    <message>
        <source>There is no example &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; diye bir örnek yok.</translation>
    </message>
    <message>
        <source>The glossary has no term &quot;%1&quot;.</source>
        <translation>Sözlükte &quot;%1&quot; terimi yok.</translation>
    </message>
    <message>
        <source>The solution is not accepted.</source>
        <translation>Çözüm kabul edilmiyor.</translation>
    </message>
    <message>
        <source>An answer has a text for each field.</source>
        <translation>Yanıtta her alan için bir metin bulunur.</translation>
    </message>
    <message>
        <source>This answer is accepted as right.</source>
        <translation>Bu yanıt doğru kabul ediliyor.</translation>
    </message>
    <message>
        <source>This answer gets another reason: &quot;%1&quot;</source>
        <translation>Bu yanıta başka bir gerekçe veriliyor: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>The document of the step fulfils them already: nothing is left to draw.</source>
        <translation>Adımın belgesi bunları zaten sağlıyor: çizilecek bir şey kalmıyor.</translation>
    </message>
    <message>
        <source>The solution is not accepted: %1</source>
        <translation>Çözüm kabul edilmiyor: %1</translation>
    </message>
    <message>
        <source>This drawing is accepted as right.</source>
        <translation>Bu çizim doğru kabul ediliyor.</translation>
    </message>
    <message>
        <source>The first condition that fails is %1.</source>
        <translation>Sağlanmayan ilk koşul: %1.</translation>
    </message>
    <message>
        <source>An id consists of small letters, digits and hyphens, such as &quot;cycle-basis&quot;.</source>
        <translation>Kimlik küçük harf, rakam ve tirelerden oluşur, örneğin &quot;cycle-basis&quot;.</translation>
    </message>
    <message>
        <source>A lesson takes 1 to 60 minutes.</source>
        <translation>Bir ders 1 ile 60 dakika sürer.</translation>
    </message>
    <message>
        <source>A lesson has 1 to %1 steps.</source>
        <translation>Bir derste 1 ile %1 arası adım olur.</translation>
    </message>
    <message>
        <source>Either an example is named or a document is given, not both.</source>
        <translation>Ya bir örnek adı ya da bir belge verilir, ikisi birden değil.</translation>
    </message>
    <message>
        <source>A step explains in at most %1 words; these are %2.</source>
        <translation>Bir adım en çok %1 sözcükle anlatır; burada %2 var.</translation>
    </message>
    <message>
        <source>The paper numbers its equations from 1 to %1.</source>
        <translation>Makale denklemlerini 1’den %1’e kadar numaralandırır.</translation>
    </message>
    <message>
        <source>Neither the step nor its lesson names an example or gives a document.</source>
        <translation>Ne adım ne de dersi bir örnek adı veya belge veriyor.</translation>
    </message>
    <message>
        <source>A step gives at least one hint.</source>
        <translation>Bir adım en az bir ipucu verir.</translation>
    </message>
    <message>
        <source>This part does not fit the fields of its task.</source>
        <translation>Bu bölüm görevinin alanlarına uymuyor.</translation>
    </message>
    <message>
        <source>What the analysis gives here is no answer to this field.</source>
        <translation>Çözümlemenin burada verdiği, bu alan için yanıt değil.</translation>
    </message>
    <message>
        <source>An answer has a text for each field: %1, not %2.</source>
        <translation>Yanıtta her alan için bir metin bulunur: %2 değil %1.</translation>
    </message>
    <message>
        <source>There is no such field.</source>
        <translation>Böyle bir alan yok.</translation>
    </message>
    <message>
        <source>The field &quot;%1&quot; cannot hold &quot;%2&quot;.</source>
        <translation>&quot;%1&quot; alanına &quot;%2&quot; yazılamaz.</translation>
    </message>
    <message>
        <source>The document gives no exercise of this kind: %1.</source>
        <translation>Belge bu türden alıştırma vermiyor: %1.</translation>
    </message>
    <message>
        <source>No exercise of this kind is about this element.</source>
        <translation>Bu türden hiçbir alıştırma bu öğeyle ilgili değil.</translation>
    </message>
    <message>
        <source>A mechanism is missing here.</source>
        <translation>Burada bir mekanizma eksik.</translation>
    </message>
    <message>
        <source>The document has no such element.</source>
        <translation>Belgede böyle bir öğe yok.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Çiz</translation>
    </message>
    <message>
        <source>Your task</source>
        <translation>Göreviniz</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>Hesapla</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Seç</translation>
    </message>
    <message>
        <source>Pick in the drawing</source>
        <translation>Çizimde seç</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Öngör</translation>
    </message>
    <message>
        <source>Find the mistake</source>
        <translation>Hatayı bul</translation>
    </message>
    <message>
        <source>The degrees of freedom are not defined yet: the document has errors.</source>
        <translation>Serbestlik derecesi henüz tanımlı değil: belgede hatalar var.</translation>
    </message>
    <message>
        <source>This quantity is not known.</source>
        <translation>Bu büyüklük bilinmiyor.</translation>
    </message>
    <message>
        <source>The document has no turning joint &quot;%1&quot;.</source>
        <translation>Belgede &quot;%1&quot; döner mafsalı yok.</translation>
    </message>
    <message>
        <source>The speeds are not determined yet: see Problems.</source>
        <translation>Hızlar henüz belirli değil: Sorunlar&apos;a bakın.</translation>
    </message>
    <message>
        <source>The solution was cancelled.</source>
        <translation>Çözüm iptal edildi.</translation>
    </message>
    <message>
        <source>The document has no state &quot;%1&quot;.</source>
        <translation>Belgede &quot;%1&quot; durumu yok.</translation>
    </message>
    <message>
        <source>The document has errors: no state has a ratio.</source>
        <translation>Belgede hatalar var: hiçbir durumun oranı yok.</translation>
    </message>
    <message>
        <source>State &quot;%1&quot; has no ratio.</source>
        <translation>&quot;%1&quot; durumunun oranı yok.</translation>
    </message>
    <message>
        <source>The document has errors: torques are not determined.</source>
        <translation>Belgede hatalar var: torklar belirli değil.</translation>
    </message>
    <message>
        <source>The loads are not held: torques are not determined.</source>
        <translation>Yükler tutulmuyor: torklar belirli değil.</translation>
    </message>
    <message>
        <source>The torque of &quot;%1&quot; is not determined as a fraction.</source>
        <translation>&quot;%1&quot; için tork kesir olarak belirli değil.</translation>
    </message>
    <message>
        <source>The document has no balance or engaged coupling &quot;%1&quot;.</source>
        <translation>Belgede &quot;%1&quot; dengesi veya devredeki elemanı yok.</translation>
    </message>
    <message>
        <source>The document has no gear mesh &quot;%1&quot;.</source>
        <translation>Belgede &quot;%1&quot; dişli çifti yok.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree: meshes close no cycles.</source>
        <translation>Döner mafsallar kapsayan ağaç oluşturmuyor: dişli çiftleri çevrim kapatmıyor.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; has no transfer vertex.</source>
        <translation>&quot;%1&quot; dişli çiftinin aktarma düğümü yok.</translation>
    </message>
    <message>
        <source>A number or a fraction such as &quot;-2/3&quot; is needed here.</source>
        <translation>Burada bir sayı ya da &quot;-2/3&quot; gibi bir kesir gerekli.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no quantity that the analysis gives.</source>
        <translation>&quot;%1&quot; çözümlemenin verdiği bir büyüklük değil.</translation>
    </message>
    <message>
        <source>The quantity &quot;%1&quot; is of the whole document.</source>
        <translation>&quot;%1&quot; büyüklüğü bütün belgeye aittir.</translation>
    </message>
    <message>
        <source>What can be picked is links, turningJoints or gearMeshes.</source>
        <translation>Seçilebilenler links, turningJoints veya gearMeshes olur.</translation>
    </message>
    <message>
        <source>What can be picked is named here.</source>
        <translation>Nelerin seçilebileceği burada belirtilir.</translation>
    </message>
    <message>
        <source>A field is an integer, a number, a choice or a set.</source>
        <translation>Alan bir tam sayı, sayı, seçim veya küme olur.</translation>
    </message>
    <message>
        <source>A choice or a set has options, a number has none.</source>
        <translation>Seçimin veya kümenin seçenekleri olur, sayının olmaz.</translation>
    </message>
    <message>
        <source>A mistake is told by answers or by conditions, not by both.</source>
        <translation>Bir hata ya yanıtlarla ya da koşullarla anlatılır, ikisiyle birden değil.</translation>
    </message>
    <message>
        <source>A reason is a sentence.</source>
        <translation>Gerekçe bir cümledir.</translation>
    </message>
    <message>
        <source>A mistake has at least one condition.</source>
        <translation>Bir hatanın en az bir koşulu olur.</translation>
    </message>
    <message>
        <source>A mistake that conditions tell needs an example of an answer.</source>
        <translation>Koşullarla anlatılan bir hata örnek bir yanıt ister.</translation>
    </message>
    <message>
        <source>A prediction names the quantity of the analysis that it is compared with.</source>
        <translation>Öngörü, karşılaştırıldığı çözümleme büyüklüğünü belirtir.</translation>
    </message>
    <message>
        <source>A choice needs two options or more.</source>
        <translation>Seçim en az iki seçenek ister.</translation>
    </message>
    <message>
        <source>A task gives its reason for at least one wrong answer.</source>
        <translation>Bir görev en az bir yanlış yanıtın gerekçesini verir.</translation>
    </message>
    <message>
        <source>What is right is told in one way: by &quot;accepted&quot;, by &quot;conditions&quot;, or by &quot;is&quot; of every field.</source>
        <translation>Neyin doğru olduğu tek yolla söylenir: &quot;accepted&quot;, &quot;conditions&quot; veya her alanın &quot;is&quot; üyesiyle.</translation>
    </message>
    <message>
        <source>Conditions need a solution that fulfils them.</source>
        <translation>Koşullar, onları sağlayan bir çözüm ister.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no kind of exercise; `geargraph-cli exercises kinds` lists them.</source>
        <translation>&quot;%1&quot; bir alıştırma türü değil; `geargraph-cli exercises kinds` onları listeler.</translation>
    </message>
    <message>
        <source>A drawing is judged by numbers.</source>
        <translation>Çizim sayılarla değerlendirilir.</translation>
    </message>
    <message>
        <source>Either one value is given or bounds, not both.</source>
        <translation>Ya bir değer ya da sınırlar verilir, ikisi birden değil.</translation>
    </message>
    <message>
        <source>A condition has &quot;equals&quot;, &quot;least&quot; or &quot;most&quot;.</source>
        <translation>Koşulda &quot;equals&quot;, &quot;least&quot; veya &quot;most&quot; bulunur.</translation>
    </message>
    <message>
        <source>A drawing has to fulfil something.</source>
        <translation>Çizim bir koşulu sağlamalıdır.</translation>
    </message>
    <message>
        <source>This is the position of a condition, counted from 0.</source>
        <translation>Bu, bir koşulun 0&apos;dan sayılan sırasıdır.</translation>
    </message>
    <message>
        <source>A task gives its reason for at least one wrong drawing.</source>
        <translation>Bir görev en az bir yanlış çizimin gerekçesini verir.</translation>
    </message>
    <message>
        <source>The member &quot;%1&quot; is not known here.</source>
        <translation>&quot;%1&quot; üyesi burada bilinmiyor.</translation>
    </message>
    <message>
        <source>The document has a fault: %1</source>
        <translation>Belgede bir hata var: %1</translation>
    </message>
    <message>
        <source>A task is one of type, choose, pick, predict, find, exercise and draw.</source>
        <translation>Görev şu türlerden biridir: type, choose, pick, predict, find, exercise, draw.</translation>
    </message>
    <message>
        <source>An equation between velocities has no number without one: write the input&apos;s velocity.</source>
        <translation>Hızlar arasındaki denklem, hız yazılmadan sayı vermez: girişin hızını yazın.</translation>
    </message>
    <message>
        <source>This equation has no velocity: write θ or ω with a label.</source>
        <translation>Bu denklemde hız yok: etiketli bir θ veya ω yazın.</translation>
    </message>
    <message>
        <source>The equation is true for these teeth and not for all: it holds another mesh&apos;s ratio.</source>
        <translation>Denklem bu dişler için doğru, bütün dişler için değil: içinde başka bir dişli çiftinin oranı var.</translation>
    </message>
    <message>
        <source>The sign of the term with %1 is wrong: with the other one the equation holds.</source>
        <translation>%1 teriminin işareti yanlış: öbürüyle denklem sağlanır.</translation>
    </message>
    <message>
        <source>The ratio %1 is upside down: it is N of the tail over N of the head.</source>
        <translation>%1 oranı ters: kuyruğun N&apos;si bölü başın N&apos;sidir.</translation>
    </message>
    <message>
        <source>The ratio %1 is upside down, and a sign is wrong besides.</source>
        <translation>%1 oranı ters, ayrıca bir işaret yanlış.</translation>
    </message>
    <message>
        <source>The number before %1 is upside down.</source>
        <translation>%1 önündeki sayı ters.</translation>
    </message>
    <message>
        <source>A term with θ%1 is left out.</source>
        <translation>θ%1 içeren bir terim eksik.</translation>
    </message>
    <message>
        <source>In place of %1 there should be θ%2.</source>
        <translation>%1 yerine θ%2 olmalı.</translation>
    </message>
    <message>
        <source>With θ%1 = 1 and the other inputs at rest the left side is greater than the right one by %2.</source>
        <translation>θ%1 = 1 ve öbür girişler dururken sol taraf sağdan %2 kadar büyük.</translation>
    </message>
    <message>
        <source>The equation is true for these teeth only.</source>
        <translation>Denklem yalnız bu dişler için doğru.</translation>
    </message>
    <message>
        <source>This mechanism has no motion to check an equation against.</source>
        <translation>Bu mekanizmanın, denklemin sınanacağı bir hareketi yok.</translation>
    </message>
    <message>
        <source>You exchange rows and columns of %1.</source>
        <translation>Şunun satır ve sütunlarını yer değiştirdiniz: %1.</translation>
    </message>
    <message>
        <source>You leave out the minus of (23): what is on the other side of the equation changes its sign.</source>
        <translation>(23)&apos;ün eksisini yazmadınız: denklemin öbür tarafındaki işaret değiştirir.</translation>
    </message>
    <message>
        <source>You write all entries without their signs: −1 where a walk runs against an arrow.</source>
        <translation>Bütün öğeleri işaretsiz yazdınız: yol bir oka ters gidiyorsa −1.</translation>
    </message>
    <message>
        <source>You exchange rows and columns of %1, and + and − besides.</source>
        <translation>Şunun satır ve sütunlarını, ayrıca + ve −&apos;yi yer değiştirdiniz: %1.</translation>
    </message>
    <message>
        <source>These are the rows of T: P multiplies each entry by the joint&apos;s coefficient.</source>
        <translation>Bunlar T&apos;nin satırları: P her öğeyi mafsalın katsayısıyla çarpar.</translation>
    </message>
    <message>
        <source>These are the signs of P alone: each is to be multiplied by the ratio of its gear.</source>
        <translation>Bunlar yalnız P&apos;nin işaretleri: her biri dişlisinin oranıyla çarpılmalı.</translation>
    </message>
    <message>
        <source>Your ratios are upside down: a joint on the axis of the tail&apos;s gear has i, one on the head&apos;s has 1.</source>
        <translation>Oranlarınız ters: kuyruk dişlisinin eksenindeki mafsal i, baş dişlisinin eksenindeki 1 alır.</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>belirsiz</translation>
    </message>
    <message>
        <source>another matrix than the one asked for</source>
        <translation>istenenden başka bir matris</translation>
    </message>
    <message>
        <source>size that the matrix does not have</source>
        <translation>matrisin sahip olmadığı boyut</translation>
    </message>
    <message>
        <source>minus of the solution left out</source>
        <translation>çözümün eksisi yazılmamış</translation>
    </message>
    <message>
        <source>row of another output</source>
        <translation>başka bir çıkışın satırı</translation>
    </message>
    <message>
        <source>ratio of another mesh with the same value</source>
        <translation>aynı değerde başka bir dişli çiftinin oranı</translation>
    </message>
    <message>
        <source>input that the output does not feel</source>
        <translation>çıkışın etkilenmediği giriş</translation>
    </message>
    <message>
        <source>entry that differs</source>
        <translation>farklı öğe</translation>
    </message>
    <message>
        <source>velocity left out of the equation</source>
        <translation>denklemde eksik hız</translation>
    </message>
    <message>
        <source>velocity of another joint or link</source>
        <translation>başka bir mafsalın veya uzvun hızı</translation>
    </message>
    <message>
        <source>equation that does not follow from the mechanism</source>
        <translation>mekanizmadan çıkmayan denklem</translation>
    </message>
    <message>
        <source>This is %1, not %2.</source>
        <translation>Bu %1; %2 değil.</translation>
    </message>
    <message>
        <source>%1 has the size %2 for this mechanism, and yours is %3.</source>
        <translation>%1 bu mekanizmada %2 boyutunda, sizinki %3.</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No matrix of this mechanism has the size %1: %2.</source>
        <translation>Bu mekanizmanın hiçbir matrisi %1 boyutunda değil: %2.</translation>
    </message>
    <message>
        <source>%1 is no label of %2, or occurs twice: its rows are %3, its columns %4.</source>
        <translation>%1, şunun etiketi değil ya da iki kez geçiyor: %2. Satırları %3, sütunları %4.</translation>
    </message>
    <message>
        <source>This mechanism has no %1.</source>
        <translation>Bu mekanizmada şu yok: %1.</translation>
    </message>
    <message>
        <source>These inputs depend on each other, so there is no solution for them.</source>
        <translation>Bu girişler birbirine bağlı, bu yüzden onlar için çözüm yok.</translation>
    </message>
    <message>
        <source>You turn the arrow of edge %1 round: it points from link %2 to link %3.</source>
        <translation>%1 kenarının okunu ters çevirdiniz: %2 uzvundan %3 uzvuna doğrudur.</translation>
    </message>
    <message>
        <source>The number is right for these teeth and the formula is not: it holds another mesh&apos;s ratio.</source>
        <translation>Sayı bu dişler için doğru, formül değil: içinde başka bir dişli çiftinin oranı var.</translation>
    </message>
    <message>
        <source>This is the row of %1, not of %2.</source>
        <translation>Bu satır %1 için; %2 için değil.</translation>
    </message>
    <message>
        <source>You exchange the gears of mesh %1: i%1 belongs to the joints on the tail&apos;s axis.</source>
        <translation>%1 dişli çiftinin dişlilerini yer değiştirdiniz: i%1, kuyruğun eksenindeki mafsallara aittir.</translation>
    </message>
    <message>
        <source>The sign of bevel mesh %1 follows from its pitch point, seen from both axes.</source>
        <translation>%1 konik dişli çiftinin işareti, iki eksenden bakıldığında hatve noktasından çıkar.</translation>
    </message>
    <message>
        <source>Mesh %1 is internal: its gears turn the same way, seen from the carrier.</source>
        <translation>%1 dişli çifti içtir: taşıyıcıdan bakıldığında dişlileri aynı yönde döner.</translation>
    </message>
    <message>
        <source>Mesh %1 is external: its gears turn opposite ways, seen from the carrier.</source>
        <translation>%1 dişli çifti dıştır: taşıyıcıdan bakıldığında dişlileri ters yönlerde döner.</translation>
    </message>
    <message>
        <source>The ratio of mesh %1 is upside down and its sign is wrong.</source>
        <translation>%1 dişli çiftinin oranı ters ve işareti yanlış.</translation>
    </message>
    <message>
        <source>This is the row of the cycle: in P its signs are multiplied by the coefficients of mesh %1.</source>
        <translation>Bu çevrimin satırı: P&apos;de işaretleri %1 dişli çiftinin katsayılarıyla çarpılır.</translation>
    </message>
    <message>
        <source>You leave out the signs of the cycle of mesh %1, which walks against some arrows.</source>
        <translation>Bazı oklara ters giden %1 dişli çiftinin çevriminin işaretlerini yazmadınız.</translation>
    </message>
    <message>
        <source>Joint %1 turns the other way: the sign of one mesh of its chain is wrong.</source>
        <translation>%1 mafsalı öbür yöne döner: zincirindeki bir dişli çiftinin işareti yanlış.</translation>
    </message>
    <message>
        <source>The row of joint %1 is upside down: it is output over input.</source>
        <translation>%1 mafsalının satırı ters: çıkış bölü giriştir.</translation>
    </message>
    <message>
        <source>In the sense that you walk it, the entry is %1.</source>
        <translation>Sizin dolaştığınız yönde öğe %1.</translation>
    </message>
    <message>
        <source>So the entry is %1.</source>
        <translation>Öyleyse öğe %1.</translation>
    </message>
    <message>
        <source>Entries of this matrix are −1, 0 or 1.</source>
        <translation>Bu matrisin öğeleri −1, 0 veya 1&apos;dir.</translation>
    </message>
    <message>
        <source>Joint %1 is not on cycle %2, so its coefficient is 0.</source>
        <translation>%1 mafsalı %2 çevriminde değil, bu yüzden katsayısı 0.</translation>
    </message>
    <message>
        <source>In the multiple of row %1 that you write, joint %2 has %3.</source>
        <translation>%1 satırının yazdığınız katında %2 mafsalının değeri %3.</translation>
    </message>
    <message>
        <source>Joint %1 does not feel input %2: 0.</source>
        <translation>%1 mafsalı %2 girişinden etkilenmez: 0.</translation>
    </message>
    <message>
        <source>With input %1 alone, joint %2 turns at %3 times its speed.</source>
        <translation>Yalnız %1 girişiyle %2 mafsalı, onun hızının %3 katıyla döner.</translation>
    </message>
    <message>
        <source>Without labels it may be either: write the labels of rows and columns.</source>
        <translation>Etiketsiz ikisi de olabilir: satır ve sütun etiketlerini yazın.</translation>
    </message>
    <message>
        <source>Your rows are in another order: %1.</source>
        <translation>Satırlarınız başka bir sırada: %1.</translation>
    </message>
    <message>
        <source>Your columns are in another order: %1.</source>
        <translation>Sütunlarınız başka bir sırada: %1.</translation>
    </message>
    <message>
        <source>You walk %1 the other way, which is as good: all signs of the row change.</source>
        <translation>Şunu öbür yönde dolaşıyorsunuz: %1. Bu da doğrudur: satırın bütün işaretleri değişir.</translation>
    </message>
    <message>
        <source>You take another spanning tree, of the edges %1: for it the matrix is right.</source>
        <translation>Başka bir kapsayan ağaç alıyorsunuz, kenarları %1: onun için matris doğru.</translation>
    </message>
    <message>
        <source>This mechanism has no ratio %1.</source>
        <translation>Bu mekanizmada %1 oranı yok.</translation>
    </message>
    <message>
        <source>Link %1 has no gear, so %2 has no value.</source>
        <translation>%1 uzvunun dişlisi yok, bu yüzden %2 değersiz.</translation>
    </message>
    <message>
        <source>Link %1 has several gears: write %2&apos; or %2&apos;&apos;, in the order of its meshes.</source>
        <translation>%1 uzvunun birkaç dişlisi var: dişli çiftlerinin sırasıyla %2&apos; veya %2&apos;&apos; yazın.</translation>
    </message>
    <message>
        <source>The diameter %1 is no fraction: use numbers of teeth.</source>
        <translation>%1 çapı kesir değil: diş sayılarını kullanın.</translation>
    </message>
    <message>
        <source>This mechanism has no turning joint %1, so no %2.</source>
        <translation>Bu mekanizmada %1 döner mafsalı yok, bu yüzden %2 de yok.</translation>
    </message>
    <message>
        <source>%1 names no links of this mechanism: write ω with two labels, as ω5_1.</source>
        <translation>%1 bu mekanizmanın uzuvlarını göstermiyor: ω&apos;yı iki etiketle yazın, örneğin ω5_1.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree, so no velocity follows from them.</source>
        <translation>Döner mafsallar kapsayan ağaç oluşturmuyor, bu yüzden onlardan hız çıkmaz.</translation>
    </message>
    <message>
        <source>The velocity of link %1 relative to link %2 has several directions: write one equation for each level.</source>
        <translation>%1 uzvunun %2 uzvuna göre hızının birkaç doğrultusu var: her düzey için bir denklem yazın.</translation>
    </message>
    <message>
        <source>An entry is missing here.</source>
        <translation>Burada bir öğe eksik.</translation>
    </message>
    <message>
        <source>This formula is too long.</source>
        <translation>Bu formül çok uzun.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: write a number, a fraction or names such as i15, n41, N4, θ8 or ω51.</source>
        <translation>“%1” okunamıyor: bir sayı, kesir ya da i15, n41, N4, θ8, ω51 gibi adlar yazın.</translation>
    </message>
    <message>
        <source>A velocity is multiplied by a velocity here.</source>
        <translation>Burada bir hız başka bir hızla çarpılıyor.</translation>
    </message>
    <message>
        <source>Something is divided by a velocity here.</source>
        <translation>Burada bir şey bir hıza bölünüyor.</translation>
    </message>
    <message>
        <source>Something is divided by 0 here.</source>
        <translation>Burada bir şey 0&apos;a bölünüyor.</translation>
    </message>
    <message>
        <source>This formula has too many parentheses inside each other.</source>
        <translation>Bu formülde çok fazla iç içe ayraç var.</translation>
    </message>
    <message>
        <source>A power needs a whole number of at most %1.</source>
        <translation>Üs, en çok %1 olan bir tam sayı olmalıdır.</translation>
    </message>
    <message>
        <source>“%1” can be read as a thousand or as a decimal: write it without the comma.</source>
        <translation>“%1” binlik ya da ondalık okunabilir: virgülsüz yazın.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1” bir sayı değil.</translation>
    </message>
    <message>
        <source>“%1” holds a velocity, and an entry of a matrix is a number.</source>
        <translation>“%1” içinde hız var; matrisin öğesi ise sayıdır.</translation>
    </message>
    <message>
        <source>The text has more than %1 bytes.</source>
        <translation>Metin %1 bayttan uzun.</translation>
    </message>
    <message>
        <source>There is no matrix and no equation.</source>
        <translation>Ne matris ne de denklem var.</translation>
    </message>
    <message>
        <source>This \begin has no name in braces.</source>
        <translation>Bu \begin için süslü ayraçta ad yok.</translation>
    </message>
    <message>
        <source>\begin{%1} has no \end{%1}.</source>
        <translation>\begin{%1} için \end{%1} yok.</translation>
    </message>
    <message>
        <source>This bracket is not closed.</source>
        <translation>Bu ayraç kapatılmamış.</translation>
    </message>
    <message>
        <source>The matrix has more than %1 entries.</source>
        <translation>Matrisin %1 öğeden fazlası var.</translation>
    </message>
    <message>
        <source>The matrix has no rows.</source>
        <translation>Matrisin satırı yok.</translation>
    </message>
    <message>
        <source>Row %1 has 1 entry, the first has %2.</source>
        <translation>%1. satırda 1 öğe, ilkinde %2 öğe var.</translation>
    </message>
    <message>
        <source>Row %1 has %2 entries, the first has %3.</source>
        <translation>%1. satırda %2 öğe, ilkinde %3 öğe var.</translation>
    </message>
    <message>
        <source>This row has a label and no entry.</source>
        <translation>Bu satırın etiketi var, öğesi yok.</translation>
    </message>
    <message>
        <source>There are %1 labels for %2 columns.</source>
        <translation>%2 sütun için %1 etiket var.</translation>
    </message>
    <message>
        <source>There are %1 labels for %2 rows.</source>
        <translation>%2 satır için %1 etiket var.</translation>
    </message>
    <message>
        <source>There is no equation.</source>
        <translation>Denklem yok.</translation>
    </message>
    <message>
        <source>This line has no equals sign.</source>
        <translation>Bu satırda eşittir işareti yok.</translation>
    </message>
    <message>
        <source>A side of this equation is empty.</source>
        <translation>Bu denklemin bir tarafı boş.</translation>
    </message>
    <message>
        <source>The symbolic solution has %1 entries; it was left out.</source>
        <translation>Simgesel çözümün %1 öğesi var; çıkarılmadı.</translation>
    </message>
    <message>
        <source>The equations of this mechanism are so coupled that the symbolic solution would fill pages; it was left out.</source>
        <translation>Bu mekanizmanın denklemleri o kadar bağlaşık ki simgesel çözüm sayfalar tutardı; çıkarılmadı.</translation>
    </message>
    <message>
        <source>%1 entries of the symbolic solution are left as a chain of substitutions: expanded, one has over %2 terms, or all together over %3 factors.</source>
        <translation>Simgesel çözümün %1 öğesi yerine koyma zinciri olarak kaldı: açıldığında biri %2 terimi, ya da hepsi birlikte %3 çarpanı aşıyor.</translation>
    </message>
    <message>
        <source>Masses need lengths in metres, and &quot;%1&quot; is no unit of length that is known: use mm, cm, m or in.</source>
        <translation>Kütleler metre cinsinden uzunluk ister, &quot;%1&quot; ise bilinen bir uzunluk birimi değil: mm, cm, m veya in kullanın.</translation>
    </message>
    <message>
        <source>It ends where joint %1 reaches the end of its range.</source>
        <translation>%1 mafsalı aralığının sonuna vardığında biter.</translation>
    </message>
    <message>
        <source>A motion of the inputs moves no mass: torques determine no acceleration.</source>
        <translation>Girişlerin bir hareketi hiçbir kütleyi hareket ettirmiyor: torklar ivme belirlemez.</translation>
    </message>
    <message>
        <source>It ends where speeds grow beyond what can be followed.</source>
        <translation>Hızlar izlenebilecek sınırı aştığında biter.</translation>
    </message>
    <message>
        <source>The ratio of an input to joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, give a ratio that it can.</source>
        <translation>Bir girişin %1 mafsalına oranı, çözümlemenin tutabildiği en büyük sayıyı, 1.79e308&apos;i aşıyor. Birbirine yakın diş sayıları ya da art arda daha az dişli çifti tutabileceği bir oran verir.</translation>
    </message>
    <message>
        <source>The speed of joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Lower the speeds of the inputs.</source>
        <translation>%1 mafsalının hızı, çözümlemenin tutabildiği en büyük sayıyı, 1.79e308&apos;i aşıyor. Girişlerin hızlarını düşürün.</translation>
    </message>
    <message>
        <source>The speed of the link that turns about joint %1 is beyond the largest number that the analysis can hold, 1.79e308. Lower the speeds of the inputs.</source>
        <translation>%1 mafsalında dönen uzvun hızı, çözümlemenin tutabildiği en büyük sayıyı, 1.79e308&apos;i aşıyor. Girişlerin hızlarını düşürün.</translation>
    </message>
    <message>
        <source>In state %1: %2</source>
        <translation>%1 durumunda: %2</translation>
    </message>
    <message>
        <source>In states %1: %2</source>
        <translation>%1 durumlarında: %2</translation>
    </message>
    <message>
        <source>No load is given: all torques are 0.</source>
        <translation>Yük verilmedi: bütün torklar 0.</translation>
    </message>
    <message>
        <source>The drive of state %1, link %2, gets 1 N m, as no load acts on it or on the driven link.</source>
        <translation>%1 durumunun tahrik eden uzvu %2, ne ona ne de tahrik edilen uzva yük etkidiği için 1 N m alır.</translation>
    </message>
    <message>
        <source>The unit of length, &quot;%1&quot;, has no known size: forces of teeth and bearings are left out, and so are loads that are forces. Units are nm, um, mm, cm, dm, m, mil, in and ft.</source>
        <translation>&quot;%1&quot; uzunluk biriminin büyüklüğü bilinmiyor: diş ve yatak kuvvetleri ile kuvvet olan yükler dışarıda bırakılır. Birimler nm, um, mm, cm, dm, m, mil, in ve ft.</translation>
    </message>
    <message>
        <source>The unit of length, &quot;%1&quot;, has no known size: forces of teeth and bearings are left out. Units are nm, um, mm, cm, dm, m, mil, in and ft.</source>
        <translation>&quot;%1&quot; uzunluk biriminin büyüklüğü bilinmiyor: diş ve yatak kuvvetleri dışarıda bırakılır. Birimler nm, um, mm, cm, dm, m, mil, in ve ft.</translation>
    </message>
    <message>
        <source>Speeds are not determined: powers and efficiencies are left out. Give inputs their speeds, or choose a state of one degree of freedom.</source>
        <translation>Hızlar belirli değil: güçler ve verimler dışarıda bırakılır. Girişlere hızlarını verin ya da bir serbestlik dereceli bir durum seçin.</translation>
    </message>
    <message>
        <source>No mesh has an efficiency: give `efficiency` or `friction` in the document, or --eta.</source>
        <translation>Hiçbir dişli çiftinin verimi yok: belgede `efficiency` veya `friction`, ya da --eta verin.</translation>
    </message>
    <message>
        <source>Nothing holds this motion: joint %1 turns freely under the load on %2. Add a balance at joint %3.</source>
        <translation>Bu hareketi tutan bir şey yok: %1 mafsalı şuradaki yük altında serbestçe döner: %2. %3 mafsalına bir denge ekleyin.</translation>
    </message>
    <message>
        <source>Nothing holds this motion: joints %1 turn freely under the load on %2. Add a balance at joint %3.</source>
        <translation>Bu hareketi tutan bir şey yok: %1 mafsalları şuradaki yük altında serbestçe döner: %2. %3 mafsalına bir denge ekleyin.</translation>
    </message>
    <message>
        <source>coupling %1</source>
        <translation>%1 elemanı</translation>
    </message>
    <message>
        <source>couplings %1</source>
        <translation>%1 elemanları</translation>
    </message>
    <message>
        <source>balances</source>
        <translation>dengeler</translation>
    </message>
    <message>
        <source>%1 share the load in proportions that stiffness and clearance decide (1 self-stress).</source>
        <translation>%1 yükü, rijitlik ve boşluğun belirlediği oranlarda paylaşır (1 öz gerilme durumu).</translation>
    </message>
    <message>
        <source>%1 share the load in proportions that stiffness and clearance decide (%2 self-stresses).</source>
        <translation>%1 yükü, rijitlik ve boşluğun belirlediği oranlarda paylaşır (%2 öz gerilme durumu).</translation>
    </message>
    <message>
        <source>Torques outside are determined.</source>
        <translation>Dışarıdaki torklar belirlidir.</translation>
    </message>
    <message>
        <source>Torques that do not depend on them are determined.</source>
        <translation>Onlara bağlı olmayan torklar belirlidir.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load needs no balance.</source>
        <translation>%1 mafsalı dönemez: yükü denge istemez.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load is carried by mesh %2.</source>
        <translation>%1 mafsalı dönemez: yükünü %2 dişli çifti taşır.</translation>
    </message>
    <message>
        <source>Joint %1 cannot turn: its load is carried by meshes %2.</source>
        <translation>%1 mafsalı dönemez: yükünü %2 dişli çiftleri taşır.</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction.</source>
        <translation>Şuradaki hiçbir tork bu yükü hareket ettirmez: %1. Dişli takımı bu yönde kendini kilitler.</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction (it begins below eta = %2).</source>
        <translation>Şuradaki hiçbir tork bu yükü hareket ettirmez: %1. Dişli takımı bu yönde kendini kilitler (eta = %2 altında başlar).</translation>
    </message>
    <message>
        <source>No torque at %1 moves this load: the train is self-locking in this direction (it begins at %2 % of these losses).</source>
        <translation>Şuradaki hiçbir tork bu yükü hareket ettirmez: %1. Dişli takımı bu yönde kendini kilitler (bu kayıpların % %2 kadarında başlar).</translation>
    </message>
    <message>
        <source>Mesh %1 passes %2 times the power fed, seen from its carrier.</source>
        <translation>%1 dişli çifti, taşıyıcısından bakıldığında verilen gücün %2 katını iletir.</translation>
    </message>
    <message>
        <source>Meshes %1 pass up to %2 times the power fed, seen from their carriers.</source>
        <translation>%1 dişli çiftleri, taşıyıcılarından bakıldığında verilen gücün %2 katına kadarını iletir.</translation>
    </message>
    <message>
        <source>%1 W of each W fed circulate through %2 and %3.</source>
        <translation>Verilen her W başına %1 W dolaşır: %2 ve %3 üzerinden.</translation>
    </message>
    <message>
        <source>links %1</source>
        <translation>%1 uzuvları</translation>
    </message>
    <message>
        <source>Turning joints %1 name one axis (%2) but do not all hang together on it by common links: they coincide only in the drawn pose and are treated as different axes (%3). Give each axis of the mechanism its own entry in axes.</source>
        <translation>%1 döner mafsalları tek bir ekseni (%2) anıyor, ama üzerinde hepsi ortak uzuvlarla bağlı değil: yalnız çizilen konumda çakışırlar ve ayrı eksenler sayılırlar (%3). Mekanizmanın her eksenine axes içinde kendi kaydını verin.</translation>
    </message>
    <message>
        <source>Axes %1 are one line held by common links: they are treated as one axis (%2).</source>
        <translation>%1 eksenleri ortak uzuvların tuttuğu tek bir doğrudur: tek eksen sayılırlar (%2).</translation>
    </message>
    <message>
        <source>The opposite direction of %1 is minded.</source>
        <translation>%1 ekseninin ters yönü hesaba katılır.</translation>
    </message>
    <message>
        <source>note</source>
        <translation>not</translation>
    </message>
    <message>
        <source>New note here</source>
        <translation>Burada yeni not</translation>
    </message>
    <message>
        <source>Change the text</source>
        <translation>Metni değiştir</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Not ekle</translation>
    </message>
    <message>
        <source>Delete note</source>
        <translation>Notu sil</translation>
    </message>
    <message>
        <source>Change note</source>
        <translation>Notu değiştir</translation>
    </message>
    <message>
        <source>Text of the note</source>
        <translation>Notun metni</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Metin</translation>
    </message>
    <message>
        <source>Return takes the text, Shift+Return begins a new line, Esc leaves it as it was</source>
        <translation>Enter metni alır, Shift+Enter yeni satıra geçer, Esc eski hâliyle bırakır</translation>
    </message>
    <message>
        <source>A note has at most 1,000 characters.</source>
        <translation>Bir not en çok 1.000 karakter olabilir.</translation>
    </message>
    <message>
        <source>Move note</source>
        <translation>Notu taşı</translation>
    </message>
    <message>
        <source>Notes are written on the sheet of the digraph</source>
        <translation>Notlar yönlü grafın sayfasına yazılır</translation>
    </message>
    <message>
        <source>Never self-locking, however large the losses</source>
        <translation>Kayıplar ne kadar büyük olursa olsun kendini kilitlemez</translation>
    </message>
    <message>
        <source>Moves up to %1 % of these losses; beyond, not decided</source>
        <translation>Bu kayıpların % %1 değerine kadar hareket eder; ötesi belirsiz</translation>
    </message>
    <message>
        <source>Moves backward up to %1 % of these losses; beyond, not decided</source>
        <translation>Bu kayıpların % %1 değerine kadar geri hareket eder; ötesi belirsiz</translation>
    </message>
    <message>
        <source>Moves down to η = %1; below, not decided</source>
        <translation>η = %1 değerine kadar hareket eder; altı belirsiz</translation>
    </message>
    <message>
        <source>Moves backward down to η = %1; below, not decided</source>
        <translation>η = %1 değerine kadar geri hareket eder; altı belirsiz</translation>
    </message>
    <message>
        <source>Self-locking from %1 % of these losses on</source>
        <translation>Bu kayıpların % %1 değerinden sonra kendini kilitler</translation>
    </message>
    <message>
        <source>Self-locking backward from %1 % of these losses on</source>
        <translation>Bu kayıpların % %1 değerinden sonra geri yönde kendini kilitler</translation>
    </message>
    <message>
        <source>Where a train locks itself, no torque of what holds the loads moves them, however large.</source>
        <translation>Bir düzenek kendini kilitlediğinde, yükleri tutanın momenti ne kadar büyük olursa olsun onları hareket ettirmez.</translation>
    </message>
    <message>
        <source>The meshes state different efficiencies: all their losses, 1 − η, are multiplied by one factor.</source>
        <translation>Dişli çiftleri farklı verimler belirtiyor: tüm kayıpları, 1 − η, tek bir katsayıyla çarpılır.</translation>
    </message>
    <message>
        <source>The efficiency counts as the same in all meshes.</source>
        <translation>Verim tüm dişli çiftlerinde aynı sayılır.</translation>
    </message>
    <message>
        <source>At %1 % it moves, at %2 % no choice of driving gears solves it.</source>
        <translation>% %1 değerinde hareket eder, % %2 değerinde hiçbir tahrik dişlisi seçimi çözüm vermez.</translation>
    </message>
    <message>
        <source>At η = %1 it moves, at %2 no choice of driving gears solves it.</source>
        <translation>η = %1 değerinde hareket eder, %2 değerinde hiçbir tahrik dişlisi seçimi çözüm vermez.</translation>
    </message>
    <message>
        <source>Of that many meshes not all choices were tried.</source>
        <translation>Bu kadar çok dişli çiftinde tüm seçimler denenmedi.</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 not</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 not</translation>
    </message>
    <message>
        <source>Select links or notes to copy; the ground stays where it is.</source>
        <translation>Kopyalanacak uzuvları ya da notları seçin; sabit uzuv yerinde kalır.</translation>
    </message>
    <message>
        <source>Rename a link, change a note</source>
        <translation>Uzvu yeniden adlandır, notu değiştir</translation>
    </message>
    <message>
        <source>Write a note on the sheet of the digraph: click where it should be; a double click changes one</source>
        <translation>Yönlü grafın sayfasına not yazın: olacağı yere tıklayın; çift tıklama bir notu değiştirir</translation>
    </message>
    <message>
        <source>Select one link to rename it, or one note to change it.</source>
        <translation>Yeniden adlandırmak için bir uzuv, değiştirmek için bir not seçin.</translation>
    </message>
    <message>
        <source>Move its axis</source>
        <translation>Eksenini taşı</translation>
    </message>
    <message>
        <source>Move its axis (%1)</source>
        <translation>Eksenini taşı (%1)</translation>
    </message>
    <message>
        <source>A mesh has no carrier in the T–T graph, or its kind is not known.</source>
        <translation>Bir dişli çiftinin T–T grafında taşıyıcısı yok ya da türü bilinmiyor.</translation>
    </message>
    <message>
        <source>Select one note to change its text.</source>
        <translation>Metnini değiştirmek için tek bir not seçin.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Not</translation>
    </message>
    <message>
        <source>The text on the sheet of the digraph</source>
        <translation>Yönlü grafın sayfasındaki metin</translation>
    </message>
    <message>
        <source>z = %1. Esc puts back</source>
        <translation>z = %1. Esc geri koyar</translation>
    </message>
    <message>
        <source>z = %1</source>
        <translation>z = %1</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Not: %1</translation>
    </message>
    <message>
        <source>Click to select, drag an axis to move it or the rim of a gear for its teeth. The program lays the drawing out</source>
        <translation>Seçmek için tıklayın; taşımak için ekseni, diş sayısı için dişlinin kenarını sürükleyin. Çizimi program yerleştirir</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Ölç</translation>
    </message>
    <message>
        <source>Measure: click an axis, a pitch point or a gear</source>
        <translation>Ölçme: bir eksene, bir hatve noktasına veya bir dişliye tıklayın</translation>
    </message>
    <message>
        <source>Measure distances, angles and diameters: click an axis, a pitch point or a gear, then another one, in a drawing or in 3D</source>
        <translation>Uzaklıkları, açıları ve çapları ölçer: bir eksene, hatve noktasına veya dişliye, sonra bir başkasına tıklayın; çizimde veya 3B&apos;de</translation>
    </message>
    <message>
        <source>This has no place to measure from. Click an axis, a mesh or a gear</source>
        <translation>Burada ölçülecek bir yer yok. Bir eksene, bir dişli çiftine veya bir dişliye tıklayın</translation>
    </message>
    <message>
        <source>%1. Click a second one. Esc takes it back</source>
        <translation>%1. İkincisine tıklayın. Esc geri alır</translation>
    </message>
    <message>
        <source>%1. Ctrl+C copies the result, Esc goes back</source>
        <translation>%1. Ctrl+C sonucu kopyalar, Esc geri döner</translation>
    </message>
    <message>
        <source>Measure: %1</source>
        <translation>Ölçme: %1</translation>
    </message>
    <message>
        <source>pitch point of mesh %1</source>
        <translation>%1 dişli çiftinin hatve noktası</translation>
    </message>
    <message>
        <source>centre of gear %1 in mesh %2</source>
        <translation>%2 dişli çiftindeki %1 dişlisinin merkezi</translation>
    </message>
    <message>
        <source>face of gear %1 in mesh %2</source>
        <translation>%2 dişli çiftindeki %1 dişlisinin alnı</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>uzaklık</translation>
    </message>
    <message>
        <source>centre distance</source>
        <translation>eksenler arası uzaklık</translation>
    </message>
    <message>
        <source>pitch radius</source>
        <translation>hatve dairesi yarıçapı</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>açı</translation>
    </message>
    <message>
        <source>along the axes</source>
        <translation>eksenler boyunca</translation>
    </message>
    <message>
        <source>pitch diameter</source>
        <translation>hatve dairesi çapı</translation>
    </message>
    <message>
        <source>pitch diameter of gear %1</source>
        <translation>%1 dişlisinin hatve dairesi çapı</translation>
    </message>
    <message>
        <source>tip diameter</source>
        <translation>baş dairesi çapı</translation>
    </message>
    <message>
        <source>root diameter</source>
        <translation>taban dairesi çapı</translation>
    </message>
    <message>
        <source>face width</source>
        <translation>diş genişliği</translation>
    </message>
    <message>
        <source>--captions are written in the digraph, the T–T graph and the schematic.</source>
        <translation>--captions; yönlü grafta, T–T grafında ve şemada yazılır.</translation>
    </message>
    <message>
        <source>names of links and tooth counts in a digraph, T–T graph or schematic, where there is room</source>
        <translation>yer olan yerlerde yönlü grafta, T–T grafında veya şemada uzuv adları ve diş sayıları</translation>
    </message>
    <message>
        <source>Names and teeth</source>
        <translation>Adlar ve dişler</translation>
    </message>
    <message>
        <source>Given speeds</source>
        <translation>Verilen hızlar</translation>
    </message>
    <message>
        <source>Given torques</source>
        <translation>Verilen torklar</translation>
    </message>
    <message>
        <source>No motors</source>
        <translation>Motor yok</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Önden</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Sağdan</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Yukarıdan</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>İzometrik</translation>
    </message>
    <message>
        <source>Lines in sight</source>
        <translation>Görünen çizgiler</translation>
    </message>
    <message>
        <source>Plane of points</source>
        <translation>Nokta düzlemi</translation>
    </message>
    <message>
        <source>Layout for projectors</source>
        <translation>Projektör yerleşimi</translation>
    </message>
    <message>
        <source>Drawing and 3D alone, the drawing on three fifths of the width, in large type; Reset the layout brings the panels back</source>
        <translation>Yalnız çizim ve 3B, çizim genişliğin beşte üçünde, büyük yazıyla; yerleşimi sıfırlamak panelleri geri getirir</translation>
    </message>
    <message>
        <source>Lessons as &amp;web pages…</source>
        <translation>&amp;Web sayfası olarak dersler…</translation>
    </message>
    <message>
        <source>Writes all lessons into a folder, with the same grader: pages for any browser, phones too, and packages for learning platforms</source>
        <translation>Tüm dersleri aynı değerlendirmeyle bir klasöre yazar: telefonlar dahil her tarayıcı için sayfalar ve öğrenme platformları için paketler</translation>
    </message>
    <message>
        <source>Folder in which the lessons&apos; folder is made</source>
        <translation>Derslerin klasörünün oluşturulacağı klasör</translation>
    </message>
    <message>
        <source>GearGraph lessons</source>
        <translation>GearGraph dersleri</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already: no lesson was written.</source>
        <translation>&quot;%1&quot; zaten var: hiçbir ders yazılmadı.</translation>
    </message>
    <message>
        <source>Range of two motors</source>
        <translation>İki motorun bölgesi</translation>
    </message>
    <message>
        <source>Parallel lines, as both links turn alike: %1.</source>
        <translation>İki uzuv aynı döndüğü için çizgiler paralel: %1.</translation>
    </message>
    <message>
        <source>Note: click on an empty area, or on a note to change it</source>
        <translation>Not: boş alana tıklayın, ya da değiştirmek için bir nota</translation>
    </message>
    <message>
        <source>Handle of %1</source>
        <translation>Tutamaç: %1</translation>
    </message>
    <message>
        <source>Drag to move %1, or use the arrow keys (with Shift: finer). Alt places freely, Esc puts back</source>
        <translation>%1 sürüklenerek ya da ok tuşlarıyla taşınır (Shift ile: daha ince). Alt serbest yerleştirir, Esc geri koyar</translation>
    </message>
    <message>
        <source>the axis of joint %1</source>
        <translation>%1 mafsalının ekseni</translation>
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
        <translation>Yük olmadan güç yok: Kuvvetler&apos;de bir yük ekleyin.</translation>
    </message>
    <message>
        <source>No power: the loads are not in balance. Forces names what is missing.</source>
        <translation>Güç yok: yükler dengede değil. Eksik olan Kuvvetler&apos;de yazar.</translation>
    </message>
    <message>
        <source>No power without a motion.</source>
        <translation>Hareket olmadan güç yok.</translation>
    </message>
    <message>
        <source>--show names labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, instant-axes, velocities, forces, power, with commas.</source>
        <translation>--show virgüllerle labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, instant-axes, velocities, forces, power adlandırır.</translation>
    </message>
    <message>
        <source>2→3: from link 2 to link 3; in the colour of the link that delivers</source>
        <translation>2→3: 2 numaralı uzuvdan 3 numaralı uzva; gücü veren uzvun renginde</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Sayfa yapısı</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Dikey</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Yatay</translation>
    </message>
    <message>
        <source>Paper:</source>
        <translation>Kâğıt:</translation>
    </message>
    <message>
        <source>Orientation:</source>
        <translation>Yönlendirme:</translation>
    </message>
    <message>
        <source>It could not be read.</source>
        <translation>Okunamadı.</translation>
    </message>
    <message>
        <source>It has more than %1 bytes.</source>
        <translation>%1 bayttan fazla.</translation>
    </message>
    <message>
        <source>This system cannot confine the program that reads 3D files (%1).</source>
        <translation>Bu sistem 3B dosyaları okuyan programı yalıtamıyor (%1).</translation>
    </message>
    <message>
        <source>Reading it takes more than %1 MiB of memory.</source>
        <translation>Okumak %1 MiB&apos;den fazla bellek gerektiriyor.</translation>
    </message>
    <message>
        <source>It is damaged: %1</source>
        <translation>Bozuk: %1</translation>
    </message>
    <message>
        <source>case</source>
        <translation>kafes</translation>
    </message>
    <message>
        <source>left wheel</source>
        <translation>sol dişli</translation>
    </message>
    <message>
        <source>right wheel</source>
        <translation>sağ dişli</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>pinyon</translation>
    </message>
    <message>
        <source>pinion %1</source>
        <translation>pinyon %1</translation>
    </message>
    <message>
        <source>housing</source>
        <translation>gövde</translation>
    </message>
    <message>
        <source>bend shaft</source>
        <translation>bükme mili</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>bükme uzvu</translation>
    </message>
    <message>
        <source>roll shaft</source>
        <translation>yuvarlanma mili</translation>
    </message>
    <message>
        <source>idler</source>
        <translation>ara dişli</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>takım</translation>
    </message>
    <message>
        <source>planet %1</source>
        <translation>gezegen %1</translation>
    </message>
    <message>
        <source>countershaft</source>
        <translation>ara mil</translation>
    </message>
    <message>
        <source>output</source>
        <translation>çıkış</translation>
    </message>
    <message>
        <source>small sun</source>
        <translation>küçük güneş</translation>
    </message>
    <message>
        <source>large sun</source>
        <translation>büyük güneş</translation>
    </message>
    <message>
        <source>short planet %1</source>
        <translation>kısa gezegen %1</translation>
    </message>
    <message>
        <source>long planet %1</source>
        <translation>uzun gezegen %1</translation>
    </message>
    <message>
        <source>suns</source>
        <translation>güneşler</translation>
    </message>
    <message>
        <source>first ring</source>
        <translation>birinci çember</translation>
    </message>
    <message>
        <source>second carrier</source>
        <translation>ikinci taşıyıcı</translation>
    </message>
    <message>
        <source>first planet %1</source>
        <translation>birinci gezegen %1</translation>
    </message>
    <message>
        <source>second planet %1</source>
        <translation>ikinci gezegen %1</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>yeterli bellek yok</translation>
    </message>
    <message>
        <source>%1 mesh</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>%1 meshes</source>
        <translation>%1 dişli çifti</translation>
    </message>
    <message>
        <source>%1 degree of freedom</source>
        <translation>%1 serbestlik derecesi</translation>
    </message>
    <message>
        <source>%1 degrees of freedom</source>
        <translation>%1 serbestlik derecesi</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Bölümler</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Çizimler</translation>
    </message>
    <message>
        <source>Tells the learning platform which parts were seen, and points; loads nothing and sends nothing else.</source>
        <translation>Öğrenme platformuna hangi bölümlerin görüldüğünü ve puanları bildirir; hiçbir şey yüklemez ve başka hiçbir şey göndermez.</translation>
    </message>
    <message>
        <source>Works offline: this file loads nothing and sends nothing.</source>
        <translation>Çevrimdışı çalışır: bu dosya hiçbir şey yüklemez ve göndermez.</translation>
    </message>
    <message>
        <source>Made by GearGraph.</source>
        <translation>GearGraph ile yapıldı.</translation>
    </message>
    <message>
        <source>To the drawings</source>
        <translation>Çizimlere git</translation>
    </message>
    <message>
        <source>The train and its solution</source>
        <translation>Dişli takımı ve çözümü</translation>
    </message>
    <message>
        <source>The wheels are coarse: finer ones would make the file too large.</source>
        <translation>Dişliler kaba: daha incesi dosyayı çok büyütürdü.</translation>
    </message>
    <message>
        <source>From %1 to %2.</source>
        <translation>%1 → %2.</translation>
    </message>
    <message>
        <source>Along joint %1, from %2 to %3: %4.</source>
        <translation>%1 mafsalı boyunca (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Against joint %1, from %2 to %3: %4.</source>
        <translation>%1 mafsalına ters (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Along mesh %1, from %2 to %3: %4.</source>
        <translation>%1 dişli çifti boyunca (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Against mesh %1, from %2 to %3: %4.</source>
        <translation>%1 dişli çiftine ters (%2 → %3): %4.</translation>
    </message>
    <message>
        <source>Turning joints: %1.</source>
        <translation>Döner mafsallar: %1.</translation>
    </message>
    <message>
        <source>Gear meshes: %1.</source>
        <translation>Dişli çiftleri: %1.</translation>
    </message>
    <message>
        <source>Its cycle runs along %1 and against %2.</source>
        <translation>Çevrimi %1 boyunca, şunlara ters gider: %2.</translation>
    </message>
    <message>
        <source>Its cycle runs along %1.</source>
        <translation>Çevrimi %1 boyunca gider.</translation>
    </message>
    <message>
        <source>Its cycle runs against %1.</source>
        <translation>Çevrimi şunlara ters gider: %1.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2 on %3, %4, %5 : %6 teeth.</source>
        <translation>Dişliler: %1 ve %2; taşıyıcı: %3; %4, %5 : %6 diş.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2 on %3, %4 : %5 teeth.</source>
        <translation>Dişliler: %1 ve %2; taşıyıcı: %3; %4 : %5 diş.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2, %3, %4 : %5 teeth.</source>
        <translation>Dişliler: %1 ve %2; %3, %4 : %5 diş.</translation>
    </message>
    <message>
        <source>Gears of %1 and %2, %3 : %4 teeth.</source>
        <translation>Dişliler: %1 ve %2; %3 : %4 diş.</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>İpucu</translation>
    </message>
    <message>
        <source>Answer to question %1</source>
        <translation>%1. sorunun yanıtı</translation>
    </message>
    <message>
        <source>The answers are hidden in this file, not secret, and other parts of it help: try first.</source>
        <translation>Yanıtlar bu dosyada gizlidir ama sır değildir, dosyanın öteki bölümleri de yardım eder: önce kendiniz deneyin.</translation>
    </message>
    <message>
        <source>Rows of P times the rates (17)</source>
        <translation>P satırları çarpı hızlar (17)</translation>
    </message>
    <message>
        <source>Coefficient matrix P (18), (19), in %1</source>
        <translation>Katsayı matrisi P (18), (19), %1 cinsinden</translation>
    </message>
    <message>
        <source>Digraph. Solid arrows: turning joints; dashed: gear meshes.</source>
        <translation>Yönlü graf. Düz oklar: döner mafsallar; kesikli oklar: dişli çiftleri.</translation>
    </message>
    <message>
        <source>Schematic.</source>
        <translation>Şema.</translation>
    </message>
    <message>
        <source>T-T graph.</source>
        <translation>T-T grafı.</translation>
    </message>
    <message>
        <source>The train</source>
        <translation>Dişli takımı</translation>
    </message>
    <message>
        <source>The train in three dimensions</source>
        <translation>Dişli takımı üç boyutta</translation>
    </message>
    <message>
        <source>The train turns where scripts may run: open the file in a browser.</source>
        <translation>Dişli takımı betiklerin çalışabildiği yerde döner: dosyayı bir tarayıcıda açın.</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Durumlar</translation>
    </message>
    <message>
        <source>The mechanism has no solution: its derivation says why.</source>
        <translation>Mekanizmanın çözümü yok: nedeni türetimde.</translation>
    </message>
    <message>
        <source>joint %1 at %2 rad/s</source>
        <translation>%1 mafsalı: %2 rad/s</translation>
    </message>
    <message>
        <source>Inputs: %1.</source>
        <translation>Girişler: %1.</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>%1 katı</translation>
    </message>
    <message>
        <source>now, rad/s</source>
        <translation>şimdi, rad/s</translation>
    </message>
    <message>
        <source>Speeds of the joints</source>
        <translation>Mafsalların hızları</translation>
    </message>
    <message>
        <source>Arrow keys walk its elements.</source>
        <translation>Ok tuşları öğelerini gezer.</translation>
    </message>
    <message>
        <source>Speed of joint %1</source>
        <translation>%1 mafsalının hızı</translation>
    </message>
    <message>
        <source>Speed of joint %1, exact, rad/s</source>
        <translation>%1 mafsalının hızı, tam, rad/s</translation>
    </message>
    <message>
        <source>A number such as 2, -3/4 or 0.75.</source>
        <translation>2, -3/4 ya da 0,75 gibi bir sayı.</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>Açık ya da koyu</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Çizim</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Bitir</translation>
    </message>
    <message>
        <source>Walk round the cycle: left and right arrow keys step, Escape ends</source>
        <translation>Çevrimde tur: sol ve sağ ok tuşları adım atar, Escape bitirir</translation>
    </message>
    <message>
        <source>%1 of %2. %3</source>
        <translation>%1 / %2. %3</translation>
    </message>
    <message>
        <source>The walk is closed: row C%1 has no other entries.</source>
        <translation>Tur kapandı: C%1 satırının başka öğesi yok.</translation>
    </message>
    <message>
        <source>Walk the cycle</source>
        <translation>Çevrimi dolaş</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Seçim</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Seçimi kaldır</translation>
    </message>
    <message>
        <source>Now %1 rad/s.</source>
        <translation>Şimdi %1 rad/s.</translation>
    </message>
    <message>
        <source>The train in three dimensions. Arrow keys turn it, plus and minus zoom, Space plays, comma and full stop step.</source>
        <translation>Dişli takımı üç boyutta. Ok tuşları döndürür, artı ve eksi yakınlaştırıp uzaklaştırır, Boşluk oynatır, virgül ve nokta adım atar.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zaman</translation>
    </message>
    <message>
        <source>%1 s of %2 s</source>
        <translation>%1 s / %2 s</translation>
    </message>
    <message>
        <source>To the reference pose</source>
        <translation>Referans konuma</translation>
    </message>
    <message>
        <source>%1 is at its limit of %2°.</source>
        <translation>%1 sınırında: %2°.</translation>
    </message>
    <message>
        <source>%1 has reached its limit of %2°: the motion turns round.</source>
        <translation>%1, %2° olan sınırına ulaştı: hareket geri döner.</translation>
    </message>
    <message>
        <source>Whole train, from the corner</source>
        <translation>Bütün takım, köşeden</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>%1 boyunca</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>%1 cinsinden</translation>
    </message>
    <message>
        <source>This browser cannot show the train in three dimensions (%1).</source>
        <translation>Bu tarayıcı dişli takımını üç boyutta gösteremiyor (%1).</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>Satır %1, sütun %2</translation>
    </message>
    <message>
        <source>Look at %1 in the drawing.</source>
        <translation>Çizimde şuraya bakın: %1.</translation>
    </message>
    <message>
        <source>Fills the cell and goes on to the next</source>
        <translation>Hücreyi doldurur ve sonrakine geçer</translation>
    </message>
    <message>
        <source>Right, %1 of 1 point</source>
        <translation>Doğru, %1 / 1 puan</translation>
    </message>
    <message>
        <source>Right, %1 of %2 points</source>
        <translation>Doğru, %1 / %2 puan</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Yanlış</translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <translation>Yanlış: %1</translation>
    </message>
    <message>
        <source>The other field is right.</source>
        <translation>Öteki alan doğru.</translation>
    </message>
    <message>
        <source>The other %1 fields are right.</source>
        <translation>Öteki %1 alan doğru.</translation>
    </message>
    <message>
        <source>No known mistake explains it. Walk through it once more, or let it be shown.</source>
        <translation>Bilinen bir hata bunu açıklamıyor. Bir kez daha üzerinden geçin ya da çözümü gösterin.</translation>
    </message>
    <message>
        <source>Shown, no points</source>
        <translation>Gösterildi, puan yok</translation>
    </message>
    <message>
        <source>%1 of the mechanism</source>
        <translation>Mekanizma: %1</translation>
    </message>
    <message>
        <source>%1 of 1 point; %2 of %3 checked</source>
        <translation>%1 / 1 puan; %2 / %3 denetlendi</translation>
    </message>
    <message>
        <source>%1 of %2 points; %3 of %4 checked</source>
        <translation>%1 / %2 puan; %3 / %4 denetlendi</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Soru %1 / %2</translation>
    </message>
    <message>
        <source>Previous question</source>
        <translation>Önceki soru</translation>
    </message>
    <message>
        <source>Next question</source>
        <translation>Sonraki soru</translation>
    </message>
    <message>
        <source>Save answers</source>
        <translation>Yanıtları kaydet</translation>
    </message>
    <message>
        <source>Enlarge: %1</source>
        <translation>Büyüt: %1</translation>
    </message>
    <message>
        <source>Fit the window</source>
        <translation>Pencereye sığdır</translation>
    </message>
    <message>
        <source>Print the questions</source>
        <translation>Soruları yazdır</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Önceki adım</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Sonraki adım</translation>
    </message>
    <message>
        <source>Hint %1 of %2</source>
        <translation>İpucu %1 / %2</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>İpuçları</translation>
    </message>
    <message>
        <source>Of the files of %1, %2 counts.</source>
        <translation>%1 adlı öğrencinin dosyalarından %2 sayılır.</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Öğrenciler</translation>
    </message>
    <message>
        <source>not right: %1</source>
        <translation>doğru değil: %1</translation>
    </message>
    <message>
        <source>--to lists forms out of html and scorm, not &quot;%1&quot;.</source>
        <translation>--to, html ve scorm biçimlerini sayar, &quot;%1&quot; biçimini değil.</translation>
    </message>
    <message>
        <source>the pages</source>
        <translation>sayfalar</translation>
    </message>
    <message>
        <source>%1 has no meaning for lesson %2.</source>
        <translation>%1, lesson %2 için anlamsızdır.</translation>
    </message>
    <message>
        <source>list needs no file.</source>
        <translation>list dosya istemez.</translation>
    </message>
    <message>
        <source>forms: html for browsers, scorm for learning platforms (html)</source>
        <translation>biçimler: tarayıcılar için html, öğrenme platformları için scorm (html)</translation>
    </message>
    <message>
        <source>a folder for the pages and packages</source>
        <translation>sayfalar ve paketler için bir klasör</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Yeniden başla</translation>
    </message>
    <message>
        <source>Start again? All answers and the name on this device are deleted.</source>
        <translation>Yeniden başlansın mı? Bu cihazdaki tüm yanıtlar ve ad silinir.</translation>
    </message>
    <message>
        <source>What you write stays in this browser. Saved answers are a small file to hand in.</source>
        <translation>Yazdıklarınız bu tarayıcıda kalır. Kaydedilen yanıtlar, teslim edilecek küçük bir dosyadır.</translation>
    </message>
    <message>
        <source>This browser cannot grade the answers (%1): write them on paper.</source>
        <translation>Bu tarayıcı yanıtları değerlendiremiyor (%1): kâğıda yazın.</translation>
    </message>
    <message>
        <source>The 3D file has %1 faces, more than the limit of %2.</source>
        <translation>3B dosyada %1 yüz var; sınır olan %2 aşılıyor.</translation>
    </message>
    <message>
        <source>It is damaged: its header has no end.</source>
        <translation>Bozuk: başlığının sonu yok.</translation>
    </message>
    <message>
        <source>It is damaged: a face names a vertex that is not there.</source>
        <translation>Bozuk: bir yüz, var olmayan bir köşeyi adlandırıyor.</translation>
    </message>
    <message>
        <source>It has no faces that could be shown.</source>
        <translation>Gösterilebilecek yüzü yok.</translation>
    </message>
    <message>
        <source>The motion repeats only after %1 turns of what turns at 1 rad/s; that is too long for an animation.</source>
        <translation>Hareket, 1 rad/s ile dönenin ancak %1 turundan sonra yineleniyor; bu bir animasyon için çok uzun.</translation>
    </message>
    <message>
        <source>The motion is too fast for an animation that long.</source>
        <translation>Hareket bu kadar uzun bir animasyon için çok hızlı.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Durduruldu; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>The scene has %1 triangles, more than the limit of %2; choose a coarser tolerance.</source>
        <translation>Sahnede %1 üçgen var; sınır olan %2 aşılıyor; daha kaba bir tolerans seçin.</translation>
    </message>
    <message>
        <source>The scene has coordinates beyond 3.4e38, the largest that 3D files hold; bring the parts nearer to each other, or scale them down.</source>
        <translation>Sahnede 3B dosyaların alabildiği en büyük değer olan 3,4e38&apos;i aşan koordinatlar var; parçaları birbirine yaklaştırın ya da küçültün.</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; is written as &quot;%2&quot;.</source>
        <translation>&quot;%1&quot; uzvu dosyaya &quot;%2&quot; olarak yazıldı.</translation>
    </message>
    <message>
        <source>Link %1 has too little mass or inertia for simulators, which take 1e-15 kg and kg m² and more. Is the unit of length right?</source>
        <translation>%1 uzvunun kütlesi ya da ataleti simülatörler için çok küçük; en az 1e-15 kg ve kg m² gerekir. Uzunluk birimi doğru mu?</translation>
    </message>
    <message>
        <source>Coupling %1 would close a linkage and is left out.</source>
        <translation>%1 elemanı bir çubuk mekanizmasını kapatırdı, bu yüzden yazılmadı.</translation>
    </message>
    <message>
        <source>Joint %1 follows %2 (q%1 = %3)</source>
        <translation>%1 mafsalı şunları izler: %2 (q%1 = %3)</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; ve %2 tane daha</translation>
    </message>
    <message>
        <source>A joint of URDF can follow one other joint. %1. Use --to mjcf, or --state with one freedom.</source>
        <translation>URDF&apos;de bir mafsal yalnız bir mafsalı izleyebilir. %1. --to mjcf ya da bir serbestlik dereceli --state kullanın.</translation>
    </message>
    <message>
        <source>2→3: from link 2 to link 3</source>
        <translation>2→3: 2 numaralı uzuvdan 3 numaralı uzva</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>tam</translation>
    </message>
    <message>
        <source>%1 more: select links in a drawing first</source>
        <translation>%1 tane daha: önce uzuvları bir çizimde seçin</translation>
    </message>
    <message>
        <source>There is more on the left</source>
        <translation>Solda daha fazlası var</translation>
    </message>
    <message>
        <source>There is more on the right</source>
        <translation>Sağda daha fazlası var</translation>
    </message>
    <message>
        <source>They have no properties that could be changed together.</source>
        <translation>Birlikte değiştirilebilecek özellikleri yok.</translation>
    </message>
    <message>
        <source>Its joints have its place and direction: select one to change them.</source>
        <translation>Yeri ve yönü mafsallarındadır: değiştirmek için birini seçin.</translation>
    </message>
    <message>
        <source>Brake %1</source>
        <translation>%1 freni</translation>
    </message>
    <message>
        <source>Clutch %1</source>
        <translation>%1 kavraması</translation>
    </message>
    <message>
        <source>While it is engaged the brake holds its link.</source>
        <translation>Fren devredeyken uzvunu tutar.</translation>
    </message>
    <message>
        <source>While it is engaged the clutch makes its links turn as one.</source>
        <translation>Kavrama devredeyken uzuvları birlikte döner.</translation>
    </message>
    <message>
        <source>At most %1 inputs are listed.</source>
        <translation>En çok %1 giriş listelenir.</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: their masses and their motion appear here.</source>
        <translation>Döner mafsallar ve dişli çiftleri çizin: kütleleri ve hareketleri burada görünür.</translation>
    </message>
    <message>
        <source>Nothing can turn here: without an input there is no equation of motion.</source>
        <translation>Burada hiçbir şey dönemez: giriş olmadan hareket denklemi yoktur.</translation>
    </message>
    <message>
        <source>This train has too many inputs and joints: dynamics is computed for up to %1 entries of the solution.</source>
        <translation>Bu dişli takımının girişleri ve mafsalları çok fazla: dinamik, çözümün en çok %1 elemanı için hesaplanır.</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetik</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potansiyel</translation>
    </message>
    <message>
        <source>work done</source>
        <translation>yapılan iş</translation>
    </message>
    <message>
        <source>energy balance</source>
        <translation>enerji dengesi</translation>
    </message>
    <message>
        <source>Torques of the motors</source>
        <translation>Motor torkları</translation>
    </message>
    <message>
        <source>Energy gained and work done</source>
        <translation>Kazanılan enerji ve yapılan iş</translation>
    </message>
    <message>
        <source>No tooth counts within these limits come near this ratio with this sign. What fits: wider limits, or other members.</source>
        <translation>Bu sınırlar içindeki hiçbir diş sayısı bu orana bu işaretle yaklaşmıyor. Uygun olan: daha geniş sınırlar ya da başka üyeler.</translation>
    </message>
    <message>
        <source>%1 is no regular file.</source>
        <translation>%1 olağan bir dosya değil.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB, which no answers are.</source>
        <translation>%1, %2 MB&apos;den büyük; yanıtlar o kadar büyük olmaz.</translation>
    </message>
    <message>
        <source>Answers that cannot be read: %1.</source>
        <translation>Okunamayan yanıtlar: %1.</translation>
    </message>
    <message>
        <source>“%1” cannot be read from “%2” on: write a whole number, a fraction such as −3/4 or a decimal.</source>
        <translation>“%1”, “%2” kısmından sonra okunamıyor: tam sayı, −3/4 gibi bir kesir ya da ondalık sayı yazın.</translation>
    </message>
    <message>
        <source>“%1” cannot be read from “%2” on: this question knows no such symbol.</source>
        <translation>“%1”, “%2” kısmından sonra okunamıyor: bu soruda böyle bir simge yok.</translation>
    </message>
    <message>
        <source>“%1” has the unit %2: write the number in %3.</source>
        <translation>“%1” için birim %2: sayıyı %3 olarak yazın.</translation>
    </message>
    <message>
        <source>“%1” has the unit %2: write a number without a unit.</source>
        <translation>“%1” için birim %2: birimsiz bir sayı yazın.</translation>
    </message>
    <message>
        <source>%1 fields are empty: %2.</source>
        <translation>%1 alan boş: %2.</translation>
    </message>
    <message>
        <source>symbol that the question does not know</source>
        <translation>sorunun bilmediği simge</translation>
    </message>
    <message>
        <source>number in another unit</source>
        <translation>başka birimde sayı</translation>
    </message>
    <message>
        <source>A number is needed here.</source>
        <translation>Burada bir sayı gerekli.</translation>
    </message>
    <message>
        <source>the same number makes the same sheets everywhere (random)</source>
        <translation>aynı sayı her yerde aynı sayfaları üretir (rastgele)</translation>
    </message>
    <message>
        <source>--seed %1 makes these sheets again.</source>
        <translation>--seed %1 bu sayfaları yeniden üretir.</translation>
    </message>
    <message>
        <source>--seed %1 asks these questions again.</source>
        <translation>--seed %1 bu soruları yeniden sorar.</translation>
    </message>
    <message>
        <source>Cannot be read: %1</source>
        <translation>Okunamıyor: %1</translation>
    </message>
    <message>
        <source>Easy</source>
        <translation>Kolay</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Orta</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Zor</translation>
    </message>
    <message>
        <source>The document has no link &quot;%1&quot;.</source>
        <translation>Belgede “%1” uzvu yok.</translation>
    </message>
    <message>
        <source>With these losses no torques are known.</source>
        <translation>Bu kayıplarla torklar bilinmiyor.</translation>
    </message>
    <message>
        <source>No power: with these losses no torques are known.</source>
        <translation>Güç yok: bu kayıplarla torklar bilinmiyor.</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>giriş</translation>
    </message>
    <message>
        <source>driven</source>
        <translation>çıkış</translation>
    </message>
    <message>
        <source>Torques in N m</source>
        <translation>N m cinsinden torklar</translation>
    </message>
    <message>
        <source>--torque is a torque like 100Nm, not &quot;%1&quot;.</source>
        <translation>--torque, 100Nm gibi bir torktur, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>at the drive of every state, instead of the document&apos;s</source>
        <translation>her durumun girişinde, belgedekinin yerine</translation>
    </message>
    <message>
        <source>efficiency of meshes that state none</source>
        <translation>verim belirtmeyen dişli çiftlerinin verimi</translation>
    </message>
    <message>
        <source>&quot;none&quot; or &quot;stiffness&quot;</source>
        <translation>&quot;none&quot; veya &quot;stiffness&quot;</translation>
    </message>
    <message>
        <source>none, stiffness or nothing</source>
        <translation>none, stiffness veya boş</translation>
    </message>
    <message>
        <source>No forces: with these losses no torques are known. Forces tells why.</source>
        <translation>Kuvvet yok: bu kayıplarla torklar bilinmiyor. Nedenini Kuvvetler söyler.</translation>
    </message>
    <message>
        <source>The torque that holds the loads: at the driven link, or at the drive where loads on the driven link alone are given.</source>
        <translation>Yükleri dengeleyen tork: çıkışta, ya da yalnız çıkışta yük verilmişse girişte.</translation>
    </message>
    <message>
        <source>The loads on %1 act as well.</source>
        <translation>%1 üzerindeki yükler de etkir.</translation>
    </message>
    <message>
        <source>The torque at the drive takes the place of the loads on %1.</source>
        <translation>Girişteki tork, %1 üzerindeki yüklerin yerini alır.</translation>
    </message>
    <message>
        <source>State %1: link %2 turns freely beside it, at any speed. The ratio does not depend on it.</source>
        <translation>Durum %1: uzuv %2 yanında serbestçe, herhangi bir hızla döner. Oran buna bağlı değildir.</translation>
    </message>
    <message>
        <source>State %1: links %2 turn freely beside it, at any speed. The ratio does not depend on them.</source>
        <translation>Durum %1: uzuvlar %2 yanında serbestçe, herhangi bir hızla döner. Oran bunlara bağlı değildir.</translation>
    </message>
    <message>
        <source>%1: %2 N m</source>
        <translation>%1: %2 N m</translation>
    </message>
    <message>
        <source>%1: %2 to %3 N m</source>
        <translation>%1: %2 ile %3 N m arası</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too: they are given for equally stiff teeth, an assumption.</source>
        <translation>Kayıplarla dışarıdaki torklar da buna bağlıdır: eşit rijitlikte dişler için, bir varsayımla verilmiştir.</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too, and are not given.</source>
        <translation>Kayıplarla dışarıdaki torklar da buna bağlıdır ve verilmez.</translation>
    </message>
    <message>
        <source>With losses, torques outside depend on it, too, and are not given: share by stiffness to find them.</source>
        <translation>Kayıplarla dışarıdaki torklar da buna bağlıdır ve verilmez: bulmak için rijitliğe göre paylaştırın.</translation>
    </message>
    <message>
        <source>Speeds are not determined, so that nothing tells which gears drive: with losses, torques and powers are left out. Give inputs their speeds, or choose a state of one degree of freedom.</source>
        <translation>Hızlar belirli değil, bu yüzden hangi dişlilerin tahrik ettiği bilinmiyor: kayıplarla torklar ve güçler verilmez. Girişlere hız verin ya da tek serbestlik dereceli bir durum seçin.</translation>
    </message>
    <message>
        <source>All speeds are 0: at rest no power is lost, so that torques are those without losses. Give inputs their speeds.</source>
        <translation>Bütün hızlar 0: durgunken güç kaybolmaz, torklar kayıpsız olanlardır. Girişlere hız verin.</translation>
    </message>
    <message>
        <source>The load on %1 acts where the balance at %2 holds, which cancels it: no mesh passes any of it, and it counts for no efficiency. To find what it drives, put the balance elsewhere.</source>
        <translation>%1 üzerindeki yük, %2 üzerindeki dengenin tuttuğu yerde etkir ve onunla yok olur: hiçbir dişli çifti ondan bir şey iletmez ve verimde sayılmaz. Neyi tahrik ettiğini bulmak için dengeyi başka yere koyun.</translation>
    </message>
    <message>
        <source>Which gears drive was not decided: the rounds of guesses do not settle, and %1 leave too many patterns to try all of them. Torques and powers are left out.</source>
        <translation>Hangi dişlilerin tahrik ettiği belirlenemedi: tahmin turları yerleşmiyor ve %1, hepsini denemeye yetmeyecek kadar çok olasılık bırakıyor. Torklar ve güçler verilmez.</translation>
    </message>
    <message>
        <source>With these losses no torques are known: the reason is below.</source>
        <translation>Bu kayıplarla torklar bilinmiyor: nedeni aşağıda.</translation>
    </message>
    <message>
        <source>Set load sharing</source>
        <translation>Yük paylaşımını ayarla</translation>
    </message>
    <message>
        <source>With these losses no torques are known: Forces tells why.</source>
        <translation>Bu kayıplarla torklar bilinmiyor: nedenini Kuvvetler söyler.</translation>
    </message>
    <message>
        <source>At the drive of every state, about its first axis; empty: that of the loads at drives, else 1 N m</source>
        <translation>Her durumun girişinde, ilk ekseni etrafında; boş: girişlerdeki yüklerinki, yoksa 1 N m</translation>
    </message>
    <message>
        <source>Torque at the drive, N m</source>
        <translation>Girişteki tork, N m</translation>
    </message>
    <message>
        <source>Set torque at the drive</source>
        <translation>Girişteki torku ayarla</translation>
    </message>
    <message>
        <source>Torques in N m, for %1 N m at the drive.</source>
        <translation>Torklar N m, girişte %1 N m için.</translation>
    </message>
    <message>
        <source>For any sharing in which no mesh works against the others: %1.</source>
        <translation>Hiçbir dişli çiftinin ötekilere karşı çalışmadığı her paylaşımda: %1.</translation>
    </message>
    <message>
        <source>%1 is now %2</source>
        <translation>%1 artık %2</translation>
    </message>
    <message>
        <source>New numbers: %1</source>
        <translation>Yeni numaralar: %1</translation>
    </message>
    <message>
        <source>New numbers: %1, and %2 more</source>
        <translation>Yeni numaralar: %1 ve %2 tane daha</translation>
    </message>
    <message>
        <source>an object of whole numbers by the id of their link</source>
        <translation>uzvunun id değerine göre tam sayılardan oluşan bir nesne</translation>
    </message>
    <message>
        <source>expected the number of a link&apos;s colour: a whole number from 1 on.</source>
        <translation>bir uzvun renk numarası bekleniyordu: 1’den başlayan bir tam sayı.</translation>
    </message>
    <message>
        <source>%1 is a whole number, %2 to %3.</source>
        <translation>%1, %2 ile %3 arasında bir tam sayıdır.</translation>
    </message>
    <message>
        <source>A chain is links, axes and gear pairs, each pair with the link that carries both gears. Frame, teeth, kinds of gears
and the joints by which coaxial links are drawn do not matter. Equations: rotation graphs, the triples gear, gear, carrier.
Chains: displacement graphs, which tell shafts apart, too. Left out: chains where m gear pairs have fewer than m + 2
links between them, so that these turn as one; the smallest of them are listed with freedom 0.</source>
        <translation>Bir zincir uzuvlardan, eksenlerden ve dişli çiftlerinden oluşur; her çiftin iki dişliyi taşıyan bir uzvu vardır. Sabit uzuv,
dişler, dişli türleri ve eş eksenli uzuvların hangi mafsallarla çizildiği önemli değildir. Denklemler: dönme grafları,
yani dişli, dişli, taşıyıcı üçlüleri. Zincirler: milleri de ayıran yer değiştirme grafları. Alınmayanlar: m dişli
çiftinin m + 2 uzuvdan azını içerdiği, bu yüzden bunların tek parça gibi döndüğü zincirler; en küçükleri serbestlik
derecesi 0 ile listelenir.</translation>
    </message>
    <message>
        <source>Counts of chains with 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301: 27 and 81 with 6 links, 152
and 647 with 7, 1070 and 6360 with 8. Nonfractionated chains with 2 freedoms: see Tsai, Lin, J. Mech. Transm. Autom. Des.
111(4), 1989, 524.</source>
        <translation>Serbestlik derecesi 1 olan zincirlerin sayıları Yang, Ding ve ark., J. Mech. Des. 141(4), 2019, 043301 ile aynıdır:
6 uzuvla 27 ve 81, 7 uzuvla 152 ve 647, 8 uzuvla 1070 ve 6360. Serbestlik derecesi 2 olan bölünmez zincirler için bkz.
Tsai, Lin, J. Mech. Transm. Autom. Des. 111(4), 1989, 524.</translation>
    </message>
    <message>
        <source>freedom</source>
        <translation>serbestlik</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>denklemler</translation>
    </message>
    <message>
        <source>chains</source>
        <translation>zincirler</translation>
    </message>
    <message>
        <source>nonfractionated equations</source>
        <translation>bölünmez denklemler</translation>
    </message>
    <message>
        <source>Geared kinematic chains, one link held</source>
        <translation>Dişli kinematik zincirler, bir uzuv tutulmuş</translation>
    </message>
    <message>
        <source>number</source>
        <translation>numara</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>eksenler</translation>
    </message>
    <message>
        <source>gear pairs / carrier</source>
        <translation>dişli çiftleri / taşıyıcı</translation>
    </message>
    <message>
        <source>Equations: %1, chains: %2</source>
        <translation>Denklemler: %1, zincirler: %2</translation>
    </message>
    <message>
        <source>Chain %1</source>
        <translation>Zincir %1</translation>
    </message>
    <message>
        <source>axes: %1</source>
        <translation>eksenler: %1</translation>
    </message>
    <message>
        <source>gear pairs / carrier: %1</source>
        <translation>dişli çiftleri / taşıyıcı: %1</translation>
    </message>
    <message>
        <source>%1 has no meaning with a number of a chain.</source>
        <translation>%1 bir zincir numarasıyla anlamsızdır.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number of a chain, as 6-1.5.1 is.</source>
        <translation>&quot;%1&quot;, 6-1.5.1 gibi bir zincir numarası değildir.</translation>
    </message>
    <message>
        <source>The atlas has no chain %1.</source>
        <translation>Atlasta %1 zinciri yok.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; are equations; a document needs a chain, as %2 is.</source>
        <translation>&quot;%1&quot; denklemlerdir; belge için %2 gibi bir zincir gerekir.</translation>
    </message>
    <message>
        <source>One number is enough.</source>
        <translation>Bir numara yeter.</translation>
    </message>
    <message>
        <source>%1 needs the number of a chain.</source>
        <translation>%1 için bir zincir numarası gerekir.</translation>
    </message>
    <message>
        <source>The atlas has chains of up to %1 links with this freedom.</source>
        <translation>Atlasta bu serbestlik derecesiyle en çok %1 uzuvlu zincirler var.</translation>
    </message>
    <message>
        <source>only chains of so many links (3 to 7)</source>
        <translation>yalnız bu kadar uzuvlu zincirler (3 ile 7)</translation>
    </message>
    <message>
        <source>of this freedom: 1 (the default), 2, or 0: trains that cannot turn</source>
        <translation>bu serbestlik derecesiyle: 1 (varsayılan), 2 ya da 0: dönemeyen dişli dizileri</translation>
    </message>
    <message>
        <source>with so many axes</source>
        <translation>bu kadar eksenli</translation>
    </message>
    <message>
        <source>that no link parts, every link in a gear pair</source>
        <translation>hiçbir uzvun bölmediği, her uzvu bir dişli çiftinde olanlar</translation>
    </message>
    <message>
        <source>write the chain of the number as a document</source>
        <translation>bu numaralı zinciri belge olarak yaz</translation>
    </message>
    <message>
        <source>With a number</source>
        <translation>Bir numarayla</translation>
    </message>
    <message>
        <source>the link that is held</source>
        <translation>tutulan uzuv</translation>
    </message>
    <message>
        <source>a gear pair, by its place, with a ring gear; may be repeated</source>
        <translation>yerine göre, çember dişlili bir çift; yinelenebilir</translation>
    </message>
    <message>
        <source>another atlas than the program&apos;s (of geargraph-make-atlas)</source>
        <translation>programınkinden başka bir atlas (geargraph-make-atlas ile yapılmış)</translation>
    </message>
    <message>
        <source>Counts and lists geared kinematic chains; writes one as a document.</source>
        <translation>Dişli kinematik zincirleri sayar ve listeler; birini belge olarak yazar.</translation>
    </message>
    <message>
        <source>same equations, other shafts: %1</source>
        <translation>aynı denklemler, başka miller: %1</translation>
    </message>
    <message>
        <source>one gear pair less: %1</source>
        <translation>bir dişli çifti eksik: %1</translation>
    </message>
    <message>
        <source>one gear pair more: %1</source>
        <translation>bir dişli çifti fazla: %1</translation>
    </message>
    <message>
        <source>links that differ as the frame: %1</source>
        <translation>sabit uzuv olarak farklı uzuvlar: %1</translation>
    </message>
    <message>
        <source>cannot turn: %1 gear pairs between %2 links, of which one is held</source>
        <translation>dönemez: biri tutulan %2 uzuv arasında %1 dişli çifti</translation>
    </message>
    <message>
        <source>Trains of more than %1 links are not identified.</source>
        <translation>%1 uzuvdan büyük dişli dizileri tanınmaz.</translation>
    </message>
    <message>
        <source>the identification</source>
        <translation>tanıma</translation>
    </message>
    <message>
        <source>A chain that is not in the atlas</source>
        <translation>Atlasta olmayan bir zincir</translation>
    </message>
    <message>
        <source>links: %1</source>
        <translation>uzuvlar: %1</translation>
    </message>
    <message>
        <source>meshes: %1</source>
        <translation>dişli çiftleri: %1</translation>
    </message>
    <message>
        <source>freedom: %1</source>
        <translation>serbestlik derecesi: %1</translation>
    </message>
    <message>
        <source>locked: two of its links turn as one in every motion</source>
        <translation>kilitli: uzuvlarından ikisi her harekette tek parça gibi döner</translation>
    </message>
    <message>
        <source>turns by these tooth counts only; with others it would be locked</source>
        <translation>yalnız bu diş sayılarıyla döner; başkalarıyla kilitlenirdi</translation>
    </message>
    <message>
        <source>Left out: link %1, a planet that repeats another</source>
        <translation>Alınmadı: %1 uzvu, başka birini yineleyen bir gezegen</translation>
    </message>
    <message>
        <source>Left out: link %1, in no mesh</source>
        <translation>Alınmadı: %1 uzvu, hiçbir dişli çiftinde değil</translation>
    </message>
    <message>
        <source>There is no mesh.</source>
        <translation>Hiç dişli çifti yok.</translation>
    </message>
    <message>
        <source>%1 and %2 are different chains.</source>
        <translation>%1 ile %2 farklı zincirlerdir.</translation>
    </message>
    <message>
        <source>%1 and %2 are the same chain.</source>
        <translation>%1 ile %2 aynı zincirdir.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same equations, on other shafts.</source>
        <translation>%1 ile %2 aynı denklemlere sahiptir, başka millerde.</translation>
    </message>
    <message>
        <source>another document: is it the same chain, and which link is which?</source>
        <translation>başka bir belge: aynı zincir mi, hangi uzuv hangisi?</translation>
    </message>
    <message>
        <source>Which chains of the atlas a train is made of.</source>
        <translation>Bir dişli dizisinin atlasın hangi zincirlerinden oluştuğu.</translation>
    </message>
    <message>
        <source>link %1 of the chain</source>
        <translation>zincirin %1. uzvu</translation>
    </message>
    <message>
        <source>This is no atlas of chains.</source>
        <translation>Bu bir zincir atlası değil.</translation>
    </message>
    <message>
        <source>This line of the atlas is no chain with its number.</source>
        <translation>Atlasın bu satırı numarasıyla bir zincir değil.</translation>
    </message>
    <message>
        <source>Chain %1 is not at its place in the atlas, or there twice.</source>
        <translation>%1 zinciri atlasta yerinde değil ya da iki kez var.</translation>
    </message>
    <message>
        <source>also the trees, inputs and frames by which the train can be drawn</source>
        <translation>dizinin hangi ağaçlar, girdiler ve sabit uzuvlarla çizilebileceği de</translation>
    </message>
    <message>
        <source>with --choices: how many of each are listed (100)</source>
        <translation>--choices ile: her birinden kaçının listeleneceği (100)</translation>
    </message>
    <message>
        <source>over 2^63</source>
        <translation>2^63 üzeri</translation>
    </message>
    <message>
        <source>Trees of turning joints: %1</source>
        <translation>Mafsal ağaçları: %1</translation>
    </message>
    <message>
        <source>Valid sets of inputs, as pairs of links: %1</source>
        <translation>Geçerli girdi kümeleri, uzuv çiftleri olarak: %1</translation>
    </message>
    <message>
        <source>Links that differ as the frame: %1</source>
        <translation>Sabit uzuv olarak farklı uzuvlar: %1</translation>
    </message>
    <message>
        <source>There are more than %1 sets of inputs to try; they are not listed.</source>
        <translation>Denenecek %1 üzerinde girdi kümesi var; listelenmez.</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>dişli takımı %1</translation>
    </message>
    <message>
        <source>sets %1</source>
        <translation>dişli takımları %1</translation>
    </message>
    <message>
        <source>No lever: the train is not finished. Problems tells what is missing.</source>
        <translation>Kaldıraç yok: düzen bitmiş değil. Sorunlar neyin eksik olduğunu söyler.</translation>
    </message>
    <message>
        <source>No lever: no mesh joins two links on the ground&apos;s axis.</source>
        <translation>Kaldıraç yok: hiçbir diş kavraması gövdenin eksenindeki iki uzvu bağlamıyor.</translation>
    </message>
    <message>
        <source>No lever: no link on the ground&apos;s axis can turn.</source>
        <translation>Kaldıraç yok: gövdenin eksenindeki hiçbir uzuv dönemez.</translation>
    </message>
    <message>
        <source>No lever: mesh %1 leads to an axis of another direction. Bevel pinions have no place on a lever, and their side gears are not joined to another link on the ground&apos;s axis.</source>
        <translation>Kaldıraç yok: %1 numaralı diş kavraması başka yöndeki bir eksene gider. Konik pinyonların kaldıraçta yeri yoktur; yan dişlileri de gövdenin eksenindeki başka bir uzva bağlı değildir.</translation>
    </message>
    <message>
        <source>No lever: the train has more links and freedoms than levers are drawn for.</source>
        <translation>Kaldıraç yok: düzende kaldıraç çizilebilecek olandan daha çok uzuv ve serbestlik var.</translation>
    </message>
    <message>
        <source>dashed: by these tooth counts only</source>
        <translation>kesikli: yalnız bu diş sayılarıyla</translation>
    </message>
    <message>
        <source>Links %1 turn as one.</source>
        <translation>%1 numaralı uzuvlar tek uzuv gibi döner.</translation>
    </message>
    <message>
        <source>Arrows: speeds in rad/s.</source>
        <translation>Oklar: hızlar, rad/s.</translation>
    </message>
    <message>
        <source>Arrows to the right of the bars: speeds in rad/s; to the left: torques on the lever in N m.</source>
        <translation>Çubukların sağındaki oklar: hızlar, rad/s; solundakiler: kaldıraca etkiyen momentler, N m.</translation>
    </message>
    <message>
        <source>No states yet: a state engages brakes and clutches and names its drive.</source>
        <translation>Henüz durum yok: bir durum frenleri ve kavramaları devreye alır ve giriş uzvunu belirtir.</translation>
    </message>
    <message>
        <source>No state has one motion: each is locked or free.</source>
        <translation>Hiçbir durumun tek bir hareketi yok: her biri kilitli ya da serbest.</translation>
    </message>
    <message>
        <source>The plan shows two freedoms; the links on the ground&apos;s axis have %1.</source>
        <translation>Plan iki serbestliği gösterir; gövdenin eksenindeki uzuvların serbestliği %1.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>yer</translation>
    </message>
    <message>
        <source>no set</source>
        <translation>takım yok</translation>
    </message>
    <message>
        <source>%1: 1 lever, freedom %2</source>
        <translation>%1: 1 kaldıraç, serbestlik derecesi %2</translation>
    </message>
    <message>
        <source>%1: %2 levers, freedom %3</source>
        <translation>%1: %2 kaldıraç, serbestlik derecesi %3</translation>
    </message>
    <message>
        <source>* there by these tooth counts only</source>
        <translation>* yalnız bu diş sayılarıyla orada</translation>
    </message>
    <message>
        <source>the levers</source>
        <translation>kaldıraçlar</translation>
    </message>
    <message>
        <source>The levers of a train: where the links of the ground&apos;s axis have their points.</source>
        <translation>Bir düzenin kaldıraçları: gövdenin eksenindeki uzuvların noktalarının yeri.</translation>
    </message>
    <message>
        <source>modules</source>
        <translation>modül</translation>
    </message>
    <message>
        <source>gears</source>
        <translation>dişliler</translation>
    </message>
    <message>
        <source>GLB, in motion</source>
        <translation>GLB, hareketli</translation>
    </message>
    <message>
        <source>Assembly: gears with their poses</source>
        <translation>Montaj: konumlarıyla dişliler</translation>
    </message>
    <message>
        <source>gears for a check</source>
        <translation>denetim için dişliler</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Katı modeller</translation>
    </message>
    <message>
        <source>Checks of teeth</source>
        <translation>Diş denetimi</translation>
    </message>
    <message>
        <source>a model of the joints</source>
        <translation>mafsalların modeli</translation>
    </message>
    <message>
        <source>Models of the joints</source>
        <translation>Mafsal modelleri</translation>
    </message>
    <message>
        <source>the worked derivation</source>
        <translation>işlenmiş türetim</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>Türetimler</translation>
    </message>
    <message>
        <source>derivations</source>
        <translation>türetimler</translation>
    </message>
    <message>
        <source>No power flows, or what there is of loads and motion does not determine it.</source>
        <translation>Güç akmıyor ya da yükler ve hareket onu belirlemiyor.</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>resim</translation>
    </message>
    <message>
        <source>drawings</source>
        <translation>çizimler</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree.</source>
        <translation>Döner mafsallar kapsayan ağaç değil.</translation>
    </message>
    <message>
        <source>The mechanism has errors.</source>
        <translation>Mekanizmada hatalar var.</translation>
    </message>
    <message>
        <source>There is no solution, because nothing can move or inputs are missing.</source>
        <translation>Çözüm yok: hiçbir şey hareket edemiyor ya da girişler eksik.</translation>
    </message>
    <message>
        <source>The turning joints are no spanning tree, or a mesh has no carrier.</source>
        <translation>Döner mafsallar kapsayan ağaç değil ya da bir dişli çiftinin taşıyıcısı yok.</translation>
    </message>
    <message>
        <source>a graph</source>
        <translation>graf</translation>
    </message>
    <message>
        <source>Graphs</source>
        <translation>Graflar</translation>
    </message>
    <message>
        <source>graphs</source>
        <translation>graflar</translation>
    </message>
    <message>
        <source>The mechanism has no such table.</source>
        <translation>Mekanizmanın böyle bir tablosu yok.</translation>
    </message>
    <message>
        <source>matrices</source>
        <translation>matrisler</translation>
    </message>
    <message>
        <source>CSV, one matrix or table</source>
        <translation>CSV, bir matris veya tablo</translation>
    </message>
    <message>
        <source>CSV, all matrices and tables</source>
        <translation>CSV, tüm matrisler ve tablolar</translation>
    </message>
    <message>
        <source>Handouts</source>
        <translation>Ders notları</translation>
    </message>
    <message>
        <source>Simulators</source>
        <translation>Simülatörler</translation>
    </message>
    <message>
        <source>%1 with --view</source>
        <translation>--view ile %1</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tablo</translation>
    </message>
    <message>
        <source>Without labels</source>
        <translation>Etiketsiz</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Girişler</translation>
    </message>
    <message>
        <source>With exercises</source>
        <translation>Alıştırmalarla</translation>
    </message>
    <message>
        <source>This variant</source>
        <translation>Bu sürüm</translation>
    </message>
    <message>
        <source>Power seen from</source>
        <translation>Gücün görüldüğü yer</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Bakış yönü</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Yüzeyler</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gösterilenler</translation>
    </message>
    <message>
        <source>Hidden links</source>
        <translation>Gizlenen uzuvlar</translation>
    </message>
    <message>
        <source>Reference frame fixed to</source>
        <translation>Referans çerçevesinin bağlı olduğu uzuv</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Saniyedeki resim sayısı</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Resimler</translation>
    </message>
    <message>
        <source>Only the gear</source>
        <translation>Yalnızca dişli</translation>
    </message>
    <message>
        <source>Only the link</source>
        <translation>Yalnızca uzuv</translation>
    </message>
    <message>
        <source>A period plays</source>
        <translation>Bir periyodun süresi</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerans</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Yer çekimi</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Yoğunluk</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motorlar</translation>
    </message>
    <message>
        <source>Inertia of the rotors</source>
        <translation>Rotorların ataleti</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zaman adımı</translation>
    </message>
    <message>
        <source>The format cannot hold the mechanism: a joint depends on several inputs, a link is too light, or the unit of length is not known.</source>
        <translation>Biçim mekanizmayı içeremiyor: bir mafsal birden çok girişe bağlı, bir uzuv çok hafif ya da uzunluk birimi bilinmiyor.</translation>
    </message>
    <message>
        <source>a model for simulators</source>
        <translation>simülatörler için model</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>resim</translation>
    </message>
    <message>
        <source>an animation</source>
        <translation>canlandırma</translation>
    </message>
    <message>
        <source>PNG, a picture of the train</source>
        <translation>PNG, dişli takımının resmi</translation>
    </message>
    <message>
        <source>PNG, once round the train</source>
        <translation>PNG, dişli takımının çevresinde bir tur</translation>
    </message>
    <message>
        <source>PNG, one period of the motion</source>
        <translation>PNG, hareketin bir periyodu</translation>
    </message>
    <message>
        <source>PNG, once round the train, a file for each picture</source>
        <translation>PNG, dişli takımının çevresinde bir tur, her resim için bir dosya</translation>
    </message>
    <message>
        <source>PNG, one period of the motion, a file for each picture</source>
        <translation>PNG, hareketin bir periyodu, her resim için bir dosya</translation>
    </message>
    <message>
        <source>GLB, the train as seen</source>
        <translation>GLB, görüldüğü gibi dişli takımı</translation>
    </message>
    <message>
        <source>3D pictures</source>
        <translation>3B resimler</translation>
    </message>
    <message>
        <source>Animations</source>
        <translation>Canlandırmalar</translation>
    </message>
    <message>
        <source>animations</source>
        <translation>canlandırmalar</translation>
    </message>
    <message>
        <source>The train as seen</source>
        <translation>Görüldüğü gibi dişli takımı</translation>
    </message>
    <message>
        <source>Handout, a web page</source>
        <translation>Ders notu, bir web sayfası</translation>
    </message>
    <message>
        <source>a page for browsers, with inputs to move</source>
        <translation>girişleri oynatılabilen, tarayıcılar için bir sayfa</translation>
    </message>
    <message>
        <source>Handout for learning platforms (SCORM 1.2)</source>
        <translation>Öğrenme ortamları için ders notu (SCORM 1.2)</translation>
    </message>
    <message>
        <source>that page as a package for learning platforms (SCORM 1.2)</source>
        <translation>o sayfa, öğrenme ortamları için paket olarak (SCORM 1.2)</translation>
    </message>
    <message>
        <source>handouts</source>
        <translation>ders notları</translation>
    </message>
    <message>
        <source>The mechanism, or what would be written, is too large.</source>
        <translation>Mekanizma ya da yazılacak olan çok büyük.</translation>
    </message>
    <message>
        <source>Gears cannot be made.</source>
        <translation>Dişliler oluşturulamıyor.</translation>
    </message>
    <message>
        <source>Nothing can paint pictures here, or a picture is too large to be painted.</source>
        <translation>Burada resim çizebilecek bir şey yok ya da resim çizilemeyecek kadar büyük.</translation>
    </message>
    <message>
        <source>--to is one of %1.</source>
        <translation>--to şunlardan biridir: %1.</translation>
    </message>
    <message>
        <source>Export into the new folder</source>
        <translation>Yeni klasöre dışa aktar</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Dışa aktar</translation>
    </message>
    <message>
        <source>Exporting %1: %2 %.</source>
        <translation>%1 dışa aktarılıyor: %2 %.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Biçim</translation>
    </message>
    <message>
        <source>This format has no options.</source>
        <translation>Bu biçimin seçeneği yok.</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Her zamanki gibi</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>This is no certificate of teeth.</source>
        <translation>Bu bir diş sertifikası değil.</translation>
    </message>
    <message>
        <source>The certificate is newer than this program.</source>
        <translation>Sertifika bu programdan daha yeni.</translation>
    </message>
    <message>
        <source>%1 is not what a certificate has there.</source>
        <translation>%1, bir sertifikada o yerde bulunan şey değil.</translation>
    </message>
    <message>
        <source>The mark is not that of the problem: it was changed.</source>
        <translation>İşaret problemin işareti değil: problem değiştirilmiş.</translation>
    </message>
    <message>
        <source>The wheels are not those of the meshes.</source>
        <translation>Dişliler, kavramaların dişlileri değil.</translation>
    </message>
    <message>
        <source>Ratio %1 is not that of the mechanism.</source>
        <translation>%1. oran mekanizmanın oranı değil.</translation>
    </message>
    <message>
        <source>The counts are %1 choices and %2 within the bounds, not %3 and %4.</source>
        <translation>Sayılar %1 seçenek ve sınırlar içinde %2; %3 ve %4 değil.</translation>
    </message>
    <message>
        <source>The counts of the branches are not those of the choices.</source>
        <translation>Dalların sayıları seçeneklerin sayıları değil.</translation>
    </message>
    <message>
        <source>Choices are listed that there are not.</source>
        <translation>Var olmayan seçenekler listelenmiş.</translation>
    </message>
    <message>
        <source>Choice %1 is not the one that follows.</source>
        <translation>%1. seçenek sıradaki seçenek değil.</translation>
    </message>
    <message>
        <source>a ratio other than 0: a number, or a string like &quot;9/2&quot; or &quot;0.632&quot;</source>
        <translation>0 dışında bir oran: bir sayı ya da &quot;9/2&quot; veya &quot;0.632&quot; gibi bir metin</translation>
    </message>
    <message>
        <source>There are no teeth from %1 to %2.</source>
        <translation>%1 ile %2 arasında diş sayısı yok.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or &quot;%2&quot;</source>
        <translation>“%1” ya da “%2”</translation>
    </message>
    <message>
        <source>There is no member &quot;%1&quot; in a wish.</source>
        <translation>Bir istekte “%1” üyesi yoktur.</translation>
    </message>
    <message>
        <source>a list of ratios</source>
        <translation>bir oran listesi</translation>
    </message>
    <message>
        <source>a list of 1 to %1 ratios</source>
        <translation>1 ile %1 arası orandan oluşan bir liste</translation>
    </message>
    <message>
        <source>Drive and driven are one link.</source>
        <translation>Giriş ve çıkış aynı uzuv.</translation>
    </message>
    <message>
        <source>Link %1 is held, so that it has no ratio.</source>
        <translation>%1 uzvu tutuluyor, bu yüzden oranı yok.</translation>
    </message>
    <message>
        <source>the name of a state</source>
        <translation>bir durumun adı</translation>
    </message>
    <message>
        <source>A ratio is wanted in a state or with links held, not in both.</source>
        <translation>Bir oran ya bir durumda ya da tutulan uzuvlarla istenir, ikisi birden değil.</translation>
    </message>
    <message>
        <source>no ratio beside an interval</source>
        <translation>bir aralığın yanında oran olmaması</translation>
    </message>
    <message>
        <source>With the ratio 0 the drive would stand still while link %1 turns.</source>
        <translation>0 oranıyla %1 uzvu dönerken giriş dururdu.</translation>
    </message>
    <message>
        <source>two ratios of one sign, the smaller first</source>
        <translation>aynı işaretli iki oran, önce küçüğü</translation>
    </message>
    <message>
        <source>Without &quot;wheels&quot; there is none that could be used once.</source>
        <translation>“wheels” olmadan bir kez kullanılabilecek dişli yoktur.</translation>
    </message>
    <message>
        <source>a list of 1 to %1 numbers of teeth from 1 to %2</source>
        <translation>1 ile %2 arasında diş sayılarından, 1 ile %1 öğeli bir liste</translation>
    </message>
    <message>
        <source>There is no wheel &quot;%1&quot;: wheels are named like 15:tail.</source>
        <translation>“%1” diye bir dişli yok: dişliler 15:tail gibi adlandırılır.</translation>
    </message>
    <message>
        <source>no efficiency of a set beside that of a mesh</source>
        <translation>bir kavramanınkinin yanında takım verimi olmaması</translation>
    </message>
    <message>
        <source>a relative tolerance from 0 to below 1</source>
        <translation>0 ile 1&apos;in altı arasında göreli bir tolerans</translation>
    </message>
    <message>
        <source>an efficiency above 0 and at most 1</source>
        <translation>0&apos;dan büyük ve en çok 1 olan bir verim</translation>
    </message>
    <message>
        <source>There are no gears whose teeth could be chosen.</source>
        <translation>Dişleri seçilebilecek dişli çark yok.</translation>
    </message>
    <message>
        <source>The speeds of links %1 and %2 have no ratio that the teeth determine.</source>
        <translation>%1 ve %2 uzuvlarının hızlarının, dişlerin belirlediği bir oranı yok.</translation>
    </message>
    <message>
        <source>The ratio depends on %1 gear pairs: teeth are looked for in trains of at most %2.</source>
        <translation>Oran %1 dişli çiftine bağlı: dişler en çok %2 çiftli dişli dizilerinde aranır.</translation>
    </message>
    <message>
        <source>Not all choices were tried, so that there is nothing to certify.</source>
        <translation>Bütün seçenekler denenmedi, bu yüzden belgelenecek bir şey yok.</translation>
    </message>
    <message>
        <source>A wish with a least efficiency has no certificate.</source>
        <translation>En düşük verim isteyen bir istek için sertifika yoktur.</translation>
    </message>
    <message>
        <source>A train that locks with other teeth has no certificate.</source>
        <translation>Başka dişlerle kilitlenen bir dişli dizisi için sertifika yoktur.</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>seçenek</translation>
    </message>
    <message>
        <source>planets</source>
        <translation>gezegenler</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>alttan kesme</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>dönüyor</translation>
    </message>
    <message>
        <source>with planets that clear each other</source>
        <translation>birbirine değmeyen gezegenlerle</translation>
    </message>
    <message>
        <source>with equal planets that go in</source>
        <translation>takılabilen eş gezegenlerle</translation>
    </message>
    <message>
        <source>with hunting teeth only</source>
        <translation>yalnızca gezici dişlerle</translation>
    </message>
    <message>
        <source>without undercut</source>
        <translation>alttan kesmesiz</translation>
    </message>
    <message>
        <source>within the bounds</source>
        <translation>sınırlar içinde</translation>
    </message>
    <message>
        <source>All %1 choices were tried.</source>
        <translation>%1 seçeneğin hepsi denendi.</translation>
    </message>
    <message>
        <source>meet the wish</source>
        <translation>isteği karşılıyor</translation>
    </message>
    <message>
        <source>None. The nearest</source>
        <translation>Hiçbiri. En yakını</translation>
    </message>
    <message>
        <source>Choices, the best first</source>
        <translation>Seçenekler, en iyisi önce</translation>
    </message>
    <message>
        <source>The certificate holds: %1 choices were tried again, %2 are within the bounds.</source>
        <translation>Sertifika doğru: %1 seçenek yeniden denendi, %2 tanesi sınırlar içinde.</translation>
    </message>
    <message>
        <source>The certificate does not hold.</source>
        <translation>Sertifika doğru değil.</translation>
    </message>
    <message>
        <source>A certificate is checked by itself, without a mechanism and a wish.</source>
        <translation>Bir sertifika tek başına, mekanizma ve istek olmadan denetlenir.</translation>
    </message>
    <message>
        <source>A mechanism and a file with a wish are needed.</source>
        <translation>Bir mekanizma ve içinde istek olan bir dosya gerekiyor.</translation>
    </message>
    <message>
        <source>inner planet %1</source>
        <translation>iç planet %1</translation>
    </message>
    <message>
        <source>outer planet %1</source>
        <translation>dış planet %1</translation>
    </message>
    <message>
        <source>Found by the gearbox designer. Ratios: %1. One planet or pair of each set is drawn; numbers that go in: %2.</source>
        <translation>Vites kutusu tasarımcısı tarafından bulundu. Oranlar: %1. Her takımın bir planeti veya çifti çizilidir; takılabilen sayılar: %2.</translation>
    </message>
    <message>
        <source>One mesh of each set has the whole basic efficiency of the set, the others lose nothing.</source>
        <translation>Her takımın bir kavraması takımın bütün temel verimini taşır, diğerleri hiçbir şey kaybetmez.</translation>
    </message>
    <message>
        <source>It is of another version of the search.</source>
        <translation>Aramanın başka bir sürümüne ait.</translation>
    </message>
    <message>
        <source>Line %1 is none of a finished part of a gearbox search.</source>
        <translation>%1. satır, vites kutusu aramasının bitmiş bir parçasına ait değil.</translation>
    </message>
    <message>
        <source>The file ends early: its gearboxes are fewer than its first line says.</source>
        <translation>Dosya erken bitiyor: vites kutuları ilk satırının söylediğinden az.</translation>
    </message>
    <message>
        <source>These are parts of searches for different wishes.</source>
        <translation>Bunlar farklı istekler için yapılan aramaların parçaları.</translation>
    </message>
    <message>
        <source>These are parts of %1 and of %2: a search is parted once.</source>
        <translation>Bunlar %1 ve %2 parçalı aramalara ait: bir arama bir kez bölünür.</translation>
    </message>
    <message>
        <source>Part %1 is in two files that hold further parts: merge single parts.</source>
        <translation>%1. parça, başka parçalar da içeren iki dosyada var: tek parçaları birleştirin.</translation>
    </message>
    <message>
        <source>It is of another wish, another part or another version of the search.</source>
        <translation>Başka bir isteğe, başka bir parçaya veya aramanın başka bir sürümüne ait.</translation>
    </message>
    <message>
        <source>It holds a line that is none of this search.</source>
        <translation>Bu aramaya ait olmayan bir satır içeriyor.</translation>
    </message>
    <message>
        <source>an object of wheels with their teeth, {&quot;1.ring&quot;: 72}</source>
        <translation>dişlileri diş sayılarıyla veren bir nesne, {&quot;1.ring&quot;: 72}</translation>
    </message>
    <message>
        <source>there is no wheel &quot;%1&quot;; wheels are named like &quot;1.ring&quot;, &quot;2.sun1&quot;, &quot;2.planet1&quot;.</source>
        <translation>&quot;%1&quot; diye bir dişli yok; dişliler &quot;1.ring&quot;, &quot;2.sun1&quot;, &quot;2.planet1&quot; gibi adlandırılır.</translation>
    </message>
    <message>
        <source>a list of gears with ratios, {&quot;gear&quot;: 4, &quot;ratio&quot;: &quot;0.98884&quot;}</source>
        <translation>viteslerin oranlarıyla bir listesi, {&quot;gear&quot;: 4, &quot;ratio&quot;: &quot;0.98884&quot;}</translation>
    </message>
    <message>
        <source>a ratio in a string</source>
        <translation>dize olarak bir oran</translation>
    </message>
    <message>
        <source>only sets in series are searched.</source>
        <translation>yalnızca seri bağlı takımlar aranır.</translation>
    </message>
    <message>
        <source>only sets of which one sun is held at a time are searched.</source>
        <translation>yalnızca her seferinde bir güneşi tutulan takımlar aranır.</translation>
    </message>
    <message>
        <source>a ratio above 0 in a string: a decimal like &quot;2.34&quot; or a fraction like &quot;7/3&quot;</source>
        <translation>dize olarak 0&apos;dan büyük bir oran: &quot;2.34&quot; gibi bir ondalık sayı veya &quot;7/3&quot; gibi bir kesir</translation>
    </message>
    <message>
        <source>a list of two whole numbers from %1 to %2, the smaller one first</source>
        <translation>%1 ile %2 arasında iki tam sayının listesi, önce küçüğü</translation>
    </message>
    <message>
        <source>a number from 0 to below 1, the part of each ratio</source>
        <translation>0 ile 1 arasında (1 hariç) bir sayı, her oranın payı</translation>
    </message>
    <message>
        <source>a list of 1 to %1 ratios in strings, each above 0</source>
        <translation>dize olarak 1 ile %1 arası oranın listesi, her biri 0&apos;dan büyük</translation>
    </message>
    <message>
        <source>a wish has no member &quot;%1&quot;.</source>
        <translation>bir isteğin &quot;%1&quot; üyesi yok.</translation>
    </message>
    <message>
        <source>a list of 1 to 4 sets, &quot;simple&quot;, &quot;double&quot; or &quot;ravigneaux&quot;, which counts twice</source>
        <translation>1 ile 4 takımın listesi: &quot;simple&quot;, &quot;double&quot; veya iki sayılan &quot;ravigneaux&quot;</translation>
    </message>
    <message>
        <source>a list of two numbers above 1 and at most 10, the smaller one first</source>
        <translation>1&apos;den büyük ve en çok 10 olan iki sayının listesi, önce küçüğü</translation>
    </message>
    <message>
        <source>an efficiency above 0, at most 1</source>
        <translation>0&apos;dan büyük, en çok 1 olan bir verim</translation>
    </message>
    <message>
        <source>one of &quot;mesh&quot; and &quot;set&quot; is needed, not both.</source>
        <translation>&quot;mesh&quot; ve &quot;set&quot; üyelerinden biri gerekir, ikisi birden değil.</translation>
    </message>
    <message>
        <source>Shafts would have to cross each other.</source>
        <translation>Miller birbirini kesmek zorunda kalır.</translation>
    </message>
    <message>
        <source>A brake cannot reach the housing: other links enclose its link.</source>
        <translation>Bir fren gövdeye ulaşamaz: başka uzuvlar onun uzvunu çevreler.</translation>
    </message>
    <message>
        <source>A clutch cannot reach both of its links without crossing others.</source>
        <translation>Bir kavrama, başkalarını kesmeden iki uzvuna birden ulaşamaz.</translation>
    </message>
    <message>
        <source>Input and output cannot come out at the two ends.</source>
        <translation>Giriş ve çıkış iki uçtan dışarı çıkamaz.</translation>
    </message>
    <message>
        <source>No. %1: %2 elements, largest error %3</source>
        <translation>No. %1: %2 eleman, en büyük hata %3</translation>
    </message>
    <message>
        <source>Teeth, sun planet ring: %1</source>
        <translation>Dişler, güneş planet çember: %1</translation>
    </message>
    <message>
        <source>Largest over that of the input: power through a member %1, torque of an element %2, slip of an open element %3, speed of a link %4</source>
        <translation>Girişinkine göre en büyükler: bir üyeden geçen güç %1, bir elemanın momenti %2, açık bir elemanın kayması %3, bir uzvun hızı %4</translation>
    </message>
    <message>
        <source>Its section can be drawn without crossing shafts.</source>
        <translation>Kesiti, miller birbirini kesmeden çizilebilir.</translation>
    </message>
    <message>
        <source>%1 layouts, %2 found</source>
        <translation>%1 düzen, %2 bulundu</translation>
    </message>
    <message>
        <source>Complete: these elements have fewer states than gears are wanted, or no layout has so many links.</source>
        <translation>Eksiksiz: bu elemanların durumları istenen viteslerden az ya da hiçbir düzende bu kadar uzuv yok.</translation>
    </message>
    <message>
        <source>All layouts were searched, but ring ratios at %1 only: sampled, not a proof.</source>
        <translation>Bütün düzenler arandı, ama çember oranları yalnızca %1 için: örneklendi, kanıt değil.</translation>
    </message>
    <message>
        <source>%1 values for each set</source>
        <translation>her takımda %1 değer</translation>
    </message>
    <message>
        <source>the search</source>
        <translation>arama</translation>
    </message>
    <message>
        <source>how many choices are given, the best first (20)</source>
        <translation>kaç seçenek verileceği, en iyisi önce (20)</translation>
    </message>
    <message>
        <source>write what proves that all choices were tried</source>
        <translation>bütün seçeneklerin denendiğini kanıtlayanı yaz</translation>
    </message>
    <message>
        <source>check such a proof, with code of its own</source>
        <translation>böyle bir kanıtı kendi koduyla denetle</translation>
    </message>
    <message>
        <source>merge needs the files of parts.</source>
        <translation>merge için parçaların dosyaları gerekir.</translation>
    </message>
    <message>
        <source>%1 has no meaning for gearbox merge.</source>
        <translation>%1, gearbox merge için anlamsız.</translation>
    </message>
    <message>
        <source>One wish is needed.</source>
        <translation>Bir istek gerekir.</translation>
    </message>
    <message>
        <source>--parts is for gearbox merge.</source>
        <translation>--parts, gearbox merge içindir.</translation>
    </message>
    <message>
        <source>--shard is R/N, the part R of N, counted from 0, not &quot;%1&quot;.</source>
        <translation>--shard, R/N&apos;dir: N parçanın 0&apos;dan sayılan R&apos;incisi; &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--shard needs a file: -o FILE.</source>
        <translation>--shard için bir dosya gerekir: -o FILE.</translation>
    </message>
    <message>
        <source>--resume needs --shard.</source>
        <translation>--resume için --shard gerekir.</translation>
    </message>
    <message>
        <source>how many gearboxes are shown and written (20)</source>
        <translation>kaç vites kutusunun gösterilip yazılacağı (20)</translation>
    </message>
    <message>
        <source>how many layouts are searched at once (all processors but one)</source>
        <translation>aynı anda kaç düzenin aranacağı (biri dışında bütün işlemciler)</translation>
    </message>
    <message>
        <source>a folder for the documents; with --shard the file of the part</source>
        <translation>belgeler için bir klasör; --shard ile parçanın dosyası</translation>
    </message>
    <message>
        <source>searches the part R of N only, counted from 0, into a file</source>
        <translation>yalnızca N parçanın 0&apos;dan sayılan R&apos;incisini bir dosyaya arar</translation>
    </message>
    <message>
        <source>On many machines</source>
        <translation>Birçok bilgisayarda</translation>
    </message>
    <message>
        <source>goes on where the part was stopped; nothing if it is finished</source>
        <translation>parçanın durdurulduğu yerden sürdürür; bittiyse hiçbir şey yapmaz</translation>
    </message>
    <message>
        <source>merge: writes the merged parts, of which some may be missing</source>
        <translation>merge: birleştirilen parçaları yazar; bazıları eksik olabilir</translation>
    </message>
    <message>
        <source>Gearboxes from planetary sets, brakes and clutches with wanted ratios.</source>
        <translation>İstenen oranlarda, planet takımları, frenler ve kavramalardan vites kutuları.</translation>
    </message>
    <message>
        <source>%1 of %2 layouts, %3 found</source>
        <translation>%2 düzenden %1 tanesi, %3 bulundu</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 yazılamadı.</translation>
    </message>
    <message>
        <source>%1 of %2 parts are missing, the first is %3/%2.</source>
        <translation>%2 parçadan %1 tanesi eksik, ilki %3/%2.</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>sıra</translation>
    </message>
    <message>
        <source>sun on planet, ring of each set</source>
        <translation>her takımın güneş/planeti, çemberi</translation>
    </message>
    <message>
        <source>ratios</source>
        <translation>oranlar</translation>
    </message>
    <message>
        <source>Count %1. By the number of teeth there remain %2.</source>
        <translation>%1 dişlerini sayın. Diş sayısına göre kalanlar: %2.</translation>
    </message>
    <message>
        <source>Turn the input %1 times in %2. By the degrees of the output there remain %3.</source>
        <translation>%2 içinde girişi %1 kez çevirin. Çıkışın derecelerine göre kalanlar: %3.</translation>
    </message>
    <message>
        <source>%1 candidates of %2 tooth sets with these ratios. All tooth sets of the structures with the fewest suns were tried.</source>
        <translation>Bu oranlara sahip %2 diş takımından %1 aday. En az güneşli yapıların bütün diş takımları denendi.</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Adaylar</translation>
    </message>
    <message>
        <source>No equal planets at equal distances can be assembled</source>
        <translation>Eşit aralıklı eş planetler takılamaz</translation>
    </message>
    <message>
        <source>All candidates share: %1.</source>
        <translation>Bütün adaylarda ortak: %1.</translation>
    </message>
    <message>
        <source>Candidates %1 have the same ratios: no turning tells them apart.</source>
        <translation>%1 adaylarının oranları aynı: çevirerek ayırt edilemezler.</translation>
    </message>
    <message>
        <source>how many candidates are shown (20)</source>
        <translation>kaç adayın gösterileceği (20)</translation>
    </message>
    <message>
        <source>The planetary sets that may be inside a hub gear with these ratios.</source>
        <translation>Bu oranlara sahip bir göbek vitesinin içinde olabilecek planet takımları.</translation>
    </message>
    <message>
        <source>Gearbox designer</source>
        <translation>Şanzıman tasarımı</translation>
    </message>
    <message>
        <source>Searches for planetary sets, brakes and clutches that have the ratios you want.</source>
        <translation>İstediğiniz oranları veren planet dişli takımlarını, frenleri ve kavramaları arar.</translation>
    </message>
    <message>
        <source>The list is of the earlier wish until you search again.</source>
        <translation>Yeniden arayana kadar liste önceki isteğe aittir.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Devam et</translation>
    </message>
    <message>
        <source>Keeps what was found (Esc)</source>
        <translation>Bulunanları korur (Esc)</translation>
    </message>
    <message>
        <source>Gearboxes with the ratios you want</source>
        <translation>İstediğiniz oranlara sahip şanzımanlar</translation>
    </message>
    <message>
        <source>Gears: %1, sets: %2</source>
        <translation>Vites: %1, takım: %2</translation>
    </message>
    <message>
        <source>Gears: %1 and reverse, sets: %2</source>
        <translation>Vites: %1 ve geri, takım: %2</translation>
    </message>
    <message>
        <source>Listing layouts…</source>
        <translation>Düzenler listeleniyor…</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Duraklatıldı</translation>
    </message>
    <message>
        <source>Paused at %1 of %2 layouts, %3 found</source>
        <translation>%2 düzenden %1 tanesinde duraklatıldı, %3 bulundu</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>eksiksiz</translation>
    </message>
    <message>
        <source>sampled, not a proof</source>
        <translation>örneklendi, kanıt değil</translation>
    </message>
    <message>
        <source>No layout has so many links.</source>
        <translation>Hiçbir düzende bu kadar uzuv yok.</translation>
    </message>
    <message>
        <source>Every layout is searched, but the ratio of ring to sun at %1 values of each set only, from which the nearest whole teeth are taken.</source>
        <translation>Her düzen aranır, ama çember güneş oranı her takımda yalnız %1 değerde denenir; oradan en yakın tam diş sayıları alınır.</translation>
    </message>
    <message>
        <source>Every layout is searched, but the ratios of ring to sun at %1 points only, from which the nearest whole teeth are taken.</source>
        <translation>Her düzen aranır, ama çember güneş oranları yalnız %1 noktada denenir; oradan en yakın tam diş sayıları alınır.</translation>
    </message>
    <message>
        <source>Type ratios and choose Search.&lt;br&gt;Six ratios are enough: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</source>
        <translation>Oranları yazıp Ara düğmesini seçin.&lt;br&gt;Altı oran yeter: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</translation>
    </message>
    <message>
        <source>None: no layout of these sets has so many links.</source>
        <translation>Yok: bu takımların hiçbir düzeninde bu kadar uzuv yok.</translation>
    </message>
    <message>
        <source>Nothing yet.</source>
        <translation>Henüz bir şey yok.</translation>
    </message>
    <message>
        <source>Shift table of the chosen gearbox</source>
        <translation>Seçilen şanzımanın vites tablosu</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>istenen</translation>
    </message>
    <message>
        <source>The largest circulating power, as a part of the power at the input</source>
        <translation>En büyük dolaşan güç, giriş gücünün parçası olarak</translation>
    </message>
    <message>
        <source>Opens this gearbox as a document with its states, in a new window</source>
        <translation>Bu şanzımanı durumlarıyla birlikte bir belge olarak yeni pencerede açar</translation>
    </message>
    <message>
        <source>Open No. %1</source>
        <translation>%1 numarayı aç</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>%1 numara</translation>
    </message>
    <message>
        <source>Choose a gearbox of the list.</source>
        <translation>Listeden bir şanzıman seçin.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>herhangi</translation>
    </message>
    <message>
        <source>Which brakes and clutches each gear engages</source>
        <translation>Her vitesin devreye aldığı frenler ve kavramalar</translation>
    </message>
    <message>
        <source>The largest difference from a wanted ratio, relative to it</source>
        <translation>İstenen bir orandan en büyük fark, ona göre</translation>
    </message>
    <message>
        <source>The least efficiency of a gear; the wish gives that of a mesh</source>
        <translation>Bir vitesin en düşük verimi; dişli çiftininkini istek verir</translation>
    </message>
    <message>
        <source>Can its section be drawn without shafts that cross?</source>
        <translation>Kesiti, kesişen miller olmadan çizilebilir mi?</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Sıra</translation>
    </message>
    <message>
        <source>worst η</source>
        <translation>en düşük η</translation>
    </message>
    <message>
        <source>buildable</source>
        <translation>yapılabilir</translation>
    </message>
    <message>
        <source>Gearboxes that were found</source>
        <translation>Bulunan şanzımanlar</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Oranlar</translation>
    </message>
    <message>
        <source>Wanted ratios</source>
        <translation>İstenen oranlar</translation>
    </message>
    <message>
        <source>4.17 2.34 1.52 …</source>
        <translation>4,17 2,34 1,52 …</translation>
    </message>
    <message>
        <source>Input over output of each gear, first gear first: decimals or fractions, typed or pasted</source>
        <translation>Her vitesin giriş bölü çıkışı, önce birinci vites: ondalık sayı veya kesir, yazılmış ya da yapıştırılmış</translation>
    </message>
    <message>
        <source>any ratio</source>
        <translation>herhangi bir oran</translation>
    </message>
    <message>
        <source>this ratio</source>
        <translation>bu oran</translation>
    </message>
    <message>
        <source>no reverse</source>
        <translation>geri vites yok</translation>
    </message>
    <message>
        <source>Wanted ratio of the reverse</source>
        <translation>Geri vitesin istenen oranı</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Geri</translation>
    </message>
    <message>
        <source>By how many percent a ratio may differ; empty: ratios are rounded as typed</source>
        <translation>Bir oranın yüzde kaç farklı olabileceği; boş: oranlar yazıldığı gibi yuvarlanmış sayılır</translation>
    </message>
    <message>
        <source>Tolerance in percent</source>
        <translation>Yüzde olarak tolerans</translation>
    </message>
    <message>
        <source>% of every ratio</source>
        <translation>% (her oranın)</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Takımlar</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>basit</translation>
    </message>
    <message>
        <source>double planets</source>
        <translation>çift gezegenli</translation>
    </message>
    <message>
        <source>Ravigneaux</source>
        <translation>Ravigneaux takımı</translation>
    </message>
    <message>
        <source>Shafts that can turn, the input shaft too</source>
        <translation>Dönebilen miller, giriş mili dahil</translation>
    </message>
    <message>
        <source>rotating links</source>
        <translation>dönen uzuvlar</translation>
    </message>
    <message>
        <source>Members of sets that are part of the housing</source>
        <translation>Gövdenin parçası olan takım üyeleri</translation>
    </message>
    <message>
        <source>members held</source>
        <translation>sabit üyeler</translation>
    </message>
    <message>
        <source>input joined by clutches only</source>
        <translation>giriş yalnız kavramalarla bağlı</translation>
    </message>
    <message>
        <source>Also layouts whose input shaft has no member of a set</source>
        <translation>Giriş milinde takım üyesi olmayan düzenler de</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemanlar</translation>
    </message>
    <message>
        <source>Brakes and clutches together</source>
        <translation>Frenler ve kavramalar birlikte</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>en fazla</translation>
    </message>
    <message>
        <source>brakes</source>
        <translation>frenler</translation>
    </message>
    <message>
        <source>clutches</source>
        <translation>kavramalar</translation>
    </message>
    <message>
        <source>Show what the exercises ask for</source>
        <translation>Alıştırmaların sorduğunu göster</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>çizilen</translation>
    </message>
    <message>
        <source>%1: pinned, it keeps its teeth</source>
        <translation>%1: sabitlenmiş, dişlerini korur</translation>
    </message>
    <message>
        <source>%1. Ticked: its teeth may change</source>
        <translation>%1. İşaretli: dişleri değişebilir</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>sabit</translation>
    </message>
    <message>
        <source>Its teeth follow from the others: one distance between two axes</source>
        <translation>Dişleri diğerlerinden çıkar: iki eksen arasında tek uzaklık</translation>
    </message>
    <message>
        <source>Whole teeth with which the train has the ratios that you want, all of them.</source>
        <translation>Takımın istediğiniz oranları verdiği tam diş sayıları, hepsi.</translation>
    </message>
    <message>
        <source>The link that drives</source>
        <translation>Tahrik eden uzuv</translation>
    </message>
    <message>
        <source>The link that is driven</source>
        <translation>Tahrik edilen uzuv</translation>
    </message>
    <message>
        <source>In which state the ratio is wanted, or which links are held</source>
        <translation>Oranın hangi durumda istendiği ya da hangi uzuvların tutulduğu</translation>
    </message>
    <message>
        <source>The numbers of the links that are held, such as 2 4</source>
        <translation>Tutulan uzuvların numaraları, örneğin 2 4</translation>
    </message>
    <message>
        <source>Speed of the drive over that of the driven link: 64, 9/2 or 0.632</source>
        <translation>Tahrik eden uzvun hızının tahrik edileninkine oranı: 64, 9/2 ya da 0,632</translation>
    </message>
    <message>
        <source>How far the ratio may be missed: 0.5 % of it, or by a number such as 0.01. Empty: a decimal is taken as rounded, any other ratio is wanted exactly</source>
        <translation>Oran ne kadar sapabilir: 0,5 % gibi bir pay ya da 0,01 gibi bir sayı kadar. Boş: ondalık sayı yuvarlanmış sayılır, başka her oran tam istenir</translation>
    </message>
    <message>
        <source>Remove this ratio</source>
        <translation>Bu oranı kaldır</translation>
    </message>
    <message>
        <source>such as 2 4</source>
        <translation>örneğin 2 4</translation>
    </message>
    <message>
        <source>in state %1</source>
        <translation>%1 durumunda</translation>
    </message>
    <message>
        <source>as engaged now</source>
        <translation>şimdi devrede olduğu gibi</translation>
    </message>
    <message>
        <source>with links held:</source>
        <translation>uzuvlar tutulurken:</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>şimdi %1</translation>
    </message>
    <message>
        <source>%1, meshes with %2</source>
        <translation>%1, %2 ile kavraşır</translation>
    </message>
    <message>
        <source>+ Ratio</source>
        <translation>+ Oran</translation>
    </message>
    <message>
        <source>Another ratio of the same train: all of them have to be met</source>
        <translation>Aynı takımın bir oranı daha: hepsi sağlanmalıdır</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>İstenen</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>Dişliler</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Varsayılanlar</translation>
    </message>
    <message>
        <source>The limits as they are at first</source>
        <translation>Sınırlar baştaki gibi</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Sınırlar</translation>
    </message>
    <message>
        <source>ring : sun</source>
        <translation>çember : güneş</translation>
    </message>
    <message>
        <source>teeth from</source>
        <translation>en az diş</translation>
    </message>
    <message>
        <source>rings to</source>
        <translation>çemberler en çok</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>hesaplanmaz</translation>
    </message>
    <message>
        <source>Efficiency of a mesh, such as 0.98, from which that of each gear follows</source>
        <translation>Bir dişli çiftinin verimi, örneğin 0,98; her vitesinki bundan çıkar</translation>
    </message>
    <message>
        <source>buildable only</source>
        <translation>yalnız yapılabilir olanlar</translation>
    </message>
    <message>
        <source>Only gearboxes whose section can be drawn without shafts that cross</source>
        <translation>Yalnız kesiti kesişen miller olmadan çizilebilen şanzımanlar</translation>
    </message>
    <message>
        <source>Impossible: %1 gears need as many states; %2 of %3 elements give fewer.</source>
        <translation>Olanaksız: %1 vites o kadar durum ister; %3 elemandan %2 tanesi daha az verir.</translation>
    </message>
    <message>
        <source>Gearbox designer…</source>
        <translation>Şanzıman tasarımı…</translation>
    </message>
    <message>
        <source>Search for planetary sets, brakes and clutches that have the ratios you want</source>
        <translation>İstediğiniz oranları veren planet dişli takımlarını, frenleri ve kavramaları arar</translation>
    </message>
    <message>
        <source>Fewest teeth of a wheel</source>
        <translation>Bir dişlinin en az dişi</translation>
    </message>
    <message>
        <source>Most teeth of a gear</source>
        <translation>Dıştan dişli bir çarkın en çok dişi</translation>
    </message>
    <message>
        <source>Most teeth of a ring gear</source>
        <translation>Bir çember dişlinin en çok dişi</translation>
    </message>
    <message>
        <source>Equal planets at equal distances that have to go in and to clear each other</source>
        <translation>Eşit aralıklarla takılabilmesi ve birbirine değmemesi gereken eş gezegenler</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>çizildiği gibi</translation>
    </message>
    <message>
        <source>Whole teeth by which the sums of two pairs between the same axes may differ; a profile shift makes up for it</source>
        <translation>Aynı eksenler arasındaki iki çiftin toplamlarının farklı olabileceği tam diş sayısı; profil kaydırma bunu giderir</translation>
    </message>
    <message>
        <source>one for all</source>
        <translation>hepsi için bir</translation>
    </message>
    <message>
        <source>free for each pair</source>
        <translation>her çift için serbest</translation>
    </message>
    <message>
        <source>With one module, pairs between the same two axes have one sum of teeth</source>
        <translation>Tek modülle, aynı iki eksen arasındaki çiftlerin diş toplamı birdir</translation>
    </message>
    <message>
        <source>The only teeth that there are, such as 8 16 24 40; empty: any</source>
        <translation>Var olan tek diş sayıları, örneğin 8 16 24 40; boş: herhangi</translation>
    </message>
    <message>
        <source>any, or only these: 8 16 24 40</source>
        <translation>herhangi ya da yalnız: 8 16 24 40</translation>
    </message>
    <message>
        <source>Efficiency of every mesh; empty: as the document states, if it does</source>
        <translation>Her dişli çiftinin verimi; boş: belge belirtiyorsa belgedeki gibi</translation>
    </message>
    <message>
        <source>The least efficiency that every ratio must have; empty: any</source>
        <translation>Her oranın sahip olması gereken en küçük verim; boş: herhangi</translation>
    </message>
    <message>
        <source>each of these once</source>
        <translation>bunların her biri bir kez</translation>
    </message>
    <message>
        <source>Of the wheels that are listed each is used once at most</source>
        <translation>Sayılan dişlilerin her biri en çok bir kez kullanılır</translation>
    </message>
    <message>
        <source>axes stay where they are</source>
        <translation>eksenler yerinde kalır</translation>
    </message>
    <message>
        <source>Centre distances and modules stay as they are</source>
        <translation>Eksen aralıkları ve modüller olduğu gibi kalır</translation>
    </message>
    <message>
        <source>only with hunting teeth</source>
        <translation>yalnız aralarında asal dişlerle</translation>
    </message>
    <message>
        <source>No two teeth meet again before each has met all others</source>
        <translation>Her diş ötekilerin hepsiyle karşılaşmadan aynı iki diş yeniden karşılaşmaz</translation>
    </message>
    <message>
        <source>no undercut</source>
        <translation>alttan kesme yok</translation>
    </message>
    <message>
        <source>No gear has fewer teeth than a rack cuts without undercut and profile shift</source>
        <translation>Hiçbir dişlinin dişi, kremayerin alttan kesme ve profil kaydırma olmadan kestiğinden az değildir</translation>
    </message>
    <message>
        <source>Rings to</source>
        <translation>Çemberler en çok</translation>
    </message>
    <message>
        <source>Slack</source>
        <translation>Pay</translation>
    </message>
    <message>
        <source>In stock</source>
        <translation>Eldekiler</translation>
    </message>
    <message>
        <source>Least η</source>
        <translation>En az η</translation>
    </message>
    <message>
        <source>%1 turn</source>
        <translation>%1 döner</translation>
    </message>
    <message>
        <source>%1 with planets that clear each other</source>
        <translation>%1 gezegenleri birbirine değmez</translation>
    </message>
    <message>
        <source>%1 with equal planets that go in</source>
        <translation>%1 eş gezegenleri takılabilir</translation>
    </message>
    <message>
        <source>%1 with hunting teeth only</source>
        <translation>%1 yalnız aralarında asal dişlerle</translation>
    </message>
    <message>
        <source>%1 without undercut</source>
        <translation>%1 alttan kesmesiz</translation>
    </message>
    <message>
        <source>%1 within the tolerance</source>
        <translation>%1 tolerans içinde</translation>
    </message>
    <message>
        <source>Draw a train with gear pairs; then say which ratio it should have, and every choice of whole teeth within your limits is tried.</source>
        <translation>Dişli çiftleri olan bir takım çizin; sonra hangi oranı vermesi gerektiğini söyleyin, sınırlarınız içindeki her tam diş seçimi denenir.</translation>
    </message>
    <message>
        <source>The teeth could not be searched: %1</source>
        <translation>Diş sayıları aranamadı: %1</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>Aramanın ne kadarının yapıldığı</translation>
    </message>
    <message>
        <source>u: undercut; a profile shift mends it</source>
        <translation>u: alttan kesme; profil kaydırma giderir</translation>
    </message>
    <message>
        <source>Save certificate…</source>
        <translation>Sertifikayı kaydet…</translation>
    </message>
    <message>
        <source>Copy the table as CSV (Ctrl+C)</source>
        <translation>Tabloyu CSV olarak kopyala (Ctrl+C)</translation>
    </message>
    <message>
        <source>Save the table as CSV</source>
        <translation>Tabloyu CSV olarak kaydet</translation>
    </message>
    <message>
        <source>Use these teeth</source>
        <translation>Bu dişleri kullan</translation>
    </message>
    <message>
        <source>Choices of teeth</source>
        <translation>Diş seçimleri</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>şimdiye dek %1</translation>
    </message>
    <message>
        <source>End the search; what was found stays</source>
        <translation>Aramayı bitir; bulunanlar kalır</translation>
    </message>
    <message>
        <source>The wish cannot be met as it is: see beside its fields.</source>
        <translation>İstek bu haliyle karşılanamaz: alanlarının yanına bakın.</translation>
    </message>
    <message>
        <source>Type the ratio that you want: every choice of whole teeth is tried.</source>
        <translation>İstediğiniz oranı yazın: her tam diş seçimi denenir.</translation>
    </message>
    <message>
        <source>All %1 choices tried: complete</source>
        <translation>%1 seçimin hepsi denendi: eksiksiz</translation>
    </message>
    <message>
        <source>Stopped after %1 choices: not complete</source>
        <translation>%1 seçimden sonra durduruldu: eksik</translation>
    </message>
    <message>
        <source>Search anew</source>
        <translation>Yeniden ara</translation>
    </message>
    <message>
        <source>Search from the beginning</source>
        <translation>Baştan ara</translation>
    </message>
    <message>
        <source>%1 meet the wish</source>
        <translation>%1 isteği karşılar</translation>
    </message>
    <message>
        <source>the best %1 are shown</source>
        <translation>en iyi %1 gösteriliyor</translation>
    </message>
    <message>
        <source>%1, off by %2</source>
        <translation>%1, sapma %2</translation>
    </message>
    <message>
        <source>None. Nearest: %1</source>
        <translation>Yok. En yakını: %1</translation>
    </message>
    <message>
        <source>No choice of teeth is left: the line above says where they end. Wider limits, or more wheels that may change, give more.</source>
        <translation>Hiçbir seçim kalmadı: nerede bittiklerini yukarıdaki satır söyler. Daha geniş sınırlar ya da değişebilecek daha çok dişli daha fazlasını verir.</translation>
    </message>
    <message>
        <source>Nothing was found yet.</source>
        <translation>Henüz bir şey bulunmadı.</translation>
    </message>
    <message>
        <source>Give the train the teeth of the chosen row (Enter); Ctrl+Z undoes it</source>
        <translation>Takıma seçili satırın dişlerini ver (Enter); Ctrl+Z geri alır</translation>
    </message>
    <message>
        <source>Choose a row first</source>
        <translation>Önce bir satır seçin</translation>
    </message>
    <message>
        <source>Save what proves that there are no other choices</source>
        <translation>Başka seçim olmadığını kanıtlayanı kaydet</translation>
    </message>
    <message>
        <source>There is a certificate when all choices have been tried</source>
        <translation>Bütün seçimler denendiğinde sertifika verilir</translation>
    </message>
    <message>
        <source>Choose teeth</source>
        <translation>Diş sayılarını seç</translation>
    </message>
    <message>
        <source>choice %1</source>
        <translation>seçim %1</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>en yakın</translation>
    </message>
    <message>
        <source>Save certificate</source>
        <translation>Sertifikayı kaydet</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON dosyaları (*.json);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Mesh %1: every tooth meets every other</source>
        <translation>Dişli çifti %1: her diş ötekilerin hepsiyle karşılaşır</translation>
    </message>
    <message>
        <source>Mesh %1: a tooth meets one in %2 of the others</source>
        <translation>Dişli çifti %1: bir diş ötekilerin %2 tanede biriyle karşılaşır</translation>
    </message>
    <message>
        <source>%1: a rack undercuts it without a profile shift</source>
        <translation>%1: profil kaydırma olmadan kremayer alttan keser</translation>
    </message>
    <message>
        <source>hunting</source>
        <translation>asal dişler</translation>
    </message>
    <message>
        <source>The best first: the smallest error, then the highest efficiency</source>
        <translation>Önce en iyisi: en küçük hata, sonra en yüksek verim</translation>
    </message>
    <message>
        <source>Teeth of %1</source>
        <translation>%1 dişleri</translation>
    </message>
    <message>
        <source>The ratio, exactly</source>
        <translation>Oran, tam olarak</translation>
    </message>
    <message>
        <source>The ratio, rounded to three decimals</source>
        <translation>Oran, üç basamağa yuvarlanmış</translation>
    </message>
    <message>
        <source>By how much of the wished ratio it is missed; the dot shows where it is within the tolerance</source>
        <translation>İstenen oranın ne kadarıyla sapıldığı; nokta tolerans içindeki yeri gösterir</translation>
    </message>
    <message>
        <source>How many equal planets go in at equal distances and clear each other</source>
        <translation>Eşit aralıklarla, birbirine değmeden kaç eş gezegenin takılabildiği</translation>
    </message>
    <message>
        <source>By pair of wheels: a hunting tooth meets all others before it meets one again</source>
        <translation>Her dişli çifti için: aralarında asal sayılarda bir diş, birine yeniden rastlamadan ötekilerin hepsiyle karşılaşır</translation>
    </message>
    <message>
        <source>Efficiency of the train, of several ratios the smallest</source>
        <translation>Takımın verimi, birkaç oranda en küçüğü</translation>
    </message>
    <message>
        <source>The same with the power the other way; none: it locks itself</source>
        <translation>Güç ters yönde akarken aynısı; yok: kendini kilitler</translation>
    </message>
    <message>
        <source>Teeth for ratios…</source>
        <translation>Oranlar için diş sayıları…</translation>
    </message>
    <message>
        <source>Every choice of whole teeth with which this train has the ratios that you want</source>
        <translation>Bu takımın istediğiniz oranları verdiği her tam diş seçimi</translation>
    </message>
    <message>
        <source>There is no train yet whose teeth could be chosen.</source>
        <translation>Dişleri seçilebilecek bir takım henüz yok.</translation>
    </message>
    <message>
        <source>The teeth hold the answer: they open when the step is right or shown.</source>
        <translation>Dişler cevabı içerir: adım doğru olduğunda ya da gösterildiğinde açılırlar.</translation>
    </message>
    <message>
        <source>Levers</source>
        <translation>Kollar</translation>
    </message>
    <message>
        <source>Each gear set as a lever, its links at their places</source>
        <translation>Her dişli takımı bir kol olarak, uzuvları yerlerinde</translation>
    </message>
    <message>
        <source>Nomogram</source>
        <translation>Nomogram</translation>
    </message>
    <message>
        <source>The states of the gearbox as lines across the speeds of its links</source>
        <translation>Vites kutusunun durumları, uzuvlarının hızları boyunca doğrular olarak</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Düzlem</translation>
    </message>
    <message>
        <source>The plane of the links that is left when the coupling engaged last is let go</source>
        <translation>En son devreye alınan eleman ayrıldığında kalan uzuv düzlemi</translation>
    </message>
    <message>
        <source>Arrows to the right of the bars: how fast each link turns</source>
        <translation>Çubukların sağındaki oklar: her uzvun ne kadar hızlı döndüğü</translation>
    </message>
    <message>
        <source>Arrows to the left of the bars: the torques of the links on the lever, which add up to zero</source>
        <translation>Çubukların solundaki oklar: uzuvların kola uyguladığı, toplamı sıfır olan momentler</translation>
    </message>
    <message>
        <source>With so many inputs no arrow is dragged: set them in Inputs and results</source>
        <translation>Bu kadar çok girişle ok sürüklenmez: girişler Girişler ve sonuçlar panelinde ayarlanır</translation>
    </message>
    <message>
        <source>Input %1: %2 rad/s. Esc puts back</source>
        <translation>Giriş %1: %2 rad/s. Esc geri alır</translation>
    </message>
    <message>
        <source>No input turns this link: there is no speed to set</source>
        <translation>Bu uzvu hiçbir giriş döndürmüyor: ayarlanacak hız yok</translation>
    </message>
    <message>
        <source>Speed of the link, rad/s</source>
        <translation>Uzvun hızı, rad/s</translation>
    </message>
    <message>
        <source>“%1” is no speed: a number, or one with a unit such as 30 rpm</source>
        <translation>“%1” bir hız değil: bir sayı ya da 30 rpm gibi birimli bir sayı</translation>
    </message>
    <message>
        <source>%1 for %2: state %3</source>
        <translation>%2 yerine %1: durum %3</translation>
    </message>
    <message>
        <source>, ratio %1</source>
        <translation>, oran %1</translation>
    </message>
    <message>
        <source>let go of %1: 1 freedom</source>
        <translation>%1 ayrılırsa: 1 serbestlik derecesi</translation>
    </message>
    <message>
        <source>let go of %1: %2 freedoms</source>
        <translation>%1 ayrılırsa: %2 serbestlik derecesi</translation>
    </message>
    <message>
        <source>hold it (B): it does not turn anyway</source>
        <translation>tutulursa (B): zaten dönmüyor</translation>
    </message>
    <message>
        <source>hold it (B): nothing turns any more</source>
        <translation>tutulursa (B): artık hiçbir şey dönmez</translation>
    </message>
    <message>
        <source>hold it (B): 1 freedom</source>
        <translation>tutulursa (B): 1 serbestlik</translation>
    </message>
    <message>
        <source>hold it (B): %1 freedoms</source>
        <translation>tutulursa (B): %1 serbestlik</translation>
    </message>
    <message>
        <source>instead</source>
        <translation>yerine</translation>
    </message>
    <message>
        <source>State %1: nothing engaged</source>
        <translation>Durum %1: hiçbir şey devrede değil</translation>
    </message>
    <message>
        <source>State %1: %2</source>
        <translation>Durum %1: %2</translation>
    </message>
    <message>
        <source>The levers hold the answer: they are shown when the step is right or shown.</source>
        <translation>Kollar yanıtı içeriyor: adım doğru olunca ya da gösterilince görünürler.</translation>
    </message>
    <message>
        <source>The levers are still being laid out. Try again in a moment.</source>
        <translation>Kollar hâlâ yerleştiriliyor. Birazdan yeniden deneyin.</translation>
    </message>
    <message>
        <source>Drag an arrow: the train turns with it. Click a point to select its link, B holds it</source>
        <translation>Bir oku sürükleyin: dişli takımı onunla döner. Bir noktaya tıklamak uzvunu seçer, B onu tutar</translation>
    </message>
    <message>
        <source>Click a line or its tag to engage the state</source>
        <translation>Bir doğruya ya da etiketine tıklamak durumu devreye alır</translation>
    </message>
    <message>
        <source>Engaging a coupling draws the plane together along its dotted line</source>
        <translation>Bir elemanı devreye almak düzlemi onun noktalı çizgisi boyunca bir araya getirir</translation>
    </message>
    <message>
        <source>Gear sets as levers: speeds and torques of the links on the ground&apos;s axis</source>
        <translation>Kol olarak dişli takımları: sabit uzuv ekseni üzerindeki uzuvların hızları ve momentleri</translation>
    </message>
    <message>
        <source>Speeds and torques on levers, the states of a gearbox as a nomogram, and the plane of two freedoms.</source>
        <translation>Kollar üzerinde hızlar ve momentler, nomogram olarak bir vites kutusunun durumları ve iki serbestliğin düzlemi.</translation>
    </message>
    <message>
        <source>Links %1</source>
        <translation>Uzuvlar %1</translation>
    </message>
    <message>
        <source>Link %1 (%2)</source>
        <translation>Uzuv %1 (%2)</translation>
    </message>
    <message>
        <source>%1: held by brake %2</source>
        <translation>%1: %2 freni tutuyor</translation>
    </message>
    <message>
        <source>, as %1 : %2 teeth</source>
        <translation>, %1 : %2 diş gibi</translation>
    </message>
    <message>
        <source>an end of the lever, %1 the other</source>
        <translation>kolun bir ucu, öbür ucu %1</translation>
    </message>
    <message>
        <source>%1 divides %2 to %3 in %4 : %5</source>
        <translation>%1, %2 ile %3 arasını %4 : %5 böler</translation>
    </message>
    <message>
        <source>: %1 of the speed of %2 and %3 of that of %4</source>
        <translation>: %2 hızının %1 kadarı ve %4 hızının %3 kadarı</translation>
    </message>
    <message>
        <source>, by these tooth counts only</source>
        <translation>, yalnızca bu diş sayılarıyla</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>hız</translation>
    </message>
    <message>
        <source>%1 N m on this lever</source>
        <translation>bu kolda %1 N m</translation>
    </message>
    <message>
        <source>, %1 of the way from %2 to %3</source>
        <translation>, %2 ile %3 arasındaki yolun %1 kadarında</translation>
    </message>
    <message>
        <source>, an end of the lever</source>
        <translation>, kolun bir ucu</translation>
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
        <translation>Kol boyunca, sonrakine</translation>
    </message>
    <message>
        <source>%1, of your train</source>
        <translation>%1, sizin dizinizden</translation>
    </message>
    <message>
        <source>%1
axes: %2
gear pairs / carrier: %3</source>
        <translation>%1
eksenler: %2
dişli çiftleri / taşıyıcı: %3</translation>
    </message>
    <message>
        <source>%1 chains</source>
        <translation>%1 zincir</translation>
    </message>
    <message>
        <source>one of %1 links that is not in the atlas</source>
        <translation>atlasta olmayan %1 uzuvlu bir zincir</translation>
    </message>
    <message>
        <source>(cannot turn)</source>
        <translation>(dönemez)</translation>
    </message>
    <message>
        <source>(turns by these tooth counts only)</source>
        <translation>(yalnızca bu diş sayılarıyla döner)</translation>
    </message>
    <message>
        <source>in no gear pair: %1</source>
        <translation>hiçbir dişli çiftinde değil: %1</translation>
    </message>
    <message>
        <source>planets that repeat another: %1</source>
        <translation>bir başkasını yineleyen planetler: %1</translation>
    </message>
    <message>
        <source>brakes and clutches</source>
        <translation>frenler ve kavramalar</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Alınmadı: %1</translation>
    </message>
    <message>
        <source>Your train is unfinished: %1</source>
        <translation>Dişli diziniz tamamlanmamış: %1</translation>
    </message>
    <message>
        <source>Your train has no gear pair yet.</source>
        <translation>Dizinizde henüz dişli çifti yok.</translation>
    </message>
    <message>
        <source>Your train is %1</source>
        <translation>Dişli diziniz: %1</translation>
    </message>
    <message>
        <source>Your train is %1 chains: %2</source>
        <translation>Dişli diziniz %1 zincirden oluşur: %2</translation>
    </message>
    <message>
        <source>Open as document</source>
        <translation>Belge olarak aç</translation>
    </message>
    <message>
        <source>Show in my train</source>
        <translation>Dizimde göster</translation>
    </message>
    <message>
        <source>Copy number</source>
        <translation>Numarayı kopyala</translation>
    </message>
    <message>
        <source>Select the links and gear pairs of your train that are this chain</source>
        <translation>Dizinizin bu zinciri oluşturan uzuvlarını ve dişli çiftlerini seç</translation>
    </message>
    <message>
        <source>Your train is being identified…</source>
        <translation>Dişli diziniz tanınıyor…</translation>
    </message>
    <message>
        <source>It cannot turn: %1 gear pairs are as many conditions for the speeds of %2 links, of which one is held.</source>
        <translation>Dönemez: %1 dişli çifti, biri tutulan %2 uzvun hızları için o kadar koşuldur.</translation>
    </message>
    <message>
        <source>Same equations, other shafts: %1</source>
        <translation>Aynı denklemler, başka miller: %1</translation>
    </message>
    <message>
        <source>One gear pair less: %1</source>
        <translation>Bir dişli çifti eksik: %1</translation>
    </message>
    <message>
        <source>One gear pair more: %1</source>
        <translation>Bir dişli çifti fazla: %1</translation>
    </message>
    <message>
        <source>Digraph of chain %1</source>
        <translation>%1 zincirinin yönlü çizgesi</translation>
    </message>
    <message>
        <source>With the numbers and colours of your links</source>
        <translation>Uzuvlarınızın numaraları ve renkleriyle</translation>
    </message>
    <message>
        <source>Counts for 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301</source>
        <translation>Serbestlik derecesi 1 için sayılar: Yang, Ding ve ark., J. Mech. Des. 141(4), 2019, 043301</translation>
    </message>
    <message>
        <source>A chain is links, axes and gear pairs, each pair with the link that carries both gears. Which link is held, teeth, kinds of gears and the joints by which coaxial links are drawn do not matter. Equations: the triples gear, gear, carrier alone (rotation graphs), which are the equations of the speeds. Chains: with the axes, too (displacement graphs). Left out are chains in which m gear pairs have fewer than m + 2 links between them, so that these turn as one; the smallest of them are the trains that cannot turn.</source>
        <translation>Zincir; uzuvlar, eksenler ve dişli çiftleridir, her çift iki dişliyi taşıyan uzuvla birlikte. Hangi uzvun tutulduğu, dişler, dişli türleri ve eş eksenli uzuvların hangi mafsallarla çizildiği önemli değildir. Denklemler: yalnızca dişli, dişli, taşıyıcı üçlüleri (dönme çizgeleri), yani hızların denklemleri. Zincirler: eksenlerle birlikte (yer değiştirme çizgeleri). m dişli çiftinin aralarında m + 2&apos;den az uzuv olan ve bu yüzden tek parça gibi dönen zincirler alınmamıştır; bunların en küçükleri dönemeyen dizilerdir.</translation>
    </message>
    <message>
        <source>Freedom, one link held</source>
        <translation>Serbestlik, bir uzuv tutulu</translation>
    </message>
    <message>
        <source>No link parts the chain in two, and every link is in a gear pair</source>
        <translation>Hiçbir uzuv zinciri ikiye bölmez ve her uzuv bir dişli çiftindedir</translation>
    </message>
    <message>
        <source>Chains with the same equations of speeds differ in their shafts only</source>
        <translation>Hız denklemleri aynı olan zincirler yalnızca millerinde ayrılır</translation>
    </message>
    <message>
        <source>Trains that cannot turn, and why</source>
        <translation>Dönemeyen diziler ve nedeni</translation>
    </message>
    <message>
        <source>Number, as 6-1.5</source>
        <translation>Numara, örn. 6-1.5</translation>
    </message>
    <message>
        <source>What is counted?</source>
        <translation>Ne sayılıyor?</translation>
    </message>
    <message>
        <source>Chains with 1 freedom</source>
        <translation>Serbestlik derecesi 1 olan zincirler</translation>
    </message>
    <message>
        <source>nonfractionated (%1)</source>
        <translation>bölünemeyen (%1)</translation>
    </message>
    <message>
        <source>equations of %1 only</source>
        <translation>yalnızca %1 denklemleri</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>All geared kinematic chains up to 7 links, and which of them your train is. Arrow keys walk, Enter opens one as a document, / finds a number.</source>
        <translation>7 uzva kadar tüm dişli kinematik zincirler ve dizinizin hangisi olduğu. Ok tuşları gezdirir, Enter belge olarak açar, / numara bulur.</translation>
    </message>
    <message>
        <source>Geared kinematic chains, filtered and counted, and which your train is.</source>
        <translation>Süzülmüş ve sayılmış dişli kinematik zincirler ve dizinizin hangisi olduğu.</translation>
    </message>
    <message>
        <source>Atlas of chains</source>
        <translation>Zincir atlası</translation>
    </message>
    <message>
        <source>All geared kinematic chains up to 7 links, and which of them this train is</source>
        <translation>7 uzva kadar tüm dişli kinematik zincirler ve bu dizinin hangisi olduğu</translation>
    </message>
    <message>
        <source>New document</source>
        <translation>Yeni belge</translation>
    </message>
    <message>
        <source>Chains</source>
        <translation>Zincirler</translation>
    </message>
    <message>
        <source>Number of a chain</source>
        <translation>Bir zincirin numarası</translation>
    </message>
    <message>
        <source>%1 has no meaning without %2.</source>
        <translation>%2 olmadan %1 anlamsızdır.</translation>
    </message>
    <message>
        <source>--limit is a whole number up to %1.</source>
        <translation>--limit en fazla %1 olan bir tam sayıdır.</translation>
    </message>
    <message>
        <source>Whole teeth with which a drawn train has wanted ratios, all of them or the best.</source>
        <translation>Çizilmiş bir dizinin istenen oranları verdiği tam diş sayıları, hepsi ya da en iyileri.</translation>
    </message>
    <message>
        <source>Links %1 turn as one by these tooth counts only.</source>
        <translation>%1 numaralı uzuvlar yalnızca bu diş sayılarıyla tek uzuv gibi döner.</translation>
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
        <source>Both methods worked out step by step for this mechanism.</source>
        <translation>Bu mekanizma için iki yöntem de adım adım.</translation>
    </message>
    <message>
        <source>one let go, one taken per shift</source>
        <translation>her geçişte biri bırakılır, biri tutulur</translation>
    </message>
    <message>
        <source>Masses, the inertia at each motor, and the motion that torques cause.</source>
        <translation>Kütleler, her motordaki atalet ve torkların yol açtığı hareket.</translation>
    </message>
    <message>
        <source>Loads, and the torques, forces and powers that they cause.</source>
        <translation>Yükler ve yol açtıkları torklar, kuvvetler ve güçler.</translation>
    </message>
    <message>
        <source>The speeds of the motors, and how fast every joint turns with them.</source>
        <translation>Motorların hızları ve her mafsalın onlarla ne kadar hızlı döndüğü.</translation>
    </message>
    <message>
        <source>A lesson: what is asked, your answer, hints, and the reason where it is wrong.</source>
        <translation>Bir ders: ne sorulduğu, yanıtınız, ipuçları ve yanlışsa nedeni.</translation>
    </message>
    <message>
        <source>Up and Down, Tab</source>
        <translation>Yukarı ve Aşağı, Tab</translation>
    </message>
    <message>
        <source>Brakes and clutches, what is engaged, and the states of a gearbox.</source>
        <translation>Frenler ve kavramalar, neyin devrede olduğu ve bir şanzımanın durumları.</translation>
    </message>
    <message>
        <source>Every matrix of the Matroid method. Rest the mouse on an entry to have it explained.</source>
        <translation>Matroid yönteminin tüm matrisleri. Açıklaması için fareyi bir öğenin üzerinde tutun.</translation>
    </message>
    <message>
        <source>What is wrong with the mechanism, and how to mend it.</source>
        <translation>Mekanizmada neyin yanlış olduğu ve nasıl düzeltileceği.</translation>
    </message>
    <message>
        <source>Teeth, axes and names of what is selected.</source>
        <translation>Seçili olanın dişleri, eksenleri ve adları.</translation>
    </message>
    <message>
        <source>The mechanism in section, as in textbooks. You can draw here, too.</source>
        <translation>Ders kitaplarındaki gibi kesit olarak mekanizma. Burada da çizilebilir.</translation>
    </message>
    <message>
        <source>Speeds over one period of the motion.</source>
        <translation>Hareketin bir periyodu boyunca hızlar.</translation>
    </message>
    <message>
        <source>The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit.</source>
        <translation>Dişliler hareket halinde. Dişliyi sürüklemek takımı, boş yeri sürüklemek görünümü döndürür.</translation>
    </message>
    <message>
        <source>Fewest brakes</source>
        <translation>En az fren</translation>
    </message>
    <message>
        <source>Most brakes</source>
        <translation>En çok fren</translation>
    </message>
    <message>
        <source>Fewest clutches</source>
        <translation>En az kavrama</translation>
    </message>
    <message>
        <source>Most clutches</source>
        <translation>En çok kavrama</translation>
    </message>
    <message>
        <source>Least ring : sun</source>
        <translation>En küçük çember : güneş</translation>
    </message>
    <message>
        <source>Largest ring : sun</source>
        <translation>En büyük çember : güneş</translation>
    </message>
    <message>
        <source>a folder for the documents of the candidates</source>
        <translation>adayların belgeleri için bir klasör</translation>
    </message>
    <message>
        <source>Hub gear</source>
        <translation>Göbek vitesi</translation>
    </message>
    <message>
        <source>driver</source>
        <translation>sürücü</translation>
    </message>
    <message>
        <source>hub shell</source>
        <translation>göbek gövdesi</translation>
    </message>
    <message>
        <source>shaft %1</source>
        <translation>mil %1</translation>
    </message>
    <message>
        <source>ring %1</source>
        <translation>çember %1</translation>
    </message>
    <message>
        <source>carrier %1</source>
        <translation>taşıyıcı %1</translation>
    </message>
    <message>
        <source>sun %1</source>
        <translation>güneş %1</translation>
    </message>
    <message>
        <source>Found from the ratios of a hub gear. One planet of each set is drawn; numbers of equal planets that go in: %1.</source>
        <translation>Bir göbek vitesinin oranlarından bulundu. Her takımdan bir gezegen çizildi; yerleştirilebilen eş gezegen sayıları: %1.</translation>
    </message>
    <message>
        <source>Gearboxes with the ratios that you want. Space ticks one for comparison, Enter opens it as a document, Esc pauses the search.</source>
        <translation>İstediğiniz oranlara sahip şanzımanlar. Boşluk tuşu karşılaştırma için işaretler, Enter belge olarak açar, Esc aramayı duraklatır.</translation>
    </message>
    <message>
        <source>Ratios to hardware</source>
        <translation>Oranlardan donanıma</translation>
    </message>
    <message>
        <source>What may be inside a hub gear with the ratios of its maker&apos;s sheet, and which wheel to count. Enter opens a candidate as a document.</source>
        <translation>Üretici sayfasındaki oranlara göre göbek vitesinin içinde ne olabilir ve hangi dişli sayılmalı. Enter bir adayı belge olarak açar.</translation>
    </message>
    <message>
        <source>Finds the planetary sets that may be inside a hub gear with given ratios, and what to count in it.</source>
        <translation>Verilen oranlara sahip bir göbek vitesinin içindeki olası planet dişli takımlarını ve nelerin sayılacağını bulur.</translation>
    </message>
    <message>
        <source>Searches for gearboxes with these ratios (Ctrl+Return)</source>
        <translation>Bu oranlara sahip şanzımanları arar (Ctrl+Enter)</translation>
    </message>
    <message>
        <source>Save wish…</source>
        <translation>İsteği kaydet…</translation>
    </message>
    <message>
        <source>Writes the wish as a file for geargraph-cli gearbox, which searches on many machines</source>
        <translation>İsteği, birçok makinede arayan geargraph-cli gearbox için dosya olarak yazar</translation>
    </message>
    <message>
        <source>This variant exceeds a limit of the wish.</source>
        <translation>Bu varyant isteğin bir sınırını aşıyor.</translation>
    </message>
    <message>
        <source>Save wish</source>
        <translation>İsteği kaydet</translation>
    </message>
    <message>
        <source>, about %1 s to go</source>
        <translation>, yaklaşık %1 s kaldı</translation>
    </message>
    <message>
        <source>, about %1 min to go</source>
        <translation>, yaklaşık %1 dk kaldı</translation>
    </message>
    <message>
        <source>None was found: no layout comes near these ratios.&lt;br&gt;More elements, another number of links, another set, or wider limits of ring : sun may help.</source>
        <translation>Bulunamadı: hiçbir düzen bu oranlara yaklaşmıyor.&lt;br&gt;Daha çok eleman, başka sayıda uzuv, başka bir takım veya daha geniş çember : güneş sınırları yardımcı olabilir.</translation>
    </message>
    <message>
        <source>None was found: %1 shift tables come near these ratios, but no whole teeth do.&lt;br&gt;A larger tolerance, or rings with more teeth may help.</source>
        <translation>Bulunamadı: %1 vites tablosu bu oranlara yaklaşıyor, ama tam diş sayıları yaklaşmıyor.&lt;br&gt;Daha büyük bir tolerans veya daha çok dişli çemberler yardımcı olabilir.</translation>
    </message>
    <message>
        <source>None was found: %1 gearboxes have these ratios, but not so many brakes and clutches.</source>
        <translation>Bulunamadı: %1 şanzıman bu oranlara sahip, ama bu sayıda fren ve kavraması yok.</translation>
    </message>
    <message>
        <source>None was found: %1 gearboxes have these ratios, but are beyond the limits at the end of the wish.</source>
        <translation>Bulunamadı: %1 şanzıman bu oranlara sahip, ama isteğin sonundaki sınırların dışında.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Süzgeç</translation>
    </message>
    <message>
        <source>Shows only gearboxes with a property (Ctrl+F); H hides a single one, Ctrl+Z brings it back</source>
        <translation>Yalnızca bir özelliği olan şanzımanları gösterir (Ctrl+F); H tek birini gizler, Ctrl+Z geri getirir</translation>
    </message>
    <message>
        <source>There is nothing in which these gearboxes differ.</source>
        <translation>Bu şanzımanların farklılaştığı bir şey yok.</translation>
    </message>
    <message>
        <source>Hides %1; a click lets go of it</source>
        <translation>%1 tanesini gizler; tıklama kaldırır</translation>
    </message>
    <message>
        <source>hidden: %1</source>
        <translation>gizli: %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 / %2 gösteriliyor</translation>
    </message>
    <message>
        <source>What gearboxes are compared by</source>
        <translation>Şanzımanların karşılaştırma ölçütleri</translation>
    </message>
    <message>
        <source>Brakes and clutches with the same speeds, but other torques and slips</source>
        <translation>Aynı hızları ama başka tork ve kaymaları veren fren ve kavramalar</translation>
    </message>
    <message>
        <source>Schematic of the gearbox</source>
        <translation>Şanzımanın şeması</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3, largest torque %4, largest slip %5</source>
        <translation>%1: %3 yerine %2, en büyük tork %4, en büyük kayma %5</translation>
    </message>
    <message>
        <source>None of them is within the limits of the wish.</source>
        <translation>Hiçbiri isteğin sınırları içinde değil.</translation>
    </message>
    <message>
        <source>error ≤ %1 %</source>
        <translation>hata ≤ %1 %</translation>
    </message>
    <message>
        <source>no circulating power</source>
        <translation>dolaşan güç yok</translation>
    </message>
    <message>
        <source>elements ≤ %1</source>
        <translation>eleman ≤ %1</translation>
    </message>
    <message>
        <source>brakes ≤ %1</source>
        <translation>fren ≤ %1</translation>
    </message>
    <message>
        <source>clutches ≤ %1</source>
        <translation>kavrama ≤ %1</translation>
    </message>
    <message>
        <source>worst η ≥ %1</source>
        <translation>en kötü η ≥ %1</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>en büyük hata</translation>
    </message>
    <message>
        <source>worst efficiency</source>
        <translation>en kötü verim</translation>
    </message>
    <message>
        <source>circulating power</source>
        <translation>dolaşan güç</translation>
    </message>
    <message>
        <source>fastest member</source>
        <translation>en hızlı uzuv</translation>
    </message>
    <message>
        <source>largest torque</source>
        <translation>en büyük tork</translation>
    </message>
    <message>
        <source>largest slip</source>
        <translation>en büyük kayma</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>aralık</translation>
    </message>
    <message>
        <source>largest ring</source>
        <translation>en büyük çember</translation>
    </message>
    <message>
        <source>Tick two to compare them (Space)</source>
        <translation>Karşılaştırmak için ikisini işaretleyin (Boşluk)</translation>
    </message>
    <message>
        <source>A bar a set, its links at their exact places; the filled points are input and output</source>
        <translation>Her takım için bir çubuk, uzuvları tam yerlerinde; dolu noktalar giriş ve çıkıştır</translation>
    </message>
    <message>
        <source>The speed of the fastest link, as a multiple of the input&apos;s</source>
        <translation>En hızlı uzvun hızı, girişin katı olarak</translation>
    </message>
    <message>
        <source>The largest torque in a brake or clutch, as a multiple of the input&apos;s</source>
        <translation>Bir fren veya kavramadaki en büyük tork, girişin katı olarak</translation>
    </message>
    <message>
        <source>levers</source>
        <translation>kaldıraçlar</translation>
    </message>
    <message>
        <source>schematic</source>
        <translation>şema</translation>
    </message>
    <message>
        <source>Schematic of the candidate</source>
        <translation>Adayın şeması</translation>
    </message>
    <message>
        <source>Opens this candidate with a state for each gear, in a new window (Return)</source>
        <translation>Bu adayı her vites için bir durumla yeni pencerede açar (Enter)</translation>
    </message>
    <message>
        <source>What can be counted or measured</source>
        <translation>Sayılabilecek veya ölçülebilecek şeyler</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>başka bir sayı</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Başka bir yanıt</translation>
    </message>
    <message>
        <source>This is it, within your limits.</source>
        <translation>Sınırlarınız içinde, bu odur.</translation>
    </message>
    <message>
        <source>count %1: leaves %2 at most</source>
        <translation>%1 say: en çok %2 kalır</translation>
    </message>
    <message>
        <source>turn %1: leaves %2 at most</source>
        <translation>%1 döndür: en çok %2 kalır</translation>
    </message>
    <message>
        <source>One measurement decides</source>
        <translation>Tek ölçüm karar verir</translation>
    </message>
    <message>
        <source>No single measurement decides</source>
        <translation>Tek bir ölçüm karar vermiyor</translation>
    </message>
    <message>
        <source>Count the teeth of %1. You counted</source>
        <translation>Dişleri sayın: %1. Saydığınız</translation>
    </message>
    <message>
        <source>Turn the input %1 times in %2. The output turned, in degrees,</source>
        <translation>Girişi %1 kez döndürün (%2). Çıkış derece olarak şu kadar döndü:</translation>
    </message>
    <message>
        <source>no such wheel</source>
        <translation>böyle dişli yok</translation>
    </message>
    <message>
        <source>leaves %1</source>
        <translation>%1 kalır</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Aday %1</translation>
    </message>
    <message>
        <source>Choose a candidate of the list.</source>
        <translation>Listeden bir aday seçin.</translation>
    </message>
    <message>
        <source>Wheel over sprocket of each gear as the sheet prints it: typed or pasted</source>
        <translation>Her vites için sayfada yazdığı gibi tekerlek / zincir dişlisi: yazılmış veya yapıştırılmış</translation>
    </message>
    <message>
        <source>0.632 0.741 0.843 …</source>
        <translation>0,632 0,741 0,843 …</translation>
    </message>
    <message>
        <source>that with 1</source>
        <translation>1 olan</translation>
    </message>
    <message>
        <source>The gear that passes the motion through. The others may then be in percent, or metres a turn.</source>
        <translation>Hareketi doğrudan geçiren vites. Diğerleri o zaman yüzde veya tur başına metre olabilir.</translation>
    </message>
    <message>
        <source>direct gear</source>
        <translation>doğrudan vites</translation>
    </message>
    <message>
        <source>rounded as printed</source>
        <translation>yazıldığı gibi yuvarlanmış</translation>
    </message>
    <message>
        <source>tolerance, %</source>
        <translation>tolerans, %</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Bilinenler</translation>
    </message>
    <message>
        <source>Planetary sets in series, at most</source>
        <translation>Seri planet dişli takımları, en çok</translation>
    </message>
    <message>
        <source>sets in series</source>
        <translation>seri takımlar</translation>
    </message>
    <message>
        <source>stepped planets</source>
        <translation>kademeli gezegenler</translation>
    </message>
    <message>
        <source>Planets with several wheels, each with a sun of its own</source>
        <translation>Her biri kendi güneşine sahip birkaç dişlili gezegenler</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>çemberler</translation>
    </message>
    <message>
        <source>Teeth by which the sums of one set may differ, made up by profile shift</source>
        <translation>Bir takımın toplamlarının farklı olabileceği diş sayısı, profil kaydırmayla karşılanır</translation>
    </message>
    <message>
        <source>slack</source>
        <translation>pay</translation>
    </message>
    <message>
        <source>Wheels whose teeth have been counted: set and wheel, then the teeth</source>
        <translation>Dişleri sayılmış dişliler: takım ve dişli, sonra diş sayısı</translation>
    </message>
    <message>
        <source>Counted teeth</source>
        <translation>Sayılan dişler</translation>
    </message>
    <message>
        <source>Products of the ratios of two sets</source>
        <translation>İki takımın oranlarının çarpımları</translation>
    </message>
    <message>
        <source>Rows: ratios of the first set. Columns: of the second. Gears are products of both.</source>
        <translation>Satırlar: birinci takımın oranları. Sütunlar: ikincinin. Vitesler ikisinin çarpımlarıdır.</translation>
    </message>
    <message>
        <source>through</source>
        <translation>doğrudan</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1, kullanılmıyor</translation>
    </message>
    <message>
        <source>planets %1</source>
        <translation>gezegenler %1</translation>
    </message>
    <message>
        <source>No equal planets at equal distances can be assembled.</source>
        <translation>Eşit aralıklı eş gezegenler takılamaz.</translation>
    </message>
    <message>
        <source>A click takes this answer back</source>
        <translation>Tıklama bu yanıtı geri alır</translation>
    </message>
    <message>
        <source>Candidates: %1, of %2 tooth sets with these ratios</source>
        <translation>Adaylar: %1, bu oranlara sahip %2 diş takımından</translation>
    </message>
    <message>
        <source>What is inside a hub with these ratios?</source>
        <translation>Bu oranlara sahip bir göbeğin içinde ne var?</translation>
    </message>
    <message>
        <source>All tooth sets tried: complete. By set: %1.</source>
        <translation>Tüm diş takımları denendi: eksiksiz. Takım başına: %1.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Aranıyor…</translation>
    </message>
    <message>
        <source>Type the ratios of the maker&apos;s sheet and choose Search.&lt;br&gt;A hub with seven gears: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</source>
        <translation>Üretici sayfasındaki oranları yazın ve Ara&apos;yı seçin.&lt;br&gt;Yedi vitesli bir göbek: &lt;a href=&quot;example&quot;&gt;%1&lt;/a&gt;</translation>
    </message>
    <message>
        <source>None has this number: was it counted rightly, or are the limits too narrow?</source>
        <translation>Hiçbirinde bu sayı yok: doğru mu sayıldı, yoksa sınırlar çok mu dar?</translation>
    </message>
    <message>
        <source>None: some ratio is no product of the others. Are all of them rounded to the same place? More sets may explain them.</source>
        <translation>Yok: bir oran diğerlerinin çarpımı değil. Hepsi aynı basamağa mı yuvarlanmış? Daha çok takım açıklayabilir.</translation>
    </message>
    <message>
        <source>the ring of set %1</source>
        <translation>takım %1 çemberi</translation>
    </message>
    <message>
        <source>sun %2 of set %1</source>
        <translation>takım %1 güneş %2</translation>
    </message>
    <message>
        <source>planet step %2 of set %1</source>
        <translation>takım %1 gezegen kademesi %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Ratios to hardware…</source>
        <translation>Oranlardan donanıma…</translation>
    </message>
    <message>
        <source>What may be inside a hub gear with these ratios, and what to count</source>
        <translation>Bu oranlara sahip bir göbek vitesinin içinde ne olabilir ve ne sayılmalı</translation>
    </message>
    <message>
        <source>Closes this tab; what it holds stays</source>
        <translation>Bu sekmeyi kapatır; içindekiler kalır</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>%1 sekmesini kapat</translation>
    </message>
    <message>
        <source>Gearbox from ratios…</source>
        <translation>Oranlardan şanzıman…</translation>
    </message>
    <message>
        <source>This is a document of its own. Save keeps it.</source>
        <translation>Bu ayrı bir belgedir. Kaydet onu saklar.</translation>
    </message>
    <message>
        <source>Ratios with the drawn teeth; * is not the stated one</source>
        <translation>Çizilen diş sayılarıyla oranlar; * belirtilen oran değil</translation>
    </message>
    <message>
        <source>The drawn teeth have all stated ratios.</source>
        <translation>Çizilen diş sayıları belirtilen tüm oranları veriyor.</translation>
    </message>
    <message>
        <source>No teeth near the drawn ones have all stated ratios.</source>
        <translation>Çizilenlere yakın hiçbir diş sayısı belirtilen tüm oranları vermiyor.</translation>
    </message>
    <message>
        <source>instead of the drawn teeth</source>
        <translation>çizilen diş sayıları yerine</translation>
    </message>
    <message>
        <source>Which teeth were meant? Wheels that differ: %1, choices: %2</source>
        <translation>Hangi diş sayıları kastedildi? Farklı dişliler: %1, seçenekler: %2</translation>
    </message>
    <message>
        <source>the ratios are stated ones: which teeth near the drawn ones have them?</source>
        <translation>oranlar belirtilmiş olanlardır: çizilenlere yakın hangi diş sayıları bunları verir?</translation>
    </message>
    <message>
        <source>with --meant: wheels that may differ, at most (3)</source>
        <translation>--meant ile: farklı olabilecek dişliler, en çok (3)</translation>
    </message>
    <message>
        <source>with --meant: teeth by which a wheel may differ (5)</source>
        <translation>--meant ile: bir dişlinin farklı olabileceği diş sayısı (5)</translation>
    </message>
    <message>
        <source>Fewest teeth: %1</source>
        <translation>En az diş: %1</translation>
    </message>
    <message>
        <source>Most teeth: %1</source>
        <translation>En çok diş: %1</translation>
    </message>
    <message>
        <source>Lever diagram of the gearbox</source>
        <translation>Şanzımanın kaldıraç diyagramı</translation>
    </message>
    <message>
        <source>sun %1.%2</source>
        <translation>güneş %1.%2</translation>
    </message>
    <message>
        <source>None: no whole teeth within the limits have these ratios. A slack of 1 to 3, or wider limits, may help.</source>
        <translation>Yok: sınırlar içinde bu oranlara sahip tam diş sayısı yok. 1 ile 3 arası bir pay veya daha geniş sınırlar yardımcı olabilir.</translation>
    </message>
    <message>
        <source>ratio %1 (%2)</source>
        <translation>oran %1 (%2)</translation>
    </message>
    <message>
        <source>No choice within the limits has %1.</source>
        <translation>Sınırlar içinde hiçbir seçimde %1 yok.</translation>
    </message>
    <message>
        <source>No choice within the limits has both %1 and %2.</source>
        <translation>Sınırlar içinde hiçbir seçimde %1 ile %2 birlikte yok.</translation>
    </message>
    <message>
        <source>Levers. Points: links of a gear set at exact distances; arrows: their speeds.</source>
        <translation>Kaldıraçlar. Noktalar: bir dişli setinin uzuvları, tam aralıklarla; oklar: hızları.</translation>
    </message>
    <message>
        <source>Nomogram. A line for each state through the speeds of the links, the drive being 1.</source>
        <translation>Nomogram. Her durum için uzuvların hızlarından geçen bir çizgi; tahrik 1’dir.</translation>
    </message>
    <message>
        <source>%1 is engaged: the plane projected along its line</source>
        <translation>%1 devrede: düzlem onun çizgisi boyunca izdüşürüldü</translation>
    </message>
    <message>
        <source>peripheral velocity in %1/s</source>
        <translation>çevresel hız, %1/s</translation>
    </message>
    <message>
        <source>A line for each link; its slope is the speed in rad/s. Filled points: teeth; others: carried axes.</source>
        <translation>Her uzuv için bir çizgi; eğimi rad/s cinsinden hızıdır. Dolu noktalar: dişler; diğerleri: taşınan eksenler.</translation>
    </message>
    <message>
        <source>Mesh %1 joins axes that are not in one plane with that of their carrier: its lines do not meet.</source>
        <translation>%1 çifti, taşıyıcısının ekseniyle aynı düzlemde olmayan eksenleri bağlar: çizgileri kesişmez.</translation>
    </message>
    <message>
        <source>Meshes %1 join axes that are not in one plane with that of their carrier: their lines do not meet.</source>
        <translation>%1 çiftleri, taşıyıcılarının ekseniyle aynı düzlemde olmayan eksenleri bağlar: çizgileri kesişmez.</translation>
    </message>
    <message>
        <source>The section is unrolled in another way: not all teeth are at the heights of the plan.</source>
        <translation>Kesit başka biçimde açılmıştır: dişlerin hepsi plandaki yükseklikte değildir.</translation>
    </message>
    <message>
        <source>No speed plan: the train is not finished, see Problems.</source>
        <translation>Hız planı yok: takım bitmemiş, bkz. Sorunlar.</translation>
    </message>
    <message>
        <source>No speed plan: the speeds are not determined, see Problems.</source>
        <translation>Hız planı yok: hızlar belirli değil, bkz. Sorunlar.</translation>
    </message>
    <message>
        <source>No speed plan: it needs axes that are all parallel.</source>
        <translation>Hız planı yok: bütün eksenlerin paralel olması gerekir.</translation>
    </message>
    <message>
        <source>Each gear set is a lever: its links on the ground&apos;s axis are points with exact places, 0 at one end and 1 at the other. In every motion the speed of a link is an affine function of its place, $\omega(x) = \omega(0) + x\,(\omega(1) - \omega(0))$.</source>
        <translation>Her dişli seti bir kaldıraçtır: sabit uzvun eksenindeki uzuvları, bir uçta 0, öbür uçta 1 olan tam yerlerdeki noktalardır. Her harekette bir uzvun hızı, yerinin afin bir fonksiyonudur: $\omega(x) = \omega(0) + x\,(\omega(1) - \omega(0))$.</translation>
    </message>
    <message>
        <source>Nomogram of the states, the speed of the drive being 1</source>
        <translation>Durumların nomogramı; tahrikin hızı 1’dir</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Yer</translation>
    </message>
    <message>
        <source>Speed in rad/s</source>
        <translation>Hız, rad/s</translation>
    </message>
    <message>
        <source>Lever of %1, %2 teeth:</source>
        <translation>%1 için kaldıraç, %2 diş:</translation>
    </message>
    <message>
        <source>These links are on one lever by these tooth counts only.</source>
        <translation>Bu uzuvlar yalnızca bu diş sayılarıyla bir kaldıraç üzerindedir.</translation>
    </message>
    <message>
        <source>A view is digraph, tt-graph, schematic, levers or nomogram.</source>
        <translation>Bir görünüm digraph, tt-graph, schematic, levers veya nomogram olur.</translation>
    </message>
    <message>
        <source>Link &quot;%1&quot; is on no lever.</source>
        <translation>“%1” uzvu hiçbir kaldıraçta değil.</translation>
    </message>
    <message>
        <source>Speed plan</source>
        <translation>Hız planı</translation>
    </message>
    <message>
        <source>Kutzbach&apos;s plan beside the section: peripheral velocities over the radius, a line for each link</source>
        <translation>Kesitin yanında Kutzbach planı: yarıçapa göre çevresel hızlar, her uzuv için bir çizgi</translation>
    </message>
    <message>
        <source>Click the point to lock link %1 with. Esc ends</source>
        <translation>%1 uzvunun kilitleneceği noktayı tıklayın. Esc bitirir</translation>
    </message>
    <message>
        <source>Each line is a link: its slope is the speed, lines cross at the teeth</source>
        <translation>Her çizgi bir uzuvdur: eğimi hızıdır, çizgiler dişlerde kesişir</translation>
    </message>
    <message>
        <source>Lock with…</source>
        <translation>Kilitle…</translation>
    </message>
    <message>
        <source>A clutch to the link that you click next</source>
        <translation>Sonra tıkladığınız uzva bir kavrama</translation>
    </message>
    <message>
        <source>Let go (B)</source>
        <translation>Bırak (B)</translation>
    </message>
    <message>
        <source>Hold (B)</source>
        <translation>Tut (B)</translation>
    </message>
    <message>
        <source>Release the brake of this link</source>
        <translation>Bu uzvun frenini bırak</translation>
    </message>
    <message>
        <source>Engage the brake of this link, a new one where it has none</source>
        <translation>Bu uzvun frenini devreye al, yoksa yenisini ekle</translation>
    </message>
    <message>
        <source>The speeds of these joints do not determine those of the motors.</source>
        <translation>Bu eklemlerin hızları motorların hızlarını belirlemiyor.</translation>
    </message>
    <message>
        <source>There are %1 motors: name as many joints, not %2.</source>
        <translation>%1 motor var: %2 değil, bir o kadar eklem adı verin.</translation>
    </message>
    <message>
        <source>The joints are %1: --outputs names others.</source>
        <translation>Eklemler %1: --outputs başkalarını belirtir.</translation>
    </message>
    <message>
        <source>the coupling of motors and joints</source>
        <translation>motorlarla eklemlerin bağlaşımı</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (JSON)</source>
        <translation>Motorlarla eklemlerin bağlaşımı (JSON)</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (C++)</source>
        <translation>Motorlarla eklemlerin bağlaşımı (C++)</translation>
    </message>
    <message>
        <source>Coupling of motors and joints (Python)</source>
        <translation>Motorlarla eklemlerin bağlaşımı (Python)</translation>
    </message>
    <message>
        <source>Transmissions of ros2_control (XML)</source>
        <translation>ros2_control aktarmaları (XML)</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>Denetleyiciler</translation>
    </message>
    <message>
        <source>the joints that the motors drive, by label, as many as motors (the chain from the ground to a link that they determine)</source>
        <translation>motorların sürdüğü eklemler, etiketleriyle, motor sayısı kadar (gövdeden, belirledikleri bir uzva giden zincir)</translation>
    </message>
    <message>
        <source>json (the default), header (C++17), python, or ros2 (transmissions of ros2_control); each of header and python tests itself</source>
        <translation>json (varsayılan), header (C++17), python ya da ros2 (ros2_control aktarmaları); header ve python kendilerini sınar</translation>
    </message>
    <message>
        <source>Written as</source>
        <translation>Yazılış biçimi</translation>
    </message>
    <message>
        <source>In the gearbox designer: search</source>
        <translation>Dişli kutusu tasarımında: ara</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>forms: html,latex,pdf,json,handout,scorm (html,latex,pdf)</source>
        <translation>biçimler: html,latex,pdf,json,handout,scorm (html,latex,pdf)</translation>
    </message>
    <message>
        <source>which mistake, how often, by whom: a .csv or a page with bars (.html)</source>
        <translation>hangi hata, kaç kez, kimden: bir .csv ya da çubuklu bir sayfa (.html)</translation>
    </message>
    <message>
        <source>--summary is a file that ends in .csv or .html.</source>
        <translation>--summary, .csv ya da .html ile biten bir dosyadır.</translation>
    </message>
    <message>
        <source>--to lists forms out of html, latex, pdf, json, handout and scorm, not &quot;%1&quot;.</source>
        <translation>--to; html, latex, pdf, json, handout ve scorm biçimlerini sıralar, &quot;%1&quot; bunlardan değil.</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Seçenek</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Öğrenci</translation>
    </message>
    <message>
        <source>File for answers</source>
        <translation>Yanıt dosyası</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>yanıtlanmamış</translation>
    </message>
    <message>
        <source>wrong, by no known mistake</source>
        <translation>yanlış, bilinen bir hata değil</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>okunamıyor</translation>
    </message>
    <message>
        <source>Question %1: %2</source>
        <translation>Soru %1: %2</translation>
    </message>
    <message>
        <source>Handout</source>
        <translation>Ders notu</translation>
    </message>
    <message>
        <source>SCORM package</source>
        <translation>SCORM paketi</translation>
    </message>
    <message>
        <source>A page for each variant, with the train in 3D, that grades what is filled in</source>
        <translation>Her seçenek için, dişli takımını 3B gösteren ve yazılanı değerlendiren bir sayfa</translation>
    </message>
    <message>
        <source>That page for each variant as a package for learning platforms</source>
        <translation>Her seçenek için o sayfa, öğrenme ortamları için paket olarak</translation>
    </message>
    <message>
        <source>right-hand</source>
        <translation>sağ</translation>
    </message>
    <message>
        <source>left-hand</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>&quot;right&quot; or &quot;left&quot;</source>
        <translation>&quot;right&quot; ya da &quot;left&quot;</translation>
    </message>
    <message>
        <source>right, left or nothing</source>
        <translation>right, left ya da hiçbir şey</translation>
    </message>
    <message>
        <source>The helix angle of a gear mesh is at least 0 and below 90 degrees.</source>
        <translation>Bir diş kavramasının helis açısı en az 0 ve 90 dereceden küçüktür.</translation>
    </message>
    <message>
        <source>The module of a gear mesh is above 0.</source>
        <translation>Bir diş kavramasının modülü 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>The pressure angle of a gear mesh is above 0 and below 90 degrees.</source>
        <translation>Bir diş kavramasının kavrama açısı 0&apos;dan büyük ve 90 dereceden küçüktür.</translation>
    </message>
    <message>
        <source>its module %1 makes a centre distance of %2, and the axes are %3 apart: profile shifts make up for two modules at most. What fits: the module %4.</source>
        <translation>modülü %1, eksenler arası uzaklığı %2 yapar, eksenler ise %3 aralıklıdır: profil kaydırmaları en çok iki modülü giderir. Uygun olan: %4 modülü.</translation>
    </message>
    <message>
        <source>Meshes %1 and %2 give the teeth of gear %3 different helix angles or hands. What fits: one helix for both (a wheel and the ring round it have the same hand, two wheels beside each other opposite ones), or two wheels with names of their own.</source>
        <translation>%1 ve %2 kavramaları %3 dişlisinin dişlerine farklı helis açıları ya da yönleri veriyor. Uygun olan: ikisi için tek helis (bir çarkla çevresindeki halkanın yönü aynı, yan yana iki çarkınki zıttır) ya da kendi adları olan iki çark.</translation>
    </message>
    <message>
        <source>Meshes %1 and %2 give gear %3 different modules. What fits: one module for both, or two wheels with names of their own.</source>
        <translation>%1 ve %2 kavramaları %3 dişlisine farklı modüller veriyor. Uygun olan: ikisi için tek modül ya da kendi adları olan iki çark.</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>kayış</translation>
    </message>
    <message>
        <source>pins</source>
        <translation>pimler</translation>
    </message>
    <message>
        <source>Make %1 a belt</source>
        <translation>%1 bağlantısını kayış yap</translation>
    </message>
    <message>
        <source>Make %1 a pair of pins and holes</source>
        <translation>%1 bağlantısını pim ve delik çifti yap</translation>
    </message>
    <message>
        <source>freewheel %1</source>
        <translation>tek yönlü kavrama %1</translation>
    </message>
    <message>
        <source>&quot;brake&quot;, &quot;clutch&quot; or &quot;freewheel&quot;</source>
        <translation>&quot;brake&quot;, &quot;clutch&quot; ya da &quot;freewheel&quot;</translation>
    </message>
    <message>
        <source>Only a belt is crossed, or has a pitch or running diameters; mesh &quot;%1&quot; is none.</source>
        <translation>Yalnızca bir kayış çapraz olabilir ya da adımı veya çalışma çapları olabilir; &quot;%1&quot; bağlantısı kayış değil.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; has no teeth that slide: state its `efficiency`, not a `friction`.</source>
        <translation>&quot;%1&quot; bağlantısında kayan diş yok: `friction` değil `efficiency` verin.</translation>
    </message>
    <message>
        <source>Mesh &quot;%1&quot; is a belt or pins, which have no pitch point: leave it out.</source>
        <translation>&quot;%1&quot; bağlantısı kayış ya da pim; bunların yuvarlanma noktası yoktur: yazmayın.</translation>
    </message>
    <message>
        <source>Pitch and running diameters of belt &quot;%1&quot; are above 0.</source>
        <translation>&quot;%1&quot; kayışının adımı ve çalışma çapları 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>Belt &quot;%1&quot; has teeth at both ends, or running diameters at both.</source>
        <translation>&quot;%1&quot; kayışının iki ucunda da diş ya da iki ucunda da çalışma çapı olur.</translation>
    </message>
    <message>
        <source>The running diameters of belt &quot;%1&quot; are in the ratio of two whole numbers up to 100,000: give them with fewer digits.</source>
        <translation>&quot;%1&quot; kayışının çalışma çapları, 100.000&apos;e kadar iki tam sayının oranındadır: daha az basamakla verin.</translation>
    </message>
    <message>
        <source>Pins turn 1 : 1 and belts with running diameters in their ratio; mesh &quot;%1&quot; states other teeth: leave them out.</source>
        <translation>Pimler 1 : 1, çalışma çaplı kayışlar bu çapların oranında döner; &quot;%1&quot; bağlantısı başka diş sayıları veriyor: yazmayın.</translation>
    </message>
    <message>
        <source>A freewheel names two links.</source>
        <translation>Tek yönlü kavrama iki uzuv adlandırır.</translation>
    </message>
    <message>
        <source>Freewheel &quot;%1&quot; ties link &quot;%2&quot; to itself.</source>
        <translation>&quot;%1&quot; tek yönlü kavraması &quot;%2&quot; uzvunu kendisine bağlıyor.</translation>
    </message>
    <message>
        <source>State &quot;%1&quot; engages freewheel &quot;%2&quot;, which locks by itself: leave it out.</source>
        <translation>&quot;%1&quot; durumu, kendiliğinden kilitlenen &quot;%2&quot; tek yönlü kavramasını devreye alıyor: yazmayın.</translation>
    </message>
    <message>
        <source>The direction of a state is 1 or -1.</source>
        <translation>Bir durumun yönü 1 ya da -1&apos;dir.</translation>
    </message>
    <message>
        <source>A freewheel needs two different links.</source>
        <translation>Tek yönlü kavrama iki farklı uzuv ister.</translation>
    </message>
    <message>
        <source>A belt and pins have no module: state a pitch or running diameters.</source>
        <translation>Kayışın ve pimlerin modülü yoktur: adım ya da çalışma çapları verin.</translation>
    </message>
    <message>
        <source>it says %1, but its axes are skew. What fits: parallel axes.</source>
        <translation>%1 diyor, ama eksenleri aykırı. Uyan: paralel eksenler.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet. What fits: bevel, or parallel axes.</source>
        <translation>%1 diyor, ama eksenleri kesişiyor. Uyan: konik ya da paralel eksenler.</translation>
    </message>
    <message>
        <source>its pulleys overlap: the running radii %1 and %2 need more than the %3 between the axes. What fits: smaller ones, or axes farther apart.</source>
        <translation>kasnakları çakışıyor: %1 ve %2 çalışma yarıçapları, eksenler arasındaki %3 mesafeden fazlasını ister. Uyan: daha küçükleri ya da daha uzak eksenler.</translation>
    </message>
    <message>
        <source>State %1: more than one pattern of locked and free freewheels is possible; shown is the one with these locked: %2.</source>
        <translation>Durum %1: kilitli ve serbest tek yönlü kavramaların birden çok düzeni mümkün; gösterilende kilitli olanlar: %2.</translation>
    </message>
    <message>
        <source>State %1: the drive overruns its freewheels and drives nothing this way (locked they would turn as shown: %2). Exchange the two links of one, or turn the drive the other way.</source>
        <translation>Durum %1: giriş tek yönlü kavramalarını aşıyor ve bu yönde hiçbir şeyi sürmüyor (kilitliyken gösterildiği gibi dönerlerdi: %2). Birinin iki uzvunu değiştirin ya da girişi ters yöne döndürün.</translation>
    </message>
    <message>
        <source>Freewheel %1 locks before link %2 turns faster than link %3, but the given speeds make it faster by %4 rad/s. Engage it, exchange its links, or turn the inputs the other way.</source>
        <translation>%1 tek yönlü kavraması, %2 uzvu %3 uzvundan hızlı dönmeden kilitlenir; oysa verilen hızlar onu %4 rad/s daha hızlı yapıyor. Devreye alın, uzuvlarını değiştirin ya da girişleri ters yöne döndürün.</translation>
    </message>
    <message>
        <source>The torque that the freewheel exerts on the first of its links while it is locked; the second one has the reaction.</source>
        <translation>Kilitliyken tek yönlü kavramanın ilk uzvuna uyguladığı moment; tepki ikincidedir.</translation>
    </message>
    <message>
        <source>Freewheel %1</source>
        <translation>Tek yönlü kavrama %1</translation>
    </message>
    <message>
        <source>It locks where its first link would turn faster than its second.</source>
        <translation>İlk uzvu ikincisinden hızlı döneceği yerde kilitlenir.</translation>
    </message>
    <message>
        <source>Mesh %1 is a belt: its pulleys turn the same way, seen from their carrier, and against each other where it is crossed.</source>
        <translation>%1 bağlantısı bir kayış: kasnakları, kollarından bakıldığında, aynı yönde döner; çaprazsa ters yönlerde.</translation>
    </message>
    <message>
        <source>Mesh %1 is a belt: its pulleys turn the same way, seen from the carrier, and opposite ways where it is crossed.</source>
        <translation>%1 bağlantısı bir kayış: kasnakları, koldan bakıldığında, aynı yönde, çaprazsa zıt yönlerde döner.</translation>
    </message>
    <message>
        <source>Mesh %1 is an open belt: seen from the carrier, its pulleys turn the same way, so that f is %2.</source>
        <translation>%1 bağlantısı açık bir kayış: koldan bakıldığında kasnakları aynı yönde döner, bu yüzden f %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is a crossed belt: seen from the carrier, its pulleys turn against each other, so that f is %2.</source>
        <translation>%1 bağlantısı çapraz bir kayış: koldan bakıldığında kasnakları ters yönlerde döner, bu yüzden f %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: seen from the carrier, both links turn alike, so that f is %2.</source>
        <translation>%1 bağlantısı deliklerde pimler: koldan bakıldığında iki uzuv da aynı döner, bu yüzden f %2.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: both links turn alike, seen from their carrier.</source>
        <translation>%1 bağlantısı deliklerde pimler: kollarından bakıldığında iki uzuv da aynı döner.</translation>
    </message>
    <message>
        <source>Mesh %1 is pins in holes: both links turn alike, seen from the carrier.</source>
        <translation>%1 bağlantısı deliklerde pimler: koldan bakıldığında iki uzuv da aynı döner.</translation>
    </message>
    <message>
        <source>%1 past link %2</source>
        <translation>%1, uzuv %2 önünden</translation>
    </message>
    <message>
        <source>--input is the label of a joint or of a moving link, not &quot;%1&quot;.</source>
        <translation>--input bir mafsalın veya hareketli bir uzvun numarasıdır, &quot;%1&quot; değil.</translation>
    </message>
    <message>
        <source>--rpm is above 0.</source>
        <translation>--rpm 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>At the given speed of the input shaft.</source>
        <translation>Giriş milinin verilen hızında.</translation>
    </message>
    <message>
        <source>Cycles for a turn of the input shaft, exactly.</source>
        <translation>Giriş milinin bir turu başına çevrim, tam olarak.</translation>
    </message>
    <message>
        <source>From stop to stop at the output, every mesh at its worst.</source>
        <translation>Çıkışta dayanaktan dayanağa, her eş çalışma en kötü durumda.</translation>
    </message>
    <message>
        <source>Give --json or --csv.</source>
        <translation>--json veya --csv verin.</translation>
    </message>
    <message>
        <source>Height and dashes tell what repeats, not how strongly.</source>
        <translation>Yükseklik ve çizgi türü neyin tekrarlandığını gösterir, ne kadar güçlü olduğunu değil.</translation>
    </message>
    <message>
        <source>How far outputs turn while inputs are held, by the play of the teeth.</source>
        <translation>Girişler tutulurken çıkışların diş boşluğu nedeniyle ne kadar döndüğü.</translation>
    </message>
    <message>
        <source>How far the input turns from stop to stop while the output is held.</source>
        <translation>Çıkış tutulurken girişin dayanaktan dayanağa ne kadar döndüğü.</translation>
    </message>
    <message>
        <source>How often the modulating frequency is added to the harmonic, or taken from it.</source>
        <translation>Modüle eden frekansın harmoniğe kaç kez eklendiği ya da ondan çıkarıldığı.</translation>
    </message>
    <message>
        <source>Meshes that follow from others share their play; the tightest decides.</source>
        <translation>Diğerlerinden çıkan eş çalışmalar boşluklarını paylaşır; en dar olan belirler.</translation>
    </message>
    <message>
        <source>No input turns, so there are no frequencies.</source>
        <translation>Hiçbir giriş dönmüyor, bu yüzden frekans yok.</translation>
    </message>
    <message>
        <source>No joint follows an input.</source>
        <translation>Hiçbir mafsal bir girişi izlemiyor.</translation>
    </message>
    <message>
        <source>No lost motion is known: the train has no solution, or is too large.</source>
        <translation>Kayıp hareket bilinmiyor: düzeneğin çözümü yok ya da çok büyük.</translation>
    </message>
    <message>
        <source>No motion is known, so there are no frequencies.</source>
        <translation>Hareket bilinmiyor, bu yüzden frekans yok.</translation>
    </message>
    <message>
        <source>The frequencies of shafts, tooth meshes and planets, as ratios to the input shaft.</source>
        <translation>Millerin, diş kavramalarının ve gezegenlerin frekansları, giriş miline oran olarak.</translation>
    </message>
    <message>
        <source>The input that it is carried back to, by label.</source>
        <translation>Geri taşındığı giriş, numarasıyla.</translation>
    </message>
    <message>
        <source>The joint that turns while the inputs are held, by label.</source>
        <translation>Girişler tutulurken dönen mafsal, numarasıyla.</translation>
    </message>
    <message>
        <source>The mesh that contributes most, by label.</source>
        <translation>En çok katkıda bulunan eş çalışma, numarasıyla.</translation>
    </message>
    <message>
        <source>The multiple of the tooth mesh.</source>
        <translation>Diş kavrama frekansının katı.</translation>
    </message>
    <message>
        <source>The root of the sum of squares of the parts of all meshes.</source>
        <translation>Tüm eş çalışmaların paylarının kareleri toplamının karekökü.</translation>
    </message>
    <message>
        <source>The same in minutes of arc.</source>
        <translation>Aynısı yay dakikası olarak.</translation>
    </message>
    <message>
        <source>The shaft does not turn (%1).</source>
        <translation>Mil dönmüyor (%1).</translation>
    </message>
    <message>
        <source>The shaft has no speed of its own about one axis (%1).</source>
        <translation>Milin tek bir eksen etrafında belirli bir hızı yok (%1).</translation>
    </message>
    <message>
        <source>The state whose couplings are engaged.</source>
        <translation>Kavramaları devrede olan durum.</translation>
    </message>
    <message>
        <source>What is lost of the worst case if that mesh has no play.</source>
        <translation>O eş çalışmada boşluk olmasaydı en kötü durumdan eksilecek olan.</translation>
    </message>
    <message>
        <source>What repeats.</source>
        <translation>Neyin tekrarlandığı.</translation>
    </message>
    <message>
        <source>Where it repeats, by label.</source>
        <translation>Nerede tekrarlandığı, numarasıyla.</translation>
    </message>
    <message>
        <source>as CSV</source>
        <translation>CSV olarak</translation>
    </message>
    <message>
        <source>assembly phase</source>
        <translation>montaj fazı</translation>
    </message>
    <message>
        <source>at the input</source>
        <translation>girişte</translation>
    </message>
    <message>
        <source>Dashed: what either motor may do alone, for some angle of the other.</source>
        <translation>Kesikli: diğerinin bir açısı için her motorun tek başına yapabildiği.</translation>
    </message>
    <message>
        <source>Degrees from the reference pose; all other motors stand in it.</source>
        <translation>Referans konumundan derece; diğer tüm motorlar bu konumdadır.</translation>
    </message>
    <message>
        <source>Dotted sides are open: nothing limits the motors there.</source>
        <translation>Noktalı kenarlar açıktır: orada motorları sınırlayan bir şey yoktur.</translation>
    </message>
    <message>
        <source>Limits that these motors never reach: those of joints %1.</source>
        <translation>Bu motorların hiç ulaşmadığı sınırlar: %1 numaralı mafsallarınkiler.</translation>
    </message>
    <message>
        <source>No joint that turns with these motors has limits.</source>
        <translation>Bu motorlarla dönen hiçbir mafsalın sınırı yok.</translation>
    </message>
    <message>
        <source>Nothing moves that limits could stop.</source>
        <translation>Sınırların durdurabileceği hiçbir şey hareket etmiyor.</translation>
    </message>
    <message>
        <source>The mechanism is too large for exact limits.</source>
        <translation>Mekanizma kesin sınırlar için çok büyük.</translation>
    </message>
    <message>
        <source>There are not two motors.</source>
        <translation>İki motor yok.</translation>
    </message>
    <message>
        <source>joint %1 at %2</source>
        <translation>%1 mafsalı %2 değerinde</translation>
    </message>
    <message>
        <source>motor %1, degrees</source>
        <translation>motor %1, derece</translation>
    </message>
    <message>
        <source>cycles for a turn of the shaft (%1)</source>
        <translation>milin bir turu başına çevrim (%1)</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>frekans</translation>
    </message>
    <message>
        <source>harmonic</source>
        <translation>harmonik</translation>
    </message>
    <message>
        <source>how many planets one stands for that is drawn alone (1)</source>
        <translation>tek çizilen bir gezegenin kaç gezegen yerine geçtiği (1)</translation>
    </message>
    <message>
        <source>hunting tooth</source>
        <translation>av dişi</translation>
    </message>
    <message>
        <source>input shaft: joint %1</source>
        <translation>giriş mili: mafsal %1</translation>
    </message>
    <message>
        <source>input shaft: link %1</source>
        <translation>giriş mili: uzuv %1</translation>
    </message>
    <message>
        <source>its part</source>
        <translation>payı</translation>
    </message>
    <message>
        <source>likely</source>
        <translation>olası</translation>
    </message>
    <message>
        <source>mesh %1, %2 planets past link %3</source>
        <translation>eş çalışma %1, %2 gezegen uzuv %3 önünden</translation>
    </message>
    <message>
        <source>mesh %1, turns of link %2</source>
        <translation>eş çalışma %1, uzuv %2 dönüşleri</translation>
    </message>
    <message>
        <source>multiples of each tooth mesh (1)</source>
        <translation>her diş kavramasının katları (1)</translation>
    </message>
    <message>
        <source>of</source>
        <translation>nerede</translation>
    </message>
    <message>
        <source>on each side of each multiple (1)</source>
        <translation>her katın her yanında (1)</translation>
    </message>
    <message>
        <source>orders</source>
        <translation>mertebe</translation>
    </message>
    <message>
        <source>planets pass</source>
        <translation>gezegen geçişi</translation>
    </message>
    <message>
        <source>shaft</source>
        <translation>mil</translation>
    </message>
    <message>
        <source>sideband</source>
        <translation>yan bant</translation>
    </message>
    <message>
        <source>the frequencies</source>
        <translation>frekanslar</translation>
    </message>
    <message>
        <source>the joint or link (by label) that ratios are of, instead of the first input or the state&apos;s drive</source>
        <translation>oranların alındığı mafsal veya uzuv (numarasıyla), ilk giriş veya durumun sürücüsü yerine</translation>
    </message>
    <message>
        <source>the lost motion</source>
        <translation>kayıp hareket</translation>
    </message>
    <message>
        <source>the speed of the input shaft: frequencies also in Hz</source>
        <translation>giriş milinin hızı: frekanslar Hz olarak da</translation>
    </message>
    <message>
        <source>tooth mesh</source>
        <translation>diş kavraması</translation>
    </message>
    <message>
        <source>turns on its bearer</source>
        <translation>taşıyıcısı üzerinde dönüş</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>en kötü</translation>
    </message>
    <message>
        <source>A wheel without teeth in one plane has no profile.</source>
        <translation>Dişleri tek düzlemde olmayan bir çarkın profili yoktur.</translation>
    </message>
    <message>
        <source>Left out, as they have no teeth in one plane: %1.</source>
        <translation>Dişleri tek düzlemde olmadığı için dışarıda bırakılanlar: %1.</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>profiller</translation>
    </message>
    <message>
        <source>Profiles of wheels (DXF)</source>
        <translation>Çark profilleri (DXF)</translation>
    </message>
    <message>
        <source>profiles of wheels</source>
        <translation>çark profilleri</translation>
    </message>
    <message>
        <source>Cutting profiles</source>
        <translation>Kesim profilleri</translation>
    </message>
    <message>
        <source>The program geargraph-step, which writes STEP files, is not installed; it is in the package of that name.</source>
        <translation>STEP dosyalarını yazan geargraph-step programı kurulu değil; aynı adlı pakettedir.</translation>
    </message>
    <message>
        <source>OpenCASCADE could not make the solids or write the file.</source>
        <translation>OpenCASCADE katıları oluşturamadı ya da dosyayı yazamadı.</translation>
    </message>
    <message>
        <source>There are no solids to write.</source>
        <translation>Yazılacak katı yok.</translation>
    </message>
    <message>
        <source>More than %1 faces are too many for a STEP file; --gear and --link export a part.</source>
        <translation>%1 yüzeyden fazlası bir STEP dosyası için çok; --gear ve --link bir parçayı dışa aktarır.</translation>
    </message>
    <message>
        <source>Teeth of a worm&apos;s wheel are within %1 modules instead of %2 (--tolerance).</source>
        <translation>Sonsuz vida çarkının dişleri %2 yerine %1 modül içindedir (--tolerance).</translation>
    </message>
    <message>
        <source>Of %1 part(s) the solids could not be united; they overlap.</source>
        <translation>%1 parçanın katıları birleştirilemedi; üst üste biniyorlar.</translation>
    </message>
    <message>
        <source>%1 parts, %2 solids, teeth within %3 modules of their exact form.</source>
        <translation>%1 parça, %2 katı, dişler kesin biçimlerinden en çok %3 modül sapar.</translation>
    </message>
    <message>
        <source>STEP (AP214), for CAD</source>
        <translation>STEP (AP214), CAD için</translation>
    </message>
    <message>
        <source>an assembly for CAD</source>
        <translation>CAD için bir montaj</translation>
    </message>
    <message>
        <source>CAD</source>
        <translation>CAD</translation>
    </message>
    <message>
        <source>Writing the STEP file took longer than %1 s.</source>
        <translation>STEP dosyasını yazmak %1 s&apos;den uzun sürdü.</translation>
    </message>
    <message>
        <source>The program geargraph-step crashed; nothing was written.</source>
        <translation>geargraph-step programı çöktü; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>The program geargraph-step cannot be run.</source>
        <translation>geargraph-step programı çalıştırılamıyor.</translation>
    </message>
    <message>
        <source>The STEP file takes more memory or more bytes than there may be; export a part of the train.</source>
        <translation>STEP dosyası izin verilenden çok bellek ya da bayt gerektiriyor; takımın bir parçasını dışa aktarın.</translation>
    </message>
    <message>
        <source>OpenCASCADE finds no valid solid in &quot;%1&quot;; nothing was written.</source>
        <translation>OpenCASCADE &quot;%1&quot; içinde geçerli katı bulamadı; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>The program geargraph-step failed; nothing was written.</source>
        <translation>geargraph-step programı başarısız oldu; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>&quot;%1&quot; bir sayı değil.</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1: %2 kat</translation>
    </message>
    <message>
        <source>%1, %2: %3 should be %4.</source>
        <translation>%1, %2: %3, %4 olmalı.</translation>
    </message>
    <message>
        <source>%1, %2: the sign of %3 is wrong; it is %4.</source>
        <translation>%1, %2: %3 değerinin işareti yanlış; doğrusu %4.</translation>
    </message>
    <message>
        <source>%1: joint %2 is named twice.</source>
        <translation>%1: mafsal %2 iki kez adlandırılmış.</translation>
    </message>
    <message>
        <source>%1: there is no turning joint &quot;%2&quot;.</source>
        <translation>%1: &quot;%2&quot; adlı döner mafsal yok.</translation>
    </message>
    <message>
        <source>--outputs belongs to the matrices of a controller.</source>
        <translation>--outputs bir denetleyicinin matrislerine aittir.</translation>
    </message>
    <message>
        <source>A matrix has at most %1 rows.</source>
        <translation>Bir matrisin en çok %1 satırı vardır.</translation>
    </message>
    <message>
        <source>A matrix is an array of rows.</source>
        <translation>Bir matris, satırlardan oluşan bir dizidir.</translation>
    </message>
    <message>
        <source>A row is an array of numbers.</source>
        <translation>Bir satır, sayılardan oluşan bir dizidir.</translation>
    </message>
    <message>
        <source>An object or an array of rows is needed.</source>
        <translation>Bir nesne ya da satır dizisi gerekir.</translation>
    </message>
    <message>
        <source>Directions differ, too.</source>
        <translation>Dönme yönleri de farklı.</translation>
    </message>
    <message>
        <source>Matrix from %1: %2</source>
        <translation>%1 matrisi: %2</translation>
    </message>
    <message>
        <source>Motors %1, joints %2</source>
        <translation>Motorlar %1, mafsallar %2</translation>
    </message>
    <message>
        <source>Row %1 has %2 numbers; the matrix is square, with %3 rows.</source>
        <translation>%1. satırda %2 sayı var; matris karedir, %3 satırlıdır.</translation>
    </message>
    <message>
        <source>Say which matrix this is: --matrix motor-to-joint or joint-to-motor.</source>
        <translation>Bunun hangi matris olduğunu belirtin: --matrix motor-to-joint veya joint-to-motor.</translation>
    </message>
    <message>
        <source>The matrices and offsets are of different sizes.</source>
        <translation>Matrisler ve kaymalar farklı boyutta.</translation>
    </message>
    <message>
        <source>The matrices have %1 rows, the train has %2 motors.</source>
        <translation>Matrislerin %1 satırı, düzeneğin %2 motoru var.</translation>
    </message>
    <message>
        <source>The offsets do not cancel: motor offset %1 is %2, the joints&apos; offsets ask for %3.</source>
        <translation>Kaymalar birbirini götürmüyor: motor kayması %1, %2; mafsal kaymaları %3 gerektirir.</translation>
    </message>
    <message>
        <source>The two matrices are not inverse of each other: their product has %1 in row %2, column %3, not %4.</source>
        <translation>İki matris birbirinin tersi değil: çarpımlarında %2. satır, %3. sütunda %4 değil %1 var.</translation>
    </message>
    <message>
        <source>There is neither &quot;motorToJoint&quot; nor &quot;jointToMotor&quot;.</source>
        <translation>Ne &quot;motorToJoint&quot; ne de &quot;jointToMotor&quot; var.</translation>
    </message>
    <message>
        <source>There is no row of numbers.</source>
        <translation>Sayı satırı yok.</translation>
    </message>
    <message>
        <source>all is right but for factors: %1.</source>
        <translation>çarpanlar dışında her şey doğru: %1.</translation>
    </message>
    <message>
        <source>all would be right if these turned the other way: %1.</source>
        <translation>bunlar ters yönde dönseydi her şey doğru olurdu: %1.</translation>
    </message>
    <message>
        <source>all would be right with rows for %1 and columns for %2.</source>
        <translation>satırlar %1, sütunlar %2 için olsaydı her şey doğru olurdu.</translation>
    </message>
    <message>
        <source>joints to motors</source>
        <translation>mafsallardan motorlara</translation>
    </message>
    <message>
        <source>motor %1</source>
        <translation>motor %1</translation>
    </message>
    <message>
        <source>motors to joints</source>
        <translation>motorlardan mafsallara</translation>
    </message>
    <message>
        <source>of a controller: the joints of its rows or columns, by label (as export --to coupling takes them)</source>
        <translation>denetleyici için: satır veya sütunlarının mafsalları, numarasıyla (export --to coupling gibi)</translation>
    </message>
    <message>
        <source>rows and columns are exchanged: this is the transpose.</source>
        <translation>satırlar ve sütunlar yer değiştirmiş: bu, devriğidir.</translation>
    </message>
    <message>
        <source>this is the matrix from %1: the inverse.</source>
        <translation>bu, %1 matrisidir: tersi.</translation>
    </message>
    <message>
        <source>this is the matrix of torques, the transposed inverse.</source>
        <translation>bu, momentlerin matrisidir: devrik ters.</translation>
    </message>
    <message>
        <source>which matrix it is: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p or solution (recognised); of a controller: motor-to-joint, joint-to-motor, or coupling for both as JSON</source>
        <translation>hangi matris olduğu: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p veya solution (tanınır); denetleyici için: motor-to-joint, joint-to-motor, ya da ikisi için JSON olarak coupling</translation>
    </message>
    <message>
        <source>%1 is a whole number.</source>
        <translation>%1 bir tam sayıdır.</translation>
    </message>
    <message>
        <source>crossed helical</source>
        <translation>çapraz helis</translation>
    </message>
    <message>
        <source>Make %1 crossed helical</source>
        <translation>%1 çapraz helis yap</translation>
    </message>
    <message>
        <source>worm</source>
        <translation>sonsuz vida</translation>
    </message>
    <message>
        <source>Make %1 a worm</source>
        <translation>%1 sonsuz vida yap</translation>
    </message>
    <message>
        <source>Teeth that cross at an angle are no herringbone teeth; mesh &quot;%1&quot; says so: leave it out.</source>
        <translation>Bir açıyla kesişen dişler çavuş dişi değildir; &quot;%1&quot; kavraması öyle diyor: bunu çıkarın.</translation>
    </message>
    <message>
        <source>The helix of worm &quot;%1&quot; follows from its starts, the module and the distance of the axes: leave the helix angle out.</source>
        <translation>&quot;%1&quot; sonsuz vidasının helisi ağız sayısından, modülden ve eksen aralığından çıkar: helis açısını yazmayın.</translation>
    </message>
    <message>
        <source>its module %1 does not fit the distance of the axes: their pitch cylinders would not touch. What fits: the module %2.</source>
        <translation>modülü %1 eksen aralığına uymuyor: yuvarlanma silindirleri birbirine değmez. Uygun olan: modül %2.</translation>
    </message>
    <message>
        <source>no helix of this hand makes these teeth with pitch radii of %1 and %2. What fits: the other hand, or no pitch point.</source>
        <translation>bu yöndeki hiçbir helis %1 ve %2 hatve yarıçaplarıyla bu dişleri vermez. Uygun olan: öbür yön ya da hatve noktası yazmamak.</translation>
    </message>
    <message>
        <source>a helix angle of %1 degrees leaves %2 for the head&apos;s gear, and at 90 teeth run round their axis. What fits: none, or a smaller one.</source>
        <translation>%1 derecelik helis açısı baş dişlisine %2 bırakır ve 90 derecede dişler eksenin çevresinde dolanır. Uygun olan: hiç yazmamak ya da daha küçüğü.</translation>
    </message>
    <message>
        <source>its pitch point makes pitch radii of %1 and %2, but teeth and helix angles make %3 and %4. What fits: no pitch point, or no helix angle.</source>
        <translation>hatve noktası %1 ve %2 hatve yarıçaplarını verir, ama dişler ve helis açıları %3 ve %4 verir. Uygun olan: hatve noktası ya da helis açısı yazmamak.</translation>
    </message>
    <message>
        <source>a worm has 1 to %1 starts, fewer than its wheel has teeth; it has %2, and the wheel %3. What fits: other numbers, or crossed helical.</source>
        <translation>bir sonsuz vidanın 1 ile %1 arasında ağzı vardır, çarkının dişlerinden az; bunun %2, çarkın %3. Uygun olan: başka sayılar ya da çapraz helis.</translation>
    </message>
    <message>
        <source>it says worm, but its axes cross at %1 degrees. What fits: crossed helical, or axes that cross at 90 degrees.</source>
        <translation>sonsuz vida diyor, ama eksenleri %1 derecede kesişiyor. Uygun olan: çapraz helis ya da 90 derecede kesişen eksenler.</translation>
    </message>
    <message>
        <source>its module %1 gives the wheel a pitch radius of %2, and the axes are %3 apart: that leaves no core for the worm. What fits: a module of at most %4.</source>
        <translation>modülü %1 çarka %2 hatve yarıçapı verir, eksenlerin aralığı %3: sonsuz vidaya gövde kalmaz. Uygun olan: en çok %4 modül.</translation>
    </message>
    <message>
        <source>its pitch point lies %1 off the common perpendicular of the axes, where their pitch cylinders touch. What fits: a point on it, or none (then it follows from the axes).</source>
        <translation>hatve noktası eksenlerin ortak dikmesinden %1 uzakta; yuvarlanma silindirleri orada değer. Uygun olan: onun üzerinde bir nokta ya da hiç yazmamak (o zaman eksenlerden çıkar).</translation>
    </message>
    <message>
        <source>its pitch point does not lie between the axes. What fits: a point between them, or none (then it follows from the axes).</source>
        <translation>hatve noktası eksenlerin arasında değil. Uygun olan: aralarında bir nokta ya da hiç yazmamak (o zaman eksenlerden çıkar).</translation>
    </message>
    <message>
        <source>its axes are skew, %1 apart: there is no point where the gears could roll. What fits: axes that are parallel or meet, or the kind worm or crossed helical.</source>
        <translation>eksenleri aykırı, aralık %1: dişlilerin yuvarlanabileceği bir nokta yok. Uygun olan: paralel ya da kesişen eksenler ya da sonsuz vida veya çapraz helis türü.</translation>
    </message>
    <message>
        <source>External, internal (one wheel is a ring), bevel (the axes meet), belt or pins (the wheels do not touch), crossed helical or worm (the axes cross without meeting). Without it the geometry tells which of the first three it is.</source>
        <translation>Dış, iç (bir çark iç dişlidir), konik (eksenler kesişir), kayış ya da pimler (çarklar değmez), çapraz helis ya da sonsuz vida (eksenler buluşmadan geçer). Yazılmazsa ilk üçünden hangisi olduğunu geometri söyler.</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Helis açısı</translation>
    </message>
    <message>
        <source>Between a tooth and the axis, at the reference cylinder of the first gear. A right-hand helix turns like a common screw. On parallel axes it changes no ratio; on axes that cross, the hands decide which way the gears turn.</source>
        <translation>Birinci dişlinin bölüm silindirinde diş ile eksen arasında. Sağ helis alışılmış bir vida gibi döner. Paralel eksenlerde hiçbir oranı değiştirmez; çapraz eksenlerde dişlilerin dönüş yönünü helis yönleri belirler.</translation>
    </message>
    <message>
        <source>The sign of mesh %1 follows from the hands of its teeth and the way its axes cross.</source>
        <translation>%1 kavramasının işareti dişlerinin helis yönlerinden ve eksenlerinin nasıl kesiştiğinden çıkar.</translation>
    </message>
    <message>
        <source>Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, let both turn the same way, so that f is %2.</source>
        <translation>%1 kavraması çapraz eksenler arasındadır: dişlerinin helis yönleri, her dişli kendi ekseni boyunca bakıldığında, ikisini aynı yönde döndürür; bu yüzden f, %2 olur.</translation>
    </message>
    <message>
        <source>Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, let them turn against each other, so that f is %2.</source>
        <translation>%1 kavraması çapraz eksenler arasındadır: dişlerinin helis yönleri, her dişli kendi ekseni boyunca bakıldığında, onları ters yönde döndürür; bu yüzden f, %2 olur.</translation>
    </message>
    <message>
        <source>Axes that cross at right angles without meeting. The gear with fewer teeth is the worm: they are its starts.</source>
        <translation>Buluşmadan dik açıyla geçen eksenler. Az dişli olan sonsuz vidadır: dişleri onun ağızlarıdır.</translation>
    </message>
    <message>
        <source>Axes that cross without meeting.</source>
        <translation>Buluşmadan geçen eksenler.</translation>
    </message>
    <message>
        <source>Axes that meet.</source>
        <translation>Kesişen eksenler.</translation>
    </message>
    <message>
        <source>Parallel axes.</source>
        <translation>Paralel eksenler.</translation>
    </message>
    <message>
        <source>herringbone</source>
        <translation>çavuş dişi</translation>
    </message>
    <message>
        <source>The strands cross</source>
        <translation>Kollar çapraz</translation>
    </message>
    <message>
        <source>Hand of the helix</source>
        <translation>Helis yönü</translation>
    </message>
    <message>
        <source>usual hand</source>
        <translation>olağan yön</translation>
    </message>
    <message>
        <source>The hand of the first gear&apos;s teeth. Usual: right-hand, or what fits the axes.</source>
        <translation>Birinci dişlinin diş yönü. Olağan: sağ ya da eksenlere uyan.</translation>
    </message>
    <message>
        <source>The helix changes its hand at the middle of the face, so that no axial force is left.</source>
        <translation>Helis yönü diş genişliğinin ortasında değişir; eksenel kuvvet kalmaz.</translation>
    </message>
    <message>
        <source>The strands cross between the pulleys, which then turn against each other.</source>
        <translation>Kollar kasnakların arasında çaprazlanır; kasnaklar ters yönde döner.</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>düz</translation>
    </message>
    <message>
        <source>Change helix angle</source>
        <translation>Helis açısını değiştir</translation>
    </message>
    <message>
        <source>Change hand</source>
        <translation>Helis yönünü değiştir</translation>
    </message>
    <message>
        <source>Change herringbone</source>
        <translation>Çavuş dişini değiştir</translation>
    </message>
    <message>
        <source>Cross strands</source>
        <translation>Kolları çaprazla</translation>
    </message>
    <message>
        <source>equal on both</source>
        <translation>ikisinde eşit</translation>
    </message>
    <message>
        <source>A cycloidal disc runs on 4 pins or more.</source>
        <translation>Bir sikloid disk 4 ya da daha çok pim üzerinde yürür.</translation>
    </message>
    <message>
        <source>A worm has 1 to %1 starts, fewer than its wheel has teeth.</source>
        <translation>Bir sonsuz vidanın 1 ile %1 arasında ağzı vardır, çarkının dişlerinden az.</translation>
    </message>
    <message>
        <source>Worm stage</source>
        <translation>Sonsuz vida kademesi</translation>
    </message>
    <message>
        <source>worm wheel</source>
        <translation>sonsuz vida çarkı</translation>
    </message>
    <message>
        <source>The pitch of a belt is above 0.</source>
        <translation>Bir kayışın adımı 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>Belt drive</source>
        <translation>Kayış tahriki</translation>
    </message>
    <message>
        <source>driving pulley</source>
        <translation>süren kasnak</translation>
    </message>
    <message>
        <source>driven pulley</source>
        <translation>sürülen kasnak</translation>
    </message>
    <message>
        <source>The circular spline has more teeth than the flexspline, usually two.</source>
        <translation>Dairesel dişlinin dişleri esnek dişliden çoktur, genellikle iki tane.</translation>
    </message>
    <message>
        <source>Strain wave drive</source>
        <translation>Dalga dişli tahriki</translation>
    </message>
    <message>
        <source>wave generator</source>
        <translation>dalga üreteci</translation>
    </message>
    <message>
        <source>flexspline</source>
        <translation>esnek dişli</translation>
    </message>
    <message>
        <source>Cycloidal drive</source>
        <translation>Sikloid tahrik</translation>
    </message>
    <message>
        <source>crank</source>
        <translation>krank</translation>
    </message>
    <message>
        <source>cycloidal disc</source>
        <translation>sikloid disk</translation>
    </message>
    <message>
        <source>RV reducer</source>
        <translation>RV redüktörü</translation>
    </message>
    <message>
        <source>eccentric</source>
        <translation>eksantrik</translation>
    </message>
    <message>
        <source>Starts of the worm</source>
        <translation>Sonsuz vidanın ağızları</translation>
    </message>
    <message>
        <source>Teeth of the wheel</source>
        <translation>Çarkın dişleri</translation>
    </message>
    <message>
        <source>Driving pulley</source>
        <translation>Süren kasnak</translation>
    </message>
    <message>
        <source>Driven pulley</source>
        <translation>Sürülen kasnak</translation>
    </message>
    <message>
        <source>Flexspline</source>
        <translation>Esnek dişli</translation>
    </message>
    <message>
        <source>Circular spline</source>
        <translation>Dairesel dişli</translation>
    </message>
    <message>
        <source>Pins of the ring</source>
        <translation>Halkanın pimleri</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Güneş</translation>
    </message>
    <message>
        <source>Planet</source>
        <translation>Gezegen</translation>
    </message>
    <message>
        <source>One turn of &quot;%1&quot; turns &quot;%2&quot; by %3.</source>
        <translation>&quot;%1&quot; bir tur dönünce &quot;%2&quot; %3 tur döner.</translation>
    </message>
    <message>
        <source>Change its kind: %1</source>
        <translation>Türünü değiştir: %1</translation>
    </message>
    <message>
        <source>Freewheel: %1 cannot overtake %2</source>
        <translation>Tek yönlü kavrama: %1, %2 öğesini geçemez</translation>
    </message>
    <message>
        <source>It locks where the first link would turn faster, about the direction of their axis.</source>
        <translation>İlk uzuv eksenlerinin yönünde daha hızlı dönecek olursa kilitler.</translation>
    </message>
    <message>
        <source>Add freewheel</source>
        <translation>Tek yönlü kavrama ekle</translation>
    </message>
    <message>
        <source>Frequencies, or lost motion</source>
        <translation>Frekanslar ya da boşluk hareketi</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>The frequencies could not be worked out: %1</source>
        <translation>Frekanslar hesaplanamadı: %1</translation>
    </message>
    <message>
        <source>Draw turning joints and gear meshes: what repeats in their motion appears here.</source>
        <translation>Döner mafsallar ve diş kavramaları çizin: hareketlerinde yinelenenler burada görünür.</translation>
    </message>
    <message>
        <source>Frequencies</source>
        <translation>Frekanslar</translation>
    </message>
    <message>
        <source>Shafts, tooth meshes with harmonics and sidebands, passing planets, hunting tooth and assembly phase</source>
        <translation>Miller, harmonikleri ve yan bantlarıyla diş kavramaları, geçen gezegenler, aynı diş çiftinin buluşması ve montaj fazı</translation>
    </message>
    <message>
        <source>The same as lines over a logarithmic axis</source>
        <translation>Aynıları logaritmik eksen üzerinde çizgiler olarak</translation>
    </message>
    <message>
        <source>Lost motion</source>
        <translation>Boşluk hareketi</translation>
    </message>
    <message>
        <source>How far the outputs turn by the play of the teeth while the inputs are held</source>
        <translation>Girişler tutulurken çıkışların diş boşluğuyla ne kadar döndüğü</translation>
    </message>
    <message>
        <source>Export the table to a CSV file</source>
        <translation>Tabloyu bir CSV dosyasına aktar</translation>
    </message>
    <message>
        <source>lost-motion.csv</source>
        <translation>bosluk-hareketi.csv</translation>
    </message>
    <message>
        <source>frequencies.csv</source>
        <translation>frekanslar.csv</translation>
    </message>
    <message>
        <source>The state whose couplings are engaged</source>
        <translation>Kavramaları kenetli olan durum</translation>
    </message>
    <message>
        <source>Speed of the input shaft, rpm</source>
        <translation>Giriş milinin hızı, d/dk</translation>
    </message>
    <message>
        <source>A speed above 0, in turns a minute.</source>
        <translation>0&apos;dan büyük bir hız, dakikadaki tur olarak.</translation>
    </message>
    <message>
        <source>Input shaft, rpm</source>
        <translation>Giriş mili, d/dk</translation>
    </message>
    <message>
        <source>Its speed in turns a minute: frequencies in Hz</source>
        <translation>Dakikadaki tur sayısı: frekanslar Hz olarak</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmonikler</translation>
    </message>
    <message>
        <source>How many multiples of each tooth mesh are listed</source>
        <translation>Her diş kavramasının kaç katının listelendiği</translation>
    </message>
    <message>
        <source>Sidebands</source>
        <translation>Yan bantlar</translation>
    </message>
    <message>
        <source>How many sidebands each multiple has on either side</source>
        <translation>Her katın iki yanında kaç yan bant olduğu</translation>
    </message>
    <message>
        <source>How many equal planets one stands for that is drawn alone</source>
        <translation>Tek çizilmiş bir gezegenin kaç eşit gezegeni temsil ettiği</translation>
    </message>
    <message>
        <source>No output can be told from an input here, so that there is no lost motion: drive a joint.</source>
        <translation>Burada çıkış girişten ayrılamıyor, bu yüzden boşluk hareketi yok: bir mafsalı sürün.</translation>
    </message>
    <message>
        <source>Minutes of arc from stop to stop, inputs held; &quot;worst&quot; adds all plays, the root of squares is what assemblies show.</source>
        <translation>Durdurmadan durdurmaya yay dakikası, girişler tutulu; &quot;en kötü&quot; bütün boşlukları toplar, karelerin kökü montajlarda görülendir.</translation>
    </message>
    <message>
        <source>Cycles for one turn of the %1.</source>
        <translation>Milin bir turundaki çevrim sayısı (%1).</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Titreşim</translation>
    </message>
    <message>
        <source>Frequencies of shafts, tooth meshes and planets, and the motion that the play of the teeth loses.</source>
        <translation>Millerin, diş kavramalarının ve gezegenlerin frekansları ile diş boşluğunun yuttuğu hareket.</translation>
    </message>
    <message>
        <source>A worm has one start or more.</source>
        <translation>Bir sonsuz vidanın bir ya da daha çok ağzı vardır.</translation>
    </message>
    <message>
        <source>%1 starts are too many for a worm; use at most %2, or a pair of helical gears on crossed axes.</source>
        <translation>Bir sonsuz vida için %1 ağız çok fazla; en çok %2 ağız ya da aykırı eksenlerde bir helisel dişli çifti kullanın.</translation>
    </message>
    <message>
        <source>A worm of %1 starts needs a lead angle between 0.3 and 70 degrees, and no profile shift: its wheel has it.</source>
        <translation>%1 ağızlı bir sonsuz vidanın adım açısı 0,3 ile 70 derece arasında olmalı ve profil kaydırması olmamalıdır: kaydırma çarkındadır.</translation>
    </message>
    <message>
        <source>A worm of %1 starts and a pitch diameter of %2 leaves no body below its threads: make it larger than %3.</source>
        <translation>%1 ağızlı ve %2 bölüm dairesi çaplı bir sonsuz vida, dişlerinin altında gövde bırakmıyor: çapı %3 değerinden büyük yapın.</translation>
    </message>
    <message>
        <source>The threads of a worm of %1 starts would be pointed; use a smaller pressure angle or less height.</source>
        <translation>%1 ağızlı bir sonsuz vidanın dişleri sivri olurdu; daha küçük bir basınç açısı ya da daha az yükseklik kullanın.</translation>
    </message>
    <message>
        <source>The bore of %1 leaves no body below the threads of the worm: make it smaller than %2.</source>
        <translation>%1 çaplı delik, sonsuz vidanın dişlerinin altında gövde bırakmıyor: %2 değerinden küçük yapın.</translation>
    </message>
    <message>
        <source>A worm wheel of %1 teeth needs a worm of fewer starts, at most %2; a pair of helical gears on crossed axes may have any numbers of teeth.</source>
        <translation>%1 dişli bir sonsuz vida çarkı, daha az ve en çok %2 ağızlı bir vida ister; aykırı eksenlerdeki bir helisel dişli çiftinin diş sayıları serbesttir.</translation>
    </message>
    <message>
        <source>The worm of a wheel of %1 teeth is too thin for its throat: make its pitch diameter larger than %2.</source>
        <translation>%1 dişli çarkın sonsuz vidası, çarkın boğazı için çok ince: bölüm dairesi çapını %2 değerinden büyük yapın.</translation>
    </message>
    <message>
        <source>A worm wheel of %1 teeth is wider than its worm is thick: make its face width at most %2.</source>
        <translation>%1 dişli sonsuz vida çarkı, vidasının kalınlığından daha geniş: diş genişliğini en çok %2 yapın.</translation>
    </message>
    <message>
        <source>The joint, the link, the brake or the clutch that a torque acts in or on.</source>
        <translation>Torkun içinde ya da üzerinde etkidiği mafsal, uzuv, fren veya kavrama.</translation>
    </message>
    <message>
        <source>The link that the torque acts on, and for a clutch the one that has the reaction.</source>
        <translation>Torkun etkidiği uzuv; kavramada tepkiyi alan da.</translation>
    </message>
    <message>
        <source>part in it</source>
        <translation>görevi</translation>
    </message>
    <message>
        <source>A motor turns a joint at a given speed, or holds it; its torque is given or found. A load is given, a balance is found. A brake holds its link, a clutch joins two.</source>
        <translation>Motor bir mafsalı verilen hızda döndürür ya da tutar; torku verilir ya da bulunur. Yük verilir, denge bulunur. Fren uzvunu tutar, kavrama iki uzvu birleştirir.</translation>
    </message>
    <message>
        <source>How fast it turns about its axis.</source>
        <translation>Ekseni etrafında ne kadar hızlı döndüğü.</translation>
    </message>
    <message>
        <source>Torque times rate: what is fed into the train here; below 0: what is taken. A clutch passes power between its links, a brake passes none.</source>
        <translation>Tork çarpı hız: burada dişli takımına verilen; 0&apos;ın altında: alınan. Kavrama uzuvları arasında güç geçirir, fren geçirmez.</translation>
    </message>
    <message>
        <source>held, found</source>
        <translation>tutulur, bulunan</translation>
    </message>
    <message>
        <source>motor, given</source>
        <translation>motor, verilen</translation>
    </message>
    <message>
        <source>motor, found</source>
        <translation>motor, bulunan</translation>
    </message>
    <message>
        <source>balance, found</source>
        <translation>denge, bulunan</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>birleştirir</translation>
    </message>
    <message>
        <source>An efficiency or a coefficient of friction of a mesh is among its properties; friction becomes an efficiency by the teeth that touch.</source>
        <translation>Bir dişli çiftinin verimi ya da sürtünme katsayısı özelliklerindedir; sürtünme, temas eden dişler üzerinden verime dönüşür.</translation>
    </message>
    <message>
        <source>Coefficient of friction μ = %1 of meshes that state none</source>
        <translation>Kendi değeri olmayan dişli çiftlerinin sürtünme katsayısı μ = %1</translation>
    </message>
    <message>
        <source>mesh %1: η = %2</source>
        <translation>dişli çifti %1: η = %2</translation>
    </message>
    <message>
        <source>mesh %1: μ = %2</source>
        <translation>dişli çifti %1: μ = %2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 tane daha</translation>
    </message>
    <message>
        <source>Torque, rate and power where the train is driven, loaded and held</source>
        <translation>Dişli takımının tahrik edildiği, yüklendiği ve tutulduğu yerlerde tork, hız ve güç</translation>
    </message>
    <message>
        <source>What every mesh passes, seen from its carrier, and what it loses of that</source>
        <translation>Her dişli çiftinin taşıyıcısından bakıldığında geçirdiği ve bundan kaybettiği</translation>
    </message>
    <message>
        <source>Efficiency forward and backward, where the train locks itself, and both over the ratio of two speeds or over the efficiency of the meshes</source>
        <translation>İleri ve geri verim, dişli takımının nerede kendini kilitlediği, ve ikisinin iki hızın oranına ya da dişli çiftlerinin verimine göre grafiği</translation>
    </message>
    <message>
        <source>Torques on the gears of every mesh, and tooth forces</source>
        <translation>Her dişli çiftinin dişlilerindeki torklar ve diş kuvvetleri</translation>
    </message>
    <message>
        <source>Losses</source>
        <translation>Kayıplar</translation>
    </message>
    <message>
        <source>What do I need?</source>
        <translation>Neye ihtiyacım var?</translation>
    </message>
    <message>
        <source>The torques at motors, brakes and clutches, as engaged and in each state</source>
        <translation>Motorlardaki, frenlerdeki ve kavramalardaki torklar, şimdiki haliyle ve her durumda</translation>
    </message>
    <message>
        <source>Where does it go?</source>
        <translation>Nereye gidiyor?</translation>
    </message>
    <message>
        <source>Power, losses, power that circulates, and efficiency forward and backward</source>
        <translation>Güç, kayıplar, dolaşan güç, ileri ve geri verim</translation>
    </message>
    <message>
        <source>What do parts carry?</source>
        <translation>Parçalar ne taşıyor?</translation>
    </message>
    <message>
        <source>The forces on teeth and bearings</source>
        <translation>Dişlerdeki ve yataklardaki kuvvetler</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Neden?</translation>
    </message>
    <message>
        <source>The cutset whose torques balance, and the row of speeds with its column of torques</source>
        <translation>Torkları dengelenen kesitleme ve torkların sütunuyla birlikte hızların satırı</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Durum</translation>
    </message>
    <message>
        <source>No load acts and nothing is held: add a load.</source>
        <translation>Hiçbir yük etkimiyor ve hiçbir şey tutulmuyor: bir yük ekleyin.</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Yükler</translation>
    </message>
    <message>
        <source>Show or hide the loads that act on the train</source>
        <translation>Dişli takımına etkiyen yükleri göster ya da gizle</translation>
    </message>
    <message>
        <source>Unit of the loads</source>
        <translation>Yüklerin birimi</translation>
    </message>
    <message>
        <source>Loads: %1</source>
        <translation>Yükler: %1</translation>
    </message>
    <message>
        <source>Found at %1 ▾</source>
        <translation>%1 üzerinde bulunur ▾</translation>
    </message>
    <message>
        <source>Found at %1 places ▾</source>
        <translation>%1 yerde bulunur ▾</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Soru</translation>
    </message>
    <message>
        <source>What is asked about the torques</source>
        <translation>Torklar hakkında ne sorulduğu</translation>
    </message>
    <message>
        <source>Choose a joint or a mesh in the list above, in a table or in a drawing.</source>
        <translation>Yukarıdaki listeden, bir tablodan ya da bir çizimden bir mafsal veya dişli çifti seçin.</translation>
    </message>
    <message>
        <source>Joint or mesh that is explained</source>
        <translation>Açıklanan mafsal ya da dişli çifti</translation>
    </message>
    <message>
        <source>The joint or the mesh whose torque is explained; it is selected in all views</source>
        <translation>Torku açıklanan mafsal ya da dişli çifti; tüm görünümlerde seçilir</translation>
    </message>
    <message>
        <source>All torques are found twice, by the cutsets of the Matroid method and by those of the T–T graph.</source>
        <translation>Tüm torklar iki kez bulunur: Matroid yönteminin ve T–T grafının kesitlemeleriyle.</translation>
    </message>
    <message>
        <source>The cutset: which torques balance</source>
        <translation>Kesitleme: hangi torklar dengelenir</translation>
    </message>
    <message>
        <source>A joint cuts off links from the ground: all torques that cross add up to 0. Of a mesh: which gear drives.</source>
        <translation>Bir mafsal uzuvları sabit uzuvdan keser: kesiti geçen tüm torkların toplamı 0&apos;dır. Dişli çiftinde: hangi dişlinin tahrik ettiği.</translation>
    </message>
    <message>
        <source>The row of speeds and its column of torques</source>
        <translation>Hızların satırı ve torkların sütunu</translation>
    </message>
    <message>
        <source>A row of P holds the speeds of a mesh, a column the torque in a joint; one entry is in both.</source>
        <translation>P&apos;nin bir satırı bir dişli çiftinin hızlarını, bir sütunu bir mafsaldaki torku verir; bir öge ikisindedir.</translation>
    </message>
    <message>
        <source>choose a joint or a mesh</source>
        <translation>mafsal ya da dişli çifti seçin</translation>
    </message>
    <message>
        <source>mesh %1: %2, %3</source>
        <translation>dişli çifti %1: %2, %3</translation>
    </message>
    <message>
        <source>The link that drives in the state.</source>
        <translation>Bu durumda tahrik eden uzuv.</translation>
    </message>
    <message>
        <source>The link that is driven in the state.</source>
        <translation>Bu durumda tahrik edilen uzuv.</translation>
    </message>
    <message>
        <source>The brakes and clutches that it engages.</source>
        <translation>Devreye aldığı frenler ve kavramalar.</translation>
    </message>
    <message>
        <source>Power taken over power fed, with the drive driving; none while the meshes state no losses</source>
        <translation>Giriş tahrik ederken alınan gücün verilen güce oranı; dişli çiftleri kayıp belirtmedikçe yoktur</translation>
    </message>
    <message>
        <source>beside</source>
        <translation>yanında</translation>
    </message>
    <message>
        <source>State that is compared</source>
        <translation>Karşılaştırılan durum</translation>
    </message>
    <message>
        <source>A state of the gearbox that is compared with the other one</source>
        <translation>Vites kutusunun diğeriyle karşılaştırılan durumu</translation>
    </message>
    <message>
        <source>Two states side by side</source>
        <translation>Yan yana iki durum</translation>
    </message>
    <message>
        <source>speed in joint %1, link %2</source>
        <translation>mafsal %1, uzuv %2 hızı</translation>
    </message>
    <message>
        <source>How fast the head turns against the tail, for 1 at the drive</source>
        <translation>Girişte 1 iken başın kuyruğa göre ne kadar hızlı döndüğü</translation>
    </message>
    <message>
        <source>value</source>
        <translation>değer</translation>
    </message>
    <message>
        <source>The ratio of the one state over that of the other</source>
        <translation>Bir durumun oranı bölü diğerininki</translation>
    </message>
    <message>
        <source>%1, N m</source>
        <translation>%1, N m</translation>
    </message>
    <message>
        <source>The largest ratio over the smallest, of the states that turn forward</source>
        <translation>İleri dönen durumların en büyük oranı bölü en küçüğü</translation>
    </message>
    <message>
        <source>spread %1</source>
        <translation>yayılım %1</translation>
    </message>
    <message>
        <source>Compare states</source>
        <translation>Durumları karşılaştır</translation>
    </message>
    <message>
        <source>Two states side by side: ratios, torques, efficiencies, speeds</source>
        <translation>Yan yana iki durum: oranlar, torklar, verimler, hızlar</translation>
    </message>
    <message>
        <source>Export the table with drive, driven, what is engaged and steps to a CSV file</source>
        <translation>Tabloyu giriş, çıkış, devredeki elemanlar ve basamaklarla CSV dosyasına aktar</translation>
    </message>
    <message>
        <source>A part of the mechanism has no form that prints.</source>
        <translation>Mekanizmanın bir parçasının basılabilir bir biçimi yok.</translation>
    </message>
    <message>
        <source>Printed parts would overlap.</source>
        <translation>Basılan parçalar çakışırdı.</translation>
    </message>
    <message>
        <source>A part does not fit the plate.</source>
        <translation>Bir parça tablaya sığmıyor.</translation>
    </message>
    <message>
        <source>--bed is a width and a depth in mm from %1 to %2, like 220x220.</source>
        <translation>--bed, mm olarak %1 ile %2 arasında bir genişlik ve derinliktir, örneğin 220x220.</translation>
    </message>
    <message>
        <source>the print kit</source>
        <translation>baskı seti</translation>
    </message>
    <message>
        <source>--to kit writes a folder; &quot;-&quot; is none.</source>
        <translation>--to kit bir klasör yazar; &quot;-&quot; klasör değildir.</translation>
    </message>
    <message>
        <source>%1 parts on %2 plate(s).</source>
        <translation>%2 tablada %1 parça.</translation>
    </message>
    <message>
        <source>Print kit: parts for a 3D printer</source>
        <translation>Baskı seti: 3B yazıcı için parçalar</translation>
    </message>
    <message>
        <source>parts for a 3D printer, with their assembly</source>
        <translation>montajıyla birlikte 3B yazıcı için parçalar</translation>
    </message>
    <message>
        <source>Print kits</source>
        <translation>Baskı setleri</translation>
    </message>
    <message>
        <source>Axes of the ground have several directions; a base holds one.</source>
        <translation>Gövdenin eksenleri birkaç yönde; bir taban tek yönü tutar.</translation>
    </message>
    <message>
        <source>The wheel %1 is fixed to the ground, for which the kit has no part.</source>
        <translation>%1 çarkı gövdeye sabit; set bunun için parça içermez.</translation>
    </message>
    <message>
        <source>The ring %1 is too near to the base.</source>
        <translation>%1 iç dişlisi tabana çok yakın.</translation>
    </message>
    <message>
        <source>There is no room for posts beside what turns.</source>
        <translation>Dönenlerin yanında direkler için yer yok.</translation>
    </message>
    <message>
        <source>Parts reach below the lowest bearing of the ground, so that no base fits there; move that joint along its axis.</source>
        <translation>Parçalar gövdenin en alt yatağının altına iniyor, oraya taban sığmaz; o mafsalı ekseni boyunca kaydırın.</translation>
    </message>
    <message>
        <source>A bearing of link %1 is too near to its arm for a printed pedestal.</source>
        <translation>%1 uzvunun bir yatağı, basılı bir yatak ayağı için koluna çok yakın.</translation>
    </message>
    <message>
        <source>An arm of link %1 is neither parallel nor at right angles to its bearing.</source>
        <translation>%1 uzvunun bir kolu yatağına ne paralel ne de dik.</translation>
    </message>
    <message>
        <source>There are no wheels to print.</source>
        <translation>Basılacak çark yok.</translation>
    </message>
    <message>
        <source>Belts are not printed.</source>
        <translation>Kayışlar basılmaz.</translation>
    </message>
    <message>
        <source>The train is too large for a kit.</source>
        <translation>Dişli dizisi bir set için çok büyük.</translation>
    </message>
    <message>
        <source>Links overlap in 3D, so their printed parts would too.</source>
        <translation>Uzuvlar 3B&apos;de çakışıyor, basılan parçaları da çakışırdı.</translation>
    </message>
    <message>
        <source>Several rings on one axis are joined by drums around each other, which the kit cannot divide.</source>
        <translation>Bir eksendeki birkaç iç dişli, iç içe tamburlarla bağlı; set bunları bölemez.</translation>
    </message>
    <message>
        <source>A link turns on a pin across the axis of another, for which the kit has no part.</source>
        <translation>Bir uzuv, başka birinin eksenine dik bir pim üzerinde dönüyor; set bunun için parça içermez.</translation>
    </message>
    <message>
        <source>The wheel %1 has no teeth.</source>
        <translation>%1 çarkının dişi yok.</translation>
    </message>
    <message>
        <source>The bevel %1 has so flat or so steep a cone that it does not print on a face.</source>
        <translation>%1 konik dişlisinin konisi o kadar yassı ya da dik ki bir yüzü üzerinde basılamaz.</translation>
    </message>
    <message>
        <source>Link %1 turns on a pin of link %2, for which the kit has no part.</source>
        <translation>%1 uzvu, %2 uzvunun bir pimi üzerinde dönüyor; set bunun için parça içermez.</translation>
    </message>
    <message>
        <source>The face of wheel %1 is %2 mm instead of %3 mm, so that it clears %4.</source>
        <translation>%1 çarkının diş genişliği %3 mm yerine %2 mm, böylece %4 çarkına değmez.</translation>
    </message>
    <message>
        <source>The ring %1 is joined to its link by more than a disc.</source>
        <translation>%1 iç dişlisi uzvuna bir diskten fazlasıyla bağlı.</translation>
    </message>
    <message>
        <source>The wheel %1 is on no shaft of its link.</source>
        <translation>%1 çarkı uzvunun hiçbir milinde değil.</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>çark</translation>
    </message>
    <message>
        <source>ring gear</source>
        <translation>iç dişli</translation>
    </message>
    <message>
        <source>arm or carrier plate</source>
        <translation>kol ya da taşıyıcı plakası</translation>
    </message>
    <message>
        <source>pedestal with a tenon</source>
        <translation>zıvanalı yatak ayağı</translation>
    </message>
    <message>
        <source>base plate</source>
        <translation>taban plakası</translation>
    </message>
    <message>
        <source>bridge</source>
        <translation>köprü</translation>
    </message>
    <message>
        <source>post</source>
        <translation>direk</translation>
    </message>
    <message>
        <source>spacer</source>
        <translation>ara halkası</translation>
    </message>
    <message>
        <source>clip, pressed on</source>
        <translation>klips, geçme</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ne olduğu</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Boyut, mm</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Kazınan</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>All parts lie on a flat face and need no supports: nothing hangs over by more than %1 degrees from the upright.</source>
        <translation>Bütün parçalar düz bir yüz üzerinde durur, destek gerekmez: hiçbir yüz düşeyden %1 dereceden fazla sarkmaz.</translation>
    </message>
    <message>
        <source>Supports are needed below the teeth of: %1.</source>
        <translation>Şunların dişlerinin altına destek gerekir: %1.</translation>
    </message>
    <message>
        <source>Shafts and screws</source>
        <translation>Miller ve vidalar</translation>
    </message>
    <message>
        <source>Shafts are printed lying on their flat, which keys what is pressed on them. Round rods of the same diameter do as well, with a flat filed to the same depth.</source>
        <translation>Miller, üzerlerine geçenleri kilitleyen düz yüzleri üzerine yatık basılır. Aynı çaplı, aynı derinlikte düzlenmiş yuvarlak çubuklar da olur.</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Çap, mm</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Uzunluk, mm</translation>
    </message>
    <message>
        <source>No screws are needed.</source>
        <translation>Vida gerekmez.</translation>
    </message>
    <message>
        <source>%1 countersunk screws M%2 × %3, which cut their thread in the part</source>
        <translation>Parçada kendi dişini açan %1 havşa başlı vida M%2 × %3</translation>
    </message>
    <message>
        <source>the space with %1 square(s) on %2</source>
        <translation>%2 üzerinde %1 kareli boşluk</translation>
    </message>
    <message>
        <source>the tooth with %1 dot(s) on %2</source>
        <translation>%2 üzerinde %1 noktalı diş</translation>
    </message>
    <message>
        <source>the space after tooth %1 of %2 (no room for a mark)</source>
        <translation>%2 çarkında %1. dişten sonraki boşluk (işaret için yer yok)</translation>
    </message>
    <message>
        <source>tooth %1 of %2 (no room for a mark)</source>
        <translation>%2 çarkında %1. diş (işaret için yer yok)</translation>
    </message>
    <message>
        <source>Teeth that meet</source>
        <translation>Buluşan dişler</translation>
    </message>
    <message>
        <source>Put the wheels together with each marked tooth in the marked space. All marks meet at once in the pose of assembly.3mf.</source>
        <translation>Çarkları, işaretli her diş işaretli boşluğa gelecek biçimde birleştirin. Bütün işaretler assembly.3mf konumunda aynı anda buluşur.</translation>
    </message>
    <message>
        <source>Mesh %1: %2 goes into %3.</source>
        <translation>Diş teması %1: %2, %3 içine girer.</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>yukarıdan</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>aşağıdan</translation>
    </message>
    <message>
        <source>along (%1, %2, %3)</source>
        <translation>(%1, %2, %3) boyunca</translation>
    </message>
    <message>
        <source>Order of assembly</source>
        <translation>Montaj sırası</translation>
    </message>
    <message>
        <source>Each part comes to its place past all those before it, as assembly.3mf shows it. Turn wheels a little where teeth meet.</source>
        <translation>Her parça, öncekilerin yanından geçerek assembly.3mf dosyasındaki yerine gelir. Dişlerin buluştuğu yerde çarkları biraz çevirin.</translation>
    </message>
    <message>
        <source>no straight way was found free; bend or turn it in</source>
        <translation>düz ve boş bir yol bulunamadı; esnetin ya da çevirerek takın</translation>
    </message>
    <message>
        <source>Plate %1</source>
        <translation>Tabla %1</translation>
    </message>
    <message>
        <source>Print kit</source>
        <translation>Baskı seti</translation>
    </message>
    <message>
        <source>Print kit: %1</source>
        <translation>Baskı seti: %1</translation>
    </message>
    <message>
        <source>Play %1 mm on each flank, bores %2 mm wider than their shafts, first layers narrower by %3 mm, scale %4. Lengths are in mm.</source>
        <translation>Her yanakta %1 mm boşluk, delikler millerinden %2 mm geniş, ilk katmanlar %3 mm dar, ölçek %4. Uzunluklar mm&apos;dir.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; measures %2 mm by %3 mm and does not fit the plate; scale the kit down.</source>
        <translation>&quot;%1&quot; %2 mm&apos;ye %3 mm ve tablaya sığmıyor; seti küçültün.</translation>
    </message>
    <message>
        <source>Printed, &quot;%1&quot; and &quot;%2&quot; would overlap.</source>
        <translation>Basılınca &quot;%1&quot; ile &quot;%2&quot; çakışırdı.</translation>
    </message>
    <message>
        <source>The ground has no bearing that a base could hold.</source>
        <translation>Gövdenin, bir tabanın tutabileceği yatağı yok.</translation>
    </message>
    <message>
        <source>Edges of &quot;%1&quot; cross each other at this size; try another scale.</source>
        <translation>&quot;%1&quot; parçasının kenarları bu boyutta kesişiyor; başka bir ölçek deneyin.</translation>
    </message>
    <message>
        <source>the plate of the printer, mm (220x220)</source>
        <translation>yazıcının tablası, mm (220x220)</translation>
    </message>
    <message>
        <source>Plate of the printer</source>
        <translation>Yazıcının tablası</translation>
    </message>
    <message>
        <source>play on either flank of a tooth, mm (0.15)</source>
        <translation>bir dişin her yanağındaki boşluk, mm (0.15)</translation>
    </message>
    <message>
        <source>Play of the teeth</source>
        <translation>Dişlerin boşluğu</translation>
    </message>
    <message>
        <source>by which bores are wider than their shafts, mm (0.2)</source>
        <translation>deliklerin millerinden ne kadar geniş olduğu, mm (0.2)</translation>
    </message>
    <message>
        <source>Clearance of bores</source>
        <translation>Deliklerin boşluğu</translation>
    </message>
    <message>
        <source>by which the lowest layers are narrower, against their spread, mm (0.4)</source>
        <translation>yayılmaya karşı en alt katmanların ne kadar dar olduğu, mm (0.4)</translation>
    </message>
    <message>
        <source>Chamfer of first layers</source>
        <translation>İlk katmanların pahı</translation>
    </message>
    <message>
        <source>by which all lengths are multiplied (1)</source>
        <translation>bütün uzunlukların çarpıldığı sayı (1)</translation>
    </message>
    <message>
        <source>sign of a belt</source>
        <translation>kayış işareti</translation>
    </message>
    <message>
        <source>sign of pins in holes</source>
        <translation>deliklerdeki pimlerin işareti</translation>
    </message>
    <message>
        <source>sign of gears on axes that cross</source>
        <translation>çapraz eksenlerdeki dişlilerin işareti</translation>
    </message>
    <message>
        <source>stated: which teeth were meant?</source>
        <translation>bildirilmiş: hangi dişler kastedildi?</translation>
    </message>
    <message>
        <source>The ratios are those that somebody states, and the drawn teeth are in doubt: looks for teeth near them with all of these ratios, by the fewest wheels</source>
        <translation>Oranlar bildirilen oranlardır ve çizilen diş sayıları kuşkuludur: yakınlarında bu oranların hepsini veren diş sayılarını, en az dişliyi değiştirerek arar</translation>
    </message>
    <message>
        <source>Wheels that may differ from the drawn ones</source>
        <translation>Çizilenlerden farklı olabilecek dişliler</translation>
    </message>
    <message>
        <source>Teeth by which each of them may differ</source>
        <translation>Her birinin farklı olabileceği diş sayısı</translation>
    </message>
    <message>
        <source>Wheels that differ</source>
        <translation>Farklı dişliler</translation>
    </message>
    <message>
        <source>Teeth apart</source>
        <translation>Diş farkı</translation>
    </message>
    <message>
        <source>All %1 choices near the drawn teeth tried: complete</source>
        <translation>Çizilen dişlere yakın %1 seçeneğin tümü denendi: eksiksiz</translation>
    </message>
    <message>
        <source>Ratio %1 of the drawn teeth: %2, as stated</source>
        <translation>Çizilen dişlerin %1. oranı: %2, bildirildiği gibi</translation>
    </message>
    <message>
        <source>Ratio %1 of the drawn teeth: %2, not the stated one</source>
        <translation>Çizilen dişlerin %1. oranı: %2, bildirilen değil</translation>
    </message>
    <message>
        <source>Wheels that differ: %1, choices: %2</source>
        <translation>Farklı dişliler: %1, seçenekler: %2</translation>
    </message>
    <message>
        <source>No teeth near the drawn ones have all stated ratios. More wheels that may differ, or by more teeth, give more.</source>
        <translation>Çizilenlere yakın hiçbir diş bildirilen oranların hepsini vermiyor. Daha çok farklı dişli ya da daha büyük diş farkı daha çok seçenek verir.</translation>
    </message>
    <message>
        <source>The likeliest first: the fewest teeth more or less, then the smallest error</source>
        <translation>En olası önce: en az diş fazlası ya da eksiği, sonra en küçük hata</translation>
    </message>
    <message>
        <source>%1 of %2 chains; equations: %3</source>
        <translation>%2 zincirden %1; denklemler: %3</translation>
    </message>
    <message>
        <source>links: %1, axes: %2, gear pairs: %3</source>
        <translation>uzuvlar: %1, eksenler: %2, dişli çiftleri: %3</translation>
    </message>
    <message>
        <source>links: %1, axes: %2, gear pairs: %3; freedom %4 with one link held</source>
        <translation>uzuvlar: %1, eksenler: %2, dişli çiftleri: %3; bir uzuv tutulunca serbestlik %4</translation>
    </message>
    <message>
        <source>Trees, inputs and frames</source>
        <translation>Ağaçlar, girişler ve sabit uzuvlar</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>Karşılaştır…</translation>
    </message>
    <message>
        <source>Which link is which</source>
        <translation>Hangi uzuv hangisi</translation>
    </message>
    <message>
        <source>Lists all trees of turning joints, valid sets of inputs and frames with which your train can be drawn</source>
        <translation>Dişli takımınızın çizilebileceği tüm döner mafsal ağaçlarını, geçerli giriş kümelerini ve sabit uzuvları listeler</translation>
    </message>
    <message>
        <source>Is the train of another document the same chain, and which link is which?</source>
        <translation>Başka bir belgenin dişli takımı aynı zincir mi, hangi uzuv hangisi?</translation>
    </message>
    <message>
        <source>your train</source>
        <translation>sizin takımınız</translation>
    </message>
    <message>
        <source>the other one</source>
        <translation>öbürü</translation>
    </message>
    <message>
        <source>Valid sets of inputs: %1</source>
        <translation>Geçerli giriş kümeleri: %1</translation>
    </message>
    <message>
        <source>GearGraph documents (*.geargraph)</source>
        <translation>GearGraph belgeleri (*.geargraph)</translation>
    </message>
    <message>
        <source>%1 is a different chain.</source>
        <translation>%1 farklı bir zincirdir.</translation>
    </message>
    <message>
        <source>%1 is the same chain.</source>
        <translation>%1 aynı zincirdir.</translation>
    </message>
    <message>
        <source>%1 has the same equations, on other shafts.</source>
        <translation>%1 aynı denklemlere sahip, başka millerde.</translation>
    </message>
    <message>
        <source>Digraph of your train</source>
        <translation>Dişli takımınızın yönlü grafı</translation>
    </message>
    <message>
        <source>Digraph of the other train, with the colours of your links</source>
        <translation>Öbür takımın yönlü grafı, sizin uzuvlarınızın renkleriyle</translation>
    </message>
    <message>
        <source>Schematic of chain %1</source>
        <translation>%1 zincirinin şeması</translation>
    </message>
    <message>
        <source>Chain %1 in three dimensions</source>
        <translation>%1 zinciri üç boyutta</translation>
    </message>
    <message>
        <source>Laid out by rule, with teeth that are no special ones</source>
        <translation>Kurala göre yerleştirilmiş, özel oranı olmayan dişlerle</translation>
    </message>
    <message>
        <source>The trains are too large to be compared.</source>
        <translation>Dişli takımları karşılaştırılamayacak kadar büyük.</translation>
    </message>
    <message>
        <source>A face gear has more teeth than its pinion.</source>
        <translation>Alın dişlinin pinyonundan daha çok dişi vardır.</translation>
    </message>
    <message>
        <source>Face gear drive</source>
        <translation>Alın dişli tahriki</translation>
    </message>
    <message>
        <source>face gear</source>
        <translation>alın dişli</translation>
    </message>
    <message>
        <source>The gear of an axle has more teeth than its pinion.</source>
        <translation>Aksın aynasının pinyonundan daha çok dişi vardır.</translation>
    </message>
    <message>
        <source>Hypoid axle</source>
        <translation>Hipoid aks</translation>
    </message>
    <message>
        <source>axle gear</source>
        <translation>ayna dişli</translation>
    </message>
    <message>
        <source>Gear %1 (%2 teeth) is drawn as its pitch cone: the teeth of hypoid gears are not made here. Motion, torques and forces are those of the teeth.</source>
        <translation>%1 dişlisi (%2 diş) hatve konisi olarak çizilir: hipoid dişlilerin dişleri burada üretilmez. Hareket, momentler ve kuvvetler dişlerinkidir.</translation>
    </message>
    <message>
        <source>Make %1 a face gear</source>
        <translation>%1 alın dişli yap</translation>
    </message>
    <message>
        <source>hypoid</source>
        <translation>hipoid</translation>
    </message>
    <message>
        <source>Make %1 hypoid</source>
        <translation>%1 hipoid yap</translation>
    </message>
    <message>
        <source>The teeth of a face gear are straight, and those of a hypoid pair follow from its pitch point; mesh &quot;%1&quot; says otherwise: leave it out.</source>
        <translation>Alın dişlinin dişleri düzdür, hipoid çiftinkiler hatve noktasından çıkar; &quot;%1&quot; çifti başka söylüyor: bunu çıkarın.</translation>
    </message>
    <message>
        <source>it has herringbone teeth, but its axes meet. What fits: a helix angle alone, or none.</source>
        <translation>ok dişleri var, ama eksenleri kesişiyor. Uyan: yalnız bir helis açısı ya da hiçbiri.</translation>
    </message>
    <message>
        <source>it has a helix angle, but the pinion of a face gear has straight teeth here. What fits: none.</source>
        <translation>helis açısı var, ama alın dişlinin pinyonu burada düz dişlidir. Uyan: hiçbiri.</translation>
    </message>
    <message>
        <source>it says %1, but its axes meet at %2 degrees. What fits: bevel, or axes that meet at 90 degrees.</source>
        <translation>%1 diyor, ama eksenleri %2 derecede kesişiyor. Uyan: konik, ya da 90 derecede kesişen eksenler.</translation>
    </message>
    <message>
        <source>a face gear has more teeth than its pinion; both have %1. What fits: other numbers, or bevel.</source>
        <translation>alın dişlinin pinyonundan daha çok dişi vardır; ikisinde de %1 var. Uyan: başka sayılar, ya da konik.</translation>
    </message>
    <message>
        <source>The spiral teeth of gear %1 have no exact faces here; STL and GLB have them.</source>
        <translation>%1 dişlisinin spiral dişlerinin burada kesin yüzeyleri yoktur; STL ve GLB&apos;de vardır.</translation>
    </message>
    <message>
        <source>The teeth of face gear %1 have no exact faces here; STL and GLB have them.</source>
        <translation>%1 alın dişlisinin dişlerinin burada kesin yüzeyleri yoktur; STL ve GLB&apos;de vardır.</translation>
    </message>
    <message>
        <source>Spiral teeth and face gears are not printed: gear %1.</source>
        <translation>Spiral dişler ve alın dişliler basılmaz: %1 dişlisi.</translation>
    </message>
    <message>
        <source>The sign of face gear mesh %1 follows from where its pitch point is, seen from both axes.</source>
        <translation>%1 alın dişli çiftinin işareti, hatve noktasının iki eksenden bakınca nerede olduğundan çıkar.</translation>
    </message>
    <message>
        <source>The sign of face gear mesh %1 follows from its pitch point, seen from both axes.</source>
        <translation>%1 alın dişli çiftinin işareti, iki eksenden bakınca hatve noktasından çıkar.</translation>
    </message>
    <message>
        <source>Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, they turn the same way, so that f is %2.</source>
        <translation>%1 çifti bir alın dişli ile pinyonudur: taşıyıcıdan, her biri kendi ekseni boyunca bakınca aynı yönde dönerler, bu yüzden f %2 olur.</translation>
    </message>
    <message>
        <source>Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, they turn against each other, so that f is %2.</source>
        <translation>%1 çifti bir alın dişli ile pinyonudur: taşıyıcıdan, her biri kendi ekseni boyunca bakınca ters yönlerde dönerler, bu yüzden f %2 olur.</translation>
    </message>
    <message>
        <source>The sign of hypoid mesh %1 follows from the half axes beside which its pitch point is, as if the axes met.</source>
        <translation>%1 hipoid çiftinin işareti, eksenler kesişiyormuş gibi, hatve noktasının yanında olduğu yarı eksenlerden çıkar.</translation>
    </message>
    <message>
        <source>The sign of hypoid mesh %1 follows from the half axes beside its pitch point.</source>
        <translation>%1 hipoid çiftinin işareti, hatve noktasının yanındaki yarı eksenlerden çıkar.</translation>
    </message>
    <message>
        <source>Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn the same way, so that f is %2.</source>
        <translation>%1 çifti hipoiddir: taşıyıcıdan, her biri kendi ekseni boyunca bakınca dişlileri aynı yönde döner, bu yüzden f %2 olur.</translation>
    </message>
    <message>
        <source>Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn against each other, so that f is %2.</source>
        <translation>%1 çifti hipoiddir: taşıyıcıdan, her biri kendi ekseni boyunca bakınca dişlileri ters yönlerde döner, bu yüzden f %2 olur.</translation>
    </message>
    <message>
        <source>Axes that meet at right angles. The gear with fewer teeth is the pinion.</source>
        <translation>Dik kesişen eksenler. Daha az dişli olan pinyondur.</translation>
    </message>
    <message>
        <source>Axes that cross at right angles without meeting, or at any angle with a pitch point.</source>
        <translation>Kesişmeden dik geçen eksenler, ya da hatve noktasıyla herhangi bir açıda.</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Pinyon</translation>
    </message>
    <message>
        <source>Face gear</source>
        <translation>Alın dişli</translation>
    </message>
    <message>
        <source>Axle gear</source>
        <translation>Ayna dişli</translation>
    </message>
    <message>
        <source>Spiral angle</source>
        <translation>Spiral açısı</translation>
    </message>
    <message>
        <source>The face of %1 is wider than the teeth of a face gear are, or leaves none: make it at most %2.</source>
        <translation>%1 genişliği alın dişlinin dişlerinden büyük ya da diş bırakmıyor: en çok %2 yapın.</translation>
    </message>
    <message>
        <source>it says hypoid, but its axes cross at %1 degrees. What fits: axes that cross at 90 degrees, or a pitch point of its own.</source>
        <translation>hipoid diyor, ama eksenleri %1 derecede geçiyor. Uyan: 90 derecede geçen eksenler, ya da kendi hatve noktası.</translation>
    </message>
    <message>
        <source>its axes are %1 apart, too far for a gear of %2 teeth and module %3. What fits: a module of at least %4, or axes nearer to each other.</source>
        <translation>eksenleri %1 uzakta, %2 dişli ve %3 modüllü bir dişli için fazla. Uyan: en az %4 modül, ya da birbirine yakın eksenler.</translation>
    </message>
    <message>
        <source>its pitch point leaves one gear no cone: it lies on an axis, or beside the common perpendicular of both. What fits: a point farther out along both axes, or none (then it follows from the axes).</source>
        <translation>hatve noktası bir dişliye koni bırakmıyor: bir eksenin üzerinde ya da iki eksenin ortak dikmesinin yanında. Uyan: iki eksen boyunca daha dışarıda bir nokta, ya da hiçbiri (o zaman eksenlerden çıkar).</translation>
    </message>
    <message>
        <source>its pitch point asks for a spiral angle of %1 degrees, and at 90 teeth run round their axis. What fits: a point whose distances from the axes are nearer to the ratio of the teeth, or none.</source>
        <translation>hatve noktası %1 derecelik spiral açısı istiyor, 90&apos;da dişler ekseni dolanır. Uyan: eksenlere uzaklıkları diş oranına daha yakın bir nokta, ya da hiçbiri.</translation>
    </message>
    <message>
        <source>%1 joints, of which %2 slide</source>
        <translation>%1 mafsal, %2 tanesi kayar</translation>
    </message>
    <message>
        <source>travel of link %1 per radian of link %2: %3 %4</source>
        <translation>uzuv %2 bir radyan dönünce uzuv %1 yolu: %3 %4</translation>
    </message>
    <message>
        <source>slides along axis %1</source>
        <translation>%1 ekseni boyunca kayar</translation>
    </message>
    <message>
        <source>The command %1 does not cover sliding joints, and &quot;%2&quot; has some.</source>
        <translation>%1 komutu kayar mafsalları kapsamaz, &quot;%2&quot; belgesinde ise var.</translation>
    </message>
    <message>
        <source>%1 is like 9=20%2: an input&apos;s label and its travel in the document&apos;s unit.</source>
        <translation>%1, 9=20%2 gibidir: bir girişin numarası ve belgenin birimiyle yolu.</translation>
    </message>
    <message>
        <source>Joint %1 turns: its angle is given by --angle.</source>
        <translation>%1 mafsalı döner: açısı --angle ile verilir.</translation>
    </message>
    <message>
        <source>Joint %1 slides: its travel is given by --travel.</source>
        <translation>%1 mafsalı kayar: yolu --travel ile verilir.</translation>
    </message>
    <message>
        <source>%1 moved by %2 %3</source>
        <translation>%1, %2 %3 kaydı</translation>
    </message>
    <message>
        <source>the travel of an input that slides, in the document&apos;s unit; may be repeated</source>
        <translation>kayan bir girişin yolu, belgenin birimiyle; yinelenebilir</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1 at %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>&quot;turning&quot; or &quot;sliding&quot;</source>
        <translation>&quot;turning&quot; ya da &quot;sliding&quot;</translation>
    </message>
    <message>
        <source>turning, sliding or nothing</source>
        <translation>turning, sliding ya da boş</translation>
    </message>
    <message>
        <source>rack</source>
        <translation>kremayer</translation>
    </message>
    <message>
        <source>Make %1 a rack and pinion</source>
        <translation>%1 eşini kremayer ve pinyon yap</translation>
    </message>
    <message>
        <source>screw</source>
        <translation>vida</translation>
    </message>
    <message>
        <source>Make %1 a screw and nut</source>
        <translation>%1 eşini vida ve somun yap</translation>
    </message>
    <message>
        <source>Screw &quot;%1&quot; needs a lead: its advance in one turn.</source>
        <translation>&quot;%1&quot; vidasına bir hatve gerekir: bir turdaki ilerlemesi.</translation>
    </message>
    <message>
        <source>The lead of screw &quot;%1&quot; is above 0.</source>
        <translation>&quot;%1&quot; vidasının hatvesi 0’dan büyüktür.</translation>
    </message>
    <message>
        <source>Screw &quot;%1&quot; has a lead and a hand, no module and no helix angle: leave them out.</source>
        <translation>&quot;%1&quot; vidasının hatvesi ve yönü vardır, modülü ve helis açısı yoktur: onları çıkarın.</translation>
    </message>
    <message>
        <source>Rack &quot;%1&quot; has a module or a pitch along its motion, one of them.</source>
        <translation>&quot;%1&quot; kremayerinin hareketi boyunca ya modülü ya adımı vardır, ikisinden biri.</translation>
    </message>
    <message>
        <source>The travel of a radian of &quot;%1&quot; is a ratio of two whole numbers up to 100,000: give it with fewer digits.</source>
        <translation>&quot;%1&quot; için bir radyandaki yol, 100.000’e kadar iki tam sayının oranıdır: daha az basamakla yazın.</translation>
    </message>
    <message>
        <source>Only a screw has a lead; mesh &quot;%1&quot; is none.</source>
        <translation>Yalnız vidanın hatvesi vardır; &quot;%1&quot; eşi vida değildir.</translation>
    </message>
    <message>
        <source>This format does not cover sliding joints, racks and screws.</source>
        <translation>Bu biçim kayar mafsalları, kremayerleri ve vidaları kapsamaz.</translation>
    </message>
    <message>
        <source>%1 slides: its screw has no angular part.</source>
        <translation>%1 kayar: vidasının açısal kısmı yoktur.</translation>
    </message>
    <message>
        <source>The %1 component of the direction in which %2 slides: how fast the pitch point of %3 moves for one unit of speed.</source>
        <translation>%2 için kayma yönünün %1 bileşeni: birim hızda %3 yuvarlanma noktasının hızı.</translation>
    </message>
    <message>
        <source>a joint slides</source>
        <translation>bir mafsal kayıyor</translation>
    </message>
    <message>
        <source>Mesh %1 is a rack: its sign follows from the side of the pinion on which it is, and f is %2.</source>
        <translation>%1 eşi bir kremayerdir: işareti pinyonun hangi yanında olduğundan çıkar ve f %2 olur.</translation>
    </message>
    <message>
        <source>The sign of rack %1 follows from the side of the pinion&apos;s axis on which its teeth are.</source>
        <translation>%1 kremayerinin işareti, dişlerinin pinyon ekseninin hangi yanında olduğundan çıkar.</translation>
    </message>
    <message>
        <source>Mesh %1 is a screw: its sign follows from the hand of the thread, and f is %2.</source>
        <translation>%1 eşi bir vidadır: işareti dişin yönünden çıkar ve f %2 olur.</translation>
    </message>
    <message>
        <source>The sign of screw %1 follows from the hand of its thread.</source>
        <translation>%1 vidasının işareti dişinin yönünden çıkar.</translation>
    </message>
    <message>
        <source>A length is tied to an angle by pi (meshes %1) and, round a loop, by a whole number of modules too: their rates would be sums of different powers of pi, for which there are no exact numbers here. State the racks of the loop all by their module or all by their pitch.</source>
        <translation>Bir uzunluk bir açıya pi ile (%1 eşleri), bir çevrim boyunca ise pi olmadan da bağlı: hızlar pi’nin farklı kuvvetlerinin toplamı olurdu ve burada bunların kesin sayıları yoktur. Çevrimdeki kremayerlerin hepsini modülle ya da hepsini adımla verin.</translation>
    </message>
    <message>
        <source>The equation of motion</source>
        <translation>Hareket denklemi</translation>
    </message>
    <message>
        <source>Ratios of states with pi</source>
        <translation>Pi içeren durum oranları</translation>
    </message>
    <message>
        <source>Torques and forces</source>
        <translation>Momentler ve kuvvetler</translation>
    </message>
    <message>
        <source>%1: sliding joints are not covered, and joints %2 slide.</source>
        <translation>%1: kayar mafsallar kapsanmaz, %2 mafsalları ise kayar.</translation>
    </message>
    <message>
        <source>one of its gears slides in their carrier, and gears of the kind %1 turn. What fits: a rack or a screw, or turning joints.</source>
        <translation>dişlilerinden biri taşıyıcıda kayıyor, %1 türünde dişliler ise döner. Uyan: bir kremayer ya da vida, veya döner mafsallar.</translation>
    </message>
    <message>
        <source>it says %1, but both of its sides slide. What fits: one side that turns.</source>
        <translation>%1 diyor, ama iki yanı da kayıyor. Uyan: dönen bir yan.</translation>
    </message>
    <message>
        <source>it says %1, but both of its sides turn. What fits: one side that slides.</source>
        <translation>%1 diyor, ama iki yanı da dönüyor. Uyan: kayan bir yan.</translation>
    </message>
    <message>
        <source>the travel of a turn is not stated. What fits: a module or a pitch of the rack, the lead of the screw.</source>
        <translation>bir turun yolu verilmemiş. Uyan: kremayerin modülü ya da adımı, vidanın hatvesi.</translation>
    </message>
    <message>
        <source>it says %1, but its side that slides does not slide along the axis of the other one. What fits: parallel directions, or a rack.</source>
        <translation>%1 diyor, ama kayan yan öbürünün ekseni boyunca kaymıyor. Uyan: paralel doğrultular ya da bir kremayer.</translation>
    </message>
    <message>
        <source>it says %1, but it slides along the axis of its pinion. What fits: a direction across it, or a screw.</source>
        <translation>%1 diyor, ama pinyonunun ekseni boyunca kayıyor. Uyan: ona çapraz bir doğrultu ya da bir vida.</translation>
    </message>
    <message>
        <source>its teeth run along the slide and cannot push it. What fits: another helix angle or hand.</source>
        <translation>dişleri kayma doğrultusu boyunca uzanıyor ve onu itemez. Uyan: başka bir helis açısı ya da yönü.</translation>
    </message>
    <message>
        <source>its pitch point lies %1 off the place where a pinion of the pitch radius %2 touches the rack. What fits: no pitch point.</source>
        <translation>yuvarlanma noktası, yuvarlanma yarıçapı %2 olan pinyonun kremayere değdiği yerden %1 uzakta. Uyan: yuvarlanma noktası vermemek.</translation>
    </message>
    <message>
        <source>sign of a rack</source>
        <translation>kremayerin işareti</translation>
    </message>
    <message>
        <source>sign of a screw</source>
        <translation>vidanın işareti</translation>
    </message>
    <message>
        <source>Sliding joints, racks and screws have no symbols here.</source>
        <translation>Kayar mafsalların, kremayerlerin ve vidaların burada simgesi yoktur.</translation>
    </message>
    <message>
        <source>One of its links turns, the other one slides across that axis.</source>
        <translation>Uzuvlarından biri döner, öbürü o eksene çapraz kayar.</translation>
    </message>
    <message>
        <source>One of its links turns, the other one slides along that axis.</source>
        <translation>Uzuvlarından biri döner, öbürü o eksen boyunca kayar.</translation>
    </message>
    <message>
        <source>Travel and module of a rack are above 0.</source>
        <translation>Bir kremayerin ilerlemesi ve modülü 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>A pinion of this module has %1 teeth for this travel a turn, and %2 to %3 fit.</source>
        <translation>Bu modülde bir pinyon, tur başına bu ilerleme için %1 dişe sahip olur; %2 ile %3 arası uygundur.</translation>
    </message>
    <message>
        <source>Rack drive</source>
        <translation>Kremayer tahriki</translation>
    </message>
    <message>
        <source>The lead of a screw is above 0.</source>
        <translation>Bir vidanın adımı 0&apos;dan büyüktür.</translation>
    </message>
    <message>
        <source>Screw drive</source>
        <translation>Vidalı tahrik</translation>
    </message>
    <message>
        <source>nut</source>
        <translation>somun</translation>
    </message>
    <message>
        <source>joint %1 at %2 %3</source>
        <translation>mafsal %1: %2 %3</translation>
    </message>
    <message>
        <source>Speed of what slides</source>
        <translation>Kayanların hızı</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%2 boyunca %1</translation>
    </message>
    <message>
        <source>Speed of joint %1: link %2 slides along link %3</source>
        <translation>%1 mafsalının hızı: %2 uzvu %3 uzvu boyunca kayar</translation>
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
        <translation>Mafsal referans konumundan bundan daha geriye kaymaz: 0 ya da daha az. Boş: sınır yok.</translation>
    </message>
    <message>
        <source>The joint slides on no farther than this from the reference pose: 0 or more. Empty: no limit.</source>
        <translation>Mafsal referans konumundan bundan daha ileriye kaymaz: 0 ya da daha çok. Boş: sınır yok.</translation>
    </message>
    <message>
        <source>One of its links slides: a rack or a screw fits, or turning joints.</source>
        <translation>Uzuvlarından biri kayar: bir kremayer ya da vida uyar, ya da döner mafsallar.</translation>
    </message>
    <message>
        <source>Both of its links slide, and one of them has to turn.</source>
        <translation>Her iki uzvu da kayar; birinin dönmesi gerekir.</translation>
    </message>
    <message>
        <source>Both of its links turn, and one of them has to slide. The form of a joint makes it a sliding one.</source>
        <translation>Her iki uzvu da döner; birinin kayması gerekir. Bir mafsalın formu onu kayar mafsal yapar.</translation>
    </message>
    <message>
        <source>It does not slide along the axis of the link that turns: a rack fits.</source>
        <translation>Dönen uzvun ekseni boyunca kaymaz: bir kremayer uyar.</translation>
    </message>
    <message>
        <source>It slides along the axis of the link that turns: a screw fits.</source>
        <translation>Dönen uzvun ekseni boyunca kayar: bir vida uyar.</translation>
    </message>
    <message>
        <source>Sliding joint %1: %2 → %3</source>
        <translation>Kayar mafsal %1: %2 → %3</translation>
    </message>
    <message>
        <source>%1 sliding joints</source>
        <translation>%1 kayar mafsal</translation>
    </message>
    <message>
        <source>Limits, %1</source>
        <translation>Sınırlar, %1</translation>
    </message>
    <message>
        <source>Speed of joint %1: how fast %2 slides along %3. Positive: in the direction of the axis.</source>
        <translation>%1 mafsalının hızı: %2, %3 boyunca ne kadar hızlı kayar. Pozitif: eksenin yönünde.</translation>
    </message>
    <message>
        <source>Travel a turn, about</source>
        <translation>Tur başına ilerleme, yaklaşık</translation>
    </message>
    <message>
        <source>Lead, advance of a turn</source>
        <translation>Adım, tur başına ilerleme</translation>
    </message>
    <message>
        <source>One turn of &quot;%1&quot; moves &quot;%2&quot; by %3.</source>
        <translation>“%1” bir tur döndüğünde “%2” %3 ilerler.</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>döner</translation>
    </message>
    <message>
        <source>The head turns about the axis, against the tail.</source>
        <translation>Baş, kuyruğa göre eksen etrafında döner.</translation>
    </message>
    <message>
        <source>sliding</source>
        <translation>kayar</translation>
    </message>
    <message>
        <source>The head slides along the axis, against the tail.</source>
        <translation>Baş, kuyruğa göre eksen boyunca kayar.</translation>
    </message>
    <message>
        <source>Change kind of joint</source>
        <translation>Mafsal türünü değiştir</translation>
    </message>
    <message>
        <source>In %1/s; a speed with another unit, such as 2 m/s or 30 in/min, is converted.</source>
        <translation>%1/s olarak; 2 m/s ya da 30 in/min gibi başka birimdeki bir hız dönüştürülür.</translation>
    </message>
    <message>
        <source>Type a speed such as 12, 2*3, 2 m/s or 30 in/min.</source>
        <translation>12, 2*3, 2 m/s ya da 30 in/min gibi bir hız yazın.</translation>
    </message>
    <message>
        <source>No joint is driven: %1 as input, at 1 rad/s or %2 each.</source>
        <translation>Hiçbir mafsal tahrik edilmiyor: giriş olarak %1, her biri 1 rad/s ya da %2 ile.</translation>
    </message>
    <message>
        <source>Hand of the thread</source>
        <translation>Dişin yönü</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>The mechanism drawn in four ways; a click on a tab chooses one.</source>
        <translation>Dört biçimde çizilmiş mekanizma; bir sekmeye tıklamak birini seçer.</translation>
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

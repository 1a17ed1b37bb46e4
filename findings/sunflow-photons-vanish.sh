#!/bin/sh
# Sunflow 0.07.2 of Debian 12 loses caustics where photons are dense. It moves a shaded point .001 units off its surface, and
# takes only photons within .05 r^2 of the point's plane, where r is the distance of the farthest photon of the estimate.
# In a scene in metres caustics vanish without a message where the radius is below .14 m, so more
# photons remove them.
# A lamp 1 m above a mirror and 1 m below a ceiling: the mirror adds 1/9 to the ceiling's light.
#
# Seen on Debian 12 with libsunflow-java 0.07.2.svn396+dfsg-18, light over that without the mirror's:
#     10000 photons: 1.10
#     1000000 photons: 1.00
#
# Needs apt-get, dpkg and a JDK. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libsunflow-java=0.07.2.svn396+dfsg-18 libjanino-java=2.7.0-2.1 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > Mean.java <<'JAVA'
import org.sunflow.SunflowAPI;
import org.sunflow.core.Display;
import org.sunflow.image.Color;
public class Mean implements Display {
    float count;
    Color sum = new Color();
    public void imageBegin(int w, int h, int bucket) {}
    public void imagePrepare(int x, int y, int w, int h, int id) {}
    public synchronized void imageUpdate(int x, int y, int w, int h, Color[] data, float[] alpha) {
        for (Color color : data)
            sum.add(color);
        count += data.length;
    }
    public void imageFill(int x, int y, int w, int h, Color c, float alpha) {}
    public void imageEnd() {}
    public static void main(String[] files) {
        SunflowAPI scene = new SunflowAPI();
        Mean mean = new Mean();
        org.sunflow.system.UI.set(new org.sunflow.system.ui.SilentInterface());
        new org.sunflow.core.parser.SCParser().parse(files[0], scene);
        scene.render(SunflowAPI.DEFAULT_OPTIONS, mean);
        float[] rgb = mean.sum.mul(1 / mean.count).getRGB();
        System.out.println(rgb[0] + " " + rgb[1] + " " + rgb[2]);
    }
}
JAVA
draw() { java -cp root/usr/share/java/sunflow.jar:root/usr/share/java/janino.jar Mean.java "$1" 2> log || exit 2; }
cat > room.sc <<'SC'
image { resolution 16 16 aa 0 0 samples 1 filter box }
trace-depths { diff 1 refl 4 refr 4 }
camera { type pinhole eye 0 0 .5 target 0 0 1 up 0 1 0 fov 20 aspect 1 }
shader { name white type diffuse diff { "sRGB linear" 1 1 1 } }
shader { name mirror type mirror refl { "sRGB linear" 1 1 1 } }
object { shader white type generic-mesh name above points 4 -5 5 1 5 5 1 5 -5 1 -5 -5 1 triangles 2 0 1 2 0 2 3 normals none uvs none }
object { shader mirror type generic-mesh name below points 4 -5 -5 -1 5 -5 -1 5 5 -1 -5 5 -1 triangles 2 0 1 2 0 2 3 normals none uvs none }
light { type spherical color { "sRGB linear" 1 1 1 } radiance 10000 center 0 0 0 radius .05 samples 16 }
SC
direct=$(draw room.sc)
for photons in 10000 1000000; do
    { cat room.sc; echo "photons { caustics $photons kd 100 1 }"; } > lit.sc
    draw lit.sc | awk -v direct="${direct%% *}" -v photons=$photons '{ printf "%d photons: %.2f\n", photons, $1 / direct }'
done > found
cat found
[ "$(cut -d: -f2 found | tr -d '\n')" = " 1.10 1.00" ]

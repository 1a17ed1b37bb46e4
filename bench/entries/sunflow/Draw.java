import java.nio.file.Files;
import java.nio.file.Path;
import org.sunflow.PluginRegistry;
import org.sunflow.SunflowAPI;
import org.sunflow.core.Display;
import org.sunflow.core.Instance;
import org.sunflow.core.LightSample;
import org.sunflow.core.LightSource;
import org.sunflow.core.ParameterList;
import org.sunflow.core.Ray;
import org.sunflow.core.ShadingState;
import org.sunflow.core.display.FileDisplay;
import org.sunflow.core.parser.SCParser;
import org.sunflow.image.Color;
import org.sunflow.math.OrthoNormalBasis;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;

/** Draws SCENE.sc with the spots of LIGHTS into PICTURE. A line of LIGHTS: place, direction, W/sr, inner and outer cosine.
 * The package's command reads no scene files, though the library has their parser. */
public class Draw {
    public static void main(String[] files) throws Exception {
        SunflowAPI scene = new SunflowAPI();
        if (!new SCParser().parse(files[0], scene))
            System.exit(1);
        PluginRegistry.lightSourcePlugins.registerPlugin("spot", Spot.class);
        for (String line : Files.readAllLines(Path.of(files[1]))) {
            scene.parameter("numbers", line);
            scene.light(line, "spot");
        }
        scene.render(SunflowAPI.DEFAULT_OPTIONS, new Mean(files[2]));
    }

    static float[] numbers(String line) {
        String[] words = line.split(" ");
        float[] numbers = new float[words.length];
        for (int i = 0; i < words.length; i++)
            numbers[i] = Float.parseFloat(words[i]);
        return numbers;
    }

    /** A spot without size, with glTF's falloff. */
    public static class Spot implements LightSource {
        private Point3 place;
        private OrthoNormalBasis basis;
        private Vector3 axis;
        private Color intensity;
        private float inner, outer;

        public boolean update(ParameterList list, SunflowAPI scene) {
            float[] n = numbers(list.getString("numbers", ""));
            place = new Point3(n[0], n[1], n[2]);
            axis = new Vector3(n[3], n[4], n[5]).normalize();
            basis = OrthoNormalBasis.makeFromW(axis);
            intensity = new Color(n[6], n[7], n[8]);
            inner = n[9];
            outer = n[10];
            return true;
        }

        private float falloff(float cosine) {
            float part = Math.max(0, Math.min(1, (cosine - outer) / Math.max(.001f, inner - outer)));
            return part * part;
        }

        public int getNumSamples() {
            return 1;
        }

        public void getSamples(ShadingState state) {
            Vector3 away = Point3.sub(state.getPoint(), place, new Vector3());
            float square = away.lengthSquared();
            float part = falloff(Vector3.dot(away, axis) / (float) Math.sqrt(square));
            if (part == 0 || Vector3.dot(away, state.getNormal()) >= 0 || Vector3.dot(away, state.getGeoNormal()) >= 0)
                return;
            LightSample sample = new LightSample();
            sample.setShadowRay(new Ray(state.getPoint(), place));
            sample.setRadiance(Color.mul(part / square, intensity), Color.mul(part / square, intensity));
            sample.traceShadow(state);
            state.addSample(sample);
        }

        public void getPhoton(double turn, double height, double x, double y, Point3 from, Vector3 direction, Color power) {
            double cosine = 1 - height * (1 - outer), sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
            from.set(place);
            basis.transform(new Vector3((float) (Math.cos(2 * Math.PI * turn) * sine),
                (float) (Math.sin(2 * Math.PI * turn) * sine), (float) cosine), direction);
            power.set(intensity).mul(falloff((float) cosine) * 2 * (float) Math.PI * (1 - outer));
        }

        public float getPower() {
            return intensity.getLuminance() * 2 * (float) Math.PI * (1 - outer);
        }

        public Instance createInstance() {
            return null;
        }
    }

    /**
     * Means of SIDE x SIDE samples, one each. Sunflow's own filters shift the picture
     * (docs/notes/outsiders.md).
     */
    public static class Mean implements Display {
        private static final int SIDE = 4;
        private final FileDisplay file;
        private Color[] sums;
        private int width, height;

        Mean(String path) {
            file = new FileDisplay(path);
        }

        public void imageBegin(int w, int h, int bucket) {
            width = w / SIDE;
            height = h / SIDE;
            sums = new Color[width * height];
            for (int i = 0; i < sums.length; i++)
                sums[i] = Color.black();
        }

        public void imagePrepare(int x, int y, int w, int h, int id) {
        }

        public synchronized void imageUpdate(int x, int y, int w, int h, Color[] data, float[] alpha) {
            for (int i = 0; i < data.length; i++)
                sums[(y + i / w) / SIDE * width + (x + i % w) / SIDE].madd(1f / (SIDE * SIDE), data[i]);
        }

        public void imageFill(int x, int y, int w, int h, Color color, float alpha) {
        }

        private void writeTile(int x, int y, int w, int h) {
            Color[] colors = new Color[w * h];
            float[] alpha = new float[w * h];
            for (int i = 0; i < colors.length; i++) {
                colors[i] = sums[(y + i / w) * width + x + i % w];
                alpha[i] = 1;
            }
            file.imageUpdate(x, y, w, h, colors, alpha);
        }

        public void imageEnd() {
            final int tile = 32;
            file.imageBegin(width, height, tile);
            for (int y = 0; y < height; y += tile)
                for (int x = 0; x < width; x += tile)
                    writeTile(x, y, Math.min(tile, width - x), Math.min(tile, height - y));
            file.imageEnd();
        }
    }
}

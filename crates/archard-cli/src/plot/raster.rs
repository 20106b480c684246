//! PNG pictures with smooth edges.

use std::io::Cursor;

use anyhow::{Result, anyhow, ensure};
use kuva::backend::raster::RasterBackend;
use kuva::render::render::Scene;

/// Pixels drawn along each axis for one that is kept: the library that draws leaves turned text
/// and steep curves jagged.
const OVERSAMPLING: usize = 3;

/// The scene as a PNG of about that width (px).
pub(super) fn png(scene: &Scene, width: f64) -> Result<Vec<u8>> {
    let scale = OVERSAMPLING as f64 * width / scene.width;
    let drawn = RasterBackend::new().with_scale(scale as f32).render_scene(scene);
    shrink(&drawn.map_err(|message| anyhow!(message))?)
}

/// The picture with the mean of each block of pixels in its place. Releases do not optimize what
/// draws: these sums are written out, without iterators.
fn shrink(drawn: &[u8]) -> Result<Vec<u8>> {
    let mut reader = png::Decoder::new(Cursor::new(drawn)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let info = reader.next_frame(&mut pixels)?;
    ensure!(
        info.bit_depth == png::BitDepth::Eight,
        "the drawn picture has not eight bits a colour"
    );
    let samples = info.color_type.samples();
    let [width, height] = [info.width, info.height].map(|size| size as usize / OVERSAMPLING);
    let mut means = vec![0; width * height * samples];
    for (y, means) in means.chunks_exact_mut(width * samples).enumerate() {
        let [above, middle, below]: [&[u8]; OVERSAMPLING] =
            std::array::from_fn(|row| &pixels[(y * OVERSAMPLING + row) * info.line_size..]);
        for (place, mean) in means.iter_mut().enumerate() {
            let left = place / samples * OVERSAMPLING * samples + place % samples;
            let (centre, right) = (left + samples, left + 2 * samples);
            let sum = above[left] as usize
                + above[centre] as usize
                + above[right] as usize
                + middle[left] as usize
                + middle[centre] as usize
                + middle[right] as usize
                + below[left] as usize
                + below[centre] as usize
                + below[right] as usize;
            *mean = (sum / (OVERSAMPLING * OVERSAMPLING)) as u8;
        }
    }
    encode(&means, [width, height], info.color_type)
}

/// Whether a file is a PNG of this program: the chunks in front of the pixels say so.
pub(super) fn is_signed(bytes: &[u8]) -> bool {
    let signed = b"tEXtSoftware\0archard";
    let pixels = bytes.windows(4).position(|kind| kind == b"IDAT").unwrap_or_default();
    bytes[..pixels].windows(signed.len()).any(|chunk| chunk == signed)
}

/// Pixels of eight bits a colour as a PNG.
fn encode(pixels: &[u8], [width, height]: [usize; 2], colour: png::ColorType) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.add_text_chunk("Software".to_owned(), "archard".to_owned())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

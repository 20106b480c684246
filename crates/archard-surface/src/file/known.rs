//! What a file is by its first bytes, whatever its ending says.

use super::bytes::beginning;
use super::{Format, ReadError, digital_surf, gwyddion, netcdf, npy, sdf, x3p};

/// A kind of file that is known by its first bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    name: &'static str,
    /// `None` of what is not read.
    pub format: Option<Format>,
}

/// Files that are not read but found where surfaces are: their first bytes, of instruments as their readers in surfalize and
/// SurfaceTopography have them.
const OTHERS: &[(&[u8], &str)] = &[
    (b"DSCOMPRESSED", "packed Digital Surf file"),
    (b"GWYO", "file of Gwyddion 1"),
    (b"Gwyddion Simple Field", "Gwyddion Simple Field (.gsf)"),
    (b"VK3_", "Keyence file (.vk3)"),
    (b"VK4_", "Keyence file (.vk4)"),
    (b"VK6", "Keyence file (.vk6)"),
    (b"VK7", "Keyence file (.vk7)"),
    (b"AliconaImaging", "Alicona file (.al3d)"),
    (b"VCA DATA", "Bruker file (.opdx)"),
    (b"\x01\x00Directory", "Wyko file (.opd)"),
    (b"\x88\x1b\x03", "Zygo file (MetroPro .dat)"),
    (b"Binary TrueMap", "TrueMap file (.tmd)"),
    (b"Zeta-Instruments", "Zeta file (.zmg)"),
    (b"\x89HDF\r\n\x1a\n", "HDF5 file (NetCDF 4, too)"),
    (b"\x89PNG\r\n\x1a\n", "picture (PNG)"),
    (b"\xff\xd8\xff", "picture (JPEG)"),
    (b"II*\0", "picture (TIFF)"),
    (b"MM\0*", "picture (TIFF)"),
    (b"%PDF-", "document (PDF)"),
    (b"\xd0\xcf\x11\xe0", "document of MountainsMap or Office"),
    (b"\x1f\x8b", "file packed by gzip"),
];

/// What a file is; `None` of text and of what is not known.
pub(super) fn of(bytes: &[u8]) -> Option<Known> {
    let known = |format: Format| Some(Known { name: format.name(), format: Some(format) });
    match bytes {
        _ if bytes.starts_with(digital_surf::MAGIC) => known(Format::DigitalSurf),
        _ if sdf::begins(bytes) => known(Format::Sdf),
        _ if bytes.starts_with(netcdf::MAGIC) => known(Format::NetCdf),
        _ if bytes.starts_with(npy::MAGIC) => known(Format::Npy),
        _ if bytes.starts_with(gwyddion::MAGIC) => known(Format::Gwyddion),
        _ if bytes.starts_with(x3p::MAGIC) && x3p::has_a_head(bytes) => known(Format::X3p),
        _ if bytes.starts_with(x3p::MAGIC) => Some(Known { name: "zip archive", format: None }),
        _ => {
            let (_, name) = OTHERS.iter().find(|(magic, _)| bytes.starts_with(magic))?;
            Some(Known { name, format: None })
        }
    }
}

/// Refuses a file that is not of a format.
pub(super) fn expect(bytes: &[u8], format: Format) -> Result<(), ReadError> {
    let found = match of(bytes) {
        Some(known) if known.format == Some(format) => return Ok(()),
        None if format == Format::Text => return Ok(()),
        Some(Known { name, format: Some(_) }) => format!("it is {name}, and needs that ending"),
        Some(Known { name, format: None }) => {
            format!(
                "it is a {name}, which is not read: save it as .x3p, .sur, .sdf, .gwy, .nc (NetCDF 3) or text"
            )
        }
        None => format!("it begins with {}", beginning(bytes)),
    };
    Err(ReadError::Format { wanted: format.name(), found })
}

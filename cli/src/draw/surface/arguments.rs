//! What can be asked of surfaces.

use std::path::PathBuf;

use clap::Args;

/// Options of `assur draw` for surfaces.
#[derive(Args, Debug, Default)]
pub struct SurfaceArguments {
    /// The vector of three lengths that is drawn as a surface over the two values that a scene sweeps; may be left out
    /// where there is one only. Several scenes are drawn together: --scene NAME,NAME.
    #[arg(long, value_name = "NAME")]
    pub surface: Option<String>,
    /// Where a surface is seen from: from the front, that is along y, turned to the right about z by the first angle and
    /// raised by the second; 35deg,25deg unless given.
    #[arg(long, value_name = "ANGLE,ANGLE", allow_hyphen_values = true)]
    pub view: Option<String>,
    /// Places of a surface along each swept value, evenly apart, `41` or `u=21,th=41`; 25 unless given.
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pub places: Option<String>,
    /// Scenes whose facets are turned over: those whose normal points inwards.
    #[arg(long, value_name = "SCENES", value_delimiter = ',')]
    pub flip: Vec<String>,
    /// File for the facets of a surface as Wavefront OBJ, in millimetres.
    #[arg(long, value_name = "FILE.obj")]
    pub obj: Option<PathBuf>,
    /// File for the facets of a surface as binary STL, in millimetres.
    #[arg(long, value_name = "FILE.stl")]
    pub stl: Option<PathBuf>,
}

impl SurfaceArguments {
    /// An option that is given.
    pub fn given(&self) -> Option<&'static str> {
        let given = [
            ("--surface", self.surface.is_some()),
            ("--view", self.view.is_some()),
            ("--places", self.places.is_some()),
            ("--flip", !self.flip.is_empty()),
            ("--obj", self.obj.is_some()),
            ("--stl", self.stl.is_some()),
        ];
        given.into_iter().find(|(_, is_given)| *is_given).map(|(option, _)| option)
    }
}

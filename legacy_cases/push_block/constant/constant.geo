<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> 0 -2.01 0 0.01 </Joint>
<Joint type="1"> -0.01 -2 20.01 -2 </Joint>
<Joint type="1"> 20 -2.01 20 0.01 </Joint>
<Joint type="1"> -0.01 0 20.01 0 </Joint>
<Joint type="1"> 3 -0.01 3 1.01 </Joint>
<Joint type="1"> 5 -0.01 5 1.01 </Joint>
<Joint type="1"> 2.99 1 5.01 1 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> 1 -1.5 </Point>
<Point> 19 -1.5 </Point>
<Point> 19 -0.5 </Point>
<Point> 1 -0.5 </Point>
</Fixedpointlist>
<Loadpointlist>
<Point> 4 0.5 </Point>
</Loadpointlist>
<Measuredpointlist>
<Point> 4 0.5 </Point>
</Measuredpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>

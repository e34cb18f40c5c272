#pragma once

#include <string>

/// Tiny tables of our own, in the form of each recogniser.
namespace aucast::sources::tables {

inline constexpr const char* kOpenFace2Header =
    "frame,face_id,timestamp,confidence,success,gaze_0_x,gaze_0_y,gaze_0_z,gaze_1_x,gaze_1_y,"
    "gaze_1_z,gaze_angle_x,gaze_angle_y,pose_Tx,pose_Ty,pose_Tz,pose_Rx,pose_Ry,pose_Rz,AU01_r,"
    "AU12_r,AU45_r,AU01_c,AU12_c,AU28_c,AU45_c\n";

/// A row under kOpenFace2Header, of a face that looks straight into the camera.
inline std::string openface2_row(int frame, const std::string& seconds, const std::string& aus,
                                 const std::string& face = "0",
                                 const std::string& sureness = "0.98,1") {
  return std::to_string(frame) + "," + face + "," + seconds + "," + sureness +
         ",0,0,-1,0,0,-1,0.000,0.000,8.6,25.9,257.9,0.000,0.000,0.000," + aus + "\n";
}

inline constexpr const char* kOpenFace1 =
    "frame, timestamp, confidence, success, gaze_0_x, gaze_0_y, gaze_0_z, gaze_1_x, gaze_1_y, "
    "gaze_1_z, pose_Tx, pose_Ty, pose_Tz, pose_Rx, pose_Ry, pose_Rz, x_0, X_0, AU01_r, AU45_r, "
    "AU01_c, AU28_c\n"
    "1, 0, 0.88, 1, 0.1, 0, -1, 0.1, 0, -1, 15, 43, 592, 0, 0, 0, 276.7, -27.7, 2.5, 0, 0, 1\n"
    "2, 0.04, 0.88, 1, 0, 0, -1, 0, 0, -1, 15, 43, 592, 0, 0, 0, 276.7, -27.7, 0, 5, 0, 0\n";

inline constexpr const char* kFacsvatar =
    "frame,timestamp,confidence,success,gaze_angle_x,gaze_angle_y,pose_Rx,pose_Ry,pose_Rz,AU01_r,"
    "AU45_r\n"
    "0,0.0,0.95,1,0,0,0,0,0,0.25,0\n"
    "1,0.033,0.95,1,0,0,0,0,0,0.86,1\n";

inline constexpr const char* kPyFeat1 =
    "frame,FaceRectX,FaceScore,x_0,Pitch,Roll,Yaw,AU01,AU43,anger,input\n"
    "0,236.1,0.999,355.5,11,-11,17.5,0.25,0,0.1,001.mp4\n"
    "3,236.1,0.999,355.5,-22,0,0,0.5,0.75,0.1,001.mp4\n";

inline constexpr const char* kPyFeat2 =
    "FaceRectX,FaceScore,Pitch,Roll,Yaw,X,Y,Z,AU01,AU12,Neutral,valence,arousal,gaze_pitch,"
    "gaze_yaw,mesh_x_0,jawOpen,input,frame,approx_time,Identity\n"
    "236,0.99,0.19198621771937624,0.19198621771937624,-0.3054326190990077,0,0,0,0.25,0.5,0.9,0,0,"
    "-0.19198621771937624,0.24434609527920614,1,0.3,a.mp4,0,00:00,Person_0\n"
    "236,0.99,0,0,0,0,0,0,0.5,0.25,0.9,0,0,0,0,1,0.3,a.mp4,1,00:00,Person_0\n";

inline constexpr const char* kLibreFace =
    "frame_idx,frame_time_in_ms,pitch,yaw,roll,lm_mp_0_x,au_1,au_7,au_12,au_1_intensity,"
    "au_12_intensity,facial_expression\n"
    "0,0.0,3,1,2,0.5,1,1,0,2.5,0.5,Neutral\n"
    "1,40.0,3,1,2,0.5,0,0,1,0,5,Happiness\n";

inline constexpr const char* kLiveLinkFace =
    "Timecode,BlendShapeCount,EyeBlinkLeft,EyeLookInLeft,EyeBlinkRight,JawRight,JawLeft,JawOpen,"
    "MouthSmileLeft,MouthSmileRight,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw,LeftEyePitch,LeftEyeRoll,"
    "RightEyeYaw,RightEyePitch,RightEyeRoll\n"
    "23:59:59:58.000,61,0.25,0.1,0.75,0.3,0,0.4,0.6,0.5,0,0,0,0.1,0.2,0,0.1,0.2,0\n"
    "00:00:00:00.000,61,0,0,0,0,0.2,1.05,0,0,0,0,0,-0.1,-0.2,0,-0.1,-0.2,0\n";

/// Curves as people publish them, after the picture's number. Some tables lack the number.
inline constexpr const char* kMediaPipe =
    "frame,_neutral,eyeBlinkLeft,eyeBlinkRight,jawLeft,jawOpen,mouthSmileLeft\n"
    "0,0.01,0.25,0.75,0,0.4,0.5\n"
    "1,0.01,0,0,0.5,1,0\n";

/// A detailed log: lines about the recording, then a table with tabs.
inline constexpr const char* kFaceReader =
    "Video analysis detailed log\r\n"
    "Face Model:\tGeneral\r\n"
    "Filename:\tC:\\films\\a, b, and c.mp4\r\n"
    "Frame rate:\t25\r\n"
    "\r\n"
    "Video Time\tNeutral\tHappy\tY - Head Orientation\tAction Unit 01 - Inner Brow Raiser\t"
    "Action Unit 12 - Lip Corner Puller\tAction Unit 12 - Lip Corner Puller - Left\t"
    "Action Unit 43 - Eyes Closed\r\n"
    "00:00:01.000\t0.9\t0\t-3.5\t0.25\t0.5\t0.75\t0\r\n"
    "00:00:01.040\t0.9\t0\t-3.5\tC\tNotActive\t0\tE\r\n"
    "00:00:01.080\tFIND_FAILED\tFIND_FAILED\tFIND_FAILED\tFIND_FAILED\tFIND_FAILED\tFIND_FAILED\t"
    "FIND_FAILED\r\n";

inline constexpr const char* kFacet =
    "#Study : a\r\n#Version : 6.1\r\n\r\n"
    "StudyName\tTimestamp\tFrameNo\tNoOfFaces\tAU1 Evidence\tAU12 Evidence\tYaw Degrees\t"
    "Pitch Degrees\tRoll Degrees\r\n"
    "a\t35\t0\t1\t-2.5\t1\t17.5\t11\t11\r\n"
    "a\t75\t1\t1\t0\t3\t0\t0\t0\r\n"
    "a\t115\t2\t0\t\t\t\t\t\r\n";

inline constexpr const char* kAffdex =
    "#Study : a\n"
    "Timestamp,Brow Furrow,Brow Raise,Inner Brow Raise,Lip Corner Depressor,Smile,Eye Closure,"
    "Smirk,Pitch\n"
    "0,0,25,3,0,75.5,0,90,4\n40,0,0,0,0,4,100,0,4\n";

}  // namespace aucast::sources::tables
